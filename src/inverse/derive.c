/* SPDX-License-Identifier: MIT */
/* Derivatives of exact values by numbers of the scene: by slopes, else from values of changed copies of it. */
#include <luxel/derive.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../api/evaluate_places.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "differences.h"
#include "keys.h"
#include "prober.h"
#include "rates.h"
#include "steps.h"

enum {
    PART = 1 << 12, /* places whose differences are kept at once */
    BLOCK = 1 << 14 /* and whose values are found at once together with slopes */
};

struct luxel_derivatives {
    size_t place_count, number_count;
    struct lx_keys keys;
    struct lx_probed *values; /* of each place */
    luxel_derivative *list;   /* number_count of each place */
};

/* A number of one of a key's values, and the scenes that it was changed for so far: all places share them. */
struct number {
    size_t index; /* among the numbers of all keys */
    struct lx_stepping stepping;
    struct lx_prober sides[LX_MOST_STEPS][2];
};

struct derivation {
    const luxel_scene *scene;
    luxel_settings settings;
    const luxel_place *places; /* NULL: they are the cells of a grid */
    size_t grid;
    luxel_derivatives *made;
    luxel_diagnostics *diagnostics;
    luxel_progress progress;
    void *progress_data;
    size_t done;        /* values that were found, */
    double of_all;      /* of so many, as far as can be told */
    size_t part;        /* places at once */
    size_t *open;       /* which places are not done of a part, */
    luxel_place *asked; /* these places, where they are no cells, */
    struct lx_probed *found[2];
    struct lx_differences *differences;
    size_t *which; /* places of a part */
    struct lx_slopes slopes;
    size_t *doubtful; /* places at which they do not tell */
    size_t doubtful_count;
};

static bool tell_progress(double share, void *data)
{
    const struct derivation *derivation = data;
    const double done = ((double)derivation->done + share * (double)derivation->part) / derivation->of_all;
    return derivation->progress(fmin(done, 1.0), derivation->progress_data);
}

static luxel_status open_prober(const struct derivation *derivation, luxel_scene *scene, struct lx_prober *prober)
{
    if (derivation->places)
        return lx_prober_open(scene, &derivation->settings, derivation->diagnostics, prober);
    return lx_prober_measure(scene, &derivation->settings, derivation->grid, derivation->made->place_count,
                             derivation->diagnostics, prober);
}

/* The values at the open places of a part with the key's number changed to one side of a row. */
static luxel_status probe_side(struct derivation *derivation, struct number *number, unsigned row, unsigned side,
                               const size_t *part, size_t count)
{
    struct lx_prober *prober = &number->sides[row][side];
    if (!prober->scene) {
        const double step = lx_step_of(&number->stepping, row);
        luxel_scene *scene;
        luxel_status status =
            lx_step_scene(&number->stepping, side > 0 ? -step : step, derivation->diagnostics, &scene);
        if (status == LUXEL_OK)
            status = open_prober(derivation, scene, prober);
        if (status != LUXEL_OK)
            return status;
    }
    derivation->done += count;
    for (size_t i = 0; prober->cells && i < count; i++)
        derivation->found[side][i] = prober->cells[part[derivation->open[i]]];
    return prober->cells
               ? LUXEL_OK
               : lx_prober_values(prober, derivation->asked, count, derivation->diagnostics, derivation->found[side]);
}

static void add_step(const struct derivation *derivation, const struct number *number, size_t i, double step,
                     struct lx_differences *differences)
{
    double values[2] = {0.0, 0.0}, errors[2] = {0.0, 0.0};
    for (size_t side = 0; side < (number->stepping.is_one_sided ? 1 : 2); side++) {
        const struct lx_probed *found = &derivation->found[side][i];
        differences->is_missing = differences->is_missing || !found->exists;
        values[side] = found->value;
        errors[side] = found->error;
    }
    if (!differences->is_missing)
        lx_differences_add(differences, step, values, errors);
}

/* Adds the derivative by one of several values that change alike; where there is none by one there is none. */
static void add(luxel_derivative one, luxel_derivative *sum)
{
    const double before = sum->value;
    sum->value += one.value;
    sum->error += one.error + (before != 0 ? fabs(sum->value) * DBL_EPSILON : 0);
    if (one.state > sum->state)
        sum->state = one.state;
}

/* Takes steps at the places of a part, at each until smaller ones tell no more. */
static luxel_status derive_part(struct derivation *derivation, struct number *number, const size_t *part, size_t count)
{
    luxel_derivatives *made = derivation->made;
    const bool is_one_sided = number->stepping.is_one_sided;
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < count; i++) {
        const struct lx_probed *middle = &made->values[part[i]];
        lx_differences_begin(&derivation->differences[i], middle->value, middle->error, is_one_sided);
        derivation->differences[i].is_missing = !middle->exists;
    }
    for (unsigned row = 0; status == LUXEL_OK && row < LX_MOST_STEPS; row++) {
        const double step = lx_step_of(&number->stepping, row);
        size_t open = 0;
        for (size_t i = 0; i < count; i++)
            if (!lx_differences_are_done(&derivation->differences[i])) {
                if (derivation->places)
                    derivation->asked[open] = derivation->places[part[i]];
                derivation->open[open++] = i;
            }
        if (open == 0 || step == 0.0)
            break;
        status = probe_side(derivation, number, row, 0, part, open);
        if (status == LUXEL_OK && !is_one_sided)
            status = probe_side(derivation, number, row, 1, part, open);
        for (size_t i = 0; status == LUXEL_OK && i < open; i++)
            add_step(derivation, number, i, step, &derivation->differences[derivation->open[i]]);
    }
    for (size_t i = 0; i < count; i++)
        add(lx_differences_conclude(&derivation->differences[i]),
            &made->list[part[i] * made->number_count + number->index]);
    return status;
}

/* By differences of values: at the places where they are in doubt, or at all. */
static luxel_status derive_number(struct derivation *derivation, size_t index, size_t target)
{
    const struct lx_key *key = lx_keys_of(&derivation->made->keys, index);
    const bool is_known = derivation->slopes.numbers[index].is_known;
    const size_t places = is_known ? derivation->doubtful_count : derivation->made->place_count;
    struct number number = {.index = index};
    if (places == 0)
        return LUXEL_OK;
    luxel_status status =
        lx_steps_find(derivation->scene, key, target, index - key->offset, derivation->diagnostics, &number.stepping);
    for (size_t first = 0; status == LUXEL_OK && first < places; first += derivation->part) {
        const size_t count = places - first < derivation->part ? places - first : derivation->part;
        for (size_t i = 0; i < count; i++)
            derivation->which[i] = is_known ? derivation->doubtful[first + i] : first + i;
        status = derive_part(derivation, &number, derivation->which, count);
    }
    for (size_t row = 0; row < LX_MOST_STEPS; row++)
        for (size_t side = 0; side < 2; side++)
            lx_prober_close(&number.sides[row][side]);
    return status;
}

/* ---- all of it ---- */

static bool make_room(struct derivation *derivation)
{
    luxel_derivatives *made = derivation->made;
    const size_t part = derivation->part + 1;
    made->values = lx_new_aligned(made->place_count + 1, sizeof *made->values);
    made->list = lx_new_aligned(made->place_count * made->number_count + 1, sizeof *made->list);
    derivation->open = lx_new_array(part, sizeof *derivation->open);
    derivation->asked = lx_new_array(part, sizeof *derivation->asked);
    derivation->found[0] = lx_new_array(part, sizeof *derivation->found[0]);
    derivation->found[1] = lx_new_array(part, sizeof *derivation->found[1]);
    derivation->differences = lx_new_array(part, sizeof *derivation->differences);
    derivation->which = lx_new_array(part, sizeof *derivation->which);
    derivation->doubtful = lx_new_aligned(made->place_count + 1, sizeof *derivation->doubtful);
    return made->values && made->list && derivation->which && derivation->doubtful && derivation->open &&
           derivation->asked && derivation->found[0] && derivation->found[1] && derivation->differences;
}

static void free_room(struct derivation *derivation)
{
    free(derivation->open);
    free(derivation->asked);
    free(derivation->found[0]);
    free(derivation->found[1]);
    free(derivation->differences);
    free(derivation->which);
    free(derivation->doubtful);
    lx_slopes_clear(&derivation->slopes);
}

/* The values in the scene as it is, with slopes as far as these are known. */
static luxel_status find_slopes(struct derivation *derivation, const struct lx_prober *prober, size_t first,
                                size_t count, luxel_value *values, bool *in_doubt)
{
    luxel_derivatives *made = derivation->made;
    const struct lx_slope_list to = {&made->list[first * made->number_count], in_doubt};
    const luxel_status status =
        lx_evaluate_slopes(prober->evaluator, &derivation->slopes, &derivation->places[first], count, values, to);
    for (size_t i = 0; status == LUXEL_OK && i < count; i++) {
        made->values[first + i] = (struct lx_probed){values[i].has_value, values[i].value, values[i].error};
        if (in_doubt[i])
            derivation->doubtful[derivation->doubtful_count++] = first + i;
    }
    return status;
}

static void clear(luxel_derivatives *made, size_t first, size_t count)
{
    memset(&made->list[first * made->number_count], 0, count * made->number_count * sizeof *made->list);
}

static luxel_status find_all_slopes(struct derivation *derivation, const struct lx_prober *prober)
{
    const size_t places = derivation->made->place_count, most = places < BLOCK ? places : BLOCK;
    luxel_value *values = lx_new_array(most, sizeof *values);
    bool *in_doubt = lx_new_array(most, sizeof *in_doubt);
    luxel_status status = values && in_doubt ? LUXEL_OK : lx_out_of_memory(derivation->diagnostics);
    for (size_t first = 0; status == LUXEL_OK && first < places; first += most) {
        const size_t count = places - first < most ? places - first : most;
        clear(derivation->made, first, count);
        status = find_slopes(derivation, prober, first, count, values, in_doubt);
        derivation->done += count;
    }
    free(values);
    free(in_doubt);
    return status;
}

/* The values in the scene as it is: those of probes where there are some. */
static luxel_status find_values(struct derivation *derivation, const luxel_probes *probes, bool any_slopes)
{
    luxel_derivatives *made = derivation->made;
    struct lx_prober prober;
    luxel_status status = LUXEL_OK;
    if (!any_slopes)
        clear(made, 0, made->place_count);
    if (!probes || any_slopes) {
        luxel_scene *copy = luxel_scene_copy(derivation->scene);
        if (!copy)
            return lx_out_of_memory(derivation->diagnostics);
        status = open_prober(derivation, copy, &prober);
        if (status == LUXEL_OK && any_slopes)
            status = find_all_slopes(derivation, &prober);
        else if (status == LUXEL_OK && prober.cells)
            memcpy(made->values, prober.cells, made->place_count * sizeof *made->values);
        else if (status == LUXEL_OK)
            status =
                lx_prober_values(&prober, derivation->places, made->place_count, derivation->diagnostics, made->values);
        lx_prober_close(&prober);
    }
    for (size_t i = 0; probes && i < made->place_count; i++) {
        const luxel_probe *probe = luxel_probes_get(probes, i);
        made->values[i] = (struct lx_probed){probe->has_value, probe->value, probe->error};
    }
    return status;
}

static luxel_status derive_all(struct derivation *derivation, const luxel_probes *probes)
{
    luxel_derivatives *made = derivation->made;
    const bool is_solved = lx_prober_solves(derivation->scene);
    luxel_status status = LUXEL_OK;
    size_t by_differences = 0; /* numbers, of all values that they change */
    bool any_slopes = false;
    if (made->place_count == 0)
        return LUXEL_OK;
    derivation->part = made->place_count < PART || is_solved ? made->place_count : PART;
    if (!make_room(derivation))
        status = lx_out_of_memory(derivation->diagnostics);
    if (status == LUXEL_OK)
        status = lx_rates_find(derivation->scene, &derivation->settings, &made->keys, derivation->diagnostics,
                               derivation->places && !is_solved, &derivation->slopes);
    for (size_t i = 0; status == LUXEL_OK && i < made->number_count; i++) {
        const bool is_known = derivation->slopes.numbers[i].is_known;
        by_differences += is_known ? 0 : lx_keys_of(&made->keys, i)->target_count;
        any_slopes = any_slopes || is_known;
    }
    derivation->of_all = (double)(made->place_count * (1 + 12 * by_differences) + 1);
    if (status == LUXEL_OK)
        status = find_values(derivation, probes, any_slopes);
    for (size_t i = 0; status == LUXEL_OK && i < made->number_count; i++)
        for (size_t t = 0; t < lx_keys_of(&made->keys, i)->target_count && status == LUXEL_OK; t++)
            status = derive_number(derivation, i, t);
    free_room(derivation);
    return status;
}

static bool is_any_seen(const luxel_place *places, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!places[i].is_element)
            return true;
    return false;
}

static luxel_status derive(struct derivation *derivation, const luxel_settings *settings, const luxel_probes *probes,
                           size_t count, const char *const *keys, size_t key_count, luxel_derivatives **derivatives)
{
    if (settings)
        derivation->settings = *settings;
    else
        luxel_settings_init(&derivation->settings);
    derivation->progress = derivation->settings.progress;
    derivation->progress_data = derivation->settings.progress_data;
    if (derivation->progress)
        derivation->settings.progress = tell_progress;
    derivation->settings.progress_data = derivation;
    derivation->settings.within = 0.0; /* what is differed by is the same each time */
    derivation->settings.enough = NULL;
    derivation->settings.skip_reflected_pixels = true;
    if (derivation->settings.tolerance == 0.0)
        derivation->settings.tolerance = 1e-11;
    luxel_derivatives *made = derivation->made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(derivation->diagnostics);
    made->place_count = count;
    luxel_status status = lx_keys_find(derivation->scene, keys, key_count, derivation->diagnostics, &made->keys);
    made->number_count = made->keys.number_count;
    if (status == LUXEL_OK && derivation->places && is_any_seen(derivation->places, count))
        status = luxel_scene_check_view(derivation->scene, derivation->diagnostics);
    if (status == LUXEL_OK)
        status = derive_all(derivation, probes);
    if (status != LUXEL_OK) {
        luxel_derivatives_free(made);
        return status;
    }
    *derivatives = made;
    return LUXEL_OK;
}

luxel_status luxel_derive_places(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                                 const luxel_probes *probes, size_t count, const char *const *keys, size_t key_count,
                                 luxel_diagnostics *diagnostics, luxel_derivatives **derivatives)
{
    if (!scene || (!places && count > 0) || (!keys && key_count > 0) || !derivatives ||
        (probes && luxel_probes_count(probes) != count))
        return LUXEL_ERROR_ARGUMENT;
    *derivatives = NULL;
    if (!luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    struct derivation derivation = {.scene = scene, .places = places, .diagnostics = diagnostics};
    return derive(&derivation, settings, probes, count, keys, key_count, derivatives);
}

luxel_status luxel_derive_grid(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                               const char *const *keys, size_t key_count, luxel_diagnostics *diagnostics,
                               luxel_derivatives **derivatives)
{
    unsigned columns, rows;
    if (!scene || (!keys && key_count > 0) || !derivatives)
        return LUXEL_ERROR_ARGUMENT;
    *derivatives = NULL;
    if (!luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    if (luxel_scene_grid_resolution(scene, i, &columns, &rows) != LUXEL_OK)
        return LUXEL_ERROR_ARGUMENT;
    struct derivation derivation = {.scene = scene, .grid = i, .diagnostics = diagnostics};
    return derive(&derivation, settings, NULL, (size_t)columns * rows, keys, key_count, derivatives);
}

size_t luxel_derivatives_numbers(const luxel_derivatives *derivatives, size_t key)
{
    return derivatives && key < derivatives->keys.count ? derivatives->keys.list[key].count : 0;
}

const char *luxel_derivatives_unit(const luxel_derivatives *derivatives, size_t key)
{
    return derivatives && key < derivatives->keys.count ? derivatives->keys.list[key].unit : NULL;
}

bool luxel_derivatives_value(const luxel_derivatives *derivatives, size_t place, luxel_bounded *value)
{
    if (place >= (derivatives ? derivatives->place_count : 0) || !derivatives->values[place].exists)
        return false;
    *value = (luxel_bounded){derivatives->values[place].value, derivatives->values[place].error};
    return true;
}

const luxel_derivative *luxel_derivatives_get(const luxel_derivatives *derivatives, size_t place, size_t key,
                                              size_t number)
{
    if (place >= (derivatives ? derivatives->place_count : 0) || number >= luxel_derivatives_numbers(derivatives, key))
        return NULL;
    return &derivatives->list[place * derivatives->number_count + derivatives->keys.list[key].offset + number];
}

const char *luxel_derivative_words(luxel_derivative_state state)
{
    static const char *const words[] = {
        [LUXEL_DERIVATIVE_NO_VALUE] = LX_N("there is no value here, or not beside it"),
        [LUXEL_DERIVATIVE_KINK] = LX_N("the value has a kink here"),
        [LUXEL_DERIVATIVE_ROUGH] = LX_N("the value jumps here, or is not known well enough"),
    };
    return (size_t)state < LX_COUNT(words) ? words[state] : NULL;
}

void luxel_derivatives_free(luxel_derivatives *derivatives)
{
    if (!derivatives)
        return;
    lx_keys_clear(&derivatives->keys);
    free(derivatives->values);
    free(derivatives->list);
    free(derivatives);
}

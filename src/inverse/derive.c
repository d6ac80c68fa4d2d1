/* SPDX-License-Identifier: MIT */
/* Derivatives of exact values by numbers of the scene, from values of changed copies of it. */
#include <luxel/derive.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "differences.h"
#include "keys.h"
#include "prober.h"

enum {
    MOST_ROWS = 40,     /* halved steps */
    MOST_HALVINGS = 50, /* of the first step, until both of its ends are legal */
    PART = 1 << 12      /* places whose differences are kept at once */
};

struct luxel_derivatives {
    size_t place_count, number_count;
    struct lx_keys keys;
    struct lx_probed *values; /* of each place */
    luxel_derivative *list;   /* number_count of each place */
};

/* What is so near, by the size of the number, counts as touching (a lamp in a ceiling): steps below tell
 * nothing of the scene. */
static const double LEAST_STEP = 1e-9;

/* A number of one of a key's values, and the scenes that it was changed for so far: all places share them. */
struct number {
    const struct lx_key *key;
    size_t target, index; /* which value, and among the numbers of all keys */
    double at, first;     /* what it is; the first step, so far as it is legal */
    bool is_one_sided;
    struct lx_prober sides[MOST_ROWS][2];
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
};

static bool tell_progress(double share, void *data)
{
    const struct derivation *derivation = data;
    const double done = ((double)derivation->done + share * (double)derivation->part) / derivation->of_all;
    return derivation->progress(fmin(done, 1.0), derivation->progress_data);
}

/* ---- steps ---- */

/* A step as it is taken: what was stepped to has no rounding of its own.  0: it is too small. */
static double step_of(const struct number *number, unsigned row)
{
    const volatile double end = number->at + ldexp(number->first, -(int)row);
    return end - number->at;
}

/* The scene that is changed by so much; LUXEL_ERROR_SCENE: there is none, which is told where diagnostics are given. */
static luxel_status change_scene(const struct derivation *derivation, const struct number *number, double change,
                                 luxel_diagnostics *diagnostics, luxel_scene **changed)
{
    return lx_key_shift(derivation->scene, number->key, number->target, number->index - number->key->offset, change,
                        diagnostics, changed);
}

static bool is_legal(const struct derivation *derivation, const struct number *number, double change)
{
    luxel_scene *scene;
    const bool good = change_scene(derivation, number, change, NULL, &scene) == LUXEL_OK;
    luxel_scene_free(scene);
    return good;
}

/* Finds the first step: that of the key, halved until it is legal, and whether it goes both ways.  LUXEL_ERROR_SCENE,
 * reported: no step is. */
static luxel_status find_steps(const struct derivation *derivation, struct number *number)
{
    const double widest = number->key->targets[number->target].scale * 0.05;
    bool up = false, down = false;
    number->first = widest;
    for (int i = 0; i < MOST_HALVINGS; i++, number->first /= 2.0) {
        up = is_legal(derivation, number, number->first);
        down = is_legal(derivation, number, -number->first);
        if (up && down)
            return LUXEL_OK;
        /* a value at the end of what is legal stays there, however small the step */
        if ((up || down) && number->first < widest * 0x1p-30)
            break;
    }
    number->is_one_sided = true;
    for (number->first = up ? widest : -widest; fabs(number->first) > widest * 0x1p-30; number->first /= 2.0)
        if (is_legal(derivation, number, number->first))
            return LUXEL_OK;
    luxel_scene *scene;
    return change_scene(derivation, number, widest, derivation->diagnostics, &scene);
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
                               size_t first, size_t count)
{
    struct lx_prober *prober = &number->sides[row][side];
    if (!prober->scene) {
        const double step = step_of(number, row);
        luxel_scene *scene;
        luxel_status status =
            change_scene(derivation, number, side > 0 ? -step : step, derivation->diagnostics, &scene);
        if (status == LUXEL_OK)
            status = open_prober(derivation, scene, prober);
        if (status != LUXEL_OK)
            return status;
    }
    derivation->done += count;
    for (size_t i = 0; prober->cells && i < count; i++)
        derivation->found[side][i] = prober->cells[first + derivation->open[i]];
    return prober->cells
               ? LUXEL_OK
               : lx_prober_values(prober, derivation->asked, count, derivation->diagnostics, derivation->found[side]);
}

static void add_step(const struct derivation *derivation, const struct number *number, size_t i, double step,
                     struct lx_differences *differences)
{
    double values[2] = {0.0, 0.0}, errors[2] = {0.0, 0.0};
    for (size_t side = 0; side < (number->is_one_sided ? 1 : 2); side++) {
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

/* Takes steps at places from `first` on, at each until smaller ones tell no more. */
static luxel_status derive_part(struct derivation *derivation, struct number *number, size_t first, size_t count)
{
    luxel_derivatives *made = derivation->made;
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < count; i++) {
        const struct lx_probed *middle = &made->values[first + i];
        lx_differences_begin(&derivation->differences[i], middle->value, middle->error, number->is_one_sided);
        derivation->differences[i].is_missing = !middle->exists;
    }
    for (unsigned row = 0; status == LUXEL_OK && row < MOST_ROWS; row++) {
        const double step = step_of(number, row);
        size_t open = 0;
        for (size_t i = 0; i < count; i++)
            if (!lx_differences_are_done(&derivation->differences[i])) {
                if (derivation->places)
                    derivation->asked[open] = derivation->places[first + i];
                derivation->open[open++] = i;
            }
        if (open == 0 || fabs(step) < LEAST_STEP * number->key->targets[number->target].scale)
            break;
        status = probe_side(derivation, number, row, 0, first, open);
        if (status == LUXEL_OK && !number->is_one_sided)
            status = probe_side(derivation, number, row, 1, first, open);
        for (size_t i = 0; status == LUXEL_OK && i < open; i++)
            add_step(derivation, number, i, step, &derivation->differences[derivation->open[i]]);
    }
    for (size_t i = 0; i < count; i++)
        add(lx_differences_conclude(&derivation->differences[i]),
            &made->list[(first + i) * made->number_count + number->index]);
    return status;
}

static luxel_status derive_number(struct derivation *derivation, size_t index, size_t target)
{
    const size_t places = derivation->made->place_count;
    const struct lx_key *key = lx_keys_of(&derivation->made->keys, index);
    struct number number = {
        .key = key, .target = target, .index = index, .at = key->targets[target].numbers[index - key->offset]};
    luxel_status status = find_steps(derivation, &number);
    for (size_t first = 0; status == LUXEL_OK && first < places; first += derivation->part)
        status = derive_part(derivation, &number, first,
                             places - first < derivation->part ? places - first : derivation->part);
    for (size_t row = 0; row < MOST_ROWS; row++)
        for (size_t side = 0; side < 2; side++)
            lx_prober_close(&number.sides[row][side]);
    return status;
}

/* ---- all of it ---- */

static bool make_room(struct derivation *derivation)
{
    luxel_derivatives *made = derivation->made;
    const size_t part = derivation->part + 1;
    made->values = lx_new_array(made->place_count + 1, sizeof *made->values);
    made->list = lx_new_array(made->place_count * made->number_count + 1, sizeof *made->list);
    derivation->open = lx_new_array(part, sizeof *derivation->open);
    derivation->asked = lx_new_array(part, sizeof *derivation->asked);
    derivation->found[0] = lx_new_array(part, sizeof *derivation->found[0]);
    derivation->found[1] = lx_new_array(part, sizeof *derivation->found[1]);
    derivation->differences = lx_new_array(part, sizeof *derivation->differences);
    return made->values && made->list && derivation->open && derivation->asked && derivation->found[0] &&
           derivation->found[1] && derivation->differences;
}

static void free_room(struct derivation *derivation)
{
    free(derivation->open);
    free(derivation->asked);
    free(derivation->found[0]);
    free(derivation->found[1]);
    free(derivation->differences);
}

/* The values in the scene as it is: those of probes where there are some. */
static luxel_status find_values(struct derivation *derivation, const luxel_probes *probes)
{
    luxel_derivatives *made = derivation->made;
    struct lx_prober prober;
    for (size_t i = 0; probes && i < made->place_count; i++) {
        const luxel_probe *probe = luxel_probes_get(probes, i);
        made->values[i] = (struct lx_probed){probe->has_value, probe->value, probe->error};
    }
    if (probes)
        return LUXEL_OK;
    luxel_scene *copy = luxel_scene_copy(derivation->scene);
    if (!copy)
        return lx_out_of_memory(derivation->diagnostics);
    luxel_status status = open_prober(derivation, copy, &prober);
    if (status == LUXEL_OK && prober.cells)
        memcpy(made->values, prober.cells, made->place_count * sizeof *made->values);
    for (size_t first = 0; status == LUXEL_OK && !prober.cells && first < made->place_count;
         first += derivation->part) {
        const size_t left = made->place_count - first, count = left < derivation->part ? left : derivation->part;
        status =
            lx_prober_values(&prober, &derivation->places[first], count, derivation->diagnostics, &made->values[first]);
        derivation->done += count;
    }
    lx_prober_close(&prober);
    return status;
}

static luxel_status derive_all(struct derivation *derivation, const luxel_probes *probes)
{
    luxel_derivatives *made = derivation->made;
    luxel_status status = LUXEL_OK;
    size_t numbers = 0; /* to be changed */
    derivation->part = made->place_count < PART || lx_prober_solves(derivation->scene) ? made->place_count : PART;
    for (size_t i = 0; i < made->keys.count; i++)
        numbers += made->keys.list[i].count * made->keys.list[i].target_count;
    derivation->of_all = (double)(made->place_count * (1 + 12 * numbers) + 1);
    if (!make_room(derivation))
        status = lx_out_of_memory(derivation->diagnostics);
    if (status == LUXEL_OK && made->place_count > 0)
        status = find_values(derivation, probes);
    for (size_t i = 0; status == LUXEL_OK && made->place_count > 0 && i < made->number_count; i++)
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

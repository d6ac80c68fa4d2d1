/* SPDX-License-Identifier: MIT */
/* Layouts of luminaires: which light, by rising numbers of them, and what is computed of those that come near. */
#include <luxel/arrange.h>

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../api/refuse.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../light/array.h"
#include "../parameter/decode.h"
#include "../scene/lit.h"
#include "tuning.h"

enum {
    MOST_IN_A_LINE = 1000,
    MOST_TOLD = 6,      /* layouts that are told as missed, */
    MOST_TOLD_SLOW = 3, /* where each takes a solution of reflected light */
    MOST_COMPUTED = 60, /* scenes */
    MOST_ALIKE = 3,     /* found ones of as many luminaires */
    TRIES = 4           /* of one array: what is computed corrects the sums */
};
/* Sums come so near to what is computed; where light is reflected, by what another array has told. */
static const double NEAR = 0.995, NEAR_REFLECTED = 0.96;
/* Rows and columns as far apart as each other, up to this factor, where they are even. */
static const double MOST_UNEVEN = 2;

void luxel_arrangement_free(luxel_arrangement *arrangement)
{
    struct lx_own_arrangement *own = (struct lx_own_arrangement *)(void *)arrangement;
    if (!own)
        return;
    for (size_t i = 0; i < arrangement->computed; i++)
        lx_computed_clear(&own->computed[i]);
    for (size_t i = 0; own->names && i < arrangement->number_count; i++)
        free(own->names[i]);
    free(own->names);
    free(own->units);
    free(own->computed);
    free(own->found);
    free(own->missed);
    luxel_scene_free(own->goals);
    free(own);
}

const luxel_scene *luxel_arrangement_scene(const luxel_arrangement *arrangement, const luxel_layout *layout)
{
    const struct lx_own_arrangement *own = (const struct lx_own_arrangement *)(const void *)arrangement;
    for (size_t i = 0; own && layout && i < arrangement->computed; i++)
        if (own->computed[i].layout.limits == layout->limits)
            return own->computed[i].scene;
    return NULL;
}

/* How far the work is nobody knows: each part of it takes a share of what is left. */
static bool tell_progress(double share, void *data)
{
    const struct lx_arranging *arranging = data;
    return arranging->progress(arranging->done + share * (1 - arranging->done) / 8, arranging->progress_data);
}

/* ---- which light ---- */

static bool can_be_arranged(const struct lx_item *light)
{
    return lx_find_parameter(light->variant->table, "array") != NULL;
}

static bool is_named(const struct lx_item *light, size_t i, const char *name)
{
    const char *own = ((const struct lx_light_common *)light->common)->name;
    char number[32];
    snprintf(number, sizeof number, "%zu", i);
    return (own && strcmp(own, name) == 0) || strcmp(number, name) == 0;
}

static luxel_status find_named(const struct lx_list *lights, const bool *on, const char *name,
                               luxel_diagnostics *diagnostics, size_t *light)
{
    for (size_t i = 0; i < lights->count; i++) {
        if (!is_named(&lights->items[i], i, name))
            continue;
        *light = i;
        if (on[i] && can_be_arranged(&lights->items[i]))
            return LUXEL_OK;
    }
    return lx_refuse(diagnostics, LX_MSG_ARRANGE_NOT_LIGHT, LX_ARGS(name));
}

static luxel_status find_light(const struct lx_scene_parameters *parameters, const bool *on, const char *name,
                               luxel_diagnostics *diagnostics, size_t *light)
{
    const struct lx_list *lights = &parameters->lights;
    size_t count[2] = {0}, first[2] = {0}; /* of those that could have an array, and of those that have one */
    if (name)
        return find_named(lights, on, name, diagnostics, light);
    for (size_t i = 0; i < lights->count; i++) {
        if (!on[i] || !can_be_arranged(&lights->items[i]))
            continue;
        for (int has = 0; has <= (lx_array_of(&lights->items[i]) != NULL); has++)
            if (count[has]++ == 0)
                first[has] = i;
    }
    if (count[0] == 0)
        return lx_refuse(diagnostics, LX_MSG_ARRANGE_NO_LIGHT, NULL);
    if (count[1] > 1 || (count[1] == 0 && count[0] > 1))
        return lx_refuse(diagnostics, LX_MSG_ARRANGE_WHICH_LIGHT, NULL);
    *light = count[1] > 0 ? first[1] : first[0];
    return LUXEL_OK;
}

/* ---- what a layout gives ---- */

/* Dims a light: of the keys that tell its strength that which it has. */
static luxel_status dim(luxel_scene *scene, size_t light, double dimming, luxel_diagnostics *diagnostics)
{
    static const char *const keys[] = {"intensity", "radiance", "power", "factor"};
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < LX_COUNT(keys) && dimming < 1 && status == LUXEL_OK; i++) {
        char key[64], assignment[128], digits[LX_NUMBER_SIZE], *text = NULL;
        double strength;
        snprintf(key, sizeof key, "lights[%zu].%s", light, keys[i]);
        if (luxel_scene_get(scene, key, NULL, NULL, &text) != LUXEL_OK)
            continue;
        const bool has = text && lx_read_number(text, strlen(text), &strength);
        luxel_text_free(text);
        if (!has)
            continue;
        snprintf(assignment, sizeof assignment, "%s=%s", key, lx_write_number(strength * dimming, digits));
        return luxel_scene_set(scene, assignment, diagnostics);
    }
    return status;
}

/* Computes the scene of a layout with that error of reflected light, and corrects the sums by it. */
static luxel_status compute(struct lx_arranging *arranging, const struct lx_lamp_layout *layout, double reflected_error,
                            struct lx_computed *computed)
{
    struct lx_superposition *superposition = &arranging->superposition;
    luxel_layout *told = &computed->layout;
    computed->scene = luxel_scene_copy(arranging->made->goals);
    if (!computed->scene)
        return lx_out_of_memory(arranging->diagnostics);
    memcpy(told->n, layout->array.n, sizeof told->n);
    memcpy(told->spacing_mm, layout->array.spacing_mm, sizeof told->spacing_mm);
    told->dimming = layout->dimming;
    luxel_status status = dim(computed->scene, superposition->light, layout->dimming, arranging->diagnostics);
    if (status == LUXEL_OK)
        status = lx_array_set(computed->scene, superposition->light, &layout->array, arranging->diagnostics);
    if (status == LUXEL_OK)
        status = lx_judge_layout(arranging, reflected_error, computed);
    if (status == LUXEL_OK)
        lx_superposition_learn(superposition, &layout->array, layout->dimming, arranging->values);
    return status;
}

/* Computes a layout and keeps it. */
static luxel_status keep(struct lx_arranging *arranging, const struct lx_lamp_layout *layout, struct lx_computed **kept)
{
    struct lx_own_arrangement *made = arranging->made;
    const size_t count = made->arrangement.computed;
    if (lx_reserve(&made->computed, &arranging->capacity, count + 1, sizeof *made->computed) != 0)
        return lx_out_of_memory(arranging->diagnostics);
    *kept = &made->computed[count];
    **kept = (struct lx_computed){.scene = NULL};
    made->arrangement.computed++;
    const luxel_status status = compute(arranging, layout, LX_COARSE, *kept);
    arranging->found += status == LUXEL_OK && (*kept)->layout.reaches;
    return status;
}

/* Forgets what was computed last. */
static void drop_last(struct lx_arranging *arranging)
{
    lx_computed_clear(&arranging->made->computed[--arranging->made->arrangement.computed]);
}

static bool is_same(const struct lx_lamp_layout *a, const struct lx_lamp_layout *b)
{
    return a->array.spacing_mm[0] == b->array.spacing_mm[0] && a->array.spacing_mm[1] == b->array.spacing_mm[1] &&
           a->dimming == b->dimming;
}

static struct lx_lamp_layout find_again(struct lx_arranging *arranging, const struct lx_lamp_layout *layout)
{
    return lx_layout_find(&arranging->superposition, arranging->wanted, layout->array.n[0], layout->array.n[1],
                          arranging->room);
}

/* What the bounds of a least value leave undecided takes more light. */
static void add_light(const luxel_layout *layout, struct lx_lamp_layout *other)
{
    for (size_t k = 0; k < layout->limit_count; k++) {
        const luxel_limit *limit = &layout->limits[k].limit;
        if (limit->verdict == LUXEL_UNDECIDED && !limit->is_most && limit->value.value > 0)
            other->dimming = fmin(1, other->dimming * (1 + 2 * limit->value.error / limit->value.value));
    }
}

/* Where observers alone are in the way: spacings half of which are left to the walls spread the luminaires farther. */
static luxel_status try_even(struct lx_arranging *arranging, const struct lx_lamp_layout *layout)
{
    luxel_arranging even = *arranging->wanted;
    even.is_even = true;
    const struct lx_lamp_layout other =
        lx_layout_find(&arranging->superposition, &even, layout->array.n[0], layout->array.n[1], arranging->room);
    struct lx_computed *computed;
    if (other.reserve < 1 || is_same(&other, layout))
        return LUXEL_OK;
    const luxel_status status = keep(arranging, &other, &computed);
    if (status == LUXEL_OK && !computed->layout.reaches)
        drop_last(arranging);
    return status;
}

/*
 * Computes an array with the spacings that are best as far as is known, and anew with what was learned by that, as long
 * as its grids may then keep their limits.  Observers do not decide on spacings.
 */
static luxel_status consider(struct lx_arranging *arranging, struct lx_lamp_layout *layout)
{
    for (int i = 0; i < TRIES; i++) {
        struct lx_computed *computed;
        const luxel_status status = keep(arranging, layout, &computed);
        if (status == LUXEL_OK && computed->grids_pass && !computed->layout.reaches)
            return try_even(arranging, layout);
        if (status != LUXEL_OK || computed->grids_pass || i == TRIES - 1)
            return status;
        struct lx_lamp_layout other = find_again(arranging, layout);
        if (arranging->wanted->dims)
            add_light(&computed->layout, &other);
        if (other.reserve < 1 || is_same(&other, layout))
            break;
        *layout = other;
        drop_last(arranging);
    }
    return LUXEL_OK;
}

/* ---- the search ---- */

static unsigned number_of(const unsigned n[2])
{
    return n[0] * n[1];
}

static bool is_even(const struct lx_superposition *superposition, unsigned columns, unsigned rows)
{
    const double along_x = superposition->wall_mm[0] / columns, along_y = superposition->wall_mm[1] / rows;
    return fmax(along_x, along_y) <= MOST_UNEVEN * fmin(along_x, along_y) * (1 + 1e-9);
}

/* Fewer before more, of equal numbers more columns first: so that sorting leaves nothing open. */
static int compare_numbers(const unsigned first[2], const unsigned second[2])
{
    const unsigned counts[2] = {number_of(first), number_of(second)};
    return counts[0] != counts[1] ? (counts[0] < counts[1] ? -1 : 1) : (first[0] < second[0]) - (first[0] > second[0]);
}

static int compare_scores(const void *a, const void *b)
{
    const struct lx_lamp_layout *first = a, *second = b;
    const int order = (first->score < second->score) - (first->score > second->score);
    return order != 0 ? order : compare_numbers(first->array.n, second->array.n);
}

/* Tries all arrays of so many luminaires; those that come near are computed, best first. */
static luxel_status try_count(struct lx_arranging *arranging, unsigned count)
{
    luxel_arrangement *arrangement = &arranging->made->arrangement;
    const size_t first = arrangement->tried;
    for (unsigned columns = 1; columns <= count; columns++) {
        const unsigned rows = count / columns;
        if (count % columns > 0 || columns > MOST_IN_A_LINE || rows > MOST_IN_A_LINE ||
            !lx_layout_fits(&arranging->superposition, columns, rows) ||
            (arranging->wanted->is_even && !is_even(&arranging->superposition, columns, rows)))
            continue;
        if (lx_reserve(&arranging->tried, &arranging->tried_capacity, arrangement->tried + 1,
                       sizeof *arranging->tried) != 0)
            return lx_out_of_memory(arranging->diagnostics);
        arranging->tried[arrangement->tried++] =
            lx_layout_find(&arranging->superposition, arranging->wanted, columns, rows, arranging->room);
    }
    qsort(arranging->tried + first, arrangement->tried - first, sizeof *arranging->tried, compare_scores);
    luxel_status status = LUXEL_OK;
    const size_t before = arranging->found;
    for (size_t i = first; i < arrangement->tried && status == LUXEL_OK; i++) {
        /* once one is found only those count that should reach the goals, and of more luminaires the best alone */
        if (arranging->tried[i].reserve < (arranging->found > before ? 1 : arranging->near) ||
            arrangement->computed >= MOST_COMPUTED || arranging->found >= before + MOST_ALIKE ||
            (before > 0 && i > first))
            break;
        status = consider(arranging, &arranging->tried[i]);
    }
    return status;
}

/* What reflected light adds, by an array that is none too bad: how many luminaires there are matters little to it. */
static luxel_status learn_reflected(struct lx_arranging *arranging)
{
    struct lx_superposition *superposition = &arranging->superposition;
    struct lx_computed computed = {.scene = NULL};
    struct lx_lamp_layout layout = {.dimming = 1};
    for (int i = 0; i < 2; i++) {
        layout.array.n[i] = 1 + (2 * superposition->least_mm[i] < superposition->half_mm[i]);
        layout.array.spacing_mm[i] = fmax(superposition->wall_mm[i], 1);
    }
    const luxel_status status = compute(arranging, &layout, LX_ROUGH, &computed);
    lx_computed_clear(&computed);
    return status;
}

static luxel_status search(struct lx_arranging *arranging)
{
    const unsigned most = arranging->wanted->most > 0 ? arranging->wanted->most : LUXEL_MOST_ARRANGED;
    luxel_arrangement *arrangement = &arranging->made->arrangement;
    luxel_status status = arranging->reflects ? learn_reflected(arranging) : LUXEL_OK;
    arranging->near = arranging->reflects ? NEAR_REFLECTED : NEAR;
    const double fewest = status == LUXEL_OK ? lx_fewest_luminaires(&arranging->superposition) : 1;
    if (!isfinite(fewest))
        return lx_refuse(arranging->diagnostics, LX_MSG_ARRANGE_DARK, NULL);
    /* what is reflected is known from one array, and none sends more of it to a grid by this much */
    arrangement->fewest = (unsigned)fmin(fmax(ceil(fewest * (arranging->reflects ? 0.9 : 0.9999)), 1), UINT_MAX / 2);
    unsigned below = arrangement->fewest, last = most;
    /* what there is below, so that something smaller can be told */
    while (below > 1 && below <= most && arrangement->tried == 0 && status == LUXEL_OK)
        status = try_count(arranging, --below);
    for (unsigned count = arrangement->fewest; count <= last && status == LUXEL_OK; count++) {
        const bool is_first = arranging->found == 0;
        status = try_count(arranging, count);
        /* of even arrays more light is nothing but more luminaires */
        if (is_first && arranging->found > 0)
            last = arranging->wanted->is_even ? count : count + 2 < most ? count + 2 : most;
        if (arrangement->computed >= MOST_COMPUTED)
            break;
    }
    return status;
}

/* ---- what is told ---- */

static bool is_computed(const struct lx_arranging *arranging, const struct lx_lamp_layout *layout)
{
    const struct lx_own_arrangement *made = arranging->made;
    for (size_t i = 0; i < made->arrangement.computed; i++)
        if (memcmp(made->computed[i].layout.n, layout->array.n, sizeof layout->array.n) == 0)
            return true;
    return false;
}

/* Computes the nearest of the arrays that are smaller than those found. */
static luxel_status compute_missed(struct lx_arranging *arranging)
{
    const struct lx_own_arrangement *made = arranging->made;
    luxel_status status = LUXEL_OK;
    unsigned smallest = ~0u;
    size_t told = 0;
    for (size_t i = 0; i < made->arrangement.computed; i++)
        if (made->computed[i].layout.reaches && number_of(made->computed[i].layout.n) < smallest)
            smallest = number_of(made->computed[i].layout.n);
    qsort(arranging->tried, made->arrangement.tried, sizeof *arranging->tried, compare_scores);
    const size_t most = !arranging->reflects ? MOST_TOLD : arranging->wanted->is_even ? 1 : MOST_TOLD_SLOW;
    for (size_t i = 0; i < made->arrangement.tried && told < most && status == LUXEL_OK; i++) {
        struct lx_computed *computed;
        if (number_of(arranging->tried[i].array.n) >= smallest)
            continue;
        told++;
        if (!is_computed(arranging, &arranging->tried[i]))
            status = keep(arranging, &arranging->tried[i], &computed);
    }
    return status;
}

static int compare_missed(const void *a, const void *b)
{
    const luxel_layout *first = a, *second = b;
    const int order = (first->reserve < second->reserve) - (first->reserve > second->reserve);
    return order != 0 ? order : compare_numbers(first->n, second->n);
}

static int compare_found(const void *a, const void *b)
{
    const luxel_layout *first = a, *second = b;
    const unsigned numbers[2] = {number_of(first->n), number_of(second->n)};
    if (numbers[0] != numbers[1])
        return numbers[0] < numbers[1] ? -1 : 1;
    if (first->dimming != second->dimming)
        return first->dimming < second->dimming ? -1 : 1;
    return compare_missed(a, b);
}

static luxel_status tell(struct lx_arranging *arranging)
{
    struct lx_own_arrangement *made = arranging->made;
    luxel_arrangement *arrangement = &made->arrangement;
    luxel_status status = arranging->wanted->key_count > 0 ? LUXEL_OK : compute_missed(arranging);
    made->found = lx_new_array(arrangement->computed + 1, sizeof *made->found);
    made->missed = lx_new_array(arrangement->computed + 1, sizeof *made->missed);
    if (status != LUXEL_OK || !made->found || !made->missed)
        return status != LUXEL_OK ? status : lx_out_of_memory(arranging->diagnostics);
    arrangement->found = made->found;
    arrangement->missed = made->missed;
    for (size_t i = 0; i < arrangement->computed; i++)
        if (made->computed[i].layout.reaches)
            made->found[arrangement->count++] = made->computed[i].layout;
    qsort(made->found, arrangement->count, sizeof *made->found, compare_found);
    for (size_t i = 0; i < arrangement->computed; i++)
        if (!made->computed[i].layout.reaches &&
            (arrangement->count == 0 || number_of(made->computed[i].layout.n) < number_of(made->found[0].n)))
            made->missed[arrangement->missed_count++] = made->computed[i].layout;
    qsort(made->missed, arrangement->missed_count, sizeof *made->missed, compare_missed);
    if (arrangement->missed_count > MOST_TOLD)
        arrangement->missed_count = MOST_TOLD;
    return LUXEL_OK;
}

static luxel_status begin(struct lx_arranging *arranging, const luxel_scene *scene)
{
    luxel_diagnostics *diagnostics = arranging->diagnostics;
    size_t *light = &arranging->made->arrangement.light;
    const bool tunes = arranging->wanted->key_count > 0;
    bool *on = lx_lights_on(lx_scene_parameters(scene), &arranging->settings);
    luxel_status status = on ? LUXEL_OK : lx_out_of_memory(diagnostics);
    if (on && tunes)
        *light = SIZE_MAX;
    else if (on)
        status = find_light(lx_scene_parameters(scene), on, arranging->wanted->light, diagnostics, light);
    free(on);
    const luxel_status goals = lx_goals_set(scene, arranging->wanted, diagnostics, &arranging->made->goals);
    if (status == LUXEL_OK)
        status = goals;
    if (status == LUXEL_OK)
        status = tunes ? lx_superposition_list(arranging->made->goals, &arranging->settings, diagnostics, true,
                                               &arranging->superposition)
                       : lx_superposition_make(arranging->made->goals, &arranging->settings, *light, diagnostics,
                                               &arranging->superposition);
    arranging->reflects = lx_wants_reflections(lx_scene_parameters(scene));
    arranging->values = lx_new_array(arranging->superposition.cells + 1, sizeof *arranging->values);
    arranging->room = lx_new_array(arranging->superposition.cells + 1, sizeof *arranging->room);
    lx_end_part(arranging);
    return status != LUXEL_OK || (arranging->values && arranging->room) ? status : lx_out_of_memory(diagnostics);
}

luxel_status luxel_arrange(const luxel_scene *scene, const luxel_settings *settings, const luxel_arranging *wanted,
                           luxel_diagnostics *diagnostics, luxel_arrangement **arrangement)
{
    if (!scene || !wanted || !arrangement || (!wanted->goals && wanted->goal_count > 0) ||
        (!wanted->keys && wanted->key_count > 0))
        return LUXEL_ERROR_ARGUMENT;
    *arrangement = NULL;
    if (!luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    struct lx_arranging arranging = {.wanted = wanted, .diagnostics = diagnostics};
    luxel_status status = LX_CHECK_RESERVE(wanted, diagnostics);
    if (status != LUXEL_OK)
        return status;
    if (settings)
        arranging.settings = *settings;
    else
        luxel_settings_init(&arranging.settings);
    arranging.progress = arranging.settings.progress;
    arranging.progress_data = arranging.settings.progress_data;
    if (arranging.progress)
        arranging.settings.progress = tell_progress;
    arranging.settings.progress_data = &arranging;
    arranging.made = lx_new_array(1, sizeof *arranging.made);
    status = arranging.made ? begin(&arranging, scene) : lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = wanted->key_count > 0 ? lx_tune(&arranging) : search(&arranging);
    if (status == LUXEL_OK)
        status = tell(&arranging);
    lx_superposition_clear(&arranging.superposition);
    free(arranging.tried);
    free(arranging.values);
    free(arranging.room);
    if (status != LUXEL_OK) {
        luxel_arrangement_free(arranging.made ? &arranging.made->arrangement : NULL);
        return status;
    }
    *arrangement = &arranging.made->arrangement;
    return LUXEL_OK;
}

/* SPDX-License-Identifier: MIT */
/* The keys of arrays, and the emitters of a light at all places of its array. */
#include "array.h"

#include <stdlib.h>

#include "../base/memory.h"
#include "../base/pose.h"
#include "../base/vector.h"
#include "../format/cloud.h"
#include "../parameter/check.h"
#include "carry.h"
#include "solid/facets.h"
#include "totals.h"

enum { MOST_IN_A_LINE = 1000, MOST_SPACING_MM = 1000000000 };

static const struct lx_parameter array_parameters[] = {
    {
        .name = "n",
        .label = "Places",
        .type = LX_WHOLES,
        .offset = offsetof(struct lx_array, n),
        .count = 2,
        .required = true,
        .legal = LX_BETWEEN(1, MOST_IN_A_LINE),
        .meaning = "the number of places, [columns, rows]",
    },
    {
        .name = "spacing",
        .label = "Spacing",
        .type = LX_REALS,
        .offset = offsetof(struct lx_array, spacing_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = {.given = true, .low = 0, .high = MOST_SPACING_MM, .low_open = true},
        .advised = {LX_BETWEEN(10, 20000)},
        .meaning = "the distance of one column from the next, and of one row from the next; each place is rounded to "
                   "float64 numbers",
    },
    {
        .name = "axes",
        .label = "Axes",
        .type = LX_VECTORS,
        .offset = offsetof(struct lx_array, axes),
        .count = 2,
        .meaning = "the two directions, of any length, in which the columns and the rows follow each other; not given: "
                   "[[1, 0, 0], [0, 1, 0]]",
    },
};

static void check_array(const struct lx_check *check, void *parameters)
{
    static const double none[3] = {0};
    const struct lx_vectors *axes = &((const struct lx_array *)parameters)->axes;
    if (!lx_is_given(&lx_array_table, parameters, "axes") || check->advises)
        return;
    bool is_good = axes->count == 2;
    for (size_t i = 0; i < 2 && is_good; i++)
        is_good = lx_distance(axes->xyz[i], none) > 0;
    if (!is_good || lx_are_parallel(axes->xyz[0], axes->xyz[1]))
        lx_check_report(check, "axes", LX_ALL_OF_IT, LX_MSG_ARRAY_AXES, NULL);
}

const struct lx_table lx_array_table = {
    .parameters = array_parameters,
    .count = LX_COUNT(array_parameters),
    .size = sizeof(struct lx_array),
    .check = check_array,
};

/* ---- lowering ---- */

const struct lx_array *lx_array_of(const struct lx_item *light)
{
    const struct lx_table *table = light->variant->table;
    const struct lx_parameter *key = lx_find_parameter(table, "array");
    return key && lx_is_given(table, light->parameters, "array") ? lx_const_member(key, light->parameters) : NULL;
}

size_t lx_light_places(const struct lx_item *light)
{
    const struct lx_array *array = lx_array_of(light);
    return array ? (size_t)array->n[0] * array->n[1] : 1;
}

/* The frame in which a light that stands at its own place is the copy in a column and a row. */
static struct lx_frame frame_of(const struct lx_array *array, unsigned column, unsigned row)
{
    static const double usual[2][3] = {{1, 0, 0}, {0, 1, 0}};
    const unsigned at[2] = {column, row};
    lx_wide3 away = lx_wide3_of((const double[3]){0});
    for (int i = 0; i < 2; i++) {
        const lx_wide3 axis = lx_wide3_of(array->axes.count == 2 ? array->axes.xyz[i] : usual[i]);
        const lx_wide steps = lx_wide_of(at[i] - (array->n[i] - 1) / 2.0);
        const lx_wide length = lx_wide_mul(steps, lx_wide_of(array->spacing_mm[i]));
        away = lx_wide3_add(away, lx_wide3_mul(axis, lx_wide_div(length, lx_wide3_length(axis))));
    }
    struct lx_frame frame = lx_frame_own();
    frame.origin_mm[0] = -lx_wide_value(away.x);
    frame.origin_mm[1] = -lx_wide_value(away.y);
    frame.origin_mm[2] = -lx_wide_value(away.z);
    frame.is_own = frame.origin_mm[0] == 0 && frame.origin_mm[1] == 0 && frame.origin_mm[2] == 0;
    return frame;
}

/* Appends one copy.  Facets that several emitters use one after the other are made once. */
static int append_copy(const struct lx_emitters *one, const struct lx_frame *frame, struct lx_emitters *emitters)
{
    struct lx_facets *moved = NULL;
    int failed = 0;
    for (size_t i = 0; i < lx_item_count(one) && !failed; i++) {
        struct lx_emitter copy = one->items[i];
        lx_frame_carry(frame, copy.position_mm, copy.position_mm);
        lx_frame_carry(frame, copy.center_mm, copy.center_mm);
        if (copy.facets && (i == 0 || copy.facets != one->items[i - 1].facets)) {
            lx_facets_free(moved);
            moved = lx_facets_carry(copy.facets, frame, emitters->asking);
        }
        if (copy.facets)
            copy.facets = moved ? (struct lx_facets *)lx_kept_hold(&moved->kept) : NULL;
        failed = one->items[i].facets && !copy.facets ? -1 : lx_emitters_append(emitters, &copy);
    }
    lx_facets_free(moved);
    for (size_t i = 0; i < one->point_set_count && !failed; i++) {
        struct lx_point_set set = one->point_sets[i];
        set.cloud = lx_cloud_carry(set.cloud, frame, emitters->asking);
        set.is_owned = true;
        failed = set.cloud ? lx_emitters_append_point_set(emitters, &set) : -1;
    }
    return failed;
}

static int append_array(const struct lx_array *array, const struct lx_emitters *one, struct lx_emitters *emitters)
{
    const size_t places = (size_t)array->n[0] * array->n[1];
    int failed = lx_emitters_make_room(emitters, (double)lx_item_count(one) * (double)places, one->faces * places,
                                       one->in_point_sets * places);
    for (unsigned row = 0; row < array->n[1]; row++)
        for (unsigned column = 0; column < array->n[0] && !failed; column++) {
            const struct lx_frame frame = frame_of(array, column, row);
            failed = append_copy(one, &frame, emitters);
        }
    return failed;
}

static int lower(const struct lx_item *light, struct lx_emitters *emitters)
{
    const struct lx_light_kind *kind = (const struct lx_light_kind *)light->variant;
    const struct lx_array *array = lx_array_of(light);
    if (!array)
        return kind->prepare(light->parameters, emitters);
    struct lx_emitters one = {
        .asking = emitters->asking,
        .is_whole = emitters->is_whole,
        .most = emitters->most,
        .most_in_point_sets = emitters->most_in_point_sets,
        .each = emitters->each,
        .each_in_point_sets = emitters->each_in_point_sets,
    };
    const int failed = kind->prepare(light->parameters, &one) == 0 ? append_array(array, &one, emitters) : -1;
    emitters->is_short = emitters->is_short || one.is_short;
    lx_emitters_clear(&one);
    return failed;
}

int lx_light_lower(const struct lx_item *light, double maintenance, double dimming, struct lx_emitters *emitters)
{
    const struct lx_light_kind *kind = (const struct lx_light_kind *)light->variant;
    const size_t items = lx_item_count(emitters), point_sets = emitters->point_set_count;
    int failed = lower(light, emitters);
    if (!failed && maintenance != 1 && !kind->is_daylight)
        failed = lx_emitters_scale(emitters, items, point_sets, maintenance);
    if (!failed && dimming != 1 && !kind->is_daylight)
        failed = lx_emitters_scale(emitters, items, point_sets, dimming);
    return failed;
}

struct lx_emitters lx_emitters_of_place(const struct lx_emitters *emitters, size_t places, size_t place)
{
    struct lx_emitters these = *emitters;
    if (places <= 1 || emitters->point_set_count > 0)
        return these;
    these.count = emitters->count / places;
    these.items += place * these.count;
    these.extended = emitters->extended / places;
    return these;
}

double (*lx_light_find_places(const struct lx_item *light))[3]
{
    const size_t count = lx_light_places(light);
    struct lx_emitters whole = {.is_whole = true};
    double(*places_mm)[3] = lx_new_array(count, sizeof *places_mm);
    bool is_there = places_mm && lower(light, &whole) == 0;
    for (size_t i = 0; i < count && is_there; i++) {
        const struct lx_emitters these = lx_emitters_of_place(&whole, count, i);
        is_there = lx_emitters_place(&these, places_mm[i]);
    }
    lx_emitters_clear(&whole);
    if (is_there)
        return places_mm;
    free(places_mm);
    return NULL;
}

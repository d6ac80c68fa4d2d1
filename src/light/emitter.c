/* SPDX-License-Identifier: MIT */
/* Lists of emitters. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/rows.h"
#include "../format/cloud.h"
#include "emitter.h"
#include "sky/dome_keeping.h"
#include "solid/area_light_facets.h"

/* Emitters that are appended between two questions whether to go on. */
enum { BETWEEN_CHECKS = 128 };

/* Room is made for so many items at once. */
static const double MANY = 4096;

/* Counts emitters that have the law of one in common. */
static void count_law(struct lx_emitters *emitters, const struct lx_emitter *emitter, size_t count)
{
    if (!lx_has_place(emitter) || emitter->attenuation == LX_INVERSE_SQUARE)
        emitters->by_square += count;
    else if (emitter->attenuation == LX_NO_ATTENUATION)
        emitters->unattenuated += count;
}

static bool is_within(const struct lx_emitters *emitters, double items, size_t faces, size_t in_point_sets)
{
    const bool have_own = emitters->most_in_point_sets > 0;
    const double counted = (double)(have_own ? lx_item_count(emitters) : emitters->count) + items;
    if (emitters->most == 0)
        return true;
    if (have_own && in_point_sets > emitters->most_in_point_sets - emitters->in_point_sets)
        return false;
    return counted + (have_own ? 0 : (double)in_point_sets) <= (double)emitters->most &&
           emitters->faces + faces <= emitters->most;
}

/* What memory could hold, and more, where it is not known how much there is. */
static const double MOST_EMITTERS = 1e9;

static bool fits(struct lx_emitters *emitters, double items, size_t faces, size_t in_point_sets)
{
    if (!is_within(emitters, items, faces, in_point_sets) && emitters->each > 0) {
        const double available = lx_available_bytes();
        emitters->most = (size_t)fmin(available / emitters->each, MOST_EMITTERS);
        emitters->most_in_point_sets = (size_t)fmin(available / emitters->each_in_point_sets, MOST_EMITTERS);
        emitters->each = 0;
    }
    emitters->is_short = !is_within(emitters, items, faces, in_point_sets);
    return !emitters->is_short;
}

int lx_emitters_make_room(struct lx_emitters *emitters, double items, size_t faces, size_t in_point_sets)
{
    if (!fits(emitters, items, faces, in_point_sets))
        return -1;
    emitters->faces += faces;
    const size_t before = lx_item_count(emitters);
    if (items < MANY || !((double)before + items > (double)emitters->capacity))
        return 0;
    if ((double)before > MANY) /* too much to copy in one go */
        return lx_reserve(&emitters->items, &emitters->capacity, before + (size_t)items, sizeof *emitters->items);
    struct lx_emitter *room = lx_new_aligned(before + (size_t)items, sizeof *room);
    if (!room)
        return -1;
    if (before > 0)
        memcpy(room, emitters->items, before * sizeof *room);
    free(emitters->items);
    emitters->items = room;
    emitters->capacity = before + (size_t)items;
    return 0;
}

int lx_emitters_append(struct lx_emitters *emitters, const struct lx_emitter *emitter)
{
    size_t items = lx_item_count(emitters);
    if (!lx_asking_at_step(emitters->asking, items, BETWEEN_CHECKS) || !fits(emitters, 1, 0, 0) ||
        lx_reserve(&emitters->items, &emitters->capacity, items + 1, sizeof *emitter)) {
        lx_facets_free(emitter->facets);
        lx_dome_free(emitter->dome);
        return -1;
    }
    emitters->items[items] = *emitter;
    emitters->items[items].light = emitters->light;
    emitters->count++;
    emitters->extended += lx_is_extended(emitter) || lx_is_dome(emitter);
    count_law(emitters, emitter, 1);
    return 0;
}

static void release_cloud(const struct lx_point_set *set)
{
    if (set->is_owned)
        lx_kept_release((struct lx_kept *)&set->cloud->kept);
}

int lx_emitters_append_point_set(struct lx_emitters *emitters, const struct lx_point_set *set)
{
    size_t rows = set->cloud->count;
    if (!fits(emitters, 0, 0, rows) ||
        lx_reserve(&emitters->point_sets, &emitters->point_set_capacity, emitters->point_set_count + 1, sizeof *set)) {
        release_cloud(set);
        return -1;
    }
    struct lx_point_set *added = &emitters->point_sets[emitters->point_set_count++];
    *added = *set;
    added->model.light = emitters->light;
    added->first = emitters->count;
    added->end = emitters->count += rows;
    emitters->in_point_sets += rows;
    count_law(emitters, &set->model, rows);
    return 0;
}

/* The cloud may be that of other scenes, too, and is copied. */
static int scale_point_set(struct lx_point_set *set, double factor)
{
    struct lx_cloud *scaled = lx_cloud_new(set->cloud->count);
    if (!scaled)
        return -1;
    scaled->intensities = set->cloud->intensities;
    scaled->tree = set->cloud->tree ? lx_kept_slot_new() : NULL;
    for (size_t i = 0; i < scaled->count; i++) {
        double *row = (double *)scaled->values + LX_CLOUD_COLUMNS * i;
        lx_cloud_row(set->cloud, i, row);
        row[3] *= factor;
    }
    release_cloud(set);
    set->cloud = scaled;
    set->is_owned = true;
    set->strength_error += DBL_EPSILON;
    return 0;
}

int lx_emitters_scale(struct lx_emitters *emitters, size_t items, size_t point_sets, double factor)
{
    int failed = 0;
    for (size_t i = items; i < lx_item_count(emitters); i++) {
        struct lx_emitter *emitter = &emitters->items[i];
        const lx_bounded strength = lx_mul(lx_strength(emitter), lx_exact(factor));
        emitter->strength = strength.value;
        emitter->strength_error = strength.error;
        emitter->radiance = lx_mul(emitter->radiance, lx_exact(factor));
    }
    for (size_t i = point_sets; i < emitters->point_set_count && !failed; i++)
        failed = scale_point_set(&emitters->point_sets[i], factor);
    return failed;
}

lx_bounded3 lx_point_set_axis(const struct lx_point_set *set, const double place_mm[3])
{
    return lx_unit3(lx_sub3(lx_exact3(set->aim_mm), lx_exact3(place_mm)));
}

/* Makes the model of a point set, or another point of it, the one of a row. */
static void set_point(const struct lx_point_set *set, size_t row, struct lx_emitter *point)
{
    double values[LX_CLOUD_COLUMNS];
    lx_cloud_row(set->cloud, row, values);
    memcpy(point->position_mm, values, sizeof point->position_mm);
    point->strength = values[3];
    point->strength_error = set->strength_error * values[3];
    if (set->is_aimed)
        point->profile.axis = lx_point_set_axis(set, point->position_mm);
}

/* The point set that emitter i is of; NULL: it is item `*item`. */
static const struct lx_point_set *point_set_of(const struct lx_emitters *emitters, size_t i, size_t *item)
{
    *item = i;
    for (size_t s = 0; s < emitters->point_set_count && i >= emitters->point_sets[s].first; s++) {
        const struct lx_point_set *set = &emitters->point_sets[s];
        if (i < set->end)
            return set;
        *item -= set->end - set->first;
    }
    return NULL;
}

const struct lx_emitter *lx_emitter_in_point_sets(const struct lx_emitters *emitters, size_t i, struct lx_emitter *room)
{
    size_t item;
    const struct lx_point_set *set = point_set_of(emitters, i, &item);
    if (!set)
        return &emitters->items[item];
    *room = set->model;
    set_point(set, i - set->first, room);
    return room;
}

bool lx_emitters_next(const struct lx_emitters *emitters, struct lx_emitter_span *span)
{
    size_t item;
    *span = (struct lx_emitter_span){.first = span->end};
    if (span->first == emitters->count)
        return false;
    span->set = point_set_of(emitters, span->first, &item);
    span->items = span->set ? NULL : &emitters->items[item];
    span->end = span->set ? span->set->end : emitters->count;
    for (size_t s = 0; !span->set && s < emitters->point_set_count; s++) {
        size_t next = emitters->point_sets[s].first;
        if (next > span->first && next < span->end)
            span->end = next;
    }
    return true;
}

const struct lx_emitter *lx_span_at(const struct lx_emitter_span *span, size_t i, struct lx_emitter *room)
{
    if (span->items)
        return &span->items[i - span->first];
    if (i == span->first)
        *room = span->set->model;
    set_point(span->set, i - span->first, room);
    return room;
}

void lx_emitter_row(const struct lx_emitters *emitters, size_t i, double row[4])
{
    size_t item;
    const struct lx_point_set *set = point_set_of(emitters, i, &item);
    if (set) {
        lx_cloud_row(set->cloud, i - set->first, row);
        return;
    }
    memcpy(row, emitters->items[item].position_mm, 3 * sizeof *row);
    row[3] = emitters->items[item].strength;
}

void lx_emitters_clear(struct lx_emitters *emitters)
{
    size_t left = emitters->extended; /* of these alone there is more to free: a million others are not looked at */
    for (size_t i = 0; left > 0 && i < lx_item_count(emitters); i++)
        if (lx_is_extended(&emitters->items[i]) || lx_is_dome(&emitters->items[i])) {
            lx_facets_free(emitters->items[i].facets);
            lx_dome_free(emitters->items[i].dome);
            left--;
        }
    for (size_t i = 0; i < emitters->point_set_count; i++)
        release_cloud(&emitters->point_sets[i]);
    for (size_t i = 0; i < emitters->turned_count; i++)
        free(emitters->turned[i]);
    free((void *)emitters->turned);
    free(emitters->items);
    free(emitters->point_sets);
    *emitters = (struct lx_emitters){0};
}

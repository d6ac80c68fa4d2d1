/* SPDX-License-Identifier: MIT */
/* Lists of emitters. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/rows.h"
#include "../format/cloud.h"
#include "emitter.h"
#include "solid/shell_facets.h"

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

static bool is_within(const struct lx_emitters *emitters, double items, size_t faces, size_t in_swarms)
{
    const bool have_own = emitters->most_in_swarms > 0;
    const double counted = (double)(have_own ? lx_item_count(emitters) : emitters->count) + items;
    if (emitters->most == 0)
        return true;
    if (have_own && in_swarms > emitters->most_in_swarms - emitters->in_swarms)
        return false;
    return counted + (have_own ? 0 : (double)in_swarms) <= (double)emitters->most &&
           emitters->faces + faces <= emitters->most;
}

/* What memory could hold, and more, where it is not known how much there is. */
static const double MOST_EMITTERS = 1e9;

static bool fits(struct lx_emitters *emitters, double items, size_t faces, size_t in_swarms)
{
    if (!is_within(emitters, items, faces, in_swarms) && emitters->each > 0) {
        const double available = lx_available_bytes();
        emitters->most = (size_t)fmin(available / emitters->each, MOST_EMITTERS);
        emitters->most_in_swarms = (size_t)fmin(available / emitters->each_in_swarms, MOST_EMITTERS);
        emitters->each = 0;
    }
    emitters->is_short = !is_within(emitters, items, faces, in_swarms);
    return !emitters->is_short;
}

int lx_emitters_make_room(struct lx_emitters *emitters, double items, size_t faces, size_t in_swarms)
{
    if (!fits(emitters, items, faces, in_swarms))
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
        return -1;
    }
    emitters->items[items] = *emitter;
    emitters->items[items].light = emitters->light;
    emitters->count++;
    emitters->extended += lx_is_extended(emitter);
    count_law(emitters, emitter, 1);
    return 0;
}

static void release_cloud(const struct lx_swarm *swarm)
{
    if (swarm->is_owned)
        lx_kept_release((struct lx_kept *)&swarm->cloud->kept);
}

int lx_emitters_append_swarm(struct lx_emitters *emitters, const struct lx_swarm *swarm)
{
    size_t rows = swarm->cloud->count;
    if (!fits(emitters, 0, 0, rows) ||
        lx_reserve(&emitters->swarms, &emitters->swarm_capacity, emitters->swarm_count + 1, sizeof *swarm)) {
        release_cloud(swarm);
        return -1;
    }
    struct lx_swarm *added = &emitters->swarms[emitters->swarm_count++];
    *added = *swarm;
    added->model.light = emitters->light;
    added->first = emitters->count;
    added->end = emitters->count += rows;
    emitters->in_swarms += rows;
    count_law(emitters, &swarm->model, rows);
    return 0;
}

lx_bounded3 lx_swarm_axis(const struct lx_swarm *swarm, const double place_mm[3])
{
    return lx_unit3(lx_sub3(lx_exact3(swarm->aim_mm), lx_exact3(place_mm)));
}

/* Makes the model of a swarm, or another point of it, the one of a row. */
static void set_point(const struct lx_swarm *swarm, size_t row, struct lx_emitter *point)
{
    double values[LX_CLOUD_COLUMNS];
    lx_cloud_row(swarm->cloud, row, values);
    memcpy(point->position_mm, values, sizeof point->position_mm);
    point->strength = values[3];
    if (swarm->is_aimed)
        point->profile.axis = lx_swarm_axis(swarm, point->position_mm);
}

/* The swarm that emitter i is of; NULL: it is item `*item`. */
static const struct lx_swarm *swarm_of(const struct lx_emitters *emitters, size_t i, size_t *item)
{
    *item = i;
    for (size_t s = 0; s < emitters->swarm_count && i >= emitters->swarms[s].first; s++) {
        const struct lx_swarm *swarm = &emitters->swarms[s];
        if (i < swarm->end)
            return swarm;
        *item -= swarm->end - swarm->first;
    }
    return NULL;
}

const struct lx_emitter *lx_emitter_in_swarms(const struct lx_emitters *emitters, size_t i, struct lx_emitter *room)
{
    size_t item;
    const struct lx_swarm *swarm = swarm_of(emitters, i, &item);
    if (!swarm)
        return &emitters->items[item];
    *room = swarm->model;
    set_point(swarm, i - swarm->first, room);
    return room;
}

bool lx_emitters_next(const struct lx_emitters *emitters, struct lx_emitter_span *span)
{
    size_t item;
    *span = (struct lx_emitter_span){.first = span->end};
    if (span->first == emitters->count)
        return false;
    span->swarm = swarm_of(emitters, span->first, &item);
    span->items = span->swarm ? NULL : &emitters->items[item];
    span->end = span->swarm ? span->swarm->end : emitters->count;
    for (size_t s = 0; !span->swarm && s < emitters->swarm_count; s++) {
        size_t next = emitters->swarms[s].first;
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
        *room = span->swarm->model;
    set_point(span->swarm, i - span->first, room);
    return room;
}

void lx_emitter_row(const struct lx_emitters *emitters, size_t i, double row[4])
{
    size_t item;
    const struct lx_swarm *swarm = swarm_of(emitters, i, &item);
    if (swarm) {
        lx_cloud_row(swarm->cloud, i - swarm->first, row);
        return;
    }
    memcpy(row, emitters->items[item].position_mm, 3 * sizeof *row);
    row[3] = emitters->items[item].strength;
}

void lx_emitters_clear(struct lx_emitters *emitters)
{
    size_t left = emitters->extended; /* of these alone there is more to free: a million others are not looked at */
    for (size_t i = 0; left > 0 && i < lx_item_count(emitters); i++)
        if (lx_is_extended(&emitters->items[i])) {
            lx_facets_free(emitters->items[i].facets);
            left--;
        }
    for (size_t i = 0; i < emitters->swarm_count; i++)
        release_cloud(&emitters->swarms[i]);
    for (size_t i = 0; i < emitters->turned_count; i++)
        free(emitters->turned[i]);
    free((void *)emitters->turned);
    free(emitters->items);
    free(emitters->swarms);
    *emitters = (struct lx_emitters){0};
}

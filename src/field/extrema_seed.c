/* SPDX-License-Identifier: MIT */
/*
 * Where to begin: the picture's own peaks, the places that face a light or mirror it (which may be narrower than a
 * pixel), and what extrema_rim.c finds along the edges.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../light/solid/extended.h"
#include "../world/camera.h"
#include "extrema.h"
#include "field.h"

/* The picture is cut into blocks, each of which proposes its best pixel: at most so many a side. */
enum { MOST_BLOCKS = 256, LEAST_BLOCK = 4 };
/* How many pixels are looked at more closely. */
enum { MOST_PIXELS = 40, MOST_PIXELS_COSTLY = 16, MOST_EQUAL = 200 };
/* Lights that are looked at one by one, a few where there are very many, and pairs of them and a surface. */
enum { MOST_LIGHTS = 64, MOST_LIGHTS_OF_MANY = 8, MOST_PAIRS = 2048 };
/* What a climb may find beyond its beginning, relative, where no pixel tells. */
static const double UNTOLD_MARGIN = 0.5, UNTOLD_MARGIN_COSTLY = 0.1;

double lx_unreported_margin(const struct lx_extremum_search *search, double value)
{
    return (search->costly ? UNTOLD_MARGIN_COSTLY : UNTOLD_MARGIN) * fabs(value);
}

void lx_gather_spot(struct lx_gathering *gathering, const struct lx_spot *spot, double value, double margin)
{
    struct lx_seeds *seeds = gathering->seeds;
    if (lx_reserve(&seeds->items, &seeds->capacity, seeds->count + 1, sizeof *seeds->items)) {
        gathering->search->short_of_memory = true;
        return;
    }
    seeds->items[seeds->count] = (struct lx_seed){*spot, value, margin, seeds->count};
    seeds->count++;
}

bool lx_look_through(struct lx_gathering *gathering, const double screen_mm[2], struct lx_spot *spot, double *value)
{
    double at[2];
    for (int i = 0; i < 2; i++)
        at[i] = fmin(fmax(screen_mm[i], gathering->low[i]), gathering->high[i]);
    const luxel_region *region = gathering->search->region;
    if (region && region->type == LUXEL_REGION_CIRCLE) {
        double out[2] = {at[0] - region->center_mm[0], at[1] - region->center_mm[1]};
        double share = region->radius_mm / hypot(out[0], out[1]);
        for (int i = 0; i < 2 && share < 1; i++)
            at[i] = region->center_mm[i] + (1 - 1e-12) * share * out[i];
    }
    return lx_spot_seen(gathering->search, at, spot, value);
}

bool lx_look_at_spot(struct lx_extremum_search *search, const struct lx_spot *spot, double *value)
{
    double error;
    if (!lx_edges_enter(search, spot))
        return false;
    *value = lx_piece_value(search, spot, &error);
    return isfinite(*value);
}

static void add_screen(struct lx_gathering *gathering, const double screen_mm[2])
{
    struct lx_spot spot;
    double value;
    if (lx_look_through(gathering, screen_mm, &spot, &value))
        lx_gather_spot(gathering, &spot, value, lx_unreported_margin(gathering->search, value));
}

static void add_place(struct lx_gathering *gathering, const struct lx_spot *spot)
{
    double place[3], normal[3], screen[2];
    lx_spot_place(gathering->search, spot, place, normal);
    if (lx_screen_of(gathering->search, place, screen))
        add_screen(gathering, screen);
}

static void add_if_seen(struct lx_gathering *gathering, const struct lx_spot *spot)
{
    double value;
    if (lx_look_at_spot(gathering->search, spot, &value))
        lx_gather_spot(gathering, spot, value, lx_unreported_margin(gathering->search, value));
}

/* -- the picture -- */

struct pixel {
    double value, margin;
    size_t index;
};

static double pixel_value(const struct lx_gathering *gathering, const luxel_field *field, size_t i)
{
    return gathering->search->sign * lx_field_value(field, i);
}

static bool counts(const struct lx_gathering *gathering, const luxel_field *field, unsigned column, unsigned row)
{
    size_t i = (size_t)row * field->columns + column;
    return field->mask[i] && luxel_region_holds(gathering->search->region, field->x_mm[column], field->y_mm[row]);
}

/* Whether a pixel is no lower than its neighbours; how much they differ from it. */
static bool is_peak(const struct lx_gathering *gathering, const luxel_field *field, struct pixel *pixel)
{
    unsigned column = (unsigned)(pixel->index % field->columns), row = (unsigned)(pixel->index / field->columns);
    unsigned left = column > 0 ? column - 1 : 0, top = row > 0 ? row - 1 : 0;
    pixel->margin = 0;
    for (unsigned y = top; y <= row + 1 && y < field->rows; y++)
        for (unsigned x = left; x <= column + 1 && x < field->columns; x++) {
            if (!counts(gathering, field, x, y))
                continue;
            double value = pixel_value(gathering, field, (size_t)y * field->columns + x);
            if (value > pixel->value)
                return false;
            pixel->margin = fmax(pixel->margin, 2 * (pixel->value - value));
        }
    return true;
}

static struct pixel best_of_block(const struct lx_gathering *gathering, const luxel_field *field,
                                  const unsigned first[2], const unsigned last[2])
{
    struct pixel best = {.value = -HUGE_VAL};
    for (unsigned row = first[1]; row < last[1]; row++)
        for (unsigned column = first[0]; column < last[0]; column++) {
            size_t i = (size_t)row * field->columns + column;
            double value = pixel_value(gathering, field, i);
            if (value > best.value && counts(gathering, field, column, row))
                best = (struct pixel){.value = value, .index = i};
        }
    return best;
}

static int compare_pixels(const void *left, const void *right)
{
    const struct pixel *a = left, *b = right;
    if (a->value != b->value)
        return a->value > b->value ? -1 : 1;
    return a->index < b->index ? -1 : a->index > b->index;
}

/* A pixel is near enough to the value that is found there: within 1e-3 of the maximum where that is costly. */
static void add_pixel(struct lx_gathering *gathering, const luxel_field *field, const struct pixel *pixel)
{
    struct lx_extremum_search *search = gathering->search;
    struct lx_spot spot;
    double screen[2] = {field->x_mm[pixel->index % field->columns], field->y_mm[pixel->index / field->columns]}, value;
    double doubt = search->costly ? 2e-3 * field->statistics.maximum.value : 1e-5 * fabs(pixel->value);
    if (search->costly ? lx_spot_shown(search, screen, &spot) : lx_spot_seen(search, screen, &spot, &value))
        lx_gather_spot(gathering, &spot, search->costly ? pixel->value : value, pixel->margin + doubt);
}

/* The best pixels; of many that are equal, as in the dark, some from everywhere. */
static void add_best_pixels(struct lx_gathering *gathering, const luxel_field *field, struct pixel *pixels,
                            size_t count)
{
    bool costly = gathering->search->costly;
    size_t most = costly ? MOST_PIXELS_COSTLY : MOST_PIXELS, most_equal = costly ? MOST_PIXELS_COSTLY : MOST_EQUAL;
    size_t equal = 0, taken;
    qsort(pixels, count, sizeof *pixels, compare_pixels);
    while (equal < count && pixels[equal].value == pixels[0].value)
        equal++;
    size_t stride = (equal + most_equal - 1) / most_equal;
    for (taken = 0; taken < equal; taken += stride)
        add_pixel(gathering, field, &pixels[taken]);
    for (size_t i = equal; i < count && i < equal + most; i++)
        if (pixels[i].value + pixels[i].margin + 0.02 * fabs(pixels[i].value) >= pixels[0].value)
            add_pixel(gathering, field, &pixels[i]);
}

static void add_pixels(struct lx_gathering *gathering, const luxel_field *field)
{
    unsigned size[2] = {field->columns, field->rows}, block[2], blocks[2];
    for (int i = 0; i < 2; i++) {
        block[i] = size[i] / MOST_BLOCKS + 1 > LEAST_BLOCK ? size[i] / MOST_BLOCKS + 1 : LEAST_BLOCK;
        blocks[i] = (size[i] + block[i] - 1) / block[i];
    }
    struct pixel *pixels = lx_new_array((size_t)blocks[0] * blocks[1], sizeof *pixels);
    size_t count = 0;
    gathering->search->short_of_memory |= !pixels;
    for (unsigned i = 0; pixels && i < blocks[0] * blocks[1]; i++) {
        unsigned first[2] = {i % blocks[0] * block[0], i / blocks[0] * block[1]};
        unsigned last[2] = {first[0] + block[0] < size[0] ? first[0] + block[0] : size[0],
                            first[1] + block[1] < size[1] ? first[1] + block[1] : size[1]};
        struct pixel best = best_of_block(gathering, field, first, last);
        if (best.value > -HUGE_VAL && is_peak(gathering, field, &best))
            pixels[count++] = best;
    }
    if (count > 0)
        add_best_pixels(gathering, field, pixels, count);
    free(pixels);
}

/* -- lights -- */

/* A light's direction, or its middle. */
static struct lx_origin origin_of(const struct lx_emitter *emitter)
{
    struct lx_origin origin = {.endless = lx_is_endless(emitter)};
    lx_emitter_origin(emitter, origin.at);
    return origin;
}

/* Whether an edge keeps what an emitter would give at a spot from being seen. */
static bool takes_away(const struct lx_extremum_search *search, size_t which, size_t emitter,
                       const struct lx_spot *spot)
{
    const struct lx_search_edge *it = &search->edges[which];
    struct lx_emitter room;
    const bool is_own = !lx_edge_is_wall(it) && it->emitter == emitter;
    const bool is_cone = /* those of a luminaire's table do not end its light */
        is_own && it->type == LX_EDGE_CONE &&
        !lx_emitter_at(&search->prepared->emitters, emitter, &room)->profile.luminaire;
    return (lx_edge_is_wall(it) || (is_own && it->type == LX_EDGE_SHADOW) || is_cone) &&
           lx_edge_distance(search, it, spot) < 0;
}

/* A place where geometry puts a peak; where it is hidden, off the screen or in the shade, also the next place that is
 * not, for the peak may be narrow. */
static void add_towards(struct lx_gathering *gathering, struct lx_spot spot, size_t emitter)
{
    struct lx_extremum_search *search = gathering->search;
    add_place(gathering, &spot);
    if (!lx_edges_of(search, spot.surface))
        return;
    bool moved = false;
    double step_mm = 1e-6 * lx_spot_shape(search, &spot)->radius_mm;
    for (size_t i = 0; i < 2 * search->edge_count; i++) { /* twice, for where two of them meet */
        size_t which = i % search->edge_count;
        if (!takes_away(search, which, emitter, &spot))
            continue;
        double inward[2];
        search->sides[which] = 1;
        struct lx_chart chart;
        if (!lx_edge_reach(search, which, &spot))
            return;
        chart = lx_spot_chart(search, &spot);
        if (!lx_edge_inward(search, which, &spot, &chart, inward))
            return;
        spot = lx_spot_moved(search, &spot, &chart, (double[]){step_mm * inward[0], step_mm * inward[1]});
        moved = true;
    }
    if (moved)
        add_if_seen(gathering, &spot);
}

/* What the middle of a light's beam hits. */
static void add_beam(struct lx_gathering *gathering, const struct lx_emitter *emitter)
{
    const struct lx_prepared *prepared = gathering->search->prepared;
    struct lx_ray ray = {.origin_error = {0}};
    lx_values3(emitter->profile.axis, ray.direction);
    memcpy(ray.origin_mm, emitter->position_mm, sizeof ray.origin_mm);
    for (size_t i = 0; i < prepared->surface_count; i++) {
        struct lx_hit hit = prepared->surfaces[i].kind->hit(&prepared->surfaces[i].shape, &ray);
        double place[3], screen[2];
        if (!hit.exists)
            continue;
        lx_values3(hit.place_mm, place);
        if (lx_screen_of(gathering->search, place, screen))
            add_screen(gathering, screen);
    }
}

static void add_light(struct lx_gathering *gathering, size_t surface, size_t index)
{
    struct lx_extremum_search *search = gathering->search;
    struct lx_emitter room;
    const struct lx_emitter *emitter = lx_emitter_at(&search->prepared->emitters, index, &room);
    const struct lx_shape *shape = &search->prepared->surfaces[surface].shape;
    const struct lx_origin light = origin_of(emitter), viewer = lx_viewer_of(search);
    double at[LX_MOST_GUESSES][3] = {{0}};
    int count = shape->kind->chart->guess ? shape->kind->chart->guess(shape, &light, &viewer, search->sign < 0, at) : 0;
    for (int i = 0; i < count; i++) {
        struct lx_spot spot = {.surface = surface};
        memcpy(spot.at, at[i], sizeof spot.at);
        add_towards(gathering, spot, index);
    }
}

static void add_lights(struct lx_gathering *gathering)
{
    struct lx_extremum_search *search = gathering->search;
    const struct lx_emitters *emitters = &search->prepared->emitters;
    size_t most = MOST_PAIRS / search->prepared->surface_count;
    size_t lights = emitters->count > MOST_LIGHTS ? MOST_LIGHTS_OF_MANY : MOST_LIGHTS;
    most = most > lights ? lights : most > 0 ? most : 1;
    size_t stride = emitters->count > most ? (emitters->count + most - 1) / most : 1;
    for (size_t i = 0; i < emitters->count && lx_search_goes_on(search); i += stride) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        if (lx_is_uniform(emitter) || lx_is_dome(emitter))
            continue;
        for (size_t k = 0; k < search->prepared->surface_count; k++)
            add_light(gathering, k, i);
        if (lx_is_point(emitter) && !lx_profile_is_isotropic(&emitter->profile))
            add_beam(gathering, emitter);
    }
}

static int compare_seeds(const void *left, const void *right)
{
    const struct lx_seed *a = left, *b = right;
    if (a->value != b->value)
        return a->value > b->value ? -1 : 1;
    return a->order < b->order ? -1 : a->order > b->order;
}

static void set_box(struct lx_gathering *gathering)
{
    const struct lx_screen *screen = &gathering->search->prepared->scene->screen;
    const luxel_region *region = gathering->search->region;
    double half[2] = {screen->width_mm / 2, screen->height_mm / 2};
    for (int i = 0; i < 2; i++) {
        gathering->low[i] = -half[i], gathering->high[i] = half[i];
        if (!region || region->type == LUXEL_REGION_ALL)
            continue;
        double reach = region->type == LUXEL_REGION_CIRCLE ? region->radius_mm : region->size_mm[i] / 2;
        gathering->low[i] = fmax(gathering->low[i], region->center_mm[i] - reach);
        gathering->high[i] = fmin(gathering->high[i], region->center_mm[i] + reach);
    }
}

bool lx_search_seeds(struct lx_extremum_search *search, const luxel_field *field, struct lx_seeds *seeds)
{
    struct lx_gathering gathering = {.search = search, .seeds = seeds};
    set_box(&gathering);
    if (!(gathering.low[0] <= gathering.high[0] && gathering.low[1] <= gathering.high[1]))
        return true; /* the region lies off the screen */
    add_pixels(&gathering, field);
    add_lights(&gathering);
    lx_gather_border(&gathering);
    for (size_t i = 0; i < search->prepared->surface_count && lx_search_goes_on(search); i++) {
        const struct lx_shape *shape = &search->prepared->surfaces[i].shape;
        const struct lx_origin eye = lx_eye_of(search);
        struct lx_spot middle = {.surface = i};
        shape->kind->chart->middle(shape, &eye, middle.at);
        add_place(&gathering, &middle);
        lx_gather_rim(&gathering, i);
    }
    if (seeds->count > 0)
        qsort(seeds->items, seeds->count, sizeof *seeds->items, compare_seeds);
    return lx_search_goes_on(search);
}

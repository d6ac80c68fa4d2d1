/* SPDX-License-Identifier: MIT */
/* Lights and parts of extended sources for the bounds of kernel_smooth.h. */
#include "smooth_lights.h"

#include <math.h>
#include <stdlib.h>

#include "../../base/larger.h"
#include "../../base/memory.h"
#include "../plan.h"
#include "../round_view.h"
#include "../area_light_bound.h"

/* Parts are so small against their distance from the surface, but not more than so many, if there are no more patches
 * than are cut at all. */
static const double FINENESS = 0.025;
enum { MOST_PATCHES = 64, MOST_PARTS = 256, LEAST_ALONG_SIDE = 2, MOST_ALONG_SIDE = 8 };

/* Lights between two questions whether to go on. */
enum { LIGHTS_BETWEEN_CHECKS = 1024 };

static int make_room(size_t count, struct lx_smooth_lights *made)
{
    double **arrays[] = {&made->x,       &made->y,        &made->z,        &made->radius,    &made->strays,
                         &made->sways,   &made->moves,    &made->gain,     &made->by_square, &made->by_root,
                         &made->by_none, &made->axis_x,   &made->axis_y,   &made->axis_z,    &made->inner,
                         &made->outer,   &made->exponent, &made->is_broken};
    const size_t length = lx_padded(count), number = sizeof arrays / sizeof *arrays;
    double *room = lx_new_aligned(number * length, sizeof *room);
    *made = (struct lx_smooth_lights){.count = count};
    for (size_t a = 0; a < number && room; a++)
        *arrays[a] = room + a * length;
    return room ? 0 : -1;
}

void lx_smooth_lights_clear(struct lx_smooth_lights *lights)
{
    free(lights->x); /* where the room of all begins */
}

/* ---- lights ---- */

/* Angles of a cosine pattern end at 90 degrees, as cones do. */
static void set_profile(const struct lx_light_double *light, struct lx_smooth_lights *lights, size_t i)
{
    const double none[2] = {-2, -3};
    const bool has_cone = light->falloff != LX_NO_CONE, has_pattern = light->exponent.value > 0;
    const double inner = lx_larger(light->inner_cosine, light->cosine);
    lights->axis_x[i] = light->axis_x, lights->axis_y[i] = light->axis_y, lights->axis_z[i] = light->axis_z;
    lights->inner[i] = has_cone ? lx_larger(inner, 0) : has_pattern ? 0 : none[0];
    lights->outer[i] = has_cone ? lx_larger(light->cosine, 0) : has_pattern ? 0 : none[1];
    if (light->luminaire) /* its lines are everywhere: never within the inner cone, nor dark beyond the outer one */
        lights->inner[i] = 3, lights->outer[i] = -3;
    lights->exponent[i] = light->exponent.value;
    lights->is_broken[i] = light->exponent.value != floor(light->exponent.value);
}

static void set_light(const struct lx_light_double *light, double radius_mm, struct lx_smooth_lights *lights, size_t i)
{
    const bool is_point = light->kind != LX_DISTANT;
    lights->x[i] = light->x, lights->y[i] = light->y, lights->z[i] = light->z;
    lights->radius[i] = lights->strays[i] = radius_mm;
    lights->sways[i] = 0;
    lights->moves[i] = is_point;
    lights->gain[i] = light->gain;
    if (is_point && light->law == LX_POLYNOMIAL) {
        lights->by_square[i] = light->by_square * 1e-6;
        lights->by_root[i] = light->by_root * 1e-3;
        lights->by_none[i] = light->by_none;
        set_profile(light, lights, i);
        return;
    }
    lights->by_square[i] = is_point && light->law == LX_INVERSE_SQUARE;
    lights->by_root[i] = is_point && light->law == LX_PRACTICAL;
    lights->by_none[i] = !is_point || light->law == LX_NO_ATTENUATION ? 1 : light->law == LX_PRACTICAL ? light->k : 0;
    set_profile(light, lights, i);
}

/* That of an area light, instead of the light's own. */
static void set_law(const struct lx_area_light_law *law, struct lx_smooth_lights *lights, size_t i)
{
    lights->by_square[i] = law->square;
    lights->by_root[i] = law->root;
    lights->by_none[i] = law->none;
}

luxel_status lx_smooth_lights_make(const struct lx_lights *lights, const struct lx_asking *asking,
                                   struct lx_smooth_lights *made)
{
    struct lx_light_room room = {.of_singles = NULL};
    if (make_room(lights->count, made))
        return LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < lx_padded(lights->count); i++) {
        const size_t light = i < lights->count ? i : lights->count - 1;
        if (!lx_asking_at_step(asking, i, LIGHTS_BETWEEN_CHECKS))
            return LUXEL_CANCELLED;
        set_light(lx_lights_double(lights, light, 1, &room), 0, made, i);
    }
    return LUXEL_OK;
}

int lx_smooth_luminaires_make(const struct lx_lights *lights, const uint32_t *which, size_t count,
                              struct lx_smooth_lights *made)
{
    struct lx_light_room room = {.of_singles = NULL};
    if (make_room(count, made))
        return -1;
    for (size_t i = 0; i < lx_padded(count); i++) {
        struct lx_light_double light = *lx_lights_double(lights, which[i < count ? i : count - 1], 1, &room);
        light.luminaire = NULL;
        set_light(&light, 0, made, i);
    }
    return 0;
}

/* ---- parts of extended sources ---- */

static size_t count_patches(const struct lx_planned_surface *surface)
{
    size_t patches = 0;
    for (size_t s = 0; s < surface->glossy_count; s++)
        patches += lx_patch_limit(surface->glossy[s].lamp);
    return patches;
}

bool lx_has_smooth_highlights(const struct lx_planned_surface *surface)
{
    for (size_t s = 0; s < surface->glossy_count; s++)
        if (surface->glossy[s].lamp->is_general)
            return false;
    return surface->glossy_count > 0 && count_patches(surface) <= MOST_PATCHES;
}

/* Into how many cells a patch is cut along s and t. */
struct cut {
    unsigned along_s, along_t;
};

/* A patch, whose it is, how far that is from the surface, and how the patch is cut. */
struct cut_patch {
    struct lx_patch patch;
    const struct lx_area_light *lamp;
    double away_mm;
    struct cut cut;
};

/* The number of cells of a length that is twice as long as half_mm. */
static unsigned cells_along(double half_mm, double away_mm, double least, double most)
{
    return (unsigned)fmax(fmin(ceil(half_mm / (FINENESS * lx_larger(away_mm, 0))), most), least);
}

/* The cut of a patch that is away_mm from the surface; turns are longer than radii. */
static struct cut cut_of(const struct lx_patch *patch, double away_mm, size_t patches)
{
    const struct lx_cell all = {0, 0, 1, 1};
    const double nowhere[3] = {0, 0, 0}, most = fmin(MOST_ALONG_SIDE, sqrt((double)MOST_PARTS / (double)patches));
    double middle[3];
    if (patch->kind == LX_PATCH_SIDE)
        return (struct cut){cells_along(patch->length / 2, away_mm, LEAST_ALONG_SIDE, most),
                            cells_along(patch->radius, away_mm, 1, most)};
    const double half = patch->kind == LX_PATCH_FLAT ? lx_cell_look(patch, &all, nowhere, middle) : patch->radius;
    const unsigned side = cells_along(half, away_mm, LEAST_ALONG_SIDE, most);
    return patch->kind == LX_PATCH_FLAT ? (struct cut){side, side} : (struct cut){(side + 1) / 2, 2 * side};
}

static size_t count_cells(const struct cut_patch *patch)
{
    return (size_t)patch->cut.along_s * patch->cut.along_t;
}

static struct lx_cell cell_of(const struct cut_patch *patch, size_t i)
{
    const double ds = 1.0 / patch->cut.along_s, dt = 1.0 / patch->cut.along_t;
    return (struct lx_cell){(double)(i % patch->cut.along_s) * ds, (double)(i / patch->cut.along_s) * dt, ds, dt};
}

/* The patches of all sources, `*count` of them; NULL when out of memory. */
static struct cut_patch *find_patches(const struct lx_planned_surface *surface, size_t *count)
{
    const struct lx_around everywhere = {.radius = HUGE_VAL};
    const size_t most = count_patches(surface);
    struct cut_patch *found = lx_new_array(most, sizeof *found);
    struct lx_patch *patches = lx_new_array(most, sizeof *patches);
    *count = 0;
    for (size_t s = 0; s < surface->glossy_count && found && patches; s++) {
        const struct lx_area_light *lamp = surface->glossy[s].lamp;
        const size_t more = lx_patches_make(lamp, &everywhere, NULL, patches);
        const double *center = lamp->center;
        const double away = sqrt(center[0] * center[0] + center[1] * center[1] + center[2] * center[2]);
        for (size_t i = 0; i < more; i++)
            found[(*count)++] =
                (struct cut_patch){.patch = patches[i], .lamp = lamp, .away_mm = away - surface->shape.radius_mm};
    }
    for (size_t p = 0; p < *count; p++)
        found[p].cut = cut_of(&found[p].patch, found[p].away_mm, *count);
    const bool complete = found && patches;
    free(patches);
    if (complete)
        return found;
    free(found);
    return NULL;
}

/* A cell of a patch as a light, and how far from its middle it reaches. */
static struct lx_light_double part_of(const struct lx_patch *patch, const struct lx_cell *cell, double radiance,
                                      double *radius_mm)
{
    enum { RULE = 3 };
    const double nowhere[3] = {0, 0, 0}; /* what a flat part is does not depend on who sees it */
    struct lx_samples_double samples;
    double middle[3], gain = 0;
    *radius_mm = lx_cell_look(patch, cell, nowhere, middle);
    lx_cell_samples(patch, cell, RULE, radiance, 0, &samples);
    for (size_t i = 0; i < (size_t)RULE * RULE; i++)
        gain += samples.gain[i];
    return (struct lx_light_double){
        .kind = LX_PROFILED,
        .x = middle[0],
        .y = middle[1],
        .z = middle[2],
        .gain = gain,
        .law = LX_INVERSE_SQUARE,
        .falloff = LX_NO_CONE,
        .axis_x = patch->n[0],
        .axis_y = patch->n[1],
        .axis_z = patch->n[2],
        .exponent = {.value = 1, .whole = 1},
    };
}

/* Whether what is seen of a patch depends on from where. */
static bool is_bent(const struct cut_patch *patch)
{
    return patch->patch.kind == LX_PATCH_BALL || patch->patch.kind == LX_PATCH_SIDE;
}

/* What whole lanes have beyond the lights is the last of these again. */
static void pad(struct lx_smooth_lights *lights, const struct lx_light_double *last, double radius_mm)
{
    for (size_t i = lights->count; i < lx_padded(lights->count); i++)
        set_light(last, radius_mm, lights, i);
}

static int take_parts(const struct cut_patch *patches, size_t count, struct lx_smooth_lights *flat,
                      struct lx_round_parts *round)
{
    size_t counts[2] = {0, 0}, next = 0;
    for (size_t p = 0; p < count; p++)
        counts[is_bent(&patches[p])] += count_cells(&patches[p]);
    round->parts = lx_new_array(counts[1], sizeof *round->parts);
    if (make_room(counts[0], flat) || !round->parts)
        return -1;
    struct lx_light_double part = {.kind = LX_PROFILED};
    double radius_mm = 0;
    for (size_t p = 0; p < count; p++) {
        for (size_t i = 0; i < count_cells(&patches[p]); i++) {
            const struct lx_cell cell = cell_of(&patches[p], i);
            if (is_bent(&patches[p])) {
                round->parts[round->count++] = (struct lx_round_part){patches[p].lamp, cell};
                continue;
            }
            part = part_of(&patches[p].patch, &cell, patches[p].lamp->radiance, &radius_mm);
            set_light(&part, radius_mm, flat, next);
            set_law(&patches[p].lamp->law, flat, next++);
        }
    }
    pad(flat, &part, radius_mm);
    return 0;
}

int lx_smooth_parts_make(const struct lx_planned_surface *surface, struct lx_smooth_lights *flat,
                         struct lx_round_parts *round)
{
    size_t count;
    struct cut_patch *patches = find_patches(surface, &count);
    *round = (struct lx_round_parts){.count = 0};
    const int status = patches ? take_parts(patches, count, flat, round) : -1;
    free(patches);
    return status;
}

/* ---- round parts ---- */

void lx_round_parts_clear(struct lx_round_parts *round)
{
    free(round->parts);
    *round = (struct lx_round_parts){.count = 0};
}

int lx_round_lights_make(size_t count, struct lx_smooth_lights *made)
{
    return make_room(count, made);
}

/* The patch of a ball or a cylinder's side as the middle of a square sees it, a ball as the disk that it is for it. */
static struct lx_patch round_patch(const struct lx_area_light *lamp, const struct lx_vicinity *at,
                                   const struct lx_round_view *view)
{
    const struct lx_around around = {.center = {at->place[0], at->place[1], at->place[2]}};
    struct lx_patch patches[LX_MOST_ROUND_PATCHES];
    lx_patches_make(lamp, &around, NULL, patches);
    if (lamp->is_ball) {
        const double sine = lamp->round_mm / view->distance;
        patches->kind = LX_PATCH_DISK;
        patches->radius = lamp->round_mm / sqrt(1 - sine * sine);
    }
    return *patches;
}

/*
 * What a part's places give at most as points by the law 1/r^2 together, but for the way r to those of a side.  Of a
 * ball that is rho^2 times the share of the disk's area, and times the cosine there, together |rho^2 sqrt(w.w/W.W)| <=
 * b^2/(1 - q).
 */
static double gain_of(const struct lx_area_light *lamp, const struct lx_cell *cell, const struct lx_round_view *view)
{
    const double radius = lamp->round_mm, end = cell->s + cell->ds, q = view->share;
    if (lamp->is_ball)
        return lamp->radiance * M_PI * radius * radius / (1 - q) * (end * end - cell->s * cell->s) * cell->dt;
    const double from = 2 * cell->t - 1, to = 2 * (cell->t + cell->dt) - 1; /* 2 t/(1 + t^2): docs/MATHS.md */
    const double turn = 2 * to / (1 + to * to) - 2 * from / (1 + from * from);
    return lamp->radiance * radius * 2 * lamp->half_mm * cell->ds * turn * view->most * (1 + q) * sqrt(1 + q);
}

/* A part as the square sees it, with what its places move by.  Too near for a bound its gain means nothing. */
static void place_part(const struct lx_round_part *part, const struct lx_vicinity *at, const struct lx_round_view *view,
                       const struct lx_patch *patch, struct lx_smooth_lights *made, size_t i)
{
    const struct lx_deviation *place = &at->place_deviation;
    struct lx_light_double light = {.kind = LX_BY_SQUARE, .law = LX_INVERSE_SQUARE, .falloff = LX_NO_CONE};
    double middle[3], square = 0;
    const double radius = lx_cell_look(patch, &part->cell, at->place, middle);
    for (int k = 0; k < 3; k++)
        square += (middle[k] - at->place[k]) * (middle[k] - at->place[k]);
    const double sways = view->aside * lx_beyond_real(place), strays = radius + view->along * place->first + sways;
    const double nearest = sqrt(square) - strays - place->first - place->second, imaginary = place->imaginary + sways;
    light.gain = gain_of(part->lamp, &part->cell, view);
    if (part->lamp->has_side && nearest > imaginary)
        light.gain /= sqrt((nearest - imaginary) * (nearest + imaginary));
    light.x = middle[0], light.y = middle[1], light.z = middle[2];
    if (part->lamp->is_ball)
        light.gain *= lx_most_of_ball(part->lamp, at);
    set_light(&light, radius + view->along * place->tile, made, i);
    if (!part->lamp->is_ball)
        set_law(&part->lamp->law, made, i);
    made->strays[i] = strays;
    made->sways[i] = sways;
}

/* Whether the square is beyond an end of a cylinder whose side it does not see. */
static bool is_hidden(const struct lx_area_light *lamp, const struct lx_vicinity *at)
{
    double from_center[3];
    for (int k = 0; k < 3; k++)
        from_center[k] = at->place[k] - lamp->center[k];
    return lamp->has_side &&
           lx_distance_from_axis(lamp, from_center) + at->place_deviation.tile + lamp->touch_mm < lamp->round_mm;
}

void lx_round_lights_place(const struct lx_round_parts *round, const struct lx_vicinity *at,
                           struct lx_smooth_lights *made)
{
    const struct lx_light_double nowhere = {.kind = LX_BY_SQUARE,
                                            .law = LX_INVERSE_SQUARE,
                                            .falloff = LX_NO_CONE,
                                            .x = at->place[0],
                                            .y = at->place[1],
                                            .z = at->place[2]};
    made->count = 0;
    for (size_t i = 0, next; i < round->count; i = next) {
        const struct lx_area_light *lamp = round->parts[i].lamp;
        struct lx_round_view view;
        const bool is_bounded = !lamp->is_ball || isfinite(lx_most_of_ball(lamp, at));
        const bool is_outside = is_bounded && lx_round_view_of(lamp, at, &view);
        const bool is_seen = is_outside || !is_hidden(lamp, at);
        const struct lx_patch patch = is_outside ? round_patch(lamp, at, &view) : (struct lx_patch){.radius = 0};
        for (next = i; next < round->count && round->parts[next].lamp == lamp; next++)
            if (is_outside)
                place_part(&round->parts[next], at, &view, &patch, made, made->count++);
            else if (is_seen)
                set_light(&nowhere, 0, made, made->count++);
    }
    pad(made, &nowhere, 0);
}

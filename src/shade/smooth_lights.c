/* SPDX-License-Identifier: MIT */
/* Lights and parts of extended sources for the bounds of kernel_smooth.h. */
#include "smooth_lights.h"

#include <math.h>
#include <stdlib.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "plan.h"
#include "shell.h"

/* Parts are so small against their distance from the surface, but not more than so many, if there are no more patches
 * than are cut at all. */
static const double FINENESS = 0.025;
enum { MOST_PATCHES = 64, MOST_PARTS = 256, LEAST_ALONG_SIDE = 2, MOST_ALONG_SIDE = 8 };

/* Lights between two questions whether to go on. */
enum { LIGHTS_BETWEEN_CHECKS = 1024 };

static int make_room(size_t count, struct lx_smooth_lights *made)
{
    double **arrays[] = {&made->x,       &made->y,      &made->z,         &made->radius,
                         &made->moves,   &made->gain,   &made->by_square, &made->by_root,
                         &made->by_none, &made->axis_x, &made->axis_y,    &made->axis_z,
                         &made->inner,   &made->outer,  &made->exponent,  &made->is_broken};
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
    lights->exponent[i] = light->exponent.value;
    lights->is_broken[i] = light->exponent.value != floor(light->exponent.value);
}

static void set_light(const struct lx_light_double *light, double radius_mm, struct lx_smooth_lights *lights, size_t i)
{
    const bool is_point = light->kind != LX_DISTANT;
    lights->x[i] = light->x, lights->y[i] = light->y, lights->z[i] = light->z;
    lights->radius[i] = radius_mm;
    lights->moves[i] = is_point;
    lights->gain[i] = light->gain;
    lights->by_square[i] = is_point && light->law == LX_INVERSE_SQUARE;
    lights->by_root[i] = is_point && light->law == LX_PRACTICAL;
    lights->by_none[i] = !is_point || light->law == LX_NO_ATTENUATION ? 1 : light->law == LX_PRACTICAL ? light->k : 0;
    set_profile(light, lights, i);
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

/* ---- parts of extended sources ---- */

static size_t count_patches(const struct lx_planned_surface *surface)
{
    size_t patches = 0;
    for (size_t s = 0; s < surface->glossy_count; s++)
        patches += lx_patch_limit(surface->glossy[s].shell);
    return patches;
}

bool lx_has_smooth_highlights(const struct lx_planned_surface *surface)
{
    for (size_t s = 0; s < surface->glossy_count; s++) {
        const enum lx_emitter_type type = surface->glossy[s].shell->type;
        if ((type != LX_FACETS && type != LX_DISK) || surface->glossy[s].law != LX_INVERSE_SQUARE)
            return false;
    }
    return surface->glossy_count > 0 && count_patches(surface) <= MOST_PATCHES;
}

/* A patch, how bright it is, and how far its source's middle is from the surface. */
struct bright_patch {
    struct lx_patch patch;
    double radiance, away_mm;
};

/* Into how many cells patches are cut along s and t; turns are longer than radii. */
struct cut {
    unsigned along_s, along_t;
};

static struct cut cut_of(const struct bright_patch *bright, size_t patches)
{
    const struct lx_cell all = {0, 0, 1, 1};
    const double nowhere[3] = {0, 0, 0};
    const bool is_disk = bright->patch.kind == LX_PATCH_DISK;
    double middle[3];
    const double radius = is_disk ? bright->patch.radius : lx_cell_look(&bright->patch, &all, nowhere, middle);
    const double wanted = radius / (FINENESS * lx_larger(bright->away_mm, 0));
    const double most = fmin(MOST_ALONG_SIDE, sqrt((double)MOST_PARTS / (double)patches));
    const unsigned side = (unsigned)fmax(fmin(ceil(wanted), most), LEAST_ALONG_SIDE);
    return is_disk ? (struct cut){(side + 1) / 2, 2 * side} : (struct cut){side, side};
}

/* A cell of a patch as a light. */
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

/* The patches of all sources, `*count` of them; NULL when memory ran out. */
static struct bright_patch *find_patches(const struct lx_planned_surface *surface, size_t *count)
{
    const struct lx_around everywhere = {.radius = HUGE_VAL};
    struct bright_patch *found = lx_new_array(count_patches(surface), sizeof *found);
    struct lx_patch *patches = lx_new_array(count_patches(surface), sizeof *patches);
    *count = 0;
    for (size_t s = 0; s < surface->glossy_count && found && patches; s++) {
        const struct lx_shell *shell = surface->glossy[s].shell;
        const size_t more = lx_patches_make(shell, &everywhere, NULL, patches);
        const double *center = shell->center;
        const double away = sqrt(center[0] * center[0] + center[1] * center[1] + center[2] * center[2]);
        for (size_t i = 0; i < more; i++)
            found[(*count)++] = (struct bright_patch){patches[i], shell->radiance, away - surface->shape.radius_mm};
    }
    const bool complete = found && patches;
    free(patches);
    if (complete)
        return found;
    free(found);
    return NULL;
}

int lx_smooth_parts_make(const struct lx_planned_surface *surface, struct lx_smooth_lights *made)
{
    size_t patches, parts = 0;
    struct bright_patch *found = find_patches(surface, &patches);
    for (size_t p = 0; p < patches && found; p++) {
        const struct cut cut = cut_of(&found[p], patches);
        parts += (size_t)cut.along_s * cut.along_t;
    }
    if (!found || make_room(parts, made)) {
        free(found);
        return -1;
    }
    struct lx_light_double part = {.kind = LX_PROFILED};
    double radius_mm = 0;
    size_t next = 0;
    for (size_t p = 0; p < patches; p++) {
        const struct cut cut = cut_of(&found[p], patches);
        const double ds = 1.0 / cut.along_s, dt = 1.0 / cut.along_t;
        for (unsigned i = 0; i < cut.along_s * cut.along_t; i++) {
            const struct lx_cell cell = {i % cut.along_s * ds, i / cut.along_s * dt, ds, dt};
            part = part_of(&found[p].patch, &cell, found[p].radiance, &radius_mm);
            set_light(&part, radius_mm, made, next++);
        }
    }
    for (; next < lx_padded(parts); next++)
        set_light(&part, radius_mm, made, next);
    free(found);
    return 0;
}

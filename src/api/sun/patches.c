/* SPDX-License-Identifier: MIT */
/*
 * Patches of sun.  On the front of each flat surface that faces the sun: inside of a room its openings, cast along the
 * sun's direction onto the surface's plane; outside of rooms the whole surface.  From both the shadows of all flat
 * surfaces are taken, which are what of them is before that plane, cast onto it.
 */
#include <luxel/sunlight.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/diagnostics.h"
#include "../../base/memory.h"
#include "../../base/vector.h"
#include "../../scene/object.h"
#include "../../surface/pane.h"
#include "../../world/prepared.h"
#include "convex.h"
#include "site.h"

/* Shares of the size of a surface: what is nearer than that is at one place, and what of its area is nothing. */
static const double NEAR = 1e-9, NOTHING = 1e-12;

enum { CORNERS = 4, ROOM_SIDES = 6 };

struct casting {
    const struct lx_prepared *prepared;
    double sun[3], up[3];
    /* the surface that is lit: */
    const struct lx_prepared_surface *lit;
    struct lx_flat flat;
    double near_mm, least_mm2;
    luxel_sun_patches *made;
    size_t capacity;
};

/* How a surface lies; false: it is not flat with four sides. */
static bool lies_flat(const struct lx_prepared_surface *surface, struct lx_flat *flat)
{
    const struct lx_part part = {.kind = surface->kind, .parameters = surface->parameters, .shape = surface->shape};
    return lx_part_flat(&part, flat);
}

/* ---- in the plane that is lit ---- */

static double height_of(const struct casting *casting, const double place_mm[3])
{
    const struct lx_shape *shape = &casting->lit->shape;
    double height = 0;
    for (int k = 0; k < 3; k++)
        height += (place_mm[k] - shape->anchor_mm[k]) * shape->axis[k];
    return height;
}

/* Where a place is cast, along the sun's direction. */
static void cast(const struct casting *casting, const double place_mm[3], double at_mm[2])
{
    const struct lx_shape *shape = &casting->lit->shape;
    const double away = height_of(casting, place_mm) / lx_dot(casting->sun, shape->axis);
    at_mm[0] = at_mm[1] = 0;
    for (int k = 0; k < 3; k++) {
        const double offset = place_mm[k] - away * casting->sun[k] - shape->anchor_mm[k];
        at_mm[0] += offset * shape->across[k];
        at_mm[1] += offset * shape->upward[k];
    }
}

static void place_of(const struct casting *casting, const double at_mm[2], double place_mm[3])
{
    const struct lx_shape *shape = &casting->lit->shape;
    for (int k = 0; k < 3; k++)
        place_mm[k] = shape->anchor_mm[k] + at_mm[0] * shape->across[k] + at_mm[1] * shape->upward[k];
}

static int new_polygon(size_t count, struct lx_convex *polygon)
{
    *polygon = (struct lx_convex){lx_new_array(count, sizeof *polygon->corners), 0};
    return polygon->corners ? 0 : -1;
}

/* A rectangle somewhere, what of it is before the plane, as it is cast onto that; counter-clockwise. */
static int cast_rectangle(const struct casting *casting, const double center_mm[3], const double across[3],
                          const double upward[3], const double half_mm[2], struct lx_convex *polygon)
{
    double corners[CORNERS][3];
    if (new_polygon(CORNERS + 1, polygon))
        return -1;
    for (int i = 0; i < CORNERS; i++)
        for (int k = 0; k < 3; k++)
            corners[i][k] = center_mm[k] + (i == 0 || i == 3 ? -1 : 1) * half_mm[0] * across[k] +
                            (i < 2 ? -1 : 1) * half_mm[1] * upward[k];
    for (int i = 0; i < CORNERS; i++) {
        const double *from = corners[i], *to = corners[(i + 1) % CORNERS];
        const double above = height_of(casting, from) - casting->near_mm,
                     next = height_of(casting, to) - casting->near_mm;
        double edge[3];
        if (above > 0)
            cast(casting, from, polygon->corners[polygon->count++]);
        if ((above > 0) == (next > 0))
            continue;
        for (int k = 0; k < 3; k++)
            edge[k] = from[k] + above / (above - next) * (to[k] - from[k]);
        cast(casting, edge, polygon->corners[polygon->count++]);
    }
    const bool is_turned = lx_convex_area(polygon) < 0;
    for (size_t i = 0; is_turned && i < polygon->count / 2; i++) {
        double *a = polygon->corners[i], *b = polygon->corners[polygon->count - 1 - i];
        for (int k = 0; k < 2; k++) {
            const double kept = a[k];
            a[k] = b[k];
            b[k] = kept;
        }
    }
    return 0;
}

/* All of the surface that is lit. */
static int whole(const struct casting *casting, struct lx_convex *polygon)
{
    const double *size_mm = casting->flat.size_mm;
    if (new_polygon(CORNERS, polygon))
        return -1;
    polygon->count = CORNERS;
    for (int i = 0; i < CORNERS; i++) {
        polygon->corners[i][0] = (i == 0 || i == 3 ? -1 : 1) * size_mm[0] / 2;
        polygon->corners[i][1] = (i < 2 ? -1 : 1) * size_mm[1] / 2;
    }
    return 0;
}

/* What of a polygon of the plane is in the room around a pane. */
static int within_room(const struct casting *casting, const struct lx_glass_pane *pane, const struct lx_convex *polygon,
                       struct lx_convex *kept)
{
    const struct lx_shape *shape = &casting->lit->shape;
    struct lx_convex rest;
    if (lx_convex_share(polygon, polygon, casting->near_mm, &rest))
        return -1;
    for (int i = 0; i < ROOM_SIDES && rest.count > 0; i++) {
        const double *axis = pane->room_axes[i / 2], sign = i % 2 ? -1 : 1;
        double from[3], side[3];
        for (int k = 0; k < 3; k++)
            from[k] = shape->anchor_mm[k] - pane->room_center_mm[k];
        side[0] = sign * lx_dot(axis, shape->across);
        side[1] = sign * lx_dot(axis, shape->upward);
        side[2] = sign * lx_dot(axis, from) + pane->room_half_mm[i / 2];
        const double length = hypot(side[0], side[1]);
        if (length < NEAR) { /* along the wall, and on it only if it faces the room */
            const bool is_on = fabs(side[2]) <= casting->near_mm;
            rest.count = (is_on ? sign * lx_dot(axis, shape->axis) : side[2]) > 0 ? rest.count : 0;
            continue;
        }
        for (int k = 0; k < 3; k++)
            side[k] /= length;
        const int failed = lx_convex_cut(&rest, side, casting->near_mm, kept);
        lx_convex_clear(&rest);
        if (failed)
            return -1;
        rest = *kept;
    }
    *kept = rest;
    return 0;
}

/* ---- what takes light ---- */

/* Whether the shadow of the ball around a surface may reach a polygon. */
static bool may_reach(const struct casting *casting, const struct lx_prepared_surface *surface,
                      const struct lx_convex *polygon)
{
    double center[3], at[2], radius = 0;
    for (int k = 0; k < 3; k++) {
        center[k] = (surface->low_mm[k] + surface->high_mm[k]) / 2;
        radius = hypot(radius, (surface->high_mm[k] - surface->low_mm[k]) / 2);
    }
    if (height_of(casting, center) + radius <= casting->near_mm)
        return false;
    cast(casting, center, at);
    radius /= lx_dot(casting->sun, casting->lit->shape.axis);
    for (size_t i = 0; i < polygon->count; i++) {
        const double *from = polygon->corners[i], *to = polygon->corners[(i + 1) % polygon->count];
        const double length = hypot(to[0] - from[0], to[1] - from[1]);
        const double beyond = ((to[1] - from[1]) * (at[0] - from[0]) - (to[0] - from[0]) * (at[1] - from[1]));
        if (beyond > radius * length)
            return false;
    }
    return true;
}

/* Takes the shadows of all flat surfaces from pieces, but for those of one of the scene's list. */
static int take_shadows(const struct casting *casting, size_t but, struct lx_convexes *pieces)
{
    const struct lx_prepared *prepared = casting->prepared;
    for (size_t i = 0; i < prepared->surface_count && pieces->count > 0 && prepared->shadows_on_free; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[i];
        struct lx_flat flat;
        struct lx_convex shadow;
        if (surface == casting->lit || surface->authored == but || !lies_flat(surface, &flat))
            continue;
        const double half[2] = {flat.size_mm[0] / 2, flat.size_mm[1] / 2};
        if (cast_rectangle(casting, surface->shape.anchor_mm, surface->shape.across, surface->shape.upward, half,
                           &shadow))
            return -1;
        const int failed = lx_convexes_subtract(pieces, &shadow, casting->near_mm, casting->least_mm2);
        lx_convex_clear(&shadow);
        if (failed)
            return -1;
    }
    return 0;
}

/* ---- patches ---- */

static int note_others(const struct casting *casting, const struct lx_convex *piece, luxel_sun_patch *patch)
{
    const struct lx_prepared *prepared = casting->prepared;
    patch->others = lx_new_array(prepared->surface_count + 1, sizeof *patch->others);
    if (!patch->others)
        return -1;
    for (size_t i = 0; i < prepared->surface_count && prepared->shadows_on_free; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[i];
        struct lx_flat flat;
        const bool is_known = patch->other_count > 0 && patch->others[patch->other_count - 1] == surface->authored;
        if (!is_known && !lies_flat(surface, &flat) && may_reach(casting, surface, piece))
            patch->others[patch->other_count++] = surface->authored;
    }
    return 0;
}

static int add_patch(struct casting *casting, const struct lx_convex *piece, const luxel_sun_patch *like)
{
    luxel_sun_patches *made = casting->made;
    if (lx_reserve(&made->list, &casting->capacity, made->count + 1, sizeof *made->list))
        return -1;
    luxel_sun_patch *patch = &made->list[made->count++];
    *patch = *like;
    patch->surface_name = NULL;
    patch->area_mm2 = lx_convex_area(piece);
    patch->corners_mm = lx_new_array(piece->count, sizeof *patch->corners_mm);
    if (!patch->corners_mm || note_others(casting, piece, patch))
        return -1;
    if (like->surface_name) {
        patch->surface_name = lx_copy_text(like->surface_name, strlen(like->surface_name));
        if (!patch->surface_name)
            return -1;
    }
    for (size_t i = 0; i < piece->count; i++)
        place_of(casting, piece->corners[i], patch->corners_mm[patch->corner_count++]);
    return 0;
}

/* Takes shadows from one polygon, which is cleared, and makes patches of what is left. */
static int light_polygon(struct casting *casting, struct lx_convex *polygon, size_t but, const luxel_sun_patch *like)
{
    struct lx_convexes pieces = {NULL, 0, 0};
    int failed = lx_convexes_take(&pieces, polygon, casting->least_mm2) || take_shadows(casting, but, &pieces);
    for (size_t i = 0; i < pieces.count && !failed; i++)
        failed = add_patch(casting, &pieces.items[i], like);
    lx_convexes_clear(&pieces);
    return failed;
}

/* What comes through an opening; `part` is what of the surface is in its room. */
static int light_through(struct casting *casting, const struct lx_glass_pane *pane, size_t opening,
                         const struct lx_convex *part, luxel_sun_patch like)
{
    struct lx_convex light, shared;
    if (!(lx_dot(pane->axis, casting->sun) < 0)) /* the axis points into the room */
        return 0;
    if (cast_rectangle(casting, pane->center_mm, pane->across, pane->upward, pane->half_mm, &light))
        return -1;
    like.has_opening = true;
    like.room = pane->surface;
    like.opening = opening;
    if (light.count == 0) { /* all of it is behind the surface */
        lx_convex_clear(&light);
        return 0;
    }
    const int failed = lx_convex_share(part, &light, casting->near_mm, &shared);
    lx_convex_clear(&light);
    return failed ? -1 : light_polygon(casting, &shared, pane->surface, &like);
}

/* A surface: room by room, by the panes of each, which follow each other; then what is outside of all rooms. */
static int light_surface(struct casting *casting, const luxel_sun_patch *like)
{
    const struct lx_prepared *prepared = casting->prepared;
    struct lx_convex all, part = {NULL, 0};
    struct lx_convexes outside = {NULL, 0, 0};
    if (whole(casting, &all))
        return -1;
    int failed = 0;
    for (size_t i = 0, first = 0; i < prepared->pane_count && !failed; i++) {
        const struct lx_glass_pane *pane = &prepared->panes[i];
        first = pane->surface == prepared->panes[first].surface ? first : i;
        failed = within_room(casting, pane, &all, &part);
        if (!failed && lx_convex_area(&part) > casting->least_mm2)
            failed = light_through(casting, pane, i - first, &part, *like);
        if (!failed)
            lx_convex_clear(&part);
    }
    failed = failed || lx_convexes_take(&outside, &all, casting->least_mm2);
    for (size_t i = 0; i < prepared->pane_count && !failed; i++) {
        if (i > 0 && prepared->panes[i].surface == prepared->panes[i - 1].surface)
            continue;
        struct lx_convex rest = {NULL, 0};
        failed = whole(casting, &rest) || within_room(casting, &prepared->panes[i], &rest, &part) ||
                 lx_convexes_subtract(&outside, &part, casting->near_mm, casting->least_mm2);
        lx_convex_clear(&rest);
        lx_convex_clear(&part);
    }
    for (size_t i = 0; i < outside.count && !failed; i++)
        failed = light_polygon(casting, &outside.items[i], SIZE_MAX, like);
    lx_convexes_clear(&outside);
    lx_convex_clear(&all);
    return failed;
}

static int light_all(struct casting *casting)
{
    const struct lx_prepared *prepared = casting->prepared;
    for (size_t i = 0; i < prepared->surface_count; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[i];
        const struct lx_item *item = &prepared->scene->surfaces.items[surface->authored];
        if (!lies_flat(surface, &casting->flat) || !(lx_dot(surface->shape.axis, casting->sun) > NEAR))
            continue;
        const double size = fmax(casting->flat.size_mm[0], casting->flat.size_mm[1]);
        casting->lit = surface;
        casting->near_mm = NEAR * size;
        casting->least_mm2 = NOTHING * size * size;
        const luxel_sun_patch like = {
            .surface = surface->authored,
            .surface_name = ((const struct lx_surface_common *)item->common)->name,
            .part = lx_part_name((const struct lx_surface_kind *)item->variant, surface->part),
        };
        if (light_surface(casting, &like))
            return -1;
    }
    return 0;
}

void luxel_sun_patches_free(luxel_sun_patches *patches)
{
    if (!patches)
        return;
    for (size_t i = 0; i < patches->count; i++) {
        free((char *)patches->list[i].surface_name);
        free(patches->list[i].corners_mm);
        free(patches->list[i].others);
    }
    free(patches->list);
    free(patches);
}

luxel_status luxel_find_sun_patches(const luxel_scene *scene, luxel_diagnostics *diagnostics,
                                    luxel_sun_patches **patches)
{
    struct lx_prepared prepared = {.scene = NULL};
    struct lx_sun_site site = {.has_sun = false};
    if (!patches)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("patches"));
    *patches = NULL;
    if (!scene || !luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    for (size_t i = 0; i < scene->parameters.lights.count && !site.has_sun; i++)
        lx_sun_site_of(&scene->parameters.lights.items[i], &site);
    if (!site.has_sun) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_SUN, NULL);
        lx_hint(diagnostics, LX_MSG_HINT_NO_SUN, NULL);
        return LUXEL_ERROR_SCENE;
    }
    double up[3];
    memcpy(up, site.ways.up, sizeof up);
    lx_normalize(up);
    luxel_sun_patches *made = lx_new_array(1, sizeof *made);
    luxel_status status = LUXEL_ERROR_MEMORY;
    if (made && !lx_prepare(&scene->parameters, NULL, NULL, &prepared)) {
        struct casting casting = {.prepared = &prepared, .made = made};
        memcpy(casting.sun, site.towards, sizeof casting.sun);
        memcpy(made->towards, site.towards, sizeof made->towards);
        made->altitude_deg = asin(fmax(-1, fmin(lx_dot(up, site.towards), 1))) * (180 / M_PI);
        status = light_all(&casting) ? LUXEL_ERROR_MEMORY : LUXEL_OK;
    }
    lx_prepared_clear(&prepared);
    if (status == LUXEL_OK) {
        *patches = made;
        return LUXEL_OK;
    }
    luxel_sun_patches_free(made);
    return lx_out_of_memory(diagnostics);
}

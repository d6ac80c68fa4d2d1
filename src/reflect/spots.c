/* SPDX-License-Identifier: MIT */
/*
 * Pictures: reflected light where surfaces are seen is the polynomial of the tile there.  Tiles are refined until the
 * bounds of all that the picture shows are a small share of its greatest value.
 */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../surface/mesh_faces.h"
#include "group.h"
#include "reflected.h"
#include "solution.h"

/* How far beyond a face or a tile rounding may put a place of it, in its coordinates. */
static const double BESIDE = 1e-6;
/* A tile that is no share of itself near to its edges is not left for another one that a place has in common. */
static const double STRICTLY = 1e-9;
/* The share of the bound that what arrives of errors may take. */
static const double ARRIVES = 0.75;

/* ---- where a place is ---- */

/* How far a place is beyond the sheet, in its coordinates; infinite on the other side of the surface. */
static double beyond_face(const struct lx_matte_face *face, const double place_mm[3], const double normal[3],
                          double at[2])
{
    const struct lx_smooth_sheet *sheet = &face->sheet;
    double there[3], out[3];
    if (face->is_flat) {
        if (sheet->turn * lx_dot(sheet->axis, normal) <= 0)
            return HUGE_VAL;
        for (int i = 0; i < 3; i++)
            there[i] = place_mm[i] - sheet->center_mm[i];
        if (face->is_facet && fabs(lx_dot(sheet->axis, there)) > BESIDE * face->radius_mm)
            return HUGE_VAL;
        lx_sheet_locate(sheet, place_mm, at);
    } else {
        lx_sheet_locate(sheet, place_mm, at);
        if (!(fabs(at[0]) <= 1 + BESIDE && fabs(at[1]) <= 1 + BESIDE))
            return HUGE_VAL;
        lx_sheet_place(sheet, at[0], at[1], there, out);
        if (lx_dot(out, normal) <= 0)
            return HUGE_VAL;
    }
    return fmax(fabs(at[0]), fabs(at[1])) - 1;
}

static double beyond_tile(const struct lx_tile *tile, const double at[2])
{
    return fmax(fabs(at[0] - tile->window.middle[0]) - tile->window.half[0],
                fabs(at[1] - tile->window.middle[1]) - tile->window.half[1]);
}

/* Faces by their surfaces, sides and triangles. */
static int by_triangle(const void *key, const void *item)
{
    const struct lx_matte_face *a = key, *b = item;
    if (a->surface != b->surface)
        return a->surface < b->surface ? -1 : 1;
    if (a->sheet.turn != b->sheet.turn)
        return a->sheet.turn > b->sheet.turn ? -1 : 1;
    return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* The face of a mesh on which a place lies, and where; SIZE_MAX: it was left out. */
static size_t find_triangle(const struct lx_radiosity *reflected, const struct lx_shape *shape, size_t surface,
                            const double place_mm[3], const double normal[3], double at[2])
{
    struct lx_matte_face key = {.surface = surface, .triangle = (uint32_t)lx_mesh_triangle_at(shape, place_mm)};
    if (!lx_mesh_sheet(shape, key.triangle, &key.sheet))
        return SIZE_MAX;
    key.sheet.turn = lx_dot(key.sheet.axis, normal) < 0 ? -1 : 1;
    lx_sheet_locate(&key.sheet, place_mm, at);
    const struct lx_matte_face *found =
        bsearch(&key, reflected->faces, reflected->face_count, sizeof *reflected->faces, by_triangle);
    return found ? (size_t)(found - reflected->faces) : SIZE_MAX;
}

/* The face of a place, and where on it; SIZE_MAX: there is none. */
static size_t find_face(const struct lx_radiosity *reflected, size_t surface, const double place_mm[3],
                        const double normal[3], double at[2])
{
    double least = HUGE_VAL, trial[2];
    size_t face = SIZE_MAX;
    for (size_t f = 0; f < reflected->face_count; f++) {
        if (reflected->faces[f].surface != surface)
            continue;
        const double beyond = beyond_face(&reflected->faces[f], place_mm, normal, trial);
        if (beyond < least) {
            least = beyond;
            face = f;
            at[0] = trial[0], at[1] = trial[1];
        }
    }
    return face;
}

/* The tile of a place, and where on its face; SIZE_MAX: there is none. */
static size_t find_tile(const struct lx_radiosity *reflected, const struct lx_prepared *prepared, size_t surface,
                        const double place_mm[3], const double normal[3], double at[2])
{
    const struct lx_shape *shape = &prepared->surfaces[surface].shape;
    const size_t face = lx_mesh_count(shape) > 0 ? find_triangle(reflected, shape, surface, place_mm, normal, at)
                                                 : find_face(reflected, surface, place_mm, normal, at);
    size_t found = SIZE_MAX;
    double least = HUGE_VAL;
    if (face == SIZE_MAX)
        return SIZE_MAX;
    for (size_t t = reflected->first_tile[face]; t < reflected->first_tile[face + 1] && least > 0; t++) {
        const double beyond = beyond_tile(&reflected->tiles[t], at);
        if (beyond < least) {
            least = beyond;
            found = t;
        }
    }
    return found;
}

/* Whether a place is well within the tile that was found before. */
static bool is_on(const struct lx_radiosity *reflected, size_t t, size_t surface, const double place_mm[3],
                  const double normal[3], double at[2])
{
    const struct lx_tile *tile = &reflected->tiles[t];
    const struct lx_matte_face *face = &reflected->faces[tile->face];
    return face->surface == surface && beyond_face(face, place_mm, normal, at) < -STRICTLY &&
           beyond_tile(tile, at) < -STRICTLY;
}

static size_t tile_of(const struct lx_radiosity *reflected, const struct lx_prepared *prepared, size_t surface,
                      const double place_mm[3], const double normal[3], size_t *near, double at[2])
{
    if (*near == 0 || !is_on(reflected, *near - 1, surface, place_mm, normal, at))
        *near = find_tile(reflected, prepared, surface, place_mm, normal, at) + 1;
    return *near - 1;
}

lx_bounded lx_reflected_on(const struct lx_radiosity *reflected, const struct lx_prepared *prepared, size_t surface,
                           const double place_mm[3], const double normal[3], size_t *near)
{
    double at[2] = {0, 0};
    if (!reflected->indirect) /* there is no light */
        return lx_exact(0);
    const size_t t = tile_of(reflected, prepared, surface, place_mm, normal, near, at);
    if (t == SIZE_MAX)
        return lx_exact(0);
    return lx_parts_value(reflected, t, at);
}

/* ---- refinement ---- */

/* The error that a picture allows on each tile: a share of its greatest value, of which there is a lower bound; NULL:
 * memory ran out. */
static double *find_allowed(const struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    double *allowed = lx_new_array(reflected->tile_count, sizeof *allowed), maximum = 0;
    size_t near = 0;
    for (size_t i = 0; allowed && i < request->spot_count; i++) {
        const struct lx_reflected_spot *spot = &request->spots[i];
        const lx_bounded light =
            lx_reflected_on(reflected, request->prepared, spot->surface, spot->place_mm, spot->normal, &near);
        maximum = fmax(maximum, spot->value + spot->share * light.value);
        if (near > 0)
            allowed[near - 1] = fmax(allowed[near - 1], spot->share);
    }
    for (size_t t = 0; allowed && t < reflected->tile_count; t++)
        allowed[t] = allowed[t] > 0 ? request->error * maximum / allowed[t] : HUGE_VAL;
    return allowed;
}

double lx_spots_error(const struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    double *allowed = find_allowed(reflected, request);
    const double error = allowed ? request->error * lx_parts_showing(reflected, allowed) : HUGE_VAL;
    free(allowed);
    return error;
}

luxel_status lx_spots_show(struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool anyway)
{
    double *allowed = find_allowed(reflected, request);
    struct lx_reflected_place place;
    const int any = allowed ? lx_parts_worst(reflected, allowed, ARRIVES, 1, &place) : -1;
    /* parts help no further than to what arrives */
    const double least = any >= 0 && anyway ? fmax(lx_parts_arriving(reflected, allowed) / ARRIVES, 1) : 1;
    for (size_t t = 0; any >= 0 && t < reflected->tile_count; t++)
        allowed[t] *= least;
    const luxel_status status = any < 0              ? LUXEL_ERROR_MEMORY
                                : any == 0 || anyway ? lx_parts_refine(reflected, allowed)
                                                     : LUXEL_OK;
    free(allowed);
    return status;
}

/* Errors that a part has of its own are mended there; those that arrive at it, where they come from. */
int lx_spots_cut(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool *cuts)
{
    enum { MOST_WORST = 16 };
    const size_t count = reflected->tile_count, most = (reflected->most_tiles - count) / 3 + 1;
    struct lx_reflected_place places[MOST_WORST];
    double *allowed = find_allowed(reflected, request), *scores = lx_new_array(count, sizeof *scores);
    int any = allowed && scores ? lx_parts_worst(reflected, allowed, ARRIVES, MOST_WORST, places) : -1;
    if (any > 0)
        any = lx_weigh(reflected, places, (size_t)any, scores) ? -1 : lx_cut_greatest(reflected, scores, most, cuts);
    free(scores);
    free(allowed);
    return any;
}

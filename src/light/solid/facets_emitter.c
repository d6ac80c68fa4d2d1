/* SPDX-License-Identifier: MIT */
/* The emitter made of facets: a convex polygon that shines from its front, or a polyhedron that shines outwards. */
#include <math.h>
#include <string.h>

#include "../../base/vector.h"
#include "../emitter_kind.h"
#include "facets.h"

static void normal_of(const struct lx_face *face, double normal[3])
{
    const lx_bounded3 direction = lx_wide3_direction(face->normal);
    normal[0] = direction.x.value, normal[1] = direction.y.value, normal[2] = direction.z.value;
}

static void corner_of(const struct lx_facets *facets, size_t i, double corner[3])
{
    const lx_wide3 *wide = &facets->corners_mm[i];
    corner[0] = lx_wide_value(wide->x), corner[1] = lx_wide_value(wide->y), corner[2] = lx_wide_value(wide->z);
}

/* The sum of the rounded areas of the faces. */
static lx_bounded area(const struct lx_emitter *emitter)
{
    return lx_rounded(emitter->facets->area_mm2, 0, 4 + (double)emitter->facets->face_count);
}

static double section(const struct lx_emitter *emitter)
{
    return emitter->facets->area_mm2;
}

static double area_seen(const struct lx_emitter *emitter, const double towards[3])
{
    double sum = 0, normal[3];
    for (size_t i = 0; i < emitter->facets->face_count; i++) {
        normal_of(&emitter->facets->faces[i], normal);
        sum += emitter->facets->faces[i].area_mm2 * fmax(0, lx_dot(normal, towards));
    }
    return sum;
}

static bool touches(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    return lx_facets_touch(emitter->facets, place_mm);
}

static lx_bounded irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal)
{
    return lx_facets_irradiance(emitter->facets, place_mm, normal);
}

static double extent(const struct lx_emitter *emitter, const double place_mm[3], const double direction[3],
                     double *nearest)
{
    double corner[3], farthest = -HUGE_VAL;
    *nearest = HUGE_VAL;
    for (size_t i = 0; i < emitter->facets->corner_count; i++) {
        corner_of(emitter->facets, i, corner);
        for (int k = 0; k < 3; k++)
            corner[k] -= place_mm[k];
        const double along = lx_dot(direction, corner);
        farthest = fmax(farthest, along);
        *nearest = fmin(*nearest, along);
    }
    return farthest;
}

static void farthest(const struct lx_emitter *emitter, const double towards[3], double place_mm[3])
{
    double furthest = -HUGE_VAL, corner[3];
    for (size_t i = 0; i < emitter->facets->corner_count; i++) {
        corner_of(emitter->facets, i, corner);
        if (!(lx_dot(corner, towards) > furthest))
            continue;
        furthest = lx_dot(corner, towards);
        memcpy(place_mm, corner, sizeof corner);
    }
}

static bool plane(const struct lx_emitter *emitter, double place_mm[3], double normal[3])
{
    const struct lx_facets *facets = emitter->facets;
    if (facets->face_count != 1)
        return false;
    corner_of(facets, facets->loop[facets->faces[0].first], place_mm);
    normal_of(&facets->faces[0], normal);
    return true;
}

const struct lx_emitter_kind lx_facets_emitter = {
    .name = "facets",
    .share_seen = 1,
    .area_mm2 = area,
    .section_mm2 = section,
    .area_seen_mm2 = area_seen,
    .touches = touches,
    .irradiance = irradiance,
    .cut = lx_facets_cut,
    .extent = extent,
    .farthest = farthest,
    .plane = plane,
};

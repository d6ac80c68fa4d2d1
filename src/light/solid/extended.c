/* SPDX-License-Identifier: MIT */
/* Extended emitters by their kind. */
#include <stdlib.h>

#include "elliptic.h"
#include "extended.h"
#include "facets.h"
#include "round.h"

/* Whether it is within a sphere that is an opening, whose surface is seen from outside alone. */
static bool is_within(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    const lx_bounded3 offset = lx_sub3(lx_exact3(emitter->center_mm), place_mm);
    return lx_is_opening(emitter) && emitter->type == LX_BALL && !lx_is_elliptic(emitter) &&
           lx_length3(offset).value < emitter->radius_mm;
}

bool lx_extended_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    if (is_within(emitter, place_mm))
        return true;
    if (emitter->type == LX_FACETS)
        return lx_facets_touch(emitter->facets, place_mm);
    if (lx_is_elliptic(emitter))
        return lx_elliptic_touches(emitter, place_mm);
    return lx_round_touches(emitter, place_mm);
}

/* The area of facets was summed as it stands, from the rounded areas of the faces. */
lx_bounded lx_extended_area_mm2(const struct lx_emitter *emitter)
{
    lx_bounded pi = lx_rounded(M_PI, 0, 1);
    lx_bounded radius = lx_exact(emitter->radius_mm), square = lx_mul(radius, radius);
    if (lx_is_elliptic(emitter))
        return lx_elliptic_area_mm2(emitter);
    switch (emitter->type) {
    case LX_FACETS: return lx_rounded(emitter->facets->area_mm2, 0, 4 + (double)emitter->facets->face_count);
    case LX_DISK: return lx_mul(pi, square);
    case LX_BALL: return lx_scale(lx_mul(pi, square), 4);
    case LX_CYLINDER: return lx_scale(lx_mul(pi, lx_add(square, lx_mul(radius, lx_exact(emitter->height_mm)))), 2);
    default: break;
    }
    return lx_exact(0);
}

lx_bounded lx_extended_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal)
{
    if (emitter->type == LX_FACETS)
        return lx_mul(emitter->radiance, lx_facets_irradiance(emitter->facets, place_mm, normal));
    return lx_mul(emitter->radiance, lx_round_irradiance(emitter, place_mm, normal));
}

int lx_extended_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters)
{
    size_t first = lx_item_count(emitters), first_swarm = emitters->swarm_count;
    int failed =
        emitter->type == LX_FACETS ? lx_facets_cut(emitter, parts, emitters) : lx_round_cut(emitter, parts, emitters);
    for (size_t i = first; i < lx_item_count(emitters); i++)
        emitters->items[i].is_part = true;
    for (size_t i = first_swarm; i < emitters->swarm_count; i++)
        emitters->swarms[i].model.is_part = true;
    return failed;
}

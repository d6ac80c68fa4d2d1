/* SPDX-License-Identifier: MIT */
/* Extended emitters: what all of them answer in the same way. */
#include <stdlib.h>
#include <string.h>

#include "extended.h"

lx_bounded lx_extended_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal)
{
    return lx_mul(emitter->radiance, lx_emitter_kind(emitter)->irradiance(emitter, place_mm, normal));
}

struct lx_emitter lx_extended_as_point(const struct lx_emitter *emitter)
{
    struct lx_emitter point = *emitter;
    point.type = LX_POINT;
    point.facets = NULL;
    point.strength = emitter->radiance.value * lx_extended_area_mm2(emitter).value / 1e6;
    point.profile = lx_profile_isotropic();
    memcpy(point.position_mm, lx_emitter_center(emitter), sizeof point.position_mm);
    return point;
}

int lx_extended_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters)
{
    size_t first = lx_item_count(emitters), first_point_set = emitters->point_set_count;
    int failed = lx_emitter_kind(emitter)->cut(emitter, parts, emitters);
    for (size_t i = first; i < lx_item_count(emitters); i++)
        emitters->items[i].is_part = true;
    for (size_t i = first_point_set; i < emitters->point_set_count; i++)
        emitters->point_sets[i].model.is_part = true;
    return failed;
}

bool lx_emitter_plane(const struct lx_emitter *emitter, double place_mm[3], double normal[3])
{
    const struct lx_emitter_kind *kind = lx_emitter_kind(emitter);
    return kind->plane && kind->plane(emitter, place_mm, normal);
}

double lx_relative_law(const struct lx_emitter *emitter, double distance_mm)
{
    const double r = distance_mm / 1000;
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return 1;
    case LX_PRACTICAL: return r * r / (emitter->k_mm / 1000 + r);
    case LX_POLYNOMIAL: return r * r * lx_by_polynomial(emitter->coefficients, r);
    case LX_NO_ATTENUATION: break;
    }
    return r * r;
}

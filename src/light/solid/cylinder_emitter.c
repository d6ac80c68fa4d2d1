/* SPDX-License-Identifier: MIT */
/* The right circular cylinder as an emitter, both ends included, which shines outwards; as a luminous opening one over
 * an ellipse, too. */
#include <math.h>

#include "../../base/vector.h"
#include "elliptic.h"
#include "round.h"

static lx_bounded area(const struct lx_emitter *cylinder)
{
    const lx_bounded radius = lx_exact(cylinder->radius_mm), pi = lx_rounded(M_PI, 0, 1);
    const lx_bounded square = lx_mul(radius, radius), side = lx_mul(radius, lx_exact(cylinder->height_mm));
    return lx_is_elliptic(cylinder) ? lx_elliptic_area_mm2(cylinder) : lx_scale(lx_mul(pi, lx_add(square, side)), 2);
}

static double section(const struct lx_emitter *cylinder)
{
    const double radius = cylinder->radius_mm, half = cylinder->height_mm / 2;
    return M_PI * radius * radius + 4 * half * radius;
}

static double area_seen(const struct lx_emitter *cylinder, const double towards[3])
{
    const double axis[3] = {cylinder->axis.x.value, cylinder->axis.y.value, cylinder->axis.z.value};
    const double radius = cylinder->radius_mm, along = lx_dot(axis, towards);
    return M_PI * radius * radius * fabs(along) + 2 * radius * cylinder->height_mm * sqrt(fmax(0, 1 - along * along));
}

const struct lx_emitter_kind lx_cylinder_emitter = {
    .name = "cylinder",
    .has_side = true,
    .share_seen = 0.5,
    .area_mm2 = area,
    .section_mm2 = section,
    .area_seen_mm2 = area_seen,
    .touches = lx_round_touches,
    .irradiance = lx_cylinder_irradiance,
    .cut = lx_cylinder_cut,
    .extent = lx_round_extent,
    .farthest = lx_round_farthest,
};

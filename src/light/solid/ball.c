/* SPDX-License-Identifier: MIT */
/* The ball as an emitter, a sphere that shines outwards; as a luminous opening an ellipsoid, too. */
#include <math.h>

#include "elliptic.h"
#include "round.h"

static lx_bounded area(const struct lx_emitter *ball)
{
    const lx_bounded radius = lx_exact(ball->radius_mm), pi = lx_rounded(M_PI, 0, 1);
    return lx_is_elliptic(ball) ? lx_elliptic_area_mm2(ball) : lx_scale(lx_mul(pi, lx_mul(radius, radius)), 4);
}

static double section(const struct lx_emitter *ball)
{
    return M_PI * ball->radius_mm * ball->radius_mm;
}

static double area_seen(const struct lx_emitter *ball, const double towards[3])
{
    (void)towards;
    return section(ball);
}

/* A sphere that is an opening is seen from outside alone: there is no L from within. */
static bool touches(const struct lx_emitter *ball, lx_bounded3 place_mm)
{
    const lx_bounded3 offset = lx_sub3(lx_exact3(ball->center_mm), place_mm);
    const bool is_within = lx_is_opening(ball) && !lx_is_elliptic(ball) && lx_length3(offset).value < ball->radius_mm;
    return is_within || lx_round_touches(ball, place_mm);
}

const struct lx_emitter_kind lx_ball_emitter = {
    .name = "ball",
    .bulges = true,
    .share_seen = 0.25,
    .area_mm2 = area,
    .section_mm2 = section,
    .area_seen_mm2 = area_seen,
    .touches = touches,
    .irradiance = lx_ball_irradiance,
    .cut = lx_ball_cut,
    .extent = lx_round_extent,
    .farthest = lx_round_farthest,
};

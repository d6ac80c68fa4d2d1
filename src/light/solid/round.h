/* SPDX-License-Identifier: MIT */
/*
 * Disks, balls and cylinders: what an element sees of them is bounded by arcs of circles and straight ways, for which
 * the contour integral of extended.h is elementary (rim.h).  Where nothing of a disk is below the element's horizon,
 *
 *     E = 2 pi R^2/(W (K + W)) ((h^2 + t) N.a + h rho N.u)
 *     K = rho^2 + h^2 + R^2,  X = rho^2 + h^2 - R^2,  W = sqrt(X^2 + 4 h^2 R^2),  t = 2 h^2 R^2/(W + X)
 *
 * its plane being at the distance h along a, the foot of the perpendicular rho away from its centre, which lies in the
 * direction u from there; a ball is seen as a disk with rho = 0, h = sqrt(d^2 - R^2).
 */
#ifndef LX_LIGHT_ROUND_H
#define LX_LIGHT_ROUND_H

#include "../emitter_kind.h"

/* Half the height of the side; 0 where there is none. */
static inline double lx_half_height(const struct lx_emitter *emitter)
{
    return lx_emitter_kind(emitter)->has_side ? emitter->height_mm / 2 : 0;
}

/* Whether it is another one when it is turned. */
static inline bool lx_has_axis(const struct lx_emitter *emitter)
{
    return lx_emitter_kind(emitter)->has_side || !lx_emitter_kind(emitter)->bulges;
}

/* Whether it is flat and shines along its axis. */
static inline bool lx_is_disk(const struct lx_emitter *emitter)
{
    const struct lx_emitter_kind *kind = lx_emitter_kind(emitter);
    return !emitter->facets && !kind->has_side && !kind->bulges;
}

/* Whether its ends are round, beyond a side. */
static inline bool lx_is_capsule(const struct lx_emitter *emitter)
{
    return lx_emitter_kind(emitter)->has_side && lx_emitter_kind(emitter)->bulges;
}

/* The rest as emitter_kind.h asks for it. */
double lx_round_extent(const struct lx_emitter *emitter, const double place_mm[3], const double direction[3],
                       double *nearest);
void lx_round_farthest(const struct lx_emitter *emitter, const double towards[3], double place_mm[3]);
bool lx_round_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm);
lx_bounded lx_disk_irradiance(const struct lx_emitter *disk, lx_bounded3 place_mm, lx_bounded3 normal);
lx_bounded lx_ball_irradiance(const struct lx_emitter *ball, lx_bounded3 place_mm, lx_bounded3 normal);
lx_bounded lx_cylinder_irradiance(const struct lx_emitter *cylinder, lx_bounded3 place_mm, lx_bounded3 normal);
int lx_disk_cut(const struct lx_emitter *disk, unsigned parts, struct lx_emitters *emitters);
int lx_ball_cut(const struct lx_emitter *ball, unsigned parts, struct lx_emitters *emitters);
int lx_cylinder_cut(const struct lx_emitter *cylinder, unsigned parts, struct lx_emitters *emitters);

#endif

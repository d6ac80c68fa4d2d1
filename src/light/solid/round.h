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

#include "../emitter.h"

/* As lx_extended_touches(), _irradiance(), _cut() for LX_DISK, LX_BALL, LX_CYLINDER. */
bool lx_round_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm);
/* for a radiance of 1 */
lx_bounded lx_round_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal);
int lx_round_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters);

#endif

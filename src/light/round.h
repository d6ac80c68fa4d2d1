/* SPDX-License-Identifier: MIT */
/*
 * Disks, balls and cylinders.  A circle is seen under an elliptic cone; in the cone's own frame, z along its axis,
 * its contour is r = (p cos t, q sin t, 1), and all parts of the contour integral are elementary:
 *
 *     N.(r x r') = -Nx q cos t - Ny p sin t + Nz p q,      |r|^2 = 1 + p^2 cos^2 t + q^2 sin^2 t
 *
 * For a disk of radius R whose plane is at the distance h from the element, the foot of the perpendicular rho away
 * from its centre: X = rho^2 + h^2 - R^2, W = sqrt(X^2 + 4 h^2 R^2), p = 2 h R/(W + X), q^2 = 2 R^2/(W + X); a ball
 * has p = q = R/sqrt(d^2 - R^2).
 */
#ifndef LX_LIGHT_ROUND_H
#define LX_LIGHT_ROUND_H

#include "extended.h"

/* As lx_extended_touches(), _irradiance(), _cut() for LX_DISK, LX_BALL, LX_CYLINDER. */
bool lx_round_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm);
/* for a radiance of 1 */
lx_bounded lx_round_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal);
int lx_round_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters);

#endif

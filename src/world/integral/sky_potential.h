/* SPDX-License-Identifier: MIT */
/*
 * Potentials of skies: what is seen of a sky lights an element as an integral along its borders tells.
 *
 * About a pole p a direction L has the angle chi and the longitude phi, dw = sin(chi) dchi dphi, and by Green's theorem
 *
 *     integral over S of K N.L dw = integral along the border of S of N.G dphi,
 *     G = integral from 0 to chi of K L sin(chi') dchi'
 *
 * for a kernel K: the luminance of a sky times what a pane of glass lets through.  The border runs counter-clockwise
 * about S as seen from outside.  G is found once, as polynomials on patches of (chi, phi), which are quartered until
 * their last terms are small; the pole is the sun, where the luminance has a corner, or the pane's axis.
 */
#ifndef LX_WORLD_SKY_POTENTIAL_H
#define LX_WORLD_SKY_POTENTIAL_H

#include "../../light/sky/luminance.h"
#include "../../surface/pane.h"

struct lx_sky_potential;

/* `sky`: NULL: a radiance of 1 from everywhere, where there is glass; `opening`: NULL: in the open.  Only ways upwards
 * where there is a sky, and outwards through its glass, count.  NULL: memory ran out. */
struct lx_sky_potential *lx_sky_potential_new(const struct lx_sky *sky, const struct lx_glass_pane *opening);
void lx_sky_potential_free(struct lx_sky_potential *potential);

/* Whether it may be used: not where too many patches would be needed, or the sun is on the horizon. */
bool lx_sky_potential_is_good(const struct lx_sky_potential *potential);

/* Whether it is that of this sky (by its address) through this opening, too. */
bool lx_sky_potential_is_of(const struct lx_sky_potential *potential, const struct lx_sky *sky,
                            const struct lx_glass_pane *opening);

/* About what the whole sky gives to a plane that faces it. */
double lx_sky_potential_whole(const struct lx_sky_potential *potential);

/* The pole. */
const double *lx_sky_potential_pole(const struct lx_sky_potential *potential);

/* N.G dphi for a step along a border at a direction of any length, and how far that may be off. */
lx_bounded lx_sky_potential_step(const struct lx_sky_potential *potential, const double towards[3],
                                 const double step[3], const double normal[3]);

#endif

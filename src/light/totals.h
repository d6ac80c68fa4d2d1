/* SPDX-License-Identifier: MIT */
/*
 * What the emitters of one light are together, as it is shown to people: the flux that it gives off in all, where it
 * stands and which way it shines.  A light is lowered for it with `is_whole`, so that parts cost nothing.
 */
#ifndef LX_LIGHT_TOTALS_H
#define LX_LIGHT_TOTALS_H

#include "emitter.h"

/* The flux to all sides in W or lm, to 1e-12; NaN where there is none: of uniform and of parallel light. */
double lx_emitters_flux(const struct lx_emitters *emitters);

/*
 * The intensity of those that shine the same in all directions, or along lx_emitters_direction(), from far away: the
 * sum of those of points, of a flat source its radiance times its area.  NaN where there is no such: of uniform and
 * parallel light, of bodies but a ball, of points with axes of their own.
 */
double lx_emitters_intensity(const struct lx_emitters *emitters);

/* The middle of the points, of the areas that shine; false of uniform and of parallel light. */
bool lx_emitters_place(const struct lx_emitters *emitters, double place_mm[3]);

/* The unit direction that all of them shine in: of parallel light, along the axis of a profile, of a plane's normal,
 * the front's where both sides shine;
 * false where there is no such: of uniform light, isotropic points, bodies. */
bool lx_emitters_direction(const struct lx_emitters *emitters, double direction[3]);

#endif

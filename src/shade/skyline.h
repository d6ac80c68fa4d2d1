/* SPDX-License-Identifier: MIT */
/*
 * Skylines: the irradiance of what obstacles leave of a source, in closed form, in float64 without a bound, for
 * pictures.
 *
 * What is seen of a source is bounded by pieces of great circles, the edges of polygons, and of circles, the outlines
 * of balls.  By the law 1/r^2 the irradiance is the sum over these pieces (light/extended.h): of each curve those
 * pieces count that lie on the source and behind no other obstacle.
 */
#ifndef LX_SHADE_SKYLINE_H
#define LX_SHADE_SKYLINE_H

#include "occlusion.h"

/* For a radiance of 1.  False: it is not known, as there are other laws, sources or obstacles, or too many, or one
 * is not wholly before the source. */
bool lx_skyline_irradiance(const struct lx_emitter *emitter, const double normal[3],
                           const struct lx_occlusion *occlusion, double *irradiance);

#endif

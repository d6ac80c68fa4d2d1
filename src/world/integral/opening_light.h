/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by a flat side of an opening that an element sees all of, over the area of the opening, line by line.
 * Along a line the integrand is smooth between the lines of the luminaire's table and the element's horizon, whose
 * crossings are known, so few places of Gauss's rule do; across the lines an adaptive rule goes.
 */
#ifndef LX_WORLD_OPENING_LIGHT_H
#define LX_WORLD_OPENING_LIGHT_H

#include "../../base/rows.h"
#include "../../light/emitter.h"
#include "../element.h"

/* From this tolerance on, relative to the light, the rule is exact enough. */
#define LX_OPENING_TOLERANCE 1e-8

/* Whether there is such a rule for it: rectangles and disks. */
bool lx_opening_is_flat(const struct lx_emitter *emitter);

/* Whether the opening lies in an element's own plane, or below that, and sends it nothing but what roundings tell. */
bool lx_opening_is_level(const struct lx_emitter *emitter, const struct lx_element *element, lx_bounded *light);

/* Whether a place is so far from it, and from its plane, that the bound is one. */
bool lx_opening_is_away(const struct lx_emitter *emitter, const double place_mm[3]);

/*
 * The irradiance by such an opening on an element, for a radiance of 1, to `tolerance` of it or of what is `known`
 * beside, with the bound of the integral.  0 where the place is behind it; from its plane openings are seen as well.
 * Adds to `parts` how many places of the opening were looked at.
 */
lx_bounded lx_opening_light(const struct lx_emitter *emitter, const struct lx_element *element, double tolerance,
                            double known, const struct lx_asking *asking, size_t *parts);

#endif

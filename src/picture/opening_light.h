/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by a flat side of an opening that an element sees all of, for pictures: over the area of the opening,
 * line by line.  Along a line the integrand is smooth between the lines of the luminaire's table and the element's
 * horizon, whose crossings are known, so few places of Gauss's rule do; across the lines an adaptive rule goes.
 */
#ifndef LX_PICTURE_OPENING_LIGHT_H
#define LX_PICTURE_OPENING_LIGHT_H

#include "../base/rows.h"
#include "../kernel/rules.h"
#include "../light/emitter.h"

/* From this tolerance on, relative to the light, the rule is exact enough. */
#define LX_OPENING_TOLERANCE 1e-8

/* Whether there is such a rule for it: rectangles and disks. */
bool lx_opening_is_flat(const struct lx_emitter *emitter);

/*
 * The irradiance by such an opening at a place, for a radiance of 1, to `allowed`.  0 where the place is behind it;
 * from its plane openings are seen as well.
 */
double lx_opening_light(const struct lx_emitter *emitter, const struct lx_gauss_rules *rules, const double place_mm[3],
                        const double normal[3], double allowed, const struct lx_asking *asking);

#endif

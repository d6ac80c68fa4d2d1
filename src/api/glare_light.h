/* SPDX-License-Identifier: MIT */
/* Emitters as an eye sees them that takes them for one source: where that is, how far and how large. */
#ifndef LX_API_GLARE_LIGHT_H
#define LX_API_GLARE_LIGHT_H

#include "../base/bounded.h"
#include "../light/emitter.h"

struct lx_light_seen {
    double towards[3], distance_m; /* the unit direction to its middle; a distance of 0: it has none */
    double area_m2;                /* that it shows; 0: it has none */
    lx_bounded radiance;           /* of a Lambertian source; else 0 */
    bool is_uniform;               /* it comes from everywhere */
};

/* Looks at the emitters of a light, or of one place of its array, that were lowered with `is_whole`. */
void lx_see_emitters(const struct lx_emitters *emitters, const double eye_mm[3], struct lx_light_seen *seen);

#endif

/* SPDX-License-Identifier: MIT */
/* A light as an eye sees it that takes it for one source: where it is, how far and how large. */
#ifndef LX_API_GLARE_LIGHT_H
#define LX_API_GLARE_LIGHT_H

#include "../base/bounded.h"
#include "../parameter/table.h"

struct lx_light_seen {
    double towards[3], distance_m; /* the unit direction to its middle; a distance of 0: it has none */
    double area_m2;                /* that it shows; 0: it has none */
    lx_bounded radiance;           /* of a Lambertian source; else 0 */
    bool is_uniform;               /* it comes from everywhere */
};

/* Looks at an item of the list `lights`; false: memory ran out. */
bool lx_see_light(const struct lx_item *item, const double eye_mm[3], struct lx_light_seen *seen);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * When the sun's middle is seen from an element on a day.  The sky around a stretch of the sun's way, a small disk, is
 * asked of all that may hide it: where that hides all of it or nothing the stretch is done, else it is halved, down to
 * LX_SUN_STEP_S, and where the sun is seen at one end of such a step alone the time between is found by bisection.
 * Nothing longer than a step can be overlooked.
 */
#ifndef LX_WORLD_SUNLIT_H
#define LX_WORLD_SUNLIT_H

#include <luxel/sunlight.h>

#include "../base/rows.h"
#include "../light/sky/site.h"
#include "reference.h"

#define LX_DAY_S 86400.0
#define LX_SUN_STEP_S 1.0
#define LX_SUN_TIME_S 1e-3 /* to which ends are found */

/* A day of a site: seconds count from its midnight. */
struct lx_sun_day {
    const struct lx_sun_site *site;
    double midnight;  /* the Julian date of UTC */
    double least_deg; /* the altitude above which the sun counts */
};

struct lx_sun_spans {
    luxel_sun_span *items;
    size_t count, capacity;
};

/*
 * Appends the times at which the sun is above the least altitude and, of an element, before it and hidden by nothing,
 * in their order; they touch nowhere.  `element` NULL: nothing hides it.  0, or -1 when memory ran out; less is
 * appended where the work is to stop.
 */
int lx_find_sunlit(const struct lx_prepared *prepared, const struct lx_element *element, const struct lx_sun_day *day,
                   const struct lx_asking *asking, struct lx_sun_spans *spans);

#endif

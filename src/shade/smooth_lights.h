/* SPDX-License-Identifier: MIT */
/*
 * Lights as lx_bound_smooth() takes them: those of a plan, and the parts that flat extended sources are cut into so
 * that their highlights can be bounded.  The places of a part are points with the cosine pattern of its face; so it is
 * as one that may stand anywhere within some distance of its middle, and that shines with the part's whole area.
 */
#ifndef LX_SHADE_SMOOTH_LIGHTS_H
#define LX_SHADE_SMOOTH_LIGHTS_H

#include <stdbool.h>

#include <luxel/status.h>

#include "../base/rows.h"
#include "lights.h"

struct lx_planned_surface;

/* LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED.  Release with lx_smooth_lights_clear() in any case. */
luxel_status lx_smooth_lights_make(const struct lx_lights *lights, const struct lx_asking *asking,
                                   struct lx_smooth_lights *made);
void lx_smooth_lights_clear(struct lx_smooth_lights *lights);

/* Whether the highlights of all extended sources over a surface, of which there are some, are of flat ones by the law
 * 1/r^2 that are worth cutting into parts; and these parts: 0, or -1 when memory ran out. */
bool lx_has_smooth_highlights(const struct lx_planned_surface *surface);
int lx_smooth_parts_make(const struct lx_planned_surface *surface, struct lx_smooth_lights *made);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Lights as lx_bound_smooth() takes them: those of a plan, and the parts that extended sources are cut into so that
 * their highlights can be bounded.  The places of a flat part are points with the cosine pattern of its face; so it is
 * as one that may stand anywhere within some distance of its middle, and that shines with the part's whole area.  Those
 * of a ball and of a cylinder's side are the ones that are seen, which depends on from where (round_view.h): they are
 * placed anew for each square, and what they move by within it adds to that distance.
 */
#ifndef LX_PICTURE_SMOOTH_LIGHTS_H
#define LX_PICTURE_SMOOTH_LIGHTS_H

#include <stdbool.h>

#include <luxel/status.h>

#include "../../base/rows.h"
#include "../lights.h"
#include "smooth_plan.h"

struct lx_planned_surface;

/* LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED.  Release with lx_smooth_lights_clear() in any case. */
luxel_status lx_smooth_lights_make(const struct lx_lights *lights, const struct lx_asking *asking,
                                   struct lx_smooth_lights *made);
void lx_smooth_lights_clear(struct lx_smooth_lights *lights);

/* The luminaires among lights, `count` of them in `which`, as if they shone evenly: 0, or -1 when memory ran out. */
int lx_smooth_luminaires_make(const struct lx_lights *lights, const uint32_t *which, size_t count,
                              struct lx_smooth_lights *made);

/* Whether the highlights of all extended sources over a surface, of which there are some, are by the law 1/r^2, and few
 * enough to be cut into parts. */
bool lx_has_smooth_highlights(const struct lx_planned_surface *surface);

/* The parts of what is flat, and of what is round: 0, or -1 when memory ran out.  Clear both in any case. */
int lx_smooth_parts_make(const struct lx_planned_surface *surface, struct lx_smooth_lights *flat,
                         struct lx_round_parts *round);
void lx_round_parts_clear(struct lx_round_parts *round);

/* Room for so many round parts as lights, 0 or -1; and those of these lights that a square sees.  Where some places
 * around it may not be outside of the body they are so near that there is no bound. */
int lx_round_lights_make(size_t count, struct lx_smooth_lights *made);
void lx_round_lights_place(const struct lx_round_parts *round, const struct lx_vicinity *at,
                           struct lx_smooth_lights *made);

#endif

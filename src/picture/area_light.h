/* SPDX-License-Identifier: MIT */
/*
 * Area lights: extended sources for pictures, what the kernels need of one, as seen from a surface's anchor.
 */
#ifndef LX_PICTURE_AREA_LIGHT_H
#define LX_PICTURE_AREA_LIGHT_H

#include <luxel/status.h>

#include "../base/rows.h"
#include "../kernel/kernel.h"

struct lx_area_light_law lx_law_of(const struct lx_emitter *emitter);

/* Sets the rules with few places where those do, no place that is lit being nearer to the area light than that (mm).
 * LUXEL_OK or LUXEL_ERROR_MEMORY. */
luxel_status lx_area_light_set_nodes(const struct lx_gauss_rules *rules, double nearest, struct lx_area_light *lamp);
void lx_area_light_forget_nodes(struct lx_area_light *lamp);

/* LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED.  Release with lx_area_light_clear() in any case. */
luxel_status lx_area_light_make(const struct lx_emitter *emitter, const struct lx_shape *lit,
                                const struct lx_asking *asking, struct lx_area_light *lamp);
void lx_area_light_clear(struct lx_area_light *lamp);
/* Adds what the kernels in float32 need of facets.  LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED. */
luxel_status lx_area_light_make_single(struct lx_area_light *lamp, const struct lx_asking *asking);

#endif

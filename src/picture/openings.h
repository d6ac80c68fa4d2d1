/* SPDX-License-Identifier: MIT */
/* Luminous openings of luminaires in pictures: their plan over a surface, and their light on its elements. */
#ifndef LX_PICTURE_OPENINGS_H
#define LX_PICTURE_OPENINGS_H

#include "shader_memory.h"

/* Openings of luminaires are apart from the area lights, the other emitters of some size. */
static inline bool lx_is_area_light(const struct lx_emitter *emitter)
{
    return lx_is_extended(emitter) && !lx_is_opening(emitter);
}

/* LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED; lx_openings_clear() is due in any case. */
luxel_status lx_plan_openings(struct lx_plan *plan, struct lx_control *control, struct lx_planned_surface *surface);
void lx_openings_clear(struct lx_planned_surface *surface);

/* Adds the light of the openings over the gathered block of a surface's elements. */
void lx_light_by_openings(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                          struct lx_shader_memory *memory, size_t count, const struct lx_asking *asking);

#endif

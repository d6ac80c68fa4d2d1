/* SPDX-License-Identifier: MIT */
/* The surfaces that may stand between a surface and a light without size, by the balls around them. */
#include "blockers.h"

#include "../base/memory.h"
#include "../light/solid/extended.h"
#include "../world/among.h"
#include "../world/blocking.h"

int lx_find_blockers(const struct lx_plan *plan, struct lx_planned_surface *lit, const struct lx_emitter *emitter)
{
    const double *anchor = lit->shape.anchor_mm;
    const struct lx_ball from = lx_ball_from(&plan->balls[lit - plan->surfaces], anchor);
    const bool endless = lx_is_endless(emitter);
    struct lx_ball towards = {.radius = 0};
    struct lx_origin light = {.endless = endless};
    int count = 0;
    lx_emitter_origin(emitter, light.at);
    for (int i = 0; i < 3; i++)
        towards.center[i] = endless ? light.at[i] : light.at[i] - anchor[i];
    struct lx_found found;
    const bool is_found = lx_among_balls(plan->prepared, anchor, &from, &towards, endless, &found);
    const size_t all = lx_found_count(&found, is_found, plan->surface_count);
    for (size_t i = 0; i < all; i++) {
        const uint32_t s = (uint32_t)lx_found_at(&found, is_found, i);
        const struct lx_planned_surface *other = &plan->surfaces[s];
        const struct lx_ball ball = lx_ball_from(&plan->balls[s], anchor);
        if (!lx_may_block(&ball, &from, &towards, endless) || !lx_may_hide(&other->shape, other == lit) ||
            lx_are_before_wall(&other->shape, &lit->shape, &light))
            continue;
        size_t needed = lit->blocker_count + (size_t)count + 1;
        if (lx_reserve(&lit->blockers, &lit->blocker_capacity, needed, sizeof *lit->blockers))
            return -1;
        lit->blockers[lit->blocker_count + (size_t)count++] = s;
    }
    return count;
}

/* SPDX-License-Identifier: MIT */
/* The part of preparing a light that all lights standing at a place share. */
#include <string.h>

#include "placed.h"

const char *const lx_attenuation_names[] = {"inverse-square", "practical", "none", NULL};

lx_bounded3 lx_placed_axis(const struct lx_table *table, const void *parameters, const struct lx_placed *placed)
{
    if (lx_is_given(table, parameters, "aim"))
        return lx_unit3(lx_sub3(lx_exact3(placed->aim_mm), lx_exact3(placed->position_mm)));
    return lx_unit3(lx_exact3(placed->axis));
}

struct lx_emitter lx_placed_emitter(const struct lx_placed *placed, struct lx_profile profile)
{
    struct lx_emitter emitter = {
        .type = LX_POINT,
        .strength = placed->intensity,
        .attenuation = (enum lx_attenuation)placed->attenuation,
        .k_mm = placed->k_mm,
        .profile = profile,
    };
    memcpy(emitter.position_mm, placed->position_mm, sizeof emitter.position_mm);
    return emitter;
}

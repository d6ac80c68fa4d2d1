/* SPDX-License-Identifier: MIT */
/* The part of preparing a light that all lights standing at a place or at many share. */
#include <string.h>

#include "placed.h"

const char *const lx_attenuation_names[] = {"inverse-square", "practical", "none", NULL};

struct lx_emitter lx_shining_emitter(const struct lx_shining *shining, const double position_mm[3], double intensity,
                                     struct lx_profile profile)
{
    struct lx_emitter emitter = {
        .type = LX_POINT,
        .strength = intensity,
        .attenuation = (enum lx_attenuation)shining->attenuation,
        .k_mm = shining->k_mm,
        .profile = profile,
    };
    memcpy(emitter.position_mm, position_mm, sizeof emitter.position_mm);
    return emitter;
}

lx_bounded3 lx_placed_axis(const struct lx_table *table, const void *parameters, const struct lx_placed *placed)
{
    const struct lx_shining *shining = &placed->shining;
    if (lx_is_given(table, parameters, "aim"))
        return lx_unit3(lx_sub3(lx_exact3(shining->aim_mm), lx_exact3(placed->position_mm)));
    return lx_unit3(lx_exact3(shining->axis));
}

struct lx_emitter lx_placed_emitter(const struct lx_placed *placed, struct lx_profile profile)
{
    return lx_shining_emitter(&placed->shining, placed->position_mm, placed->intensity, profile);
}

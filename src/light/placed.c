/* SPDX-License-Identifier: MIT */
/* The part of preparing a light that all lights standing at a place or at many share. */
#include "placed.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "../parameter/check.h"
#include "solid/solid_angle.h"

struct lx_emitter lx_shining_emitter(const struct lx_shining *shining, const double position_mm[3], double intensity,
                                     struct lx_profile profile)
{
    struct lx_emitter emitter = {
        .type = LX_POINT,
        .strength = intensity,
        .profile = profile,
    };
    lx_law_set(&shining->law, &emitter);
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

struct lx_emitter lx_placed_emitter(const struct lx_table *table, const void *parameters,
                                    const struct lx_placed *placed, struct lx_profile profile)
{
    struct lx_emitter emitter = lx_shining_emitter(&placed->shining, placed->position_mm, placed->intensity, profile);
    if (lx_is_given(table, parameters, "power")) {
        emitter.strength = placed->power / lx_profile_solid_angle(&profile);
        emitter.strength_error = emitter.strength * (LX_SOLID_ANGLE_ERROR + DBL_EPSILON);
    }
    return emitter;
}

void lx_check_power(const struct lx_check *check, const struct lx_emitter *emitter)
{
    if (isfinite(emitter->strength))
        return;
    const bool is_dark = !(lx_profile_solid_angle(&emitter->profile) > 0);
    lx_check_report(check, "power", LX_ALL_OF_IT, is_dark ? LX_MSG_POWER_NOWHERE : LX_MSG_POWER_TOO_LARGE, NULL);
    if (is_dark)
        lx_check_hint(check, LX_MSG_HINT_WIDER_CONE, NULL);
}

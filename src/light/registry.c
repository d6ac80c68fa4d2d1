/* SPDX-License-Identifier: MIT */
/* The kinds of lights, each listed once. */
#include "light.h"

extern const struct lx_light_kind lx_ambient_kind, lx_point_kind, lx_points_kind, lx_distant_kind, lx_spot_kind,
    lx_planar_kind, lx_volume_kind, lx_luminaire_kind, lx_sun_kind, lx_sky_kind;

const struct lx_variant *const lx_light_variants[] = {
    &lx_point_kind.variant,     &lx_points_kind.variant,  &lx_spot_kind.variant,
    &lx_luminaire_kind.variant, &lx_planar_kind.variant,  &lx_volume_kind.variant,
    &lx_distant_kind.variant,   &lx_ambient_kind.variant, &lx_sun_kind.variant,
    &lx_sky_kind.variant,       NULL,
};

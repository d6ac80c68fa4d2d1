/* SPDX-License-Identifier: MIT */
/* The kinds of surfaces, each listed once. */
#include "surface.h"

extern const struct lx_surface_kind lx_sphere_kind;

const struct lx_variant *const lx_surface_variants[] = {
    &lx_sphere_kind.variant,
    NULL,
};

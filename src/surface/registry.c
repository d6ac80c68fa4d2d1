/* SPDX-License-Identifier: MIT */
/* The kinds of surfaces, each listed once. */
#include "surface.h"

extern const struct lx_surface_kind lx_sphere_kind, lx_plate_kind;
extern const struct lx_surface_kind lx_disk_kind, lx_cylinder_kind, lx_mesh_kind, lx_room_kind, lx_box_kind;

const struct lx_variant *const lx_surface_variants[] = {
    &lx_sphere_kind.variant,
    &lx_plate_kind.variant,
    &lx_disk_kind.variant,
    &lx_cylinder_kind.variant,
    &lx_room_kind.variant,
    &lx_box_kind.variant,
    &lx_mesh_kind.variant,
    NULL,
};

/* SPDX-License-Identifier: MIT */
/* Cuboids: what rooms and boxes share, six rectangles on three axes, which are named by the one that is up. */
#ifndef LX_SURFACE_CUBOID_H
#define LX_SURFACE_CUBOID_H

#include <stdbool.h>

#include "../material/material.h"
#include "authored.h"
#include "shape.h"

/* Sides in the order of their names: left, right, the lowest and the highest along the axis that is up, back, front. */
enum { LX_CUBOID_SIDES = 6 };

/* Which axis is up, as a list of choices. */
extern const char *const lx_cuboid_ups[];

/* What `materials` may give a side on its own, and a row of that table. */
struct lx_cuboid_materials {
    uint64_t given;
    struct lx_material sides[LX_CUBOID_SIDES];
};

#define LX_CUBOID_MATERIAL(side_, name_, label_, meaning_)                                                             \
    {                                                                                                                  \
        .name = name_, .label = label_, .type = LX_GROUP,                                                              \
        .offset = offsetof(struct lx_cuboid_materials, sides[side_]), .group = &lx_material_table, .meaning = meaning_ \
    }

struct lx_cuboid {
    double center_mm[3], size_mm[3];
    double axes[3][3]; /* unit: where its own x, y and z point to */
    int up;            /* among the choices */
};

/* Side i as a user would write it, which looks into the cuboid or out of it. */
void lx_cuboid_side(const struct lx_cuboid *cuboid, unsigned i, bool inwards, struct lx_plate_parameters *plate);

/* Its middle, its axes and, in `own`, the halves of its sizes along them. */
struct lx_shape lx_cuboid_shape(const struct lx_cuboid *cuboid);

#endif

/* SPDX-License-Identifier: MIT */
/* Where the sides of cuboids lie. */
#include "cuboid.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"

enum up { UP_Y, UP_Z };

const char *const lx_cuboid_ups[] = {"y", "z", NULL};

/* On which axis each of them stands, and on which side of the middle, by what is up. */
static const struct {
    int axis, side;
} sides[][LX_CUBOID_SIDES] = {
    [UP_Y] = {{0, -1}, {0, 1}, {1, -1}, {1, 1}, {2, -1}, {2, 1}},
    [UP_Z] = {{0, -1}, {0, 1}, {2, -1}, {2, 1}, {1, 1}, {1, -1}},
};

/* Adding 0 leaves no -0. */
void lx_cuboid_side(const struct lx_cuboid *cuboid, unsigned i, bool inwards, struct lx_plate_parameters *plate)
{
    const int axis = sides[cuboid->up][i].axis, side = sides[cuboid->up][i].side;
    const int upward = axis == 1 ? 2 : 1, across = 3 - axis - upward;
    *plate = (struct lx_plate_parameters){.given = UINT64_MAX,
                                          .size_mm = {cuboid->size_mm[across], cuboid->size_mm[upward]}};
    for (int k = 0; k < 3; k++) {
        plate->center_mm[k] = cuboid->center_mm[k] + side * cuboid->size_mm[axis] / 2 * cuboid->axes[axis][k];
        plate->axis[k] = (inwards ? -side : side) * cuboid->axes[axis][k] + 0.0;
        plate->up[k] = cuboid->axes[upward][k] + 0.0;
    }
}

struct lx_shape lx_cuboid_shape(const struct lx_cuboid *cuboid)
{
    struct lx_shape shape = {.type = LX_GENERAL};
    memcpy(shape.anchor_mm, cuboid->center_mm, sizeof shape.anchor_mm);
    memcpy(shape.across, cuboid->axes[0], sizeof shape.across);
    memcpy(shape.upward, cuboid->axes[1], sizeof shape.upward);
    memcpy(shape.axis, cuboid->axes[2], sizeof shape.axis);
    shape.radius_mm = sqrt(lx_dot(cuboid->size_mm, cuboid->size_mm)) / 2;
    for (int i = 0; i < 3; i++)
        shape.own[i] = cuboid->size_mm[i] / 2;
    return shape;
}

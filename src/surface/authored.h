/* SPDX-License-Identifier: MIT */
/* What users write of spheres and rectangles.  For the kinds themselves and for tests that make surfaces of them. */
#ifndef LX_SURFACE_AUTHORED_H
#define LX_SURFACE_AUTHORED_H

#include <stdbool.h>
#include <stdint.h>

struct lx_sphere_parameters {
    uint64_t given;
    double center_mm[3];
    double radius_mm;
    bool inside; /* seen and lit there (inside.c) */
};

/* How a rectangle lies: base/pose.h. */
struct lx_plate_parameters {
    uint64_t given;
    double center_mm[3];
    double size_mm[2];
    double axis[3], up[3];
    bool mirror;
};

#endif

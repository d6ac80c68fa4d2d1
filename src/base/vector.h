/* SPDX-License-Identifier: MIT */
/* Vectors of three plain float64 numbers, and places around a square. */
#ifndef LX_BASE_VECTOR_H
#define LX_BASE_VECTOR_H

#include <math.h>
#include <stdbool.h>

static inline double lx_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The product of two vectors, which is neither of them. */
static inline void lx_cross(const double a[3], const double b[3], double product[3])
{
    for (int i = 0; i < 3; i++)
        product[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* The angle between two vectors of any lengths. */
static inline double lx_angle_between(const double a[3], const double b[3])
{
    double cross[3];
    lx_cross(a, b, cross);
    return atan2(sqrt(lx_dot(cross, cross)), lx_dot(a, b));
}

/* The length of a vector, which becomes of unit length unless it is 0. */
static inline double lx_normalize(double a[3])
{
    double length = sqrt(lx_dot(a, a));
    if (!(length > 1e-140 && length < 1e140)) /* squares out of the range */
        length = hypot(hypot(a[0], a[1]), a[2]);
    for (int i = 0; i < 3 && length > 0; i++)
        a[i] /= length;
    return length;
}

/* Two unit vectors at right angles to a unit vector and to each other. */
static inline void lx_around_axis(const double axis[3], double across[3], double upward[3])
{
    const bool is_along_x = fabs(axis[0]) > 0.7;
    const double unit[3] = {is_along_x ? 0.0 : 1.0, is_along_x ? 1.0 : 0.0, 0};
    lx_cross(axis, unit, across);
    lx_normalize(across);
    lx_cross(axis, across, upward);
}

/* Place i of `count` around the square from (-1, -1) to (1, 1), counter-clockwise from its lower left corner; the
 * corners are among them if their number is a multiple of 4. */
static inline void lx_around_square(int i, int count, double at[2])
{
    int side = 4 * i / count;
    double along = 2 * (4.0 * i / count - side) - 1;
    at[0] = side == 0 ? along : side == 1 ? 1 : side == 2 ? -along : -1;
    at[1] = side == 0 ? -1 : side == 1 ? along : side == 2 ? 1 : -along;
}

#endif

/* SPDX-License-Identifier: MIT */
/* Vectors of space. */
#include "geometry.h"

#include <math.h>

gboolean app_unit(const double vector[3], double unit[3])
{
    const double length = hypot(hypot(vector[0], vector[1]), vector[2]);
    for (int k = 0; k < 3; k++)
        unit[k] = length > 0 && isfinite(length) ? vector[k] / length : vector[k];
    return length > 0 && isfinite(length);
}

void app_cross(const double a[3], const double b[3], double product[3])
{
    for (int k = 0; k < 3; k++)
        product[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

void app_basis(const double axis[3], const double up[3], double u[3], double v[3])
{
    double n[3] = {axis[0], axis[1], axis[2]}, right[3];
    const double other[3] = {0, 0, axis[1] > 0 ? -1 : 1};
    app_unit(n, n);
    app_cross(up, n, right);
    if (hypot(hypot(right[0], right[1]), right[2]) < 1e-9)
        app_cross(other, n, right);
    app_unit(right, u);
    app_cross(n, u, v);
}

/* SPDX-License-Identifier: MIT */
/* The exchange of light between floor, walls and ceiling of a room, each taken as evenly lit. */
#include "photometry_cavity.h"

#include <math.h>

static const double PI = 3.141592653589793;

/* The form factor of two rectangles, x by y, opposite each other at the distance 1. */
static double opposite_factor(double x, double y)
{
    double p = hypot(1, x), q = hypot(1, y);
    double sum = log(p * q / sqrt(1 + x * x + y * y)) + x * q * atan(x / q) + y * p * atan(y / p);
    return 2 / (PI * x * y) * (sum - x * atan(x) - y * atan(y));
}

void lx_cavity_light(double x, double y, const double flux[LX_CAVITY_PARTS], const double reflectance[LX_CAVITY_PARTS],
                     double light[LX_CAVITY_PARTS])
{
    double floor_area = x * y, wall_area = 2 * (x + y);
    double across = opposite_factor(x, y), to_walls = 1 - across, from_walls = to_walls * floor_area / wall_area;
    const double factors[LX_CAVITY_PARTS][LX_CAVITY_PARTS] = {
        [LX_FLOOR] = {0, to_walls, across},
        [LX_WALLS] = {from_walls, 1 - 2 * from_walls, from_walls},
        [LX_CEILING] = {across, to_walls, 0},
    };
    const double areas[LX_CAVITY_PARTS] = {floor_area, wall_area, floor_area};
    double direct[LX_CAVITY_PARTS], change = 1;
    for (int i = 0; i < LX_CAVITY_PARTS; i++)
        light[i] = direct[i] = flux[i] / areas[i];
    for (int round = 0; round < 1000 && change > 1e-15; round++) { /* at most 0.8 of the change is left by each */
        change = 0;
        for (int i = 0; i < LX_CAVITY_PARTS; i++) {
            double next = direct[i];
            for (int j = 0; j < LX_CAVITY_PARTS; j++)
                next += factors[i][j] * reflectance[j] * light[j];
            change = fmax(change, fabs(next - light[i]) / fmax(next, 1e-300));
            light[i] = next;
        }
    }
}

/* SPDX-License-Identifier: MIT */
/*
 * Half axes, areas and distances of openings that are not round.  Perimeters and areas are Carlson's symmetric elliptic
 * integral R_G: 8 R_G(0, a^2, b^2) and 4 pi R_G(a^2 b^2, b^2 c^2, c^2 a^2) (DLMF 19.30.5, 19.33.1), by duplication
 * (DLMF 19.36).
 */
#include "elliptic.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "../../base/vector.h"
#include "../distribution.h"
#include "extended.h"

/* ---- directions ---- */

void lx_elliptic_ways(const struct lx_emitter *emitter, double ways[3][3])
{
    lx_values3(emitter->profile.luminaire->c0, ways[0]);
    lx_values3(emitter->profile.luminaire->across, ways[1]);
    lx_values3(emitter->profile.luminaire->axis, ways[2]);
}

/* Which of the three the normal of a disk or the axis of a cylinder is. */
static int along_of(const struct lx_emitter *emitter, double ways[3][3])
{
    double axis[3];
    int along = 0;
    lx_values3(emitter->axis, axis);
    for (int i = 1; i < 3; i++)
        along = fabs(lx_dot(axis, ways[i])) > fabs(lx_dot(axis, ways[along])) ? i : along;
    return along;
}

void lx_half_axes(const struct lx_emitter *emitter, double first[3], double second[3])
{
    double axis[3], ways[3][3], radii[2] = {emitter->radius_mm, emitter->radius_mm};
    lx_values3(emitter->axis, axis);
    if (lx_is_elliptic(emitter)) {
        lx_elliptic_ways(emitter, ways);
        const int along = along_of(emitter, ways), one = (along + 1) % 3, other = (along + 2) % 3;
        radii[0] = emitter->radii_mm[one], radii[1] = emitter->radii_mm[other];
        memcpy(first, ways[one], sizeof ways[one]);
        memcpy(second, ways[other], sizeof ways[other]);
    } else {
        const double aside[3] = {fabs(axis[0]) <= 0.5, fabs(axis[0]) > 0.5, 0};
        lx_cross(axis, aside, first);
        lx_normalize(first);
        lx_cross(axis, first, second);
    }
    for (int k = 0; k < 3; k++)
        first[k] *= radii[0], second[k] *= radii[1];
}

static double error_norm(lx_bounded3 a)
{
    return hypot(hypot(a.x.error, a.y.error), a.z.error);
}

double lx_elliptic_error(const struct lx_emitter *emitter)
{
    const struct lx_pointed *luminaire = emitter->profile.luminaire;
    return fmax(fmax(error_norm(luminaire->axis), error_norm(luminaire->c0)), error_norm(luminaire->across));
}

/* ---- areas ---- */

/* The rest of the series, where all three are this near to each other, is below a rounding. */
static const double NEAR = 1e-3;

static double carlson_f(double x, double y, double z)
{
    for (;;) {
        const double mean = (x + y + z) / 3, a = 1 - x / mean, b = 1 - y / mean, c = -a - b;
        if (fmax(fmax(fabs(a), fabs(b)), fabs(c)) < NEAR) {
            const double e2 = a * b - c * c, e3 = a * b * c;
            return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / sqrt(mean);
        }
        const double more = sqrt(x * y) + sqrt(y * z) + sqrt(z * x);
        x = (x + more) / 4, y = (y + more) / 4, z = (z + more) / 4;
    }
}

static double carlson_d(double x, double y, double z)
{
    double sum = 0, scale = 1;
    for (;;) {
        const double mean = (x + y + 3 * z) / 5, a = 1 - x / mean, b = 1 - y / mean, c = -(a + b) / 3;
        if (fmax(fmax(fabs(a), fabs(b)), fabs(c)) < NEAR) {
            const double e2 = a * b - 6 * c * c, e3 = (3 * a * b - 8 * c * c) * c;
            const double e4 = 3 * (a * b - c * c) * c * c, e5 = a * b * c * c * c;
            const double series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 +
                                  3 * e5 / 26 - e2 * e2 * e2 / 16;
            return 3 * sum + scale * series / (mean * sqrt(mean));
        }
        const double more = sqrt(x * y) + sqrt(y * z) + sqrt(z * x);
        sum += scale / (sqrt(z) * (z + more));
        scale /= 4;
        x = (x + more) / 4, y = (y + more) / 4, z = (z + more) / 4;
    }
}

/* R_G; with the middle one as the third all terms are positive. */
static double carlson_g(double x, double y, double z)
{
    const double middle = fmax(fmin(x, y), fmin(fmax(x, y), z)), low = fmin(fmin(x, y), z), high = fmax(fmax(x, y), z);
    return (middle * carlson_f(low, high, middle) +
            (middle - low) * (high - middle) * carlson_d(low, high, middle) / 3 + sqrt(low / middle * high)) /
           2;
}

lx_bounded lx_elliptic_area_mm2(const struct lx_emitter *emitter)
{
    static const double UNITS = 64;
    double first[3], second[3];
    if (emitter->type == LX_BALL) {
        const double x = emitter->radii_mm[0], y = emitter->radii_mm[1], z = emitter->radii_mm[2];
        return lx_rounded(4 * M_PI * carlson_g(x * x * y * y, y * y * z * z, z * z * x * x), 0, UNITS);
    }
    lx_half_axes(emitter, first, second);
    const double a2 = lx_dot(first, first), b2 = lx_dot(second, second), ellipse = M_PI * sqrt(a2 * b2);
    if (emitter->type == LX_DISK)
        return lx_rounded(ellipse, 0, UNITS);
    return lx_rounded(2 * ellipse + 8 * carlson_g(0, a2, b2) * emitter->height_mm, 0, UNITS);
}

/* ---- distances ---- */

/* A place at q times the radii is off the surface by no less than |q - 1| times the shortest one. */
bool lx_elliptic_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    static const double UNITS = 16;
    const double place[3] = {place_mm.x.value, place_mm.y.value, place_mm.z.value};
    double ways[3][3], offset[3], shares[3], largest = emitter->radius_mm + emitter->height_mm, shortest = HUGE_VAL;
    lx_elliptic_ways(emitter, ways);
    for (int k = 0; k < 3; k++) {
        offset[k] = place[k] - emitter->center_mm[k];
        largest = fmax(largest, fmax(fabs(place[k]), fabs(emitter->center_mm[k])));
    }
    const double slack = (UNITS * DBL_EPSILON + lx_elliptic_error(emitter)) * largest + error_norm(place_mm);
    const int along = emitter->type == LX_BALL ? -1 : along_of(emitter, ways);
    for (int i = 0; i < 3; i++) {
        shares[i] = i == along ? 0 : lx_dot(offset, ways[i]) / emitter->radii_mm[i];
        shortest = i == along ? shortest : fmin(shortest, emitter->radii_mm[i]);
    }
    const double beyond = (sqrt(lx_dot(shares, shares)) - 1) * shortest;
    if (emitter->type == LX_BALL)
        return beyond <= slack; /* also within it */
    const double over = fabs(lx_dot(offset, ways[along])) - emitter->height_mm / 2;
    if (emitter->type == LX_CYLINDER && beyond <= 0 && over <= 0)
        return -fmax(beyond, over) <= slack;
    return hypot(fmax(beyond, 0), fmax(over, 0)) <= slack;
}

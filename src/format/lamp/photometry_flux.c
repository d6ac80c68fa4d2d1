/* SPDX-License-Identifier: MIT */
/*
 * The flux of a table: by trapezoids over the planes, and over the polar angle either by the zone rule, exact where the
 * intensity is linear in the cosine, or exactly for an intensity that is linear in the angle itself.
 */
#include <math.h>
#include <stdlib.h>

#include "../../base/memory.h"
#include "photometry.h"

static const double DEGREE = 0.017453292519943295;

/* Half of the steps before and behind a number, in radians: what it counts in a sum of trapezoids. */
static double trapezoid(const double *numbers, size_t count, size_t i)
{
    double before = numbers[i > 0 ? i - 1 : i], behind = numbers[i + 1 < count ? i + 1 : i];
    return 0.5 * (behind - before) * DEGREE;
}

bool lx_polar_curve_of(const luxel_photometry *photometry, struct lx_polar_curve *curve)
{
    size_t planes = photometry->plane_count, angles = photometry->angle_count;
    bool is_sideways = photometry->type == LUXEL_PHOTOMETRY_TYPE_B; /* the polar angle is the horizontal one */
    const double *polar = is_sideways ? photometry->planes : photometry->angles;
    const double *other = is_sideways ? photometry->angles : photometry->planes;
    size_t others = is_sideways ? angles : planes;
    curve->count = is_sideways ? planes : angles;
    curve->angles_deg = lx_new_array(curve->count, sizeof *curve->angles_deg);
    curve->values = lx_new_array(curve->count, sizeof *curve->values);
    if (!curve->angles_deg || !curve->values) {
        lx_polar_curve_clear(curve);
        return false;
    }
    for (size_t j = 0; j < curve->count; j++)
        curve->angles_deg[j] = polar[j] + (photometry->type == LUXEL_PHOTOMETRY_TYPE_C ? 0 : 90);
    for (size_t i = 0; i < others; i++) {
        double weight = trapezoid(other, others, i);
        const double *row = photometry->intensities + i * (is_sideways ? 1 : angles);
        for (size_t j = 0; j < curve->count; j++)
            curve->values[j] += weight * row[j * (is_sideways ? angles : 1)];
    }
    return true;
}

void lx_polar_curve_clear(struct lx_polar_curve *curve)
{
    free(curve->angles_deg);
    free(curve->values);
    *curve = (struct lx_polar_curve){NULL, NULL, 0};
}

/* (sin d - d cos d) / d, which cancels where d is small. */
static double moment(double d)
{
    if (d > 0.2)
        return sin(d) / d - cos(d);
    double square = d * d;
    return square / 3 * (1 - square / 10 * (1 - square / 28 * (1 - square / 54)));
}

/* The integral of a value times the sine between two polar angles. */
static double step_flux(luxel_photometry_interpolation rule, double from_deg, double to_deg, double low, double high)
{
    double middle = 0.5 * (from_deg + to_deg) * DEGREE, half = 0.5 * (to_deg - from_deg) * DEGREE;
    double zone = (low + high) * sin(middle) * sin(half);
    if (rule == LUXEL_INTERPOLATE_COSINE || half == 0)
        return zone;
    return zone + (high - low) * cos(middle) * moment(half);
}

/* A value between two polar angles, as the rule has it. */
static double step_value(luxel_photometry_interpolation rule, const struct lx_polar_curve *curve, size_t i,
                         double at_deg)
{
    double from = curve->angles_deg[i], to = curve->angles_deg[i + 1], half = 0.5 * DEGREE;
    double share = rule == LUXEL_INTERPOLATE_ANGLE ? (at_deg - from) / (to - from)
                                                   : sin((at_deg + from) * half) * sin((at_deg - from) * half) /
                                                         (sin((to + from) * half) * sin((to - from) * half));
    return curve->values[i] + share * (curve->values[i + 1] - curve->values[i]);
}

double lx_polar_flux(const struct lx_polar_curve *curve, luxel_photometry_interpolation rule, double from_deg,
                     double to_deg)
{
    double sum = 0;
    for (size_t i = 0; i + 1 < curve->count; i++) {
        double from = curve->angles_deg[i], to = curve->angles_deg[i + 1];
        double low = curve->values[i], high = curve->values[i + 1];
        if (to <= from_deg || from >= to_deg)
            continue;
        if (from < from_deg) {
            low = step_value(rule, curve, i, from_deg);
            from = from_deg;
        }
        if (to > to_deg) {
            high = step_value(rule, curve, i, to_deg);
            to = to_deg;
        }
        sum += step_flux(rule, from, to, low, high);
    }
    return sum;
}

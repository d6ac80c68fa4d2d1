/* SPDX-License-Identifier: MIT */
/*
 * The flux of a table: by trapezoids over the planes, and over the polar angle either by the zone rule, exact where the
 * intensity is linear in the cosine, or exactly for an intensity that is linear in the angle itself.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* What each plane counts in a sum over C from one angle on, so wide, of an intensity that is linear between planes. */
static void weigh_planes(const luxel_photometry *photometry, double from_deg, double width_deg, double *weights)
{
    const double *planes = photometry->planes;
    for (size_t i = 0; i + 1 < photometry->plane_count; i++)
        for (int turn = -1; turn <= 1; turn++) { /* the range may lie across the seam */
            double low = fmax(planes[i], from_deg + 360 * turn);
            double high = fmin(planes[i + 1], from_deg + width_deg + 360 * turn);
            if (!(high > low))
                continue;
            double share = (0.5 * (low + high) - planes[i]) / (planes[i + 1] - planes[i]);
            weights[i] += (1 - share) * (high - low) * DEGREE;
            weights[i + 1] += share * (high - low) * DEGREE;
        }
}

bool lx_polar_curve_within(const luxel_photometry *photometry, double from_deg, double width_deg,
                           struct lx_polar_curve *curve)
{
    size_t angles = photometry->angle_count;
    double *weights = lx_new_array(photometry->plane_count, sizeof *weights);
    curve->count = angles;
    curve->angles_deg = lx_new_array(angles, sizeof *curve->angles_deg);
    curve->values = lx_new_array(angles, sizeof *curve->values);
    bool is_done = weights && curve->angles_deg && curve->values;
    if (is_done) {
        weigh_planes(photometry, from_deg, width_deg, weights);
        memcpy(curve->angles_deg, photometry->angles, angles * sizeof *curve->angles_deg);
        for (size_t i = 0; i < photometry->plane_count; i++)
            for (size_t j = 0; j < angles; j++)
                curve->values[j] += weights[i] * photometry->intensities[i * angles + j];
    } else {
        lx_polar_curve_clear(curve);
    }
    free(weights);
    return is_done;
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

/* SPDX-License-Identifier: MIT */
/*
 * Tables of types A and B as ones of type C, for formats that know no other: the intensities in the directions of a
 * grid of C and gamma, which in the luminaire's own axes stay what they were.  Between its directions the new table is
 * interpolated as the old one is between others, so the two differ; by how much decides how fine the grid is.
 */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "photometry_turn.h"

/* Grids that are tried, from the coarse one on, in degrees, and the difference that is good enough. */
static const struct {
    double plane, angle;
} STEPS[] = {{5, 2.5}, {2.5, 1}, {1, 0.5}};
static const double GOOD = 0.005;

/* What another table tells of the direction of two angles of this one. */
static double told_by(const luxel_photometry *other, const luxel_photometry *photometry, double plane_deg,
                      double angle_deg)
{
    double direction[3], plane, angle;
    luxel_photometry_direction(photometry, plane_deg, angle_deg, direction);
    luxel_photometry_angles(other, direction, &plane, &angle);
    return luxel_photometry_intensity(other, LUXEL_INTERPOLATE_ANGLE, plane, angle);
}

/* The greatest difference in the directions of a table and in the middles between them. */
static double difference(const luxel_photometry *photometry, const luxel_photometry *other)
{
    double most = 0;
    for (size_t i = 0; i + 1 < 2 * photometry->plane_count; i++)
        for (size_t j = 0; j + 1 < 2 * photometry->angle_count; j++) {
            const double plane = (photometry->planes[i / 2] + photometry->planes[(i + 1) / 2]) / 2;
            const double angle = (photometry->angles[j / 2] + photometry->angles[(j + 1) / 2]) / 2;
            const double own = luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, plane, angle);
            most = fmax(most, fabs(own - told_by(other, photometry, plane, angle)));
        }
    return most;
}

static double greatest_of(const luxel_photometry *photometry)
{
    double greatest = 0;
    for (size_t i = 0; i < photometry->plane_count * photometry->angle_count; i++)
        greatest = fmax(greatest, photometry->intensities[i]);
    return greatest;
}

/* Makes the table of a grid; false: no memory. */
static bool sample(const luxel_photometry *photometry, double plane_step, double angle_step, struct lx_turned *turned)
{
    const size_t planes = (size_t)lround(360 / plane_step) + 1, angles = (size_t)lround(180 / angle_step) + 1;
    *turned = (struct lx_turned){.shown = *photometry,
                                 .planes = lx_new_array(planes, sizeof(double)),
                                 .angles = lx_new_array(angles, sizeof(double)),
                                 .intensities = lx_new_array(planes * angles, sizeof(double))};
    if (!turned->planes || !turned->angles || !turned->intensities)
        return false;
    turned->shown.type = LUXEL_PHOTOMETRY_TYPE_C;
    turned->shown.symmetry = LUXEL_SYMMETRY_NONE;
    turned->shown.plane_count = planes;
    turned->shown.angle_count = angles;
    turned->shown.planes = turned->planes;
    turned->shown.angles = turned->angles;
    turned->shown.intensities = turned->intensities;
    for (size_t j = 0; j < angles; j++)
        turned->angles[j] = (double)j * angle_step;
    for (size_t i = 0; i < planes; i++) {
        turned->planes[i] = (double)i * plane_step;
        for (size_t j = 0; j < angles; j++)
            turned->intensities[i * angles + j] =
                told_by(photometry, &turned->shown, i + 1 < planes ? turned->planes[i] : 0, turned->angles[j]);
    }
    return true;
}

bool lx_turn_to_c(const luxel_photometry *photometry, struct lx_turned *turned)
{
    const double greatest = greatest_of(photometry);
    for (size_t i = 0; i < sizeof STEPS / sizeof STEPS[0]; i++) {
        if (i > 0)
            lx_turned_clear(turned);
        if (!sample(photometry, STEPS[i].plane, STEPS[i].angle, turned))
            return false;
        turned->off = fmax(difference(photometry, &turned->shown), difference(&turned->shown, photometry));
        turned->off = greatest > 0 ? turned->off / greatest : 0;
        if (turned->off <= GOOD)
            break;
    }
    return true;
}

void lx_turned_clear(struct lx_turned *turned)
{
    free(turned->planes);
    free(turned->angles);
    free(turned->intensities);
    *turned = (struct lx_turned){.planes = NULL};
}

/* SPDX-License-Identifier: MIT */
/*
 * What catalogues print of a table beside its figures: the flux of zones about the axis, the mean luminance of the
 * opening, and the rating of backlight, uplight and glare of luminaires outdoors (IES TM-15-11, its addendum A).
 */
#include <math.h>
#include <stdlib.h>

#include "photometry.h"
#include "photometry_area.h"

static const double ZONE_DEG = 10;

luxel_status luxel_photometry_find_zones(const luxel_photometry *photometry, double lumens[LUXEL_FLUX_ZONES])
{
    struct lx_polar_curve curve;
    if (!photometry || !lumens)
        return LUXEL_ERROR_ARGUMENT;
    for (int i = 0; i < LUXEL_FLUX_ZONES; i++)
        lumens[i] = (double)NAN;
    if (photometry->type != LUXEL_PHOTOMETRY_TYPE_C)
        return LUXEL_OK;
    if (!lx_polar_curve_of(photometry, &curve))
        return LUXEL_ERROR_MEMORY;
    for (int i = 0; i < LUXEL_FLUX_ZONES; i++)
        lumens[i] = lx_polar_flux(&curve, LUXEL_INTERPOLATE_COSINE, i * ZONE_DEG, (i + 1) * ZONE_DEG);
    lx_polar_curve_clear(&curve);
    return LUXEL_OK;
}

double luxel_photometry_luminance(const luxel_photometry *photometry, double plane_deg, double angle_deg)
{
    double direction[3];
    if (!photometry || photometry->type != LUXEL_PHOTOMETRY_TYPE_C)
        return (double)NAN;
    luxel_photometry_direction(photometry, plane_deg, angle_deg, direction);
    double area = lx_opening_seen_area(&photometry->opening, direction);
    double intensity = luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, plane_deg, angle_deg);
    return area > 0 ? intensity / area : (double)NAN;
}

/* ---- backlight, uplight, glare ---- */

enum { BEYOND = 5 }; /* the rating of what keeps none of the bounds */

/* A zone's most lumens for the ratings 0 to 4. */
struct bound {
    luxel_bug_zone zone;
    double lumens[BEYOND];
};

static const struct bound backlight[] = {{LUXEL_BUG_BACK_HIGH, {110, 500, 1000, 2500, 5000}},
                                         {LUXEL_BUG_BACK_MID, {220, 1000, 2500, 5000, 8500}},
                                         {LUXEL_BUG_BACK_LOW, {110, 500, 1000, 2500, 5000}}};
static const struct bound uplight[] = {{LUXEL_BUG_UP_HIGH, {0, 10, 50, 500, 1000}},
                                       {LUXEL_BUG_UP_LOW, {0, 10, 50, 500, 1000}}};
static const struct bound glare[] = {{LUXEL_BUG_FORWARD_VERY_HIGH, {10, 100, 225, 500, 750}},
                                     {LUXEL_BUG_BACK_VERY_HIGH, {10, 100, 225, 500, 750}},
                                     {LUXEL_BUG_FORWARD_HIGH, {660, 1800, 5000, 7500, 12000}},
                                     {LUXEL_BUG_BACK_HIGH, {110, 500, 1000, 2500, 5000}}};
/* The back counts as the front does where all sides are lit alike. */
static const struct bound glare_around[] = {{LUXEL_BUG_FORWARD_VERY_HIGH, {10, 100, 225, 500, 750}},
                                            {LUXEL_BUG_BACK_VERY_HIGH, {10, 100, 225, 500, 750}},
                                            {LUXEL_BUG_FORWARD_HIGH, {660, 1800, 5000, 7500, 12000}},
                                            {LUXEL_BUG_BACK_HIGH, {660, 1800, 5000, 7500, 12000}}};

static unsigned rate(const struct bound *bounds, size_t count, const double lumens[LUXEL_BUG_ZONES])
{
    unsigned worst = 0;
    for (size_t i = 0; i < count; i++) {
        unsigned rating = 0;
        while (rating < BEYOND && lumens[bounds[i].zone] > bounds[i].lumens[rating])
            rating++;
        worst = rating > worst ? rating : worst;
    }
    return worst;
}

#define RATE(bounds, lumens) rate((bounds), sizeof(bounds) / sizeof *(bounds), (lumens))

/* Whether the four quadrants are alike, and each about its middle: type V, round or square. */
static bool shines_around(const luxel_photometry *photometry, double greatest)
{
    if (photometry->symmetry == LUXEL_SYMMETRY_AXIAL)
        return true;
    if (photometry->symmetry != LUXEL_SYMMETRY_QUADRANT)
        return false;
    for (size_t i = 0; i < photometry->plane_count && photometry->planes[i] <= 45; i++)
        for (size_t j = 0; j < photometry->angle_count; j++) {
            double here = photometry->intensities[i * photometry->angle_count + j];
            double there = luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, 90 - photometry->planes[i],
                                                      photometry->angles[j]);
            if (fabs(here - there) > 0.01 * greatest)
                return false;
        }
    return true;
}

/* The zones of one half, from nadir to the horizon. */
static bool find_half(const luxel_photometry *photometry, double from_deg, double *lumens)
{
    static const double edges[] = {0, 30, 60, 80, 90};
    struct lx_polar_curve curve;
    if (!lx_polar_curve_within(photometry, from_deg < 0 ? from_deg + 360 : from_deg, 180, &curve))
        return false;
    for (int i = 0; i < 4; i++)
        lumens[i] = lx_polar_flux(&curve, LUXEL_INTERPOLATE_COSINE, edges[i], edges[i + 1]);
    lx_polar_curve_clear(&curve);
    return true;
}

luxel_status luxel_photometry_find_bug_rating(const luxel_photometry *photometry, luxel_bug_rating *rating)
{
    struct lx_polar_curve curve;
    double greatest = 0;
    if (!photometry || !rating)
        return LUXEL_ERROR_ARGUMENT;
    *rating = (luxel_bug_rating){.exists = photometry->type == LUXEL_PHOTOMETRY_TYPE_C};
    if (!rating->exists)
        return LUXEL_OK;
    rating->front_c_deg = photometry->format == LUXEL_PHOTOMETRY_EULUMDAT ? 90 : 0;
    if (!find_half(photometry, rating->front_c_deg - 90, rating->lumens + LUXEL_BUG_FORWARD_LOW) ||
        !find_half(photometry, rating->front_c_deg + 90, rating->lumens + LUXEL_BUG_BACK_LOW) ||
        !lx_polar_curve_of(photometry, &curve))
        return LUXEL_ERROR_MEMORY;
    rating->lumens[LUXEL_BUG_UP_LOW] = lx_polar_flux(&curve, LUXEL_INTERPOLATE_COSINE, 90, 100);
    rating->lumens[LUXEL_BUG_UP_HIGH] = lx_polar_flux(&curve, LUXEL_INTERPOLATE_COSINE, 100, 180);
    lx_polar_curve_clear(&curve);
    for (size_t i = 0; i < photometry->plane_count * photometry->angle_count; i++)
        greatest = fmax(greatest, photometry->intensities[i]);
    rating->is_around = shines_around(photometry, greatest);
    rating->backlight = RATE(backlight, rating->lumens);
    rating->uplight = RATE(uplight, rating->lumens);
    rating->glare = rating->is_around ? RATE(glare_around, rating->lumens) : RATE(glare, rating->lumens);
    return LUXEL_OK;
}

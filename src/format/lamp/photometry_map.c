/* SPDX-License-Identifier: MIT */
/* The intensity in any direction, from the table of a luminaire, and directions as angles of the table. */
#include <math.h>

#include "../../base/search.h"
#include "photometry.h"

static const double DEGREE = 0.017453292519943295;

/* How far between two angles, from 0 to 1; by equal solid angles: along the sine or cosine. */
static double share_of(double from_deg, double to_deg, double at_deg, bool by_sine, bool by_cosine)
{
    if (!by_sine && !by_cosine)
        return (at_deg - from_deg) / (to_deg - from_deg);
    double half = 0.5 * DEGREE, pole = by_sine ? 90 : 0; /* a sine is the cosine of an angle counted from the pole */
    double part = sin((at_deg + from_deg + 2 * pole) * half) * sin((at_deg - from_deg) * half);
    return part / (sin((to_deg + from_deg + 2 * pole) * half) * sin((to_deg - from_deg) * half));
}

static bool is_within(const double *numbers, size_t count, double at)
{
    return at >= numbers[0] && at <= numbers[count - 1];
}

double luxel_photometry_intensity(const luxel_photometry *photometry, luxel_photometry_interpolation interpolation,
                                  double plane_deg, double angle_deg)
{
    const double *planes = photometry->planes, *angles = photometry->angles;
    size_t plane_count = photometry->plane_count, angle_count = photometry->angle_count;
    bool is_cosine = interpolation == LUXEL_INTERPOLATE_COSINE;
    luxel_photometry_type type = photometry->type;
    if (type == LUXEL_PHOTOMETRY_TYPE_C) {
        double turned = fmod(plane_deg - planes[0], 360);
        plane_deg = planes[0] + (turned < 0 ? turned + 360 : turned);
        plane_deg = fmin(plane_deg, planes[plane_count - 1]);
    }
    if (!is_within(planes, plane_count, plane_deg) || !is_within(angles, angle_count, angle_deg))
        return 0;
    size_t i = lx_cell_among(planes, plane_count, plane_deg), j = lx_cell_among(angles, angle_count, angle_deg);
    double across = share_of(planes[i], planes[i + 1], plane_deg, is_cosine && type == LUXEL_PHOTOMETRY_TYPE_B, false);
    double along = share_of(angles[j], angles[j + 1], angle_deg, is_cosine && type == LUXEL_PHOTOMETRY_TYPE_A,
                            is_cosine && type == LUXEL_PHOTOMETRY_TYPE_C);
    const double *first = photometry->intensities + i * angle_count + j, *second = first + angle_count;
    double low = first[0] + along * (first[1] - first[0]), high = second[0] + along * (second[1] - second[0]);
    return low + across * (high - low);
}

void luxel_photometry_direction(const luxel_photometry *photometry, double plane_deg, double angle_deg,
                                double direction[3])
{
    double cos_plane = cos(plane_deg * DEGREE), sin_plane = sin(plane_deg * DEGREE);
    double cos_angle = cos(angle_deg * DEGREE), sin_angle = sin(angle_deg * DEGREE);
    switch (photometry->type) {
    case LUXEL_PHOTOMETRY_TYPE_A:
        direction[0] = cos_angle * cos_plane;
        direction[1] = cos_angle * sin_plane;
        direction[2] = sin_angle;
        break;
    case LUXEL_PHOTOMETRY_TYPE_B:
        direction[0] = cos_plane * cos_angle;
        direction[1] = sin_plane;
        direction[2] = cos_plane * sin_angle;
        break;
    case LUXEL_PHOTOMETRY_TYPE_C:
        direction[0] = cos_angle;
        direction[1] = sin_angle * cos_plane;
        direction[2] = sin_angle * sin_plane;
        break;
    }
}

void luxel_photometry_angles(const luxel_photometry *photometry, const double direction[3], double *plane_deg,
                             double *angle_deg)
{
    double axis = direction[0], right = direction[1], up = direction[2];
    switch (photometry->type) {
    case LUXEL_PHOTOMETRY_TYPE_A:
        *plane_deg = atan2(right, axis) / DEGREE;
        *angle_deg = atan2(up, hypot(axis, right)) / DEGREE;
        break;
    case LUXEL_PHOTOMETRY_TYPE_B:
        *plane_deg = atan2(right, hypot(axis, up)) / DEGREE;
        *angle_deg = atan2(up, axis) / DEGREE;
        break;
    case LUXEL_PHOTOMETRY_TYPE_C:
        *plane_deg = atan2(up, right) / DEGREE;
        *plane_deg += *plane_deg < 0 ? 360 : 0;
        *angle_deg = atan2(hypot(right, up), axis) / DEGREE;
        break;
    }
}

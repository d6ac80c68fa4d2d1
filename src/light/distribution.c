/* SPDX-License-Identifier: MIT */
/*
 * The tabulated distribution's float64 reference.  Angles are in degrees here, as those of the file are exact in them.
 *
 * The bound of the function's error is found where the direction may be: in the box of its angles and their errors the
 * function takes its greatest and least values at corners of the pieces into which the lines of the grid cut the box,
 * as it is linear along each angle, or monotone in it, between two lines.
 */
#include "distribution.h"

#include <math.h>

#include "../base/pose.h"
#include "../base/search.h"
#include "../base/wide.h"

static const double DEGREE = 0.017453292519943295;

/* ---- pointing ---- */

static lx_wide3 negated(lx_wide3 a)
{
    return (lx_wide3){lx_wide_negate(a.x), lx_wide_negate(a.y), lx_wide_negate(a.z)};
}

/* Direction i of the table's frame. */
static void set_frame(struct lx_pointed *pointed, int i, lx_bounded3 direction)
{
    pointed->frame[i] = direction;
    lx_values3(direction, pointed->frame_double[i]);
    for (int k = 0; k < 3; k++)
        pointed->frame_single[i][k] = (float)pointed->frame_double[i][k];
}

/* pose.h's `upward` is `up` made perpendicular to the axis, and `across` is up x axis. */
static void point(const struct lx_distribution *distribution, struct lx_pose pose, struct lx_pointed *pointed)
{
    const lx_wide3 axis = pose.axis, c0 = pose.upward, across = pose.across;
    const luxel_photometry_type type = distribution->photometry->shown.type;
    const lx_wide3 frames[][3] = {
        [LUXEL_PHOTOMETRY_TYPE_A] = {axis, c0, negated(across)},
        [LUXEL_PHOTOMETRY_TYPE_B] = {axis, across, negated(c0)},
        [LUXEL_PHOTOMETRY_TYPE_C] = {c0, across, axis},
    };
    pointed->distribution = distribution;
    pointed->axis = lx_wide3_direction(axis);
    pointed->c0 = lx_wide3_direction(c0);
    pointed->across = lx_wide3_direction(across);
    for (int i = 0; i < 3; i++)
        set_frame(pointed, i, lx_wide3_direction(frames[type][i]));
}

void lx_turn_distribution(const struct lx_pointed *pointed, const struct lx_frame *frame, struct lx_pointed *turned)
{
    *turned = *pointed;
    turned->axis = lx_frame_turn_bounded(frame, pointed->axis);
    turned->c0 = lx_frame_turn_bounded(frame, pointed->c0);
    turned->across = lx_frame_turn_bounded(frame, pointed->across);
    for (int i = 0; i < 3; i++)
        set_frame(turned, i, lx_frame_turn_bounded(frame, pointed->frame[i]));
}

void lx_point_distribution(const struct lx_distribution *distribution, const double axis[3], const double c0[3],
                           struct lx_pointed *pointed)
{
    point(distribution, lx_pose_of(axis, c0), pointed);
}

void lx_aim_distribution(const struct lx_distribution *distribution, const double from[3], const double to[3],
                         const double c0[3], struct lx_pointed *pointed)
{
    point(distribution, lx_pose_towards(from, to, c0), pointed);
}

/* ---- the function ---- */

/* How far from one polar angle to another, from 0 to 1. */
static double polar_share(const struct lx_distribution *distribution, double from, double to, double at)
{
    if (distribution->interpolation == LUXEL_INTERPOLATE_ANGLE)
        return (at - from) / (to - from);
    const double half = 0.5 * DEGREE; /* differences of cosines as products, with sums counted from the nearer pole */
    const double sum = at + from, whole = to + from, turned = sum > 180 ? 360 - sum : sum;
    return sin(turned * half) * sin((at - from) * half) /
           (sin((whole > 180 ? 360 - whole : whole) * half) * sin((to - from) * half));
}

/* The function at angles within the lines, by the cell that holds them. */
static double value_in(const struct lx_distribution *distribution, size_t i, size_t j, double azimuth, double polar)
{
    const double *azimuths = distribution->azimuths, *polars = distribution->polars;
    const double *first = distribution->values + i * distribution->polar_count + j;
    const double *second = first + distribution->polar_count;
    const double across = (azimuth - azimuths[i]) / (azimuths[i + 1] - azimuths[i]);
    const double along = polar_share(distribution, polars[j], polars[j + 1], polar);
    const double low = first[0] + along * (first[1] - first[0]), high = second[0] + along * (second[1] - second[0]);
    return low + across * (high - low);
}

/* An interval of an angle. */
struct span {
    double from, to;
};

/* The least and the greatest of what the function takes. */
struct extent {
    double least, greatest;
};

static void take(struct extent *extent, double value)
{
    extent->least = fmin(extent->least, value);
    extent->greatest = fmax(extent->greatest, value);
}

/* All that the function may be in a box of angles which does not go round the seam. */
static void extend(const struct lx_distribution *distribution, struct span azimuth, struct span polar,
                   struct extent *extent)
{
    const double *azimuths = distribution->azimuths, *polars = distribution->polars;
    const size_t last_i = distribution->azimuth_count - 1, last_j = distribution->polar_count - 1;
    if (azimuth.from < azimuths[0] || azimuth.to > azimuths[last_i] || polar.from < polars[0] ||
        polar.to > polars[last_j])
        take(extent, 0);
    azimuth.from = fmax(azimuth.from, azimuths[0]), azimuth.to = fmin(azimuth.to, azimuths[last_i]);
    polar.from = fmax(polar.from, polars[0]), polar.to = fmin(polar.to, polars[last_j]);
    if (azimuth.from > azimuth.to || polar.from > polar.to)
        return;
    size_t from_i = lx_cell_among(azimuths, last_i + 1, azimuth.from),
           to_i = lx_cell_among(azimuths, last_i + 1, azimuth.to);
    size_t from_j = lx_cell_among(polars, last_j + 1, polar.from), to_j = lx_cell_among(polars, last_j + 1, polar.to);
    for (size_t i = from_i; i <= to_i; i++)
        for (size_t j = from_j; j <= to_j; j++) {
            const double left = fmax(azimuth.from, azimuths[i]), right = fmin(azimuth.to, azimuths[i + 1]);
            const double low = fmax(polar.from, polars[j]), high = fmin(polar.to, polars[j + 1]);
            take(extent, value_in(distribution, i, j, left, low));
            take(extent, value_in(distribution, i, j, left, high));
            take(extent, value_in(distribution, i, j, right, low));
            take(extent, value_in(distribution, i, j, right, high));
        }
}

/* Extent of any box; the azimuths of a whole turn have a seam. */
static void extend_round(const struct lx_distribution *distribution, struct span azimuth, struct span polar,
                         struct extent *extent)
{
    const double start = distribution->azimuths[0], end = distribution->azimuths[distribution->azimuth_count - 1];
    if (end - start < 360) {
        extend(distribution, azimuth, polar, extent);
        if (azimuth.to > 180)
            extend(distribution, (struct span){-180, azimuth.to - 360}, polar, extent);
        if (azimuth.from < -180)
            extend(distribution, (struct span){azimuth.from + 360, 180}, polar, extent);
        return;
    }
    if (azimuth.to - azimuth.from >= 360)
        azimuth = (struct span){start, end};
    if (azimuth.from < start)
        extend(distribution, (struct span){fmax(azimuth.from + 360, start), end}, polar, extent);
    if (azimuth.to > end)
        extend(distribution, (struct span){start, fmin(azimuth.to - 360, end)}, polar, extent);
    extend(distribution, (struct span){fmax(azimuth.from, start), fmin(azimuth.to, end)}, polar, extent);
}

/* The angles of a direction, in degrees; the azimuth of a whole turn from its first line on. */
struct angles {
    lx_bounded azimuth, polar;
};

static struct angles angles_of(const struct lx_pointed *pointed, lx_bounded3 towards)
{
    const struct lx_distribution *distribution = pointed->distribution;
    const lx_bounded degrees = lx_rounded(180 / M_PI, 0, 2);
    lx_bounded d[3];
    for (int i = 0; i < 3; i++)
        d[i] = lx_negate(lx_dot3(pointed->frame[i], towards));
    /* the third of the way round the axis: a cross product keeps the digits of directions near the axis */
    const lx_bounded beside = lx_sqrt(lx_square3(lx_cross3(pointed->frame[2], towards)));
    struct angles angles = {lx_mul(lx_angle(d[1], d[0]), degrees), lx_mul(lx_angle(beside, d[2]), degrees)};
    if (!(beside.value > beside.error) || !(angles.azimuth.error < 180))
        angles.azimuth = (lx_bounded){0, 180};
    const double start = distribution->azimuths[0];
    if (distribution->azimuths[distribution->azimuth_count - 1] - start >= 360)
        while (angles.azimuth.value < start)
            angles.azimuth = lx_add(angles.azimuth, lx_exact(360));
    return angles;
}

/* Error of the lines for being counted from another direction than in the file, and sums for rounding. */
static const double LINES_OFF = 3e-14; /* degrees */
/* Roundings of two shares and three steps between values. */
static const double ROUNDINGS = 12;

lx_bounded lx_pointed_value(const struct lx_pointed *pointed, lx_bounded3 towards)
{
    const struct lx_distribution *distribution = pointed->distribution;
    const bool is_turned = distribution->photometry->shown.type != LUXEL_PHOTOMETRY_TYPE_C;
    const double off = is_turned || distribution->interpolation == LUXEL_INTERPOLATE_COSINE ? LINES_OFF : 0;
    const struct angles angles = angles_of(pointed, towards);
    const lx_bounded azimuth = angles.azimuth, polar = angles.polar;
    const double least = fmax(polar.value - polar.error - off, 0), most = fmin(polar.value + polar.error + off, 180);
    const double middle_polar = fmax(fmin(polar.value, 180), 0);
    struct extent middle = {HUGE_VAL, -HUGE_VAL}, all;
    extend_round(distribution, (struct span){azimuth.value, azimuth.value}, (struct span){middle_polar, middle_polar},
                 &middle);
    if (!(middle.least <= middle.greatest))
        middle = (struct extent){0, 0};
    all = middle;
    extend_round(distribution, (struct span){azimuth.value - azimuth.error, azimuth.value + azimuth.error},
                 (struct span){least, most}, &all);
    const double value = fmax(middle.greatest, 0);
    const double apart = fmax(all.greatest - value, value - all.least);
    return (lx_bounded){value, (apart + ROUNDINGS * LX_ROUNDING * all.greatest) * LX_BOUND_SLACK};
}

void lx_pointed_angles(const struct lx_pointed *pointed, const double towards[3], double *plane_deg, double *angle_deg)
{
    const lx_bounded3 *frame[] = {&pointed->axis, &pointed->c0, &pointed->across};
    double direction[3];
    for (int i = 0; i < 3; i++)
        direction[i] =
            -(frame[i]->x.value * towards[0] + frame[i]->y.value * towards[1] + frame[i]->z.value * towards[2]);
    luxel_photometry_angles(&pointed->distribution->photometry->shown, direction, plane_deg, angle_deg);
}

/* ---- where it breaks ---- */

/* Whether the function jumps at an outermost polar line. */
static bool jumps_at(const struct lx_distribution *distribution, size_t j)
{
    const double polar = distribution->polars[j];
    if (polar <= 0 || polar >= 180)
        return false;
    for (size_t i = 0; i < distribution->azimuth_count; i++)
        if (distribution->values[i * distribution->polar_count + j] > 0)
            return j == 0 || j + 1 == distribution->polar_count;
    return false;
}

bool lx_pointed_break(const struct lx_pointed *pointed, size_t i, struct lx_break *place)
{
    const struct lx_distribution *distribution = pointed->distribution;
    *place = (struct lx_break){.shape = LX_BREAK_CONE, .order = LX_KINK};
    lx_values3(pointed->frame[2], place->axis);
    if (i < distribution->polar_count) {
        place->angle_rad = distribution->polars[i] * DEGREE;
        const bool is_pole = distribution->polars[i] <= 0 || distribution->polars[i] >= 180;
        place->order = is_pole ? LX_BEND : jumps_at(distribution, i) ? LX_JUMP : LX_KINK;
        return true;
    }
    i -= distribution->polar_count;
    if (distribution->table_double.is_axial || i >= distribution->azimuth_count)
        return false;
    const bool is_turn = distribution->azimuths[distribution->azimuth_count - 1] - distribution->azimuths[0] >= 360;
    const double azimuth = distribution->azimuths[i] * DEGREE;
    double first[3], second[3];
    lx_values3(pointed->frame[0], first);
    lx_values3(pointed->frame[1], second);
    place->shape = LX_BREAK_HALF_PLANE;
    place->order = !is_turn && (i == 0 || i + 1 == distribution->azimuth_count) ? LX_JUMP : LX_KINK;
    for (int k = 0; k < 3; k++)
        place->begin[k] = cos(azimuth) * first[k] + sin(azimuth) * second[k];
    return true;
}

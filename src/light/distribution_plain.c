/* SPDX-License-Identifier: MIT */
/*
 * The tabulated distribution in plain float64, for integrals over openings: its values, and where the lines of the
 * table cross an arc of directions, for between two of them it is smooth.
 */
#include <math.h>

#include "../base/vector.h"
#include "distribution.h"

static const double DEGREE = 0.017453292519943295;

/* The cell of an angle in radians, as the kernels find it. */
static size_t cell_of(const struct lx_lines_double *lines, double angle)
{
    const double bucket = (angle - lines->start) * lines->per_radian;
    uint32_t cell = lines->first[bucket > 0 ? (bucket < (double)lines->last ? (uint32_t)bucket : lines->last) : 0];
    while (cell > 0 && angle < lines->edge[cell])
        cell--;
    while (angle >= lines->edge[cell + 1])
        cell++;
    return cell;
}

/* The azimuth of a way from the luminaire in the table's frame, in radians; of a whole turn from its first line on. */
static double azimuth_of(const struct lx_distribution *distribution, const double d[3])
{
    const struct lx_lines_double *lines = &distribution->table_double.azimuth;
    const double azimuth = atan2(d[1], d[0]);
    const bool is_turn = lines->dark_above > 8;
    return is_turn && azimuth < lines->start ? azimuth + 2 * M_PI : azimuth;
}

/* The share of its cell that is behind a direction. */
static double polar_share(const struct lx_table_double *table, size_t j, double polar)
{
    if (!table->by_cosine)
        return (polar - table->polar.line[j]) * table->polar.per_step[j];
    const bool is_south = j >= table->south;
    const double sine = sin((is_south ? M_PI - polar : polar) / 2), versine = 2 * sine * sine;
    return ((is_south ? -versine : versine) - table->polar.line[j]) * table->polar.per_step[j];
}

/* The value in a cell, of which `along` and `across` are behind. */
static double blend(const struct lx_distribution *distribution, size_t i, size_t j, double across, double along)
{
    const double *near = distribution->table_double.values + i * distribution->polar_count + j;
    const double first = near[0] + along * (near[1] - near[0]);
    if (distribution->table_double.is_axial)
        return fmax(first, 0);
    const double *far = near + distribution->polar_count;
    const double second = far[0] + along * (far[1] - far[0]);
    return fmax(first + across * (second - first), 0);
}

/* The direction in the table's frame. */
static void turn_to_frame(const struct lx_pointed *pointed, const double towards[3], double d[3])
{
    for (int i = 0; i < 3; i++)
        d[i] = -lx_dot(pointed->frame_double[i], towards);
}

/* Keeps an angle and the cell that it lies in. */
static void keep(struct lx_kept_angle *kept, double angle, size_t cell)
{
    *kept = (struct lx_kept_angle){.angle = angle, .cosine = cos(angle), .sine = sin(angle), .cell = cell};
}

static double value_anywhere(const struct lx_distribution *distribution, const double d[3], struct lx_kept_cell *kept)
{
    const struct lx_table_double *table = &distribution->table_double;
    const double polar = atan2(sqrt(d[0] * d[0] + d[1] * d[1]), d[2]);
    size_t i = 0;
    double across = 0;
    kept->is_set = false;
    if (polar < table->polar.dark_below || polar > table->polar.dark_above)
        return 0;
    const size_t j = cell_of(&table->polar, polar);
    if (!table->is_axial) {
        const double azimuth = azimuth_of(distribution, d);
        if (azimuth < table->azimuth.dark_below || azimuth > table->azimuth.dark_above)
            return 0;
        i = cell_of(&table->azimuth, azimuth);
        across = (azimuth - table->azimuth.line[i]) * table->azimuth.per_step[i];
        keep(&kept->azimuth, azimuth, i);
    }
    keep(&kept->polar, polar, j);
    kept->is_set = true;
    return blend(distribution, i, j, across, polar_share(table, j, polar));
}

/* The angle whose sine and cosine these are, times `length`, next to one that was kept; false: it is not near. */
static bool angle_near(const struct lx_kept_angle *kept, double sine, double cosine, double length, double *angle)
{
    static const double NEAR = 0.1; /* so far the series of the arc sine has all digits */
    const double x = (sine * kept->cosine - cosine * kept->sine) / length, x2 = x * x;
    if (!(fabs(x) < NEAR) || !(cosine * kept->cosine + sine * kept->sine > 0))
        return false;
    const double series =
        1 + x2 * (1 / 6. +
                  x2 * (3 / 40. +
                        x2 * (15 / 336. +
                              x2 * (105 / 3456. +
                                    x2 * (945 / 42240. + x2 * (10395 / 599040. + x2 * (135135 / 9676800.)))))));
    *angle = kept->angle + x * series;
    return true;
}

double lx_pointed_near(const struct lx_pointed *pointed, const double towards[3], struct lx_kept_cell *kept)
{
    const struct lx_distribution *distribution = pointed->distribution;
    const struct lx_table_double *table = &distribution->table_double;
    double d[3], polar, azimuth, across = 0;
    turn_to_frame(pointed, towards, d);
    const double radius = sqrt(d[0] * d[0] + d[1] * d[1]);
    const size_t i = kept->azimuth.cell, j = kept->polar.cell;
    if (!kept->is_set || !angle_near(&kept->polar, radius, d[2], 1, &polar))
        return value_anywhere(distribution, d, kept);
    const double along = polar_share(table, j, polar);
    if (!table->is_axial) {
        if (!angle_near(&kept->azimuth, d[1], d[0], radius, &azimuth))
            return value_anywhere(distribution, d, kept);
        across = (azimuth - table->azimuth.line[i]) * table->azimuth.per_step[i];
    }
    if (!(along >= 0 && along <= 1 && across >= 0 && across <= 1)) /* it lies in another cell */
        return value_anywhere(distribution, d, kept);
    return blend(distribution, table->is_axial ? 0 : i, j, across, along);
}

double lx_pointed_plain(const struct lx_pointed *pointed, const double towards[3])
{
    struct lx_kept_cell unused;
    double d[3];
    turn_to_frame(pointed, towards, d);
    return value_anywhere(pointed->distribution, d, &unused);
}

double lx_pointed_slope(const struct lx_pointed *pointed)
{
    static const double STEEP = 1e4; /* where it jumps, a strip as narrow as directions are sure */
    return isfinite(pointed->distribution->slope) ? pointed->distribution->slope : STEEP;
}

/* Crossings that are found, and how many there may be. */
struct crossings {
    struct lx_pointed_crossing *items;
    size_t count, most;
};

/* The place of an angle on the arc, or HUGE_VAL where it is not on it. */
static double on_arc(const struct lx_pointed_arc *arc, double at)
{
    const double turned = at - 2 * M_PI * floor((at - arc->from) / (2 * M_PI));
    return turned > arc->from && turned < arc->from + arc->width ? turned : HUGE_VAL;
}

/* Appends a place that lies on the arc. */
static void put(const struct lx_pointed_arc *arc, double at, size_t line, struct crossings *crossings)
{
    const double tau = on_arc(arc, at);
    if (crossings->count < crossings->most && tau < HUGE_VAL)
        crossings->items[crossings->count++] = (struct lx_pointed_crossing){tau, (uint32_t)line};
}

/* Where the polar lines cross the arc, on which the cosine of the polar angle is amplitude cos(tau - peak). */
static void cross_polars(const struct lx_distribution *distribution, const struct lx_pointed_arc *arc, double a,
                         double b, struct crossings *crossings)
{
    const double amplitude = hypot(a, b), peak = atan2(b, a), to = arc->from + arc->width;
    const double first = amplitude * cos(arc->from - peak), last = amplitude * cos(to - peak);
    double least = fmin(first, last), greatest = fmax(first, last);
    if (on_arc(arc, peak) < HUGE_VAL)
        greatest = amplitude;
    if (on_arc(arc, peak + M_PI) < HUGE_VAL)
        least = -amplitude;
    const double nearest = acos(fmin(greatest, 1)), farthest = acos(fmax(least, -1));
    for (size_t j = 0; j < distribution->polar_count; j++) {
        const double angle = distribution->polars[j] * DEGREE;
        if (!(angle > nearest && angle < farthest))
            continue;
        const double half = acos(fmax(-1, fmin(cos(angle) / amplitude, 1)));
        put(arc, peak - half, 2 * j, crossings);
        put(arc, peak + half, 2 * j + 1, crossings);
    }
}

/* Where the azimuth lines do.  Along an arc the azimuth goes one way, by less than half a turn. */
static void cross_azimuths(const struct lx_distribution *distribution, const struct lx_pointed_arc *arc,
                           const double e[3], const double d[3], struct crossings *crossings)
{
    const double to = arc->from + arc->width;
    const double first =
        atan2(e[1] * cos(arc->from) + d[1] * sin(arc->from), e[0] * cos(arc->from) + d[0] * sin(arc->from));
    const double last = atan2(e[1] * cos(to) + d[1] * sin(to), e[0] * cos(to) + d[0] * sin(to));
    const double way = e[0] * d[1] - e[1] * d[0] > 0 ? 1 : -1;
    double swept = way * (last - first);
    swept -= 2 * M_PI * floor(swept / (2 * M_PI));
    for (size_t i = 0; i < distribution->azimuth_count; i++) {
        const double angle = distribution->azimuths[i] * DEGREE;
        double ahead = way * (angle - first);
        ahead -= 2 * M_PI * floor(ahead / (2 * M_PI));
        if (!(ahead < swept))
            continue;
        const double sine = sin(angle), cosine = cos(angle);
        const double at = atan2(-(e[0] * sine - e[1] * cosine), d[0] * sine - d[1] * cosine);
        const size_t line = 2 * (distribution->polar_count + i);
        put(arc, at, line, crossings);
        put(arc, at + M_PI, line + 1, crossings);
    }
}

size_t lx_pointed_crossings(const struct lx_pointed *pointed, const struct lx_pointed_arc *arc, size_t most,
                            struct lx_pointed_crossing *crossings)
{
    const struct lx_distribution *distribution = pointed->distribution;
    struct crossings found = {crossings, 0, most};
    double e[3], d[3];
    for (int i = 0; i < 3; i++) {
        e[i] = -lx_dot(pointed->frame_double[i], arc->direction);
        d[i] = -lx_dot(pointed->frame_double[i], arc->pole);
    }
    cross_polars(distribution, arc, e[2], d[2], &found);
    if (!distribution->table_double.is_axial)
        cross_azimuths(distribution, arc, e, d, &found);
    return found.count;
}

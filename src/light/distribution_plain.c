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

double lx_pointed_plain(const struct lx_pointed *pointed, const double towards[3])
{
    const struct lx_distribution *distribution = pointed->distribution;
    const struct lx_table_double *table = &distribution->table_double;
    double d[3];
    for (int i = 0; i < 3; i++)
        d[i] = -lx_dot(pointed->frame_double[i], towards);
    const double polar = atan2(sqrt(d[0] * d[0] + d[1] * d[1]), d[2]);
    if (polar < table->polar.dark_below || polar > table->polar.dark_above)
        return 0;
    const size_t j = cell_of(&table->polar, polar);
    const double along = polar_share(table, j, polar);
    const double *near = table->values + j;
    if (table->is_axial)
        return fmax(near[0] + along * (near[1] - near[0]), 0);
    const double azimuth = azimuth_of(distribution, d);
    if (azimuth < table->azimuth.dark_below || azimuth > table->azimuth.dark_above)
        return 0;
    const size_t i = cell_of(&table->azimuth, azimuth);
    near += i * distribution->polar_count;
    const double *far = near + distribution->polar_count;
    const double first = near[0] + along * (near[1] - near[0]), second = far[0] + along * (far[1] - far[0]);
    const double across = (azimuth - table->azimuth.line[i]) * table->azimuth.per_step[i];
    return fmax(first + across * (second - first), 0);
}

double lx_pointed_slope(const struct lx_pointed *pointed)
{
    static const double STEEP = 1e4; /* where it jumps, a strip as narrow as directions are sure */
    return isfinite(pointed->distribution->slope) ? pointed->distribution->slope : STEEP;
}

/* Appends a place that lies on the arc. */
static size_t put(const struct lx_pointed_arc *arc, double at, size_t count, size_t most, double *places)
{
    const double turned = at - 2 * M_PI * floor((at - arc->from) / (2 * M_PI));
    if (count == most || !(turned > arc->from && turned < arc->from + arc->width))
        return count;
    places[count] = turned;
    return count + 1;
}

/* Where the polar lines cross the arc, on which the cosine of the polar angle is amplitude cos(tau - peak). */
static size_t cross_polars(const struct lx_distribution *distribution, const struct lx_pointed_arc *arc, double a,
                           double b, size_t most, double *places)
{
    const double amplitude = hypot(a, b), peak = atan2(b, a), to = arc->from + arc->width;
    const double first = amplitude * cos(arc->from - peak), last = amplitude * cos(to - peak);
    double least = fmin(first, last), greatest = fmax(first, last), unused[1];
    size_t count = 0;
    if (put(arc, peak, 0, 1, unused))
        greatest = amplitude;
    if (put(arc, peak + M_PI, 0, 1, unused))
        least = -amplitude;
    const double nearest = acos(fmin(greatest, 1)), farthest = acos(fmax(least, -1));
    for (size_t j = 0; j < distribution->polar_count; j++) {
        const double angle = distribution->polars[j] * DEGREE;
        if (!(angle > nearest && angle < farthest))
            continue;
        const double half = acos(fmax(-1, fmin(cos(angle) / amplitude, 1)));
        count = put(arc, peak - half, count, most, places);
        count = put(arc, peak + half, count, most, places);
    }
    return count;
}

/* Where the azimuth lines do.  Along an arc the azimuth goes one way, by less than half a turn. */
static size_t cross_azimuths(const struct lx_distribution *distribution, const struct lx_pointed_arc *arc,
                             const double e[3], const double d[3], size_t count, size_t most, double *places)
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
        count = put(arc, at, count, most, places);
        count = put(arc, at + M_PI, count, most, places);
    }
    return count;
}

size_t lx_pointed_crossings(const struct lx_pointed *pointed, const struct lx_pointed_arc *arc, size_t most,
                            double *places)
{
    const struct lx_distribution *distribution = pointed->distribution;
    double e[3], d[3];
    for (int i = 0; i < 3; i++) {
        e[i] = -lx_dot(pointed->frame_double[i], arc->direction);
        d[i] = -lx_dot(pointed->frame_double[i], arc->pole);
    }
    const size_t count = cross_polars(distribution, arc, e[2], d[2], most, places);
    return distribution->table_double.is_axial ? count : cross_azimuths(distribution, arc, e, d, count, most, places);
}

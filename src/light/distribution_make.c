/* SPDX-License-Identifier: MIT */
/*
 * Making a distribution of a photometry: the grid of azimuth and polar angle, what is known of it as a whole, and the
 * kernels' lines.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "distribution.h"

static const double DEGREE = 0.017453292519943295;

/* ---- the grid ---- */

static void clear(struct lx_distribution *made)
{
    free(made->azimuths);
    free(made->polars);
    free(made->values);
    free(made->room);
    lx_even_table_clear(&made->even);
    if (made->photometry)
        lx_kept_release((struct lx_kept *)&made->photometry->kept);
    free(made);
}

static void free_by_angle(struct lx_kept *kept)
{
    clear((struct lx_distribution *)kept);
}

static void free_by_cosine(struct lx_kept *kept)
{
    clear((struct lx_distribution *)kept);
}

void (*lx_distribution_free_of(luxel_photometry_interpolation interpolation))(struct lx_kept *kept)
{
    return interpolation == LUXEL_INTERPOLATE_ANGLE ? free_by_angle : free_by_cosine;
}

static double greatest_of(const double *values, size_t count)
{
    double greatest = 0;
    for (size_t i = 0; i < count; i++)
        greatest = fmax(greatest, values[i]);
    return greatest;
}

static bool make_grid(struct lx_distribution *made)
{
    const luxel_photometry *shown = &made->photometry->shown;
    const size_t planes = shown->plane_count, angles = shown->angle_count;
    const bool is_sideways = shown->type == LUXEL_PHOTOMETRY_TYPE_B;
    const double from_pole = shown->type == LUXEL_PHOTOMETRY_TYPE_C ? 0 : 90;
    int exponent = 0;
    frexp(greatest_of(shown->intensities, planes * angles), &exponent);
    made->unit_cd = ldexp(1, exponent);
    made->azimuth_count = is_sideways ? angles : planes;
    made->polar_count = is_sideways ? planes : angles;
    made->azimuths = lx_new_array(made->azimuth_count, sizeof *made->azimuths);
    made->polars = lx_new_array(made->polar_count, sizeof *made->polars);
    made->values = lx_new_array(planes * angles, sizeof *made->values);
    if (!made->azimuths || !made->polars || !made->values)
        return false;
    memcpy(made->azimuths, is_sideways ? shown->angles : shown->planes, made->azimuth_count * sizeof *made->azimuths);
    for (size_t j = 0; j < made->polar_count; j++)
        made->polars[j] = from_pole + (is_sideways ? shown->planes : shown->angles)[j];
    for (size_t i = 0; i < made->azimuth_count; i++)
        for (size_t j = 0; j < made->polar_count; j++)
            made->values[i * made->polar_count + j] =
                shown->intensities[is_sideways ? j * angles + i : i * angles + j] / made->unit_cd;
    return true;
}

/* ---- what is known of the whole ---- */

static bool is_turn(const struct lx_distribution *made)
{
    return made->azimuths[made->azimuth_count - 1] - made->azimuths[0] >= 360;
}

static bool is_axial(const struct lx_distribution *made)
{
    const size_t row = made->polar_count;
    for (size_t i = 1; i < made->azimuth_count; i++)
        if (memcmp(made->values, made->values + i * row, row * sizeof *made->values) != 0)
            return false;
    return is_turn(made);
}

/* Whether all values of a line of azimuths, or of polar angles, are 0. */
static bool is_dark(const double *values, size_t count, size_t stride)
{
    for (size_t i = 0; i < count; i++)
        if (values[i * stride] > 0)
            return false;
    return true;
}

/* Whether it ends in light somewhere, where it jumps to 0. */
static bool has_jump(const struct lx_distribution *made)
{
    const size_t row = made->polar_count, count = made->azimuth_count;
    if (!is_turn(made) && (!is_dark(made->values, row, 1) || !is_dark(made->values + (count - 1) * row, row, 1)))
        return true;
    return (made->polars[0] > 0 && !is_dark(made->values, count, row)) ||
           (made->polars[row - 1] < 180 && !is_dark(made->values + row - 1, count, row));
}

/* The greatest slope along the polar angle of a step of two values, for a radian. */
static double polar_slope(const struct lx_distribution *made, size_t j, double step)
{
    const double from = made->polars[j] * DEGREE, to = made->polars[j + 1] * DEGREE;
    if (made->interpolation == LUXEL_INTERPOLATE_ANGLE)
        return step / (to - from);
    const double sine = from < M_PI / 2 && to > M_PI / 2 ? 1 : fmax(sin(from), sin(to));
    return step * sine / (2 * sin((to + from) / 2) * sin((to - from) / 2));
}

/*
 * The greatest slope along the azimuth between two lines of it, whose values differ by `near` and `far` at the ends of
 * a step of the polar angle, for a radian of the direction: at a pole all azimuths are one direction.
 */
static double azimuth_slope(const struct lx_distribution *made, size_t i, size_t j, double near, double far)
{
    const double step = (made->azimuths[i + 1] - made->azimuths[i]) * DEGREE;
    const double from = made->polars[j] * DEGREE, to = made->polars[j + 1] * DEGREE;
    const bool at_start = !(sin(from) > 1e-12) && from < 1, at_end = !(sin(to) > 1e-12) || to >= M_PI;
    if ((at_start && near > 0) || (at_end && far > 0))
        return HUGE_VAL;
    /* where the difference rises from 0 at a pole, no faster than the sine there does, twice over */
    const double least = at_start ? sin(fmin(to, M_PI / 2)) / 2
                         : at_end ? sin(fmax(from, M_PI / 2)) / 2
                                  : fmin(sin(from), sin(to));
    return fmax(near, far) / (step * least);
}

static double slope_of(const struct lx_distribution *made)
{
    const size_t row = made->polar_count;
    double along = 0, around = 0;
    if (has_jump(made))
        return HUGE_VAL;
    for (size_t i = 0; i < made->azimuth_count; i++)
        for (size_t j = 0; j + 1 < row; j++) {
            const double *at = made->values + i * row + j;
            along = fmax(along, polar_slope(made, j, fabs(at[1] - at[0])));
            if (i + 1 < made->azimuth_count)
                around = fmax(around, azimuth_slope(made, i, j, fabs(at[row] - at[0]), fabs(at[row + 1] - at[1])));
        }
    return hypot(along, around);
}

/* ---- the kernels' lines ---- */

/* Buckets of lines are as narrow as the narrowest step, but there are no more than this. */
enum { MOST_BUCKETS = 65536 };

static const double BEYOND = 100; /* more than any angle in radians */

/* Angles that the lines of one direction are made of. */
struct plan_of_lines {
    const double *degrees;
    size_t count;
    bool by_cosine;
    bool is_closed[2]; /* the first or the last line is a pole or the seam of a turn, beyond which there is no dark */
};

static size_t bucket_count(const struct plan_of_lines *plan)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i + 1 < plan->count; i++)
        least = fmin(least, plan->degrees[i + 1] - plan->degrees[i]);
    return (size_t)fmin(ceil((plan->degrees[plan->count - 1] - plan->degrees[0]) / least) + 1, MOST_BUCKETS);
}

/* The versine 1 - cos of an angle, or, from half way on, less that of the rest to the other pole. */
static double versine(double degrees, bool is_south)
{
    const double sine = sin((is_south ? 180 - degrees : degrees) * (DEGREE / 2));
    return is_south ? -2 * sine * sine : 2 * sine * sine;
}

static uint32_t first_south(const struct plan_of_lines *plan)
{
    uint32_t cell = 0;
    while (cell + 1 < plan->count && plan->degrees[cell] < 90)
        cell++;
    return cell;
}

/* Room for the numbers of lines, handed out bit by bit. */
struct room {
    double *doubles;
    float *singles;
    uint32_t *indices;
};

/* Cells a radian where all of them are alike and linear in the angle, but for a rounding; else 0. */
static double even_cells(const struct plan_of_lines *plan)
{
    const double cells = (double)plan->count - 1, start = plan->degrees[0];
    const double whole = plan->degrees[plan->count - 1] - start;
    for (size_t i = 0; i < plan->count; i++)
        if (plan->by_cosine || fabs(plan->degrees[i] - (start + whole * (double)i / cells)) > 1e-13 * 360)
            return 0;
    return cells / (whole * DEGREE);
}

static void make_lines(const struct plan_of_lines *plan, struct room *room, struct lx_lines_double *lines)
{
    const size_t count = plan->count, buckets = bucket_count(plan);
    const double start = plan->degrees[0] * DEGREE, end = plan->degrees[count - 1] * DEGREE;
    double *edge = room->doubles, *line = edge + count, *per_step = line + count;
    uint32_t *first = room->indices, cell = 0;
    *lines = (struct lx_lines_double){.cells = (uint32_t)count - 1,
                                      .last = (uint32_t)buckets - 1,
                                      .start = start,
                                      .per_radian = (double)(buckets - 1) / (end - start),
                                      .even = even_cells(plan),
                                      .first = first,
                                      .edge = edge,
                                      .line = line,
                                      .per_step = per_step,
                                      .dark_below = plan->is_closed[0] ? -BEYOND : start,
                                      .dark_above = plan->is_closed[1] ? BEYOND : end};
    for (size_t i = 0; i < count; i++) {
        const bool is_south = plan->by_cosine && plan->degrees[i] >= 90;
        edge[i] = i == 0 ? -BEYOND : i + 1 == count ? BEYOND : plan->degrees[i] * DEGREE;
        line[i] = plan->by_cosine ? versine(plan->degrees[i], is_south) : plan->degrees[i] * DEGREE;
        if (i + 1 == count)
            continue;
        if (!plan->by_cosine)
            per_step[i] = 1 / ((plan->degrees[i + 1] - plan->degrees[i]) * DEGREE);
        else
            per_step[i] = 1 / (versine(plan->degrees[i + 1], is_south) - line[i]);
    }
    per_step[count - 1] = 0;
    for (size_t k = 0; k < buckets; k++) { /* a little below, for what rounding does */
        const double at = start + ((double)k - 1e-3) / lines->per_radian;
        while (cell + 2 < count && edge[cell + 1] <= at)
            cell++;
        first[k] = cell;
    }
    room->doubles += 3 * count;
    room->indices += buckets;
}

static void make_single_lines(const struct lx_lines_double *lines, struct room *room, struct lx_lines_single *single)
{
    const size_t count = lines->cells + 1;
    float *edge = room->singles, *line = edge + count, *per_step = line + count;
    for (size_t i = 0; i < count; i++) {
        edge[i] = (float)lines->edge[i];
        line[i] = (float)lines->line[i];
        per_step[i] = (float)lines->per_step[i];
    }
    *single = (struct lx_lines_single){.cells = lines->cells,
                                       .last = lines->last,
                                       .start = (float)lines->start,
                                       .per_radian = (float)lines->per_radian,
                                       .even = (float)lines->even,
                                       .first = lines->first,
                                       .edge = edge,
                                       .line = line,
                                       .per_step = per_step,
                                       .dark_below = (float)lines->dark_below,
                                       .dark_above = (float)lines->dark_above};
    room->singles += 3 * count;
}

static bool make_tables(struct lx_distribution *made)
{
    const bool turns = is_turn(made), by_cosine = made->interpolation == LUXEL_INTERPOLATE_COSINE;
    const size_t row = made->polar_count, count = made->azimuth_count * row;
    const struct plan_of_lines azimuth = {made->azimuths, made->azimuth_count, .is_closed = {turns, turns}};
    const struct plan_of_lines polar = {
        made->polars, row, by_cosine, {made->polars[0] <= 0, made->polars[row - 1] >= 180}};
    const size_t numbers = 3 * (azimuth.count + polar.count), buckets = bucket_count(&azimuth) + bucket_count(&polar);
    char *bytes =
        lx_new_aligned(1, numbers * sizeof(double) + (numbers + count) * sizeof(float) + buckets * sizeof(uint32_t));
    made->room = bytes;
    if (!bytes)
        return false;
    struct room room = {.doubles = (double *)bytes, .singles = (float *)(bytes + numbers * sizeof(double))};
    float *values = room.singles + numbers;
    room.indices = (uint32_t *)(values + count);
    made->table_double =
        (struct lx_table_double){.is_axial = is_axial(made), .by_cosine = by_cosine, .values = made->values};
    made->table_double.south = first_south(&polar);
    make_lines(&azimuth, &room, &made->table_double.azimuth);
    make_lines(&polar, &room, &made->table_double.polar);
    made->table_single = (struct lx_table_single){.is_axial = made->table_double.is_axial,
                                                  .by_cosine = by_cosine,
                                                  .south = made->table_double.south,
                                                  .values = values};
    make_single_lines(&made->table_double.azimuth, &room, &made->table_single.azimuth);
    make_single_lines(&made->table_double.polar, &room, &made->table_single.polar);
    for (size_t i = 0; i < count; i++)
        values[i] = (float)made->values[i];
    return true;
}

/* ---- the whole ---- */

struct lx_distribution *lx_distribution_make(struct lx_photometry *photometry,
                                             luxel_photometry_interpolation interpolation)
{
    luxel_photometry_figures figures;
    struct lx_distribution *made = lx_new_array(1, sizeof *made);
    if (!made)
        return NULL;
    lx_kept_init(&made->kept, lx_distribution_free_of(interpolation));
    lx_kept_hold(&photometry->kept);
    made->photometry = photometry;
    made->interpolation = interpolation;
    if (!make_grid(made) || luxel_photometry_find_figures(&photometry->shown, &figures) != LUXEL_OK ||
        !make_tables(made) || !lx_even_table_make(made, &made->even)) {
        clear(made);
        return NULL;
    }
    made->zone_lumens = figures.zone_lumens;
    made->solid_angle =
        (interpolation == LUXEL_INTERPOLATE_ANGLE ? figures.linear_lumens : figures.zone_lumens) / made->unit_cd;
    made->slope = slope_of(made);
    return made;
}

/* SPDX-License-Identifier: MIT */
/* Tables on lines that are equally far apart. */
#include "distribution_even.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "distribution.h"

static const double DEGREE = 0.017453292519943295;

/* A step is the least one divided by no more than this; and there are no more cells than this. */
enum { MOST_PARTS = 8, MOST_CELLS = 1 << 18 };

/* Where a new line lies among those that were there: behind one, by a share of the step to the next. */
struct between {
    size_t line;
    double share;
};

static bool is_measure(const double *degrees, size_t count, double step)
{
    for (size_t i = 1; i < count; i++) {
        const double steps = (degrees[i] - degrees[0]) / step;
        if (fabs(steps - round(steps)) > 1e-9 * fmax(steps, 1))
            return false;
    }
    return true;
}

/* How many equal cells have a line wherever there is one; 0: none of those that are tried. */
static size_t count_cells(const double *degrees, size_t count)
{
    double least = HUGE_VAL;
    if (count < 2)
        return 0;
    const double whole = degrees[count - 1] - degrees[0];
    for (size_t i = 1; i < count; i++)
        least = fmin(least, degrees[i] - degrees[i - 1]);
    for (int parts = 1; parts <= MOST_PARTS; parts++)
        if (is_measure(degrees, count, least / parts) && whole / least * parts < MOST_CELLS)
            return (size_t)round(whole / least * parts);
    return 0;
}

static double place_of(double degrees, bool by_cosine)
{
    return by_cosine ? cos(degrees * DEGREE) : degrees;
}

/* Where cells + 1 lines lie. */
static void find_between(const double *degrees, size_t count, size_t cells, bool by_cosine, struct between *between)
{
    const double whole = degrees[count - 1] - degrees[0];
    size_t line = 0;
    for (size_t i = 0; i <= cells; i++) {
        const double angle = degrees[0] + whole * (double)i / (double)cells;
        while (line + 2 < count && angle >= degrees[line + 1] - 1e-9)
            line++;
        const double from = place_of(degrees[line], by_cosine), to = place_of(degrees[line + 1], by_cosine);
        const double share = (place_of(angle, by_cosine) - from) / (to - from);
        between[i] = (struct between){line, fmax(0, fmin(share, 1))};
    }
}

static double value_at(const struct lx_distribution *distribution, struct between azimuth, struct between polar)
{
    const double *near = distribution->values + azimuth.line * distribution->polar_count + polar.line;
    const double *far = near + distribution->polar_count;
    const double first = near[0] + polar.share * (near[1] - near[0]);
    if (azimuth.share == 0)
        return first;
    return first + azimuth.share * (far[0] + polar.share * (far[1] - far[0]) - first);
}

static void fill(const struct lx_distribution *distribution, const struct between *azimuths,
                 const struct between *polars, bool is_axial, struct lx_even_table *even)
{
    lx_even_cell *cell = even->cells;
    for (size_t i = 0; i < even->azimuth.cells; i++) {
        const struct between next = azimuths[is_axial ? i : i + 1];
        for (size_t j = 0; j < even->polar.cells; j++, cell++) {
            const double near = value_at(distribution, azimuths[i], polars[j]);
            const double along = value_at(distribution, azimuths[i], polars[j + 1]) - near;
            const double far = value_at(distribution, next, polars[j]);
            (*cell)[0] = (float)near;
            (*cell)[1] = (float)along;
            (*cell)[2] = (float)(far - near);
            (*cell)[3] = (float)(value_at(distribution, next, polars[j + 1]) - far - along);
        }
    }
}

static struct lx_even_lines lines_of(const double *degrees, size_t count, size_t cells)
{
    const double whole = degrees[count - 1] - degrees[0];
    return (struct lx_even_lines){
        .cells = cells, .start = degrees[0] * DEGREE, .per_radian = (double)cells / (whole * DEGREE)};
}

bool lx_even_table_make(const struct lx_distribution *distribution, struct lx_even_table *even)
{
    const bool is_axial = distribution->table_double.is_axial;
    const size_t polars = count_cells(distribution->polars, distribution->polar_count);
    const size_t planes = count_cells(distribution->azimuths, distribution->azimuth_count);
    const size_t azimuths = is_axial && planes > 0 ? 1 : planes;
    const double *azimuth = distribution->azimuths, *polar = distribution->polars;
    *even = (struct lx_even_table){.cells = NULL};
    if (polars == 0 || azimuths == 0 || azimuths > MOST_CELLS / polars)
        return true;
    even->azimuth = lines_of(azimuth, distribution->azimuth_count, azimuths);
    even->polar = lines_of(polar, distribution->polar_count, polars);
    even->is_turn = azimuth[distribution->azimuth_count - 1] - azimuth[0] >= 360;
    even->azimuth.is_closed[0] = even->azimuth.is_closed[1] = even->is_turn;
    even->polar.is_closed[0] = polar[0] <= 0;
    even->polar.is_closed[1] = polar[distribution->polar_count - 1] >= 180;
    even->cells = lx_new_aligned(azimuths * polars, sizeof *even->cells);
    even->cosines = lx_new_array(polars + 1, sizeof *even->cosines);
    struct between *between = lx_new_array(azimuths + polars + 2, sizeof *between);
    if (even->cells && even->cosines && between) {
        find_between(azimuth, distribution->azimuth_count, azimuths, false, between);
        find_between(polar, distribution->polar_count, polars,
                     distribution->interpolation == LUXEL_INTERPOLATE_COSINE, between + azimuths + 1);
        for (size_t j = 0; j <= polars; j++)
            even->cosines[j] = cos(even->polar.start + (double)j / even->polar.per_radian);
        fill(distribution, between, between + azimuths + 1, is_axial, even);
    }
    const bool complete = even->cells && even->cosines && between;
    free(between);
    return complete;
}

void lx_even_table_clear(struct lx_even_table *even)
{
    free(even->cells);
    free(even->cosines);
    *even = (struct lx_even_table){.cells = NULL};
}

/* Not fmaxf(), which is a call. */
static float greater(float a, float b)
{
    return a > b ? a : b;
}

struct lx_even_extent lx_even_extent_of(const struct lx_even_table *even, const size_t first[2], const size_t count[2])
{
    float greatest = 0, along = 0, across = 0;
    for (size_t i = 0; i < count[0]; i++) {
        const size_t row = (first[0] + i) % even->azimuth.cells;
        const lx_even_cell *cells = even->cells + row * even->polar.cells + first[1];
        for (size_t j = 0; j < count[1]; j++) {
            const float *cell = cells[j], end = cell[0] + cell[1], far = cell[0] + cell[2];
            const float corner = end + cell[2] + cell[3];
            greatest = greater(greatest, greater(greater(cell[0], end), greater(far, corner)));
            along = greater(along, greater(fabsf(cell[1]), fabsf(cell[1] + cell[3])));
            across = greater(across, greater(fabsf(cell[2]), fabsf(cell[2] + cell[3])));
        }
    }
    return (struct lx_even_extent){(double)greatest, (double)along, (double)across};
}

/* SPDX-License-Identifier: MIT */
/* Statistics of a field, gathered row by row and put together in the order of the rows. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../shade/kernel.h"
#include "field.h"
#include "gather.h"

struct lx_row_statistics lx_gather_row(const struct luxel_field *field, unsigned row)
{
    struct lx_row_statistics result = {.maximum = -HUGE_VAL, .minimum = HUGE_VAL};
    const size_t first = (size_t)row * field->columns;
    const uint8_t *mask = &field->mask[first];
    double sums[LX_LANES] = {0}; /* as the kernels sum */
    for (unsigned i = 0; i < field->columns; i++) {
        if (!mask[i])
            continue;
        double value = lx_field_value(field, first + i);
        result.surface_pixels++;
        sums[i % LX_LANES] += value;
        /* A value that is no number must not hide: it becomes the maximum. */
        if (!(value <= result.maximum))
            result.maximum = value;
        if (!(value >= LX_LEAST_LIT))
            continue;
        result.lit_pixels++;
        result.minimum = fmin(result.minimum, value);
    }
    for (int k = 0; k < LX_LANES; k++)
        result.sum += sums[k];
    return result;
}

/* The first pixel of a row with this value, or, where that is no number, without one. */
static luxel_extremum find_extremum(const struct luxel_field *field, unsigned row, double value)
{
    size_t pixel = (size_t)row * field->columns, last = pixel + field->columns - 1;
    for (; pixel < last; pixel++) {
        double there = lx_field_value(field, pixel);
        if (field->mask[pixel] && (there == value || (isnan(there) && isnan(value))))
            break;
    }
    return lx_extremum_at(field, pixel, value);
}

void lx_finish_statistics(struct luxel_field *field, const struct lx_row_statistics *rows)
{
    luxel_statistics *all = &field->statistics;
    const struct lx_row_statistics *highest = NULL, *lowest = NULL;
    size_t lit = 0;
    double sum = 0;
    *all = (luxel_statistics){0};
    for (unsigned row = 0; row < field->rows; row++) {
        const struct lx_row_statistics *one = &rows[row];
        if (one->surface_pixels == 0)
            continue;
        if (!highest || !(one->maximum <= highest->maximum))
            highest = one;
        if (one->lit_pixels > 0 && (!lowest || one->minimum < lowest->minimum))
            lowest = one;
        all->surface_pixels += one->surface_pixels;
        lit += one->lit_pixels;
        sum += one->sum;
    }
    if (highest)
        all->maximum = find_extremum(field, (unsigned)(highest - rows), highest->maximum);
    if (lowest)
        all->minimum = find_extremum(field, (unsigned)(lowest - rows), lowest->minimum);
    all->has_surface = all->surface_pixels > 0;
    if (all->has_surface) {
        all->mean = sum / (double)all->surface_pixels;
        all->lit = (double)lit / (double)all->surface_pixels;
    }
}

int lx_gather_statistics(struct luxel_field *field)
{
    struct lx_row_statistics *rows = lx_new_array(field->rows, sizeof *rows);
    if (!rows)
        return -1;
    for (unsigned row = 0; row < field->rows; row++)
        rows[row] = lx_gather_row(field, row);
    lx_finish_statistics(field, rows);
    free(rows);
    return 0;
}

/* SPDX-License-Identifier: MIT */
/* Statistics of a field, gathered row by row and put together in the order of the rows. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "field.h"

struct lx_row_statistics lx_gather_row(const struct luxel_field *field, unsigned row)
{
    struct lx_row_statistics result = {.maximum = -HUGE_VAL, .minimum = HUGE_VAL};
    const size_t first = (size_t)row * field->columns;
    const uint8_t *mask = &field->mask[first];
    for (unsigned i = 0; i < field->columns; i++) {
        if (!mask[i])
            continue;
        double value = lx_field_value(field, first + i);
        result.surface_pixels++;
        result.sum += value;
        /* A value that is no number must not hide: it becomes the maximum. */
        if (!(value <= result.maximum)) {
            result.maximum = value;
            result.maximum_column = i;
        }
        if (!(value >= LX_LEAST_LIT))
            continue;
        result.lit_pixels++;
        if (value < result.minimum) {
            result.minimum = value;
            result.minimum_column = i;
        }
    }
    return result;
}

static luxel_extremum extremum(const struct luxel_field *field, double value, unsigned column, unsigned row)
{
    return (luxel_extremum){
        .exists = true,
        .value = value,
        .column = column,
        .row = row,
        .x_mm = field->x_mm ? field->x_mm[column] : (double)NAN,
        .y_mm = field->y_mm ? field->y_mm[row] : (double)NAN,
    };
}

void lx_finish_statistics(struct luxel_field *field, const struct lx_row_statistics *rows)
{
    luxel_statistics *all = &field->statistics;
    size_t lit = 0;
    double sum = 0;
    *all = (luxel_statistics){0};
    for (unsigned row = 0; row < field->rows; row++) {
        const struct lx_row_statistics *one = &rows[row];
        if (one->surface_pixels == 0)
            continue;
        if (!all->maximum.exists || !(one->maximum <= all->maximum.value))
            all->maximum = extremum(field, one->maximum, one->maximum_column, row);
        if (one->lit_pixels > 0 && (!all->minimum.exists || one->minimum < all->minimum.value))
            all->minimum = extremum(field, one->minimum, one->minimum_column, row);
        all->surface_pixels += one->surface_pixels;
        lit += one->lit_pixels;
        sum += one->sum;
    }
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

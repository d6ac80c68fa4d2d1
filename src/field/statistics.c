/* SPDX-License-Identifier: MIT */
/* Statistics of a field, gathered row by row and put together in the order of the rows. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../kernel/kernel.h"
#include "field.h"
#include "gather.h"

/* Whether a value takes the place of the maximum so far.  One that is no number must not hide: it does, and stays. */
static bool exceeds(double value, double maximum)
{
    return !isnan(maximum) && !(value <= maximum);
}

struct lx_row_statistics lx_gather_row(const struct luxel_field *field, const struct lx_strip *strip, unsigned row)
{
    struct lx_row_statistics result = {.maximum = -HUGE_VAL, .minimum = HUGE_VAL, .reached = HUGE_VAL};
    const size_t first = (size_t)(row - strip->first) * field->columns;
    const uint8_t *mask = &strip->mask[first];
    double sums[LX_LANES] = {0}; /* as the kernels sum */
    for (unsigned i = 0; i < field->columns; i++) {
        if (!mask[i])
            continue;
        double value = lx_strip_value(field, strip, first + i);
        result.surface_pixels++;
        sums[i % LX_LANES] += value;
        if (exceeds(value, result.maximum))
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
static luxel_extremum find_extremum(const struct luxel_field *field, const struct lx_strip *strip, unsigned row,
                                    double value)
{
    const size_t first = (size_t)row * field->columns, last = first + field->columns - 1;
    size_t pixel = first;
    for (; pixel < last; pixel++) {
        double there = lx_strip_value(field, strip, pixel);
        if (strip->mask[pixel] && (there == value || (isnan(there) && isnan(value))))
            break;
    }
    return lx_extremum_at(field, (size_t)strip->first * field->columns + pixel, value);
}

/* Each extremum is looked for in one row of a strip at most. */
void lx_tally_add(struct lx_tally *tally, const struct luxel_field *field, const struct lx_strip *strip,
                  const struct lx_row_statistics *rows)
{
    luxel_statistics *so_far = &tally->so_far;
    const struct lx_row_statistics *highest = NULL, *lowest = NULL, *reached = NULL;
    for (unsigned i = 0; i < strip->rows; i++) {
        const struct lx_row_statistics *one = &rows[i];
        if (one->surface_pixels == 0)
            continue;
        if (!highest || exceeds(one->maximum, highest->maximum))
            highest = one;
        if (one->lit_pixels > 0 && (!lowest || one->minimum < lowest->minimum))
            lowest = one;
        if (one->reached < HUGE_VAL && (!reached || one->reached < reached->reached))
            reached = one;
        so_far->surface_pixels += one->surface_pixels;
        tally->lit_pixels += one->lit_pixels;
        tally->sum += one->sum;
    }
    if (highest && (!so_far->maximum.exists || exceeds(highest->maximum, so_far->maximum.value)))
        so_far->maximum = find_extremum(field, strip, (unsigned)(highest - rows), highest->maximum);
    if (lowest && !(so_far->minimum.exists && lowest->minimum >= so_far->minimum.value))
        so_far->minimum = find_extremum(field, strip, (unsigned)(lowest - rows), lowest->minimum);
    if (reached && !(so_far->minimum_reached.exists && reached->reached >= so_far->minimum_reached.value)) {
        const size_t row = (size_t)strip->first + (size_t)(reached - rows);
        so_far->minimum_reached =
            lx_extremum_at(field, row * field->columns + reached->reached_column, reached->reached);
    }
}

luxel_statistics lx_tally_finish(const struct lx_tally *tally)
{
    luxel_statistics all = tally->so_far;
    all.has_surface = all.surface_pixels > 0;
    all.reflected_reached = true;
    if (all.has_surface) {
        all.mean = tally->sum / (double)all.surface_pixels;
        all.lit = (double)tally->lit_pixels / (double)all.surface_pixels;
    }
    return all;
}

int lx_gather_statistics(struct luxel_field *field)
{
    const struct lx_strip all = lx_whole_strip(field);
    struct lx_tally tally = {0};
    struct lx_row_statistics *rows = lx_new_array(field->rows, sizeof *rows);
    if (!rows)
        return -1;
    for (unsigned row = 0; row < field->rows; row++)
        rows[row] = lx_gather_row(field, &all, row);
    lx_tally_add(&tally, field, &all, rows);
    field->statistics = lx_tally_finish(&tally);
    free(rows);
    return 0;
}

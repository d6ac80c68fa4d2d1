/* SPDX-License-Identifier: MIT */
/* Gathering the values of a region. */
#include "gather.h"

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "region.h"

luxel_extremum lx_extremum_at(const struct luxel_field *field, size_t pixel, double value)
{
    unsigned column = (unsigned)(pixel % field->columns), row = (unsigned)(pixel / field->columns);
    return (luxel_extremum){
        .exists = true,
        .value = value,
        .column = column,
        .row = row,
        .x_mm = field->x_mm ? field->x_mm[column] : (double)NAN,
        .y_mm = field->y_mm ? field->y_mm[row] : (double)NAN,
    };
}

static luxel_status check(const struct luxel_field *field, const luxel_region *region, luxel_diagnostics *diagnostics)
{
    luxel_status status = lx_region_check(region, diagnostics);
    if (status == LUXEL_OK && region && region->type != LUXEL_REGION_ALL && (!field->x_mm || !field->y_mm))
        status = lx_no_places(diagnostics);
    return status;
}

luxel_status lx_no_places(luxel_diagnostics *diagnostics)
{
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FIELD_WITHOUT_PLACES, NULL);
    lx_hint(diagnostics, LX_MSG_FILES_WITH_PLACES, NULL);
    return LUXEL_ERROR_ARGUMENT;
}

luxel_status lx_not_finite(const struct luxel_field *field, size_t pixel, luxel_diagnostics *diagnostics)
{
    struct lx_text place = {0};
    lx_text_printf(&place, "(%zu, %zu)", pixel % field->columns, pixel / field->columns);
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FIELD_NOT_FINITE, LX_ARGS(place.bytes));
    lx_text_clear(&place);
    return LUXEL_ERROR_ARGUMENT;
}

luxel_status lx_gather_region(const struct luxel_field *field, const luxel_region *region,
                              luxel_diagnostics *diagnostics, struct lx_gathered *gathered)
{
    bool whole = !region || region->type == LUXEL_REGION_ALL;
    luxel_status status = check(field, region, diagnostics);
    *gathered = (struct lx_gathered){0};
    if (status != LUXEL_OK)
        return status;
    gathered->values = lx_new_array((size_t)field->columns * field->rows, sizeof *gathered->values);
    if (!gathered->values)
        return lx_out_of_memory(diagnostics);
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (size_t i = 0; i < (size_t)field->columns * field->rows; i++) {
        if (!field->mask[i] ||
            !(whole || luxel_region_holds(region, field->x_mm[i % field->columns], field->y_mm[i / field->columns])))
            continue;
        double value = lx_field_value(field, i);
        if (!isfinite(value)) {
            free(gathered->values);
            *gathered = (struct lx_gathered){0};
            return lx_not_finite(field, i, diagnostics);
        }
        gathered->values[gathered->count++] = value;
        if (value < least) {
            least = value;
            gathered->least = i;
        }
        if (value > greatest) {
            greatest = value;
            gathered->greatest = i;
        }
    }
    return LUXEL_OK;
}

static void swap(double *a, double *b)
{
    double kept = *a;
    *a = *b;
    *b = kept;
}

/* The middle one of three. */
static double middle(double a, double b, double c)
{
    return fmax(fmin(a, b), fmin(fmax(a, b), c));
}

/* Hoare's selection; equal values end on both sides, so that many of them do not slow it down. */
double lx_select(double *values, size_t count, size_t k)
{
    size_t low = 0, high = count - 1;
    while (low < high) {
        double pivot = middle(values[low], values[low + (high - low) / 2], values[high]);
        size_t i = low, j = high;
        for (;;) {
            while (values[i] < pivot)
                i++;
            while (values[j] > pivot)
                j--;
            if (i >= j)
                break;
            swap(&values[i++], &values[j--]);
        }
        /* all up to j are at most the pivot, all from j + 1 on at least */
        if (k <= j)
            high = j;
        else
            low = j + 1;
    }
    return values[k];
}

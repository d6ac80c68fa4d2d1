/* SPDX-License-Identifier: MIT */
/* Comparing two fields pixel by pixel. */
#include <luxel/compare.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/wide.h"
#include "gather.h"

/* Places that near to each other, in pixels, are the same: files hold them with fewer digits. */
static const double SAME_PLACE = 1e-6;

static bool same_places(const double *a, const double *b, unsigned count)
{
    if (!a || !b)
        return true;
    double pixel = count > 1 ? fabs(a[1] - a[0]) : 1;
    for (unsigned i = 0; i < count; i++)
        if (!(fabs(a[i] - b[i]) <= SAME_PLACE * pixel + 1e-9 * fabs(a[i])))
            return false;
    return true;
}

static luxel_status check(const struct luxel_field *a, const struct luxel_field *b, luxel_diagnostics *diagnostics)
{
    if (a->columns != b->columns || a->rows != b->rows) {
        char sizes[4][LX_NUMBER_SIZE];
        return lx_refuse(diagnostics, LX_MSG_OTHER_RESOLUTION,
                         LX_ARGS(lx_write_number(a->columns, sizes[0]), lx_write_number(a->rows, sizes[1]),
                                 lx_write_number(b->columns, sizes[2]), lx_write_number(b->rows, sizes[3])));
    }
    if (!same_places(a->x_mm, b->x_mm, a->columns) || !same_places(a->y_mm, b->y_mm, a->rows))
        return lx_refuse(diagnostics, LX_MSG_OTHER_PLACES, NULL);
    return LUXEL_OK;
}

/* An empty field of A's size and unit for the differences, NULL when memory is short. */
static struct luxel_field *new_difference(const struct luxel_field *a, const struct luxel_field *b)
{
    const struct luxel_field *placed = a->x_mm && a->y_mm ? a : b;
    size_t pixels = (size_t)a->columns * a->rows;
    bool is_double = a->precision == LUXEL_DOUBLE || b->precision == LUXEL_DOUBLE;
    struct luxel_field *made = lx_new_array(1, sizeof *made);
    if (!made)
        return NULL;
    *made = (struct luxel_field){
        .columns = a->columns,
        .rows = a->rows,
        .quantity = a->quantity,
        .quantity_word = a->quantity_word,
        .precision = is_double ? LUXEL_DOUBLE : LUXEL_SINGLE,
        .instruction_set = "",
        .unit = lx_copy_text(*a->unit ? a->unit : b->unit, strlen(*a->unit ? a->unit : b->unit)),
        .values = lx_new_aligned(pixels, is_double ? sizeof(double) : sizeof(float)),
        .mask = lx_new_array(pixels, 1),
    };
    bool whole = made->unit && made->values && made->mask;
    if (placed->x_mm && placed->y_mm) {
        made->x_mm = lx_new_array(a->columns, sizeof *made->x_mm);
        made->y_mm = lx_new_array(a->rows, sizeof *made->y_mm);
        whole = whole && made->x_mm && made->y_mm;
        if (whole) {
            memcpy(made->x_mm, placed->x_mm, a->columns * sizeof *made->x_mm);
            memcpy(made->y_mm, placed->y_mm, a->rows * sizeof *made->y_mm);
        }
    }
    if (whole)
        return made;
    luxel_field_free(made);
    return NULL;
}

static void store(struct luxel_field *difference, size_t pixel, double value, bool shown)
{
    if (difference->precision == LUXEL_DOUBLE)
        ((double *)difference->values)[pixel] = value;
    else
        ((float *)difference->values)[pixel] = (float)value;
    difference->mask[pixel] = shown;
}

/* What is summed on the way; squares are of values over the largest so far known scale, so that none overflows. */
struct sums {
    lx_wide signed_sum, magnitudes;
    double squares, scale;
};

static void add_square(struct sums *sums, double magnitude)
{
    if (magnitude > sums->scale) {
        double ratio = sums->scale / magnitude;
        sums->squares *= ratio * ratio;
        sums->scale = magnitude;
    }
    if (magnitude > 0)
        sums->squares += magnitude / sums->scale * (magnitude / sums->scale);
}

static luxel_status walk(const struct luxel_field *a, const struct luxel_field *b, luxel_diagnostics *diagnostics,
                         luxel_comparison *made, struct luxel_field *difference)
{
    struct sums sums = {.signed_sum = lx_wide_of(0), .magnitudes = lx_wide_of(0)};
    const struct luxel_field *placed = a->x_mm && a->y_mm ? a : b;
    for (size_t i = 0; i < (size_t)a->columns * a->rows; i++) {
        /* where one of them only guesses what is a surface, the other one knows */
        bool in_mask_a = a->mask_is_guess && !b->mask_is_guess ? b->mask[i] : a->mask[i];
        bool in_mask_b = b->mask_is_guess && !a->mask_is_guess ? a->mask[i] : b->mask[i];
        bool shown = in_mask_a && in_mask_b;
        double in_a = lx_field_value(a, i), in_b = lx_field_value(b, i), away = shown ? in_b - in_a : 0;
        if (!isfinite(in_a) || !isfinite(in_b))
            return lx_not_finite(isfinite(in_a) ? b : a, i, diagnostics);
        made->only_a += in_mask_a && !in_mask_b;
        made->only_b += in_mask_b && !in_mask_a;
        if (difference)
            store(difference, i, away, shown);
        if (!shown)
            continue;
        double magnitude = fabs(away);
        made->pixels++;
        made->scale = fmax(made->scale, fmax(fabs(in_a), fabs(in_b)));
        sums.signed_sum = lx_wide_add(sums.signed_sum, lx_wide_of(away));
        sums.magnitudes = lx_wide_add(sums.magnitudes, lx_wide_of(magnitude));
        add_square(&sums, magnitude);
        if (!made->largest.exists || magnitude > made->largest.value) {
            made->largest = lx_extremum_at(placed, i, magnitude);
            made->a = in_a;
            made->b = in_b;
        }
    }
    if (made->pixels > 0) {
        double count = (double)made->pixels;
        made->mean = lx_wide_value(sums.signed_sum) / count;
        made->mean_magnitude = lx_wide_value(sums.magnitudes) / count;
        made->rms = sums.scale * sqrt(sums.squares / count);
    }
    if (made->scale > 0) {
        made->largest_relative = made->largest.value / made->scale;
        made->rms_relative = made->rms / made->scale;
    }
    return LUXEL_OK;
}

luxel_status luxel_compare(const luxel_field *a, const luxel_field *b, luxel_diagnostics *diagnostics,
                           luxel_comparison *comparison, luxel_field **difference)
{
    struct luxel_field *made = NULL;
    *comparison = (luxel_comparison){0};
    luxel_status status = check(a, b, diagnostics);
    if (status == LUXEL_OK && difference) {
        made = new_difference(a, b);
        status = made ? LUXEL_OK : lx_out_of_memory(diagnostics);
    }
    if (status == LUXEL_OK)
        status = walk(a, b, diagnostics, comparison, made);
    if (status == LUXEL_OK && made) {
        /* grey levels: 0 is the middle, the largest difference black or white */
        double most = comparison->largest.value > 0 ? comparison->largest.value : 1;
        made->picture = (struct lx_picture){.range = {-1, -most, most}, .rounding = LX_NEAREST};
        status = lx_gather_statistics(made) < 0 ? lx_out_of_memory(diagnostics) : LUXEL_OK;
    }
    if (status == LUXEL_OK && difference)
        *difference = made;
    else
        luxel_field_free(made);
    return status;
}

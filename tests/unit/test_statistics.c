/* SPDX-License-Identifier: MIT */
/*
 * Summaries and histograms of fields whose values are chosen: numbers that are known by hand, edges of regions and of
 * bins, values at the ends of what a double holds, and what is refused.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "csv_field.h"

#define NONE ((double)NAN)

static luxel_summary summary_of(const luxel_field *field, const luxel_region *region)
{
    luxel_summary summary;
    assert_int_equal(luxel_field_summary(field, region, NULL, &summary), LUXEL_OK);
    return summary;
}

/* 3 x 4 pixels of the values 1 to 12, the last one off the surfaces. */
static luxel_field *dozen(void)
{
    const double values[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, NONE};
    return csv_field(values, 3, 4);
}

static void test_known_numbers(void **state)
{
    (void)state;
    luxel_field *field = dozen();
    luxel_summary all = summary_of(field, NULL);
    assert_int_equal(all.pixels, 11);
    assert_true(all.mean == 6 && all.median == 6);
    assert_true(all.standard_deviation == sqrt(10.0)); /* (n^2 - 1) / 12 of 1 to n */
    assert_true(all.lit == 1 && all.has_evenness);
    assert_true(all.u0 == 1.0 / 6 && all.ud == 1.0 / 11);
    assert_true(all.maximum.value == 11 && all.maximum.row == 2 && all.maximum.column == 2);
    assert_true(all.maximum.x_mm == 2 && all.maximum.y_mm == 0);
    assert_true(all.minimum.value == 1 && all.minimum.row == 0 && all.minimum.column == 0);
    assert_true(all.minimum.x_mm == 0 && all.minimum.y_mm == 2);
    luxel_field_free(field);
}

/* The median of an even number is the mean of the two in the middle, in whatever order they stand. */
static void test_even_median(void **state)
{
    (void)state;
    const double values[] = {9, 1, 8, 2};
    luxel_field *field = csv_field(values, 2, 2);
    assert_true(summary_of(field, NULL).median == 5);
    luxel_field_free(field);
}

/* The median against sorting, for many sizes and values that repeat. */
static int rising(const void *a, const void *b)
{
    return (*(const double *)a > *(const double *)b) - (*(const double *)a < *(const double *)b);
}

static void test_median_by_sorting(void **state)
{
    (void)state;
    uint64_t random = 1;
    for (unsigned columns = 2; columns < 60; columns++) {
        double values[120];
        for (unsigned i = 0; i < 2 * columns; i++) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            values[i] = (double)(random >> 60);
        }
        luxel_field *field = csv_field(values, 2, columns);
        double found = summary_of(field, NULL).median;
        qsort(values, 2 * (size_t)columns, sizeof *values, rising);
        assert_true(found == (values[columns - 1] + values[columns]) / 2);
        luxel_field_free(field);
    }
}

/* A pixel belongs to a region if its sample does, the edge included. */
static void test_regions(void **state)
{
    (void)state;
    luxel_field *field = dozen();
    luxel_region rectangle = {.type = LUXEL_REGION_RECTANGLE, .center_mm = {1, 1.5}, .size_mm = {2, 1}};
    luxel_summary part = summary_of(field, &rectangle); /* 1 2 3 and 5 6 7 */
    assert_int_equal(part.pixels, 6);
    assert_true(part.mean == 4 && part.median == 4 && part.maximum.value == 7 && part.minimum.value == 1);

    luxel_region circle = {.type = LUXEL_REGION_CIRCLE, .center_mm = {1, 1}, .radius_mm = 1};
    part = summary_of(field, &circle); /* 2, 5 6 7, 10 */
    assert_int_equal(part.pixels, 5);
    assert_true(part.mean == 6);

    luxel_region off = {
        .type = LUXEL_REGION_CIRCLE, .center_mm = {3, 0}, .radius_mm = 0.5}; /* the pixel without value */
    part = summary_of(field, &off);
    assert_int_equal(part.pixels, 0);
    assert_false(part.maximum.exists || part.minimum.exists || part.has_evenness);
    assert_true(part.mean == 0 && part.median == 0 && part.u0 == 0);
    luxel_field_free(field);
}

/* 0 is on the surface and dark: it counts in the minimum, the mean and the median, and is not lit. */
static void test_dark(void **state)
{
    (void)state;
    const double values[] = {0, 0, 0, 4}, nothing[] = {0, 0};
    luxel_field *field = csv_field(values, 1, 4);
    luxel_summary all = summary_of(field, NULL);
    assert_true(all.minimum.value == 0 && all.minimum.column == 0 && all.mean == 1 && all.median == 0);
    assert_true(all.lit == 0.25 && all.has_evenness && all.u0 == 0 && all.ud == 0);
    luxel_field_free(field);
    field = csv_field(nothing, 1, 2);
    all = summary_of(field, NULL);
    assert_true(!all.has_evenness && all.mean == 0 && all.lit == 0 && all.pixels == 2);
    luxel_field_free(field);
}

/* What lies on both sides of 0, as differences do, has no uniformity. */
static void test_below_0(void **state)
{
    (void)state;
    const double values[] = {-1, 2, 5};
    luxel_field *field = csv_field(values, 1, 3);
    luxel_summary all = summary_of(field, NULL);
    assert_true(all.mean == 2 && all.minimum.value == -1 && !all.has_evenness && all.u0 == 0 && all.ud == 0);
    luxel_field_free(field);
}

/* Neither a sum nor a square leaves the range of doubles, and small numbers are not lost beside large ones. */
static void test_ends_of_the_range(void **state)
{
    (void)state;
    const double large[] = {1e300, 3e300}, mixed[] = {1e16, 1, 1, 1};
    luxel_field *field = csv_field(large, 1, 2);
    luxel_summary all = summary_of(field, NULL);
    assert_true(fabs(all.mean / 2e300 - 1) < 1e-15 && fabs(all.median / 2e300 - 1) < 1e-15);
    assert_true(fabs(all.standard_deviation / 1e300 - 1) < 1e-15);
    luxel_field_free(field);
    field = csv_field(mixed, 1, 4);
    assert_true(summary_of(field, NULL).mean == (1e16 + 3) / 4);
    luxel_field_free(field);
}

/* What goes with a field: dark pixels count in the mean and not in the minimum, and of equal ones the first is told. */
static void test_of_field(void **state)
{
    (void)state;
    const double values[] = {0, 2, 7, NONE, 7, 2, 1e-300, 0}, dark[] = {0, 0, 0, 0};
    luxel_field *field = csv_field(values, 2, 4);
    const luxel_statistics *all = luxel_field_statistics(field);
    assert_true(all->has_surface && all->surface_pixels == 7);
    assert_true(fabs(all->mean - 18.0 / 7) < 1e-15);
    assert_true(all->maximum.value == 7 && all->maximum.row == 0 && all->maximum.column == 2);
    assert_true(all->minimum.value <= 2 && all->minimum.value > 0 && all->lit > 0.5 && all->lit < 1);
    luxel_field_free(field);
    field = csv_field((const double[]){3, 9, 9, 3, 3, 9}, 3, 2);
    all = luxel_field_statistics(field);
    assert_true(all->maximum.row == 0 && all->maximum.column == 1 && all->maximum.x_mm == 1 && all->maximum.y_mm == 2);
    assert_true(all->minimum.value == 3 && all->minimum.row == 0 && all->minimum.column == 0 && all->lit == 1);
    luxel_field_free(field);
    field = csv_field(dark, 2, 2);
    all = luxel_field_statistics(field);
    assert_true(all->mean == 0 && all->lit == 0 && all->maximum.exists && all->maximum.value == 0);
    assert_false(all->minimum.exists);
    luxel_field_free(field);
}

/* A value that is no number does not hide: wherever it stands it is the maximum. */
static void test_no_number(void **state)
{
    (void)state;
    static const char *const rows[] = {"0,0,nan\n1,0,5\n2,0,7\n", "0,0,5\n1,0,nan\n2,0,7\n", "0,0,5\n1,0,7\n2,0,nan\n"};
    for (unsigned i = 0; i < 3; i++) {
        char text[100];
        snprintf(text, sizeof text, "x_mm,y_mm,value_\n%s0,1,4\n0,-1,8\n", rows[i]); /* between other rows */
        luxel_field *field = field_of_csv(text);
        const luxel_statistics *all = luxel_field_statistics(field);
        assert_true(all->maximum.exists && isnan(all->maximum.value) && all->maximum.column == i &&
                    all->maximum.row == 1);
        assert_true(isnan(all->mean) && all->minimum.value == 4);
        luxel_field_free(field);
    }
}

static luxel_histogram *histogram_of(const luxel_field *field, luxel_histogram_scale scale, double low, double high,
                                     size_t bins)
{
    luxel_histogram *histogram = NULL;
    assert_int_equal(luxel_field_histogram(field, NULL, scale, low, high, bins, NULL, &histogram), LUXEL_OK);
    assert_int_equal(histogram->bins, bins);
    return histogram;
}

static void assert_counts(const luxel_histogram *histogram, const size_t *counts, size_t below, size_t above)
{
    size_t sum = histogram->below + histogram->above;
    for (size_t i = 0; i < histogram->bins; i++) {
        assert_int_equal(histogram->counts[i], counts[i]);
        sum += histogram->counts[i];
    }
    assert_int_equal(histogram->below, below);
    assert_int_equal(histogram->above, above);
    assert_int_equal(sum, histogram->pixels);
}

/* A bin takes in its lower edge, the last one both. */
static void test_histogram(void **state)
{
    (void)state;
    luxel_field *field = dozen();
    luxel_histogram *histogram = histogram_of(field, LUXEL_HISTOGRAM_LINEAR, NONE, NONE, 5); /* edges 1 3 5 7 9 11 */
    assert_true(histogram->edges[0] == 1 && histogram->edges[5] == 11);
    assert_counts(histogram, (const size_t[]){2, 2, 2, 2, 3}, 0, 0);
    luxel_histogram_free(histogram);

    histogram = histogram_of(field, LUXEL_HISTOGRAM_LINEAR, 2, 6, 2); /* edges 2 4 6 */
    assert_counts(histogram, (const size_t[]){2, 3}, 1, 5);
    luxel_histogram_free(histogram);

    histogram = histogram_of(field, LUXEL_HISTOGRAM_LOGARITHMIC, 1, 16, 4); /* edges 1 2 4 8 16 */
    for (int i = 0; i <= 4; i++)
        assert_true(fabs(histogram->edges[i] - (1 << i)) < 1e-14 * (1 << i));
    assert_int_equal(histogram->pixels, 11);
    luxel_histogram_free(histogram);
    luxel_field_free(field);
}

/* Logarithmic: what is 0 lies below the range, which begins at the least value above. */
static void test_logarithmic_range(void **state)
{
    (void)state;
    const double values[] = {0, 0, 1e-3, 1e3}, one[] = {5, 5}, dark[] = {0, 0};
    luxel_field *field = csv_field(values, 1, 4);
    luxel_histogram *histogram = histogram_of(field, LUXEL_HISTOGRAM_LOGARITHMIC, NONE, NONE, 2);
    assert_true(histogram->edges[0] == 1e-3 && histogram->edges[2] == 1e3);
    assert_counts(histogram, (const size_t[]){1, 1}, 2, 0);
    luxel_histogram_free(histogram);
    luxel_field_free(field);

    field = csv_field(one, 1, 2); /* a range of no size is widened about the value */
    for (int scale = LUXEL_HISTOGRAM_LINEAR; scale <= LUXEL_HISTOGRAM_LOGARITHMIC; scale++) {
        histogram = histogram_of(field, (luxel_histogram_scale)scale, NONE, NONE, 3);
        assert_true(histogram->edges[0] < 5 && histogram->edges[3] > 5);
        assert_counts(histogram, (const size_t[]){0, 2, 0}, 0, 0);
        luxel_histogram_free(histogram);
    }
    luxel_field_free(field);

    field = csv_field(dark, 1, 2);
    luxel_histogram *none = NULL;
    assert_int_equal(luxel_field_histogram(field, NULL, LUXEL_HISTOGRAM_LOGARITHMIC, NONE, NONE, 3, NULL, &none),
                     LUXEL_ERROR_ARGUMENT);
    histogram = histogram_of(field, LUXEL_HISTOGRAM_LINEAR, NONE, NONE, 3);
    assert_counts(histogram, (const size_t[]){0, 2, 0}, 0, 0);
    luxel_histogram_free(histogram);
    luxel_field_free(field);
}

static void test_refused(void **state)
{
    (void)state;
    luxel_field *field = dozen();
    luxel_summary summary;
    luxel_histogram *histogram = NULL;
    const luxel_region bad_regions[] = {
        {.type = LUXEL_REGION_CIRCLE, .radius_mm = 0},
        {.type = LUXEL_REGION_CIRCLE, .radius_mm = NONE},
        {.type = LUXEL_REGION_RECTANGLE, .size_mm = {1, -1}},
        {.type = LUXEL_REGION_RECTANGLE, .center_mm = {HUGE_VAL, 0}, .size_mm = {1, 1}},
    };
    for (size_t i = 0; i < sizeof bad_regions / sizeof bad_regions[0]; i++) {
        assert_int_equal(luxel_field_summary(field, &bad_regions[i], NULL, &summary), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(
            luxel_field_histogram(field, &bad_regions[i], LUXEL_HISTOGRAM_LINEAR, NONE, NONE, 5, NULL, &histogram),
            LUXEL_ERROR_ARGUMENT);
    }
    const struct {
        luxel_histogram_scale scale;
        double low, high;
        size_t bins;
    } bad[] = {{LUXEL_HISTOGRAM_LINEAR, NONE, NONE, 0},  {LUXEL_HISTOGRAM_LINEAR, NONE, NONE, 65537},
               {LUXEL_HISTOGRAM_LINEAR, 2, 2, 5},        {LUXEL_HISTOGRAM_LINEAR, 3, 2, 5},
               {LUXEL_HISTOGRAM_LINEAR, NONE, 2, 5},     {LUXEL_HISTOGRAM_LINEAR, 2, NONE, 5},
               {LUXEL_HISTOGRAM_LINEAR, 0, HUGE_VAL, 5}, {LUXEL_HISTOGRAM_LOGARITHMIC, 0, 2, 5}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_field_histogram(field, NULL, bad[i].scale, bad[i].low, bad[i].high, bad[i].bins,
                                               diagnostics, &histogram),
                         LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
        luxel_diagnostics_free(diagnostics);
    }
    assert_null(histogram);
    luxel_field_free(field);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_numbers),
        cmocka_unit_test(test_even_median),
        cmocka_unit_test(test_median_by_sorting),
        cmocka_unit_test(test_regions),
        cmocka_unit_test(test_dark),
        cmocka_unit_test(test_below_0),
        cmocka_unit_test(test_ends_of_the_range),
        cmocka_unit_test(test_of_field),
        cmocka_unit_test(test_no_number),
        cmocka_unit_test(test_histogram),
        cmocka_unit_test(test_logarithmic_range),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

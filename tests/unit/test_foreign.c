/* SPDX-License-Identifier: MIT */
/* Fields that are not of an evaluator's scene are refused by what looks at both, whatever in them differs. */
#include <math.h>
#include <stdlib.h>

#include <luxel/evaluator.h>
#include <luxel/extrema.h>
#include <luxel/isophotes.h>

#include "field/field.h"
#include "scenes.h"

struct both {
    luxel_scene *scene;
    luxel_field *field;
    luxel_evaluator *evaluator;
};

static void make(struct both *both)
{
    const char *const changes[] = {"screen.resolution=[24,16]", "screen.height=300", "screen.width=450"};
    both->scene = opened_with("report", changes, 3);
    assert_int_equal(luxel_render(both->scene, NULL, NULL, &both->field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(both->scene, NULL, NULL, &both->evaluator), LUXEL_OK);
}

static void clear(struct both *both)
{
    luxel_evaluator_free(both->evaluator);
    luxel_field_free(both->field);
    luxel_scene_free(both->scene);
}

static bool fits_extrema(const struct both *both)
{
    luxel_extrema extrema;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_status status = luxel_find_extrema(both->evaluator, both->field, NULL, diagnostics, &extrema);
    if (status != LUXEL_OK)
        expect_entry(diagnostics, 0, WANTED("foreign-field"));
    luxel_diagnostics_free(diagnostics);
    assert_true(status == LUXEL_OK || status == LUXEL_ERROR_ARGUMENT);
    return status == LUXEL_OK;
}

static bool fits_isophotes(const struct both *both)
{
    const double level = 5;
    luxel_isophotes *lines = NULL;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_status status = luxel_find_isophotes(both->field, both->evaluator, &level, 1, diagnostics, &lines);
    if (status != LUXEL_OK)
        expect_entry(diagnostics, 0, WANTED("other-scene"));
    luxel_isophotes_free(lines);
    luxel_diagnostics_free(diagnostics);
    assert_true(status == LUXEL_OK || status == LUXEL_ERROR_ARGUMENT);
    return status == LUXEL_OK;
}

static void expect_both(const struct both *both, bool fits)
{
    assert_int_equal(fits_extrema(both), fits);
    assert_int_equal(fits_isophotes(both), fits);
}

/* Any one of them, by the least that there is. */
static void every_place_counts(void **state)
{
    struct both both;
    (void)state;
    make(&both);
    expect_both(&both, true);
    for (int axis = 0; axis < 2; axis++) {
        double *places = axis ? both.field->y_mm : both.field->x_mm;
        const unsigned count = axis ? both.field->rows : both.field->columns;
        for (unsigned i = 0; i < count; i++) {
            const double kept = places[i];
            places[i] = nextafter(kept, HUGE_VAL);
            expect_both(&both, false);
            places[i] = kept;
        }
    }
    expect_both(&both, true);
    clear(&both);
}

static void numbers_of_pixels_and_quantity_count(void **state)
{
    struct both both;
    (void)state;
    make(&both);
    both.field->columns--;
    expect_both(&both, false);
    both.field->columns++, both.field->rows--;
    expect_both(&both, false);
    both.field->rows++, both.field->quantity = LUXEL_IRRADIANCE;
    expect_both(&both, false);
    clear(&both);
}

/* Lines are drawn through the picture's own values: its maximum must be what is found there, but for float32. */
static void the_maximum_counts(void **state)
{
    static const struct {
        double off, light_error;
        bool fits;
    } cases[] = {
        {0.9e-4, 0, true},      {-0.9e-4, 0, true},      {1.1e-4, 0, false},    {-1.1e-4, 0, false},
        {0.5, 0, false},        {-0.9, 0, false},        {1.05e-3, 1e-3, true}, {-1.05e-3, 1e-3, true},
        {1.15e-3, 1e-3, false}, {-1.15e-3, 1e-3, false},
    };
    struct both both;
    (void)state;
    make(&both);
    const double kept = both.field->statistics.maximum.value;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        both.field->statistics.maximum.value = kept * (1 + cases[i].off);
        both.field->light_error = cases[i].light_error;
        assert_int_equal(fits_isophotes(&both), cases[i].fits);
    }
    both.field->light_error = 0, both.field->statistics.maximum.value = 2 * kept;
    both.field->statistics.maximum.exists = false; /* nothing to compare */
    assert_true(fits_isophotes(&both));
    clear(&both);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_place_counts),
        cmocka_unit_test(numbers_of_pixels_and_quantity_count),
        cmocka_unit_test(the_maximum_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

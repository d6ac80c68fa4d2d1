/* SPDX-License-Identifier: MIT */
/* Numbered variants: good scenes with one pronounced peak in view, all different, the same for ever. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

enum { TRIED = 3000 };

/* The text without its comment, which holds the number. */
static char *scene_of(unsigned number)
{
    char *text;
    assert_int_equal(luxel_variant_text(number, NULL, &text), LUXEL_OK);
    char *scene = strdup(strstr(text, "luxel: 1\n"));
    luxel_text_free(text);
    assert_non_null(scene);
    return scene;
}

static void stays_the_same(void **state)
{
    (void)state;
    char *text;
    assert_int_equal(luxel_variant_text(1, NULL, &text), LUXEL_OK);
    assert_string_equal(
        text, "# Variant 1: the brightness of a sphere\n"
              "# By the rules of the published solution: the sources shine the same in all directions and are not\n"
              "# attenuated by the distance, the highlight is seen along z, values are those of the exact points.\n"
              "luxel: 1\n"
              "units: radiometric\n"
              "screen: {width: 1050, height: 900, resolution: [700, 600], sampling: nodes}\n"
              "observer: {z: 2700, projection: orthographic, view: parallel}\n"
              "surfaces:\n"
              "  - type: sphere\n"
              "    center: [150, -100, 1200]\n"
              "    radius: 300\n"
              "    material: {model: blinn-phong, diffuse: 0.5, specular: 0.3, shininess: 25, highlight: plain, "
              "over_pi: false}\n"
              "lights:\n"
              "  - {type: point, position: [1700, 3800, 5300], intensity: 25, pattern: isotropic, attenuation: none}\n"
              "points: [[150, -100], [300, -100], [0, -100], [150, 50], [150, -250]]\n"
              "picture: {range: max, rounding: truncate}\n");
    luxel_text_free(text);
}

/* FNV-1a over the first thousand and a thousand up to the last: no variant may ever change. */
static void has_the_same_bytes(void **state)
{
    (void)state;
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (unsigned i = 0; i < 2000; i++) {
        char *text;
        unsigned number = i < 1000 ? i + 1 : LUXEL_LAST_VARIANT - (i - 1000);
        assert_int_equal(luxel_variant_text(number, NULL, &text), LUXEL_OK);
        for (const char *at = text; *at; at++)
            hash = (hash ^ (unsigned char)*at) * UINT64_C(0x100000001b3);
        luxel_text_free(text);
    }
    assert_int_equal(hash, UINT64_C(0x688d2de32fd22448));
}

static int by_text(const void *one, const void *other)
{
    return strcmp(*(char *const *)one, *(char *const *)other);
}

static void are_all_different(void **state)
{
    (void)state;
    char *texts[TRIED];
    for (unsigned i = 0; i < TRIED; i++)
        texts[i] = scene_of(i + 1);
    qsort(texts, TRIED, sizeof *texts, by_text);
    for (unsigned i = 1; i < TRIED; i++)
        assert_string_not_equal(texts[i - 1], texts[i]);
    for (unsigned i = 0; i < TRIED; i++)
        free(texts[i]);
}

static luxel_scene *open_scene(unsigned number)
{
    luxel_scene *scene;
    char *text = scene_of(number);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    free(text);
    return scene;
}

/* Valid, and nothing to advise: so all numbers lie in their ranges, the sphere is in view and the peak stands out. */
static void deserve_no_advice(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    for (unsigned number = 1; number <= TRIED; number++) {
        luxel_scene *scene = open_scene(number);
        assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
        assert_int_equal(luxel_scene_advise_peak(scene, diagnostics), LUXEL_OK);
        if (luxel_diagnostics_count(diagnostics) > 0)
            fail_msg("variant %u: %s", number, luxel_diagnostics_get(diagnostics, 0)->id);
        luxel_scene_free(scene);
    }
    luxel_diagnostics_free(diagnostics);
}

/* All points are brighter than a thousandth of the maximum, and at most one is where no source shines. */
static void expect_points_that_show(const luxel_scene *scene, unsigned number, double maximum)
{
    unsigned dark = 0;
    for (size_t i = 0; i < luxel_scene_point_count(scene); i++) {
        double x, y, irradiance = 0;
        luxel_probe *probe;
        luxel_scene_point(scene, i, &x, &y);
        assert_int_equal(luxel_probe_screen(scene, NULL, x, y, NULL, &probe), LUXEL_OK);
        for (size_t k = 0; k < probe->share_count; k++)
            irradiance += probe->shares[k].irradiance;
        if (!(probe->value > 1e-3 * maximum))
            fail_msg("variant %u, P%zu: %g of %g", number, i + 1, probe->value, maximum);
        dark += irradiance == 0;
        luxel_probe_free(probe);
    }
    assert_true(dark <= 1);
}

/* The continuous maximum, by the exact function: well inside the sphere, and over twice the mean; and what the points
 * are beside it. */
static void have_a_peak(void **state)
{
    (void)state;
    for (unsigned number = 1; number <= TRIED; number += number < 300 ? 1 : 7) {
        luxel_scene *scene = open_scene(number);
        luxel_field *field;
        luxel_evaluator *evaluator;
        luxel_extrema extrema;
        assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
        assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
        assert_int_equal(luxel_find_extrema(evaluator, field, NULL, NULL, &extrema), LUXEL_OK);
        const luxel_peak *peak = &extrema.maximum;
        assert_int_equal(peak->place, LUXEL_PEAK_INSIDE);
        assert_true(peak->normal[2] > 0.6 && peak->normal[2] < 0.99);
        assert_true(peak->value > 2 * luxel_field_statistics(field)->mean);
        expect_points_that_show(scene, number, peak->value);
        luxel_evaluator_free(evaluator);
        luxel_field_free(field);
        luxel_scene_free(scene);
    }
}

static void have_five_points(void **state)
{
    (void)state;
    for (unsigned number = 1; number <= TRIED; number++) {
        luxel_scene *scene = open_scene(number);
        luxel_evaluator *evaluator;
        assert_int_equal(luxel_scene_point_count(scene), 5);
        assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
        assert_int_equal(luxel_evaluator_light_count(evaluator), number % 3 == 0 ? 2 : 1);
        for (size_t i = 0; i < 5; i++) {
            double x, y;
            luxel_scene_point(scene, i, &x, &y);
            luxel_value value;
            luxel_evaluate_screen(evaluator, x, y, &value, NULL);
            assert_true(value.on_surface && value.normal[2] > 0.6);
            assert_true(i > 0 || value.value > 0);
        }
        luxel_evaluator_free(evaluator);
        luxel_scene_free(scene);
    }
}

static void refuses_other_numbers(void **state)
{
    (void)state;
    static const unsigned wrong[] = {0, LUXEL_LAST_VARIANT + 1, 4294967295u};
    for (size_t i = 0; i < 3; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        char *text = NULL;
        assert_int_equal(luxel_variant_text(wrong[i], diagnostics, &text), LUXEL_ERROR_ARGUMENT);
        assert_null(text);
        expect_entry(diagnostics, 0, WANTED("no-variant", .message = "1 to 1000000"));
        luxel_diagnostics_free(diagnostics);
    }
    char *text;
    assert_int_equal(luxel_variant_text(LUXEL_LAST_VARIANT, NULL, &text), LUXEL_OK);
    luxel_text_free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stays_the_same),        cmocka_unit_test(has_the_same_bytes),
        cmocka_unit_test(are_all_different),     cmocka_unit_test(deserve_no_advice),
        cmocka_unit_test(have_a_peak),           cmocka_unit_test(have_five_points),
        cmocka_unit_test(refuses_other_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

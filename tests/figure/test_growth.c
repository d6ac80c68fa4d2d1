/* SPDX-License-Identifier: MIT */
/*
 * What structures for figures and drawings reserve for later versions must be NULL, so that programs of today stay
 * right with them, and is set to NULL in what comes out.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>
#include <luxel/drawing.h>
#include <luxel/figure.h>
#include <luxel/luxel.h>

static void test_figures(void **state)
{
    unsigned char *bytes = NULL;
    size_t length;
    luxel_scene *scene = NULL;
    luxel_figure_settings figure;
    luxel_report_settings report = {.reserved = {state}};
    luxel_figure_settings_init(&figure);
    figure.reserved[0] = state;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_figure_write_memory(scene, NULL, &figure, "f.svg", NULL, &bytes, &length),
                     LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_report_write_memory(scene, NULL, &report, "r.md", NULL, &bytes, &length),
                     LUXEL_ERROR_ARGUMENT);
    assert_null(bytes);
    luxel_scene_free(scene);
}

static void test_drawings(void **state)
{
    const luxel_language odd = {.reserved = {state}};
    double color[3], room;
    luxel_drawing_style style;
    luxel_drawing_style_init(&style, false);
    luxel_color_bar bar = {.low = 1, .high = 2};
    assert_int_equal(luxel_light_color(&style, 0, color), LUXEL_OK);
    assert_int_equal(luxel_color_bar_room(&style, &bar, 100, false, &room), LUXEL_OK);
    style.language = &odd;
    assert_int_equal(luxel_light_color(&style, 0, color), LUXEL_ERROR_ARGUMENT);
    luxel_drawing_style_init(&style, false);
    bar.reserved[3] = state;
    assert_int_equal(luxel_color_bar_room(&style, &bar, 100, false, &room), LUXEL_ERROR_ARGUMENT);
    luxel_profile_style how;
    luxel_profile_style_init(&how);
    luxel_plot_frame frame;
    const luxel_profile_sample samples[2] = {{.has_value = true}, {.abscissa = 1, .has_value = true, .value = 1}};
    const luxel_profile profile = {.count = 2, .samples = samples, .quantity_word = "brightness"};
    memset(&frame, 0xa5, sizeof frame);
    assert_int_equal(luxel_profile_frame(&style, &profile, &how, 300, 200, &frame), LUXEL_OK);
    for (int i = 0; i < 4; i++)
        assert_null(frame.reserved[i]);
    how.reserved[0] = state;
    assert_int_equal(luxel_profile_frame(&style, &profile, &how, 300, 200, &frame), LUXEL_ERROR_ARGUMENT);
    style.reserved[0] = state;
    assert_int_equal(luxel_light_color(&style, 0, color), LUXEL_ERROR_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_figures), cmocka_unit_test(test_drawings)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

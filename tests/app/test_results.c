/* SPDX-License-Identifier: MIT */
/* The results as one text: what the field and the points have, with their places, a line each. */
#include <string.h>

#include "../../app/base/number.h"
#include "../../app/numbers/results.h"
#include "scenes.h"

static void expect_line(const char *text, const char *name, double value)
{
    char number[APP_NUMBER_SIZE];
    char *line = g_strdup_printf("%s\t%s\tx = ", name, app_number_round(value, 7, number));
    if (!strstr(text, line))
        fail_msg("%s is not in: %s", line, text);
    g_free(line);
}

static void tells_all(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
    const luxel_statistics *statistics = luxel_field_statistics(shot->field);
    const AppPoint points[] = {{.x_mm = 0, .y_mm = 0, .on_surface = TRUE, .has_value = TRUE, .value = 2.7275912},
                               {.x_mm = 240, .y_mm = -1.5}};
    const luxel_extrema extrema = {
        .maximum = {.exists = true, .value = 11.75, .x_mm = 177.4828, .y_mm = -3.739128e-11}};
    const luxel_extremum reached = {.exists = true, .value = 0.25, .x_mm = 12, .y_mm = 7};
    AppResults results = {"report", "brightness, W/sr", shot->field, &extrema, &reached, points, G_N_ELEMENTS(points)};
    char *text = app_results_text(&results);
    assert_true(g_str_has_prefix(text, "report\tbrightness, W/sr\n"));
    expect_line(text, "Maximum of the pixels", statistics->maximum.value);
    expect_line(text, "Least value above 0", statistics->minimum.value);
    expect_line(text, "Minimum where light arrives", 0.25);
    /* what the search does not resolve is no number */
    assert_non_null(strstr(text, "True maximum\t11.75\tx = 177.4828, y = 0 mm\n"));
    assert_non_null(strstr(text, "P1\t2.727591\tx = 0, y = 0 mm\nP2\toff the surface\tx = 240, y = -1.5 mm\n"));
    assert_null(strstr(text, "True minimum")); /* which was not found */
    g_free(text);
    results.field = NULL;
    results.extrema = NULL;
    results.reached = NULL;
    text = app_results_text(&results);
    assert_null(strstr(text, "aximum"));
    assert_non_null(strstr(text, "P2\t"));
    g_free(text);
    app_shot_unref(shot);
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(tells_all)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

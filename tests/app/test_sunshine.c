/* SPDX-License-Identifier: MIT */
/* Hours of sun are those of the library at the element that is seen. */
#include "../../app/numbers/sunshine.h"

#include "scenes.h"

/* A wall along x, north of which there is no sun at noon of the equinox; y is north. */
static const char scene[] =
    "luxel: 1\nscreen: {width: 6000, height: 6000, resolution: [8, 8]}\nobserver: {z: 9000}\n"
    "surfaces:\n  - {type: rectangle, center: [0, 0, 0], size: [6000, 6000]}\n"
    "  - {type: rectangle, center: [0, 0, 1000], size: [5000, 2000], axis: [0, 1, 0]}\n"
    "lights: [{type: sun, irradiance: 800, date: \"2026-03-21T12:00+00:00\", latitude: 50, longitude: 0}]\n";

static char *told(const AppMoment *moment, double x_mm, double y_mm)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    return app_sunshine(moment->scene, &settings, x_mm, y_mm);
}

static void test_places(void **state)
{
    (void)state;
    AppDocument *document = document_of_text(scene);
    AppMoment *moment = moment_of(document);
    char *open = told(moment, 0, -1000), *behind = told(moment, 0, 100), *beside = told(moment, 9000, 9000);
    assert_string_equal(open, "Sun on 2026-03-21: 06:06–18:09; 12.05 h");
    assert_string_equal(behind, "Sun on 2026-03-21: 06:06–06:20, 17:54–18:09; 0.4942 h");
    assert_null(beside);
    g_free(open);
    g_free(behind);
    app_moment_unref(moment);
    set(document, "lights[0]", "{type: sun, irradiance: 800, altitude: 40, azimuth: 180}");
    moment = moment_of(document);
    assert_null(told(moment, 0, -1000)); /* without a date there is no day */
    app_moment_unref(moment);
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_places)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Outlines for programs: rims and edges where geometry puts them, only where they are seen, whatever the lights are. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>
#include <luxel/drawing.h>
#include <luxel/luxel.h>

static luxel_scene *scene_of(const char *text)
{
    luxel_scene *scene;
    assert_int_equal(luxel_scene_read_text(text, strlen(text), NULL, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_surface_outlines *find(const luxel_scene *scene)
{
    luxel_surface_outlines *outlines;
    assert_int_equal(luxel_find_surface_outlines(scene, NULL, &outlines), LUXEL_OK);
    return outlines;
}

static const char sphere[] = "luxel: 1\n"
                             "screen: {width: 1000, height: 1000, resolution: [10, 10]}\n"
                             "observer: {z: 3000, projection: %s}\n"
                             "surfaces:\n"
                             "  - {type: sphere, center: [100, -50, 1000], radius: 300}\n"
                             "lights: []\n";

/* Chains of a whole rim: each place is on it, and between two of them the chord leaves it by next to nothing. */
static void finds_the_rim_of_a_sphere(void **state)
{
    (void)state;
    char text[sizeof sphere + 20];
    snprintf(text, sizeof text, sphere, "orthographic");
    luxel_scene *scene = scene_of(text);
    luxel_surface_outlines *outlines = find(scene);
    assert_int_equal(outlines->count, 1);
    const luxel_surface_outline *line = &outlines->lines[0];
    double turned = 0;
    for (size_t i = 0; i < line->count; i++) {
        double x = line->x_mm[i] - 100, y = line->y_mm[i] + 50;
        assert_true(fabs(hypot(x, y) - 300) < 1e-9);
        if (i == 0)
            continue;
        double middle_x = (line->x_mm[i - 1] + line->x_mm[i]) / 2 - 100;
        double middle_y = (line->y_mm[i - 1] + line->y_mm[i]) / 2 + 50;
        assert_true(300 - hypot(middle_x, middle_y) < 3e-6 * 300);
        double from_x = line->x_mm[i - 1] - 100, from_y = line->y_mm[i - 1] + 50;
        turned += atan2(from_x * y - from_y * x, from_x * x + from_y * y);
    }
    assert_true(fabs(fabs(turned) - 2 * M_PI) < 1e-9);
    luxel_surface_outlines_free(outlines);
    luxel_scene_free(scene);
}

/* In perspective a place of the rim is where the line of sight touches: it meets the sphere just inside, not beyond. */
static void finds_what_perspective_shows(void **state)
{
    (void)state;
    char text[sizeof sphere + 20];
    snprintf(text, sizeof text, sphere, "perspective");
    luxel_scene *scene = scene_of(text);
    luxel_surface_outlines *outlines = find(scene);
    assert_int_equal(outlines->count, 1);
    for (size_t i = 0; i < outlines->lines[0].count; i++) {
        /* from the observer (0, 0, 3000) through (x, y, 0): how far it passes by the centre */
        const double way[3] = {outlines->lines[0].x_mm[i], outlines->lines[0].y_mm[i], -3000};
        const double to[3] = {100, -50, -2000};
        const double along = to[0] * way[0] + to[1] * way[1] + to[2] * way[2];
        const double length = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
        const double square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
        assert_true(fabs(sqrt(square - along * along / length) - 300) < 1e-6);
    }
    luxel_surface_outlines_free(outlines);
    luxel_scene_free(scene);
}

/* A sphere before another: of the one behind no place that the other covers. */
static void leaves_out_what_is_covered(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of("luxel: 1\n"
                                  "screen: {width: 1000, height: 1000, resolution: [10, 10]}\n"
                                  "observer: {z: 3000, projection: orthographic}\n"
                                  "surfaces:\n"
                                  "  - {type: sphere, center: [-100, 0, 800], radius: 200}\n"
                                  "  - {type: sphere, center: [100, 0, 1500], radius: 150}\n"
                                  "  - {type: rectangle, center: [0, -350, 500], size: [400, 100]}\n"
                                  "lights: [{type: point, position: [0, 0, 2900], intensity: 1}]\n");
    luxel_surface_outlines *outlines = find(scene);
    size_t of_back = 0, of_front = 0, of_plate = 0;
    for (size_t i = 0; i < outlines->count; i++) {
        assert_true(outlines->lines[i].count >= 2);
        for (size_t k = 0; k < outlines->lines[i].count; k++) {
            const double x = outlines->lines[i].x_mm[k], y = outlines->lines[i].y_mm[k];
            const int back = fabs(hypot(x + 100, y) - 200) < 1e-9, front = fabs(hypot(x - 100, y) - 150) < 1e-9;
            const int plate = fabs(fmax(fabs(x) / 200, fabs(y + 350) / 50) - 1) < 1e-9;
            assert_true(back || front || plate);
            assert_true(!back || hypot(x - 100, y) > 149);
            of_back += (size_t)back;
            of_front += (size_t)front;
            of_plate += (size_t)plate;
        }
    }
    assert_true(of_front > 1400 && of_plate > 1400 && of_back > 700 && of_back < 1400);
    luxel_surface_outlines_free(outlines);
    luxel_scene_free(scene);
}

static void refuses_what_is_not_committed(void **state)
{
    (void)state;
    luxel_surface_outlines *outlines;
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_find_surface_outlines(scene, diagnostics, &outlines), LUXEL_ERROR_ARGUMENT);
    assert_null(outlines);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "not-committed");
    assert_int_equal(luxel_find_surface_outlines(NULL, NULL, &outlines), LUXEL_ERROR_ARGUMENT);
    luxel_surface_outlines_free(NULL);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_rim_of_a_sphere),
        cmocka_unit_test(finds_what_perspective_shows),
        cmocka_unit_test(leaves_out_what_is_covered),
        cmocka_unit_test(refuses_what_is_not_committed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

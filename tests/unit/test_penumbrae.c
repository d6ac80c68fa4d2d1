/* SPDX-License-Identifier: MIT */
/*
 * Pictures with penumbrae against exact values, in random scenes of all kinds of surfaces and sources, in float32 and
 * float64: within 2e-6 of the maximum and 1e-11, and 1e-3 where there are highlights of extended sources; the same
 * bytes for any number of threads.  Surfaces that stand aside change no byte.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "campaign.h"
#include "scenes.h"
#include "shadow_scenes.h"

enum { SIDE = 30 };

static luxel_scene *scene_of(const char *text)
{
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), text);
    luxel_diagnostics_free(diagnostics);
    return scene;
}

static luxel_field *picture(const luxel_scene *scene, luxel_precision precision, unsigned threads)
{
    luxel_settings settings;
    luxel_field *field;
    luxel_settings_init(&settings);
    settings.precision = precision;
    settings.threads = threads;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

/* Pixels that show the edge of a surface may be on its other side. */
static bool is_near_edge(const luxel_evaluator *evaluator, double x, double y, size_t surface)
{
    for (int k = 0; k < 4; k++) {
        const double off = k % 2 ? 1e-6 : -1e-6;
        luxel_value next;
        luxel_evaluate_screen(evaluator, k < 2 ? x + off : x, k < 2 ? y : y + off, &next, NULL);
        if (!next.on_surface || next.surface != surface)
            return true;
    }
    return false;
}

static size_t compare(const luxel_scene *scene, luxel_precision precision, double within, const char *text)
{
    luxel_evaluator *evaluator;
    luxel_field *field = picture(scene, precision, 1), *other = picture(scene, precision, 2);
    const double most = luxel_field_statistics(field)->maximum.value;
    const double *x = luxel_field_x_mm(field), *y = luxel_field_y_mm(field);
    size_t compared = 0;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.tolerance = 0.01 * within;
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
    for (unsigned i = 0; i < SIDE * SIDE; i++) {
        const unsigned column = i % SIDE, row = i / SIDE;
        const double found = luxel_field_value(field, column, row);
        assert_true(found == luxel_field_value(other, column, row));
        if (i % 37 != 0)
            continue;
        luxel_value exact;
        luxel_evaluate_screen(evaluator, x[column], y[row], &exact, NULL);
        if (!exact.on_surface || is_near_edge(evaluator, x[column], y[row], exact.surface))
            continue;
        compared++;
        if (!(fabs(found - exact.value) <= within * most + exact.error))
            fail_msg("pixel %u, %u: %.9g instead of %.9g, maximum %g, in\n%s", column, row, found, exact.value, most,
                     text);
    }
    luxel_evaluator_free(evaluator);
    luxel_field_free(field);
    luxel_field_free(other);
    return compared;
}

static void random_pictures(void **state)
{
    (void)state;
    const char *seed = getenv("LUXEL_SHADOW_SEED");
    const int count = scenes_to_try(6);
    struct dice dice = {seed ? strtoull(seed, NULL, 0) : 5};
    size_t compared = 0;
    for (int n = 0; n < count; n++) {
        const bool glossy = n % 4 == 3;
        const struct text text = shadow_scene(&dice, (n + n / KINDS) % KINDS, n % SOURCES, glossy, 800);
        luxel_scene *scene = scene_of(text.words);
        compared += compare(scene, LUXEL_SINGLE, 1.1e-3, text.words);
        luxel_scene_free(scene);
    }
    assert_true(compared > (size_t)count * SIDE / 3);
}

/* Diffuse light alone, of a window, a box, a globe, a lamp and a tube over a ball, a plate, a disk and a cylinder. */
static void diffuse_pictures(void **state)
{
    (void)state;
    static const char *const lights[] = {
        "{type: planar, rectangle: {center: [-300, 300, 1500], size: [500, 400], axis: [0.2, -0.2, -1]}, radiance: 1}",
        "{type: volume, box: {center: [300, 300, 1400], size: [300, 200, 150]}, radiance: 1}",
        "{type: volume, sphere: {center: [300, -300, 1400], radius: 150}, radiance: 1}",
        "{type: planar, disk: {center: [0, 0, 1600], radius: 250}, radiance: 1}",
        "{type: volume, cylinder: {center: [0, 100, 1600], radius: 60, height: 600, axis: [1, 0, 0]}, radiance: 1}",
        "{type: planar, attenuation: none, rectangle: {center: [0, 0, 1500], size: [500, 400]}, radiance: 1}"};
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        char text[2000];
        snprintf(
            text, sizeof text,
            "luxel: 1\nscreen: {width: 1600, height: 1600, resolution: [30, 30]}\nobserver: {z: 5000}\nsurfaces:\n"
            "  - {type: rectangle, center: [0, 0, 0], size: [1600, 1600], material: {model: lambert}}\n"
            "  - {type: sphere, center: [-200, 100, 400], radius: 180, material: {model: lambert}}\n"
            "  - {type: rectangle, center: [300, -100, 300], size: [300, 200], axis: [0.3, 0, 1], material: {model: "
            "lambert}}\n"
            "  - {type: %s, material: {model: lambert}}\nlights:\n  - %s\n",
            i % 2 ? "disk, center: [0, 400, 350], radius: 150"
                  : "cylinder, center: [0, -450, 250], radius: 80, height: 300, axis: [1, 0.3, 0]",
            lights[i]);
        luxel_scene *scene = scene_of(text);
        assert_true(compare(scene, LUXEL_SINGLE, 2e-6, text) > SIDE / 2);
        if (i % 3 == 0)
            assert_true(compare(scene, LUXEL_DOUBLE, 1e-11, text) > SIDE / 2);
        luxel_scene_free(scene);
    }
}

static const char *const LAMPS[] = {
    "planar, rectangle: {center: [-300, 300, 1500], size: [500, 400], axis: [0.2, -0.2, -1]}",
    "planar, vertices: [[-500, 100, 1500], [-400, 500, 1500], [-100, 550, 1500], [50, 300, 1500], [-200, 50, 1500]]",
    "volume, box: {center: [-200, 300, 1400], size: [300, 200, 150]}",
    "volume, sphere: {center: [-300, 300, 1400], radius: 150}",
    "planar, disk: {center: [-200, 300, 1500], radius: 250, axis: [0.2, -0.2, -1]}",
    "volume, cylinder: {center: [-200, 300, 1500], radius: 60, height: 600, axis: [1, 0.3, 0]}"};
static const char *const OBSTACLES[] = {"sphere, center: [0, 0, 300], radius: 180",
                                        "rectangle, center: [50, 0, 300], size: [300, 200], axis: [0.3, 0, 1]",
                                        "disk, center: [0, 0, 300], radius: 150",
                                        "cylinder, center: [0, 0, 300], radius: 80, height: 300, axis: [1, 0.3, 0]"};

/* Highlights, hidden in part, by laws and lobes of all kinds: quicker rules than the reference's, but within a tenth of
 * what pictures may be off, so that penumbrae are smooth. */
static void glossy_pictures(void **state)
{
    (void)state;
    enum { LAMP_COUNT = sizeof LAMPS / sizeof *LAMPS, OBSTACLE_COUNT = sizeof OBSTACLES / sizeof *OBSTACLES };
    static const char *const laws[] = {"inverse-square", "inverse-square", "practical, k: 500"};
    static const char *const lobes[] = {"{}", "{shininess: 300, highlight: gated}", "{model: phong, highlight: cosine}",
                                        "{shininess: 3}", "{model: phong, shininess: 2000}"};
    for (int i = 0; i < LAMP_COUNT * OBSTACLE_COUNT; i++) {
        char text[1500];
        snprintf(text, sizeof text,
                 "luxel: 1\nscreen: {width: 900, height: 900, resolution: [30, 30]}\nobserver: {z: 5000}\nsurfaces:\n"
                 "  - {type: rectangle, center: [0, 0, 0], size: [1600, 1600], material: %s}\n"
                 "  - {type: %s, material: {model: lambert}}\nlights:\n  - {type: %s, attenuation: %s, radiance: 1}\n",
                 lobes[i % 5], OBSTACLES[i / LAMP_COUNT], LAMPS[i % LAMP_COUNT], laws[i % 3]);
        luxel_scene *scene = scene_of(text);
        assert_true(compare(scene, LUXEL_SINGLE, 1e-4, text) > SIDE / 2);
        luxel_scene_free(scene);
    }
}

/* A box one of whose faces lies in the plane of a surface. */
static void faces_on_edge(void **state)
{
    (void)state;
    luxel_scene *scene =
        scene_of("luxel: 1\nscreen: {width: 600, height: 600, resolution: [30, 30]}\nobserver: {z: 5000}\nsurfaces:\n"
                 "  - {type: rectangle, center: [0, 0, 0], size: [600, 600]}\n"
                 "  - {type: rectangle, center: [100, 0, 200], size: [200, 200]}\n"
                 "lights:\n  - {type: volume, box: {center: [900, 0, 500], size: [600, 400, 1000]}, radiance: 1}\n");
    assert_true(compare(scene, LUXEL_SINGLE, 1e-4, "a box on edge") > SIDE / 2);
    luxel_scene_free(scene);
}

/* A ball beside a large picture, whose shadow falls beside it, too. */
static void surfaces_aside(void **state)
{
    (void)state;
    luxel_field *fields[2];
    for (int i = 0; i < 2; i++) {
        char text[1000];
        snprintf(
            text, sizeof text,
            "luxel: 1\nshadows: %s\nscreen: {width: 900, height: 900, resolution: [300, 300]}\nobserver: {z: 5000}\n"
            "surfaces:\n  - {type: rectangle, center: [0, 0, 0], size: [900, 900]}\n"
            "  - {type: sphere, center: [3000, 0, 500], radius: 180}\n"
            "lights:\n  - {type: planar, rectangle: {center: [-300, 300, 1500], size: [500, 400]}, radiance: 1}\n",
            i ? "none" : "all");
        luxel_scene *scene = scene_of(text);
        fields[i] = picture(scene, LUXEL_SINGLE, 1);
        luxel_scene_free(scene);
    }
    for (unsigned i = 0; i < 300 * 300; i++)
        assert_true(luxel_field_single(fields[0])[i] == luxel_field_single(fields[1])[i]);
    luxel_field_free(fields[0]);
    luxel_field_free(fields[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(diffuse_pictures), cmocka_unit_test(glossy_pictures), cmocka_unit_test(faces_on_edge),
        cmocka_unit_test(random_pictures),  cmocka_unit_test(surfaces_aside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * What disks and the sides of cylinders show: closed forms under a point source, pictures against exact values, a disk
 * cut out of a rectangle, a ring of facets that tends to a cylinder, shadows and their flux, turns about the line of
 * sight, and extrema against a search by chance.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

enum { TEXT_SIZE = 60000 };

/* A scene of these surfaces and lights, seen along -z from z = 5000 mm or as `observer` says. */
static luxel_scene *scene_of(const char *observer, const char *surfaces, const char *lights, const char *more)
{
    static char text[TEXT_SIZE];
    luxel_scene *scene;
    int length = snprintf(text, sizeof text,
                          "luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: %s\n"
                          "surfaces: [%s]\nlights: [%s]\n%s\n",
                          observer ? observer : "{z: 5000}", surfaces, lights, more ? more : "");
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), text);
    luxel_diagnostics_free(diagnostics);
    return scene;
}

#define WHITE "material: {model: lambert, diffuse: 1}"
#define SHINY "material: {diffuse: 0.7, specular: 0.6, shininess: 25}"

static void assert_near(double value, double expected, double relative)
{
    if (!(fabs(value - expected) <= relative * fabs(expected)))
        fail_msg("%.17g instead of %.17g", value, expected);
}

static luxel_probe *probe_at(const luxel_scene *scene, double x_mm, double y_mm)
{
    luxel_probe *probe;
    assert_int_equal(luxel_probe_screen(scene, NULL, x_mm, y_mm, NULL, &probe), LUXEL_OK);
    return probe;
}

/* The value seen through a screen point, -1 off every surface. */
static double seen(const luxel_scene *scene, double x_mm, double y_mm)
{
    luxel_probe *probe = probe_at(scene, x_mm, y_mm);
    double value = probe->on_surface ? probe->value : -1;
    if (probe->on_surface)
        assert_true(probe->has_value && probe->error <= 1e-12 * fabs(probe->value) + 1e-15);
    luxel_probe_free(probe);
    return value;
}

/* The irradiance of a free element. */
static double lit(const luxel_scene *scene, const double place[3], const double normal[3])
{
    luxel_probe *probe;
    assert_int_equal(luxel_probe_element(scene, NULL, place, normal, NULL, &probe), LUXEL_OK);
    double sum = 0;
    for (size_t i = 0; i < probe->share_count; i++)
        sum += probe->shares[i].irradiance;
    luxel_probe_free(probe);
    return sum;
}

static void closed_forms(void **state)
{
    (void)state;
    /* E = I h/(h^2 + d^2)^(3/2), 2 m above a disk */
    luxel_scene *disk = scene_of(NULL, "{type: disk, center: [0, 0, 1000], radius: 300, " WHITE "}",
                                 "{type: point, position: [0, 0, 3000], intensity: 8}", NULL);
    assert_near(seen(disk, 0, 0), 2, 1e-15);
    assert_near(seen(disk, 180, 240), 8 * 2 / pow(4 + 0.09, 1.5), 1e-14); /* the edge belongs to it */
    assert_true(seen(disk, 180.001, 240) == -1 && seen(disk, 0, -300.001) == -1);
    luxel_scene_free(disk);
    /* E = I cos/r^2 on the side of an upright cylinder, 100 mm across: its nearest meridian, and at 30 degrees */
    luxel_scene *tube = scene_of(NULL, "{type: cylinder, center: [0, 0, 1000], radius: 100, height: 600, " WHITE "}",
                                 "{type: point, position: [0, 0, 2100], intensity: 8}", NULL);
    assert_near(seen(tube, 0, 0), 8, 1e-15);
    assert_near(seen(tube, 0, 300), 8 * 1 / pow(1 + 0.09, 1.5), 1e-14);
    double x = 0.05, z = 0.1 * sqrt(0.75), far = hypot(x, 1.1 - z);
    assert_near(seen(tube, 50, 0), 8 * (1.1 * z / 0.1 - 0.1) / (far * far * far), 1e-14);
    assert_true(seen(tube, 100.001, 0) == -1 && seen(tube, 0, 300.001) == -1 && seen(tube, -99.999, -299) >= 0);
    luxel_scene_free(tube);
    /* seen along its axis there is nothing of the side, and through it what is behind */
    luxel_scene *end_on = scene_of(NULL,
                                   "{type: cylinder, center: [0, 0, 1000], radius: 100, height: 600, axis: [0, 0, 2]}, "
                                   "{type: disk, center: [0, 0, 0], radius: 80, " WHITE "}",
                                   "{type: point, position: [0, 0, 2000], intensity: 8}", NULL);
    assert_near(seen(end_on, 0, 0), 2, 1e-15);
    assert_true(seen(end_on, 99, 0) == -1 && seen(end_on, 100, 0) == -1);
    luxel_scene_free(end_on);
}

/* Seen through a disk cut out of a rectangle is what the rectangle shows, to the last digits. */
static void cut_out(void **state)
{
    static const char *const observers[] = {"{z: 5000}", "{z: 1800, projection: perspective}"};
    const char *lights =
        "{type: point, position: [300, 500, 1700], intensity: 5}, "
        "{type: spot, position: [-400, 0, 1500], aim: [0, 0, 600], intensity: 3, inner: 10, outer: 30}, "
        "{type: planar, radiance: 5, rectangle: {center: [0, 300, 2000], size: [300, 300]}}";
    (void)state;
    for (int o = 0; o < 2; o++) {
        luxel_scene *disk =
            scene_of(observers[o], "{type: disk, center: [10, 20, 600], radius: 250, axis: [0.3, 0.2, 1], " SHINY "}",
                     lights, NULL);
        luxel_scene *plate = scene_of(
            observers[o], "{type: rectangle, center: [10, 20, 600], size: [500, 500], axis: [0.3, 0.2, 1], " SHINY "}",
            lights, NULL);
        luxel_field *fields[2];
        luxel_settings settings;
        luxel_settings_init(&settings);
        settings.precision = LUXEL_DOUBLE;
        settings.tolerance = 1e-8;
        assert_int_equal(luxel_render(disk, &settings, NULL, &fields[0]), LUXEL_OK);
        assert_int_equal(luxel_render(plate, &settings, NULL, &fields[1]), LUXEL_OK);
        const double most = luxel_field_statistics(fields[1])->maximum.value;
        unsigned shared = 0, fewer = 0;
        for (size_t i = 0; i < 80 * 80; i++) {
            const double *values[2] = {luxel_field_double(fields[0]), luxel_field_double(fields[1])};
            const bool shows[2] = {luxel_field_mask(fields[0])[i], luxel_field_mask(fields[1])[i]};
            assert_true(shows[1] || !shows[0]);
            fewer += shows[1] && !shows[0];
            if (!shows[0])
                continue;
            shared++;
            assert_true(fabs(values[0][i] - values[1][i]) <= 2e-8 * most);
        }
        assert_true(shared > 1000 && fewer > 200);
        for (int i = 0; i < 30; i++) {
            const double x = 100 * sin(i * 7.0), y = 100 * cos(i * 5.0);
            luxel_probe *one = probe_at(disk, x, y), *other = probe_at(plate, x, y);
            assert_true(one->on_surface && other->on_surface);
            assert_near(one->value, other->value, 1e-9);
            assert_near(one->shares[0].irradiance, other->shares[0].irradiance, 1e-14);
            luxel_probe_free(one), luxel_probe_free(other);
        }
        luxel_field_free(fields[0]), luxel_field_free(fields[1]);
        luxel_scene_free(disk), luxel_scene_free(plate);
    }
}

/* Every pixel against the exact value at its sample, by every instruction set in both precisions; those whose sample
 * lies within 1e-6 of an edge, where the value jumps, aside. */
static void expect_picture(const luxel_scene *scene)
{
    luxel_evaluator *evaluator;
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    for (size_t set = 0; luxel_instruction_set_name(set); set++)
        for (int precision = 0; precision < 2 && luxel_instruction_set_runs(set); precision++) {
            luxel_field *field;
            luxel_settings settings;
            luxel_settings_init(&settings);
            settings.instruction_set = luxel_instruction_set_name(set);
            settings.precision = precision ? LUXEL_DOUBLE : LUXEL_SINGLE;
            assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
            const double bound = (precision ? 1e-11 : 2e-6) * luxel_field_statistics(field)->maximum.value;
            unsigned shown = 0;
            for (unsigned i = 0; i < 80 * 80; i++) {
                const double x = luxel_field_x_mm(field)[i % 80], y = luxel_field_y_mm(field)[i / 80];
                luxel_value exact;
                luxel_evaluate_screen(evaluator, x, y, &exact, NULL);
                bool near_edge = false;
                for (int k = 0; k < 4; k++) {
                    const double off[2] = {k < 2 ? (k ? 1e-6 : -1e-6) : 0, k < 2 ? 0 : (k > 2 ? 1e-6 : -1e-6)};
                    luxel_value next;
                    luxel_evaluate_screen(evaluator, x + off[0], y + off[1], &next, NULL);
                    near_edge |= next.on_surface != exact.on_surface || next.surface != exact.surface ||
                                 fabs(next.value - exact.value) > 1e-3 * fabs(exact.value);
                }
                if (near_edge)
                    continue;
                assert_int_equal(luxel_field_mask(field)[i], exact.on_surface);
                shown += exact.on_surface;
                const double value = luxel_field_value(field, i % 80, i / 80);
                if (exact.on_surface && !(fabs(value - exact.value) <= bound))
                    fail_msg("%s, %d: pixel %u, %u: %.17g instead of %.17g", settings.instruction_set, precision,
                             i % 80, i / 80, value, exact.value);
            }
            assert_true(shown > 1000);
            luxel_field_free(field);
        }
    luxel_evaluator_free(evaluator);
}

static void pictures(void **state)
{
    static const char *const observers[] = {"{z: 5000}", "{z: 4000, view: observer}",
                                            "{z: 2500, projection: perspective}"};
    static const char *const surfaces[] = {
        "{type: cylinder, center: [20, -10, 800], radius: 260, height: 500, axis: [0.2, 1, 0.5], " SHINY "}",
        "{type: disk, center: [0, 0, 700], radius: 390, axis: [-0.4, 0.3, 1], " SHINY "}",
        "{type: disk, center: [0, 0, 500], radius: 390, " WHITE "}, "
        "{type: cylinder, center: [60, 0, 900], radius: 90, height: 300, axis: [1, 0.4, 0.3], " SHINY "}, "
        "{type: sphere, center: [-180, 120, 850], radius: 100, " SHINY "}, "
        "{type: disk, center: [-100, -200, 1100], radius: 120, axis: [0.3, 0, 1], material: {shininess: 3000}}, "
        "{type: rectangle, center: [200, 250, 950], size: [200, 150], axis: [-0.5, -0.5, 1]}",
    };
    static const char *const lights[] = {
        "{type: point, position: [700, 900, 2200], intensity: 10}, "
        "{type: distant, direction: [0.6, -0.2, -1], irradiance: 2}, {type: ambient, irradiance: 0.1}",
        "{type: spot, position: [100, 400, 1900], aim: [0, 0, 700], intensity: 6, inner: 5, outer: 40}, "
        "{type: point, position: [-500, -100, 1250], intensity: 1, attenuation: practical, k: 100}",
    };
    (void)state;
    for (size_t o = 0; o < 3; o++)
        for (size_t s = 0; s < 3; s++)
            for (size_t l = 0; l < 2; l++) {
                luxel_scene *scene = scene_of(observers[o], surfaces[s], lights[l], NULL);
                expect_picture(scene);
                luxel_scene_free(scene);
            }
}

/* A prism of flat facets around a cylinder: the more, the closer, and where a facet touches it the same. */
static void facets(void **state)
{
    static char plates[TEXT_SIZE / 2];
    const char *lights = "{type: point, position: [300, 200, 1900], intensity: 10}";
    luxel_scene *tube =
        scene_of(NULL, "{type: cylinder, center: [0, 0, 800], radius: 200, height: 400, " SHINY "}", lights, NULL);
    double worst[2] = {0, 0};
    (void)state;
    for (int fine = 0; fine < 2; fine++) {
        const int count = fine ? 240 : 60;
        size_t length = 0;
        for (int i = 0; i < count; i++) { /* those whose fronts are seen */
            const double turn = 2 * M_PI * i / count, x = sin(turn), z = cos(turn);
            if (z > 0.2)
                length += (size_t)snprintf(plates + length, sizeof plates - length,
                                           "%s{type: rectangle, center: [%.17g, 0, %.17g], size: [%.17g, 400], "
                                           "axis: [%.17g, 0, %.17g], " SHINY "}",
                                           length ? ", " : "", 200 * x, 800 + 200 * z, 400 * tan(M_PI / count), x, z);
            assert_true(length < sizeof plates);
        }
        luxel_scene *prism = scene_of(NULL, plates, lights, "shadows: none");
        assert_near(seen(prism, 0, 50), seen(tube, 0, 50), 1e-12);
        for (int i = 0; i < 100; i++) {
            const double x = -180 + 3.6 * i, y = 150 * sin(i);
            worst[fine] = fmax(worst[fine], fabs(seen(prism, x, y) - seen(tube, x, y)));
        }
        luxel_scene_free(prism);
    }
    /* normals are off by no more than half a facet's turn, a fourth of what it was */
    if (!(worst[1] < 0.3 * worst[0] && worst[1] < 0.3))
        fail_msg("facets are off by %g, then %g", worst[0], worst[1]);
    luxel_scene_free(tube);
}

/* The shadow of a disk from a point halfway up is a disk of twice the radius, with all the flux that meets the disk:
 * I times its solid angle.  Light passes a tube along its axis, and from aside it does not. */
static void shadows(void **state)
{
    (void)state;
    luxel_scene *scene =
        scene_of(NULL,
                 "{type: rectangle, center: [0, 0, 0], size: [700, 700], " WHITE "}, "
                 "{type: disk, center: [30, 20, 500], radius: 80, " WHITE "}",
                 "{type: point, position: [30, 20, 1000], intensity: 4}",
                 "grids: [{name: floor, center: [30, 20, 0], size: [600, 600], axis: [0, 0, 1], n: [3, 3]}]");
    const double up[3] = {0, 0, 1};
    for (int i = 0; i < 24; i++) {
        const double turn = 2 * M_PI * i / 24;
        const double in[3] = {30 + 159.9999 * cos(turn), 20 + 159.9999 * sin(turn), 0};
        const double out[3] = {30 + 160.0001 * cos(turn), 20 + 160.0001 * sin(turn), 0};
        assert_true(lit(scene, in, up) == 0);
        assert_near(lit(scene, out, up), 4 / pow(1 + 0.1600001 * 0.1600001, 1.5), 1e-9);
    }
    assert_near(seen(scene, 300, 20), 4 / pow(1 + 0.27 * 0.27, 1.5), 1e-14);
    luxel_grid *grid;
    assert_int_equal(luxel_find_grid(scene, NULL, 0, NULL, &grid), LUXEL_OK);
    /* a square of the side 2a at the distance h: 4 asin(a^2/(a^2 + h^2)) */
    const double square = 4 * asin(0.09 / 1.09), hidden = 2 * M_PI * (1 - 0.5 / hypot(0.5, 0.08));
    assert_true(grid->has_mean && grid->flux.error < 1e-6 * grid->flux.value);
    assert_near(grid->flux.value, 4 * (square - hidden), 1e-8);
    luxel_grid_free(grid);
    luxel_scene_free(scene);

    luxel_scene *tube =
        scene_of(NULL,
                 "{type: rectangle, center: [0, 0, 0], size: [700, 700], " WHITE "}, "
                 "{type: cylinder, center: [0, 0, 500], radius: 100, height: 200, axis: [0, 0, 1], " WHITE "}",
                 "{type: point, position: [0, 0, 1200], intensity: 4}",
                 "grids: [{name: floor, center: [0, 0, 0], size: [600, 600], axis: [0, 0, 1], n: [3, 3]}]");
    /* from 1200 to the rims at 600 and 400: shadows from 1200/6 = 200 to 1200/8 = 150 mm, a ring */
    const double reaches[] = {0, 149.999, 150.001, 199.999, 200.001};
    for (int i = 0; i < 5; i++) {
        const double at[3] = {reaches[i] * 0.6, reaches[i] * 0.8, 0};
        const double free = 4 * 1.2 / pow(1.44 + reaches[i] * reaches[i] * 1e-6, 1.5);
        if (i == 2 || i == 3)
            assert_true(lit(tube, at, up) == 0);
        else
            assert_near(lit(tube, at, up), free, 1e-14);
    }
    assert_int_equal(luxel_find_grid(tube, NULL, 0, NULL, &grid), LUXEL_OK);
    const double ring = 2 * M_PI * (1.2 / hypot(1.2, 0.15) - 1.2 / hypot(1.2, 0.2));
    const double plate = 4 * asin(0.09 / (0.09 + 1.44));
    assert_near(grid->flux.value, 4 * (plate - ring), 1e-8);
    luxel_grid_free(grid);
    luxel_scene_free(tube);
}

/* A free element on the inner wall is lit through the open end alone. */
static void inner_wall(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of(
        NULL, "{type: cylinder, center: [0, 0, 500], radius: 100, height: 200, axis: [0, 0, 1], " WHITE "}",
        "{type: point, position: [-50, 0, 1000], intensity: 4}, {type: point, position: [-1000, 0, 500], intensity: 4}",
        NULL);
    const double inside[3] = {100, 0, 500}, inward[3] = {-1, 0, 0}, outward[3] = {1, 0, 0}, across[3] = {-1, 0, 1};
    assert_near(lit(scene, inside, inward), 4 * 0.15 / pow(0.15 * 0.15 + 0.25, 1.5), 1e-14);
    assert_near(lit(scene, inside, across), 4 * (0.15 + 0.5) / sqrt(2) / pow(0.15 * 0.15 + 0.25, 1.5), 1e-14);
    assert_true(lit(scene, inside, outward) == 0);
    luxel_scene_free(scene);
}

/* Turned about the line of sight, everything is seen where it was turned to. */
static void turns(void **state)
{
    (void)state;
    for (int n = 0; n < 6; n++) {
        const double turn = 0.3 + n, c = cos(turn), s = sin(turn);
        char surfaces[2][1000], lights[2][300];
        for (int turned = 0; turned < 2; turned++) {
            const double cx = turned ? c : 1, sx = turned ? s : 0;
#define TURNED(x, y) cx *(x)-sx *(y), sx *(x) + cx *(y)
            snprintf(surfaces[turned], sizeof surfaces[0],
                     "{type: cylinder, center: [%.17g, %.17g, 900], radius: 120, height: 300, axis: [%.17g, %.17g, "
                     "0.4], " SHINY
                     "}, {type: disk, center: [%.17g, %.17g, 500], radius: 380, axis: [%.17g, %.17g, 1], " SHINY "}",
                     TURNED(50.0, 20.0), TURNED(0.3, 1.0), TURNED(-10.0, 30.0), TURNED(0.1, 0.3));
            snprintf(lights[turned], sizeof lights[0], "{type: point, position: [%.17g, %.17g, 2000], intensity: 10}",
                     TURNED(500.0, 300.0));
        }
        const char *observer = n % 2 ? "{z: 3000, projection: perspective}" : "{z: 3000}";
        luxel_scene *one = scene_of(observer, surfaces[0], lights[0], NULL);
        luxel_scene *other = scene_of(observer, surfaces[1], lights[1], NULL);
        for (int i = 0; i < 60; i++) {
            const double x = 350 * sin(i * 3.7), y = 350 * cos(i * 1.9) * sin(i);
            const double values[2] = {seen(one, x, y), seen(other, c * x - s * y, s * x + c * y)};
            assert_true(fabs(values[1] - values[0]) <= 1e-12);
        }
        luxel_scene_free(one), luxel_scene_free(other);
    }
}

/* What is refused, and what a free element, an arc and a body are told. */
static void refusals(void **state)
{
    static const struct {
        const char *surface, *id;
    } cases[] = {
        {"{type: disk, center: [0, 0, 4990], radius: 100, axis: [0, 1, 1]}", "observer-too-low"},
        {"{type: cylinder, center: [0, 0, 4950], radius: 100, height: 10}", "observer-too-low"},
        {"{type: disk, center: [0, 0, 0], radius: 0}", "out-of-range"},
        {"{type: cylinder, center: [0, 0, 0], radius: 10, height: -1}", "out-of-range"},
        {"{type: cylinder, center: [0, 0, 0], radius: 10}", "missing-key"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1000];
        luxel_scene *scene;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        snprintf(text, sizeof text,
                 "luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: {z: 5000}\n"
                 "surfaces: [%s]\nlights: []\n",
                 cases[i].surface);
        assert_true(load(text, diagnostics, &scene) != LUXEL_OK ||
                    luxel_scene_check_view(scene, diagnostics) != LUXEL_OK);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
        if (strcmp(luxel_diagnostics_get(diagnostics, 0)->id, cases[i].id) != 0)
            fail_msg("%s: %s", cases[i].surface, luxel_diagnostics_get(diagnostics, 0)->id);
        luxel_scene_free(scene);
        luxel_diagnostics_free(diagnostics);
    }
}

static uint64_t chance_state = 99;

static double chance(double low, double high)
{
    chance_state = chance_state * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * (double)(chance_state >> 11) * 0x1p-53;
}

/* No place found by chance, or by steps from the best of them, is beyond the extrema. */
static void extrema(void **state)
{
    static const char *const surfaces[] = {
        "{type: cylinder, center: [20, -10, 800], radius: 260, height: 500, axis: [0.2, 1, 0.5], " SHINY "}",
        "{type: disk, center: [0, 0, 700], radius: 300, axis: [-0.4, 0.3, 1], " SHINY "}",
        "{type: disk, center: [0, 0, 500], radius: 390, " WHITE "}, "
        "{type: cylinder, center: [60, 0, 900], radius: 90, height: 300, axis: [1, 0.4, 0.3], " SHINY "}",
    };
    static const char *const lights[] = {"{type: point, position: [200, 300, 1500], intensity: 10}",
                                         "{type: distant, direction: [0.3, -0.2, -1], irradiance: 2}"};
    (void)state;
    for (int n = 0; n < 12; n++) {
        luxel_scene *scene =
            scene_of(n % 4 > 1 ? "{z: 2500, projection: perspective}" : NULL, surfaces[n / 4], lights[n % 2], NULL);
        luxel_evaluator *evaluator;
        luxel_field *field;
        luxel_extrema found;
        assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
        assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
        assert_int_equal(luxel_find_extrema(evaluator, field, NULL, NULL, &found), LUXEL_OK);
        for (int sign = -1; sign <= 1; sign += 2) {
            const luxel_peak *peak = sign > 0 ? &found.maximum : &found.minimum;
            double best = -HUGE_VAL, at[2] = {0, 0};
            assert_true(peak->exists);
            for (int i = 0; i < 20000; i++) {
                const double reach = i < 10000 ? 400 : 400 * pow(2, -(i - 10000) / 300.0);
                const double x = (i < 10000 ? 0 : at[0]) + chance(-reach, reach);
                const double y = (i < 10000 ? 0 : at[1]) + chance(-reach, reach);
                if (fabs(x) > 400 || fabs(y) > 400)
                    continue;
                luxel_value value;
                luxel_evaluate_screen(evaluator, x, y, &value, NULL);
                if (value.on_surface && sign * value.value > best)
                    best = sign * value.value, at[0] = x, at[1] = y;
            }
            const double beyond = best - sign * peak->value;
            if (beyond > 1e-9 * fabs(peak->value) + 1e-15)
                fail_msg("scene %d: %.12g at (%g, %g), but the extremum is %.12g at (%g, %g)", n, sign * best, at[0],
                         at[1], peak->value, peak->x_mm, peak->y_mm);
        }
        luxel_evaluator_free(evaluator);
        luxel_field_free(field);
        luxel_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms), cmocka_unit_test(cut_out),  cmocka_unit_test(pictures),
        cmocka_unit_test(facets),       cmocka_unit_test(shadows),  cmocka_unit_test(inner_wall),
        cmocka_unit_test(turns),        cmocka_unit_test(refusals), cmocka_unit_test(extrema),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

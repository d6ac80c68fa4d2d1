/* SPDX-License-Identifier: MIT */
/*
 * What falls on a measuring plane as a whole: closed numbers, all that a source sends out on the walls around it, parts
 * of a plane that add up, shadows of known size, and how far the average of the cells is from it.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <luxel/luxel.h>

#include "flux_crowd.h"

static luxel_scene *scene_with(const char *surfaces, const char *lights, const char *grids)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    static char text[32768];
    int length = snprintf(text, sizeof text,
                          "luxel: 1\nunits: photometric\nscreen: {width: 100, height: 100, resolution: [8, 8]}\n"
                          "observer: {z: 200000}\nsurfaces: [%s]\nlights: [%s]\ngrids: [%s]\n",
                          surfaces ? surfaces : "{type: sphere, center: [90000, 0, 0], radius: 1}", lights, grids);
    assert_true(length > 0 && (size_t)length < sizeof text);
    luxel_status status = luxel_scene_read_text(text, (size_t)length, "test.yaml", diagnostics, &scene);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    if (status != LUXEL_OK) {
        char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
        fail_msg("%s: %s", grids, message ? message : "?");
    }
    luxel_diagnostics_free(diagnostics);
    return scene;
}

static luxel_grid *measure(const luxel_scene *scene, size_t i)
{
    luxel_grid *grid = NULL;
    assert_int_equal(luxel_find_grid(scene, NULL, i, NULL, &grid), LUXEL_OK);
    return grid;
}

/* Within the error that is told, and that no larger than `relative`. */
static void assert_flux(const luxel_grid *grid, double expected, double relative)
{
    assert_true(grid->has_mean && grid->flux_unit);
    if (!(fabs(grid->flux.value - expected) <= grid->flux.error + 1e-15 * expected))
        fail_msg("%.17g +- %.3g is not %.17g", grid->flux.value, grid->flux.error, expected);
    if (!(grid->flux.error <= relative * expected))
        fail_msg("%.17g +- %.3g: the error is above %g", grid->flux.value, grid->flux.error, relative);
    assert_true(fabs(grid->mean.value * grid->size_mm[0] * grid->size_mm[1] / 1e6 - grid->flux.value) <=
                1e-14 * grid->flux.value);
}

static void expect_flux(const char *surfaces, const char *lights, const char *grid, double expected, double relative)
{
    luxel_scene *scene = scene_with(surfaces, lights, grid);
    luxel_grid *found = measure(scene, 0);
    assert_flux(found, expected, relative);
    luxel_grid_free(found);
    luxel_scene_free(scene);
}

static void closed_numbers(void **state)
{
    (void)state;
    const char *desk = "{center: [0, 0, 0], size: [1000, 1000], n: [10, 10]}";
    /* I times the solid angle, 4 atan(a^2 / (h sqrt(2 a^2 + h^2))) */
    const double angle = 4 * atan(0.25 / (0.02 * sqrt(0.5004)));
    expect_flux(NULL, "{type: point, position: [0, 0, 20], intensity: 100}", desk, 100 * angle, 1e-13);
    assert_true(fabs(100 * angle - 605.706183) < 1e-6);
    /* half a rectangle has half of it, its upper left quarter a quarter */
    expect_flux(NULL, "{type: point, position: [0, 0, 20], intensity: 100}",
                "{center: [-250, 250, 0], size: [500, 500], n: [3, 3]}", 25 * angle, 1e-13);
    /* under a lambertian source: the configuration factor of an element and a rectangle above its corner, times pi */
    const double x = 0.5 / 0.3, root = sqrt(1 + x * x);
    expect_flux(NULL, "{type: point, pattern: lambertian, position: [0, 0, 300], intensity: 7}", desk,
                7 * 4 * (x / root) * atan(x / root), 1e-12);
    expect_flux(NULL, "{type: ambient, irradiance: 3}, {type: distant, direction: [3, 0, -4], irradiance: 5}", desk, 7,
                1e-14);
    /* behind the plane, and in it */
    luxel_scene *scene = scene_with(NULL,
                                    "{type: point, position: [0, 0, -20], intensity: 100}, {type: point, position: "
                                    "[700, 0, 0], intensity: 1}, {type: distant, direction: [0, 0, 1], irradiance: 5}",
                                    desk);
    luxel_grid *grid = measure(scene, 0);
    assert_true(grid->has_mean && grid->flux.value == 0 && grid->sampling_error == 0 && !grid->is_coarse);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

/* Opposite faces of a cube, and neighbours, which share an edge: configuration factors, times the power. */
static void squares(void **state)
{
    (void)state;
    const char *lamp = "{type: planar, rectangle: {center: [0, 0, 1000], size: [1000, 1000]}, power: 100}";
    expect_flux(NULL, lamp, "{center: [0, 0, 0], size: [1000, 1000], n: [4, 4]}", 19.982489569838746, 1e-7);
    expect_flux(NULL, lamp, "{center: [500, 0, 500], size: [1000, 1000], axis: [-1, 0, 0], up: [0, 0, 1], n: [4, 4]}",
                20.004377607540316, 2e-6);
}

/* Whatever a source sends out falls on the walls around it. */
static void closed_rooms(void **state)
{
    (void)state;
    static const char *const walls =
        "{center: [0, 0, 0], size: [4000, 4000], n: [2, 2]},"
        "{center: [0, 0, 3000], size: [4000, 4000], axis: [0, 0, -1], n: [3, 3]},"
        "{center: [-2000, 0, 1500], size: [4000, 3000], axis: [1, 0, 0], up: [0, 0, 1], n: [2, 2]},"
        "{center: [2000, 0, 1500], size: [4000, 3000], axis: [-1, 0, 0], up: [0, 0, 1], n: [2, 2]},"
        "{center: [0, -2000, 1500], size: [4000, 3000], axis: [0, 1, 0], n: [2, 2]},"
        "{center: [0, 2000, 1500], size: [4000, 3000], axis: [0, -1, 0], n: [2, 2]}";
    static const struct {
        const char *light;
        double relative;
    } cases[] = {
        {"{type: point, position: [700, -900, 2000], intensity: 3}", 1e-13},
        {"{type: point, position: [700, -900, 2000], intensity: 3, pattern: lambertian, axis: [1, 2, -3]}", 1e-12},
        {"{type: point, position: [0, 0, 1000], intensity: 3, pattern: cosine, exponent: 7, axis: [1, 2, -3]}", 1e-7},
        {"{type: spot, position: [-500, 0, 1900], intensity: 3, inner: 10, outer: 40, axis: [1, 0, -1]}", 1e-6},
        {"{type: spot, position: [-500, 0, 1900], intensity: 3, inner: 20, outer: 20, axis: [1, 0.5, -1]}", 1e-6},
        {"{type: luminaire, file: 'builtin:office-lamp.ies', position: [700, -900, 2000]}", 1e-7},
        {"{type: luminaire, file: 'builtin:office-lamp.ies', position: [-1900, 0, 300], axis: [1, 2, 3], c0: [1, 0, "
         "0], "
         "interpolation: cosine}",
         1e-7},
        {"{type: planar, disk: {center: [0, 300, 2500], radius: 200}, radiance: 10}", 1e-7},
        {"{type: volume, sphere: {center: [0, 300, 2500], radius: 200}, radiance: 10}", 1e-5},
        {"{type: volume, box: {center: [0, 300, 1500], size: [300, 200, 100]}, radiance: 10}", 1e-5},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        luxel_scene *scene = scene_with(NULL, cases[i].light, walls);
        double all = 0, error = 0, sent = 0;
        for (size_t wall = 0; wall < 6; wall++) {
            luxel_grid *grid = measure(scene, wall);
            assert_true(grid->has_mean);
            all += grid->flux.value;
            error += grid->flux.error;
            luxel_grid_free(grid);
        }
        assert_int_equal(luxel_scene_light_flux(scene, 0, &sent), LUXEL_OK);
        if (!(fabs(all - sent) <= error + 1e-12 * sent && error <= cases[i].relative * sent))
            fail_msg("%s: %.17g +- %.3g, not %.17g", cases[i].light, all, error, sent);
        luxel_scene_free(scene);
    }
}

/* The shadow of a ball under parallel light is a disk; that of a plate is as large as it; a plate in the plane throws
 * none. */
static void shadows(void **state)
{
    (void)state;
    const char *sun = "{type: distant, direction: [0, 0, -1], irradiance: 5}",
               *plane = "{center: [0, 0, 0], size: [2000, 1000], n: [4, 4]}";
    expect_flux("{type: sphere, center: [100, -70, 1000], radius: 300}", sun, plane, 5 * (2 - M_PI * 0.09), 1e-6);
    expect_flux("{type: rectangle, center: [100, -70, 1000], size: [400, 500]}", sun, plane, 5 * (2 - 0.2), 1e-6);
    expect_flux("{type: rectangle, center: [100, -70, 0], size: [400, 500]}", sun, plane, 10, 1e-14);
    expect_flux("{type: sphere, center: [100, -70, -300], radius: 300}", sun, plane, 10, 1e-14);
}

/* Plates beside the light's way, whose edges together are more than are kept, change nothing of a plate's shadow. */
static void plates_aside(void **state)
{
    (void)state;
    enum { ASIDE = 30 };
    static const char plate[] =
        "{type: rectangle, center: [%d, %d, 60], size: [%d, 31], axis: [0.1, 0.2, 1], up: [0, 1, 0]}%s";
    static const char *const lamp = "{type: point, position: [10, 20, 100], intensity: 100}",
                             *const plane = "{center: [0, 0, 0], size: [100, 100], n: [4, 4]}";
    char alone[128], all[ASIDE * 96 + 256];
    size_t length = 0;
    for (int i = 0; i < ASIDE; i++)
        length += (size_t)snprintf(all + length, sizeof all - length, plate, 300 + 40 * i, 200, 20, ", ");
    snprintf(alone, sizeof alone, plate, 5, -3, 26, "");
    snprintf(all + length, sizeof all - length, "%s", alone);
    luxel_scene *scene = scene_with(alone, lamp, plane);
    luxel_grid *grid = measure(scene, 0);
    expect_flux(all, lamp, plane, grid->flux.value, 1e-8);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

/* Many plates that lie over the plane, whose shadows together are a union of rectangles, under a point source. */
static void plates_over(void **state)
{
    (void)state;
    struct crowd crowd = make_crowd(CROWD_FLAT, 7);
    char lamp[128], plane[128];
    snprintf(lamp, sizeof lamp, "{type: point, position: [%g, %g, %g], intensity: 100}", CROWD_LAMP[0], CROWD_LAMP[1],
             CROWD_LAMP[2]);
    snprintf(plane, sizeof plane, "{center: [0, 0, 0], size: [%d, %d], n: [2, 2]}", CROWD_SIZE, CROWD_SIZE);
    expect_flux(crowd.text, lamp, plane, 100 * open_solid_angle(&crowd), 1e-7);
}

/* Balls and tilted plates under parallel light: what is left of lines across the plane, which a sum over many of them
 * finds to some 1e-8 of it. */
static void crowds_under_the_sun(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 3; seed++) {
        struct crowd crowd = make_crowd(CROWD_MIXED, seed);
        char plane[128];
        snprintf(plane, sizeof plane, "{center: [0, 0, 0], size: [%d, %d], n: [2, 2]}", CROWD_SIZE, CROWD_SIZE);
        luxel_scene *scene = scene_with(crowd.text, "{type: distant, direction: [0, 0, -1], irradiance: 5}", plane);
        luxel_grid *grid = measure(scene, 0);
        const double expected = 5 * open_area(&crowd) * 1e-6;
        if (!(fabs(grid->flux.value - expected) <= 1e-6 * expected && grid->flux.error <= 1e-6 * expected))
            fail_msg("seed %d: %.12g +- %g, not %.12g", (int)seed, grid->flux.value, grid->flux.error, expected);
        luxel_grid_free(grid);
        luxel_scene_free(scene);
    }
}

/* Penumbrae of many surfaces are more than the work may resolve; the bound is no more than the light without them. */
static void bounds_of_penumbrae(void **state)
{
    (void)state;
    struct crowd crowd = make_crowd(CROWD_MIXED, 5);
    const char *lamp = "{type: planar, rectangle: {center: [10, 20, 900], size: [50, 50]}, radiance: 10000}";
    char plane[128];
    snprintf(plane, sizeof plane, "{center: [0, 0, 0], size: [%d, %d], n: [12, 12]}", CROWD_SIZE, CROWD_SIZE);
    luxel_scene *open = scene_with(NULL, lamp, plane), *scene = scene_with(crowd.text, lamp, plane);
    luxel_grid *whole = measure(open, 0), *grid = measure(scene, 0);
    assert_true(grid->flux.value >= 0 && grid->flux.value <= whole->flux.value + whole->flux.error);
    assert_true(grid->flux.error <= whole->flux.value + whole->flux.error);
    assert_true(fabs(grid->flux.value - grid->average.value * CROWD_SIZE * CROWD_SIZE * 1e-6) < 0.1 * grid->flux.value);
    luxel_grid_free(whole);
    luxel_grid_free(grid);
    luxel_scene_free(open);
    luxel_scene_free(scene);
}

/* Behind one surface the bound of a penumbra is small, and holds what many cells tell. */
static void penumbrae_of_one(void **state)
{
    static const char *const surfaces[] = {
        "{type: sphere, center: [300, -200, 600], radius: 250}",
        "{type: rectangle, center: [300, -200, 600], size: [700, 500]}",
        "{type: rectangle, center: [300, -200, 300], size: [700, 500], axis: [0.3, 0, 1]}",
    };
    static const double greatest[] = {5e-3, 2e-2, 3e-2};
    (void)state;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        luxel_scene *scene = scene_with(
            surfaces[i], "{type: planar, rectangle: {center: [0, 0, 1800], size: [800, 500]}, radiance: 10}",
            "{center: [0, 0, 0], size: [1600, 1600], n: [3, 3]}, {center: [0, 0, 0], size: [1600, 1600], n: [72, 72]}");
        luxel_grid *grid = measure(scene, 0), *fine = NULL;
        assert_int_equal(luxel_find_grid_values(scene, NULL, 1, NULL, &fine), LUXEL_OK);
        if (!(fabs(grid->mean.value - fine->average.value) <= grid->mean.error &&
              grid->mean.error <= greatest[i] * grid->mean.value))
            fail_msg("%s: %.9g +- %.3g, and %.9g of many cells", surfaces[i], grid->mean.value, grid->mean.error,
                     fine->average.value);
        assert_true(fabs(grid->flux.value - 2.56 * grid->mean.value) <= 1e-12 * grid->flux.value);
        luxel_grid_free(grid);
        luxel_grid_free(fine);
        luxel_scene_free(scene);
    }
}

/* Values alone are the same ones, without what is asked of the plane as a whole. */
static void values_alone(void **state)
{
    (void)state;
    luxel_scene *scene = scene_with(NULL, "{type: point, position: [10, 0, 20], intensity: 100}",
                                    "{center: [0, 0, 0], size: [100, 80], n: [5, 4]}");
    luxel_grid *whole = measure(scene, 0), *alone = NULL;
    assert_int_equal(luxel_find_grid_values(scene, NULL, 0, NULL, &alone), LUXEL_OK);
    assert_memory_equal(whole->values, alone->values, 20 * sizeof *whole->values);
    assert_true(whole->average.value == alone->average.value && whole->u0 == alone->u0 &&
                whole->measured == alone->measured);
    assert_true(whole->has_mean && whole->has_sampling_error && !alone->has_mean && !alone->has_sampling_error);
    luxel_grid_free(whole);
    luxel_grid_free(alone);
    luxel_scene_free(scene);
}

/* Where the light varies over a cell, it is said so; where there is no flux, from a coarser grid. */
static void sampling(void **state)
{
    (void)state;
    static const struct {
        const char *attenuation;
        unsigned n;
        bool is_coarse;
    } cases[] = {{"inverse-square", 10, true}, {"inverse-square", 400, false}, {"none", 1, true}, {"none", 60, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char light[128], plane[128];
        const bool has_mean = strcmp(cases[i].attenuation, "none") != 0;
        snprintf(light, sizeof light, "{type: point, position: [0, 0, 20], intensity: 100, attenuation: %s}",
                 cases[i].attenuation);
        snprintf(plane, sizeof plane, "{center: [0, 0, 0], size: [1000, 1000], n: [%u, %u]}", cases[i].n, cases[i].n);
        luxel_scene *scene = scene_with(NULL, light, plane);
        luxel_grid *grid = measure(scene, 0);
        assert_true(grid->has_sampling_error && grid->has_mean == has_mean && grid->sampling_is_bound == has_mean);
        if (grid->is_coarse != cases[i].is_coarse)
            fail_msg("case %zu: sampling error %g of %g", i, grid->sampling_error, grid->average.value);
        if (has_mean)
            assert_true(grid->sampling_error >= fabs(grid->average.value - grid->mean.value));
        assert_true(grid->has_evenness && grid->u0 == grid->minimum.value / grid->average.value);
        luxel_grid_free(grid);
        luxel_scene_free(scene);
    }
    luxel_scene *scene = scene_with("{type: sphere, center: [0, 0, 0], radius: 200}", "{type: ambient, irradiance: 1}",
                                    "{center: [0, 0, 0], size: [900, 900], n: [3, 3]}");
    luxel_grid *grid = measure(scene, 0);
    assert_true(grid->enclosed == 1 && grid->enclosing_surface == 0 && grid->measured == 8);
    assert_true(!grid->has_sampling_error && grid->has_mean && fabs(grid->mean.value - 1) <= grid->mean.error);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

/* Tubes across parallel light, whose ends are then seen edge-on, or nearly so: their shadows are rectangles. */
static void tubes_across(void **state)
{
    (void)state;
    const char *plane = "{center: [0, 0, 0], size: [1000, 800], n: [4, 3]}";
    const char *suns[] = {"[0, 0, -1]", "[1e-8, 0, -1]", "[1e-7, 0, -1]", "[1e-6, 0, -1]"};
    char light[80];
    for (size_t i = 0; i < sizeof suns / sizeof *suns; i++) {
        snprintf(light, sizeof light, "{type: distant, direction: %s, irradiance: 1}", suns[i]);
        expect_flux("{type: cylinder, center: [0, 240, 0], axis: [1, 0, 0], radius: 2, height: 600}", light, plane,
                    0.8 - 0.0024, 1e-7);
        expect_flux("{type: cylinder, center: [500, 239.68, 1], axis: [1, 0, 0], radius: 2, height: 1000}", light,
                    plane, 0.8 - 0.002, 1e-7);
    }
}

/* A luminaire near the plane, whose light reaches it at few azimuths about an axis that lies along it: the average of
 * many cells is the mean. */
static void along_the_plane(void **state)
{
    (void)state;
    luxel_scene *scene = scene_with(NULL,
                                    "{type: luminaire, file: 'builtin:office-lamp.ies', position: [250, 400, 10], "
                                    "axis: [1.647, 0.641, -0.034]}",
                                    "{center: [0, 0, 0], size: [100, 2000], n: [150, 600]}");
    luxel_grid *grid = measure(scene, 0);
    assert_true(grid->has_mean && grid->average.value > 0);
    assert_true(grid->mean.error <= 1e-8 * grid->mean.value);
    if (!(fabs(grid->mean.value - grid->average.value) <= 1e-3 * grid->average.value))
        fail_msg("%.17g +- %.3g is not %.17g", grid->mean.value, grid->mean.error, grid->average.value);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_numbers),       cmocka_unit_test(squares),
        cmocka_unit_test(closed_rooms),         cmocka_unit_test(shadows),
        cmocka_unit_test(values_alone),         cmocka_unit_test(sampling),
        cmocka_unit_test(plates_aside),         cmocka_unit_test(plates_over),
        cmocka_unit_test(crowds_under_the_sun), cmocka_unit_test(bounds_of_penumbrae),
        cmocka_unit_test(penumbrae_of_one),     cmocka_unit_test(along_the_plane),
        cmocka_unit_test(tubes_across),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

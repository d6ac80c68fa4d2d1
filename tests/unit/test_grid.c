/* SPDX-License-Identifier: MIT */
/*
 * Measuring grids through the public interface: where the cells are, their values against closed numbers, what is read
 * off them, the same bytes for any number of threads, cancelling, and what is refused.
 */
#include <float.h>
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

#include "world/cells.h"

#define SURFACE "{type: sphere, center: [0, 0, 9000], radius: 10}"

static luxel_scene *scene_of(const char *text, int length)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_status status = luxel_scene_read_text(text, (size_t)length, "test.yaml", diagnostics, &scene);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    if (status != LUXEL_OK) {
        char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
        fail_msg("%s: %s", text, message ? message : "?");
    }
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* A scene with these lights and grids; the sphere is far above and small, so that it shades nothing. */
static luxel_scene *scene_with(const char *units, const char *lights, const char *grids)
{
    char text[4096];
    int length = snprintf(text, sizeof text,
                          "luxel: 1\nunits: %s\nshadows: none\n"
                          "screen: {width: 100, height: 100, resolution: [8, 8]}\nobserver: {z: 20000}\n"
                          "surfaces: [" SURFACE "]\nlights: [%s]\ngrids: [%s]\n",
                          units, lights, grids);
    assert_true(length > 0 && (size_t)length < sizeof text);
    return scene_of(text, length);
}

static luxel_grid *measure(const luxel_scene *scene, size_t i)
{
    luxel_grid *grid = NULL;
    assert_int_equal(luxel_find_grid(scene, NULL, i, NULL, &grid), LUXEL_OK);
    assert_non_null(grid);
    return grid;
}

static void assert_near(double found, double expected, double relative)
{
    if (!(fabs(found - expected) <= relative * fabs(expected)))
        fail_msg("%.17g is not %.17g to %g", found, expected, relative);
}

static void assert_vector(const double found[3], double x, double y, double z)
{
    double far = fmax(fmax(fabs(found[0] - x), fabs(found[1] - y)), fabs(found[2] - z));
    if (!(far <= 1e-12 * (1 + fabs(x) + fabs(y) + fabs(z))))
        fail_msg("(%.17g, %.17g, %.17g) is not (%g, %g, %g)", found[0], found[1], found[2], x, y, z);
}

static void test_orientation(void **state)
{
    (void)state;
    luxel_scene *scene = scene_with("radiometric", "",
                                    "{center: [100, 200, 300], size: [40, 60], n: [2, 3]},"
                                    "{name: wall, center: [0, 0, 0], size: [40, 60], axis: [0, 5, 0], n: [2, 3]},"
                                    "{center: [0, 0, 0], size: [40, 60], axis: [1, 0, 0], up: [0, 3, 4], n: [4, 2]},"
                                    "{center: [0, 0, 0], size: [10, 20], axis: [1, 1, 1], up: [0, 0, 1], n: [1, 1]}");
    assert_int_equal(luxel_scene_grid_count(scene), 4);
    double place[3];

    luxel_grid *grid = measure(scene, 0);
    assert_null(grid->name);
    assert_int_equal(grid->columns, 2);
    assert_int_equal(grid->rows, 3);
    assert_vector(grid->axis, 0, 0, 1);
    assert_vector(grid->up, 0, 1, 0);
    assert_vector(grid->across, 1, 0, 0);
    luxel_grid_position(grid, 0, 0, place);
    assert_vector(place, 90, 220, 300);
    luxel_grid_position(grid, 1, 2, place);
    assert_vector(place, 110, 180, 300);
    luxel_grid_free(grid);

    /* Along y the default up is z, and across is z x y. */
    grid = measure(scene, 1);
    assert_string_equal(grid->name, "wall");
    assert_vector(grid->axis, 0, 1, 0);
    assert_vector(grid->up, 0, 0, 1);
    assert_vector(grid->across, -1, 0, 0);
    luxel_grid_position(grid, 0, 0, place);
    assert_vector(place, 10, 0, 20);
    luxel_grid_free(grid);

    grid = measure(scene, 2);
    assert_vector(grid->up, 0, 0.6, 0.8);
    assert_vector(grid->across, 0, 0.8, -0.6);
    luxel_grid_position(grid, 3, 0, place);
    assert_vector(place, 0, 15 * 0.8 + 15 * 0.6, -15 * 0.6 + 15 * 0.8);
    luxel_grid_free(grid);

    /* up is made perpendicular to the axis. */
    grid = measure(scene, 3);
    assert_vector(grid->up, -1 / sqrt(6), -1 / sqrt(6), 2 / sqrt(6));
    assert_vector(grid->across, -1 / sqrt(2), 1 / sqrt(2), 0);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

static void test_point_law(void **state)
{
    (void)state;
    const double height = 3, intensity = 1000;
    luxel_scene *scene =
        scene_with("photometric", "{type: point, pattern: lambertian, position: [0, 0, 3000], intensity: 1000}",
                   "{center: [0, 0, 0], size: [3500, 3500], n: [7, 7]}");
    luxel_grid *grid = measure(scene, 0);
    double sum = 0, errors = 0;
    assert_string_equal(grid->unit, "lx");
    assert_int_equal(grid->measured, 49);
    for (unsigned row = 0; row < 7; row++)
        for (unsigned column = 0; column < 7; column++) {
            double x = 0.5 * column - 1.5, y = 1.5 - 0.5 * row, square = x * x + y * y + height * height;
            double expected = intensity * height * height / (square * square);
            sum += expected;
            errors += grid->errors[7 * row + column];
            assert_int_equal(grid->mask[7 * row + column], 1);
            assert_near(grid->values[7 * row + column], expected, 1e-14);
            assert_true(grid->errors[7 * row + column] <= 1e-14 * expected);
            assert_true(grid->errors[7 * row + column] <= grid->error);
        }
    assert_near(grid->average.value, sum / 49, 1e-14);
    assert_true(grid->average.error >= errors / 49 * (1 - 1e-14) && grid->average.error <= 1e-14 * grid->average.value);
    assert_near(grid->maximum.value, 1000.0 / 9, 1e-14);
    assert_int_equal(grid->maximum.column, 3);
    assert_int_equal(grid->maximum.row, 3);
    assert_vector(grid->maximum.position_mm, 0, 0, 0);
    assert_near(grid->minimum.value, 9000 / (13.5 * 13.5), 1e-14);
    assert_true(grid->has_evenness);
    assert_near(grid->u0, grid->minimum.value / grid->average.value, 1e-15);
    assert_near(grid->ud, grid->minimum.value / grid->maximum.value, 1e-15);
    assert_string_equal(grid->flux_unit, "lm");
    assert_near(grid->flux.value, grid->mean.value * 12.25, 1e-15);
    assert_near(grid->mean.value, grid->average.value, 1e-2);
    assert_true(grid->has_sampling_error && grid->sampling_is_bound && !grid->is_coarse);
    assert_true(grid->sampling_error >= fabs(grid->average.value - grid->mean.value));
    assert_true(grid->tolerance_reached);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

/* CIE 171:2006, 5.4: what an isotropic source of 10 000 lm sends out falls on the walls of a closed room. */
static void test_closed_room(void **state)
{
    (void)state;
    static const char *const places[] = {"[0, 0, 1500]", "[700, -900, 2000]"};
    for (size_t p = 0; p < 2; p++) {
        char light[128];
        snprintf(light, sizeof light, "{type: point, position: %s, intensity: %.17g}", places[p], 10000 / (4 * M_PI));
        luxel_scene *scene =
            scene_with("photometric", light,
                       "{name: floor, center: [0, 0, 0], size: [4000, 4000], n: [80, 80]},"
                       "{name: ceiling, center: [0, 0, 3000], size: [4000, 4000], axis: [0, 0, -1], n: [80, 80]},"
                       "{center: [-2000, 0, 1500], size: [4000, 3000], axis: [1, 0, 0], up: [0, 0, 1], n: [80, 60]},"
                       "{center: [2000, 0, 1500], size: [4000, 3000], axis: [-1, 0, 0], up: [0, 0, 1], n: [80, 60]},"
                       "{center: [0, -2000, 1500], size: [4000, 3000], axis: [0, 1, 0], n: [80, 60]},"
                       "{center: [0, 2000, 1500], size: [4000, 3000], axis: [0, -1, 0], n: [80, 60]}");
        double flux = 0;
        for (size_t i = 0; i < 6; i++) {
            luxel_grid *grid = measure(scene, i);
            assert_string_equal(grid->flux_unit, "lm");
            flux += grid->flux.value;
            luxel_grid_free(grid);
        }
        assert_near(flux, 10000, 1e-13);
        luxel_scene_free(scene);
    }
}

static void test_uniform(void **state)
{
    (void)state;
    luxel_scene *scene = scene_with("radiometric", "{type: ambient, irradiance: 0.1}",
                                    "{center: [1, 2, 3], size: [7, 9], axis: [1, 2, 3], n: [31, 17]}");
    luxel_grid *grid = measure(scene, 0);
    assert_string_equal(grid->unit, "W/m²");
    assert_string_equal(grid->flux_unit, "W");
    assert_true(grid->average.value == 0.1 && grid->minimum.value == 0.1 && grid->maximum.value == 0.1);
    assert_true(grid->u0 == 1 && grid->ud == 1);
    assert_true(grid->average.error <= 4 * DBL_EPSILON * 0.1); /* many cells add nothing to it */
    /* Ties: the first in row order. */
    assert_int_equal(grid->minimum.column + grid->minimum.row + grid->maximum.column + grid->maximum.row, 0);
    luxel_grid_free(grid);
    luxel_scene_free(scene);

    /* Behind the light all is dark: no evenness, yet a flux of 0. */
    scene = scene_with("radiometric", "{type: distant, direction: [0, 0, -1], irradiance: 5}",
                       "{center: [0, 0, 0], size: [10, 10], axis: [0, 0, -1], n: [3, 3]}");
    grid = measure(scene, 0);
    assert_int_equal(grid->measured, 9);
    assert_true(grid->average.value == 0 && grid->maximum.value == 0 && !grid->has_evenness && grid->u0 == 0);
    assert_true(grid->flux_unit && grid->flux.value == 0);
    luxel_grid_free(grid);
    luxel_scene_free(scene);

    /* One cell of three has the least number that there is: the average has none, and there is no evenness of it. */
    scene = scene_with("radiometric",
                       "{type: spot, position: [0, 0, 5], intensity: 4.9406564584124654e-324, inner: 30, "
                       "outer: 30, attenuation: none}",
                       "{center: [10, 0, 0], size: [30, 10], n: [3, 1]}");
    grid = measure(scene, 0);
    assert_true(grid->maximum.value > 0 && grid->average.value == 0 && !grid->has_evenness && grid->u0 == 0);
    luxel_grid_free(grid);
    luxel_scene_free(scene);

    /* Without attenuation the values are no power by area. */
    scene = scene_with("radiometric", "{type: point, position: [0, 0, 5], intensity: 5, attenuation: none}",
                       "{center: [0, 0, 0], size: [10, 10], n: [3, 3]}");
    grid = measure(scene, 0);
    assert_null(grid->flux_unit);
    assert_true(grid->has_evenness && grid->flux.value == 0);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

static void test_on_source(void **state)
{
    (void)state;
    luxel_scene *scene =
        scene_with("radiometric", "{type: ambient, irradiance: 2}, {type: point, position: [10, 0, 0], intensity: 1}",
                   "{center: [0, 0, 0], size: [30, 30], n: [3, 3]},"
                   "{center: [10, 0, 0], size: [3, 3], n: [1, 1]}");
    luxel_grid *grid = measure(scene, 0);
    assert_int_equal(grid->measured, 8);
    assert_int_equal(grid->blocking_light, 1);
    assert_int_equal(grid->mask[5], 0);
    assert_true(grid->values[5] == 0 && grid->errors[5] == 0);
    assert_true(grid->average.value == 2 && grid->minimum.value == 2); /* the source is in the plane: it lights none */
    assert_null(grid->flux_unit);
    luxel_grid_free(grid);

    grid = measure(scene, 1);
    assert_int_equal(grid->measured, 0);
    assert_false(grid->has_evenness);
    assert_true(grid->average.value == 0 && grid->tolerance_reached);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

static void test_tolerance(void **state)
{
    (void)state;
    luxel_scene *scene = scene_with("radiometric", "{type: point, position: [1, 2, 30], intensity: 1}",
                                    "{center: [0, 0, 0], size: [30, 30], n: [3, 3]}");
    luxel_settings settings;
    luxel_grid *grid = NULL;
    luxel_settings_init(&settings);
    settings.tolerance = 1e-12;
    assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, &grid), LUXEL_OK);
    assert_true(grid->tolerance_reached);
    luxel_grid_free(grid);
    settings.tolerance = 1e-18;
    assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, &grid), LUXEL_OK);
    assert_false(grid->tolerance_reached);
    assert_int_equal(grid->measured, 9);
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

static void test_threads(void **state)
{
    (void)state;
    luxel_scene *scene = scene_with("radiometric",
                                    "{type: point, position: [100, 200, 300], intensity: 1},"
                                    "{type: spot, position: [0, 0, 500], aim: [9, 9, 0], intensity: 3, inner: 5,"
                                    " outer: 20, exponent: 2.5}",
                                    "{center: [0, 0, 0], size: [700, 300], axis: [0.1, 0.2, 1], n: [71, 33]}");
    static const unsigned counts[] = {1, 2, 3, 7, 64};
    luxel_settings settings;
    luxel_grid *one = NULL;
    luxel_settings_init(&settings);
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        luxel_grid *grid = NULL;
        settings.threads = counts[i];
        assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, &grid), LUXEL_OK);
        if (!one) {
            one = grid;
            continue;
        }
        assert_memory_equal(grid->values, one->values, (size_t)71 * 33 * sizeof(double));
        assert_memory_equal(grid->errors, one->errors, (size_t)71 * 33 * sizeof(double));
        assert_memory_equal(&grid->minimum, &one->minimum, sizeof one->minimum);
        assert_memory_equal(&grid->maximum, &one->maximum, sizeof one->maximum);
        assert_true(grid->average.value == one->average.value && grid->average.error == one->average.error);
        luxel_grid_free(grid);
    }
    luxel_grid_free(one);
    luxel_scene_free(scene);
}

/* A cell is the free element that a probe there is. */
static void test_probes_agree(void **state)
{
    (void)state;
    luxel_scene *scene = scene_with("radiometric",
                                    "{type: point, position: [100, 200, 300], intensity: 1},"
                                    "{type: ambient, irradiance: 0.25}",
                                    "{center: [5, 6, 7], size: [80, 60], axis: [3, 0, 4], n: [5, 4]}");
    luxel_settings settings;
    luxel_grid *grid = measure(scene, 0);
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    for (unsigned cell = 0; cell < 20; cell++) {
        luxel_probe *probe = NULL;
        double place[3];
        luxel_grid_position(grid, cell % 5, cell / 5, place);
        assert_int_equal(luxel_probe_element(scene, &settings, place, grid->axis, NULL, &probe), LUXEL_OK);
        assert_true(fabs(probe->value - grid->values[cell]) <= probe->error + grid->errors[cell]);
        assert_near(probe->value, grid->values[cell], 1e-14);
        luxel_probe_free(probe);
    }
    luxel_grid_free(grid);
    luxel_scene_free(scene);
}

static bool cancel(double done, void *data)
{
    assert_true(done >= 0 && done <= 1);
    ++*(unsigned *)data;
    return false;
}

static void expect_error(luxel_status found, luxel_status expected, luxel_diagnostics *diagnostics, const char *id)
{
    assert_int_equal(found, expected);
    assert_true(luxel_diagnostics_count(diagnostics) > 0);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, id);
    luxel_diagnostics_clear(diagnostics);
}

static void test_refusals(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = scene_with("radiometric", "{type: point, position: [0, 0, 1e-160], intensity: 1e300}",
                                    "{center: [9, 0, 0], size: [30, 30], n: [300, 300]}");
    luxel_settings settings;
    luxel_grid *grid = NULL;
    luxel_grid_extrema extrema;
    luxel_field *field = NULL;
    unsigned calls = 0, columns = 0, rows = 0;
    luxel_settings_init(&settings);

    expect_error(luxel_find_grid(NULL, NULL, 0, diagnostics, &grid), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "not-committed");
    expect_error(luxel_find_grid(scene, NULL, 0, diagnostics, NULL), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "missing-argument");
    expect_error(luxel_find_grid(scene, NULL, 1, diagnostics, &grid), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "no-such-grid");
    expect_error(luxel_find_grid_extrema(scene, NULL, 0, diagnostics, NULL), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "missing-argument");
    expect_error(luxel_find_grid_extrema(scene, NULL, 1, diagnostics, &extrema), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "no-such-grid");
    expect_error(luxel_find_grid_field(scene, NULL, 1, 2, 2, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "no-such-grid");
    expect_error(luxel_find_grid_values(scene, NULL, 1, diagnostics, &grid), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "no-such-grid");
    expect_error(luxel_find_grid_values(scene, NULL, 0, diagnostics, NULL), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "missing-argument");
    settings.threads = 5000;
    expect_error(luxel_find_grid(scene, &settings, 0, diagnostics, &grid), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "setting-out-of-range");
    expect_error(luxel_check_grid_output_name("a.png", diagnostics), LUXEL_ERROR_ARGUMENT, diagnostics, "grid-ending");
    expect_error(luxel_check_grid_output_name("csv", diagnostics), LUXEL_ERROR_ARGUMENT, diagnostics, "grid-ending");
    expect_error(luxel_check_grid_output_name("a/.csv", diagnostics), LUXEL_ERROR_ARGUMENT, diagnostics, "grid-ending");
    assert_int_equal(luxel_check_grid_output_name("a.b/c.CSV", diagnostics), LUXEL_OK);
    expect_error(luxel_grids_write(NULL, 0, "a.csv", diagnostics), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "missing-argument");

    assert_int_equal(luxel_scene_grid_resolution(scene, 0, &columns, &rows), LUXEL_OK);
    assert_int_equal(columns, 300);
    assert_int_equal(rows, 300);
    assert_int_equal(luxel_scene_grid_resolution(scene, 1, &columns, &rows), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_grid_count(NULL), 0);

    settings.threads = 0;
    settings.progress = cancel;
    settings.progress_data = &calls;
    assert_int_equal(luxel_find_grid(scene, &settings, 0, diagnostics, &grid), LUXEL_CANCELLED);
    assert_int_equal(calls, 1);
    luxel_scene_free(scene);

    scene = scene_with("radiometric", "{type: point, position: [0, 0, 1], intensity: 1e308}",
                       "{center: [0, 0, 0], size: [30, 30], n: [3, 3]}");
    expect_error(luxel_find_grid(scene, NULL, 0, diagnostics, &grid), LUXEL_ERROR_RANGE, diagnostics,
                 "value-too-large");

    /* A change takes the readiness away. */
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=3", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_grid_count(scene), 0);
    expect_error(luxel_find_grid(scene, NULL, 0, diagnostics, &grid), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "not-committed");
    assert_null(grid);
    luxel_grid_free(NULL);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* The rounding of places to float64, and 2^-90 of what they are summed of. */
static void test_places_of_cells(void **state)
{
    const struct lx_grid flat = {
        .center_mm = {30, -7, 400}, .size_mm = {80, 48}, .axis = {0, 0, -1}, .up = {0, 2, 0}, .n = {4, 3}};
    struct lx_grid tilted = flat;
    (void)state;
    struct lx_cells cells = lx_cells_of(&flat); /* across runs along -x */
    for (unsigned row = 0; row < 3; row++)
        for (unsigned column = 0; column < 4; column++) {
            lx_bounded3 place = lx_cell_place(&cells, column, row);
            const double u = 20 * column - 30.0, v = 16 - 16.0 * row;
            assert_vector((const double[]){place.x.value, place.y.value, place.z.value}, 30 - u, -7 + v, 400);
            assert_near(place.x.error, 0x1p-90 * (30 + fabs(u)), 1e-12);
            assert_near(place.y.error, 0x1p-90 * (7 + fabs(v)), 1e-12);
            assert_true(place.z.error == 0);
        }
    tilted.axis[0] = 0.6, tilted.axis[1] = 0.48, tilted.axis[2] = 0.64;
    cells = lx_cells_of(&tilted);
    double most = 0;
    for (unsigned column = 0; column < 4; column++) {
        lx_bounded3 place = lx_cell_place(&cells, column, 0);
        most = fmax(most, fmax(place.x.error, place.z.error));
        assert_true(place.x.error <= 0x1p-54 * fabs(place.x.value) * 2 && place.z.error <= 0x1p-54 * 1024);
    }
    assert_true(most > 0x1p-60);
}

#define PLANE "{center: [0, 0, 0], size: [4000, 3000], n: [4, 3]}"
#define BROAD "{type: point, position: [0, 0, 1000], intensity: 1000}"

/* A scene with a plane that one surface takes light from. */
static luxel_scene *scene_below(const char *surface, const char *lights)
{
    char text[2048];
    int length = snprintf(text, sizeof text,
                          "luxel: 1\nunits: photometric\nshadows: all\n"
                          "screen: {width: 100, height: 100, resolution: [8, 8]}\nobserver: {z: 20000}\n"
                          "surfaces: [%s]\nlights: [%s]\ngrids: [" PLANE "]\n",
                          surface, lights);
    assert_true(length > 0 && (size_t)length < sizeof text);
    return scene_of(text, length);
}

static luxel_grid_extrema extrema_of(luxel_scene *scene)
{
    luxel_grid_extrema extrema;
    assert_int_equal(luxel_find_grid_extrema(scene, NULL, 0, NULL, &extrema), LUXEL_OK);
    luxel_scene_free(scene);
    return extrema;
}

static void assert_on_plane(const luxel_grid_peak *peak, double x, double y, double near_mm)
{
    if (!(hypot(peak->on_plane_mm[0] - x, peak->on_plane_mm[1] - y) <= near_mm))
        fail_msg("%.9g, %.9g is not %g, %g", peak->on_plane_mm[0], peak->on_plane_mm[1], x, y);
}

/* Extrema far narrower than the lattice of samples, of closed values: below a source and where beams fall. */
static void test_narrow_peaks(void **state)
{
    (void)state;
    /* half a millimetre above the plane, on the slope of another one's hill: I/h^2 and what that gives there */
    luxel_grid_extrema found = extrema_of(
        scene_with("photometric", BROAD ", {type: point, position: [711, 307, 0.5], intensity: 0.00125}", PLANE));
    assert_near(found.maximum.value, 5000 + 1000 / pow(1 + 0.711 * 0.711 + 0.307 * 0.307, 1.5), 1e-8);
    assert_on_plane(&found.maximum, 711, 307, 1e-3);
    /* a spot ten millimetres wide */
    found = extrema_of(scene_with("photometric",
                                  "{type: ambient, irradiance: 100}, {type: spot, position: [711, 307, 2000], "
                                  "intensity: 20000, inner: 0.1, outer: 0.3}",
                                  PLANE));
    assert_near(found.maximum.value, 5100, 1e-12);
    assert_on_plane(&found.maximum, 711, 307, 0.1);
}

/* A ridge that is no straight line: the edge of a cone, of which the place is greatest that is nearest to a lamp. */
static void test_ridge(void **state)
{
    (void)state;
    const double turn = 37 * M_PI / 180, edge = 10 * M_PI / 180, out = 2 * tan(edge);
    char lights[400];
    snprintf(lights, sizeof lights,
             "{type: spot, position: [-311, 107, 2000], intensity: 20000, inner: 10, outer: 30, falloff: linear}, "
             "{type: point, position: [%.17g, %.17g, 1500], intensity: 7000}",
             -311 + 1500 * cos(turn), 107 + 1500 * sin(turn));
    const luxel_grid_extrema found = extrema_of(scene_with("photometric", lights, PLANE));
    const double lamp = 7000 * 1.5 / pow((1.5 - out) * (1.5 - out) + 1.5 * 1.5, 1.5);
    assert_near(found.maximum.value, 20000 * pow(cos(edge), 3) / 4 + lamp, 1e-9);
    assert_on_plane(&found.maximum, -311 + 1000 * out * cos(turn), 107 + 1000 * out * sin(turn), 0.01);
}

/* The least value in small shadows: of a ball 6 mm wide, and of a disk that hides the middle of a round source. */
static void test_small_shadows(void **state)
{
    (void)state;
    const luxel_grid_extrema hard =
        extrema_of(scene_below("{type: sphere, center: [711, 307, 30], radius: 3}",
                               "{type: ambient, irradiance: 7}, {type: point, position: [100, 200, 2000], intensity: "
                               "1000}"));
    assert_near(hard.minimum.value, 7, 1e-12);
    assert_on_plane(&hard.minimum, 720.3, 308.6, 4);
    const luxel_grid_extrema soft = extrema_of(
        scene_below("{type: disk, center: [711, 307, 20], radius: 4.9, axis: [0, 0, 1]}",
                    "{type: planar, radiance: 1000, disk: {center: [711, 307, 2000], radius: 500, axis: [0, 0, -1]}}"));
    const double source = 1 / (1 + 2000.0 * 2000 / (500.0 * 500)), hidden = 1 / (1 + 20 * 20 / (4.9 * 4.9));
    assert_near(soft.minimum.value, 1000 * M_PI * (source - hidden), 1e-8);
    assert_on_plane(&soft.minimum, 711, 307, 0.1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orientation),     cmocka_unit_test(test_point_law),    cmocka_unit_test(test_closed_room),
        cmocka_unit_test(test_uniform),         cmocka_unit_test(test_on_source),    cmocka_unit_test(test_tolerance),
        cmocka_unit_test(test_threads),         cmocka_unit_test(test_probes_agree), cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_places_of_cells), cmocka_unit_test(test_narrow_peaks), cmocka_unit_test(test_ridge),
        cmocka_unit_test(test_small_shadows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

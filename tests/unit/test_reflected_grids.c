/* SPDX-License-Identifier: MIT */
/*
 * Measuring planes in reflected light as a whole: their mean, flux and extrema, against a closed number, a sum of rays
 * and finer cells, within the bounds that are told.
 */
#include <math.h>

#include "scenes.h"

static void measure(const char *text, double wanted, luxel_grid **grid, luxel_grid_extrema *extrema,
                    luxel_field **finer)
{
    luxel_scene *scene;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.reflected_error = wanted;
    settings.threads = 2;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, grid), LUXEL_OK);
    assert_int_equal(luxel_find_grid_extrema(scene, &settings, 0, NULL, extrema), LUXEL_OK);
    if (finer)
        assert_int_equal(luxel_find_grid_field(scene, &settings, 0, 33, 21, NULL, finer), LUXEL_OK);
    luxel_scene_free(scene);
}

static void assert_within(double value, double truth, double error)
{
    if (!(fabs(value - truth) <= error))
        fail_msg("%.12g is farther than %.3g from %.12g", value, error, truth);
}

/* In a closed room that reflects half of all light the irradiance is twice the ambient one, whatever is asked where. */
static void furnace(void **state)
{
    static const char text[] = "luxel: 1\nreflections: all\nscreen: {width: 10, height: 10, resolution: [2, 2]}\n"
                               "observer: {z: 9000}\nsurfaces: [{type: room, center: [0, 0, 2000], size: [4000, 3000, "
                               "2000], material: {model: lambert, diffuse: 0.5, over_pi: true}}]\n"
                               "lights: [{type: ambient, irradiance: 1}]\n"
                               "grids: [{center: [100, 200, 1800], size: [1500, 1000], axis: [1, 2, 3], n: [4, 3]}]\n";
    luxel_grid *grid;
    luxel_grid_extrema extrema;
    (void)state;
    measure(text, 1e-3, &grid, &extrema, NULL);
    assert_true(grid->has_reflected && grid->has_mean && grid->has_sampling_error && grid->sampling_is_bound);
    assert_true(grid->mean.error < 5e-3 && !grid->is_coarse);
    assert_within(grid->mean.value, 2, grid->mean.error);
    assert_string_equal(grid->flux_unit, "W");
    assert_within(grid->flux.value, 3, grid->flux.error);
    assert_within(extrema.maximum.value, 2, extrema.maximum.error);
    assert_within(extrema.minimum.value, 2, extrema.minimum.error);
    assert_true(grid->sampling_error < 1e-2);
    luxel_grid_free(grid);
}

/* One bounce off a floor: the truth is a sum of 64 000 rays to each of 256 places, by Gauss's rules. */
static void one_bounce(void **state)
{
    static const char text[] =
        "luxel: 1\nreflections: 1\nscreen: {width: 3000, height: 2400, resolution: [30, 24]}\nobserver: {z: 9000}\n"
        "surfaces: [{type: rectangle, center: [0, 0, 0], size: [4000, 3000], material: {model: lambert, diffuse: 0.7, "
        "over_pi: true}}]\n"
        "lights: [{type: point, position: [300, 200, 900], intensity: 100}]\n"
        "grids: [{center: [200, 100, 600], size: [1000, 600], axis: [0, 0, -1], n: [5, 3]}]\n";
    luxel_grid *grid;
    luxel_grid_extrema extrema;
    luxel_field *finer;
    (void)state;
    measure(text, 1e-4, &grid, &extrema, &finer);
    assert_true(grid->has_mean && grid->mean.error < 1e-3 * grid->mean.value);
    assert_within(grid->mean.value, 41.8953059, grid->mean.error);
    assert_within(grid->flux.value, 25.13718354, grid->flux.error);
    assert_true(grid->sampling_is_bound && fabs(grid->average.value - grid->mean.value) <= grid->sampling_error);
    const luxel_statistics *statistics = luxel_field_statistics(finer);
    assert_within(statistics->mean, 41.8953059, 5e-3 * 41.8953059);
    assert_true(extrema.maximum.value + 2 * extrema.maximum.error >= statistics->maximum.value);
    assert_true(extrema.minimum.value - 2 * extrema.minimum.error <= statistics->minimum.value);
    assert_true(extrema.maximum.value >= grid->maximum.value - extrema.maximum.error);
    /* between the nodes of the lattice: over the lamp's foot, or near it */
    assert_true(hypot(extrema.maximum.on_plane_mm[0] - 100, extrema.maximum.on_plane_mm[1]) > 1);
    luxel_field_free(finer);
    luxel_grid_free(grid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(furnace), cmocka_unit_test(one_bounce)};
    return cmocka_run_group_tests_name("planes in reflected light", tests, NULL, NULL);
}

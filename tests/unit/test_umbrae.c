/* SPDX-License-Identifier: MIT */
/*
 * Where shadows end.  At the tip of an umbra what stands in the way covers a lamp exactly, so that nothing arrives:
 * bounds there are no less than what rounding makes of that, and far below the lamp's light.  Next to it what is left
 * of the lamp is a strip, whose light without anything in the way is known in closed form.  Beyond the edge of the
 * shadow that a flat surface throws under a point, by however little, light arrives or the bound says that it may.
 */
#include <math.h>
#include <stdio.h>

#include "base/bounded.h"
#include "scenes.h"

static const double UPWARDS[3] = {0, 0, 1}, ASLANT[3] = {0.25, 0.5, 1};

/* The irradiance of an element. */
static lx_bounded ask(const char *surfaces, const char *lights, const double place[3], const double normal[3])
{
    char text[1200];
    luxel_scene *scene;
    luxel_probe *probe;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    snprintf(text, sizeof text,
             "luxel: 1\nscreen: {width: 100, height: 100, resolution: [10, 10]}\nobserver: {z: 100000}\n"
             "surfaces: [%s]\nlights: [%s]\n",
             surfaces, lights);
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("not a scene:\n%s", text);
    const luxel_settings settings = {.quantity = LUXEL_IRRADIANCE};
    assert_int_equal(luxel_probe_element(scene, &settings, place, normal, diagnostics, &probe), LUXEL_OK);
    const lx_bounded found = {probe->value, probe->error};
    luxel_probe_free(probe);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    return found;
}

#define FAR_PLATE "{type: rectangle, center: [0, 0, -5000], size: [1, 1]}"
#define SQUARE "{type: planar, rectangle: {center: [0, 0, 1000], size: [300, 300]}, radiance: 1000}"
#define DISK "{type: planar, disk: {center: [0, 0, 1000], radius: 150}, radiance: 1000}"
#define BALL "{type: volume, sphere: {center: [0, 0, 500], radius: 250}, radiance: 1000}"

/* What covers a lamp exactly. */
static const struct tip {
    const char *surface, *light;
    double place[3];
} tips[] = {
    {"{type: rectangle, center: [-100000, 0, 500], size: [200000, 200000]}", SQUARE, {-150, 0, 0}},
    {"{type: rectangle, center: [-100000, 0, 250], size: [200000, 200000]}",
     "{type: planar, rectangle: {center: [0, 0, 500], size: [200, 200]}, radiance: 1000}",
     {-100, 100, 0}},
    {"{type: rectangle, center: [0, 0, 400], size: [120, 120]}", SQUARE, {0, 0, 0}},
    {"{type: rectangle, center: [12.5, -7.25, 311.08], size: [120, 120]}",
     "{type: planar, rectangle: {center: [12.5, -7.25, 777.7], size: [300, 300]}, radiance: 1000}",
     {12.5, -7.25, 0}},
    {"{type: disk, center: [0, 0, 400], radius: 60}", DISK, {0, 0, 0}},
    {"{type: sphere, center: [0, 0, 200], radius: 100}", BALL, {0, 0, 0}},
    {"{type: cylinder, center: [0, 0, 125], radius: 55.90169943749474, height: 20000, axis: [0, 1, 0]}",
     "{type: planar, rectangle: {center: [0, 0, 500], size: [500, 500]}, radiance: 1000}",
     {0, 0, 0}},
};

static void exact_cover(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof tips / sizeof *tips; i++)
        for (int k = 0; k < 2; k++) {
            const double *normal = k ? ASLANT : UPWARDS;
            const lx_bounded seen = ask(tips[i].surface, tips[i].light, tips[i].place, normal);
            const lx_bounded all = ask(FAR_PLATE, tips[i].light, tips[i].place, normal);
            assert_true(seen.value >= 0 && seen.value <= seen.error);
            assert_true(seen.error <= 1e-10 * all.value);
        }
}

static void strips(void **state)
{
    (void)state;
    for (int power = 1; power <= 30; power++) {
        const double width = ldexp(1, -power), place[3] = {-150 + width, 0, 0};
        char strip[200];
        snprintf(strip, sizeof strip,
                 "{type: planar, vertices: [[%.17g, 150, 1000], [150, 150, 1000], [150, -150, 1000], [%.17g, -150, "
                 "1000]], radiance: 1000}",
                 150 - width, 150 - width);
        const lx_bounded seen = ask(tips[0].surface, SQUARE, place, UPWARDS);
        const lx_bounded alone = ask(FAR_PLATE, strip, place, UPWARDS);
        assert_true(fabs(seen.value - alone.value) <= seen.error + alone.error);
        assert_true(seen.error <= 1e-9);
    }
}

/* A plate of a hundred metres and one of half a metre, a disk and a tube, which end at x = 0 half way up to a point at
 * (100, 0, 1000): places are dark up to x = -100. */
static void edges(void **state)
{
    static const char *const surfaces[] = {
        "{type: rectangle, center: [-100000, 0, 500], size: [200000, 200000]}",
        "{type: rectangle, center: [-300, 0, 500], size: [600, 600]}",
        "{type: disk, center: [-3000, 0, 500], radius: 3000}",
        "{type: cylinder, center: [-1000, 0, 1400], radius: 900, height: 2000, axis: [1, 0, 0]}",
    };
    static const char light[] = "{type: point, position: [100, 0, 1000], intensity: 1}";
    (void)state;
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        for (double off = 1e-6; off > 2e-13; off /= 2) {
            const double lit[3] = {-100 + off, 0, 0}, dark[3] = {-100 - off, 0, 0};
            const lx_bounded seen = ask(surfaces[i], light, lit, UPWARDS), all = ask(FAR_PLATE, light, lit, UPWARDS);
            assert_true(fabs(seen.value - all.value) <= seen.error + all.error);
            assert_true(seen.value > 0 || off < 1e-6);
            const lx_bounded hidden = ask(surfaces[i], light, dark, UPWARDS);
            assert_true(hidden.value <= hidden.error);
            assert_true(hidden.error == 0 || off < 1e-6);
        }
        assert_true(ask(surfaces[i], light, (const double[]){-100, 0, 0}, UPWARDS).value == 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_cover),
        cmocka_unit_test(strips),
        cmocka_unit_test(edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

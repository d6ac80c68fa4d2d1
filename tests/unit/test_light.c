/* SPDX-License-Identifier: MIT */
/*
 * What lights give off in all, against closed forms, against numbers that mpmath gave with 30 digits, and against the
 * irradiance of probes summed up over a sphere around the light; where lights stand and which way they shine.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "light/gauss.h"
#include "scenes.h"

/* A scene with this light. */
static luxel_scene *lit_by(const char *light)
{
    static const char form[] = "luxel: 1\n"
                               "screen: {width: 10, height: 10, resolution: [2, 2]}\n"
                               "observer: {z: 0}\n"
                               "surfaces: [{type: sphere, center: [0, 0, -20000], radius: 1}]\n"
                               "lights: [%s]\n";
    char text[1024];
    luxel_scene *scene = NULL;
    snprintf(text, sizeof text, form, light);
    if (load(text, NULL, &scene) != LUXEL_OK)
        fail_msg("no good light: %s", light);
    return scene;
}

static void expect_near(const char *what, double found, double expected, double tolerance)
{
    if (!(fabs(found - expected) <= tolerance * fabs(expected)))
        fail_msg("%s: %.17g, not %.17g", what, found, expected);
}

static double flux_of(const char *light)
{
    luxel_scene *scene = lit_by(light);
    double flux = -1;
    assert_int_equal(luxel_scene_light_count(scene), 1);
    assert_int_equal(luxel_scene_light_flux(scene, 0, &flux), LUXEL_OK);
    luxel_scene_free(scene);
    return flux;
}

static void closed_forms(void **state)
{
    (void)state;
    static const struct {
        const char *light;
        double flux;
    } cases[] = {
        {"{type: point, position: [9, 9, 9], intensity: 10}", 40 * M_PI},
        {"{type: point, position: [9, 9, 9], intensity: 10, enabled: false}", 40 * M_PI},
        {"{type: point, position: [9, 9, 9], intensity: 10, attenuation: practical, k: 9}", 40 * M_PI},
        {"{type: point, position: [9, 9, 9], intensity: 0}", 0},
        {"{type: point, position: [9, 9, 9], intensity: 10, pattern: lambertian}", 10 * M_PI},
        {"{type: point, position: [9, 9, 9], intensity: 10, pattern: cosine, exponent: 4}", 4 * M_PI},
        /* x^0 = 1 for a light behind, too */
        {"{type: point, position: [9, 9, 9], intensity: 10, pattern: cosine, exponent: 0}", 40 * M_PI},
        {"{type: planar, rectangle: {center: [9, 9, 9], size: [600, 300]}, radiance: 90}", 90 * M_PI * 0.18},
        {"{type: planar, rectangle: {center: [9, 9, 9], size: [600, 300]}, intensity: 9, parts: 7}", 9 * M_PI},
        {"{type: planar, disk: {center: [9, 9, 9], radius: 300}, radiance: 90, attenuation: none}",
         90 * M_PI * M_PI * 0.09},
        {"{type: planar, vertices: [[0, 0, 9], [0, 900, 9], [900, 900, 9], [900, 700, 9], [200, 700, 9], [200, 0, 9]], "
         "radiance: 10}",
         10 * M_PI * 0.32},
        {"{type: volume, box: {center: [9, 9, 9], size: [100, 200, 300]}, radiance: 50, parts: 1000}",
         50 * M_PI * 0.22},
        {"{type: volume, sphere: {center: [9, 9, 9], radius: 200}, radiance: 50}", 50 * M_PI * 4 * M_PI * 0.04},
        {"{type: volume, cylinder: {center: [9, 9, 9], radius: 200, height: 300}, radiance: 50}",
         50 * M_PI * 2 * M_PI * 0.1},
        /* an octahedron: eight triangles with edges of sqrt(2) 200 mm */
        {"{type: volume, sphere: {center: [9, 9, 9], radius: 200, facets: 4}, radiance: 50}",
         50 * M_PI * 2 * 1.7320508075688772 * 0.08},
        {"{type: volume, sphere: {center: [9, 9, 9], radius: 200, facets: 9}, power: 250, parts: 2}", 250},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_near(cases[i].light, flux_of(cases[i].light), cases[i].flux, 1e-14);
    assert_true(isnan(flux_of("{type: ambient, irradiance: 5}")));
    assert_true(isnan(flux_of("{type: distant, direction: [0, 0, -1], irradiance: 5}")));
}

static void spots(void **state)
{
    (void)state;
    static const struct {
        const char *falloff;
        double inner, outer, exponent, flux;
    } cases[] = {
        {"smoothstep", 20, 30, 0, 0.61035482673471048},
        {"squared", 20, 30, 0, 0.53321069646},
        {"linear", 20, 30, 0, 0.59591047},
        {"hard", 20, 30, 0, 0.84178721},
        {"squared", 30, 30, 0, 0.84178721},
        {"smoothstep", 0, 90, 0.5, 2.5930606029630039},
        {"smoothstep", 0, 60, 20, 0.28737323920712532},
        {"smoothstep", 10, 12, 500, 0.012539872818892152},
        {"smoothstep", 0, 40, 1e4, 6.2825501739432279e-4},
        {"smoothstep", 45, 90, 3.3, 1.4182537497031277},
        {"smoothstep", 0.001, 0.002, 0, 2.3924596201870157e-9},
        {"smoothstep", 0, 0.0001, 7, 4.7849192407704906e-12},
        {"squared", 0, 90, 0.5, 1.7951958020513104},
        {"squared", 0, 60, 20, 0.24952985070936129},
        {"linear", 0, 90, 0.5, 1.8580723787489512},
        {"linear", 10, 12, 500, 0.012539546985579623},
        {"linear", 0, 40, 1e4, 6.1697785159588785e-4},
        {"linear", 0, 90, 2.7, 1.0392814670698717},
        {"hard", 0, 0, 0, 0},
        {"smoothstep", 0, 90, 1e300, 2 * M_PI / 1e300},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char light[256];
        snprintf(light, sizeof light,
                 "{type: spot, position: [9, 9, 9], intensity: 1, inner: %g, outer: %g, falloff: %s, exponent: %g}",
                 cases[i].inner, cases[i].outer, cases[i].falloff, cases[i].exponent);
        /* SPEC 3 has eight digits */
        expect_near(light, flux_of(light), cases[i].flux, i > 0 && i < 5 ? 6e-9 : 1e-13);
    }
}

/* ---- against probes ---- */

/* The sphere that is probed, in mm; its centre is that of the lights. */
static const double ROUND = 4000, CENTER[3] = {1, 2, 3};

/* How a sphere is divided: circles around an axis, dense between the angles where the irradiance is not smooth. */
struct division {
    double axis[3];
    int places; /* on each circle */
    int bend_count;
    double bends[4]; /* cosines of those angles, rising */
};

static double irradiance(const luxel_scene *scene, const double out[3])
{
    double place[3], normal[3];
    luxel_settings settings;
    luxel_probe *probe = NULL;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    for (int i = 0; i < 3; i++) {
        place[i] = CENTER[i] + ROUND * out[i];
        normal[i] = -out[i];
    }
    assert_int_equal(luxel_probe_element(scene, &settings, place, normal, NULL, &probe), LUXEL_OK);
    double value = probe->value;
    luxel_probe_free(probe);
    return value;
}

/* Over the circle at this cosine from the axis. */
static double around(const luxel_scene *scene, const struct division *division, double cosine)
{
    double length = sqrt(division->axis[0] * division->axis[0] + division->axis[1] * division->axis[1] +
                         division->axis[2] * division->axis[2]);
    double a[3], u[3], v[3], total = 0, sine = sqrt(1 - cosine * cosine);
    for (int i = 0; i < 3; i++)
        a[i] = division->axis[i] / length;
    double flat = hypot(a[0], a[2]);
    u[0] = -a[2] / flat, u[1] = 0, u[2] = a[0] / flat;
    v[0] = a[1] * u[2], v[1] = a[2] * u[0] - a[0] * u[2], v[2] = -a[1] * u[0];
    for (int k = 0; k < division->places; k++) {
        double turn = 2 * M_PI * (k + 0.25) / division->places, out[3];
        for (int i = 0; i < 3; i++)
            out[i] = cosine * a[i] + sine * (cos(turn) * u[i] + sin(turn) * v[i]);
        total += irradiance(scene, out);
    }
    return total * 2 * M_PI / division->places;
}

static double flux_through_sphere(const char *light, const struct division *division)
{
    luxel_scene *scene = lit_by(light);
    double total = 0;
    for (int b = 0; b <= division->bend_count; b++) {
        double from = b > 0 ? division->bends[b - 1] : -1, to = b < division->bend_count ? division->bends[b] : 1;
        double half = (to - from) / 2;
        for (int i = 0; i < LX_GAUSS_NODES; i++)
            total += half * lx_gauss[i].weight * around(scene, division, from + half * (1 + lx_gauss[i].place));
    }
    luxel_scene_free(scene);
    return total * ROUND * ROUND / 1e6;
}

static void sums_over_spheres(void **state)
{
    (void)state;
    const double c20 = cos(20 * M_PI / 180), c30 = cos(30 * M_PI / 180);
    const struct division smooth = {{1, 0, 0}, 2, 0, {0}}, down = {{0, 0, -1}, 2, 1, {0}},
                          tilted = {{1, 2, -2}, 2, 1, {0}}, plate = {{1, 2, -2}, 16, 1, {0}},
                          polygon = {{0, 0, -1}, 16, 1, {0}}, cone = {{0, 0, -1}, 2, 2, {c30, c20}},
                          tilted_cone = {{1, 2, -2}, 2, 2, {c30, c20}};
    /* A cap is seen from above its plane, 200 mm high; the side from farther than 200 mm from the axis. */
    const struct division box = {{0, 0, 1}, 16, 2, {-0.05, 0.05}},
                          tube = {{0, 0, 1}, 2, 4, {-0.9987492177719089, -0.05, 0.05, 0.9987492177719089}};
    const struct {
        const struct division *division;
        double tolerance;
        const char *light;
    } cases[] = {
        {&smooth, 1e-13, "{type: point, position: [1, 2, 3], intensity: 3}"},
        {&tilted, 1e-13, "{type: point, position: [1, 2, 3], intensity: 3, pattern: lambertian, axis: [1, 2, -2]}"},
        {&tilted, 1e-13,
         "{type: point, position: [1, 2, 3], intensity: 3, pattern: cosine, exponent: 3, aim: [2, 4, 1]}"},
        {&tilted_cone, 1e-12,
         "{type: spot, position: [1, 2, 3], intensity: 3, inner: 20, outer: 30, axis: [1, 2, -2]}"},
        {&cone, 1e-12,
         "{type: spot, position: [1, 2, 3], intensity: 3, inner: 20, outer: 30, falloff: squared, exponent: 4}"},
        {&cone, 1e-12,
         "{type: spot, position: [1, 2, 3], intensity: 3, inner: 20, outer: 30, falloff: linear, exponent: 30}"},
        {&cone, 1e-12, "{type: spot, position: [1, 2, 3], intensity: 3, inner: 20, outer: 30, falloff: hard}"},
        {&plate, 1e-10, "{type: planar, rectangle: {center: [1, 2, 3], size: [600, 300], axis: [1, 2, -2]}, power: 9}"},
        {&polygon, 1e-10,
         "{type: planar, intensity: 4, vertices: "
         "[[0, 0, 3], [0, 600, 3], [600, 600, 3], [600, 400, 3], [200, 400, 3], [200, 0, 3]]}"},
        {&down, 1e-10, "{type: planar, disk: {center: [1, 2, 3], radius: 200}, radiance: 60}"},
        {&smooth, 1e-12, "{type: volume, sphere: {center: [1, 2, 3], radius: 200}, radiance: 5}"},
        {&tube, 1e-5, "{type: volume, cylinder: {center: [1, 2, 3], radius: 200, height: 400}, radiance: 5}"},
        {&box, 1e-3, "{type: volume, box: {center: [1, 2, 3], size: [200, 200, 400]}, power: 70}"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_near(cases[i].light, flux_of(cases[i].light), flux_through_sphere(cases[i].light, cases[i].division),
                    cases[i].tolerance);
}

/* A cone whose two angles are one has an edge and no falloff, whatever that is called. */
static void cones_of_one_angle(void **state)
{
    (void)state;
    static const char *const falloffs[] = {"smoothstep", "squared", "linear", "hard"};
    static const double radians = M_PI / 180;
    for (size_t i = 0; i < sizeof falloffs / sizeof *falloffs; i++) {
        char light[160];
        snprintf(light, sizeof light,
                 "{type: spot, position: [1, 2, 3], intensity: 8, inner: 30, outer: 30, falloff: %s}", falloffs[i]);
        luxel_scene *scene = lit_by(light);
        expect_near(falloffs[i], irradiance(scene, (double[]){sin(29.9 * radians), 0, -cos(29.9 * radians)}), 0.5,
                    1e-14);
        assert_true(irradiance(scene, (double[]){sin(30.1 * radians), 0, -cos(30.1 * radians)}) == 0);
        assert_true(irradiance(scene, (double[]){0, 0, 1}) == 0);
        luxel_scene_free(scene);
        /* of none the axis itself */
        snprintf(light, sizeof light,
                 "{type: spot, position: [1, 2, 3], intensity: 8, inner: 0, outer: 0, falloff: %s}", falloffs[i]);
        scene = lit_by(light);
        expect_near(falloffs[i], irradiance(scene, (double[]){0, 0, -1}), 0.5, 1e-14);
        assert_true(irradiance(scene, (double[]){1e-3, 0, -1}) == 0);
        luxel_scene_free(scene);
    }
}

/* An element that a source lies on has no value, and is told which source that is; a millimetre away it has one. */
static void sources_on_elements(void **state)
{
    (void)state;
    static const char *const lights[] = {
        "{type: point, position: [0.5, 0.75, 3], intensity: 5}",
        "{type: point, position: [0.5, 0.75, 3], intensity: 5, pattern: lambertian, attenuation: none}",
        "{type: spot, position: [0.5, 0.75, 3], intensity: 5, inner: 10, outer: 20}",
        "{type: planar, rectangle: {center: [0.5, 0.75, 3], size: [7, 5]}, radiance: 5}",
        "{type: planar, rectangle: {center: [4, 3.25, 3], size: [7, 5]}, radiance: 5}",
        "{type: planar, disk: {center: [1.5, 0.75, 3], radius: 2}, radiance: 5}",
        "{type: volume, sphere: {center: [0.5, 2.75, 3], radius: 2}, radiance: 5}",
        "{type: volume, box: {center: [1, 0.75, 4], size: [4, 5, 2]}, radiance: 5}",
        "{type: volume, cylinder: {center: [0.5, 2.75, 3], radius: 2, height: 9}, radiance: 5}",
        "{type: volume, cylinder: {center: [0.5, 1.75, 5.5], radius: 2, height: 5}, radiance: 5}",
    };
    static const double on[3] = {0.5, 0.75, 3}, below[3] = {0.5, -0.25, 2}, normal[3] = {0, 0.6, 0.8};
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        luxel_probe *probe = NULL;
        char both[256];
        snprintf(both, sizeof both, "{type: ambient, irradiance: 2}, %s", lights[i]);
        luxel_scene *scene = lit_by(both);
        assert_int_equal(luxel_probe_element(scene, NULL, on, normal, NULL, &probe), LUXEL_OK);
        if (probe->has_value || !probe->source_on_element || probe->blocking_light != 1)
            fail_msg("not noticed on the element: %s", lights[i]);
        luxel_probe_free(probe);
        assert_int_equal(luxel_probe_element(scene, NULL, below, normal, NULL, &probe), LUXEL_OK);
        assert_true(probe->has_value && !probe->source_on_element && isfinite(probe->value));
        luxel_probe_free(probe);
        luxel_scene_free(scene);
    }
}

/* ---- place and direction ---- */

static void expect_three(const char *what, const double found[3], const double expected[3], double tolerance)
{
    for (int i = 0; i < 3; i++)
        if (!(fabs(found[i] - expected[i]) <= tolerance))
            fail_msg("%s: %.17g, not %.17g", what, found[i], expected[i]);
}

static void places_and_directions(void **state)
{
    (void)state;
    static const double place[3] = {0.1, -0.7, 1234.56789}, untouched[3] = {7, 7, 7};
    static const double down[3] = {0, 0, -1}, along_y[3] = {0, 1, 0}, slant[3] = {1.0 / 3, 2.0 / 3, 2.0 / 3};
    static const struct {
        const char *light;       /* at %s: the place */
        const double *direction; /* NULL: none */
    } cases[] = {
        {"{type: ambient, irradiance: 5}", NULL},
        {"{type: distant, direction: [2, 4, 4], irradiance: 5}", slant},
        {"{type: point, position: %s, intensity: 5, axis: [1, 2, 2]}", NULL},
        {"{type: point, position: %s, intensity: 5, pattern: lambertian}", down},
        {"{type: spot, position: %s, intensity: 5, inner: 1, outer: 2, axis: [1, 2, 2]}", slant},
        {"{type: spot, position: %s, intensity: 5, inner: 1, outer: 2, aim: [0.1, 99, 1234.56789]}", along_y},
        {"{type: planar, rectangle: {center: %s, size: [7, 3], axis: [1, 2, 2]}, power: 5, parts: 4}", slant},
        {"{type: planar, rectangle: {center: %s, size: [7, 3.3], aim: [0.1, 99, 1234.56789]}, power: 5}", along_y},
        {"{type: planar, disk: {center: %s, radius: 3}, power: 5, enabled: false}", down},
        {"{type: volume, box: {center: %s, size: [7, 3.3, 5]}, power: 5, parts: 10}", NULL},
        {"{type: volume, sphere: {center: %s, radius: 3}, power: 5}", NULL},
        {"{type: volume, sphere: {center: %s, radius: 3, facets: 7}, power: 5}", NULL},
        {"{type: volume, cylinder: {center: %s, radius: 3, height: 9, axis: [1, 2, 2]}, power: 5}", NULL},
        {"{type: volume, cylinder: {center: %s, radius: 3, height: 9, facets: 5}, power: 5}", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *form = cases[i].light, *at = strstr(form, "%s");
        double found[3] = {7, 7, 7}, direction[3] = {7, 7, 7};
        char light[256];
        snprintf(light, sizeof light, "%.*s%s%s", at ? (int)(at - form) : (int)strlen(form), form,
                 at ? "[0.1, -0.7, 1234.56789]" : "", at ? at + 2 : "");
        luxel_scene *scene = lit_by(light);
        assert_int_equal(luxel_scene_light_place(scene, 0, found), at != NULL);
        assert_int_equal(luxel_scene_light_direction(scene, 0, direction), cases[i].direction != NULL);
        expect_three(light, found, at ? place : untouched, 0);
        expect_three(light, direction, cases[i].direction ? cases[i].direction : untouched, 1e-15);
        luxel_scene_free(scene);
    }
}

/* A polygon that is not convex stands at the centroid of its area, and shines along the normal of all its pieces. */
static void polygons(void **state)
{
    (void)state;
    luxel_scene *scene = lit_by("{type: planar, power: 1, vertices: "
                                "[[0, 0, 9], [0, 900, 9], [900, 900, 9], [900, 700, 9], [200, 700, 9], [200, 0, 9]]}");
    double place[3], direction[3];
    assert_true(luxel_scene_light_place(scene, 0, place));
    assert_true(luxel_scene_light_direction(scene, 0, direction));
    expect_near("x", place[0], (100 * 0.18 + 550 * 0.14) / 0.32, 1e-15);
    expect_near("y", place[1], (450 * 0.18 + 800 * 0.14) / 0.32, 1e-15);
    assert_true(place[2] == 9);
    assert_true(direction[0] == 0 && direction[1] == 0 && direction[2] == -1);
    luxel_scene_free(scene);
}

/* An array stands in the middle of its places, which run along its columns first. */
static void arrays(void **state)
{
    (void)state;
    static const double wanted[6][3] = {{90, 195, 9},  {100, 195, 9}, {110, 195, 9},
                                        {90, 205, 9}, {100, 205, 9}, {110, 205, 9}};
    double place[3], places[6][3] = {{0}};
    luxel_scene *scene = lit_by("{type: point, position: [100, 200, 9], intensity: 1, "
                                "array: {n: [3, 2], spacing: [10, 10]}}");
    assert_int_equal(luxel_scene_light_place_count(scene, 0), 6);
    assert_true(luxel_scene_light_place(scene, 0, place));
    assert_true(luxel_scene_light_places(scene, 0, places));
    expect_three("the array", place, (const double[3]){100, 200, 9}, 1e-15);
    for (int i = 0; i < 6; i++)
        expect_three("a place", places[i], wanted[i], 1e-15);
    assert_int_equal(luxel_scene_light_place_count(scene, 1), 0);
    assert_false(luxel_scene_light_places(scene, 1, places));
    assert_false(luxel_scene_light_places(scene, 0, NULL));
    luxel_scene_free(scene);
}

static void refusals(void **state)
{
    (void)state;
    double flux = 7, three[3];
    luxel_scene *scene = lit_by("{type: point, position: [9, 9, 9], intensity: 1.7e308}");
    assert_int_equal(luxel_scene_light_flux(scene, 0, &flux), LUXEL_ERROR_RANGE);
    assert_int_equal(luxel_scene_light_flux(scene, 1, &flux), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_light_flux(scene, 0, NULL), LUXEL_ERROR_ARGUMENT);
    assert_false(luxel_scene_light_place(scene, 1, three));
    assert_false(luxel_scene_light_place(scene, 0, NULL));
    assert_false(luxel_scene_light_direction(scene, 1, three));
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=1", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_light_count(scene), 0);
    assert_int_equal(luxel_scene_light_flux(scene, 0, &flux), LUXEL_ERROR_ARGUMENT);
    assert_false(luxel_scene_light_place(scene, 0, three));
    assert_int_equal(luxel_scene_light_count(NULL), 0);
    assert_int_equal(luxel_scene_light_flux(NULL, 0, &flux), LUXEL_ERROR_ARGUMENT);
    assert_true(flux == 7);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(spots),
        cmocka_unit_test(sums_over_spheres),
        cmocka_unit_test(cones_of_one_angle),
        cmocka_unit_test(sources_on_elements),
        cmocka_unit_test(places_and_directions),
        cmocka_unit_test(polygons),
        cmocka_unit_test(arrays),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

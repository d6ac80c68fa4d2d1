/* SPDX-License-Identifier: MIT */
/*
 * The surface `rectangle` against geometry by hand: the closed forms of a point source above it, the same in the
 * picture, shadows between plates and spheres, places where surfaces and sources touch, how it lies, what of it is
 * seen, and what is refused.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/pose.h"
#include "scenes.h"
#include "surface/authored.h"
#include "surface/surface.h"

enum { TEXT_SIZE = 2000 };

/* A scene of these surfaces and lights, without a highlight, seen along -z from z = 5000 mm or as `observer` says. */
static luxel_scene *scene_of(const char *observer, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    int length = snprintf(text, sizeof text,
                          "luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: %s\n"
                          "surfaces: [%s]\nlights: [%s]\n",
                          observer ? observer : "{z: 5000}", surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL));
    luxel_diagnostics_free(diagnostics);
    return scene;
}

#define WHITE "material: {model: lambert, diffuse: 1}"

/* The value seen through a screen point, -1 off every surface. */
static double seen(const luxel_scene *scene, double x_mm, double y_mm)
{
    luxel_probe *probe;
    assert_int_equal(luxel_probe_screen(scene, NULL, x_mm, y_mm, NULL, &probe), LUXEL_OK);
    double value = probe->on_surface ? probe->value : -1;
    if (probe->on_surface)
        assert_true(probe->has_value && probe->error <= 1e-12 * fabs(probe->value));
    luxel_probe_free(probe);
    return value;
}

/* The irradiance of a free element. */
static double lit(const luxel_scene *scene, double x, double y, double z, double nx, double ny, double nz)
{
    luxel_probe *probe;
    double place[3] = {x, y, z}, normal[3] = {nx, ny, nz};
    assert_int_equal(luxel_probe_element(scene, NULL, place, normal, NULL, &probe), LUXEL_OK);
    double sum = 0;
    for (size_t i = 0; i < probe->share_count; i++) {
        sum += probe->shares[i].irradiance;
        assert_true(probe->shares[i].error <= 1e-12 * probe->shares[i].irradiance);
    }
    luxel_probe_free(probe);
    return sum;
}

static void assert_near(double value, double expected, double relative)
{
    if (!(fabs(value - expected) <= relative * fabs(expected)))
        fail_msg("%.17g instead of %.17g", value, expected);
}

/* A point source at the height h over a plate: E = I/h^2 below it, I cos^3/h^2 elsewhere. */
static void test_closed_forms(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of(NULL, "{type: rectangle, center: [0, 0, 0], size: [700, 500], " WHITE "}",
                                  "{type: point, position: [0, 0, 300], intensity: 10}");
    assert_near(seen(scene, 0, 0), 10 / 0.09, 1e-15);
    for (int i = -6; i <= 6; i++)
        for (int j = -4; j <= 4; j++) {
            double x = 50 * i + 3, y = 50 * j - 7, r2 = (x * x + y * y + 90000) / 1e6;
            assert_near(seen(scene, x, y), 10 * 0.3 / (r2 * sqrt(r2)), 1e-14);
        }
    luxel_scene_free(scene);

    /* Light on a plate that leans: turned about y by the angle whose tangent is 3/4. */
    scene = scene_of(NULL, "{type: rectangle, center: [10, 0, 100], size: [400, 400], axis: [0.6, 0, 0.8], " WHITE "}",
                     "{type: point, position: [130, 0, 260], intensity: 8}");
    for (int i = -6; i <= 6; i++) {
        double along = 25.0 * i, r2 = (along * along + 40000) / 1e6; /* 200 mm above its centre */
        assert_near(seen(scene, 10 + 0.8 * along, 0), 8 * 0.2 / (r2 * sqrt(r2)), 1e-13);
    }
    luxel_scene_free(scene);
}

/* Case 5.2 of CIE 171: a Lambertian source of 1000 cd, 3 m above a plane; as probes and as a picture of the plane. */
static void test_cie_171(void **state)
{
    (void)state;
    enum { SIDE = 7 }; /* samples every 500 mm */
    static const char text[] =
        "luxel: 1\nunits: photometric\nobserver: {z: 5000}\n"
        "screen: {width: 3000, height: 3000, resolution: [7, 7], sampling: nodes}\n"
        "surfaces: [{type: rectangle, center: [0, 0, 0], size: [3000, 3000]}]\n"
        "lights: [{type: point, pattern: lambertian, position: [0, 0, 3000], intensity: 1000}]\n";
    static const double exact[4][4] = {{111.1111111111111, 105.18626734842954, 89.99999999999997, 71.1111111111111},
                                       {105.18626734842954, 99.72299168975071, 85.66329565734681, 68.05293005671078},
                                       {89.99999999999997, 85.66329565734681, 74.38016528925621, 59.97501041232818},
                                       {71.1111111111111, 68.05293005671078, 59.97501041232818, 49.382716049382715}};
    luxel_scene *scene;
    luxel_field *field;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    for (unsigned row = 0; row < SIDE; row++)
        for (unsigned column = 0; column < SIDE; column++) {
            int i = (int)column - SIDE / 2, j = SIDE / 2 - (int)row;
            double expected = exact[abs(i)][abs(j)];
            luxel_probe *probe;
            assert_int_equal(luxel_probe_screen(scene, &settings, 500 * i, 500 * j, NULL, &probe), LUXEL_OK);
            assert_near(probe->value, expected, 1e-14);
            assert_true(probe->error <= 1e-13 * expected && probe->column == column && probe->row == row);
            assert_true(probe->pixel_value == luxel_field_value(field, column, row));
            assert_true(fabs(probe->pixel_value - expected) <= 2e-6 * exact[0][0]);
            luxel_probe_free(probe);
        }
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* The picture's pixels are the probes at their centres. */
static void test_picture(void **state)
{
    (void)state;
    static const char *const observers[] = {"{z: 5000}", "{z: 900, projection: perspective}"};
    for (int k = 0; k < 2; k++) {
        luxel_scene *scene =
            scene_of(observers[k],
                     "{type: rectangle, center: [0, 0, 0], size: [600, 500], axis: [0.1, -0.2, 1], " WHITE "}, "
                     "{type: sphere, center: [-60, 40, 200], radius: 90, " WHITE "}",
                     "{type: point, position: [150, 0, 420], intensity: 10, attenuation: practical, k: 200}");
        luxel_field *field;
        assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
        const double maximum = luxel_field_statistics(field)->maximum.value;
        unsigned on_surface = 0;
        for (unsigned row = 0; row < 80; row++)
            for (unsigned column = 0; column < 80; column++) {
                double x = -400 + (column + 0.5) * 10, y = 400 - (row + 0.5) * 10;
                bool on = luxel_field_mask(field)[row * 80 + column] != 0;
                luxel_probe *probe;
                assert_int_equal(luxel_probe_screen(scene, NULL, x, y, NULL, &probe), LUXEL_OK);
                assert_int_equal(on, probe->on_surface);
                if (on)
                    assert_true(fabs(luxel_field_value(field, column, row) - probe->value) <= 2e-6 * maximum);
                luxel_probe_free(probe);
                on_surface += on;
            }
        assert_true(on_surface > 2000);
        luxel_field_free(field);
        luxel_scene_free(scene);
    }
}

/* A sphere's shadow on a plate, of a point and of distant light, and a plate's on a sphere and on a plate. */
static void test_shadows(void **state)
{
    (void)state;
    static const char ground[] = "{type: rectangle, center: [0, 0, 0], size: [700, 700], " WHITE "}";
    char surfaces[TEXT_SIZE];
    snprintf(surfaces, sizeof surfaces, "%s, {type: sphere, center: [0, 0, 250], radius: 50, " WHITE "}", ground);
    /* a cone of half the angle asin(50/250) from the light at 500: its edge is at 500 tan on the ground */
    luxel_scene *scene = scene_of(NULL, surfaces, "{type: point, position: [0, 0, 500], intensity: 1}");
    double edge = 500 * 0.2 / sqrt(1 - 0.04);
    assert_true(seen(scene, edge - 1e-6, 0) == 0 && seen(scene, 0, 1e-6 - edge) == 0);
    assert_true(seen(scene, edge + 1e-6, 0) > 0 && seen(scene, 0, -edge - 1e-6) > 0);
    assert_true(luxel_scene_set(scene, "shadows=none", NULL) == LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_true(seen(scene, edge - 1e-6, 0) > 0);
    luxel_scene_free(scene);
    /* along (1, 0, -1) the shadow's centre is at x = 250 and half as wide as sqrt(2) * 50 along x */
    scene = scene_of(NULL, surfaces, "{type: distant, direction: [1, 0, -1], irradiance: 1}");
    edge = 250 - 50 * sqrt(2);
    assert_true(seen(scene, edge + 1e-6, 0) == 0 && seen(scene, edge - 1e-6, 0) > 0);
    assert_true(seen(scene, 250, 50 - 1e-6) == 0 && seen(scene, 250, 50 + 1e-6) > 0);
    luxel_scene_free(scene);

    /* a plate at half the height throws twice its size */
    snprintf(surfaces, sizeof surfaces, "%s, {type: rectangle, center: [0, 0, 100], size: [80, 40], " WHITE "}",
             ground);
    scene = scene_of(NULL, surfaces, "{type: point, position: [0, 0, 200], intensity: 1}");
    assert_true(seen(scene, 80 - 1e-6, 40 - 1e-6) == 0 && seen(scene, -80 + 1e-6, 39) == 0);
    assert_true(seen(scene, 80 + 1e-6, 0) > 0 && seen(scene, 0, -40 - 1e-6) > 0);
    assert_near(seen(scene, 0, 0), 1 / 0.01, 1e-14); /* the upper one itself */
    luxel_scene_free(scene);
    /* along (-1, 0, -1) onto a sphere: about (foot, 0, foot), 20 mm wide */
    scene = scene_of(NULL,
                     "{type: sphere, center: [0, 0, 0], radius: 100, " WHITE "}, "
                     "{type: rectangle, center: [200, 0, 200], size: [20, 20], axis: [1, 0, 1], " WHITE "}",
                     "{type: distant, direction: [-1, 0, -1], irradiance: 1}");
    double foot = 100 / sqrt(2), side = 0.1 * foot, top = sqrt(0.99) * foot; /* its ends: top + side, top - side */
    assert_true(seen(scene, foot, 0) == 0 && seen(scene, foot, 9.999) == 0 && seen(scene, foot, 10.001) > 0);
    assert_true(seen(scene, top + side - 1e-6, 0) == 0 && seen(scene, top + side + 1e-6, 0) > 0);
    assert_true(seen(scene, top - side + 1e-6, 0) == 0 && seen(scene, top - side - 1e-6, 0) > 0);
    luxel_scene_free(scene);
}

/* A plate takes light from free elements on both of its sides, and by its back. */
static void test_both_sides(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of(NULL,
                                  "{type: sphere, center: [3000, 0, 0], radius: 1, " WHITE "}, "
                                  "{type: rectangle, center: [0, 0, 100], size: [80, 40], " WHITE "}",
                                  "{type: point, position: [0, 0, 200], intensity: 1}");
    assert_true(lit(scene, 0, 0, 0, 0, 0, 1) == 0);
    assert_true(lit(scene, 79, 39, 0, 0, 0, 1) == 0 && lit(scene, 81, 0, 0, 0, 0, 1) > 0);
    assert_near(lit(scene, 0, 0, 150, 0, 0, 1), 400, 1e-14);
    luxel_scene_free(scene);
    scene = scene_of(NULL,
                     "{type: sphere, center: [3000, 0, 0], radius: 1, " WHITE "}, "
                     "{type: rectangle, center: [0, 0, 100], size: [80, 40], " WHITE "}",
                     "{type: point, position: [0, 0, 0], intensity: 1}, "
                     "{type: distant, direction: [0, 0, 1], irradiance: 1}");
    assert_true(lit(scene, 0, 0, 200, 0, 0, -1) == 0);
    assert_near(lit(scene, 0, 0, 50, 0, 0, -1), 401, 1e-14);
    luxel_scene_free(scene);
}

/* What lies on a plate is not behind it: its own elements, those of a plate that it joins, a lamp on a ceiling. */
static void test_touching(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of(
        "{z: 250, projection: perspective}",
        "{type: rectangle, center: [0, 0, 0], size: [400, 400], " WHITE "}, "
        "{type: rectangle, center: [-200, 0, 150], size: [400, 300], axis: [1, 0, 0], up: [0, 0, 1], " WHITE "}, "
        "{type: rectangle, center: [0, 0, 300], size: [400, 400], axis: [0, 0, -1], " WHITE "}",
        "{type: point, position: [0, 0, 300], intensity: 1}");
    assert_near(lit(scene, 0, 0, 0, 0, 0, 1), 1 / 0.09, 1e-14);
    assert_near(seen(scene, 0, 0), 1 / 0.09, 1e-14);
    /* on the edge that the floor shares with the wall */
    double r2 = 0.04 + 0.09;
    assert_near(lit(scene, -200, 0, 0, 0, 0, 1), 0.3 / (r2 * sqrt(r2)), 1e-14);
    assert_near(lit(scene, -200, 0, 0, 1, 0, 0), 0.2 / (r2 * sqrt(r2)), 1e-14);
    luxel_scene_free(scene);

    /* A lamp on a ceiling that leans, which rounding leaves on either side, lights the floor, in the picture too. */
    for (int i = 1; i <= 20; i++) {
        char surfaces[TEXT_SIZE], lights[TEXT_SIZE];
        double slope = 0.017 * i;
        snprintf(surfaces, sizeof surfaces,
                 "{type: rectangle, center: [0, 0, 0], size: [400, 400], " WHITE "}, "
                 "{type: rectangle, center: [0, 0, 300], size: [400, 400], axis: [%.17g, 0, -1], " WHITE "}",
                 slope);
        snprintf(lights, sizeof lights, "{type: point, position: [33, 0, %.17g], intensity: 1}", 300 + slope * 33);
        scene = scene_of("{z: 250, projection: perspective}", surfaces, lights);
        luxel_probe *probe;
        assert_int_equal(luxel_probe_screen(scene, NULL, 5, 5, NULL, &probe), LUXEL_OK);
        assert_true(probe->value > 8 && probe->error < 1e-13);
        assert_true(fabs(probe->pixel_value - probe->value) < 1e-5 * probe->value);
        luxel_probe_free(probe);
        luxel_scene_free(scene);
    }
}

static double component(const double of[3], const double along[3])
{
    return of[0] * along[0] + of[1] * along[1] + of[2] * along[2];
}

/* h along up made perpendicular to the axis, w along up x axis; any lengths; the up that stands for one not given. */
static void test_pose(void **state)
{
    (void)state;
    const double axis[3] = {1e-200, 2e-200, 2e-200}, up[3] = {0, 3e150, 0};
    struct lx_pose pose = lx_pose_of(axis, up);
    lx_bounded3 n = lx_wide3_direction(pose.axis), w = lx_wide3_direction(pose.across);
    lx_bounded3 h = lx_wide3_direction(pose.upward);
    const double root = sqrt(5);
    const double expected[3][3] = {
        {1.0 / 3, 2.0 / 3, 2.0 / 3}, {2 / root, 0, -1 / root}, {-2 / (3 * root), 5 / (3 * root), -4 / (3 * root)}};
    const lx_bounded3 found[3] = {n, w, h};
    for (int i = 0; i < 3; i++) {
        const double values[3] = {found[i].x.value, found[i].y.value, found[i].z.value};
        const double errors[3] = {found[i].x.error, found[i].y.error, found[i].z.error};
        for (int k = 0; k < 3; k++)
            assert_true(fabs(values[k] - expected[i][k]) < 2e-16 && errors[k] < 2e-16);
    }
    double usual[3];
    lx_usual_up((double[]){0, 0, -1}, usual);
    assert_true(usual[1] == 1);
    lx_usual_up((double[]){0, -5, 0}, usual);
    assert_true(usual[2] == 1 && usual[1] == 0);
    assert_true(lx_are_parallel((double[]){1, 2, 3}, (double[]){-0.1, -0.2, -0.3}));
    assert_true(lx_are_parallel((double[]){1e300, 0, 0}, (double[]){1e-300, 0, 0}));
    assert_false(lx_are_parallel((double[]){1, 2, 3}, (double[]){1, 2, 3.00001}));
}

static const struct lx_surface_kind *rectangle(void)
{
    for (size_t i = 0; lx_surface_variants[i]; i++)
        if (strcmp(lx_surface_variants[i]->name, "rectangle") == 0)
            return (const struct lx_surface_kind *)lx_surface_variants[i];
    fail();
    return NULL;
}

/* Edges belong to it, its back and what lies behind the start of a ray do not; extent; what lies on it. */
static void test_reference(void **state)
{
    (void)state;
    const struct lx_surface_kind *kind = rectangle();
    const struct lx_plate_parameters plate = {
        .center_mm = {10, 20, 30}, .size_mm = {200, 100}, .axis = {3, 0, 4}, .up = {0, 1, 0}};
    const struct lx_shape shape = lx_surface_shape(kind, &plate);
    assert_near(component(shape.across, (double[]){4, 0, -3}), 5, 1e-15);
    double low[3], high[3];
    kind->extent(&plate, low, high);
    assert_true(fabs(low[0] + 70) < 1e-12 && fabs(high[0] - 90) < 1e-12 && low[1] == -30 && high[1] == 70);
    assert_true(fabs(low[2] + 30) < 1e-12 && fabs(high[2] - 90) < 1e-12);
    assert_near(kind->farthest(&plate, (double[]){0, 0, 1}), 90, 1e-14);

    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++) {
            double x = 10 + 80 * i, y = 20 + 50 * k, z = 30 - 60 * i;
            struct lx_ray ray = {.origin_mm = {x, y, 500}, .direction = {0, 0, -1}};
            struct lx_hit hit = kind->hit(&shape, &ray);
            assert_true(hit.exists && fabs(hit.t - (500 - z)) < 1e-12 && hit.place_mm.x.value == x);
            assert_true(fabs(hit.place_mm.z.value - z) <= hit.place_mm.z.error && hit.place_mm.z.error < 1e-13);
            assert_true(hit.normal.x.value == 0.6 && hit.normal.z.value == 0.8);
            struct lx_ray away = {.origin_mm = {x, y, 500}, .direction = {0, 0, 1}},
                          behind = {.origin_mm = {x, y, -500}, .direction = {0, 0, 1}};
            assert_false(kind->hit(&shape, &away).exists || kind->hit(&shape, &behind).exists);
            struct lx_ray past = {.origin_mm = {x, y, -500}, .direction = {0, 0, -1}};
            assert_false(kind->hit(&shape, &past).exists);
            struct lx_ray beside = {.origin_mm = {x + 1e-7 * i, y + 1e-7 * k, 500}, .direction = {0, 0, -1}};
            assert_int_equal(kind->hit(&shape, &beside).exists, i == 0 && k == 0);
            assert_true(kind->holds(&shape, (double[]){x, y, z}));
            assert_false(kind->holds(&shape, (double[]){x + 1e-5, y, z + 1e-5}));
        }
    struct lx_ray along = {.origin_mm = {500, 20, 30}, .direction = {-4, 0, 3}};
    assert_false(kind->hit(&shape, &along).exists);
}

static const char plates_text[] = "luxel: 1\n"
                                  "screen: {width: 800, height: 800, resolution: [80, 80]}\n"
                                  "observer: {z: 1000, projection: %s}\n"
                                  "surfaces:\n"
                                  "  - {type: rectangle, center: [0, 0, %s], size: %s, axis: %s}\n"
                                  "lights: []\n";

static void expect_refusal(const char *projection, const char *z, const char *size, const char *axis,
                           struct expected expected)
{
    char text[TEXT_SIZE];
    snprintf(text, sizeof text, plates_text, projection, z, size, axis);
    expect_text_error(text, expected);
}

static void test_refusals(void **state)
{
    (void)state;
    expect_refusal("orthographic", "900", "[300, 300]", "[1, 0, 1]",
                   WANTED("observer-too-low", 3, 15, "observer.z", "surfaces[0]", "observer.z > 1006.06"));
    expect_refusal("perspective", "0", "[0, 100]", "[0, 0, 1]",
                   WANTED("out-of-range", 5, 0, "surfaces[0].size[0]", "> 0 mm"));
    expect_refusal("perspective", "0", "[100]", "[0, 0, 1]", WANTED("wrong-length", 5, 0, "surfaces[0].size"));
    expect_refusal("perspective", "0", "[100, 100]", "[0, 0, 0]", WANTED("zero-vector", 5, 0, "surfaces[0].axis"));
    expect_refusal("perspective", "0", "[100, 100]", "[0, 1, 1], up: [0, -2, -2]",
                   WANTED("up-parallel", 5, 0, "surfaces[0].up", "parallel"));
    /* In perspective parts of it may lie above the observer, who need only stand before its front. */
    char text[TEXT_SIZE];
    luxel_scene *scene;
    snprintf(text, sizeof text, plates_text, "perspective", "900", "[300, 300]", "[1, 0, 1]");
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_scene_free(scene);
}

/* Advice where it reaches beyond the screen, exactly, and where a light is behind it. */
static void test_advice(void **state)
{
    (void)state;
    static const struct {
        const char *observer, *center, *size, *axis, *light, *first;
    } cases[] = {
        {"{z: 5000}", "[0, 0, 0]", "[800, 100]", "[0, 0, 1]", "[0, 0, 500]", NULL},
        {"{z: 5000}", "[0, 0, 0]", "[800.01, 100]", "[0, 0, 1]", "[0, 0, 500]", "not-in-view"},
        {"{z: 5000}", "[0, 0, 0]", "[1000, 100]", "[0.6, 0, 0.8]", "[0, 0, 500]", NULL},
        /* half way to the observer half of the screen is in view; this one leans, and its near edge decides */
        {"{z: 1000, projection: perspective}", "[0, 0, 500]", "[399.9, 100]", "[0, 0, 1]", "[0, 0, 600]", NULL},
        {"{z: 1000, projection: perspective}", "[0, 0, 500]", "[400.1, 100]", "[0, 0, 1]", "[0, 0, 600]",
         "not-in-view"},
        {"{z: 1000, projection: perspective}", "[0, 0, 500]", "[300, 100]", "[0.6, 0, 0.8]", "[0, 0, 600]", NULL},
        {"{z: 1000, projection: perspective}", "[0, 0, 500]", "[400, 100]", "[0.6, 0, 0.8]", "[0, 0, 600]",
         "not-in-view"},
        {"{z: 5000}", "[0, 0, 500]", "[100, 100]", "[1, 0, 1]", "[200, 0, 310]", NULL},
        {"{z: 5000}", "[0, 0, 500]", "[100, 100]", "[1, 0, 1]", "[200, 0, 290]", "light-behind"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char surface[TEXT_SIZE], light[TEXT_SIZE];
        snprintf(surface, sizeof surface, "{type: rectangle, center: %s, size: %s, axis: %s}", cases[i].center,
                 cases[i].size, cases[i].axis);
        snprintf(light, sizeof light, "{type: point, position: %s, intensity: 1}", cases[i].light);
        luxel_scene *scene = scene_of(cases[i].observer, surface, light);
        assert_int_equal(luxel_scene_set(scene, "screen.resolution=[400, 400]", NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
        if (luxel_diagnostics_count(diagnostics) != (cases[i].first != NULL))
            fail_msg("case %zu: %zu advices", i, luxel_diagnostics_count(diagnostics));
        if (cases[i].first)
            expect_entry(diagnostics, 0, WANTED(cases[i].first));
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
}

/* A lamp in the plane of a plate, as on a ceiling, lights none of it, however the observer stands: pixels are 0. */
static void test_in_its_plane(void **state)
{
    static const char *const lights[] = {
        "{type: point, position: [-100, 30, 700], intensity: 1}",
        "{type: point, pattern: lambertian, axis: [0, 0, -1], position: [110, 70.1, 700], intensity: 1}",
        "{type: spot, axis: [0, 0, -1], position: [0, 0, 700], inner: 80, outer: 90, intensity: 1}",
        "{type: distant, direction: [1, 0.3, 0], irradiance: 1}",
        "{type: planar, rectangle: {center: [50, 50, 700], size: [100, 100]}, radiance: 1}",
        "{type: planar, disk: {center: [50, 50, 700], radius: 70}, radiance: 1}",
    };
    (void)state;
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++)
        for (int precision = 0; precision < 2; precision++) {
            luxel_field *field;
            luxel_settings settings;
            luxel_scene *scene = scene_of(
                "{position: [-310, -290, 170], target: [0, 0, 660], up: [0, 0, 1], projection: perspective}",
                "{type: rectangle, center: [0, 0, 700], size: [800, 600], axis: [0, 0, -1], " WHITE "}", lights[i]);
            luxel_settings_init(&settings);
            settings.precision = precision ? LUXEL_DOUBLE : LUXEL_SINGLE;
            assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
            const luxel_statistics *statistics = luxel_field_statistics(field);
            assert_true(statistics->has_surface && statistics->maximum.value == 0 && statistics->lit == 0);
            luxel_field_free(field);
            luxel_scene_free(scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed_forms), cmocka_unit_test(test_cie_171),      cmocka_unit_test(test_picture),
        cmocka_unit_test(test_shadows),      cmocka_unit_test(test_both_sides),   cmocka_unit_test(test_touching),
        cmocka_unit_test(test_pose),         cmocka_unit_test(test_reference),    cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_advice),       cmocka_unit_test(test_in_its_plane),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

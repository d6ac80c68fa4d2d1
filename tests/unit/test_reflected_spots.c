/* SPDX-License-Identifier: MIT */
/*
 * Reflected light of spots and narrow patterns.  On a plate that has all of a cone, what an element receives by one
 * bounce, rho/pi times the integral of I f(theta) cos cos' / r^2 over the directions of the cone, is a sum by Gauss's
 * rule between its two angles and evenly around its axis.  On a disk that has a part of a cone, on a ball, and over the
 * horizon of the element, the same integral was made to ten digits by roots of these borders around each angle.
 */
#include <math.h>
#include <stdio.h>

#include "random_scenes.h"
#include "scenes.h"

enum { TEXT_SIZE = 1000, SCENES = 48, PLACES = 3 };

#define HEAD                                                                                                           \
    "luxel: 1\nunits: photometric\nreflections: all\nscreen: {width: 400, height: 400, resolution: [4, 4]}\n"          \
    "observer: {z: 90000}\n"
#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"

static const double REFLECTANCE = 0.5, INTENSITY = 1000, HALF_SIDE = 2500;

/* ---- the truth ---- */

enum falloff { SMOOTHSTEP, SQUARED, LINEAR, HARD };
static const char *const names[] = {"smoothstep", "squared", "linear", "hard"};

struct spot {
    enum falloff falloff;
    double place[3], axis[3], inner, outer; /* the angles in radians */
};

static double degrees(double radians)
{
    return radians * 180 / M_PI;
}

static double factor(const struct spot *spot, double theta)
{
    if (theta <= spot->inner || spot->falloff == HARD)
        return 1;
    const double by_cosine = (cos(theta) - cos(spot->outer)) / (cos(spot->inner) - cos(spot->outer));
    switch (spot->falloff) {
    case SMOOTHSTEP: return by_cosine * by_cosine * (3 - 2 * by_cosine);
    case SQUARED: return by_cosine * by_cosine;
    default: return (spot->outer - theta) / (spot->outer - spot->inner);
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalize(double a[3])
{
    const double length = sqrt(dot(a, a));
    for (int k = 0; k < 3; k++)
        a[k] /= length;
}

/* What arrives at an element that looks down from where a direction meets the plate, for a solid angle of 1. */
static double from_plate(const struct spot *spot, const double direction[3], const double element[3])
{
    const double away = -spot->place[2] / direction[2];
    double square = element[2] * element[2];
    for (int k = 0; k < 2; k++) {
        const double aside = element[k] - spot->place[k] - away * direction[k];
        square += aside * aside;
    }
    return REFLECTANCE / M_PI * INTENSITY * 1e6 * element[2] * element[2] / (square * square);
}

/* All around the axis, under an angle from it. */
static double from_ring(const struct spot *spot, double theta, const double element[3])
{
    enum { TURNS = 96 };
    const double *axis = spot->axis;
    double first[3] = {-axis[2], 0, axis[0]}, sum = 0;
    normalize(first);
    const double second[3] = {axis[1] * first[2] - axis[2] * first[1], axis[2] * first[0] - axis[0] * first[2],
                              axis[0] * first[1] - axis[1] * first[0]};
    for (int i = 0; i < TURNS; i++) {
        const double turn = 2 * M_PI * i / TURNS;
        double direction[3];
        for (int k = 0; k < 3; k++)
            direction[k] = cos(theta) * axis[k] + sin(theta) * (cos(turn) * first[k] + sin(turn) * second[k]);
        sum += from_plate(spot, direction, element);
    }
    return sum * 2 * M_PI / TURNS * sin(theta) * factor(spot, theta);
}

static double truth_at(const struct spot *spot, const double element[3])
{
    enum { PANELS = 64 };
    const double node = 1 / sqrt(3);
    double sum = 0;
    for (int part = 0; part < 2; part++) {
        const double low = part ? spot->inner : 0, step = ((part ? spot->outer : spot->inner) - low) / PANELS;
        for (int i = 0; i < PANELS; i++)
            for (int side = -1; side <= 1; side += 2)
                sum += step / 2 * from_ring(spot, low + step * (i + 0.5 + 0.5 * side * node), element);
    }
    return sum;
}

/* ---- scenes ---- */

static luxel_scene *scene_of(const char *text)
{
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), text);
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* `room` is what the truth may be off by, as a share. */
static void expect(const char *text, const double place[3], const double normal[3], double asked, double truth,
                   double room)
{
    luxel_scene *scene = scene_of(text);
    luxel_settings settings;
    luxel_probe *probe;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = asked;
    luxel_probe_element(scene, &settings, place, normal, NULL, &probe);
    const double value = probe->reflected_irradiance, error = probe->reflected.error;
    if (!(fabs(value - truth) <= error + room * truth && error <= 40 * asked * truth))
        fail_msg("%.10g +- %.2g at %g, not %.10g\n%s", value, error, asked, truth, text);
    luxel_probe_free(probe);
    luxel_scene_free(scene);
}

static struct spot random_spot(struct randomness *random, enum falloff falloff)
{
    struct spot spot = {.falloff = falloff, .outer = logarithmic(random, 0.2, 20) * M_PI / 180};
    const int kind = pick(random, 3); /* soft all over, soft, narrow */
    spot.inner = spot.outer * (kind == 0 ? 0 : kind == 1 ? uniform(random, 0, 1) : 1 - logarithmic(random, 1e-3, 0.3));
    const double lean = pick(random, 2) * 0.4;
    for (int k = 0; k < 2; k++) {
        spot.place[k] = uniform(random, -600, 600);
        spot.axis[k] = uniform(random, -lean, lean);
    }
    spot.place[2] = uniform(random, 1200, 2400);
    spot.axis[2] = -1;
    normalize(spot.axis);
    return spot;
}

static void spots_on_a_plate(void **state)
{
    static const double down[3] = {0, 0, -1};
    struct randomness random = {20261129};
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        const struct spot spot = random_spot(&random, (enum falloff)(i % 4));
        char text[TEXT_SIZE];
        const int length = snprintf(
            text, sizeof text,
            HEAD "surfaces: [{type: rectangle, center: [0, 0, 0], size: [%g, %g], " MATERIAL(
                "0.5") "}]\n"
                       "lights: [{type: spot, position: [%.17g, %.17g, %.17g], axis: [%.17g, %.17g, %.17g], inner: "
                       "%.17g, outer: %.17g, falloff: %s, intensity: %g}]\n",
            2 * HALF_SIDE, 2 * HALF_SIDE, spot.place[0], spot.place[1], spot.place[2], spot.axis[0], spot.axis[1],
            spot.axis[2], degrees(spot.inner), degrees(spot.outer), names[spot.falloff], INTENSITY);
        assert_true(length < TEXT_SIZE);
        for (int p = 0; p < PLACES; p++) {
            const double place[3] = {uniform(&random, -1500, 1500), uniform(&random, -1500, 1500),
                                     uniform(&random, 500, 1500)};
            expect(text, place, down, p == 0 ? 1e-4 : 1e-3, truth_at(&spot, place), 1e-6);
        }
    }
}

/* The cone over the border of a disk, seen over the element's horizon; a needle on a ball over the ball's horizon; a
 * spot and a narrow pattern at the element's horizon on a plate. */
static void borders_and_horizons(void **state)
{
    static const struct {
        const char *text;
        double place[3], normal[3], truth;
    } scenes[] = {
        {HEAD "surfaces: [{type: disk, center: [0, 0, 0], radius: 1297, " MATERIAL(
             "0.75") "}]\n"
                     "lights: [{type: spot, position: [-24, -351, 1885], inner: 4.4, outer: 10.6, falloff: linear, "
                     "intensity: 1000}]\n",
         {-1242, -1436, 1408},
         {0.1, -0.8, -0.6},
         0.1078574694},
        {HEAD "surfaces: [{type: sphere, center: [0, 0, -334], radius: 334, " MATERIAL(
             "0.2") "}]\n"
                    "lights: [{type: spot, position: [-142, 227, 1862], inner: 0, outer: 0.62, intensity: 1000}]\n",
         {-390, -573, 1123},
         {0, 0, -1},
         0.0008799146396},
        {HEAD "surfaces: [{type: rectangle, center: [0, 0, 0], size: [2580, 2260], up: [0, 1, 0], " MATERIAL(
             "0.36") "}]\nlights: [{type: spot, position: [-700, -24, 2529], inner: 1.7, outer: 2, intensity: 1000}]\n",
         {-1712, -764, 1237},
         {-0.79, 0.03, -0.61},
         0.000258255346},
        {HEAD "surfaces: [{type: rectangle, center: [0, 0, 0], size: [2290, 1780], up: [0, 1, 0], " MATERIAL(
             "0.58") "}]\nlights: [{type: point, position: [-874, -48, 1831], pattern: cosine, exponent: 1900, "
                     "intensity: 1000}]\n",
         {-1783, 873, 649},
         {-0.51, 0.08, -0.85},
         0.001735837047},
    };
    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++)
        for (double asked = 1e-2; asked > 5e-4; asked /= 10)
            expect(scenes[i].text, scenes[i].place, scenes[i].normal, asked, scenes[i].truth, 1e-8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spots_on_a_plate),
        cmocka_unit_test(borders_and_horizons),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

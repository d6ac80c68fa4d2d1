/* SPDX-License-Identifier: MIT */
/*
 * Reflected light against truths: the furnace (in any closed enclosure of one reflectance under uniform light, whatever
 * stands in it, E = E0/(1 - rho)), the integrating sphere, concentric spheres, points of a cube to eight digits, one
 * bounce over a plane and from a ball; what is refused; the same digits for any number of threads.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scenes.h"

enum { TEXT_SIZE = 3000 };

static luxel_scene *scene_of(const char *reflections, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    const int length = snprintf(text, sizeof text,
                                "luxel: 1\nunits: photometric\nreflections: %s\n"
                                "screen: {width: 400, height: 400, resolution: [4, 4]}\nobserver: {z: 30000, "
                                "projection: perspective}\nsurfaces: [%s]\nlights: [%s]\n",
                                reflections, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL));
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* A free element and its true reflected irradiance. */
struct truth {
    double place[3], normal[3], irradiance;
};

/* The values are within their bounds of the truth, and these are no more than `most` of it. */
static void expect(luxel_scene *scene, const struct truth *truths, size_t count, double most)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = most;
    luxel_place places[8] = {0};
    luxel_probes *probes;
    for (size_t i = 0; i < count; i++) {
        places[i].is_element = true;
        for (int k = 0; k < 3; k++) {
            places[i].position_mm[k] = truths[i].place[k];
            places[i].normal[k] = truths[i].normal[k];
        }
    }
    assert_int_equal(luxel_probe_places(scene, &settings, places, count, NULL, &probes), LUXEL_OK);
    for (size_t i = 0; i < count; i++) {
        const luxel_probe *probe = luxel_probes_get(probes, i);
        const double off = fabs(probe->reflected_irradiance - truths[i].irradiance);
        assert_true(probe->has_reflected && probe->reflected_reached);
        if (!(off <= probe->reflected.error) || !(probe->reflected.error <= most * probe->value))
            fail_msg("place %zu: %.10g instead of %.10g, bound %.2g", i, probe->reflected_irradiance,
                     truths[i].irradiance, probe->reflected.error);
    }
    luxel_probes_free(probes);
    luxel_scene_free(scene);
}

#define ROOM(rho)                                                                                                      \
    "{type: room, center: [0, 0, 0], size: [4000, 4000, 4000], material: {model: lambert, diffuse: " rho               \
    ", over_pi: true}}"
#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"

/* Eight digits by spectral collocation, of 10 000 lm from the middle of a cube of 4 m. */
static void cube(void **state)
{
    (void)state;
    static const double truths[2][3] = {{112.03836, 107.78338, 96.850238}, {255.00881, 248.68833, 231.79366}};
    static const char *const rooms[] = {ROOM("0.5"), ROOM("0.7")};
    for (int r = 0; r < 2; r++) {
        const struct truth at[] = {{{0, 0, -2000}, {0, 0, 1}, truths[r][0]},
                                   {{-2000, 1000, 1000}, {1, 0, 0}, truths[r][1]},
                                   {{1500, -2000, 1500}, {0, 1, 0}, truths[r][2]}};
        expect(scene_of("all", rooms[r], "{type: point, position: [0, 0, 0], power: 10000}"), at, 3, 2e-3);
    }
}

/* 10 cm from a corner, where the light changes fast, of weak and strong reflection. */
static void corners_of_a_cube(void **state)
{
    (void)state;
    static const double truths[] = {7.4707868, 77.032300, 866.30617};
    static const char *const rooms[] = {ROOM("0.1"), ROOM("0.5"), ROOM("0.9")};
    for (int r = 0; r < 3; r++) {
        const struct truth at = {{1900, 1900, -2000}, {0, 0, 1}, truths[r]};
        expect(scene_of("all", rooms[r], "{type: point, position: [0, 0, 0], power: 10000}"), &at, 1, 1e-3);
    }
}

static void furnace(void **state)
{
    (void)state;
    const struct truth at[] = {{{0, 0, -2000}, {0, 0, 1}, 1},
                               {{300, -1000, 200}, {0, -1, -0.1}, 1},
                               {{300, -2000, 200}, {0, 1, 0}, 1},
                               {{-900, -1400, 500}, {0, 1, 0}, 1},
                               {{100, 500, 300}, {1, 2, 3}, 1}};
    expect(scene_of(
               "all",
               ROOM("0.5") ", {type: rectangle, center: [300, -1000, 200], size: [1500, 900], axis: [0, 1, "
                           "0.1], " MATERIAL(
                               "0.5") "}, {type: sphere, center: [-900, -1700, 500], radius: 300, " MATERIAL("0.5") "}",
               "{type: ambient, irradiance: 1}"),
           at, 5, 5e-3);
}

/* In a furnace, on the floor within a tube and on its walls: one that stands there, lies between walls, or is free. */
static void open_tubes(void **state)
{
    (void)state;
    static const char *const centers[] = {"[200, 100, -1800]", "[200, 100, 0]", "[0, 1700, -1000]"};
    static const char *const shapes[] = {"height: 400, axis: [0, 0, 1]", "height: 400, axis: [0, 0, 1]",
                                         "height: 4000, axis: [1, 0, 0]"};
    const struct truth at[3][3] = {
        {{{200, 100, -2000}, {0, 0, 1}, 1}, {{500, 100, -1850}, {-1, 0, 0}, 1}, {{500, 100, -1850}, {1, 0, 0}, 1}},
        {{{200, 100, -2000}, {0, 0, 1}, 1}, {{500, 100, -50}, {-1, 0, 0}, 1}, {{500, 100, -50}, {1, 0, 0}, 1}},
        {{{-2000, 1700, -1000}, {1, 0, 0}, 1}, {{300, 1400, -1000}, {0, 1, 0}, 1}, {{300, 2000, -500}, {0, -1, 0}, 1}}};
    for (int i = 0; i < 3; i++) {
        char surfaces[TEXT_SIZE];
        const int length = snprintf(surfaces, sizeof surfaces, "%s, {type: cylinder, center: %s, radius: 300, %s, %s}",
                                    ROOM("0.5"), centers[i], shapes[i], MATERIAL("0.5"));
        assert_true(length > 0 && length < TEXT_SIZE);
        expect(scene_of("all", surfaces, "{type: ambient, irradiance: 1}"), at[i], 3, 3e-2);
    }
    /* where one touches another, which hides nothing within */
    const struct truth touching = {{-444.2351248623074, 0, 94.7990960153122}, {-1, 0, 0}, 1};
    char surfaces[TEXT_SIZE];
    const int length =
        snprintf(surfaces, sizeof surfaces,
                 "{type: room, center: [0, 0, 0], size: [4000, 3000, 2500], %s}, "
                 "{type: cylinder, center: [-744.2351248623074, 0, 0], radius: 300, height: 2500, %s}, "
                 "{type: cylinder, center: [-144.2351248623074, 0, 0], radius: 300, height: 2500, %s}",
                 MATERIAL("0.5"), "axis: [0, 0, 1], " MATERIAL("0.5"), "axis: [0, 0, 1], " MATERIAL("0.5"));
    assert_true(length > 0 && length < TEXT_SIZE);
    expect(scene_of("all", surfaces, "{type: ambient, irradiance: 1}"), &touching, 1, 3e-2);
}

/* What reaches into a ball is hidden in it, not only behind the circle in which ways touch the ball. */
static void bodies_in_bodies(void **state)
{
    (void)state;
    const double truth = 2 * 0.3 / (1 - 0.3);
    const struct truth at[] = {{{0, 0, -800}, {0, 0, 1}, truth},
                               {{500, 300, -800}, {0, 0, 1}, truth},
                               {{0, -1200, -300}, {0, 1, 0}, truth},
                               {{-300, 0, -300}, {-1, 0, 0}, truth}};
    static const char *const others[] = {
        "{type: sphere, center: [300, 0, -300], radius: 300, " MATERIAL("0.3") "}",
        "{type: disk, center: [200, 0, -300], radius: 400, axis: [0.3, 0.1, 1], " MATERIAL("0.3") "}",
        "{type: rectangle, center: [0, 0, -300], size: [500, 550], " MATERIAL("0.3") "}",
        "{type: sphere, center: [700, 300, 800], radius: 300, " MATERIAL("0.3") "}",
        "{type: cylinder, center: [700, 0, 0], radius: 150, height: 1600, axis: [0, 0, 1], " MATERIAL(
            "0.3") "}, {type: disk, center: [600, 50, -100], radius: 300, " MATERIAL("0.3") "}"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        char surfaces[TEXT_SIZE];
        const int length = snprintf(surfaces, sizeof surfaces,
                                    "{type: room, center: [0, 0, 0], size: [3000, 2400, 1600], %s}, "
                                    "{type: sphere, center: [0, 0, -300], radius: 300, %s}, %s",
                                    MATERIAL("0.3"), MATERIAL("0.3"), others[i]);
        assert_true(length > 0 && length < TEXT_SIZE);
        expect(scene_of("all", surfaces, "{type: ambient, irradiance: 2}"), at, 4, 1e-2);
    }
}

/* The kernel of a sphere is constant: mean rho E / (1 - rho) on all of it, whatever the lamp's pattern. */
static void integrating_sphere(void **state)
{
    (void)state;
    const char *sphere = "{type: sphere, center: [0, 0, 0], radius: 500, inside: true, " MATERIAL("0.9") "}";
    const char *lamp = "{type: point, position: [100, 50, -200], power: 1000}";
    const char *spot = "{type: spot, position: [0, 100, 50], axis: [1, 0.3, 0.2], inner: 10, outer: 40, power: 1000}";
    const double mean = 1000 / M_PI; /* by 4 pi 0.5^2 m^2 */
    const struct truth all[] = {{{0, 0, -500}, {0, 0, 1}, 9 * mean}, {{500, 0, 0}, {-1, 0, 0}, 9 * mean}};
    const struct truth one[] = {{{0, 0, -500}, {0, 0, 1}, 0.9 * mean}};
    const struct truth two[] = {{{0, 0, -500}, {0, 0, 1}, 1.71 * mean}};
    expect(scene_of("all", sphere, lamp), all, 2, 1e-4);
    expect(scene_of("all", sphere, spot), all, 2, 1e-4);
    expect(scene_of("1", sphere, spot), one, 1, 1e-4);
    expect(scene_of("2", sphere, lamp), two, 1, 1e-4);
    /* where residuals are next to nothing the areas of tiles must be right as well */
    static const double reflectances[] = {0.2, 0.5, 0.98};
    static const char *const spheres[] = {
        "{type: sphere, center: [0, 0, 0], radius: 500, inside: true, " MATERIAL("0.2") "}",
        "{type: sphere, center: [0, 0, 0], radius: 500, inside: true, " MATERIAL("0.5") "}",
        "{type: sphere, center: [0, 0, 0], radius: 500, inside: true, " MATERIAL("0.98") "}"};
    for (int i = 0; i < 3; i++) {
        const double rho = reflectances[i];
        const struct truth at[] = {{{0, 300, -400}, {0, -0.6, 0.8}, mean * rho / (1 - rho)}};
        expect(scene_of("all", spheres[i], "{type: point, position: [0, 0, 0], power: 1000}"), at, 1, 1e-4);
    }
}

/* e1 = 1 + 0.8 e2 inside, e2 = 1 + 0.5 e1/4 + 0.8 (3/4) e2 outside. */
static void concentric_spheres(void **state)
{
    (void)state;
    const struct truth at[] = {{{0, 0, 500}, {0, 0, 1}, 3}, {{0, 1000, 0}, {0, -1, 0}, 2.75}};
    expect(scene_of("all",
                    "{type: sphere, center: [0, 0, 0], radius: 1000, inside: true, " MATERIAL(
                        "0.8") "}, {type: sphere, center: [0, 0, 0], radius: 500, " MATERIAL("0.5") "}",
                    "{type: ambient, irradiance: 1}"),
           at, 2, 5e-3);
}

/* A point at the height of 2 m over a plane, an element at 1 m below it; the plane's end takes less than 1e-7. */
static void one_bounce(void **state)
{
    (void)state;
    const struct truth at[] = {{{0, 0, 1000}, {0, 0, -1}, 0.159769335799369 * 50}};
    expect(scene_of("1", "{type: rectangle, center: [0, 0, 0], size: [60000, 60000], " MATERIAL("0.5") "}",
                    "{type: point, position: [0, 0, 2000], intensity: 100}"),
           at, 1, 1e-3);
}

/* The outside of a room, whose walls stand farther outside as something in the way: by 400 x 400 places of Gauss's rule
 * on the wall that the lamp lights. */
static void outside_of_a_room(void **state)
{
    (void)state;
    const struct truth at[] = {{{100, -1000, -2200}, {0, 1, 0}, 23.3974485699066}};
    expect(scene_of("1", "{type: room, center: [0, 0, 0], size: [2000, 2000, 2000], " MATERIAL("0.5") "}",
                    "{type: point, position: [300, -500, -2500], intensity: 1000}"),
           at, 1, 1e-3);
}

/* Spots that end at once, on the walls of a room: narrower than the places that are sampled first are apart, and such
 * that their edges pass between these.  By a million directions within the cone, each to the wall that it meets. */
static void narrow_beams(void **state)
{
    (void)state;
    static const struct {
        const char *cone;
        double irradiance[2]; /* on the ceiling and on a wall */
    } spots[] = {
        {"axis: [0.1, -1, 0.13], inner: 0.2, outer: 0.2, intensity: 2.5e7", {10.746391, 8.4052112}},
        {"axis: [0.887, 0.241, 0.636], inner: 1.2, outer: 1.2, intensity: 694444.444444444", {0.98570037, 0}},
        {"axis: [1, -0.3, 0.2], inner: 4, outer: 4, intensity: 62500", {3.8399626, 0}},
        {"axis: [-0.5, 0.2, -0.7], inner: 6, outer: 6, intensity: 27777.7777777778", {3.9468556, 2.301985}},
    };
    for (size_t i = 0; i < sizeof spots / sizeof spots[0]; i++) {
        const struct truth at[] = {{{-1000, 3000, 300}, {0, -1, 0}, spots[i].irradiance[0]},
                                   {{2500, 1000, -500}, {-1, 0, 0}, spots[i].irradiance[1]}};
        char light[200];
        snprintf(light, sizeof light, "{type: spot, position: [300, 2000, 250], %s}", spots[i].cone);
        expect(
            scene_of("1", "{type: room, center: [0, 1500, 0], size: [5000, 3000, 4000], " MATERIAL("0.5") "}", light),
            at, 2, 1e-2);
    }
}

/* A ball under a lamp, of which half is lit: by 4000 x 8000 places of Gauss's rule on the ball.  From afar, where its
 * normals turn more than the ways to it; from nearby; from its side. */
static void one_ball(void **state)
{
    (void)state;
    const struct truth at[] = {{{-1750, -1250, 0}, {0, 0, 1}, 0.03254623},
                               {{250, 200, 650}, {0, 0, 1}, 0.53502687},
                               {{60, 300, 900}, {-0.3, -1, 0.2}, 24.0646163},
                               {{500, 0, 1000}, {-1, 0, 0}, 16.6339269}};
    for (size_t i = 0; i < 4; i++)
        for (double most = 1e-2; most > 5e-6; most /= 10) {
            luxel_scene *scene = scene_of("1", "{type: sphere, center: [0, 0, 900], radius: 200, " MATERIAL("0.5") "}",
                                          "{type: point, position: [137, 211, 2000], intensity: 1000}");
            luxel_settings settings;
            luxel_settings_init(&settings);
            settings.quantity = LUXEL_IRRADIANCE;
            settings.reflected_error = most;
            luxel_probe *probe;
            luxel_probe_element(scene, &settings, at[i].place, at[i].normal, NULL, &probe);
            assert_true(probe->has_reflected);
            const double off = fabs(probe->reflected_irradiance - at[i].irradiance);
            if (!(off <= probe->reflected.error + 2e-7 * at[i].irradiance) ||
                !(probe->reflected.error < 0.25 * at[i].irradiance))
                fail_msg("place %zu at %g: %.10g instead of %.10g, bound %.2g", i, most, probe->reflected_irradiance,
                         at[i].irradiance, probe->reflected.error);
            luxel_probe_free(probe);
            luxel_scene_free(scene);
        }
}

/* A black ball hides much of a floor that is lit all over from an element close to the ball, aslant by 0.2: of all its
 * ways cos(0.2) sin^2 of the half angle under which the ball is seen. */
static void near_a_ball(void **state)
{
    const double tilt = 0.2, heights[] = {205, 210, 240};
    (void)state;
    for (size_t i = 0; i < sizeof heights / sizeof heights[0]; i++) {
        const double sine = 200 / heights[i];
        const struct truth at[] = {
            {{0, 0, heights[i]}, {sin(tilt), 0, -cos(tilt)}, 0.5 * ((1 + cos(tilt)) / 2 - cos(tilt) * sine * sine)}};
        expect(scene_of("1\nshadows: none",
                        "{type: rectangle, center: [0, 0, -1000], size: [2e9, 2e9], " MATERIAL(
                            "0.5") "}, {type: sphere, center: [0, 0, 0], radius: 200, " MATERIAL("0") "}",
                        "{type: distant, direction: [0, 0, -1], irradiance: 1}"),
               at, 1, 1e-4);
    }
}

/* All that is wrong is told at once. */
static void refusals(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene;
    assert_int_equal(
        load("luxel: 1\nreflections: 2\nscreen: {width: 400, height: 400, resolution: [4, 4]}\n"
             "observer: {z: 3000}\nsurfaces:\n  - {type: sphere, center: [0, 0, 0], radius: 100}\n"
             "  - {type: sphere, center: [300, 0, 0], radius: 100, material: {diffuse: 1, over_pi: "
             "true}}\nlights:\n  - {type: point, position: [0, 0, 900], intensity: 1, attenuation: none}\n",
             diagnostics, &scene),
        LUXEL_ERROR_SCENE);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 3);
    expect_entry(diagnostics, 0, WANTED("reflects-by-weight", 6, .key = "surfaces[0].material.over_pi"));
    expect_entry(diagnostics, 1, WANTED("reflects-all", 7, .key = "surfaces[1].material.diffuse"));
    expect_entry(diagnostics, 2, WANTED("reflects-by-law", 9, .key = "lights[0].attenuation"));
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* In a furnace of reflectance 1/2 and irradiance 1 every bounce adds half of the one before: 1, 3/2, 7/4 ... 2.  The
 * scene's own number comes first, and each value is inside its bound. */
static void explanations(void **state)
{
    (void)state;
    static const char *const choices[] = {"2", "none", "1", "all"};
    static const double truths[] = {1.75, 1, 1.5, 2};
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = scene_of("2", ROOM("0.5"), "{type: ambient, irradiance: 1}");
    luxel_alternatives *found = NULL;
    assert_int_equal(luxel_find_alternatives(scene, &settings, 0, 0, diagnostics, &found), LUXEL_OK);
    assert_int_equal(found->count, 4);
    for (size_t i = 0; i < found->count; i++) {
        assert_string_equal(found->list[i].choice, choices[i]);
        assert_int_equal(found->list[i].is_present, i == 0);
        assert_true(fabs(found->list[i].value - truths[i]) <= found->list[i].error);
        assert_true(found->list[i].error <= 2e-3);
    }
    luxel_alternatives_free(found);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

static void threads(void **state)
{
    (void)state;
    double values[2] = {0};
    luxel_scene *scene = scene_of("all", ROOM("0.5"), "{type: point, position: [500, 0, 0], power: 10000}");
    for (unsigned i = 0; i < 2; i++) {
        luxel_settings settings;
        luxel_probe *probe;
        luxel_settings_init(&settings);
        settings.threads = 1 + 2 * i;
        settings.reflected_error = 0.02;
        assert_int_equal(luxel_probe_screen(scene, &settings, 100, 50, NULL, &probe), LUXEL_OK);
        values[i] = probe->value;
        luxel_probe_free(probe);
    }
    luxel_scene_free(scene);
    assert_true(values[0] == values[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube),
        cmocka_unit_test(corners_of_a_cube),
        cmocka_unit_test(furnace),
        cmocka_unit_test(open_tubes),
        cmocka_unit_test(bodies_in_bodies),
        cmocka_unit_test(integrating_sphere),
        cmocka_unit_test(concentric_spheres),
        cmocka_unit_test(one_bounce),
        cmocka_unit_test(outside_of_a_room),
        cmocka_unit_test(narrow_beams),
        cmocka_unit_test(one_ball),
        cmocka_unit_test(near_a_ball),
        cmocka_unit_test(refusals),
        cmocka_unit_test(explanations),
        cmocka_unit_test(threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * Reflected light with little effort: whatever is left undone, truths are within the bounds that are told, and values
 * near to them; the more effort the smaller the bounds are, and any number of threads makes the same numbers.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../../src/api/session.h"
#include "../../src/reflect/reflected.h"
#include "scenes.h"

enum { TEXT_SIZE = 2000, MOST_PLACES = 5 };

#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"
#define CUBE(rho) "{type: room, center: [0, 0, 2000], size: [4000, 4000, 4000], " MATERIAL(rho) "}"

/* From what is cut off in the first samples to what is whole. */
static const size_t efforts[] = {1, 10000, 100000, 2000000, 0};
enum { EFFORTS = sizeof efforts / sizeof *efforts };

static luxel_scene *scene_of(const char *reflections, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    const int length = snprintf(text, sizeof text,
                                "luxel: 1\nreflections: %s\nscreen: {width: 3000, height: 3000, resolution: [7, 7]}\n"
                                "observer: {z: 30000}\nsurfaces: [%s]\nlights: [%s]\n",
                                reflections, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    return scene;
}

/* Places of the back wall, z = 0, of a cube. */
struct truths {
    const char *reflections, *surfaces, *lights;
    size_t count;
    double at_mm[MOST_PLACES][2], reflected[MOST_PLACES];
};

/* Reflected light found at the places, as an integral and as a picture shows it. */
struct found {
    lx_bounded at[MOST_PLACES], on[MOST_PLACES];
};

static void find_to(const struct truths *truths, double error, size_t effort, unsigned threads, bool is_picture,
                    struct found *found)
{
    luxel_scene *scene = scene_of(truths->reflections, truths->surfaces, truths->lights);
    struct lx_session session;
    luxel_settings settings;
    luxel_settings_init(&settings);
    assert_int_equal(lx_session_open_world(scene, &settings, NULL, &session), LUXEL_OK);
    struct lx_control control = {.rows = 1};
    struct lx_reflected_place places[MOST_PLACES] = {0};
    struct lx_reflected_spot spots[MOST_PLACES] = {0};
    for (size_t p = 0; p < truths->count; p++) {
        const double place[3] = {truths->at_mm[p][0], truths->at_mm[p][1], 0};
        memcpy(places[p].receiver.place_mm, place, sizeof place);
        memcpy(spots[p].place_mm, place, sizeof place);
        places[p].receiver.normal[2] = spots[p].normal[2] = 1;
        places[p].receiver.own = spots[p].surface = 4; /* of the room's walls */
        spots[p].share = 1;
    }
    const struct lx_reflected_request wish = {
        .prepared = &session.prepared,
        .kernels = lx_element_kernels_of(session.kernels),
        .error = error,
        .places = places,
        .place_count = is_picture ? 0 : truths->count,
        .spots = is_picture ? spots : NULL,
        .spot_count = is_picture ? truths->count : 0,
        .effort = effort,
        .threads = threads,
        .control = &control,
    };
    struct lx_radiosity *reflected;
    struct lx_occluder_cones cones = {0};
    size_t near = 0;
    assert_int_equal(lx_reflected_make(&wish, &reflected), LUXEL_OK);
    for (size_t p = 0; p < truths->count; p++) {
        found->at[p] = lx_reflected_at(reflected, &session.prepared, &places[p].receiver, &cones);
        found->on[p] = lx_reflected_on(reflected, &session.prepared, 4, spots[p].place_mm, spots[p].normal, &near);
    }
    lx_occluder_cones_clear(&cones);
    lx_reflected_free(reflected);
    lx_session_clear(&session);
    luxel_scene_free(scene);
}

static void find(const struct truths *truths, size_t effort, unsigned threads, bool is_picture, struct found *found)
{
    find_to(truths, 1e-3, effort, threads, is_picture, found);
}

static void expect(const struct truths *truths, const lx_bounded *found, size_t effort)
{
    for (size_t p = 0; p < truths->count; p++)
        if (!(fabs(found[p].value - truths->reflected[p]) <= found[p].error))
            fail_msg("effort %zu, place %zu: %.8g, not %.8g, bound %.2g", effort, p, found[p].value,
                     truths->reflected[p], found[p].error);
}

static void check(const struct truths *truths)
{
    for (int is_picture = 0; is_picture < 2; is_picture++) {
        struct found found[EFFORTS];
        for (size_t e = 0; e < EFFORTS; e++) {
            find(truths, efforts[e], 1, is_picture, &found[e]);
            expect(truths, found[e].at, efforts[e]);
            expect(truths, found[e].on, efforts[e]);
        }
        /* next to nothing is known with the least, with the most enough */
        assert_true(found[0].at[0].error > 0.1 * found[0].at[0].value);
        assert_true(found[0].on[0].error > 0.1 * found[0].on[0].value);
        assert_true(found[EFFORTS - 1].at[0].error < 2e-3 * found[EFFORTS - 1].at[0].value);
    }
}

/* A cube of 4 m with 10 000 lm in its middle, by collocation. */
static const struct truths cube = {"all",
                                   CUBE("0.7"),
                                   "{type: point, position: [0, 0, 2000], power: 10000}",
                                   5,
                                   {{0, 0}, {1000, 0}, {1000, 1000}, {1500, 1500}, {1800, 0}},
                                   {255.00881, 253.33949, 248.68833, 231.79366, 243.52884}};

/* The values are the best that is known, not the middle of what cannot be excluded: where all tiles have their first
 * samples they are near to the truth, however far the bounds reach. */
static void cube_within(void **state)
{
    (void)state;
    struct found found;
    find(&cube, 10000, 1, false, &found);
    for (size_t p = 0; p < cube.count; p++) {
        assert_true(fabs(found.at[p].value - cube.reflected[p]) <= 0.1 * cube.reflected[p]);
        assert_true(found.at[p].error > cube.reflected[p]);
    }
    check(&cube);
}

/* In uniform light everything has E = 1/(1 - 0.5), whatever stands around; one bounce brings a half. */
static void furnace_within(void **state)
{
    (void)state;
    static const char things[] =
        CUBE("0.5") ", {type: rectangle, center: [0, -900, 1500], size: [1200, 1000], "
                    "axis: [0, 1, 0.2], " MATERIAL(
                        "0.5") "}, "
                               "{type: sphere, center: [700, 700, 1500], radius: 400, " MATERIAL("0.5") "}";
    static const struct {
        const char *reflections;
        double reflected;
    } cases[] = {{"all", 1}, {"1", 0.5}, {"3", 0.875}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double truth = cases[i].reflected;
        const struct truths truths = {
            cases[i].reflections, things, "{type: ambient, irradiance: 1}", 3, {{0, 0}, {700, 600}, {-1900, 1900}},
            {truth, truth, truth}};
        struct found found;
        for (size_t e = 0; e < EFFORTS - 1; e++)
            for (int is_picture = 0; is_picture < 2; is_picture++) {
                find(&truths, efforts[e], 1, is_picture, &found);
                expect(&truths, found.at, efforts[e]);
                expect(&truths, found.on, efforts[e]);
            }
    }
}

/* Whoever wants more than the effort allows is told no less than whoever wants little, up to that. */
static void more_is_no_less(void **state)
{
    static const double LITTLE = 0.1, OTHER = 1.01; /* values are other ones */
    static const char things[] = CUBE("0.5") ", {type: sphere, center: [700, 700, 1500], radius: 400, " MATERIAL(
        "0.5") "}, "
               "{type: rectangle, center: [0, -900, 1500], size: [1200, 1000], "
               "axis: [0, 1, 0.2], " MATERIAL("0.5") "}";
    const struct truths room = {"all",
                                things,
                                "{type: point, position: [-900, 300, 2500], power: 10000}",
                                3,
                                {{0, 0}, {700, 600}, {-1900, 1900}},
                                {0}};
    (void)state;
    for (size_t effort = 1000000; effort <= 16000000; effort *= 4) {
        struct found much, little;
        double worst[2] = {0, 0};
        find_to(&room, 1e-5, effort, 1, false, &much);
        find_to(&room, LITTLE, effort, 1, false, &little);
        for (size_t p = 0; p < room.count; p++) {
            worst[0] = fmax(worst[0], much.at[p].error / much.at[p].value);
            worst[1] = fmax(worst[1], little.at[p].error / little.at[p].value);
        }
        if (!(worst[0] <= OTHER * fmax(LITTLE, worst[1])))
            fail_msg("effort %zu: %g where 1e-5 was wanted, %g where 0.1 was", effort, worst[0], worst[1]);
    }
}

static void same_for_threads(void **state)
{
    (void)state;
    for (size_t e = 0; e < EFFORTS - 1; e += 2) {
        struct found one, three;
        memset(&one, 0, sizeof one);
        memset(&three, 0, sizeof three);
        find(&cube, efforts[e], 1, true, &one);
        find(&cube, efforts[e], 3, true, &three);
        assert_memory_equal(&one, &three, sizeof one);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube_within),
        cmocka_unit_test(furnace_within),
        cmocka_unit_test(more_is_no_less),
        cmocka_unit_test(same_for_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

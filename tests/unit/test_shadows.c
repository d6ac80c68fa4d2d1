/* SPDX-License-Identifier: MIT */
/*
 * What surfaces hide of extended sources, in thousands of random scenes of all kinds of surfaces, sources, laws and
 * lobes: within what a grid of rays that are blocked or not says; at one tolerance as at a tighter one and with the
 * source cut in parts, to the errors that are told; never less than nothing nor more than without shadows.  Then what
 * is known in closed form, and what must be so where things touch, lie in one plane, or contain each other.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "campaign.h"
#include "light/solid/extended.h"
#include "scenes.h"
#include "shadow_scenes.h"
#include "world/reference.h"

struct stage {
    luxel_scene *scene;
    struct lx_prepared prepared;
};

static struct stage staged(const char *text, double tolerance)
{
    struct stage stage;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &stage.scene) != LUXEL_OK)
        fail_msg("not a scene:\n%s", text);
    luxel_diagnostics_free(diagnostics);
    const luxel_settings settings = {.tolerance = tolerance};
    assert_int_equal(lx_prepare(lx_scene_parameters(stage.scene), &settings, NULL, &stage.prepared), 0);
    return stage;
}

static void leave(struct stage *stage)
{
    lx_prepared_clear(&stage->prepared);
    luxel_scene_free(stage->scene);
}

static struct lx_lighting sum_of(const struct lx_prepared *prepared, const struct lx_element *element)
{
    struct lx_lighting sum = {.irradiance = {0, 0}, .diffuse = {0, 0}, .specular = {0, 0}};
    for (size_t i = 0; i < prepared->emitters.count; i++) {
        struct lx_lighting light = lx_light_element(prepared, element, &prepared->emitters.items[i]);
        sum.on_element = sum.on_element || light.on_element;
        sum.irradiance = lx_add(sum.irradiance, light.irradiance);
        sum.specular = lx_add(sum.specular, light.specular);
        sum.parts += light.parts;
    }
    return sum;
}

static struct lx_element element_of(const struct lx_prepared *prepared, double x, double y)
{
    struct lx_element element;
    if (!lx_element_seen(prepared, x, y, &element) || element.own != prepared->surfaces) {
        /* something covers it: it is asked for by its place */
        element = lx_element_at(prepared, &(luxel_place){.position_mm = {x, y, 0}, .normal = {0, 0, 1}});
    }
    return element;
}

/* The light of the parts of the source cut into points: how much of it is blocked, by rays. */
static double by_rays(const struct lx_prepared *prepared, const struct lx_element *element, unsigned parts)
{
    double sum = 0;
    for (size_t i = 0; i < prepared->emitters.count; i++) {
        struct lx_emitters points = {0};
        assert_int_equal(lx_extended_cut(&prepared->emitters.items[i], parts, &points), 0);
        struct lx_emitter room;
        for (size_t k = 0; k < points.count; k++) {
            struct lx_emitter point = *lx_emitter_at(&points, k, &room);
            sum += lx_light_element(prepared, element, &point).irradiance.value;
        }
        lx_emitters_clear(&points);
    }
    return sum;
}

static void assert_within(lx_bounded found, lx_bounded other, const char *what, const char *text)
{
    if (!(fabs(found.value - other.value) <= found.error + other.error))
        fail_msg("%s: %.17g +- %g, and %.17g +- %g (off by %g) of\n%s", what, found.value, found.error, other.value,
                 other.error, found.value - other.value, text);
}

/* What rays tell of the sources cut in two ways: as far as these differ they may be off. */
static void compare_with_rays(struct lx_prepared *prepared, const struct lx_element *element, double found,
                              double whole, const char *text)
{
    const bool casts = prepared->shadows;
    double seen[2], all[2];
    for (int k = 0; k < 2; k++) {
        const unsigned parts = k ? 59 : 43;
        seen[k] = by_rays(prepared, element, parts);
        prepared->shadows = prepared->shadows_on_free = false;
        all[k] = by_rays(prepared, element, parts);
        prepared->shadows = casts;
        prepared->shadows_on_free = true;
    }
    const double allowed = 3 * (fabs(all[1] - whole) + fabs(seen[1] - seen[0])) + 0.02 * all[1];
    if (!(fabs(found - seen[1]) <= allowed))
        fail_msg("rays tell %.9g of %.9g, found %.9g of %.9g in\n%s", seen[1], all[1], found, whole, text);
}

/* At 1e-7, 1e-9 and 1e-12, between nothing and all. */
static void random_scenes(void **state)
{
    (void)state;
    const char *from = getenv("LUXEL_SHADOW_SEED");
    const int count = scenes_to_try(400);
    struct dice dice = {from ? strtoull(from, NULL, 0) : 20261};
    size_t partly = 0, work = 0, most = 0;
    for (int n = 0; n < count; n++) {
        const bool glossy = n % 3 == 2;
        const struct dice before = dice;
        const struct text text = shadow_scene(&dice, n % KINDS, n / KINDS % SOURCES, glossy, 10);
        struct stage stage = staged(text.words, 1e-9);
        const struct lx_element element =
            element_of(&stage.prepared, dice_uniform(&dice, -15, 15), dice_uniform(&dice, -15, 15));
        struct lx_lighting light = sum_of(&stage.prepared, &element);
        stage.prepared.shadows_extended = false;
        const struct lx_lighting whole = sum_of(&stage.prepared, &element);
        stage.prepared.shadows_extended = true;
        stage.prepared.tolerance = 1e-12;
        const struct lx_lighting tight = sum_of(&stage.prepared, &element);
        stage.prepared.tolerance = 1e-6;
        const struct lx_lighting coarse = sum_of(&stage.prepared, &element);
        if (light.on_element) {
            leave(&stage);
            continue;
        }
        if (getenv("LUXEL_SHADOW_VERBOSE"))
            printf("%d %llx parts %zu value %g of %g tight %zu coarse %zu gloss %g\n", n,
                   (unsigned long long)before.state, light.parts, light.irradiance.value, whole.irradiance.value,
                   tight.parts, coarse.parts, light.specular.value);
        work += light.parts;
        most = light.parts > most ? light.parts : most;
        assert_within(light.irradiance, tight.irradiance, "tighter", text.words);
        assert_within(light.specular, tight.specular, "tighter highlight", text.words);
        assert_within(coarse.irradiance, tight.irradiance, "coarse", text.words);
        assert_within(coarse.specular, tight.specular, "coarse highlight", text.words);
        if (!(light.irradiance.value >= 0 &&
              light.irradiance.value <= whole.irradiance.value + whole.irradiance.error + light.irradiance.error))
            fail_msg("%.17g of %.17g of\n%s", light.irradiance.value, whole.irradiance.value, text.words);
        if (light.irradiance.error > 2e-9 * whole.irradiance.value)
            fail_msg("error %g of %.17g of\n%s", light.irradiance.error, whole.irradiance.value, text.words);
        const bool is_partly = light.irradiance.value > 1e-6 * whole.irradiance.value &&
                               light.irradiance.value < (1 - 1e-6) * whole.irradiance.value;
        partly += is_partly;
        if (n % 4 == n / 4 % 4)
            compare_with_rays(&stage.prepared, &element, light.irradiance.value, whole.irradiance.value, text.words);
        leave(&stage);
    }
    if (getenv("LUXEL_SHADOW_VERBOSE"))
        printf("%zu partly, %g parts on average, %zu at most\n", partly, (double)work / count, most);
    assert_true(partly > (size_t)count / 6);
}

/* ---- what is known ---- */

#define FLOOR "  - {type: rectangle, center: [0, 0, 0], size: [9000, 9000], material: {model: lambert, diffuse: 1}}\n"

static lx_bounded irradiance_at(const char *surfaces, const char *light, const double place[3], const double normal[3],
                                double tolerance)
{
    static char text[MOST_TEXT];
    snprintf(text, sizeof text,
             "luxel: 1\nscreen: {width: 10, height: 10, resolution: [10, 10]}\nobserver: {z: 90000}\nsurfaces:\n" FLOOR
             "%slights:\n  - %s\n",
             surfaces, light);
    struct stage stage = staged(text, tolerance);
    const struct lx_element element =
        lx_element_at(&stage.prepared, &(luxel_place){.position_mm = {place[0], place[1], place[2]},
                                                      .normal = {normal[0], normal[1], normal[2]}});
    const lx_bounded found = sum_of(&stage.prepared, &element).irradiance;
    leave(&stage);
    return found;
}

static void assert_known(lx_bounded found, double expected, double within, const char *what)
{
    const double last_digit = 1e-15; /* of the expected number */
    if (!(fabs(found.value - expected) <= fmin(found.error + last_digit, within)))
        fail_msg("%s: %.17g +- %g instead of %.17g", what, found.value, found.error, expected);
}

static const double UP[3] = {0, 0, 1};

/* A square source of 1 m at z = 1 m, and a plate half as high that covers x >= 0: for the element at x that is the
 * source cut at -x. */
static void plate_under_square(void **state)
{
    (void)state;
    static const double cases[][2] = {
        {-0.5, .566645112049507}, {-0.25, .584056157484375}, {-0.1, .483634176500061}, {0, .376137344227054},
        {0.1, .260099969783063},  {0.25, .116412809115846},  {0.4, .0308576602233824}, {0.5, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double place[3] = {1000 * cases[i][0], 0, 0};
        const lx_bounded found = irradiance_at(
            "  - {type: rectangle, center: [2000, 0, 500], size: [4000, 4000]}\n",
            "{type: planar, rectangle: {center: [0, 0, 1000], size: [1000, 1000]}, radiance: 1}", place, UP, 1e-12);
        assert_known(found, cases[i][1], 1e-14, "plate");
    }
}

/* A sphere in the middle of a disk, and before a ball: the cap of a ball is hidden by that of another. */
static void spheres(void **state)
{
    (void)state;
    static const double origin[3] = {0, 0, 0}, tilted[3] = {0.47942553860420300027, 0, 0.87758256189037271612};
    lx_bounded found =
        irradiance_at("  - {type: sphere, center: [0, 0, 1000], radius: 200}\n",
                      "{type: planar, disk: {center: [0, 0, 2000], radius: 500}, radiance: 1}", origin, UP, 1e-12);
    assert_known(found, 3.14159265358979323846 * (0.25 / 4.25 - 0.04), 1e-12, "sphere before a disk");
    for (int i = 0; i < 2; i++) {
        found = irradiance_at("  - {type: sphere, center: [886.5606199840188, 0, 2866.0094673768180], radius: 600}\n",
                              "{type: volume, sphere: {center: [0, 0, 6000], radius: 1500}, radiance: 1}", origin,
                              i ? tilted : UP, 1e-12);
        assert_known(found, i ? .172312933084582 - .0341103758867005 : .16095186416198, 1e-13, "eclipse");
    }
}

/* CIE 171, case 5.7: a box before a lit wall, by the corrected numbers. */
static void box_before_wall(void **state)
{
    (void)state;
    static const struct {
        double y, z, expected;
    } cases[] = {{0, 2.75, 16.0706}, {0, 2.25, 16.3297}, {0, 1.75, 15.3988}, {0, 1.25, 13.3220},
                 {0, 0.75, 10.3169}, {0, 0.25, 7.0790},  {0.25, 0, 3.3823},  {0.75, 0, 3.6290},
                 {1.25, 0, 3.0130},  {1.75, 0, 0},       {2.25, 0, 0}};
    double ratio = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double place[3] = {2000, 1000 * cases[i].y, 1000 * cases[i].z};
        const double normal[3] = {0, cases[i].y == 0, cases[i].y != 0};
        /* the sides of the box; its faces look up and to the observer as they must */
        const lx_bounded found = irradiance_at(
            "  - {type: rectangle, center: [2000, 2500, 500], size: [4000, 1000], axis: [0, -1, 1e-9], up: [0, 0, 1]}\n"
            "  - {type: rectangle, center: [2000, 2700, 500], size: [4000, 1000], axis: [0, 1, 1e-9], up: [0, 0, 1]}\n"
            "  - {type: rectangle, center: [2000, 2600, 1000], size: [4000, 200]}\n",
            "{type: planar, rectangle: {center: [2000, 4000, 1500], size: [4000, 3000], axis: [0, -1, 0], up: [0, 0, "
            "1]}, "
            "radiance: 1}",
            place, normal, 1e-9);
        if (i == 0)
            ratio = cases[i].expected / found.value;
        if (!(fabs(found.value * ratio - cases[i].expected) <= 1.5e-4))
            fail_msg("y %g z %g: %.9g instead of %g", cases[i].y, cases[i].z, found.value * ratio, cases[i].expected);
    }
}

/* The light of parts of a window behind a ball is that of the whole; an obstacle twice is one; behind the source, or in
 * its plane, it hides nothing. */
static void sums_and_places(void **state)
{
    (void)state;
    static const double place[3] = {120, -80, 0};
    const char *ball = "  - {type: sphere, center: [100, 50, 700], radius: 210}\n";
    const char *window = "{type: planar, rectangle: {center: [0, 0, 1500], size: [1000, 800]}, radiance: 1}";
    const lx_bounded whole = irradiance_at(ball, window, place, UP, 1e-11);
    lx_bounded sum = {0, 0};
    for (int i = 0; i < 4; i++) {
        char part[200];
        snprintf(part, sizeof part,
                 "{type: planar, rectangle: {center: [%d, %d, 1500], size: [500, 400]}, radiance: 1}",
                 i % 2 ? 250 : -250, i / 2 ? 200 : -200);
        sum = lx_add(sum, irradiance_at(ball, part, place, UP, 1e-11));
    }
    assert_within(whole, sum, "parts", window);
    char twice[400];
    snprintf(twice, sizeof twice, "%s%s", ball, ball);
    assert_within(whole, irradiance_at(twice, window, place, UP, 1e-11), "twice", window);
    const lx_bounded open = irradiance_at("", window, place, UP, 1e-11);
    static const char *const harmless[] = {"  - {type: rectangle, center: [0, 0, 1500], size: [3000, 3000]}\n",
                                           "  - {type: disk, center: [0, 0, 1500], radius: 300}\n",
                                           "  - {type: sphere, center: [0, 0, 2000], radius: 499}\n",
                                           "  - {type: cylinder, center: [0, 0, 2000], radius: 300, height: 900}\n",
                                           "  - {type: rectangle, center: [0, 0, 0], size: [500, 500]}\n",
                                           "  - {type: rectangle, center: [0, 0, -1], size: [500, 500]}\n"};
    for (size_t i = 0; i < sizeof harmless / sizeof *harmless; i++)
        assert_within(open, irradiance_at(harmless[i], window, place, UP, 1e-11), "harmless", harmless[i]);
    /* a plate over the element hides all, and a tube around it all but what is seen through its end */
    assert_true(irradiance_at("  - {type: disk, center: [120, -80, 1], radius: 90}\n", window,
                              (const double[]){120, -80, 0.9999}, UP, 1e-9)
                    .value < 1e-6 * open.value);
    const lx_bounded through =
        irradiance_at("  - {type: cylinder, center: [120, -80, 500], axis: [0, 0, 1], radius: 100, height: 1000}\n",
                      window, place, UP, 1e-11);
    const lx_bounded hole = irradiance_at(
        "", "{type: planar, disk: {center: [120, -80, 1000], radius: 100}, radiance: 1}", place, UP, 1e-11);
    assert_within(through, hole, "through a tube", window);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plate_under_square), cmocka_unit_test(spheres),       cmocka_unit_test(box_before_wall),
        cmocka_unit_test(sums_and_places),    cmocka_unit_test(random_scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Committing: every kind of error is found, at its place, with what was expected. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static void accepts_the_good_scene(void **state)
{
    (void)state;
    luxel_scene *scene;
    unsigned columns, rows;
    double x, y;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    assert_true(luxel_scene_is_committed(scene));
    assert_int_equal(luxel_scene_resolution(scene, &columns, &rows), LUXEL_OK);
    assert_int_equal(columns, 400);
    assert_int_equal(rows, 400);
    assert_int_equal(luxel_scene_point_count(scene), 2);
    assert_int_equal(luxel_scene_point(scene, 1, &x, &y), LUXEL_OK);
    assert_true(x == 150 && y == 0);
    assert_int_equal(luxel_scene_point(scene, 2, &x, &y), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
}

static void finds_wrong_keys(void **state)
{
    (void)state;
    expect_error("radius", "raduis", WANTED("unknown-key", 8, 5, "surfaces[0].raduis", "\"raduis\"", "\"radius\""));
    expect_error("radius: 300", "radius: 300\n    zebra: 1",
                 WANTED("unknown-key", 9, 5, .hint = "type, center, radius, inside, name, material"));
    expect_error("radius: 300", "radius: 300\n    radius: 200", WANTED("doubled-key", 9, 5, "surfaces[0].radius"));
    expect_error("type: sphere", "type: sphere\n    type: sphere", WANTED("doubled-key", 7, 5));
    expect_error("    radius: 300\n", "",
                 WANTED("missing-key", 6, 5, "surfaces[0].radius", "\"radius\"", "number > 0 mm"));
    expect_error("luxel: 1\n", "", WANTED("missing-key", 1, 1, "luxel"));
    expect_error("width: 800, ", "", WANTED("missing-key", 3, 9, "screen.width"));
    expect_error("intensity: 10, ", "", WANTED("missing-key", 11, 5, "lights[0]", "one of intensity, power"));
    expect_error("attenuation: none", "inner: 5", WANTED("unknown-key", 11, 61, .hint = "spot"));
    expect_error("radius: 300", "radius: 300\n    <<: {a: 1}", WANTED("unknown-key", 9, 5));
}

static void finds_wrong_numbers(void **state)
{
    (void)state;
    static const char *const no_numbers[] = {"true", "\"300\"", ".nan",   ".inf",  "-.inf", "1e999",
                                             "0x10", "1_000",   "300 mm", "abc",   "",      "~",
                                             "null", "[1]",     "{a: 1}", "'300'", "0,5"};
    for (size_t i = 0; i < sizeof no_numbers / sizeof no_numbers[0]; i++) {
        char text[40];
        snprintf(text, sizeof text, "radius: %s", no_numbers[i]);
        expect_error("radius: 300", text, WANTED("wrong-type", 8, 0, "surfaces[0].radius", "> 0 mm"));
    }
    expect_error("radius: 300", "radius: \"300\"", WANTED(.hint = "quotes"));
    expect_error("radius: 300", "radius: 0,5", WANTED(.hint = "point"));
    expect_error("radius: 300", "radius: -5", WANTED("out-of-range", 8, 13, NULL, "> 0 mm, not -5"));
    expect_error("radius: 300", "radius: 0", WANTED("out-of-range", 8, 13));
    expect_error("intensity: 10", "intensity: -1", WANTED("out-of-range", 11, 0, NULL, "≥ 0 W/sr"));
    expect_error("luxel: 1", "luxel: 2", WANTED("out-of-range", 1, 8, "luxel"));
    expect_error("[0, 0, 1000]", "[0, 0]", WANTED("wrong-length", 7, 13, NULL, "3 numbers, not of 2"));
    expect_error("[0, 0, 1000]", "[0, a, 1000]", WANTED("wrong-type", 7, 17, "surfaces[0].center[1]"));
    expect_error("[0, 0, 1000]", "1000", WANTED("wrong-type", 7, 13));
    expect_error("attenuation: none", "axis: [0, -0, 0.0]", WANTED("zero-vector", 11, 67));
}

static void finds_wrong_whole_numbers(void **state)
{
    (void)state;
    static const char *const wrong[] = {"400.0", "4e2", "true", "\"400\"", "x", ""};
    static const char *const beyond[] = {"0", "-1", "65537", "99999999999999999999999"};
    char text[60];
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        snprintf(text, sizeof text, "resolution: [400, %s]", wrong[i]);
        if (wrong[i][0])
            expect_error("resolution: [400, 400]", text, WANTED("wrong-type", 3, 0, "screen.resolution[1]"));
        else
            expect_error("resolution: [400, 400]", text, WANTED("wrong-length", 3));
    }
    for (size_t i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
        snprintf(text, sizeof text, "resolution: [%s, 400]", beyond[i]);
        expect_error("resolution: [400, 400]", text,
                     WANTED("out-of-range", 3, 48, "screen.resolution[0]", "1 to 65536"));
    }
}

static void finds_wrong_words(void **state)
{
    (void)state;
    expect_error("nodes", "node", WANTED("unknown-choice", 3, 69, NULL, "centers, nodes", "\"nodes\""));
    expect_error("nodes", "Nodes", WANTED("unknown-choice", 3, 69, .hint = "\"nodes\""));
    expect_error("nodes", "5", WANTED("unknown-choice", 3, 69, .hint = ""));
    expect_error("shininess: 20", "over_pi: yes", WANTED("wrong-type", 9, 0, .message = "true or false"));
    expect_error("shininess: 20", "over_pi: True", WANTED("wrong-type", 9, .hint = "\"true\""));
    expect_error("shininess: 20", "over_pi: \"true\"", WANTED("wrong-type", 9, .hint = "quotes"));
    expect_error("radius: 300", "radius: 300\n    name: 5", WANTED("wrong-type", 9, 11, .hint = "quotes"));
    expect_error("radius: 300", "radius: 300\n    name: [a]", WANTED("wrong-type", 9, 11));
    expect_error("range: max", "range: [5, 5]", WANTED("out-of-range", 13, 18));
    expect_error("range: max", "range: [5]", WANTED("wrong-length", 13, 18));
    expect_error("range: max", "range: maxi", WANTED("unknown-choice", 13, 18, .hint = "\"max\""));
    expect_error("[150, 0]", "[150]", WANTED("wrong-length", 12, 18, "points[1]"));
    expect_error("[150, 0]", "[150, x]", WANTED("wrong-type", 12, 24, "points[1][1]"));
}

static void finds_wrong_types(void **state)
{
    (void)state;
    expect_error("type: point", "type: poitn",
                 WANTED("unknown-choice", 11, 12, "lights[0].type",
                        "point, points, spot, luminaire, planar, volume, distant, ambient", "\"point\""));
    expect_error("type: point, ", "", WANTED("missing-key", 11, 5, "lights[0].type", .hint = "spot"));
    expect_error("type: point", "type: [point]", WANTED("unknown-choice", 11, 12));
    expect_error("- {type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}", "- 5",
                 WANTED("wrong-type", 11, 5, "lights[0]"));
    expect_error("{z: 1500, projection: orthographic, view: parallel}", "1500",
                 WANTED("wrong-type", 4, 11, "observer"));
    expect_error("points: [[0, 0], [150, 0]]", "points: {a: 1}", WANTED("wrong-type", 12, 9, "points"));
}

/* Why a text is no number, as far as that can be guessed. */
static void guesses_what_was_meant(void **state)
{
    static const char quotes[] = "quotes", finite[] = "finite", large[] = "too large", point[] = "with a point",
                      decimal[] = "decimal number";
    static const char alone[] = "alone", none[] = "";
    static const struct {
        const char *text, *hint;
    } cases[] = {
        {"\"300\"", quotes}, {"'3e2'", quotes}, {"'3 mm'", none},
        {"1e999", large},    {"nan", finite},   {"-.inf", finite},
        {"+Inf", finite},    {".NaN", finite},  {"0;5", alone},
        {"3 mm", alone},     {"300mm", alone},  {"3e", alone},
        {"1_000", decimal},  {"0x1F", decimal}, {"0o17", decimal},
        {"1:30", decimal},   {"x3", none},      {"wide", none},
        {"-", none},         {"3.4.5", none},   {"\xd1\x82\xd1\x80\xd0\xb8", decimal},
        {"- 5", none},
    };
    (void)state;
    expect_error("radius: 300", "radius: 0,5", WANTED(.hint = point));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char line[60];
        snprintf(line, sizeof line, "radius: %s", cases[i].text);
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        luxel_scene *scene;
        char *text = changed("radius: 300", line);
        assert_int_equal(load(text, diagnostics, &scene), LUXEL_ERROR_SCENE);
        char *hint = luxel_diagnostics_hint(diagnostics, 0, NULL, NULL);
        if ((cases[i].hint == none) != !(hint && *hint) || (hint && !strstr(hint, cases[i].hint)))
            fail_msg("%s: %s", cases[i].text, hint ? hint : "no hint");
        luxel_text_free(hint);
        luxel_scene_free(scene);
        luxel_diagnostics_free(diagnostics);
        free(text);
    }
}

static void finds_broken_rules(void **state)
{
    (void)state;
    expect_error("attenuation: none", "axis: [0, 0, 1], aim: [0, 0, 0]",
                 WANTED("exclusive-keys", 11, 78, "lights[0].aim"));
    expect_error("attenuation: none", "aim: [0, 0, 0], axis: [0, 0, 1]",
                 WANTED("exclusive-keys", 11, 77, "lights[0].axis"));
    expect_error("none", "practical", WANTED("missing-key", 11, 5, "lights[0].k", "practical"));
    expect_error("attenuation: none", "pattern: cosine", WANTED("missing-key", 11, 5, "lights[0].exponent"));
    expect_error("attenuation: none", "aim: [2000, 0, 2000]", WANTED("same-place", 11, 66));
    expect_error("type: point", "type: spot, inner: 40, outer: 30", WANTED("wrong-order", 11, 25, NULL, "30"));
}

static void wants_square_pixels(void **state)
{
    (void)state;
    expect_error("[400, 400]", "[400, 401]", WANTED("not-square", 3, 47, NULL, "square", "[400, 400]"));
    expect_error("height: 800", "height: 533", WANTED("not-square", 3, 0, NULL, "square", "would fit"));
    expect_error("height: 800", "height: 0.01", WANTED("not-square", 3, 0, NULL, "square", "height 800 mm"));
    expect_error("height: 800", "height: 800.000805", WANTED("not-square", 3, 0, NULL, "square"));
    luxel_scene *scene;
    char *text = changed("height: 800", "height: 800.000795"); /* within the tolerance */
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_scene_free(scene);
    free(text);
}

static void wants_the_observer_above(void **state)
{
    (void)state;
    static const char *const too_low[] = {"z: 1300", "z: 1000", "z: 700", "z: -5"};
    for (size_t i = 0; i < sizeof too_low / sizeof too_low[0]; i++)
        expect_error("z: 1500", too_low[i],
                     WANTED("observer-too-low", 4, 15, "observer.z", "surfaces[0]", "> 1300 mm"));
    expect_error("z: 1500, projection: orthographic", "z: 1200, projection: perspective",
                 WANTED("observer-too-low", 4, 15));
    expect_error("z: 1500, projection: orthographic", "z: 0, projection: perspective", WANTED("out-of-range", 4, 15));
    /* of several surfaces the one that reaches highest is told, wherever it stands in the list */
    static const char one[] = "  - {type: sphere, center: [0, 0, 1000], radius: 300}\n"
                              "  - {type: sphere, center: [0, 0, 1000], radius: 700}\n"
                              "  - {type: sphere, center: [0, 0, 1000], radius: 600}\n";
    expect_error("  - type: sphere\n    center: [0, 0, 1000]\n    radius: 300\n"
                 "    material: {model: phong, diffuse: 0.8, shininess: 20}\n",
                 one, WANTED("observer-too-low", 4, 15, "observer.z", "surfaces[1]", "> 1700 mm"));
    expect_error("  - type: sphere\n    center: [0, 0, 1000]\n    radius: 300\n"
                 "    material: {model: phong, diffuse: 0.8, shininess: 20}\n",
                 "  []\n", WANTED("no-surfaces", 6, 3, "surfaces"));
}

static void reports_all_errors_at_once(void **state)
{
    (void)state;
    static const char text[] =
        "luxel: 3\nscreen: {width: -1, height: x, resolution: [1, 2], foo: 1}\nobserver: {z: true}\n"
        "surfaces: []\nlights: [{type: point}, {type: moon}, 5]\n";
    static const char *const ids[] = {"out-of-range", "out-of-range", "wrong-type",     "unknown-key", "wrong-type",
                                      "missing-key",  "missing-key",  "unknown-choice", "wrong-type"};
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene;
    assert_int_equal(load(text, diagnostics, &scene), LUXEL_ERROR_SCENE);
    assert_false(luxel_scene_is_committed(scene));
    assert_int_equal(luxel_diagnostics_count(diagnostics), sizeof ids / sizeof ids[0]);
    for (size_t i = 0; i < sizeof ids / sizeof ids[0]; i++)
        assert_string_equal(luxel_diagnostics_get(diagnostics, i)->id, ids[i]);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

static void counts_what_it_does_not_keep(void **state)
{
    (void)state;
    char text[2000] = "luxel: 1\n";
    for (int i = 0; i < 30; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "zebra%d: 1\n", i);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene;
    assert_int_equal(load(text, diagnostics, &scene), LUXEL_ERROR_SCENE);
    assert_int_equal(luxel_diagnostics_count(diagnostics), LUXEL_DIAGNOSTICS_KEPT);
    assert_int_equal(luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR), 34);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* The value of a convention; NULL: there is no such. */
static const char *convention(const luxel_scene *scene, const char *key)
{
    static char value[80];
    luxel_conventions *all;
    bool found = false;
    assert_int_equal(luxel_find_conventions(scene, NULL, &all), LUXEL_OK);
    for (size_t i = 0; i < all->count && !found; i++) {
        found = strcmp(all->list[i].key, key) == 0;
        snprintf(value, sizeof value, "%s", all->list[i].value);
    }
    luxel_conventions_free(all);
    return found ? value : NULL;
}

static void lists_conventions(void **state)
{
    (void)state;
    luxel_scene *scene;
    char *text =
        changed("lights:\n", "lights:\n  - {type: spot, position: [0, 0, 9], intensity: 1, inner: 1, outer: 2}\n"
                             "  - {type: point, position: [0, 0, 9], intensity: 1, pattern: lambertian, "
                             "enabled: false}\n");
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    assert_string_equal(convention(scene, "sampling"), "nodes");
    assert_string_equal(convention(scene, "projection"), "orthographic");
    assert_string_equal(convention(scene, "model"), "phong");
    assert_string_equal(convention(scene, "over_pi"), "false");
    assert_string_equal(convention(scene, "attenuation"), "inverse-square, none");
    assert_string_equal(convention(scene, "pattern"), "isotropic"); /* the light that is off does not count */
    assert_string_equal(convention(scene, "range"), "max");
    assert_int_equal(luxel_scene_set(scene, "picture.range=[0.5, 2]", NULL), LUXEL_OK);
    luxel_conventions *none = NULL;
    assert_int_equal(luxel_find_conventions(scene, NULL, &none), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_set(scene, "observer={z: 1500, projection: perspective}", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "surfaces[0].material.model=lambert", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_string_equal(convention(scene, "range"), "[0.5, 2]");
    assert_null(convention(scene, "view"));
    assert_null(convention(scene, "highlight"));
    /* a choice that begins another is one of its own */
    assert_int_equal(
        luxel_scene_set(scene,
                        "lights=[{type: planar, disk: {center: [0, 0, 2000], radius: 9}, power: 1, parts: 40}, "
                        "{type: planar, disk: {center: [0, 0, 2000], radius: 9}, power: 1, parts: 4}, "
                        "{type: planar, disk: {center: [0, 0, 2000], radius: 9}, power: 1, parts: 40}]",
                        NULL),
        LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_string_equal(convention(scene, "parts"), "40, 4");
    luxel_scene_free(scene);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(accepts_the_good_scene),     cmocka_unit_test(finds_wrong_keys),
        cmocka_unit_test(finds_wrong_numbers),        cmocka_unit_test(finds_wrong_whole_numbers),
        cmocka_unit_test(finds_wrong_words),          cmocka_unit_test(finds_wrong_types),
        cmocka_unit_test(finds_broken_rules),         cmocka_unit_test(wants_square_pixels),
        cmocka_unit_test(guesses_what_was_meant),     cmocka_unit_test(wants_the_observer_above),
        cmocka_unit_test(reports_all_errors_at_once), cmocka_unit_test(counts_what_it_does_not_keep),
        cmocka_unit_test(lists_conventions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

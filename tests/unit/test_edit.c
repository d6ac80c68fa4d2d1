/* SPDX-License-Identifier: MIT */
/* Changing scenes by assignments: paths, values, failures that leave no trace, and no growth. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parameter/document.h"
#include "scene/object.h"
#include "scenes.h"

static luxel_scene *good(void)
{
    luxel_scene *scene;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    return scene;
}

static void expect_text(const luxel_scene *scene, const char *part, bool there)
{
    char *text = NULL;
    assert_int_equal(luxel_scene_write_text(scene, &text), LUXEL_OK);
    if ((strstr(text, part) != NULL) != there)
        fail_msg("%s %s in:\n%s", part, there ? "is not" : "is", text);
    luxel_text_free(text);
}

static void sets_values(void **state)
{
    (void)state;
    static const struct {
        const char *assignment, *part;
    } cases[] = {
        {"lights[0].intensity=20", "intensity: 20,"},
        {"lights.0.intensity= 21 ", "intensity: 21,"},
        {" lights[0].intensity =22", "intensity: 22,"},
        {"surfaces[0].material.specular=0.25", "specular: 0.25}"},
        {"surfaces[0].material.model=lambert", "{model: lambert,"},
        {"surfaces[0].name=ball", "name: ball"},
        {"surfaces[0].name=\"5\"", "name: \"5\""},
        {"screen.resolution=[40, 40]", "resolution: [40, 40]"},
        {"screen.resolution[1]=40", "resolution: [40, 40]"},
        {"points[1][0]=-7.5", "points: [[0, 0], [-7.5, 0]]"},
        {"points=[]", "points: []"},
        {"shadows=none", "shadows: none"},
        {"picture.range=[0, 5]", "range: [0, 5]"},
        {"lights=[{type: ambient, irradiance: 3}]", "lights: [{type: ambient, irradiance: 3}]"},
        {"lights[0]={type: distant, direction: [0, 0, -1], irradiance: 3}",
         "lights: [{type: distant, direction: [0, 0, -1], irradiance: 3}]"},
        {"observer=z: 1600\nprojection: perspective", "observer: {z: 1600, projection: perspective}"},
        {"lights=[]", "lights: []"},
    };
    luxel_scene *scene = good();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_int_equal(luxel_scene_set(scene, cases[i].assignment, NULL), LUXEL_OK);
        assert_false(luxel_scene_is_committed(scene));
        expect_text(scene, cases[i].part, true);
    }
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_scene_free(scene);
}

static void makes_missing_groups(void **state)
{
    (void)state;
    luxel_scene *scene;
    assert_int_equal(load("luxel: 1\nscreen:\nsurfaces: [{type: sphere}]\nlights: []\n", NULL, &scene),
                     LUXEL_ERROR_SCENE);
    static const char *const assignments[] = {"screen.width=100",
                                              "screen.height=100",
                                              "screen.resolution=[2, 2]",
                                              "observer.z=500",
                                              "surfaces[0].center=[0,0,5]",
                                              "surfaces[0].radius=5",
                                              "surfaces[0].material.over_pi=true",
                                              "picture.rounding=nearest"};
    for (size_t i = 0; i < sizeof assignments / sizeof assignments[0]; i++)
        assert_int_equal(luxel_scene_set(scene, assignments[i], NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    expect_text(scene, "screen: {width: 100, height: 100, resolution: [2, 2]}\n", true);
    expect_text(scene, "{type: sphere, center: [0,0,5], radius: 5, material: {over_pi: true}}", true);
    expect_text(scene, "picture: {rounding: nearest}\n", true);
    luxel_scene_free(scene);
}

static void refuses_bad_paths(void **state)
{
    (void)state;
    static const struct {
        const char *assignment, *id;
        unsigned column;
        const char *message, *hint;
    } cases[] = {
        {"lights[0].intensty=2", "unknown-key", 11, "intensty", "\"intensity\""},
        {"Screen.width=2", "unknown-key", 1, "Screen", "\"screen\""},
        {"surfaces[0].materail.diffuse=1", "unknown-key", 13, "materail", "\"material\""},
        {"lights[0].inner=5", "unknown-key", 11, "inner", "spot"},
        {"lights[0].type.x=5", "no-keys", 16, "lights[0].type", ""},
        {"screen.width.x=5", "no-keys", 14, "screen.width", ""},
        {"lights[1].intensity=2", "no-such-element", 8, "1 element, lights[0]", ""},
        {"points[2]=[0, 0]", "no-such-element", 8, "2 elements, points[0] to points[1]", ""},
        {"points[99999999999999999999999]=1", "no-such-element", 8, "", ""},
        {"lights.intensity=2", "needs-index", 8, "lights[0].intensity", ""},
        {"screen[0]=2", "not-a-list", 8, "screen", ""},
        {"screen.width[0]=2", "not-a-list", 14, "screen.width", ""},
        {"lights[0].axis[0]=2", "list-not-written", 16, "lights[0].axis", ""},
        {"lights[0]intensity=2", "path-syntax", 10, "", "lights[0].intensity"},
        {"lights[0.intensity=2", "path-syntax", 7, "", ""},
        {"lights[-1].intensity=2", "path-syntax", 7, "", ""},
        {"lights[].intensity=2", "path-syntax", 7, "", ""},
        {"lights..x=2", "path-syntax", 7, "", ""},
        {"lights.=2", "path-syntax", 7, "", ""},
        {".lights=2", "path-syntax", 1, "", ""},
        {"[0]=2", "path-syntax", 1, "", ""},
        {"=2", "path-syntax", 1, "", ""},
        {"=", "path-syntax", 1, "", ""},
        {"\x1B[31m=2", "path-syntax", 1, "", ""},
        {"a.b.c.d.e.f.g.h.i.j=2", "path-too-long", 16, "", ""},
        {"lights[0].intensity", "no-equals", 1, "KEY=VALUE", ""},
        {"", "no-equals", 1, "", ""},
    };
    luxel_scene *scene = good();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_scene_set(scene, cases[i].assignment, diagnostics), LUXEL_ERROR_PATH);
        expect_entry(diagnostics, 0, WANTED(cases[i].id, 1, cases[i].column, NULL, cases[i].message, cases[i].hint));
        assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->source, "-s");
        luxel_diagnostics_free(diagnostics);
        assert_true(luxel_scene_is_committed(scene)); /* nothing happened */
    }
    luxel_scene_free(scene);
}

static void refuses_bad_values(void **state)
{
    (void)state;
    static const struct {
        const char *assignment, *id;
        unsigned column;
    } cases[] = {
        {"lights[0].intensity=", "no-value", 21},
        {"lights[0].intensity= # none", "no-value", 21},
        {"lights[0].intensity=[1", "not-closed", 21},
        {"lights[0].intensity=\"1", "syntax", 22},
        {"lights[0].intensity=&a 1", "no-anchors", 21},
        {"lights[0].intensity=\x01", "control-character", 21},
        {"lights[0].intensity=\xFF", "not-utf8", 21},
        {"lights[0].intensity=]", "syntax", 21},
        {"points=[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1", "too-deep", 39},
    };
    luxel_scene *scene = good();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_scene_set(scene, cases[i].assignment, diagnostics), LUXEL_ERROR_SCENE);
        expect_entry(diagnostics, 0, WANTED(cases[i].id, 1, cases[i].column));
        luxel_diagnostics_free(diagnostics);
        assert_true(luxel_scene_is_committed(scene));
    }
    luxel_scene_free(scene);
}

static void leaves_legality_to_commit(void **state)
{
    (void)state;
    luxel_scene *scene = good();
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=-5", diagnostics), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "lights[0].type=poitn", diagnostics), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "lights[0].inner=1", diagnostics), LUXEL_OK); /* of any type now */
    assert_int_equal(luxel_scene_set(scene, "lights[0].type=point", diagnostics), LUXEL_OK);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 0);
    assert_int_equal(luxel_scene_commit(scene, diagnostics), LUXEL_ERROR_SCENE);
    expect_entry(diagnostics, 0, WANTED("out-of-range", 1, 21, "lights[0].intensity"));
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->source, "-s");
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->excerpt, "lights[0].intensity=-5");
    expect_entry(diagnostics, 1, WANTED("unknown-key", 1, 11, "lights[0].inner"));
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

static void does_not_grow(void **state)
{
    (void)state;
    luxel_scene *scene = good();
    size_t most = 0;
    for (int i = 0; i < 20000; i++) {
        char assignment[100];
        snprintf(assignment, sizeof assignment, "lights[0].position=[%d, 0, 2000]", i);
        assert_int_equal(luxel_scene_set(scene, assignment, NULL), LUXEL_OK);
        size_t bytes = lx_document_bytes(&scene->document);
        most = bytes > most ? bytes : most;
    }
    assert_true(most < 200000);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    expect_text(scene, "position: [19999, 0, 2000]", true);
    luxel_scene_free(scene);
}

static void copies_are_independent(void **state)
{
    (void)state;
    luxel_scene *scene = good();
    luxel_scene *copy = luxel_scene_copy(scene);
    assert_true(luxel_scene_is_committed(copy));
    assert_int_equal(luxel_scene_point_count(copy), 2);
    assert_int_equal(luxel_scene_set(copy, "shadows=none", NULL), LUXEL_OK);
    assert_true(luxel_scene_is_committed(scene));
    luxel_scene *second = luxel_scene_copy(copy);
    assert_false(luxel_scene_is_committed(second));
    expect_text(scene, "shadows", false);
    luxel_scene_free(scene);
    luxel_scene_free(copy);
    expect_text(second, "shadows: none", true);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(luxel_scene_set(second, "surfaces[0].name=x", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_set(second, "units=lux", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(second, diagnostics), LUXEL_ERROR_SCENE);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(second);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sets_values),
        cmocka_unit_test(makes_missing_groups),
        cmocka_unit_test(refuses_bad_paths),
        cmocka_unit_test(refuses_bad_values),
        cmocka_unit_test(leaves_legality_to_commit),
        cmocka_unit_test(does_not_grow),
        cmocka_unit_test(copies_are_independent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Advice: each kind, at its place, and none where all is well; and the list of parameters it is taken from. */
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

/* Asserts that the good scene, so changed, has exactly one piece of advice (id NULL: none). */
static void expect_advice(const char *old, const char *new_words, struct expected expected)
{
    char *text = changed(old, new_words);
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(load(text, diagnostics, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
    assert_int_equal(luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ADVICE), expected.id ? 1 : 0);
    if (expected.id)
        expect_entry(diagnostics, 0, expected);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    free(text);
}

static void is_silent_where_all_is_well(void **state)
{
    (void)state;
    expect_advice("luxel: 1", "luxel: 1", WANTED(NULL));
    expect_advice("lights:\n", "lights:\n  - {type: ambient, irradiance: 1}\n", WANTED(NULL));
}

static void names_values_out_of_range(void **state)
{
    (void)state;
    expect_advice("radius: 300", "radius: 30", WANTED("not-advised", 8, 13, "surfaces[0].radius", "50 to 2000 mm"));
    expect_advice("[2000, 0, 2000]", "[2000, 20000, 2000]",
                  WANTED("not-advised", 11, 36, "lights[0].position[1]", "-10000 to 10000 mm"));
    expect_advice("intensity: 10", "intensity: 20000", WANTED("not-advised", 11, 0, .message = "W/sr"));
    expect_advice("diffuse: 0.8", "diffuse: 1.5", WANTED("not-advised", 9, 0, "surfaces[0].material.diffuse"));
    expect_advice("radiometric\n", "photometric\n", WANTED(NULL));
}

static void names_unused_keys(void **state)
{
    (void)state;
    expect_advice("z: 1500, projection: orthographic", "z: 9000, projection: perspective",
                  WANTED("not-used", 4, 0, "observer.view", "perspective"));
    expect_advice("none}", "none, k: 50}", WANTED("not-used", 11, 0, "lights[0].k", "none"));
    expect_advice("{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}",
                  "{type: volume, sphere: {center: [0, 0, 2000], radius: 9}, scale: 2, power: 1}",
                  WANTED("not-used", 11, 0, "lights[0].scale", "scale has no effect without mesh"));
    expect_advice("model: phong", "model: lambert",
                  WANTED("not-used", 9, 0, "surfaces[0].material.shininess", "lambert"));
}

static void watches_the_view(void **state)
{
    (void)state;
    expect_advice("center: [0, 0, 1000]", "center: [100, 0, 1000]", WANTED(NULL));
    expect_advice("center: [0, 0, 1000]", "center: [101, 0, 1000]",
                  WANTED("not-in-view", 6, 5, "surfaces[0]", "right"));
    expect_advice("center: [0, 0, 1000]", "center: [0, -150, 1000]", WANTED("not-in-view", 6, 5, .message = "bottom"));
    /* a wall behind it, whose ends nobody wants to see */
    expect_advice("surfaces:\n", "surfaces:\n  - {type: rectangle, center: [0, 0, 500], size: [900, 900]}\n",
                  WANTED(NULL));
    /* in perspective the same sphere looks larger: its outline lies at 100/sqrt(500^2 - 100^2) of 1500 mm */
    static const struct {
        const char *words;
        bool fits;
    } cases[] = {{"width: 613, height: 613", true}, {"width: 612, height: 612", false}};
    for (size_t i = 0; i < 2; i++) {
        char *text = changed("width: 800, height: 800", cases[i].words);
        luxel_scene *scene;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
        assert_int_equal(luxel_scene_set(scene, "observer={z: 1500, projection: perspective}", NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_set(scene, "surfaces[0].radius=100", NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
        assert_int_equal(luxel_diagnostics_count(diagnostics), cases[i].fits ? 0 : 1);
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
        free(text);
    }
}

/* What lies outside its advised range is brought to the end that is near, and no farther. */
static void mends_to_the_nearest_end(void **state)
{
    (void)state;
    static const struct {
        const char *words, *hint;
    } cases[] = {
        {"width: 800, height: 800, resolution: [1000, 1000]", "'screen.resolution=[800, 800]'"},
        {"width: 800, height: 800, resolution: [150, 150]", "'screen.resolution=[200, 200]'"},
        {"width: 900, height: 600, resolution: [150, 100]", "'screen.resolution=[300, 200]'"},
        {"width: 900, height: 600, resolution: [1200, 800]", "'screen.resolution=[798, 532]'"},
        {"width: 90, height: 60, resolution: [300, 200]", "'screen.width=150' -s 'screen.height=100'"},
        {"width: 30000, height: 15000, resolution: [400, 200]", "'screen.width=10000' -s 'screen.height=5000'"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *text = changed("width: 800, height: 800, resolution: [400, 400]", cases[i].words);
        luxel_scene *scene;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        bool found = false;
        assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
        assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
        for (size_t k = 0; k < luxel_diagnostics_count(diagnostics); k++) {
            char *hint = luxel_diagnostics_hint(diagnostics, k, NULL, NULL);
            found = found || strstr(hint, cases[i].hint);
            luxel_text_free(hint);
        }
        if (!found)
            fail_msg("%s: no %s", cases[i].words, cases[i].hint);
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
        free(text);
    }
}

static void watches_lights_behind(void **state)
{
    (void)state;
    expect_advice("[2000, 0, 2000]", "[10, 0, 300]", WANTED("light-behind", 11, 29, "lights[0].position"));
    expect_advice("[2000, 0, 2000]", "[10, 0, 1100]", WANTED("light-behind", 11, 29));
    expect_advice("[2000, 0, 2000]", "[10, 0, 1400]", WANTED(NULL));
    expect_advice("[2000, 0, 2000]", "[301, 0, 300]", WANTED(NULL));
    expect_advice("[2000, 0, 2000], intensity: 10", "[10, 0, 300], intensity: 10, enabled: false", WANTED(NULL));
}

static void wants_a_committed_scene(void **state)
{
    (void)state;
    luxel_scene *scene;
    assert_int_equal(luxel_scene_read_text(good_scene, strlen(good_scene), "a", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_advise(scene, NULL), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
}

static const luxel_parameter *find(const luxel_parameters *list, const char *path, const char *variant)
{
    const luxel_parameter *parameter;
    for (size_t i = 0; (parameter = luxel_parameters_get(list, i)); i++)
        if (strcmp(parameter->path, path) == 0 &&
            (!variant || (parameter->variant && strcmp(parameter->variant, variant) == 0)))
            return parameter;
    return NULL;
}

static void lists_parameters(void **state)
{
    (void)state;
    luxel_parameters *list = luxel_parameters_new();
    const luxel_parameter *width = find(list, "screen.width", NULL), *type = find(list, "lights[].type", NULL);
    const luxel_parameter *outer = find(list, "lights[].outer", "spot");
    const luxel_parameter *model = find(list, "surfaces[].material.model", NULL);
    assert_non_null(width);
    assert_string_equal(width->type, "number");
    assert_string_equal(width->unit, "mm");
    assert_string_equal(width->legal, "> 0 mm");
    assert_string_equal(width->advised, "100 to 10000 mm");
    assert_true(width->required);
    assert_non_null(type);
    assert_string_equal(type->choices, "point, points, spot, luminaire, planar, volume, distant, ambient, sun, sky");
    assert_non_null(outer);
    assert_string_equal(outer->legal, "0 to 90°");
    assert_non_null(model);
    assert_string_equal(model->default_value, "blinn-phong");
    assert_null(find(list, "lights[].outer", "point"));
    for (size_t i = 0; i < luxel_parameters_count(list); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(list, i);
        assert_true(strlen(parameter->meaning) > 3);
        assert_true(strlen(parameter->type) > 3);
        assert_non_null(parameter->unit);
    }
    assert_null(luxel_parameters_get(list, luxel_parameters_count(list)));
    luxel_parameters_free(list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_silent_where_all_is_well), cmocka_unit_test(names_values_out_of_range),
        cmocka_unit_test(names_unused_keys),           cmocka_unit_test(watches_the_view),
        cmocka_unit_test(mends_to_the_nearest_end),    cmocka_unit_test(watches_lights_behind),
        cmocka_unit_test(wants_a_committed_scene),     cmocka_unit_test(lists_parameters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Explanations: what is told of values that are special, and that the numbers in them are those of the probe. */
#include <stdio.h>
#include <string.h>

#include "scenes.h"

struct asked {
    const char *scene;
    const char *assignments[4]; /* the rest NULL */
    double x_mm, y_mm;
    luxel_quantity quantity;
};

static char *explain(struct asked asked)
{
    luxel_scene *scene = builtin(asked.scene);
    luxel_document *document = NULL;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = asked.quantity;
    for (size_t i = 0; i < 4 && asked.assignments[i]; i++)
        assert_int_equal(luxel_scene_set(scene, asked.assignments[i], NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_explain(scene, &settings, asked.x_mm, asked.y_mm, NULL, NULL, &document), LUXEL_OK);
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_MARKDOWN);
    assert_non_null(text);
    luxel_document_free(document);
    luxel_scene_free(scene);
    return text;
}

/* The explanation has these words and, unless `absent` is NULL, not those. */
static void expect(struct asked asked, const char *words, const char *absent)
{
    char *text = explain(asked);
    if (!strstr(text, words))
        fail_msg("\"%s\" is not in\n%s", words, text);
    if (absent && strstr(text, absent))
        fail_msg("\"%s\" is in\n%s", absent, text);
    luxel_text_free(text);
}

static void tells_where_it_is_not_seen(void **state)
{
    (void)state;
    static const char small[] = "screen={width: 100, height: 100, resolution: [10, 10]}";
    expect((struct asked){.scene = "report", .assignments = {small}, .x_mm = 60}, "no pixel shows it",
           "The pixel that the point falls in");
    expect((struct asked){.scene = "report", .assignments = {small}, .x_mm = 40}, "The pixel that the point falls in",
           "no pixel shows it");
    expect((struct asked){.scene = "report", .x_mm = 5000}, "meets no surface", "The value is");
}

static void tells_what_blocks_it(void **state)
{
    (void)state;
    expect((struct asked){.scene = "report", .assignments = {"lights[0].position=[0, 0, 1300]"}},
           "lights\\[0\\] lies on the very point", "The value is");
    expect((struct asked){.scene = "report", .assignments = {"lights[0].enabled=false"}}, "no lights that are on",
           NULL);
}

/* Two plates each take half of a lamp, three quarters together; without shadows nothing is told. */
static void tells_who_hides_it(void **state)
{
    (void)state;
    static const char surfaces[] =
        "surfaces=[{type: rectangle, center: [0, 0, 0], size: [400, 400]}, {type: rectangle, "
        "name: screen, center: [510, 0, 500], size: [1000, 1000]}, {type: rectangle, "
        "center: [0, 510, 250], size: [1000, 1000]}]",
                      lamp[] = "lights=[{type: planar, rectangle: {center: [10, 10, 1000], size: [200, 200]}, "
                               "radiance: 10}]",
                      eye[] = "observer={z: 3000, projection: perspective}";
    static const char *const words[] = {"; 75 % of that is hidden", "surfaces\\[1\\] screen: 50 %",
                                        "surfaces\\[2\\]: 50 %"};
    for (int i = 0; i < 3; i++)
        expect((struct asked){.scene = "report", .assignments = {surfaces, lamp, eye}, .x_mm = 10, .y_mm = 10},
               words[i], "surfaces\\[0\\]: ");
    expect(
        (struct asked){.scene = "report", .assignments = {surfaces, lamp, eye, "shadows=none"}, .x_mm = 10, .y_mm = 10},
        "The sum", "of that is hidden");
}

/* Twelve lights are told one by one; of the others, which give 1 and 2, only the sum. */
static void adds_up_the_others(void **state)
{
    (void)state;
    char lights[1024] = "lights=[";
    for (int i = 1; i <= 14; i++)
        snprintf(lights + strlen(lights), sizeof lights - strlen(lights), "{type: ambient, irradiance: %d}%s",
                 i * 4 % 15, i < 14 ? ", " : "]"); /* 1 to 14 in another order */
    expect((struct asked){.scene = "report", .assignments = {lights}, .quantity = LUXEL_IRRADIANCE},
           "The other 2 lights, which give less, add up to 3.", NULL);
}

static void tells_the_model(void **state)
{
    (void)state;
    static const char phong[] = "surfaces[0].material={model: phong, diffuse: 0.8, specular: 0.5, shininess: 20}";
    expect((struct asked){.scene = "report", .assignments = {phong}}, "\\mathbf{R} \\cdot \\mathbf{V}", "\\mathbf{H}");
    expect((struct asked){.scene = "report"}, "\\mathbf{H}", "\\mathbf{R} \\cdot \\mathbf{V}");
    /* 700 mm above the top of the sphere, which stands at 1300 mm: 1 / (0.5 + 0.7) */
    expect((struct asked){.scene = "report",
                          .assignments = {"lights[0]={type: point, position: [0, 0, 2000], intensity: 3, attenuation: "
                                          "practical, k: 500}"}},
           "\\frac{1}{k + r} = \\frac{1}{0.5 + 0.7} = 0.83333", "\\frac{1}{r^2}");
}

static void tells_how_an_integral_is_found(void **state)
{
    (void)state;
    expect((struct asked){.scene = "ball-lamp", .assignments = {"surfaces[0].material={model: lambert, diffuse: 1}"}},
           "has a closed form", "computed from");
    expect((struct asked){.scene = "ball-lamp", .assignments = {"surfaces[0].material={model: lambert, diffuse: 1}"}},
           "B_d = p", "B_s");
    expect((struct asked){.scene = "ball-lamp"}, "B_s = ", NULL);
    expect((struct asked){.scene = "all-sources", .x_mm = 150, .y_mm = 150}, "computed from", NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tells_where_it_is_not_seen),
        cmocka_unit_test(tells_what_blocks_it),
        cmocka_unit_test(tells_who_hides_it),
        cmocka_unit_test(adds_up_the_others),
        cmocka_unit_test(tells_the_model),
        cmocka_unit_test(tells_how_an_integral_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

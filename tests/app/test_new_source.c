/* SPDX-License-Identifier: MIT */
/* A source that is added follows the chosen one's law, stands elsewhere, is aimed at the surface and as strong. */
#include <math.h>
#include <string.h>

#include "../../app/base/number.h"
#include "../../app/form/new_source.h"
#include "../../app/picture/marks.h"
#include "scenes.h"

/* The greatest irradiance of a source alone, over every eighth pixel of each way. */
static double greatest(const AppDocument *document, gssize light)
{
    luxel_settings settings;
    luxel_field *field;
    AppMoment *moment = app_moment_new(app_document_copy_scene(document), 0, light, NULL);
    assert_non_null(moment);
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.stride = 8;
    app_moment_light(moment, &settings);
    assert_int_equal(luxel_render(moment->scene, &settings, NULL, &field), LUXEL_OK);
    const double value = luxel_field_statistics(field)->maximum.value;
    luxel_field_free(field);
    app_moment_unref(moment);
    return value;
}

/* Takes the text over. */
static void insert(AppDocument *document, char *yaml)
{
    assert_non_null(yaml);
    const AppEdit edit = {
        .kind = APP_EDIT_INSERT, .key = "lights", .value = yaml, .index = app_document_size(document, "lights")};
    assert_true(app_document_edit(document, &edit, 1, NULL, NULL));
    g_free(yaml);
}

/* How strong the sky and the sun are is not changed. */
static gboolean is_daylight(const char *kind)
{
    return strcmp(kind, "sky") == 0 || strcmp(kind, "sun") == 0;
}

/* Every other kind that has an example, beside the first source of every built-in scene. */
static void gives_as_much(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    gsize compared = 0;
    for (gsize s = 0; luxel_builtin_scene_name(s); s++)
        for (gsize i = 0; i < luxel_parameters_kind_count(parameters); i++) {
            /* in its ceiling, which the others shine at from next to it */
            if (strcmp(luxel_builtin_scene_name(s), "office") == 0)
                continue;
            const luxel_parameter_kind *kind = luxel_parameters_kind(parameters, i);
            if (strcmp(kind->list, "lights") != 0 || !kind->example || is_daylight(kind->name))
                continue;
            AppDocument *document = document_of_builtin(luxel_builtin_scene_name(s));
            const gsize index = app_document_size(document, "lights");
            insert(document, app_new_source(document, kind->name, 0));
            const double old = greatest(document, 0), new = greatest(document, (gssize)index);
            /* a source that does not reach what is in view stays as it is */
            if (new > 0 && old > 0 && fabs(new / old - 1) > 0.35)
                fail_msg("%s in %s gives %g beside %g", kind->name, luxel_builtin_scene_name(s), new, old);
            compared += new > 0 && old > 0;
            g_object_unref(document);
        }
    assert_true(compared > 60);
    luxel_parameters_free(parameters);
}

static void follows_the_law(void **state)
{
    (void)state;
    static const char *const kinds[] = {"point", "spot", "planar", "volume"};
    for (gsize i = 0; i < G_N_ELEMENTS(kinds); i++) {
        AppDocument *document = document_of_builtin("report"); /* without attenuation */
        AppMoment *before = moment_of(document);
        insert(document, app_new_source(document, kinds[i], 0));
        assert_key(document, "lights[1].attenuation", "none");
        AppMoment *after = moment_of(document);
        if (i < 2)
            assert_string_equal(luxel_scene_unit(after->scene, LUXEL_BRIGHTNESS),
                                luxel_scene_unit(before->scene, LUXEL_BRIGHTNESS));
        app_moment_unref(before);
        app_moment_unref(after);
        set(document, "lights[0].attenuation", "practical");
        set(document, "lights[0].k", "250");
        insert(document, app_new_source(document, kinds[i], 0));
        assert_key(document, "lights[2].attenuation", "practical");
        assert_key(document, "lights[2].k", "250");
        g_object_unref(document);
    }
}

static void stands_elsewhere_and_looks_there(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    double place[3];
    set(document, "surfaces[0].center", "[120, -80, 900]");
    set(document, "lights[0].pattern", "lambertian");
    insert(document, app_new_source(document, "spot", 0));
    assert_key(document, "lights[1].aim", "[120, -80, 900]");
    char *text = app_document_get(document, "lights[1].position", NULL);
    assert_int_equal(app_list_read(text, place, 3), 3);
    assert_true(place[0] < 0 && place[2] == 2000); /* the other one stands at 2000, 0, 2000 */
    g_free(text);
    insert(document, app_new_source(document, "point", 0));
    assert_key(document, "lights[2].pattern", "lambertian");
    assert_key(document, "lights[2].aim", "[120, -80, 900]");
    g_object_unref(document);
}

/* However many are added to the same lamp, each has a place of its own. */
static void none_stands_on_another(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    double places[5][3];
    for (int i = 0; i < 5; i++) {
        char *key = g_strdup_printf("lights[%d].position", i);
        if (i > 0)
            insert(document, app_new_source(document, i % 2 ? "point" : "spot", 0));
        char *text = app_document_get(document, key, NULL);
        assert_int_equal(app_list_read(text, places[i], 3), 3);
        for (int k = 0; k < i; k++)
            assert_true(hypot(places[i][0] - places[k][0], places[i][1] - places[k][1]) > 100);
        g_free(text);
        g_free(key);
    }
    g_object_unref(document);
}

static void begins_in_the_dark(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    const AppEdit edit = {.kind = APP_EDIT_REMOVE, .key = "lights[0]"};
    assert_true(app_document_edit(document, &edit, 1, NULL, NULL));
    insert(document, app_new_source(document, "point", 0));
    assert_true(greatest(document, 0) > 0);
    assert_null(app_new_source(document, "lantern", 0));
    assert_null(app_new_source(document, "points", 0)); /* which needs a file */
    g_object_unref(document);
}

/* Another kind in its place stands where it stood, is called so, and gives as much. */
static void another_kind_stands_in_its_place(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    gsize compared = 0;
    for (gsize i = 0; i < luxel_parameters_kind_count(parameters); i++) {
        const luxel_parameter_kind *kind = luxel_parameters_kind(parameters, i);
        if (strcmp(kind->list, "lights") != 0 || !kind->example || is_daylight(kind->name))
            continue;
        AppDocument *document = document_of_builtin("report");
        set(document, "lights[0].name", "window");
        set(document, "lights[0].position", "[-1500, 400, 2600]");
        const double old = greatest(document, 0);
        insert(document, app_changed_source(document, kind->name, 0));
        assert_key(document, "lights[1].name", "window");
        assert_key(document, "lights[1].type", kind->name);
        char *place_key = app_place_key(document, APP_MARK_SOURCE, 1);
        if (place_key)
            assert_key(document, place_key, "[-1500, 400, 2600]");
        const double new = greatest(document, 1);
        if (!(new > 0 && fabs(new / old - 1) < 0.35))
            fail_msg("%s gives %g in the place of %g", kind->name, new, old);
        compared += place_key != NULL;
        g_free(place_key);
        g_object_unref(document);
    }
    assert_true(compared >= 4);
    luxel_parameters_free(parameters);
}

static void doubles_are_seen(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    insert(document, app_doubled_source(document, 0));
    assert_key(document, "lights[1].position", "[2100, 0, 2000]");
    assert_key(document, "lights[0].position", "[2000, 0, 2000]");
    assert_key(document, "lights[1].intensity", "10");
    assert_null(app_doubled_source(document, 7));
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gives_as_much),
        cmocka_unit_test(follows_the_law),
        cmocka_unit_test(stands_elsewhere_and_looks_there),
        cmocka_unit_test(none_stands_on_another),
        cmocka_unit_test(begins_in_the_dark),
        cmocka_unit_test(another_kind_stands_in_its_place),
        cmocka_unit_test(doubles_are_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* The rules of the parameter table in forms: what is shown, what a change brings with it, and what can be instead. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "../../app/base/number.h"
#include "../../app/form/rules.h"
#include "scenes.h"

static luxel_parameters *parameters;

static int make_parameters(void **state)
{
    (void)state;
    parameters = luxel_parameters_new();
    return parameters ? 0 : -1;
}

static int free_parameters(void **state)
{
    (void)state;
    luxel_parameters_free(parameters);
    return 0;
}

/* A light of a document, as a form has it. */
typedef struct Light {
    AppDocument *document;
    AppKeys keys;
    char *type;
} Light;

/* Anew after its type may have changed. */
static void look(Light *light)
{
    char *key = g_strdup_printf("lights[%zu].type", light->keys.index);
    g_free(light->type);
    light->type = app_document_get(light->document, key, NULL);
    light->keys = (AppKeys){light->document, parameters, light->type, light->keys.index};
    g_free(key);
}

static Light light_of(const char *scene, gsize index)
{
    Light light = {.document = document_of_builtin(scene), .keys = {.index = index}};
    look(&light);
    return light;
}

static void clear_light(Light *light)
{
    g_free(light->type);
    g_object_unref(light->document);
}

/* A parameter of such elements, such as "lights[].radiance". */
static const luxel_parameter *find(const AppKeys *keys, const char *path)
{
    for (gsize i = 0; i < luxel_parameters_count(parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(parameters, i);
        if (strcmp(parameter->path, path) == 0 && app_keys_has(keys, parameter))
            return parameter;
    }
    fail_msg("%s has no %s", keys->type, path);
    return NULL;
}

static void make(AppDocument *document, AppEdits *edits)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    if (!app_document_edit(document, (const AppEdit *)(void *)edits->list->data, edits->list->len, NULL, faults))
        fail_msg("%s", luxel_diagnostics_message(faults, 0, NULL, NULL));
    luxel_diagnostics_free(faults);
    app_edits_free(edits);
}

/* Gives a key of the light a value, as the form does; the scene must be a right one then. */
static void give(Light *light, const char *path, const char *yaml)
{
    AppEdits *edits = app_edits_new();
    app_keys_set(&light->keys, find(&light->keys, path), -1, yaml, edits);
    make(light->document, edits);
    look(light);
    app_moment_unref(moment_of(light->document));
}

/* Gives a key instead of another. */
static void change_over(Light *light, const char *from, const char *to)
{
    AppEdits *edits = app_edits_new();
    app_keys_switch(&light->keys, find(&light->keys, from), find(&light->keys, to), edits);
    make(light->document, edits);
    app_moment_unref(moment_of(light->document));
}

static gboolean has(const Light *light, const char *name)
{
    gboolean written;
    char *key = g_strdup_printf("lights[%zu].%s", light->keys.index, name);
    g_free(app_document_get(light->document, key, &written));
    g_free(key);
    return written;
}

static gboolean shows(const Light *light, const char *path)
{
    return app_keys_is_shown(&light->keys, find(&light->keys, path));
}

static double flux_of(const Light *light)
{
    double flux;
    AppMoment *moment = moment_of(light->document);
    assert_int_equal(luxel_scene_light_flux(moment->scene, light->keys.index, &flux), LUXEL_OK);
    app_moment_unref(moment);
    return flux;
}

/* ---- what is shown ---- */

/* All keys shown of a light, in the order of the table. */
static char *shown(const Light *light)
{
    GString *names = g_string_new(NULL);
    for (gsize i = 0; i < luxel_parameters_count(parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(parameters, i);
        if (g_str_has_prefix(parameter->path, "lights[].") && app_keys_is_shown(&light->keys, parameter))
            g_string_append_printf(names, "%s%s", names->len ? " " : "", parameter->path + strlen("lights[]."));
    }
    return g_string_free(names, FALSE);
}

#define ARRAY " array" /* which is not given: its keys say nothing */
#define BODY "attenuation parts" ARRAY
#define SPOT                                                                                                           \
    "type name group enabled color color.temperature position intensity attenuation aim inner outer falloff "          \
    "exponent" ARRAY
#define POINT "type name group enabled color color.temperature position intensity attenuation pattern" ARRAY
#define AMBIENT "type name group enabled color color.temperature irradiance"
#define LUMINAIRE                                                                                                      \
    "type name group enabled color color.temperature file position attenuation axis c0 flux factor "                   \
    "maintenance_factor "                                                                                              \
    "interpolation opening" ARRAY
#define DISTANT "type name group enabled color color.temperature direction irradiance"

static void shows_what_has_a_say(void **state)
{
    (void)state;
    static const struct {
        const char *scene;
        gsize index;
        const char *keys;
    } cases[] = {
        {"report", 0, POINT},
        {"sphere", 0, POINT},
        {"distant", 0, DISTANT},
        {"distant", 1, AMBIENT},
        {"spot", 0, SPOT},
        {"spot", 1, AMBIENT},
        {"three-lights", 0, POINT},
        {"three-lights", 1,
         "type name group enabled color color.temperature position intensity attenuation aim pattern" ARRAY},
        {"three-lights", 2, POINT},
        {"two-spheres", 0, POINT},
        {"two-spheres", 1, AMBIENT},
        {"ambient", 0, AMBIENT},
        {"window", 0,
         "type name group enabled color color.temperature rectangle rectangle.center rectangle.aim rectangle.size "
         "rectangle.up sides radiance " BODY},
        {"window", 1, AMBIENT},
        {"disk-lamp", 0,
         "type name group enabled color color.temperature disk disk.center disk.aim disk.radius sides power " BODY},
        {"box-lamp", 0, "type name group enabled color color.temperature box box.center box.size radiance " BODY},
        {"ball-lamp", 0,
         "type name group enabled color color.temperature sphere sphere.center sphere.radius sphere.facets "
         "power " BODY},
        {"tube", 0,
         "type name group enabled color color.temperature cylinder cylinder.center cylinder.radius cylinder.height "
         "cylinder.axis cylinder.facets "
         "power " BODY},
        {"lampshade", 0,
         "type name group enabled color color.temperature sphere sphere.center sphere.radius sphere.facets radiance "
         "attenuation k parts" ARRAY},
        {"desk", 0, SPOT},
        {"desk", 1, AMBIENT},
        {"tin", 0, SPOT},
        {"tin", 1, AMBIENT},
        {"sundial", 0, DISTANT},
        {"sundial", 1, AMBIENT},
        {"integrating-sphere", 0, POINT},
        {"integrating-sphere", 1, AMBIENT},
        {"room", 0,
         "type name group enabled color color.temperature rectangle rectangle.center rectangle.axis rectangle.size "
         "rectangle.up sides "
         "radiance " BODY},
        {"room", 1, POINT},
        {"room", 2, AMBIENT},
        {"office", 0, LUMINAIRE},
        {"office", 1, LUMINAIRE},
        {"office", 2, LUMINAIRE},
        {"office", 3, LUMINAIRE},
        {"office", 4, AMBIENT},
        {"pot", 0,
         "type name group enabled color color.temperature rectangle rectangle.center rectangle.axis rectangle.size "
         "rectangle.up sides "
         "radiance " BODY},
        {"pot", 1, AMBIENT},
        {"all-sources", 0, AMBIENT},
        {"all-sources", 1, DISTANT},
        {"all-sources", 2, POINT},
        {"all-sources", 3, SPOT},
        {"all-sources", 4,
         "type name group enabled color color.temperature rectangle rectangle.center rectangle.aim rectangle.size "
         "rectangle.up sides radiance " BODY},
        {"all-sources", 5,
         "type name group enabled color color.temperature disk disk.center disk.aim disk.radius sides radiance " BODY},
        {"all-sources", 6, "type name group enabled color color.temperature box box.center box.size radiance " BODY},
        {"all-sources", 7,
         "type name group enabled color color.temperature sphere sphere.center sphere.radius sphere.facets "
         "radiance " BODY},
        {"all-sources", 8,
         "type name group enabled color color.temperature cylinder cylinder.center cylinder.radius cylinder.height "
         "cylinder.axis cylinder.facets "
         "radiance " BODY},
        {"warm-and-cold", 0, POINT},
        {"warm-and-cold", 1, POINT},
        {"mirror", 0, POINT},
        {"mirror", 1, POINT},
        {"mirror", 2, AMBIENT},
    };
    gsize lights = 0;
    for (gsize i = 0; i < luxel_builtin_scene_count(); i++) {
        AppDocument *document = document_of_builtin(luxel_builtin_scene_name(i));
        lights += app_document_size(document, "lights");
        g_object_unref(document);
    }
    assert_int_equal(lights, G_N_ELEMENTS(cases)); /* none is left out */
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        Light light = light_of(cases[i].scene, cases[i].index);
        char *keys = shown(&light);
        assert_string_equal(keys, cases[i].keys);
        g_free(keys);
        clear_light(&light);
    }
}

/* A scale is that of a mesh: it is shown beside one, or where it is written. */
static void shows_the_scale_of_a_mesh(void **state)
{
    (void)state;
#define BOX "{type: volume, box: {center: [0, 0, 2000], size: [9, 9, 9]}, "
    static const char off[] =
        "OFF\n4 4 6\n0 0 1500\n90 0 1500\n0 90 1500\n0 0 1590\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
    char *folder = g_dir_make_tmp("luxel-rules-XXXXXX", NULL), *file = g_build_filename(folder, "a.off", NULL);
    assert_true(g_file_set_contents(file, off, -1, NULL));
    char *mesh = g_strdup_printf("{type: volume, mesh: %s, power: 1}", file);
    const struct {
        const char *light;
        gboolean is_shown;
    } cases[] = {{mesh, TRUE}, {BOX "power: 1}", FALSE}, {BOX "scale: 2, power: 1}", TRUE}};
#undef BOX
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        Light light = light_of("report", 0);
        assert_true(app_document_set(light.document, "lights[0]", cases[i].light, NULL));
        look(&light);
        assert_int_equal(shows(&light, "lights[].scale"), cases[i].is_shown);
        clear_light(&light);
    }
    g_unlink(file);
    g_rmdir(folder);
    g_free(mesh);
    g_free(file);
    g_free(folder);
}

static void knows_paths(void **state)
{
    (void)state;
    Light light = light_of("all-sources", 4);
    const luxel_parameter *size = find(&light.keys, "lights[].rectangle.size");
    char *path = app_keys_path(&light.keys, size);
    assert_string_equal(path, "lights[4].rectangle.size");
    g_free(path);
    path = app_keys_path(&light.keys, find(&light.keys, "screen.width"));
    assert_string_equal(path, "screen.width");
    g_free(path);
    assert_ptr_equal(app_keys_beside(&light.keys, size, "center"), find(&light.keys, "lights[].rectangle.center"));
    assert_null(app_keys_beside(&light.keys, size, "radius"));
    clear_light(&light);
}

/* ---- what a change brings with it ---- */

static void adds_what_is_needed(void **state)
{
    (void)state;
    Light light = light_of("report", 0);
    assert_false(shows(&light, "lights[].k"));
    give(&light, "lights[].attenuation", "practical");
    assert_true(has(&light, "k"));
    assert_true(shows(&light, "lights[].k"));
    give(&light, "lights[].pattern", "lambertian");
    assert_true(shows(&light, "lights[].axis"));
    assert_false(has(&light, "exponent"));
    give(&light, "lights[].pattern", "cosine");
    assert_true(has(&light, "exponent"));
    give(&light, "lights[].exponent", "7");
    give(&light, "lights[].pattern", "isotropic");
    give(&light, "lights[].pattern", "cosine"); /* what is there stays */
    assert_key(light.document, "lights[0].exponent", "7");
    clear_light(&light);
}

/* Whatever it became, it gives light. */
static void expect_light(const Light *light)
{
    double flux;
    AppMoment *moment = moment_of(light->document);
    assert_int_equal(luxel_scene_light_flux(moment->scene, light->keys.index, &flux), LUXEL_OK);
    assert_true(isnan(flux) || flux > 0);
    app_moment_unref(moment);
    char *irradiance = app_document_get(light->document, "lights[0].irradiance", NULL);
    assert_true(!irradiance || g_ascii_strtod(irradiance, NULL) > 0);
    g_free(irradiance);
}

static void changes_types(void **state)
{
    (void)state;
    static const char *const types[] = {"point", "spot", "planar", "volume", "distant", "ambient"};
    for (gsize s = 0; s < luxel_builtin_scene_count(); s++) {
        Light light = light_of(luxel_builtin_scene_name(s), 0);
        for (gsize from = 0; from < G_N_ELEMENTS(types); from++)
            for (gsize to = 0; to < G_N_ELEMENTS(types); to++) {
                give(&light, "lights[].type", types[from]);
                give(&light, "lights[].type", types[to]);
                expect_light(&light);
            }
        clear_light(&light);
    }
}

static void keeps_the_place_and_back(void **state)
{
    (void)state;
    static const char *const types[] = {"spot", "planar", "volume", "planar", "spot", "point"};
    Light light = light_of("three-lights", 0);
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        double place[3];
        give(&light, "lights[].type", types[i]);
        AppMoment *moment = moment_of(light.document);
        assert_true(luxel_scene_light_place(moment->scene, 0, place));
        assert_true(fabs(place[0] + 1200) < 1e-9 && fabs(place[1] - 1000) < 1e-9 && fabs(place[2] - 2600) < 1e-9);
        app_moment_unref(moment);
        assert_key(light.document, "lights[0].name", "key");
    }
    assert_key(light.document, "lights[0].type", "point");
    clear_light(&light);
}

static void keeps_pixels_square(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        int component;
        const char *value;
    } changes[] = {{"screen.width", -1, "1234.5"},  {"screen.height", -1, "333"},  {"screen.resolution", 0, "777"},
                   {"screen.resolution", 1, "123"}, {"screen.resolution", 0, "1"}, {"screen.resolution", 1, "1"},
                   {"screen.resolution", 1, "50"},  {"screen.width", -1, "0.1"},   {"screen.height", -1, "7e5"}};
    static const char *const scenes[] = {"report", "three-lights", "desk"};
    for (gsize s = 0; s < G_N_ELEMENTS(scenes); s++) {
        AppDocument *document = document_of_builtin(scenes[s]);
        const AppKeys keys = {.document = document, .parameters = parameters};
        for (gsize i = 0; i < G_N_ELEMENTS(changes); i++) {
            AppEdits *edits = app_edits_new();
            app_keys_set(&keys, find(&keys, changes[i].path), changes[i].component, changes[i].value, edits);
            make(document, edits);
            app_moment_unref(moment_of(document));
            char *found = app_document_get(document, changes[i].path, NULL);
            double numbers[2];
            app_list_read(found, numbers, 2);
            assert_true(numbers[MAX(changes[i].component, 0)] == g_ascii_strtod(changes[i].value, NULL));
            g_free(found);
        }
        g_object_unref(document);
    }
}

static void sets_one_number_of_several(void **state)
{
    (void)state;
    Light light = light_of("report", 0);
    AppEdits *edits = app_edits_new();
    app_keys_set(&light.keys, find(&light.keys, "lights[].position"), 1, "-70.5", edits);
    make(light.document, edits);
    assert_key(light.document, "lights[0].position", "[2000, -70.5, 2000]");
    clear_light(&light);
}

/* An array is there as a whole or not at all: then its keys have no say. */
static void gives_and_takes_an_array(void **state)
{
    (void)state;
    Light light = light_of("report", 0);
    const luxel_parameter *places = find(&light.keys, "lights[].array.n");
    assert_true(app_keys_is_optional(&light.keys, find(&light.keys, "lights[].array")));
    assert_false(app_keys_is_optional(&light.keys, find(&light.keys, "lights[].color")));
    assert_false(app_keys_is_shown(&light.keys, places));
    give(&light, "lights[].array", "true");
    assert_key(light.document, "lights[0].array.n", "[2, 2]");
    assert_true(app_keys_is_shown(&light.keys, places));
    assert_true(app_keys_is_shown(&light.keys, find(&light.keys, "lights[].array.spacing")));
    clear_light(&light);
}

/* ---- one key instead of another ---- */

static void expect_instead(const Light *light, const char *path, const char *names)
{
    GPtrArray *found = app_keys_instead(&light->keys, find(&light->keys, path));
    g_ptr_array_add(found, NULL);
    char *joined = g_strjoinv(" ", (char **)found->pdata);
    assert_string_equal(joined, names);
    g_free(joined);
    g_ptr_array_unref(found);
}

static void names_what_can_be_instead(void **state)
{
    (void)state;
    Light window = light_of("window", 0), tube = light_of("tube", 0), spot = light_of("spot", 0);
    expect_instead(&window, "lights[].radiance", "intensity power");
    expect_instead(&window, "lights[].rectangle", "vertices disk");
    expect_instead(&window, "lights[].rectangle.aim", "axis");
    expect_instead(&window, "lights[].parts", "");
    expect_instead(&tube, "lights[].power", "radiance");
    expect_instead(&tube, "lights[].cylinder", "box sphere"); /* not mesh: a file cannot be guessed */
    expect_instead(&spot, "lights[].aim", "axis");
    expect_instead(&spot, "lights[].axis", "aim");
    clear_light(&window);
    clear_light(&tube);
    clear_light(&spot);
}

static void keeps_the_flux(void **state)
{
    (void)state;
    static const char *const names[] = {"lights[].radiance", "lights[].power",     "lights[].intensity",
                                        "lights[].radiance", "lights[].intensity", "lights[].power",
                                        "lights[].radiance"};
    Light window = light_of("window", 0), tube = light_of("tube", 0);
    const double flux = flux_of(&window), tube_flux = flux_of(&tube);
    for (gsize i = 0; i + 1 < G_N_ELEMENTS(names); i++) {
        change_over(&window, names[i], names[i + 1]);
        assert_true(fabs(flux_of(&window) / flux - 1) < 1e-10);
        assert_false(has(&window, names[i] + strlen("lights[].")));
        assert_true(has(&window, names[i + 1] + strlen("lights[].")));
    }
    assert_key(window.document, "lights[0].radiance", "300");
    change_over(&tube, "lights[].power", "lights[].radiance");
    assert_true(fabs(flux_of(&tube) / tube_flux - 1) < 1e-10);
    change_over(&tube, "lights[].radiance", "lights[].power");
    assert_key(tube.document, "lights[0].power", "3300");
    clear_light(&window);
    clear_light(&tube);
}

static void direction_of(const Light *light, double direction[3])
{
    AppMoment *moment = moment_of(light->document);
    assert_true(luxel_scene_light_direction(moment->scene, light->keys.index, direction));
    app_moment_unref(moment);
}

static void changes_aims_and_shapes(void **state)
{
    (void)state;
    Light spot = light_of("spot", 0), window = light_of("window", 0), tube = light_of("tube", 0);
    double directions[4][3];
    direction_of(&spot, directions[0]);
    direction_of(&window, directions[1]);
    change_over(&spot, "lights[].aim", "lights[].axis");
    assert_true(has(&spot, "axis") && !has(&spot, "aim"));
    assert_false(shows(&spot, "lights[].aim"));
    change_over(&spot, "lights[].axis", "lights[].aim");
    assert_true(has(&spot, "aim") && !has(&spot, "axis"));
    assert_false(shows(&spot, "lights[].axis"));
    change_over(&window, "lights[].rectangle.aim", "lights[].rectangle.axis");
    change_over(&window, "lights[].rectangle.axis", "lights[].rectangle.aim");
    direction_of(&spot, directions[2]);
    direction_of(&window, directions[3]);
    for (int k = 0; k < 3; k++) { /* they shine where they did */
        assert_true(fabs(directions[2][k] - directions[0][k]) < 1e-6);
        assert_true(fabs(directions[3][k] - directions[1][k]) < 1e-6);
    }
    static const char *const shapes[] = {"rectangle", "disk", "vertices", "disk", "rectangle", "vertices", "rectangle"};
    static const char *const bodies[] = {"cylinder", "box", "sphere", "box", "cylinder", "sphere", "cylinder"};
    for (int i = 0; i < 12; i++) {
        Light *light = i < 6 ? &window : &tube;
        const char *const *names = (i < 6 ? shapes : bodies) + i % 6;
        char *from = g_strconcat("lights[].", names[0], NULL), *to = g_strconcat("lights[].", names[1], NULL);
        double before[3], after[3];
        AppMoment *moment = moment_of(light->document);
        luxel_scene_light_place(moment->scene, 0, before);
        app_moment_unref(moment);
        change_over(light, from, to);
        moment = moment_of(light->document);
        assert_true(luxel_scene_light_place(moment->scene, 0, after));
        for (int k = 0; k < 3; k++)
            assert_true(fabs(after[k] - before[k]) < 1e-6);
        app_moment_unref(moment);
        assert_true(has(light, names[1]) && !has(light, names[0]));
        g_free(from);
        g_free(to);
    }
    clear_light(&spot);
    clear_light(&window);
    clear_light(&tube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shows_what_has_a_say),
        cmocka_unit_test(shows_the_scale_of_a_mesh),
        cmocka_unit_test(knows_paths),
        cmocka_unit_test(adds_what_is_needed),
        cmocka_unit_test(changes_types),
        cmocka_unit_test(keeps_the_place_and_back),
        cmocka_unit_test(keeps_pixels_square),
        cmocka_unit_test(sets_one_number_of_several),
        cmocka_unit_test(gives_and_takes_an_array),
        cmocka_unit_test(names_what_can_be_instead),
        cmocka_unit_test(keeps_the_flux),
        cmocka_unit_test(changes_aims_and_shapes),
    };
    return cmocka_run_group_tests(tests, make_parameters, free_parameters);
}

/* SPDX-License-Identifier: MIT */
/* Files that come into a scene: what they are, how they are named, and that a mesh is seen where it is put. */
#include "../../app/form/new_surface.h"

#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include <luxel/evaluator.h>

#include "scenes.h"

static char *folder;

/* A tetrahedron of this size with a corner at the origin, in a file of the test's folder; the caller's. */
static char *write_tetrahedron(double size)
{
    char *path = g_build_filename(folder, "a.obj", NULL);
    char *text = g_strdup_printf("v 0 0 0\nv %g 0 0\nv 0 %g 0\nv 0 0 %g\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", size,
                                 size, size);
    assert_true(g_file_set_contents(path, text, -1, NULL));
    g_free(text);
    return path;
}

static void test_kinds(void **state)
{
    (void)state;
    assert_int_equal(app_file_kind("/a/b.OBJ"), APP_FILE_MESH);
    assert_int_equal(app_file_kind("b.glb"), APP_FILE_MESH);
    assert_int_equal(app_file_kind("lamp.IES"), APP_FILE_LUMINAIRE);
    assert_int_equal(app_file_kind("lamp.ldt"), APP_FILE_LUMINAIRE);
    assert_int_equal(app_file_kind("obj"), APP_FILE_OTHER);
    assert_int_equal(app_file_kind("scene.yaml"), APP_FILE_OTHER);
}

/* From the scene's folder where the file lies in it, else whole. */
static void test_names(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    char *scene = g_build_filename(folder, "scene.yaml", NULL), *beside = g_build_filename(folder, "m", "a.obj", NULL);
    char *name = app_file_in_scene(document, beside);
    assert_string_equal(name, beside);
    g_free(name);
    assert_true(app_document_save(document, scene, NULL));
    name = app_file_in_scene(document, beside);
    assert_string_equal(name, "m/a.obj");
    g_free(name);
    name = app_file_in_scene(document, "/elsewhere/a.obj");
    assert_string_equal(name, "/elsewhere/a.obj");
    g_free(name);
    g_remove(scene);
    g_free(beside);
    g_free(scene);
    g_object_unref(document);
}

/* Tiny, right and huge ones: each is made to suit, in the middle of the screen, and the scene can be computed. */
static void test_meshes(void **state)
{
    static const double sizes[] = {0.02, 200, 40000};
    (void)state;
    for (gsize i = 0; i < G_N_ELEMENTS(sizes); i++) {
        AppDocument *document = document_of_builtin("report");
        char *path = write_tetrahedron(sizes[i]), *yaml = app_new_mesh(document, path, NULL);
        const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "surfaces", .value = yaml, .index = 1};
        luxel_mesh_survey survey;
        bool is_mesh;
        double center[3], screen[2];
        assert_non_null(yaml);
        assert_true(app_document_edit(document, &edit, 1, NULL, NULL));
        AppMoment *moment = moment_of(document);
        assert_int_equal(luxel_scene_surface_mesh(moment->scene, 1, &is_mesh, &survey), LUXEL_OK);
        assert_true(is_mesh && survey.size_mm[0] > 100 && survey.size_mm[0] < 300);
        assert_true(i != 1 || fabs(survey.size_mm[0] - 200) < 1e-9); /* as it is */
        assert_int_equal(luxel_scene_surface_place(moment->scene, 1, center), LUXEL_OK);
        assert_true(luxel_scene_project(moment->scene, center, screen));
        assert_true(hypot(screen[0], screen[1]) < 1);
        app_moment_unref(moment);
        g_remove(path);
        g_free(path);
        g_free(yaml);
        g_object_unref(document);
    }
}

static void test_no_mesh(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    luxel_diagnostics *faults = luxel_diagnostics_new();
    assert_null(app_new_mesh(document, "/no/such.obj", faults));
    assert_true(luxel_diagnostics_count(faults) > 0);
    luxel_diagnostics_free(faults);
    g_object_unref(document);
}

/* Which share of the screen shows a surface of a document that must have no faults. */
static double seen(const AppDocument *document, gsize surface)
{
    enum { PLACES = 40 };
    AppMoment *moment = moment_of(document);
    luxel_evaluator *evaluator;
    gsize count = 0;
    const double width = app_document_get_number(document, "screen.width");
    const double height = app_document_get_number(document, "screen.height");
    assert_int_equal(luxel_evaluator_new(moment->scene, NULL, NULL, &evaluator), LUXEL_OK);
    for (int i = 0; i < PLACES * PLACES; i++) {
        const double x = ((i % PLACES + 0.5) / PLACES - 0.5) * width;
        const double y = ((double)(i / PLACES) + 0.5) / PLACES - 0.5;
        luxel_value value;
        luxel_evaluate_screen(evaluator, x, y * height, &value, NULL);
        count += value.on_surface && value.surface == surface;
    }
    luxel_evaluator_free(evaluator);
    app_moment_unref(moment);
    return (double)count / (PLACES * PLACES);
}

static void insert(AppDocument *document, char *yaml)
{
    const gsize count = app_document_size(document, "surfaces");
    const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "surfaces", .value = yaml, .index = count};
    assert_non_null(yaml);
    assert_true(app_document_edit(document, &edit, 1, NULL, NULL));
    g_free(yaml);
}

/* Each kind that has an example is seen in each of these scenes, and what was there before, too. */
static void test_of_kinds(void **state)
{
    static const char *const scenes[] = {"report", "three-lights", "two-spheres", "desk", "tin"};
    luxel_parameters *parameters = luxel_parameters_new();
    gsize tried = 0;
    (void)state;
    for (gsize i = 0; i < luxel_parameters_kind_count(parameters); i++) {
        const luxel_parameter_kind *kind = luxel_parameters_kind(parameters, i);
        for (gsize k = 0; k < G_N_ELEMENTS(scenes) && strcmp(kind->list, "surfaces") == 0 && kind->example; k++) {
            AppDocument *document = document_of_builtin(scenes[k]);
            const gsize count = app_document_size(document, "surfaces");
            insert(document, app_new_surface(document, parameters, kind->name));
            if (seen(document, count) < 0.01 || seen(document, 0) < 0.01)
                fail_msg("%s in %s: %.3f of the screen, the first surface %.3f", kind->name, scenes[k],
                         seen(document, count), seen(document, 0));
            assert_true(app_document_undo(document));
            assert_int_equal(app_document_size(document, "surfaces"), count);
            g_object_unref(document);
            tried++;
        }
    }
    assert_true(tried >= 5 * G_N_ELEMENTS(scenes));
    AppDocument *document = document_of_builtin("report");
    assert_null(app_new_surface(document, parameters, "mesh"));
    assert_null(app_new_surface(document, parameters, "point"));
    g_object_unref(document);
    luxel_parameters_free(parameters);
}

static void test_doubles(void **state)
{
    static const char *const scenes[] = {"three-lights", "two-spheres", "desk", "tin", "pot"};
    (void)state;
    for (gsize k = 0; k < G_N_ELEMENTS(scenes); k++) {
        AppDocument *document = document_of_builtin(scenes[k]);
        const gsize count = app_document_size(document, "surfaces");
        insert(document, app_doubled_surface(document, count - 1));
        if (seen(document, count) < 0.005)
            fail_msg("the double in %s: %.3f of the screen", scenes[k], seen(document, count));
        g_object_unref(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_kinds),   cmocka_unit_test(test_names),
                                       cmocka_unit_test(test_meshes),  cmocka_unit_test(test_of_kinds),
                                       cmocka_unit_test(test_doubles), cmocka_unit_test(test_no_mesh)};
    folder = g_dir_make_tmp("luxel-XXXXXX", NULL);
    assert_non_null(folder);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    g_rmdir(folder);
    g_free(folder);
    return failed;
}

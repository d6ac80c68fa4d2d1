/* SPDX-License-Identifier: MIT */
/* Scenes that name files: these are read when the scene is committed, and copies share what was read. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scenes.h"

static const char tetrahedron[] = "OFF\n4 4 6\n0 0 1500\n90 0 1500\n0 90 1500\n0 0 1590\n"
                                  "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

/* A folder with a mesh and a scene that names it. */
struct folder {
    char path[40], mesh[64], scene[64];
};

static void put(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static int make_folder(void **state)
{
    struct folder *folder = calloc(1, sizeof *folder);
    assert_non_null(folder);
    strcpy(folder->path, "/tmp/luxel-named-XXXXXX");
    assert_non_null(mkdtemp(folder->path));
    snprintf(folder->mesh, sizeof folder->mesh, "%s/lamp.off", folder->path);
    snprintf(folder->scene, sizeof folder->scene, "%s/scene.yaml", folder->path);
    char *scene = changed("{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}",
                          "{type: volume, mesh: lamp.off, power: 5}");
    put(folder->mesh, tetrahedron);
    put(folder->scene, scene);
    free(scene);
    *state = folder;
    return 0;
}

static int remove_folder(void **state)
{
    struct folder *folder = *state;
    unlink(folder->mesh);
    unlink(folder->scene);
    rmdir(folder->path);
    free(folder);
    return 0;
}

static double value_at_centre(const luxel_scene *scene)
{
    luxel_probe *probe;
    luxel_settings settings;
    luxel_settings_init(&settings);
    assert_int_equal(luxel_probe_screen(scene, &settings, 0, 0, NULL, &probe), LUXEL_OK);
    double value = probe->value;
    luxel_probe_free(probe);
    return value;
}

static void copies_share(void **state)
{
    const struct folder *folder = *state;
    luxel_scene *scene;
    assert_int_equal(luxel_scene_read_file(folder->scene, NULL, &scene), LUXEL_OK);
    luxel_scene *raw = luxel_scene_copy(scene);
    assert_non_null(raw);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    double value = value_at_centre(scene);
    unlink(folder->mesh);
    luxel_scene *copy = luxel_scene_copy(scene);
    assert_non_null(copy);
    luxel_scene_free(scene);
    assert_true(luxel_scene_is_committed(copy));
    assert_true(value > 0 && value_at_centre(copy) == value);
    luxel_scene *second = luxel_scene_copy(copy);
    assert_non_null(second);
    assert_int_equal(luxel_scene_commit(copy, NULL), LUXEL_ERROR_FILE); /* which looks again */
    luxel_scene_free(copy);
    assert_true(value_at_centre(second) == value);
    luxel_scene_free(second);
    assert_int_equal(luxel_scene_commit(raw, NULL), LUXEL_ERROR_FILE);
    put(folder->mesh, tetrahedron);
    assert_int_equal(luxel_scene_commit(raw, NULL), LUXEL_OK); /* found from the folder of the first */
    luxel_scene_free(raw);
}

static void commits_read_again(void **state)
{
    const struct folder *folder = *state;
    luxel_scene *scene;
    assert_int_equal(luxel_scene_read_file(folder->scene, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    double value = value_at_centre(scene);
    char *higher = strdup(tetrahedron);
    memcpy(strstr(higher, "1590"), "1690", 4);
    put(folder->mesh, higher);
    free(higher);
    assert_true(value_at_centre(scene) == value);
    assert_int_equal(luxel_scene_set(scene, "lights[0].name=lamp", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_true(value_at_centre(scene) != value);
    luxel_scene_free(scene);
}

static void reports_at_the_key(void **state)
{
    const struct folder *folder = *state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene;
    unlink(folder->mesh);
    assert_int_equal(luxel_scene_read_file(folder->scene, diagnostics, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, diagnostics), LUXEL_ERROR_FILE);
    expect_entry(diagnostics, 0, WANTED("file-not-read", 11, 26, .key = "lights[0].mesh", .message = folder->mesh));
    luxel_diagnostics_clear(diagnostics);
    put(folder->mesh, "OFF\n4 4 6\n0 0 far\n");
    assert_int_equal(luxel_scene_commit(scene, diagnostics), LUXEL_ERROR_SCENE);
    expect_entry(diagnostics, 0, WANTED("mesh-line", 11, 26, .key = "lights[0].mesh", .message = "line 3"));
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* A cloud beside the mesh, which copies share as they share that. */
static void clouds_too(void **state)
{
    const struct folder *folder = *state;
    char path[80];
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    snprintf(path, sizeof path, "%s/lamps.csv", folder->path);
    put(path, "x,y,z,intensity\n0,0,2000,3\n5,5,1900,2\n");
    assert_int_equal(luxel_scene_read_file(folder->scene, NULL, &scene), LUXEL_OK);
    static const char lights[] = "lights=[{type: points, file: lamps.csv}, {type: volume, mesh: lamp.off, power: 5}, "
                                 "{type: points, file: lamps.csv, pattern: lambertian, aim: [5, 5, 1900.5]}]";
    assert_int_equal(luxel_scene_set(scene, lights, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    double value = value_at_centre(scene);
    unlink(path);
    luxel_scene *copy = luxel_scene_copy(scene);
    assert_non_null(copy);
    assert_true(luxel_scene_is_committed(copy));
    luxel_scene_free(scene);
    assert_true(value > 0 && value_at_centre(copy) == value);
    put(path, "1,2,3,-4\n");
    assert_int_equal(luxel_scene_commit(copy, diagnostics), LUXEL_ERROR_SCENE); /* which looks again */
    expect_entry(diagnostics, 0, WANTED("cloud-line", .key = "lights[0].file", .message = "line 1"));
    luxel_diagnostics_clear(diagnostics);
    put(path, "5,5,1900.5,4\n");
    assert_int_equal(luxel_scene_commit(copy, diagnostics), LUXEL_ERROR_SCENE);
    expect_entry(diagnostics, 0, WANTED("same-place", .key = "lights[2].aim", .message = "number 1 of"));
    luxel_diagnostics_clear(diagnostics);
    put(path, tetrahedron);
    assert_int_equal(luxel_scene_commit(copy, diagnostics), LUXEL_ERROR_SCENE);
    assert_int_equal(luxel_scene_set(copy, "lights=[{type: points, file: lamp.off}]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(copy, diagnostics), LUXEL_ERROR_SCENE); /* a mesh is no cloud */
    luxel_scene_free(copy);
    luxel_diagnostics_free(diagnostics);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(copies_share, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(commits_read_again, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(reports_at_the_key, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(clouds_too, make_folder, remove_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

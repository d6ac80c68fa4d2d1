/* SPDX-License-Identifier: MIT */
/* Where places are seen on the screen, against the places that probes find there; where surfaces stand. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

/* Every place that a probe finds through a screen point is seen at it, and found again through it. */
static void as_probed(const luxel_scene *scene)
{
    size_t seen = 0;
    for (double y = -350; y <= 350; y += 70)
        for (double x = -350; x <= 350; x += 70) {
            const double point[2] = {x, y};
            double screen[2], place[3];
            luxel_probe *probe = NULL;
            assert_int_equal(luxel_probe_screen(scene, NULL, x, y, NULL, &probe), LUXEL_OK);
            if (probe->on_surface) {
                seen++;
                assert_true(luxel_scene_project(scene, probe->position_mm, screen));
                assert_true(fabs(screen[0] - x) < 1e-11 && fabs(screen[1] - y) < 1e-11);
                double height;
                assert_true(luxel_scene_height(scene, probe->position_mm, &height));
                assert_true(luxel_scene_unproject(scene, point, height, place));
                for (int i = 0; i < 3; i++)
                    assert_true(fabs(place[i] - probe->position_mm[i]) < 1e-11);
            }
            luxel_probe_free(probe);
        }
    assert_true(seen > 20);
}

static luxel_scene *seen_in(const char *projection)
{
    luxel_scene *scene;
    char *text = changed("orthographic", projection);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_text_free(text);
    return scene;
}

static void orthographic(void **state)
{
    (void)state;
    luxel_scene *scene = seen_in("orthographic");
    double screen[2], place[3];
    as_probed(scene);
    /* also from above the observer, at 1500 */
    assert_true(luxel_scene_project(scene, (double[]){3, -4, 2000}, screen));
    assert_true(screen[0] == 3 && screen[1] == -4);
    assert_true(luxel_scene_unproject(scene, screen, 2000, place));
    assert_true(place[0] == 3 && place[1] == -4 && place[2] == 2000);
    luxel_scene_free(scene);
}

static void perspective(void **state)
{
    (void)state;
    luxel_scene *scene = seen_in("perspective");
    double screen[2] = {7, 7}, place[3] = {7, 7, 7};
    as_probed(scene);
    assert_true(luxel_scene_project(scene, (double[]){100, -50, 1000}, screen));
    assert_true(fabs(screen[0] - 300) < 1e-12 && fabs(screen[1] + 150) < 1e-12);
    assert_true(luxel_scene_project(scene, (double[]){100, -50, 0}, screen));
    assert_true(screen[0] == 100 && screen[1] == -50);
    /* behind the screen, too */
    assert_true(luxel_scene_unproject(scene, screen, -1500, place));
    assert_true(place[0] == 200 && place[1] == -100 && place[2] == -1500);

    assert_false(luxel_scene_project(scene, (double[]){1, 1, 1500}, screen));
    assert_false(luxel_scene_project(scene, (double[]){1, 1, 1501}, screen));
    assert_false(luxel_scene_unproject(scene, screen, 1500, place));
    assert_true(screen[0] == 100 && place[0] == 200);
    luxel_scene_free(scene);
}

/* Seen from the side, and once more from anywhere. */
static void placed(void **state)
{
    static const char *const observers[] = {
        "{position: [1500, 0, 1000], target: [0, 0, 1000], projection: orthographic, view: parallel}",
        "{position: [1200, -900, 1800], target: [10, 20, 950], up: [1, 1, 3], projection: perspective}"};
    (void)state;
    for (int i = 0; i < 2; i++) {
        luxel_scene *scene;
        double screen[2], height, place[3] = {7, 7, 7};
        char *text = changed("{z: 1500, projection: orthographic, view: parallel}", observers[i]);
        assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
        luxel_text_free(text);
        as_probed(scene);
        if (i == 0) { /* x to the screen's depth, z to the left */
            assert_true(luxel_scene_project(scene, (double[]){300, 20, 990}, screen));
            assert_true(screen[0] == 10 && screen[1] == 20);
            assert_true(luxel_scene_height(scene, (double[]){300, 20, 990}, &height) && height == 300);
            assert_true(luxel_scene_unproject(scene, screen, 300, place));
            assert_true(place[0] == 300 && place[1] == 20 && place[2] == 990);
        } else {
            assert_false(luxel_scene_project(scene, (double[]){1300, -1000, 1950}, screen));
        }
        assert_false(luxel_scene_height(scene, (double[]){(double)NAN, 0, 0}, &height));
        assert_false(luxel_scene_height(NULL, (double[]){0, 0, 0}, &height));
        luxel_scene_free(scene);
    }
}

static void refusals(void **state)
{
    (void)state;
    luxel_scene *scene = seen_in("orthographic");
    const double nowhere[3] = {0, HUGE_VAL, 0}, high[3] = {0, 0, (double)NAN}, here[3] = {0, 0, 0};
    double screen[2], place[3];
    assert_false(luxel_scene_project(scene, nowhere, screen));
    assert_false(luxel_scene_project(scene, high, screen));
    assert_false(luxel_scene_unproject(scene, nowhere, 0, place));
    assert_false(luxel_scene_unproject(scene, here, HUGE_VAL, place));
    assert_false(luxel_scene_project(scene, NULL, screen));
    assert_false(luxel_scene_project(scene, here, NULL));
    assert_false(luxel_scene_unproject(scene, NULL, 0, place));
    assert_false(luxel_scene_unproject(scene, here, 0, NULL));
    assert_false(luxel_scene_project(NULL, here, screen));
    assert_int_equal(luxel_scene_set(scene, "observer.z=2000", NULL), LUXEL_OK);
    assert_false(luxel_scene_project(scene, here, screen));
    assert_false(luxel_scene_unproject(scene, here, 0, place));
    luxel_scene_free(scene);
}

static void surfaces(void **state)
{
    (void)state;
    char *text = changed("surfaces:\n", "surfaces:\n  - {type: rectangle, center: [1, -2, 3.5], size: [7, 9]}\n");
    luxel_scene *scene;
    double place[3];
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_surface_count(scene), 2);
    assert_int_equal(luxel_scene_surface_place(scene, 0, place), LUXEL_OK);
    assert_true(place[0] == 1 && place[1] == -2 && place[2] == 3.5);
    assert_int_equal(luxel_scene_surface_place(scene, 1, place), LUXEL_OK);
    assert_true(place[0] == 0 && place[1] == 0 && place[2] == 1000);
    assert_int_equal(luxel_scene_surface_place(scene, 2, place), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_surface_place(scene, 0, NULL), LUXEL_ERROR_ARGUMENT);
    double radius;
    assert_int_equal(luxel_scene_surface_radius(scene, 0, &radius), LUXEL_OK);
    assert_true(fabs(radius - hypot(7, 9) / 2) < 1e-9);
    assert_int_equal(luxel_scene_surface_radius(scene, 2, &radius), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_surface_radius(scene, 0, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_set(scene, "observer.z=2000", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_surface_count(scene), 0);
    assert_int_equal(luxel_scene_surface_place(scene, 0, place), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_surface_count(NULL), 0);
    luxel_scene_free(scene);
    luxel_text_free(text);
}

/* What is taken over from another scene: whole, or told why not; a scene without files stays as it is. */
static void files_of_another(void **state)
{
    (void)state;
    char *text = changed("surfaces:\n", "surfaces:\n");
    luxel_scene *before, *scene;
    assert_int_equal(load(text, NULL, &before), LUXEL_OK);
    assert_int_equal(luxel_scene_read_text(text, strlen(text), NULL, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_keep_files(scene, before), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_keep_files(scene, scene), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_keep_files(NULL, before), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_keep_files(scene, NULL), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(before);
    luxel_scene_free(scene);
    luxel_text_free(text);
}

static bool stop_at_once(double done, void *data)
{
    (void)done;
    ++*(size_t *)data;
    return false;
}

/* What a picture shows, each array for itself and together; cancelled, and refused. */
static void geometry(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_open_builtin("two-spheres", NULL, &scene), LUXEL_OK);
    const luxel_geometry nothing = {.depth_mm = NULL};
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, &nothing), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    unsigned columns, rows;
    luxel_scene_resolution(scene, &columns, &rows);
    const size_t count = (size_t)columns * rows;
    luxel_field *field = NULL;
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    luxel_geometry all = {.depth_mm = calloc(count, sizeof(double)),
                          .normals = calloc(count, sizeof(double[3])),
                          .positions_mm = calloc(count, sizeof(double[3])),
                          .surfaces = calloc(count, sizeof(int32_t)),
                          .parts = calloc(count, sizeof(unsigned))};
    double *depth = calloc(count, sizeof *depth);
    assert_true(all.depth_mm && all.normals && all.positions_mm && all.surfaces && all.parts && depth);
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, &all), LUXEL_OK);
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, &(luxel_geometry){.depth_mm = depth}), LUXEL_OK);
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, &nothing), LUXEL_OK);
    assert_memory_equal(depth, all.depth_mm, count * sizeof *depth);
    for (size_t i = 0; i < count; i++) {
        double screen[2], height;
        assert_int_equal(all.surfaces[i] >= 0, luxel_field_mask(field)[i]);
        if (all.surfaces[i] < 0)
            continue;
        assert_true(luxel_scene_project(scene, all.positions_mm[i], screen) &&
                    luxel_scene_height(scene, all.positions_mm[i], &height));
        assert_true(fabs(screen[0] - luxel_field_x_mm(field)[i % columns]) < 1e-10 &&
                    fabs(screen[1] - luxel_field_y_mm(field)[i / columns]) < 1e-10 && all.parts[i] == 0);
    }
    luxel_settings settings;
    size_t asked = 0;
    luxel_settings_init(&settings);
    settings.progress = stop_at_once;
    settings.progress_data = &asked;
    assert_int_equal(luxel_find_geometry(scene, &settings, NULL, &all), LUXEL_CANCELLED);
    assert_true(asked > 0);
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, NULL), LUXEL_ERROR_ARGUMENT);
    all.reserved[1] = &all;
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, &all), LUXEL_ERROR_ARGUMENT);
    free(all.depth_mm), free(all.normals), free(all.positions_mm), free(all.surfaces), free(all.parts), free(depth);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orthographic), cmocka_unit_test(perspective), cmocka_unit_test(placed),
        cmocka_unit_test(refusals),     cmocka_unit_test(surfaces),    cmocka_unit_test(files_of_another),
        cmocka_unit_test(geometry),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

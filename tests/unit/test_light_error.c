/* SPDX-License-Identifier: MIT */
/*
 * Clusters of points against the full sum: in random and nasty scenes, every instruction set and either precision, no
 * pixel is off by more than the allowed share of its value, or of a thousandth of the picture's maximum.
 */
#include <malloc.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "campaign.h"
#include "format/cloud.h"
#include "picture/cluster/cut.h"
#include "picture/plan_make.h"
#include "picture/shader.h"
#include "random_scenes.h"
#include "scenes.h"
#include "world/camera.h"
#include "world/reference.h"

enum { MOST_GROUPS = 3, MOST_IN_GROUP = 600, MOST_POINTS = MOST_GROUPS * MOST_IN_GROUP + MAXIMUM_LIGHTS };

struct picture {
    double values[ROWS][COLUMNS];
    double maximum;
};

/* Many points of one kind about a place: in a ball, a disk or a line, large or small, turned alike or not. */
static void add_group(struct randomness *random, const struct lx_shape *shape, struct lx_emitters *emitters)
{
    struct lx_emitter model = random_emitter(random, shape);
    const size_t count = LX_LEAST_CLUSTERED + (size_t)pick(random, MOST_IN_GROUP - LX_LEAST_CLUSTERED);
    const double spread = logarithmic(random, 0.1, 2000), turn = pick(random, 3) ? 0 : uniform(random, 0, 2);
    const int dimensions = 1 + pick(random, 3);
    model.type = LX_POINT;
    model.is_part = pick(random, 3) == 0;
    for (size_t i = 0; i < count; i++) {
        struct lx_emitter *point = &emitters->items[emitters->count++];
        double off[3];
        *point = model;
        random_direction(random, off);
        for (int k = 0; k < dimensions; k++)
            point->position_mm[k] += spread * off[k];
        point->strength = pick(random, 20) ? logarithmic(random, 0.01, 10) : 0;
        random_direction(random, off);
        for (int k = 0; k < 3; k++)
            off[k] *= turn * uniform(random, 0, 1);
        if (model.profile.falloff != LX_NO_CONE || model.profile.exponent > 0)
            point->profile.axis = lx_unit3(lx_add3(model.profile.axis, lx_exact3(off)));
    }
}

/* Scene i with its lights and groups of points besides. */
static void make_scene(int i, struct test_scene *test, struct lx_emitter room[MOST_POINTS])
{
    struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 7)};
    make_random_scene(&random, true, test);
    struct lx_emitters *emitters = &test->prepared.emitters;
    memcpy(room, emitters->items, emitters->count * sizeof *room);
    emitters->items = room;
    for (int groups = 1 + pick(&random, MOST_GROUPS); groups > 0; groups--)
        add_group(&random, &test->surfaces[0].shape, emitters);
}

static void make_picture(const struct test_scene *test, const struct lx_kernels *kernels,
                         const luxel_settings *settings, struct picture *picture)
{
    struct lx_plan plan;
    double x[LX_BLOCK], y[LX_TILE_ROWS], values[LX_BLOCK];
    uint8_t mask[LX_BLOCK];
    assert_int_equal(lx_plan_make(&test->prepared, kernels, settings, &plan), LUXEL_OK);
    struct lx_shader_memory *memory = lx_shader_memory_new(&plan);
    assert_non_null(memory);
    picture->maximum = 0;
    const unsigned width = lx_tile_columns(&plan, COLUMNS);
    for (unsigned top = 0; top < ROWS; top += LX_TILE_ROWS)
        for (unsigned first = 0; first < COLUMNS; first += width) {
            const unsigned rows = ROWS - top < LX_TILE_ROWS ? ROWS - top : LX_TILE_ROWS;
            const unsigned columns = COLUMNS - first < width ? COLUMNS - first : width;
            for (unsigned i = 0; i < columns; i++)
                x[i] = lx_column_x_mm(&test->scene.screen, first + i);
            for (unsigned j = 0; j < rows; j++)
                y[j] = lx_row_y_mm(&test->scene.screen, top + j);
            lx_shader_enter(&plan, memory, y, rows, x, columns);
            for (unsigned j = 0; j < rows; j++) {
                lx_shade_row(&plan, memory, j, NULL, false, values, mask);
                memcpy(&picture->values[top + j][first], values, columns * sizeof *values);
                for (unsigned i = 0; i < columns; i++)
                    picture->maximum = fmax(picture->maximum, values[i]);
            }
        }
    assert_true(plan.least_maximum <= picture->maximum * (1 + 0.2));
    lx_shader_memory_free(memory);
    lx_plan_clear(&plan);
}

/* The bound of the float64 reference of a pixel; in the tails of highlights and patterns it exceeds the value. */
static double doubt_of(const struct test_scene *test, unsigned row, unsigned column)
{
    struct lx_element element;
    double doubt = 0;
    if (!lx_element_seen(&test->prepared, lx_column_x_mm(&test->scene.screen, column),
                         lx_row_y_mm(&test->scene.screen, row), &element))
        return 0;
    for (size_t i = 0; i < test->prepared.emitters.count; i++) {
        const struct lx_lighting light = lx_light_element(&test->prepared, &element, &test->prepared.emitters.items[i]);
        doubt += light.diffuse.error + light.specular.error;
    }
    return doubt;
}

/* The largest error of a pixel as a share of what is allowed; `*changed`: whether any differs at all. */
static double worst_share(const struct test_scene *test, const struct picture *picture, const struct picture *full,
                          double light_error, double rounding, bool *changed)
{
    double worst = 0;
    for (unsigned row = 0; row < ROWS; row++)
        for (unsigned column = 0; column < COLUMNS; column++) {
            double value = picture->values[row][column], truth = full->values[row][column];
            double off = fabs(value - truth) - rounding * full->maximum;
            double allowed = light_error * fmax(truth, full->maximum / 1000);
            assert_true(isfinite(value) && value >= 0);
            if (off > allowed)
                off -= 2 * doubt_of(test, row, column); /* of both pictures */
            worst = fmax(worst, allowed > 0 ? off / allowed : off > 0 ? HUGE_VAL : 0);
            *changed = *changed || off > 0;
        }
    return worst;
}

static void check_errors(luxel_precision precision, double rounding)
{
    static struct lx_emitter room[MOST_POINTS];
    static struct picture full, picture;
    const int scenes = scenes_to_try(60);
    double worst = 0;
    int changed_scenes = 0;
    for (int i = 0; i < scenes; i++) {
        struct test_scene test;
        luxel_settings settings = {.precision = LUXEL_DOUBLE};
        make_scene(i, &test, room);
        make_picture(&test, lx_kernels_choose(NULL), &settings, &full);
        settings.precision = precision;
        settings.light_error = pow(10, -1 - i % 4);
        bool changed = false;
        for (size_t k = 0; lx_kernels_get(k); k++) {
            if (!lx_kernels_get(k)->runs())
                continue;
            make_picture(&test, lx_kernels_get(k), &settings, &picture);
            double share = worst_share(&test, &picture, &full, settings.light_error, rounding, &changed);
            if (share > 1)
                print_message("# scene %d, %s: %.3g times the allowed error\n", i, lx_kernels_get(k)->name, share);
            worst = fmax(worst, share);
        }
        changed_scenes += changed;
    }
    print_message("# worst pixel: %.3g times the allowed error; %d of %d scenes changed\n", worst, changed_scenes,
                  scenes);
    assert_true(worst <= 1);
    assert_true(changed_scenes > scenes / 2); /* else nothing was clustered */
}

static void test_double(void **state)
{
    (void)state;
    check_errors(LUXEL_DOUBLE, 1e-11);
}

static void test_single(void **state)
{
    (void)state;
    check_errors(LUXEL_SINGLE, 2e-6);
}

/* Few points of a kind are all summed, and without an error allowed all of any number. */
static void test_few(void **state)
{
    (void)state;
    static struct lx_emitter room[MOST_POINTS];
    static struct picture full, picture;
    struct test_scene test;
    luxel_settings settings = {.light_error = 0.1};
    make_scene(0, &test, room);
    test.prepared.emitters.count = LX_LEAST_CLUSTERED - 1;
    make_picture(&test, lx_kernels_choose(NULL), &settings, &picture);
    settings.light_error = 0;
    make_picture(&test, lx_kernels_choose(NULL), &settings, &full);
    assert_memory_equal(&picture, &full, sizeof full);
}

/* The plan of a large cloud takes little room beside it. */
static void test_room(void **state)
{
    (void)state;
    enum { POINTS = 200000, MOST_BYTES = 64 };
    static double rows[POINTS][LX_CLOUD_COLUMNS];
    struct randomness random = {.state = 5};
    for (int i = 0; i < POINTS; i++) {
        for (int k = 0; k < 3; k++)
            rows[i][k] = uniform(&random, -500, 500) + (k == 2 ? 4000 : 0);
        rows[i][3] = 1;
    }
    struct lx_cloud cloud = {.count = POINTS, .values = rows};
    struct test_scene test;
    make_random_scene(&random, false, &test);
    const struct lx_point_set set = {
        .cloud = &cloud, .model = {.type = LX_POINT, .profile = lx_profile_isotropic()}, .aim_mm = {0}};
    test.prepared.emitters = (struct lx_emitters){0};
    assert_int_equal(lx_emitters_append_point_set(&test.prepared.emitters, &set), 0);
    for (int error = 0; error < 2; error++) {
        const luxel_settings settings = {.light_error = error ? 0.01 : 0};
        const struct mallinfo2 before = mallinfo2();
        struct lx_plan plan;
        assert_int_equal(lx_plan_make(&test.prepared, lx_kernels_choose(NULL), &settings, &plan), LUXEL_OK);
        const struct mallinfo2 after = mallinfo2();
        double bytes = (double)(after.uordblks + after.hblkhd) - (double)(before.uordblks + before.hblkhd);
        print_message("# %.1f bytes a source\n", bytes / POINTS);
        assert_true(bytes <= (error ? MOST_BYTES : 1) * (double)POINTS);
        lx_plan_clear(&plan);
    }
    lx_emitters_clear(&test.prepared.emitters);
}

/* A small picture of a scene of one planar source in many parts, with an error allowed and without. */
static void compare_small(const char *text, double light_error)
{
    luxel_scene *scene;
    luxel_settings settings;
    luxel_field *full = NULL, *taken = NULL;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_settings_init(&settings);
    settings.precision = LUXEL_DOUBLE;
    assert_int_equal(luxel_render(scene, &settings, NULL, &full), LUXEL_OK);
    settings.light_error = light_error;
    assert_int_equal(luxel_render(scene, &settings, NULL, &taken), LUXEL_OK);
    assert_true(luxel_field_statistics(full)->maximum.value > 0);
    for (unsigned column = 0; column < luxel_field_columns(full); column++) {
        const double sum = luxel_field_value(full, column, 0), value = luxel_field_value(taken, column, 0);
        if (!(fabs(value - sum) <= light_error * sum))
            fail_msg("column %u: %.17g, summed %.17g", column, value, sum);
    }
    luxel_field_free(full);
    luxel_field_free(taken);
    luxel_scene_free(scene);
}

/* Two elements that face opposite ways share a tile: their normals have no middle. */
static void test_opposite(void **state)
{
    (void)state;
    compare_small("luxel: 1\n"
                  "screen: {width: 763.5, height: 381.75, resolution: [2, 1], sampling: nodes}\n"
                  "observer: {z: 600}\n"
                  "surfaces: [{type: sphere, center: [0, 0, 0], radius: 381.75, material: {model: lambert}}]\n"
                  "lights: [{type: planar, rectangle: {center: [1000, 0, 2], size: [1, 1], up: [0, 1, 0], "
                  "axis: [0, 0, -1]}, radiance: 1, parts: 24}]\n",
                  0.3);
}

/* So far from the origin the middle of a cluster can only stand where the next numbers are. */
static void test_misplaced(void **state)
{
    (void)state;
    compare_small("luxel: 1\n"
                  "screen: {width: 1, height: 1, resolution: [1, 1], sampling: centers}\n"
                  "observer: {z: 1000000001000}\n"
                  "surfaces: [{type: sphere, center: [0, 0, 1000000000000], radius: 0.003, "
                  "material: {model: lambert, diffuse: 1}}]\n"
                  "lights: [{type: volume, box: {center: [0, 0, 1000000000000.04], size: [0.0001, 1, 0.00068]}, "
                  "radiance: 1, parts: 8}]\n",
                  0.001);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_double), cmocka_unit_test(test_single),   cmocka_unit_test(test_few),
        cmocka_unit_test(test_room),   cmocka_unit_test(test_opposite), cmocka_unit_test(test_misplaced),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * Silhouettes: a turned box of triangles has the corners that geometry gives it, what is thin stays, and of real
 * meshes the lines part the pixels that show them from those that do not; other surfaces have what geometry outlines.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "place.h"
#include "scenes.h"

#define PI 3.14159265358979323846

static const double X[3] = {1, 0, 0}, Y[3] = {0, 1, 0}, Z[3] = {0, 0, 1};

static const char form[] =
    "luxel: 1\n"
    "screen: {width: 800, height: 800, resolution: [200, 200]}\n"
    "observer: {z: 2000}\n"
    "surfaces: [{type: mesh, file: '%s', scale: %g, rotate: [%g, %g, %g], position: [30, -20, 300]}]\n"
    "lights: [{type: ambient, irradiance: 1}]\n";

static luxel_scene *scene_of(const char *file, double scale, double about_x, double about_y, double about_z)
{
    char text[1024];
    luxel_scene *scene = NULL;
    snprintf(text, sizeof text, form, file, scale, about_x, about_y, about_z);
    assert_int_equal(luxel_scene_read_text(text, strlen(text), NULL, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_scene *scene_of_text(const struct place *place, const char *obj, double about_z)
{
    char path[256];
    snprintf(path, sizeof path, "%s/body.obj", place->folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(obj, file) >= 0);
    assert_int_equal(fclose(file), 0);
    return scene_of(path, 1, 0, 0, about_z);
}

static luxel_silhouette *silhouette_of(const luxel_scene *scene, const double right[3], const double up[3])
{
    luxel_silhouette *silhouette = NULL;
    assert_int_equal(luxel_find_silhouette(scene, 0, right, up, &silhouette), LUXEL_OK);
    return silhouette;
}

/* The area that a line goes around, below 0 where it runs clockwise. */
static double area_of(const luxel_silhouette_line *line)
{
    double sum = 0;
    for (size_t i = 0; i < line->count; i++) {
        const double *a = line->places_mm[i], *b = line->places_mm[(i + 1) % line->count];
        sum += a[0] * b[1] - a[1] * b[0];
    }
    return sum / 2;
}

/* How often the lines go around a place, and how far it is from them. */
static int turns_around(const luxel_silhouette *silhouette, const double at[2], double *distance)
{
    int turns = 0;
    *distance = HUGE_VAL;
    for (size_t k = 0; k < silhouette->count; k++)
        for (size_t i = 0; i < silhouette->lines[k].count; i++) {
            const double *a = silhouette->lines[k].places_mm[i];
            const double *b = silhouette->lines[k].places_mm[(i + 1) % silhouette->lines[k].count];
            const double way[2] = {b[0] - a[0], b[1] - a[1]}, off[2] = {at[0] - a[0], at[1] - a[1]};
            const double side = way[0] * off[1] - way[1] * off[0], square = way[0] * way[0] + way[1] * way[1];
            const double along = fmax(0, fmin(1, (way[0] * off[0] + way[1] * off[1]) / square));
            *distance = fmin(*distance, hypot(off[0] - along * way[0], off[1] - along * way[1]));
            turns += (a[1] <= at[1] && b[1] > at[1] && side > 0) - (b[1] <= at[1] && a[1] > at[1] && side < 0);
        }
    return turns;
}

/* A box of 400 x 200 x 100 turned by 30 degrees about the vertical. */
static const char box[] = "v -200 -100 -50\nv 200 -100 -50\nv 200 100 -50\nv -200 100 -50\n"
                          "v -200 -100 50\nv 200 -100 50\nv 200 100 50\nv -200 100 50\n"
                          "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

static void draws_a_turned_box(void **state)
{
    luxel_scene *scene = scene_of_text(*state, box, 30);
    const double c = cos(PI / 6), s = sin(PI / 6), width = 400 * c + 200 * s,
                 cell = fmax(width, 400 * s + 200 * c) / 1024;
    luxel_silhouette *plan = silhouette_of(scene, X, Y);
    assert_int_equal(plan->count, 1);
    const double area = area_of(&plan->lines[0]);
    if (!(area > 400 * 200 && area < 400 * 200 + 1200 * 1.5 * cell))
        fail_msg("the plan covers %g mm² of 80000", area);
    assert_in_range(plan->lines[0].count, 4, 12);
    for (int i = 0; i < 4; i++) {
        const double x = i == 1 || i == 2 ? 200 : -200, y = i >= 2 ? 100 : -100;
        const double corner[2] = {30 + c * x - s * y, -20 + s * x + c * y};
        double nearest = HUGE_VAL;
        for (size_t k = 0; k < plan->lines[0].count; k++)
            nearest = fmin(
                nearest, hypot(plan->lines[0].places_mm[k][0] - corner[0], plan->lines[0].places_mm[k][1] - corner[1]));
        if (nearest > 3 * cell)
            fail_msg("corner %d is %g mm off, which is %g cells", i, nearest, nearest / cell);
    }
    luxel_silhouette_free(plan);
    luxel_silhouette *elevation = silhouette_of(scene, X, Z);
    assert_int_equal(elevation->count, 1);
    assert_true(fabs(area_of(&elevation->lines[0]) - width * 100) < 2 * (width + 100) * 2 * width / 1024);
    luxel_silhouette_free(elevation);
    luxel_scene_free(scene);
}

/* A sheet seen from its edge is a line, which has no area and yet is there. */
static void keeps_what_is_thin(void **state)
{
    static const char sheet[] = "v -200 0 0\nv 200 0 0\nv 0 100 0\nf 1 2 3\n";
    luxel_scene *scene = scene_of_text(*state, sheet, 0);
    luxel_silhouette *edge = silhouette_of(scene, X, Z);
    double low = HUGE_VAL, high = -HUGE_VAL;
    assert_int_equal(edge->count, 1);
    for (size_t i = 0; i < edge->lines[0].count; i++) {
        low = fmin(low, edge->lines[0].places_mm[i][0]);
        high = fmax(high, edge->lines[0].places_mm[i][0]);
        assert_true(fabs(edge->lines[0].places_mm[i][1] - 300) < 1);
    }
    assert_true(fabs(low + 170) < 1 && fabs(high - 230) < 1);
    luxel_silhouette_free(edge);
    luxel_scene_free(scene);
}

/* Pixels that show a mesh lie within its plan, those that do not outside, but for some on its very lines. */
static void compare_with_picture(const char *file, double scale, double tilt, bool has_holes)
{
    enum { SIDE = 200 };
    luxel_scene *scene = scene_of(file, scale, tilt, 20, 40);
    luxel_silhouette *plan = silhouette_of(scene, X, Y);
    double *depth = calloc((size_t)SIDE * SIDE, sizeof *depth),
           (*normals)[3] = calloc((size_t)SIDE * SIDE, sizeof *normals);
    double radius, area = 0;
    size_t seen = 0, holes = 0;
    assert_true(depth && normals);
    assert_int_equal(luxel_scene_surface_radius(scene, 0, &radius), LUXEL_OK);
    assert_int_equal(luxel_find_geometry(scene, NULL, NULL, &(luxel_geometry){.depth_mm = depth, .normals = normals}),
                     LUXEL_OK);
    for (size_t k = 0; k < plan->count; k++) {
        area += area_of(&plan->lines[k]);
        holes += area_of(&plan->lines[k]) < 0;
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        const double at[2] = {800.0 / SIDE * ((double)(i % SIDE) + 0.5) - 400,
                              400 - 800.0 / SIDE * ((double)(i / SIDE) + 0.5)};
        const bool is_seen = depth[i] != 0;
        double distance;
        const int turns = turns_around(plan, at, &distance);
        seen += is_seen;
        if (is_seen != (turns == 1) && distance > 0.003 * 2 * radius)
            fail_msg("%s: (%g, %g) is %s, lies %d times within, and %g mm from the lines", file, at[0], at[1],
                     is_seen ? "seen" : "not seen", turns, distance);
        assert_in_range(turns, 0, 1);
    }
    assert_int_equal(holes > 0, has_holes);
    const double pixels = (double)seen * 16;
    if (!(seen > 2000 && fabs(area - pixels) < 0.03 * pixels))
        fail_msg("%s: %g mm², pixels %g mm²", file, area, pixels);
    free(normals);
    free(depth);
    luxel_silhouette_free(plan);
    luxel_scene_free(scene);
}

static void parts_what_is_seen(void **state)
{
    (void)state;
    compare_with_picture("builtin:knot.ply", 1, 0, true);
    compare_with_picture("builtin:pot.ply", 1, 65, false);
}

/* The silhouette of a surface that is no mesh: where its lines reach, and the area that they go around together. */
static void outlines_other_surfaces(void **state)
{
    (void)state;
    static const double root = 141.4213562373095;
    const struct {
        const char *surface;
        bool is_elevation;
        size_t lines;
        double half[2], area; /* around its centre */
    } cases[] = {
        {"sphere, center: [10, 20, 20], radius: 100", false, 1, {100, 100}, PI * 1e4},
        {"sphere, center: [10, 20, 20], radius: 100", true, 1, {100, 100}, PI * 1e4},
        {"sphere, center: [10, 20, 20], radius: 100, inside: true", true, 1, {100, 100}, PI * 1e4},
        {"rectangle, center: [10, 20, 20], size: [200, 100]", false, 1, {100, 50}, 2e4},
        {"rectangle, center: [10, 20, 20], size: [200, 100]", true, 1, {100, 0}, 0},
        {"rectangle, center: [10, 20, 20], size: [200, 100], axis: [0, 0, -1]", false, 1, {100, 50}, 2e4},
        {"disk, center: [10, 20, 20], radius: 100, axis: [0.6, 0, 0.8]", false, 1, {80, 100}, 0.8 * PI * 1e4},
        {"cylinder, center: [10, 20, 20], radius: 100, height: 600, axis: [1, 0, 0]", false, 4, {300, 100}, 0},
        {"cylinder, center: [10, 20, 20], radius: 100, height: 600, axis: [0, 0, 1]", true, 4, {100, 300}, 0},
        {"cylinder, center: [10, 20, 20], radius: 100, height: 600, axis: [0, 0, 1]",
         false,
         2,
         {100, 100},
         2 * PI * 1e4},
        {"room, center: [10, 20, 20], size: [200, 100, 300]", false, 6, {100, 50}, 4e4},
        {"room, center: [10, 20, 20], size: [200, 100, 300]", true, 6, {100, 150}, 12e4},
        {"box, center: [10, 20, 20], size: [200, 100, 300]", false, 6, {100, 50}, 4e4},
        {"box, center: [10, 20, 20], size: [200, 200, 300], rotate: [0, 0, 45]", false, 6, {root, root}, 8e4},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        luxel_scene *scene = NULL;
        double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, area = 0;
        snprintf(text, sizeof text,
                 "luxel: 1\nscreen: {width: 800, height: 800, resolution: [200, 200]}\nobserver: {z: 2000}\n"
                 "surfaces: [{type: %s}]\nlights: [{type: ambient, irradiance: 1}]\n",
                 cases[i].surface);
        assert_int_equal(luxel_scene_read_text(text, strlen(text), NULL, NULL, &scene), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        luxel_silhouette *silhouette = silhouette_of(scene, X, cases[i].is_elevation ? Z : Y);
        assert_int_equal(silhouette->count, cases[i].lines);
        for (size_t l = 0; l < silhouette->count; l++) {
            const double own = area_of(&silhouette->lines[l]);
            assert_true(own >= -1e-6); /* counter-clockwise */
            area += own;
            for (size_t k = 0; k < silhouette->lines[l].count; k++)
                for (int axis = 0; axis < 2; axis++) {
                    low[axis] = fmin(low[axis], silhouette->lines[l].places_mm[k][axis]);
                    high[axis] = fmax(high[axis], silhouette->lines[l].places_mm[k][axis]);
                }
        }
        for (int axis = 0; axis < 2; axis++) {
            const double middle = axis ? 20 : 10;
            assert_true(fabs(low[axis] - middle + cases[i].half[axis]) < 0.2);
            assert_true(fabs(high[axis] - middle - cases[i].half[axis]) < 0.2);
        }
        assert_true(fabs(area - cases[i].area) <= 2e-3 * cases[i].area + 1e-6);
        luxel_silhouette_free(silhouette);
        luxel_scene_free(scene);
    }
}

static void refuses_what_is_none(void **state)
{
    (void)state;
    static const double slant[3] = {0.6, 0.9, 0};
    luxel_scene *scene = scene_of("builtin:pot.ply", 1, 0, 0, 0), *ball = builtin("sphere");
    luxel_silhouette *silhouette = NULL;
    assert_int_equal(luxel_find_silhouette(ball, 1, X, Y, &silhouette), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_silhouette(scene, 1, X, Y, &silhouette), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_silhouette(scene, 0, X, slant, &silhouette), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_silhouette(scene, 0, X, NULL, &silhouette), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_silhouette(scene, 0, X, Y, NULL), LUXEL_ERROR_ARGUMENT);
    assert_null(silhouette);
    luxel_silhouette_free(NULL);
    luxel_scene_free(ball);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(draws_a_turned_box, make_place, remove_place),
        cmocka_unit_test_setup_teardown(keeps_what_is_thin, make_place, remove_place),
        cmocka_unit_test(parts_what_is_seen),
        cmocka_unit_test(outlines_other_surfaces),
        cmocka_unit_test(refuses_what_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

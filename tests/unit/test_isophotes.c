/* SPDX-License-Identifier: MIT */
/*
 * Isophotes: every vertex on its level to 1e-9, circles in space on a sphere under a distant source, circles on a plate
 * under a point, a saddle, lines that end at limbs, other surfaces and the screen's edge, the same lines for any number
 * of threads, and round levels.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <luxel/luxel.h>

#include "csv_field.h"

struct view {
    luxel_scene *scene;
    luxel_evaluator *evaluator;
    luxel_field *field;
};

static struct view view_with(const char *text, luxel_quantity quantity, unsigned threads)
{
    struct view view = {0};
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = quantity;
    settings.threads = threads;
    if (luxel_scene_open_builtin(text, NULL, &view.scene) != LUXEL_OK)
        assert_int_equal(luxel_scene_read_text(text, strlen(text), "test", NULL, &view.scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(view.scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(view.scene, &settings, NULL, &view.evaluator), LUXEL_OK);
    assert_int_equal(luxel_render(view.scene, &settings, NULL, &view.field), LUXEL_OK);
    return view;
}

static void view_clear(struct view *view)
{
    luxel_field_free(view->field);
    luxel_evaluator_free(view->evaluator);
    luxel_scene_free(view->scene);
}

static luxel_isophotes *lines_of(const struct view *view, const double *levels, size_t count)
{
    luxel_isophotes *lines = NULL;
    assert_int_equal(luxel_find_isophotes(view->field, view->evaluator, levels, count, NULL, &lines), LUXEL_OK);
    return lines;
}

/* Every vertex has its level, and no two neighbours are farther apart than cells are wide. */
static void assert_on_level(const struct view *view, const luxel_isophotes *lines)
{
    const double pixel = luxel_field_x_mm(view->field)[1] - luxel_field_x_mm(view->field)[0];
    for (size_t i = 0; i < lines->count; i++) {
        const luxel_isophote *line = &lines->lines[i];
        assert_true(line->count >= 2);
        for (size_t k = 0; k < line->count; k++) {
            luxel_value value;
            luxel_evaluate_screen(view->evaluator, line->x_mm[k], line->y_mm[k], &value, NULL);
            if (!value.has_value || !(fabs(value.value - line->level) <= 1e-9 * line->level))
                fail_msg("(%.17g, %.17g): %.17g is not %.17g", line->x_mm[k], line->y_mm[k], value.value, line->level);
            if (k > 0)
                assert_true(hypot(line->x_mm[k] - line->x_mm[k - 1], line->y_mm[k] - line->y_mm[k - 1]) < 1.5 * pixel);
        }
    }
}

/* The greater values are at the left of every segment. */
static void assert_turned_left(const struct view *view, const luxel_isophotes *lines)
{
    for (size_t i = 0; i < lines->count; i++) {
        const luxel_isophote *line = &lines->lines[i];
        for (size_t k = line->count / 2; k < line->count / 2 + 1 && k + 1 < line->count; k++) {
            double dx = line->x_mm[k + 1] - line->x_mm[k], dy = line->y_mm[k + 1] - line->y_mm[k];
            double x = (line->x_mm[k + 1] + line->x_mm[k]) / 2, y = (line->y_mm[k + 1] + line->y_mm[k]) / 2;
            luxel_value left;
            luxel_evaluate_screen(view->evaluator, x - 0.1 * dy, y + 0.1 * dx, &left, NULL);
            luxel_value right;
            luxel_evaluate_screen(view->evaluator, x + 0.1 * dy, y - 0.1 * dx, &right, NULL);
            assert_true(left.value > right.value);
        }
    }
}

static void test_builtins(void **state)
{
    static const char *const names[] = {"report", "spot", "two-spheres", "three-lights", "distant", "desk"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct view view = view_with(names[i], LUXEL_BRIGHTNESS, 0);
        double levels[16];
        size_t count = luxel_round_levels(0, luxel_field_statistics(view.field)->maximum.value, false, 8, levels, 16);
        luxel_isophotes *lines = lines_of(&view, levels, count);
        assert_true(count > 4 && lines->count >= count);
        assert_on_level(&view, lines);
        luxel_isophotes_free(lines);
        view_clear(&view);
    }
}

#define LAMBERT "surfaces: [{type: sphere, center: [10, -20, 900], radius: %d, material: {model: lambert}}]\n"

/* E = kd E0 N.L: the normals of a line make one angle with L. */
static void test_circles_on_a_sphere(void **state)
{
    static const char *const cameras[] = {"{z: 1500}", "{z: 1500, projection: perspective}"};
    static const char *const samplings[] = {"nodes", "centers"};
    (void)state;
    for (int k = 0; k < 4; k++) {
        char text[800];
        snprintf(
            text, sizeof text,
            "luxel: 1\nscreen: {width: 500, height: 500, resolution: [100, 100], sampling: %s}\nobserver: %s\n" LAMBERT
            "lights: [{type: distant, direction: [-2, 1, -2], irradiance: 5}]\n",
            samplings[k % 2], cameras[k / 2], k < 2 ? 210 : 80);
        struct view view = view_with(text, LUXEL_BRIGHTNESS, 0);
        const double levels[] = {0.5, 1, 2, 3, 3.9}, toward[3] = {2 / 3.0, -1 / 3.0, 2 / 3.0};
        luxel_isophotes *lines = lines_of(&view, levels, 5);
        assert_int_equal(lines->count, 5);
        assert_on_level(&view, lines);
        assert_turned_left(&view, lines);
        for (size_t i = 0; i < lines->count; i++) {
            const luxel_isophote *line = &lines->lines[i];
            for (size_t v = 0; v < line->count; v++) {
                luxel_value value;
                luxel_evaluate_screen(view.evaluator, line->x_mm[v], line->y_mm[v], &value, NULL);
                double cosine = value.normal[0] * toward[0] + value.normal[1] * toward[1] + value.normal[2] * toward[2];
                assert_true(fabs(cosine - line->level / 4) <= 1e-9 * cosine);
            }
            /* a circle all of which is seen is closed: L is 48.2 degrees from the z axis, the circle of 3 41.4 from L,
             * and the limb at 90 degrees, or in perspective before */
            assert_int_equal(line->closed, k < 2 ? line->level >= 3 : line->level > 3);
        }
        luxel_isophotes_free(lines);
        view_clear(&view);
    }
}

static const char plate[] =
    "luxel: 1\nscreen: {width: 400, height: 200, resolution: [80, 40]}\nobserver: {z: 1000}\n"
    "surfaces: [{type: rectangle, center: [0, 0, 0], size: [1000, 1000], material: {model: lambert, diffuse: 1}}]\n"
    "lights: [%s]\n";

/* Under a point at the height h: I h/(h^2 + d^2)^(3/2). */
static void test_circles_on_a_plate(void **state)
{
    char text[800];
    const double radii[] = {30, 60, 99, 130};
    double levels[4];
    (void)state;
    snprintf(text, sizeof text, plate, "{type: point, position: [20, 0, 80], intensity: 1}");
    struct view view = view_with(text, LUXEL_BRIGHTNESS, 0);
    for (int i = 0; i < 4; i++)
        levels[i] = 0.08 / pow(0.0064 + radii[i] * radii[i] * 1e-6, 1.5);
    luxel_isophotes *lines = lines_of(&view, levels, 4);
    assert_on_level(&view, lines);
    assert_int_equal(lines->count, 5); /* the widest leaves the screen above and below: two arcs */
    for (size_t i = 0; i < lines->count; i++) {
        const luxel_isophote *line = &lines->lines[i];
        double radius = radii[i < 4 ? i : 3];
        assert_int_equal(line->closed, i < 3);
        for (size_t v = 0; v < line->count; v++)
            assert_true(fabs(hypot(line->x_mm[v] - 20, line->y_mm[v]) - radius) <= 1e-8 * radius);
        for (int end = 0; end < 2 && !line->closed; end++) /* on the screen's edge */
            assert_true(fabs(fabs(line->y_mm[end ? line->count - 1 : 0]) - 100) < 1e-9);
    }
    luxel_isophotes_free(lines);
    view_clear(&view);
}

/* Two equal lamps: below the value in the middle one line goes around both, above it one around each. */
static void test_saddle(void **state)
{
    static const char *const lamps[] = {"{type: point, position: [70.3, 1.7, 50], intensity: 1}, {type: point, "
                                        "position: [-69.7, 1.7, 50], intensity: 1}",
                                        "{type: point, position: [30.3, 31.7, 30], intensity: 1}, {type: point, "
                                        "position: [-29.7, -28.3, 30], intensity: 1}"};
    (void)state;
    for (int i = 0; i < 4; i++) {
        char text[800];
        bool above = i % 2;
        snprintf(text, sizeof text, plate, lamps[i / 2]);
        struct view view = view_with(text, LUXEL_BRIGHTNESS, 0);
        luxel_value value;
        luxel_evaluate_screen(view.evaluator, 0.3, 1.7, &value, NULL);
        double level = value.value * (above ? 1 + 1e-6 : 1 - 1e-6);
        luxel_isophotes *lines = lines_of(&view, &level, 1);
        assert_int_equal(lines->count, above ? 2 : 1);
        assert_on_level(&view, lines);
        for (size_t k = 0; k < lines->count; k++)
            assert_true(lines->lines[k].closed);
        luxel_isophotes_free(lines);
        view_clear(&view);
    }
}

/* In a picture alone a saddle is that of the bilinear surface: here at 8/9, between high corners and low ones. */
static void test_saddle_of_picture(void **state)
{
    const double corners[4] = {4, 0, 1, 0.5}; /* counter-clockwise from the lower left one */
    (void)state;
    for (int turn = 0; turn < 4; turn++)
        for (int above = 0; above < 2; above++) {
            const double v[4] = {corners[turn], corners[(turn + 1) % 4], corners[(turn + 2) % 4],
                                 corners[(turn + 3) % 4]};
            const double values[4] = {v[3], v[2], v[0], v[1]}, level = above ? 0.95 : 0.82;
            luxel_field *field = csv_field(values, 2, 2);
            luxel_isophotes *lines = NULL;
            assert_int_equal(luxel_find_isophotes(field, NULL, &level, 1, NULL, &lines), LUXEL_OK);
            assert_int_equal(lines->count, 2);
            for (size_t i = 0; i < 2; i++) {
                /* a line cuts off the corner that both of its ends are nearest to: a high one above the saddle */
                const luxel_isophote *line = &lines->lines[i];
                assert_int_equal(line->count, 2);
                double x = fmod(line->x_mm[0], 1) == 0 ? line->x_mm[0] : line->x_mm[1];
                double y = fmod(line->y_mm[0], 1) == 0 ? line->y_mm[0] : line->y_mm[1];
                double cut_off = values[(y > 0.5 ? 0 : 2) + (x > 0.5 ? 1 : 0)];
                assert_int_equal(cut_off > level, above);
            }
            luxel_isophotes_free(lines);
            luxel_field_free(field);
        }
}

/* A line ends at the limb itself, not a pixel before it. */
static void test_ends(void **state)
{
    (void)state;
    struct view view =
        view_with("luxel: 1\nscreen: {width: 500, height: 500, resolution: [60, 60]}\nobserver: {z: 1500}\n"
                  "surfaces: [{type: sphere, center: [0, 0, 900], radius: 210, material: {model: lambert}}]\n"
                  "lights: [{type: distant, direction: [-3, 1, -1], irradiance: 5}]\n",
                  LUXEL_IRRADIANCE, 0);
    const double levels[] = {1, 2, 3, 4};
    luxel_isophotes *lines = lines_of(&view, levels, 4);
    assert_int_equal(lines->count, 4);
    assert_on_level(&view, lines);
    for (size_t i = 0; i < lines->count; i++) {
        const luxel_isophote *line = &lines->lines[i];
        assert_false(line->closed);
        for (int end = 0; end < 2; end++) {
            size_t v = end ? line->count - 1 : 0;
            if (!(fabs(hypot(line->x_mm[v], line->y_mm[v]) - 210) < 1e-3))
                fail_msg("%g: (%.9g, %.9g) is %.9g from the axis", line->level, line->x_mm[v], line->y_mm[v],
                         hypot(line->x_mm[v], line->y_mm[v]));
        }
    }
    luxel_isophotes_free(lines);
    view_clear(&view);
}

/* A bar before the sphere, thinner than a pixel and from corner to corner of pixels: lines end on either side of it. */
static void test_behind_a_bar(void **state)
{
    (void)state;
    struct view view = view_with(
        "luxel: 1\nshadows: none\nscreen: {width: 500, height: 500, resolution: [101, 101], sampling: nodes}\n"
        "observer: {z: 1500}\nsurfaces:\n"
        "  - {type: sphere, center: [10, -20, 900], radius: 210, material: {model: lambert}}\n"
        "  - {type: rectangle, center: [0, 0, 1200], size: [2, 700], up: [1, 1, 0], material: {diffuse: 0, "
        "specular: 0}}\n"
        "lights: [{type: distant, direction: [-2, 1, -2], irradiance: 5}]\n",
        LUXEL_BRIGHTNESS, 0);
    const double levels[] = {0.5, 1, 2, 3, 3.9}, half = sqrt(2);
    luxel_isophotes *lines = lines_of(&view, levels, 5);
    assert_on_level(&view, lines);
    size_t ends = 0;
    for (size_t i = 0; i < lines->count; i++) {
        const luxel_isophote *line = &lines->lines[i];
        for (size_t v = 0; v < line->count; v++)
            assert_true(fabs(line->x_mm[v] - line->y_mm[v]) >= half * (1 - 1e-9));
        for (size_t v = 1; v < line->count; v++)
            assert_true((line->x_mm[v] > line->y_mm[v]) == (line->x_mm[v - 1] > line->y_mm[v - 1]));
        const size_t last = line->count - 1;
        ends += !line->closed && fabs(line->x_mm[0] - line->y_mm[0]) < half * (1 + 1e-6);
        ends += !line->closed && fabs(line->x_mm[last] - line->y_mm[last]) < half * (1 + 1e-6);
    }
    assert_true(ends >= 8);
    luxel_isophotes_free(lines);
    view_clear(&view);
}

/* A hard cone's edge jumps: no vertex lies on it, as none of a level between would be true. */
static void test_jumps(void **state)
{
    char text[800];
    (void)state;
    snprintf(
        text, sizeof text, plate,
        "{type: spot, position: [0, 0, 300], intensity: 1, inner: 10, outer: 10}, {type: ambient, irradiance: 0.1}");
    struct view view = view_with(text, LUXEL_BRIGHTNESS, 0);
    const double levels[] = {5};
    luxel_isophotes *lines = lines_of(&view, levels, 1);
    assert_int_equal(lines->count, 0);
    luxel_isophotes_free(lines);
    view_clear(&view);
}

static void test_threads(void **state)
{
    (void)state;
    luxel_isophotes *lines[2];
    for (int i = 0; i < 2; i++) {
        struct view view = view_with("two-spheres", LUXEL_BRIGHTNESS, i ? 7 : 1);
        const double levels[] = {0.1, 0.5, 1, 2};
        lines[i] = lines_of(&view, levels, 4);
        view_clear(&view);
    }
    assert_int_equal(lines[0]->count, lines[1]->count);
    for (size_t i = 0; i < lines[0]->count; i++) {
        const luxel_isophote *a = &lines[0]->lines[i], *b = &lines[1]->lines[i];
        assert_int_equal(a->count, b->count);
        assert_memory_equal(a->x_mm, b->x_mm, a->count * sizeof *a->x_mm);
        assert_memory_equal(a->y_mm, b->y_mm, a->count * sizeof *a->y_mm);
    }
    luxel_isophotes_free(lines[0]);
    luxel_isophotes_free(lines[1]);
}

/* From the picture alone a line is near, and levels that nothing reaches have none. */
static void test_picture(void **state)
{
    (void)state;
    struct view view = view_with("report", LUXEL_BRIGHTNESS, 0);
    const double levels[] = {6, 0, -1, 100};
    luxel_isophotes *lines = NULL;
    assert_int_equal(luxel_find_isophotes(view.field, NULL, levels, 4, NULL, &lines), LUXEL_OK);
    assert_int_equal(lines->count, 1);
    for (size_t v = 0; v < lines->lines[0].count; v++) {
        luxel_value value;
        luxel_evaluate_screen(view.evaluator, lines->lines[0].x_mm[v], lines->lines[0].y_mm[v], &value, NULL);
        assert_true(fabs(value.value - 6) < 0.01);
    }
    luxel_isophotes_free(lines);
    for (int i = 0; i < 3; i++) {
        double bad[3] = {6, 7, 8};
        bad[i] = i == 1 ? HUGE_VAL : (double)NAN;
        assert_int_equal(luxel_find_isophotes(view.field, NULL, bad, 3, NULL, &lines), LUXEL_ERROR_ARGUMENT);
    }
    struct view other = view_with("spot", LUXEL_BRIGHTNESS, 0);
    assert_int_equal(luxel_find_isophotes(view.field, other.evaluator, levels, 1, NULL, &lines), LUXEL_ERROR_ARGUMENT);
    view_clear(&other);
    assert_int_equal(luxel_find_isophotes(NULL, NULL, levels, 1, NULL, &lines), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_isophotes(view.field, NULL, NULL, 1, NULL, &lines), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_isophotes(view.field, NULL, levels, 1, NULL, NULL), LUXEL_ERROR_ARGUMENT);
    /* of as many pixels, but of another screen */
    luxel_scene *wider = luxel_scene_copy(view.scene);
    luxel_evaluator *evaluator = NULL;
    assert_int_equal(luxel_scene_set(wider, "screen={width: 510, height: 510, resolution: [360, 360]}", NULL),
                     LUXEL_OK);
    assert_int_equal(luxel_scene_commit(wider, NULL), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(wider, NULL, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_find_isophotes(view.field, evaluator, levels, 1, NULL, &lines), LUXEL_ERROR_ARGUMENT);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(wider);
    view_clear(&view);
}

static void assert_levels(double low, double high, bool logarithmic, size_t wanted, const double *expected,
                          size_t count)
{
    double levels[32];
    size_t found = luxel_round_levels(low, high, logarithmic, wanted, levels, 32);
    assert_int_equal(found, count);
    for (size_t i = 0; i < count; i++)
        if (levels[i] != expected[i])
            fail_msg("level %zu is %.17g, not %.17g", i, levels[i], expected[i]);
}

static void test_round_levels(void **state)
{
    (void)state;
    assert_levels(0, 11.7, false, 5, (const double[]){2, 4, 6, 8, 10}, 5);
    assert_levels(0, 1, false, 9, (const double[]){0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}, 9);
    assert_levels(-3, 3, false, 5, (const double[]){-2, -1, 0, 1, 2}, 5);
    assert_levels(1e-9, 5e-9, false, 4, (const double[]){2e-9, 3e-9, 4e-9}, 3);
    assert_levels(0.05, 30, true, 9, (const double[]){0.1, 0.2, 0.5, 1, 2, 5, 10, 20}, 8);
    assert_levels(1e-6, 1e6, true, 4, (const double[]){1e-4, 1e-2, 1, 100, 1e4}, 5);
    /* rounded once, so that no level is a neighbour of the round number */
    assert_levels(0, 1e-23, false, 4, (const double[]){2e-24, 4e-24, 6e-24, 8e-24}, 4);
    assert_levels(0, 3e22, false, 4, (const double[]){5e21, 1e22, 1.5e22, 2e22, 2.5e22}, 5);
    /* the ends of what doubles can hold, and ranges too narrow for steps */
    assert_levels(-1.7e308, 1.7e308, false, 3, (const double[]){-1e308, 0, 1e308}, 3);
    assert_levels(1e-300, 1e300, true, 5, (const double[]){1e-240, 1e-160, 1e-80, 1, 1e80, 1e160, 1e240}, 7);
    assert_levels(1e17, 1e17 + 64, false, 5, NULL, 0);
    assert_levels(1, nextafter(1, 2), false, 5, NULL, 0);
    assert_levels(0, 5e-324, false, 3, NULL, 0);
    assert_levels(0, 5e-324, true, 3, NULL, 0);
    double few[3];
    assert_int_equal(luxel_round_levels(0, 1, false, SIZE_MAX, few, 3), 1);
    assert_true(few[0] == 0.5);
    /* where steps are too many for the room the next coarser ones: 0.2, 0.5, 1, 2 */
    assert_int_equal(luxel_round_levels(0, 1.04, false, 3, few, 3), 2);
    assert_true(few[0] == 0.5 && few[1] == 1);
    assert_int_equal(luxel_round_levels(0, 2.2, false, 3, few, 3), 2);
    assert_true(few[0] == 1 && few[1] == 2);
    assert_int_equal(luxel_round_levels(0, 4.4, false, 3, few, 3), 2);
    assert_true(few[0] == 2 && few[1] == 4);
    assert_levels(1, 1, false, 4, NULL, 0);
    assert_levels(0, (double)NAN, false, 4, NULL, 0);
}

/* Linear levels lie within the range, as far apart as a round step, and as many as wanted but for its roundness. */
static void test_steps(void **state)
{
    (void)state;
    uint64_t random = 7;
    for (int n = 0; n < 3000; n++) {
        double levels[64], numbers[3];
        for (int i = 0; i < 3; i++) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            numbers[i] = (double)(random >> 11) * 0x1p-53;
        }
        double low = (numbers[0] - 0.5) * 100, high = low + pow(10, 6 * numbers[1] - 3);
        size_t wanted = 1 + (size_t)(numbers[2] * 20), count = luxel_round_levels(low, high, false, wanted, levels, 64);
        assert_true(count * 2 + 2 >= wanted && count <= 2 * wanted + 2);
        for (size_t i = 0; i < count; i++)
            assert_true(levels[i] > low && levels[i] < high);
        if (count < 2)
            continue;
        double step = levels[1] - levels[0], digit = step / pow(10, floor(log10(step) + 1e-6));
        assert_true(fabs(digit - 1) < 1e-6 || fabs(digit - 2) < 1e-6 || fabs(digit - 5) < 1e-6);
        assert_true(levels[0] - step <= low + 1e-9 * step && levels[count - 1] + step >= high - 1e-9 * step);
        for (size_t i = 1; i < count; i++)
            assert_true(fabs(levels[i] - levels[i - 1] - step) < 1e-6 * step);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_builtins),
        cmocka_unit_test(test_circles_on_a_sphere),
        cmocka_unit_test(test_circles_on_a_plate),
        cmocka_unit_test(test_saddle),
        cmocka_unit_test(test_saddle_of_picture),
        cmocka_unit_test(test_ends),
        cmocka_unit_test(test_behind_a_bar),
        cmocka_unit_test(test_jumps),
        cmocka_unit_test(test_threads),
        cmocka_unit_test(test_picture),
        cmocka_unit_test(test_round_levels),
        cmocka_unit_test(test_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

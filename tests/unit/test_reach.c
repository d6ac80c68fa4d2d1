/* SPDX-License-Identifier: MIT */
/*
 * Where light arrives: the least value there and the share of such pixels, against N.L of the report's sphere by hand,
 * and against the reference pixel by pixel in scenes of every kind of source; and that neither depends on threads.
 */
#include <math.h>
#include <stdlib.h>

#include "scenes.h"

#include "base/memory.h"
#include "picture/reach.h"
#include "scene/scene.h"

struct truth {
    size_t shown, reached;
    double least,
        doubt; /* the least value where light arrives; how many pixels are too near to the terminator to tell */
};

/* By the irradiance of the scene's sources but the ambient ones, from the reference, and the picture's values. */
static struct truth truth_of(const luxel_scene *scene, const luxel_field *field)
{
    const unsigned columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    const struct lx_list *lights = &lx_scene_parameters(scene)->lights;
    luxel_settings settings;
    luxel_evaluator *evaluator = NULL;
    double *shares = calloc(lights->count + 1, sizeof *shares);
    struct truth truth = {.least = HUGE_VAL};
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.tolerance = 1e-3;
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
    for (unsigned row = 0; row < rows; row++)
        for (unsigned column = 0; column < columns; column++) {
            luxel_value found;
            luxel_evaluate_screen(evaluator, luxel_field_x_mm(field)[column], luxel_field_y_mm(field)[row], &found,
                                  shares);
            double direct = 0;
            for (size_t i = 0; i < lights->count; i++)
                direct += lights->items[i].variant->name[0] == 'a' ? 0 : shares[i];
            if (!found.on_surface)
                continue;
            const double value = luxel_field_value(field, column, row);
            truth.shown++;
            truth.reached += direct > 0;
            truth.doubt += direct > 0 && direct < 1e-9;
            if (direct > 0 && value >= 1.2e-38)
                truth.least = fmin(truth.least, value);
        }
    luxel_evaluator_free(evaluator);
    free(shares);
    return truth;
}

static double share_of(const luxel_scene *scene, const luxel_field *field)
{
    struct lx_reach reach;
    luxel_settings settings;
    double share = (double)NAN;
    luxel_settings_init(&settings);
    assert_int_equal(lx_reach_open(&reach, lx_scene_parameters(scene), lx_kernels_choose(NULL), &settings), LUXEL_OK);
    assert_int_equal(lx_reach_share(&reach, luxel_field_x_mm(field), luxel_field_columns(field),
                                    luxel_field_y_mm(field), luxel_field_rows(field), &share),
                     LUXEL_OK);
    lx_reach_clear(&reach);
    return share;
}

static luxel_field *rendered(const luxel_scene *scene, unsigned threads)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.threads = threads;
    settings.minimum_reached = true;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

static void check(const char *name, const char *const *changes, size_t count)
{
    luxel_scene *scene = opened_with(name, changes, count);
    luxel_field *field = rendered(scene, 1), *again = rendered(scene, 7);
    const luxel_extremum *least = &luxel_field_statistics(field)->minimum_reached;
    const struct truth truth = truth_of(scene, field);
    print_message("# %zu of %zu pixels, %g\n", truth.reached, truth.shown, truth.least);
    assert_true(fabs(share_of(scene, field) * (double)truth.shown - (double)truth.reached) <= truth.doubt + 1e-6);
    assert_true(least->exists == (truth.least < HUGE_VAL));
    if (least->exists) {
        assert_true(least->value == truth.least);
        assert_true(luxel_field_value(field, least->column, least->row) == truth.least);
    }
    const luxel_extremum *other = &luxel_field_statistics(again)->minimum_reached;
    assert_true(other->value == least->value && other->column == least->column && other->row == least->row);
    assert_true(other->x_mm == least->x_mm && other->y_mm == least->y_mm);
    luxel_field_free(field);
    luxel_field_free(again);
    luxel_scene_free(scene);
}

#define CHECK(name, ...)                                                                                               \
    check(name, (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *))
#define SMALL(columns, rows) "screen.resolution=[" #columns "," #rows "]"

/* It costs several pictures of one source, so only those who ask for it get it. */
static void test_only_where_asked_for(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_field *field = NULL;
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    assert_true(luxel_field_statistics(field)->minimum.exists);
    assert_false(luxel_field_statistics(field)->minimum_reached.exists);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* 66.56 % of the report's pixels face its source; its highlight shows on 93.88 %. */
static void test_report_by_hand(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_field *field = rendered(scene, 0);
    size_t shown = 0, faced = 0;
    double least = HUGE_VAL;
    for (unsigned row = 0; row < 360; row++)
        for (unsigned column = 0; column < 360; column++) {
            const double x = -250 + column * 500 / 359.0, y = 250 - row * 500 / 359.0, square = 9e4 - x * x - y * y;
            if (square < 0)
                continue;
            const double z = sqrt(square), to[3] = {2000 - x, -y, 1000 - z}; /* from the sphere's centre */
            shown++;
            if (to[0] * x + to[1] * y + to[2] * z <= 0)
                continue;
            faced++;
            least = fmin(least, luxel_field_value(field, column, row));
        }
    const luxel_statistics *statistics = luxel_field_statistics(field);
    assert_true(fabs((double)faced / (double)shown - 0.6656) < 5e-5);
    assert_true(fabs(share_of(scene, field) - (double)faced / (double)shown) < 1e-15);
    assert_true(statistics->minimum_reached.value == least);
    assert_true(statistics->minimum.value < 1e-30 && least > 1e-4);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

static void test_point_like_sources(void **state)
{
    (void)state;
    CHECK("report", SMALL(120, 120));
    CHECK("report", SMALL(120, 120), "lights[0].position=[2000, -700, 900]"); /* below the sphere's centre */
    CHECK("report", SMALL(120, 120), "lights[0].position=[0, 0, 100]");       /* no light arrives at all */
    CHECK("report", SMALL(120, 120), "lights[0].intensity=0");
    CHECK("report", SMALL(120, 120), "observer.projection=perspective");
    CHECK("report", SMALL(120, 120), "surfaces[0].material.highlight=gated");
    CHECK("report", SMALL(150, 120), "screen.width=600", "screen.height=480", "units=radiometric");
    CHECK("distant", SMALL(120, 120));
    CHECK("three-lights", SMALL(100, 80));
    CHECK("two-spheres", SMALL(100, 80));
    CHECK("two-spheres", SMALL(100, 80), "shadows=none");
    CHECK("ambient", SMALL(60, 60));
    CHECK("spot", SMALL(100, 100));
    CHECK("desk", SMALL(100, 80));
}

static void test_extended_sources(void **state)
{
    (void)state;
    CHECK("window", SMALL(40, 40));
    CHECK("disk-lamp", SMALL(40, 40));
    CHECK("tube", SMALL(40, 40));
    CHECK("ball-lamp", SMALL(40, 40));
    CHECK("window", SMALL(40, 40), "lights[0].attenuation=none");
}

/* Variants: spheres under one or two points, and a picture that is made strip by strip says the same. */
static void test_variants(void **state)
{
    (void)state;
    for (unsigned number = 1; number <= 12; number++) {
        char *text = NULL;
        assert_int_equal(luxel_variant_text(number, NULL, &text), LUXEL_OK);
        check(text, NULL, 0);
        luxel_text_free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_report_by_hand),     cmocka_unit_test(test_only_where_asked_for),
        cmocka_unit_test(test_point_like_sources), cmocka_unit_test(test_extended_sources),
        cmocka_unit_test(test_variants),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

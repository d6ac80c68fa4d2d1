/* SPDX-License-Identifier: MIT */
/*
 * Every instruction set's kernels against the float64 reference, on random and on nasty scenes: grazing and
 * backward light, sources just above the surface and very far, all laws, profiles, lobes and projections, odd
 * numbers of pixels; spheres alone, and plates alone and among spheres.  Asserts which set really ran, that float32
 * pictures keep 2e-6 and float64 pictures 1e-11 of their maximum, and that a pixel has the same bytes wherever it
 * stands in a block.
 */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "campaign.h"
#include "picture/plan_make.h"
#include "picture/shader.h"
#include "random_scenes.h"
#include "world/camera.h"
#include "world/reference.h"

/* The reference picture and, for each pixel, how far it may be trusted. */
static double reference_picture(const struct test_scene *test, lx_bounded picture[ROWS][COLUMNS])
{
    double maximum = 0;
    for (unsigned row = 0; row < ROWS; row++)
        for (unsigned column = 0; column < COLUMNS; column++) {
            struct lx_element element;
            picture[row][column] = lx_exact(0);
            if (!lx_element_seen(&test->prepared, lx_column_x_mm(&test->scene.screen, column),
                                 lx_row_y_mm(&test->scene.screen, row), &element))
                continue;
            for (size_t i = 0; i < test->prepared.emitters.count; i++) {
                struct lx_lighting light = lx_light_element(&test->prepared, &element, &test->lights[i]);
                picture[row][column] = lx_add(picture[row][column], lx_add(light.diffuse, light.specular));
            }
            maximum = fmax(maximum, picture[row][column].value);
        }
    return maximum;
}

/* A row in float32 is the same, but for roundings, and ends where it ends. */
static void check_single(const struct lx_plan *plan, struct lx_shader_memory *memory, const double *values,
                         const uint8_t *mask)
{
    float singles[COLUMNS + 1];
    uint8_t single_mask[COLUMNS + 1];
    singles[COLUMNS] = -1, single_mask[COLUMNS] = 7;
    lx_shade_row_single(plan, memory, 0, NULL, false, singles, single_mask);
    assert_memory_equal(mask, single_mask, COLUMNS);
    assert_true(singles[COLUMNS] == -1 && single_mask[COLUMNS] == 7);
    for (unsigned column = 0; column < COLUMNS; column++)
        assert_true(fabs((double)singles[column] - values[column]) <= 0x1p-23 * values[column] + (double)FLT_MIN);
}

static double worst_pixel(const struct test_scene *test, const struct lx_kernels *kernels, luxel_precision precision,
                          lx_bounded picture[ROWS][COLUMNS], double maximum, double *share_single)
{
    struct lx_plan plan;
    double x[LX_BLOCK], values[LX_BLOCK], one[LX_BLOCK], worst = 0, bound = precision == LUXEL_DOUBLE ? 1e-11 : 2e-6;
    uint8_t mask[LX_BLOCK];
    const luxel_settings settings = {.precision = precision};
    assert_int_equal(lx_plan_make(&test->prepared, kernels, &settings, &plan), LUXEL_OK);
    struct lx_shader_memory *memory = lx_shader_memory_new(&plan);
    assert_non_null(memory);
    assert_ptr_equal(plan.kernels, kernels);
    size_t singles = 0, lights = 0;
    for (size_t s = 0; s < plan.surface_count; s++)
        for (size_t i = 0; i < plan.surfaces[s].run_count; i++) {
            lights += plan.surfaces[s].runs[i].count;
            singles += plan.surfaces[s].runs[i].in_double ? 0 : plan.surfaces[s].runs[i].count;
        }
    *share_single = lights ? (double)singles / (double)lights : 0;
    for (unsigned row = 0; row < ROWS; row++) {
        double y = lx_row_y_mm(&test->scene.screen, row);
        for (unsigned column = 0; column < COLUMNS; column++)
            x[column] = lx_column_x_mm(&test->scene.screen, column);
        lx_shader_enter(&plan, memory, &y, 1, x, COLUMNS);
        lx_shade_row(&plan, memory, 0, NULL, false, values, mask);
        check_single(&plan, memory, values, mask);
        unsigned alone = (row * 31) % COLUMNS;
        lx_shader_enter(&plan, memory, &y, 1, &x[alone], 1);
        lx_shade_row(&plan, memory, 0, NULL, false, one, mask);
        assert_memory_equal(&one[0], &values[alone], sizeof one[0]);
        for (unsigned column = 0; column < COLUMNS; column++) {
            lx_bounded exact = picture[row][column];
            assert_true(isfinite(values[column]) && values[column] >= 0);
            /* Where the exact value itself jumps within the rounding of float64, either side is right. */
            if (exact.error > bound / 10 * maximum)
                continue;
            double off = fabs(values[column] - exact.value);
            if (maximum > 0)
                worst = fmax(worst, off / maximum);
        }
    }
    lx_shader_memory_free(memory);
    lx_plan_clear(&plan);
    return worst;
}

static void make_with_spheres(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 1)};
    make_random_scene(&random, false, test);
}

static void make_with_plates(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 1)};
    make_random_scene(&random, true, test);
}

/* A direction at right angles to a unit vector. */
static void across(struct randomness *random, const double unit[3], double way[3])
{
    double off[3], along = 0, length = 0;
    random_direction(random, off);
    for (int i = 0; i < 3; i++)
        along += off[i] * unit[i];
    for (int i = 0; i < 3; i++) {
        way[i] = off[i] - along * unit[i];
        length = hypot(length, way[i]);
    }
    for (int i = 0; i < 3; i++)
        way[i] /= length;
}

/*
 * A sphere or plate through P = (0, 0, 1000), which is in the middle of the picture, and one point S.  P lies where
 * highlights are gated, or in the penumbra of the point's cone or at its ends; the picture shows much around it, or a
 * few of the steps that float32 has there.
 */
static void make_edge_scene(struct randomness *random, bool is_gated, bool is_plate, struct test_scene *test)
{
    static const double middle[3] = {0, 0, 1000};
    const double radius = logarithmic(random, 30, 600), distance = logarithmic(random, 100, 10000);
    double normal[3], to_light[3], side[3], turn[3], axis[3];
    make_random_scene(random, false, test);
    do
        random_direction(random, normal);
    while (normal[2] < 0.2);
    across(random, normal, side);
    const double above = is_gated ? 0 : uniform(random, 0.2, 1.5);
    for (int i = 0; i < 3; i++) {
        to_light[i] = cos(above) * side[i] + sin(above) * normal[i];
        test->spheres[0].center_mm[i] = middle[i] - radius * normal[i];
    }
    test->spheres[0].radius_mm = radius;
    test->plates[0] = (struct lx_plate_parameters){.size_mm = {radius, radius}};
    memcpy(test->plates[0].center_mm, middle, sizeof middle);
    memcpy(test->plates[0].axis, normal, sizeof normal);
    const struct lx_surface_kind *kind = kind_called(is_plate ? "rectangle" : "sphere");
    const void *parameters = is_plate ? (const void *)&test->plates[0] : &test->spheres[0];
    const struct lx_material material = {.model = pick(random, 2),
                                         .highlight = is_gated ? LX_HIGHLIGHT_GATED : LX_HIGHLIGHT_PLAIN,
                                         .diffuse = uniform(random, 0.1, 1),
                                         .specular = uniform(random, 0.1, 1),
                                         .shininess = uniform(random, 1, 20)};
    test->surfaces[0] = (struct lx_prepared_surface){.kind = kind,
                                                     .parameters = parameters,
                                                     .shape = lx_surface_shape(kind, parameters),
                                                     .lobe = lx_lobe_prepare(&material)};
    kind->extent(parameters, test->surfaces[0].low_mm, test->surfaces[0].high_mm);

    const double outer = uniform(random, 0.1, 90), narrow = logarithmic(random, 1e-3, outer);
    const enum lx_falloff falloff = (enum lx_falloff)(1 + pick(random, 4));
    const double inner = falloff == LX_HARD ? outer : outer - narrow;
    const double share = pick(random, 3) ? uniform(random, 0, 1) : pick(random, 2);
    const double angle = (inner + share * (outer - inner)) * M_PI / 180;
    across(random, to_light, turn);
    for (int i = 0; i < 3; i++)
        axis[i] = -cos(angle) * to_light[i] + sin(angle) * turn[i];
    test->lights[0] = (struct lx_emitter){
        .type = LX_POINT,
        .strength = logarithmic(random, 0.01, 10000),
        .attenuation = (enum lx_attenuation)pick(random, LX_LAWS),
        .k_mm = logarithmic(random, 10, 2000),
        .coefficients = {uniform(random, 0, 2), pick(random, 2), logarithmic(random, 1e-3, 10)},
        .profile = is_gated ? lx_profile_isotropic()
                            : lx_profile_cone(lx_unit3(lx_exact3(axis)), falloff, inner, outer, pick(random, 2)),
    };
    if (is_gated && pick(random, 3) == 0) {
        test->lights[0].type = LX_DIRECTION;
        test->lights[0].towards = lx_unit3(lx_exact3(to_light));
    }
    for (int i = 0; i < 3; i++)
        test->lights[0].position_mm[i] = middle[i] + distance * to_light[i];
    /* as bright as the point may be: what float32 makes of it counts, however dim it is there */
    const double meters = distance / 1000, k_meters = test->lights[0].k_mm / 1000;
    const double laws[] = {[LX_INVERSE_SQUARE] = 1 / (meters * meters),
                           [LX_PRACTICAL] = 1 / (k_meters + meters),
                           [LX_NO_ATTENUATION] = 1,
                           [LX_POLYNOMIAL] = lx_by_polynomial(test->lights[0].coefficients, meters)};
    const double law = test->lights[0].type == LX_POINT ? laws[test->lights[0].attenuation] : 1;
    test->lights[1] = (struct lx_emitter){
        .type = LX_UNIFORM, .strength = law * test->lights[0].strength / test->surfaces[0].lobe.ambient.value};
    test->scene.screen.width_mm = logarithmic(random, 1e-4, 100);
    test->scene.screen.height_mm = test->scene.screen.width_mm * ROWS / COLUMNS;
    test->prepared.surface_count = 1;
    test->prepared.emitters.count = 2;
    test->prepared.shadows = false;
}

static void make_with_edges(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0xD1B54A32D192ED03) * ((uint64_t)i + 1)};
    make_edge_scene(&random, i % 4 == 0, i % 4 == 1, test);
}

/* Nothing but wide highlights, whose feet are the steeper the less their exponents are above 1. */
static void make_with_wide_highlights(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0xA0761D6478BD642F) * ((uint64_t)i + 1)};
    make_random_scene(&random, i % 2 == 0, test);
    for (size_t k = 0; k < test->prepared.surface_count; k++) {
        struct lx_lobe *lobe = &test->surfaces[k].lobe;
        lobe->diffuse = lx_exact(0);
        lobe->exponent = pick(&random, 2) ? uniform(&random, 1, 3) : 1 + pick(&random, 3);
    }
}

/* The share of the lights that are in float32. */
static double check_precision(luxel_precision precision, void (*make)(int i, struct test_scene *test), double bound)
{
    static lx_bounded picture[ROWS][COLUMNS];
    const int scenes = scenes_to_try(250);
    double worst = 0, single = 0;
    int pictures = 0;
    for (int i = 0; i < scenes; i++) {
        struct test_scene test;
        make(i, &test);
        double maximum = reference_picture(&test, picture);
        for (size_t k = 0; lx_kernels_get(k); k++) {
            const struct lx_kernels *kernels = lx_kernels_get(k);
            double share;
            if (!kernels->runs())
                continue;
            double off = worst_pixel(&test, kernels, precision, picture, maximum, &share);
            single += share;
            pictures++;
            if (off > bound)
                print_message("# scene %d, %s: off by %.3g of the maximum\n", i, kernels->name, off);
            worst = fmax(worst, off);
        }
    }
    print_message("# worst pixel: %.3g of the maximum; %.0f %% of the lights in float32\n", worst,
                  100 * single / pictures);
    assert_true(worst <= bound);
    return single / pictures;
}

static void test_single(void **state)
{
    (void)state;
    check_precision(LUXEL_SINGLE, make_with_spheres, 2e-6);
}

static void test_double(void **state)
{
    (void)state;
    check_precision(LUXEL_DOUBLE, make_with_spheres, 1e-11);
}

static void test_plates_single(void **state)
{
    (void)state;
    check_precision(LUXEL_SINGLE, make_with_plates, 2e-6);
}

static void test_plates_double(void **state)
{
    (void)state;
    check_precision(LUXEL_DOUBLE, make_with_plates, 1e-11);
}

static void test_edges(void **state)
{
    (void)state;
    assert_true(check_precision(LUXEL_SINGLE, make_with_edges, 2e-6) > 0.5);
}

static void test_wide_highlights(void **state)
{
    (void)state;
    assert_true(check_precision(LUXEL_SINGLE, make_with_wide_highlights, 2e-6) > 0.25);
    check_precision(LUXEL_DOUBLE, make_with_wide_highlights, 1e-11);
}

static void test_choice(void **state)
{
    (void)state;
    size_t count = 0;
    while (lx_kernels_get(count))
        count++;
    const struct lx_kernels *generic = lx_kernels_get(count - 1);
    assert_ptr_equal(lx_kernels_choose("generic"), generic);
    assert_null(lx_kernels_choose("z80"));
    setenv("LUXEL_ISA", "generic", 1);
    assert_ptr_equal(lx_kernels_choose(NULL), generic);
    unsetenv("LUXEL_ISA");
    for (size_t i = 0; lx_kernels_get(i); i++)
        if (lx_kernels_get(i)->runs())
            assert_ptr_equal(lx_kernels_choose(lx_kernels_get(i)->name), lx_kernels_get(i));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_choice),          cmocka_unit_test(test_single),        cmocka_unit_test(test_double),
        cmocka_unit_test(test_plates_single),   cmocka_unit_test(test_plates_double), cmocka_unit_test(test_edges),
        cmocka_unit_test(test_wide_highlights),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

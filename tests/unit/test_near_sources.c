/* SPDX-License-Identifier: MIT */
/*
 * Sources that are large against their distance: a sky as a disk, a light table, the rim of a ball, a wire along
 * a plate, of which part is seen at thousands of times the size of the rest.  Their highlights keep the tolerance, and
 * the work on them does not grow with the ratio of lengths: it is counted, in calls between files of the library,
 * beside the work on a square of that size.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/evaluator.h>

#include "base/larger.h"
#include "campaign.h"
#include "picture/patch.h"
#include "picture/sight.h"
#include "scenes.h"
#include "world/integral/sweep.h"
#include "wrapped.h"

static unsigned work;

WRAPPED(void, lx_see, const struct lx_receivers *receivers, const struct lx_sampled *source,
        const struct lx_patch *patch, const struct lx_cell *cell, double hardly, struct lx_sight *sight)
{
    work++;
    REAL(lx_see)(receivers, source, patch, cell, hardly, sight);
}

WRAPPED(void, lx_cell_samples, const struct lx_patch *patch, const struct lx_cell *cell, unsigned side, double gain,
        size_t first, struct lx_samples_double *samples)
{
    work++;
    REAL(lx_cell_samples)(patch, cell, side, gain, first, samples);
}

WRAPPED(void, lx_round_samples, const struct lx_patch *patch, double from_s, double to_s, unsigned rings,
        unsigned spokes, double off, double gain, struct lx_samples_double *samples)
{
    work++;
    REAL(lx_round_samples)(patch, from_s, to_s, rings, spokes, off, gain, samples);
}

WRAPPED(struct lx_arc, lx_sweep_arc, const struct lx_sweep *sweep, double x)
{
    work++;
    return REAL(lx_sweep_arc)(sweep, x);
}

/* -- the scenes -- */

enum kind { SQUARE, DISK, SLAB, BALL, TUBE, NEEDLE, BOX, KINDS };

static const char *const names[KINDS] = {"square", "disk", "slab", "ball", "tube", "needle", "box"};

struct near_scene {
    enum kind kind;
    double radius, gap; /* half the size of the source; from the nearest place of the surface */
    bool is_plate;
    double aside; /* the source, along x */
    const char *material, *law;
    unsigned columns, rows;
};

static void describe_source(const struct near_scene *near, char *text, size_t size)
{
    const double r = near->radius, x = near->aside, z = 1000 + near->gap;
    switch (near->kind) {
    case SQUARE:
        snprintf(text, size, "type: planar, rectangle: {center: [%.17g, 0, %.17g], size: [%.17g, %.17g]}", x, z, 2 * r,
                 2 * r);
        return;
    case NEEDLE:
        snprintf(text, size, "type: planar, rectangle: {center: [%.17g, 0, %.17g], size: [%.17g, 1]}", x, z, 2 * r);
        return;
    case DISK: snprintf(text, size, "type: planar, disk: {center: [%.17g, 0, %.17g], radius: %.17g}", x, z, r); return;
    case SLAB:
        snprintf(text, size, "type: volume, cylinder: {center: [%.17g, 0, %.17g], radius: %.17g, height: 2}", x, z + 1,
                 r);
        return;
    case TUBE:
        snprintf(text, size,
                 "type: volume, cylinder: {center: [%.17g, 0, %.17g], radius: 1, height: %.17g, axis: [1, 0, 0]}", x,
                 z + 1, 2 * r);
        return;
    case BALL:
        snprintf(text, size, "type: volume, sphere: {center: [%.17g, 0, %.17g], radius: %.17g}", x, z + r, r);
        return;
    default:
        snprintf(text, size, "type: volume, box: {center: [%.17g, 0, %.17g], size: [%.17g, %.17g, %.17g]}", x, z + r,
                 2 * r, 2 * r, 2 * r);
    }
}

static luxel_scene *scene_of(const struct near_scene *near)
{
    char source[400], text[1200];
    luxel_scene *scene = NULL;
    describe_source(near, source, sizeof source);
    snprintf(text, sizeof text,
             "luxel: 1\n"
             "screen: {width: %u, height: %u, resolution: [%u, %u]}\n"
             "observer: {z: 1500}\n"
             "surfaces: [{type: %s, material: {%s}}]\n"
             "lights: [{%s, radiance: 1, attenuation: %s}]\n",
             near->columns * 20, near->rows * 20, near->columns, near->rows,
             near->is_plate ? "rectangle, center: [0, 0, 1000], size: [600, 500]"
                            : "sphere, center: [0, 0, 700], radius: 300",
             near->material, source, near->law);
    assert_int_equal(luxel_scene_read_text(text, strlen(text), "near", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_field *render(const luxel_scene *scene)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.threads = 1;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

/* -- that the tolerance is kept -- */

/* xorshift64*: the same scenes on every machine */
static double uniform(uint64_t *state, double low, double high)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return low + (high - low) * ((double)((*state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

/* Checks each pixel; returns whether all were known well enough for that to say something. */
static bool check_pixels(const luxel_scene *scene, int index)
{
    luxel_evaluator *evaluator = NULL;
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_field *field = render(scene);
    const double maximum = luxel_field_statistics(field)->maximum.value;
    bool is_known = maximum > 0;
    for (unsigned row = 0; row < luxel_field_rows(field); row++)
        for (unsigned column = 0; column < luxel_field_columns(field); column++) {
            luxel_value exact;
            luxel_evaluate_screen(evaluator, luxel_field_x_mm(field)[column], luxel_field_y_mm(field)[row], &exact,
                                  NULL);
            const double off = fabs(luxel_field_value(field, column, row) - exact.value);
            is_known = is_known && exact.error <= 1e-4 * maximum;
            if (!(off <= 1e-3 * maximum + exact.error))
                print_message("# scene %d, pixel %u, %u: off by %.3g of the maximum\n", index, column, row,
                              off / maximum);
            assert_true(off <= 1e-3 * maximum + exact.error);
        }
    luxel_field_free(field);
    luxel_evaluator_free(evaluator);
    return is_known;
}

static void test_tolerance(void **state)
{
    (void)state;
    static const char *const models[] = {"blinn-phong", "phong"}, *const highlights[] = {"plain", "gated", "cosine"};
    static const char *const laws[] = {"inverse-square", "inverse-square", "practical, k: 300", "none"};
    const int scenes = scenes_to_try(42);
    uint64_t random = UINT64_C(0x9E3779B97F4A7C15);
    int known = 0;
    for (int i = 0; i < scenes; i++) {
        char material[200];
        const double shininess = exp(uniform(&random, log(0.5), log(3000))), diffuse = uniform(&random, 0, 0.3);
        const double specular = uniform(&random, 0.3, 1), radius = exp(uniform(&random, log(1e2), log(1e10)));
        const double gap = exp(uniform(&random, log(1e-2), log(lx_smaller(1e6, radius))));
        const double aside =
            uniform(&random, -1, 1) < 0 ? uniform(&random, -100, 100) : uniform(&random, -1, 1) * radius;
        snprintf(material, sizeof material,
                 "model: %s, highlight: %s, shininess: %.17g, diffuse: %.17g, specular: %.17g", models[i % 2],
                 highlights[i / 2 % 3], shininess, diffuse, specular);
        const struct near_scene near = {(enum kind)(i % KINDS), radius, gap, i / 3 % 2, aside, material,
                                        laws[i / 5 % 4],        5,      3};
        luxel_scene *scene = scene_of(&near);
        known += check_pixels(scene, i);
        luxel_scene_free(scene);
    }
    print_message("# %d of %d known well\n", known, scenes);
    assert_true(known >= 3 * scenes / 4);
}

/* A diffuse integral that took all the work that one may take leaves its own to the highlight, which is no 0 then. */
static void test_highlight_after_much_work(void **state)
{
    (void)state;
    const struct near_scene near = {TUBE,
                                    814631760.7049545,
                                    0.057934978878329664,
                                    false,
                                    -44.26763928161228,
                                    "highlight: gated, shininess: 524, diffuse: 0.25, specular: 0.886",
                                    "none",
                                    5,
                                    3};
    luxel_evaluator *evaluator = NULL;
    luxel_scene *scene = scene_of(&near);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_field *field = render(scene);
    const double maximum = luxel_field_statistics(field)->maximum.value;
    luxel_value exact;
    luxel_evaluate_screen(evaluator, 40, 0, &exact, NULL);
    assert_true(exact.error < 1e-2 * exact.value);
    assert_true(fabs(luxel_field_value(field, 4, 1) - exact.value) <= 1e-3 * maximum + exact.error);
    luxel_field_free(field);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

/* -- that the work does not grow -- */

static unsigned work_of(enum kind kind, double radius, double gap, bool is_plate, const char *material)
{
    const struct near_scene near = {kind, radius, gap, is_plate, 30, material, "inverse-square", 16, 6};
    luxel_scene *scene = scene_of(&near);
    work = 0;
    luxel_field_free(render(scene));
    luxel_scene_free(scene);
    return work;
}

/* No kind takes much more than the square, and no ratio of lengths much more than another. */
static void check_work(double gap, bool is_plate, const char *material)
{
    const double radii[] = {1e5, 1e7, 1e10};
    unsigned first[KINDS], wrong = 0;
    for (int r = 0; r < 3; r++) {
        unsigned square = 0;
        for (enum kind kind = SQUARE; kind < KINDS; kind++) {
            const unsigned own = work_of(kind, radii[r], gap, is_plate, material);
            square = kind == SQUARE ? own : square;
            first[kind] = r == 0 ? own : first[kind];
            if (own > 0 && own <= 2 * square && own <= 5 * first[kind])
                continue;
            print_message("# a %s of %g mm at %g mm: %u, of 1e5 mm %u, a square %u\n", names[kind], radii[r], gap, own,
                          first[kind], square);
            wrong++;
        }
    }
    assert_int_equal(wrong, 0);
}

static void test_work(void **state)
{
    (void)state;
    check_work(1, false, "shininess: 20");
    check_work(100, true, "shininess: 50, model: phong");
    check_work(1700, false, "shininess: 20, highlight: gated");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tolerance),
        cmocka_unit_test(test_highlight_after_much_work),
        cmocka_unit_test(test_work),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

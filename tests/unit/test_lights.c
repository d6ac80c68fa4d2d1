/* SPDX-License-Identifier: MIT */
/*
 * The kernels' constants of lights: those of each emitter, and that windows over lists of single lights, small clouds
 * and large ones, aimed or not, hold those of the emitters that they stand for, in whatever order they are asked for.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "format/cloud.h"
#include "picture/lights.h"
#include "random_scenes.h"

static const double anchor[3] = {10, -20, 700};

extern const struct lx_surface_kind lx_sphere_kind;

static const struct lx_shape sphere = {
    .type = LX_SPHERE, .kind = &lx_sphere_kind, .anchor_mm = {0, 0, 1000}, .radius_mm = 300};

/* What the header says of each number, plainly. */
static void assert_constants(const struct lx_emitter *emitter, const struct lx_light_double *light)
{
    static const double units[] = {
        [LX_INVERSE_SQUARE] = 1e6, [LX_PRACTICAL] = 1e3, [LX_NO_ATTENUATION] = 1, [LX_POLYNOMIAL] = 1};
    static const enum lx_kernel_light kinds[] = {[LX_INVERSE_SQUARE] = LX_BY_SQUARE,
                                                 [LX_PRACTICAL] = LX_BY_SUM,
                                                 [LX_NO_ATTENUATION] = LX_UNATTENUATED,
                                                 [LX_POLYNOMIAL] = LX_PROFILED};
    const struct lx_profile *profile = &emitter->profile;
    if (emitter->type != LX_POINT) {
        assert_true(light->kind == LX_DISTANT && light->gain == emitter->strength);
        assert_true(light->x == emitter->towards.x.value && light->y == emitter->towards.y.value);
        assert_true(light->z == emitter->towards.z.value);
        return;
    }
    bool is_plain = profile->falloff == LX_NO_CONE && profile->exponent == 0;
    assert_int_equal(light->kind, is_plain ? kinds[emitter->attenuation] : LX_PROFILED);
    assert_true(light->x == emitter->position_mm[0] - anchor[0] && light->y == emitter->position_mm[1] - anchor[1]);
    assert_true(light->z == emitter->position_mm[2] - anchor[2] && light->k == emitter->k_mm);
    assert_true(light->gain == emitter->strength * units[emitter->attenuation]);
    assert_true(light->by_none == emitter->coefficients[0] && light->by_root == emitter->coefficients[1]);
    assert_true(light->by_square == emitter->coefficients[2]);
    assert_true(light->law == emitter->attenuation && light->falloff == profile->falloff);
    assert_true(light->axis_x == profile->axis.x.value && light->axis_y == profile->axis.y.value);
    assert_true(light->axis_z == profile->axis.z.value && light->exponent.value == profile->exponent);
    if (profile->falloff == LX_NO_CONE || profile->falloff == LX_HARD) {
        assert_true(light->edge_slope == 0);
        assert_true(profile->falloff == LX_NO_CONE || light->edge == profile->outer_versine.value);
    } else if (profile->falloff == LX_LINEAR) {
        assert_true(light->edge == profile->outer_rad.value);
        assert_true(light->edge_slope == 1 / (profile->outer_rad.value - profile->inner_rad.value));
    } else {
        assert_true(light->edge == profile->outer_versine.value);
        assert_true(light->edge_slope == 1 / (profile->outer_versine.value - profile->inner_versine.value));
    }
}

static void constants(void **state)
{
    struct randomness random = {.state = 71};
    (void)state;
    for (int i = 0; i < 500; i++) {
        struct lx_emitter emitter = random_emitter(&random, &sphere);
        struct lx_light_double light;
        lx_light_set(&emitter, anchor, &light);
        assert_constants(&emitter, &light);
        struct lx_light_single single = lx_light_single_of(&light);
        assert_true(single.x == (float)light.x && single.y == (float)light.y && single.z == (float)light.z);
        assert_true(single.gain == (float)light.gain && single.k == (float)light.k && single.kind == light.kind);
        assert_true(single.axis_x == (float)light.axis_x && single.axis_y == (float)light.axis_y);
        assert_true(single.axis_z == (float)light.axis_z && single.law == light.law);
        assert_true(single.edge == (float)light.edge && single.edge_slope == (float)light.edge_slope);
        assert_true(single.falloff == light.falloff && single.exponent.value == (float)light.exponent.value);
        assert_true(single.exponent.whole == light.exponent.whole);
    }
    assert_true(lx_exponent_of(7).whole == 7 && lx_exponent_of(7.5).whole == 0 && lx_exponent_of(7.5).value == 7.5);
    assert_true(lx_exponent_of(65536).whole == 65536 && lx_exponent_of(65537).whole == 0);
}

/* -- lists -- */

enum { SMALL = 50, LARGE = LX_MOST_STORED + 700, CLOUDS = 4, SINGLE_LIGHTS = 40 };

struct lists {
    struct lx_emitters emitters;
    struct lx_lights lights;
    struct lx_cloud clouds[CLOUDS];
};

static void *rows_of(struct randomness *random, size_t count, bool is_single)
{
    void *values = malloc(count * LX_CLOUD_COLUMNS * (is_single ? sizeof(float) : sizeof(double)));
    assert_non_null(values);
    for (size_t i = 0; i < count * LX_CLOUD_COLUMNS; i++) {
        double value = i % 4 == 3 ? uniform(random, 0, 5) : uniform(random, -900, 900);
        if (is_single)
            ((float *)values)[i] = (float)value;
        else
            ((double *)values)[i] = value;
    }
    return values;
}

/* Single lights, and clouds of which the second and the last are large, one of them aimed. */
static void make_lists(struct randomness *random, struct lists *lists)
{
    memset(lists, 0, sizeof *lists);
    memcpy(lists->lights.anchor_mm, anchor, sizeof anchor);
    for (int i = 0; i < SINGLE_LIGHTS; i++) {
        struct lx_emitter emitter = random_emitter(random, &sphere);
        emitter.type = emitter.type == LX_UNIFORM ? LX_POINT : emitter.type;
        assert_int_equal(lx_emitters_append(&lists->emitters, &emitter), 0);
        if (i % 10 != 9)
            continue;
        int c = i / 10;
        struct lx_cloud *cloud = &lists->clouds[c];
        cloud->count = c % 2 ? LARGE : SMALL;
        cloud->is_single = c > 1;
        cloud->values = rows_of(random, cloud->count, cloud->is_single);
        struct lx_emitter model = random_emitter(random, &sphere);
        model.type = LX_POINT;
        const struct lx_point_set set = {
            .cloud = cloud, .model = model, .is_aimed = c == 0 || c == 3, .aim_mm = {30, 40, 950}};
        assert_int_equal(lx_emitters_append_point_set(&lists->emitters, &set), 0);
    }
    struct lx_emitter_span span = {0};
    while (lx_emitters_next(&lists->emitters, &span)) {
        if (span.set)
            assert_int_equal(lx_lights_append_point_set(&lists->lights, span.set), 0);
        for (size_t i = span.first; i < span.end && !span.set; i++)
            assert_int_equal(lx_lights_append(&lists->lights, lx_span_at(&span, i, NULL)), 0);
    }
    assert_true(lists->lights.count == lists->emitters.count && lists->lights.cloud_count == 2);
    assert_true(lists->lights.count == SINGLE_LIGHTS + 2 * SMALL + 2 * LARGE);
    assert_true(lists->lights.stored == SINGLE_LIGHTS + 2 * SMALL);
}

static void clear_lists(struct lists *lists)
{
    lx_lights_clear(&lists->lights);
    lx_emitters_clear(&lists->emitters);
    for (int c = 0; c < CLOUDS; c++)
        free(lists->clouds[c].values);
}

static void assert_window(const struct lists *lists, size_t first, size_t count, struct lx_light_room *room)
{
    const struct lx_light_double *exacts = lx_lights_double(&lists->lights, first, count, room);
    const struct lx_light_single *singles = lx_lights_single(&lists->lights, first, count, room);
    for (size_t k = 0; k < count; k++) {
        struct lx_emitter made;
        const struct lx_emitter *emitter = lx_emitter_at(&lists->emitters, first + k, &made);
        assert_constants(emitter, &exacts[k]);
        const struct lx_light_single expected = lx_light_single_of(&exacts[k]);
        /* float32 numbers may be made without the float64 ones between them */
        assert_true(fabsf(singles[k].x - expected.x) <= 1e-4F && fabsf(singles[k].y - expected.y) <= 1e-4F);
        assert_true(fabsf(singles[k].z - expected.z) <= 1e-4F);
        assert_true(fabsf(singles[k].gain - expected.gain) <= 1e-6F * expected.gain);
        assert_true(singles[k].axis_x == expected.axis_x && singles[k].axis_y == expected.axis_y);
        assert_true(singles[k].axis_z == expected.axis_z && singles[k].kind == expected.kind);
        assert_true(singles[k].k == expected.k && singles[k].edge == expected.edge && singles[k].law == expected.law);
        assert_true(singles[k].edge_slope == expected.edge_slope && singles[k].falloff == expected.falloff);
        assert_true(singles[k].exponent.value == expected.exponent.value);
    }
}

static void windows(void **state)
{
    static struct lx_light_room room;
    struct randomness random = {.state = 72};
    struct lists lists;
    (void)state;
    make_lists(&random, &lists);
    /* where a list ends and another begins */
    const size_t ends[] = {0,
                           10,
                           10 + SMALL,
                           20 + SMALL,
                           20 + SMALL + LARGE,
                           30 + SMALL + LARGE,
                           30 + 2 * SMALL + LARGE,
                           40 + 2 * SMALL + LARGE,
                           lists.lights.count};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        for (size_t before = 0; before <= LX_MOST_IN_RUN; before++)
            for (size_t count = 1; count <= LX_MOST_IN_RUN; count++)
                if (ends[i] >= before && ends[i] - before + count <= lists.lights.count)
                    assert_window(&lists, ends[i] - before, count, &room);
    for (int i = 0; i < 3000; i++) {
        size_t count = 1 + (size_t)pick(&random, LX_MOST_IN_RUN);
        assert_window(&lists, (size_t)uniform(&random, 0, (double)(lists.lights.count - count)), count, &room);
    }
    for (size_t first = 0; first + LX_MOST_IN_RUN <= lists.lights.count; first += LX_MOST_IN_RUN)
        assert_window(&lists, first, LX_MOST_IN_RUN, &room);
    clear_lists(&lists);
}

/* An emitter of a list is the same, whichever way it is asked for. */
static void spans(void **state)
{
    struct randomness random = {.state = 73};
    struct lists lists;
    (void)state;
    make_lists(&random, &lists);
    struct lx_emitter_span span = {0};
    struct lx_emitter one, other;
    size_t seen = 0;
    while (lx_emitters_next(&lists.emitters, &span)) {
        assert_true(span.first == seen && span.end > span.first);
        for (size_t i = span.first; i < span.end; i++, seen++) {
            const struct lx_emitter *by_span = lx_span_at(&span, i, &one);
            const struct lx_emitter *by_number = lx_emitter_at(&lists.emitters, i, &other);
            double row[4];
            lx_emitter_row(&lists.emitters, i, row);
            assert_memory_equal(by_span->position_mm, by_number->position_mm, sizeof by_span->position_mm);
            assert_true(by_span->strength == by_number->strength && by_span->type == by_number->type);
            assert_true(by_span->profile.axis.x.value == by_number->profile.axis.x.value);
            if (by_number->type == LX_POINT) {
                assert_memory_equal(row, by_number->position_mm, sizeof by_number->position_mm);
                assert_true(row[3] == by_number->strength);
            }
            if (!span.set)
                continue;
            double expected[LX_CLOUD_COLUMNS];
            lx_cloud_row(span.set->cloud, i - span.first, expected);
            assert_memory_equal(row, expected, sizeof row);
            if (!span.set->is_aimed)
                continue;
            double way[3], length = 0;
            for (int k = 0; k < 3; k++) {
                way[k] = span.set->aim_mm[k] - row[k];
                length = hypot(length, way[k]);
            }
            assert_true(fabs(by_number->profile.axis.x.value - way[0] / length) < 1e-14);
            assert_true(fabs(by_number->profile.axis.z.value - way[2] / length) < 1e-14);
        }
    }
    assert_true(seen == lists.emitters.count);
    clear_lists(&lists);
}

/* Emitters belong to the light that they were appended for, before clouds, in them and behind them. */
static void owners(void **state)
{
    struct randomness random = {.state = 74};
    struct lx_emitters emitters = {0};
    struct lx_cloud cloud = {.count = SMALL, .values = rows_of(&random, SMALL, false)};
    size_t owner[9 * SMALL], light = 0;
    (void)state;
    for (int turn = 0; turn < 6; turn++, light++) {
        size_t first = emitters.count;
        struct lx_emitter model = random_emitter(&random, &sphere);
        model.type = LX_POINT;
        emitters.light = light;
        if (turn % 2) {
            const struct lx_point_set set = {.cloud = &cloud, .model = model};
            assert_int_equal(lx_emitters_append_point_set(&emitters, &set), 0);
        } else {
            for (int i = 0; i <= turn; i++)
                assert_int_equal(lx_emitters_append(&emitters, &model), 0);
        }
        for (size_t i = first; i < emitters.count; i++)
            owner[i] = light;
    }
    assert_true(emitters.count == 3 * SMALL + 1 + 3 + 5);
    for (size_t i = 0; i < emitters.count; i++) {
        struct lx_emitter room;
        assert_true(lx_emitter_at(&emitters, i, &room)->light == owner[i]);
    }
    lx_emitters_clear(&emitters);
    free(cloud.values);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants),
        cmocka_unit_test(windows),
        cmocka_unit_test(spans),
        cmocka_unit_test(owners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

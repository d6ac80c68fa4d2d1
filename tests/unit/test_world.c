/* SPDX-License-Identifier: MIT */
/*
 * Batches of elements against the reference, element by element: value and bound to the last bit, by every instruction
 * set, wherever an element stands in the batch, over random scenes of all sources, laws, profiles, lobes and shadows
 * and elements on surfaces, beside them, at lights, at the edges of shadows, very near and very far.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "random_scenes.h"
#include "world/evaluate.h"
#include "world/world.h"

enum { SCENES = 10000 };

/* Equal, where 0 has no sign. */
static bool is_same(const struct lx_column *column, size_t i, lx_bounded expected)
{
    const bool is_number = expected.error == expected.error;
    return column->value[i] == expected.value && (!is_number || column->error[i] == expected.error);
}

static void on_surface(struct randomness *random, const struct lx_shape *shape, double place[3], double normal[3])
{
    if (shape->type == LX_SPHERE) {
        random_direction(random, normal);
        for (int k = 0; k < 3; k++)
            place[k] = shape->anchor_mm[k] + shape->radius_mm * normal[k];
        return;
    }
    const double u = uniform(random, -1, 1) * shape->half_mm[0], v = uniform(random, -1, 1) * shape->half_mm[1];
    for (int k = 0; k < 3; k++) {
        place[k] = shape->anchor_mm[k] + u * shape->across[k] + v * shape->upward[k];
        normal[k] = shape->axis[k];
    }
}

/* A place on the edge of the shadow that a surface throws from a light, or just beside it. */
static void at_shadow(struct randomness *random, const struct lx_shape *shape, const struct lx_emitter *light,
                      double place[3])
{
    double edge[3], side[3];
    random_direction(random, side);
    const double size = shape->type == LX_SPHERE ? shape->radius_mm : shape->half_mm[0];
    const double beyond = uniform(random, 1, 3), off = 1 + uniform(random, -1, 1) * logarithmic(random, 1e-16, 1e-2);
    for (int k = 0; k < 3; k++) {
        edge[k] = shape->anchor_mm[k] + size * off * (shape->type == LX_SPHERE ? side[k] : shape->across[k]);
        place[k] = light->position_mm[k] + beyond * (edge[k] - light->position_mm[k]);
    }
}

static luxel_place random_place(struct randomness *random, const struct test_scene *test)
{
    luxel_place place = {.is_element = true};
    const struct lx_shape *shape = &test->surfaces[pick(random, (int)test->prepared.surface_count)].shape;
    const struct lx_emitter *light = &test->lights[pick(random, (int)test->prepared.emitters.count)];
    random_direction(random, place.normal);
    const int kind = pick(random, 8);
    if (kind < 4) {
        double own[3];
        on_surface(random, shape, place.position_mm, own);
        for (int k = 0; k < 3 && kind > 0; k++)
            place.normal[k] = kind == 3 ? -own[k] : own[k] + (kind == 2 ? 0.002 * place.normal[k] : 0);
        for (int k = 0; k < 3 && pick(random, 8) == 0; k++)
            place.normal[k] = k == 0 ? -own[1] : k == 1 ? own[0] : 0;
    } else if (kind == 4 && light->type == LX_POINT) {
        at_shadow(random, shape, light, place.position_mm);
    } else if (kind == 5 && light->type == LX_POINT) {
        memcpy(place.position_mm, light->position_mm, sizeof place.position_mm);
        place.position_mm[pick(random, 3)] += pick(random, 2) ? 0 : logarithmic(random, 1e-20, 1);
    } else {
        double way[3];
        random_direction(random, way);
        const double far = pick(random, 8) ? logarithmic(random, 0.01, 1e5) : logarithmic(random, 1e-300, 1e300);
        for (int k = 0; k < 3; k++)
            place.position_mm[k] = (pick(random, 8) ? shape->anchor_mm[k] : 0) + far * way[k];
    }
    if (place.normal[0] == 0 && place.normal[1] == 0 && place.normal[2] == 0)
        place.normal[2] = 1;
    const double length = pick(random, 4) ? 1 : logarithmic(random, 1e-300, 1e300);
    for (int k = 0; k < 3; k++)
        place.normal[k] *= length;
    return place;
}

static void add_lighting(struct lx_lighting more, struct lx_lighting *sum)
{
    sum->irradiance = lx_add(sum->irradiance, more.irradiance);
    sum->diffuse = lx_add(sum->diffuse, more.diffuse);
    sum->specular = lx_add(sum->specular, more.specular);
    sum->on_element = more.on_element;
}

/* The lights of a batch, emitter by emitter as the reference has them. */
static void assert_batch(const struct lx_world *world, const struct lx_elements *elements,
                         const struct lx_element *expected)
{
    const struct lx_prepared *prepared = world->prepared;
    for (size_t first = 0; first < prepared->emitters.count;) {
        const size_t light = prepared->emitters.items[first].light;
        size_t next = first;
        struct lx_received received, part;
        lx_world_light_of(world, elements, light, (enum lx_wanted)(LX_WANT_IRRADIANCE | LX_WANT_BRIGHTNESS), NULL,
                          &next, &received);
        size_t again = first;
        lx_world_light_of(world, elements, light, LX_WANT_BRIGHTNESS, NULL, &again, &part);
        assert_true(again == next && next > first);
        for (size_t i = 0; i < elements->count; i++) {
            struct lx_lighting sum = {.irradiance = lx_exact(0), .diffuse = lx_exact(0), .specular = lx_exact(0)};
            for (size_t k = first; k < next && !sum.on_element; k++)
                add_lighting(lx_light_element(prepared, &expected[i], &prepared->emitters.items[k]), &sum);
            assert_true(received.on_element[i] == sum.on_element && part.on_element[i] == sum.on_element);
            if (sum.on_element)
                continue;
            assert_true(is_same(&received.irradiance, i, sum.irradiance));
            assert_true(is_same(&received.diffuse, i, sum.diffuse) && is_same(&part.diffuse, i, sum.diffuse));
            assert_true(is_same(&received.specular, i, sum.specular) && is_same(&part.specular, i, sum.specular));
        }
        first = next;
    }
}

static void set_lights(struct randomness *random, struct test_scene *test)
{
    size_t light = 0;
    for (size_t i = 0; i < test->prepared.emitters.count; i++) {
        light += i > 0 && pick(random, 2);
        test->lights[i].light = light;
        test->lights[i].is_part = pick(random, 8) == 0;
        test->lights[i].strength_error = pick(random, 4) ? 0 : 1e-16 * test->lights[i].strength;
    }
    test->prepared.shadows_on_free = pick(random, 4) > 0;
}

static bool are_close(lx_bounded3 a, lx_bounded3 b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static void test_free_elements(void **state)
{
    struct randomness random = {20261126};
    (void)state;
    for (int scene = 0; scene < SCENES; scene++) {
        struct test_scene test;
        make_random_scene(&random, scene % 2 == 1, &test);
        set_lights(&random, &test);
        const int count = 1 + pick(&random, pick(&random, 4) ? 12 : LX_BATCH);
        const bool has_views = pick(&random, 3) == 0;
        luxel_place places[LX_BATCH];
        struct lx_element expected[LX_BATCH];
        for (int i = 0; i < count; i++) {
            places[i] = random_place(&random, &test);
            places[i].has_view = has_views;
            random_direction(&random, places[i].view);
            expected[i] = lx_element_at(&test.prepared, &places[i]);
            expected[i].lobe = &test.surfaces[0].lobe;
        }
        const struct lx_kernels *kernels;
        for (size_t k = 0; (kernels = lx_kernels_get(k)); k++) {
            const struct lx_world world = {.prepared = &test.prepared, .kernels = lx_element_kernels_of(kernels)};
            struct lx_elements elements;
            if (!kernels->runs())
                continue;
            lx_elements_begin(&elements, &test.surfaces[0].lobe, true);
            for (int i = 0; i < count; i++)
                lx_elements_append_place(&elements, lx_exact3(places[i].position_mm), lx_exact3(places[i].normal),
                                         has_views ? places[i].view : NULL);
            lx_elements_end(&elements);
            lx_world_settle(&world, &(struct lx_settling){.has_views = has_views}, &elements);
            for (int i = 0; i < count; i++) {
                const struct lx_element made = lx_elements_get(&test.prepared, &elements, (size_t)i);
                assert_true(made.own == expected[i].own && made.is_free);
                assert_true(are_close(lx_add3(made.normal, lx_exact3((double[]){0, 0, 0})),
                                      lx_add3(expected[i].normal, lx_exact3((double[]){0, 0, 0}))));
                assert_true(made.view.z.value == expected[i].view.z.value ||
                            !(expected[i].view.z.value == expected[i].view.z.value));
                assert_true(made.view.z.error == expected[i].view.z.error ||
                            !(expected[i].view.z.error == expected[i].view.z.error));
            }
            assert_batch(&world, &elements, expected);
            for (int i = 0; i < count && i < 4; i++) { /* on their own, where cubes of distances are numbers */
                if (!(lx_length3(expected[i].place_mm).value < 1e100))
                    continue;
                lx_elements_of_one(&test.prepared, &expected[i], &elements);
                assert_batch(&world, &elements, &expected[i]);
            }
        }
    }
}

/* What is seen is not free: it never loses light to its own surface. */
static void test_seen_elements(void **state)
{
    struct randomness random = {771};
    (void)state;
    for (int scene = 0; scene < SCENES; scene++) {
        struct test_scene test;
        make_random_scene(&random, scene % 2 == 1, &test);
        set_lights(&random, &test);
        struct lx_element seen[LX_BATCH];
        struct lx_elements elements;
        lx_elements_begin(&elements, &test.surfaces[0].lobe, false);
        for (int i = 0; i < 12; i++) {
            struct lx_element *element = &seen[elements.count];
            if (!lx_element_seen(&test.prepared, uniform(&random, -335, 335), uniform(&random, -265, 265), element))
                continue;
            element->lobe = elements.lobe;
            lx_elements_append(&test.prepared, &elements, element);
        }
        if (elements.count == 0)
            continue;
        lx_elements_end(&elements);
        const struct lx_kernels *kernels;
        for (size_t k = 0; (kernels = lx_kernels_get(k)); k++)
            if (kernels->runs())
                assert_batch(&(struct lx_world){.prepared = &test.prepared, .kernels = lx_element_kernels_of(kernels)},
                             &elements, seen);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_free_elements),
        cmocka_unit_test(test_seen_elements),
    };
    return cmocka_run_group_tests_name("batches of elements are lit as the reference lights each", tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Trees over boxes: what they find is what asking each box finds, in order, and they ask few. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

#include "world/boxes.h"

enum { COUNT = 3000, ROUNDS = 300 };

static uint64_t state_of_chance = 7;

static double chance(void)
{
    state_of_chance = state_of_chance * 6364136223846793005u + 1442695040888963407u;
    return (double)(state_of_chance >> 11) * 0x1p-53;
}

/* Small boxes in a cube of side 1000, some flat, every hundredth long. */
static void fill(struct lx_box *boxes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            const double size = i % 100 == 0 ? 800 * chance() : i % 7 == (size_t)k ? 0 : 20 * chance();
            boxes[i].low[k] = 1000 * chance() - size / 2;
            boxes[i].high[k] = boxes[i].low[k] + size;
        }
}

/* A way that counts how often it was asked for. */
struct counted {
    struct lx_box_way way;
    size_t asked;
};

static bool counts(const void *data, const double low[3], const double high[3])
{
    struct counted *counted = (struct counted *)data;
    counted->asked++;
    return lx_box_way_meets(&counted->way, low, high);
}

static struct lx_box_way random_way(int round)
{
    double from[3], way[3];
    for (int k = 0; k < 3; k++) {
        from[k] = 1000 * chance();
        way[k] = round % 5 == k ? 0 : 2000 * (chance() - 0.5) * (round % 2 ? 1 : 0.05);
    }
    return lx_box_way_of(from, way, round % 3 == 0 ? 5 * chance() : 0, round % 4 == 0);
}

/* Returns how many of that many boxes are found by random ways, and how many tests that took. */
static size_t find_all(size_t count, size_t *asked)
{
    struct lx_box *boxes = calloc(count, sizeof *boxes);
    struct lx_boxes tree;
    size_t all = 0;
    fill(boxes, count);
    assert_int_equal(lx_boxes_make(boxes, count, &tree), 0);
    for (int round = 0; round < ROUNDS; round++) {
        struct counted way = {random_way(round), 0};
        struct lx_found found, on_way;
        size_t next = 0;
        assert_true(lx_boxes_find(&tree, counts, &way, &found));
        assert_true(lx_boxes_find_on_way(&tree, &way.way, &on_way));
        assert_int_equal(on_way.count, found.count);
        assert_memory_equal(on_way.items, found.items, found.count * sizeof *found.items);
        *asked += way.asked;
        for (size_t i = 0; i < count; i++)
            if (lx_box_way_meets(&way.way, boxes[i].low, boxes[i].high)) {
                assert_true(next < found.count);
                assert_int_equal(found.items[next++], i);
                assert_true(lx_is_among(found.items, found.count, (uint32_t)i));
            } else {
                assert_false(lx_is_among(found.items, found.count, (uint32_t)i));
            }
        assert_int_equal(next, found.count);
        all += next;
    }
    lx_boxes_clear(&tree);
    free(boxes);
    return all;
}

static void finds_what_each_tells(void **state)
{
    (void)state;
    size_t asked = 0;
    assert_true(find_all(LX_FEW_BOXES, &asked) > 0);
    asked = 0;
    assert_true(find_all(COUNT, &asked) > 300);
    assert_true(asked < (size_t)ROUNDS * COUNT / 4);
}

static void ways_meet_where_they_lead(void **state)
{
    (void)state;
    struct lx_box boxes[200];
    size_t met = 0;
    fill(boxes, 200);
    for (int round = 0; round < ROUNDS; round++) {
        const double from[3] = {1000 * chance(), 1000 * chance(), 1000 * chance()};
        const double along[3] = {900 * (chance() - 0.5), round % 3 ? 900 * (chance() - 0.5) : 0,
                                 900 * (chance() - 0.5)};
        const struct lx_box_way way = lx_box_way_of(from, along, 0, false);
        for (size_t i = 0; i < 200; i++)
            for (int step = 0; step <= 100; step++) {
                bool is_inside = true;
                for (int k = 0; k < 3; k++) {
                    const double at = from[k] + along[k] * step / 100;
                    is_inside = is_inside && at >= boxes[i].low[k] && at <= boxes[i].high[k];
                }
                if (is_inside)
                    assert_true(lx_box_way_meets(&way, boxes[i].low, boxes[i].high));
                met += is_inside;
            }
    }
    assert_true(met > 100);
}

static void says_when_each_is_to_be_asked(void **state)
{
    (void)state;
    struct lx_box *boxes = calloc(COUNT, sizeof *boxes);
    struct lx_boxes tree;
    struct lx_found found;
    fill(boxes, COUNT);
    assert_int_equal(lx_boxes_make(boxes, 0, &tree), 0);
    assert_false(lx_boxes_find(&tree, lx_box_way_meets, NULL, &found));
    lx_boxes_clear(&tree);
    for (size_t i = 0; i < COUNT; i++) /* endless, or all at one place */
        for (int k = 0; k < 3; k++)
            boxes[i].low[k] = i % 2 ? -HUGE_VAL : 5, boxes[i].high[k] = i % 2 ? HUGE_VAL : 5;
    assert_int_equal(lx_boxes_make(boxes, COUNT, &tree), 0);
    const struct lx_box_way way = lx_box_way_of((double[]){0, 0, 0}, (double[]){1, 0, 0}, 1, true);
    assert_false(lx_boxes_find(&tree, lx_box_way_meets, &way, &found));
    lx_boxes_clear(&tree);
    assert_int_equal(lx_boxes_make(boxes, 2 * LX_FEW_BOXES, &tree), 0);
    assert_true(lx_boxes_find(&tree, lx_box_way_meets, &way, &found));
    assert_int_equal(found.count, LX_FEW_BOXES);
    lx_boxes_clear(&tree);
    free(boxes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_what_each_tells),
        cmocka_unit_test(ways_meet_where_they_lead),
        cmocka_unit_test(says_when_each_is_to_be_asked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * Sheets by their types: coordinates lead to places and back, areas are those of the map, what reaches farthest, which
 * side is turned to a place, and rims that lie on the surface.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/vector.h"
#include "surface/sheet.h"

enum { KINDS = 6 };

static double between(double low, double high)
{
    return low + (high - low) * (rand() / (RAND_MAX + 1.0));
}

/* A sheet of each type, turned and placed at random; a hollow ball as the last one. */
static struct lx_smooth_sheet random_sheet(int kind)
{
    static const struct lx_sheet_type *const types[KINDS] = {&lx_plate_sheet, &lx_triangle_sheet, &lx_disk_sheet,
                                                             &lx_tube_sheet,  &lx_ball_sheet,     &lx_ball_sheet};
    struct lx_smooth_sheet sheet = {.type = types[kind], .turn = kind == 5 || (kind < 4 && rand() % 2) ? -1 : 1};
    double corners[3][3];
    for (int i = 0; i < 9; i++)
        corners[i / 3][i % 3] = between(-100, 100);
    if (kind == 1 && lx_sheet_of_triangle((const double(*)[3])corners, &sheet)) {
        assert_true(sheet.type == types[kind]);
        return sheet;
    }
    for (int i = 0; i < 3; i++) {
        sheet.center_mm[i] = between(-100, 100);
        sheet.axis[i] = between(-1, 1);
    }
    lx_normalize(sheet.axis);
    lx_around_axis(sheet.axis, sheet.across, sheet.upward);
    sheet.half_mm[0] = between(20, 100);
    sheet.half_mm[1] = kind == 2 ? between(0, 15) : between(20, 100);
    sheet.middle = kind == 2 || kind == 3 ? M_PI / 4 * (1 + 2 * (rand() % 4)) : 0;
    return sheet;
}

static void difference(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[i] - b[i];
}

static void test_coordinates(void **state)
{
    (void)state;
    for (int trial = 0; trial < 3000; trial++) {
        const struct lx_smooth_sheet sheet = random_sheet(trial % KINDS);
        const double s = between(-0.99, 0.99), t = between(-0.99, 0.99), step = 1e-5;
        double place[3], normal[3], other[3], ways[2][3], back[3], across[3], at[2];
        const double area = lx_sheet_place(&sheet, s, t, place, normal);
        lx_sheet_locate(&sheet, place, at);
        assert_true(fabs(at[0] - s) < 1e-9 && fabs(at[1] - t) < 1e-9);
        for (int way = 0; way < 2; way++) {
            lx_sheet_place(&sheet, s + (way ? 0 : step), t + (way ? step : 0), back, other);
            lx_sheet_place(&sheet, s - (way ? 0 : step), t - (way ? step : 0), across, other);
            difference(back, across, ways[way]);
        }
        lx_cross(ways[0], ways[1], across);
        const double seen = sqrt(lx_dot(across, across)) / (4 * step * step);
        assert_true(fabs(seen - area) < 1e-6 * area);
        assert_true(fabs(fabs(lx_dot(across, normal)) / (4 * step * step) - area) < 1e-6 * area);
        assert_true(lx_sheet_distance(&sheet, place) < 1e-9);
    }
}

/* Nothing goes beyond what it reaches, and something comes near; of sectors all four together. */
static void test_reach(void **state)
{
    (void)state;
    for (int trial = 0; trial < 300; trial++) {
        struct lx_smooth_sheet sheet = random_sheet(trial % KINDS);
        const struct lx_smooth_sheet whole = sheet;
        const bool is_ball = sheet.type->bends == 2, is_sector = !is_ball && sheet.type->corner_count == 0;
        double direction[3] = {between(-1, 1), between(-1, 1), between(-1, 1)}, farthest = -HUGE_VAL;
        lx_normalize(direction);
        const double reach = whole.type->reach(&whole, direction);
        for (int part = 0; part < (is_ball ? 6 : is_sector ? 4 : 1); part++) {
            sheet.middle = is_sector ? M_PI / 4 * (1 + 2 * part) : whole.middle;
            if (is_ball) {
                const double sign = part < 3 ? 1 : -1;
                for (int i = 0; i < 3; i++) {
                    sheet.axis[i] = i == part % 3 ? sign : 0;
                    sheet.across[i] = i == (part + 1) % 3 ? sign : 0;
                    sheet.upward[i] = i == (part + 2) % 3;
                }
            }
            for (int i = 0; i < 41 * 41; i++) {
                double place[3], normal[3], from[3];
                lx_sheet_place(&sheet, i % 41 / 20.0 - 1, i / 41 / 20.0 - 1, place, normal);
                difference(place, sheet.center_mm, from);
                farthest = fmax(farthest, lx_dot(from, direction));
            }
        }
        assert_true(farthest <= reach + 1e-9 && farthest > reach - 0.01 * (fabs(reach) + 1));
    }
}

/* A place of a sheet is turned to an eye where its normal is: on the near side of the plane that tells. */
static void test_facing(void **state)
{
    size_t partly = 0;
    (void)state;
    for (int trial = 0; trial < 6000; trial++) {
        const struct lx_smooth_sheet sheet = random_sheet(3 + trial % 3);
        double eye[3], place[3], out[3], way[3], normal[3] = {0}, through[3] = {0};
        for (int i = 0; i < 3; i++)
            eye[i] = sheet.center_mm[i] + between(-300, 300);
        lx_sheet_place(&sheet, between(-1, 1), between(-1, 1), place, out);
        difference(eye, place, way);
        const bool is_turned = lx_dot(way, out) > 0;
        const enum lx_sheet_facing facing = sheet.type->facing(&sheet, eye, 1e-9, normal, through);
        difference(place, through, way);
        const double beyond = lx_dot(way, normal);
        partly += facing == LX_FACES_PARTLY;
        if (facing == LX_FACES_WHOLLY)
            assert_true(is_turned);
        else if (facing == LX_FACES_PARTLY && fabs(beyond) > 1e-6)
            assert_true(is_turned == (beyond < 0));
        else if (facing == LX_FACES_NOT && sheet.turn > 0)
            assert_false(is_turned);
    }
    assert_true(partly > 2000);
}

struct rim {
    const struct lx_smooth_sheet *sheet;
    struct lx_origin light;
    size_t count;
};

static bool look_at(void *data, const double from_mm[3], const double to_mm[3], const double inside_mm[3])
{
    struct rim *rim = data;
    double length[3], aside[3];
    difference(to_mm, from_mm, length);
    difference(inside_mm, from_mm, aside);
    assert_true(lx_sheet_distance(rim->sheet, from_mm) < 1e-9);
    assert_true(lx_dot(length, length) > 0 && lx_dot(aside, aside) > 0);
    rim->count++;
    return rim->count < 1000;
}

static bool take_one(void *data, const double from_mm[3], const double to_mm[3], const double inside_mm[3])
{
    size_t *count = data;
    (void)from_mm, (void)to_mm, (void)inside_mm;
    ++*count;
    return false;
}

/* As many pieces as are asked for, and no more once whoever takes them has enough. */
static void test_rims(void **state)
{
    (void)state;
    for (int trial = 0; trial < 600; trial++) {
        const struct lx_smooth_sheet sheet = random_sheet(trial % KINDS);
        struct rim rim = {.sheet = &sheet, .light = {.endless = true}};
        size_t taken = 0;
        if (!sheet.type->rim)
            continue;
        for (int i = 0; i < 3; i++)
            rim.light.at[i] = between(-1, 1);
        sheet.type->rim(&sheet, &rim.light, 12, look_at, &rim);
        const size_t expected = sheet.type == &lx_plate_sheet                          ? 4
                                : sheet.type == &lx_tube_sheet                         ? 26
                                : sheet.type == &lx_disk_sheet && sheet.half_mm[1] > 0 ? 24
                                                                                       : 12;
        assert_int_equal(rim.count, expected);
        sheet.type->rim(&sheet, &rim.light, 12, take_one, &taken);
        assert_int_equal(taken, 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_coordinates),
        cmocka_unit_test(test_reach),
        cmocka_unit_test(test_facing),
        cmocka_unit_test(test_rims),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

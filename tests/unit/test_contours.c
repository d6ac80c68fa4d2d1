/* SPDX-License-Identifier: MIT */
/*
 * Contours in wide numbers, each of both ways to their area against Lambert's sum over the polygon that the horizon
 * leaves, to all digits that the sums promise; which side of a face a place is on; and the rule of Gauss against
 * Legendre's polynomial.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "light/gauss.h"
#include "light/solid/facets.h"
#include "light/solid/facets_contour.h"
#include "light/solid/facets_plain.h"
#include "random_scenes.h"

static void assert_near(double found, double expected, double most)
{
    if (!(fabs(found - expected) <= most))
        fail_msg("%.17g instead of %.17g", found, expected);
}

/* -- Lambert's sum, plainly -- */

enum { CORNERS = 3, MOST = CORNERS + 1 };

/* The part of a triangle that is above the horizon. */
static int clip(const lx_wide3 corners[CORNERS], lx_wide3 normal, lx_wide3 left[MOST])
{
    int count = 0;
    for (int i = 0; i < CORNERS; i++) {
        lx_wide3 a = corners[i], b = corners[(i + 1) % CORNERS];
        lx_wide from = lx_wide3_dot(normal, a), to = lx_wide3_dot(normal, b);
        if (from.high >= 0)
            left[count++] = a;
        if ((from.high >= 0) != (to.high >= 0))
            left[count++] = lx_wide3_add(a, lx_wide3_mul(lx_wide3_sub(b, a), lx_wide_div(from, lx_wide_sub(from, to))));
    }
    return count;
}

/* The sum of theta (N.g) over the edges; *size is what it was summed of. */
static lx_wide lambert(const lx_wide3 *corners, int count, lx_wide3 normal, double *size)
{
    lx_wide sum = lx_wide_of(0);
    *size = 0;
    for (int i = 0; i < count; i++) {
        lx_wide3 a = corners[i], b = corners[(i + 1) % count], g = lx_wide3_cross(a, b);
        lx_wide length = lx_wide3_length(g), theta = lx_wide_atan2(length, lx_wide3_dot(a, b));
        lx_wide term = lx_wide_mul(theta, lx_wide_div(lx_wide3_dot(normal, g), length));
        *size += fabs(theta.high);
        sum = lx_wide_add(sum, term);
    }
    return sum;
}

/* -- triangles -- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A vector with digits beyond those of float64. */
static lx_wide3 with_more_digits(struct randomness *random, const double v[3])
{
    lx_wide3 wide = lx_wide3_of(v);
    double more[3];
    for (int k = 0; k < 3; k++)
        more[k] = 0x1p-54 * v[k] * uniform(random, -1, 1);
    return lx_wide3_add(wide, lx_wide3_of(more));
}

struct triangle {
    lx_wide3 place, normal, corners[CORNERS], ways[CORNERS];
    double nearest;
};

/* Some way off in a direction, with corners so far from its middle, by the height above the horizon and across. */
static struct triangle random_triangle(struct randomness *random, double size, double lowest, double highest)
{
    struct triangle triangle;
    double normal[3], middle[3], place[3], farthest = 0;
    random_direction(random, normal);
    do
        random_direction(random, middle);
    while (fabs(dot(normal, middle)) > 0.9);
    double lean = dot(normal, middle), middle_height = uniform(random, lowest, highest);
    for (int k = 0; k < 3; k++)
        middle[k] -= lean * normal[k];
    double length = sqrt(dot(middle, middle));
    for (int k = 0; k < 3; k++) {
        middle[k] = middle[k] / length + middle_height * normal[k];
        place[k] = uniform(random, -1, 1);
    }
    triangle.place = lx_wide3_of(place);
    for (int i = 0; i < CORNERS; i++) {
        double off[3], corner[3], height = uniform(random, lowest, highest);
        random_direction(random, off);
        double rise = dot(off, normal) * size - height + middle_height;
        for (int k = 0; k < 3; k++)
            corner[k] = place[k] + middle[k] + size * off[k] - rise * normal[k];
        triangle.corners[i] = with_more_digits(random, corner);
        triangle.ways[i] = lx_wide3_sub(triangle.corners[i], triangle.place);
        farthest = fmax(farthest, lx_wide3_length(lx_wide3_sub(triangle.ways[i], lx_wide3_of(middle))).high);
    }
    double stretch = uniform(random, 0.5, 2);
    for (int k = 0; k < 3; k++)
        normal[k] *= stretch;
    triangle.normal = lx_wide3_of(normal);
    triangle.nearest = 1 - farthest;
    return triangle;
}

static double off(lx_wide a, lx_wide b)
{
    return fabs(lx_wide_sub(a, b).high);
}

/* Polygons of all sizes, above the horizon, cut by it, and below it. */
static void contours(void **state)
{
    struct randomness random = {.state = 5};
    unsigned seen = 0, crossed = 0;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        struct triangle triangle = random_triangle(&random, logarithmic(&random, 0.003, 0.8), i % 2 ? -0.4 : 0, 0.5);
        lx_wide3 left[MOST];
        double size;
        struct lx_contour contour =
            lx_contour_start(triangle.corners, triangle.place, triangle.normal, i % 3 ? 1 : 0.25, 0.1);
        int count = clip(triangle.ways, triangle.normal, left);
        lx_wide expected = lambert(left, count, triangle.normal, &size);
        unsigned base = 0;
        while (base < CORNERS && lx_contour_height(&contour, base).high < 0)
            base++;
        assert_int_equal(base<CORNERS, count> 0);
        if (count == 0)
            continue;
        lx_contour_set_base(&contour, base);
        for (unsigned k = 0; k < CORNERS; k++)
            lx_contour_add(&contour, k, (k + 1) % CORNERS, 0);
        double bound = contour.error + 0x1p-94 * size;
        assert_true(off(contour.sum, expected) <= bound && contour.error <= 0x1p-84 * size);
        assert_true(contour.corners_error == 0);
        seen++;
        crossed += contour.crossed;
    }
    assert_true(seen > 3000 && crossed > 1000 && crossed < seen - 1000);
}

/* In float64, of all sizes, many of them slivers: within the bound of Lambert's sum, and good enough to be used where a
 * triangle is above the horizon and no sliver. */
static void plain_contours(void **state)
{
    struct randomness random = {.state = 7};
    unsigned seen = 0, good = 0, wide = 0, good_of_wide = 0;
    (void)state;
    for (int i = 0; i < 4000; i++) {
        const double lowest = i % 2 ? -0.4 : 0.2;
        struct triangle triangle = random_triangle(&random, logarithmic(&random, 1e-6, 0.8), lowest, 0.5);
        const double place[3] = {triangle.place.x.high, triangle.place.y.high, triangle.place.z.high};
        const double normal[3] = {triangle.normal.x.high, triangle.normal.y.high, triangle.normal.z.high};
        const struct lx_facets facets = {.corners_mm = triangle.corners};
        struct lx_plain_contour contour = lx_plain_start(&facets, place, normal, i % 3 ? 1 : 0.25);
        lx_wide3 left[MOST];
        double size;
        const int count = clip(triangle.ways, triangle.normal, left);
        const lx_wide expected = lambert(left, count, triangle.normal, &size);
        for (unsigned k = 0; k < CORNERS; k++)
            lx_plain_add(&contour, k, (k + 1) % CORNERS);
        assert_true(off(lx_wide_of(contour.sum.value), expected) <= contour.sum.error + 0x1p-94 * size ||
                    !(contour.sum.error < HUGE_VAL));
        const bool is_good = contour.sum.error <= 0x1p-43 * fabs(expected.high);
        seen += count > 0;
        good += is_good;
        const bool is_wide = lowest > 0 && fabs(expected.high) > 0.02 * size * size;
        wide += is_wide;
        good_of_wide += is_wide && is_good;
    }
    assert_true(seen > 3000 && good < seen && wide > 200 && good_of_wide > 0.95 * wide);
}

/* By the integral of z^2, where all is low: 2^-64 of it is promised, and more is kept. */
static void low_contours(void **state)
{
    struct randomness random = {.state = 6};
    (void)state;
    for (int i = 0; i < 1000; i++) {
        struct triangle triangle = random_triangle(&random, uniform(&random, 0.1, 0.7), i % 2 ? -0.02 : 0, 0.03);
        lx_wide3 left[MOST];
        double size;
        if (triangle.nearest < 0.25)
            continue;
        struct lx_contour contour =
            lx_contour_start(triangle.corners, triangle.place, triangle.normal, 1, triangle.nearest);
        lx_wide expected = lambert(left, clip(triangle.ways, triangle.normal, left), triangle.normal, &size);
        struct lx_low_area low = {.failed = false};
        for (unsigned k = 0; k < CORNERS; k++)
            lx_contour_add_low(&contour, k, (k + 1) % CORNERS, &low);
        assert_false(low.failed);
        assert_true(off(low.sum, expected) <= 0x1p-78 * size);
        assert_true(off(low.sum, expected) <= low.error + 0x1p-94 * size);
    }
}

/* A long edge that passes near by, anywhere along it, comes to as much as its parts do: each is cut into pieces of its
 * own, which are as short as they must be where it is nearest. */
static void long_edges(void **state)
{
    struct randomness random = {.state = 16};
    (void)state;
    for (int i = 0; i < 1000; i++) {
        const double length = logarithmic(&random, 1, 1000), foot = uniform(&random, -0.2, 1.2) * length;
        const double ends[2][3] = {{-foot, 1, uniform(&random, 0.02, 0.1)},
                                   {length - foot, 1, uniform(&random, 0.02, 0.1)}};
        const lx_wide3 from = lx_wide3_of(ends[0]), to = lx_wide3_of(ends[1]);
        const lx_wide3 half = lx_wide3_mul(lx_wide3_add(from, to), lx_wide_of(0.5)),
                       quarter = lx_wide3_mul(lx_wide3_add(from, half), lx_wide_of(0.5));
        const lx_wide3 corners[4] = {from, quarter, half, to};
        struct lx_contour contour =
            lx_contour_start(corners, lx_wide3_of((double[]){0, 0, 0}), lx_wide3_of((double[]){0, 0, 1}), 1, 1);
        struct lx_low_area whole = {.failed = false}, parts = {.failed = false};
        lx_contour_add_low(&contour, 0, 3, &whole);
        for (unsigned k = 0; k < 3; k++)
            lx_contour_add_low(&contour, k, k + 1, &parts);
        assert_false(whole.failed || parts.failed);
        assert_true(whole.sum.high != 0);
        assert_true(off(whole.sum, parts.sum) <= 0x1p-64 * fabs(whole.sum.high));
        assert_true(off(whole.sum, parts.sum) <= whole.error + parts.error);
    }
}

/* An edge that is wrong by some length sweeps about as much times its length, seen from above, over the square. */
static void wrong_corners(void **state)
{
    const double corners[3][3] = {{-1, -1, 1}, {1, -1, 1}, {0, 2, 1}};
    lx_wide3 wide[3], place = lx_wide3_of((const double[]){0, 0, 0}), up = lx_wide3_of((const double[]){0, 0, 1});
    (void)state;
    for (int k = 0; k < 3; k++)
        wide[k] = lx_wide3_of(corners[k]);
    struct lx_contour contour = lx_contour_start(wide, place, up, 1, 1);
    lx_contour_set_base(&contour, 0);
    lx_contour_add(&contour, 0, 1, 1e-12);
    assert_near(contour.corners_error, 4 * 1e-12 * 2 + 4e-24, 1e-26);
    contour = lx_contour_start(wide, place, up, 0.5, 2); /* twice as near as that, from which it is seen under pi */
    lx_contour_set_base(&contour, 0);
    lx_contour_add(&contour, 0, 1, 1e-12);
    assert_near(contour.corners_error, 4 * 0.5e-12 * (0.5 + 0.5e-12) + 4 * 0.25e-24, 1e-26);
}

/* -- heights over faces -- */

/* How high a place above the middle of a rectangle has to be to see it; lengths are doubled until then. */
static double least_height(const struct lx_facets *facets, const double axis[3])
{
    const double length = sqrt(dot(axis, axis));
    double low = 1e-300, high = 1;
    while (high / low > 1 + 1e-9) {
        double middle = sqrt(low) * sqrt(high), place[3];
        for (int k = 0; k < 3; k++)
            place[k] = middle * axis[k] / length;
        lx_bounded found =
            lx_facets_irradiance(facets, lx_exact3(place), lx_exact3((const double[]){-axis[0], -axis[1], -axis[2]}));
        *(found.value > 0 ? &high : &low) = middle;
    }
    return high;
}

/* One that lies across all axes is rounded; from closer than that comes to, no side of it is seen. */
static void sides_of_faces(void **state)
{
    const double origin[3] = {0, 0, 0}, size[2] = {300, 50}, up[3] = {0, 1, 0}, tilted[3] = {0.3, -0.4, 1};
    const double upright[3] = {0, 0, 1};
    (void)state;
    struct lx_facets *facets = lx_facets_of_rectangle(origin, size, tilted, up);
    assert_non_null(facets);
    /* what its corners, and the way from one of them times what a narrow normal is wrong by, are rounded by */
    const double radius = hypot(150, 25), narrow = 700.0 * 700 / (300 * 50);
    assert_near(facets->radius_mm, radius, 1e-9);
    assert_near(facets->corner_error_mm, 0x1p-92 * radius, 0x1p-108 * radius);
    assert_near(least_height(facets, tilted) / (0x1p-92 * radius * (narrow + 2)), 1, 1e-6);
    lx_facets_free(facets);
    facets = lx_facets_of_rectangle(origin, size, upright, up);
    assert_non_null(facets);
    assert_true(least_height(facets, upright) < 1e-200);
    lx_facets_free(facets);
}

/* -- the rule of Gauss -- */

/* P_n(x), and its derivative, by their recurrence. */
static double legendre(int n, double x, double *slope)
{
    double before = 1, now = x;
    for (int k = 1; k < n; k++) {
        double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
        before = now;
        now = next;
    }
    *slope = n * (before - x * now) / (1 - x * x);
    return now;
}

static void nodes(void **state)
{
    double sum = 0;
    (void)state;
    for (int i = 0; i < LX_GAUSS_NODES; i++) {
        const struct lx_gauss_node *node = &lx_gauss[i];
        double slope, value = legendre(LX_GAUSS_NODES, node->place, &slope);
        assert_true(fabs(value / slope) <= 4e-16);
        assert_near(node->weight * (1 - node->place * node->place) * slope * slope, 2, 1e-12);
        assert_true(fabs(node->rest - (1 - node->place)) <= 3e-16);
        sum += node->weight;
    }
    assert_near(sum, 2, 1e-14);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contours),   cmocka_unit_test(plain_contours), cmocka_unit_test(low_contours),
        cmocka_unit_test(long_edges), cmocka_unit_test(wrong_corners),  cmocka_unit_test(sides_of_faces),
        cmocka_unit_test(nodes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

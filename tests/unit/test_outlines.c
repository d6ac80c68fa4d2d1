/* SPDX-License-Identifier: MIT */
/*
 * Outlines and meshes drawn by chance: outlines are cut into convex pieces that make up their area, edges that meet are
 * found as comparing all with all finds them, and what is still flat, straight, convex or of some area is so up to the
 * limits that the code names and not beyond.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "light/solid/facets.h"
#include "random_scenes.h"

typedef const double (*places)[3];

enum { MOST = 60 };

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Two unit vectors that are square to each other, and to what they are seen from. */
static void random_plane(struct randomness *random, double u[3], double v[3], double n[3])
{
    double other[3];
    random_direction(random, u);
    random_direction(random, other);
    cross(u, other, n);
    double length = sqrt(dot(n, n));
    for (int i = 0; i < 3; i++)
        n[i] /= length;
    cross(n, u, v);
}

/* Corners around the origin at any distance; a comb every third time, with teeth. */
static size_t random_outline(struct randomness *random, int kind, double (*xy)[2])
{
    size_t count = 3 + (size_t)pick(random, MOST - 8);
    if (kind % 3 == 2) {
        size_t teeth = 2 + (size_t)pick(random, 12), n = 0;
        for (size_t i = 0; i < teeth; i++) {
            xy[n][0] = 2 * (double)i, xy[n++][1] = uniform(random, 0, 1);
            xy[n][0] = 2 * (double)i + 1, xy[n++][1] = uniform(random, -9, -2);
        }
        xy[n][0] = 2 * (double)teeth, xy[n++][1] = 0;
        xy[n][0] = 2 * (double)teeth - 3, xy[n++][1] = 3;
        xy[n][0] = -1, xy[n++][1] = 2;
        return n;
    }
    for (size_t i = 0; i < count; i++) {
        double turn = 2 * M_PI * ((double)i + uniform(random, 0, 0.8)) / (double)count;
        double away = kind % 3 ? 1 : uniform(random, 0.2, 2);
        xy[i][0] = away * cos(turn), xy[i][1] = away * sin(turn);
    }
    return count;
}

static double doubled_area(const double (*xy)[2], size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += xy[i][0] * xy[(i + 1) % count][1] - xy[(i + 1) % count][0] * xy[i][1];
    return sum;
}

static double turn(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Pieces of convex pieces: how many of them, and of their corners, there are in all tells how well they are joined. */
static void pieces_make_up_the_outline(void **state)
{
    struct randomness random = {.state = 51};
    size_t all_pieces = 0, all_corners = 0;
    (void)state;
    for (int n = 0; n < 300; n++) {
        double xy[MOST][2], corners[MOST][3], u[3], v[3], normal[3], area = 0, size = logarithmic(&random, 1e-5, 1000);
        size_t count = random_outline(&random, n, xy), piece_count = 0;
        struct lx_facets **pieces = NULL;
        random_plane(&random, u, v, normal);
        for (size_t i = 0; i < count; i++)
            for (int k = 0; k < 3; k++)
                corners[i][k] = size * (5 * normal[k] + xy[i][0] * u[k] + xy[i][1] * v[k]);
        assert_int_equal(lx_facets_of_outline((places)corners, count, &pieces, &piece_count).fault, LX_SHAPE_GOOD);
        assert_true(n % 3 != 1 || piece_count == 1); /* those are convex */
        all_pieces += piece_count;
        for (size_t p = 0; p < piece_count; p++) {
            const struct lx_facets *piece = pieces[p];
            double flat[MOST][2], most = 0;
            assert_true(piece->face_count == 1 && piece->corner_count == piece->faces[0].count);
            all_corners += piece->corner_count;
            for (size_t i = 0; i < piece->corner_count; i++) {
                const lx_wide3 *corner = &piece->corners_mm[piece->loop[i]];
                double at[3] = {lx_wide_value(corner->x), lx_wide_value(corner->y), lx_wide_value(corner->z)};
                flat[i][0] = dot(at, u) / size, flat[i][1] = dot(at, v) / size;
                assert_true(fabs(dot(at, normal) / size - 5) < 1e-12);
                double off[3] = {at[0] - piece->center_mm[0], at[1] - piece->center_mm[1], at[2] - piece->center_mm[2]};
                most = fmax(most, sqrt(dot(off, off)));
            }
            assert_true(piece->radius_mm >= most && piece->radius_mm <= most * (1 + 1e-12) + 1e-12 * size);
            for (size_t i = 0; i < piece->corner_count; i++)
                assert_true(turn(flat[i], flat[(i + 1) % piece->corner_count], flat[(i + 2) % piece->corner_count]) >
                            -1e-11);
            assert_true(fabs(doubled_area((const double(*)[2])flat, piece->corner_count) / 2 -
                             piece->area_mm2 / size / size) < 1e-11);
            area += piece->area_mm2 / size / size;
            lx_facets_free(pieces[p]);
        }
        free(pieces);
        double expected = doubled_area((const double(*)[2])xy, count) / 2;
        if (!(fabs(area - expected) < 1e-11 * expected))
            fail_msg("outline %d: %.17g, expected %.17g", n, area, expected);
    }
    if (all_pieces != 2665 || all_corners != 12259)
        fail_msg("%zu pieces with %zu corners", all_pieces, all_corners);
}

/* The first two edges that meet, by comparing all: those of corners swapped by chance. */
static bool edges_meet(const double (*xy)[2], size_t count, size_t i, size_t k)
{
    const double *a = xy[i], *b = xy[i + 1], *c = xy[k], *d = xy[(k + 1) % count];
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

static void crossings_are_found(void **state)
{
    struct randomness random = {.state = 52};
    unsigned crossed = 0;
    (void)state;
    for (int n = 0; n < 400; n++) {
        double xy[MOST][2], corners[MOST][3], u[3], v[3], normal[3];
        size_t count = random_outline(&random, n, xy), piece_count = 0, first = 0, second = 0;
        struct lx_facets **pieces = NULL;
        if (count > 3) {
            double moved[2];
            size_t i = (size_t)pick(&random, (int)count), k = (size_t)pick(&random, (int)count);
            memcpy(moved, xy[i], sizeof moved);
            memcpy(xy[i], xy[k], sizeof moved);
            memcpy(xy[k], moved, sizeof moved);
        }
        bool meet = false;
        for (size_t i = 0; i < count && !meet; i++)
            for (size_t k = i + 2; k < count && !meet; k++)
                if (!(i == 0 && k == count - 1) && edges_meet((const double(*)[2])xy, count, i, k))
                    meet = true, first = i, second = k;
        random_plane(&random, u, v, normal);
        for (size_t i = 0; i < count; i++)
            for (int k = 0; k < 3; k++)
                corners[i][k] = 100 * (xy[i][0] * u[k] + xy[i][1] * v[k]) + 50 * normal[k];
        struct lx_shape_report report = lx_facets_of_outline((places)corners, count, &pieces, &piece_count);
        assert_int_equal(report.fault, meet ? LX_SHAPE_CROSSES : LX_SHAPE_GOOD);
        assert_true(!meet || (report.first == first && report.second == second));
        crossed += meet;
        for (size_t p = 0; p < piece_count; p++)
            lx_facets_free(pieces[p]);
        free(pieces);
    }
    assert_true(crossed > 100 && crossed < 350);
}

/* -- limits -- */

/* They are relative: the same for shapes of any size. */
static double unit_mm = 1;

static const double units_mm[] = {1, 0x1p-30, 0x1p30};

/* The number from which on something is so, between two where it is not and is. */
static double limit_of(bool (*is_so)(double value), double low, double high)
{
    assert_true(!is_so(low) && is_so(high));
    for (int i = 0; i < 60; i++) {
        double middle = sqrt(low * high);
        *(is_so(middle) ? &high : &low) = middle;
    }
    return sqrt(low * high);
}

static struct lx_shape_report try_square(const double (*corners)[3], size_t count, size_t *piece_count)
{
    struct lx_facets **pieces = NULL;
    double scaled[5][3];
    *piece_count = 0;
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            scaled[i][k] = corners[i][k] * unit_mm;
    struct lx_shape_report report = lx_facets_of_outline((places)scaled, count, &pieces, piece_count);
    for (size_t i = 0; i < *piece_count; i++)
        lx_facets_free(pieces[i]);
    free(pieces);
    return report;
}

/* A square of 10 whose corners lie above its plane and below it by turns. */
static bool is_bent(double height)
{
    const double corners[4][3] = {{0, 0, height}, {10, 0, -height}, {10, 10, height}, {0, 10, -height}};
    size_t count;
    return try_square((places)corners, 4, &count).fault == LX_SHAPE_NOT_FLAT;
}

/* The corner from which on a rhombus is told that is 10 long and 4 wide and bent likewise. */
static size_t first_corner;

static bool is_rhombus_bent(double height)
{
    const double corners[4][3] = {{-5, 0, height}, {0, -2, -height}, {5, 0, height}, {0, 2, -height}};
    double told[4][3];
    size_t count;
    for (size_t i = 0; i < 4; i++)
        memcpy(told[i], corners[(first_corner + i) % 4], sizeof told[i]);
    return try_square((places)told, 4, &count).fault == LX_SHAPE_NOT_FLAT;
}

static bool has_area(double width)
{
    const double corners[4][3] = {{0, 0, 0}, {10, 0, 0}, {10, width, 0}, {0, width, 0}};
    size_t count;
    return try_square((places)corners, 4, &count).fault == LX_SHAPE_GOOD;
}

/* A square of 8 with a notch so deep in the middle of a side. */
static bool is_cut(double depth)
{
    const double corners[5][3] = {{0, 0, 0}, {4, depth, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
    size_t count;
    assert_int_equal(try_square((places)corners, 5, &count).fault, LX_SHAPE_GOOD);
    return count > 1;
}

/* Whether the corners of a square of 10, bent as above and 1000 away, were brought into one plane. */
static bool is_flattened(double height)
{
    double corners[4][3] = {{1000, 0, height}, {1010, 0, -height}, {1010, 10, height}, {1000, 10, -height}};
    struct lx_facets **pieces = NULL;
    size_t count = 0;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            corners[i][k] *= unit_mm;
    assert_int_equal(lx_facets_of_outline((places)corners, 4, &pieces, &count).fault, LX_SHAPE_GOOD);
    assert_int_equal(count, 1);
    const double left = lx_wide_value(pieces[0]->corners_mm[0].z);
    const bool moved = fabs(left) != height * unit_mm;
    assert_true(!moved || fabs(left) < 1e-6 * height * unit_mm);
    assert_true(moved == (pieces[0]->corner_error_mm > 0));
    lx_facets_free(pieces[0]);
    free(pieces);
    return moved;
}

static void assert_limit(double found, double expected, const char *what)
{
    if (!(fabs(found / expected - 1) < 1e-4))
        fail_msg("%s: %.9g, expected %.9g", what, found, expected);
}

static void outlines_have_limits(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof units_mm / sizeof *units_mm; i++) {
        unit_mm = units_mm[i];
        assert_limit(limit_of(is_bent, 1e-9, 1), 1e-6 * hypot(10, 10), "flat");
        for (first_corner = 0; first_corner < 4; first_corner++)
            assert_limit(limit_of(is_rhombus_bent, 1e-9, 1), 1e-6 * 10, "flat, whichever corner is the first");
        assert_limit(limit_of(has_area, 1e-30, 1), 0.5e-14 * 10, "area");
        assert_limit(limit_of(is_cut, 1e-20, 1), 0x1p-44 * 2, "straight");
        assert_limit(limit_of(is_flattened, 1e-20, 1e-6), 0x1p-48 * (hypot(10, 10) + 1010), "rounded");
    }
}

/* -- meshes -- */

/* A box of 2 x 2 x `height` whose top has a middle corner, which lies `depth` below it; `lift` as in is_bent(). */
static struct lx_shape_report try_box(double height, double depth, double lift, size_t *face_count, double *radius)
{
    double corners[9][3] = {{-1, -1, -height}, {1, -1, -height}, {-1, 1, -height}, {1, 1, -height}, {-1, -1, lift},
                            {1, -1, -lift},    {-1, 1, -lift},   {1, 1, lift},     {0, 0, -depth}};
    const unsigned flat[] = {4, 5, 7, 6, 0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1};
    const unsigned roof[] = {4, 5, 8, 5, 7, 8, 7, 6, 8, 6, 4, 8, 0, 4, 6, 2,
                             1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1};
    const unsigned flat_counts[] = {4, 4, 4, 4, 4, 4}, roof_counts[] = {3, 3, 3, 3, 4, 4, 4, 4, 4};
    const bool has_roof = depth != 0;
    struct lx_facets *facets = NULL;
    for (size_t i = 0; i < 9; i++)
        for (int k = 0; k < 3; k++)
            corners[i][k] *= unit_mm;
    struct lx_shape_report report =
        lx_facets_of_mesh((places)corners, 9, has_roof ? roof : flat, has_roof ? roof_counts : flat_counts,
                          has_roof ? 9 : 6, NULL, &facets);
    if (report.fault == LX_SHAPE_GOOD) {
        *face_count = facets->face_count;
        *radius = facets->radius_mm / unit_mm;
        lx_facets_free(facets);
    }
    return report;
}

static bool is_pit(double depth)
{
    size_t count;
    double radius;
    return try_box(2, depth, 0, &count, &radius).fault == LX_SHAPE_NOT_CONVEX;
}

static bool is_twisted(double lift)
{
    size_t count;
    double radius;
    return try_box(2, 0, lift, &count, &radius).fault == LX_SHAPE_NOT_FLAT;
}

/* Whether a bent top was cut into two triangles. */
static bool is_folded(double lift)
{
    size_t count = 0;
    double radius;
    assert_int_equal(try_box(2, 0, lift, &count, &radius).fault, LX_SHAPE_GOOD);
    return count == 7;
}

static bool has_volume(double height)
{
    size_t count;
    double radius;
    return try_box(height, 0, 0, &count, &radius).fault == LX_SHAPE_GOOD;
}

static void meshes_have_limits(void **state)
{
    size_t count = 0;
    double radius = 0;
    (void)state;
    for (size_t i = 0; i < sizeof units_mm / sizeof *units_mm; i++) {
        unit_mm = units_mm[i];
        assert_int_equal(try_box(2, 0, 0, &count, &radius).fault, LX_SHAPE_GOOD);
        assert_true(count == 6 && fabs(radius - sqrt(3)) < 1e-14);
        /* a plane of the roof runs from an edge to the middle: twice as deep below the other edge */
        assert_int_equal(try_box(2, 1e-9, 0, &count, &radius).fault, LX_SHAPE_GOOD);
        assert_limit(limit_of(is_pit, 1e-9, 1), 1e-6 * radius, "convex");
        assert_limit(limit_of(is_twisted, 1e-9, 1), 2e-6 * sqrt(3), "flat face");
        assert_limit(limit_of(is_folded, 1e-16, 1e-7), 0x1p-45 * sqrt(3), "bent face");
        /* 4 h/R^3 of a volume, 8 of an area */
        assert_limit(limit_of(has_volume, 1e-30, 1), 2e-14 * sqrt(2), "volume");
    }
}

/* A prism of many sides of which one edge lies within the chord of its neighbours: the first face that has it. */
static void every_dent_is_found(void **state)
{
    enum { SIDES = 40 };
    double corners[2 * SIDES][3];
    unsigned loop[6 * SIDES], counts[SIDES + 2], used = 0;
    (void)state;
    for (unsigned i = 0; i < SIDES; i++) {
        unsigned next = (i + 1) % SIDES;
        memcpy(loop + used, (const unsigned[]){i, next, SIDES + next, SIDES + i}, 4 * sizeof *loop);
        used += 4;
        counts[i] = 4;
    }
    for (unsigned cap = 0; cap < 2; cap++) {
        counts[SIDES + cap] = SIDES;
        for (unsigned i = 0; i < SIDES; i++)
            loop[used++] = cap ? SIDES + i : SIDES - 1 - i;
    }
    for (unsigned dent = 0; dent < SIDES; dent++) {
        for (unsigned i = 0; i < 2 * SIDES; i++) {
            double turn_of = 2 * M_PI * (i % SIDES) / SIDES, away = i % SIDES == dent ? 0.98 : 1;
            corners[i][0] = 100 * away * cos(turn_of), corners[i][1] = 70 * away * sin(turn_of);
            corners[i][2] = i < SIDES ? -20 : 30;
        }
        struct lx_facets *facets = NULL;
        struct lx_shape_report report =
            lx_facets_of_mesh((places)corners, 2 * SIDES, loop, counts, SIDES + 2, NULL, &facets);
        assert_int_equal(report.fault, LX_SHAPE_NOT_CONVEX);
        /* of the two sides at the dent the first one that is listed, and a corner that is beyond it */
        unsigned first = dent == 0 ? 0 : dent - 1, next = (first + 1) % SIDES;
        assert_int_equal(report.first, first);
        assert_true(report.second < 2 * SIDES);
        const double *beyond = corners[report.second];
        assert_true(turn(corners[first], corners[next], beyond) < 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_make_up_the_outline), cmocka_unit_test(crossings_are_found),
        cmocka_unit_test(outlines_have_limits),       cmocka_unit_test(meshes_have_limits),
        cmocka_unit_test(every_dent_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * Making facets: corners, normals, areas and edges of every shape; outlines of all kinds cut into convex pieces, or
 * refused; meshes that are closed, convex and look outwards, or refused with the face that is wrong.
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

typedef const double (*places)[3];

static double height_over(const struct lx_facets *facets, const struct lx_face *face, lx_wide3 place)
{
    return lx_wide_value(
        lx_wide3_dot(face->normal, lx_wide3_sub(place, facets->corners_mm[facets->loop[face->first]])));
}

static lx_wide3 corner_of(const struct lx_facets *facets, const struct lx_face *face, unsigned k)
{
    return facets->corners_mm[facets->loop[face->first + k % face->count]];
}

/* What is so of all facets: flat, convex faces; each edge with its faces; all within the sphere. */
static void assert_sound(const struct lx_facets *facets, double size, bool closed)
{
    double area = 0;
    size_t sides = 0;
    for (size_t i = 0; i < facets->face_count; i++) {
        const struct lx_face *face = &facets->faces[i];
        area += face->area_mm2;
        sides += face->count;
        assert_true(fabs(lx_wide_value(lx_wide3_length(face->normal)) - 1) < 1e-15);
        for (unsigned k = 0; k < face->count; k++) {
            lx_wide3 a = corner_of(facets, face, k), b = corner_of(facets, face, k + 1);
            lx_wide3 turn = lx_wide3_cross(lx_wide3_sub(b, a), lx_wide3_sub(corner_of(facets, face, k + 2), b));
            assert_true(lx_wide_value(lx_wide3_dot(face->normal, turn)) >= -1e-13 * size * size);
            assert_true(fabs(height_over(facets, face, a)) <= 1e-13 * size);
        }
        for (size_t k = 0; k < facets->corner_count && closed; k++)
            assert_true(height_over(facets, face, facets->corners_mm[k]) <= 2e-6 * size);
    }
    assert_true(fabs(area - facets->area_mm2) <= 1e-13 * area);
    assert_int_equal(facets->edge_count, closed ? sides / 2 : sides);
    for (size_t i = 0; i < facets->edge_count; i++) {
        const struct lx_edge *edge = &facets->edges[i];
        bool found = false;
        const struct lx_face *left = &facets->faces[edge->left];
        for (unsigned k = 0; k < left->count; k++)
            found |= facets->loop[left->first + k] == edge->from &&
                     facets->loop[left->first + (k + 1) % left->count] == edge->to;
        assert_true(found);
        assert_true(closed ? edge->right >= 0 && edge->right != edge->left : edge->right == LX_NO_FACE);
    }
    for (size_t i = 0; i < facets->corner_count; i++) {
        lx_wide3 way = lx_wide3_sub(facets->corners_mm[i], lx_wide3_of(facets->center_mm));
        assert_true(lx_wide_value(lx_wide3_length(way)) <= facets->radius_mm);
    }
}

static void assert_corner(lx_wide3 corner, double x, double y, double z)
{
    assert_true(corner.x.high == x && corner.y.high == y && corner.z.high == z);
    assert_true(corner.x.low == 0 && corner.y.low == 0 && corner.z.low == 0);
}

/* ---- shapes that cannot go wrong ---- */

static void rectangles(void **unused)
{
    const double center[3] = {10, 20, 30}, size[2] = {4, 2}, down[3] = {0, 0, -5}, y[3] = {3, 7, 0};
    struct lx_facets *facets = lx_facets_of_rectangle(center, size, down, (double[]){0, 3, 1});
    (void)unused;
    assert_sound(facets, 4, false);
    assert_true(facets->area_mm2 == 8 && facets->faces[0].normal.z.high == -1);
    /* h along y, w along up x axis = (0, 1, 0) x (0, 0, -1) = (-1, 0, 0), counter-clockwise from below */
    assert_corner(facets->corners_mm[0], 12, 19, 30);
    assert_corner(facets->corners_mm[1], 8, 19, 30);
    assert_corner(facets->corners_mm[2], 8, 21, 30);
    assert_corner(facets->corners_mm[3], 12, 21, 30);
    lx_facets_free(facets);

    /* axis (1, 2, 2)/3: corners are known to more than float64 can tell */
    facets = lx_facets_of_rectangle(center, size, (double[]){1, 2, 2}, y);
    assert_sound(facets, 4, false);
    lx_wide3 sum = lx_wide3_of((double[]){0, 0, 0});
    for (int i = 0; i < 4; i++)
        sum = lx_wide3_add(sum, facets->corners_mm[i]);
    lx_wide3 off = lx_wide3_sub(sum, lx_wide3_of((double[]){40, 80, 120}));
    assert_true(lx_wide_value(lx_wide3_length(off)) < 1e-28);
    assert_true(fabs(lx_wide_sub(facets->faces[0].normal.x, lx_wide_div(lx_wide_of(1), lx_wide_of(3))).high) < 1e-31);
    lx_facets_free(facets);
}

static void boxes(void **unused)
{
    struct lx_facets *facets = lx_facets_of_box((double[]){1, 2, 3}, (double[]){2, 4, 6});
    (void)unused;
    assert_sound(facets, 8, true);
    assert_true(facets->area_mm2 == 88 && facets->face_count == 6 && facets->edge_count == 12);
    assert_corner(facets->corners_mm[0], 0, 0, 0);
    assert_corner(facets->corners_mm[7], 2, 4, 6);
    lx_facets_free(facets);
    /* the sphere around one far away has room for what its middle is rounded by */
    facets = lx_facets_of_box((double[]){1e7, -2e7, 3e7}, (double[]){2, 4, 4});
    assert_non_null(facets);
    assert_true(facets->center_mm[0] == 1e7 && facets->center_mm[1] == -2e7 && facets->center_mm[2] == 3e7);
    assert_true(fabs(facets->radius_mm - (3 + 8 * 0x1p-52 * 6e7)) < 1e-13);
    lx_facets_free(facets);
}

/* The area of the sphere's polyhedron from its bands; the prism's from its sides. */
static void inscribed(void **unused)
{
    const double center[3] = {100, -50, 900};
    (void)unused;
    for (unsigned n = 3; n < 40; n += n < 9 ? 1 : 10) {
        struct lx_facets *ball = lx_facets_of_sphere(center, 50, n);
        unsigned bands = n / 2 < 2 ? 2 : n / 2;
        double area = 0;
        assert_non_null(ball);
        assert_sound(ball, 100, true);
        assert_int_equal(ball->face_count, bands * n);
        for (unsigned i = 0; i < bands; i++) {
            double s0 = sin(M_PI * i / bands), s1 = sin(M_PI * (i + 1) / bands);
            double fall = cos(M_PI * i / bands) - cos(M_PI * (i + 1) / bands);
            area += n * 50 * 50 * sin(M_PI / n) * (s0 + s1) * hypot(fall, (s1 - s0) * cos(M_PI / n));
        }
        assert_true(fabs(ball->area_mm2 - area) < 1e-12 * area);
        for (size_t i = 0; i < ball->corner_count; i++) {
            lx_wide3 way = lx_wide3_sub(ball->corners_mm[i], lx_wide3_of(center));
            assert_true(fabs(lx_wide_sub(lx_wide3_length(way), lx_wide_of(50)).high) < 1e-27);
        }
        assert_corner(ball->corners_mm[0], 100, -50, 950);
        lx_facets_free(ball);

        struct lx_facets *prism = lx_facets_of_cylinder(center, 50, 30, (double[]){0, 0, 2}, n);
        assert_non_null(prism);
        assert_sound(prism, 100, true);
        assert_int_equal(prism->face_count, n + 2);
        area = 2 * n * 50 * sin(M_PI / n) * 30 + n * 50 * 50 * sin(2 * M_PI / n);
        assert_true(fabs(prism->area_mm2 - area) < 1e-12 * area);
        assert_corner(prism->corners_mm[0], 150, -50, 885);
        lx_facets_free(prism);
    }
    struct lx_facets *tube = lx_facets_of_cylinder(center, 5, 1200, (double[]){1, 0, 1}, 12);
    assert_sound(tube, 1200, true);
    lx_facets_free(tube);
}

/* ---- outlines ---- */

/* The corners are x, y pairs in a plane spanned by u and v. */
static struct lx_shape_report try_outline(const double *xy, size_t count, size_t *pieces, double *area)
{
    static const double planes[][6] = {{1, 0, 0, 0, 1, 0}, {0, 2, 1, -1, 0, 3}, {1, 2, -2, 2, 1, 2}};
    struct lx_shape_report report = {LX_SHAPE_GOOD, 0, 0};
    double corners[64][3];
    *pieces = 0;
    for (size_t p = 0; p < sizeof planes / sizeof *planes; p++) {
        const double *u = planes[p], *v = u + 3;
        struct lx_facets **facets = NULL;
        size_t found = 0;
        for (size_t i = 0; i < count; i++)
            for (int k = 0; k < 3; k++)
                corners[i][k] = xy[2 * i] * u[k] + xy[2 * i + 1] * v[k] + 7 * k;
        struct lx_shape_report seen = lx_facets_of_outline((places)corners, count, &facets, &found);
        if (p > 0) { /* the same in every plane */
            assert_int_equal(seen.fault, report.fault);
            assert_int_equal(seen.first, report.first);
            assert_int_equal(seen.second, report.second);
            assert_int_equal(found, *pieces);
        }
        report = seen;
        *pieces = found;
        double sum = 0, uu = u[0] * u[0] + u[1] * u[1] + u[2] * u[2], vv = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        double uv = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        for (size_t i = 0; i < found; i++) {
            assert_sound(facets[i], 100, false);
            sum += facets[i]->area_mm2 / sqrt(uu * vv - uv * uv);
            lx_facets_free(facets[i]);
        }
        free(facets);
        *area = sum;
    }
    return report;
}

static void good_outlines(void **unused)
{
    static const struct {
        size_t count, most;
        double area, xy[32];
    } cases[] = {
        {3, 1, 6, {0, 0, 4, 0, 0, 3}},
        {4, 1, 12, {0, 0, 4, 0, 4, 3, 0, 3}},
        {8, 1, 12, {0, 0, 2, 0, 4, 0, 4, 1, 4, 3, 1, 3, 0, 3, 0, 2}},                          /* corners on sides */
        {4, 2, 6, {0, 0, 4, 0, 1, 1, 0, 4 - 1}},                                               /* a dart */
        {6, 2, 12, {0, 0, 4, 0, 4, 2, 2, 2, 2, 4, 0, 4}},                                      /* an L */
        {10, 3, 12, {0, 0, 2, 0, 4, 0, 4, 1, 4, 2, 3, 2, 2, 2, 2, 4, 0, 4, 0, 3}},             /* the same */
        {8, 3, 20, {0, 0, 6, 0, 6, 4, 4, 4, 4, 2, 2, 2, 2, 4, 0, 4}},                          /* a U */
        {12, 5, 20, {2, 0, 4, 0, 4, 2, 6, 2, 6, 4, 4, 4, 4, 6, 2, 6, 2, 4, 0, 4, 0, 2, 2, 2}}, /* a cross */
        {10, 7, 40, {5, 0, 6, 3, 10, 3, 7, 6, 8, 10, 5, 7, 2, 10, 3, 6, 0, 3, 4, 3}},          /* a star */
    };
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        size_t pieces;
        double area, turned[32], expected = 0;
        struct lx_shape_report report = try_outline(cases[i].xy, cases[i].count, &pieces, &area);
        assert_int_equal(report.fault, LX_SHAPE_GOOD);
        assert_in_range(pieces, 1, cases[i].most);
        for (size_t k = 0; k < cases[i].count; k++) {
            size_t next = (k + 1) % cases[i].count;
            const double *xy = cases[i].xy;
            expected += (xy[2 * k] * xy[2 * next + 1] - xy[2 * next] * xy[2 * k + 1]) / 2;
            turned[2 * k] = xy[2 * (cases[i].count - 1 - k)];
            turned[2 * k + 1] = xy[2 * (cases[i].count - 1 - k) + 1];
        }
        assert_true(fabs(area - expected) < 1e-13 * expected);
        report = try_outline(turned, cases[i].count, &pieces, &area);
        assert_int_equal(report.fault, LX_SHAPE_GOOD);
        assert_true(fabs(area - expected) < 1e-13 * expected);
    }
}

static void bad_outlines(void **unused)
{
    static const struct {
        size_t count;
        enum lx_shape_fault fault;
        size_t first, second;
        double xy[16];
    } cases[] = {
        {2, LX_SHAPE_TOO_SMALL, 0, 0, {0, 0, 1, 0}},
        {4, LX_SHAPE_TOO_SMALL, 2, 0, {0, 0, 1, 0, 1, 0, 0, 1}},           /* a corner twice */
        {4, LX_SHAPE_TOO_SMALL, 0, 0, {0, 0, 1, 0, 1, 1, 0, 0}},           /* the first again at the end */
        {3, LX_SHAPE_TOO_SMALL, 0, 0, {0, 0, 1, 1, 3, 3}},                 /* all on a line */
        {4, LX_SHAPE_CROSSES, 0, 2, {0, 0, 2, 2, 2, 0, 0, 2}},             /* a bow tie, without area */
        {4, LX_SHAPE_CROSSES, 0, 2, {0, 0, 2, 2, 2, 0, 0, 3}},             /* another */
        {5, LX_SHAPE_CROSSES, 0, 2, {0, 0, 4, 0, 4, 4, 2, 0, 0, 4}},       /* a corner on an edge */
        {4, LX_SHAPE_CROSSES, 0, 1, {0, 0, 4, 0, 2, 0, 2, 2}},             /* folds back */
        {6, LX_SHAPE_CROSSES, 1, 3, {0, 0, 4, 0, 2, 2, 4, 4, 2, 2, 0, 4}}, /* touches itself in a corner */
    };
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        size_t pieces;
        double area;
        struct lx_shape_report report = try_outline(cases[i].xy, cases[i].count, &pieces, &area);
        if (report.fault != cases[i].fault || report.first != cases[i].first || report.second != cases[i].second)
            fail_msg("%zu: fault %d at %zu, %zu", i, report.fault, report.first, report.second);
    }
}

static void flat_outlines(void **unused)
{
    double corners[4][3] = {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 1.9e-3}};
    struct lx_facets **facets;
    size_t count;
    (void)unused;
    struct lx_shape_report report = lx_facets_of_outline((places)corners, 4, &facets, &count);
    assert_int_equal(report.fault, LX_SHAPE_GOOD);
    assert_sound(facets[0], 1000, false); /* moved into one plane */
    lx_facets_free(facets[0]);
    free(facets);
    corners[3][2] = 1;
    report = lx_facets_of_outline((places)corners, 4, &facets, &count);
    assert_int_equal(report.fault, LX_SHAPE_NOT_FLAT);
    assert_int_equal(report.first, 3);
}

/* ---- meshes ---- */

static const double cube_corners[8][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0},
                                          {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};
static const unsigned cube_loop[24] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
static const unsigned cube_counts[6] = {4, 4, 4, 4, 4, 4};

/* A cube of 2 with some change. */
struct mesh {
    double corners[32][3];
    unsigned loop[96], counts[32];
    size_t corner_count, face_count;
};

static struct mesh cube(void)
{
    struct mesh mesh = {.corner_count = 8, .face_count = 6};
    memcpy(mesh.corners, cube_corners, sizeof cube_corners);
    memcpy(mesh.loop, cube_loop, sizeof cube_loop);
    memcpy(mesh.counts, cube_counts, sizeof cube_counts);
    return mesh;
}

static struct lx_facets *assert_good(const struct mesh *mesh, size_t faces, double area)
{
    struct lx_facets *facets = NULL;
    struct lx_shape_report report = lx_facets_of_mesh((places)mesh->corners, mesh->corner_count, mesh->loop,
                                                      mesh->counts, mesh->face_count, NULL, &facets);
    assert_int_equal(report.fault, LX_SHAPE_GOOD);
    assert_sound(facets, 4, true);
    assert_int_equal(facets->face_count, faces);
    assert_true(fabs(facets->area_mm2 - area) < 1e-5 * area);
    return facets;
}

static void assert_bad(const struct mesh *mesh, enum lx_shape_fault fault, size_t first)
{
    struct lx_facets *facets = NULL;
    struct lx_shape_report report = lx_facets_of_mesh((places)mesh->corners, mesh->corner_count, mesh->loop,
                                                      mesh->counts, mesh->face_count, NULL, &facets);
    assert_null(facets);
    assert_int_equal(report.fault, fault);
    assert_int_equal(report.first, first);
}

/* Takes the corners of the last faces instead. */
static void set_faces(struct mesh *mesh, size_t from, size_t count, unsigned corners, const unsigned *loop)
{
    size_t used = 0;
    for (size_t i = 0; i < from; i++)
        used += mesh->counts[i];
    memcpy(mesh->loop + used, loop, count * corners * sizeof *loop);
    for (size_t i = 0; i < count; i++)
        mesh->counts[from + i] = corners;
    mesh->face_count = from + count;
}

static void good_meshes(void **unused)
{
    struct mesh mesh = cube();
    (void)unused;
    lx_facets_free(assert_good(&mesh, 6, 24));

    /* two triangles for the top: coplanar neighbours */
    set_faces(&mesh, 5, 2, 3, (const unsigned[]){4, 5, 7, 4, 7, 6});
    lx_facets_free(assert_good(&mesh, 7, 24));

    /* each face has corners of its own, at the same places; corners that no face uses are far away */
    struct mesh split = {.corner_count = 25, .face_count = 6, .corners = {[24] = {1e6, 1e6, 1e6}}};
    for (unsigned i = 0; i < 24; i++) {
        memcpy(split.corners[i], cube_corners[cube_loop[i]], sizeof split.corners[i]);
        split.loop[i] = i;
    }
    split.corners[3][0] = -0.0;
    memcpy(split.counts, cube_counts, sizeof cube_counts);
    struct lx_facets *facets = assert_good(&split, 6, 24);
    assert_int_equal(facets->corner_count, 8);
    assert_true(facets->radius_mm < 2);
    lx_facets_free(facets);

    /* the top is an L and a square: the L is cut in two */
    mesh = cube();
    const double more[3][3] = {{1, 2, 2}, {1, 1, 2}, {2, 1, 2}};
    memcpy(mesh.corners[8], more, sizeof more);
    mesh.corner_count = 11;
    mesh.face_count = 0;
    set_faces(&mesh, 0, 1, 4, (const unsigned[]){0, 4, 6, 2});
    set_faces(&mesh, 1, 2, 5, (const unsigned[]){1, 3, 7, 10, 5, 2, 6, 8, 7, 3});
    set_faces(&mesh, 3, 3, 4, (const unsigned[]){0, 1, 5, 4, 0, 2, 3, 1, 9, 10, 7, 8});
    set_faces(&mesh, 6, 1, 6, (const unsigned[]){4, 5, 10, 9, 8, 6});
    lx_facets_free(assert_good(&mesh, 8, 24));

    /* a top that is bent by less than 1e-6: triangles */
    mesh = cube();
    mesh.corners[7][2] = 2 + 1e-6;
    lx_facets_free(assert_good(&mesh, 7, 24));
}

static void bad_meshes(void **unused)
{
    struct mesh mesh = cube();
    (void)unused;
    mesh.face_count = 5;
    assert_bad(&mesh, LX_SHAPE_NOT_CLOSED, 0);

    mesh = cube(); /* one face the wrong way round */
    set_faces(&mesh, 5, 1, 4, (const unsigned[]){4, 6, 7, 5});
    assert_bad(&mesh, LX_SHAPE_NOT_CLOSED, 0);

    mesh = cube(); /* one twice */
    set_faces(&mesh, 6, 1, 4, (const unsigned[]){4, 5, 7, 6});
    assert_bad(&mesh, LX_SHAPE_NOT_CLOSED, 0);

    mesh = cube(); /* all the wrong way round */
    for (size_t i = 0; i < 24; i++)
        mesh.loop[i] = cube_loop[23 - i];
    assert_bad(&mesh, LX_SHAPE_INWARD, 0);

    mesh = cube(); /* a roof that is a pit, or not */
    memcpy(mesh.corners[8], (const double[]){1, 1, 1.5}, sizeof mesh.corners[8]);
    mesh.corner_count = 9;
    set_faces(&mesh, 5, 4, 3, (const unsigned[]){4, 5, 8, 5, 7, 8, 7, 6, 8, 6, 4, 8});
    assert_bad(&mesh, LX_SHAPE_NOT_CONVEX, 5);
    mesh.corners[8][2] = 2.5;
    lx_facets_free(assert_good(&mesh, 9, 20 + 2 * sqrt(5)));
    mesh.corners[8][2] = 2 - 1e-4;
    assert_bad(&mesh, LX_SHAPE_NOT_CONVEX, 5);

    mesh = cube();
    mesh.counts[0] = 2;
    assert_bad(&mesh, LX_SHAPE_TOO_SMALL, 0);

    mesh = cube(); /* a corner twice in a face */
    mesh.loop[9] = mesh.loop[8];
    assert_bad(&mesh, LX_SHAPE_TOO_SMALL, 2);

    mesh = cube(); /* a face without area */
    memcpy(mesh.corners[8], (const double[]){1, 0, 2}, sizeof mesh.corners[8]);
    mesh.corner_count = 9;
    set_faces(&mesh, 6, 1, 3, (const unsigned[]){4, 8, 5});
    mesh.loop[20] = 4; /* the top takes the other way along it */
    assert_bad(&mesh, LX_SHAPE_TOO_SMALL, 6);

    mesh = cube(); /* without volume */
    for (size_t i = 4; i < 8; i++)
        mesh.corners[i][2] = 0;
    mesh.face_count = 0;
    set_faces(&mesh, 0, 2, 4, (const unsigned[]){0, 1, 3, 2, 0, 2, 3, 1});
    assert_bad(&mesh, LX_SHAPE_TOO_SMALL, 0);

    mesh = cube();
    mesh.corners[7][2] = 2.1;
    assert_bad(&mesh, LX_SHAPE_NOT_FLAT, 1 + 4);

    mesh = cube(); /* two cubes */
    memcpy(mesh.loop + 24, cube_loop, sizeof cube_loop);
    memcpy(mesh.counts + 6, cube_counts, sizeof cube_counts);
    for (size_t i = 0; i < 8; i++) {
        for (int k = 0; k < 3; k++)
            mesh.corners[8 + i][k] = cube_corners[i][k] + 3;
    }
    for (size_t i = 24; i < 48; i++)
        mesh.loop[i] += 8;
    mesh.corner_count = 16;
    mesh.face_count = 12;
    assert_bad(&mesh, LX_SHAPE_NOT_CONVEX, 1);

    mesh = cube(); /* a corner that does not exist */
    mesh.loop[5] = 8;
    assert_bad(&mesh, LX_SHAPE_NOT_CLOSED, 1);
}

/* A ball of a hundred thousand faces. */
static void large_mesh(void **unused)
{
    const double center[3] = {10, 20, 30};
    struct lx_facets *ball = lx_facets_of_sphere(center, 100, 450), *made = NULL;
    (void)unused;
    assert_non_null(ball);
    double(*corners)[3] = malloc(ball->corner_count * sizeof *corners);
    unsigned *counts = malloc(ball->face_count * sizeof *counts);
    for (size_t i = 0; i < ball->corner_count; i++) {
        corners[i][0] = lx_wide_value(ball->corners_mm[i].x);
        corners[i][1] = lx_wide_value(ball->corners_mm[i].y);
        corners[i][2] = lx_wide_value(ball->corners_mm[i].z);
    }
    for (size_t i = 0; i < ball->face_count; i++)
        counts[i] = ball->faces[i].count;
    struct lx_shape_report report =
        lx_facets_of_mesh((places)corners, ball->corner_count, ball->loop, counts, ball->face_count, NULL, &made);
    assert_int_equal(report.fault, LX_SHAPE_GOOD);
    assert_true(made->face_count == ball->face_count && made->edge_count == ball->edge_count);
    assert_true(fabs(made->area_mm2 - ball->area_mm2) < 1e-10 * ball->area_mm2);
    lx_facets_free(made);
    corners[1234][0] *= 0.99;
    corners[1234][1] *= 0.99;
    report = lx_facets_of_mesh((places)corners, ball->corner_count, ball->loop, counts, ball->face_count, NULL, &made);
    assert_true(report.fault == LX_SHAPE_NOT_CONVEX || report.fault == LX_SHAPE_NOT_FLAT);
    lx_facets_free(ball);
    free(corners);
    free(counts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles),    cmocka_unit_test(boxes),        cmocka_unit_test(inscribed),
        cmocka_unit_test(good_outlines), cmocka_unit_test(bad_outlines), cmocka_unit_test(flat_outlines),
        cmocka_unit_test(good_meshes),   cmocka_unit_test(bad_meshes),   cmocka_unit_test(large_mesh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

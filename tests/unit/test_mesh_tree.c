/* SPDX-License-Identifier: MIT */
/*
 * The tree of a mesh against looking at every triangle, without a gap between neighbours; polygons cut into triangles;
 * normals; and what is said of bodies.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/vector.h"
#include "random_scenes.h"
#include "surface/solid.h"

/* ---- meshes ---- */

struct made {
    double (*corners)[3];
    unsigned (*triangles)[3];
    size_t corner_count, count;
};

static void add_triangle(struct made *made, unsigned a, unsigned b, unsigned c)
{
    const unsigned corners[3] = {a, b, c};
    memcpy(made->triangles[made->count++], corners, sizeof corners);
}

/* A closed ball of bands from pole to pole, dented at random. */
static struct made make_ball(struct randomness *random, unsigned bands, double dents)
{
    const unsigned around = 2 * bands, south = 1 + (bands - 1) * around;
    struct made made = {.corners = lx_new_array(south + 1, sizeof *made.corners),
                        .triangles = lx_new_array(2 * bands * around, sizeof *made.triangles),
                        .corner_count = south + 1};
    assert_true(made.corners && made.triangles);
    made.corners[0][2] = 1;
    made.corners[south][2] = -1;
    for (unsigned i = 1; i < bands; i++)
        for (unsigned k = 0; k < around; k++) {
            const double theta = M_PI * i / bands, phi = 2 * M_PI * k / around, r = 1 - dents * uniform(random, 0, 1);
            double *at = made.corners[1 + (i - 1) * around + k];
            at[0] = r * sin(theta) * cos(phi), at[1] = r * sin(theta) * sin(phi), at[2] = r * cos(theta);
        }
    for (unsigned i = 0; i < bands; i++)
        for (unsigned k = 0; k < around; k++) {
            const unsigned next = (k + 1) % around;
            const unsigned a = 1 + (i - 1) * around + k, b = 1 + (i - 1) * around + next;
            const unsigned c = 1 + i * around + k, d = 1 + i * around + next;
            if (i == 0)
                add_triangle(&made, 0, c, d);
            else if (i == bands - 1)
                add_triangle(&made, a, south, b);
            if (i > 0 && i < bands - 1) {
                add_triangle(&made, a, c, d);
                add_triangle(&made, a, d, b);
            }
        }
    return made;
}

/* Triangles anywhere, of many sizes. */
static struct made make_soup(struct randomness *random, size_t count)
{
    struct made made = {.corners = lx_new_array(3 * count, sizeof *made.corners),
                        .triangles = lx_new_array(count, sizeof *made.triangles),
                        .corner_count = 3 * count};
    assert_true(made.corners && made.triangles);
    for (size_t i = 0; i < count; i++) {
        const double size = pow(10, uniform(random, -4, 0.5));
        double middle[3];
        for (int k = 0; k < 3; k++)
            middle[k] = uniform(random, -10, 10);
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                made.corners[3 * i + (size_t)c][k] = middle[k] + size * uniform(random, -1, 1);
        add_triangle(&made, (unsigned)(3 * i), (unsigned)(3 * i + 1), (unsigned)(3 * i + 2));
    }
    return made;
}

static struct lx_mesh_tree *tree_of(const struct made *made)
{
    struct lx_mesh_tree *tree =
        lx_mesh_tree_new((const double(*)[3])made->corners, (const unsigned(*)[3])made->triangles, made->count);
    assert_non_null(tree);
    return tree;
}

static void clear(struct made *made, struct lx_mesh_tree *tree)
{
    free(made->corners);
    free(made->triangles);
    lx_kept_release(&tree->kept);
}

/* ---- rays ---- */

/* By Moeller and Trumbore, in long double; 2: so near to an edge that either answer is right. */
static int meets(const struct lx_tree_triangle *triangle, const struct lx_tree_ray *ray, long double *t)
{
    long double e1[3], e2[3], p[3], s[3], q[3], det = 0, u = 0, v = 0;
    long double d[3];
    for (int k = 0; k < 3; k++) {
        const long double corner = (long double)triangle->corners[0][k];
        d[k] = (long double)ray->direction[k];
        e1[k] = (long double)triangle->corners[1][k] - corner;
        e2[k] = (long double)triangle->corners[2][k] - corner;
        s[k] = (long double)ray->origin[k] - corner;
    }
    for (int k = 0; k < 3; k++) {
        const int y = (k + 1) % 3, z = (k + 2) % 3;
        p[k] = d[y] * e2[z] - d[z] * e2[y];
        q[k] = s[y] * e1[z] - s[z] * e1[y];
    }
    for (int k = 0; k < 3; k++)
        det += e1[k] * p[k], u += s[k] * p[k], v += d[k] * q[k];
    *t = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) / det;
    u /= det, v /= det;
    const long double least = fminl(fminl(u, v), 1 - u - v);
    return fabsl(least) < 1e-9L || !isfinite(least)
               ? 2
               : least > 0 && *t >= (long double)ray->from && *t <= (long double)ray->to;
}

static void agrees_with_every_triangle(void **state)
{
    (void)state;
    struct randomness random = {.state = 31};
    for (int n = 0; n < 40; n++) {
        struct made made = make_soup(&random, 1 + (size_t)(n * n));
        struct lx_mesh_tree *tree = tree_of(&made);
        for (int i = 0; i < 400; i++) {
            struct lx_tree_ray ray = {.from = 0, .to = i % 2 ? HUGE_VAL : 1};
            long double nearest = HUGE_VALL, t;
            bool in_doubt = false;
            for (int k = 0; k < 3; k++) {
                ray.origin[k] = uniform(&random, -1.2, 1.2);
                ray.direction[k] = i % 5 == 0 && k != i % 3 ? 0 : uniform(&random, -2, 2);
            }
            for (size_t f = 0; f < tree->triangle_count; f++) {
                const int met = meets(&tree->triangles[f], &ray, &t);
                in_doubt = in_doubt || met == 2;
                nearest = met == 1 && t < nearest ? t : nearest;
            }
            if (in_doubt)
                continue;
            const struct lx_tree_hit hit = lx_tree_first(tree, &ray, false);
            assert_int_equal(hit.triangle != NULL, nearest < HUGE_VALL);
            assert_true(!hit.triangle || fabsl((long double)hit.t - nearest) <= 1e-9L * (1 + nearest));
            assert_int_equal(lx_tree_is_met(tree, &ray, 0), nearest < HUGE_VALL && nearest > 0);
        }
        clear(&made, tree);
    }
}

/* Rays from inside a closed mesh, through edges and corners of it: none gets out, from outside none gets in. */
static void has_no_gaps(void **state)
{
    enum { RAYS = 1000000 };
    (void)state;
    struct randomness random = {.state = 7};
    struct made made = make_ball(&random, 60, 0.3);
    struct lx_mesh_tree *tree = tree_of(&made);
    for (int i = 0; i < RAYS; i++) {
        const unsigned face = (unsigned)uniform(&random, 0, (double)made.count - 1e-6);
        const double *a = made.corners[made.triangles[face][i % 3]];
        const double *b = made.corners[made.triangles[face][(i + 1) % 3]];
        const double share = i % 4 == 0 ? 0 : uniform(&random, 0, 1);
        struct lx_tree_ray ray = {.from = 0, .to = HUGE_VAL};
        for (int k = 0; k < 3; k++) {
            const double target = (a[k] + share * (b[k] - a[k]) - tree->middle[k]) / tree->unit;
            ray.origin[k] = (i % 16 == 0 ? 0 : uniform(&random, -0.2, 0.2)) / tree->unit;
            ray.direction[k] = target - ray.origin[k];
        }
        if (!lx_tree_is_met(tree, &ray, 0) || !lx_tree_first(tree, &ray, false).triangle)
            fail_msg("ray %d gets through", i);
    }
    clear(&made, tree);
}

static void finds_the_nearest(void **state)
{
    (void)state;
    struct randomness random = {.state = 5};
    struct made made = make_soup(&random, 300);
    struct lx_mesh_tree *tree = tree_of(&made);
    for (int i = 0; i < 3000; i++) {
        double place[3], least = HUGE_VAL, distance;
        for (int k = 0; k < 3; k++)
            place[k] = uniform(&random, -1.5, 1.5);
        for (size_t f = 0; f < tree->triangle_count; f++)
            least = fmin(least, lx_triangle_square(&tree->triangles[f], place));
        assert_non_null(lx_tree_nearest(tree, place, HUGE_VAL, &distance));
        assert_true(fabs(distance - sqrt(least)) <= 1e-12);
        assert_null(lx_tree_nearest(tree, place, 0.999 * sqrt(least), &distance));
    }
    clear(&made, tree);
}

static void knows_inside(void **state)
{
    (void)state;
    struct randomness random = {.state = 6};
    struct made made = make_ball(&random, 20, 0.1);
    struct lx_mesh_tree *tree = tree_of(&made);
    for (int i = 0; i < 3000; i++) {
        double place[3], in_tree[3];
        random_direction(&random, place);
        const double away = uniform(&random, 0, 2);
        if (away > 0.8 && away < 1)
            continue;
        for (int k = 0; k < 3; k++)
            in_tree[k] = (away * place[k] - tree->middle[k]) / tree->unit;
        assert_int_equal(lx_tree_is_inside(tree, in_tree), away < 0.9);
    }
    clear(&made, tree);
}

/* ---- faces ---- */

static double turn(const double a[3], const double b[3], const double c[3])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Stars of any shape, around which corners run counter-clockwise: all triangles do, and their areas are the star's. */
static void cuts_polygons(void **state)
{
    enum { MOST = 60 };
    (void)state;
    struct randomness random = {.state = 9};
    for (int n = 0; n < 2000; n++) {
        const unsigned count = 3 + (unsigned)uniform(&random, 0, MOST - 3 + 0.99);
        double corners[MOST][3], whole = 0, sum = 0;
        unsigned loop[MOST], room[MOST], triangles[MOST][3];
        const double tilt = uniform(&random, -2, 2);
        for (unsigned i = 0; i < count; i++) {
            const double angle = 2 * M_PI * i / count, reach = uniform(&random, 0.05, 1);
            corners[i][0] = reach * cos(angle), corners[i][1] = reach * sin(angle);
            corners[i][2] = tilt * corners[i][0];
            loop[i] = i;
        }
        for (unsigned i = 0; i < count; i++)
            whole += corners[i][0] * corners[(i + 1) % count][1] - corners[i][1] * corners[(i + 1) % count][0];
        lx_cut_polygon((const double(*)[3])corners, loop, count, room, triangles);
        for (unsigned i = 0; i + 2 < count; i++) {
            const double area = turn(corners[triangles[i][0]], corners[triangles[i][1]], corners[triangles[i][2]]);
            assert_true(area > -1e-12);
            sum += area;
        }
        assert_true(fabs(sum - whole) <= 1e-9);
    }
}

static struct lx_mesh *read(const char *text)
{
    struct lx_mesh *mesh = NULL;
    char *copy = lx_copy_text(text, strlen(text));
    assert_int_equal(lx_mesh_read("a.obj", copy, strlen(text), NULL, &mesh).message, LX_MSG_COUNT);
    free(copy);
    return mesh;
}

static void surveys_bodies(void **state)
{
    (void)state;
    static const char corners[] = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\n";
    static const struct {
        const char *faces;
        size_t open, crowded, flipped, parts;
        double volume;
        long euler;
        size_t turned;
        unsigned first;
        bool is_one_sided;
    } cases[] = {
        {"f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n", 0, 0, 0, 1, 4, 2, 0, 0, false},
        {"f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n", 0, 0, 0, 1, -4, 2, 0, 0, false},
        {"f 1 3 2\nf 1 2 4\nf 2 3 4\n", 3, 0, 0, 1, 4, 1, 0, 0, false},
        {"f 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 4 3\n", 0, 0, 3, 1, 4, 2, 1, 1, false},
        {"f 1 3 2\nf 1 2 4\nf 4 3 2\nf 1 4 3\n", 0, 0, 3, 1, 4, 2, 1, 3, false},
        {"f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nv 1 1 9\nf 1 2 5\n", 2, 1, 0, 1, 4, 2, 0, 0, false},
        /* a strip of three faces, glued with half a turn */
        {"v 9 0 0\nv 9 9 0\nf 1 2 4 3\nf 3 4 6 5\nf 5 6 1 2\n", 6, 0, 1, 1, -3, 0, 0, 0, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[300];
        struct lx_mesh_survey survey;
        snprintf(text, sizeof text, "%s%s", corners, cases[i].faces);
        struct lx_mesh *mesh = read(text);
        assert_true(lx_survey_mesh(mesh, &survey));
        assert_int_equal(survey.open, cases[i].open);
        assert_int_equal(survey.crowded, cases[i].crowded);
        assert_int_equal(survey.flipped, cases[i].flipped);
        assert_int_equal(survey.parts, cases[i].parts);
        assert_int_equal(survey.euler, cases[i].euler);
        assert_int_equal(survey.is_one_sided, cases[i].is_one_sided);
        if (!survey.is_one_sided)
            assert_int_equal(survey.turned_faces, cases[i].turned);
        if (!survey.is_one_sided)
            assert_int_equal(survey.turned_at.number, cases[i].first);
        if (survey.open == 0 && survey.turned_faces == 0)
            assert_true(fabs(survey.volume - cases[i].volume) < 1e-12);
        lx_kept_release(&mesh->kept);
    }
}

/* A roof, whose ridge bends by 90 degrees: one surface within a crease of 91 degrees, two within 89. */
static void smooths_within_the_crease(void **state)
{
    (void)state;
    struct lx_mesh *mesh = read("v -1 0 0\nv 0 0 1\nv 1 0 0\nv -1 9 0\nv 0 9 1\nv 1 9 0\nf 1 2 5 4\nf 2 3 6 5\n");
    bool is_empty;
    struct lx_solid *solid = lx_solid_of(mesh, &is_empty);
    assert_non_null(solid);
    for (int wide = 0; wide < 2; wide++) {
        struct lx_mesh_normals *normals = lx_normals_of(mesh, solid, LX_NORMALS_SMOOTH, wide ? 91 : 89);
        assert_non_null(normals);
        for (size_t i = 0; i < solid->count; i++)
            for (int c = 0; c < 3; c++) {
                const unsigned corner = mesh->loop[solid->places[i][c]];
                const double *normal = normals->normals[normals->of[i][c]];
                const bool is_ridge = mesh->corners[corner][2] == 1;
                assert_true(fabs(fabs(normal[0]) - (is_ridge && wide ? 0 : M_SQRT1_2)) < 1e-12);
            }
        lx_kept_release(&normals->kept);
    }
    lx_kept_release(&solid->kept);
    lx_kept_release(&mesh->kept);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_every_triangle),
        cmocka_unit_test(has_no_gaps),
        cmocka_unit_test(finds_the_nearest),
        cmocka_unit_test(knows_inside),
        cmocka_unit_test(cuts_polygons),
        cmocka_unit_test(surveys_bodies),
        cmocka_unit_test(smooths_within_the_crease),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

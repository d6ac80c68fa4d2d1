/* SPDX-License-Identifier: MIT */
/*
 * Surfaces against school geometry: where rays meet them, how far they reach, how an observer and a source stand to
 * them, and what light they take away: by the reference, and by the kernels of every instruction set.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "picture/lights.h"
#include "random_scenes.h"
#include "world/blocking.h"

/* A surface of either kind, with its frame as it was meant. */
struct body {
    const struct lx_surface_kind *kind;
    struct lx_sphere_parameters sphere;
    struct lx_plate_parameters plate;
    const void *parameters;
    struct lx_shape shape;
    double across[3], upward[3], axis[3]; /* of a plate */
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void random_point(struct randomness *random, double size, double point[3])
{
    for (int i = 0; i < 3; i++)
        point[i] = uniform(random, -size, size);
}

static void make_body(struct randomness *random, bool is_plate, struct body *body)
{
    memset(body, 0, sizeof *body);
    for (size_t i = 0; lx_surface_variants[i]; i++)
        if (strcmp(lx_surface_variants[i]->name, is_plate ? "rectangle" : "sphere") == 0)
            body->kind = (const struct lx_surface_kind *)lx_surface_variants[i];
    assert_non_null(body->kind);
    double *center = is_plate ? body->plate.center_mm : body->sphere.center_mm;
    random_point(random, 300, center);
    body->sphere.radius_mm = uniform(random, 50, 300);
    body->plate.size_mm[0] = uniform(random, 50, 600), body->plate.size_mm[1] = uniform(random, 50, 600);
    body->plate.given = 1 << 3;
    random_direction(random, body->plate.axis);
    random_direction(random, body->plate.up);
    memcpy(body->axis, body->plate.axis, sizeof body->axis);
    unit(body->axis);
    cross(body->plate.up, body->axis, body->across);
    unit(body->across);
    cross(body->axis, body->across, body->upward);
    for (int i = 0; i < 3; i++) /* the length of a direction does not matter */
        body->plate.axis[i] *= 7;
    body->parameters = is_plate ? (const void *)&body->plate : &body->sphere;
    body->shape = lx_surface_shape(body->kind, body->parameters);
}

/* -- shapes -- */

static void assert_near(double value, double expected, const char *what)
{
    if (!(fabs(value - expected) <= 1e-9 * (1 + fabs(expected))))
        fail_msg("%s: %.17g, expected %.17g", what, value, expected);
}

/* The greatest and the least of place . direction are those over many places of the surface, and are reached. */
static void reaches(void **state)
{
    struct randomness random = {.state = 41};
    (void)state;
    for (int n = 0; n < 200; n++) {
        struct body body;
        make_body(&random, n % 2, &body);
        double direction[3], low[3], high[3];
        random_point(&random, 2, direction);
        body.kind->extent(body.parameters, low, high);
        if (n % 2 == 0) {
            double length = sqrt(dot(direction, direction)), radius = body.sphere.radius_mm;
            assert_near(body.kind->farthest(body.parameters, direction),
                        dot(direction, body.sphere.center_mm) + radius * length, "farthest of a sphere");
            for (int i = 0; i < 3; i++) {
                assert_near(low[i], body.sphere.center_mm[i] - radius, "lowest of a sphere");
                assert_near(high[i], body.sphere.center_mm[i] + radius, "highest of a sphere");
            }
            assert_true(body.shape.radius_mm == radius);
            assert_memory_equal(body.shape.anchor_mm, body.sphere.center_mm, sizeof body.shape.anchor_mm);
            continue;
        }
        double most = -HUGE_VAL, lowest[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL},
               highest[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (int corner = 0; corner < 4; corner++) {
            double place[3];
            for (int i = 0; i < 3; i++) {
                place[i] = body.plate.center_mm[i] +
                           (corner & 1 ? 0.5 : -0.5) * body.plate.size_mm[0] * body.across[i] +
                           (corner & 2 ? 0.5 : -0.5) * body.plate.size_mm[1] * body.upward[i];
                lowest[i] = fmin(lowest[i], place[i]), highest[i] = fmax(highest[i], place[i]);
            }
            most = fmax(most, dot(direction, place));
        }
        assert_near(body.kind->farthest(body.parameters, direction), most, "farthest of a plate");
        for (int i = 0; i < 3; i++) {
            assert_near(low[i], lowest[i], "lowest of a plate"), assert_near(high[i], highest[i], "highest of a plate");
            assert_near(body.shape.axis[i], body.axis[i], "axis");
            assert_near(body.shape.across[i], body.across[i], "across");
            assert_near(body.shape.upward[i], body.upward[i], "upward");
            assert_true(body.shape.axis_error[i] < 1e-15 && body.shape.across_error[i] < 1e-15);
            assert_true(body.shape.upward_error[i] < 1e-15);
        }
        for (int i = 0; i < 2; i++) /* the room for rounding is known, too */
            assert_near(body.shape.half_mm[i] - body.plate.size_mm[i] / 2, body.shape.touch_mm, "half");
        const double *c = body.plate.center_mm;
        double touch = 1e-12 * (body.shape.radius_mm + fabs(c[0]) + fabs(c[1]) + fabs(c[2]));
        assert_true(fabs(body.shape.touch_mm / touch - 1) < 1e-12);
        assert_near(body.shape.radius_mm, hypot(body.plate.size_mm[0], body.plate.size_mm[1]) / 2, "half a diagonal");
    }
}

/* -- rays -- */

/* The parameter at which a ray meets a body from outside, plainly; infinite: nowhere. */
static double meet(const struct body *body, const double origin[3], const double direction[3])
{
    const double *anchor = body->shape.anchor_mm;
    double from[3] = {origin[0] - anchor[0], origin[1] - anchor[1], origin[2] - anchor[2]};
    if (body->shape.type == LX_SPHERE) {
        double a = dot(direction, direction), b = dot(from, direction);
        double root = b * b - a * (dot(from, from) - body->shape.radius_mm * body->shape.radius_mm);
        return root >= 0 ? (-b - sqrt(root)) / a : HUGE_VAL;
    }
    double height = dot(from, body->axis), slope = dot(direction, body->axis), place[3];
    for (int i = 0; i < 3; i++)
        place[i] = from[i] - height / slope * direction[i];
    bool on_it = fabs(dot(place, body->across)) <= body->plate.size_mm[0] / 2 &&
                 fabs(dot(place, body->upward)) <= body->plate.size_mm[1] / 2;
    return height > 0 && slope < 0 && on_it ? -height / slope : HUGE_VAL;
}

static void rays(void **state)
{
    struct randomness random = {.state = 42};
    unsigned hits[2] = {0, 0};
    (void)state;
    for (int n = 0; n < 4000; n++) {
        struct body body;
        struct lx_ray ray = {.origin_error = {0}};
        make_body(&random, n % 2, &body);
        random_point(&random, 2000, ray.origin_mm);
        for (int i = 0; i < 3; i++)
            ray.direction[i] = body.shape.anchor_mm[i] + uniform(&random, -300, 300) - ray.origin_mm[i];
        if (n % 7 < 2) { /* along an axis: nothing is rounded across it */
            memset(ray.direction, 0, sizeof ray.direction);
            ray.direction[n % 7] = ray.origin_mm[n % 7] > 0 ? -1 : 1;
            for (int i = 0; i < 3; i++)
                if (i != n % 7)
                    ray.origin_mm[i] = body.shape.anchor_mm[i] + uniform(&random, -200, 200);
        }
        double t = meet(&body, ray.origin_mm, ray.direction);
        struct lx_hit hit = body.kind->hit(&body.shape, &ray);
        assert_int_equal(hit.exists, t < HUGE_VAL);
        if (!hit.exists)
            continue;
        hits[n % 2]++;
        assert_near(hit.t, t, "parameter");
        const lx_bounded found[3] = {hit.place_mm.x, hit.place_mm.y, hit.place_mm.z};
        const lx_bounded normal[3] = {hit.normal.x, hit.normal.y, hit.normal.z};
        for (int i = 0; i < 3; i++) {
            double place = ray.origin_mm[i] + t * ray.direction[i];
            assert_near(found[i].value, place, "place");
            assert_true(found[i].error <= 1e-9);
            assert_near(normal[i].value,
                        n % 2 ? body.axis[i] : (place - body.shape.anchor_mm[i]) / body.shape.radius_mm, "normal");
            if (n % 2 && ray.direction[i] == 0)
                assert_true(found[i].value == ray.origin_mm[i] && found[i].error == 0);
        }
        double place[3] = {found[0].value, found[1].value, found[2].value};
        assert_true(body.kind->holds(&body.shape, place));
        double off = 3e-9 * body.shape.radius_mm;
        for (int i = 0; i < 3; i++)
            place[i] += off * normal[i].value;
        assert_false(body.kind->holds(&body.shape, place));
        for (int i = 0; i < 3; i++)
            place[i] -= 2 * off * normal[i].value;
        assert_false(body.kind->holds(&body.shape, place));
    }
    assert_true(hits[0] > 300 && hits[1] > 100);
}

/* Near the limb of a sphere the depth is a root of what nearly cancels: it keeps its digits. */
static void limb(void **state)
{
    struct randomness random = {.state = 48};
    (void)state;
    for (int n = 0; n < 400; n++) {
        struct body body;
        make_body(&random, false, &body);
        memset(body.shape.anchor_mm, 0, sizeof body.shape.anchor_mm);
        double radius = body.shape.radius_mm, x = radius * (1 - logarithmic(&random, 3e-16, 1e-9));
        const struct lx_ray ray = {.origin_mm = {x, 0, 1500}, .direction = {0, 0, -1}};
        struct lx_hit hit = body.kind->hit(&body.shape, &ray);
        double depth = sqrt((radius - x) * (radius + x)); /* the difference is exact */
        assert_true(hit.exists == (x <= radius));
        assert_true(fabs(hit.place_mm.z.value - depth) <= hit.place_mm.z.error + 2e-16 * depth);
        assert_true(fabs(hit.place_mm.z.value - depth) <= 1e-14 * depth && hit.place_mm.z.error <= 1e-13 * depth);
    }
}

/* A place of a plate's plane belongs to it up to its edges, and a billionth of its size beyond. */
static void edges(void **state)
{
    struct randomness random = {.state = 43};
    (void)state;
    for (int n = 0; n < 200; n++) {
        struct body body;
        make_body(&random, true, &body);
        for (int side = 0; side < 4; side++) {
            const double *along = side < 2 ? body.across : body.upward;
            for (int beyond = 0; beyond < 2; beyond++) {
                double place[3],
                    reach = body.plate.size_mm[side / 2] / 2 + (beyond ? 2 : 0.5) * 1e-9 * body.shape.radius_mm;
                for (int i = 0; i < 3; i++)
                    place[i] = body.plate.center_mm[i] + (side % 2 ? -reach : reach) * along[i];
                assert_int_equal(body.kind->holds(&body.shape, place), !beyond);
            }
        }
    }
}

/* -- observers and sources -- */

static void standing(void **state)
{
    struct randomness random = {.state = 44};
    const struct lx_frame own = lx_frame_own();
    (void)state;
    for (int n = 0; n < 400; n++) {
        struct body body;
        make_body(&random, n % 2, &body);
        double place[3], low[3], high[3], z = uniform(&random, -700, 700);
        random_point(&random, 600, place);
        body.kind->extent(body.parameters, low, high);
        const double from[3] = {place[0] - body.shape.anchor_mm[0], place[1] - body.shape.anchor_mm[1],
                                place[2] - body.shape.anchor_mm[2]};
        const double eye[3] = {-body.shape.anchor_mm[0], -body.shape.anchor_mm[1], z - body.shape.anchor_mm[2]};
        enum lx_standing central = lx_surface_standing(body.kind, body.parameters, &own, z, true);
        enum lx_standing parallel = lx_surface_standing(body.kind, body.parameters, &own, z, false);
        bool dark = lx_surface_is_dark(body.kind, body.parameters, &own, place);
        if (n % 2) {
            assert_int_equal(central, dot(eye, body.axis) > 0 ? LX_STANDS_BEFORE : LX_SEES_BACK);
            assert_int_equal(parallel, body.axis[2] <= 0 ? LX_SEES_BACK
                                       : z > high[2]     ? LX_STANDS_BEFORE
                                                         : LX_STANDS_TOO_LOW);
            assert_int_equal(dark, dot(from, body.axis) <= 0);
        } else {
            assert_int_equal(central, z > high[2] ? LX_STANDS_BEFORE : LX_STANDS_TOO_LOW);
            assert_int_equal(parallel, central);
            double r2 = body.shape.radius_mm * body.shape.radius_mm;
            bool inside = dot(from, from) <= r2, behind = from[2] < 0 && from[0] * from[0] + from[1] * from[1] <= r2;
            assert_int_equal(dark, inside || behind);
        }
    }
}

/* -- shadows -- */

/* Whether a body crosses the open way from a place on, plainly. */
static bool crosses(const struct body *body, const double place[3], const double way[3], bool endless)
{
    const double *anchor = body->shape.anchor_mm;
    const double from[3] = {place[0] - anchor[0], place[1] - anchor[1], place[2] - anchor[2]};
    if (body->shape.type == LX_SPHERE) {
        const double r2 = body->shape.radius_mm * body->shape.radius_mm;
        double t = fmax(-dot(from, way) / dot(way, way), 0), nearest[3], end[3];
        for (int i = 0; i < 3; i++) {
            nearest[i] = from[i] + (endless ? t : fmin(t, 1)) * way[i];
            end[i] = from[i] + way[i];
        }
        bool within = !endless && dot(from, from) < r2 && dot(end, end) < r2;
        return dot(nearest, nearest) < r2 && !within;
    }
    double t = -dot(from, body->axis) / dot(way, body->axis), at[3];
    for (int i = 0; i < 3; i++)
        at[i] = from[i] + t * way[i];
    return t > 0 && (endless || t < 1) && fabs(dot(at, body->across)) < body->plate.size_mm[0] / 2 &&
           fabs(dot(at, body->upward)) < body->plate.size_mm[1] / 2;
}

/* A block of places around a body, some of them within a sphere, and a light near to it or far away. */
static void shadows(void **state)
{
    struct randomness random = {.state = 45};
    unsigned dark = 0, all = 0, by_planes = 0;
    (void)state;
    for (int n = 0; n < 400; n++) {
        static struct lx_block_double block;
        struct body body;
        make_body(&random, n % 2, &body);
        const bool endless = n % 3 == 0;
        const double size = n % 5 == 0 ? 150 : 900;
        double light[3], anchor[3];
        random_point(&random, size, light);
        random_point(&random, 100, anchor);
        struct lx_light_double constants = {.kind = endless ? LX_DISTANT : LX_BY_SQUARE};
        constants.x = light[0] - (endless ? 0 : anchor[0]);
        constants.y = light[1] - (endless ? 0 : anchor[1]);
        constants.z = light[2] - (endless ? 0 : anchor[2]);
        bool expected[LX_BLOCK];
        for (int i = 0; i < LX_BLOCK; i++) {
            double place[3], way[3];
            random_point(&random, i % 3 ? 700 : 200, place);
            for (int k = 0; k < 3; k++)
                way[k] = light[k] - (endless ? 0 : place[k]);
            block.px[i] = place[0] - anchor[0], block.py[i] = place[1] - anchor[1], block.pz[i] = place[2] - anchor[2];
            expected[i] = crosses(&body, place, way, endless);
            lx_bounded blocked = body.kind->blocks(&body.shape, lx_exact3(place), lx_exact3(way), endless);
            assert_true(blocked.error == 0 && blocked.value == expected[i]);
            dark += expected[i], all++;
            /* the balls around both ends and the body meet, too */
            struct lx_ball blocker = {.radius = body.shape.radius_mm}, from = {.radius = 0}, towards = {.radius = 0};
            for (int k = 0; k < 3; k++)
                blocker.center[k] = body.shape.anchor_mm[k], from.center[k] = place[k], towards.center[k] = light[k];
            assert_true(lx_may_block(&blocker, &from, &towards, endless) || !expected[i]);
            /* so they do where the end is but some place of its ball; a plate's plane may tell that they do not */
            double aside[3];
            random_direction(&random, aside);
            from.radius = uniform(&random, 0, 20);
            for (int k = 0; k < 3; k++)
                from.center[k] += 0.99 * from.radius * aside[k];
            const bool may = lx_shape_may_block(&body.shape, (const double[]){0, 0, 0}, &from, &towards, endless);
            assert_true(may || !expected[i]);
            by_planes += !may && lx_may_block(&blocker, &from, &towards, endless);
        }
        for (size_t k = 0; lx_kernels_get(k); k++) {
            const struct lx_kernels *kernels = lx_kernels_get(k);
            float open[LX_BLOCK];
            if (!kernels->runs())
                continue;
            for (int i = 0; i < LX_BLOCK; i++)
                open[i] = i % 7 != 6; /* what is shut already stays so */
            lx_block_one(kernels, &body.shape, false, anchor, &constants, &block, LX_BLOCK, open);
            for (int i = 0; i < LX_BLOCK; i++)
                if (open[i] != (i % 7 != 6 && !expected[i]))
                    fail_msg("%s, case %d, element %d: %g", kernels->name, n, i, (double)open[i]);
        }
    }
    assert_true(dark > all / 20 && dark < all / 2);
    assert_true(by_planes > all / 50);
}

/* How far the middle of a ball is from a line decides; the line is as thick as the larger of the balls at its ends. */
static void thick_lines(void **state)
{
    struct randomness random = {.state = 46};
    (void)state;
    for (int n = 0; n < 600; n++) {
        const bool endless = n % 2;
        const double along = uniform(&random, -1.5, 2.5);
        struct lx_ball blocker = {.radius = uniform(&random, 1, 50)}, from = {.radius = uniform(&random, 0, 50)};
        struct lx_ball towards = {.radius = uniform(&random, 0, 50)};
        double way[3], side[3], off[3], nearest = endless ? fmax(along, 0) : fmin(fmax(along, 0), 1);
        random_point(&random, 500, from.center);
        random_point(&random, 500, way);
        random_direction(&random, side);
        cross(way, side, off);
        unit(off);
        double thick = endless ? from.radius : fmax(from.radius, towards.radius), length = sqrt(dot(way, way));
        double beyond = fabs(along - nearest) * length, reach = blocker.radius + thick;
        if (n % 5 == 0) /* straight on, so that the ends are tried too */
            memset(off, 0, sizeof off);
        for (int outside = 0; outside < 2; outside++) {
            double wanted = reach * (outside ? 1 + 1e-7 : 1 - 1e-7);
            double across = wanted > beyond ? sqrt(wanted * wanted - beyond * beyond) : 0, gap = 0;
            for (int i = 0; i < 3; i++) {
                towards.center[i] = way[i] + (endless ? 0 : from.center[i]);
                blocker.center[i] = from.center[i] + along * way[i] + across * off[i];
                double apart = (along - nearest) * way[i] + across * off[i];
                gap += apart * apart;
            }
            assert_int_equal(lx_may_block(&blocker, &from, &towards, endless), sqrt(gap) <= reach);
        }
    }
    /* a line without a length is a ball */
    struct lx_ball here = {.center = {1, 2, 3}, .radius = 2}, near = {.center = {1, 2, 8}, .radius = 2.9};
    assert_false(lx_may_block(&near, &here, &here, false));
    near.radius = 3.1;
    assert_true(lx_may_block(&near, &here, &here, false));
}

/* The ball around a surface has its middle, from the other's anchor, and half the diagonal of its box. */
static void balls(void **state)
{
    (void)state;
    const struct lx_shape shape = {.type = LX_PLATE, .anchor_mm = {10, 20, 30}};
    const double low[3] = {8, 17, 24}, high[3] = {12, 23, 36}, anchor[3] = {1, 2, 4};
    struct lx_ball ball = lx_shape_ball(&shape, low, high, anchor);
    assert_true(ball.center[0] == 9 && ball.center[1] == 18 && ball.center[2] == 26 && fabs(ball.radius - 7) < 1e-14);
}

/* What is taken for a plate's own place takes no light: to its touch, and not beyond. */
static void plates_touch(void **state)
{
    struct randomness random = {.state = 47};
    (void)state;
    for (int n = 0; n < 200; n++) {
        struct body body;
        make_body(&random, true, &body);
        const double touch = body.shape.touch_mm * 1e3; /* so that places can be told from each other */
        body.shape.touch_mm = touch;
        for (int k = 0; k < 8; k++) {
            /* from one height to another; in touches: those within one of the plate are on it */
            const double heights[8][2] = {{0.9, -50}, {1.1, -50}, {50, -0.9}, {50, -1.1},
                                          {-0.9, 50}, {-1.1, 50}, {-50, 0.9}, {-50, 1.1}};
            double place[3], way[3];
            for (int i = 0; i < 3; i++) {
                place[i] = body.plate.center_mm[i] + heights[k][0] * touch * body.axis[i];
                way[i] = (heights[k][1] - heights[k][0]) * touch * body.axis[i];
            }
            bool endless = n % 2 && (k < 2 || k == 4 || k == 5);
            lx_bounded blocked = body.kind->blocks(&body.shape, lx_exact3(place), lx_exact3(way), endless);
            assert_true(blocked.value == k % 2);
            static struct lx_block_double block;
            struct lx_light_double light = {.kind = endless ? LX_DISTANT : LX_BY_SQUARE};
            block.px[0] = place[0], block.py[0] = place[1], block.pz[0] = place[2];
            light.x = way[0] + (endless ? 0 : place[0]);
            light.y = way[1] + (endless ? 0 : place[1]);
            light.z = way[2] + (endless ? 0 : place[2]);
            float open[LX_BLOCK] = {1};
            lx_block_one(lx_kernels_choose(NULL), &body.shape, false, (const double[]){0, 0, 0}, &light, &block, 1,
                         open);
            assert_true(open[0] == (k % 2 ? 0 : 1));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reaches),     cmocka_unit_test(rays),     cmocka_unit_test(limb),
        cmocka_unit_test(edges),       cmocka_unit_test(standing), cmocka_unit_test(shadows),
        cmocka_unit_test(thick_lines), cmocka_unit_test(balls),    cmocka_unit_test(plates_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

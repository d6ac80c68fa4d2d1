/* SPDX-License-Identifier: MIT */
/*
 * Disks and the sides of cylinders against geometry by hand: where rays meet them, how far they are and reach, what
 * light they take, where the edges of their shadows lie, and the coordinates on them.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/vector.h"
#include "random_scenes.h"
#include "surface/beside.h"

/* What users write of either kind, as their tables lay it out; of a disk the height is 0. */
struct disk {
    uint64_t given;
    double center_mm[3], radius_mm, axis[3];
};

struct tube {
    uint64_t given;
    double center_mm[3], radius_mm, height_mm, axis[3];
};

/* A body with its frame as it was meant: the third direction is the axis. */
struct body {
    const struct lx_surface_kind *kind;
    union {
        struct disk disk;
        struct tube tube;
    } as;
    struct lx_shape shape;
    double center[3], frame[3][3], radius, half;
    bool is_tube;
};

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

static void make_body(struct randomness *random, bool is_tube, struct body *body)
{
    memset(body, 0, sizeof *body);
    body->is_tube = is_tube;
    body->kind = kind_called(is_tube ? "cylinder" : "disk");
    random_point(random, 300, body->center);
    random_direction(random, body->frame[2]);
    random_direction(random, body->frame[1]);
    cross(body->frame[1], body->frame[2], body->frame[0]);
    lx_normalize(body->frame[0]);
    cross(body->frame[2], body->frame[0], body->frame[1]);
    body->radius = uniform(random, 50, 300);
    body->half = is_tube ? uniform(random, 20, 400) : 0;
    double axis[3];
    for (int i = 0; i < 3; i++) /* the length of a direction does not matter */
        axis[i] = 7 * body->frame[2][i];
    if (is_tube) {
        body->as.tube = (struct tube){.radius_mm = body->radius, .height_mm = 2 * body->half};
        memcpy(body->as.tube.center_mm, body->center, sizeof body->center);
        memcpy(body->as.tube.axis, axis, sizeof axis);
    } else {
        body->as.disk = (struct disk){.radius_mm = body->radius};
        memcpy(body->as.disk.center_mm, body->center, sizeof body->center);
        memcpy(body->as.disk.axis, axis, sizeof axis);
    }
    body->shape = lx_surface_shape(body->kind, &body->as);
}

/* In the body's own frame, and from it. */
static void into(const struct body *body, const double a[3], bool is_place, double b[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = a[i] - (is_place ? body->center[i] : 0);
    for (int i = 0; i < 3; i++)
        b[i] = lx_dot(body->frame[i], from);
}

static void out_of(const struct body *body, const double a[3], bool is_place, double b[3])
{
    for (int i = 0; i < 3; i++) {
        b[i] = is_place ? body->center[i] : 0;
        for (int k = 0; k < 3; k++)
            b[i] += a[k] * body->frame[k][i];
    }
}

static void assert_near(double value, double expected, double error, const char *what)
{
    if (!(fabs(value - expected) <= error))
        fail_msg("%s: %.17g, expected %.17g", what, value, expected);
}

/* A place of the surface. */
static void random_place(struct randomness *random, const struct body *body, double place[3])
{
    const double turn = uniform(random, 0, 2 * M_PI);
    const double away = body->is_tube ? body->radius : body->radius * sqrt(uniform(random, 0, 1));
    out_of(body, (double[]){away * cos(turn), away * sin(turn), uniform(random, -1, 1) * body->half}, true, place);
}

/* The parameters at which a way crosses the surface, either way; returns how many. */
static int crossings(const struct body *body, const double place[3], const double way[3], double t[2])
{
    double p[3], d[3];
    int count = 0;
    into(body, place, true, p);
    into(body, way, false, d);
    if (!body->is_tube) {
        t[0] = -p[2] / d[2];
        return hypot(p[0] + t[0] * d[0], p[1] + t[0] * d[1]) <= body->radius;
    }
    const double a = d[0] * d[0] + d[1] * d[1], b = p[0] * d[0] + p[1] * d[1];
    const double root = b * b - a * (p[0] * p[0] + p[1] * p[1] - body->radius * body->radius);
    for (int sign = -1; sign <= 1 && root >= 0; sign += 2) {
        t[count] = (-b + sign * sqrt(root)) / a;
        count += fabs(p[2] + t[count] * d[2]) <= body->half;
    }
    return count;
}

/* The least share by which a way comes near to the edge of being blocked: too near, and rounding decides. */
static bool is_doubtful(const struct body *body, const double place[3], const double way[3])
{
    for (int i = 0; i < 60; i++) {
        double t[2], u[2], near[3];
        for (int k = 0; k < 3; k++)
            near[k] = place[k] + 1e-6 * ((i * (k + 3) * 7) % 13 - 6);
        if (crossings(body, place, way, t) != crossings(body, near, way, u))
            return true;
    }
    return false;
}

static void rays(void **state)
{
    struct randomness random = {.state = 71};
    unsigned hits = 0, misses = 0;
    (void)state;
    for (int n = 0; n < 6000; n++) {
        struct body body;
        struct lx_ray ray = {.origin_error = {0}};
        double aim[3], t[2], normal[3], front[3];
        make_body(&random, n % 2, &body);
        random_point(&random, 2000, ray.origin_mm);
        random_place(&random, &body, aim);
        for (int i = 0; i < 3; i++)
            ray.direction[i] = aim[i] + uniform(&random, -100, 100) - ray.origin_mm[i];
        into(&body, ray.origin_mm, true, front);
        into(&body, ray.direction, false, normal);
        int count = crossings(&body, ray.origin_mm, ray.direction, t);
        /* from the front, and of a tube the entrance alone */
        bool seen = body.is_tube ? hypot(front[0], front[1]) > body.radius : front[2] > 0 && normal[2] < 0;
        double p[3], first = HUGE_VAL;
        for (int i = 0; i < count && seen; i++) {
            for (int k = 0; k < 3; k++)
                p[k] = ray.origin_mm[k] + t[i] * ray.direction[k];
            double q[3];
            into(&body, p, true, q);
            if (t[i] > 0 && (!body.is_tube || q[0] * normal[0] + q[1] * normal[1] < 0))
                first = fmin(first, t[i]);
        }
        struct lx_hit hit = body.kind->hit(&body.shape, &ray);
        double from[3], plain[3], plain_t = HUGE_VAL;
        for (int i = 0; i < 3; i++)
            from[i] = ray.origin_mm[i] - body.center[i];
        const bool meets = body.kind->meets(&body.shape, from, ray.direction, &plain_t, plain);
        if (is_doubtful(&body, ray.origin_mm, ray.direction))
            continue;
        assert_int_equal(hit.exists, first < HUGE_VAL);
        assert_int_equal(meets, hit.exists);
        hits += hit.exists, misses += !hit.exists;
        if (!hit.exists)
            continue;
        assert_near(hit.t, first, 1e-9 * first, "way to the hit");
        assert_near(plain_t, first, 1e-9 * first, "plain way to the hit");
        for (int k = 0; k < 3; k++)
            p[k] = ray.origin_mm[k] + first * ray.direction[k];
        into(&body, p, true, front);
        const double own[3] = {body.is_tube ? front[0] / body.radius : 0, body.is_tube ? front[1] / body.radius : 0,
                               body.is_tube ? 0 : 1};
        out_of(&body, own, false, normal);
        const lx_bounded *places[3] = {&hit.place_mm.x, &hit.place_mm.y, &hit.place_mm.z};
        const lx_bounded *normals[3] = {&hit.normal.x, &hit.normal.y, &hit.normal.z};
        double offset[3], again[3];
        for (int i = 0; i < 3; i++) {
            assert_near(places[i]->value, p[i], 1e-7, "place");
            assert_near(plain[i] + body.center[i], places[i]->value, places[i]->error + 1e-9, "plain place");
            assert_near(normals[i]->value, normal[i], 1e-8, "normal");
            assert_true(places[i]->error >= 0 && places[i]->error < 1e-6 && normals[i]->error < 1e-8);
            offset[i] = places[i]->value - body.center[i];
        }
        body.kind->normal(&body.shape, offset, again);
        for (int i = 0; i < 3; i++)
            assert_near(again[i], normals[i]->value, 1e-12, "normal at a place");
        /* what the bounds say of it: it lies on the surface */
        into(&body, (double[]){places[0]->value, places[1]->value, places[2]->value}, true, front);
        const double room = 2 * (places[0]->error + places[1]->error + places[2]->error) + 1e-12;
        assert_near(body.is_tube ? hypot(front[0], front[1]) : front[2], body.is_tube ? body.radius : 0, room, "on it");
        assert_true(body.kind->holds(&body.shape, (double[]){places[0]->value, places[1]->value, places[2]->value}));
    }
    assert_true(hits > 1000 && misses > 500);
}

/* Open ways, and ways that end; the ways past the surface tell the same by their signs, and the edges of the shadow on
 * the way between a dark place and a bright one go through 0 where that changes. */
static void shadows(void **state)
{
    struct randomness random = {.state = 72};
    unsigned blocked = 0, edges = 0;
    (void)state;
    for (int n = 0; n < 8000; n++) {
        struct body body;
        double place[3], aim[3], way[3], t[2], other[3];
        const bool endless = n / 2 % 2;
        make_body(&random, n % 2, &body);
        random_point(&random, 900, place);
        random_place(&random, &body, aim);
        const double reach = uniform(&random, 0.3, 3);
        for (int i = 0; i < 3; i++)
            way[i] = reach * (aim[i] + uniform(&random, -100, 100) - place[i]);
        const int count = crossings(&body, place, way, t);
        bool expected = false, near_end = false;
        for (int i = 0; i < count; i++) {
            expected |= t[i] > 0 && (endless || t[i] < 1);
            near_end |= fabs(t[i]) < 1e-6 || fabs(t[i] - 1) < 1e-6;
        }
        if (near_end || is_doubtful(&body, place, way))
            continue;
        const lx_bounded answer = body.kind->blocks(&body.shape, lx_exact3(place), lx_exact3(way), endless);
        assert_true(answer.error == 0 && (answer.value > 0) == expected);
        double from[3];
        for (int i = 0; i < 3; i++)
            from[i] = place[i] - body.center[i];
        assert_int_equal(body.kind->takes(&body.shape, from, way, endless), expected);
        const double beside = body.kind->beside(&body.shape, place, way, endless);
        assert_true(expected ? beside < 0 : beside > 0);
        blocked += expected;
        if (!expected)
            continue;
        /* a light at the end of the way: from the dark place to one that it reaches */
        struct lx_origin light = {.endless = endless, .at = {way[0], way[1], way[2]}};
        for (int i = 0; i < 3 && !endless; i++)
            light.at[i] = place[i] + way[i];
        random_point(&random, 900, other);
        double low = 0, high = 1, least = HUGE_VAL, middle[3];
        for (int step = 0; step < 60; step++) {
            const double share = step == 0 ? 1 : (low + high) / 2;
            for (int i = 0; i < 3; i++)
                middle[i] = place[i] + share * (other[i] - place[i]);
            double to[3];
            lx_way_to(&light, middle, to);
            const bool dark = body.kind->blocks(&body.shape, lx_exact3(middle), lx_exact3(to), endless).value > 0;
            if (step == 0 && dark)
                break;
            *(dark ? &low : &high) = share;
        }
        if (low == 0)
            continue;
        for (unsigned i = 0; i < body.kind->shadow_edges; i++) {
            double value = body.kind->shadow_edge(&body.shape, &light, i, middle), ahead[3];
            for (int k = 0; k < 3; k++) /* its slope along the way tells how far it is from 0 */
                ahead[k] = middle[k] + 1e-4 * (other[k] - place[k]);
            const double slope = (body.kind->shadow_edge(&body.shape, &light, i, ahead) - value) / 1e-4;
            if (isfinite(value))
                least = fmin(least, fabs(value / slope));
        }
        if (!(least < 1e-6))
            fail_msg("the shadow of a %s ends at no edge: %g", body.kind->variant.name, least);
        edges++;
    }
    assert_true(blocked > 1500 && edges > 500);
}

/* The distance is that of the nearest of many places, its direction leads away from it; extent, farthest place and
 * support are those of the farthest of them. */
static void reaches(void **state)
{
    struct randomness random = {.state = 73};
    (void)state;
    for (int n = 0; n < 60; n++) {
        struct body body;
        double from[3], place[3], low[3], high[3], direction[3], away[3], support[3];
        make_body(&random, n % 2, &body);
        random_point(&random, 700, from);
        random_direction(&random, direction);
        body.kind->extent(&body.as, low, high);
        double nearest = HUGE_VAL, farthest = -HUGE_VAL, lowest[3], highest[3], offset[3];
        for (int i = 0; i < 3; i++)
            lowest[i] = HUGE_VAL, highest[i] = -HUGE_VAL, offset[i] = from[i] - body.center[i];
        for (int k = 0; k < 40000; k++) {
            double square = 0;
            random_place(&random, &body, place);
            if (k % 4 == 0) { /* and along the edges */
                const double turn = uniform(&random, 0, 2 * M_PI), side = k % 8 ? 1 : -1;
                out_of(&body, (double[]){body.radius * cos(turn), body.radius * sin(turn), side * body.half}, true,
                       place);
            }
            for (int i = 0; i < 3; i++) {
                square += (place[i] - from[i]) * (place[i] - from[i]);
                lowest[i] = fmin(lowest[i], place[i]), highest[i] = fmax(highest[i], place[i]);
            }
            nearest = fmin(nearest, sqrt(square));
            farthest = fmax(farthest, lx_dot(place, direction));
        }
        const double distance = body.kind->distance(&body.shape, offset, away);
        assert_true(fabs(distance) <= nearest + 1e-6 && fabs(distance) > nearest - 12);
        double most = lx_surface_farthest(body.kind, &body.as, direction);
        assert_true(most >= farthest - 1e-9 && most < farthest + 1);
        const double ball = body.kind->bounds->support(&body.shape, direction, support);
        assert_near(lx_dot(support, direction) + ball + lx_dot(body.center, direction), most, 1e-8, "support");
        for (int i = 0; i < 3; i++) {
            assert_true(low[i] <= lowest[i] + 1e-9 && low[i] > lowest[i] - 1);
            assert_true(high[i] >= highest[i] - 1e-9 && high[i] < highest[i] + 1);
        }
        /* a step against the direction comes nearer by its length */
        if (body.is_tube && fabs(distance) > 2) {
            double step[3], unused[3];
            for (int i = 0; i < 3; i++)
                step[i] = offset[i] - away[i];
            assert_near(fabs(body.kind->distance(&body.shape, step, unused)), fabs(distance - 1), 1e-6,
                        "a step nearer");
        }
    }
}

/* Coordinates lead to places of the surface and back; a step of a mm moves a place by a mm. */
static void coordinates(void **state)
{
    struct randomness random = {.state = 74};
    (void)state;
    for (int n = 0; n < 400; n++) {
        struct body body;
        double place[3], offset[3], normal[3], at[3], again[3], there[3], first[3], second[3], moved[3], far[3];
        make_body(&random, n % 2, &body);
        const struct lx_surface_chart *chart = body.kind->chart;
        random_place(&random, &body, place);
        for (int i = 0; i < 3; i++)
            offset[i] = place[i] - body.center[i];
        body.kind->normal(&body.shape, offset, normal);
        chart->locate(&body.shape, offset, normal, at);
        chart->place(&body.shape, at, again, there);
        lx_bounded3 exact, exact_normal;
        chart->element(&body.shape, at, &exact, &exact_normal);
        chart->directions(&body.shape, at, first, second);
        for (int way = 0; way < 2; way++) {
            double square = 0;
            chart->move(&body.shape, at, first, second, (double[]){way == 0 ? 1e-3 : 0, way == 1 ? 1e-3 : 0}, moved);
            chart->place(&body.shape, moved, far, there);
            for (int i = 0; i < 3; i++)
                square += (far[i] - again[i]) * (far[i] - again[i]);
            assert_near(sqrt(square), 1e-3, 1e-8, "a step");
        }
        chart->place(&body.shape, at, again, there);
        const double values[3] = {exact.x.value, exact.y.value, exact.z.value};
        for (int i = 0; i < 3; i++) {
            assert_near(again[i], place[i], 1e-9, "place");
            assert_near(values[i], place[i], 1e-9, "element");
            assert_near(there[i], normal[i], 1e-12, "normal");
        }
        assert_true(exact.x.error < 1e-11 && exact_normal.x.error < 1e-14);
    }
}

/* An element on the inner wall of a tube is lit through an open end, and not through the wall it is on or the wall
 * opposite; one on the outer wall by what is outside. */
static void inner_walls(void **state)
{
    struct randomness random = {.state = 75};
    unsigned counts[2][2] = {{0, 0}, {0, 0}};
    (void)state;
    for (int n = 0; n < 4000; n++) {
        struct body body;
        double place[3], normal[3], offset[3], way[3], t[2], start[3];
        make_body(&random, true, &body);
        random_place(&random, &body, place);
        for (int i = 0; i < 3; i++)
            offset[i] = place[i] - body.center[i];
        body.kind->normal(&body.shape, offset, normal);
        random_direction(&random, way);
        const double side = n % 2 ? 1 : -1, above = lx_dot(normal, way);
        double tilted[3];
        for (int i = 0; i < 3; i++) {
            way[i] *= 1000;
            tilted[i] = side * normal[i] + 0.2 * body.frame[2][i];
            start[i] = place[i] + 1e-6 * side * normal[i]; /* a little off the wall, on its side */
        }
        bool expected = false;
        const int count = crossings(&body, start, way, t);
        for (int i = 0; i < count; i++)
            expected |= t[i] > 0;
        if (fabs(above) < 1e-3 || is_doubtful(&body, start, way))
            continue;
        const lx_bounded hidden =
            lx_shape_hides(&body.shape, lx_exact3(place), lx_unit3(lx_exact3(tilted)), lx_exact3(way), true);
        assert_true(hidden.error == 0 && (hidden.value > 0) == expected);
        counts[side > 0][expected]++;
    }
    for (int i = 0; i < 4; i++)
        assert_true(counts[i / 2][i % 2] > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays),        cmocka_unit_test(shadows),     cmocka_unit_test(reaches),
        cmocka_unit_test(coordinates), cmocka_unit_test(inner_walls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

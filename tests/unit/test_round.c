/* SPDX-License-Identifier: MIT */
/*
 * Disks, balls and cylinders: their irradiance against values computed with 80 digits in easy and in hard places
 * (round_cases.h), against printed ones, and what must be so anyway: the integrals agree with the closed forms, a ball
 * is a disk under the same cone, polyhedra approach the round bodies, a body's flux passes through any sphere around
 * it, sizes and mirrors do not matter, errors hold for uncertain places, parts add up to the whole.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/pose.h"
#include "light/solid/facets.h"
#include "light/solid/rim.h"
#include "light/solid/round.h"
#include "round_cases.h"

/* xorshift64*: the same places on every machine */
static double uniform(uint64_t *state, double low, double high)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return low + (high - low) * ((double)((*state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

static void random_unit(uint64_t *state, double v[3])
{
    double z = uniform(state, -1, 1), phi = uniform(state, 0, 2 * M_PI), rho = sqrt(1 - z * z);
    v[0] = rho * cos(phi);
    v[1] = rho * sin(phi);
    v[2] = z;
}

static struct lx_emitter disk(const double center[3], double radius, const double axis[3])
{
    return (struct lx_emitter){
        .type = LX_DISK,
        .center_mm = {center[0], center[1], center[2]},
        .radius_mm = radius,
        .axis = lx_wide3_direction(lx_wide3_unit(lx_wide3_of(axis))),
        .radiance = lx_exact(1),
    };
}

static struct lx_emitter ball(const double center[3], double radius)
{
    return (struct lx_emitter){
        .type = LX_BALL,
        .center_mm = {center[0], center[1], center[2]},
        .radius_mm = radius,
        .radiance = lx_exact(1),
    };
}

static struct lx_emitter cylinder(const double center[3], double radius, double height, const double axis[3])
{
    struct lx_emitter emitter = disk(center, radius, axis);
    emitter.type = LX_CYLINDER;
    emitter.height_mm = height;
    return emitter;
}

static lx_bounded light(const struct lx_emitter *emitter, const double place[3], const double normal[3])
{
    assert_false(lx_round_touches(emitter, lx_exact3(place)));
    lx_bounded found = lx_emitter_kind(emitter)->irradiance(emitter, lx_exact3(place), lx_exact3(normal));
    assert_true(found.value >= 0 && found.error >= 0);
    return found;
}

static void assert_near(double value, double expected, double relative, const char *what)
{
    if (!(fabs(value - expected) <= relative * fabs(expected)))
        fail_msg("%s: %.17g, expected %.17g", what, value, expected);
}

static struct lx_emitter emitter_of(const struct round_case *entry)
{
    const double *n = entry->numbers;
    return entry->kind == DISK   ? disk(n, n[3], n + 4)
           : entry->kind == BALL ? ball(n, n[3])
                                 : cylinder(n, n[3], n[4], n + 5);
}

/* An emitter of some kind, size and direction at some distance from the origin. */
static struct lx_emitter some_emitter(uint64_t *state, enum lx_emitter_type type, double distance)
{
    double center[3], axis[3];
    random_unit(state, center);
    random_unit(state, axis);
    for (int i = 0; i < 3; i++)
        center[i] *= distance;
    double radius = distance * uniform(state, 0.01, 0.6), height = distance * uniform(state, 0.01, 1);
    return type == LX_DISK   ? disk(center, radius, axis)
           : type == LX_BALL ? ball(center, radius)
                             : cylinder(center, radius, height, axis);
}

static const enum lx_emitter_type TYPES[] = {LX_DISK, LX_BALL, LX_CYLINDER};
enum { TYPE_COUNT = 3 };

/* ---- values ---- */

static void truth(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof round_cases / sizeof *round_cases; i++) {
        const struct round_case *entry = &round_cases[i];
        struct lx_emitter emitter = emitter_of(entry);
        lx_bounded found = light(&emitter, entry->place_mm, entry->normal);
        double off = fabs((found.value - entry->value) - entry->rest);
        if (!(off <= found.error))
            fail_msg("%s: %.17g is off by %g, more than %g", entry->what, found.value, off, found.error);
        double none = entry->value == 0 ? 1e-24 : 0; /* at the least, what the frame's own roundings leave */
        if (!(found.error <= 1e-12 * entry->value + none))
            fail_msg("%s: %.17g, expected %.17g to 1e-12; off by %g, error %g", entry->what, found.value, entry->value,
                     off, found.error);
    }
}

/* Configuration factors: a sphere of r/d = 1/2 at angles from 0 to 120 degrees, disks on and off the axis, tilted. */
static void printed(void **unused)
{
    static const double angles[] = {0, 30, 60, 75, 90, 105, 115, 119, 120};
    static const double factors[] = {0.25,       0.21650635, 0.125,    0.07041043, 0.02883444,
                                     0.00570567, 0.00039471, 7.28e-06, 0};
    static const struct {
        double place[3], tilt, factor;
    } disks[] = {
        {{0, 0, 0}, 0, 0.5},         {{500, 0, 0}, 0, 0.43798263},
        {{0, 0, -1000}, 0, 0.2},     {{1500, 0, -1000}, 0, 0.10228414},
        {{0, 0, 0}, 30, 0.4330127},  {{0, 0, 0}, 60, 0.25735206},
        {{0, 0, 0}, 90, 0.09084506},
    };
    (void)unused;
    struct lx_emitter sphere = ball((const double[]){0, 0, 2000}, 1000);
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
        double angle = angles[i] * M_PI / 180;
        lx_bounded found = light(&sphere, (const double[]){0, 0, 0}, (const double[]){sin(angle), 0, cos(angle)});
        assert_true(fabs(found.value / M_PI - factors[i]) <= 0.5e-8);
    }
    struct lx_emitter lamp = disk((const double[]){0, 0, 1000}, 1000, (const double[]){0, 0, -1});
    for (size_t i = 0; i < sizeof disks / sizeof *disks; i++) {
        double angle = disks[i].tilt * M_PI / 180;
        lx_bounded found = light(&lamp, disks[i].place, (const double[]){sin(angle), 0, cos(angle)});
        assert_true(fabs(found.value / M_PI - disks[i].factor) <= 0.5e-8);
    }
}

/* ---- what must be so ---- */

/* The integrals hold, too, where the contours' terms do not cancel, and share no formula with them. */
static void integrals(void **unused)
{
    uint64_t state = 20;
    (void)unused;
    for (int i = 0; i < 3000; i++) {
        double n[3];
        random_unit(&state, n);
        lx_wide3 normal = lx_wide3_of(n);
        lx_wide radius = lx_wide_of(pow(10, uniform(&state, -1, 1)));
        lx_wide rho = lx_wide_mul(radius, lx_wide_of(1 + pow(10, uniform(&state, -2, 1))));
        lx_wide near = lx_wide_of(uniform(&state, -1, 2)), far = lx_wide_add(near, lx_wide_of(uniform(&state, 0.1, 3)));
        struct lx_rim rims[2] = {lx_rim_of(rho, near, radius, normal), lx_rim_of(rho, far, radius, normal)};
        struct lx_horizon horizons[2] = {lx_rim_horizon(&rims[0]), lx_rim_horizon(&rims[1])};
        double off, cap = 0;
        if (horizons[1].crossed && far.high > 0) {
            struct lx_wide_sum terms = {{0, 0}, 0};
            lx_add_disk(&terms, &rims[1], &horizons[1]);
            double value = lx_wide_value(terms.value) / 2,
                   integral = lx_cut_disk_integral(&rims[1], &horizons[1], &off);
            assert_true(off < 1e-11);
            assert_true(fabs(integral - value) <= off * value + LX_SUM_ROUNDING * terms.size);
        }
        if (near.high > 0) {
            struct lx_wide_sum terms = {{0, 0}, 0};
            lx_add_disk(&terms, &rims[0], &horizons[0]);
            cap = lx_wide_value(terms.value) / 2;
        }
        struct lx_wide_sum terms = {{0, 0}, 0};
        lx_wide middle = lx_wide_scale(lx_wide_add(near, far), 0.5), half = lx_wide_scale(lx_wide_sub(far, near), 0.5);
        if (middle.high < 0)
            continue;
        lx_add_cylinder(&terms, rho, middle, radius, half, normal);
        double value = lx_wide_value(terms.value) / 2, side = lx_side_integral(rims, horizons, &off);
        assert_true(off < 1e-11);
        assert_true(fabs(cap + side - value) <= off * side + 4 * DBL_EPSILON * value + LX_SUM_ROUNDING * terms.size);
    }
}

/* So near to the disk's plane, before it and beside it, that panels have to keep away from where r vanishes. */
static void integrals_near_the_plane(void **unused)
{
    uint64_t state = 22;
    unsigned tried = 0;
    (void)unused;
    for (int i = 0; i < 3000; i++) {
        double n[3], off;
        random_unit(&state, n);
        const lx_wide radius = lx_wide_of(pow(10, uniform(&state, -1, 1)));
        const lx_wide rho = lx_wide_mul(radius, lx_wide_of(pow(10, uniform(&state, -2, 1))));
        const lx_wide height = lx_wide_mul(radius, lx_wide_of(pow(10, uniform(&state, -5, 0))));
        const struct lx_rim rim = lx_rim_of(rho, height, radius, lx_wide3_of(n));
        const struct lx_horizon horizon = lx_rim_horizon(&rim);
        if (!horizon.crossed)
            continue;
        struct lx_wide_sum terms = {{0, 0}, 0};
        lx_add_disk(&terms, &rim, &horizon);
        const double value = lx_wide_value(terms.value) / 2, integral = lx_cut_disk_integral(&rim, &horizon, &off);
        if (!(off < 1))
            continue; /* the panels did not suffice, and it says so */
        tried++;
        if (!(fabs(integral - value) <= off * value + LX_SUM_ROUNDING * terms.size))
            fail_msg("%d: %.17g, by its terms %.17g", i, integral, value);
    }
    if (tried < 1500)
        fail_msg("only %u cut by the horizon", tried);
}

static void ball_and_disk(void **unused)
{
    uint64_t state = 21;
    (void)unused;
    for (int i = 0; i < 2000; i++) {
        double axis[3], normal[3], center[3], foot[3];
        random_unit(&state, axis);
        random_unit(&state, normal);
        double distance = pow(10, uniform(&state, -3, 6)), radius = distance * uniform(&state, 0.001, 0.99);
        double cosine2 = 1 - radius / distance * (radius / distance);
        for (int k = 0; k < 3; k++) {
            center[k] = distance * axis[k];
            foot[k] = cosine2 * center[k];
            axis[k] = -axis[k];
        }
        struct lx_emitter globe = ball(center, radius), lamp = disk(foot, radius * sqrt(cosine2), axis);
        double a = light(&globe, (const double[]){0, 0, 0}, normal).value,
               b = light(&lamp, (const double[]){0, 0, 0}, normal).value;
        assert_true(fabs(a - b) <= 1e-12 * M_PI * (1 - cosine2));
    }
}

static double light_and_free(struct lx_facets *facets, const double place[3], const double normal[3])
{
    assert_non_null(facets);
    double value = lx_facets_irradiance(facets, lx_exact3(place), lx_exact3(normal)).value;
    lx_facets_free(facets);
    return value;
}

static struct lx_facets *polygon(const struct lx_emitter *lamp, unsigned sides)
{
    double(*corners)[3] = calloc(sides, sizeof *corners);
    struct lx_facets **pieces = NULL, *whole;
    size_t count = 0;
    assert_non_null(corners);
    for (unsigned i = 0; i < sides; i++) { /* it shines downwards */
        double angle = -2 * M_PI * i / sides;
        corners[i][0] = lamp->center_mm[0] + lamp->radius_mm * cos(angle);
        corners[i][1] = lamp->center_mm[1] + lamp->radius_mm * sin(angle);
        corners[i][2] = lamp->center_mm[2];
    }
    assert_int_equal(lx_facets_of_outline((const double(*)[3])corners, sides, &pieces, &count).fault, LX_SHAPE_GOOD);
    assert_int_equal(count, 1);
    whole = pieces[0];
    free(pieces);
    free(corners);
    return whole;
}

/* Polygons, prisms and polyhedra with 32 and 64 sides lie inside, with twice as many four times nearer. */
static void polyhedra(void **unused)
{
    static const double center[3] = {0, 0, 1000}, down[3] = {0, 0, -1};
    static const double places[][3] = {{0, 0, 0}, {450, 30, 100}, {-500, 200, 900}, {300, -400, 600}};
    static const double normals[][3] = {{0, 0, 1}, {-0.8, 0, 0.6}, {0.96, 0, 0.28}, {0, 0.8, 0.6}};
    (void)unused;
    struct lx_emitter round[] = {disk(center, 300, down), ball(center, 300),
                                 cylinder(center, 200, 700, (const double[]){2, -1, 2})};
    for (size_t i = 0; i < 4; i++)
        for (int k = 0; k < TYPE_COUNT; k++) {
            double off[2], value = light(&round[k], places[i], normals[i]).value;
            for (unsigned j = 0; j < 2; j++) {
                unsigned sides = 32u << j;
                struct lx_facets *facets =
                    k == 0   ? polygon(&round[k], sides)
                    : k == 1 ? lx_facets_of_sphere(center, 300, sides)
                             : lx_facets_of_cylinder(center, 200, 700, (const double[]){2, -1, 2}, sides);
                off[j] = value - light_and_free(facets, places[i], normals[i]);
            }
            /* of a sphere or a cylinder the outline is one or another of the edges */
            assert_true(off[0] > off[1] && off[1] > 0 && off[0] < 0.02 * value && off[1] < 0.005 * value);
            assert_true(k > 0 || (off[0] / off[1] > 3.5 && off[0] / off[1] < 4.5));
        }
}

/* The mean over a sphere of what comes from a disk of exitance M under the solid angle Omega is M Omega/4 pi. */
static void mean_over_sphere(void **unused)
{
    enum { STEPS = 4000 };
    struct lx_emitter lamp = disk((const double[]){0, 0, 500}, 1000, (const double[]){0, 0, -1});
    double sum = 0;
    (void)unused;
    for (int i = 0; i < STEPS; i++) {
        double z = (i + 0.5) / STEPS * 2 - 1, rho = sqrt(1 - z * z);
        sum += light(&lamp, (const double[]){400 * rho, 0, 400 * z}, (const double[]){rho, 0, z}).value / STEPS;
    }
    assert_near(sum / M_PI, 0.2763932, 1e-6, "mean over a sphere");
}

/* All the flux of a body, pi A, passes through a sphere around it. */
static void flux(void **unused)
{
    enum { STEPS = 4000 };
    static const double center[3] = {0, 0, 0}, axis[3] = {0, 0, 1};
    struct lx_emitter bodies[] = {ball(center, 2), cylinder(center, 2, 3, axis), cylinder(center, 0.1, 5, axis),
                                  cylinder(center, 2.5, 0.001, axis)};
    (void)unused;
    for (size_t k = 0; k < sizeof bodies / sizeof *bodies; k++) {
        double r = bodies[k].radius_mm, h = bodies[k].height_mm, sum = 0;
        double area = bodies[k].type == LX_BALL ? 4 * M_PI * r * r : 2 * M_PI * r * (r + h);
        for (int i = 0; i < STEPS; i++) {
            double z = (i + 0.5) / STEPS * 2 - 1, rho = sqrt(1 - z * z);
            sum += light(&bodies[k], (const double[]){3 * rho, 0, 3 * z}, (const double[]){-rho, 0, -z}).value / STEPS;
        }
        assert_near(sum * 4 * M_PI * 9, M_PI * area, 2e-6, "flux");
    }
}

/* From afar a body is a point of the intensity that its outline has; off by the square of its size. */
static void far_field(void **unused)
{
    (void)unused;
    const double way[3] = {-0.48, 0.6, -0.64}, normal[3] = {-0.48, 0.6, -0.64};
    struct lx_emitter body = cylinder((const double[]){0, 0, 0}, 2, 3, (const double[]){0, 0, 1});
    double outline = M_PI * 4 * 0.64 + 4 * 3 * sqrt(1 - 0.64 * 0.64), off[2];
    for (int i = 0; i < 2; i++) {
        double distance = 400.0 * (1 + i);
        const double place[3] = {-distance * way[0], -distance * way[1], -distance * way[2]};
        off[i] = fabs(light(&body, place, normal).value * distance * distance / outline - 1);
    }
    assert_true(off[0] < 1e-4 && off[0] / off[1] > 3.9 && off[0] / off[1] < 4.1);
}

static void sizes_and_mirrors(void **unused)
{
    uint64_t state = 22;
    (void)unused;
    for (int i = 0; i < 1500; i++) {
        struct lx_emitter emitter = some_emitter(&state, TYPES[i % TYPE_COUNT], 1);
        double place[3] = {0, 0, 0}, normal[3];
        random_unit(&state, normal);
        if (lx_round_touches(&emitter, lx_exact3(place)))
            continue;
        lx_bounded first = light(&emitter, place, normal);
        struct lx_emitter large = emitter, tenfold = emitter, mirrored = emitter;
        for (int k = 0; k < 3; k++) {
            large.center_mm[k] *= 0x1p30;
            tenfold.center_mm[k] *= 1e-6;
        }
        large.radius_mm *= 0x1p30, large.height_mm *= 0x1p30;
        tenfold.radius_mm *= 1e-6, tenfold.height_mm *= 1e-6;
        lx_bounded second = light(&large, place, normal), third = light(&tenfold, place, normal);
        assert_true(first.value == second.value && first.error == second.error);
        /* the products are rounded: as if the place were off */
        assert_true(fabs(first.value - third.value) <= 1e-12);
        mirrored.center_mm[0] *= -1;
        mirrored.axis.x.value *= -1;
        const double turned[3] = {-normal[0], normal[1], normal[2]};
        lx_bounded fourth = light(&mirrored, place, turned);
        assert_true(fabs(first.value - fourth.value) <= first.error + fourth.error);
        /* a cylinder's axis has no sign */
        if (emitter.type == LX_CYLINDER) {
            mirrored = emitter;
            mirrored.axis = lx_negate3(mirrored.axis);
            fourth = light(&mirrored, place, normal);
            assert_true(fabs(first.value - fourth.value) <= first.error + fourth.error);
        }
    }
}

/* What place, normal and axis may be off, together or one of them alone: the errors cover it. */
static void uncertain_elements(void **unused)
{
    enum { ALL, PLACE, NORMAL, AXIS, WAYS };
    uint64_t state = 23;
    (void)unused;
    for (int i = 0; i < 12000; i++) {
        int way = i / TYPE_COUNT % WAYS;
        struct lx_emitter emitter = some_emitter(&state, TYPES[i % TYPE_COUNT], 1), turned = emitter;
        double normal[3], off = pow(10, uniform(&state, -12, -2));
        random_unit(&state, normal);
        double place_off = way == ALL || way == PLACE ? off * uniform(&state, 0, 1) : 0;
        double normal_off = way == ALL || way == NORMAL ? off * uniform(&state, 0, 1) : 0;
        double axis_off = way == ALL || way == AXIS ? off : 0;
        lx_bounded3 place = {{0, place_off}, {0, place_off}, {0, place_off}}, uncertain = lx_exact3(normal);
        uncertain.x.error = uncertain.y.error = uncertain.z.error = normal_off;
        lx_bounded *axis[3] = {&emitter.axis.x, &emitter.axis.y, &emitter.axis.z};
        double direction[3];
        for (int k = 0; k < 3; k++) {
            direction[k] = axis[k]->value + axis_off * (uniform(&state, 0, 1) < 0.5 ? -1 : 1);
            axis[k]->error = fmax(axis_off, axis[k]->error);
        }
        if (lx_round_touches(&emitter, place))
            continue;
        if (axis_off > 0)
            turned.axis = lx_unit3(lx_exact3(direction));
        lx_bounded found = lx_emitter_kind(&emitter)->irradiance(&emitter, place, uncertain);
        double there[3], tilted[3];
        for (int k = 0; k < 3; k++) {
            there[k] = place_off * (uniform(&state, 0, 1) < 0.5 ? -1 : 1);
            tilted[k] = normal[k] + normal_off * (uniform(&state, 0, 1) < 0.5 ? -1 : 1);
        }
        lx_bounded other = lx_emitter_kind(&turned)->irradiance(&turned, lx_exact3(there), lx_exact3(tilted));
        if (!(fabs(found.value - other.value) <= found.error + other.error))
            fail_msg("type %d: %.17g and %.17g, error %g", (int)emitter.type, found.value, other.value, found.error);
    }
}

/* ---- on, in and behind ---- */

static void nothing_is_seen(void **unused)
{
    static const double up[3] = {0, 0, 1}, center[3] = {10, 20, 1000};
    struct lx_emitter lamp = disk(center, 300, (const double[]){0, 0, -1}), globe = ball(center, 300);
    struct lx_emitter tube = cylinder(center, 300, 400, up);
    (void)unused;
    static const double elements[][6] = {
        {0, 0, 1500, 0, 0, -1}, {0, 0, 0, 0, 0, -1}, {0, 0, 0, 0.8, 0, -0.6}, {2000, 0, 900, 1, 0, 0}};
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++) {
        lx_bounded dark = light(&lamp, elements[i], elements[i] + 3);
        assert_true(dark.value == 0 && dark.error == 0);
    }
    lx_bounded in_plane = light(&lamp, (const double[]){500, 0, 1000}, (const double[]){-1, 0, 0});
    assert_true(in_plane.value == 0 && in_plane.error < 1e-24);
    static const double inside[][3] = {{10, 20, 1000}, {100, 20, 1100}, {10, 20, 1199}};
    for (size_t i = 0; i < 3; i++) {
        lx_bounded in_ball = light(&globe, inside[i], up), in_tube = light(&tube, inside[i], up);
        assert_true(in_ball.value == 0 && in_ball.error == 0 && in_tube.value == 0 && in_tube.error == 0);
    }
}

static void touching(void **unused)
{
    static const double up[3] = {0, 0, 1}, center[3] = {10, 20, 1000};
    struct lx_emitter lamp = disk(center, 300, (const double[]){0, 0, -1}), globe = ball(center, 300);
    struct lx_emitter tube = cylinder(center, 300, 400, up);
    static const struct {
        double place[3];
        bool disk, ball, cylinder;
    } cases[] = {
        {{10, 20, 1000}, true, false, false},       {{310, 20, 1000}, true, true, true},
        {{190, 260, 1000}, true, true, true},       {{310.0001, 20, 1000}, false, false, false},
        {{10, 20, 1000.0001}, false, false, false}, {{10, 20, 1300}, false, true, false},
        {{10, 20, 1300.0001}, false, false, false}, {{10, 20, 1200}, false, false, true},
        {{310, 20, 1200}, false, false, true},      {{310, 20, 800}, false, false, true},
        {{310, 20, 799.9999}, false, false, false}, {{10, 20, 1199.9999}, false, false, false},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        lx_bounded3 place = lx_exact3(cases[i].place);
        assert_int_equal(lx_round_touches(&lamp, place), cases[i].disk);
        assert_int_equal(lx_round_touches(&globe, place), cases[i].ball);
        assert_int_equal(lx_round_touches(&tube, place), cases[i].cylinder);
    }
    lx_bounded3 near = {{310.0001, 0.001}, {20, 0}, {1000, 0}};
    assert_true(lx_round_touches(&lamp, near) && lx_round_touches(&globe, near) && lx_round_touches(&tube, near));
    /* four roundings of the greatest number that tells where things are, be it the place's own */
    for (int axis = 0; axis < 3; axis++)
        for (int units = 2; units <= 6; units++) {
            double middle[3] = {0}, place[3] = {0};
            middle[axis] = 512, place[axis] = 1024 * (1 + units * DBL_EPSILON);
            struct lx_emitter large = ball(middle, 512);
            assert_int_equal(lx_round_touches(&large, lx_exact3(place)), units <= 4);
        }
}

/* ---- parts ---- */

static double parts_light(const struct lx_emitter *emitter, unsigned parts, const double place[3],
                          const double normal[3])
{
    struct lx_emitters list = {0};
    double sum = 0;
    assert_int_equal(lx_emitter_kind(emitter)->cut(emitter, parts, &list), 0);
    for (size_t i = 0; i < list.count; i++) {
        struct lx_sample sample = lx_emitter_sample(&list.items[i], lx_exact3(place));
        sum += sample.e_perp.value * fmax(0, lx_dot3(sample.towards, lx_exact3(normal)).value);
    }
    lx_emitters_clear(&list);
    return sum;
}

static void parts(void **unused)
{
    static const double center[3] = {10, 20, 1000}, axis[3] = {1, 2, -2}, place[3] = {100, -50, 0},
                        normal[3] = {0, 0.6, 0.8};
    struct lx_emitter round[] = {disk(center, 300, axis), ball(center, 300), cylinder(center, 200, 500, axis)};
    static const double areas[] = {0.09, 0.36, 0.28};
    (void)unused;
    for (int k = 0; k < TYPE_COUNT; k++) {
        round[k].radiance = lx_exact(7);
        for (unsigned n = 1; n <= 5; n += 2) {
            struct lx_emitters list = {0};
            assert_int_equal(lx_emitter_kind(&round[k])->cut(&round[k], n, &list), 0);
            assert_int_equal(list.count, (round[k].type == LX_CYLINDER ? 3 : 1) * n * n);
            double strength = 0;
            for (size_t i = 0; i < list.count; i++) {
                assert_int_equal(list.items[i].type, LX_POINT);
                strength += list.items[i].strength;
            }
            assert_near(strength, 7 * M_PI * areas[k], 1e-13, "strength");
            if (n == 1 && round[k].type == LX_DISK)
                assert_memory_equal(list.items[0].position_mm, center, sizeof center);
            lx_emitters_clear(&list);
        }
    }
    for (int k = 0; k < TYPE_COUNT; k++) {
        double whole = 7 * light(&round[k], place, normal).value;
        double off = fabs(parts_light(&round[k], 40, place, normal) - whole);
        assert_true(off < 2e-3 * whole);
        if (k == 0) {
            double finer = fabs(parts_light(&round[k], 80, place, normal) - whole);
            assert_true(off / finer > 3.5 && off / finer < 4.5);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(truth),
        cmocka_unit_test(printed),
        cmocka_unit_test(integrals),
        cmocka_unit_test(integrals_near_the_plane),
        cmocka_unit_test(ball_and_disk),
        cmocka_unit_test(polyhedra),
        cmocka_unit_test(mean_over_sphere),
        cmocka_unit_test(flux),
        cmocka_unit_test(far_field),
        cmocka_unit_test(sizes_and_mirrors),
        cmocka_unit_test(uncertain_elements),
        cmocka_unit_test(nothing_is_seen),
        cmocka_unit_test(touching),
        cmocka_unit_test(parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

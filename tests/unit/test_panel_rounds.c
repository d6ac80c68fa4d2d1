/* SPDX-License-Identifier: MIT */
/* The visible places of balls and cylinders' sides at complex places, the bounds of their highlights by parts, and of
 * the irradiance by cylinders. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "campaign.h"
#include "extended_sources.h"
#include "picture/round_view.h"
#include "picture/area_light_bound.h"
#include "squares.h"

enum { SQUARES = 12 };

/* One surface under a ball or a cylinder, of any size and however near. */
static void make_scene(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 1)};
    double direction[3], center[3], axis[3];
    make_finer_scene(&random, i % 3 == 0, test, direction, center);
    const struct lx_material material = {
        .model = pick(&random, 2) ? LX_BLINN_PHONG : LX_PHONG,
        .diffuse = 0.25,
        .specular = 0.5,
        .shininess = pick(&random, 2) ? floor(logarithmic(&random, 1, 300)) : logarithmic(&random, 0.5, 100),
        .highlight = pick(&random, 2) ? (int)LX_HIGHLIGHT_PLAIN : pick(&random, 3),
    };
    random_direction(&random, axis);
    test->surfaces[0].lobe = lx_lobe_prepare(&material);
    test->prepared.emitters.count = 1;
    test->lights[0] = source_of(BALL + i % 2, center, 1000, 0);
    test->lights[0].attenuation = (enum lx_attenuation)(i / 2 % LX_LAWS);
    test->lights[0].k_mm = 200;
    test->lights[0].radius_mm *= logarithmic(&random, 0.05, 1);
    test->lights[0].height_mm *= logarithmic(&random, 0.1, 3);
    test->lights[0].axis = lx_unit3(lx_exact3(axis));
}

/* ---- visible places ---- */

/* The places of the disk that a ball is, turned from the way out from where they are told; there as area_light.c has
 * it. */
static struct seen_place seen_of_ball(const struct lx_area_light *ball, struct vector out, struct vector place,
                                      double s, double t)
{
    const struct vector zero = {0, 0, 0}, from = plus(place, -1, vector_of(ball->center)), u = unit(from);
    const struct vector beside = {cabs(out.x) <= 0.5, cabs(out.x) > 0.5, 0};
    const struct vector b = unit(cross(out, beside)), a = cross(b, out);
    const struct vector told = plus(plus(zero, cos(2 * M_PI * t), a), sin(2 * M_PI * t), b);
    const struct vector turned = plus(told, -dot(u, told) / (1 + dot(u, out)), plus(u, 1, out));
    const double complex square = dot(from, from);
    const double complex radius = ball->round_mm / csqrt(1 - ball->round_mm * ball->round_mm / square);
    const struct vector at = plus(zero, s * radius, turned), way = plus(from, -1, at);
    return (struct seen_place){at, 2 * M_PI * s * radius * radius * dot(way, u) / csqrt(dot(way, way))};
}

/* As they are told from the middle. */
static struct seen_place seen_of(const struct lx_area_light *lamp, const struct lx_vicinity *at, struct vector place,
                                 double s, double t)
{
    if (lamp->has_side)
        return seen_of_side(lamp, place, s, t);
    return seen_of_ball(lamp, unit(plus(vector_of(at->place), -1, vector_of(lamp->center))), place, s, t);
}

static double length_of_imaginary(struct vector a)
{
    return sqrt(cimag(a.x) * cimag(a.x) + cimag(a.y) * cimag(a.y) + cimag(a.z) * cimag(a.z));
}

static struct vector random_way(struct randomness *random, double most)
{
    double direction[3];
    random_direction(random, direction);
    const double length = most * (pick(random, 2) ? 1 : uniform(random, 0, 1));
    return plus((struct vector){0, 0, 0}, length, vector_of(direction));
}

/* Places move no farther than a view tells. */
static void places_move(void **state)
{
    enum { BODIES = 3000, PLACES = 12 };
    double worst[2] = {0, 0};
    size_t views = 0;
    (void)state;
    for (int i = 0; i < BODIES; i++) {
        struct randomness random = {.state = UINT64_C(0x94D049BB133111EB) * ((uint64_t)i + 1)};
        const double distance = logarithmic(&random, 110, 3000), reach = distance * logarithmic(&random, 0.001, 0.3);
        struct lx_area_light lamp = {.is_ball = i % 2 == 1, .has_side = i % 2 == 0, .round_mm = 100, .half_mm = 200};
        struct lx_vicinity at = {.place_deviation = {.first = reach * uniform(&random, 0, 1),
                                                     .second = reach * uniform(&random, 0, 0.3),
                                                     .imaginary = reach * uniform(&random, 0, 1)}};
        const struct lx_deviation *place = &at.place_deviation;
        struct lx_round_view view;
        double direction[3];
        random_direction(&random, lamp.axis);
        random_direction(&random, direction);
        for (int k = 0; k < 3; k++)
            at.place[k] = distance * direction[k];
        if (!lx_round_view_of(&lamp, &at, &view))
            continue;
        views++;
        for (int n = 0; n < PLACES; n++) {
            const double s = pick(&random, 2) ? 1 : uniform(&random, 0, 1),
                         t = pick(&random, 2) ? 1 : uniform(&random, 0, 1);
            const struct vector middle = vector_of(at.place), real = plus(middle, 1, random_way(&random, place->first));
            const struct vector beyond =
                plus(random_way(&random, place->second), (double complex)I, random_way(&random, place->imaginary));
            const struct vector told = seen_of(&lamp, &at, middle, s, t).from_center,
                                moved = seen_of(&lamp, &at, real, s, t).from_center,
                                all = seen_of(&lamp, &at, plus(real, 1, beyond), s, t).from_center;
            const double along = length_of_real(plus(moved, -1, told)) / (view.along * place->first);
            const struct vector more = plus(all, -1, moved);
            const double aside =
                fmax(length_of_real(more), length_of_imaginary(more)) / (view.aside * lx_beyond_real(place));
            assert_true(along <= 1 + 1e-9 && aside <= 1 + 1e-9);
            worst[0] = fmax(worst[0], along);
            worst[1] = fmax(worst[1], aside);
        }
    }
    print_message("# %zu views, of which up to %.2g and %.2g was there\n", views, worst[0], worst[1]);
    assert_true(views > BODIES / 2 && worst[0] > 0.5 && worst[1] > 0.5);
}

/* ---- parts ---- */

struct part {
    const struct lx_area_light *lamp;
    const struct lx_cell *cell;
    const struct lx_vicinity *at;
};

/* All of a part by the rule of Gauss, along t in pieces: a side may be one part. */
static double complex brightness_by_part(const struct lx_plan *plan, const struct lx_lobe_double *lobe,
                                         const void *what, bool is_dark, bool has_highlight, double complex x,
                                         double complex y)
{
    enum { RULE = 3, PIECES = 4, PLACES = RULE * RULE * PIECES };
    static const double places[] = {0.11270166537925831, 0.5, 0.88729833462074169}, weights[] = {5, 8, 5};
    const struct part *part = what;
    const struct lx_cell *cell = part->cell;
    struct vector normal;
    const struct vector place = place_at(plan, x, y, &normal);
    double complex sum = 0;
    for (int i = 0; i < PLACES; i++) {
        const int column = i % RULE, row = i / RULE % RULE, piece = i / (RULE * RULE);
        const double s = cell->s + cell->ds * places[column], t = cell->t + cell->dt * (piece + places[row]) / PIECES;
        const struct seen_place seen = seen_of(part->lamp, part->at, place, s, t);
        const struct vector way = plus(plus(vector_of(part->lamp->center), 1, seen.from_center), -1, place);
        const double complex e = part->lamp->radiance * seen.e * attenuated(&part->lamp->law, dot(way, way));
        const struct falling falling = falling_along(plan, way, e, place, normal);
        sum += weights[column] * weights[row] * brightness_of(lobe, falling, is_dark, has_highlight);
    }
    return sum * cell->ds * cell->dt / (18 * 18 * PIECES);
}

/* The cell of a part that was placed; a cylinder's side may have none. */
static void try_parts(const struct test_scene *test, struct workplace *work, const struct lx_square *square, int q,
                      struct randomness *random, void *data)
{
    const struct lx_plan *plan = &work->plan;
    const struct lx_round_parts *round = &plan->surfaces->smooth.round;
    const struct lx_lobe_double *lobe = &plan->surfaces->glossy_exact;
    const struct lx_basis *basis = &plan->bases[q % LX_BASES];
    struct lx_smooth_lights *lights = &work->fitting.round;
    struct lx_vicinity vicinity;
    size_t *tried = data;
    const struct lx_emitter *emitter = &test->lights[0];
    if (emitter->type == LX_CYLINDER) { /* its section along the axis, and an end */
        const double radius = emitter->radius_mm, area = 2 * radius * emitter->height_mm + M_PI * radius * radius;
        assert_true(fabs(plan->surfaces->smooth.gains[0] / (0.25 * 1000 * area) - 1) < 1e-9);
    }
    if (!lx_find_vicinity(plan, square, basis, &vicinity))
        return;
    lx_round_lights_place(round, &vicinity, lights);
    assert_true(lights->count == 0 || lights->count == round->count);
    plan->kernels->bound_smooth(&vicinity, lights, 0, lights->count, lobe, work->fitting.part_sizes);
    for (size_t i = 0; i < lights->count; i++) {
        const double size = work->fitting.part_sizes[i];
        const struct part part = {round->parts[i].lamp, &round->parts[i].cell, &vicinity};
        const struct lx_light_double about = {
            .kind = LX_BY_SQUARE, .x = lights->x[i], .y = lights->y[i], .z = lights->z[i]};
        assert_true(size == size);
        if (!isfinite(size) || size == 0)
            continue;
        ++tried[part.lamp->has_side];
        check_size_by(plan, lobe, brightness_by_part, &part, &about, size, &vicinity, square, basis, random);
    }
}

static void bounds_of_parts(void **state)
{
    (void)state;
    const struct campaign campaign = {.scenes = 400,
                                      .squares = SQUARES,
                                      .seed = UINT64_C(0xD1B54A32D192ED03),
                                      .make = make_scene,
                                      .visit = try_parts};
    size_t tried[2] = {0, 0};
    visit_by_all_sets(&campaign, tried);
    print_message("# bounds of %zu parts of balls, %zu of cylinders over squares\n", tried[0], tried[1]);
    assert_true(tried[0] > in_campaign(10000) && tried[1] > in_campaign(5000));
}

/* Whether a place, from the centre, is no farther from the middle of a part than that. */
static bool is_within(const struct lx_smooth_lights *made, size_t k, const struct lx_area_light *lamp,
                      struct vector seen, double real, double imaginary)
{
    const struct vector middle = {made->x[k], made->y[k], made->z[k]},
                        off = plus(plus(vector_of(lamp->center), 1, seen), -1, middle);
    return length_of_real(off) <= real * (1 + 1e-9) && length_of_imaginary(off) <= imaginary * (1 + 1e-9);
}

/* Every visible place is in its part, wherever it is seen from. */
static void check_places(const struct lx_area_light *lamp, const struct lx_vicinity *at,
                         const struct lx_round_parts *round, const struct lx_smooth_lights *made,
                         struct randomness *random)
{
    const struct lx_deviation *place = &at->place_deviation;
    const struct vector middle = vector_of(at->place);
    for (size_t k = 0; k < made->count; k++) {
        const struct lx_cell *cell = &round->parts[k].cell;
        const double s = cell->s + cell->ds * (pick(random, 2) ? pick(random, 2) : uniform(random, 0, 1)),
                     t = cell->t + cell->dt * (pick(random, 2) ? pick(random, 2) : uniform(random, 0, 1));
        const struct vector near = plus(middle, 1, random_way(random, place->tile)),
                            real = plus(middle, 1, random_way(random, place->first)),
                            beyond = plus(random_way(random, place->second), (double complex)I,
                                          random_way(random, place->imaginary));
        assert_true(is_within(made, k, lamp, seen_of(lamp, at, near, s, t).from_center, made->radius[k], 0));
        assert_true(is_within(made, k, lamp, seen_of(lamp, at, real, s, t).from_center, made->strays[k], 0));
        assert_true(is_within(made, k, lamp, seen_of(lamp, at, plus(real, 1, beyond), s, t).from_center,
                              made->strays[k], made->sways[k]));
    }
}

/* The parts are all of the body, and shine as it does. */
static void check_sums(const struct lx_area_light *lamp, const struct lx_vicinity *at,
                       const struct lx_round_parts *round, const struct lx_smooth_lights *made)
{
    struct lx_round_view view;
    double area = 0, gain = 0;
    for (size_t k = 0; k < made->count; k++) {
        area += round->parts[k].cell.ds * round->parts[k].cell.dt;
        gain += made->gain[k];
    }
    assert_true(fabs(area - 1) < 1e-12);
    assert_true(lx_round_view_of(lamp, at, &view));
    if (lamp->is_ball)
        assert_true(fabs(gain / (7 * M_PI * 150 * 150 / (1 - view.share)) - 1) < 1e-9);
}

static void parts_are_the_body(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        struct randomness random = {.state = UINT64_C(0xBF58476D1CE4E5B9) * ((uint64_t)i + 1)};
        static const double center[3] = {40, -700, 300};
        struct lx_emitter emitter = source_of(BALL + i % 2, center, 7, 0);
        const struct lx_shape lit = {.radius_mm = 200, .anchor_mm = {10, 20, 30}};
        struct lx_area_light lamp;
        struct lx_smooth_lights flat, made;
        struct lx_round_parts round;
        const double reach = logarithmic(&random, 1, 100);
        const struct lx_vicinity at = {
            .place = {uniform(&random, -200, 200), uniform(&random, -300, 200), uniform(&random, -200, 200)},
            .place_deviation = {.first = reach, .second = reach / 10, .imaginary = reach / 2, .tile = reach / 4}};
        assert_int_equal(lx_area_light_make(&emitter, &lit, NULL, &lamp), LUXEL_OK);
        struct lx_sampled source = {.emitter = &emitter, .lamp = &lamp, .law = LX_INVERSE_SQUARE};
        const struct lx_planned_surface surface = {.shape = lit, .glossy = &source, .glossy_count = 1};
        assert_int_equal(lx_smooth_parts_make(&surface, &flat, &round), 0);
        assert_int_equal(lx_round_lights_make(round.count, &made), 0);
        lx_round_lights_place(&round, &at, &made);
        assert_true(made.count == round.count && round.count >= 2);
        check_sums(&lamp, &at, &round, &made);
        check_places(&lamp, &at, &round, &made, &random);
        lx_smooth_lights_clear(&flat);
        lx_smooth_lights_clear(&made);
        lx_round_parts_clear(&round);
        lx_area_light_clear(&lamp);
    }
}

/* ---- irradiance by cylinders ---- */

static void bounds_of_cylinders(void **state)
{
    enum { CYLINDERS = 4000, PLACES = 4 };
    double tightest = 0;
    size_t bounds = 0;
    (void)state;
    for (int i = 0; i < CYLINDERS; i++) {
        struct randomness random = {.state = UINT64_C(0xD1B54A32D192ED03) * ((uint64_t)i + 1)};
        struct lx_area_light lamp = {.has_side = true, .round_mm = 100, .half_mm = logarithmic(&random, 10, 1000)};
        lamp.law =
            i % 2 ? (struct lx_area_light_law){.square = 1} : (struct lx_area_light_law){1e5, 1e2 * (i % 3), i % 5, 0};
        const double away = logarithmic(&random, 101, 2000), reach = away * logarithmic(&random, 0.0001, 0.1);
        struct lx_vicinity at = {.normal = {0, 0, 1}, .place_deviation = {.first = reach, .tile = reach / 4}};
        struct lx_deviation *place = &at.place_deviation;
        double direction[3];
        random_direction(&random, lamp.axis);
        random_direction(&random, direction);
        for (int k = 0; k < 3; k++)
            lamp.center[k] = away * direction[k] + (k == 2 ? away : 0);
        lamp.radius_mm = hypot(lamp.round_mm, lamp.half_mm);
        place->second = pick(&random, 2) ? 0 : reach / 10;
        place->imaginary = pick(&random, 2) ? 0 : reach / 2;
        const double gain = 4 * lamp.half_mm * lamp.round_mm + M_PI * lamp.round_mm * lamp.round_mm;
        const double bound = lx_smooth_area_light_bound(&lamp, gain, &at);
        if (!(bound > 0 && isfinite(bound)))
            continue;
        bounds++;
        for (int n = 0; n < PLACES; n++) {
            const struct vector beyond =
                plus(random_way(&random, place->second), (double complex)I, random_way(&random, place->imaginary));
            const struct vector seen_from = plus(random_way(&random, place->first), 1, beyond);
            const double share = cabs(irradiance_by_cylinder(&lamp, &at, seen_from, vector_of(at.normal))) / bound;
            assert_true(share <= 1.01); /* what the sum may be off by */
            tightest = fmax(tightest, share);
        }
    }
    print_message("# %zu bounds, of which up to %.2g was there\n", bounds, tightest);
    assert_true(bounds > CYLINDERS / 4 && tightest > 0.5);
}

/* None where the plane of an end goes through the square. */
static void ends_of_cylinders(void **state)
{
    struct lx_area_light lamp = {.has_side = true, .law.square = 1, .round_mm = 100, .half_mm = 200, .axis = {1, 0, 0}};
    const struct lx_vicinity at = {.normal = {0, 0, 1}, .place_deviation = {.first = 10, .tile = 10}};
    (void)state;
    lamp.center[2] = 1000;
    lamp.radius_mm = hypot(lamp.round_mm, lamp.half_mm);
    for (double x = 1; x < 400; x += 2) {
        lamp.center[0] = x;
        assert_true(isfinite(lx_smooth_area_light_bound(&lamp, 1, &at)) == (fabs(x - 200) > 10));
    }
}

/* Straight below a lamp its side is not seen: it has no parts there.  Beside it, and so near, they have no bound. */
static void hidden_sides(void **state)
{
    static const double center[3] = {0, 0, 500};
    struct lx_emitter emitter = source_of(CYLINDER, center, 7, 0);
    const double upright[3] = {0, 0, 1};
    const struct lx_shape lit = {.radius_mm = 200};
    struct lx_area_light lamp;
    struct lx_smooth_lights flat, made;
    struct lx_round_parts round;
    (void)state;
    emitter.axis = lx_unit3(lx_exact3(upright));
    assert_int_equal(lx_area_light_make(&emitter, &lit, NULL, &lamp), LUXEL_OK);
    struct lx_sampled source = {.emitter = &emitter, .lamp = &lamp, .law = LX_INVERSE_SQUARE};
    const struct lx_planned_surface surface = {.shape = lit, .glossy = &source, .glossy_count = 1};
    assert_int_equal(lx_smooth_parts_make(&surface, &flat, &round), 0);
    assert_int_equal(lx_round_lights_make(round.count, &made), 0);
    assert_true(flat.count > 0);
    struct lx_vicinity at = {.normal = {0, 0, 1}, .place_deviation = {.first = 40, .imaginary = 30, .tile = 10}};
    for (double x = 1; x < 600; x += 4) {
        at.place[0] = x;
        lx_round_lights_place(&round, &at, &made);
        const bool is_below = x<150 - 10, is_beside = x> 40 + sqrt(150 * 150 / 0.8 + 30 * 30);
        assert_true(made.count == (is_below ? 0 : round.count));
        for (size_t i = 0; i < made.count; i++)
            assert_true(x > 330 ? made.z[i] > 300 : is_beside || (made.x[i] == x && made.z[i] == 0));
        const bool is_bounded = isfinite(lx_smooth_area_light_bound(&lamp, 1, &at));
        assert_true(is_below || x > 330 ? is_bounded : is_beside || !is_bounded);
    }
    lx_smooth_lights_clear(&flat);
    lx_smooth_lights_clear(&made);
    lx_round_parts_clear(&round);
    lx_area_light_clear(&lamp);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places_move),  cmocka_unit_test(bounds_of_parts),     cmocka_unit_test(parts_are_the_body),
        cmocka_unit_test(hidden_sides), cmocka_unit_test(bounds_of_cylinders), cmocka_unit_test(ends_of_cylinders),
    };
    return cmocka_run_group_tests_name("panel rounds", tests, NULL, NULL);
}

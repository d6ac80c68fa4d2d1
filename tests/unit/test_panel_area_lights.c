/* SPDX-License-Identifier: MIT */
/* Polynomials in place of extended sources: their bounds against the irradiance, and those of their highlights, at
 * complex places, the polynomials against the reference at pixels. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "campaign.h"
#include "extended_sources.h"
#include "lamp_scenes.h"
#include "light/solid/extended.h"
#include "light/solid/facets.h"
#include "picture/plan_make.h"
#include "picture/seen.h"
#include "picture/area_light_bound.h"
#include "squares.h"
#include "world/reference.h"

/* Plans of scenes with highlights take long to make. */
enum { SQUARES = 6, GLOSSY_SQUARES = 24 };

/* ---- bounds ---- */

/* The sum of weights times (N.w)(-a.w) a(r)/r^2 over the middles of parts of a triangle. */
static double complex over_triangle(const struct lx_area_light_law *law, const double a[3], const double b[3],
                                    const double c[3], struct vector place, struct vector normal)
{
    enum { PARTS = 12 };
    const double ab[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, ac[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const struct vector face = {ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
                                ab[0] * ac[1] - ab[1] * ac[0]}; /* as long as twice the area */
    double complex sum = 0;
    for (int i = 0; i < PARTS * PARTS; i++) {
        const double s = (i % PARTS + 0.5) / PARTS, t = (i / PARTS + 0.5) / PARTS; /* a + s (ab + t (ac - ab)) */
        const struct vector at = {a[0] + s * (ab[0] + t * (ac[0] - ab[0])), a[1] + s * (ab[1] + t * (ac[1] - ab[1])),
                                  a[2] + s * (ab[2] + t * (ac[2] - ab[2]))};
        const struct vector way = plus(at, -1, place);
        const double complex square = dot(way, way);
        sum -= s * dot(normal, way) * dot(face, way) * attenuated(law, square) / square;
    }
    return sum / (PARTS * PARTS);
}

/* A corner of facets from the anchor. */
static void corner_of(const struct lx_facets *facets, const struct lx_face *face, unsigned i, const double anchor[3],
                      double corner[3])
{
    const lx_wide3 *from = &facets->corners_mm[facets->loop[face->first + i]];
    corner[0] = from->x.high - anchor[0], corner[1] = from->y.high - anchor[1], corner[2] = from->z.high - anchor[2];
}

/* The faces that are seen from the middle of the square. */
static double complex by_facets(const struct lx_area_light_law *law, const struct lx_facets *facets,
                                const struct lx_vicinity *at, const double anchor[3], struct vector place,
                                struct vector normal)
{
    double complex sum = 0;
    for (size_t f = 0; f < facets->face_count; f++) {
        const struct lx_face *face = &facets->faces[f];
        double corners[3][3], height = 0;
        corner_of(facets, face, 0, anchor, corners[0]);
        const double way[3] = {at->place[0] - corners[0][0], at->place[1] - corners[0][1],
                               at->place[2] - corners[0][2]};
        height += face->normal.x.high * way[0] + face->normal.y.high * way[1] + face->normal.z.high * way[2];
        for (unsigned i = 1; i + 1 < face->count && height > 0; i++) {
            corner_of(facets, face, i, anchor, corners[1]);
            corner_of(facets, face, i + 1, anchor, corners[2]);
            sum += over_triangle(law, corners[0], corners[1], corners[2], place, normal);
        }
    }
    return sum;
}

/* As a sum over rings: sin^2 of the angle from its centre is q (1 - v^2), q = R^2/d^2. */
static double complex by_ball(const struct lx_area_light *lamp, struct vector place, struct vector normal)
{
    enum { RINGS = 40 };
    const struct vector way = plus((struct vector){lamp->center[0], lamp->center[1], lamp->center[2]}, -1, place);
    const double radius = lamp->round_mm;
    const double complex square = dot(way, way), distance = csqrt(square), q = radius * radius / square;
    double complex sum = 0;
    for (int i = 0; i < RINGS; i++) {
        const double v = (i + 0.5) / RINGS;
        const double complex r = distance * csqrt(1 - q * (1 - v * v)) - radius * v;
        sum += 2 * v * r * r * attenuated(&lamp->law, r * r) / RINGS;
    }
    return M_PI * q * sum * dot(normal, way) / distance;
}

/* As a polygon of many corners, which is a little smaller. */
static double complex by_disk(const struct lx_area_light *lamp, struct vector place, struct vector normal)
{
    enum { CORNERS = 60 };
    const double *axis = lamp->axis, *center = lamp->center;
    const double beside[3] = {fabs(axis[0]) < 0.6, fabs(axis[0]) >= 0.6, 0};
    double u[3] = {beside[1] * axis[2], -beside[0] * axis[2], beside[0] * axis[1] - beside[1] * axis[0]};
    const double length = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (int k = 0; k < 3; k++)
        u[k] *= lamp->round_mm / length;
    const double v[3] = {axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2],
                         axis[0] * u[1] - axis[1] * u[0]};
    double complex sum = 0;
    for (int i = 0; i < CORNERS; i++) {
        double corners[2][3];
        for (int k = 0; k < 6; k++) {
            const double turn = 2 * M_PI * (i + k / 3) / CORNERS;
            corners[k / 3][k % 3] = center[k % 3] + cos(turn) * u[k % 3] + sin(turn) * v[k % 3];
        }
        sum += over_triangle(&lamp->law, center, corners[0], corners[1], place, normal);
    }
    return sum;
}

static double complex brightness(const struct lx_plan *plan, const struct lx_vicinity *at, double complex x,
                                 double complex y)
{
    const struct lx_planned_surface *surface = plan->surfaces;
    const struct lx_area_light *lamp = &surface->area_lights[0].lamp;
    struct vector normal;
    const struct vector place = place_at(plan, x, y, &normal);
    double complex sum = 0;
    switch (lamp->type) {
    case LX_FACETS:
        sum =
            by_facets(&lamp->law, surface->area_lights[0].emitter->facets, at, surface->shape.anchor_mm, place, normal);
        break;
    case LX_DISK: sum = by_disk(lamp, place, normal); break;
    case LX_BALL: sum = by_ball(lamp, place, normal); break;
    default: sum = irradiance_by_cylinder(lamp, at, place, normal); break;
    }
    return surface->lobe_exact.diffuse * lamp->radiance * sum;
}

struct tally {
    bool has_bounds; /* and not polynomials alone */
    size_t bounds, dark, squares;
    double tightest;               /* the largest share of a bound that was found */
    double worst, worst_of_itself; /* what polynomials are off by */
};

static void try_bound(struct workplace *work, const struct lx_square *square, const struct lx_basis *basis,
                      struct randomness *random, struct tally *tally)
{
    enum { PLACES = 10 };
    const struct lx_plan *plan = &work->plan;
    struct lx_vicinity vicinity;
    if (!lx_find_vicinity(plan, square, basis, &vicinity))
        return;
    const double bound =
        lx_smooth_area_light_bound(&plan->surfaces->area_lights[0].lamp, plan->surfaces->smooth.gains[0], &vicinity);
    assert_true(bound >= 0);
    tally->bounds += bound > 0 && isfinite(bound);
    tally->dark += bound == 0;
    for (int k = 0; k < PLACES && bound > 0 && isfinite(bound); k++) {
        double complex place[2];
        random_place(random, square, basis, place);
        const double share = cabs(brightness(plan, &vicinity, place[0], place[1])) / bound;
        assert_true(share <= 1);
        tally->tightest = fmax(tally->tightest, share);
    }
}

/* ---- bounds of highlights ---- */

/* A part as a light that stands at one of its places. */
static struct lx_light_double place_of_part(const struct lx_smooth_lights *parts, size_t i, struct randomness *random)
{
    double direction[3];
    random_direction(random, direction);
    const double off = parts->radius[i] * (pick(random, 2) ? 1 : uniform(random, 0, 1));
    return (struct lx_light_double){
        .kind = LX_PROFILED,
        .x = parts->x[i] + off * direction[0],
        .y = parts->y[i] + off * direction[1],
        .z = parts->z[i] + off * direction[2],
        .gain = parts->gain[i],
        .law = LX_POLYNOMIAL,
        .by_none = parts->by_none[i],
        .by_root = 1e3 * parts->by_root[i], /* of metres */
        .by_square = 1e6 * parts->by_square[i],
        .axis_x = parts->axis_x[i],
        .axis_y = parts->axis_y[i],
        .axis_z = parts->axis_z[i],
        .exponent = {.value = 1, .whole = 1},
    };
}

static void try_parts(const struct test_scene *test, struct workplace *work, const struct lx_square *square, int q,
                      struct randomness *random, void *data)
{
    enum { PLACES = 3 };
    const struct lx_plan *plan = &work->plan;
    const struct lx_smooth_lights *parts = &plan->surfaces->smooth.parts;
    const struct lx_lobe_double *lobe = &plan->surfaces->glossy_exact;
    const struct lx_basis *basis = &plan->bases[q % LX_BASES];
    struct lx_vicinity vicinity;
    size_t *tried = data;
    (void)test;
    if (!lx_find_vicinity(plan, square, basis, &vicinity))
        return;
    plan->kernels->bound_smooth(&vicinity, parts, 0, parts->count, lobe, work->fitting.part_sizes);
    for (size_t i = 0; i < parts->count; i++) {
        const double size = work->fitting.part_sizes[i];
        assert_true(size == size);
        if (!isfinite(size) || size == 0)
            continue;
        ++*tried;
        for (int k = 0; k < PLACES; k++) {
            const struct lx_light_double light = place_of_part(parts, i, random);
            check_size(plan, lobe, &light, size, &vicinity, square, basis, random);
        }
    }
}

static void bounds_of_highlights(void **state)
{
    (void)state;
    const struct campaign campaign = {
        .scenes = 600,
        .squares = GLOSSY_SQUARES,
        .seed = UINT64_C(0xD1B54A32D192ED03),
        .make = make_glossy_lamp_scene,
        .clear = clear_lamp_scene,
        .visit = try_parts,
    };
    size_t tried = 0;
    visit_by_all_sets(&campaign, &tried);
    print_message("# bounds of %zu parts over squares\n", tried);
    assert_true(tried > in_campaign(50000));
}

/* The bound of a part that stands so high over a place, beside which nothing has any deviation; its highlight is cut
 * off, or fades, at the horizon. */
static double bound_of_part(const struct lx_kernels *kernels, double height_mm, enum lx_highlight highlight)
{
    const struct lx_vicinity at = {.normal = {0, 0, 1}, .view = {0, 0, 1}, .slip = HUGE_VAL};
    const struct lx_lobe_double lobe = {
        .model = LX_BLINN_PHONG, .highlight = highlight, .specular = 1, .exponent = {.value = 1, .whole = 1}};
    struct lx_light_double light = {
        .kind = LX_BY_SQUARE, .law = LX_INVERSE_SQUARE, .falloff = LX_NO_CONE, .x = 300, .z = height_mm, .gain = 1};
    const struct lx_lights lights = {.exacts = &light, .count = 1};
    struct lx_smooth_lights parts;
    _Alignas(64) double sizes[LX_LANES];
    assert_int_equal(lx_smooth_lights_make(&lights, NULL, &parts), LUXEL_OK);
    for (size_t i = 0; i < LX_LANES; i++)
        parts.radius[i] = parts.strays[i] = 50;
    kernels->bound_smooth(&at, &parts, 0, 1, &lobe, sizes);
    lx_smooth_lights_clear(&parts);
    return fabs(sizes[0]);
}

/* What a point gives there whose highlight fades. */
static double fading(double x_mm, double height_mm)
{
    const double square = x_mm * x_mm + height_mm * height_mm, cosine = height_mm / sqrt(square);
    return cosine * sqrt((1 + cosine) / 2) / square; /* the half vector is half as far from the normal */
}

static void parts_over_the_horizon(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++) {
        const struct lx_kernels *kernels = lx_kernels_get(k);
        if (!kernels->runs())
            continue;
        for (double height = 55; height < 1000; height *= 1.5) {
            const double bound = bound_of_part(kernels, height, LX_HIGHLIGHT_COSINE);
            assert_true(isfinite(bound) && isfinite(bound_of_part(kernels, height, LX_HIGHLIGHT_GATED)));
            for (int degrees = 0; degrees < 360; degrees += 10) {
                const double turn = degrees * M_PI / 180;
                assert_true(fading(300 + 50 * cos(turn), height + 50 * sin(turn)) <= bound);
            }
        }
        for (double height = -45; height < 50; height += 10) {
            assert_true(isinf(bound_of_part(kernels, height, LX_HIGHLIGHT_GATED)));
            assert_true(isinf(bound_of_part(kernels, height, LX_HIGHLIGHT_COSINE)));
        }
        assert_true(bound_of_part(kernels, -55, LX_HIGHLIGHT_GATED) == 0);
    }
}

/* Every place of a flat source is in one of its parts, and these shine with all of its area. */
static void parts_are_the_source(void **state)
{
    static const double center[3] = {40, -700, 300};
    (void)state;
    for (int kind = RECTANGLE; kind < SOURCES; kind++) {
        struct randomness random = {.state = UINT64_C(0x94D049BB133111EB) + (uint64_t)kind};
        struct lx_emitter emitter = source_of(kind, center, 7, 0);
        const struct lx_shape lit = {.radius_mm = 200, .anchor_mm = {10, 20, 30}};
        struct lx_area_light lamp;
        struct lx_smooth_lights parts;
        struct lx_round_parts round;
        assert_int_equal(lx_area_light_make(&emitter, &lit, NULL, &lamp), LUXEL_OK);
        struct lx_sampled source = {.emitter = &emitter, .lamp = &lamp, .law = LX_INVERSE_SQUARE};
        const struct lx_planned_surface surface = {.shape = lit, .glossy = &source, .glossy_count = 1};
        const bool is_smooth = lx_has_smooth_highlights(&surface);
        assert_true(is_smooth == (lx_patch_limit(&lamp) <= 64));
        if (kind > DISK) {
            lx_area_light_clear(&lamp);
            continue;
        }
        assert_int_equal(lx_smooth_parts_make(&surface, &parts, &round), 0);
        assert_true(round.count == 0);
        double gain = 0;
        for (size_t i = 0; i < parts.count; i++)
            gain += parts.gain[i];
        assert_true(fabs(gain / (7 * lx_extended_area_mm2(&emitter).value) - 1) < 1e-9);
        const struct lx_around everywhere = {.radius = HUGE_VAL};
        struct lx_patch *patches = calloc(lx_patch_limit(&lamp), sizeof *patches);
        assert_non_null(patches);
        const size_t count = lx_patches_make(&lamp, &everywhere, NULL, patches);
        for (int k = 0; k < 2000; k++) {
            const struct lx_patch *patch = &patches[pick(&random, (int)count)];
            struct lx_samples_double samples;
            lx_cell_samples(patch, &(struct lx_cell){uniform(&random, 0, 1), uniform(&random, 0, 1), 0, 0}, 1, 1, 0,
                            &samples);
            bool is_in_one = false;
            for (size_t i = 0; i < parts.count && !is_in_one; i++) {
                const double x = samples.x[0] - parts.x[i], y = samples.y[0] - parts.y[i],
                             z = samples.z[0] - parts.z[i];
                const double cosine =
                    parts.axis_x[i] * patch->n[0] + parts.axis_y[i] * patch->n[1] + parts.axis_z[i] * patch->n[2];
                is_in_one = cosine > 1 - 1e-12 && sqrt(x * x + y * y + z * z) <= parts.radius[i] * (1 + 1e-12);
            }
            assert_true(is_in_one);
        }
        free(patches);
        lx_round_parts_clear(&round);
        lx_smooth_lights_clear(&parts);
        lx_area_light_clear(&lamp);
        lx_facets_free(emitter.facets);
    }
}

/* A disk is whole above the horizon where its lowest place is. */
static void disks(void **state)
{
    const struct lx_vicinity at = {.normal = {0, 0, 1}, .view = {0, 0, 1}};
    (void)state;
    for (int degrees = 5; degrees < 90; degrees += 10) {
        const double turn = degrees * M_PI / 180, reach = 100 * sin(turn);
        struct lx_area_light lamp = {
            .is_disk = true, .law.square = 1, .axis = {-sin(turn), 0, -cos(turn)}, .center = {300, 0, 1.001 * reach}};
        lamp.radius_mm = lamp.round_mm = 100;
        assert_true(isfinite(lx_smooth_area_light_bound(&lamp, 1, &at)));
        lamp.center[2] = 0.999 * reach;
        assert_true(isinf(lx_smooth_area_light_bound(&lamp, 1, &at)));
        lamp.center[2] = -0.999 * reach;
        assert_true(isinf(lx_smooth_area_light_bound(&lamp, 1, &at)));
        lamp.center[2] = -1.001 * reach;
        assert_true(lx_smooth_area_light_bound(&lamp, 1, &at) == 0);
    }
}

/* ---- plans ---- */

/* Plans are made in no time, also where samples of the picture show little or nothing of highlights that bounds say are
 * there: by the scenes of those numbers it took minutes, or longer than anybody waits. */
static void plans_end(void **state)
{
    (void)state;
    enum { USUAL = 100 };
    static const int known[] = {3348, 3614, 3644};
    enum { KNOWN = sizeof known / sizeof *known };
    size_t k = 0;
    while (!lx_kernels_get(k)->runs())
        k++;
    for (int i = 0; i < scenes_to_try(USUAL); i++) {
        const int number = i < KNOWN ? known[i] : i;
        struct test_scene test;
        struct lx_plan plan;
        luxel_settings settings = {.precision = make_narrow_lamp_scene(number, &test)};
        assert_int_equal(lx_plan_make(&test.prepared, lx_kernels_get(k), &settings, &plan), LUXEL_OK);
        lx_plan_clear(&plan);
        clear_lamp_scene(&test);
    }
}

/* ---- polynomials ---- */

static double exact_value(const struct test_scene *test, const struct workplace *work, double x, double y)
{
    struct lx_element element;
    double sum = 0;
    assert_true(lx_element_seen(&test->prepared, x, y, &element));
    for (size_t i = 0; i < test->prepared.emitters.count; i++) {
        const size_t lights = work->plan.surfaces->smooth.lights.count, light = i == 0 ? lights : 0;
        const struct lx_lighting lighting = lx_light_element(&test->prepared, &element, &test->lights[i]);
        if (test->lights[i].type == LX_UNIFORM || !work->fitting.is_left[light])
            sum += lighting.diffuse.value + (i > 0 ? lighting.specular.value : 0);
    }
    return sum;
}

static void try_square(const struct test_scene *test, struct workplace *work, const struct lx_square *square,
                       int pixels, struct randomness *random, struct tally *tally)
{
    const struct lx_plan *plan = &work->plan;
    float values[LX_PANEL_SIDE * LX_PANEL_SIDE];
    double allowance = 8e-7 * plan->least_maximum;
    memset(work->fitting.is_left, 1, plan->surfaces->smooth.count);
    if (!lx_smooth_fit(plan, &work->fitting, work->shader, square, plan->surfaces->uniform, true, NULL, &allowance))
        return;
    for (size_t i = 0; i < work->fitting.count; i++)
        plan->kernels->spread_polynomial(&work->fitting.polynomials[i], square->side, square->side, i > 0, values,
                                         LX_PANEL_SIDE);
    tally->squares++;
    for (int k = 0; k < pixels; k++) {
        const int column = pick(random, (int)square->side), row = pick(random, (int)square->side);
        const double t = (2 * column + 1) / (double)square->side - 1, u = (2 * row + 1) / (double)square->side - 1;
        const double value = (double)values[row * LX_PANEL_SIDE + column];
        const double exact =
            exact_value(test, work, square->x_mm + square->half_mm[0] * t, square->y_mm - square->half_mm[1] * u);
        assert_true(value >= 0);
        const double off = fmax(fabs(value - exact) - (double)FLT_MIN, 0);
        tally->worst = fmax(tally->worst, off / fmax(plan->least_maximum, exact));
        tally->worst_of_itself = fmax(tally->worst_of_itself, off / exact);
    }
}

static void visit_diffuse(const struct test_scene *test, struct workplace *work, const struct lx_square *square, int q,
                          struct randomness *random, void *data)
{
    struct tally *tally = data;
    if (tally->has_bounds)
        try_bound(work, square, &work->plan.bases[q % LX_BASES], random, tally);
    try_square(test, work, square, 8, random, tally);
}

static void squares(void **state)
{
    (void)state;
    const struct campaign campaign = {
        .scenes = 1500,
        .squares = SQUARES,
        .seed = UINT64_C(0xD1B54A32D192ED03),
        .make = make_lamp_scene,
        .clear = clear_lamp_scene,
        .visit = visit_diffuse,
    };
    bool is_first = true;
    for (size_t k = 0; lx_kernels_get(k); k++) {
        struct tally tally = {.has_bounds = is_first};
        if (!lx_kernels_get(k)->runs())
            continue;
        is_first = false;
        visit_squares(&campaign, lx_kernels_get(k), &tally);
        print_message("# %s: %zu bounds, of which up to %.2g was there, %zu dark; %zu squares, off by %.2g of the "
                      "maximum, %.2g of themselves\n",
                      lx_kernels_get(k)->name, tally.bounds, tally.tightest, tally.dark, tally.squares, tally.worst,
                      tally.worst_of_itself);
        assert_true(!tally.has_bounds ||
                    (tally.bounds > in_campaign(150) && tally.dark > in_campaign(50) && tally.tightest > 0.1));
        assert_true(tally.squares > in_campaign(150) && tally.worst <= 1.2e-6 && tally.worst_of_itself <= 1e-3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(disks),
        cmocka_unit_test(squares),
        cmocka_unit_test(parts_are_the_source),
        cmocka_unit_test(parts_over_the_horizon),
        cmocka_unit_test(bounds_of_highlights),
        cmocka_unit_test(plans_end),
    };
    return cmocka_run_group_tests_name("panel area_lights", tests, NULL, NULL);
}

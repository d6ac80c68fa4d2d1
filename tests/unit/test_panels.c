/* SPDX-License-Identifier: MIT */
/* Polynomials in place of lights: the bounds against the brightness at complex places, and the polynomials against the
 * reference at pixels. */
#include <complex.h>
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
#include "picture/seen.h"
#include "squares.h"
#include "world/reference.h"

enum { SQUARES = 6, LIGHTS_AT_MOST = MAXIMUM_LIGHTS };

/* ---- random squares ---- */

/* Under one light, which may be so near that its direction changes as much as the normal does, and of which the whole
 * highlight counts: its peak, and the faint foot that is all there is where the light does not come. */
static void leave_one_light(struct randomness *random, struct test_scene *test)
{
    const struct lx_shape *shape = &test->surfaces[0].shape;
    const struct lx_material material = {
        .model = pick(random, 2) ? LX_BLINN_PHONG : LX_PHONG,
        .diffuse = pick(random, 2) ? 0 : 0.5,
        .specular = 0.5,
        .shininess = floor(logarithmic(random, 2, 2000)),
    };
    const double away = shape->radius_mm * logarithmic(random, 0.05, 3);
    double direction[3];
    random_direction(random, direction);
    direction[2] = fabs(direction[2]);
    test->surfaces[0].lobe = lx_lobe_prepare(&material);
    test->prepared.emitters.count = 1;
    test->lights[0].type = LX_POINT;
    test->lights[0].profile = lx_profile_isotropic();
    for (int i = 0; i < 3; i++)
        test->lights[0].position_mm[i] =
            shape->anchor_mm[i] + (shape->type == LX_PLATE ? away * (shape->axis[i] + 0.5 * direction[i])
                                                           : (shape->radius_mm + away) * direction[i]);
}

/* Brings an observer nearer, so that lines of sight go apart. */
static void come_near(struct randomness *random, struct test_scene *test)
{
    const struct lx_shape *shape = &test->surfaces[0].shape;
    test->scene.observer.z_mm =
        fmax(shape->anchor_mm[2] + shape->radius_mm * logarithmic(random, 1.05, 1000), 0.1 * shape->radius_mm);
    test->prepared.camera = lx_camera_of(&test->scene.observer);
}

/* One surface, in pixels so small that the picture is shaded by panels. */
static void make_scene(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 1)};
    make_random_scene(&random, i % 3 == 0, test);
    const unsigned finer = (unsigned)logarithmic(&random, 8, 200);
    if (i % 4 == 3)
        leave_one_light(&random, test);
    test->prepared.surface_count = 1;
    test->prepared.shadows = false;
    if (test->scene.observer.projection == LX_PERSPECTIVE)
        come_near(&random, test);
    test->scene.screen.resolution[0] *= finer;
    test->scene.screen.resolution[1] *= finer;
}

/* ---- bounds at complex places ---- */

/* Whether a vector at a complex place, or within the square, is as near to the one in its middle as was said. */
static bool keeps_to(struct vector v, const double middle[3], const struct lx_deviation *deviation, bool is_in_square)
{
    const struct vector real = {creal(v.x) - middle[0], creal(v.y) - middle[1], creal(v.z) - middle[2]};
    const struct vector imaginary = {cimag(v.x), cimag(v.y), cimag(v.z)};
    const double off = sqrt(creal(dot(real, real))), size = sqrt(creal(dot(imaginary, imaginary)));
    const double more = 1e-9 * (1 + sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2]));
    return is_in_square ? off <= deviation->tile + more
                        : off <= deviation->first + deviation->second + more && size <= deviation->imaginary + more;
}

static void try_vicinity(const struct lx_plan *plan, const struct lx_vicinity *vicinity, double complex x,
                         double complex y, bool is_in_square)
{
    struct vector normal;
    const struct vector place = place_at(plan, x, y, &normal);
    assert_true(keeps_to(place, vicinity->place, &vicinity->place_deviation, is_in_square));
    assert_true(keeps_to(normal, vicinity->normal, &vicinity->normal_deviation, is_in_square));
    assert_true(keeps_to(view_at(plan, place), vicinity->view, &vicinity->view_deviation, is_in_square));
}

/* How many lights over a square have a bound that is tried. */
static size_t try_bounds(struct workplace *work, const struct lx_square *square, const struct lx_basis *basis,
                         struct randomness *random)
{
    enum { PLACES = 40 };
    const struct lx_plan *plan = &work->plan;
    const size_t count = plan->surfaces->smooth.lights.count;
    struct lx_vicinity vicinity;
    size_t tried = 0;
    if (!lx_find_vicinity(plan, square, basis, &vicinity))
        return 0;
    for (int k = 0; k < PLACES; k++) {
        double complex place[2];
        random_place(random, square, basis, place);
        try_vicinity(plan, &vicinity, place[0], place[1], false);
        const double across = k < 4 ? k % 2 * 2 - 1 : uniform(random, -1, 1),
                     down = k < 4 ? k / 2 * 2 - 1 : uniform(random, -1, 1);
        try_vicinity(plan, &vicinity, square->x_mm + across * square->half_mm[0],
                     square->y_mm + down * square->half_mm[1], true);
    }
    plan->kernels->bound_smooth(&vicinity, &plan->surfaces->smooth.lights, 0, plan->surfaces->smooth.lights.count,
                                &plan->surfaces->lobe_exact, work->fitting.sizes);
    for (size_t i = 0; i < count; i++) {
        const double size = work->fitting.sizes[i];
        assert_true(size == size);
        if (!isfinite(size) || size == 0)
            continue;
        tried++;
        for (int k = 0; k < PLACES; k++)
            check_size(plan, &plan->surfaces->lobe_exact, &plan->surfaces->lights.exacts[i], size, &vicinity, square,
                       basis, random);
    }
    return tried;
}

/* How many feet of highlights over a square have a bound that is tried, each light as if it were alone: of the root at
 * complex places, of the highlight in the square, and that there is no light there but the highlight. */
static size_t try_feet(const struct workplace *work, const struct lx_square *square, const struct lx_basis *basis,
                       struct randomness *random)
{
    enum { PLACES = 20 };
    const struct lx_plan *plan = &work->plan;
    const struct lx_lobe_double *lobe = &plan->surfaces->lobe_exact;
    struct lx_vicinity vicinity;
    size_t tried = 0;
    if (lobe->model == LX_LAMBERT || lobe->highlight != LX_HIGHLIGHT_PLAIN || lobe->exponent.whole == 0 ||
        !lx_find_vicinity(plan, square, basis, &vicinity))
        return 0;
    for (size_t i = 0; i < plan->surfaces->smooth.lights.count; i++) {
        const struct lx_light_double *light = &plan->surfaces->lights.exacts[i];
        const struct lx_foot foot = plan->kernels->bound_foot(&vicinity, &plan->surfaces->smooth.lights, i, lobe);
        const double n = lobe->exponent.value;
        assert_true(foot.root >= 0 && foot.most >= 0);
        if (!(foot.root < HUGE_VAL))
            continue;
        tried++;
        for (int k = 0; k < PLACES; k++) {
            double complex place[2];
            random_place(random, square, basis, place);
            const struct falling far = falling_at(plan, light, place[0], place[1]);
            assert_true(cabs(cpow(far.e * lobe->specular, 1 / n) * far.s) <= foot.root * (1 + 1e-7));
            const double x = square->x_mm + square->half_mm[0] * uniform(random, -1, 1),
                         y = square->y_mm + square->half_mm[1] * uniform(random, -1, 1);
            const struct falling near = falling_at(plan, light, x, y);
            const double s = creal(near.s), e = creal(near.e);
            assert_true(s > 0 && e * lobe->specular * pow(s, n) <= foot.most * (1 + 1e-7));
            /* where it sets within the square its diffuse light is known by the size below 0 */
            assert_true(lobe->diffuse == 0 || creal(near.cosine) <= 0 || work->fitting.sizes[i] < 0);
        }
    }
    return tried;
}

struct tried {
    size_t bounds[LX_BASES], feet;
};

static void visit_bounds(const struct test_scene *test, struct workplace *work, const struct lx_square *square, int q,
                         struct randomness *random, void *data)
{
    struct tried *tried = data;
    (void)test;
    (void)q;
    for (int b = 0; b < LX_BASES; b++) {
        tried->bounds[b] += try_bounds(work, square, &work->plan.bases[b], random);
        tried->feet += try_feet(work, square, &work->plan.bases[b], random);
    }
}

static void test_bounds(void **state)
{
    (void)state;
    const struct campaign campaign = {
        .scenes = 3000,
        .squares = SQUARES,
        .seed = UINT64_C(0xD1B54A32D192ED03),
        .make = make_scene,
        .visit = visit_bounds,
    };
    struct tried tried = {{0}, 0};
    visit_by_all_sets(&campaign, &tried);
    for (int b = 0; b < LX_BASES; b++) {
        print_message("# bounds of %zu lights over squares\n", tried.bounds[b]);
        assert_true(tried.bounds[b] > in_campaign(1000));
    }
    print_message("# and of %zu feet of highlights\n", tried.feet);
    assert_true(tried.feet > in_campaign(1000));
}

/* ---- polynomials ---- */

/* What a polynomial through nodes is off by, of a function with a pole just beyond the ellipse: nearly as much as its
 * share of the bound, and no more. */
static void check_share(const struct lx_basis *basis)
{
    const double end = (basis->reach + 1 / basis->reach) / 2, pole = 1.02 * end, most = 1 / (pole - end);
    double worst = 0;
    for (double x = -1; x <= 1; x += 1.0 / 64) {
        double sum = 0;
        for (unsigned i = 0; i < basis->nodes; i++)
            for (unsigned k = 0; k < basis->nodes; k++)
                sum += basis->series[i][k] * cos(k * acos(x)) / (pole - basis->place[i]);
        worst = fmax(worst, fabs(sum - 1 / (pole - x)));
    }
    assert_true(worst <= basis->share * most && worst >= 1e-3 * basis->share * most);
}

static void test_shares(void **state)
{
    (void)state;
    struct test_scene test;
    struct workplace work;
    size_t k = 0;
    while (!lx_kernels_get(k)->runs())
        k++;
    make_scene(0, &test);
    assert_true(open_workplace(&test, lx_kernels_get(k), &work));
    for (int b = 0; b < LX_BASES; b++)
        check_share(&work.plan.bases[b]);
    close_workplace(&work);
}

/* The brightness by lights that are not left, and what all emitters that are no lights give. */
static double exact_value(const struct test_scene *test, const struct workplace *work, double x, double y)
{
    struct lx_element element;
    double sum = 0;
    size_t light = 0;
    assert_true(lx_element_seen(&test->prepared, x, y, &element));
    for (size_t i = 0; i < test->prepared.emitters.count; i++) {
        const struct lx_emitter *emitter = &test->lights[i];
        if (emitter->type != LX_UNIFORM && work->fitting.is_left[light++])
            continue;
        struct lx_lighting lighting = lx_light_element(&test->prepared, &element, emitter);
        sum += lighting.diffuse.value + lighting.specular.value;
    }
    return sum;
}

struct tally {
    size_t squares, folded, feet;
    double worst, worst_of_itself;
    double worst_rounding; /* beyond what the polynomials are said to be off by */
};

/* What stood in a block before must not count, not even in its last vector beyond the nodes. */
static void leave_rubbish(struct lx_block_double *block)
{
    for (size_t i = 0; i < LX_BLOCK; i++)
        block->px[i] = block->py[i] = block->pz[i] = HUGE_VAL;
}

static void try_square(const struct test_scene *test, struct workplace *work, const struct lx_square *square, int q,
                       struct randomness *random, void *data)
{
    enum { PIXELS = 12 };
    const struct lx_plan *plan = &work->plan;
    struct tally *tally = data;
    const double allowed = 8e-7 * plan->least_maximum;
    float values[LX_PANEL_SIDE * LX_PANEL_SIDE];
    double allowance = allowed;
    (void)q;
    memset(work->fitting.is_left, 1, plan->surfaces->smooth.lights.count);
    leave_rubbish(&lx_shader_seen(work->shader)->block);
    if (!lx_smooth_fit(plan, &work->fitting, work->shader, square, plan->surfaces->uniform, true, NULL, &allowance))
        return;
    assert_true(allowance >= 0 && allowance <= allowed);
    for (size_t i = 0; i < work->fitting.count; i++)
        plan->kernels->spread_polynomial(&work->fitting.polynomials[i], square->side, square->side, i > 0, values,
                                         LX_PANEL_SIDE);
    tally->squares++;
    tally->folded += work->fitting.count > 1;
    tally->feet += work->fitting.polynomials[0].power > 1;
    for (int k = 0; k < PIXELS; k++) {
        const int column = k == 0 ? 0 : pick(random, (int)square->side),
                  row = k == 1 ? 0 : pick(random, (int)square->side);
        const double t = (2 * column + 1) / (double)square->side - 1, u = (2 * row + 1) / (double)square->side - 1;
        const double value = (double)values[row * LX_PANEL_SIDE + column];
        const double exact =
            exact_value(test, work, square->x_mm + square->half_mm[0] * t, square->y_mm - square->half_mm[1] * u);
        assert_true(value >= 0);
        const double maximum = fmax(plan->least_maximum, exact);
        const double off = fmax(fabs(value - exact) - (double)FLT_MIN, 0); /* digits end below the normal numbers */
        tally->worst = fmax(tally->worst, off / maximum);
        tally->worst_rounding = fmax(tally->worst_rounding, (off - (allowed - allowance)) / maximum);
        tally->worst_of_itself = fmax(tally->worst_of_itself, off / exact);
    }
}

static void test_polynomials(void **state)
{
    (void)state;
    const struct campaign campaign = {
        .scenes = 3000,
        .squares = SQUARES,
        .seed = UINT64_C(0xA0761D6478BD642F),
        .make = make_scene,
        .visit = try_square,
    };
    for (size_t k = 0; lx_kernels_get(k); k++) {
        struct tally tally = {0};
        if (!lx_kernels_get(k)->runs())
            continue;
        visit_squares(&campaign, lx_kernels_get(k), &tally);
        print_message("# %s: %zu squares, %zu with folds, %zu feet; off by %.2g of the maximum, %.2g of themselves\n",
                      lx_kernels_get(k)->name, tally.squares, tally.folded, tally.feet, tally.worst,
                      tally.worst_of_itself);
        assert_true(tally.squares > in_campaign(1000) && tally.folded > in_campaign(50) &&
                    tally.feet > in_campaign(50));
        assert_true(tally.worst <= 1.2e-6 && tally.worst_of_itself <= 1e-3 && tally.worst_rounding <= 4.6e-7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bounds),
        cmocka_unit_test(test_shares),
        cmocka_unit_test(test_polynomials),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

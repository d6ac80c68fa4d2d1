/* SPDX-License-Identifier: MIT */
/*
 * Adaptive integration: powers are integrated exactly up to the degree of each rule, which holds every node and weight;
 * what the estimate is where a function is steep, falls to an end, or vanishes; and which panel is halved, and until
 * when.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "world/integral/adaptive.h"

enum { NODES = 21, MOST_PANELS = 64 };

struct problem {
    double (*of)(const struct problem *problem, double x);
    double parameter;
    double target, relative;
    unsigned calls, asked;
};

static struct lx_point_value at(void *data, size_t interval, double x)
{
    struct problem *problem = data;
    problem->calls++;
    return (struct lx_point_value){.value = problem->of(problem, x) * (double)(1 + interval), .error = 0.5 + x * x};
}

static double target(void *data, const struct lx_integral *integral)
{
    struct problem *problem = data;
    problem->asked++;
    return problem->target + problem->relative * integral->value;
}

static struct lx_integral integrate(struct problem *problem, struct lx_panel *items, size_t count, size_t capacity)
{
    const struct lx_integrand integrand = {.at = at, .target = target, .data = problem};
    struct lx_panels panels = {items, count, capacity};
    return lx_integrate_panels(&integrand, &panels);
}

/* One panel, not to be halved. */
static struct lx_integral look(struct problem *problem, double from, double to)
{
    struct lx_panel panel = {.from = from, .to = to};
    struct lx_integral found = integrate(problem, &panel, 1, 1);
    assert_true(found.value == panel.value && found.error == panel.estimate && found.inherited == panel.inherited);
    return found;
}

static void assert_near(double found, double expected, double relative)
{
    if (!(fabs(found - expected) <= relative * fabs(expected)))
        fail_msg("%.17g instead of %.17g", found, expected);
}

/* -- the rules -- */

static double even_power(const struct problem *problem, double x)
{
    return 1 + pow(x * x, problem->parameter);
}

/* The rule with 21 points is exact up to x^31, that with 10 up to x^19, beyond which its error is known. */
static void powers(void **state)
{
    (void)state;
    for (int k = 0; k <= 15; k++) {
        struct problem problem = {.of = even_power, .parameter = k};
        struct lx_integral found = look(&problem, -1, 1);
        assert_near(found.value, 2 + 2.0 / (2 * k + 1), 1e-14);
        if (k <= 9)
            assert_true(found.error <= 1e-12);
        assert_int_equal(problem.calls, NODES + 2);
        assert_near(found.inherited, 1 + 2.0 / 3, 1e-14); /* of 1/2 + x^2 */
    }
    struct problem problem = {.of = even_power, .parameter = 10};
    double tenth = tgamma(11), off = ldexp(1, 21) * pow(tenth, 4) / (21 * pow(tgamma(21), 2));
    assert_near(look(&problem, -1, 1).error, 10 * off, 1e-6);
    problem.parameter = 16; /* the first even power that 21 points are wrong about */
    double beyond = look(&problem, -1, 1).value - (2 + 2.0 / 33);
    assert_true(fabs(beyond) > 1e-12 && fabs(beyond) < 1e-8);
}

static double whole_power(const struct problem *problem, double x)
{
    return pow(x, problem->parameter);
}

/* On any panel: the integral of x^k from 2 to 5. */
static void other_panels(void **state)
{
    (void)state;
    for (int k = 0; k <= 19; k++) {
        struct problem problem = {.of = whole_power, .parameter = k};
        struct lx_integral found = look(&problem, 2, 5);
        assert_near(found.value, (pow(5, k + 1) - pow(2, k + 1)) / (k + 1), 1e-14);
        assert_true(found.error <= 1e-12 * found.value);
        assert_near(found.inherited, 0.5 * 3 + (125.0 - 8) / 3, 1e-14);
    }
}

/* -- what is believed -- */

/* exp(parameter) from the middle on, else 1. */
static double step(const struct problem *problem, double x)
{
    return x > 0 ? exp(problem->parameter) : 1;
}

/* A step at 0 so far below what is the top elsewhere. */
static double low_step(const struct problem *problem, double x)
{
    return x < -1.5 ? 1 : exp(-problem->parameter - (x > 0 ? 7 : 0));
}

static double left_part(const struct problem *problem, double x)
{
    return x < problem->parameter ? 1 : 0;
}

/* Small, or large, from a place to the end on its side. */
static double falling(const struct problem *problem, double x)
{
    return x * problem->parameter > problem->parameter * problem->parameter ? exp(-12) : 1;
}

static double rising(const struct problem *problem, double x)
{
    return x * problem->parameter > problem->parameter * problem->parameter ? exp(12) : 1;
}

/* How much more than what is seen there may be between the last two places beside a steep end. */
static const double BESIDE_END = 12;

/* Whether the rules are; if not, the whole content counts as the error, or more where a peak may hide at an end. */
static bool is_believed(struct problem problem, double from, double to)
{
    struct lx_panel panel = {.from = from, .to = to};
    struct lx_integral found = integrate(&problem, &panel, 1, 1);
    double greatest = 0;
    for (int i = 0; i <= 1000; i++)
        greatest = fmax(greatest, problem.of(&problem, from + (to - from) * i / 1000));
    if (found.error < (to - from) * greatest * (1 - 1e-9))
        return true;
    if (problem.of == rising)
        assert_true(found.error <= (to - from) * greatest * BESIDE_END);
    else
        assert_near(found.error, (to - from) * greatest, 1e-9);
    return false;
}

static void steep_places(void **state)
{
    (void)state;
    /* the estimate by the rules of a step is less than the whole content */
    assert_true(is_believed((struct problem){.of = step, .parameter = 5.99}, -1, 1));
    assert_false(is_believed((struct problem){.of = step, .parameter = 6.01}, -1, 1));
    assert_true(is_believed((struct problem){.of = step, .parameter = -5.99}, -1, 1));
    assert_false(is_believed((struct problem){.of = step, .parameter = -6.01}, -1, 1));
    /* what is far below the top does not matter */
    for (int i = 0; i < 2; i++) {
        struct problem problem = {.of = low_step, .parameter = i ? 40.1 : 39.9};
        struct lx_panel items[2] = {{.from = -3, .to = -2}, {.from = -1, .to = 1}};
        integrate(&problem, items, 2, 2);
        if (i)
            assert_true(items[1].estimate < 1.9 * exp(-problem.parameter));
        else
            assert_near(items[1].estimate, 2 * exp(-problem.parameter), 1e-9);
    }
    /* falling towards the ends hides nothing between the two places next to them; rising, or earlier, it might */
    for (int side = -1; side <= 1; side += 2) {
        assert_true(is_believed((struct problem){.of = falling, .parameter = side * 0.999}, -1, 1));
        assert_true(is_believed((struct problem){.of = falling, .parameter = side * 0.98}, -1, 1));
        assert_false(is_believed((struct problem){.of = falling, .parameter = side * 0.96}, -1, 1));
        assert_false(is_believed((struct problem){.of = rising, .parameter = side * 0.999}, -1, 1));
        assert_false(is_believed((struct problem){.of = rising, .parameter = side * 0.98}, -1, 1));
    }
    /* where a function ends is looked for down to a width */
    assert_false(is_believed((struct problem){.of = left_part, .parameter = 0.51e-7}, 0, 1.001e-7));
    assert_true(is_believed((struct problem){.of = left_part, .parameter = 0.51e-7}, 0, 0.999e-7));
    assert_true(is_believed((struct problem){.of = left_part, .parameter = 1 + 0.51e-7}, 1, 1 + 0.999e-7));
}

/* A peak at `parameter`, as wide as `relative` tells. */
static double bell(const struct problem *problem, double x)
{
    const double off = (x - problem->parameter) / problem->relative;
    return exp(-off * off);
}

static double tent(const struct problem *problem, double x)
{
    return exp(-fabs(x - problem->parameter) / problem->relative);
}

/* A peak that hides between the places is within the estimate. */
static void hidden_peaks(void **state)
{
    (void)state;
    for (int i = -400; i <= 400; i++) {
        struct problem problem = {.of = bell, .parameter = i / 400.0};
        for (double width = 0.5; width > 0.0115; width *= 0.95) {
            const double left = (1 + problem.parameter) / width, right = (1 - problem.parameter) / width;
            problem.relative = width;
            struct lx_integral found = look(&problem, -1, 1);
            assert_true(fabs(found.value - width * sqrt(M_PI) / 2 * (erf(left) + erf(right))) <= found.error + 1e-15);
        }
        problem.of = tent;
        for (double width = 0.02; width > 0.0035; width *= 0.95) {
            const double left = (1 + problem.parameter) / width, right = (1 - problem.parameter) / width;
            problem.relative = width;
            struct lx_integral found = look(&problem, -1, 1);
            assert_true(fabs(found.value - width * (2 - exp(-left) - exp(-right))) <= found.error + 1e-15);
        }
    }
}

/* -- smooth panels -- */

static double lamp_like(const struct problem *problem, double x)
{
    return exp(-problem->parameter * x * x) * (2 - x);
}

/* Seven points for each panel, none at its ends; and the estimate covers what they miss. */
static void smooth(void **state)
{
    (void)state;
    for (double width = 0.05; width < 3; width *= 1.3) {
        struct problem problem = {.of = lamp_like, .parameter = 1}, fine = problem;
        struct lx_integrand integrand = {.at = at, .target = target, .data = &problem, .is_smooth = true};
        struct lx_panel panel = {.from = -0.2, .to = -0.2 + width}, truth = panel;
        struct lx_panels panels = {&panel, 1, 1}, exact = {&truth, 1, 1};
        const struct lx_integral found = lx_integrate_panels(&integrand, &panels);
        assert_int_equal(problem.calls, 7);
        integrand = (struct lx_integrand){.at = at, .target = target, .data = &fine};
        const double off = fabs(found.value - lx_integrate_panels(&integrand, &exact).value);
        assert_true(off <= found.error + 1e-15);
        assert_true(width > 0.1 || found.error < 1e-9);
        assert_near(found.inherited, truth.inherited, 1e-9);
    }
}

/* -- halving -- */

static double square_root(const struct problem *problem, double x)
{
    return problem->parameter * sqrt(fabs(x - 1));
}

/* The panel at 1 is halved over and over; the sum is made up of all panels. */
static void halving(void **state)
{
    struct problem problem = {.of = square_root, .parameter = 3, .target = 1e-9};
    struct lx_panel items[MOST_PANELS] = {{.interval = 2, .from = 2, .to = 3}, {.interval = 0, .from = 1, .to = 2}};
    const struct lx_integrand integrand = {.at = at, .target = target, .data = &problem};
    struct lx_panels panels = {items, 2, MOST_PANELS};
    (void)state;
    struct lx_integral found = lx_integrate_panels(&integrand, &panels);
    assert_true(found.error <= 1e-9 && panels.count > 8 && panels.count < MOST_PANELS);
    assert_near(found.value, 2 + 3 * 3 * 2.0 / 3 * (pow(2, 1.5) - 1), 1e-9);
    assert_int_equal(problem.calls, (NODES + 2) * (2 * panels.count - 2));
    assert_int_equal(problem.asked, panels.count - 1);
    assert_true(items[1].from == 1 && items[1].to == 1 + ldexp(1, 2 - (int)panels.count));
    assert_true(items[0].from == 2 && items[0].to == 3 && items[0].interval == 2);
    double error = items[0].estimate + items[1].estimate;
    for (size_t i = 2; i < panels.count; i++) {
        const double from = ldexp(1, 1 - (int)i);
        assert_true(items[i].interval == 0 && items[i].from == 1 + from && items[i].to == 1 + 2 * from);
        error += items[i].estimate;
    }
    assert_near(found.error, error, 1e-12);
    /* one step earlier it was too large: what a panel at 1 is wrong by grows with its length to the power 3/2 */
    assert_true(error + items[1].estimate * (pow(2, 1.5) - 1) - items[panels.count - 1].estimate > 1e-9);
}

static void ends_of_halving(void **state)
{
    struct problem problem = {.of = square_root, .parameter = 1, .target = 0};
    struct lx_panel items[MOST_PANELS] = {{.from = 1, .to = 2}};
    (void)state;
    /* no more room */
    const struct lx_integrand integrand = {.at = at, .target = target, .data = &problem};
    struct lx_panels panels = {items, 1, 5};
    lx_integrate_panels(&integrand, &panels);
    assert_int_equal(panels.count, 5);
    /* nothing to do */
    panels.count = 0;
    assert_true(lx_integrate_panels(&integrand, &panels).value == 0);
    /* a panel that rounding leaves no more of: the powers of a straight line are known at once */
    problem = (struct problem){.of = whole_power, .parameter = 1};
    items[0] = (struct lx_panel){.from = 1, .to = 2};
    panels = (struct lx_panels){items, 1, MOST_PANELS};
    lx_integrate_panels(&integrand, &panels);
    assert_true(panels.count <= 4);
    /* a panel without a number between its ends */
    problem = (struct problem){.of = rising, .parameter = 1};
    items[0] = (struct lx_panel){.from = 1, .to = nextafter(1, 2)};
    panels = (struct lx_panels){items, 1, MOST_PANELS};
    lx_integrate_panels(&integrand, &panels);
    assert_int_equal(panels.count, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(powers),          cmocka_unit_test(other_panels), cmocka_unit_test(steep_places),
        cmocka_unit_test(hidden_peaks),    cmocka_unit_test(smooth),       cmocka_unit_test(halving),
        cmocka_unit_test(ends_of_halving),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

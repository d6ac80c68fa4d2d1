/* SPDX-License-Identifier: MIT */
/*
 * Bounded numbers against the same operation in long double, on operands moved by chance within their errors: the
 * result lies within its bound, and the bound is not much larger than what the moves and the roundings make.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/bounded.h"

enum { CASES = 20000, MOVES = 9 };

/* What long double itself may be off by; where it is no wider than double there is nothing to compare with. */
#define FINE ((long double)0x1p-60)

static uint64_t seed = 1;

/* From 0 to 1. */
static double chance(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) * 0x1p-53;
}

/* A size anywhere between two powers of ten. */
static double any_size(double low, double high)
{
    return pow(10, low + (high - low) * chance());
}

/* A number of a size between two powers of ten; exact, or with an error from rounding to beyond the number itself. */
static lx_bounded any_number(double low, double high, bool is_signed)
{
    double value = any_size(low, high) * (is_signed && chance() < 0.5 ? -1 : 1);
    return (lx_bounded){value, chance() < 0.2 ? 0 : fabs(value) * any_size(-16, 0.3)};
}

/* Move i of an operand: to its ends first, then anywhere. */
static long double moved(lx_bounded a, int i)
{
    double share = i == 0 ? 0 : i < 5 ? (i & 1 ? 1 : -1) : 2 * chance() - 1;
    return (long double)a.value + (long double)share * (long double)a.error;
}

/* Numbers for a second operand, so that all pairs of ends occur. */
static long double moved_too(lx_bounded a, int i)
{
    return moved(a, i == 2 ? 1 : i == 3 ? 2 : i);
}

/* The farthest that exact results were found from the value. */
struct trial {
    lx_bounded result;
    long double farthest;
};

static void assert_holds(struct trial *trial, long double exact, const char *name)
{
    long double off = fabsl((long double)trial->result.value - exact);
    trial->farthest = fmaxl(trial->farthest, off);
    if (!(off <= (long double)trial->result.error + FINE * fabsl(exact)))
        fail_msg("%s: %a is off by %La, beyond its bound %a", name, trial->result.value, off, trial->result.error);
}

/* `factor`: how much larger the bound may be than the farthest of some moves. */
static void assert_is_tight(const struct trial *trial, double factor, const char *name)
{
    long double most = (long double)factor * trial->farthest +
                       8 * (long double)DBL_EPSILON * fabsl((long double)trial->result.value) +
                       4 * (long double)LX_UNDERFLOW;
    if (!((long double)trial->result.error <= most))
        fail_msg("%s: %a has the bound %a, but was off by no more than %La", name, trial->result.value,
                 trial->result.error, trial->farthest);
}

/* As the processor has it, not the compiler: under valgrind all have the digits of double. */
static bool is_long_enough(void)
{
    const volatile long double one = 1, more = one + FINE;
    return more > one;
}

static void sums_and_products(void **unused)
{
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        lx_bounded a = any_number(-3, 3, true), b = any_number(-3, 3, true);
        struct trial sum = {lx_add(a, b), 0}, difference = {lx_sub(a, b), 0}, product = {lx_mul(a, b), 0};
        for (int i = 0; i < MOVES; i++) {
            long double x = moved(a, i), y = moved_too(b, i);
            assert_holds(&sum, x + y, "sum");
            assert_holds(&difference, x - y, "difference");
            assert_holds(&product, x * y, "product");
        }
        assert_is_tight(&sum, 1.01, "sum");
        assert_is_tight(&difference, 1.01, "difference");
        assert_is_tight(&product, 1.01, "product");
        lx_bounded half = lx_scale(a, -0.5), opposite = lx_negate(a);
        assert_true(half.value == -0.5 * a.value && half.error == 0.5 * a.error);
        assert_true(opposite.value == -a.value && opposite.error == a.error);
    }
}

static void quotients_and_roots(void **unused)
{
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        lx_bounded a = any_number(-3, 3, true), b = any_number(-3, 3, true), c = any_number(-3, 3, false);
        struct trial quotient = {lx_div(a, b), 0}, root = {lx_sqrt(c), 0};
        bool may_be_zero = !(fabs(b.value) > b.error);
        assert_true(!may_be_zero || quotient.result.error == HUGE_VAL);
        for (int i = 0; i < MOVES; i++) {
            if (!may_be_zero)
                assert_holds(&quotient, moved(a, i) / moved_too(b, i), "quotient");
            assert_holds(&root, sqrtl(fmaxl(moved(c, i), 0)), "root");
        }
        if (!may_be_zero)
            assert_is_tight(&quotient, 1.01, "quotient");
        assert_is_tight(&root, 3, "root");
    }
    lx_bounded below = lx_sqrt((lx_bounded){-1, 4});
    assert_true(below.value == 0 && below.error >= 2);
}

/* Results that leave the normal numbers are rounded absolutely. */
static void underflow(void **unused)
{
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        lx_bounded a = any_number(-200, -140, true), b = any_number(-200, -140, true), c = any_number(120, 180, true);
        a.error *= 1e-4, b.error *= 1e-4, c.error *= 1e-4;
        struct trial product = {lx_mul(a, b), 0}, quotient = {lx_div(a, c), 0};
        for (int i = 0; i < MOVES; i++) {
            assert_holds(&product, moved(a, i) * moved_too(b, i), "small product");
            assert_holds(&quotient, moved(a, i) / moved_too(c, i), "small quotient");
        }
        assert_is_tight(&product, 1.01, "small product");
        assert_is_tight(&quotient, 1.01, "small quotient");
    }
    assert_true(lx_is_zero(lx_mul(lx_exact(0), lx_exact(1e-200))) && lx_is_zero(lx_div(lx_exact(0), lx_exact(3))));
}

static void functions(void **unused)
{
    static const double exponents[] = {0.25, 0.5, 1, 2, 7, 40, 1000};
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        lx_bounded a = any_number(-3, 1, true), c = any_number(-3, 0.3, false), angle = any_number(-3, 0.5, true);
        double exponent = exponents[n % 7];
        a.error = fmin(a.error, 1);
        bool is_little = chance() < 0.8; /* so that the power stays of one size */
        c.error = is_little ? fmin(c.error, c.value / (4 * exponent + 2)) : c.error;
        struct trial exponential = {lx_exp(a), 0}, power = {lx_power(c, exponent), 0}, sine = {lx_sin(angle), 0};
        struct trial logarithm = {lx_log1p(c), 0};
        for (int i = 0; i < MOVES; i++) {
            long double x = fmaxl(moved(c, i), 0);
            assert_holds(&exponential, expl(moved(a, i)), "exponential");
            assert_holds(&power, powl(x, (long double)exponent), "power");
            assert_holds(&sine, sinl(moved(angle, i)), "sine");
            assert_holds(&logarithm, log1pl(moved(c, i)), "logarithm");
        }
        assert_is_tight(&exponential, 1.01, "exponential");
        if (is_little)
            assert_is_tight(&power, 4, "power");
        assert_true(sine.result.error <= 1.01 * angle.error + 4 * DBL_EPSILON);
        assert_true(!(c.error < c.value) || logarithm.result.error <= 2.01 * c.error + 4 * DBL_EPSILON);
    }
    lx_bounded beyond = lx_log1p((lx_bounded){-0.5, 0.75});
    assert_true(beyond.error == HUGE_VAL);
    assert_true(lx_power(lx_exact(0), 0).value == 1 && lx_is_zero(lx_power(lx_exact(0), 3)));
}

/* x rounded to float64, with what that loses. */
static lx_bounded rounded(long double x)
{
    return (lx_bounded){(double)x, fabs((double)x) * LX_ROUNDING + DBL_TRUE_MIN};
}

/* Powers of cosines that are told with the squared sine keep the digits that the cosine alone has lost near 1. */
static void powers_of_cosines(void **unused)
{
    static const double exponents[] = {0.5, 1, 3, 20, 1000, 1e6};
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        long double angle = (long double)any_size(-6, 0.19), exponent = (long double)exponents[n % 6]; /* below pi/2 */
        long double sine = sinl(angle), s2 = sine * sine;
        long double exact = s2 < 0.5L ? expl(exponent / 2 * log1pl(-s2)) : powl(cosl(angle), exponent);
        lx_bounded cosine = rounded(cosl(angle)), square = rounded(s2);
        struct trial power = {lx_cosine_power(cosine, square, (double)exponent), 0};
        assert_holds(&power, exact, "power of a cosine");
        assert_true(power.result.error <= power.result.value *
                                                  (8 + (double)exponent * fmin(1, 4 * (double)(angle * angle))) *
                                                  DBL_EPSILON * 4 +
                                              LX_UNDERFLOW * 2);
        lx_bounded behind = lx_cosine_power(lx_negate(cosine), square, (double)exponent);
        assert_true(behind.value == 0 && behind.error <= 1e-6);
        assert_true(lx_cosine_power(lx_negate(cosine), square, 0).value == 1);
    }
    lx_bounded nowhere = lx_cosine_power((lx_bounded){(double)NAN, HUGE_VAL}, (lx_bounded){(double)NAN, HUGE_VAL}, 5);
    assert_true(nowhere.value == 0);
}

static void angles(void **unused)
{
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        lx_bounded x = any_number(-2, 2, true), y = any_number(-2, 2, false);
        double size = hypot(x.value, y.value);
        x.error = fmin(x.error, size / 8),
        y.error = fmin(y.error, fmin(size / 8, y.value)); /* on one side of the cut */
        struct trial angle = {lx_angle(y, x), 0};
        for (int i = 0; i < MOVES; i++)
            assert_holds(&angle, atan2l(moved_too(y, i), moved(x, i)), "angle");
        assert_true(angle.result.error <= 2 * (x.error + y.error) / size + 8 * DBL_EPSILON);
    }
    assert_true(lx_angle((lx_bounded){1, 2}, (lx_bounded){1, 2}).error >= 2 * M_PI);
}

/* Answers by a sign: certain, or in doubt. */
static void answers(void **unused)
{
    const lx_bounded yes = {1, 0}, no = {0, 0}, maybe = {1, 1}, maybe_not = {0, 1};
    (void)unused;
    assert_true(lx_step(lx_exact(2), false).value == 1 && lx_step(lx_exact(2), false).error == 0);
    assert_true(lx_is_zero(lx_step(lx_exact(-2), true)));
    assert_true(lx_step(lx_exact(0), true).value == 1 && lx_step(lx_exact(0), true).error == 0);
    assert_true(lx_is_zero(lx_step(lx_exact(0), false)));
    assert_true(lx_step((lx_bounded){2, 3}, false).value == 1 && lx_step((lx_bounded){2, 3}, false).error == 1);
    assert_true(lx_step((lx_bounded){-2, 3}, false).value == 0 && lx_step((lx_bounded){-2, 3}, false).error == 1);
    assert_true(lx_step((lx_bounded){2, 2}, false).error == 1 && lx_step((lx_bounded){2, 1}, false).error == 0);
    assert_true(lx_not(yes).value == 0 && lx_not(no).value == 1 && lx_not(maybe).error == 1);
    assert_true(lx_both(yes, yes).value == 1 && lx_both(yes, yes).error == 0);
    assert_true(lx_is_zero(lx_both(no, maybe)) && lx_is_zero(lx_both(maybe, no)));
    assert_true(lx_both(yes, maybe).value == 1 && lx_both(yes, maybe).error == 1 && lx_both(maybe, yes).error == 1);
    assert_true(lx_both(maybe, maybe_not).value == 0 && lx_both(maybe, maybe_not).error == 1);
    lx_bounded dark = lx_positive((lx_bounded){-1, 3}), black = lx_positive((lx_bounded){-1, 0.5});
    assert_true(dark.value == 0 && dark.error == 2 && lx_is_zero(black));
    lx_bounded lit = lx_positive((lx_bounded){1, 3});
    assert_true(lit.value == 1 && lit.error == 3);
}

static void assert_vector(lx_bounded3 found, const long double exact[3], const char *name)
{
    assert_holds(&(struct trial){found.x, 0}, exact[0], name);
    assert_holds(&(struct trial){found.y, 0}, exact[1], name);
    assert_holds(&(struct trial){found.z, 0}, exact[2], name);
}

static void vectors(void **unused)
{
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        /* of any size, so that squares neither overflow nor vanish */
        double size = any_size(-300, 300);
        lx_bounded3 a = {any_number(-1, 1, true), any_number(-1, 1, true), any_number(-1, 1, true)};
        lx_bounded3 b = {any_number(-1, 1, true), any_number(-1, 1, true), any_number(-1, 1, true)};
        lx_bounded3 far = lx_exact3((const double[]){a.x.value * size, a.y.value * size, a.z.value * size});
        long double f[3] = {(long double)far.x.value, (long double)far.y.value, (long double)far.z.value};
        long double length = sqrtl(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
        struct trial reach = {lx_length3(far), 0};
        assert_holds(&reach, length, "length");
        assert_is_tight(&reach, 8, "length");
        assert_vector(lx_unit3(far), (const long double[]){f[0] / length, f[1] / length, f[2] / length}, "unit vector");
        assert_true(lx_unit3(far).x.error <= 8 * DBL_EPSILON);
        const lx_bounded3 along = lx_unit3(lx_exact3((const double[]){0, -fabs(far.y.value) - DBL_MIN, 0}));
        assert_true(lx_is_zero(along.x) && lx_is_zero(along.z) && along.y.value == -1 && along.y.error == 0);
        struct trial dot = {lx_dot3(a, b), 0};
        for (int i = 0; i < MOVES; i++) {
            long double p[3] = {moved(a.x, i), moved(a.y, i), moved(a.z, i)};
            long double q[3] = {moved_too(b.x, i), moved_too(b.y, i), moved_too(b.z, i)};
            assert_holds(&dot, p[0] * q[0] + p[1] * q[1] + p[2] * q[2], "dot product");
            assert_vector(
                lx_cross3(a, b),
                (const long double[]){p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]},
                "cross product");
            assert_vector(lx_sub3(a, b), (const long double[]){p[0] - q[0], p[1] - q[1], p[2] - q[2]}, "difference");
            assert_vector(lx_add3(a, lx_negate3(b)), (const long double[]){p[0] - q[0], p[1] - q[1], p[2] - q[2]},
                          "sum with the opposite");
            assert_vector(lx_mul3(a, b.x), (const long double[]){p[0] * q[0], p[1] * q[0], p[2] * q[0]}, "multiple");
        }
    }
    for (int i = 0; i < 3; i++) { /* whichever is the largest sets the scale */
        double uneven[3] = {3e-200, 3e-200, 3e-200};
        uneven[i] = 1;
        assert_true(lx_length3(lx_exact3(uneven)).value == 1);
    }
    assert_true(lx_length3(lx_exact3((const double[]){0, 0, 0})).value == 0);
    assert_true(lx_length3(lx_exact3((const double[]){0, 3e-320, 4e-320})).value == 5e-320);
}

/* Differences and products without error, and dot products that cancel. */
static void twice_the_precision(void **unused)
{
    (void)unused;
    if (!is_long_enough())
        skip();
    for (int n = 0; n < CASES; n++) {
        double a[6], b[6], error;
        long double exact = 0, magnitude = 0;
        for (int i = 0; i < 6; i++) {
            a[i] = any_size(-2, 2) * (chance() < 0.5 ? -1 : 1);
            b[i] = any_size(-2, 2);
        }
        a[5] = -a[0], b[5] = b[0] * (1 + 0x1p-40); /* nearly takes the first one away */
        struct lx_pair difference = lx_exact_difference(a[0], b[1]), product = lx_exact_product(a[0], b[0]), dot;
        assert_true(difference.high == a[0] - b[1] && product.high == a[0] * b[0]);
        assert_true((long double)difference.high + (long double)difference.low ==
                    (long double)a[0] - (long double)b[1]);
        assert_true(product.low == fma(a[0], b[0], -product.high));
        const double c = a[2] * (1 + 0x1p-30);
        const struct lx_pair squares = lx_exact_difference_of_squares(a[2], c);
        dot = lx_exact_dot(2, (double[]){a[2], -c}, (double[]){a[2], c}, &error);
        assert_true(squares.high == dot.high && squares.low == dot.low);
        dot = lx_exact_dot(6, a, b, &error);
        for (int i = 1; i < 5; i++) {
            struct lx_pair part = lx_exact_product(a[i], b[i]);
            exact += (long double)part.high;
            magnitude += fabsl((long double)part.high);
        }
        magnitude += 2 * fabsl((long double)product.high);
        /* what the first and the last leave of each other, which is exact, and the low parts */
        exact -= (long double)a[0] * (long double)(b[5] - b[0]);
        for (int i = 1; i < 5; i++)
            exact += (long double)lx_exact_product(a[i], b[i]).low;
        assert_true(fabsl((long double)dot.high + (long double)dot.low - exact) <=
                    (long double)error + 16 * FINE * magnitude);
        assert_true(fabs(dot.low) <= fabs(dot.high) * DBL_EPSILON);
        assert_true((long double)error <= 144 * (long double)(LX_ROUNDING * LX_ROUNDING) * magnitude * 1.01L);
        assert_true((long double)error >= 100 * (long double)(LX_ROUNDING * LX_ROUNDING) * magnitude);
    }
}

/* -- how wide bounds are -- */

static void assert_width(lx_bounded found, double value, double error)
{
    if (!(fabs(found.value - value) <= 1e-15 * fabs(value) && fabs(found.error - error) <= 1e-9 * error))
        fail_msg("%.17g +- %.17g instead of %.17g +- %.17g", found.value, found.error, value, error);
}

static lx_bounded of(double value, double error)
{
    return (lx_bounded){value, error};
}

/* Numbers without errors have the roundings alone: half a unit in the last place for each. */
static void widths_of_roundings(void **unused)
{
    const double u = DBL_EPSILON / 2;
    (void)unused;
    assert_width(lx_add(lx_exact(3), lx_exact(-7)), -4, 4 * u);
    assert_width(lx_sub(lx_exact(3), lx_exact(-7)), 10, 10 * u);
    assert_width(lx_mul(lx_exact(3), lx_exact(-7)), -21, 21 * u);
    assert_width(lx_div(lx_exact(3), lx_exact(-8)), -0.375, 2 * 0.375 * u);
    assert_width(lx_sqrt(lx_exact(9)), 3, 2 * 3 * u);
    assert_width(lx_exp(lx_exact(2)), exp(2), 4 * exp(2) * u);
    assert_width(lx_log1p(lx_exact(3)), log(4), 4 * log(4) * u);
    assert_width(lx_power(lx_exact(3), 5), 243, 4 * 243 * u);
    assert_width(lx_angle(lx_exact(-2), lx_exact(2)), -M_PI / 4, 4 * (M_PI / 4) * u);
    assert_width(lx_sin(lx_exact(2)), sin(2), 4 * sin(2) * u);
}

/* What operands bring, so large that roundings do not matter beside it. */
static void widths_of_errors(void **unused)
{
    (void)unused;
    assert_width(lx_add(of(3, 0.5), of(-7, 0.25)), -4, 0.75);
    assert_width(lx_sub(of(3, 0.5), of(-7, 0.25)), 10, 0.75);
    assert_width(lx_mul(of(3, 0.5), of(-7, 0.25)), -21, 3 * 0.25 + 7 * 0.5 + 0.5 * 0.25);
    assert_width(lx_div(of(3, 0.5), of(-8, 0.25)), -0.375, (0.5 + 0.375 * 0.25) / 7.75);
    assert_width(lx_div(lx_exact(3), of(8, 7.75)), 0.375, 0.375 * 7.75 / 0.25);
    assert_true(lx_div(lx_exact(3), of(8, 8)).error == HUGE_VAL);
    assert_width(lx_sqrt(of(4, 1)), 2, 0.5);
    assert_width(lx_sqrt(of(4, 3.999)), 2, 3.999 / 2);
    assert_width(lx_sqrt(of(4, 4)), 2, sqrt(8));
    assert_width(lx_sqrt(of(-4, 5)), 0, sqrt(5));
    assert_width(lx_exp(of(2, 0.5)), exp(2), exp(2) * (exp(0.5) - 1));
    assert_width(lx_log1p(of(3, 0.5)), log(4), 0.5 / 3.5);
    assert_width(lx_log1p(of(3, 3.5)), log(4), 7);
    assert_true(lx_log1p(of(3, 4)).error == HUGE_VAL);
    assert_width(lx_power(of(2, 0.25), 5), 32, 32 * (exp(5 * 0.25 / 1.75) - 1));
    assert_width(lx_power(of(2, 0.5), 5), 32, pow(2.5, 5));  /* more than to the power e */
    assert_width(lx_power(of(2, 0.5), 3), 8, pow(2.5, 3));   /* just e */
    assert_width(lx_power(of(2, 2), 0.5), sqrt(2), sqrt(4)); /* perhaps 0 */
    assert_true(lx_power(of(2, 1), 1).error > 3);            /* 3, and what the sum is rounded by */
    assert_width(lx_angle(of(3, 0.3), of(-4, 0.4)), atan2(3, -4), 0.5 / (5 - 0.7));
    assert_width(lx_angle(of(3, 2), of(-4, 2.9)), atan2(3, -4), hypot(2, 2.9) / 0.1);
    assert_width(lx_angle(of(3, 2), of(-4, 3.1)), atan2(3, -4), 2 * M_PI);
    assert_width(lx_sin(of(2, 0.5)), sin(2), 0.5);
}

/* From a squared sine of one half on, the cosine itself is raised; no power is off by more than 1. */
static void widths_of_powers_of_cosines(void **unused)
{
    const double u = DBL_EPSILON / 2, by_cosine = 4 * 0.49 * u;
    (void)unused;
    assert_width(lx_cosine_power(lx_exact(0.7), lx_exact(0.5), 2), 0.49, by_cosine);
    assert_width(lx_cosine_power(lx_exact(0.7), lx_exact(0.503), 2), 0.49, by_cosine);
    lx_bounded by_sine = lx_cosine_power(lx_exact(0.7), lx_exact(0.499), 2);
    assert_true(fabs(by_sine.value - 0.501) < 1e-15 && by_sine.error > 5 * 0.501 * u);
    lx_bounded doubtful = lx_cosine_power(of(0.7, 0.9), lx_exact(0.51), 3);
    assert_true(fabs(doubtful.value - 0.343) < 1e-15 && doubtful.error == 1);
    assert_true(lx_cosine_power(of(0.7, 0.4), lx_exact(0.51), 3).error == 1); /* not 1.1^3 */
    doubtful = lx_cosine_power(of(0.5, 0.3), lx_exact(0.75), 3);
    assert_width(doubtful, 0.125, 0.512);
}

static void scales(void **unused)
{
    static const struct {
        double largest, scale;
    } cases[] = {
        {0, 1},
        {1, 1},
        {1.99, 1},
        {2, 0.5},
        {0.75, 2},
        {HUGE_VAL, 1},
        {0x1p1023, 0x1p-1023},
        {0x1p-1000, 0x1p1000},
        {0x1p-1001, 0x1p1000},
        {0x1p-1074, 0x1p1000},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int k = 0; k < 3; k++) {
            double v[3] = {cases[i].largest / 4, cases[i].largest / 4, cases[i].largest / 4};
            v[k] = -cases[i].largest;
            if (lx_scale_for3(lx_exact3(v)) != cases[i].scale)
                fail_msg("%g: %g", cases[i].largest, lx_scale_for3(lx_exact3(v)));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_and_products),
        cmocka_unit_test(quotients_and_roots),
        cmocka_unit_test(underflow),
        cmocka_unit_test(functions),
        cmocka_unit_test(powers_of_cosines),
        cmocka_unit_test(angles),
        cmocka_unit_test(answers),
        cmocka_unit_test(vectors),
        cmocka_unit_test(twice_the_precision),
        cmocka_unit_test(widths_of_roundings),
        cmocka_unit_test(widths_of_errors),
        cmocka_unit_test(widths_of_powers_of_cosines),
        cmocka_unit_test(scales),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * The functions that the kernels of one instruction set are made of, against the C library in long double, over all of
 * their domain: each error stays below what lanes.h and kernel_functions.h state.  Built once for each set; where the
 * machine does not have it, nothing runs.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#define LX_WITHOUT_TABLE
#pragma GCC diagnostic ignored "-Wunused-function"
#include "kernel/kernel.c"

static const long double unit_single = 0x1p-23L, unit_double = 0x1p-52L; /* an ulp of 1 */

/* What a step of the argument does to a worst case. */
struct worst {
    long double error;
    double at;
};

static void note(struct worst *worst, long double error, double at)
{
    if (!(error <= worst->error))
        *worst = (struct worst){error, at};
}

static void report(const char *name, const struct worst *worst, double bound)
{
    print_message("# %s, %s: %.2Lf ulp at %.9g\n", LX_ISA_NAME, name, worst->error, worst->at);
    assert_true(worst->error <= (long double)bound);
}

/* Numbers of a power of two, side by side. */
static lanes_single numbers_single(int octave, int step, int per_octave)
{
    lanes_single x;
    for (int i = 0; i < LX_WIDTH_single; i++)
        x[i] = ldexpf(1 + (float)(step + i) / (float)per_octave, octave);
    return x;
}

static lanes_double numbers_double(int octave, int step, int per_octave)
{
    lanes_double x;
    for (int i = 0; i < LX_WIDTH_double; i++)
        x[i] = ldexp(1 + (double)(step + i) / (double)per_octave, octave);
    return x;
}

enum { PER_OCTAVE = 1 << 14 };

static void test_inverses(void **state)
{
    (void)state;
    struct worst inverse = {0}, root = {0};
    for (int octave = -100; octave < 100; octave++)
        for (int step = 0; step < PER_OCTAVE; step += LX_WIDTH_single) {
            lanes_single x = numbers_single(octave, step, PER_OCTAVE);
            lanes_single a = inverse_single(x), b = inverse_root_single(x);
            for (int i = 0; i < LX_WIDTH_single; i++) {
                long double exact = (long double)x[i];
                note(&inverse, fabsl((long double)a[i] * exact - 1) / unit_single, (double)x[i]);
                note(&root, fabsl((long double)b[i] * sqrtl(exact) - 1) / unit_single, (double)x[i]);
            }
        }
    report("1/a in float32", &inverse, 2);
    report("1/sqrt(a) in float32", &root, 2);
    inverse = root = (struct worst){0};
    for (int octave = -300; octave < 300; octave++)
        for (int step = 0; step < 1024; step += LX_WIDTH_double) {
            lanes_double x = numbers_double(octave, step, 1024);
            lanes_double a = inverse_double(x), b = inverse_root_double(x);
            for (int i = 0; i < LX_WIDTH_double; i++) {
                long double exact = (long double)x[i];
                note(&inverse, fabsl((long double)a[i] * exact - 1) / unit_double, x[i]);
                note(&root, fabsl((long double)b[i] * sqrtl(exact) - 1) / unit_double, x[i]);
            }
        }
    report("1/a in float64", &inverse, 2);
    report("1/sqrt(a) in float64", &root, 2);
}

/* Exact at 0, and within a little more than half a digit. */
static void test_roots(void **state)
{
    (void)state;
    struct worst single = {0}, exact = {0};
    for (int octave = -300; octave < 300; octave++)
        for (int step = 0; step < 1024; step += LX_WIDTH_single) {
            lanes_double x = numbers_double(octave, step, 1024), root = root_double(x);
            for (int i = 0; i < LX_WIDTH_double; i++)
                note(&exact, fabsl((long double)root[i] / sqrtl((long double)x[i]) - 1) / unit_double, x[i]);
            if (octave < -100 || octave >= 100)
                continue;
            lanes_single y = numbers_single(octave, step, 1024), other = root_single(y);
            for (int i = 0; i < LX_WIDTH_single; i++)
                note(&single, fabsl((long double)other[i] / sqrtl((long double)y[i]) - 1) / unit_single, (double)y[i]);
        }
    report("sqrt(a) in float32", &single, LX_ISA_LEVEL >= 4 ? 0.54 : 0.5); /* elsewhere the machine rounds */
    report("sqrt(a) in float64", &exact, 0.501);
    assert_true(root_double(all_double(0))[0] == 0 && root_single(all_single(0))[0] == 0);
}

/* t from far below the last digit of 1 to 2; its power in ulp of 1. */
static void check_power_single(double exponent, bool whole, struct worst *worst)
{
    const struct lx_exponent_single n = {(float)exponent, whole ? (unsigned)exponent : 0};
    for (int octave = -40; octave < 1; octave++)
        for (int step = 0; step < 1024; step += LX_WIDTH_single) {
            lanes_single t = numbers_single(octave, step, 1024), power = power_of_single(1 - t, t, n);
            for (int i = 0; i < LX_WIDTH_single; i++) {
                long double exact = t[i] < 1 ? expl((long double)n.value * log1pl(-(long double)t[i])) : 0;
                note(worst, fabsl((long double)power[i] - exact) / unit_single, exponent);
                assert_true(power[i] >= 0 && power[i] <= 1);
            }
        }
}

static void check_power_double(double exponent, bool whole, struct worst *worst)
{
    const struct lx_exponent_double n = {exponent, whole ? (unsigned)exponent : 0};
    for (int octave = -80; octave < 1; octave++)
        for (int step = 0; step < 256; step += LX_WIDTH_double) {
            lanes_double t = numbers_double(octave, step, 256), power = power_of_double(1 - t, t, n);
            for (int i = 0; i < LX_WIDTH_double; i++) {
                long double exact = t[i] < 1 ? expl((long double)n.value * log1pl(-(long double)t[i])) : 0;
                note(worst, fabsl((long double)power[i] - exact) / unit_double, exponent);
                assert_true(power[i] >= 0 && power[i] <= 1);
            }
        }
}

static void test_whole_powers(void **state)
{
    (void)state;
    struct worst single = {0}, twice = {0};
    static const unsigned large[] = {255, 256, 999, 1000, 4095, 10000, 65535, 65536};
    for (unsigned n = 1; n <= 130; n++) {
        check_power_single(n, true, &single);
        check_power_double(n, true, &twice);
    }
    for (size_t i = 0; i < sizeof large / sizeof large[0]; i++) {
        check_power_single(large[i], true, &single);
        check_power_double(large[i], true, &twice);
    }
    report("whole powers in float32", &single, 6);
    report("whole powers in float64", &twice, 6);
}

/* The relative error of powers down to 1e-250, over 1 + |ln power|, in ulp: they may be all that a picture shows. */
static void test_small_powers(void **state)
{
    (void)state;
    struct worst worst = {0};
    static const unsigned exponents[] = {1, 2, 3, 7, 11, 12, 13, 20, 23, 24, 50, 99, 100, 127, 500, 1001, 10000, 65535};
    for (size_t e = 0; e < sizeof exponents / sizeof exponents[0]; e++) {
        const struct lx_exponent_double n = {exponents[e], exponents[e]};
        for (int octave = -40; octave < 0; octave++)
            for (int step = 0; step < 512; step += LX_WIDTH_double) {
                lanes_double t = numbers_double(octave, step, 512), power = power_of_double(1 - t, t, n);
                for (int i = 0; i < LX_WIDTH_double; i++) {
                    const long double logarithm = (long double)n.value * log1pl(-(long double)t[i]);
                    const long double off = (long double)power[i] / expl(logarithm) - 1;
                    if (logarithm > -575)
                        note(&worst, fabsl(off) / (1 - logarithm) / unit_double, n.value);
                }
            }
    }
    report("small whole powers in float64", &worst, 6);
}

/* A cosine of 1e-20, which 1 - t cannot tell from 0, keeps its digits. */
static void test_small_cosines(void **state)
{
    (void)state;
    static const struct lx_exponent_double exponents[] = {{1, 1}, {2, 2}, {13, 13}, {0.75, 0}, {7.5, 0}};
    for (size_t e = 0; e < sizeof exponents / sizeof exponents[0]; e++) {
        const double exact = pow(3e-20, exponents[e].value);
        lanes_double power = power_of_double(all_double(3e-20), all_double(1), exponents[e]);
        for (int i = 0; i < LX_WIDTH_double; i++)
            assert_true(fabs(power[i] - exact) <= 1e-13 * exact);
    }
}

static void test_other_powers(void **state)
{
    (void)state;
    struct worst single = {0}, twice = {0};
    static const double exponents[] = {1, 1.5, 2.5, 3.7, 10.25, 20.5, 64.125, 333.3, 5000.5, 10000.5, 99999.5};
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++) {
        check_power_single(exponents[i], false, &single);
        check_power_double(exponents[i], false, &twice);
    }
    report("other powers in float32", &single, 2);
    report("other powers in float64", &twice, 2);
}

static void test_angles(void **state)
{
    (void)state;
    struct worst single = {0}, twice = {0};
    for (int octave = -30; octave < 0; octave++)
        for (int step = 0; step < 4096; step += LX_WIDTH_single) {
            lanes_single t = numbers_single(octave, step, 4096), angle = angle_of_half_tangent_single(t);
            for (int i = 0; i < LX_WIDTH_single; i++)
                note(&single, fabsl((long double)angle[i] / (2 * atanl((long double)t[i])) - 1) / unit_single,
                     (double)t[i]);
        }
    for (int octave = -60; octave < 0; octave++)
        for (int step = 0; step < 1024; step += LX_WIDTH_double) {
            lanes_double t = numbers_double(octave, step, 1024), angle = angle_of_half_tangent_double(t);
            for (int i = 0; i < LX_WIDTH_double; i++)
                note(&twice, fabsl((long double)angle[i] / (2 * atanl((long double)t[i])) - 1) / unit_double, t[i]);
        }
    report("angles in float32", &single, 2);
    report("angles in float64", &twice, 2);
}

/* gap(z), and an angle over its sine less 1, of z from 0 to 1, in long double. */
static long double exact_gap(long double z)
{
    long double root = sqrtl(z), series = 0;
    for (int k = 12; k >= 1; k--)
        series = 1 / (2 * (long double)k + 1) - z * series;
    return z < 1e-2L ? z * series : 1 - atanl(root) / root;
}

static long double exact_bow(long double z)
{
    long double sine = sqrtl(z * (2 - z)), series = 0, coefficient = 1.0L / 3;
    for (int k = 1; k <= 12; k++, coefficient *= (long double)k / (2 * (long double)k + 1))
        series += coefficient * powl(z, k);
    return z < 1e-2L ? series : acosl(1 - z) / sine - 1;
}

/* As the processor has it, not the compiler: under valgrind all have the digits of double. */
static bool is_long_enough(void)
{
    const volatile long double one = 1, more = one + LDBL_EPSILON;
    return more > one;
}

/* Relative to themselves, as small sources need them. */
static void test_arcs(void **state)
{
    (void)state;
    if (!is_long_enough())
        skip();
    struct worst gap = {0}, arc = {0}, gap_twice = {0}, arc_twice = {0};
    for (int octave = -40; octave < 0; octave++)
        for (int step = 0; step < 4096; step += LX_WIDTH_single) {
            lanes_single z = numbers_single(octave, step, 4096), a = gap_of_single(z), b = arc_over_sine_single(z);
            for (int i = 0; i < LX_WIDTH_single; i++) {
                note(&gap, fabsl((long double)a[i] / exact_gap((long double)z[i]) - 1) / unit_single, (double)z[i]);
                note(&arc, fabsl((long double)b[i] - 1 - exact_bow((long double)z[i])) / unit_single, (double)z[i]);
            }
        }
    for (int octave = -80; octave < 0; octave++)
        for (int step = 0; step < 512; step += LX_WIDTH_double) {
            lanes_double z = numbers_double(octave, step, 512), a = gap_of_double(z), b = arc_over_sine_double(z);
            for (int i = 0; i < LX_WIDTH_double; i++) {
                note(&gap_twice, fabsl((long double)a[i] / exact_gap((long double)z[i]) - 1) / unit_double, z[i]);
                note(&arc_twice, fabsl((long double)b[i] - 1 - exact_bow((long double)z[i])) / unit_double, z[i]);
            }
        }
    report("gap(z) in float32", &gap, 2);
    report("gap(z) in float64", &gap_twice, 2);
    report("angle/sine in float32", &arc, 2);
    report("angle/sine in float64", &arc_twice, 2);
}

static void test_comparisons(void **state)
{
    (void)state;
    const lanes_single zero = all_single(0), none = all_single(NAN);
    const lanes_double zero_double = all_double(0);
    assert_false(any_above_single(zero, zero) || all_above_single(zero, zero));
    assert_false(any_above_single(none, zero) || any_above_single(zero, none));
    assert_true(all_above_single(all_single(1), zero) && all_above_double(all_double(1), zero_double));
    for (int i = 0; i < LX_WIDTH_single; i++) {
        lanes_single one = zero;
        one[i] = 1;
        assert_true(any_above_single(one, zero) && !all_above_single(one, zero));
        assert_true(!any_above_single(zero, one) && !all_above_single(1 - one, zero));
    }
    for (int i = 0; i < LX_WIDTH_double; i++) {
        lanes_double one = zero_double;
        one[i] = 1;
        assert_true(any_above_double(one, zero_double) && !all_above_double(one, zero_double));
        assert_true(!any_above_double(zero_double, one) && !all_above_double(1 - one, zero_double));
    }
}

/* What is no number gives way to the bound that it is held against: highlights without a half vector rest on it. */
static void test_bounds(void **state)
{
    (void)state;
    const lanes_single none = all_single(NAN), one = all_single(1), two = all_single(2);
    const lanes_double none_double = all_double((double)NAN), one_double = all_double(1);
    const struct lx_exponent_single twenty = {20, 20}, odd = {20.5F, 0};
    const struct lx_exponent_double twenty_double = {20, 20}, odd_double = {20.5, 0};
    for (int i = 0; i < LX_WIDTH_single; i++) {
        assert_true(lesser_single(none, one)[i] == 1 && greater_single(none, one)[i] == 1);
        assert_true(lesser_single(one, two)[i] == 1 && lesser_single(two, one)[i] == 1);
        assert_true(greater_single(one, two)[i] == 2 && greater_single(two, one)[i] == 2);
        assert_true(power_of_single(none, none, twenty)[i] == 0 && power_of_single(none, none, odd)[i] == 0);
    }
    for (int i = 0; i < LX_WIDTH_double; i++) {
        assert_true(lesser_double(none_double, one_double)[i] == 1 && greater_double(none_double, one_double)[i] == 1);
        assert_true(power_of_double(none_double, one_double, twenty_double)[i] == 0);
        assert_true(power_of_double(none_double, one_double, odd_double)[i] == 0);
    }
}

/* The survey of values, also of numbers that do not fill the last vector, against plain loops. */
static void test_survey(void **state)
{
    (void)state;
    float values[100];
    for (int i = 0; i < 100; i++)
        values[i] = i % 7 == 3 ? 0 : (float)((i * 37) % 101) / 8;
    for (size_t count = 0; count <= 100; count++) {
        double maximum = 0, minimum = HUGE_VAL, sum = 0;
        size_t lit = 0;
        for (size_t i = 0; i < count; i++) {
            maximum = fmax(maximum, (double)values[i]);
            minimum = values[i] >= 1 ? fmin(minimum, (double)values[i]) : minimum;
            lit += values[i] >= 1;
            sum += (double)values[i];
        }
        struct lx_survey survey = survey_single(values, count, 1);
        assert_true(survey.maximum == maximum && survey.minimum == minimum);
        assert_true(survey.at_least == lit && survey.sum == sum); /* eighths: no rounding */
    }
    values[50] = NAN;
    assert_true(isnan(survey_single(values, 100, 1).sum));
}

/* Not a part of main(): compilers fill such a table by the instructions that are to be asked for first. */
__attribute__((noinline)) static int run_all(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_inverses),     cmocka_unit_test(test_roots),        cmocka_unit_test(test_whole_powers),
        cmocka_unit_test(test_other_powers), cmocka_unit_test(test_bounds),       cmocka_unit_test(test_angles),
        cmocka_unit_test(test_survey),       cmocka_unit_test(test_small_powers), cmocka_unit_test(test_small_cosines),
        cmocka_unit_test(test_arcs),         cmocka_unit_test(test_comparisons),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

int main(void)
{
    if (runs())
        return run_all();
    printf("1..0 # SKIP this machine does not have %s\n", LX_ISA_NAME);
    return 0;
}

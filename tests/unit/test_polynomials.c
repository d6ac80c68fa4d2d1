/* SPDX-License-Identifier: MIT */
/* Polynomials over squares of pixels: the one through values at nodes, what of it counts, what it is spread over. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "kernel/kernel.h"
#include "random_scenes.h"

/* ---- finding ---- */

/* Chebyshev's nodes, from the right, and what each gives a series. */
struct nodes {
    unsigned count;
    double place[LX_MOST_NODES];
    _Alignas(64) double series[LX_MOST_NODES][LX_LANES];
};

static const unsigned counts[] = {8, 10, 12, 16};

static struct nodes make_nodes(unsigned count)
{
    struct nodes nodes = {.count = count};
    for (unsigned i = 0; i < count; i++) {
        nodes.place[i] = cos(M_PI * (i + 0.5) / count);
        for (unsigned k = 0; k < count; k++)
            nodes.series[i][k] = (k > 0 ? 2.0 : 1.0) / count * cos(M_PI * k * (i + 0.5) / count);
    }
    return nodes;
}

/* A series of products T_l(u) T_k(t), each of which is smaller than the one before by the factor `decay`. */
struct series {
    unsigned count;
    double shares[LX_MOST_NODES][LX_MOST_NODES];
};

static struct series random_series(struct randomness *random, unsigned count, double decay)
{
    struct series series = {.count = count};
    for (unsigned l = 0; l < count; l++)
        for (unsigned k = 0; k < count; k++)
            series.shares[l][k] = uniform(random, -1, 1) * pow(decay, l + k);
    return series;
}

static double value_of(const struct series *series, double u, double t)
{
    double sum = 0;
    for (unsigned l = 0; l < series->count; l++)
        for (unsigned k = 0; k < series->count; k++)
            sum += series->shares[l][k] * cos(l * acos(u)) * cos(k * acos(t));
    return sum;
}

static double polynomial_at(const struct lx_polynomial *polynomial, double u, double t)
{
    double sum = 0;
    for (unsigned l = 0; l < polynomial->size; l++)
        for (unsigned k = 0; k < polynomial->size; k++)
            sum += (double)polynomial->terms[l][k] * pow(u, l) * pow(t, k);
    return sum;
}

/* As of some other square, of which no term may be left in the rows that count. */
static struct lx_polynomial used_polynomial(void)
{
    struct lx_polynomial polynomial = {.side = LX_PANEL_SIDE, .power = 1};
    memset(polynomial.terms, 0xFF, sizeof polynomial.terms); /* no numbers */
    return polynomial;
}

/* The polynomial is the series it was made of, within what it is said to be off by, and where some of it is left out
 * within roundings of float32.  Returns its size. */
static unsigned check_found(const struct lx_kernels *kernels, const struct nodes *nodes, const struct series *series)
{
    enum { GRID = 9 };
    _Alignas(64) double values[LX_BLOCK] = {0};
    struct lx_polynomial polynomial = used_polynomial();
    double most = 0, sum = 0;
    for (unsigned j = 0; j < nodes->count; j++)
        for (unsigned i = 0; i < nodes->count; i++)
            values[j * nodes->count + i] = value_of(series, nodes->place[j], nodes->place[i]);
    for (unsigned l = 0; l < series->count; l++)
        for (unsigned k = 0; k < series->count; k++)
            sum += fabs(series->shares[l][k]);
    const double off = kernels->find_polynomial(nodes->series, nodes->count, values, &polynomial);
    for (int j = 0; j < GRID; j++)
        for (int i = 0; i < GRID; i++) {
            const double u = 2.0 * j / (GRID - 1) - 1, t = 2.0 * i / (GRID - 1) - 1;
            most = fmax(most, fabs(polynomial_at(&polynomial, u, t) - value_of(series, u, t)));
        }
    assert_true(most <= off + 1e-12 * sum);
    for (unsigned l = 0; l < polynomial.size; l++)
        for (unsigned k = polynomial.size; k < LX_LANES; k++)
            assert_true(polynomial.terms[l][k] == 0);
    if (polynomial.size < nodes->count)
        assert_true(most <= (double)FLT_EPSILON * sum);
    return polynomial.size;
}

static void test_finding(void **state)
{
    (void)state;
    struct randomness random = {.state = 5};
    for (size_t k = 0; lx_kernels_get(k); k++) {
        bool has_size[LX_MOST_NODES + 1] = {false};
        if (!lx_kernels_get(k)->runs())
            continue;
        for (int i = 0; i < 400; i++) {
            const struct nodes nodes = make_nodes(counts[i % 4]);
            const struct series series = random_series(&random, nodes.count, logarithmic(&random, 0.01, 1));
            has_size[check_found(lx_kernels_get(k), &nodes, &series)] = true;
        }
        for (unsigned size = 0; size <= LX_MOST_NODES; size++)
            assert_int_equal(has_size[size], size == 6 || size == 7 || size == 8 || size == 12 || size == 16);
    }
}

/* One product alone, beyond a size or the last within it: it counts where it is more than roundings, and only there. */
static void test_sizes(void **state)
{
    (void)state;
    const struct nodes nodes = make_nodes(LX_MOST_NODES);
    const double little = 0.9 * (double)FLT_EPSILON / 4, much = 1.2 * (double)FLT_EPSILON / 4;
    for (size_t k = 0; lx_kernels_get(k); k++)
        for (unsigned degree = 0; lx_kernels_get(k)->runs() && degree < LX_MOST_NODES; degree++)
            for (unsigned other = 0; other <= degree; other += degree > 0 ? degree : 1)
                for (int is_down = 0; is_down < 2; is_down++) {
                    const unsigned expected = degree < 6 ? 6 : degree < 8 ? degree + 1 : degree < 12 ? 12 : 16;
                    struct series series = {.count = LX_MOST_NODES, .shares = {{1}}};
                    double *share = &series.shares[is_down ? degree : other][is_down ? other : degree];
                    *share += much;
                    assert_int_equal(check_found(lx_kernels_get(k), &nodes, &series), expected);
                    *share += little - much;
                    assert_int_equal(check_found(lx_kernels_get(k), &nodes, &series), 6);
                }
}

/* [degree][power] of Chebyshev's polynomials, each by the two before it. */
static void make_powers(double powers[LX_MOST_NODES][LX_MOST_NODES])
{
    memset(powers, 0, sizeof(double[LX_MOST_NODES][LX_MOST_NODES]));
    powers[0][0] = powers[1][1] = 1;
    for (unsigned n = 2; n < LX_MOST_NODES; n++)
        for (unsigned m = 0; m < LX_MOST_NODES; m++)
            powers[n][m] = (m > 0 ? 2 * powers[n - 1][m - 1] : 0) - powers[n - 2][m];
}

/* The terms of one product alone are whole numbers. */
static void check_terms(const struct lx_kernels *kernels, const struct nodes *nodes,
                        const double (*powers)[LX_MOST_NODES], unsigned l, unsigned k)
{
    _Alignas(64) double values[LX_BLOCK] = {0};
    struct lx_polynomial polynomial = used_polynomial();
    for (unsigned j = 0; j < nodes->count; j++)
        for (unsigned i = 0; i < nodes->count; i++)
            values[j * nodes->count + i] = cos(l * acos(nodes->place[j])) * cos(k * acos(nodes->place[i]));
    kernels->find_polynomial(nodes->series, nodes->count, values, &polynomial);
    assert_true(polynomial.size > l && polynomial.size > k);
    for (unsigned m = 0; m < polynomial.size; m++)
        for (unsigned p = 0; p < polynomial.size; p++) {
            const double exact = powers[l][m] * powers[k][p];
            assert_true(fabs((double)polynomial.terms[m][p] - exact) <= 1e-4 + (double)FLT_EPSILON * fabs(exact));
        }
}

static void test_terms(void **state)
{
    (void)state;
    double powers[LX_MOST_NODES][LX_MOST_NODES];
    make_powers(powers);
    for (size_t s = 0; lx_kernels_get(s); s++)
        for (size_t c = 0; lx_kernels_get(s)->runs() && c < sizeof counts / sizeof *counts; c++) {
            const struct nodes nodes = make_nodes(counts[c]);
            for (unsigned l = 0; l < nodes.count; l++)
                for (unsigned k = 0; k < nodes.count; k++)
                    check_terms(lx_kernels_get(s), &nodes, (const double(*)[LX_MOST_NODES])powers, l, k);
        }
}

/* ---- spreading ---- */

/* The power of the sum that the terms stand for, and nothing beyond the rows and columns that were asked for. */
static void check_spread(const struct lx_kernels *kernels, const struct lx_polynomial *polynomial, unsigned rows,
                         unsigned columns, bool adds)
{
    enum { STRIDE = LX_PANEL_SIDE + 3 };
    float values[(LX_PANEL_SIDE + 1) * STRIDE];
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        values[i] = 0.5F;
    kernels->spread_polynomial(polynomial, rows, columns, adds, values, STRIDE);
    for (unsigned row = 0; row <= LX_PANEL_SIDE; row++)
        for (unsigned column = 0; column < STRIDE; column++) {
            const double t = (2 * column + 1) / (double)polynomial->side - 1;
            const double u = (2 * row + 1) / (double)polynomial->side - 1;
            const bool is_in = row < rows && column < columns;
            const double sum = is_in ? fmax(polynomial_at(polynomial, u, t), 0) : 0;
            const double power = pow(sum, polynomial->power), kept = is_in && !adds ? 0 : 0.5;
            const double more = polynomial->power > 1 ? polynomial->power * pow(sum, polynomial->power - 1) : 1;
            assert_true(fabs((double)values[(size_t)row * STRIDE + column] - kept - power) <=
                        (is_in ? 1e-5 * (1 + more) : 0));
        }
}

static void test_spreading(void **state)
{
    (void)state;
    static const unsigned sizes[] = {1, 3, 8, 17, 31, 32, 33, 50, 64}, terms[] = {6, 7, 8, 12, 16};
    struct randomness random = {.state = 7};
    for (size_t k = 0; lx_kernels_get(k); k++)
        for (size_t r = 0; lx_kernels_get(k)->runs() && r < sizeof sizes / sizeof *sizes; r++)
            for (size_t c = 0; c < sizeof sizes / sizeof *sizes; c++) {
                struct lx_polynomial polynomial = {.size = terms[pick(&random, 5)], .power = 1};
                const bool is_half = sizes[r] <= 32 && sizes[c] <= 32 && pick(&random, 2);
                polynomial.side = is_half ? LX_PANEL_SIDE / 2 : LX_PANEL_SIDE;
                for (unsigned j = 0; j < polynomial.size; j++)
                    for (unsigned i = 0; i < polynomial.size; i++)
                        polynomial.terms[j][i] = (float)uniform(&random, -1, 1);
                check_spread(lx_kernels_get(k), &polynomial, sizes[r], sizes[c], r % 2 == 0);
            }
}

/* Polynomials of a plane, so that powers can be told to some roundings however faint they are; and what is below 0. */
static void test_powers(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++)
        for (unsigned power = 1; lx_kernels_get(k)->runs() && power < 80; power++) {
            struct lx_polynomial polynomial = {.size = 6, .side = LX_PANEL_SIDE, .power = power};
            float values[LX_PANEL_SIDE * LX_PANEL_SIDE];
            polynomial.terms[0][0] = 0.6F, polynomial.terms[0][1] = 0.3F, polynomial.terms[1][0] = -0.2F;
            lx_kernels_get(k)->spread_polynomial(&polynomial, LX_PANEL_SIDE, LX_PANEL_SIDE, false, values,
                                                 LX_PANEL_SIDE);
            for (int i = 0; i < LX_PANEL_SIDE * LX_PANEL_SIDE; i++) {
                const double t = (2 * (i % LX_PANEL_SIDE) + 1) / (double)LX_PANEL_SIDE - 1;
                const double u = (2 * (i / LX_PANEL_SIDE) + 1) / (double)LX_PANEL_SIDE - 1;
                const double exact = pow(fmax(polynomial_at(&polynomial, u, t), 0), power);
                assert_true(fabs((double)values[i] - exact) <=
                            (3 + 4 * power) * (double)FLT_EPSILON * exact + (double)FLT_MIN);
            }
            polynomial.terms[0][0] = -2;
            lx_kernels_get(k)->spread_polynomial(&polynomial, 1, LX_PANEL_SIDE, false, values, LX_PANEL_SIDE);
            for (int i = 0; i < LX_PANEL_SIDE; i++)
                assert_true(values[i] == 0);
        }
}

/* ---- roots ---- */

static void test_roots(void **state)
{
    (void)state;
    struct randomness random = {.state = 11};
    for (size_t k = 0; lx_kernels_get(k); k++)
        for (int i = 0; lx_kernels_get(k)->runs() && i < 2000; i++) {
            enum { COUNT = 2 * LX_LANES };
            _Alignas(64) double values[COUNT], roots[COUNT];
            const double n = floor(logarithmic(&random, 1, 70000));
            for (int j = 0; j < COUNT; j++)
                roots[j] = values[j] = logarithmic(&random, DBL_MIN, 1e200);
            lx_kernels_get(k)->find_roots(roots, LX_LANES, n);
            for (int j = 0; j < COUNT; j++) {
                const double exact = j < LX_LANES ? pow(values[j], 1 / n) : values[j];
                assert_true(fabs(roots[j] - exact) <= (j < LX_LANES ? 1e-13 * exact : 0));
            }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_finding),   cmocka_unit_test(test_sizes),  cmocka_unit_test(test_terms),
        cmocka_unit_test(test_spreading), cmocka_unit_test(test_powers), cmocka_unit_test(test_roots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* The compensated operations behind bounded numbers. */
#include "bounded.h"

static struct lx_pair exact_sum(double a, double b)
{
    double sum = a + b;
    double part = sum - a;
    return (struct lx_pair){sum, (a - (sum - part)) + (b - part)};
}

struct lx_pair lx_exact_difference(double a, double b)
{
    return exact_sum(a, -b);
}

struct lx_pair lx_exact_product(double a, double b)
{
    double product = a * b;
    return (struct lx_pair){product, fma(a, b, -product)};
}

struct lx_pair lx_exact_difference_of_squares(double a, double b)
{
    struct lx_pair a2 = lx_exact_product(a, a), b2 = lx_exact_product(b, b);
    struct lx_pair difference = exact_sum(a2.high, -b2.high);
    return exact_sum(difference.high, a2.low + (difference.low - b2.low));
}

struct lx_pair lx_exact_dot(unsigned count, const double a[], const double b[], double *error)
{
    double sum = 0, rest = 0, magnitude = 0;
    for (unsigned i = 0; i < count; i++) {
        struct lx_pair product = lx_exact_product(a[i], b[i]);
        struct lx_pair partial = exact_sum(sum, product.high);
        sum = partial.high;
        rest += partial.low + product.low;
        magnitude += fabs(product.high);
    }
    double share = 2 * count * LX_ROUNDING;
    *error = share * share * magnitude * LX_BOUND_SLACK;
    return exact_sum(sum, rest);
}

/* SPDX-License-Identifier: MIT */
/* The compensated operations behind bounded numbers. */
#include "bounded.h"

struct lx_pair lx_exact_dot(unsigned count, const double a[], const double b[], double *error)
{
    double sum = 0, rest = 0, magnitude = 0;
    for (unsigned i = 0; i < count; i++) {
        struct lx_pair product = lx_exact_product(a[i], b[i]);
        struct lx_pair partial = lx_exact_sum(sum, product.high);
        sum = partial.high;
        rest += partial.low + product.low;
        magnitude += fabs(product.high);
    }
    double share = 2 * count * LX_ROUNDING;
    *error = share * share * magnitude * LX_BOUND_SLACK;
    return lx_exact_sum(sum, rest);
}

/* SPDX-License-Identifier: MIT */
/* Rules of Gauss with few and with many places, for what the kernels integrate (kernel_rows.h). */
#ifndef LX_KERNEL_RULES_H
#define LX_KERNEL_RULES_H

/* How many places there are rules with. */
#define LX_RULE_COUNTS 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 32, 40, 48, 64
enum { LX_RULES = 18, LX_MOST_PLACES = 64 };

/*
 * A rule of n places along what is no longer than L and no nearer than d leaves of a smooth sum no more than
 * 1.6 (n + 1) rho^-2n, rho = exp(asinh(2 d/L)), of what it would give from straight in front, as near (tests/unit/
 * test_laws.c).  Product rules have no more than so many places either way, for which LX_MISSED_BY_PRODUCTS is
 * ln 1.6 (n + 1).
 */
enum { LX_MOST_NODES_ACROSS = 8 };
#define LX_MISSED_BY_PRODUCTS 2.7

/* From -1 to 1; the weights come to 2. */
struct lx_gauss_rule {
    unsigned count;
    double places_double[LX_MOST_PLACES], weights_double[LX_MOST_PLACES];
    float places_single[LX_MOST_PLACES], weights_single[LX_MOST_PLACES];
};

struct lx_gauss_rules {
    double digits; /* how exact: the natural logarithm of the relative error, with its sign turned */
    struct lx_gauss_rule rules[LX_RULES];
};

/* Rules for a relative error; NULL when memory ran out. */
struct lx_gauss_rules *lx_gauss_rules_new(double error);

#endif

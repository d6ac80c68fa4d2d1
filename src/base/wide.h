/* SPDX-License-Identifier: MIT */
/*
 * Wide numbers: unevaluated sums of two float64 numbers, some 31 decimal digits, for the few formulas whose terms
 * cancel to many digits (Lambert's sum over the edges of a small polygon).  Each operation is good to a relative
 * LX_WIDE_ROUNDING; nothing here handles infinities, and products may not underflow.
 *
 * Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971); Joldes, Muller,
 * Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic, ACM TOMS 44 (2017).
 */
#ifndef LX_BASE_WIDE_H
#define LX_BASE_WIDE_H

#include "bounded.h"

typedef struct lx_pair lx_wide;

typedef struct lx_wide3 {
    lx_wide x, y, z;
} lx_wide3;

/* Bounds the relative error of + - * / sqrt, and of atan2, log and atanh relative to their result. */
#define LX_WIDE_ROUNDING 0x1p-98

lx_wide lx_wide_of(double value);
double lx_wide_value(lx_wide a); /* rounded to float64 */

lx_wide lx_wide_negate(lx_wide a);
lx_wide lx_wide_add(lx_wide a, lx_wide b);
lx_wide lx_wide_sub(lx_wide a, lx_wide b);
lx_wide lx_wide_mul(lx_wide a, lx_wide b);
lx_wide lx_wide_div(lx_wide a, lx_wide b);
lx_wide lx_wide_scale(lx_wide a, double power_of_two);
lx_wide lx_wide_sqrt(lx_wide a);             /* 0 for a <= 0 */
lx_wide lx_wide_atan2(lx_wide y, lx_wide x); /* 0 for (0, 0) */
lx_wide lx_wide_log(lx_wide a);              /* a > 0 */
lx_wide lx_wide_atanh(lx_wide a);            /* |a| < 1 */
lx_wide lx_wide_pi(void);
int lx_wide_compare(lx_wide a, lx_wide b); /* < 0, 0, > 0 */

lx_wide3 lx_wide3_of(const double v[3]);
void lx_wide3_values(lx_wide3 a, double values[3]); /* rounded to float64 */
lx_wide3 lx_wide3_add(lx_wide3 a, lx_wide3 b);
lx_wide3 lx_wide3_sub(lx_wide3 a, lx_wide3 b);
lx_wide3 lx_wide3_mul(lx_wide3 a, lx_wide factor);
lx_wide lx_wide3_dot(lx_wide3 a, lx_wide3 b);
lx_wide3 lx_wide3_cross(lx_wide3 a, lx_wide3 b);
lx_wide lx_wide3_length(lx_wide3 a);
lx_wide3 lx_wide3_unit(lx_wide3 a);

#endif

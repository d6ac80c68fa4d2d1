/* SPDX-License-Identifier: MIT */
/*
 * The larger and the smaller of two numbers, of which the second is not NaN: in place, where fmax() and fmin(), which
 * have to look for NaN on both sides, are calls that cost more than the work between them.  Their order, for qsort().
 */
#ifndef LX_BASE_LARGER_H
#define LX_BASE_LARGER_H

static inline double lx_larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double lx_smaller(double a, double b)
{
    return a < b ? a : b;
}

/* The order of two numbers behind pointers: less than 0 where the first is the smaller one. */
static inline int lx_by_value(const void *first, const void *second)
{
    const double a = *(const double *)first, b = *(const double *)second;
    return (a > b) - (a < b);
}

#endif

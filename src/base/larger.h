/* SPDX-License-Identifier: MIT */
/*
 * The larger and the smaller of two numbers, of which the second is not NaN: in place, where fmax() and fmin(), which
 * have to look for NaN on both sides, are calls that cost more than the work between them.
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

#endif

/* SPDX-License-Identifier: MIT */
/*
 * float64 as the numbers of the formulas that are included after this file, with lanes.h: what in them depends on the
 * precision.  Where both precisions are wanted, it comes first.
 */
#define REAL double
#define LX_IS_SINGLE 0
#define SUFFIX pd
#define NAME(x) x##_double
#define BITS uint64_t
#define MANTISSA 52
#define BIAS 1023
#define MAGIC 6755399441055744.0
#define SMALLEST 2.2250738585072014e-308
#define TINY 1e-200
#define SQRT sqrt
#define LOG_TERMS 11
#define EXP_TERMS 14
#include "lanes.h"

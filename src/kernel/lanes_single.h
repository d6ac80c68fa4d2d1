/* SPDX-License-Identifier: MIT */
/*
 * float32 as the numbers of the formulas that are included after this file, with lanes.h: what in them depends on the
 * precision.  It comes after lanes_double.h and what is included behind that.
 */
#undef REAL
#undef LX_IS_SINGLE
#undef SUFFIX
#undef NAME
#undef BITS
#undef MANTISSA
#undef BIAS
#undef MAGIC
#undef SMALLEST
#undef TINY
#undef SQRT
#undef LOG_TERMS
#undef EXP_TERMS

#define REAL float
#define LX_IS_SINGLE 1
#define SUFFIX ps
#define NAME(x) x##_single
#define BITS uint32_t
#define MANTISSA 23
#define BIAS 127
#define MAGIC 12582912.0F
#define SMALLEST 1.17549435e-38F
#define TINY 1e-30F
#define SQRT sqrtf
#define LOG_TERMS 5
#define EXP_TERMS 8
#include "lanes.h"

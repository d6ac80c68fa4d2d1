/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by extended sources of laws without closed forms, compiled once for each instruction set as kernel.c
 * is: rows and rings in place of its sums over contours.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "kernel_law.h"

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

#include "kernel_functions.h"
#include "kernel_space.h"

#include "kernel_nodes.h"
#include "kernel_rows.h"

#include "kernel_rings.h"
#include "kernel_rows_round.h"
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

#include "kernel_functions.h"
#include "kernel_space.h"

#include "kernel_nodes.h"
#include "kernel_rows.h"

#include "kernel_rings.h"
#include "kernel_rows_round.h"

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

#include "lanes_double.h"

#include "kernel_functions.h"
#include "kernel_space.h"

#include "kernel_nodes.h"
#include "kernel_rows.h"

#include "kernel_rings.h"
#include "kernel_rows_round.h"

#include "lanes_single.h"

#include "kernel_functions.h"
#include "kernel_space.h"

#include "kernel_nodes.h"
#include "kernel_rows.h"

#include "kernel_rings.h"
#include "kernel_rows_round.h"

/* SPDX-License-Identifier: MIT */
/* Bounded numbers: what was computed, with how far it may be from the truth. */
#ifndef LUXEL_BOUNDED_H
#define LUXEL_BOUNDED_H

#include <luxel/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A number and the bound of its error: |value - truth| <= error.  A structure about one number has the two itself. */
typedef struct luxel_bounded {
    double value; /* in the unit of what it belongs to */
    double error; /* in the same */
} luxel_bounded;

/*
 * A bound as it may be shown: the least number of `digits` significant digits (1 to 17) that is not below it, so that
 * printf's %.*g of it is still a bound.  What is 0, below 0 or not finite stays as it is.
 */
LUXEL_API double luxel_round_bound(double error, int digits);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/* Bounded numbers: what was computed, with how far it may be from the truth. */
#ifndef LUXEL_BOUNDED_H
#define LUXEL_BOUNDED_H

#ifdef __cplusplus
extern "C" {
#endif

/* A number and the bound of its error: |value - truth| <= error.  A structure about one number has the two itself. */
typedef struct luxel_bounded {
    double value; /* in the unit of what it belongs to */
    double error; /* in the same */
} luxel_bounded;

#ifdef __cplusplus
}
#endif
#endif

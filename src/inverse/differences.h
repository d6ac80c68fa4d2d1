/* SPDX-License-Identifier: MIT */
/*
 * Differences of a function for halved steps, extrapolated to step 0 (Richardson's tableau, as Ridders uses it).
 *
 * Row k holds a difference quotient for the step h/2^k, whose error is a series in powers of the step; column j has the
 * first j powers removed.  What the function's own errors can make of each entry is carried along beside it.
 */
#ifndef LX_INVERSE_DIFFERENCES_H
#define LX_INVERSE_DIFFERENCES_H

#include <luxel/derive.h>

#include <stdbool.h>

enum { LX_EXTRAPOLATIONS = 6 }; /* columns of a tableau */

struct lx_tableau {
    unsigned first, step; /* powers of the step that the quotient's error has: first, first + step ... */
    unsigned rows;
    double value[LX_EXTRAPOLATIONS]; /* the last row */
    double noise[LX_EXTRAPOLATIONS]; /* what the function's errors make of it */
    double best, error;              /* the entry with the least error, and that; infinite before the second row */
};

/* A function around a place: what is known of its derivative there. */
struct lx_differences {
    bool is_one_sided;
    double middle, middle_error;  /* the function's value at the place */
    double greatest;              /* the greatest absolute value that was met */
    double first_step;            /* the largest step */
    bool is_missing;              /* it had no value at one of the steps */
    struct lx_tableau slope, gap; /* the derivative; and the change of slope from side to side, 0 of smooth ones */
};

/* A function with this value at the place; one that is one-sided is only asked on one side of it. */
void lx_differences_begin(struct lx_differences *differences, double middle, double error, bool is_one_sided);

/*
 * Adds the values at a step's end above and below the place; each step is half of the one before.  Where the function
 * is one-sided the step may be negative, and there is nothing below.
 */
void lx_differences_add(struct lx_differences *differences, double step, const double values[2],
                        const double errors[2]);

/* Whether smaller steps can tell no more: the function's errors alone make more of them. */
bool lx_differences_are_done(const struct lx_differences *differences);

/* The derivative that they tell, or why there is none. */
luxel_derivative lx_differences_conclude(const struct lx_differences *differences);

#endif

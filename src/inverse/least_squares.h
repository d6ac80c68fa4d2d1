/* SPDX-License-Identifier: MIT */
/*
 * Linear least squares of a few unknowns: what rows of coefficients and right sides say of them, and what they do not.
 *
 * Columns may be scaled to length 1 first, so that units do not matter.  A = Q R by Householder's reflections,
 * R = U S V' by one-sided Jacobi rotations (Golub and Van Loan, Matrix Computations, 5.2 and 8.6).
 */
#ifndef LX_INVERSE_LEAST_SQUARES_H
#define LX_INVERSE_LEAST_SQUARES_H

#include <stdbool.h>
#include <stddef.h>

/* Its arrays hold so many numbers of so many columns, column by column. */
struct lx_least_squares {
    size_t columns;
    double *scale;    /* columns: the length of each, 1 of one that is 0 or not scaled */
    double *rotated;  /* columns x columns: U S */
    double *right;    /* columns: Q'b */
    double *singular; /* columns: S, the greatest first */
    double *v;        /* columns x columns: what goes with each is a column */
};

/* Room for so many columns; false: memory ran out.  Clear it in any case. */
bool lx_least_squares_make(size_t columns, struct lx_least_squares *squares);
void lx_least_squares_clear(struct lx_least_squares *squares);

/*
 * Takes in a matrix of `rows` rows, at least as many as columns, and its right side, which are used up.  Columns that
 * are no longer than `least` of theirs count as 0; `least` NULL: none of more than 0 does.
 */
void lx_least_squares_solve(struct lx_least_squares *squares, double *a, double *b, size_t rows, const double *least,
                            bool is_scaled);

/* The unknowns that make the squares least, damped by Marquardt's number, of directions that are known to `tolerance`
 * of the best one. */
void lx_least_squares_step(const struct lx_least_squares *squares, double damping, double tolerance, double *step);

/* How many directions are known so well. */
size_t lx_least_squares_rank(const struct lx_least_squares *squares, double tolerance);

/* The covariance of two unknowns for right sides of variance 1, over the first `rank` directions. */
double lx_least_squares_covariance(const struct lx_least_squares *squares, size_t rank, size_t i, size_t j);

#endif

/* SPDX-License-Identifier: MIT */
/* Linear programs of a few unknowns and many conditions, by the simplex method of Dantzig. */
#ifndef LX_INVERSE_LINEAR_PROGRAM_H
#define LX_INVERSE_LINEAR_PROGRAM_H

#include <stddef.h>

/*
 * Makes gain . x greatest where x >= 0 and a x <= b, with b >= 0, so that x = 0 is allowed.  The table has rows of
 * `columns` + 1 numbers: those of a, and b behind them; a last row of zeros is for the gains.  It is used up, and
 * `basis` has room for rows + columns.  What is unbounded, or not done after many steps, is left where it was.
 */
void lx_linear_program(double *table, size_t rows, size_t columns, const double *gain, size_t *basis, double *x);

#endif

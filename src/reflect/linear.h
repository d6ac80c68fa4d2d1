/* SPDX-License-Identifier: MIT */
/*
 * The linear system of reflected light: x = right + K (rho x), K the matrix of transfers between the nodes of all
 * tiles, whose rows sum to no more than 1, so that it has one solution wherever rho is below 1.
 */
#ifndef LX_REFLECT_LINEAR_H
#define LX_REFLECT_LINEAR_H

#include <stddef.h>

#include "../base/rows.h"

struct lx_radiosity;

struct lx_linear {
    size_t count;
    const struct lx_radiosity *reflected; /* whose tiles have rows */
    const double *reflectance;            /* of each node */
    double rest;                          /* the share of the right side that a solution may leave */
    struct lx_control *control;
    unsigned threads;
};

/* sum = right + K (rho x); neither is x.  False: the work is to stop. */
bool lx_linear_bounce(const struct lx_linear *linear, const double *right, const double *x, double *sum);

/* All bounces: the solution, by GMRES.  0, or -1 when memory ran out or the work is to stop. */
int lx_linear_solve(const struct lx_linear *linear, const double *right, double *x);

#endif

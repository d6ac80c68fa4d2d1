/* SPDX-License-Identifier: MIT */
/*
 * Gauss's rule with 16 nodes on panels that keep their distance from the places in the complex plane where the
 * integrand is singular.  Where a panel's middle is 3 of its half lengths from the nearest of them, the integrand is
 * analytic within an ellipse about the panel with Bernstein's parameter 4.7, and there at most some 1000 times as large
 * as on the panel: the rule leaves 1000 * 4.7^-32 = 3e-19 of it.
 */
#ifndef LX_LIGHT_GAUSS_H
#define LX_LIGHT_GAUSS_H

enum { LX_GAUSS_NODES = 16, LX_MOST_PANELS = 200 };

/* A node on (-1, 1), its distance from 1, and its weight. */
struct lx_gauss_node {
    double place, rest, weight;
};

extern const struct lx_gauss_node lx_gauss[LX_GAUSS_NODES];

/* A place off the real axis. */
struct lx_pole {
    double along, off;
};

/* Where a panel from `from` towards `to` has to end: there, or after a half, a quarter ... of the way; `from` itself
 * where a pole is too near for float64 numbers. */
double lx_panel_end(double from, double to, const struct lx_pole poles[], int count);

#endif

/* SPDX-License-Identifier: MIT */
/* The formulas and functions that lobes which are powers S^n have in common. */
#ifndef LX_MATERIAL_POWER_H
#define LX_MATERIAL_POWER_H

#include "lobe.h"

/* Formulas of the brightness, plain and normalised. */
#define LX_POWER_BRIGHTNESS "\\left( k_d \\max(0, \\mathbf{N} \\cdot \\mathbf{L}) + k_s\\, w\\, S^n \\right)"
#define LX_POWER_NORMALIZED "\\left( k_d \\max(0, \\mathbf{N} \\cdot \\mathbf{L}) + k_s\\, c\\, w\\, S^n \\right)"

/* S^n of the lobe's pair of vectors, by the cosine and the squared sine of their angle. */
lx_bounded lx_power_value(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards);

/* The logarithm of S^n, and its relative error where S's angle is off by `off`; -HUGE_VAL where S <= 0. */
double lx_power_log(double exponent, double cosine, double sine_squared, double off, double *error);

/* Where N.H may be greatest on the great circle of directions a cos(tau) + b sin(tau), as in struct lx_lobe_kind. */
size_t lx_half_peaks(bool is_sharp, const struct lx_lobe_at *at, const double a[3], const double b[3],
                     double tau[LX_MOST_PEAKS]);

/* The square of the length of a x b. */
double lx_cross_square(const double a[3], const double b[3]);

#endif

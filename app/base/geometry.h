/* SPDX-License-Identifier: MIT */
/* Vectors of space: what the standard library of C lacks of them. */
#ifndef LUXEL_APP_GEOMETRY_H
#define LUXEL_APP_GEOMETRY_H

#include <glib.h>

/* A vector of length 1; FALSE and as it is where it has no length.  The two may be the same. */
gboolean app_unit(const double vector[3], double unit[3]);
/* The product of two vectors, which is neither of them. */
void app_cross(const double a[3], const double b[3], double product[3]);
/* Two unit vectors across an axis, the second along `up` as far as that goes. */
void app_basis(const double axis[3], const double up[3], double u[3], double v[3]);

#endif

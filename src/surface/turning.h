/* SPDX-License-Identifier: MIT */
/* Rotations as users write them: degrees about x, then about y, then about z. */
#ifndef LX_SURFACE_TURNING_H
#define LX_SURFACE_TURNING_H

#include "../base/bounded.h"

/* Where they take the unit vector along x (0), y (1) or z (2); multiples of 90 degrees have no error. */
lx_bounded3 lx_turned_axis(const double degrees[3], int axis);

#endif

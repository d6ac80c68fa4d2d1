/* SPDX-License-Identifier: MIT */
/* The area that a luminous opening shows, by which its luminance and its solid angle are told. */
#ifndef LX_FORMAT_PHOTOMETRY_AREA_H
#define LX_FORMAT_PHOTOMETRY_AREA_H

#include <luxel/photometry.h>

/* In m², towards a direction (along the axis, C = 0 and C = 90) of length 1; 0: of a point. */
double lx_opening_seen_area(const luxel_photometry_opening *opening, const double direction[3]);

#endif

/* SPDX-License-Identifier: MIT */
/* Sections of a table: the intensity along a great circle through the axis, and how wide its beam is. */
#ifndef LX_FORMAT_PHOTOMETRY_SECTION_H
#define LX_FORMAT_PHOTOMETRY_SECTION_H

#include <luxel/photometry.h>

/*
 * A closed curve, linear between its places: angles rise from -180 to 180 degrees from the axis, below 0 in the plane
 * opposite; where the table ends two places have one angle.
 */
struct lx_section {
    double *angles_deg, *values;
    size_t count;
};

/*
 * The section in the planes C and C + 180; of types A and B the horizontal one (C = 0) or the vertical one (C = 90).
 * False: no memory.
 */
bool lx_section_of(const luxel_photometry *photometry, double plane_deg, struct lx_section *section);
void lx_section_clear(struct lx_section *section);

/*
 * The full angle over which the intensity is at least a share of the greatest of the section.  Where the section is
 * symmetric about the axis it is measured across the axis, up to where the intensity falls below for good on that half;
 * else around the greatest.
 */
double lx_section_width(const struct lx_section *section, double share);

#endif

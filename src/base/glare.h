/* SPDX-License-Identifier: MIT */
/* Glare: how much less a source dazzles away from the line of sight than on it. */
#ifndef LX_BASE_GLARE_H
#define LX_BASE_GLARE_H

/*
 * The position index of Guth for a source `ahead` of the eye, `aside` and `above`, lengths of any unit: 1 on the line
 * of sight, greater away from it.  NaN: outside the field of view that unified glare rating counts, which ends at the
 * height of the eye, at the slopes 3 aside and 1.9 above (CIE 117).
 */
double lx_position_index(double ahead, double aside, double above);

/* The index by the table of CIE 117, which CIE 190 uses, linear between its places: up to a tenth off the fit.  NaN
 * where the table has none. */
double lx_position_index_of_table(double ahead, double aside, double above);

#endif

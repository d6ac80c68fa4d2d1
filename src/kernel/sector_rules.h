/* SPDX-License-Identifier: MIT */
/* The rules of Gauss by which partial highlights are summed, and what they have to know of a lobe in a part of a
 * source. */
#ifndef LX_KERNEL_SECTOR_RULES_H
#define LX_KERNEL_SECTOR_RULES_H

#include "kernel.h"

enum { LX_PARTIAL_HIGHLIGHT_NODES = 8 };

/* On (0, 1): of n nodes in row n - 1. */
extern const double lx_sector_places[LX_PARTIAL_HIGHLIGHT_NODES][LX_PARTIAL_HIGHLIGHT_NODES];
extern const double lx_sector_weights[LX_PARTIAL_HIGHLIGHT_NODES][LX_PARTIAL_HIGHLIGHT_NODES];

/* How many nodes do, but no fewer than so many, for what is twice `half` widths of the lobe long. */
unsigned lx_sector_order(unsigned least, double half);

/* The greatest S^n within an angle from the middle, as in sight.c; `mirrored`: the view. */
double lx_sector_power(const struct lx_lobe_double *lobe, const double mirrored[3], const double middle[3],
                       double cosine, double sine);

/* How wide the lobe is in a part, as a tangent: half vectors turn the faster the shorter they are. */
double lx_sector_width(const struct lx_lobe_double *lobe, const double view[3], const double middle[3], double sine);

#endif

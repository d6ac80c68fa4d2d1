/* SPDX-License-Identifier: MIT */
/*
 * What diffuse models of rough surfaces have in common.  With s = L.V - (N.L)(N.V) and t the greater of N.L and N.V,
 * each cut at 0, they know a slope q: s/t where s > 0, that is sin(alpha) tan(beta) cos(phi), and s elsewhere, where
 * some leave it out.  It has kinks where s = 0 and where N.L = N.V.
 */
#ifndef LX_MATERIAL_ROUGH_H
#define LX_MATERIAL_ROUGH_H

#include "lobe.h"

#define LX_ROUGH_SLOPE                                                                                                 \
    "s = \\mathbf{L} \\cdot \\mathbf{V} - (\\mathbf{N} \\cdot \\mathbf{L})(\\mathbf{N} \\cdot \\mathbf{V})"

struct lx_slope {
    lx_bounded lit, seen, value; /* N.L and N.V, cut at 0; q */
};

struct lx_slope lx_slope_of(lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards);

/* N.L cut at 0, q and its error for an L that is off by `moved`, in plain float64. */
double lx_slope_at(const struct lx_lobe_at *at, const double towards[3], double moved, double *lit, double *error);

size_t lx_slope_kinks(const struct lx_lobe_at *at, struct lx_border kinks[LX_MOST_KINKS]);

#endif

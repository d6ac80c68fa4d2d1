/* SPDX-License-Identifier: MIT */
/*
 * Lobes: the prepared constants of a material, and the float64 reference of how it reflects one light sample:
 *
 *     brightness = E_perp (diffuse max(0, N.L) + specular w S^exponent),   ambient light: ambient E
 *
 * S is N.H for the half-vector lobe, R.V for the mirror lobe.  The factors hold p, kd, ks, ka and c of the
 * material (Blinn 1977; Phong 1975; normalisation as in docs/MATHS).
 */
#ifndef LX_MATERIAL_LOBE_H
#define LX_MATERIAL_LOBE_H

#include "../base/bounded.h"
#include "model.h"

struct lx_material;

struct lx_lobe {
    enum lx_model model;
    enum lx_highlight highlight;
    lx_bounded diffuse, specular, ambient;
    double exponent;
};

struct lx_lobe lx_lobe_prepare(const struct lx_material *material);

/* The lobe that makes the irradiance itself: diffuse and ambient 1, no highlight. */
struct lx_lobe lx_lobe_irradiance(void);

/* What a lobe makes of light from L (unit), for the normal N and view V (units). */
struct lx_reflection {
    lx_bounded cosine;            /* max(0, N.L) */
    lx_bounded diffuse, specular; /* brightness for each unit of E_perp */
};

struct lx_reflection lx_lobe_reflect(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view,
                                     lx_bounded3 towards);

#endif

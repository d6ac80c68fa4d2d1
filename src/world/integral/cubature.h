/* SPDX-License-Identifier: MIT */
/*
 * Cubature: the light of an extended source on one element where no closed form exists, that is every highlight,
 * and the diffuse part by the laws 1/(k + r) and 1.  Adaptive, to a tolerance, with an error estimate.
 *
 * Every source is swept by arcs of great circles as the element sees it: in longitude beta and latitude tau about a
 * pole d, a part of the source lies between tau1(beta) and tau2(beta), and
 *
 *     integral of f(L) r^2 a(r) dw = integral dbeta integral dtau cos(tau) f r^2 a.
 */
#ifndef LX_WORLD_CUBATURE_H
#define LX_WORLD_CUBATURE_H

#include "../../base/rows.h"
#include "../element.h"
#include "../visibility/occlusion.h"

struct lx_cubature {
    lx_bounded irradiance; /* where it was asked for */
    lx_bounded specular;   /* brightness by the highlight */
    size_t parts;          /* number of points of the source that were looked at */
};

/*
 * Integrates over what is left of an extended source that does not touch the element, behind what stands in the way
 * (NULL: nothing).  `diffuse` says whether the irradiance is wanted; the highlight is, where the lobe has one.
 * `tolerance` is relative to diffuse brightness + highlight; `known` is the share of that sum which is known already (a
 * diffuse part in closed form).  The bounds tell what was reached.  Where the work is to stop it ends early, with any
 * result.
 */
struct lx_cubature lx_integrate(const struct lx_emitter *emitter, const struct lx_element *element,
                                struct lx_occlusion *occlusion, bool diffuse, double known, double tolerance,
                                const struct lx_asking *asking);

#endif

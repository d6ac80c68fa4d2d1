/* SPDX-License-Identifier: MIT */
/*
 * Polynomials in place of the highlights of extended sources, which are exact to a tolerance only, as samples of the
 * sources are (sampling.h).  Over a small square all of them together are sampled at a few nodes, and the polynomial
 * through the sums takes their place.
 *
 * That they are smooth there, and no narrower than what nodes can see, follows from a bound of them as an analytic
 * function a little around the square, by parts of the sources (smooth_lights.h).  How far the polynomial is from them
 * the last of its own terms tell, as the difference of two rules does where a source is sampled.
 */
#ifndef LX_PICTURE_SMOOTH_GLOSS_H
#define LX_PICTURE_SMOOTH_GLOSS_H

#include "smooth.h"

/* By the fewest nodes that may do. */
void lx_gloss_bases_make(struct lx_basis bases[LX_GLOSS_BASES]);

/* DARK: there are no highlights that matter.  ROUGH: they have to be summed in smaller squares, or for each pixel. */
enum lx_gloss { LX_GLOSS_DARK, LX_GLOSS_SMOOTH, LX_GLOSS_ROUGH };

/* The highlights over a square whose surface has some: where they are smooth, the polynomial.  The elements that the
 * shader has seen are lost.  Where the work is to stop the polynomial means nothing. */
enum lx_gloss lx_gloss_fit(const struct lx_plan *plan, struct lx_fitting *fitting, struct lx_shader_memory *shader,
                           const struct lx_square *square, const struct lx_asking *asking,
                           struct lx_polynomial *polynomial);

#endif

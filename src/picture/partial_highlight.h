/* SPDX-License-Identifier: MIT */
/*
 * Partial highlights: the highlight of what an element sees of a source that obstacles hide in part, or its irradiance
 * by other laws than 1/r^2, to the accuracy of a picture.
 *
 * What is seen is bounded by pieces of curves (boundary.h).  Each piece and a direction within the source are the sides
 * of a sector; signed, these sectors make up what is seen, and the highlight over each is a product rule of Gauss: a
 * smooth function of the element as long as the pieces are the same ones.  How many nodes a rule has follows from the
 * angle under which the sector is seen in widths of the lobe; a source that is too wide for them is cut into parts, and
 * those that cannot matter are left out.
 */
#ifndef LX_PICTURE_PARTIAL_HIGHLIGHT_H
#define LX_PICTURE_PARTIAL_HIGHLIGHT_H

#include "plan.h"

/* From which tolerance on the rules are good enough. */
#define LX_PARTIAL_HIGHLIGHT_TOLERANCE 1e-4

/* An element, and what it sees of a source. */
struct lx_partial_highlight {
    const struct lx_kernels *kernels;
    const struct lx_sampled *source;
    const struct lx_occlusion *occlusion;
    const struct lx_lobe_double *lobe;
    const struct lx_lobe_single *lobe_single;
    double normal[3], view[3];
    double allowed; /* how far the highlight may be off */
    bool is_matte;  /* irradiance is asked for instead, good to some 1e-8 */
};

/* For a radiance and a specular coefficient of 1.  False: it is not known, as there are sources, lobes or obstacles
 * that the rules are not for. */
bool lx_partial_highlight_sum(const struct lx_partial_highlight *partial, double *sum);

/* The highlight of so many beams, one or more, for those rules; others up to lx_padded() are set. */
double lx_partial_highlight_of_beams(const struct lx_partial_highlight *partial, struct lx_beams_double *beams,
                                     size_t used);

/* The highlight of facets by the law 1/r^2 behind the outline of meshes, in slabs between its edges. */
bool lx_partial_highlight_outline(const struct lx_partial_highlight *partial, const struct lx_asking *asking,
                                  double *sum);

#endif

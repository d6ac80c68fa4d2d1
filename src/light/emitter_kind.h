/* SPDX-License-Identifier: MIT */
/*
 * Kinds of emitters: what an emitter of each kind tells of itself.  Whoever lights, hides, integrates or draws asks for
 * what it wants to know, here and in extended.h, and never which kind it is.
 *
 * To add a kind: a file like solid/ball.c, which exports its descriptor, and a row in LX_EMITTER_KINDS of emitter.h
 * (docs/ADDING-AN-EMITTER.md).  Lengths are mm, areas mm^2; directions are unit vectors; a radiance is taken as 1.
 */
#ifndef LX_LIGHT_EMITTER_KIND_H
#define LX_LIGHT_EMITTER_KIND_H

#include "emitter.h"

struct lx_emitter_kind {
    const char *name;

    /* ---- without size: uniform, parallel, a point ---- */
    /* The light that it gives at a place: its reference. */
    struct lx_sample (*sample)(const struct lx_emitter *emitter, lx_bounded3 place_mm);

    /* ---- with size; the rest is theirs, and is NULL or false for the others ---- */
    /* Round ones are disks, or balls where they bulge, that move along the axis by half of `height_mm` both ways where
     * they have a side.  Those made of facets are neither. */
    bool has_side, bulges;
    /* How much of its area counts as turned to one place, at most: the integral of the cosine of incidence over it. */
    double share_seen;
    lx_bounded (*area_mm2)(const struct lx_emitter *emitter);
    /* The largest area that a plane across any direction cuts out of the rays through it. */
    double (*section_mm2)(const struct lx_emitter *emitter);
    /* The area that it shows to an eye far away in a direction. */
    double (*area_seen_mm2)(const struct lx_emitter *emitter, const double towards[3]);
    /* Whether a place lies on it, as far as its error tells. */
    bool (*touches)(const struct lx_emitter *emitter, lx_bounded3 place_mm);
    /* The closed form of the irradiance by the law 1/r^2, with its bound, of an element that it does not touch. */
    lx_bounded (*irradiance)(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal);
    /* Appends points that stand for parts of it, as lx_extended_cut() says. */
    int (*cut)(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters);
    /* How far it comes along a direction from a place, and from where on. */
    double (*extent)(const struct lx_emitter *emitter, const double place_mm[3], const double direction[3],
                     double *nearest);
    /* Its place that is farthest in a direction. */
    void (*farthest)(const struct lx_emitter *emitter, const double towards[3], double place_mm[3]);
    /* A place in the plane of a flat one and the normal of the side that shines; NULL or false: it is a body. */
    bool (*plane)(const struct lx_emitter *emitter, double place_mm[3], double normal[3]);
};

/* The descriptors by type. */
extern const struct lx_emitter_kind *const lx_emitter_kinds[LX_EMITTER_TYPES];

static inline const struct lx_emitter_kind *lx_emitter_kind(const struct lx_emitter *emitter)
{
    return lx_emitter_kinds[emitter->type];
}

#endif

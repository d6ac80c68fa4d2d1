/* SPDX-License-Identifier: MIT */
/*
 * The plan of a picture: for each surface the emitters as constants of the kernels, each with the precision
 * that it needs and the surfaces that may stand in its light.
 *
 * A picture in float32 must lie within 2e-6 of its maximum from the exact one.  Most lights keep that in
 * float32 arithmetic; a light very near to the surface, a narrow cone, a very sharp highlight, a picture that
 * sees only the faint rim of a lit side do not, and are computed in float64.  Which is decided here from an
 * a-priori bound of each light's rounding error and from a lower bound of the picture's maximum, before any
 * pixel is computed; so a pixel's value depends on the scene and the pixel alone.  The highlights of extended sources
 * are sums over samples; how many is decided for runs of pixels, so that they depend on the block of pixels as well.
 * So do the values where an error of the light is allowed: how many points are clustered is decided for tiles (cut.h).
 */
#ifndef LX_PICTURE_PLAN_H
#define LX_PICTURE_PLAN_H

#include <float.h>

#include <luxel/render.h>

#include "../base/rows.h"
#include "../world/prepared.h"
#include "cluster/bound.h"
#include "cluster/tree.h"
#include "lights.h"
#include "polynomial/smooth_plan.h"
#include "precision.h"
#include "sampling.h"

/* Lights that follow each other, of one kind and precision, and with the same surfaces that may stand in their way. */
struct lx_light_run {
    size_t first, count;
    enum lx_kernel_light kind;
    bool has_edges;
    bool in_double;
    size_t blocker_first, blocker_count; /* in the surface's list */
};

/* An extended emitter over a surface. */
struct lx_planned_area_light {
    const struct lx_emitter *emitter;
    struct lx_area_light lamp;
    bool in_single;     /* its law, other than 1/r^2, is good enough in float32 */
    bool by_reference;  /* its diffuse light, as float64 would not keep the picture's accuracy */
    uint32_t *blockers; /* which surfaces may hide a part of it (penumbra.h) */
    size_t blocker_count;
};

struct lx_planned_surface {
    struct lx_shape shape;
    struct lx_lobe lobe;
    double low_mm[3], high_mm[3]; /* its extent, and what rounding cannot tell from it */
    struct lx_lobe_single lobe_single;
    struct lx_lobe_double lobe_exact;
    double uniform;            /* brightness by all uniform emitters together */
    struct lx_lights lights;   /* that are not clustered */
    struct lx_light_run *runs; /* of all of them */
    size_t run_count, run_capacity;
    uint32_t *blockers; /* which surfaces */
    size_t blocker_count, blocker_capacity;
    struct lx_rounding_sum rounding; /* of those in float32 */
    struct lx_lobe_limits limits;
    struct lx_planned_area_light *area_lights;
    struct lx_sampled *glossy;                           /* all of them, where there is a highlight */
    size_t area_light_count, glossy_count, by_law_count; /* by_law: that shine by laws other than 1/r^2 */
    struct lx_planned_area_light *openings;              /* of luminaires, which are among neither (openings.h) */
    size_t opening_count;
    struct lx_lobe_single glossy_single; /* the lobe's two parts */
    struct lx_lobe_double glossy_exact, matte_exact;
    struct lx_smooth smooth;
    bool by_reference; /* kernels do not know its lobe, or there are mirrors: there is nothing of it but what stands
                        * before the lights */
};

struct lx_plan {
    const struct lx_prepared *prepared; /* the scene in the frame of its screen: */
    struct lx_prepared *carried;        /* it was carried there; NULL: it is as it was prepared */
    const struct lx_kernels *kernels;
    struct lx_planned_surface *surfaces;
    struct lx_ball *balls; /* around them, from the origin, side by side */
    size_t surface_count;
    struct lx_boxes on_screen; /* over where many of them may be seen, with z = 0 */
    /* The only surface that the picture may show, if its light takes nothing but its elements in float32 (seen.h);
     * NULL: there is none. */
    const struct lx_planned_surface *alone;
    bool asks_reference; /* some surface is summed by the reference */
    bool at_once;        /* it is there, and has few lights of one kind, whose sum is the value */
    bool in_panels;      /* the whole picture is shaded by panels (panels.h), with: */
    struct lx_basis bases[LX_BASES], gloss_bases[LX_GLOSS_BASES], table_bases[LX_TABLE_BASES];
    bool has_gloss; /* highlights of extended sources have polynomials of their own */
    luxel_precision precision;
    double tolerance;             /* of the highlights of extended sources, relative to the picture's maximum */
    double least_maximum;         /* which is no less than this */
    double part_tolerance;        /* of the diffuse light of openings and of hidden parts, relative to the same */
    size_t most_patches;          /* of the extended sources together */
    struct lx_gauss_rules *rules; /* for laws other than 1/r^2; NULL where there are none */
    bool has_openings;
    struct lx_gauss_rules *node_rules;    /* the same at the nodes of squares, which polynomials make more of */
    struct lx_light_trees trees;          /* the points that are clustered */
    double light_error; /* how wrong they may make a pixel, relative to the larger of its value and: */
    double least_value;
    size_t every; /* of the lights only each such one is summed: for a look at many */
};

/* How exact highlights and clusters are while the maximum is looked for. */
#define LX_ROUGH 0.1

/* No picture shows what is smaller: the least number above 0, in float64 the least that has all its digits. */
static inline double lx_least_of(luxel_precision precision)
{
    return precision == LUXEL_SINGLE ? (double)FLT_TRUE_MIN : DBL_MIN;
}

/* Whether an extended emitter is set into a flat surface, as a lamp into a ceiling, and reaches to its plane but for
 * what rounding does: then nothing of it arrives there, but for a highlight that counts below the horizon, too. */
bool lx_is_set_in(const struct lx_planned_surface *surface, const struct lx_emitter *emitter);

#endif

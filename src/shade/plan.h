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
 */
#ifndef LX_SHADE_PLAN_H
#define LX_SHADE_PLAN_H

#include "kernel.h"
#include "prepared.h"
#include "sampling.h"

struct lx_planned_light {
    bool in_double;
    double bound;                /* of the absolute error in float32; infinite where float32 must not be used */
    double relative;             /* and of its error relative to the light's own share */
    struct lx_blocker *blockers; /* surfaces that may stand in its light */
    size_t blocker_count;
};

/* Lights that a kernel takes together: consecutive ones of one kind and precision.  Without blockers, or alone. */
struct lx_light_run {
    size_t first, count;
    bool in_double;
};

/* An extended emitter over a surface. */
struct lx_planned_shell {
    const struct lx_emitter *emitter;
    struct lx_shell shell;
};

struct lx_planned_surface {
    struct lx_shape shape;
    struct lx_lobe lobe;
    double low_mm[3], high_mm[3]; /* its extent, and what rounding cannot tell from it */
    struct lx_lobe_single lobe_single;
    struct lx_lobe_double lobe_exact;
    double uniform; /* brightness by all uniform emitters together */
    struct lx_planned_light *lights;
    struct lx_light_single *singles; /* their constants for the kernels, in either precision */
    struct lx_light_double *exacts;
    size_t light_count;
    struct lx_light_run *runs; /* of all of them */
    size_t run_count;
    struct lx_planned_shell *shells;
    struct lx_sampled *glossy; /* all of them for the highlight */
    struct lx_sampled *matte;  /* those by laws other than 1/r^2, for the diffuse part */
    size_t shell_count, matte_count;
    struct lx_lobe_single glossy_single, matte_single; /* the lobe's two parts */
    struct lx_lobe_double glossy_exact, matte_exact;
};

struct lx_plan {
    const struct lx_prepared *prepared;
    const struct lx_kernels *kernels;
    struct lx_planned_surface *surfaces;
    size_t surface_count;
    luxel_precision precision;
    double tolerance;     /* of the highlights of extended sources, relative to the picture's maximum */
    double least_maximum; /* which is no less than this */
    size_t most_patches;  /* of the extended sources together */
};

/* tolerance: as in struct lx_plan; 0: the usual one.  0, or -1 when memory ran out.  Release with lx_plan_clear() in
 * either case. */
int lx_plan_make(const struct lx_prepared *prepared, const struct lx_kernels *kernels, luxel_quantity quantity,
                 luxel_precision precision, double tolerance, struct lx_plan *plan);
void lx_plan_clear(struct lx_plan *plan);

#endif

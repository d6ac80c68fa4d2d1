/* SPDX-License-Identifier: MIT */
/*
 * The plan of a picture: for each surface the emitters as constants of the kernels, each with the precision
 * that it needs and the surfaces that may stand in its light.
 *
 * A picture in float32 must lie within 2e-6 of its maximum from the exact one.  Most lights keep that in
 * float32 arithmetic; a light very near to the surface, a narrow cone, a very sharp highlight, a picture that
 * sees only the faint rim of a lit side do not, and are computed in float64.  Which is decided here from an
 * a-priori bound of each light's rounding error and from a lower bound of the picture's maximum, before any
 * pixel is computed; so a pixel's value depends on the scene and the pixel alone.
 */
#ifndef LX_SHADE_PLAN_H
#define LX_SHADE_PLAN_H

#include "kernel.h"
#include "prepared.h"

struct lx_planned_light {
    bool in_double;
    double bound;    /* of the absolute error in float32; infinite where float32 must not be used */
    double relative; /* and of its error relative to the light's own share */
    struct lx_light_single single;
    struct lx_light_double exact;
    struct lx_blocker *blockers; /* surfaces that may stand in its light */
    size_t blocker_count;
};

struct lx_planned_surface {
    struct lx_shape shape;
    double low_mm[3], high_mm[3]; /* its extent */
    struct lx_lobe_single lobe_single;
    struct lx_lobe_double lobe_exact;
    double uniform; /* brightness by all uniform emitters together */
    struct lx_planned_light *lights;
    size_t light_count;
};

struct lx_plan {
    const struct lx_prepared *prepared;
    const struct lx_kernels *kernels;
    struct lx_planned_surface *surfaces;
    size_t surface_count;
};

/* 0, or -1 when memory ran out.  Release with lx_plan_clear() in either case. */
int lx_plan_make(const struct lx_prepared *prepared, const struct lx_kernels *kernels, luxel_quantity quantity,
                 luxel_precision precision, struct lx_plan *plan);
void lx_plan_clear(struct lx_plan *plan);

#endif

/* SPDX-License-Identifier: MIT */
/* How exact a light would be in float32, and which lights of a plan are therefore computed in float64. */
#ifndef LX_PICTURE_PRECISION_H
#define LX_PICTURE_PRECISION_H

#include "../base/rows.h"
#include "../world/prepared.h"
#include "lights.h"

struct lx_area_light;

/* The sum of the rounding errors, and that of their squares, of what is in float32. */
struct lx_rounding_sum {
    double sum, squares;
};

/* How a light stands to some elements. */
struct lx_stand {
    double nearest_mm; /* no element is nearer to it */
    double away_mm;    /* from the anchor of their surface; 0 for a direction */
    double least_half; /* of the lengths of L + V */
};

/* A bound of a light's error in float32; infinite where float32 must not be used. */
double lx_bound_light(const struct lx_prepared *prepared, const struct lx_shape *shape, const struct lx_lobe *lobe,
                      const struct lx_emitter *emitter);
/* That bound for an emitter of another strength that stands as `stand` says. */
double lx_bound_stand(const struct lx_shape *shape, const struct lx_lobe *lobe, const struct lx_emitter *emitter,
                      double strength, const struct lx_stand *stand);

/* A bound of the error of an area light's diffuse light in float32; infinite unless it is of facets. */
double lx_bound_area_light(const struct lx_shape *shape, double diffuse, const struct lx_area_light *lamp,
                           const struct lx_asking *asking);
/* A bound of the error in float64 of an area light of facets, for places that are exact. */
double lx_bound_area_light_double(const struct lx_shape *shape, double diffuse, const struct lx_area_light *lamp,
                                  const struct lx_asking *asking);

/* What the rules for laws other than 1/r^2 are made for in pictures of float32 and of float64, and at nodes of squares
 * (smooth.h). */
#define LX_SINGLE_RULES 1e-7
#define LX_DOUBLE_RULES 1e-14
#define LX_NODE_RULES 1e-9

/* No place of an area light is nearer to a shape than this; less than 0 where they may meet. */
double lx_gap(const struct lx_shape *shape, const struct lx_area_light *lamp, const struct lx_asking *asking);

/* A bound for the diffuse light of an area light by its own law, which rules sum; infinite for a ball: it has none. */
double lx_bound_law(const struct lx_shape *shape, double diffuse, const struct lx_area_light *lamp,
                    const struct lx_asking *asking);

/*
 * Leaves as many lights, which are all in float64, to float32 as the picture's accuracy allows, given a lower bound
 * of its maximum, and the rounding of other lights, to which theirs is added.  Their bounds become negative.  Returns
 * how many they are; fewer where the work is to stop.
 */
size_t lx_choose_precision(double *bounds, size_t count, double least_maximum, const struct lx_asking *asking,
                           struct lx_rounding_sum *rounding);

/* Whether float32 samples of an area light are good enough for a tolerance. */
bool lx_samples_fit_single(const struct lx_shape *shape, const struct lx_lobe_double *lobe,
                           const struct lx_area_light *lamp, double tolerance);

#endif

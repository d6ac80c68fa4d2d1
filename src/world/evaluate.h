/* SPDX-License-Identifier: MIT */
/* Exact values: what all lights together give at an element, by the reference, from a scene prepared once. */
#ifndef LX_WORLD_EVALUATE_H
#define LX_WORLD_EVALUATE_H

#include <luxel/evaluator.h>

#include "reference.h"

struct lx_kernels;

struct luxel_evaluator {
    const luxel_scene *scene;
    bool sees; /* the screen shows something (luxel_scene_check_view()) */
    luxel_settings settings;
    const struct lx_kernels *kernels;
    struct lx_prepared prepared;
    /* The reflected irradiance of an element, by who knows it; NULL: surfaces do not reflect. */
    lx_bounded (*reflected_at)(const struct luxel_evaluator *evaluator, const struct lx_element *element);
    void *reflected; /* what it knows it by */
};

/* What one light gives at an element. */
struct lx_share {
    lx_bounded irradiance, diffuse, specular;
    size_t parts;
};

/*
 * The share of the lights from *next on, which counts emitters; moves it behind this light's.  False: the light lies on
 * the element.
 */
bool lx_light_share(const struct lx_prepared *prepared, const struct lx_element *element, size_t light, size_t *next,
                    struct lx_share *share);

/* What a share adds to the value of a quantity. */
lx_bounded lx_share_value(const struct lx_share *share, luxel_quantity quantity);

/* What reflected light adds to it, of an irradiance. */
lx_bounded lx_reflected_value(const struct lx_lobe *lobe, luxel_quantity quantity, lx_bounded irradiance);

/* The error that is told of a number: infinite where the bound has left the range and so is none. */
double lx_told_error(lx_bounded number);

/* Whether a place is one that can be probed: its numbers finite, its directions not 0. */
bool lx_is_place(const luxel_place *place);

/* The free element at a place that is one. */
struct lx_element lx_free_element_at(const struct lx_prepared *prepared, const luxel_place *place);

/* What is seen through a point of the screen; false: nothing. */
bool lx_evaluator_sees(const struct luxel_evaluator *evaluator, double x_mm, double y_mm, struct lx_element *element);

/* The value of an element: sums its lights. */
luxel_value lx_evaluate_element(const struct luxel_evaluator *evaluator, const struct lx_element *element,
                                double *shares);

#endif

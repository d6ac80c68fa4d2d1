/* SPDX-License-Identifier: MIT */
/* Exact values: what all lights together give at elements, by the world, from a scene prepared once. */
#ifndef LX_WORLD_EVALUATE_H
#define LX_WORLD_EVALUATE_H

#include <luxel/evaluator.h>

#include "world.h"

/* A part of a value that is a sum: an evaluator of one channel of the materials, and what it counts for. */
struct lx_evaluator_part {
    struct luxel_evaluator *evaluator;
    double weight;
};

struct luxel_evaluator {
    const luxel_scene *scene;
    bool sees; /* the screen shows something (luxel_scene_check_view()) */
    luxel_settings settings;
    struct lx_prepared prepared;
    struct lx_world world;           /* of it */
    struct lx_evaluator_part *parts; /* whose values add up to its own; it has only the places then */
    size_t part_count;               /* 0: its values are those of its world */
    luxel_scene *view;               /* of a part: the scene in its channel, its own (colours.h) */
};

/* The question to a world for a value of a quantity. */
static inline enum lx_wanted lx_wanted_for(luxel_quantity quantity)
{
    return quantity == LUXEL_IRRADIANCE ? LX_WANT_IRRADIANCE : LX_WANT_BRIGHTNESS;
}

/* The direct part of the value of element i. */
lx_bounded lx_received_value(const struct lx_received *received, luxel_quantity quantity, size_t i);

/* What reflected light adds to it, of an irradiance. */
lx_bounded lx_reflected_value(const struct lx_lobe *lobe, luxel_quantity quantity, lx_bounded irradiance);

/* A number as it is told: with an infinite error where the bound has left the range and so is none. */
lx_bounded lx_reported(lx_bounded number);

/* Whether a place is one that can be probed: its numbers finite, its directions not 0, its reserve NULL. */
bool lx_is_place(const luxel_place *place);

/* What is seen through a point of the screen; false: nothing. */
bool lx_evaluator_sees(const struct luxel_evaluator *evaluator, double x_mm, double y_mm, struct lx_element *element);

/* Values of the elements of a batch, and their shares of each light, side by side (NULL: not wanted): those of element
 * i stand at place of[i]. */
void lx_evaluate_elements(const struct luxel_evaluator *evaluator, const struct lx_elements *elements,
                          const struct lx_asking *asking, const size_t *of, luxel_value *values, double *shares);

/* The value of an element: sums its lights. */
luxel_value lx_evaluate_element(const struct luxel_evaluator *evaluator, const struct lx_element *element,
                                double *shares);

#endif

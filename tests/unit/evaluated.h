/* SPDX-License-Identifier: MIT */
/* Values that evaluators give, as expressions; and how far two places are apart. */
#ifndef TESTS_UNIT_EVALUATED_H
#define TESTS_UNIT_EVALUATED_H

#include <math.h>
#include <string.h>

#include <luxel/evaluator.h>

/* The value seen at a point of the screen. */
static inline luxel_value value_seen(const luxel_evaluator *evaluator, double x_mm, double y_mm)
{
    luxel_value value;
    luxel_evaluate_screen(evaluator, x_mm, y_mm, &value, NULL);
    return value;
}

/* The value of the element at a place with a normal. */
static inline luxel_value value_on(const luxel_evaluator *evaluator, const double position_mm[3],
                                   const double normal[3])
{
    luxel_place place = {.is_element = true};
    luxel_value value;
    memcpy(place.position_mm, position_mm, sizeof place.position_mm);
    memcpy(place.normal, normal, sizeof place.normal);
    luxel_evaluate_place(evaluator, &place, &value, NULL);
    return value;
}

static inline double distance_of(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

#endif

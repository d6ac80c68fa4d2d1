/* SPDX-License-Identifier: MIT */
/*
 * Evaluators: a scene prepared once for many exact values, where a probe would prepare it anew each time.
 *
 * An evaluator gives at any place the number that luxel_probe_places() gives there, to the last bit.  It
 * is what extrema, isophotes and profiles are found with, and what a front end keeps while the pointer moves.
 *
 * The scene must outlive the evaluator and must not be changed while it lives.
 */
#ifndef LUXEL_EVALUATOR_H
#define LUXEL_EVALUATOR_H

#include <luxel/probe.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A scene prepared for exact values of one quantity; the caller's, freed with luxel_evaluator_free(). */
typedef struct luxel_evaluator luxel_evaluator;

/* What is found at one place. */
typedef struct luxel_value {
    bool on_surface;       /* whether a surface is seen there; without one all else is 0 */
    bool has_value;        /* false where a source lies on the element */
    unsigned part;         /* of a room the wall, of a box the side (luxel_scene_part_name()); else 0 */
    size_t surface;        /* its index in the scene's list */
    double position_mm[3]; /* the place on it */
    double normal[3];      /* its unit normal there */
    double value;          /* the exact value, in the unit of luxel_scene_unit() */
    double error;          /* bounds |value - truth| */
    void *reserved[2];     /* for later versions: NULL */
} luxel_value;

/*
 * Prepares a committed scene for the settings' quantity and tolerance; `settings` NULL: the defaults.
 * Errors as luxel_render() lists them.
 */
LUXEL_API luxel_status luxel_evaluator_new(const luxel_scene *scene, const luxel_settings *settings,
                                           luxel_diagnostics *diagnostics, luxel_evaluator **evaluator);

/* Frees an evaluator; NULL is harmless. */
LUXEL_API void luxel_evaluator_free(luxel_evaluator *evaluator);

/* The quantity whose values it gives. */
LUXEL_API luxel_quantity luxel_evaluator_quantity(const luxel_evaluator *evaluator);

/*
 * Whether its values are integrals over the areas of lights: each then takes some tenths of a millisecond up to several
 * milliseconds where it is exact, thousands of times what a pixel does.
 */
LUXEL_API bool luxel_evaluator_integrates(const luxel_evaluator *evaluator);

/* The number of lights of the scene, whether they are enabled or not. */
LUXEL_API size_t luxel_evaluator_light_count(const luxel_evaluator *evaluator);

/*
 * The place that is seen through a screen point, which may lie off the screen.  Nothing is evaluated there, so it costs
 * little: has_value is false.
 */
LUXEL_API void luxel_trace_screen(const luxel_evaluator *evaluator, double x_mm, double y_mm, luxel_value *value);

/*
 * The value seen through a screen point, which may lie off the screen.  `shares` NULL, or room for a number for each
 * light of the scene: what each gives of the value, 0 where there is none.
 */
LUXEL_API void luxel_evaluate_screen(const luxel_evaluator *evaluator, double x_mm, double y_mm, luxel_value *value,
                                     double *shares);

/*
 * The value at a place, the number that luxel_probe_places() gives there: of a free element `surface` of the answer
 * tells whose material counts.  on_surface is false, too, where the place is none that could be probed.
 */
LUXEL_API void luxel_evaluate_place(const luxel_evaluator *evaluator, const luxel_place *place, luxel_value *value,
                                    double *shares);

/*
 * The values at `count` places by several threads, as many as the evaluator's settings say: each is what
 * luxel_evaluate_place() gives there, to the last bit.  `values` has room for `count` of them, `shares`, unless it is
 * NULL, for as many rows of a number for each light of the scene.  Progress is that of the evaluator's settings, so two
 * threads should not call this at once with an evaluator that has some.
 * LUXEL_ERROR_ARGUMENT: a pointer is missing.  LUXEL_CANCELLED: progress said so, and not all values are there.
 */
LUXEL_API luxel_status luxel_evaluate_places(const luxel_evaluator *evaluator, const luxel_place *places, size_t count,
                                             luxel_value *values, double *shares);

/*
 * Puts places back that rounding took off a surface.  A place that was computed in float32, or from a depth map, lies
 * some of its last digits above or below the surface it is meant for, and below it nothing lights it.  Each element
 * (is_element) that is no farther from a surface than its number of `tolerances_mm` is moved onto it along its normal,
 * and has its material from then on; what lies on a surface as far as float64 tells is left, as are screen points.
 * `moved_mm` NULL, or room for how far each was moved.  By threads and progress as luxel_evaluate_places().
 */
LUXEL_API luxel_status luxel_evaluator_settle_places(const luxel_evaluator *evaluator, luxel_place *places,
                                                     size_t count, const double *tolerances_mm, double *moved_mm);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/*
 * Derivatives: how a value changes with what the scene says, such as the position of a lamp or a material's shininess.
 *
 * A derivative is by the key's own unit in the scene's text: mm, degrees, W/sr.  Light of points, directions and from
 * everywhere has it by the rules of differentiation, at each place for all keys at once; its error is a bound, but for
 * that of how the scene's constants change with a key, which is an estimate.
 * Other light has it from exact values of changed scenes, by central differences of shrinking steps that are
 * extrapolated to step 0 (Richardson), so whatever can be probed can be derived: shadows, area lights, reflected light.
 * Its error is what the values' own bounds make of it, added to twice how far the extrapolations still differ: an
 * honest estimate, no proof.
 *
 * A place of the screen stays where it is on the screen: where a surface moves, so does the element that is seen.
 *
 * Threads as luxel.h says.
 */
#ifndef LUXEL_DERIVE_H
#define LUXEL_DERIVE_H

#include <luxel/probe.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Whether there is a derivative. */
typedef enum luxel_derivative_state {
    LUXEL_DERIVATIVE_EXISTS,    /* from both sides */
    LUXEL_DERIVATIVE_ONE_SIDED, /* from one side, as the key's value is the least or greatest legal one */
    LUXEL_DERIVATIVE_NO_VALUE,  /* none: the place has no value in this scene, or not beside it */
    LUXEL_DERIVATIVE_KINK,      /* none: the value turns sharply here, as at the border of what a lamp reaches */
    LUXEL_DERIVATIVE_ROUGH      /* none: the value jumps here, as at the border of a hard shadow, or is not known well
                                 * enough for its change to be told */
} luxel_derivative_state;

/* A derivative of the value at one place by one number of one key. */
typedef struct luxel_derivative {
    luxel_derivative_state state; /* whether there is one */
    double value;                 /* in the value's unit per that of the key; NaN where there is none */
    double error;                 /* about how far it may be off; NaN where there is none */
} luxel_derivative;

/* Derivatives at many places by many keys; made by luxel_derive_places(). */
typedef struct luxel_derivatives luxel_derivatives;

/*
 * Derives the values at `count` places by `key_count` keys, which are paths such as lights[0].position or
 * surfaces[0].material.shininess of keys that take a number or numbers; lights[*].intensity means all elements of the
 * list that have one, changed by as much, so that theirs add up.  settings->tolerance 0 is 1e-11 here.  `probes`
 * are what luxel_probe_places() tells of these places, so that their values are taken from there, or NULL.
 * *derivatives is the caller's: free it with luxel_derivatives_free().  Where differences are taken each number of a
 * key takes 4 to some 16 values of every place, of scenes that are prepared once for all of them.  Without places the
 * keys alone are checked.  Progress and cancelling as of luxel_render().
 * LUXEL_ERROR_PATH: keys that do not exist, have no value in this scene, or take no numbers; all of them are reported.
 * LUXEL_ERROR_SCENE: there are points of the screen, and the scene shows nothing there (luxel_scene_check_view()).
 * Else errors as luxel_evaluator_new(), and where light is reflected as luxel_probe_places().
 */
LUXEL_API luxel_status luxel_derive_places(const luxel_scene *scene, const luxel_settings *settings,
                                           const luxel_place *places, const luxel_probes *probes, size_t count,
                                           const char *const *keys, size_t key_count, luxel_diagnostics *diagnostics,
                                           luxel_derivatives **derivatives);

/*
 * Derives the values of the i-th grid as luxel_find_grid_values() measures them: its cells are the places, row by row,
 * and move with the grid.  A cell whose number changes beside this scene has no derivative, as a rule of spacing makes
 * of the grid's size.
 * LUXEL_ERROR_ARGUMENT: there is no such grid.  Else as luxel_derive_places() and luxel_find_grid_values().
 */
LUXEL_API luxel_status luxel_derive_grid(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                         const char *const *keys, size_t key_count, luxel_diagnostics *diagnostics,
                                         luxel_derivatives **derivatives);

/* The value at a place, with its bound; false: it has none. */
LUXEL_API bool luxel_derivatives_value(const luxel_derivatives *derivatives, size_t place, luxel_bounded *value);
/* How many numbers the i-th key takes: 3 of a position.  0 beyond the last key. */
LUXEL_API size_t luxel_derivatives_numbers(const luxel_derivatives *derivatives, size_t key);
/* The unit of the i-th key in UTF-8, "" where it has none; NULL beyond the last. */
LUXEL_API const char *luxel_derivatives_unit(const luxel_derivatives *derivatives, size_t key);
/* The derivative at a place by a number of a key, which lives as long as all of them; NULL beyond the last. */
LUXEL_API const luxel_derivative *luxel_derivatives_get(const luxel_derivatives *derivatives, size_t place, size_t key,
                                                        size_t number);
/* A state in words, "the value has a kink here", or NULL where there is a derivative. */
LUXEL_API const char *luxel_derivative_words(luxel_derivative_state state);
/* Frees derivatives; NULL is harmless. */
LUXEL_API void luxel_derivatives_free(luxel_derivatives *derivatives);

#ifdef __cplusplus
}
#endif
#endif

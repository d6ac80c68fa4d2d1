/* SPDX-License-Identifier: MIT */
/*
 * Alternatives: the value that each other convention would give at a point, so that two people whose numbers differ can
 * see which choice makes the difference.
 *
 * An alternative changes one convention of the scene (the place that is evaluated, the view vector, 1/pi, the
 * highlight, the law of attenuation, the pattern of the sources, the model, the projection, the sampling) and leaves
 * all else as it is.  Of a scene with reflections the alternatives are only how often light is reflected: not at all,
 * once, as often as the scene says, until nothing is left.
 */
#ifndef LUXEL_ALTERNATIVES_H
#define LUXEL_ALTERNATIVES_H

#include <luxel/probe.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One choice of a convention and what it gives. */
typedef struct luxel_alternative {
    const char *convention; /* such as "place" or "highlight"; English words for a front end to translate */
    const char *choice;     /* such as "pixel" or "gated" */
    const char *meaning;    /* one line, English, to translate */
    const char *assignment; /* what makes it with luxel_scene_set(), such as "surfaces[0].material.over_pi=true";
                               NULL where it is no key of the scene (the place) */
    bool is_present;        /* whether it is what the scene says, and the value the scene's own */
    bool has_value;         /* false where it does not give any, such as off every surface */
    double value;           /* in the unit of luxel_scene_unit() */
    double error;           /* bounds |value - truth|, rounding included */
    void *reserved[4];      /* for later versions: NULL */
} luxel_alternative;

/*
 * All of them, convention by convention, the present choice first in each; none is the present one where surfaces or
 * lights differ in a convention.  Its arrays and texts live as long as it.
 */
typedef struct luxel_alternatives {
    size_t count;                  /* of the list */
    const luxel_alternative *list; /* count of them */
} luxel_alternatives;

/*
 * Finds the alternatives at a point of the screen.  The result is the caller's.  `settings` NULL: the defaults.
 * Errors as luxel_probe_screen().
 */
LUXEL_API luxel_status luxel_find_alternatives(const luxel_scene *scene, const luxel_settings *settings, double x_mm,
                                               double y_mm, luxel_diagnostics *diagnostics,
                                               luxel_alternatives **alternatives);

/* Frees alternatives; NULL is harmless. */
LUXEL_API void luxel_alternatives_free(luxel_alternatives *alternatives);

#ifdef __cplusplus
}
#endif
#endif

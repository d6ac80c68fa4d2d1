/* SPDX-License-Identifier: MIT */
/* Alternatives under way: the choices that a scene has at a point, and the value of one or two of them together. */
#ifndef LX_EXERCISE_ALTERNATIVES_H
#define LX_EXERCISE_ALTERNATIVES_H

#include <luxel/alternatives.h>

enum { LX_MOST_CHOICES = 32 };

/* Where the scene is looked at. */
enum lx_looked_at {
    LX_AT_POINT,      /* the point itself */
    LX_AT_PIXEL,      /* the sample of the pixel that it falls in */
    LX_AT_FLIPPED,    /* the sample of that pixel's mirror image, as rows counted from the other end give */
    LX_AT_OTHER_PIXEL /* the sample of the pixel that it falls in by the other sampling */
};

/* A choice: what it is called, and what it does to the scene. */
struct lx_choice {
    const char *convention, *choice, *meaning;
    char *assignment; /* those that make it, with " -s " between them; NULL: none, it is a place */
    enum lx_looked_at place;
    bool is_bounces; /* says how often light is reflected */
    bool is_present;
};

struct lx_choices {
    const luxel_scene *scene;
    luxel_scene *lit; /* that scene, where it was made for a group of lights; else NULL */
    luxel_settings settings;
    double x_mm, y_mm;
    struct lx_choice list[LX_MOST_CHOICES];
    size_t count;
    bool has_bounces; /* the scene reflects light */
};

/* No value: off every surface, off the screen, or where the scene does not allow the choices. */
struct lx_choice_value {
    bool has_value;
    double value, error;
};

/* Finds the choices of a committed scene.  lx_choices_clear() is due whatever it returns.  LUXEL_ERROR_MEMORY. */
luxel_status lx_choices_find(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                             luxel_diagnostics *diagnostics, struct lx_choices *choices);
void lx_choices_clear(struct lx_choices *choices);

/*
 * The value that `count` choices together give; of one convention only one.
 * LUXEL_ERROR_MEMORY, or what a probe of the scene ends with.
 */
luxel_status lx_choices_value(const struct lx_choices *choices, const size_t *which, size_t count,
                              luxel_diagnostics *diagnostics, struct lx_choice_value *found);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * The core of the page keeps one scene that is whole, the last that was; what the page asks is about that one.  Texts
 * of the page come as bytes in memory that page_memory() gave, and what the core answers lives until its next answer.
 */
#ifndef WEB_CORE_H
#define WEB_CORE_H

#include <luxel/luxel.h>

struct core {
    luxel_scene *scene;             /* NULL: none was whole yet */
    luxel_scene *direct;            /* the same without reflected light; NULL: not asked for yet */
    luxel_evaluator *evaluator;     /* of the scene and the quantity; NULL: not asked for yet */
    luxel_evaluator *lit;           /* of the scene and the irradiance; NULL: not asked for yet */
    luxel_field *field;             /* the picture that was computed last, by the view; NULL: none */
    luxel_diagnostics *diagnostics; /* of the last call that can fail */
    luxel_quantity quantity;
    luxel_color_view view; /* of pictures in colour */
    bool is_direct;        /* only direct light is computed, whatever the scene says */
    double within;         /* seconds for a solution of reflected light; 0: without end */
    /* The package for npm: what it asks has a solution of reflected light of its own, as the tool's, and these settings
     * of luxel_settings. */
    bool is_package;
    double tolerance, light_error, reflected_error;
};

extern struct core core;

/* Empties what the last call reported, and gives the list for the next one. */
luxel_diagnostics *fresh_diagnostics(void);

/* The scene that is computed: the present one, or that without reflected light; NULL: there is none. */
const luxel_scene *computed_scene(void);

/* The evaluator of the present scene and quantity, or NULL. */
const luxel_evaluator *present_evaluator(void);

/* Drops what was made for the scene and the settings that were. */
void drop_evaluator(void);

/* Drops what another camera saw of the scene that was. */
void drop_stage(void);

/* Answers with the value through a point of an evaluator's screen and each light's share of it; NULL: there is none. */
const char *answer_probe(const luxel_evaluator *evaluator, double x_mm, double y_mm);

/* A member "limits" of an answer: limits and whether they are kept. */
void answer_limits(const luxel_limit *limits, size_t count);

/* Limits of the scene's i-th grid, which was measured, and of the areas around it. */
void answer_grid_limits(const luxel_scene *scene, size_t i, const luxel_grid *grid);

/* A picture as the present view has it, in its place. */
luxel_field *viewed(luxel_field *field);

/* The default settings with the present quantity, and the page's progress. */
luxel_settings present_settings(void);

#endif

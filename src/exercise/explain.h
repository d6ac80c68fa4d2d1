/* SPDX-License-Identifier: MIT */
/* The formulas of a scene, in general and with the numbers of one point put in. */
#ifndef LX_EXERCISE_EXPLAIN_H
#define LX_EXERCISE_EXPLAIN_H

#include <luxel/probe.h>

#include "../document/document.h"
#include "../world/reference.h"

/* The formulas of just the conventions that a scene uses, without numbers: place, normal, view, lights, material. */
void lx_explain_model(struct luxel_document *document, const struct lx_prepared *prepared, luxel_quantity quantity);

/*
 * Adds notation with what its marks stand for, one argument each: # for a number (7 digits, 1.2e-7 as
 * 1.2\cdot 10^{-7}), ! for one that stands in brackets where it is negative, as factors do, @ for a vector (const
 * lx_bounded3 *), $ for further notation without marks.  A formula is made in parts and then ended, or shown at once.
 */
void lx_add_notation(struct lx_text *text, const char *notation, ...);
void lx_end_formula(struct luxel_document *document, struct lx_text *text);
void lx_show_formula(struct luxel_document *document, const char *notation, ...);

/* One point, step by step. */
struct lx_steps {
    struct luxel_document *document;
    const struct lx_prepared *prepared;
    const struct lx_element *element;
    luxel_quantity quantity;
    const luxel_scene *scene; /* that was prepared */
};

void lx_explain_place(const struct lx_steps *steps, double x_mm, double y_mm);
/* The share of one light of the probe. */
void lx_explain_light(const struct lx_steps *steps, const luxel_light_share *share);
/* Which surfaces hide how much of a light of so many emitters, if any do. */
void lx_explain_shadows(const struct lx_steps *steps, const luxel_light_share *share, size_t emitters);

/* In a scene in colour: what the steps of lights leave out; the channels of a light, of its parts in white and of its
 * share in colour; their sum, and the colour of that. */
void lx_explain_color_rule(const struct lx_steps *steps);
void lx_explain_light_color(const struct lx_steps *steps, const luxel_light_share *white,
                            const luxel_light_share *share);
void lx_explain_color(const struct lx_steps *steps, const luxel_probe *probe, bool shows_terms);

#endif

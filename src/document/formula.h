/* SPDX-License-Identifier: MIT */
/*
 * Formulas, written in a small part of LaTeX's notation and put out as Unicode in one line, as MathML, or as boxes that
 * a canvas draws.  LaTeX takes the notation as it is.
 *
 * The notation: letters (italic), numbers, + - = < > ( ) [ ] | , / and spaces as LaTeX has them; a_{b}, a^{b},
 * \frac{a}{b}, \sqrt{a}, \sum_{i=1}^{n}, \left( \right) and \left| \right|, \mathbf{a} (vectors), \mathrm{a} (upright),
 * \text{words}, \vec{a}, \hat{a}, \dot products \cdot and \times, \le \ge \ne \approx \pm \to \infty \degree,
 * \max \min \cos \sin \log \exp \arctan, Greek letters, \qquad \quad \, and \\ with & for lines of an aligned whole.
 */
#ifndef LX_DOCUMENT_FORMULA_H
#define LX_DOCUMENT_FORMULA_H

#include <stdbool.h>
#include <stddef.h>

#include "../base/text.h"

enum lx_formula_type {
    LX_FORMULA_ROW,      /* children side by side */
    LX_FORMULA_LETTER,   /* a variable: italic */
    LX_FORMULA_BOLD,     /* a vector: bold upright */
    LX_FORMULA_UPRIGHT,  /* names of functions, units */
    LX_FORMULA_NUMBER,   /* a number */
    LX_FORMULA_OPERATOR, /* a relation or an operation, with its space */
    LX_FORMULA_FENCE,    /* a bracket; `tall` where \left or \right made it */
    LX_FORMULA_WORDS,    /* \text{...} */
    LX_FORMULA_SPACE,    /* of `width` em */
    LX_FORMULA_FRACTION, /* children: above, below */
    LX_FORMULA_ROOT,     /* child: what is under it */
    LX_FORMULA_SCRIPTS,  /* children: base, below or NULL, above or NULL */
    LX_FORMULA_ACCENT,   /* child; `text` is the mark above it */
    LX_FORMULA_LINES     /* children: ROWs, one a line; a SPACE of width 0 marks where they are aligned */
};

struct lx_formula {
    enum lx_formula_type type;
    char *text; /* UTF-8 of what shows a sign */
    bool tall;
    double width;
    size_t count;
    struct lx_formula **children; /* some may be NULL */
};

/* The tree of a formula, or NULL: memory ran out, or it is not in the notation (then `at` tells where). */
struct lx_formula *lx_formula_parse(const char *notation, size_t *at);
void lx_formula_free(struct lx_formula *formula);

/* Adds the formula in one line of Unicode: "I / r²", "√(a + b)". */
void lx_formula_add_text(struct lx_text *text, const struct lx_formula *formula);
/* Adds MathML, without the math element around it. */
void lx_formula_add_mathml(struct lx_text *text, const struct lx_formula *formula);

#endif

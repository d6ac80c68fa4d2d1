/* SPDX-License-Identifier: MIT */
/*
 * Formulas, written in a small part of LaTeX's notation and put out as Unicode in one line, as MathML, or as boxes that
 * a canvas draws.  LaTeX takes the notation as it is.
 *
 * The notation: letters (italic), numbers, + - = < > ( ) [ ] | , . ; : ! ' / ⊥ ° and blanks, which mean nothing; a_{b},
 * a^{b}; \frac{a}{b}, \sqrt{a}; \sum and \int; \left( \right) with ( [ | or nothing (.) in pairs; \mathbf{a} (vectors),
 * \mathrm{a} (upright), \text{words}, the braces of which hold plain characters; \vec{a}, \hat{a}; \cdot \times \le \ge
 * \ne \approx \pm \to \infty \perp \degree \lfloor \rfloor; \max \min \cos \sin \tan \log \exp \arctan \arccos; Greek
 * letters; \qquad \quad \, \; and \% ; \\ parts the lines of a whole, each aligned at its &.
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
    char *text;        /* UTF-8 of what shows a sign */
    bool tall, closes; /* of a fence; whether it ends what it holds */
    double width;
    size_t count;
    struct lx_formula **children; /* some may be NULL */
};

/*
 * The tree of a formula, or NULL: it is not in the notation, then `at` (NULL: not wanted) tells where; or memory ran
 * out, then it is SIZE_MAX.
 */
struct lx_formula *lx_formula_parse(const char *notation, size_t *at);
void lx_formula_free(struct lx_formula *formula);

/* The sign that bears what stands below and above it; the formula itself where nothing does. */
const struct lx_formula *lx_formula_nucleus(const struct lx_formula *formula);
/* A bracket that opens or closes; | is neither. */
bool lx_formula_is_fence(const struct lx_formula *formula, bool closes);
/* cos, max with its scripts, mm: upright words, which stand apart from their neighbours. */
bool lx_formula_is_word(const struct lx_formula *formula);
bool lx_formula_is_comma(const struct lx_formula *formula);
/* Whether the i-th of a row is a sign rather than an operation: −a, (−2), = ±1. */
bool lx_formula_is_sign(const struct lx_formula *row, size_t i);

/* Adds the formula in one line of Unicode: "I / r²", "√(a + b)". */
void lx_formula_add_text(struct lx_text *text, const struct lx_formula *formula);
/* Adds MathML, without the math element around it. */
void lx_formula_add_mathml(struct lx_text *text, const struct lx_formula *formula);

#endif

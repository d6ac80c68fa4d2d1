/* SPDX-License-Identifier: MIT */
/* Formulas as boxes of letters, lines and shapes about a baseline, as books set them; drawn to a cairo context. */
#ifndef LX_FIGURE_FORMULA_BOX_H
#define LX_FIGURE_FORMULA_BOX_H

#include <pango/pangocairo.h>
#include <stdbool.h>

#include "../document/formula.h"

/* What formulas are set with: letters of a pango context, of a size in points. */
struct lx_formula_font {
    PangoContext *context;
    const char *families;
    double size;
};

struct lx_formula_item;

/* Lengths in points; `height` above and `depth` below the baseline, which begins at (0, 0). */
struct lx_formula_box {
    double width, height, depth;
    double overhang; /* of a slanting letter beyond its width */
    struct lx_formula_item *items;
    size_t count, capacity;
    bool failed; /* memory ran out */
};

void lx_formula_box_clear(struct lx_formula_box *box);

/* Draws a box with its baseline beginning at (x, y). */
void lx_formula_box_draw(cairo_t *cairo, const struct lx_formula_box *box, double x, double y);

/* A formula as it stands in a sentence, in parts that may stand on different lines; at least one. */
struct lx_formula_box *lx_formula_set_parts(const struct lx_formula_font *type, const struct lx_formula *formula,
                                            size_t *count);

/* A line of a formula that stands by itself. */
struct lx_formula_line {
    struct lx_formula_box box;
    double x;     /* where it begins in the width */
    double scale; /* less than 1 where nothing else makes it fit */
};

/* A formula that stands by itself, centred in a width, in as many lines as it needs. */
struct lx_formula_line *lx_formula_set_lines(const struct lx_formula_font *type, const struct lx_formula *formula,
                                             double width, size_t *count);

/* Both return NULL when memory is short; what they return is cleared box by box and freed with free(). */

#endif

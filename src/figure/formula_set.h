/* SPDX-License-Identifier: MIT */
/* What the parts of setting formulas share: boxes of parts, rows, lines, and the drawing of shapes. */
#ifndef LX_FIGURE_FORMULA_SET_H
#define LX_FIGURE_FORMULA_SET_H

#include "formula_box.h"

enum lx_formula_shape {
    LX_SHAPE_LETTERS,
    LX_SHAPE_RULE,
    LX_SHAPE_ROOT,
    LX_SHAPE_LEFT_ROUND,
    LX_SHAPE_RIGHT_ROUND,
    LX_SHAPE_LEFT_SQUARE,
    LX_SHAPE_RIGHT_SQUARE,
    LX_SHAPE_BAR,
    LX_SHAPE_ARROW,
    LX_SHAPE_HAT
};

/* Letters stand on their baseline at (x, y), shapes fill what is to the right of and below it. */
struct lx_formula_item {
    enum lx_formula_shape shape;
    double x, y, width, height, pen;
    PangoLayout *layout; /* of letters */
};

struct lx_setting {
    const struct lx_formula_font *type;
    double axis; /* in parts of the size */
    bool failed; /* memory ran out */
};

/* How a part is set: by itself or in a sentence, as what stands below or above something, and its size. */
struct lx_style {
    double size;
    bool display, script;
};

struct lx_setting lx_formula_setting(const struct lx_formula_font *type);

/* Sets a part into an empty box. */
void lx_formula_set(const struct lx_setting *setting, const struct lx_formula *formula, struct lx_style style,
                    struct lx_formula_box *box);

/* Sets those of a row from `first` to before `last`, with the space behind them if others follow. */
void lx_formula_set_range(const struct lx_setting *setting, const struct lx_formula *row, size_t first, size_t last,
                          struct lx_style style, struct lx_formula_box *box);

/* Sets one box behind another, which takes what it holds. */
void lx_formula_box_append(struct lx_formula_box *box, struct lx_formula_box *next, double space);

#endif

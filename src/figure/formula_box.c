/* SPDX-License-Identifier: MIT */
/* Boxes of formulas: how high things stand and how far apart, after the rules of TeX, in parts of the type's size. */
#include "formula_set.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

static const double RULE = 0.048; /* lines of fractions and roots */
static const double AXIS = 0.29;  /* of signs and fractions above the baseline, where the letters do not tell */

/* ---- boxes ---- */

void lx_formula_box_clear(struct lx_formula_box *box)
{
    for (size_t i = 0; i < box->count; i++)
        if (box->items[i].layout)
            g_object_unref(box->items[i].layout);
    free(box->items);
    *box = (struct lx_formula_box){0};
}

static struct lx_formula_item *add_item(struct lx_formula_box *box, enum lx_formula_shape shape)
{
    if (lx_reserve(&box->items, &box->capacity, box->count + 1, sizeof *box->items) < 0) {
        box->failed = true;
        return NULL;
    }
    struct lx_formula_item *item = &box->items[box->count++];
    *item = (struct lx_formula_item){.shape = shape};
    return item;
}

static void add_shape(struct lx_formula_box *box, enum lx_formula_shape shape, double x, double y, double width,
                      double height, double pen)
{
    struct lx_formula_item *item = add_item(box, shape);
    if (!item)
        return;
    item->x = x;
    item->y = y;
    item->width = width;
    item->height = height;
    item->pen = pen;
}

/* Takes what a box holds into another one, moved; y grows downwards. */
static void take_box(struct lx_formula_box *box, struct lx_formula_box *taken, double x, double y)
{
    box->height = fmax(box->height, taken->height - y);
    box->depth = fmax(box->depth, taken->depth + y);
    for (size_t i = 0; i < taken->count; i++) {
        struct lx_formula_item *item = add_item(box, taken->items[i].shape);
        if (!item)
            break;
        *item = taken->items[i];
        item->x += x;
        item->y += y;
        taken->items[i].layout = NULL; /* it has moved */
    }
    box->failed = box->failed || taken->failed;
    lx_formula_box_clear(taken);
}

/* ---- letters ---- */

static void set_letters(const struct lx_setting *setting, const char *text, bool italic, bool bold, double size,
                        struct lx_formula_box *box)
{
    PangoRectangle ink, logical;
    struct lx_formula_item *item = add_item(box, LX_SHAPE_LETTERS);
    if (!item)
        return;
    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family_static(font, setting->type->families);
    pango_font_description_set_absolute_size(font, size * PANGO_SCALE);
    pango_font_description_set_style(font, italic ? PANGO_STYLE_ITALIC : PANGO_STYLE_NORMAL);
    pango_font_description_set_weight(font, bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    item->layout = pango_layout_new(setting->type->context);
    pango_layout_set_font_description(item->layout, font);
    pango_layout_set_text(item->layout, text, -1);
    pango_font_description_free(font);
    pango_layout_line_get_extents(pango_layout_get_line_readonly(item->layout, 0), &ink, &logical);
    box->width = (double)logical.width / PANGO_SCALE;
    box->height = fmax(0, -(double)ink.y / PANGO_SCALE);
    box->depth = fmax(0, (double)(ink.y + ink.height) / PANGO_SCALE);
    double overhang = (double)(ink.x + ink.width - logical.width) / PANGO_SCALE;
    box->overhang = italic ? fmax(0, overhang) : 0;
}

/* How high above the baseline the line of a minus runs, where fractions have theirs. */
static double axis_of(struct lx_setting *setting)
{
    struct lx_formula_box box = {0};
    PangoRectangle ink;
    double axis = AXIS;
    set_letters(setting, "−", false, false, 100, &box);
    if (box.count > 0) {
        pango_layout_line_get_extents(pango_layout_get_line_readonly(box.items[0].layout, 0), &ink, NULL);
        axis = -((double)ink.y + (double)ink.height / 2) / PANGO_SCALE / 100;
    }
    setting->failed = box.failed;
    lx_formula_box_clear(&box);
    return axis > 0.15 && axis < 0.45 ? axis : AXIS;
}

struct lx_setting lx_formula_setting(const struct lx_formula_font *type)
{
    struct lx_setting setting = {.type = type, .axis = AXIS};
    setting.axis = axis_of(&setting);
    return setting;
}

/* ---- parts ---- */

static struct lx_style smaller(const struct lx_setting *setting, struct lx_style style)
{
    double least = setting->type->size * 0.55, size = style.size * 0.72;
    return (struct lx_style){.size = size > least ? size : least, .script = true};
}

/* A sum or an integral: larger than letters and centred on the axis. */
static void set_large(const struct lx_setting *setting, const char *text, struct lx_style style,
                      struct lx_formula_box *box)
{
    struct lx_formula_box sign = {0};
    set_letters(setting, text, false, false, style.size * (style.display ? 1.7 : 1.15), &sign);
    double middle = (sign.height - sign.depth) / 2, width = sign.width;
    take_box(box, &sign, 0, middle - setting->axis * style.size);
    box->width = width;
}

static void set_fraction(const struct lx_setting *setting, const struct lx_formula *formula, struct lx_style style,
                         struct lx_formula_box *box)
{
    struct lx_style inner = style.display ? (struct lx_style){.size = style.size} : smaller(setting, style);
    struct lx_formula_box above = {0}, below = {0};
    double em = style.size, pen = RULE * em, axis = setting->axis * em, gap = (style.display ? 0.2 : 0.1) * em;
    lx_formula_set(setting, formula->children[0], inner, &above);
    lx_formula_set(setting, formula->children[1], inner, &below);
    double width = fmax(above.width, below.width) + 0.16 * em, side = 0.07 * em;
    double up = fmax(axis + pen / 2 + gap + above.depth, (style.display ? 0.72 : 0.42) * em);
    double down = fmax(below.height + gap + pen / 2 - axis, (style.display ? 0.7 : 0.36) * em);
    double above_x = side + (width - above.width) / 2, below_x = side + (width - below.width) / 2;
    take_box(box, &above, above_x, -up);
    take_box(box, &below, below_x, down);
    add_shape(box, LX_SHAPE_RULE, side, -axis - pen / 2, width, pen, pen);
    box->width = width + 2 * side;
}

static void set_root(const struct lx_setting *setting, const struct lx_formula *formula, struct lx_style style,
                     struct lx_formula_box *box)
{
    struct lx_formula_box inner = {0};
    double em = style.size, pen = RULE * em, gap = (style.display ? 0.16 : 0.1) * em, sign = 0.62 * em;
    lx_formula_set(setting, formula->children[0], style, &inner);
    double height = fmax(inner.height, 0.62 * em) + gap + pen, depth = fmax(inner.depth, 0.12 * em);
    double width = inner.width + 0.08 * em;
    take_box(box, &inner, sign + 0.02 * em, 0);
    add_shape(box, LX_SHAPE_ROOT, 0, -height, sign, height + depth, pen);
    add_shape(box, LX_SHAPE_RULE, sign, -height, width, pen, pen);
    box->width = sign + width;
    box->height = height;
    box->depth = fmax(box->depth, depth);
}

/* A bracket about what lies so far above and below the axis; ordinary ones are letters. */
static void set_fence(const struct lx_setting *setting, const struct lx_formula *fence, struct lx_style style,
                      double reach, struct lx_formula_box *box)
{
    static const struct {
        const char *sign;
        enum lx_formula_shape shape;
    } shapes[] = {{"(", LX_SHAPE_LEFT_ROUND},
                  {")", LX_SHAPE_RIGHT_ROUND},
                  {"[", LX_SHAPE_LEFT_SQUARE},
                  {"]", LX_SHAPE_RIGHT_SQUARE},
                  {"|", LX_SHAPE_BAR}};
    double em = style.size, axis = setting->axis * em, pen = 0.072 * em;
    if (!*fence->text)
        return;
    if (reach <= 0.62 * em) {
        set_letters(setting, fence->text, false, false, em, box);
        return;
    }
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++)
        if (strcmp(shapes[i].sign, fence->text) == 0) {
            bool round = shapes[i].shape == LX_SHAPE_LEFT_ROUND || shapes[i].shape == LX_SHAPE_RIGHT_ROUND;
            bool bar = shapes[i].shape == LX_SHAPE_BAR;
            double width = bar ? pen : round ? fmin(0.24 * em + 0.06 * reach, 0.5 * em) : 0.2 * em;
            add_shape(box, shapes[i].shape, 0.08 * em, -axis - reach, width, 2 * reach, pen);
            box->width = width + 0.16 * em;
            box->height = axis + reach;
            box->depth = fmax(0, reach - axis);
        }
}

/* What \left and \right hold, between brackets as tall. */
static void set_fenced(const struct lx_setting *setting, const struct lx_formula *row, struct lx_style style,
                       struct lx_formula_box *box)
{
    struct lx_formula_box parts[3] = {{0}};
    double axis = setting->axis * style.size, x = 0;
    lx_formula_set(setting, row->children[1], style, &parts[1]);
    double reach = fmax(parts[1].height - axis, parts[1].depth + axis) + 0.04 * style.size;
    set_fence(setting, row->children[0], style, reach, &parts[0]);
    set_fence(setting, row->children[2], style, reach, &parts[2]);
    for (int i = 0; i < 3; i++) {
        double width = parts[i].width;
        take_box(box, &parts[i], x, 0);
        x += width;
    }
    box->width = x;
}

static bool is_large(const struct lx_formula *formula)
{
    return formula->type == LX_FORMULA_UPRIGHT && (strcmp(formula->text, "∑") == 0 || strcmp(formula->text, "∫") == 0);
}

/* Limits stand below and above a sum that stands by itself. */
static bool has_limits(const struct lx_formula *base)
{
    return base->type == LX_FORMULA_UPRIGHT &&
           (strcmp(base->text, "∑") == 0 || strcmp(base->text, "max") == 0 || strcmp(base->text, "min") == 0);
}

static void set_limits(const struct lx_setting *setting, const struct lx_formula *formula, struct lx_style style,
                       struct lx_formula_box *box)
{
    struct lx_formula_box parts[3] = {{0}};
    double width = 0, gap = 0.16 * style.size;
    for (int i = 0; i < 3; i++)
        if (formula->children[i]) {
            lx_formula_set(setting, formula->children[i], i == 0 ? style : smaller(setting, style), &parts[i]);
            width = fmax(width, parts[i].width);
        }
    double depth = parts[0].depth, height = parts[0].height;
    double x[3], y[3] = {0, depth + gap + parts[1].height, -(height + gap + parts[2].depth)};
    for (int i = 0; i < 3; i++)
        x[i] = (width - parts[i].width) / 2;
    for (int i = 0; i < 3; i++)
        if (formula->children[i])
            take_box(box, &parts[i], x[i], y[i]);
    box->width = width;
}

static void set_scripts(const struct lx_setting *setting, const struct lx_formula *formula, struct lx_style style,
                        struct lx_formula_box *box)
{
    const struct lx_formula *base = formula->children[0], *below = formula->children[1], *above = formula->children[2];
    struct lx_style small = smaller(setting, style);
    struct lx_formula_box parts[3] = {{0}};
    bool letter = base->type == LX_FORMULA_LETTER || base->type == LX_FORMULA_BOLD || base->type == LX_FORMULA_NUMBER ||
                  (base->type == LX_FORMULA_UPRIGHT && !is_large(base));
    double em = style.size, up = 0, down = 0;
    if (style.display && has_limits(base)) {
        set_limits(setting, formula, style, box);
        return;
    }
    lx_formula_set(setting, base, style, &parts[0]);
    double width = parts[0].width, overhang = parts[0].overhang;
    if (above) {
        lx_formula_set(setting, above, small, &parts[2]);
        up = fmax((style.display ? 0.4 : 0.36) * em, parts[2].depth + 0.12 * em);
        up = letter ? fmax(up, parts[0].height - 0.42 * em) : fmax(up, parts[0].height - 0.3 * em);
    }
    if (below) {
        lx_formula_set(setting, below, small, &parts[1]);
        down = fmax((above ? 0.25 : 0.18) * em, parts[1].height - 0.44 * em);
        down = letter ? down : fmax(down, parts[0].depth + 0.08 * em);
    }
    if (above && below) { /* they must not meet */
        double gap = (up - parts[2].depth) - (parts[1].height - down), least = 0.18 * em;
        down += gap < least ? least - gap : 0;
    }
    double wider = fmax(above ? overhang + parts[2].width : 0, below ? parts[1].width : 0);
    take_box(box, &parts[0], 0, 0);
    take_box(box, &parts[1], width + 0.02 * em, down);
    take_box(box, &parts[2], width + overhang + 0.03 * em, -up);
    box->width = width + wider + 0.05 * em;
}

static void set_accent(const struct lx_setting *setting, const struct lx_formula *formula, struct lx_style style,
                       struct lx_formula_box *box)
{
    struct lx_formula_box inner = {0};
    double em = style.size;
    bool hat = strcmp(formula->text, "^") == 0;
    lx_formula_set(setting, formula->children[0], style, &inner);
    double width = inner.width, height = inner.height, shift = inner.overhang / 2 + 0.04 * em;
    double mark = hat ? fmin(0.42 * em, width) : fmax(width, 0.4 * em);
    take_box(box, &inner, 0, 0);
    add_shape(box, hat ? LX_SHAPE_HAT : LX_SHAPE_ARROW, (width - mark) / 2 + shift, -height - 0.26 * em, mark,
              0.16 * em, RULE * em);
    box->width = width;
    box->height = height + 0.28 * em;
}

void lx_formula_set(const struct lx_setting *setting, const struct lx_formula *formula, struct lx_style style,
                    struct lx_formula_box *box)
{
    bool fenced = formula->type == LX_FORMULA_ROW && formula->count == 3 &&
                  formula->children[0]->type == LX_FORMULA_FENCE && formula->children[0]->tall;
    switch (formula->type) {
    case LX_FORMULA_ROW:
        if (fenced)
            set_fenced(setting, formula, style, box);
        else
            lx_formula_set_range(setting, formula, 0, formula->count, style, box);
        break;
    case LX_FORMULA_LETTER: set_letters(setting, formula->text, true, false, style.size, box); break;
    case LX_FORMULA_BOLD: set_letters(setting, formula->text, false, true, style.size, box); break;
    case LX_FORMULA_UPRIGHT:
        if (is_large(formula))
            set_large(setting, formula->text, style, box);
        else
            set_letters(setting, formula->text, false, false, style.size, box);
        break;
    case LX_FORMULA_SPACE: box->width = formula->width * style.size; break;
    case LX_FORMULA_FRACTION: set_fraction(setting, formula, style, box); break;
    case LX_FORMULA_ROOT: set_root(setting, formula, style, box); break;
    case LX_FORMULA_SCRIPTS: set_scripts(setting, formula, style, box); break;
    case LX_FORMULA_ACCENT: set_accent(setting, formula, style, box); break;
    case LX_FORMULA_LINES: /* only whole formulas have them; see formula_set.c */ break;
    case LX_FORMULA_NUMBER:
    case LX_FORMULA_OPERATOR:
    case LX_FORMULA_FENCE:
    case LX_FORMULA_WORDS: set_letters(setting, formula->text, false, false, style.size, box); break;
    }
}

void lx_formula_box_append(struct lx_formula_box *box, struct lx_formula_box *next, double space)
{
    double x = box->width + space, width = next->width, overhang = next->overhang;
    take_box(box, next, x, 0);
    box->width = x + width;
    box->overhang = overhang;
}

/* SPDX-License-Identifier: MIT */
/* Drawing the boxes of formulas: letters by pango, brackets, roots and marks as shapes. */
#include "formula_set.h"

/* A bracket as tall as need be: thick in the middle, thin at its ends; `side` 1 opens to the right, -1 to the left. */
static void draw_round(cairo_t *cairo, const struct lx_formula_item *item, double x, double y, int side)
{
    double height = item->height, width = item->width, pen = item->pen, thin = pen * 0.35;
    double end = side > 0 ? x + width : x, back = side > 0 ? x : x + width;
    cairo_move_to(cairo, end, y);
    cairo_curve_to(cairo, back, y + height * 0.22, back, y + height * 0.78, end, y + height);
    cairo_line_to(cairo, end + side * thin, y + height - thin);
    cairo_curve_to(cairo, back + side * 1.5 * pen, y + height * 0.76, back + side * 1.5 * pen, y + height * 0.24,
                   end + side * thin, y + thin);
    cairo_close_path(cairo);
    cairo_fill(cairo);
}

static void draw_square(cairo_t *cairo, const struct lx_formula_item *item, double x, double y, int side)
{
    double pen = item->pen, back = side > 0 ? x : x + item->width - pen;
    cairo_rectangle(cairo, back, y, pen, item->height);
    cairo_rectangle(cairo, x, y, item->width, pen);
    cairo_rectangle(cairo, x, y + item->height - pen, item->width, pen);
    cairo_fill(cairo);
}

/* The sign of a root: a short stroke up, a thick one down, a thin one up to the line over the rest. */
static void draw_root(cairo_t *cairo, const struct lx_formula_item *item, double x, double y)
{
    double width = item->width, bottom = y + item->height, pen = item->pen;
    double hook = item->height < 1.6 * width ? item->height * 0.45 : 0.72 * width;
    cairo_move_to(cairo, x + 0.02 * width, bottom - hook + 0.1 * width);
    cairo_line_to(cairo, x + 0.26 * width, bottom - hook - 0.04 * width);
    cairo_line_to(cairo, x + 0.5 * width, bottom - 1.9 * pen);
    cairo_line_to(cairo, x + width - pen, y);
    cairo_line_to(cairo, x + width, y);
    cairo_line_to(cairo, x + width, y + pen);
    cairo_line_to(cairo, x + width - 0.25 * pen, y + pen);
    cairo_line_to(cairo, x + 0.53 * width, bottom);
    cairo_line_to(cairo, x + 0.44 * width, bottom);
    cairo_line_to(cairo, x + 0.18 * width, bottom - hook + 0.1 * width);
    cairo_line_to(cairo, x + 0.06 * width, bottom - hook + 0.17 * width);
    cairo_close_path(cairo);
    cairo_fill(cairo);
}

static void stroke(cairo_t *cairo, double pen)
{
    cairo_set_line_width(cairo, pen);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_MITER);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_stroke(cairo);
}

static void draw_arrow(cairo_t *cairo, const struct lx_formula_item *item, double x, double y)
{
    double middle = y + item->height / 2, tip = x + item->width, head = item->height * 0.8;
    cairo_move_to(cairo, x, middle);
    cairo_line_to(cairo, tip - item->pen, middle);
    cairo_move_to(cairo, tip - head, y);
    cairo_line_to(cairo, tip, middle);
    cairo_line_to(cairo, tip - head, y + item->height);
    stroke(cairo, item->pen);
}

static void draw_hat(cairo_t *cairo, const struct lx_formula_item *item, double x, double y)
{
    cairo_move_to(cairo, x, y + item->height);
    cairo_line_to(cairo, x + item->width / 2, y + item->height * 0.2);
    cairo_line_to(cairo, x + item->width, y + item->height);
    stroke(cairo, item->pen);
}

static void draw_item(cairo_t *cairo, const struct lx_formula_item *item, double x, double y)
{
    switch (item->shape) {
    case LX_SHAPE_LETTERS:
        cairo_move_to(cairo, x, y);
        pango_cairo_show_layout_line(cairo, pango_layout_get_line_readonly(item->layout, 0));
        cairo_new_path(cairo);
        break;
    case LX_SHAPE_RULE:
    case LX_SHAPE_BAR:
        cairo_rectangle(cairo, x, y, item->width, item->height);
        cairo_fill(cairo);
        break;
    case LX_SHAPE_ROOT: draw_root(cairo, item, x, y); break;
    case LX_SHAPE_LEFT_ROUND: draw_round(cairo, item, x, y, 1); break;
    case LX_SHAPE_RIGHT_ROUND: draw_round(cairo, item, x, y, -1); break;
    case LX_SHAPE_LEFT_SQUARE: draw_square(cairo, item, x, y, 1); break;
    case LX_SHAPE_RIGHT_SQUARE: draw_square(cairo, item, x, y, -1); break;
    case LX_SHAPE_ARROW: draw_arrow(cairo, item, x, y); break;
    case LX_SHAPE_HAT: draw_hat(cairo, item, x, y); break;
    }
}

void lx_formula_box_draw(cairo_t *cairo, const struct lx_formula_box *box, double x, double y)
{
    for (size_t i = 0; i < box->count; i++)
        draw_item(cairo, &box->items[i], x + box->items[i].x, y + box->items[i].y);
}

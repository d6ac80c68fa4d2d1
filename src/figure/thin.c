/* SPDX-License-Identifier: MIT */
/* A raster of what was drawn, in which each short piece of a line looks for lines of other levels around it. */
#include "thin.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"

/* Lines are to be a millimetre apart, in points, which are so many cells; very large maps have larger cells.  A line
 * that was left out comes back only where there is more room, lest it be dashes. */
static const double APART = 72 / 25.4;
enum { CELLS_APART = 3, CELLS_TO_COME_BACK = 6, MOST_CELLS = 3000 };

void lx_thinning_begin(struct lx_thinning *thinning, const struct lx_pane *box)
{
    const double largest = fmax(box->width, box->height);
    thinning->cell = fmax(APART / CELLS_APART, largest / MOST_CELLS);
    thinning->x = box->x;
    thinning->y = box->y;
    thinning->columns = (size_t)(box->width / thinning->cell) + 1;
    thinning->rows = (size_t)(box->height / thinning->cell) + 1;
    thinning->cells = lx_new_array(thinning->columns * thinning->rows, sizeof *thinning->cells);
}

void lx_thinning_clear(struct lx_thinning *thinning)
{
    free(thinning->cells);
}

/* Whether a line of another level is nearer than so many cells. */
static bool is_crowded(const struct lx_thinning *thinning, double x, double y, uint16_t level, long apart)
{
    const long column = (long)floor((x - thinning->x) / thinning->cell);
    const long row = (long)floor((y - thinning->y) / thinning->cell);
    for (long r = row - apart; r <= row + apart; r++)
        for (long c = column - apart; c <= column + apart; c++) {
            if (r < 0 || c < 0 || r >= (long)thinning->rows || c >= (long)thinning->columns)
                continue;
            const uint16_t there = thinning->cells[(size_t)r * thinning->columns + (size_t)c];
            const double dx = (double)(c - column), dy = (double)(r - row);
            if (there > 0 && there != level + 1 && dx * dx + dy * dy <= (double)(apart * apart))
                return true;
        }
    return false;
}

static void take(struct lx_thinning *thinning, double x, double y, uint16_t level)
{
    const double column = floor((x - thinning->x) / thinning->cell), row = floor((y - thinning->y) / thinning->cell);
    if (column >= 0 && row >= 0 && column < (double)thinning->columns && row < (double)thinning->rows)
        thinning->cells[(size_t)row * thinning->columns + (size_t)column] = (uint16_t)(level + 1);
}

/* One straight part, in pieces no longer than a cell; `down`: whether the pen is on the paper. */
static void add_part(struct lx_thinning *thinning, cairo_t *cairo, const double from[2], const double to[2],
                     uint16_t level, bool *down)
{
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    const size_t pieces = (size_t)fmin(ceil(length / thinning->cell), 2.0 * MOST_CELLS) + 1;
    for (size_t i = 1; i <= pieces; i++) {
        const double before = (double)(i - 1) / (double)pieces, share = (double)i / (double)pieces;
        const double x = from[0] + share * (to[0] - from[0]), y = from[1] + share * (to[1] - from[1]);
        if (is_crowded(thinning, x, y, level, *down ? CELLS_APART : CELLS_TO_COME_BACK)) {
            *down = false;
            continue;
        }
        if (!*down)
            cairo_move_to(cairo, from[0] + before * (to[0] - from[0]), from[1] + before * (to[1] - from[1]));
        cairo_line_to(cairo, x, y);
        take(thinning, x, y, level);
        *down = true;
    }
}

void lx_thinning_add_line(struct lx_thinning *thinning, cairo_t *cairo, const struct lx_plot *plot,
                          const luxel_isophote *line, uint16_t level)
{
    bool down = false, whole = true;
    for (size_t k = 0; k < line->count && whole && thinning->cells; k++)
        whole =
            !is_crowded(thinning, lx_plot_x(plot, line->x_mm[k]), lx_plot_y(plot, line->y_mm[k]), level, CELLS_APART);
    if (whole || !thinning->cells) { /* as one stroke, whose ends meet */
        for (size_t k = 0; k < line->count; k++)
            cairo_line_to(cairo, lx_plot_x(plot, line->x_mm[k]), lx_plot_y(plot, line->y_mm[k]));
        if (line->closed)
            cairo_close_path(cairo);
    }
    for (size_t k = 1; k < line->count + line->closed && thinning->cells; k++) {
        const size_t next = k % line->count;
        const double from[2] = {lx_plot_x(plot, line->x_mm[k - 1]), lx_plot_y(plot, line->y_mm[k - 1])};
        const double to[2] = {lx_plot_x(plot, line->x_mm[next]), lx_plot_y(plot, line->y_mm[next])};
        if (!whole)
            add_part(thinning, cairo, from, to, level, &down);
        else
            for (int i = 0; i <= 4; i++) /* the vertices of a line are near to each other */
                take(thinning, from[0] + i * (to[0] - from[0]) / 4, from[1] + i * (to[1] - from[1]) / 4, level);
    }
}

/* SPDX-License-Identifier: MIT */
/* Tables of pages: columns as wide as their words want and the page has room, cells on a common baseline. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "page_rows.h"

static const struct lx_page_type plain = {.size = 8.6, .leading = 1.36};
static const struct lx_page_type strong = {.size = 8.6, .leading = 1.36, .bold = true};

static const double GAP = 14;      /* between columns */
static const double SLACK = 0.1;   /* lest rounding breaks a line that fits */
static const double PADDING = 2.2; /* above and below the words of a row */

enum {
    MOST_LINES = 40, /* of a cell, so that a row fits a page */
    SMALL = 9        /* rows of a table that stands on one page */
};

struct column {
    double least, wanted, heading, width, x;
};

static const struct lx_page_type *type_of(const struct lx_block *table, size_t row)
{
    return row == 0 || table->rows[row].marked ? &strong : &plain;
}

static double width_of(PangoLayout *layout)
{
    PangoRectangle logical;
    pango_layout_get_extents(layout, NULL, &logical);
    return (double)logical.width / PANGO_SCALE;
}

static double width_in_line(struct lx_pages *pages, const struct lx_block *table, size_t r, size_t c,
                            double *widest_word)
{
    PangoLayout *layout = lx_page_layout(pages, &table->rows[r].cells[c], type_of(table, r), 0);
    if (!layout)
        return 0;
    double width = width_of(layout);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD);
    pango_layout_set_width(layout, 0);
    *widest_word = width_of(layout);
    return width;
}

/* The widest word of a column's cells, and its widest cell in one line; numbers are never broken. */
static void measure(struct lx_pages *pages, const struct lx_block *table, size_t c, struct column *column)
{
    *column = (struct column){0};
    for (size_t r = 0; r < table->row_count && !pages->failed; r++) {
        double word = 0, wanted = width_in_line(pages, table, r, c, &word);
        if (r == 0) {
            column->heading = wanted;
            column->least = word;
            column->wanted = table->row_count > 1 ? word : wanted; /* headings give way to what stands below them */
        } else {
            column->wanted = fmax(column->wanted, wanted);
            column->least = fmax(column->least, table->text[c] == 'r' ? wanted : word);
        }
    }
}

/* Headings stay in one line if that leaves the columns enough. */
static void keep_headings(struct column *columns, size_t count, double room)
{
    double least = 0;
    for (size_t c = 0; c < count; c++)
        least += fmax(columns[c].least, columns[c].heading);
    for (size_t c = 0; least <= 0.8 * room && c < count; c++) {
        columns[c].least = fmax(columns[c].least, columns[c].heading);
        columns[c].wanted = fmax(columns[c].wanted, columns[c].heading);
    }
}

static double width_within(const struct column *column, double most)
{
    return fmax(column->least, fmin(column->wanted, most));
}

/* How wide a column may be so that all of them fit: the widest ones give way first. */
static double find_most(const struct column *columns, size_t count, double room)
{
    double low = 0, high = room;
    for (int i = 0; i < 40; i++) {
        double middle = (low + high) / 2, total = 0;
        for (size_t c = 0; c < count; c++)
            total += width_within(&columns[c], middle);
        if (total > room)
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* Gives the columns their widths. */
static void share_room(struct column *columns, size_t count, double width)
{
    double least = 0, wanted = 0, missing = 0, room = width - GAP * (double)(count - 1) - (double)count * SLACK;
    keep_headings(columns, count, room);
    for (size_t c = 0; c < count; c++) {
        least += columns[c].least;
        wanted += columns[c].wanted;
        missing += fmax(0, columns[c].heading - columns[c].wanted);
    }
    double more = missing > 0 ? fmin(1, fmax(0, (room - wanted) / missing)) : 0;
    double most = wanted > room ? find_most(columns, count, room) : room;
    for (size_t c = 0; c < count; c++) {
        struct column *column = &columns[c];
        column->width = width_within(column, most) + fmax(0, column->heading - column->wanted) * more;
        if (least > room)
            column->width = column->least * room / least;
        column->width += SLACK;
        column->x = c > 0 ? columns[c - 1].x + columns[c - 1].width + GAP : 0;
    }
}

/* Sets a cell's lines into the row, with the first baseline at `first`; returns where the last line ends. */
static double set_cell(struct lx_pages *pages, struct lx_page_row *row, PangoLayout *layout, double x, double first)
{
    PangoLayoutIter *iterator = pango_layout_get_iter(layout);
    double shift = first - (double)pango_layout_iter_get_baseline(iterator) / PANGO_SCALE, bottom = 0;
    int number = 0;
    do {
        PangoRectangle logical;
        double lead = 0.12 * plain.size * number++;
        pango_layout_iter_get_line_extents(iterator, NULL, &logical);
        lx_page_add_text(pages, row, pango_layout_iter_get_line_readonly(iterator), x + (double)logical.x / PANGO_SCALE,
                         (double)pango_layout_iter_get_baseline(iterator) / PANGO_SCALE + shift + lead);
        bottom = (double)(logical.y + logical.height) / PANGO_SCALE + shift + lead;
    } while (pango_layout_iter_next_line(iterator));
    pango_layout_iter_free(iterator);
    return bottom;
}

static void add_row(struct lx_pages *pages, const struct lx_block *table, size_t r, const struct column *columns,
                    size_t heading)
{
    size_t count = lx_block_columns(table);
    PangoLayout **layouts = lx_new_array(count, sizeof(PangoLayout *));
    struct lx_page_row *row = layouts ? lx_page_add_row(pages, LX_ROW_CELLS) : NULL;
    double first = 0, bottom = 0;
    pages->failed = pages->failed || !layouts;
    for (size_t c = 0; row && c < count; c++) {
        layouts[c] = lx_page_layout(pages, &table->rows[r].cells[c], type_of(table, r), columns[c].width);
        if (!layouts[c])
            break;
        pango_layout_set_height(layouts[c], -MOST_LINES);
        pango_layout_set_ellipsize(layouts[c], PANGO_ELLIPSIZE_END);
        if (table->text[c] == 'r')
            pango_layout_set_alignment(layouts[c], PANGO_ALIGN_RIGHT);
        first = fmax(first, (double)pango_layout_get_baseline(layouts[c]) / PANGO_SCALE);
    }
    for (size_t c = 0; row && !pages->failed && c < count; c++)
        bottom = fmax(bottom, set_cell(pages, row, layouts[c], columns[c].x, first + PADDING));
    free(layouts);
    if (!row)
        return;
    row->height = bottom + PADDING;
    row->width = columns[count - 1].x + columns[count - 1].width;
    row->above = r == 0 ? 9 : 0;
    row->ruled[0] = r == 0;
    row->ruled[1] = r + 1 == table->row_count;
    row->underlined = r == 0;
    row->is_marked = table->rows[r].marked;
    /* small tables are not parted, large ones neither right behind their heading nor before their last row */
    row->stays = r + 1 < table->row_count && (table->row_count <= SMALL || r < 2 || r + 2 == table->row_count);
    row->heading = r > 0 ? heading : 0;
}

void lx_page_add_table(struct lx_pages *pages, const struct lx_block *table)
{
    size_t count = lx_block_columns(table), heading = pages->count + 1;
    struct column *columns = lx_new_array(count + 1, sizeof *columns);
    pages->failed = pages->failed || !columns;
    if (count > 0 && table->row_count > 0 && !pages->failed) {
        for (size_t c = 0; c < count; c++)
            measure(pages, table, c, &columns[c]);
        share_room(columns, count, pages->width);
        for (size_t r = 0; r < table->row_count && !pages->failed; r++)
            add_row(pages, table, r, columns, heading);
    }
    free(columns);
}

/* SPDX-License-Identifier: MIT */
/* Writing measured grids: a line of comma-separated values for each cell, and lines of equal value as a drawing, whole
 * or not at all. */
#include <luxel/grid.h>
#include <luxel/isophotes.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../base/diagnostics.h"
#include "../base/ending.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/path.h"
#include "../base/sink.h"
#include "../format/csv_read.h"
#include "../format/dxf.h"
#include "grid.h"

#define ENDING ".csv"

luxel_status luxel_check_grid_output_name(const char *path, luxel_diagnostics *diagnostics)
{
    const char *name = lx_path_name(path), *dot = strrchr(name, '.');
    if (dot && dot != name && strcasecmp(dot, ENDING) == 0)
        return LUXEL_OK;
    return lx_refuse(diagnostics, LX_MSG_GRID_ENDING, LX_ARGS(path, ENDING));
}

static void add_heading(struct lx_text *lines, const char *unit, bool in_color)
{
    static const char *const names[] = {"irradiance_", "error_", "red_", "green_", "blue_"};
    lx_text_puts(lines, "grid,column,row,x_mm,y_mm,z_mm");
    for (size_t i = 0; i < (in_color ? 5 : 2); i++) {
        struct lx_text field = {0};
        lx_text_puts(&field, names[i]);
        lx_text_puts(&field, unit);
        lx_text_puts(lines, ",");
        lx_csv_add_field(lines, field.failed ? "" : field.bytes);
        lines->failed |= field.failed;
        lx_text_clear(&field);
    }
    lx_text_puts(lines, "\n");
}

static void add_cell(struct lx_text *lines, const struct luxel_grid *grid, unsigned column, unsigned row)
{
    size_t cell = (size_t)row * grid->columns + column;
    char number[LX_NUMBER_SIZE];
    double position_mm[3];
    luxel_grid_position(grid, column, row, position_mm);
    lx_text_printf(lines, ",%u,%u", column, row);
    for (int i = 0; i < 3; i++) {
        lx_text_puts(lines, ",");
        lx_text_puts(lines, lx_write_digits(position_mm[i] + 0.0, LX_CSV_PLACE_DIGITS, number));
    }
    lx_text_puts(lines, ",");
    if (grid->mask[cell])
        lx_text_puts(lines, lx_write_number(grid->values[cell], number));
    lx_text_puts(lines, ",");
    if (grid->mask[cell])
        lx_text_puts(lines, lx_write_number(grid->errors[cell], number));
    for (int c = 0; grid->colors && c < 3; c++) {
        lx_text_puts(lines, ",");
        if (grid->mask[cell])
            lx_text_puts(lines, lx_write_number(grid->colors[cell].rgb[c], number));
    }
    lx_text_puts(lines, "\n");
}

/* Row by row, so that the buffer stays small.  A failure is the sink's to keep. */
static void write_grid(const struct luxel_grid *grid, size_t number, struct lx_sink *sink)
{
    struct lx_text lines = {0}, label = {0};
    luxel_status status = LUXEL_OK;
    if (grid->name)
        lx_csv_add_field(&label, grid->name);
    else
        lx_text_printf(&label, "grid %zu", number);
    for (unsigned row = 0; row < grid->rows && status == LUXEL_OK && !lines.failed && !label.failed; row++) {
        lines.length = 0;
        for (unsigned column = 0; column < grid->columns; column++) {
            lx_text_add(&lines, label.bytes, label.length);
            add_cell(&lines, grid, column, row);
        }
        status = lines.failed ? LUXEL_OK : lx_sink_write(sink, lines.bytes, lines.length);
    }
    if (lines.failed || label.failed)
        lx_sink_out_of_memory(sink);
    lx_text_clear(&lines);
    lx_text_clear(&label);
}

luxel_status luxel_grids_write(const luxel_grid *const *grids, size_t count, const char *path,
                               luxel_diagnostics *diagnostics)
{
    struct lx_text heading = {0};
    struct lx_sink *sink;
    luxel_status status = luxel_check_grid_output_name(path, diagnostics);
    if (status != LUXEL_OK)
        return status;
    if (count == 0)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("grids"));
    status = lx_sink_open(path, NULL, diagnostics, &sink);
    if (status != LUXEL_OK)
        return status;
    add_heading(&heading, grids[0]->unit, grids[0]->colors != NULL);
    if (heading.failed)
        lx_sink_out_of_memory(sink);
    else
        lx_sink_write(sink, heading.bytes, heading.length);
    lx_text_clear(&heading);
    for (size_t i = 0; i < count; i++)
        write_grid(grids[i], i + 1, sink);
    return lx_sink_commit(sink);
}

/* ---- drawings ---- */

/* Letters are so high, as a share of the geometric mean of a plane's sides; a line with fewer vertices has none. */
static const double LETTERS = 1.0 / 50;
enum { LEVEL_DIGITS = 9, LABELLED = 8 };

/* The places of a line, or of the edges of the plane, in space; NULL when memory is short. */
static double (*places_of(const luxel_grid *grid, const double *x_mm, const double *y_mm, size_t count))[3]
{
    double(*places)[3] = lx_new_array(count, sizeof *places);
    for (size_t i = 0; places && i < count; i++)
        lx_place_on_cells(&((const struct lx_measured *)grid)->cells, (const double[]){x_mm[i], y_mm[i]}, places[i]);
    return places;
}

static void write_words(struct lx_dxf *dxf, const struct lx_dxf_layer *layer, const luxel_grid *grid,
                        const double place[3], const char *text)
{
    struct lx_dxf_words words = {.height = LETTERS * sqrt(grid->size_mm[0] * grid->size_mm[1]), .text = text};
    memcpy(words.place, place, sizeof words.place);
    memcpy(words.along, grid->across, sizeof words.along);
    memcpy(words.normal, grid->axis, sizeof words.normal);
    lx_dxf_add_words(dxf, layer, &words);
}

/* The edges of the plane, and what is on it. */
static void add_plane(struct lx_dxf *dxf, const luxel_grid *grid, size_t number)
{
    const double across = grid->size_mm[0] / 2, up = grid->size_mm[1] / 2;
    const double x_mm[] = {-across, across, across, -across}, y_mm[] = {-up, -up, up, up};
    struct lx_dxf_layer layer = {.name = "GRIDS", .color = 7};
    double(*places)[3] = places_of(grid, x_mm, y_mm, 4);
    struct lx_text words = {0};
    if (grid->name)
        lx_text_puts(&words, grid->name);
    else
        lx_text_printf(&words, "grid %zu", number);
    lx_text_puts(&words, ": ");
    lx_text_puts(&words, grid->unit);
    lx_dxf_add_layer(dxf, &layer);
    if (places && !words.failed) {
        lx_dxf_add_line(dxf, &layer, (const double(*)[3])places, 4, true);
        write_words(dxf, &layer, grid, places[3], words.bytes);
    }
    dxf->entities.failed = dxf->entities.failed || !places || words.failed;
    free(places);
    lx_text_clear(&words);
}

/* From blue, of low levels, to red; `number` 0: the only grid. */
static struct lx_dxf_layer layer_of(double level, double share, size_t number)
{
    static const int colors[] = {5, 4, 3, 2, 1};
    enum { COLORS = sizeof colors / sizeof *colors };
    struct lx_dxf_layer layer = {.color = colors[(size_t)fmin(share * COLORS, COLORS - 1)]};
    struct lx_text name = {0};
    char digits[LX_NUMBER_SIZE];
    lx_text_puts(&name, "ISOLUX_");
    if (number > 0)
        lx_text_printf(&name, "%zu_", number);
    lx_text_puts(&name, lx_write_digits(level, LEVEL_DIGITS, digits));
    lx_text_add(&name, "", 1);
    if (!name.failed)
        memcpy(layer.name, name.bytes, name.length < LX_DXF_NAME ? name.length : LX_DXF_NAME - 1);
    lx_text_clear(&name);
    return layer;
}

static void add_lines(struct lx_dxf *dxf, const luxel_grid *grid, const luxel_isophotes *isophotes, size_t number)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t i = 0; i < isophotes->count; i++) {
        low = fmin(low, isophotes->lines[i].level);
        high = fmax(high, isophotes->lines[i].level);
    }
    for (size_t i = 0; i < isophotes->count && !dxf->entities.failed; i++) {
        const luxel_isophote *line = &isophotes->lines[i];
        struct lx_dxf_layer layer = layer_of(line->level, high > low ? (line->level - low) / (high - low) : 0, number);
        double(*places)[3] = places_of(grid, line->x_mm, line->y_mm, line->count);
        char level[LX_NUMBER_SIZE];
        lx_dxf_add_layer(dxf, &layer);
        if (!places) {
            dxf->entities.failed = true;
            return;
        }
        lx_dxf_add_line(dxf, &layer, (const double(*)[3])places, line->count, line->closed);
        if (line->count >= LABELLED)
            write_words(dxf, &layer, grid, places[line->count / 2], lx_write_digits(line->level, LEVEL_DIGITS, level));
        free(places);
    }
}

luxel_status luxel_grid_isophotes_write(const luxel_grid *const *grids, const luxel_isophotes *const *isophotes,
                                        size_t count, const char *path, luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".dxf"};
    struct lx_dxf dxf = {.layers = NULL};
    struct lx_text text = {0};
    size_t found;
    luxel_status status = lx_find_ending(path, endings, 1, diagnostics, &found);
    if (status != LUXEL_OK)
        return status;
    if (count == 0)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("grids"));
    for (size_t i = 0; i < count; i++) {
        add_plane(&dxf, grids[i], i + 1);
        add_lines(&dxf, grids[i], isophotes[i], count > 1 ? i + 1 : 0);
    }
    lx_dxf_finish(&dxf, "Luxel: lines of equal illuminance; all lengths in mm, in the coordinates of the scene", &text);
    status = text.failed ? lx_out_of_memory(diagnostics)
                         : lx_sink_put(&(struct lx_destination){.path = path}, text.bytes, text.length, diagnostics);
    lx_text_clear(&text);
    return status;
}

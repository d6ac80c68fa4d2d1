/* SPDX-License-Identifier: MIT */
/* Writing measured grids: a line of comma-separated values for each cell, whole or not at all. */
#include <luxel/grid.h>

#include <string.h>
#include <strings.h>

#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../base/path.h"
#include "../base/sink.h"
#include "../format/csv_read.h"

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

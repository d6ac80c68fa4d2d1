/* SPDX-License-Identifier: MIT */
/*
 * The tables of a lighting report as files in a folder, for whoever calculates on: those of the document, all values of
 * the grids, and the lines of equal value on their planes.
 */
#include <math.h>

#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../document/blocks.h"
#include "../format/csv_read.h"
#include "lighting.h"

enum { PLACE_DIGITS = 12 };

/* A path in the folder; clear it. */
static struct lx_text path_of(const struct lx_design_report *lighting, const char *name, const char *ending)
{
    struct lx_text path = {0};
    lx_text_puts(&path, lighting->report->texts->tables);
    lx_text_puts(&path, "/");
    lx_text_puts(&path, name);
    lx_text_puts(&path, ending);
    return path;
}

/* Writes a text, which it clears. */
static luxel_status put(const struct lx_design_report *lighting, const char *name, struct lx_text *text)
{
    struct lx_text path = path_of(lighting, name, ".csv");
    luxel_diagnostics *diagnostics = lighting->report->diagnostics;
    const luxel_status status = text->failed || path.failed ? lx_out_of_memory(diagnostics)
                                                            : lx_sink_put(&(struct lx_destination){.path = path.bytes},
                                                                          text->bytes, text->length, diagnostics);
    lx_text_clear(&path);
    lx_text_clear(text);
    return status;
}

static luxel_status write_tables(const struct lx_design_report *lighting)
{
    const struct luxel_document *document = lighting->report->document;
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < document->block_count && status == LUXEL_OK; i++) {
        struct lx_text text = {0};
        if (document->blocks[i].type != LX_BLOCK_TABLE || !*document->blocks[i].name)
            continue;
        lx_document_write_table(&document->blocks[i], &text);
        status = put(lighting, document->blocks[i].name, &text);
    }
    return status;
}

/* ---- grids ---- */

/* `area`: around the grid, or "". */
static void add_name(struct lx_text *text, const luxel_grid *grid, size_t i, const char *area)
{
    struct lx_text name = {0};
    if (grid->name)
        lx_text_puts(&name, grid->name);
    else
        lx_text_printf(&name, "grid %zu", i + 1);
    lx_text_puts(&name, area);
    lx_csv_add_field(text, name.bytes ? name.bytes : "");
    text->failed = text->failed || name.failed;
    lx_text_clear(&name);
}

static void add_number(struct lx_text *text, bool exists, double value)
{
    char number[LX_NUMBER_SIZE];
    lx_text_puts(text, ",");
    if (exists && isfinite(value))
        lx_text_puts(text, lx_write_number(value, number));
}

static void add_grid(struct lx_text *text, const luxel_grid *grid, size_t i, const char *area)
{
    if (!grid)
        return;
    const bool has_values = grid->measured > 0;
    add_name(text, grid, i, area);
    lx_text_printf(text, ",%s", grid->measure);
    add_number(text, true, grid->columns);
    add_number(text, true, grid->rows);
    for (int k = 0; k < 2; k++)
        add_number(text, true, grid->size_mm[k]);
    add_number(text, has_values, grid->average.value);
    add_number(text, has_values, grid->average.error);
    add_number(text, has_values, grid->minimum.value);
    add_number(text, has_values, grid->maximum.value);
    add_number(text, has_values, grid->error);
    add_number(text, grid->has_evenness, grid->u0);
    add_number(text, grid->has_evenness, grid->ud);
    lx_text_puts(text, "\n");
}

static luxel_status write_grids(const struct lx_design_report *lighting)
{
    static const char *const names[] = {"average", "average_error", "minimum", "maximum", "error"};
    luxel_grid *const *grids = lighting->grids;
    struct lx_text text = {0};
    lx_text_puts(&text, "grid,measure,columns,rows,width_mm,height_mm");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        lx_text_printf(&text, ",%s_%s", names[i], grids[0]->unit);
    lx_text_puts(&text, ",u0,ud\n");
    for (size_t i = 0; i < lighting->grid_count; i++) {
        add_grid(&text, grids[i], i, "");
        add_grid(&text, grids[i]->surround, i, ", surround");
        add_grid(&text, grids[i]->background, i, ", background");
    }
    const luxel_status status = put(lighting, "grids", &text);
    struct lx_text path = path_of(lighting, "values", ".csv");
    const luxel_status of_values = path.failed
                                       ? lx_out_of_memory(lighting->report->diagnostics)
                                       : luxel_grids_write((const luxel_grid *const *)grids, lighting->grid_count,
                                                           path.bytes, lighting->report->diagnostics);
    lx_text_clear(&path);
    return status == LUXEL_OK ? of_values : status;
}

/* ---- lines ---- */

static void add_line(struct lx_text *text, const luxel_grid *grid, const luxel_isophote *line, size_t i, size_t number)
{
    char digits[LX_NUMBER_SIZE];
    for (size_t k = 0; k < line->count; k++) {
        add_name(text, grid, i, "");
        lx_text_printf(text, ",%zu", number);
        add_number(text, true, line->level);
        lx_text_puts(text, line->closed ? ",1" : ",0");
        for (int c = 0; c < 3; c++) {
            const double place = grid->center_mm[c] + line->x_mm[k] * grid->across[c] + line->y_mm[k] * grid->up[c];
            lx_text_puts(text, ",");
            lx_text_puts(text, lx_write_digits(place + 0.0, PLACE_DIGITS, digits));
        }
        lx_text_puts(text, "\n");
    }
}

/* Grids without lines, all of whose cells are inside of bodies, have no part in them. */
static luxel_status write_lines(const struct lx_design_report *lighting)
{
    static const luxel_isophotes none = {0};
    luxel_diagnostics *diagnostics = lighting->report->diagnostics;
    struct lx_text text = {0};
    lx_text_printf(&text, "grid,line,level_%s,closed,x_mm,y_mm,z_mm\n", lighting->grids[0]->unit);
    for (size_t i = 0; i < lighting->grid_count; i++) {
        if (!lighting->lines[i])
            lighting->lines[i] = &none;
        for (size_t k = 0; k < lighting->lines[i]->count; k++)
            add_line(&text, lighting->grids[i], &lighting->lines[i]->lines[k], i, k + 1);
    }
    const luxel_status status = put(lighting, "isolux", &text);
    struct lx_text path = path_of(lighting, "isolux", ".dxf");
    const luxel_status of_drawing =
        path.failed ? lx_out_of_memory(diagnostics)
                    : luxel_grid_isophotes_write((const luxel_grid *const *)lighting->grids, lighting->lines,
                                                 lighting->grid_count, path.bytes, diagnostics);
    lx_text_clear(&path);
    return status == LUXEL_OK ? of_drawing : status;
}

luxel_status lx_lighting_tables(const struct lx_design_report *lighting)
{
    luxel_status status = write_tables(lighting);
    if (status == LUXEL_OK && lighting->grid_count > 0)
        status = write_grids(lighting);
    if (status == LUXEL_OK && lighting->grid_count > 0)
        status = write_lines(lighting);
    return status;
}

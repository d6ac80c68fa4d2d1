/* SPDX-License-Identifier: MIT */
/* Writing luminaires to files: which format, which planes, and the file as a whole. */
#include "photometry_write.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/ending.h"
#include "../../base/memory.h"
#include "../../base/number.h"
#include "../../base/sink.h"
#include "../photometry_turn.h"

static const double SAME = 1e-9; /* degrees */

void lx_add_number(struct lx_text *text, double number)
{
    char digits[LX_NUMBER_SIZE];
    lx_text_puts(text, lx_write_number(number + 0.0, digits));
}

void lx_add_line(struct lx_text *text, const char *line, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        unsigned char byte = (unsigned char)line[i];
        lx_text_add(text, byte < ' ' || byte == 0x7f ? " " : line + i, 1);
    }
}

/* Adds the intensities at a plane, which may lie between two of the table. */
static void add_plane(const luxel_photometry *photometry, double plane_deg, struct lx_written_table *table)
{
    size_t angles = photometry->angle_count;
    double *row = table->intensities + table->plane_count * angles;
    table->planes[table->plane_count++] = plane_deg;
    for (size_t i = 0; i < photometry->plane_count; i++)
        if (fabs(photometry->planes[i] - plane_deg) <= SAME) {
            memcpy(row, photometry->intensities + i * angles, angles * sizeof *row);
            return;
        }
    for (size_t j = 0; j < angles; j++)
        row[j] = luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, plane_deg, photometry->angles[j]);
}

bool lx_take_planes(const luxel_photometry *photometry, double from_deg, double to_deg, struct lx_written_table *table)
{
    size_t count = photometry->plane_count, angles = photometry->angle_count;
    *table = (struct lx_written_table){lx_new_array(count + 2, sizeof(double)),
                                       lx_new_array(count + 2, angles * sizeof(double)), 0};
    if (!table->planes || !table->intensities) {
        lx_written_table_clear(table);
        return false;
    }
    add_plane(photometry, from_deg, table);
    for (size_t i = 0; i < count; i++) {
        double plane = photometry->planes[i];
        if (plane > from_deg + SAME && plane < to_deg - SAME)
            add_plane(photometry, plane, table);
    }
    if (to_deg > from_deg + SAME)
        add_plane(photometry, to_deg, table);
    return true;
}

void lx_written_table_clear(struct lx_written_table *table)
{
    free(table->planes);
    free(table->intensities);
    *table = (struct lx_written_table){NULL, NULL, 0};
}

/* A luminaire of type A or B in a format that knows type C alone, with how far that may be off. */
static bool write_turned(const luxel_photometry *photometry, const char *path, luxel_diagnostics *diagnostics,
                         struct lx_text *text)
{
    static const char *const types[] = {"A", "B", "C"};
    char planes[LX_NUMBER_SIZE], angles[LX_NUMBER_SIZE], off[LX_NUMBER_SIZE];
    struct lx_turned turned;
    bool has_memory = lx_turn_to_c(photometry, &turned);
    if (has_memory)
        lx_write_eulumdat(&turned.shown, text, &has_memory);
    if (has_memory) {
        lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_EULUMDAT_TYPE,
                  LX_ARGS(path, types[photometry->type], lx_write_number(turned.planes[1], planes),
                          lx_write_number(turned.angles[1], angles), lx_write_bound(100 * turned.off, 2, off)));
        lx_hint(diagnostics, LX_MSG_HINT_EULUMDAT_TYPE, NULL);
    }
    lx_turned_clear(&turned);
    return has_memory;
}

luxel_status luxel_photometry_write(const luxel_photometry *photometry, const char *path,
                                    luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".ies", ".ldt"};
    struct lx_text text = {0};
    struct lx_sink *sink;
    size_t format;
    bool has_memory = true;
    if (!photometry || !path)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = lx_find_ending(path, endings, 2, diagnostics, &format);
    if (status != LUXEL_OK)
        return status;
    if (format == 0)
        lx_write_lm63(photometry, &text, &has_memory);
    else if (photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        lx_write_eulumdat(photometry, &text, &has_memory);
    else
        has_memory = write_turned(photometry, path, diagnostics, &text);
    status = has_memory && !text.failed ? lx_sink_open(path, NULL, diagnostics, &sink) : lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK) {
        lx_sink_write(sink, text.bytes, text.length);
        status = lx_sink_commit(sink);
    }
    lx_text_clear(&text);
    return status;
}

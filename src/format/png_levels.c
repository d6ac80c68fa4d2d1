/* SPDX-License-Identifier: MIT */
/* Reading grey PNG pictures through libpng, levels as they are: no gamma, no palette. */
#include "png_levels.h"

#include <png.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/source.h"
#include "format.h"

enum { MOST_BYTES = 1 << 30 };

struct reading {
    struct lx_source *source;
    uint64_t at;
    png_structp png;
    png_infop info;
    unsigned char *row;
    struct lx_levels *levels;
};

static void get_bytes(png_structp png, png_bytep bytes, size_t count)
{
    struct reading *reading = png_get_io_ptr(png);
    if (lx_source_read(reading->source, reading->at, bytes, count) != LUXEL_OK)
        png_error(png, "the source failed");
    reading->at += count;
}

static void fail(png_structp png, const char *text)
{
    struct reading *reading = png_get_error_ptr(png);
    lx_bad_file(reading->source, "PNG", text);
    png_longjmp(png, 1);
}

static void ignore_warning(png_structp png, const char *text)
{
    (void)png;
    (void)text;
}

/* Where libpng jumps back to the caller nothing that it needs is in a variable. */
static void read_rows(struct reading *reading)
{
    struct lx_levels *levels = reading->levels;
    const unsigned bytes = levels->greatest > 255 ? 2 : 1;
    for (unsigned row = 0; row < levels->rows; row++) {
        png_read_row(reading->png, reading->row, NULL);
        for (unsigned column = 0; column < levels->columns; column++) {
            const unsigned char *at = &reading->row[(size_t)column * bytes];
            levels->list[(size_t)row * levels->columns + column] = bytes == 1 ? at[0] : at[0] * 256 + at[1];
        }
    }
}

static void read_all(struct reading *reading)
{
    struct lx_levels *levels = reading->levels;
    if (setjmp(png_jmpbuf(reading->png)) != 0)
        return;
    png_set_read_fn(reading->png, reading, get_bytes);
    png_read_info(reading->png, reading->info);
    levels->columns = png_get_image_width(reading->png, reading->info);
    levels->rows = png_get_image_height(reading->png, reading->info);
    const unsigned bits = png_get_bit_depth(reading->png, reading->info);
    if (png_get_color_type(reading->png, reading->info) != PNG_COLOR_TYPE_GRAY || bits < 8 ||
        png_get_interlace_type(reading->png, reading->info) != PNG_INTERLACE_NONE) {
        lx_source_refuse(reading->source, LX_MSG_PNG_NOT_GREY, NULL);
        return;
    }
    levels->greatest = (1u << bits) - 1;
    levels->list = lx_new_array((size_t)levels->columns * levels->rows + 1, sizeof *levels->list);
    reading->row = lx_new_array((size_t)levels->columns + 1, 2);
    if (levels->list && reading->row)
        read_rows(reading);
    else
        lx_source_out_of_memory(reading->source);
}

luxel_status lx_png_read_levels(const char *path, luxel_diagnostics *diagnostics, struct lx_levels *levels)
{
    struct reading reading = {.levels = levels};
    *levels = (struct lx_levels){.columns = 0};
    luxel_status status = lx_source_open(path, MOST_BYTES, diagnostics, &reading.source);
    if (status != LUXEL_OK)
        return status;
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, fail, ignore_warning);
    if (reading.png)
        reading.info = png_create_info_struct(reading.png);
    if (reading.info)
        read_all(&reading);
    else
        lx_source_out_of_memory(reading.source);
    png_destroy_read_struct(&reading.png, &reading.info, NULL);
    status = lx_source_status(reading.source);
    lx_source_close(reading.source);
    free(reading.row);
    if (status != LUXEL_OK) {
        free(levels->list);
        levels->list = NULL;
    }
    return status;
}

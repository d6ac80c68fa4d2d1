/* SPDX-License-Identifier: MIT */
/*
 * Portable float map, grey (Pf) or in colour (PF, which is written only): three lines of text and float32 numbers.  Its
 * rows run from the bottom of the picture to the top, so the image's last row comes first; a reader that knows that
 * shows row 0 on top.  The negative scale says little-endian; its amount, which says what the numbers are multiples of,
 * is 1 here and passed over when read, as by most programs.  Format: http://www.pauldebevec.com/Research/HDR/PFM/
 */
#include <stdio.h>
#include <string.h>

#include "../base/number.h"
#include "format.h"

enum { LONGEST_HEADER = 128 };

static const char NAME[] = "PFM";

static size_t write_header(const struct lx_image *image, char header[LONGEST_HEADER])
{
    return (size_t)snprintf(header, LONGEST_HEADER, "P%c\n%u %u\n-1.0\n", image->channels == 3 ? 'F' : 'f',
                            image->columns, image->rows);
}

static void begin_pfm(struct lx_writer *writer)
{
    char header[LONGEST_HEADER];
    lx_sink_write(writer->sink, header, write_header(&writer->image, header));
    lx_reserve_numbers(writer, sizeof(float));
}

static void add_pfm(struct lx_writer *writer, const struct lx_image_strip *strip)
{
    const struct lx_image *image = &writer->image;
    char header[LONGEST_HEADER];
    uint64_t below = image->rows - strip->first - strip->rows;
    luxel_status status = LUXEL_OK;
    if (strip->rows < image->rows)
        status =
            lx_sink_seek(writer->sink, write_header(image, header) + below * lx_row_samples(image) * sizeof(float));
    for (size_t row = strip->rows; row > 0 && status == LUXEL_OK; row--)
        status =
            lx_write_numbers(writer, strip, (row - 1) * lx_row_samples(image), lx_row_samples(image), sizeof(float));
}

/* The next word of a header, with the one space behind it; false where there is none. */
static bool take_number(const char *header, size_t length, size_t *at, double *number)
{
    static const char space[] = " \t\r\n";
    size_t start = *at;
    while (start < length && strchr(space, header[start]) && header[start])
        start++;
    size_t end = start;
    while (end < length && header[end] && !strchr(space, header[end]))
        end++;
    *at = end + 1;
    return end < length && lx_read_number(header + start, end - start, number);
}

static bool is_size(double number)
{
    return number >= 1 && number < 4e9 && number == (double)(unsigned)number;
}

static luxel_status read_pfm(struct lx_source *source, struct lx_loaded *loaded)
{
    char header[LONGEST_HEADER];
    uint64_t size = lx_source_size(source);
    size_t length = size < sizeof header ? (size_t)size : sizeof header, at = 2;
    double columns = 0, rows = 0, scale = 0;
    luxel_status status = lx_source_read(source, 0, header, length);
    if (status != LUXEL_OK)
        return status;
    if (length < 3 || header[0] != 'P' || (header[1] != 'f' && header[1] != 'F'))
        return lx_bad_file(source, NAME, "Pf");
    if (header[1] == 'F')
        return lx_unfit_file(source, NAME, "type", "PF",
                             LX_N("Pf, which has one channel and not the three of a coloured picture"));
    if (!take_number(header, length, &at, &columns) || !take_number(header, length, &at, &rows) ||
        !take_number(header, length, &at, &scale) || !is_size(columns) || !is_size(rows) || scale == 0)
        return lx_bad_file(source, NAME, "header");
    loaded->columns = (unsigned)columns;
    loaded->rows = (unsigned)rows;
    loaded->sample = LX_SAMPLE_F32;
    status = lx_check_size(source, NAME, loaded, sizeof(float), at);
    if (status == LUXEL_OK)
        status = lx_loaded_allocate(source, loaded);
    for (size_t row = 0; status == LUXEL_OK && row < loaded->rows; row++)
        status = lx_read_numbers(source, at + row * loaded->columns * sizeof(float), scale > 0, loaded,
                                 (loaded->rows - 1 - row) * loaded->columns, 1, loaded->columns);
    return status;
}

const struct lx_format lx_format_pfm = {
    .ending = ".pfm",
    .name = NAME,
    .samples = LX_SAMPLE_F32 | LX_SAMPLE_F64,
    .magic = "Pf\n",
    .magic_length = 3,
    .bottom_up = true,
    .begin = begin_pfm,
    .add = add_pfm,
    .read = read_pfm,
};

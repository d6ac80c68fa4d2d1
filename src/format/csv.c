/* SPDX-License-Identifier: MIT */
/*
 * Comma-separated values: a line for each pixel on the mask, from the top row down and from the left to the right, with
 * its place and its value, or its three channels, under a line that names them.  The numbers read back as exactly the
 * same ones, and have a decimal point in every locale.  Format: RFC 4180, with the line ends of the system's other
 * texts.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../base/text.h"
#include "csv_read.h"

void lx_csv_add_field(struct lx_text *line, const char *field)
{
    if (!strpbrk(field, ",\"\r\n")) {
        lx_text_puts(line, field);
        return;
    }
    lx_text_puts(line, "\"");
    for (const char *c = field; *c; c++)
        lx_text_fill(line, *c, *c == '"' ? 2 : 1);
    lx_text_puts(line, "\"");
}

static void add_heading(struct lx_text *line, const struct lx_image *image)
{
    static const char *const channels[] = {"red_", "green_", "blue_"};
    lx_text_puts(line, LX_CSV_PLACES);
    for (unsigned c = 0; c < image->channels; c++) {
        struct lx_text field = {0};
        lx_text_puts(&field, image->channels == 3 ? channels[c] : LX_CSV_VALUE);
        lx_text_puts(&field, image->unit ? image->unit : "");
        lx_text_puts(line, c > 0 ? "," : "");
        lx_csv_add_field(line, field.failed ? "" : field.bytes);
        line->failed |= field.failed;
        lx_text_clear(&field);
    }
    lx_text_puts(line, "\n");
}

static const char *write_value(const void *data, bool single, size_t i, char number[LX_NUMBER_SIZE])
{
    double value = single ? (double)((const float *)data)[i] : ((const double *)data)[i];
    if (isnan(value))
        return "nan";
    return single ? lx_write_digits(value, LX_CSV_SINGLE_DIGITS, number) : lx_write_number(value, number);
}

/* The columns' places as texts, since each is needed in every row. */
static char (*column_texts(const struct lx_image *image))[LX_NUMBER_SIZE]
{
    char(*texts)[LX_NUMBER_SIZE] = lx_new_array(image->columns, LX_NUMBER_SIZE);
    for (unsigned column = 0; texts && column < image->columns; column++)
        lx_write_digits(image->x_mm[column], LX_CSV_PLACE_DIGITS, texts[column]);
    return texts;
}

/* The i-th row of a strip. */
static void add_row(struct lx_text *lines, const struct lx_writer *writer, const struct lx_image_strip *strip,
                    unsigned i)
{
    const struct lx_image *image = &writer->image;
    const bool single = image->sample == LX_SAMPLE_F32;
    char(*columns)[LX_NUMBER_SIZE] = writer->own;
    char y[LX_NUMBER_SIZE], number[LX_NUMBER_SIZE];
    size_t first = (size_t)i * image->columns;
    lx_write_digits(image->y_mm[strip->first + i], LX_CSV_PLACE_DIGITS, y);
    for (unsigned column = 0; column < image->columns; column++) {
        if (strip->mask && !strip->mask[first + column])
            continue;
        lx_text_puts(lines, columns[column]);
        lx_text_puts(lines, ",");
        lx_text_puts(lines, y);
        for (unsigned c = 0; c < image->channels; c++) {
            lx_text_puts(lines, ",");
            lx_text_puts(lines, write_value(strip->data, single, (first + column) * image->channels + c, number));
        }
        lx_text_puts(lines, "\n");
    }
}

/* Writes the lines, unless there was no memory for them. */
static luxel_status put_lines(struct lx_text *lines, bool failed, struct lx_sink *sink)
{
    if (failed || lines->failed)
        return lx_sink_out_of_memory(sink);
    luxel_status status = lx_sink_write(sink, lines->bytes, lines->length);
    lines->length = 0;
    return status;
}

static void begin_csv(struct lx_writer *writer)
{
    struct lx_text heading = {0};
    writer->own = column_texts(&writer->image);
    add_heading(&heading, &writer->image);
    put_lines(&heading, !writer->own, writer->sink);
    lx_text_clear(&heading);
}

static void add_csv(struct lx_writer *writer, const struct lx_image_strip *strip)
{
    struct lx_text lines = {0};
    luxel_status status = LUXEL_OK;
    for (unsigned i = 0; i < strip->rows && status == LUXEL_OK; i++) {
        add_row(&lines, writer, strip, i);
        status = put_lines(&lines, false, writer->sink);
    }
    lx_text_clear(&lines);
}

static void end_csv(struct lx_writer *writer, bool whole)
{
    (void)whole;
    free(writer->own);
}

const struct lx_format lx_format_csv = {
    .ending = ".csv",
    .name = LX_CSV_NAME,
    .samples = LX_SAMPLE_F32 | LX_SAMPLE_F64,
    .needs_places = true,
    .begin = begin_csv,
    .add = add_csv,
    .end = end_csv,
    .read = lx_csv_read,
};

/* SPDX-License-Identifier: MIT */
/*
 * Comma-separated values: a line for each pixel on the mask, from the top row down and from the left to the right, with
 * its place and its value, under a line that names the three.  The numbers read back as exactly the same ones, and
 * have a decimal point in every locale.  Format: RFC 4180, with the line ends of the system's other texts.
 */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../base/reason.h"
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
    struct lx_text field = {0};
    lx_text_puts(&field, LX_CSV_VALUE);
    lx_text_puts(&field, image->unit ? image->unit : "");
    lx_text_puts(line, LX_CSV_PLACES);
    lx_csv_add_field(line, field.failed ? "" : field.bytes);
    lx_text_puts(line, "\n");
    line->failed |= field.failed;
    lx_text_clear(&field);
}

static const char *write_value(const struct lx_image *image, size_t i, char number[LX_NUMBER_SIZE])
{
    bool single = image->sample == LX_SAMPLE_F32;
    double value = single ? (double)((const float *)image->data)[i] : ((const double *)image->data)[i];
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

static void add_row(struct lx_text *lines, const struct lx_image *image, unsigned row, char (*columns)[LX_NUMBER_SIZE])
{
    char y[LX_NUMBER_SIZE], number[LX_NUMBER_SIZE];
    size_t first = (size_t)row * image->columns;
    lx_write_digits(image->y_mm[row], LX_CSV_PLACE_DIGITS, y);
    for (unsigned column = 0; column < image->columns; column++) {
        if (image->mask && !image->mask[first + column])
            continue;
        lx_text_puts(lines, columns[column]);
        lx_text_puts(lines, ",");
        lx_text_puts(lines, y);
        lx_text_puts(lines, ",");
        lx_text_puts(lines, write_value(image, first + column, number));
        lx_text_puts(lines, "\n");
    }
}

static void write_csv(const struct lx_image *image, struct lx_sink *sink)
{
    struct lx_text lines = {0};
    char(*columns)[LX_NUMBER_SIZE] = column_texts(image);
    luxel_status status = LUXEL_OK;
    if (columns)
        add_heading(&lines, image);
    for (unsigned row = 0; columns && row < image->rows && status == LUXEL_OK && !lines.failed; row++) {
        add_row(&lines, image, row, columns);
        status = lx_sink_write(sink, lines.bytes, lines.length);
        lines.length = 0;
    }
    if (!columns || lines.failed)
        lx_sink_fail(sink, LX_MSG_FILE_NOT_WRITTEN, lx_reason(ENOMEM));
    lx_text_clear(&lines);
    free(columns);
}

const struct lx_format lx_format_csv = {
    .ending = ".csv",
    .name = LX_CSV_NAME,
    .samples = LX_SAMPLE_F32 | LX_SAMPLE_F64,
    .needs_places = true,
    .write = write_csv,
    .read = lx_csv_read,
};

/* SPDX-License-Identifier: MIT */
/* Reading tables of pixels: first the lines, then the grid that they lie on. */
#include "csv_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"

enum { PART = 64 * 1024, LONGEST_FIELD = 256, FIELDS = 3 };

/* A grid may lack so many pixels for each that there is, or be so large: two small surfaces far apart. */
static const double MOST_MISSING = 1000, SMALL_GRID = 1 << 24;

struct pixel {
    double x_mm, y_mm, value;
};

struct reader {
    struct lx_source *source;
    uint64_t offset; /* of what comes behind the part */
    unsigned char part[PART];
    size_t at, length; /* of the part */
    unsigned long line;
    bool is_single; /* every value is written as a float32 */
    char fields[FIELDS][LONGEST_FIELD];
};

/* The next byte without taking it; -1 at the end and after a failure. */
static int next_byte(struct reader *reader)
{
    if (reader->at < reader->length)
        return reader->part[reader->at];
    uint64_t left = lx_source_size(reader->source) - reader->offset;
    reader->length = left < PART ? (size_t)left : PART;
    reader->at = 0;
    if (reader->length == 0 ||
        lx_source_read(reader->source, reader->offset, reader->part, reader->length) != LUXEL_OK) {
        reader->length = 0;
        return -1;
    }
    reader->offset += reader->length;
    return reader->part[0];
}

/* One field, with or without quotes; false where it is too long or its quotes are wrong. */
static bool read_field(struct reader *reader, char field[LONGEST_FIELD])
{
    bool quoted = next_byte(reader) == '"';
    size_t used = 0;
    reader->at += quoted;
    for (int byte; (byte = next_byte(reader)) >= 0; reader->at++) {
        if (!quoted && (byte == ',' || byte == '\n' || byte == '\r' || byte == '"'))
            break;
        if (quoted && byte == '"') {
            reader->at++;
            if (next_byte(reader) != '"') {
                quoted = false;
                break;
            }
        }
        if (byte == 0 || used + 1 == LONGEST_FIELD)
            return false;
        field[used++] = (char)byte;
    }
    field[used] = '\0';
    return !quoted;
}

/* The next line of three fields; empty lines are passed over.  `end`: there is none. */
static bool read_line(struct reader *reader, bool *end)
{
    int byte;
    do {
        while ((byte = next_byte(reader)) == '\r')
            reader->at++;
        if (byte == '\n')
            reader->at++;
        reader->line++;
    } while (byte == '\n');
    *end = byte < 0;
    for (size_t i = 0; !*end && i < FIELDS; i++) {
        if (!read_field(reader, reader->fields[i]))
            return false;
        byte = next_byte(reader);
        if (i + 1 < FIELDS) {
            if (byte != ',')
                return false;
            reader->at++;
        }
    }
    if (*end)
        return true;
    while (byte == '\r') {
        reader->at++;
        byte = next_byte(reader);
    }
    if (byte == '\n')
        reader->at++;
    return byte == '\n' || byte < 0;
}

static luxel_status read_heading(struct reader *reader, struct lx_loaded *loaded)
{
    static const char mark[] = "\xef\xbb\xbf"; /* what some programs put before UTF-8 */
    bool end = false;
    if (next_byte(reader) == (unsigned char)mark[0] && reader->length >= 3 && memcmp(reader->part, mark, 3) == 0)
        reader->at += 3;
    bool good = read_line(reader, &end) && !end;
    const char *value = reader->fields[2];
    if (good && strcmp(reader->fields[0], "x_mm") == 0 && strcmp(reader->fields[1], "y_mm") == 0 &&
        strncmp(value, LX_CSV_VALUE, strlen(LX_CSV_VALUE)) == 0) {
        const char *unit = value + strlen(LX_CSV_VALUE);
        loaded->unit = lx_copy_text(unit, strlen(unit));
        return loaded->unit ? LUXEL_OK : lx_source_out_of_memory(reader->source);
    }
    return lx_source_refuse(reader->source, LX_MSG_CSV_HEADER, NULL);
}

/* A value: what a number is, and what is none. */
static bool read_value(struct reader *reader, double *value)
{
    const char *text = reader->fields[2];
    char single[LX_NUMBER_SIZE];
    bool negative = text[0] == '-';
    if (strcmp(text + negative, "inf") == 0) {
        *value = negative ? -HUGE_VAL : HUGE_VAL;
        return true;
    }
    if (strcmp(text, "nan") == 0) {
        *value = (double)NAN;
        return true;
    }
    if (!lx_read_number(text, strlen(text), value))
        return false;
    if (reader->is_single)
        reader->is_single = strcmp(text, lx_write_digits((double)(float)*value, LX_CSV_SINGLE_DIGITS, single)) == 0;
    return true;
}

static luxel_status read_pixels(struct reader *reader, struct pixel **pixels, size_t *count)
{
    size_t capacity = 0;
    for (;;) {
        struct pixel pixel;
        bool end = false;
        bool good = read_line(reader, &end);
        if (good && end)
            return *count > 0 ? lx_source_status(reader->source)
                              : lx_source_refuse(reader->source, LX_MSG_CSV_EMPTY, NULL);
        const char *x = reader->fields[0], *y = reader->fields[1];
        if (!good || !lx_read_number(x, strlen(x), &pixel.x_mm) || !lx_read_number(y, strlen(y), &pixel.y_mm) ||
            !read_value(reader, &pixel.value)) {
            char line[LX_NUMBER_SIZE];
            return lx_source_refuse(reader->source, LX_MSG_CSV_LINE,
                                    LX_ARGS(lx_write_number((double)reader->line, line)));
        }
        if (lx_reserve(pixels, &capacity, *count + 1, sizeof **pixels) < 0)
            return lx_source_out_of_memory(reader->source);
        (*pixels)[(*count)++] = pixel;
    }
}

/* The steps of the grid along one axis, which may run down. */
struct axis {
    double start, step;
    unsigned count;
};

static int compare(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* The equal steps between sorted places; false where there are none. */
static bool find_steps(const double *places, size_t count, bool down, struct axis *axis)
{
    double range = places[count - 1] - places[0], least = HUGE_VAL;
    for (size_t i = 1; i < count; i++)
        least = fmin(least, places[i] - places[i - 1]);
    double steps = count > 1 ? round(range / least) : 0;
    if (!(steps < LX_MOST_PIXELS))
        return false;
    double step = steps > 0 ? range / steps : 1;
    for (size_t i = 0; i < count; i++) {
        double at = (places[i] - places[0]) / step;
        if (!(fabs(at - round(at)) < 1e-3))
            return false;
    }
    *axis = (struct axis){down ? places[count - 1] : places[0], down ? -step : step, (unsigned)steps + 1};
    return true;
}

/* Finds an axis from one number of each pixel. */
static luxel_status find_axis(struct lx_source *source, const struct pixel *pixels, size_t count, bool down,
                              struct axis *axis)
{
    double *places = lx_new_array(count, sizeof *places);
    if (!places)
        return lx_source_out_of_memory(source);
    for (size_t i = 0; i < count; i++)
        places[i] = down ? pixels[i].y_mm : pixels[i].x_mm;
    qsort(places, count, sizeof *places, compare);
    size_t unique = 1;
    for (size_t i = 1; i < count; i++)
        if (places[i] != places[unique - 1])
            places[unique++] = places[i];
    bool good = find_steps(places, unique, down, axis);
    free(places);
    return good ? LUXEL_OK : lx_source_refuse(source, LX_MSG_CSV_NO_GRID, LX_ARGS(down ? "y_mm" : "x_mm"));
}

static double *new_places(const struct axis *axis)
{
    double *places = lx_new_array(axis->count, sizeof *places);
    for (unsigned i = 0; places && i < axis->count; i++)
        places[i] = axis->start + i * axis->step;
    return places;
}

static luxel_status allocate(struct lx_source *source, const struct axis axes[2], size_t count,
                             struct lx_loaded *loaded)
{
    loaded->columns = axes[0].count;
    loaded->rows = axes[1].count;
    double grid = (double)loaded->columns * loaded->rows;
    if (grid > SMALL_GRID && grid > MOST_MISSING * (double)count)
        return lx_source_refuse(source, LX_MSG_CSV_NO_GRID, LX_ARGS("x_mm, y_mm"));
    luxel_status status = lx_loaded_allocate(source, loaded);
    if (status != LUXEL_OK)
        return status;
    loaded->mask = lx_new_array((size_t)loaded->columns * loaded->rows, 1);
    loaded->x_mm = new_places(&axes[0]);
    loaded->y_mm = new_places(&axes[1]);
    return loaded->mask && loaded->x_mm && loaded->y_mm ? LUXEL_OK : lx_source_out_of_memory(source);
}

/* The places that the file tells replace the calculated ones, which may differ in the last digit. */
static luxel_status put_pixel(struct lx_source *source, const struct axis axes[2], const struct pixel *pixel,
                              struct lx_loaded *loaded)
{
    size_t column = (size_t)round((pixel->x_mm - axes[0].start) / axes[0].step);
    size_t row = (size_t)round((pixel->y_mm - axes[1].start) / axes[1].step), i = row * loaded->columns + column;
    if (loaded->mask[i]) {
        char x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE];
        return lx_source_refuse(source, LX_MSG_CSV_DOUBLED,
                                LX_ARGS(lx_write_number(pixel->x_mm, x), lx_write_number(pixel->y_mm, y)));
    }
    loaded->mask[i] = 1;
    loaded->x_mm[column] = pixel->x_mm;
    loaded->y_mm[row] = pixel->y_mm;
    if (loaded->sample == LX_SAMPLE_F64)
        ((double *)loaded->values)[i] = pixel->value;
    else
        ((float *)loaded->values)[i] = (float)pixel->value;
    return LUXEL_OK;
}

static luxel_status read_table(struct reader *reader, struct lx_loaded *loaded)
{
    struct pixel *pixels = NULL;
    struct axis axes[2];
    size_t count = 0;
    luxel_status status = read_heading(reader, loaded);
    if (status == LUXEL_OK)
        status = read_pixels(reader, &pixels, &count);
    for (size_t i = 0; status == LUXEL_OK && i < 2; i++)
        status = find_axis(reader->source, pixels, count, i == 1, &axes[i]);
    loaded->sample = reader->is_single ? LX_SAMPLE_F32 : LX_SAMPLE_F64;
    if (status == LUXEL_OK)
        status = allocate(reader->source, axes, count, loaded);
    for (size_t i = 0; status == LUXEL_OK && i < count; i++)
        status = put_pixel(reader->source, axes, &pixels[i], loaded);
    free(pixels);
    return status;
}

luxel_status lx_csv_read(struct lx_source *source, struct lx_loaded *loaded)
{
    struct reader *reader = lx_new_array(1, sizeof *reader);
    if (!reader)
        return lx_source_out_of_memory(source);
    reader->source = source;
    reader->is_single = true;
    luxel_status status = read_table(reader, loaded);
    free(reader);
    return status;
}

/* SPDX-License-Identifier: MIT */
/* Reading clouds of points: CSV part by part, so that only the numbers stay in memory, and NPY. */
#include "cloud.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "lines.h"
#include "npy.h"

/* The longest line is as long as a part. */
enum { PART = 1 << 20, LONGEST_SHOWN = 40 };

static const struct lx_cloud_report GOOD = {.message = LX_MSG_COUNT};

void lx_cloud_free(struct lx_kept *kept)
{
    struct lx_cloud *cloud = (struct lx_cloud *)kept;
    free(cloud->values);
    lx_kept_slot_free(cloud->tree);
    free(cloud);
}

struct lx_cloud *lx_cloud_new(size_t count)
{
    struct lx_cloud *cloud = lx_new_array(1, sizeof *cloud);
    if (!cloud)
        return NULL;
    lx_kept_init(&cloud->kept, lx_cloud_free);
    cloud->count = count;
    cloud->values = lx_new_aligned(count, LX_CLOUD_COLUMNS * sizeof(double));
    if (cloud->values)
        return cloud;
    lx_cloud_free(&cloud->kept);
    return NULL;
}

/* ---- CSV ---- */

struct reader {
    struct lx_source *source;
    uint64_t offset; /* of what comes behind the part */
    char *part;
    size_t length; /* of the part; its whole lines are those of `lines` */
    struct lx_lines lines;
    char separator; /* ' ': blanks; 0: not known yet */
    struct lx_cloud *cloud;
    size_t capacity;
};

static struct lx_cloud_report wrong(enum lx_message message, const struct reader *reader)
{
    return (struct lx_cloud_report){.message = message, .number = reader->lines.line};
}

/* Moves the beginning of a line to the front and reads on behind it; false where the source is at its end. */
static bool read_part(struct reader *reader)
{
    const char *rest = reader->lines.end;
    size_t kept = (size_t)(reader->part + reader->length - rest);
    uint64_t left = lx_source_size(reader->source) - reader->offset;
    memmove(reader->part, rest, kept);
    size_t more = left < PART - kept ? (size_t)left : PART - kept;
    if (lx_source_read(reader->source, reader->offset, reader->part + kept, more) != LUXEL_OK || kept + more == 0)
        return false;
    reader->offset += more;
    reader->length = kept + more;
    const char *last = (const char *)memrchr(reader->part, '\n', reader->length);
    bool is_last = more == left;
    reader->lines.next = reader->part;
    reader->lines.end = reader->part + (is_last ? reader->length : last ? (size_t)(last - reader->part) + 1 : 0);
    return true;
}

/* The next line that is not blank; `*is_long`: there is one that no part holds. */
static bool next_line(struct reader *reader, bool *is_long)
{
    while (!lx_next_line(&reader->lines)) {
        *is_long = reader->length == PART && reader->lines.end == reader->part;
        if (*is_long || !read_part(reader))
            return false;
    }
    return true;
}

static void pass_blanks(struct lx_lines *lines)
{
    while (lines->at < lines->stop && lx_is_blank(*lines->at))
        lines->at++;
}

/* The next field of a line, without blanks around it, and the separator behind it unless it is the last one. */
static bool next_field(struct reader *reader, bool is_last, const char **field, size_t *length)
{
    struct lx_lines *lines = &reader->lines;
    pass_blanks(lines);
    *field = lines->at;
    while (lines->at < lines->stop && !lx_is_blank(*lines->at) && *lines->at != reader->separator)
        lines->at++;
    *length = (size_t)(lines->at - *field);
    pass_blanks(lines);
    if (is_last || reader->separator == ' ')
        return *length > 0;
    return *length > 0 && lines->at < lines->stop && *lines->at++ == reader->separator;
}

/* Whether a text begins with these letters, in either case. */
static bool has_letters(const char *text, const char *letters)
{
    for (; *letters; text++, letters++)
        if ((*text | 0x20) != *letters)
            return false;
    return true;
}

/* The separator of the first line, and whether this names the columns. */
static bool read_heading(struct reader *reader)
{
    static const char *const names[LX_CLOUD_COLUMNS] = {"x", "y", "z", "intensity"};
    struct lx_lines line = reader->lines;
    size_t size = (size_t)(line.stop - line.at), length;
    const char *field;
    reader->separator = memchr(line.at, ';', size) ? ';' : memchr(line.at, ',', size) ? ',' : ' ';
    bool names_all = true;
    for (size_t i = 0; names_all && i < LX_CLOUD_COLUMNS; i++)
        names_all = next_field(reader, i + 1 == LX_CLOUD_COLUMNS, &field, &length) && length == strlen(names[i]) &&
                    has_letters(field, names[i]);
    names_all = names_all && reader->lines.at == reader->lines.stop;
    reader->lines = line;
    return names_all;
}

/* Why a field is no number that may stand in a row. */
static struct lx_cloud_report judge_field(const struct reader *reader, const char *field, size_t length)
{
    struct lx_cloud_report report = wrong(LX_MSG_CLOUD_NUMBER, reader);
    size_t shown = length < LONGEST_SHOWN ? length : LONGEST_SHOWN;
    while (shown < length && shown > 0 && (field[shown] & 0xC0) == 0x80) /* within a character of several bytes */
        shown--;
    snprintf(report.text, sizeof report.text, "%.*s%s", (int)shown, field, shown < length ? "..." : "");
    const char *word = field + (*field == '-' || *field == '+');
    size_t left = length - (size_t)(word - field);
    bool is_name = left >= 3 && (has_letters(word, "nan") || has_letters(word, "inf"));
    if (is_name || lx_looks_like_number(field, length))
        report.message = LX_MSG_CLOUD_NOT_FINITE;
    return report;
}

static struct lx_cloud_report read_row(struct reader *reader)
{
    struct lx_cloud *cloud = reader->cloud;
    double row[LX_CLOUD_COLUMNS];
    for (size_t i = 0; i < LX_CLOUD_COLUMNS; i++) {
        const char *field;
        size_t length;
        bool is_there = next_field(reader, i + 1 == LX_CLOUD_COLUMNS, &field, &length);
        if (length > 0 && !lx_read_number(field, length, &row[i]))
            return judge_field(reader, field, length);
        if (!is_there)
            return wrong(LX_MSG_CLOUD_ROW, reader);
    }
    if (reader->lines.at < reader->lines.stop)
        return wrong(LX_MSG_CLOUD_ROW, reader);
    if (row[3] < 0)
        return wrong(LX_MSG_CLOUD_NEGATIVE, reader);
    if (cloud->count == LX_MOST_POINTS)
        return wrong(LX_MSG_CLOUD_TOO_LARGE, reader);
    if (lx_reserve(&cloud->values, &reader->capacity, cloud->count + 1, sizeof row) < 0)
        return wrong(LX_MSG_OUT_OF_MEMORY, reader);
    memcpy((double *)cloud->values + LX_CLOUD_COLUMNS * cloud->count++, row, sizeof row);
    return GOOD;
}

static struct lx_cloud_report read_lines(struct reader *reader)
{
    static const char mark[] = "\xef\xbb\xbf"; /* what some programs put before UTF-8 */
    struct lx_cloud_report report = GOOD;
    bool is_long = false;
    if (read_part(reader) && reader->length >= 3 && memcmp(reader->part, mark, 3) == 0)
        reader->lines.next += 3;
    while (report.message == LX_MSG_COUNT && next_line(reader, &is_long)) {
        bool is_heading = !reader->separator && read_heading(reader);
        if (!is_heading)
            report = read_row(reader);
    }
    if (report.message == LX_MSG_COUNT && is_long) {
        reader->lines.line++;
        return wrong(LX_MSG_CLOUD_ROW, reader);
    }
    bool is_whole = report.message == LX_MSG_COUNT && lx_source_status(reader->source) == LUXEL_OK;
    return is_whole && reader->cloud->count == 0 ? wrong(LX_MSG_CLOUD_EMPTY, reader) : report;
}

static struct lx_cloud_report read_csv(struct lx_source *source, struct lx_cloud *cloud)
{
    struct reader reader = {.source = source, .cloud = cloud, .part = lx_new_array(PART, 1)};
    if (!reader.part)
        return wrong(LX_MSG_OUT_OF_MEMORY, &reader);
    reader.lines.next = reader.lines.end = reader.part;
    struct lx_cloud_report report = read_lines(&reader);
    free(reader.part);
    size_t bytes = cloud->count * LX_CLOUD_COLUMNS * sizeof(double);
    void *fitting = bytes > 0 ? realloc(cloud->values, bytes) : NULL;
    if (fitting)
        cloud->values = fitting;
    return report;
}

/* ---- NPY ---- */

static struct lx_cloud_report say(enum lx_message message, const char *text)
{
    struct lx_cloud_report report = {.message = message};
    snprintf(report.text, sizeof report.text, "%s", text);
    return report;
}

static struct lx_cloud_report check_header(const struct lx_npy *npy, uint64_t size)
{
    if (npy->width == 0)
        return say(LX_MSG_CLOUD_DESCR, npy->descr);
    if (npy->columns != LX_CLOUD_COLUMNS)
        return say(LX_MSG_CLOUD_SHAPE, npy->shape);
    if (npy->rows == 0)
        return say(LX_MSG_CLOUD_EMPTY, "");
    if (npy->rows > LX_MOST_POINTS)
        return say(LX_MSG_CLOUD_TOO_LARGE, "");
    if (npy->start + (uint64_t)npy->rows * LX_CLOUD_COLUMNS * npy->width != size)
        return (struct lx_cloud_report){.message = LX_MSG_CLOUD_SIZE, .number = npy->rows};
    return GOOD;
}

static struct lx_cloud_report check_rows(const struct lx_cloud *cloud)
{
    for (size_t i = 0; i < cloud->count; i++) {
        double row[LX_CLOUD_COLUMNS];
        lx_cloud_row(cloud, i, row);
        if (!isfinite(row[0]) || !isfinite(row[1]) || !isfinite(row[2]) || !isfinite(row[3]))
            return (struct lx_cloud_report){.message = LX_MSG_CLOUD_ROW_NOT_FINITE, .number = i + 1};
        if (row[3] < 0)
            return (struct lx_cloud_report){.message = LX_MSG_CLOUD_ROW_NEGATIVE, .number = i + 1};
    }
    return GOOD;
}

static struct lx_cloud_report read_npy(struct lx_source *source, struct lx_cloud *cloud)
{
    struct lx_npy npy;
    const char *word = lx_npy_read_header(source, &npy);
    if (word)
        return say(LX_MSG_CLOUD_DAMAGED, word);
    if (lx_source_status(source) != LUXEL_OK)
        return GOOD;
    struct lx_cloud_report report = check_header(&npy, lx_source_size(source));
    if (report.message != LX_MSG_COUNT)
        return report;
    size_t numbers = (size_t)npy.rows * LX_CLOUD_COLUMNS;
    cloud->values = lx_new_array(numbers, npy.width);
    cloud->is_single = npy.width == sizeof(float);
    cloud->count = npy.rows;
    if (!cloud->values)
        return say(LX_MSG_OUT_OF_MEMORY, "");
    struct lx_loaded loaded = {.sample = cloud->is_single ? LX_SAMPLE_F32 : LX_SAMPLE_F64, .values = cloud->values};
    return lx_npy_read_numbers(source, &npy, &loaded) == LUXEL_OK ? check_rows(cloud) : GOOD;
}

/* ---- either ---- */

struct lx_cloud_report lx_cloud_read(struct lx_source *source, struct lx_cloud **result)
{
    struct lx_cloud *cloud = lx_new_array(1, sizeof *cloud);
    *result = NULL;
    if (!cloud)
        return say(LX_MSG_OUT_OF_MEMORY, "");
    lx_kept_init(&cloud->kept, lx_cloud_free);
    cloud->tree = lx_kept_slot_new();
    if (!cloud->tree) {
        lx_cloud_free(&cloud->kept);
        return say(LX_MSG_OUT_OF_MEMORY, "");
    }
    bool is_npy = lx_format_of_content(source) == &lx_format_npy;
    struct lx_cloud_report report = is_npy ? read_npy(source, cloud) : read_csv(source, cloud);
    if (report.message == LX_MSG_COUNT && lx_source_status(source) == LUXEL_OK)
        *result = cloud;
    else
        lx_cloud_free(&cloud->kept);
    return report;
}

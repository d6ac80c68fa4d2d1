/* SPDX-License-Identifier: MIT */
/*
 * NumPy's array file: a magic number, a Python dictionary that describes the array, and its bytes.  Written in version
 * 1.0 with the shape (rows, columns) in C order, so that numpy.load() gives row 0 first, little-endian on every host.
 * Read in versions 1 to 3, both orders of bytes and of axes.  Format: numpy.lib.format.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "format.h"
#include "npy.h"

#define MAGIC "\x93NUMPY"

enum { MAGIC_LENGTH = 6, ALIGNMENT = 64, PREFIX = 10, HEADER = 128, LONGEST_HEADER = 64 * 1024 };

static const char NAME[] = "NPY";

static size_t width_of(const struct lx_writer *writer)
{
    return writer->image.sample == LX_SAMPLE_F64 ? sizeof(double) : sizeof(float);
}

static void begin_npy(struct lx_writer *writer)
{
    const struct lx_image *image = &writer->image;
    size_t width = width_of(writer);
    char header[HEADER + 1];
    const char *third = image->channels == 3 ? ", 3" : "";
    int written = snprintf(header + PREFIX, sizeof header - PREFIX,
                           "{'descr': '<f%zu', 'fortran_order': False, 'shape': (%u, %u%s), }", width, image->rows,
                           image->columns, third);
    size_t used = PREFIX + (size_t)written;
    size_t length = (used + 1 + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT; /* 1: the line's end */

    memcpy(header, MAGIC "\x01\x00", 8);
    header[8] = (char)(length - PREFIX); /* of two bytes, little-endian; never above 255 here */
    header[9] = 0;
    memset(header + used, ' ', length - used);
    header[length - 1] = '\n';

    lx_sink_write(writer->sink, header, length);
    lx_reserve_numbers(writer, width);
}

static void add_npy(struct lx_writer *writer, const struct lx_image_strip *strip)
{
    lx_write_numbers(writer, strip, 0, strip->rows * lx_row_samples(&writer->image), width_of(writer));
}

/* The dictionary, read from left to right. */
struct header {
    const char *at;
    struct lx_npy *npy; /* what was read of it */
    bool has_order;
};

static void skip_space(struct header *header)
{
    header->at += strspn(header->at, " \t\n");
}

/* Passes a character, with space around it. */
static bool take(struct header *header, char expected)
{
    skip_space(header);
    if (*header->at != expected)
        return false;
    header->at++;
    skip_space(header);
    return true;
}

/* The fields of records, [('x', '<f8'), ...], cut to the buffer. */
static bool take_records(struct header *header, char *text, size_t size)
{
    const char *start = header->at;
    int depth = 0;
    do {
        depth += (*header->at == '[' || *header->at == '(') - (*header->at == ']' || *header->at == ')');
        if (*header->at++ == '\0')
            return false;
    } while (depth > 0);
    size_t length = (size_t)(header->at - start);
    bool fits = length < size;
    snprintf(text, size, "%.*s%s", (int)(fits ? length : size - 4), start, fits ? "" : "...");
    return true;
}

/* 'a text', cut to the buffer. */
static bool take_text(struct header *header, char *text, size_t size)
{
    char quote = *header->at;
    if (quote == '[')
        return take_records(header, text, size);
    if (quote != '\'' && quote != '"')
        return false;
    const char *end = strchr(header->at + 1, quote);
    if (!end)
        return false;
    snprintf(text, size, "%.*s", (int)(end - header->at - 1), header->at + 1);
    header->at = end + 1;
    return true;
}

static bool take_order(struct header *header)
{
    header->has_order = true;
    header->npy->fortran = strncmp(header->at, "True", 4) == 0;
    if (!header->npy->fortran && strncmp(header->at, "False", 5) != 0)
        return false;
    header->at += header->npy->fortran ? 4 : 5;
    return true;
}

/* A number that is cut where no picture is that large. */
static bool take_whole(struct header *header, unsigned *number)
{
    const char *start = header->at;
    *number = 0;
    for (; *header->at >= '0' && *header->at <= '9'; header->at++)
        *number = *number > 100000000 ? *number : 10 * *number + (unsigned)(*header->at - '0');
    header->at += header->at > start && *header->at == 'L'; /* a long number of Python 2 */
    return header->at > start;
}

/* (rows, columns), or a tuple of another length. */
static bool take_shape(struct header *header)
{
    const char *start = header->at;
    unsigned numbers[2] = {0}, count = 0, number = 0;
    if (!take(header, '('))
        return false;
    while (take_whole(header, &number)) {
        if (count < 2)
            numbers[count] = number;
        count++;
        if (!take(header, ','))
            break;
    }
    if (!take(header, ')'))
        return false;
    header->npy->rows = count == 2 ? numbers[0] : 0;
    header->npy->columns = count == 2 ? numbers[1] : 0;
    const char *end = (const char *)memrchr(start, ')', (size_t)(header->at - start)) + 1;
    snprintf(header->npy->shape, sizeof header->npy->shape, "%.*s", (int)(end - start), start);
    return true;
}

static bool take_dictionary(struct header *header)
{
    char key[16];
    if (!take(header, '{'))
        return false;
    while (*header->at != '}') {
        if (!take_text(header, key, sizeof key) || !take(header, ':'))
            return false;
        bool good = strcmp(key, "descr") == 0 ? take_text(header, header->npy->descr, sizeof header->npy->descr)
                    : strcmp(key, "fortran_order") == 0 ? take_order(header)
                    : strcmp(key, "shape") == 0         ? take_shape(header)
                                                        : false;
        if (!good || (!take(header, ',') && *header->at != '}'))
            return false;
    }
    header->at++;
    skip_space(header);
    return *header->at == '\0' && header->npy->descr[0] && header->npy->shape[0] && header->has_order;
}

/* What the type of the numbers says: what they are, their width and order of bytes. */
static void read_descr(struct lx_npy *npy)
{
    static const char *const kinds[] = {"f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "b1"};
    bool is_order = npy->descr[0] && strchr("<>=|", npy->descr[0]);
    const char *kind = npy->descr + is_order;
    npy->big_endian = npy->descr[0] == '>' || (npy->descr[0] == '=' && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(kinds[i], kind) == 0) {
            npy->kind = kind[0];
            npy->width = (size_t)(kind[1] - '0');
        }
    bool has_order = npy->descr[0] == '<' || npy->descr[0] == '>' || npy->descr[0] == '=';
    if (npy->width > 1 && !has_order)
        npy->width = 0;
    npy->sample = npy->width == 8 || (npy->width == 4 && npy->kind != 'f') ? LX_SAMPLE_F64 : LX_SAMPLE_F32;
}

const char *lx_npy_read_header(struct lx_source *source, struct lx_npy *npy)
{
    unsigned char prefix[12];
    *npy = (struct lx_npy){0};
    if (lx_source_size(source) < sizeof prefix)
        return "header";
    if (lx_source_read(source, 0, prefix, sizeof prefix) != LUXEL_OK)
        return NULL;
    size_t before = prefix[6] == 1 ? 10 : 12;
    size_t length = prefix[8] | (size_t)prefix[9] << 8;
    if (memcmp(prefix, MAGIC, MAGIC_LENGTH) != 0)
        return "\\x93NUMPY";
    if (prefix[6] < 1 || prefix[6] > 3)
        return "version";
    if (prefix[6] > 1)
        length |= (size_t)prefix[10] << 16 | (size_t)prefix[11] << 24;
    npy->start = before + length;
    if (length > LONGEST_HEADER || npy->start > lx_source_size(source))
        return "header";
    char *text = lx_new_array(length + 1, 1);
    if (!text) {
        lx_source_out_of_memory(source);
        return NULL;
    }
    struct header header = {.at = text, .npy = npy};
    bool is_good = lx_source_read(source, before, text, length) != LUXEL_OK || take_dictionary(&header);
    free(text);
    read_descr(npy);
    return is_good ? NULL : "header";
}

static luxel_status read_npy(struct lx_source *source, struct lx_loaded *loaded)
{
    struct lx_npy npy;
    const char *wrong = lx_npy_read_header(source, &npy);
    if (wrong)
        return lx_bad_file(source, NAME, wrong);
    if (lx_source_status(source) != LUXEL_OK)
        return lx_source_status(source);
    if (npy.width == 0)
        return lx_unfit_file(source, NAME, "descr", npy.descr, "<f2, <f4, <f8, <i1 - <i8, <u1 - <u8, |b1");
    if (npy.rows == 0 || npy.columns == 0)
        return lx_unfit_file(source, NAME, "shape", npy.shape, "shape (rows, columns)");
    loaded->rows = npy.rows;
    loaded->columns = npy.columns;
    loaded->sample = npy.sample;
    luxel_status status = lx_check_size(source, NAME, loaded, npy.width, npy.start);
    if (status == LUXEL_OK)
        status = lx_loaded_allocate(source, loaded);
    return status == LUXEL_OK ? lx_npy_read_numbers(source, &npy, loaded) : status;
}

/* ---- numbers ---- */

/* A float16, which a float32 holds exactly. */
static double half_value(uint64_t bits)
{
    unsigned exponent = bits >> 10 & 31, fraction = bits & 1023;
    double size = exponent == 31 ? (fraction ? (double)NAN : HUGE_VAL)
                  : exponent     ? ldexp(1024 + fraction, (int)exponent - 25)
                                 : ldexp(fraction, -24);
    return bits >> 15 & 1 ? -size : size;
}

static double value_of(const struct lx_npy *npy, uint64_t bits)
{
    unsigned unused = 64 - 8 * (unsigned)npy->width;
    switch (npy->kind) {
    case 'f': return half_value(bits);
    case 'i': return (double)((int64_t)(bits << unused) >> unused);
    case 'b': return bits != 0;
    default: return (double)bits;
    }
}

/* Whole numbers and float16: `count` from an offset on, to every `stride`-th place from place `first` on. */
static luxel_status convert(struct lx_source *source, const struct lx_npy *npy, uint64_t offset,
                            struct lx_loaded *loaded, size_t first, size_t stride, size_t count)
{
    enum { PART = 2048 };
    unsigned char bytes[PART * sizeof(uint64_t)];
    size_t width = npy->width;
    for (size_t done = 0; done < count;) {
        size_t part = count - done < PART ? count - done : PART;
        if (lx_source_read(source, offset + done * width, bytes, part * width) != LUXEL_OK)
            break;
        for (size_t i = 0; i < part; i++, done++) {
            uint64_t bits = 0;
            for (size_t byte = 0; byte < width; byte++)
                bits = bits << 8 | bytes[i * width + (npy->big_endian ? byte : width - 1 - byte)];
            double value = value_of(npy, bits);
            if (loaded->sample == LX_SAMPLE_F64)
                ((double *)loaded->values)[first + done * stride] = value;
            else
                ((float *)loaded->values)[first + done * stride] = (float)value;
        }
    }
    return lx_source_status(source);
}

luxel_status lx_npy_read_numbers(struct lx_source *source, const struct lx_npy *npy, struct lx_loaded *loaded)
{
    size_t columns = npy->columns, rows = npy->rows, lines = npy->fortran ? columns : 1;
    size_t count = rows * columns / lines, stride = npy->fortran ? columns : 1;
    bool is_plain = npy->kind == 'f' && npy->width > 2;
    for (size_t line = 0; line < lines; line++) {
        uint64_t offset = npy->start + line * count * npy->width;
        if (is_plain)
            lx_read_numbers(source, offset, npy->big_endian, loaded, line, stride, count);
        else
            convert(source, npy, offset, loaded, line, stride, count);
    }
    return lx_source_status(source);
}

const struct lx_format lx_format_npy = {
    .ending = ".npy",
    .name = NAME,
    .samples = LX_SAMPLE_F32 | LX_SAMPLE_F64,
    .magic = MAGIC,
    .magic_length = MAGIC_LENGTH,
    .begin = begin_npy,
    .add = add_npy,
    .read = read_npy,
};

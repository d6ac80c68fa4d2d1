/* SPDX-License-Identifier: MIT */
/*
 * NumPy's array file: a magic number, a Python dictionary that describes the array, and its bytes.  Written in version
 * 1.0 with the shape (rows, columns) in C order, so that numpy.load() gives row 0 first, little-endian on every host.
 * Read in versions 1 to 3, both orders of bytes and of axes.  Format: numpy.lib.format.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "format.h"

#define MAGIC "\x93NUMPY"

enum { MAGIC_LENGTH = 6, ALIGNMENT = 64, PREFIX = 10, HEADER = 128, LONGEST_HEADER = 64 * 1024 };

static const char NAME[] = "NPY";

static void write_npy(const struct lx_image *image, struct lx_sink *sink)
{
    size_t width = image->sample == LX_SAMPLE_F64 ? sizeof(double) : sizeof(float);
    char header[HEADER + 1];
    int written =
        snprintf(header + PREFIX, sizeof header - PREFIX,
                 "{'descr': '<f%zu', 'fortran_order': False, 'shape': (%u, %u), }", width, image->rows, image->columns);
    size_t used = PREFIX + (size_t)written;
    size_t length = (used + 1 + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT; /* 1: the line's end */

    memcpy(header, MAGIC "\x01\x00", 8);
    header[8] = (char)(length - PREFIX); /* of two bytes, little-endian; never above 255 here */
    header[9] = 0;
    memset(header + used, ' ', length - used);
    header[length - 1] = '\n';

    luxel_status status = lx_sink_write(sink, header, length);
    for (unsigned row = 0; row < image->rows && status == LUXEL_OK; row++)
        status = lx_write_row(image, row, width, sink);
}

/* The dictionary, read from left to right; what was read of it. */
struct header {
    const char *at;
    char descr[16], shape[32]; /* as they stand there, cut where they are too long */
    unsigned rows, columns;    /* 0: the shape is of another form */
    bool fortran, has_order;
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

/* 'a text', cut to the buffer. */
static bool take_text(struct header *header, char *text, size_t size)
{
    char quote = *header->at;
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
    header->fortran = strncmp(header->at, "True", 4) == 0;
    if (!header->fortran && strncmp(header->at, "False", 5) != 0)
        return false;
    header->at += header->fortran ? 4 : 5;
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
    header->rows = count == 2 ? numbers[0] : 0;
    header->columns = count == 2 ? numbers[1] : 0;
    const char *end = (const char *)memrchr(start, ')', (size_t)(header->at - start)) + 1;
    snprintf(header->shape, sizeof header->shape, "%.*s", (int)(end - start), start);
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
        bool good = strcmp(key, "descr") == 0           ? take_text(header, header->descr, sizeof header->descr)
                    : strcmp(key, "fortran_order") == 0 ? take_order(header)
                    : strcmp(key, "shape") == 0         ? take_shape(header)
                                                        : false;
        if (!good || (!take(header, ',') && *header->at != '}'))
            return false;
    }
    header->at++;
    skip_space(header);
    return *header->at == '\0' && header->descr[0] && header->shape[0] && header->has_order;
}

/* Finds out where the numbers begin, and reads the dictionary before them. */
static luxel_status read_header(struct lx_source *source, struct header *header, size_t *start)
{
    unsigned char prefix[12];
    luxel_status status = lx_source_read(source, 0, prefix, sizeof prefix);
    if (status != LUXEL_OK)
        return status;
    size_t before = prefix[6] == 1 ? 10 : 12;
    size_t length = prefix[8] | (size_t)prefix[9] << 8;
    if (memcmp(prefix, MAGIC, MAGIC_LENGTH) != 0)
        return lx_bad_file(source, NAME, "\\x93NUMPY");
    if (prefix[6] < 1 || prefix[6] > 3)
        return lx_bad_file(source, NAME, "version");
    if (prefix[6] > 1)
        length |= (size_t)prefix[10] << 16 | (size_t)prefix[11] << 24;
    if (length > LONGEST_HEADER)
        return lx_bad_file(source, NAME, "header");
    char *text = lx_new_array(length + 1, 1);
    if (!text)
        return lx_source_out_of_memory(source);
    status = lx_source_read(source, before, text, length);
    header->at = text;
    if (status == LUXEL_OK && !take_dictionary(header))
        status = lx_bad_file(source, NAME, "header");
    header->at = NULL;
    free(text);
    *start = before + length;
    return status;
}

static luxel_status read_npy(struct lx_source *source, struct lx_loaded *loaded)
{
    struct header header = {0};
    size_t start = 0;
    luxel_status status = read_header(source, &header, &start);
    if (status != LUXEL_OK)
        return status;
    const char *kind = header.descr + 1;
    bool big_endian = header.descr[0] == '>';
    if ((!big_endian && header.descr[0] != '<') || (strcmp(kind, "f4") != 0 && strcmp(kind, "f8") != 0))
        return lx_unfit_file(source, NAME, "descr", header.descr, "<f4, <f8, >f4, >f8");
    if (header.rows == 0 || header.columns == 0)
        return lx_unfit_file(source, NAME, "shape", header.shape, "shape (rows, columns)");
    loaded->rows = header.rows;
    loaded->columns = header.columns;
    loaded->sample = kind[1] == '8' ? LX_SAMPLE_F64 : LX_SAMPLE_F32;
    status = lx_check_size(source, NAME, loaded, start);
    if (status == LUXEL_OK)
        status = lx_loaded_allocate(source, loaded);
    size_t width = kind[1] == '8' ? sizeof(double) : sizeof(float), columns = header.columns, rows = header.rows;
    if (status == LUXEL_OK && !header.fortran)
        status = lx_read_numbers(source, start, big_endian, loaded, 0, 1, rows * columns);
    for (size_t column = 0; status == LUXEL_OK && header.fortran && column < columns; column++)
        status = lx_read_numbers(source, start + column * rows * width, big_endian, loaded, column, columns, rows);
    return status;
}

const struct lx_format lx_format_npy = {
    .ending = ".npy",
    .name = NAME,
    .samples = LX_SAMPLE_F32 | LX_SAMPLE_F64,
    .magic = MAGIC,
    .magic_length = MAGIC_LENGTH,
    .write = write_npy,
    .read = read_npy,
};

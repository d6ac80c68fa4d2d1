/* SPDX-License-Identifier: MIT */
/*
 * Each file format, read back by a reader that shares nothing with the writer.  The image is asymmetric in every
 * way, so that a turned, mirrored or shifted one cannot pass; row 0 is the top of the picture in every format.
 */
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "format/format.h"

enum { COLUMNS = 5, ROWS = 3, LARGEST = 1 << 20 };

struct folder {
    char path[64];
    char file[96];
    unsigned char bytes[LARGEST]; /* of the file that was read last */
    size_t length;
};

static int make_folder(void **state)
{
    struct folder *folder = calloc(1, sizeof *folder);

    strcpy(folder->path, "/tmp/luxel-formats-XXXXXX");
    *state = folder;
    return mkdtemp(folder->path) != NULL ? 0 : -1;
}

static int remove_folder(void **state)
{
    struct folder *folder = *state;

    unlink(folder->file);
    int error = rmdir(folder->path); /* fails if anything else was left in it */
    free(folder);
    return error;
}

static void read_file(struct folder *folder)
{
    FILE *file = fopen(folder->file, "rb");
    assert_non_null(file);
    folder->length = fread(folder->bytes, 1, LARGEST, file);
    fclose(file);
}

/* Writes an image to a file of this ending and reads its bytes. */
static void write_and_read(struct folder *folder, const char *ending, const struct lx_image *image)
{
    snprintf(folder->file, sizeof folder->file, "%s/image%s", folder->path, ending);
    assert_int_equal(lx_write_image(folder->file, image, NULL), LUXEL_OK);
    read_file(folder);
}

/* A value that tells its place, and needs all the digits of its type. */
static double value_at(unsigned row, unsigned column)
{
    return (1.0 + row) / 3.0 + 10.0 * column;
}

static void fill_single(float *values)
{
    for (unsigned i = 0; i < ROWS * COLUMNS; i++) {
        values[i] = (float)value_at(i / COLUMNS, i % COLUMNS);
    }
}

static void fill_double(double *values)
{
    for (unsigned i = 0; i < ROWS * COLUMNS; i++) {
        values[i] = value_at(i / COLUMNS, i % COLUMNS);
    }
}

/* Little-endian numbers, put together by arithmetic. */
static double read_single(const unsigned char *bytes)
{
    uint32_t bits = bytes[0] + 256u * (bytes[1] + 256u * (bytes[2] + 256u * bytes[3]));
    int exponent = (int)(bits >> 23 & 255);
    double fraction = (double)(bits & 0x7fffff);

    return (bits >> 31 ? -1 : 1) * (exponent == 0 ? ldexp(fraction, -149) : ldexp(fraction + 0x800000, exponent - 150));
}

static double read_double(const unsigned char *bytes)
{
    uint64_t bits = 0;

    for (int i = 7; i >= 0; i--) {
        bits = bits << 8 | bytes[i];
    }
    return (bits >> 63 ? -1 : 1) *
           ldexp((double)((bits & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52), (int)(bits >> 52 & 2047) - 1075);
}

/* ---- NPY ---- */

/* Checks the header; returns where the numbers begin. */
static const unsigned char *npy_numbers(const struct folder *folder, const char *dictionary, size_t width)
{
    const unsigned char *bytes = folder->bytes;
    size_t header = 10u + bytes[8] + 256u * bytes[9];

    assert_memory_equal(bytes, "\x93NUMPY\x01\x00", 8);
    assert_int_equal(header % 64, 0);
    assert_int_equal(bytes[header - 1], '\n');
    assert_memory_equal(bytes + 10, dictionary, strlen(dictionary));
    for (size_t i = 10 + strlen(dictionary); i < header - 1; i++) {
        assert_int_equal(bytes[i], ' ');
    }
    assert_int_equal(folder->length, header + width * ROWS * COLUMNS);
    return bytes + header;
}

static void test_npy_single(void **state)
{
    float values[ROWS * COLUMNS];
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F32, .data = values};

    fill_single(values);
    write_and_read(*state, ".npy", &image);
    const unsigned char *numbers =
        npy_numbers(*state, "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 5), }", 4);
    for (unsigned i = 0; i < ROWS * COLUMNS; i++) {
        assert_true(read_single(numbers + 4 * i) == (double)(float)value_at(i / COLUMNS, i % COLUMNS));
    }
}

static void test_npy_double(void **state)
{
    double values[ROWS * COLUMNS];
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F64, .data = values};

    fill_double(values);
    write_and_read(*state, ".npy", &image);
    const unsigned char *numbers =
        npy_numbers(*state, "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 5), }", 8);
    for (unsigned i = 0; i < ROWS * COLUMNS; i++) {
        assert_true(read_double(numbers + 8 * i) == value_at(i / COLUMNS, i % COLUMNS));
    }
}

/* ---- PFM ---- */

/* Checks header and numbers: the picture's bottom row comes first. */
static void assert_pfm(const struct folder *folder)
{
    static const char header[] = "Pf\n5 3\n-1.0\n";
    const unsigned char *numbers = folder->bytes + sizeof header - 1;

    assert_memory_equal(folder->bytes, header, sizeof header - 1);
    assert_int_equal(folder->length, sizeof header - 1 + 4 * ROWS * COLUMNS);
    for (unsigned i = 0; i < ROWS * COLUMNS; i++) {
        unsigned row = ROWS - 1 - i / COLUMNS;
        assert_true(read_single(numbers + 4 * i) == (double)(float)value_at(row, i % COLUMNS));
    }
}

static void test_pfm_single(void **state)
{
    float values[ROWS * COLUMNS];
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F32, .data = values};

    fill_single(values);
    write_and_read(*state, ".pfm", &image);
    assert_pfm(*state);
}

static void test_pfm_from_double(void **state)
{
    double values[ROWS * COLUMNS];
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F64, .data = values};

    fill_double(values);
    write_and_read(*state, ".pfm", &image);
    assert_pfm(*state);
}

/* Signs, the smallest and the largest numbers, in rows longer than what is turned into bytes at a time. */
static void test_nasty_numbers(void **state)
{
    struct folder *folder = *state;
    enum { WIDE = 1031 };
    static const float nasty[] = {0.0f, -1.5f, 1e-45f, 1.2e-38f, 3.4028235e38f, -7e-40f, 16777215.0f};
    float *values = malloc(2 * WIDE * sizeof *values);
    struct lx_image image = {.columns = WIDE, .rows = 2, .channels = 1, .sample = LX_SAMPLE_F32, .data = values};

    for (unsigned i = 0; i < 2 * WIDE; i++) {
        values[i] = nasty[i % 7];
    }
    write_and_read(folder, ".npy", &image);
    const unsigned char *numbers = folder->bytes + folder->length - 4 * 2 * WIDE;
    for (unsigned i = 0; i < 2 * WIDE; i++) {
        assert_true(read_single(numbers + 4 * i) == (double)nasty[i % 7]);
    }
    free(values);
}

/* ---- PNG ---- */

static uint8_t grey_at(unsigned row, unsigned column)
{
    return (uint8_t)(200 - 60 * row + 7 * column);
}

/* By libpng's simplified reader for the values, and by its place in the file for the kind. */
static void assert_png(const struct folder *folder, unsigned columns, unsigned rows)
{
    static const unsigned char grey8[] = {8, 0, 0, 0, 0}; /* depth, colour, compression, filter, interlace */
    png_image reader = {.version = PNG_IMAGE_VERSION};
    uint8_t *pixels = malloc((size_t)columns * rows);

    assert_memory_equal(folder->bytes, "\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    assert_memory_equal(folder->bytes + 24, grey8, sizeof grey8);
    assert_true(png_image_begin_read_from_memory(&reader, folder->bytes, folder->length));
    assert_int_equal(reader.width, columns);
    assert_int_equal(reader.height, rows);
    reader.format = PNG_FORMAT_GRAY;
    assert_true(png_image_finish_read(&reader, NULL, pixels, 0, NULL));
    for (size_t i = 0; i < (size_t)columns * rows; i++) {
        assert_int_equal(pixels[i], grey_at((unsigned)(i / columns), (unsigned)(i % columns)));
    }
    free(pixels);
}

static void png_of_size(struct folder *folder, unsigned columns, unsigned rows)
{
    uint8_t *values = malloc((size_t)columns * rows);
    struct lx_image image = {.columns = columns, .rows = rows, .channels = 1, .sample = LX_SAMPLE_U8, .data = values};

    for (size_t i = 0; i < (size_t)columns * rows; i++) {
        values[i] = grey_at((unsigned)(i / columns), (unsigned)(i % columns));
    }
    write_and_read(folder, ".PNG", &image);
    assert_png(folder, columns, rows);
    free(values);
}

static void test_png(void **state)
{
    png_of_size(*state, COLUMNS, ROWS);
    png_of_size(*state, 1, 1);
    png_of_size(*state, 65536, 2);
    png_of_size(*state, 3, 5000);
}

static void test_png_same_bytes(void **state)
{
    struct folder *folder = *state;

    png_of_size(folder, 300, 200);
    unsigned char *first = malloc(folder->length);
    size_t length = folder->length;
    memcpy(first, folder->bytes, length);
    memset(folder->bytes, 0, length);
    png_of_size(folder, 300, 200);
    assert_int_equal(folder->length, length);
    assert_memory_equal(folder->bytes, first, length);
    free(first);
}

/* ---- the table, and failures ---- */

static void assert_format(const char *path, const struct lx_format *expected)
{
    const struct lx_format *format = NULL;

    assert_int_equal(lx_find_format(path, NULL, &format), LUXEL_OK);
    assert_ptr_equal(format, expected);
}

static void test_endings(void **state)
{
    (void)state;
    assert_format("a.png", &lx_format_png);
    assert_format("some.folder/b.c.NpY", &lx_format_npy);
    assert_format("/x.npy/..pfm", &lx_format_pfm);
    assert_format("a.CSV", &lx_format_csv);
    assert_format("a.exr", &lx_format_exr);
}

static void test_unknown_endings(void **state)
{
    static const char *const paths[] = {"a.gif", "a", "a.png/b", ".png", "a.png.", "a.pngx", "", "png", "a.png "};
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    const struct lx_format *format = NULL;

    (void)state;
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        assert_int_equal(lx_find_format(paths[i], diagnostics, &format), LUXEL_ERROR_ARGUMENT);
        assert_null(format);
        assert_int_equal(luxel_diagnostics_count(diagnostics), i + 1);
        char *hint = luxel_diagnostics_hint(diagnostics, i, NULL, NULL);
        assert_string_equal(hint, "known extensions: .png, .npy, .pfm, .csv, .exr");
        luxel_text_free(hint);
    }
    char *text = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
    assert_non_null(strstr(text, ".gif"));
    luxel_text_free(text);
    luxel_diagnostics_free(diagnostics);
}

/* An image that a format cannot hold leaves no file. */
static void test_unfit_images(void **state)
{
    struct folder *folder = *state;
    double values[3] = {0};
    const struct lx_image unfit[] = {{.columns = 1, .rows = 1, .channels = 1, .sample = LX_SAMPLE_F32, .data = values},
                                     {.columns = 1, .rows = 1, .channels = 2, .sample = LX_SAMPLE_U8, .data = values},
                                     {.columns = 0, .rows = 1, .channels = 1, .sample = LX_SAMPLE_U8, .data = values}};

    snprintf(folder->file, sizeof folder->file, "%s/image.png", folder->path);
    for (size_t i = 0; i < sizeof unfit / sizeof unfit[0]; i++) {
        assert_int_equal(lx_write_image(folder->file, &unfit[i], NULL), LUXEL_ERROR_ARGUMENT);
        assert_int_not_equal(access(folder->file, F_OK), 0);
    }
}

/* Every format stops at a full disk, with one report. */
static void test_full_disk(void **state)
{
    static const char *const endings[] = {".png", ".npy", ".pfm", ".exr", ".csv"};
    static const enum lx_sample_type samples[] = {LX_SAMPLE_U8, LX_SAMPLE_F32, LX_SAMPLE_F64, LX_SAMPLE_F64,
                                                  LX_SAMPLE_F32};
    struct folder *folder = *state;
    double *values = calloc(300 * 300, sizeof *values);

    for (size_t i = 0; i < sizeof samples / sizeof samples[0]; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        struct lx_image image = {.columns = 300,
                                 .rows = 300,
                                 .channels = 1,
                                 .sample = samples[i],
                                 .data = values,
                                 .x_mm = values,
                                 .y_mm = values};

        snprintf(folder->file, sizeof folder->file, "%s/image%s", folder->path, endings[i]);
        assert_int_equal(symlink("/dev/full", folder->file), 0);
        assert_int_equal(lx_write_image(folder->file, &image, diagnostics), LUXEL_ERROR_FILE);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
        assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "file-not-written");
        luxel_diagnostics_free(diagnostics);
        assert_int_equal(unlink(folder->file), 0);
    }
    free(values);
}

/* Strips of any height make the same file as the image in one piece, and a file that is given up is none. */
static void test_strips(void **state)
{
    static const char *const endings[] = {".png", ".png", ".npy", ".npy", ".pfm", ".pfm", ".exr", ".exr", ".csv"};
    static const enum lx_sample_type samples[] = {LX_SAMPLE_U8,  LX_SAMPLE_U16, LX_SAMPLE_F32,
                                                  LX_SAMPLE_F64, LX_SAMPLE_F32, LX_SAMPLE_F64,
                                                  LX_SAMPLE_F32, LX_SAMPLE_F64, LX_SAMPLE_F64};
    static const size_t widths[] = {1, 2, 4, 8, 4, 8, 4, 8, 8};
    enum { HIGH = 11 };
    double values[HIGH * COLUMNS];
    uint8_t mask[HIGH * COLUMNS];
    struct folder *folder = *state;
    unsigned char *whole = malloc(LARGEST);

    for (unsigned i = 0; i < HIGH * COLUMNS; i++) {
        values[i] = value_at(i / COLUMNS, i % COLUMNS);
        mask[i] = i % 3 > 0;
    }
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        const struct lx_image image = {.columns = COLUMNS,
                                       .rows = HIGH,
                                       .channels = 1,
                                       .sample = samples[i],
                                       .data = values, /* or as numbers of another kind, whatever they are then */
                                       .mask = mask,
                                       .x_mm = values,
                                       .y_mm = values};
        write_and_read(folder, endings[i], &image);
        memcpy(whole, folder->bytes, folder->length);
        const size_t length = folder->length, row_size = widths[i] * COLUMNS;
        for (unsigned height = 1; height <= HIGH; height++) {
            struct lx_writer *writer = NULL;
            assert_int_equal(lx_writer_open(&(struct lx_destination){.path = folder->file}, &image, NULL, &writer),
                             LUXEL_OK);
            assert_true(lx_writer_takes_strips(writer));
            for (unsigned row = 0; row < HIGH; row += height) {
                const unsigned rows = HIGH - row < height ? HIGH - row : height;
                lx_writer_add(writer, &(struct lx_image_strip){row, rows, (const char *)values + row * row_size,
                                                               mask + row * COLUMNS});
            }
            assert_int_equal(lx_writer_commit(writer), LUXEL_OK);
            read_file(folder);
            assert_int_equal(folder->length, length);
            assert_memory_equal(folder->bytes, whole, length);
        }

        struct lx_writer *writer = NULL;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(unlink(folder->file), 0);
        assert_int_equal(lx_writer_open(&(struct lx_destination){.path = folder->file}, &image, diagnostics, &writer),
                         LUXEL_OK);
        lx_writer_add(writer, &(struct lx_image_strip){0, 2, values, mask});
        lx_writer_abort(writer);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 0);
        assert_int_not_equal(access(folder->file, F_OK), 0);
        luxel_diagnostics_free(diagnostics);
    }
    free(whole);
}

/* What runs from the bottom up goes to a device or a pipe only in one piece. */
static void test_strips_to_devices(void **state)
{
    static const char *const endings[] = {".png", ".npy", ".pfm", ".exr", ".csv"};
    struct folder *folder = *state;
    const double values[COLUMNS] = {0};

    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++) {
        const struct lx_image image = {.columns = COLUMNS,
                                       .rows = ROWS,
                                       .channels = 1,
                                       .sample = i == 0 ? LX_SAMPLE_U8 : LX_SAMPLE_F64,
                                       .x_mm = values,
                                       .y_mm = values};
        struct lx_writer *writer = NULL;
        snprintf(folder->file, sizeof folder->file, "%s/image%s", folder->path, endings[i]);
        assert_int_equal(symlink("/dev/null", folder->file), 0);
        assert_int_equal(lx_writer_open(&(struct lx_destination){.path = folder->file}, &image, NULL, &writer),
                         LUXEL_OK);
        assert_true(lx_writer_takes_strips(writer) == (strcmp(endings[i], ".pfm") != 0));
        lx_writer_abort(writer);
        assert_int_equal(unlink(folder->file), 0);
    }
}

/* A picture that libpng refuses is a failure that names the file, not the end of the process. */
static void test_png_refuses(void **state)
{
    struct folder *folder = *state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_image image = {
        .columns = UINT32_C(0x80000001), .rows = 1, .channels = 1, .sample = LX_SAMPLE_U8, .data = ""};

    snprintf(folder->file, sizeof folder->file, "%s/image.png", folder->path);
    assert_int_equal(lx_write_image(folder->file, &image, diagnostics), LUXEL_ERROR_FILE);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "png-failed");
    assert_int_not_equal(access(folder->file, F_OK), 0);
    luxel_diagnostics_free(diagnostics);
}

#define CASE(name) cmocka_unit_test_setup_teardown(test_##name, make_folder, remove_folder)

int main(void)
{
    const struct CMUnitTest tests[] = {
        CASE(npy_single), CASE(npy_double),     CASE(pfm_single),      CASE(pfm_from_double), CASE(nasty_numbers),
        CASE(png),        CASE(png_same_bytes), CASE(endings),         CASE(strips),          CASE(strips_to_devices),
        CASE(full_disk),  CASE(png_refuses),    CASE(unknown_endings), CASE(unfit_images),
    };

    return cmocka_run_group_tests_name("formats", tests, NULL, NULL);
}

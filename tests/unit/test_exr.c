/* SPDX-License-Identifier: MIT */
/*
 * EXR files of other programs, made with OpenEXR's own library: every compression and type of numbers that is read,
 * pictures that do not begin at 0, and those that no field can be read from.
 */
#include "files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <OpenEXR/openexr.h>

enum { COLUMNS = 45, ROWS = 37, PIXELS = COLUMNS * ROWS };

static const exr_compression_t LOSSLESS[] = {EXR_COMPRESSION_NONE, EXR_COMPRESSION_RLE, EXR_COMPRESSION_ZIPS,
                                             EXR_COMPRESSION_ZIP, EXR_COMPRESSION_PIZ};

struct kind {
    exr_compression_t compression;
    exr_pixel_type_t type;
    const char *channels[3]; /* NULL: no more */
    int x, y;                /* of the first pixel */
};

/* Small whole numbers: every type can hold them. */
static unsigned value_at(size_t i)
{
    return (unsigned)(i % COLUMNS < 20 ? i / COLUMNS : i * 37 % 1999);
}

/* 16 bits of a whole number below 2048. */
static uint16_t half_of(unsigned number)
{
    int exponent = 0;
    if (number == 0)
        return 0;
    double fraction = frexp((double)number, &exponent);
    return (uint16_t)((unsigned)(exponent + 14) << 10 | (unsigned)((fraction * 2 - 1) * 1024));
}

static void *numbers_of(exr_pixel_type_t type)
{
    void *numbers = calloc(PIXELS, 4);
    for (size_t i = 0; i < PIXELS; i++) {
        if (type == EXR_PIXEL_HALF)
            ((uint16_t *)numbers)[i] = half_of(value_at(i));
        else if (type == EXR_PIXEL_UINT)
            ((uint32_t *)numbers)[i] = value_at(i);
        else
            ((float *)numbers)[i] = (float)value_at(i) / 8;
    }
    return numbers;
}

static void write_picture(exr_context_t context, const struct kind *kind, uint8_t *numbers)
{
    int width = kind->type == EXR_PIXEL_HALF ? 2 : 4;
    exr_encode_pipeline_t pipeline = {0};
    exr_chunk_info_t chunk;
    int lines = 1;

    exr_get_scanlines_per_chunk(context, 0, &lines);
    for (int row = 0; row < ROWS; row += lines) {
        assert_int_equal(exr_write_scanline_chunk_info(context, 0, kind->y + row, &chunk), 0);
        if (row == 0)
            assert_int_equal(exr_encoding_initialize(context, 0, &chunk, &pipeline), 0);
        else
            assert_int_equal(exr_encoding_update(context, 0, &chunk, &pipeline), 0);
        for (int i = 0; i < pipeline.channel_count; i++) {
            pipeline.channels[i].encode_from_ptr = numbers + row * COLUMNS * width;
            pipeline.channels[i].user_bytes_per_element = (int16_t)width;
            pipeline.channels[i].user_data_type = (uint16_t)kind->type;
            pipeline.channels[i].user_pixel_stride = width;
            pipeline.channels[i].user_line_stride = COLUMNS * width;
        }
        if (row == 0)
            assert_int_equal(exr_encoding_choose_default_routines(context, 0, &pipeline), 0);
        assert_int_equal(exr_encoding_run(context, 0, &pipeline), 0);
    }
    exr_encoding_destroy(context, &pipeline);
}

/* `preview` NULL: without one. */
static void make_exr_with(struct files *files, const struct kind *kind, const exr_attr_preview_t *preview)
{
    exr_context_t context = NULL;
    int part = 0;
    exr_attr_box2i_t window = {{.x = kind->x, .y = kind->y}, {.x = kind->x + COLUMNS - 1, .y = kind->y + ROWS - 1}};
    exr_attr_v2f_t center = {.x = 0, .y = 0};
    void *numbers = numbers_of(kind->type);

    snprintf(files->path, sizeof files->path, "%s/a.exr", files->folder);
    assert_int_equal(exr_start_write(&context, files->path, EXR_WRITE_FILE_DIRECTLY, NULL), 0);
    assert_int_equal(exr_add_part(context, NULL, EXR_STORAGE_SCANLINE, &part), 0);
    assert_int_equal(exr_initialize_required_attr(context, 0, &window, &window, 1, &center, 1,
                                                  EXR_LINEORDER_INCREASING_Y, kind->compression),
                     0);
    for (size_t i = 0; i < 3 && kind->channels[i]; i++)
        assert_int_equal(exr_add_channel(context, 0, kind->channels[i], kind->type, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1),
                         0);
    if (preview)
        assert_int_equal(exr_attr_set_preview(context, 0, "preview", preview), 0);
    assert_int_equal(exr_write_header(context), 0);
    write_picture(context, kind, numbers);
    assert_int_equal(exr_finish(&context), 0);
    free(numbers);
}

static void make_exr(struct files *files, const struct kind *kind)
{
    make_exr_with(files, kind, NULL);
}

static void test_kinds(void **state)
{
    struct files *files = *state;
    static const exr_pixel_type_t types[] = {EXR_PIXEL_FLOAT, EXR_PIXEL_HALF, EXR_PIXEL_UINT};

    for (size_t i = 0; i < 15; i++) {
        struct kind kind = {
            LOSSLESS[i % 5], types[i / 5], {i % 2 ? "R" : "Y"}, i % 3 == 0 ? -20 : 7, i % 3 == 1 ? 11 : -300};
        struct lx_loaded loaded = {0};
        make_exr(files, &kind);
        assert_int_equal(lx_read_image(files->path, NULL, &loaded), LUXEL_OK);
        assert_int_equal(loaded.columns, COLUMNS);
        assert_int_equal(loaded.rows, ROWS);
        assert_int_equal(loaded.sample, LX_SAMPLE_F32);
        for (size_t k = 0; k < PIXELS; k++)
            assert_true(((float *)loaded.values)[k] == (float)value_at(k) / (kind.type == EXR_PIXEL_FLOAT ? 8 : 1));
        lx_loaded_clear(&loaded);
    }
}

static void test_refused(void **state)
{
    struct files *files = *state;
    struct kind colour = {EXR_COMPRESSION_ZIP, EXR_PIXEL_HALF, {"B", "G", "R"}, 0, 0};
    struct kind lossy = {EXR_COMPRESSION_PXR24, EXR_PIXEL_FLOAT, {"Y"}, 0, 0};

    make_exr(files, &colour);
    assert_refused(files, LUXEL_ERROR_FILE, "unfit-file");
    make_exr(files, &lossy);
    assert_refused(files, LUXEL_ERROR_FILE, "unfit-file");
}

static size_t find(const unsigned char *bytes, size_t length, const char *text)
{
    const unsigned char *found = memmem(bytes, length, text, strlen(text));
    assert_non_null(found);
    return (size_t)(found - bytes);
}

/* A header that says other things than the file holds. */
static void test_false_headers(void **state)
{
    struct files *files = *state;
    struct kind kind = {EXR_COMPRESSION_ZIP, EXR_PIXEL_FLOAT, {"Y"}, 0, 0};
    size_t length;

    make_exr(files, &kind);
    unsigned char *bytes = file_bytes(files->path, &length);
    size_t window = find(bytes, length, "dataWindow") + 21;
    bytes[window + 10] = 1; /* 65536 more columns */
    make_file(files, "b.exr", bytes, length);
    assert_refused(files, LUXEL_ERROR_FILE, "too-many-pixels");
    bytes[window + 10] = 0;
    bytes[window + 9] = bytes[window + 13] = 0xfe; /* far more than the file could hold */
    make_file(files, "b.exr", bytes, length);
    assert_refused(files, LUXEL_ERROR_FILE, "file-ends");
    bytes[window + 9] = bytes[window + 13] = 0;
    bytes[window + 3] = 0x80; /* begins at -2147483648 */
    make_file(files, "b.exr", bytes, length);
    assert_refused(files, LUXEL_ERROR_FILE, "unfit-file");
    bytes[window + 3] = 0;
    bytes[window] = 200; /* ends before it begins */
    make_file(files, "b.exr", bytes, length);
    assert_refused(files, LUXEL_ERROR_FILE, "bad-file");
    bytes[window] = 0;
    bytes[5] = 2; /* tiles */
    make_file(files, "b.exr", bytes, length);
    assert_refused(files, LUXEL_ERROR_FILE, "exr-storage");
    bytes[5] = 0;
    make_file(files, "b.exr", bytes, length - 1);
    assert_refused(files, LUXEL_ERROR_FILE, "bad-file");
    bytes[length - 20] ^= 0x55; /* within the compressed numbers */
    make_file(files, "b.exr", bytes, length);
    assert_refused(files, LUXEL_ERROR_FILE, "bad-file");
    free(bytes);
}

/* Each end of a window may lie 2^30 from the origin and no farther. */
static void test_far_windows(void **state)
{
    static const struct {
        int32_t value;
        const char *low, *high; /* of the first two numbers, and of the others */
    } cases[] = {{(1 << 30) + 1, "unfit-file", "unfit-file"},
                 {-(1 << 30) - 1, "unfit-file", "unfit-file"},
                 {1 << 30, "bad-file", "too-many-pixels"},
                 {-(1 << 30), "too-many-pixels", "bad-file"}};
    struct files *files = *state;
    struct kind kind = {EXR_COMPRESSION_ZIP, EXR_PIXEL_FLOAT, {"Y"}, 0, 0};
    size_t length;

    make_exr(files, &kind);
    unsigned char *bytes = file_bytes(files->path, &length), whole[4];
    size_t window = find(bytes, length, "dataWindow") + 21;
    for (size_t end = 0; end < 4; end++)
        for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
            memcpy(whole, bytes + window + 4 * end, sizeof whole);
            for (int k = 0; k < 4; k++)
                bytes[window + 4 * end + (size_t)k] = (unsigned char)((uint32_t)cases[i].value >> (8 * k));
            make_file(files, "b.exr", bytes, length);
            assert_refused(files, LUXEL_ERROR_FILE, end < 2 ? cases[i].low : cases[i].high);
            memcpy(bytes + window + 4 * end, whole, sizeof whole);
        }
    free(bytes);
}

/* A preview is passed over where its size is that of its pixels. */
static void test_previews(void **state)
{
    struct files *files = *state;
    const struct kind kind = {EXR_COMPRESSION_ZIP, EXR_PIXEL_FLOAT, {"Y"}, 0, 0};
    static const uint8_t pixels[4 * 3 * 2] = {1, 2, 3, 4};
    const exr_attr_preview_t preview = {.width = 3, .height = 2, .rgba = pixels};
    struct lx_loaded loaded = {0};
    size_t length;
    make_exr_with(files, &kind, &preview);
    assert_int_equal(lx_read_image(files->path, NULL, &loaded), LUXEL_OK);
    assert_true(loaded.columns == COLUMNS && loaded.rows == ROWS);
    lx_loaded_clear(&loaded);

    unsigned char *bytes = file_bytes(files->path, &length);
    size_t width = find(bytes, length, "preview") + 2 * sizeof "preview" + 4; /* behind name, type and size */
    assert_int_equal(bytes[width], 3);
    static const unsigned char wrong[][2] = {{0, 4}, {1, 1}, {2, 1}, {3, 0x80}, {4, 3}, {7, 0xff}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        unsigned char *changed = &bytes[width + wrong[i][0]], right = *changed;
        *changed = wrong[i][1];
        make_file(files, "b.exr", bytes, length);
        assert_refused(files, LUXEL_ERROR_FILE, "bad-file");
        *changed = right;
    }
    free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {FILES_CASE(kinds), FILES_CASE(refused), FILES_CASE(false_headers),
                                       FILES_CASE(far_windows), FILES_CASE(previews)};

    return cmocka_run_group_tests_name("exr", tests, NULL, NULL);
}

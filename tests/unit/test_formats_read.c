/* SPDX-License-Identifier: MIT */
/*
 * Reading arrays of numbers: what each format wrote comes back bit for bit, files of other programs are read as they
 * mean it, and everything else is refused with one message, before any room is made for it.
 */
#include "files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 37, ROWS = 21, PIXELS = COLUMNS * ROWS };

static const float NASTY[] = {0.1f, 1.0f / 3, 1e-45f, 1.17549435e-38f, 3.40282347e38f, 16777217.0f, 123456789.0f, 2.5f};

static float single_at(size_t i)
{
    return NASTY[i % 8] / (i % 8 < 2 ? (float)(i + 1) : 1);
}

static double double_at(size_t i)
{
    return (i % 5 == 0 ? 5e-324 : i % 7 == 0 ? 1.7976931348623157e308 : 1.0 / 3) / (i % 7 == 0 ? 1 : (double)(i + 1));
}

static void fill(float *singles, double *doubles)
{
    for (size_t i = 0; i < PIXELS; i++) {
        singles[i] = single_at(i);
        doubles[i] = double_at(i);
    }
}

/* ---- round trips ---- */

static void assert_comes_back(struct files *files, const char *name, const struct lx_image *image)
{
    struct lx_loaded loaded;
    size_t width = image->sample == LX_SAMPLE_F64 ? sizeof(double) : sizeof(float);

    write_and_read(files, name, image, &loaded);
    assert_int_equal(loaded.columns, image->columns);
    assert_int_equal(loaded.rows, image->rows);
    assert_int_equal(loaded.sample, image->sample);
    assert_memory_equal(loaded.values, image->data, image->columns * image->rows * width);
    lx_loaded_clear(&loaded);
}

static void test_round_trips(void **state)
{
    float singles[PIXELS];
    double doubles[PIXELS];
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F32, .data = singles};

    fill(singles, doubles);
    assert_comes_back(*state, "a.npy", &image);
    assert_comes_back(*state, "a.pfm", &image);
    assert_comes_back(*state, "a.exr", &image);
    image.columns = 1;
    assert_comes_back(*state, "b.exr", &image);
    image.columns = PIXELS;
    image.rows = 1;
    assert_comes_back(*state, "c.exr", &image);
    image =
        (struct lx_image){.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F64, .data = doubles};
    assert_comes_back(*state, "a.npy", &image);
}

/* EXR of float64 is rounded to float32. */
static void test_exr_from_double(void **state)
{
    double doubles[PIXELS];
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F64, .data = doubles};
    struct lx_loaded loaded;

    for (size_t i = 0; i < PIXELS; i++)
        doubles[i] = (double)i / 7;
    write_and_read(*state, "a.exr", &image, &loaded);
    assert_int_equal(loaded.sample, LX_SAMPLE_F32);
    for (size_t i = 0; i < PIXELS; i++)
        assert_true(((float *)loaded.values)[i] == (float)doubles[i]);
    lx_loaded_clear(&loaded);
}

/* A file is known by its content: another name does not matter. */
static void test_renamed(void **state)
{
    struct files *files = *state;
    static const char *const names[] = {"a.npy", "a.pfm", "a.exr"};
    float singles[PIXELS];
    double doubles[PIXELS];
    struct lx_image image = {.columns = COLUMNS, .rows = ROWS, .channels = 1, .sample = LX_SAMPLE_F32, .data = singles};

    fill(singles, doubles);
    for (size_t i = 0; i < 3; i++) {
        struct lx_loaded loaded = {0};
        size_t length;
        snprintf(files->path, sizeof files->path, "%s/%s", files->folder, names[i]);
        assert_int_equal(lx_write_image(files->path, &image, NULL), LUXEL_OK);
        unsigned char *bytes = file_bytes(files->path, &length);
        make_file(files, "other.csv", bytes, length);
        assert_int_equal(lx_read_image(files->path, NULL, &loaded), LUXEL_OK);
        assert_memory_equal(loaded.values, singles, sizeof singles);
        lx_loaded_clear(&loaded);
        free(bytes);
    }
}

/* ---- CSV ---- */

static void make_places(double *x, double *y)
{
    for (unsigned i = 0; i < COLUMNS; i++)
        x[i] = -166.7 / 2 + 166.7 * i / (COLUMNS - 1);
    for (unsigned i = 0; i < ROWS; i++)
        y[i] = 94.1 / 2 - 94.1 * i / (ROWS - 1);
}

/* A hole, a border and a missing column and row within: the grid around the pixels comes back. */
static bool is_on(size_t i)
{
    size_t row = i / COLUMNS, column = i % COLUMNS;
    return row >= 2 && row < 19 && column >= 3 && column < 30 && column != 11 && row != 7 && i % 13 != 4;
}

/* Places are written with 12 digits. */
static void assert_same_place(double found, double expected)
{
    assert_true(fabs(found - expected) <= 1e-11 * fabs(expected));
}

static void assert_table(struct lx_loaded *loaded, const struct lx_image *image)
{
    assert_int_equal(loaded->columns, 27);
    assert_int_equal(loaded->rows, 17);
    assert_int_equal(loaded->sample, image->sample);
    for (unsigned row = 0; row < 17; row++)
        for (unsigned column = 0; column < 27; column++) {
            size_t from = (row + 2) * COLUMNS + column + 3, to = row * 27 + column;
            assert_int_equal(loaded->mask[to], is_on(from));
            if (image->sample == LX_SAMPLE_F64)
                assert_true(((double *)loaded->values)[to] == (is_on(from) ? double_at(from) : 0));
            else
                assert_true(((float *)loaded->values)[to] == (is_on(from) ? single_at(from) : 0));
            if (is_on(from)) {
                assert_same_place(loaded->x_mm[column], image->x_mm[column + 3]);
                assert_same_place(loaded->y_mm[row], image->y_mm[row + 2]);
            }
        }
}

static void test_csv(void **state)
{
    static const char *const units[] = {"W/(sr·m²)", "a \"quoted\", unit", ""};
    float singles[PIXELS];
    double doubles[PIXELS], x[COLUMNS], y[ROWS];
    uint8_t mask[PIXELS];

    fill(singles, doubles);
    make_places(x, y);
    for (size_t i = 0; i < PIXELS; i++)
        mask[i] = is_on(i);
    for (size_t i = 0; i < 6; i++) {
        struct lx_image image = {.columns = COLUMNS,
                                 .rows = ROWS,
                                 .channels = 1,
                                 .mask = mask,
                                 .x_mm = x,
                                 .y_mm = y,
                                 .sample = i % 2 ? LX_SAMPLE_F64 : LX_SAMPLE_F32,
                                 .unit = units[i / 2],
                                 .data = i % 2 ? (const void *)doubles : singles};
        struct lx_loaded loaded;
        write_and_read(*state, "a.csv", &image, &loaded);
        assert_string_equal(loaded.unit, units[i / 2]);
        assert_table(&loaded, &image);
        lx_loaded_clear(&loaded);
    }
}

static void test_csv_text(void **state)
{
    struct files *files = *state;
    float values[] = {1.5f, 0.1f, 0, -2e-9f};
    uint8_t mask[] = {1, 1, 0, 1};
    double x[] = {-0.25, 0.1}, y[] = {1e-7, -300};
    struct lx_image image = {.columns = 2,
                             .rows = 2,
                             .channels = 1,
                             .sample = LX_SAMPLE_F32,
                             .data = values,
                             .mask = mask,
                             .x_mm = x,
                             .y_mm = y,
                             .unit = "cd/m²"};
    struct lx_loaded loaded;
    size_t length;

    write_and_read(files, "a.csv", &image, &loaded);
    lx_loaded_clear(&loaded);
    unsigned char *bytes = file_bytes(files->path, &length);
    bytes[length] = 0;
    assert_string_equal((char *)bytes,
                        "x_mm,y_mm,value_cd/m²\n-0.25,1e-07,1.5\n0.1,1e-07,0.100000001\n0.1,-300,-1.99999994e-09\n");
    free(bytes);
}

static void make_text(struct files *files, const char *text)
{
    make_file(files, "a.csv", text, strlen(text));
}

/* What spreadsheets make of it. */
static void test_csv_of_others(void **state)
{
    static const char text[] = "\xef\xbb\xbf\"x_mm\",\"y_mm\",\"value_lx\"\r\n"
                               "10,5,1\r\n\r\n\"30\",-5,2.50\r\n10,-5,-3e2\r\n50,5,inf";
    struct files *files = *state;
    struct lx_loaded loaded = {0};

    make_text(files, text);
    assert_int_equal(lx_read_image(files->path, NULL, &loaded), LUXEL_OK);
    assert_int_equal(loaded.columns, 3);
    assert_int_equal(loaded.rows, 2);
    assert_int_equal(loaded.sample, LX_SAMPLE_F64);
    static const double values[] = {1, 0, HUGE_VAL, -300, 2.5, 0};
    static const uint8_t mask[] = {1, 0, 1, 1, 1, 0};
    assert_memory_equal(loaded.values, values, sizeof values);
    assert_memory_equal(loaded.mask, mask, sizeof mask);
    assert_true(loaded.x_mm[1] == 30 && loaded.y_mm[0] == 5 && loaded.y_mm[1] == -5);
    assert_string_equal(loaded.unit, "lx");
    lx_loaded_clear(&loaded);
}

/* One table in many ways of writing. */
static void test_csv_dialects(void **state)
{
    static const struct {
        const char *text;
        size_t length;
    } cases[] = {
#define CASE(text_) {text_, sizeof text_ - 1}
        CASE("x_mm, y_mm, value_lx\n0, 10, 1.5\n 10, 10, inf\n"),
        CASE("x_mm;y_mm;value_lx\r\n0;10;1,5\r\n10;10;inf\r\n"),
        CASE("sep=;\nx_mm;y_mm;value_lx;\n0;10;1,5;\n10;10;inf;\n;;;\n"),
        CASE("x_mm\ty_mm\tvalue_lx\r0\t10\t1,5\r10\t10\tInf"),
        CASE("x_mm y_mm value_lx\n0   10 1.5 # first\n# none\n10 10 inf\n"),
        CASE(",value (lx),Y [cm],\"x, m\"\n0,1.5,1,0\n1,inf,1,\"0,01\"\n"),
        CASE("\xff\xfex\0;\0y\0;\0v\0a\0l\0u\0e\0_\0l\0x\0\n\0"
             "0\0;\0"
             "1\0"
             "0\0;\0"
             "1\0,\0"
             "5\0\n\0"
             "1\0"
             "0\0;\0"
             "1\0"
             "0\0;\0i\0n\0f\0"),
#undef CASE
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct files *files = *state;
        struct lx_loaded loaded = {0};
        make_file(files, "a.csv", cases[i].text, cases[i].length);
        if (lx_read_image(files->path, NULL, &loaded) != LUXEL_OK)
            fail_msg("refused: %s", cases[i].text);
        assert_true(loaded.columns == 2 && loaded.rows == 1 && loaded.sample == LX_SAMPLE_F32);
        assert_true(loaded.x_mm[0] == 0 && loaded.x_mm[1] == 10 && loaded.y_mm[0] == 10);
        assert_true(((float *)loaded.values)[0] == 1.5f && isinf(((float *)loaded.values)[1]));
        assert_string_equal(loaded.unit, "lx");
        lx_loaded_clear(&loaded);
    }
}

static void test_csv_refused(void **state)
{
#define HEADING "x_mm,y_mm,value_lx\n"
    static const char *const cases[][2] = {
        {"", "csv-empty"},
        {"x,y,values\n1,2,3\n", "csv-header"},
        {"x_mm,y_mm\n1,2\n", "csv-header"},
        {HEADING, "csv-empty"},
        {HEADING "1,2\n", "csv-line"},
        {HEADING "1,2,3,4\n", "csv-line"},
        {HEADING "1,2,three\n", "csv-line"},
        {HEADING "1,2,1e999\n", "csv-line"},
        {HEADING "1,2,\n", "csv-line"},
        {HEADING "1,2,\"3\n", "csv-line"},
        {HEADING "1,2,\"3\"4\n", "csv-line"},
        {HEADING "0,0,1\n1,0,1\n2.5,0,1\n", "csv-no-grid"},
        {HEADING "0,0,1\n1e-9,0,1\n1,0,1\n", "csv-no-grid"},
        {HEADING "0,0,1\n1,1,1\n65535,65535,1\n", "csv-no-grid"},
        {HEADING "0,0,1\n1,0,1\n0,0,1\n", "csv-doubled"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        make_text(*state, cases[i][0]);
        assert_refused(*state, LUXEL_ERROR_FILE, cases[i][1]);
    }
}

/* ---- NPY ---- */

static void make_npy(struct files *files, unsigned version, const char *dictionary, const void *data, size_t size)
{
    unsigned char bytes[4096] = "\x93NUMPY";
    size_t length = strlen(dictionary), at = version == 1 ? 10 : 12;

    bytes[6] = (unsigned char)version;
    bytes[8] = (unsigned char)(length & 255);
    bytes[9] = (unsigned char)(length >> 8);
    memcpy(bytes + at, dictionary, length);
    memcpy(bytes + at + length, data, size);
    make_file(files, "a.npy", bytes, at + length + size);
}

static void assert_six(const struct files *files, enum lx_sample_type sample)
{
    struct lx_loaded loaded = {0};

    assert_int_equal(lx_read_image(files->path, NULL, &loaded), LUXEL_OK);
    assert_int_equal(loaded.rows, 2);
    assert_int_equal(loaded.columns, 3);
    assert_int_equal(loaded.sample, sample);
    for (size_t i = 0; i < 6; i++) {
        double value = sample == LX_SAMPLE_F64 ? ((double *)loaded.values)[i] : (double)((float *)loaded.values)[i];
        assert_true(value == 1.25 * (double)(i + 1));
    }
    lx_loaded_clear(&loaded);
}

/* 1.25 .. 7.5 as bytes of any kind, row by row or column by column. */
static size_t six(size_t width, bool big_endian, bool fortran, unsigned char *bytes)
{
    for (size_t i = 0; i < 6; i++) {
        double value = 1.25 * (double)((fortran ? i / 2 + 3 * (i % 2) : i) + 1);
        float single = (float)value;
        uint64_t bits = 0;
        memcpy(&bits, width == 8 ? (void *)&value : (void *)&single, width);
        for (size_t byte = 0; byte < width; byte++)
            bytes[i * width + (big_endian ? width - 1 - byte : byte)] = (unsigned char)(bits >> (8 * byte));
    }
    return 6 * width;
}

static void test_npy_kinds(void **state)
{
    unsigned char bytes[64];
    char dictionary[200];

    for (unsigned i = 0; i < 8; i++) {
        size_t width = i & 1 ? 8 : 4, size = six(width, i & 2, i & 4, bytes);
        snprintf(dictionary, sizeof dictionary, "{'descr': '%cf%zu', 'fortran_order': %s, 'shape': (2, 3), }  \n",
                 i & 2 ? '>' : '<', width, i & 4 ? "True" : "False");
        make_npy(*state, 1 + i % 3, dictionary, bytes, size);
        assert_six(*state, width == 8 ? LX_SAMPLE_F64 : LX_SAMPLE_F32);
    }
    make_npy(*state, 2, "{\"shape\":(2L,3L),\"fortran_order\":False,\"descr\":\"<f4\"}", bytes,
             six(4, false, false, bytes));
    assert_six(*state, LX_SAMPLE_F32);
}

/* Whole numbers of every width, float16 and truth, in both orders of bytes and of axes. */
static void test_npy_others(void **state)
{
    static const struct {
        const char *kind;
        enum lx_sample_type sample;
        uint64_t bits[6];
        double values[6];
    } cases[] = {
        {"i1", LX_SAMPLE_F32, {0, 1, 127, 0x80, 0xFF, 5}, {0, 1, 127, -128, -1, 5}},
        {"u1", LX_SAMPLE_F32, {0, 1, 127, 0x80, 0xFF, 5}, {0, 1, 127, 128, 255, 5}},
        {"b1", LX_SAMPLE_F32, {0, 1, 1, 0, 0, 1}, {0, 1, 1, 0, 0, 1}},
        {"i2", LX_SAMPLE_F32, {0, 258, 0x7FFF, 0x8000, 0xFFFE, 5}, {0, 258, 32767, -32768, -2, 5}},
        {"u2", LX_SAMPLE_F32, {0, 258, 0x7FFF, 0x8000, 0xFFFE, 5}, {0, 258, 32767, 32768, 65534, 5}},
        {"i4", LX_SAMPLE_F64, {0, 16777217, 0x80000000, 0xFFFFFFFF, 1, 5}, {0, 16777217, -2147483648.0, -1, 1, 5}},
        {"u4", LX_SAMPLE_F64, {0, 16777217, 0x80000000, 0xFFFFFFFF, 1, 5}, {0, 16777217, 0x1p31, 4294967295.0, 1, 5}},
        {"i8", LX_SAMPLE_F64, {0, UINT64_MAX, UINT64_C(1) << 63, 1, 2, 5}, {0, -1, -0x1p63, 1, 2, 5}},
        {"u8", LX_SAMPLE_F64, {0, UINT64_C(1) << 53, UINT64_C(1) << 63, 1, 2, 5}, {0, 0x1p53, 0x1p63, 1, 2, 5}},
        {"f2",
         LX_SAMPLE_F32,
         {0x3C00, 0xC000, 0x7BFF, 1, 0x3555, 0x7C00},
         {1, -2, 65504, 0x1p-24, 1365.0 / 4096, HUGE_VAL}},
    };
    for (size_t i = 0; i < 4 * sizeof cases / sizeof cases[0]; i++) {
        bool big = i & 1, fortran = i & 2;
        unsigned char bytes[64];
        char dictionary[200];
        size_t width = (size_t)(cases[i / 4].kind[1] - '0');
        struct lx_loaded loaded = {0};
        struct files *files = *state;
        for (size_t k = 0; k < 6 * width; k++) {
            size_t at = k / width, value = fortran ? at / 2 + 3 * (at % 2) : at, byte = k % width;
            bytes[k] = (unsigned char)(cases[i / 4].bits[value] >> 8 * (big ? width - 1 - byte : byte));
        }
        snprintf(dictionary, sizeof dictionary, "{'descr': '%c%s', 'fortran_order': %s, 'shape': (2, 3), }",
                 width == 1 ? '|'
                 : big      ? '>'
                            : '<',
                 cases[i / 4].kind, fortran ? "True" : "False");
        make_npy(files, 1, dictionary, bytes, 6 * width);
        assert_int_equal(lx_read_image(files->path, NULL, &loaded), LUXEL_OK);
        assert_int_equal(loaded.sample, cases[i / 4].sample);
        for (size_t k = 0; k < 6; k++) {
            bool is_double = loaded.sample == LX_SAMPLE_F64;
            double value = is_double ? ((double *)loaded.values)[k] : (double)((float *)loaded.values)[k];
            assert_true(value == cases[i / 4].values[k]);
        }
        lx_loaded_clear(&loaded);
    }
}

static void test_npy_refused(void **state)
{
    static const struct {
        const char *dictionary;
        const char *id;
    } cases[] = {
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), ", "bad-file"},
        {"{'descr': '<f4', 'fortran_order': False, }", "bad-file"},
        {"{'descr': '<f4', 'shape': (2, 3), }", "bad-file"},
        {"{'fortran_order': False, 'shape': (2, 3), }", "bad-file"},
        {"{'descr': '', 'fortran_order': False, 'shape': (2, 3), }", "bad-file"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), } x", "bad-file"},
        {"{'descr': '<', 'fortran_order': False, 'shape': (2, 3), }", "unfit-file"},
        {"{'descr': '<f4', 'fortran_order': 0, 'shape': (2, 3), }", "bad-file"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (2, -3), }", "bad-file"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), 'more': 1}", "bad-file"},
        {"{'descr': [('a', '<f4')], 'fortran_order': False, 'shape': (2, 3), }", "unfit-file"},
        {"", "bad-file"},
        {"{'descr': '<c8', 'fortran_order': False, 'shape': (2, 3), }", "unfit-file"},
        {"{'descr': '<f16', 'fortran_order': False, 'shape': (2, 3), }", "unfit-file"},
        {"{'descr': '|S4', 'fortran_order': False, 'shape': (2, 3), }", "unfit-file"},
        {"{'descr': '|f4', 'fortran_order': False, 'shape': (2, 3), }", "unfit-file"},
        {"{'descr': [('a', '<f4')", "bad-file"},
        {"{'descr': '|O', 'fortran_order': False, 'shape': (2, 3), }", "unfit-file"},
        {"{'descr': '<f2', 'fortran_order': False, 'shape': (2, 3), }", "bad-file-size"},
        {"{'descr': '|i1', 'fortran_order': False, 'shape': (2, 3), }", "bad-file-size"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (6,), }", "unfit-file"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (), }", "unfit-file"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2, 3), }", "unfit-file"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (0, 3), }", "unfit-file"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 4), }", "bad-file-size"},
        {"{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }", "bad-file-size"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (65536, 65536), }", "bad-file-size"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999999999999, 99999999999999999999), }",
         "bad-file-size"},
    };
    unsigned char bytes[64] = {0};

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        make_npy(*state, 1, cases[i].dictionary, bytes, 24);
        assert_refused(*state, LUXEL_ERROR_FILE, cases[i].id);
    }
    make_npy(*state, 4, "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }", bytes, 24);
    assert_refused(*state, LUXEL_ERROR_FILE, "bad-file");
    make_npy(*state, 1, "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 65537), }", bytes, 0);
    assert_refused(*state, LUXEL_ERROR_FILE, "bad-file-size");
}

/* The size of the file fits, but the picture is too wide. */
static void test_too_many_pixels(void **state)
{
    static const char header[] = "Pf\n65537 1\n-1\n";
    size_t length = sizeof header - 1 + 65537 * 4;
    char *bytes = calloc(length, 1);

    memcpy(bytes, header, sizeof header - 1);
    make_file(*state, "a.pfm", bytes, length);
    assert_refused(*state, LUXEL_ERROR_FILE, "too-many-pixels");
    free(bytes);
}

/* ---- PFM ---- */

static void test_pfm_kinds(void **state)
{
    static const char *const headers[] = {"Pf\n3 2\n-1.0\n", "Pf\n3 2\n1.0\n", "Pf 3 2 +1e0\n", "Pf\r\n3\t2\n-2.5 "};
    unsigned char bytes[128], numbers[64];
    struct files *files = *state;

    for (size_t i = 0; i < 4; i++) {
        size_t length = strlen(headers[i]);
        bool big_endian = i == 1 || i == 2;
        memcpy(bytes, headers[i], length);
        six(4, big_endian, false, numbers);
        memcpy(bytes + length, numbers + 12, 12); /* the bottom row first */
        memcpy(bytes + length + 12, numbers, 12);
        make_file(files, "a.pfm", bytes, length + 24);
        assert_six(files, LX_SAMPLE_F32);
    }
}

static void test_pfm_refused(void **state)
{
    static const char *const cases[][2] = {
        {"PF\n1 1\n-1\n012345678901", "unfit-file"},
        {"Pf\n1 1\n-1\n012", "bad-file-size"},
        {"Pf\n1 1\n-1\n01234", "bad-file-size"},
        {"Pf\n0 1\n-1\n", "bad-file"},
        {"Pf\n1.5 1\n-1\n0123", "bad-file"},
        {"Pf\n-1 1\n-1\n0123", "bad-file"},
        {"Pf\n1 1\n0\n0123", "bad-file"},
        {"Pf\n1 1\n-1", "bad-file"},
        {"Pf\n1 1", "bad-file"},
        {"Pf", "bad-file"},
        {"P5\n1 1\n255\n0", "bad-file"},
        {"Pf\n3999999999 3999999999\n-1\n", "bad-file-size"},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        make_file(*state, "a.pfm", cases[i][0], strlen(cases[i][0]));
        assert_refused(*state, LUXEL_ERROR_FILE, cases[i][1]);
    }
}

/* ---- what no format reads ---- */

static void test_others_refused(void **state)
{
    struct files *files = *state;
    uint8_t grey = 7;
    struct lx_image image = {.columns = 1, .rows = 1, .channels = 1, .sample = LX_SAMPLE_U8, .data = &grey};

    snprintf(files->path, sizeof files->path, "%s/a.png", files->folder);
    assert_int_equal(lx_write_image(files->path, &image, NULL), LUXEL_OK);
    assert_refused(files, LUXEL_ERROR_FILE, "no-values");
    make_file(files, "a.txt", "anything", 8);
    assert_refused(files, LUXEL_ERROR_FILE, "unknown-content");
    make_file(files, "a", "", 0);
    assert_refused(files, LUXEL_ERROR_FILE, "unknown-content");
    snprintf(files->path, sizeof files->path, "%s/gone.npy", files->folder);
    assert_refused(files, LUXEL_ERROR_FILE, "file-not-read");
    snprintf(files->path, sizeof files->path, "%s", files->folder);
    assert_refused(files, LUXEL_ERROR_FILE, "file-not-read");
}

/* An image whose places are not known is no table. */
static void test_csv_without_places(void **state)
{
    struct files *files = *state;
    float value = 1;
    struct lx_image image = {.columns = 1, .rows = 1, .channels = 1, .sample = LX_SAMPLE_F32, .data = &value};
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();

    snprintf(files->path, sizeof files->path, "%s/a.csv", files->folder);
    assert_int_equal(lx_write_image(files->path, &image, diagnostics), LUXEL_ERROR_ARGUMENT);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "no-places");
    luxel_diagnostics_free(diagnostics);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        FILES_CASE(round_trips),    FILES_CASE(exr_from_double),
        FILES_CASE(renamed),        FILES_CASE(csv),
        FILES_CASE(csv_text),       FILES_CASE(csv_of_others),
        FILES_CASE(csv_dialects),   FILES_CASE(csv_refused),
        FILES_CASE(npy_kinds),      FILES_CASE(npy_others),
        FILES_CASE(npy_refused),    FILES_CASE(pfm_kinds),
        FILES_CASE(pfm_refused),    FILES_CASE(too_many_pixels),
        FILES_CASE(others_refused), FILES_CASE(csv_without_places),
    };

    return cmocka_run_group_tests_name("reading formats", tests, NULL, NULL);
}

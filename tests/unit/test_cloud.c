/* SPDX-License-Identifier: MIT */
/* Reading clouds of points: what CSV and NPY files may look like, and what is refused and where. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "format/cloud.h"
#include "scenes.h"

static struct lx_cloud_report read_bytes(const void *bytes, size_t length, struct lx_cloud **cloud)
{
    struct lx_source *source;
    assert_int_equal(lx_source_of_bytes("cloud", bytes, length, NULL, &source), LUXEL_OK);
    struct lx_cloud_report report = lx_cloud_read(source, cloud);
    assert_int_equal(lx_source_status(source), LUXEL_OK);
    lx_source_close(source);
    assert_true((report.message == LX_MSG_COUNT) == (*cloud != NULL));
    return report;
}

/* The rows 1, -2, 3.5, 4 and 1e3, 0, -0.25, 0. */
static void expect_two_rows(const char *what, const void *bytes, size_t length)
{
    static const double expected[2][LX_CLOUD_COLUMNS] = {{1, -2, 3.5, 4}, {1e3, 0, -0.25, 0}};
    struct lx_cloud *cloud;
    struct lx_cloud_report report = read_bytes(bytes, length, &cloud);
    if (report.message != LX_MSG_COUNT)
        fail_msg("message %d, %zu, %s of\n%s", (int)report.message, report.number, report.text, what);
    assert_int_equal(cloud->count, 2);
    for (size_t i = 0; i < 2; i++) {
        double row[LX_CLOUD_COLUMNS];
        lx_cloud_row(cloud, i, row);
        for (size_t k = 0; k < LX_CLOUD_COLUMNS; k++)
            assert_true(row[k] == expected[i][k]);
    }
    lx_kept_release(&cloud->kept);
}

static void reads_csv(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "1,-2,3.5,4\n1e3,0,-0.25,0\n",
        "1,-2,3.5,4\n1e3,0,-0.25,0",
        "x,y,z,intensity\n1,-2,3.5,4\n1e3,0,-0.25,0\n",
        "\xef\xbb\xbfX, Y, Z, Intensity\r\n 1 , -2 , 3.5 , 4 \r\n\r\n1000,0,-.25,0.0\r\n",
        "x;y;z;INTENSITY # in W/sr\n1;-2;3.5;4\n# another\n\n1e3;0;-0.25;-0\n",
        "\xef\xbb\xbf# lamps\n1\t-2\t3.5\t4\n1e3\t0\t-0.25\t0\n\n",
        "  1 -2   3.5 4\n+1e3 0 \t -0.25 0  # the last",
        "x y z intensity\n1 -2 3.5 4\n1e3 0 -0.25 0\n",
        "i;x;y;z;intensity;\n1;1,0;-2;3,5;4;\n2;1000;0;-,25;0,0\n;;;;\n",
        "Z (cm),Y [mm],x_m,I_mW/sr\n0.35,-2,0.001,4000\n-0.025,0,1,0\n",
        "\"1\",\"-2\",\"3,5\",\"4\"\n\"1000\",\"0\",\"-0,25\",\"0\"\n",
        "\"x\" \"y\" \"z\" \"intensity\"\n\"1\" 1 -2 3.5 4\n\"2\" 1000 0 -0.25 0\n",
        "# y,x,z,intensity\n-2,1,3.5,4\n0,1000,-0.25,0\n",
        "sep=\t\r\n1\t-2\t3,5\t4\r\n1000\t0\t-0,25\t0\r\n",
        "1;-2;3,5;4\r1000;0;-0,25;0",
        "1\t-2\t3.5\t4\n1e3 0 -0.25 \t 0\n",
        "\xd5;\xf3;Z;\xc8\xed\xf2\xe5\xed\xf1\xe8\xe2\xed\xee\xf1\xf2\xfc\n1;-2;3,5;4\n1e3;0;-0,25;0\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        expect_two_rows(texts[i], texts[i], strlen(texts[i]));
}

/* Lines that no part of the reader ends with. */
static void reads_long_csv(void **state)
{
    (void)state;
    enum { ROWS = 200000, LONGEST = 48 };
    char *text = malloc((size_t)ROWS * LONGEST), *at = text;
    struct lx_cloud *cloud;
    assert_non_null(text);
    for (int i = 0; i < ROWS; i++)
        at += snprintf(at, LONGEST, "%d,%d.5,-%d,0.%d\n", i, i, i, i);
    assert_int_equal(read_bytes(text, (size_t)(at - text), &cloud).message, LX_MSG_COUNT);
    assert_int_equal(cloud->count, ROWS);
    for (int i = 0; i < ROWS; i++) {
        double row[LX_CLOUD_COLUMNS];
        char words[LONGEST];
        snprintf(words, sizeof words, "0.%d", i);
        lx_cloud_row(cloud, (size_t)i, row);
        assert_true(row[0] == i && row[1] == i + 0.5 && row[2] == -i && row[3] == atof(words));
    }
    lx_kept_release(&cloud->kept);
    *text = 'x';
    struct lx_cloud_report report = read_bytes(text, (size_t)(at - text), &cloud);
    assert_true(report.fault.message == LX_MSG_TABLE_NUMBER && report.number == 1);
    memset(text, ' ', (size_t)ROWS * LONGEST);
    text[0] = text[1] = '\n';
    report = read_bytes(text, (size_t)ROWS * LONGEST, &cloud); /* blank lines, one of them without an end */
    assert_true(report.fault.message == LX_MSG_TABLE_LONG && report.number == 3);
    free(text);
}

static void refuses_csv(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        enum lx_message message;
        size_t line;
        const char *word; /* the first argument of the fault */
    } cases[] = {
        {"", LX_MSG_CLOUD_EMPTY, 0, ""},
        {"\xef\xbb\xbf", LX_MSG_CLOUD_EMPTY, 0, ""},
        {"# nothing\n\n", LX_MSG_CLOUD_EMPTY, 0, ""},
        {"x,y,z,intensity\n", LX_MSG_CLOUD_EMPTY, 0, ""},
        {"1,2,3,4\n1,2,3\n", LX_MSG_TABLE_NUMBERS, 2, "3"},
        {"\n\n1 2 3 4\n1 2 3\n", LX_MSG_TABLE_NUMBERS, 4, "3"},
        {"1,2,3,4,5\n", LX_MSG_TABLE_NUMBERS, 1, "5"},
        {"1,,3,4\n", LX_MSG_TABLE_MISSING, 1, ""},
        {"1,2,3,\n1,2,3,4\n", LX_MSG_TABLE_NUMBERS, 2, "4"},
        {"1 2 3 4 5\n", LX_MSG_TABLE_NUMBERS, 1, "5"},
        {"2000,0,5,2000,10\n", LX_MSG_TABLE_NUMBERS, 1, "5"},
        {"1,2 3,4,5\n", LX_MSG_TABLE_NUMBER, 1, "2 3"},
        {"1,2,3,4\n1;2;3;4\n", LX_MSG_TABLE_NUMBERS, 2, "1"},
        {"1,2,3,4\nx,y,z,intensity\n", LX_MSG_TABLE_NUMBER, 2, "x"},
        {"x,y,intensity\n1,2,3\n", LX_MSG_TABLE_HEADING, 1, "x, y, z, intensity"},
        {"x,y,x,z,intensity\n1,2,3,4,5\n", LX_MSG_TABLE_TWICE, 1, "x"},
        {"x (furlong),y,z,intensity\n1,2,3,4\n", LX_MSG_TABLE_UNIT, 1, "furlong"},
        {"sep=|\n1|2|3|4\n", LX_MSG_TABLE_SEPARATOR, 1, "|"},
        {"x,y,z,I\n1,5,2,3,4\n", LX_MSG_TABLE_FIELDS, 2, "5"},
        {"x;y;z;I\n1.5;2;3;4\n1;2;1,234;4\n", LX_MSG_TABLE_TWO_MEANINGS, 3, ""},
        {"3\nlamp 1 2 3\nlamp 1 2 3\n", LX_MSG_TABLE_LAMPS, 0, "2"},
        {"2\nlamp number 1 1 2 3\n", LX_MSG_TABLE_LAMP, 2, ""},
        {"1,2,0x3,4\n", LX_MSG_TABLE_NUMBER, 1, "0x3"},
        {"1;2;3 000,5;4\n", LX_MSG_TABLE_NUMBER, 1, "3 000,5"},
        {"1,2,3,"
         "\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0"
         "\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0_\xd0\xb0\xd0\xb0",
         LX_MSG_TABLE_NUMBER, 1,
         "\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0"
         "\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0\xd0\xb0_..."},
        {"1,2,3,nan\n", LX_MSG_TABLE_NOT_FINITE, 1, "nan"},
        {"1,2,-Infinity,1\n", LX_MSG_TABLE_NOT_FINITE, 1, "-Infinity"},
        {"1,2,3,4\n1,2,3,1e999\n", LX_MSG_TABLE_NOT_FINITE, 2, "1e999"},
        {"1,2,3,4\n1,2,3,-1e-9\n", LX_MSG_CLOUD_NEGATIVE, 2, ""},
        {"1,2,3,\"4\n5,6,7,8\n", LX_MSG_TABLE_OPEN_QUOTE, 1, ""},
        {"1,2,3,4\n\"1\"2,3,4,5\n", LX_MSG_TABLE_BEHIND, 2, ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct lx_cloud *cloud;
        struct lx_cloud_report report = read_bytes(cases[i].text, strlen(cases[i].text), &cloud);
        bool is_fault = report.message == LX_MSG_CLOUD_PLACE || report.message == LX_MSG_CLOUD_LINE ||
                        report.message == LX_MSG_CLOUD_TABLE;
        enum lx_message message = is_fault ? report.fault.message : report.message;
        const char *word = is_fault ? report.fault.words[0] : report.text;
        if (message != cases[i].message || (cases[i].line && report.number != cases[i].line) ||
            strcmp(word, cases[i].word) != 0)
            fail_msg("message %d in line %zu, %s, of\n%s", (int)message, report.number, word, cases[i].text);
    }
}

/* An NPY file of so many numbers of a width, in either order of bytes; its length. */
static size_t make_npy(const char *dictionary, const double *values, size_t count, size_t width, bool big_endian,
                       unsigned char bytes[1024])
{
    size_t length = strlen(dictionary), at = 10 + length;
    memcpy(bytes, "\x93NUMPY\x01", 8);
    bytes[8] = (unsigned char)length;
    bytes[9] = 0;
    memcpy(bytes + 10, dictionary, length);
    for (size_t i = 0; i < count; i++) {
        uint64_t bits = 0;
        float single = (float)values[i];
        memcpy(&bits, width == 8 ? (const void *)&values[i] : (const void *)&single, width);
        for (size_t k = 0; k < width; k++)
            bytes[at++] = (unsigned char)(bits >> 8 * (big_endian ? width - 1 - k : k));
    }
    return at;
}

static const double by_rows[] = {1, -2, 3.5, 4, 1e3, 0, -0.25, 0};

static void reads_npy(void **state)
{
    (void)state;
    static const double by_columns[] = {1, 1e3, -2, 0, 3.5, -0.25, 4, 0};
    for (int i = 0; i < 8; i++) {
        bool big = i & 1, wide = i & 2, fortran = i & 4;
        unsigned char bytes[1024];
        char dictionary[100];
        snprintf(dictionary, sizeof dictionary, "{'descr': '%c%s', 'fortran_order': %s, 'shape': (2, 4), }\n",
                 big ? '>' : '<', wide ? "f8" : "f4", fortran ? "True" : "False");
        size_t length = make_npy(dictionary, fortran ? by_columns : by_rows, 8, wide ? 8 : 4, big, bytes);
        expect_two_rows(dictionary, bytes, length);
    }
}

#define DICTIONARY(descr_, shape_) "{'descr': '" descr_ "', 'fortran_order': False, 'shape': " shape_ ", }"

/* Rows of places alone: a table and arrays of either width, orders of bytes and of axes tell no intensity. */
static void reads_places_alone(void **state)
{
    (void)state;
    static const double by_places[] = {1, -2, 3.5, 1e3, 0, -0.25}, by_axes[] = {1, 1e3, -2, 0, 3.5, -0.25};
    static const char table[] = "1,-2,3.5\n1e3,0,-0.25\n";
    for (int i = 0; i < 9; i++) {
        bool big = i & 1, wide = i & 2, fortran = i & 4;
        unsigned char bytes[1024];
        char dictionary[100];
        struct lx_cloud *cloud;
        snprintf(dictionary, sizeof dictionary, "{'descr': '%c%s', 'fortran_order': %s, 'shape': (2, 3), }\n",
                 big ? '>' : '<', wide ? "f8" : "f4", fortran ? "True" : "False");
        size_t length = make_npy(dictionary, fortran ? by_axes : by_places, 6, wide ? 8 : 4, big, bytes);
        struct lx_cloud_report report =
            i < 8 ? read_bytes(bytes, length, &cloud) : read_bytes(table, strlen(table), &cloud);
        assert_int_equal(report.message, LX_MSG_COUNT);
        assert_true(cloud->count == 2 && cloud->intensities == LX_CLOUD_NOT_TOLD);
        for (size_t k = 0; k < 2; k++) {
            double row[LX_CLOUD_COLUMNS];
            lx_cloud_row(cloud, k, row);
            assert_memory_equal(row, by_places + 3 * k, 3 * sizeof *row);
            assert_true(row[3] == 1);
        }
        lx_kept_release(&cloud->kept);
    }
}

static void refuses_npy(void **state)
{
    (void)state;
    static const struct {
        const char *dictionary;
        enum lx_message message;
        const char *word;
    } cases[] = {
        {DICTIONARY("<f8", "(2, 5)"), LX_MSG_CLOUD_SHAPE, "(2, 5)"},
        {DICTIONARY("<f8", "(2, 3)"), LX_MSG_CLOUD_SIZE, ""},
        {DICTIONARY("<f8", "(0, 3)"), LX_MSG_CLOUD_EMPTY, ""},
        {DICTIONARY("<f8", "(8,)"), LX_MSG_CLOUD_SHAPE, "(8,)"},
        {DICTIONARY("<f8", "(1, 2, 4)"), LX_MSG_CLOUD_SHAPE, "(1, 2, 4)"},
        {DICTIONARY("<f8", "(4, 2)"), LX_MSG_CLOUD_SHAPE, "(4, 2)"},
        {DICTIONARY("<c8", "(2, 4)"), LX_MSG_CLOUD_DESCR, "<c8"},
        {DICTIONARY("<f2", "(2, 4)"), LX_MSG_CLOUD_SIZE, ""},
        {DICTIONARY("|O", "(2, 4)"), LX_MSG_CLOUD_DESCR, "|O"},
        {DICTIONARY("<f8", "(0, 4)"), LX_MSG_CLOUD_EMPTY, ""},
        {DICTIONARY("<f8", "(10000001, 4)"), LX_MSG_CLOUD_TOO_LARGE, ""},
        {DICTIONARY("<f8", "(99999999999999999999, 4)"), LX_MSG_CLOUD_TOO_LARGE, ""},
        {DICTIONARY("<f8", "(10000000, 4)"), LX_MSG_CLOUD_SIZE, ""},
        {DICTIONARY("<f8", "(1, 4)"), LX_MSG_CLOUD_SIZE, ""},
        {DICTIONARY("<f4", "(2, 4)"), LX_MSG_CLOUD_SIZE, ""},
        {"{'descr': '<f8'}", LX_MSG_CLOUD_DAMAGED, "header"},
    };
    unsigned char bytes[1024];
    struct lx_cloud *cloud;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        size_t length = make_npy(cases[i].dictionary, by_rows, 8, 8, false, bytes);
        struct lx_cloud_report report = read_bytes(bytes, length, &cloud);
        if (report.message != cases[i].message || strcmp(report.text, cases[i].word) != 0)
            fail_msg("message %d, %s, of\n%s", (int)report.message, report.text, cases[i].dictionary);
    }
    size_t whole = make_npy(DICTIONARY("<f8", "(2, 4)"), by_rows, 8, 8, false, bytes);
    for (size_t length = 6; length < whole; length++) {
        enum lx_message message = read_bytes(bytes, length, &cloud).message;
        assert_true(message == LX_MSG_CLOUD_DAMAGED || message == LX_MSG_CLOUD_SIZE);
    }
    bytes[6] = 4;
    assert_int_equal(read_bytes(bytes, whole, &cloud).message, LX_MSG_CLOUD_DAMAGED);
}

static void refuses_rows_of_npy(void **state)
{
    (void)state;
    static const double wrong[] = {HUGE_VAL, -HUGE_VAL, (double)NAN};
    unsigned char bytes[1024];
    struct lx_cloud *cloud;
    for (size_t i = 0; i < 4; i++) {
        double values[8];
        memcpy(values, by_rows, sizeof values);
        values[4 + i] = wrong[i % 3];
        size_t length = make_npy(DICTIONARY("<f8", "(2, 4)"), values, 8, 8, false, bytes);
        struct lx_cloud_report report = read_bytes(bytes, length, &cloud);
        assert_true(report.message == LX_MSG_CLOUD_ROW_NOT_FINITE && report.number == 2);
        values[4 + i] = 1;
        values[3] = -1;
        length = make_npy(DICTIONARY(">f4", "(2, 4)"), values, 8, 4, true, bytes);
        report = read_bytes(bytes, length, &cloud);
        assert_true(report.message == LX_MSG_CLOUD_ROW_NEGATIVE && report.number == 1);
    }
}

/* One row more than may be, short as it is. */
static void refuses_too_many_rows(void **state)
{
    (void)state;
    enum { WIDTH = 8 };
    size_t length = (size_t)WIDTH * (LX_MOST_POINTS + 1);
    char *text = malloc(length);
    struct lx_cloud *cloud;
    assert_non_null(text);
    for (size_t i = 0; i < length; i += WIDTH)
        memcpy(text + i, "1,2,3,4\n", WIDTH);
    struct lx_cloud_report report = read_bytes(text, length, &cloud);
    assert_true(report.message == LX_MSG_CLOUD_TOO_LARGE && report.number == LX_MOST_POINTS + 1);
    assert_int_equal(read_bytes(text, length - WIDTH, &cloud).message, LX_MSG_COUNT);
    assert_int_equal(cloud->count, LX_MOST_POINTS);
    lx_kept_release(&cloud->kept);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_csv),           cmocka_unit_test(reads_long_csv),        cmocka_unit_test(refuses_csv),
        cmocka_unit_test(reads_npy),           cmocka_unit_test(reads_places_alone),    cmocka_unit_test(refuses_npy),
        cmocka_unit_test(refuses_rows_of_npy), cmocka_unit_test(refuses_too_many_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

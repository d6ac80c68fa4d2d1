/* SPDX-License-Identifier: MIT */
/* The part of a picture that a view shows: copies, squares, averages, and where they lie. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../app/picture/resample.h"
#include "scenes.h"

enum { MOST = 200 };

/* A picture with its field, whose pixels are a millimetre wide, from -columns/2 mm on. */
typedef struct Sheet {
    AppShot *shot;
    guint columns, rows;
    guchar *pixels;
} Sheet;

static Sheet new_sheet(guint columns, guint rows)
{
    char value[32];
    AppDocument *document = document_of_builtin("report");
    g_snprintf(value, sizeof value, "[%u, %u]", columns, rows);
    set(document, "screen.sampling", "centers");
    set(document, "screen.resolution", value);
    g_snprintf(value, sizeof value, "%u", columns);
    set(document, "screen.width", value);
    g_snprintf(value, sizeof value, "%u", rows);
    set(document, "screen.height", value);
    Sheet sheet = {shot_of(document, LUXEL_BRIGHTNESS), columns, rows, g_malloc((gsize)columns * rows * 4)};
    g_object_unref(document);
    return sheet;
}

static void clear_sheet(Sheet *sheet)
{
    app_shot_unref(sheet->shot);
    g_free(sheet->pixels);
}

static void fill_at_random(Sheet *sheet, guint32 seed)
{
    GRand *random = g_rand_new_with_seed(seed);
    for (gsize i = 0; i < (gsize)sheet->columns * sheet->rows * 4; i++)
        sheet->pixels[i] = i % 4 == 3 ? 255 : (guchar)g_rand_int_range(random, 0, 256);
    g_rand_free(random);
}

/* What is seen of it: pixels of `columns` x `rows`, the caller's. */
typedef struct Seen {
    guchar *pixels;
    guint columns, rows;
    AppArea area;
} Seen;

static Seen look(const Sheet *sheet, double x, double y, double scale, int width, int height)
{
    const AppFrame frame = {{x, y}, scale, width, height};
    Seen seen = {0};
    seen.pixels = app_resample(sheet->pixels, sheet->shot->field, &frame, FALSE, &seen.columns, &seen.rows, &seen.area);
    return seen;
}

static const guchar *at(const guchar *pixels, guint columns, guint column, guint row)
{
    return pixels + 4 * ((gsize)row * columns + column);
}

/* ---- cases ---- */

static void knows_what_pixels_cover(void **state)
{
    (void)state;
    static const guint sizes[][2] = {{40, 30}, {1, 1}, {1, 7}, {9, 1}};
    for (gsize i = 0; i < G_N_ELEMENTS(sizes); i++) {
        Sheet sheet = new_sheet(sizes[i][0], sizes[i][1]);
        AppArea area = app_area_of(sheet.shot->field);
        assert_true(fabs(area.low[0] + sizes[i][0] / 2.0) < 1e-9 && fabs(area.high[0] - sizes[i][0] / 2.0) < 1e-9);
        assert_true(fabs(area.low[1] + sizes[i][1] / 2.0) < 1e-9 && fabs(area.high[1] - sizes[i][1] / 2.0) < 1e-9);
        clear_sheet(&sheet);
    }
}

static void copies_one_to_one(void **state)
{
    (void)state;
    Sheet sheet = new_sheet(61, 40);
    fill_at_random(&sheet, 1);
    Seen seen = look(&sheet, 100.5, 70, 1, MOST, MOST);
    assert_int_equal(seen.columns, 61);
    assert_int_equal(seen.rows, 40);
    assert_memory_equal(seen.pixels, sheet.pixels, 61 * 40 * 4);
    g_free(seen.pixels);
    seen = look(&sheet, 10.5, 70, 1, 30, 60); /* cut on each side */
    assert_int_equal(seen.columns, 30);
    assert_int_equal(seen.rows, 10);
    for (guint row = 0; row < 10; row++)
        assert_memory_equal(at(seen.pixels, 30, 0, row), at(sheet.pixels, 61, 20, row), 30 * 4);
    g_free(seen.pixels);
    clear_sheet(&sheet);
}

/* As the window lays it: the numbers of the frame are no round ones. */
static void copies_with_rounded_frames(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    char value[32];
    for (guint size = 20; size < 160; size++) {
        g_snprintf(value, sizeof value, "[%u, %u]", size, size);
        set(document, "screen.resolution", value);
        Sheet sheet = {shot_of(document, LUXEL_BRIGHTNESS), size, size, g_malloc((gsize)size * size * 4)};
        const AppArea all = app_area_of(sheet.shot->field);
        const double scale = size / (all.high[0] - all.low[0]) * (1 + (size % 3 - 1.0) * 1e-12);
        fill_at_random(&sheet, size);
        Seen seen = look(&sheet, 300 + size % 2 / 2.0, 200 + size % 2 / 2.0, scale, 1000, 1000);
        assert_int_equal(seen.columns, size);
        assert_int_equal(seen.rows, size);
        assert_memory_equal(seen.pixels, sheet.pixels, 4 * (gsize)size * size);
        g_free(seen.pixels);
        clear_sheet(&sheet);
    }
    g_object_unref(document);
}

static void keeps_what_is_constant(void **state)
{
    (void)state;
    static const guchar levels[] = {0, 1, 77, 128, 254, 255};
    Sheet sheet = new_sheet(120, 90);
    for (gsize l = 0; l < G_N_ELEMENTS(levels); l++) {
        for (gsize i = 0; i < 120 * 90 * 4; i++)
            sheet.pixels[i] = i % 4 == 3 ? 255 : levels[l];
        for (double scale = 0.05; scale < 20; scale *= 1.13) {
            Seen seen = look(&sheet, 77.3, 55.1, scale, MOST, MOST);
            assert_non_null(seen.pixels);
            for (gsize i = 0; i < (gsize)seen.columns * seen.rows * 4; i++)
                if (seen.pixels[i] != (i % 4 == 3 ? 255 : levels[l]))
                    fail_msg("%d became %d at scale %g", levels[l], seen.pixels[i], scale);
            g_free(seen.pixels);
        }
    }
    clear_sheet(&sheet);
}

static void shows_squares(void **state)
{
    (void)state;
    Sheet sheet = new_sheet(20, 16);
    fill_at_random(&sheet, 3);
    for (guint times = 4; times <= 10; times++) {
        Seen seen = look(&sheet, 10.0 * times, 8.0 * times, times * (1 - 1e-12), MOST, MOST);
        assert_int_equal(seen.columns, 20 * times);
        assert_int_equal(seen.rows, 16 * times);
        for (guint row = 0; row < seen.rows; row++)
            for (guint column = 0; column < seen.columns; column++)
                assert_memory_equal(at(seen.pixels, seen.columns, column, row),
                                    at(sheet.pixels, 20, column / times, row / times), 4);
        g_free(seen.pixels);
    }
    clear_sheet(&sheet);
}

/* Between one and four times pixels blend: what is even stays even. */
static void blends_evenly(void **state)
{
    (void)state;
    Sheet sheet = new_sheet(60, 40);
    for (guint row = 0; row < 40; row++)
        for (guint column = 0; column < 60; column++)
            memset(sheet.pixels + 4 * (row * 60 + column), (int)(3 * column + row), 4);
    Seen seen = look(&sheet, 75, 50, 2.5, MOST, MOST);
    assert_int_equal(seen.columns, 150);
    for (guint row = 2; row + 2 < seen.rows; row++)
        for (guint column = 2; column + 2 < seen.columns; column++) {
            const double wanted = 3 * ((column + 0.5) / 2.5 - 0.5) + (row + 0.5) / 2.5 - 0.5;
            assert_true(fabs(at(seen.pixels, 150, column, row)[0] - wanted) < 2);
        }
    g_free(seen.pixels);
    clear_sheet(&sheet);
}

static void averages(void **state)
{
    (void)state;
    Sheet sheet = new_sheet(168, 168);
    fill_at_random(&sheet, 4);
    for (guint times = 2; times <= 8; times++) {
        if (168 % times != 0)
            continue;
        Seen seen = look(&sheet, 84.0 / times, 84.0 / times, 1.0 / times, MOST, MOST);
        assert_int_equal(seen.columns, 168 / times);
        for (guint row = 0; row < seen.rows; row++)
            for (guint column = 0; column < seen.columns; column++)
                for (int k = 0; k < 4; k++) {
                    double sum = 0;
                    for (guint i = 0; i < times * times; i++)
                        sum += at(sheet.pixels, 168, column * times + i % times, row * times + i / times)[k];
                    const double found = at(seen.pixels, seen.columns, column, row)[k];
                    if (fabs(found - sum / (times * times)) > 1)
                        fail_msg("%g instead of %g, reduced %u times", found, sum / (times * times), times);
                }
        g_free(seen.pixels);
    }
    clear_sheet(&sheet);
}

static void keeps_the_mean_at_any_reduction(void **state)
{
    (void)state;
    Sheet sheet = new_sheet(200, 150);
    for (guint row = 0; row < 150; row++)
        for (guint column = 0; column < 200; column++)
            memset(sheet.pixels + 4 * (row * 200 + column), (int)(column / 2 + row), 4);
    for (int i = 1; i < 50; i++) { /* 4 i to 3 i pixels */
        const double scale = i / 50.0;
        Seen seen = look(&sheet, 100 * scale, 75 * scale, scale, MOST, MOST);
        double sum = 0;
        assert_non_null(seen.pixels);
        for (gsize k = 0; k < (gsize)seen.columns * seen.rows; k++)
            sum += seen.pixels[4 * k];
        assert_true(fabs(sum / (seen.columns * seen.rows) - (49.5 + 74.5)) < 2);
        g_free(seen.pixels);
    }
    clear_sheet(&sheet);
}

/* The area is that of whole dots, which lie where the frame says. */
static void tells_the_area(void **state)
{
    (void)state;
    Sheet sheet = new_sheet(50, 30);
    fill_at_random(&sheet, 5);
    GRand *random = g_rand_new_with_seed(6);
    for (int i = 0; i < 500; i++) {
        const double scale = exp(g_rand_double_range(random, -3, 4));
        const double x = g_rand_double_range(random, 0, MOST), y = g_rand_double_range(random, 0, MOST);
        Seen seen = look(&sheet, x, y, scale, MOST, MOST);
        if (!seen.pixels)
            continue;
        const double left = x + seen.area.low[0] * scale, right = x + seen.area.high[0] * scale;
        const double top = y - seen.area.high[1] * scale, bottom = y - seen.area.low[1] * scale;
        assert_true(fabs(left - round(left)) < 1e-6 && fabs(top - round(top)) < 1e-6);
        assert_true(fabs(right - left - seen.columns) < 1e-6 && fabs(bottom - top - seen.rows) < 1e-6);
        assert_true(left > -1e-6 && top > -1e-6 && right < MOST + 1e-6 && bottom < MOST + 1e-6);
        /* at most half a dot from the picture's edge, or cut at the view's */
        assert_true(fabs(left - MAX(0, x - 25 * scale)) <= 0.5 + 1e-6);
        assert_true(fabs(right - MIN(MOST, x + 25 * scale)) <= 0.5 + 1e-6);
        assert_true(fabs(top - MAX(0, y - 15 * scale)) <= 0.5 + 1e-6);
        assert_true(fabs(bottom - MIN(MOST, y + 15 * scale)) <= 0.5 + 1e-6);
        g_free(seen.pixels);
    }
    g_rand_free(random);
    clear_sheet(&sheet);
}

static void gives_nothing_where_nothing_is_seen(void **state)
{
    (void)state;
    Sheet sheet = new_sheet(50, 30);
    memset(sheet.pixels, 0, 50 * 30 * 4);
    assert_null(look(&sheet, -30, 50, 1, MOST, MOST).pixels);
    assert_null(look(&sheet, 50, MOST + 20, 1, MOST, MOST).pixels);
    assert_null(look(&sheet, 50, -20, 1, MOST, MOST).pixels);
    assert_null(look(&sheet, MOST + 30, 50, 1, MOST, MOST).pixels);
    assert_null(look(&sheet, 50, 50, 0.001, MOST, MOST).pixels);
    assert_null(look(&sheet, 50, 50, 0, MOST, MOST).pixels);
    assert_null(look(&sheet, (double)NAN, 50, 1, MOST, MOST).pixels);
    assert_null(look(&sheet, 50, 50, 1, 0, 0).pixels);
    Seen seen = look(&sheet, 100, 100, 1e9, MOST, MOST); /* within one pixel */
    assert_int_equal(seen.columns, MOST);
    assert_int_equal(seen.rows, MOST);
    g_free(seen.pixels);
    clear_sheet(&sheet);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(knows_what_pixels_cover),
        cmocka_unit_test(copies_one_to_one),
        cmocka_unit_test(copies_with_rounded_frames),
        cmocka_unit_test(keeps_what_is_constant),
        cmocka_unit_test(shows_squares),
        cmocka_unit_test(blends_evenly),
        cmocka_unit_test(averages),
        cmocka_unit_test(keeps_the_mean_at_any_reduction),
        cmocka_unit_test(tells_the_area),
        cmocka_unit_test(gives_nothing_where_nothing_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

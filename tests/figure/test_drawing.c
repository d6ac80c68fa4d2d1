/* SPDX-License-Identifier: MIT */
/*
 * Drawing on a context of one's own: the right colours at the right places, nothing outside, and what is refused.
 * Curves and bins are found by their colours, so that the tests need not know how the room is shared out.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <luxel/drawing.h>
#include <luxel/figure.h>
#include <luxel/luxel.h>

#include "take_file.h"

enum { LEFT = 30, TOP = 20 }; /* of the drawing in its picture */

static const uint32_t ORANGE = 0xc98218, BLUE = 0x109ce5, UNTOUCHED = 0x123456;

/* ---- pictures ---- */

static cairo_t *begin(int width, int height, uint32_t ground)
{
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width + 2 * LEFT, height + 2 * TOP);
    cairo_t *cairo = cairo_create(image);
    cairo_surface_destroy(image);
    cairo_set_source_rgb(cairo, (ground >> 16) / 255.0, (ground >> 8 & 255) / 255.0, (ground & 255) / 255.0);
    cairo_paint(cairo);
    cairo_translate(cairo, LEFT, TOP);
    assert_int_equal(cairo_status(cairo), CAIRO_STATUS_SUCCESS);
    return cairo;
}

/* A pixel of the drawing, 0xrrggbb. */
static uint32_t pixel(cairo_t *cairo, int x, int y)
{
    cairo_surface_t *image = cairo_get_target(cairo);
    uint32_t value;
    cairo_surface_flush(image);
    memcpy(&value,
           cairo_image_surface_get_data(image) + (y + TOP) * cairo_image_surface_get_stride(image) + 4 * (x + LEFT),
           sizeof value);
    return value & 0xffffff;
}

static bool is_near(uint32_t a, uint32_t b, int allowed)
{
    for (int shift = 0; shift < 24; shift += 8)
        if (abs((int)(a >> shift & 255) - (int)(b >> shift & 255)) > allowed)
            return false;
    return true;
}

static uint32_t palette(const char *name, double t)
{
    double color[3];
    assert_true(luxel_palette_color(name, t, color));
    return (uint32_t)lround(255 * color[0]) << 16 | (uint32_t)lround(255 * color[1]) << 8 |
           (uint32_t)lround(255 * color[2]);
}

/* The pixels of a colour: their number, the box around them, and the mean of their places. */
struct found {
    int count, left, right, top, bottom;
    double x, y;
};

/* In a part of the drawing. */
static struct found find(cairo_t *cairo, uint32_t color, const int part[4])
{
    struct found found = {.left = part[2], .top = part[3], .right = -1, .bottom = -1};
    for (int y = part[1]; y < part[3]; y++)
        for (int x = part[0]; x < part[2]; x++) {
            if (!is_near(pixel(cairo, x, y), color, 6))
                continue;
            found.count++;
            found.left = x < found.left ? x : found.left;
            found.right = x > found.right ? x : found.right;
            found.top = y < found.top ? y : found.top;
            found.bottom = y > found.bottom ? y : found.bottom;
            found.x += x + 0.5;
            found.y += y + 0.5;
        }
    found.x /= found.count;
    found.y /= found.count;
    return found;
}

static void assert_frame_untouched(cairo_t *cairo, int width, int height, uint32_t ground)
{
    for (int y = -TOP; y < height + TOP; y++)
        for (int x = -LEFT; x < width + LEFT; x++)
            if (x < 0 || y < 0 || x >= width || y >= height)
                assert_int_equal(pixel(cairo, x, y), ground);
}

static void assert_same_pictures(cairo_t *a, cairo_t *b, int width, int height, bool same)
{
    bool equal = true;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            equal = equal && pixel(a, x, y) == pixel(b, x, y);
    assert_int_equal(equal, same);
}

/* ---- bars ---- */

static const luxel_color_bar usual_bar = {.palette = "turbo", .low = 0, .high = 10, .label = "brightness"};

/* Along the bar the colours are those of the palette, from the one end to the other. */
static void check_bar(const luxel_color_bar *bar, bool lying, bool dark)
{
    luxel_drawing_style style;
    double room;
    const int length = 300;
    luxel_drawing_style_init(&style, dark);
    assert_int_equal(luxel_color_bar_room(&style, bar, length, lying, &room), LUXEL_OK);
    int across = (int)ceil(room), width = lying ? length : across, height = lying ? across : length;
    cairo_t *cairo = begin(width, height, UNTOUCHED);
    assert_int_equal(luxel_draw_color_bar(cairo, &style, bar, width, height), LUXEL_OK);
    assert_frame_untouched(cairo, width, height, UNTOUCHED);
    /* where the ends of the palette are, in the middle of the bar's width */
    int first = -1, last = -1, middle = 8;
    for (int i = 0; i < length; i++) {
        uint32_t color = lying ? pixel(cairo, i, middle) : pixel(cairo, middle, length - 1 - i);
        bool is_bar = color != UNTOUCHED;
        first = is_bar && first < 0 ? i : first;
        last = is_bar ? i : last;
    }
    assert_true(first >= 0 && last - first > 0.8 * length);
    for (int i = first + 3; i <= last - 3; i++) {
        uint32_t color = lying ? pixel(cairo, i, middle) : pixel(cairo, middle, length - 1 - i);
        assert_true(is_near(color, palette(bar->palette, (i + 0.5 - first) / (last + 1 - first)), 8));
    }
    cairo_destroy(cairo);
}

static void test_bars(void **state)
{
    (void)state;
    for (size_t i = 0; luxel_palette_name(i); i++) {
        luxel_color_bar bar = usual_bar;
        bar.palette = luxel_palette_name(i);
        bar.logarithmic = i % 2;
        bar.low = i % 2 ? 1e-3 : -2;
        check_bar(&bar, true, i % 3 == 0);
        check_bar(&bar, false, i % 3 == 1);
    }
}

/* A pointed end has the colour of the end of the palette and comes to a point in the middle. */
static void test_points(void **state)
{
    (void)state;
    luxel_drawing_style style;
    luxel_color_bar bar = usual_bar;
    luxel_drawing_style_init(&style, false);
    bar.has_above = true;
    cairo_t *cairo = begin(60, 300, UNTOUCHED);
    assert_int_equal(luxel_draw_color_bar(cairo, &style, &bar, 60, 300), LUXEL_OK);
    struct found point = find(cairo, palette("turbo", 1), (const int[]){0, 0, 18, 20});
    assert_true(point.count > 20 && point.right - point.left > 8);
    struct found tip = find(cairo, palette("turbo", 1), (const int[]){0, point.top, 18, point.top + 1});
    assert_true(tip.count <= 3 && fabs(tip.x - point.x) < 1);
    cairo_destroy(cairo);
}

/* A label for which there is no room is left out, and the measure says how much it takes. */
static void test_bar_labels(void **state)
{
    (void)state;
    luxel_drawing_style style;
    luxel_color_bar bare = usual_bar;
    double with, without;
    luxel_drawing_style_init(&style, false);
    bare.label = NULL;
    assert_int_equal(luxel_color_bar_room(&style, &usual_bar, 200, false, &with), LUXEL_OK);
    assert_int_equal(luxel_color_bar_room(&style, &bare, 200, false, &without), LUXEL_OK);
    assert_true(with > without + 10 && with < without + 20);
    for (int i = 0; i < 2; i++) {
        int width = (int)ceil(i ? with : without);
        cairo_t *labelled = begin(width, 200, UNTOUCHED), *plain = begin(width, 200, UNTOUCHED);
        assert_int_equal(luxel_draw_color_bar(labelled, &style, &usual_bar, width, 200), LUXEL_OK);
        assert_int_equal(luxel_draw_color_bar(plain, &style, &bare, width, 200), LUXEL_OK);
        assert_same_pictures(labelled, plain, width, 200, i == 0);
        cairo_destroy(labelled);
        cairo_destroy(plain);
    }
}

/* ---- profiles ---- */

enum { SAMPLES = 101 };

/* Two lights that give the same everywhere, seen from 20 to 60 of 0 to 100. */
struct profiled {
    luxel_profile profile;
    luxel_profile_sample samples[SAMPLES];
    double shares[SAMPLES][2];
};

static void make_profile(struct profiled *made, double one, double other)
{
    *made = (struct profiled){.profile = {.count = SAMPLES, .lights = 2}};
    made->profile.samples = made->samples;
    made->profile.shares = &made->shares[0][0];
    for (int i = 0; i < SAMPLES; i++) {
        made->samples[i] = (luxel_profile_sample){.abscissa = i, .x_mm = 50 - i, .y_mm = 2, .value = one + other};
        made->samples[i].has_value = i >= 20 && i <= 60;
        made->shares[i][0] = one;
        made->shares[i][1] = other;
    }
}

static cairo_t *draw_profile(const struct profiled *made, const luxel_drawing_style *style,
                             const luxel_profile_style *how, int width, int height)
{
    cairo_t *cairo = begin(width, height, 0xffffff);
    assert_int_equal(luxel_draw_profile(cairo, style, &made->profile, how, width, height), LUXEL_OK);
    assert_frame_untouched(cairo, width, height, 0xffffff);
    return cairo;
}

/* Lines are where their values are: one that is in the middle of two others, by its scale, is drawn so; they end where
 * the values do. */
static void test_lines(void **state)
{
    (void)state;
    const int all[] = {0, 0, 400, 300};
    struct profiled made;
    luxel_drawing_style style;
    luxel_profile_style how;
    luxel_drawing_style_init(&style, false);
    luxel_profile_style_init(&how);
    style.letters = 20; /* wide lines, whose middle has their colour alone */
    for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
        how.logarithmic = logarithmic;
        how.low = logarithmic ? 0.01 : 0;
        how.high = 10;
        make_profile(&made, logarithmic ? 0.09 : 1, logarithmic ? 0.81 : 5);
        cairo_t *cairo = draw_profile(&made, &style, &how, 400, 300);
        make_profile(&made, logarithmic ? 0.27 : 3, logarithmic ? 0.81 : 5);
        cairo_t *between = draw_profile(&made, &style, &how, 400, 300);
        struct found one = find(cairo, ORANGE, all), other = find(cairo, BLUE, all),
                     middle = find(between, ORANGE, all);
        assert_true(one.count > 80 && other.count > 80 && middle.count > 80 && one.y - other.y > 60);
        assert_true(fabs(middle.y - (one.y + other.y) / 2) < 0.8);
        assert_true(one.bottom - one.top <= 2 && other.bottom - other.top <= 2);
        assert_true(abs(one.left - other.left) <= 1 && abs(one.right - other.right) <= 1);
        /* from 20 to 60 the line, at 80 the marker */
        how.marker = 80;
        cairo_t *marked = draw_profile(&made, &style, &how, 400, 300);
        struct found line = {.left = 400};
        for (int y = 30; y < 200; y++)
            for (int x = 0; x < 400; x++)
                if (pixel(between, x, y) != pixel(marked, x, y)) {
                    line.left = x < line.left ? x : line.left;
                    line.right = x > line.right ? x : line.right;
                    line.count++;
                }
        assert_true(line.count > 80 && line.right - line.left <= 4);
        double place = (line.left + line.right) / 2.0 - one.right;
        assert_true(fabs(place / (one.right - one.left) - 0.5) < 0.03);
        how.marker = (double)NAN;
        cairo_destroy(marked);
        cairo_destroy(between);
        cairo_destroy(cairo);
    }
}

/* The colour told for a light is that of its curve, on light and dark grounds; every tenth light has it again. */
static void test_light_colors(void **state)
{
    (void)state;
    struct profiled made;
    luxel_drawing_style style;
    const int all[] = {0, 0, 400, 300};
    double on_light[2][3];
    make_profile(&made, 1, 3);
    for (int dark = 0; dark < 2; dark++) {
        double first[3], again[3];
        luxel_drawing_style_init(&style, dark == 1);
        style.letters = 20; /* wide lines, whose middle has their colour alone */
        cairo_t *cairo = draw_profile(&made, &style, NULL, 400, 300);
        for (size_t light = 0; light < 2; light++) {
            double color[3];
            assert_int_equal(luxel_light_color(&style, light, color), LUXEL_OK);
            const uint32_t wanted = (uint32_t)lround(255 * color[0]) << 16 | (uint32_t)lround(255 * color[1]) << 8 |
                                    (uint32_t)lround(255 * color[2]);
            assert_true(find(cairo, wanted, all).count > 80);
            if (dark)
                assert_memory_not_equal(color, on_light[light], sizeof color);
            memcpy(on_light[light], color, sizeof color);
        }
        assert_int_equal(luxel_light_color(&style, 0, first), LUXEL_OK);
        assert_int_equal(luxel_light_color(&style, 10, again), LUXEL_OK);
        assert_memory_equal(first, again, sizeof first);
        cairo_destroy(cairo);
    }
    assert_int_equal(luxel_light_color(NULL, 0, (double[3]){0}), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_light_color(&style, 0, NULL), LUXEL_ERROR_ARGUMENT);
}

/* Stacked, the areas are as high as the shares; along x, which falls along the way, they are mirrored. */
static void test_stacked(void **state)
{
    (void)state;
    const int all[] = {0, 0, 400, 300};
    struct profiled made;
    luxel_drawing_style style;
    luxel_profile_style how;
    double centers[2];
    luxel_drawing_style_init(&style, false);
    luxel_profile_style_init(&how);
    make_profile(&made, 1, 3);
    how.stacked = true;
    how.logarithmic = true; /* which stacks are not */
    for (int mirrored = 0; mirrored < 2; mirrored++) {
        how.along = mirrored ? LUXEL_ALONG_X : LUXEL_ALONG_WAY;
        cairo_t *cairo = draw_profile(&made, &style, &how, 400, 300);
        uint32_t pale[2] = {0xd1953b, 0x34abe9}; /* a little of the ground is in them */
        struct found one = find(cairo, pale[0], all), other = find(cairo, pale[1], all);
        assert_true(one.count > 2000);
        assert_true(fabs((other.bottom - other.top + 1.0) / (one.bottom - one.top + 1) - 3) < 0.25);
        assert_true(other.bottom < one.bottom && other.top < one.top);
        centers[mirrored] = one.x;
        cairo_destroy(cairo);
    }
    /* 40 of 100 here, so 60 there, of a frame that is nearly as wide as the drawing */
    assert_true(centers[1] - centers[0] > 0.15 * 350 && centers[1] - centers[0] < 0.25 * 400);
}

/* Names make a legend and choose the lights; a low drawing has no legend. */
static void test_names(void **state)
{
    (void)state;
    const int all[] = {0, 0, 400, 300}, plot[] = {0, 0, 400, 200}, below[] = {0, 250, 400, 300};
    const char *both[] = {"one", "other"}, *one[] = {"one", NULL};
    struct profiled made;
    luxel_drawing_style style;
    luxel_profile_style how;
    luxel_drawing_style_init(&style, false);
    luxel_profile_style_init(&how);
    style.letters = 20;
    make_profile(&made, 1, 3);
    cairo_t *plain = draw_profile(&made, &style, NULL, 400, 300);
    assert_true(find(plain, BLUE, all).count > 80 && find(plain, BLUE, below).count == 0);
    how.names = both;
    cairo_t *named = draw_profile(&made, &style, &how, 400, 300);
    assert_true(find(named, BLUE, plot).count > 80 && find(named, BLUE, below).count > 10);
    how.names = one;
    cairo_t *single = draw_profile(&made, &style, &how, 400, 300);
    assert_true(find(single, BLUE, all).count == 0 && find(single, ORANGE, all).count == 0);
    cairo_t *low = draw_profile(&made, &style, NULL, 400, 80);
    how.names = both;
    cairo_t *low_named = draw_profile(&made, &style, &how, 400, 80);
    assert_same_pictures(low, low_named, 400, 80, true);
    cairo_destroy(plain);
    cairo_destroy(named);
    cairo_destroy(single);
    cairo_destroy(low);
    cairo_destroy(low_named);
}

static const char *exclaim(const char *english, void *data)
{
    static char word[64];
    (void)data;
    snprintf(word, sizeof word, "%s!", english);
    return word;
}

/* Words that are not given come from the language, those that are do not. */
static void test_words(void **state)
{
    (void)state;
    const luxel_language language = {.translate = exclaim};
    struct profiled made;
    luxel_drawing_style english, other;
    luxel_profile_style how;
    luxel_drawing_style_init(&english, false);
    luxel_drawing_style_init(&other, false);
    other.language = &language;
    luxel_profile_style_init(&how);
    make_profile(&made, 1, 3);
    for (int given = 0; given < 2; given++) {
        how.x_label = given ? "x" : NULL;
        how.y_label = given ? "y" : NULL;
        cairo_t *one = draw_profile(&made, &english, &how, 250, 200),
                *two = draw_profile(&made, &other, &how, 250, 200);
        assert_same_pictures(one, two, 250, 200, given);
        cairo_destroy(one);
        cairo_destroy(two);
    }
}

/* ---- histograms ---- */

/* Bins are as high as their counts, in the colours of their values; an empty one has none. */
static void test_histogram(void **state)
{
    (void)state;
    static const size_t counts[] = {10, 0, 20, 40};
    const double rising[2][5] = {{0, 1, 2, 3, 4}, {1, 10, 100, 1000, 10000}};
    const int all[] = {0, 0, 300, 200};
    luxel_drawing_style style;
    luxel_drawing_style_init(&style, true);
    for (int i = 0; i < 2; i++) {
        const luxel_histogram histogram = {.scale = i ? LUXEL_HISTOGRAM_LOGARITHMIC : LUXEL_HISTOGRAM_LINEAR,
                                           .bins = 4,
                                           .edges = rising[i],
                                           .counts = counts};
        const luxel_color_bar colors = {
            .palette = "turbo", .low = rising[i][0], .high = rising[i][4], .logarithmic = i == 1};
        struct found bins[4];
        cairo_t *cairo = begin(300, 200, 0x141414);
        assert_int_equal(luxel_draw_histogram(cairo, &style, &histogram, &colors, "x", i ? NULL : "y", 300, 200),
                         LUXEL_OK);
        assert_frame_untouched(cairo, 300, 200, 0x141414);
        for (int k = 0; k < 4; k++)
            bins[k] = find(cairo, palette("turbo", (k + 0.5) / 4), all);
        assert_int_equal(bins[1].count, 0);
        assert_true(bins[0].count > 500 && bins[0].x < bins[2].x && bins[2].x < bins[3].x);
        assert_true(fabs(bins[2].count / (double)bins[0].count - 2) < 0.15);
        assert_true(fabs(bins[3].count / (double)bins[0].count - 4) < 0.3);
        cairo_t *plain = begin(300, 200, 0x141414);
        assert_int_equal(luxel_draw_histogram(plain, &style, &histogram, NULL, NULL, NULL, 300, 200), LUXEL_OK);
        assert_int_equal(find(plain, palette("turbo", 0.625), all).count, 0);
        cairo_destroy(plain);
        cairo_destroy(cairo);
    }
}

/* ---- what is refused, and what is left alone ---- */

static void test_refusals(void **state)
{
    (void)state;
    const double flat[] = {1, 1}, infinite[] = {0, HUGE_VAL}, negative[] = {-1, 1}, far[] = {0, 1};
    const size_t counts[] = {3};
    struct profiled made;
    luxel_drawing_style style, bad;
    luxel_profile_style how;
    luxel_color_bar bar;
    double room;
    cairo_t *cairo = begin(200, 100, UNTOUCHED);
    luxel_drawing_style_init(&style, false);
    make_profile(&made, 1, 2);

    assert_int_equal(luxel_draw_color_bar(NULL, &style, &usual_bar, 200, 100), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_draw_color_bar(cairo, NULL, &usual_bar, 200, 100), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_draw_color_bar(cairo, &style, NULL, 200, 100), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_draw_color_bar(cairo, &style, &usual_bar, 0, 100), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_draw_color_bar(cairo, &style, &usual_bar, 200, (double)NAN), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_color_bar_room(&style, &usual_bar, -1, false, &room), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_color_bar_room(&style, &usual_bar, 10, false, NULL), LUXEL_ERROR_ARGUMENT);
    const luxel_color_bar bad_bars[] = {{.palette = "jet", .high = 1},   {.low = 1, .high = 1},
                                        {.low = (double)NAN, .high = 1}, {.high = HUGE_VAL},
                                        {.low = -1e308, .high = 1e308},  {.high = 1, .logarithmic = true}};
    for (size_t i = 0; i < sizeof bad_bars / sizeof bad_bars[0]; i++)
        assert_int_equal(luxel_draw_color_bar(cairo, &style, &bad_bars[i], 200, 100), LUXEL_ERROR_ARGUMENT);
    for (int i = 0; i < 3; i++) {
        bad = style;
        *(i == 0 ? &bad.letters : i == 1 ? &bad.ink[1] : &bad.ground[2]) = i == 0 ? 0 : i == 1 ? 1.5 : (double)NAN;
        assert_int_equal(luxel_draw_profile(cairo, &bad, &made.profile, NULL, 200, 100), LUXEL_ERROR_ARGUMENT);
    }
    assert_int_equal(luxel_draw_profile(cairo, &style, NULL, NULL, 200, 100), LUXEL_ERROR_ARGUMENT);
    luxel_profile_style_init(&how);
    how.along = LUXEL_ALONG_Y; /* which is the same everywhere */
    assert_int_equal(luxel_draw_profile(cairo, &style, &made.profile, &how, 200, 100), LUXEL_ERROR_ARGUMENT);
    luxel_profile_style_init(&how);
    how.low = how.high = 3;
    assert_int_equal(luxel_draw_profile(cairo, &style, &made.profile, &how, 200, 100), LUXEL_ERROR_ARGUMENT);
    const double *const edges[] = {flat, infinite, negative};
    for (int i = 0; i < 3; i++) {
        const luxel_histogram histogram = {.scale = i == 2 ? LUXEL_HISTOGRAM_LOGARITHMIC : LUXEL_HISTOGRAM_LINEAR,
                                           .bins = 1,
                                           .edges = edges[i],
                                           .counts = counts};
        assert_int_equal(luxel_draw_histogram(cairo, &style, &histogram, NULL, NULL, NULL, 200, 100),
                         LUXEL_ERROR_ARGUMENT);
    }
    const luxel_histogram good = {.bins = 1, .edges = far, .counts = counts};
    bar = usual_bar;
    bar.palette = "jet";
    assert_int_equal(luxel_draw_histogram(cairo, &style, &good, &bar, NULL, NULL, 200, 100), LUXEL_ERROR_ARGUMENT);
    assert_frame_untouched(cairo, 0, 0, UNTOUCHED);
    cairo_restore(cairo); /* without a save: the context is broken from here on */
    assert_int_equal(luxel_draw_color_bar(cairo, &style, &usual_bar, 200, 100), LUXEL_ERROR_ARGUMENT);
    cairo_destroy(cairo);
}

/* On every size something sensible or nothing, never more than the rectangle; the context keeps its settings. */
static void test_sizes(void **state)
{
    (void)state;
    static const int sizes[] = {1, 3, 11, 29, 60, 150};
    static const size_t counts[] = {3, 5};
    const double edges[] = {0, 1, 2};
    const luxel_histogram histogram = {.bins = 2, .edges = edges, .counts = counts};
    const char *names[] = {"a name that is quite long for such a small drawing", "other"};
    struct profiled made;
    luxel_drawing_style style;
    luxel_profile_style how;
    luxel_drawing_style_init(&style, false);
    luxel_profile_style_init(&how);
    how.names = names;
    how.marker = 40;
    make_profile(&made, 0, 0);
    for (size_t i = 0; i < 36; i++) {
        int width = sizes[i % 6], height = sizes[i / 6];
        cairo_t *cairo = begin(width, height, UNTOUCHED);
        cairo_set_line_width(cairo, 7);
        cairo_set_dash(cairo, (const double[]){1, 2}, 2, 0);
        assert_int_equal(luxel_draw_color_bar(cairo, &style, &usual_bar, width, height), LUXEL_OK);
        assert_int_equal(luxel_draw_profile(cairo, &style, &made.profile, &how, width, height), LUXEL_OK);
        assert_int_equal(luxel_draw_histogram(cairo, &style, &histogram, NULL, "x", "y", width, height), LUXEL_OK);
        assert_frame_untouched(cairo, width, height, UNTOUCHED);
        assert_true(cairo_get_line_width(cairo) == 7 && cairo_get_dash_count(cairo) == 2);
        assert_false(cairo_has_current_point(cairo));
        cairo_destroy(cairo);
    }
}

/* ---- figures ---- */

static char *drawn(const char *path, size_t *length)
{
    char *bytes = take_file(path, length);
    assert_non_null(bytes);
    assert_true(*length > 1000);
    return bytes;
}

/* Whatever stride the settings have, figures and reports show the whole picture. */
static void test_whole_pictures(void **state)
{
    (void)state;
    char *bytes[2][2];
    size_t lengths[2][2];
    luxel_settings settings;
    luxel_scene *scene = NULL;
    luxel_settings_init(&settings);
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "screen.resolution=[90,90]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    for (int i = 0; i < 2; i++) {
        char folder[] = "/tmp/luxel-drawing-XXXXXX", path[64];
        settings.stride = i ? 7 : 1;
        assert_non_null(mkdtemp(folder));
        snprintf(path, sizeof path, "%s/f.png", folder);
        assert_int_equal(luxel_figure_write(scene, &settings, NULL, path, NULL), LUXEL_OK);
        bytes[i][0] = drawn(path, &lengths[i][0]);
        snprintf(path, sizeof path, "%s/r.md", folder);
        assert_int_equal(luxel_report_write(scene, &settings, NULL, path, NULL), LUXEL_OK);
        bytes[i][1] = drawn(path, &lengths[i][1]);
        remove(folder);
    }
    for (int k = 0; k < 2; k++) {
        assert_int_equal(lengths[0][k], lengths[1][k]);
        assert_memory_equal(bytes[0][k], bytes[1][k], lengths[0][k]);
        free(bytes[0][k]);
        free(bytes[1][k]);
    }
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bars),  cmocka_unit_test(test_points),         cmocka_unit_test(test_bar_labels),
        cmocka_unit_test(test_lines), cmocka_unit_test(test_stacked),        cmocka_unit_test(test_names),
        cmocka_unit_test(test_words), cmocka_unit_test(test_histogram),      cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_sizes), cmocka_unit_test(test_whole_pictures), cmocka_unit_test(test_light_colors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

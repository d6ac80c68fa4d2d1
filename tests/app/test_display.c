/* SPDX-License-Identifier: MIT */
/* Painting fields: every colour is the palette's at the value's place in the range, and nothing but numbers decides. */
#include <luxel/colour.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../app/picture/display.h"
#include "scenes.h"

/* A painted field. */
typedef struct Painting {
    AppShot *shot;
    const luxel_field *field;
    AppDisplay display;
    double low, high;
    guchar *pixels;
    gsize count;
} Painting;

static Painting begin(const char *scene, const char *key, const char *value)
{
    AppDocument *document = document_of_builtin(scene);
    set(document, "screen.resolution", "[100, 80]");
    set(document, "screen.width", "1000");
    set(document, "screen.height", "800");
    if (key)
        set(document, key, value);
    Painting painting = {.shot = shot_of(document, LUXEL_BRIGHTNESS)};
    painting.field = painting.shot->field;
    painting.count = (gsize)luxel_field_columns(painting.field) * luxel_field_rows(painting.field);
    painting.pixels = g_malloc(4 * painting.count);
    app_display_init(&painting.display);
    g_object_unref(document);
    return painting;
}

static void paint(Painting *painting)
{
    memset(painting->pixels, 0x5a, 4 * painting->count);
    app_display_range(&painting->display, painting->field, &painting->low, &painting->high);
    app_display_paint(&painting->display, painting->field, painting->low, painting->high, painting->pixels);
}

static void finish(Painting *painting)
{
    g_free(painting->pixels);
    app_shot_unref(painting->shot);
}

static double value_at(const luxel_field *field, gsize i)
{
    const guint columns = luxel_field_columns(field);
    return luxel_field_value(field, (guint)(i % columns), (guint)(i / columns));
}

/* Asserts that a pixel has this colour up to so many levels. */
static void expect_color(const guchar *pixel, const double color[3], int levels)
{
    for (int k = 0; k < 3; k++) {
        const int wanted = (int)(color[k] * 255 + 0.5), found = pixel[2 - k];
        if (abs(found - wanted) > levels)
            fail_msg("part %d of the colour is %d instead of %d", k, found, wanted);
    }
    assert_int_equal(pixel[3], 255);
}

/* Asserts the palette's colour, t being the value's place in the range: within a step of 1023. */
static void expect_place(const guchar *pixel, const char *palette, double t)
{
    double color[3], before[3], after[3];
    luxel_palette_color(palette, t, color);
    luxel_palette_color(palette, t - 0.6 / 1023, before);
    luxel_palette_color(palette, t + 0.6 / 1023, after);
    int levels = 1;
    for (int k = 0; k < 3; k++)
        levels = MAX(levels, 1 + (int)ceil(255 * fmax(fabs(after[k] - color[k]), fabs(before[k] - color[k]))));
    expect_color(pixel, color, levels);
}

/* Asserts the colours of all pixels on the surface, `place` being where values have their place, 0 to 1. */
static void expect_places(Painting *painting, double (*place)(const Painting *painting, double value))
{
    const guint8 *mask = luxel_field_mask(painting->field);
    paint(painting);
    for (gsize i = 0; i < painting->count; i++)
        if (mask[i])
            expect_place(painting->pixels + 4 * i, painting->display.palette,
                         place(painting, value_at(painting->field, i)));
}

static double linear(const Painting *painting, double value)
{
    return (value * exp2(painting->display.exposure) - painting->low) / (painting->high - painting->low);
}

static double logarithmic(const Painting *painting, double value)
{
    const double bright = value * exp2(painting->display.exposure);
    return bright > 0 ? log(bright / painting->low) / log(painting->high / painting->low) : 0;
}

/* ---- cases ---- */

static void is_plain_at_first(void **state)
{
    (void)state;
    AppDisplay display;
    app_display_init(&display);
    assert_true(app_display_is_plain(&display));
    display.background[0] = 1; /* beside the numbers */
    display.isophotes = TRUE;
    assert_true(app_display_is_plain(&display));
    display.exposure = 1;
    assert_false(app_display_is_plain(&display));
    display.exposure = 0;
    display.palette = "viridis";
    assert_false(app_display_is_plain(&display));
    display.palette = "grey";
    display.logarithmic = TRUE;
    assert_false(app_display_is_plain(&display));
    display.logarithmic = FALSE;
    display.is_locked = TRUE;
    assert_false(app_display_is_plain(&display));
}

static void shows_the_grey_of_the_file(void **state)
{
    (void)state;
    static const char *const ways[] = {"{range: max, rounding: truncate}", "{range: minmax, rounding: nearest}",
                                       "{range: log}", "{range: [0, 3]}"};
    for (gsize w = 0; w < G_N_ELEMENTS(ways); w++) {
        Painting painting = begin("three-lights", "picture", ways[w]);
        guint8 *grey = g_malloc(painting.count);
        luxel_field_grey(painting.field, grey);
        painting.display.outline = FALSE;
        paint(&painting);
        for (gsize i = 0; i < painting.count; i++)
            for (int k = 0; k < 3; k++)
                assert_int_equal(painting.pixels[4 * i + (gsize)k], grey[i]);
        for (gsize i = 0; i < painting.count; i++)
            assert_int_equal(painting.pixels[4 * i + 3], 255);
        g_free(grey);
        finish(&painting);
    }
}

static void shows_the_colors_of_the_file(void **state)
{
    (void)state;
    Painting painting = begin("three-lights", "channels", "rgb");
    guint8 *levels = g_malloc(3 * painting.count);
    const guint8 *mask = luxel_field_mask(painting.field);
    luxel_field_srgb(painting.field, levels);
    assert_int_equal(luxel_field_channels(painting.field), 3);
    paint(&painting);
    for (gsize i = 0; i < painting.count; i++)
        for (gsize k = 0; k < 3 && mask[i]; k++)
            assert_int_equal(painting.pixels[4 * i + 2 - k], levels[3 * i + k]);
    g_free(levels);
    finish(&painting);
}

static void shows_the_palette(void **state)
{
    (void)state;
    Painting painting = begin("spot", NULL, NULL);
    for (gsize i = 0; luxel_palette_name(i); i++) {
        painting.display.palette = luxel_palette_name(i);
        painting.display.exposure = 0.01; /* so that grey is no special case */
        expect_places(&painting, linear);
        assert_true(painting.low == 0);
        assert_true(painting.high == luxel_field_statistics(painting.field)->maximum.value);
    }
    finish(&painting);
}

static void shows_logarithms(void **state)
{
    (void)state;
    Painting painting = begin("spot", NULL, NULL);
    painting.display.palette = "viridis";
    painting.display.logarithmic = TRUE;
    expect_places(&painting, logarithmic);
    assert_true(fabs(painting.low / painting.high - 1e-4) < 1e-12);
    painting.display.exposure = -2.5;
    expect_places(&painting, logarithmic);
    finish(&painting);
}

static void shows_exposure(void **state)
{
    (void)state;
    Painting painting = begin("report", NULL, NULL);
    painting.display.palette = "viridis";
    for (int stops = -3; stops <= 3; stops++) {
        painting.display.exposure = stops;
        expect_places(&painting, linear);
    }
    finish(&painting);
}

static void shows_a_locked_range(void **state)
{
    (void)state;
    Painting painting = begin("report", NULL, NULL);
    const double maximum = luxel_field_statistics(painting.field)->maximum.value;
    painting.display.palette = "viridis";
    painting.display.is_locked = TRUE;
    painting.display.low = 0.2 * maximum;
    painting.display.high = 0.7 * maximum;
    expect_places(&painting, linear);
    assert_true(painting.low == painting.display.low && painting.high == painting.display.high);
    painting.display.logarithmic = TRUE;
    expect_places(&painting, logarithmic);
    assert_true(painting.low == painting.display.low && painting.high == painting.display.high);
    finish(&painting);
}

static void always_has_a_range(void **state)
{
    (void)state;
    static const double ranges[][2] = {{1, 1}, {2, 1}, {0, 0}, {-1, -1}, {-2, -1}, {-1, 1}, {0, 1}, {-1, 0}};
    Painting painting = begin("report", "lights[0].enabled", "false"); /* all is dark */
    paint(&painting);
    assert_true(painting.low == 0 && painting.high == 1);
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(ranges); i++) {
        painting.display.is_locked = TRUE;
        painting.display.logarithmic = i % 2 == 1;
        painting.display.low = ranges[i / 2][0];
        painting.display.high = ranges[i / 2][1];
        paint(&painting);
        assert_true(painting.low < painting.high);
        assert_true(!painting.display.logarithmic || painting.low > 0);
    }
    finish(&painting);
}

static void paints_around_the_surface_only(void **state)
{
    (void)state;
    Painting painting = begin("report", NULL, NULL);
    const guint8 *mask = luxel_field_mask(painting.field);
    painting.display.palette = "viridis";
    painting.display.outline = FALSE;
    paint(&painting);
    guchar *plain = g_memdup2(painting.pixels, 4 * painting.count);
    memcpy(painting.display.background, (double[]){0.2, 0.4, 0.6}, sizeof painting.display.background);
    painting.display.outline = TRUE; /* which is drawn over it, as a line */
    paint(&painting);
    gsize background = 0;
    for (gsize i = 0; i < painting.count; i++) {
        if (mask[i]) {
            assert_memory_equal(painting.pixels + 4 * i, plain + 4 * i, 4);
        } else {
            assert_memory_equal(painting.pixels + 4 * i, ((guchar[]){153, 102, 51, 255}), 4);
            background++;
        }
    }
    assert_true(background > 1000);
    g_free(plain);
    finish(&painting);
}

/* What is more in one way is less in the other, and the colours stand as far from the middle. */
static void shows_differences_alike_both_ways(void **state)
{
    (void)state;
    Painting one = begin("report", NULL, NULL), other = begin("report", "surfaces[0].material.shininess", "5");
    luxel_comparison comparison;
    luxel_field *fields[2];
    assert_int_equal(luxel_compare(one.field, other.field, NULL, &comparison, &fields[0]), LUXEL_OK);
    assert_int_equal(luxel_compare(other.field, one.field, NULL, &comparison, &fields[1]), LUXEL_OK);
    for (int i = 0; i < 2; i++) {
        Painting *painting = i == 0 ? &one : &other;
        painting->field = fields[i];
        painting->display.palette = "coolwarm";
        painting->display.is_locked = TRUE;
        painting->display.high = comparison.largest.value;
        painting->display.low = -comparison.largest.value;
        expect_places(painting, linear);
        luxel_field_free(fields[i]);
    }
    finish(&one);
    finish(&other);
}

/* Fields of double precision are painted alike. */
static void paints_either_precision(void **state)
{
    (void)state;
    Painting painting = begin("spot", NULL, NULL);
    luxel_settings settings;
    luxel_field *precise;
    luxel_settings_init(&settings);
    settings.precision = LUXEL_DOUBLE;
    assert_int_equal(luxel_render(painting.shot->moment->scene, &settings, NULL, &precise), LUXEL_OK);
    painting.field = precise;
    painting.display.palette = "viridis";
    expect_places(&painting, linear);
    painting.display.logarithmic = TRUE;
    expect_places(&painting, logarithmic);
    luxel_field_free(precise);
    finish(&painting);
}

/* The ends of a range go where the hand puts them: to the value that stood there, and never past each other. */
static void moves_ends(void **state)
{
    (void)state;
    const AppRange line = {2, 10, FALSE}, decades = {0.01, 100, TRUE};
    assert_true(fabs(app_range_place(&line, 4) - 0.25) < 1e-15);
    assert_true(fabs(app_range_place(&line, 12) - 1.25) < 1e-15);
    assert_true(fabs(app_range_place(&decades, 1) - 0.5) < 1e-15);
    assert_true(app_range_place(&decades, 0) < -1e300);
    for (double parts = -0.9; parts < 0.95; parts += 0.1) {
        const AppRange ranges[] = {line, decades};
        for (int i = 0; i < 2; i++) {
            const AppRange up = app_range_move(&ranges[i], TRUE, parts),
                           down = app_range_move(&ranges[i], FALSE, parts);
            assert_true(up.low == ranges[i].low && down.high == ranges[i].high);
            assert_true(fabs(app_range_place(&ranges[i], up.high) - (1 + parts)) < 1e-12);
            if (down.low > 0)
                assert_true(fabs(app_range_place(&ranges[i], down.low) - parts) < 1e-12);
            else
                assert_true(down.low == 0 && i == 0);
        }
    }
    assert_true(app_range_move(&line, TRUE, -3).high > line.low);
    assert_true(app_range_move(&decades, FALSE, 3).low < decades.high);
}

/* In colour the picture has the levels of its file, and with another exposure channels by the curve of sRGB. */
static void paints_colors(void **state)
{
    (void)state;
    Painting painting = begin("warm-and-cold", NULL, NULL);
    guint8 *levels = g_malloc(3 * painting.count);
    const float *rgb = luxel_field_rgb_single(painting.field);
    double ends[2], greatest = 0;
    luxel_field_srgb(painting.field, levels);
    paint(&painting);
    for (gsize i = 0; i < painting.count; i++)
        for (gsize c = 0; c < 3; c++) {
            assert_int_equal(painting.pixels[4 * i + 2 - c], levels[3 * i + c]);
            greatest = fmax(greatest, (double)rgb[3 * i + c]);
        }
    app_display_ends(&painting.display, painting.field, ends);
    assert_true(ends[1] == greatest && painting.high == greatest);
    painting.display.exposure = 1;
    paint(&painting);
    for (gsize i = 0; i < painting.count; i++) {
        double color[3];
        for (gsize c = 0; c < 3; c++)
            color[c] = luxel_srgb_curve(CLAMP(2 * (double)rgb[3 * i + c] / greatest, 0, 1));
        expect_color(painting.pixels + 4 * i, color,
                     3); /* where the curve is steep, a step of the table is three levels */
    }
    g_free(levels);
    finish(&painting);
}

/* Temperatures have the range from the least to the greatest; what is grey has no channels. */
static void shows_channels(void **state)
{
    (void)state;
    Painting painting = begin("warm-and-cold", NULL, NULL), grey = begin("sphere", NULL, NULL);
    luxel_field *view = app_display_view(painting.field, APP_CHANNEL_CCT);
    AppDisplay display = painting.display;
    double low, high;
    assert_null(app_display_view(painting.field, APP_CHANNEL_COLORS));
    assert_null(app_display_view(grey.field, APP_CHANNEL_RED));
    display.channel = APP_CHANNEL_CCT;
    assert_false(app_display_is_plain(&display));
    app_display_range(&display, view, &low, &high);
    assert_true(fabs(low - 2700) < 1 && fabs(high - 6500) < 1);
    luxel_field_free(view);
    finish(&painting);
    finish(&grey);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_plain_at_first),
        cmocka_unit_test(shows_the_grey_of_the_file),
        cmocka_unit_test(shows_the_colors_of_the_file),
        cmocka_unit_test(shows_the_palette),
        cmocka_unit_test(shows_logarithms),
        cmocka_unit_test(shows_exposure),
        cmocka_unit_test(shows_a_locked_range),
        cmocka_unit_test(always_has_a_range),
        cmocka_unit_test(paints_around_the_surface_only),
        cmocka_unit_test(shows_differences_alike_both_ways),
        cmocka_unit_test(paints_either_precision),
        cmocka_unit_test(moves_ends),
        cmocka_unit_test(paints_colors),
        cmocka_unit_test(shows_channels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

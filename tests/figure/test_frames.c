/* SPDX-License-Identifier: MIT */
/* Frames of plots: what is told of them is where they are drawn, at every size and with every legend. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <luxel/drawing.h>

enum { WIDTH = 420, HEIGHT = 260, SAMPLES = 41 };

static const double ink_of_frame[3] = {0, 0, 1}, ground[3] = {1, 1, 1};

/* Draws on white in blue. */
static cairo_t *begin(luxel_drawing_style *style, double letters)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, WIDTH, HEIGHT);
    cairo_t *cairo = cairo_create(surface);
    cairo_surface_destroy(surface);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    luxel_drawing_style_init(style, false);
    style->letters = letters;
    memcpy(style->ink, ink_of_frame, sizeof style->ink);
    memcpy(style->ground, ground, sizeof style->ground);
    return cairo;
}

/* How dark a dot is that is not white, 0 to 255. */
static int darkness(cairo_t *cairo, int x, int y)
{
    cairo_surface_t *surface = cairo_get_target(cairo);
    cairo_surface_flush(surface);
    const unsigned char *row =
        cairo_image_surface_get_data(surface) + (size_t)y * (size_t)cairo_image_surface_get_stride(surface);
    return 255 - row[4 * x + 2];
}

/* Whether there is a line along the whole side: each of its places is inked, within a dot across. */
static void assert_side(cairo_t *cairo, double x1, double y1, double x2, double y2)
{
    const int steps = 50;
    for (int i = 0; i <= steps; i++) {
        const int x = (int)floor(x1 + (x2 - x1) * i / steps), y = (int)floor(y1 + (y2 - y1) * i / steps);
        int most = 0;
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++)
                if (x + dx >= 0 && x + dx < WIDTH && y + dy >= 0 && y + dy < HEIGHT)
                    most = darkness(cairo, x + dx, y + dy) > most ? darkness(cairo, x + dx, y + dy) : most;
        assert_true(most > 40);
    }
}

static void assert_drawn_there(cairo_t *cairo, const luxel_plot_frame *frame)
{
    const double right = frame->x + frame->width, low = frame->y + frame->height;
    assert_true(frame->width > 50 && frame->height > 50);
    assert_side(cairo, frame->x, frame->y, right, frame->y);
    assert_side(cairo, frame->x, low, right, low);
    assert_side(cairo, frame->x, frame->y, frame->x, low);
    assert_side(cairo, right, frame->y, right, low);
}

static void profiles(void **state)
{
    (void)state;
    luxel_profile_sample samples[SAMPLES];
    double shares[SAMPLES][2];
    const char *const names[] = {"key", "a fill with a name that is long"};
    const luxel_profile profile = {
        .quantity_word = "brightness", .count = SAMPLES, .samples = samples, .lights = 2, .shares = &shares[0][0]};
    for (int i = 0; i < SAMPLES; i++) {
        samples[i] =
            (luxel_profile_sample){.abscissa = i, .x_mm = 3 * i - 20, .y_mm = 5, .has_value = true, .value = 4};
        shares[i][0] = 3;
        shares[i][1] = 1;
    }
    for (int i = 0; i < 6; i++) {
        luxel_drawing_style style;
        luxel_profile_style how;
        luxel_plot_frame frame;
        cairo_t *cairo = begin(&style, i % 2 ? 9 : 14);
        luxel_profile_style_init(&how);
        how.along = LUXEL_ALONG_X;
        how.names = i < 2 ? NULL : names;
        how.high = i < 4 ? (double)NAN : 12345;
        assert_int_equal(luxel_draw_profile(cairo, &style, &profile, &how, WIDTH, HEIGHT), LUXEL_OK);
        assert_int_equal(luxel_profile_frame(&style, &profile, &how, WIDTH, HEIGHT, &frame), LUXEL_OK);
        assert_drawn_there(cairo, &frame);
        assert_true(frame.left == -20 && frame.right == 100 && frame.bottom == 0);
        assert_true(i < 4 ? fabs(frame.top - 4.24) < 1e-12 : frame.top == 12345);
        cairo_destroy(cairo);
    }
}

static void histograms(void **state)
{
    (void)state;
    const double edges[] = {1, 10, 100, 1000};
    const size_t counts[] = {100, 0, 50};
    const luxel_histogram histogram = {
        .scale = LUXEL_HISTOGRAM_LOGARITHMIC, .bins = 3, .edges = edges, .counts = counts};
    luxel_drawing_style style;
    luxel_plot_frame frame;
    cairo_t *cairo = begin(&style, 11);
    assert_int_equal(luxel_draw_histogram(cairo, &style, &histogram, NULL, "x", "y", WIDTH, HEIGHT), LUXEL_OK);
    assert_int_equal(luxel_histogram_frame(&style, &histogram, "x", "y", WIDTH, HEIGHT, &frame), LUXEL_OK);
    assert_drawn_there(cairo, &frame);
    assert_true(frame.left == 1 && frame.right == 1000 && frame.bottom == 0 && fabs(frame.top - 106) < 1e-12);
    cairo_destroy(cairo);
}

/* Where there is no room for a plot, its frame has no size; what cannot be drawn has none that is told. */
static void small_and_refused(void **state)
{
    (void)state;
    const double edges[] = {0, 1};
    const size_t counts[] = {3};
    const luxel_histogram histogram = {.bins = 1, .edges = edges, .counts = counts};
    const luxel_profile_sample samples[2] = {{.abscissa = 0}, {.abscissa = 1}};
    const luxel_profile profile = {.quantity_word = "brightness", .count = 2, .samples = samples};
    luxel_profile_style how;
    luxel_drawing_style style;
    luxel_plot_frame frame = {.width = 7};
    luxel_drawing_style_init(&style, false);
    assert_int_equal(luxel_profile_frame(&style, &profile, NULL, 9, 9, &frame), LUXEL_OK);
    assert_true(frame.width == 0 && frame.height == 0);
    frame.width = 7;
    assert_int_equal(luxel_histogram_frame(&style, &histogram, "x", "y", 9, 9, &frame), LUXEL_OK);
    assert_true(frame.width == 0 && frame.height == 0);
    luxel_profile_style_init(&how);
    how.along = LUXEL_ALONG_X; /* which is the same everywhere */
    assert_int_equal(luxel_profile_frame(&style, &profile, &how, 200, 100, &frame), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_profile_frame(NULL, &profile, NULL, 200, 100, &frame), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_profile_frame(&style, NULL, NULL, 200, 100, &frame), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_profile_frame(&style, &profile, NULL, 0, 100, &frame), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_profile_frame(&style, &profile, NULL, 200, 100, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_histogram_frame(NULL, &histogram, NULL, NULL, 200, 100, &frame), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_histogram_frame(&style, NULL, NULL, NULL, 200, 100, &frame), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_histogram_frame(&style, &histogram, NULL, NULL, 200, (double)NAN, &frame),
                     LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_histogram_frame(&style, &histogram, NULL, NULL, 200, 100, NULL), LUXEL_ERROR_ARGUMENT);
}

/* Ticks have the mark that is asked for: drawings differ by it where there are fractions, and in nothing where not. */
static void decimal_marks(void **state)
{
    (void)state;
    for (int fractions = 0; fractions < 2; fractions++) {
        const luxel_color_bar bar = {.low = 0, .high = fractions ? 2.5 : 5000};
        cairo_surface_t *drawn[2];
        for (int comma = 0; comma < 2; comma++) {
            luxel_drawing_style style;
            cairo_t *cairo = begin(&style, 10);
            assert_int_equal(style.decimal_mark, '.');
            style.decimal_mark = comma ? ',' : '.';
            assert_int_equal(luxel_draw_color_bar(cairo, &style, &bar, WIDTH, HEIGHT), LUXEL_OK);
            drawn[comma] = cairo_surface_reference(cairo_get_target(cairo));
            cairo_surface_flush(drawn[comma]);
            cairo_destroy(cairo);
        }
        const size_t size = (size_t)cairo_image_surface_get_stride(drawn[0]) * HEIGHT;
        const int same = memcmp(cairo_image_surface_get_data(drawn[0]), cairo_image_surface_get_data(drawn[1]), size);
        assert_int_equal(same != 0, fractions);
        cairo_surface_destroy(drawn[0]);
        cairo_surface_destroy(drawn[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(profiles),
        cmocka_unit_test(histograms),
        cmocka_unit_test(small_and_refused),
        cmocka_unit_test(decimal_marks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* The painter: the newest wish wins, pixels are those of the scene, faults are told, slow scenes come in two steps. */
#include <math.h>
#include <string.h>

#include "scenes.h"

/* A painter and what it showed. */
typedef struct Studio {
    AppPainter *painter;
    AppDocument *document;
    GPtrArray *pictures;
    AppWish wish; /* to be asked for next */
} Studio;

static void keep(AppPicture *picture, gpointer owner)
{
    Studio *studio = owner;
    g_ptr_array_add(studio->pictures, app_picture_ref(picture));
}

static void unref_picture(gpointer picture)
{
    app_picture_unref(picture);
}

static Studio *begin_studio(AppDocument *document)
{
    Studio *studio = g_new0(Studio, 1);
    studio->document = document;
    studio->pictures = g_ptr_array_new_with_free_func(unref_picture);
    studio->wish = (AppWish){.solo = -1};
    app_display_init(&studio->wish.display);
    studio->wish.display.outline = FALSE; /* it is drawn over the pixels, which most tests look at */
    studio->painter = app_painter_new(keep, studio);
    return studio;
}

static Studio *open_studio(const char *scene)
{
    return begin_studio(document_of_builtin(scene));
}

static void close_studio(Studio *studio)
{
    app_painter_free(studio->painter);
    g_ptr_array_unref(studio->pictures);
    g_object_unref(studio->document);
    g_free(studio);
}

static void ask(Studio *studio)
{
    studio->wish.scene = app_document_copy_scene(studio->document);
    studio->wish.serial = app_document_serial(studio->document);
    app_painter_ask(studio->painter, &studio->wish);
}

static AppPicture *picture_at(const Studio *studio, guint i)
{
    return g_ptr_array_index(studio->pictures, i);
}

static AppPicture *last_picture(const Studio *studio)
{
    assert_true(studio->pictures->len > 0);
    return picture_at(studio, studio->pictures->len - 1);
}

static gboolean is_idle(gpointer data)
{
    return !app_painter_is_busy(((Studio *)data)->painter) && !g_main_context_pending(NULL);
}

/* Asks, and waits for the whole answer. */
static AppPicture *picture_of(Studio *studio)
{
    ask(studio);
    wait_until(is_idle, studio);
    return last_picture(studio);
}

static gboolean has_picture(gpointer data)
{
    return ((Studio *)data)->pictures->len > 0;
}

static gboolean has_two_pictures(gpointer data)
{
    return ((Studio *)data)->pictures->len > 1;
}

/* Makes the scene one that takes seconds. */
static void make_slow(AppDocument *document)
{
    set(document, "screen.resolution", "[2000, 2000]");
    set(document, "screen.width", "1000");
    set(document, "screen.height", "1000");
}

/* Asserts that the pixels are those of a field, painted by the display, for a view that shows them as they are. */
static void expect_pixels(const AppPicture *picture, const AppDisplay *display, const luxel_field *field)
{
    double low, high;
    const gsize count = (gsize)luxel_field_columns(field) * luxel_field_rows(field);
    guchar *pixels = g_malloc(4 * count);
    app_display_range(display, field, &low, &high);
    app_display_paint(display, field, low, high, pixels);
    assert_int_equal(picture->columns, luxel_field_columns(field));
    assert_int_equal(picture->rows, luxel_field_rows(field));
    assert_true(picture->low == low && picture->high == high);
    for (gsize i = 0; i < count; i++)
        for (gsize k = 0; k < 3; k++)
            if (picture->pixels[3 * i + k] != pixels[4 * i + 2 - k])
                fail_msg("pixel %zu differs", i);
    g_free(pixels);
}

/* ---- cases ---- */

/* A ball over a floor, each of which lights the other. */
static void make_reflecting(AppDocument *document)
{
    set(document, "surfaces",
        "[{type: rectangle, center: [0, 0, 0], size: [900, 900],"
        "  material: {model: lambert, diffuse: 0.7, over_pi: true}},"
        " {type: sphere, center: [0, 0, 400], radius: 150, material: {model: lambert, diffuse: 0.5, over_pi: true}}]");
    set(document, "lights", "[{type: point, position: [-300, 0, 900], power: 20, attenuation: inverse-square}]");
    set(document, "screen.resolution", "[40, 40]");
    set(document, "reflections", "1");
}

static void expect_field(const AppPicture *picture, const AppDocument *document)
{
    AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
    assert_true(picture->shot->is_fine);
    assert_memory_equal(luxel_field_single(picture->shot->field), luxel_field_single(shot->field),
                        40 * 40 * sizeof(float));
    app_shot_unref(shot);
}

/* Direct light comes first, and is called that; the last picture has all light. */
static void shows_direct_light_first(void **state)
{
    (void)state;
    Studio *studio = open_studio("report");
    make_reflecting(studio->document);
    AppPicture *last = picture_of(studio);
    assert_null(last->faults);
    assert_true(studio->pictures->len >= 2);
    const AppPicture *direct = picture_at(studio, studio->pictures->len - 2);
    assert_true(direct->shot->moment->is_direct && !last->shot->moment->is_direct);
    assert_int_equal(direct->serial, last->serial);
    expect_field(last, studio->document);
    set(studio->document, "reflections", "none");
    expect_field(direct, studio->document);
    /* what is only painted anew, and what is compared, is all light */
    set(studio->document, "reflections", "1");
    picture_of(studio);
    studio->wish.display.palette = "viridis";
    const guint before = studio->pictures->len;
    picture_of(studio);
    studio->wish.pinned = last_picture(studio)->shot;
    set(studio->document, "lights[0].power", "30");
    picture_of(studio);
    for (guint i = before; i < studio->pictures->len; i++)
        assert_false(picture_at(studio, i)->shot->moment->is_direct);
    close_studio(studio);
}

static void paints_what_is_computed(void **state)
{
    (void)state;
    for (gsize i = 0; i < luxel_builtin_scene_count(); i++) {
        Studio *studio = open_studio(luxel_builtin_scene_name(i));
        set(studio->document, "screen.resolution", "[100, 80]");
        set(studio->document, "screen.width", "800");
        set(studio->document, "screen.height", "640");
        /* grey pictures keep to a range that the scene has */
        char *range = app_document_get(studio->document, "picture.range", NULL);
        studio->wish.display.palette = i % 2 || (range && strcmp(range, "max") != 0) ? "viridis" : "grey";
        g_free(range);
        studio->wish.quantity = i % 3 ? LUXEL_BRIGHTNESS : LUXEL_IRRADIANCE;
        AppPicture *picture = picture_of(studio);
        AppShot *shot = shot_of(studio->document, studio->wish.quantity);
        assert_null(picture->faults);
        assert_true(picture->shot->is_fine);
        assert_int_equal(picture->side, APP_SIDE_LIVE);
        assert_int_equal(picture->serial, app_document_serial(studio->document));
        assert_int_equal(picture->shot->moment->serial, picture->serial);
        assert_int_equal(luxel_field_quantity(picture->shot->field), studio->wish.quantity);
        assert_memory_equal(luxel_field_single(picture->shot->field), luxel_field_single(shot->field),
                            100 * 80 * sizeof(float));
        expect_pixels(picture, &studio->wish.display, shot->field);
        AppArea area = app_area_of(shot->field);
        assert_memory_equal(&picture->area, &area, sizeof area);
        app_shot_unref(shot);
        close_studio(studio);
    }
}

static void shows_the_newest(void **state)
{
    (void)state;
    enum { WISHES = 200 };
    Studio *studio = open_studio("report");
    char value[32];
    for (int i = 0; i < WISHES; i++) {
        g_snprintf(value, sizeof value, "[%d, 500, 2000]", 10 * i);
        set(studio->document, "lights[0].position", value);
        ask(studio);
    }
    wait_until(is_idle, studio);
    guint64 before = 0;
    for (guint i = 0; i < studio->pictures->len; i++) {
        const AppPicture *picture = picture_at(studio, i);
        assert_null(picture->faults);
        assert_true(picture->serial >= before);
        before = picture->serial;
    }
    const AppPicture *last = last_picture(studio);
    assert_int_equal(last->serial, app_document_serial(studio->document));
    assert_true(last->shot->is_fine);
    AppShot *shot = shot_of(studio->document, LUXEL_BRIGHTNESS);
    expect_pixels(last, &studio->wish.display, shot->field);
    app_shot_unref(shot);
    close_studio(studio);
}

/* The scene is the same: it is not computed again. */
static void paints_anew_without_computing(void **state)
{
    (void)state;
    Studio *studio = open_studio("report");
    const AppPicture *one = picture_of(studio);
    studio->wish.display.palette = "inferno";
    const AppPicture *other = picture_of(studio);
    assert_ptr_equal(other->shot, one->shot);
    assert_string_equal(other->display.palette, "inferno");
    expect_pixels(other, &studio->wish.display, one->shot->field);
    studio->wish.quantity = LUXEL_IRRADIANCE;
    assert_ptr_not_equal(picture_of(studio)->shot, one->shot);
    close_studio(studio);
}

/* The outline is a line of the view: at the rim of the sphere, as wide however large the pixels are, and soft. */
static void draws_the_outline_as_a_line(void **state)
{
    (void)state;
    static const double RADIUS = 300, SCALE = 2;
    Studio *studio = open_studio("report");
    set(studio->document, "screen.width", "700");
    set(studio->document, "screen.height", "700");
    set(studio->document, "screen.resolution", "[35, 35]"); /* pixels of 20 mm, 40 dots of the view */
    studio->wish.frame = (AppFrame){{700, 700}, SCALE, 1400, 1400};
    AppPicture *plain = app_picture_ref(picture_of(studio));
    studio->wish.display.outline = TRUE;
    const AppPicture *drawn = picture_of(studio);
    gsize changed = 0, far = 0, soft = 0;
    for (guint row = 0; row < drawn->rows; row++)
        for (guint column = 0; column < drawn->columns; column++) {
            const gsize i = 3 * ((gsize)row * drawn->columns + column);
            if (drawn->pixels[i] == plain->pixels[i])
                continue;
            const double x = drawn->area.low[0] + (column + 0.5) / SCALE;
            const double y = drawn->area.high[1] - (row + 0.5) / SCALE;
            changed++;
            far += fabs(hypot(x, y) - RADIUS) * SCALE > 1.6;
            soft += plain->pixels[i] == 0 && drawn->pixels[i] < 100;
        }
    assert_int_equal(far, 0);
    assert_true((double)changed > 2 * G_PI * RADIUS * SCALE * 0.9);
    assert_true(soft > changed / 10);
    app_picture_unref(plain);
    close_studio(studio);
}

static void fits_the_view(void **state)
{
    (void)state;
    Studio *studio = open_studio("report");
    studio->wish.frame = (AppFrame){{100, 80}, 0.25, 200, 160};
    const AppPicture *picture = picture_of(studio);
    guint columns, rows;
    AppArea area;
    guchar *pixels = g_malloc(360 * 360 * 4), *fitted;
    app_display_paint(&picture->display, picture->shot->field, picture->low, picture->high, pixels);
    fitted = app_resample(pixels, picture->shot->field, &studio->wish.frame, FALSE, &columns, &rows, &area);
    assert_int_equal(picture->columns, columns);
    assert_int_equal(picture->rows, rows);
    assert_memory_equal(&picture->area, &area, sizeof area);
    for (gsize i = 0; i < (gsize)columns * rows; i++)
        assert_int_equal(picture->pixels[3 * i], fitted[4 * i + 2]);
    studio->wish.frame.origin[0] = 9000; /* none of it is seen */
    picture = picture_of(studio);
    assert_int_equal(picture->columns, 360);
    g_free(pixels);
    g_free(fitted);
    close_studio(studio);
}

static void shows_one_light_alone(void **state)
{
    (void)state;
    Studio *studio = open_studio("three-lights");
    set(studio->document, "screen.resolution", "[125, 100]");
    set(studio->document, "lights[1].enabled", "false");
    AppDocument *alone = app_document_copy(studio->document);
    set(alone, "lights[0].enabled", "false");
    set(alone, "lights[1].enabled", "true");
    set(alone, "lights[2].enabled", "false");
    studio->wish.solo = 1;
    const AppPicture *picture = picture_of(studio);
    AppShot *shot = shot_of(alone, LUXEL_BRIGHTNESS);
    assert_int_equal(picture->shot->moment->solo, 1);
    assert_memory_equal(luxel_field_single(picture->shot->field), luxel_field_single(shot->field), 125 * 100 * 4);
    studio->wish.solo = -1;
    const AppPicture *all = picture_of(studio);
    assert_memory_not_equal(luxel_field_single(all->shot->field), luxel_field_single(shot->field), 125 * 100 * 4);
    app_shot_unref(shot);
    g_object_unref(alone);
    close_studio(studio);
}

static void tells_faults_and_goes_on(void **state)
{
    (void)state;
    Studio *studio = open_studio("report");
    picture_of(studio);
    set(studio->document, "lights[0].intensity", "-5");
    const AppPicture *picture = picture_of(studio);
    assert_null(picture->shot);
    assert_non_null(picture->faults);
    assert_int_equal(picture->serial, app_document_serial(studio->document));
    assert_int_equal(luxel_diagnostics_total(picture->faults, LUXEL_SEVERITY_ERROR), 1);
    assert_string_equal(luxel_diagnostics_get(picture->faults, 0)->key, "lights[0].intensity");
    set(studio->document, "lights[0].intensity", "5");
    picture = picture_of(studio);
    assert_null(picture->faults);
    assert_non_null(picture->shot);
    studio->wish.solo = 9; /* there is no such light to be alone: all are off */
    picture = picture_of(studio);
    assert_true(picture->shot || picture->faults);
    assert_true(app_document_undo(studio->document));
    studio->wish.solo = -1;
    assert_non_null(picture_of(studio)->faults);
    close_studio(studio);
}

/* The values that are told of the pixels are the field's, and there are none where no surface is. */
static void expect_values(const AppPicture *picture, const luxel_field *field)
{
    const guint columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    const guint8 *mask = luxel_field_mask(field);
    double value;
    for (guint row = 0; row < rows; row += 7)
        for (guint column = 0; column < columns; column++) {
            const gboolean any = app_picture_value(picture, column, row, &value);
            assert_int_equal(any, mask[(gsize)row * columns + column] != 0);
            if (any)
                assert_true(fabs(value - luxel_field_value(field, column, row)) <= 1e-6 * fabs(value));
        }
    assert_false(app_picture_value(picture, columns, 0, &value));
    assert_false(app_picture_value(picture, 0, rows, &value));
}

static void compares_with_what_was_pinned(void **state)
{
    (void)state;
    Studio *studio = open_studio("report");
    AppShot *pinned = app_shot_ref(picture_of(studio)->shot);
    set(studio->document, "lights[0].intensity", "20");
    studio->wish.pinned = pinned;
    studio->wish.side = APP_SIDE_DIFFERENCE;
    const AppPicture *picture = picture_of(studio);
    luxel_comparison comparison;
    luxel_field *difference;
    assert_true(picture->has_comparison);
    assert_int_equal(picture->side, APP_SIDE_DIFFERENCE);
    assert_int_equal(luxel_compare(pinned->field, picture->shot->field, NULL, &comparison, &difference), LUXEL_OK);
    assert_true(picture->comparison.rms == comparison.rms);
    assert_true(picture->high == comparison.largest.value && picture->low == -picture->high); /* both ways alike */
    expect_pixels(picture, &picture->display, difference);
    expect_values(picture, difference);
    luxel_field_free(difference);
    studio->wish.side = APP_SIDE_PINNED;
    picture = picture_of(studio);
    assert_int_equal(picture->side, APP_SIDE_PINNED);
    expect_pixels(picture, &studio->wish.display, pinned->field);
    expect_values(picture, pinned->field);
    set(studio->document, "screen.resolution", "[50, 50]"); /* another grid: no difference, the picture itself */
    studio->wish.side = APP_SIDE_DIFFERENCE;
    picture = picture_of(studio);
    assert_false(picture->has_comparison);
    assert_int_equal(picture->side, APP_SIDE_LIVE);
    expect_pixels(picture, &studio->wish.display, picture->shot->field);
    expect_values(picture, picture->shot->field);
    app_shot_unref(pinned);
    close_studio(studio);
}

/* ---- scenes that take longer than a frame ---- */

static void shows_a_quick_look_first(void **state)
{
    (void)state;
    Studio *studio = open_studio("all-sources");
    make_slow(studio->document);
    ask(studio);
    wait_until(has_picture, studio);
    const AppPicture *coarse = picture_at(studio, 0);
    assert_false(coarse->shot->is_fine);
    assert_true(coarse->columns < 2000);
    wait_until(is_idle, studio);
    const AppPicture *fine = last_picture(studio);
    assert_true(studio->pictures->len >= 2);
    for (guint i = 1; i < studio->pictures->len; i++) /* the slower it is, the more come between */
        assert_true(picture_at(studio, i)->columns > picture_at(studio, i - 1)->columns);
    assert_true(fine->shot->is_fine);
    assert_int_equal(fine->columns, 2000);
    assert_int_equal(fine->serial, coarse->serial);
    const double pixel = (coarse->area.high[0] - coarse->area.low[0]) / coarse->columns;
    for (int k = 0; k < 2; k++) { /* of the same screen, up to what a large pixel is wider */
        assert_true(fabs(fine->area.low[k] - coarse->area.low[k]) <= pixel);
        assert_true(fabs(fine->area.high[k] - coarse->area.high[k]) <= pixel);
    }
    close_studio(studio);
}

/* A sky over a box takes milliseconds for a pixel: what is seen first has few, and ever finer ones follow it. */
static void grows_finer(void **state)
{
    (void)state;
    static const char *const text =
        "luxel: 1\nscreen: {width: 6000, height: 4000, resolution: [150, 100]}\n"
        "observer: {position: [-5000, -8000, 6000], target: [0, 0, 500], up: [0, 0, 1]}\n"
        "surfaces:\n  - {type: rectangle, center: [0, 0, 0], size: [6000, 6000]}\n"
        "  - {type: box, center: [600, 0, 750], size: [1000, 1000, 1500], up: z}\n"
        "lights: [{type: sky, kind: 12, horizontal: 100, sun: {altitude: 40, azimuth: 200}}]\n";
    Studio *studio = begin_studio(document_of_text(text));
    ask(studio);
    wait_until(has_two_pictures, studio);
    assert_true(picture_at(studio, 0)->columns <= 20);
    assert_true(picture_at(studio, 1)->columns > picture_at(studio, 0)->columns);
    assert_false(picture_at(studio, 1)->shot->is_fine);
    close_studio(studio);
}

static gboolean is_computing(gpointer data)
{
    double done = -1, seconds = -1;
    if (!app_painter_progress(((Studio *)data)->painter, &done, &seconds))
        return FALSE;
    assert_true(done >= 0 && done <= 1);
    assert_true(seconds >= 0);
    return TRUE;
}

static void gives_up_what_is_outdated(void **state)
{
    (void)state;
    Studio *studio = open_studio("all-sources");
    double done, seconds;
    assert_false(app_painter_progress(studio->painter, &done, &seconds));
    make_slow(studio->document);
    ask(studio);
    wait_until(is_computing, studio); /* the fine one */
    const guint64 slow = app_document_serial(studio->document);
    assert_true(app_document_open_builtin(studio->document, "report", NULL));
    ask(studio);
    wait_until(is_idle, studio);
    for (guint i = 0; i < studio->pictures->len; i++) {
        const AppPicture *picture = picture_at(studio, i);
        assert_null(picture->faults); /* to be given up is no fault */
        assert_true(picture->serial != slow || !picture->shot->is_fine);
    }
    assert_int_equal(last_picture(studio)->columns, 360);
    assert_true(last_picture(studio)->shot->is_fine);
    assert_false(app_painter_progress(studio->painter, &done, &seconds));
    close_studio(studio);
}

/* After a quick scene a slow one whose wishes never cease: it is not given up time after time. */
static void follows_a_slow_scene_too(void **state)
{
    (void)state;
    Studio *studio = open_studio("report");
    picture_of(studio);
    assert_true(app_document_open_builtin(studio->document, "all-sources", NULL));
    make_slow(studio->document);
    const guint64 slow = app_document_serial(studio->document);
    const gint64 end = g_get_monotonic_time() + 100 * G_USEC_PER_SEC;
    char value[16];
    for (int i = 0; last_picture(studio)->serial < slow; i++) {
        g_snprintf(value, sizeof value, "%d", 300 + i % 100);
        set(studio->document, "surfaces[0].radius", value);
        ask(studio);
        run_for(30);
        assert_true(g_get_monotonic_time() < end);
    }
    close_studio(studio);
}

static void stops_while_computing(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        Studio *studio = open_studio("all-sources");
        make_slow(studio->document);
        ask(studio);
        if (i > 0)
            wait_until(i == 1 ? has_picture : is_computing, studio);
        ask(studio);
        close_studio(studio);
        run_for(10);
    }
    app_painter_free(NULL);
    app_picture_unref(NULL);
    app_shot_unref(NULL);
    app_moment_unref(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shows_direct_light_first),
        cmocka_unit_test(paints_what_is_computed),
        cmocka_unit_test(shows_the_newest),
        cmocka_unit_test(paints_anew_without_computing),
        cmocka_unit_test(fits_the_view),
        cmocka_unit_test(shows_one_light_alone),
        cmocka_unit_test(tells_faults_and_goes_on),
        cmocka_unit_test(compares_with_what_was_pinned),
        cmocka_unit_test(shows_a_quick_look_first),
        cmocka_unit_test(grows_finer),
        cmocka_unit_test(gives_up_what_is_outdated),
        cmocka_unit_test(follows_a_slow_scene_too),
        cmocka_unit_test(stops_while_computing),
        cmocka_unit_test(draws_the_outline_as_a_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

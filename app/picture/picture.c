/* SPDX-License-Identifier: MIT */
/*
 * The painter's work.  From what the last picture took for a pixel it foretells what the next will take: within a
 * frame it computes every pixel and lets nothing interrupt it, so that a slider that moves all the time is followed
 * all the time; beyond that it computes as many pixels as a frame allows, shows them, and goes on with the whole.
 */
#include "picture.h"

#include <cairo.h>
#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../base/runner.h"

static const double FRAME_SECONDS = 0.011; /* of the 16.7 ms of a frame, what painting and showing leave */
static const double FIRST_SECONDS = 0.3;   /* that the first coarse picture may take */
static const double WHOLE_SECONDS = 1;     /* a whole that takes longer has ever finer ones before it */
static const double LONG_SECONDS = 0.1;    /* a coarse picture that takes longer may be given up after all */
enum { FIRST_STRIDE = 8, LARGEST_STRIDE = 64, FINER = 4, PERMILLE = 1000 };

struct AppPainter {
    AppRunner *runner;
    void (*show)(AppPicture *picture, gpointer owner);
    gpointer owner;
    /* shared with the thread */
    int permille;   /* atomic; -1: nothing is computed */
    int started_ms; /* atomic; the lower bits of the monotonic time; written before permille is set to 0 */
};

typedef struct Work {
    AppPainter *painter;
    AppShot *last;            /* the last fine one, of direct light as well */
    AppShot *seen;            /* of which this channel was painted last; NULL: none was */
    double seconds_per_pixel; /* of the last picture; 0: not known */
    luxel_quantity quantity;  /* that is wished */
} Work;

/* ---- moments, shots, pictures ---- */

static void clear_picture(gpointer data)
{
    AppPicture *picture = data;
    app_shot_unref(picture->shot);
    app_shot_unref(picture->pinned);
    g_free(picture->pixels);
    luxel_diagnostics_free(picture->faults);
}

AppPicture *app_picture_ref(AppPicture *picture)
{
    return g_atomic_rc_box_acquire(picture);
}

void app_picture_unref(AppPicture *picture)
{
    if (picture)
        g_atomic_rc_box_release_full(picture, clear_picture);
}

static gboolean value_of(const luxel_field *field, guint column, guint row, double *value)
{
    const guint columns = luxel_field_columns(field);
    if (column >= columns || row >= luxel_field_rows(field) || !luxel_field_mask(field)[(gsize)row * columns + column])
        return FALSE;
    *value = luxel_field_value(field, column, row);
    return TRUE;
}

gboolean app_picture_value(const AppPicture *picture, guint column, guint row, double *value)
{
    double minus = 0;
    if (picture->side == APP_SIDE_PINNED)
        return value_of(picture->pinned->field, column, row, value);
    if (!value_of(picture->shot->field, column, row, value) ||
        (picture->side == APP_SIDE_DIFFERENCE && !value_of(picture->pinned->field, column, row, &minus)))
        return FALSE;
    *value -= minus;
    return TRUE;
}

/* The moment without what its surfaces reflect; NULL: they reflect nothing, or the scene has faults. */
static AppMoment *direct_moment(const AppWish *wish)
{
    luxel_scene *scene = luxel_scene_copy(wish->scene);
    AppMoment *moment = NULL;
    if (scene && app_scene_leave_direct(scene))
        moment = app_moment_new(g_steal_pointer(&scene), wish->serial, wish->solo, NULL);
    luxel_scene_free(scene);
    if (moment)
        moment->is_direct = TRUE;
    return moment;
}

/* ---- computing ---- */

/* What a computation is watched with. */
typedef struct Watch {
    AppRunner *runner;
    AppPainter *painter;
    gint64 started;
    gboolean is_coarse;
    Work *work;
    AppWish *wish; /* that reflected light is found for; NULL: it is not */
} Watch;

static void free_wish(gpointer data)
{
    AppWish *wish = data;
    luxel_scene_free(wish->scene);
    app_shot_unref(wish->pinned);
    g_free(wish);
}

static double seconds_since(gint64 started)
{
    return (double)(g_get_monotonic_time() - started) / G_USEC_PER_SEC;
}

/* Small enough for atomic access on every machine; differences are right for weeks. */
static guint milliseconds(gint64 time)
{
    return (guint)(time / 1000);
}

static void paint_and_report(Work *work, AppRunner *runner, const AppWish *wish, AppShot *shot);

/* Whether a wish is for the light that another one is for, shown in another way. */
static gboolean is_same_light(gconstpointer job, gconstpointer data)
{
    const AppWish *newer = job, *wish = data;
    return newer->serial == wish->serial && newer->solo == wish->solo && newer->quantity == wish->quantity &&
           newer->is_direct == wish->is_direct && !newer->pinned && !wish->pinned;
}

/* Reflected light takes long, and whoever zooms or chooses colours meanwhile goes on waiting for it: the direct light
 * is painted as it is wished now. */
static gboolean take_over(const Watch *watch)
{
    AppWish *newer = watch->wish ? app_runner_take(watch->runner, is_same_light, watch->wish) : NULL;
    if (!newer)
        return FALSE;
    watch->wish->display = newer->display;
    watch->wish->frame = newer->frame;
    free_wish(newer);
    if (watch->work->last)
        paint_and_report(watch->work, watch->runner, watch->wish, watch->work->last);
    return TRUE;
}

static bool watch(double done, void *data)
{
    const Watch *watch = data;
    if (!watch->is_coarse)
        g_atomic_int_set(&watch->painter->permille, (int)(done * PERMILLE));
    if (!app_runner_is_outdated(watch->runner) || take_over(watch))
        return true;
    return watch->is_coarse && seconds_since(watch->started) < LONG_SECONDS;
}

/* At least so long it would have taken: else the next one would be tried and given up in the same way. */
static void note_given_up(Work *work, const luxel_scene *scene, guint stride, double seconds)
{
    unsigned columns, rows;
    luxel_scene_resolution(scene, &columns, &rows);
    const double pixels = ceil((double)columns / stride) * ceil((double)rows / stride);
    work->seconds_per_pixel = fmax(work->seconds_per_pixel, seconds / pixels);
}

/* Computes each stride-th pixel; NULL where it was given up or failed.  `wish`: see Watch. */
static AppShot *compute(Work *work, AppRunner *runner, AppMoment *moment, guint stride, gboolean is_short,
                        AppWish *wish, luxel_diagnostics *faults)
{
    Watch watched = {runner, work->painter, g_get_monotonic_time(), is_short, work, wish};
    luxel_settings settings;
    luxel_field *field;
    luxel_settings_init(&settings);
    settings.quantity = work->quantity;
    settings.stride = stride;
    settings.progress = watch;
    settings.progress_data = &watched;
    app_moment_light(moment, &settings);
    if (!is_short) {
        g_atomic_int_set(&work->painter->started_ms, (int)milliseconds(watched.started));
        g_atomic_int_set(&work->painter->permille, 0);
    }
    luxel_status status = luxel_render(moment->scene, &settings, faults, &field);
    g_atomic_int_set(&work->painter->permille, -1);
    if (status == LUXEL_CANCELLED)
        note_given_up(work, moment->scene, stride, seconds_since(watched.started));
    if (status != LUXEL_OK)
        return NULL;
    AppShot *shot = g_atomic_rc_box_new0(AppShot);
    *shot = (AppShot){.moment = app_moment_ref(moment),
                      .field = field,
                      .is_fine = stride == 1,
                      .seconds = seconds_since(watched.started)};
    work->seconds_per_pixel = shot->seconds / ((double)luxel_field_columns(field) * luxel_field_rows(field));
    return shot;
}

/* ---- painting ---- */

static AppPicture *new_picture(const AppWish *wish)
{
    AppPicture *picture = g_atomic_rc_box_new0(AppPicture);
    picture->display = wish->display;
    picture->serial = wish->serial;
    return picture;
}

/* Colours on both sides of zero, as far as the difference goes. */
static AppDisplay display_of_difference(const AppDisplay *display, double largest)
{
    AppDisplay changed = *display;
    changed.palette = "coolwarm";
    changed.logarithmic = FALSE;
    changed.exposure = 0;
    changed.is_locked = TRUE;
    changed.high = largest > 0 ? largest : 1;
    changed.low = -changed.high;
    return changed;
}

/* Compares with the pinned picture; the field to show, which is `difference` or that of one of the two. */
static const luxel_field *choose_field(const AppWish *wish, const AppShot *shot, AppPicture *picture,
                                       luxel_field **difference)
{
    *difference = NULL;
    if (!wish->pinned)
        return shot->field;
    picture->pinned = app_shot_view(wish->pinned, shot->channel);
    picture->has_comparison = luxel_compare(picture->pinned->field, shot->field, NULL, &picture->comparison,
                                            wish->side == APP_SIDE_DIFFERENCE ? difference : NULL) == LUXEL_OK;
    picture->side = wish->side;
    if (*difference)
        return *difference;
    if (wish->side == APP_SIDE_DIFFERENCE)
        picture->side = APP_SIDE_LIVE; /* they cannot be compared */
    return picture->side == APP_SIDE_PINNED ? picture->pinned->field : shot->field;
}

/* From four bytes a pixel to three, in place: what the toolkit puts on the screen fastest. */
static void pack(AppPicture *picture)
{
    const gsize count = (gsize)picture->columns * picture->rows;
    guchar *to = picture->pixels;
    for (const guchar *from = picture->pixels; from < picture->pixels + 4 * count; from += 4, to += 3) {
        const guchar blue = from[0], green = from[1], red = from[2];
        to[0] = red;
        to[1] = green;
        to[2] = blue;
    }
}

/* Whoever paints it on a machine of the other byte order sees blue first, too. */
static void swap_bytes(AppPicture *picture)
{
    guint32 *words = (guint32 *)(void *)picture->pixels;
    for (gsize i = 0; i < (gsize)picture->columns * picture->rows && G_BYTE_ORDER == G_BIG_ENDIAN; i++)
        words[i] = GUINT32_SWAP_LE_BE(words[i]);
}

/* The outlines as lines of the view's own dots, over the pixels of four bytes. */
static void draw_outlines(AppPicture *picture, AppMoment *moment)
{
    static const double WIDTH = 1.4;
    if (!moment->outlines && luxel_find_surface_outlines(moment->scene, NULL, &moment->outlines) != LUXEL_OK)
        return;
    const double *ground = picture->display.background;
    const double grey = 0.3 * ground[0] + 0.6 * ground[1] + 0.1 * ground[2] > 0.5 ? 0.35 : 0.5;
    const AppArea *area = &picture->area;
    swap_bytes(picture);
    cairo_surface_t *surface = cairo_image_surface_create_for_data(
        picture->pixels, CAIRO_FORMAT_RGB24, (int)picture->columns, (int)picture->rows, (int)picture->columns * 4);
    cairo_t *cairo = cairo_create(surface);
    const double across = picture->columns / (area->high[0] - area->low[0]);
    const double down = picture->rows / (area->high[1] - area->low[1]);
    for (gsize i = 0; i < moment->outlines->count; i++) {
        const luxel_surface_outline *line = &moment->outlines->lines[i];
        for (gsize k = 0; k < line->count; k++)
            cairo_line_to(cairo, (line->x_mm[k] - area->low[0]) * across, (area->high[1] - line->y_mm[k]) * down);
        cairo_new_sub_path(cairo);
    }
    cairo_set_source_rgb(cairo, grey, grey, grey);
    cairo_set_line_width(cairo, WIDTH);
    cairo_stroke(cairo);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    swap_bytes(picture);
}

/* Where the view shows none of it, or none is meant, the picture stays as it is. */
static void fit_to_frame(AppPicture *picture, const luxel_field *field, const AppFrame *frame, AppMoment *moment)
{
    picture->area = app_area_of(field);
    guchar *fitted = frame->width > 0 ? app_resample(picture->pixels, field, frame, !picture->shot->is_fine,
                                                     &picture->columns, &picture->rows, &picture->area)
                                      : NULL;
    if (fitted) {
        g_free(picture->pixels);
        picture->pixels = fitted;
    }
    if (picture->display.outline)
        draw_outlines(picture, moment);
    pack(picture);
}

/* Shown as the PNG has it, the colours have the range of the scene's `picture`. */
static void take_plain_range(AppPicture *picture, const luxel_field *field)
{
    char *range = NULL;
    double pair[2];
    if (luxel_scene_get(picture->shot->moment->scene, "picture.range", NULL, NULL, &range) != LUXEL_OK || !range)
        return;
    AppDisplay shown = picture->display;
    shown.logarithmic = strcmp(range, "log") == 0;
    if (app_list_read(range, pair, 2) == 2) {
        shown.is_locked = TRUE;
        shown.low = pair[0];
        shown.high = pair[1];
    }
    app_display_range(&shown, field, &picture->low, &picture->high);
    if (strcmp(range, "minmax") == 0) {
        app_display_ends(&shown, field, pair);
        picture->low = MIN(pair[0], picture->high * (1 - 1e-9));
    }
    picture->display.logarithmic = shown.logarithmic;
    luxel_text_free(range);
}

/* The shot as it shows the channel that is wished; that of the last one is kept. */
static AppShot *see(Work *work, AppShot *shot, AppChannel channel)
{
    AppShot *seen = work->seen && work->seen->whole == shot ? work->seen : shot;
    AppShot *next = app_shot_view(seen, channel);
    app_shot_unref(work->seen);
    work->seen = next;
    return app_shot_ref(next);
}

static void paint_and_report(Work *work, AppRunner *runner, const AppWish *wish, AppShot *shot)
{
    AppPicture *picture = new_picture(wish);
    luxel_field *difference;
    const gboolean is_grey = wish->pinned && luxel_field_channels(app_shot_light(wish->pinned)) == 1;
    picture->shot = see(work, shot, is_grey ? APP_CHANNEL_COLORS : wish->display.channel);
    picture->display.channel = picture->shot->channel;
    const luxel_field *field = choose_field(wish, picture->shot, picture, &difference);
    if (difference)
        picture->display = display_of_difference(&picture->display, picture->comparison.largest.value);
    picture->serial = shot->moment->serial; /* whatever was wished meanwhile */
    picture->columns = luxel_field_columns(field);
    picture->rows = luxel_field_rows(field);
    picture->pixels = g_malloc((gsize)picture->columns * picture->rows * 4);
    app_display_range(&picture->display, field, &picture->low, &picture->high);
    app_display_paint(&picture->display, field, picture->low, picture->high, picture->pixels);
    fit_to_frame(picture, field, &wish->frame,
                 picture->side == APP_SIDE_PINNED ? picture->pinned->moment : shot->moment);
    if (app_display_is_plain(&picture->display))
        take_plain_range(picture, field);
    luxel_field_free(difference);
    app_runner_report(runner, picture);
}

static void report_faults(AppRunner *runner, const AppWish *wish, luxel_diagnostics *faults)
{
    AppPicture *picture = new_picture(wish);
    picture->faults = faults;
    app_runner_report(runner, picture);
}

/* ---- the work ---- */

static double pixels_of(const AppMoment *moment)
{
    unsigned columns, rows;
    luxel_scene_resolution(moment->scene, &columns, &rows);
    return (double)columns * rows;
}

static guint stride_for(const Work *work, double pixels)
{
    if (work->seconds_per_pixel <= 0)
        return FIRST_STRIDE;
    double stride = ceil(sqrt(work->seconds_per_pixel * pixels / FRAME_SECONDS));
    return (guint)CLAMP(stride, 1, LARGEST_STRIDE);
}

/* Keeps and shows a fine picture. */
static void finish(Work *work, AppRunner *runner, const AppWish *wish, AppShot *shot)
{
    paint_and_report(work, runner, wish, shot);
    app_shot_unref(work->last);
    work->last = shot;
}

/* Shows a coarse picture, which is freed, unless the whole, as is known then, is there in a frame; FALSE: there is none
 * as it was given up, or a newer wish has come. */
static gboolean show_coarse(Work *work, AppRunner *runner, const AppWish *wish, AppShot *coarse)
{
    const gboolean is_shown = coarse && stride_for(work, pixels_of(coarse->moment)) > 1;
    if (is_shown)
        paint_and_report(work, runner, wish, coarse);
    const gboolean goes_on = coarse && !(is_shown && app_runner_is_outdated(runner));
    app_shot_unref(coarse);
    return goes_on;
}

/* Where nothing is known of how long pixels take, a few of them tell whether those of the first picture are too many:
 * they are the first picture then, else NULL, and their time is too uncertain to count. */
static AppShot *try_few(Work *work, AppRunner *runner, AppMoment *moment)
{
    AppShot *few = compute(work, runner, moment, LARGEST_STRIDE, TRUE, NULL, NULL);
    if (few && work->seconds_per_pixel * pixels_of(moment) > FIRST_SECONDS * FIRST_STRIDE * FIRST_STRIDE)
        return few;
    work->seconds_per_pixel = 0;
    app_shot_unref(few);
    return NULL;
}

/* Ever finer pictures come before a whole that takes long. */
static void compute_and_paint(Work *work, AppRunner *runner, const AppWish *wish, AppMoment *moment,
                              luxel_diagnostics *faults)
{
    const double pixels = pixels_of(moment);
    AppShot *coarse = work->seconds_per_pixel > 0 ? NULL : try_few(work, runner, moment);
    guint stride = coarse ? LARGEST_STRIDE : stride_for(work, pixels);
    if (stride > 1) {
        do {
            if (!coarse)
                coarse = compute(work, runner, moment, stride, TRUE, NULL, faults);
            if (!show_coarse(work, runner, wish, g_steal_pointer(&coarse)))
                return;
            stride /= FINER;
        } while (stride >= FINER && work->seconds_per_pixel * pixels > WHOLE_SECONDS);
        stride = stride_for(work, pixels);
    }
    AppShot *fine = compute(work, runner, moment, 1, stride == 1, NULL, faults);
    if (fine)
        finish(work, runner, wish, fine);
}

/* All of the light, after the direct light was shown; how fast that follows the hand stays known. */
static void add_reflected(Work *work, AppRunner *runner, AppWish *wish, AppMoment *moment, luxel_diagnostics *faults)
{
    const double known = work->seconds_per_pixel;
    AppShot *shot = compute(work, runner, moment, 1, FALSE, wish, faults);
    work->seconds_per_pixel = known;
    if (shot)
        finish(work, runner, wish, shot);
}

/* Whether the last fine picture shows what is wished, so that it need only be painted anew. */
static gboolean is_last(const Work *work, const AppWish *wish)
{
    return work->last && work->last->moment->serial == wish->serial && work->last->moment->solo == wish->solo &&
           luxel_field_quantity(work->last->field) == wish->quantity &&
           (!work->last->moment->is_direct || wish->is_direct);
}

static void do_wish(AppRunner *runner, gpointer job, gpointer state)
{
    AppWish *wish = job;
    Work *work = state;
    if (is_last(work, wish)) {
        paint_and_report(work, runner, wish, work->last);
        return;
    }
    work->quantity = wish->quantity;
    luxel_diagnostics *faults = luxel_diagnostics_new();
    AppMoment *direct = direct_moment(wish);
    const gboolean is_shown = direct && !wish->pinned; /* what is compared is all light */
    if (is_shown)
        compute_and_paint(work, runner, wish, direct, NULL);
    const gboolean is_enough = is_shown && (wish->is_direct || app_runner_is_outdated(runner));
    AppMoment *moment =
        is_enough ? NULL : app_moment_new(g_steal_pointer(&wish->scene), wish->serial, wish->solo, faults);
    if (moment)
        moment->direct = direct ? app_moment_ref(direct) : NULL;
    if (moment && is_shown)
        add_reflected(work, runner, wish, moment, faults);
    else if (moment)
        compute_and_paint(work, runner, wish, moment, faults);
    app_moment_unref(direct);
    app_moment_unref(moment);
    if (luxel_diagnostics_total(faults, LUXEL_SEVERITY_ERROR) > 0)
        report_faults(runner, wish, faults);
    else
        luxel_diagnostics_free(faults);
}

static void free_work(gpointer data)
{
    Work *work = data;
    app_shot_unref(work->last);
    app_shot_unref(work->seen);
    g_free(work);
}

static void deliver(gpointer report, gpointer owner)
{
    AppPainter *painter = owner;
    painter->show(report, painter->owner);
}

static void unref_picture(gpointer picture)
{
    app_picture_unref(picture);
}

AppPainter *app_painter_new(void (*show)(AppPicture *picture, gpointer owner), gpointer owner)
{
    static const AppRunnerClass class = {"painter", do_wish, free_wish, unref_picture, free_work, 10};
    AppPainter *painter = g_new0(AppPainter, 1);
    Work *work = g_new0(Work, 1);
    work->painter = painter;
    *painter = (AppPainter){.show = show, .owner = owner, .permille = -1};
    painter->runner = app_runner_new(&class, work, deliver, painter);
    return painter;
}

void app_painter_free(AppPainter *painter)
{
    if (!painter)
        return;
    app_runner_stop(painter->runner);
    g_free(painter);
}

void app_painter_ask(AppPainter *painter, const AppWish *wish)
{
    AppWish *copy = g_new(AppWish, 1);
    *copy = *wish;
    if (copy->pinned)
        app_shot_ref(copy->pinned);
    app_runner_post(painter->runner, copy);
}

gboolean app_painter_is_busy(AppPainter *painter)
{
    return app_runner_is_busy(painter->runner);
}

gboolean app_painter_progress(AppPainter *painter, double *done, double *seconds)
{
    int permille = g_atomic_int_get(&painter->permille);
    if (permille < 0)
        return FALSE;
    *done = (double)permille / PERMILLE;
    *seconds = (milliseconds(g_get_monotonic_time()) - (guint)g_atomic_int_get(&painter->started_ms)) / 1000.0;
    return TRUE;
}

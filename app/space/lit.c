/* SPDX-License-Identifier: MIT */
/*
 * The thread's work.  From what the last picture took for a pixel it foretells how fine a picture may be that comes in
 * some time; each later one may take longer, and waits until the hand rests.
 */
#include "lit.h"

#include <math.h>

#include "../base/number.h"
#include "../base/runner.h"

enum { NICE = 10, REST_MS = 120 };
static const double STEPS[] = {0.03, 0.25, 1.2, 6}; /* seconds that pictures of a view may take, one after another */
static const double FINENESS[] = {1, 0.5, 0.25, 0.125, 0.0625}; /* of the finest */
static const double LEAST = 1e-7;                               /* seconds for a pixel */
static const double PATIENCE = 0.2; /* seconds that a picture of a view that is gone may still take */
static const double BEFORE = 2e-3;  /* of a distance: what is less nearer does not hide */

struct AppLighter {
    AppRunner *runner;
    void (*show)(AppLit *lit, gpointer owner);
    gpointer owner;
};

typedef struct Work {
    double seconds_per_pixel; /* of the last picture; 0: there was none */
} Work;

/* ---- pictures ---- */

static void clear_lit(gpointer data)
{
    AppLit *lit = data;
    app_moment_unref(lit->moment);
    g_free(lit->pixels);
    g_free(lit->depth_mm);
}

AppLit *app_lit_ref(AppLit *lit)
{
    return g_atomic_rc_box_acquire(lit);
}

void app_lit_unref(AppLit *lit)
{
    if (lit)
        g_atomic_rc_box_release_full(lit, clear_lit);
}

double app_lit_depth(const AppLit *lit, double x, double y)
{
    if (!lit->depth_mm)
        return 0;
    /* the pixels are square: the rows may reach beyond the widget by a part of one */
    const double per_dot = lit->depth_columns / lit->orbit.width;
    const double column = floor(x * per_dot),
                 row = floor((y - lit->orbit.height / 2) * per_dot + lit->depth_rows / 2.0);
    return column >= 0 && row >= 0 && column < lit->depth_columns && row < lit->depth_rows
               ? (double)lit->depth_mm[(gsize)row * lit->depth_columns + (gsize)column]
               : 0;
}

gboolean app_lit_hides(const AppLit *lit, const double seen[3])
{
    const double depth = app_lit_depth(lit, seen[0], seen[1]);
    return depth > 0 && depth < seen[2] * (1 - BEFORE);
}

/* ---- making them ---- */

typedef struct Watch {
    AppRunner *runner;
    gint64 started;
} Watch;

static double seconds_since(gint64 started)
{
    return (double)(g_get_monotonic_time() - started) / G_USEC_PER_SEC;
}

static bool goes_on(double done, void *data)
{
    const Watch *watch = data;
    (void)done;
    return !app_runner_is_outdated(watch->runner) || seconds_since(watch->started) < PATIENCE;
}

/* The light that is there at once. */
static const AppMoment *light_of(const AppLitWish *wish)
{
    return wish->moment->direct ? wish->moment->direct : wish->moment;
}

/* The scene with the range of the observer's picture, where the colours are those of its PNG. */
static luxel_scene *ranged_scene(const AppLitWish *wish)
{
    luxel_scene *scene = luxel_scene_copy(light_of(wish)->scene);
    const double range[2] = {wish->low, wish->high};
    char *list = app_list_write(range, 2), *assignment = g_strdup_printf("picture.range=%s", list);
    if (scene)
        (void)luxel_scene_set(scene, assignment, NULL);
    g_free(assignment);
    g_free(list);
    return scene;
}

static luxel_scene *seen_scene(const AppLitWish *wish, double dots)
{
    const camera from = app_orbit_camera(&wish->orbit, dots);
    luxel_scene *scene = app_display_is_plain(&wish->display) ? ranged_scene(wish) : NULL;
    luxel_scene *seen = camera_scene(scene ? scene : light_of(wish)->scene, &from, NULL);
    luxel_scene_free(scene);
    return seen;
}

static void paint(AppLit *lit, const AppLitWish *wish, const luxel_field *whole)
{
    luxel_field *view = app_display_view(whole, wish->display.channel);
    const luxel_field *field = view ? view : whole;
    AppDisplay display = wish->display;
    const guint8 *mask = luxel_field_mask(field);
    lit->columns = luxel_field_columns(field);
    lit->rows = luxel_field_rows(field);
    const gsize count = (gsize)lit->columns * lit->rows;
    lit->pixels = g_new(guint32, count);
    app_display_paint(&display, field, wish->low, wish->high, (guchar *)lit->pixels);
    for (gsize i = 0; i < count; i++)
        if (!mask[i])
            lit->pixels[i] = 0;
    luxel_field_free(view);
}

static void find_depth(AppLit *lit, const AppLitWish *wish, double dots, const luxel_settings *settings)
{
    const camera from = app_orbit_camera(&wish->orbit, dots);
    luxel_scene *scene = camera_scene(light_of(wish)->scene, &from, NULL);
    const gsize count = (gsize)from.columns * from.rows;
    lit->depth_columns = from.columns;
    lit->depth_rows = from.rows;
    lit->depth_mm = g_new0(float, count);
    if (!scene || camera_depth(scene, settings, NULL, lit->depth_mm, count) != LUXEL_OK)
        g_clear_pointer(&lit->depth_mm, g_free);
    luxel_scene_free(scene);
}

/* NULL: it was given up. */
static AppLit *light(Work *work, AppRunner *runner, const AppLitWish *wish, double fineness)
{
    const double dots = wish->dots * fineness;
    Watch watched = {runner, g_get_monotonic_time()};
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_status status = LUXEL_OK;
    AppLit *lit = g_atomic_rc_box_new0(AppLit);
    lit->orbit = wish->orbit;
    luxel_settings_init(&settings);
    settings.quantity = wish->quantity;
    settings.progress = goes_on;
    settings.progress_data = &watched;
    app_moment_light(light_of(wish), &settings);
    luxel_scene *scene = seen_scene(wish, dots);
    watched.started = g_get_monotonic_time(); /* what a pixel takes is foretold */
    if (scene)
        status = luxel_render(scene, &settings, NULL, &field);
    luxel_scene_free(scene);
    const double pixels = wish->orbit.width * wish->orbit.height * dots * dots;
    work->seconds_per_pixel = seconds_since(watched.started) / MAX(pixels, 1);
    if (field) {
        lit->moment = app_moment_ref(wish->moment);
        paint(lit, wish, field);
        find_depth(lit, wish, dots / 2, &settings);
        luxel_field_free(field);
    }
    if (status != LUXEL_CANCELLED)
        return lit;
    app_lit_unref(lit);
    return NULL;
}

/* The finest of the pictures that come in so many seconds, or the coarsest. */
static gsize finest_within(const Work *work, const AppLitWish *wish, double seconds)
{
    gsize i = 0;
    while (i + 1 < G_N_ELEMENTS(FINENESS) &&
           wish->orbit.width * wish->orbit.height * pow(wish->dots * FINENESS[i], 2) * work->seconds_per_pixel >
               seconds)
        i++;
    return i;
}

static void do_wish(AppRunner *runner, gpointer job, gpointer state)
{
    const AppLitWish *wish = job;
    Work *work = state;
    gsize last = G_N_ELEMENTS(FINENESS);
    if (!(work->seconds_per_pixel > 0))
        work->seconds_per_pixel = MAX(wish->seconds, LEAST);
    for (gsize step = 0; step < G_N_ELEMENTS(STEPS) && last > 0; step++) {
        const gsize next = finest_within(work, wish, STEPS[step]);
        if (next >= last)
            continue;
        if (last < G_N_ELEMENTS(FINENESS) && app_runner_rest(runner, REST_MS))
            return;
        AppLit *lit = light(work, runner, wish, FINENESS[next]);
        if (!lit)
            return;
        const gboolean is_seen = lit->moment != NULL;
        app_runner_report(runner, lit);
        last = next;
        if (!is_seen || app_runner_is_outdated(runner))
            return;
    }
}

static void free_wish(gpointer data)
{
    AppLitWish *wish = data;
    app_moment_unref(wish->moment);
    g_free(wish);
}

static void deliver(gpointer report, gpointer owner)
{
    AppLighter *lighter = owner;
    lighter->show(report, lighter->owner);
}

static void unref_lit(gpointer lit)
{
    app_lit_unref(lit);
}

AppLighter *app_lighter_new(void (*show)(AppLit *lit, gpointer owner), gpointer owner)
{
    static const AppRunnerClass class = {"lighter", do_wish, free_wish, unref_lit, g_free, NICE};
    AppLighter *lighter = g_new(AppLighter, 1);
    Work *work = g_new0(Work, 1);
    *lighter = (AppLighter){.show = show, .owner = owner};
    lighter->runner = app_runner_new(&class, work, deliver, lighter);
    return lighter;
}

void app_lighter_free(AppLighter *lighter)
{
    if (!lighter)
        return;
    app_runner_stop(lighter->runner);
    g_free(lighter);
}

void app_lighter_ask(AppLighter *lighter, const AppLitWish *wish)
{
    AppLitWish *copy = g_new(AppLitWish, 1);
    *copy = *wish;
    app_moment_ref(copy->moment);
    app_runner_post(lighter->runner, copy);
}

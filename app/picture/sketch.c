/* SPDX-License-Identifier: MIT */
/* Grey levels are those that the scene's own grey PNG has, of every n-th pixel. */
#include "sketch.h"

#include <luxel/luxel.h>
#include <string.h>

#include "../base/runner.h"
#include "../files/document.h"
#include "picture.h"

static const double PATIENCE_SECONDS = 2; /* for a scene */
enum { NICE = 10 };

struct AppSketcher {
    AppRunner *runner;
    void (*show)(const AppSketch *sketch, gpointer owner);
    gpointer owner;
};

typedef struct Watch {
    AppRunner *runner;
    gint64 started;
} Watch;

static bool watch(double done, void *data)
{
    const Watch *watch = data;
    (void)done;
    return !app_runner_is_outdated(watch->runner) &&
           (double)(g_get_monotonic_time() - watch->started) < PATIENCE_SECONDS * G_USEC_PER_SEC;
}

static luxel_scene *open_scene(const char *name)
{
    luxel_scene *scene = NULL;
    const luxel_status status = g_str_has_prefix(name, APP_BUILTIN)
                                    ? luxel_scene_open_builtin(name + strlen(APP_BUILTIN), NULL, &scene)
                                    : luxel_scene_read_file(name, NULL, &scene);
    if (status == LUXEL_OK)
        app_scene_leave_direct(scene);
    if (status == LUXEL_OK && luxel_scene_commit(scene, NULL) == LUXEL_OK)
        return scene;
    if (status == LUXEL_OK)
        luxel_scene_free(scene);
    return NULL;
}

static GBytes *paint(const luxel_field *field)
{
    const gsize size = 3 * (gsize)luxel_field_columns(field) * luxel_field_rows(field);
    guint8 *pixels = g_malloc(size);
    luxel_field_srgb(field, pixels);
    return g_bytes_new_take(pixels, size);
}

static AppSketch *draw(AppRunner *runner, const char *name)
{
    AppSketch *sketch = g_new(AppSketch, 1);
    luxel_scene *scene = open_scene(name);
    Watch watched = {runner, g_get_monotonic_time()};
    luxel_settings settings;
    luxel_field *field;
    unsigned columns, rows;
    *sketch = (AppSketch){.scene = g_strdup(name)};
    if (!scene)
        return sketch;
    luxel_scene_resolution(scene, &columns, &rows);
    luxel_settings_init(&settings);
    settings.stride = MAX(MIN(columns / APP_SKETCH_COLUMNS, rows / APP_SKETCH_ROWS), 1);
    settings.threads = 1;
    settings.progress = watch;
    settings.progress_data = &watched;
    if (luxel_render(scene, &settings, NULL, &field) == LUXEL_OK) {
        sketch->pixels = paint(field);
        sketch->columns = luxel_field_columns(field);
        sketch->rows = luxel_field_rows(field);
        luxel_field_free(field);
    }
    luxel_scene_free(scene);
    return sketch;
}

/* ---- the thread ---- */

static void work(AppRunner *runner, gpointer job, gpointer state)
{
    char **scenes = job;
    (void)state;
    for (guint i = 0; scenes[i] && !app_runner_is_outdated(runner); i++)
        app_runner_report(runner, draw(runner, scenes[i]));
}

static void free_sketch(gpointer data)
{
    AppSketch *sketch = data;
    g_clear_pointer(&sketch->pixels, g_bytes_unref);
    g_free(sketch->scene);
    g_free(sketch);
}

static void deliver(gpointer report, gpointer owner)
{
    AppSketcher *sketcher = owner;
    sketcher->show(report, sketcher->owner);
}

AppSketcher *app_sketcher_new(void (*show)(const AppSketch *sketch, gpointer owner), gpointer owner)
{
    static const AppRunnerClass class = {"sketches", work, (GDestroyNotify)g_strfreev, free_sketch, NULL, NICE};
    AppSketcher *sketcher = g_new(AppSketcher, 1);
    *sketcher = (AppSketcher){.show = show, .owner = owner};
    sketcher->runner = app_runner_new(&class, NULL, deliver, sketcher);
    return sketcher;
}

void app_sketcher_free(AppSketcher *sketcher)
{
    if (!sketcher)
        return;
    app_runner_stop(sketcher->runner);
    g_free(sketcher);
}

void app_sketcher_ask(AppSketcher *sketcher, const char *const *scenes)
{
    app_runner_post(sketcher->runner, g_strdupv((char **)scenes));
}

/* SPDX-License-Identifier: MIT */
/* What is written, and how. */
#include "export.h"

#include <math.h>
#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"

enum { MOST_FAULTS = 3 };

static const AppExport exports[] = {
    {"png8", N_("Picture, PNG of 8 bits…"), ".png"},
    {"png16", N_("Picture, PNG of 16 bits…"), ".png"},
    {"figure-png", N_("Figure with colour bar, PNG…"), ".png"},
    {"figure-svg", N_("Figure with colour bar, SVG…"), ".svg"},
    {"figure-pdf", N_("Figure with colour bar, PDF…"), ".pdf"},
    {"exr", N_("Numbers, OpenEXR…"), ".exr"},
    {"npy", N_("Numbers, NumPy…"), ".npy"},
    {"csv", N_("Numbers, CSV…"), ".csv"},
    {"report", N_("Report, PDF…"), ".pdf"},
};

typedef struct Work {
    const AppExport *how;
    luxel_scene *scene;
    luxel_quantity quantity;
    AppDisplay display;
    AppReport report;
    char *path;
    void (*done)(const char *path, const char *fault, gpointer owner);
} Work;

const AppExport *app_export_get(gsize i)
{
    return i < G_N_ELEMENTS(exports) ? &exports[i] : NULL;
}

const AppExport *app_export_named(const char *name)
{
    for (gsize i = 0; i < G_N_ELEMENTS(exports); i++)
        if (strcmp(exports[i].name, name) == 0)
            return &exports[i];
    return NULL;
}

char *app_faults_text(const luxel_diagnostics *faults, const char *path)
{
    GString *text = g_string_new(NULL);
    gsize shown = 0;
    for (gsize i = 0; i < luxel_diagnostics_count(faults) && shown < MOST_FAULTS; i++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(faults, i);
        if (entry->severity != LUXEL_SEVERITY_ERROR)
            continue;
        char *message = luxel_diagnostics_message(faults, i, language_translate, NULL);
        char *hint = luxel_diagnostics_hint(faults, i, language_translate, NULL);
        if (shown)
            g_string_append(text, "\n");
        if (path && entry->line) /* the path once is enough */
            g_string_append_printf(text, "%s%s%u:%u: ", shown ? "" : path, shown ? "" : ":", entry->line,
                                   entry->column);
        g_string_append_printf(text, "%s%s%s", message ? message : "", hint && *hint ? " – " : "", hint ? hint : "");
        luxel_text_free(message);
        luxel_text_free(hint);
        shown++;
    }
    return g_string_free(text, shown == 0);
}

static luxel_status write_field(const Work *work, const luxel_settings *settings, luxel_diagnostics *faults)
{
    const luxel_field_output how = {.bits = strcmp(work->how->name, "png16") == 0 ? 16 : 8};
    luxel_field *field;
    luxel_status status = luxel_render(work->scene, settings, faults, &field);
    if (status != LUXEL_OK)
        return status;
    status = luxel_field_write_as(field, work->path, &how, faults);
    luxel_field_free(field);
    return status;
}

static luxel_status write_figure(const Work *work, const luxel_settings *settings, luxel_diagnostics *faults)
{
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    luxel_figure_settings figure;
    luxel_figure_settings_init(&figure);
    figure.palette = work->display.palette;
    figure.logarithmic = work->display.logarithmic;
    figure.bands = work->display.isophotes ? LUXEL_BANDS_CONTOURS : LUXEL_BANDS_SMOOTH;
    figure.extrema = work->display.maximum;
    figure.language = &language;
    if (luxel_scene_has_color(work->scene) && work->display.channel != APP_CHANNEL_COLORS)
        figure.view = (luxel_color_view)(work->display.channel - APP_CHANNEL_LUMINANCE + LUXEL_VIEW_LUMINANCE);
    if (work->display.is_locked) {
        figure.low = work->display.low;
        figure.high = work->display.high;
    }
    return luxel_figure_write(work->scene, settings, &figure, work->path, faults);
}

static const char *text_or_none(const char *text)
{
    return text && *text ? text : NULL;
}

static luxel_status write_report(const Work *work, const luxel_settings *settings, luxel_diagnostics *faults)
{
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    const luxel_report_settings report = {.language = &language,
                                          .author = text_or_none(work->report.author),
                                          .group = text_or_none(work->report.group),
                                          .date = text_or_none(work->report.date),
                                          .institution = text_or_none(work->report.institution),
                                          .faculty = text_or_none(work->report.faculty),
                                          .course = text_or_none(work->report.course),
                                          .teacher = text_or_none(work->report.teacher),
                                          .place = text_or_none(work->report.place),
                                          .aim = text_or_none(work->report.aim)};
    return luxel_report_write(work->scene, settings, &report, work->path, faults);
}

static void run(GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
    Work *work = data;
    luxel_diagnostics *faults = luxel_diagnostics_new();
    luxel_settings settings;
    (void)source;
    (void)cancellable;
    luxel_settings_init(&settings);
    settings.quantity = work->quantity;
    luxel_status status = luxel_scene_commit(work->scene, faults);
    if (status == LUXEL_OK)
        status = strcmp(work->how->name, "report") == 0         ? write_report(work, &settings, faults)
                 : g_str_has_prefix(work->how->name, "figure-") ? write_figure(work, &settings, faults)
                                                                : write_field(work, &settings, faults);
    char *text = status == LUXEL_OK ? NULL : app_faults_text(faults, NULL);
    if (status != LUXEL_OK && !text)
        text = g_strdup(_("it could not be written"));
    luxel_diagnostics_free(faults);
    g_task_return_pointer(task, text, g_free);
}

static void finished(GObject *owner, GAsyncResult *result, gpointer data)
{
    Work *work = g_task_get_task_data(G_TASK(result));
    char *fault = g_task_propagate_pointer(G_TASK(result), NULL);
    (void)data;
    work->done(work->path, fault, owner);
    g_free(fault);
}

static void free_report(AppReport *report)
{
    char *const texts[] = {report->author, report->group,   report->date,  report->institution, report->faculty,
                           report->course, report->teacher, report->place, report->aim};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
}

static void free_work(gpointer data)
{
    Work *work = data;
    luxel_scene_free(work->scene);
    free_report(&work->report);
    g_free(work->path);
    g_free(work);
}

void app_export(const AppExport *how, luxel_scene *scene, luxel_quantity quantity, const AppDisplay *display,
                const AppReport *report, const char *path,
                void (*done)(const char *path, const char *fault, gpointer owner), GObject *owner)
{
    Work *work = g_new(Work, 1);
    GTask *task = g_task_new(owner, NULL, finished, NULL);
    *work = (Work){how, scene, quantity, *display, *report, g_strdup(path), done};
    g_task_set_task_data(task, work, free_work);
    g_task_run_in_thread(task, run);
    g_object_unref(task);
}

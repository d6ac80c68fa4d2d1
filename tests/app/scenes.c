/* SPDX-License-Identifier: MIT */
/* Scenes for the tests of the app. */
#include "scenes.h"

#include <string.h>

enum { TIMEOUT_SECONDS = 120 };

AppDocument *document_of_builtin(const char *name)
{
    AppDocument *document = app_document_new();
    assert_true(app_document_open_builtin(document, name, NULL));
    return document;
}

AppDocument *document_of_text(const char *text)
{
    AppDocument *document = app_document_new();
    assert_true(app_document_open_unsaved(document, text, NULL, NULL));
    return document;
}

void set(AppDocument *document, const char *key, const char *value)
{
    app_document_begin_gesture(document);
    if (!app_document_set(document, key, value, NULL))
        fail_msg("%s cannot become %s", key, value);
    app_document_end_gesture(document);
}

void assert_key(const AppDocument *document, const char *key, const char *value)
{
    char *found = app_document_get(document, key, NULL);
    assert_non_null(found);
    assert_string_equal(found, value);
    g_free(found);
}

AppMoment *moment_of(const AppDocument *document)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    AppMoment *moment = app_moment_new(app_document_copy_scene(document), app_document_serial(document), -1, faults);
    if (!moment)
        fail_msg("%s\n%s", luxel_diagnostics_message(faults, 0, NULL, NULL), app_document_text(document));
    luxel_diagnostics_free(faults);
    return moment;
}

AppShot *shot_of(const AppDocument *document, luxel_quantity quantity)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = quantity;
    AppShot *shot = g_atomic_rc_box_new0(AppShot);
    shot->moment = moment_of(document);
    shot->is_fine = TRUE;
    assert_int_equal(luxel_render(shot->moment->scene, &settings, NULL, &shot->field), LUXEL_OK);
    return shot;
}

void wait_until(gboolean (*is_done)(gpointer data), gpointer data)
{
    const gint64 end = g_get_monotonic_time() + (gint64)TIMEOUT_SECONDS * G_USEC_PER_SEC;
    while (!is_done(data)) {
        if (g_get_monotonic_time() > end)
            fail_msg("it did not come within %d seconds", TIMEOUT_SECONDS);
        if (!g_main_context_iteration(NULL, FALSE))
            g_usleep(1000);
    }
}

void run_for(guint milliseconds)
{
    const gint64 end = g_get_monotonic_time() + (gint64)milliseconds * 1000;
    while (g_get_monotonic_time() < end)
        if (!g_main_context_iteration(NULL, FALSE))
            g_usleep(1000);
}

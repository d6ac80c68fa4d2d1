/* SPDX-License-Identifier: MIT */
/*
 * Versions of the scene: every change of the document, of the light that alone is seen and of the quantity makes a new
 * one, which pictures, numbers, readings and explanations carry.  What is of another one than the picture is dimmed at
 * once, and never copied; what has not followed for a while says that it is being computed.  A picture that has not
 * followed for a while is dimmed itself, and with it all that belongs to it.
 */
#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/dim.h"
#include "../base/number.h"
#include "../space/space_view.h"
#include "window_private.h"

/* What may be behind, and after how long it is said. */
enum Behind { BEHIND_PICTURE = 1, BEHIND_NUMBERS = 2, BEHIND_READING = 4 };
enum { PATIENCE_MS = 250 };

static gboolean is_latest(const AppWindow *self)
{
    return self->picture && !self->is_stale && self->picture->serial == self->version;
}

/* Whether the picture counts as that of the document, which it follows within a while. */
static gboolean is_followed(const AppWindow *self)
{
    return self->picture && !self->is_stale && (is_latest(self) || !(self->late & BEHIND_PICTURE));
}

AppVersion app_window_version(const AppWindow *self)
{
    return is_followed(self) ? app_version_of(app_window_shot(self), app_window_minus(self))
                             : (AppVersion){.shot = self->version};
}

static gboolean is_read(const AppWindow *self, const AppVersion *version)
{
    return !self->pointer_inside || (app_version_equal(&self->reading, version) &&
                                     memcmp(self->reading_mm, self->pointer_mm, sizeof self->reading_mm) == 0);
}

void app_window_await_reading(AppWindow *self)
{
    char n[2][APP_NUMBER_SIZE];
    char *text = g_strdup_printf("x %s  y %s %s\t%s", app_number_show(self->pointer_mm[0], 5, n[0]),
                                 app_number_show(self->pointer_mm[1], 5, n[1]), _("mm"), _("being computed…"));
    gtk_label_set_text(GTK_LABEL(self->status_label), self->is_stale ? "" : text);
    g_free(text);
    app_dial_set_needle(APP_DIAL(self->bar), (double)NAN);
    app_sources_show_shares(APP_SOURCES(self->sources), NULL);
    app_window_show_vectors(self, NULL);
}

static gboolean grow_late(gpointer data);

/* Tells every part which version is shown; returns what is behind (enum Behind). */
static guint tell_parts(AppWindow *self)
{
    const AppVersion version = app_window_version(self);
    const guint64 live = is_followed(self) ? self->picture->shot->moment->serial : self->version;
    const gboolean has_numbers = app_numbers_set_version(APP_NUMBERS(self->numbers), &version, live, is_latest(self));
    const gboolean has_sources = app_sources_set_version(APP_SOURCES(self->sources), live);
    const gboolean is_dim = self->is_stale || (self->picture && !is_followed(self));
    app_why_set_version(APP_WHY(self->why), version.shot);
    app_view_set_stale(self->view, is_dim);
    for (int i = 0; i < APP_SIGHTS; i++)
        app_sight_set_stale(app_window_sight(self, i), is_dim);
    app_set_stale(self->bar, is_dim);
    app_set_stale(self->status_label, self->pointer_inside && !app_version_equal(&self->reading, &version));
    return (is_latest(self) ? 0 : BEHIND_PICTURE) | (has_numbers && has_sources ? 0 : BEHIND_NUMBERS) |
           (is_read(self, &version) ? 0 : BEHIND_READING);
}

void app_window_judge(AppWindow *self)
{
    const guint behind = tell_parts(self);
    self->late &= behind;
    app_numbers_set_late(APP_NUMBERS(self->numbers), !self->is_stale && (self->late & BEHIND_NUMBERS));
    if (!(behind & ~self->late))
        g_clear_handle_id(&self->late_timer, g_source_remove);
    else if (!self->late_timer)
        self->late_timer = g_timeout_add(PATIENCE_MS, grow_late, self);
}

static gboolean grow_late(gpointer data)
{
    AppWindow *self = data;
    self->late_timer = 0;
    self->late = tell_parts(self);
    if (self->late & BEHIND_READING)
        app_window_await_reading(self);
    app_window_judge(self);
    return G_SOURCE_REMOVE;
}

void app_window_forget(AppWindow *self)
{
    self->first = self->version;
    self->late = 0;
    self->is_direct = FALSE;
    self->surveyed = 0;
    for (int i = 0; i < APP_SIGHTS; i++)
        app_sight_set_lighting(app_window_sight(self, i), NULL, NULL);
    g_clear_pointer(&self->picture, app_picture_unref);
    self->reading = (AppVersion){0};
    app_window_set_stale(self, NULL);
    app_view_forget(self->view);
    app_stage_set_moment(APP_STAGE(self->stage), NULL);
    app_space_view_set_picture(APP_SPACE_VIEW(self->space_view), NULL);
    app_window_show_vectors(self, NULL);
    app_dial_set_picture(APP_DIAL(self->bar), NULL);
    app_dial_set_needle(APP_DIAL(self->bar), (double)NAN);
    app_numbers_forget(APP_NUMBERS(self->numbers));
    app_sources_forget(APP_SOURCES(self->sources));
    app_why_forget(APP_WHY(self->why));
    gtk_label_set_text(GTK_LABEL(self->status_label), "");
    gtk_label_set_text(GTK_LABEL(self->zoom_label), "");
    gtk_label_set_text(GTK_LABEL(self->compare_label), "");
    gtk_widget_set_visible(self->direct_label, FALSE);
}

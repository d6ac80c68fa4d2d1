/* SPDX-License-Identifier: MIT */
/*
 * Explanations take longer than a frame: they are made in a thread, when the pointer rests, and only while they are
 * shown.
 */
#include "why.h"

#include <string.h>

#include "../front/language.h"
#include "../front/words.h"
#include "dim.h"
#include "explained.h"
#include "number.h"

enum { REST_MS = 180, HEIGHT = 190, WHOLE_WIDTH = 820, WHOLE_HEIGHT = 700 };

/* A place that is explained. */
typedef struct Place {
    AppShot *shot;
    double x_mm, y_mm;
} Place;

struct _AppWhy {
    GtkBox parent;
    GtkWidget *toggle, *where, *revealed, *result, *formula, *whole;
    Place place; /* that the pointer was at last; no shot: none yet */
    guint timer;
    gboolean is_busy, is_outdated;
    gsize light;
    char *text;             /* of the place that was explained last; NULL: none */
    guint64 wanted, serial; /* of the version that is shown, and that the text is of */
    GCancellable *cancellable;
};

G_DEFINE_FINAL_TYPE(AppWhy, app_why, GTK_TYPE_BOX)

static void free_place(gpointer data)
{
    Place *place = data;
    app_shot_unref(place->shot);
    g_free(place);
}

/* ---- explaining ---- */

static void show_formula(AppWhy *self)
{
    char *formula = self->text ? app_explained_light(self->text, self->light) : NULL;
    const char *last = formula ? strrchr(formula, '\n') : NULL;
    gtk_label_set_text(GTK_LABEL(self->result), last ? last + 1 : "");
    gtk_widget_set_visible(self->result, last != NULL);
    gtk_label_set_text(GTK_LABEL(self->formula), formula       ? formula
                                                 : !self->text ? _("Rest with the pointer on a surface.")
                                                               : _("The chosen source has no say here."));
    g_free(formula);
}

static void judge(AppWhy *self)
{
    const gboolean is_stale = self->text && self->serial != self->wanted;
    app_set_stale(self->formula, is_stale);
    app_set_stale(self->result, is_stale);
    app_set_stale(self->where, is_stale);
    gtk_widget_set_sensitive(self->whole, self->text && !is_stale);
}

static bool goes_on(double done, void *cancellable)
{
    (void)done;
    return !g_cancellable_is_cancelled(cancellable);
}

static void explain(GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
    const Place *place = data;
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    luxel_settings settings;
    luxel_document *document = NULL;
    (void)source;
    luxel_settings_init(&settings);
    settings.share_reflected = true;
    settings.progress = goes_on;
    settings.progress_data = cancellable;
    settings.quantity = luxel_field_quantity(place->shot->field);
    settings.threads = 1;
    app_moment_light(place->shot->moment, &settings);
    if (luxel_explain(place->shot->moment->scene, &settings, place->x_mm, place->y_mm, &language, NULL, &document) !=
        LUXEL_OK) {
        g_task_return_pointer(task, NULL, NULL);
        return;
    }
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_TEXT);
    g_task_return_pointer(task, text ? app_text_show(text) : NULL, g_free);
    luxel_text_free(text);
    luxel_document_free(document);
}

static void ask(AppWhy *self);

static void explained(GObject *source, GAsyncResult *result, gpointer data)
{
    AppWhy *self = APP_WHY(source);
    char *text = g_task_propagate_pointer(G_TASK(result), NULL);
    const Place *place = g_task_get_task_data(G_TASK(result));
    char x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE];
    (void)data;
    self->is_busy = FALSE;
    if (!self->formula || !self->place.shot) { /* the window went meanwhile, or the scene */
        g_free(text);
        return;
    }
    g_free(self->text);
    self->text = text;
    self->serial = place->shot->moment->serial;
    char *where = g_strdup_printf(_("x = %s, y = %s mm"), app_number_show(place->x_mm, 4, x),
                                  app_number_show(place->y_mm, 4, y));
    gtk_label_set_text(GTK_LABEL(self->where), where);
    g_free(where);
    show_formula(self);
    judge(self);
    if (self->is_outdated)
        ask(self);
}

static void ask(AppWhy *self)
{
    if (!self->place.shot || !gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->toggle)))
        return;
    self->is_outdated = self->is_busy;
    if (self->is_busy)
        return;
    Place *place = g_new(Place, 1);
    *place = self->place;
    app_shot_ref(place->shot);
    GTask *task = g_task_new(self, self->cancellable, explained, NULL);
    g_task_set_task_data(task, place, free_place);
    self->is_busy = TRUE;
    g_task_run_in_thread(task, explain);
    g_object_unref(task);
}

static gboolean rested(gpointer data)
{
    AppWhy *self = data;
    self->timer = 0;
    ask(self);
    return G_SOURCE_REMOVE;
}

void app_why_point(AppWhy *self, AppShot *shot, double x_mm, double y_mm)
{
    app_shot_ref(shot);
    app_shot_unref(self->place.shot);
    self->place = (Place){shot, x_mm, y_mm};
    g_clear_handle_id(&self->timer, g_source_remove);
    if (gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->toggle)))
        self->timer = g_timeout_add(REST_MS, rested, self);
}

void app_why_follow(AppWhy *self, AppShot *shot)
{
    if (!self->place.shot || self->place.shot == shot || self->timer)
        return;
    app_shot_ref(shot);
    app_shot_unref(self->place.shot);
    self->place.shot = shot;
    ask(self);
}

void app_why_set_version(AppWhy *self, guint64 serial)
{
    self->wanted = serial;
    judge(self);
}

void app_why_forget(AppWhy *self)
{
    g_clear_handle_id(&self->timer, g_source_remove);
    g_clear_pointer(&self->place.shot, app_shot_unref);
    g_clear_pointer(&self->text, g_free);
    gtk_label_set_text(GTK_LABEL(self->where), "");
    show_formula(self);
    judge(self);
}

void app_why_choose(AppWhy *self, gsize light)
{
    if (light == self->light)
        return;
    self->light = light;
    show_formula(self);
}

/* ---- the whole ---- */

static GtkWidget *new_text(const char *text)
{
    GtkWidget *view = gtk_text_view_new(), *scrolled = gtk_scrolled_window_new();
    gtk_text_buffer_set_text(gtk_text_view_get_buffer(GTK_TEXT_VIEW(view)), text, -1);
    gtk_text_view_set_editable(GTK_TEXT_VIEW(view), FALSE);
    gtk_text_view_set_cursor_visible(GTK_TEXT_VIEW(view), FALSE);
    gtk_text_view_set_monospace(GTK_TEXT_VIEW(view), TRUE);
    gtk_text_view_set_wrap_mode(GTK_TEXT_VIEW(view), GTK_WRAP_WORD_CHAR);
    gtk_text_view_set_left_margin(GTK_TEXT_VIEW(view), 12);
    gtk_text_view_set_top_margin(GTK_TEXT_VIEW(view), 12);
    gtk_accessible_update_property(GTK_ACCESSIBLE(view), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Why this value?"), -1);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), view);
    return scrolled;
}

static gboolean escape(GtkWidget *widget, GVariant *arguments, gpointer data)
{
    (void)arguments;
    (void)data;
    gtk_window_close(GTK_WINDOW(widget));
    return TRUE;
}

static void show_whole(AppWhy *self)
{
    GtkWidget *window = gtk_window_new();
    GtkEventController *keys = gtk_shortcut_controller_new();
    gtk_window_set_title(GTK_WINDOW(window), _("Why this value?"));
    gtk_window_set_transient_for(GTK_WINDOW(window), GTK_WINDOW(gtk_widget_get_root(GTK_WIDGET(self))));
    gtk_window_set_destroy_with_parent(GTK_WINDOW(window), TRUE);
    gtk_window_set_default_size(GTK_WINDOW(window), WHOLE_WIDTH, WHOLE_HEIGHT);
    gtk_window_set_child(GTK_WINDOW(window), new_text(self->text ? self->text : ""));
    gtk_shortcut_controller_add_shortcut(
        GTK_SHORTCUT_CONTROLLER(keys),
        gtk_shortcut_new(gtk_keyval_trigger_new(GDK_KEY_Escape, 0), gtk_callback_action_new(escape, NULL, NULL)));
    gtk_widget_add_controller(window, keys);
    gtk_window_present(GTK_WINDOW(window));
}

static void toggled(AppWhy *self)
{
    const gboolean active = gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->toggle));
    gtk_widget_set_visible(self->revealed, active);
    gtk_widget_set_visible(self->whole, active);
    ask(self);
}

/* ---- the class ---- */

static void app_why_dispose(GObject *object)
{
    AppWhy *self = APP_WHY(object);
    g_clear_handle_id(&self->timer, g_source_remove);
    g_clear_pointer(&self->place.shot, app_shot_unref);
    self->formula = NULL;
    g_cancellable_cancel(self->cancellable);
    G_OBJECT_CLASS(app_why_parent_class)->dispose(object);
}

static void app_why_finalize(GObject *object)
{
    g_free(APP_WHY(object)->text);
    g_object_unref(APP_WHY(object)->cancellable);
    G_OBJECT_CLASS(app_why_parent_class)->finalize(object);
}

static void app_why_class_init(AppWhyClass *class)
{
    G_OBJECT_CLASS(class)->dispose = app_why_dispose;
    G_OBJECT_CLASS(class)->finalize = app_why_finalize;
}

static void app_why_init(AppWhy *self)
{
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8), *scrolled = gtk_scrolled_window_new();
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 6);
    self->cancellable = g_cancellable_new();
    self->toggle = gtk_toggle_button_new_with_label(_("Why?"));
    self->where = gtk_label_new(NULL);
    self->revealed = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    self->result = gtk_label_new(NULL);
    self->formula = gtk_label_new(NULL);
    self->whole = gtk_button_new_with_label(_("The whole…"));
    gtk_widget_set_tooltip_text(self->whole, _("The whole calculation, as luxel explain prints it"));
    gtk_widget_set_tooltip_text(self->toggle, _("The formula of the chosen source with the numbers of the place where "
                                                "the pointer rests"));
    gtk_label_set_wrap(GTK_LABEL(self->formula), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(self->formula), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_xalign(GTK_LABEL(self->formula), 0);
    gtk_label_set_yalign(GTK_LABEL(self->formula), 0);
    gtk_label_set_selectable(GTK_LABEL(self->formula), TRUE);
    gtk_widget_add_css_class(self->formula, "note");
    gtk_widget_add_css_class(self->where, "numeric");
    /* what was asked for is never below the fold */
    gtk_widget_add_css_class(self->result, "result");
    gtk_label_set_wrap(GTK_LABEL(self->result), TRUE);
    gtk_label_set_xalign(GTK_LABEL(self->result), 0);
    gtk_label_set_selectable(GTK_LABEL(self->result), TRUE);
    gtk_label_set_xalign(GTK_LABEL(self->where), 0);
    gtk_label_set_ellipsize(GTK_LABEL(self->where), PANGO_ELLIPSIZE_END);
    gtk_widget_set_halign(self->whole, GTK_ALIGN_END);
    gtk_widget_set_hexpand(self->whole, TRUE);
    gtk_widget_set_visible(self->whole, FALSE);
    gtk_widget_set_size_request(scrolled, -1, HEIGHT);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), self->formula);
    gtk_box_append(GTK_BOX(line), self->toggle);
    gtk_box_append(GTK_BOX(line), self->whole);
    gtk_box_append(GTK_BOX(self->revealed), self->where); /* on a line of its own, where it is never cut */
    gtk_box_append(GTK_BOX(self->revealed), self->result);
    gtk_box_append(GTK_BOX(self->revealed), scrolled);
    gtk_widget_set_visible(self->revealed, FALSE);
    gtk_box_append(GTK_BOX(self), self->revealed);
    gtk_box_append(GTK_BOX(self), line);
    g_signal_connect_swapped(self->toggle, "toggled", G_CALLBACK(toggled), self);
    g_signal_connect_swapped(self->whole, "clicked", G_CALLBACK(show_whole), self);
    show_formula(self);
    judge(self);
}

GtkWidget *app_why_new(void)
{
    return g_object_new(APP_TYPE_WHY, NULL);
}

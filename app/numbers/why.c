/* SPDX-License-Identifier: MIT */
/*
 * The value and what each source gives of it are read as under the pointer, and follow a hand.  Explanations take
 * longer than a frame: they are made in a thread, when the pointer rests.  Both only while they are shown.
 */
#include "why.h"

#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "../base/dim.h"
#include "../base/letters.h"
#include "../base/lamp.h"
#include "../base/number.h"
#include "../base/row.h"
#include "../picture/color.h"
#include "../picture/measures.h"
#include "explained.h"
#include "sunshine.h"

enum { REST_MS = 180, WIDTH = 276, HEIGHT = 150, WHOLE_WIDTH = 820, WHOLE_HEIGHT = 700, DIGITS = 4, MOST_SHARES = 4 };

/* A place that is explained. */
typedef struct Place {
    AppShot *shot;
    double x_mm, y_mm;
    gssize point; /* of the scene that it is; -1: none */
} Place;

struct _AppWhy {
    GtkBox parent;
    GtkWidget *where, *pin, *result, *shares, *sun, *formula, *whole;
    AppPointer *pointer;
    gboolean is_shown;
    Place place; /* that the pointer was at last; no shot: none yet */
    guint timer;
    gboolean is_busy, is_outdated;
    gsize light;
    char *text;                   /* of the place that was explained last; NULL: none */
    guint64 wanted, serial, read; /* of the version that is shown, and that the text and the value are of */
    GCancellable *cancellable;
};

enum { KEPT, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppWhy, app_why, GTK_TYPE_BOX)

/* Texts about a place; NULL: none. */
typedef struct Told {
    char *text, *sun;
} Told;

static void free_told(gpointer data)
{
    Told *told = data;
    g_free(told->text);
    g_free(told->sun);
    g_free(told);
}

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
    gtk_label_set_text(GTK_LABEL(self->formula), formula       ? formula
                                                 : !self->text ? _("Rest with the pointer on a surface.")
                                                               : _("The chosen source has no say here."));
    g_free(formula);
}

static void judge(AppWhy *self)
{
    const gboolean is_stale = self->text && self->serial != self->wanted;
    app_set_stale(self->formula, is_stale);
    app_set_stale(self->sun, is_stale);
    app_set_stale(self->result, self->read != self->wanted);
    app_set_stale(self->shares, self->read != self->wanted);
    gtk_widget_set_sensitive(self->whole, self->text && !is_stale);
}

/* "1  0.5123  26 %", a line for each of the sources that give most; the others are one line. */
static char *write_shares(const AppReading *reading)
{
    GString *text = g_string_new(NULL);
    gsize *order = app_reading_order(reading);
    double rest = 0;
    for (gsize i = 0; i < reading->share_count && reading->shares[order[i]] != 0; i++) {
        char number[APP_NUMBER_SIZE], percent[APP_NUMBER_SIZE];
        if (i >= MOST_SHARES) {
            rest += reading->shares[order[i]];
            continue;
        }
        char *lamp = app_lamp_markup(order[i]);
        app_number_show(100 * reading->shares[order[i]] / reading->value.value, 2, percent);
        g_string_append_printf(text, "%s%s\t%s\t%s %%", i ? "\n" : "", lamp,
                               app_number_show(reading->shares[order[i]], DIGITS, number), percent);
        g_free(lamp);
    }
    if (rest != 0) {
        char number[APP_NUMBER_SIZE];
        g_string_append_printf(text, "\n+\t%s", app_number_show(rest, DIGITS, number));
    }
    g_free(order);
    return g_string_free(text, FALSE);
}

/* The value first, and what the sources give of it; NULL: there is none yet. */
static void show_reading(AppWhy *self, const AppReading *reading)
{
    const gboolean any = reading && reading->value.on_surface && reading->value.has_value;
    char x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE], value[APP_NUMBER_SIZE];
    char *place = reading ? g_strdup_printf(_("x = %s, y = %s mm"), app_number_show(reading->x_mm, DIGITS, x),
                                            app_number_show(reading->y_mm, DIGITS, y))
                          : g_strdup("");
    char *where =
        reading && self->place.point >= 0 ? g_strdup_printf("P%zd  %s", self->place.point + 1, place) : g_strdup(place);
    char *result = any ? g_markup_printf_escaped("<span size=\"x-large\" weight=\"bold\">%s</span> %s",
                                                 app_number_show(reading->value.value, DIGITS, value),
                                                 gettext(app_moment_unit(reading->moment, reading->quantity)))
                       : g_strdup("");
    char *shares = any && reading->share_count > 1 ? write_shares(reading) : g_strdup("");
    if (any && reading->color.exists) {
        char *parts[] = {app_color_channels(&reading->color), app_color_place(&reading->color),
                         app_color_temperature(&reading->color)};
        char *plain = result;
        result = g_strdup_printf("%s\n<small>%s\n%s\n%s</small>", plain, parts[0], parts[1], parts[2]);
        g_free(plain);
        for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
            g_free(parts[i]);
    }
    gtk_label_set_text(GTK_LABEL(self->where), where);
    gtk_label_set_markup(GTK_LABEL(self->result), result);
    const int column = (int)(WIDTH / 6 * app_letters_scale(self->shares));
    PangoTabArray *tabs =
        pango_tab_array_new_with_positions(2, TRUE, PANGO_TAB_LEFT, column, PANGO_TAB_LEFT, 3 * column);
    gtk_label_set_tabs(GTK_LABEL(self->shares), tabs);
    pango_tab_array_free(tabs);
    gtk_label_set_markup(GTK_LABEL(self->shares), shares);
    gtk_widget_set_visible(self->shares, *shares != '\0');
    g_free(shares);
    g_free(result);
    g_free(where);
    g_free(place);
}

static void value_came(const AppReading *reading, gpointer owner)
{
    AppWhy *self = owner;
    if (!self->place.shot) /* the scene went meanwhile */
        return;
    self->read = reading->version.shot;
    show_reading(self, reading);
    judge(self);
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
    Told *told = g_new0(Told, 1);
    const AppMoment *direct = place->shot->moment->direct;
    if (luxel_explain(place->shot->moment->scene, &settings, place->x_mm, place->y_mm, &language, NULL, &document) ==
        LUXEL_OK) {
        char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_TEXT);
        told->text = text ? app_text_show(text) : NULL;
        luxel_text_free(text);
        luxel_document_free(document);
    }
    told->sun = app_sunshine(direct ? direct->scene : place->shot->moment->scene, &settings, place->x_mm, place->y_mm);
    g_task_return_pointer(task, told, free_told);
}

static void ask(AppWhy *self);

static void explained(GObject *source, GAsyncResult *result, gpointer data)
{
    AppWhy *self = APP_WHY(source);
    Told *told = g_task_propagate_pointer(G_TASK(result), NULL);
    const Place *place = g_task_get_task_data(G_TASK(result));
    (void)data;
    self->is_busy = FALSE;
    if (!told)
        return;
    if (!self->formula || !self->place.shot) { /* the window went meanwhile, or the scene */
        free_told(told);
        return;
    }
    g_free(self->text);
    self->text = g_steal_pointer(&told->text);
    gtk_label_set_text(GTK_LABEL(self->sun), told->sun ? told->sun : "");
    gtk_widget_set_visible(self->sun, told->sun != NULL);
    free_told(told);
    self->serial = place->shot->moment->serial;
    show_formula(self);
    judge(self);
    if (self->is_outdated)
        ask(self);
}

static void ask(AppWhy *self)
{
    if (!self->place.shot || !self->is_shown)
        return;
    app_pointer_ask(self->pointer, self->place.shot, NULL, self->place.x_mm, self->place.y_mm);
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
    if (self->place.shot && gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->pin))) {
        app_why_follow(self, shot);
        return;
    }
    app_shot_ref(shot);
    app_shot_unref(self->place.shot);
    self->place = (Place){shot, x_mm, y_mm, -1};
    g_clear_handle_id(&self->timer, g_source_remove);
    if (self->is_shown)
        self->timer = g_timeout_add(REST_MS, rested, self);
}

static void tell_kept(AppWhy *self)
{
    g_signal_emit(self, signals[KEPT], 0);
}

void app_why_pin(AppWhy *self, AppShot *shot, const double place_mm[2], gssize point)
{
    app_shot_ref(shot);
    app_shot_unref(self->place.shot);
    self->place = (Place){shot, place_mm[0], place_mm[1], point};
    g_clear_handle_id(&self->timer, g_source_remove);
    ask(self);
    if (gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->pin)))
        tell_kept(self);
    else
        gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(self->pin), TRUE);
}

gboolean app_why_pinned(const AppWhy *self, double place_mm[2])
{
    if (!self->is_shown || !self->place.shot || !gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->pin)))
        return FALSE;
    place_mm[0] = self->place.x_mm;
    place_mm[1] = self->place.y_mm;
    return TRUE;
}

/* A point that was moved takes the card with it; one that went leaves it where it is. */
static void follow_point(AppWhy *self)
{
    const double before[2] = {self->place.x_mm, self->place.y_mm};
    if (self->place.point < 0)
        return;
    if (luxel_scene_point(self->place.shot->moment->scene, (gsize)self->place.point, &self->place.x_mm,
                          &self->place.y_mm) != LUXEL_OK)
        self->place.point = -1;
    else if (self->place.x_mm != before[0] || self->place.y_mm != before[1])
        tell_kept(self);
}

gboolean app_why_is_shown(const AppWhy *self)
{
    return self->is_shown;
}

void app_why_follow(AppWhy *self, AppShot *shot)
{
    if (!self->place.shot || self->place.shot == shot || self->timer)
        return;
    app_shot_ref(shot);
    app_shot_unref(self->place.shot);
    self->place.shot = shot;
    follow_point(self);
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
    gtk_widget_set_visible(self->sun, FALSE);
    gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(self->pin), FALSE);
    show_reading(self, NULL);
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

void app_why_show(AppWhy *self, gboolean shown)
{
    self->is_shown = shown;
    gtk_widget_set_visible(GTK_WIDGET(self), shown);
    ask(self);
    tell_kept(self);
}

/* ---- the class ---- */

static void app_why_dispose(GObject *object)
{
    AppWhy *self = APP_WHY(object);
    g_clear_handle_id(&self->timer, g_source_remove);
    g_clear_pointer(&self->place.shot, app_shot_unref);
    self->formula = NULL;
    g_clear_pointer(&self->pointer, app_pointer_free);
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
    signals[KEPT] = g_signal_new("kept", APP_TYPE_WHY, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

/* A label that is read and copied. */
static GtkWidget *new_words(const char *class)
{
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_yalign(GTK_LABEL(label), 0);
    gtk_label_set_selectable(GTK_LABEL(label), TRUE);
    gtk_widget_set_focusable(label, FALSE);
    gtk_widget_add_css_class(label, class);
    return label;
}

/* The place, what keeps it, and what closes the card. */
static GtkWidget *new_head(AppWhy *self)
{
    GtkWidget *head = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 2);
    GtkWidget *close = gtk_button_new_from_icon_name("window-close-symbolic");
    self->where = gtk_label_new(NULL);
    self->pin = gtk_toggle_button_new();
    gtk_label_set_xalign(GTK_LABEL(self->where), 0);
    gtk_widget_set_hexpand(self->where, TRUE);
    gtk_widget_add_css_class(self->where, "numeric");
    gtk_button_set_icon_name(GTK_BUTTON(self->pin), "view-pin-symbolic");
    gtk_widget_set_tooltip_text(self->pin, _("Stay at this place, wherever the pointer goes"));
    app_name_control(self->pin, _("Stay at this place"));
    g_signal_connect_swapped(self->pin, "toggled", G_CALLBACK(tell_kept), self);
    gtk_widget_set_tooltip_text(close, _("Close"));
    app_name_control(close, _("Close"));
    gtk_actionable_set_action_name(GTK_ACTIONABLE(close), "win.why");
    gtk_widget_add_css_class(close, "flat");
    gtk_widget_add_css_class(self->pin, "flat");
    gtk_box_append(GTK_BOX(head), self->where);
    gtk_box_append(GTK_BOX(head), self->pin);
    gtk_box_append(GTK_BOX(head), close);
    return head;
}

static void app_why_init(AppWhy *self)
{
    GtkWidget *scrolled = gtk_scrolled_window_new(), *fold = gtk_expander_new(_("Formula of the chosen source"));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 6);
    gtk_widget_add_css_class(GTK_WIDGET(self), "card");
    gtk_widget_set_halign(GTK_WIDGET(self), GTK_ALIGN_START);
    gtk_widget_set_valign(GTK_WIDGET(self), GTK_ALIGN_END);
    gtk_widget_set_size_request(GTK_WIDGET(self), WIDTH, -1);
    gtk_widget_set_visible(GTK_WIDGET(self), FALSE);
    self->cancellable = g_cancellable_new();
    self->pointer = app_pointer_new(value_came, self);
    self->result = new_words("numeric");
    self->shares = new_words("numeric");
    self->sun = new_words("note");
    self->formula = new_words("note");
    self->whole = gtk_button_new_with_label(_("The whole…"));
    gtk_label_set_max_width_chars(GTK_LABEL(self->formula), 1); /* the card is as wide as it is */
    gtk_label_set_max_width_chars(GTK_LABEL(self->sun), 1);
    gtk_widget_set_visible(self->sun, FALSE);
    gtk_widget_set_hexpand(self->formula, TRUE);
    gtk_widget_set_tooltip_text(self->whole, _("The whole calculation, as luxel explain prints it"));
    gtk_widget_add_css_class(self->whole, "flat");
    gtk_widget_set_halign(self->whole, GTK_ALIGN_END);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_min_content_height(GTK_SCROLLED_WINDOW(scrolled), HEIGHT);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), self->formula);
    gtk_box_append(GTK_BOX(self), new_head(self));
    gtk_box_append(GTK_BOX(self), self->result);
    gtk_box_append(GTK_BOX(self), self->shares);
    gtk_box_append(GTK_BOX(self), self->sun);
    gtk_expander_set_child(GTK_EXPANDER(fold), scrolled);
    app_name_control(fold, _("Formula of the chosen source"));
    gtk_box_append(GTK_BOX(self), fold);
    gtk_box_append(GTK_BOX(self), self->whole);
    g_signal_connect_swapped(self->whole, "clicked", G_CALLBACK(show_whole), self);
    show_formula(self);
    judge(self);
}

GtkWidget *app_why_new(void)
{
    return g_object_new(APP_TYPE_WHY, NULL);
}

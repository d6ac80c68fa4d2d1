/* SPDX-License-Identifier: MIT */
/* The parts of a row stay where they are, whatever they show: only the name gives way. */
#include "source_row.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/dim.h"
#include "../base/lamp.h"
#include "../base/number.h"
#include "../base/row.h"
#include "../base/share.h"

enum { BADGE_SIDE = 2 * APP_BADGE_RADIUS + 5 };

struct _AppSourceRow {
    GtkBox parent;
    gsize light;
    GtkWidget *enabled, *badge, *name, *gives, *share, *solo;
    gboolean is_on, is_updating;
};

enum { ENABLED, SOLO, HOVERED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppSourceRow, app_source_row, GTK_TYPE_BOX)

gsize app_source_row_light(const AppSourceRow *self)
{
    return self->light;
}

/* ---- what is pressed and pointed at ---- */

static void enabled_toggled(GtkCheckButton *button, AppSourceRow *self)
{
    if (!self->is_updating)
        g_signal_emit(self, signals[ENABLED], 0, gtk_check_button_get_active(button));
}

static void solo_toggled(GtkToggleButton *button, AppSourceRow *self)
{
    if (!self->is_updating)
        g_signal_emit(self, signals[SOLO], 0, gtk_toggle_button_get_active(button));
}

static void pointer_came(GtkEventControllerMotion *motion, double x, double y, AppSourceRow *self)
{
    (void)motion;
    (void)x;
    (void)y;
    g_signal_emit(self, signals[HOVERED], 0, TRUE);
}

static void pointer_went(GtkEventControllerMotion *motion, AppSourceRow *self)
{
    (void)motion;
    g_signal_emit(self, signals[HOVERED], 0, FALSE);
}

/* The whole row of the list is watched, which is there when this is put into it. */
static void app_source_row_root(GtkWidget *widget)
{
    GtkEventController *motion = gtk_event_controller_motion_new();
    GTK_WIDGET_CLASS(app_source_row_parent_class)->root(widget);
    g_signal_connect_object(motion, "enter", G_CALLBACK(pointer_came), widget, 0);
    g_signal_connect_object(motion, "leave", G_CALLBACK(pointer_went), widget, 0);
    gtk_widget_add_controller(gtk_widget_get_parent(widget), motion);
}

/* ---- what is shown ---- */

static void draw_badge(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    const AppSourceRow *self = data;
    const AppBadge badge = {.light = self->light, .is_on = self->is_on};
    (void)area;
    cairo_translate(cairo, width / 2.0, height / 2.0);
    app_lamp_draw_badge(cairo, &badge);
}

void app_source_row_show(AppSourceRow *self, const char *title, gboolean enabled, gboolean solo)
{
    self->is_updating = TRUE;
    gtk_label_set_text(GTK_LABEL(self->name), title);
    gtk_check_button_set_active(GTK_CHECK_BUTTON(self->enabled), enabled);
    gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(self->solo), solo);
    self->is_updating = FALSE;
    if (enabled != self->is_on) {
        self->is_on = enabled;
        gtk_widget_queue_draw(self->badge);
    }
}

void app_source_row_set_gives(AppSourceRow *self, const AppSource *source, const char *flux_unit, const char *unit)
{
    char number[APP_NUMBER_SIZE];
    GString *text = g_string_new(NULL);
    if (source && isfinite(source->flux))
        g_string_append_printf(text, "Φ %s %s", app_number_show(source->flux, 4, number), flux_unit);
    if (source && isfinite(source->irradiance))
        g_string_append_printf(text, "%sE %s", text->len ? "   " : "", app_number_show(source->irradiance, 4, number));
    /* the word for no unit is longer than the number */
    if (source && isfinite(source->irradiance) && strcmp(unit, "relative") != 0)
        g_string_append_printf(text, " %s", gettext(unit));
    if (g_strcmp0(text->str, gtk_label_get_text(GTK_LABEL(self->gives))) != 0)
        gtk_label_set_text(GTK_LABEL(self->gives), text->str);
    g_string_free(text, TRUE);
}

void app_source_row_set_share(AppSourceRow *self, double share, double whole)
{
    app_share_set(APP_SHARE(self->share), share, whole);
}

void app_source_row_set_stale(AppSourceRow *self, gboolean stale)
{
    app_set_stale(self->gives, stale);
}

/* ---- the class ---- */

static void app_source_row_class_init(AppSourceRowClass *class)
{
    GTK_WIDGET_CLASS(class)->root = app_source_row_root;
    signals[ENABLED] = g_signal_new("enabled", APP_TYPE_SOURCE_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                                    1, G_TYPE_BOOLEAN);
    signals[SOLO] = g_signal_new("solo", APP_TYPE_SOURCE_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1,
                                 G_TYPE_BOOLEAN);
    signals[HOVERED] = g_signal_new("hovered", APP_TYPE_SOURCE_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                                    1, G_TYPE_BOOLEAN);
}

static void name_button(GtkWidget *control, const char *format, gsize light)
{
    char *text = g_strdup_printf(format, light + 1);
    app_name_control(control, text);
    gtk_widget_set_tooltip_text(control, text);
    g_free(text);
}

static void app_source_row_init(AppSourceRow *self)
{
    self->is_on = TRUE;
    self->enabled = gtk_check_button_new();
    self->badge = g_object_new(GTK_TYPE_DRAWING_AREA, "accessible-role", GTK_ACCESSIBLE_ROLE_PRESENTATION, NULL);
    self->name = gtk_label_new(NULL);
    self->gives = gtk_label_new(NULL);
    self->solo = gtk_toggle_button_new_with_label(_("Solo"));
    gtk_box_set_spacing(GTK_BOX(self), 4);
    gtk_drawing_area_set_content_width(GTK_DRAWING_AREA(self->badge), BADGE_SIDE);
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(self->badge), BADGE_SIDE);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(self->badge), draw_badge, self, NULL);
    gtk_widget_set_valign(self->badge, GTK_ALIGN_CENTER);
    for (int i = 0; i < 2; i++) {
        GtkWidget *label = i ? self->gives : self->name;
        gtk_label_set_xalign(GTK_LABEL(label), 0);
        gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    }
    gtk_widget_add_css_class(self->gives, "note");
    gtk_widget_add_css_class(self->gives, "numeric");
    gtk_widget_set_valign(self->solo, GTK_ALIGN_CENTER);
    gtk_widget_add_css_class(self->solo, "small");
    gtk_widget_set_tooltip_text(
        self->gives, _("Φ: the flux of the source in all\nE: the irradiance or illuminance at the place where Why? "
                       "is kept,\nor else where the centre of the first surface is seen; 0 also in shadow"));
}

GtkWidget *app_source_row_new(gsize light)
{
    AppSourceRow *self = g_object_new(APP_TYPE_SOURCE_ROW, NULL);
    GtkWidget *texts = gtk_box_new(GTK_ORIENTATION_VERTICAL, 1), *title = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    self->light = light;
    self->share = app_share_new(light);
    name_button(self->enabled, _("Source %zu on"), light);
    name_button(self->solo, _("Only source %zu"), light);
    gtk_widget_set_tooltip_text(self->share, _("What the source gives under the pointer, and its share of the whole"));
    gtk_widget_set_hexpand(texts, TRUE);
    gtk_widget_set_hexpand(self->name, TRUE);
    gtk_box_append(GTK_BOX(title), self->name);
    gtk_box_append(GTK_BOX(title), self->solo);
    gtk_box_append(GTK_BOX(texts), title);
    gtk_box_append(GTK_BOX(texts), self->gives);
    gtk_box_append(GTK_BOX(texts), self->share);
    gtk_box_append(GTK_BOX(self), self->enabled);
    gtk_box_append(GTK_BOX(self), self->badge);
    gtk_box_append(GTK_BOX(self), texts);
    g_signal_connect(self->enabled, "toggled", G_CALLBACK(enabled_toggled), self);
    g_signal_connect(self->solo, "toggled", G_CALLBACK(solo_toggled), self);
    return GTK_WIDGET(self);
}

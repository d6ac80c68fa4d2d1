/* SPDX-License-Identifier: MIT */
/* The numbers are rows of their own; the vector only gives them their places. */
#include "vector.h"

#include "touch.h"

struct _AppVector {
    GtkBox parent;
    GtkWidget *name, *unit, *numbers;
    AppRow *first;
};

G_DEFINE_FINAL_TYPE(AppVector, app_vector, GTK_TYPE_BOX)

/* The label stands for the whole, as the first of its numbers does. */
static void label_clicked(GtkGestureClick *gesture, int count, double x, double y, AppVector *self)
{
    const guint button = gtk_gesture_single_get_current_button(GTK_GESTURE_SINGLE(gesture));
    (void)x;
    (void)y;
    if (self->first && button == GDK_BUTTON_SECONDARY)
        g_signal_emit_by_name(self->first, "menu", self->name);
    else if (self->first && button == GDK_BUTTON_PRIMARY && count == 2)
        g_signal_emit_by_name(self->first, "reset");
}

static void label_held(GtkGestureLongPress *gesture, double x, double y, AppVector *self)
{
    (void)gesture;
    (void)x;
    (void)y;
    if (self->first)
        g_signal_emit_by_name(self->first, "menu", self->name);
}

void app_vector_add(AppVector *self, AppRow *part)
{
    gtk_box_append(GTK_BOX(self->numbers), GTK_WIDGET(part));
    gtk_box_append(GTK_BOX(self), app_row_words(part));
    if (!self->first)
        self->first = part;
}

const char *app_vector_label(const AppVector *self)
{
    return gtk_label_get_text(GTK_LABEL(self->name));
}

void app_vector_set_unit(AppVector *self, const char *unit)
{
    gtk_label_set_text(GTK_LABEL(self->unit), unit ? unit : "");
    gtk_widget_set_visible(self->unit, unit && *unit);
}

static void app_vector_class_init(AppVectorClass *class)
{
    (void)class;
}

static void app_vector_init(AppVector *self)
{
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_widget_add_css_class(GTK_WIDGET(self), "row");
    self->name = gtk_label_new(NULL);
    self->unit = gtk_label_new(NULL);
    self->numbers = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    gtk_label_set_xalign(GTK_LABEL(self->name), 0);
    gtk_label_set_ellipsize(GTK_LABEL(self->name), PANGO_ELLIPSIZE_END);
    gtk_widget_set_hexpand(self->name, TRUE);
    gtk_widget_add_css_class(self->unit, "dim-label");
    gtk_box_set_homogeneous(GTK_BOX(self->numbers), TRUE);
}

GtkWidget *app_vector_new(const char *label, const char *unit, const char *meaning)
{
    AppVector *self = g_object_new(APP_TYPE_VECTOR, NULL);
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    GtkGesture *click = gtk_gesture_click_new();
    gtk_label_set_text(GTK_LABEL(self->name), label);
    app_vector_set_unit(self, unit);
    gtk_widget_set_tooltip_text(GTK_WIDGET(self), meaning);
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), 0);
    g_signal_connect(click, "pressed", G_CALLBACK(label_clicked), self);
    gtk_widget_add_controller(self->name, GTK_EVENT_CONTROLLER(click));
    app_touch_on_rest(self->name, G_CALLBACK(label_held), self);
    gtk_box_append(GTK_BOX(line), self->name);
    gtk_box_append(GTK_BOX(line), self->unit);
    gtk_box_append(GTK_BOX(self), line);
    gtk_box_append(GTK_BOX(self), self->numbers);
    return GTK_WIDGET(self);
}

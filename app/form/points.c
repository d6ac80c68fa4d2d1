/* SPDX-License-Identifier: MIT */
/* A field for each point, "x, y" in it. */
#include "points.h"

#include <string.h>

#include "../../front/words.h"
#include "../base/number.h"
#include "../picture/measures.h"
#include "rules.h"

struct _AppPoints {
    GtkBox parent;
    AppDocument *document;
    GtkWidget *list, *more;
    GPtrArray *fields; /* GtkEntry */
};

G_DEFINE_FINAL_TYPE(AppPoints, app_points, GTK_TYPE_BOX)

static char *key_of(gpointer widget)
{
    return g_strdup_printf("points[%u]", GPOINTER_TO_UINT(g_object_get_data(G_OBJECT(widget), "index")));
}

static void set_wrong(GtkWidget *field, gboolean wrong)
{
    if (wrong)
        gtk_widget_add_css_class(field, "error");
    else
        gtk_widget_remove_css_class(field, "error");
    gtk_widget_set_tooltip_text(
        field,
        wrong ? _("expected: x, y in millimetres with a blank behind the comma, such as 60, -20 or 60.5, -20") : NULL);
    gtk_accessible_update_state(GTK_ACCESSIBLE(field), GTK_ACCESSIBLE_STATE_INVALID,
                                wrong ? GTK_ACCESSIBLE_INVALID_TRUE : GTK_ACCESSIBLE_INVALID_FALSE, -1);
}

static void entered(GtkWidget *field, AppPoints *self)
{
    double place[2];
    const char *typed = gtk_editable_get_text(GTK_EDITABLE(field)),
               *shown = g_object_get_data(G_OBJECT(field), "shown");
    if (g_strcmp0(typed, shown) == 0) {
        set_wrong(field, FALSE);
        return;
    }
    gboolean good = app_pair_read(typed, place);
    set_wrong(field, !good);
    if (!good)
        return;
    char *key = key_of(field);
    char *yaml = app_list_write(place, 2);
    app_document_set(self->document, key, yaml, NULL);
    g_free(yaml);
    g_free(key);
}

/* Shows the place that holds in stead of what was typed; FALSE: there was nothing else. */
static gboolean restore(GtkWidget *field)
{
    const char *shown = g_object_get_data(G_OBJECT(field), "shown");
    if (g_strcmp0(gtk_editable_get_text(GTK_EDITABLE(field)), shown) == 0)
        return FALSE;
    gtk_editable_set_text(GTK_EDITABLE(field), shown ? shown : "");
    set_wrong(field, FALSE);
    return TRUE;
}

static void left(GtkEventControllerFocus *focus, AppPoints *self)
{
    GtkWidget *field = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(focus));
    entered(field, self);
    restore(field);
}

static gboolean key_pressed(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                            GtkWidget *field)
{
    (void)controller;
    (void)code;
    (void)state;
    return key == GDK_KEY_Escape && restore(field);
}

gboolean app_points_restore(AppPoints *self, GtkWidget *focus)
{
    for (guint i = 0; i < self->fields->len; i++) {
        GtkWidget *field = g_ptr_array_index(self->fields, i);
        if (focus && gtk_widget_is_ancestor(focus, field))
            return restore(field);
    }
    return FALSE;
}

static void deleted(GtkWidget *button, AppPoints *self)
{
    char *key = key_of(button);
    const AppEdit edit = {.kind = APP_EDIT_REMOVE, .key = key};
    app_document_edit(self->document, &edit, 1, NULL, NULL);
    g_free(key);
}

static void add_field(AppPoints *self)
{
    const guint index = self->fields->len;
    char *name = g_strdup_printf("P%u", index + 1), *remove = g_strdup_printf(_("Delete point %u"), index + 1);
    char *meaning = g_strdup_printf(_("Point %u: x, y in mm"), index + 1);
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *label = gtk_label_new(name);
    GtkWidget *field = gtk_entry_new(), *button = gtk_button_new_from_icon_name("list-remove-symbolic");
    GtkEventController *focus = gtk_event_controller_focus_new(), *keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    gtk_editable_set_enable_undo(GTK_EDITABLE(field), FALSE);
    gtk_widget_set_hexpand(field, TRUE);
    gtk_label_set_width_chars(GTK_LABEL(label), 4);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_button_set_has_frame(GTK_BUTTON(button), FALSE);
    gtk_widget_set_tooltip_text(button, remove);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, remove, -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(field), GTK_ACCESSIBLE_PROPERTY_LABEL, meaning, -1);
    g_object_set_data(G_OBJECT(field), "index", GUINT_TO_POINTER(index));
    g_object_set_data(G_OBJECT(button), "index", GUINT_TO_POINTER(index));
    g_signal_connect(field, "activate", G_CALLBACK(entered), self);
    g_signal_connect(focus, "leave", G_CALLBACK(left), self);
    g_signal_connect(button, "clicked", G_CALLBACK(deleted), self);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key_pressed), field);
    gtk_widget_add_controller(field, focus);
    gtk_widget_add_controller(field, keys);
    gtk_box_append(GTK_BOX(line), label);
    gtk_box_append(GTK_BOX(line), field);
    gtk_box_append(GTK_BOX(line), button);
    gtk_box_append(GTK_BOX(self->list), line);
    g_ptr_array_add(self->fields, field);
    g_free(name);
    g_free(remove);
    g_free(meaning);
}

static void remove_last(AppPoints *self)
{
    GtkWidget *field = g_ptr_array_index(self->fields, self->fields->len - 1);
    gtk_box_remove(GTK_BOX(self->list), gtk_widget_get_parent(field));
    g_ptr_array_set_size(self->fields, (int)self->fields->len - 1);
}

void app_points_refresh(AppPoints *self)
{
    const gsize count = app_document_size(self->document, "points"), shown = MIN(count, APP_MOST_POINTS);
    while (self->fields->len < shown)
        add_field(self);
    while (self->fields->len > shown)
        remove_last(self);
    for (guint i = 0; i < self->fields->len; i++) {
        GtkWidget *field = g_ptr_array_index(self->fields, i);
        double place[2] = {0, 0};
        char x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE], *key = key_of(field);
        char *yaml = app_document_get(self->document, key, NULL);
        app_list_read(yaml, place, 2);
        char *text = g_strdup_printf("%s%s%s", app_number_show_all(place[0], x), app_number_separator(),
                                     app_number_show_all(place[1], y));
        if (g_strcmp0(text, g_object_get_data(G_OBJECT(field), "shown")) != 0) {
            gtk_editable_set_text(GTK_EDITABLE(field), text);
            set_wrong(field, FALSE);
        }
        g_object_set_data_full(G_OBJECT(field), "shown", text, g_free);
        g_free(yaml);
        g_free(key);
    }
    char *more = g_strdup_printf(ngettext("and %zu more", "and %zu more", count - shown), count - shown);
    gtk_label_set_text(GTK_LABEL(self->more), more);
    gtk_widget_set_visible(self->more, count > shown);
    g_free(more);
}

static void add_all(AppPoints *self, const double *places, gsize count)
{
    AppEdits *edits = app_edits_new();
    const gsize size = app_document_size(self->document, "points");
    for (gsize i = 0; i < count; i++) {
        char *yaml = app_list_write(&places[2 * i], 2);
        app_edits_add(edits, APP_EDIT_INSERT, "points", yaml, size + i, 0);
        g_free(yaml);
    }
    app_edits_make(edits, self->document, NULL);
    app_edits_free(edits);
}

void app_points_add(AppPoints *self, double x_mm, double y_mm)
{
    const double place[2] = {x_mm, y_mm};
    add_all(self, place, 1);
}

char *app_points_paste(AppPoints *self, const char *text)
{
    gsize count;
    char *fault;
    double *places = app_numbers_read(text, 2, &count, &fault);
    if (!places)
        return fault;
    add_all(self, places, count);
    g_free(places);
    return NULL;
}

static void app_points_dispose(GObject *object)
{
    AppPoints *self = APP_POINTS(object);
    g_clear_object(&self->document);
    G_OBJECT_CLASS(app_points_parent_class)->dispose(object);
}

static void app_points_finalize(GObject *object)
{
    g_ptr_array_unref(APP_POINTS(object)->fields);
    G_OBJECT_CLASS(app_points_parent_class)->finalize(object);
}

static void app_points_class_init(AppPointsClass *class)
{
    G_OBJECT_CLASS(class)->dispose = app_points_dispose;
    G_OBJECT_CLASS(class)->finalize = app_points_finalize;
}

static void app_points_init(AppPoints *self)
{
    self->fields = g_ptr_array_new();
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 4);
}

static void add_button(GtkWidget *bar, const char *label, const char *meaning, const char *action)
{
    GtkWidget *button = gtk_button_new_with_label(label);
    gtk_widget_set_tooltip_text(button, meaning);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), action);
    gtk_box_append(GTK_BOX(bar), button);
}

GtkWidget *app_points_new(AppDocument *document)
{
    AppPoints *self = g_object_new(APP_TYPE_POINTS, NULL);
    GtkWidget *bar = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    self->document = g_object_ref(document);
    self->list = gtk_box_new(GTK_ORIENTATION_VERTICAL, 2);
    self->more = gtk_label_new(NULL);
    add_button(bar, _("Add a point"), _("A point in the middle of the screen, to be dragged"), "win.point-add");
    add_button(bar, _("Paste"), _("Paste points: x, y; x, y"), "win.point-paste");
    gtk_box_append(GTK_BOX(self), self->list);
    gtk_box_append(GTK_BOX(self), self->more);
    gtk_box_append(GTK_BOX(self), bar);
    app_points_refresh(self);
    return GTK_WIDGET(self);
}

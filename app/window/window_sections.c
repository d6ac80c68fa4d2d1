/* SPDX-License-Identifier: MIT */
/*
 * The sections of the form at the left: which of them are open is kept from start to start.  A search finds rows by
 * label, key and meaning, in whichever section they are; the one that is chosen is shown and gets the keyboard.
 */
#include <string.h>

#include "../../front/words.h"
#include "../base/reveal.h"
#include "../base/row.h"
#include "../base/vector.h"
#include "window_private.h"

enum { MOST_FOUND = 12 };

void app_window_add_section(AppWindow *self, const char *name, const char *title, GtkWidget *first, GtkWidget *second,
                            GtkWidget *third)
{
    GtkWidget *expander = gtk_expander_new(title), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    GtkWidget *const children[] = {first, second, third};
    for (gsize i = 0; i < G_N_ELEMENTS(children); i++)
        if (children[i])
            gtk_box_append(GTK_BOX(box), children[i]);
    gtk_expander_set_child(GTK_EXPANDER(expander), box);
    app_name_control(expander, title);
    gtk_widget_set_name(expander, name);
    gtk_box_append(GTK_BOX(self->left_box), expander);
}

/* ---- which are open ---- */

static void keep_sections(AppWindow *self)
{
    GStrvBuilder *names = g_strv_builder_new();
    for (GtkWidget *child = gtk_widget_get_first_child(self->left_box); child;
         child = gtk_widget_get_next_sibling(child))
        if (GTK_IS_EXPANDER(child) && gtk_expander_get_expanded(GTK_EXPANDER(child)))
            g_strv_builder_add(names, gtk_widget_get_name(child));
    char **list = g_strv_builder_end(names);
    g_settings_set_strv(self->settings, "open-sections", (const char *const *)list);
    g_strfreev(list);
    g_strv_builder_unref(names);
}

/* Those of the last time are open; without settings those that most people need. */
void app_window_open_sections(AppWindow *self)
{
    static const char *const usual[] = {"sources", "surfaces", "material", NULL};
    char **kept = self->settings ? g_settings_get_strv(self->settings, "open-sections") : NULL;
    for (GtkWidget *child = gtk_widget_get_first_child(self->left_box); child;
         child = gtk_widget_get_next_sibling(child)) {
        if (!GTK_IS_EXPANDER(child))
            continue;
        const char *const *open = kept ? (const char *const *)kept : usual;
        gtk_expander_set_expanded(GTK_EXPANDER(child), g_strv_contains(open, gtk_widget_get_name(child)));
        if (self->settings)
            g_signal_connect_swapped(child, "notify::expanded", G_CALLBACK(keep_sections), self);
        app_reveal_when_opened(GTK_EXPANDER(child), GTK_SCROLLED_WINDOW(self->left_scroll)); /* from now on */
    }
    g_strfreev(kept);
}

/* ---- the search ---- */

/* The label of a row or a vector; NULL: the widget is neither. */
static const char *label_of(GtkWidget *widget)
{
    return APP_IS_ROW(widget)      ? app_row_label(APP_ROW(widget))
           : APP_IS_VECTOR(widget) ? app_vector_label(APP_VECTOR(widget))
                                   : NULL;
}

/* The key that a row has, "lights[].position"; "" where it has none. */
static const char *key_of(GtkWidget *widget)
{
    const char *name = gtk_widget_get_name(widget);
    return strcmp(name, G_OBJECT_TYPE_NAME(widget)) == 0 ? "" : name;
}

static gboolean has(const char *text, const char *wanted)
{
    char *folded = g_utf8_casefold(text ? text : "", -1);
    const gboolean found = strstr(folded, wanted) != NULL;
    g_free(folded);
    return found;
}

/* A row and its section, which holds the row only where it is open. */
typedef struct Found {
    GtkWidget *row;
    GtkExpander *section;
} Found;

/* Gathers the rows below a widget that are shown and have the text in their label or key, or in their meaning. */
static void gather(GtkWidget *widget, GtkExpander *section, const char *wanted, GArray *close, GArray *far)
{
    const Found found = {widget, section};
    const char *label = label_of(widget);
    if (!gtk_widget_get_visible(widget))
        return;
    if (APP_IS_FORM(widget))
        app_form_fill(APP_FORM(widget));
    if (label && (has(label, wanted) || has(key_of(widget), wanted)))
        g_array_append_val(close, found);
    else if (label && has(gtk_widget_get_tooltip_text(widget), wanted))
        g_array_append_val(far, found);
    for (GtkWidget *child = label ? NULL : gtk_widget_get_first_child(widget); child;
         child = gtk_widget_get_next_sibling(child))
        gather(child, section, wanted, close, far);
}

/* "Intensity", and small below it where it is: "Sources, lights[].intensity". */
static GtkWidget *new_line(const Found *found)
{
    const char *key = key_of(found->row);
    char *text = g_markup_printf_escaped("%s\n<small>%s%s%s</small>", label_of(found->row),
                                         gtk_expander_get_label(found->section), *key ? ", " : "", key);
    GtkWidget *label = gtk_label_new(NULL), *line = gtk_list_box_row_new();
    gtk_label_set_markup(GTK_LABEL(label), text);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_list_box_row_set_child(GTK_LIST_BOX_ROW(line), label);
    g_object_set_data_full(G_OBJECT(line), "luxel-row", g_object_ref(found->row), g_object_unref);
    g_object_set_data(G_OBJECT(line), "luxel-section", found->section);
    g_free(text);
    return line;
}

static void search(GtkSearchEntry *entry, AppWindow *self)
{
    char *wanted = g_utf8_casefold(gtk_editable_get_text(GTK_EDITABLE(entry)), -1);
    GArray *close = g_array_new(FALSE, FALSE, sizeof(Found)), *far = g_array_new(FALSE, FALSE, sizeof(Found));
    GtkWidget *child;
    while ((child = gtk_widget_get_first_child(self->found_list)))
        gtk_list_box_remove(GTK_LIST_BOX(self->found_list), child);
    for (child = gtk_widget_get_first_child(self->left_box); child && *g_strstrip(wanted);
         child = gtk_widget_get_next_sibling(child))
        if (GTK_IS_EXPANDER(child))
            gather(gtk_expander_get_child(GTK_EXPANDER(child)), GTK_EXPANDER(child), wanted, close, far);
    g_array_append_vals(close, far->data, far->len);
    for (guint i = 0; i < close->len && i < MOST_FOUND; i++)
        gtk_list_box_append(GTK_LIST_BOX(self->found_list), new_line(&g_array_index(close, Found, i)));
    gtk_list_box_select_row(GTK_LIST_BOX(self->found_list),
                            gtk_list_box_get_row_at_index(GTK_LIST_BOX(self->found_list), 0));
    (*wanted ? gtk_popover_popup : gtk_popover_popdown)(GTK_POPOVER(self->found));
    g_array_unref(close);
    g_array_unref(far);
    g_free(wanted);
}

static void end_search(AppWindow *self)
{
    gtk_editable_set_text(GTK_EDITABLE(self->search), "");
    gtk_popover_popdown(GTK_POPOVER(self->found));
}

static void go_to(GtkListBox *list, GtkListBoxRow *line, AppWindow *self)
{
    (void)list;
    if (!line)
        return;
    GtkWidget *row = g_object_ref(g_object_get_data(G_OBJECT(line), "luxel-row"));
    gtk_expander_set_expanded(g_object_get_data(G_OBJECT(line), "luxel-section"), TRUE);
    end_search(self);
    if (gtk_widget_get_root(row)) { /* the form may have become another meanwhile */
        gtk_widget_child_focus(row, GTK_DIR_TAB_FORWARD);
        app_reveal_part(self->left_box, GTK_SCROLLED_WINDOW(self->left_scroll), row);
    }
    g_object_unref(row);
}

static void go_to_selected(AppWindow *self)
{
    go_to(NULL, gtk_list_box_get_selected_row(GTK_LIST_BOX(self->found_list)), self);
}

static gboolean search_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                           AppWindow *self)
{
    GtkListBox *list = GTK_LIST_BOX(self->found_list);
    GtkListBoxRow *line = gtk_list_box_get_selected_row(list);
    (void)controller;
    (void)code;
    (void)state;
    if ((key != GDK_KEY_Down && key != GDK_KEY_Up) || !line)
        return FALSE;
    line = gtk_list_box_get_row_at_index(list, gtk_list_box_row_get_index(line) + (key == GDK_KEY_Down ? 1 : -1));
    if (line)
        gtk_list_box_select_row(list, line);
    return TRUE;
}

static void begin_search(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    gtk_widget_grab_focus(((AppWindow *)data)->search);
}

void app_window_add_search(AppWindow *self)
{
    static const GActionEntry actions[] = {{.name = "search", .activate = begin_search}};
    GtkEventController *keys = gtk_event_controller_key_new();
    self->search = gtk_search_entry_new();
    self->found = gtk_popover_new();
    self->found_list = gtk_list_box_new();
    gtk_list_box_set_placeholder(GTK_LIST_BOX(self->found_list), gtk_label_new(_("nothing of this scene")));
    g_object_set(self->search, "placeholder-text", _("Search the form"), NULL);
    gtk_widget_set_tooltip_text(self->search, _("Finds rows by label, key or meaning, in all sections (Ctrl+K)"));
    app_name_control(self->search, _("Search the form"));
    gtk_popover_set_autohide(GTK_POPOVER(self->found), FALSE); /* the keyboard stays in the field */
    gtk_popover_set_child(GTK_POPOVER(self->found), self->found_list);
    gtk_popover_set_has_arrow(GTK_POPOVER(self->found), FALSE);
    gtk_widget_set_parent(self->found, self->search);
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(search_key), self);
    gtk_widget_add_controller(self->search, keys);
    g_signal_connect(self->search, "search-changed", G_CALLBACK(search), self);
    g_signal_connect_swapped(self->search, "activate", G_CALLBACK(go_to_selected), self);
    g_signal_connect_swapped(self->search, "stop-search", G_CALLBACK(end_search), self);
    g_signal_connect(self->found_list, "row-activated", G_CALLBACK(go_to), self);
    gtk_box_append(GTK_BOX(self->left_box), self->search);
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
}

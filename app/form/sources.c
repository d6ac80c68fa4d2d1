/* SPDX-License-Identifier: MIT */
/* The list of sources. */
#include "sources.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/choices.h"
#include "../base/number.h"
#include "../base/reveal.h"
#include "../base/row.h"
#include "../base/toolbar.h"
#include "diagram.h"
#include "new_source.h"
#include "rules.h"
#include "several.h"
#include "source_row.h"

static const char *const prefixes[] = {"lights[].", NULL};

enum { MOST_ROWS = 5 /* that are seen without scrolling */ };

struct _AppSources {
    GtkBox parent;
    AppDocument *document;
    const luxel_parameters *parameters;
    GtkWidget *list, *scrolled, *more, *form, *diagram, *aim;
    GtkWidget *several;
    GPtrArray *items; /* AppSourceRow's */
    gsize chosen;
    GArray *together;       /* gsize, rising: all that are chosen */
    guint64 wanted, serial; /* of the version of the scene that is shown, and of what the rows say that sources give */
    gsize count;            /* of the sources, as it was last */
    gssize solo;
    gboolean is_updating;
};

enum { CHOSEN, SOLO, HOVERED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppSources, app_sources, GTK_TYPE_BOX)

static char *get(AppSources *self, gsize index, const char *name)
{
    char *key = g_strdup_printf("lights[%zu].%s", index, name), *value = app_document_get(self->document, key, NULL);
    g_free(key);
    return value;
}

/* ---- which are chosen ---- */

const GArray *app_sources_chosen(const AppSources *self)
{
    return self->together;
}

gsize app_sources_shown(const AppSources *self)
{
    return self->chosen;
}

static gboolean is_chosen(const AppSources *self, gsize index)
{
    for (guint i = 0; i < self->together->len; i++)
        if (g_array_index(self->together, gsize, i) == index)
            return TRUE;
    return FALSE;
}

static void choose_alone(AppSources *self, gsize index)
{
    self->chosen = index;
    g_array_set_size(self->together, 0);
    g_array_append_val(self->together, index);
}

/* ---- rows ---- */

static void add_edit(AppEdits *edits, AppEditKind kind, gsize index, const char *name, const char *value)
{
    char *key = g_strdup_printf("lights[%zu].%s", index, name);
    app_edits_add(edits, kind, key, value, 0, 0);
    g_free(key);
}

/* The box of a chosen one is that of all of them. */
static void enabled_pressed(AppSourceRow *row, gboolean active, AppSources *self)
{
    const gsize light = app_source_row_light(row);
    AppEdits *edits = app_edits_new();
    for (guint i = 0; i < self->together->len && is_chosen(self, light); i++)
        add_edit(edits, APP_EDIT_SET, g_array_index(self->together, gsize, i), "enabled", active ? "true" : "false");
    if (edits->list->len == 0)
        add_edit(edits, APP_EDIT_SET, light, "enabled", active ? "true" : "false");
    app_edits_make(edits, self->document, NULL);
    app_edits_free(edits);
}

static void solo_pressed(AppSourceRow *row, gboolean active, AppSources *self)
{
    self->solo = active ? (gssize)app_source_row_light(row) : -1;
    g_signal_emit(self, signals[SOLO], 0, (int)self->solo);
    app_sources_refresh(self);
}

/* The mark of the row that the pointer is on is lit up on the picture. */
static void row_hovered(AppSourceRow *row, gboolean inside, AppSources *self)
{
    g_signal_emit(self, signals[HOVERED], 0, inside ? (int)app_source_row_light(row) : -1);
}

static void add_item(AppSources *self)
{
    GtkWidget *row = app_source_row_new(self->items->len);
    g_signal_connect(row, "enabled", G_CALLBACK(enabled_pressed), self);
    g_signal_connect(row, "solo", G_CALLBACK(solo_pressed), self);
    g_signal_connect(row, "hovered", G_CALLBACK(row_hovered), self);
    gtk_list_box_append(GTK_LIST_BOX(self->list), row);
    g_ptr_array_add(self->items, row);
}

static void remove_last(AppSources *self)
{
    GtkListBoxRow *row = gtk_list_box_get_row_at_index(GTK_LIST_BOX(self->list), (int)self->items->len - 1);
    gtk_list_box_remove(GTK_LIST_BOX(self->list), GTK_WIDGET(row));
    g_ptr_array_set_size(self->items, (int)self->items->len - 1);
}

static void refresh_item(AppSources *self, AppSourceRow *row)
{
    const gsize index = app_source_row_light(row);
    char *type = get(self, index, "type"), *enabled = get(self, index, "enabled");
    char *yaml = get(self, index, "name"), *name = yaml ? app_yaml_unquote(yaml) : NULL;
    const char *kind = type ? app_choice_label(type) : "";
    /* the badge has the number for those who see it */
    char *title = name && *name ? g_strdup_printf("%s (%s)", name, kind) : g_strdup(kind);
    char *whole = g_strdup_printf("%zu  %s", index + 1, title);
    app_source_row_show(row, title, g_strcmp0(enabled, "false") != 0, self->solo == (gssize)index);
    gtk_accessible_update_property(GTK_ACCESSIBLE(gtk_list_box_get_row_at_index(GTK_LIST_BOX(self->list), (int)index)),
                                   GTK_ACCESSIBLE_PROPERTY_LABEL, whole, -1);
    g_free(type);
    g_free(enabled);
    g_free(yaml);
    g_free(name);
    g_free(title);
    g_free(whole);
}

/* The mapping in which a source can be aimed, such as lights[0] or lights[0].disk; NULL where it cannot. */
static char *aimed_part(AppSources *self, gsize light)
{
    char *type = get(self, light, "type"), *found = NULL;
    const AppKeys keys = {self->document, self->parameters, type, light};
    for (gsize i = 0; i < luxel_parameters_count(keys.parameters) && type && !found; i++) {
        const luxel_parameter *parameter = luxel_parameters_get(keys.parameters, i);
        gboolean written;
        if (!g_str_has_prefix(parameter->path, prefixes[0]) || !g_str_has_suffix(parameter->path, ".aim") ||
            !app_keys_has(&keys, parameter))
            continue;
        found = app_keys_path(&keys, parameter);
        *strrchr(found, '.') = '\0';
        g_free(app_document_get(self->document, found, &written));
        if (!written)
            g_clear_pointer(&found, g_free);
    }
    g_free(type);
    return found;
}

/* The diagram of a luminaire's file, which is looked for where the scene looks for it. */
static void show_diagram(AppSources *self, const char *type)
{
    char *yaml = g_strcmp0(type, "luminaire") == 0 ? get(self, self->chosen, "file") : NULL;
    char *file = yaml ? app_yaml_unquote(yaml) : NULL, *path = NULL;
    if (file && *file) {
        const char *scene = app_document_path(self->document);
        char *folder = scene ? g_path_get_dirname(scene) : g_strdup(".");
        path = g_path_is_absolute(file) ? g_strdup(file) : g_build_filename(folder, file, NULL);
        g_free(folder);
    }
    app_diagram_show(APP_DIAGRAM(self->diagram), path);
    g_free(path);
    g_free(file);
    g_free(yaml);
}

static void show_chosen(AppSources *self)
{
    char *type = self->chosen < app_document_size(self->document, "lights") ? get(self, self->chosen, "type") : NULL;
    gboolean can_aim = FALSE;
    GArray *others = g_array_new(FALSE, FALSE, sizeof(gsize));
    for (guint i = 0; i < self->together->len; i++) {
        const gsize light = g_array_index(self->together, gsize, i);
        char *aimed = type ? aimed_part(self, light) : NULL;
        can_aim = can_aim || aimed;
        g_free(aimed);
        if (light != self->chosen)
            g_array_append_val(others, light);
    }
    char *several = app_several_tell(self->document, self->together);
    gtk_label_set_text(GTK_LABEL(self->several), several ? several : "");
    gtk_widget_set_visible(self->several, others->len > 0);
    app_form_set_element(APP_FORM(self->form), self->chosen, type);
    app_form_set_others(APP_FORM(self->form), (const gsize *)(const void *)others->data, others->len);
    g_free(several);
    g_array_unref(others);
    gtk_widget_set_sensitive(self->aim, can_aim);
    show_diagram(self, type);
    g_free(type);
}

/* The list shows what is chosen. */
static void show_rows(AppSources *self)
{
    for (guint i = 0; i < self->items->len; i++) {
        GtkListBoxRow *row = gtk_list_box_get_row_at_index(GTK_LIST_BOX(self->list), (int)i);
        if (is_chosen(self, i))
            gtk_list_box_select_row(GTK_LIST_BOX(self->list), row);
        else
            gtk_list_box_unselect_row(GTK_LIST_BOX(self->list), row);
    }
}

void app_sources_refresh(AppSources *self)
{
    const gsize count = app_document_size(self->document, "lights"), shown = MIN(count, APP_MOST_POINTS);
    self->is_updating = TRUE;
    while (self->items->len < shown)
        add_item(self);
    while (self->items->len > shown)
        remove_last(self);
    for (guint i = 0; i < self->items->len; i++)
        refresh_item(self, g_ptr_array_index(self->items, i));
    if (count != self->count || self->chosen >= MAX(count, 1)) /* the others are no longer where they were */
        choose_alone(self, MIN(self->chosen, count > 0 ? count - 1 : 0));
    self->count = count;
    show_rows(self);
    app_reveal_rows(GTK_LIST_BOX(self->list), GTK_SCROLLED_WINDOW(self->scrolled), MOST_ROWS);
    char *more = g_strdup_printf(ngettext("and %zu more", "and %zu more", count - shown), count - shown);
    gtk_label_set_text(GTK_LABEL(self->more), more);
    gtk_widget_set_visible(self->more, count > shown);
    g_free(more);
    self->is_updating = FALSE;
    show_chosen(self);
}

/* The one that is new among the selected rows is shown; where none is, the one that was, or the last of them. */
static void rows_selected(GtkListBox *list, AppSources *self)
{
    if (self->is_updating)
        return;
    GList *rows = gtk_list_box_get_selected_rows(list);
    GArray *together = g_array_new(FALSE, FALSE, sizeof(gsize));
    gsize shown = self->chosen;
    gboolean is_left = TRUE, is_new = FALSE;
    for (GList *at = rows; at; at = at->next) {
        const gsize index = (gsize)gtk_list_box_row_get_index(at->data);
        g_array_append_val(together, index);
        is_left = is_left && index != self->chosen;
        if (is_chosen(self, index))
            continue;
        shown = index;
        is_new = TRUE;
    }
    g_list_free(rows);
    if (together->len == 0) { /* one stays chosen */
        g_array_unref(together);
        app_sources_refresh(self);
        return;
    }
    if (is_left && !is_new)
        shown = g_array_index(together, gsize, together->len - 1);
    self->chosen = shown;
    g_array_unref(self->together);
    self->together = together;
    show_chosen(self);
    g_signal_emit(self, signals[CHOSEN], 0, (guint)self->chosen);
}

/* A finger chooses one alone, as the mouse does, where GTK would take one more in. */
static void row_tapped(GtkGestureClick *gesture, int count, double x, double y, AppSources *self)
{
    GtkListBoxRow *row = gtk_list_box_get_row_at_y(GTK_LIST_BOX(self->list), (int)y);
    (void)count;
    (void)x;
    if (!row)
        return;
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    app_sources_choose(self, (gsize)gtk_list_box_row_get_index(row));
    g_signal_emit(self, signals[CHOSEN], 0, (guint)self->chosen);
}

void app_sources_choose(AppSources *self, gsize index)
{
    choose_alone(self, index);
    app_sources_refresh(self);
    app_reveal_row(GTK_LIST_BOX(self->list), GTK_SCROLLED_WINDOW(self->scrolled), (int)index);
}

void app_sources_toggle(AppSources *self, gsize index)
{
    guint at = 0;
    while (at < self->together->len && g_array_index(self->together, gsize, at) < index)
        at++;
    if (!is_chosen(self, index)) {
        g_array_insert_val(self->together, at, index);
        self->chosen = index;
    } else if (self->together->len > 1) {
        g_array_remove_index(self->together, at);
        if (self->chosen == index)
            self->chosen = g_array_index(self->together, gsize, 0);
    }
    app_sources_refresh(self);
    g_signal_emit(self, signals[CHOSEN], 0, (guint)self->chosen);
}

void app_sources_hover(AppSources *self, gssize index)
{
    for (guint i = 0; i < self->items->len; i++) {
        GtkWidget *row = GTK_WIDGET(gtk_list_box_get_row_at_index(GTK_LIST_BOX(self->list), (int)i));
        if ((gssize)i == index)
            gtk_widget_add_css_class(row, "hovered");
        else
            gtk_widget_remove_css_class(row, "hovered");
    }
}

gboolean app_sources_set_version(AppSources *self, guint64 serial)
{
    self->wanted = serial;
    for (guint i = 0; i < self->items->len; i++)
        app_source_row_set_stale(g_ptr_array_index(self->items, i), self->serial != self->wanted);
    return self->serial == self->wanted;
}

void app_sources_forget(AppSources *self)
{
    self->serial = 0;
    for (guint i = 0; i < self->items->len; i++)
        app_source_row_set_gives(g_ptr_array_index(self->items, i), NULL, NULL, NULL);
    app_sources_show_shares(self, NULL);
}

void app_sources_show_shares(AppSources *self, const AppReading *reading)
{
    const gboolean any = reading && reading->value.on_surface && reading->value.has_value;
    for (guint i = 0; i < self->items->len; i++)
        app_source_row_set_share(g_ptr_array_index(self->items, i),
                                 any && i < reading->share_count ? reading->shares[i] : (double)NAN,
                                 any ? reading->value.value : 0);
}

void app_sources_show(AppSources *self, const AppMeasures *measures, gboolean photometric)
{
    for (guint i = 0; i < self->items->len && i < measures->source_count; i++) {
        const char *unit = app_moment_unit(measures->live->moment, LUXEL_IRRADIANCE);
        app_source_row_set_gives(g_ptr_array_index(self->items, i), &measures->sources[i],
                                 photometric ? _("lm") : _("W"), unit);
    }
    self->serial = measures->live->moment->serial;
    app_sources_set_version(self, self->wanted);
}

gboolean app_sources_set_fault(AppSources *self, const char *key, const char *reason)
{
    gsize index = 0;
    if (key && g_str_has_prefix(key, "lights["))
        index = (gsize)g_ascii_strtoull(key + strlen("lights["), NULL, 10);
    if (key && g_str_has_prefix(key, "lights[") && index != self->chosen &&
        index < app_document_size(self->document, "lights"))
        app_sources_choose(self, index);
    return app_form_set_fault(APP_FORM(self->form), key, reason);
}

/* ---- what can be done ---- */

static gsize behind_chosen(AppSources *self)
{
    return MIN(self->chosen + 1, app_document_size(self->document, "lights"));
}

static void insert(AppSources *self, gsize index, const char *yaml)
{
    const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "lights", .value = yaml, .index = index};
    app_sources_end_solo(self);
    if (app_document_edit(self->document, &edit, 1, NULL, NULL)) {
        app_sources_choose(self, index);
        g_signal_emit(self, signals[CHOSEN], 0, (guint)self->chosen);
    }
}

void app_sources_add(AppSources *self, const char *name)
{
    char *yaml = app_new_source(self->document, name, self->chosen);
    if (yaml)
        insert(self, behind_chosen(self), yaml);
    g_free(yaml);
}

void app_sources_add_luminaire(AppSources *self, const char *file)
{
    char *yaml = app_new_luminaire(self->document, file, self->chosen);
    if (yaml)
        insert(self, behind_chosen(self), yaml);
    g_free(yaml);
}

/* The doubles stand behind the last of the chosen ones, and are chosen in their place. */
void app_sources_duplicate(AppSources *self)
{
    AppEdits *edits = app_edits_new();
    const gsize behind = g_array_index(self->together, gsize, self->together->len - 1) + 1;
    gsize count = 0;
    for (guint i = 0; i < self->together->len; i++) {
        char *yaml = app_doubled_source(self->document, g_array_index(self->together, gsize, i));
        if (yaml)
            app_edits_add(edits, APP_EDIT_INSERT, "lights", yaml, behind + count++, 0);
        g_free(yaml);
    }
    app_sources_end_solo(self);
    if (count > 0 && app_edits_make(edits, self->document, NULL)) {
        choose_alone(self, behind);
        for (gsize i = 1; i < count; i++) {
            const gsize index = behind + i;
            g_array_append_val(self->together, index);
        }
        app_sources_refresh(self);
        g_signal_emit(self, signals[CHOSEN], 0, (guint)self->chosen);
    }
    app_edits_free(edits);
}

void app_sources_delete(AppSources *self)
{
    AppEdits *edits = app_edits_new();
    for (guint i = self->together->len; i-- > 0;) { /* from the end, so that the others stay where they are */
        const gsize index = g_array_index(self->together, gsize, i);
        char *key = g_strdup_printf("lights[%zu]", index);
        if (index < app_document_size(self->document, "lights"))
            app_edits_add(edits, APP_EDIT_REMOVE, key, NULL, 0, 0);
        g_free(key);
    }
    app_sources_end_solo(self);
    if (edits->list->len > 0) {
        choose_alone(self, g_array_index(self->together, gsize, 0));
        app_edits_make(edits, self->document, NULL);
    }
    app_edits_free(edits);
}

void app_sources_move(AppSources *self, int step)
{
    const gssize to = (gssize)self->chosen + step;
    if (to < 0 || to >= (gssize)app_document_size(self->document, "lights"))
        return;
    const AppEdit edit = {.kind = APP_EDIT_MOVE, .key = "lights", .index = self->chosen, .to = (gsize)to};
    app_sources_end_solo(self);
    choose_alone(self, (gsize)to);
    app_document_edit(self->document, &edit, 1, NULL, NULL);
    g_signal_emit(self, signals[CHOSEN], 0, (guint)self->chosen);
}

/* All that are chosen and can be aimed. */
void app_sources_aim(AppSources *self)
{
    char *center = app_document_get(self->document, "surfaces[0].center", NULL);
    AppEdits *edits = app_edits_new();
    for (guint i = 0; i < self->together->len && center; i++) {
        char *aimed = aimed_part(self, g_array_index(self->together, gsize, i));
        char *axis = g_strconcat(aimed, ".axis", NULL), *aim = g_strconcat(aimed, ".aim", NULL); /* NULL stays NULL */
        if (aimed) {
            app_edits_add(edits, APP_EDIT_REMOVE, axis, NULL, 0, 0);
            app_edits_add(edits, APP_EDIT_SET, aim, center, 0, 0);
        }
        g_free(aimed);
        g_free(axis);
        g_free(aim);
    }
    if (edits->list->len > 0)
        app_edits_make(edits, self->document, NULL);
    app_edits_free(edits);
    g_free(center);
}

void app_sources_end_solo(AppSources *self)
{
    if (self->solo < 0)
        return;
    self->solo = -1;
    g_signal_emit(self, signals[SOLO], 0, -1);
    app_sources_refresh(self);
}

char *app_sources_paste(AppSources *self, const char *text)
{
    gsize count;
    char *fault;
    double *places = app_numbers_read(text, 3, &count, &fault);
    if (!places)
        return fault;
    AppEdits *edits = app_edits_new();
    const gsize at = behind_chosen(self);
    app_new_points(self->document, places, count, self->chosen, at, edits);
    app_sources_end_solo(self);
    if (app_edits_make(edits, self->document, NULL))
        app_sources_choose(self, at + count - 1);
    app_edits_free(edits);
    g_free(places);
    return NULL;
}

/* ---- the class ---- */

static void app_sources_dispose(GObject *object)
{
    AppSources *self = APP_SOURCES(object);
    self->is_updating = TRUE; /* rows that go choose nothing */
    g_clear_object(&self->document);
    G_OBJECT_CLASS(app_sources_parent_class)->dispose(object);
}

static void app_sources_finalize(GObject *object)
{
    g_ptr_array_unref(APP_SOURCES(object)->items);
    g_array_unref(APP_SOURCES(object)->together);
    G_OBJECT_CLASS(app_sources_parent_class)->finalize(object);
}

static void app_sources_class_init(AppSourcesClass *class)
{
    G_OBJECT_CLASS(class)->dispose = app_sources_dispose;
    G_OBJECT_CLASS(class)->finalize = app_sources_finalize;
    signals[CHOSEN] =
        g_signal_new("chosen", APP_TYPE_SOURCES, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_UINT);
    signals[HOVERED] =
        g_signal_new("hovered", APP_TYPE_SOURCES, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_INT);
    signals[SOLO] =
        g_signal_new("solo", APP_TYPE_SOURCES, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_INT);
}

static void app_sources_init(AppSources *self)
{
    self->items = g_ptr_array_new();
    self->together = g_array_new(FALSE, FALSE, sizeof(gsize));
    choose_alone(self, 0);
    self->solo = -1;
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 6);
}

static GtkWidget *new_toolbar(AppSources *self)
{
    GtkWidget *bar = app_toolbar_new();
    app_toolbar_add_kinds(bar, self->parameters, "lights", _("Add a source"), "win.source-add");
    app_toolbar_add(bar, "edit-copy-symbolic", _("Duplicate the source"), "win.source-duplicate");
    app_toolbar_add(bar, "list-remove-symbolic", _("Delete the source"), "win.source-delete");
    app_toolbar_add(bar, "go-up-symbolic", _("Move the source up"), "win.source-up");
    app_toolbar_add(bar, "go-down-symbolic", _("Move the source down"), "win.source-down");
    self->aim = app_toolbar_add(bar, "find-location-symbolic", _("Aim the source at the surface"), "win.source-aim");
    app_toolbar_add(bar, "edit-paste-symbolic", _("Paste sources: x, y, z; x, y, z"), "win.source-paste");
    return bar;
}

GtkWidget *app_sources_new(AppDocument *document, const luxel_parameters *parameters)
{
    AppSources *self = g_object_new(APP_TYPE_SOURCES, NULL);
    self->document = g_object_ref(document);
    self->parameters = parameters;
    self->list = gtk_list_box_new();
    self->more = gtk_label_new(NULL);
    self->form = app_form_new(document, parameters, prefixes, NULL);
    gtk_widget_add_css_class(self->list, "frame");
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->list), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Sources"), -1);
    gtk_list_box_set_selection_mode(GTK_LIST_BOX(self->list), GTK_SELECTION_MULTIPLE);
    /* else a click takes one more in, as with Ctrl */
    gtk_list_box_set_activate_on_single_click(GTK_LIST_BOX(self->list), FALSE);
    GtkGesture *tap = gtk_gesture_click_new();
    gtk_gesture_single_set_touch_only(GTK_GESTURE_SINGLE(tap), TRUE);
    g_signal_connect(tap, "released", G_CALLBACK(row_tapped), self);
    gtk_widget_add_controller(self->list, GTK_EVENT_CONTROLLER(tap));
    g_signal_connect(self->list, "selected-rows-changed", G_CALLBACK(rows_selected), self);
    self->several = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(self->several), 0);
    gtk_label_set_wrap(GTK_LABEL(self->several), TRUE);
    gtk_widget_add_css_class(self->several, "heading");
    self->scrolled = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(self->scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(self->scrolled), self->list);
    gtk_box_append(GTK_BOX(self), new_toolbar(self)); /* above the list, which grows, so that it stays in its place */
    gtk_box_append(GTK_BOX(self), self->scrolled);
    gtk_box_append(GTK_BOX(self), self->more);
    gtk_box_append(GTK_BOX(self), self->several);
    gtk_box_append(GTK_BOX(self), self->form);
    self->diagram = app_diagram_new();
    gtk_box_append(GTK_BOX(self), self->diagram);
    app_sources_refresh(self);
    return GTK_WIDGET(self);
}

/* SPDX-License-Identifier: MIT */
/* Forms: rows, made when they are first seen of an element's type, and refreshed from the document. */
#include "form.h"

#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "../base/menu.h"
#include "../base/number.h"
#include "../base/row.h"
#include "../base/vector.h"
#include "rules.h"

/* One control: a parameter, or one of its numbers. */
typedef struct Entry {
    AppForm *form;
    const luxel_parameter *parameter;
    int component; /* -1: the whole */
    GtkWidget *row;   /* made when it is first seen, as */
    GtkWidget *block; /* what stands in the form is: the row, or the vector that it is a part of */
} Entry;

struct _AppForm {
    GtkBox parent;
    AppDocument *document;
    const luxel_parameters *parameters;
    const char *const *prefixes;
    const char *except;
    AppKeys keys;
    char *type;
    GArray *others; /* gsize: the elements that take the changes, too */
    GPtrArray *entries;
    gboolean is_photometric;
    const char *suggested; /* the key that a range was told of, */
    double suggestion[2];  /* which is this one */
};

G_DEFINE_FINAL_TYPE(AppForm, app_form, GTK_TYPE_BOX)

/* ---- words ---- */

static const char *unit_of(const AppForm *self, const luxel_parameter *parameter)
{
    return self->is_photometric ? parameter->photometric_unit : parameter->unit;
}

static const char *component_name(const luxel_parameter *parameter, int component)
{
    static const char *const space[] = {"x", "y", "z"}, *const channels[] = {"R", "G", "B"};
    static const char *const pixels[] = {N_("columns"), N_("rows")}, *const sides[] = {N_("width"), N_("height")};
    if (parameter->value_type == LUXEL_PARAMETER_WHOLE_NUMBERS)
        return _(pixels[component]);
    if (strstr(parameter->path, "color")) /* channels, or the chromaticity x, y */
        return parameter->count == 3 ? channels[component] : space[component];
    return parameter->count == 3 ? space[component] : _(sides[component]);
}

/* The label of a row; quantities have names of their own in photometric units. */
static char *label_of(const AppForm *self, const luxel_parameter *parameter, int component)
{
    static const struct {
        const char *end, *label;
    } photometric[] = {
        {".irradiance", N_("Illuminance")},
        {".radiance", N_("Luminance")},
        {"lights[].horizontal", N_("Horizontal illuminance")},
        {"lights[].direct", N_("Direct illuminance")},
        {"lights[].diffuse", N_("Diffuse illuminance")},
        {"lights[].extraterrestrial", N_("Extraterrestrial illuminance")},
    };
    const char *label = parameter->label;
    for (gsize i = 0; i < G_N_ELEMENTS(photometric) && self->is_photometric; i++)
        if (g_str_has_suffix(parameter->path, photometric[i].end))
            label = _(photometric[i].label);
    return component < 0 ? g_strdup(label) : g_strdup_printf("%s, %s", label, component_name(parameter, component));
}

static AppRowKind kind_of(const luxel_parameter *parameter)
{
    switch (parameter->value_type) {
    case LUXEL_PARAMETER_NUMBER:
    case LUXEL_PARAMETER_NUMBERS: return APP_ROW_NUMBER;
    case LUXEL_PARAMETER_WHOLE_NUMBER:
    case LUXEL_PARAMETER_WHOLE_NUMBERS: return APP_ROW_WHOLE;
    case LUXEL_PARAMETER_GROUP: /* that is there or not */
    case LUXEL_PARAMETER_YES_OR_NO: return APP_ROW_SWITCH;
    case LUXEL_PARAMETER_CHOICE: return APP_ROW_CHOICE;
    case LUXEL_PARAMETER_CHOICE_OR_PAIR: return APP_ROW_RANGE;
    case LUXEL_PARAMETER_CHOICE_OR_WHOLE: return APP_ROW_CHOICE_OR_WHOLE;
    case LUXEL_PARAMETER_TEXT: return g_str_has_suffix(parameter->path, ".date") ? APP_ROW_DATE : APP_ROW_TEXT;
    default: return APP_ROW_YAML;
    }
}

/* ---- changing ---- */

/* What is to be said of an error that is about a key; the caller's, luxel_text_free().  NULL: there is none. */
static char *fault_about(const luxel_diagnostics *faults, const char *path)
{
    const gsize length = strlen(path);
    for (gsize i = 0; i < luxel_diagnostics_count(faults); i++) {
        const luxel_diagnostic *fault = luxel_diagnostics_get(faults, i);
        if (fault->severity == LUXEL_SEVERITY_ERROR &&
            (!fault->key || (strncmp(fault->key, path, length) == 0 && strchr(".[", fault->key[length]))))
            return luxel_diagnostics_message(faults, i, language_translate, NULL);
    }
    return NULL;
}

/*
 * Why a text that was typed cannot be a value of this key, found out on a copy, so that the document never has it; the
 * caller's, luxel_text_free().  NULL: it can.
 */
static char *reason_against(AppForm *self, const AppEdits *edits, const Entry *entry)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    AppDocument *trial = app_document_copy(self->document);
    char *path = app_keys_path(&self->keys, entry->parameter), *reason = NULL;
    luxel_scene *scene = NULL;
    if (app_edits_make(edits, trial, faults)) {
        scene = app_document_copy_scene(trial);
        if (scene && luxel_scene_commit(scene, faults) == LUXEL_OK)
            luxel_scene_check_view(scene, faults);
    }
    reason = fault_about(faults, path);
    luxel_scene_free(scene);
    g_object_unref(trial);
    g_free(path);
    luxel_diagnostics_free(faults);
    return reason;
}

static void apply(AppForm *self, AppEdits *edits, const Entry *entry)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    if (!app_edits_make(edits, self->document, faults)) {
        char *reason = luxel_diagnostics_message(faults, 0, language_translate, NULL);
        app_row_set_fault(APP_ROW(entry->row), reason ? reason : _("this cannot be set"));
        luxel_text_free(reason);
    }
    luxel_diagnostics_free(faults);
}

/* Adds to the edits what a change of the entry is to one element. */
typedef void (*Change)(const AppKeys *keys, const Entry *entry, const char *yaml, AppEdits *edits);

/* The change of the element that is shown, and of the others, as one step. */
static void change_all(const Entry *entry, Change change, const char *yaml, AppEdits *edits)
{
    const AppForm *self = entry->form;
    const gboolean is_name = g_str_has_suffix(entry->parameter->path, ".name");
    change(&self->keys, entry, yaml, edits);
    for (guint i = 0; i < self->others->len && !is_name; i++) {
        AppKeys keys = self->keys;
        keys.index = g_array_index(self->others, gsize, i);
        char *path = g_strdup_printf("lights[%zu].type", keys.index);
        char *type = app_document_get(self->document, path, NULL);
        keys.type = type;
        if (type && app_keys_has(&keys, entry->parameter) && app_keys_is_shown(&keys, entry->parameter))
            change(&keys, entry, yaml, edits);
        g_free(type);
        g_free(path);
    }
}

static void change_value(const AppKeys *keys, const Entry *entry, const char *yaml, AppEdits *edits)
{
    const gboolean is_group = entry->parameter->value_type == LUXEL_PARAMETER_GROUP;
    if (*yaml == '\0' || strcmp(yaml, "\"\"") == 0 || (is_group && strcmp(yaml, "false") == 0)) {
        char *path = app_keys_path(keys, entry->parameter);
        app_edits_add(edits, APP_EDIT_REMOVE, path, NULL, 0, 0);
        g_free(path);
    } else
        app_keys_set(keys, entry->parameter, entry->component, yaml, edits);
}

static void edited(AppRow *row, const char *yaml, Entry *entry)
{
    AppEdits *edits = app_edits_new();
    app_row_set_fault(row, NULL);
    change_all(entry, change_value, yaml, edits);
    const AppRowKind kind = kind_of(entry->parameter);
    const gboolean is_typed = kind == APP_ROW_TEXT || kind == APP_ROW_DATE || kind == APP_ROW_YAML;
    char *reason = is_typed ? reason_against(entry->form, edits, entry) : NULL;
    if (reason)
        app_row_refuse(row, reason);
    else
        apply(entry->form, edits, entry);
    luxel_text_free(reason);
    app_edits_free(edits);
}

/* The value of a key that is not given; NULL: it must be given. */
static const char *default_of(const luxel_parameter *parameter)
{
    return parameter->value_type == LUXEL_PARAMETER_GROUP ? _("none") : parameter->default_value;
}

/* The default, or what the scene had when it was opened. */
static void change_back(const AppKeys *keys, const Entry *entry, const char *yaml, AppEdits *edits)
{
    char *path = app_keys_path(keys, entry->parameter);
    char *opened = app_document_get_opened(entry->form->document, path);
    (void)yaml;
    if (default_of(entry->parameter))
        app_edits_add(edits, APP_EDIT_REMOVE, path, NULL, 0, 0);
    else if (opened)
        app_keys_set(keys, entry->parameter, -1, opened, edits);
    g_free(opened);
    g_free(path);
}

static void reset(AppRow *row, Entry *entry)
{
    AppEdits *edits = app_edits_new();
    (void)row;
    change_all(entry, change_back, NULL, edits);
    if (edits->list->len > 0)
        apply(entry->form, edits, entry);
    app_edits_free(edits);
}

/* ---- the menu of a row ---- */

typedef struct Switch {
    Entry *entry;
    const luxel_parameter *to;
} Switch;

static void menu_reset(GtkButton *button, Entry *entry)
{
    gtk_popover_popdown(GTK_POPOVER(gtk_widget_get_ancestor(GTK_WIDGET(button), GTK_TYPE_POPOVER)));
    reset(NULL, entry);
}

static void menu_copy(GtkButton *button, Entry *entry)
{
    char *path = app_keys_path(&entry->form->keys, entry->parameter);
    char *value = app_document_get(entry->form->document, path, NULL);
    char *assignment = g_strdup_printf("%s=%s", path, value ? value : "");
    gdk_clipboard_set_text(gtk_widget_get_clipboard(GTK_WIDGET(entry->form)), assignment);
    gtk_popover_popdown(GTK_POPOVER(gtk_widget_get_ancestor(GTK_WIDGET(button), GTK_TYPE_POPOVER)));
    g_free(assignment);
    g_free(value);
    g_free(path);
}

/* Gives the key with this name instead. */
static void change_key(const AppKeys *keys, const Entry *entry, const char *name, AppEdits *edits)
{
    const luxel_parameter *to = app_keys_beside(keys, entry->parameter, name);
    if (to && app_keys_has(keys, to))
        app_keys_switch(keys, entry->parameter, to, edits);
}

static void menu_switch(GtkButton *button, Switch *change)
{
    AppEdits *edits = app_edits_new();
    Switch wanted = *change; /* which goes with the menu */
    change_all(wanted.entry, change_key, strrchr(wanted.to->path, '.') + 1, edits);
    gtk_popover_popdown(GTK_POPOVER(gtk_widget_get_ancestor(GTK_WIDGET(button), GTK_TYPE_POPOVER)));
    apply(wanted.entry->form, edits, wanted.entry);
    app_edits_free(edits);
}

static void free_switch(gpointer data, GClosure *closure)
{
    (void)closure;
    g_free(data);
}

static void add_switches(Entry *entry, GtkWidget *box)
{
    GPtrArray *names = app_keys_instead(&entry->form->keys, entry->parameter);
    for (guint i = 0; i < names->len; i++) {
        const luxel_parameter *to = app_keys_beside(&entry->form->keys, entry->parameter, g_ptr_array_index(names, i));
        /* TRANSLATORS: a key is given instead of another; %s is its name, such as Radiance */
        char *text = g_strdup_printf(_("Give “%s” instead"), to->label);
        Switch *change = g_new(Switch, 1);
        *change = (Switch){entry, to};
        g_signal_connect_data(app_menu_add(box, text), "clicked", G_CALLBACK(menu_switch), change, free_switch, 0);
        g_free(text);
    }
    g_ptr_array_unref(names);
}

static void show_menu(AppRow *row, GtkWidget *at, Entry *entry)
{
    GtkWidget *popover = gtk_popover_new(), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0);
    char *text = default_of(entry->parameter)
                     /* TRANSLATORS: %s is a value */
                     ? g_strdup_printf(_("Back to the default, %s"), default_of(entry->parameter))
                     : g_strdup(_("Back to what was opened"));
    (void)row;
    g_signal_connect(app_menu_add(box, text), "clicked", G_CALLBACK(menu_reset), entry);
    g_signal_connect(app_menu_add(box, _("Copy as key=value")), "clicked", G_CALLBACK(menu_copy), entry);
    add_switches(entry, box);
    g_free(text);
    gtk_popover_set_child(GTK_POPOVER(popover), box);
    app_menu_show(popover, GTK_WIDGET(entry->form), at);
}

/* ---- making rows ---- */

/* The window chooses the file, as it knows which kinds there are. */
static void browse(AppRow *row, Entry *entry)
{
    char *path = app_keys_path(&entry->form->keys, entry->parameter);
    gtk_widget_activate_action(GTK_WIDGET(row), "win.choose-file", "s", path);
    g_free(path);
}

static gboolean is_file(const luxel_parameter *parameter)
{
    return parameter->value_type == LUXEL_PARAMETER_TEXT &&
           (g_str_has_suffix(parameter->path, ".file") || g_str_has_suffix(parameter->path, ".mesh"));
}

/* What an empty field stands for, in grey; NULL: a field that may not be empty. */
static const char *missing_of(const luxel_parameter *parameter)
{
    if (parameter->default_value || parameter->required)
        return parameter->default_value;
    /* the weight of ambient light is that of diffuse light */
    return g_str_has_suffix(parameter->path, ".material.ambient") ? "= kd" : _("none");
}

static void make_row(AppForm *self, Entry *entry)
{
    const luxel_parameter *parameter = entry->parameter;
    const int component = entry->component;
    char *label = label_of(self, parameter, component);
    const AppRowSpec spec = {
        .kind = kind_of(parameter),
        .label = label,
        .part = component < 0 ? NULL : component_name(parameter, component),
        .unit = unit_of(self, parameter),
        .meaning = parameter->meaning,
        .choices = parameter->choices,
        .legal = parameter->legal_range,
        .advised = parameter->advised_range[MAX(component, 0)],
        .advised_words = parameter->advised,
        .hint = parameter->choices ? parameter->choices : parameter->type,
        .missing = missing_of(parameter),
        .is_file = is_file(parameter),
    };
    entry->row = app_row_new(&spec);
    g_signal_connect(entry->row, "edited", G_CALLBACK(edited), entry);
    g_signal_connect(entry->row, "reset", G_CALLBACK(reset), entry);
    g_signal_connect(entry->row, "menu", G_CALLBACK(show_menu), entry);
    g_signal_connect(entry->row, "browse", G_CALLBACK(browse), entry);
    if (g_strcmp0(self->suggested, parameter->path) == 0)
        app_row_suggest(APP_ROW(entry->row), self->suggestion[0], self->suggestion[1]);
    g_free(label);
}

/* The row of an entry, or the vector of it and those behind it, `count` in all; it stands behind `sibling`. */
static void make_block(AppForm *self, Entry *const *entries, guint count, GtkWidget *sibling)
{
    const luxel_parameter *parameter = entries[0]->parameter;
    char *label = label_of(self, parameter, -1);
    GtkWidget *vector =
        entries[0]->component < 0 ? NULL : app_vector_new(label, unit_of(self, parameter), parameter->meaning);
    for (guint i = 0; i < count; i++) {
        make_row(self, entries[i]);
        entries[i]->block = vector ? vector : entries[i]->row;
        if (vector)
            app_vector_add(APP_VECTOR(vector), APP_ROW(entries[i]->row));
    }
    gtk_widget_set_name(entries[0]->block, parameter->path);
    gtk_box_insert_child_after(GTK_BOX(self), entries[0]->block, sibling);
    g_free(label);
}

static gboolean belongs(const AppForm *self, const char *path)
{
    if (self->except && g_str_has_prefix(path, self->except))
        return FALSE;
    for (gsize i = 0; self->prefixes[i]; i++) {
        const char *prefix = self->prefixes[i];
        /* a prefix without a dot at its end is a whole key */
        if (g_str_has_suffix(prefix, ".") ? g_str_has_prefix(path, prefix) : strcmp(path, prefix) == 0)
            return TRUE;
    }
    return FALSE;
}

static void add_entries(AppForm *self, const luxel_parameter *parameter)
{
    const luxel_parameter_type type = parameter->value_type;
    const gboolean is_vector = (type == LUXEL_PARAMETER_NUMBERS || type == LUXEL_PARAMETER_WHOLE_NUMBERS) &&
                               parameter->count <= 3;
    if (type == LUXEL_PARAMETER_GROUPS || type == LUXEL_PARAMETER_VARIANTS ||
        (type == LUXEL_PARAMETER_GROUP && !app_keys_is_optional(&self->keys, parameter)))
        return;
    for (int i = 0; i < (is_vector ? (int)parameter->count : 1); i++) {
        Entry *entry = g_new0(Entry, 1);
        *entry = (Entry){self, parameter, is_vector ? i : -1, NULL, NULL};
        g_ptr_array_add(self->entries, entry);
    }
}

static void rebuild(AppForm *self)
{
    GtkWidget *child;
    while ((child = gtk_widget_get_first_child(GTK_WIDGET(self))))
        gtk_box_remove(GTK_BOX(self), child);
    g_ptr_array_set_size(self->entries, 0);
    for (gsize i = 0; i < luxel_parameters_count(self->parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(self->parameters, i);
        if (belongs(self, parameter->path) && app_keys_has(&self->keys, parameter))
            add_entries(self, parameter);
    }
}

/* ---- showing ---- */

static void show_value(const AppForm *self, const Entry *entry)
{
    double numbers[3];
    char text[APP_NUMBER_SIZE], *path = app_keys_path(&self->keys, entry->parameter);
    gboolean written = FALSE;
    char *value = app_document_get(self->document, path, &written);
    if (entry->parameter->value_type == LUXEL_PARAMETER_GROUP)
        app_row_set(APP_ROW(entry->row), written ? "true" : "false");
    else if (entry->component < 0)
        app_row_set(APP_ROW(entry->row), value);
    else if (value && app_list_read(value, numbers, 3) > (gsize)entry->component)
        app_row_set(APP_ROW(entry->row), app_number_write(numbers[entry->component], text));
    g_free(value);
    g_free(path);
}

static void refresh_units(AppForm *self)
{
    char *units = app_document_get(self->document, "units", NULL);
    const gboolean photometric = g_strcmp0(units, "photometric") == 0;
    g_free(units);
    if (photometric == self->is_photometric)
        return;
    self->is_photometric = photometric;
    for (guint i = 0; i < self->entries->len; i++) {
        const Entry *entry = g_ptr_array_index(self->entries, i);
        if (!entry->row)
            continue;
        char *label = label_of(self, entry->parameter, entry->component);
        if (APP_IS_VECTOR(entry->block))
            app_vector_set_unit(APP_VECTOR(entry->block), unit_of(self, entry->parameter));
        else
            app_row_set_unit(APP_ROW(entry->row), unit_of(self, entry->parameter));
        app_row_set_label(APP_ROW(entry->row), label);
        g_free(label);
    }
}

void app_form_fill(AppForm *self)
{
    GtkWidget *last = NULL;
    guint count;
    refresh_units(self);
    for (guint i = 0; i < self->entries->len; i += count) {
        Entry *const *entries = (Entry *const *)&self->entries->pdata[i];
        const gboolean shown = app_keys_is_shown(&self->keys, entries[0]->parameter);
        count = entries[0]->component < 0 ? 1 : entries[0]->parameter->count;
        if (shown && !entries[0]->block)
            make_block(self, entries, count, last);
        if (!entries[0]->block)
            continue;
        last = entries[0]->block;
        gtk_widget_set_visible(last, shown);
        for (guint k = 0; k < count && shown; k++)
            show_value(self, entries[k]);
    }
}

void app_form_refresh(AppForm *self)
{
    if (gtk_widget_get_mapped(GTK_WIDGET(self)))
        app_form_fill(self);
}

static void app_form_map(GtkWidget *widget)
{
    app_form_fill(APP_FORM(widget));
    GTK_WIDGET_CLASS(app_form_parent_class)->map(widget);
}

void app_form_set_element(AppForm *self, gsize index, const char *type)
{
    const gboolean is_same = g_strcmp0(type, self->type) == 0 && self->entries->len > 0;
    self->keys.index = index;
    if (!is_same) {
        g_free(self->type);
        self->type = g_strdup(type);
        self->keys.type = self->type;
        rebuild(self);
    }
    gtk_widget_set_visible(GTK_WIDGET(self), type != NULL);
    if (type)
        app_form_refresh(self);
}

void app_form_set_others(AppForm *self, const gsize *others, gsize count)
{
    g_array_set_size(self->others, 0);
    g_array_append_vals(self->others, others, (guint)count);
}

void app_form_suggest(AppForm *self, const char *key, double low, double high)
{
    self->suggested = key;
    self->suggestion[0] = low;
    self->suggestion[1] = high;
    for (guint i = 0; i < self->entries->len; i++) {
        const Entry *entry = g_ptr_array_index(self->entries, i);
        if (entry->row && strcmp(entry->parameter->path, key) == 0)
            app_row_suggest(APP_ROW(entry->row), low, high);
    }
}

gboolean app_form_set_fault(AppForm *self, const char *key, const char *reason)
{
    gboolean found = FALSE;
    if (key)
        app_form_fill(self); /* in a section that is closed, too */
    for (guint i = 0; i < self->entries->len; i++) {
        const Entry *entry = g_ptr_array_index(self->entries, i);
        if (!entry->row)
            continue;
        char *path = app_keys_path(&self->keys, entry->parameter);
        const gsize length = strlen(path);
        /* a number of a list is the row's, too */
        gboolean meant = key && strncmp(key, path, length) == 0 && (key[length] == '\0' || key[length] == '[');
        if (meant || !key)
            app_row_set_fault(APP_ROW(entry->row), meant ? reason : NULL);
        found |= meant;
        g_free(path);
    }
    return found;
}

/* ---- the class ---- */

static void app_form_dispose(GObject *object)
{
    AppForm *self = APP_FORM(object);
    g_clear_object(&self->document);
    G_OBJECT_CLASS(app_form_parent_class)->dispose(object);
}

static void app_form_finalize(GObject *object)
{
    AppForm *self = APP_FORM(object);
    g_ptr_array_unref(self->entries);
    g_array_unref(self->others);
    g_free(self->type);
    G_OBJECT_CLASS(app_form_parent_class)->finalize(object);
}

static void app_form_class_init(AppFormClass *class)
{
    G_OBJECT_CLASS(class)->dispose = app_form_dispose;
    G_OBJECT_CLASS(class)->finalize = app_form_finalize;
    GTK_WIDGET_CLASS(class)->map = app_form_map;
}

static void app_form_init(AppForm *self)
{
    self->entries = g_ptr_array_new_with_free_func(g_free);
    self->others = g_array_new(FALSE, FALSE, sizeof(gsize));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 4);
}

GtkWidget *app_form_new(AppDocument *document, const luxel_parameters *parameters, const char *const *prefixes,
                        const char *except)
{
    AppForm *self = g_object_new(APP_TYPE_FORM, NULL);
    self->document = g_object_ref(document);
    self->parameters = parameters;
    self->prefixes = prefixes;
    self->except = except;
    self->keys = (AppKeys){.document = document, .parameters = parameters};
    if (!strstr(prefixes[0], "[]"))
        rebuild(self);
    return GTK_WIDGET(self);
}

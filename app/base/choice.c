/* SPDX-License-Identifier: MIT */
/* A list of words, with fields below it for numbers in their stead. */
#include "choice.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "choices.h"
#include "number.h"
#include "row.h"

enum { DIGITS = 4 };

struct _AppChoice {
    GtkBox parent;
    char **words;
    guint numbers;
    GtkWidget *list, *line, *fields[2];
    char *shown; /* YAML that holds */
    double low, high;
    gboolean is_updating;
};

enum { CHOSEN, REFUSED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppChoice, app_choice, GTK_TYPE_BOX)

static guint word_count(const AppChoice *self)
{
    return g_strv_length(self->words);
}

static gboolean takes_numbers(const AppChoice *self)
{
    return self->numbers > 0 && gtk_drop_down_get_selected(GTK_DROP_DOWN(self->list)) == word_count(self);
}

static void mark_field(GtkWidget *field, gboolean wrong)
{
    if (wrong)
        gtk_widget_add_css_class(field, "error");
    else
        gtk_widget_remove_css_class(field, "error");
    gtk_accessible_update_state(GTK_ACCESSIBLE(field), GTK_ACCESSIBLE_STATE_INVALID,
                                wrong ? GTK_ACCESSIBLE_INVALID_TRUE : GTK_ACCESSIBLE_INVALID_FALSE, -1);
}

/* The numbers in the fields as YAML; NULL with *wrong, the field, and *reason, the caller's. */
static char *read_fields(AppChoice *self, GtkWidget **wrong, char **reason)
{
    double numbers[2] = {0, 0};
    char text[APP_NUMBER_SIZE];
    for (guint i = 0; i < self->numbers; i++) {
        const char *typed = gtk_editable_get_text(GTK_EDITABLE(self->fields[i]));
        if (app_number_read(typed, &numbers[i]))
            continue;
        *wrong = self->fields[i];
        *reason = g_strdup_printf(_("“%s” is not a number"), typed);
        return NULL;
    }
    *wrong = self->fields[self->numbers - 1];
    if (self->numbers == 2 && !(numbers[0] < numbers[1])) {
        *reason = g_strdup(_("the range must go from a smaller value to a greater one"));
        return NULL;
    }
    if (self->numbers == 1 && !(numbers[0] >= 1 && numbers[0] == floor(numbers[0]))) {
        *reason = g_strdup_printf(_("“%s” is not a whole number from 1 up"), app_number_write(numbers[0], text));
        return NULL;
    }
    return self->numbers == 2 ? app_list_write(numbers, 2) : g_strdup(app_number_write(numbers[0], text));
}

static void tell_numbers(AppChoice *self)
{
    GtkWidget *wrong = NULL;
    char *reason = NULL, *yaml = read_fields(self, &wrong, &reason);
    for (guint i = 0; i < self->numbers; i++)
        mark_field(self->fields[i], !yaml && self->fields[i] == wrong);
    g_signal_emit(self, signals[REFUSED], 0, reason ? reason : "");
    if (yaml && g_strcmp0(yaml, self->shown) != 0)
        g_signal_emit(self, signals[CHOSEN], 0, yaml);
    g_free(yaml);
    g_free(reason);
}

/* A field that goes as another word was chosen is left, too. */
static void field_left(AppChoice *self)
{
    if (!takes_numbers(self))
        return;
    tell_numbers(self);
    app_choice_restore(self);
}

/* The fields have what holds, or what a range of one's own begins with. */
static void fill_fields(AppChoice *self)
{
    double numbers[2] = {self->low, self->high};
    const gboolean holds = self->shown && app_list_read(self->shown, numbers, self->numbers) == self->numbers;
    char text[APP_NUMBER_SIZE];
    for (guint i = 0; i < self->numbers; i++) {
        gtk_editable_set_text(GTK_EDITABLE(self->fields[i]), holds ? app_number_show_all(numbers[i], text)
                                                                   : app_number_show(numbers[i], DIGITS, text));
        mark_field(self->fields[i], FALSE);
    }
}

static gboolean tell_choice(gpointer data)
{
    AppChoice *self = data;
    const guint selected = gtk_drop_down_get_selected(GTK_DROP_DOWN(self->list));
    if (!gtk_widget_get_parent(GTK_WIDGET(self)) || selected == GTK_INVALID_LIST_POSITION)
        return G_SOURCE_REMOVE;
    g_signal_emit(self, signals[REFUSED], 0, "");
    if (takes_numbers(self)) {
        fill_fields(self);
        tell_numbers(self);
    } else
        g_signal_emit(self, signals[CHOSEN], 0, self->words[selected]);
    return G_SOURCE_REMOVE;
}

/* A choice may make the form another one, and this control go: not while its list is still at work. */
static void selected(GtkDropDown *list, GParamSpec *spec, AppChoice *self)
{
    (void)list;
    (void)spec;
    if (self->line)
        gtk_widget_set_visible(self->line, takes_numbers(self));
    if (!self->is_updating)
        g_idle_add_full(G_PRIORITY_DEFAULT, tell_choice, g_object_ref(self), g_object_unref);
}

void app_choice_set(AppChoice *self, const char *yaml)
{
    guint found = yaml && self->numbers > 0 ? word_count(self) : GTK_INVALID_LIST_POSITION;
    const gboolean is_new = g_strcmp0(yaml, self->shown) != 0;
    for (guint i = 0; self->words[i] && yaml; i++)
        if (strcmp(self->words[i], yaml) == 0)
            found = i;
    self->is_updating = TRUE;
    if (is_new) {
        g_free(self->shown);
        self->shown = g_strdup(yaml);
    }
    gtk_drop_down_set_selected(GTK_DROP_DOWN(self->list), found);
    if (is_new && takes_numbers(self))
        fill_fields(self);
    self->is_updating = FALSE;
}

void app_choice_suggest(AppChoice *self, double low, double high)
{
    self->low = low;
    self->high = high;
}

gboolean app_choice_restore(AppChoice *self)
{
    double numbers[2];
    char text[APP_NUMBER_SIZE];
    if (!takes_numbers(self))
        return FALSE;
    const gboolean holds = self->shown && app_list_read(self->shown, numbers, self->numbers) == self->numbers;
    gboolean differs = !holds;
    for (guint i = 0; i < self->numbers && holds; i++)
        differs |=
            strcmp(gtk_editable_get_text(GTK_EDITABLE(self->fields[i])), app_number_show_all(numbers[i], text)) != 0;
    if (!differs)
        return FALSE;
    fill_fields(self);
    g_signal_emit(self, signals[REFUSED], 0, "");
    return TRUE;
}

void app_choice_name(AppChoice *self, const char *name, const char *meaning)
{
    static const char *const ends[] = {N_("%s, from"), N_("%s, to")};
    app_name_control(self->list, name);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->list), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, meaning, -1);
    for (guint i = 0; i < self->numbers; i++) {
        char *text = self->numbers == 2 ? g_strdup_printf(_(ends[i]), name) : g_strdup(name);
        gtk_accessible_update_property(GTK_ACCESSIBLE(self->fields[i]), GTK_ACCESSIBLE_PROPERTY_LABEL, text, -1);
        g_free(text);
    }
}

static void app_choice_finalize(GObject *object)
{
    AppChoice *self = APP_CHOICE(object);
    g_strfreev(self->words);
    g_free(self->shown);
    G_OBJECT_CLASS(app_choice_parent_class)->finalize(object);
}

static void app_choice_class_init(AppChoiceClass *class)
{
    G_OBJECT_CLASS(class)->finalize = app_choice_finalize;
    signals[CHOSEN] =
        g_signal_new("chosen", APP_TYPE_CHOICE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
    signals[REFUSED] =
        g_signal_new("refused", APP_TYPE_CHOICE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
}

static void app_choice_init(AppChoice *self)
{
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_box_set_spacing(GTK_BOX(self), 4);
    self->high = 1;
}

/* The word that is chosen is shortened where it is longer than the field; the list of them has its room. */
static GtkListItemFactory *new_short_factory(void)
{
    static const char template[] =
        "<interface><template class='GtkListItem'><property name='child'><object class='GtkLabel'>"
        "<property name='ellipsize'>end</property><property name='xalign'>0</property>"
        "<property name='max-width-chars'>8</property>"
        "<binding name='label'><lookup name='string' type='GtkStringObject'><lookup name='item'>GtkListItem</lookup>"
        "</lookup></binding></object></property></template></interface>";
    GBytes *bytes = g_bytes_new_static(template, sizeof template - 1);
    GtkListItemFactory *factory = gtk_builder_list_item_factory_new_from_bytes(NULL, bytes);
    g_bytes_unref(bytes);
    return factory;
}

/* The words as labels. */
static void add_list(AppChoice *self)
{
    GtkStringList *labels = gtk_string_list_new(NULL);
    for (guint i = 0; self->words[i]; i++)
        gtk_string_list_append(labels, app_choice_label(self->words[i]));
    if (self->numbers == 2)
        gtk_string_list_append(labels, _("from … to …"));
    else if (self->numbers == 1)
        gtk_string_list_append(labels, _("a number"));
    self->list = gtk_drop_down_new(G_LIST_MODEL(labels), NULL);
    GtkListItemFactory *factory = new_short_factory();
    gtk_drop_down_set_list_factory(GTK_DROP_DOWN(self->list), gtk_drop_down_get_factory(GTK_DROP_DOWN(self->list)));
    gtk_drop_down_set_factory(GTK_DROP_DOWN(self->list), factory);
    g_object_unref(factory);
    g_signal_connect(self->list, "notify::selected", G_CALLBACK(selected), self);
    gtk_box_append(GTK_BOX(self), self->list);
}

static void add_fields(AppChoice *self)
{
    self->line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    for (guint i = 0; i < self->numbers; i++) {
        GtkEventController *focus = gtk_event_controller_focus_new();
        self->fields[i] = gtk_entry_new();
        gtk_editable_set_width_chars(GTK_EDITABLE(self->fields[i]), 4);
        gtk_editable_set_max_width_chars(GTK_EDITABLE(self->fields[i]), 4);
        gtk_editable_set_enable_undo(GTK_EDITABLE(self->fields[i]), FALSE);
        gtk_widget_set_hexpand(self->fields[i], TRUE);
        g_signal_connect_swapped(self->fields[i], "activate", G_CALLBACK(tell_numbers), self);
        g_signal_connect_swapped(focus, "leave", G_CALLBACK(field_left), self);
        gtk_widget_add_controller(self->fields[i], focus);
        if (i > 0)
            gtk_box_append(GTK_BOX(self->line), gtk_label_new("–"));
        gtk_box_append(GTK_BOX(self->line), self->fields[i]);
    }
    gtk_widget_set_visible(self->line, FALSE);
    gtk_box_append(GTK_BOX(self), self->line);
}

GtkWidget *app_choice_new(const char *choices, guint numbers)
{
    AppChoice *self = g_object_new(APP_TYPE_CHOICE, NULL);
    self->words = g_strsplit(choices ? choices : "", ", ", -1);
    self->numbers = MIN(numbers, 2);
    add_list(self);
    if (self->numbers > 0)
        add_fields(self);
    return GTK_WIDGET(self);
}

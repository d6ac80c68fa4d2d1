/* SPDX-License-Identifier: MIT */
/* Cards with a picture each.  Pictures come one by one while the cards are already there to be chosen. */
#include "gallery.h"

#include <math.h>

#include "../../front/words.h"
#include "../base/row.h"
#include "../files/document.h"
#include "../files/recent.h"
#include "../picture/sketch.h"

enum { SPACE = 12, MOST_IN_LINE = 12, TITLE_LINES = 3, TITLE_COLUMNS = 24 };

struct _AppGallery {
    GtkBox parent;
    AppSketcher *sketcher;
    GtkWidget *scrolled, *recent_title, *recent, *builtin;
    GHashTable *pictures; /* by scene: the GtkPicture's of the cards, which have them */
    GPtrArray *cards;     /* in their order */
};

enum { CHOSEN, CLOSED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppGallery, app_gallery, GTK_TYPE_BOX)

static void show_sketch(const AppSketch *sketch, gpointer owner)
{
    AppGallery *self = owner;
    GtkWidget *picture = g_hash_table_lookup(self->pictures, sketch->scene);
    if (!picture || !sketch->pixels)
        return;
    GdkTexture *texture = gdk_memory_texture_new((int)sketch->columns, (int)sketch->rows, GDK_MEMORY_R8G8B8,
                                                 sketch->pixels, (gsize)sketch->columns * 3);
    gtk_picture_set_paintable(GTK_PICTURE(picture), GDK_PAINTABLE(texture));
    g_object_unref(texture);
}

/* ---- cards ---- */

static const char scene_of_card[] = "luxel-scene";

static void card_clicked(GtkWidget *card, AppGallery *self)
{
    g_signal_emit(self, signals[CHOSEN], 0, (const char *)g_object_get_data(G_OBJECT(card), scene_of_card));
}

static GtkWidget *new_title(const char *text, const char *style, int lines)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_yalign(GTK_LABEL(label), 0);
    gtk_label_set_wrap(GTK_LABEL(label), lines > 1);
    gtk_label_set_lines(GTK_LABEL(label), lines);
    gtk_label_set_ellipsize(GTK_LABEL(label), lines > 1 ? PANGO_ELLIPSIZE_END : PANGO_ELLIPSIZE_MIDDLE);
    gtk_label_set_width_chars(GTK_LABEL(label), TITLE_COLUMNS);
    gtk_label_set_max_width_chars(GTK_LABEL(label), TITLE_COLUMNS);
    gtk_widget_add_css_class(label, style);
    return label;
}

/* `more` says more of what is called `title`: in lines below it, and whole as a tooltip. */
static void add_card(AppGallery *self, GtkWidget *list, const char *scene, const char *title, const char *more)
{
    GtkWidget *card = gtk_button_new(), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    GtkWidget *picture = gtk_picture_new(), *ground = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0);
    GtkWidget *frame = gtk_overlay_new(); /* as large as its ground, whatever size the picture has */
    char *whole = g_strdup_printf("%s: %s", title, more);
    gtk_widget_set_size_request(ground, APP_SKETCH_COLUMNS, APP_SKETCH_ROWS);
    gtk_widget_add_css_class(ground, "sketch");
    gtk_overlay_set_child(GTK_OVERLAY(frame), ground);
    gtk_overlay_add_overlay(GTK_OVERLAY(frame), picture);
    gtk_widget_set_valign(box, GTK_ALIGN_START);
    gtk_box_append(GTK_BOX(box), frame);
    gtk_box_append(GTK_BOX(box), new_title(title, "heading", 1));
    gtk_box_append(GTK_BOX(box), new_title(more, "note", TITLE_LINES));
    gtk_button_set_child(GTK_BUTTON(card), box);
    gtk_widget_add_css_class(card, "flat");
    gtk_widget_set_tooltip_text(card, whole);
    app_name_control(card, whole);
    g_object_set_data_full(G_OBJECT(card), scene_of_card, g_strdup(scene), g_free);
    g_signal_connect(card, "clicked", G_CALLBACK(card_clicked), self);
    gtk_flow_box_append(GTK_FLOW_BOX(list), card);
    /* the card takes the keyboard, not what stands around it */
    gtk_widget_set_focusable(gtk_widget_get_parent(card), FALSE);
    g_hash_table_insert(self->pictures, g_strdup(scene), picture);
    g_ptr_array_add(self->cards, card);
    g_free(whole);
}

static void add_recent(AppGallery *self, const char *path)
{
    char *name = g_path_get_basename(path), *folder = g_path_get_dirname(path);
    char *shown_name = g_filename_display_name(name), *shown_folder = g_filename_display_name(folder);
    add_card(self, self->recent, path, shown_name, shown_folder);
    g_free(shown_folder);
    g_free(shown_name);
    g_free(folder);
    g_free(name);
}

static void clear(GtkWidget *list)
{
    for (GtkWidget *child; (child = gtk_widget_get_first_child(list));)
        gtk_flow_box_remove(GTK_FLOW_BOX(list), child);
}

void app_gallery_open(AppGallery *self)
{
    char **recent = app_recent_paths();
    GStrvBuilder *wanted = g_strv_builder_new();
    g_hash_table_remove_all(self->pictures);
    g_ptr_array_set_size(self->cards, 0);
    clear(self->recent);
    clear(self->builtin);
    for (guint i = 0; recent[i]; i++) {
        add_recent(self, recent[i]);
        g_strv_builder_add(wanted, recent[i]);
    }
    gtk_widget_set_visible(self->recent_title, recent[0] != NULL);
    gtk_widget_set_visible(self->recent, recent[0] != NULL);
    for (gsize i = 0; luxel_builtin_scene_name(i); i++) {
        char *scene = g_strconcat(APP_BUILTIN, luxel_builtin_scene_name(i), NULL);
        add_card(self, self->builtin, scene, luxel_builtin_scene_name(i), gettext(luxel_builtin_scene_title(i)));
        g_strv_builder_add(wanted, scene);
        g_free(scene);
    }
    char **scenes = g_strv_builder_end(wanted);
    app_sketcher_ask(self->sketcher, (const char *const *)scenes);
    g_strfreev(scenes);
    g_strv_builder_unref(wanted);
    gtk_adjustment_set_value(gtk_scrolled_window_get_vadjustment(GTK_SCROLLED_WINDOW(self->scrolled)), 0);
    gtk_widget_grab_focus(g_ptr_array_index(self->cards, 0));
    g_strfreev(recent);
}

/* ---- the class ---- */

static void find_middle(AppGallery *self, GtkWidget *card, double middle[2])
{
    graphene_rect_t bounds;
    if (!gtk_widget_compute_bounds(card, self->scrolled, &bounds))
        graphene_rect_init(&bounds, 0, 0, 0, 0);
    middle[0] = (double)(bounds.origin.x + bounds.size.width / 2);
    middle[1] = (double)(bounds.origin.y + bounds.size.height / 2);
}

/* The card of the next line, or with step -1 of the one before, that is nearest; NULL: there is none. */
static GtkWidget *card_of_line(AppGallery *self, GtkWidget *from, int step)
{
    double start[2], best = G_MAXDOUBLE;
    GtkWidget *found = NULL;
    find_middle(self, from, start);
    for (guint i = 0; i < self->cards->len; i++) {
        GtkWidget *card = g_ptr_array_index(self->cards, i);
        double middle[2];
        find_middle(self, card, middle);
        const double down = (middle[1] - start[1]) * step, aside = fabs(middle[0] - start[0]);
        if (down < APP_SKETCH_ROWS / 2.0 || down * 1e3 + aside >= best)
            continue;
        best = down * 1e3 + aside;
        found = card;
    }
    return found;
}

/* Arrows go from card to card, as these stand. */
static gboolean move_focus(AppGallery *self, guint key)
{
    GtkWidget *focus = gtk_root_get_focus(gtk_widget_get_root(GTK_WIDGET(self))), *next = NULL;
    guint index;
    if (!focus || !g_ptr_array_find(self->cards, focus, &index))
        return FALSE;
    if (key == GDK_KEY_Up || key == GDK_KEY_Down)
        next = card_of_line(self, focus, key == GDK_KEY_Down ? 1 : -1);
    else if (key == GDK_KEY_Left && index > 0)
        next = g_ptr_array_index(self->cards, index - 1);
    else if (key == GDK_KEY_Right && index + 1 < self->cards->len)
        next = g_ptr_array_index(self->cards, index + 1);
    if (next)
        gtk_widget_grab_focus(next);
    return next != NULL;
}

static gboolean key_pressed(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                            AppGallery *self)
{
    (void)controller;
    (void)code;
    (void)state;
    if (key != GDK_KEY_Escape)
        return move_focus(self, key);
    g_signal_emit(self, signals[CLOSED], 0);
    return TRUE;
}

static void app_gallery_dispose(GObject *object)
{
    AppGallery *self = APP_GALLERY(object);
    g_clear_pointer(&self->sketcher, app_sketcher_free);
    G_OBJECT_CLASS(app_gallery_parent_class)->dispose(object);
}

static void app_gallery_finalize(GObject *object)
{
    g_hash_table_unref(APP_GALLERY(object)->pictures);
    g_ptr_array_unref(APP_GALLERY(object)->cards);
    G_OBJECT_CLASS(app_gallery_parent_class)->finalize(object);
}

static void app_gallery_class_init(AppGalleryClass *class)
{
    G_OBJECT_CLASS(class)->dispose = app_gallery_dispose;
    G_OBJECT_CLASS(class)->finalize = app_gallery_finalize;
    signals[CHOSEN] =
        g_signal_new("chosen", APP_TYPE_GALLERY, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
    signals[CLOSED] = g_signal_new("closed", APP_TYPE_GALLERY, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static GtkWidget *new_list(const char *name)
{
    GtkWidget *list = gtk_flow_box_new();
    gtk_flow_box_set_selection_mode(GTK_FLOW_BOX(list), GTK_SELECTION_NONE);
    gtk_flow_box_set_max_children_per_line(GTK_FLOW_BOX(list), MOST_IN_LINE);
    gtk_flow_box_set_homogeneous(GTK_FLOW_BOX(list), TRUE);
    gtk_flow_box_set_column_spacing(GTK_FLOW_BOX(list), SPACE);
    gtk_flow_box_set_row_spacing(GTK_FLOW_BOX(list), SPACE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(list), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    return list;
}

static void app_gallery_init(AppGallery *self)
{
    GtkWidget *page = gtk_box_new(GTK_ORIENTATION_VERTICAL, SPACE);
    GtkEventController *keys = gtk_event_controller_key_new();
    self->sketcher = app_sketcher_new(show_sketch, self);
    self->pictures = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    self->cards = g_ptr_array_new();
    self->recent_title = new_title(_("Recent files"), "title-2", 1);
    self->recent = new_list(_("Recent files"));
    self->builtin = new_list(_("Built-in scenes"));
    gtk_widget_add_css_class(page, "gallery");
    gtk_box_append(GTK_BOX(page), self->recent_title);
    gtk_box_append(GTK_BOX(page), self->recent);
    gtk_box_append(GTK_BOX(page), new_title(_("Built-in scenes"), "title-2", 1));
    gtk_box_append(GTK_BOX(page), self->builtin);
    self->scrolled = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(self->scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(self->scrolled), page);
    gtk_widget_set_hexpand(self->scrolled, TRUE);
    gtk_widget_set_vexpand(self->scrolled, TRUE);
    gtk_box_append(GTK_BOX(self), self->scrolled);
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE); /* before the lists' own keys */
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key_pressed), self);
    gtk_widget_add_controller(GTK_WIDGET(self), keys);
}

GtkWidget *app_gallery_new(void)
{
    return g_object_new(APP_TYPE_GALLERY, NULL);
}

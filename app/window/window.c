/* SPDX-License-Identifier: MIT */
/*
 * The window's parts and the way between them: the document changes, a picture is asked for; the picture comes, numbers
 * are asked for; the numbers come and are shown.
 */
#include "window.h"

#include <math.h>
#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "../base/choices.h"
#include "../base/pulse.h"
#include "../base/row.h"
#include "../space/space_view.h"
#include "window_private.h"

enum { PROGRESS_MS = 150, PULSE_MS = 1000 };
static const double PATIENCE_SECONDS = 1; /* before progress is shown */

G_DEFINE_FINAL_TYPE(AppWindow, app_window, GTK_TYPE_APPLICATION_WINDOW)

/* ---- asking ---- */

/* "reflected light: 38 %, at most 40 s": it may be exact enough before all effort is spent. */
static void tell_reflected(AppWindow *self, double done, double seconds)
{
    const double left = done > 0.01 ? seconds * (1 - done) / done : 0;
    char *text = left > 0 ? g_strdup_printf(_("reflected light: %.0f %%, at most %.0f s"), 100 * done, ceil(left))
                          : g_strdup(_("reflected light: 0 %"));
    gtk_label_set_text(GTK_LABEL(self->progress_label), text);
    g_free(text);
}

static gboolean show_progress(gpointer data)
{
    AppWindow *self = data;
    double done, seconds;
    const gboolean busy = app_painter_progress(self->painter, &done, &seconds),
                   shown = busy && seconds > PATIENCE_SECONDS;
    const gboolean reflects = self->picture && self->picture->shot->moment->is_direct && !self->is_stale;
    gtk_widget_set_visible(self->progress, shown);
    gtk_widget_set_visible(self->progress_label, shown && reflects);
    gtk_widget_set_visible(self->stop_button, (shown || self->is_direct) && reflects);
    if (busy)
        gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(self->progress), done);
    if (shown && reflects)
        tell_reflected(self, done, seconds);
    if (busy || app_painter_is_busy(self->painter))
        return G_SOURCE_CONTINUE;
    self->progress_timer = 0;
    return G_SOURCE_REMOVE;
}

gboolean app_window_is_open(AppWindow *self)
{
    return self->painter != NULL;
}

/* A number for what the document, the light that alone is seen and the quantity are now. */
static void count_version(AppWindow *self)
{
    const guint64 serial = app_document_serial(self->document), origin = app_document_origin(self->document);
    if (serial == self->serial && self->solo == self->asked_solo && self->quantity == self->asked_quantity)
        return;
    self->version++;
    self->serial = serial;
    self->asked_solo = self->solo;
    self->asked_quantity = self->quantity;
    if (origin != self->origin)
        app_window_forget(self);
    self->origin = origin;
}

void app_window_ask_picture(AppWindow *self)
{
    static const AppFrame none = {.width = 0}; /* the view is not fitted to the first picture yet */
    if (!gtk_widget_get_mapped(GTK_WIDGET(self))) /* it may have another scene before it is seen */
        return;
    count_version(self);
    app_window_judge(self);
    const AppWish wish = {
        .scene = app_document_copy_scene(self->document),
        .serial = self->version,
        .solo = self->solo,
        .quantity = self->quantity,
        .is_direct = self->is_direct,
        .display = *app_display_form_get(APP_DISPLAY_FORM(self->display_form)),
        .frame = self->picture ? app_view_frame(self->view) : none,
        .side = self->side,
        .pinned = self->pinned,
    };
    if (!wish.scene) {
        app_window_show_fault(self, _("out of memory"));
        return;
    }
    app_painter_ask(self->painter, &wish);
    app_window_ask_survey(self);
    if (!self->progress_timer)
        self->progress_timer = g_timeout_add(PROGRESS_MS, show_progress, self);
}

AppShot *app_window_shot(const AppWindow *self)
{
    if (!self->picture)
        return NULL;
    return self->picture->side == APP_SIDE_PINNED ? self->picture->pinned : self->picture->shot;
}

AppShot *app_window_minus(const AppWindow *self)
{
    return self->picture && self->picture->side == APP_SIDE_DIFFERENCE ? self->picture->pinned : NULL;
}

void app_window_ask_numbers(AppWindow *self)
{
    if (!app_window_shot(self))
        return;
    const AppPage page = app_numbers_page(APP_NUMBERS(self->numbers));
    const AppDisplay *display = &self->picture->display;
    double place_mm[2];
    AppQuestion question = {
        .shot = app_window_shot(self),
        .minus = app_window_minus(self),
        .live = self->picture->shot,
        .is_placed = app_why_pinned(APP_WHY(self->why), place_mm),
        .section = page == APP_PAGE_SECTION,
        .statistics = page == APP_PAGE_STATISTICS,
        .isophotes = display->isophotes,
        .low = self->picture->low,
        .high = self->picture->high,
        .logarithmic = display->logarithmic,
    };
    memcpy(question.section_mm, self->section_mm, sizeof question.section_mm);
    if (question.is_placed)
        memcpy(question.place_mm, place_mm, sizeof question.place_mm);
    app_meter_ask(self->meter, &question);
}

void app_window_ask_pointer(AppWindow *self)
{
    if (self->pointer_inside && app_window_shot(self) && !self->is_stale)
        app_pointer_ask(self->pointer, app_window_shot(self), app_window_minus(self), self->pointer_mm[0],
                        self->pointer_mm[1]);
}

/* ---- what the parts tell ---- */

static void show_surface(AppWindow *self)
{
    const gsize count = app_document_size(self->document, "surfaces");
    guint index = gtk_drop_down_get_selected(GTK_DROP_DOWN(self->surface_list));
    GListModel *model = gtk_drop_down_get_model(GTK_DROP_DOWN(self->surface_list));
    if (g_list_model_get_n_items(model) != count) {
        GtkStringList *names = gtk_string_list_new(NULL);
        for (gsize i = 0; i < count; i++) {
            char *key = g_strdup_printf("surfaces[%zu].type", i), *type = app_document_get(self->document, key, NULL);
            char *name = g_strdup_printf("%zu  %s", i + 1, type ? app_choice_label(type) : "");
            gtk_string_list_append(names, name);
            g_free(name);
            g_free(type);
            g_free(key);
        }
        gtk_drop_down_set_model(GTK_DROP_DOWN(self->surface_list), G_LIST_MODEL(names));
        g_object_unref(names);
        index = MIN(index, count > 0 ? (guint)count - 1 : 0);
        gtk_drop_down_set_selected(GTK_DROP_DOWN(self->surface_list), index);
    }
    gtk_widget_set_visible(self->surface_list, count > 1);
    index = index == GTK_INVALID_LIST_POSITION ? 0 : index;
    char *key = g_strdup_printf("surfaces[%u].type", index), *type = app_document_get(self->document, key, NULL);
    app_form_set_element(APP_FORM(self->surface_form), index, type);
    app_form_set_element(APP_FORM(self->material_form), index, type);
    g_free(type);
    g_free(key);
}

/* The chosen sources are marked on the picture and in space; the formula is that of the one that the form shows. */
void app_window_show_chosen(AppWindow *self)
{
    const GArray *chosen = app_sources_chosen(APP_SOURCES(self->sources));
    const gsize shown = app_sources_shown(APP_SOURCES(self->sources));
    app_view_choose(self->view, chosen);
    for (int i = 0; i < APP_SIGHTS; i++)
        app_sight_choose(app_window_sight(self, i), chosen, shown);
    app_why_choose(APP_WHY(self->why), shown);
}

static void document_changed(AppWindow *self)
{
    app_form_refresh(APP_FORM(self->screen_form));
    app_form_refresh(APP_FORM(self->picture_form));
    show_surface(self);
    app_sources_refresh(APP_SOURCES(self->sources));
    app_window_show_chosen(self);
    app_points_refresh(APP_POINTS(self->points));
    app_window_update_actions(self);
    app_window_update_hint(self);
    app_window_ask_picture(self);
}

static void document_renamed(AppWindow *self)
{
    const char *name = app_document_name(self->document);
    char *title = g_strdup_printf("%s%s – Luxel", app_document_is_modified(self->document) ? "• " : "",
                                  *name ? name : _("a new scene"));
    gtk_window_set_title(GTK_WINDOW(self), title);
    app_window_update_actions(self);
    app_window_watch_file(self);
    g_free(title);
}

static void view_pointed(GtkWidget *view, double x_mm, double y_mm, gboolean inside, AppWindow *self)
{
    (void)view;
    self->pointer_mm[0] = x_mm;
    self->pointer_mm[1] = y_mm;
    self->pointer_inside = inside;
    if (!inside) {
        app_window_rest(self);
        app_dial_set_needle(APP_DIAL(self->bar), (double)NAN);
        app_sources_show_shares(APP_SOURCES(self->sources), NULL);
        app_window_show_vectors(self, NULL);
    }
    app_window_ask_pointer(self);
    app_window_judge(self);
}

static void view_selected(AppView *view, int kind, guint index, AppWindow *self)
{
    (void)view;
    if (kind == APP_MARK_SOURCE) {
        app_sources_choose(APP_SOURCES(self->sources), index);
        app_window_show_chosen(self);
    } else if (kind == APP_MARK_SURFACE) {
        gtk_drop_down_set_selected(GTK_DROP_DOWN(self->surface_list), index);
        app_window_pin_why(self, self->pointer_mm, -1);
    } else if (kind == APP_MARK_POINT) {
        const luxel_scene *scene = self->picture ? self->picture->shot->moment->scene : NULL;
        double place_mm[2];
        if (scene && luxel_scene_point(scene, index, &place_mm[0], &place_mm[1]) == LUXEL_OK)
            app_window_pin_why(self, place_mm, (gssize)index);
    }
}

/* A second click at a place of a surface asks why its value is what it is. */
static void camera_clicked(GtkGestureClick *gesture, int count, double x, double y, AppWindow *self)
{
    (void)gesture;
    (void)x;
    (void)y;
    if (count == 2 && self->pointer_inside && self->is_on_surface)
        app_window_ask_why(self, -1);
}

/* The place at which the card is kept is ringed, and the list tells what the sources give there. */
static void why_kept(AppWindow *self)
{
    double place_mm[2];
    app_view_set_kept(self->view, app_why_pinned(APP_WHY(self->why), place_mm) ? place_mm : NULL);
    app_window_ask_numbers(self);
}

/* On the picture or in space. */
static void source_toggled(GtkWidget *where, guint index, AppWindow *self)
{
    (void)where;
    app_sources_toggle(APP_SOURCES(self->sources), index);
}

static void view_hovered(AppView *view, int kind, guint index, AppWindow *self)
{
    (void)view;
    app_window_hover_light(self, kind == APP_MARK_SOURCE ? (gssize)index : -1);
}

static void list_hovered(AppSources *sources, int index, AppWindow *self)
{
    (void)sources;
    app_view_hover(self->view, index < 0 ? APP_MARK_NONE : APP_MARK_SOURCE, index < 0 ? 0 : (gsize)index);
    app_window_hover_light(self, index);
}

static void section_moved(AppView *view, double x_mm, double y_mm, AppWindow *self)
{
    self->section_mm[0] = x_mm;
    self->section_mm[1] = y_mm;
    app_view_set_section(view, TRUE, self->section_mm);
    app_window_ask_numbers(self);
}

static void section_read(AppNumbers *numbers, double x_mm, double y_mm, gboolean inside, AppWindow *self)
{
    const double place[2] = {x_mm, y_mm};
    (void)numbers;
    app_view_set_read(self->view, inside ? place : NULL);
}

static void page_turned(AppWindow *self)
{
    app_view_set_section(self->view, app_numbers_page(APP_NUMBERS(self->numbers)) == APP_PAGE_SECTION,
                         self->section_mm);
    app_window_ask_numbers(self);
    app_window_ask_survey(self);
    app_window_judge(self);
}

static void source_chosen(AppSources *sources, guint index, AppWindow *self)
{
    (void)sources;
    app_view_select(self->view, APP_MARK_SOURCE, index);
    app_window_show_chosen(self);
}

static void solo_changed(AppSources *sources, int index, AppWindow *self)
{
    (void)sources;
    self->solo = index;
    app_window_say(self, index < 0 ? "" : _("One source alone is shown; what is saved has them all"));
    app_window_ask_picture(self);
}

static void display_changed(AppWindow *self)
{
    const AppDisplay *display = app_display_form_get(APP_DISPLAY_FORM(self->display_form));
    const gboolean is_new = strcmp(display->palette, "grey") != 0 && display->palette != self->false_palette;
    if (is_new)
        self->false_palette = display->palette;
    if (is_new && self->settings)
        g_settings_set_string(self->settings, "palette", self->false_palette);
    app_window_update_actions(self);
    app_window_ask_picture(self);
}

static gboolean show_pulse(gpointer data)
{
    AppWindow *self = data;
    char *text = app_pulse_recent();
    app_window_say(self, text);
    g_free(text);
    return G_SOURCE_CONTINUE;
}

/* Between press and release of a button, wherever it is, all is one step of undo. */
static gboolean legacy_event(GtkEventControllerLegacy *controller, GdkEvent *event, AppWindow *self)
{
    (void)controller;
    const GdkEventType type = gdk_event_get_event_type(event);
    const gboolean pressed = type == GDK_BUTTON_PRESS || type == GDK_TOUCH_BEGIN;
    const gboolean released = type == GDK_BUTTON_RELEASE || type == GDK_TOUCH_END || type == GDK_TOUCH_CANCEL;
    /* a release may be missed, when a menu takes it */
    if ((pressed || released) && self->is_pressed)
        app_document_end_gesture(self->document);
    if (pressed)
        app_document_begin_gesture(self->document);
    self->is_pressed = pressed || (self->is_pressed && !released);
    return GDK_EVENT_PROPAGATE;
}

static void close_faults(AppWindow *self)
{
    app_window_show_fault(self, NULL);
}

/* The wheel over a control that is not being used moves the panel, not the value. */
static gboolean panel_scrolled(GtkEventControllerScroll *controller, double dx, double dy, AppWindow *self)
{
    GtkAdjustment *adjustment = gtk_scrolled_window_get_vadjustment(GTK_SCROLLED_WINDOW(self->left_scroll));
    (void)controller;
    (void)dx;
    gtk_adjustment_set_value(adjustment, gtk_adjustment_get_value(adjustment) + dy * 60);
    return TRUE;
}

/* ---- making it ---- */

static GtkWidget *new_surface_list(AppWindow *self)
{
    self->surface_list = gtk_drop_down_new_from_strings((const char *const[]){NULL});
    app_name_control(self->surface_list, _("Surface"));
    g_signal_connect_swapped(self->surface_list, "notify::selected", G_CALLBACK(show_surface), self);
    return self->surface_list;
}

static void make_left(AppWindow *self)
{
    static const char *const screen[] = {"units", "shadows", "screen.", "observer.", NULL};
    static const char *const surface[] = {"surfaces[].", NULL}, *const picture[] = {"picture.", NULL};
    static const char *const material[] = {"surfaces[].material.", NULL};
    self->screen_form = app_form_new(self->document, self->parameters, screen, NULL);
    self->surface_form = app_form_new(self->document, self->parameters, surface, material[0]);
    self->material_form = app_form_new(self->document, self->parameters, material, NULL);
    self->picture_form = app_form_new(self->document, self->parameters, picture, NULL);
    self->sources = app_sources_new(self->document, self->parameters);
    self->points = app_points_new(self->document);
    self->display_form = app_display_form_new();
    app_window_add_search(self);
    app_window_add_section(self, "sources", _("Sources"), self->sources, NULL, NULL);
    app_window_add_section(self, "surfaces", _("Surfaces"), app_window_new_surface_bar(self), new_surface_list(self),
                           self->surface_form);
    app_window_add_section(self, "material", _("Material"), self->material_form, NULL, NULL);
    app_window_add_section(self, "screen", _("Screen and observer"), self->screen_form, NULL, NULL);
    app_window_add_section(self, "points", _("Points"), self->points, NULL, NULL);
    app_window_add_section(self, "picture", _("Picture"), self->picture_form,
                           gtk_separator_new(GTK_ORIENTATION_HORIZONTAL), self->display_form);
}

static void connect_parts(AppWindow *self)
{
    GtkEventController *buttons = gtk_event_controller_legacy_new();
    GtkEventController *wheel = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);
    GtkGesture *click = gtk_gesture_click_new();
    gtk_event_controller_set_propagation_phase(buttons, GTK_PHASE_CAPTURE);
    gtk_event_controller_set_propagation_phase(wheel, GTK_PHASE_CAPTURE);
    g_signal_connect(buttons, "event", G_CALLBACK(legacy_event), self);
    g_signal_connect(wheel, "scroll", G_CALLBACK(panel_scrolled), self);
    gtk_widget_add_controller(GTK_WIDGET(self), buttons);
    gtk_widget_add_controller(self->left_box, wheel);
    g_signal_connect_object(self->document, "changed", G_CALLBACK(document_changed), self, G_CONNECT_SWAPPED);
    g_signal_connect_object(self->document, "renamed", G_CALLBACK(document_renamed), self, G_CONNECT_SWAPPED);
    g_signal_connect(self->view, "pointed", G_CALLBACK(view_pointed), self);
    g_signal_connect(self->view, "selected", G_CALLBACK(view_selected), self);
    g_signal_connect(self->view, "toggled", G_CALLBACK(source_toggled), self);
    g_signal_connect(self->view, "hovered", G_CALLBACK(view_hovered), self);
    g_signal_connect(self->sources, "hovered", G_CALLBACK(list_hovered), self);
    g_signal_connect(self->space_view, "pointed", G_CALLBACK(view_pointed), self);
    app_window_connect_spaces(self);
    g_signal_connect(self->view, "section-moved", G_CALLBACK(section_moved), self);
    g_signal_connect_swapped(self->view, "framed", G_CALLBACK(app_window_ask_picture), self);
    g_signal_connect(self->sources, "chosen", G_CALLBACK(source_chosen), self);
    g_signal_connect(self->sources, "solo", G_CALLBACK(solo_changed), self);
    g_signal_connect_swapped(self->display_form, "changed", G_CALLBACK(display_changed), self);
    g_signal_connect(self->numbers, "read", G_CALLBACK(section_read), self);
    g_signal_connect_swapped(self->numbers, "wanted", G_CALLBACK(page_turned), self);
    g_signal_connect_swapped(self->fault_bar, "response", G_CALLBACK(close_faults), self);
    g_signal_connect_swapped(self->why, "kept", G_CALLBACK(why_kept), self);
    g_signal_connect(click, "pressed", G_CALLBACK(camera_clicked), self);
    gtk_widget_add_controller(self->cameras, GTK_EVENT_CONTROLLER(click));
    app_dial_set_form(APP_DIAL(self->bar), APP_DISPLAY_FORM(self->display_form));
}

/* Sizes and choices of the last time. */
static void bind_settings(AppWindow *self)
{
    GSettings *settings = app_application_settings(APP_APPLICATION(gtk_window_get_application(GTK_WINDOW(self))));
    if (!settings)
        return;
    self->settings = g_object_ref(settings);
    g_settings_bind(settings, "window-width", self, "default-width", G_SETTINGS_BIND_DEFAULT);
    g_settings_bind(settings, "window-height", self, "default-height", G_SETTINGS_BIND_DEFAULT);
    g_settings_bind(settings, "window-maximized", self, "maximized", G_SETTINGS_BIND_DEFAULT);
    char *palette = g_settings_get_string(settings, "palette");
    const char *known = app_palette_named(palette);
    if (known && strcmp(known, "grey") != 0)
        self->false_palette = known;
    g_free(palette);
}

AppWindow *app_window_new(AppApplication *application)
{
    AppWindow *self = g_object_new(APP_TYPE_WINDOW, "application", application, NULL);
    bind_settings(self);
    app_window_watch_panes(self);
    app_window_open_sections(self);
    app_window_init_report(self);
    app_window_fill_menus(self);
    app_window_begin_hint(self);
    document_renamed(self);
    g_signal_connect(self, "map", G_CALLBACK(app_window_ask_picture), NULL);
    app_view_select(self->view, APP_MARK_SOURCE, 0);
    app_window_show_chosen(self);
    app_pulse_watch(GTK_WIDGET(self));
    self->pulse_timer = app_pulse_is_on() ? g_timeout_add(PULSE_MS, show_pulse, self) : 0;
    gtk_widget_grab_focus(GTK_WIDGET(self->view));
    return self;
}

gboolean app_window_is_fresh(AppWindow *self)
{
    return !app_document_is_modified(self->document) && !app_document_path(self->document) &&
           !app_history_can_redo(app_document_history(self->document));
}

static void app_window_dispose(GObject *object)
{
    AppWindow *self = APP_WINDOW(object);
    g_clear_handle_id(&self->progress_timer, g_source_remove);
    g_clear_handle_id(&self->pulse_timer, g_source_remove);
    g_clear_handle_id(&self->say_timer, g_source_remove);
    g_clear_handle_id(&self->late_timer, g_source_remove);
    app_window_end_watch(self);
    for (int i = 0; i < APP_STATUS_KINDS; i++)
        g_clear_pointer(&self->status_tabs[i], pango_tab_array_free);
    g_clear_pointer(&self->painter, app_painter_free);
    g_clear_pointer(&self->meter, app_meter_free);
    g_clear_pointer(&self->pointer, app_pointer_free);
    g_clear_pointer(&self->survey, app_survey_free);
    g_clear_pointer(&self->recovery, app_recovery_free);
    g_clear_pointer(&self->picture, app_picture_unref);
    g_clear_pointer(&self->pinned, app_shot_unref);
    g_clear_pointer(&self->unsaved, g_ptr_array_unref);
    g_clear_pointer(&self->repair, g_ptr_array_unref);
    g_clear_pointer(&self->report, g_hash_table_unref);
    g_clear_object(&self->settings);
    g_clear_pointer(&self->found, gtk_widget_unparent);
    gtk_widget_dispose_template(GTK_WIDGET(self), APP_TYPE_WINDOW);
    G_OBJECT_CLASS(app_window_parent_class)->dispose(object);
}

static void app_window_finalize(GObject *object)
{
    g_clear_object(&APP_WINDOW(object)->document);
    luxel_parameters_free(APP_WINDOW(object)->parameters);
    G_OBJECT_CLASS(app_window_parent_class)->finalize(object);
}

static void app_window_class_init(AppWindowClass *class)
{
    GtkWidgetClass *widget = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = app_window_dispose;
    G_OBJECT_CLASS(class)->finalize = app_window_finalize;
    g_type_ensure(APP_TYPE_VIEW);
    g_type_ensure(APP_TYPE_DIAL);
    gtk_widget_class_set_template_from_resource(widget, "/org/luxel/Luxel/window.ui");
#define BIND(name) gtk_widget_class_bind_template_child(widget, AppWindow, name)
    BIND(view);
    BIND(cameras);
    BIND(pages);
    BIND(left_pane);
    BIND(right_pane);
    BIND(left_scroll);
    BIND(left_box);
    BIND(right_box);
    BIND(view_overlay);
    BIND(compare_box);
    BIND(compare_label);
    BIND(bar);
    BIND(unsaved_bar);
    BIND(unsaved_label);
    BIND(discard_button);
    BIND(fault_bar);
    BIND(fault_label);
    BIND(outside_bar);
    BIND(outside_label);
    BIND(direct_label);
    BIND(stale_bar);
    BIND(stale_label);
    BIND(repair_button);
    BIND(repair_label);
    BIND(status_label);
    BIND(message_label);
    BIND(zoom_label);
    BIND(progress);
    BIND(progress_label);
    BIND(stop_button);
    BIND(builtin_menu);
    BIND(recent_menu);
    BIND(export_menu);
#undef BIND
}

static void make_space(AppWindow *self)
{
    self->stage = app_stage_new(self->document);
    app_window_add_space(self);
    self->why = app_why_new();
    gtk_overlay_add_overlay(GTK_OVERLAY(self->view_overlay), self->why);
    self->numbers = app_numbers_new(self->document, self->stage);
}

static void app_window_init(AppWindow *self)
{
    gtk_widget_init_template(GTK_WIDGET(self));
    self->solo = -1;
    self->false_palette = app_palette_named("viridis");
    self->document = app_document_new();
    self->parameters = luxel_parameters_new_translated(language_translate, NULL);
    self->recovery = app_recovery_new(self->document);
    self->painter = app_painter_new(app_window_show_picture, self);
    self->meter = app_meter_new(app_window_show_numbers, self);
    self->pointer = app_pointer_new(app_window_show_reading, self);
    self->survey = app_survey_new(app_window_show_survey, self);
    app_view_set_document(self->view, self->document);
    app_window_set_columns(self);
    make_left(self);
    make_space(self);
    gtk_box_append(GTK_BOX(self->right_box), self->numbers);
    connect_parts(self);
    show_surface(self);
    app_window_add_actions(self);
    app_window_add_file_actions(self);
    app_window_add_outside_actions(self);
    app_window_add_chosen_actions(self);
    app_window_add_room_action(self);
    app_window_add_surface_actions(self);
    app_window_add_focus_actions(self);
    app_window_add_begin_actions(self);
    app_window_update_actions(self);
}

/* SPDX-License-Identifier: MIT */
/*
 * The window's parts and the way between them: the document changes, a picture is asked for; the picture comes, numbers
 * are asked for; the numbers come and are shown.
 */
#include "window.h"

#include <luxel/drawing.h>
#include <math.h>
#include <string.h>

#include "../front/language.h"
#include "../front/words.h"
#include "export.h"
#include "number.h"
#include "pulse.h"
#include "row.h"
#include "window_private.h"

enum { PROGRESS_MS = 150, PULSE_MS = 1000, DIGITS = 6, RIGHT_WIDTH = 350, LEAST_CENTER = 300 };
static const double PATIENCE_SECONDS = 1; /* before progress is shown */

G_DEFINE_FINAL_TYPE(AppWindow, app_window, GTK_TYPE_APPLICATION_WINDOW)

/* ---- asking ---- */

static gboolean show_progress(gpointer data)
{
    AppWindow *self = data;
    double done, seconds;
    gboolean busy = app_painter_progress(self->painter, &done, &seconds);
    gtk_widget_set_visible(self->progress, busy && seconds > PATIENCE_SECONDS);
    if (busy)
        gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(self->progress), done);
    if (busy || app_painter_is_busy(self->painter))
        return G_SOURCE_CONTINUE;
    self->progress_timer = 0;
    return G_SOURCE_REMOVE;
}

void app_window_ask_picture(AppWindow *self)
{
    const AppWish wish = {
        .scene = app_document_copy_scene(self->document),
        .serial = app_document_serial(self->document),
        .solo = self->solo,
        .quantity = self->quantity,
        .display = *app_display_form_get(APP_DISPLAY_FORM(self->display_form)),
        .frame = app_view_frame(self->view),
        .side = self->side,
        .pinned = self->pinned,
    };
    if (!wish.scene) {
        app_window_show_fault(self, _("memory ran out"));
        return;
    }
    app_painter_ask(self->painter, &wish);
    if (!self->progress_timer)
        self->progress_timer = g_timeout_add(PROGRESS_MS, show_progress, self);
}

void app_window_ask_numbers(AppWindow *self)
{
    if (!self->picture || !self->picture->shot)
        return;
    const AppPage page = app_numbers_page(APP_NUMBERS(self->numbers));
    const AppDisplay *display = &self->picture->display;
    AppQuestion question = {
        .shot = self->picture->shot,
        .section = page == APP_PAGE_SECTION,
        .statistics = page == APP_PAGE_STATISTICS,
        .isophotes = display->isophotes,
        .low = self->picture->low,
        .high = self->picture->high,
        .logarithmic = display->logarithmic,
    };
    memcpy(question.section_mm, self->section_mm, sizeof question.section_mm);
    app_meter_ask(self->meter, &question);
}

static void ask_pointer(AppWindow *self)
{
    if (self->pointer_inside && self->picture && self->picture->shot)
        app_pointer_ask(self->pointer, self->picture->shot, self->pointer_mm[0], self->pointer_mm[1]);
}

/* ---- saying ---- */

void app_window_say(AppWindow *self, const char *text)
{
    gtk_label_set_text(GTK_LABEL(self->message_label), text);
}

void app_window_show_fault(AppWindow *self, const char *text)
{
    if (text)
        gtk_label_set_text(GTK_LABEL(self->fault_label), text);
    gtk_info_bar_set_revealed(GTK_INFO_BAR(self->fault_bar), text != NULL);
}

static gboolean is_photometric(AppWindow *self)
{
    char *units = app_document_get(self->document, "units", NULL);
    const gboolean photometric = g_strcmp0(units, "photometric") == 0;
    g_free(units);
    return photometric;
}

/* Marks the rows that the faults name, in whichever form they stand. */
static void mark_faults(AppWindow *self, const luxel_diagnostics *faults)
{
    AppForm *forms[] = {APP_FORM(self->screen_form), APP_FORM(self->surface_form), APP_FORM(self->material_form),
                        APP_FORM(self->picture_form)};
    for (gsize i = 0; i < G_N_ELEMENTS(forms); i++)
        app_form_set_fault(forms[i], NULL, NULL);
    app_sources_set_fault(APP_SOURCES(self->sources), NULL, NULL);
    for (gsize i = 0; faults && i < luxel_diagnostics_count(faults); i++) {
        const char *key = luxel_diagnostics_get(faults, i)->key;
        char *reason = luxel_diagnostics_message(faults, i, language_translate, NULL);
        for (gsize k = 0; k < G_N_ELEMENTS(forms) && key; k++)
            app_form_set_fault(forms[k], key, reason);
        if (key)
            app_sources_set_fault(APP_SOURCES(self->sources), key, reason);
        luxel_text_free(reason);
    }
}

/* ---- pictures ---- */

static void show_comparison(AppWindow *self, const AppPicture *picture)
{
    char *text = NULL;
    gtk_widget_set_visible(self->compare_box, self->pinned != NULL);
    if (!self->pinned)
        return;
    if (picture->has_comparison) {
        const luxel_comparison *comparison = &picture->comparison;
        char difference[APP_NUMBER_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE], share[APP_NUMBER_SIZE];
        text = g_strdup_printf(_("largest difference %s (%s %% of the maximum) at x = %s, y = %s mm"),
                               app_number_round(comparison->largest.value, DIGITS, difference),
                               app_number_round(100 * comparison->largest_relative, 3, share),
                               app_number_round(comparison->largest.x_mm, DIGITS, x),
                               app_number_round(comparison->largest.y_mm, DIGITS, y));
    } else if (picture->shot->is_fine)
        text = g_strdup(_("A and B differ in their screens and cannot be compared"));
    if (text)
        gtk_label_set_text(GTK_LABEL(self->compare_label), text);
    g_free(text);
}

static void show_picture(AppPicture *picture, gpointer owner)
{
    AppWindow *self = owner;
    if (picture->faults) {
        char *text = app_faults_text(picture->faults);
        mark_faults(self, picture->faults);
        app_window_show_fault(self, text);
        g_free(text);
        return;
    }
    if (gtk_info_bar_get_revealed(GTK_INFO_BAR(self->fault_bar))) {
        mark_faults(self, NULL);
        app_window_show_fault(self, NULL);
    }
    app_picture_ref(picture);
    app_picture_unref(self->picture);
    self->picture = picture;
    app_view_set_picture(self->view, picture);
    app_display_form_tell_range(APP_DISPLAY_FORM(self->display_form), picture->low, picture->high);
    app_numbers_set_colors(APP_NUMBERS(self->numbers), picture->display.palette, picture->low, picture->high,
                           picture->display.logarithmic);
    gtk_widget_queue_draw(self->bar);
    show_comparison(self, picture);
    app_window_ask_numbers(self);
    ask_pointer(self);
    app_pulse_picture();
}

static void draw_bar(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    AppWindow *self = data;
    const AppPicture *picture = self->picture;
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    luxel_drawing_style style;
    GdkRGBA ink;
    if (!picture || width < 60)
        return;
    gtk_style_context_get_color(gtk_widget_get_style_context(GTK_WIDGET(area)), &ink);
    luxel_drawing_style_init(&style, ink.red + ink.green + ink.blue > 1.5f);
    style.letters = 11;
    style.language = &language;
    const double gain = exp2(picture->display.exposure);
    char *label = g_strdup_printf("%s, %s", self->quantity == LUXEL_IRRADIANCE ? _("irradiance") : _("brightness"),
                                  gettext(luxel_field_unit(picture->shot->field)));
    const luxel_bar bar = {.palette = picture->display.palette,
                           .low = picture->low / gain,
                           .high = picture->high / gain,
                           .logarithmic = picture->display.logarithmic,
                           .label = label};
    cairo_translate(cairo, 16, 4);
    luxel_draw_bar(cairo, &style, &bar, width - 32, height - 4);
    g_free(label);
}

/* ---- numbers ---- */

static void show_numbers(AppMeasures *measures, gpointer owner)
{
    AppWindow *self = owner;
    app_numbers_show(APP_NUMBERS(self->numbers), measures);
    if (measures->has_points)
        app_sources_show(APP_SOURCES(self->sources), measures, is_photometric(self));
    if (measures->has_isophotes)
        app_view_set_isophotes(self->view, g_steal_pointer(&measures->isophotes));
}

/* "1 12.3 · 2 0.5": what the lights give, the greatest first so far as there is room. */
static void add_shares(GString *text, const AppReading *reading)
{
    char number[APP_NUMBER_SIZE];
    for (gsize i = 0; i < reading->share_count && i < 6; i++)
        g_string_append_printf(text, "%s%zu: %s", i ? ", " : "", i + 1,
                               app_number_round(reading->shares[i], 4, number));
    if (reading->share_count > 6)
        g_string_append(text, ", …");
}

static void show_reading(const AppReading *reading, gpointer owner)
{
    AppWindow *self = owner;
    const luxel_value *value = &reading->value;
    char n[8][APP_NUMBER_SIZE];
    GString *text = g_string_new(NULL);
    if (!self->pointer_inside) {
        g_string_free(text, TRUE);
        return;
    }
    app_view_set_surface(self->view, value->on_surface ? (gssize)value->surface : -1);
    g_string_append_printf(text, "x %s  y %s mm", app_number_round(reading->x_mm, 5, n[0]),
                           app_number_round(reading->y_mm, 5, n[1]));
    if (!value->on_surface)
        g_string_append_printf(text, "   %s", _("off the surface"));
    else {
        for (int i = 0; i < 3; i++) {
            app_number_round(value->position_mm[i], 6, n[i]);
            app_number_round(value->normal[i], 3, n[3 + i]);
        }
        g_string_append_printf(text, "   P (%s, %s, %s)   N (%s, %s, %s)   ", n[0], n[1], n[2], n[3], n[4], n[5]);
        if (value->has_value)
            g_string_append_printf(text, "%s %s", app_number_round(value->value, DIGITS, n[6]),
                                   gettext(luxel_scene_unit(reading->moment->scene, self->quantity)));
        else
            g_string_append(text, _("a source lies here"));
        if (reading->has_pixel)
            g_string_append_printf(text, "   %s %u", _("grey"), reading->grey);
        if (reading->share_count > 1 && value->has_value) {
            g_string_append_printf(text, "   %s ", _("sources"));
            add_shares(text, reading);
        }
    }
    gtk_label_set_text(GTK_LABEL(self->status_label), text->str);
    g_string_free(text, TRUE);
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
            char *name = g_strdup_printf("%zu  %s", i + 1, type ? type : "");
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

static void document_changed(AppWindow *self)
{
    app_form_refresh(APP_FORM(self->screen_form));
    app_form_refresh(APP_FORM(self->picture_form));
    show_surface(self);
    app_sources_refresh(APP_SOURCES(self->sources));
    app_points_refresh(APP_POINTS(self->points));
    app_window_update_actions(self);
    app_window_ask_picture(self);
}

static void document_renamed(AppWindow *self)
{
    char *title = g_strdup_printf("%s%s – Luxel", app_document_is_modified(self->document) ? "• " : "",
                                  app_document_name(self->document));
    gtk_window_set_title(GTK_WINDOW(self), title);
    app_window_update_actions(self);
    g_free(title);
}

static void view_pointed(AppView *view, double x_mm, double y_mm, gboolean inside, AppWindow *self)
{
    (void)view;
    self->pointer_mm[0] = x_mm;
    self->pointer_mm[1] = y_mm;
    self->pointer_inside = inside;
    if (!inside)
        gtk_label_set_text(GTK_LABEL(self->status_label), "");
    ask_pointer(self);
}

static void view_selected(AppView *view, int kind, guint index, AppWindow *self)
{
    (void)view;
    if (kind == APP_MARK_SOURCE)
        app_sources_choose(APP_SOURCES(self->sources), index);
    else if (kind == APP_MARK_SURFACE)
        gtk_drop_down_set_selected(GTK_DROP_DOWN(self->surface_list), index);
}

static void section_moved(AppView *view, double x_mm, double y_mm, AppWindow *self)
{
    self->section_mm[0] = x_mm;
    self->section_mm[1] = y_mm;
    app_view_set_section(view, TRUE, self->section_mm);
    app_window_ask_numbers(self);
}

static void page_turned(AppWindow *self)
{
    app_view_set_section(self->view, app_numbers_page(APP_NUMBERS(self->numbers)) == APP_PAGE_SECTION,
                         self->section_mm);
    app_window_ask_numbers(self);
}

static void source_chosen(AppSources *sources, guint index, AppWindow *self)
{
    (void)sources;
    app_view_select(self->view, APP_MARK_SOURCE, index);
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
    if (strcmp(display->palette, "grey") != 0)
        self->false_palette = display->palette;
    if (self->settings)
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

static void keep_right(AppWindow *self)
{
    const int width = gtk_widget_get_width(self->right_box);
    if (self->settings && width > 0)
        g_settings_set_int(self->settings, "right-width", width);
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

static void add_group(AppWindow *self, const char *title, gboolean expanded, GtkWidget *first, GtkWidget *second,
                      GtkWidget *third)
{
    GtkWidget *expander = gtk_expander_new(title), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    GtkWidget *const children[] = {first, second, third};
    for (gsize i = 0; i < G_N_ELEMENTS(children); i++)
        if (children[i])
            gtk_box_append(GTK_BOX(box), children[i]);
    gtk_expander_set_child(GTK_EXPANDER(expander), box);
    gtk_expander_set_expanded(GTK_EXPANDER(expander), expanded);
    gtk_box_append(GTK_BOX(self->left_box), expander);
}

static GtkWidget *new_surface_list(AppWindow *self)
{
    self->surface_list = gtk_drop_down_new_from_strings((const char *const[]){NULL});
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->surface_list), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Surface"), -1);
    g_signal_connect_swapped(self->surface_list, "notify::selected", G_CALLBACK(show_surface), self);
    return self->surface_list;
}

static void make_left(AppWindow *self)
{
    static const char *const screen[] = {"units", "shadows", "screen.", "observer.", NULL};
    static const char *const surface[] = {"surfaces[].", NULL}, *const picture[] = {"picture.", NULL};
    static const char *const material[] = {"surfaces[].material.", NULL};
    self->screen_form = app_form_new(self->document, self->tables, screen, NULL);
    self->surface_form = app_form_new(self->document, self->tables, surface, material[0]);
    self->material_form = app_form_new(self->document, self->tables, material, NULL);
    self->picture_form = app_form_new(self->document, self->tables, picture, NULL);
    self->sources = app_sources_new(self->document, self->tables);
    self->points = app_points_new(self->document);
    self->display_form = app_display_form_new();
    add_group(self, _("Sources"), TRUE, self->sources, NULL, NULL);
    add_group(self, _("Material"), TRUE, self->material_form, NULL, NULL);
    add_group(self, _("Surfaces"), TRUE, new_surface_list(self), self->surface_form, NULL);
    add_group(self, _("Screen and observer"), FALSE, self->screen_form, NULL, NULL);
    add_group(self, _("Points"), FALSE, self->points, NULL, NULL);
    add_group(self, _("Picture"), FALSE, self->picture_form, gtk_separator_new(GTK_ORIENTATION_HORIZONTAL),
              self->display_form);
}

static void connect_parts(AppWindow *self)
{
    GtkEventController *buttons = gtk_event_controller_legacy_new();
    GtkEventController *wheel = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);
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
    g_signal_connect(self->view, "section-moved", G_CALLBACK(section_moved), self);
    g_signal_connect_swapped(self->view, "framed", G_CALLBACK(app_window_ask_picture), self);
    g_signal_connect(self->sources, "chosen", G_CALLBACK(source_chosen), self);
    g_signal_connect(self->sources, "solo", G_CALLBACK(solo_changed), self);
    g_signal_connect_swapped(self->display_form, "changed", G_CALLBACK(display_changed), self);
    g_signal_connect_swapped(self->numbers, "wanted", G_CALLBACK(page_turned), self);
    g_signal_connect_swapped(self->right_box, "unmap", G_CALLBACK(keep_right), self);
    g_signal_connect_swapped(self->fault_bar, "response", G_CALLBACK(close_faults), self);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(self->bar), draw_bar, self, NULL);
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
    g_settings_bind(settings, "left-width", self->left_pane, "position", G_SETTINGS_BIND_DEFAULT);
    g_settings_bind(settings, "right-shown", self->right_box, "visible", G_SETTINGS_BIND_DEFAULT);
    char *palette = g_settings_get_string(settings, "palette");
    const char *known = app_palette_named(palette);
    if (known && strcmp(known, "grey") != 0)
        self->false_palette = known;
    g_free(palette);
}

/* A pane counts from the left, the right side's width from the right. */
static void place_right(AppWindow *self)
{
    int width, right = self->settings ? g_settings_get_int(self->settings, "right-width") : RIGHT_WIDTH;
    gtk_window_get_default_size(GTK_WINDOW(self), &width, NULL);
    gtk_paned_set_position(GTK_PANED(self->right_pane),
                           MAX(width - gtk_paned_get_position(GTK_PANED(self->left_pane)) - right, LEAST_CENTER));
}

AppWindow *app_window_new(AppApplication *application)
{
    AppWindow *self = g_object_new(APP_TYPE_WINDOW, "application", application, NULL);
    bind_settings(self);
    place_right(self);
    app_window_fill_menus(self);
    document_renamed(self);
    app_window_ask_picture(self);
    app_view_select(self->view, APP_MARK_SOURCE, 0);
    if (app_pulse_is_on())
        self->pulse_timer = g_timeout_add(PULSE_MS, show_pulse, self);
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
    g_clear_pointer(&self->painter, app_painter_free);
    g_clear_pointer(&self->meter, app_meter_free);
    g_clear_pointer(&self->pointer, app_pointer_free);
    g_clear_pointer(&self->recovery, app_recovery_free);
    g_clear_pointer(&self->picture, app_picture_unref);
    g_clear_pointer(&self->pinned, app_shot_unref);
    g_clear_pointer(&self->unsaved, g_ptr_array_unref);
    g_clear_object(&self->settings);
    gtk_widget_dispose_template(GTK_WIDGET(self), APP_TYPE_WINDOW);
    G_OBJECT_CLASS(app_window_parent_class)->dispose(object);
}

static void app_window_finalize(GObject *object)
{
    AppWindow *self = APP_WINDOW(object);
    g_clear_object(&self->document);
    app_tables_free(self->tables);
    G_OBJECT_CLASS(app_window_parent_class)->finalize(object);
}

static void app_window_class_init(AppWindowClass *class)
{
    GtkWidgetClass *widget = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = app_window_dispose;
    G_OBJECT_CLASS(class)->finalize = app_window_finalize;
    g_type_ensure(APP_TYPE_VIEW);
    gtk_widget_class_set_template_from_resource(widget, "/org/luxel/Luxel/window.ui");
#define BIND(name) gtk_widget_class_bind_template_child(widget, AppWindow, name)
    BIND(view);
    BIND(left_pane);
    BIND(right_pane);
    BIND(left_scroll);
    BIND(left_box);
    BIND(right_box);
    BIND(compare_box);
    BIND(compare_label);
    BIND(bar);
    BIND(unsaved_bar);
    BIND(unsaved_label);
    BIND(fault_bar);
    BIND(fault_label);
    BIND(status_label);
    BIND(message_label);
    BIND(progress);
    BIND(builtin_menu);
    BIND(recent_menu);
    BIND(export_menu);
#undef BIND
}

static void app_window_init(AppWindow *self)
{
    gtk_widget_init_template(GTK_WIDGET(self));
    self->solo = -1;
    self->false_palette = app_palette_named("viridis");
    self->document = app_document_new();
    self->tables = app_tables_new();
    self->recovery = app_recovery_new(self->document);
    self->painter = app_painter_new(show_picture, self);
    self->meter = app_meter_new(show_numbers, self);
    self->pointer = app_pointer_new(show_reading, self);
    app_view_set_document(self->view, self->document);
    make_left(self);
    self->numbers = app_numbers_new(self->document);
    gtk_box_append(GTK_BOX(self->right_box), self->numbers);
    connect_parts(self);
    show_surface(self);
    app_window_add_actions(self);
    app_window_add_file_actions(self);
    app_window_update_actions(self);
}

/* SPDX-License-Identifier: MIT */
/*
 * The bar, its two ends and the needle lie over each other, so that a needle that moves has nothing else drawn anew.
 * The ends are widgets of their own, large enough for a finger; what is seen of them is drawn with the bar.
 */
#include "dial.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/letters.h"
#include "../base/number.h"
#include "../base/row.h"
#include "../base/touch.h"

enum {
    INSET = 22, /* of the bar at both ends: half a finger */
    ABOVE = 17, /* the room for the isophotes' values */
    BAR = 16,
    BELOW = 37, /* where the numbers begin */
    HEIGHT = 64,
    LEAST_WIDTH = 150,
    LETTERS = 11,
    TICK = 4,
    GAP = 5,
    GRIP = 4, /* half the width of an end */
    POINT = 7,
    DIGITS = 4,
    MOST_LEVELS = 64
};
static const double PIXELS_OF_A_STOP = 45, PIXELS_OF_A_TICK = 60, MOST_STOPS = 40, STOP_GRAIN = 4, KEY_PART = 0.05,
                    SHIFT_PART = 0.2;

typedef enum End { END_LOW, END_HIGH, ENDS, NO_END = ENDS } End;

struct _AppDial {
    GtkBox parent;
    AppDisplayForm *form;
    AppPicture *picture;
    GtkWidget *area, *needle, *ends[ENDS], *lock, *logarithmic, *stops;
    double levels[MOST_LEVELS];
    gsize level_count;
    double value;      /* at the needle; NaN: none */
    AppRange start;    /* as it was when a drag began */
    double exposure;   /* then */
    End dragged;       /* or NO_END */
    double dragged_by; /* pixels */
    gboolean is_told;  /* the buttons are being set, not pressed */
};

G_DEFINE_FINAL_TYPE(AppDial, app_dial, GTK_TYPE_BOX)

/* ---- the range ---- */

static const luxel_field *field_of(const AppDial *self)
{
    const AppPicture *picture = self->picture;
    return (picture->side == APP_SIDE_PINNED ? picture->pinned : picture->shot)->field;
}

/* As it is seen: what exposure makes brighter has its colours at smaller values. */
static AppRange shown_range(const AppDial *self)
{
    const double gain = exp2(self->picture->display.exposure);
    return (AppRange){self->picture->low / gain, self->picture->high / gain, self->picture->display.logarithmic};
}

/* As the form has it, which the picture follows. */
static AppRange wanted_range(const AppDial *self)
{
    AppDisplay display = *app_display_form_get(self->form);
    const double gain = exp2(display.exposure);
    AppRange range = {.logarithmic = display.logarithmic};
    display.channel = self->picture->display.channel;
    app_display_range(&display, field_of(self), &range.low, &range.high);
    range.low /= gain;
    range.high /= gain;
    return range;
}

static double length_of(const AppDial *self)
{
    return MAX(gtk_widget_get_width(self->area) - 2 * INSET, 1);
}

/* Differences have a range of their own, which nobody sets. */
static gboolean can_turn(const AppDial *self)
{
    return self->form && self->picture && self->picture->side != APP_SIDE_DIFFERENCE;
}

static void move_end(AppDial *self, End end, AppRange from, double part)
{
    AppDisplay display = *app_display_form_get(self->form);
    const double gain = exp2(display.exposure);
    const AppRange moved = app_range_move(&from, end == END_HIGH, part);
    display.is_locked = TRUE;
    display.low = moved.low * gain;
    display.high = moved.high * gain;
    app_display_form_set(self->form, &display);
}

static void expose(AppDial *self, double stops)
{
    AppDisplay display = *app_display_form_get(self->form);
    const double next = CLAMP(round(stops * STOP_GRAIN) / STOP_GRAIN, -MOST_STOPS, MOST_STOPS);
    if (next == display.exposure)
        return;
    display.exposure = next;
    app_display_form_set(self->form, &display);
}

/* ---- drawing ---- */

static double x_of(const AppDial *self, double value)
{
    const AppRange range = shown_range(self);
    return INSET + length_of(self) * CLAMP(app_range_place(&range, value), 0, 1);
}

/* A number under or over its place, if there is room for it between what stands beside it. */
static void write_number(cairo_t *cairo, PangoLayout *layout, const double at[2], double number, double room[2])
{
    char text[APP_NUMBER_SIZE];
    int width, height;
    app_number_plain(number, DIGITS, text);
    pango_layout_set_text(layout, app_number_mark(text), -1);
    pango_layout_get_pixel_size(layout, &width, &height);
    if (at[0] - width / 2.0 < room[0] || at[0] + width / 2.0 > room[1])
        return;
    cairo_move_to(cairo, at[0] - width / 2.0, at[1]);
    pango_cairo_show_layout(cairo, layout);
    room[0] = at[0] + width / 2.0 + GAP;
}

/* Ticks of the isophotes go into the bar; where there is room their values stand above it. */
static void draw_levels(const AppDial *self, cairo_t *cairo, PangoLayout *layout, double width)
{
    double room[2] = {0, width};
    for (gsize i = 0; i < self->level_count; i++) {
        const double x = round(x_of(self, self->levels[i])) + 0.5;
        if (x <= INSET + 1 || x >= width - INSET - 1)
            continue;
        cairo_move_to(cairo, x, ABOVE - 3);
        cairo_line_to(cairo, x, ABOVE + 5);
        cairo_stroke(cairo);
        write_number(cairo, layout, (const double[]){x, 0}, self->levels[i], room);
    }
}

/* The ends have their values, and round ones stand between them where there is room. */
static void draw_ticks(const AppDial *self, cairo_t *cairo, PangoLayout *layout, double width)
{
    const AppRange range = shown_range(self);
    const double bounds[ENDS] = {range.low, range.high}, y = ABOVE + BAR + TICK;
    double levels[MOST_LEVELS], room[2] = {0, width};
    for (int end = 0; end < ENDS; end++) {
        char text[APP_NUMBER_SIZE];
        int length, height;
        app_number_plain(bounds[end], DIGITS, text);
        pango_layout_set_text(layout, app_number_mark(text), -1);
        pango_layout_get_pixel_size(layout, &length, &height);
        const double x =
            end == END_LOW ? MAX(INSET - length / 2.0, 0) : MIN(width - INSET - length / 2.0, width - length);
        cairo_move_to(cairo, x, y);
        pango_cairo_show_layout(cairo, layout);
        room[end] = end == END_LOW ? x + length + GAP : x - GAP;
    }
    const gsize count = luxel_round_levels(range.low, range.high, range.logarithmic,
                                           (gsize)(length_of(self) / PIXELS_OF_A_TICK) + 1, levels, MOST_LEVELS);
    for (gsize i = 0; i < count; i++) {
        const double x = round(x_of(self, levels[i])) + 0.5;
        cairo_move_to(cairo, x, ABOVE + BAR);
        cairo_line_to(cairo, x, y);
        cairo_stroke(cairo);
        write_number(cairo, layout, (const double[]){x, y}, levels[i], room);
    }
}

/* One row of colours, drawn as long as the bar. */
static void draw_colors(const AppDial *self, cairo_t *cairo)
{
    enum { STEPS = 512 };
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, STEPS, 1);
    if (cairo_surface_status(image) == CAIRO_STATUS_SUCCESS) {
        guint32 *pixels = (guint32 *)(void *)cairo_image_surface_get_data(image);
        for (int i = 0; i < STEPS; i++) {
            double color[3];
            app_display_color(&self->picture->display, field_of(self), (i + 0.5) / STEPS, color);
            pixels[i] = (guint32)lround(255 * color[0]) << 16 | (guint32)lround(255 * color[1]) << 8 |
                        (guint32)lround(255 * color[2]);
        }
        cairo_surface_mark_dirty(image);
        cairo_save(cairo);
        cairo_rectangle(cairo, INSET, ABOVE, length_of(self), BAR);
        cairo_clip(cairo);
        cairo_translate(cairo, INSET, ABOVE);
        cairo_scale(cairo, length_of(self) / STEPS, BAR);
        cairo_set_source_surface(cairo, image, 0, 0);
        cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
        cairo_paint(cairo);
        cairo_restore(cairo);
    }
    cairo_surface_destroy(image);
}

static void draw_triangle(cairo_t *cairo, double x, double way)
{
    const double middle = ABOVE + BAR / 2.0;
    cairo_move_to(cairo, x, middle - POINT);
    cairo_line_to(cairo, x + way * POINT, middle);
    cairo_line_to(cairo, x, middle + POINT);
    cairo_close_path(cairo);
    cairo_fill(cairo);
}

/* Values that the first and the last colour stand for as well. */
static void draw_clips(const AppDial *self, cairo_t *cairo, double width)
{
    const luxel_statistics *statistics = luxel_field_statistics(field_of(self));
    const AppRange range = shown_range(self);
    if (self->picture->side == APP_SIDE_DIFFERENCE)
        return;
    if (statistics->minimum.exists && statistics->minimum.value < range.low)
        draw_triangle(cairo, INSET - GRIP - 3, -1);
    if (statistics->maximum.exists && statistics->maximum.value > range.high * (1 + 1e-9))
        draw_triangle(cairo, width - INSET + GRIP + 3, 1);
}

static void draw_end(const AppDial *self, cairo_t *cairo, End end, double width, const GdkRGBA *ink)
{
    const double x = (end == END_HIGH ? width - INSET : INSET) + (self->dragged == end ? self->dragged_by : 0);
    cairo_rectangle(cairo, round(x) - GRIP + 0.5, ABOVE - 3 + 0.5, 2 * GRIP - 1, BAR + 5);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_fill_preserve(cairo);
    gdk_cairo_set_source_rgba(cairo, ink);
    cairo_set_line_width(cairo, 1.5);
    cairo_stroke_preserve(cairo);
    cairo_set_source_rgba(cairo, 0, 0, 0, 0.5);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
}

/* The quantity and unit of the numbers; shortened where they are longer than the bar. */
static void write_label(const AppDial *self, cairo_t *cairo, PangoLayout *layout, double width, double height)
{
    const luxel_field *field = field_of(self);
    int high;
    char *label = g_strdup_printf("%s%s, %s", self->picture->side == APP_SIDE_DIFFERENCE ? _("B − A: ") : "",
                                  gettext(luxel_field_quantity_word(field)), gettext(luxel_field_unit(field)));
    pango_layout_set_text(layout, label, -1);
    pango_layout_set_width(layout, (int)width * PANGO_SCALE);
    pango_layout_set_alignment(layout, PANGO_ALIGN_CENTER);
    pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    pango_layout_get_pixel_size(layout, NULL, &high);
    cairo_move_to(cairo, 0, height - high);
    pango_cairo_show_layout(cairo, layout);
    g_free(label);
}

static void draw_bar(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    const AppDial *self = data;
    GdkRGBA ink;
    if (!self->picture || width < 3 * INSET)
        return;
    PangoLayout *layout = app_letters_new(self->area, NULL, NULL, LETTERS);
    PangoLayout *small = app_letters_new(self->area, NULL, NULL, LETTERS / app_letters_scale(self->area));
    gtk_style_context_get_color(gtk_widget_get_style_context(GTK_WIDGET(area)), &ink);
    draw_colors(self, cairo);
    gdk_cairo_set_source_rgba(cairo, &ink);
    cairo_set_line_width(cairo, 1);
    draw_ticks(self, cairo, layout, width);
    draw_levels(self, cairo, small, width);
    draw_clips(self, cairo, width);
    for (int end = 0; end < ENDS && can_turn(self); end++)
        draw_end(self, cairo, (End)end, width, &ink);
    gdk_cairo_set_source_rgba(cairo, &ink);
    write_label(self, cairo, layout, width, height);
    g_object_unref(layout);
    g_object_unref(small);
}

/* A line through the bar between two arrowheads, dark with a light seam, which shows on every colour. */
static void draw_needle(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    const AppDial *self = data;
    (void)area;
    (void)width;
    (void)height;
    if (!self->picture || !isfinite(self->value))
        return;
    const double x = round(x_of(self, self->value)) + 0.5;
    cairo_move_to(cairo, x - 4, ABOVE - 6);
    cairo_line_to(cairo, x + 4, ABOVE - 6);
    cairo_line_to(cairo, x, ABOVE);
    cairo_line_to(cairo, x, ABOVE + BAR);
    cairo_line_to(cairo, x, ABOVE);
    cairo_close_path(cairo);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_set_line_width(cairo, 4);
    cairo_stroke_preserve(cairo);
    cairo_set_source_rgb(cairo, 0.8, 0.1, 0.1);
    cairo_set_line_width(cairo, 1.6);
    cairo_stroke_preserve(cairo);
    cairo_fill(cairo);
}

/* ---- the hand ---- */

static End end_of(const AppDial *self, GtkWidget *widget)
{
    return widget == self->ends[END_LOW] ? END_LOW : widget == self->ends[END_HIGH] ? END_HIGH : NO_END;
}

static void drag_begins(GtkGestureDrag *gesture, double x, double y, AppDial *self)
{
    GtkWidget *widget = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(gesture));
    (void)x;
    (void)y;
    if (!can_turn(self)) {
        gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_DENIED);
        return;
    }
    gtk_widget_grab_focus(widget);
    self->start = wanted_range(self);
    self->exposure = app_display_form_get(self->form)->exposure;
    self->dragged = end_of(self, widget);
    self->dragged_by = 0;
}

static void dragged(GtkGestureDrag *gesture, double dx, double dy, AppDial *self)
{
    (void)gesture;
    (void)dy;
    if (!can_turn(self))
        return;
    self->dragged_by = dx;
    if (self->dragged == NO_END)
        expose(self, self->exposure + dx / PIXELS_OF_A_STOP);
    else
        move_end(self, self->dragged, self->start, dx / length_of(self));
    gtk_widget_queue_draw(self->area);
}

static void drag_ends(GtkGestureDrag *gesture, double dx, double dy, AppDial *self)
{
    (void)gesture;
    (void)dx;
    (void)dy;
    self->dragged = NO_END;
    gtk_widget_queue_draw(self->area);
}

static gboolean key_pressed(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                            AppDial *self)
{
    const End end = end_of(self, gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(controller)));
    const gboolean forth = key == GDK_KEY_Right || key == GDK_KEY_Up, back = key == GDK_KEY_Left || key == GDK_KEY_Down;
    (void)code;
    if (!(forth || back) || !can_turn(self) || (state & (GDK_CONTROL_MASK | GDK_ALT_MASK)))
        return FALSE;
    const double sign = forth ? 1 : -1;
    if (end == NO_END)
        expose(self,
               app_display_form_get(self->form)->exposure + sign * ((state & GDK_SHIFT_MASK) ? 1 : 1 / STOP_GRAIN));
    else
        move_end(self, end, wanted_range(self), sign * ((state & GDK_SHIFT_MASK) ? SHIFT_PART : KEY_PART));
    return TRUE;
}

static void lock_toggled(AppDial *self)
{
    AppDisplay display = *app_display_form_get(self->form);
    if (self->is_told || !self->picture)
        return;
    display.is_locked = gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->lock));
    display.low = self->picture->low;
    display.high = self->picture->high;
    app_display_form_set(self->form, &display);
}

static void logarithmic_toggled(AppDial *self)
{
    AppDisplay display = *app_display_form_get(self->form);
    if (self->is_told)
        return;
    display.logarithmic = gtk_toggle_button_get_active(GTK_TOGGLE_BUTTON(self->logarithmic));
    app_display_form_set(self->form, &display);
}

/* ---- what is told ---- */

static void tell_slider(GtkWidget *widget, double value, double least, double most, const char *text)
{
    gtk_accessible_update_property(GTK_ACCESSIBLE(widget), GTK_ACCESSIBLE_PROPERTY_VALUE_NOW, value,
                                   GTK_ACCESSIBLE_PROPERTY_VALUE_MIN, least, GTK_ACCESSIBLE_PROPERTY_VALUE_MAX, most,
                                   GTK_ACCESSIBLE_PROPERTY_VALUE_TEXT, text, GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text,
                                   -1);
}

/* Screen readers are told what changed, and nothing while nothing does. */
static void tell(AppDial *self)
{
    const AppDisplay *display = app_display_form_get(self->form);
    const AppRange range = shown_range(self);
    char n[2][APP_NUMBER_SIZE], stops[APP_NUMBER_SIZE];
    g_snprintf(stops, sizeof stops, _("%+.2f EV"), display->exposure);
    app_number_mark(stops);
    app_number_show(range.low, DIGITS, n[0]);
    app_number_show(range.high, DIGITS, n[1]);
    tell_slider(self->ends[END_LOW], range.low, -G_MAXDOUBLE, range.high, n[0]);
    tell_slider(self->ends[END_HIGH], range.high, range.low, G_MAXDOUBLE, n[1]);
    tell_slider(self->area, display->exposure, -MOST_STOPS, MOST_STOPS, stops);
    if (strcmp(gtk_label_get_text(GTK_LABEL(self->stops)), stops) != 0)
        gtk_label_set_text(GTK_LABEL(self->stops), stops);
    self->is_told = TRUE;
    gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(self->lock), display->is_locked);
    gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(self->logarithmic), display->logarithmic);
    self->is_told = FALSE;
}

void app_dial_set_form(AppDial *self, AppDisplayForm *form)
{
    g_set_object(&self->form, form);
}

void app_dial_set_picture(AppDial *self, AppPicture *picture)
{
    if (picture)
        app_picture_ref(picture);
    app_picture_unref(self->picture);
    self->picture = picture;
    if (!picture) {
        self->level_count = 0;
        gtk_widget_queue_draw(self->area);
        gtk_widget_queue_draw(self->needle);
        return;
    }
    if (!picture->display.isophotes || picture->side == APP_SIDE_DIFFERENCE)
        self->level_count = 0;
    for (int i = 0; i < ENDS; i++)
        gtk_widget_set_sensitive(self->ends[i], can_turn(self));
    tell(self);
    gtk_widget_queue_draw(self->area);
    if (isfinite(self->value))
        gtk_widget_queue_draw(self->needle);
}

/* The lines come level by level. */
void app_dial_set_isophotes(AppDial *self, const luxel_isophotes *isophotes)
{
    self->level_count = 0;
    for (gsize i = 0; isophotes && i < isophotes->count && self->level_count < MOST_LEVELS; i++)
        if (self->level_count == 0 || isophotes->lines[i].level != self->levels[self->level_count - 1])
            self->levels[self->level_count++] = isophotes->lines[i].level;
    gtk_widget_queue_draw(self->area);
}

void app_dial_set_needle(AppDial *self, double value)
{
    if (value == self->value || (isnan(value) && isnan(self->value)))
        return;
    self->value = value;
    gtk_widget_queue_draw(self->needle);
}

/* ---- making it ---- */

static gboolean place_child(GtkOverlay *overlay, GtkWidget *child, GdkRectangle *place, AppDial *self)
{
    const int width = gtk_widget_get_width(GTK_WIDGET(overlay));
    const End end = end_of(self, child);
    if (end == NO_END)
        return FALSE;
    *place = (GdkRectangle){end == END_HIGH ? width - APP_FINGER : 0, 0, APP_FINGER, APP_FINGER};
    return TRUE;
}

static void make_slider(AppDial *self, GtkWidget *slider, const char *name, const char *meaning)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    GtkEventController *keys = gtk_event_controller_key_new();
    gtk_widget_set_focusable(slider, TRUE);
    gtk_widget_set_tooltip_text(slider, meaning);
    gtk_widget_set_cursor_from_name(slider, "ew-resize");
    gtk_widget_add_css_class(slider, "turned");
    gtk_accessible_update_property(GTK_ACCESSIBLE(slider), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(drag_begins), self);
    g_signal_connect(drag, "drag-update", G_CALLBACK(dragged), self);
    g_signal_connect(drag, "drag-end", G_CALLBACK(drag_ends), self);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key_pressed), self);
    gtk_widget_add_controller(slider, GTK_EVENT_CONTROLLER(drag));
    gtk_widget_add_controller(slider, keys);
}

static GtkWidget *new_slider_area(GtkDrawingAreaDrawFunc draw, AppDial *self)
{
    GtkWidget *area = g_object_new(GTK_TYPE_DRAWING_AREA, "accessible-role", GTK_ACCESSIBLE_ROLE_SLIDER, NULL);
    if (draw)
        gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(area), draw, self, NULL);
    return area;
}

/* Larger letters have room: numbers and the label stand below the bar. */
static void set_height(GtkWidget *area, gpointer data)
{
    (void)data;
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(area),
                                        HEIGHT + (int)ceil((app_letters_scale(area) - 1) * (HEIGHT - BELOW)));
}

static void make_bar(AppDial *self)
{
    GtkWidget *overlay = gtk_overlay_new();
    self->area = new_slider_area(draw_bar, self);
    g_signal_connect(self->area, "map", G_CALLBACK(set_height), NULL);
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(self->area), HEIGHT);
    gtk_drawing_area_set_content_width(GTK_DRAWING_AREA(self->area), LEAST_WIDTH);
    make_slider(self, self->area, _("Exposure"), _("Drag between the ends: exposure, each stop doubles what is shown"));
    self->needle = gtk_drawing_area_new();
    gtk_widget_set_can_target(self->needle, FALSE);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(self->needle), draw_needle, self, NULL);
    self->ends[END_LOW] = new_slider_area(NULL, self);
    self->ends[END_HIGH] = new_slider_area(NULL, self);
    make_slider(self, self->ends[END_LOW], _("Lower end of the scale"), _("The value of the first colour"));
    make_slider(self, self->ends[END_HIGH], _("Upper end of the scale"), _("The value of the last colour"));
    gtk_overlay_set_child(GTK_OVERLAY(overlay), self->area);
    gtk_overlay_add_overlay(GTK_OVERLAY(overlay), self->needle);
    for (int i = 0; i < ENDS; i++)
        gtk_overlay_add_overlay(GTK_OVERLAY(overlay), self->ends[i]);
    g_signal_connect(overlay, "get-child-position", G_CALLBACK(place_child), self);
    gtk_widget_set_hexpand(overlay, TRUE);
    gtk_box_append(GTK_BOX(self), overlay);
}

static GtkWidget *new_toggle(const char *name, const char *meaning, GCallback toggled, AppDial *self)
{
    GtkWidget *button = gtk_toggle_button_new();
    gtk_widget_set_size_request(button, APP_FINGER, APP_FINGER);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_set_tooltip_text(button, meaning);
    app_name_control(button, name);
    g_signal_connect_swapped(button, "toggled", toggled, self);
    return button;
}

static void make_buttons(AppDial *self)
{
    GtkWidget *column = gtk_box_new(GTK_ORIENTATION_VERTICAL, 2), *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 2);
    self->lock = new_toggle(_("Lock range"), _("The same range for every picture; else from 0 to each one's maximum"),
                            G_CALLBACK(lock_toggled), self);
    gtk_button_set_icon_name(GTK_BUTTON(self->lock), "changes-prevent-symbolic");
    self->logarithmic =
        new_toggle(_("Logarithmic scale"), _("Colours by the logarithm of the value, over four decades"),
                   G_CALLBACK(logarithmic_toggled), self);
    gtk_button_set_label(GTK_BUTTON(self->logarithmic), _("log"));
    app_name_control(self->logarithmic, _("Logarithmic scale")); /* which the label has become */
    self->stops = gtk_label_new(NULL);
    gtk_label_set_width_chars(GTK_LABEL(self->stops), (int)strlen("+40.00 EV"));
    gtk_label_set_xalign(GTK_LABEL(self->stops), 1);
    gtk_widget_add_css_class(self->stops, "numeric");
    gtk_widget_set_margin_end(column, GAP);
    gtk_box_append(GTK_BOX(line), self->lock);
    gtk_box_append(GTK_BOX(line), self->logarithmic);
    gtk_box_append(GTK_BOX(column), line);
    gtk_box_append(GTK_BOX(column), self->stops);
    gtk_box_append(GTK_BOX(self), column);
}

static void app_dial_dispose(GObject *object)
{
    AppDial *self = APP_DIAL(object);
    g_clear_object(&self->form);
    g_clear_pointer(&self->picture, app_picture_unref);
    G_OBJECT_CLASS(app_dial_parent_class)->dispose(object);
}

static void app_dial_class_init(AppDialClass *class)
{
    G_OBJECT_CLASS(class)->dispose = app_dial_dispose;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "luxeldial");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
}

static void app_dial_init(AppDial *self)
{
    self->value = (double)NAN;
    self->dragged = NO_END;
    make_bar(self);
    make_buttons(self);
}

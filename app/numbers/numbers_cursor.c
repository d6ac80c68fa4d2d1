/* SPDX-License-Identifier: MIT */
/*
 * Plots with a cursor: under the pointer, or moved by arrows, it stands at a sample of a section or a bin of the
 * histogram, whose numbers are told below the plot.  They are what was computed there, never read off the drawing.
 */
#include <math.h>

#include "../../front/words.h"
#include "../base/lamp.h"
#include "../base/number.h"
#include "numbers_private.h"

enum {
    PLOT_HEIGHT = 230,
    WORD_LINES = 2,
    SHARE_DIGITS = 5,
    PAGE = 10 /* steps of Page Up and Down */
};
static const double DOT = 3.5;

/* ---- what it stands at ---- */

static gsize size_of(const AppNumbers *self, Plot plot)
{
    if (plot == PLOT_HISTOGRAM)
        return self->bins ? self->bins->bins : 0;
    return self->curves[plot] ? self->curves[plot]->profile.count : 0;
}

/* How far from the left edge of the frame to the right one, 0 to 1. */
static double share_of(const AppNumbers *self, Plot plot, gsize at)
{
    const double size = (double)size_of(self, plot);
    return plot == PLOT_HISTOGRAM ? ((double)at + 0.5) / size : (double)at / (size - 1);
}

/* The nearest one to a place of the widget; -1: beside the frame. */
static gssize find(const AppNumbers *self, Plot plot, double x)
{
    const luxel_plot_frame *frame = &self->cursors[plot].frame;
    const double size = (double)size_of(self, plot), share = (x - frame->x) / frame->width;
    if (size < 2 || !(frame->width > 0) || share < -0.02 || share > 1.02)
        return -1;
    const double at = plot == PLOT_HISTOGRAM ? floor(share * size) : round(share * (size - 1));
    return (gssize)CLAMP(at, 0, size - 1);
}

/* ---- its words ---- */

/* "1 2.5  2 0.5" on a line of their own, in the colours of the sources, of those that give anything. */
static void add_shares(GString *text, const luxel_profile *profile, gsize at)
{
    const char *before = "\n";
    char number[APP_NUMBER_SIZE];
    for (gsize i = 0; i < profile->lights && profile->lights > 1; i++) {
        const double share = profile->shares[at * profile->lights + i];
        if (share == 0)
            continue;
        char *lamp = app_lamp_markup(i);
        g_string_append_printf(text, "%s%s %s", before, lamp, app_number_show(share, SHARE_DIGITS, number));
        before = "  ";
        g_free(lamp);
    }
}

static void tell_sample(AppNumbers *self, Plot plot, GString *text)
{
    const luxel_profile *profile = &self->curves[plot]->profile;
    const luxel_profile_sample *sample = &profile->samples[self->cursors[plot].at];
    const double place = plot == PLOT_VERTICAL ? sample->y_mm : sample->x_mm;
    char number[APP_NUMBER_SIZE];
    g_string_append_printf(text, "%s = %s %s: ", plot == PLOT_VERTICAL ? "y" : "x",
                           app_number_show(place, PLACE_DIGITS, number), _("mm"));
    if (!sample->has_value) {
        g_string_append(text, _("no value"));
        return;
    }
    g_string_append(text, app_number_show(sample->value, DIGITS, number));
    if (profile->shares)
        add_shares(text, profile, (gsize)self->cursors[plot].at);
}

static void tell_bin(AppNumbers *self, GString *text)
{
    const gsize at = (gsize)self->cursors[PLOT_HISTOGRAM].at, count = self->bins->counts[at];
    char low[APP_NUMBER_SIZE], high[APP_NUMBER_SIZE], percent[APP_NUMBER_SIZE];
    gsize whole = 0;
    for (gsize i = 0; i < self->bins->bins; i++)
        whole += self->bins->counts[i];
    g_string_append_printf(text, ngettext("%s … %s: %zu pixel, %s %%", "%s … %s: %zu pixels, %s %%", count),
                           app_number_show(self->bins->edges[at], DIGITS, low),
                           app_number_show(self->bins->edges[at + 1], DIGITS, high), count,
                           app_number_show(whole > 0 ? 100.0 * (double)count / (double)whole : 0, 3, percent));
}

void app_numbers_tell_cursor(AppNumbers *self, Plot plot)
{
    Cursor *cursor = &self->cursors[plot];
    GString *text = g_string_new(NULL);
    if (cursor->at >= (gssize)size_of(self, plot))
        cursor->at = -1;
    if (cursor->at >= 0 && plot == PLOT_HISTOGRAM)
        tell_bin(self, text);
    else if (cursor->at >= 0)
        tell_sample(self, plot, text);
    gtk_label_set_markup(GTK_LABEL(cursor->words), text->str);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->plots[plot]), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   gtk_label_get_text(GTK_LABEL(cursor->words)), -1);
    g_string_free(text, TRUE);
    gtk_widget_queue_draw(self->plots[plot]);
}

/* ---- its look ---- */

static void draw_dot(cairo_t *cairo, const luxel_plot_frame *frame, double x, double value, const double color[3],
                     const double ground[3])
{
    const double y = frame->y + frame->height * (frame->top - value) / (frame->top - frame->bottom);
    if (!(y >= frame->y && y <= frame->y + frame->height))
        return;
    cairo_arc(cairo, x, y, DOT, 0, 2 * G_PI);
    cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
    cairo_fill_preserve(cairo);
    cairo_set_source_rgb(cairo, ground[0], ground[1], ground[2]);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
}

static void draw_dots(AppNumbers *self, Plot plot, cairo_t *cairo, const luxel_drawing_style *style, double x)
{
    const luxel_profile *profile = &self->curves[plot]->profile;
    const Cursor *cursor = &self->cursors[plot];
    const luxel_profile_sample *sample = &profile->samples[cursor->at];
    for (gsize i = 0; i < profile->lights && profile->shares && profile->lights > 1 && sample->has_value; i++) {
        double color[3];
        if (luxel_light_color(style, i, color) == LUXEL_OK)
            draw_dot(cairo, &cursor->frame, x, profile->shares[(gsize)cursor->at * profile->lights + i], color,
                     style->ground);
    }
    if (sample->has_value)
        draw_dot(cairo, &cursor->frame, x, sample->value, style->ink, style->ground);
}

void app_numbers_draw_cursor(AppNumbers *self, Plot plot, cairo_t *cairo, const luxel_drawing_style *style)
{
    const Cursor *cursor = &self->cursors[plot];
    const luxel_plot_frame *frame = &cursor->frame;
    if (cursor->at < 0 || !(frame->width > 0))
        return;
    const double x = frame->x + frame->width * share_of(self, plot, (gsize)cursor->at);
    cairo_set_source_rgba(cairo, style->ink[0], style->ink[1], style->ink[2], 0.6);
    cairo_set_line_width(cairo, 1);
    cairo_move_to(cairo, round(x) + 0.5, frame->y);
    cairo_line_to(cairo, round(x) + 0.5, frame->y + frame->height);
    cairo_stroke(cairo);
    if (plot != PLOT_HISTOGRAM)
        draw_dots(self, plot, cairo, style, x);
}

/* ---- the hand ---- */

static Plot plot_of(const AppNumbers *self, const GtkWidget *widget)
{
    Plot plot = PLOT_HORIZONTAL;
    while (plot < PLOT_HISTOGRAM && self->plots[plot] != widget)
        plot++;
    return plot;
}

static void put(AppNumbers *self, Plot plot, gssize at)
{
    if (at == self->cursors[plot].at)
        return;
    self->cursors[plot].at = at;
    app_numbers_tell_cursor(self, plot);
    if (plot == PLOT_HISTOGRAM)
        return;
    const luxel_profile_sample *sample = at >= 0 ? &self->curves[plot]->profile.samples[at] : NULL;
    g_signal_emit_by_name(self, "read", sample ? sample->x_mm : 0.0, sample ? sample->y_mm : 0.0, sample != NULL);
}

static void pointer_moved(GtkEventController *controller, double x, double y, AppNumbers *self)
{
    const Plot plot = plot_of(self, gtk_event_controller_get_widget(controller));
    (void)y;
    put(self, plot, find(self, plot, x));
}

/* Pointer or keyboard have gone. */
static void left(GtkEventController *controller, AppNumbers *self)
{
    put(self, plot_of(self, gtk_event_controller_get_widget(controller)), -1);
}

static void pressed(GtkEventController *controller)
{
    gtk_widget_grab_focus(gtk_event_controller_get_widget(controller));
}

static gboolean key_pressed(GtkEventController *controller, guint key, guint code, GdkModifierType state,
                            AppNumbers *self)
{
    const Plot plot = plot_of(self, gtk_event_controller_get_widget(controller));
    const gssize last = (gssize)size_of(self, plot) - 1, at = self->cursors[plot].at;
    gssize step;
    (void)code;
    (void)state;
    switch (key) {
    case GDK_KEY_Left: step = -1; break;
    case GDK_KEY_Right: step = 1; break;
    case GDK_KEY_Page_Up: step = PAGE; break;
    case GDK_KEY_Page_Down: step = -PAGE; break;
    case GDK_KEY_Home: step = -last; break;
    case GDK_KEY_End: step = last; break;
    default: return FALSE;
    }
    if (last > 0)
        put(self, plot, CLAMP((at < 0 ? last / 2 : at) + step, 0, last));
    return TRUE;
}

/* ---- making it ---- */

static GtkWidget *new_words(GtkWidget *plot)
{
    GtkWidget *words = gtk_label_new(NULL);
    PangoLayout *layout = gtk_widget_create_pango_layout(plot, "0");
    int height;
    pango_layout_get_pixel_size(layout, NULL, &height);
    g_object_unref(layout);
    gtk_label_set_xalign(GTK_LABEL(words), 0);
    gtk_label_set_yalign(GTK_LABEL(words), 0);
    gtk_label_set_wrap(GTK_LABEL(words), TRUE);
    gtk_label_set_lines(GTK_LABEL(words), WORD_LINES);
    gtk_label_set_ellipsize(GTK_LABEL(words), PANGO_ELLIPSIZE_END);
    gtk_label_set_max_width_chars(GTK_LABEL(words), TEXT_COLUMNS);
    gtk_widget_set_size_request(words, -1, WORD_LINES * height); /* what it reads moves nothing */
    gtk_widget_add_css_class(words, "numeric");
    return words;
}

void app_numbers_add_plot(AppNumbers *self, Plot plot, GtkDrawingAreaDrawFunc draw, const char *name, GtkWidget *page)
{
    GtkWidget *area = gtk_drawing_area_new();
    GtkEventController *motion = gtk_event_controller_motion_new(), *keys = gtk_event_controller_key_new();
    GtkEventController *focus = gtk_event_controller_focus_new();
    GtkGesture *click = gtk_gesture_click_new();
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(area), PLOT_HEIGHT);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(area), draw, self, NULL);
    gtk_widget_set_hexpand(area, TRUE);
    gtk_widget_set_vexpand(area, plot < PLOT_HISTOGRAM); /* both sections share the height there is */
    gtk_widget_set_focusable(area, TRUE);
    gtk_widget_set_cursor_from_name(area, "crosshair");
    gtk_widget_add_css_class(area, "turned");
    gtk_accessible_update_property(GTK_ACCESSIBLE(area), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    g_signal_connect(motion, "motion", G_CALLBACK(pointer_moved), self);
    g_signal_connect(motion, "leave", G_CALLBACK(left), self);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key_pressed), self);
    g_signal_connect(focus, "leave", G_CALLBACK(left), self);
    g_signal_connect(click, "pressed", G_CALLBACK(pressed), NULL);
    gtk_widget_add_controller(area, GTK_EVENT_CONTROLLER(click));
    gtk_widget_add_controller(area, motion);
    gtk_widget_add_controller(area, keys);
    gtk_widget_add_controller(area, focus);
    self->plots[plot] = area;
    self->cursors[plot].words = new_words(area);
    gtk_box_append(GTK_BOX(page), area);
    gtk_box_append(GTK_BOX(page), self->cursors[plot].words);
}

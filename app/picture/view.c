/* SPDX-License-Identifier: MIT */
/* The widget: its picture and its zoom. */
#include "view.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/lamp.h"
#include "view_private.h"

enum { MARGIN = 12 };
static const double LEAST_ZOOM = 0.02, MOST_ZOOM = 200; /* of the fitted picture */

enum { POINTED, SELECTED, SECTION_MOVED, FRAMED, HOVERED, MOVED, TOGGLED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppView, app_view, GTK_TYPE_WIDGET)

/* ---- the map ---- */

static const luxel_field *field_of(const AppView *self)
{
    return self->picture ? self->picture->shot->field : NULL;
}

void app_view_tell_frame(AppView *self)
{
    if (memcmp(&self->told, &self->map, sizeof self->map) == 0)
        return;
    self->told = self->map;
    g_signal_emit(self, signals[FRAMED], 0);
}

/* Fitted to what the screen of the scene is, which a coarse picture covers but for a part of a pixel. */
static void fit_map(AppView *self)
{
    const double width = gtk_widget_get_width(GTK_WIDGET(self)), height = gtk_widget_get_height(GTK_WIDGET(self));
    if (!self->is_fitted || !field_of(self) || width < 2 * MARGIN + 1 || height < 2 * MARGIN + 1)
        return;
    if (self->picture->shot->is_fine || self->screen.high[0] - self->screen.low[0] <= 1)
        self->screen = app_area_of(field_of(self));
    const AppArea *screen = &self->screen;
    self->map.scale = MIN((width - 2 * MARGIN) / (screen->high[0] - screen->low[0]),
                          (height - 2 * MARGIN) / (screen->high[1] - screen->low[1]));
    self->map.origin[0] = width / 2 - (screen->low[0] + screen->high[0]) / 2 * self->map.scale;
    self->map.origin[1] = height / 2 + (screen->low[1] + screen->high[1]) / 2 * self->map.scale;
    app_view_tell_frame(self);
}

static graphene_rect_t picture_area(const AppView *self)
{
    const AppArea *area = &self->picture->area;
    double from[2], to[2];
    const double upper_left[2] = {area->low[0], area->high[1]}, lower_right[2] = {area->high[0], area->low[1]};
    app_map_to_widget(&self->map, upper_left, from);
    app_map_to_widget(&self->map, lower_right, to);
    return GRAPHENE_RECT_INIT((float)from[0], (float)from[1], (float)(to[0] - from[0]), (float)(to[1] - from[1]));
}

/* Painted for just this map, the picture lies on whole dots: rounding takes away what the arithmetic left. */
static graphene_rect_t dots_of(AppView *self, graphene_rect_t area)
{
    const float dots = (float)gtk_widget_get_scale_factor(GTK_WIDGET(self));
    float sides[4] = {area.origin.x, area.origin.y, area.size.width, area.size.height};
    for (int i = 0; i < 4; i++) {
        const float whole = roundf(sides[i] * dots) / dots;
        if (fabsf(whole - sides[i]) > 0.01f)
            return area;
        sides[i] = whole;
    }
    return GRAPHENE_RECT_INIT(sides[0], sides[1], sides[2], sides[3]);
}

AppFrame app_view_frame(AppView *self)
{
    const int dots = gtk_widget_get_scale_factor(GTK_WIDGET(self));
    return (AppFrame){.origin = {self->map.origin[0] * dots, self->map.origin[1] * dots},
                      .scale = self->map.scale * dots,
                      .width = gtk_widget_get_width(GTK_WIDGET(self)) * dots,
                      .height = gtk_widget_get_height(GTK_WIDGET(self)) * dots};
}

double app_view_mm_per_pixel(AppView *self)
{
    return self->map.scale > 0 ? 1 / self->map.scale : 1;
}

double app_view_magnification(AppView *self)
{
    const luxel_field *field = field_of(self);
    if (!field)
        return 0;
    const AppArea area = app_area_of(field);
    return self->map.scale * gtk_widget_get_scale_factor(GTK_WIDGET(self)) * (area.high[0] - area.low[0]) /
           luxel_field_columns(field);
}

void app_view_zoom_at(AppView *self, const double at[2], double factor)
{
    double place[2];
    if (!field_of(self))
        return;
    const double fitted = gtk_widget_get_width(GTK_WIDGET(self)) / (self->screen.high[0] - self->screen.low[0]);
    app_map_from_widget(&self->map, at, place);
    self->map.scale = CLAMP(self->map.scale * factor, fitted * LEAST_ZOOM, fitted * MOST_ZOOM);
    self->map.origin[0] = at[0] - place[0] * self->map.scale;
    self->map.origin[1] = at[1] + place[1] * self->map.scale;
    self->is_fitted = FALSE;
    app_view_tell_frame(self);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

static void get_middle(AppView *self, double middle[2])
{
    middle[0] = gtk_widget_get_width(GTK_WIDGET(self)) / 2.0;
    middle[1] = gtk_widget_get_height(GTK_WIDGET(self)) / 2.0;
}

void app_view_zoom(AppView *self, double factor)
{
    double middle[2];
    get_middle(self, middle);
    app_view_zoom_at(self, middle, factor);
}

void app_view_fit(AppView *self)
{
    self->is_fitted = TRUE;
    fit_map(self);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_one_to_one(AppView *self)
{
    double middle[2];
    if (!field_of(self))
        return;
    const AppArea area = app_area_of(field_of(self));
    const double dots = gtk_widget_get_scale_factor(GTK_WIDGET(self));
    const double wanted = luxel_field_columns(field_of(self)) / (area.high[0] - area.low[0]) / dots;
    get_middle(self, middle);
    app_view_zoom_at(self, middle, wanted / self->map.scale);
    /* whole pixels on whole pixels */
    for (int k = 0; k < 2; k++)
        self->map.origin[k] = round(self->map.origin[k] * dots) / dots;
    app_view_tell_frame(self);
}

/* ---- what is shown ---- */

void app_view_set_document(AppView *self, AppDocument *document)
{
    g_set_object(&self->document, document);
}

static AppMoment *shown_moment(const AppPicture *picture)
{
    return picture->side == APP_SIDE_PINNED ? picture->pinned->moment : picture->shot->moment;
}

void app_view_set_picture(AppView *self, AppPicture *picture)
{
    const gboolean is_new = !self->picture || shown_moment(self->picture) != shown_moment(picture);
    app_picture_ref(picture);
    app_picture_unref(self->picture);
    self->picture = picture;
    GBytes *pixels = g_bytes_new_with_free_func(picture->pixels, (gsize)picture->columns * picture->rows * 3,
                                                (GDestroyNotify)app_picture_unref, app_picture_ref(picture));
    g_clear_object(&self->texture);
    self->texture = gdk_memory_texture_new((int)picture->columns, (int)picture->rows, GDK_MEMORY_R8G8B8, pixels,
                                           (gsize)picture->columns * 3);
    g_bytes_unref(pixels);
    if (is_new) {
        g_array_unref(self->marks);
        self->marks = app_marks_of(shown_moment(picture));
    }
    fit_map(self);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_forget(AppView *self)
{
    app_view_let_go(self);
    g_clear_object(&self->texture);
    g_clear_pointer(&self->picture, app_picture_unref);
    g_clear_pointer(&self->isophotes, luxel_isophotes_free);
    g_array_set_size(self->marks, 0);
    self->is_fitted = TRUE;
    self->screen = (AppArea){.high = {1, 1}}; /* that of the first picture is fitted */
    self->surface = -1;
    self->is_read = FALSE;
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_isophotes(AppView *self, luxel_isophotes *isophotes, guint64 serial)
{
    luxel_isophotes_free(self->isophotes);
    self->isophotes = isophotes;
    self->isophotes_serial = serial;
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_section(AppView *self, gboolean shown, const double section_mm[2])
{
    self->section_shown = shown;
    self->section_mm[0] = section_mm[0];
    self->section_mm[1] = section_mm[1];
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_read(AppView *self, const double place_mm[2])
{
    self->is_read = place_mm != NULL;
    if (place_mm)
        memcpy(self->read_mm, place_mm, sizeof self->read_mm);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_kept(AppView *self, const double place_mm[2])
{
    self->is_kept = place_mm != NULL;
    if (place_mm)
        memcpy(self->kept_mm, place_mm, sizeof self->kept_mm);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_select(AppView *self, AppMarkKind kind, gsize index)
{
    self->selected_kind = kind;
    self->selected_index = index;
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_choose(AppView *self, const GArray *lights)
{
    g_array_set_size(self->chosen, 0);
    g_array_append_vals(self->chosen, lights->data, lights->len);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

gboolean app_view_is_chosen(const AppView *self, const AppMark *mark)
{
    for (guint i = 0; i < self->chosen->len && self->chosen->len > 1 && mark->kind == APP_MARK_SOURCE; i++)
        if (g_array_index(self->chosen, gsize, i) == mark->index)
            return TRUE;
    return FALSE;
}

void app_view_hover(AppView *self, AppMarkKind kind, gsize index)
{
    if (kind == self->hovered_kind && index == self->hovered_index)
        return;
    self->hovered_kind = kind;
    self->hovered_index = index;
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_stale(AppView *self, gboolean stale)
{
    self->is_stale = stale;
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_hint(AppView *self, const char *hint)
{
    if (g_strcmp0(hint, self->hint) == 0)
        return;
    g_free(self->hint);
    self->hint = g_strdup(hint);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, hint ? hint : "", -1);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_surface(AppView *self, gssize surface)
{
    self->surface = surface;
}

/* The pixel of the greatest value; where all is dark, none is. */
static void draw_maximum(AppView *self, GtkSnapshot *snapshot)
{
    const AppPicture *picture = self->picture;
    const AppShot *shot = picture->side == APP_SIDE_PINNED ? picture->pinned : picture->shot;
    const luxel_extremum *maximum = &luxel_field_statistics(shot->field)->maximum;
    if (maximum->value > 0)
        app_draw_maximum(snapshot, GTK_WIDGET(self), &self->map, maximum);
}

static gboolean is_mark(const AppMark *mark, AppMarkKind kind, gsize index)
{
    return mark->kind == kind && mark->index == index;
}

static void draw_marks(AppView *self, GtkSnapshot *snapshot)
{
    for (guint i = 0; i < self->marks->len; i++) {
        const AppMark *mark = &g_array_index(self->marks, AppMark, i);
        app_draw_mark(snapshot, GTK_WIDGET(self), &self->map, mark,
                      is_mark(mark, self->selected_kind, self->selected_index) || app_view_is_chosen(self, mark),
                      is_mark(mark, self->hovered_kind, self->hovered_index));
        if (self->hint && is_mark(mark, APP_MARK_SOURCE, 0))
            app_draw_hint(snapshot, GTK_WIDGET(self), &self->map, mark, self->hint);
    }
}

static const double DIM = 0.3; /* of what is not of the document, or not of the picture */

static void draw_isophotes(AppView *self, GtkSnapshot *snapshot, int width, int height)
{
    const gboolean is_stale = self->isophotes_serial != shown_moment(self->picture)->serial;
    if (is_stale)
        gtk_snapshot_push_opacity(snapshot, DIM);
    app_draw_isophotes(snapshot, &self->map, self->isophotes, &GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height));
    if (is_stale)
        gtk_snapshot_pop(snapshot);
}

static void app_view_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    AppView *self = APP_VIEW(widget);
    const int width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    if (!self->texture)
        return;
    const AppDisplay *display = &self->picture->display;
    const graphene_rect_t area = dots_of(self, picture_area(self));
    gtk_snapshot_push_clip(snapshot, &GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height));
    if (self->is_stale)
        gtk_snapshot_push_opacity(snapshot, DIM);
    gtk_snapshot_append_texture(snapshot, self->texture, &area);
    const gboolean is_whole = self->picture->side != APP_SIDE_DIFFERENCE; /* which has neither */
    if (is_whole && display->isophotes && self->isophotes)
        draw_isophotes(self, snapshot, width, height);
    if (!self->is_stale)
        app_draw_values(snapshot, widget, &self->map, self->picture);
    else
        gtk_snapshot_pop(snapshot);
    if (display->marks && self->section_shown)
        app_draw_section(snapshot, &self->map, self->section_mm, width, height);
    if (self->section_shown && self->is_read)
        app_draw_read(snapshot, widget, &self->map, self->read_mm);
    if (self->is_kept)
        app_draw_read(snapshot, widget, &self->map, self->kept_mm);
    if (is_whole && display->maximum && !self->is_stale)
        draw_maximum(self, snapshot);
    if (display->marks)
        draw_marks(self, snapshot);
    gtk_snapshot_pop(snapshot);
}

/* The colours of lamps are for the ground that the theme has. */
static void app_view_css_changed(GtkWidget *widget, GtkCssStyleChange *change)
{
    GdkRGBA ink;
    GTK_WIDGET_CLASS(app_view_parent_class)->css_changed(widget, change);
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &ink);
    app_lamp_use_dark(ink.red + ink.green + ink.blue > 1.5f);
}

static void app_view_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    (void)width;
    (void)height;
    (void)baseline;
    fit_map(APP_VIEW(widget));
}

/* ---- the class ---- */

static void app_view_dispose(GObject *object)
{
    AppView *self = APP_VIEW(object);
    g_clear_object(&self->document);
    g_clear_object(&self->texture);
    g_clear_pointer(&self->picture, app_picture_unref);
    g_clear_pointer(&self->isophotes, luxel_isophotes_free);
    g_clear_pointer(&self->marks, g_array_unref);
    G_OBJECT_CLASS(app_view_parent_class)->dispose(object);
}

static void app_view_finalize(GObject *object)
{
    g_free(APP_VIEW(object)->hint);
    app_turn_free(APP_VIEW(object)->turn);
    g_array_unref(APP_VIEW(object)->chosen);
    G_OBJECT_CLASS(app_view_parent_class)->finalize(object);
}

static void app_view_class_init(AppViewClass *class)
{
    GtkWidgetClass *widget = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = app_view_dispose;
    G_OBJECT_CLASS(class)->finalize = app_view_finalize;
    widget->snapshot = app_view_snapshot;
    widget->size_allocate = app_view_size_allocate;
    widget->css_changed = app_view_css_changed;
    gtk_widget_class_set_css_name(widget, "luxelview");
    gtk_widget_class_set_accessible_role(widget, GTK_ACCESSIBLE_ROLE_IMG);
    signals[POINTED] = g_signal_new("pointed", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 3,
                                    G_TYPE_DOUBLE, G_TYPE_DOUBLE, G_TYPE_BOOLEAN);
    signals[SELECTED] = g_signal_new("selected", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2,
                                     G_TYPE_INT, G_TYPE_UINT);
    signals[SECTION_MOVED] = g_signal_new("section-moved", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                          G_TYPE_NONE, 2, G_TYPE_DOUBLE, G_TYPE_DOUBLE);
    signals[HOVERED] = g_signal_new("hovered", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2,
                                    G_TYPE_INT, G_TYPE_UINT);
    signals[TOGGLED] =
        g_signal_new("toggled", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_UINT);
    signals[MOVED] = g_signal_new("moved", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    signals[FRAMED] = g_signal_new("framed", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void app_view_init(AppView *self)
{
    GtkWidget *widget = GTK_WIDGET(self);
    self->marks = g_array_new(FALSE, TRUE, sizeof(AppMark));
    self->chosen = g_array_new(FALSE, FALSE, sizeof(gsize));
    self->surface = -1;
    self->is_fitted = TRUE;
    self->map.scale = 1;
    self->screen.high[0] = self->screen.high[1] = 1;
    gtk_widget_set_focusable(widget, TRUE);
    gtk_widget_set_hexpand(widget, TRUE);
    gtk_widget_set_vexpand(widget, TRUE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Picture"), -1);
    app_view_add_input(self);
}

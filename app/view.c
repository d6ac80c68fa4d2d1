/* SPDX-License-Identifier: MIT */
/* The widget: its picture, its zoom, and what the pointer, the wheel and the keys do on it. */
#include "view.h"

#include <math.h>
#include <string.h>

#include "../front/words.h"
#include "view_draw.h"

enum { MARGIN = 12, REACH = 12 /* pixels from a mark within which a press takes it */ };
static const double LEAST_ZOOM = 0.02, MOST_ZOOM = 200; /* of the fitted picture */

typedef enum Doing { DOING_NOTHING, DOING_MOVE, DOING_PAN } Doing;

struct _AppView {
    GtkWidget parent;
    AppDocument *document;
    AppPicture *picture;
    GdkTexture *texture;
    GArray *marks; /* of the picture's moment */
    luxel_isophotes *isophotes;
    gboolean section_shown;
    double section_mm[2];
    AppMarkKind selected_kind;
    gsize selected_index;
    gssize surface; /* under the pointer */
    gboolean is_fitted;
    AppArea screen;    /* that is fitted */
    AppMap map, told;  /* `told`: as it was when the last signal went out */
    double pointer[2]; /* in the widget */
    Doing doing;
    AppHand hand;
    double pan_start[2];
    double pinch; /* the scale that was zoomed by so far */
};

enum { POINTED, SELECTED, SECTION_MOVED, FRAMED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppView, app_view, GTK_TYPE_WIDGET)

/* ---- the map ---- */

static const luxel_field *field_of(const AppView *self)
{
    return self->picture ? self->picture->shot->field : NULL;
}

/* Tells when the map has become another. */
static void tell_frame(AppView *self)
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
    tell_frame(self);
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

/* Zooms so that what is at a place of the widget stays there. */
static void zoom_at(AppView *self, const double at[2], double factor)
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
    tell_frame(self);
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
    zoom_at(self, middle, factor);
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
    zoom_at(self, middle, wanted / self->map.scale);
    /* whole pixels on whole pixels */
    for (int k = 0; k < 2; k++)
        self->map.origin[k] = round(self->map.origin[k] * dots) / dots;
    tell_frame(self);
}

/* ---- what is shown ---- */

void app_view_set_document(AppView *self, AppDocument *document)
{
    g_set_object(&self->document, document);
}

void app_view_set_picture(AppView *self, AppPicture *picture)
{
    const gboolean is_new = !self->picture || !self->picture->shot || !picture->shot ||
                            self->picture->shot->moment != picture->shot->moment;
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
        self->marks = app_marks_of(picture->shot->moment, self->document);
    }
    fit_map(self);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_isophotes(AppView *self, luxel_isophotes *isophotes)
{
    luxel_isophotes_free(self->isophotes);
    self->isophotes = isophotes;
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_section(AppView *self, gboolean shown, const double section_mm[2])
{
    self->section_shown = shown;
    self->section_mm[0] = section_mm[0];
    self->section_mm[1] = section_mm[1];
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_select(AppView *self, AppMarkKind kind, gsize index)
{
    self->selected_kind = kind;
    self->selected_index = index;
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

void app_view_set_surface(AppView *self, gssize surface)
{
    self->surface = surface;
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
    gtk_snapshot_append_texture(snapshot, self->texture, &area);
    const gboolean live = self->picture->side == APP_SIDE_LIVE; /* which isophotes and maximum are of */
    if (live && display->isophotes && self->isophotes)
        app_draw_isophotes(snapshot, &self->map, self->isophotes,
                           &GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height));
    if (display->marks && self->section_shown)
        app_draw_section(snapshot, &self->map, self->section_mm, width, height);
    if (live && display->maximum)
        app_draw_maximum(snapshot, widget, &self->map, &luxel_field_statistics(self->picture->shot->field)->maximum);
    for (guint i = 0; i < self->marks->len && display->marks; i++) {
        const AppMark *mark = &g_array_index(self->marks, AppMark, i);
        app_draw_mark(snapshot, widget, &self->map, mark,
                      mark->kind == self->selected_kind && mark->index == self->selected_index);
    }
    gtk_snapshot_pop(snapshot);
}

static void app_view_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    (void)width;
    (void)height;
    (void)baseline;
    fit_map(APP_VIEW(widget));
}

/* ---- taking hold ---- */

/* The mark within reach of a place of the widget that is nearest; points and sources before surfaces. */
static gboolean mark_at(const AppView *self, const double at[2], AppMark *found)
{
    double best = REACH * REACH;
    gboolean any = FALSE;
    if (!self->picture || !self->picture->display.marks)
        return FALSE;
    for (guint i = 0; i < self->marks->len; i++) {
        const AppMark *mark = &g_array_index(self->marks, AppMark, i);
        double shown[2], angle;
        if (mark->kind == APP_MARK_SURFACE)
            continue;
        app_mark_shown(&self->map, mark, gtk_widget_get_width(GTK_WIDGET(self)),
                       gtk_widget_get_height(GTK_WIDGET(self)), shown, &angle);
        double apart = (shown[0] - at[0]) * (shown[0] - at[0]) + (shown[1] - at[1]) * (shown[1] - at[1]);
        if (apart <= best) {
            best = apart;
            *found = *mark;
            any = TRUE;
        }
    }
    return any;
}

static gboolean section_at(const AppView *self, const double at[2], AppMark *found)
{
    double line[2];
    if (!self->section_shown || !self->picture || !self->picture->display.marks)
        return FALSE;
    app_map_to_widget(&self->map, self->section_mm, line);
    gboolean by_x = fabs(at[0] - line[0]) < REACH / 2, by_y = fabs(at[1] - line[1]) < REACH / 2;
    *found = (AppMark){.kind = APP_MARK_SECTION, .index = by_x && by_y ? 0 : by_y ? 1 : 2};
    return by_x || by_y;
}

static gboolean surface_at(const AppView *self, AppMark *found)
{
    for (guint i = 0; i < self->marks->len && self->surface >= 0; i++) {
        const AppMark *mark = &g_array_index(self->marks, AppMark, i);
        if (mark->kind == APP_MARK_SURFACE && mark->index == (gsize)self->surface) {
            *found = *mark;
            return TRUE;
        }
    }
    return FALSE;
}

static gboolean what_is_at(const AppView *self, const double at[2], AppMark *found)
{
    return mark_at(self, at, found) || section_at(self, at, found) || surface_at(self, found);
}

static void select_mark(AppView *self, const AppMark *mark)
{
    app_view_select(self, mark->kind, mark->index);
    g_signal_emit(self, signals[SELECTED], 0, (int)mark->kind, (guint)mark->index);
}

static void take(AppView *self, const AppMark *mark, const double at[2])
{
    double pointer[2], shown_at[2], shown[2], angle;
    app_map_from_widget(&self->map, at, pointer);
    app_mark_shown(&self->map, mark, gtk_widget_get_width(GTK_WIDGET(self)), gtk_widget_get_height(GTK_WIDGET(self)),
                   shown_at, &angle);
    app_map_from_widget(&self->map, shown_at, shown);
    app_hand_take(&self->hand, mark, pointer, shown);
    self->doing = DOING_MOVE;
    app_document_begin_gesture(self->document);
    if (mark->kind != APP_MARK_SECTION)
        select_mark(self, mark);
}

static void move_section(AppView *self, const AppTouch *touch)
{
    double place[2] = {self->section_mm[0], self->section_mm[1]};
    double grain = pow(10, floor(log10(touch->mm_per_pixel))) * (touch->snap ? 10 : 1);
    for (int k = 0; k < 2; k++)
        if (self->hand.mark.index == 0 || self->hand.mark.index == (k == 0 ? 2 : 1))
            place[k] = round(touch->pointer_mm[k] / grain) * grain;
    g_signal_emit(self, signals[SECTION_MOVED], 0, place[0], place[1]);
}

static void drag_begin(GtkGestureDrag *gesture, double x, double y, AppView *self)
{
    const double at[2] = {x, y};
    const guint button = gtk_gesture_single_get_current_button(GTK_GESTURE_SINGLE(gesture));
    AppMark mark;
    gtk_widget_grab_focus(GTK_WIDGET(self));
    if (!self->picture || !self->picture->shot || !self->document)
        return;
    if (button == GDK_BUTTON_PRIMARY && what_is_at(self, at, &mark)) {
        take(self, &mark, at);
        return;
    }
    self->doing = DOING_PAN;
    self->pan_start[0] = self->map.origin[0];
    self->pan_start[1] = self->map.origin[1];
}

static void drag_update(GtkGestureDrag *gesture, double dx, double dy, AppView *self)
{
    double x, y, at[2];
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    gtk_gesture_drag_get_start_point(gesture, &x, &y);
    at[0] = x + dx;
    at[1] = y + dy;
    if (self->doing == DOING_PAN) {
        self->map.origin[0] = self->pan_start[0] + dx;
        self->map.origin[1] = self->pan_start[1] + dy;
        self->is_fitted = FALSE;
        tell_frame(self);
        gtk_widget_queue_draw(GTK_WIDGET(self));
    } else if (self->doing == DOING_MOVE) {
        AppTouch touch = {.mm_per_pixel = app_view_mm_per_pixel(self),
                          .fine = (state & GDK_SHIFT_MASK) != 0,
                          .snap = (state & GDK_CONTROL_MASK) != 0,
                          .height = (state & GDK_ALT_MASK) != 0};
        app_map_from_widget(&self->map, at, touch.pointer_mm);
        if (self->hand.mark.kind == APP_MARK_SECTION)
            move_section(self, &touch);
        else
            app_hand_move(&self->hand, &touch, self->picture->shot->moment, self->document);
    }
}

static void drag_end(GtkGestureDrag *gesture, double dx, double dy, AppView *self)
{
    (void)gesture;
    (void)dx;
    (void)dy;
    if (self->doing == DOING_MOVE)
        app_document_end_gesture(self->document);
    self->doing = DOING_NOTHING;
}

/* ---- pointer, wheel, keys ---- */

static void show_cursor(AppView *self, const double at[2])
{
    AppMark mark;
    const char *name = "default";
    if (section_at(self, at, &mark))
        name = mark.index == 0 ? "move" : mark.index == 1 ? "ns-resize" : "ew-resize";
    else if (self->picture && self->picture->shot && what_is_at(self, at, &mark))
        name = "grab";
    gtk_widget_set_cursor_from_name(GTK_WIDGET(self), name);
}

static void pointer_moved(GtkEventControllerMotion *controller, double x, double y, AppView *self)
{
    double place[2];
    (void)controller;
    self->pointer[0] = x;
    self->pointer[1] = y;
    app_map_from_widget(&self->map, self->pointer, place);
    if (self->doing == DOING_NOTHING)
        show_cursor(self, self->pointer);
    g_signal_emit(self, signals[POINTED], 0, place[0], place[1], TRUE);
}

static void pointer_left(GtkEventControllerMotion *controller, AppView *self)
{
    (void)controller;
    g_signal_emit(self, signals[POINTED], 0, 0.0, 0.0, FALSE);
}

/* Over a source the wheel lifts it, anywhere else it zooms. */
static gboolean scrolled(GtkEventControllerScroll *controller, double dx, double dy, AppView *self)
{
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(controller));
    AppMark mark;
    (void)dx;
    if (self->document && mark_at(self, self->pointer, &mark) && mark.kind == APP_MARK_SOURCE && !mark.is_distant) {
        const double step[3] = {0, 0, -dy * ((state & GDK_SHIFT_MASK) ? 1 : 10)};
        app_mark_shift(&mark, step, self->document);
        return TRUE;
    }
    zoom_at(self, self->pointer, exp(-0.15 * dy));
    return TRUE;
}

static void pinched(GtkGestureZoom *gesture, double scale, AppView *self)
{
    double at[2];
    gtk_gesture_get_bounding_box_center(GTK_GESTURE(gesture), &at[0], &at[1]);
    zoom_at(self, at, scale / self->pinch);
    self->pinch = scale;
}

static void pinch_begins(GtkGestureZoom *gesture, GdkEventSequence *sequence, AppView *self)
{
    (void)gesture;
    (void)sequence;
    self->pinch = 1;
}

static const AppMark *selected_mark(const AppView *self)
{
    for (guint i = 0; i < self->marks->len; i++) {
        const AppMark *mark = &g_array_index(self->marks, AppMark, i);
        if (mark->kind == self->selected_kind && mark->index == self->selected_index)
            return mark;
    }
    return NULL;
}

/* Brackets go from mark to mark. */
static void select_next(AppView *self, int step)
{
    const AppMark *present = selected_mark(self);
    if (self->marks->len == 0)
        return;
    const AppMark *first = &g_array_index(self->marks, AppMark, 0);
    int i = present ? (int)(present - first) + step : 0, count = (int)self->marks->len;
    select_mark(self, &g_array_index(self->marks, AppMark, (guint)((i % count + count) % count)));
}

static gboolean key_pressed(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                            AppView *self)
{
    static const struct {
        guint key;
        double step[3];
    } moves[] = {{GDK_KEY_Left, {-1, 0, 0}}, {GDK_KEY_Right, {1, 0, 0}},   {GDK_KEY_Up, {0, 1, 0}},
                 {GDK_KEY_Down, {0, -1, 0}}, {GDK_KEY_Page_Up, {0, 0, 1}}, {GDK_KEY_Page_Down, {0, 0, -1}}};
    (void)controller;
    (void)code;
    if (key == GDK_KEY_bracketleft || key == GDK_KEY_Cyrillic_ha)
        select_next(self, -1);
    else if (key == GDK_KEY_bracketright || key == GDK_KEY_Cyrillic_hardsign)
        select_next(self, 1);
    else if (key == GDK_KEY_plus || key == GDK_KEY_equal || key == GDK_KEY_KP_Add)
        app_view_zoom(self, 1.25);
    else if (key == GDK_KEY_minus || key == GDK_KEY_KP_Subtract)
        app_view_zoom(self, 0.8);
    else {
        const AppMark *mark = selected_mark(self);
        const double step = (state & GDK_SHIFT_MASK) ? 1 : (state & GDK_CONTROL_MASK) ? 100 : 10;
        for (gsize i = 0; i < G_N_ELEMENTS(moves); i++)
            if (moves[i].key == key && mark && self->document) {
                const double shift[3] = {moves[i].step[0] * step, moves[i].step[1] * step, moves[i].step[2] * step};
                app_mark_shift(mark, shift, self->document);
                return TRUE;
            }
        return FALSE;
    }
    return TRUE;
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

static void app_view_class_init(AppViewClass *class)
{
    GtkWidgetClass *widget = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = app_view_dispose;
    widget->snapshot = app_view_snapshot;
    widget->size_allocate = app_view_size_allocate;
    gtk_widget_class_set_css_name(widget, "luxelview");
    gtk_widget_class_set_accessible_role(widget, GTK_ACCESSIBLE_ROLE_IMG);
    signals[POINTED] = g_signal_new("pointed", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 3,
                                    G_TYPE_DOUBLE, G_TYPE_DOUBLE, G_TYPE_BOOLEAN);
    signals[SELECTED] = g_signal_new("selected", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2,
                                     G_TYPE_INT, G_TYPE_UINT);
    signals[SECTION_MOVED] = g_signal_new("section-moved", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                          G_TYPE_NONE, 2, G_TYPE_DOUBLE, G_TYPE_DOUBLE);
    signals[FRAMED] = g_signal_new("framed", APP_TYPE_VIEW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void add_drag(AppView *self, guint button)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(drag), button);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(drag_begin), self);
    g_signal_connect(drag, "drag-update", G_CALLBACK(drag_update), self);
    g_signal_connect(drag, "drag-end", G_CALLBACK(drag_end), self);
    gtk_widget_add_controller(GTK_WIDGET(self), GTK_EVENT_CONTROLLER(drag));
}

static void app_view_init(AppView *self)
{
    GtkWidget *widget = GTK_WIDGET(self);
    GtkEventController *motion = gtk_event_controller_motion_new(), *keys = gtk_event_controller_key_new();
    GtkEventController *wheel = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_BOTH_AXES);
    GtkGesture *pinch = gtk_gesture_zoom_new();
    self->marks = g_array_new(FALSE, TRUE, sizeof(AppMark));
    self->surface = -1;
    self->is_fitted = TRUE;
    self->map.scale = 1;
    self->screen.high[0] = self->screen.high[1] = 1;
    gtk_widget_set_focusable(widget, TRUE);
    gtk_widget_set_hexpand(widget, TRUE);
    gtk_widget_set_vexpand(widget, TRUE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Picture"), -1);
    add_drag(self, GDK_BUTTON_PRIMARY);
    add_drag(self, GDK_BUTTON_MIDDLE);
    g_signal_connect(motion, "motion", G_CALLBACK(pointer_moved), self);
    g_signal_connect(motion, "leave", G_CALLBACK(pointer_left), self);
    g_signal_connect(wheel, "scroll", G_CALLBACK(scrolled), self);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key_pressed), self);
    g_signal_connect(pinch, "begin", G_CALLBACK(pinch_begins), self);
    g_signal_connect(pinch, "scale-changed", G_CALLBACK(pinched), self);
    gtk_widget_add_controller(widget, motion);
    gtk_widget_add_controller(widget, wheel);
    gtk_widget_add_controller(widget, keys);
    gtk_widget_add_controller(widget, GTK_EVENT_CONTROLLER(pinch));
}

/* SPDX-License-Identifier: MIT */
/* The hand on the view: what is taken hold of, what the pointer finds, what wheel, keys and fingers do. */
#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/number.h"
#include "../base/touch.h"
#include "view_private.h"

enum {
    REACH = 12, /* pixels from a mark within which a press takes it */
    STILL = 4   /* within which a press is no drag */
};

/* ---- taking hold ---- */

/* The mark within reach of a place of the widget that is nearest; points and sources before surfaces. */
static gboolean mark_at(const AppView *self, const double at[2], AppMark *found)
{
    const int reach = app_touch_reach((GtkWidget *)self, REACH);
    double best = reach * reach;
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
    const int reach = app_touch_reach((GtkWidget *)self, REACH) / 2;
    gboolean by_x = fabs(at[0] - line[0]) < reach, by_y = fabs(at[1] - line[1]) < reach;
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

/* Marks of the pinned picture are of what was: only those of the document can be moved. */
static gboolean what_is_at(const AppView *self, const double at[2], AppMark *found)
{
    if (self->picture && self->picture->side == APP_SIDE_PINNED)
        return section_at(self, at, found);
    return mark_at(self, at, found) || section_at(self, at, found) || surface_at(self, found);
}

static void select_mark(AppView *self, const AppMark *mark)
{
    app_view_select(self, mark->kind, mark->index);
    g_signal_emit_by_name(self, "selected", (int)mark->kind, (guint)mark->index);
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
    self->was_chosen = app_view_is_chosen(self, mark);
    g_clear_pointer(&self->turn, app_turn_free);
    self->turn = self->was_chosen ? app_turn_begin(self->document, self->chosen, mark->index) : NULL;
    self->has_moved = FALSE;
    if (mark->kind != APP_MARK_SECTION && !self->was_chosen && !self->is_toggling)
        select_mark(self, mark);
}

/* Moves the other chosen sources as far as one of them was; light from far away turns as one of it does. */
static void move_others(AppView *self, const AppMark *moved, const double step[3], const AppTurn *turn)
{
    app_turn_follow(turn, self->document);
    if (moved->is_distant)
        return;
    for (guint i = 0; i < self->marks->len; i++) {
        const AppMark *mark = &g_array_index(self->marks, AppMark, i);
        if (app_view_is_chosen(self, mark) && mark->index != moved->index && !mark->is_distant)
            app_mark_shift(mark, step, self->document);
    }
}

/* Shifts a mark, and with a chosen source the others, as one step of undo. */
static void shift(AppView *self, const AppMark *mark, const double step[3])
{
    const gboolean several = app_view_is_chosen(self, mark);
    g_autoptr(AppTurn) turn = several ? app_turn_begin(self->document, self->chosen, mark->index) : NULL;
    app_document_set_topic(self->document, several ? "lights" : NULL);
    app_mark_shift(mark, step, self->document);
    if (several)
        move_others(self, mark, step, turn);
    app_document_set_topic(self->document, NULL);
}

/* As the hand does; FALSE where that is not possible. */
static gboolean move_mark(AppView *self, const AppTouch *touch)
{
    const gboolean several = app_view_is_chosen(self, &self->hand.mark);
    double step[3];
    memcpy(step, self->hand.mark.place_mm, sizeof step);
    app_document_set_topic(self->document, several ? "lights" : NULL);
    const gboolean done = app_hand_move(&self->hand, touch, self->picture->shot->moment, self->document);
    for (int k = 0; k < 3; k++)
        step[k] = self->hand.mark.place_mm[k] - step[k];
    if (done && several)
        move_others(self, &self->hand.mark, step, self->turn);
    app_document_set_topic(self->document, NULL);
    return done;
}

/* A press with Ctrl or Shift that becomes a drag is one: it chooses nothing but what it moves. */
static void begin_to_move(AppView *self)
{
    if (self->is_toggling && !self->was_chosen)
        select_mark(self, &self->hand.mark);
    self->is_toggling = FALSE;
    self->has_moved = TRUE;
}

static void move_section(AppView *self, const AppTouch *touch)
{
    double place[2] = {self->section_mm[0], self->section_mm[1]};
    double grain = pow(10, floor(log10(touch->mm_per_pixel))) * (touch->snap ? 10 : 1);
    for (int k = 0; k < 2; k++)
        if (self->hand.mark.index == 0 || self->hand.mark.index == (k == 0 ? 2 : 1))
            place[k] = round(touch->pointer_mm[k] / grain) * grain;
    g_signal_emit_by_name(self, "section-moved", place[0], place[1]);
}

/* A surface is everywhere: one is moved that was chosen before, and a room, in which one stands, never. */
static gboolean can_take(const AppView *self, const AppMark *mark)
{
    if (mark->kind != APP_MARK_SURFACE)
        return TRUE;
    char *key = g_strdup_printf("surfaces[%zu].type", mark->index), *type = app_document_get(self->document, key, NULL);
    const gboolean is_room = g_strcmp0(type, "room") == 0;
    g_free(type);
    g_free(key);
    return !is_room && self->selected_kind == APP_MARK_SURFACE && self->selected_index == mark->index;
}

static void drag_begin(GtkGestureDrag *gesture, double x, double y, AppView *self)
{
    const double at[2] = {x, y};
    const guint button = gtk_gesture_single_get_current_button(GTK_GESTURE_SINGLE(gesture));
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    AppMark mark;
    gtk_widget_grab_focus(GTK_WIDGET(self));
    if (!self->picture || !self->picture->shot || !self->document)
        return;
    self->pressed.kind = APP_MARK_NONE;
    self->has_moved = FALSE;
    const gboolean is_thing = button == GDK_BUTTON_PRIMARY && what_is_at(self, at, &mark);
    if (is_thing && can_take(self, &mark)) {
        self->is_toggling = mark.kind == APP_MARK_SOURCE && (state & (GDK_CONTROL_MASK | GDK_SHIFT_MASK));
        take(self, &mark, at);
        return;
    }
    if (is_thing)
        self->pressed = mark;
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
    if (!self->has_moved && hypot(dx, dy) < STILL) /* a hand that clicks is never quite still */
        return;
    if (self->doing == DOING_PAN) {
        self->has_moved = TRUE;
        self->map.origin[0] = self->pan_start[0] + dx;
        self->map.origin[1] = self->pan_start[1] + dy;
        self->is_fitted = FALSE;
        app_view_tell_frame(self);
        gtk_widget_queue_draw(GTK_WIDGET(self));
    } else if (self->doing == DOING_MOVE) {
        begin_to_move(self);
        AppTouch touch = {.mm_per_pixel = app_view_mm_per_pixel(self),
                          .fine = (state & GDK_SHIFT_MASK) != 0,
                          .snap = (state & GDK_CONTROL_MASK) != 0,
                          .height = (state & GDK_ALT_MASK) != 0};
        app_map_from_widget(&self->map, at, touch.pointer_mm);
        if (self->hand.mark.kind == APP_MARK_SECTION)
            move_section(self, &touch);
        else if (move_mark(self, &touch))
            g_signal_emit_by_name(self, "moved");
    }
}

void app_view_let_go(AppView *self)
{
    if (self->doing == DOING_MOVE)
        app_document_end_gesture(self->document);
    g_clear_pointer(&self->turn, app_turn_free);
    self->doing = DOING_NOTHING;
    self->is_toggling = FALSE;
    self->pressed.kind = APP_MARK_NONE;
}

static void drag_end(GtkGestureDrag *gesture, double dx, double dy, AppView *self)
{
    const gboolean is_click = self->doing == DOING_MOVE && !self->has_moved;
    (void)gesture;
    (void)dx;
    (void)dy;
    if (is_click && self->is_toggling)
        g_signal_emit_by_name(self, "toggled", (guint)self->hand.mark.index);
    else if (is_click && self->was_chosen)
        select_mark(self, &self->hand.mark);
    else if (self->doing == DOING_PAN && !self->has_moved && self->pressed.kind != APP_MARK_NONE)
        select_mark(self, &self->pressed);
    app_view_let_go(self);
}

/* ---- pointer, wheel, keys ---- */

static const AppMark *selected_mark(const AppView *self)
{
    for (guint i = 0; i < self->marks->len; i++) {
        const AppMark *mark = &g_array_index(self->marks, AppMark, i);
        if (mark->kind == self->selected_kind && mark->index == self->selected_index)
            return mark;
    }
    return NULL;
}

static void show_cursor(AppView *self, const double at[2])
{
    AppMark mark;
    const char *name = "default";
    if (section_at(self, at, &mark))
        name = mark.index == 0 ? "move" : mark.index == 1 ? "ns-resize" : "ew-resize";
    else if (self->picture && self->picture->shot && what_is_at(self, at, &mark) && can_take(self, &mark))
        name = "grab";
    gtk_widget_set_cursor_from_name(GTK_WIDGET(self), name);
}

/* The mark under the pointer is lit up, here and by whoever listens in its list. */
static void tell_hovered(AppView *self)
{
    AppMark mark = {.kind = APP_MARK_NONE};
    mark_at(self, self->pointer, &mark);
    if (mark.kind == self->hovered_kind && mark.index == self->hovered_index)
        return;
    app_view_hover(self, mark.kind, mark.index);
    g_signal_emit_by_name(self, "hovered", (int)mark.kind, (guint)mark.index);
}

/* "2 fill" and where it is; of distant light where it comes from. */
static gboolean query_tooltip(AppView *self, int x, int y, gboolean by_keys, GtkTooltip *tooltip)
{
    const double at[2] = {x, y};
    AppMark mark;
    char n[3][APP_NUMBER_SIZE];
    if (by_keys || !mark_at(self, at, &mark))
        return FALSE;
    const double size = mark.is_distant ? 1 : 1e4;
    for (int k = 0; k < 3; k++)
        app_number_place(mark.place_mm[k], size, n[k]);
    char *text = mark.kind == APP_MARK_POINT ? g_strdup_printf(_("Point %s\nx %s, y %s mm"), mark.label, n[0], n[1])
                 : mark.is_distant ? g_strdup_printf(_("Source %s\nlight from the direction %s, %s, %s"), mark.label,
                                                     n[0], n[1], n[2])
                                   : g_strdup_printf(_("Source %s\nx %s, y %s, z %s mm"), mark.label, n[0], n[1], n[2]);
    char *whole = mark.kind == APP_MARK_SOURCE && !mark.is_on ? g_strconcat(text, "\n", _("off"), NULL) : NULL;
    gtk_tooltip_set_text(tooltip, whole ? whole : text);
    g_free(whole);
    g_free(text);
    return TRUE;
}

static void pointer_moved(GtkEventControllerMotion *controller, double x, double y, AppView *self)
{
    double place[2];
    (void)controller;
    self->pointer[0] = x;
    self->pointer[1] = y;
    app_map_from_widget(&self->map, self->pointer, place);
    if (self->doing == DOING_NOTHING) {
        show_cursor(self, self->pointer);
        tell_hovered(self);
    }
    g_signal_emit_by_name(self, "pointed", place[0], place[1], TRUE);
}

static void pointer_left(GtkEventControllerMotion *controller, AppView *self)
{
    (void)controller;
    app_view_hover(self, APP_MARK_NONE, 0);
    g_signal_emit_by_name(self, "hovered", (int)APP_MARK_NONE, 0u);
    g_signal_emit_by_name(self, "pointed", 0.0, 0.0, FALSE);
}

/* The source that Alt and the wheel lift: the one under the pointer, or else the chosen one. */
static gboolean source_to_lift(const AppView *self, AppMark *found)
{
    const AppMark *chosen = selected_mark(self);
    if (!self->picture || self->picture->side == APP_SIDE_PINNED)
        return FALSE;
    if (mark_at(self, self->pointer, found) && found->kind == APP_MARK_SOURCE)
        return !found->is_distant;
    if (!chosen || chosen->kind != APP_MARK_SOURCE || chosen->is_distant)
        return FALSE;
    *found = *chosen;
    return TRUE;
}

/* The wheel zooms, whatever is under it; with Alt it lifts a source, which is the chosen one from then on. */
static gboolean scrolled(GtkEventControllerScroll *controller, double dx, double dy, AppView *self)
{
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(controller));
    AppMark mark;
    (void)dx;
    if (!(state & GDK_ALT_MASK))
        app_view_zoom_at(self, self->pointer, exp(-0.15 * dy));
    else if (self->document && source_to_lift(self, &mark)) {
        const double step[3] = {0, 0, -dy * ((state & GDK_SHIFT_MASK) ? 1 : 10)};
        shift(self, &mark, step);
        if (app_view_is_chosen(self, &mark))
            return TRUE;
        if (mark.index != self->selected_index || self->selected_kind != APP_MARK_SOURCE)
            select_mark(self, &mark);
    }
    return TRUE;
}

static void pinched(GtkGestureZoom *gesture, double scale, AppView *self)
{
    double at[2];
    gtk_gesture_get_bounding_box_center(GTK_GESTURE(gesture), &at[0], &at[1]);
    app_view_zoom_at(self, at, scale / self->pinch);
    self->pinch = scale;
}

static void pinch_begins(GtkGestureZoom *gesture, GdkEventSequence *sequence, AppView *self)
{
    (void)gesture;
    (void)sequence;
    self->pinch = 1;
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
                const double way[3] = {moves[i].step[0] * step, moves[i].step[1] * step, moves[i].step[2] * step};
                shift(self, mark, way);
                return TRUE;
            }
        return FALSE;
    }
    return TRUE;
}

/* ---- all of them ---- */

static void add_drag(AppView *self, guint button)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(drag), button);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(drag_begin), self);
    g_signal_connect(drag, "drag-update", G_CALLBACK(drag_update), self);
    g_signal_connect(drag, "drag-end", G_CALLBACK(drag_end), self);
    gtk_widget_add_controller(GTK_WIDGET(self), GTK_EVENT_CONTROLLER(drag));
}

void app_view_add_input(AppView *self)
{
    GtkWidget *widget = GTK_WIDGET(self);
    GtkEventController *motion = gtk_event_controller_motion_new(), *keys = gtk_event_controller_key_new();
    GtkEventController *wheel = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_BOTH_AXES);
    GtkGesture *pinch = gtk_gesture_zoom_new();
    add_drag(self, GDK_BUTTON_PRIMARY);
    add_drag(self, GDK_BUTTON_MIDDLE);
    gtk_widget_set_has_tooltip(widget, TRUE);
    g_signal_connect(widget, "query-tooltip", G_CALLBACK(query_tooltip), NULL);
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

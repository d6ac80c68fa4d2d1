/* SPDX-License-Identifier: MIT */
/* The widget: whose scene it shows, how it is looked at, and the hand on it. */
#include "space_view.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/touch.h"
#include "space_view_private.h"

enum { REACH = 16, STILL = 4 /* within which a press is no drag */, EDGE = 18, STEP = 15 /* dots of a turn by keys */ };

enum { POINTED, PRESSED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppSpaceView, app_space_view, GTK_TYPE_WIDGET)

/* ---- what it shows ---- */

const AppOrbit *app_space_view_orbit(const AppSpaceView *self)
{
    const gboolean fits = self->lit && self->lit->moment && self->lit->orbit.width == self->orbit.width &&
                          self->lit->orbit.height == self->orbit.height;
    return fits ? &self->lit->orbit : &self->orbit;
}

static void lit_came(AppLit *lit, gpointer owner)
{
    AppSpaceView *self = owner;
    if (!self->picture) /* the scene went meanwhile */
        return;
    app_lit_unref(self->lit);
    g_clear_object(&self->texture);
    self->lit = app_lit_ref(lit);
    if (lit->moment) {
        GBytes *bytes = g_bytes_new_with_free_func(lit->pixels, sizeof *lit->pixels * lit->columns * lit->rows,
                                                   (GDestroyNotify)app_lit_unref, app_lit_ref(lit));
        self->texture = gdk_memory_texture_new((int)lit->columns, (int)lit->rows, GDK_MEMORY_DEFAULT, bytes,
                                               sizeof *lit->pixels * lit->columns);
        g_bytes_unref(bytes);
    }
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

/* What nobody sees is not computed. */
static void ask(AppSpaceView *self)
{
    if (!self->picture || !self->space || !(self->orbit.scale > 0) || !gtk_widget_get_mapped(GTK_WIDGET(self)))
        return;
    if (!self->lighter)
        self->lighter = app_lighter_new(lit_came, self);
    const AppShot *shot = self->picture->shot;
    const double pixels = (double)luxel_field_columns(shot->field) * luxel_field_rows(shot->field);
    const AppLitWish wish = {.moment = shot->moment,
                             .orbit = self->orbit,
                             .dots = gtk_widget_get_scale_factor(GTK_WIDGET(self)),
                             .quantity = luxel_field_quantity(shot->field),
                             .display = self->picture->display,
                             .low = self->picture->low,
                             .high = self->picture->high,
                             .seconds = shot->moment->direct ? 0 : shot->seconds / pixels};
    app_lighter_ask(self->lighter, &wish);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

/* The scene is looked at as it begins, or as somebody left it. */
static void place(AppSpaceView *self)
{
    AppOrbit *orbit = &self->orbit;
    orbit->width = gtk_widget_get_width(GTK_WIDGET(self));
    orbit->height = gtk_widget_get_height(GTK_WIDGET(self));
    if (self->space && !self->is_own && orbit->width > 0 && self->doing == APP_SPACE_RESTS)
        (orbit->scale > 0 ? app_orbit_fit : app_orbit_begin)(orbit, self->picture->shot->moment->scene, self->space);
}

static void read_space(AppSpaceView *self)
{
    if (self->space || !self->picture || !gtk_widget_get_mapped(GTK_WIDGET(self)))
        return;
    const gboolean is_first = !(self->orbit.scale > 0);
    self->space = app_space_new(self->picture->shot->moment, NULL);
    if (is_first)
        place(self);
    ask(self);
}

/* What was held is let go. */
static void let_go(AppSpaceView *self)
{
    if (self->doing == APP_SPACE_MOVES)
        app_sight_let_go(&self->sight);
    self->doing = APP_SPACE_RESTS;
}

void app_space_view_set_picture(AppSpaceView *self, AppPicture *picture)
{
    AppPicture *before = self->picture;
    const gboolean is_same = before && picture && before->shot->moment == picture->shot->moment;
    const gboolean is_repainted = !is_same || before->low != picture->low || before->high != picture->high ||
                                  memcmp(&before->display, &picture->display, sizeof before->display) != 0;
    self->picture = picture ? app_picture_ref(picture) : NULL;
    app_picture_unref(before);
    if (!picture) {
        let_go(self);
        g_clear_pointer(&self->lit, app_lit_unref);
        g_clear_object(&self->texture);
        self->is_own = self->sight.has_place = FALSE;
        self->orbit.scale = 0;
    }
    if (!is_same)
        g_clear_pointer(&self->space, app_space_free);
    if (!self->space)
        read_space(self);
    else if (is_repainted)
        ask(self);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

AppSight *app_space_view_sight(AppSpaceView *self)
{
    return &self->sight;
}

/* ---- how it is looked at ---- */

void app_space_view_fit(AppSpaceView *self)
{
    if (!self->space)
        return;
    self->is_own = FALSE;
    app_orbit_fit(&self->orbit, self->picture->shot->moment->scene, self->space);
    ask(self);
}

void app_space_view_front(AppSpaceView *self)
{
    app_orbit_front(&self->orbit);
    self->is_own = TRUE;
    ask(self);
}

static void zoom_at(AppSpaceView *self, const double at[2], double factor)
{
    if (!(self->orbit.scale > 0))
        return;
    app_orbit_zoom(&self->orbit, at, factor);
    self->is_own = TRUE;
    ask(self);
}

void app_space_view_zoom(AppSpaceView *self, double factor)
{
    const double middle[2] = {self->orbit.width / 2, self->orbit.height / 2};
    zoom_at(self, middle, factor);
}

/* ---- where things are ---- */

gboolean app_space_view_mark(const AppSpaceView *self, const AppThing *thing, double at[3], double *angle)
{
    const AppOrbit *orbit = app_space_view_orbit(self);
    const double middle[2] = {orbit->width / 2, orbit->height / 2};
    app_orbit_see(orbit, thing->at_mm, at);
    const double out[2] = {at[0] - middle[0], at[1] - middle[1]};
    const double share =
        MIN((middle[0] - EDGE) / MAX(fabs(out[0]), 1e-9), (middle[1] - EDGE) / MAX(fabs(out[1]), 1e-9));
    *angle = atan2(out[1], out[0]);
    for (int k = 0; k < 2 && share < 1; k++)
        at[k] = middle[k] + share * out[k];
    return share < 1;
}

/* What is grabbed before what is as near. */
static int rank(AppThingKind kind)
{
    return kind == APP_THING_LAMP || kind == APP_THING_DIRECTION ? 2 : kind == APP_THING_AIM ? 1 : 0;
}

static gboolean thing_at(const AppSpaceView *self, double x, double y, AppThing *found)
{
    const double reach = app_touch_reach((GtkWidget *)self, REACH);
    double best = reach, angle;
    found->kind = APP_THING_NONE;
    for (guint i = 0; self->space && i < self->space->things->len; i++) {
        const AppThing *thing = &g_array_index(self->space->things, AppThing, i);
        double at[3];
        if (thing->kind == APP_THING_SURFACE)
            continue;
        if (app_space_view_mark(self, thing, at, &angle) && thing->kind != APP_THING_LAMP)
            continue;
        const double apart = hypot(at[0] - x, at[1] - y) - 2 * rank(thing->kind);
        if (apart < best && hypot(at[0] - x, at[1] - y) < reach) {
            best = apart;
            *found = *thing;
        }
    }
    return found->kind != APP_THING_NONE;
}

/* The point of the observer's screen at which the place of a body under the pointer is; FALSE: none is there. */
static gboolean screen_at(const AppSpaceView *self, double x, double y, double screen_mm[2])
{
    const double depth = self->lit && self->lit->moment ? app_lit_depth(self->lit, x, y) : 0, seen[3] = {x, y, depth};
    double at[3];
    if (!(depth > 0))
        return FALSE;
    app_orbit_place(&self->lit->orbit, seen, at);
    return luxel_scene_project(self->lit->moment->scene, at, screen_mm);
}

/* ---- the hand ---- */

static void tell_pointed(AppSpaceView *self, gboolean inside, const double screen_mm[2])
{
    if (inside || self->was_inside)
        g_signal_emit(self, signals[POINTED], 0, screen_mm[0], screen_mm[1], inside);
    self->was_inside = inside;
}

static void pointer_moved(GtkEventControllerMotion *controller, double x, double y, AppSpaceView *self)
{
    AppThing thing;
    double screen_mm[2] = {0, 0};
    (void)controller;
    self->pointer[0] = x;
    self->pointer[1] = y;
    if (self->doing != APP_SPACE_RESTS)
        return;
    const gboolean is_thing = thing_at(self, x, y, &thing);
    const gboolean is_place = !is_thing && !self->sight.is_stale && screen_at(self, x, y, screen_mm);
    gtk_widget_set_cursor_from_name(GTK_WIDGET(self), is_thing ? "grab" : is_place ? "crosshair" : "default");
    app_sight_point(&self->sight, &thing);
    tell_pointed(self, is_place, screen_mm);
}

static void pointer_left(GtkEventControllerMotion *controller, AppSpaceView *self)
{
    static const AppThing none = {.kind = APP_THING_NONE};
    static const double nowhere[2] = {0, 0};
    (void)controller;
    if (self->doing != APP_SPACE_RESTS)
        return;
    app_sight_point(&self->sight, &none);
    tell_pointed(self, FALSE, nowhere);
}

static void take(AppSpaceView *self, const AppThing *thing, GdkModifierType state)
{
    double seen[3];
    self->doing = APP_SPACE_MOVES;
    app_orbit_see(app_space_view_orbit(self), thing->at_mm, seen);
    self->pixel_mm = app_orbit_pixel(app_space_view_orbit(self), seen[2]);
    app_sight_take(&self->sight, thing, state);
}

/* The size of a dot of the view where the hand is: at the thing or the body that it presses, else in the middle. */
static double pixel_at(const AppSpaceView *self, double x, double y)
{
    const AppOrbit *orbit = app_space_view_orbit(self);
    double seen[3] = {x, y, self->lit ? app_lit_depth(self->lit, x, y) : 0}, angle;
    AppThing thing;
    if (thing_at(self, x, y, &thing) && app_space_view_mark(self, &thing, seen, &angle))
        seen[2] = 0; /* which is elsewhere, and has an arrow there */
    return app_orbit_pixel(orbit, seen[2] > 0 ? seen[2] : orbit->distance_mm);
}

static void drag_begin(GtkGestureDrag *gesture, double x, double y, AppSpaceView *self)
{
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    const gboolean is_first = gtk_gesture_single_get_current_button(GTK_GESTURE_SINGLE(gesture)) == GDK_BUTTON_PRIMARY;
    AppThing thing;
    gtk_widget_grab_focus(GTK_WIDGET(self));
    self->sight.has_moved = FALSE;
    self->last[0] = self->last[1] = 0;
    if (is_first && !self->sight.is_stale && thing_at(self, x, y, &thing))
        take(self, &thing, state);
    else {
        self->doing = is_first ? APP_SPACE_TURNS : APP_SPACE_PANS;
        self->pixel_mm = pixel_at(self, x, y);
    }
}

static void drag_update(GtkGestureDrag *gesture, double dx, double dy, AppSpaceView *self)
{
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    const AppOrbit *orbit = app_space_view_orbit(self);
    const double gain = self->pixel_mm * ((state & GDK_SHIFT_MASK) ? 0.1 : 1),
                 way[2] = {dx - self->last[0], dy - self->last[1]};
    double to[3];
    if (self->doing == APP_SPACE_RESTS || (!self->sight.has_moved && hypot(dx, dy) < STILL))
        return;
    self->sight.has_moved = TRUE;
    self->last[0] = dx;
    self->last[1] = dy;
    if (self->doing != APP_SPACE_MOVES) {
        const double dots = self->doing == APP_SPACE_TURNS ? 1 : self->pixel_mm * self->orbit.scale;
        (self->doing == APP_SPACE_TURNS ? app_orbit_turn : app_orbit_pan)(&self->orbit, dots * way[0], dots * way[1]);
        self->is_own = TRUE;
        ask(self);
        return;
    }
    for (int k = 0; k < 3; k++)
        to[k] = self->sight.start_mm[k] + gain * (dx * orbit->right[k] - dy * orbit->up[k]);
    app_sight_move(&self->sight, NULL, to, self->pixel_mm, state);
}

static void drag_end(GtkGestureDrag *gesture, double dx, double dy, AppSpaceView *self)
{
    const AppSpaceDoing doing = self->doing;
    double x, y, screen_mm[2];
    (void)dx;
    (void)dy;
    let_go(self);
    if (self->sight.has_moved)
        return;
    if (doing == APP_SPACE_MOVES)
        app_sight_click(&self->sight);
    else if (doing == APP_SPACE_TURNS && gtk_gesture_drag_get_start_point(gesture, &x, &y) &&
             screen_at(self, x, y, screen_mm))
        g_signal_emit(self, signals[PRESSED], 0, screen_mm[0], screen_mm[1]);
}

static gboolean scrolled(GtkEventControllerScroll *controller, double dx, double dy, AppSpaceView *self)
{
    (void)controller;
    (void)dx;
    zoom_at(self, self->pointer, exp(-0.15 * dy));
    return TRUE;
}

static void pinch_begin(GtkGesture *gesture, GdkEventSequence *sequence, AppSpaceView *self)
{
    (void)gesture;
    (void)sequence;
    let_go(self);
    self->pinch = 1;
}

static void pinched(GtkGestureZoom *gesture, double scale, AppSpaceView *self)
{
    double at[2];
    if (gtk_gesture_get_bounding_box_center(GTK_GESTURE(gesture), &at[0], &at[1]))
        zoom_at(self, at, scale / self->pinch);
    self->pinch = scale;
}

static gboolean key_pressed(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                            AppSpaceView *self)
{
    const int x = key == GDK_KEY_Left ? -STEP : key == GDK_KEY_Right ? STEP : 0;
    const int y = key == GDK_KEY_Up ? -STEP : key == GDK_KEY_Down ? STEP : 0;
    (void)controller;
    (void)code;
    if (key == GDK_KEY_Home)
        app_space_view_front(self);
    else if ((x || y) && !(state & (GDK_CONTROL_MASK | GDK_ALT_MASK))) {
        app_orbit_turn(&self->orbit, x, y);
        self->is_own = TRUE;
        ask(self);
    } else
        return FALSE;
    return TRUE;
}

static gboolean query_tooltip(AppSpaceView *self, int x, int y, gboolean by_keys, GtkTooltip *tooltip)
{
    AppThing thing;
    return !by_keys && self->doing == APP_SPACE_RESTS && thing_at(self, x, y, &thing) &&
           app_sight_tell(&thing, tooltip);
}

/* ---- the class ---- */

/* Around the scene it is a little lighter above than below. */
static void append_backdrop(GtkWidget *widget, GtkSnapshot *snapshot, const graphene_rect_t *area)
{
    static const GdkRGBA light[2] = {{0.855f, 0.851f, 0.839f, 1}, {0.741f, 0.737f, 0.725f, 1}},
                         dark[2] = {{0.165f, 0.173f, 0.188f, 1}, {0.075f, 0.078f, 0.086f, 1}};
    GdkRGBA ink;
    gtk_style_context_get_color(gtk_widget_get_style_context(widget), &ink);
    const GdkRGBA *colors = ink.red + ink.green + ink.blue > 1.5f ? dark : light;
    const GskColorStop stops[] = {{0, colors[0]}, {1, colors[1]}};
    gtk_snapshot_append_linear_gradient(snapshot, area, &area->origin,
                                        &GRAPHENE_POINT_INIT(0, area->origin.y + area->size.height), stops, 2);
}

static void app_space_view_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    AppSpaceView *self = APP_SPACE_VIEW(widget);
    const float width = (float)gtk_widget_get_width(widget), height = (float)gtk_widget_get_height(widget);
    const graphene_rect_t area = GRAPHENE_RECT_INIT(0, 0, width, height);
    append_backdrop(widget, snapshot, &area);
    if (!self->space || !(self->orbit.scale > 0))
        return;
    if (self->sight.is_stale)
        gtk_snapshot_push_opacity(snapshot, 0.3);
    gtk_snapshot_push_clip(snapshot, &area);
    if (self->texture) {
        const float high = width * (float)self->lit->rows / (float)self->lit->columns;
        gtk_snapshot_append_texture(snapshot, self->texture, &GRAPHENE_RECT_INIT(0, (height - high) / 2, width, high));
    }
    cairo_t *cairo = gtk_snapshot_append_cairo(snapshot, &area);
    app_space_view_draw(self, cairo);
    cairo_destroy(cairo);
    gtk_snapshot_pop(snapshot);
    if (self->sight.is_stale)
        gtk_snapshot_pop(snapshot);
}

static void app_space_view_map(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(app_space_view_parent_class)->map(widget);
    read_space(APP_SPACE_VIEW(widget));
    ask(APP_SPACE_VIEW(widget));
}

static void app_space_view_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    AppSpaceView *self = APP_SPACE_VIEW(widget);
    (void)baseline;
    if (width == self->orbit.width && height == self->orbit.height)
        return;
    place(self);
    ask(self);
}

static void app_space_view_dispose(GObject *object)
{
    AppSpaceView *self = APP_SPACE_VIEW(object);
    g_clear_pointer(&self->lighter, app_lighter_free);
    g_clear_pointer(&self->lit, app_lit_unref);
    g_clear_object(&self->texture);
    g_clear_pointer(&self->space, app_space_free);
    g_clear_pointer(&self->picture, app_picture_unref);
    G_OBJECT_CLASS(app_space_view_parent_class)->dispose(object);
}

static void app_space_view_finalize(GObject *object)
{
    app_sight_clear(&APP_SPACE_VIEW(object)->sight);
    G_OBJECT_CLASS(app_space_view_parent_class)->finalize(object);
}

static void app_space_view_class_init(AppSpaceViewClass *class)
{
    GtkWidgetClass *widget = GTK_WIDGET_CLASS(class);
    const GType type = APP_TYPE_SPACE_VIEW;
    G_OBJECT_CLASS(class)->dispose = app_space_view_dispose;
    G_OBJECT_CLASS(class)->finalize = app_space_view_finalize;
    widget->snapshot = app_space_view_snapshot;
    widget->size_allocate = app_space_view_size_allocate;
    widget->map = app_space_view_map;
    gtk_widget_class_set_css_name(widget, "luxelspace");
    gtk_widget_class_set_accessible_role(widget, GTK_ACCESSIBLE_ROLE_IMG);
    app_sight_add_signals(type);
    signals[POINTED] = g_signal_new("pointed", type, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 3,
                                    G_TYPE_DOUBLE, G_TYPE_DOUBLE, G_TYPE_BOOLEAN);
    signals[PRESSED] = g_signal_new("pressed", type, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2,
                                    G_TYPE_DOUBLE, G_TYPE_DOUBLE);
}

static void add_controllers(AppSpaceView *self)
{
    GtkWidget *widget = GTK_WIDGET(self);
    GtkEventController *motion = gtk_event_controller_motion_new(), *keys = gtk_event_controller_key_new();
    GtkEventController *wheel = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_VERTICAL);
    GtkGesture *drag = gtk_gesture_drag_new(), *pinch = gtk_gesture_zoom_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(drag), 0);
    g_signal_connect(motion, "motion", G_CALLBACK(pointer_moved), self);
    g_signal_connect(motion, "leave", G_CALLBACK(pointer_left), self);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(drag_begin), self);
    g_signal_connect(drag, "drag-update", G_CALLBACK(drag_update), self);
    g_signal_connect(drag, "drag-end", G_CALLBACK(drag_end), self);
    g_signal_connect(wheel, "scroll", G_CALLBACK(scrolled), self);
    g_signal_connect(pinch, "begin", G_CALLBACK(pinch_begin), self);
    g_signal_connect(pinch, "scale-changed", G_CALLBACK(pinched), self);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key_pressed), self);
    gtk_widget_add_controller(widget, motion);
    gtk_widget_add_controller(widget, wheel);
    gtk_widget_add_controller(widget, keys);
    gtk_widget_add_controller(widget, GTK_EVENT_CONTROLLER(pinch));
    gtk_widget_add_controller(widget, GTK_EVENT_CONTROLLER(drag));
}

static void app_space_view_init(AppSpaceView *self)
{
    GtkWidget *widget = GTK_WIDGET(self);
    app_sight_init(&self->sight, widget);
    gtk_widget_set_focusable(widget, TRUE);
    gtk_widget_set_hexpand(widget, TRUE);
    gtk_widget_set_vexpand(widget, TRUE);
    gtk_widget_set_has_tooltip(widget, TRUE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Space"), -1);
    g_signal_connect(widget, "query-tooltip", G_CALLBACK(query_tooltip), NULL);
    add_controllers(self);
}

GtkWidget *app_space_view_new(AppDocument *document)
{
    AppSpaceView *self = g_object_new(APP_TYPE_SPACE_VIEW, NULL);
    self->sight.document = g_object_ref(document);
    return GTK_WIDGET(self);
}

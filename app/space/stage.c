/* SPDX-License-Identifier: MIT */
/* The widget: how the scene is fitted, and the hand on it. */
#include "stage.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/number.h"
#include "../base/touch.h"
#include "stage_private.h"

enum {
    MARGIN = 20,
    TITLE = 14,
    REACH = 14,
    LEAST_SIDE = 40,
    STILL = 4 /* within which a press is no drag */
};

G_DEFINE_FINAL_TYPE(AppStage, app_stage, GTK_TYPE_WIDGET)

/* ---- the map ---- */

void app_stage_place(const AppStageMap *map, AppProjection projection, const double place_mm[3], double at[2])
{
    at[0] = map->left + place_mm[0] * map->scale;
    at[1] = map->floors[projection] - place_mm[app_projection_up(projection)] * map->scale;
}

/* One scale for both, so that they can be read together; what is left of the height is shared. */
static void fit(AppStage *self)
{
    const double width = gtk_widget_get_width(GTK_WIDGET(self)), height = gtk_widget_get_height(GTK_WIDGET(self));
    const AppSpace *space = self->space;
    if (!space || self->is_held || width < LEAST_SIDE || height < LEAST_SIDE)
        return;
    double sides[3];
    for (int k = 0; k < 3; k++)
        sides[k] = MAX(space->high[k] - space->low[k], 1);
    AppStageMap *map = &self->map;
    map->scale = MIN((width - 2 * MARGIN) / sides[0], (height - 4 * MARGIN - 2 * TITLE) / (sides[1] + sides[2]));
    map->left = width / 2 - (space->low[0] + space->high[0]) / 2 * map->scale;
    const double spare = (height - 4 * MARGIN - 2 * TITLE - map->scale * (sides[1] + sides[2])) / 2;
    double top = 0;
    for (int i = 0; i < APP_PROJECTIONS; i++) {
        const int up = app_projection_up((AppProjection)i);
        map->tops[i] = top;
        map->floors[i] = top + TITLE + MARGIN + spare / 2 + space->high[up] * map->scale;
        top += TITLE + 2 * MARGIN + spare + sides[up] * map->scale;
    }
    map->tops[APP_PROJECTIONS] = height;
}

/* What nobody sees is not read off the scene. */
static void read_space(AppStage *self)
{
    if (self->space || !self->moment || !gtk_widget_get_mapped(GTK_WIDGET(self)))
        return;
    self->space = app_space_new(self->moment, self->outlines);
    fit(self);
}

/* ---- the hand ---- */

static AppProjection projection_at(const AppStage *self, double y)
{
    return y < self->map.tops[APP_ELEVATION] ? APP_PLAN : APP_ELEVATION;
}

/* The nearest thing within reach; of those as near the one that is on top. */
static gboolean thing_at(const AppStage *self, double x, double y, AppThing *found)
{
    const AppProjection projection = projection_at(self, y);
    double best = app_touch_reach((GtkWidget *)self, REACH);
    found->kind = APP_THING_NONE;
    for (guint i = 0; self->space && i < self->space->things->len; i++) {
        const AppThing *thing = &g_array_index(self->space->things, AppThing, i);
        double at[2];
        if (!app_space_moves(thing, projection))
            continue;
        app_stage_place(&self->map, projection, thing->at_mm, at);
        const double apart = hypot(at[0] - x, at[1] - y);
        if (apart < best - (found->kind == APP_THING_NONE ? 0 : 2)) {
            best = apart;
            *found = *thing;
        }
    }
    return found->kind != APP_THING_NONE;
}

static void pointer_moved(GtkEventControllerMotion *controller, double x, double y, AppStage *self)
{
    AppThing thing;
    (void)controller;
    if (self->is_held)
        return;
    const gboolean is_thing = thing_at(self, x, y, &thing);
    self->projection = projection_at(self, y);
    gtk_widget_set_cursor_from_name(GTK_WIDGET(self), is_thing ? "grab" : "default");
    app_sight_point(&self->sight, &thing);
}

static void pointer_left(GtkEventControllerMotion *controller, AppStage *self)
{
    const AppThing none = {.kind = APP_THING_NONE};
    (void)controller;
    if (!self->is_held)
        app_sight_point(&self->sight, &none);
}

static void drag_begin(GtkGestureDrag *gesture, double x, double y, AppStage *self)
{
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    AppThing thing;
    gtk_widget_grab_focus(GTK_WIDGET(self));
    if (self->sight.is_stale || !thing_at(self, x, y, &thing)) {
        gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_DENIED);
        return;
    }
    self->projection = projection_at(self, y);
    self->is_held = TRUE;
    app_sight_take(&self->sight, &thing, state);
}

static void drag_update(GtkGestureDrag *gesture, double dx, double dy, AppStage *self)
{
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    const double gain = ((state & GDK_SHIFT_MASK) ? 0.1 : 1) / self->map.scale;
    double to[3];
    if (!self->is_held || (!self->sight.has_moved && hypot(dx, dy) < STILL))
        return;
    memcpy(to, self->sight.start_mm, sizeof to);
    to[0] += dx * gain;
    to[app_projection_up(self->projection)] -= dy * gain;
    app_sight_move(&self->sight, &self->projection, to, 1 / self->map.scale, state);
}

/* The thing that is held is let go; where it is of a scene that is no longer there, too. */
static void let_go(AppStage *self)
{
    if (self->is_held)
        app_sight_let_go(&self->sight);
    self->is_held = FALSE;
}

static void drag_end(GtkGestureDrag *gesture, double dx, double dy, AppStage *self)
{
    const gboolean was_held = self->is_held;
    (void)gesture;
    (void)dx;
    (void)dy;
    let_go(self);
    if (was_held && !self->sight.has_moved)
        app_sight_click(&self->sight);
    fit(self);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

/* "work plane: 528.655 ± 0.00004 lx": the value of a grid's cell, with its bound. */
static gboolean tell_cell(const AppGrids *grids, gsize i, int other, const double place_mm[3], GtkTooltip *tooltip)
{
    const luxel_grid *const parts[] = {grids->list[i].grid, grids->list[i].grid->surround,
                                       grids->list[i].grid->background};
    char amount[APP_AMOUNT_SIZE];
    gsize cell;
    for (gsize k = 0; k < G_N_ELEMENTS(parts); k++) {
        if (!parts[k] || !app_grid_find_cell(parts[k], other, place_mm, &cell))
            continue;
        char *name = app_grid_name(grids, i);
        char *text = g_strdup_printf(
            "%s: %s %s", name, app_amount_write(parts[k]->values[cell], parts[k]->errors[cell], amount),
            gettext(parts[k]->unit));
        gtk_tooltip_set_text(tooltip, text);
        g_free(text);
        g_free(name);
        return TRUE;
    }
    return FALSE;
}

static gboolean query_tooltip(AppStage *self, int x, int y, gboolean by_keys, GtkTooltip *tooltip)
{
    const AppProjection projection = projection_at(self, y);
    const int other = app_projection_up(projection);
    const AppGrids *grids = self->sight.grids;
    double place_mm[3] = {0};
    AppThing thing;
    if (by_keys || !(self->map.scale > 0))
        return FALSE;
    if (thing_at(self, x, y, &thing))
        return app_sight_tell(&thing, tooltip);
    place_mm[0] = (x - self->map.left) / self->map.scale;
    place_mm[other] = (self->map.floors[projection] - y) / self->map.scale;
    const gboolean is_latest = grids && self->moment && grids->moment->serial >= self->moment->serial;
    for (gsize i = 0; is_latest && i < grids->count; i++)
        if (tell_cell(grids, i, other, place_mm, tooltip))
            return TRUE;
    return FALSE;
}

/* ---- what is shown ---- */

void app_stage_set_moment(AppStage *self, AppMoment *moment)
{
    if (moment == self->moment)
        return;
    if (moment)
        app_moment_ref(moment);
    else
        let_go(self);
    app_moment_unref(self->moment);
    self->moment = moment;
    g_clear_pointer(&self->space, app_space_free);
    read_space(self);
    gtk_widget_queue_draw(GTK_WIDGET(self));
}

AppSight *app_stage_sight(AppStage *self)
{
    return &self->sight;
}

static void app_stage_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    AppStage *self = APP_STAGE(widget);
    const int width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    const graphene_rect_t area = GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height);
    if (!self->space || !(self->map.scale > 0))
        return;
    if (self->sight.is_stale)
        gtk_snapshot_push_opacity(snapshot, 0.3);
    cairo_t *cairo = gtk_snapshot_append_cairo(snapshot, &area);
    app_stage_draw(self, cairo, width, height);
    cairo_destroy(cairo);
    if (self->sight.is_stale)
        gtk_snapshot_pop(snapshot);
}

static void app_stage_map(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(app_stage_parent_class)->map(widget);
    read_space(APP_STAGE(widget));
}

static void app_stage_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    (void)width;
    (void)height;
    (void)baseline;
    fit(APP_STAGE(widget));
}

/* ---- the class ---- */

static void app_stage_dispose(GObject *object)
{
    AppStage *self = APP_STAGE(object);
    g_clear_pointer(&self->space, app_space_free);
    g_clear_pointer(&self->moment, app_moment_unref);
    G_OBJECT_CLASS(app_stage_parent_class)->dispose(object);
}

static void app_stage_finalize(GObject *object)
{
    app_sight_clear(&APP_STAGE(object)->sight);
    app_outlines_free(APP_STAGE(object)->outlines);
    G_OBJECT_CLASS(app_stage_parent_class)->finalize(object);
}

static void app_stage_class_init(AppStageClass *class)
{
    GtkWidgetClass *widget = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = app_stage_dispose;
    G_OBJECT_CLASS(class)->finalize = app_stage_finalize;
    widget->snapshot = app_stage_snapshot;
    widget->size_allocate = app_stage_size_allocate;
    widget->map = app_stage_map;
    gtk_widget_class_set_css_name(widget, "luxelstage");
    gtk_widget_class_set_accessible_role(widget, GTK_ACCESSIBLE_ROLE_IMG);
    app_sight_add_signals(APP_TYPE_STAGE);
}

static void app_stage_init(AppStage *self)
{
    GtkWidget *widget = GTK_WIDGET(self);
    GtkEventController *motion = gtk_event_controller_motion_new();
    GtkGesture *drag = gtk_gesture_drag_new();
    app_sight_init(&self->sight, widget);
    self->outlines = app_outlines_new();
    gtk_widget_set_focusable(widget, TRUE);
    gtk_widget_set_hexpand(widget, TRUE);
    gtk_widget_set_vexpand(widget, TRUE);
    gtk_widget_set_has_tooltip(widget, TRUE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Plan and elevation"), -1);
    g_signal_connect(widget, "query-tooltip", G_CALLBACK(query_tooltip), NULL);
    g_signal_connect(motion, "motion", G_CALLBACK(pointer_moved), self);
    g_signal_connect(motion, "leave", G_CALLBACK(pointer_left), self);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(drag_begin), self);
    g_signal_connect(drag, "drag-update", G_CALLBACK(drag_update), self);
    g_signal_connect(drag, "drag-end", G_CALLBACK(drag_end), self);
    gtk_widget_add_controller(widget, motion);
    gtk_widget_add_controller(widget, GTK_EVENT_CONTROLLER(drag));
}

GtkWidget *app_stage_new(AppDocument *document)
{
    AppStage *self = g_object_new(APP_TYPE_STAGE, NULL);
    self->sight.document = g_object_ref(document);
    return GTK_WIDGET(self);
}

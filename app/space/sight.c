/* SPDX-License-Identifier: MIT */
/* The state of a sight, and what the hand does with it; widgets draw it. */
#include "sight.h"

#include <string.h>

#include "hold.h"

static void emit_thing(AppSight *self, const char *signal)
{
    g_signal_emit_by_name(self->widget, signal, (int)self->thing.kind, (guint)self->thing.index);
}

void app_sight_add_signals(GType type)
{
    static const char *const of_things[] = {"selected", "hovered"};
    for (gsize i = 0; i < G_N_ELEMENTS(of_things); i++)
        g_signal_new(of_things[i], type, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2, G_TYPE_INT,
                     G_TYPE_UINT);
    g_signal_new("toggled", type, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_UINT);
}

void app_sight_init(AppSight *self, GtkWidget *widget)
{
    *self = (AppSight){.widget = widget, .selected = -1, .hovered = -1};
    self->chosen = g_array_new(FALSE, FALSE, sizeof(gsize));
}

void app_sight_clear(AppSight *self)
{
    g_clear_object(&self->document);
    g_clear_pointer(&self->grids, app_grids_unref);
    g_clear_pointer(&self->eyes, app_eyes_unref);
    g_clear_pointer(&self->chosen, g_array_unref);
    g_clear_pointer(&self->turn, app_turn_free);
}

/* ---- what is shown ---- */

void app_sight_choose(AppSight *self, const GArray *lights, gsize selected)
{
    self->selected = (gssize)selected;
    g_array_set_size(self->chosen, 0);
    g_array_append_vals(self->chosen, lights->data, lights->len);
    gtk_widget_queue_draw(self->widget);
}

gboolean app_sight_is_chosen(const AppSight *self, gsize light)
{
    for (guint i = 0; i < self->chosen->len; i++)
        if (g_array_index(self->chosen, gsize, i) == light)
            return TRUE;
    return FALSE;
}

void app_sight_hover(AppSight *self, gssize light)
{
    if (light == self->hovered)
        return;
    self->hovered = light;
    gtk_widget_queue_draw(self->widget);
}

void app_sight_set_reading(AppSight *self, const AppReading *reading)
{
    const gboolean has = reading && reading->value.on_surface;
    if (!has && !self->has_place)
        return;
    self->has_place = has;
    if (has) {
        memcpy(self->place_mm, reading->value.position_mm, sizeof self->place_mm);
        memcpy(self->normal, reading->value.normal, sizeof self->normal);
    }
    gtk_widget_queue_draw(self->widget);
}

void app_sight_set_stale(AppSight *self, gboolean stale)
{
    self->is_stale = stale;
    gtk_widget_queue_draw(self->widget);
}

void app_sight_set_lighting(AppSight *self, AppGrids *grids, AppEyes *eyes)
{
    app_grids_ref(grids);
    app_eyes_ref(eyes);
    app_grids_unref(self->grids);
    app_eyes_unref(self->eyes);
    self->grids = grids;
    self->eyes = eyes;
    gtk_widget_queue_draw(self->widget);
}

double app_sight_grid_opacity(AppSight *self, const AppMoment *moment)
{
    static const double shown = 0.6, dimmed = 0.2;
    enum { BLINK_MICROSECONDS = 200000 };
    const AppMoment *of = self->grids ? self->grids->moment : NULL;
    const gint64 now = g_get_monotonic_time();
    if (of && of->serial >= moment->serial)
        self->grids_seen = now;
    return now - self->grids_seen <= BLINK_MICROSECONDS && !self->is_stale ? shown : dimmed;
}

/* ---- the hand ---- */

void app_sight_point(AppSight *self, const AppThing *thing)
{
    if (thing->kind == self->thing.kind && thing->index == self->thing.index)
        return;
    self->thing = *thing;
    emit_thing(self, "hovered");
    gtk_widget_queue_draw(self->widget);
}

gboolean app_sight_tell(const AppThing *thing, GtkTooltip *tooltip)
{
    char *text = app_thing_tell(thing);
    gtk_tooltip_set_text(tooltip, text);
    g_free(text);
    return TRUE;
}

static gboolean is_lamp(const AppThing *thing)
{
    return thing->kind == APP_THING_LAMP || thing->kind == APP_THING_DIRECTION;
}

void app_sight_take(AppSight *self, const AppThing *thing, GdkModifierType state)
{
    self->thing = *thing;
    memcpy(self->start_mm, thing->at_mm, sizeof self->start_mm);
    self->has_moved = FALSE;
    self->is_toggling = is_lamp(thing) && (state & (GDK_CONTROL_MASK | GDK_SHIFT_MASK));
    self->was_chosen = is_lamp(thing) && self->chosen->len > 1 && app_sight_is_chosen(self, thing->index);
    g_clear_pointer(&self->turn, app_turn_free);
    self->turn = self->was_chosen ? app_turn_begin(self->document, self->chosen, thing->index) : NULL;
    app_document_begin_gesture(self->document);
    if (!self->was_chosen && !self->is_toggling)
        emit_thing(self, "selected");
}

void app_sight_move(AppSight *self, const AppProjection *projection, const double to_mm[3], double pixel_mm,
                    GdkModifierType state)
{
    const double grain_mm = app_hold_grain(pixel_mm, (state & GDK_SHIFT_MASK) != 0, (state & GDK_CONTROL_MASK) != 0);
    if (self->is_toggling && !self->was_chosen) /* it is a drag, which chooses nothing but what it moves */
        emit_thing(self, "selected");
    self->is_toggling = FALSE;
    self->has_moved = TRUE;
    app_hold_move(&self->thing, projection, to_mm, grain_mm, self->was_chosen ? self->chosen : NULL, self->turn,
                  self->document);
}

void app_sight_let_go(AppSight *self)
{
    app_document_end_gesture(self->document);
    g_clear_pointer(&self->turn, app_turn_free);
}

void app_sight_click(AppSight *self)
{
    if (self->is_toggling)
        g_signal_emit_by_name(self->widget, "toggled", (guint)self->thing.index);
    else if (self->was_chosen)
        emit_thing(self, "selected");
}

/* SPDX-License-Identifier: MIT */
/* Labels that are dragged to the left and right, to change what their rows have. */
#include <math.h>

#include "row_private.h"

enum { STILL = 4 /* dots that are no drag yet */ };

static void drag_begins(GtkGestureDrag *gesture, double x, double y, AppRow *self)
{
    (void)x;
    (void)y;
    self->is_dragged = FALSE;
    if (!self->hand->begins(self))
        gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_DENIED);
}

static void dragged(GtkGestureDrag *gesture, double dx, double dy, AppRow *self)
{
    const GdkModifierType state = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    (void)dy;
    if (!self->is_dragged && fabs(dx) < STILL)
        return;
    self->is_dragged = TRUE;
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    self->hand->moves(self, dx, (state & GDK_SHIFT_MASK) != 0, (state & GDK_CONTROL_MASK) != 0);
}

static void drag_ends(AppRow *self)
{
    if (self->is_dragged)
        app_row_leave(self);
}

void app_row_make_draggable(AppRow *self, const AppRowHand *hand)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    self->hand = hand;
    g_signal_connect(drag, "drag-begin", G_CALLBACK(drag_begins), self);
    g_signal_connect(drag, "drag-update", G_CALLBACK(dragged), self);
    g_signal_connect_swapped(drag, "drag-end", G_CALLBACK(drag_ends), self);
    gtk_widget_add_controller(self->name, GTK_EVENT_CONTROLLER(drag));
    gtk_widget_set_cursor_from_name(self->name, "ew-resize");
}

/* SPDX-License-Identifier: MIT */
/* The style class that makes controls large, on all windows of a program. */
#include "touch.h"

static const char CLASS[] = "touch"; /* as app.css has it */
static const char KEY[] = "touch-controls";

static gboolean has_touch_screen(void)
{
    GdkDisplay *display = gdk_display_get_default();
    GdkSeat *seat = display ? gdk_display_get_default_seat(display) : NULL;
    return seat && (gdk_seat_get_capabilities(seat) & GDK_SEAT_CAPABILITY_TOUCH);
}

static void dress(GtkWidget *window, gboolean is_on)
{
    if (is_on)
        gtk_widget_add_css_class(window, CLASS);
    else
        gtk_widget_remove_css_class(window, CLASS);
}

static gboolean is_on(GActionMap *application)
{
    GVariant *state = g_action_get_state(g_action_map_lookup_action(application, CLASS));
    const gboolean on = g_variant_get_boolean(state);
    g_variant_unref(state);
    return on;
}

static void set(GtkApplication *application, gboolean on)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(application), CLASS);
    g_simple_action_set_state(G_SIMPLE_ACTION(action), g_variant_new_boolean(on));
    for (GList *window = gtk_application_get_windows(application); window; window = window->next)
        dress(window->data, on);
}

static void window_came(GtkApplication *application, GtkWindow *window)
{
    dress(GTK_WIDGET(window), is_on(G_ACTION_MAP(application)));
}

/* The user's choice stays; else the screen decides, which may be plugged in at any time. */
static void seat_changed(GtkApplication *application)
{
    GSettings *settings = g_object_get_data(G_OBJECT(application), KEY);
    char *chosen = settings ? g_settings_get_string(settings, KEY) : NULL;
    set(application, g_strcmp0(chosen, "large") == 0 || (g_strcmp0(chosen, "small") != 0 && has_touch_screen()));
    g_free(chosen);
}

static void switched(GSimpleAction *action, GVariant *state, gpointer application)
{
    GSettings *settings = g_object_get_data(G_OBJECT(application), KEY);
    const gboolean on = g_variant_get_boolean(state);
    (void)action;
    if (settings)
        g_settings_set_string(settings, KEY, on ? "large" : "small");
    set(application, on);
}

void app_touch_begin(GtkApplication *application, GSettings *settings)
{
    static const GActionEntry actions[] = {{.name = CLASS, .state = "false", .change_state = switched}};
    GdkSeat *seat = gdk_display_get_default_seat(gdk_display_get_default());
    g_action_map_add_action_entries(G_ACTION_MAP(application), actions, G_N_ELEMENTS(actions), application);
    if (settings)
        g_object_set_data_full(G_OBJECT(application), KEY, g_object_ref(settings), g_object_unref);
    g_signal_connect(application, "window-added", G_CALLBACK(window_came), NULL);
    if (seat) {
        g_signal_connect_object(seat, "device-added", G_CALLBACK(seat_changed), application, G_CONNECT_SWAPPED);
        g_signal_connect_object(seat, "device-removed", G_CALLBACK(seat_changed), application, G_CONNECT_SWAPPED);
    }
    seat_changed(application);
}

void app_touch_on_rest(GtkWidget *widget, GCallback pressed, gpointer data)
{
    GtkGesture *rest = gtk_gesture_long_press_new();
    gtk_gesture_single_set_touch_only(GTK_GESTURE_SINGLE(rest), TRUE);
    g_signal_connect(rest, "pressed", pressed, data);
    gtk_widget_add_controller(widget, GTK_EVENT_CONTROLLER(rest));
}

int app_touch_reach(GtkWidget *widget, int reach)
{
    GtkRoot *root = gtk_widget_get_root(widget);
    return root && gtk_widget_has_css_class(GTK_WIDGET(root), CLASS) ? MAX(reach, APP_FINGER / 2) : reach;
}

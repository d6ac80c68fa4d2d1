/* SPDX-License-Identifier: MIT */
/* Toolbars; their buttons call actions of the window. */
#include "toolbar.h"

#include <string.h>

#include "choices.h"
#include "row.h"

GtkWidget *app_toolbar_new(void)
{
    GtkWidget *bar = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 2);
    gtk_widget_add_css_class(bar, "tools");
    return bar;
}

GtkWidget *app_toolbar_add(GtkWidget *bar, const char *icon, const char *meaning, const char *action)
{
    GtkWidget *button = gtk_button_new_from_icon_name(icon);
    gtk_widget_set_tooltip_text(button, meaning);
    app_name_control(button, meaning);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), action);
    gtk_box_append(GTK_BOX(bar), button);
    return button;
}

static GMenu *menu_of_kinds(const luxel_parameters *parameters, const char *list, const char *action)
{
    GMenu *menu = g_menu_new();
    for (gsize i = 0; i < luxel_parameters_kind_count(parameters); i++) {
        const luxel_parameter_kind *kind = luxel_parameters_kind(parameters, i);
        if (strcmp(kind->list, list) != 0 || !kind->example)
            continue;
        char *text = g_strdup_printf("%s: %s", app_choice_label(kind->name), kind->meaning);
        GMenuItem *item = g_menu_item_new(text, NULL);
        g_menu_item_set_action_and_target(item, action, "s", kind->name);
        g_menu_append_item(menu, item);
        g_object_unref(item);
        g_free(text);
    }
    return menu;
}

GMenu *app_toolbar_add_kinds(GtkWidget *bar, const luxel_parameters *parameters, const char *list, const char *meaning,
                             const char *action)
{
    GtkWidget *add = gtk_menu_button_new();
    GMenu *kinds = menu_of_kinds(parameters, list, action);
    gtk_menu_button_set_icon_name(GTK_MENU_BUTTON(add), "list-add-symbolic");
    gtk_menu_button_set_menu_model(GTK_MENU_BUTTON(add), G_MENU_MODEL(kinds));
    gtk_widget_set_tooltip_text(add, meaning);
    app_name_control(add, meaning);
    gtk_box_append(GTK_BOX(bar), add);
    g_object_unref(kinds); /* the button has it */
    return kinds;
}

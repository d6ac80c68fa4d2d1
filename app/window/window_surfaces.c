/* SPDX-License-Identifier: MIT */
/* Surfaces are added by kind, doubled and deleted, as sources are. */
#include <string.h>

#include "../../front/words.h"
#include "../base/toolbar.h"
#include "../form/new_surface.h"
#include "window_private.h"

static gsize chosen(AppWindow *self)
{
    const guint index = gtk_drop_down_get_selected(GTK_DROP_DOWN(self->surface_list));
    return index == GTK_INVALID_LIST_POSITION ? 0 : index;
}

/* Takes the text. */
static void append(AppWindow *self, char *yaml)
{
    const gsize count = app_document_size(self->document, "surfaces");
    const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "surfaces", .value = yaml, .index = count};
    if (yaml && app_document_edit(self->document, &edit, 1, NULL, NULL))
        gtk_drop_down_set_selected(GTK_DROP_DOWN(self->surface_list), (guint)count);
    g_free(yaml);
}

static void surface_add(GSimpleAction *action, GVariant *kind, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    append(self, app_new_surface(self->document, self->parameters, g_variant_get_string(kind, NULL)));
}

static void surface_duplicate(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    append(self, app_doubled_surface(self->document, chosen(self)));
}

static void surface_delete(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    char *key = g_strdup_printf("surfaces[%zu]", chosen(self));
    const AppEdit edit = {.kind = APP_EDIT_REMOVE, .key = key};
    (void)action;
    (void)argument;
    if (chosen(self) < app_document_size(self->document, "surfaces"))
        app_document_edit(self->document, &edit, 1, NULL, NULL);
    g_free(key);
}

GtkWidget *app_window_new_surface_bar(AppWindow *self)
{
    GtkWidget *bar = app_toolbar_new();
    GMenu *kinds = app_toolbar_add_kinds(bar, self->parameters, "surfaces", _("Add a surface"), "win.surface-add");
    g_menu_append(kinds, _("Mesh of a file…"), "win.surface-mesh");
    app_toolbar_add(bar, "edit-copy-symbolic", _("Duplicate the surface"), "win.surface-duplicate");
    app_toolbar_add(bar, "list-remove-symbolic", _("Delete the surface"), "win.surface-delete");
    return bar;
}

void app_window_add_surface_actions(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "surface-add", .activate = surface_add, .parameter_type = "s"},
        {.name = "surface-duplicate", .activate = surface_duplicate},
        {.name = "surface-delete", .activate = surface_delete},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
}

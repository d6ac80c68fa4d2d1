/* SPDX-License-Identifier: MIT */
/* The desktop keeps the list; scenes are known in it by the program that opened them. */
#include "recent.h"

#include <gtk/gtk.h>

static const char mime_type[] = "application/x-luxel-scene", program[] = "Luxel";

void app_recent_add(const char *path)
{
    GFile *file = g_file_new_for_path(path);
    char *uri = g_file_get_uri(file), *name = g_path_get_basename(path), *groups[] = {NULL};
    /* the type is given, as a scene by another name would not be known by it */
    GtkRecentData data = {.display_name = name,
                          .mime_type = g_strdup(mime_type),
                          .app_name = g_strdup(program),
                          .app_exec = g_strdup("luxel-app %f"),
                          .groups = groups};
    gtk_recent_manager_add_full(gtk_recent_manager_get_default(), uri, &data);
    g_free(data.mime_type);
    g_free(data.app_name);
    g_free(data.app_exec);
    g_free(uri);
    g_free(name);
    g_object_unref(file);
}

static int by_time(gconstpointer a, gconstpointer b)
{
    return g_date_time_compare(gtk_recent_info_get_modified((GtkRecentInfo *)b),
                               gtk_recent_info_get_modified((GtkRecentInfo *)a));
}

char **app_recent_paths(void)
{
    GList *items = g_list_sort(gtk_recent_manager_get_items(gtk_recent_manager_get_default()), by_time);
    GStrvBuilder *paths = g_strv_builder_new();
    int shown = 0;
    for (GList *at = items; at && shown < APP_MOST_RECENT; at = at->next) {
        GtkRecentInfo *info = at->data;
        char *path = gtk_recent_info_has_application(info, program)
                         ? g_filename_from_uri(gtk_recent_info_get_uri(info), NULL, NULL)
                         : NULL;
        if (path && g_file_test(path, G_FILE_TEST_EXISTS)) {
            g_strv_builder_add(paths, path);
            shown++;
        }
        g_free(path);
    }
    g_list_free_full(items, (GDestroyNotify)gtk_recent_info_unref);
    char **found = g_strv_builder_end(paths);
    g_strv_builder_unref(paths);
    return found;
}

/* SPDX-License-Identifier: MIT */
/* Headings are lines that are underlined; that of a light begins with its key, in every language. */
#include "explained.h"

#include <string.h>

/* Whether a line is drawn under a heading. */
static gboolean is_underline(const char *line)
{
    return line && (g_str_has_prefix(line, "─") || g_str_has_prefix(line, "═"));
}

char *app_explained_light(const char *text, gsize light)
{
    char **lines = g_strsplit(text, "\n", -1), *key = g_strdup_printf("lights[%zu]", light);
    GString *found = NULL;
    for (gsize i = 0; lines[i]; i++) {
        const gboolean is_heading = lines[i + 1] && is_underline(lines[i + 1]);
        if (is_heading && found)
            break;
        if (is_heading && g_str_has_prefix(lines[i], key)) {
            found = g_string_new(NULL);
            i++;
        } else if (found && *g_strstrip(lines[i]))
            g_string_append_printf(found, "%s%s", found->len ? "\n" : "", lines[i]);
    }
    g_strfreev(lines);
    g_free(key);
    return found ? g_string_free(found, FALSE) : NULL;
}

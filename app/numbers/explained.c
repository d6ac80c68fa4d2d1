/* SPDX-License-Identifier: MIT */
/* Headings are underlined, and may take several lines; that of a light begins with its key, in every language. */
#include "explained.h"

#include <string.h>

/* Whether a line is drawn under a heading. */
static gboolean is_underline(const char *line)
{
    return line && (g_str_has_prefix(line, "─") || g_str_has_prefix(line, "═"));
}

/* Those lines of a heading that begins here, with the one below it; 0: none begins. */
static gsize heading_lines(char **lines)
{
    for (gsize i = 0; lines[i] && *lines[i]; i++)
        if (i > 0 && is_underline(lines[i]))
            return i + 1;
    return 0;
}

char *app_explained_light(const char *text, gsize light)
{
    char **lines = g_strsplit(text, "\n", -1), *key = g_strdup_printf("lights[%zu]", light);
    GString *found = NULL;
    for (gsize i = 0; lines[i]; i++) {
        const gsize heading = heading_lines(lines + i);
        if (heading && found)
            break;
        if (heading && g_str_has_prefix(lines[i], key)) {
            found = g_string_new(NULL);
            i += heading - 1;
        } else if (found && *g_strstrip(lines[i]))
            g_string_append_printf(found, "%s%s", found->len ? "\n" : "", lines[i]);
    }
    g_strfreev(lines);
    g_free(key);
    return found ? g_string_free(found, FALSE) : NULL;
}

/* SPDX-License-Identifier: MIT */
/* Quoting for YAML: double quotes with escapes are written; single quotes are read as well. */
#include "scalar.h"

#include <glib.h>
#include <string.h>

char *app_yaml_quote(const char *text)
{
    GString *quoted = g_string_new("\"");
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            g_string_append_c(quoted, '\\');
        if ((guchar)*text < 0x20)
            g_string_append_printf(quoted, "\\u%04x", (guint)*text);
        else
            g_string_append_c(quoted, *text);
    }
    g_string_append_c(quoted, '"');
    return g_string_free(quoted, FALSE);
}

char *app_yaml_unquote(const char *yaml)
{
    const gsize length = strlen(yaml);
    if (length < 2 || (yaml[0] != '"' && yaml[0] != '\'') || yaml[length - 1] != yaml[0])
        return g_strdup(yaml);
    GString *text = g_string_new(NULL);
    for (const char *c = yaml + 1; c < yaml + length - 1; c++) {
        if (yaml[0] == '"' && c[0] == '\\' && c[1] == 'u') {
            char digits[5] = {c[2], c[3], c[4], c[5], 0};
            g_string_append_unichar(text, (gunichar)g_ascii_strtoull(digits, NULL, 16));
            c += 5;
        } else {
            if ((yaml[0] == '"' && c[0] == '\\') || (yaml[0] == '\'' && c[0] == '\'' && c[1] == '\''))
                c++;
            g_string_append_c(text, *c);
        }
    }
    return g_string_free(text, FALSE);
}

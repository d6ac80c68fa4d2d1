/* SPDX-License-Identifier: MIT */
/* The words above the form of sources that are chosen together. */
#include "several.h"

#include "../../front/words.h"

static gboolean is_of(const AppDocument *document, gsize light, const char *type)
{
    char *key = g_strdup_printf("lights[%zu].type", light), *now = app_document_get(document, key, NULL);
    const gboolean is_it = g_strcmp0(now, type) == 0;
    g_free(now);
    g_free(key);
    return is_it;
}

char *app_several_tell(const AppDocument *document, const GArray *lights)
{
    guint distant = 0, ambient = 0;
    if (lights->len < 2)
        return NULL;
    for (guint i = 0; i < lights->len; i++) {
        distant += is_of(document, g_array_index(lights, gsize, i), "distant") ? 1 : 0;
        ambient += is_of(document, g_array_index(lights, gsize, i), "ambient") ? 1 : 0;
    }
    char *text =
        g_strdup_printf(ngettext("%u source is changed", "%u sources are changed together", lights->len), lights->len);
    const char *more = ambient > 0 ? _("Ambient light stands nowhere: a drag leaves it.")
                       : distant > 0 && distant < lights->len
                           ? _("A drag moves those that stand somewhere, or turns light from far away.")
                           : NULL;
    if (!more)
        return text;
    char *both = g_strdup_printf("%s. %s", text, more);
    g_free(text);
    return both;
}

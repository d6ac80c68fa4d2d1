/* SPDX-License-Identifier: MIT */
/* The words above the form of sources that are chosen together. */
#include "several.h"

#include "../front/words.h"

/* Whether light comes from no place that a drag could move. */
static gboolean stands_nowhere(const AppDocument *document, gsize light)
{
    char *key = g_strdup_printf("lights[%zu].type", light), *type = app_document_get(document, key, NULL);
    const gboolean nowhere = g_strcmp0(type, "distant") == 0 || g_strcmp0(type, "ambient") == 0;
    g_free(type);
    g_free(key);
    return nowhere;
}

char *app_several_tell(const AppDocument *document, const GArray *lights)
{
    gboolean stays = FALSE;
    if (lights->len < 2)
        return NULL;
    for (guint i = 0; i < lights->len; i++)
        stays = stays || stands_nowhere(document, g_array_index(lights, gsize, i));
    char *text = g_strdup_printf(ngettext("%u source is changed", "%u sources are changed together", lights->len),
                                 lights->len);
    if (!stays)
        return text;
    char *both = g_strdup_printf("%s. %s", text, _("Light from far away stands nowhere: a drag leaves it."));
    g_free(text);
    return both;
}

/* SPDX-License-Identifier: MIT */
/* The public functions of the built-in scenes. */
#include <stdlib.h>
#include <string.h>

#include <luxel/scene.h>

#include "../base/diagnostics.h"
#include "../base/text.h"
#include "builtin.h"

size_t luxel_builtin_scene_count(void)
{
    size_t count = 0;
    while (lx_builtins[count].name)
        count++;
    return count;
}

const char *luxel_builtin_scene_name(size_t i)
{
    return i < luxel_builtin_scene_count() ? lx_builtins[i].name : NULL;
}

const char *luxel_builtin_scene_title(size_t i)
{
    return i < luxel_builtin_scene_count() ? lx_builtins[i].title : NULL;
}

const char *luxel_builtin_scene_text(size_t i)
{
    return i < luxel_builtin_scene_count() ? lx_builtins[i].text : NULL;
}

static luxel_status report_unknown(const char *name, luxel_diagnostics *diagnostics)
{
    struct lx_nearest nearest = {.word = name, .length = strlen(name)};
    struct lx_text names = {0};
    for (const struct lx_builtin *builtin = lx_builtins; builtin->name; builtin++) {
        lx_nearest_offer(&nearest, builtin->name);
        lx_text_puts(&names, builtin == lx_builtins ? "" : ", ");
        lx_text_puts(&names, builtin->name);
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_BUILTIN, LX_ARGS(name));
    char *words = lx_text_take(&names);
    if (nearest.best)
        lx_hint(diagnostics, LX_MSG_DID_YOU_MEAN, LX_ARGS(nearest.best));
    else if (words)
        lx_hint(diagnostics, LX_MSG_HINT_BUILTINS, LX_ARGS(words));
    free(words);
    return LUXEL_ERROR_ARGUMENT;
}

luxel_status luxel_scene_open_builtin(const char *name, luxel_diagnostics *diagnostics, luxel_scene **scene)
{
    if (!name)
        return LUXEL_ERROR_ARGUMENT;
    for (const struct lx_builtin *builtin = lx_builtins; builtin->name; builtin++)
        if (strcmp(builtin->name, name) == 0)
            return luxel_scene_read_text(builtin->text, strlen(builtin->text), name, diagnostics, scene);
    return report_unknown(name, diagnostics);
}

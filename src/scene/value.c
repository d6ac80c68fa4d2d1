/* SPDX-License-Identifier: MIT */
/* Asking a scene for the value of a key, as it is written or by default, whether the scene is committed or not. */
#include <string.h>

#include "path.h"
#include "tidy.h"

luxel_status luxel_scene_get(const luxel_scene *scene, const char *key, luxel_diagnostics *diagnostics, bool *written,
                             char **text)
{
    if (!scene || !key || !text)
        return LUXEL_ERROR_ARGUMENT;
    struct lx_place place = {.source = "key", .text = key, .length = strlen(key)};
    struct lx_path path;
    struct lx_text words = {0};
    luxel_status status = lx_follow_path(scene, &place, place.length, diagnostics, &path);
    if (status != LUXEL_OK)
        return status;
    lx_node_id node = path.nodes[path.count];
    const char *initial = path.parameter ? path.parameter->initial : NULL;
    if (node)
        lx_write_flow(&words, &scene->document, node, false);
    else if (initial)
        lx_text_puts(&words, initial);
    char *taken = node || initial ? lx_text_take(&words) : NULL;
    lx_text_clear(&words);
    if ((node || initial) && !taken)
        return lx_out_of_memory(diagnostics);
    *text = taken;
    if (written)
        *written = node != 0;
    return LUXEL_OK;
}

luxel_status luxel_scene_list_size(const luxel_scene *scene, const char *list, luxel_diagnostics *diagnostics,
                                   size_t *count)
{
    if (!scene || !list || !count)
        return LUXEL_ERROR_ARGUMENT;
    struct lx_place place = {.source = "key", .text = list, .length = strlen(list)};
    struct lx_path path;
    return lx_follow_list(scene, &place, diagnostics, &path, count);
}

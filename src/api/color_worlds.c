/* SPDX-License-Identifier: MIT */
/* Opening the worlds of a scene in colour. */
#include "color_worlds.h"

#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../world/evaluate.h"

luxel_status lx_color_worlds_begin(const luxel_scene *scene, const luxel_settings *settings,
                                   luxel_diagnostics *diagnostics, struct lx_color_worlds *worlds)
{
    luxel_settings own = *settings;
    *worlds = (struct lx_color_worlds){.opened = 0};
    own.quantity = LUXEL_IRRADIANCE;
    return lx_color_parts_make(scene, &own, diagnostics, &worlds->parts);
}

luxel_status lx_color_worlds_open(struct lx_color_worlds *worlds, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    worlds->sessions = lx_new_array(worlds->parts.count, sizeof *worlds->sessions);
    if (!worlds->sessions)
        return lx_out_of_memory(diagnostics);
    while (worlds->opened < worlds->parts.count && status == LUXEL_OK) {
        const struct lx_color_part *part = &worlds->parts.list[worlds->opened];
        status = lx_session_open_world(part->scene, &part->settings, diagnostics, &worlds->sessions[worlds->opened++]);
    }
    return status;
}

void lx_color_worlds_clear(struct lx_color_worlds *worlds)
{
    for (size_t i = 0; i < worlds->opened; i++)
        lx_session_clear(&worlds->sessions[i]);
    free(worlds->sessions);
    lx_color_parts_clear(&worlds->parts);
}

void lx_color_add(const struct lx_color_part *part, lx_bounded value, luxel_color *color)
{
    color->exists = true;
    for (int c = 0; c < LX_CHANNELS; c++) {
        const lx_bounded so_far = {color->rgb[c], color->error[c]};
        const lx_bounded sum = lx_add_part(so_far, part->rgb[c], value.value, value.error);
        color->rgb[c] = sum.value;
        color->error[c] = lx_reported(sum).error;
    }
}

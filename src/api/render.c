/* SPDX-License-Identifier: MIT */
/* luxel_render(): the whole picture as one strip, which becomes the field's. */
#include "../base/diagnostics.h"
#include "coloring.h"
#include "reflecting.h"
#include "rendering.h"

luxel_status luxel_render(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                          luxel_field **field)
{
    if (!field)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("field"));
    const luxel_status status = luxel_scene_has_color(scene) ? lx_render_in_color(scene, settings, diagnostics, field)
                                                             : lx_render_grey(scene, settings, diagnostics, field);
    if (status == LUXEL_OK)
        lx_report_mirrored_error(scene, &(*field)->statistics, diagnostics);
    return status;
}

luxel_status lx_render_grey(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            luxel_field **field)
{
    struct lx_session session;
    struct lx_rendering rendering = {0};
    struct luxel_field *made = NULL;
    luxel_status status = lx_session_open(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = lx_reflect_picture(scene, &session, diagnostics);
    if (status == LUXEL_OK)
        status = lx_new_frame(&session, scene, diagnostics, &made);
    if (status == LUXEL_OK)
        status = lx_rendering_open(&rendering, &session, made, made->rows, diagnostics);
    if (status == LUXEL_OK)
        status = lx_rendering_run(&rendering);
    if (status == LUXEL_OK) {
        struct lx_strip *all = &rendering.held[0].strip;
        made->values = all->values;
        made->mask = all->mask;
        all->values = all->mask = NULL;
        *field = made;
    } else {
        luxel_field_free(made);
    }
    lx_rendering_clear(&rendering);
    lx_session_clear(&session);
    return status;
}

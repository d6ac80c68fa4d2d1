/* SPDX-License-Identifier: MIT */
/* What the pixels of a scene show, as depths and normals: luxel_scene_geometry(). */
#include "../base/diagnostics.h"
#include "../shade/camera.h"
#include "../shade/reference.h"
#include "session.h"
#include <luxel/view.h>

/* How far below the observer a place is, along the axis of view. */
static double depth_of(const struct lx_camera *camera, const lx_bounded3 *place_mm)
{
    const double place[3] = {place_mm->x.value, place_mm->y.value, place_mm->z.value};
    double carried[3];
    lx_frame_carry(&camera->frame, place, carried);
    return camera->z_mm - carried[2];
}

/* Fills one pixel of what is wanted. */
static void see(const struct lx_prepared *prepared, double x_mm, double y_mm, double *depth_mm, double *normal)
{
    struct lx_element element;
    const bool is_seen = lx_element_seen(prepared, x_mm, y_mm, &element);
    if (depth_mm)
        *depth_mm = is_seen ? depth_of(&prepared->camera, &element.place_mm) : 0;
    if (normal) {
        normal[0] = is_seen ? element.normal.x.value : 0;
        normal[1] = is_seen ? element.normal.y.value : 0;
        normal[2] = is_seen ? element.normal.z.value : 0;
    }
}

luxel_status luxel_scene_geometry(const luxel_scene *scene, luxel_diagnostics *diagnostics, double *depth_mm,
                                  double (*normals)[3])
{
    luxel_settings settings;
    luxel_status status = lx_settings_check(scene, NULL, diagnostics, &settings);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, diagnostics);
    if (status != LUXEL_OK)
        return status;
    struct lx_prepared prepared;
    status = lx_session_prepare(scene, &settings, diagnostics, &prepared);
    if (status == LUXEL_OK) {
        const struct lx_screen *screen = &prepared.scene->screen;
        size_t pixel = 0;
        for (unsigned row = 0; row < screen->resolution[1]; row++)
            for (unsigned column = 0; column < screen->resolution[0]; column++, pixel++)
                see(&prepared, lx_column_x_mm(screen, column), lx_row_y_mm(screen, row),
                    depth_mm ? depth_mm + pixel : NULL, normals ? normals[pixel] : NULL);
    }
    lx_prepared_clear(&prepared);
    return status;
}

/* SPDX-License-Identifier: MIT */
/*
 * The view of a committed scene: between places in space and the points of the screen at which the observer sees them.
 * Whether something stands in the way does not matter.  The screen is the plane z = 0 of the scene, or, of an observer
 * with a position, of a frame that was carried to its target, with the z axis towards the observer; heights are along
 * that axis.
 */
#ifndef LUXEL_VIEW_H
#define LUXEL_VIEW_H

#include <stdint.h>

#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The point (x, y) of the screen, which may lie off its edges, at which a place (x, y, z) of the scene is seen: in
 * orthographic projection straight below it, in perspective on the line from the observer through it.  Both in mm.
 * False, and nothing is written, for a scene that is not committed, numbers that are not finite, and in perspective
 * where the place is not in front of the observer, below its height.
 */
LUXEL_API bool luxel_scene_project(const luxel_scene *scene, const double position_mm[3], double screen_mm[2]);

/*
 * The other way: the place of the scene at the height z above the screen that is seen at a point (x, y) of it.  False
 * as above.
 */
LUXEL_API bool luxel_scene_unproject(const luxel_scene *scene, const double screen_mm[2], double z_mm,
                                     double position_mm[3]);

/*
 * The height of a place of the scene above the screen: its z, unless the observer has a position.  False, and nothing
 * is written, for a scene that is not committed or numbers that are not finite.
 */
LUXEL_API bool luxel_scene_height(const luxel_scene *scene, const double position_mm[3], double *z_mm);

/* What pixels show, row by row from the top: arrays with room for rows x columns elements each, of the caller's; NULL:
 * not wanted. */
typedef struct luxel_geometry {
    double *depth_mm;     /* how far it is from the observer along the observer's line of view; 0: nothing is seen */
    double (*normals)[3]; /* the unit normal of the surface, as the scene has it, towards the observer's side; or 0 */
    double (*positions_mm)[3]; /* the place, in the scene's frame; or 0 */
    int32_t *surfaces;         /* the surface's index in the scene's list; -1: nothing is seen */
    unsigned *parts;           /* its part that is seen, of a room or box one side (luxel_scene_part_name()); else 0 */
    void *reserved[4];         /* for later versions: NULL */
} luxel_geometry;

/*
 * What every pixel of a committed scene's picture shows.  It is found in float64 by the kernels that the picture is
 * made with, so it is the surface whose light the picture has; in parallel and to be cancelled by the settings
 * (NULL: the defaults), of which threads, instruction set and progress count.
 * Errors as luxel_render() lists them; LUXEL_CANCELLED: not all is there.
 */
LUXEL_API luxel_status luxel_find_geometry(const luxel_scene *scene, const luxel_settings *settings,
                                           luxel_diagnostics *diagnostics, const luxel_geometry *geometry);

#ifdef __cplusplus
}
#endif
#endif

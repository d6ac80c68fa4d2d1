/* SPDX-License-Identifier: MIT */
/*
 * The lights of a committed scene, as front ends show them: how much they give off, where they stand, which way they
 * shine.  Lights are counted as in the scene's list, and whether one is enabled does not matter.
 */
#ifndef LUXEL_LIGHT_H
#define LUXEL_LIGHT_H

#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of lights in the scene's list; 0 where it is not committed. */
LUXEL_API size_t luxel_scene_light_count(const luxel_scene *scene);

/* The type of light i, such as "point"; NULL where there is no such light.  It is the scene's and lasts until that
 * changes. */
LUXEL_API const char *luxel_scene_light_type(const luxel_scene *scene, size_t i);
/* The name of light i, which lasts as its type does; NULL where it has none, or where there is no such light. */
LUXEL_API const char *luxel_scene_light_name(const luxel_scene *scene, size_t i);
/* Whether light i is on; false where there is no such light. */
LUXEL_API bool luxel_scene_light_enabled(const luxel_scene *scene, size_t i);

/*
 * The flux that light i gives off in all, in W (lm with photometric units), to 1e-12: its radiant intensity integrated
 * over the sphere, 4 pi I of an isotropic point, pi I of a lambertian one, 2 pi I/(m + 1) by a power m > 0 of the
 * cosine; of a planar or volume source pi times its radiance times the area that shines.  The attenuation does not
 * change it.
 * NaN for ambient and distant light, which have none.
 * LUXEL_ERROR_ARGUMENT: not committed, or no such light.  LUXEL_ERROR_RANGE: beyond float64.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_scene_light_flux(const luxel_scene *scene, size_t i, double *flux);

/*
 * The radiant intensity of light i in W/sr (cd with photometric units): the same in all directions, or along
 * luxel_scene_light_direction(); of a cloud the sum over its points; of a planar source its radiance times the area of
 * one side, of a sphere times that of its cross-section.  Given by a power it is worked out, to 1e-12.
 * NaN for lights that have no such: ambient and distant ones, other bodies, clouds whose points are aimed.
 * Errors as of luxel_scene_light_flux().
 */
LUXEL_API luxel_status luxel_scene_light_intensity(const luxel_scene *scene, size_t i, double *intensity);

/*
 * Where light i stands: its position, the centre of its outline or body, in mm; of a polygon or mesh the centroid of
 * the area that shines.  False, and nothing is written, for ambient and distant light, which stand nowhere, where there
 * is no such light, and where memory is short.
 */
LUXEL_API bool luxel_scene_light_place(const luxel_scene *scene, size_t i, double position_mm[3]);

/* How many places light i has: those of its array, 1 without one; 0 where there is no such light. */
LUXEL_API size_t luxel_scene_light_place_count(const luxel_scene *scene, size_t i);
/* Where it stands at each of them, row by row of the array: so many places.  False as of luxel_scene_light_place(). */
LUXEL_API bool luxel_scene_light_places(const luxel_scene *scene, size_t i, double (*places_mm)[3]);

/*
 * The direction in which light i shines, of length 1 up to rounding: that in which distant light travels, the axis of a
 * spot or of a point whose intensity depends on it, the normal of a planar source, of its front
 * where both sides shine.  False, and nothing is written, for
 * lights that have none, ambient ones, isotropic points and volumes, where there is no such light, and where memory is
 * short.
 */
LUXEL_API bool luxel_scene_light_direction(const luxel_scene *scene, size_t i, double direction[3]);

/* Which light there is, and how far it goes. */
typedef struct luxel_light_reach {
    bool has_ambient;  /* light that is everywhere */
    bool has_direct;   /* light that comes from somewhere */
    double share;      /* of the pixels that show a surface: where some of has_direct arrives, shadows included */
    void *reserved[4]; /* for later versions: NULL */
} luxel_light_reach;

/*
 * Finds where the light of a picture arrives: a question of geometry, whatever the values are, so the tail of a
 * highlight behind the terminator counts for nothing.  The settings' group of lights counts; NULL: the defaults.
 * Errors as luxel_render() lists them.
 */
LUXEL_API luxel_status luxel_find_light_reach(const luxel_scene *scene, const luxel_settings *settings,
                                              luxel_diagnostics *diagnostics, luxel_light_reach *reach);

/*
 * A light that fits a scene, as YAML on one line, to be inserted into its list `lights`.  `wanted` is a kind, such as
 * "spot", whose example is taken, or a light in YAML, "{type: luminaire, file: ...}".  The light of index `like`, where
 * there is one, is what it becomes like: it takes its law (attenuation, pattern), stands on the other side of the first
 * surface, where no other light does, is aimed at that surface's centre, and gives as much irradiance in view, its
 * strength rounded to two digits; strengths stay as they are where pictures cannot be made, or either gives nothing,
 * and of the sky and the sun.
 * With `replaces` it stands where that light stands, is aimed as that one, and takes its name, colour and array, too.
 * The scene need not be committed, and stays as it is.  The text is the caller's: free it with luxel_text_free().
 * LUXEL_ERROR_ARGUMENT: no such kind, or one without an example, as of lights that need a file.  LUXEL_ERROR_SCENE:
 * `wanted` is no YAML.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_new_light(const luxel_scene *scene, const char *wanted, size_t like, bool replaces,
                                       luxel_diagnostics *diagnostics, char **yaml);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/*
 * Isophotes: the lines of equal value on what the screen shows.
 *
 * They are found in the picture by marching squares, a saddle being decided by the asymptotic decider (Nielson and
 * Hamann 1991), and chained.  With an evaluator each vertex is refined on the exact function and lies on its level to
 * 1e-9 relative; a line then also reaches the edge of a surface and of the screen, where it ends.  Along a line the
 * greater values lie to the left.
 */
#ifndef LUXEL_ISOPHOTES_H
#define LUXEL_ISOPHOTES_H

#include <luxel/evaluator.h>
#include <luxel/field.h>
#include <luxel/grid.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One line.  A closed one does not repeat its first vertex. */
typedef struct luxel_isophote {
    double level;       /* the value along it */
    bool closed;        /* whether it comes back to where it began */
    size_t count;       /* of vertices, 2 at least */
    const double *x_mm; /* on the screen; on the plane of a grid from its middle, along up x axis */
    const double *y_mm; /* of the vertices, on the screen; on the plane of a grid along up */
} luxel_isophote;

/* All lines, level by level in the order in which the levels were given.  The arrays live as long as it does. */
typedef struct luxel_isophotes {
    size_t count;                /* of the lines */
    const luxel_isophote *lines; /* count of them */
} luxel_isophotes;

/*
 * Finds the lines of `count` levels.  `evaluator` NULL: as the picture has them, else on the exact function of the same
 * scene and quantity.  The result is the caller's.
 * LUXEL_ERROR_ARGUMENT: a level is not finite, the field does not know its places or is not of the evaluator's scene.
 * LUXEL_CANCELLED: the evaluator's progress said so.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_find_isophotes(const luxel_field *field, const luxel_evaluator *evaluator,
                                            const double *levels, size_t count, luxel_diagnostics *diagnostics,
                                            luxel_isophotes **isophotes);

/* Frees isophotes; NULL is harmless. */
LUXEL_API void luxel_isophotes_free(luxel_isophotes *isophotes);

/*
 * Finds the lines of `count` levels on the plane of the scene's i-th grid, in the field that luxel_find_grid_field()
 * found for it, by the grid's own measure.  A line is straight between samples of the field, whose values are taken for
 * a straight rise; where light jumps, at the edge of a shadow of what is a point or far away, its vertices are moved to
 * where the light passes the level.  The result is the caller's.
 * Errors as luxel_find_grid() and luxel_find_isophotes().
 */
LUXEL_API luxel_status luxel_find_grid_isophotes(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                                 const luxel_field *field, const double *levels, size_t count,
                                                 luxel_diagnostics *diagnostics, luxel_isophotes **isophotes);

/*
 * Writes the lines on the planes of `count` grids to a .dxf file (ASCII, of release 12), whole or not at all: each a
 * polyline in space, in the scene's coordinates in mm, with its level beside it, on a layer of that level, ISOLUX_300
 * say, of several grids ISOLUX_2_300 for the second one; what is no letter or digit is written as _.  The layer GRIDS
 * has the edges of the planes, and their names.
 * LUXEL_ERROR_ARGUMENT: another extension, or no grid.  LUXEL_ERROR_FILE: it could not be written.
 */
LUXEL_API luxel_status luxel_grid_isophotes_write(const luxel_grid *const *grids,
                                                  const luxel_isophotes *const *isophotes, size_t count,
                                                  const char *path, luxel_diagnostics *diagnostics);

/*
 * Fills at most `room` levels that a reader takes in at a glance: round numbers (1, 2 or 5 times a power of ten) in
 * equal steps between low and high, both excluded, or, logarithmic, 1, 2 and 5 times each power of ten; about `wanted`
 * of them.  Returns how many.
 */
LUXEL_API size_t luxel_round_levels(double low, double high, bool logarithmic, size_t wanted, double *levels,
                                    size_t room);

#ifdef __cplusplus
}
#endif
#endif

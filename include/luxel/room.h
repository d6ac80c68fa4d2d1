/* SPDX-License-Identifier: MIT */
/*
 * Scenes of rooms to begin a lighting design with: a room with luminaires in a regular array under its ceiling, the
 * work plane as a measuring grid, and limits that they keep.  Columns and rows are as far apart as twice their distance
 * from the walls.
 */
#ifndef LUXEL_ROOM_H
#define LUXEL_ROOM_H

#include <luxel/bounded.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The flux of the panels, 0.6 m square, Lambert's law, that there are without a photometry file. */
enum { LUXEL_PANEL_LUMENS = 3600 };

/* What is known of the room. */
typedef struct luxel_room {
    double size_m[3];       /* along x, along y, its height */
    const char *file;       /* a photometry file, as the scene is to name it; NULL: panels */
    unsigned array[2];      /* columns along x and rows along y; 0, 0: the fewest that reach the target */
    double target;          /* the mean on the work plane in lx; 0: 500 without an array, else what is reached */
    double reflectances[3]; /* of ceiling, walls and floor, 0 to below 1 */
    double plane_m;         /* the height of the work plane */
    double maintenance;     /* the maintenance factor, above 0 to 1 */
    void *reserved[4];      /* for later versions: NULL */
} luxel_room;

/* Sets the defaults: reflectances 0.7, 0.5, 0.2, the plane 0.75 m high, maintenance factor 0.8; all else is 0. */
LUXEL_API void luxel_room_init(luxel_room *room);

/* An array and what it gives on the work plane, reflected light included. */
typedef struct luxel_room_array {
    unsigned n[2];         /* columns, rows; 0: there is none */
    luxel_bounded average; /* of the values, lx */
    double uniformity;     /* U0 */
    void *reserved[4];     /* for later versions: NULL */
} luxel_room_array;

/* A scene and what was found on the way. */
typedef struct luxel_room_design {
    char *text;               /* the scene file; free it with luxel_text_free() */
    luxel_room_array chosen;  /* that of the scene */
    luxel_room_array smaller; /* the next smaller regular array, where one was looked for; it misses the target */
    void *reserved[4];        /* for later versions: NULL */
} luxel_room_design;

/*
 * Makes the scene.  `path` is the file that it will be, in whose folder the photometry file is looked for; NULL: the
 * current one.  With a target arrays are tried as luxel_arrange() tries even ones, by rising numbers of luminaires,
 * those whose spacings differ by no more than 2 to 1, and of equal numbers the more uniform one is taken; a mean whose
 * bound spans the target does not reach it.  Luminaires that send more than LUXEL_ROOM_UPWARDS percent of their light
 * upwards hang half a metre below the ceiling, others are level with it.  The answer is the same for any number of
 * threads.
 * LUXEL_ERROR_ARGUMENT: NULL, a number out of its range, no light reaches the plane, or it takes more than 10 000
 * luminaires, or more than have room; reported.  Else errors as luxel_scene_commit() and luxel_find_grid() list them.
 */
LUXEL_API luxel_status luxel_design_room(const luxel_room *room, const char *path, const luxel_settings *settings,
                                         luxel_diagnostics *diagnostics, luxel_room_design *design);

#ifdef __cplusplus
}
#endif
#endif

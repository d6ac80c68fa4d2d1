/* SPDX-License-Identifier: MIT */
/*
 * Utilization factors: the share of the lamps' flux that reaches the work plane of a room under luminaires on its
 * ceiling, by reflections too.  The rooms are square, as the room index k = x y / (h (x + y)) is all that tabular
 * methods know of them, with the luminaires at the height h above the work plane.
 */
#ifndef LUXEL_UTILIZATION_H
#define LUXEL_UTILIZATION_H

#include <luxel/bounded.h>
#include <luxel/photometry.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { LUXEL_UTILIZATION_REFLECTANCES = 10 };

/* The factors of standard rooms, by the tabular method. */
typedef struct luxel_utilization_table {
    bool exists;   /* false, and no factors: types A and B, and luminaires without light downwards */
    double lumens; /* that the factors are related to: of the lamps, of absolute photometry of the luminaire */
    /* For each room index and each triple of reflectances, 0 to 1 and of lamps in reflecting rooms seldom above. */
    double factors[LUXEL_ROOM_INDICES][LUXEL_UTILIZATION_REFLECTANCES];
    void *reserved[4]; /* for later versions: NULL */
} luxel_utilization_table;

/*
 * Computes them: the direct ratios of LiTG 3.5 share out the downward flux, and floor, walls and ceiling, each evenly
 * lit, exchange it by their form factors.  LUXEL_ERROR_ARGUMENT: NULL.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_photometry_find_utilization(const luxel_photometry *photometry,
                                                         luxel_utilization_table *table);

/* The i-th reflectance of ceiling [0], walls [1] and floor [2]. */
LUXEL_API double luxel_utilization_reflectance(size_t i, size_t part);

/* A factor by the light that surfaces really reflect, any number of times. */
typedef struct luxel_room_utilization {
    luxel_bounded factor; /* related to the lumens of the table */
    bool reached;         /* whether reflected light reached its bound; see luxel_settings */
    void *reserved[4];    /* for later versions: NULL */
} luxel_room_utilization;

/*
 * Finds the factor of room index `k` and triple `triple`: a scene of the room is solved, with the luminaire of the file
 * at `path`, of which the table is, in even columns and rows about as far apart as they are high, to
 * settings->reflected_error, 0.01 where that is 0.  More than LUXEL_ROOM_UPWARDS of light upwards is the caller's to
 * refuse.  LUXEL_ERROR_ARGUMENT: NULL, a table without factors, no such room or reflectances.  Else errors as
 * luxel_find_balance() lists them.
 */
LUXEL_API luxel_status luxel_find_room_utilization(const char *path, const luxel_utilization_table *table, size_t k,
                                                   size_t triple, const luxel_settings *settings,
                                                   luxel_diagnostics *diagnostics, luxel_room_utilization *utilization);

#ifdef __cplusplus
}
#endif
#endif

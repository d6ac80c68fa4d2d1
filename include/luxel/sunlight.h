/* SPDX-License-Identifier: MIT */
/*
 * Sunlight: at which hours of a day the sun shines on places, by where it stands and what hides it; and on which parts
 * of flat surfaces it shines at one time.
 *
 * The sun counts by its middle, whatever light the scene's own sun gives, and refraction is left out.  Its place is
 * that of the Astronomical Almanac's short algorithm: to 0.01 degrees from 1950 to 2050, to 0.02 from 1900 to 2100,
 * which are the way of 2.4 and 4.8 seconds.  All surfaces of the scene hide it where its key `shadows` is not `none`;
 * glass in openings lets it through.  Ends are found to a millisecond of that sun's way; what lasts less than a second
 * may be overlooked.
 */
#ifndef LUXEL_SUNLIGHT_H
#define LUXEL_SUNLIGHT_H

#include <luxel/probe.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A day, and where: {0} and a date will do. */
typedef struct luxel_sun_day {
    const char
        *date;      /* "2026-03-21", or with the offset of its clock from UTC, which is UTC else: "2026-03-21+01:00" */
    bool has_place; /* false: the place of the scene's first light that has one with a date */
    double latitude_deg;       /* north of the equator */
    double longitude_deg;      /* east of Greenwich */
    double least_altitude_deg; /* above which the sun counts, 0 to 90 */
    void *reserved[4];         /* for later versions: NULL */
} luxel_sun_day;

/* A time at which the sun shines, in seconds from the day's midnight by its clock. */
typedef struct luxel_sun_span {
    double from_s; /* its beginning */
    double to_s;   /* its end, after it */
} luxel_sun_span;

/* What EN 17037 recommends as the least hours of sun on one day from 1 February to 21 March. */
typedef enum luxel_sun_level {
    LUXEL_SUN_NOT_KEPT, /* less than 1.5 h */
    LUXEL_SUN_MINIMUM,  /* 1.5 h */
    LUXEL_SUN_MEDIUM,   /* 3 h */
    LUXEL_SUN_HIGH,     /* 4 h */
    LUXEL_SUN_NO_LEVEL  /* the day is another one */
} luxel_sun_level;

/* The sun at one place. */
typedef struct luxel_sun_hours {
    luxel_sun_span *spans; /* when it shines, in their order; they touch nowhere */
    size_t span_count;     /* how many */
    double total_s;        /* how long together */
    luxel_sun_level level; /* which recommendation it keeps, the highest */
    void *reserved[2];     /* for later versions: NULL */
} luxel_sun_hours;

/* The sun on the cells of a measuring grid. */
typedef struct luxel_sun_grid {
    const char *name;       /* in the scene, NULL where it has none */
    unsigned columns;       /* as of luxel_grid, in the order of its values */
    unsigned rows;          /* as of luxel_grid */
    luxel_sun_hours *cells; /* rows x columns; inside a body the sun never shines */
    void *reserved[4];      /* for later versions: NULL */
} luxel_sun_grid;

/* The sun of a day. */
typedef struct luxel_sunlight {
    double latitude_deg;       /* of the place */
    double longitude_deg;      /* of the place */
    double least_altitude_deg; /* above which the sun counted */
    int zone_minutes;          /* how far the day's clock is before UTC */
    luxel_sun_hours open;      /* under the open sky: from where it rises to where it sets */
    luxel_sun_grid *grids;     /* all of the scene */
    size_t grid_count;         /* how many */
    luxel_sun_hours *elements; /* of the places that were asked */
    size_t element_count;      /* how many */
    void *reserved[4];         /* for later versions: NULL */
} luxel_sunlight;

/*
 * Finds when the sun shines on the cells of all grids of a committed scene and on free elements, on their front.  Which
 * ways are up and north says that light of the scene that the place is taken from, else its first sun or sky; else z
 * is up and y is north.  Of the settings (NULL: the defaults) threads and progress count.  The result is the caller's:
 * free it with luxel_sunlight_free().
 * Errors as luxel_render() lists them; LUXEL_ERROR_ARGUMENT: the date cannot be read, a number is out of its range, or
 * there is no place; a place is none, or one of the screen.
 */
LUXEL_API luxel_status luxel_find_sunlight(const luxel_scene *scene, const luxel_settings *settings,
                                           const luxel_sun_day *day, const luxel_place *places, size_t place_count,
                                           luxel_diagnostics *diagnostics, luxel_sunlight **sunlight);

/* Does nothing with NULL. */
LUXEL_API void luxel_sunlight_free(luxel_sunlight *sunlight);

/* A part of a flat surface's front on which the middle of the sun shines: a convex polygon. */
typedef struct luxel_sun_patch {
    size_t surface;           /* whose it is, as an index in the scene's list */
    const char *surface_name; /* its name in the scene, NULL where it has none */
    const char *part;         /* of a room or a box, such as "floor"; else NULL */
    bool has_opening;         /* whether the sun comes through an opening of the room around it */
    size_t room;              /* then the index of that room in the scene's list, */
    size_t opening;           /* and which of its openings, as in openings[0] */
    double (*corners_mm)[3];  /* its corners, counter-clockwise as seen from the surface's front */
    size_t corner_count;      /* how many */
    double area_mm2;          /* its area */
    size_t *others;           /* surfaces that may take some of it, as what is round or a mesh is not cut out of it */
    size_t other_count;       /* how many */
    void *reserved[2];        /* for later versions: NULL */
} luxel_sun_patch;

/* The patches of sun of a scene. */
typedef struct luxel_sun_patches {
    double towards[3];     /* the unit vector to the sun */
    double altitude_deg;   /* of it */
    luxel_sun_patch *list; /* surface by surface, of pieces that together are all that is lit and share no area */
    size_t count;          /* how many */
    void *reserved[4];     /* for later versions: NULL */
} luxel_sun_patches;

/*
 * Finds what the sun of a committed scene, that of the first light that has one, shines on of its rectangles, boxes and
 * rooms: the openings of a room cast along its direction, or the whole of what is outside of rooms, less the shadows of
 * all that is flat, unless the scene's key `shadows` is `none`.  Positions are float64 ones without a bound.  The
 * result is the caller's: free it with luxel_sun_patches_free().
 * LUXEL_ERROR_ARGUMENT: not committed.  LUXEL_ERROR_SCENE: it has no sun.
 */
LUXEL_API luxel_status luxel_find_sun_patches(const luxel_scene *scene, luxel_diagnostics *diagnostics,
                                              luxel_sun_patches **patches);

/* Does nothing with NULL. */
LUXEL_API void luxel_sun_patches_free(luxel_sun_patches *patches);

#ifdef __cplusplus
}
#endif

#endif

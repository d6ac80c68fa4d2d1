/* SPDX-License-Identifier: MIT */
/*
 * Daylight factors: the illuminance of a place by the sky as a share of that of a horizontal plane under the open sky,
 * in percent.  The sun does not count, nor do lamps.  Parts: what comes from the sky itself, what from outside beyond
 * that (the ground), and what surfaces reflect, where the scene's `reflections` ask for it.
 *
 * EN 17037 asks, by its method of daylight factors, for what share of a plane reaches so many lx where there are
 * `outdoor` lx under the open sky: in the middle of the hours of daylight of the place.
 */
#ifndef LUXEL_DAYLIGHT_H
#define LUXEL_DAYLIGHT_H

#include <luxel/bounded.h>
#include <luxel/probe.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The daylight of a place, in percent, with bounds. */
typedef struct luxel_daylight_factor {
    bool has_value;         /* false where a source lies on it, or a cell is inside a body; then all is 0 */
    luxel_bounded value;    /* the daylight factor, the sum of: */
    luxel_bounded sky;      /* what comes from the sky, */
    luxel_bounded external; /* from the ground, */
    luxel_bounded internal; /* and from surfaces that reflect it */
    void *reserved[2];      /* for later versions: NULL */
} luxel_daylight_factor;

/* How many levels of illuminance EN 17037 has. */
enum { LUXEL_DAYLIGHT_LEVELS = 4 };
/* The i-th of them in lx, lowest first. */
LUXEL_API double luxel_daylight_level(size_t i);

/* The daylight of a measuring grid. */
typedef struct luxel_daylight_grid {
    const char *name;                     /* in the scene, NULL where it has none */
    unsigned columns;                     /* as of luxel_grid, in the order of its values */
    unsigned rows;                        /* as of luxel_grid */
    luxel_daylight_factor *cells;         /* rows x columns */
    size_t measured;                      /* how many have a value; the next two are 0 where none has */
    luxel_bounded mean;                   /* of the values */
    luxel_bounded median;                 /* of the values */
    double shares[LUXEL_DAYLIGHT_LEVELS]; /* of them that reach each level for certain, 0 to 1; NaN: see `outdoor` */
    void *reserved[4];                    /* for later versions: NULL */
} luxel_daylight_grid;

/* The daylight of a scene. */
typedef struct luxel_daylight {
    luxel_bounded horizontal;   /* the irradiance of a horizontal plane under the open sky, in the scene's unit */
    double outdoor;             /* in lx: as it was asked, else `horizontal`; NaN where the units are radiometric */
    luxel_daylight_grid *grids; /* all of the scene */
    size_t grid_count;          /* how many */
    luxel_daylight_factor *elements; /* the places that were asked */
    size_t element_count;            /* how many */
    bool reached;                    /* whether all errors are as small as the settings ask for */
    void *reserved[4];               /* for later versions: NULL */
} luxel_daylight;

/*
 * Finds the daylight factors of all grids of a committed scene and of free elements.  `outdoor`: lx under the open sky;
 * 0: those of the scene's own sky.  `settings` NULL: the defaults; their quantity and lights do not count.  The result
 * is the caller's: free it with luxel_daylight_free().  Errors as luxel_render() lists them; LUXEL_ERROR_SCENE: there
 * is no sky, or it is dark.
 */
LUXEL_API luxel_status luxel_find_daylight(const luxel_scene *scene, const luxel_settings *settings,
                                           const luxel_place *places, size_t place_count, double outdoor,
                                           luxel_diagnostics *diagnostics, luxel_daylight **daylight);

/* Does nothing with NULL. */
LUXEL_API void luxel_daylight_free(luxel_daylight *daylight);

#ifdef __cplusplus
}
#endif

#endif

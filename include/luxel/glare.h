/* SPDX-License-Identifier: MIT */
/*
 * Discomfort glare: the unified glare rating (UGR) of CIE 117, 8 lg(0.25 / Lb · Σ L² ω / p²), of the luminances L of
 * luminaires that are seen under solid angles ω and with position indices p before a background of the luminance Lb.
 */
#ifndef LUXEL_GLARE_H
#define LUXEL_GLARE_H

#include <luxel/balance.h>
#include <luxel/photometry.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { LUXEL_UGR_ROOMS = 19, LUXEL_UGR_REFLECTANCES = 5 };

/* UGR in standard rooms under even grids of a luminaire, by the tabular method of CIE 190. */
typedef struct luxel_ugr_table {
    bool exists;    /* false, and no ratings: types A and B, and points, have no luminance towards an observer */
    double spacing; /* between luminaires, over their height above the eye */
    /* In each room, of luminaires crosswise [0], their C = 0 along the line of sight, and endwise [1], their C = 90
     * along it, for each triple of reflectances.  NaN: no luminaire is seen to shine, or its area is not seen. */
    double ratings[LUXEL_UGR_ROOMS][2][LUXEL_UGR_REFLECTANCES];
    /* The luminance Lb of the background in cd/m², where the luminaires are 1 m above the eye; it falls with the square
     * of that height. */
    double backgrounds[LUXEL_UGR_ROOMS][LUXEL_UGR_REFLECTANCES];
    void *reserved[4]; /* for later versions: NULL */
} luxel_ugr_table;

/*
 * Computes it for a spacing of 1, 1/2, 1/3 ... 1/8 of the height; catalogues have 0.25, the example of CIE 190 has 1.
 * LUXEL_ERROR_ARGUMENT: NULL, another spacing.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_photometry_find_ugr_table(const luxel_photometry *photometry, double spacing,
                                                       luxel_ugr_table *table);

/* The size of the i-th room in heights of the luminaires above the eye: [0] across, [1] along the line of sight. */
LUXEL_API double luxel_ugr_room(size_t i, size_t axis);
/* The i-th reflectance of ceiling [0], walls [1] and floor [2]. */
LUXEL_API double luxel_ugr_reflectance(size_t i, size_t part);

/* A luminaire sends less than this part of its light upwards, in percent, in a room that is rated with reflected light:
 * what the ceiling makes of it depends on how far below it the luminaire hangs; it is less than 0.05 of ratings. */
#define LUXEL_ROOM_UPWARDS 0.3

/* One room by the light that its surfaces really reflect, any number of times. */
typedef struct luxel_room_rating {
    luxel_bounded background; /* Lb in cd/m², where the luminaires are 1 m above the eye */
    double ratings[2];        /* UGR crosswise and endwise, with the glare of the table; NaN: nothing dazzles */
    double error;             /* bounds what the error of the background makes of both */
    bool reached;             /* whether reflected light reached its bound; see luxel_settings */
    void *reserved[4];        /* for later versions: NULL */
} luxel_room_rating;

/*
 * Rates room `room` of a table with the reflectances `triple` (luxel_ugr_room(), luxel_ugr_reflectance()): a scene of
 * it under the luminaire of the file at `path`, of which the table is, is solved with reflected light, to
 * settings->reflected_error, 0.01 where that is 0.  More than LUXEL_ROOM_UPWARDS of light upwards is the caller's to
 * refuse.  LUXEL_ERROR_ARGUMENT: NULL, a table without ratings, no such room or reflectances.  Else errors as
 * luxel_find_balance() lists them.
 */
LUXEL_API luxel_status luxel_find_room_rating(const char *path, const luxel_ugr_table *table, size_t room,
                                              size_t triple, const luxel_settings *settings,
                                              luxel_diagnostics *diagnostics, luxel_room_rating *rating);

/* An observer who looks in a direction. */
typedef struct luxel_glare_sight {
    double eye_mm[3]; /* where the eye is */
    double view[3];   /* the way it looks, of any length but 0 */
    /* The observer's upward direction, not along the view; all 0: what a room's `up` names, else the scene's
     * observer.up, else (0, 0, 1), or (0, 1, 0) where the view is along that. */
    double up[3];
    void *reserved[4]; /* for later versions: NULL */
} luxel_glare_sight;

/* Whether a light counts, and why it does not. */
typedef enum luxel_glare_reason {
    LUXEL_GLARE_COUNTS,
    LUXEL_GLARE_NO_AREA,   /* it is a point or a cloud of them, or comes from afar, and so has no luminance */
    LUXEL_GLARE_UNSEEN,    /* it lies outside the field of view: below the line of sight, more than 3 aside or 1.9 above
                            * for 1 ahead */
    LUXEL_GLARE_HIDDEN,    /* surfaces hide all of it */
    LUXEL_GLARE_DARK,      /* it shines elsewhere */
    LUXEL_GLARE_BACKGROUND /* it comes from everywhere (ambient) and is part of the background */
} luxel_glare_reason;

/* One light, or one place of its array, as the observer sees it. */
typedef struct luxel_glare_source {
    size_t light;              /* index in the scene's list */
    const char *type;          /* the light's type, such as "luminaire" */
    const char *name;          /* the light's name in the scene, NULL where it has none; lives as long as the rating */
    luxel_glare_reason reason; /* the numbers below are 0 where it has no area or is no source */
    double luminance;          /* its mean towards the eye, in cd/m² or W/(sr m²) */
    double solid_angle;        /* of its luminous area, in sr: the area that it shows over the square of its distance */
    double seen;               /* the share of its light that surfaces let through, 0 to 1 */
    double position_index;     /* by the direction of its middle; NaN outside the field of view */
    double share;              /* of the glare, 0 to 1 */
    size_t place;              /* of the light's array, row by row */
    size_t places;             /* how many that has; 1 without an array */
    void *reserved[2];         /* for later versions: NULL */
} luxel_glare_source;

/* The unified glare rating of an observer. */
typedef struct luxel_glare {
    bool has_rating;             /* false where nothing dazzles, the background is dark, or units are radiometric */
    luxel_bounded rating;        /* UGR */
    luxel_bounded background;    /* Lb: the irradiance of the eye by reflected and ambient light over pi */
    bool reached;                /* whether reflected light reached its bound; see luxel_settings */
    size_t source_count;         /* of the next */
    luxel_glare_source *sources; /* the lights that give light, place by place, in the order of the scene */
} luxel_glare;

/*
 * Rates what an observer sees, with shadows and with the reflected light of scenes that have it; a scene without
 * reflections and ambient light has no background and so no rating.  The lengths of light sources are small against
 * their distances, as the rating has it: each is one source at its middle.  The rating's error covers all of these
 * numbers.  The rating is the caller's: free it with luxel_glare_free().  LUXEL_ERROR_ARGUMENT: a direction is 0 or
 * not finite.  Else errors as luxel_render() lists them.
 */
LUXEL_API luxel_status luxel_find_glare(const luxel_scene *scene, const luxel_settings *settings,
                                        const luxel_glare_sight *sight, luxel_diagnostics *diagnostics,
                                        luxel_glare **glare);

/* Frees a rating; NULL is harmless. */
LUXEL_API void luxel_glare_free(luxel_glare *glare);

/* The English words of a reason, for callers to translate; NULL: no such reason. */
LUXEL_API const char *luxel_glare_reason_words(luxel_glare_reason reason);

#ifdef __cplusplus
}
#endif
#endif

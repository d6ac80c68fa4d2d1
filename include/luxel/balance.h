/* SPDX-License-Identifier: MIT */
/*
 * Where the light of a scene stays whose surfaces reflect it: the mean irradiance of each side of the surfaces, and the
 * balance of the flux.
 *
 * The light that arrives at surfaces directly is absorbed by them or escapes, after any number of bounces, to where
 * there is no surface; where the scene asks for N bounces only, some is reflected once more and not followed.  The sum
 * of all that is compared with what arrives: the difference, in truth 0, is a check of the whole calculation.
 *
 * Each number has a bound of its error, which covers what is reflected as the bounds of probes do.
 */
#ifndef LUXEL_BALANCE_H
#define LUXEL_BALANCE_H

#include <luxel/bounded.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The sides of surfaces: of what is flat by its normal, of what is round by its middle. */
typedef enum luxel_surface_side {
    LUXEL_SIDE_FRONT,
    LUXEL_SIDE_BACK,
    LUXEL_SIDE_OUTSIDE,
    LUXEL_SIDE_INSIDE
} luxel_surface_side;

/* The English word of a side, for callers to translate: "front", "back", "outside", "inside"; NULL: no such side. */
LUXEL_API const char *luxel_surface_side_name(luxel_surface_side side);

/* The light on one side of a surface. */
typedef struct luxel_balance_side {
    size_t surface;           /* as an index in the scene */
    const char *surface_name; /* its name in the scene, NULL where it has none; lives as long as the balance */
    unsigned part;            /* of a room the wall, of a box the side; else 0 */
    const char *part_name;    /* its name, as of luxel_scene_part_name(); NULL where the surface is one by itself */
    luxel_surface_side side;  /* which side of it; the walls of a room face it with their front */
    double area_m2;           /* of the side */
    double reflectance;       /* how much of the light it sends back, in colour of the light that it gets */
    luxel_bounded direct;     /* the mean irradiance by light that comes from the sources */
    luxel_bounded irradiance; /* the mean irradiance by all light */
    void *reserved[4];        /* for later versions: NULL */
} luxel_balance_side;

/* The balance of a scene; all fluxes are in W or lm. */
typedef struct luxel_balance {
    const char *unit;                /* of irradiances, in UTF-8 */
    const char *flux_unit;           /* "W" or "lm" */
    size_t side_count;               /* of the next */
    const luxel_balance_side *sides; /* those that light may reach, in the order of the surfaces; fronts come first */
    bool has_emitted;                /* false with ambient or distant light, and where not all surfaces throw shadows */
    luxel_bounded emitted;           /* what all sources give off; 0 without has_emitted */
    luxel_bounded missed;            /* of that, what meets no surface: emitted - arrives; 0 without has_emitted */
    luxel_bounded arrives;           /* what arrives at surfaces directly */
    luxel_bounded absorbed;          /* by all surfaces */
    luxel_bounded escaped;           /* what was reflected, and meets no surface any more */
    luxel_bounded pending;           /* what is reflected after the last of N bounces; 0 with all of them */
    luxel_bounded difference;        /* absorbed + escaped + pending - arrives, in truth 0 */
    bool closes;                     /* the difference is within its bound, and no more arrives than is emitted */
    bool reached; /* each error of a mean is at most reflected_error times the greatest; see settings */
} luxel_balance;

/*
 * Finds the balance of a committed scene with reflected light, in colour of the luminance; NULL where it wants none.
 * `settings` NULL: the defaults; of them count tolerance, reflected_error, threads and progress.  A bound that was not
 * reached is advice, "balance-error", too.  The balance is the caller's: free it with luxel_balance_free().
 * Errors as luxel_render() lists them.
 */
LUXEL_API luxel_status luxel_find_balance(const luxel_scene *scene, const luxel_settings *settings,
                                          luxel_diagnostics *diagnostics, luxel_balance **balance);

/* Frees a balance; NULL is harmless. */
LUXEL_API void luxel_balance_free(luxel_balance *balance);

#ifdef __cplusplus
}
#endif
#endif

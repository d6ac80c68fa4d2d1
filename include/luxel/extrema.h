/* SPDX-License-Identifier: MIT */
/*
 * Continuous extrema: the true maximum and minimum over what the screen shows of the surfaces, between the pixels, on
 * the exact function.
 *
 * They are looked for from the picture's local extrema and from the places where geometry puts a peak (facing a source,
 * and mirroring it), then refined by Newton's method; along the edge of a surface and of the screen, where the extremum
 * may lie too, on that edge.  The edges of surface, screen and region belong to them.
 */
#ifndef LUXEL_EXTREMA_H
#define LUXEL_EXTREMA_H

#include <luxel/evaluator.h>
#include <luxel/statistics.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Where an extremum lies. */
typedef enum luxel_peak_place {
    LUXEL_PEAK_INSIDE, /* within the surface: the function is level there */
    LUXEL_PEAK_LIMB,   /* on the rim of what is seen of the surface */
    LUXEL_PEAK_BORDER, /* on the edge of the screen or of the region */
    LUXEL_PEAK_JUMP,   /* where the function jumps or has a kink: the edge of a shadow, hard cone, gated highlight */
    LUXEL_PEAK_PLATEAU /* in a part of one value, such as what is quite dark: the place is one of many */
} luxel_peak_place;

/* One extremum. */
typedef struct luxel_peak {
    bool exists;            /* false where no surface is seen; then the rest is 0 */
    double value;           /* the exact value there */
    double error;           /* bounds |value - truth at this very place| */
    double x_mm;            /* on the screen; of a sphere's rim, which it does not resolve, as near as it shows it */
    double y_mm;            /* on the screen; of a sphere's rim, which it does not resolve, as near as it shows it */
    size_t surface;         /* index in the scene's list */
    unsigned part;          /* of a room the wall, of a box the side (luxel_scene_part_name()); else 0 */
    double position_mm[3];  /* on the surface */
    double normal[3];       /* the unit normal there */
    luxel_peak_place place; /* where it lies */
    void *reserved[4];      /* for later versions: NULL */
} luxel_peak;

/* Both. */
typedef struct luxel_extrema {
    luxel_peak maximum; /* the greatest value */
    luxel_peak minimum; /* the least value */
    void *reserved[4];  /* for later versions: NULL */
} luxel_extrema;

/*
 * Finds the extrema.  `field` is a picture of the evaluator's scene and quantity, which tells where to look; its
 * resolution decides how narrow a peak may be that no geometry foretells.  `region` NULL: all that the screen shows.
 * LUXEL_ERROR_ARGUMENT: the field is not of that scene's screen and quantity, or the region does not go.
 * LUXEL_CANCELLED: the settings' progress said so.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_find_extrema(const luxel_evaluator *evaluator, const luxel_field *field,
                                          const luxel_region *region, luxel_diagnostics *diagnostics,
                                          luxel_extrema *extrema);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/*
 * Profiles: the values along a line of the screen, or along a great circle of a sphere by the angle, exact or as the
 * picture has them, in all and light by light.
 */
#ifndef LUXEL_PROFILE_H
#define LUXEL_PROFILE_H

#include <luxel/evaluator.h>
#include <luxel/field.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a profile runs along. */
typedef enum luxel_profile_path_type {
    LUXEL_PATH_LINE, /* a straight line of the screen; the abscissa is the distance from its beginning, in mm */
    LUXEL_PATH_ARC   /* the great circle of a sphere through the two places of it that are seen through from and to; the
                        abscissa is the angle at the sphere's centre from the first place, in degrees */
} luxel_profile_path_type;

/* A way between two places. */
typedef struct luxel_profile_path {
    luxel_profile_path_type type; /* what it runs along */
    double from_mm[2];            /* on the screen; two different places */
    double to_mm[2];              /* on the screen; two different places */
    size_t samples;               /* 2 to 10 000 000, both ends among them, in equal steps of the abscissa */
    void *reserved[4];            /* for later versions: NULL */
} luxel_profile_path;

/* One value of a profile. */
typedef struct luxel_profile_sample {
    double abscissa; /* mm or degrees */
    double x_mm;     /* on the screen */
    double y_mm;     /* on the screen */
    bool has_value;  /* false off the surfaces, and where a source lies on the element */
    double value;    /* in the unit of luxel_scene_unit() */
    double error;    /* bounds |value - truth|; 0 where the value is the picture's */
} luxel_profile_sample;

/* A profile.  Its arrays live as long as it does. */
typedef struct luxel_profile {
    luxel_profile_path_type type;        /* what it runs along */
    luxel_quantity quantity;             /* what its values are */
    const char *quantity_word;           /* its name: brightness, luminance, irradiance, illuminance or values */
    size_t count;                        /* of the samples */
    const luxel_profile_sample *samples; /* count of them */
    size_t lights;                       /* of the scene; 0 where the values are the picture's */
    const double *shares; /* count x lights: what each light gives, 0 where there is no value; NULL where lights is 0 */
} luxel_profile;

/*
 * The two ends of the line across the screen through a point of it, at an angle in degrees from the x axis, counter-
 * clockwise (0: horizontal, from the left; 90: vertical, from the bottom).
 * LUXEL_ERROR_ARGUMENT: the scene is not committed, or the line misses the screen.
 */
LUXEL_API luxel_status luxel_profile_line(const luxel_scene *scene, const double through_mm[2], double degrees,
                                          luxel_diagnostics *diagnostics, double from_mm[2], double to_mm[2]);

/*
 * The exact profile, light by light.  The profile is the caller's.
 * LUXEL_ERROR_ARGUMENT: the path does not go; for an arc: the places are not both on one sphere, or are opposite.
 * LUXEL_CANCELLED: the settings' progress said so.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_find_profile(const luxel_evaluator *evaluator, const luxel_profile_path *path,
                                          luxel_diagnostics *diagnostics, luxel_profile **profile);

/*
 * The profile of a picture: the value of the pixel that each place falls in.  Only lines; off the screen there is no
 * value.  LUXEL_ERROR_ARGUMENT: as above, or the field does not know its places.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_field_profile(const luxel_field *field, const luxel_profile_path *path,
                                           luxel_diagnostics *diagnostics, luxel_profile **profile);

/* Frees a profile; NULL is harmless. */
LUXEL_API void luxel_profile_free(luxel_profile *profile);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/*
 * Colours of light: what three channels say as chromaticity and colour temperature, and which channels black bodies
 * have.
 *
 * Channels are linear sRGB: the primaries of ITU-R BT.709 and the white (0.3127, 0.3290).  They may be negative, for
 * light that is more saturated than what these primaries mix.  X, Y, Z are those of the CIE 1931 standard observer (2
 * degrees), Y the luminance.  Planck's law takes c2 = 1.438776877e-2 m K and wavelengths in vacuum, and is summed from
 * 360 to 830 nm in steps of 1 nm.
 */
#ifndef LUXEL_COLOUR_H
#define LUXEL_COLOUR_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The channels R, G, B of a value in a scene with `channels: rgb`. */
typedef struct luxel_color {
    bool exists;     /* false in a grey scene, and where there is no value; then the rest is 0 */
    double rgb[3];   /* linear sRGB, in the unit of the value, which is their luminance */
    double error[3]; /* bounds |channel - truth| */
} luxel_color;

/* The colour that channels mean. */
typedef struct luxel_chromaticity {
    double xyz[3]; /* X, Y, Z */
    bool has_xy;   /* false where the luminance is 0; then the rest is 0 */
    double xy[2];  /* the chromaticity of 1931 */
    double uv[2];  /* u', v' of 1976 */
    bool has_cct;  /* whether a colour temperature means something: 1000 to 25000 K, |duv| at most 0.05 */
    double cct_k;  /* of the black body that is nearest in u, v of 1960, found to 1e-6 K */
    double duv;    /* the distance from it in u, v; above 0 on the side of green */
} luxel_chromaticity;

/* The luminance of channels: 0.2126390058715 R + 0.7151686787678 G + 0.0721923153607 B, a number by itself if equal. */
LUXEL_API double luxel_rgb_luminance(const double rgb[3]);

/* The colour of channels. */
LUXEL_API void luxel_find_chromaticity(const double rgb[3], luxel_chromaticity *chromaticity);

/* The channels of a chromaticity (x, y), y above 0, at luminance 1. */
LUXEL_API void luxel_xy_to_rgb(const double xy[2], double rgb[3]);

/* The chromaticity of a black body with this temperature, above 0. */
LUXEL_API void luxel_planck_xy(double kelvin, double xy[2]);

/* The curve of sRGB: the level, 0 to 1, by which a display shows a channel from 0 to 1. */
LUXEL_API double luxel_srgb_curve(double channel);

/* Whether a committed scene has channels: rgb, so that its values have a color. */
LUXEL_API bool luxel_scene_has_color(const luxel_scene *scene);

/* The channels of the i-th light of a committed scene at luminance 1, those of white light where it has no color.
 * LUXEL_ERROR_ARGUMENT: not committed, or no such light. */
LUXEL_API luxel_status luxel_scene_light_rgb(const luxel_scene *scene, size_t i, double rgb[3]);

#ifdef __cplusplus
}
#endif
#endif

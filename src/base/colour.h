/* SPDX-License-Identifier: MIT */
/* Colour science for those who read colours: spectra as seen by the standard observer, and which colours are light's.
 * */
#ifndef LX_BASE_COLOUR_H
#define LX_BASE_COLOUR_H

#include <luxel/colour.h>

/* Wavelengths of the observer's table: from 360 nm on in steps of 1 nm. */
enum { LX_FIRST_NM = 360, LX_WAVELENGTHS = 471 };

/* The chromaticity of a spectrum by that table; false: it has no luminance. */
bool lx_spectrum_xy(const double power[LX_WAVELENGTHS], double xy[2]);

/* Black bodies one beside the other, for whoever asks for the temperatures of many colours; the caller's, free(); NULL:
 * memory ran out. */
struct lx_black_bodies;
struct lx_black_bodies *lx_black_bodies_new(void);
/* The colour temperature of channels as luxel_find_chromaticity() has it, to a part in a million; 0: there is none. */
double lx_black_body_near(const struct lx_black_bodies *bodies, const double rgb[3]);

/* Whether some light has the chromaticity: it lies within the spectral locus and the line of purples. */
bool lx_is_light(const double xy[2]);

#endif

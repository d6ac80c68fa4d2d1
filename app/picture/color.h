/* SPDX-License-Identifier: MIT */
/* Colours of values in numbers and words, as the command line has them: channels, chromaticity, temperature. */
#ifndef LUXEL_APP_COLOR_H
#define LUXEL_APP_COLOR_H

#include <luxel/colour.h>

#include "display.h"

/* The mean of each channel of the pixels on a surface, as `luxel stats` has it; of a picture in colour, else none. */
luxel_color app_color_mean(const luxel_field *field);

/* The number of a channel at a value, which is the luminance; NaN: it has none. */
double app_color_number(const luxel_color *color, double value, AppChannel channel);

/* "R, G, B 1.2, 0.9, 0.3"; the caller's. */
char *app_color_channels(const luxel_color *color);
/* Channels with the bound of each, "R 1.2 ± 0.00001", a line for each; the caller's. */
char *app_color_bounds(const luxel_color *color);
/* "x, y 0.45780, 0.41010"; "" of no light; the caller's. */
char *app_color_place(const luxel_color *color);
/* "2700 K, Duv 0.0004", or that there is none; "" of no light; the caller's. */
char *app_color_temperature(const luxel_color *color);

#endif

/* SPDX-License-Identifier: MIT */
/* The authored colour of a light: its parameter table and the struct behind it. */
#ifndef LX_LIGHT_COLOUR_H
#define LX_LIGHT_COLOUR_H

#include "../parameter/table.h"

struct lx_spectrum;

struct lx_light_color {
    uint64_t given;
    double temperature, xy[2], rgb[3];
    const char *spectrum;
    struct lx_spectrum *read; /* of that file */
    double channels[3];       /* what they all come to: linear sRGB at luminance 1 */
};

extern const struct lx_table lx_light_color_table;

#endif

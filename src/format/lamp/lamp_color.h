/* SPDX-License-Identifier: MIT */
/* What the words that a luminaire's file has for its lamp say of the colour of the light. */
#ifndef LX_FORMAT_LAMP_COLOR_H
#define LX_FORMAT_LAMP_COLOR_H

#include <luxel/photometry.h>

enum { LX_MOST_KELVINS = 4 };

struct lx_lamp_color {
    size_t count; /* of different colour temperatures, up to so many; with more than one the words leave it open */
    double kelvins[LX_MOST_KELVINS];
    char code[4]; /* where they are told by the lamp's code, such as "840", that; else "" */
};

/*
 * Reads "4000 K", "4000", "3000/4000 K", "2700-6500 K", "4,000 K" and, where there is no such number, the codes "840"
 * (the index of colour rendering in tens, hundreds of kelvins); numbers that are none of these are passed over.
 * `needs_unit`: only what has its K counts.
 */
void lx_read_lamp_color(const char *words, bool needs_unit, struct lx_lamp_color *color);

/* That of the first lamps of a file that tell one, by their line or, in LM-63, by the name of the lamp. */
struct lx_lamp_color lx_lamp_color_of(const luxel_photometry *photometry);

#endif

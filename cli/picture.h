/* SPDX-License-Identifier: MIT */
/* Pictures that commands look at: of a scene, computed, or from a file of values (.npy, .pfm, .exr, .csv). */
#ifndef LUXEL_CLI_PICTURE_H
#define LUXEL_CLI_PICTURE_H

#include "load.h"

struct picture {
    struct loaded loaded;   /* its scene is NULL where the values come from a file */
    struct options options; /* as they count for this picture */
    luxel_field *field;
    int code; /* EXIT_TOLERANCE: its reflected light is less exact than was asked for, which was said; else EXIT_DONE */
};

/* Whether a name ends as that of a file of values. */
bool picture_holds_values(const char *operand);

/*
 * Computes the picture of a scene, or reads a file whose name ends as files of values do.  Returns an enum exit_code;
 * errors are printed here.  picture_close() is due in either case.
 */
int picture_open(const struct options *options, const char *operand, struct picture *picture);
void picture_close(struct picture *picture);

/* Its unit, "" where it is not known, and its quantity, as words that are not translated yet. */
const char *picture_unit(const struct picture *picture);
const char *picture_quantity(const struct picture *picture);

/* "brightness" or "irradiance", as JSON says it. */
const char *picture_quantity_name(const struct picture *picture);
/* "name: brightness in W/sr, 360 × 360 pixels" */
void picture_print_heading(const struct picture *picture);

#endif

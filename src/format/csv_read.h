/* SPDX-License-Identifier: MIT */
/* Reading tables of pixels, and what they have in common with writing them. */
#ifndef LX_FORMAT_CSV_READ_H
#define LX_FORMAT_CSV_READ_H

#include "../base/text.h"
#include "format.h"

#define LX_CSV_NAME "CSV"
/* What the first line begins with, and the beginning of its last field, which the unit ends. */
#define LX_CSV_PLACES "x_mm,y_mm,"
#define LX_CSV_VALUE "value_"

/* The digits that tell one float32 from every other. */
enum { LX_CSV_SINGLE_DIGITS = 9 };
/* Digits of a place on the screen: enough for any picture, too few to show the roundings of its samples. */
enum { LX_CSV_PLACE_DIGITS = 12 };

/* Adds a field to a line; in quotes where it has a character that would end it. */
void lx_csv_add_field(struct lx_text *line, const char *field);

/*
 * Reads a table of pixels, in any order, into the smallest grid that holds them all; what is missing of it is off the
 * mask.  The samples are float32 if every value is written as a float32 is written here, else float64.
 */
luxel_status lx_csv_read(struct lx_source *source, struct lx_loaded *loaded);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Fields: the computed picture, a grid of numbers in their unit, with its statistics and grey levels.
 *
 * Row 0 is the top of the picture (largest y), column 0 the smallest x; values lie row by row.  A pixel off
 * every surface holds 0 and is off the mask.  A field is never changed after it was made, so several threads
 * may read it; it keeps nothing of the scene alive.
 */
#ifndef LUXEL_FIELD_H
#define LUXEL_FIELD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <luxel/diagnostics.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum luxel_quantity {
    LUXEL_BRIGHTNESS, /* sum of the lights' brightness by the material */
    LUXEL_IRRADIANCE  /* sum of E_perp max(0, N.L) and ambient irradiance */
} luxel_quantity;

typedef enum luxel_precision {
    LUXEL_SINGLE, /* float32: within 2e-6 of the picture's maximum */
    LUXEL_DOUBLE  /* float64: within 1e-11 of the picture's maximum */
} luxel_precision;

typedef struct luxel_field luxel_field;

/* One extreme value; `exists` is false where no pixel qualifies. */
typedef struct luxel_extremum {
    bool exists;
    double value;
    unsigned column, row;
    double x_mm, y_mm; /* of the sample on the screen */
} luxel_extremum;

typedef struct luxel_statistics {
    luxel_extremum maximum;
    luxel_extremum minimum;  /* the smallest value of at least 1.2e-38; ties: first in row order */
    bool has_surface;        /* whether any pixel shows a surface; the next two are 0 otherwise */
    double mean;             /* plain mean over the pixels on a surface */
    double lit;              /* share of them from 1.2e-38 up */
    size_t surface_pixels;
} luxel_statistics;

LUXEL_API void luxel_field_free(luxel_field *field);

LUXEL_API unsigned luxel_field_columns(const luxel_field *field);
LUXEL_API unsigned luxel_field_rows(const luxel_field *field);
LUXEL_API unsigned luxel_field_channels(const luxel_field *field); /* 1 */
LUXEL_API luxel_quantity luxel_field_quantity(const luxel_field *field);
LUXEL_API luxel_precision luxel_field_precision(const luxel_field *field);
/* The unit in UTF-8, such as "W/sr", "cd/m²" or "relative". */
LUXEL_API const char *luxel_field_unit(const luxel_field *field);
/* The instruction set whose kernels made it, such as "x86-64-v3". */
LUXEL_API const char *luxel_field_instruction_set(const luxel_field *field);

/* The values, rows x columns; each returns NULL for a field of the other precision. */
LUXEL_API const float *luxel_field_single(const luxel_field *field);
LUXEL_API const double *luxel_field_double(const luxel_field *field);
/* rows x columns bytes: 1 on a surface, 0 off. */
LUXEL_API const uint8_t *luxel_field_mask(const luxel_field *field);
/* One value whatever the precision; 0 outside the grid. */
LUXEL_API double luxel_field_value(const luxel_field *field, unsigned column, unsigned row);

LUXEL_API const luxel_statistics *luxel_field_statistics(const luxel_field *field);

/* Fills rows x columns bytes with the grey levels 0..255 by the rule of the scene's `picture`. */
LUXEL_API void luxel_field_grey(const luxel_field *field, uint8_t *grey);

/*
 * Writes the field to a file, by the ending of its name: .png (8-bit grey), .pfm (float32), .npy (float32 or
 * float64).  The file appears whole or not at all; one that was there stays until the new one is complete.
 * LUXEL_ERROR_ARGUMENT: unknown ending.  LUXEL_ERROR_FILE: it could not be written.
 */
LUXEL_API luxel_status luxel_field_write(const luxel_field *field, const char *path, luxel_diagnostics *diagnostics);

/* Whether luxel_field_write() knows the ending of this name; if not, says so in the diagnostics. */
LUXEL_API luxel_status luxel_check_output_name(const char *path, luxel_diagnostics *diagnostics);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/*
 * Fields: the computed picture, a grid of numbers in their unit, with its statistics and grey levels.
 *
 * Row 0 is the top of the picture (largest y), column 0 the smallest x; values lie row by row.  A pixel off
 * every surface holds 0 and is off the mask.  A field keeps the text of its scene, but nothing of the scene alive.
 */
#ifndef LUXEL_FIELD_H
#define LUXEL_FIELD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <luxel/diagnostics.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A computed picture; made by luxel_render() or luxel_field_read(), the caller's, freed with luxel_field_free(). */
typedef struct luxel_field luxel_field;

/* One extreme value and where it is. */
typedef struct luxel_extremum {
    bool exists;     /* false where no pixel qualifies; then the rest is 0 */
    double value;    /* in the field's unit */
    unsigned column; /* of its pixel, from 0 at the left */
    unsigned row;    /* of its pixel, from 0 at the top */
    double x_mm;     /* of the pixel's sample on the screen */
    double y_mm;     /* of the pixel's sample on the screen */
} luxel_extremum;

/* What is read off a field at a glance. */
typedef struct luxel_statistics {
    luxel_extremum maximum; /* the largest value on a surface; ties: first in row order */
    luxel_extremum minimum; /* the smallest value of at least 1.2e-38; ties: first in row order */
    bool has_surface;       /* whether any pixel shows a surface; the next two are 0 otherwise */
    double mean;            /* plain mean over the pixels on a surface */
    double lit;             /* share of them from 1.2e-38 up */
    size_t surface_pixels;  /* how many pixels show a surface */
    /* The smallest value of at least 1.2e-38 where light arrives: where some source, or a part of it, shines on the
     * element (N.L > 0, shadows included).  Less is only the tail of a highlight behind the terminator, or ambient
     * light.  Only where the settings of luxel_render() ask for it, as it costs more than a picture of few point
     * sources; not of a quick look, nor where a light_error takes points together. */
    luxel_extremum minimum_reached;
    bool has_reflected;     /* whether surfaces reflect light to each other; then all values have it */
    double reflected_error; /* bounds the error of what it adds to any pixel, as a share of the maximum */
    bool reflected_reached; /* whether that is no more than the settings ask for; true without such light */
    /* Where light or sights may go over more mirrors than the scene counts: bounds the error of any pixel, with what
     * those give, as a share of the maximum; HUGE_VAL where no bound is known.  0: they do not.  Not of fields that
     * were read, nor of views of them. */
    double mirrored_error;
    void *reserved[3]; /* for later versions: NULL */
} luxel_statistics;

/* Frees a field; NULL is harmless. */
LUXEL_API void luxel_field_free(luxel_field *field);

/* The number of columns, the horizontal resolution. */
LUXEL_API unsigned luxel_field_columns(const luxel_field *field);
/* The number of rows, the vertical resolution. */
LUXEL_API unsigned luxel_field_rows(const luxel_field *field);
/* The number of channels: 3 of a picture of a scene with channels: rgb, else 1. */
LUXEL_API unsigned luxel_field_channels(const luxel_field *field);
/* What the values are. */
LUXEL_API luxel_quantity luxel_field_quantity(const luxel_field *field);
/* What type the values have. */
LUXEL_API luxel_precision luxel_field_precision(const luxel_field *field);
/*
 * What the values are called: "brightness" or "irradiance" and, in photometric units, "luminance" or "illuminance";
 * "values" of a field that was read from a file that does not tell.
 */
LUXEL_API const char *luxel_field_quantity_word(const luxel_field *field);
/* The unit in UTF-8, such as "W/sr", "cd/m²" or "relative", which lives as long as the field; "" where not known. */
LUXEL_API const char *luxel_field_unit(const luxel_field *field);
/* The instruction set whose kernels made it, such as "x86-64-v3"; "" for one that was read. */
LUXEL_API const char *luxel_field_instruction_set(const luxel_field *field);
/* The scene it shows, as YAML text that lives as long as the field; NULL where it is not known. */
LUXEL_API const char *luxel_field_scene(const luxel_field *field);
/* The places of the columns' samples on the screen, from the left, in mm; NULL where they are not known. */
LUXEL_API const double *luxel_field_x_mm(const luxel_field *field);
/* The places of the rows' samples on the screen, from the top, in mm; NULL where they are not known. */
LUXEL_API const double *luxel_field_y_mm(const luxel_field *field);

/* The values, rows x columns, which live as long as the field; NULL for a field of double precision. */
LUXEL_API const float *luxel_field_single(const luxel_field *field);
/* The values, rows x columns, which live as long as the field; NULL for a field of single precision. */
LUXEL_API const double *luxel_field_double(const luxel_field *field);
/* The channels R, G, B (linear sRGB), rows x columns x 3, of which the values are the luminance; they live as long as
 * the field.  NULL for a field of double precision, or with one channel. */
LUXEL_API const float *luxel_field_rgb_single(const luxel_field *field);
/* The channels, likewise; NULL for a field of single precision, or with one channel. */
LUXEL_API const double *luxel_field_rgb_double(const luxel_field *field);
/* rows x columns bytes: 1 on a surface, 0 off. */
LUXEL_API const uint8_t *luxel_field_mask(const luxel_field *field);
/* One value whatever the precision; 0 outside the grid. */
LUXEL_API double luxel_field_value(const luxel_field *field, unsigned column, unsigned row);

/* The field's statistics, which live as long as the field. */
LUXEL_API const luxel_statistics *luxel_field_statistics(const luxel_field *field);

/* Fills rows x columns bytes with the grey levels 0..255 by the rule of the scene's `picture`. */
LUXEL_API void luxel_field_grey(const luxel_field *field, uint8_t *grey);
/*
 * Fills rows x columns x 3 bytes with the levels 0..255 of a picture in colour, which a display with sRGB's curve
 * shows: as the grey levels, but by the greatest channel where those go by the maximum, and with that curve.  Returns
 * how many of these numbers were clipped, below 0 or beyond the range.  A field with one channel has its grey levels
 * three times.
 */
LUXEL_API size_t luxel_field_srgb(const luxel_field *field, uint8_t *levels);
/* Fills rows x columns numbers with the grey levels 0..65535 by the same rule, 65535 taking the place of 255. */
LUXEL_API void luxel_field_grey16(const luxel_field *field, uint16_t *grey);

/*
 * Writes the field to a file, by the extension of its name: .png (grey levels), .pfm (float32), .npy (float32 or
 * float64), .csv (a line for each pixel on a surface: x_mm, y_mm, value), .exr (float32).  PNG and EXR carry the
 * scene, the quantity, the precision and the unit, so that luxel_scene_read_file() can read the scene from them.
 * The file appears whole or not at all; one that was there stays until the new one is complete.
 * LUXEL_ERROR_ARGUMENT: unknown extension, or .csv for a field without places.  LUXEL_ERROR_FILE: it could not be
 * written.
 */
LUXEL_API luxel_status luxel_field_write(const luxel_field *field, const char *path, luxel_diagnostics *diagnostics);

/* How a file is written, where its format leaves a choice; {0} is as luxel_field_write() does. */
typedef struct luxel_field_output {
    unsigned bits;     /* of a grey level in .png: 8 or 16; 0: 8.  Other formats hold the values themselves */
    void *reserved[4]; /* for later versions: NULL */
} luxel_field_output;

/*
 * Writes the field as luxel_field_write() does; `how` NULL: just so.
 * LUXEL_ERROR_ARGUMENT: other numbers of bits, too.
 */
LUXEL_API luxel_status luxel_field_write_as(const luxel_field *field, const char *path, const luxel_field_output *how,
                                            luxel_diagnostics *diagnostics);

/*
 * Makes the file that luxel_field_write_as() would write, in memory: *bytes, *length of them, the caller's, freed with
 * luxel_bytes_free().  `name` tells the format by its extension, and is named in messages: "field.png".
 * LUXEL_ERROR_ARGUMENT, LUXEL_ERROR_MEMORY; *bytes and *length then stay as they were.
 */
LUXEL_API luxel_status luxel_field_write_memory(const luxel_field *field, const char *name,
                                                const luxel_field_output *how, luxel_diagnostics *diagnostics,
                                                unsigned char **bytes, size_t *length);

/* Whether luxel_field_write() knows the extension of this name; if not, says so in the diagnostics. */
LUXEL_API luxel_status luxel_check_output_name(const char *path, luxel_diagnostics *diagnostics);

/*
 * Reads a field from an .npy, .pfm, .csv or .exr file, known by its content or else by its extension; the statistics
 * are calculated.  Its size is at most 65536 x 65536.
 *
 * .npy: (rows, columns) of float32 or float64, either order of bytes and axes.  .pfm: grey, either order of bytes.
 * .exr: scan lines of a single channel of any name, float32, float16 or whole numbers (which become float32),
 * compressed without loss.  .csv: the pixels in any order; the field is the smallest grid that holds them, of single
 * precision if each value is written as .csv files of single precision are.
 *
 * What the file does not tell: the mask is then 1 where the value is not 0, as off the surfaces it is 0; the unit is
 * ""; the quantity is brightness; the places are NULL and those of the extrema NaN.  An .exr file with its scene
 * tells them all but the mask.
 * LUXEL_ERROR_FILE: it cannot be read, is damaged or of another kind.  LUXEL_ERROR_MEMORY: it would not fit.
 * The field is the caller's.
 */
LUXEL_API luxel_status luxel_field_read(const char *path, luxel_diagnostics *diagnostics, luxel_field **field);

/*
 * Reads a field from the bytes of such a file; `name` stands for it in messages, and its extension tells the format
 * where the content does not.  The bytes may go afterwards.  Errors as luxel_field_read().
 */
LUXEL_API luxel_status luxel_field_read_memory(const void *bytes, size_t length, const char *name,
                                               luxel_diagnostics *diagnostics, luxel_field **field);

/* A picture of somebody else's making: its size and values, and what else is known of it. */
typedef struct luxel_field_content {
    unsigned columns;          /* of pixels, 1 to 65536 */
    unsigned rows;             /* of pixels, 1 to 65536 */
    luxel_precision precision; /* float values, or double ones */
    luxel_quantity quantity;   /* where it is known what the values are */
    bool quantity_known;       /* else they are called "values" */
    const void *values;        /* rows x columns of them, from the top left */
    const uint8_t *mask;       /* as many bytes, not 0 on a surface; NULL: where the value is not 0 */
    const double *x_mm;        /* the places of the columns, from the left, going up; NULL: not known, nor is y_mm */
    const double *y_mm;        /* the places of the rows, from the top, going down */
    const char *unit;          /* NULL: not known */
    void *reserved[4];         /* for later versions: NULL */
} luxel_field_content;

/*
 * Makes a field of values in memory, which are copied; off the mask they become 0.  It is as one that was read from a
 * file.  LUXEL_ERROR_ARGUMENT: a size or enumeration out of range, places that are not finite or do not go on.
 * LUXEL_ERROR_MEMORY.  The field is the caller's.
 */
LUXEL_API luxel_status luxel_field_of_values(const luxel_field_content *content, luxel_diagnostics *diagnostics,
                                             luxel_field **field);

/* Views of a picture in colour, where one number a pixel can be shown. */
typedef enum luxel_color_view {
    LUXEL_VIEW_LUMINANCE, /* the values themselves */
    LUXEL_VIEW_RED,       /* channels, in linear sRGB, which may be below 0 */
    LUXEL_VIEW_GREEN,
    LUXEL_VIEW_BLUE,
    LUXEL_VIEW_CCT /* the colour temperature in K, as luxel_find_chromaticity() has it */
} luxel_color_view;

/* The word of a view, for options and messages: "luminance", "red", "green", "blue", "cct"; NULL: no such view. */
LUXEL_API const char *luxel_color_view_word(luxel_color_view view);

/*
 * Makes the field of a view of a picture in colour: grey, without its scene, with statistics of its own, which know no
 * reflected light.
 * Where a pixel has no colour temperature it is off the mask of that view.
 * LUXEL_ERROR_ARGUMENT: the field is grey and the view is not of the luminance, or there is no such.
 * LUXEL_ERROR_MEMORY.  The field is the caller's.
 */
LUXEL_API luxel_status luxel_field_of_view(const luxel_field *field, luxel_color_view view,
                                           luxel_diagnostics *diagnostics, luxel_field **shown);

/* The extensions that luxel_field_write() knows: the i-th with its dot, such as ".png"; NULL beyond the last. */
LUXEL_API const char *luxel_field_output_ending(size_t i);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/* The field: the grid of numbers behind luxel_field, with what is needed to read it without the scene. */
#ifndef LX_FIELD_FIELD_H
#define LX_FIELD_FIELD_H

#include <luxel/field.h>

#include "../scene/scene.h"
#include "../scene/scene_text.h"

/* What is gathered of one row. */
struct lx_row_statistics {
    double maximum, minimum; /* minimum: of the values from LX_LEAST_LIT up */
    size_t surface_pixels, lit_pixels;
    double sum;
    double reached; /* the least of those where light arrives, or HUGE_VAL, and: */
    unsigned reached_column;
};

/* The smallest value that counts as light: below it float32 has no normal numbers. */
#define LX_LEAST_LIT 1.2e-38

struct luxel_field {
    unsigned columns, rows;
    luxel_quantity quantity;
    const char *quantity_word; /* a constant */
    luxel_precision precision;
    double tolerance, light_error, reflected_error; /* of the settings that it was made with; 0: the defaults */
    char *unit;
    const char *instruction_set; /* a constant of the program */
    struct lx_scene_text *scene; /* that it was made of; NULL: not known */
    void *values;                /* float or double */
    void *rgb;                   /* likewise, three a pixel: their channels; NULL: it is grey */
    uint8_t *mask;
    bool mask_is_guess;  /* of a file that tells none: the pixels that are not 0 */
    double *x_mm, *y_mm; /* the places of the columns and of the rows; NULL: not known */
    struct lx_picture picture;
    struct luxel_statistics statistics;
};

/* Bytes that a field of this size needs in memory; 0 where the number itself is too large. */
size_t lx_field_bytes(unsigned columns, unsigned rows, luxel_precision precision);

/* How many of `count` columns or rows a field with a stride of at least 1 has. */
unsigned lx_strided_count(unsigned count, unsigned stride);

/* The places of those columns or rows of a screen; NULL when memory is short. */
double *lx_new_column_places(const struct lx_screen *screen, unsigned stride);
double *lx_new_row_places(const struct lx_screen *screen, unsigned stride);

/* A field of the scene's picture without its values, whose unit is not set yet either; NULL when memory is short. */
struct luxel_field *lx_field_new_frame(const struct lx_scene_parameters *scene, unsigned stride,
                                       luxel_precision precision);

/*
 * Rows of a field, one below the other, which are held at a time: all of them, or of a frame those that come next.
 * Values and mask begin with the row `first`.
 */
struct lx_strip {
    unsigned first, rows;
    void *values; /* float or double, as the field's */
    uint8_t *mask;
    void *rgb; /* three a pixel, likewise; NULL: it is grey */
};

/* Makes room for the rows of a strip; 0, or -1 when memory is short.  free() both in any case. */
int lx_strip_allocate(const struct luxel_field *field, struct lx_strip *strip);

/* All rows of a field that has its values. */
static inline struct lx_strip lx_whole_strip(const struct luxel_field *field)
{
    return (struct lx_strip){.rows = field->rows, .values = field->values, .mask = field->mask, .rgb = field->rgb};
}

/* The i-th value of a strip, row by row, whatever the precision. */
static inline double lx_strip_value(const struct luxel_field *field, const struct lx_strip *strip, size_t i)
{
    return field->precision == LUXEL_DOUBLE ? ((const double *)strip->values)[i]
                                            : (double)((const float *)strip->values)[i];
}

/* The i-th value of a field that has them, likewise. */
static inline double lx_field_value(const struct luxel_field *field, size_t i)
{
    return field->precision == LUXEL_DOUBLE ? ((const double *)field->values)[i]
                                            : (double)((const float *)field->values)[i];
}

/* Gathers a finished row of the field, which the strip holds. */
struct lx_row_statistics lx_gather_row(const struct luxel_field *field, const struct lx_strip *strip, unsigned row);

/* What was gathered of a field's rows so far; starts as {0}. */
struct lx_tally {
    luxel_statistics so_far; /* without mean and lit */
    size_t lit_pixels;
    double sum;
};

/* Adds what was gathered of a strip's rows, one for each; the strips come in their order. */
void lx_tally_add(struct lx_tally *tally, const struct luxel_field *field, const struct lx_strip *strip,
                  const struct lx_row_statistics *rows);
/* The statistics, once all rows were added. */
luxel_statistics lx_tally_finish(const struct lx_tally *tally);

/* All of it, of a field that is complete; 0, or -1 when memory ran out. */
int lx_gather_statistics(struct luxel_field *field);

/* How values become grey levels. */
struct lx_greys {
    const struct lx_picture *picture;
    double black, white; /* the values that become so, for the linear ranges */
};

/* Whether levels depend on the values of the whole picture, so that none is known before the last value. */
bool lx_greys_wait(const struct luxel_field *field);

/* What black may depend on: the least value on a surface in a strip.  Infinite without one, or if it does not. */
double lx_greys_least(const struct luxel_field *field, const struct lx_strip *strip);

/* By the field's statistics and the least of all its strips. */
struct lx_greys lx_greys_of(const struct luxel_field *field, double least);

/* Whole numbers of 8 or 16 bits for `count` values of a strip from the i-th on. */
void lx_grey_levels(const struct lx_greys *greys, const struct luxel_field *field, const struct lx_strip *strip,
                    size_t i, size_t count, unsigned bits, void *levels);

/* How the channels of a whole picture in colour become levels: as its grey levels, but by the greatest and the least
 * channel where those go by the values. */
struct lx_greys lx_greys_of_rgb(const struct luxel_field *field);

/* Whole numbers of 8 or 16 bits for the channels of `count` pixels from the i-th on, with sRGB's curve; returns how
 * many were clipped. */
size_t lx_srgb_levels(const struct lx_greys *greys, const struct luxel_field *field, size_t i, size_t count,
                      unsigned bits, void *levels);

/* The brightness of a value from 0 to 1 before it is clipped. */
double lx_grey_shade(const struct lx_greys *greys, double value);

#endif

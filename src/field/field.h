/* SPDX-License-Identifier: MIT */
/* The field: the grid of numbers behind luxel_field, with what is needed to read it without the scene. */
#ifndef LX_FIELD_FIELD_H
#define LX_FIELD_FIELD_H

#include <luxel/field.h>

#include "../scene/scene.h"

/* What is gathered of one row, and of all rows together. */
struct lx_row_statistics {
    double maximum, minimum; /* minimum: of the values from LX_LEAST_LIT up */
    size_t surface_pixels, lit_pixels;
    double sum;
};

/* The smallest value that counts as light: below it float32 has no normal numbers. */
#define LX_LEAST_LIT 1.2e-38

struct luxel_field {
    unsigned columns, rows;
    luxel_quantity quantity;
    luxel_precision precision;
    double tolerance, light_error; /* of the settings that it was made with; 0: the defaults */
    char *unit;
    const char *instruction_set; /* a constant of the program */
    char *scene;                 /* as text; NULL: not known */
    void *values;                /* float or double */
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

/* A field of the scene's picture, neither its values nor its unit set yet; NULL when memory is short. */
struct luxel_field *lx_field_new(const struct lx_scene_parameters *scene, unsigned stride, luxel_precision precision);

/* Stores values of a row from `column` on, rounded to the field's precision. */
void lx_field_store(struct luxel_field *field, unsigned row, unsigned column, const double *values, const uint8_t *mask,
                    size_t count);

/* The i-th value, row by row, whatever the precision. */
static inline double lx_field_value(const struct luxel_field *field, size_t i)
{
    return field->precision == LUXEL_DOUBLE ? ((const double *)field->values)[i]
                                            : (double)((const float *)field->values)[i];
}

/* Gathers a finished row; then puts the rows' statistics (one for each row) together, in their order. */
struct lx_row_statistics lx_gather_row(const struct luxel_field *field, unsigned row);
void lx_finish_statistics(struct luxel_field *field, const struct lx_row_statistics *rows);
/* Both, of a field that is complete; 0, or -1 when memory ran out. */
int lx_gather_statistics(struct luxel_field *field);

#endif

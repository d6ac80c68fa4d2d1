/* SPDX-License-Identifier: MIT */
/* Making a field, reading it, and its grey levels. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../shade/camera.h"
#include "field.h"

size_t lx_field_bytes(unsigned columns, unsigned rows, luxel_precision precision)
{
    size_t pixels, bytes, value = precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float);
    if (__builtin_mul_overflow((size_t)columns, (size_t)rows, &pixels) ||
        __builtin_mul_overflow(pixels, value + 1, &bytes))
        return 0;
    return bytes;
}

unsigned lx_strided_count(unsigned count, unsigned stride)
{
    return count / stride + (count % stride != 0);
}

/* The i-th of `count` columns or rows that a stride takes: the middle one of each run, or the last of them all. */
static unsigned strided(unsigned count, unsigned stride, unsigned i)
{
    unsigned place = stride / 2 + i * stride;
    return place < count ? place : count - 1;
}

double *lx_new_column_places(const struct lx_screen *screen, unsigned stride)
{
    unsigned count = lx_strided_count(screen->resolution[0], stride);
    double *places = lx_new_array(count, sizeof *places);
    for (unsigned i = 0; places && i < count; i++)
        places[i] = lx_column_x_mm(screen, strided(screen->resolution[0], stride, i));
    return places;
}

double *lx_new_row_places(const struct lx_screen *screen, unsigned stride)
{
    unsigned count = lx_strided_count(screen->resolution[1], stride);
    double *places = lx_new_array(count, sizeof *places);
    for (unsigned i = 0; places && i < count; i++)
        places[i] = lx_row_y_mm(screen, strided(screen->resolution[1], stride, i));
    return places;
}

struct luxel_field *lx_field_new(const struct lx_scene_parameters *scene, unsigned stride, luxel_precision precision)
{
    unsigned columns = lx_strided_count(scene->screen.resolution[0], stride);
    unsigned rows = lx_strided_count(scene->screen.resolution[1], stride);
    size_t pixels = (size_t)columns * rows;
    struct luxel_field *field = lx_new_array(1, sizeof *field);
    if (!field)
        return NULL;
    *field = (struct luxel_field){
        .columns = columns,
        .rows = rows,
        .precision = precision,
        .values = lx_new_aligned(pixels, precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float)),
        .mask = lx_new_aligned(pixels, 1),
        .x_mm = lx_new_column_places(&scene->screen, stride),
        .y_mm = lx_new_row_places(&scene->screen, stride),
        .picture = scene->picture,
    };
    if (field->values && field->mask && field->x_mm && field->y_mm)
        return field;
    luxel_field_free(field);
    return NULL;
}

void luxel_field_free(luxel_field *field)
{
    if (!field)
        return;
    free(field->values);
    free(field->mask);
    free(field->x_mm);
    free(field->y_mm);
    free(field->unit);
    free(field->scene);
    free(field);
}

void lx_field_store(struct luxel_field *field, unsigned row, unsigned column, const double *values, const uint8_t *mask,
                    size_t count)
{
    size_t first = (size_t)row * field->columns + column;
    memcpy(&field->mask[first], mask, count);
    if (field->precision == LUXEL_DOUBLE)
        memcpy((double *)field->values + first, values, count * sizeof *values);
    else
        for (size_t i = 0; i < count; i++)
            ((float *)field->values)[first + i] = (float)values[i];
}

unsigned luxel_field_columns(const luxel_field *field)
{
    return field->columns;
}

unsigned luxel_field_rows(const luxel_field *field)
{
    return field->rows;
}

unsigned luxel_field_channels(const luxel_field *field)
{
    (void)field;
    return 1;
}

luxel_quantity luxel_field_quantity(const luxel_field *field)
{
    return field->quantity;
}

luxel_precision luxel_field_precision(const luxel_field *field)
{
    return field->precision;
}

const char *luxel_field_unit(const luxel_field *field)
{
    return field->unit;
}

const char *luxel_field_instruction_set(const luxel_field *field)
{
    return field->instruction_set;
}

const char *luxel_field_scene(const luxel_field *field)
{
    return field->scene;
}

const double *luxel_field_x_mm(const luxel_field *field)
{
    return field->x_mm;
}

const double *luxel_field_y_mm(const luxel_field *field)
{
    return field->y_mm;
}

const float *luxel_field_single(const luxel_field *field)
{
    return field->precision == LUXEL_SINGLE ? field->values : NULL;
}

const double *luxel_field_double(const luxel_field *field)
{
    return field->precision == LUXEL_DOUBLE ? field->values : NULL;
}

const uint8_t *luxel_field_mask(const luxel_field *field)
{
    return field->mask;
}

double luxel_field_value(const luxel_field *field, unsigned column, unsigned row)
{
    return column < field->columns && row < field->rows ? lx_field_value(field, (size_t)row * field->columns + column)
                                                        : 0;
}

const luxel_statistics *luxel_field_statistics(const luxel_field *field)
{
    return &field->statistics;
}

/* The values that become black and white, for the linear ranges. */
static void linear_range(const struct luxel_field *field, double *black, double *white)
{
    const struct lx_choice_or_pair *range = &field->picture.range;
    *black = 0;
    *white = field->statistics.maximum.value;
    if (range->choice == -1) {
        *black = range->low;
        *white = range->high;
    } else if (range->choice == LX_RANGE_MINMAX) {
        *black = HUGE_VAL; /* the least on a surface, which may be 0 */
        for (size_t i = 0; i < (size_t)field->columns * field->rows; i++)
            if (field->mask[i] && lx_field_value(field, i) < *black)
                *black = lx_field_value(field, i);
    }
}

/* The brightness of a value from 0 to 1 before it is clipped. */
static double shade_of(const struct luxel_field *field, double value, double black, double white)
{
    if (field->picture.range.choice == LX_RANGE_LOG)
        return value > 0 ? 1 + log10(value / white) / 4 : 0;
    /* A range without width: what is dark is black, anything else white. */
    if (!(white > black))
        return value > 0 ? 1 : 0;
    return (value - black) / (white - black);
}

/* The level of a pixel, a whole number from 0 to `most`. */
static double level_of(const struct luxel_field *field, size_t i, double black, double white, double most)
{
    double level = field->mask[i] ? most * shade_of(field, lx_field_value(field, i), black, white) : 0;
    level = level > 0 ? level < most ? level : most : 0;
    return field->picture.rounding == LX_NEAREST ? round(level) : trunc(level);
}

void luxel_field_grey(const luxel_field *field, uint8_t *grey)
{
    double black, white;
    linear_range(field, &black, &white);
    for (size_t i = 0; i < (size_t)field->columns * field->rows; i++)
        grey[i] = (uint8_t)level_of(field, i, black, white, 255);
}

void luxel_field_grey16(const luxel_field *field, uint16_t *grey)
{
    double black, white;
    linear_range(field, &black, &white);
    for (size_t i = 0; i < (size_t)field->columns * field->rows; i++)
        grey[i] = (uint16_t)level_of(field, i, black, white, 65535);
}

/* SPDX-License-Identifier: MIT */
/* Making a field and reading it. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../world/camera.h"
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

struct luxel_field *lx_field_new_frame(const struct lx_scene_parameters *scene, unsigned stride,
                                       luxel_precision precision)
{
    struct luxel_field *field = lx_new_array(1, sizeof *field);
    if (!field)
        return NULL;
    *field = (struct luxel_field){
        .columns = lx_strided_count(scene->screen.resolution[0], stride),
        .rows = lx_strided_count(scene->screen.resolution[1], stride),
        .precision = precision,
        .x_mm = lx_new_column_places(&scene->screen, stride),
        .y_mm = lx_new_row_places(&scene->screen, stride),
        .picture = scene->picture,
    };
    if (field->x_mm && field->y_mm)
        return field;
    luxel_field_free(field);
    return NULL;
}

int lx_strip_allocate(const struct luxel_field *field, struct lx_strip *strip)
{
    size_t pixels = (size_t)field->columns * strip->rows;
    strip->values = lx_new_aligned(pixels, field->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float));
    strip->mask = lx_new_aligned(pixels, 1);
    return strip->values && strip->mask ? 0 : -1;
}

void luxel_field_free(luxel_field *field)
{
    if (!field)
        return;
    free(field->values);
    free(field->rgb);
    free(field->mask);
    free(field->x_mm);
    free(field->y_mm);
    free(field->unit);
    lx_scene_text_free(field->scene);
    free(field);
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
    return field->rgb ? 3 : 1;
}

luxel_quantity luxel_field_quantity(const luxel_field *field)
{
    return field->quantity;
}

luxel_precision luxel_field_precision(const luxel_field *field)
{
    return field->precision;
}

const char *luxel_field_quantity_word(const luxel_field *field)
{
    return field->quantity_word;
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
    const char *text;
    return lx_scene_text_get(field->scene, &text) == LUXEL_OK ? text : NULL;
}

const double *luxel_field_x_mm(const luxel_field *field)
{
    return field->x_mm;
}

const double *luxel_field_y_mm(const luxel_field *field)
{
    return field->y_mm;
}

const float *luxel_field_rgb_single(const luxel_field *field)
{
    return field->precision == LUXEL_SINGLE ? field->rgb : NULL;
}

const double *luxel_field_rgb_double(const luxel_field *field)
{
    return field->precision == LUXEL_DOUBLE ? field->rgb : NULL;
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

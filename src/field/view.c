/* SPDX-License-Identifier: MIT */
/* Views of a picture in colour: fields of one channel, or of the colour temperature. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/colour.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "field.h"

static const double LEAST_COLORED = 0x1p-102; /* float32 has 24 bits from 2^-126 on */

static const char *const words[] = {"luminance", "red", "green", "blue", "cct"};
/* What the values are called; NULL: as those of the field. */
static const char *const quantities[] = {NULL, LX_N("red channel"), LX_N("green channel"), LX_N("blue channel"),
                                         LX_N("colour temperature")};

const char *luxel_color_view_word(luxel_color_view view)
{
    return (size_t)view < LX_COUNT(words) ? words[view] : NULL;
}

/* What a pixel shows in a view; false: there is no such. */
static bool see(const struct luxel_field *field, size_t i, luxel_color_view view, const struct lx_black_bodies *bodies,
                double *value)
{
    double rgb[3] = {0, 0, 0};
    for (size_t c = 0; field->rgb && c < 3; c++)
        rgb[c] = field->precision == LUXEL_DOUBLE ? ((const double *)field->rgb)[3 * i + c]
                                                  : (double)((const float *)field->rgb)[3 * i + c];
    *value = 0;
    if (!field->mask[i])
        return false;
    if (view != LUXEL_VIEW_CCT) {
        *value = view == LUXEL_VIEW_LUMINANCE ? lx_field_value(field, i) : rgb[view - LUXEL_VIEW_RED];
        return true;
    }
    /* single precision below keeps no ratios of channels */
    if (fmax(fmax(fabs(rgb[0]), fabs(rgb[1])), fabs(rgb[2])) < LEAST_COLORED)
        return false;
    *value = lx_black_body_near(bodies, rgb);
    return *value > 0;
}

/* A copy of the places of columns or rows; NULL also where there are none. */
static double *copy_places(const double *places, size_t count)
{
    double *copy = places ? lx_new_array(count, sizeof *copy) : NULL;
    if (copy)
        memcpy(copy, places, count * sizeof *copy);
    return copy;
}

/* A field like another, without its values, its scene and its channels. */
static struct luxel_field *new_like(const struct luxel_field *field, luxel_color_view view)
{
    const char *unit = view == LUXEL_VIEW_CCT ? "K" : field->unit;
    struct luxel_field *made = lx_new_array(1, sizeof *made);
    struct lx_strip all = {.rows = field->rows};
    if (!made)
        return NULL;
    *made = (struct luxel_field){.columns = field->columns,
                                 .rows = field->rows,
                                 .quantity = field->quantity,
                                 .quantity_word = quantities[view] ? quantities[view] : field->quantity_word,
                                 .precision = field->precision,
                                 .tolerance = field->tolerance,
                                 .light_error = field->light_error,
                                 .reflected_error = field->reflected_error,
                                 .unit = lx_copy_text(unit, strlen(unit)),
                                 .instruction_set = field->instruction_set,
                                 .x_mm = copy_places(field->x_mm, field->columns),
                                 .y_mm = copy_places(field->y_mm, field->rows),
                                 .picture = field->picture};
    const int failed = lx_strip_allocate(made, &all);
    made->values = all.values;
    made->mask = all.mask;
    if (!failed && made->unit && !made->x_mm == !field->x_mm && !made->y_mm == !field->y_mm)
        return made;
    luxel_field_free(made);
    return NULL;
}

luxel_status luxel_field_of_view(const luxel_field *field, luxel_color_view view, luxel_diagnostics *diagnostics,
                                 luxel_field **shown)
{
    if (!field || !shown || !luxel_color_view_word(view)) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_MISSING_ARGUMENT, LX_ARGS(field ? "view" : "field"));
        return LUXEL_ERROR_ARGUMENT;
    }
    if (view != LUXEL_VIEW_LUMINANCE && !field->rgb) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_CHANNELS, LX_ARGS(luxel_color_view_word(view)));
        lx_hint(diagnostics, LX_MSG_HINT_CHANNELS_RGB, NULL);
        return LUXEL_ERROR_ARGUMENT;
    }
    struct luxel_field *made = new_like(field, view);
    struct lx_black_bodies *bodies = view == LUXEL_VIEW_CCT ? lx_black_bodies_new() : NULL;
    if (!made || (view == LUXEL_VIEW_CCT && !bodies)) {
        luxel_field_free(made);
        free(bodies);
        return lx_out_of_memory(diagnostics);
    }
    for (size_t i = 0; i < (size_t)field->columns * field->rows; i++) {
        double value;
        made->mask[i] = see(field, i, view, bodies, &value);
        if (made->precision == LUXEL_DOUBLE)
            ((double *)made->values)[i] = value;
        else
            ((float *)made->values)[i] = (float)value;
    }
    free(bodies);
    if (lx_gather_statistics(made) < 0) {
        luxel_field_free(made);
        return lx_out_of_memory(diagnostics);
    }
    made->statistics.reflected_reached = true;
    *shown = made;
    return LUXEL_OK;
}

/* SPDX-License-Identifier: MIT */
/* Grey levels by the rule of the scene's `picture`. */
#include <math.h>

#include "field.h"

bool lx_greys_wait(const struct luxel_field *field)
{
    return field->picture.range.choice != -1;
}

double lx_greys_least(const struct luxel_field *field, const struct lx_strip *strip)
{
    double least = HUGE_VAL;
    for (size_t i = 0; field->picture.range.choice == LX_RANGE_MINMAX && i < (size_t)field->columns * strip->rows; i++)
        if (strip->mask[i] && lx_strip_value(field, strip, i) < least)
            least = lx_strip_value(field, strip, i);
    return least;
}

struct lx_greys lx_greys_of(const struct luxel_field *field, double least)
{
    const struct lx_choice_or_pair *range = &field->picture.range;
    struct lx_greys greys = {.picture = &field->picture, .white = field->statistics.maximum.value};
    if (range->choice == -1) {
        greys.black = range->low;
        greys.white = range->high;
    } else if (range->choice == LX_RANGE_MINMAX) {
        greys.black = least;
    }
    return greys;
}

double lx_grey_shade(const struct lx_greys *greys, double value)
{
    if (greys->picture->range.choice == LX_RANGE_LOG)
        return value > 0 ? 1 + log10(value / greys->white) / 4 : 0;
    /* A range without width: what is dark is black, anything else white. */
    if (!(greys->white > greys->black))
        return value > 0 ? 1 : 0;
    return (value - greys->black) / (greys->white - greys->black);
}

/* The level of a value on a surface, a whole number from 0 to `most`. */
static double level_of(const struct lx_greys *greys, double value, double most)
{
    double level = most * lx_grey_shade(greys, value);
    level = level > 0 ? level < most ? level : most : 0;
    return greys->picture->rounding == LX_NEAREST ? round(level) : trunc(level);
}

void lx_grey_levels(const struct lx_greys *greys, const struct luxel_field *field, const struct lx_strip *strip,
                    size_t i, size_t count, unsigned bits, void *levels)
{
    const double most = bits == 16 ? UINT16_MAX : UINT8_MAX;
    for (size_t k = 0; k < count; k++) {
        double level = strip->mask[i + k] ? level_of(greys, lx_strip_value(field, strip, i + k), most) : 0;
        if (bits == 16)
            ((uint16_t *)levels)[k] = (uint16_t)level;
        else
            ((uint8_t *)levels)[k] = (uint8_t)level;
    }
}

static void fill(const luxel_field *field, unsigned bits, void *levels)
{
    const struct lx_strip all = lx_whole_strip(field);
    const struct lx_greys greys = lx_greys_of(field, lx_greys_least(field, &all));
    lx_grey_levels(&greys, field, &all, 0, (size_t)field->columns * field->rows, bits, levels);
}

void luxel_field_grey(const luxel_field *field, uint8_t *grey)
{
    fill(field, 8, grey);
}

void luxel_field_grey16(const luxel_field *field, uint16_t *grey)
{
    fill(field, 16, grey);
}

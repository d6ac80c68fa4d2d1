/* SPDX-License-Identifier: MIT */
/* Levels of pictures in colour, as displays with sRGB's curve show them. */
#include <math.h>

#include <luxel/colour.h>

#include "field.h"

static double channel_of(const struct luxel_field *field, size_t i)
{
    return field->precision == LUXEL_DOUBLE ? ((const double *)field->rgb)[i] : (double)((const float *)field->rgb)[i];
}

struct lx_greys lx_greys_of_rgb(const struct luxel_field *field)
{
    struct lx_greys greys = lx_greys_of(field, 0);
    double least = HUGE_VAL, greatest = 0;
    for (size_t i = 0; i < (size_t)field->columns * field->rows; i++)
        for (size_t c = 0; field->mask[i] && c < 3; c++) {
            const double value = channel_of(field, 3 * i + c);
            least = fmin(least, value);
            greatest = fmax(greatest, value);
        }
    if (field->picture.range.choice == LX_RANGE_MINMAX)
        greys.black = least;
    if (field->picture.range.choice != -1)
        greys.white = greatest;
    return greys;
}

size_t lx_srgb_levels(const struct lx_greys *greys, const struct luxel_field *field, size_t i, size_t count,
                      unsigned bits, void *levels)
{
    const double most = bits == 16 ? UINT16_MAX : UINT8_MAX;
    const bool is_log = greys->picture->range.choice == LX_RANGE_LOG;
    size_t clipped = 0;
    for (size_t k = 0; k < 3 * count; k++) {
        const bool is_shown = field->mask[i + k / 3];
        double shade = is_shown ? lx_grey_shade(greys, channel_of(field, 3 * i + k)) : 0;
        clipped += !(shade >= 0 && shade <= 1) && !(is_log && shade < 0);
        shade = shade > 0 ? shade < 1 ? shade : 1 : 0;
        const double level = most * (is_log ? shade : luxel_srgb_curve(shade));
        const double whole = greys->picture->rounding == LX_NEAREST ? round(level) : trunc(level);
        if (bits == 16)
            ((uint16_t *)levels)[k] = (uint16_t)whole;
        else
            ((uint8_t *)levels)[k] = (uint8_t)whole;
    }
    return clipped;
}

size_t luxel_field_srgb(const luxel_field *field, uint8_t *levels)
{
    const size_t pixels = (size_t)field->columns * field->rows;
    if (field->rgb) {
        const struct lx_greys greys = lx_greys_of_rgb(field);
        return lx_srgb_levels(&greys, field, 0, pixels, 8, levels);
    }
    luxel_field_grey(field, levels);
    for (size_t i = pixels; i-- > 0;)
        levels[3 * i] = levels[3 * i + 1] = levels[3 * i + 2] = levels[i];
    return 0;
}

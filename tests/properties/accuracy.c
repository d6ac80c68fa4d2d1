/* SPDX-License-Identifier: MIT */
/* Pictures against exact values, pixel by pixel. */
#include <math.h>

#include "properties.h"
#include "truth.h"

/* The pixels that are looked at: few under extended sources, whose exact values take long, with highlights a thousand
 * times as long. */
enum { MOST_PIXELS = 100, FEWER_PIXELS = 20, DEAR_PIXELS = 2 };

static bool is_true(struct trial *trial, luxel_precision precision, unsigned most)
{
    const luxel_field *picture = trial_picture(trial, precision);
    if (!picture || !trial_picture(trial, LUXEL_DOUBLE))
        return true;
    const unsigned columns = luxel_field_columns(picture), count = columns * luxel_field_rows(picture);
    const unsigned step = count > most ? count / most : 1;
    const double slack = trial_slack(trial, picture);
    for (unsigned i = step / 2; i < count; i += step) {
        const unsigned column = i % columns, row = i / columns;
        if (!truth_shows(trial, column, row, luxel_field_mask(picture)[i]) ||
            !truth_allows(trial, column, row, luxel_field_value(picture, column, row), slack))
            return false;
    }
    return true;
}

static unsigned most_pixels(const struct trial *trial)
{
    return draft_has_extended(trial->draft) ? DEAR_PIXELS : MOST_PIXELS;
}

bool is_true_in_single(struct trial *trial)
{
    return is_true(trial, LUXEL_SINGLE, most_pixels(trial));
}

bool is_true_in_double(struct trial *trial)
{
    return is_true(trial, LUXEL_DOUBLE, most_pixels(trial));
}

/* A part of the first surface from so near that squares of pixels are smooth, alone or with all others in the view and
 * in the light; under extended sources mostly without their highlights, as exact values of these take long. */
bool is_true_in_panels(struct trial *trial)
{
    enum { COLUMNS = 150, ROWS = 140, PANEL = 64, LEAST_PANELS = 8 };
    struct draft near = *trial->draft;
    struct draft_surface_numbers *surface = &near.surfaces[0].numbers;
    const double farther = near.words.columns;                                             /* by chance from 1 to 9 */
    const bool has_extended = draft_has_extended(&near), is_glossy = near.words.rows == 2; /* by chance */
    const bool is_alone = near.words.columns % 2 == 0;
    if (is_alone)
        near.surface_count = 1;
    for (size_t s = 0; has_extended && !is_glossy && s < near.surface_count; s++)
        near.surfaces[s].numbers.specular = 0;
    near.words.columns = COLUMNS;
    near.words.rows = ROWS;
    near.numbers.pitch = surface->size[0] / (PANEL * LEAST_PANELS * farther);
    if (near.words.perspective && surface->center[2] < near.numbers.observer_z) /* as large on the screen */
        near.numbers.pitch *= near.numbers.observer_z / (near.numbers.observer_z - surface->center[2]);
    surface->center[0] = fmod(surface->center[0], surface->size[0] / 2);
    surface->center[1] = fmod(surface->center[1], surface->size[0] / 2);
    const unsigned pixels = !has_extended ? MOST_PIXELS : is_glossy ? DEAR_PIXELS : FEWER_PIXELS;
    struct trial close;
    trial_open(&near, &close);
    const bool holds = !close.scene || is_true(&close, LUXEL_SINGLE, pixels);
    if (!holds)
        trial_fails(trial, "from near: %s", close.complaint);
    trial->pixels += close.pixels, trial->vague += close.vague, trial->excused += close.excused;
    trial_close(&close);
    return holds;
}

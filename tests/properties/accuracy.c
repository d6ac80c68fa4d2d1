/* SPDX-License-Identifier: MIT */
/* Pictures against exact values, pixel by pixel. */
#include "properties.h"
#include "truth.h"

/* Exact values of extended sources take a thousand times as long as others, so only so many pixels are looked at. */
enum { DEAR_PIXELS = 2 };

static bool is_true(struct trial *trial, luxel_precision precision)
{
    const luxel_field *picture = trial_picture(trial, precision);
    if (!picture || !trial_picture(trial, LUXEL_DOUBLE))
        return true;
    const unsigned columns = luxel_field_columns(picture), count = columns * luxel_field_rows(picture);
    const unsigned step = draft_has_extended(trial->draft) && count > DEAR_PIXELS ? count / DEAR_PIXELS : 1;
    const double slack = trial_slack(trial, picture);
    for (unsigned i = step / 2; i < count; i += step) {
        const unsigned column = i % columns, row = i / columns;
        if (!truth_shows(trial, column, row, luxel_field_mask(picture)[i]) ||
            !truth_allows(trial, column, row, luxel_field_value(picture, column, row), slack))
            return false;
    }
    return true;
}

bool is_true_in_single(struct trial *trial)
{
    return is_true(trial, LUXEL_SINGLE);
}

bool is_true_in_double(struct trial *trial)
{
    return is_true(trial, LUXEL_DOUBLE);
}

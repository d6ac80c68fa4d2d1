/* SPDX-License-Identifier: MIT */
/* Many points taken together, by luxel_settings.light_error, against each of them summed. */
#include "properties.h"
#include "truth.h"

#include <math.h>

/* The draft with its extended sources cut into some hundred points, or thousands; false where it has none. */
static bool cut_up(const struct draft *draft, struct draft *points)
{
    enum { PLANAR_PARTS = 24, VOLUME_PARTS = 8 };
    bool has_any = false;
    *points = *draft;
    for (size_t i = 0; i < points->light_count; i++) {
        struct draft_light_words *words = &points->lights[i].words;
        const bool is_planar = words->type == DRAFT_PLANAR, is_volume = words->type == DRAFT_VOLUME;
        if (is_planar || is_volume)
            words->parts = is_planar ? PLANAR_PARTS : VOLUME_PARTS;
        has_any = has_any || is_planar || is_volume;
    }
    return has_any;
}

/* `cut`: a trial of the points, whose exact values excuse a pixel that jumps. */
static bool is_within(struct trial *trial, struct trial *cut, luxel_precision precision, double error)
{
    const luxel_field *summed = trial_picture(cut, LUXEL_DOUBLE);
    const double share = precision == LUXEL_DOUBLE ? 2e-11 : 2e-6, maximum = trial_maximum(summed);
    luxel_settings settings = trial_settings(precision);
    settings.light_error = error;
    luxel_field *together = trial_render(cut->scene, &settings);
    bool holds = true;
    for (unsigned p = 0; holds && together && p < luxel_field_columns(summed) * luxel_field_rows(summed); p++) {
        const unsigned column = p % luxel_field_columns(summed), row = p / luxel_field_columns(summed);
        const double sum = luxel_field_value(summed, column, row), taken = luxel_field_value(together, column, row);
        const double slack = error * fmax(sum, maximum / 1000) + share * maximum + 1.2e-38;
        holds = fabs(taken - sum) <= slack || truth_allows(cut, column, row, taken, slack) ||
                trial_fails(trial, "column %u, row %u: %.17g, with light_error %g %.17g, the maximum being %.17g",
                            column, row, sum, error, taken, maximum);
    }
    luxel_field_free(together);
    return holds;
}

bool keeps_light_error(struct trial *trial)
{
    static const double errors[] = {0.3, 0.1, 0.01, 0.001};
    struct draft points;
    struct trial cut;
    if (!cut_up(trial->draft, &points))
        return true;
    trial_open(&points, &cut);
    bool holds = true;
    for (size_t i = 0; holds && i < sizeof errors / sizeof *errors; i++)
        holds = !cut.scene || !trial_picture(&cut, LUXEL_DOUBLE) ||
                (is_within(trial, &cut, LUXEL_DOUBLE, errors[i]) && is_within(trial, &cut, LUXEL_SINGLE, errors[i]));
    trial_close(&cut);
    return holds;
}

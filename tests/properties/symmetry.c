/* SPDX-License-Identifier: MIT */
/* A scene that is mirrored or turned gives the picture that is mirrored or turned; lights may stand in any order. */
#include "properties.h"
#include "truth.h"

#include <math.h>

/* The greatest slack of two pictures, both of which may be off. */
static double slack_of_two(const struct trial *trial, const luxel_field *one, const luxel_field *other)
{
    return trial_slack(trial, one) + trial_slack(trial, other);
}

/* Where a pixel goes. */
struct target {
    unsigned column, row;
};

static struct target target_of(const luxel_field *picture, struct draft_map map, unsigned column, unsigned row)
{
    const unsigned last_column = luxel_field_columns(picture) - 1, last_row = luxel_field_rows(picture) - 1;
    if (map.xx) /* y is counted down, so a row stays where y does */
        return (struct target){map.xx > 0 ? column : last_column - column, map.yy > 0 ? row : last_row - row};
    return (struct target){map.xy > 0 ? last_row - row : row, map.yx > 0 ? last_column - column : column};
}

/* Whether two pictures of the same, but for a map, agree; where they do not both must show what is true nearby. */
static bool agree(struct trial *trial, const luxel_field *picture, const luxel_field *turned, struct draft_map map)
{
    const double slack = slack_of_two(trial, picture, turned);
    for (unsigned row = 0; row < luxel_field_rows(picture); row++)
        for (unsigned column = 0; column < luxel_field_columns(picture); column++) {
            const struct target target = target_of(picture, map, column, row);
            const double here = luxel_field_value(picture, column, row);
            const double there = luxel_field_value(turned, target.column, target.row);
            if (fabs(here - there) > slack && !(truth_allows(trial, column, row, here, slack / 2) &&
                                                truth_allows(trial, column, row, there, slack / 2)))
                return false;
        }
    return true;
}

static bool is_same_after(struct trial *trial, struct draft_map map)
{
    const luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    const luxel_field *picture = trial_picture(trial, LUXEL_DOUBLE);
    if (!picture || !draft_is_symmetric(trial->draft))
        return true;
    struct draft turned = *trial->draft;
    draft_turn(&turned, map);
    luxel_field *after = trial_render_draft(&turned, &settings);
    const bool holds = after ? agree(trial, picture, after, map)
                             : trial_fails(trial, "the turned scene is illegal, or beyond the range");
    luxel_field_free(after);
    return holds;
}

bool is_mirrored_in_x(struct trial *trial)
{
    return is_same_after(trial, (struct draft_map){.xx = -1, .yy = 1});
}

bool is_mirrored_in_y(struct trial *trial)
{
    return is_same_after(trial, (struct draft_map){.xx = 1, .yy = -1});
}

bool is_turned(struct trial *trial)
{
    return is_same_after(trial, (struct draft_map){.xy = -1, .yx = 1});
}

bool ignores_order(struct trial *trial)
{
    const struct draft *draft = trial->draft;
    const luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    const luxel_field *picture = trial_picture(trial, LUXEL_DOUBLE);
    struct draft reversed = *draft;
    if (!picture || draft->light_count < 2)
        return true;
    for (size_t i = 0; i < draft->light_count; i++)
        reversed.lights[i] = draft->lights[draft->light_count - 1 - i];
    luxel_field *other = trial_render_draft(&reversed, &settings);
    const double slack = draft_has_extended(draft) ? slack_of_two(trial, picture, picture) : 0;
    bool holds = other != NULL || trial_fails(trial, "beyond the range in the other order");
    for (unsigned row = 0; holds && row < luxel_field_rows(picture); row++)
        for (unsigned column = 0; holds && column < luxel_field_columns(picture); column++) {
            const double one = luxel_field_value(picture, column, row), two = luxel_field_value(other, column, row);
            holds = fabs(one - two) <= slack + 1e-12 * one + 1e-300 ||
                    trial_fails(trial, "pixel [%u, %u]: %.17g, %.17g in the other order", column, row, one, two);
        }
    luxel_field_free(other);
    return holds;
}

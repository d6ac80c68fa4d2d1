/* SPDX-License-Identifier: MIT */
/* Pictures that must be the same to the last bit, and what instruction sets may differ by. */
#include "properties.h"
#include "truth.h"

#include <math.h>
#include <string.h>

static bool are_same(const luxel_field *a, const luxel_field *b)
{
    const size_t count = (size_t)luxel_field_columns(a) * luxel_field_rows(a);
    return memcmp(luxel_field_mask(a), luxel_field_mask(b), count) == 0 &&
           memcmp(luxel_field_single(a), luxel_field_single(b), count * sizeof(float)) == 0;
}

/* A picture that is large enough for so many threads, as a small one is left to a single one. */
bool ignores_threads(struct trial *trial)
{
    enum { COLUMNS = 220, ROWS = 270, SETTINGS = 3 };
    static const unsigned threads[SETTINGS] = {1, 2, 7};
    struct draft large = *trial->draft;
    luxel_field *pictures[SETTINGS] = {NULL};
    if (draft_has_extended(&large))
        return true;
    large.numbers.pitch *= (double)large.words.columns / COLUMNS;
    large.words.columns = COLUMNS;
    large.words.rows = ROWS;
    luxel_scene *scene = trial_scene_of(&large);
    for (int i = 0; scene && i < SETTINGS; i++) {
        luxel_settings settings = trial_settings(LUXEL_SINGLE);
        settings.threads = threads[i];
        pictures[i] = trial_render(scene, &settings);
    }
    bool holds = true;
    for (int i = 1; holds && pictures[0] && i < SETTINGS; i++)
        holds = (pictures[i] && are_same(pictures[0], pictures[i])) ||
                trial_fails(trial, "another picture by %u threads", threads[i]);
    for (int i = 0; i < SETTINGS; i++)
        luxel_field_free(pictures[i]);
    luxel_scene_free(scene);
    return holds;
}

/* A quick look at every second pixel gives what the whole picture has there. */
bool ignores_stride(struct trial *trial)
{
    const luxel_field *picture = trial_picture(trial, LUXEL_SINGLE);
    luxel_settings settings = trial_settings(LUXEL_SINGLE);
    settings.stride = 2;
    if (!picture || draft_has_extended(trial->draft))
        return true;
    luxel_field *look = trial_render(trial->scene, &settings);
    bool holds = look != NULL || trial_fails(trial, "a quick look is beyond the range");
    for (unsigned row = 0; holds && row < luxel_field_rows(look); row++)
        for (unsigned column = 0; holds && column < luxel_field_columns(look); column++) {
            const unsigned c = column * 2 + 1 < luxel_field_columns(picture) ? column * 2 + 1 : column * 2;
            const unsigned r = row * 2 + 1 < luxel_field_rows(picture) ? row * 2 + 1 : row * 2;
            const double seen = luxel_field_value(look, column, row), shown = luxel_field_value(picture, c, r);
            holds = seen == shown ||
                    trial_fails(trial, "pixel [%u, %u]: picture %.17g, quick look %.17g", c, r, shown, seen);
        }
    luxel_field_free(look);
    return holds;
}

/* Where two sets differ by more than both may be off, both must show what is true nearby. */
static bool agree(struct trial *trial, const luxel_field *best, const luxel_field *other, const char *set)
{
    const double slack = trial_slack(trial, best) + trial_slack(trial, other);
    for (unsigned row = 0; row < luxel_field_rows(best); row++)
        for (unsigned column = 0; column < luxel_field_columns(best); column++) {
            const double one = luxel_field_value(best, column, row), two = luxel_field_value(other, column, row);
            if (fabs(one - two) <= slack)
                continue;
            if (truth_allows(trial, column, row, one, slack / 2) && truth_allows(trial, column, row, two, slack / 2))
                continue;
            char details[sizeof trial->complaint];
            memcpy(details, trial->complaint, sizeof details);
            return trial_fails(trial, "%s against %s: %.200s", set, luxel_field_instruction_set(best), details);
        }
    return true;
}

bool agrees_by_sets(struct trial *trial)
{
    bool holds = true;
    for (luxel_precision precision = LUXEL_SINGLE; precision <= LUXEL_DOUBLE; precision++) {
        const luxel_field *best = trial_picture(trial, precision);
        luxel_settings settings = trial_settings(precision);
        for (size_t i = 0; holds && best && trial_picture(trial, LUXEL_DOUBLE) && luxel_instruction_set_name(i); i++) {
            settings.instruction_set = luxel_instruction_set_name(i);
            if (!luxel_instruction_set_runs(i) ||
                strcmp(settings.instruction_set, luxel_field_instruction_set(best)) == 0)
                continue;
            luxel_field *other = trial_render(trial->scene, &settings);
            holds = other ? agree(trial, best, other, settings.instruction_set)
                          : truth_is_touched(trial) ||
                                trial_fails(trial, "beyond the range by %s", settings.instruction_set);
            luxel_field_free(other);
        }
    }
    return holds;
}

bool reads_back(struct trial *trial)
{
    const luxel_settings settings = trial_settings(LUXEL_SINGLE);
    const luxel_field *picture = trial_picture(trial, LUXEL_SINGLE);
    char *text = NULL, *again = NULL;
    luxel_scene *copy = NULL;
    luxel_field *field = NULL;
    bool holds = luxel_scene_write_text(trial->scene, &text) == LUXEL_OK &&
                 luxel_scene_read_text(text, strlen(text), "written", NULL, &copy) == LUXEL_OK &&
                 luxel_scene_commit(copy, NULL) == LUXEL_OK && luxel_scene_write_text(copy, &again) == LUXEL_OK;
    if (!holds)
        trial_fails(trial, "what was written is no scene");
    else if (!(holds = strcmp(text, again) == 0))
        trial_fails(trial, "what was read is written otherwise");
    else if (picture) {
        field = trial_render(copy, &settings);
        holds = (field && are_same(picture, field)) || trial_fails(trial, "another picture after reading");
    }
    luxel_text_free(text);
    luxel_text_free(again);
    luxel_field_free(field);
    luxel_scene_free(copy);
    return holds;
}

/* SPDX-License-Identifier: MIT */
/*
 * Scenes made from bytes, which are legal in form whatever the bytes are, with numbers from the whole legal range and
 * its edges (tests/properties/draft.h).  Pictures must keep their bounds against exact values, and by all instruction
 * sets; what else is asked of any scene is asked, too.
 */
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>

#include "properties.h"

/* The properties that are quick to tell. */
static bool (*const properties[])(struct trial *) = {
    is_finite, is_true_in_single, is_true_in_double, has_shares, has_pixel_values, agrees_by_sets, ignores_stride,
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct choices choices = choices_of_bytes(data, size);
    struct draft draft;
    struct trial trial;
    draft_make(&choices, DRAFT_EXTENDED_ONE_IN, &draft);
    trial_open(&draft, &trial);
    for (size_t i = 0; trial.scene && i < sizeof properties / sizeof properties[0]; i++)
        if (!properties[i](&trial)) {
            char *text = draft_write(&draft);
            fprintf(stderr, "%s", text);
            free(text);
            fuzz_must(false, trial.complaint);
        }
    luxel_scene *scene = trial.scene ? luxel_scene_copy(trial.scene) : NULL;
    trial_close(&trial);
    if (scene)
        fuzz_use_scene(scene);
    return 0;
}

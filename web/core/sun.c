/* SPDX-License-Identifier: MIT */
/* Where the sun of a light stands. */
#include "answer.h"
#include "core.h"

/* The unit vector to the sun of a text whose only light is one; NULL: the text has errors, or the sun has set. */
PAGE_CALLS(page_sun) const char *page_sun(const char *text, size_t length)
{
    luxel_diagnostics *diagnostics = fresh_diagnostics();
    luxel_scene *scene = NULL;
    luxel_sun_patches *patches = NULL;

    if (luxel_scene_read_text(text, length, NULL, diagnostics, &scene) == LUXEL_OK &&
        luxel_scene_commit(scene, diagnostics) == LUXEL_OK)
        (void)luxel_find_sun_patches(scene, diagnostics, &patches);
    answer_begin();
    if (patches)
        answer_numbers(patches->towards, 3);
    luxel_sun_patches_free(patches);
    luxel_scene_free(scene);
    return patches ? answer_text() : NULL;
}

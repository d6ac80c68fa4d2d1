/* SPDX-License-Identifier: MIT */
/* The silhouettes of surfaces of the present scene, for the space view. */
#include "answer.h"
#include "core.h"

/* Closed lines, each as x, y, x, y, … in mm along the two unit vectors; NULL: there is none. */
PAGE_CALLS(page_silhouette)
const char *page_silhouette(unsigned surface, double right_x, double right_y, double right_z, double up_x, double up_y,
                            double up_z)
{
    const double right[3] = {right_x, right_y, right_z}, up[3] = {up_x, up_y, up_z};
    luxel_silhouette *silhouette = NULL;
    if (!core.scene || luxel_find_silhouette(core.scene, surface, right, up, &silhouette) != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_open('[');
    for (size_t i = 0; i < silhouette->count; i++)
        answer_numbers(silhouette->lines[i].places_mm[0], 2 * silhouette->lines[i].count);
    answer_close(']');
    luxel_silhouette_free(silhouette);
    return answer_text();
}

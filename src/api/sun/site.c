/* SPDX-License-Identifier: MIT */
/* The site of a scene among its lights. */
#include "site.h"

void lx_find_sun_site(const struct lx_scene_parameters *scene, struct lx_sun_site *site)
{
    bool is_found = false;
    *site = lx_sun_site_plain();
    for (size_t i = 0; i < scene->lights.count && !site->has_place; i++) {
        struct lx_sun_site found;
        if (!lx_sun_site_of(&scene->lights.items[i], &found))
            continue;
        if (!is_found || found.has_place)
            *site = found;
        is_found = true;
    }
}

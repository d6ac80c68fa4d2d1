/* SPDX-License-Identifier: MIT */
/* Which lights of a scene shine, turning them on and off in a copy, and whether an exact value takes an integral. */
#include "lit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../parameter/decode.h"

bool *lx_lights_on(const struct lx_scene_parameters *scene, const luxel_settings *settings)
{
    const struct lx_list *lights = &scene->lights;
    const bool is_group = settings && settings->lights;
    bool *on = lx_new_array(lights->count, sizeof *on);
    for (size_t i = 0; on && i < lights->count && !is_group; i++)
        on[i] = ((const struct lx_light_common *)lights->items[i].common)->enabled;
    for (size_t i = 0; on && is_group && i < settings->light_count; i++)
        if (settings->lights[i] < lights->count)
            on[settings->lights[i]] = true;
    return on;
}

/* Turns the lights that are not as they are to be, in a copy that is made for the first of them. */
static luxel_status turn(const luxel_scene *scene, const bool *on, luxel_diagnostics *diagnostics, luxel_scene **lit)
{
    const struct lx_list *lights = &lx_scene_parameters(scene)->lights;
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < lights->count && status == LUXEL_OK; i++) {
        char assignment[64];
        if (on[i] == ((const struct lx_light_common *)lights->items[i].common)->enabled)
            continue;
        if (!*lit && !(*lit = luxel_scene_copy(scene)))
            return lx_out_of_memory(diagnostics);
        snprintf(assignment, sizeof assignment, "lights[%zu].enabled=%s", i, on[i] ? "true" : "false");
        status = luxel_scene_set(*lit, assignment, diagnostics);
    }
    return *lit && status == LUXEL_OK ? luxel_scene_commit(*lit, diagnostics) : status;
}

luxel_status lx_scene_lit(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                          luxel_scene **lit)
{
    *lit = NULL;
    if (!settings || !settings->lights)
        return LUXEL_OK;
    bool *on = lx_lights_on(lx_scene_parameters(scene), settings);
    luxel_status status = on ? turn(scene, on, diagnostics, lit) : lx_out_of_memory(diagnostics);
    free(on);
    if (status != LUXEL_OK) {
        luxel_scene_free(*lit);
        *lit = NULL;
    }
    return status;
}

bool lx_has_extended_lights(const struct lx_scene_parameters *scene)
{
    for (size_t i = 0; i < scene->lights.count; i++) {
        const struct lx_item *light = &scene->lights.items[i];
        const struct lx_light_common *common = light->common;
        const struct lx_table *table = light->variant->table;
        const bool is_extended =
            strcmp(light->variant->name, "planar") == 0 || strcmp(light->variant->name, "volume") == 0 ||
            strcmp(light->variant->name, "sky") == 0 ||
            (lx_find_parameter(table, "opening") && lx_is_given(table, light->parameters, "opening"));
        if (common->enabled && is_extended)
            return true;
    }
    return false;
}

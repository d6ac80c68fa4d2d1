/* SPDX-License-Identifier: MIT */
/* The skies of a scene, and the scene that they alone light. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/diagnostics.h"
#include "../../base/memory.h"
#include "../../light/array.h"
#include "../../light/sky/dome.h"
#include "../../scene/object.h"
#include "../../scene/scene.h"
#include "daylight.h"

luxel_status lx_find_skies(const luxel_scene *scene, luxel_diagnostics *diagnostics, struct lx_skies *skies)
{
    const struct lx_list *lights = &scene->parameters.lights;
    lx_bounded sum = lx_exact(0);
    *skies = (struct lx_skies){.items = lx_new_array(lights->count + 1, sizeof *skies->items)};
    if (!skies->items)
        return LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < lights->count; i++) {
        const struct lx_item *light = &lights->items[i];
        struct lx_emitters emitters = {0};
        if (!((const struct lx_light_common *)light->common)->enabled || strcmp(light->variant->name, "sky") != 0)
            continue;
        skies->items[skies->count++] = i;
        const int failed = lx_light_lower(light, 1, 1, &emitters);
        for (size_t k = 0; k < lx_item_count(&emitters); k++)
            sum = lx_add(sum, emitters.items[k].dome->facing);
        lx_emitters_clear(&emitters);
        if (failed)
            return LUXEL_ERROR_MEMORY;
    }
    skies->horizontal = sum;
    if (sum.value > 0)
        return LUXEL_OK;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_SKY, NULL);
    lx_hint(diagnostics, LX_MSG_HINT_NO_SKY, NULL);
    return LUXEL_ERROR_SCENE;
}

/* Multiplies all that tells how strong a sky is. */
static luxel_status strengthen(luxel_scene *scene, size_t light, double factor, luxel_diagnostics *diagnostics)
{
    static const char *const keys[] = {"zenith", "horizontal", "diffuse", "direct", "extraterrestrial"};
    const struct lx_item *sky = &scene->parameters.lights.items[light];
    const struct lx_table *table = sky->variant->table;
    char changes[LX_COUNT(keys)][96];
    size_t count = 0;
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < LX_COUNT(keys); i++) {
        const struct lx_parameter *key = lx_find_parameter(table, keys[i]);
        const double *value = (const double *)((const char *)sky->parameters + key->offset);
        if (lx_is_given(table, sky->parameters, keys[i]) ||
            (i + 1 == LX_COUNT(keys) && lx_is_given(table, sky->parameters, "diffuse")))
            snprintf(changes[count++], sizeof changes[0], "lights[%zu].%s=%.17g", light, keys[i], factor * *value);
    }
    for (size_t i = 0; i < count && status == LUXEL_OK; i++)
        status = luxel_scene_set(scene, changes[i], diagnostics);
    return status;
}

luxel_status lx_daylit_scene(const luxel_scene *scene, luxel_diagnostics *diagnostics, luxel_scene **daylit)
{
    struct lx_skies skies;
    luxel_status status = lx_find_skies(scene, diagnostics, &skies);
    luxel_scene *made = status == LUXEL_OK ? luxel_scene_copy(scene) : NULL;
    status = status == LUXEL_OK && !made ? LUXEL_ERROR_MEMORY : status;
    for (size_t i = 0, sky = 0; i < scene->parameters.lights.count && status == LUXEL_OK; i++) {
        char off[64];
        snprintf(off, sizeof off, "lights[%zu].enabled=false", i);
        if (sky < skies.count && skies.items[sky] == i) {
            status = strengthen(made, i, 100 / skies.horizontal.value, diagnostics);
            sky++;
        } else {
            status = luxel_scene_set(made, off, diagnostics);
        }
    }
    if (status == LUXEL_OK)
        status = luxel_scene_commit(made, diagnostics);
    free(skies.items);
    if (status == LUXEL_ERROR_MEMORY)
        lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        *daylit = made;
    else
        luxel_scene_free(made);
    return status;
}

/* SPDX-License-Identifier: MIT */
/* What the lights of a scene are as a whole, each lowered by itself. */
#include <luxel/light.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../light/array.h"
#include "../light/totals.h"
#include "../scene/scene.h"

size_t luxel_scene_light_count(const luxel_scene *scene)
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    return parameters ? parameters->lights.count : 0;
}

static const struct lx_item *item_of(const luxel_scene *scene, size_t i)
{
    return i < luxel_scene_light_count(scene) ? &lx_scene_parameters(scene)->lights.items[i] : NULL;
}

const char *luxel_scene_light_type(const luxel_scene *scene, size_t i)
{
    const struct lx_item *item = item_of(scene, i);
    return item ? item->variant->name : NULL;
}

const char *luxel_scene_light_name(const luxel_scene *scene, size_t i)
{
    const struct lx_item *item = item_of(scene, i);
    return item ? ((const struct lx_light_common *)item->common)->name : NULL;
}

bool luxel_scene_light_enabled(const luxel_scene *scene, size_t i)
{
    const struct lx_item *item = item_of(scene, i);
    return item && ((const struct lx_light_common *)item->common)->enabled;
}

/* The emitters of light i; to be cleared whatever it returns. */
static luxel_status lower(const luxel_scene *scene, size_t i, struct lx_emitters *emitters)
{
    *emitters = (struct lx_emitters){.is_whole = true};
    const struct lx_item *item = item_of(scene, i);
    if (!item)
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    return lx_light_lower(item, parameters->maintenance, lx_dimming_of(parameters, item), emitters) == 0
               ? LUXEL_OK
               : LUXEL_ERROR_MEMORY;
}

/* The number that one of the totals gives of light i. */
static luxel_status measure(const luxel_scene *scene, size_t i, double (*total)(const struct lx_emitters *),
                            double *answer)
{
    struct lx_emitters emitters;
    if (!answer)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = lower(scene, i, &emitters);
    double sum = status == LUXEL_OK ? total(&emitters) : 0;
    lx_emitters_clear(&emitters);
    if (status == LUXEL_OK && isinf(sum))
        status = LUXEL_ERROR_RANGE;
    if (status == LUXEL_OK)
        *answer = sum;
    return status;
}

luxel_status luxel_scene_light_flux(const luxel_scene *scene, size_t i, double *flux)
{
    return measure(scene, i, lx_emitters_flux, flux);
}

luxel_status luxel_scene_light_intensity(const luxel_scene *scene, size_t i, double *intensity)
{
    return measure(scene, i, lx_emitters_intensity, intensity);
}

/* What one of the totals says of light i. */
static bool ask(const luxel_scene *scene, size_t i, bool (*total)(const struct lx_emitters *, double[3]),
                double answer[3])
{
    struct lx_emitters emitters;
    bool is_there = answer && lower(scene, i, &emitters) == LUXEL_OK && total(&emitters, answer);
    if (answer)
        lx_emitters_clear(&emitters);
    return is_there;
}

bool luxel_scene_light_place(const luxel_scene *scene, size_t i, double position_mm[3])
{
    return ask(scene, i, lx_emitters_place, position_mm);
}

size_t luxel_scene_light_place_count(const luxel_scene *scene, size_t i)
{
    const struct lx_item *item = item_of(scene, i);
    return item ? lx_light_places(item) : 0;
}

bool luxel_scene_light_places(const luxel_scene *scene, size_t i, double (*places_mm)[3])
{
    const struct lx_item *item = places_mm ? item_of(scene, i) : NULL;
    double(*found_mm)[3] = item ? lx_light_find_places(item) : NULL;
    if (found_mm)
        memcpy(places_mm, found_mm, lx_light_places(item) * sizeof *places_mm);
    free(found_mm);
    return found_mm != NULL;
}

bool luxel_scene_light_direction(const luxel_scene *scene, size_t i, double direction[3])
{
    return ask(scene, i, lx_emitters_direction, direction);
}

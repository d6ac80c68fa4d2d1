/* SPDX-License-Identifier: MIT */
/* Where light arrives, by the kernels of the irradiance in float64. */
#include "reach.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../light/solid/extended.h"
#include "plan_make.h"

/* A source that shines at all shines with strength 1 by the law 1/r^2, and ambient light not at all. */
static void make_plain(struct lx_emitter *emitter)
{
    emitter->attenuation = LX_INVERSE_SQUARE;
    if (lx_is_uniform(emitter))
        emitter->strength = 0;
    else if (emitter->strength > 0)
        emitter->strength = 1;
    if (lx_is_extended(emitter) && emitter->radiance.value > 0)
        emitter->radiance = lx_exact(1);
}

/* Whether an emitter shines that was made plain. */
static bool shines(const struct lx_emitter *emitter)
{
    return lx_is_dome(emitter) || (lx_is_extended(emitter) ? emitter->radiance.value > 0 : emitter->strength > 0);
}

static bool has_ambient_light(const struct lx_emitters *emitters)
{
    for (size_t i = 0; i < lx_item_count(emitters); i++)
        if (lx_is_uniform(&emitters->items[i]) && emitters->items[i].strength > 0)
            return true;
    return false;
}

luxel_status lx_reach_open(struct lx_reach *reach, const struct lx_scene_parameters *scene,
                           const struct lx_kernels *kernels, const luxel_settings *settings)
{
    luxel_settings own = *settings;
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    const struct lx_asking asking = {.control = &control, .is_caller = true};
    *reach = (struct lx_reach){.plan = {.surfaces = NULL}};
    own.quantity = LUXEL_IRRADIANCE;
    own.precision = LUXEL_DOUBLE;
    own.light_error = own.tolerance = 0;
    if (lx_prepare(scene, &own, &asking, &reach->prepared) != 0)
        return atomic_load(&control.stop) ? LUXEL_CANCELLED : LUXEL_ERROR_MEMORY;
    struct lx_emitters *emitters = &reach->prepared.emitters;
    reach->has_ambient = has_ambient_light(emitters);
    reach->has_direct = emitters->in_point_sets > 0;
    for (size_t i = 0; i < lx_item_count(emitters); i++) {
        make_plain(&emitters->items[i]);
        reach->has_direct = reach->has_direct || shines(&emitters->items[i]);
    }
    for (size_t i = 0; i < emitters->point_set_count; i++)
        make_plain(&emitters->point_sets[i].model);
    const luxel_status status = lx_plan_make(&reach->prepared, kernels, &own, &reach->plan);
    reach->plan.part_tolerance = 1e-3; /* what is hidden in part is lit, however much of it is left */
    return status;
}

void lx_reach_clear(struct lx_reach *reach)
{
    lx_plan_clear(&reach->plan);
    lx_prepared_clear(&reach->prepared);
}

void lx_reach_row(const struct lx_reach *reach, struct lx_shader_memory *memory, double y_mm, const double *x_mm,
                  size_t count, uint8_t *mask, uint8_t *arrives)
{
    _Alignas(64) double values[LX_BLOCK];
    lx_shader_enter(&reach->plan, memory, &y_mm, 1, x_mm, count);
    lx_shade_row(&reach->plan, memory, 0, NULL, false, values, mask);
    for (size_t i = 0; i < count; i++)
        arrives[i] = mask[i] && values[i] > 0;
}

luxel_status lx_reach_share(const struct lx_reach *reach, const double *x_mm, unsigned columns, const double *y_mm,
                            unsigned rows, double *share)
{
    struct lx_shader_memory *memory = lx_shader_memory_new(&reach->plan);
    uint8_t mask[LX_BLOCK], arrives[LX_BLOCK];
    size_t shown = 0, lit = 0;
    if (!memory)
        return LUXEL_ERROR_MEMORY;
    for (unsigned row = 0; row < rows; row++)
        for (unsigned first = 0; first < columns; first += LX_BLOCK) {
            const size_t left = columns - first, count = left < LX_BLOCK ? left : LX_BLOCK;
            lx_reach_row(reach, memory, y_mm[row], x_mm + first, count, mask, arrives);
            for (size_t i = 0; i < count; i++) {
                shown += mask[i];
                lit += arrives[i];
            }
        }
    *share = shown > 0 ? (double)lit / (double)shown : 0;
    lx_shader_memory_free(memory);
    return LUXEL_OK;
}

bool lx_reach_is_plain(const struct lx_prepared *prepared, luxel_quantity quantity)
{
    const bool has_ambient = has_ambient_light(&prepared->emitters);
    if (quantity == LUXEL_IRRADIANCE)
        return !has_ambient;
    for (size_t s = 0; s < prepared->surface_count; s++) {
        const struct lx_lobe *lobe = &prepared->surfaces[s].lobe;
        if ((has_ambient && lobe->ambient.value > 0) || lx_lobe_reaches_below(lobe))
            return false;
    }
    return true;
}

/* SPDX-License-Identifier: MIT */
/* Lowering a scene to surfaces and emitters, and naming the unit of the result. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/phrase.h"
#include "../light/light.h"
#include "prepared.h"

/* What memory could hold, and more, where it is not known how much there is. */
static const double MOST_EMITTERS = 1e9;
enum { FEW_EMITTERS = 4096 };

static int prepare_lights(const struct lx_list *lights, struct lx_emitters *emitters)
{
    for (size_t i = 0; i < lights->count; i++) {
        const struct lx_item *item = &lights->items[i];
        const struct lx_light_common *common = item->common;
        const struct lx_light_kind *kind = (const struct lx_light_kind *)item->variant;
        size_t first = emitters->count;
        if (common->enabled && kind->prepare(item->parameters, emitters))
            return -1;
        lx_emitters_set_light(emitters, first, i);
    }
    return 0;
}

static int prepare(const struct lx_scene_parameters *scene, double tolerance, size_t most, size_t most_in_swarms,
                   struct lx_prepared *prepared)
{
    const struct lx_list *surfaces = &scene->surfaces;
    *prepared = (struct lx_prepared){
        .scene = scene,
        .surfaces = lx_new_array(surfaces->count, sizeof *prepared->surfaces),
        .surface_count = surfaces->count,
        .emitters = {.most = most, .most_in_swarms = most_in_swarms},
        .tolerance = tolerance,
        .shadows = scene->shadows == LX_SHADOWS_POINTS && surfaces->count > 1,
    };
    if (!prepared->surfaces)
        return -1;
    for (size_t i = 0; i < surfaces->count; i++) {
        const struct lx_item *item = &surfaces->items[i];
        const struct lx_surface_common *common = item->common;
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
        prepared->surfaces[i] = (struct lx_prepared_surface){
            .kind = kind,
            .parameters = item->parameters,
            .shape = kind->shape(item->parameters),
            .lobe = lx_lobe_prepare(&common->material),
        };
    }
    return prepare_lights(&scene->lights, &prepared->emitters);
}

int lx_prepare(const struct lx_scene_parameters *scene, double tolerance, struct lx_prepared *prepared)
{
    /* The usual scene has few, and need not ask for memory; besides the emitters, each surface has its constants, and
     * the numbers of the surfaces that may stand in their light. */
    int failed = lx_prepare_few(scene, tolerance, FEW_EMITTERS, prepared);
    if (!failed || !prepared->emitters.is_short)
        return failed;
    size_t surfaces = scene->surfaces.count, others = prepared->shadows ? surfaces - 1 : 0;
    lx_prepared_clear(prepared);
    double each = (double)(sizeof(struct lx_emitter) + surfaces * (320 + others * sizeof(uint32_t)));
    double each_in_swarms = (double)(64 + surfaces * others * sizeof(uint32_t)), available = lx_available_bytes();
    return prepare(scene, tolerance, (size_t)fmin(available / each, MOST_EMITTERS),
                   (size_t)fmin(available / each_in_swarms, MOST_EMITTERS), prepared);
}

int lx_prepare_few(const struct lx_scene_parameters *scene, double tolerance, size_t most, struct lx_prepared *prepared)
{
    return prepare(scene, tolerance, most, 0, prepared);
}

void lx_prepared_clear(struct lx_prepared *prepared)
{
    free(prepared->surfaces);
    lx_emitters_clear(&prepared->emitters);
    *prepared = (struct lx_prepared){0};
}

/* What the lights' laws have in common. */
enum laws { ALL_UNATTENUATED, ALL_PHYSICAL, MIXED };

static enum laws common_law(const struct lx_emitters *emitters)
{
    size_t unattenuated = 0, physical = 0;
    for (struct lx_emitter_span span = {0}; lx_emitters_next(emitters, &span);)
        for (size_t i = span.first; i < span.end; i++) {
            const struct lx_emitter *emitter = span.swarm ? &span.swarm->model : &span.items[i - span.first];
            size_t count = span.swarm ? span.end - span.first : 1; /* the points of a swarm have one law */
            bool has_law = emitter->type == LX_POINT || lx_is_extended(emitter);
            if (!has_law || emitter->attenuation == LX_INVERSE_SQUARE)
                physical += count;
            else if (emitter->attenuation == LX_NO_ATTENUATION)
                unattenuated += count;
            i += count - 1;
        }
    if (unattenuated == emitters->count)
        return ALL_UNATTENUATED;
    return physical == emitters->count ? ALL_PHYSICAL : MIXED;
}

const char *lx_unit_of(const struct lx_prepared *prepared, luxel_quantity quantity)
{
    const struct lx_list *surfaces = &prepared->scene->surfaces;
    bool photometric = prepared->scene->units == LX_PHOTOMETRIC;
    size_t over_pi = 0;
    for (size_t i = 0; quantity == LUXEL_BRIGHTNESS && i < surfaces->count; i++)
        over_pi += ((const struct lx_surface_common *)surfaces->items[i].common)->material.over_pi;
    bool all = over_pi == surfaces->count && over_pi > 0, none = over_pi == 0;

    enum laws laws = common_law(&prepared->emitters);
    if (laws == ALL_UNATTENUATED && none)
        return photometric ? LX_N("cd") : LX_N("W/sr");
    if (laws == ALL_PHYSICAL && none)
        return photometric ? LX_N("lx") : LX_N("W/m²");
    if (laws == ALL_PHYSICAL && all)
        return photometric ? LX_N("cd/m²") : LX_N("W/(sr·m²)");
    return LX_N("relative");
}

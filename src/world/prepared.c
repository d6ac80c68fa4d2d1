/* SPDX-License-Identifier: MIT */
/* Lowering a scene to surfaces and emitters, and naming the unit of the result. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/phrase.h"
#include "../base/rows.h"
#include "../light/array.h"
#include "../light/carry.h"
#include "../parameter/decode.h"
#include "../scene/colours.h"
#include "../scene/lit.h"
#include "among.h"
#include "mirrors.h"
#include "open_domes.h"
#include "potentials.h"
#include "prepared.h"

/* How many a scene may have without asking how much memory there is. */
enum { FEW_EMITTERS = 4096 };
/* A point of a point set takes so much. */
enum { SWARM_BYTES = 64 };

/* The largest coordinate of what surfaces are; those of endless ones do not count. */
static double reach_of(const struct lx_prepared *prepared)
{
    double reach = 0;
    for (size_t i = 0; i < prepared->surface_count; i++)
        for (int k = 0; k < 3; k++) {
            const double most = fmax(fabs(prepared->surfaces[i].low_mm[k]), fabs(prepared->surfaces[i].high_mm[k]));
            reach = isfinite(most) ? fmax(reach, most) : reach;
        }
    return reach;
}

static int prepare_lights(const struct lx_scene_parameters *scene, const bool *on, struct lx_emitters *emitters)
{
    const struct lx_list *lights = &scene->lights;
    for (size_t i = 0; i < lights->count; i++) {
        const double dimming = lx_dimming_of(scene, &lights->items[i]);
        emitters->light = i;
        if (on[i] && (!lx_asking_goes_on(emitters->asking) ||
                      lx_light_lower(&lights->items[i], scene->maintenance, dimming, emitters)))
            return -1;
    }
    return 0;
}

static size_t count_parts(const struct lx_list *surfaces)
{
    size_t count = 0;
    for (size_t i = 0; i < surfaces->count; i++)
        count +=
            lx_piece_count((const struct lx_surface_kind *)surfaces->items[i].variant, surfaces->items[i].parameters);
    return count;
}

/* The material in the scene's channel, number `number` of those that may be another one there. */
static const struct lx_material *in_channel(const struct lx_prepared *prepared, const struct lx_material *material,
                                            size_t number)
{
    if (!prepared->colored || (prepared->scene->channel <= LX_CHANNELS && !lx_has_color(material)))
        return material;
    prepared->colored[number] = lx_material_in_channel(material, prepared->scene->channel);
    return &prepared->colored[number];
}

/* The lobe of a material that was authored so; factors that were multiplied by a colour are rounded. */
static struct lx_lobe lobe_of(const struct lx_material *material, const struct lx_material *authored)
{
    struct lx_lobe lobe = lx_lobe_prepare(material);
    const double roundings = material != authored ? 4 * LX_ROUNDING : 0;
    lobe.diffuse.error += roundings * lobe.diffuse.value;
    lobe.specular.error += roundings * lobe.specular.value;
    lobe.ambient.error += roundings * lobe.ambient.value;
    return lobe;
}

/* Whether a part of a surface, or all of it, is a mirror, which weighs nothing. */
static bool is_mirror(const struct lx_surface_kind *kind, const void *parameters, const struct lx_material *material)
{
    return kind->is_mirror && (material->mirror || kind->is_mirror(parameters));
}

/* Appends the parts of surface i. */
static void prepare_surface(const struct lx_scene_parameters *scene, size_t i, struct lx_prepared *prepared)
{
    const struct lx_item *item = &scene->surfaces.items[i];
    const struct lx_surface_common *common = item->common;
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    const size_t count = lx_piece_count(kind, item->parameters);
    const struct lx_material *own = in_channel(prepared, &common->material, i);
    prepared->authored[i] = (struct lx_authored_surface){prepared->surface_count, lobe_of(own, &common->material)};
    for (size_t k = 0; k < count; k++) {
        struct lx_prepared_surface *surface = &prepared->surfaces[prepared->surface_count];
        struct lx_part part;
        unsigned number;
        lx_piece_make(kind, item->parameters, k, &part, &number);
        const struct lx_material *material =
            part.material ? in_channel(prepared, part.material, scene->surfaces.count + prepared->surface_count) : own;
        *surface = (struct lx_prepared_surface){
            .kind = part.kind,
            .parameters = part.parameters,
            .shape = part.shape,
            .material = material,
            .lobe = part.material ? lobe_of(material, part.material) : prepared->authored[i].lobe,
            .authored = i,
            .part = number,
        };
        if (part.parameters == (const void *)&part.own) {
            surface->own = part.own;
            surface->parameters = &surface->own;
        }
        surface->is_mirror = is_mirror(surface->kind, surface->parameters, material);
        surface->kind->extent(surface->parameters, surface->low_mm, surface->high_mm);
        const bool is_first = prepared->surface_count++ == 0;
        prepared->shadows = prepared->shadows || (prepared->shadows_on_free && lx_may_hide(&part.shape, is_first));
    }
}

/* Panes in the openings of all surfaces; 0, or -1 when memory ran out. */
static int prepare_panes(const struct lx_list *surfaces, struct lx_prepared *prepared)
{
    size_t capacity = 0;
    for (size_t i = 0; i < surfaces->count; i++) {
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surfaces->items[i].variant;
        struct lx_glass_pane pane = {.index = 0};
        for (size_t k = 0; kind->panes && k < kind->panes(surfaces->items[i].parameters, k, &pane); k++) {
            if (lx_reserve(&prepared->panes, &capacity, prepared->pane_count + 1, sizeof pane))
                return -1;
            pane.surface = i;
            prepared->is_glazed = prepared->is_glazed || pane.index > 0;
            prepared->panes[prepared->pane_count++] = pane;
        }
    }
    return 0;
}

/* The lobe of free elements in a scene without surfaces: that of a material with all keys by default. */
static struct lx_lobe default_lobe(void)
{
    struct lx_material material = {0};
    for (size_t i = 0; i < lx_material_table.count; i++)
        lx_set_default(&lx_material_table.parameters[i], lx_member(&lx_material_table.parameters[i], &material));
    return lx_lobe_prepare(&material);
}

/* `room`: an empty list that knows how many emitters it may take. */
static int prepare(const struct lx_scene_parameters *scene, const luxel_settings *settings, double tolerance,
                   const struct lx_emitters *room, struct lx_prepared *prepared)
{
    const struct lx_list *surfaces = &scene->surfaces;
    *prepared = (struct lx_prepared){
        .scene = scene,
        .camera = lx_camera_of(&scene->observer),
        .surfaces = lx_new_array(count_parts(surfaces), sizeof *prepared->surfaces),
        .authored = lx_new_array(lx_material_count(scene), sizeof *prepared->authored),
        .on = lx_lights_on(scene, settings),
        .emitters = *room,
        .tolerance = tolerance,
        .shadows_extended = scene->shadows == LX_SHADOWS_ALL,
        .shadows_on_free = scene->shadows != LX_SHADOWS_NONE,
    };
    if (scene->channels == LX_RGB)
        prepared->colored = lx_new_array(count_parts(surfaces) + surfaces->count, sizeof *prepared->colored);
    if (!prepared->surfaces || !prepared->authored || !prepared->on ||
        (scene->channels == LX_RGB && !prepared->colored))
        return -1;
    prepared->authored[0].lobe = default_lobe();
    for (size_t i = 0; i < surfaces->count; i++)
        prepare_surface(scene, i, prepared);
    prepared->reach_mm = reach_of(prepared);
    if (prepare_panes(surfaces, prepared) || lx_among_make(prepared) || lx_mirrors_make(prepared, scene->mirrors, NULL))
        return -1;
    int failed = prepare_lights(scene, prepared->on, &prepared->emitters);
    prepared->emitters.asking = NULL;
    prepared->open_domes = lx_has_dome(&prepared->emitters) ? lx_open_domes_new() : NULL;
    prepared->potentials = prepared->open_domes ? lx_potentials_new() : NULL;
    return failed;
}

int lx_prepare(const struct lx_scene_parameters *scene, const luxel_settings *settings, const struct lx_asking *asking,
               struct lx_prepared *prepared)
{
    /* The usual scene has few, and need not ask for memory; besides the emitters, each surface has its constants, and
     * the numbers of the surfaces that may stand in their light.  What is carried to a screen is there twice. */
    const size_t surfaces = count_parts(&scene->surfaces);
    const size_t others = scene->shadows != LX_SHADOWS_NONE && surfaces > 1 ? surfaces - 1 : 0;
    const size_t placed = lx_observer_is_placed(&scene->observer);
    const struct lx_emitters room = {
        .most = FEW_EMITTERS,
        .each = (double)((placed + 1) * sizeof(struct lx_emitter) + surfaces * (320 + others * sizeof(uint32_t))),
        .each_in_point_sets = (double)((placed + 1) * SWARM_BYTES + surfaces * others * sizeof(uint32_t)),
        .asking = asking,
    };
    const double tolerance = settings && settings->tolerance > 0 ? settings->tolerance : LX_DEFAULT_TOLERANCE;
    return prepare(scene, settings, tolerance, &room, prepared);
}

int lx_prepare_few(const struct lx_scene_parameters *scene, double tolerance, size_t most, struct lx_prepared *prepared)
{
    const struct lx_emitters room = {.most = most};
    return prepare(scene, NULL, tolerance, &room, prepared);
}

int lx_prepared_carry(const struct lx_prepared *prepared, const struct lx_asking *asking, struct lx_prepared *carried)
{
    const struct lx_frame *frame = &prepared->camera.frame;
    *carried = *prepared;
    carried->camera = lx_camera_carried(&prepared->camera);
    carried->surfaces = lx_new_array(prepared->surface_count, sizeof *carried->surfaces);
    carried->authored = lx_new_array(lx_material_count(prepared->scene), sizeof *carried->authored);
    carried->boxes = (struct lx_boxes){.count = 0};
    carried->mirrors = (struct lx_mirrors){.count = 0};
    carried->panes = lx_new_array(prepared->pane_count, sizeof *carried->panes);
    carried->colored = NULL; /* its materials are those of the scene that it is a copy of, which outlives it */
    carried->on = lx_new_array(prepared->scene->lights.count, sizeof *carried->on);
    carried->emitters = (struct lx_emitters){0};
    carried->open_domes = prepared->open_domes ? lx_open_domes_new() : NULL;
    carried->potentials = prepared->potentials ? lx_potentials_new() : NULL;
    if (!carried->surfaces || !carried->authored || !carried->on || (prepared->pane_count > 0 && !carried->panes))
        return -1;
    for (size_t i = 0; i < prepared->pane_count; i++)
        carried->panes[i] = lx_pane_carried(&prepared->panes[i], frame);
    memcpy(carried->on, prepared->on, prepared->scene->lights.count * sizeof *carried->on);
    memcpy(carried->authored, prepared->authored, lx_material_count(prepared->scene) * sizeof *carried->authored);
    for (size_t i = 0; i < prepared->surface_count; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[i];
        struct lx_prepared_surface *made = &carried->surfaces[i];
        *made = *surface;
        made->shape = lx_shape_carried(&surface->shape, frame);
        made->parameters = NULL;
        lx_surface_extent(surface->kind, surface->parameters, frame, made->low_mm, made->high_mm);
    }
    carried->reach_mm = reach_of(carried);
    if (lx_among_make(carried) || lx_mirrors_make(carried, prepared->scene->mirrors, prepared))
        return -1;
    return lx_emitters_carry(&prepared->emitters, frame, asking, &carried->emitters);
}

const struct lx_prepared *lx_prepared_on_screen(const struct lx_prepared *prepared, const struct lx_asking *asking,
                                                struct lx_prepared **carried)
{
    *carried = NULL;
    if (prepared->camera.frame.is_own)
        return prepared;
    *carried = lx_new_array(1, sizeof **carried);
    return *carried && lx_prepared_carry(prepared, asking, *carried) == 0 ? *carried : NULL;
}

void lx_prepared_free(struct lx_prepared *carried)
{
    if (carried)
        lx_prepared_clear(carried);
    free(carried);
}

void lx_prepared_clear(struct lx_prepared *prepared)
{
    free(prepared->surfaces);
    lx_boxes_clear(&prepared->boxes);
    free(prepared->authored);
    free(prepared->colored);
    free(prepared->on);
    free(prepared->panes);
    lx_emitters_clear(&prepared->emitters);
    lx_mirrors_clear(&prepared->mirrors);
    lx_open_domes_free(prepared->open_domes);
    lx_potentials_free(prepared->potentials);
    *prepared = (struct lx_prepared){0};
}

/* An intensity without a distance makes no irradiance, and a mixture of laws no unit at all. */
static const char *unit_of_irradiance(const struct lx_emitters *emitters, bool photometric)
{
    const char *unit = photometric ? LX_N("lx") : LX_N("W/m²");
    return emitters->by_square == emitters->count ? unit : LX_N("relative");
}

/* The unit where `over_pi` of so many surfaces and parts of them weigh by 1/pi.  No light at all obeys every law. */
static const char *unit_of_brightness(const struct lx_emitters *emitters, bool photometric, size_t over_pi,
                                      size_t parts)
{
    const bool all = over_pi == parts && over_pi > 0, none = over_pi == 0;
    const bool physical = emitters->by_square == emitters->count;
    if (emitters->unattenuated == emitters->count && none)
        return photometric ? LX_N("cd") : LX_N("W/sr");
    if (physical && none)
        return photometric ? LX_N("lx") : LX_N("W/m²");
    if (physical && all)
        return photometric ? LX_N("cd/m²") : LX_N("W/(sr·m²)");
    return LX_N("relative");
}

const char *lx_unit_of(const struct lx_prepared *prepared, luxel_quantity quantity)
{
    const bool photometric = prepared->scene->units == LX_PHOTOMETRIC;
    size_t over_pi = 0;
    if (quantity == LUXEL_IRRADIANCE)
        return unit_of_irradiance(&prepared->emitters, photometric);
    for (size_t i = 0; i < prepared->surface_count; i++)
        over_pi += prepared->surfaces[i].material->over_pi && !prepared->surfaces[i].is_mirror;
    return unit_of_brightness(&prepared->emitters, photometric, over_pi,
                              prepared->surface_count - prepared->mirrors.count);
}

/* How many parts of a surface weigh by 1/pi, of so many that weigh anything. */
static size_t count_over_pi(const struct lx_item *item, size_t *parts)
{
    const struct lx_surface_common *common = item->common;
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    size_t count = 0;
    if (!kind->part_names) {
        const bool weighs = !is_mirror(kind, item->parameters, &common->material);
        *parts += weighs;
        return weighs && common->material.over_pi;
    }
    for (unsigned k = 0; k < lx_part_count(kind); k++) {
        struct lx_part part;
        lx_part_make(kind, item->parameters, k, &part);
        const struct lx_material *material = part.material ? part.material : &common->material;
        const bool weighs = !is_mirror(part.kind, part.parameters, material);
        *parts += weighs;
        count += weighs && material->over_pi;
    }
    return count;
}

const char *lx_unit_of_scene(const struct lx_scene_parameters *scene, const luxel_settings *settings)
{
    const luxel_quantity quantity = settings ? settings->quantity : LUXEL_BRIGHTNESS;
    const bool photometric = scene->units == LX_PHOTOMETRIC;
    struct lx_emitters emitters = {
        .most = FEW_EMITTERS, .each = sizeof(struct lx_emitter), .each_in_point_sets = SWARM_BYTES};
    bool *on = lx_lights_on(scene, settings);
    const char *unit = LX_N("relative");
    size_t over_pi = 0, parts = 0;
    for (size_t i = 0; i < scene->surfaces.count && quantity == LUXEL_BRIGHTNESS; i++)
        over_pi += count_over_pi(&scene->surfaces.items[i], &parts);
    if (on && prepare_lights(scene, on, &emitters) == 0)
        unit = quantity == LUXEL_IRRADIANCE ? unit_of_irradiance(&emitters, photometric)
                                            : unit_of_brightness(&emitters, photometric, over_pi, parts);
    lx_emitters_clear(&emitters);
    free(on);
    return unit;
}

/* SPDX-License-Identifier: MIT */
/* The light of extended sources over a run of pixels: all of them, or what is seen of them. */
#include <math.h>
#include <string.h>

#include "../light/solid/extended.h"
#include "../world/integral/cubature.h"
#include "shader_memory.h"

/* Sources that are summed between two questions whether to go on. */
enum { SHELLS_BETWEEN_CHECKS = 4 };

/* An element of the block as the references take it. */
static struct lx_element element_of(const struct lx_planned_surface *surface, const struct lx_block_double *block,
                                    size_t i)
{
    const double *anchor = surface->shape.anchor_mm;
    double place[3] = {anchor[0] + block->px[i], anchor[1] + block->py[i], anchor[2] + block->pz[i]};
    return (struct lx_element){
        .place_mm = lx_exact3(place),
        .normal = lx_exact3((double[]){block->nx[i], block->ny[i], block->nz[i]}),
        .view = lx_exact3((double[]){block->vx[i], block->vy[i], block->vz[i]}),
        .lobe = &surface->lobe,
    };
}

/* The diffuse light of one element by an extended source whose law has no closed form. */
static double integrate_matte(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                              const struct lx_emitter *emitter, const struct lx_block_double *block, size_t i,
                              const struct lx_asking *asking)
{
    struct lx_lobe matte = surface->lobe;
    matte.specular = lx_exact(0);
    struct lx_element element = element_of(surface, block, i);
    element.lobe = &matte;
    if (lx_extended_touches(emitter, element.place_mm))
        return 0;
    double tolerance = plan->precision == LUXEL_DOUBLE ? 1e-12 : 1e-7;
    double irradiance = lx_integrate(emitter, &element, NULL, true, 0, tolerance, asking).irradiance.value;
    return irradiance > 0 ? matte.diffuse.value * irradiance : 0;
}

/* The highlights of one element. */
static double integrate_glossy(const struct lx_plan *plan, const struct lx_planned_surface *surface, double known,
                               const struct lx_block_double *block, size_t i, const struct lx_asking *asking)
{
    const struct lx_element element = element_of(surface, block, i);
    double sum = 0;
    for (size_t s = 0; s < surface->glossy_count && lx_asking_goes_on(asking); s++) {
        const struct lx_emitter *emitter = surface->glossy[s].emitter;
        if (lx_extended_touches(emitter, element.place_mm))
            continue;
        double specular =
            lx_integrate(emitter, &element, NULL, false, known, plan->tolerance / 2, asking).specular.value;
        sum += specular > 0 ? specular : 0;
    }
    return sum;
}

/* Adds the diffuse light of an extended source by a law without a closed form: by rules of Gauss, and where the source
 * is too near for them by integrals for each element. */
static void light_by_law(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                         const struct lx_planned_area_light *planned, struct lx_shader_memory *memory, size_t count,
                         const struct lx_asking *asking)
{
    const struct lx_area_light *lamp = &planned->lamp;
    uint8_t left[LX_BLOCK] = {0};
    lx_light_by_law *const light =
        planned->in_single ? plan->kernels->law_single[lamp->type] : plan->kernels->law_double[lamp->type];
    if (light)
        light(lamp, plan->rules, surface->lobe_exact.diffuse, &memory->seen.block, count, asking, memory->sum, left);
    else
        memset(left, 1, count);
    for (size_t i = 0; i < count; i++) {
        if (!left[i])
            continue;
        memory->sum[i] += integrate_matte(plan, surface, planned->emitter, &memory->seen.block, i, asking);
        if (!lx_asking_goes_on(asking))
            return;
    }
}

static struct lx_sampler sampler_of(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                    const struct lx_asking *asking)
{
    return (struct lx_sampler){
        .kernels = plan->kernels,
        .sources = surface->glossy,
        .source_count = surface->glossy_count,
        .lobe = &surface->glossy_exact,
        .lobe_single = &surface->glossy_single,
        .tolerance = plan->tolerance,
        .least_maximum = plan->least_maximum,
        .least = lx_least_of(plan->precision),
        .most_cells = LX_MOST_CELLS,
        .asking = asking,
    };
}

/* Whether elements of a run see all of every source. */
static bool sees_all(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                     struct lx_shader_memory *memory, size_t start, size_t last)
{
    for (size_t s = 0; s < surface->area_light_count; s++)
        if (surface->area_lights[s].blocker_count > 0 &&
            !lx_find_sight(plan, surface, &surface->area_lights[s], &memory->seen.block, start, last,
                           &memory->penumbra))
            return false;
    return true;
}

/* The highlight of all of a source over a run of elements, sampled when it is first asked for. */
struct whole_highlight {
    double added[LX_LANES];
    bool is_tried, is_good;
};

static void sample_whole(const struct lx_plan *plan, const struct lx_planned_surface *surface, size_t s,
                         struct lx_shader_memory *memory, size_t start, const struct lx_asking *asking,
                         struct whole_highlight *whole)
{
    struct lx_sampler sampling = sampler_of(plan, surface, asking);
    double sum[LX_LANES];
    if (whole->is_tried)
        return;
    sampling.sources += s;
    sampling.source_count = 1;
    memcpy(sum, memory->sum + start, sizeof sum);
    whole->is_tried = true;
    whole->is_good = lx_sample_run(&sampling, memory->sampling, &memory->seen.block, &memory->seen.copy, start, sum);
    for (size_t i = 0; i < LX_LANES; i++)
        whole->added[i] = sum[i] - memory->sum[start + i];
}

/*
 * Adds the highlight of a source to a run of elements that see parts of it.  Where rules of few nodes are not for a
 * part, that of the whole source tells whether it matters: it is no less, and half of it does where it is small.
 */
static void light_by_seen_highlight(const struct lx_plan *plan, const struct lx_planned_surface *surface, size_t s,
                                    struct lx_shader_memory *memory, size_t start, size_t last,
                                    const struct lx_asking *asking)
{
    const double SMALL = 0.5; /* of the tolerance */
    const struct lx_planned_area_light *planned = &surface->area_lights[s];
    const struct lx_block_double *block = &memory->seen.block;
    struct lx_penumbra *penumbra = &memory->penumbra;
    struct whole_highlight whole = {.is_tried = false};
    lx_find_sight(plan, surface, planned, block, start, last, penumbra);
    if (memchr(penumbra->sight + start, LX_SEES_ALL, last - start))
        sample_whole(plan, surface, s, memory, start, asking, &whole);
    for (size_t i = start; i < last && lx_asking_goes_on(asking); i++) {
        const uint8_t sight = penumbra->sight[i];
        const double known = fmax(plan->least_maximum, memory->sum[i]);
        const struct lx_element element = element_of(surface, block, i);
        double partial_sum;
        if (sight == LX_SEES_NOTHING)
            continue;
        if (sight == LX_SEES_PART &&
            lx_partial_highlight_of_part(plan, surface, planned, &element, i, known, penumbra, asking, &partial_sum)) {
            memory->sum[i] += partial_sum;
            continue;
        }
        sample_whole(plan, surface, s, memory, start, asking, &whole);
        const double added = whole.added[i - start];
        if (whole.is_good && (sight == LX_SEES_ALL || added < SMALL * plan->tolerance * known)) {
            memory->sum[i] += sight == LX_SEES_ALL ? added : added / 2;
            continue;
        }
        memory->sum[i] += lx_highlight_of_part(plan, surface, planned, &element, i, known, penumbra, asking);
    }
}

/* Adds the highlights of the extended sources to a run of elements. */
static void light_by_highlights(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                struct lx_shader_memory *memory, size_t start, size_t count,
                                const struct lx_asking *asking)
{
    const struct lx_sampler sampling = sampler_of(plan, surface, asking);
    const size_t last = start + LX_LANES < count ? start + LX_LANES : count;
    double sum[LX_LANES];
    if (!sees_all(plan, surface, memory, start, last)) {
        for (size_t s = 0; s < surface->glossy_count; s++)
            light_by_seen_highlight(plan, surface, s, memory, start, last, asking);
        return;
    }
    memcpy(sum, memory->sum + start, sizeof sum);
    if (lx_sample_run(&sampling, memory->sampling, &memory->seen.block, &memory->seen.copy, start, sum)) {
        memcpy(memory->sum + start, sum, sizeof sum);
        return;
    }
    for (size_t i = start; i < last && lx_asking_goes_on(asking); i++) {
        double known = fmax(plan->least_maximum, memory->sum[i]);
        memory->sum[i] += integrate_glossy(plan, surface, known, &memory->seen.block, i, asking);
    }
}

/* Whether light of an area light may fall on an element: a part above its horizon, and of facets a face in front of
 * which it is. */
static bool may_light(const struct lx_area_light *lamp, const struct lx_block_double *block, size_t i)
{
    const double p[3] = {block->px[i] - lamp->center[0], block->py[i] - lamp->center[1],
                         block->pz[i] - lamp->center[2]};
    bool any = !lamp->facets;
    if (block->nx[i] * p[0] + block->ny[i] * p[1] + block->nz[i] * p[2] > lamp->radius_mm + lamp->touch_mm)
        return false;
    for (size_t f = 0; f < lamp->face_count && !any; f++) {
        const struct lx_area_light_face_double *face = &lamp->faces_double[f];
        const double height = face->normal[0] * p[0] + face->normal[1] * p[1] + face->normal[2] * p[2];
        any = height > face->height - lamp->touch_mm;
    }
    return any;
}

/* Adds the diffuse light of an area light by the reference, element by element. */
static void light_by_reference(const struct lx_planned_surface *surface, const struct lx_planned_area_light *planned,
                               struct lx_shader_memory *memory, size_t count, const struct lx_asking *asking)
{
    const struct lx_emitter *emitter = planned->emitter;
    for (size_t i = 0; i < count && lx_asking_goes_on(asking); i++) {
        if (!may_light(&planned->lamp, &memory->seen.block, i))
            continue;
        const struct lx_element element = element_of(surface, &memory->seen.block, i);
        if (lx_extended_touches(emitter, element.place_mm))
            continue;
        double irradiance = lx_extended_irradiance(emitter, element.place_mm, element.normal).value;
        memory->sum[i] += irradiance > 0 ? surface->lobe_exact.diffuse * irradiance : 0;
    }
}

/* Adds the diffuse light of an extended source that nothing hides. */
static void light_by_area_light(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                const struct lx_planned_area_light *planned, struct lx_shader_memory *memory,
                                size_t count, const struct lx_asking *asking)
{
    const struct lx_area_light *lamp = &planned->lamp;
    const double diffuse = surface->lobe_exact.diffuse;
    if (planned->emitter->attenuation != LX_INVERSE_SQUARE)
        light_by_law(plan, surface, planned, memory, count, asking);
    else if (planned->by_reference)
        light_by_reference(surface, planned, memory, count, asking);
    else if (lamp->edges_single)
        plan->kernels->facets_single(lamp, diffuse, &memory->seen.copy, count, asking, memory->sum);
    else
        plan->kernels->light_by_area_light[lamp->type](lamp, diffuse, &memory->seen.block, count, asking, memory->sum);
}

/* Adds the light of an area light that some elements see in part, or not at all. */
static void light_by_seen(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                          const struct lx_planned_area_light *planned, struct lx_shader_memory *memory, size_t count,
                          const struct lx_asking *asking)
{
    const struct lx_block_double *block = &memory->seen.block;
    double before[LX_BLOCK];
    if (lx_find_sight(plan, surface, planned, block, 0, count, &memory->penumbra)) {
        light_by_area_light(plan, surface, planned, memory, count, asking);
        return;
    }
    memcpy(before, memory->sum, lx_padded(count) * sizeof *before);
    if (memchr(memory->penumbra.sight, LX_SEES_ALL, count))
        light_by_area_light(plan, surface, planned, memory, count, asking);
    for (size_t i = 0; i < count && lx_asking_goes_on(asking); i++) {
        if (memory->penumbra.sight[i] == LX_SEES_ALL)
            continue;
        memory->sum[i] = before[i];
        const struct lx_element element = element_of(surface, block, i);
        if (memory->penumbra.sight[i] == LX_SEES_PART)
            memory->sum[i] += lx_diffuse_of_part(plan, surface, planned, &element, i, &memory->penumbra, asking);
    }
}

/* Adds the extended sources' light: first all that is diffuse, as the highlights need be exact only beside the rest. */
void lx_light_by_area_lights(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                             struct lx_shader_memory *memory, size_t count, const struct lx_asking *asking)
{
    const double diffuse = surface->lobe_exact.diffuse;
    for (size_t s = 0; s < surface->area_light_count && diffuse > 0; s++) {
        const struct lx_planned_area_light *planned = &surface->area_lights[s];
        if (!lx_is_chosen(memory->portion, surface->lights.count + s))
            continue;
        if (s % SHELLS_BETWEEN_CHECKS == SHELLS_BETWEEN_CHECKS - 1 && !lx_asking_goes_on(asking))
            return;
        if (planned->blocker_count > 0)
            light_by_seen(plan, surface, planned, memory, count, asking);
        else
            light_by_area_light(plan, surface, planned, memory, count, asking);
    }
    const bool has_highlights = surface->glossy_count > 0 && (!memory->portion || memory->portion->highlights);
    for (size_t start = 0; start < count && has_highlights; start += LX_LANES) {
        light_by_highlights(plan, surface, memory, start, count, asking);
        if (!lx_asking_goes_on(asking))
            return;
    }
}

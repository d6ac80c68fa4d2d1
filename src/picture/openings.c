/* SPDX-License-Identifier: MIT */
/*
 * Luminous openings in pictures.  They are no area lights: nothing of them has a closed form.  An element that sees all
 * of a flat one sums lines over it (opening_light.h); of other openings, of those that are hidden in part, in float64,
 * and for highlights that matter the reference's integrals are taken, to the picture's accuracy.
 */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "../world/integral/cubature.h"
#include "../world/integral/opening_light.h"
#include "area_light.h"
#include "openings.h"

/* ---- plan ---- */

luxel_status lx_plan_openings(struct lx_plan *plan, struct lx_control *control, struct lx_planned_surface *surface)
{
    const struct lx_asking asking = {.control = control, .is_caller = true};
    const struct lx_emitters *emitters = &plan->prepared->emitters;
    const size_t items = lx_item_count(emitters);
    size_t count = 0;
    for (size_t i = 0; i < items; i++)
        count += lx_is_opening(&emitters->items[i]);
    if (count == 0)
        return LUXEL_OK;
    surface->openings = lx_new_array(count, sizeof *surface->openings);
    if (!surface->openings)
        return LUXEL_ERROR_MEMORY;
    plan->has_openings = true;
    for (size_t i = 0; i < items; i++) {
        if (!lx_is_opening(&emitters->items[i]) || lx_is_set_in(surface, &emitters->items[i]))
            continue;
        struct lx_planned_area_light *planned = &surface->openings[surface->opening_count];
        planned->emitter = &emitters->items[i];
        const luxel_status status = lx_area_light_make(planned->emitter, &surface->shape, &asking, &planned->lamp);
        surface->opening_count++;
        if (status != LUXEL_OK)
            return status;
        if (lx_find_area_light_blockers(plan, surface, planned))
            return LUXEL_ERROR_MEMORY;
        if (!lx_asking_goes_on(&asking))
            return LUXEL_CANCELLED;
    }
    return LUXEL_OK;
}

void lx_openings_clear(struct lx_planned_surface *surface)
{
    for (size_t i = 0; i < surface->opening_count; i++) {
        lx_area_light_clear(&surface->openings[i].lamp);
        free(surface->openings[i].blockers);
    }
    free(surface->openings);
}

/* ---- elements ---- */

/* One element and what it is lit for. */
struct lit {
    const struct lx_plan *plan;
    const struct lx_planned_surface *surface;
    const struct lx_planned_area_light *planned;
    struct lx_element element;
    double place[3], normal[3], view[3];
    double known; /* the picture's maximum, or more that this element has */
    const struct lx_asking *asking;
};

static struct lit lit_of(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                         const struct lx_block_double *block, size_t i, const struct lx_asking *asking)
{
    const double *anchor = surface->shape.anchor_mm;
    struct lit lit = {.plan = plan,
                      .surface = surface,
                      .place = {anchor[0] + block->px[i], anchor[1] + block->py[i], anchor[2] + block->pz[i]},
                      .normal = {block->nx[i], block->ny[i], block->nz[i]},
                      .view = {block->vx[i], block->vy[i], block->vz[i]},
                      .asking = asking};
    lit.element = (struct lx_element){.place_mm = lx_exact3(lit.place),
                                      .normal = lx_exact3(lit.normal),
                                      .view = lx_exact3(lit.view),
                                      .lobe = &surface->lobe};
    return lit;
}

/* Tolerance of the diffuse light, relative to what is known; little is asked for while the maximum is looked for. */
static double matte_tolerance(const struct lx_plan *plan)
{
    if (plan->tolerance >= LX_ROUGH)
        return LX_ROUGH / 100;
    return plan->part_tolerance;
}

static double matte_by_reference(const struct lit *lit, struct lx_occlusion *occlusion)
{
    struct lx_lobe matte = lit->surface->lobe;
    struct lx_element element = lit->element;
    matte.specular = lx_exact(0);
    element.lobe = &matte;
    const double irradiance = lx_integrate(lit->planned->emitter, &element, occlusion, true, lit->known,
                                           matte_tolerance(lit->plan), lit->asking)
                                  .irradiance.value;
    return irradiance > 0 ? matte.diffuse.value * irradiance : 0;
}

static double matte_of_all(const struct lit *lit)
{
    const struct lx_emitter *emitter = lit->planned->emitter;
    const double diffuse = lit->surface->lobe_exact.diffuse, gain = diffuse * emitter->radiance.value;
    if (matte_tolerance(lit->plan) < LX_OPENING_TOLERANCE || !lx_opening_is_flat(emitter))
        return matte_by_reference(lit, NULL);
    size_t parts = 0;
    return gain *
           lx_opening_light(emitter, &lit->element, matte_tolerance(lit->plan), lit->known / gain, lit->asking, &parts)
               .value;
}

/* How great the highlight may be at most: all of the opening as a point at its nearest, where the lobe is greatest. */
static double most_of_highlight(const struct lit *lit)
{
    const struct lx_area_light *lamp = &lit->planned->lamp;
    const struct lx_lobe *lobe = &lit->surface->lobe;
    struct lx_lobe_at at;
    double towards[3];
    for (int k = 0; k < 3; k++)
        towards[k] = lamp->center[k] + lit->surface->shape.anchor_mm[k] - lit->place[k];
    const double distance = lx_normalize(towards), nearest = distance - lamp->radius_mm;
    if (!(nearest > 0))
        return HUGE_VAL;
    const double spread = asin(lamp->radius_mm / distance);
    lx_lobe_at_set(lit->normal, lit->view, &at);
    const double off = lx_power_lobe_of(lobe->model)->least_angle(&at, towards, spread);
    const double cosine = off > 0 ? fmax(cos(fmin(off, M_PI)), 0) : 1;
    const double law = 1 / (lamp->law.none + nearest * (lamp->law.root + nearest * lamp->law.square));
    return lamp->radiance * lx_extended_area_mm2(lit->planned->emitter).value * law * lobe->specular.value *
           pow(cosine, lobe->exponent);
}

static double highlight_of(const struct lit *lit, struct lx_occlusion *occlusion)
{
    static const double NEGLIGIBLE = 0.1; /* of the tolerance */
    const double tolerance = lit->plan->tolerance;
    if (!lx_lobe_shines(&lit->surface->lobe) || most_of_highlight(lit) < NEGLIGIBLE * tolerance * lit->known)
        return 0;
    const double specular =
        lx_integrate(lit->planned->emitter, &lit->element, occlusion, false, lit->known, tolerance / 2, lit->asking)
            .specular.value;
    return specular > 0 ? specular : 0;
}

static double light_of(const struct lit *lit, size_t i, struct lx_penumbra *penumbra)
{
    const uint8_t sight = penumbra->sight[i];
    if (sight == LX_SEES_NOTHING || lx_extended_touches(lit->planned->emitter, lit->element.place_mm))
        return 0;
    if (sight == LX_SEES_ALL)
        return (lit->surface->lobe_exact.diffuse > 0 ? matte_of_all(lit) : 0) + highlight_of(lit, NULL);
    lx_look_again(lit->plan, lit->surface, lit->planned, &lit->element, i, penumbra);
    if (penumbra->used->is_dark)
        return 0;
    return (lit->surface->lobe_exact.diffuse > 0 ? matte_by_reference(lit, penumbra->used) : 0) +
           highlight_of(lit, penumbra->used);
}

/* Whether any of the light may arrive: from above the horizon, and from the side that shines. */
static bool may_arrive(const struct lit *lit)
{
    const struct lx_area_light *lamp = &lit->planned->lamp;
    const bool looks_below = lx_lobe_reaches_below(&lit->surface->lobe);
    double away[3];
    for (int k = 0; k < 3; k++)
        away[k] = lit->place[k] - lamp->center[k] - lit->surface->shape.anchor_mm[k];
    if (!looks_below && lx_dot(lit->normal, away) > lamp->radius_mm + lamp->touch_mm)
        return false;
    if (lamp->is_disk)
        return lx_dot(lamp->axis, away) > -lamp->touch_mm;
    for (size_t f = 0; f < lamp->face_count; f++)
        if (lx_dot(lamp->faces_double[f].normal, away) > lamp->faces_double[f].height - lamp->touch_mm)
            return true;
    return !lamp->facets;
}

static bool may_arrive_at_any(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                              const struct lx_planned_area_light *planned, const struct lx_block_double *block,
                              size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct lit lit = lit_of(plan, surface, block, i, NULL);
        lit.planned = planned;
        if (may_arrive(&lit))
            return true;
    }
    return false;
}

void lx_light_by_openings(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                          struct lx_shader_memory *memory, size_t count, const struct lx_asking *asking)
{
    const struct lx_block_double *block = &memory->seen.block;
    for (size_t s = 0; s < surface->opening_count; s++) {
        const struct lx_planned_area_light *planned = &surface->openings[s];
        if (!may_arrive_at_any(plan, surface, planned, block, count))
            continue;
        lx_find_sight(plan, surface, planned, block, 0, count, &memory->penumbra);
        for (size_t i = 0; i < count; i++) {
            struct lit lit = lit_of(plan, surface, block, i, asking);
            lit.planned = planned;
            lit.known = fmax(plan->least_maximum, memory->sum[i]);
            if (!may_arrive(&lit))
                continue;
            memory->sum[i] += light_of(&lit, i, &memory->penumbra);
            if (!lx_asking_goes_on(asking))
                return;
        }
    }
}

/* SPDX-License-Identifier: MIT */
/* Which pixels see how much of a source, and the light of what they see in part. */
#include "penumbra.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "../world/among.h"
#include "../world/blocking.h"
#include "../world/integral/cubature.h"
#include "../world/visibility/boundary.h"
#include "partial_highlight.h"

/* Elements next to each other in whose way the same surfaces are looked for. */
enum { RUN = 16 };

/* More of what is in the way of an element is gathered again when it is needed, since a block has many elements. */
enum { MOST_KEPT = 600 };

void lx_penumbra_init(struct lx_penumbra *penumbra)
{
    penumbra->occlusion = (struct lx_occlusion){.place_mm = {0}};
    penumbra->source = NULL;
    penumbra->used = &penumbra->occlusion;
    penumbra->kept = NULL;
}

void lx_penumbra_clear(struct lx_penumbra *penumbra)
{
    for (size_t i = 0; penumbra->kept && i < LX_BLOCK; i++) {
        penumbra->kept[i].outline = NULL; /* they all use one */
        lx_occlusion_clear(&penumbra->kept[i]);
    }
    free(penumbra->kept);
    lx_occlusion_clear(&penumbra->occlusion);
}

/* ---- what may be in the way ---- */

/* Whether a flat shape has all of the shaft on one side of its plane, or in it. */
static bool is_beside_plane(const struct lx_shape *flat, const struct lx_shaft *shaft)
{
    double from[3], to[3];
    for (int k = 0; k < 3; k++) {
        from[k] = shaft->from_mm[k] - flat->anchor_mm[k];
        to[k] = shaft->to_mm[k] - flat->anchor_mm[k];
    }
    const double height = lx_dot(flat->axis, from), further = lx_dot(flat->axis, to);
    const double room = 1e-12 * (sqrt(lx_dot(from, from)) + sqrt(lx_dot(to, to)));
    const double least = fabs(height) - shaft->from_radius_mm - room;
    return least > 0 && (height > 0 ? further : -further) > shaft->to_radius_mm + room;
}

static bool may_stand_in(const struct lx_shape *shape, const struct lx_shaft *shaft)
{
    return lx_shaft_meets_ball(shaft, shape->anchor_mm, shape->radius_mm + 2 * shape->touch_mm) &&
           !(lx_shape_is_flat(shape) && is_beside_plane(shape, shaft));
}

/* From a ball, an offset from the surface's anchor. */
static struct lx_shaft shaft_from(const struct lx_planned_surface *surface, const struct lx_ball *ball,
                                  const struct lx_emitter *emitter)
{
    double place[3];
    for (int k = 0; k < 3; k++)
        place[k] = surface->shape.anchor_mm[k] + ball->center[k];
    return lx_shaft_to(place, ball->radius, emitter);
}

/* How far before a wall the place of a source is that is nearest to it, or farthest behind. */
static double lowest_before(const struct lx_shape *wall, const struct lx_emitter *emitter)
{
    double lowest;
    lx_emitter_extent(emitter, wall->anchor_mm, wall->axis, &lowest);
    return lowest;
}

/* Whether a surface and a source are both before a wall of a room, which then hides nothing. */
static bool are_before_wall(const struct lx_shape *wall, const struct lx_shape *lit, const struct lx_emitter *emitter)
{
    if (!(wall->behind_mm > 0))
        return false;
    const struct lx_origin on_wall = {.at = {wall->anchor_mm[0], wall->anchor_mm[1], wall->anchor_mm[2]}};
    return lx_are_before_wall(wall, lit, &on_wall) &&
           lowest_before(wall, emitter) > 2 * wall->touch_mm - wall->behind_mm;
}

int lx_find_area_light_blockers(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                struct lx_planned_area_light *planned)
{
    const struct lx_ball whole = {.radius = surface->shape.radius_mm};
    const struct lx_shaft shaft = shaft_from(surface, &whole, planned->emitter);
    size_t capacity = 0;
    struct lx_found found;
    const bool is_found = lx_among_shaft(plan->prepared, &shaft, &found);
    const size_t all = lx_found_count(&found, is_found, plan->surface_count);
    for (size_t i = 0; plan->prepared->shadows_extended && i < all; i++) {
        const uint32_t s = (uint32_t)lx_found_at(&found, is_found, i);
        const struct lx_shape *shape = &plan->surfaces[s].shape;
        if (!lx_may_hide(shape, &plan->surfaces[s] == surface) ||
            are_before_wall(shape, &surface->shape, planned->emitter) || !may_stand_in(shape, &shaft))
            continue;
        if (lx_reserve(&planned->blockers, &capacity, planned->blocker_count + 1, sizeof *planned->blockers))
            return -1;
        planned->blockers[planned->blocker_count++] = s;
    }
    return 0;
}

/* Those of many blockers that may stand in a shaft. */
static bool find_blockers(const struct lx_plan *plan, const struct lx_planned_area_light *planned,
                          const struct lx_shaft *shaft, struct lx_found *found)
{
    size_t kept = 0;
    if (planned->blocker_count <= LX_FEW_BOXES || !lx_among_shaft(plan->prepared, shaft, found))
        return false;
    for (size_t i = 0; i < found->count; i++)
        if (lx_is_among(planned->blockers, planned->blocker_count, found->items[i]))
            found->items[kept++] = found->items[i];
    found->count = kept;
    return true;
}

bool lx_area_light_may_be_hidden(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                 const struct lx_planned_area_light *planned, const struct lx_ball *ball)
{
    const struct lx_shaft shaft = shaft_from(surface, ball, planned->emitter);
    struct lx_found found;
    const bool is_found = find_blockers(plan, planned, &shaft, &found);
    const size_t count = lx_found_count(&found, is_found, planned->blocker_count);
    for (size_t b = 0; b < count; b++)
        if (may_stand_in(&plan->surfaces[is_found ? found.items[b] : planned->blockers[b]].shape, &shaft))
            return true;
    return false;
}

/* ---- what is in the way ---- */

/* The ball around some elements. */
static struct lx_ball ball_around(const struct lx_block_double *block, size_t first, size_t end)
{
    const double *all[3] = {block->px, block->py, block->pz};
    struct lx_ball ball;
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = first; i < end; i++) {
            low = fmin(low, all[k][i]);
            high = fmax(high, all[k][i]);
        }
        ball.center[k] = low + (high - low) / 2;
        square += (high - low) * (high - low) / 4;
    }
    ball.radius = sqrt(square) * (1 + 1e-12);
    return ball;
}

/* Whether highlights reach below the horizon. */
static bool looks_below(const struct lx_planned_surface *surface)
{
    return (surface->glossy_count > 0 || surface->opening_count > 0) && lx_lobe_reaches_below(&surface->lobe);
}

/* Gathers what is in the way of a single element. */
static enum lx_share_seen look(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                               const struct lx_planned_area_light *planned, const double place_mm[3],
                               const double normal[3], struct lx_occlusion *occlusion)
{
    const struct lx_emitter *emitter = planned->emitter;
    bool failed = false;
    lx_occlusion_begin(place_mm, looks_below(surface) ? NULL : normal, emitter, occlusion);
    struct lx_found found;
    const bool is_found = find_blockers(plan, planned, &occlusion->shaft, &found);
    const size_t count = lx_found_count(&found, is_found, planned->blocker_count);
    for (size_t b = 0; b < count && !failed; b++) {
        const struct lx_planned_surface *blocker = &plan->surfaces[is_found ? found.items[b] : planned->blockers[b]];
        failed = lx_occlusion_gather(&blocker->shape, blocker == surface, false, normal, occlusion) != 0;
    }
    if (failed || lx_occlusion_settle(emitter, 0, occlusion))
        return LX_SEES_NOTHING;
    if (!lx_is_occluded(occlusion))
        return LX_SEES_ALL;
    return lx_occlusion_hides_all(occlusion, emitter) ? LX_SEES_NOTHING : LX_SEES_PART;
}

static void place_of(const struct lx_planned_surface *surface, const struct lx_block_double *block, size_t i,
                     double place_mm[3])
{
    place_mm[0] = surface->shape.anchor_mm[0] + block->px[i];
    place_mm[1] = surface->shape.anchor_mm[1] + block->py[i];
    place_mm[2] = surface->shape.anchor_mm[2] + block->pz[i];
}

/* Whether what these elements of a block see of a source was asked for last. */
static bool is_known(const struct lx_penumbra *penumbra, const struct lx_planned_area_light *planned,
                     const double *const elements[6], size_t first, size_t end)
{
    bool known = penumbra->source == planned && penumbra->first <= first && penumbra->end >= end;
    for (int k = 0; k < 6 && known; k++)
        known = memcmp(penumbra->elements[k] + first, elements[k] + first, (end - first) * sizeof **elements) == 0;
    return known;
}

/* Keeps what was gathered for an element, and takes for the next one the memory of what was kept before. */
static void keep(struct lx_penumbra *penumbra, size_t i)
{
    const struct lx_occlusion gathered = penumbra->occlusion;
    const struct lx_obstacles *obstacles = &gathered.obstacles;
    if (!penumbra->kept)
        penumbra->kept = lx_new_array(LX_BLOCK, sizeof *penumbra->kept);
    penumbra->is_kept[i] =
        penumbra->kept &&
        obstacles->count + obstacles->edge_count + obstacles->sheet_count + obstacles->layered_count <= MOST_KEPT;
    if (!penumbra->is_kept[i])
        return;
    penumbra->occlusion = penumbra->kept[i];
    penumbra->occlusion.outline = gathered.outline;
    penumbra->kept[i] = gathered;
}

/* Looks at a run of elements. */
static void look_at_run(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                        const struct lx_planned_area_light *planned, const struct lx_block_double *block, size_t from,
                        size_t to, struct lx_penumbra *penumbra)
{
    const struct lx_ball ball = ball_around(block, from, to);
    if (!lx_area_light_may_be_hidden(plan, surface, planned, &ball))
        return;
    for (size_t i = from; i < to; i++) {
        double place[3];
        const double normal[3] = {block->nx[i], block->ny[i], block->nz[i]};
        place_of(surface, block, i, place);
        penumbra->sight[i] = (uint8_t)look(plan, surface, planned, place, normal, &penumbra->occlusion);
        if (penumbra->sight[i] == LX_SEES_PART)
            keep(penumbra, i);
    }
}

bool lx_find_sight(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                   const struct lx_planned_area_light *planned, const struct lx_block_double *block, size_t first,
                   size_t end, struct lx_penumbra *penumbra)
{
    const double *const elements[6] = {block->px, block->py, block->pz, block->nx, block->ny, block->nz};
    bool all = true;
    if (planned->blocker_count == 0) {
        memset(penumbra->sight + first, LX_SEES_ALL, end - first);
        penumbra->source = NULL;
        return true;
    }
    if (!is_known(penumbra, planned, elements, first, end)) {
        penumbra->source = planned;
        penumbra->first = first;
        penumbra->end = end;
        for (int k = 0; k < 6; k++)
            memcpy(penumbra->elements[k] + first, elements[k] + first, (end - first) * sizeof **elements);
        memset(penumbra->sight + first, LX_SEES_ALL, end - first);
        memset(penumbra->is_kept + first, 0, (end - first) * sizeof *penumbra->is_kept);
        for (size_t from = first; from < end; from += RUN)
            look_at_run(plan, surface, planned, block, from, end - from < RUN ? end : from + RUN, penumbra);
    }
    for (size_t i = first; i < end; i++)
        all = all && penumbra->sight[i] == LX_SEES_ALL;
    return all;
}

void lx_look_again(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                   const struct lx_planned_area_light *planned, const struct lx_element *element, size_t i,
                   struct lx_penumbra *penumbra)
{
    const double place[3] = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value};
    const double normal[3] = {element->normal.x.value, element->normal.y.value, element->normal.z.value};
    const bool is_kept = penumbra->source == planned && i >= penumbra->first && i < penumbra->end &&
                         penumbra->is_kept[i] && memcmp(penumbra->kept[i].place_mm, place, sizeof place) == 0;
    penumbra->used = is_kept ? &penumbra->kept[i] : &penumbra->occlusion;
    if (is_kept)
        penumbra->used->outline = penumbra->occlusion.outline;
    else
        look(plan, surface, planned, place, normal, &penumbra->occlusion);
}

static struct lx_partial_highlight partial_of(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                              const struct lx_planned_area_light *planned,
                                              const struct lx_element *element, const struct lx_penumbra *penumbra)
{
    return (struct lx_partial_highlight){
        .kernels = plan->kernels,
        .source = &surface->glossy[planned - surface->area_lights],
        .occlusion = penumbra->used,
        .lobe = &surface->glossy_exact,
        .lobe_single = &surface->glossy_single,
        .normal = {element->normal.x.value, element->normal.y.value, element->normal.z.value},
        .view = {element->view.x.value, element->view.y.value, element->view.z.value},
    };
}

/* The irradiance of what an element sees, for a radiance of 1, if it is known without an integral over arcs. */
static bool find_irradiance(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                            const struct lx_planned_area_light *planned, const struct lx_element *element,
                            const struct lx_penumbra *penumbra, double *irradiance)
{
    const struct lx_emitter *emitter = planned->emitter;
    const double normal[3] = {element->normal.x.value, element->normal.y.value, element->normal.z.value};
    if (emitter->attenuation == LX_INVERSE_SQUARE) {
        lx_bounded seen;
        if (!lx_boundary_irradiance(emitter, normal, penumbra->used, &seen))
            return false;
        *irradiance = seen.value;
        return true;
    }
    struct lx_partial_highlight partial = partial_of(plan, surface, planned, element, penumbra);
    partial.is_matte = true;
    return plan->precision != LUXEL_DOUBLE && lx_partial_highlight_sum(&partial, irradiance);
}

double lx_diffuse_of_part(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                          const struct lx_planned_area_light *planned, const struct lx_element *element, size_t i,
                          struct lx_penumbra *penumbra, const struct lx_asking *asking)
{
    struct lx_lobe matte = surface->lobe;
    struct lx_element bare = *element;
    matte.specular = lx_exact(0);
    bare.lobe = &matte;
    if (lx_extended_touches(planned->emitter, element->place_mm))
        return 0;
    lx_look_again(plan, surface, planned, element, i, penumbra);
    double seen;
    if (find_irradiance(plan, surface, planned, element, penumbra, &seen))
        return seen > 0 ? matte.diffuse.value * planned->emitter->radiance.value * seen : 0;
    if (penumbra->used->is_dark)
        return 0;
    const double irradiance =
        lx_integrate(planned->emitter, &bare, penumbra->used, true, plan->least_maximum, plan->part_tolerance, asking)
            .irradiance.value;
    return irradiance > 0 ? matte.diffuse.value * irradiance : 0;
}

bool lx_partial_highlight_of_part(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                  const struct lx_planned_area_light *planned, const struct lx_element *element,
                                  size_t i, double known, struct lx_penumbra *penumbra, const struct lx_asking *asking,
                                  double *highlight)
{
    if (plan->tolerance < LX_PARTIAL_HIGHLIGHT_TOLERANCE || lx_extended_touches(planned->emitter, element->place_mm))
        return false;
    lx_look_again(plan, surface, planned, element, i, penumbra);
    struct lx_partial_highlight partial = partial_of(plan, surface, planned, element, penumbra);
    partial.allowed = plan->tolerance / 2 * known;
    if (penumbra->used->has_outline ? !lx_partial_highlight_outline(&partial, asking, highlight)
                                    : !lx_partial_highlight_sum(&partial, highlight))
        return false;
    *highlight *= planned->emitter->radiance.value * surface->glossy_exact.specular;
    return true;
}

double lx_highlight_of_part(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                            const struct lx_planned_area_light *planned, const struct lx_element *element, size_t i,
                            double known, struct lx_penumbra *penumbra, const struct lx_asking *asking)
{
    if (lx_extended_touches(planned->emitter, element->place_mm))
        return 0;
    lx_look_again(plan, surface, planned, element, i, penumbra);
    const double specular =
        lx_integrate(planned->emitter, element, penumbra->used, false, known, plan->tolerance / 2, asking)
            .specular.value;
    return specular > 0 ? specular : 0;
}

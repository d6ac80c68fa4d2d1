/* SPDX-License-Identifier: MIT */
/* How much work a picture is: the times of docs/PERFORMANCE.md, of AVX-512 on a quick machine. */
#include "effort.h"

/* What a pixel takes in ns, everything that it shows but light. */
static const double ALONE_NS = 0.7, SURFACE_NS = 3;

/* A light at a pixel: in float32, in float64, where polynomials do for most pixels; and whether a surface hides it. */
static const double SINGLE_NS = 0.3, DOUBLE_NS = 0.8, SMOOTH_NS = 0.06, BLOCKER_NS = 1;

/* An extended source: an edge of an outline, a round one, a law without closed form, a highlight, where polynomials do
 * for most pixels a highlight, and by the reference; and a tree of clustered points. */
static const double EDGE_NS = 0.5, ROUND_NS = 2, LAW_NS = 20, INTEGRAL_NS = 50;
static const double HIGHLIGHT_NS = 5, REFERENCE_NS = 5000, TREE_NS = 50;

/* A side of a luminous opening. */
static const double OPENING_NS = 8000;

/* A source that surfaces may hide, of which one pixel in eight may see a part; and its highlight, or another law. */
static const double PENUMBRA_NS = 200, SEEN_NS = 800;

static double lights_ns(const struct lx_plan *plan, const struct lx_planned_surface *surface)
{
    double sum = 0;
    for (size_t r = 0; r < surface->run_count; r++) {
        const struct lx_light_run *run = &surface->runs[r];
        const double each = plan->in_panels ? SMOOTH_NS : run->in_double ? DOUBLE_NS : SINGLE_NS;
        sum += (double)run->count * (each + BLOCKER_NS * (double)run->blocker_count);
    }
    return sum;
}

static double area_lights_ns(const struct lx_plan *plan, const struct lx_planned_surface *surface)
{
    const double highlight = plan->in_panels ? HIGHLIGHT_NS : INTEGRAL_NS;
    double sum = LAW_NS * (double)surface->by_law_count + highlight * (double)surface->glossy_count;
    for (size_t s = 0; s < surface->area_light_count; s++) {
        const struct lx_planned_area_light *planned = &surface->area_lights[s];
        const bool is_summed = surface->glossy_count > 0 || planned->emitter->attenuation != LX_INVERSE_SQUARE;
        sum += planned->by_reference ? REFERENCE_NS : 0;
        sum += planned->blocker_count > 0 ? PENUMBRA_NS + (is_summed ? SEEN_NS : 0) : 0;
        sum += planned->lamp.facets ? EDGE_NS * (double)planned->lamp.edge_count : ROUND_NS;
    }
    sum += OPENING_NS * (double)surface->opening_count;
    return sum;
}

/* The most that one of the surfaces takes would be too much where another is seen: the mean of them. */
double lx_effort_of_pixel_ns(const struct lx_plan *plan)
{
    const double widest = 16;
    double light = TREE_NS * (double)plan->trees.tree_count;
    for (size_t s = 0; s < plan->surface_count; s++)
        light += (lights_ns(plan, &plan->surfaces[s]) + area_lights_ns(plan, &plan->surfaces[s])) /
                 (double)plan->surface_count;
    const double geometry = plan->alone ? ALONE_NS : SURFACE_NS * (double)plan->surface_count;
    return (geometry + light) * widest / plan->kernels->width;
}

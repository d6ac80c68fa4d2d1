/* SPDX-License-Identifier: MIT */
/* Whether a polynomial does for the highlights of extended sources over a square of pixels, and the polynomial. */
#include "smooth_gloss.h"

#include <math.h>

#include "../penumbra.h"
#include "../seen.h"
#include "../shader.h"

/*
 * The bases, all for one small ellipse, and how large highlights may be in it at most, of the picture's maximum: a lobe
 * that is as wide as the distance of nodes from each other is larger there by such a factor.  More nodes than one for
 * so many pixels do not pay.
 */
static const double REACH = 2;
#define MOST 1e16
static const struct {
    unsigned nodes;
    double most;
} BASES[LX_GLOSS_BASES] = {{8, 6}, {12, 1e3}, {16, MOST}};
enum { PIXELS_A_NODE = 3 };

/* Highlights in the dark are no larger than this, of the tolerance. */
static const double DARK = 0.02;

/* Error of highlights at nodes, a share of the tolerance: it grows by no more than the square of Lebesgue's constant,
 * below 7.7; and what the last terms of polynomials may come to. */
static const double AT_NODES = 0.1, LAST_TERMS = 0.05;

/* Share of the tolerance that parts which may not be analytic come to at most. */
static const double DOUBTFUL = 0.01;

void lx_gloss_bases_make(struct lx_basis bases[LX_GLOSS_BASES])
{
    for (int b = 0; b < LX_GLOSS_BASES; b++)
        lx_basis_make(BASES[b].nodes, REACH, &bases[b]);
}

/* A bound of the highlights of parts together, by such a lobe. */
static double bound_parts(const struct lx_plan *plan, struct lx_fitting *fitting, const struct lx_smooth_lights *parts,
                          const struct lx_lobe_double *lobe)
{
    double most = 0;
    plan->kernels->bound_smooth(&fitting->vicinity, parts, 0, parts->count, lobe, fitting->part_sizes);
    for (size_t i = 0; i < parts->count; i++)
        most += fabs(fitting->part_sizes[i]);
    return most;
}

/*
 * A bound of all highlights around a square, of the picture's maximum; infinite: they may not be smooth.  Where some
 * are gated or cut off within the square, or a face is seen edge-on, it is a bound of what they would be if they were
 * not: as functions that are bent there their last terms tell of that.
 */
static double bound_gloss(const struct lx_plan *plan, struct lx_fitting *fitting, const struct lx_square *square)
{
    const struct lx_planned_surface *surface = square->surface;
    const struct lx_smooth *smooth = &surface->smooth;
    struct lx_lobe_double lobe = surface->glossy_exact;
    if (!lx_find_vicinity(plan, square, &plan->gloss_bases[0], &fitting->vicinity))
        return HUGE_VAL;
    fitting->vicinity.slip = MOST / (DOUBTFUL * plan->tolerance);
    lx_round_lights_place(&smooth->round, &fitting->vicinity, &fitting->round);
    const double cut =
        bound_parts(plan, fitting, &smooth->parts, &lobe) + bound_parts(plan, fitting, &fitting->round, &lobe);
    if (cut <= MOST * plan->least_maximum)
        return cut / plan->least_maximum;
    lobe.highlight = LX_HIGHLIGHT_PLAIN;
    const double uncut =
        bound_parts(plan, fitting, &smooth->plain_parts, &lobe) + bound_parts(plan, fitting, &fitting->round, &lobe);
    return uncut / plan->least_maximum;
}

/* Samples highlights at nodes in tiles.  False: they are not as good as they should be. */
static bool sample_nodes(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                         struct lx_shader_memory *shader, size_t count, const struct lx_asking *asking, double *sums)
{
    const struct lx_seen *seen = lx_shader_seen(shader);
    const struct lx_sampler sampler = {
        .kernels = plan->kernels,
        .sources = surface->glossy,
        .source_count = surface->glossy_count,
        .lobe = &surface->glossy_exact,
        .lobe_single = &surface->glossy_single,
        .tolerance = AT_NODES * plan->tolerance,
        .least_maximum = plan->least_maximum,
        .least = lx_least_of(plan->precision),
        .most_cells = LX_MOST_CELLS,
        .asking = asking,
    };
    bool is_good = true;
    plan->kernels->set_all(sums, lx_padded(count), 0);
    for (size_t start = 0; start < count && is_good; start += LX_LANES)
        is_good = lx_sample_run(&sampler, lx_shader_sampling(shader), &seen->block, &seen->copy, start, sums + start);
    return is_good;
}

/* Sum of the terms of the two highest degrees on each axis, of the polynomial through values at nodes. */
static double last_terms(const struct lx_basis *basis, const double *values)
{
    const unsigned n = basis->nodes;
    double across[LX_MOST_NODES][LX_MOST_NODES], sum = 0; /* of each row, by degree */
    for (unsigned j = 0; j < n; j++)
        for (unsigned k = 0; k < n; k++) {
            across[j][k] = 0;
            for (unsigned i = 0; i < n; i++)
                across[j][k] += values[j * n + i] * basis->series[i][k];
        }
    for (unsigned l = 0; l < n; l++)
        for (unsigned k = l + 2 < n ? n - 2 : 0; k < n; k++) {
            double term = 0;
            for (unsigned j = 0; j < n; j++)
                term += across[j][k] * basis->series[j][l];
            sum += fabs(term);
        }
    return sum;
}

/* Whether something may hide a part of a source in the square that was bounded last. */
static bool may_be_hidden(const struct lx_plan *plan, const struct lx_fitting *fitting,
                          const struct lx_planned_surface *surface)
{
    const struct lx_ball part = lx_vicinity_ball(&fitting->vicinity);
    for (size_t s = 0; s < surface->area_light_count; s++)
        if (surface->area_lights[s].blocker_count > 0 &&
            lx_area_light_may_be_hidden(plan, surface, &surface->area_lights[s], &part))
            return true;
    return false;
}

enum lx_gloss lx_gloss_fit(const struct lx_plan *plan, struct lx_fitting *fitting, struct lx_shader_memory *shader,
                           const struct lx_square *square, const struct lx_asking *asking,
                           struct lx_polynomial *polynomial)
{
    const double most = bound_gloss(plan, fitting, square);
    _Alignas(64) double sums[LX_BLOCK], values[LX_BLOCK];
    int b = 0;
    if (most <= DARK * plan->tolerance)
        return LX_GLOSS_DARK;
    if (may_be_hidden(plan, fitting, square->surface))
        return LX_GLOSS_ROUGH;
    while (b < LX_GLOSS_BASES && !(most <= BASES[b].most))
        b++;
    if (b == LX_GLOSS_BASES || BASES[b].nodes * BASES[b].nodes * PIXELS_A_NODE > square->side * square->side)
        return LX_GLOSS_ROUGH;
    const struct lx_basis *basis = &plan->gloss_bases[b];
    const unsigned n = basis->nodes;
    lx_gather_nodes(plan, lx_shader_seen(shader), square, basis, true);
    if (!sample_nodes(plan, square->surface, shader, (size_t)n * n, asking, sums))
        return LX_GLOSS_ROUGH;
    for (unsigned j = 0; j < n; j++)
        for (unsigned i = 0; i < n; i++)
            values[j * n + i] = sums[lx_node_in_tiles(n, i, j)];
    if (!(last_terms(basis, values) <= LAST_TERMS * plan->tolerance * plan->least_maximum))
        return LX_GLOSS_ROUGH;
    polynomial->side = square->side;
    polynomial->power = 1;
    plan->kernels->find_polynomial(basis->series, n, values, polynomial);
    return LX_GLOSS_SMOOTH;
}

/* SPDX-License-Identifier: MIT */
/* Sampling direct light, window by window. */
#include "direct.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

/* No beam is followed further down. */
enum { DEEPEST = 14 };
/* The effort of each point or arc of a source that is looked at, and of each source anyway. */
enum { PART_EFFORT = 10, EMITTER_EFFORT = 4 };
/* Differences of the last samples tell about how far off they are, and no more: so many times as much counts. */
static const double SAFETY = 2;
/* Quarters that stay are this much nearer to the light than the polynomials that they are beside. */
static const double KEPT = 1.0 / 16;

/* The effort of this many outlines that are looked at. */
enum { OUTLINES_EACH = 4 };

double lx_direct_open_flux(const struct lx_sampling_direct *sampling, const struct lx_asking *asking,
                           const struct lx_tile_cell *cell)
{
    const struct lx_world open = {.prepared = sampling->open, .kernels = sampling->world.kernels};
    struct lx_elements elements;
    struct lx_received received;
    lx_elements_begin(&elements, &sampling->lobe, true);
    lx_elements_append_place(&elements, lx_exact3(cell->center_mm), lx_exact3(cell->normal[0]), NULL);
    lx_elements_end(&elements);
    lx_world_settle(&open, &(struct lx_settling){.has_normals = false}, &elements);
    lx_world_light(&open, &elements, LX_WANT_IRRADIANCE, asking, &received);
    lx_effort_take(asking->effort, EMITTER_EFFORT * open.prepared->emitters.count);
    return received.on_element[0] ? 0 : lx_cell_area(cell) * received.irradiance.value[0];
}

/* Direct irradiance at the nodes of a cell; *error is that of its integral.  0, or -1 where the work is to stop. */
static int sample_cell(const struct lx_sampling_direct *sampling, const struct lx_tile_cell *cell,
                       const struct lx_asking *asking, double irradiance[LX_RULE_NODES], double *error)
{
    struct lx_elements elements;
    struct lx_received received;
    *error = 0;
    lx_elements_begin(&elements, &sampling->lobe, true);
    for (int i = 0; i < LX_RULE_NODES; i++)
        lx_elements_append_place(&elements, lx_exact3(cell->place_mm[i]), lx_exact3(cell->normal[i]), NULL);
    lx_elements_end(&elements);
    lx_world_settle(&sampling->world, &(struct lx_settling){.has_normals = false}, &elements);
    lx_world_light(&sampling->world, &elements, LX_WANT_IRRADIANCE, asking, &received);
    size_t parts = 0;
    for (int i = 0; i < LX_RULE_NODES; i++)
        parts += (size_t)received.parts[i];
    lx_effort_take(asking->effort, PART_EFFORT * parts + EMITTER_EFFORT * sampling->world.prepared->emitters.count);
    for (int i = 0; i < LX_RULE_NODES; i++) {
        irradiance[i] = received.on_element[i] ? 0 : received.irradiance.value[i];
        *error += received.on_element[i] ? 0 : cell->area[i] * received.irradiance.error[i];
    }
    return lx_asking_goes_on(asking) ? 0 : -1;
}

/* The polynomial of a window at the nodes of its quarter i. */
static void foresee(const double nodes[LX_RULE_NODES], int i, double at[LX_RULE_NODES])
{
    for (int q = 0; q < LX_RULE_NODES; q++)
        at[q] = lx_rule_value(nodes, (lx_rule_places[q / LX_ORDER] + (i & 1 ? 1 : -1)) / 2,
                              (lx_rule_places[q % LX_ORDER] + (i & 2 ? 1 : -1)) / 2);
}

/* Coefficients that have the integrals of a quarter's light with the polynomials of the window are added. */
static void lift(const double quarter[LX_RULE_NODES], const double quarter_area[LX_RULE_NODES], int i,
                 double moments[LX_RULE_NODES])
{
    for (int q = 0; q < LX_RULE_NODES; q++) {
        double across[LX_ORDER], upward[LX_ORDER];
        lx_rule_basis((lx_rule_places[q / LX_ORDER] + (i & 1 ? 1 : -1)) / 2, across);
        lx_rule_basis((lx_rule_places[q % LX_ORDER] + (i & 2 ? 1 : -1)) / 2, upward);
        for (int k = 0; k < LX_RULE_NODES; k++)
            moments[k] += quarter[q] * quarter_area[q] * across[k / LX_ORDER] * upward[k % LX_ORDER];
    }
}

/* What goes down the tree. */
struct descent {
    const struct lx_sampling_direct *sampling;
    const struct lx_matte_face *face;
    const struct lx_asking *asking;
    double squares; /* of the errors of leaves' fluxes */
    double errors;  /* of the samples, in the same */
    struct lx_tile *tile;
    struct lx_near *near; /* places that it is near to */
    size_t near_count;
};

/* The node of a tile that stands for where a window is. */
static int node_around(const struct lx_window *tile, const struct lx_window *window)
{
    int at[2];
    for (int k = 0; k < 2; k++) {
        const double x = (window->middle[k] - tile->middle[k]) / tile->half[k];
        at[k] = (x > -LX_RULE_INNER_WEIGHT) + (x > 0) + (x > LX_RULE_INNER_WEIGHT);
    }
    return LX_ORDER * at[0] + at[1];
}

/* Fluxes that the samples of a cell are off by, as geometry tells. */
struct missed {
    double shadows; /* at outlines, */
    double open;    /* of light that would be so bright there if nothing hid it, where that is asked; */
    struct lx_beside beside;
    bool counts; /* so much that it is to be looked at more closely */
};

/* Adds what is left at outlines and folds; at jumps the nodes have now too much light, now too little. */
static void leave(struct descent *descent, const struct lx_window *window, const struct missed *missed)
{
    const double jumps = SAFETY * missed->beside.jumps;
    descent->squares += jumps * jumps;
    descent->tile->local_error[node_around(&descent->tile->window, window)] += missed->shadows + missed->beside.bends;
}

/* Samples of a quarter beside the polynomial of the window. */
struct change {
    double off, difference; /* in flux: all that is off, and what it comes to */
    double error;           /* of the samples */
};

static struct change quarter_change(const double foreseen[LX_RULE_NODES], const double nodes[LX_RULE_NODES],
                                    const struct lx_tile_cell *cell, double error)
{
    struct change change = {.error = error};
    for (int q = 0; q < LX_RULE_NODES; q++) {
        const double at = (nodes[q] - foreseen[q]) * cell->area[q];
        change.off += fabs(at);
        change.difference += at;
    }
    return change;
}

static void add_change(struct change *sum, const struct change *change)
{
    sum->off += change->off;
    sum->difference += change->difference;
    sum->error += change->error;
}

static double squares_of(const struct change *change)
{
    return SAFETY * SAFETY * (change->difference * change->difference + 1e-4 * change->off * change->off);
}

/* Where it ends, what the last samples tell is the error. */
static void end_at(struct descent *descent, const struct change *change)
{
    descent->squares += squares_of(change);
    descent->errors += change->error;
}

/* The doubt of a quarter, with its nodes by samples and by the polynomial around it; the samples are nearer to the
 * light than that, so that only a share of the difference counts where they stay. */
static struct lx_doubt doubt_of(const struct change *change, double share, const struct missed *missed,
                                const struct lx_tile_cell *cell, const double nodes[LX_RULE_NODES],
                                const double foreseen[LX_RULE_NODES])
{
    const double jumps = SAFETY * missed->beside.jumps;
    struct lx_doubt doubt = {.off = share * change->off,
                             .reach = share * change->off * cell->radius_mm,
                             .left = missed->shadows + missed->beside.bends + change->error,
                             .squares = squares_of(change) + jumps * jumps};
    for (int q = 0; q < LX_RULE_NODES; q++)
        doubt.greatest = fmax(doubt.greatest, SAFETY * fmax(fabs(nodes[q]), fabs(foreseen[q])));
    doubt.greatest = fmax(doubt.greatest, missed->open);
    return doubt;
}

/* Finds the outlines on a cell, of those on a larger one, and puts what its samples are off by there right as far as
 * that is known; returns the flux that is left. */
static double find_crossings(const struct descent *descent, const struct lx_tile_cell *cell,
                             const struct lx_crossings *larger, struct lx_crossings *found, double nodes[LX_RULE_NODES],
                             double *open)
{
    const struct lx_sampling_direct *sampling = descent->sampling;
    lx_crossings_find(&sampling->outlines, descent->face, cell, larger, found);
    lx_effort_take(descent->asking->effort, (larger ? larger->count : sampling->outlines.count) / OUTLINES_EACH);
    for (int q = 0; q < LX_RULE_NODES; q++)
        nodes[q] += found->correction[q];
    *open = found->share > 0 ? lx_direct_open_flux(sampling, descent->asking, cell) / lx_cell_area(cell) : 0;
    return (found->irradiance + found->share * *open) * lx_cell_area(cell);
}

static struct missed find_missed(const struct descent *descent, const struct lx_tile_cell *cell,
                                 const struct lx_crossings *larger, struct lx_crossings *found,
                                 double nodes[LX_RULE_NODES])
{
    const struct lx_sampling_direct *sampling = descent->sampling;
    struct missed missed = {0};
    missed.shadows = find_crossings(descent, cell, larger, found, nodes, &missed.open);
    const bool is_plain = sampling->outlines.count > 0 && found->count == 0;
    missed.beside =
        lx_folds_beside(&sampling->folds, cell, is_plain ? sampling->world.prepared : NULL, descent->face->surface);
    lx_effort_take(descent->asking->effort, sampling->folds.count);
    missed.counts =
        missed.shadows > sampling->narrow_flux || missed.beside.jumps + missed.beside.bends > sampling->fold_flux;
    return missed;
}

/*
 * Goes on from a window whose light at the nodes is known, to its quarters; they stay where they tell something.  What
 * they tell is followed down to level `most`, and so many levels further below a beam.
 */
static int look_closer(struct descent *descent, const struct lx_window *window, const struct lx_tile_cell *cell,
                       const struct lx_crossings *crossings, int level, int most, struct lx_direct *direct)
{
    const struct lx_sampling_direct *sampling = descent->sampling;
    struct lx_direct *quarters = lx_new_array(4, sizeof *quarters);
    struct lx_tile_cell *cells = lx_new_array(4, sizeof *cells);
    uint32_t *room = lx_new_array(4 * crossings->count, sizeof *room);
    struct lx_crossings on[4];
    struct change changes[4] = {{0}}, all = {0};
    struct missed missed[4] = {{0}};
    double moments[LX_RULE_NODES] = {0}, foreseen[4][LX_RULE_NODES];
    bool is_narrow[4] = {false};
    int failed = quarters && cells && room ? 0 : -1, narrow = 0;
    for (int i = 0; i < 4 && !failed; i++) {
        const struct lx_window quarter = lx_window_quarter(window, i);
        double error;
        lx_cell_make(descent->face, &quarter, &cells[i]);
        failed = sample_cell(sampling, &cells[i], descent->asking, quarters[i].nodes, &error);
        on[i].items = room + (size_t)i * crossings->count;
        missed[i] = find_missed(descent, &cells[i], crossings, &on[i], quarters[i].nodes);
        foresee(direct->nodes, i, foreseen[i]);
        changes[i] = quarter_change(foreseen[i], quarters[i].nodes, &cells[i], error);
        add_change(&all, &changes[i]);
        quarters[i].doubt = doubt_of(&changes[i], KEPT, &missed[i], &cells[i], quarters[i].nodes, foreseen[i]);
        is_narrow[i] = level < DEEPEST && (lx_beams_narrow(&sampling->beams, &cells[i]) || missed[i].counts ||
                                           lx_near_counts(descent->near, descent->near_count, descent->face, &cells[i],
                                                          &quarters[i].doubt));
        narrow += is_narrow[i];
    }
    direct->quarters = quarters;
    const bool tells = all.off > sampling->least_flux && level < most;
    if (!tells && narrow == 0)
        end_at(descent, &all);
    for (int i = 0; i < 4 && !failed; i++) {
        const struct lx_window quarter = lx_window_quarter(window, i);
        const int further = is_narrow[i] ? level + 1 + sampling->most_levels : most;
        if (tells || is_narrow[i]) {
            failed = look_closer(descent, &quarter, &cells[i], &on[i], level + 1, further > most ? further : most,
                                 &quarters[i]);
            continue;
        }
        if (narrow > 0)
            end_at(descent, &changes[i]);
        leave(descent, &quarter, &missed[i]);
        if (narrow == 0)
            quarters[i].doubt = doubt_of(&changes[i], 1, &missed[i], &cells[i], quarters[i].nodes, foreseen[i]);
    }
    direct->doubt = (struct lx_doubt){0};
    for (int i = 0; i < 4 && !failed; i++)
        lx_doubt_add(&direct->doubt, &quarters[i].doubt);
    for (int i = 0; i < 4 && !failed; i++)
        lift(quarters[i].nodes, cells[i].area, i, moments);
    for (int q = 0; q < LX_RULE_NODES && !failed; q++)
        direct->nodes[q] = moments[q] / cell->area[q];
    free(room);
    free(cells);
    if ((!tells && narrow == 0) || failed)
        lx_direct_clear(direct);
    return failed;
}

int lx_direct_sample(const struct lx_sampling_direct *sampling, const struct lx_matte_face *face,
                     const struct lx_asking *asking, struct lx_tile *tile)
{
    struct descent descent = {.sampling = sampling, .face = face, .asking = asking, .tile = tile};
    struct lx_crossings crossings = {.items = lx_new_array(sampling->outlines.count, sizeof *crossings.items)};
    double error;
    lx_direct_clear(&tile->direct);
    memset(tile->local_error, 0, sizeof tile->local_error);
    descent.near = lx_new_array(sampling->near_count, sizeof *descent.near);
    if (descent.near)
        descent.near_count = lx_near_find(sampling->near, sampling->near_count, face, &tile->cell, descent.near);
    int failed = !crossings.items || !descent.near ? -1 : 0;
    failed = failed || sample_cell(sampling, &tile->cell, asking, tile->direct.nodes, &error) ? -1 : 0;
    if (!failed) {
        const struct missed missed = find_missed(&descent, &tile->cell, NULL, &crossings, tile->direct.nodes);
        if (isfinite(sampling->least_flux) || lx_beams_narrow(&sampling->beams, &tile->cell) || missed.counts)
            failed =
                look_closer(&descent, &tile->window, &tile->cell, &crossings, 0, sampling->most_levels, &tile->direct);
        else
            leave(&descent, &tile->window, &missed);
    }
    for (int q = 0; q < LX_RULE_NODES; q++)
        descent.errors += tile->local_error[q];
    tile->direct_error = (sqrt(descent.squares) + descent.errors) / lx_tile_area(tile);
    free(crossings.items);
    free(descent.near);
    return failed;
}

void lx_direct_clear(struct lx_direct *direct)
{
    for (int i = 0; direct->quarters && i < 4; i++)
        lx_direct_clear(&direct->quarters[i]);
    free(direct->quarters);
    direct->quarters = NULL;
}

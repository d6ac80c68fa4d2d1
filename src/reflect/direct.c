/* SPDX-License-Identifier: MIT */
/* Sampling direct light, window by window. */
#include "direct.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

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
    lx_world_all_light(&sampling->world, &elements, LX_WANT_IRRADIANCE, asking, &received);
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
};

static int look_closer(struct descent *descent, const struct lx_window *window, const struct lx_tile_cell *cell,
                       int level, struct lx_direct *direct);

/* The quarters of a window, whose light is at its nodes; they stay where they tell something. */
static int make_quarters(struct descent *descent, const struct lx_window *window, const struct lx_tile_cell *cell,
                         int level, struct lx_direct *direct)
{
    const struct lx_sampling_direct *sampling = descent->sampling;
    struct lx_direct *quarters = lx_new_array(4, sizeof *quarters);
    struct lx_tile_cell *cells = lx_new_array(4, sizeof *cells);
    double off = 0, difference = 0, errors = 0, moments[LX_RULE_NODES] = {0};
    int failed = quarters && cells ? 0 : -1;
    for (int i = 0; i < 4 && !failed; i++) {
        const struct lx_window quarter = lx_window_quarter(window, i);
        double foreseen[LX_RULE_NODES], error;
        lx_cell_make(descent->face, &quarter, &cells[i]);
        failed = sample_cell(sampling, &cells[i], descent->asking, quarters[i].nodes, &error);
        errors += error;
        foresee(direct->nodes, i, foreseen);
        for (int q = 0; q < LX_RULE_NODES; q++) {
            const double change = (quarters[i].nodes[q] - foreseen[q]) * cells[i].area[q];
            off += fabs(change);
            difference += change;
        }
    }
    direct->quarters = quarters;
    const bool tells = off > sampling->least_flux && level < sampling->most_levels;
    if (!tells) {
        descent->squares += difference * difference + 1e-4 * off * off;
        descent->errors += errors;
    }
    for (int i = 0; i < 4 && !failed && tells; i++) {
        const struct lx_window quarter = lx_window_quarter(window, i);
        failed = look_closer(descent, &quarter, &cells[i], level + 1, &quarters[i]);
    }
    for (int i = 0; i < 4 && !failed; i++)
        lift(quarters[i].nodes, cells[i].area, i, moments);
    for (int q = 0; q < LX_RULE_NODES && !failed; q++)
        direct->nodes[q] = moments[q] / cell->area[q];
    free(cells);
    if (!tells || failed) {
        lx_direct_clear(direct);
    }
    return failed;
}

/* Goes on from a window whose light at the nodes is known. */
static int look_closer(struct descent *descent, const struct lx_window *window, const struct lx_tile_cell *cell,
                       int level, struct lx_direct *direct)
{
    return make_quarters(descent, window, cell, level, direct);
}

int lx_direct_sample(const struct lx_sampling_direct *sampling, const struct lx_matte_face *face,
                     const struct lx_asking *asking, struct lx_tile *tile)
{
    struct descent descent = {.sampling = sampling, .face = face, .asking = asking};
    double area = 0, error;
    if (sample_cell(sampling, &tile->cell, asking, tile->direct.nodes, &error))
        return -1;
    if (sampling->least_flux > 0 && look_closer(&descent, &tile->window, &tile->cell, 0, &tile->direct))
        return -1;
    for (int q = 0; q < LX_RULE_NODES; q++)
        area += tile->cell.area[q];
    tile->direct_error = (sqrt(descent.squares) + descent.errors) / area;
    return 0;
}

void lx_direct_clear(struct lx_direct *direct)
{
    for (int i = 0; direct->quarters && i < 4; i++)
        lx_direct_clear(&direct->quarters[i]);
    free(direct->quarters);
    direct->quarters = NULL;
}

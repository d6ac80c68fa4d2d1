/* SPDX-License-Identifier: MIT */
/*
 * Sums over tiles: the mean irradiance of each side of the surfaces, and the balance of the flux, which tells where the
 * light that arrives at them stays.
 *
 * A place absorbs the share 1 - rho of what falls on it, E; of the rest the share F, the integral of the kernel over
 * all faces, arrives at faces, and 1 - F escapes.  As the kernel is the same in both directions the integral of
 * rho E F is that of E_r.  Here both come from sums of different kinds, at the nodes that send and at the nodes that
 * receive; so what they differ by is a check of the solution.
 */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "between.h"
#include "links.h"
#include "reflected.h"
#include "solution.h"

/* ---- one tile ---- */

/* Integrals over a tile, in mm^2. */
struct tile_sum {
    double area, direct, irradiance, pending;
    double leaves;                                        /* rho E (1 - F), of what is reflected */
    double direct_error, error, before_error, seen_error; /* of direct light, all, what is reflected, F rho E */
};

static struct tile_sum sum_tile(const struct lx_radiosity *reflected, size_t t)
{
    const struct lx_tile *tile = &reflected->tiles[t];
    const double reflectance = reflected->faces[tile->face].reflectance;
    struct tile_sum sum = {0};
    double brightest = 0;
    for (int q = 0; q < LX_RULE_NODES; q++) {
        const size_t i = t * LX_RULE_NODES + (size_t)q;
        const double area = tile->cell.area[q], direct = tile->direct.nodes[q];
        const double sent = reflectance * (direct + reflected->before[i]);
        sum.area += area;
        sum.direct += area * direct;
        sum.irradiance += area * (direct + reflected->indirect[i]);
        sum.pending += area * reflectance * (reflected->indirect[i] - reflected->before[i]);
        sum.leaves += area * sent * (1 - reflected->seen[i]);
        sum.error += area * reflected->slack[i];
        sum.before_error += area * reflected->slack_before[i];
        brightest = fmax(brightest, fabs(sent));
    }
    sum.direct_error = sum.area * lx_tile_unsure(tile);
    sum.error += sum.direct_error;
    sum.before_error += sum.direct_error;
    sum.seen_error = sum.area * brightest * tile->seen_error;
    return sum;
}

/* ---- the balance ---- */

static void add(lx_bounded *sum, double value, double error)
{
    const double mm2 = 1e-6; /* in m^2 */
    sum->value += mm2 * value;
    sum->error += mm2 * error;
}

/* Errors of what is sent count with rho, whether it escapes or not. */
struct lx_light_balance lx_reflected_balance(const struct lx_radiosity *reflected)
{
    struct lx_light_balance balance = {0};
    for (size_t t = 0; t < reflected->tile_count; t++) {
        const struct tile_sum sum = sum_tile(reflected, t);
        const double reflectance = reflected->faces[reflected->tiles[t].face].reflectance;
        const double sent_error = reflectance * sum.before_error + sum.seen_error;
        const double absorbed = (1 - reflectance) * sum.irradiance;
        add(&balance.arrives, sum.direct, sum.direct_error);
        add(&balance.absorbed, absorbed, (1 - reflectance) * sum.error);
        add(&balance.escaped, sum.leaves, sent_error);
        if (reflected->bounces > 0)
            add(&balance.pending, sum.pending, reflectance * (sum.error + sum.before_error));
        add(&balance.difference, absorbed + sum.leaves + sum.pending - sum.direct,
            sum.error - sum.direct_error + sent_error);
    }
    return balance;
}

/* ---- sides ---- */

size_t lx_reflected_most_sides(const struct lx_radiosity *reflected)
{
    return reflected->face_count;
}

/* The side of face f is the last one of a list, or a new one of it. */
static struct lx_lit_side *side_of(const struct lx_matte_face *face, struct lx_lit_side *sides, size_t *count)
{
    const bool is_back = face->sheet.turn < 0;
    if (*count == 0 || sides[*count - 1].surface != face->surface || sides[*count - 1].is_back != is_back)
        sides[(*count)++] = (struct lx_lit_side){
            .surface = face->surface, .is_flat = face->is_flat, .is_back = is_back, .reflectance = face->reflectance};
    return &sides[*count - 1];
}

size_t lx_reflected_sides(const struct lx_radiosity *reflected, struct lx_lit_side *sides)
{
    size_t count = 0, kept = 0;
    for (size_t f = 0; f < reflected->face_count; f++) {
        struct lx_lit_side *side = side_of(&reflected->faces[f], sides, &count);
        for (size_t t = reflected->first_tile[f]; t < reflected->first_tile[f + 1]; t++) {
            const struct tile_sum sum = sum_tile(reflected, t);
            side->area_m2 += 1e-6 * sum.area;
            add(&side->direct, sum.direct, sum.direct_error);
            add(&side->irradiance, sum.irradiance, sum.error);
        }
    }
    for (size_t s = 0; s < count; s++) {
        struct lx_lit_side *side = &sides[s];
        side->direct = (lx_bounded){side->direct.value / side->area_m2, side->direct.error / side->area_m2};
        side->irradiance = (lx_bounded){side->irradiance.value / side->area_m2, side->irradiance.error / side->area_m2};
        if (side->irradiance.value > 0 || side->irradiance.error > 0)
            sides[kept++] = *side;
    }
    return kept;
}

/* ---- refinement ---- */

/* The greatest error of a mean, as a share of the greatest mean. */
double lx_means_error(const struct lx_radiosity *reflected)
{
    struct lx_lit_side *sides = lx_new_array(reflected->face_count + 1, sizeof *sides);
    const size_t count = sides ? lx_reflected_sides(reflected, sides) : 0;
    double error = 0, greatest = 0;
    for (size_t s = 0; s < count; s++) {
        error = fmax(error, sides[s].irradiance.error);
        greatest = fmax(greatest, sides[s].irradiance.value);
    }
    if (!sides)
        return HUGE_VAL;
    free(sides);
    return error > 0 ? error / greatest : 0;
}

/* Each tile counts by what it sends on, and by what it adds to its own side. */
int lx_means_cut(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool *cuts)
{
    const size_t count = reflected->tile_count;
    double *scores = lx_new_array(count, sizeof *scores);
    (void)request;
    for (size_t t = 0; scores && t < count; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        scores[t] = (0.1 + reflected->faces[tile->face].reflectance) * lx_tile_area(tile) *
                    (lx_between_change(tile->residual) + tile->direct_error);
    }
    const int any = scores ? lx_cut_greatest(reflected, scores, (reflected->most_tiles - count) * 2 / 3 + 1, cuts) : -1;
    free(scores);
    return any;
}

/* SPDX-License-Identifier: MIT */
/* Counting effort block by block, and what stands for what it does not reach. */
#include "within.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "links.h"
#include "occluder_cone.h"

/* ---- effort ---- */

/* Pieces between which it is counted, and the share of all effort that each may take at most. */
enum { AT_ONCE = 64, SHARE_OF_ONE = 48 };

/* The share of what was left to do that a solution is taken for. */
static const double SOLVING = 0.95;

void lx_within_tell(const struct lx_radiosity *reflected, double done)
{
    reflected->control->before = reflected->begun + SOLVING * (1 - reflected->begun) * fmin(done, 1);
}

bool lx_within_goes_on(const struct lx_radiosity *reflected)
{
    struct lx_control *control = reflected->control;
    return lx_control_goes_on(control, true) && !(control->patience && atomic_load(&control->patience->is_over));
}

luxel_status lx_within_run(struct lx_radiosity *reflected, const struct lx_within *within)
{
    struct lx_effort *all = &reflected->effort;
    const struct lx_patience *patience = reflected->control->patience;
    const atomic_bool *over = patience ? &patience->is_over : NULL;
    const size_t left = all->most > all->done ? all->most - all->done : 0;
    const size_t limit = all->done + (size_t)(within->share * (double)left), most = all->most / SHARE_OF_ONE;
    if (lx_reserve(&reflected->efforts, &reflected->effort_capacity, within->count, sizeof *reflected->efforts))
        return LUXEL_ERROR_MEMORY;
    for (size_t first = 0; first < within->count; first += AT_ONCE) {
        const size_t last = within->count - first < AT_ONCE ? within->count : first + AT_ONCE;
        for (size_t i = first; i < last; i++)
            reflected->efforts[i] = (struct lx_effort){.most = all->done < limit ? most : 0, .over = over};
        const struct lx_rows_part part = {.first = (unsigned)first,
                                          .last = (unsigned)last,
                                          .tile_rows = 1,
                                          .counts_itself = true,
                                          .work = within->work,
                                          .data = within->data};
        if (!lx_rows_run_part(reflected->control, reflected->threads, &part))
            return LUXEL_CANCELLED;
        for (size_t i = first; i < last; i++)
            all->done += reflected->efforts[i].done;
        lx_within_tell(reflected, (double)all->done / (double)all->most);
    }
    return LUXEL_OK;
}

struct ranked {
    double area;
    size_t tile;
};

static int by_area(const void *a, const void *b)
{
    const struct ranked *x = a, *y = b;
    return x->area != y->area ? (x->area < y->area ? 1 : -1) : (x->tile > y->tile) - (x->tile < y->tile);
}

int lx_within_order(struct lx_radiosity *reflected)
{
    const size_t count = reflected->tile_count;
    struct ranked *ranked = lx_new_array(count, sizeof *ranked);
    free(reflected->order);
    reflected->order = lx_new_array(count, sizeof *reflected->order);
    const int failed = ranked && reflected->order ? 0 : -1;
    for (size_t t = 0; t < count && !failed; t++)
        ranked[t] = (struct ranked){lx_tile_area(&reflected->tiles[t]), t};
    if (!failed && count > 1)
        qsort(ranked, count, sizeof *ranked, by_area);
    for (size_t i = 0; i < count && !failed; i++)
        reflected->order[i] = ranked[i].tile;
    free(ranked);
    return failed;
}

bool lx_within_rows(const struct lx_radiosity *reflected, struct lx_effort *effort, uint32_t face,
                    const struct lx_window *window, const struct lx_tile_cell *cell, struct lx_occluder_cones *cones,
                    struct lx_rows **rows)
{
    cones->effort = effort;
    if (lx_effort_is_left(effort) && lx_rows_find(reflected, face, window, cell, cones, rows))
        cones->failed = true;
    cones->effort = NULL;
    return lx_effort_is_left(effort) && !cones->failed;
}

/* ---- direct light ---- */

static double greatest_of(const struct lx_direct *direct)
{
    double greatest = 0;
    for (int q = 0; q < LX_RULE_NODES; q++)
        greatest = fmax(greatest, fabs(direct->nodes[q]));
    for (int i = 0; direct->quarters && i < 4; i++)
        greatest = fmax(greatest, greatest_of(&direct->quarters[i]));
    return greatest;
}

int lx_within_guess(const struct lx_radiosity *reflected, const struct lx_asking *asking, const double *told,
                    struct lx_tile *tile)
{
    enum { FEW_LEVELS = 2 };
    const struct lx_asking unbounded = {.control = asking->control, .is_caller = asking->is_caller};
    struct lx_sampling_direct sampling = reflected->sampling;
    double light = 0;
    sampling.world.prepared = sampling.open;
    sampling.outlines.count = 0; /* there are no shadows */
    sampling.most_levels = FEW_LEVELS;
    sampling.fold_flux = HUGE_VAL;
    if (lx_direct_sample(&sampling, &reflected->faces[tile->face], &unbounded, tile))
        return -1;
    tile->most_direct = greatest_of(&tile->direct);
    for (int q = 0; q < LX_RULE_NODES; q++) {
        const double open = fmax(tile->direct.nodes[q], 0), value = told ? fmin(fmax(told[q], 0), open) : open / 2;
        light += tile->cell.area[q] * (fmax(value, open - value) + fabs(tile->direct.nodes[q] - open));
        tile->direct.nodes[q] = value;
    }
    lx_direct_clear(&tile->direct);
    tile->direct_error += light / lx_tile_area(tile);
    tile->direct.doubt.left += light;
    tile->direct.doubt.greatest = fmax(tile->direct.doubt.greatest, 2 * tile->most_direct);
    tile->is_guessed = true;
    return 0;
}

/* ---- ceilings ---- */

/* A tile as it tells how much it can send: reflectance times its greatest irradiance, and times its flux. */
struct sender {
    double brightest, flux, area;
};

static struct sender sender_of(const struct lx_radiosity *reflected, const struct lx_tile *tile)
{
    const double between = 2; /* the nodes of the finest windows */
    const double reflectance = reflected->faces[tile->face].reflectance, area = lx_tile_area(tile);
    double light = 0;
    for (int q = 0; q < LX_RULE_NODES; q++)
        light += tile->cell.area[q] * tile->direct.nodes[q];
    return (struct sender){
        .brightest = reflectance * between * (tile->is_guessed ? tile->most_direct : greatest_of(&tile->direct)),
        .flux = reflectance * (fmax(light, 0) + tile->direct_error * area),
        .area = area,
    };
}

/*
 * The most direct light that a tile may receive from the others by one bounce.  The kernel is nowhere greater than
 * 1 / (pi d^2) at the least distance d, nor is all that a place sees of something more than 1.
 */
static double first_bounce(const struct lx_radiosity *reflected, const struct sender *senders, double brightest,
                           size_t t)
{
    const struct lx_tile *tile = &reflected->tiles[t];
    const struct lx_matte_face *face = &reflected->faces[tile->face];
    double sum = 0;
    for (size_t s = 0; s < reflected->tile_count && sum < brightest; s++) {
        const struct lx_tile_cell *other = &reflected->tiles[s].cell;
        double square = 0;
        if (reflected->tiles[s].face == tile->face ? face->is_flat
                                                   : !lx_faces_meet(face, &reflected->faces[reflected->tiles[s].face]))
            continue;
        for (int i = 0; i < 3; i++)
            square += (other->center_mm[i] - tile->cell.center_mm[i]) * (other->center_mm[i] - tile->cell.center_mm[i]);
        const double gap = sqrt(square) - other->radius_mm - tile->cell.radius_mm;
        const double kernel = gap > 0 ? 1 / (M_PI * gap * gap) : HUGE_VAL;
        const double seen = fmin(senders[s].area * kernel, 1);
        sum += senders[s].flux > 0 ? fmin(senders[s].brightest * seen, senders[s].flux * kernel) : 0;
    }
    return fmin(sum, brightest);
}

/* What arrives of others in the mean, as in a sphere of as much area and light, where the share of all ways that end on
 * faces is that of the tiles of which it is known. */
static double mean_received(const struct lx_radiosity *reflected)
{
    double area = 0, reflecting = 0, sent = 0, known = 0, seen = 0;
    for (size_t t = 0; t < reflected->tile_count; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        const double reflectance = reflected->faces[tile->face].reflectance;
        for (int q = 0; q < LX_RULE_NODES; q++) {
            const double at = tile->cell.area[q];
            area += at;
            reflecting += reflectance * at;
            sent += reflectance * at * tile->direct.nodes[q];
            known += tile->is_blind ? 0 : at;
            seen += tile->is_blind ? 0 : at * reflected->seen[t * LX_RULE_NODES + (size_t)q];
        }
    }
    const double share = known > 0 ? fmin(seen / known, 1) : 1;
    return fmax(share * sent / (area - (reflected->bounces == 1 ? 0 : share * reflecting)), 0);
}

int lx_within_ceilings(struct lx_radiosity *reflected)
{
    const size_t count = reflected->tile_count;
    const double mean = mean_received(reflected);
    struct sender *senders = lx_new_array(count, sizeof *senders);
    double *first = lx_new_array(count, sizeof *first), brightest = 0, greatest = 0, reflectance = 0;
    const int failed = senders && first ? 0 : -1;
    for (size_t t = 0; t < count && !failed; t++) {
        senders[t] = sender_of(reflected, &reflected->tiles[t]);
        brightest = fmax(brightest, senders[t].brightest);
        reflectance = fmax(reflectance, reflected->faces[reflected->tiles[t].face].reflectance);
    }
    for (size_t t = 0; t < count && !failed; t++) {
        first[t] = first_bounce(reflected, senders, brightest, t);
        greatest = fmax(greatest, first[t]);
    }
    const double further = reflected->bounces == 1 ? 0 : reflectance / (1 - reflectance) * greatest;
    for (size_t t = 0; t < count && !failed; t++) {
        struct lx_tile *tile = &reflected->tiles[t];
        if (!tile->is_blind || tile->has_past)
            continue;
        const double most = first[t] + further, value = fmin(mean, most);
        tile->past_error = fmax(value, most - value);
        for (int q = 0; q < LX_RULE_NODES; q++)
            tile->past[q] = value;
    }
    free(senders);
    free(first);
    return failed;
}

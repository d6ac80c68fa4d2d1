/* SPDX-License-Identifier: MIT */
/* From a scene to its reflected light: sampling, solving, cutting tiles where it matters, and asking at places. */
#include "reflected.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../surface/beside.h"
#include "refine.h"

enum { MOST_ROUNDS = 6, MOST_TILES = 560, LEVELS = 6 };

/* Differences of direct light that do not count, as a share of all of it. */
static const double LITTLE = 2e-6;
/* Errors of the last integral beside what two of them differ by. */
static const double ROUNDING = 1e-7;

void lx_reflected_free(struct lx_radiosity *reflected)
{
    if (!reflected)
        return;
    for (size_t t = 0; t < reflected->tile_count; t++)
        lx_direct_clear(&reflected->tiles[t].direct);
    free(reflected->faces);
    free(reflected->tiles);
    free(reflected->first_tile);
    free(reflected->indirect);
    free(reflected->before);
    free(reflected->slack);
    free(reflected->slack_before);
    free(reflected);
}

/* ---- direct light ---- */

/* Tiles whose light is to be sampled. */
struct sampling {
    struct lx_radiosity *reflected;
    atomic_bool failed;
};

static void sample_tiles(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct sampling *sampling = data;
    struct lx_radiosity *reflected = sampling->reflected;
    const struct lx_asking asking = {.control = reflected->control, .is_caller = is_caller};
    (void)worker;
    for (unsigned t = first; t < last && lx_asking_goes_on(&asking); t++) {
        struct lx_tile *tile = &reflected->tiles[t];
        if (tile->has_light)
            continue;
        if (lx_direct_sample(&reflected->sampling, &reflected->faces[tile->face], &asking, tile))
            atomic_store(&sampling->failed, true);
        else
            tile->has_light = reflected->sampling.least_flux > 0;
    }
}

static luxel_status sample(struct lx_radiosity *reflected)
{
    struct sampling sampling = {.reflected = reflected};
    const struct lx_rows_part part = {.last = (unsigned)reflected->tile_count,
                                      .tile_rows = 1,
                                      .counts_itself = true,
                                      .work = sample_tiles,
                                      .data = &sampling};
    if (!lx_rows_run_part(reflected->control, reflected->threads, &part))
        return LUXEL_CANCELLED;
    return atomic_load(&sampling.failed) ? LUXEL_ERROR_MEMORY : LUXEL_OK;
}

/* First the nodes, which tell how much light there is, then all that counts. */
static luxel_status light_up(struct lx_radiosity *reflected)
{
    uint8_t *is_lit = lx_new_array(reflected->face_count, sizeof *is_lit);
    double flux = 0;
    luxel_status status = is_lit ? sample(reflected) : LUXEL_ERROR_MEMORY;
    for (size_t t = 0; t < reflected->tile_count && status == LUXEL_OK; t++)
        for (int q = 0; q < LX_RULE_NODES; q++) {
            const struct lx_tile *tile = &reflected->tiles[t];
            flux += tile->direct.nodes[q] * tile->cell.area[q];
            is_lit[tile->face] |= tile->direct.nodes[q] > 0;
        }
    if (status == LUXEL_OK && lx_tiling_drop(reflected, is_lit))
        status = LUXEL_ERROR_MEMORY;
    free(is_lit);
    reflected->sampling.least_flux = LITTLE * flux;
    return status == LUXEL_OK && flux > 0 ? sample(reflected) : status;
}

/* ---- what is asked for ---- */

/* A place, by an integral twice: once coarse, to tell what the cells of integrals leave. */
lx_bounded lx_reflected_at(const struct lx_radiosity *reflected, const struct lx_receiver *receiver,
                           struct lx_veils *veils)
{
    const struct lx_arrival fine =
        lx_gather(reflected, &lx_fine, receiver, reflected->before, reflected->slack_before, veils, NULL);
    const struct lx_arrival coarse = lx_gather(reflected, &lx_coarse, receiver, reflected->before, NULL, veils, NULL);
    return (lx_bounded){fine.value, fine.slack + fabs(fine.value - coarse.value) + ROUNDING * fabs(fine.value)};
}

/* What the tiles add to the error of a place: residuals and weights. */
static luxel_status weigh_place(const struct lx_radiosity *reflected, const struct lx_receiver *receiver, float *row,
                                double *weights)
{
    struct lx_veils veils = {0};
    lx_gather(reflected, &lx_coarse, receiver, NULL, NULL, &veils, row);
    lx_veils_clear(&veils);
    for (size_t i = 0; i < reflected->tile_count * LX_RULE_NODES; i++)
        weights[i / LX_RULE_NODES] = fmax(weights[i / LX_RULE_NODES], 0) + fabs((double)row[i]);
    return LUXEL_OK;
}

struct judging {
    struct lx_radiosity *reflected;
    const struct lx_reflected_wish *wish;
    bool reached;
};

/* Whether the errors at all places are small enough. */
static bool is_reached(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish)
{
    struct lx_veils veils = {0};
    bool reached = true;
    for (size_t p = 0; p < wish->place_count && reached; p++) {
        const struct lx_reflected_place *place = &wish->places[p];
        const lx_bounded light = lx_reflected_at(reflected, &place->receiver, &veils);
        reached = light.error <= wish->error * (light.value + place->direct);
    }
    lx_veils_clear(&veils);
    return reached;
}

static double area_of(const struct lx_tile *tile)
{
    double area = 0;
    for (int q = 0; q < LX_RULE_NODES; q++)
        area += tile->cell.area[q];
    return area;
}

/* How much the residual of each tile matters: by what the places see of it, and by its share of all. */
static int weigh(const struct lx_radiosity *reflected, const struct lx_reflected_wish *wish, double *scores)
{
    enum { MOST_WEIGHED = 16 };
    const size_t tiles = reflected->tile_count;
    float *row = lx_new_array(tiles * LX_RULE_NODES, sizeof *row);
    double *weights = lx_new_array(tiles, sizeof *weights), all = 0;
    const size_t step = wish->place_count / MOST_WEIGHED + 1;
    for (size_t t = 0; t < tiles; t++)
        all += area_of(&reflected->tiles[t]);
    for (size_t p = 0; row && weights && p < wish->place_count; p += step)
        weigh_place(reflected, &wish->places[p].receiver, row, weights);
    for (size_t t = 0; row && weights && t < tiles; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        const double seen = weights[t] / (double)(wish->place_count / step + 1), share = 4 * area_of(tile) / all;
        scores[t] = reflected->faces[tile->face].reflectance * (seen + share) *
                    (tile->residual[0] + tile->residual[1] + tile->direct_error);
    }
    const int failed = row && weights ? 0 : -1;
    free(row);
    free(weights);
    return failed;
}

static int falling(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

/* The score from which on tiles are cut: they are to hold most of the sum, but not to become too many. */
static double threshold_of(const double *scores, size_t count, size_t most)
{
    const double most_of_it = 0.85;
    double *sorted = lx_new_array(count, sizeof *sorted), sum = 0, reached = 0, threshold = HUGE_VAL;
    if (!sorted)
        return -1;
    memcpy(sorted, scores, count * sizeof *sorted);
    qsort(sorted, count, sizeof *sorted, falling);
    for (size_t t = 0; t < count; t++)
        sum += sorted[t];
    for (size_t t = 0; t < count && t < most && reached < most_of_it * sum; t++) {
        reached += sorted[t];
        threshold = sorted[t];
    }
    free(sorted);
    return threshold;
}

/* Cuts the tiles that matter; false: none, or *failed. */
static bool refine(struct lx_radiosity *reflected, const struct lx_reflected_wish *wish, bool *failed)
{
    const size_t count = reflected->tile_count;
    if (count >= MOST_TILES)
        return false;
    double *scores = lx_new_array(count, sizeof *scores);
    uint8_t *cuts = lx_new_array(count, sizeof *cuts);
    bool any = false;
    *failed = !scores || !cuts || weigh(reflected, wish, scores);
    const double threshold = *failed ? 0 : threshold_of(scores, count, (MOST_TILES - count) * 2 / 3 + 1);
    *failed = *failed || threshold < 0;
    for (size_t t = 0; t < count && !*failed; t++) {
        const double *residual = reflected->tiles[t].residual;
        if (!(scores[t] >= threshold && scores[t] > 0))
            continue;
        cuts[t] = residual[0] > 3 * residual[1] ? 1 : residual[1] > 3 * residual[0] ? 2 : 3;
        any = true;
    }
    *failed = *failed || (any && lx_tiling_cut(reflected, cuts));
    free(scores);
    free(cuts);
    return any && !*failed;
}

static luxel_status work(struct lx_radiosity *reflected, const struct lx_reflected_wish *wish)
{
    luxel_status status = lx_tiling_make(reflected) ? LUXEL_ERROR_MEMORY : light_up(reflected);
    for (int round = 0; status == LUXEL_OK; round++) {
        bool failed = false;
        status = lx_reflected_solve(reflected);
        if (status != LUXEL_OK || round == MOST_ROUNDS || is_reached(reflected, wish) ||
            !refine(reflected, wish, &failed))
            return failed ? LUXEL_ERROR_MEMORY : status;
        status = sample(reflected);
    }
    return status;
}

luxel_status lx_reflected_make(const struct lx_reflected_wish *wish, struct lx_radiosity **made)
{
    struct lx_radiosity *reflected = lx_new_array(1, sizeof *reflected);
    *made = reflected;
    if (!reflected)
        return LUXEL_ERROR_MEMORY;
    const struct lx_choice_or_whole *bounces = &wish->prepared->scene->reflections;
    *reflected = (struct lx_radiosity){
        .prepared = wish->prepared,
        .sampling = {.world = {wish->prepared, wish->kernels}, .lobe = lx_lobe_irradiance(), .most_levels = LEVELS},
        .bounces = bounces->choice < 0 ? bounces->whole : 0,
        .threads = wish->threads,
        .control = wish->control,
    };
    const luxel_status status = work(reflected, wish);
    if (status != LUXEL_OK) {
        lx_reflected_free(reflected);
        *made = NULL;
    }
    return status;
}

struct lx_receiver lx_receiver_of(const struct lx_prepared *prepared, const struct lx_element *element)
{
    struct lx_receiver receiver = {
        .place_mm = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value},
        .normal = {element->normal.x.value, element->normal.y.value, element->normal.z.value},
        .own = element->own ? (size_t)(element->own - prepared->surfaces) : SIZE_MAX,
    };
    receiver.is_turned = element->own && lx_shape_is_turned(&element->own->shape, element->place_mm, element->normal);
    return receiver;
}

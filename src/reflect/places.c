/* SPDX-License-Identifier: MIT */
/* Refinement for places: whether their errors are small enough, and which tiles they have them from. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "between.h"
#include "close.h"
#include "doubt.h"
#include "links.h"
#include "refine.h"
#include "reflected.h"
#include "within.h"

/* The share that a place has of a tile's light. */
struct share {
    double seen; /* of all its ways */
    double bent; /* irradiance of the errors that cancel from afar, where it is near */
};

/* Adds what a place has from all tiles. */
static int weigh_place(const struct lx_radiosity *reflected, const struct lx_receiver *receiver, struct share *shares)
{
    struct lx_occluder_cones cones = {0};
    struct lx_links links = {0};
    size_t w = 0;
    lx_links_find(reflected, reflected->prepared, &reflected->coarse, receiver, &cones, &links);
    for (size_t i = 0; i < links.count && !links.failed; i++) {
        if (links.items[i].kind == LX_LINK_NONE)
            continue;
        const struct lx_weights *weights = &links.weights[w++];
        const struct lx_group *group = &reflected->groups[weights->group];
        double sum = 0, area = 0;
        for (int q = 0; q < LX_RULE_NODES; q++) {
            sum += fabs((double)weights->of[q]);
            area += group->cell.area[q];
        }
        for (size_t t = group->first_tile; t < group->first_tile + group->tile_count; t++)
            shares[t].seen += sum * lx_tile_area(&reflected->tiles[t]) / area;
        if (links.items[i].kind != LX_LINK_FAR)
            shares[group->first_tile].bent += (double)weights->doubt + sqrt((double)weights->squares);
    }
    struct lx_close_error errors[LX_MOST_CLOSE];
    const size_t close_count = lx_close_ask(reflected, reflected->prepared, receiver, &cones, errors);
    for (size_t i = 0; i < close_count; i++)
        shares[errors[i].tile].bent +=
            errors[i].error / reflected->faces[reflected->tiles[errors[i].tile].face].reflectance;
    const bool failed = links.failed || cones.failed;
    lx_links_clear(&links);
    lx_occluder_cones_clear(&cones);
    return failed ? -1 : 0;
}

bool lx_reflected_is_whole(const struct lx_radiosity *reflected, const struct lx_receiver *receiver)
{
    bool is_whole = true;
    for (size_t f = 0; f < reflected->left_out_count && is_whole; f++)
        is_whole = !lx_looks_at(receiver, &reflected->left_out[f]);
    return is_whole;
}

bool lx_reflected_is_for(const struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    bool is_for = reflected->left_out_count == 0 || request->place_count > 0;
    for (size_t p = 0; p < request->place_count && is_for; p++)
        is_for = lx_reflected_is_whole(reflected, &request->places[p].receiver);
    return is_for;
}

double lx_places_error(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, double most)
{
    struct lx_occluder_cones cones = {0};
    double greatest = 0;
    for (size_t p = 0; p < request->place_count && greatest <= most; p++) {
        const struct lx_reflected_place *place = &request->places[p];
        if (reflected->control && !lx_within_goes_on(reflected)) {
            greatest = HUGE_VAL;
            break;
        }
        const lx_bounded light = lx_reflected_at(reflected, request->prepared, &place->receiver, &cones);
        const double value = fmax(light.value + place->direct, 0);
        greatest = light.error > 0 ? fmax(greatest, light.error / value) : greatest;
    }
    lx_occluder_cones_clear(&cones);
    return greatest;
}

int lx_weigh(const struct lx_radiosity *reflected, const struct lx_reflected_place *places, size_t count,
             double *scores)
{
    enum { MOST_WEIGHED = 16 };
    const size_t tiles = reflected->tile_count;
    struct share *shares = lx_new_array(tiles, sizeof *shares);
    double all = 0, reflecting = 0;
    const size_t step = count / MOST_WEIGHED + 1;
    for (size_t t = 0; t < tiles; t++) {
        const double area = lx_tile_area(&reflected->tiles[t]);
        all += area;
        reflecting += reflected->faces[reflected->tiles[t].face].reflectance * area;
    }
    const double bounces = fmax(reflecting / (all - reflecting), 1); /* after the last one that the places see */
    int failed = shares ? 0 : -1;
    for (size_t p = 0; !failed && p < count; p += step)
        failed = weigh_place(reflected, &places[p].receiver, shares);
    for (size_t t = 0; !failed && t < tiles; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        const double mean = 1 / (double)(count / step + 1), share = bounces * lx_tile_area(tile) / all;
        scores[t] = reflected->faces[tile->face].reflectance *
                    ((mean * shares[t].seen + share) * (lx_between_change(tile->residual) + tile->direct_error) +
                     mean * shares[t].bent);
    }
    free(shares);
    return failed;
}

static int falling(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

/* The score from which on tiles are cut: they are to hold most of the sum, but not to become too many, nor too few to
 * be worth a solution. */
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
    for (size_t t = 0; t < count && t < most && (reached < most_of_it * sum || t < count / 16); t++) {
        reached += sorted[t];
        threshold = sorted[t];
    }
    free(sorted);
    return threshold;
}

int lx_cut_greatest(const struct lx_radiosity *reflected, const double *scores, size_t most, bool *cuts)
{
    const double threshold = threshold_of(scores, reflected->tile_count, most);
    int any = threshold < 0 ? -1 : 0;
    for (size_t t = 0; t < reflected->tile_count && any >= 0; t++) {
        if (!(scores[t] >= threshold && scores[t] > 0))
            continue;
        cuts[t] = true;
        any = 1;
    }
    return any;
}

int lx_places_cut(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool *cuts)
{
    const size_t count = reflected->tile_count;
    double *scores = lx_new_array(count, sizeof *scores);
    const int any = !scores || lx_weigh(reflected, request->places, request->place_count, scores)
                        ? -1
                        : lx_cut_greatest(reflected, scores, (reflected->most_tiles - count) * 2 / 3 + 1, cuts);
    free(scores);
    return any;
}

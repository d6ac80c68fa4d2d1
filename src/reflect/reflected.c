/* SPDX-License-Identifier: MIT */
/* From a scene to its reflected light: sampling, solving, cutting tiles where it matters, and asking at places. */
#include "reflected.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../surface/mesh_faces.h"
#include "box.h"
#include "close.h"
#include "group.h"
#include "links.h"
#include "overlap.h"
#include "refine.h"
#include "within.h"

enum { MOST_ROUNDS = 10, LEVELS = 6 };
/* Where faces lie on one another in the light the bound stays large, however small tiles are. */
enum { FEW_ROUNDS = 2 };

/* With more tiles than this share of the most, too few are left for another round. */
static const double WORTH_A_ROUND = 0.92;
/* All work together: it ends within a minute or two of one core.  Samples of direct light may take so much of what is
 * left of it; with more than the last share gone, too little is left for another round. */
static const size_t MOST_EFFORT = 1000000000;
static const double SAMPLES_SHARE = 0.6, WORTH_AS_MUCH = 0.5;
/* Differences of direct light that do not count, as a share of all of it and of the bound that is wanted. */
static const double LITTLE = 5e-2;
/* Light between outlines that may be missed on one window, as a share of that; or, as long as nobody knows how much
 * light there is, of all that would fall without shadows. */
static const double NARROW = 1.0 / 64, NARROW_AT_FIRST = 1e-3;
/* Light at folds that may be missed on one window, as a share of that; they are looked for once it is known. */
static const double FOLDED = 1.0 / 32;
/* What the samples of one window beside a place may leave there, as a share of the bound that is wanted. */
static const double NEARBY = 1.0 / 64;
/* How exact integrals over sources are made that samples of direct light take, as a share of the bound that is wanted:
 * errors of samples count as errors of the direct light. */
static const double SAMPLED = 1e-2;
/* Where time may be the end a solution of this bound comes first. */
static const double QUICK_ERROR = 0.1;
/* Samples and integrals are no finer for smaller bounds than this. */
static const double LEAST_ERROR = 1e-5;
/* The most tiles are so many, and more where few faces have to be asked for each: the work is about as much. */
static const size_t MOST_TILES = 600, MOST_PAIRS = 5000;
/* Errors of the rules of integration, as a share of what arrives and of the bound that is wanted. */
static const double RULE = 2e-2;
/* Errors of the last integral beside what two of them differ by; where round faces light: their light is sampled in
 * windows whose errors have one sign where it bends one way, so that they do not cancel. */
static const double ROUNDING = 1e-7, ROUND_RULE = 3e-5;

static void free_solution(struct lx_kept *kept)
{
    struct lx_radiosity *reflected = (struct lx_radiosity *)kept;
    for (size_t t = 0; t < reflected->tile_count; t++)
        lx_tile_clear(&reflected->tiles[t]);
    lx_parts_clear(reflected);
    free(reflected->on);
    free(reflected->faces);
    free(reflected->left_out);
    lx_closed_boxes_clear(&reflected->boxes);
    lx_beams_clear(&reflected->sampling.beams);
    lx_outlines_clear(&reflected->sampling.outlines);
    lx_folds_clear(&reflected->sampling.folds);
    free(reflected->near);
    free(reflected->tiles);
    free(reflected->groups);
    free(reflected->first_tile);
    free(reflected->indirect);
    free(reflected->before);
    free(reflected->slack);
    free(reflected->slack_before);
    free(reflected->sent);
    free(reflected->sent_slack);
    free(reflected->seen);
    free(reflected->parts);
    free(reflected->efforts);
    free(reflected->order);
    free(reflected);
}

void lx_reflected_free(struct lx_radiosity *reflected)
{
    lx_kept_release(reflected ? &reflected->kept : NULL);
}

struct lx_kept *lx_reflected_kept(struct lx_radiosity *reflected)
{
    return &reflected->kept;
}

struct lx_radiosity *lx_reflected_like_kept(struct lx_kept *kept, const struct lx_reflected_key *key)
{
    struct lx_radiosity *reflected = (struct lx_radiosity *)kept;
    const struct lx_reflected_key *made = &reflected->key;
    const bool is_it = made->tolerance == key->tolerance && made->kernels == key->kernels &&
                       memcmp(made->on, key->on, reflected->light_count * sizeof *key->on) == 0;
    return is_it ? reflected : NULL;
}

struct lx_radiosity *lx_reflected_of_kept(struct lx_kept *kept, const struct lx_reflected_key *key)
{
    struct lx_radiosity *reflected = lx_reflected_like_kept(kept, key);
    const bool is_it = reflected && reflected->key.quantity == key->quantity && reflected->key.error == key->error;
    return is_it && (reflected->cut_within == 0 || lx_reflected_is_cut(reflected, key->within, key->is_asked))
               ? reflected
               : NULL;
}

bool lx_reflected_is_cut(const struct lx_radiosity *reflected, double within, bool is_asked)
{
    const double had = reflected->cut_within;
    return had > 0 && (isfinite(had) ? within > 0 && within <= had : is_asked);
}

/* ---- direct light ---- */

/* Tiles whose light is to be sampled. */
struct sampling {
    struct lx_radiosity *reflected;
    atomic_bool failed;
};

static int sample_tile(const struct lx_radiosity *reflected, const struct lx_asking *asking, struct lx_tile *tile)
{
    const struct lx_effort *effort = asking->effort;
    const bool is_told = tile->is_sampled;
    double told[LX_RULE_NODES];
    memcpy(told, tile->direct.nodes, sizeof told);
    tile->is_guessed = false;
    if (lx_effort_is_left(effort) &&
        !lx_direct_sample(&reflected->sampling, &reflected->faces[tile->face], asking, tile)) {
        tile->is_sampled = true;
        return 0;
    }
    return lx_effort_is_left(effort) ? -1 : lx_within_guess(reflected, asking, is_told ? told : NULL, tile);
}

static void sample_tiles(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct sampling *sampling = data;
    struct lx_radiosity *reflected = sampling->reflected;
    (void)worker;
    for (unsigned i = first; i < last && lx_control_goes_on(reflected->control, is_caller); i++) {
        const struct lx_asking asking = {reflected->control, is_caller, &reflected->efforts[i]};
        struct lx_tile *tile = &reflected->tiles[reflected->order[i]];
        if (tile->has_light)
            continue;
        tile->is_overlaid = lx_overlap_on(reflected, tile) != NULL;
        if (sample_tile(reflected, &asking, tile))
            atomic_store(&sampling->failed, true);
        else
            tile->has_light = isfinite(reflected->sampling.least_flux);
    }
}

static luxel_status sample(struct lx_radiosity *reflected)
{
    struct sampling sampling = {.reflected = reflected};
    const struct lx_within within = {reflected->tile_count, SAMPLES_SHARE, sample_tiles, &sampling};
    const luxel_status status = lx_within_order(reflected) ? LUXEL_ERROR_MEMORY : lx_within_run(reflected, &within);
    return status == LUXEL_OK && atomic_load(&sampling.failed) ? LUXEL_ERROR_MEMORY : status;
}

/* All light that would fall without shadows, about. */
static double open_flux(const struct lx_radiosity *reflected)
{
    const struct lx_asking asking = {.control = reflected->control, .is_caller = true};
    double flux = 0;
    for (size_t t = 0; t < reflected->tile_count; t++)
        flux += lx_direct_open_flux(&reflected->sampling, &asking, &reflected->tiles[t].cell);
    return flux;
}

/* Which faces have light, or may have, and how much all of them have: that on the brightest material counts whole, all
 * else by what is reflected of it beside that. */
static double lit_flux(const struct lx_radiosity *reflected, bool *is_lit)
{
    double flux = 0, sent = 0, most = 0;
    for (size_t t = 0; t < reflected->tile_count; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        const double reflectance = reflected->faces[tile->face].reflectance;
        double light = tile->direct_error * lx_tile_area(tile);
        for (int q = 0; q < LX_RULE_NODES; q++)
            light += tile->direct.nodes[q] * tile->cell.area[q];
        is_lit[tile->face] = is_lit[tile->face] || light > 0;
        most = fmax(most, reflectance);
        sent += reflectance * light;
        flux += light;
    }
    return sent > 0 ? sent / most : flux;
}

/* What a place receives of the direct light that tiles have by now, about, and without regard to what hides it. */
static double received_by(const struct lx_radiosity *reflected, const struct lx_receiver *receiver)
{
    static const int inner[] = {5, 6, 9, 10};
    double sum = 0;
    for (size_t t = 0; t < reflected->tile_count; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        double sent = 0, kernel = 0, area = 0;
        for (int q = 0; q < LX_RULE_NODES; q++) {
            sent += tile->cell.area[q] * tile->direct.nodes[q];
            area += tile->cell.area[q];
        }
        for (int k = 0; k < 4 && sent > 0; k++)
            kernel += lx_kernel_at(receiver, tile->cell.place_mm[inner[k]], tile->cell.normal[inner[k]]) / 4;
        sum += reflected->faces[tile->face].reflectance * fmax(sent, 0) * fmin(kernel, 1 / area);
    }
    return sum;
}

/* Adds what a place sees from close by. */
static int add_close(struct lx_radiosity *reflected, const struct lx_receiver *receiver, double least)
{
    struct lx_close_place found[LX_MOST_CLOSE];
    struct lx_occluder_cones cones = {0};
    const size_t count = lx_close_find(reflected, reflected->prepared, receiver, &cones, found);
    int failed = cones.failed ? -1 : 0;
    lx_occluder_cones_clear(&cones);
    if (lx_reserve(&reflected->near, &reflected->near_capacity, reflected->near_count + count + 1,
                   sizeof *reflected->near))
        failed = -1;
    for (size_t i = 0; i < count && !failed; i++)
        reflected->near[reflected->near_count++] =
            (struct lx_near){found[i].receiver, least / reflected->faces[found[i].face].reflectance};
    return failed;
}

/* The places that are asked, once it is known how much light there is. */
static int find_near(struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    const double share = NEARBY * fmax(request->error, LEAST_ERROR);
    for (size_t p = 0; p < request->place_count; p++) {
        const struct lx_reflected_place *place = &request->places[p];
        const double least = share * (fabs(place->direct) + received_by(reflected, &place->receiver));
        if (add_close(reflected, &place->receiver, least))
            return -1;
        reflected->near[reflected->near_count++] = (struct lx_near){place->receiver, least};
    }
    reflected->sampling.near = reflected->near;
    reflected->sampling.near_count = reflected->near_count;
    return 0;
}

/* First the nodes, beams and outlines, which tell how much light there is, then all that counts. */
static luxel_status light_up(struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    struct lx_sampling_direct *sampling = &reflected->sampling;
    bool *is_lit = lx_new_array(reflected->face_count, sizeof *is_lit);
    double flux = 0;
    const double share = LITTLE * fmax(request->error, LEAST_ERROR);
    const bool has_room = is_lit && !lx_beams_make(&reflected->prepared->emitters, share, &sampling->beams) &&
                          !lx_outlines_make(&reflected->sampled, &sampling->outlines) &&
                          !lx_folds_make(&reflected->sampled.emitters, share, &sampling->folds);
    if (has_room && sampling->outlines.count > 0)
        sampling->narrow_flux = NARROW_AT_FIRST * open_flux(reflected);
    luxel_status status = has_room ? sample(reflected) : LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK)
        flux = lit_flux(reflected, is_lit);
    if (status == LUXEL_OK && lx_tiling_drop(reflected, is_lit))
        status = LUXEL_ERROR_MEMORY;
    free(is_lit);
    reflected->most_tiles = MOST_TILES + MOST_PAIRS / (reflected->face_count + 1);
    for (size_t f = 0; f < reflected->face_count; f++)
        reflected->most_tiles += reflected->faces[f].is_small;
    if (status != LUXEL_OK || !(flux > 0))
        return status;
    sampling->least_flux = share * flux;
    sampling->narrow_flux = NARROW * sampling->least_flux;
    sampling->fold_flux = FOLDED * sampling->least_flux;
    return find_near(reflected, request) ? LUXEL_ERROR_MEMORY : sample(reflected);
}

/* ---- what is asked for ---- */

/* A place, by an integral twice: once coarse, to tell what the cells of integrals leave. */
lx_bounded lx_reflected_at(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                           const struct lx_receiver *receiver, struct lx_occluder_cones *cones)
{
    const struct lx_light light = {reflected->sent, reflected->sent_slack};
    struct lx_links links = {0};
    if (!lx_reflected_is_whole(reflected, receiver))
        return (lx_bounded){0, HUGE_VAL};
    lx_links_find(reflected, prepared, &reflected->fine, receiver, cones, &links);
    const struct lx_arrival fine = lx_links_sum(reflected, &links, &light);
    links.count = 0;
    lx_links_find(reflected, prepared, &reflected->coarse, receiver, cones, &links);
    const struct lx_arrival coarse = lx_links_sum(reflected, &links, &light);
    lx_links_clear(&links);
    struct lx_close_error errors[LX_MOST_CLOSE];
    const size_t count = lx_close_ask(reflected, prepared, receiver, cones, errors);
    double unsure = 0;
    for (size_t i = 0; i < count; i++)
        unsure += errors[i].error;
    unsure += fine.slack + fabs(fine.value - coarse.value) + reflected->rule * fabs(fine.value);
    return (lx_bounded){fine.value, unsure};
}

/* ---- rounds of refinement ---- */

double lx_reflected_error(const struct lx_radiosity *reflected, const struct lx_reflected_request *request, double most)
{
    return request->place_count > 0 ? lx_places_error(reflected, request, most)
           : request->spots         ? lx_spots_error(reflected, request)
                                    : lx_means_error(reflected);
}

bool lx_reflected_is_reached(const struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    return lx_reflected_is_for(reflected, request) &&
           lx_reflected_error(reflected, request, request->error) <= request->error;
}

/* Cuts the tiles that matter; false: none, or *failed. */
static bool refine(struct lx_radiosity *reflected, const struct lx_reflected_request *request, bool *failed)
{
    const size_t count = reflected->tile_count;
    if ((double)reflected->effort.done > WORTH_AS_MUCH * (double)reflected->effort.most)
        return false;
    if ((double)count >= WORTH_A_ROUND * (double)reflected->most_tiles)
        return false;
    bool *cuts = lx_new_array(count, sizeof *cuts);
    const int any = !cuts                      ? -1
                    : request->place_count > 0 ? lx_places_cut(reflected, request, cuts)
                    : request->spots           ? lx_spots_cut(reflected, request, cuts)
                                               : lx_means_cut(reflected, request, cuts);
    *failed = any < 0 || (any > 0 && lx_groups_cut(reflected, cuts));
    free(cuts);
    return any > 0 && !*failed;
}

static luxel_status solve(struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    luxel_status status = lx_groups_light(reflected) ? LUXEL_ERROR_MEMORY : lx_reflected_solve(reflected);
    if (status == LUXEL_OK)
        status = lx_parts_make(reflected);
    return status == LUXEL_OK && request->spots ? lx_spots_show(reflected, request, false) : status;
}

/* Errors of integrals, as a share of what arrives.  Inside a hollow ball that stands by itself there is
 * nothing to integrate: all places see all in one way. */
static double rule_of(const struct lx_radiosity *reflected)
{
    bool is_round = false, is_even = false, is_alone = true;
    for (size_t f = 0; f < reflected->face_count; f++) {
        const struct lx_matte_face *face = &reflected->faces[f];
        is_round = is_round || !face->is_flat;
        is_even = is_even || (face->sheet.type->exchange && face->sheet.type->exchange(&face->sheet) > 0);
        is_alone = is_alone && face->surface == reflected->faces[0].surface;
    }
    if (is_even && is_alone)
        return ROUNDING;
    return fmax(RULE * reflected->error, is_round ? ROUND_RULE : ROUNDING);
}

/* How fine integrals are, by the bound that is wanted, and never coarser than a thousandth takes: the rule of 16 nodes
 * errs by the 8th power of the size of cells, or by the 4th where what it is multiplied by is rough, as for groups, or
 * cut. */
static void set_fineness(struct lx_radiosity *reflected)
{
    const double scale = fmin(fmax(reflected->error, LEAST_ERROR), 1e-3) / 1e-3;
    const double fourth = sqrt(sqrt(scale)), eighth = sqrt(fourth);
    reflected->fine = (struct lx_fineness){.seen = 0.35 * eighth,
                                           .rough = 0.2 * fourth,
                                           .narrow = 0.07 * fourth,
                                           .flat_part = 0.3 * fourth,
                                           .round_part = 0.06 * fourth,
                                           .group = 0.16 * fourth,
                                           .has_details = true};
    reflected->coarse = (struct lx_fineness){.seen = 0.45 * eighth,
                                             .rough = 0.25 * fourth,
                                             .narrow = 0.14 * fourth,
                                             .flat_part = 0.42 * fourth,
                                             .round_part = 0.12 * fourth,
                                             .group = 0.26 * fourth};
    reflected->fine.is_of_nodes = reflected->coarse.is_of_nodes = reflected->sampling.near_count == 0;
    reflected->rule = rule_of(reflected);
}

/* Whether the bound is reached.  Where somebody waits, a copy of the solution becomes the best if it is, and no work is
 * done any more once the time is over; *failed: memory ran out. */
static bool is_done(const struct lx_radiosity *reflected, const struct lx_reflected_request *request,
                    struct lx_radiosity **best, bool *failed)
{
    struct lx_patience *patience = reflected->control->patience;
    if (!patience)
        return lx_reflected_is_reached(reflected, request);
    const double bound = lx_reflected_error(reflected, request, HUGE_VAL);
    if (!*best || bound < patience->bound) {
        lx_reflected_free(*best);
        *best = lx_reflected_copy(reflected);
        *failed = !*best;
    }
    patience->bound = fmin(patience->bound, bound);
    patience->stops = true;
    return bound <= request->error;
}

/* Bounds below what integrals can do are not striven for.  *best is the best whole solution, where somebody waits: NULL
 * as long as there is none. */
static luxel_status work(struct lx_radiosity *reflected, const struct lx_reflected_request *wanted,
                         struct lx_radiosity **best)
{
    struct lx_reflected_request within_reach = *wanted;
    within_reach.error = fmax(wanted->error, LEAST_ERROR);
    const struct lx_reflected_request *request = &within_reach;
    struct lx_patience *patience = reflected->control->patience;
    luxel_status status = light_up(reflected, request);
    set_fineness(reflected);
    for (int round = 0; status == LUXEL_OK; round++) {
        bool failed = false;
        size_t overlapping[2];
        status = solve(reflected, request);
        if (status != LUXEL_OK || (is_done(reflected, request, best, &failed) && !failed))
            break;
        if (failed || (patience && atomic_load(&patience->is_over)))
            return failed ? LUXEL_ERROR_MEMORY : LUXEL_CANCELLED;
        const int most = lx_reflected_overlaps(reflected, overlapping) ? FEW_ROUNDS : MOST_ROUNDS;
        if (round == most || !refine(reflected, request, &failed)) {
            status = failed ? LUXEL_ERROR_MEMORY : request->spots ? lx_spots_show(reflected, request, true) : LUXEL_OK;
            break;
        }
        status = sample(reflected);
    }
    return status;
}

/* A coarse solution for the same, which belongs to the caller in any case. */
static luxel_status make_quickly(const struct lx_reflected_request *request, struct lx_radiosity **best,
                                 struct lx_radiosity **made)
{
    struct lx_reflected_request quick = *request;
    const double before = request->control->before;
    quick.error = QUICK_ERROR;
    luxel_status status = lx_reflected_begin(&quick, made);
    if (status == LUXEL_OK)
        status = work(*made, &quick, best);
    request->control->before = before;
    return status;
}

/* Works until the bound is reached or somebody has waited for long enough. */
static luxel_status wait(struct lx_radiosity **made, const struct lx_reflected_request *request)
{
    struct lx_patience patience = {.until = request->within > 0 ? lx_seconds() + request->within : HUGE_VAL,
                                   .is_enough = request->is_enough,
                                   .bound = HUGE_VAL};
    struct lx_radiosity *best = NULL, *first = NULL;
    request->control->patience = &patience;
    luxel_status status = LUXEL_OK;
    if (request->within > 0 && request->error < QUICK_ERROR)
        status = make_quickly(request, &best, &first);
    lx_reflected_free(first);
    if (status == LUXEL_OK)
        status = work(*made, request, &best);
    request->control->patience = NULL;
    const bool is_over = atomic_load(&patience.is_over);
    if (status == LUXEL_CANCELLED && is_over && best && lx_control_goes_on(request->control, true)) {
        status = LUXEL_OK;
        lx_reflected_free(*made);
        *made = best;
        best = NULL;
    }
    if (is_over && patience.bound > request->error) {
        (*made)->cut_within = lx_seconds() < patience.until ? HUGE_VAL : request->within;
        if (request->is_enough)
            request->is_enough(patience.bound, request->control->data);
    }
    lx_reflected_free(best);
    return status;
}

/* Rows are of use only while the solution is made. */
static void forget_rows(struct lx_radiosity *reflected)
{
    for (size_t t = 0; t < reflected->tile_count; t++) {
        lx_rows_free(reflected->tiles[t].rows);
        reflected->tiles[t].rows = NULL;
    }
    for (size_t p = 0; p < reflected->part_count; p++) {
        lx_rows_free(reflected->parts[p].rows);
        reflected->parts[p].rows = NULL;
    }
}

luxel_status lx_reflected_begin(const struct lx_reflected_request *request, struct lx_radiosity **made)
{
    struct lx_radiosity *reflected = lx_new_array(1, sizeof *reflected);
    *made = reflected;
    if (!reflected)
        return LUXEL_ERROR_MEMORY;
    const struct lx_choice_or_whole *bounces = &request->prepared->scene->reflections;
    *reflected = (struct lx_radiosity){
        .key = request->key,
        .on = lx_new_array(request->prepared->scene->lights.count, sizeof *reflected->on),
        .light_count = request->prepared->scene->lights.count,
        .prepared = request->prepared,
        .sampled = *request->prepared,
        .error = request->error,
        .sampling = {.world = {.kernels = request->kernels},
                     .lobe = lx_lobe_irradiance(),
                     .least_flux = HUGE_VAL,
                     .fold_flux = HUGE_VAL,
                     .most_levels = LEVELS},
        .bounces = bounces->choice < 0 ? bounces->whole : 0,
        .threads = request->threads,
        .effort = {.most = request->effort > 0 ? request->effort : MOST_EFFORT},
        .control = request->control,
        .begun = request->control->before,
    };
    reflected->sampled.tolerance = fmax(reflected->sampled.tolerance, SAMPLED * request->error);
    reflected->sampling.world.prepared = &reflected->sampled;
    reflected->open = reflected->sampled;
    reflected->open.shadows = reflected->open.shadows_extended = reflected->open.shadows_on_free = false;
    reflected->sampling.open = &reflected->open;
    lx_kept_init(&reflected->kept, free_solution);
    reflected->key.on = reflected->on;
    if (reflected->on)
        memcpy(reflected->on, request->prepared->on, reflected->light_count * sizeof *reflected->on);
    if (!reflected->on || lx_tiling_make(reflected, request))
        return LUXEL_ERROR_MEMORY;
    reflected->most_tiles = MOST_TILES + MOST_PAIRS / (reflected->face_count + 1);
    set_fineness(reflected);
    return LUXEL_OK;
}

/* Works until the bound is reached or all effort is spent.  Samples for a fine bound may take all of it and leave one
 * that is larger than a coarse solution has; then such a one follows, and the better of the two stays. */
static luxel_status strive(struct lx_radiosity **made, const struct lx_reflected_request *request)
{
    luxel_status status = work(*made, request, NULL);
    const struct lx_effort *effort = &(*made)->effort;
    if (status != LUXEL_OK || request->error >= QUICK_ERROR || effort->done < effort->most / 2)
        return status;
    const double bound = lx_reflected_error(*made, request, HUGE_VAL);
    if (bound <= QUICK_ERROR)
        return LUXEL_OK;
    struct lx_radiosity *coarse = NULL;
    forget_rows(*made);
    status = make_quickly(request, NULL, &coarse);
    if (status == LUXEL_OK && lx_reflected_error(coarse, request, HUGE_VAL) < bound) {
        struct lx_radiosity *fine = *made;
        *made = coarse;
        coarse = fine;
    }
    lx_reflected_free(coarse);
    return status;
}

luxel_status lx_reflected_make(const struct lx_reflected_request *request, struct lx_radiosity **made)
{
    luxel_status status = lx_reflected_begin(request, made);
    struct lx_radiosity *reflected = *made;
    if (status == LUXEL_OK && (request->within > 0 || request->is_enough))
        status = wait(&reflected, request);
    else if (status == LUXEL_OK)
        status = strive(&reflected, request);
    if (!reflected)
        return status;
    *made = reflected;
    lx_within_tell(reflected, 1);
    forget_rows(reflected);
    reflected->prepared = reflected->sampling.world.prepared = NULL;
    reflected->control = NULL;
    if (status != LUXEL_OK) {
        lx_reflected_free(reflected);
        *made = NULL;
    }
    return status;
}

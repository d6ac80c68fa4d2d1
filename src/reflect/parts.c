/* SPDX-License-Identifier: MIT */
/*
 * Parts of tiles, for what a picture shows.  What tiles receive from each other is often known long before each of
 * them shows it well: a polynomial on a large tile is coarse where light changes fast, near to edges and to the feet
 * of things.  So the tile is cut for showing alone, and its parts have polynomials by one more integral over the
 * solution, which stays as it is.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "between.h"
#include "links.h"
#include "refine.h"
#include "within.h"

/* No picture has many more parts. */
enum { MOST_PARTS = 2400 };
/* Where there are more parts, their rows would take too much memory. */
enum { MOST_WITH_ROWS = 800 };
/* Arriving light is smooth: between the nodes no more than that beyond the greatest of them. */
static const double BEYOND = 1.1;

/* Parts under way: from `first` on they are to be filled. */
struct showing {
    struct lx_radiosity *reflected;
    struct lx_occluder_cones *cones; /* of each worker */
    size_t first;
};

static struct lx_shown_part *append(struct lx_radiosity *reflected)
{
    if (lx_reserve(&reflected->parts, &reflected->part_capacity, reflected->part_count + 1, sizeof *reflected->parts))
        return NULL;
    struct lx_shown_part *part = &reflected->parts[reflected->part_count++];
    *part = (struct lx_shown_part){0};
    return part;
}

void lx_parts_clear(struct lx_radiosity *reflected)
{
    for (size_t p = 0; p < reflected->part_count; p++) {
        lx_rows_free(reflected->parts[p].rows);
        reflected->parts[p].rows = NULL;
    }
    reflected->part_count = 0;
}

static void show_tile(const struct lx_radiosity *reflected, size_t t, struct lx_shown_part *part)
{
    const struct lx_tile *tile = &reflected->tiles[t];
    part->tile = t;
    part->group = tile->group;
    part->window = tile->window;
    part->own_error = tile->own_error;
    part->error = tile->error;
    part->worst = tile->worst;
    memcpy(part->residual, tile->residual, sizeof part->residual);
    memcpy(part->nodes, reflected->indirect + t * LX_RULE_NODES, sizeof part->nodes);
}

/* Tiles that are still there keep the parts that they had. */
static int keep_parts(struct lx_radiosity *reflected, struct lx_shown_part *old, size_t old_count)
{
    size_t *of_group = lx_new_array(reflected->group_count, sizeof *of_group), *was = NULL, was_capacity = 0;
    int failed = of_group ? 0 : -1;
    for (size_t p = old_count; p-- > 0 && !failed;) /* the first one of a group is all of it */
        of_group[old[p].group] = p + 1;
    for (size_t p = 0; p < reflected->part_count && !failed; p++) {
        failed = lx_reserve(&was, &was_capacity, reflected->part_count, sizeof *was);
        if (failed)
            break;
        if (p < reflected->tile_count)
            was[p] = of_group[reflected->parts[p].group];
        const struct lx_shown_part *before = was[p] > 0 ? &old[was[p] - 1] : NULL;
        if (!before || before->count == 0)
            continue;
        const size_t tile = reflected->parts[p].tile, first = reflected->part_count;
        reflected->parts[p].first = first;
        reflected->parts[p].count = before->count;
        for (unsigned i = 0; i < before->count && !failed; i++) {
            struct lx_shown_part *part = append(reflected);
            failed = !part || lx_reserve(&was, &was_capacity, reflected->part_count, sizeof *was) ? -1 : 0;
            if (failed)
                break;
            *part = old[before->first + i];
            old[before->first + i].rows = NULL;
            part->tile = tile;
            part->count = 0;
            was[reflected->part_count - 1] = before->first + i + 1;
        }
    }
    free(of_group);
    free(was);
    return failed;
}

/* ---- one more integral ---- */

/* As with tiles, coarse integrals at the nodes, and fine ones between them. */
static void fill(const struct showing *showing, struct lx_effort *effort, struct lx_occluder_cones *cones,
                 struct lx_shown_part *part)
{
    const struct lx_radiosity *reflected = showing->reflected;
    const uint32_t face = reflected->tiles[part->tile].face;
    const struct lx_light light = {reflected->sent, reflected->sent_slack};
    double arrives = 0, received = 0, between[LX_BETWEEN];
    struct lx_tile_cell cell;
    lx_cell_make(&reflected->faces[face], &part->window, &cell);
    if (!lx_within_rows(reflected, effort, face, &part->window, &cell, cones, &part->rows))
        return; /* what is known of it already stands */
    for (int q = 0; q < lx_rows_nodes(part->rows); q++) {
        const struct lx_arrival arrival = lx_links_sum(reflected, &part->rows->of[q], &light);
        part->nodes[q] = arrival.value;
        if (arrival.slack > arrives) {
            arrives = arrival.slack;
            part->worst = (unsigned)q;
        }
        received = fmax(received, fabs(arrival.value));
    }
    lx_rows_spread(part->rows, part->nodes);
    for (int p = 0; p < LX_BETWEEN; p++) {
        double at[2];
        lx_between_place(p, at);
        between[p] = lx_links_sum(reflected, lx_rows_between(part->rows, p), &light).value -
                     lx_rule_value(part->nodes, at[0], at[1]);
    }
    if (reflected->part_count > MOST_WITH_ROWS) {
        lx_rows_free(part->rows);
        part->rows = NULL;
    }
    memset(part->residual, 0, sizeof part->residual);
    lx_between_changes(between, part->residual);
    part->own_error = LX_BETWEEN_FACTOR * lx_between_greatest(between) + reflected->rule * received;
    part->error = part->own_error + BEYOND * arrives;
}

static void fill_parts(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct showing *showing = data;
    for (size_t i = first; i < last && lx_control_goes_on(showing->reflected->control, is_caller); i++)
        fill(showing, &showing->reflected->efforts[i], &showing->cones[worker],
             &showing->reflected->parts[showing->first + i]);
}

/* Fills parts from one on, with what arrives there now. */
static luxel_status fill_from(struct lx_radiosity *reflected, size_t first)
{
    struct showing showing = {reflected, lx_new_array(reflected->threads, sizeof(struct lx_occluder_cones)), first};
    const struct lx_within within = {reflected->part_count - first, 1, fill_parts, &showing};
    bool has_room = showing.cones;
    const luxel_status status = has_room ? lx_within_run(reflected, &within) : LUXEL_ERROR_MEMORY;
    for (size_t w = 0; showing.cones && w < reflected->threads; w++) {
        has_room = has_room && !showing.cones[w].failed;
        lx_occluder_cones_clear(&showing.cones[w]);
    }
    free(showing.cones);
    return !has_room ? LUXEL_ERROR_MEMORY : status;
}

luxel_status lx_parts_make(struct lx_radiosity *reflected)
{
    struct lx_shown_part *old = reflected->parts;
    const size_t old_count = reflected->part_count;
    int failed = 0;
    reflected->parts = NULL;
    reflected->part_count = reflected->part_capacity = 0;
    for (size_t t = 0; t < reflected->tile_count && !failed; t++) {
        struct lx_shown_part *part = append(reflected);
        failed = part ? 0 : -1;
        if (part)
            show_tile(reflected, t, part);
    }
    failed = failed || keep_parts(reflected, old, old_count);
    for (size_t p = 0; p < old_count; p++)
        lx_rows_free(old[p].rows);
    free(old);
    return failed ? LUXEL_ERROR_MEMORY : fill_from(reflected, reflected->tile_count);
}

/* ---- cutting ---- */

/* A part shows on those that it is cut into what it showed there. */
static void inherit(const struct lx_shown_part *whole, struct lx_shown_part *part)
{
    part->own_error = whole->own_error;
    part->error = whole->error;
    part->worst = whole->worst;
    for (int q = 0; q < LX_RULE_NODES; q++) {
        double at[2];
        for (int k = 0; k < 2; k++)
            at[k] = (part->window.middle[k] - whole->window.middle[k] +
                     part->window.half[k] * lx_rule_places[k ? q % LX_ORDER : q / LX_ORDER]) /
                    whole->window.half[k];
        part->nodes[q] = lx_rule_value(whole->nodes, at[0], at[1]);
    }
}

static int cut(struct lx_radiosity *reflected, size_t p)
{
    const struct lx_cuts cuts = lx_between_cuts(reflected->parts[p].residual);
    const unsigned count = lx_window_parts(&cuts);
    reflected->parts[p].first = reflected->part_count;
    for (unsigned i = 0; i < count; i++) {
        struct lx_shown_part *part = append(reflected);
        if (!part)
            return -1;
        part->tile = reflected->parts[p].tile;
        part->group = reflected->parts[p].group;
        part->window = lx_window_part(&reflected->parts[p].window, &cuts, i);
        inherit(&reflected->parts[p], part);
    }
    reflected->parts[p].count = count;
    return 0;
}

/* Cuts the parts that show more error than is allowed, of their own. */
static int cut_some(struct lx_radiosity *reflected, const double *allowed)
{
    const size_t count = reflected->part_count;
    int failed = 0;
    for (size_t p = 0; p < count && reflected->part_count < MOST_PARTS && !failed; p++) {
        const struct lx_shown_part *part = &reflected->parts[p];
        const double most = allowed[part->tile];
        const double arrives = part->error - part->own_error, little = arrives < most ? 0.25 * most : 0.5 * arrives;
        if (part->count == 0 && part->error > most && part->own_error > little)
            failed = cut(reflected, p);
    }
    return failed;
}

luxel_status lx_parts_refine(struct lx_radiosity *reflected, const double *allowed)
{
    enum { MOST_LEVELS = 8 };
    luxel_status status = LUXEL_OK;
    for (int level = 0; level < MOST_LEVELS && status == LUXEL_OK; level++) {
        const size_t first = reflected->part_count;
        if (cut_some(reflected, allowed))
            return LUXEL_ERROR_MEMORY;
        if (reflected->part_count == first)
            break;
        status = fill_from(reflected, first);
    }
    return status;
}

/* ---- asking ---- */

static double beyond_window(const struct lx_window *window, const double at[2])
{
    return fmax(fabs(at[0] - window->middle[0]) - window->half[0], fabs(at[1] - window->middle[1]) - window->half[1]);
}

static double clamp(double x)
{
    return fmin(fmax(x, -1), 1);
}

lx_bounded lx_parts_value(const struct lx_radiosity *reflected, size_t tile, const double at[2])
{
    const struct lx_shown_part *part = &reflected->parts[tile];
    while (part->count > 0) {
        const struct lx_shown_part *children = &reflected->parts[part->first], *nearest = children;
        for (unsigned i = 1; i < part->count; i++)
            if (beyond_window(&children[i].window, at) < beyond_window(&nearest->window, at))
                nearest = &children[i];
        part = nearest;
    }
    const double x = clamp((at[0] - part->window.middle[0]) / part->window.half[0]);
    const double y = clamp((at[1] - part->window.middle[1]) / part->window.half[1]);
    return (lx_bounded){fmax(lx_rule_value(part->nodes, x, y), 0), part->error};
}

double lx_parts_arriving(const struct lx_radiosity *reflected, const double *allowed)
{
    double greatest = 0;
    for (size_t p = 0; p < reflected->part_count; p++) {
        const struct lx_shown_part *part = &reflected->parts[p];
        if (part->count == 0)
            greatest = fmax(greatest, (part->error - part->own_error) / allowed[part->tile]);
    }
    return greatest;
}

double lx_parts_showing(const struct lx_radiosity *reflected, const double *allowed)
{
    double greatest = 0;
    for (size_t p = 0; p < reflected->part_count; p++)
        if (reflected->parts[p].count == 0 && reflected->parts[p].error > 0)
            greatest = fmax(greatest, reflected->parts[p].error / allowed[reflected->parts[p].tile]);
    return greatest;
}

/* ---- what is worst ---- */

struct worst {
    double excess; /* beside what is allowed */
    size_t part;
};

static int by_excess(const void *a, const void *b)
{
    const struct worst *x = a, *y = b;
    return x->excess != y->excess ? (x->excess < y->excess ? 1 : -1) : (x->part > y->part) - (x->part < y->part);
}

static struct lx_receiver receiver_of(const struct lx_radiosity *reflected, const struct lx_shown_part *part)
{
    const struct lx_matte_face *face = &reflected->faces[reflected->tiles[part->tile].face];
    struct lx_receiver receiver = {.own = face->surface};
    struct lx_tile_cell cell;
    lx_cell_make(face, &part->window, &cell);
    memcpy(receiver.place_mm, cell.place_mm[part->worst], sizeof receiver.place_mm);
    memcpy(receiver.normal, cell.normal[part->worst], sizeof receiver.normal);
    return receiver;
}

int lx_parts_worst(const struct lx_radiosity *reflected, const double *allowed, double share, size_t most,
                   struct lx_reflected_place *places)
{
    struct worst *worst = lx_new_array(reflected->part_count, sizeof *worst);
    size_t count = 0;
    if (!worst)
        return -1;
    for (size_t p = 0; p < reflected->part_count; p++) {
        const struct lx_shown_part *part = &reflected->parts[p];
        const double arrives = part->error - part->own_error, limit = allowed[part->tile];
        if (part->count == 0 && part->error > limit && arrives > share * limit)
            worst[count++] = (struct worst){arrives / limit, p};
    }
    if (count > 1)
        qsort(worst, count, sizeof *worst, by_excess);
    for (size_t i = 0; i < count && i < most; i++)
        places[i] = (struct lx_reflected_place){.receiver = receiver_of(reflected, &reflected->parts[worst[i].part])};
    free(worst);
    return (int)(count < most ? count : most);
}

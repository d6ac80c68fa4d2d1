/* SPDX-License-Identifier: MIT */
/*
 * The true extrema on a measuring plane, between the points of its grid: looked for on a lattice that holds the
 * centres, the sides and the corners of all cells, and at the ends of candidate rays, where they may be narrower than
 * that; and refined from the best places by steps of ever half the length to the best of eight around, which jumps and
 * kinks do not mislead.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "../base/rows.h"
#include "../base/vector.h"
#include "../flux/candidate_rays.h"
#include "../scene/scene.h"
#include "../world/bodies.h"
#include "../world/evaluate.h"
#include "../world/world.h"
#include "color_worlds.h"
#include "grid_measuring.h"
#include "reflecting.h"
#include "refuse.h"
#include "session.h"

/* Nodes of the lattice that are wanted where light is quickly told, and rays that are followed; from how many of
 * either the search goes on; and how often its steps are halved. */
enum { WANTED_NODES = 6000, MOST_RAYS = 1000, STARTS = 6, HALVINGS = 26 };
enum { MOST_RAYS_COSTLY = 64, STARTS_COSTLY = 2, HALVINGS_COSTLY = 16 };
/* Looks around of one climb, at most, and how often a ridge's way is looked for more closely at one place. */
enum { MOST_LOOKS = 600, CLOSER = 3 };
/* The share of the fall at twice the step that is more than that of a level peak, a quarter. */
static const double STEEP = 0.35;
/* Below this step, of the lattice's, the fall around tells how far a climb may lead. */
static const double SURE = 0.1;
/* Where all around falls off by a smaller share together, a climb is at its end. */
static const double LEVEL = 1e-14, LEVEL_COSTLY = 1e-7;

/* The tolerance of integrals while places are compared; what is as far as that tells is asked again. */
static const double WHILE_SEARCHING = 1e-6;

/* A place of the plane, in mm from its middle, with what falls on it. */
struct node {
    double at[2];
    lx_bounded value;
    bool has_value; /* false: it lies on a source, or inside a body */
};

struct search {
    struct lx_world world;
    struct lx_prepared hasty; /* the scene, with that tolerance */
    struct lx_control *control;
    struct lx_plane_measure measure;
    struct lx_cells cells;
    struct lx_bodies bodies; /* in which nothing is looked for */
    bool is_costly;
    unsigned threads;
    unsigned n[2];      /* of the lattice */
    struct node *nodes; /* of the lattice, then where rays end */
    size_t count;
    const struct lx_color_worlds *worlds; /* whose sum it is; NULL: it is the world's own light */
    size_t adding;                        /* the part whose reflected light is found */
};

/* The world that a part of the light is asked of. */
static const struct lx_world *world_of(const struct search *search, size_t part)
{
    return search->worlds ? &search->worlds->sessions[part].world : &search->world;
}

/* The elements of some nodes, at most a batch of them. */
static void place_nodes(const struct search *search, const struct lx_world *world, const struct node *nodes,
                        unsigned count, struct lx_elements *elements)
{
    lx_elements_begin(elements, &search->measure.lobe, true);
    for (unsigned i = 0; i < count; i++) {
        double place_mm[3];
        lx_place_on_cells(&search->cells, nodes[i].at, place_mm);
        lx_elements_append_place(elements, lx_exact3(place_mm), search->cells.normal, NULL);
    }
    lx_elements_end(elements);
    lx_world_settle(world, &(struct lx_settling){.has_normals = true}, elements);
}

/* Asks one world for the light at some nodes. */
static void ask(const struct search *search, const struct lx_world *world, const struct node *nodes, unsigned count,
                bool is_caller, struct lx_received *received)
{
    const struct lx_asking asking = {.control = search->control, .is_caller = is_caller};
    struct lx_elements elements;
    place_nodes(search, world, nodes, count, &elements);
    lx_plane_light(world, &search->measure, &elements, &asking, received);
}

/* The irradiance of some nodes, at most a batch of them. */
static void look(const struct search *search, struct node *nodes, unsigned count, bool is_caller)
{
    struct lx_received received;
    bool is_any = false;
    for (unsigned i = 0; i < count; i++) {
        double place_mm[3];
        lx_place_on_cells(&search->cells, nodes[i].at, place_mm);
        nodes[i].has_value = !lx_body_around(&search->bodies, place_mm);
        is_any = is_any || nodes[i].has_value;
    }
    for (size_t p = 0; is_any && p < (search->worlds ? search->worlds->parts.count : 1); p++) {
        const struct lx_world *world = world_of(search, p);
        ask(search, world, nodes, count, is_caller, &received);
        for (unsigned i = 0; i < count; i++) {
            const lx_bounded light = lx_received_on_plane(world, &received, i);
            const lx_bounded before = p > 0 ? nodes[i].value : lx_exact(0);
            nodes[i].value =
                search->worlds ? lx_add_part(before, search->worlds->parts.list[p].luminance, light.value, light.error)
                               : light;
            nodes[i].has_value = nodes[i].has_value && !received.on_element[i] && isfinite(nodes[i].value.value);
        }
    }
}

/* ---- the lattice ---- */

static void look_at_nodes(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct search *search = data;
    const struct lx_asking asking = {.control = search->control, .is_caller = is_caller};
    (void)worker;
    for (unsigned i = first; i < last && lx_asking_goes_on(&asking); i += LX_BATCH)
        look(search, &search->nodes[i], last - i < LX_BATCH ? last - i : LX_BATCH, is_caller);
}

/* Looks at that many nodes by all threads; false: nobody waits any more.  The progress counts those of the lattice. */
static bool look_at_all(struct search *search, size_t count, bool is_lattice)
{
    const struct lx_rows_part part = {.last = (unsigned)count,
                                      .tile_rows = lx_world_batch(&search->world),
                                      .counts_itself = !is_lattice,
                                      .work = look_at_nodes,
                                      .data = search};
    return lx_rows_run_part(search->control, lx_thread_count(search->threads, (unsigned)(count / 4 + 1)), &part);
}

/* Two nodes a cell each way, so that centres and sides are among them, or an even multiple.  0, or -1. */
static int make_lattice(struct search *search)
{
    const unsigned *n = search->cells.n;
    const double wanted = search->is_costly ? 0 : WANTED_NODES;
    const double more = fmax(floor(sqrt(wanted / (4.0 * n[0] * n[1]))), 1);
    search->count = 1;
    for (int i = 0; i < 2; i++) {
        search->n[i] = 2 * (unsigned)more * n[i] + 1;
        search->count *= search->n[i];
    }
    if (search->count > UINT32_MAX - 2 * MOST_RAYS)
        return -1;
    search->nodes = lx_new_array(search->count, sizeof *search->nodes);
    for (size_t i = 0; search->nodes && i < search->count; i++) {
        const double column = (double)(i % search->n[0]), row = (double)(i / search->n[0]);
        search->nodes[i].at[0] = search->cells.size_mm[0] * (column / (search->n[0] - 1) - 0.5);
        search->nodes[i].at[1] = search->cells.size_mm[1] * (0.5 - row / (search->n[1] - 1));
    }
    return search->nodes ? 0 : -1;
}

/* Where a ray meets the plane, or, a little off what is measured of it, the next place there; false: neither. */
static bool end_of(const struct search *search, const struct lx_candidate_ray *ray, double at[2])
{
    const struct lx_pose *pose = &search->cells.pose;
    const lx_bounded3 sides[3] = {lx_wide3_direction(pose->across), lx_wide3_direction(pose->upward),
                                  search->cells.normal};
    double from[3], way[3];
    for (int i = 0; i < 3; i++) {
        const double side[3] = {sides[i].x.value, sides[i].y.value, sides[i].z.value};
        const double offset[3] = {ray->from_mm[0] - search->cells.center_mm[0],
                                  ray->from_mm[1] - search->cells.center_mm[1],
                                  ray->from_mm[2] - search->cells.center_mm[2]};
        from[i] = lx_dot(side, offset);
        way[i] = lx_dot(side, ray->way);
    }
    if (!(from[2] >= 0 && way[2] < 0))
        return false;
    for (int i = 0; i < 2; i++) {
        const double half = search->cells.size_mm[i] / 2, place = from[i] - way[i] * (from[2] / way[2]);
        if (!(fabs(place) <= 2 * half))
            return false;
        at[i] = fmax(-half, fmin(place, half));
    }
    return true;
}

/* Adds the places where rays end.  0, or -1: memory ran out. */
static int add_candidate_rays(struct search *search)
{
    const lx_bounded3 *normal = &search->cells.normal;
    const double downward[3] = {-normal->x.value, -normal->y.value, -normal->z.value};
    struct lx_candidate_rays rays = {.count = 0};
    size_t capacity = search->count;
    int result = lx_candidate_rays_make(search->world.prepared, downward,
                                        search->is_costly ? MOST_RAYS_COSTLY : MOST_RAYS, &rays);
    if (result == 0)
        result = lx_reserve(&search->nodes, &capacity, search->count + rays.count, sizeof *search->nodes);
    for (size_t i = 0; result == 0 && i < rays.count; i++)
        search->count += end_of(search, &rays.items[i], search->nodes[search->count].at);
    lx_candidate_rays_clear(&rays);
    return result;
}

/* ---- the climb ---- */

/* Whether one node is further that way than another. */
static bool is_beyond(const struct node *a, const struct node *b, double sign)
{
    return a->has_value && (!b->has_value || sign * a->value.value > sign * b->value.value);
}

/* Whether none of its neighbours is further that way. */
static bool is_peak(const struct search *search, size_t i, double sign)
{
    const long column = (long)(i % search->n[0]), row = (long)(i / search->n[0]);
    for (long k = 0; k < 9; k++) {
        const long u = column + k % 3 - 1, v = row + k / 3 - 1;
        if (u >= 0 && v >= 0 && u < (long)search->n[0] && v < (long)search->n[1] &&
            is_beyond(&search->nodes[(size_t)v * search->n[0] + (size_t)u], &search->nodes[i], sign))
            return false;
    }
    return search->nodes[i].has_value;
}

/* Whether the end of a ray is further that way than the nodes around it, which else lead on as well. */
static bool is_beyond_nodes(const struct search *search, const struct node *end, double sign)
{
    const double column = (0.5 + end->at[0] / search->cells.size_mm[0]) * (search->n[0] - 1);
    const double row = (0.5 - end->at[1] / search->cells.size_mm[1]) * (search->n[1] - 1);
    for (unsigned v = (unsigned)floor(row); v <= ceil(row); v++)
        for (unsigned u = (unsigned)floor(column); u <= ceil(column); u++)
            if (!is_beyond(end, &search->nodes[(size_t)v * search->n[0] + u], sign))
                return false;
    return true;
}

/* The best peaks of the lattice, or the best of the rays' ends, the first of equal ones; returns how many. */
static unsigned find_starts(const struct search *search, bool of_rays, double sign, struct node starts[STARTS])
{
    const unsigned most = search->is_costly ? STARTS_COSTLY : STARTS;
    const size_t lattice = (size_t)search->n[0] * search->n[1];
    unsigned count = 0;
    for (size_t i = of_rays ? lattice : 0; i < (of_rays ? search->count : lattice); i++) {
        const struct node *node = &search->nodes[i];
        if ((count == most && !is_beyond(node, &starts[most - 1], sign)) ||
            !(of_rays ? is_beyond_nodes(search, node, sign) : is_peak(search, i, sign)))
            continue;
        unsigned at = count < most ? count++ : most - 1;
        for (; at > 0 && is_beyond(node, &starts[at - 1], sign); at--)
            starts[at] = starts[at - 1];
        starts[at] = *node;
    }
    return count;
}

/* Looks at eight places around a node, on a circle by the nodes of the lattice, from an angle on; the furthest. */
static int look_around(const struct search *search, double sign, const struct node *middle, double step, double angle,
                       double apart, struct node around[8])
{
    int furthest = 0;
    for (int k = 0; k < 8; k++) {
        const double to[2] = {cos(angle + k * apart), sin(angle + k * apart)};
        for (int i = 0; i < 2; i++) {
            const double half = search->cells.size_mm[i] / 2, node_mm = 2 * half / (search->n[i] - 1);
            around[k].at[i] = fmax(-half, fmin(middle->at[i] + step * to[i] * node_mm, half));
        }
    }
    look(search, around, 8, true);
    for (int k = 1; k < 8; k++)
        if (is_beyond(&around[k], &around[furthest], sign))
            furthest = k;
    return furthest;
}

/* How much less far all around is together. */
static double fall_of(const struct node *middle, const struct node around[8], double sign)
{
    double fall = 0;
    for (int k = 0; k < 8; k++)
        fall += around[k].has_value ? sign * (middle->value.value - around[k].value.value) : 0;
    return fall;
}

/* Whether a climb may come beyond what was found before, which it does not where that lies within its step, or where
 * it is farther from it than all around falls off. */
static bool may_go_beyond(const struct search *search, const struct node *here, const struct node *found, double sign,
                          double step, double fall)
{
    bool is_near = true;
    for (int i = 0; i < 2; i++)
        is_near = is_near && fabs(here->at[i] - found->at[i]) <= step * search->cells.size_mm[i] / (search->n[i] - 1);
    return is_beyond(here, found, sign) || (!is_near && sign * (found->value.value - here->value.value) < fall);
}

/*
 * Goes from a node to the best of eight around it.  Steps along one way grow; where none leads on, they are halved.
 * A place that falls off by more than a quarter of its fall at twice the step is no level peak but may be a ridge,
 * whose way is looked for more closely.  A climb is given up where it does not come beyond what was `found` before.
 */
static void climb(const struct search *search, double sign, const struct node *found, struct node *best)
{
    const struct lx_asking asking = {.control = search->control, .is_caller = true};
    const double level = search->is_costly ? LEVEL_COSTLY : LEVEL;
    int left = search->is_costly ? HALVINGS_COSTLY : HALVINGS;
    double step = 1, angle = 0, last_fall = 0;
    for (int looks = 0; left > 0 && looks < MOST_LOOKS && lx_asking_goes_on(&asking); looks++) {
        struct node around[8];
        double apart = M_PI / 4;
        int k = look_around(search, sign, best, step, angle, apart, around);
        const double fall = fall_of(best, around, sign);
        const bool is_ahead = k == 0;
        angle += k * apart;
        if (fall > STEEP * last_fall && is_beyond(best, &around[k], sign))
            for (int i = 0; i < CLOSER && !is_beyond(&around[k], best, sign); i++, looks++) {
                const double closer = 2 * apart / 9;
                k = look_around(search, sign, best, step, angle - apart + closer, closer, around);
                angle += (k + 1) * closer - apart;
                apart = closer;
            }
        last_fall = fall;
        if (!is_beyond(&around[k], best, sign)) {
            left--;
            step /= 2;
            if (step < SURE &&
                (fall <= level * fabs(best->value.value) || !may_go_beyond(search, best, found, sign, step, fall)))
                return;
            continue;
        }
        *best = around[k];
        if (is_ahead && looks > 0 && step < 1) {
            left++;
            step *= 2;
        }
    }
}

/* Whether a node may be further that way than another, for all that their errors say. */
static bool may_be_beyond(const struct node *a, const struct node *b, double sign)
{
    return a->has_value && sign * (a->value.value - b->value.value) > -(a->value.error + b->value.error);
}

/* Asks for the best node, and all of the lattice that may be better, to the tolerance of the results; false: memory ran
 * out, or nobody waits any more. */
static bool settle(const struct search *search, const struct lx_prepared *prepared, double sign, struct node *best)
{
    const size_t all = search->count;
    struct search exact = *search;
    size_t count = 1;
    for (size_t i = 0; i < all; i++)
        count += may_be_beyond(&search->nodes[i], best, sign);
    exact.world.prepared = prepared;
    exact.nodes = lx_new_array(count, sizeof *exact.nodes);
    if (!exact.nodes)
        return false;
    exact.nodes[0] = *best;
    for (size_t i = 0, next = 1; i < all; i++)
        if (may_be_beyond(&search->nodes[i], best, sign))
            exact.nodes[next++] = search->nodes[i];
    const bool is_whole = look_at_all(&exact, count, false);
    *best = exact.nodes[0];
    for (size_t i = 1; i < count; i++)
        if (is_beyond(&exact.nodes[i], best, sign))
            *best = exact.nodes[i];
    free(exact.nodes);
    return is_whole;
}

static luxel_grid_peak peak_of(const struct search *search, const struct node *node)
{
    luxel_grid_peak peak = {.exists = node->has_value};
    if (!node->has_value)
        return peak;
    peak.value = node->value.value;
    peak.error = lx_reported(node->value).error;
    lx_place_on_cells(&search->cells, node->at, peak.position_mm);
    memcpy(peak.on_plane_mm, node->at, sizeof peak.on_plane_mm);
    return peak;
}

/* False: memory ran out, or nobody waits any more. */
static bool find_peak(const struct search *search, const struct lx_prepared *prepared, double sign,
                      luxel_grid_peak *peak)
{
    struct node lattice[STARTS], ends[STARTS], best = {.has_value = false};
    const unsigned of_lattice = find_starts(search, false, sign, lattice);
    const unsigned of_rays = find_starts(search, true, sign, ends);
    for (unsigned i = 0, k = 0; i + k < of_lattice + of_rays;) { /* the best first */
        const bool is_lead = i == of_lattice || (k < of_rays && is_beyond(&ends[k], &lattice[i], sign));
        struct node *start = is_lead ? &ends[k++] : &lattice[i++];
        climb(search, sign, &best, start);
        if (is_beyond(start, &best, sign))
            best = *start;
    }
    if (best.has_value && search->hasty.tolerance > prepared->tolerance && !settle(search, prepared, sign, &best))
        return false;
    *peak = peak_of(search, &best);
    return true;
}

/* ---- with reflected light ---- */

/* The element of a node that has a value, and that. */
static bool element_of(const void *data, size_t i, struct lx_element *element, double *direct)
{
    const struct search *search = data;
    struct lx_elements elements;
    if (!search->nodes[i].has_value)
        return false;
    const struct lx_world *world = world_of(search, search->adding);
    place_nodes(search, world, &search->nodes[i], 1, &elements);
    *element = lx_elements_get(world->prepared, &elements, 0);
    *direct = search->nodes[i].value.value;
    return true;
}

static void take_reflected(void *data, size_t i, lx_bounded irradiance)
{
    const struct search *search = data;
    struct node *node = &search->nodes[i];
    node->value = search->worlds ? lx_add_part(node->value, search->worlds->parts.list[search->adding].luminance,
                                               irradiance.value, irradiance.error)
                                 : lx_add(node->value, irradiance);
}

/* Adds what is reflected to the nodes of the lattice, by the solution that was found for the plane, if there is one. */
static luxel_status add_reflected(const luxel_scene *scene, struct lx_session *session, size_t grid,
                                  struct search *search, luxel_diagnostics *diagnostics)
{
    const struct lx_reflected_key key = lx_reflected_key_of_plane(session, grid);
    const struct lx_reflecting reflecting = {search->control,
                                             search->count,
                                             element_of,
                                             take_reflected,
                                             search,
                                             lx_scene_reflected_on_plane(scene),
                                             &key,
                                             lx_plane_response(&search->measure)};
    const bool is_shared = session->world.reflected != NULL;
    if (!is_shared)
        session->world.reflected = lx_reflected_of_plane(scene, session, grid);
    return lx_reflect_places(session, &reflecting, !is_shared && session->world.reflected, diagnostics);
}

/* ---- in colour ---- */

/* Adds what is reflected in the parts to the nodes. */
static luxel_status add_parts(struct search *search, size_t grid, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    const struct lx_color_worlds *worlds = search->worlds;
    for (search->adding = 0; search->adding < worlds->parts.count && status == LUXEL_OK; search->adding++)
        status = add_reflected(worlds->parts.list[search->adding].scene, &worlds->sessions[search->adding], grid,
                               search, diagnostics);
    return status;
}

/* The channels at a peak, by the parts, whose worlds know what is reflected. */
static void color_peak(const struct search *search, luxel_grid_peak *peak)
{
    const struct node node = {.at = {peak->on_plane_mm[0], peak->on_plane_mm[1]}};
    if (!peak->exists)
        return;
    for (size_t p = 0; p < search->worlds->parts.count; p++) {
        const struct lx_world *world = world_of(search, p);
        struct lx_received received;
        ask(search, world, &node, 1, true, &received);
        lx_color_add(&search->worlds->parts.list[p], lx_received_on_plane(world, &received, 0), &peak->color);
    }
}

/* The channels of both peaks, by parts whose worlds know what is reflected, or find it here. */
static luxel_status color_peaks(struct search *search, size_t grid, bool reflects, luxel_diagnostics *diagnostics,
                                luxel_grid_extrema *extrema)
{
    luxel_grid_peak *const peaks[] = {&extrema->minimum, &extrema->maximum};
    struct node nodes[2] = {{.has_value = false}, {.has_value = false}};
    struct lx_control control = {.rows = 1};
    luxel_status status = LUXEL_OK;
    search->control = &control;
    if (reflects && !world_of(search, 0)->reflected) {
        struct search both = *search;
        both.nodes = nodes;
        both.count = LX_COUNT(nodes);
        for (size_t i = 0; i < LX_COUNT(nodes); i++) {
            memcpy(nodes[i].at, peaks[i]->on_plane_mm, sizeof nodes[i].at);
            nodes[i].value = (lx_bounded){peaks[i]->value, peaks[i]->error};
            nodes[i].has_value = peaks[i]->exists;
        }
        status = add_parts(&both, grid, diagnostics);
    }
    for (size_t i = 0; i < LX_COUNT(peaks) && status == LUXEL_OK; i++)
        color_peak(search, peaks[i]);
    return status;
}

/* ---- the plane ---- */

static luxel_status run(const luxel_scene *scene, struct lx_session *session, size_t i, const struct lx_grid *grid,
                        struct search *search, luxel_diagnostics *diagnostics, luxel_grid_extrema *extrema)
{
    const bool reflects = lx_wants_reflections(session->prepared.scene);
    search->cells = lx_cells_of(grid);
    search->measure = lx_plane_measure_of((enum lx_measure)grid->measure, &search->cells);
    search->is_costly = reflects || lx_world_batch(&search->world) < LX_BATCH;
    if (make_lattice(search) || add_candidate_rays(search) ||
        lx_bodies_find(&session->prepared, &search->cells, &search->bodies))
        return lx_out_of_memory(diagnostics);
    struct lx_control control = {.rows = (unsigned)search->count,
                                 .progress = session->settings.progress,
                                 .data = session->settings.progress_data};
    search->control = &control;
    search->threads = session->settings.threads;
    if (!look_at_all(search, control.rows, true))
        return LUXEL_CANCELLED;
    const luxel_status status = !reflects        ? LUXEL_OK
                                : search->worlds ? add_parts(search, i, diagnostics)
                                                 : add_reflected(scene, session, i, search, diagnostics);
    if (status != LUXEL_OK)
        return status;
    search->world.reflected = session->world.reflected; /* places that are looked at from now on have it */
    if ((!find_peak(search, &session->prepared, 1, &extrema->maximum) ||
         !find_peak(search, &session->prepared, -1, &extrema->minimum)) &&
        !atomic_load(&control.stop))
        return lx_out_of_memory(diagnostics);
    return atomic_load(&control.stop) ? LUXEL_CANCELLED : LUXEL_OK;
}

/* Looks for the extrema of a scene in colour, of the parts' sum or of its own light, and for their channels. */
static luxel_status run_in_color(const luxel_scene *scene, struct lx_session *session, size_t i,
                                 const struct lx_grid *grid, struct search *search, luxel_diagnostics *diagnostics,
                                 luxel_grid_extrema *extrema)
{
    luxel_grid_peak *const peaks[] = {&extrema->minimum, &extrema->maximum};
    struct lx_color_worlds worlds;
    luxel_status status = lx_color_worlds_begin(scene, &session->settings, diagnostics, &worlds);
    if (status == LUXEL_OK && worlds.parts.is_sum) {
        status = lx_color_worlds_open(&worlds, diagnostics);
        search->worlds = &worlds;
    }
    if (status == LUXEL_OK)
        status = run(scene, session, i, grid, search, diagnostics, extrema);
    for (size_t k = 0; k < LX_COUNT(peaks) && status == LUXEL_OK && worlds.parts.is_single; k++)
        if (peaks[k]->exists)
            lx_color_add(&worlds.parts.list[0], (lx_bounded){peaks[k]->value, peaks[k]->error}, &peaks[k]->color);
    if (status == LUXEL_OK && !worlds.parts.is_sum && !worlds.parts.is_single) {
        status = lx_color_worlds_open(&worlds, diagnostics);
        search->worlds = &worlds;
    }
    if (status == LUXEL_OK && !worlds.parts.is_single)
        status = color_peaks(search, i, lx_wants_reflections(session->prepared.scene), diagnostics, extrema);
    lx_color_worlds_clear(&worlds);
    return status;
}

luxel_status luxel_find_grid_extrema(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                     luxel_diagnostics *diagnostics, luxel_grid_extrema *extrema)
{
    struct lx_session session;
    struct search search = {.world.prepared = &search.hasty};
    luxel_grid_extrema found = {.minimum.exists = false};
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    const struct lx_grid *grid = status == LUXEL_OK ? lx_asked_grid(scene, i, extrema, "extrema", diagnostics) : NULL;
    if (status == LUXEL_OK && !grid)
        status = LUXEL_ERROR_ARGUMENT;
    const bool in_color = status == LUXEL_OK && luxel_scene_has_color(scene);
    if (status == LUXEL_OK) {
        search.world.kernels = session.world.kernels;
        search.world.reflect = session.world.reflect;
        search.hasty = session.prepared;
        if (!lx_wants_reflections(session.prepared.scene)) /* else nothing is asked again */
            search.hasty.tolerance = fmax(session.prepared.tolerance, WHILE_SEARCHING);
        if (!(in_color && lx_is_sum_of_channels(lx_scene_parameters(scene), LUXEL_IRRADIANCE)))
            status = lx_reflect_shared(scene, &session, diagnostics);
    }
    if (status == LUXEL_OK)
        status = (in_color ? run_in_color : run)(scene, &session, i, grid, &search, diagnostics, &found);
    free(search.nodes);
    lx_bodies_clear(&search.bodies);
    lx_session_clear(&session);
    if (status == LUXEL_OK)
        *extrema = found;
    return status;
}

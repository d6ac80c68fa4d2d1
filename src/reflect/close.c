/* SPDX-License-Identifier: MIT */
/* Finding and asking what a place sees from close by. */
#include "close.h"

#include <math.h>

#include "../base/vector.h"
#include "doubt.h"
#include "links.h"
#include "solution.h"

/* A place stands for cells no larger than this share of its distance; and it is asked when it is no farther than a
 * share of the scene's size, and so large in the view. */
static const double SMALL = 0.5, CLOSE = 1.0 / 16, LEAST_SHARE = 1.0 / 64;
/* The light of windows that are smaller than this share of the distance cancels as from afar. */
static const double SMOOTH = 0.25;
enum { MOST_LEVELS = 24 };

/* One face before a receiver. */
struct looking {
    const struct lx_receiver *from;
    const struct lx_occluder_cones *cones;
    const struct lx_matte_face *face;
    uint32_t number;
    double most_mm;
    struct lx_close_place *found;
    size_t count;
};

static void add_place(struct looking *looking, const struct lx_window *window, struct lx_tile_cell *cell)
{
    struct lx_close_place made = {.receiver = {.own = looking->face->surface},
                                  .face = looking->number,
                                  .at = {window->middle[0], window->middle[1]}};
    struct lx_receiver *there = &made.receiver;
    double way[3];
    lx_sheet_place(&looking->face->sheet, made.at[0], made.at[1], there->place_mm, there->normal);
    for (int i = 0; i < 3; i++)
        way[i] = there->place_mm[i] - looking->from->place_mm[i];
    const double distance = sqrt(lx_dot(way, way));
    lx_cell_nodes(looking->face, window, cell);
    for (int q = 0; q < LX_RULE_NODES; q++)
        made.share += cell->area[q] * lx_kernel_at(looking->from, cell->place_mm[q], cell->normal[q]);
    there->smooth_mm = SMOOTH * distance;
    if (distance <= looking->most_mm && made.share >= LEAST_SHARE && looking->count < LX_MOST_CLOSE &&
        lx_occluder_cones_leave(looking->cones, there->place_mm))
        looking->found[looking->count++] = made;
}

static void look(struct looking *looking, const struct lx_window *window, int level)
{
    struct lx_tile_cell cell;
    double way[3];
    lx_cell_bound(looking->face, window, &cell);
    for (int i = 0; i < 3; i++)
        way[i] = cell.center_mm[i] - looking->from->place_mm[i];
    const double distance = sqrt(lx_dot(way, way)), radius = cell.radius_mm, nearest = distance - radius;
    if (nearest > looking->most_mm || (nearest > 0 && radius * radius < LEAST_SHARE * nearest * nearest))
        return;
    if (radius <= SMALL * distance || level == MOST_LEVELS) {
        add_place(looking, window, &cell);
        return;
    }
    const int longer = cell.lengths_mm[1] > cell.lengths_mm[0];
    for (int i = 0; i < 2; i++) {
        const struct lx_window half = lx_window_half(window, longer, i);
        look(looking, &half, level + 1);
    }
}

size_t lx_close_find(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                     const struct lx_receiver *receiver, struct lx_occluder_cones *cones,
                     struct lx_close_place found[LX_MOST_CLOSE])
{
    const struct lx_window whole = {{0, 0}, {1, 1}};
    struct looking looking = {.from = receiver, .cones = cones, .most_mm = CLOSE * reflected->size_mm, .found = found};
    cones->boxes = &reflected->boxes;
    for (size_t f = 0; f < reflected->face_count; f++) {
        const struct lx_matte_face *face = &reflected->faces[f];
        double way[3];
        for (int i = 0; i < 3; i++)
            way[i] = face->center_mm[i] - receiver->place_mm[i];
        looking.face = face;
        looking.number = (uint32_t)f;
        if (sqrt(lx_dot(way, way)) - face->radius_mm <= looking.most_mm && face->reflectance > 0 &&
            lx_greatest_kernel(receiver, face, &face->cell) > 0 &&
            lx_occluder_cones_set(prepared, receiver, face, f, reflected->size_mm, cones))
            look(&looking, &whole, 0);
    }
    return looking.count;
}

/* The tile that has a place of its face; on an edge either one. */
static size_t tile_of(const struct lx_radiosity *reflected, const struct lx_close_place *place)
{
    size_t found = reflected->first_tile[place->face];
    double least = HUGE_VAL;
    for (size_t t = found; t < reflected->first_tile[place->face + 1]; t++) {
        const struct lx_window *window = &reflected->tiles[t].window;
        const double away = fmax(fabs(place->at[0] - window->middle[0]) / window->half[0],
                                 fabs(place->at[1] - window->middle[1]) / window->half[1]);
        if (away < least) {
            least = away;
            found = t;
        }
    }
    return found;
}

/* The residual there counts as far as the slack has it not; errors of direct light, as windows around tell. */
static double error_at(const struct lx_radiosity *reflected, const struct lx_links *links,
                       const struct lx_close_place *place, size_t t)
{
    const struct lx_window *window = &reflected->tiles[t].window;
    const size_t nodes = t * LX_RULE_NODES;
    double at[2];
    for (int k = 0; k < 2; k++)
        at[k] = fmax(-1, fmin((place->at[k] - window->middle[k]) / window->half[k], 1));
    const struct lx_arrival sent = lx_links_sum(reflected, links, &(struct lx_light){reflected->sent, NULL});
    const double residual = sent.value - lx_rule_value(reflected->indirect + nodes, at[0], at[1]);
    const double known = lx_rule_value(reflected->slack + nodes, at[0], at[1]);
    return fmax(LX_BETWEEN_FACTOR * fabs(residual) - fmax(known, 0), 0) + lx_links_unsure_near(reflected, links);
}

size_t lx_close_ask(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                    const struct lx_receiver *receiver, struct lx_occluder_cones *cones,
                    struct lx_close_error found[LX_MOST_CLOSE])
{
    struct lx_close_place places[LX_MOST_CLOSE];
    if (reflected->bounces == 1 || reflected->near_count == 0)
        return 0;
    const size_t count = lx_close_find(reflected, prepared, receiver, cones, places);
    for (size_t i = 0; i < count; i++) {
        struct lx_links links = {0};
        const size_t t = tile_of(reflected, &places[i]);
        lx_links_find(reflected, prepared, &reflected->coarse, &places[i].receiver, cones, &links);
        found[i] = (struct lx_close_error){t, reflected->faces[places[i].face].reflectance * places[i].share *
                                                  error_at(reflected, &links, &places[i], t)};
        lx_links_clear(&links);
    }
    return count;
}

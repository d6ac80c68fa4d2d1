/* SPDX-License-Identifier: MIT */
/* Finding links, and what they bring. */
#include "links.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "solution.h"

/* The effort of a face that is asked, and of the shaft to it. */
enum { FACE_EFFORT = 2, SHAFT_EFFORT = 5 };

/* Links of one receiver under way. */
struct finding {
    const struct lx_radiosity *reflected;
    const struct lx_prepared *prepared;
    const struct lx_receiver *receiver;
    const struct lx_fineness *fineness;
    struct lx_occluder_cones *cones;
    const struct lx_links *old;
    size_t next, next_weights; /* of the old ones */
    struct lx_links *made;
    struct lx_transfer transfer; /* of the face under way, once it is set */
    bool is_set, is_seen;
};

/* ---- appending ---- */

static void add_link(struct lx_links *links, uint32_t group, enum lx_link_kind kind)
{
    if (links->failed || lx_reserve(&links->items, &links->capacity, links->count + 1, sizeof *links->items))
        links->failed = true;
    else
        links->items[links->count++] = (struct lx_link){group & 0x3fffffff, (unsigned)kind & 3};
}

static struct lx_weights *add_weights(struct lx_links *links)
{
    if (links->failed ||
        lx_reserve(&links->weights, &links->weight_capacity, links->weight_count + 1, sizeof *links->weights)) {
        links->failed = true;
        return NULL;
    }
    return &links->weights[links->weight_count++];
}

static void add_sent(struct finding *finding, uint32_t group, enum lx_link_kind kind, const struct lx_sent *sent)
{
    struct lx_weights *weights = add_weights(finding->made);
    add_link(finding->made, group, kind);
    if (!weights)
        return;
    weights->group = group;
    weights->direct = sent->direct;
    weights->doubt = (float)sent->doubt;
    weights->squares = (float)sent->squares;
    for (int q = 0; q < LX_RULE_NODES; q++)
        weights->of[q] = (float)sent->weights[q];
}

/* ---- one group ---- */

/* Occluder cones before the face, where anything of it has to be looked at. */
static bool set_face(struct finding *finding, uint32_t f)
{
    const struct lx_matte_face *face = &finding->reflected->faces[f];
    const struct lx_receiver *receiver = finding->receiver;
    if (finding->is_set)
        return finding->is_seen;
    const bool is_own = lx_receives_from_own(receiver, face);
    const struct lx_shafts *shafts = &finding->cones->shafts;
    finding->is_set = true;
    finding->is_seen =
        !(shafts->of && shafts->of[f].is_none) && !(is_own && (face->is_flat || face->sheet.turn > 0)) &&
        lx_occluder_cones_set(finding->prepared, receiver, face, f, finding->reflected->size_mm, finding->cones);
    finding->transfer = lx_transfer_of(finding->fineness, receiver, finding->cones, face);
    return finding->is_seen;
}

/* Looks at a group; false: at what is in it, one by one. */
static bool look(struct finding *finding, uint32_t g)
{
    const struct lx_group *group = &finding->reflected->groups[g];
    struct lx_partly partly;
    const enum lx_outlook sight = set_face(finding, group->face)
                                      ? lx_occluder_cones_look(finding->cones, &group->cell, NULL, &partly)
                                      : LX_NONE_SEEN;
    struct lx_sent sent;
    if (sight == LX_NONE_SEEN) {
        add_link(finding->made, g, LX_LINK_NONE);
        return true;
    }
    if (sight == LX_ALL_SEEN && lx_transfer_group(&finding->transfer, group, &sent)) {
        add_sent(finding, g, LX_LINK_FAR, &sent);
        return true;
    }
    if (group->child != LX_NO_GROUP)
        return false;
    lx_transfer(&finding->transfer, &finding->reflected->tiles[group->first_tile], sight, &partly, &sent);
    add_sent(finding, g, sight == LX_ALL_SEEN ? LX_LINK_NEAR : LX_LINK_PART, &sent);
    return true;
}

/* Takes over what is known of a group, if that is still right; false: what is in it is to be asked. */
static bool keep(struct finding *finding, uint32_t g)
{
    const struct lx_links *old = finding->old;
    if (finding->next == old->count || old->items[finding->next].group != g)
        return false;
    const enum lx_link_kind kind = (enum lx_link_kind)old->items[finding->next++].kind;
    if (kind == LX_LINK_NONE) {
        add_link(finding->made, g, kind);
        return true;
    }
    const struct lx_weights *known = &old->weights[finding->next_weights++];
    if (lx_link_is_of_tile(kind) && finding->reflected->groups[g].child != LX_NO_GROUP)
        return false;
    struct lx_weights *weights = add_weights(finding->made);
    add_link(finding->made, g, kind);
    if (weights)
        *weights = *known;
    return true;
}

/* Whether all old links are right: nothing of them was cut. */
static bool is_up_to_date(const struct lx_radiosity *reflected, const struct lx_links *links)
{
    for (size_t i = 0; i < links->count; i++)
        if (lx_link_is_of_tile((enum lx_link_kind)links->items[i].kind) &&
            reflected->groups[links->items[i].group].child != LX_NO_GROUP)
            return false;
    return links->count > 0;
}

/* Gives back memory that is not needed; where that fails it stays. */
static void trim(struct lx_links *links)
{
    struct lx_link *items = links->count > 0 ? realloc(links->items, links->count * sizeof *items) : NULL;
    struct lx_weights *weights =
        links->weight_count > 0 ? realloc(links->weights, links->weight_count * sizeof *weights) : NULL;
    if (items) {
        links->items = items;
        links->capacity = links->count;
    }
    if (weights) {
        links->weights = weights;
        links->weight_capacity = links->weight_count;
    }
}

void lx_links_find(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                   const struct lx_fineness *fineness, const struct lx_receiver *receiver,
                   struct lx_occluder_cones *cones, struct lx_links *links)
{
    struct lx_links made = {.known = reflected->group_count};
    struct finding finding = {.reflected = reflected,
                              .prepared = prepared,
                              .receiver = receiver,
                              .fineness = fineness,
                              .cones = cones,
                              .old = links,
                              .made = &made};
    if (is_up_to_date(reflected, links))
        return;
    cones->boxes = &reflected->boxes;
    const size_t known = links->count > 0 ? links->known : 0;
    for (size_t f = 0; f < reflected->face_count && lx_effort_take(cones->effort, FACE_EFFORT); f++) {
        finding.is_set = false;
        for (uint32_t g = reflected->faces[f].group; g != LX_NO_GROUP;) {
            const bool is_done = g < known ? keep(&finding, g) : look(&finding, g);
            g = is_done ? lx_group_after(reflected, g) : reflected->groups[g].child;
        }
    }
    if (!lx_effort_is_left(cones->effort)) {
        lx_links_clear(&made);
        return;
    }
    lx_links_clear(links);
    trim(&made);
    *links = made;
}

void lx_links_clear(struct lx_links *links)
{
    free(links->items);
    free(links->weights);
    *links = (struct lx_links){0};
}

/* ---- sums ---- */

static double product(const float weights[LX_RULE_NODES], const double values[LX_RULE_NODES])
{
    double sums[4] = {0};
    for (int q = 0; q < LX_RULE_NODES; q += 4)
        for (int k = 0; k < 4; k++)
            sums[k] += (double)weights[q + k] * values[q + k];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/* What rounding may leave of light that cancels, or that was cut out to nothing: so much of the greatest. */
static const double ROUNDING = 1e-14;

/* Errors of a near tile's direct light as they arrive: all of it where another face lies on the tile. */
static double unsure_near(const struct lx_tile *tile, const struct lx_weights *weights)
{
    return (double)weights->doubt + (tile->is_overlaid ? fabs(weights->direct) : 0);
}

struct lx_arrival lx_links_sum(const struct lx_radiosity *reflected, const struct lx_links *links,
                               const struct lx_light *light)
{
    struct lx_arrival sum = {0};
    double squares = 0;  /* of what samples differ by, of which each is off by itself */
    double greatest = 0; /* of all light */
    size_t w = 0;
    for (size_t i = 0; i < links->count; i++) {
        if (links->items[i].kind == LX_LINK_NONE)
            continue;
        const struct lx_weights *weights = &links->weights[w++];
        const struct lx_group *group = &reflected->groups[weights->group];
        const double reflectance = reflected->faces[group->face].reflectance;
        const size_t nodes = (size_t)weights->group * LX_RULE_NODES;
        const bool is_far = links->items[i].kind == LX_LINK_FAR;
        double value = is_far ? product(weights->of, group->direct) : weights->direct;
        double total = 0, most = 0, slack = 0;
        squares += reflectance * reflectance * (double)weights->squares;
        for (int q = 0; q < LX_RULE_NODES; q++) {
            const double weight = fabs((double)weights->of[q]);
            total += (double)weights->of[q];
            if (light->slack) {
                most = fmax(most, weight / group->cell.area[q]);
                slack += weight * fabs(light->slack[nodes + (size_t)q]);
                greatest = fmax(greatest, reflectance * fabs(group->direct[q]));
                greatest = fmax(greatest, light->indirect ? reflectance * fabs(light->indirect[nodes + (size_t)q]) : 0);
            }
        }
        if (light->indirect)
            value += product(weights->of, light->indirect + nodes);
        sum.value += reflectance * value;
        if (light->slack)
            sum.slack += reflectance * (slack + (is_far ? group->unsure * most
                                                        : unsure_near(&reflected->tiles[group->first_tile], weights)));
        sum.seen += total;
    }
    sum.slack += light->slack ? sqrt(squares) + ROUNDING * greatest : 0;
    return sum;
}

double lx_links_unsure_near(const struct lx_radiosity *reflected, const struct lx_links *links)
{
    double sum = 0, squares = 0;
    size_t w = 0;
    for (size_t i = 0; i < links->count; i++) {
        if (links->items[i].kind == LX_LINK_NONE)
            continue;
        const struct lx_weights *weights = &links->weights[w++];
        const double reflectance = reflected->faces[reflected->groups[weights->group].face].reflectance;
        sum += reflectance * (double)weights->doubt;
        squares += reflectance * reflectance * (double)weights->squares;
    }
    return sum + sqrt(squares);
}

/* ---- rows ---- */

/* Nodes of a triangle, where shares of its corners are 2/3, 1/6, 1/6. */
static const double linear_at[LX_LINEAR_NODES][2] = {{0, -1.0 / 3}, {-0.6, 2.0 / 3}, {0.6, 2.0 / 3}};
/* The nearest place between the nodes that is asked: the corners, of which two lie together, and the middle. */
static const int linear_between[LX_BETWEEN] = {1, 1, 1, 6, 4, 8, 6, 8, 8};

static bool has_linear_row(int r)
{
    return r < LX_RULE_NODES ? r < LX_LINEAR_NODES : linear_between[r - LX_RULE_NODES] == r - LX_RULE_NODES;
}

void lx_rows_spread(const struct lx_rows *rows, double nodes[LX_RULE_NODES])
{
    if (!rows->is_linear)
        return;
    const double at[LX_LINEAR_NODES] = {nodes[0], nodes[1], nodes[2]};
    for (int q = 0; q < LX_RULE_NODES; q++) {
        const double away = (1 + lx_rule_places[q % LX_ORDER]) / 2, side = lx_rule_places[q / LX_ORDER];
        const double shares[LX_LINEAR_NODES] = {1 - away, away * (1 - side) / 2, away * (1 + side) / 2};
        nodes[q] = 0;
        for (int k = 0; k < LX_LINEAR_NODES; k++)
            nodes[q] += at[k] * (2 * shares[k] - 1.0 / 3);
    }
}

const struct lx_links *lx_rows_between(const struct lx_rows *rows, int p)
{
    return &rows->of[LX_RULE_NODES + (rows->is_linear ? linear_between[p] : p)];
}

int lx_rows_find(const struct lx_radiosity *reflected, uint32_t face, const struct lx_window *window,
                 const struct lx_tile_cell *cell, struct lx_occluder_cones *cones, struct lx_rows **rows)
{
    const struct lx_smooth_sheet *sheet = &reflected->faces[face].sheet;
    struct lx_receiver receiver = {.own = reflected->faces[face].surface};
    if (!*rows && !(*rows = lx_new_array(1, sizeof **rows)))
        return -1;
    (*rows)->is_linear = lx_is_linear(&reflected->faces[face], window);
    if (lx_shafts_set(reflected, cell, &cones->shafts))
        return -1;
    lx_effort_take(cones->effort, SHAFT_EFFORT * reflected->face_count);
    for (int r = 0; r < LX_ROWS && lx_effort_is_left(cones->effort); r++) {
        const bool is_node = r < LX_RULE_NODES;
        if ((*rows)->is_linear && !has_linear_row(r))
            continue;
        if ((*rows)->is_linear && is_node) {
            lx_sheet_place(sheet, linear_at[r][0], linear_at[r][1], receiver.place_mm, receiver.normal);
        } else if (is_node) {
            memcpy(receiver.place_mm, cell->place_mm[r], sizeof receiver.place_mm);
            memcpy(receiver.normal, cell->normal[r], sizeof receiver.normal);
        } else {
            double at[2];
            lx_between_place(r - LX_RULE_NODES, at);
            lx_sheet_place(sheet, window->middle[0] + at[0] * window->half[0],
                           window->middle[1] + at[1] * window->half[1], receiver.place_mm, receiver.normal);
        }
        lx_links_find(reflected, reflected->prepared, is_node ? &reflected->coarse : &reflected->fine, &receiver, cones,
                      &(*rows)->of[r]);
        if ((*rows)->of[r].failed || cones->failed)
            return -1;
    }
    return 0;
}

void lx_rows_free(struct lx_rows *rows)
{
    for (int r = 0; rows && r < LX_ROWS; r++)
        lx_links_clear(&rows->of[r]);
    free(rows);
}

/* SPDX-License-Identifier: MIT */
/* Finding closed boxes among the plates of a scene, and what follows from them. */
#include "box.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "solution.h"

/* Directions that are along one another. */
static const double ALONG = 1 - 1e-12;

/* ---- rectangles ---- */

/* A rectangle in space: a plate, or the side of a box. */
struct rectangle {
    double center_mm[3], axis[3], sides[2][3], half_mm[2];
};

static bool find_plate(const struct lx_prepared_surface *surface, struct rectangle *plate)
{
    struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
    if (lx_shape_sheets(&surface->shape, sheets) == 0 || sheets[0].type->corner_count != 4)
        return false;
    memcpy(plate->center_mm, sheets[0].center_mm, sizeof plate->center_mm);
    memcpy(plate->axis, sheets[0].axis, sizeof plate->axis);
    memcpy(plate->sides[0], sheets[0].across, sizeof plate->sides[0]);
    memcpy(plate->sides[1], sheets[0].upward, sizeof plate->sides[1]);
    memcpy(plate->half_mm, sheets[0].half_mm, sizeof plate->half_mm);
    return true;
}

static struct rectangle side_of(const struct lx_closed_box *box, int side)
{
    const int way = side / 2, first = (way + 1) % 3, second = (way + 2) % 3;
    struct rectangle made = {.half_mm = {box->half_mm[first], box->half_mm[second]}};
    for (int i = 0; i < 3; i++) {
        made.center_mm[i] = box->center_mm[i] + (side & 1 ? 1 : -1) * box->half_mm[way] * box->axes[way][i];
        made.axis[i] = box->axes[way][i];
        made.sides[0][i] = box->axes[first][i];
        made.sides[1][i] = box->axes[second][i];
    }
    return made;
}

/* Whether one rectangle has all of another on it. */
static bool covers(const struct rectangle *cover, const struct rectangle *other, double touch_mm)
{
    for (int corner = 0; corner < 4; corner++) {
        double from[3];
        for (int i = 0; i < 3; i++)
            from[i] = other->center_mm[i] - cover->center_mm[i] +
                      (corner & 1 ? 1 : -1) * other->half_mm[0] * other->sides[0][i] +
                      (corner & 2 ? 1 : -1) * other->half_mm[1] * other->sides[1][i];
        if (fabs(lx_dot(from, cover->axis)) > touch_mm)
            return false;
        for (int k = 0; k < 2; k++)
            if (fabs(lx_dot(from, cover->sides[k])) > cover->half_mm[k] + touch_mm)
                return false;
    }
    return true;
}

/* ---- boxes ---- */

/* Plates of a scene, at the numbers of their surfaces. */
struct plates {
    struct rectangle *items;
    bool *are_plates;
    size_t count;
    double size_mm; /* of the scene */
};

/* Distances in something of a size that are below rounding; places in the scene are no more exact than the second. */
static double touch_of(const struct plates *plates, double size_mm)
{
    return fmax(1e-9 * size_mm, 1e-14 * plates->size_mm);
}

/* The box that has one plate as a side and goes as far behind or before it as another one does. */
static bool reach(const struct plates *plates, const struct rectangle *plate, const struct rectangle *other,
                  struct lx_closed_box *box)
{
    double from[3], touch_mm = touch_of(plates, hypot(plate->half_mm[0], plate->half_mm[1]));
    for (int i = 0; i < 3; i++)
        from[i] = other->center_mm[i] - plate->center_mm[i];
    const double depth = lx_dot(from, plate->axis);
    if (fabs(lx_dot(plate->axis, other->axis)) > 1 - ALONG || fabs(depth) <= touch_mm)
        return false;
    memcpy(box->axes[0], plate->sides[0], sizeof box->axes[0]);
    memcpy(box->axes[1], plate->sides[1], sizeof box->axes[1]);
    memcpy(box->axes[2], plate->axis, sizeof box->axes[2]);
    box->half_mm[0] = plate->half_mm[0];
    box->half_mm[1] = plate->half_mm[1];
    box->half_mm[2] = fabs(depth);
    touch_mm = touch_of(plates, sqrt(lx_dot(box->half_mm, box->half_mm)));
    box->touch_mm = touch_mm;
    for (int i = 0; i < 3; i++)
        box->center_mm[i] = plate->center_mm[i] + depth * plate->axis[i];
    for (int side = 0; side < 4; side++) {
        const struct rectangle made = side_of(box, side);
        if (covers(other, &made, touch_mm) && covers(&made, other, touch_mm))
            return true;
    }
    return false;
}

/* Whether each side of a box is a plate, or on one. */
static bool close_sides(const struct plates *plates, struct lx_closed_box *box)
{
    for (int side = 0; side < 6; side++) {
        const struct rectangle made = side_of(box, side);
        bool is_closed = false;
        box->plates[side] = SIZE_MAX;
        for (size_t s = 0; s < plates->count && box->plates[side] == SIZE_MAX; s++) {
            if (!plates->are_plates[s] || !covers(&plates->items[s], &made, box->touch_mm))
                continue;
            is_closed = true;
            if (covers(&made, &plates->items[s], box->touch_mm))
                box->plates[side] = s;
        }
        if (!is_closed)
            return false;
    }
    return true;
}

static int add_box(struct lx_closed_boxes *boxes, const struct lx_closed_box *box)
{
    if (lx_reserve(&boxes->items, &boxes->capacity, boxes->count + 1, sizeof *boxes->items))
        return -1;
    boxes->items[boxes->count++] = *box;
    for (uint32_t side = 0; side < 6; side++)
        if (box->plates[side] != SIZE_MAX)
            boxes->sides[box->plates[side]] = (struct lx_box_side){(uint32_t)boxes->count, side};
    return 0;
}

static int find_boxes(const struct plates *plates, struct lx_closed_boxes *boxes)
{
    for (size_t s = 0; s < plates->count; s++)
        for (size_t other = 0; other < plates->count; other++) {
            struct lx_closed_box box;
            if (!plates->are_plates[s] || !plates->are_plates[other] || boxes->sides[s].box > 0)
                continue;
            if (reach(plates, &plates->items[s], &plates->items[other], &box) && close_sides(plates, &box) &&
                add_box(boxes, &box))
                return -1;
        }
    return 0;
}

int lx_closed_boxes_find(struct lx_radiosity *reflected)
{
    const size_t count = reflected->prepared->surface_count;
    struct lx_closed_boxes *boxes = &reflected->boxes;
    struct plates plates = {.items = lx_new_array(count, sizeof *plates.items),
                            .are_plates = lx_new_array(count, sizeof *plates.are_plates),
                            .count = count,
                            .size_mm = reflected->size_mm};
    boxes->sides = lx_new_array(count, sizeof *boxes->sides);
    int failed = plates.items && plates.are_plates && boxes->sides ? 0 : -1;
    for (size_t s = 0; s < count && !failed; s++)
        plates.are_plates[s] = find_plate(&reflected->prepared->surfaces[s], &plates.items[s]);
    if (!failed)
        failed = find_boxes(&plates, boxes);
    free(plates.items);
    free(plates.are_plates);
    return failed;
}

void lx_closed_boxes_clear(struct lx_closed_boxes *boxes)
{
    free(boxes->items);
    free(boxes->sides);
    *boxes = (struct lx_closed_boxes){0};
}

/* ---- asking ---- */

/* How far a place is from the middle of a box along its axes. */
static void locate(const struct lx_closed_box *box, const double place_mm[3], double at[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - box->center_mm[i];
    for (int way = 0; way < 3; way++)
        at[way] = lx_dot(from, box->axes[way]);
}

bool lx_closed_boxes_turn_away(const struct lx_closed_boxes *boxes, size_t surface, const double place_mm[3])
{
    const struct lx_box_side *side = &boxes->sides[surface];
    double at[3];
    bool is_outside = false;
    if (side->box == 0)
        return false;
    const struct lx_closed_box *box = &boxes->items[side->box - 1];
    locate(box, place_mm, at);
    for (int way = 0; way < 3; way++)
        is_outside = is_outside || fabs(at[way]) > box->half_mm[way] + box->touch_mm;
    const int way = (int)side->side / 2;
    return is_outside && (side->side & 1 ? at[way] : -at[way]) < box->half_mm[way] - box->touch_mm;
}

/* Whether all of a face is beyond a plate that is a side of a box, and some of it not in its plane, where it may
 * lie on it: nothing says then which of them is seen (overlap.h). */
static bool is_beyond(const struct lx_closed_box *box, const struct lx_matte_face *face)
{
    for (int side = 0; side < 6; side++)
        if (box->plates[side] == face->surface)
            return false;
    for (int side = 0; side < 6; side++) {
        const struct rectangle made = side_of(box, side);
        const double turn = side & 1 ? -1 : 1;
        const double inwards[3] = {turn * made.axis[0], turn * made.axis[1], turn * made.axis[2]};
        const double outwards[3] = {-inwards[0], -inwards[1], -inwards[2]};
        if (box->plates[side] != SIZE_MAX && lx_face_reach(face, inwards, made.center_mm) <= box->touch_mm &&
            lx_face_reach(face, outwards, made.center_mm) > box->touch_mm)
            return true;
    }
    return false;
}

bool lx_closed_boxes_part(const struct lx_closed_boxes *boxes, const double place_mm[3],
                          const struct lx_matte_face *face)
{
    for (size_t b = 0; b < boxes->count; b++) {
        const struct lx_closed_box *box = &boxes->items[b];
        bool is_inside = true;
        double at[3];
        locate(box, place_mm, at);
        for (int way = 0; way < 3; way++)
            is_inside = is_inside && fabs(at[way]) < box->half_mm[way] - box->touch_mm;
        if (is_inside && is_beyond(box, face))
            return true;
    }
    return false;
}

/* Whether a face is the inner side of a box. */
static bool is_inner(const struct lx_closed_box *box, const struct lx_matte_face *face)
{
    double inwards[3];
    bool is_side = false;
    for (int side = 0; side < 6; side++)
        is_side = is_side || box->plates[side] == face->surface;
    for (int i = 0; i < 3; i++)
        inwards[i] = box->center_mm[i] - face->sheet.center_mm[i];
    return is_side && face->sheet.turn * lx_dot(face->sheet.axis, inwards) > 0;
}

static bool is_outer(const struct lx_closed_box *box, const struct lx_matte_face *face)
{
    for (int side = 0; side < 6; side++)
        if (box->plates[side] == face->surface)
            return !is_inner(box, face);
    return false;
}

/* Whether an emitter may give light in a box: no sample of what it falls on tells, which a narrow beam may miss. */
static bool reaches_into(const struct lx_emitter *emitter, const struct lx_prepared *prepared,
                         const struct lx_closed_box *box)
{
    const bool is_extended = lx_is_extended(emitter);
    double at[3];
    if (lx_is_uniform(emitter) || !(is_extended ? prepared->shadows_extended : prepared->shadows_on_free))
        return true;
    if (lx_is_endless(emitter))
        return false;
    locate(box, lx_emitter_center(emitter), at);
    for (int way = 0; way < 3; way++)
        if (fabs(at[way]) > box->half_mm[way] + lx_emitter_radius(emitter) + box->touch_mm)
            return false;
    return true;
}

/* Whether a node of a face is in a box or on its sides; but not on what a side that is a plate lies on, as the bottom
 * does on a floor: that plate has what light there is inside, and a polynomial of the floor's goes above 0 under it. */
static bool has_node(const struct lx_closed_box *box, const struct lx_matte_face *face, const double place_mm[3])
{
    double at[3];
    bool is_on = false, is_side = false;
    locate(box, place_mm, at);
    for (int way = 0; way < 3; way++) {
        if (fabs(at[way]) > box->half_mm[way] + box->touch_mm)
            return false;
        is_on = is_on || (fabs(at[way]) > box->half_mm[way] - box->touch_mm &&
                          box->plates[2 * way + (at[way] > 0)] != SIZE_MAX);
    }
    for (int side = 0; side < 6; side++)
        is_side = is_side || box->plates[side] == face->surface;
    return is_side || !is_on;
}

/* Whether there may be light in a box: from a source that reaches into it, or on its inner sides or something in it. */
static bool is_lit_inside(const struct lx_radiosity *reflected, const struct lx_closed_box *box)
{
    const struct lx_emitters *emitters = &reflected->prepared->emitters;
    for (size_t i = 0; i < emitters->count; i++) {
        struct lx_emitter room;
        if (reaches_into(lx_emitter_at(emitters, i, &room), reflected->prepared, box))
            return true;
    }
    for (size_t t = 0; t < reflected->tile_count; t++) {
        const struct lx_tile *tile = &reflected->tiles[t];
        const struct lx_matte_face *face = &reflected->faces[tile->face];
        for (int q = 0; q < LX_RULE_NODES && !is_outer(box, face); q++)
            if (tile->direct.nodes[q] > 0 && has_node(box, face, tile->cell.place_mm[q]))
                return true;
    }
    return false;
}

/* Whether a face with straight edges is within a box. */
static bool is_within(const struct lx_closed_box *box, const struct lx_matte_face *face)
{
    double corners[4][3], at[3];
    if (!lx_is_polygon(face))
        return false;
    locate(box, face->cell.center_mm, at); /* not on a side */
    for (int way = 0; way < 3; way++)
        if (fabs(at[way]) >= box->half_mm[way] - box->touch_mm)
            return false;
    const int count = lx_sheet_corners(&face->sheet, corners);
    for (int c = 0; c < count; c++) {
        locate(box, corners[c], at);
        for (int way = 0; way < 3; way++)
            if (fabs(at[way]) > box->half_mm[way] + box->touch_mm)
                return false;
    }
    return true;
}

void lx_closed_boxes_darken(const struct lx_radiosity *reflected, bool *stays)
{
    for (size_t b = 0; b < reflected->boxes.count; b++) {
        const struct lx_closed_box *box = &reflected->boxes.items[b];
        if (is_lit_inside(reflected, box))
            continue;
        for (size_t f = 0; f < reflected->face_count; f++)
            stays[f] = stays[f] && !is_inner(box, &reflected->faces[f]) && !is_within(box, &reflected->faces[f]);
    }
}

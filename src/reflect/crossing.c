/* SPDX-License-Identifier: MIT */
/* Shadows on cells: where they begin, and which parts of a cell are lit. */
#include "crossing.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "../world/reference.h"

/* In coordinates of a cell, -1 to 1: outlines that are nearer to its border lie on it; half a penumbra of this width
 * shows in its samples. */
static const double BORDER = 1e-6, SOFT = 0.5;
/* Two shadows that begin towards directions with no more than this cosine are on both sides of a strip. */
static const double OPPOSITE = -0.5;
/* The share of what was put right that may still be wrong. */
static const double LEFT = 0.1;
/* How near to a light, as a share of its height over a cell, outlines count. */
static const double BELOW = 0.999;
/* Shares below are rounding. */
static const double NOTHING = 1e-9;
static const double NOWHERE[3] = {0, 0, 0};

/* ---- the plane of a cell ---- */

/* A convex part of the plane, in coordinates of the cell. */
struct part {
    double corners[16][2];
    int count;
};

/* A cell in a plane, in which its sides are from -1 to 1; of what is round in that which faces the light. */
struct square {
    double center_mm[3], sides_mm[2][3], normal[3];
    double lowest_mm;                                       /* what is below it casts no shadow on it */
    double height_mm;                                       /* of the light; of one without end 1 */
    double nodes[LX_RULE_NODES][2], weights[LX_RULE_NODES]; /* these add up to 1 */
    struct part whole;
};

/* Coordinates of a place in the plane of a square, from its middle. */
static void locate(const struct square *square, const double place_mm[3], double at[2])
{
    const double *first = square->sides_mm[0], *second = square->sides_mm[1];
    const double a = lx_dot(first, first), b = lx_dot(first, second), c = lx_dot(second, second);
    const double x = lx_dot(first, place_mm), y = lx_dot(second, place_mm), whole = a * c - b * b;
    at[0] = (c * x - b * y) / whole;
    at[1] = (a * y - b * x) / whole;
}

/* The whole of a cell, narrower at its low end where it is of a triangle, and its nodes. */
static void set_nodes(const struct lx_tile_cell *cell, struct square *square)
{
    const double narrow = cell->narrow;
    double area = 0;
    square->whole = (struct part){.corners = {{-narrow, -1}, {narrow, -1}, {1, 1}, {-1, 1}}, .count = 4};
    for (int q = 0; q < LX_RULE_NODES; q++) {
        double from[3];
        for (int k = 0; k < 3; k++)
            from[k] = cell->place_mm[q][k] - square->center_mm[k];
        locate(square, from, square->nodes[q]);
        area += cell->area[q];
    }
    for (int q = 0; q < LX_RULE_NODES; q++)
        square->weights[q] = cell->area[q] / area;
}

/* False: the light is behind. */
static bool make_square(const struct lx_tile_cell *cell, bool is_flat, const struct lx_outline_light *light,
                        struct square *square)
{
    double way[3];
    memcpy(square->center_mm, cell->center_mm, sizeof square->center_mm);
    lx_way_to(&light->at, cell->center_mm, way);
    bool is_before;
    if (is_flat) {
        memcpy(square->normal, cell->normal[0], sizeof square->normal);
        memcpy(square->sides_mm[0], cell->first_mm, sizeof cell->first_mm);
        memcpy(square->sides_mm[1], cell->second_mm, sizeof cell->second_mm);
        square->lowest_mm = 0;
        square->height_mm = lx_dot(way, square->normal);
        is_before = square->height_mm > 0;
    } else {
        square->height_mm = lx_normalize(way);
        memcpy(square->normal, way, sizeof way);
        lx_around_axis(way, square->sides_mm[0], square->sides_mm[1]);
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 3; k++)
                square->sides_mm[i][k] *= cell->radius_mm;
        square->lowest_mm = -cell->radius_mm;
        is_before = light->at.endless || square->height_mm > cell->radius_mm;
    }
    if (is_before)
        set_nodes(cell, square);
    return is_before;
}

/* ---- where shadows begin ---- */

/* Where a shadow begins: at the places x with side . x = offset, and it is dark where that is more; how far along from
 * there, as (-side[1], side[0]) . x tells. */
struct beginning {
    double side[2], offset;
    double low, high;
    unsigned dark; /* a bit for each node that is */
    uint32_t surface;
};

/* Where the shadow of a place falls on the plane of a square, from its middle, if the light were moved so far; false:
 * that is behind the plane. */
static bool cast(const struct square *square, const struct lx_outline_light *light, const double moved_mm[3],
                 const double place_mm[3], double shadow_mm[3])
{
    double from[3], way[3];
    lx_way_to(&light->at, place_mm, way);
    for (int k = 0; k < 3; k++) {
        from[k] = place_mm[k] - square->center_mm[k];
        way[k] += moved_mm[k];
    }
    const double rise = lx_dot(way, square->normal), share = lx_dot(from, square->normal) / rise;
    for (int k = 0; k < 3; k++)
        shadow_mm[k] = from[k] - share * way[k];
    return rise > 0;
}

/* The part of an outline that is above the plane of a square and below the light; false: there is none. */
static bool clip_height(const struct square *square, const struct lx_outline_light *light,
                        const struct lx_shadow_outline *outline, double ends_mm[2][3])
{
    const double most = light->at.endless ? HUGE_VAL : BELOW * square->height_mm;
    double heights[2] = {0, 0}, range[2] = {0, 1};
    for (int k = 0; k < 3; k++) {
        heights[0] += (outline->from_mm[k] - square->center_mm[k]) * square->normal[k];
        heights[1] += (outline->to_mm[k] - square->center_mm[k]) * square->normal[k];
    }
    const double rise = heights[1] - heights[0];
    if (fmax(heights[0], heights[1]) < square->lowest_mm || fmin(heights[0], heights[1]) > most)
        return false;
    const double low = (square->lowest_mm - heights[0]) / rise, high = (most - heights[0]) / rise;
    if (rise > 0)
        range[0] = fmax(range[0], low), range[1] = fmin(range[1], high);
    else if (rise < 0)
        range[0] = fmax(range[0], high), range[1] = fmin(range[1], low);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            ends_mm[i][k] = outline->from_mm[k] + range[i] * (outline->to_mm[k] - outline->from_mm[k]);
    return range[0] <= range[1];
}

/* Whether a line between two places comes into the square of half a side. */
static bool meets(double ends[2][2], double half)
{
    double from = 0, to = 1;
    for (int k = 0; k < 2; k++) {
        const double begin = ends[0][k], along = ends[1][k] - begin;
        if (along == 0) {
            if (fabs(begin) > half)
                return false;
            continue;
        }
        const double a = (-half - begin) / along, b = (half - begin) / along;
        from = fmax(from, fmin(a, b));
        to = fmin(to, fmax(a, b));
    }
    return from <= to;
}

/* Half the width of the penumbra at a place of an outline, in coordinates of the square; `slope` is how fast these grow
 * across it. */
static double penumbra(const struct square *square, const struct lx_outline_light *light,
                       const struct lx_shadow_outline *outline, const double place_mm[3], double slope)
{
    double at[3], moved[3], most = 0;
    cast(square, light, NOWHERE, place_mm, at);
    for (unsigned i = 0; i < light->reach_count; i++) {
        if (!cast(square, light, light->reach_mm[i], place_mm, moved))
            return HUGE_VAL;
        most = fmax(most, fabs(lx_dot(outline->dark, moved) - lx_dot(outline->dark, at)) / slope);
    }
    return most;
}

/* Whether a shadow may begin on a square, and where. */
static bool crosses(const struct square *square, const struct lx_outline_light *light,
                    const struct lx_shadow_outline *outline, struct beginning *beginning)
{
    double ends[2][3], ends_at[2][2], middle[3], slopes[2], along[2];
    if (!clip_height(square, light, outline, ends))
        return false;
    for (int i = 0; i < 2; i++) {
        double shadow[3];
        cast(square, light, NOWHERE, ends[i], shadow);
        locate(square, shadow, ends_at[i]);
        slopes[i] = lx_dot(outline->dark, square->sides_mm[i]);
    }
    const double slope = hypot(slopes[0], slopes[1]);
    for (int k = 0; k < 3; k++)
        middle[k] = (ends[0][k] + ends[1][k]) / 2;
    const double half_width = slope > 0 ? penumbra(square, light, outline, middle, slope) : HUGE_VAL;
    if (!(half_width < SOFT && meets(ends_at, 1 - BORDER + half_width)))
        return false;
    for (int i = 0; i < 2; i++)
        beginning->side[i] = slopes[i] / slope;
    beginning->offset = beginning->side[0] * ends_at[0][0] + beginning->side[1] * ends_at[0][1];
    for (int i = 0; i < 2; i++)
        along[i] = beginning->side[0] * ends_at[i][1] - beginning->side[1] * ends_at[i][0];
    beginning->low = fmin(along[0], along[1]);
    beginning->high = fmax(along[0], along[1]);
    return true;
}

/* Which nodes are on the dark side of the plane through an outline and the light. */
static void find_nodes(const struct lx_tile_cell *cell, const struct lx_shadow_outline *outline,
                       struct beginning *beginning)
{
    const double here = lx_dot(outline->dark, outline->from_mm);
    beginning->dark = 0;
    beginning->surface = outline->surface;
    for (unsigned q = 0; q < LX_RULE_NODES; q++)
        beginning->dark |= (unsigned)(lx_dot(outline->dark, cell->place_mm[q]) > here) << q;
}

/* ---- parts ---- */

/* The part where side . x > offset. */
static void cut(struct part *part, const double side[2], double offset)
{
    const struct part before = *part;
    part->count = 0;
    for (int c = 0; c < before.count; c++) {
        const double *a = before.corners[c], *b = before.corners[(c + 1) % before.count];
        const double at = side[0] * a[0] + side[1] * a[1] - offset, next = side[0] * b[0] + side[1] * b[1] - offset;
        if (at > 0)
            memcpy(part->corners[part->count++], a, sizeof part->corners[0]);
        if ((at > 0) != (next > 0)) {
            const double share = at / (at - next);
            for (int k = 0; k < 2; k++)
                part->corners[part->count][k] = a[k] + share * (b[k] - a[k]);
            part->count++;
        }
    }
}

/* The area of a part, and the integrals of both coordinates. */
static void add_moments(const struct part *part, double times, double moments[3])
{
    const double *first = part->corners[0];
    for (int c = 1; c + 1 < part->count; c++) {
        const double *a = part->corners[c], *b = part->corners[c + 1];
        const double area = times * ((a[0] - first[0]) * (b[1] - first[1]) - (a[1] - first[1]) * (b[0] - first[0])) / 2;
        moments[0] += area;
        for (int k = 0; k < 2; k++)
            moments[k + 1] += area * (first[k] + a[k] + b[k]) / 3;
    }
}

static double area_of(const struct part *part)
{
    double moments[3] = {0};
    add_moments(part, 1, moments);
    return moments[0];
}

/* A place inside of a part that is not empty. */
static void middle_of(const struct part *part, double middle[2])
{
    middle[0] = middle[1] = 0;
    for (int c = 0; c < part->count; c++)
        for (int k = 0; k < 2; k++)
            middle[k] += part->corners[c][k] / part->count;
}

/* The dark or the lit side of a beginning. */
static void cut_side(struct part *part, const struct beginning *beginning, bool is_dark)
{
    const double other[2] = {-beginning->side[0], -beginning->side[1]};
    cut(part, is_dark ? beginning->side : other, is_dark ? beginning->offset : -beginning->offset);
}

/* The part that is beside a beginning, from one of its ends to the other. */
static void cut_ends(struct part *part, const struct beginning *beginning)
{
    const double along[2] = {-beginning->side[1], beginning->side[0]}, back[2] = {-along[0], -along[1]};
    cut(part, along, beginning->low);
    cut(part, back, -beginning->high);
}

/* By how much the nodes have too much shadow where one begins: its share of the cell, and both moments. */
static void find_excess(const struct square *square, const struct beginning *beginning, double excess[3])
{
    struct part dark = square->whole;
    cut_side(&dark, beginning, true);
    excess[0] = excess[1] = excess[2] = 0;
    add_moments(&dark, -1 / area_of(&square->whole), excess);
    for (int q = 0; q < LX_RULE_NODES; q++) {
        if (!(beginning->dark >> q & 1))
            continue;
        excess[0] += square->weights[q];
        for (int k = 0; k < 2; k++)
            excess[k + 1] += square->weights[q] * square->nodes[q][k];
    }
}

static bool is_strip(const struct beginning *a, const struct beginning *b)
{
    return a->side[0] * b->side[0] + a->side[1] * b->side[1] <= OPPOSITE;
}

/* Whether a place is beside a beginning, from one of its ends to the other. */
static bool is_beside(const struct beginning *beginning, const double place[2])
{
    const double along = beginning->side[0] * place[1] - beginning->side[1] * place[0];
    return along > beginning->low && along < beginning->high;
}

/* Whether any node is in a part, that of the sides of two beginnings. */
static bool has_node(const struct square *square, const struct beginning *a, const struct beginning *b, bool is_dark)
{
    const unsigned mask = is_dark ? a->dark & b->dark : ~a->dark & ~b->dark;
    const bool has_ends = is_strip(a, b);
    for (int q = 0; q < LX_RULE_NODES; q++) {
        const double *node = square->nodes[q];
        if ((mask >> q & 1) && (!has_ends || (is_beside(a, node) && is_beside(b, node))))
            return true;
    }
    return false;
}

/* The share of a cell that is between two beginnings, lit or dark, where no node is. */
static double share_between(const struct square *square, const struct beginning *a, const struct beginning *b)
{
    double share = 0;
    for (int is_dark = 0; is_dark < 2; is_dark++) {
        struct part part = square->whole;
        if (has_node(square, a, b, is_dark))
            continue;
        cut_side(&part, a, is_dark);
        cut_side(&part, b, is_dark);
        if (is_strip(a, b)) {
            cut_ends(&part, a);
            cut_ends(&part, b);
        }
        share += area_of(&part) / area_of(&square->whole);
    }
    return share;
}

/* ---- shadows of one light ---- */

struct group {
    const struct lx_outlines *outlines;
    const struct lx_prepared_surface *own; /* that the cell is of */
    const struct lx_tile_cell *cell;
    const struct lx_outline_light *light;
    struct square square;
    bool is_before; /* the light is before the cell */
    size_t first;   /* of those that were found */
    struct beginning beginnings[16];
    unsigned count;
    bool is_crowded; /* there are more */
};

static void begin_group(const struct lx_outline_light *light, bool is_flat, size_t first, struct group *group)
{
    group->light = light;
    group->first = first;
    group->count = 0;
    group->is_crowded = false;
    group->is_before = make_square(group->cell, is_flat, light, &group->square);
}

/* Whether surfaces lie on both sides of one line, so that no light comes through there. */
static bool are_joined(const struct beginning *a, const struct beginning *b)
{
    const double most = M_SQRT2; /* the cell reaches no farther */
    return hypot(a->side[0] + b->side[0], a->side[1] + b->side[1]) < BORDER && fabs(a->offset + b->offset) < BORDER &&
           fabs(fmin(a->high, most) + fmax(b->low, -most)) < BORDER &&
           fabs(fmax(a->low, -most) + fmin(b->high, most)) < BORDER;
}

static void add_to_group(struct group *group, const struct beginning *beginning)
{
    const unsigned most = sizeof group->beginnings / sizeof *group->beginnings;
    for (unsigned i = 0; i < group->count; i++)
        if (are_joined(&group->beginnings[i], beginning)) {
            group->beginnings[i] = group->beginnings[--group->count];
            return;
        }
    group->is_crowded = group->is_crowded || group->count == most;
    if (group->count < most)
        group->beginnings[group->count++] = *beginning;
}

/* Shares of a cell. */
struct shares {
    double excess[3]; /* of shadow that its nodes have too much, and moments, in all */
    double off;       /* the same of shadows one by one, without signs */
    double missed;    /* of what is between two of them and has no node */
    bool adds_up;     /* the excess is that of all shadows: they begin on one side, or on both sides of a strip */
};

static struct shares shares_of(const struct group *group)
{
    struct shares shares = {.missed = group->is_crowded};
    for (unsigned i = 0; i < group->count; i++) {
        double excess[3];
        find_excess(&group->square, &group->beginnings[i], excess);
        for (int k = 0; k < 3; k++) {
            shares.excess[k] += excess[k];
            shares.off += fabs(excess[k]);
        }
        for (unsigned k = 0; k < i; k++)
            shares.missed += share_between(&group->square, &group->beginnings[k], &group->beginnings[i]);
    }
    shares.adds_up = group->count == 1 || (group->count == 2 && is_strip(&group->beginnings[0], &group->beginnings[1]));
    return shares;
}

/* ---- what is dark ---- */

static struct lx_element element_at(const struct group *group, const double place_mm[3], const double normal[3])
{
    return (struct lx_element){
        .place_mm = lx_exact3(place_mm), .normal = lx_exact3(normal), .own = group->own, .is_free = true};
}

/* Whether the light is hidden from a place of the cell. */
static bool is_hidden(const struct group *group, const double place_mm[3], const double normal[3])
{
    const struct lx_element element = element_at(group, place_mm, normal);
    return lx_openness_of(group->outlines->prepared, &element, group->light->emitter).value < 0.5;
}

/* Whether some surface whose outline does not cross the cell takes the light from its middle, and so from all of it. */
static bool is_dark(const struct group *group, const struct lx_crossings *found)
{
    const struct lx_prepared *prepared = group->outlines->prepared;
    const struct lx_element element = element_at(group, group->cell->center_mm, group->cell->normal[0]);
    if (group->light->reach_count > 0)
        return false;
    for (size_t s = 0; s < prepared->surface_count; s++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[s];
        bool is_aside = surface == group->own; /* its outlines may be on the cell's border */
        for (size_t i = group->first; i < found->count && !is_aside; i++)
            is_aside = group->outlines->items[found->items[i]].surface == s;
        if (!is_aside && lx_hidden_by(surface, &element, group->light->emitter).value > 0.5)
            return true;
    }
    return false;
}

/* Whether the light falls on a cell as its outlines say. */
enum answer { AS_FORETOLD, OTHERWISE, ALL_DARK };

/*
 * Asks at the nodes, and where there are none in a part of the cell, in its middle.  Of a strip it is not known whether
 * it is lit, between two surfaces, or the shadow of one thing, but where its two shadows do not meet.
 */
static enum answer ask_cell(const struct group *group)
{
    const struct lx_tile_cell *cell = group->cell;
    const struct beginning *a = &group->beginnings[0], *b = &group->beginnings[group->count - 1];
    const bool is_lit_strip = a != b && a->offset + b->offset > 0;
    const unsigned all = (1U << LX_RULE_NODES) - 1, predicted = is_lit_strip ? a->dark | b->dark : a->dark & b->dark;
    unsigned found = 0;
    for (unsigned q = 0; q < LX_RULE_NODES; q++)
        found |= (unsigned)is_hidden(group, cell->place_mm[q], cell->normal[q]) << q;
    bool is_as_predicted = found == predicted, is_all_dark = found == all;
    for (int is_dark = 0; is_dark < 2; is_dark++) {
        struct part part = group->square.whole;
        double middle[2], place[3];
        if (predicted != (is_dark ? 0 : all))
            continue;
        cut_side(&part, a, is_dark);
        if (is_lit_strip != is_dark) /* else it is on either side, and one of them tells */
            cut_side(&part, b, is_dark);
        if (part.count == 0)
            continue;
        middle_of(&part, middle);
        for (int k = 0; k < 3; k++)
            place[k] = cell->center_mm[k] + middle[0] * group->square.sides_mm[0][k] +
                       middle[1] * group->square.sides_mm[1][k];
        const bool is_hidden_there = is_hidden(group, place, cell->normal[0]);
        is_as_predicted = is_as_predicted && is_hidden_there == is_dark;
        is_all_dark = is_all_dark && is_hidden_there;
    }
    return is_all_dark ? ALL_DARK : is_as_predicted ? AS_FORETOLD : OTHERWISE;
}

/* Adds the linear function that has an excess of light and its moments. */
static void correct(const struct square *square, double irradiance, const double excess[3],
                    double correction[LX_RULE_NODES])
{
    double middle[2] = {0, 0}, spread[2] = {0, 0};
    for (int q = 0; q < LX_RULE_NODES; q++)
        for (int k = 0; k < 2; k++)
            middle[k] += square->weights[q] * square->nodes[q][k];
    for (int q = 0; q < LX_RULE_NODES; q++)
        for (int k = 0; k < 2; k++)
            spread[k] += square->weights[q] * (square->nodes[q][k] - middle[k]) * (square->nodes[q][k] - middle[k]);
    for (int q = 0; q < LX_RULE_NODES; q++) {
        double share = excess[0];
        for (int k = 0; k < 2; k++)
            share += (excess[k + 1] - excess[0] * middle[k]) / spread[k] * (square->nodes[q][k] - middle[k]);
        correction[q] += irradiance * share;
    }
}

/* The irradiance that a light without size gives where nothing is in its way. */
static double open_irradiance(const struct lx_outline_light *light, const struct lx_tile_cell *cell)
{
    const struct lx_sample sample = lx_emitter_sample(light->emitter, lx_exact3(cell->center_mm));
    return sample.on_element ? 0
                             : fmax(sample.e_perp.value * lx_dot3(sample.towards, lx_exact3(cell->normal[0])).value, 0);
}

static void end_group(const struct group *group, struct lx_crossings *found)
{
    if (group->count == 0 || is_dark(group, found))
        return;
    const struct shares shares = shares_of(group);
    if (shares.off + shares.missed < NOTHING)
        return;
    if (group->light->reach_count > 0) {
        found->share += shares.off + shares.missed;
        return;
    }
    const enum answer answer = shares.adds_up ? ask_cell(group) : OTHERWISE;
    const double irradiance = open_irradiance(group->light, group->cell);
    if (answer == OTHERWISE)
        found->irradiance += irradiance * fmin(shares.off + shares.missed, 1);
    if (answer != AS_FORETOLD)
        return;
    found->irradiance += irradiance * fmin(LEFT * shares.off, 1);
    correct(&group->square, irradiance, shares.excess, found->correction);
}

void lx_crossings_find(const struct lx_outlines *outlines, const struct lx_matte_face *face,
                       const struct lx_tile_cell *cell, const struct lx_crossings *larger, struct lx_crossings *found)
{
    const size_t count = larger ? larger->count : outlines->count;
    struct group group = {.outlines = outlines, .own = &outlines->prepared->surfaces[face->surface], .cell = cell};
    *found = (struct lx_crossings){.items = found->items};
    for (size_t i = 0; i < count; i++) {
        const uint32_t number = larger ? larger->items[i] : (uint32_t)i;
        const struct lx_shadow_outline *outline = &outlines->items[number];
        const struct lx_outline_light *light = &outlines->lights[outline->light];
        struct beginning beginning;
        if (light != group.light) {
            end_group(&group, found);
            begin_group(light, face->is_flat, found->count, &group);
        }
        if (!group.is_before || (outline->surface == face->surface && !group.own->kind->hides_itself) ||
            !crosses(&group.square, light, outline, &beginning))
            continue;
        find_nodes(cell, outline, &beginning);
        found->items[found->count++] = number;
        add_to_group(&group, &beginning);
    }
    end_group(&group, found);
    found->share = fmin(found->share, 1);
}

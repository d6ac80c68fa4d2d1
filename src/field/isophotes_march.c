/* SPDX-License-Identifier: MIT */
/*
 * Marching: the pieces of a level's lines within each cell.
 *
 * A cell that shows one surface at all its corners is a square.  In any other, each surface that is seen at some of its
 * corners has a polygon: those corners, the places on the cell's sides where the surface ends, and between two of these
 * a chord, beyond which the surface's edge bulges.  Where the level crosses a side of the polygon is a vertex; vertices
 * are paired around the runs of corners on one side of the level.
 *
 * Places on the edge of a surface are taken a little inside it, because there the height of a sphere, and with it all
 * else, changes without bound.
 */
#include <math.h>
#include <string.h>

#include "../base/memory.h"
#include "isophotes.h"

enum { MOST_CORNERS = 9, MOST_STEPS = 200 };

/* Of the cell's side: how far inside an edge places are taken; of a way: how well they are found there. */
static const double INSET = 1e-6, CORNER_ERROR = 1e-8, VERTEX_ERROR = 1e-15;
static const double NEAR_LEVEL = 1e-13, LEVEL_ERROR = 1e-9;

/* A corner of a polygon. */
struct corner {
    double at[2], value;
    uint64_t side; /* key of the grid's side on the way to the next corner; CHORD for an edge of the surface */
};

static const uint64_t CHORD = UINT64_MAX;

struct polygon {
    struct corner corners[MOST_CORNERS];
    size_t count;
    uint32_t surface; /* 0: the picture alone is looked at */
    double size;      /* of the cell's side */
    uint64_t chord;   /* key for what lies on its first chord */
};

struct crossing {
    bool exists; /* false at a jump */
    uint64_t key;
    double at[2];
    size_t before; /* the corner before it */
};

/* ---- values ---- */

/* The value at a place of the surface; false where another one or none is seen. */
static bool value_at(const struct lx_nodes *nodes, uint32_t surface, const double at[2], double *value)
{
    luxel_value found = luxel_evaluate(nodes->evaluator, at[0], at[1], NULL);
    *value = found.value;
    return found.has_value && found.surface + 1 == surface;
}

static bool is_seen(const struct lx_nodes *nodes, uint32_t surface, const double at[2])
{
    struct lx_element element;
    return lx_element_seen(&nodes->evaluator->prepared, at[0], at[1], &element) &&
           (uint32_t)(element.own - nodes->evaluator->prepared.surfaces) + 1 == surface;
}

/* The value of a node, exact where the picture's leaves it in doubt on which side of the level it is. */
static double node_value(const struct lx_nodes *nodes, size_t node, double level)
{
    double value = nodes->values[node];
    if (!nodes->evaluator || nodes->exact[node] || fabs(value - level) > nodes->doubt)
        return value;
    const double at[2] = {nodes->x_mm[node % nodes->columns], nodes->y_mm[node / nodes->columns]};
    value_at(nodes, nodes->surface[node], at, &value);
    return value;
}

static void between(const double a[2], const double b[2], double share, double at[2])
{
    for (int i = 0; i < 2; i++)
        at[i] = a[i] * (1 - share) + b[i] * share;
}

/*
 * Where the level is crossed between a and b, to NEAR_LEVEL, by the rule of Illinois, and by halving when that is slow.
 * `place` turns a share of the way into a place of the surface; false where there is none.
 */
struct way {
    const struct lx_nodes *nodes;
    const struct polygon *polygon;
    const double *a, *b;
    bool (*place)(const struct way *way, double share, double at[2]);
};

static bool find_level(const struct way *way, double level, double value_a, double value_b, double at[2])
{
    double low = 0, high = 1, at_low = value_a - level, at_high = value_b - level;
    double enough = NEAR_LEVEL * (level != 0 ? fabs(level) : way->nodes->scale);
    double best = HUGE_VAL, most = LEVEL_ERROR * (level != 0 ? fabs(level) : way->nodes->scale);
    int last_side = 0;
    for (int step = 0; step < MOST_STEPS && high - low > 4e-16; step++) {
        double share = low + (high - low) * (at_low / (at_low - at_high)), value, here[2];
        if (step % 8 == 7 || !(share > low && share < high))
            share = low + (high - low) / 2;
        if (!way->place(way, share, here) || !value_at(way->nodes, way->polygon->surface, here, &value))
            return false;
        double away = value - level;
        if (fabs(away) < best) {
            best = fabs(away);
            at[0] = here[0], at[1] = here[1];
        }
        if (best <= enough)
            return true;
        if ((away >= 0) == (at_low >= 0)) {
            low = share, at_low = away;
            at_high *= last_side == -1 ? 0.5 : 1;
            last_side = -1;
        } else {
            high = share, at_high = away;
            at_low *= last_side == 1 ? 0.5 : 1;
            last_side = 1;
        }
    }
    return best <= most; /* else the value jumps over the level */
}

static bool place_on_side(const struct way *way, double share, double at[2])
{
    between(way->a, way->b, share, at);
    return true;
}

/* ---- edges of surfaces ---- */

/*
 * On the way from a place that shows the surface to one that does not: the last that does, a little inside.  A vertex
 * must be found exactly, as values next to an edge change with the root of the distance from it.
 */
static bool find_edge(const struct lx_nodes *nodes, uint32_t surface, const double inside[2], const double outside[2],
                      double size, double error, double at[2])
{
    double low = 0, high = 1, length = hypot(outside[0] - inside[0], outside[1] - inside[1]);
    while (high - low > error) {
        double half = low + (high - low) / 2;
        between(inside, outside, half, at);
        if (is_seen(nodes, surface, at))
            low = half;
        else
            high = half;
    }
    low -= INSET * size / length;
    between(inside, outside, low > 0 ? low : 0, at);
    return is_seen(nodes, surface, at);
}

/* The place of the surface's edge beside a chord. */
static bool place_on_edge(const struct way *way, double share, double at[2])
{
    const struct polygon *polygon = way->polygon;
    double on_chord[2], beyond[2], back[2];
    double dx = way->b[0] - way->a[0], dy = way->b[1] - way->a[1], length = hypot(dx, dy);
    double reach = fmin(polygon->size, length);
    between(way->a, way->b, share, on_chord);
    if (!(length > 0))
        return false;
    /* corners go round with the surface at their left, so what is beyond is at the right */
    beyond[0] = on_chord[0] + reach * dy / length, beyond[1] = on_chord[1] - reach * dx / length;
    back[0] = on_chord[0] - reach * dy / length, back[1] = on_chord[1] + reach * dx / length;
    if (is_seen(way->nodes, polygon->surface, on_chord))
        return !is_seen(way->nodes, polygon->surface, beyond) &&
               find_edge(way->nodes, polygon->surface, on_chord, beyond, polygon->size, VERTEX_ERROR, at);
    return is_seen(way->nodes, polygon->surface, back) &&
           find_edge(way->nodes, polygon->surface, back, on_chord, polygon->size, VERTEX_ERROR, at);
}

/* ---- polygons ---- */

static bool is_crossed(const struct polygon *polygon, size_t i, double level)
{
    size_t next = (i + 1) % polygon->count;
    return (polygon->corners[i].value >= level) != (polygon->corners[next].value >= level);
}

static struct crossing find_crossing(const struct lx_nodes *nodes, const struct polygon *polygon, size_t i,
                                     double level)
{
    const struct corner *a = &polygon->corners[i], *b = &polygon->corners[(i + 1) % polygon->count];
    struct crossing crossing = {.exists = true, .key = a->side == CHORD ? polygon->chord : a->side, .before = i};
    if (!nodes->evaluator) {
        between(a->at, b->at, (level - a->value) / (b->value - a->value), crossing.at);
        return crossing;
    }
    /* a side is always gone along in the same direction, so that both its cells find the same bytes */
    bool swapped = a->at[0] > b->at[0] || (a->at[0] == b->at[0] && a->at[1] > b->at[1]);
    const struct corner *first = swapped && a->side != CHORD ? b : a, *second = first == a ? b : a;
    struct way way = {nodes, polygon, first->at, second->at, a->side == CHORD ? place_on_edge : place_on_side};
    crossing.exists = find_level(&way, level, first->value, second->value, crossing.at);
    return crossing;
}

static void add_segment(struct lx_segments *segments, const struct crossing *from, const struct crossing *to)
{
    if (!from->exists || !to->exists || segments->failed)
        return;
    if (lx_reserve((void **)&segments->items, &segments->capacity, segments->count + 1, sizeof *segments->items) < 0) {
        segments->failed = true;
        return;
    }
    struct lx_segment *segment = &segments->items[segments->count++];
    segment->from_key = from->key;
    segment->to_key = to->key;
    memcpy(segment->from, from->at, sizeof segment->from);
    memcpy(segment->to, to->at, sizeof segment->to);
}

/*
 * The value in the middle, which tells what of the greater values is joined there.  In a square that is where the
 * asymptotes of the bilinear surface's saddle meet; what they say is checked on the exact function where there is one.
 */
static double middle_value(const struct lx_nodes *nodes, const struct polygon *polygon)
{
    const struct corner *c = polygon->corners;
    double value = 0, at[2] = {0, 0};
    bool square = polygon->count == 4;
    for (size_t i = 0; i < polygon->count; i++) {
        square = square && c[i].side != CHORD;
        for (int k = 0; k < 2; k++)
            at[k] += c[i].at[k] / (double)polygon->count;
    }
    if (square) {
        double twist = c[0].value + c[2].value - c[1].value - c[3].value;
        double u = (c[0].value - c[3].value) / twist, v = (c[0].value - c[1].value) / twist;
        at[0] = c[0].at[0] * (1 - u) + c[1].at[0] * u;
        at[1] = c[0].at[1] * (1 - v) + c[3].at[1] * v;
        value = (c[0].value * c[2].value - c[1].value * c[3].value) / twist;
    }
    if (!nodes->evaluator)
        return value;
    double exact;
    return value_at(nodes, polygon->surface, at, &exact) || !square ? exact : value;
}

/*
 * Corners go counter-clockwise, y being up.  Going round, the crossing that leaves the greater values comes before the
 * run of lesser ones and is where a segment ends that has the greater values at its left; the next one, behind the run,
 * is where it begins.
 */
static void march_polygon(const struct lx_nodes *nodes, const struct polygon *polygon, double level,
                          struct lx_segments *segments)
{
    struct crossing crossings[MOST_CORNERS];
    size_t count = 0;
    for (size_t i = 0; i < polygon->count; i++)
        if (is_crossed(polygon, i, level))
            crossings[count++] = find_crossing(nodes, polygon, i, level);
    if (count == 0)
        return;
    bool joined = count == 2 || middle_value(nodes, polygon) >= level; /* the greater values, across the middle */
    for (size_t i = 0; i < count; i++) {
        const struct crossing *leaves = &crossings[i];
        if (polygon->corners[leaves->before].value < level)
            continue;
        const struct crossing *returns = &crossings[(i + (joined ? 1 : count - 1)) % count];
        add_segment(segments, leaves, returns);
    }
}

/* ---- cells ---- */

struct cell {
    size_t nodes[4]; /* from the lower left counter-clockwise */
    uint64_t sides[4];
    double at[4][2], values[4], size;
    uint32_t surface[4];
    uint64_t number;
};

static void read_cell(const struct lx_nodes *nodes, unsigned column, unsigned row, struct cell *cell)
{
    size_t upper = (size_t)row * nodes->columns + column, lower = upper + nodes->columns;
    uint64_t all = (uint64_t)nodes->columns * nodes->rows;
    const size_t corners[4] = {lower, lower + 1, upper + 1, upper};
    memcpy(cell->nodes, corners, sizeof corners);
    /* sides: horizontal ones by their left node, vertical ones behind them by their upper node; each has two parts */
    cell->sides[0] = 2 * (uint64_t)lower;
    cell->sides[1] = 2 * (all + upper + 1);
    cell->sides[2] = 2 * (uint64_t)upper;
    cell->sides[3] = 2 * (all + upper);
    cell->number = 4 * all + 4 * (uint64_t)upper;
    for (int i = 0; i < 4; i++) {
        size_t node = corners[i];
        cell->at[i][0] = nodes->x_mm[node % nodes->columns];
        cell->at[i][1] = nodes->y_mm[node / nodes->columns];
        cell->surface[i] = nodes->surface[node];
        cell->values[i] = nodes->values[node];
    }
    cell->size = fmax(cell->at[1][0] - cell->at[0][0], cell->at[3][1] - cell->at[0][1]);
}

static bool is_whole(const struct cell *cell)
{
    return cell->surface[0] && cell->surface[0] == cell->surface[1] && cell->surface[0] == cell->surface[2] &&
           cell->surface[0] == cell->surface[3];
}

static void add_corner(struct polygon *polygon, const double at[2], double value, uint64_t side)
{
    struct corner *corner = &polygon->corners[polygon->count++];
    memcpy(corner->at, at, sizeof corner->at);
    corner->value = value;
    corner->side = side;
}

/* A side on which the surface begins or ends has a part at each of its ends; its first end is its left or upper one. */
static uint64_t part_of(const struct cell *cell, int side, bool at_from)
{
    bool from_is_first = side == 0 || side == 3;
    return cell->sides[side] + (at_from == from_is_first ? 0 : 1);
}

/* The place where the surface ends on the side from corner i to the next. */
static bool add_edge(const struct lx_nodes *nodes, const struct cell *cell, struct polygon *polygon, int i, bool leaves)
{
    int next = (i + 1) % 4;
    const double *inside = leaves ? cell->at[i] : cell->at[next], *outside = leaves ? cell->at[next] : cell->at[i];
    double at[2], value;
    if (!find_edge(nodes, polygon->surface, inside, outside, cell->size, CORNER_ERROR, at) ||
        !value_at(nodes, polygon->surface, at, &value))
        return false;
    add_corner(polygon, at, value, leaves ? CHORD : part_of(cell, i, false));
    return true;
}

/* The polygon of a run of corners that show one surface, from corner `first` on; false where it has no edge. */
static bool make_polygon(const struct lx_nodes *nodes, const struct cell *cell, int first, int length,
                         struct polygon *polygon)
{
    *polygon =
        (struct polygon){.surface = cell->surface[first], .size = cell->size, .chord = cell->number + (uint64_t)first};
    if (!add_edge(nodes, cell, polygon, (first + 3) % 4, false))
        return false;
    for (int k = 0; k < length; k++) {
        int i = (first + k) % 4;
        add_corner(polygon, cell->at[i], cell->values[i], k + 1 == length ? part_of(cell, i, true) : cell->sides[i]);
    }
    return add_edge(nodes, cell, polygon, (first + length - 1) % 4, true);
}

static void march_levels(const struct lx_nodes *nodes, const struct polygon *polygon, const double *levels,
                         size_t count, struct lx_segments *segments)
{
    for (size_t i = 0; i < count; i++)
        march_polygon(nodes, polygon, levels[i], &segments[i]);
}

static void march_mixed(const struct lx_nodes *nodes, const struct cell *cell, const double *levels, size_t count,
                        struct lx_segments *segments)
{
    for (int first = 0; first < 4; first++) {
        uint32_t surface = cell->surface[first];
        struct polygon polygon;
        int length = 1;
        if (!surface || cell->surface[(first + 3) % 4] == surface)
            continue;
        while (length < 4 && cell->surface[(first + length) % 4] == surface)
            length++;
        if (make_polygon(nodes, cell, first, length, &polygon))
            march_levels(nodes, &polygon, levels, count, segments);
    }
}

/* A square: its corners are looked at closely only where the picture leaves in doubt what the level does. */
static void march_whole(const struct lx_nodes *nodes, const struct cell *cell, double level,
                        struct lx_segments *segments)
{
    struct polygon polygon = {.surface = cell->surface[0], .size = cell->size};
    for (int i = 0; i < 4; i++)
        add_corner(&polygon, cell->at[i], node_value(nodes, cell->nodes[i], level), cell->sides[i]);
    march_polygon(nodes, &polygon, level, segments);
}

void lx_march_row(const struct lx_nodes *nodes, const double *levels, size_t count, unsigned row,
                  struct lx_segments *segments)
{
    for (unsigned column = 0; column + 1 < nodes->columns; column++) {
        struct cell cell;
        read_cell(nodes, column, row, &cell);
        if (!is_whole(&cell)) {
            if (nodes->evaluator)
                march_mixed(nodes, &cell, levels, count, segments);
            continue;
        }
        double least = cell.values[0], greatest = cell.values[0];
        for (int i = 1; i < 4; i++) {
            least = fmin(least, cell.values[i]);
            greatest = fmax(greatest, cell.values[i]);
        }
        for (size_t i = 0; i < count; i++)
            if (levels[i] >= least - nodes->doubt && levels[i] <= greatest + nodes->doubt)
                march_whole(nodes, &cell, levels[i], &segments[i]);
    }
}

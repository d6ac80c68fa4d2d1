/* SPDX-License-Identifier: MIT */
/*
 * What happens within a cell of the grid: the crossings on its sides are joined to segments.
 *
 * What of a cell lies on one surface is a polygon: of corners, of places where the surface's edge cuts the cell's
 * sides, and of extrema on them.  Its sides are pieces, or rims, along the edge of the surface, where lines end.
 */
#include <math.h>
#include <string.h>

#include "isophotes.h"

enum { MOST_POINTS = 12 };

/* A point of a polygon and the side from it to the next, counter-clockwise. */
struct point {
    double xy_mm[2], value;
    bool is_corner;
    bool is_rim; /* the side runs along the edge of the surface */
    bool below;  /* the side belongs to the next line of the grid */
    size_t edge; /* else */
    unsigned char piece;
};

struct polygon {
    int surface;
    unsigned count;
    struct point points[MOST_POINTS];
};

/* A cell: its corners from the lower left one counter-clockwise, and the sides behind them. */
struct cell {
    struct lx_iso_search *search;
    unsigned line, column;
    double xy_mm[4][2], value[4];
    int surface[4];
    bool has_nodes;
};

/* A side of a cell, as it is kept. */
struct side {
    bool below, reversed;
    size_t edge;
};

static struct side side_of(const struct cell *cell, unsigned k)
{
    size_t horizontal = 2 * (size_t)cell->column;
    switch (k) {
    case 0: return (struct side){.below = true, .edge = horizontal};
    case 1: return (struct side){.reversed = true, .edge = horizontal + 3};
    case 2: return (struct side){.reversed = true, .edge = horizontal};
    default: return (struct side){.edge = horizontal + 1};
    }
}

/* -- what the lines know -- */

static const struct lx_iso_node *find_node(const struct cell *cell, const struct side *side, unsigned char end)
{
    const struct lx_iso_list *list = &cell->search->lines[cell->line + side->below].nodes;
    const struct lx_iso_node *nodes = list->items;
    size_t first = 0, last = list->count;
    while (first < last) {
        size_t middle = first + (last - first) / 2;
        if (nodes[middle].edge < side->edge || (nodes[middle].edge == side->edge && nodes[middle].side < end))
            first = middle + 1;
        else
            last = middle;
    }
    bool found = first < list->count && nodes[first].edge == side->edge && nodes[first].side == end;
    return found ? &nodes[first] : NULL;
}

static bool is_before(const struct lx_iso_crossing *a, size_t edge, unsigned char piece, size_t level)
{
    if (a->edge != edge)
        return a->edge < edge;
    return a->piece != piece ? a->piece < piece : a->level < level;
}

/* The crossing of a level with the side behind a point; false: there is none, as the function jumps. */
static bool find_crossing(const struct cell *cell, const struct point *point, size_t level,
                          struct lx_iso_vertex *vertex)
{
    const struct lx_iso_list *list = &cell->search->lines[cell->line + point->below].crossings;
    const struct lx_iso_crossing *crossings = list->items;
    size_t first = 0, last = list->count;
    while (first < last) {
        size_t middle = first + (last - first) / 2;
        if (is_before(&crossings[middle], point->edge, point->piece, level))
            first = middle + 1;
        else
            last = middle;
    }
    *vertex = (struct lx_iso_vertex){point->below ? LX_ISO_CROSSING_NEXT : LX_ISO_CROSSING_HERE, first};
    return first < list->count && crossings[first].edge == point->edge && crossings[first].piece == point->piece &&
           crossings[first].level == level;
}

/* -- the ends of lines on rims -- */

/* A place well on the surface: the middle of the polygon's corners, or one of them. */
static void find_inner(const struct cell *cell, const struct polygon *polygon, double inner_mm[2])
{
    unsigned corners = 0;
    const struct point *some = &polygon->points[0];
    inner_mm[0] = inner_mm[1] = 0;
    for (unsigned i = 0; i < polygon->count; i++) {
        if (!polygon->points[i].is_corner)
            continue;
        some = &polygon->points[i];
        inner_mm[0] += some->xy_mm[0];
        inner_mm[1] += some->xy_mm[1];
        corners++;
    }
    inner_mm[0] /= fmax(corners, 1);
    inner_mm[1] /= fmax(corners, 1);
    if (corners == 0 || lx_iso_seen(cell->search, inner_mm) != polygon->surface)
        memcpy(inner_mm, some->xy_mm, sizeof some->xy_mm);
}

/* Where a level meets the rim behind a point; false: nowhere, as the function jumps. */
static bool end_on_rim(const struct cell *cell, const struct polygon *polygon, unsigned k, size_t level,
                       struct lx_iso_vertex *vertex)
{
    struct lx_iso_search *search = cell->search;
    struct lx_iso_list *ends = &search->lines[cell->line].ends;
    const struct point *from = &polygon->points[k], *to = &polygon->points[(k + 1) % polygon->count];
    struct lx_iso_way way;
    double at;
    way.search = search;
    way.surface = polygon->surface;
    way.along_rim = true;
    way.count = way.rim_count = 0;
    find_inner(cell, polygon, way.inner_mm);
    memcpy(way.ends_mm[0], from->xy_mm, sizeof from->xy_mm);
    memcpy(way.ends_mm[1], to->xy_mm, sizeof to->xy_mm);
    if (!lx_iso_way_cross(&way, search->levels[level], (struct lx_iso_sample){-1, from->value},
                          (struct lx_iso_sample){2, to->value}, &at))
        return false;
    struct lx_iso_end *end = lx_iso_append(search, ends, sizeof *end);
    if (!end)
        return false;
    end->level = level;
    lx_iso_way_place(&way, at, end->xy_mm);
    *vertex = (struct lx_iso_vertex){LX_ISO_END, ends->count - 1};
    return true;
}

/* -- which crossings belong together -- */

/* The value of a bilinear surface through four corners at its saddle. */
static double bilinear_saddle(const double v[4])
{
    double scale = fmax(fmax(fabs(v[0]), fabs(v[1])), fmax(fabs(v[2]), fabs(v[3])));
    double a = v[0] / scale, b = v[1] / scale, c = v[2] / scale, d = v[3] / scale;
    return (a * c - b * d) / (a + c - b - d) * scale;
}

/* Nine values around a place, `reach` of the cell apart; false: there are not all of them. */
static bool sample_around(const struct cell *cell, int surface, const double at[2], double reach, double v[3][3])
{
    double width = cell->xy_mm[1][0] - cell->xy_mm[0][0], height = cell->xy_mm[3][1] - cell->xy_mm[0][1];
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            double xy_mm[2] = {cell->xy_mm[0][0] + (at[0] + reach * (column - 1)) * width,
                               cell->xy_mm[0][1] + (at[1] + reach * (row - 1)) * height};
            v[row][column] = lx_iso_value(cell->search, surface, xy_mm);
            if (isnan(v[row][column]))
                return false;
        }
    return true;
}

/* The exact value at the saddle in a cell, to which Newton's method leads from its middle; NaN: there is none. */
static double exact_saddle(const struct cell *cell, int surface)
{
    static const double reaches[] = {0.25, 0.1, 0.05, 0.02, 0.02};
    double at[2] = {0.5, 0.5}, v[3][3];
    for (unsigned i = 0; i < sizeof reaches / sizeof reaches[0]; i++) {
        double h = reaches[i];
        if (!sample_around(cell, surface, at, h, v))
            return (double)NAN;
        double x = (v[1][2] - v[1][0]) / 2, y = (v[2][1] - v[0][1]) / 2;
        double xx = v[1][2] - 2 * v[1][1] + v[1][0], yy = v[2][1] - 2 * v[1][1] + v[0][1];
        double xy = (v[2][2] - v[2][0] - v[0][2] + v[0][0]) / 4, det = xx * yy - xy * xy;
        if (!(det < 0))
            break;
        at[0] = fmin(fmax(at[0] - h * (yy * x - xy * y) / det, -0.5), 1.5);
        at[1] = fmin(fmax(at[1] - h * (xx * y - xy * x) / det, -0.5), 1.5);
    }
    /* one on a side may be found a little beyond it */
    if (!(fabs(at[0] - 0.5) <= 0.51 && fabs(at[1] - 0.5) <= 0.51))
        return (double)NAN;
    double xy_mm[2] = {cell->xy_mm[0][0] + at[0] * (cell->xy_mm[1][0] - cell->xy_mm[0][0]),
                       cell->xy_mm[0][1] + at[1] * (cell->xy_mm[3][1] - cell->xy_mm[0][1])};
    return lx_iso_value(cell->search, surface, xy_mm);
}

/*
 * Whether the parts of a polygon that a level leaves inside hang together through its middle.  Without a saddle what
 * comes in through an extremum of a side does not end there, but goes on to another side.
 */
static bool is_middle_inside(const struct cell *cell, const struct polygon *polygon, double level)
{
    double saddle = cell->search->evaluator ? exact_saddle(cell, polygon->surface) : (double)NAN;
    for (unsigned i = 0; isnan(saddle) && i < polygon->count; i++) {
        const struct point *point = &polygon->points[i],
                           *before = &polygon->points[(i + polygon->count - 1) % polygon->count];
        if (!point->is_corner && !point->is_rim && !before->is_rim)
            saddle = point->value;
    }
    if (isnan(saddle) && polygon->count == 4)
        saddle = bilinear_saddle(cell->value);
    return saddle >= level;
}

static void join(const struct cell *cell, const struct polygon *polygon, size_t level, unsigned leave, unsigned enter)
{
    struct lx_iso_search *search = cell->search;
    struct lx_iso_vertex ends[2];
    const unsigned sides[2] = {leave, enter};
    for (int i = 0; i < 2; i++) {
        const struct point *point = &polygon->points[sides[i]];
        if (!(point->is_rim ? end_on_rim(cell, polygon, sides[i], level, &ends[i])
                            : find_crossing(cell, point, level, &ends[i])))
            return;
    }
    struct lx_iso_segment *segment = lx_iso_append(search, &search->lines[cell->line].segments, sizeof *segment);
    if (segment)
        *segment = (struct lx_iso_segment){ends[0], ends[1]};
}

/*
 * Joins the sides that a level crosses.  Going round, the inside lies between a side where it is entered and the next
 * where it is left.  A segment that leads from where it is left to where it was entered has it on its left, and so has
 * one that leads on to where it is entered next: the first cuts off a part of the inside, the second of the outside.
 */
static void march(const struct cell *cell, const struct polygon *polygon, size_t level)
{
    unsigned sides[MOST_POINTS], count = 0;
    double value = cell->search->levels[level];
    for (unsigned k = 0; k < polygon->count; k++) {
        bool here = polygon->points[k].value >= value;
        bool next = polygon->points[(k + 1) % polygon->count].value >= value;
        if (here != next)
            sides[count++] = k;
    }
    bool hangs_together = count > 2 && is_middle_inside(cell, polygon, value);
    for (unsigned i = 0; i < count; i++)
        if (polygon->points[sides[i]].value >= value)
            join(cell, polygon, level, sides[i], sides[(i + (hangs_together ? 1 : count - 1)) % count]);
}

static void march_levels(const struct cell *cell, const struct polygon *polygon)
{
    const struct lx_iso_search *search = cell->search;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (unsigned i = 0; i < polygon->count; i++) {
        low = fmin(low, polygon->points[i].value);
        high = fmax(high, polygon->points[i].value);
    }
    for (size_t k = lx_iso_first_level(search, low); k < search->level_count && search->levels[k] <= high; k++)
        march(cell, polygon, k);
}

/* -- polygons -- */

static void add_point(struct polygon *polygon, const double xy_mm[2], double value, bool is_corner,
                      const struct side *side, unsigned char piece)
{
    struct point *point = &polygon->points[polygon->count++];
    *point = (struct point){.xy_mm = {xy_mm[0], xy_mm[1]}, .value = value, .is_corner = is_corner};
    point->is_rim = !side;
    if (side) {
        point->below = side->below;
        point->edge = side->edge;
        point->piece = piece;
    }
}

/* The place of a node on the side behind corner k. */
static void add_node(struct polygon *polygon, const struct cell *cell, unsigned k, const struct lx_iso_node *node,
                     const struct side *side, unsigned char piece)
{
    double xy_mm[2] = {cell->xy_mm[k][0], cell->xy_mm[k][1]};
    xy_mm[k % 2] = node->at;
    add_point(polygon, xy_mm, node->value, false, side, piece);
}

/* What of the cell lies on a surface, as far as its corners tell. */
static struct polygon polygon_of(const struct cell *cell, int surface)
{
    struct polygon polygon = {.surface = surface};
    for (unsigned k = 0; k < 4; k++) {
        struct side side = side_of(cell, k);
        bool here = cell->surface[k] == surface, next = cell->surface[(k + 1) % 4] == surface;
        unsigned char near = side.reversed, far = !side.reversed;
        const struct lx_iso_node *node = NULL;
        if (cell->has_nodes && (here || next))
            node = find_node(cell, &side, here && next ? 0 : here ? near : far);
        if (here)
            add_point(&polygon, cell->xy_mm[k], cell->value[k], true, &side, next && !node ? 0 : near);
        if (!node)
            continue;
        if (here)
            add_node(&polygon, cell, k, node, next ? &side : NULL, far);
        else
            add_node(&polygon, cell, k, node, &side, far);
    }
    return polygon;
}

/* A polygon of two opposite corners whose surface is not seen between them is two. */
static void march_parts(const struct cell *cell, const struct polygon *polygon)
{
    unsigned rims = 0, last = 0;
    for (unsigned i = 0; i < polygon->count; i++)
        if (polygon->points[i].is_rim)
            last = i, rims++;
    double middle[2] = {(cell->xy_mm[0][0] + cell->xy_mm[2][0]) / 2, (cell->xy_mm[0][1] + cell->xy_mm[2][1]) / 2};
    if (rims < 2 || lx_iso_seen(cell->search, middle) == polygon->surface) {
        march_levels(cell, polygon);
        return;
    }
    struct polygon part = {.surface = polygon->surface};
    for (unsigned i = 1; i <= polygon->count; i++) {
        const struct point *point = &polygon->points[(last + i) % polygon->count];
        part.points[part.count++] = *point;
        if (!point->is_rim)
            continue;
        march_levels(cell, &part);
        part.count = 0;
    }
}

static void look_at(const struct cell *cell)
{
    const int *surface = cell->surface;
    for (unsigned k = 0; k < 4; k++) {
        bool is_new = surface[k] != LX_ISO_NOTHING;
        for (unsigned before = 0; before < k; before++)
            is_new = is_new && surface[before] != surface[k];
        if (!is_new)
            continue;
        struct polygon polygon = polygon_of(cell, surface[k]);
        march_parts(cell, &polygon);
    }
}

/* Whether the cell is of the usual kind: all of it on one surface, without an extremum on a side. */
static bool is_plain(const struct cell *cell)
{
    const int *surface = cell->surface;
    return !cell->has_nodes && surface[0] == surface[1] && surface[1] == surface[2] && surface[2] == surface[3];
}

/* Whether a level passes between the corners of a plain cell. */
static bool is_crossed(const struct cell *cell)
{
    const double *v = cell->value;
    double low = v[0], high = v[0];
    for (int i = 1; i < 4; i++) {
        low = v[i] < low ? v[i] : low;
        high = v[i] > high ? v[i] : high;
    }
    /* values that are no numbers are looked at closely */
    size_t k = lx_iso_first_level(cell->search, low);
    return !(low == low && high == high) || (k < cell->search->level_count && cell->search->levels[k] <= high);
}

/* Marks the edges of a line that have nodes. */
static void mark(const struct lx_iso_search *search, unsigned line, unsigned char *marked)
{
    const struct lx_iso_list *list = &search->lines[line].nodes;
    const struct lx_iso_node *nodes = list->items;
    memset(marked, 0, 2 * (size_t)search->columns);
    for (size_t i = 0; i < list->count; i++)
        marked[nodes[i].edge] = 1;
}

void lx_iso_cells(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line)
{
    if (line + 1 >= search->rows)
        return;
    lx_iso_load(search, worker, line, true);
    const struct lx_iso_corners *upper = &worker->around[1], *lower = &worker->around[2];
    mark(search, line, worker->marked[0]);
    mark(search, line + 1, worker->marked[1]);
    for (unsigned i = 0; i + 1 < search->columns; i++) {
        const unsigned char *here = &worker->marked[0][2 * i], *below = &worker->marked[1][2 * i];
        struct cell cell = {.search = search, .line = line, .column = i};
        const double x[2] = {search->x_mm[i], search->x_mm[i + 1]};
        for (unsigned k = 0; k < 4; k++) {
            const struct lx_iso_corners *row = k < 2 ? lower : upper;
            unsigned right = k == 1 || k == 2;
            cell.surface[k] = row->surface[i + right];
            cell.value[k] = row->value[i + right];
            cell.xy_mm[k][0] = x[right];
            cell.xy_mm[k][1] = search->y_mm[k < 2 ? line + 1 : line];
        }
        cell.has_nodes = here[0] || here[1] || here[3] || below[0];
        bool plain = is_plain(&cell);
        if (plain ? is_crossed(&cell) : search->evaluator != NULL)
            look_at(&cell);
    }
}

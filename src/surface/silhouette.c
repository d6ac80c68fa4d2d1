/* SPDX-License-Identifier: MIT */
/* Silhouettes: cells that triangles touch, the borders of those cells, and as few corners as tell the borders. */
#include "silhouette.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"

enum { ROOM = 2 /* cells around what is covered */, COVERED = 1, FOLLOWED = 2 };
static const double TOLERANCE = 1.25; /* cells that a line may leave the borders by */

/* A rectangle of cells, its first row the lowest one. */
struct cells {
    uint8_t *of;
    int columns, rows;
    double low[2], side; /* where they begin, and how large each is, in the frame of the tree */
};

/* ---- covering ---- */

/* Plain comparisons, which are quicker than fmin() and fmax(): no number is NaN. */
static double lesser(double a, double b)
{
    return a < b ? a : b;
}

static double greater(double a, double b)
{
    return a > b ? a : b;
}

/* The ends of what triangles cover along both axes. */
static void find_ends(const struct lx_mesh_tree *tree, const double *const axes[2], double low[2], double high[2])
{
    for (int axis = 0; axis < 2; axis++)
        low[axis] = HUGE_VAL, high[axis] = -HUGE_VAL;
    for (size_t i = 0; i < tree->triangle_count; i++)
        for (int corner = 0; corner < 3; corner++)
            for (int axis = 0; axis < 2; axis++) {
                const double at = lx_dot(tree->triangles[i].corners[corner], axes[axis]);
                low[axis] = lesser(low[axis], at);
                high[axis] = greater(high[axis], at);
            }
}

static int cell_of(double at, int count)
{
    return at <= 0 ? 0 : at >= count - 1 ? count - 1 : (int)at;
}

static void cover_run(struct cells *cells, int row, double left, double right)
{
    const int first = cell_of(left, cells->columns), last = cell_of(right, cells->columns);
    memset(cells->of + (size_t)row * (size_t)cells->columns + first, COVERED, (size_t)(last - first) + 1);
}

/* Widens a run by what a side of a triangle has between two heights. */
static void widen(const double from[2], const double to[2], double low, double high, double *left, double *right)
{
    const double *const lower = from[1] <= to[1] ? from : to, *const upper = from[1] <= to[1] ? to : from;
    const double begin = greater(lower[1], low), end = lesser(upper[1], high), rise = upper[1] - lower[1];
    if (begin > end)
        return;
    const double slope = rise > 0 ? (upper[0] - lower[0]) / rise : 0;
    const double first = lower[0] + slope * (begin - lower[1]);
    const double last = rise > 0 ? lower[0] + slope * (end - lower[1]) : upper[0];
    *left = lesser(*left, lesser(first, last));
    *right = greater(*right, greater(first, last));
}

/* The cells that a triangle touches, row by row. */
static void cover(struct cells *cells, const double corners[3][2])
{
    const double lowest = lesser(corners[0][1], lesser(corners[1][1], corners[2][1]));
    const double highest = greater(corners[0][1], greater(corners[1][1], corners[2][1]));
    const int last = cell_of(highest, cells->rows);
    for (int row = cell_of(lowest, cells->rows); row <= last; row++) {
        double left = HUGE_VAL, right = -HUGE_VAL;
        for (int corner = 0; corner < 3; corner++)
            widen(corners[corner], corners[(corner + 1) % 3], row, row + 1, &left, &right);
        if (left <= right)
            cover_run(cells, row, left, right);
    }
}

static int make_cells(const struct lx_mesh_tree *tree, const double *const axes[2], struct cells *cells)
{
    double high[2], corners[3][2];
    find_ends(tree, axes, cells->low, high);
    const double width = high[0] - cells->low[0], height = high[1] - cells->low[1], longer = greater(width, height);
    cells->side = longer > 0 ? longer / LX_SILHOUETTE_CELLS : 1;
    cells->columns = (int)(width / cells->side) + 1 + 2 * ROOM;
    cells->rows = (int)(height / cells->side) + 1 + 2 * ROOM;
    for (int axis = 0; axis < 2; axis++)
        cells->low[axis] -= ROOM * cells->side;
    cells->of = lx_new_array((size_t)cells->columns * (size_t)cells->rows, 1);
    if (!cells->of)
        return -1;
    for (size_t i = 0; i < tree->triangle_count; i++) {
        for (int corner = 0; corner < 3; corner++)
            for (int axis = 0; axis < 2; axis++)
                corners[corner][axis] =
                    (lx_dot(tree->triangles[i].corners[corner], axes[axis]) - cells->low[axis]) / cells->side;
        cover(cells, (const double(*)[2])corners);
    }
    return 0;
}

/* ---- following borders ---- */

static bool is_covered(const struct cells *cells, int column, int row)
{
    return cells->of[(size_t)row * (size_t)cells->columns + (size_t)column] != 0;
}

static int add_place(struct lx_silhouette *silhouette, double x, double y)
{
    if (lx_reserve(&silhouette->places, &silhouette->place_room, silhouette->place_count + 1,
                   sizeof *silhouette->places))
        return -1;
    silhouette->places[silhouette->place_count][0] = x;
    silhouette->places[silhouette->place_count][1] = y;
    silhouette->place_count++;
    return 0;
}

/*
 * Follows the border from the lower side of a covered cell, with what is covered on the left, and adds the middles of
 * the sides that it passes.  Lower sides are marked, as each is passed once.
 */
static int follow(struct cells *cells, int column, int row, struct lx_silhouette *silhouette)
{
    static const int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    /* the cells before a corner, on the left and on the right, by the direction of the step */
    static const int lefts[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
    static const int rights[4][2] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
    int x = column, y = row, way = 0;
    do {
        if (way == 0)
            cells->of[(size_t)y * (size_t)cells->columns + (size_t)x] |= FOLLOWED;
        if (add_place(silhouette, x + 0.5 * steps[way][0], y + 0.5 * steps[way][1]))
            return -1;
        x += steps[way][0];
        y += steps[way][1];
        if (!is_covered(cells, x + lefts[way][0], y + lefts[way][1]))
            way = (way + 1) % 4;
        else if (is_covered(cells, x + rights[way][0], y + rights[way][1]))
            way = (way + 3) % 4;
    } while (x != column || y != row || way != 0);
    return 0;
}

/* ---- leaving out corners ---- */

/* How far a place is from the line between two others. */
static double distance_from(const double place[2], const double from[2], const double to[2])
{
    const double way[2] = {to[0] - from[0], to[1] - from[1]}, off[2] = {place[0] - from[0], place[1] - from[1]};
    const double length = hypot(way[0], way[1]);
    return length > 0 ? fabs(way[0] * off[1] - way[1] * off[0]) / length : hypot(off[0], off[1]);
}

struct stretch {
    size_t from, to; /* places that stay; `to` may be the count, which is the first one again */
};

/* Marks those of a closed chain of places that tell it to the tolerance (Ramer, Douglas, Peucker); -1: no memory. */
static int mark_corners(const double (*places)[2], size_t count, uint8_t *stays)
{
    struct stretch *waiting = NULL;
    size_t room = 0, waiting_count = 0, middle = 0;
    for (size_t i = 1; i < count; i++)
        if (hypot(places[i][0] - places[0][0], places[i][1] - places[0][1]) >
            hypot(places[middle][0] - places[0][0], places[middle][1] - places[0][1]))
            middle = i;
    stays[0] = stays[middle] = 1;
    if (lx_reserve(&waiting, &room, 2, sizeof *waiting))
        return -1;
    waiting[waiting_count++] = (struct stretch){0, middle};
    waiting[waiting_count++] = (struct stretch){middle, count};
    while (waiting_count > 0) {
        const struct stretch stretch = waiting[--waiting_count];
        double most = TOLERANCE;
        size_t farthest = 0;
        for (size_t i = stretch.from + 1; i < stretch.to; i++) {
            const double distance = distance_from(places[i], places[stretch.from], places[stretch.to % count]);
            if (distance > most)
                most = distance, farthest = i;
        }
        if (farthest == 0)
            continue;
        stays[farthest] = 1;
        if (lx_reserve(&waiting, &room, waiting_count + 2, sizeof *waiting)) {
            free(waiting);
            return -1;
        }
        waiting[waiting_count++] = (struct stretch){stretch.from, farthest};
        waiting[waiting_count++] = (struct stretch){farthest, stretch.to};
    }
    free(waiting);
    return 0;
}

/* Ends a line that began at a place of the silhouette: leaves out corners, and goes to the frame of the tree. */
static int end_line(struct lx_silhouette *silhouette, size_t begin, const struct cells *cells)
{
    const size_t count = silhouette->place_count - begin;
    double(*places)[2] = silhouette->places + begin;
    uint8_t *stays = lx_new_array(count, 1);
    if (!stays || mark_corners((const double(*)[2])places, count, stays) ||
        lx_reserve(&silhouette->ends, &silhouette->line_room, silhouette->line_count + 1, sizeof *silhouette->ends)) {
        free(stays);
        return -1;
    }
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        if (!stays[i])
            continue;
        for (int axis = 0; axis < 2; axis++)
            places[kept][axis] = cells->low[axis] + places[i][axis] * cells->side;
        kept++;
    }
    free(stays);
    silhouette->place_count = begin + kept;
    silhouette->ends[silhouette->line_count++] = silhouette->place_count;
    return 0;
}

static int trace(struct cells *cells, struct lx_silhouette *silhouette)
{
    for (int row = 1; row < cells->rows; row++)
        for (int column = 0; column < cells->columns; column++) {
            const size_t begin = silhouette->place_count;
            if (cells->of[(size_t)row * (size_t)cells->columns + (size_t)column] == COVERED &&
                !is_covered(cells, column, row - 1) &&
                (follow(cells, column, row, silhouette) || end_line(silhouette, begin, cells)))
                return -1;
        }
    return 0;
}

int lx_trace_silhouette(const struct lx_mesh_tree *tree, const double right[3], const double up[3],
                        struct lx_silhouette *silhouette)
{
    const double *const axes[2] = {right, up};
    struct cells cells = {0};
    const int failed = make_cells(tree, axes, &cells) || trace(&cells, silhouette);
    free(cells.of);
    if (failed)
        lx_clear_silhouette(silhouette);
    return failed ? -1 : 0;
}

void lx_clear_silhouette(struct lx_silhouette *silhouette)
{
    free(silhouette->places);
    free(silhouette->ends);
    *silhouette = (struct lx_silhouette){0};
}

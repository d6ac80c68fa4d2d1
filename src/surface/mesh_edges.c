/* SPDX-License-Identifier: MIT */
/*
 * The edges of a mesh, each with the faces along it and with the triangle of the tree that owns it, the first of those;
 * and for each branch of the tree a cone around the normals of all faces along the edges that it owns: where that tells
 * that a place sees all of them from their fronts, or all from their backs, none of them is an outline.
 */
#include "mesh_edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"

/* A face's side, from one name to the other. */
struct side {
    uint32_t other; /* the higher name */
    uint32_t face;  /* the triangle times 2, and 1 if its corners run from the lower name to the higher one */
    uint32_t ends[2];
};

/* ---- edges ---- */

/* Sides by their lower names, whose places in the list are in starts. */
static void list_sides(const struct lx_mesh_tree *tree, uint32_t *starts, size_t name_count, struct side *sides)
{
    memset(starts, 0, (name_count + 1) * sizeof *starts);
    for (int pass = 0; pass < 2; pass++) {
        for (size_t t = 0; t < tree->triangle_count; t++)
            for (uint32_t c = 0; c < 3; c++) {
                const uint32_t *names = tree->triangles[t].names, next = (c + 1) % 3;
                const bool is_up = names[c] < names[next];
                const uint32_t low = is_up ? names[c] : names[next], high = is_up ? names[next] : names[c];
                if (pass == 0) {
                    starts[low + 1]++;
                    continue;
                }
                const uint32_t at = (uint32_t)t * 4;
                sides[starts[low]++] =
                    (struct side){high, (uint32_t)t * 2 + is_up, {at + (is_up ? c : next), at + (is_up ? next : c)}};
            }
        for (size_t i = 0; pass == 0 && i < name_count; i++)
            starts[i + 1] += starts[i];
    }
    /* each start has moved to its end */
    memmove(starts + 1, starts, name_count * sizeof *starts);
    starts[0] = 0;
}

/* Those of one lower name by the other and by faces: there are few of them. */
static void sort_sides(struct side *sides, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        const struct side moved = sides[i];
        size_t k = i;
        for (; k > 0 && (sides[k - 1].other > moved.other ||
                         (sides[k - 1].other == moved.other && sides[k - 1].face > moved.face));
             k--)
            sides[k] = sides[k - 1];
        sides[k] = moved;
    }
}

static int by_other(const void *a, const void *b)
{
    const struct side *x = a, *y = b;
    if (x->other != y->other)
        return x->other < y->other ? -1 : 1;
    return (x->face > y->face) - (x->face < y->face);
}

/* Sides with the same names are one edge; made in the order of names. */
static size_t join_sides(const struct side *sides, size_t first, size_t end, struct lx_tree_edges *edges, size_t count)
{
    for (size_t i = first; i < end;) {
        struct lx_tree_edge edge = {.ends = {sides[i].ends[0], sides[i].ends[1]}, .first = (uint32_t)i};
        const uint32_t other = sides[i].other;
        for (; i < end && sides[i].other == other; i++) {
            edges->faces[i] = sides[i].face;
            edge.count++;
        }
        edges->items[count++] = edge;
    }
    return count;
}

/* The order of owners. */
static int sort_by_owner(const struct lx_mesh_tree *tree, struct lx_tree_edges *edges, size_t count)
{
    struct lx_tree_edge *sorted = lx_new_aligned(count, sizeof *sorted);
    if (!sorted)
        return -1;
    memset(edges->owned, 0, (tree->triangle_count + 1) * sizeof *edges->owned);
    for (size_t i = 0; i < count; i++)
        edges->owned[edges->faces[edges->items[i].first] / 2 + 1]++;
    for (size_t t = 0; t < tree->triangle_count; t++)
        edges->owned[t + 1] += edges->owned[t];
    for (size_t i = 0; i < count; i++)
        sorted[edges->owned[edges->faces[edges->items[i].first] / 2]++] = edges->items[i];
    memmove(edges->owned + 1, edges->owned, tree->triangle_count * sizeof *edges->owned);
    edges->owned[0] = 0;
    free(edges->items);
    edges->items = sorted;
    return 0;
}

static int list_edges(const struct lx_mesh_tree *tree, struct lx_tree_edges *edges)
{
    enum { FEW = 32 };
    size_t name_count = 0, count = 0;
    for (size_t t = 0; t < tree->triangle_count; t++)
        for (int c = 0; c < 3; c++)
            name_count =
                tree->triangles[t].names[c] >= name_count ? (size_t)tree->triangles[t].names[c] + 1 : name_count;
    uint32_t *starts = lx_new_aligned(name_count + 1, sizeof *starts);
    struct side *sides = lx_new_aligned(3 * tree->triangle_count, sizeof *sides);
    int failed = starts && sides ? 0 : -1;
    if (!failed)
        list_sides(tree, starts, name_count, sides);
    for (size_t i = 0; i < name_count && !failed; i++) {
        const size_t found = starts[i + 1] - starts[i];
        if (found > FEW)
            qsort(&sides[starts[i]], found, sizeof *sides, by_other);
        else
            sort_sides(&sides[starts[i]], found);
        count = join_sides(sides, starts[i], starts[i + 1], edges, count);
    }
    free(starts);
    free(sides);
    return failed || sort_by_owner(tree, edges, count) ? -1 : 0;
}

/* ---- cones ---- */

/* The unit normal of a triangle; false: it is so thin that rounding may turn it. */
static bool normal_of(const struct lx_tree_triangle *triangle, double normal[3])
{
    static const double THIN = 1e-8;
    double first[3], second[3];
    for (int k = 0; k < 3; k++) {
        first[k] = triangle->corners[1][k] - triangle->corners[0][k];
        second[k] = triangle->corners[2][k] - triangle->corners[0][k];
    }
    lx_cross(first, second, normal);
    return lx_normalize(normal) > THIN * fmax(lx_dot(first, first), lx_dot(second, second));
}

/* The directions around an axis; half is above pi/2 where nothing is known. */
struct cone {
    double axis[3], half;
};

static const struct cone UNKNOWN = {{0, 0, 1}, M_PI};

/* A cone that holds two. */
static struct cone joined(const struct cone *a, const struct cone *b)
{
    struct cone made = {.half = M_PI};
    if (a->half < 0)
        return *b;
    if (b->half < 0)
        return *a;
    for (int k = 0; k < 3; k++)
        made.axis[k] = a->axis[k] + b->axis[k];
    if (a->half > M_PI_2 || b->half > M_PI_2 || !(lx_normalize(made.axis) > 0.1))
        return UNKNOWN;
    made.half = fmax(lx_angle_between(made.axis, a->axis) + a->half, lx_angle_between(made.axis, b->axis) + b->half);
    return made.half < M_PI_2 ? made : UNKNOWN;
}

/* Around the normals of all faces along the edges of some triangles; not known where an edge is an outline whatever
 * is seen of its faces, as one that is open. */
static struct cone cone_of_leaf(const struct lx_mesh_tree *tree, uint32_t first, uint32_t count)
{
    const struct lx_tree_edges *edges = &tree->edges;
    struct cone cone = {.half = -1};
    for (uint32_t e = edges->owned[first]; e < edges->owned[first + count]; e++) {
        int sum = 0;
        for (uint32_t f = 0; f < edges->items[e].count; f++) {
            const uint32_t side = edges->faces[edges->items[e].first + f];
            struct cone face = {.half = 0};
            if (!normal_of(&tree->triangles[side / 2], face.axis))
                return UNKNOWN;
            cone = joined(&cone, &face);
            sum += side % 2 ? 1 : -1;
        }
        if (sum != 0)
            return UNKNOWN;
    }
    return cone;
}

static void keep_cone(const struct cone *cone, struct lx_tree_cone *kept)
{
    static const double ROOM = 1e-5; /* for what float32 loses */
    for (int k = 0; k < 3; k++)
        kept->axis[k] = (float)cone->axis[k];
    const double half = fmax(cone->half, 0) + ROOM;
    kept->is_known = half < M_PI_2;
    kept->sine = (float)sin(half);
    kept->cosine = (float)cos(half);
}

/* Branches come behind the nodes that they belong to. */
static int make_cones(struct lx_mesh_tree *tree)
{
    struct cone *cones = lx_new_aligned(tree->node_count, sizeof *cones);
    if (!cones)
        return -1;
    for (size_t n = tree->node_count; n > 0; n--) {
        const struct lx_tree_node *node = &tree->nodes[n - 1];
        struct cone sides[2];
        for (int side = 0; side < 2; side++) {
            sides[side] = node->count[side] == LX_TREE_BRANCH
                              ? cones[node->child[side]]
                              : cone_of_leaf(tree, node->child[side], node->count[side]);
            keep_cone(&sides[side], &tree->edges.cones[2 * (n - 1) + (size_t)side]);
        }
        cones[n - 1] = joined(&sides[0], &sides[1]);
    }
    free(cones);
    return 0;
}

int lx_tree_make_edges(struct lx_mesh_tree *tree)
{
    struct lx_tree_edges *edges = &tree->edges;
    edges->items = lx_new_aligned(3 * tree->triangle_count, sizeof *edges->items);
    edges->faces = lx_new_aligned(3 * tree->triangle_count, sizeof *edges->faces);
    edges->owned = lx_new_aligned(tree->triangle_count + 1, sizeof *edges->owned);
    edges->cones = lx_new_aligned(2 * tree->node_count, sizeof *edges->cones);
    return edges->items && edges->faces && edges->owned && edges->cones && !list_edges(tree, edges) && !make_cones(tree)
               ? 0
               : -1;
}

void lx_tree_free_edges(struct lx_mesh_tree *tree)
{
    free(tree->edges.items);
    free(tree->edges.faces);
    free(tree->edges.owned);
    free(tree->edges.cones);
}

/* ---- outlines ---- */

/* Whether a place sees all faces along the edges in a box from one side of theirs. */
static bool sees_one_side(const struct lx_tree_cone *cone, const double low[3], const double high[3],
                          const double place[3])
{
    static const double ROOM = 1e-5;
    double offset[3], half[3];
    if (!cone->is_known)
        return false;
    for (int k = 0; k < 3; k++) {
        half[k] = (high[k] - low[k]) / 2;
        offset[k] = low[k] + half[k] - place[k];
    }
    const double square = lx_dot(half, half), away = lx_dot(offset, offset);
    if (!(away > square))
        return false;
    const double sine = sqrt(square / away), cosine = sqrt(1 - square / away);
    const double sum = (double)cone->sine * cosine + (double)cone->cosine * sine;
    const double along =
        fabs(lx_dot(offset, (double[]){(double)cone->axis[0], (double)cone->axis[1], (double)cone->axis[2]}));
    return (double)cone->cosine * cosine > (double)cone->sine * sine && along > (sum + ROOM) * sqrt(away);
}

int lx_triangle_turn(const struct lx_tree_triangle *triangle, const double place[3])
{
    double corners[3][3], across[3];
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            corners[c][k] = triangle->corners[c][k] - place[k];
    lx_cross(corners[1], corners[2], across);
    return lx_dot(corners[0], across) < 0 ? -1 : 1;
}

/* The triangles that a place lies on. */
enum { MOST_TOUCHED = 32 };
struct touched {
    uint32_t triangles[MOST_TOUCHED];
    unsigned count;
    bool is_full; /* there may be more */
};

static double gap_square(const struct lx_tree_node *node, int side, const double place[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++) {
        const double low = (double)node->ends[k][side], high = (double)node->ends[k][side + 2];
        const double off = fmax(fmax(low - place[k], place[k] - high), 0);
        square += off * off;
    }
    return square;
}

static void find_touched(const struct lx_mesh_tree *tree, const struct lx_tree_outline *outline,
                         struct touched *touched)
{
    const double square = outline->touch * outline->touch;
    uint32_t stack[LX_TREE_DEPTH];
    unsigned depth = 1;
    stack[0] = 0;
    touched->count = 0;
    touched->is_full = false;
    while (depth > 0) {
        const struct lx_tree_node *node = &tree->nodes[stack[--depth]];
        for (int side = 0; side < 2; side++) {
            if (node->count[side] == 0 || gap_square(node, side, outline->place) > square)
                continue;
            if (node->count[side] == LX_TREE_BRANCH) {
                stack[depth++] = node->child[side];
                continue;
            }
            for (uint32_t t = node->child[side]; t < node->child[side] + node->count[side]; t++) {
                if (lx_triangle_square(&tree->triangles[t], outline->place) > square)
                    continue;
                touched->is_full = touched->count == MOST_TOUCHED;
                if (touched->is_full)
                    return;
                touched->triangles[touched->count++] = t;
            }
        }
    }
}

static bool touches(const struct lx_mesh_tree *tree, const struct lx_tree_outline *outline,
                    const struct touched *touched, uint32_t triangle)
{
    if (touched->is_full)
        return lx_triangle_square(&tree->triangles[triangle], outline->place) <= outline->touch * outline->touch;
    for (unsigned i = 0; i < touched->count; i++)
        if (touched->triangles[i] == triangle)
            return true;
    return false;
}

/* ---- the search ---- */

/* How many faces more there are on the left of an edge than on its right, as seen from a place, but for those that it
 * lies on. */
static int change_at(const struct lx_mesh_tree *tree, const struct lx_tree_edge *edge,
                     const struct lx_tree_outline *outline, const struct touched *touched)
{
    int sum = 0;
    for (uint32_t f = 0; f < edge->count; f++) {
        const uint32_t face = tree->edges.faces[edge->first + f];
        if (!touches(tree, outline, touched, face / 2))
            sum += lx_triangle_turn(&tree->triangles[face / 2], outline->place) * (face % 2 ? 1 : -1);
    }
    return sum;
}

static const double *end_of(const struct lx_mesh_tree *tree, uint32_t end)
{
    return tree->triangles[end / 4].corners[end % 4];
}

/* The edges of a leaf, and its triangles. */
static bool take_edges(const struct lx_mesh_tree *tree, const struct lx_tree_outline *outline,
                       const struct touched *touched, uint32_t first, uint32_t end)
{
    for (uint32_t e = tree->edges.owned[first]; e < tree->edges.owned[end]; e++) {
        const struct lx_tree_edge *edge = &tree->edges.items[e];
        const int change = change_at(tree, edge, outline, touched);
        if (change != 0 &&
            !outline->take_edge(outline->data, end_of(tree, edge->ends[0]), end_of(tree, edge->ends[1]), change))
            return false;
    }
    return true;
}

static bool take_triangles(const struct lx_mesh_tree *tree, const struct lx_tree_outline *outline,
                           const struct touched *touched, uint32_t first, uint32_t end)
{
    for (uint32_t t = first; t < end; t++)
        if (!touches(tree, outline, touched, t) && !outline->take_triangle(outline->data, &tree->triangles[t]))
            return false;
    return true;
}

bool lx_tree_outline(const struct lx_mesh_tree *tree, const struct lx_tree_outline *outline)
{
    struct touched touched;
    uint32_t stack[LX_TREE_DEPTH];
    unsigned depth = 1;
    stack[0] = 0;
    find_touched(tree, outline, &touched);
    while (depth > 0) {
        const uint32_t number = stack[--depth];
        const struct lx_tree_node *node = &tree->nodes[number];
        for (int side = 0; side < 2; side++) {
            double low[3], high[3];
            if (node->count[side] == 0)
                continue;
            for (int k = 0; k < 3; k++)
                low[k] = (double)node->ends[k][side], high[k] = (double)node->ends[k][side + 2];
            if (!outline->meets(outline->data, low, high))
                continue;
            const bool has_edges =
                !sees_one_side(&tree->edges.cones[2 * number + (uint32_t)side], low, high, outline->place);
            const bool beyond = outline->reaches_beyond(outline->data, low, high);
            if (!has_edges && !beyond)
                continue;
            const uint32_t first = node->child[side], end = first + node->count[side];
            if (node->count[side] == LX_TREE_BRANCH)
                stack[depth++] = node->child[side];
            else if ((has_edges && !take_edges(tree, outline, &touched, first, end)) ||
                     (beyond && !take_triangles(tree, outline, &touched, first, end)))
                return false;
        }
    }
    return true;
}

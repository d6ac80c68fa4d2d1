/* SPDX-License-Identifier: MIT */
/* Triangles of a mesh in space, and the search of its tree for those in a part of space. */
#include "mesh_faces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "mesh_edges.h"
#include "mesh_tree.h"

extern const struct lx_surface_kind lx_mesh_kind;

static const struct lx_mesh_tree *tree_of(const struct lx_shape *shape)
{
    return ((const struct lx_mesh_body *)shape->body)->tree;
}

size_t lx_mesh_count(const struct lx_shape *shape)
{
    return shape->kind == &lx_mesh_kind ? tree_of(shape)->triangle_count : 0;
}

void lx_mesh_corners(const struct lx_shape *shape, size_t i, double corners_mm[3][3])
{
    const struct lx_tree_triangle *triangle = &tree_of(shape)->triangles[i];
    for (int c = 0; c < 3; c++)
        lx_mesh_leave_place(shape, triangle->corners[c], corners_mm[c]);
}

bool lx_mesh_sheet(const struct lx_shape *shape, size_t i, struct lx_smooth_sheet *sheet)
{
    double corners[3][3];
    lx_mesh_corners(shape, i, corners);
    return lx_sheet_of_triangle((const double(*)[3])corners, sheet);
}

/* The corners of a triangle in order, and where it stands. */
struct trio {
    uint32_t names[3], number;
    size_t at;
};

static int by_names(const void *a, const void *b)
{
    const struct trio *x = a, *y = b;
    for (int c = 0; c < 3; c++)
        if (x->names[c] != y->names[c])
            return x->names[c] < y->names[c] ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

bool *lx_mesh_repeated(const struct lx_shape *shape)
{
    const struct lx_mesh_tree *tree = tree_of(shape);
    const size_t count = tree->triangle_count;
    struct trio *trios = lx_new_array(count, sizeof *trios);
    bool *repeated = lx_new_array(count, sizeof *repeated);
    for (size_t t = 0; t < count && trios && repeated; t++) {
        const uint32_t *names = tree->triangles[t].names;
        const uint32_t low = names[0] < names[1] ? names[0] : names[1],
                       high = names[0] < names[1] ? names[1] : names[0];
        trios[t] = (struct trio){.number = tree->triangles[t].number, .at = t};
        trios[t].names[0] = names[2] < low ? names[2] : low;
        trios[t].names[1] = names[2] < low ? low : names[2] < high ? names[2] : high;
        trios[t].names[2] = names[2] < high ? high : names[2];
    }
    if (trios && repeated) {
        qsort(trios, count, sizeof *trios, by_names);
        for (size_t t = 1; t < count; t++)
            repeated[trios[t].at] = memcmp(trios[t].names, trios[t - 1].names, sizeof trios[t].names) == 0;
    } else {
        free(repeated);
        repeated = NULL;
    }
    free(trios);
    return repeated;
}

size_t lx_mesh_triangle_at(const struct lx_shape *shape, const double place_mm[3])
{
    const struct lx_mesh_tree *tree = tree_of(shape);
    double offset[3], place[3], distance;
    for (int k = 0; k < 3; k++)
        offset[k] = place_mm[k] - shape->anchor_mm[k];
    lx_mesh_enter(shape, offset, place);
    return (size_t)(lx_tree_nearest(tree, place, HUGE_VAL, &distance) - tree->triangles);
}

/* ---- outlines ---- */

struct outlining {
    const struct lx_shape *shape;
    bool (*take)(void *data, const double from_mm[3], const double to_mm[3], int change);
    void *data;
};

static bool is_any(const void *data, const double low[3], const double high[3])
{
    (void)data, (void)low, (void)high;
    return true;
}

static bool is_none(const void *data, const double low[3], const double high[3])
{
    (void)data, (void)low, (void)high;
    return false;
}

static bool take_edge(void *data, const double from[3], const double to[3], int change)
{
    const struct outlining *outlining = data;
    double from_mm[3], to_mm[3];
    lx_mesh_leave_place(outlining->shape, from, from_mm);
    lx_mesh_leave_place(outlining->shape, to, to_mm);
    return outlining->take(outlining->data, from_mm, to_mm, change);
}

void lx_mesh_outline(const struct lx_shape *shape, const double place_mm[3],
                     bool (*take)(void *data, const double from_mm[3], const double to_mm[3], int change), void *data)
{
    struct outlining outlining = {shape, take, data};
    struct lx_tree_outline outline = {.touch = shape->touch_mm / lx_mesh_size_of(shape),
                                      .meets = is_any,
                                      .reaches_beyond = is_none,
                                      .take_edge = take_edge,
                                      .data = &outlining};
    double offset[3];
    for (int k = 0; k < 3; k++)
        offset[k] = place_mm[k] - shape->anchor_mm[k];
    lx_mesh_enter(shape, offset, outline.place);
    lx_tree_outline(tree_of(shape), &outline);
}

/* ---- parts of space ---- */

/* Planes in the frame of the tree. */
struct region {
    double planes[LX_REGION_PLANES][4];
    unsigned count;
};

static bool has_box(const struct region *region, const struct lx_tree_node *node, int side)
{
    for (unsigned i = 0; i < region->count; i++) {
        const double *plane = region->planes[i];
        double most = plane[3];
        for (int k = 0; k < 3; k++)
            most += plane[k] * (double)node->ends[k][side + (plane[k] > 0 ? 2 : 0)];
        if (most <= 0)
            return false;
    }
    return true;
}

static bool has_triangle(const struct region *region, const struct lx_tree_triangle *triangle)
{
    for (unsigned i = 0; i < region->count; i++) {
        const double *plane = region->planes[i];
        bool is_outside = true;
        for (int c = 0; c < 3 && is_outside; c++)
            is_outside = lx_dot(plane, triangle->corners[c]) + plane[3] <= 0;
        if (is_outside)
            return false;
    }
    return true;
}

size_t lx_mesh_within(const struct lx_shape *shape, const double (*planes)[4], unsigned count, size_t most,
                      uint32_t *found)
{
    const struct lx_mesh_tree *tree = tree_of(shape);
    struct region region = {.count = count};
    uint32_t stack[LX_TREE_DEPTH];
    unsigned depth = 1;
    size_t made = 0;
    for (unsigned i = 0; i < count; i++) {
        double *plane = region.planes[i];
        plane[0] = lx_dot(planes[i], shape->across);
        plane[1] = lx_dot(planes[i], shape->upward);
        plane[2] = lx_dot(planes[i], shape->axis);
        plane[3] = (lx_dot(planes[i], shape->anchor_mm) + planes[i][3]) / lx_mesh_size_of(shape);
    }
    stack[0] = 0;
    while (depth > 0) {
        const struct lx_tree_node *node = &tree->nodes[stack[--depth]];
        for (int side = 0; side < 2; side++) {
            if (!has_box(&region, node, side))
                continue;
            if (node->count[side] == LX_TREE_BRANCH) {
                stack[depth++] = node->child[side];
                continue;
            }
            for (uint32_t i = node->child[side]; i < node->child[side] + node->count[side]; i++) {
                if (!has_triangle(&region, &tree->triangles[i]))
                    continue;
                if (made == most)
                    return most + 1;
                found[made++] = i;
            }
        }
    }
    return made;
}

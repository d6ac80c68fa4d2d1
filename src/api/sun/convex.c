/* SPDX-License-Identifier: MIT */
/* Cutting convex polygons. */
#include "convex.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"

void lx_convex_clear(struct lx_convex *polygon)
{
    free(polygon->corners);
    *polygon = (struct lx_convex){NULL, 0};
}

void lx_convexes_clear(struct lx_convexes *polygons)
{
    for (size_t i = 0; i < polygons->count; i++)
        lx_convex_clear(&polygons->items[i]);
    free(polygons->items);
    *polygons = (struct lx_convexes){NULL, 0, 0};
}

double lx_convex_area(const struct lx_convex *polygon)
{
    double sum = 0;
    for (size_t i = 2; i < polygon->count; i++) {
        const double *origin = polygon->corners[0], *a = polygon->corners[i - 1], *b = polygon->corners[i];
        sum += (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0]);
    }
    return sum / 2;
}

/* How far a corner is on the inner side of a line, 0 where it is on it. */
static double height_over(const double side[3], const double corner[2], double near)
{
    const double height = side[0] * corner[0] + side[1] * corner[1] + side[2];
    return fabs(height) <= near ? 0 : height;
}

int lx_convex_cut(const struct lx_convex *polygon, const double side[3], double near, struct lx_convex *kept)
{
    *kept = (struct lx_convex){lx_new_array(polygon->count + 1, sizeof *kept->corners), 0};
    if (!kept->corners)
        return -1;
    for (size_t i = 0; i < polygon->count; i++) {
        const double *from = polygon->corners[i], *to = polygon->corners[(i + 1) % polygon->count];
        const double above = height_over(side, from, near), next = height_over(side, to, near);
        if (above >= 0)
            memcpy(kept->corners[kept->count++], from, sizeof *kept->corners);
        if (kept->count <= polygon->count && ((above > 0 && next < 0) || (above < 0 && next > 0))) {
            for (int k = 0; k < 2; k++)
                kept->corners[kept->count][k] = from[k] + above / (above - next) * (to[k] - from[k]);
            kept->count++;
        }
    }
    return 0;
}

/* The line along side i, with the polygon on its inner side; `sign` -1: on its outer one. */
static void side_of(const struct lx_convex *polygon, size_t i, double sign, double side[3])
{
    const double *from = polygon->corners[i], *to = polygon->corners[(i + 1) % polygon->count];
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    side[0] = sign * -(to[1] - from[1]) / length;
    side[1] = sign * (to[0] - from[0]) / length;
    side[2] = -(side[0] * from[0] + side[1] * from[1]);
}

static bool has_side(const struct lx_convex *polygon, size_t i, double near)
{
    const double *from = polygon->corners[i], *to = polygon->corners[(i + 1) % polygon->count];
    return hypot(to[0] - from[0], to[1] - from[1]) > near;
}

int lx_convexes_take(struct lx_convexes *polygons, struct lx_convex *polygon, double least)
{
    int failed = 0;
    if (polygon->count >= 3 && lx_convex_area(polygon) > least) {
        failed = lx_reserve(&polygons->items, &polygons->capacity, polygons->count + 1, sizeof *polygons->items);
        if (!failed) {
            polygons->items[polygons->count++] = *polygon;
            polygon->corners = NULL;
        }
    }
    lx_convex_clear(polygon);
    return failed;
}

int lx_convex_share(const struct lx_convex *one, const struct lx_convex *other, double near, struct lx_convex *shared)
{
    double side[3];
    *shared = (struct lx_convex){lx_new_array(one->count + 1, sizeof *one->corners), one->count};
    if (!shared->corners)
        return -1;
    memcpy(shared->corners, one->corners, one->count * sizeof *one->corners);
    for (size_t i = 0; i < other->count; i++) {
        struct lx_convex kept;
        if (!has_side(other, i, near))
            continue;
        side_of(other, i, 1, side);
        const int failed = lx_convex_cut(shared, side, near, &kept);
        lx_convex_clear(shared);
        *shared = kept;
        if (failed)
            return -1;
    }
    return 0;
}

/* Appends what a polygon leaves of another: beyond its first side, then of the rest beyond the next, and so on. */
static int subtract_one(const struct lx_convex *from, const struct lx_convex *taken, double near, double least,
                        struct lx_convexes *left)
{
    struct lx_convex rest, shared;
    double side[3];
    if (lx_convex_share(from, taken, near, &shared))
        return -1;
    const bool is_touched = shared.count >= 3 && lx_convex_area(&shared) > least;
    lx_convex_clear(&shared);
    rest = (struct lx_convex){lx_new_array(from->count + 1, sizeof *from->corners), from->count};
    if (!rest.corners)
        return -1;
    memcpy(rest.corners, from->corners, from->count * sizeof *from->corners);
    for (size_t i = 0; i < taken->count && is_touched; i++) {
        struct lx_convex beyond, within;
        if (!has_side(taken, i, near))
            continue;
        side_of(taken, i, -1, side);
        int failed = lx_convex_cut(&rest, side, near, &beyond) || lx_convexes_take(left, &beyond, least);
        side_of(taken, i, 1, side);
        failed = failed || lx_convex_cut(&rest, side, near, &within);
        lx_convex_clear(&rest);
        if (failed)
            return -1;
        rest = within;
    }
    if (!is_touched)
        return lx_convexes_take(left, &rest, least);
    lx_convex_clear(&rest);
    return 0;
}

int lx_convexes_subtract(struct lx_convexes *polygons, const struct lx_convex *taken, double near, double least)
{
    struct lx_convexes left = {NULL, 0, 0};
    int failed = 0;
    if (taken->count < 3)
        return 0;
    for (size_t i = 0; i < polygons->count && !failed; i++)
        failed = subtract_one(&polygons->items[i], taken, near, least, &left);
    if (failed) {
        lx_convexes_clear(&left);
        return -1;
    }
    lx_convexes_clear(polygons);
    *polygons = left;
    return 0;
}

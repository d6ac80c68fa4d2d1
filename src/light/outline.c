/* SPDX-License-Identifier: MIT */
/*
 * Outlines: whether corners make up a simple polygon in one plane, and its cutting into convex pieces: ears are cut
 * off (Meisters 1975), then the triangles merged over their common edges wherever the union stays convex (Hertel,
 * Mehlhorn 1983).
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "solid/facets_make.h"

/* A corner that turns to the right by less than this is taken for a straight one. */
static const double STRAIGHT = 0x1p-44;

/* Corners this near to their common plane, relative to the size, lie in it but for their own rounding. */
static const double ROUNDED = 0x1p-48;

/* ---- in the plane ---- */

/* What turn() tells, from float64 alone; 0 where that tells neither the sign nor whether a corner is STRAIGHT. */
static double quick_turn(const lx_wide a[2], const lx_wide b[2], const lx_wide c[2])
{
    double ux = b[0].high - a[0].high, uy = b[1].high - a[1].high;
    double vx = c[0].high - a[0].high, vy = c[1].high - a[1].high;
    double value = ux * vy - uy * vx, size = fabs(ux) + fabs(uy) + fabs(vx) + fabs(vy);
    double away = fabs(a[0].high) + fabs(a[1].high) + size; /* each coordinate at most */
    return fabs(value) > 0x1p-40 * away * size ? value : 0;
}

/* Twice the area of the triangle, positive where it turns to the left; 0 where that is all rounding. */
static double turn(const lx_wide a[2], const lx_wide b[2], const lx_wide c[2])
{
    double quick = quick_turn(a, b, c);
    if (quick != 0)
        return quick;
    lx_wide ux = lx_wide_sub(b[0], a[0]), uy = lx_wide_sub(b[1], a[1]);
    lx_wide vx = lx_wide_sub(c[0], a[0]), vy = lx_wide_sub(c[1], a[1]);
    lx_wide first = lx_wide_mul(ux, vy), second = lx_wide_mul(uy, vx);
    double value = lx_wide_value(lx_wide_sub(first, second));
    double noise = 0x1p-90 * (fabs(first.high) + fabs(second.high));
    return fabs(value) <= noise ? 0 : value;
}

static double length(const lx_wide a[2], const lx_wide b[2])
{
    return hypot(lx_wide_sub(a[0], b[0]).high, lx_wide_sub(a[1], b[1]).high);
}

/* Whether b lies before the line from a to c or on it, but for rounding. */
static bool is_left_turn(const lx_wide a[2], const lx_wide b[2], const lx_wide c[2])
{
    return turn(a, b, c) >= -STRAIGHT * length(a, b) * length(b, c);
}

bool lx_turns_left(const lx_wide (*xy)[2], const unsigned *loop, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!is_left_turn(xy[loop[i]], xy[loop[(i + 1) % count]], xy[loop[(i + 2) % count]]))
            return false;
    return true;
}

/* Whether a point on the line of a and b lies between them, ends included. */
static bool is_between(const lx_wide a[2], const lx_wide b[2], const lx_wide point[2])
{
    int k = fabs(lx_wide_sub(a[0], b[0]).high) >= fabs(lx_wide_sub(a[1], b[1]).high) ? 0 : 1;
    return lx_wide_compare(a[k], point[k]) * lx_wide_compare(b[k], point[k]) <= 0;
}

static int sign(double a)
{
    return (a > 0) - (a < 0);
}

/* Whether the closed edges a-b and c-d have a point in common. */
static bool do_meet(const lx_wide a[2], const lx_wide b[2], const lx_wide c[2], const lx_wide d[2])
{
    int c_side = sign(turn(a, b, c)), d_side = sign(turn(a, b, d));
    int a_side = sign(turn(c, d, a)), b_side = sign(turn(c, d, b));
    if (c_side * d_side < 0 && a_side * b_side < 0)
        return true;
    return (c_side == 0 && is_between(a, b, c)) || (d_side == 0 && is_between(a, b, d)) ||
           (a_side == 0 && is_between(c, d, a)) || (b_side == 0 && is_between(c, d, b));
}

/* ---- whether it is simple ---- */

struct span {
    double low, high;
    size_t edge;
};

static int by_low(const void *a, const void *b)
{
    const struct span *x = a, *y = b;
    return (x->low > y->low) - (x->low < y->low);
}

/* The edges i and k, i < k, of a polygon of so many corners: whether they meet where they should not. */
static bool do_cross(const lx_wide (*xy)[2], size_t count, size_t i, size_t k)
{
    const lx_wide *a = xy[i], *b = xy[i + 1], *c = xy[k], *d = xy[(k + 1) % count];
    if (k == i + 1) /* neighbours may not fold back */
        return turn(a, b, d) == 0 && (is_between(a, b, d) || is_between(b, d, a));
    if (i == 0 && k == count - 1)
        return turn(c, a, b) == 0 && (is_between(c, a, b) || is_between(a, b, c));
    return do_meet(a, b, c, d);
}

/* Those edges are looked at that overlap in x. */
struct lx_shape_report lx_find_crossing(const lx_wide (*xy)[2], size_t count)
{
    struct lx_shape_report report = {LX_SHAPE_GOOD, 0, 0};
    struct span *spans = lx_new_array(count, sizeof *spans);
    if (!spans)
        return (struct lx_shape_report){LX_SHAPE_OUT_OF_MEMORY, 0, 0};
    for (size_t i = 0; i < count; i++) {
        double from = xy[i][0].high, to = xy[(i + 1) % count][0].high;
        spans[i] = (struct span){fmin(from, to), fmax(from, to), i};
    }
    qsort(spans, count, sizeof *spans, by_low);
    for (size_t i = 0; i < count; i++)
        for (size_t k = i + 1; k < count && spans[k].low <= spans[i].high; k++) {
            size_t one = spans[i].edge, other = spans[k].edge;
            size_t first = one < other ? one : other, second = one < other ? other : one;
            bool sooner = report.fault == LX_SHAPE_GOOD || first < report.first ||
                          (first == report.first && second < report.second);
            if (sooner && do_cross(xy, count, first, second))
                report = (struct lx_shape_report){LX_SHAPE_CROSSES, first, second};
        }
    free(spans);
    return report;
}

/* ---- cutting ---- */

/* Whether the corner `point` lies in the closed triangle; most are known not to by one coordinate. */
static bool is_inside(const lx_wide a[2], const lx_wide b[2], const lx_wide c[2], const lx_wide point[2])
{
    for (int k = 0; k < 2; k++) {
        double at = point[k].high;
        if ((at < a[k].high && at < b[k].high && at < c[k].high) ||
            (at > a[k].high && at > b[k].high && at > c[k].high))
            return false;
    }
    return turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0;
}

/* Whether corner k of the polygon can be cut off: the triangle with its neighbours holds no other corner. */
static bool is_ear(const lx_wide (*xy)[2], const unsigned *rest, size_t count, size_t k)
{
    size_t before = (k + count - 1) % count, after = (k + 1) % count;
    const lx_wide *a = xy[rest[before]], *b = xy[rest[k]], *c = xy[rest[after]];
    if (!(turn(a, b, c) > 0))
        return false;
    for (size_t i = 0; i < count; i++)
        if (i != before && i != k && i != after && is_inside(a, b, c, xy[rest[i]]))
            return false;
    return true;
}

/* Cuts ears off until nothing is left; the number of triangles, 0 when that fails. */
static size_t cut_ears(const lx_wide (*xy)[2], unsigned *rest, size_t count, unsigned *pieces, unsigned *piece_counts)
{
    size_t found = 0, k = 0, failed = 0;
    while (count >= 3 && failed < count) {
        k %= count;
        if (!is_ear(xy, rest, count, k)) {
            k++, failed++;
            continue;
        }
        pieces[3 * found] = rest[(k + count - 1) % count];
        pieces[3 * found + 1] = rest[k];
        pieces[3 * found + 2] = rest[(k + 1) % count];
        piece_counts[found++] = 3;
        memmove(rest + k, rest + k + 1, (count - k - 1) * sizeof *rest);
        count--, failed = 0;
        k++; /* elsewhere next: fans of needles are no good pieces */
    }
    return count == 2 ? found : 0;
}

struct piece {
    unsigned *corners;
    size_t count;
};

/* A side of a triangle, by which the one beyond it is found: there the same side runs the other way. */
struct side {
    unsigned from, to;
    size_t triangle;
};

static int by_ends(const void *a, const void *b)
{
    const struct side *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return (x->to > y->to) - (x->to < y->to);
}

static void list_sides(const struct piece *triangles, size_t count, struct side *sides)
{
    for (size_t i = 0; i < 3 * count; i++) {
        const unsigned *corners = triangles[i / 3].corners;
        sides[i] = (struct side){corners[i % 3], corners[(i + 1) % 3], i / 3};
    }
    qsort(sides, 3 * count, sizeof *sides, by_ends);
}

/* Joins a piece with the triangle beyond its side i, unless a corner would not be convex then; `spare` has room. */
static bool join(const lx_wide (*xy)[2], struct piece *one, size_t i, const struct piece *triangle, unsigned *spare)
{
    size_t next = (i + 1) % one->count, k = 0;
    unsigned from = one->corners[i], to = one->corners[next];
    while (triangle->corners[k] == from || triangle->corners[k] == to)
        k++;
    unsigned tip = triangle->corners[k];
    const lx_wide *before = xy[one->corners[(i + one->count - 1) % one->count]];
    const lx_wide *after = xy[one->corners[(next + 1) % one->count]];
    if (!is_left_turn(before, xy[from], xy[tip]) || !is_left_turn(xy[tip], xy[to], after))
        return false;
    memcpy(spare, one->corners, (i + 1) * sizeof *spare);
    memmove(one->corners, one->corners + i + 1, (one->count - i - 1) * sizeof *spare);
    memcpy(one->corners + one->count - i - 1, spare, (i + 1) * sizeof *spare);
    one->corners[one->count++] = tip;
    return true;
}

/* A piece takes over a triangle behind it that it can be joined with; false: there is none. */
static bool join_some(const lx_wide (*xy)[2], struct piece *pieces, size_t count, size_t one, const struct side *sides,
                      unsigned *spare)
{
    for (size_t i = 0; i < pieces[one].count; i++) {
        const unsigned *corners = pieces[one].corners;
        const struct side wanted = {.from = corners[(i + 1) % pieces[one].count], .to = corners[i]};
        const struct side *found = bsearch(&wanted, sides, 3 * count, sizeof *sides, by_ends);
        if (!found || found->triangle <= one || pieces[found->triangle].count == 0)
            continue;
        if (join(xy, &pieces[one], i, &pieces[found->triangle], spare)) {
            pieces[found->triangle].count = 0;
            return true;
        }
    }
    return false;
}

/* Joins triangles; the number of pieces left, 0 when out of memory. */
static size_t join_all(const lx_wide (*xy)[2], size_t corner_count, size_t count, unsigned *loops, unsigned *counts)
{
    struct piece *pieces = lx_new_array(count, sizeof *pieces);
    struct side *sides = lx_new_array(count, 3 * sizeof *sides);
    unsigned *memory = lx_new_array(3 * count, sizeof *memory), *spare = lx_new_array(corner_count, sizeof *spare);
    size_t left = 0, used = 0;
    bool has_room = pieces && sides && memory && spare;
    if (has_room)
        memcpy(memory, loops, 3 * count * sizeof *loops);
    for (size_t i = 0; has_room && i < count; i++)
        pieces[i] = (struct piece){memory + 3 * i, 3};
    if (has_room)
        list_sides(pieces, count, sides);
    for (size_t i = 0; has_room && i < count; i++) {
        if (pieces[i].count == 0)
            continue;
        /* The piece that grows lies behind those that are done. */
        memcpy(loops + used, pieces[i].corners, 3 * sizeof *loops);
        pieces[i].corners = loops + used;
        while (join_some(xy, pieces, count, i, sides, spare)) {
        }
        used += pieces[i].count;
        counts[left++] = (unsigned)pieces[i].count;
    }
    free(pieces);
    free(sides);
    free(memory);
    free(spare);
    return left;
}

size_t lx_cut_outline(const lx_wide (*xy)[2], const unsigned *loop, size_t count, unsigned *pieces,
                      unsigned *piece_counts, bool joined)
{
    unsigned *rest = lx_new_array(count, sizeof *rest);
    if (!rest)
        return 0;
    memcpy(rest, loop, count * sizeof *rest);
    size_t triangles = cut_ears(xy, rest, count, pieces, piece_counts);
    free(rest);
    return triangles > 0 && joined ? join_all(xy, count, triangles, pieces, piece_counts) : triangles;
}

/* ---- in space ---- */

/* The two coordinates that tell most, in an order that keeps the polygon counter-clockwise. */
void lx_flatten(const lx_wide3 *corners_mm, const unsigned *loop, size_t count, lx_wide3 normal, lx_wide (*xy)[2])
{
    double x = fabs(normal.x.high), y = fabs(normal.y.high), z = fabs(normal.z.high);
    int dropped = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    double along = dropped == 0 ? normal.x.high : dropped == 1 ? normal.y.high : normal.z.high;
    int first = (dropped + 1) % 3, second = (dropped + 2) % 3;
    for (size_t i = 0; i < count; i++) {
        const lx_wide3 *corner = &corners_mm[loop ? loop[i] : i];
        const lx_wide at[3] = {corner->x, corner->y, corner->z};
        xy[i][0] = at[along > 0 ? first : second];
        xy[i][1] = at[along > 0 ? second : first];
    }
}

static lx_wide height_over(const struct lx_plane *plane, lx_wide3 place_mm)
{
    return lx_wide3_dot(plane->normal, lx_wide3_sub(place_mm, plane->middle_mm));
}

struct lx_plane lx_best_plane(const lx_wide3 *corners_mm, const unsigned *loop, size_t count)
{
    struct lx_plane plane = {.size_mm = 0};
    lx_wide3 sum = lx_wide3_of((double[]){0, 0, 0}), newell = sum, largest = sum, first = corners_mm[loop[0]];
    lx_wide3 before = sum;
    double all = 0, most = 0;
    for (size_t i = 1; i < count; i++) {
        lx_wide3 next = lx_wide3_sub(corners_mm[loop[i]], first), product = lx_wide3_cross(before, next);
        double length = lx_wide_value(lx_wide3_length(product));
        newell = lx_wide3_add(newell, product);
        largest = length > most ? product : largest;
        most = fmax(most, length);
        all += length;
        sum = lx_wide3_add(sum, next);
        before = next;
    }
    plane.middle_mm = lx_wide3_add(first, lx_wide3_mul(sum, lx_wide_div(lx_wide_of(1), lx_wide_of((double)count))));
    for (size_t i = 0; i < count; i++) {
        const double away = lx_wide_value(lx_wide3_length(lx_wide3_sub(corners_mm[loop[i]], plane.middle_mm)));
        plane.size_mm = fmax(plane.size_mm, 2 * away);
    }
    double area = lx_wide_value(lx_wide3_length(newell));
    plane.has_area = area > 1e-14 * plane.size_mm * plane.size_mm && area > 1e-10 * all;
    plane.is_line = !(all > 1e-14 * plane.size_mm * plane.size_mm);
    plane.normal = lx_wide3_unit(area > 1e-10 * all ? newell : largest);
    for (size_t i = 0; i < count; i++) {
        double height = fabs(height_over(&plane, corners_mm[loop[i]]).high);
        if (height >= plane.deviation_mm * (1 - 1e-6)) { /* the last of several */
            plane.farthest = i;
            plane.deviation_mm = fmax(height, plane.deviation_mm);
        }
    }
    return plane;
}

/* The corners in working order. */
struct outline {
    size_t count;
    lx_wide3 *corners_mm;
    lx_wide (*xy)[2];
    unsigned *loop, *pieces, *piece_counts;
    struct lx_plane plane;
    bool is_moved; /* corners were, into the plane */
};

static void clear_outline(struct outline *outline)
{
    free(outline->corners_mm);
    free(outline->xy);
    free(outline->loop);
    free(outline->pieces);
    free(outline->piece_counts);
}

static bool start_outline(const double (*vertices_mm)[3], size_t count, struct outline *outline)
{
    outline->count = count;
    outline->corners_mm = lx_new_array(count, sizeof *outline->corners_mm);
    outline->xy = lx_new_array(count, sizeof *outline->xy);
    outline->loop = lx_new_array(count, sizeof *outline->loop);
    outline->pieces = lx_new_array(count, 3 * sizeof *outline->pieces);
    outline->piece_counts = lx_new_array(count, sizeof *outline->piece_counts);
    if (!outline->corners_mm || !outline->xy || !outline->loop || !outline->pieces || !outline->piece_counts)
        return false;
    for (size_t i = 0; i < count; i++) {
        outline->corners_mm[i] = lx_wide3_of(vertices_mm[i]);
        outline->loop[i] = (unsigned)i;
    }
    return true;
}

/* Flat to 1e-6; what is not roundings only is moved into the plane. */
static struct lx_shape_report flatten(struct outline *outline, double largest_mm)
{
    outline->plane = lx_best_plane(outline->corners_mm, outline->loop, outline->count);
    const struct lx_plane *plane = &outline->plane;
    if (plane->is_line)
        return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, 0, 0};
    if (plane->deviation_mm > LX_SHAPE_TOLERANCE * plane->size_mm)
        return (struct lx_shape_report){LX_SHAPE_NOT_FLAT, plane->farthest, 0};
    outline->is_moved = plane->deviation_mm > ROUNDED * (plane->size_mm + largest_mm);
    for (size_t i = 0; i < outline->count && outline->is_moved; i++) {
        lx_wide3 *corner = &outline->corners_mm[i];
        *corner = lx_wide3_sub(*corner, lx_wide3_mul(plane->normal, height_over(plane, *corner)));
    }
    lx_flatten(outline->corners_mm, outline->loop, outline->count, plane->normal, outline->xy);
    return (struct lx_shape_report){LX_SHAPE_GOOD, 0, 0};
}

static struct lx_facets *make_piece(const struct outline *outline, const unsigned *loop, unsigned count)
{
    struct lx_facets *facets = lx_facets_new(count, 1, count);
    if (!facets)
        return NULL;
    lx_facets_add_face(facets, count);
    for (unsigned i = 0; i < count; i++) {
        facets->corners_mm[i] = outline->corners_mm[loop[i]];
        facets->loop[i] = i;
    }
    if (lx_facets_finish(facets, false, NULL).fault != LX_SHAPE_GOOD) {
        lx_facets_free(facets);
        return NULL;
    }
    if (outline->is_moved)
        lx_facets_were_rounded(facets);
    facets->faces[0].normal = outline->plane.normal; /* a thin piece knows it less well */
    return facets;
}

static struct lx_shape_report make_pieces(const struct outline *outline, size_t count, struct lx_facets ***facets,
                                          size_t *facet_count)
{
    struct lx_facets **made = lx_new_array(count, sizeof *made);
    const unsigned *loop = outline->pieces;
    size_t done = 0;
    while (made && done < count && (made[done] = make_piece(outline, loop, outline->piece_counts[done])))
        loop += outline->piece_counts[done++];
    if (count > 0 && done == count) {
        *facets = made;
        *facet_count = count;
        return (struct lx_shape_report){LX_SHAPE_GOOD, 0, 0};
    }
    for (size_t i = 0; i < done; i++)
        lx_facets_free(made[i]);
    free(made);
    return (struct lx_shape_report){LX_SHAPE_OUT_OF_MEMORY, 0, 0};
}

static struct lx_shape_report make_outline(struct outline *outline, double largest_mm, struct lx_facets ***facets,
                                           size_t *facet_count)
{
    struct lx_shape_report report = flatten(outline, largest_mm);
    const lx_wide(*xy)[2] = (const lx_wide(*)[2])outline->xy;
    if (report.fault == LX_SHAPE_GOOD)
        report = lx_find_crossing(xy, outline->count);
    if (report.fault == LX_SHAPE_GOOD && !outline->plane.has_area)
        report.fault = LX_SHAPE_TOO_SMALL;
    if (report.fault != LX_SHAPE_GOOD)
        return report;
    size_t count = 1;
    if (lx_turns_left(xy, outline->loop, outline->count)) {
        memcpy(outline->pieces, outline->loop, outline->count * sizeof *outline->loop);
        outline->piece_counts[0] = (unsigned)outline->count;
    } else {
        count = lx_cut_outline(xy, outline->loop, outline->count, outline->pieces, outline->piece_counts, true);
    }
    return make_pieces(outline, count, facets, facet_count);
}

struct lx_shape_report lx_facets_of_outline(const double (*vertices_mm)[3], size_t count, struct lx_facets ***facets,
                                            size_t *facet_count)
{
    double largest_mm = 0;
    if (count < 3)
        return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, 0, 0};
    for (size_t i = 0; i < count; i++) {
        const double *corner = vertices_mm[i], *next = vertices_mm[(i + 1) % count];
        if (corner[0] == next[0] && corner[1] == next[1] && corner[2] == next[2])
            return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, (i + 1) % count, 0};
        for (int k = 0; k < 3; k++)
            largest_mm = fmax(largest_mm, fabs(corner[k]));
    }
    struct outline outline = {0};
    struct lx_shape_report report = {LX_SHAPE_OUT_OF_MEMORY, 0, 0};
    if (start_outline(vertices_mm, count, &outline))
        report = make_outline(&outline, largest_mm, facets, facet_count);
    clear_outline(&outline);
    return report;
}

/* SPDX-License-Identifier: MIT */
/* The rectangle of a sweep, the lines in it, and where they begin, end and cross. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/larger.h"
#include "../../base/memory.h"
#include "../../base/vector.h"
#include "outline_map.h"

enum { MOST_LINES = 200000, MOST_EVENTS = 1000000 };

/* What lies before a flat source by less than this share of the distance, lies on it (occlusion_arc.c). */
static const double ON_SOURCE = 1e-13;

/* ---- where a sweep lies ---- */

static void to_frame(const struct lx_sweep *sweep, const double a[3], double made[3])
{
    made[0] = lx_dot(a, sweep->frame.x), made[1] = lx_dot(a, sweep->frame.y), made[2] = lx_dot(a, sweep->frame.z);
}

static void set_range(struct map_build *build, double u1, double u2, double v1, double v2)
{
    const double room = 1e-6 * (v2 - v1);
    build->u[0] = u1, build->u[1] = u2;
    build->v[0] = v1 - room, build->v[1] = v2 + room;
}

static void bound_sweep(struct map_build *build)
{
    const struct lx_sweep *s = build->sweep;
    const double h = s->height_mm, r = s->radius_mm;
    build->limit_mm = build->farthest_mm = h * (1 - ON_SOURCE);
    if (s->kind == LX_SWEEP_STRIP) {
        set_range(build, (s->y_mm + s->y1_mm) / h, (s->y_mm + s->y2_mm) / h, (s->s_mm + fmin(s->s1_mm, s->s2_mm)) / h,
                  (s->s_mm + fmax(s->s1_mm + s->width1_mm, s->s2_mm + s->width2_mm)) / h);
        return;
    }
    if (s->kind == LX_SWEEP_DISK) {
        const double aside = hypot(s->half_mm, s->slope * r);
        set_range(build, s->y1_mm / h, s->y2_mm / h, (s->s_mm - aside) / h, (s->s_mm + aside) / h);
        return;
    }
    if (s->kind == LX_SWEEP_TUBE || s->kind == LX_SWEEP_ELLIPSOID) {
        const struct lx_sweep_bounds bounds = lx_sweep_bound(s);
        build->limit_mm = bounds.x_mm[0] * (1 - ON_SOURCE);
        build->farthest_mm = bounds.x_mm[1];
        set_range(build, bounds.u[0], bounds.u[1], bounds.v[0], bounds.v[1]);
        return;
    }
    const double tangent = r / sqrt((h - r) * (h + r)), far = (h - r) * (h + r) / h;
    const double u1 = s->angle1 < 0 ? -tangent : 0, u2 = u1 + tangent;
    build->limit_mm = (h - r) * (1 - ON_SOURCE);
    build->farthest_mm = s->wall == LX_FAR_WALL ? h + r : far;
    if (lx_sweep_bulges(s)) {
        set_range(build, u1, u2, -tangent, tangent);
        return;
    }
    const double low = s->s_mm, high = low + s->length_mm;
    set_range(build, u1, u2, fmin(low / (h - r), low / far), fmax(high / (h - r), high / far));
}

/* ---- lines ---- */

static int add_event(struct map_build *build, double u)
{
    if (!(u >= build->u[0] && u <= build->u[1]))
        return 0;
    if (lx_reserve(&build->events, &build->event_capacity, build->event_count + 1, sizeof *build->events))
        return -1;
    build->events[build->event_count++] = u;
    return 0;
}

/* The share of the way from a place to another at which a linear function that is >= 0 there becomes less. */
static bool cut(double at_from, double at_to, double shares[2])
{
    if (at_from < 0 && at_to < 0)
        return false;
    if (at_from < 0)
        shares[0] = fmax(shares[0], at_from / (at_from - at_to));
    if (at_to < 0)
        shares[1] = fmin(shares[1], at_from / (at_from - at_to));
    return shares[0] < shares[1];
}

/* What of an edge lies in the rectangle and before the source, as shares of it; false: nothing. */
static bool cut_to_range(const struct map_build *build, const double from[3], const double to[3], double shares[2])
{
    const double *u = build->u, *v = build->v;
    shares[0] = 0, shares[1] = 1;
    return cut(from[0], to[0], shares) && cut(from[1] - u[0] * from[0], to[1] - u[0] * to[0], shares) &&
           cut(u[1] * from[0] - from[1], u[1] * to[0] - to[1], shares) &&
           cut(from[2] - v[0] * from[0], to[2] - v[0] * to[0], shares) &&
           cut(v[1] * from[0] - from[2], v[1] * to[0] - to[2], shares) &&
           cut(build->limit_mm - from[0], build->limit_mm - to[0], shares);
}

static double tangent_at(const struct map_build *build, const double from[3], const double to[3], double share)
{
    const double x = from[0] + share * (to[0] - from[0]), y = from[1] + share * (to[1] - from[1]);
    return share == 0   ? fmin(fmax(from[1] / from[0], build->u[0]), build->u[1])
           : share == 1 ? fmin(fmax(to[1] / to[0], build->u[0]), build->u[1])
                        : fmin(fmax(y / x, build->u[0]), build->u[1]);
}

/* Appends a line between two tangents. */
static int append_line(struct map_build *build, enum lx_outline_kind kind, const double from[3], const double to[3],
                       const double ends[2], int change)
{
    struct lx_trapezoid_map *map = build->map;
    double n[3];
    lx_cross(from, to, n);
    if (ends[0] == ends[1] || n[2] == 0) {
        if (lx_reserve(&build->walls, &build->wall_capacity, build->wall_count + 1, sizeof *build->walls))
            return -1;
        build->walls[build->wall_count++] = ends[0];
        return 0;
    }
    if (map->line_count >= MOST_LINES) {
        build->occlusion->outline->is_broken = true;
        return 0;
    }
    if (lx_reserve(&map->lines, &map->line_capacity, map->line_count + 1, sizeof *map->lines))
        return -1;
    struct lx_outline_line *line = &map->lines[map->line_count++];
    *line = (struct lx_outline_line){.kind = kind,
                                     .low = fmin(ends[0], ends[1]),
                                     .high = fmax(ends[0], ends[1]),
                                     .start = -n[0] / n[2],
                                     .rise = -n[1] / n[2],
                                     .change = ends[0] < ends[1] ? change : -change};
    memcpy(line->from, from, sizeof line->from);
    memcpy(line->to, to, sizeof line->to);
    return 0;
}

/* Adds what of an edge is in the rectangle. */
static int add_line(struct map_build *build, enum lx_outline_kind kind, const double from[3], const double to[3],
                    int change)
{
    double shares[2];
    if (!cut_to_range(build, from, to, shares))
        return 0;
    const double ends[2] = {tangent_at(build, from, to, shares[0]), tangent_at(build, from, to, shares[1])};
    return add_event(build, ends[0]) || add_event(build, ends[1]) ? -1
                                                                  : append_line(build, kind, from, to, ends, change);
}

/* The lower and the upper border of a strip, and of the rectangle. */
static int add_borders(struct map_build *build)
{
    const struct lx_sweep *s = build->sweep;
    const double h = build->limit_mm, *u = build->u, *v = build->v;
    for (int i = 0; i < 2; i++) {
        const double room = i ? -1e-7 * (v[1] - v[0]) : 1e-7 * (v[1] - v[0]);
        const double from[3] = {h, h * u[0], h * (v[i] + room)}, to[3] = {h, h * u[1], h * (v[i] + room)};
        if (append_line(build, LX_OUTLINE_BOX, from, to, u, 0))
            return -1;
    }
    for (int i = 0; i < 2 && s->kind == LX_SWEEP_STRIP; i++) {
        const double y = s->y_mm + s->y1_mm, z = s->s_mm + s->s1_mm + i * s->width1_mm;
        const double end_y = s->y_mm + s->y2_mm, end_z = s->s_mm + s->s2_mm + i * s->width2_mm;
        const double scale = 1 - ON_SOURCE;
        const double from[3] = {h, y * scale, z * scale}, to[3] = {h, end_y * scale, end_z * scale};
        if (append_line(build, LX_OUTLINE_BORDER, from, to, u, 0))
            return -1;
    }
    return 0;
}

/* The horizons n.(1, u, v) = 0, as far as they come through the rectangle. */
static int add_horizon(struct map_build *build, unsigned number)
{
    const double *n = build->horizons[number];
    const double middle[2] = {(build->u[0] + build->u[1]) / 2, (build->v[0] + build->v[1]) / 2};
    const double size = hypot(build->u[1] - build->u[0], build->v[1] - build->v[0]), slope = hypot(n[1], n[2]);
    if (!(slope > 0))
        return 0;
    const double off = (n[0] + n[1] * middle[0] + n[2] * middle[1]) / slope, h = build->limit_mm;
    if (!(fabs(off) < size))
        return 0;
    const double foot[2] = {middle[0] - off * n[1] / slope, middle[1] - off * n[2] / slope};
    const double from[3] = {h, h * (foot[0] + size * n[2] / slope), h * (foot[1] - size * n[1] / slope)};
    const double to[3] = {h, h * (foot[0] - size * n[2] / slope), h * (foot[1] + size * n[1] / slope)};
    const size_t before = build->map->line_count;
    if (add_line(build, LX_OUTLINE_HORIZON, from, to, 0))
        return -1;
    if (build->map->line_count > before)
        build->map->lines[before].change = (int)number;
    return 0;
}

/* Where the edge between two corners of a sheet comes through the plane x = limit, the same for both of its sheets. */
static void cross_limit(const double a[3], const double b[3], bool swap, double limit, double place[3])
{
    const double *from = swap ? b : a, *to = swap ? a : b;
    const double share = (limit - from[0]) / (to[0] - from[0]);
    for (int k = 0; k < 3; k++)
        place[k] = from[k] + share * (to[k] - from[k]);
    place[0] = limit;
}

/* Whether a sheet may be seen in the rectangle. */
static bool may_be_before(const struct map_build *build, const double corners[3][3])
{
    unsigned outside[4] = {0, 0, 0, 0};
    for (int i = 0; i < 3; i++) {
        const double *c = corners[i];
        outside[0] += c[1]<build->u[0] * c[0], outside[1] += c[1]> build->u[1] * c[0];
        outside[2] += c[2]<build->v[0] * c[0], outside[3] += c[2]> build->v[1] * c[0];
    }
    return outside[0] < 3 && outside[1] < 3 && outside[2] < 3 && outside[3] < 3;
}

/* Where a flat source's plane cuts a sheet; round sources may be met by it, unless it is among the obstacles. */
static int add_section(struct map_build *build, const struct lx_sheet *sheet)
{
    const double limit = build->limit_mm;
    double corners[3][3], ends[2][3], lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        to_frame(build->sweep, sheet->corners_mm[i], corners[i]);
        lowest = fmin(lowest, corners[i][0]);
        highest = fmax(highest, corners[i][0]);
    }
    if (!(highest > limit) || !(lowest < build->farthest_mm))
        return 0;
    build->occlusion->outline->is_doubtful |=
        build->farthest_mm > limit && !build->occlusion->has_polygons && may_be_before(build, corners);
    if (!(lowest <= limit))
        return 0;
    const bool turned = sheet->turn < 0;
    for (int i = 0; i < 3; i++) {
        const int a = turned ? 2 - i : i, b = turned ? (4 - i) % 3 : (i + 1) % 3;
        const bool from = corners[a][0] > limit, to = corners[b][0] > limit;
        if (from != to)
            cross_limit(corners[a], corners[b], sheet->names[a] > sheet->names[b], limit, ends[from]);
    }
    return add_line(build, LX_OUTLINE_EDGE, ends[0], ends[1], 1);
}

static int add_lines(struct map_build *build)
{
    const struct lx_obstacles *obstacles = &build->occlusion->obstacles;
    int failed = add_borders(build);
    for (unsigned i = 0; i < build->horizon_count && !failed; i++)
        failed = add_horizon(build, i);
    for (size_t i = 0; i < obstacles->edge_count && !failed; i++) {
        double from[3], to[3];
        to_frame(build->sweep, obstacles->edges[i].from_mm, from);
        to_frame(build->sweep, obstacles->edges[i].to_mm, to);
        failed = add_line(build, LX_OUTLINE_EDGE, from, to, obstacles->edges[i].change);
    }
    for (size_t i = 0; i < obstacles->sheet_count && !failed; i++)
        failed = add_section(build, &obstacles->sheets[i]);
    return failed;
}

/* What the difference of two heights may be off. */
static double rounding_of(const struct lx_outline_line *a, const struct lx_outline_line *b, double u)
{
    return 4 * DBL_EPSILON * (fabs(a->start) + fabs(a->rise * u) + fabs(b->start) + fabs(b->rise * u));
}

static int by_low(const void *a, const void *b)
{
    const struct lx_outline_line *x = a, *y = b;
    return (x->low > y->low) - (x->low < y->low);
}

static int add_crossings(struct map_build *build)
{
    const struct lx_trapezoid_map *map = build->map;
    for (size_t i = 0; i < map->line_count; i++) {
        const struct lx_outline_line *a = &map->lines[i];
        for (size_t k = i + 1; k < map->line_count && map->lines[k].low < a->high; k++) {
            const struct lx_outline_line *b = &map->lines[k];
            const double low = b->low, high = fmin(a->high, b->high);
            const double from = lx_outline_height(a, low) - lx_outline_height(b, low);
            const double to = lx_outline_height(a, high) - lx_outline_height(b, high);
            if (!((from < 0) != (to < 0)) || fabs(from) <= rounding_of(a, b, low) ||
                fabs(to) <= rounding_of(a, b, high))
                continue;
            if (build->event_count >= MOST_EVENTS) {
                build->occlusion->outline->is_broken = true;
                return 0;
            }
            if (add_event(build, low + (high - low) * (from / (from - to))))
                return -1;
        }
    }
    return 0;
}

/* ---- the whole ---- */

int lx_outline_draw(struct map_build *build)
{
    struct lx_trapezoid_map *map = build->map;
    bound_sweep(build);
    for (unsigned i = 0; i < build->occlusion->horizon_count; i++)
        to_frame(build->sweep, build->occlusion->horizons[i], build->horizons[build->horizon_count++]);
    if (!(build->u[0] < build->u[1]))
        return 0;
    if (add_lines(build) || add_event(build, build->u[1]))
        return -1;
    if (map->line_count > 1)
        qsort(map->lines, map->line_count, sizeof *map->lines, by_low);
    if (add_crossings(build))
        return -1;
    qsort(build->events, build->event_count, sizeof *build->events, lx_by_value);
    if (build->wall_count > 1)
        qsort(build->walls, build->wall_count, sizeof *build->walls, lx_by_value);
    return 0;
}

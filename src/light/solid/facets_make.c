/* SPDX-License-Identifier: MIT */
/*
 * Making facets: what all of them have, and the shapes that cannot go wrong: rectangles, boxes, and the polyhedra
 * inscribed in spheres and cylinders.  Corners are wide numbers, and right to some 1e-30 of the size.
 */
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/pose.h"
#include "../../base/rows.h"
#include "facets_make.h"

/* Faces, corners or sides between two questions whether to go on. */
enum { BETWEEN_CHECKS = 64 };

/* ---- memory ---- */

static void free_facets(struct lx_kept *kept)
{
    struct lx_facets *facets = (struct lx_facets *)kept;
    free(facets->corners_mm);
    free(facets->loop);
    free(facets->faces);
    free(facets->edges);
    free(facets);
}

struct lx_facets *lx_facets_new(size_t corner_count, size_t face_count, size_t loop_count)
{
    struct lx_facets *facets = lx_new_array(1, sizeof *facets);
    if (!facets)
        return NULL;
    lx_kept_init(&facets->kept, free_facets);
    facets->corners_mm = lx_new_aligned(corner_count, sizeof *facets->corners_mm);
    facets->corner_count = corner_count;
    facets->faces = lx_new_aligned(face_count, sizeof *facets->faces);
    facets->loop = lx_new_aligned(loop_count, sizeof *facets->loop);
    if (facets->corners_mm && facets->faces && facets->loop)
        return facets;
    lx_facets_free(facets);
    return NULL;
}

void lx_facets_add_face(struct lx_facets *facets, unsigned count)
{
    size_t n = facets->face_count;
    unsigned first = n > 0 ? facets->faces[n - 1].first + facets->faces[n - 1].count : 0;
    facets->faces[facets->face_count++] = (struct lx_face){.first = first, .count = count};
}

/* Appends a face with these corners. */
static void add_loop(struct lx_facets *facets, const unsigned corners[], unsigned count)
{
    lx_facets_add_face(facets, count);
    memcpy(facets->loop + facets->faces[facets->face_count - 1].first, corners, count * sizeof *corners);
}

/* ---- edges ---- */

/* An edge as one of its faces has it. */
struct side {
    unsigned low, high; /* its corners, the smaller number first */
    unsigned face, position;
    bool forward; /* the face's loop runs from low to high */
};

static bool list_sides(const struct lx_facets *facets, const struct lx_asking *asking, struct side *sides)
{
    size_t n = 0;
    for (size_t i = 0; i < facets->face_count; i++) {
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return false;
        const unsigned *loop = facets->loop + facets->faces[i].first;
        unsigned count = facets->faces[i].count;
        for (unsigned k = 0; k < count; k++) {
            unsigned from = loop[k], to = loop[(k + 1) % count];
            sides[n++] = (struct side){.low = from < to ? from : to,
                                       .high = from < to ? to : from,
                                       .face = (unsigned)i,
                                       .position = k,
                                       .forward = from < to};
        }
    }
    return true;
}

/* Sorts sides by one of their corners, stably, into another list; false: the work is to stop.  `begin` is room for a
 * number for each corner. */
static bool sort_by_corner(const struct side *sides, size_t count, bool by_high, size_t *begin, size_t corner_count,
                           struct side *sorted, const struct lx_asking *asking)
{
    size_t sum = 0;
    memset(begin, 0, corner_count * sizeof *begin);
    for (size_t i = 0; i < count; i++) {
        begin[by_high ? sides[i].high : sides[i].low]++;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return false;
    }
    for (size_t corner = 0; corner < corner_count; corner++) {
        const size_t here = begin[corner];
        begin[corner] = sum;
        sum += here;
        if (!lx_asking_at_step(asking, corner, BETWEEN_CHECKS))
            return false;
    }
    for (size_t i = 0; i < count; i++) {
        sorted[begin[by_high ? sides[i].high : sides[i].low]++] = sides[i];
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return false;
    }
    return true;
}

/* Sorts the sides, which are listed face by face, by their lower corners, then by the others, then by faces; false:
 * out of memory, or the work is to stop. */
static bool sort_sides(struct side *sides, size_t count, size_t corner_count, const struct lx_asking *asking)
{
    size_t *begin = lx_new_array(corner_count, sizeof *begin);
    struct side *other = lx_new_aligned(count, sizeof *other);
    const bool sorted = begin && other && sort_by_corner(sides, count, true, begin, corner_count, other, asking) &&
                        sort_by_corner(other, count, false, begin, corner_count, sides, asking);
    free(begin);
    free(other);
    return sorted;
}

static struct lx_edge edge_of(const struct side *side, int right)
{
    return (struct lx_edge){
        .from = side->forward ? side->low : side->high,
        .to = side->forward ? side->high : side->low,
        .left = (int)side->face,
        .right = right,
    };
}

/* Each edge of a closed shell has two sides, which run opposite ways. */
static struct lx_shape_report pair_sides(struct lx_facets *facets, struct side *sides, size_t count,
                                         const struct lx_asking *asking)
{
    if (!sort_sides(sides, count, facets->corner_count, asking))
        return (struct lx_shape_report){LX_SHAPE_OUT_OF_MEMORY, 0, 0};
    for (size_t i = 0; i < count; i += 2) {
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return (struct lx_shape_report){LX_SHAPE_OUT_OF_MEMORY, 0, 0};
        const struct side *one = &sides[i], *other = one + 1;
        bool alone = i + 1 == count || one->low != other->low || one->high != other->high;
        bool crowded = i + 2 < count && one->low == other[1].low && one->high == other[1].high;
        if (alone || crowded || one->forward == other->forward)
            return (struct lx_shape_report){LX_SHAPE_NOT_CLOSED, one->face, one->position};
        facets->edges[facets->edge_count++] = edge_of(one, (int)other->face);
    }
    return (struct lx_shape_report){LX_SHAPE_GOOD, 0, 0};
}

static struct lx_shape_report find_edges(struct lx_facets *facets, bool closed, const struct lx_asking *asking)
{
    size_t count = 0;
    for (size_t i = 0; i < facets->face_count; i++)
        count += facets->faces[i].count;
    struct lx_shape_report report = {LX_SHAPE_OUT_OF_MEMORY, 0, 0};
    struct side *sides = lx_new_aligned(count, sizeof *sides);
    facets->edges = lx_new_aligned(count, sizeof *facets->edges);
    if (sides && facets->edges && list_sides(facets, asking, sides)) {
        report.fault = LX_SHAPE_GOOD;
        if (closed)
            report = pair_sides(facets, sides, count, asking);
        for (size_t i = 0; i < count && !closed; i++)
            facets->edges[facets->edge_count++] = edge_of(&sides[i], LX_NO_FACE);
    }
    free(sides);
    return report;
}

/* ---- normals, sizes ---- */

/* Twice the area of a loop of corners times its normal (Newell's vector), seen from its first corner. */
static lx_wide3 newell_of(const lx_wide3 *corners_mm, const unsigned *loop, size_t count)
{
    lx_wide3 sum = lx_wide3_of((double[]){0, 0, 0}), first = corners_mm[loop[0]];
    lx_wide3 before = lx_wide3_sub(corners_mm[loop[1]], first);
    for (size_t i = 2; i < count; i++) {
        lx_wide3 next = lx_wide3_sub(corners_mm[loop[i]], first);
        sum = lx_wide3_add(sum, lx_wide3_cross(before, next));
        before = next;
    }
    return sum;
}

static double distance(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static bool find_sphere(struct lx_facets *facets, const struct lx_asking *asking)
{
    double n = (double)facets->corner_count;
    double sum[3] = {0, 0, 0};
    for (size_t i = 0; i < facets->corner_count; i++) {
        const lx_wide3 *corner = &facets->corners_mm[i];
        sum[0] += corner->x.high / n;
        sum[1] += corner->y.high / n;
        sum[2] += corner->z.high / n;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return false;
    }
    memcpy(facets->center_mm, sum, sizeof sum);
    double largest = 0;
    for (size_t i = 0; i < facets->corner_count; i++) {
        const lx_wide3 *corner = &facets->corners_mm[i];
        double place[3] = {corner->x.high, corner->y.high, corner->z.high};
        largest = fmax(largest, distance(place, sum));
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return false;
    }
    double rounding = 8 * DBL_EPSILON * (fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2]));
    facets->radius_mm = largest * (1 + 16 * DBL_EPSILON) + rounding;
    return true;
}

struct lx_shape_report lx_facets_finish(struct lx_facets *facets, bool closed, const struct lx_asking *asking)
{
    const struct lx_shape_report stopped = {LX_SHAPE_OUT_OF_MEMORY, 0, 0};
    lx_wide area = lx_wide_of(0);
    for (size_t i = 0; i < facets->face_count; i++) {
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return stopped;
        struct lx_face *face = &facets->faces[i];
        lx_wide3 newell = newell_of(facets->corners_mm, facets->loop + face->first, face->count);
        lx_wide length = lx_wide3_length(newell);
        if (!(length.high > 0))
            return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, i, 0};
        lx_wide3 normal = {lx_wide_div(newell.x, length), lx_wide_div(newell.y, length), lx_wide_div(newell.z, length)};
        face->normal = normal;
        face->area_mm2 = lx_wide_value(length) / 2;
        area = lx_wide_add(area, lx_wide_scale(length, 0.5));
    }
    facets->area_mm2 = lx_wide_value(area);
    return find_sphere(facets, asking) ? find_edges(facets, closed, asking) : stopped;
}

/* Facets that cannot be wrong, or NULL when out of memory, or where the work is to stop. */
static struct lx_facets *finished(struct lx_facets *facets, bool closed, const struct lx_asking *asking)
{
    if (lx_facets_finish(facets, closed, asking).fault == LX_SHAPE_GOOD)
        return facets;
    lx_facets_free(facets);
    return NULL;
}

void lx_facets_were_rounded(struct lx_facets *facets)
{
    if (!facets)
        return;
    const double *center = facets->center_mm;
    double away = fabs(center[0]) + fabs(center[1]) + fabs(center[2]);
    facets->corner_error_mm = 0x1p-92 * facets->radius_mm + 0x1p-96 * away;
}

/* ---- polygons and boxes ---- */

static bool is_axis(lx_wide3 a)
{
    return (a.x.high == 0) + (a.y.high == 0) + (a.z.high == 0) == 2;
}

struct lx_facets *lx_facets_of_pose(const double center_mm[3], const double size_mm[2], const struct lx_pose *pose)
{
    static const double signs[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    static const unsigned corners[4] = {0, 1, 2, 3};
    struct lx_facets *facets = lx_facets_new(4, 1, 4);
    if (!facets)
        return NULL;
    for (int i = 0; i < 4; i++) {
        lx_wide3 across = lx_wide3_mul(pose->across, lx_wide_of(signs[i][0] * size_mm[0]));
        lx_wide3 upward = lx_wide3_mul(pose->upward, lx_wide_of(signs[i][1] * size_mm[1]));
        facets->corners_mm[i] = lx_wide3_add(lx_wide3_of(center_mm), lx_wide3_add(across, upward));
    }
    add_loop(facets, corners, 4);
    facets = finished(facets, false, NULL);
    if (!is_axis(pose->axis) || !is_axis(pose->across))
        lx_facets_were_rounded(facets);
    if (facets) /* a thin one knows its own normal less well */
        facets->faces[0].normal = pose->axis;
    return facets;
}

struct lx_facets *lx_facets_turned(const struct lx_facets *sheet)
{
    const unsigned count = sheet->faces[0].count;
    struct lx_facets *turned = lx_facets_new(sheet->corner_count, 1, count);
    if (!turned)
        return NULL;
    memcpy(turned->corners_mm, sheet->corners_mm, sheet->corner_count * sizeof *sheet->corners_mm);
    for (unsigned i = 0; i < count; i++)
        turned->loop[i] = sheet->loop[sheet->faces[0].first + count - 1 - i];
    lx_facets_add_face(turned, count);
    turned = finished(turned, false, NULL);
    if (turned) {
        const lx_wide3 normal = sheet->faces[0].normal;
        turned->faces[0].normal = lx_wide3_sub(lx_wide3_of((const double[]){0, 0, 0}), normal);
        turned->corner_error_mm = sheet->corner_error_mm;
    }
    return turned;
}

struct lx_facets *lx_facets_of_rectangle(const double center_mm[3], const double size_mm[2], const double axis[3],
                                         const double up[3])
{
    struct lx_pose pose = lx_pose_of(axis, up);
    return lx_facets_of_pose(center_mm, size_mm, &pose);
}

struct lx_facets *lx_facets_of_box(const double center_mm[3], const double size_mm[3])
{
    /* Corner i lies on the far side in x, y, z by its bits 0, 1, 2. */
    static const unsigned faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    struct lx_facets *facets = lx_facets_new(8, 6, 24);
    if (!facets)
        return NULL;
    for (unsigned i = 0; i < 8; i++) {
        lx_wide at[3];
        for (unsigned k = 0; k < 3; k++)
            at[k] = lx_wide_add(lx_wide_of(center_mm[k]), lx_wide_of((i >> k & 1 ? 0.5 : -0.5) * size_mm[k]));
        facets->corners_mm[i] = (lx_wide3){at[0], at[1], at[2]};
    }
    for (int i = 0; i < 6; i++)
        add_loop(facets, faces[i], 4);
    return finished(facets, true, NULL);
}

/* ---- inscribed polyhedra ---- */

/* Sine and cosine of an angle in [0, pi/4]. */
static void sine_and_cosine(lx_wide angle, lx_wide *sine, lx_wide *cosine)
{
    enum { HALVINGS = 4, TERMS = 9 };
    lx_wide one = lx_wide_of(1), x = lx_wide_scale(angle, 1.0 / (1 << HALVINGS)), square = lx_wide_mul(x, x);
    lx_wide s = one, v = one; /* sin x = x s; 1 - cos x = x^2/2 v */
    for (int k = TERMS; k > 0; k--) {
        s = lx_wide_sub(one, lx_wide_div(lx_wide_mul(s, square), lx_wide_of(2 * k * (2 * k + 1))));
        v = lx_wide_sub(one, lx_wide_div(lx_wide_mul(v, square), lx_wide_of((2 * k + 1) * (2 * k + 2))));
    }
    s = lx_wide_mul(s, x);
    v = lx_wide_mul(v, lx_wide_scale(square, 0.5));
    for (int i = 0; i < HALVINGS; i++) { /* sin 2x = 2 sin x cos x, 1 - cos 2x = 2 sin^2 x */
        lx_wide twice = lx_wide_scale(s, 2);
        s = lx_wide_mul(twice, lx_wide_sub(one, v));
        v = lx_wide_mul(twice, lx_wide_scale(twice, 0.5));
    }
    *sine = s;
    *cosine = lx_wide_sub(one, v);
}

/* Sine and cosine of step/count of a full turn, for step < count < 2^28. */
static void of_turn(unsigned step, unsigned count, lx_wide *sine, lx_wide *cosine)
{
    unsigned octant = 8 * step / count, rest = 8 * step % count;
    bool mirrored = octant % 2 == 1;
    lx_wide share = lx_wide_div(lx_wide_of(mirrored ? count - rest : rest), lx_wide_of(count)), s, c;
    sine_and_cosine(lx_wide_mul(lx_wide_scale(lx_wide_pi(), 0.25), share), &s, &c);
    bool swapped = (octant + 1) / 2 % 2 == 1;
    lx_wide y = swapped ? c : s, x = swapped ? s : c;
    *sine = octant >= 4 ? lx_wide_negate(y) : y;
    *cosine = octant >= 2 && octant < 6 ? lx_wide_negate(x) : x;
}

/* The corner `step` on the parallel `band` of so many from the pole; the poles are the corners 0 and 1. */
static unsigned on_parallel(unsigned band, unsigned bands, unsigned step, unsigned meridians)
{
    if (band == 0 || band == bands)
        return band == bands;
    return 2 + (band - 1) * meridians + step % meridians;
}

/* The faces between two parallels. */
static void add_band(struct lx_facets *facets, unsigned band, unsigned bands, unsigned meridians)
{
    for (unsigned step = 0; step < meridians; step++) {
        unsigned corners[4] = {
            on_parallel(band, bands, step, meridians),
            on_parallel(band + 1, bands, step, meridians),
            on_parallel(band + 1, bands, step + 1, meridians),
            on_parallel(band, bands, step + 1, meridians),
        };
        if (band == bands - 1)
            corners[2] = corners[3];
        add_loop(facets, corners, band == 0 || band == bands - 1 ? 3 : 4);
    }
}

/* Frees facets in the making; NULL, for those that are not made. */
static struct lx_facets *abandon(struct lx_facets *facets)
{
    lx_facets_free(facets);
    return NULL;
}

struct lx_facets *lx_facets_make_sphere(const double center_mm[3], double radius_mm, unsigned meridians,
                                        const struct lx_asking *asking)
{
    unsigned bands = meridians / 2 < 2 ? 2 : meridians / 2;
    struct lx_facets *facets =
        lx_facets_new(2 + (size_t)(bands - 1) * meridians, (size_t)bands * meridians, 4 * (size_t)bands * meridians);
    if (!facets)
        return NULL;
    lx_wide3 center = lx_wide3_of(center_mm);
    lx_wide radius = lx_wide_of(radius_mm);
    for (unsigned i = 0; i < 2; i++) {
        facets->corners_mm[i] = center;
        facets->corners_mm[i].z = lx_wide_add(center.z, i ? lx_wide_negate(radius) : radius);
    }
    for (unsigned step = 0; step < meridians; step++) { /* first the way from the axis, the same on all parallels */
        lx_wide3 *way = &facets->corners_mm[on_parallel(1, bands, step, meridians)];
        of_turn(step, meridians, &way->y, &way->x);
        if (!lx_asking_at_step(asking, step, BETWEEN_CHECKS))
            return abandon(facets);
    }
    for (unsigned band = bands - 1; band > 0; band--) { /* the first parallel, which holds the ways, last */
        lx_wide s, c;
        of_turn(band, 2 * bands, &s, &c);
        s = lx_wide_mul(s, radius);
        for (unsigned step = 0; step < meridians; step++) {
            const lx_wide3 *way = &facets->corners_mm[on_parallel(1, bands, step, meridians)];
            lx_wide3 offset = {lx_wide_mul(s, way->x), lx_wide_mul(s, way->y), lx_wide_mul(c, radius)};
            facets->corners_mm[on_parallel(band, bands, step, meridians)] = lx_wide3_add(center, offset);
            if (!lx_asking_at_step(asking, step, BETWEEN_CHECKS))
                return abandon(facets);
        }
    }
    for (unsigned band = 0; band < bands; band++) {
        add_band(facets, band, bands, meridians);
        if (!lx_asking_goes_on(asking))
            return abandon(facets);
    }
    facets = finished(facets, true, asking);
    lx_facets_were_rounded(facets);
    return facets;
}

struct lx_facets *lx_facets_make_cylinder(const double center_mm[3], double radius_mm, double height_mm,
                                          const double axis[3], unsigned sides, const struct lx_asking *asking)
{
    struct lx_facets *facets = lx_facets_new(2 * (size_t)sides, (size_t)sides + 2, 6 * (size_t)sides);
    if (!facets)
        return NULL;
    double up[3];
    lx_usual_up(axis, up);
    struct lx_pose pose = lx_pose_of(axis, up);
    lx_wide3 half = lx_wide3_mul(pose.axis, lx_wide_of(height_mm / 2));
    for (unsigned i = 0; i < sides; i++) {
        lx_wide sine, cosine;
        of_turn(i, sides, &sine, &cosine);
        lx_wide3 across = lx_wide3_mul(pose.across, lx_wide_mul(lx_wide_of(radius_mm), cosine));
        lx_wide3 upward = lx_wide3_mul(pose.upward, lx_wide_mul(lx_wide_of(radius_mm), sine));
        lx_wide3 rim = lx_wide3_add(across, upward);
        facets->corners_mm[i] = lx_wide3_add(lx_wide3_of(center_mm), lx_wide3_sub(rim, half));
        facets->corners_mm[sides + i] = lx_wide3_add(lx_wide3_of(center_mm), lx_wide3_add(rim, half));
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return abandon(facets);
    }
    for (unsigned i = 0; i < sides; i++) {
        unsigned next = (i + 1) % sides;
        add_loop(facets, (const unsigned[]){i, next, sides + next, sides + i}, 4);
    }
    for (unsigned cap = 0; cap < 2; cap++) {
        lx_facets_add_face(facets, sides);
        unsigned *loop = facets->loop + facets->faces[facets->face_count - 1].first;
        for (unsigned i = 0; i < sides; i++)
            loop[i] = cap ? sides + i : sides - 1 - i;
    }
    facets = finished(facets, true, asking);
    lx_facets_were_rounded(facets);
    return facets;
}

/* SPDX-License-Identifier: MIT */
/*
 * The kernels of one instruction set: this file is compiled once for each, with LX_ISA its name as a C word,
 * LX_ISA_NAME as users write it, LX_ISA_LEVEL its x86-64 level (0: not of that family), and the compiler flags
 * that allow its instructions.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "../base/larger.h"
#include "../light/distribution.h"
#include "kernel_law.h"

#include "lanes_double.h"

#include "kernel_functions.h"

#include "kernel_space.h"

#include "kernel_facets.h"
#include "kernel_table.h"

#include "kernel_real.h"
#include "kernel_samples.h"
#include "kernel_beams.h"
#include "kernel_survey.h"

#include "kernel_angle.h"
#include "kernel_contour.h"
#include "kernel_round.h"

#include "kernel_series.h"
#include "kernel_smooth.h"

#include "lanes_single.h"

#include "kernel_functions.h"

#include "kernel_edge.h"

#include "kernel_space.h"

#include "kernel_facets.h"
#include "kernel_polynomial.h"
#include "kernel_tabled.h"
#include "kernel_table.h"

#include "kernel_real.h"
#include "kernel_samples.h"
#include "kernel_beams.h"
#include "kernel_survey.h"

static void set_all(double *values, size_t count, double number)
{
    for (size_t i = 0; i < count; i++)
        values[i] = number;
}

static void round_all(const double *restrict values, size_t count, float *restrict rounded)
{
    for (size_t i = 0; i < count; i++)
        rounded[i] = (float)values[i];
}

/*
 * A sphere seen along -z: the place is (dx, dy, sqrt(R^2 - dx^2 - dy^2)).  What is the same in the whole row is
 * formed in twice the precision, so that sources just above the surface find it where it is.
 */
struct sphere_row {
    double x, dy;         /* of the centre, and from it */
    struct lx_pair below; /* R^2 - dy^2 */
};

static struct sphere_row sphere_row_of(const struct lx_shape *sphere, const struct lx_row_view *view)
{
    const double dy = view->y_mm - sphere->anchor_mm[1];
    return (struct sphere_row){
        .x = sphere->anchor_mm[0],
        .dy = dy,
        .below = lx_exact_difference_of_squares(sphere->radius_mm, dy),
    };
}

struct sphere_places {
    lanes_double dx, below, height; /* below: the square of the height, less than 0 beside the sphere */
};

LX_LANE struct sphere_places sphere_places_at(struct sphere_row row, const double *x_mm)
{
    lanes_double dx, zero = all_double(0);
    memcpy(&dx, x_mm, sizeof dx);
    dx -= row.x;
    lanes_double below = row.below.high - dx * dx + row.below.low;
    return (struct sphere_places){dx, below, root_double(greater_double(below, zero))};
}

static void meet_parallel_lines(const struct lx_shape *sphere, const struct lx_row_view *view,
                                const double *restrict x_mm, size_t count, double *restrict depth, double *restrict px,
                                double *restrict py, double *restrict pz)
{
    const struct sphere_row row = sphere_row_of(sphere, view);
    const double top = view->observer_z_mm - sphere->anchor_mm[2];
    const lanes_double zero = all_double(0), infinite = all_double(HUGE_VAL);
    for (size_t i = 0; i < count; i += LX_WIDTH_double) {
        const struct sphere_places at = sphere_places_at(row, x_mm + i);
        store_double(depth + i, where_above_double(zero, at.below, infinite, top - at.height));
        store_double(px + i, at.dx);
        store_double(py + i, all_double(row.dy));
        store_double(pz + i, at.height);
    }
}

/* How many of the first lines meet a shape. */
static size_t count_met(const double *depth, size_t count)
{
    size_t met = 0;
    for (size_t i = 0; i < count; i++)
        met += depth[i] < HUGE_VAL;
    return met;
}

/* Adds lines to the whole lanes of a run that have lines which meet a shape. */
static void extend_stretch(struct lx_stretch *stretch, size_t first, size_t count, size_t met)
{
    if (met == 0)
        return;
    if (stretch->met == 0)
        stretch->first = first;
    stretch->count = first - stretch->first + count;
    stretch->met += met;
}

/* Lines that meet a shape, those of a finite depth; sets the mask. */
static void extend_by_depth(struct lx_stretch *stretch, const double *depth, size_t first, size_t count, uint8_t *mask)
{
    const size_t met = count_met(depth, count);
    memset(mask + first, met == count, count);
    for (size_t i = 0; i < count && met > 0 && met < count; i++)
        mask[first + i] = depth[i] < HUGE_VAL;
    extend_stretch(stretch, first, count, met);
}

/* A run of which all is met. */
static struct lx_stretch whole_stretch(size_t count, uint8_t *mask)
{
    memset(mask, 1, count);
    return (struct lx_stretch){0, count, count};
}

/* The columns' places on the screen, and from the shape's anchor. */
static void set_columns_plate(const struct lx_shape *shape, const double *x_mm, size_t count,
                              struct lx_columns *columns)
{
    for (size_t i = 0; i < lx_padded(count); i++) {
        columns->x_mm[i] = x_mm[i < count ? i : count - 1];
        columns->px[i] = (float)(columns->x_mm[i] - shape->anchor_mm[0]);
    }
    columns->count = count;
}

static void set_columns_sphere(const struct lx_shape *sphere, const double *x_mm, size_t count,
                               struct lx_columns *columns)
{
    const double x = sphere->anchor_mm[0], inverse = 1 / sphere->radius_mm;
    set_columns_plate(sphere, x_mm, count, columns);
    for (size_t i = 0; i < lx_padded(count); i++) {
        const double nx = (columns->x_mm[i] - x) * inverse, square = nx * nx;
        columns->nx[i] = (float)nx;
        columns->square[i] = (float)square;
        columns->rest[i] = (float)(square - (double)columns->square[i]);
    }
}

/* Elements of a sphere, from one of the columns on, in a row so high above its centre: nx^2 + nz^2 = 1 - ny^2. */
static void fill_sphere(const struct lx_shape *sphere, double dy, const struct lx_columns *columns, size_t first,
                        size_t count, struct lx_block_single *block)
{
    const double radius = sphere->radius_mm, ny = dy / radius, both = (1 - ny) * (1 + ny);
    const lanes_single py = all_single((float)dy), y = all_single((float)ny), zero = all_single(0);
    const float high = (float)both, low = (float)(both - (double)high);
    const float radius_high = (float)radius, radius_low = (float)(radius - (double)radius_high);
    for (size_t i = 0; i < count; i += LX_WIDTH_single) {
        const lanes_single square = load_single(columns->square + first + i);
        const lanes_single rest = load_single(columns->rest + first + i);
        const lanes_single nz = root_single(greater_single((high - square) + (low - rest), zero));
        store_single(block->px + i, load_single(columns->px + first + i));
        store_single(block->py + i, py);
        store_single(block->pz + i, radius_high * nz + radius_low * nz);
        store_single(block->nx + i, load_single(columns->nx + first + i));
        store_single(block->ny + i, y);
        store_single(block->nz + i, nz);
    }
}

/* How many of the lines from one to the other, whose x from the centre are given, are certain to meet a sphere. */
enum share { NONE, SOME, ALL };

static enum share share_on_sphere(double radius, double dy, double left, double right)
{
    const double doubt = 1e-12 * radius * radius; /* more than roundings */
    const double to_left = left * left, to_right = right * right;
    const double farthest = to_left > to_right ? to_left : to_right;
    const double nearest = left > 0 ? to_left : right < 0 ? to_right : 0;
    const double square = radius * radius - dy * dy;
    return farthest < square - doubt ? ALL : nearest > square + doubt ? NONE : SOME;
}

/* Infinite where one of some whole lanes of lines passes by the sphere, else 0. */
static void depths_on_sphere(const struct sphere_row *row, const double *x_mm, double *depth)
{
    const lanes_double zero = all_double(0), infinite = all_double(HUGE_VAL);
    for (size_t i = 0; i < LX_LANES; i += LX_WIDTH_double)
        store_double(depth + i, where_above_double(zero, sphere_places_at(*row, x_mm + i).below, infinite, zero));
}

/* Tries lines only of whole lanes that the rim may pass through. */
static struct lx_stretch view_sphere(const struct lx_shape *sphere, const struct lx_row_view *view,
                                     const struct lx_columns *columns, struct lx_block_single *block, uint8_t *mask)
{
    const double *x = columns->x_mm, from = sphere->anchor_mm[0], radius = sphere->radius_mm;
    const double dy = view->y_mm - sphere->anchor_mm[1];
    const size_t count = columns->count;
    struct lx_stretch stretch = {0};
    if (share_on_sphere(radius, dy, x[0] - from, x[count - 1] - from) == ALL) {
        stretch = whole_stretch(count, mask);
    } else {
        const struct sphere_row row = sphere_row_of(sphere, view);
        for (size_t i = 0; i < count; i += LX_LANES) {
            const size_t lanes = count - i < LX_LANES ? count - i : LX_LANES;
            const enum share share = share_on_sphere(radius, dy, x[i] - from, x[i + lanes - 1] - from);
            if (share == SOME) {
                _Alignas(LX_VECTOR_BYTES) double depth[LX_LANES];
                depths_on_sphere(&row, x + i, depth);
                extend_by_depth(&stretch, depth, i, lanes, mask);
            } else {
                memset(mask + i, share == ALL, lanes);
                extend_stretch(&stretch, i, lanes, share == ALL ? lanes : 0);
            }
        }
    }
    fill_sphere(sphere, dy, columns, stretch.first, lx_padded(stretch.count), block);
    return stretch;
}

/* A sphere seen from a point, as surface/sphere.c explains it: d the line, c from the centre to the observer. */
static void meet_central_lines(const struct lx_shape *sphere, const struct lx_row_view *view,
                               const double *restrict x_mm, size_t count, double *restrict depth, double *restrict px,
                               double *restrict py, double *restrict pz)
{
    const double r2 = sphere->radius_mm * sphere->radius_mm;
    const double cx = -sphere->anchor_mm[0], cy = -sphere->anchor_mm[1];
    const double cz = view->observer_z_mm - sphere->anchor_mm[2];
    const double dy = view->y_mm, dz = -view->observer_z_mm, wx = dy * cz - dz * cy;
    const lanes_double zero = all_double(0), infinite = all_double(HUGE_VAL);
    for (size_t i = 0; i < count; i += LX_WIDTH_double) {
        const lanes_double dx = load_double(x_mm + i), wy = dz * cx - dx * cz, wz = dx * cy - dy * cx;
        const lanes_double a = dx * dx + dy * dy + dz * dz, below = a * r2 - (wx * wx + wy * wy + wz * wz);
        const lanes_double root = root_double(greater_double(below, zero)), inverse = inverse_double(a);
        const lanes_double met = -(dx * cx + dy * cy + dz * cz + root) * inverse;
        store_double(depth + i, where_above_double(zero, below, infinite, met));
        store_double(px + i, (wy * dz - wz * dy - dx * root) * inverse);
        store_double(py + i, (wz * dx - wx * dz - dy * root) * inverse);
        store_double(pz + i, (wx * dy - wy * dx - dz * root) * inverse);
    }
}

static size_t meet_sphere(const struct lx_shape *sphere, const struct lx_row_view *view, const double *x_mm,
                          size_t count, double *depth, double *px, double *py, double *pz)
{
    if (view->perspective)
        meet_central_lines(sphere, view, x_mm, lx_padded(count), depth, px, py, pz);
    else
        meet_parallel_lines(sphere, view, x_mm, lx_padded(count), depth, px, py, pz);
    return count_met(depth, count);
}

static void look_at(const double observer_mm[3], struct lx_block_double *block, struct lx_block_single *copy,
                    size_t count)
{
    for (size_t i = 0; i < count; i += LX_WIDTH_double) {
        const lanes_double x = observer_mm[0] - load_double(block->px + i),
                           y = observer_mm[1] - load_double(block->py + i),
                           z = observer_mm[2] - load_double(block->pz + i);
        const lanes_double inverse = inverse_root_double(x * x + y * y + z * z);
        store_double(block->vx + i, x * inverse);
        store_double(block->vy + i, y * inverse);
        store_double(block->vz + i, z * inverse);
    }
    for (size_t i = 0; i < count; i++)
        copy->vx[i] = (float)block->vx[i], copy->vy[i] = (float)block->vy[i], copy->vz[i] = (float)block->vz[i];
}

/* The view vectors of a block whose places and normals are set, unless they stay, and the copy of all in float32. */
static void finish_block(const double *observer_mm, struct lx_block_double *block, struct lx_block_single *copy,
                         size_t count)
{
    if (observer_mm)
        look_at(observer_mm, block, copy, count);
    for (size_t i = 0; i < count; i++) {
        copy->px[i] = (float)block->px[i], copy->py[i] = (float)block->py[i], copy->pz[i] = (float)block->pz[i];
        copy->nx[i] = (float)block->nx[i], copy->ny[i] = (float)block->ny[i], copy->nz[i] = (float)block->nz[i];
    }
}

static void complete_sphere(const struct lx_shape *sphere, const double *observer_mm, struct lx_block_double *block,
                            struct lx_block_single *copy, size_t count)
{
    const double inverse = 1 / sphere->radius_mm;
    count = lx_padded(count);
    for (size_t i = 0; i < count; i++) {
        block->nx[i] = block->px[i] * inverse;
        block->ny[i] = block->py[i] * inverse;
        block->nz[i] = block->pz[i] * inverse;
    }
    finish_block(observer_mm, block, copy, count);
}

/* As sphere_blocks() of surface/sphere.c. */
static void block_by_sphere(const struct lx_blocker *blocker, const struct lx_block_double *block, size_t count,
                            float *restrict open)
{
    const double *center = blocker->shape.anchor_mm, *light = blocker->light;
    const double r2 = blocker->shape.radius_mm * blocker->shape.radius_mm;
    const double farthest = blocker->is_point ? 1 : HUGE_VAL, place = blocker->is_point ? 1 : 0;
    const double lx = light[0] - center[0], ly = light[1] - center[1], lz = light[2] - center[2];
    const bool light_inside = blocker->is_point && lx * lx + ly * ly + lz * lz < r2;
    const double own_r2 = light_inside ? r2 : 0; /* elements nearer than this share the inside with the light */
    count = lx_padded(count);
    for (size_t i = 0; i < count; i++) {
        double x = block->px[i] - center[0], y = block->py[i] - center[1], z = block->pz[i] - center[2];
        double tx = light[0] - place * block->px[i], ty = light[1] - place * block->py[i];
        double tz = light[2] - place * block->pz[i];
        double from = x * x + y * y + z * z;
        double t = -(x * tx + y * ty + z * tz) / (tx * tx + ty * ty + tz * tz);
        t = t > 0 ? t : 0;
        t = t < farthest ? t : farthest;
        x += t * tx;
        y += t * ty;
        z += t * tz;
        float reached = x * x + y * y + z * z < r2 ? 0 : open[i];
        open[i] = from < own_r2 ? open[i] : reached;
    }
}

#include "kernel_plate.h"

static bool runs(void)
{
#if LX_ISA_LEVEL >= 4
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512bw") ||
        !__builtin_cpu_supports("avx512cd") || !__builtin_cpu_supports("avx512dq") ||
        !__builtin_cpu_supports("avx512vl"))
        return false;
#endif
#if LX_ISA_LEVEL >= 3
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") || !__builtin_cpu_supports("bmi2"))
        return false;
#endif
    return true;
}

#ifndef LX_WITHOUT_TABLE /* tests of single functions do without the kernels, which take long to compile */
#define TABLE_OF(isa) TABLE_NAME(isa)
#define TABLE_NAME(isa) lx_kernels_##isa

extern const struct lx_kernels TABLE_OF(LX_ISA);
const struct lx_kernels TABLE_OF(LX_ISA) = {
    .name = LX_ISA_NAME,
    .runs = runs,
    .width = LX_WIDTH_single,
    .shade_single = shade_single,
    .shade_double = shade_double,
    .value_single = value_single,
    .samples_single = samples_single,
    .samples_double = samples_double,
    .beams_single = sum_beams_single,
    .beams_double = sum_beams_double,
    .survey_single = survey_single,
    .survey_double = survey_double,
    .set_all = set_all,
    .round_all = round_all,
    .find_polynomial = find_polynomial,
    .spread_polynomial = spread_polynomial,
    .spread_tabled = spread_tabled,
    .find_angles = find_angles,
    .bound_smooth = bound_smooth,
    .bound_foot = bound_foot,
    .find_roots = find_roots,
    .facets_single = light_by_facets_single,
    .light_by_area_light = {[LX_FACETS] = light_by_facets_double,
                       [LX_DISK] = light_by_disk,
                       [LX_BALL] = light_by_ball,
                       [LX_CYLINDER] = light_by_cylinder},
    .law_single = {[LX_FACETS] = LX_OF_ISA(lx_facets_by_rows_single),
                   [LX_DISK] = LX_OF_ISA(lx_round_by_rows_single),
                   [LX_BALL] = LX_OF_ISA(lx_ball_by_rings_single),
                   [LX_CYLINDER] = LX_OF_ISA(lx_round_by_rows_single)},
    .law_double = {[LX_FACETS] = LX_OF_ISA(lx_facets_by_rows_double),
                   [LX_DISK] = LX_OF_ISA(lx_round_by_rows_double),
                   [LX_BALL] = LX_OF_ISA(lx_ball_by_rings_double),
                   [LX_CYLINDER] = LX_OF_ISA(lx_round_by_rows_double)},
    .meet_lines = LX_BY_SHAPE(meet),
    .complete_block = LX_BY_SHAPE(complete),
    .set_columns = LX_BY_SHAPE(set_columns),
    .view_single = LX_BY_SHAPE(view),
    .block_light = LX_BY_SHAPE(block_by),
};
#endif

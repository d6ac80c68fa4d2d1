/* SPDX-License-Identifier: MIT */
/*
 * The kernels of one instruction set: this file is compiled once for each, with LX_ISA its name as a C word,
 * LX_ISA_NAME as users write it, LX_ISA_LEVEL its x86-64 level (0: not of that family), and the compiler flags
 * that allow its instructions.
 */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "../base/larger.h"
#include "kernel.h"

#define REAL double
#define LX_IS_SINGLE 0
#define SUFFIX pd
#define NAME(x) x##_double
#define BITS uint64_t
#define MANTISSA 52
#define BIAS 1023
#define MAGIC 6755399441055744.0
#define SMALLEST 2.2250738585072014e-308
#define TINY 1e-200
#define SQRT sqrt
#define LOG_TERMS 11
#define EXP_TERMS 14
#include "lanes.h"

#include "kernel_functions.h"

#include "kernel_facets.h"
#include "kernel_real.h"
#include "kernel_samples.h"
#include "kernel_survey.h"

#include "kernel_angle.h"
#include "kernel_contour.h"
#include "kernel_round.h"
#undef REAL
#undef LX_IS_SINGLE
#undef SUFFIX
#undef NAME
#undef BITS
#undef MANTISSA
#undef BIAS
#undef MAGIC
#undef SMALLEST
#undef TINY
#undef SQRT
#undef LOG_TERMS
#undef EXP_TERMS

#define REAL float
#define LX_IS_SINGLE 1
#define SUFFIX ps
#define NAME(x) x##_single
#define BITS uint32_t
#define MANTISSA 23
#define BIAS 127
#define MAGIC 12582912.0F
#define SMALLEST 1.17549435e-38
#define TINY 1e-30F
#define SQRT sqrtf
#define LOG_TERMS 5
#define EXP_TERMS 8
#include "lanes.h"

#include "kernel_functions.h"

#include "kernel_edge.h"

#include "kernel_facets.h"
#include "kernel_real.h"
#include "kernel_samples.h"
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
 * Of a sphere seen along -z: the place is (dx, dy, sqrt(R^2 - dx^2 - dy^2)).  What is the same in the whole row is
 * formed in twice the precision, so that sources just above the surface find it where it is.
 */
struct sphere_row {
    double x, dy;         /* of the centre, and from it */
    struct lx_pair below; /* R^2 - dy^2 */
    double inverse;       /* 1/R */
};

static struct sphere_row sphere_row_of(const struct lx_shape *sphere, const struct lx_row_view *view)
{
    const double dy = view->y_mm - sphere->anchor_mm[1];
    return (struct sphere_row){
        .x = sphere->anchor_mm[0],
        .dy = dy,
        .below = lx_exact_difference_of_squares(sphere->radius_mm, dy),
        .inverse = 1 / sphere->radius_mm,
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

/* Half a vector of float32. */
typedef float rounded_lanes __attribute__((vector_size(LX_VECTOR_BYTES / 2)));

LX_LANE void store_rounded(float *to, lanes_double lanes)
{
    *(rounded_lanes *)__builtin_assume_aligned(to, sizeof(rounded_lanes)) =
        __builtin_convertvector(lanes, rounded_lanes);
}

/* How many of the first lines meet a shape. */
static size_t count_met(const double *depth, size_t count)
{
    size_t met = 0;
    for (size_t i = 0; i < count; i++)
        met += depth[i] < HUGE_VAL;
    return met;
}

/* The whole lanes of a run that have lines which meet a shape, those of a finite depth; sets the mask. */
static struct lx_stretch stretch_of(const double *depth, size_t count, uint8_t *mask)
{
    struct lx_stretch stretch = {0};
    for (size_t i = 0; i < count; i += LX_LANES) {
        const size_t lanes = count - i < LX_LANES ? count - i : LX_LANES, met = count_met(depth + i, lanes);
        memset(mask + i, met == lanes, lanes);
        for (size_t k = 0; k < lanes && met > 0 && met < lanes; k++)
            mask[i + k] = depth[i + k] < HUGE_VAL;
        if (met == 0)
            continue;
        if (stretch.count == 0)
            stretch.first = i;
        stretch.count = i - stretch.first + lanes;
        stretch.met += met;
    }
    return stretch;
}

/* A run of which all is met. */
static struct lx_stretch whole_stretch(size_t count, uint8_t *mask)
{
    memset(mask, 1, count);
    return (struct lx_stretch){0, count, count};
}

/* Whether the lines all meet the sphere. */
static bool fill_sphere(struct sphere_row row, const double *restrict x_mm, size_t count,
                        struct lx_block_single *restrict block)
{
    lanes_double least = all_double(HUGE_VAL);
    for (size_t i = 0; i < count; i += LX_WIDTH_double) {
        const struct sphere_places at = sphere_places_at(row, x_mm + i);
        least = lesser_double(at.below, least);
        store_rounded(block->px + i, at.dx);
        store_rounded(block->py + i, all_double(row.dy));
        store_rounded(block->pz + i, at.height);
        store_rounded(block->nx + i, at.dx * row.inverse);
        store_rounded(block->ny + i, all_double(row.dy * row.inverse));
        store_rounded(block->nz + i, at.height * row.inverse);
    }
    return !any_above_double(all_double(0), least);
}

static struct lx_stretch view_sphere(const struct lx_shape *sphere, const struct lx_row_view *view, const double *x_mm,
                                     size_t count, struct lx_block_single *block, uint8_t *mask)
{
    const struct sphere_row row = sphere_row_of(sphere, view);
    const lanes_double zero = all_double(0), infinite = all_double(HUGE_VAL);
    _Alignas(LX_VECTOR_BYTES) double depth[LX_BLOCK];
    if (fill_sphere(row, x_mm, lx_padded(count), block))
        return whole_stretch(count, mask);
    for (size_t i = 0; i < count; i += LX_WIDTH_double)
        store_double(depth + i, where_above_double(zero, sphere_places_at(row, x_mm + i).below, infinite, zero));
    const struct lx_stretch stretch = stretch_of(depth, count, mask);
    fill_sphere(row, x_mm + stretch.first, lx_padded(stretch.count), block);
    return stretch;
}

/* Of a sphere seen from a point, as surface/sphere.c explains it: d the line, c from the centre to the observer. */
static void meet_central_lines(const struct lx_shape *sphere, const struct lx_row_view *view,
                               const double *restrict x_mm, size_t count, double *restrict depth, double *restrict px,
                               double *restrict py, double *restrict pz)
{
    const double r2 = sphere->radius_mm * sphere->radius_mm;
    const double cx = -sphere->anchor_mm[0], cy = -sphere->anchor_mm[1];
    const double cz = view->observer_z_mm - sphere->anchor_mm[2];
    const double dy = view->y_mm, dz = -view->observer_z_mm;
    for (size_t i = 0; i < count; i++) {
        double dx = x_mm[i];
        double wx = dy * cz - dz * cy, wy = dz * cx - dx * cz, wz = dx * cy - dy * cx;
        double a = dx * dx + dy * dy + dz * dz;
        double below = a * r2 - (wx * wx + wy * wy + wz * wz);
        double root = sqrt(below > 0 ? below : 0);
        depth[i] = below >= 0 ? -(dx * cx + dy * cy + dz * cz + root) / a : HUGE_VAL;
        px[i] = (wy * dz - wz * dy - dx * root) / a;
        py[i] = (wz * dx - wx * dz - dy * root) / a;
        pz[i] = (wx * dy - wy * dx - dz * root) / a;
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
    for (size_t i = 0; i < count; i++) {
        double x = observer_mm[0] - block->px[i], y = observer_mm[1] - block->py[i], z = observer_mm[2] - block->pz[i];
        double inverse = 1 / sqrt(x * x + y * y + z * z);
        block->vx[i] = x * inverse;
        block->vy[i] = y * inverse;
        block->vz[i] = z * inverse;
        copy->vx[i] = (float)block->vx[i], copy->vy[i] = (float)block->vy[i], copy->vz[i] = (float)block->vz[i];
    }
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
    .shade_single = shade_single,
    .shade_double = shade_double,
    .samples_single = samples_single,
    .samples_double = samples_double,
    .survey_single = survey_single,
    .survey_double = survey_double,
    .set_all = set_all,
    .round_all = round_all,
    .facets_single = light_by_facets_single,
    .light_by_shell = {[LX_FACETS] = light_by_facets_double,
                       [LX_DISK] = light_by_disk,
                       [LX_BALL] = light_by_ball,
                       [LX_CYLINDER] = light_by_cylinder},
    .meet_lines = {[LX_SPHERE] = meet_sphere, [LX_PLATE] = meet_plate},
    .complete_block = {[LX_SPHERE] = complete_sphere, [LX_PLATE] = complete_plate},
    .view_single = {[LX_SPHERE] = view_sphere, [LX_PLATE] = view_plate},
    .block_light = {[LX_SPHERE] = block_by_sphere, [LX_PLATE] = block_by_plate},
};
#endif

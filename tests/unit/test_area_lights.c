/* SPDX-License-Identifier: MIT */
/*
 * What the kernels make of extended sources, one block at a time: the closed forms against the reference, near and far,
 * whole and cut by the horizon, and samples of their patches against what each of them is worth.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "extended_sources.h"
#include "light/solid/facets.h"
#include "picture/lights.h"
#include "picture/patch.h"
#include "picture/sampling.h"
#include "random_scenes.h"
#include "world/integral/cubature.h"

static const double center[3] = {40, -25, 700};

static const double anchor[3] = {10, 20, 300};

static void round_block(const struct lx_block_double *block, struct lx_block_single *copy)
{
    for (int i = 0; i < LX_BLOCK; i++) {
        copy->px[i] = (float)block->px[i], copy->py[i] = (float)block->py[i], copy->pz[i] = (float)block->pz[i];
        copy->nx[i] = (float)block->nx[i], copy->ny[i] = (float)block->ny[i], copy->nz[i] = (float)block->nz[i];
        copy->vx[i] = (float)block->vx[i], copy->vy[i] = (float)block->vy[i], copy->vz[i] = (float)block->vz[i];
    }
}

/* Elements around a place, at most so far apart, which face the source, or any way, or lie so that it sets. */
static void make_block(struct randomness *random, struct lx_block_double *block, struct lx_block_single *copy)
{
    double way[3], apart = logarithmic(random, 1, 1000), away = 280 + logarithmic(random, 1, 1e5);
    random_direction(random, way);
    memset(block, 0, sizeof *block);
    for (int i = 0; i < LX_BLOCK; i++) {
        double place[3], n[3], v[3], from[3], length = 0, off[3], reach = 0;
        random_direction(random, off);
        random_direction(random, n);
        random_direction(random, v);
        for (int k = 0; k < 3; k++) {
            place[k] = center[k] + away * way[k] + uniform(random, 0, 1) * fmin(apart, away - 270) * off[k];
            from[k] = place[k] - center[k];
            reach = hypot(reach, from[k]);
        }
        for (int k = 0; k < 3; k++) {
            if (i % 4 == 1) /* to the source */
                n[k] -= 2 * from[k] / reach;
            if (i % 4 == 2) /* as the source sets */
                n[k] = uniform(random, -1, 1) - from[k] / reach * 150 / reach;
        }
        if (i % 4 == 2) {
            double along = 0;
            for (int k = 0; k < 3; k++)
                along += n[k] * from[k] / reach;
            double wanted = uniform(random, -1, 1) * 150 / reach;
            for (int k = 0; k < 3; k++)
                n[k] += (wanted - along) * from[k] / reach;
        }
        for (int k = 0; k < 3; k++)
            length = hypot(length, n[k]);
        block->px[i] = place[0] - anchor[0], block->py[i] = place[1] - anchor[1], block->pz[i] = place[2] - anchor[2];
        block->nx[i] = n[0] / length, block->ny[i] = n[1] / length, block->nz[i] = n[2] / length;
        block->vx[i] = v[0], block->vy[i] = v[1], block->vz[i] = v[2];
    }
    round_block(block, copy);
}

static void place_and_normal(const struct lx_block_double *block, size_t i, lx_bounded3 *place, lx_bounded3 *normal)
{
    *place = lx_exact3((const double[]){anchor[0] + block->px[i], anchor[1] + block->py[i], anchor[2] + block->pz[i]});
    *normal = lx_exact3((const double[]){block->nx[i], block->ny[i], block->nz[i]});
}

/* A source of some kind, and what the kernels know of it. */
struct body {
    struct lx_emitter source;
    struct lx_area_light lamp;
};

static struct body make_body(int kind)
{
    const struct lx_shape lit = {.anchor_mm = {anchor[0], anchor[1], anchor[2]}};
    struct body body = {.source = source_of(kind, center, 3, 250)};
    assert_int_equal(lx_area_light_make(&body.source, &lit, NULL, &body.lamp), LUXEL_OK);
    if (body.lamp.type == LX_FACETS)
        assert_int_equal(lx_area_light_make_single(&body.lamp, NULL), LUXEL_OK);
    return body;
}

static void clear_body(struct body *body)
{
    lx_area_light_clear(&body->lamp);
    lx_facets_free(body->source.facets);
}

static void closed_forms(void **state)
{
    static struct lx_block_double block;
    static struct lx_block_single copy;
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct body body = make_body(kind);
        struct randomness random = {.state = 61};
        for (int n = 0; n < 60; n++) {
            double expected[LX_BLOCK], most[LX_BLOCK];
            make_block(&random, &block, &copy);
            for (size_t i = 0; i < LX_BLOCK; i++) {
                lx_bounded3 place, normal;
                place_and_normal(&block, i, &place, &normal);
                expected[i] = lx_extended_irradiance(&body.source, place, normal).value;
                double distance = lx_length3(lx_sub3(place, lx_exact3(center))).value;
                most[i] = 3 * M_PI * fmin(1, 250 * 250 / distance / distance);
            }
            for (size_t k = 0; lx_kernels_get(k); k++) {
                const struct lx_kernels *kernels = lx_kernels_get(k);
                double sum[LX_BLOCK];
                if (!kernels->runs())
                    continue;
                for (int i = 0; i < LX_BLOCK; i++)
                    sum[i] = 0.5;
                kernels->light_by_area_light[body.lamp.type](&body.lamp, 0.75, &block, LX_BLOCK, NULL, sum);
                for (int i = 0; i < LX_BLOCK; i++) {
                    double off = fabs(sum[i] - 0.5 - 0.75 * expected[i]) / (most[i] + 1e-3);
                    if (!(off <= 2e-13))
                        fail_msg("%s, source %d, block %d, element %d: %.17g, expected %.17g", kernels->name, kind, n,
                                 i, (sum[i] - 0.5) / 0.75, expected[i]);
                }
            }
        }
        clear_body(&body);
    }
}

/* The elements of some runs of a block face the source, so that it stands wholly above their horizon. */
static void turn_runs(struct randomness *random, struct lx_block_double *block, struct lx_block_single *copy)
{
    for (size_t start = 0; start < LX_BLOCK; start += LX_LANES) {
        const bool turned = pick(random, 3) > 0;
        for (size_t i = start; turned && i < start + LX_LANES; i++) {
            const double x = center[0] - anchor[0] - block->px[i], y = center[1] - anchor[1] - block->py[i];
            const double z = center[2] - anchor[2] - block->pz[i], length = sqrt(x * x + y * y + z * z);
            block->nx[i] = x / length, block->ny[i] = y / length, block->nz[i] = z / length;
        }
    }
    round_block(block, copy);
}

/* Makes a block, which is arrays of numbers of a size, begin with a run of another one. */
static void begin_with(void *block, const void *other, size_t size, size_t start)
{
    enum { ARRAYS = sizeof(struct lx_block_double) / (LX_BLOCK * sizeof(double)) };
    for (size_t k = 0; k < ARRAYS; k++)
        memcpy((char *)block + k * LX_BLOCK * size, (const char *)other + (k * LX_BLOCK + start) * size,
               LX_LANES * size);
}

/* By the closed forms in float64, and in float32 where there are such. */
static void add_body(const struct lx_kernels *kernels, const struct lx_area_light *lamp,
                     const struct lx_block_double *block, const struct lx_block_single *copy, size_t count, double *sum,
                     double *sum_in_single)
{
    kernels->light_by_area_light[lamp->type](lamp, 0.75, block, count, NULL, sum);
    if (lamp->edges_single)
        kernels->facets_single(lamp, 0.75, copy, count, NULL, sum_in_single);
}

/* What stands beside an element does not matter to it, also where vectors of them go side by side. */
static void check_runs(const struct lx_kernels *kernels, const struct lx_area_light *lamp,
                       const struct lx_block_double *block, const struct lx_block_single *copy)
{
    static struct lx_block_double alone;
    static struct lx_block_single copy_alone;
    double sum[LX_BLOCK] = {0}, sum_in_single[LX_BLOCK] = {0};
    add_body(kernels, lamp, block, copy, LX_BLOCK, sum, sum_in_single);
    for (size_t start = 0; start < LX_BLOCK; start += LX_LANES) {
        double run[LX_LANES] = {0}, run_in_single[LX_LANES] = {0};
        begin_with(&alone, block, sizeof *block->px, start);
        begin_with(&copy_alone, copy, sizeof *copy->px, start);
        add_body(kernels, lamp, &alone, &copy_alone, LX_LANES, run, run_in_single);
        assert_memory_equal(run, sum + start, sizeof run);
        assert_memory_equal(run_in_single, sum_in_single + start, sizeof run_in_single);
    }
}

static void runs_by_themselves(void **state)
{
    static struct lx_block_double block;
    static struct lx_block_single copy;
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct body body = make_body(kind);
        struct randomness random = {.state = 62};
        for (int n = 0; n < 40; n++) {
            make_block(&random, &block, &copy);
            turn_runs(&random, &block, &copy);
            for (size_t k = 0; lx_kernels_get(k); k++)
                if (lx_kernels_get(k)->runs())
                    check_runs(lx_kernels_get(k), &body.lamp, &block, &copy);
        }
        clear_body(&body);
    }
}

/* -- samples -- */

/* The sum over all samples of a source, its patches cut into so many cells each way. */
static void sum_samples(const struct lx_kernels *kernels, const struct lx_area_light *lamp, enum lx_attenuation law,
                        const struct lx_lobe_double *lobe, const struct lx_block_double *block, unsigned side,
                        double sum[LX_LANES])
{
    enum { MOST_PATCHES = 64, CELLS = 8 };
    static const double metres[] = {
        [LX_INVERSE_SQUARE] = 1, [LX_PRACTICAL] = 1e-3, [LX_NO_ATTENUATION] = 1e-6, [LX_POLYNOMIAL] = 1e-6};
    static struct lx_samples_double samples;
    struct lx_patch patches[MOST_PATCHES];
    struct lx_around around = lx_run_around(block, 0);
    assert_true(lx_patch_limit(lamp) <= MOST_PATCHES);
    size_t count = lx_patches_make(lamp, &around, NULL, patches);
    assert_true(count <= lx_patch_limit(lamp));
    for (int i = 0; i < LX_LANES; i++)
        sum[i] = 0;
    samples.law = law;
    samples.k = 250;
    samples.by_none = 0.2, samples.by_root = 0.3, samples.by_square = 0.4; /* as source_of() has them */
    for (size_t p = 0; p < count; p++)
        for (int c = 0; c < CELLS * CELLS; c++) {
            struct lx_cell cell = {(double)(c % CELLS) / CELLS, (double)(c / CELLS) / CELLS, 1.0 / CELLS, 1.0 / CELLS};
            double part[LX_LANES];
            lx_patch_samples(&patches[p], lamp->touch_mm, &samples);
            lx_cell_samples(&patches[p], &cell, side, lamp->radiance * metres[law], 2, &samples);
            kernels->samples_double(&samples, 2, (size_t)side * side, lobe, block, 0, part);
            for (int i = 0; i < LX_LANES; i++)
                sum[i] += part[i];
        }
}

/* Elements that see all of the source, from the middle distance, along a way that is drawn. */
static void make_run(struct randomness *random, struct lx_block_double *block)
{
    double way[3];
    random_direction(random, way);
    memset(block, 0, sizeof *block);
    for (int i = 0; i < LX_LANES; i++) {
        double n[3], v[3], lengths[2] = {0, 0}, away = uniform(random, 700, 1500), lean[3], aside[3];
        random_direction(random, lean);
        random_direction(random, aside);
        for (int k = 0; k < 3; k++) {
            n[k] = -way[k] + 0.4 * lean[k], v[k] = -way[k] + 0.6 * aside[k];
            lengths[0] = hypot(lengths[0], n[k]), lengths[1] = hypot(lengths[1], v[k]);
        }
        block->px[i] = center[0] + away * way[0] - anchor[0] + 20 * aside[0];
        block->py[i] = center[1] + away * way[1] - anchor[1] + 20 * aside[1];
        block->pz[i] = center[2] + away * way[2] - anchor[2] + 20 * aside[2];
        block->nx[i] = n[0] / lengths[0], block->ny[i] = n[1] / lengths[0], block->nz[i] = n[2] / lengths[0];
        block->vx[i] = v[0] / lengths[1], block->vy[i] = v[1] / lengths[1], block->vz[i] = v[2] / lengths[1];
    }
}

/* The matte part and the highlight of every law, by samples, are those of the integrals. */
static void samples_are_the_integral(void **state)
{
    static struct lx_block_double block;
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct body body = make_body(kind);
        struct randomness random = {.state = 62};
        for (int n = 0; n < 24; n++) {
            struct lx_lobe lobe = {.model = n % 3 == 0   ? LX_LAMBERT
                                            : n % 3 == 1 ? LX_BLINN_PHONG
                                                         : LX_PHONG,
                                   .highlight = (enum lx_highlight)(n / 3 % 3),
                                   .diffuse = lx_exact(n % 3 ? 0 : 0.75),
                                   .specular = lx_exact(n % 3 ? 0.6 : 0),
                                   .exponent = 4};
            struct lx_lobe_double constants = {.model = lobe.model,
                                               .highlight = lobe.highlight,
                                               .diffuse = lobe.diffuse.value,
                                               .specular = lobe.specular.value,
                                               .exponent = lx_exponent_of(4)};
            make_run(&random, &block);
            body.source.attenuation = (enum lx_attenuation)(n % 8 % LX_LAWS);
            double expected[LX_LANES];
            for (size_t i = 0; i < LX_LANES; i++) {
                struct lx_element element = {.lobe = &lobe};
                place_and_normal(&block, i, &element.place_mm, &element.normal);
                element.view = lx_exact3((const double[]){block.vx[i], block.vy[i], block.vz[i]});
                struct lx_cubature truth = lx_integrate(&body.source, &element, NULL, n % 3 == 0, 0, 1e-9, NULL);
                expected[i] = n % 3 ? truth.specular.value : 0.75 * truth.irradiance.value;
            }
            for (size_t k = 0; lx_kernels_get(k); k++) {
                const struct lx_kernels *kernels = lx_kernels_get(k);
                double fine[LX_LANES], coarse[LX_LANES];
                if (!kernels->runs())
                    continue;
                sum_samples(kernels, &body.lamp, body.source.attenuation, &constants, &block, 3, fine);
                sum_samples(kernels, &body.lamp, body.source.attenuation, &constants, &block, 2, coarse);
                for (size_t i = 0; i < LX_LANES; i++)
                    if (!(fabs(fine[i] - expected[i]) <= 1e-6 * expected[i] &&
                          fabs(coarse[i] - expected[i]) <= 3e-5 * expected[i]))
                        fail_msg("%s, source %d, case %d, element %zu: %.17g, %.17g, expected %.17g", kernels->name,
                                 kind, n, i, fine[i], coarse[i], expected[i]);
            }
        }
        clear_body(&body);
    }
}

/* Rules of any number of points give areas, and those of two and more the squares of distances. */
static void rules_are_exact(void **state)
{
    static struct lx_samples_double samples;
    const struct lx_patch patch = {
        .kind = LX_PATCH_FLAT, .o = {5, 6, 7}, .a = {3, 0, 0}, .b = {1, 2, 0}, .n = {0, 0, 1}, .area = {6, 0, 0}};
    const struct lx_patch disk = {.kind = LX_PATCH_DISK, .o = {5, 6, 7}, .a = {1, 0, 0}, .b = {0, 1, 0}, .radius = 3};
    const struct lx_cell all = {0, 0, 1, 1}, part = {0.25, 0.5, 0.5, 0.25};
    (void)state;
    for (unsigned side = 1; side <= 3; side++) {
        double sums[3] = {0, 0, 0}, square = 0;
        lx_cell_samples(&patch, &all, side, 2, 0, &samples);
        for (unsigned i = 0; i < side * side; i++) {
            double x = samples.x[i] - 5, y = samples.y[i] - 6;
            assert_true(samples.z[i] == 7 && x > 0 && y > 0 && y < 2);
            sums[0] += samples.gain[i];
            square += samples.gain[i] * (x * x + y * y);
        }
        lx_cell_samples(&patch, &part, side, 2, 0, &samples);
        for (unsigned i = 0; i < side * side; i++) {
            sums[1] += samples.gain[i];
            assert_true(samples.y[i] > 7 && samples.y[i] < 7.5);
        }
        lx_cell_samples(&disk, &all, side, 2, 0, &samples);
        for (unsigned i = 0; i < side * side; i++) {
            sums[2] += samples.gain[i];
            assert_true(hypot(samples.x[i] - 5, samples.y[i] - 6) < 3);
        }
        assert_true(fabs(sums[0] - 2 * 6) < 1e-14 * 12 && fabs(sums[1] - 2 * 6 * 0.125) < 1e-15);
        assert_true(fabs(sums[2] - 2 * 9 * M_PI) < 1e-13);
        /* area (a.a/3 + b.b/3 + a.b/2) */
        assert_true(side == 1 || fabs(square - 12 * (9 / 3.0 + 5 / 3.0 + 3 / 2.0)) < 1e-12);
    }
}

/* Circles of samples weigh area, and see no slope; two of them are exact for squares. */
static void circles_are_exact(void **state)
{
    const struct lx_patch disk = {
        .kind = LX_PATCH_DISK, .o = {5, 6, 7}, .a = {0.6, 0.8, 0}, .b = {-0.8, 0.6, 0}, .n = {0, 0, 1}, .radius = 3};
    struct lx_samples_double samples;
    (void)state;
    for (unsigned rings = 1; rings <= 3; rings++)
        for (unsigned spokes = 3; spokes <= 12; spokes++) {
            const double from = 0.25, to = 0.75, off = 0.1 * spokes;
            double area = 0, slope[2] = {0, 0}, square = 0;
            lx_round_samples(&disk, from, to, rings, spokes, off, 2, &samples);
            for (unsigned i = 0; i < rings * spokes; i++) {
                const double x = samples.x[i] - 5, y = samples.y[i] - 6, away = hypot(x, y);
                assert_true(away > 3 * from && away < 3 * to && samples.z[i] == 7);
                area += samples.gain[i];
                slope[0] += samples.gain[i] * x;
                slope[1] += samples.gain[i] * y;
                square += samples.gain[i] * away * away;
            }
            assert_true(fabs(area - 2 * M_PI * 9 * (to * to - from * from)) < 1e-13);
            assert_true(fabs(slope[0]) < 1e-13 && fabs(slope[1]) < 1e-13);
            assert_true(rings == 1 || fabs(square - M_PI * 81 * (pow(to, 4) - pow(from, 4))) < 1e-12);
        }
}

/* A ball around a cell's middle holds its places, of a flat one the farthest of them just so; and what is round that
 * around its own. */
static void cells_are_held(void **state)
{
    struct randomness random = {.state = 63};
    const double limits[] = {1 + 1e-12, 4, 6, 3};
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct body body = make_body(kind);
        struct lx_patch patches[64];
        static struct lx_block_double block;
        for (int n = 0; n < 100; n++) {
            make_run(&random, &block);
            struct lx_around around = lx_run_around(&block, 0);
            size_t count = lx_patches_make(&body.lamp, &around, NULL, patches);
            const double element[3] = {block.px[0], block.py[0], block.pz[0]};
            for (size_t p = 0; p < count; p++) {
                double size = logarithmic(&random, 0.01, 0.5), middle[3], farthest = 0;
                struct lx_cell cell = {uniform(&random, 0, 1 - size), uniform(&random, 0, 1 - size), size, size};
                double radius = lx_cell_look(&patches[p], &cell, element, middle);
                if (radius < 0) /* within the continued side of a cylinder */
                    continue;
                for (int c = 0; c < 81; c++) {
                    const struct lx_cell spot = {cell.s + (c % 9) / 8.0 * size, cell.t + (c / 9) / 8.0 * size, 0, 0};
                    double place[3], apart = 0;
                    assert_true(lx_cell_look(&patches[p], &spot, element, place) >= 0);
                    for (int k = 0; k < 3; k++)
                        apart = hypot(apart, place[k] - middle[k]);
                    farthest = fmax(farthest, apart);
                }
                if (!(farthest <= radius * (1 + 1e-12) && radius <= farthest * limits[patches[p].kind]))
                    fail_msg("source %d, patch kind %d: %g within %g", kind, patches[p].kind, farthest, radius);
                const struct lx_cell all = {0, 0, 1, 1}, spot = {1, uniform(&random, 0, 1), 0, 0};
                assert_true(lx_cell_is_round(&patches[p], &all) == (kind >= DISK && patches[p].kind != LX_PATCH_SIDE));
                if (lx_cell_is_round(&patches[p], &all)) {
                    double whole = lx_cell_look(&patches[p], &all, element, middle), rim[3], apart = 0;
                    lx_cell_look(&patches[p], &spot, element, rim);
                    for (int k = 0; k < 3; k++)
                        apart = hypot(apart, rim[k] - middle[k]);
                    assert_true(fabs(apart / whole - 1) < 1e-12);
                }
            }
        }
        clear_body(&body);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(runs_by_themselves),
        cmocka_unit_test(samples_are_the_integral),
        cmocka_unit_test(rules_are_exact),
        cmocka_unit_test(circles_are_exact),
        cmocka_unit_test(cells_are_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * What the kernels touch.  Each buffer ends where memory ends, and begins behind bytes of a known pattern, so that a
 * kernel that reads or writes past it crashes or is seen; entries beyond the last whole vector are no numbers, which
 * would show in a result, and stay as they are; and each element gets the same whatever the others are.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmocka.h>

#include "extended_sources.h"
#include "kernel/kernel.h"
#include "light/solid/facets.h"
#include "picture/lights.h"
#include "picture/area_light.h"
#include "random_scenes.h"

static const size_t counts[] = {1, 2, 15, 16, 17, 31, 37, 64, 100, 127, 128, 240, 241, 255, 256};
enum { COUNTS = sizeof counts / sizeof counts[0], PATTERN = 0xA5, ALIGNMENT = 64 };

/* ---- memory ---- */

enum { MOST_BUFFERS = 32 };

static struct buffer {
    unsigned char *map;
    size_t before, whole; /* bytes of the pattern, and of all with the page behind */
} buffers[MOST_BUFFERS];
static size_t used;

/* Memory that ends with a page, behind which none can be touched; `size` is a multiple of the alignment. */
static void *take(size_t size)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), room = (size + 2 * page - 1) / page * page;
    assert_true(used < MOST_BUFFERS && size % ALIGNMENT == 0);
    unsigned char *map = mmap(NULL, room + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(map != MAP_FAILED);
    assert_int_equal(mprotect(map + room, page, PROT_NONE), 0);
    buffers[used++] = (struct buffer){map, room - size, room + page};
    memset(map, PATTERN, room);
    return map + room - size;
}

/* Gives all buffers back; what stands before them must be untouched. */
static void give_back(const char *name)
{
    while (used > 0) {
        const struct buffer *buffer = &buffers[--used];
        for (size_t i = 0; i < buffer->before; i++)
            if (buffer->map[i] != PATTERN)
                fail_msg("%s wrote %zu bytes before a buffer", name, buffer->before - i);
        munmap(buffer->map, buffer->whole);
    }
}

static bool is_pattern(const void *data, size_t size)
{
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i++)
        if (bytes[i] != PATTERN)
            return false;
    return true;
}

/* ---- blocks ---- */

enum { ARRAYS = sizeof(struct lx_block_double) / (LX_BLOCK * sizeof(double)) };

static double *array_of(struct lx_block_double *block, size_t array)
{
    return block->px + array * LX_BLOCK;
}

static float *array_of_single(struct lx_block_single *block, size_t array)
{
    return block->px + array * LX_BLOCK;
}

/* Elements on a sphere of 300 mm, seen from anywhere; what is beyond the last whole vector is no number. */
static void fill(struct randomness *random, size_t count, struct lx_block_double *block, struct lx_block_single *copy)
{
    for (size_t i = 0; i < LX_BLOCK; i++) {
        double n[3], v[3];
        random_direction(random, n);
        random_direction(random, v);
        const double entries[ARRAYS] = {300 * n[0], 300 * n[1], 300 * n[2], n[0], n[1], n[2], v[0], v[1], v[2]};
        for (size_t array = 0; array < ARRAYS; array++) {
            const double entry = i < lx_padded(count) ? entries[array] : (double)NAN;
            array_of(block, array)[i] = entry;
            array_of_single(copy, array)[i] = (float)entry;
        }
    }
}

/* Puts other elements in the place of all but one. */
static void fill_around(struct randomness *random, size_t kept, struct lx_block_double *block,
                        struct lx_block_single *copy)
{
    struct lx_block_double one = *block;
    struct lx_block_single one_copy = *copy;
    fill(random, LX_BLOCK, block, copy);
    for (size_t array = 0; array < ARRAYS; array++) {
        array_of(block, array)[kept] = array_of(&one, array)[kept];
        array_of_single(copy, array)[kept] = array_of_single(&one_copy, array)[kept];
    }
}

static void set_all(double *sum, double value)
{
    for (size_t i = 0; i < LX_BLOCK; i++)
        sum[i] = value;
}

/* What a kernel that adds to sums is called with. */
struct call {
    const struct lx_kernels *kernels;
    struct lx_block_double *block;
    struct lx_block_single *copy;
    float *open;
    double *sum;
    size_t count;
    const void *data;
};
typedef void add_light(const struct call *call);

/* Calls a kernel with every count, and once more with other elements around one of them. */
static void check_sums(const struct lx_kernels *kernels, add_light *add, const void *data, const char *what,
                       struct randomness *random)
{
    for (size_t c = 0; c < COUNTS; c++) {
        const size_t count = counts[c], kept = (size_t)pick(random, (int)count);
        struct call call = {.kernels = kernels, .count = count, .data = data};
        call.block = take(sizeof *call.block);
        call.copy = take(sizeof *call.copy);
        call.open = take(LX_BLOCK * sizeof *call.open);
        call.sum = take(LX_BLOCK * sizeof *call.sum);
        fill(random, count, call.block, call.copy);
        for (size_t i = 0; i < lx_padded(count); i++)
            call.open[i] = 1;
        set_all(call.sum, 0.5);
        add(&call);
        for (size_t i = 0; i < LX_BLOCK; i++) {
            if (i < count ? !(call.sum[i] >= 0.5 && call.sum[i] < HUGE_VAL)
                          : i >= lx_padded(count) && call.sum[i] != 0.5)
                fail_msg("%s, %s: element %zu of %zu: %g", kernels->name, what, i, count, call.sum[i]);
        }
        const double alone = call.sum[kept];
        fill_around(random, kept, call.block, call.copy);
        for (size_t i = 0; i < LX_BLOCK; i++)
            call.open[i] = 1;
        set_all(call.sum, 0.5);
        call.count = LX_BLOCK;
        add(&call);
        if (call.sum[kept] != alone)
            fail_msg("%s, %s: element %zu of %zu: %.17g, among others %.17g", kernels->name, what, kept, count, alone,
                     call.sum[kept]);
        give_back(kernels->name);
    }
}

/* ---- points ---- */

struct points {
    struct lx_light_double exacts[3];
    struct lx_light_single singles[3];
    struct lx_lobe_double lobe;
    struct lx_lobe_single lobe_single;
    bool is_open;
};

static void add_in_double(const struct call *call)
{
    const struct points *points = call->data;
    call->kernels->shade_double(points->exacts, NULL, 3, &points->lobe, call->block, NULL,
                                points->is_open ? NULL : call->open, call->count, call->sum);
}

static void add_in_single(const struct call *call)
{
    const struct points *points = call->data;
    call->kernels->shade_single(points->singles, points->exacts, 3, &points->lobe_single, call->copy, call->block,
                                points->is_open ? NULL : call->open, call->count, call->sum);
}

/* Three lights of one kind, some way off. */
static void make_points(struct randomness *random, int n, struct points *points)
{
    static const double anchor[3] = {0, 0, 0};
    const struct lx_shape shape = {.radius_mm = 300};
    struct lx_emitter emitter = random_emitter(random, &shape);
    const double exponents[] = {20, 3.5};
    points->is_open = n % 2 == 0;
    points->lobe = (struct lx_lobe_double){.model = (enum lx_model)(n % 3),
                                           .highlight = (enum lx_highlight)(n / 3 % 3),
                                           .diffuse = 0.7,
                                           .specular = 0.4,
                                           .exponent = lx_exponent_of(exponents[n / 9 % 2])};
    points->lobe_single = lx_lobe_single_of(&points->lobe);
    lx_light_set(&emitter, anchor, &points->exacts[0]);
    for (int i = 0; i < 3; i++) {
        double way[3];
        random_direction(random, way);
        const double row[4] = {900 * way[0], 900 * way[1], 900 * way[2], 5};
        points->exacts[i] = points->exacts[0];
        if (points->exacts[0].kind != LX_DISTANT)
            lx_light_move(anchor, row, &points->exacts[i]);
        points->singles[i] = lx_light_single_of(&points->exacts[i]);
    }
}

static void test_points(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++) {
        struct randomness random = {.state = 71};
        for (int n = 0; n < 180 && lx_kernels_get(k)->runs(); n++) {
            struct points points;
            make_points(&random, n, &points);
            check_sums(lx_kernels_get(k), add_in_double, &points, "points in float64", &random);
            check_sums(lx_kernels_get(k), add_in_single, &points, "points in float32", &random);
        }
    }
}

/* ---- extended sources ---- */

static void add_area_light(const struct call *call)
{
    const struct lx_area_light *lamp = call->data;
    call->kernels->light_by_area_light[lamp->type](lamp, 0.75, call->block, call->count, NULL, call->sum);
}

static void add_area_light_in_single(const struct call *call)
{
    call->kernels->facets_single(call->data, 0.75, call->copy, call->count, NULL, call->sum);
}

static void test_area_lights(void **state)
{
    static const double center[3] = {500, -250, 700};
    const struct lx_shape lit = {.radius_mm = 300};
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct lx_emitter source = source_of(kind, center, 3, 250);
        struct randomness random = {.state = 72};
        struct lx_area_light lamp;
        assert_int_equal(lx_area_light_make(&source, &lit, NULL, &lamp), LUXEL_OK);
        if (lamp.edge_count > 0)
            assert_int_equal(lx_area_light_make_single(&lamp, NULL), LUXEL_OK);
        for (size_t k = 0; lx_kernels_get(k); k++)
            for (int n = 0; n < 10 && lx_kernels_get(k)->runs(); n++) {
                check_sums(lx_kernels_get(k), add_area_light, &lamp, "an extended source", &random);
                if (lamp.edge_count > 0)
                    check_sums(lx_kernels_get(k), add_area_light_in_single, &lamp, "facets in float32", &random);
            }
        lx_area_light_clear(&lamp);
        lx_facets_free(source.facets);
    }
}

/* ---- samples ---- */

static void test_samples(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++) {
        const struct lx_kernels *kernels = lx_kernels_get(k);
        struct randomness random = {.state = 73};
        for (int n = 0; n < 54 && kernels->runs(); n++) {
            const struct lx_lobe_double lobe = {.model = (enum lx_model)(n % 3),
                                                .highlight = (enum lx_highlight)(n / 3 % 3),
                                                .diffuse = 0.7,
                                                .specular = 0.4,
                                                .exponent = lx_exponent_of(20)};
            const struct lx_lobe_single lobe_single = lx_lobe_single_of(&lobe);
            struct lx_block_double *block = take(sizeof *block);
            struct lx_block_single *copy = take(sizeof *copy);
            struct lx_samples_double *samples = take((sizeof *samples + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
            struct lx_samples_single *singles = take((sizeof *singles + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
            double *sum = take(LX_LANES * sizeof *sum);
            float *sum_single = take(LX_LANES * sizeof *sum_single);
            fill(&random, LX_BLOCK, block, copy);
            *samples = (struct lx_samples_double){
                .bend = (enum lx_bend)(n / 9 % 3), .oz = 900, .nz = 1, .ax = 1, .radius = 50, .law = LX_INVERSE_SQUARE};
            for (size_t i = 0; i < LX_MOST_SAMPLES; i++) {
                samples->x[i] = uniform(&random, 0, 1), samples->y[i] = uniform(&random, -1, 1);
                samples->z[i] = sqrt(1 - samples->y[i] * samples->y[i]), samples->gain[i] = 1;
            }
            *singles = (struct lx_samples_single){
                .bend = samples->bend, .oz = 900, .nz = 1, .ax = 1, .radius = 50, .law = LX_INVERSE_SQUARE};
            for (size_t i = 0; i < LX_MOST_SAMPLES; i++) {
                singles->x[i] = (float)samples->x[i], singles->y[i] = (float)samples->y[i];
                singles->z[i] = (float)samples->z[i], singles->gain[i] = 1;
            }
            /* the last run of a block, the last samples: they end where memory does */
            kernels->samples_double(samples, LX_MOST_SAMPLES - 9, 9, &lobe, block, LX_BLOCK - LX_LANES, sum);
            kernels->samples_single(singles, LX_MOST_SAMPLES - 9, 9, &lobe_single, copy, LX_BLOCK - LX_LANES,
                                    sum_single);
            for (size_t i = 0; i < LX_LANES; i++)
                assert_true(isfinite(sum[i]) && isfinite(sum_single[i]));
            give_back(kernels->name);
        }
    }
}

/* ---- statistics ---- */

static void test_surveys(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++) {
        const struct lx_kernels *kernels = lx_kernels_get(k);
        for (size_t count = 0; count <= 200 && kernels->runs(); count++) {
            /* the last value ends where memory does, wherever the first then stands */
            const size_t room = (count * sizeof(double) + ALIGNMENT) / ALIGNMENT * ALIGNMENT;
            double *values = (double *)((char *)take(room) + room) - count;
            float *singles = (float *)((char *)take(room) + room) - count;
            double total = 0;
            for (size_t i = 0; i < count; i++)
                values[i] = (double)(i + 1), singles[i] = (float)(i + 1), total += (double)(i + 1);
            const struct lx_survey exact = kernels->survey_double(values, count, 0.5);
            const struct lx_survey single = kernels->survey_single(singles, count, 0.5);
            assert_true(exact.maximum == (double)count && single.maximum == (double)count);
            assert_true(exact.minimum == (count ? 1 : HUGE_VAL) && single.minimum == (count ? 1 : HUGE_VAL));
            assert_true(exact.at_least == count && single.at_least == count);
            assert_true(exact.sum == total && single.sum == total);
            give_back(kernels->name);
        }
    }
}

/* ---- plain loops ---- */

static void test_plain_loops(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++) {
        const struct lx_kernels *kernels = lx_kernels_get(k);
        for (size_t c = 0; c < COUNTS && kernels->runs(); c++) {
            const size_t count = counts[c];
            double *values = (double *)take(LX_BLOCK * sizeof *values) + LX_BLOCK - count;
            float *rounded = (float *)take(LX_BLOCK * sizeof *rounded) + LX_BLOCK - count;
            kernels->set_all(values, count, 0.25);
            for (size_t i = 0; i < count; i++) {
                assert_true(values[i] == 0.25);
                values[i] = 1 / (double)(i + 3);
            }
            kernels->round_all(values, count, rounded);
            for (size_t i = 0; i < count; i++)
                assert_true(rounded[i] == (float)(1 / (double)(i + 3)));
            assert_true(is_pattern(values + count - LX_BLOCK, (LX_BLOCK - count) * sizeof *values));
            assert_true(is_pattern(rounded + count - LX_BLOCK, (LX_BLOCK - count) * sizeof *rounded));
            give_back(kernels->name);
        }
    }
}

/* ---- shapes ---- */

static const struct lx_shape ball = {.type = LX_SPHERE, .anchor_mm = {5, -7, 400}, .radius_mm = 300};
static const struct lx_shape plate = {.type = LX_PLATE,
                                      .anchor_mm = {5, -7, 400},
                                      .radius_mm = 500,
                                      .axis = {0, 0.6, 0.8},
                                      .across = {1, 0, 0},
                                      .upward = {0, 0.8, -0.6},
                                      .half_mm = {300, 200},
                                      .touch_mm = 1e-9};

/* turned aside: |dx| < 280, |dy| < 200 of it are seen */
static const struct lx_shape slope = {.type = LX_PLATE,
                                      .anchor_mm = {5, -7, 400},
                                      .radius_mm = 500,
                                      .axis = {0.6, 0, 0.8},
                                      .across = {0.8, 0, -0.6},
                                      .upward = {0, 1, 0},
                                      .half_mm = {350, 200},
                                      .touch_mm = 1e-9};

static void check_shape(const struct lx_kernels *kernels, const struct lx_shape *shape, size_t count, bool perspective)
{
    const struct lx_row_view view = {.perspective = perspective, .observer_z_mm = 5000, .y_mm = 20};
    const double observer[3] = {-5, 7, 4600};
    double *x = take(LX_BLOCK * sizeof *x), *depth = take(LX_BLOCK * sizeof *depth);
    struct lx_block_double *block = take(sizeof *block);
    struct lx_block_single *copy = take(sizeof *copy);
    float *open = take(LX_BLOCK * sizeof *open);
    const size_t padded = lx_padded(count), beyond = LX_BLOCK - padded;
    for (size_t i = 0; i < padded; i++)
        x[i] = (i < count ? (double)i : (double)(count - 1)) * 9 - 500;
    size_t met = kernels->meet_lines[shape->type](shape, &view, x, count, depth, block->px, block->py, block->pz);
    size_t expected = 0;
    for (size_t i = 0; i < count; i++)
        expected += depth[i] < HUGE_VAL;
    assert_int_equal(met, expected);
    assert_true(is_pattern(depth + padded, beyond * sizeof *depth));
    for (size_t array = 0; array < 3; array++)
        assert_true(is_pattern(array_of(block, array) + padded, beyond * sizeof(double)));
    kernels->complete_block[shape->type](shape, observer, block, copy, count);
    for (size_t array = 0; array < ARRAYS; array++) {
        assert_true(is_pattern(array_of(block, array) + padded, beyond * sizeof(double)));
        assert_true(is_pattern(array_of_single(copy, array) + padded, beyond * sizeof(float)));
        for (size_t i = 0; i < count; i++)
            assert_true(array_of_single(copy, array)[i] == (float)array_of(block, array)[i]);
    }
    /* what all elements see alike stays as it was set */
    block->vx[0] = 3, copy->vz[0] = 4;
    kernels->complete_block[shape->type](shape, NULL, block, copy, count);
    assert_true(block->vx[0] == 3 && copy->vz[0] == 4);
    const struct lx_blocker blocker = {.shape = *shape, .is_point = perspective, .light = {100, 200, 900}};
    for (size_t i = 0; i < padded; i++)
        open[i] = 1;
    kernels->block_light[shape->type](&blocker, block, count, open);
    for (size_t i = 0; i < count; i++)
        assert_true(open[i] == 0 || open[i] == 1);
    assert_true(is_pattern(open + padded, beyond * sizeof *open));
    give_back(kernels->name);
}

/* What is made at once is what is made step by step, places and normals within two roundings of the shape's size: a row
 * so high over the centre, seen from the one side of it to the other. */
static void check_view(const struct lx_kernels *kernels, const struct lx_shape *shape, size_t count, double high,
                       double from, double to)
{
    const struct lx_row_view row = {.observer_z_mm = 5000, .y_mm = shape->anchor_mm[1] + high};
    const size_t padded = lx_padded(count);
    size_t first = LX_BLOCK, last = 0;
    double *x = take(LX_BLOCK * sizeof *x), *depth = take(LX_BLOCK * sizeof *depth);
    struct lx_block_double *block = take(sizeof *block);
    struct lx_block_single *copy = take(sizeof *copy), *once = take(sizeof *once);
    struct lx_columns *columns = take(sizeof *columns);
    unsigned char *mask = (unsigned char *)take(LX_BLOCK) + LX_BLOCK - count;
    for (size_t i = 0; i < padded; i++) {
        const double share = i < count - 1 ? (double)i / (double)(count - 1) : 1;
        x[i] = shape->anchor_mm[0] + from + (to - from) * share;
    }
    const size_t met = kernels->meet_lines[shape->type](shape, &row, x, count, depth, block->px, block->py, block->pz);
    kernels->complete_block[shape->type](shape, NULL, block, copy, count);
    double *line = (double *)take(LX_BLOCK * sizeof *line) + LX_BLOCK - count;
    memcpy(line, x, count * sizeof *line);
    kernels->set_columns[shape->type](shape, line, count, columns);
    assert_true(is_pattern(columns->x_mm + padded, (LX_BLOCK - padded) * sizeof(double)));
    for (size_t array = 0; array < 4; array++)
        assert_true(is_pattern(columns->px + array * LX_BLOCK + padded, (LX_BLOCK - padded) * sizeof(float)));
    const struct lx_stretch stretch = kernels->view_single[shape->type](shape, &row, columns, once, mask);
    assert_int_equal(stretch.met, met);
    assert_true(is_pattern(mask + count - LX_BLOCK, LX_BLOCK - count));
    for (size_t i = 0; i < count; i++) {
        const bool is_met = depth[i] < HUGE_VAL;
        assert_int_equal(mask[i], is_met);
        first = is_met && first == LX_BLOCK ? i : first;
        last = is_met ? i : last;
        for (size_t array = 0; array < 6 && is_met; array++) {
            const double size = array < 3 ? shape->radius_mm : 1;
            const float made = array_of_single(once, array)[i - stretch.first];
            assert_true(fabs((double)made - array_of(block, array)[i]) <= 2 * 0x1p-24 * size);
            assert_true(array % 3 == 2 || made == array_of_single(copy, array)[i]);
        }
    }
    if (met > 0) {
        const size_t end = lx_padded(last + 1);
        assert_int_equal(stretch.first, first / LX_LANES * LX_LANES);
        assert_int_equal(stretch.first + stretch.count, end < count ? end : count);
    }
    for (size_t array = 0; array < ARRAYS; array++) {
        const size_t kept = array < 6 ? padded : 0;
        assert_true(is_pattern(array_of_single(once, array) + kept, (LX_BLOCK - kept) * sizeof(float)));
    }
    give_back(kernels->name);
}

/* All of a row on a shape, to its very edge, and rows that begin and end beside it. */
static void check_views(const struct lx_kernels *kernels, const struct lx_shape *shape, size_t count, double high,
                        double half)
{
    const double edge = half * (1 - 1e-12), beyond = half * (1 + 0.1 / (double)count);
    check_view(kernels, shape, count, high, -edge, edge);
    check_view(kernels, shape, count, high, -edge, beyond); /* the last alone misses it */
    check_view(kernels, shape, count, high, -beyond, edge);
    check_view(kernels, shape, count, high, -2 * half, 1.5 * half);
    check_view(kernels, shape, count, high, -9 * half, edge);
    check_view(kernels, shape, count, high, edge, 9 * half);
    check_view(kernels, shape, count, high, 1.1 * half, 2 * half);
}

static void test_views(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++)
        for (size_t c = 0; c < COUNTS && lx_kernels_get(k)->runs(); c++)
            for (int row = -5; row <= 5; row++) {
                const double high = row * 59.99, half = sqrt(ball.radius_mm * ball.radius_mm - high * high);
                check_views(lx_kernels_get(k), &ball, counts[c], high, half);
                check_views(lx_kernels_get(k), &slope, counts[c], row * 20, 280);
                check_views(lx_kernels_get(k), &plate, counts[c], row * 31.9, 300);
            }
}

static void test_shapes(void **state)
{
    (void)state;
    for (size_t k = 0; lx_kernels_get(k); k++)
        for (size_t c = 0; c < COUNTS && lx_kernels_get(k)->runs(); c++)
            for (int perspective = 0; perspective < 2; perspective++) {
                check_shape(lx_kernels_get(k), &ball, counts[c], perspective);
                check_shape(lx_kernels_get(k), &plate, counts[c], perspective);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points),  cmocka_unit_test(test_area_lights), cmocka_unit_test(test_samples),
        cmocka_unit_test(test_surveys), cmocka_unit_test(test_plain_loops), cmocka_unit_test(test_shapes),
        cmocka_unit_test(test_views),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by laws without closed forms (kernel_law.c), by every instruction set and in either precision, against
 * integrals in float64: facets, disks, balls and cylinders, seen from afar and from beside them, in front of them and
 * along their planes, whole and cut by the horizon; what float32 rounds, against its bound; and that no element's bytes
 * depend on the elements beside it.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "campaign.h"
#include "light/solid/extended.h"
#include "light/solid/facets.h"
#include "picture/precision.h"
#include "picture/area_light.h"
#include "world/integral/cubature.h"

extern const struct lx_surface_kind lx_sphere_kind;

enum { SCENES = 24, EVERY = 16 };

/* What the two sets of rules of pictures may be off by, of the greatest value. */
static const double errors[] = {LX_SINGLE_RULES, LX_DOUBLE_RULES}, limits[] = {3e-7, 5e-12};

/* xorshift64*: the same sources on every machine */
struct randomness {
    uint64_t state;
};

static double uniform(struct randomness *random, double low, double high)
{
    random->state ^= random->state >> 12;
    random->state ^= random->state << 25;
    random->state ^= random->state >> 27;
    return low + (high - low) * ((double)((random->state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

static double logarithmic(struct randomness *random, double low, double high)
{
    return exp(uniform(random, log(low), log(high)));
}

static void random_direction(struct randomness *random, double direction[3])
{
    double length = 0;
    for (int i = 0; i < 3; i++) {
        direction[i] = uniform(random, -1, 1);
        length = hypot(length, direction[i]);
    }
    for (int i = 0; i < 3; i++)
        direction[i] /= length;
}

static struct lx_emitter random_source(struct randomness *random, enum lx_emitter_type type, double size)
{
    const double center[3] = {0, 0, 0};
    double axis[3], up[3];
    random_direction(random, axis);
    random_direction(random, up);
    struct lx_emitter emitter = {.type = type,
                                 .radiance = lx_exact(10),
                                 .attenuation = (enum lx_attenuation)(1 + (int)uniform(random, 0, LX_LAWS - 1)),
                                 .k_mm = logarithmic(random, 10, 3000),
                                 .radius_mm = size,
                                 .height_mm = size * logarithmic(random, 0.3, 20),
                                 .axis = lx_unit3(lx_exact3(axis))};
    for (int i = 0; i < 3; i++)
        emitter.coefficients[i] = logarithmic(random, 1e-2, 10);
    const double sizes[3] = {size, size * uniform(random, 0.1, 1), size * uniform(random, 0.1, 1)};
    if (type != LX_FACETS)
        return emitter;
    switch ((int)uniform(random, 0, 4)) {
    case 0: emitter.facets = lx_facets_of_box(center, sizes); break;
    case 1: emitter.facets = lx_facets_of_sphere(center, size, 6); break;
    case 2: emitter.facets = lx_facets_of_cylinder(center, size / 2, size, axis, 5); break;
    default: emitter.facets = lx_facets_of_rectangle(center, sizes, axis, up); break;
    }
    assert_non_null(emitter.facets);
    return emitter;
}

/* Elements that are so far from the ball around the source, and up to ten times its size farther, most of which face
 * it, many partly. */
static void random_block(struct randomness *random, double reach, double least, struct lx_block_double *block)
{
    for (size_t i = 0; i < LX_BLOCK; i++) {
        double p[3], n[3];
        random_direction(random, p);
        random_direction(random, n);
        const double distance = least + reach * logarithmic(random, 0.1, 10);
        const bool turns = p[0] * n[0] + p[1] * n[1] + p[2] * n[2] > 0 && uniform(random, 0, 1) < 0.8;
        const double sign = turns ? -1 : 1;
        block->px[i] = distance * p[0], block->py[i] = distance * p[1], block->pz[i] = distance * p[2];
        block->nx[i] = sign * n[0], block->ny[i] = sign * n[1], block->nz[i] = sign * n[2];
        block->vx[i] = block->vy[i] = 0, block->vz[i] = 1;
    }
}

static double integral(const struct lx_emitter *emitter, const struct lx_block_double *block, size_t i)
{
    const struct lx_lobe lobe = {.diffuse = lx_exact(1), .specular = lx_exact(0)};
    const double p[3] = {block->px[i], block->py[i], block->pz[i]}, n[3] = {block->nx[i], block->ny[i], block->nz[i]};
    const struct lx_element element = {.place_mm = lx_exact3(p),
                                       .normal = lx_unit3(lx_exact3(n)),
                                       .view = lx_exact3((double[]){0, 0, 1}),
                                       .lobe = &lobe};
    if (lx_extended_touches(emitter, element.place_mm))
        return 0;
    return lx_integrate(emitter, &element, NULL, true, 0, 1e-12, NULL).irradiance.value;
}

/* The truth at every 16th element, and the greatest of them: what a picture of these elements is measured by. */
struct truth {
    double value[LX_BLOCK / EVERY], maximum;
};

static struct truth truth_of(const struct lx_emitter *emitter, const struct lx_block_double *block)
{
    struct truth truth = {.maximum = 0};
    for (size_t i = 0; i < LX_BLOCK / EVERY; i++) {
        truth.value[i] = integral(emitter, block, i * EVERY);
        truth.maximum = fmax(truth.maximum, truth.value[i]);
    }
    return truth;
}

/* The worst error, of the greatest value; counts those that are left. */
static double worst_of(lx_light_by_law *law, const struct lx_area_light *lamp, const struct lx_gauss_rules *rules,
                       const struct lx_block_double *block, const struct truth *truth, size_t *left_count)
{
    double sum[LX_BLOCK] = {0}, worst = 0;
    uint8_t left[LX_BLOCK] = {0};
    law(lamp, rules, 1, block, LX_BLOCK, NULL, sum, left);
    for (size_t i = 0; i < LX_BLOCK / EVERY; i++) {
        *left_count += left[i * EVERY];
        if (left[i * EVERY])
            assert_true(sum[i * EVERY] == 0);
        else if (truth->maximum > 0)
            worst = fmax(worst, fabs(sum[i * EVERY] - truth->value[i]) / truth->maximum);
    }
    return worst;
}

/* One element alone, in the other order, and beside others gives the same bytes. */
static void check_alone(lx_light_by_law *law, const struct lx_area_light *lamp, const struct lx_gauss_rules *rules,
                        const struct lx_block_double *block)
{
    double sum[LX_BLOCK] = {0}, turned_sum[LX_BLOCK] = {0};
    uint8_t left[LX_BLOCK] = {0}, turned_left[LX_BLOCK] = {0};
    static struct lx_block_double turned;
    for (size_t i = 0; i < LX_BLOCK; i++) {
        const size_t k = (i * 37 + 11) % LX_BLOCK;
        turned.px[i] = block->px[k], turned.py[i] = block->py[k], turned.pz[i] = block->pz[k];
        turned.nx[i] = block->nx[k], turned.ny[i] = block->ny[k], turned.nz[i] = block->nz[k];
    }
    law(lamp, rules, 1, block, LX_BLOCK, NULL, sum, left);
    law(lamp, rules, 1, &turned, LX_BLOCK, NULL, turned_sum, turned_left);
    for (size_t i = 0; i < LX_BLOCK; i++) {
        const size_t k = (i * 37 + 11) % LX_BLOCK;
        assert_true(sum[k] == turned_sum[i]);
        assert_int_equal(left[k], turned_left[i]);
    }
}

/* What sources of a kind came to. */
struct tally {
    double worst[2];
    size_t left, all, by_nodes;
};

/* What the rules for each error leave, in what is far by few places. */
static void check_rules(const struct lx_emitter *emitter, double nearest, const struct lx_block_double *block,
                        struct lx_area_light *lamp, struct tally *tally)
{
    const struct truth truth = truth_of(emitter, block);
    for (int e = 0; e < 2; e++) {
        struct lx_gauss_rules *rules = lx_gauss_rules_new(errors[e]);
        const struct lx_kernels *kernels;
        assert_non_null(rules);
        assert_int_equal(lx_area_light_set_nodes(rules, nearest, lamp), LUXEL_OK);
        tally->by_nodes += lamp->nodes_each > 0;
        for (size_t k = 0; (kernels = lx_kernels_get(k)) != NULL; k++) {
            if (!kernels->runs())
                continue;
            size_t left = 0;
            const double off = worst_of(kernels->law_double[emitter->type], lamp, rules, block, &truth, &left);
            tally->worst[e] = fmax(tally->worst[e], off);
            if (off > limits[e])
                print_message("# %s: off by %.2g, the law %d, so near: %g mm, %u places each\n", kernels->name, off,
                              (int)emitter->attenuation, nearest, lamp->nodes_each);
            tally->left += e == 0 ? left : 0;
            tally->all += e == 0 ? LX_BLOCK / EVERY : 0;
            check_alone(kernels->law_double[emitter->type], lamp, rules, block);
            check_alone(kernels->law_single[emitter->type], lamp, rules, block);
        }
        lx_area_light_forget_nodes(lamp);
        free(rules);
    }
}

/* By sources that elements are next to, and by those that no element is near to. */
static void check_sources(enum lx_emitter_type type)
{
    struct randomness random = {UINT64_C(0x1357924680ACE135) + (uint64_t)type};
    struct tally tally = {0};
    const int scenes = scenes_to_try(SCENES);
    for (int s = 0; s < scenes; s++) {
        struct lx_emitter emitter = random_source(&random, type, logarithmic(&random, 1, 1000));
        const struct lx_shape lit = {.radius_mm = 0};
        const double reach = type == LX_CYLINDER ? hypot(emitter.radius_mm, emitter.height_mm / 2) : emitter.radius_mm;
        const double nearest = s % 2 == 0 ? 0 : reach * logarithmic(&random, 0.3, 10);
        static struct lx_block_double block;
        struct lx_area_light lamp;
        assert_int_equal(lx_area_light_make(&emitter, &lit, NULL, &lamp), LUXEL_OK);
        random_block(&random, reach, nearest > 0 ? reach + nearest : uniform(&random, 0, reach), &block);
        check_rules(&emitter, nearest, &block, &lamp, &tally);
        lx_area_light_clear(&lamp);
        lx_facets_free(emitter.facets);
    }
    print_message("# off by %.2g and %.2g of the maximum; %zu of %zu left to integrals, few places in %zu of %d\n",
                  tally.worst[0], tally.worst[1], tally.left, tally.all, tally.by_nodes, 2 * scenes);
    for (int e = 0; e < 2; e++)
        assert_true(tally.worst[e] <= limits[e]);
    assert_true(tally.left < tally.all / 20); /* integrals for single elements are for the nearest ones alone */
    assert_true(tally.by_nodes >= (size_t)scenes / 4);
}

/* ---- roundings ---- */

/* A sphere that a source stands before, so near or so far. */
static double random_sphere(struct randomness *random, double reach, struct lx_emitter *emitter,
                            struct lx_shape *sphere)
{
    double direction[3];
    const double radius = reach * logarithmic(random, 0.1, 30), gap = reach * logarithmic(random, 0.03, 10);
    random_direction(random, direction);
    *sphere = (struct lx_shape){.type = LX_SPHERE, .kind = &lx_sphere_kind, .radius_mm = radius};
    for (int k = 0; k < 3; k++) {
        sphere->anchor_mm[k] = direction[k] * (radius + reach + gap);
        emitter->center_mm[k] = 0;
    }
    return gap;
}

/* Places of it that the source may be seen from. */
static void block_on(struct randomness *random, const struct lx_shape *sphere, struct lx_block_double *block)
{
    for (size_t i = 0; i < LX_BLOCK; i++) {
        double n[3], up = 0;
        random_direction(random, n);
        const double share = logarithmic(random, 0.01, 1), *c = sphere->anchor_mm;
        const double length = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        for (int k = 0; k < 3; k++)
            n[k] = share * n[k] - c[k] / length, up += n[k] * n[k];
        for (int k = 0; k < 3; k++)
            n[k] /= sqrt(up);
        block->nx[i] = n[0], block->ny[i] = n[1], block->nz[i] = n[2];
        block->px[i] = sphere->radius_mm * n[0], block->py[i] = sphere->radius_mm * n[1];
        block->pz[i] = sphere->radius_mm * n[2];
    }
}

/* What float32 rounds, of its bound. */
static double share_of_bound(lx_light_by_law *single, lx_light_by_law *exact, const struct lx_area_light *lamp,
                             const struct lx_gauss_rules *rules, const struct lx_block_double *block, double bound)
{
    double sums[2][LX_BLOCK] = {{0}}, worst = 0;
    uint8_t left[2][LX_BLOCK] = {{0}};
    single(lamp, rules, 1, block, LX_BLOCK, NULL, sums[0], left[0]);
    exact(lamp, rules, 1, block, LX_BLOCK, NULL, sums[1], left[1]);
    for (size_t i = 0; i < LX_BLOCK; i++)
        if (!left[0][i] && !left[1][i])
            worst = fmax(worst, fabs(sums[0][i] - sums[1][i]) / bound);
    return worst;
}

static void test_roundings(void **state)
{
    enum { SPHERES = 400 };
    (void)state;
    struct lx_gauss_rules *rules = lx_gauss_rules_new(LX_SINGLE_RULES);
    assert_non_null(rules);
    for (int type = LX_FACETS; type <= LX_CYLINDER; type++) {
        struct randomness random = {UINT64_C(0xD1B54A32D192ED03) + (uint64_t)type};
        double worst = 0;
        for (int s = 0; s < SPHERES; s++) {
            struct lx_emitter emitter =
                random_source(&random, (enum lx_emitter_type)type, logarithmic(&random, 1, 1000));
            const double reach =
                type == LX_CYLINDER ? hypot(emitter.radius_mm, emitter.height_mm / 2) : emitter.radius_mm;
            struct lx_shape sphere;
            struct lx_area_light lamp;
            static struct lx_block_double block;
            random_sphere(&random, reach, &emitter, &sphere);
            assert_int_equal(lx_area_light_make(&emitter, &sphere, NULL, &lamp), LUXEL_OK);
            assert_int_equal(lx_area_light_set_nodes(rules, lx_gap(&sphere, &lamp, NULL), &lamp), LUXEL_OK);
            const double bound = lx_bound_law(&sphere, 1, &lamp, NULL);
            assert_true(bound > 0 && isfinite(bound));
            block_on(&random, &sphere, &block);
            const struct lx_kernels *kernels;
            for (size_t k = 0; (kernels = lx_kernels_get(k)) != NULL; k++)
                if (kernels->runs())
                    worst = fmax(worst, share_of_bound(kernels->law_single[type], kernels->law_double[type], &lamp,
                                                       rules, &block, bound));
            lx_area_light_clear(&lamp);
            lx_facets_free(emitter.facets);
        }
        print_message("# roundings are up to %.2g of their bound\n", worst);
        assert_true(worst <= 0.6 && worst > 0.05);
    }
    free(rules);
}

static void test_facets(void **state)
{
    (void)state;
    check_sources(LX_FACETS);
}

static void test_disks(void **state)
{
    (void)state;
    check_sources(LX_DISK);
}

static void test_balls(void **state)
{
    (void)state;
    check_sources(LX_BALL);
}

static void test_cylinders(void **state)
{
    (void)state;
    check_sources(LX_CYLINDER);
}

/* Each rule is exact for polynomials below twice its number of places. */
static void test_rules(void **state)
{
    (void)state;
    struct lx_gauss_rules *rules = lx_gauss_rules_new(LX_SINGLE_RULES);
    assert_non_null(rules);
    assert_true(fabs(rules->digits - 16.11809565095832) < 1e-12);
    for (int r = 0; r < LX_RULES; r++) {
        const struct lx_gauss_rule *rule = &rules->rules[r];
        assert_in_range(rule->count, 1, LX_MOST_PLACES);
        for (unsigned power = 0; power < 2 * rule->count; power++) {
            double sum = 0;
            for (unsigned i = 0; i < rule->count; i++)
                sum += rule->weights_double[i] * pow(rule->places_double[i], power);
            assert_true(fabs(sum - (power % 2 == 0 ? 2.0 / (power + 1) : 0)) < 1e-14);
        }
    }
    free(rules);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rules), cmocka_unit_test(test_facets),    cmocka_unit_test(test_disks),
        cmocka_unit_test(test_balls), cmocka_unit_test(test_cylinders), cmocka_unit_test(test_roundings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

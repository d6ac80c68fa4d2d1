/* SPDX-License-Identifier: MIT */
/*
 * Materials beyond Blinn and Phong: what lobes of rough surfaces and of facets reflect in all, by their values and
 * Gauss's rule against closed forms and a table, that they are the same both ways, and Lambert's where they are smooth;
 * and that the answers of these lobes fit their values.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/vector.h"
#include "material/eon.h"
#include "material/lobe.h"
#include "material/material.h"
#include "random_scenes.h"
#include "world/albedo.h"

static const double DEGREE = M_PI / 180;

enum { OREN_NAYAR = LX_OREN_NAYAR - LX_LAMBERT, EON = LX_EON - LX_LAMBERT };

static struct lx_material rough(int model, double how)
{
    return (struct lx_material){.model = LX_LAMBERT,
                                .diffuse_model = model,
                                .diffuse = 1,
                                .sigma_degrees = how / DEGREE,
                                .roughness = how,
                                .over_pi = true};
}

static struct lx_material facets(double alpha, double f0)
{
    return (struct lx_material){.model = LX_GGX, .specular = 1, .alpha = alpha, .f0 = f0, .over_pi = true};
}

static void towards(double angle, double turn, double v[3])
{
    v[0] = sin(angle) * cos(turn), v[1] = sin(angle) * sin(turn), v[2] = cos(angle);
}

static double reflect(const struct lx_lobe *lobe, const double view[3], const double light[3])
{
    const struct lx_reflection made =
        lx_lobe_reflect(lobe, lx_exact3((const double[]){0, 0, 1}), lx_exact3(view), lx_exact3(light));
    return made.diffuse.value + made.specular.value;
}

/* Nodes and weights of Gauss's rule of 24 points on [-1, 1], by Newton's method. */
enum { NODES = 24 };

static void find_rule(double nodes[NODES], double weights[NODES])
{
    for (int i = 0; i < NODES; i++) {
        double x = cos(M_PI * (i + 0.75) / (NODES + 0.5)), slope = 1;
        for (int step = 0; step < 20; step++) {
            double before = 1, now = x;
            for (int n = 2; n <= NODES; n++) {
                const double next = ((2 * n - 1) * x * now - (n - 1) * before) / n;
                before = now, now = next;
            }
            slope = NODES * (x * now - before) / (x * x - 1);
            x -= now / slope;
        }
        nodes[i] = x, weights[i] = 2 / ((1 - x * x) * slope * slope);
    }
}

/* All that is reflected to a view, by that rule on parts of the angles that begin where the lobe may bend. */
static double sum_of(const struct lx_material *material, double degrees, int parts)
{
    double nodes[NODES], weights[NODES], view[3], sum = 0;
    const struct lx_lobe lobe = lx_lobe_prepare(material);
    const double slant = degrees * DEGREE, angles[3] = {0, slant, M_PI / 2};
    find_rule(nodes, weights);
    towards(slant, M_PI, view);
    for (int side = 0; side < 2; side++)
        for (int part = 0; part < 2 * parts; part++) {
            const double width = (angles[side + 1] - angles[side]) / parts, turn_width = M_PI / 2 / parts;
            for (int half = 0; half < parts && width > 0; half++)
                for (int i = 0; i < NODES; i++)
                    for (int k = 0; k < NODES; k++) {
                        const double angle = angles[side] + width * (half + (1 + nodes[i]) / 2);
                        double light[3];
                        towards(angle, turn_width * (part + (1 + nodes[k]) / 2), light);
                        sum += weights[i] * weights[k] * width * turn_width / 4 * sin(angle) * 2 *
                               reflect(&lobe, view, light);
                    }
        }
    return sum;
}

static void assert_near(double found, double expected, double tolerance, const char *what, double of)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s %g: %.15g, expected %.15g", what, of, found, expected);
}

/* Those of powers, whose sum around the still vector is a closed form, by Gauss's rule in both angles. */
static void albedos_of_powers(void **unused)
{
    static const double angles[] = {0, 0.5, 45, 80}, exponents[] = {5, 20, 60}; /* S^5 ends smoothly */
    (void)unused;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            for (int weight = 0; weight < 3; weight++)
                for (int half = 0; half < 2; half++) {
                    const struct lx_material power = {.model = half ? LX_BLINN_PHONG : LX_PHONG,
                                                      .diffuse = 0.25,
                                                      .specular = 0.5,
                                                      .shininess = exponents[k],
                                                      .highlight = weight,
                                                      .over_pi = true};
                    const double found = lx_material_albedo(&power, cos(angles[i] * DEGREE));
                    assert_near(found, sum_of(&power, angles[i], 6), 1e-9, half ? "blinn-phong" : "phong", angles[i]);
                }
    /* Phong straight on: 2 ks/(n + 1), and over the horizon's edge half of it */
    const struct lx_material sharp = {.model = LX_PHONG, .specular = 1, .shininess = 1e4};
    assert_near(lx_material_albedo(&sharp, 1), 2 / 10001., 1e-15, "phong straight on", 1e4);
    assert_near(lx_material_albedo(&sharp, 1e-9), 1 / 10001., 1e-10, "phong at the edge", 1e4);
}

static void albedos(void **unused)
{
    static const double angles[] = {0, 30, 60, 80}, alphas[] = {0.1, 0.25, 0.5, 1};
    static const double oren_nayar[2][4] = {{0.8928571429, 0.9202216568, 0.9599361925, 0.9914311905},
                                            {0.7844827586, 0.8247246910, 0.8831284199, 0.9294445934}};
    static const double fujii[4] = {0.7765220670, 0.7885711788, 0.8653195483, 0.9544420509};
    static const double ggx[4][4] = {{0.9883040565, 0.9860869435, 0.9692049844, 0.8955187502},
                                     {0.9158124302, 0.9041468343, 0.8572634356, 0.8555543146},
                                     {0.6878485151, 0.6830519157, 0.6982506969, 0.8053228445},
                                     {0.3068528194, 0.3351940810, 0.4506938557, 0.6681859439}};
    (void)unused;
    for (int i = 0; i < 4; i++) {
        const double cosine = cos(angles[i] * DEGREE);
        for (int k = 0; k < 2; k++) {
            const struct lx_material slopes = rough(OREN_NAYAR, k == 0 ? 0.3 : 0.5);
            assert_near(lx_material_albedo(&slopes, cosine), oren_nayar[k][i], 1e-10, "oren-nayar", angles[i]);
            assert_near(sum_of(&slopes, angles[i], 2), oren_nayar[k][i], 1e-10, "oren-nayar's sum", angles[i]);
        }
        /* EON's single scattering alone is that of a reflectance of nothing, but for the weight */
        struct lx_material eon = rough(EON, 1);
        assert_near(lx_material_albedo(&eon, cosine), 1, 1e-14, "eon's furnace", angles[i]);
        assert_near(sum_of(&eon, angles[i], 4), 1, 1e-10, "eon's sum", angles[i]);
        eon.diffuse = 1e-12;
        assert_near(lx_material_albedo(&eon, cosine) * 1e12, fujii[i], 1e-10, "eon's single scattering", angles[i]);
        eon.diffuse = 0.6;
        assert_near(sum_of(&eon, angles[i], 4), lx_material_albedo(&eon, cosine), 1e-10, "eon of 0.6", angles[i]);
        for (int k = 0; k < 4; k++) {
            const struct lx_material facet = facets(alphas[k], 1);
            assert_near(lx_material_albedo(&facet, cosine), ggx[k][i], 1e-10, "ggx", alphas[k]);
            assert_near(sum_of(&facet, angles[i], 24), lx_material_albedo(&facet, cosine), 1e-9, "ggx's sum",
                        alphas[k]);
        }
        /* The share of facets' light by Schlick's law, and Blinn's by the rule */
        const struct lx_material glass = facets(0.3, 0.04);
        assert_near(sum_of(&glass, angles[i], 12), lx_material_albedo(&glass, cosine), 1e-10, "glass", angles[i]);
        struct lx_material blinn = {.diffuse = 0.8, .specular = 0.5, .shininess = 20, .over_pi = true};
        assert_near(sum_of(&blinn, angles[i], 12), lx_material_albedo(&blinn, cosine), 1e-10, "blinn-phong", angles[i]);
        const double divided = lx_material_albedo(&blinn, cosine);
        blinn.over_pi = false;
        assert_true(lx_material_albedo(&blinn, cosine) == divided);
    }
    assert_near(lx_material_albedo(&(struct lx_material){.diffuse = 0.8, .specular = 0.5, .shininess = 20}, 1),
                0.8 + 0.5 * 8 / 22 * (1 - exp2(-11)), 1e-11, "blinn-phong straight on", 20);
    assert_near(lx_material_albedo(&(struct lx_material){.model = LX_GGX, .specular = 1, .alpha = 1, .f0 = 1}, 1),
                1 - log(2), 1e-12, "ggx straight on", 1);
    assert_true(isnan(lx_material_albedo(&(struct lx_material){.diffuse = 1}, 0)));
}

static struct lx_material any_material(struct randomness *random, int n)
{
    struct lx_material material = n % 3 == 0   ? rough(OREN_NAYAR, uniform(random, 0.01, M_PI / 2))
                                  : n % 3 == 1 ? rough(EON, uniform(random, 0.01, 1))
                                               : facets(logarithmic(random, 0.01, 1), uniform(random, 0, 1));
    material.roughness = fmin(material.roughness, 1);
    material.diffuse = n % 3 == 2 ? 0 : uniform(random, 0.01, 1);
    return material;
}

static void upward(struct randomness *random, double v[3])
{
    towards(acos(uniform(random, 0, 1)), uniform(random, 0, 2 * M_PI), v);
}

/* As much goes from a to b as from b to a, for as much light; and never less than nothing. */
static void reciprocity(void **unused)
{
    struct randomness random = {.state = 7};
    (void)unused;
    for (int n = 0; n < 30000; n++) {
        const struct lx_material material = any_material(&random, n);
        const struct lx_lobe lobe = lx_lobe_prepare(&material);
        double a[3], b[3];
        upward(&random, a);
        upward(&random, b);
        const double there = reflect(&lobe, a, b) * a[2], back = reflect(&lobe, b, a) * b[2];
        if (!(fabs(there - back) <= 1e-11 * fabs(there) && there >= 0))
            fail_msg("material %d: %.17g and %.17g", n, there, back);
    }
}

/* Twice the weight reflects twice as much, but for EON's multiple scattering, which is told for any reflectance. */
static void scaling(void **unused)
{
    struct randomness random = {.state = 8};
    (void)unused;
    for (int n = 0; n < 3000; n++) {
        struct lx_material material = any_material(&random, n);
        double view[3], light[3];
        upward(&random, view);
        upward(&random, light);
        material.diffuse /= 2, material.specular /= 2;
        struct lx_lobe lobe = lx_lobe_prepare(&material);
        const double once = reflect(&lobe, view, light);
        if (n % 3 == 1)
            lobe.diffuse_own[2] = lx_eon_multiple(material.roughness, 2 * material.diffuse);
        const double before = reflect(&lobe, view, light);
        assert_true(before >= once);
        material.diffuse *= 2, material.specular *= 2;
        lobe = lx_lobe_prepare(&material);
        assert_near(reflect(&lobe, view, light), 2 * before, 1e-14 * before, "twice", n);
    }
}

/* What is smooth is Lambert's, to the last bit; what is hardly rough, nearly so. */
static void smooth(void **unused)
{
    struct randomness random = {.state = 9};
    (void)unused;
    for (int n = 0; n < 3000; n++) {
        double view[3], light[3];
        upward(&random, view);
        upward(&random, light);
        struct lx_material material = rough(0, 0);
        const struct lx_lobe plain = lx_lobe_prepare(&material);
        for (int model = OREN_NAYAR; model <= EON; model++) {
            material = rough(model, 0);
            const struct lx_lobe lobe = lx_lobe_prepare(&material);
            assert_true(reflect(&lobe, view, light) == reflect(&plain, view, light));
            material = rough(model, 1e-9);
            const struct lx_lobe near = lx_lobe_prepare(&material);
            assert_near(reflect(&near, view, light), reflect(&plain, view, light), 1e-8, "hardly rough", n);
        }
    }
}

/*
 * The bound of a value holds where the vectors are off, by as much as a rough one is from an exact one, and the
 * logarithm is that of the value, with no smaller error than what it changes by.
 */
static void answers_fit(void **unused)
{
    struct randomness random = {.state = 10};
    int told = 0;
    (void)unused;
    for (int n = 0; n < 30000; n++) {
        const struct lx_material material = any_material(&random, n);
        const struct lx_lobe whole = lx_lobe_prepare(&material);
        const struct lx_lobe lobe = lx_lobe_is_rough(&whole) ? lx_lobe_of_diffuse(&whole) : whole;
        const struct lx_lobe_kind *kind = lx_lobe_kind_of(&lobe);
        const double normal[3] = {0, 0, 1}, off = logarithmic(&random, 1e-12, 1e-6);
        double view[3], light[3], moved[3], error, unused_error;
        upward(&random, view);
        upward(&random, light);
        for (int i = 0; i < 3; i++)
            moved[i] = light[i] + off / 2 * uniform(&random, -1, 1);
        const double length = sqrt(lx_dot(moved, moved));
        for (int i = 0; i < 3; i++)
            moved[i] /= length;
        const lx_bounded3 light_off = {{light[0], off}, {light[1], off}, {light[2], off}};
        const lx_bounded there = kind->value(&lobe, lx_exact3(normal), lx_exact3(view), lx_exact3(moved));
        const lx_bounded here = kind->value(&lobe, lx_exact3(normal), lx_exact3(view), light_off);
        if (!(fabs(there.value - here.value) <= here.error + there.error))
            fail_msg("value %d: %.17g +- %g and %.17g", n, here.value, here.error, there.value);
        struct lx_lobe_at at;
        lx_lobe_at_set(normal, view, &at);
        const double found = lx_lobe_log(&lobe, &at, light, off, &error);
        const double other = lx_lobe_log(&lobe, &at, moved, 0, &unused_error);
        if (!(fabs(exp(found) - here.value) <= 1e-11 * here.value + here.error))
            fail_msg("logarithm %d: %.17g, value %.17g", n, exp(found), here.value);
        if (error < 0.1) {
            told++;
            if (!(fabs(expm1(other - found)) <= error * 1.2))
                fail_msg("error %d: %g, changed by %g", n, error, expm1(other - found));
        }
    }
    assert_true(told > 20000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(albedos),     cmocka_unit_test(albedos_of_powers),
        cmocka_unit_test(reciprocity), cmocka_unit_test(scaling),
        cmocka_unit_test(smooth),      cmocka_unit_test(answers_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

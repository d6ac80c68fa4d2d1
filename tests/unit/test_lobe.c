/* SPDX-License-Identifier: MIT */
/*
 * Lobes against their formulas in the plane of the light, where all angles are sums: normal, view and light at signed
 * angles from the normal; what is behind; and that normalized lobes reflect what they are said to.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/vector.h"
#include "material/lobe.h"
#include "material/material.h"
#include "random_scenes.h"

static const double DEGREE = M_PI / 180;

static const struct lx_material usual = {.model = LX_PHONG, .diffuse = 0.75, .specular = 0.5, .shininess = 20};

/* A unit vector at this angle from the normal, in a plane that is not one of the coordinates. */
static lx_bounded3 at_angle(double degrees)
{
    double sine = sin(degrees * DEGREE), cosine = cos(degrees * DEGREE);
    /* the normal is (2, 3, 6)/7, what is perpendicular to it (6, 2, -3)/7 */
    const double v[3] = {2 * cosine + 6 * sine, 3 * cosine + 2 * sine, 6 * cosine - 3 * sine};
    return lx_unit3(lx_exact3(v));
}

static struct lx_reflection reflect(const struct lx_material *material, double view, double light)
{
    struct lx_lobe lobe = lx_lobe_prepare(material);
    return lx_lobe_reflect(&lobe, at_angle(0), at_angle(view), at_angle(light));
}

static void assert_value(lx_bounded found, double expected, const char *what)
{
    if (!(fabs(found.value - expected) <= found.error + 1e-13 * fabs(expected)))
        fail_msg("%s: %.17g with the error %g, expected %.17g", what, found.value, found.error, expected);
    assert_true(found.error <= 1e-7); /* the root of a cosine near 0 is not known better */
}

/* S, by the angles alone. */
static double shine(const struct lx_material *material, double view, double light)
{
    double half = (view + light) / 2 + (fabs(view - light) > 180 ? 180 : 0);
    double cosine = cos((material->model == LX_PHONG ? view + light : half) * DEGREE);
    return cosine > 0 ? pow(cosine, material->shininess) : 0;
}

static void formulas(void **unused)
{
    static const double exponents[] = {0.5, 1, 20, 3.7, 400};
    (void)unused;
    for (int model = LX_BLINN_PHONG; model <= LX_LAMBERT; model += model == LX_PHONG ? LX_LAMBERT - LX_PHONG : 1)
        for (int highlight = LX_HIGHLIGHT_PLAIN; highlight <= LX_HIGHLIGHT_COSINE; highlight++)
            for (int n = 0; n < 5; n++)
                for (double view = -80; view <= 80; view += 32)
                    for (double light = -84; light <= 161; light += 35) {
                        struct lx_material material = usual;
                        material.model = model, material.highlight = highlight, material.shininess = exponents[n];
                        struct lx_reflection found = reflect(&material, view, light);
                        double cosine = fmax(cos(light * DEGREE), 0), weight = 1;
                        if (highlight == LX_HIGHLIGHT_GATED)
                            weight = cosine > 0;
                        if (highlight == LX_HIGHLIGHT_COSINE)
                            weight = cosine;
                        assert_value(found.cosine, cosine, "cosine");
                        assert_value(found.diffuse, 0.75 * cosine, "diffuse");
                        assert_value(found.specular,
                                     model == LX_LAMBERT ? 0 : 0.5 * weight * shine(&material, view, light),
                                     "specular");
                    }
}

/* All weights are divided, and the ambient one is the diffuse one where it is not given. */
static void over_pi(void **unused)
{
    struct lx_material material = usual;
    (void)unused;
    struct lx_lobe plain = lx_lobe_prepare(&material);
    material.over_pi = true;
    struct lx_lobe divided = lx_lobe_prepare(&material);
    assert_true(plain.diffuse.value == 0.75 && plain.specular.value == 0.5 && plain.ambient.value == 0.75);
    assert_value(divided.diffuse, 0.75 / M_PI, "diffuse");
    assert_value(divided.specular, 0.5 / M_PI, "specular");
    assert_value(divided.ambient, 0.75 / M_PI, "ambient");
    struct lx_lobe irradiance = lx_lobe_irradiance();
    assert_true(irradiance.diffuse.value == 1 && irradiance.ambient.value == 1 && lx_is_zero(irradiance.specular));
}

/* A gate is open where the light is above the horizon, and only there. */
static void gates(void **unused)
{
    struct lx_material material = usual;
    struct lx_lobe lobe;
    const lx_bounded3 normal = lx_exact3((const double[]){0, 0, 1}), view = lx_exact3((const double[]){1, 0, 0});
    (void)unused;
    for (int model = LX_BLINN_PHONG; model <= LX_PHONG; model++) {
        material.model = model;
        material.shininess = 0; /* S^0 = 1 wherever it is */
        material.highlight = LX_HIGHLIGHT_GATED;
        lobe = lx_lobe_prepare(&material);
        lx_bounded on = lx_lobe_reflect(&lobe, normal, view, lx_exact3((const double[]){0, 1, 0})).specular;
        lx_bounded below = lx_lobe_reflect(&lobe, normal, view, lx_exact3((const double[]){0, 0.8, -0.6})).specular;
        lx_bounded above = lx_lobe_reflect(&lobe, normal, view, lx_exact3((const double[]){0, 0.8, 0.6})).specular;
        assert_true(lx_is_zero(on) && lx_is_zero(below) && above.value == 0.5);
        material.highlight = LX_HIGHLIGHT_PLAIN;
        lobe = lx_lobe_prepare(&material);
        assert_true(lx_lobe_reflect(&lobe, normal, view, lx_exact3((const double[]){0, 0.8, -0.6})).specular.value ==
                    0.5);
    }
}

/* Over pi and with the cosine a normalized lobe reflects ks of what falls in along the normal, over all angles. */
static void normalized(void **unused)
{
    enum { STEPS = 20000 };
    static const double exponents[] = {0, 1, 5, 60};
    struct lx_material material = usual;
    (void)unused;
    material.over_pi = material.normalized = true;
    material.highlight = LX_HIGHLIGHT_COSINE;
    for (int model = LX_BLINN_PHONG; model <= LX_PHONG; model++)
        for (int n = 0; n < 4; n++) {
            material.model = model;
            material.shininess = exponents[n];
            double sum = 0;
            for (int i = 0; i < STEPS; i++) {
                double angle = (i + 0.5) / STEPS * 90;
                sum += reflect(&material, 0, angle).specular.value * 2 * M_PI * sin(angle * DEGREE);
            }
            sum *= M_PI / 2 / STEPS;
            if (!(fabs(sum - 0.5) <= 1e-7))
                fail_msg("model %d, exponent %g: %.12g", model, exponents[n], sum);
        }
}

/* The answers of a highlight fit its value: its logarithm, where it ends, and how great it may be near a direction. */
static void answers_fit(void **unused)
{
    struct randomness random = {.state = 2026};
    (void)unused;
    for (int n = 0; n < 20000; n++) {
        const struct lx_lobe lobe = {.model = n % 2 ? LX_PHONG : LX_BLINN_PHONG,
                                     .specular = lx_exact(1),
                                     .exponent = logarithmic(&random, 0.3, 300)};
        const struct lx_lobe_kind *kind = lx_lobe_kind_of(&lobe);
        double normal[3], view[3], towards[3], near[3], error = 0, limit;
        random_direction(&random, normal);
        random_direction(&random, view);
        random_direction(&random, towards);
        struct lx_lobe_at at;
        lx_lobe_at_set(normal, view, &at);
        const lx_bounded value = kind->value(&lobe, lx_exact3(normal), lx_exact3(view), lx_exact3(towards));
        const double log_value = lx_lobe_log(&lobe, &at, towards, 0, &error), *end = kind->end(&at, &limit);
        const double beyond = lx_dot(end, towards) - limit, square = exp(2 * log_value / lobe.exponent);
        if (value.value > 1e-280)
            assert_true(fabs(exp(log_value) / value.value - 1) <= error + value.error / value.value + 1e-12);
        assert_true(fabs(beyond) < 1e-9 || (beyond > 0) == (log_value > -HUGE_VAL));
        assert_true(square <= kind->power->greatest_square(lx_dot(at.mirrored, towards)) + 1e-12);
        for (int k = 0; k < 3; k++)
            near[k] = towards[k] + uniform(&random, -0.1, 0.1);
        lx_normalize(near);
        const double spread = lx_angle_between(near, towards);
        assert_true(!(square > 0) || cos(kind->power->least_angle(&at, near, spread)) >= sqrt(square) - 1e-9 ||
                    kind->power->least_angle(&at, near, spread) < 0);
        assert_true(lx_lobe_weight(&lobe, -1) == 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formulas),   cmocka_unit_test(over_pi),     cmocka_unit_test(gates),
        cmocka_unit_test(normalized), cmocka_unit_test(answers_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

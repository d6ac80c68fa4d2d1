/* SPDX-License-Identifier: MIT */
/*
 * What float32 is left to: the bound of a light's rounding by its formula, the sizes and angles beyond which there is
 * none, how many lights share what a picture may be off by, and which tolerance samples in float32 still meet.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "picture/precision.h"
#include "picture/area_light.h"

static const double unit = 0x1p-24, allowance = 2.5e-6;

extern const struct lx_surface_kind lx_sphere_kind;

static const struct lx_shape sphere = {.type = LX_SPHERE, .kind = &lx_sphere_kind, .radius_mm = 300};

static void assert_near(double found, double expected, double relative)
{
    if (!(fabs(found - expected) <= relative * fabs(expected)))
        fail_msg("%.17g instead of %.17g", found, expected);
}

static struct lx_emitter light_of(enum lx_emitter_type type)
{
    return (struct lx_emitter){.type = type,
                               .strength = 5,
                               .attenuation = LX_NO_ATTENUATION,
                               .profile = {.falloff = LX_NO_CONE, .outer_rad = lx_exact(0.5)}};
}

static struct lx_lobe lobe_of(enum lx_model model, enum lx_highlight highlight, double specular, double exponent)
{
    return (struct lx_lobe){.model = model,
                            .highlight = highlight,
                            .diffuse = lx_exact(0.4),
                            .specular = lx_exact(specular),
                            .exponent = exponent};
}

/* -- the formula -- */

static void bounds(void **state)
{
    const struct lx_stand stand = {.nearest_mm = 500, .away_mm = 900, .least_half = 0.25};
    const struct lx_stand none = {.least_half = 2};
    const double moved = unit * 1200 / 500, off = moved + 3 * unit;
    struct lx_emitter point = light_of(LX_POINT), distant = light_of(LX_DIRECTION);
    struct lx_lobe matt = lobe_of(LX_PHONG, LX_HIGHLIGHT_PLAIN, 0, 20);
    (void)state;
    assert_near(lx_bound_stand(&sphere, &matt, &distant, 5, &none), 5 * 0.4 * 3 * unit, 1e-12);
    assert_near(lx_bound_stand(&sphere, &matt, &point, 7, &stand), 7 * 0.4 * (off + 2 * unit), 1e-12);
    point.attenuation = LX_INVERSE_SQUARE;
    assert_near(lx_bound_stand(&sphere, &matt, &point, 7, &stand), 4 * 7 * 0.4 * (off + 2 * unit), 1e-12);
    point.attenuation = LX_PRACTICAL, point.k_mm = 1500;
    assert_near(lx_bound_stand(&sphere, &matt, &point, 7, &stand), 7 * 0.4 * (off + 2 * unit) / 2, 1e-12);
    point.attenuation = LX_NO_ATTENUATION;
    /* the slope of a highlight; of its angle the mirror lobe keeps the error, the half vector divides it */
    struct lx_lobe phong = lobe_of(LX_PHONG, LX_HIGHLIGHT_PLAIN, 0.3, 100);
    double diffuse = 0.4 * (off + 2 * unit), slope = 0.61 * 10;
    assert_near(lx_bound_stand(&sphere, &phong, &point, 7, &stand),
                7 * (diffuse + 0.3 * (slope * (off + 4 * unit) + 12 * unit)), 1e-12);
    phong.highlight = LX_HIGHLIGHT_COSINE;
    assert_near(lx_bound_stand(&sphere, &phong, &point, 7, &stand),
                7 * (diffuse + 0.3 * (slope * (off + 4 * unit) + off + 13 * unit)), 1e-12);
    struct lx_lobe blinn = lobe_of(LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, 0.3, 1);
    assert_near(lx_bound_stand(&sphere, &blinn, &point, 7, &stand),
                7 * (diffuse + 0.3 * ((off + 2 * unit) / 0.25 + 3 * unit + 12 * unit)), 1e-12);
    blinn.exponent = 0.999;
    assert_true(lx_bound_stand(&sphere, &blinn, &point, 7, &stand) == HUGE_VAL);
    blinn.exponent = 0;
    assert_near(lx_bound_stand(&sphere, &blinn, &point, 7, &stand), 7 * (diffuse + 0.3 * 12 * unit), 1e-12);
}

/* -- where there is none -- */

static bool has_bound(const struct lx_shape *shape, const struct lx_lobe *lobe, const struct lx_emitter *emitter,
                      double strength, double away)
{
    const struct lx_stand stand = {.nearest_mm = away, .away_mm = away, .least_half = 2};
    return lx_bound_stand(shape, lobe, emitter, strength, &stand) < HUGE_VAL;
}

static void sizes(void **state)
{
    const double low = 1e-7, high = 1e9, inside[2] = {nextafter(low, 1), nextafter(high, 1)}, outside[2] = {low, high};
    (void)state;
    for (int i = 0; i < 4; i++) {
        const double size = i % 2 ? outside[i / 2] : i / 2 ? nextafter(high, 0) : inside[0];
        const bool fits = i % 2 == 0;
        struct lx_emitter point = light_of(LX_POINT), distant = light_of(LX_DIRECTION);
        struct lx_lobe lobe = lobe_of(LX_PHONG, LX_HIGHLIGHT_PLAIN, 0, 1);
        struct lx_shape shape = sphere;
        assert_int_equal(has_bound(&sphere, &lobe, &distant, size, 0), fits);
        shape.radius_mm = size;
        assert_int_equal(has_bound(&shape, &lobe, &distant, 1, 0), fits);
        shape.radius_mm = 2e-7;
        assert_int_equal(has_bound(&shape, &lobe, &point, 1, size), fits);
        distant.k_mm = size;
        assert_int_equal(has_bound(&sphere, &lobe, &distant, 1, 0), fits);
        distant.k_mm = 0;
        lobe.diffuse = lx_exact(size);
        assert_int_equal(has_bound(&sphere, &lobe, &distant, 1, 0), fits);
        lobe.diffuse = lx_exact(1), lobe.specular = lx_exact(size);
        assert_int_equal(has_bound(&sphere, &lobe, &distant, 1, 0), fits);
    }
    struct lx_emitter point = light_of(LX_POINT);
    struct lx_lobe lobe = lobe_of(LX_PHONG, LX_HIGHLIGHT_PLAIN, 0, 1);
    point.attenuation = LX_INVERSE_SQUARE; /* 900 W/sr at 1 mm is 9e8 W/m^2 */
    assert_true(has_bound(&sphere, &lobe, &point, 3e6, 100) && !has_bound(&sphere, &lobe, &point, 3e7, 100));
}

/* The greatest number for which there is a bound. */
static double greatest(bool (*has)(double), double low, double high)
{
    assert_true(has(low) && !has(high));
    for (int i = 0; i < 100; i++) {
        double middle = (low + high) / 2;
        *(has(middle) ? &low : &high) = middle;
    }
    return low;
}

static const double away_mm = 3000;

static double relative_error(void)
{
    return 2 * unit * (away_mm + 300) / away_mm + 4 * unit;
}

static double direction_error(void)
{
    return unit * (away_mm + 300) / away_mm + 5 * unit;
}

static bool has_with(struct lx_profile profile)
{
    struct lx_emitter point = light_of(LX_POINT);
    struct lx_lobe lobe = lobe_of(LX_PHONG, LX_HIGHLIGHT_PLAIN, 0, 1);
    point.profile = profile;
    return has_bound(&sphere, &lobe, &point, 1, away_mm);
}

static bool has_exponent(double exponent)
{
    return has_with((struct lx_profile){.falloff = LX_NO_CONE, .exponent = exponent});
}

/* A cone whose penumbra has a versine that is so many times smaller than 1; or, where it is hard, the cone itself. */
static bool has_narrow(enum lx_falloff falloff, double times)
{
    return has_with(
        (struct lx_profile){.falloff = falloff, .outer_versine = lx_exact(1 / times), .inner_versine = lx_exact(0)});
}

static bool has_linear(double times)
{
    return has_narrow(LX_LINEAR, times);
}

static bool has_smooth(double times)
{
    return has_narrow(LX_SMOOTHSTEP, times);
}

static bool has_squared(double times)
{
    return has_narrow(LX_SQUARED, times);
}

static bool has_hard(double times)
{
    return has_narrow(LX_HARD, times);
}

/* A pattern may take half of the allowance, relative to the light. */
static void patterns(void **state)
{
    const double left = allowance / 2 - relative_error(), off = direction_error(), rounding = 4 * 0x1p-52;
    const double penumbra = 1.5 * unit * (away_mm + 300) / away_mm + 3 * unit;
    (void)state;
    assert_near(greatest(has_exponent, 1, 1e6), pow(left / off / 0.61, 2), 1e-9);
    assert_near(greatest(has_linear, 1, 1e12), (left - penumbra) / rounding, 1e-9);
    assert_near(greatest(has_smooth, 1, 1e12), (left - penumbra) / rounding, 1e-9);
    assert_near(greatest(has_squared, 1, 1e12), (left / 2 - penumbra) / rounding, 1e-9);
    assert_near(greatest(has_hard, 1, 1e12), left / rounding, 1e-9);
    assert_false(has_exponent(0.5));
}

/* -- how many -- */

static size_t chosen_of(double bound, size_t count, double maximum, struct lx_rounding_sum before)
{
    double all[200];
    for (size_t i = 0; i < count; i++)
        all[i] = bound;
    size_t chosen = lx_choose_precision(all, count, maximum, NULL, &before), negative = 0;
    for (size_t i = 0; i < count; i++)
        negative += all[i] < 0;
    assert_int_equal(chosen, negative);
    return chosen;
}

/* A third of their sum, and the root of the sum of their squares, stay below the allowance. */
static void shares(void **state)
{
    const struct lx_rounding_sum none = {0, 0}, some = {allowance, allowance * allowance / 2};
    (void)state;
    assert_int_equal(chosen_of(allowance * 0.999, 200, 1, none), 1);
    assert_int_equal(chosen_of(allowance * 1.001, 200, 1, none), 0);
    assert_int_equal(chosen_of(allowance * 0.999, 200, 1.002, none), 1);
    assert_int_equal(chosen_of(allowance * 0.51, 200, 1, none), 3);
    assert_int_equal(chosen_of(allowance * 0.49, 200, 1, none), 4);
    assert_int_equal(chosen_of(allowance / 7.01, 200, 1, none), 21);
    assert_int_equal(chosen_of(allowance / 6.99, 200, 1, none), 20);
    assert_int_equal(chosen_of(allowance * 0.49, 200, 1, some), 2);
    assert_int_equal(chosen_of(allowance / 10.01, 200, 1, some), 20);
    assert_int_equal(chosen_of(HUGE_VAL, 200, 1, none), 0);
    assert_int_equal(chosen_of(0, 200, 0, none), 200);
    /* the smallest first, wherever they stand */
    double mixed[] = {allowance * 0.9, allowance / 100, allowance * 0.8, allowance / 2000, allowance * 0.7};
    struct lx_rounding_sum rounding = none;
    assert_int_equal(lx_choose_precision(mixed, 5, 1, NULL, &rounding), 3);
    assert_true(mixed[0] < 0 && mixed[1] < 0 && mixed[2] > 0 && mixed[3] < 0 && mixed[4] > 0);
    assert_near(rounding.sum, allowance * (0.9 + 0.01 + 0.0005), 1e-12);
    assert_near(rounding.squares, allowance * allowance * (0.81 + 0.0001 + 0.00000025), 1e-12);
}

/* -- samples -- */

static double least_tolerance(struct lx_area_light lamp, double exponent)
{
    struct lx_lobe_double lobe = {.specular = 0.3, .exponent = lx_exponent_of(exponent)};
    double low = 0, high = 1;
    for (int i = 0; i < 80; i++) {
        double middle = (low + high) / 2;
        *(lx_samples_fit_single(&sphere, &lobe, &lamp, middle) ? &high : &low) = middle;
    }
    return high;
}

/* Two hundred times the rounding of the way to them, as steep as the highlight. */
static void samples(void **state)
{
    struct lx_area_light lamp = {.type = LX_FACETS, .center = {0, -900, 1200}, .radius_mm = 200, .radiance = 3};
    const double off = unit * (1500 + 200 + 300) / (1500 - 300 - 200) + 4 * unit;
    (void)state;
    assert_near(least_tolerance(lamp, 1), 200 * off, 1e-12);
    assert_near(least_tolerance(lamp, 400), 200 * off * 0.61 * 20, 1e-12);
    lamp.radius_mm = 1199;
    assert_true(least_tolerance(lamp, 1) < 1);
    lamp.radius_mm = 1200; /* it may touch */
    assert_true(least_tolerance(lamp, 1) == 1);
    lamp.radius_mm = 200, lamp.radiance = 1e9;
    assert_true(least_tolerance(lamp, 1) == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds), cmocka_unit_test(sizes),   cmocka_unit_test(patterns),
        cmocka_unit_test(shares), cmocka_unit_test(samples),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

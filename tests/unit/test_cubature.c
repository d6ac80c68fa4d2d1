/* SPDX-License-Identifier: MIT */
/*
 * The integrals over extended sources: against closed forms (the diffuse part by 1/r^2, Arvo's axial moments of a
 * square, the albedo of a half-vector lobe), against themselves at tighter tolerances in random scenes of every kind,
 * lobe, law and size, and what must be so anyway: shares of a divided source add up, elements behind see nothing.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "campaign.h"
#include "light/solid/facets.h"
#include "world/integral/cubature.h"
#include "world/reference.h"

/* xorshift64*: the same scenes on every machine */
static double uniform(uint64_t *state, double low, double high)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return low + (high - low) * ((double)((*state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

static lx_bounded3 unit_of(double x, double y, double z)
{
    double length = sqrt(x * x + y * y + z * z);
    return lx_exact3((const double[]){x / length, y / length, z / length});
}

static struct lx_element element_at_origin(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view)
{
    return (struct lx_element){
        .place_mm = lx_exact3((const double[]){0, 0, 0}), .normal = normal, .view = view, .lobe = lobe};
}

static struct lx_lobe lobe_of(enum lx_model model, enum lx_highlight highlight, double exponent)
{
    return (struct lx_lobe){
        .model = model, .highlight = highlight, .diffuse = lx_exact(0), .specular = lx_exact(1), .exponent = exponent};
}

static void assert_near(double value, double expected, double tolerance, const char *what)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s: %.17g, expected %.17g to %g", what, value, expected, tolerance);
}

/* The unit square at the distance 1, radiance 1: integrals of max(0, w.u)^n dw (Arvo 1995, to 8 digits). */
static void axial_moments(void **unused)
{
    static const struct {
        double w[3], exponent, expected;
    } cases[] = {
        {{0, 0, 1}, 0, .80543168},  {{0, 0, 1}, 1, .75227469}, {{0, 0, 1}, 2, .70394207},  {{0, 0, 1}, 10, .44067944},
        {{0, 0, 1}, 50, .12300602}, {{1, 0, 2}, 1, .67285494}, {{1, 0, 2}, 10, .25030005}, {{1, 0, 2}, 50, .06150973},
    };
    (void)unused;
    struct lx_facets *square = lx_facets_of_rectangle((const double[]){0, 0, 1000}, (const double[]){1000, 1000},
                                                      (const double[]){0, 0, -1}, (const double[]){0, 1, 0});
    struct lx_emitter emitter = {.type = LX_FACETS, .radiance = lx_exact(1), .facets = square};
    assert_non_null(square);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct lx_lobe lobe = lobe_of(LX_PHONG, LX_HIGHLIGHT_PLAIN, cases[i].exponent);
        lx_bounded3 w =
            unit_of(cases[i].w[0], cases[i].w[1], cases[i].w[2]); /* seen along N, R is V mirrored at itself */
        struct lx_element element = element_at_origin(&lobe, w, w);
        struct lx_cubature found = lx_integrate(&emitter, &element, NULL, false, 0, 1e-11, NULL);
        assert_near(found.specular.value, cases[i].expected, 0.5e-8 + found.specular.error, "axial moment");
        assert_true(found.specular.error <= 1.001e-11 * found.specular.value);
        assert_true(found.parts > 0);
    }
    lx_facets_free(square);
}

/* At normal view over the hemisphere: 8 pi (2^(-n/2) + n)/((n + 2)(n + 4)).  A disk of 1000 km at 1 mm is one. */
static void albedo(void **unused)
{
    (void)unused;
    struct lx_emitter disk = {.type = LX_DISK, .radiance = lx_exact(1), .center_mm = {0, 0, 1}, .radius_mm = 1e9};
    disk.axis = lx_exact3((const double[]){0, 0, -1});
    lx_bounded3 up = lx_exact3((const double[]){0, 0, 1});
    for (double n = 0.125; n < 20000; n *= 4) {
        struct lx_lobe lobe = lobe_of(LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE, n);
        struct lx_element element = element_at_origin(&lobe, up, up);
        struct lx_cubature found = lx_integrate(&disk, &element, NULL, false, 0, 1e-11, NULL);
        double expected = 8 * M_PI * (exp2(-n / 2) + n) / ((n + 2) * (n + 4));
        assert_near(found.specular.value, expected, found.specular.error + 1e-13 * expected, "albedo");
    }
}

/* A source of any kind that does not touch the origin; false: it would. */
static bool random_source(uint64_t *random, struct lx_emitter *emitter)
{
    double size = pow(10, uniform(random, -2, 3)), center[3], axis[3];
    for (int i = 0; i < 3; i++) {
        center[i] = uniform(random, -1000, 1000);
        axis[i] = uniform(random, -1, 1);
    }
    *emitter = (struct lx_emitter){
        .type = (enum lx_emitter_type)(LX_FACETS + (int)uniform(random, 0, 4)),
        .radiance = lx_exact(1),
        .attenuation = (enum lx_attenuation)uniform(random, 0, LX_LAWS),
        .k_mm = uniform(random, 10, 2000),
        .coefficients = {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)},
        .radius_mm = size * uniform(random, 50, 500),
        .axis = unit_of(axis[0], axis[1], axis[2]),
    };
    for (int i = 0; i < 3; i++)
        emitter->center_mm[i] = center[i];
    double reach = emitter->radius_mm;
    if (emitter->type == LX_CYLINDER) {
        emitter->height_mm = size * uniform(random, 50, 1000);
        reach = hypot(reach, emitter->height_mm / 2);
    }
    if (emitter->type == LX_FACETS && uniform(random, 0, 1) < 0.5) {
        const double sides[3] = {emitter->radius_mm, size * uniform(random, 50, 500), size * uniform(random, 50, 500)};
        emitter->facets = lx_facets_of_box(center, sides);
        reach = emitter->facets->radius_mm;
    } else if (emitter->type == LX_FACETS) {
        const double sides[2] = {emitter->radius_mm, size * uniform(random, 1, 500)}, up[3] = {0.1, 1, 0.2};
        emitter->facets = lx_facets_of_rectangle(center, sides, axis, up);
        reach = 0;
    }
    bool apart = emitter->type == LX_DISK || hypot(hypot(center[0], center[1]), center[2]) > 1.001 * reach;
    if (!apart)
        lx_facets_free(emitter->facets);
    return apart;
}

static struct lx_element random_element(uint64_t *random, const struct lx_lobe *lobe)
{
    double n[3], v[3], product = 0;
    for (int i = 0; i < 3; i++) {
        n[i] = uniform(random, -1, 1);
        v[i] = uniform(random, -1, 1);
        product += n[i] * v[i];
    }
    /* elements are mostly seen from their front */
    double sign = product < 0 && uniform(random, 0, 1) < 0.7 ? -1 : 1;
    return element_at_origin(lobe, unit_of(sign * n[0], sign * n[1], sign * n[2]), unit_of(v[0], v[1], v[2]));
}

static void diffuse_as_in_closed_form(void **unused)
{
    enum { SCENES = 400 };
    uint64_t random = 20;
    (void)unused;
    for (int i = 0; i < scenes_to_try(SCENES); i++) {
        struct lx_emitter emitter;
        struct lx_lobe lobe = lx_lobe_irradiance();
        if (!random_source(&random, &emitter))
            continue;
        struct lx_element element = random_element(&random, &lobe);
        emitter.attenuation = LX_INVERSE_SQUARE;
        lx_bounded closed = lx_extended_irradiance(&emitter, element.place_mm, element.normal);
        lx_bounded found = lx_integrate(&emitter, &element, NULL, true, 0, 1e-10, NULL).irradiance;
        if (!(fabs(found.value - closed.value) <= found.error + closed.error))
            fail_msg("scene %d, type %d: integral %.17g +- %g, closed form %.17g +- %g", i, emitter.type, found.value,
                     found.error, closed.value, closed.error);
        lx_facets_free(emitter.facets);
    }
}

/* Even the area of a needle is rounded: 30 mm x 0.0001 mm. */
static void needles(void **unused)
{
    uint64_t random = 23;
    (void)unused;
    for (int i = 0; i < 50; i++) {
        const double center[3] = {uniform(&random, -50, 50), uniform(&random, -50, 50), 1000}, size[2] = {30, 1e-4};
        const double axis[3] = {uniform(&random, -1, 1), 0.2, -1}, up[3] = {uniform(&random, -1, 1), 2, 0.3};
        struct lx_emitter emitter = {.type = LX_FACETS, .radiance = lx_exact(1)};
        struct lx_lobe lobe = lx_lobe_irradiance();
        lx_bounded3 normal = lx_exact3((const double[]){0, 0, 1});
        struct lx_element element = element_at_origin(&lobe, normal, normal);
        emitter.facets = lx_facets_of_rectangle(center, size, axis, up);
        assert_non_null(emitter.facets);
        lx_bounded closed = lx_extended_irradiance(&emitter, element.place_mm, element.normal);
        lx_bounded found = lx_integrate(&emitter, &element, NULL, true, 0, 1e-9, NULL).irradiance;
        assert_near(found.value, closed.value, found.error + closed.error, "needle");
        assert_true(found.error < 1e-9 * found.value && closed.error < 1e-12 * closed.value);
        lx_facets_free(emitter.facets);
    }
}

/* So far away that an arc across it is shorter than angles are told apart: less than a millionth of a mm at 1000 km. */
static void far_needles(void **unused)
{
    uint64_t random = 25;
    (void)unused;
    for (int i = 0; i < 60; i++) {
        const double center[3] = {uniform(&random, -1e9, 1e9), uniform(&random, -1e9, 1e9), uniform(&random, 1e8, 1e9)};
        const double size[2] = {1, 3e-8}, up[3] = {uniform(&random, -1, 1), 2, uniform(&random, -1, 1)};
        const double axis[3] = {-center[0] + uniform(&random, -4e8, 4e8), -center[1] + 4e8, -center[2]};
        struct lx_emitter emitter = {.type = LX_FACETS, .radiance = lx_exact(1)};
        struct lx_lobe lobe = lobe_of(i % 2 ? LX_BLINN_PHONG : LX_PHONG, LX_HIGHLIGHT_PLAIN, 2);
        struct lx_element element = element_at_origin(
            &lobe, unit_of(uniform(&random, -0.5, 0.5), uniform(&random, -0.5, 0.5), 1), unit_of(0, 0, 1));
        emitter.facets = lx_facets_of_rectangle(center, size, axis, up);
        assert_non_null(emitter.facets);
        const double n[3] = {element.normal.x.value, element.normal.y.value, element.normal.z.value};
        const double r2 = center[0] * center[0] + center[1] * center[1] + center[2] * center[2], r = sqrt(r2);
        const double l[3] = {center[0] / r, center[1] / r, center[2] / r};
        const double n_dot_l = n[0] * l[0] + n[1] * l[1] + n[2] * l[2];
        const double cosine = i % 2 ? (n_dot_l + n[2]) / sqrt(2 + 2 * l[2]) : 2 * n_dot_l * n[2] - l[2];
        const double incidence = -(axis[0] * l[0] + axis[1] * l[1] + axis[2] * l[2]) /
                                 sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        const double power = fmax(incidence, 0) * size[0] * size[1] / r2, shine = cosine > 0 ? cosine * cosine : 0;
        struct lx_cubature found = lx_integrate(&emitter, &element, NULL, true, 0, 1e-6, NULL);
        assert_near(found.specular.value, power * shine, found.specular.error + 1e-9 * power, "far needle's highlight");
        assert_near(found.irradiance.value, power * fmax(n_dot_l, 0), found.irradiance.error + 1e-9 * power,
                    "far needle");
        lx_facets_free(emitter.facets);
    }
}

/*
 * A wire up to 10 km long that passes some metres away, and beside it light a hundred times as bright, so that it is
 * looked at but coarsely: what is near of it is a thousandth of a strip, and must not be missed.
 */
static void wires(void **unused)
{
    static const double tolerances[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6};
    uint64_t random = 24;
    (void)unused;
    for (int i = 0; i < 400; i++) {
        const double size[2] = {pow(10, uniform(&random, 2, 7)), pow(10, uniform(&random, -1, 1.5))};
        const double center[3] = {uniform(&random, -500, 500) + uniform(&random, -0.4, 0.4) * size[0],
                                  uniform(&random, -500, 500), uniform(&random, 100, 1500)};
        const double axis[3] = {0, uniform(&random, -1, 1), -1}, up[3] = {uniform(&random, -0.02, 0.02), 1, 0.3};
        const double lean[3] = {uniform(&random, -0.5, 0.5), uniform(&random, -0.5, 0.5), 1};
        struct lx_emitter emitter = {.type = LX_FACETS, .radiance = lx_exact(1)};
        struct lx_lobe lobe = lobe_of((enum lx_model)(i % 2), LX_HIGHLIGHT_PLAIN, i % 3 ? 1 : 20);
        struct lx_element element = element_at_origin(&lobe, unit_of(lean[0], lean[1], lean[2]), unit_of(0, 0, 1));
        emitter.facets = lx_facets_of_rectangle(center, size, axis, up);
        assert_non_null(emitter.facets);
        const double closed = lx_extended_irradiance(&emitter, element.place_mm, element.normal).value;
        const struct lx_cubature fine = lx_integrate(&emitter, &element, NULL, false, 0, 1e-9, NULL);
        for (size_t k = 0; k < sizeof tolerances / sizeof tolerances[0]; k++) {
            const double known = 100 * fmax(closed, fine.specular.value);
            struct lx_cubature coarse = lx_integrate(&emitter, &element, NULL, true, known, tolerances[k], NULL);
            if (!(fabs(coarse.irradiance.value - closed) <= coarse.irradiance.error + 1e-11 * closed) ||
                !(fabs(coarse.specular.value - fine.specular.value) <= coarse.specular.error + fine.specular.error))
                fail_msg("wire %d, %g mm x %g mm, tolerance %g: diffuse %.17g +- %g, closed form %.17g; highlight "
                         "%.17g +- %g, finer %.17g +- %g",
                         i, size[0], size[1], tolerances[k], coarse.irradiance.value, coarse.irradiance.error, closed,
                         coarse.specular.value, coarse.specular.error, fine.specular.value, fine.specular.error);
        }
        lx_facets_free(emitter.facets);
    }
}

/* The bounds of coarse integrals hold the fine ones. */
static void errors_are_honest(void **unused)
{
    enum { SCENES = 600 };
    static const double tolerances[] = {1e-2, 1e-4, 1e-6, 1e-9};
    uint64_t random = 21;
    (void)unused;
    for (int i = 0; i < scenes_to_try(SCENES); i++) {
        struct lx_emitter emitter;
        if (!random_source(&random, &emitter))
            continue;
        struct lx_lobe lobe = lobe_of((enum lx_model)uniform(&random, 0, 2), (enum lx_highlight)uniform(&random, 0, 3),
                                      pow(10, uniform(&random, -3, 4)));
        struct lx_element element = random_element(&random, &lobe);
        struct lx_cubature fine = lx_integrate(&emitter, &element, NULL, true, 0, 1e-11, NULL);
        for (size_t k = 0; k < sizeof tolerances / sizeof tolerances[0]; k++) {
            struct lx_cubature coarse = lx_integrate(&emitter, &element, NULL, true, 0, tolerances[k], NULL);
            if (!(fabs(coarse.specular.value - fine.specular.value) <= coarse.specular.error + fine.specular.error) ||
                !(fabs(coarse.irradiance.value - fine.irradiance.value) <=
                  coarse.irradiance.error + fine.irradiance.error))
                fail_msg("scene %d, type %d, model %d, highlight %d, law %d, exponent %g, tolerance %g: highlight "
                         "%.17g +- %g, finer %.17g +- %g; diffuse %.17g +- %g, finer %.17g +- %g",
                         i, emitter.type, lobe.model, lobe.highlight, emitter.attenuation, lobe.exponent, tolerances[k],
                         coarse.specular.value, coarse.specular.error, fine.specular.value, fine.specular.error,
                         coarse.irradiance.value, coarse.irradiance.error, fine.irradiance.value,
                         fine.irradiance.error);
        }
        lx_facets_free(emitter.facets);
    }
}

static double either(uint64_t *random, double size)
{
    return uniform(random, 0, 1) < 0.5 ? -size : size;
}

/* A vector with each component moved by as much as the error that it gets. */
static lx_bounded3 shaken(uint64_t *random, lx_bounded3 *vector, double off)
{
    lx_bounded3 there = *vector;
    lx_bounded *to[3] = {&there.x, &there.y, &there.z}, *from[3] = {&vector->x, &vector->y, &vector->z};
    for (int i = 0; i < 3; i++) {
        to[i]->value += either(random, off);
        from[i]->error = off;
    }
    return there;
}

/*
 * What place, normal or view may be off: the bounds cover it.  Exponents from 1 on; of gated highlights those that jump
 * where only the normal moves the border, Phong's.
 */
static void uncertain_elements(void **unused)
{
    enum { SCENES = 1200 };
    uint64_t random = 24;
    unsigned farther = 0;
    (void)unused;
    for (int i = 0; i < scenes_to_try(SCENES); i++) {
        struct lx_emitter emitter;
        if (!random_source(&random, &emitter))
            continue;
        enum lx_highlight highlight = (enum lx_highlight)uniform(&random, 0, 3);
        enum lx_model model = (enum lx_model)uniform(&random, 0, 2);
        bool jumps = highlight == LX_HIGHLIGHT_GATED;
        if (jumps && (model != LX_PHONG || i % 3 == 0)) {
            lx_facets_free(emitter.facets);
            continue;
        }
        /* wide ones that are gated reach the horizon, where they jump */
        struct lx_lobe lobe = lobe_of(model, highlight, pow(10, uniform(&random, 0, jumps ? 0.3 : 3)));
        struct lx_element here = random_element(&random, &lobe), there = here;
        double off = pow(10, uniform(&random, -7, -4));
        if (i % 3 == 0)
            there.place_mm = shaken(&random, &here.place_mm, 100 * off);
        else if (i % 3 == 1)
            there.normal = shaken(&random, &here.normal, off);
        else
            there.view = shaken(&random, &here.view, off);
        there.normal = lx_unit3(there.normal), there.view = lx_unit3(there.view);
        if (lx_extended_touches(&emitter, here.place_mm)) {
            lx_facets_free(emitter.facets);
            continue;
        }
        struct lx_cubature found = lx_integrate(&emitter, &here, NULL, true, 0, 1e-9, NULL);
        struct lx_cubature other = lx_integrate(&emitter, &there, NULL, true, 0, 1e-9, NULL);
        const lx_bounded pairs[2][2] = {{found.irradiance, other.irradiance}, {found.specular, other.specular}};
        for (int k = 0; k < 2; k++) {
            double apart = fabs(pairs[k][0].value - pairs[k][1].value);
            if (!(apart <= pairs[k][0].error + pairs[k][1].error))
                fail_msg("scene %d, type %d, %s: %.17g +- %g, moved %.17g +- %g", i, emitter.type,
                         k ? "highlight" : "diffuse", pairs[k][0].value, pairs[k][0].error, pairs[k][1].value,
                         pairs[k][1].error);
            farther += apart > 1e-8 * pairs[k][0].value;
        }
        lx_facets_free(emitter.facets);
    }
    assert_true(farther > (unsigned)scenes_to_try(SCENES) / 4); /* most moves matter */
}

/* A corner of a rectangle; the edge from corner 0 to corner 1, or from 1 to 2, is the one along its width. */
static void corner_of(const struct lx_facets *facets, unsigned i, double corner[3])
{
    lx_wide3 place = facets->corners_mm[facets->loop[i]];
    corner[0] = lx_wide_value(place.x), corner[1] = lx_wide_value(place.y), corner[2] = lx_wide_value(place.z);
}

/* A rectangle and its two halves. */
static void shares_add_up(void **unused)
{
    static const double axis[3] = {0.2, -0.1, -1}, up[3] = {0.5, 0.5, 0.1}, size[2] = {800, 300}, half[2] = {400, 300};
    uint64_t random = 22;
    (void)unused;
    for (int i = 0; i < 60; i++) {
        const double center[3] = {uniform(&random, -500, 500), uniform(&random, -500, 500), uniform(&random, 50, 900)};
        struct lx_facets *all = lx_facets_of_rectangle(center, size, axis, up);
        double sum = 0, error = 0, corners[3][3], first = 0;
        assert_non_null(all);
        for (unsigned k = 0; k < 3; k++)
            corner_of(all, k, corners[k]);
        for (int k = 0; k < 3; k++)
            first += (corners[1][k] - corners[0][k]) * (corners[1][k] - corners[0][k]);
        int start = first > 500 * 500 ? 0 : 1;
        struct lx_lobe lobe = lobe_of(LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, pow(10, uniform(&random, -1, 3)));
        struct lx_element element = random_element(&random, &lobe);
        struct lx_emitter emitter = {.type = LX_FACETS, .radiance = lx_exact(2), .facets = all};
        lx_bounded whole = lx_integrate(&emitter, &element, NULL, false, 0, 1e-9, NULL).specular;
        for (int side = -1; side <= 1; side += 2) {
            double moved[3];
            for (int k = 0; k < 3; k++)
                moved[k] = center[k] + side * 0.25 * (corners[start + 1][k] - corners[start][k]);
            emitter.facets = lx_facets_of_rectangle(moved, half, axis, up);
            lx_bounded part = lx_integrate(&emitter, &element, NULL, false, 0, 1e-9, NULL).specular;
            sum += part.value;
            error += part.error;
            lx_facets_free(emitter.facets);
        }
        assert_near(sum, whole.value, error + whole.error + 1e-11 * whole.value, "two halves");
        lx_facets_free(all);
    }
}

/* Behind the source, and below the horizon of a highlight that is gated, there is nothing. */
static void dark_places(void **unused)
{
    (void)unused;
    lx_bounded3 up = lx_exact3((const double[]){0, 0, 1}), down = lx_exact3((const double[]){0, 0, -1});
    struct lx_lobe gated = lobe_of(LX_BLINN_PHONG, LX_HIGHLIGHT_GATED, 20);
    struct lx_emitter disk = {.type = LX_DISK, .radiance = lx_exact(1), .center_mm = {0, 0, 500}, .radius_mm = 300};
    struct lx_element element = element_at_origin(&gated, up, up);
    disk.axis = up;
    struct lx_cubature behind = lx_integrate(&disk, &element, NULL, true, 0, 1e-9, NULL);
    assert_true(behind.specular.value == 0 && behind.irradiance.value == 0);
    disk.axis = down;
    element = element_at_origin(&gated, down, down);
    struct lx_cubature below = lx_integrate(&disk, &element, NULL, true, 0, 1e-9, NULL);
    assert_true(below.specular.value == 0 && below.irradiance.value == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(axial_moments),
        cmocka_unit_test(albedo),
        cmocka_unit_test(diffuse_as_in_closed_form),
        cmocka_unit_test(needles),
        cmocka_unit_test(far_needles),
        cmocka_unit_test(wires),
        cmocka_unit_test(errors_are_honest),
        cmocka_unit_test(uncertain_elements),
        cmocka_unit_test(shares_add_up),
        cmocka_unit_test(dark_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

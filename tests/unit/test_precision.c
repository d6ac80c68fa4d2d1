/* SPDX-License-Identifier: MIT */
/*
 * Which lights a picture in single precision leaves to float32: none that float32 cannot do (infinite slopes, cones as
 * narrow as roundings, sources that touch, sizes beyond its range), and together no more than what the picture may be
 * off by.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/plan_make.h"
#include "scene/scene.h"
#include "scenes.h"

static const char form[] = "luxel: 1\n"
                           "screen: {width: 700, height: 700, resolution: [70, 70]}\n"
                           "observer: {z: 3000%s}\n"
                           "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 300, material: {%s}}]\n"
                           "lights: [%s]\n";

struct planned {
    luxel_scene *scene;
    struct lx_prepared prepared;
    struct lx_plan plan;
};

static void plan_text(const char *text, struct planned *made)
{
    if (load(text, NULL, &made->scene) != LUXEL_OK)
        fail_msg("not a good scene: %s", text);
    assert_int_equal(lx_prepare(lx_scene_parameters(made->scene), NULL, NULL, &made->prepared), 0);
    luxel_settings settings;
    luxel_settings_init(&settings);
    assert_int_equal(lx_plan_make(&made->prepared, lx_kernels_choose("generic"), &settings, &made->plan), LUXEL_OK);
}

static void make_plan(const char *observer, const char *material, const char *lights, struct planned *made)
{
    char text[2000];
    snprintf(text, sizeof text, form, observer, material, lights);
    plan_text(text, made);
}

static bool is_in_double(const struct planned *made, size_t light)
{
    const struct lx_light_run *run = made->plan.surfaces[0].runs;
    while (light >= run->first + run->count)
        run++;
    return run->in_double;
}

static void clear(struct planned *made)
{
    lx_plan_clear(&made->plan);
    lx_prepared_clear(&made->prepared);
    luxel_scene_free(made->scene);
}

static void what_float32_cannot_do(void **state)
{
    (void)state;
    static const struct {
        bool in_double;
        const char *observer, *material, *light;
    } cases[] = {
        {false, "", "specular: 0", "{type: point, position: [900, 500, 3000], intensity: 5}"},
        {false, "", "shininess: 20", "{type: point, position: [900, 500, 3000], intensity: 5}"},
        {false, "", "shininess: 20, model: phong", "{type: point, position: [900, 500, 3000], intensity: 5}"},
        {false, "", "shininess: 20, highlight: cosine", "{type: distant, direction: [1, 2, -3], irradiance: 5}"},
        {false, "", "shininess: 20, highlight: gated", "{type: distant, direction: [1, 2, -3], irradiance: 5}"},
        {true, "", "shininess: 0.5", "{type: distant, direction: [1, 2, -3], irradiance: 5}"},
        {true, "", "shininess: 1e5", "{type: distant, direction: [1, 2, -3], irradiance: 5}"},
        /* behind the sphere the half vector vanishes for some element */
        {true, ", projection: perspective", "shininess: 20", "{type: point, position: [0, 0, -2000], intensity: 5}"},
        {false, "", "specular: 0", "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 0, outer: 90}"},
        {false, "", "specular: 0",
         "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 1, outer: 60, falloff: linear}"},
        {false, "", "specular: 0",
         "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 1, outer: 20, falloff: hard}"},
        {true, "", "specular: 0",
         "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 0, outer: 1e-3, falloff: hard}"},
        {false, "", "specular: 0", "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 4.999, outer: 5}"},
        {true, "", "specular: 0", "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 5, outer: 5.0000001}"},
        {false, "", "specular: 0",
         "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 4.999, outer: 5, falloff: squared}"},
        /* 2 t dt counts where the surface is near */
        {true, "", "specular: 0",
         "{type: spot, position: [0, 0, 1700], intensity: 5, inner: 19.999, outer: 20, falloff: squared}"},
        {false, "", "specular: 0",
         "{type: spot, position: [0, 0, 1700], intensity: 5, inner: 19.999, outer: 20, falloff: linear}"},
        {true, "", "specular: 0", "{type: point, position: [0, 0, 1300.01], intensity: 5, attenuation: none}"},
        {true, "", "specular: 0", "{type: point, position: [9e9, 0, 3000], intensity: 5, attenuation: none}"},
        {true, "", "specular: 0", "{type: distant, direction: [0, 0, -1], irradiance: 1e10}"},
        {true, "", "specular: 0", "{type: distant, direction: [0, 0, -1], irradiance: 1e-8}"},
        {true, "", "specular: 0",
         "{type: point, position: [0, 0, 3000], intensity: 5, attenuation: practical, k: 1e-8}"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct planned made;
        make_plan(cases[i].observer, cases[i].material, cases[i].light, &made);
        assert_int_equal(made.plan.surfaces[0].lights.count, 1);
        if (is_in_double(&made, 0) != cases[i].in_double)
            fail_msg("wrongly in %s: %s, %s", cases[i].in_double ? "float32" : "double", cases[i].material,
                     cases[i].light);
        clear(&made);
    }
}

/* A light that makes little of the picture may be coarse where the one that makes most of it could not. */
static void what_does_not_matter(void **state)
{
    (void)state;
    struct planned made;
    make_plan("", "shininess: 30000",
              "{type: distant, direction: [1, 2, -3], irradiance: 5}, "
              "{type: distant, direction: [-2, 1, -3], irradiance: 0.005}",
              &made);
    assert_true(is_in_double(&made, 0) && !is_in_double(&made, 1));
    clear(&made);
}

/* What the lights left to float32 may be off by, together, for many scenes of some lights. */
static void shares_of_the_maximum(void **state)
{
    (void)state;
    unsigned seed = 1;
    size_t left = 0, all = 0;
    for (int n = 0; n < 300; n++) {
        char lights[1500] = "", material[60];
        for (int i = 0, count = 1 + n % 12; i < count; i++) {
            double place[3];
            for (int k = 0; k < 3; k++) {
                seed = seed * 1664525u + 1013904223u;
                place[k] = (seed >> 8) * 0x1p-24 * 3000 - (k < 2 ? 1500 : -1200);
            }
            seed = seed * 1664525u + 1013904223u;
            snprintf(lights + strlen(lights), sizeof lights - strlen(lights),
                     "%s{type: point, position: [%.1f, %.1f, %.1f], intensity: %.3g, attenuation: none}", i ? ", " : "",
                     place[0], place[1], place[2], pow(10, (seed >> 8) * 0x1p-24 * 4 - 2));
        }
        snprintf(material, sizeof material, "shininess: %.3g", pow(10, n % 50 / 10.0));
        struct planned made;
        make_plan("", material, lights, &made);
        const struct lx_planned_surface *surface = &made.plan.surfaces[0];
        const struct lx_prepared_surface *prepared = made.prepared.surfaces;
        double sum = 0, squares = 0;
        for (size_t i = 0; i < surface->lights.count; i++) {
            const struct lx_emitter *emitter = &made.prepared.emitters.items[i];
            const double bound = lx_bound_light(&made.prepared, &prepared->shape, &prepared->lobe, emitter);
            const bool in_single = !is_in_double(&made, i);
            sum += in_single ? bound : 0;
            squares += in_single ? bound * bound : 0;
            left += in_single;
            all++;
        }
        if (!(fmax(sqrt(squares), sum / 3) <= 2.6e-6 * made.plan.least_maximum))
            fail_msg("scene %d: %g, together %g, of a maximum of %g", n, sqrt(squares), sum, made.plan.least_maximum);
        clear(&made);
    }
    assert_true(left > all / 3 && left < all);
}

/*
 * What the terms of facets far away are rounded by: the edges' length times the radius over the square of the distance;
 * also in float64, whose unit is 2^-29 of float32's, but for what places are rounded by.
 */
static void rounding_of_facets(void **state)
{
    (void)state;
    for (double away = 1e4; away < 1e7; away *= 10) {
        char light[200];
        struct planned made;
        snprintf(light, sizeof light, "{type: planar, rectangle: {center: [0, 0, %.17g], size: [60, 80]}, radiance: 3}",
                 1000 + away);
        make_plan("", "model: lambert, diffuse: 0.5", light, &made);
        const struct lx_planned_surface *surface = &made.plan.surfaces[0];
        const struct lx_area_light *lamp = &surface->area_lights[0].lamp;
        const double terms = 3 * surface->lobe_exact.diffuse * 280 * 50 / ((away - 300) * (away - 300));
        const double single = lx_bound_area_light(&surface->shape, surface->lobe_exact.diffuse, lamp, NULL);
        const double exact = lx_bound_area_light_double(&surface->shape, surface->lobe_exact.diffuse, lamp, NULL);
        const double places = (away + 300) / (away - 300);
        assert_true(fabs(single / (terms * 0x1p-24 * (1 + places)) - 1) < 1e-3);
        assert_true(fabs(exact / (terms * 0x1p-53) - 1) < 1e-3);
        assert_true(lamp->edges_single && !surface->area_lights[0].by_reference);
        clear(&made);
    }
}

/* Which pictures take the ways for elements in float32 alone, and for few lights that are all. */
static void the_quickest_ways(void **state)
{
    (void)state;
#define POINT "{type: point, position: [900, 500, 3000], intensity: 5}"
#define FOUR POINT "," POINT "," POINT "," POINT
#define DISTANT "{type: distant, direction: [1, 2, -3], irradiance: 5}"
#define PLATE "{type: planar, rectangle: {center: [0, 0, 3000], size: [300, 200]}, radiance: 1}"
#define NEAR_PLATE "{type: planar, rectangle: {center: [0, 0, 1300.001], size: [300, 200]}, radiance: 1}"
    static const struct {
        bool in_single, at_once;
        const char *observer, *material, *lights;
    } cases[] = {
        {true, true, "", "shininess: 20", POINT},
        {true, true, "", "shininess: 20", POINT ", {type: ambient, irradiance: 1}"},
        {true, false, "", "shininess: 20", "{type: ambient, irradiance: 1}"},
        {true, true, "", "shininess: 20", FOUR "," FOUR "," FOUR "," FOUR},
        {true, false, "", "shininess: 20", FOUR "," FOUR "," FOUR "," FOUR "," POINT},
        {true, false, "", "shininess: 20", POINT "," DISTANT},
        {true, false, "", "specular: 0", PLATE},
        {true, false, "", "specular: 0", POINT "," PLATE},
        {false, false, "", "specular: 0", POINT "," PLATE "," NEAR_PLATE},
        {false, false, "", "shininess: 20", PLATE},
        {false, false, ", projection: perspective", "shininess: 20", POINT},
        {false, false, ", view: observer", "shininess: 20", POINT},
        {false, false, "", "shininess: 20, highlight: gated", POINT},
        {false, false, "", "shininess: 0.5", POINT},
        {false, false, "", "specular: 0", "{type: spot, position: [0, 0, 3000], intensity: 5, inner: 1, outer: 20}"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct planned made;
        make_plan(cases[i].observer, cases[i].material, cases[i].lights, &made);
        if ((made.plan.alone != NULL) != cases[i].in_single || made.plan.at_once != cases[i].at_once)
            fail_msg("case %zu: in float32 %d, at once %d", i, made.plan.alone != NULL, made.plan.at_once);
        clear(&made);
    }
}

/* Other surfaces count where the picture may show them, be it at its edge, or where they take light. */
static void beside_the_picture(void **state)
{
    (void)state;
    static const struct {
        bool is_alone;
        const char *observer, *another;
    } cases[] = {
        {true, "", "[900, 0, 1000], radius: 5"},      {true, "", "[0, -900, 1000], radius: 5"},
        {true, "", "[0, 900, 1000], radius: 5"},      {false, "", "[499, 0, 1000], radius: 5"},
        {false, "", "[0, -499, 1000], radius: 5"},    {false, "", "[100, 100, 100], radius: 5"},
        {false, "", "[720, 400, 2600], radius: 100"}, {false, ", view: observer", "[900, 0, 1000], radius: 5"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1000];
        struct planned made;
        snprintf(text, sizeof text,
                 "luxel: 1\n"
                 "screen: {width: 1000, height: 1000, resolution: [100, 100]}\n"
                 "observer: {z: 3000%s}\n"
                 "surfaces:\n"
                 "  - {type: sphere, center: [0, 0, 1000], radius: 300, material: {shininess: 20}}\n"
                 "  - {type: sphere, center: %s}\n"
                 "lights: [{type: point, position: [900, 500, 3000], intensity: 5}]\n",
                 cases[i].observer, cases[i].another);
        plan_text(text, &made);
        assert_int_equal(made.plan.alone == made.plan.surfaces, cases[i].is_alone);
        assert_true(cases[i].is_alone || !made.plan.alone);
        assert_int_equal(made.plan.at_once, cases[i].is_alone);
        clear(&made);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_float32_cannot_do), cmocka_unit_test(what_does_not_matter),
        cmocka_unit_test(shares_of_the_maximum),  cmocka_unit_test(rounding_of_facets),
        cmocka_unit_test(the_quickest_ways),      cmocka_unit_test(beside_the_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

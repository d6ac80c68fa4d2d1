/* SPDX-License-Identifier: MIT */
/* Pictures that are shaded by panels: against those in float64, with the same bytes for all threads and at a probe. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/polynomial/smooth.h"
#include "scenes.h"

static const char *const scenes[] = {
    /* lights all around: some set, some are behind, one is a spot, one shines from just above */
    "luxel: 1\n"
    "screen: {width: 620, height: 540, resolution: [930, 810]}\n"
    "observer: {z: 3000, view: observer}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [0, 0, 1000], radius: 300,\n"
    "     material: {diffuse: 0.6, specular: 0.4, shininess: 20, ambient: 0.1}}\n"
    "lights:\n"
    "  - {type: ambient, irradiance: 0.1}\n"
    "  - {type: point, position: [900, 300, 1700], intensity: 2}\n"
    "  - {type: point, position: [-700, 600, 1200], intensity: 1, attenuation: practical, k: 0.3}\n"
    "  - {type: point, position: [-100, -200, 1290], intensity: 0.02}\n"
    "  - {type: distant, direction: [1, -0.5, -0.2], irradiance: 0.7}\n"
    "  - {type: spot, position: [0, -600, 2500], aim: [0, 0, 1000], intensity: 3, inner: 5, outer: 9}\n"
    "  - {type: point, position: [300, 300, 100], intensity: 1}\n",
    /* one light, whose highlight's tail is all that the dark side shows */
    "luxel: 1\n"
    "screen: {width: 640, height: 640, resolution: [1100, 1100]}\n"
    "observer: {z: 3000}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [20, -10, 1000], radius: 290,\n"
    "     material: {diffuse: 0.6, specular: 0.4, shininess: 30}}\n"
    "lights: [{type: point, position: [900, 300, 1400], intensity: 2}]\n",
    /* a plate below lamps with patterns */
    "luxel: 1\n"
    "screen: {width: 500, height: 300, resolution: [1000, 600]}\n"
    "observer: {z: 3000}\n"
    "surfaces:\n"
    "  - {type: rectangle, center: [0, 0, 500], size: [520, 280], axis: [0.2, 0.1, 1],\n"
    "     material: {diffuse: 0.8, specular: 0.2, shininess: 12.5, model: phong}}\n"
    "lights:\n"
    "  - {type: point, position: [100, 50, 900], intensity: 1, pattern: cosine, exponent: 1.5}\n"
    "  - {type: point, position: [-300, -50, 700], intensity: 1}\n",
    /* a sphere from near by: lines of sight go apart, and its limb is a circle before its middle */
    "luxel: 1\n"
    "screen: {width: 3600, height: 3600, resolution: [1200, 1200], sampling: nodes}\n"
    "observer: {z: 2000, projection: perspective}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [60, -40, 1000], radius: 700,\n"
    "     material: {diffuse: 0.6, specular: 0.4, shininess: 30, ambient: 0.01}}\n"
    "lights:\n"
    "  - {type: ambient, irradiance: 0.01}\n"
    "  - {type: point, position: [900, 300, 2400], intensity: 2}\n"
    "  - {type: point, position: [-900, 300, 1100], intensity: 2}\n",
    /* a plate that runs away from the observer */
    "luxel: 1\n"
    "screen: {width: 900, height: 600, resolution: [1500, 1000]}\n"
    "observer: {z: 1000, projection: perspective}\n"
    "surfaces:\n"
    "  - {type: rectangle, center: [0, -200, -300], size: [900, 1700], axis: [0, 2, 1],\n"
    "     material: {diffuse: 0.6, specular: 0.4, shininess: 9}}\n"
    "lights:\n"
    "  - {type: point, position: [200, 300, 100], intensity: 2}\n"
    "  - {type: distant, direction: [0.3, 0.8, -0.7], irradiance: 1}\n",
    /* lamps of every shape, some of which set, one that shines away, and a point */
    "luxel: 1\n"
    "screen: {width: 620, height: 540, resolution: [930, 810]}\n"
    "observer: {z: 3000}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [0, 0, 1000], radius: 300,\n"
    "     material: {model: lambert, diffuse: 0.6, ambient: 0.1}}\n"
    "lights:\n"
    "  - {type: ambient, irradiance: 0.1}\n"
    "  - {type: planar, radiance: 10, rectangle: {center: [900, 300, 1900], size: [300, 200], aim: [0, 0, 1000]}}\n"
    "  - {type: planar, radiance: 10, rectangle: {center: [0, 0, 2900], size: [300, 200], axis: [0, 0, 1]}}\n"
    "  - {type: planar, radiance: 8, disk: {center: [-500, 600, 1900], radius: 100, aim: [0, 0, 1000]}}\n"
    "  - {type: volume, radiance: 5, box: {center: [-900, -200, 1700], size: [200, 300, 100]}}\n"
    "  - {type: volume, radiance: 5, sphere: {center: [-200, -900, 1500], radius: 90}}\n"
    "  - {type: volume, radiance: 2, cylinder: {center: [600, -900, 1800], radius: 40, height: 300, axis: [1, 1, 0]}}\n"
    "  - {type: point, position: [900, 300, 1700], intensity: 2}\n",
    /* a plate before a window, from near by */
    "luxel: 1\n"
    "screen: {width: 900, height: 600, resolution: [1500, 1000]}\n"
    "observer: {z: 1000, projection: perspective}\n"
    "surfaces:\n"
    "  - {type: rectangle, center: [0, -200, -300], size: [900, 1700], axis: [0, 2, 1],\n"
    "     material: {model: lambert, diffuse: 0.6}}\n"
    "lights:\n"
    "  - {type: planar, radiance: 3,\n"
    "     vertices: [[-200, 900, -300], [300, 900, -300], [250, 900, 200], [-250, 900, 100]]}\n",
    /* so many parts of a lamp that their constants are not kept, which set where a point and another lamp do not */
    "luxel: 1\n"
    "screen: {width: 160, height: 160, resolution: [260, 260]}\n"
    "observer: {z: 3000}\n"
    "surfaces: [{type: sphere, center: [160, 0, 1000], radius: 310, material: {shininess: 20}}]\n"
    "lights:\n"
    "  - {type: point, position: [-900, 300, 1700], intensity: 2}\n"
    "  - {type: planar, radiance: 10, rectangle: {center: [900, 300, 1900], size: [300, 200], aim: [0, 0, 1000]},\n"
    "     parts: 72}\n"
    "  - {type: planar, radiance: 3, rectangle: {center: [-900, 0, 1900], size: [300, 200], aim: [0, 0, 1000]},\n"
    "     parts: 30}\n",
    /* by the textbook's laws: flat and round lamps, one near by */
    "luxel: 1\n"
    "screen: {width: 620, height: 540, resolution: [930, 810]}\n"
    "observer: {z: 3000}\n"
    "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 300, material: {model: lambert}}]\n"
    "lights:\n"
    "  - {type: planar, radiance: 10, rectangle: {center: [900, 300, 1900], size: [300, 200], aim: [0, 0, 1000]},\n"
    "     attenuation: practical, k: 300}\n"
    "  - {type: planar, radiance: 3, disk: {center: [-300, 200, 1500], radius: 100, aim: [0, 0, 1000]},\n"
    "     attenuation: none}\n"
    "  - {type: volume, radiance: 4, sphere: {center: [-600, -700, 1700], radius: 150}, attenuation: polynomial,\n"
    "     coefficients: [0.2, 1, 0.6]}\n"
    "  - {type: volume, radiance: 9, cylinder: {center: [300, -900, 1700], radius: 20, height: 900, axis: [1, 0, "
    "0.2]},\n"
    "     attenuation: polynomial, coefficients: [0, 1, 0]}\n",
    /* balls over a floor, which throw shadows on it and each other, hide each other, and are hidden from some lights */
    "luxel: 1\n"
    "screen: {width: 900, height: 700, resolution: [900, 700]}\n"
    "observer: {z: 3000, view: observer}\n"
    "shadows: points\n"
    "surfaces:\n"
    "  - {type: sphere, center: [-120, 0, 1000], radius: 230, material: {diffuse: 0.6, specular: 0.4, shininess: 20}}\n"
    "  - {type: sphere, center: [200, 40, 1250], radius: 90, material: {diffuse: 0.8, specular: 0.2, shininess: 9}}\n"
    "  - {type: sphere, center: [2000, 0, 900], radius: 5}\n"
    "  - {type: rectangle, center: [0, -60, 700], size: [850, 900], axis: [0, 1, 1],\n"
    "     material: {model: phong, diffuse: 0.7, specular: 0.2, shininess: 12}}\n"
    "lights:\n"
    "  - {type: ambient, irradiance: 0.1}\n"
    "  - {type: point, position: [900, 500, 2000], intensity: 2}\n"
    "  - {type: point, position: [-900, 700, 1900], intensity: 1}\n"
    "  - {type: distant, direction: [0.3, -1, -1], irradiance: 0.7}\n"
    "  - {type: point, position: [100, 900, 2500], intensity: 2}\n"
    "  - {type: planar, radiance: 2, rectangle: {center: [0, 900, 2400], size: [300, 200], aim: [0, 0, 900]},\n"
    "     parts: 4}\n",
    /* a ball before a wall and beside a smaller one, from near by */
    "luxel: 1\n"
    "screen: {width: 2400, height: 2400, resolution: [800, 800], sampling: nodes}\n"
    "observer: {z: 2000, projection: perspective}\n"
    "shadows: points\n"
    "surfaces:\n"
    "  - {type: rectangle, center: [0, 0, -400], size: [4000, 3500], axis: [0.1, 0, 1], material: {model: lambert}}\n"
    "  - {type: sphere, center: [60, -40, 700], radius: 400, material: {diffuse: 0.6, specular: 0.4, shininess: 30}}\n"
    "  - {type: sphere, center: [-500, 300, 900], radius: 80, material: {diffuse: 0.6, specular: 0.4, shininess: 30}}\n"
    "lights:\n"
    "  - {type: ambient, irradiance: 0.1}\n"
    "  - {type: point, position: [900, 300, 2400], intensity: 2}\n"
    "  - {type: point, position: [-1900, 600, 1100], intensity: 2}\n"
    "  - {type: point, position: [-700, -900, 1300], intensity: 1}\n"
    "  - {type: distant, direction: [-0.5, 0.2, -1], irradiance: 0.3}\n",
    /* flat lamps with highlights, one near by, and a point */
    "luxel: 1\n"
    "screen: {width: 620, height: 540, resolution: [930, 810]}\n"
    "observer: {z: 3000, view: observer}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [0, 0, 1000], radius: 300, material: {shininess: 40, highlight: cosine}}\n"
    "lights:\n"
    "  - {type: planar, radiance: 10, rectangle: {center: [900, 300, 1900], size: [300, 200], aim: [0, 0, 1000]}}\n"
    "  - {type: planar, radiance: 8, disk: {center: [-500, 600, 1900], radius: 100, aim: [0, 0, 1000]}}\n"
    "  - {type: planar, radiance: 2, rectangle: {center: [60, -250, 1270], size: [60, 40], aim: [0, 0, 1000]}}\n"
    "  - {type: volume, radiance: 5, box: {center: [-900, -200, 1700], size: [200, 300, 100]}}\n"
    "  - {type: point, position: [900, 300, 1700], intensity: 2}\n",
    /* a small lamp, whose highlight is a few pixels wide */
    "luxel: 1\n"
    "screen: {width: 620, height: 540, resolution: [930, 810]}\n"
    "observer: {z: 3000}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [0, 0, 1000], radius: 300, material: {shininess: 5000}}\n"
    "lights: [{type: planar, radiance: 10, disk: {center: [600, 300, 1900], radius: 10, aim: [0, 0, 1000]}}]\n",
    /* a shiny plate before a window, from near by */
    "luxel: 1\n"
    "screen: {width: 900, height: 600, resolution: [1500, 1000]}\n"
    "observer: {z: 1000, projection: perspective}\n"
    "surfaces:\n"
    "  - {type: rectangle, center: [0, -200, -300], size: [900, 1700], axis: [0, 2, 1],\n"
    "     material: {model: phong, shininess: 7.5}}\n"
    "lights:\n"
    "  - {type: planar, radiance: 3,\n"
    "     vertices: [[-200, 900, -300], [300, 900, -300], [250, 900, 200], [-250, 900, 100]]}\n",
    /* a shiny sphere under lamps by the textbook's laws */
    "luxel: 1\n"
    "screen: {width: 620, height: 540, resolution: [930, 810]}\n"
    "observer: {z: 3000}\n"
    "surfaces: [{type: sphere, center: [0, 0, 1000], radius: 300, material: {shininess: 30}}]\n"
    "lights:\n"
    "  - {type: planar, radiance: 10, rectangle: {center: [900, 300, 1900], size: [300, 200], aim: [0, 0, 1000]},\n"
    "     attenuation: practical, k: 300}\n"
    "  - {type: volume, radiance: 4, sphere: {center: [-600, 700, 1700], radius: 150}, attenuation: none}\n"
    "  - {type: volume, radiance: 9, cylinder: {center: [-600, 0, 1700], radius: 20, height: 900, axis: [0, 1, 0.2]},\n"
    "     attenuation: polynomial, coefficients: [0.2, 1, 0.6]}\n",
    /* a shiny ball beside a smaller one and before a plate that is not, under a lamp and a tube */
    "luxel: 1\n"
    "screen: {width: 800, height: 600, resolution: [600, 450]}\n"
    "observer: {z: 3000, view: observer}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [-60, 0, 1000], radius: 220, material: {shininess: 90, highlight: gated}}\n"
    "  - {type: sphere, center: [180, 90, 1200], radius: 60, material: {shininess: 30}}\n"
    "  - {type: rectangle, center: [0, -250, 900], size: [700, 400], axis: [0, 2, 1], material: {model: lambert}}\n"
    "lights:\n"
    "  - {type: planar, radiance: 10, rectangle: {center: [500, 500, 1900], size: [300, 200], aim: [0, 0, 1000]}}\n"
    "  - {type: volume, radiance: 9, cylinder: {center: [-400, 500, 1600], radius: 15, height: 700, axis: [1, 0, 0]}}\n"
    "  - {type: point, position: [900, 300, 1700], intensity: 1}\n",
    /* a shiny part of a sphere under a ball, a tube, and the end of a cylinder that looks at it */
    "luxel: 1\n"
    "screen: {width: 160, height: 160, resolution: [260, 260]}\n"
    "observer: {z: 3000}\n"
    "surfaces: [{type: sphere, center: [160, 0, 1000], radius: 310, material: {shininess: 30}}]\n"
    "lights:\n"
    "  - {type: volume, radiance: 5, sphere: {center: [200, 900, 1900], radius: 150}}\n"
    "  - {type: volume, radiance: 9, cylinder: {center: [-600, 0, 1700], radius: 20, height: 900, axis: [0, 1, 0.2]}}\n"
    "  - {type: volume, radiance: 2, cylinder: {center: [0, 0, 2900], radius: 60, height: 300, axis: [0, 0, 1]}}\n",
};

/* From this scene on there are highlights of extended sources, exact to the tolerance. */
enum { FIRST_GLOSSY = 11 };

static double share_of(size_t scene)
{
    return scene < FIRST_GLOSSY ? 2e-6 : 1e-3;
}

static luxel_scene *open_scene(size_t i)
{
    luxel_scene *scene = NULL;
    assert_int_equal(load(scenes[i], NULL, &scene), LUXEL_OK);
    return scene;
}

/* In float64 integrals are taken to the tolerance. */
static luxel_field *render_to(const luxel_scene *scene, luxel_quantity quantity, luxel_precision precision,
                              double tolerance, unsigned threads, const char *instruction_set)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.quantity = quantity;
    settings.precision = precision;
    settings.tolerance = tolerance;
    settings.threads = threads;
    settings.instruction_set = instruction_set;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

static luxel_field *render_as(const luxel_scene *scene, luxel_quantity quantity, luxel_precision precision,
                              unsigned threads, const char *instruction_set)
{
    return render_to(scene, quantity, precision, precision == LUXEL_DOUBLE ? 1e-5 : 0, threads, instruction_set);
}

static luxel_field *render(const luxel_scene *scene, luxel_precision precision, unsigned threads,
                           const char *instruction_set)
{
    return render_as(scene, LUXEL_BRIGHTNESS, precision, threads, instruction_set);
}

/* Off by no more than a share of the maximum. */
static void check_within(const luxel_field *picture, const luxel_field *exact, double share)
{
    const size_t count = (size_t)luxel_field_columns(picture) * luxel_field_rows(picture);
    const double maximum = luxel_field_statistics(exact)->maximum.value;
    const float *values = luxel_field_single(picture);
    assert_memory_equal(luxel_field_mask(picture), luxel_field_mask(exact), count);
    for (size_t i = 0; i < count; i++)
        assert_true(values[i] >= 0 && fabs((double)values[i] - luxel_field_double(exact)[i]) <= share * maximum);
}

static void check_values(const luxel_field *picture, const luxel_field *exact)
{
    check_within(picture, exact, 2e-6);
}

static void check_picture(const luxel_field *picture, const luxel_field *exact, double share)
{
    const luxel_statistics *statistics = luxel_field_statistics(picture), *exactly = luxel_field_statistics(exact);
    const double maximum = exactly->maximum.value, least = exactly->minimum.value;
    check_within(picture, exact, share);
    assert_true(fabs(statistics->maximum.value - maximum) <= share * maximum);
    assert_true(fabs(statistics->minimum.value - least) <= 1e-3 * least + (share > 2e-6 ? share * maximum : 0));
    assert_true(fabs(statistics->mean - exactly->mean) <= share / 2 * exactly->mean);
    assert_int_equal(statistics->surface_pixels, exactly->surface_pixels);
}

/* A quick look sums the lights at each of its pixels; a share of those of the whole picture must not be the same. */
static void check_that_panels_took_part(const luxel_scene *scene, const luxel_field *picture)
{
    enum { STRIDE = 2, FIRST = STRIDE / 2 };
    luxel_settings settings;
    luxel_field *quick = NULL;
    size_t others = 0, all = 0;
    luxel_settings_init(&settings);
    settings.precision = LUXEL_SINGLE;
    settings.stride = STRIDE;
    assert_int_equal(luxel_render(scene, &settings, NULL, &quick), LUXEL_OK);
    for (unsigned row = 0; row < luxel_field_rows(quick); row++)
        for (unsigned column = 0; column < luxel_field_columns(quick); column++, all++)
            others += luxel_field_value(quick, column, row) !=
                      luxel_field_value(picture, FIRST + STRIDE * column, FIRST + STRIDE * row);
    assert_true(others > all / 50);
    luxel_field_free(quick);
}

static void test_pictures(void **state)
{
    (void)state;
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++) {
        luxel_scene *scene = open_scene(s);
        luxel_field *exact = render_to(scene, LUXEL_BRIGHTNESS, LUXEL_DOUBLE, fmax(share_of(s) / 10, 1e-5), 0, NULL);
        for (size_t k = 0; luxel_instruction_set_name(k); k++) {
            if (!luxel_instruction_set_runs(k))
                continue;
            luxel_field *picture = render(scene, LUXEL_SINGLE, 0, luxel_instruction_set_name(k));
            check_picture(picture, exact, share_of(s));
            if (k == 0)
                check_that_panels_took_part(scene, picture);
            luxel_field_free(picture);
        }
        luxel_field_free(exact);
        luxel_scene_free(scene);
    }
}

static void check_irradiance(const luxel_scene *scene)
{
    luxel_field *exact = render_as(scene, LUXEL_IRRADIANCE, LUXEL_DOUBLE, 0, NULL);
    luxel_field *picture = render_as(scene, LUXEL_IRRADIANCE, LUXEL_SINGLE, 0, NULL);
    check_values(picture, exact);
    luxel_field_free(exact);
    luxel_field_free(picture);
}

static void test_irradiance(void **state)
{
    (void)state;
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++) {
        luxel_scene *scene = open_scene(s);
        check_irradiance(scene);
        luxel_scene_free(scene);
    }
}

/* Pictures that are as large, but of two surfaces, or under an extended source with a highlight. */
static void test_other_pictures(void **state)
{
    (void)state;
    static const struct {
        const char *list, *element; /* to be inserted */
    } changes[] = {
        {"surfaces", "{type: sphere, center: [50, 50, 1500], radius: 60}"},
        {"lights", "{type: planar, rectangle: {center: [0, 0, 2000], size: [300, 300]}, radiance: 3}"},
    };
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        luxel_scene *scene = open_scene(1);
        assert_int_equal(luxel_scene_insert(scene, changes[i].list, 1, changes[i].element, NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        check_irradiance(scene);
        luxel_field *exact = render(scene, LUXEL_DOUBLE, 0, NULL), *picture = render(scene, LUXEL_SINGLE, 0, NULL);
        check_within(picture, exact, i == 0 ? 2e-6 : 1e-3);
        luxel_field_free(exact);
        luxel_field_free(picture);
        luxel_scene_free(scene);
    }
}

/* What is beyond float32 is an error, no number. */
static void test_too_bright(void **state)
{
    (void)state;
    luxel_settings settings;
    luxel_scene *scene;
    luxel_field *field = NULL;
    assert_int_equal(load("luxel: 1\n"
                          "screen: {width: 0.5, height: 0.5, resolution: [256, 256]}\n"
                          "observer: {z: 2}\n"
                          "surfaces: [{type: sphere, center: [0, 0, 0], radius: 1, material: {model: lambert}}]\n"
                          "lights: [{type: point, position: [0, 0, 2], intensity: 1e50}]\n",
                          NULL, &scene),
                     LUXEL_OK);
    luxel_settings_init(&settings);
    settings.precision = LUXEL_SINGLE;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_ERROR_RANGE);
    assert_null(field);
    luxel_scene_free(scene);
}

/* The foot of a highlight, which is all that there is, keeps digits of its own however faint it is. */
static void test_faint_foot(void **state)
{
    (void)state;
    luxel_scene *scene = open_scene(1);
    assert_int_equal(luxel_scene_set(scene, "surfaces[0].material.diffuse=0", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_field *exact = render(scene, LUXEL_DOUBLE, 0, NULL), *picture = render(scene, LUXEL_SINGLE, 0, NULL);
    const size_t count = (size_t)luxel_field_columns(picture) * luxel_field_rows(picture);
    const double maximum = luxel_field_statistics(exact)->maximum.value;
    size_t faint = 0;
    for (size_t i = 0; i < count; i++) {
        const double value = luxel_field_double(exact)[i];
        faint += value > 1e-20 * maximum && value < 1e-7 * maximum;
        if (value > 1e-20 * maximum)
            assert_true(fabs((double)luxel_field_single(picture)[i] - value) <= 1e-3 * value);
    }
    assert_true(faint > count / 20);
    check_that_panels_took_part(scene, picture);
    luxel_field_free(exact);
    luxel_field_free(picture);
    luxel_scene_free(scene);
}

/* More lights set within a square than have polynomials of their own. */
static void test_many_folds(void **state)
{
    (void)state;
    enum { LIGHTS = 3 * LX_MOST_FOLDED };
    char text[500 + 80 * LIGHTS], *end = text;
    luxel_scene *scene;
    end += sprintf(end, "luxel: 1\n"
                        "screen: {width: 640, height: 640, resolution: [1100, 1100]}\n"
                        "observer: {z: 3000}\n"
                        "surfaces:\n"
                        "  - {type: sphere, center: [0, 0, 1000], radius: 310,\n"
                        "     material: {diffuse: 0.6, specular: 0.4, shininess: 9}}\n"
                        "lights:\n"
                        "  - {type: ambient, irradiance: 0.01}\n");
    for (int i = 0; i < LIGHTS; i++)
        end += sprintf(end, "  - {type: distant, direction: [1, %g, -0.3], irradiance: %d}\n", 0.002 * i, 1 + i % 3);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_field *exact = render(scene, LUXEL_DOUBLE, 0, NULL), *picture = render(scene, LUXEL_SINGLE, 0, NULL);
    check_picture(picture, exact, 2e-6);
    check_that_panels_took_part(scene, picture);
    luxel_field_free(exact);
    luxel_field_free(picture);
    luxel_scene_free(scene);
}

/* A probe's pixel is the picture's to the last bit; and so is the picture by any number of threads. */
static void test_same_bytes(void **state)
{
    (void)state;
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++) {
        luxel_scene *scene = open_scene(s);
        luxel_field *picture = render(scene, LUXEL_SINGLE, 1, NULL);
        const unsigned columns = luxel_field_columns(picture), rows = luxel_field_rows(picture);
        const size_t count = (size_t)columns * rows;
        luxel_field *other = render(scene, LUXEL_SINGLE, s % 2 == 0 ? 2 : 7, NULL);
        assert_memory_equal(luxel_field_single(picture), luxel_field_single(other), count * sizeof(float));
        assert_memory_equal(luxel_field_mask(picture), luxel_field_mask(other), count);
        assert_memory_equal(&luxel_field_statistics(picture)->mean, &luxel_field_statistics(other)->mean,
                            sizeof(double));
        luxel_field_free(other);
        const uint8_t *mask = luxel_field_mask(picture);
        for (size_t i = 64; i < count; i++) {
            bool is_near_rim = false; /* where what a panel shows begins within it, or in the one before */
            for (size_t off = 0; off <= 60 && i / columns % 9 == 0; off += 20)
                is_near_rim |= mask[i - off] && !mask[i - off - 1];
            if (i % (count / 60) != 11 && !is_near_rim)
                continue;
            luxel_probe *probe = NULL;
            const unsigned column = (unsigned)(i % columns), row = (unsigned)(i / columns);
            assert_int_equal(luxel_probe_screen(scene, NULL, luxel_field_x_mm(picture)[column],
                                                luxel_field_y_mm(picture)[row], NULL, &probe),
                             LUXEL_OK);
            if (probe->on_surface)
                assert_true(probe->has_pixel_value && probe->pixel_value == luxel_field_value(picture, column, row));
            luxel_probe_free(probe);
        }
        luxel_field_free(picture);
        luxel_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures),       cmocka_unit_test(test_irradiance), cmocka_unit_test(test_faint_foot),
        cmocka_unit_test(test_other_pictures), cmocka_unit_test(test_too_bright), cmocka_unit_test(test_many_folds),
        cmocka_unit_test(test_same_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

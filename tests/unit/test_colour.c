/* SPDX-License-Identifier: MIT */
/* Colour science against published values, and scenes in colour against what they are sums of. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <luxel/luxel.h>

#include "base/colour.h"
#include "base/observer_table.h"

/* ---- colour science ---- */

static void observer_has_its_sums(void **state)
{
    (void)state;
    static const double sums[3] = {106.8654694896, 106.8569171012, 106.8922512786};
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int i = 0; i < LX_WAVELENGTHS; i++)
            sum += observer_table[3 * i + k];
        assert_true(fabs(sum - sums[k]) < 1e-9);
    }
}

static void black_bodies_have_their_chromaticities(void **state)
{
    (void)state;
    static const double known[][3] = {
        {1000, .65275070, .34446166},  {1900, .53777728, .41120222}, {2700, .45985903, .41059904},
        {2856, .44753514, .40742829},  {3000, .43693105, .40407397}, {4000, .38043953, .37674682},
        {5000, .34510117, .35160804},  {6500, .31352588, .32362830}, {10000, .28063357, .28828784},
        {20000, .25645725, .25763088},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double xy[2];
        luxel_planck_xy(known[i][0], xy);
        assert_true(fabs(xy[0] - known[i][1]) < 6e-9 && fabs(xy[1] - known[i][2]) < 6e-9);
    }
}

static void black_bodies_have_their_channels(void **state)
{
    (void)state;
    static const double known[][4] = {
        {1900, 2.63934676, .61353014, -.00007774}, {2700, 1.93510007, .80355312, .19179632},
        {3000, 1.77093133, .84426137, .27207370},  {4000, 1.41399829, .92400603, .53341741},
        {5000, 1.21351660, .96050536, .76234828},  {6500, 1.04338344, .98357063, 1.03497265},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double xy[2], rgb[3];
        luxel_planck_xy(known[i][0], xy);
        luxel_xy_to_rgb(xy, rgb);
        for (int c = 0; c < 3; c++)
            assert_true(fabs(rgb[c] - known[i][c + 1]) < 2e-8);
        assert_true(fabs(luxel_rgb_luminance(rgb) - 1) < 1e-14);
    }
}

static luxel_chromaticity seen_of(double x, double y)
{
    double rgb[3];
    luxel_chromaticity seen;
    luxel_xy_to_rgb((const double[]){x, y}, rgb);
    luxel_find_chromaticity(rgb, &seen);
    assert_true(seen.has_xy && fabs(seen.xy[0] - x) < 1e-13 && fabs(seen.xy[1] - y) < 1e-13);
    return seen;
}

/* A, D65 and E: what a search by golden section finds, to a hundredth of a kelvin; and black bodies find themselves. */
static void nearest_black_body_is_found(void **state)
{
    (void)state;
    static const double known[][4] = {{.44757355, .40743939, 2855.4958, 0},
                                      {.31272, .32903, 6502.9287, .00321},
                                      {1 / 3.0, 1 / 3.0, 5455.3983, -.00442}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const luxel_chromaticity seen = seen_of(known[i][0], known[i][1]);
        assert_true(seen.has_cct && fabs(seen.cct_k - known[i][2]) < 0.001 && fabs(seen.duv - known[i][3]) < 2e-5);
    }
    static const double kelvins[] = {1000, 1900, 2700, 4321, 6500, 12000, 25000};
    for (size_t i = 0; i < sizeof kelvins / sizeof *kelvins; i++) {
        double xy[2];
        luxel_planck_xy(kelvins[i], xy);
        const luxel_chromaticity seen = seen_of(xy[0], xy[1]);
        assert_true(seen.has_cct && fabs(seen.cct_k - kelvins[i]) < 1e-5 * kelvins[i] && fabs(seen.duv) < 1e-10);
    }
    assert_false(seen_of(.3, .6).has_cct); /* sRGB's green is far from all of them */
    luxel_chromaticity dark;
    luxel_find_chromaticity((const double[]){0, 0, 0}, &dark);
    assert_false(dark.has_xy || dark.has_cct);
}

static void light_lies_within_the_locus(void **state)
{
    (void)state;
    static const double inside[][2] = {{.3127, .3290}, {.64, .33}, {.30, .60}, {.15, .06}, {.08, .83}, {.18, .02}};
    static const double outside[][2] = {{.8, .1}, {.3, .75}, {.01, .2}, {.4, .05}, {.7, .35}, {0, 0}};
    for (size_t i = 0; i < sizeof inside / sizeof *inside; i++)
        assert_true(lx_is_light(inside[i]));
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++)
        assert_false(lx_is_light(outside[i]));
}

static void curve_is_that_of_srgb(void **state)
{
    (void)state;
    assert_true(luxel_srgb_curve(0) == 0 && luxel_srgb_curve(1) == 1 &&
                fabs(luxel_srgb_curve(0.001) - 0.01292) < 1e-17);
    assert_true(fabs(luxel_srgb_curve(0.5) - 0.7353569830524495) < 1e-15);
}

/* ---- scenes ---- */

#define HEAD "luxel: 1\nscreen: {width: 200, height: 200, resolution: [40, 40]}\nobserver: {z: 1000}\n"
#define BALL "surfaces: [{type: sphere, center: [0, 0, 0], radius: 90, material: {MATERIAL}}]\n"

/* A committed scene of a text in which MATERIAL stands for a material. */
static luxel_scene *scene_with(const char *text, const char *material)
{
    char whole[4096];
    const char *at = strstr(text, "MATERIAL");
    snprintf(whole, sizeof whole, "%.*s%s%s", (int)(at - text), text, material, at + strlen("MATERIAL"));
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_text(whole, strlen(whole), NULL, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_probe *probe_of(const luxel_scene *scene, double x_mm, double y_mm)
{
    luxel_probe *probe = NULL;
    assert_int_equal(luxel_probe_screen(scene, NULL, x_mm, y_mm, NULL, &probe), LUXEL_OK);
    assert_true(probe->has_value);
    return probe;
}

static luxel_field *render(const luxel_scene *scene)
{
    luxel_field *field = NULL;
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    return field;
}

/* A scene all grey has today's values three times, to the last bit, and no error more. */
static void grey_stays_grey(void **state)
{
    (void)state;
    static const char lamps[] = "lights: [{type: point, position: [300, 200, 400], intensity: 2},"
                                " {type: point, position: [-300, 200, 400], intensity: 1}]\n";
    char grey[2048], rgb[2048];
    snprintf(grey, sizeof grey, HEAD BALL "%s", lamps);
    snprintf(rgb, sizeof rgb, HEAD "channels: rgb\n" BALL "%s", lamps);
    luxel_scene *scenes[2] = {scene_with(grey, "shininess: 30"), scene_with(rgb, "shininess: 30")};
    luxel_field *fields[2] = {render(scenes[0]), render(scenes[1])};
    luxel_probe *probes[2] = {probe_of(scenes[0], 20, 10), probe_of(scenes[1], 20, 10)};
    assert_int_equal(luxel_field_channels(fields[0]), 1);
    assert_int_equal(luxel_field_channels(fields[1]), 3);
    assert_null(luxel_field_rgb_single(fields[0]));
    assert_memory_equal(luxel_field_single(fields[0]), luxel_field_single(fields[1]), 1600 * sizeof(float));
    for (size_t i = 0; i < 4800; i++)
        assert_true(luxel_field_rgb_single(fields[1])[i] == luxel_field_single(fields[0])[i / 3]);
    assert_false(probes[0]->color.exists);
    assert_true(probes[1]->color.exists && probes[0]->value == probes[1]->value &&
                probes[0]->error == probes[1]->error);
    for (int c = 0; c < 3; c++)
        assert_true(probes[1]->color.rgb[c] == probes[0]->value);
    for (int i = 0; i < 2; i++) {
        luxel_probe_free(probes[i]);
        luxel_field_free(fields[i]);
        luxel_scene_free(scenes[i]);
    }
}

/* Two lamps mix linearly: the channels are those of each, by what it gives, within the bound; and the picture's pixel
 * is that of the probe. */
static void lamps_mix(void **state)
{
    (void)state;
    luxel_scene *scene =
        scene_with(HEAD "channels: rgb\n" BALL "lights: [{type: point, position: [300, 200, 400], intensity: 2,"
                        " color: {temperature: 2700}},"
                        " {type: point, position: [-300, 200, 400], intensity: 1,"
                        " color: {temperature: 6500}}]\n",
                   "shininess: 30");
    luxel_probe *probe = probe_of(scene, 22.5, 12.5);
    luxel_field *field = render(scene);
    double rgb[2][3];
    assert_int_equal(luxel_scene_light_rgb(scene, 0, rgb[0]), LUXEL_OK);
    assert_int_equal(luxel_scene_light_rgb(scene, 1, rgb[1]), LUXEL_OK);
    assert_true(fabs(rgb[0][0] - 1.93510007) < 2e-8 && fabs(rgb[1][2] - 1.03497265) < 2e-8);
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (size_t s = 0; s < 2; s++)
            sum += rgb[s][c] * (probe->shares[s].diffuse + probe->shares[s].specular);
        assert_true(fabs(probe->color.rgb[c] - sum) <= probe->color.error[c] + 1e-15 * sum);
        assert_true(probe->color.error[c] < 1e-12 * sum);
        const size_t pixel = (size_t)probe->row * 40 + probe->column;
        assert_true(fabs((double)luxel_field_rgb_single(field)[3 * pixel + (size_t)c] - sum) < 1e-5 * sum);
    }
    assert_true(fabs(luxel_rgb_luminance(probe->color.rgb) - probe->value) < 1e-13 * probe->value);
    luxel_probe_free(probe);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* A red material: each channel is that of the grey scene with the reflectance of the channel, and the value their
 * luminance; pictures, evaluators and probes agree. */
static void materials_color(void **state)
{
    (void)state;
    static const char lamps[] = "lights: [{type: point, position: [300, 200, 400], intensity: 2, "
                                "color: {temperature: 3000}}, {type: ambient, irradiance: 0.5}]\n";
    static const double color[3] = {1, .25, .5};
    char text[2048], grey[2048];
    snprintf(text, sizeof text, HEAD "channels: rgb\n" BALL "%s", lamps);
    snprintf(grey, sizeof grey, HEAD BALL "%s", lamps);
    luxel_scene *scene =
        scene_with(text, "diffuse: 0.8, specular: 0.3, color: [1, .25, .5], specular_color: [.5, 1, 1]");
    luxel_probe *probe = probe_of(scene, 22.5, 12.5);
    luxel_field *field = render(scene);
    luxel_evaluator *evaluator = NULL;
    double lamp[3], luminance = 0, shares[2];
    static const double weights[3] = {.2126390058715, .7151686787678, .0721923153607};
    luxel_scene_light_rgb(scene, 0, lamp);
    for (int c = 0; c < 3; c++) {
        char material[96];
        snprintf(material, sizeof material, "diffuse: %.17g, specular: %.17g", 0.8 * color[c], c == 0 ? 0.15 : 0.3);
        luxel_scene *alone = scene_with(grey, material);
        luxel_probe *of_channel = probe_of(alone, 22.5, 12.5);
        double sum = 0;
        for (size_t s = 0; s < 2; s++)
            sum += (s == 0 ? lamp[c] : 1) * (of_channel->shares[s].diffuse + of_channel->shares[s].specular);
        assert_true(fabs(probe->color.rgb[c] - sum) <= probe->color.error[c] + 1e-15 * sum);
        const size_t pixel = (size_t)probe->row * 40 + probe->column;
        assert_true(fabs((double)luxel_field_rgb_single(field)[3 * pixel + (size_t)c] - sum) < 1e-5 * sum);
        luminance += weights[c] * sum;
        luxel_probe_free(of_channel);
        luxel_scene_free(alone);
    }
    assert_true(fabs(probe->value - luminance) <= probe->error + 1e-12 * luminance);
    assert_true(fabs(luxel_field_value(field, probe->column, probe->row) - luminance) < 1e-5 * luminance);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_value value;
    luxel_evaluate_screen(evaluator, 22.5, 12.5, &value, shares);
    assert_true(value.has_value && fabs(value.value - probe->value) <= value.error + probe->error);
    assert_true(fabs(shares[0] + shares[1] - value.value) < 1e-13 * value.value);
    assert_true(fabs(probe->shares[0].diffuse + probe->shares[0].specular + probe->shares[1].diffuse - probe->value) <
                1e-13 * probe->value);
    luxel_evaluator_free(evaluator);
    luxel_probe_free(probe);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* The furnace: in a closed sphere with a lamp in the middle the reflected irradiance is direct rho / (1 - rho), in each
 * channel by its own rho. */
static void furnace_has_channels(void **state)
{
    (void)state;
    static const double color[3] = {.9, .5, .25};
    luxel_scene *scene =
        scene_with("luxel: 1\nchannels: rgb\nreflections: all\nscreen: {width: 200, height: 200, resolution: [4, 4]}\n"
                   "observer: {z: 5000}\n"
                   "surfaces: [{type: sphere, center: [0, 0, 0], radius: 1000, inside: true, material: {MATERIAL}}]\n"
                   "lights: [{type: point, position: [0, 0, 0], intensity: 10}]\n",
                   "model: lambert, diffuse: .8, color: [.9, .5, .25], over_pi: true");
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    luxel_probe *probe = NULL;
    const double place[3] = {0, 600, 800}, normal[3] = {0, -.6, -.8};
    assert_int_equal(luxel_probe_element(scene, &settings, place, normal, NULL, &probe), LUXEL_OK);
    assert_true(probe->color.exists);
    for (int c = 0; c < 3; c++) {
        const double rho = .8 * color[c], truth = 10 / (1 - rho);
        assert_true(fabs(probe->color.rgb[c] - truth) <= probe->color.error[c]);
        assert_true(probe->color.error[c] < 1e-2 * truth);
    }
    luxel_probe_free(probe);
    luxel_scene_free(scene);
}

/* The blue of 1900 K lies outside of sRGB: it is kept in the numbers, and counted where levels clip it. */
static void negative_blue_is_kept(void **state)
{
    (void)state;
    luxel_scene *scene =
        scene_with(HEAD "channels: rgb\n" BALL "lights: [{type: distant, direction: [0, 0, -1], irradiance: 1,"
                        " color: {temperature: 1900}}]\n",
                   "model: lambert");
    luxel_field *field = render(scene);
    uint8_t levels[4800];
    size_t below = 0;
    for (size_t i = 0; i < 1600; i++)
        below += luxel_field_rgb_single(field)[3 * i + 2] < 0;
    assert_true(below > 1000);
    assert_int_equal(luxel_field_srgb(field, levels), below);
    double rgb[3];
    luxel_scene_light_rgb(scene, 0, rgb);
    const float *middle = luxel_field_rgb_single(field) + 3 * (20 * 40 + 20);
    assert_true(fabs((double)middle[2] / luxel_field_value(field, 20, 20) - rgb[2]) < 1e-6 * fabs(rgb[2]) + 1e-11);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* What is no colour is refused, where it stands. */
static void bad_colors_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *color, *id;
    } bad[] = {{"{xy: [.8, .1]}", "color-no-light"},     {"{xy: [.3, 0]}", "color-dark"},
               {"{rgb: [0, 0, 0]}", "color-dark"},       {"{rgb: [-1, 0, 1]}", "color-dark"},
               {"{rgb: [-1, 1, 0]}", "color-no-light"},  {"{temperature: 900}", "out-of-range"},
               {"{temperature: 26000}", "out-of-range"}, {"{}", "missing-key"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 HEAD "surfaces: []\nlights: [{type: distant, direction: [0, 0, -1], irradiance: 1, color: %s}]\n",
                 bad[i].color);
        luxel_scene *scene = NULL;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_scene_read_text(text, strlen(text), NULL, NULL, &scene), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, diagnostics), LUXEL_ERROR_SCENE);
        assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, bad[i].id);
        assert_non_null(strstr(luxel_diagnostics_get(diagnostics, 0)->key, "lights[0].color"));
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
}

/* The table of black bodies has the temperatures that the search finds, and none where that finds none. */
static void many_colors_have_temperatures(void **state)
{
    (void)state;
    struct lx_black_bodies *bodies = lx_black_bodies_new();
    uint32_t seed = 7;
    size_t with = 0, without = 0;
    assert_non_null(bodies);
    for (int i = 0; i < 400; i++) {
        double place[3], xy[2], rgb[3];
        luxel_chromaticity seen;
        for (int k = 0; k < 3; k++) {
            seed = seed * 1664525 + 1013904223;
            place[k] = seed / 4294967296.0;
        }
        luxel_planck_xy(1e6 / (38 + 970 * place[0] * place[0]), xy);
        xy[0] += 0.08 * (place[1] - 0.5);
        xy[1] += 0.12 * (place[2] - 0.5);
        luxel_xy_to_rgb(xy, rgb);
        luxel_find_chromaticity(rgb, &seen);
        const double kelvin = lx_black_body_near(bodies, rgb);
        with += seen.has_cct;
        without += !seen.has_cct;
        assert_int_equal(kelvin > 0, seen.has_cct);
        if (seen.has_cct)
            assert_true(fabs(kelvin - seen.cct_k) < 1e-6 * seen.cct_k);
    }
    assert_true(with > 100 && without > 10);
    assert_true(lx_black_body_near(bodies, (const double[]){0, 0, 0}) == 0);
    free(bodies);
}

/* A view of a channel has its values, that of the colour temperature leaves out what has none, and none is of grey. */
static void fields_have_views(void **state)
{
    (void)state;
    luxel_scene *scene =
        scene_with(HEAD "channels: rgb\n" BALL "lights: [{type: point, position: [300, 200, 400], intensity: 2,"
                        " color: {temperature: 2700}}]\n",
                   "model: lambert");
    luxel_field *field = render(scene), *shown = NULL;
    for (luxel_color_view view = LUXEL_VIEW_LUMINANCE; view <= LUXEL_VIEW_CCT; view++) {
        assert_int_equal(luxel_field_of_view(field, view, NULL, &shown), LUXEL_OK);
        for (unsigned i = 0; i < 1600; i++) {
            const float *rgb = luxel_field_rgb_single(field) + 3 * (size_t)i;
            const double value = luxel_field_value(shown, i % 40, i / 40);
            const bool is_lit = luxel_field_single(field)[i] > 0;
            if (view == LUXEL_VIEW_LUMINANCE)
                assert_true(value == (double)luxel_field_single(field)[i]);
            else if (view < LUXEL_VIEW_CCT)
                assert_true(value == (double)rgb[view - LUXEL_VIEW_RED]);
            else
                assert_true(is_lit ? fabs(value - 2700) < 0.01 && luxel_field_mask(shown)[i]
                                   : !luxel_field_mask(shown)[i]);
        }
        assert_string_equal(luxel_field_unit(shown), view == LUXEL_VIEW_CCT ? "K" : luxel_field_unit(field));
        assert_int_equal(luxel_field_channels(shown), 1);
        luxel_field *again = NULL;
        assert_int_equal(luxel_field_of_view(shown, LUXEL_VIEW_RED, NULL, &again), LUXEL_ERROR_ARGUMENT);
        luxel_field_free(shown);
    }
    assert_int_equal(luxel_field_of_view(field, (luxel_color_view)5, NULL, &shown), LUXEL_ERROR_ARGUMENT);
    assert_null(luxel_color_view_word((luxel_color_view)5));
    luxel_field_free(field);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(observer_has_its_sums),
        cmocka_unit_test(black_bodies_have_their_chromaticities),
        cmocka_unit_test(black_bodies_have_their_channels),
        cmocka_unit_test(nearest_black_body_is_found),
        cmocka_unit_test(light_lies_within_the_locus),
        cmocka_unit_test(curve_is_that_of_srgb),
        cmocka_unit_test(grey_stays_grey),
        cmocka_unit_test(lamps_mix),
        cmocka_unit_test(materials_color),
        cmocka_unit_test(furnace_has_channels),
        cmocka_unit_test(negative_blue_is_kept),
        cmocka_unit_test(bad_colors_are_refused),
        cmocka_unit_test(many_colors_have_temperatures),
        cmocka_unit_test(fields_have_views),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

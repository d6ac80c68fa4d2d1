/* SPDX-License-Identifier: MIT */
/*
 * Units: brightness by lights of one law is W/sr, W/m2 or, over pi, W/(sr m2), or their photometric likes; where laws
 * or materials differ, it is relative.  Irradiance is W/m2 or lx by the law of nature alone, and relative by any other.
 */
#include <stdio.h>
#include <string.h>

#include "scenes.h"

#define PLAIN_BALL "{type: sphere, center: [-200, 0, 1000], radius: 100, material: {model: lambert}}"
#define BALL_OVER_PI "{type: sphere, center: [200, 0, 1000], radius: 100, material: {model: lambert, over_pi: true}}"
#define BY_SQUARE "{type: point, position: [900, 0, 2500], intensity: 4, attenuation: inverse-square}"
#define BY_NOTHING "{type: point, position: [900, 0, 2500], intensity: 4, attenuation: none}"
#define BY_SUM "{type: point, position: [900, 0, 2500], intensity: 4, attenuation: practical, k: 200}"
#define PARALLEL "{type: distant, direction: [0, 0, -1], irradiance: 2}"
#define SKY "{type: ambient, irradiance: 1}"
#define WINDOW "{type: planar, rectangle: {center: [0, 900, 2000], size: [300, 300], aim: [0, 0, 1000]}, radiance: 3"

static const struct {
    const char *surfaces, *lights;
    const char *brightness[2], *irradiance[2]; /* radiometric, photometric */
} cases[] = {
    {PLAIN_BALL, BY_NOTHING, {"W/sr", "cd"}, {"relative", "relative"}},
    {PLAIN_BALL, BY_NOTHING ", " BY_NOTHING, {"W/sr", "cd"}, {"relative", "relative"}},
    {PLAIN_BALL, BY_SQUARE, {"W/m²", "lx"}, {"W/m²", "lx"}},
    {PLAIN_BALL, PARALLEL, {"W/m²", "lx"}, {"W/m²", "lx"}},
    {PLAIN_BALL, BY_SQUARE ", " PARALLEL ", " SKY, {"W/m²", "lx"}, {"W/m²", "lx"}},
    {PLAIN_BALL, WINDOW "}", {"W/m²", "lx"}, {"W/m²", "lx"}},
    {PLAIN_BALL, WINDOW ", attenuation: none}", {"W/sr", "cd"}, {"relative", "relative"}},
    {PLAIN_BALL, WINDOW ", parts: 5}, " BY_SQUARE, {"W/m²", "lx"}, {"W/m²", "lx"}},
    {PLAIN_BALL, BY_SUM, {"relative", "relative"}, {"relative", "relative"}},
    {PLAIN_BALL, BY_NOTHING ", " BY_SQUARE, {"relative", "relative"}, {"relative", "relative"}},
    {PLAIN_BALL, BY_NOTHING ", " SKY, {"relative", "relative"}, {"relative", "relative"}},
    {PLAIN_BALL, BY_NOTHING ", " PARALLEL, {"relative", "relative"}, {"relative", "relative"}},
    {BALL_OVER_PI, BY_SQUARE, {"W/(sr·m²)", "cd/m²"}, {"W/m²", "lx"}},
    {BALL_OVER_PI ", " BALL_OVER_PI, SKY, {"W/(sr·m²)", "cd/m²"}, {"W/m²", "lx"}},
    {BALL_OVER_PI, BY_NOTHING, {"relative", "relative"}, {"relative", "relative"}},
    {BALL_OVER_PI, BY_SUM, {"relative", "relative"}, {"relative", "relative"}},
    {PLAIN_BALL, SKY, {"W/m²", "lx"}, {"W/m²", "lx"}},
    {PLAIN_BALL,
     "{type: point, position: [900, 0, 2500], intensity: 4, attenuation: none, enabled: false}, " SKY,
     {"W/m²", "lx"},
     {"W/m²", "lx"}},
    {PLAIN_BALL, WINDOW ", attenuation: none, parts: 3}", {"W/sr", "cd"}, {"relative", "relative"}},
    {PLAIN_BALL, WINDOW ", attenuation: practical, k: 100}", {"relative", "relative"}, {"relative", "relative"}},
    {PLAIN_BALL, "", {"W/sr", "cd"}, {"W/m²", "lx"}},
    {BALL_OVER_PI, "", {"W/(sr·m²)", "cd/m²"}, {"W/m²", "lx"}},
    {BALL_OVER_PI ", " PLAIN_BALL, BY_SQUARE, {"relative", "relative"}, {"W/m²", "lx"}},
    {PLAIN_BALL ", " BALL_OVER_PI, BY_SQUARE, {"relative", "relative"}, {"W/m²", "lx"}},
};

static const char *const words[2][2] = {{"brightness", "irradiance"}, {"luminance", "illuminance"}};

/* Profiles are of the same quantity, exact ones and those of the picture. */
static void check_profiles(const luxel_scene *scene, const luxel_field *field, const luxel_settings *settings,
                           const char *word)
{
    const luxel_profile_path path = {.type = LUXEL_PATH_LINE, .from_mm = {-10, 0}, .to_mm = {10, 0}, .samples = 2};
    luxel_evaluator *evaluator;
    luxel_profile *profile;
    assert_int_equal(luxel_evaluator_new(scene, settings, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_find_profile(evaluator, &path, NULL, &profile), LUXEL_OK);
    assert_string_equal(profile->quantity_word, word);
    luxel_profile_free(profile);
    luxel_evaluator_free(evaluator);
    assert_int_equal(luxel_field_profile(field, &path, NULL, &profile), LUXEL_OK);
    assert_string_equal(profile->quantity_word, word);
    luxel_profile_free(profile);
}

static void units(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int photometric = 0; photometric < 2; photometric++)
            for (int irradiance = 0; irradiance < 2; irradiance++) {
                char text[1500];
                luxel_scene *scene;
                luxel_field *field;
                luxel_settings settings;
                snprintf(text, sizeof text,
                         "luxel: 1\nunits: %s\nscreen: {width: 800, height: 600, resolution: [8, 6]}\n"
                         "observer: {z: 3000}\nsurfaces: [%s]\nlights: [%s]\n",
                         photometric ? "photometric" : "radiometric", cases[i].surfaces, cases[i].lights);
                if (load(text, NULL, &scene) != LUXEL_OK)
                    fail_msg("not a good scene: %s", text);
                luxel_settings_init(&settings);
                settings.quantity = irradiance ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
                assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
                const char *unit = (irradiance ? cases[i].irradiance : cases[i].brightness)[photometric];
                assert_string_equal(luxel_field_unit(field), unit);
                assert_string_equal(luxel_scene_unit(scene, settings.quantity), unit);
                assert_string_equal(luxel_field_quantity_word(field), words[photometric][irradiance]);
                assert_string_equal(luxel_scene_quantity_word(scene, settings.quantity),
                                    words[photometric][irradiance]);
                check_profiles(scene, field, &settings, words[photometric][irradiance]);
                luxel_field_free(field);
                luxel_scene_free(scene);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * Continuous extrema: closed forms, the report's scene, what kind of place they are, symmetries, and many random
 * scenes, in which an independent search by chance must find nothing beyond them.
 *
 * Every peak is held against the function itself: its value is the one that is found at its place.  So a peak that the
 * search by chance does not exceed is the extremum, as far as that search goes.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "campaign.h"
#include "evaluated.h"
#include "scenes.h"

enum { TEXT_SIZE = 8000 };

static luxel_scene *scene_of(const char *text)
{
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), text);
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* A scene with its picture and evaluator. */
struct setting {
    luxel_scene *scene;
    luxel_field *field;
    luxel_evaluator *evaluator;
    luxel_settings settings;
};

static struct setting setting_of(luxel_scene *scene, luxel_quantity quantity)
{
    struct setting setting = {.scene = scene};
    luxel_settings_init(&setting.settings);
    setting.settings.quantity = quantity;
    assert_int_equal(luxel_render(scene, &setting.settings, NULL, &setting.field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, &setting.settings, NULL, &setting.evaluator), LUXEL_OK);
    return setting;
}

static void clear(struct setting *setting)
{
    luxel_evaluator_free(setting->evaluator);
    luxel_field_free(setting->field);
    luxel_scene_free(setting->scene);
}

/* Whether a peak is what the function gives at its place. */
static void expect_true_value(const luxel_evaluator *evaluator, const luxel_region *region, const luxel_peak *peak)
{
    luxel_value seen = value_seen(evaluator, peak->x_mm, peak->y_mm);
    assert_true(peak->exists && seen.on_surface && seen.surface == peak->surface);
    assert_true(luxel_region_holds(region, peak->x_mm, peak->y_mm));
    if (seen.value == peak->value && seen.error == peak->error)
        return;
    /* On the rim of a sphere the screen does not resolve the place: the normal does. */
    luxel_value there = value_on(evaluator, peak->position_mm, peak->normal);
    double apart = distance_of(seen.position_mm, peak->position_mm);
    assert_true(there.on_surface && fabs(there.value - peak->value) <= 1e-12 * fabs(peak->value));
    assert_true(apart < 1e-2);
}

static luxel_extrema extrema_of(const struct setting *setting, const luxel_region *region)
{
    luxel_extrema extrema;
    assert_int_equal(luxel_find_extrema(setting->evaluator, setting->field, region, NULL, &extrema), LUXEL_OK);
    return extrema;
}

/* -- an independent search: by chance -- */

static uint64_t chance_state;

static double chance(double low, double high)
{
    chance_state ^= chance_state << 13;
    chance_state ^= chance_state >> 7;
    chance_state ^= chance_state << 17;
    return low + (high - low) * (double)(chance_state >> 11) * 0x1p-53;
}

struct trial {
    double x, y, value;
};

struct domain {
    const luxel_evaluator *evaluator;
    const luxel_region *region;
    double half, sign;
};

static double value_at(const struct domain *domain, double x, double y)
{
    if (!(fabs(x) <= domain->half && fabs(y) <= domain->half && luxel_region_holds(domain->region, x, y)))
        return -HUGE_VAL;
    luxel_value value = value_seen(domain->evaluator, x, y);
    /* what is sure of it: in a crack between two surfaces it may not even be known what shades what */
    return value.on_surface && value.has_value ? domain->sign * value.value - value.error : -HUGE_VAL;
}

/* Goes up in steps of random directions, which halve where none leads upwards. */
static void improve(const struct domain *domain, double step, struct trial *trial)
{
    for (int tries = 0; step > 1e-12 && tries < 2000; tries++) {
        bool better = false;
        double turn = chance(0, 2 * M_PI);
        for (int i = 0; i < 9; i++) {
            double x = trial->x + step * cos(turn + i * 2 * M_PI / 9),
                   y = trial->y + step * sin(turn + i * 2 * M_PI / 9);
            double value = value_at(domain, x, y);
            if (value > trial->value) {
                *trial = (struct trial){x, y, value};
                better = true;
                break;
            }
        }
        step = better ? fmin(1.5 * step, 20) : step * 0.6;
    }
}

/* Whether what was found is more than a crack between two surfaces, where rounding decides which of them is seen. */
static bool is_solid(const struct domain *domain, const struct trial *trial)
{
    for (int i = 0; i < 24; i++) {
        double beside = value_at(domain, trial->x + 1e-6 * cos(i * M_PI / 12), trial->y + 1e-6 * sin(i * M_PI / 12));
        if (fabs(beside - trial->value) <= 1e-3 * fabs(trial->value))
            return true;
    }
    return false;
}

enum { KEPT = 12 };

static void keep(struct trial kept[KEPT], struct trial trial, double apart)
{
    for (int i = 0; i < KEPT; i++)
        if (hypot(kept[i].x - trial.x, kept[i].y - trial.y) < apart) {
            if (trial.value > kept[i].value)
                kept[i] = trial;
            return;
        }
    int lowest = 0;
    for (int i = 1; i < KEPT; i++)
        if (kept[i].value < kept[lowest].value)
            lowest = i;
    if (trial.value > kept[lowest].value)
        kept[lowest] = trial;
}

static double search_by_chance(const struct domain *domain, int looks, double apart)
{
    struct trial kept[KEPT];
    double best = -HUGE_VAL;
    for (int i = 0; i < KEPT; i++)
        kept[i] = (struct trial){1e9, 1e9, -HUGE_VAL};
    for (int i = 0; i < looks; i++) {
        struct trial trial = {.x = chance(-domain->half, domain->half), .y = chance(-domain->half, domain->half)};
        if (domain->region && i % 2) {
            double reach =
                fmax(fmax(domain->region->size_mm[0], domain->region->size_mm[1]) / 2, domain->region->radius_mm);
            trial.x = domain->region->center_mm[0] + chance(-reach, reach);
            trial.y = domain->region->center_mm[1] + chance(-reach, reach);
        }
        trial.value = value_at(domain, trial.x, trial.y);
        keep(kept, trial, apart);
    }
    for (int i = 0; i < KEPT; i++) {
        if (!(kept[i].value > -HUGE_VAL))
            continue;
        for (int again = 0; again < 3; again++)
            improve(domain, again ? 0.1 : 3, &kept[i]);
        if (is_solid(domain, &kept[i]))
            best = fmax(best, kept[i].value);
    }
    return best;
}

/* -- random scenes -- */

static const char *one_of(const char *const words[], int count)
{
    return words[(int)chance(0, count)];
}

#define ONE_OF(...)                                                                                                    \
    one_of((const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *))

static char *add_surface(char *to, char *end)
{
    char material[400];
    snprintf(material, sizeof material,
             "material: {model: %s, diffuse: %.3f, specular: %.3f, shininess: %.4g, highlight: %s, over_pi: %s}",
             ONE_OF("blinn-phong", "phong", "lambert"), chance(0, 1) < 0.15 ? 0 : chance(0, 1), chance(0, 1),
             pow(10, chance(-1, 4)), ONE_OF("plain", "gated", "cosine"), ONE_OF("true", "false"));
    double x = chance(-250, 250), y = chance(-250, 250), z = chance(500, 1200);
    if (chance(0, 1) < 0.65)
        return to + snprintf(to, (size_t)(end - to),
                             "  - {type: sphere, center: [%.2f, %.2f, %.2f], radius: %.2f, %s}\n", x, y, z,
                             chance(40, 350), material);
    return to + snprintf(to, (size_t)(end - to),
                         "  - {type: rectangle, center: [%.2f, %.2f, %.2f], size: [%.1f, %.1f], axis: [%.3f, %.3f, 1], "
                         "up: [%.3f, 1, 0], %s}\n",
                         x, y, z, chance(100, 900), chance(100, 900), chance(-1, 1), chance(-1, 1), chance(-0.5, 0.5),
                         material);
}

static char *add_light(char *to, char *end)
{
    char law[100];
    size_t room = (size_t)(end - to);
    double x = chance(-2000, 2000), y = chance(-2000, 2000), z = chance(700, 3500), kind = chance(0, 1);
    if (chance(0, 1) < 0.2)
        x /= 5, y /= 5;
    snprintf(law, sizeof law, "intensity: %.3f, attenuation: %s", chance(0.5, 20),
             ONE_OF("inverse-square", "none", "practical, k: 300"));
    if (kind < 0.4)
        return to +
               snprintf(to, room,
                        "  - {type: point, position: [%.2f, %.2f, %.2f], pattern: %s, aim: [%.1f, %.1f, 900], %s}\n", x,
                        y, z,
                        ONE_OF("isotropic", "isotropic", "lambertian", "cosine, exponent: 0.5", "cosine, exponent: 30"),
                        chance(-200, 200), chance(-200, 200), law);
    if (kind < 0.6)
        return to + snprintf(to, room, "  - {type: distant, direction: [%.3f, %.3f, %.3f], irradiance: %.3f}\n",
                             chance(-1, 1), chance(-1, 1), chance(-1, 0.2), chance(0.5, 5));
    if (kind < 0.7)
        return to + snprintf(to, room, "  - {type: ambient, irradiance: %.3f}\n", chance(0, 1));
    double inner = chance(1, 15);
    return to +
           snprintf(to, room,
                    "  - {type: spot, position: [%.2f, %.2f, %.2f], aim: [%.1f, %.1f, 1000], inner: %.2f, outer: %.2f, "
                    "falloff: %s, exponent: %s, %s}\n",
                    x, y, z, chance(-200, 200), chance(-200, 200), inner, inner + chance(0.5, 10),
                    ONE_OF("smoothstep", "squared", "linear", "hard"), ONE_OF("0", "0", "2"), law);
}

/* The order in which a compiler draws the arguments is its own: other compilers try other scenes. */
static void make_scene(char text[TEXT_SIZE])
{
    char *to = text, *end = text + TEXT_SIZE;
    to += snprintf(to, TEXT_SIZE,
                   "luxel: 1\nscreen: {width: 600, height: 600, resolution: [120, 120], sampling: %s}\n"
                   "observer: {z: 3000, projection: %s, view: %s}\nshadows: %s\nsurfaces:\n",
                   ONE_OF("nodes", "centers"), ONE_OF("orthographic", "perspective"), ONE_OF("parallel", "observer"),
                   ONE_OF("points", "points", "none"));
    for (int i = (int)chance(1, 4); i > 0; i--)
        to = add_surface(to, end);
    to += snprintf(to, (size_t)(end - to), "lights:\n");
    for (int i = (int)chance(1, 5); i > 0; i--)
        to = add_light(to, end);
    assert_true(to < end);
}

static luxel_region make_region(void)
{
    luxel_region region = {.type = chance(0, 1) < 0.5 ? LUXEL_REGION_RECTANGLE : LUXEL_REGION_CIRCLE};
    double size = pow(10, chance(0.3, 2.7));
    region.center_mm[0] = chance(-200, 200), region.center_mm[1] = chance(-200, 200);
    if (region.type == LUXEL_REGION_CIRCLE)
        region.radius_mm = size;
    else
        region.size_mm[0] = size, region.size_mm[1] = size * chance(0.3, 2);
    return region;
}

/* The edges of a plate are known to 1e-12 of its size and place: what that is worth at a peak. */
static double edge_doubt(const struct domain *domain, const luxel_peak *peak)
{
    double doubt = 0, value = domain->sign * peak->value;
    for (int i = 0; i < 8; i++) {
        double x = peak->x_mm + 4e-9 * cos(i * M_PI / 4), y = peak->y_mm + 4e-9 * sin(i * M_PI / 4);
        luxel_value beside = value_seen(domain->evaluator, x, y);
        double apart = fabs(domain->sign * beside.value - value);
        if (beside.surface == peak->surface && apart < 1e-6 * fabs(value))
            doubt = fmax(doubt, apart);
    }
    return doubt;
}

static int misses;

static void hold_against_chance(const struct setting *setting, const luxel_region *region, int number)
{
    luxel_extrema extrema = extrema_of(setting, region);
    /* Far from a sharp highlight a minimum may be 1e-182: what no rounding of the maximum would show is no miss. */
    const double nothing = extrema.maximum.exists ? 1e-17 * extrema.maximum.value : 0;
    for (int sign = 1; sign >= -1; sign -= 2) {
        const luxel_peak *peak = sign > 0 ? &extrema.maximum : &extrema.minimum;
        struct domain domain = {setting->evaluator, region, 300, sign};
        double found = search_by_chance(&domain, 4000, 12);
        if (!peak->exists) {
            assert_true(found == -HUGE_VAL);
            continue;
        }
        expect_true_value(setting->evaluator, region, peak);
        double excess = found - sign * peak->value;
        if (excess > 1e-10 * fabs(peak->value) + nothing + edge_doubt(&domain, peak)) {
            misses++;
            print_message("scene %d, %s: %.17g at (%.10g, %.10g), place %d, but %.17g was found (%.2e)\n", number,
                          sign > 0 ? "maximum" : "minimum", peak->value, peak->x_mm, peak->y_mm, (int)peak->place,
                          sign * found, excess / fabs(peak->value));
            if (region)
                print_message("# region %d: [%g, %g] [%g, %g] %g\n", (int)region->type, region->center_mm[0],
                              region->center_mm[1], region->size_mm[0], region->size_mm[1], region->radius_mm);
        }
    }
}

static void random_scenes(void **state)
{
    static char text[TEXT_SIZE];
    (void)state;
    for (int i = 0; i < scenes_to_try(75); i++) {
        chance_state = 0x9e3779b97f4a7c15u * (uint64_t)(i + 1);
        for (int warm = 0; warm < 8; warm++)
            chance(0, 1);
        make_scene(text);
        luxel_quantity quantity = chance(0, 1) < 0.2 ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
        struct setting setting = setting_of(scene_of(text), quantity);
        luxel_region region = make_region();
        hold_against_chance(&setting, chance(0, 1) < 0.3 ? &region : NULL, i);
        clear(&setting);
    }
    assert_int_equal(misses, 0);
}

/* -- closed forms -- */

static char scene_text[TEXT_SIZE];

/* A scene 600 mm wide of these surfaces and lights. */
static struct setting made(const char *observer, const char *surfaces, const char *lights, luxel_quantity quantity)
{
    int length = snprintf(scene_text, sizeof scene_text,
                          "luxel: 1\nscreen: {width: 600, height: 600, resolution: [60, 60]}\nobserver: %s\n"
                          "surfaces: [%s]\nlights: [%s]\n",
                          observer, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    return setting_of(scene_of(scene_text), quantity);
}

/* What a maximum must be: at a place of the screen to 1e-5 mm, the value to 1e-12. */
static void expect_maximum(struct setting setting, const luxel_region *region, double value, double x, double y,
                           luxel_peak_place place)
{
    luxel_extrema extrema = extrema_of(&setting, region);
    const luxel_peak *peak = &extrema.maximum;
    expect_true_value(setting.evaluator, region, peak);
    if (!(fabs(peak->value - value) <= 1e-12 * value && fabs(peak->x_mm - x) < 1e-5 && fabs(peak->y_mm - y) < 1e-5 &&
          peak->place == place))
        fail_msg("%.17g at (%.9g, %.9g), place %d, but should be %.17g at (%.9g, %.9g), place %d", peak->value,
                 peak->x_mm, peak->y_mm, (int)peak->place, value, x, y, (int)place);
    clear(&setting);
}

#define FLAT "{z: 3000}"
#define WHITE "material: {model: lambert, diffuse: 1}"
#define BALL "{type: sphere, center: [0, 0, 1000], radius: 200, material: {model: lambert, diffuse: 0.7}}"
#define FLOOR "{type: rectangle, center: [0, 0, 0], size: [2000, 2000], " WHITE "}"

static void report(void **state)
{
    (void)state;
    luxel_scene *scene;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    struct setting setting = setting_of(scene, LUXEL_BRIGHTNESS);
    luxel_extrema extrema = extrema_of(&setting, NULL);
    assert_true(fabs(extrema.minimum.value) == 0 && extrema.minimum.place == LUXEL_PEAK_PLATEAU);
    assert_true(fabs(extrema.maximum.value - 11.747879166893981) <= 1e-13);
    assert_true(fabs(extrema.maximum.x_mm - 177.48276) < 5e-6 && fabs(extrema.maximum.y_mm) < 1e-7);
    assert_int_equal(extrema.maximum.place, LUXEL_PEAK_INSIDE);
    expect_true_value(setting.evaluator, NULL, &extrema.maximum);
    expect_true_value(setting.evaluator, NULL, &extrema.minimum);
    clear(&setting);
}

static void spheres(void **state)
{
    (void)state;
    /* facing a point, by the law 1/r^2 */
    double d = sqrt(400 * 400 + 300 * 300 + 1200 * 1200);
    expect_maximum(made(FLAT, BALL, "{type: point, position: [400, -300, 2200], intensity: 5}", LUXEL_BRIGHTNESS), NULL,
                   0.7 * 5e6 / ((d - 200) * (d - 200)), 200 * 400 / d, -200 * 300 / d, LUXEL_PEAK_INSIDE);
    /* facing the sun */
    d = sqrt(0.36 + 0.25 + 0.16);
    expect_maximum(made(FLAT, BALL, "{type: distant, direction: [-0.6, 0.4, -0.5], irradiance: 3}", LUXEL_BRIGHTNESS),
                   NULL, 0.7 * 3, 200 * 0.6 / d, -200 * 0.4 / d, LUXEL_PEAK_INSIDE);
    /* which shines from behind: on the rim */
    expect_maximum(made(FLAT, BALL, "{type: distant, direction: [-0.6, -0.8, 0.75], irradiance: 3}", LUXEL_BRIGHTNESS),
                   NULL, 0.7 * 3 * 0.8, 200 * 0.6, 200 * 0.8, LUXEL_PEAK_LIMB);
    /* in perspective the rim lies nearer to the front: N.z = R/D, seen at R sqrt(1 - R^2/D^2) z/(z - z_N) */
    double rim = 150 / 2000.0, sine = sqrt(1 - rim * rim), height = 1000 + 150 * rim;
    expect_maximum(made("{z: 3000, projection: perspective}",
                        "{type: sphere, center: [0, 0, 1000], radius: 150, material: {model: lambert, diffuse: 0.7}}",
                        "{type: distant, direction: [-0.8, 0, 0.6], irradiance: 3}", LUXEL_BRIGHTNESS),
                   NULL, 0.7 * 3 * (0.8 * sine - 0.6 * rim), 150 * sine * 3000 / (3000 - height), 0, LUXEL_PEAK_LIMB);
    /* off the screen: on its border, N.x = 300/400 and N in the plane of x and the light */
    expect_maximum(made(FLAT, "{type: sphere, center: [0, 0, 0], radius: 400, " WHITE "}",
                        "{type: distant, direction: [-1, 0, -0.1], irradiance: 1}", LUXEL_IRRADIANCE),
                   NULL, (0.75 + 0.1 * sqrt(1 - 0.75 * 0.75)) / sqrt(1.01), 300, 0, LUXEL_PEAK_BORDER);
    /* two spheres, the second nearer to the light */
    struct setting two = made(FLAT,
                              "{type: sphere, center: [-150, 0, 800], radius: 100, " WHITE "}, "
                              "{type: sphere, center: [150, 0, 1200], radius: 80, " WHITE "}",
                              "{type: point, position: [0, 0, 3000], intensity: 5}", LUXEL_IRRADIANCE);
    luxel_extrema extrema = extrema_of(&two, NULL);
    assert_int_equal(extrema.maximum.surface, 1);
    d = hypot(150, 1800);
    expect_maximum(two, NULL, 5e6 / ((d - 80) * (d - 80)), 150 - 80 * 150 / d, 0, LUXEL_PEAK_INSIDE);
}

/* A highlight much narrower than a pixel: N = H. */
static void narrow_highlight(void **state)
{
    (void)state;
    const char *ball = "{type: sphere, center: [0, 0, 1000], radius: 200, "
                       "material: {diffuse: 0, specular: 0.5, shininess: 10000}}";
    double x = 0.6 / sqrt(0.77), z = 0.5 / sqrt(0.77) + 1, y = -0.4 / sqrt(0.77), length = sqrt(x * x + y * y + z * z);
    expect_maximum(made(FLAT, ball, "{type: distant, direction: [-0.6, 0.4, -0.5], irradiance: 3}", LUXEL_BRIGHTNESS),
                   NULL, 1.5, 200 * x / length, 200 * y / length, LUXEL_PEAK_INSIDE);
    expect_maximum(made(FLAT,
                        "{type: rectangle, center: [0, 0, 500], size: [500, 500], "
                        "material: {model: phong, diffuse: 0, specular: 0.5, shininess: 10000}}",
                        "{type: point, position: [33, 44, 900], intensity: 2, attenuation: none}", LUXEL_BRIGHTNESS),
                   NULL, 1, 33, 44, LUXEL_PEAK_INSIDE);
}

static double below(double intensity, double height, double aside)
{
    return intensity * 1e6 * height / pow(height * height + aside * aside, 1.5);
}

static void plates(void **state)
{
    (void)state;
    luxel_region right = {.type = LUXEL_REGION_RECTANGLE, .center_mm = {225, 30}, .size_mm = {150, 100}};
    luxel_region round = {.type = LUXEL_REGION_CIRCLE, .center_mm = {60, 80}, .radius_mm = 40};
    /* the foot; off the screen; off the plate; off the region */
    expect_maximum(made(FLAT, FLOOR, "{type: point, position: [70, -90, 800], intensity: 4}", LUXEL_IRRADIANCE), NULL,
                   4e6 / (800 * 800), 70, -90, LUXEL_PEAK_INSIDE);
    expect_maximum(made(FLAT, FLOOR, "{type: point, position: [470, -90, 800], intensity: 4}", LUXEL_IRRADIANCE), NULL,
                   below(4, 800, 170), 300, -90, LUXEL_PEAK_BORDER);
    expect_maximum(made(FLAT, FLOOR, "{type: point, position: [470, 390, 800], intensity: 4}", LUXEL_IRRADIANCE), NULL,
                   below(4, 800, hypot(170, 90)), 300, 300, LUXEL_PEAK_BORDER);
    expect_maximum(made(FLAT, "{type: rectangle, center: [0, 0, 0], size: [200, 400], " WHITE "}",
                        "{type: point, position: [170, -90, 800], intensity: 4}", LUXEL_IRRADIANCE),
                   NULL, below(4, 800, 70), 100, -90, LUXEL_PEAK_LIMB);
    expect_maximum(made(FLAT, FLOOR, "{type: point, position: [0, 0, 800], intensity: 4}", LUXEL_IRRADIANCE), &round,
                   below(4, 800, 60), 36, 48, LUXEL_PEAK_BORDER);
    /* the edge of a hard cone, of a shadow, of a linear cone's full light */
    double edge = 1000 * tan(atan(0.3) - 10 * M_PI / 180);
    expect_maximum(made(FLAT, FLOOR,
                        "{type: spot, position: [-100, 50, 1000], aim: [200, 50, 0], inner: 10, outer: 10, "
                        "falloff: hard, intensity: 2}",
                        LUXEL_IRRADIANCE),
                   NULL, below(2, 1000, edge), edge - 100, 50, LUXEL_PEAK_JUMP);
    expect_maximum(made(FLAT, FLOOR,
                        "{type: spot, position: [-100, 50, 1000], aim: [200, 50, 0], inner: 10, outer: 12, "
                        "falloff: linear, intensity: 2}",
                        LUXEL_IRRADIANCE),
                   NULL, below(2, 1000, edge), edge - 100, 50, LUXEL_PEAK_JUMP);
    expect_maximum(made(FLAT, FLOOR ", {type: rectangle, center: [0, 0, 500], size: [200, 200], " WHITE "}",
                        "{type: point, position: [0, 0, 1000], intensity: 4}", LUXEL_IRRADIANCE),
                   &right, below(4, 1000, 200), 200, 0, LUXEL_PEAK_JUMP);
    /* one value all over */
    struct setting setting =
        made(FLAT, FLOOR, "{type: distant, direction: [1, 0, -1], irradiance: 2}", LUXEL_IRRADIANCE);
    luxel_extrema extrema = extrema_of(&setting, NULL);
    assert_true(fabs(extrema.maximum.value - sqrt(2)) < 1e-15 && extrema.minimum.value == extrema.maximum.value);
    assert_true(extrema.maximum.place == LUXEL_PEAK_PLATEAU && extrema.minimum.place == LUXEL_PEAK_PLATEAU);
    clear(&setting);
}

static void minima(void **state)
{
    (void)state;
    struct setting setting = /* the corner farthest from the foot */
        made(FLAT, FLOOR, "{type: point, position: [70, -90, 800], intensity: 4}", LUXEL_IRRADIANCE);
    luxel_extrema extrema = extrema_of(&setting, NULL);
    double least = below(4, 800, hypot(370, 390));
    assert_true(fabs(extrema.minimum.value - least) < 1e-12 * least);
    assert_true(extrema.minimum.x_mm == -300 && extrema.minimum.y_mm == 300);
    assert_int_equal(extrema.minimum.place, LUXEL_PEAK_BORDER);
    clear(&setting);
    /* lights from two sides, which both set on the middle line: a kink */
    setting = made(FLAT, BALL,
                   "{type: distant, direction: [-1, 0, 0], irradiance: 2}, "
                   "{type: distant, direction: [1, 0, 0], irradiance: 3}",
                   LUXEL_IRRADIANCE);
    extrema = extrema_of(&setting, NULL);
    assert_true(extrema.minimum.value < 1e-12 && fabs(extrema.minimum.x_mm) < 1e-9);
    clear(&setting);
    /* a ball whose highlight sets within the screen, and falls towards that line as a high power of the way to it */
    setting = made(FLAT, "{type: sphere, center: [0, 0, 1000], radius: 400, material: {diffuse: 0.8, specular: 0.5}}",
                   "{type: volume, sphere: {center: [0, 900, 2000], radius: 40}, radiance: 7}", LUXEL_BRIGHTNESS);
    assert_true(extrema_of(&setting, NULL).minimum.value == 0);
    clear(&setting);
}

/* -- symmetries -- */

static luxel_peak maximum_of(const char *surfaces, const char *lights)
{
    struct setting setting = made("{z: 3000, projection: perspective}", surfaces, lights, LUXEL_BRIGHTNESS);
    luxel_peak peak = extrema_of(&setting, NULL).maximum;
    expect_true_value(setting.evaluator, NULL, &peak);
    clear(&setting);
    return peak;
}

static void symmetries(void **state)
{
    (void)state;
    const char *shine = "material: {diffuse: 0.6, specular: 0.3, shininess: 35}";
    char ball[200], mirrored[200], turned[200];
    snprintf(ball, sizeof ball, "{type: sphere, center: [40, 70, 900], radius: 210, %s}", shine);
    snprintf(mirrored, sizeof mirrored, "{type: sphere, center: [-40, 70, 900], radius: 210, %s}", shine);
    snprintf(turned, sizeof turned, "{type: sphere, center: [-70, 40, 900], radius: 210, %s}", shine);
    luxel_peak peak = maximum_of(ball, "{type: point, position: [900, -400, 2100], intensity: 8}");
    luxel_peak other = maximum_of(mirrored, "{type: point, position: [-900, -400, 2100], intensity: 8}");
    assert_true(fabs(other.value - peak.value) <= 1e-14 * peak.value);
    assert_true(fabs(other.x_mm + peak.x_mm) < 1e-6 && fabs(other.y_mm - peak.y_mm) < 1e-6);
    other = maximum_of(turned, "{type: point, position: [400, 900, 2100], intensity: 8}");
    assert_true(fabs(other.value - peak.value) <= 1e-14 * peak.value);
    assert_true(fabs(other.x_mm + peak.y_mm) < 1e-6 && fabs(other.y_mm - peak.x_mm) < 1e-6);
    other = maximum_of(ball, "{type: point, position: [900, -400, 2100], intensity: 24}");
    assert_true(fabs(other.value - 3 * peak.value) <= 1e-14 * other.value);
    assert_true(fabs(other.x_mm - peak.x_mm) < 1e-6 && fabs(other.y_mm - peak.y_mm) < 1e-6);
}

/* -- what is asked for -- */

/* Counts, and goes on as long as the count is not above 0. */
static bool stop(double done, void *data)
{
    (void)done;
    return ++*(int *)data <= 0;
}

static void expect_refused(const struct setting *setting, const luxel_field *field, const luxel_region *region,
                           const char *id)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_extrema extrema;
    assert_int_equal(luxel_find_extrema(setting->evaluator, field, region, diagnostics, &extrema),
                     LUXEL_ERROR_ARGUMENT);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, id);
    luxel_diagnostics_free(diagnostics);
}

static void requests(void **state)
{
    (void)state;
    const char *lamp = "{type: point, position: [400, -300, 2200], intensity: 5}";
    struct setting setting = made(FLAT, BALL, lamp, LUXEL_BRIGHTNESS), other = made(FLAT, BALL, lamp, LUXEL_IRRADIANCE);
    luxel_region off = {.type = LUXEL_REGION_CIRCLE, .center_mm = {280, 280}, .radius_mm = 10};
    luxel_region tiny = {.type = LUXEL_REGION_RECTANGLE, .center_mm = {0.3, 0.2}, .size_mm = {0.01, 0.02}};
    luxel_region far_off = {.type = LUXEL_REGION_CIRCLE, .center_mm = {900, 0}, .radius_mm = 10};
    luxel_region bad = {.type = LUXEL_REGION_CIRCLE, .radius_mm = 0};
    expect_refused(&setting, other.field, NULL, "foreign-field");
    expect_refused(&setting, setting.field, &bad, "bad-region");
    expect_refused(&setting, NULL, NULL, "missing-argument");
    assert_false(extrema_of(&setting, &off).maximum.exists || extrema_of(&setting, &far_off).minimum.exists);
    luxel_extrema extrema = extrema_of(&setting, &tiny);
    assert_true(fabs(extrema.maximum.x_mm - 0.305) < 1e-12 && fabs(extrema.maximum.y_mm - 0.19) < 1e-12);
    assert_int_equal(extrema.maximum.place, LUXEL_PEAK_BORDER);
    clear(&other);
    clear(&setting);

    luxel_scene *scene;
    assert_int_equal(luxel_scene_open_builtin("tube", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    setting = setting_of(scene, LUXEL_BRIGHTNESS);
    luxel_evaluator_free(setting.evaluator);
    int calls = -1000;
    setting.settings.progress = stop;
    setting.settings.progress_data = &calls;
    assert_int_equal(luxel_evaluator_new(scene, &setting.settings, NULL, &setting.evaluator), LUXEL_OK);
    calls = 0;
    assert_int_equal(luxel_find_extrema(setting.evaluator, setting.field, NULL, NULL, &extrema), LUXEL_CANCELLED);
    assert_int_equal(calls, 1);
    clear(&setting);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(report),   cmocka_unit_test(spheres),       cmocka_unit_test(narrow_highlight),
        cmocka_unit_test(plates),   cmocka_unit_test(minima),        cmocka_unit_test(symmetries),
        cmocka_unit_test(requests), cmocka_unit_test(random_scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * Reflected light of a floor on which shadows and gaps between them are narrow: boards, rods, a window and a ball under
 * the sun or a point, from below them, by one bounce.  What is lit is a sum of rectangles and disks, over each of which
 * the light that arrives is an integral of a smooth function, here by Gauss's rule.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "place.h"
#include "random_scenes.h"
#include "scenes.h"

enum { TEXT_SIZE = 4000, MOST_BOARDS = 6, PLACES = 3, SCENES = 28 };

static const double FLOOR = 2000, REFLECTANCE = 0.5;

/* A rectangle parallel to the axes: lowest and highest x and y. */
struct rectangle {
    double low[2], high[2];
};

static const struct rectangle whole_floor = {{-2000, -2000}, {2000, 2000}};

/* Boards at one height over the floor, or a ball, under one light. */
struct shadows {
    struct rectangle boards[MOST_BOARDS];
    int board_count;
    double height;
    double ball[3], radius; /* 0: there is none */
    bool is_sun;
    double light[3]; /* the way to the sun, of height 1; or where the point is */
};

/* ---- the truth ---- */

/* The shadow of a place on the floor. */
static void cast(const struct shadows *shadows, double x, double y, double z, double shadow[2])
{
    const double *light = shadows->light;
    const double share = shadows->is_sun ? z : z / (light[2] - z);
    shadow[0] = x + share * (shadows->is_sun ? -light[0] : x - light[0]);
    shadow[1] = y + share * (shadows->is_sun ? -light[1] : y - light[1]);
}

/* What arrives at a place from 1 mm^2 of the floor: the sun gives an irradiance of 1 on what faces it, the point has an
 * intensity of 1. */
static double from_floor(const struct shadows *shadows, const double place[3], double x, double y)
{
    const double *light = shadows->light;
    const double to[3] = {light[0] - (shadows->is_sun ? 0 : x), light[1] - (shadows->is_sun ? 0 : y), light[2]};
    const double square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
    const double direct = shadows->is_sun ? to[2] / sqrt(square) : 1e6 * to[2] / (square * sqrt(square));
    const double away = (x - place[0]) * (x - place[0]) + (y - place[1]) * (y - place[1]) + place[2] * place[2];
    return REFLECTANCE * direct * place[2] * place[2] / (M_PI * away * away);
}

static const double nodes[] = {0.21132486540518712, 0.78867513459481288};

static double from_rectangle(const struct shadows *shadows, const double place[3], const struct rectangle *rectangle)
{
    enum { PANELS = 200 };
    double step[2], sum = 0;
    for (int k = 0; k < 2; k++)
        step[k] = (rectangle->high[k] - rectangle->low[k]) / PANELS;
    for (int i = 0; i < 2 * PANELS; i++)
        for (int j = 0; j < 2 * PANELS; j++)
            sum += from_floor(shadows, place, rectangle->low[0] + step[0] * (i / 2 + nodes[i % 2]),
                              rectangle->low[1] + step[1] * (j / 2 + nodes[j % 2]));
    return sum * step[0] * step[1] / 4;
}

/* The shadow of a ball under the sun overhead is a disk. */
static double from_disk(const struct shadows *shadows, const double place[3])
{
    enum { RINGS = 100, TURNS = 200 };
    const double step = shadows->radius / RINGS;
    double sum = 0;
    for (int i = 0; i < 2 * RINGS; i++)
        for (int j = 0; j < TURNS; j++) {
            const double radius = step * (i / 2 + nodes[i % 2]), angle = 2 * M_PI * j / TURNS;
            sum += radius * from_floor(shadows, place, shadows->ball[0] + radius * cos(angle),
                                       shadows->ball[1] + radius * sin(angle));
        }
    return sum * step / 2 * 2 * M_PI / TURNS;
}

static double truth_at(const struct shadows *shadows, const double place[3])
{
    double light = from_rectangle(shadows, place, &whole_floor);
    for (int i = 0; i < shadows->board_count; i++) {
        struct rectangle shadow;
        cast(shadows, shadows->boards[i].low[0], shadows->boards[i].low[1], shadows->height, shadow.low);
        cast(shadows, shadows->boards[i].high[0], shadows->boards[i].high[1], shadows->height, shadow.high);
        for (int k = 0; k < 2; k++) {
            shadow.low[k] = fmax(shadow.low[k], -FLOOR);
            shadow.high[k] = fmin(shadow.high[k], FLOOR);
        }
        if (shadow.low[0] < shadow.high[0] && shadow.low[1] < shadow.high[1])
            light -= from_rectangle(shadows, place, &shadow);
    }
    return shadows->radius > 0 ? light - from_disk(shadows, place) : light;
}

/* ---- scenes ---- */

static void add_board(struct shadows *shadows, double x, double y, double width, double length)
{
    assert_true(shadows->board_count < MOST_BOARDS);
    shadows->boards[shadows->board_count++] =
        (struct rectangle){{x - width / 2, y - length / 2}, {x + width / 2, y + length / 2}};
}

/* Boards side by side, gaps of 3 to 100 mm between them, the outer ones beyond the floor. */
static void add_gaps(struct randomness *random, struct shadows *shadows)
{
    const int count = 2 + pick(random, 4);
    double x = -1.3 * FLOOR;
    for (int i = 0; i < count; i++) {
        const double end = i == count - 1 ? 1.3 * FLOOR : fmax(x, -FLOOR) + uniform(random, 50, 700);
        add_board(shadows, (x + end) / 2, 0, end - x, 2.6 * FLOOR);
        x = end + logarithmic(random, 3, 100);
    }
}

static void add_rods(struct randomness *random, struct shadows *shadows)
{
    const int count = 1 + pick(random, 3);
    for (int i = 0; i < count; i++)
        add_board(shadows, -1000 + 800 * i + uniform(random, -100, 100), uniform(random, -500, 500),
                  logarithmic(random, 3, 100), uniform(random, 300, 3000));
}

/* Four boards around a window. */
static void add_window(struct randomness *random, struct shadows *shadows)
{
    const double far = 1.3 * FLOOR, x = uniform(random, -900, 900), y = uniform(random, -900, 900);
    const double width = logarithmic(random, 20, 600), height = logarithmic(random, 20, 600);
    shadows->boards[0] = (struct rectangle){{-far, -far}, {x, far}};
    shadows->boards[1] = (struct rectangle){{x + width, -far}, {far, far}};
    shadows->boards[2] = (struct rectangle){{x, -far}, {x + width, y}};
    shadows->boards[3] = (struct rectangle){{x, y + height}, {x + width, far}};
    shadows->board_count = 4;
}

static struct shadows random_shadows(struct randomness *random, int kind)
{
    struct shadows shadows = {.height = uniform(random, 600, 1200), .is_sun = kind == 3 || pick(random, 2)};
    shadows.light[2] = shadows.is_sun ? 1 : uniform(random, 2000, 3000);
    for (int k = 0; k < 2 && kind != 3; k++)
        shadows.light[k] = shadows.is_sun ? pick(random, 2) * uniform(random, -0.3, 0.3) : uniform(random, -300, 300);
    if (kind == 0)
        add_gaps(random, &shadows);
    else if (kind == 1)
        add_rods(random, &shadows);
    else if (kind == 2)
        add_window(random, &shadows);
    for (int k = 0; k < 2 && kind == 3; k++)
        shadows.ball[k] = uniform(random, -1000, 1000);
    shadows.ball[2] = shadows.height + 400;
    shadows.radius = kind == 3 ? logarithmic(random, 10, 200) : 0;
    return shadows;
}

static void write_rectangles(const char *folder, const char *name, const struct rectangle *rectangles, int count)
{
    char path[300];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n", 4 * count, 2 * count);
    for (int i = 0; i < count; i++) {
        const double *low = rectangles[i].low, *high = rectangles[i].high;
        fprintf(file, "%.17g %.17g 0\n%.17g %.17g 0\n%.17g %.17g 0\n%.17g %.17g 0\n", low[0], low[1], high[0], low[1],
                high[0], high[1], low[0], high[1]);
    }
    for (int i = 0; i < 4 * count; i += 4)
        fprintf(file, "3 %d %d %d\n3 %d %d %d\n", i, i + 1, i + 2, i, i + 2, i + 3);
    assert_int_equal(fclose(file), 0);
}

#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"

/* As plates, or as meshes in files of a folder. */
static void describe(const struct shadows *shadows, const char *folder, char text[TEXT_SIZE])
{
    int length = snprintf(text, TEXT_SIZE,
                          "luxel: 1\nreflections: 1\nscreen: {width: 400, height: 400, resolution: [4, 4]}\n"
                          "observer: {z: 30000, projection: perspective}\nsurfaces:\n");
    if (folder)
        length +=
            snprintf(text + length, (size_t)(TEXT_SIZE - length),
                     "  - {type: mesh, file: '%s/floor.off', " MATERIAL(
                         "0.5") "}\n"
                                "  - {type: mesh, file: '%s/boards.off', position: [0, 0, %.17g], " MATERIAL("0") "}\n",
                     folder, folder, shadows->height);
    else
        length +=
            snprintf(text + length, (size_t)(TEXT_SIZE - length),
                     "  - {type: rectangle, center: [0, 0, 0], size: [%g, %g], axis: [0, 0, 1], " MATERIAL("0.5") "}\n",
                     2 * FLOOR, 2 * FLOOR);
    for (int i = 0; i < shadows->board_count && !folder; i++) {
        const double *low = shadows->boards[i].low, *high = shadows->boards[i].high;
        length += snprintf(
            text + length, (size_t)(TEXT_SIZE - length),
            "  - {type: rectangle, center: [%.17g, %.17g, %.17g], size: [%.17g, %.17g], axis: [0, 0, 1], "
            "up: [0, 1, 0], " MATERIAL("0") "}\n",
            (low[0] + high[0]) / 2, (low[1] + high[1]) / 2, shadows->height, high[0] - low[0], high[1] - low[1]);
    }
    if (shadows->radius > 0)
        length += snprintf(text + length, (size_t)(TEXT_SIZE - length),
                           "  - {type: sphere, center: [%.17g, %.17g, %.17g], radius: %.17g, " MATERIAL("0") "}\n",
                           shadows->ball[0], shadows->ball[1], shadows->ball[2], shadows->radius);
    const double *light = shadows->light, sign = shadows->is_sun ? -1 : 1;
    length +=
        snprintf(text + length, (size_t)(TEXT_SIZE - length), "lights: [{type: %s: [%.17g, %.17g, %.17g], %s: 1}]\n",
                 shadows->is_sun ? "distant, direction" : "point, position", sign * light[0], sign * light[1],
                 sign * light[2], shadows->is_sun ? "irradiance" : "intensity");
    assert_true(length < TEXT_SIZE);
}

static void look_from_below(const struct shadows *shadows, const char *folder, struct randomness *random, int number)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    luxel_settings settings;
    luxel_probes *probes;
    luxel_place places[PLACES] = {0};
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    describe(shadows, folder, text);
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), text);
    luxel_diagnostics_free(diagnostics);
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = 1e-2;
    for (int i = 0; i < PLACES; i++)
        places[i] = (luxel_place){.is_element = true,
                                  .position_mm = {uniform(random, -1500, 1500), uniform(random, -1500, 1500),
                                                  uniform(random, 100, shadows->height - 50)},
                                  .normal = {0, 0, -1}};
    const luxel_status status = luxel_probe_places(scene, &settings, places, PLACES, NULL, &probes);
    assert_true(status == LUXEL_OK);
    for (int i = 0; i < PLACES; i++) {
        const double value = luxel_probes_get(probes, (size_t)i)->reflected_irradiance,
                     error = luxel_probes_get(probes, (size_t)i)->reflected.error;
        const double truth = truth_at(shadows, places[i].position_mm);
        if (!(fabs(value - truth) <= error + 1e-6 * truth && error <= 0.2 * truth))
            fail_msg("scene %d%s, place %d: %.10g +- %.2g, not %.10g\n%s", number, folder ? " as meshes" : "", i, value,
                     error, truth, text);
    }
    luxel_probes_free(probes);
    luxel_scene_free(scene);
}

static void test_shadows(void **state)
{
    struct randomness random = {20261128};
    const char *folder = ((const struct place *)*state)->folder;
    write_rectangles(folder, "floor.off", &whole_floor, 1);
    for (int i = 0; i < SCENES; i++) {
        const struct shadows shadows = random_shadows(&random, i % 4);
        look_from_below(&shadows, NULL, &random, i);
        if (i % 4 == 3 || i % 8 > 3)
            continue;
        write_rectangles(folder, "boards.off", shadows.boards, shadows.board_count);
        look_from_below(&shadows, folder, &random, i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_setup_teardown(test_shadows, make_place, remove_place)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

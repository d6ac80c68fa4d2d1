/* SPDX-License-Identifier: MIT */
/*
 * Reflected light of meshes: as that of the plates and the ball that they stand for, as the furnace tells, and by the
 * true faces, whatever the smooth normals; the balance of a closed mesh; and how many triangles are too many.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "place.h"
#include "scenes.h"
#include <luxel/balance.h>

enum { TEXT_SIZE = 6000, PLACES = 4 };

#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"
#define LAMP "{type: point, position: [300, 800, 1400], intensity: 500}"

/* ---- meshes ---- */

/* The eight corners of a box around the origin and its twelve triangles, which look outwards. */
static void write_box(const char *path, const double half[3])
{
    static const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n8 12 0\n");
    for (int c = 0; c < 8; c++)
        fprintf(file, "%g %g %g\n", c & 1 ? half[0] : -half[0], c & 2 ? half[1] : -half[1], c & 4 ? half[2] : -half[2]);
    for (int s = 0; s < 6; s++)
        fprintf(file, "3 %d %d %d\n3 %d %d %d\n", sides[s][0], sides[s][1], sides[s][2], sides[s][0], sides[s][2],
                sides[s][3]);
    assert_int_equal(fclose(file), 0);
}

/* A ball of radius 1: each face of an octahedron in count^2 triangles, whose corners are on the ball. */
static void write_ball(const char *path, int count)
{
    FILE *file = fopen(path, "w");
    const int corners = (count + 1) * (count + 2) / 2;
    assert_non_null(file);
    fprintf(file, "OFF\n%d %d 0\n", 8 * corners, 8 * count * count);
    for (int face = 0; face < 8; face++)
        for (int i = 0; i <= count; i++)
            for (int j = 0; j <= i; j++) {
                const double x = count - i, y = i - j, z = j, length = sqrt(x * x + y * y + z * z);
                fprintf(file, "%.17g %.17g %.17g\n", (face & 1 ? -x : x) / length, (face & 2 ? -y : y) / length,
                        (face & 4 ? -z : z) / length);
            }
    for (int face = 0; face < 8; face++) {
        const bool turned = (face ^ face >> 1 ^ face >> 2) & 1;
        for (int i = 0; i < count; i++)
            for (int j = 0; j <= 2 * i; j++) {
                const int above = corners * face + i * (i + 1) / 2 + j / 2, below = above + i + 1;
                const int a = above, b = j % 2 ? below + 1 : below, c = j % 2 ? above + 1 : below + 1;
                fprintf(file, "3 %d %d %d\n", a, turned ? c : b, turned ? b : c);
            }
    }
    assert_int_equal(fclose(file), 0);
}

/* ---- scenes ---- */

static luxel_status try_scene(const char *reflections, const char *surfaces, const char *lights,
                              luxel_diagnostics *diagnostics, luxel_scene **scene)
{
    char text[TEXT_SIZE];
    const int length = snprintf(text, sizeof text,
                                "luxel: 1\nunits: photometric\nreflections: %s\n"
                                "screen: {width: 400, height: 400, resolution: [4, 4]}\nobserver: {z: 30000, "
                                "projection: perspective}\nsurfaces: [%s]\nlights: [%s]\n",
                                reflections, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    return load(text, diagnostics, scene);
}

static luxel_scene *scene_of(const char *reflections, const char *surfaces, const char *lights)
{
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (try_scene(reflections, surfaces, lights, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), surfaces);
    luxel_diagnostics_free(diagnostics);
    return scene;
}

struct element {
    double place[3], normal[3];
};

/* Reflected irradiances and their bounds, which are to be no more than `most` of the values; whether they are. */
static bool ask(luxel_scene *scene, const struct element *elements, size_t count, double most, double values[PLACES],
                double errors[PLACES])
{
    bool reached = true;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = most;
    luxel_place places[PLACES] = {0};
    luxel_probes *probes;
    for (size_t i = 0; i < count; i++) {
        places[i].is_element = true;
        memcpy(places[i].position_mm, elements[i].place, sizeof places[i].position_mm);
        memcpy(places[i].normal, elements[i].normal, sizeof places[i].normal);
    }
    assert_int_equal(luxel_probe_places(scene, &settings, places, count, NULL, &probes), LUXEL_OK);
    for (size_t i = 0; i < count; i++) {
        assert_true(luxel_probes_get(probes, i)->has_reflected);
        if (luxel_probes_get(probes, i)->reflected_reached)
            assert_true(luxel_probes_get(probes, i)->reflected.error <=
                        fmax(most * luxel_probes_get(probes, i)->value, DBL_MIN));
        reached = reached && luxel_probes_get(probes, i)->reflected_reached;
        values[i] = luxel_probes_get(probes, i)->reflected_irradiance;
        errors[i] = luxel_probes_get(probes, i)->reflected.error;
    }
    luxel_probes_free(probes);
    luxel_scene_free(scene);
    return reached;
}

static void probe(luxel_scene *scene, const struct element *elements, size_t count, double most, double values[PLACES],
                  double errors[PLACES])
{
    assert_true(ask(scene, elements, count, most, values, errors));
}

/* Two scenes have the same light, as far as both know it. */
static void compare(const char *reflections, const char *surfaces, const char *others, const char *lights, double most,
                    const struct element elements[PLACES])
{
    double values[2][PLACES], errors[2][PLACES];
    probe(scene_of(reflections, surfaces, lights), elements, PLACES, most, values[0], errors[0]);
    probe(scene_of(reflections, others, lights), elements, PLACES, most, values[1], errors[1]);
    for (int i = 0; i < PLACES; i++)
        if (!(fabs(values[0][i] - values[1][i]) <= errors[0][i] + errors[1][i]))
            fail_msg("place %d: %.10g with %.2g, and %.10g with %.2g\n%s", i, values[0][i], errors[0][i], values[1][i],
                     errors[1][i], surfaces);
}

static const char *path_of(void **state, const char *name)
{
    static char path[2][64];
    static int next;
    next = !next;
    snprintf(path[next], sizeof path[next], "%s/%s", ((const struct place *)*state)->folder, name);
    return path[next];
}

/* ---- tests ---- */

#define ROOM "{type: room, center: [0, 0, 0], size: [5000, 3000, 4000], " MATERIAL("0.5") "}"

static const struct element in_room[PLACES] = {{{0, -1500, 0}, {0, 1, 0}},
                                               {{500, 300, 600}, {0, 0, 1}},
                                               {{2400, -1400, -1900}, {-1, 0, 0}},
                                               {{-2500, 100, 1990}, {1, 0, 0}}};

/* Twelve triangles that are seen from inside. */
static void test_room(void **state)
{
    const char *path = path_of(state, "room.off");
    char surfaces[300];
    write_box(path, (const double[]){2500, 1500, 2000});
    snprintf(surfaces, sizeof surfaces, "{type: mesh, file: '%s', " MATERIAL("0.5") "}", path);
    compare("all", surfaces, ROOM, LAMP, 3e-3, in_room);
    compare("2", surfaces, ROOM, LAMP, 3e-3, in_room);
}

/* Two triangles aslant in a room; one bounce from them alone, over a floor. */
static void test_plate(void **state)
{
    const char *path = path_of(state, "plate.off");
    char surfaces[500], others[500];
    put(path, "OFF\n4 1 0\n-300 -200 0\n300 -200 0\n300 200 0\n-300 200 0\n4 0 1 2 3\n");
    const char *const before[] = {ROOM, "{type: rectangle, center: [0, -1500, 0], axis: [0, 1, 0.1], up: [0, 0, 1], "
                                        "size: [100, 100], " MATERIAL("0.5") "}"};
    static const struct element below[PLACES] = {{{500, -700, 100}, {0, 1, 0.2}},
                                                 {{300, -500, 600}, {0, 0.6, -0.8}},
                                                 {{700, -1200, -300}, {0, 1, 0}},
                                                 {{0, 0, 0}, {1, 0, 0}}};
    for (int s = 0; s < 2; s++) {
        if (s == 1) /* with both sides written down */
            put(path, "OFF\n4 2 0\n-300 -200 0\n300 -200 0\n300 200 0\n-300 200 0\n4 0 1 2 3\n4 0 3 2 1\n");
        snprintf(surfaces, sizeof surfaces,
                 "%s, {type: mesh, file: '%s', rotate: [30, 0, 0], position: [500, -200, 100], " MATERIAL("0.7") "}",
                 before[s], path);
        snprintf(others, sizeof others,
                 "%s, {type: rectangle, size: [600, 400], center: [500, -200, 100], axis: [0, -0.5, "
                 "0.86602540378443864676], up: [0, 0.86602540378443864676, 0.5], " MATERIAL("0.7") "}",
                 before[s]);
        if (s == 0)
            compare("all", surfaces, others, LAMP, 1e-2, in_room);
        else
            compare("1", surfaces, others, "{type: point, position: [500, -1000, 900], intensity: 50}", 1e-2, below);
    }
}

#define SIDE(size, center, axis, up)                                                                                   \
    ", {type: rectangle, size: " size ", center: " center ", axis: " axis ", up: " up ", " MATERIAL("0.6") "}"
#define WALLS(y, height)                                                                                               \
    SIDE("[600, " height "]", "[500, " y ", 600]", "[0, 0, 1]", "[0, 1, 0]")                                           \
    SIDE("[600, " height "]", "[500, " y ", -400]", "[0, 0, 1]", "[0, 1, 0]")                                          \
    SIDE("[1000, " height "]", "[200, " y ", 100]", "[-1, 0, 0]", "[0, 1, 0]")                                         \
    SIDE("[1000, " height "]", "[800, " y ", 100]", "[-1, 0, 0]", "[0, 1, 0]")
#define LID(y) SIDE("[600, 1000]", "[500, " y ", 100]", "[0, 1, 0]", "[0, 0, 1]")

/* What a box hides: plates with the same outlines, six of them, or five where it stands on the floor. */
static void test_box(void **state)
{
    const char *path = path_of(state, "box.off");
    char surfaces[300];
    write_box(path, (const double[]){300, 400, 500});
    for (int s = 0; s < 2; s++) {
        snprintf(surfaces, sizeof surfaces,
                 ROOM ", {type: mesh, file: '%s', position: [500, %d, 100], " MATERIAL("0.6") "}", path,
                 s == 0 ? -1000 : -1100);
        compare("all", surfaces,
                s == 0 ? ROOM WALLS("-1000", "800") LID("-600") LID("-1400") : ROOM WALLS("-1100", "800") LID("-700"),
                LAMP, 2e-2, in_room);
    }
}

/* In a closed box of plates it is dark, but for light of its own, with which it is a furnace, or a lamp's. */
static void test_closed_box(void **state)
{
    static const struct element inside[] = {{{400, -1100, 100}, {0, 0, 1}}, {{300, -1390, -300}, {0.6, 0.8, 0}}};
    static const char closed[] = ROOM WALLS("-1000", "800") LID("-600") LID("-1400");
    double values[PLACES], errors[PLACES], lit[PLACES], unsure[PLACES];
    (void)state;
    probe(scene_of("all", closed, LAMP), inside, 2, 5e-2, values, errors);
    for (int i = 0; i < 2; i++)
        assert_true(values[i] == 0 && errors[i] <= DBL_MIN);
    probe(scene_of("all", closed, "{type: ambient, irradiance: 100}"), inside, 2, 5e-2, values, errors);
    for (int i = 0; i < 2; i++)
        if (!(fabs(values[i] - 150) <= errors[i]))
            fail_msg("place %d: %.10g +- %.2g, not 150", i, values[i], errors[i]);
    /* spots that light only the bottom, a narrow one between the places that are sampled first; with a lid that leaves
     * a gap the box is none, but hardly any light is lost */
    static const char *const spots[] = {
        "{type: spot, position: [500, -1000, 100], axis: [0, -1, 0], inner: 15, outer: 20, intensity: 100}",
        "{type: spot, position: [500, -1000, 100], axis: [0.02, -1, 0.07], inner: 3, outer: 4, intensity: 2000}, "
        "{type: point, position: [300, 800, 1400], intensity: 0.01}"};
    for (int s = 0; s < 2; s++) {
        ask(scene_of("all", closed, spots[s]), inside, 2, 5e-2, values, errors);
        ask(scene_of("all", ROOM WALLS("-1000", "800") LID("-599.9999") LID("-1400"), spots[s]), inside, 2, 5e-2, lit,
            unsure);
        for (int i = 0; i < 2; i++)
            if (!(values[i] > 1 && fabs(values[i] - lit[i]) <= errors[i] + unsure[i] + 1e-3 * lit[i]))
                fail_msg("spot %d, place %d: %.10g, and %.10g", s, i, values[i], lit[i]);
    }
}

/* Through a gap that is a ten thousandth of a small box light comes into it, however far away other things are. */
#define SMALL(bottom)                                                                                                  \
    "{type: rectangle, center: [0, 0, -1000], size: [2000000, 2000000], " MATERIAL("0.5") "}" SIDE(                    \
        "[10, 10]", "[-5, 0, 5]", "[1, 0, 0]", "[0, 1, 0]") SIDE("[10, 10]", "[5, 0, 5]", "[-1, 0, 0]", "[0, 1, 0]")   \
        SIDE("[10, 10]", "[0, -5, 5]", "[0, 1, 0]", "[0, 0, 1]")                                                       \
            SIDE("[10, 10]", "[0, 5, 5]", "[0, -1, 0]", "[0, 0, 1]")                                                   \
                SIDE("[10, 10]", "[0, 0, 10]", "[0, 0, 1]", "[0, 1, 0]")                                               \
                    SIDE("[10, 10]", bottom, "[0, 0, 1]", "[0, 1, 0]")

static void test_small_gap(void **state)
{
    static const struct element inside[] = {{{0, 0, 1}, {1, 0, -0.2}}};
    static const char lamp[] = "{type: point, position: [0, 0, -500], intensity: 1000}";
    double values[PLACES], errors[PLACES];
    (void)state;
    ask(scene_of("1", SMALL("[0, 0, 0]"), lamp), inside, 1, 0.5, values, errors);
    assert_true(values[0] == 0 && errors[0] <= DBL_MIN);
    ask(scene_of("1", SMALL("[0, 0, -0.001]"), lamp), inside, 1, 0.5, values, errors);
    assert_true(values[0] > errors[0] && errors[0] > 0);
}

/* Where another plate lies on a side of a box nothing says which is seen from inside: bounds hold for either. */
static void test_side_twice(void **state)
{
    static const struct element inside[] = {{{400, -800, 100}, {0, 0, 1}}, {{300, -1000, -300}, {0, 0.6, 0.8}}};
    static const char lamp[] = "{type: point, position: [450, -800, 450], intensity: 20}";
#define END(rho) ", {type: rectangle, size: [600, 800], center: [500, -900, 600], " MATERIAL(rho) "}"
#define OTHERS                                                                                                         \
    SIDE("[600, 800]", "[500, -900, -400]", "[0, 0, 1]", "[0, 1, 0]")                                                  \
    SIDE("[1000, 800]", "[200, -900, 100]", "[-1, 0, 0]", "[0, 1, 0]")                                                 \
    SIDE("[1000, 800]", "[800, -900, 100]", "[-1, 0, 0]", "[0, 1, 0]")                                                 \
    LID("-500") LID("-1300")
    double values[PLACES], errors[PLACES], lit[PLACES], unsure[PLACES];
    (void)state;
    ask(scene_of("all", ROOM END("0.1") OTHERS END("0.9"), lamp), inside, 2, 5e-2, values, errors);
    ask(scene_of("all", ROOM END("0.9") OTHERS, lamp), inside, 2, 5e-2, lit, unsure);
    for (int i = 0; i < 2; i++)
        if (!(lit[i] > 1 && fabs(values[i] - lit[i]) <= errors[i] + unsure[i]))
            fail_msg("place %d: %.10g with %.2g, and %.10g with %.2g", i, values[i], errors[i], lit[i], unsure[i]);
}

/* In uniform light E_r = E0 rho/(1 - rho) everywhere in a closed mesh, on its faces and among them, whatever stands in
 * it; of a lamp the mean is flux/(area (1 - rho)). */
static void test_furnace(void **state)
{
    const char *path = path_of(state, "ball.off");
    char mesh[200], surfaces[400];
    static const struct element inside[PLACES] = {{{600, 600, 700}, {0, -1, 0}},
                                                  {{0, 0, 0}, {0, 0, 1}},
                                                  {{-900, 700, 0}, {0.6, 0, -0.8}},
                                                  {{0, 0, -500}, {0, 0, 1}}};
    double values[PLACES], errors[PLACES];
    write_ball(path, 2);
    snprintf(mesh, sizeof mesh,
             "{type: mesh, file: '%s', scale: 2000, normals: smooth, crease: 80, " MATERIAL("0.6") "}", path);
    snprintf(surfaces, sizeof surfaces,
             "%s, {type: sphere, center: [300, 200, -800], radius: 300, " MATERIAL("0.6") "}", mesh);
    probe(scene_of("all", surfaces, "{type: ambient, irradiance: 100}"), inside, PLACES, 5e-3, values, errors);
    for (int i = 0; i < PLACES; i++)
        if (!(fabs(values[i] - 150) <= errors[i]))
            fail_msg("place %d: %.10g +- %.2g, not 150", i, values[i], errors[i]);
    luxel_settings settings;
    luxel_balance *balance;
    luxel_settings_init(&settings);
    settings.reflected_error = 1e-2;
    luxel_scene *scene = scene_of("all", mesh, "{type: point, position: [200, 100, -300], intensity: 500}");
    assert_int_equal(luxel_find_balance(scene, &settings, NULL, &balance), LUXEL_OK);
    assert_true(balance->closes);
    assert_int_equal(balance->side_count, 1);
    const double flux = 4 * M_PI * 500, mean = flux / (balance->sides[0].area_m2 * (1 - 0.6));
    assert_true(fabs(balance->sides[0].irradiance.value - mean) <= balance->sides[0].irradiance.error);
    assert_true(fabs(balance->absorbed.value - flux) <= balance->absorbed.error);
    luxel_balance_free(balance);
    luxel_scene_free(scene);
}

/* Light from a ball to a place beside it: meshes tend to it as N^-2. */
static void test_tends_to_the_ball(void **state)
{
    const struct element beside[] = {{{0, -1500, 300}, {0, 1, 0}}};
    static const char lamp[] = "{type: point, position: [0, -2500, 2000], intensity: 500}";
    double truth[PLACES], off[2], values[PLACES], errors[PLACES];
    probe(scene_of("1", "{type: sphere, center: [0, 0, 0], radius: 600, " MATERIAL("0.8") "}", lamp), beside, 1, 1e-4,
          truth, errors);
    for (int i = 0; i < 2; i++) {
        const char *path = path_of(state, "ball.off");
        char surfaces[300];
        write_ball(path, 3 << i);
        snprintf(surfaces, sizeof surfaces, "{type: mesh, file: '%s', scale: 600, " MATERIAL("0.8") "}", path);
        probe(scene_of("1", surfaces, lamp), beside, 1, 2e-3, values, errors);
        off[i] = fabs(values[0] - truth[0]) / truth[0];
    }
    if (!(off[0] < 0.2 && off[1] < off[0] / 3 && off[1] > off[0] / 6))
        fail_msg("off by %g and %g", off[0], off[1]);
}

/* A balance whose bound is missed, and why. */
static void expect_hint(luxel_scene *scene, const char *words)
{
    luxel_balance *balance = NULL;
    luxel_settings settings;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_settings_init(&settings);
    settings.reflected_error = 2e-2;
    assert_int_equal(luxel_find_balance(scene, &settings, diagnostics, &balance), LUXEL_OK);
    char *hint = luxel_diagnostics_hint(diagnostics, 0, NULL, NULL);
    assert_non_null(hint);
    assert_non_null(strstr(hint, words));
    luxel_text_free(hint);
    luxel_balance_free(balance);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

/* A plate on a floor in the very same plane, and triangles on one another: what is hidden shines too, but the bound
 * tells it.  The truth has a gap, or one of them alone. */
static void test_overlap(void **state)
{
    static const char format[] = "{type: rectangle, center: [0, 0, 0], size: [3000, 3000], " MATERIAL(
        "0.8") "}, "
               "{type: rectangle, center: [0, 0, 900], axis: [0.1, 0, 1], size: [600, 600], " MATERIAL("0.5") "}, %s";
    static const struct element under[PLACES] = {{{100, 0, 880}, {-0.1, 0, -1}},
                                                 {{900, 300, 700}, {-1, 0, 0}},
                                                 {{0, 900, 400}, {0, -0.6, -0.8}},
                                                 {{-200, -500, 300}, {0, 1, -1}}};
    const char *once = path_of(state, "once.off"), *twice = path_of(state, "twice.off");
    char on[2][300];
    put(once, "OFF\n4 1 0\n-500 -400 0\n500 -400 0\n500 400 0\n-500 400 0\n4 0 1 2 3\n");
    put(twice, "OFF\n4 4 0\n-500 -400 0\n500 -400 0\n500 400 0\n-500 400 0\n3 0 1 2\n3 0 2 3\n3 1 2 3\n3 1 3 0\n");
    for (int c = 0; c < 2; c++) {
        double values[2][PLACES], errors[2][PLACES];
        for (int k = 0; k < 2; k++) {
            char surfaces[1000];
            if (c == 0)
                snprintf(on[k], sizeof on[k],
                         "{type: rectangle, center: [0, 0, %s], size: [1000, 800], " MATERIAL("0.2") "}",
                         k ? "0.01" : "0");
            else
                snprintf(on[k], sizeof on[k], "{type: mesh, file: '%s', position: [0, 0, 50], " MATERIAL("0.4") "}",
                         k ? once : twice);
            snprintf(surfaces, sizeof surfaces, format, on[k]);
            if (k == 0)
                expect_hint(scene_of("1", surfaces, LAMP),
                            c == 0 ? "surfaces[0] and surfaces[2] lie" : "surfaces[2] and surfaces[2] lie");
            assert_int_equal(ask(scene_of("1", surfaces, LAMP), under, PLACES, 2e-2, values[k], errors[k]), k);
        }
        for (int i = 0; i < PLACES; i++)
            assert_true(fabs(values[0][i] - values[1][i]) <= errors[0][i] + errors[1][i]);
        assert_true(fabs(values[0][0] - values[1][0]) > errors[1][0]);
    }
}

/* The most triangles, and one mesh more. */
static void test_too_many(void **state)
{
    const char *path = path_of(state, "ball.off");
    char surfaces[400];
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    write_ball(path, 100);
    snprintf(surfaces, sizeof surfaces, "{type: mesh, file: '%s', " MATERIAL("0.8") "}", path);
    assert_int_equal(try_scene("none", surfaces, LAMP, diagnostics, &scene), LUXEL_OK);
    luxel_scene_free(scene);
    assert_int_equal(try_scene("all", surfaces, LAMP, diagnostics, &scene), LUXEL_ERROR_SCENE);
    char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
    assert_non_null(strstr(message, "80000 triangles"));
    luxel_text_free(message);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* Advice does not wait for the light of many triangles: that would take minutes. */
static void test_advice(void **state)
{
    const char *path = path_of(state, "ball.off");
    char surfaces[400];
    write_ball(path, 15);
    snprintf(surfaces, sizeof surfaces, ROOM ", {type: mesh, file: '%s', scale: 500, " MATERIAL("0.8") "}", path);
    luxel_scene *scene = scene_of("all", surfaces, LAMP);
    assert_int_equal(luxel_scene_advise_peak(scene, NULL), LUXEL_OK);
    luxel_scene_free(scene);
    scene = scene_of("all",
                     ROOM ", {type: cylinder, center: [900, -1000, 0], radius: 250, height: 1000, "
                          "axis: [0, 1, 0], " MATERIAL("0.8") "}",
                     "{type: planar, rectangle: {center: [0, 1400, 0], size: [1200, 300], axis: [0, -1, 0]}, "
                     "radiance: 9}");
    assert_int_equal(luxel_scene_advise_peak(scene, NULL), LUXEL_OK);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        CASE(room),    CASE(plate),   CASE(box),      CASE(closed_box),        CASE(small_gap), CASE(side_twice),
        CASE(furnace), CASE(overlap), CASE(too_many), CASE(tends_to_the_ball), CASE(advice)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * How much is done, counted: how often each search and each integral looks at the function until it has its result, in
 * scenes of every kind.  A fault in a rule of when to stop, where to begin or what to trust seldom shows in results,
 * which are found in the end; it shows here, as more work, or as less than the result should be believed for.
 *
 * The counts may differ a little between compilers and processors, by roundings that decide on which side of a limit a
 * number is.  They are no limits but what is done: when a rule is changed on purpose, LUXEL_COUNTS=print tells the new
 * ones.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/evaluator.h>
#include <luxel/exercise.h>
#include <luxel/extrema.h>
#include <luxel/isophotes.h>

#include "field/extrema.h"
#include "light/solid/facets.h"
#include "picture/cluster/cut.h"
#include "picture/patch.h"
#include "scenes.h"
#include "world/integral/cubature.h"
#include "world/integral/sweep.h"
#include "wrapped.h"

/* -- what is counted: calls between files of the library, which the linker leads through here -- */

enum { SEEN, VALUES, PIECES, EDGES, ARCS, LOOKS, SAMPLES, BOUNDS, KINDS };

static unsigned counts[KINDS];

WRAPPED(bool, lx_element_seen, const struct lx_prepared *prepared, double x_mm, double y_mm, struct lx_element *element)
{
    counts[SEEN]++;
    return REAL(lx_element_seen)(prepared, x_mm, y_mm, element);
}

WRAPPED(void, luxel_evaluate_screen, const luxel_evaluator *evaluator, double x_mm, double y_mm, luxel_value *value,
        double *shares)
{
    counts[VALUES]++;
    REAL(luxel_evaluate_screen)(evaluator, x_mm, y_mm, value, shares);
}

WRAPPED(double, lx_piece_value, struct lx_extremum_search *search, const struct lx_spot *spot, double *error)
{
    counts[PIECES]++;
    return REAL(lx_piece_value)(search, spot, error);
}

WRAPPED(double, lx_edge_distance, const struct lx_extremum_search *search, const struct lx_search_edge *edge,
        const struct lx_spot *spot)
{
    counts[EDGES]++;
    return REAL(lx_edge_distance)(search, edge, spot);
}

WRAPPED(struct lx_arc, lx_sweep_arc, const struct lx_sweep *sweep, double x)
{
    counts[ARCS]++;
    return REAL(lx_sweep_arc)(sweep, x);
}

WRAPPED(double, lx_cell_look, const struct lx_patch *patch, const struct lx_cell *cell, const double element[3],
        double middle[3])
{
    counts[LOOKS]++;
    return REAL(lx_cell_look)(patch, cell, element, middle);
}

WRAPPED(void, lx_cell_samples, const struct lx_patch *patch, const struct lx_cell *cell, unsigned side, double gain,
        size_t first, struct lx_samples_double *samples)
{
    counts[SAMPLES]++;
    REAL(lx_cell_samples)(patch, cell, side, gain, first, samples);
}

WRAPPED(void, lx_round_samples, const struct lx_patch *patch, double from_s, double to_s, unsigned rings,
        unsigned spokes, double off, double gain, struct lx_samples_double *samples)
{
    counts[SAMPLES]++;
    REAL(lx_round_samples)(patch, from_s, to_s, rings, spokes, off, gain, samples);
}

WRAPPED(struct lx_share_bound, lx_bound_cluster, const struct lx_receiver_region *region, const double anchor_mm[3],
        const struct lx_lobe_limits *limits, const struct lx_tree *tree, const struct lx_cluster *cluster,
        const struct lx_cluster_turn *turn, bool is_hidden)
{
    counts[BOUNDS]++;
    return REAL(lx_bound_cluster)(region, anchor_mm, limits, tree, cluster, turn, is_hidden);
}

/* -- the scenes -- */

struct view {
    luxel_scene *scene;
    luxel_evaluator *evaluator;
    luxel_field *field;
    luxel_settings settings;
};

#define SCREEN "luxel: 1\nscreen: {width: 800, height: 640, resolution: [400, 320]}\nobserver: {z: 2500, "
#define PLATE(axis)                                                                                                    \
    "{type: rectangle, center: [30, -20, 900], size: [500, 380], axis: " axis                                          \
    ", material: {diffuse: 0.6, specular: 0.5, shininess: 60, highlight: gated}}"
#define BALL(center, material)                                                                                         \
    "{type: sphere, center: " center ", radius: 130, material: {diffuse: 0.6, specular: 0.5, " material "}}"
#define NEAR_LIGHT "{type: point, position: [300, 200, 1500], intensity: 5}"
#define FAR_LIGHT "{type: distant, direction: [-0.3, 0.2, -1], irradiance: 4}"

#define OPENING "{type: luminaire, file: 'builtin:office-lamp.ies', position: [200, 90, 2400], opening: file}"
#define UNDER_OPENING                                                                                                  \
    SCREEN "projection: orthographic}\nsurfaces: [" PLATE(                                                             \
        "[0, 0, 1]") "]\n"                                                                                             \
                     "lights: [{type: ambient, irradiance: 9}, " OPENING "]\n"

/* A text, a built-in scene, or the variant of this number, with a value changed. */
static struct view view_of(const char *name, unsigned resolution, const char *set)
{
    char assignment[100];
    snprintf(assignment, sizeof assignment, "screen.resolution=[%u,%u]", resolution, resolution * 4 / 5);
    const char *const changes[] = {assignment, "screen.height=640", "screen.width=800", set};
    struct view view = {.scene = opened_with(name, changes, 4)};
    luxel_settings_init(&view.settings);
    view.settings.threads = 1;
    return view;
}

static void look_at(struct view *view)
{
    assert_int_equal(luxel_evaluator_new(view->scene, &view->settings, NULL, &view->evaluator), LUXEL_OK);
    assert_int_equal(luxel_render(view->scene, &view->settings, NULL, &view->field), LUXEL_OK);
}

static void clear(struct view *view)
{
    luxel_field_free(view->field);
    luxel_evaluator_free(view->evaluator);
    luxel_scene_free(view->scene);
}

/* -- what is done -- */

static void find_extrema(struct view *view)
{
    luxel_extrema extrema;
    look_at(view);
    memset(counts, 0, sizeof counts);
    assert_int_equal(luxel_find_extrema(view->evaluator, view->field, NULL, NULL, &extrema), LUXEL_OK);
    const luxel_region circle = {.type = LUXEL_REGION_CIRCLE, .center_mm = {60, 30}, .radius_mm = 120};
    assert_int_equal(luxel_find_extrema(view->evaluator, view->field, &circle, NULL, &extrema), LUXEL_OK);
    const luxel_region strip = {.type = LUXEL_REGION_RECTANGLE, .center_mm = {-40, 25}, .size_mm = {270, 90}};
    assert_int_equal(luxel_find_extrema(view->evaluator, view->field, &strip, NULL, &extrema), LUXEL_OK);
}

static void find_isophotes(struct view *view)
{
    double levels[16], most;
    luxel_isophotes *lines;
    look_at(view);
    most = luxel_field_statistics(view->field)->maximum.value;
    size_t count = luxel_round_levels(0, most, false, 7, levels, 16);
    memset(counts, 0, sizeof counts);
    assert_int_equal(luxel_find_isophotes(view->field, view->evaluator, levels, count, NULL, &lines), LUXEL_OK);
    luxel_isophotes_free(lines);
}

static void render(struct view *view)
{
    memset(counts, 0, sizeof counts);
    assert_int_equal(luxel_render(view->scene, &view->settings, NULL, &view->field), LUXEL_OK);
}

static void render_in_double(struct view *view)
{
    view->settings.precision = LUXEL_DOUBLE;
    render(view);
}

static void render_with_least(struct view *view)
{
    view->settings.minimum_reached = true;
    render(view);
}

static void render_irradiance(struct view *view)
{
    view->settings.quantity = LUXEL_IRRADIANCE;
    render(view);
}

static void find_extrema_of_irradiance(struct view *view)
{
    view->settings.quantity = LUXEL_IRRADIANCE;
    find_extrema(view);
}

static void find_isophotes_of_irradiance(struct view *view)
{
    view->settings.quantity = LUXEL_IRRADIANCE;
    find_isophotes(view);
}

static void render_by_clusters(struct view *view)
{
    view->settings.light_error = 0.01;
    render(view);
}

static void render_by_clusters_in_double(struct view *view)
{
    view->settings.precision = LUXEL_DOUBLE;
    render_by_clusters(view);
}

struct job {
    void (*run)(struct view *view);
    const char *scene;
    unsigned resolution;
    const char *set;
    unsigned counts[KINDS];
};

static const struct job jobs[] = {
    {find_extrema, "1", 40, NULL, {1138, 38, 1030, 4294}},
    {find_extrema, "2", 40, NULL, {1151, 42, 1621, 8786}},
    {find_extrema, "3", 40, NULL, {1141, 22, 2931, 21554}},
    {find_extrema, "4", 40, NULL, {1124, 33, 352, 1497}},
    {find_extrema, "5", 40, NULL, {1129, 33, 556, 1049}},
    {find_extrema, "6", 40, NULL, {1143, 18, 539, 1374}},
    {find_extrema, "7", 40, NULL, {1139, 42, 746, 2590}},
    {find_extrema, "8", 40, NULL, {1143, 41, 818, 4359}},
    {find_extrema, "9", 40, NULL, {1152, 35, 3196, 20900}},
    {find_extrema, "10", 40, NULL, {1130, 33, 881, 3309}},
    {find_extrema, "11", 40, NULL, {1152, 52, 645, 3990}},
    {find_extrema, "12", 40, NULL, {1156, 30, 2377, 11482}},
    {find_extrema, "13", 40, NULL, {1131, 35, 503, 1309}},
    {find_extrema, "14", 40, NULL, {1132, 41, 983, 5435}},
    {find_extrema, "15", 40, NULL, {1160, 55, 10472, 81618}},
    {find_extrema, "16", 40, NULL, {1152, 42, 1659, 9486}},
    {find_extrema, "17", 40, NULL, {1137, 38, 603, 1989}},
    {find_extrema, "18", 40, NULL, {1151, 41, 3313, 18131}},
    {find_extrema, "19", 40, NULL, {1131, 34, 869, 4125}},
    {find_extrema, "20", 40, NULL, {1137, 42, 1546, 9450}},
    {find_extrema, "report", 40, NULL, {1148, 42, 803, 3480}},
    {find_extrema, "spot", 40, NULL, {1174, 35, 972, 3949}},
    {find_extrema, "two-spheres", 40, NULL, {3128, 1187, 2275, 4160}},
    {find_extrema, "three-lights", 40, NULL, {1174, 40, 1851, 9585}},
    {find_extrema, "distant", 40, NULL, {1159, 43, 1062, 4978}},
    {find_extrema, "desk", 40, NULL, {2015, 371, 2003, 9264}},
    {find_extrema, "spot", 40, "lights[0].falloff=hard", {1169, 35, 1428, 6093}},
    {find_extrema, "spot", 40, "lights[0].falloff=linear", {1175, 36, 1001, 4174}},
    {find_extrema, "spot", 40, "surfaces[0].material.model=phong", {1174, 35, 904, 3395}},
    {find_extrema, "spot", 40, "observer.projection=orthographic", {1163, 31, 954, 1731}},
    {find_extrema, "two-spheres", 40, "observer.projection=perspective", {4014, 2584, 2205, 1373}},
    {find_extrema, "two-spheres", 40, "shadows=none", {2530, 612, 2192, 4160}},
    {find_extrema, "three-lights", 40, "surfaces[0].material.highlight=gated", {1176, 40, 1846, 9655}},
    {find_extrema, "three-lights", 40, "surfaces[0].material.shininess=3000", {1167, 34, 3246, 21669}},
    {find_extrema, "three-lights", 40, "surfaces[0].center=[90,-200,1000]", {1186, 34, 8565, 62436}},
    {find_extrema, "desk", 40, "observer.projection=orthographic", {2470, 734, 4371, 26750}},
    {find_extrema, "desk", 40, "surfaces[0].material.model=blinn-phong", {2015, 371, 2029, 9587}},
    {find_extrema, "desk", 40, "lights[0].falloff=hard", {2015, 371, 2003, 9538}},
    {find_extrema, "window", 20, NULL, {223, 32, 180, 577, 141015}},
    {find_extrema, "tube", 20, NULL, {224, 41, 194, 941, 48884}},
    {find_extrema, "lampshade", 20, NULL, {329, 34, 174, 1708}},
    {find_isophotes, "1", 40, NULL, {6363, 2355}},
    {find_isophotes, "2", 40, NULL, {5516, 2057}},
    {find_isophotes, "5", 40, NULL, {5564, 1378}},
    {find_isophotes, "9", 40, NULL, {4857, 2936}},
    {find_isophotes, "report", 50, NULL, {7898, 1552}},
    {find_isophotes, "spot", 50, NULL, {8285, 4573}},
    {find_isophotes, "two-spheres", 50, NULL, {27805, 9711}},
    {find_isophotes, "three-lights", 50, NULL, {9499, 2556}},
    {find_isophotes, "distant", 50, NULL, {11362, 3339}},
    {find_isophotes, "desk", 50, NULL, {22325, 4938}},
    {find_isophotes, "spot", 50, "lights[0].falloff=hard", {12448, 8072}},
    {find_isophotes, "two-spheres", 50, "screen.sampling=nodes", {13516, 4699}},
    {find_isophotes, "two-spheres", 50, "observer.projection=perspective", {15841, 10396}},
    {find_isophotes, "desk", 50, "observer.projection=orthographic", {21994, 6879}},
    {find_isophotes, "desk", 50, "surfaces[1].center=[240,210,1000]", {7428, 2902}},
    {render, "window", 60, NULL, {0, 0, 0, 0, 0, 802, 1990}},
    {render, "tube", 60, NULL, {0, 0, 0, 0, 0, 63200, 11903}},
    {render, "ball-lamp", 60, NULL, {0, 0, 0, 0, 0, 19808, 4239}},
    {render, "disk-lamp", 60, NULL, {0, 0, 0, 0, 0, 1699, 4840}},
    {render, "box-lamp", 60, NULL, {0, 0, 0, 0, 0, 1213, 3193}},
    {render, "all-sources", 60, NULL, {0, 0, 0, 0, 0, 26446, 7345}},
    {render, "window", 60, "surfaces[0].material.model=phong", {0, 0, 0, 0, 0, 650, 2431}},
    {render, "all-sources", 60, "lights[7].attenuation=none", {0, 0, 0, 0, 0, 26446, 7197}},
    {render, "ball-lamp", 60, "surfaces[0].material.highlight=gated", {0, 0, 0, 0, 0, 19296, 4179}},
    {render, "disk-lamp", 60, "surfaces[0].material.shininess=0.6", {0, 0, 0, 0, 0, 15435, 61298}},
    {render_by_clusters, "window", 60, "lights[0].parts=40", {0, 0, 0, 0, 0, 0, 0, 26786}},
    {render_by_clusters, "tube", 60, "lights[0].parts=20", {0, 0, 0, 0, 0, 0, 0, 19366}},
    {render_by_clusters, "ball-lamp", 60, "lights[0].parts=40", {0, 0, 0, 0, 0, 0, 0, 33018}},
    {render_by_clusters, "all-sources", 60, "lights[4].parts=40", {0, 0, 0, 0, 0, 40061, 6714, 28212}},
    {render_in_double, "window", 30, NULL, {0, 0, 0, 0, 0, 304, 779}},
    {render_in_double, "all-sources", 20, NULL, {0, 0, 0, 0, 0, 6850, 2217}},
    {render_in_double, "ball-lamp", 20, "surfaces[0].material.shininess=0.6", {0, 0, 0, 0, 0, 165248, 41239}},
    {render_in_double, "all-sources", 20, "lights[5].attenuation=none", {0, 0, 0, 0, 0, 6826, 2187}},
    {render_irradiance, "all-sources", 30, "lights[6].attenuation=none", {0}},
    {find_extrema_of_irradiance, "spot", 40, NULL, {1189, 50, 1098, 5536}},
    {find_extrema_of_irradiance, "two-spheres", 40, NULL, {3294, 1731, 2217, 2948}},
    {find_extrema_of_irradiance, "desk", 40, NULL, {1992, 612, 2463, 12584}},
    {find_extrema_of_irradiance, "window", 40, NULL, {1159, 50, 1210, 6403, 18901}},
    {find_isophotes_of_irradiance, "desk", 40, NULL, {20976, 4347}},
    {find_isophotes_of_irradiance, "three-lights", 40, "observer.projection=perspective", {1903, 1903}},
    {find_isophotes_of_irradiance, "tube", 20, NULL, {5355, 1041, 0, 0, 113462}},
    {find_extrema,
     SCREEN "projection: perspective}\nsurfaces: [" PLATE("[0.2, -0.3, 1]") "]\nlights: [" NEAR_LIGHT "]\n",
     40,
     NULL,
     {1137, 53, 2845, 17696}},
    {find_extrema,
     SCREEN "projection: perspective}\nsurfaces: [" PLATE("[0.2, -0.3, 1]") "]\nlights: [" FAR_LIGHT "]\n",
     40,
     NULL,
     {1129, 50, 2718, 16292}},
    {find_extrema,
     SCREEN "projection: orthographic}\nsurfaces: [" PLATE("[0.2, -0.3, 1]") "]\nlights: [" NEAR_LIGHT "]\n",
     40,
     NULL,
     {1136, 52, 2571, 16362}},
    {find_extrema,
     SCREEN "projection: orthographic}\nsurfaces: [" PLATE("[0.2, -0.3, 1]") "]\nlights: [" FAR_LIGHT "]\n",
     40,
     NULL,
     {4634, 3456, 2496}},
    {find_extrema,
     SCREEN "projection: perspective}\nsurfaces: [" PLATE("[0, 0, 1]") "]\nlights: [" NEAR_LIGHT ", " FAR_LIGHT "]\n",
     40,
     NULL,
     {1134, 44, 4031, 48274}},
    {find_extrema,
     SCREEN "projection: perspective}\nshadows: points\nsurfaces: [" PLATE("[0, 0.1, 1]") ", " BALL(
         "[60, 20, 1100]", "shininess: 30") "]\nlights: [" NEAR_LIGHT ", " FAR_LIGHT "]\n",
     40,
     NULL,
     {1507, 63, 955, 5507}},
    {find_isophotes,
     SCREEN "projection: orthographic}\nshadows: points\nsurfaces: [" PLATE("[0, 0.1, 1]") ", " BALL(
         "[60, 20, 1100]", "shininess: 30") "]\nlights: [" NEAR_LIGHT ", " FAR_LIGHT "]\n",
     40,
     NULL,
     {11771, 2622}},
    {find_extrema,
     SCREEN "projection: orthographic}\nshadows: points\nsurfaces: [" BALL(
         "[-160, 20, 1100]",
         "shininess: 30, model: phong, "
         "highlight: gated") ", " BALL("[130, -20, 1000]",
                                       "shininess: 200, highlight: cosine") "]\nlights: [" NEAR_LIGHT ", " FAR_LIGHT
                                                                            "]\n",
     40,
     NULL,
     {1738, 20, 746, 1252}},
    {find_extrema,
     SCREEN "projection: perspective}\nsurfaces: [" BALL(
         "[-60, 20, 1100]", "shininess: 30, model: phong") "]\nlights: ["
                                                           "{type: point, position: [-900, 300, 700], intensity: 5, "
                                                           "pattern: cosine, exponent: 3, aim: [0, 100, 1000]}"
                                                           "]\n",
     40,
     NULL,
     {1181, 40, 402, 1214}},
    {find_extrema,
     SCREEN "projection: perspective}\nsurfaces: [" PLATE(
         "[0, 0.1, 1]") "]\nlights: ["
                        "{type: spot, position: [0, 300, 1900], intensity: 5, aim: [60, 0, 900], inner: 3, outer: 5, "
                        "falloff: hard}, " FAR_LIGHT "]\n",
     40,
     NULL,
     {1130, 34, 1394, 7374}},
    {find_isophotes,
     SCREEN "projection: perspective}\nsurfaces: [" PLATE(
         "[0, 0.1, 1]") "]\nlights: ["
                        "{type: spot, position: [0, 300, 1900], intensity: 5, aim: [60, 0, 900], inner: 3, outer: 5, "
                        "falloff: hard}, " FAR_LIGHT "]\n",
     40,
     NULL,
     {7030, 5058}},
    {find_extrema,
     SCREEN "projection: orthographic}\nsurfaces: [" BALL(
         "[20, 20, 900]", "shininess: 3, highlight: gated") "]\nlights: ["
                                                            "{type: distant, direction: [1, 0.2, 0.1], irradiance: 3}, "
                                                            "{type: distant, direction: [-1, 0.1, 0], irradiance: 2}"
                                                            "]\n",
     40,
     NULL,
     {1145, 38, 692, 1279}},
    {find_extrema, "window", 20, "lights[0].parts=9", {358, 37, 219, 1749}},
    {find_extrema, "window", 20, "lights[0].parts=6", {1789, 46, 7517, 158435}},
    {render_by_clusters_in_double, "window", 60, "lights[0].parts=40", {0, 0, 0, 0, 0, 0, 0, 26786}},
    {render, "lampshade", 30, "lights[0].parts=converged", {0, 0, 0, 0, 0, 901, 3105}},
    {render_in_double, "lampshade", 20, "lights[0].parts=converged", {0, 0, 0, 0, 0, 520, 1630}},
    {render,
     SCREEN "projection: orthographic}\nsurfaces: [" BALL(
         "[0, 0, 900]", "shininess: 20") "]\nlights: [{type: planar, rectangle: {center: [500, 400, 1400], "
                                         "size: [270, 200], aim: [0, 0, 900]}, radiance: 80}]\n",
     60,
     "surfaces[0].radius=300",
     {0, 0, 0, 0, 0, 222, 765}},
    /* a luminous opening, and whether any of its light arrives, which needs few digits */
    {render_with_least, UNDER_OPENING, 20, NULL, {0, 0, 0, 0, 24477}},
};

/* -- integrals over sources of every kind, seen by elements that stand and are seen in many ways -- */

enum { SOURCES = 4, MODELS = 2, ELEMENTS = 40 };

/* Points looked at, of each kind of source and model of the highlight. */
static const unsigned points[SOURCES][MODELS] = {
    {210542, 280278}, {173581, 216959}, {212635, 344908}, {315859, 393112}};

static struct lx_emitter source_of(int kind)
{
    struct lx_emitter source = {
        .type = (enum lx_emitter_type)(LX_FACETS + kind),
        .radiance = lx_exact(1),
        .center_mm = {120, -90, 800},
        .axis = lx_unit3(lx_exact3((const double[]){0.3, 0.2, -1})),
        .radius_mm = 260,
        .height_mm = 500,
    };
    if (source.type == LX_FACETS)
        source.facets = lx_facets_of_rectangle(source.center_mm, (const double[]){400, 300},
                                               (const double[]){0.3, 0.2, -1}, (const double[]){0, 1, 0});
    return source;
}

static unsigned points_of(int kind, int model)
{
    struct lx_emitter source = source_of(kind);
    size_t sum = 0;
    for (int i = 0; i < ELEMENTS; i++) {
        const double turn = 2.4 * i, lean = 0.03 * i, from = 0.02 * i + 0.1;
        const double exponents[] = {0.7, 3, 20, 90, 1000};
        struct lx_lobe lobe = {.model = (enum lx_model)model,
                               .highlight = (enum lx_highlight)(i % 3),
                               .diffuse = lx_exact(0.5),
                               .specular = lx_exact(1),
                               .exponent = exponents[i % 5]};
        struct lx_element element = {
            .place_mm = lx_exact3((const double[]){3.0 * i, -2.0 * i, 0}),
            .normal = lx_unit3(lx_exact3((const double[]){lean * cos(turn), lean * sin(turn), 1})),
            .view = lx_unit3(lx_exact3((const double[]){from * sin(turn), -from * cos(turn), 1})),
            .lobe = &lobe,
        };
        source.attenuation = (enum lx_attenuation)(i % 4 % 3);
        source.k_mm = 400;
        sum += lx_integrate(&source, &element, NULL, i % 2, 0, 1e-7, NULL).parts;
    }
    lx_facets_free(source.facets);
    return (unsigned)sum;
}

/* -- held against the tables -- */

/* Whether a count is what it was, but for roundings. */
static bool is_as_before(unsigned found, unsigned expected)
{
    const unsigned apart = found > expected ? found - expected : expected - found;
    return apart <= expected / 400;
}

static bool prints(void)
{
    const char *wish = getenv("LUXEL_COUNTS");
    return wish && strcmp(wish, "print") == 0;
}

static void searches_and_pictures(void **state)
{
    unsigned wrong = 0;
    (void)state;
    for (size_t i = 0; i < sizeof jobs / sizeof *jobs; i++) {
        const struct job *job = &jobs[i];
        struct view view = view_of(job->scene, job->resolution, job->set);
        bool same = true;
        job->run(&view);
        for (int k = 0; k < KINDS; k++)
            same = same && is_as_before(counts[k], job->counts[k]);
        wrong += !same;
        if (!same || prints()) {
            char text[200] = "";
            for (int k = 0; k < KINDS; k++)
                snprintf(text + strlen(text), sizeof text - strlen(text), "%s%u", k ? ", " : "", counts[k]);
            print_message("# %s %zu, %.*s%s%s: {%s}\n", same ? "job" : "changed: job", i,
                          (int)strcspn(job->scene, "\n"), job->scene, job->set ? ", " : "", job->set ? job->set : "",
                          text);
        }
        clear(&view);
    }
    assert_int_equal(wrong, 0);
}

static void integrals(void **state)
{
    unsigned wrong = 0;
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++)
        for (int model = 0; model < MODELS; model++) {
            unsigned found = points_of(kind, model);
            bool same = is_as_before(found, points[kind][model]);
            wrong += !same;
            if (!same || prints())
                print_message("# %s source %d, model %d: %u\n", same ? "of" : "changed: of", kind, model, found);
        }
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(searches_and_pictures),
        cmocka_unit_test(integrals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

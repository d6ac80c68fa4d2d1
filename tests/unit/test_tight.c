/* SPDX-License-Identifier: MIT */
/*
 * How tight bounds are.  That a bound holds is tested elsewhere, and a bound that is ten times too large holds as well;
 * one that lost a term holds nearly everywhere.  So bounds of every kind are summed up here over many random cases: how
 * many are nothing or without end, and the mean of their logarithms, next to those of the values that they belong to.
 *
 * Where a bound is changed on purpose, LUXEL_BOUNDS=print tells the new numbers.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "extended_sources.h"
#include "light/gauss.h"
#include "light/solid/facets.h"
#include "light/solid/facets_contour.h"
#include "light/solid/facets_plain.h"
#include "light/solid/rim.h"
#include "material/lobe.h"
#include "picture/cluster/cut.h"
#include "picture/plan_make.h"
#include "picture/shader.h"
#include "random_scenes.h"
#include "world/camera.h"
#include "world/integral/cubature.h"
#include "world/reference.h"
#include "wrapped.h"

/* Some numbers that are not negative. */
struct tally {
    unsigned none, endless, some;
    double mean; /* of the logarithms of those that are neither 0 nor infinite; their sum while it is made */
};

static void add(struct tally *tally, double number)
{
    if (number == 0) {
        tally->none++;
    } else if (!(number < HUGE_VAL)) {
        tally->endless++;
    } else {
        tally->some++;
        tally->mean += log(fabs(number));
    }
}

/* Numbers with their bounds. */
struct pair {
    struct tally value, error;
};

static void add_pair(struct pair *pair, lx_bounded number)
{
    add(&pair->value, number.value);
    add(&pair->error, number.error);
}

static void add_vector(struct pair *pair, lx_bounded3 vector)
{
    add_pair(pair, vector.x), add_pair(pair, vector.y), add_pair(pair, vector.z);
}

/* Whether numbers that were summed up are what they were, but for how functions of the C library round. */
static bool is_as_before(struct tally *found, const struct tally *expected, const char *what, size_t i)
{
    const char *wish = getenv("LUXEL_BOUNDS");
    found->mean /= fmax(found->some, 1);
    bool same = found->none == expected->none && found->endless == expected->endless && found->some == expected->some &&
                fabs(found->mean - expected->mean) <= 2e-5;
    if (!same || (wish && strcmp(wish, "print") == 0))
        print_message("# %s%s %zu: {%u, %u, %u, %.6f}\n", same ? "" : "changed: ", what, i, found->none, found->endless,
                      found->some, found->mean);
    return same;
}

static void expect(struct tally *found, const struct tally *expected, size_t count, const char *what)
{
    unsigned wrong = 0;
    for (size_t i = 0; i < count; i++)
        wrong += !is_as_before(&found[i], &expected[i], what, i);
    assert_int_equal(wrong, 0);
}

/* A vector of which each component may be off. */
static lx_bounded3 doubtful(lx_bounded3 vector, double error)
{
    vector.x.error += error, vector.y.error += error, vector.z.error += error;
    return vector;
}

static lx_bounded3 random_unit(struct randomness *random)
{
    double v[3];
    random_direction(random, v);
    return lx_unit3(lx_exact3(v));
}

/* -- closed forms of extended sources -- */

static const double center[3] = {30, -20, 600};

/* From next to the source to far away; every third one is not quite known. */
static struct lx_element random_element(struct randomness *random, int i, const struct lx_lobe *lobe)
{
    struct lx_element element = {.normal = random_unit(random), .view = random_unit(random), .lobe = lobe};
    double place[3] = {30, -20, 600}, way[3], away = 260 + logarithmic(random, 0.1, i % 8 == 6 ? 1e10 : 1e5);
    random_direction(random, way);
    for (int k = 0; k < 3; k++)
        place[k] += away * way[k];
    element.place_mm = lx_exact3(place);
    /* most face the source, some at a grazing angle */
    if (i % 4) {
        const double lean = i % 4 == 1 ? 1 : logarithmic(random, 1e-6, 1), against = i % 8 == 1 ? 1 : lean;
        element.normal = lx_scale3(element.normal, lean);
        element.normal = lx_unit3(lx_sub3(element.normal, lx_scale3(lx_exact3(way), against)));
    }
    if (i % 8 == 6) { /* the horizon cuts the source, or leaves a sliver of it */
        const double above = (i % 16 == 6 ? uniform(random, 0, 2) : logarithmic(random, 1e-13, 1)) - 1;
        element.normal = lx_unit3(lx_cross3(element.normal, lx_exact3(way)));
        element.normal = lx_unit3(lx_sub3(element.normal, lx_scale3(lx_exact3(way), above * 150 / away)));
    }
    if (i % 3 == 0) {
        element.place_mm = doubtful(element.place_mm, 1e-6);
        element.normal = doubtful(element.normal, 1e-9);
        element.view = doubtful(element.view, 1e-8);
    }
    return element;
}

/* The greatest place . direction over a source. */
static double top_of(const struct lx_emitter *source, const double n[3])
{
    const double axis[3] = {source->axis.x.value, source->axis.y.value, source->axis.z.value};
    double along = 0, top = 0;
    for (int k = 0; k < 3; k++)
        along += n[k] * axis[k], top += n[k] * source->center_mm[k];
    double across = source->radius_mm * sqrt(fmax(1 - along * along, 0));
    if (source->type != LX_FACETS)
        return top + (source->type == LX_BALL ? source->radius_mm : across) +
               (source->type == LX_CYLINDER ? source->height_mm / 2 * fabs(along) : 0);
    top = -HUGE_VAL;
    for (size_t i = 0; i < source->facets->corner_count; i++) {
        const lx_wide3 *corner = &source->facets->corners_mm[i];
        top = fmax(top, n[0] * corner->x.high + n[1] * corner->y.high + n[2] * corner->z.high);
    }
    return top;
}

/* Raises an element until no more than a sliver of the source is above its horizon. */
static void raise_element(struct randomness *random, const struct lx_emitter *source, struct lx_element *element)
{
    double n[3], place[3] = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value},
                 above = 0;
    random_direction(random, n);
    for (int k = 0; k < 3; k++)
        above -= n[k] * place[k];
    above += top_of(source, n) - logarithmic(random, 1e-9, 10);
    for (int k = 0; k < 3; k++)
        place[k] += above * n[k];
    element->place_mm = lx_exact3(place);
    element->normal = lx_unit3(lx_exact3(n));
}

/* What closed forms are made of; the rest of their bounds is hidden behind the rounding to float64. */
enum {
    CONTOUR_SUM,
    CONTOUR_ERROR,
    CORNERS_ERROR,
    LOW_SUM,
    LOW_ERROR,
    CUT,
    CUT_BOUND,
    SIDE,
    SIDE_BOUND,
    ROUND_SUM,
    ROUND_SIZE,
    PANELS,
    PLAIN_SUM,
    PLAIN_ERROR,
    WITHIN
};

static struct tally within[WITHIN];

WRAPPED(void, lx_contour_add, struct lx_contour *contour, unsigned from, unsigned to, double corner_error_mm)
{
    REAL(lx_contour_add)(contour, from, to, corner_error_mm);
    add(&within[CONTOUR_SUM], contour->sum.high);
    add(&within[CONTOUR_ERROR], contour->error);
    add(&within[CORNERS_ERROR], contour->corners_error);
}

WRAPPED(void, lx_plain_add, struct lx_plain_contour *contour, unsigned from, unsigned to)
{
    REAL(lx_plain_add)(contour, from, to);
    add(&within[PLAIN_SUM], contour->sum.value);
    add(&within[PLAIN_ERROR], contour->sum.error);
}

WRAPPED(void, lx_contour_add_low, const struct lx_contour *contour, unsigned from, unsigned to, struct lx_low_area *low)
{
    REAL(lx_contour_add_low)(contour, from, to, low);
    add(&within[LOW_SUM], low->failed ? 0 : low->sum.high);
    add(&within[LOW_ERROR], low->failed ? HUGE_VAL : low->error);
}

WRAPPED(double, lx_cut_disk_integral, const struct lx_rim *rim, const struct lx_horizon *horizon, double *relative)
{
    double found = REAL(lx_cut_disk_integral)(rim, horizon, relative);
    add(&within[CUT], found);
    add(&within[CUT_BOUND], *relative);
    return found;
}

WRAPPED(double, lx_side_integral, const struct lx_rim rims[2], const struct lx_horizon horizons[2], double *relative)
{
    double found = REAL(lx_side_integral)(rims, horizons, relative);
    add(&within[SIDE], found);
    add(&within[SIDE_BOUND], *relative);
    return found;
}

WRAPPED(void, lx_add_disk, struct lx_wide_sum *sum, const struct lx_rim *rim, const struct lx_horizon *horizon)
{
    REAL(lx_add_disk)(sum, rim, horizon);
    add(&within[ROUND_SUM], sum->value.high);
    add(&within[ROUND_SIZE], sum->size);
}

WRAPPED(void, lx_add_cylinder, struct lx_wide_sum *sum, lx_wide rho, lx_wide middle, lx_wide radius,
        lx_wide half_height, lx_wide3 normal)
{
    REAL(lx_add_cylinder)(sum, rho, middle, radius, half_height, normal);
    add(&within[ROUND_SUM], sum->value.high);
    add(&within[ROUND_SIZE], sum->size);
}

WRAPPED(double, lx_panel_end, double from, double to, const struct lx_pole poles[], int count)
{
    double end = REAL(lx_panel_end)(from, to, poles, count);
    add(&within[PANELS], end - from);
    return end;
}

static const struct tally within_before[WITHIN] = {
    {985, 0, 5380, -19.089935}, {985, 0, 5380, -74.767876}, {2077, 0, 4288, -74.263902}, {97, 0, 136, -79.950148},
    {8, 0, 225, -114.028630},   {0, 0, 116, -53.596001},    {0, 0, 116, -31.750604},     {11, 0, 45, -51.577131},
    {0, 0, 56, -31.683041},     {158, 0, 1425, -11.218991}, {158, 0, 1425, -1.198302},   {0, 0, 4466, -3.657577},
    {0, 0, 8908, -6.424834},    {0, 871, 8037, -37.019091},
};

static const struct tally closed_forms_before[SOURCES][2] = {
    {{345, 0, 255, -14.330149}, {344, 0, 256, -32.403732}}, {{64, 0, 536, -12.309485}, {64, 0, 536, -31.266967}},
    {{68, 0, 532, -11.570422}, {67, 0, 533, -30.566085}},   {{37, 0, 563, -11.294968}, {36, 0, 564, -30.539148}},
    {{340, 0, 260, -10.465157}, {338, 0, 262, -35.207720}}, {{49, 0, 551, -11.798876}, {48, 0, 552, -36.511803}},
    {{42, 0, 558, -11.279902}, {42, 0, 558, -34.885453}},
};

static void closed_forms(void **state)
{
    static struct pair sums[SOURCES];
    struct randomness random = {.state = 31};
    struct lx_lobe lobe = lx_lobe_irradiance();
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct lx_emitter source = source_of(kind, center, 1, 300);
        for (int i = 0; i < 600; i++) {
            struct lx_element element = random_element(&random, i, &lobe);
            if (i % 8 == 2)
                raise_element(&random, &source, &element);
            if (!lx_extended_touches(&source, element.place_mm))
                add_pair(&sums[kind], lx_extended_irradiance(&source, element.place_mm, element.normal));
        }
        lx_facets_free(source.facets);
    }
    expect(&sums[0].value, closed_forms_before[0], 2 * SOURCES, "source");
    expect(within, within_before, WITHIN, "within");
}

/* How near a place must be to be taken for one of the source: bisected above a place of its surface. */
static const struct tally touching_before[SOURCES] = {
    {0, 0, 40, -21.629615}, {0, 0, 40, -20.498976}, {0, 0, 40, -20.417716}, {0, 0, 40, -25.280050},
    {0, 0, 40, -19.299786}, {0, 0, 40, -19.369628}, {0, 0, 40, -19.319104},
};

static void touching(void **state)
{
    static struct tally reach[SOURCES];
    struct randomness random = {.state = 32};
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct lx_emitter source = source_of(kind, center, 1, 300);
        const double axis[3] = {source.axis.x.value, source.axis.y.value, source.axis.z.value};
        const double upright[3] = {0, 0, 1};
        const double from_middle[SOURCES] = {0, 50, 150, 200, 0, 150, 200};
        for (int i = 0; i < 40; i++) {
            double way[3], place[3], low = -40, high = 3;
            random_direction(&random, way);
            for (int k = 0; k < 3 && kind != BALL; k++)
                way[k] = kind == BOX || kind == GLOBE ? upright[k] : axis[k];
            for (int step = 0; step < 50; step++) {
                double middle = (low + high) / 2;
                for (int k = 0; k < 3; k++)
                    place[k] = source.center_mm[k] + (from_middle[kind] + exp(middle)) * way[k];
                lx_bounded3 at = doubtful(lx_exact3(place), i % 2 ? 1e-6 * i : 0);
                *(lx_extended_touches(&source, at) ? &low : &high) = middle;
            }
            add(&reach[kind], exp(low));
        }
        lx_facets_free(source.facets);
    }
    expect(reach, touching_before, SOURCES, "reach of source");
}

static const struct tally integrals_before[SOURCES][4] = {
    {{48, 0, 12, -10.824247}, {48, 0, 12, -33.446110}, {41, 0, 19, -62.625445}, {40, 0, 20, -111.796920}},
    {{34, 0, 26, -6.712897}, {34, 0, 26, -28.753702}, {22, 0, 38, -53.733174}, {20, 0, 40, -103.446457}},
    {{36, 0, 24, -5.156414}, {36, 0, 24, -27.883672}, {26, 0, 34, -77.384521}, {22, 0, 38, -157.848395}},
    {{33, 0, 27, -6.405328}, {33, 0, 27, -25.414859}, {20, 0, 40, -51.672908}, {16, 0, 44, -127.042280}},
    {{46, 0, 14, -6.126166}, {46, 0, 14, -25.454391}, {39, 0, 21, -23.599685}, {39, 0, 21, -39.579377}},
    {{34, 0, 26, -5.778030}, {34, 0, 26, -24.784552}, {23, 0, 37, -98.816626}, {17, 0, 43, -197.433481}},
    {{32, 0, 28, -7.637015}, {32, 0, 28, -26.342005}, {18, 0, 42, -87.432681}, {16, 0, 44, -130.224319}},
};

static void integrals(void **state)
{
    static struct pair sums[SOURCES][2];
    struct randomness random = {.state = 33};
    (void)state;
    for (int kind = 0; kind < SOURCES; kind++) {
        struct lx_emitter source = source_of(kind, center, 1, 300);
        for (int i = 0; i < 60; i++) {
            const struct lx_material material = {.model = i % 2,
                                                 .highlight = i % 3,
                                                 .diffuse = 0.5,
                                                 .specular = 1,
                                                 .shininess = logarithmic(&random, 0.5, 3000)};
            struct lx_lobe lobe = lx_lobe_prepare(&material);
            struct lx_element element = random_element(&random, i, &lobe);
            source.attenuation = (enum lx_attenuation)(i / 2 % 3);
            if (lx_extended_touches(&source, element.place_mm))
                continue;
            struct lx_cubature found = lx_integrate(&source, &element, NULL, i % 2 == 0, 0, 1e-6, NULL);
            add_pair(&sums[kind][0], found.irradiance);
            add_pair(&sums[kind][1], found.specular);
        }
        lx_facets_free(source.facets);
    }
    expect(&sums[0][0].value, integrals_before[0], 4 * SOURCES, "integral");
}

/* -- one light at a time, in scenes of every kind -- */

enum { E_PERP, TOWARDS, COSINE, DIFFUSE, SPECULAR, PLACE, NORMAL, VIEW, LIT, SHINE, PAIRS };

static const struct tally elements_before[2 * PAIRS] = {
    {296, 0, 3091, 0.958147},     {1358, 0, 2029, -33.122340},  {28, 0, 8750, -1.202357},
    {0, 0, 8778, -35.277763},     {754, 0, 2172, -1.540071},    {672, 0, 2254, -34.269478},
    {1191, 0, 1735, -3.101800},   {1128, 0, 1798, -35.691943},  {1526, 0, 1400, -41.565575},
    {1418, 0, 1508, -115.826591}, {0, 0, 4059, 5.256239},       {884, 0, 3175, -30.186148},
    {776, 0, 3283, -0.798446},    {1164, 0, 2895, -37.868649},  {424, 0, 3635, -2.449620},
    {636, 0, 3423, -36.758991},   {996, 0, 2391, -0.488259},    {1393, 0, 1994, -32.854743},
    {2172, 0, 1215, -38.959521},  {2073, 0, 1314, -115.497791},
};

static void elements(void **state)
{
    static struct pair sums[PAIRS];
    (void)state;
    for (int i = 0; i < 400; i++) {
        struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 3)};
        struct test_scene test;
        make_random_scene(&random, true, &test);
        for (int k = 0; k < 12; k++) {
            struct lx_element element;
            double x = uniform(&random, -335, 335), y = uniform(&random, -265, 265);
            if (!lx_element_seen(&test.prepared, x, y, &element))
                continue;
            add_vector(&sums[PLACE], element.place_mm);
            add_vector(&sums[NORMAL], element.normal);
            add_vector(&sums[VIEW], element.view);
            for (size_t e = 0; e < test.prepared.emitters.count; e++) {
                const struct lx_emitter *emitter = &test.prepared.emitters.items[e];
                struct lx_lighting lighting = lx_light_element(&test.prepared, &element, emitter);
                struct lx_sample sample = lx_emitter_sample(emitter, element.place_mm);
                add_pair(&sums[LIT], lighting.irradiance);
                add_pair(&sums[SHINE], lighting.specular);
                add_pair(&sums[E_PERP], sample.e_perp);
                if (emitter->type == LX_UNIFORM || sample.on_element)
                    continue;
                struct lx_reflection light =
                    lx_lobe_reflect(element.lobe, element.normal, element.view, sample.towards);
                add_vector(&sums[TOWARDS], sample.towards);
                add_pair(&sums[COSINE], light.cosine);
                add_pair(&sums[DIFFUSE], light.diffuse);
                add_pair(&sums[SPECULAR], light.specular);
            }
        }
    }
    expect(&sums[0].value, elements_before, 2 * PAIRS, "element");
}

/* -- what is known of a picture before it is made -- */

enum {
    BOUND,
    IN_DOUBLE,
    LEAST_MAXIMUM,
    CLUSTER_ERROR,
    CLUSTER_MOST,
    CLUSTER_LEAST,
    NEAREST,
    AWAY,
    HALF,
    CUT_ERROR,
    WHOLE,
    OPENED,
    PLANNED
};

static struct tally planned[PLANNED];

WRAPPED(struct lx_share_bound, lx_bound_cluster, const struct lx_receiver_region *region, const double anchor_mm[3],
        const struct lx_lobe_limits *limits, const struct lx_tree *tree, const struct lx_cluster *cluster,
        const struct lx_cluster_turn *turn, bool is_hidden)
{
    struct lx_share_bound bound = REAL(lx_bound_cluster)(region, anchor_mm, limits, tree, cluster, turn, is_hidden);
    add(&planned[CLUSTER_ERROR], bound.error);
    add(&planned[CLUSTER_MOST], bound.most);
    add(&planned[CLUSTER_LEAST], bound.least);
    return bound;
}

WRAPPED(struct lx_stand, lx_stand_of, const struct lx_receiver_region *region, const double place[3], bool has_half)
{
    struct lx_stand stand = REAL(lx_stand_of)(region, place, has_half);
    add(&planned[NEAREST], stand.nearest_mm);
    add(&planned[AWAY], stand.away_mm);
    add(&planned[HALF], stand.least_half);
    return stand;
}

WRAPPED(bool, lx_cut_make, const struct lx_plan *plan, const struct lx_planned_surface *surface,
        const struct lx_receiver_region *region, const struct lx_asking *asking, struct lx_cut *cut)
{
    bool goes_on = REAL(lx_cut_make)(plan, surface, region, asking, cut);
    add(&planned[CUT_ERROR], cut->error);
    add(&planned[WHOLE], (double)cut->whole_count);
    add(&planned[OPENED], (double)cut->opened_count);
    return goes_on;
}

enum { MOST_POINTS = 600 + MAXIMUM_LIGHTS };

/* Some hundred points of one kind, which are clustered, behind the scene's own lights. */
static void add_points(struct randomness *random, struct test_scene *test, struct lx_emitter room[MOST_POINTS])
{
    struct lx_emitters *emitters = &test->prepared.emitters;
    struct lx_emitter model = random_emitter(random, &test->surfaces[0].shape);
    const double spread = logarithmic(random, 0.1, 1000), turn = pick(random, 2) ? 0 : uniform(random, 0, 2);
    memcpy(room, emitters->items, emitters->count * sizeof *room);
    emitters->items = room;
    model.type = LX_POINT;
    for (int i = 0; i < 300; i++) {
        double off[3], lean[3];
        struct lx_emitter *point = &room[emitters->count++];
        *point = model;
        random_direction(random, off);
        random_direction(random, lean);
        for (int k = 0; k < 3; k++) {
            point->position_mm[k] += spread * off[k];
            lean[k] *= turn * uniform(random, 0, 1);
        }
        point->strength = logarithmic(random, 0.01, 10);
        if (model.profile.falloff != LX_NO_CONE || model.profile.exponent > 0)
            point->profile.axis = lx_unit3(lx_add3(model.profile.axis, lx_exact3(lean)));
    }
}

/* One tile in the middle of the picture. */
static void shade_tile(const struct lx_plan *plan, const struct test_scene *test)
{
    double x[LX_BLOCK], y[LX_TILE_ROWS];
    struct lx_shader_memory *memory = lx_shader_memory_new(plan);
    assert_non_null(memory);
    unsigned width = lx_tile_columns(plan, COLUMNS);
    for (unsigned i = 0; i < width; i++)
        x[i] = lx_column_x_mm(&test->scene.screen, (COLUMNS - width) / 2 + i);
    for (unsigned j = 0; j < LX_TILE_ROWS; j++)
        y[j] = lx_row_y_mm(&test->scene.screen, ROWS / 2 + j);
    lx_shader_enter(plan, memory, y, LX_TILE_ROWS, x, width);
    lx_shader_memory_free(memory);
}

static const struct tally plans_before[PLANNED] = {
    {50, 253, 774, -11.649186},        {495, 0, 472, 0.082127},           {57, 0, 243, 3.594322},
    {26638, 15935, 261767, -6.214474}, {26609, 15935, 261796, -5.234620}, {247538, 0, 56802, -50.690010},
    {0, 0, 320436, 8.053540},          {0, 0, 320436, 8.042434},          {0, 0, 320436, 0.453031},
    {5308, 0, 7708, -12.497797},       {5350, 0, 7666, 1.317650},         {9768, 0, 3248, 2.304833},
};

static void plans(void **state)
{
    static struct lx_emitter room[MOST_POINTS];
    (void)state;
    for (int i = 0; i < 300; i++) {
        struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 11)};
        const luxel_settings settings = {.precision = i % 5 ? LUXEL_SINGLE : LUXEL_DOUBLE,
                                         .light_error = pow(10, -1 - i % 4)};
        struct test_scene test;
        struct lx_plan plan;
        make_random_scene(&random, i % 3, &test);
        for (size_t s = 0; s < test.prepared.surface_count; s++)
            for (size_t e = 0; e < test.prepared.emitters.count; e++)
                if (lx_has_one_way(&test.prepared.emitters.items[e]))
                    add(&planned[BOUND], lx_bound_light(&test.prepared, &test.surfaces[s].shape, &test.surfaces[s].lobe,
                                                        &test.prepared.emitters.items[e]));
        if (i % 2)
            add_points(&random, &test, room);
        assert_int_equal(lx_plan_make(&test.prepared, lx_kernels_choose("generic"), &settings, &plan), LUXEL_OK);
        add(&planned[LEAST_MAXIMUM], plan.least_maximum);
        for (size_t s = 0; s < plan.surface_count; s++)
            for (size_t k = 0; k < plan.surfaces[s].run_count; k++)
                add(&planned[IN_DOUBLE],
                    plan.surfaces[s].runs[k].in_double ? (double)plan.surfaces[s].runs[k].count : 0);
        if (i % 2)
            shade_tile(&plan, &test);
        lx_plan_clear(&plan);
    }
    expect(planned, plans_before, PLANNED, "plan");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms), cmocka_unit_test(touching), cmocka_unit_test(integrals),
        cmocka_unit_test(elements),     cmocka_unit_test(plans),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

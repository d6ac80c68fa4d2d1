/* SPDX-License-Identifier: MIT */
/*
 * Pictures of extended sources against the float64 reference, pixel by pixel, in every instruction set: facets, disks,
 * balls and cylinders, near and far, tiny and huge, in front of surfaces, behind them, cut by their horizons, standing
 * on them; every law, lobe and projection.  Their diffuse light keeps 2e-6 of the picture's maximum, in float64 1e-11;
 * highlights keep the tolerance.  The same bytes for any number of threads, and in probes.
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

#include <luxel/luxel.h>

#include "campaign.h"
#include "light/solid/extended.h"
#include "light/solid/facets.h"
#include "picture/plan_make.h"
#include "picture/shader.h"
#include "surface/authored.h"
#include "world/camera.h"
#include "world/reference.h"

/* Pictures that are darker than this are black in float32. */
static const double LEAST_FLOAT = 1e-30;

enum { COLUMNS = 75, ROWS = 3, MAXIMUM_LIGHTS = 2 };

/* xorshift64*: the same scenes on every machine */
struct randomness {
    uint64_t state;
};

static double uniform(struct randomness *random, double low, double high)
{
    random->state ^= random->state >> 12;
    random->state ^= random->state << 25;
    random->state ^= random->state >> 27;
    return low + (high - low) * ((double)((random->state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

static int pick(struct randomness *random, int count)
{
    return (int)uniform(random, 0, count);
}

static double logarithmic(struct randomness *random, double low, double high)
{
    return exp(uniform(random, log(low), log(high)));
}

static void random_direction(struct randomness *random, double direction[3])
{
    double length = 0;
    for (int i = 0; i < 3; i++) {
        direction[i] = uniform(random, -1, 1);
        length = hypot(length, direction[i]);
    }
    for (int i = 0; i < 3; i++)
        direction[i] /= length;
}

struct test_scene {
    struct lx_scene_parameters scene;
    struct lx_sphere_parameters sphere;
    struct lx_plate_parameters plate;
    struct lx_prepared_surface surface;
    struct lx_emitters emitters;
    struct lx_prepared prepared;
    bool has_laws;
};

/* The laws of a run of scenes: 1/r^2 alone, that for most, and none but the others. */
enum laws { INVERSE_SQUARE, MIXED, OTHERS };

/* What is asked of the pictures of a run of scenes. */
struct demand {
    luxel_quantity quantity;
    luxel_precision precision;
    enum laws laws;
    double bound, tolerance;
    bool facets; /* only */
};

static struct lx_material random_material(struct randomness *random)
{
    return (struct lx_material){
        .model = pick(random, 2) ? LX_BLINN_PHONG : LX_PHONG,
        .diffuse = pick(random, 5) ? uniform(random, 0, 1) : 0,
        .specular = uniform(random, 0, 1),
        .shininess = pick(random, 3) ? uniform(random, 1, 60) : logarithmic(random, 0.1, 10000),
        .over_pi = pick(random, 2),
        .highlight = pick(random, 3),
        .normalized = pick(random, 3) == 0,
    };
}

static void set_surface(struct randomness *random, struct test_scene *test)
{
    bool is_plate = pick(random, 2);
    const char *name = is_plate ? "rectangle" : "sphere";
    const struct lx_surface_kind *kind = NULL;
    for (size_t i = 0; lx_surface_variants[i]; i++)
        if (strcmp(lx_surface_variants[i]->name, name) == 0)
            kind = (const struct lx_surface_kind *)lx_surface_variants[i];
    assert_non_null(kind);
    test->sphere = (struct lx_sphere_parameters){.center_mm = {10, -20, 1000}, .radius_mm = 240};
    test->plate = (struct lx_plate_parameters){.center_mm = {10, -20, 1000}, .size_mm = {460, 420}, .axis = {0, 0, 1}};
    if (pick(random, 2)) {
        random_direction(random, test->plate.axis);
        test->plate.axis[2] = fabs(test->plate.axis[2]) + 0.2;
    }
    const void *parameters = is_plate ? (const void *)&test->plate : (const void *)&test->sphere;
    struct lx_material material = random_material(random);
    test->surface = (struct lx_prepared_surface){.kind = kind,
                                                 .parameters = parameters,
                                                 .shape = lx_surface_shape(kind, parameters),
                                                 .lobe = lx_lobe_prepare(&material)};
    kind->extent(parameters, test->surface.low_mm, test->surface.high_mm);
}

/* Where a source of this size may stand: before the surface, beside it, just above it, or anywhere. */
static void random_place(struct randomness *random, const struct lx_shape *shape, double size, double place[3])
{
    double direction[3], distance = shape->radius_mm + logarithmic(random, 1, 10) * size;
    random_direction(random, direction);
    if (pick(random, 4))
        direction[2] = fabs(direction[2]);
    if (pick(random, 3) == 0)
        distance = shape->radius_mm + logarithmic(random, 0.1, 10000);
    for (int i = 0; i < 3; i++)
        place[i] = shape->anchor_mm[i] + direction[i] * distance;
}

static struct lx_facets *random_facets(struct randomness *random, const struct lx_shape *shape, double size,
                                       const double place[3], const double axis[3])
{
    double sizes[3], up[3];
    random_direction(random, up);
    for (int i = 0; i < 3; i++)
        sizes[i] = size * logarithmic(random, 0.1, 1);
    double center[3] = {place[0], place[1], place[2]};
    switch (pick(random, 6)) {
    case 0: return lx_facets_of_box(place, sizes);
    case 1: return lx_facets_of_sphere(place, size, 3 + (unsigned)pick(random, 9));
    case 2: return lx_facets_of_cylinder(place, size, sizes[0], axis, 3 + (unsigned)pick(random, 9));
    case 3: /* stands on the plane through the anchor, which is a plate's own */
        center[0] = shape->anchor_mm[0] + 100, center[1] = shape->anchor_mm[1];
        center[2] = shape->anchor_mm[2] + sizes[0] / 2;
        return lx_facets_of_cylinder(center, sizes[1], sizes[0], (double[]){0, 0, 1}, 12);
    default: break;
    }
    return lx_facets_of_rectangle(place, sizes, axis, up);
}

static enum lx_attenuation random_law(struct randomness *random, enum laws laws)
{
    static const enum lx_attenuation others[] = {LX_PRACTICAL, LX_NO_ATTENUATION, LX_POLYNOMIAL};
    if (laws == OTHERS)
        return others[pick(random, 3)];
    return laws == INVERSE_SQUARE || pick(random, 2) ? LX_INVERSE_SQUARE : (enum lx_attenuation)pick(random, LX_LAWS);
}

static void add_emitter(struct randomness *random, const struct demand *demand, struct test_scene *test)
{
    const struct lx_shape *shape = &test->surface.shape;
    struct lx_emitter emitter = {.radiance = lx_exact(logarithmic(random, 0.01, 100))};
    double size = logarithmic(random, 1, 1000), axis[3], place[3];
    random_place(random, shape, size, place);
    random_direction(random, axis);
    if (pick(random, 4))
        for (int i = 0; i < 3; i++)
            axis[i] = shape->anchor_mm[i] + uniform(random, -1, 1) * shape->radius_mm - place[i];
    emitter.type = demand->facets ? LX_FACETS : (enum lx_emitter_type)(LX_FACETS + pick(random, 4));
    emitter.attenuation = random_law(random, demand->laws);
    emitter.k_mm = logarithmic(random, 10, 2000);
    if (demand->laws == OTHERS && pick(random, 8) == 0)
        emitter.k_mm = 0;
    for (int i = 0; i < 3; i++)
        emitter.coefficients[i] = logarithmic(random, 1e-2, 10);
    test->has_laws = test->has_laws || emitter.attenuation != LX_INVERSE_SQUARE;
    memcpy(emitter.center_mm, place, sizeof place);
    emitter.radius_mm = size;
    emitter.height_mm = size * logarithmic(random, 0.1, 10);
    emitter.axis = lx_unit3(lx_exact3(axis));
    if (emitter.type == LX_FACETS) {
        emitter.facets = random_facets(random, shape, size, place, axis);
        assert_non_null(emitter.facets);
    }
    assert_int_equal(lx_emitters_append(&test->emitters, &emitter), 0);
}

static void make_scene(struct randomness *random, const struct demand *demand, struct test_scene *test)
{
    *test = (struct test_scene){
        .scene.screen = {.width_mm = 520, .height_mm = 530, .resolution = {COLUMNS, ROWS}, .sampling = pick(random, 2)},
        .scene.observer = {.z_mm = 5000, .projection = pick(random, 2), .view = pick(random, 2)},
    };
    set_surface(random, test);
    for (int i = 0, count = 1 + pick(random, MAXIMUM_LIGHTS); i < count; i++)
        add_emitter(random, demand, test);
    test->prepared = (struct lx_prepared){
        .scene = &test->scene,
        .camera = lx_camera_of(&test->scene.observer),
        .surfaces = &test->surface,
        .surface_count = 1,
        .emitters = test->emitters,
        .tolerance = fmin(demand->bound / 4, 1e-4),
    };
}

/*
 * The reference picture.  Emitters that lie on an element, or around it, count as 0 there; as the value jumps beside
 * it, from nothing to a face that fills half of all directions, such an element is all doubt.
 */
static double reference_picture(const struct test_scene *test, luxel_quantity quantity,
                                lx_bounded picture[ROWS][COLUMNS])
{
    const struct lx_lobe irradiance = lx_lobe_irradiance();
    double maximum = 0;
    for (unsigned row = 0; row < ROWS; row++)
        for (unsigned column = 0; column < COLUMNS; column++) {
            struct lx_element element;
            picture[row][column] = lx_exact(0);
            if (!lx_element_seen(&test->prepared, lx_column_x_mm(&test->scene.screen, column),
                                 lx_row_y_mm(&test->scene.screen, row), &element))
                continue;
            if (quantity == LUXEL_IRRADIANCE)
                element.lobe = &irradiance;
            for (size_t i = 0; i < test->prepared.emitters.count; i++) {
                struct lx_lighting light =
                    lx_light_element(&test->prepared, &element, &test->prepared.emitters.items[i]);
                if (light.on_element)
                    picture[row][column].error = HUGE_VAL;
                else
                    picture[row][column] = lx_add(picture[row][column], lx_add(light.diffuse, light.specular));
            }
            maximum = fmax(maximum, picture[row][column].value);
        }
    return maximum;
}

/* The share of a plan's facets that is left to float32; 0 where there are none. */
static double share_in_single(const struct lx_plan *plan)
{
    size_t facets = 0, singles = 0;
    for (size_t i = 0; i < plan->surfaces[0].area_light_count; i++) {
        facets += plan->surfaces[0].area_lights[i].lamp.type == LX_FACETS;
        singles += plan->surfaces[0].area_lights[i].lamp.edges_single != NULL;
    }
    return facets > 0 ? (double)singles / (double)facets : 0;
}

/* Pixels that the reference is good enough for, and others. */
struct tally {
    size_t compared, doubtful;
};

static double worst_pixel(const struct test_scene *test, const struct lx_kernels *kernels, const struct demand *demand,
                          lx_bounded picture[ROWS][COLUMNS], double maximum, double *share, struct tally *tally)
{
    struct lx_plan plan;
    double x[LX_BLOCK], values[LX_BLOCK], one[LX_BLOCK], worst = 0;
    uint8_t mask[LX_BLOCK];
    const luxel_settings settings = {
        .quantity = demand->quantity, .precision = demand->precision, .tolerance = demand->tolerance};
    assert_int_equal(lx_plan_make(&test->prepared, kernels, &settings, &plan), LUXEL_OK);
    struct lx_shader_memory *memory = lx_shader_memory_new(&plan);
    assert_non_null(memory);
    assert_true(plan.least_maximum <= maximum * (1 + 1e-6));
    *share = share_in_single(&plan);
    for (unsigned row = 0; row < ROWS; row++) {
        for (unsigned column = 0; column < COLUMNS; column++)
            x[column] = lx_column_x_mm(&test->scene.screen, column);
        const double y = lx_row_y_mm(&test->scene.screen, row);
        lx_shader_enter(&plan, memory, &y, 1, x, COLUMNS);
        lx_shade_row(&plan, memory, 0, NULL, false, values, mask);
        if (demand->quantity == LUXEL_IRRADIANCE && demand->laws != MIXED) { /* then its block does not matter */
            const unsigned alone = (row * 31) % COLUMNS;
            lx_shader_enter(&plan, memory, &y, 1, &x[alone], 1);
            lx_shade_row(&plan, memory, 0, NULL, false, one, mask);
            assert_memory_equal(&one[0], &values[alone], sizeof one[0]);
        }
        for (unsigned column = 0; column < COLUMNS; column++) {
            lx_bounded exact = picture[row][column];
            assert_true(isfinite(values[column]) && values[column] >= 0);
            /* Where the reference itself is in doubt there is nothing to compare with. */
            const bool is_doubtful = exact.error > demand->bound / 2 * maximum;
            tally->doubtful += is_doubtful;
            tally->compared += exact.value > 0 && !is_doubtful;
            if (is_doubtful)
                continue;
            double off = fabs(values[column] - exact.value) - exact.error;
            if (maximum > 0)
                worst = fmax(worst, off / maximum);
        }
    }
    lx_shader_memory_free(memory);
    lx_plan_clear(&plan);
    return worst;
}

static void check(const struct demand *demand, int scenes)
{
    static lx_bounded picture[ROWS][COLUMNS];
    double worst = 0, share, single = 0;
    struct tally tally = {0, 0};
    scenes = scenes_to_try(scenes);
    for (int i = 0; i < scenes; i++) {
        struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 1)};
        struct test_scene test;
        make_scene(&random, demand, &test);
        double maximum = reference_picture(&test, demand->quantity, picture);
        for (size_t k = 0; lx_kernels_get(k); k++) {
            const struct lx_kernels *kernels = lx_kernels_get(k);
            if (!kernels->runs() || maximum < LEAST_FLOAT)
                continue;
            double off = worst_pixel(&test, kernels, demand, picture, maximum, &share, &tally);
            single += k == 0 ? share : 0;
            if (off > demand->bound)
                print_message("# scene %d, %s: off by %.3g of the maximum\n", i, kernels->name, off);
            worst = fmax(worst, off);
        }
        lx_emitters_clear(&test.emitters);
    }
    print_message("# worst pixel: %.3g of the maximum, of %zu; %zu doubtful", worst, tally.compared, tally.doubtful);
    if (demand->facets)
        print_message("; %.0f %% of the sources in float32", 100 * single / scenes);
    print_message("\n");
    assert_true(worst <= demand->bound && tally.compared > 4 * tally.doubtful);
}

static void test_closed_forms(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_IRRADIANCE, LUXEL_DOUBLE, INVERSE_SQUARE, 1e-11, 0, false}, 150);
}

/* What is left to float32 is told by its bounds. */
static void test_facets(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_IRRADIANCE, LUXEL_SINGLE, INVERSE_SQUARE, 2e-6, 0, true}, 150);
}

static void test_laws(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_IRRADIANCE, LUXEL_SINGLE, MIXED, 2e-6, 0, false}, 20);
}

/* Every source by another law. */
static void test_other_laws(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_IRRADIANCE, LUXEL_SINGLE, OTHERS, 2e-6, 0, false}, 40);
}

static void test_exact_laws(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_IRRADIANCE, LUXEL_DOUBLE, OTHERS, 1e-11, 0, false}, 20);
}

static void test_highlights(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_BRIGHTNESS, LUXEL_SINGLE, INVERSE_SQUARE, 1e-3, 0, false}, 30);
}

/* Also where the light falls by other laws, and all of it is an integral. */
static void test_highlights_by_laws(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_BRIGHTNESS, LUXEL_SINGLE, MIXED, 1e-3, 0, false}, 12);
}

static void test_fine_highlights(void **state)
{
    (void)state;
    check(&(struct demand){LUXEL_BRIGHTNESS, LUXEL_DOUBLE, INVERSE_SQUARE, 1e-5, 1e-5, false}, 12);
}

static const char many_sources[] =
    "luxel: 1\n"
    "screen: {width: 600, height: 200, resolution: [300, 100]}\n"
    "observer: {z: 3000, view: observer}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [-40, 0, 1000], radius: 200, material: {shininess: 60}}\n"
    "  - {type: sphere, center: [250, 30, 1000], radius: 80, material: {model: phong, shininess: 9}}\n"
    "lights:\n"
    "  - {type: point, position: [900, 900, 1900], intensity: 10}\n"
    "  - {type: planar, rectangle: {center: [900, 800, 1900], size: [500, 500], aim: [0, 0, 1000]}, radiance: 80}\n"
    "  - {type: planar, disk: {center: [-300, -1100, 1700], radius: 200, aim: [0, 0, 1000]}, radiance: 90}\n"
    "  - {type: volume, box: {center: [-1000, -300, 1600], size: [200, 300, 200]}, radiance: 90}\n"
    "  - {type: volume, sphere: {center: [300, -900, 1900], radius: 100}, radiance: 150}\n"
    "  - {type: volume, cylinder: {center: [0, 1000, 1800], radius: 20, height: 900, axis: [1, 0, 0]}, radiance: 9}\n";

static luxel_scene *read_scene(void)
{
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_text(many_sources, strlen(many_sources), "many", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_field *render(const luxel_scene *scene, unsigned threads)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.threads = threads;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

static void test_threads(void **state)
{
    (void)state;
    luxel_scene *scene = read_scene();
    luxel_field *one = render(scene, 1);
    size_t size = (size_t)luxel_field_columns(one) * luxel_field_rows(one) * sizeof(float);
    for (unsigned threads = 2; threads <= 7; threads += 5) {
        luxel_field *many = render(scene, threads);
        assert_memory_equal(luxel_field_single(one), luxel_field_single(many), size);
        luxel_field_free(many);
    }
    luxel_field_free(one);
    luxel_scene_free(scene);
}

/* What a probe says of its pixel is in the picture, to the last bit, in every block of columns. */
static void test_probed_pixels(void **state)
{
    (void)state;
    luxel_scene *scene = read_scene();
    luxel_field *field = render(scene, 0);
    unsigned probed = 0;
    for (unsigned column = 0; column < luxel_field_columns(field); column += 7) {
        unsigned row = (column * 5) % luxel_field_rows(field);
        luxel_probe *probe = NULL;
        assert_int_equal(luxel_probe_screen(scene, NULL, luxel_field_x_mm(field)[column], luxel_field_y_mm(field)[row],
                                            NULL, &probe),
                         LUXEL_OK);
        if (probe->has_pixel_value) {
            double shown = luxel_field_value(field, column, row), value = probe->pixel_value;
            assert_int_equal(probe->column, column);
            assert_memory_equal(&value, &shown, sizeof value);
            assert_true(fabs(probe->value - value) <= 1e-3 * luxel_field_statistics(field)->maximum.value);
            probed++;
        }
        luxel_probe_free(probe);
    }
    assert_true(probed > 10);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* Where the first rows show but the foot of a highlight, fainter than any float32 number, it is not looked for in ever
 * smaller cells: that would take hours. */
static void test_vanishing_highlight(void **state)
{
    (void)state;
    static const char text[] =
        "luxel: 1\n"
        "screen: {width: 670, height: 530, resolution: [201, 159]}\n"
        "observer: {z: 5000, projection: perspective}\n"
        "surfaces:\n"
        "  - {type: sphere, center: [37, 35, 1112], radius: 111, material: {model: phong, shininess: 207}}\n"
        "lights: [{type: volume, radiance: 1000, box: {center: [2082, -2989, 505], size: [300, 200, 100]}}]\n";
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_text(text, strlen(text), "faint", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_field *field = render(scene, 0);
    assert_true(luxel_field_statistics(field)->maximum.value > 1);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* Each pixel of a picture is what an evaluator finds there, to the tolerance. */
static void check_pixels(const char *text)
{
    luxel_scene *scene = NULL;
    luxel_evaluator *evaluator = NULL;
    assert_int_equal(luxel_scene_read_text(text, strlen(text), "pixels", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_field *field = render(scene, 1);
    const double maximum = luxel_field_statistics(field)->maximum.value;
    assert_true(maximum > 0);
    for (unsigned row = 0; row < luxel_field_rows(field); row++)
        for (unsigned column = 0; column < luxel_field_columns(field); column++) {
            luxel_value exact;
            luxel_evaluate_screen(evaluator, luxel_field_x_mm(field)[column], luxel_field_y_mm(field)[row], &exact,
                                  NULL);
            assert_true(fabs(luxel_field_value(field, column, row) - exact.value) <= 1e-3 * maximum + exact.error);
        }
    luxel_field_free(field);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

/* Light that comes nearly straight from behind has half vectors of all directions side by side. */
static void test_opposite_light(void **state)
{
    (void)state;
    check_pixels("luxel: 1\n"
                 "screen: {width: 60, height: 20, resolution: [3, 1]}\n"
                 "observer: {z: 900}\n"
                 "surfaces: [{type: sphere, center: [0, 10, 0], radius: 300, material: {diffuse: 0, shininess: 1}}]\n"
                 "lights: [{type: volume, sphere: {center: [0, 0, 2], radius: 6}, radiance: 1}]\n");
}

/* What is round and many times as wide as the highlight shines with a part that few samples in all of it would miss:
 * those of the only pixel. */
static void test_sharp_highlights(void **state)
{
    (void)state;
    for (int i = 0; i < 28; i++) {
        const bool is_disk = i % 2 == 0;
        char text[600];
        snprintf(text, sizeof text,
                 "luxel: 1\n"
                 "screen: {width: 10, height: 10, resolution: [1, 1]}\n"
                 "observer: {z: 2000}\n"
                 "surfaces: [{type: rectangle, center: [0, 0, 0], size: [400, 200], axis: [0, 0, 1],\n"
                 "            material: {diffuse: 0, shininess: 50000}}]\n"
                 "lights: [{type: %s: {center: [%d, 30, 1000], radius: 150%s}, radiance: 1}]\n",
                 is_disk ? "planar, disk" : "volume, sphere", 5 * i, is_disk ? ", axis: [0, 0, -1]" : "");
        check_pixels(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed_forms),
        cmocka_unit_test(test_facets),
        cmocka_unit_test(test_laws),
        cmocka_unit_test(test_other_laws),
        cmocka_unit_test(test_exact_laws),
        cmocka_unit_test(test_highlights),
        cmocka_unit_test(test_highlights_by_laws),
        cmocka_unit_test(test_fine_highlights),
        cmocka_unit_test(test_threads),
        cmocka_unit_test(test_probed_pixels),
        cmocka_unit_test(test_vanishing_highlight),
        cmocka_unit_test(test_opposite_light),
        cmocka_unit_test(test_sharp_highlights),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/*
 * The surface `box` against rotations by hand, and against six rectangles that are written one by one: pictures, free
 * elements under all kinds of lights, reflected light, grids; the names and materials of its sides, and what is said of
 * scenes that have it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/scene.h"
#include "scenes.h"
#include "surface/part.h"

enum { TEXT_SIZE = 6000, SIDES = 6 };

static const char floor_text[] = "{type: rectangle, center: [0, 0, 0], size: [1200, 1200], material: {model: lambert, "
                                 "diffuse: 0.6, over_pi: true}}";
static const char matte[] = ", material: {model: lambert, diffuse: 0.5, over_pi: true}";

static double between(double low, double high)
{
    return low + (high - low) * (rand() / (RAND_MAX + 1.0));
}

static luxel_scene *scene_of(const char *more, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    const int length = snprintf(text, sizeof text,
                                "luxel: 1\nscreen: {width: 1000, height: 1000, resolution: [80, 80]}\n"
                                "observer: {z: 3000, projection: perspective}\n%ssurfaces: [%s]\nlights: [%s]\n",
                                more, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), text);
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* A box, and where its own x, y and z point to. */
struct box {
    double center[3], size[3], rotate[3], axes[3][3];
    bool is_z_up;
};

/* Turned by the matrices of rotations about x, y and z. */
static void turn(struct box *box)
{
    for (int axis = 0; axis < 3; axis++) {
        double *v = box->axes[axis];
        for (int i = 0; i < 3; i++)
            v[i] = i == axis;
        for (int about = 0; about < 3; about++) {
            const double angle = box->rotate[about] * M_PI / 180;
            const int y = (about + 1) % 3, z = (about + 2) % 3;
            const double first = cos(angle) * v[y] - sin(angle) * v[z];
            v[z] = sin(angle) * v[y] + cos(angle) * v[z];
            v[y] = first;
        }
    }
}

/* Standing over the floor, or on it. */
static struct box random_box(void)
{
    struct box box = {.is_z_up = rand() % 2};
    const int kind = rand() % 3;
    for (int i = 0; i < 3; i++) {
        box.center[i] = between(-250, 250);
        box.size[i] = between(80, 300);
        box.rotate[i] = kind == 0 ? 0 : kind == 1 ? 90 * (rand() % 4) : between(-180, 180);
    }
    box.center[2] = 300;
    if (kind == 0 && rand() % 2)
        box.center[2] = box.size[2] / 2;
    turn(&box);
    return box;
}

static const char *box_of(const struct box *box, const char *more, char text[TEXT_SIZE])
{
    snprintf(text, TEXT_SIZE,
             "{type: box, center: [%.17g, %.17g, %.17g], size: [%.17g, %.17g, %.17g], rotate: [%.17g, %.17g, %.17g], "
             "up: %c%s}",
             box->center[0], box->center[1], box->center[2], box->size[0], box->size[1], box->size[2], box->rotate[0],
             box->rotate[1], box->rotate[2], box->is_z_up ? 'z' : 'y', more);
    return text;
}

/* The sides as the scene's first box, or room, has them. */
static void sides_of(const luxel_scene *scene, size_t surface, struct lx_part sides[SIDES])
{
    const struct lx_item *item = &lx_scene_parameters(scene)->surfaces.items[surface];
    for (unsigned i = 0; i < SIDES; i++)
        lx_part_make((const struct lx_surface_kind *)item->variant, item->parameters, i, &sides[i]);
}

/* Six rectangles in the places of these sides, to the last bit. */
static const char *six_of(const struct box *box, const char *more, char text[TEXT_SIZE])
{
    char one[TEXT_SIZE];
    struct lx_part sides[SIDES];
    luxel_scene *scene = scene_of("", box_of(box, more, one), "");
    size_t length = 0;
    sides_of(scene, 0, sides);
    for (int i = 0; i < SIDES; i++) {
        const struct lx_plate_parameters *p = &sides[i].own.plate;
        length +=
            (size_t)snprintf(text + length, TEXT_SIZE - length,
                             "%s{type: rectangle, center: [%.17g, %.17g, %.17g], size: [%.17g, %.17g], axis: "
                             "[%.17g, %.17g, %.17g], up: [%.17g, %.17g, %.17g]%s}",
                             i ? ", " : "", p->center_mm[0], p->center_mm[1], p->center_mm[2], p->size_mm[0],
                             p->size_mm[1], p->axis[0], p->axis[1], p->axis[2], p->up[0], p->up[1], p->up[2], more);
    }
    luxel_scene_free(scene);
    return text;
}

/* Which of its axes a side stands on, and at which end, by what the format says of their names. */
static void meant(bool is_z_up, int side, int *axis, int *end)
{
    static const struct {
        int axis, end;
    } by_up[2][SIDES] = {{{0, -1}, {0, 1}, {1, -1}, {1, 1}, {2, -1}, {2, 1}},
                         {{0, -1}, {0, 1}, {2, -1}, {2, 1}, {1, 1}, {1, -1}}};
    *axis = by_up[is_z_up][side].axis;
    *end = by_up[is_z_up][side].end;
}

/* Sides are where rotations by hand put them, look outwards, are named as those of a room, and are as large. */
static void test_sides(void **state)
{
    static const char *const names[] = {"left", "right", "bottom", "top", "back", "front"};
    static const char *const walls[] = {"left", "right", "floor", "ceiling", "back", "front"};
    (void)state;
    for (int trial = 0; trial < 300; trial++) {
        const struct box box = random_box();
        char text[TEXT_SIZE], room[TEXT_SIZE], both[TEXT_SIZE];
        struct lx_part sides[SIDES], inside[SIDES];
        snprintf(room, sizeof room, "{type: room, center: [%.17g, %.17g, %.17g], size: [%.17g, %.17g, %.17g], up: %c}",
                 box.center[0], box.center[1], box.center[2], box.size[0], box.size[1], box.size[2],
                 box.is_z_up ? 'z' : 'y');
        assert_true(snprintf(both, sizeof both, "%s, %s", box_of(&box, "", text), room) < TEXT_SIZE);
        luxel_scene *scene = scene_of("", both, "");
        sides_of(scene, 0, sides);
        sides_of(scene, 1, inside);
        for (int s = 0; s < SIDES; s++) {
            const struct lx_shape *shape = &sides[s].shape;
            int axis, end;
            meant(box.is_z_up, s, &axis, &end);
            assert_string_equal(luxel_scene_part_name(scene, 0, (unsigned)s), names[s]);
            assert_string_equal(luxel_scene_part_name(scene, 1, (unsigned)s), walls[s]);
            for (int i = 0; i < 3; i++) {
                const double at = box.center[i] + end * box.size[axis] / 2 * box.axes[axis][i];
                const double at_wall = box.center[i] + (i == axis ? end * box.size[axis] / 2 : 0);
                assert_true(fabs(shape->anchor_mm[i] - at) < 1e-11);
                assert_true(fabs(shape->axis[i] - end * box.axes[axis][i]) < 1e-14);
                assert_true(inside[s].shape.anchor_mm[i] == at_wall);
                assert_true(inside[s].shape.axis[i] == (i == axis ? -end : 0));
            }
            const double area = 4 * shape->half_mm[0] * shape->half_mm[1];
            const double expected = box.size[(axis + 1) % 3] * box.size[(axis + 2) % 3];
            assert_true(fabs(area - expected) < 1e-9 * expected);
            /* its width and height are those of the box along the axes on which they run */
            for (int way = 0; way < 2; way++) {
                const double *along = way ? shape->upward : shape->across;
                bool is_found = false;
                for (int k = 0; k < 3 && !is_found; k++)
                    is_found =
                        fabs(fabs(along[0] * box.axes[k][0] + along[1] * box.axes[k][1] + along[2] * box.axes[k][2]) -
                             1) < 1e-12 &&
                        fabs(2 * shape->half_mm[way] - box.size[k]) < 1e-8;
                assert_true(is_found);
            }
        }
        luxel_scene_free(scene);
    }
}

/* One of the lights that there are, somewhere above. */
static const char *random_light(char text[TEXT_SIZE])
{
    const double x = between(-900, 900), y = between(-900, 900), z = between(700, 1500), reach = between(5, 250);
    switch (rand() % 6) {
    case 0: snprintf(text, TEXT_SIZE, "{type: point, position: [%g, %g, %g], intensity: 7}", x, y, z); break;
    case 1: snprintf(text, TEXT_SIZE, "{type: distant, direction: [%g, %g, %g], irradiance: 5}", -x, -y, -z); break;
    case 2:
        snprintf(text, TEXT_SIZE,
                 "{type: planar, disk: {center: [%g, %g, %g], radius: %g, axis: [0, 0, -1]}, radiance: 90}", x, y, z,
                 reach);
        break;
    case 3:
        snprintf(
            text, TEXT_SIZE,
            "{type: planar, rectangle: {center: [%g, %g, %g], size: [%g, %g], axis: [%g, %g, -1000]}, radiance: 90}", x,
            y, z, reach, 2 * reach, -x, -y);
        break;
    case 4:
        snprintf(text, TEXT_SIZE, "{type: volume, sphere: {center: [%g, %g, %g], radius: %g}, radiance: 90}", x, y, z,
                 reach);
        break;
    default:
        snprintf(text, TEXT_SIZE,
                 "{type: spot, position: [%g, %g, %g], axis: [%g, %g, %g], intensity: 9, inner: 20, "
                 "outer: 50}",
                 x, y, z, -x, -y, -z);
    }
    return text;
}

/* Boxes, rotations and lights at random: places of the floor, also right beside the box, places of its sides, and
 * others near it have to the last bit what they have among six rectangles; and where these take light the box does. */
static void test_elements(void **state)
{
    enum { TRIALS = 60, PLACES = 60 };
    size_t darkened = 0;
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        const struct box box = random_box();
        char one[TEXT_SIZE], six[TEXT_SIZE], light[TEXT_SIZE], surfaces[TEXT_SIZE];
        luxel_scene *scenes[3];
        luxel_evaluator *evaluators[3];
        random_light(light);
        snprintf(surfaces, sizeof surfaces, "%s, %s", floor_text, box_of(&box, matte, one));
        scenes[0] = scene_of("", surfaces, light);
        assert_true(snprintf(surfaces, sizeof surfaces, "%s, %s", floor_text, six_of(&box, matte, six)) < TEXT_SIZE);
        scenes[1] = scene_of("", surfaces, light);
        scenes[2] = scene_of("", floor_text, light);
        for (int i = 0; i < 3; i++)
            assert_int_equal(luxel_evaluator_new(scenes[i], NULL, NULL, &evaluators[i]), LUXEL_OK);
        for (int k = 0; k < PLACES; k++) {
            luxel_place place = {.is_element = true, .normal = {0, 0, 1}};
            luxel_value values[3];
            const int axis = rand() % 3;
            for (int i = 0; i < 3; i++)
                place.position_mm[i] = i < 2 ? box.center[i] + between(-350, 350) : 0;
            for (int i = 0; i < 3 && k % 3 == 1; i++) { /* on the far end of one of its axes */
                place.position_mm[i] = box.center[i];
                for (int j = 0; j < 3; j++)
                    place.position_mm[i] += (j == axis ? 0.5 : 0.3) * box.size[j] * box.axes[j][i];
                place.normal[i] = box.axes[axis][i];
            }
            for (int i = 0; i < 3 && k % 3 == 2; i++) {
                place.position_mm[i] += between(0, 400);
                place.normal[i] = between(-1, 1);
            }
            for (int i = 0; i < 3; i++)
                luxel_evaluate_place(evaluators[i], &place, &values[i], NULL);
            assert_true(values[0].value == values[1].value && values[0].error == values[1].error);
            darkened += k % 3 == 0 && values[0].value < values[2].value - values[2].error - values[0].error;
        }
        for (int i = 0; i < 3; i++) {
            luxel_evaluator_free(evaluators[i]);
            luxel_scene_free(scenes[i]);
        }
    }
    assert_true(darkened > TRIALS * PLACES / 3 / 20);
}

/* Pictures of both, of hard and soft shadows and highlights, are the same to the last bit. */
static void test_pictures(void **state)
{
    (void)state;
    for (int trial = 0; trial < 10; trial++) {
        const struct box box = random_box();
        char one[TEXT_SIZE], six[TEXT_SIZE], light[TEXT_SIZE], surfaces[TEXT_SIZE];
        const char *shiny = ", material: {diffuse: 0.6, specular: 0.3, shininess: 30}";
        luxel_field *fields[2];
        random_light(light);
        for (int i = 0; i < 2; i++) {
            assert_true(snprintf(surfaces, sizeof surfaces, "%s, %s", floor_text,
                                 i ? six_of(&box, shiny, six) : box_of(&box, shiny, one)) < TEXT_SIZE);
            luxel_scene *scene = scene_of("", surfaces, light);
            assert_int_equal(luxel_render(scene, NULL, NULL, &fields[i]), LUXEL_OK);
            luxel_scene_free(scene);
        }
        for (unsigned pixel = 0; pixel < 80 * 80; pixel++) {
            const double a = luxel_field_value(fields[0], pixel % 80, pixel / 80);
            const double b = luxel_field_value(fields[1], pixel % 80, pixel / 80);
            assert_true(a == b || (isnan(a) && isnan(b)));
        }
        luxel_field_free(fields[0]);
        luxel_field_free(fields[1]);
    }
}

/* It sends on what six rectangles do. */
static void test_reflections(void **state)
{
    (void)state;
    const struct box boxes[] = {{.center = {100, 20, 90}, .size = {200, 150, 180}},
                                {.center = {100, 20, 190}, .size = {200, 150, 100}, .rotate = {20, 30, 40}}};
    for (size_t b = 0; b < LX_COUNT(boxes); b++) {
        char one[TEXT_SIZE], six[TEXT_SIZE], surfaces[TEXT_SIZE];
        double values[2][3], errors[2][3];
        luxel_settings settings;
        luxel_settings_init(&settings);
        settings.reflected_error = 0.02;
        for (int i = 0; i < 2; i++) {
            const luxel_place places[] = {
                {.is_element = true, .position_mm = {-60, 20, 0}, .normal = {0, 0, 1}},
                {.is_element = true, .position_mm = {300, 0, 50}, .normal = {-1, 0, 0}},
                {.is_element = true, .position_mm = {-200, 250, 0}, .normal = {0, 0, 1}},
            };
            luxel_probes *probes;
            snprintf(surfaces, sizeof surfaces, "%s, %s", floor_text,
                     i ? six_of(&boxes[b], matte, six) : box_of(&boxes[b], matte, one));
            luxel_scene *scene =
                scene_of("reflections: 2\n", surfaces, "{type: point, position: [-300, 200, 900], intensity: 10}");
            assert_int_equal(luxel_probe_places(scene, &settings, places, 3, NULL, &probes), LUXEL_OK);
            for (size_t k = 0; k < 3; k++) {
                values[i][k] = luxel_probes_get(probes, k)->reflected.value;
                errors[i][k] = luxel_probes_get(probes, k)->reflected.error;
            }
            luxel_probes_free(probes);
            luxel_scene_free(scene);
        }
        for (int k = 0; k < 3; k++)
            if (!(values[0][k] > 0 && errors[0][k] < 0.1 * values[0][k] &&
                  fabs(values[0][k] - values[1][k]) <= errors[0][k] + errors[1][k]))
                fail_msg("%zu, %d: %g +- %g instead of %g +- %g", b, k, values[0][k], errors[0][k], values[1][k],
                         errors[1][k]);
    }
}

/* A side that is named has its own material, with defaults of its own; the others have the box's. */
static void test_materials(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of("",
                                  "{type: box, center: [0, 0, 200], size: [300, 300, 300], rotate: [0, 45, 0], up: z, "
                                  "material: {model: lambert, diffuse: 0.5}, "
                                  "materials: {top: {model: lambert, diffuse: 0.25}, left: {model: lambert}}}",
                                  "{type: point, position: [0, 0, 1500], intensity: 1}");
    const double x[] = {100, -100}, expected[] = {0.25, 0.8}; /* its top is turned to the right */
    for (int i = 0; i < 2; i++) {
        luxel_probe *probe;
        assert_int_equal(luxel_probe_screen(scene, NULL, x[i], 0, NULL, &probe), LUXEL_OK);
        assert_string_equal(probe->part_name, i ? "left" : "top");
        assert_true(fabs(probe->value / probe->shares[0].irradiance - expected[i]) <= 1e-12);
        luxel_probe_free(probe);
    }
    luxel_scene_free(scene);
}

static bool says(const luxel_scene *scene, const char *id)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    bool found = false;
    assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++)
        found = found || strcmp(luxel_diagnostics_get(diagnostics, i)->id, id) == 0;
    luxel_diagnostics_free(diagnostics);
    return found;
}

/* Sizes above 0 and sides that there are; an observer above it; a light inside lights nothing. */
static void test_words(void **state)
{
    (void)state;
    const char *box = "{type: box, center: [0, 0, 200], size: [300, 300, 300], rotate: [0, 30, 20]}";
    luxel_scene *dark = scene_of("", box, "{type: point, position: [20, 0, 210], intensity: 1}");
    luxel_scene *below = scene_of("", box, "{type: point, position: [0, 0, -900], intensity: 1}");
    luxel_scene *beside = scene_of("", box, "{type: point, position: [900, 0, 100], intensity: 1}");
    assert_true(says(dark, "light-behind") && says(below, "light-behind") && !says(beside, "light-behind"));
    luxel_scene_free(dark);
    luxel_scene_free(below);
    luxel_scene_free(beside);
    static const char scene[] = "luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\n"
                                "observer: {z: %s}\nsurfaces: [{type: box, center: [0, 0, 0], size: %s%s}]\n"
                                "lights: []\n";
    char text[TEXT_SIZE];
    snprintf(text, sizeof text, scene, "900", "[10, 0, 10]", "");
    expect_text_error(text, WANTED(.line = 4, .key = "surfaces[0].size[1]"));
    snprintf(text, sizeof text, scene, "900", "[10, 10, 10]", ", materials: {floor: {diffuse: 1}}");
    expect_text_error(text, WANTED(.line = 4, .message = "floor"));
    snprintf(text, sizeof text, scene, "100", "[10, 10, 400]", "");
    expect_text_error(text, WANTED(.id = "observer-too-low", .message = "surfaces[0]"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sides),       cmocka_unit_test(test_elements),  cmocka_unit_test(test_pictures),
        cmocka_unit_test(test_reflections), cmocka_unit_test(test_materials), cmocka_unit_test(test_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

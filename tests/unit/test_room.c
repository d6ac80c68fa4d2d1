/* SPDX-License-Identifier: MIT */
/*
 * The surface `room` against geometry by hand, and against six rectangles that are written one by one; its edges, past
 * which neither light nor sight may leak; where its observer may stand; the materials of its walls.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/scene.h"
#include "scenes.h"
#include "surface/part.h"

enum { TEXT_SIZE = 3000 };

static double between(double low, double high)
{
    return low + (high - low) * (rand() / (RAND_MAX + 1.0));
}

static luxel_scene *scene_of(const char *observer, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    int length = snprintf(text, sizeof text,
                          "luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: %s\n"
                          "surfaces: [%s]\nlights: [%s]\n",
                          observer, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL));
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* The irradiance of a free element, and the bound of its error. */
static double lit(const luxel_scene *scene, const double place[3], const double normal[3], double *error)
{
    luxel_probe *probe;
    assert_int_equal(luxel_probe_element(scene, NULL, place, normal, NULL, &probe), LUXEL_OK);
    double sum = 0;
    *error = probe->error;
    for (size_t i = 0; i < probe->share_count; i++)
        sum += probe->shares[i].irradiance;
    luxel_probe_free(probe);
    return sum;
}

/* A box by its lowest and highest places. */
struct box {
    double low[3], high[3];
};

static struct box random_box(void)
{
    struct box box;
    for (int i = 0; i < 3; i++) {
        box.low[i] = between(-4000, -300);
        box.high[i] = between(300, 4000);
    }
    return box;
}

static const char *room_of(const struct box *box, const char *more, char text[TEXT_SIZE])
{
    snprintf(text, TEXT_SIZE, "{type: room, center: [%.17g, %.17g, %.17g], size: [%.17g, %.17g, %.17g]%s}",
             (box->low[0] + box->high[0]) / 2, (box->low[1] + box->high[1]) / 2, (box->low[2] + box->high[2]) / 2,
             box->high[0] - box->low[0], box->high[1] - box->low[1], box->high[2] - box->low[2], more);
    return text;
}

/* A place on wall w (left, right, lower, upper, back, front) and the normal there. */
static void on_wall(const struct box *box, int w, double place[3], double normal[3])
{
    for (int i = 0; i < 3; i++) {
        place[i] = between(box->low[i], box->high[i]);
        normal[i] = 0;
    }
    place[w / 2] = w % 2 ? box->high[w / 2] : box->low[w / 2];
    normal[w / 2] = w % 2 ? -1 : 1;
}

/* Under a lamp with the intensity I each wall has I cos / r^2, at every place and in every room. */
static void test_walls_under_a_lamp(void **state)
{
    (void)state;
    for (int trial = 0; trial < 60; trial++) {
        const struct box box = random_box();
        char room[TEXT_SIZE], light[200];
        double lamp[3], place[3], normal[3], error;
        for (int i = 0; i < 3; i++)
            lamp[i] = between(box.low[i], box.high[i]);
        snprintf(light, sizeof light, "{type: point, position: [%.17g, %.17g, %.17g], intensity: 7}", lamp[0], lamp[1],
                 lamp[2]);
        luxel_scene *scene = scene_of("{z: 9000}", room_of(&box, "", room), light);
        for (int w = 0; w < 6; w++) {
            on_wall(&box, w, place, normal);
            double square = 0, height = 0;
            for (int i = 0; i < 3; i++) {
                square += (lamp[i] - place[i]) * (lamp[i] - place[i]);
                height += (lamp[i] - place[i]) * normal[i];
            }
            const double expected = 7 * height / (square * sqrt(square)) * 1e6,
                         value = lit(scene, place, normal, &error);
            if (!(fabs(value - expected) <= 1e-12 * expected && error <= 1e-12 * expected))
                fail_msg("wall %d: %.17g instead of %.17g", w, value, expected);
        }
        luxel_scene_free(scene);
    }
}

/* Moves some coordinates of a place on a wall onto the edge, or into the corner, where it meets others. */
static void onto_edges(const struct box *box, int edges, int w, double place[3])
{
    for (int i = 0; i < 3 && edges > 0; i++)
        if (i != w / 2) {
            place[i] = rand() % 2 ? box->low[i] : box->high[i];
            edges--;
        }
}

/* What stands outside lights nothing inside, neither on walls nor along their edges nor in their corners; what stands
 * inside, or on a wall, is hidden from no place of any wall. */
static void test_no_light_leaks(void **state)
{
    (void)state;
    for (int trial = 0; trial < 400; trial++) {
        const struct box box = random_box();
        char room[TEXT_SIZE], lights[600];
        double out[3], in[3], way[3], place[3], normal[3], bare, error, unshadowed;
        const int side = rand() % 3, beyond = rand() % 6;
        for (int i = 0; i < 3; i++) {
            in[i] = between(box.low[i], box.high[i]);
            out[i] = rand() % 3 ? between(-9000, 9000) : rand() % 2 ? box.low[i] : box.high[i];
            way[i] = between(-1, 1);
        }
        out[side] = rand() % 2 ? box.high[side] + between(1e-3, 3000) : box.low[side] - between(1e-3, 3000);
        if (beyond < 3)
            in[beyond] = rand() % 2 ? box.low[beyond] : box.high[beyond];
        snprintf(lights, sizeof lights,
                 "{type: point, position: [%.17g, %.17g, %.17g], intensity: 7}, "
                 "{type: distant, direction: [%.17g, %.17g, %.17g], irradiance: 5}",
                 out[0], out[1], out[2], way[0], way[1], way[2]);
        luxel_scene *dark = scene_of("{z: 9000}", room_of(&box, "", room), lights);
        snprintf(lights, sizeof lights, "{type: point, position: [%.17g, %.17g, %.17g], intensity: 7}", in[0], in[1],
                 in[2]);
        luxel_scene *bright = scene_of("{z: 9000}", room, lights), *open = luxel_scene_copy(bright);
        assert_int_equal(luxel_scene_set(open, "shadows=none", NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(open, NULL), LUXEL_OK);
        for (int w = 0; w < 6; w++)
            for (int edges = 0; edges < 3; edges++) {
                on_wall(&box, w, place, normal);
                onto_edges(&box, edges, w, place);
                assert_true(lit(dark, place, normal, &error) == 0 && error == 0);
                bare = lit(open, place, normal, &unshadowed);
                /* where the lamp stands in the plane of the wall that an edge belongs to, its bound may cover both */
                assert_true(lit(bright, place, normal, &error) == bare && (error == unshadowed || beyond < 3));
            }
        luxel_scene_free(dark);
        luxel_scene_free(bright);
        luxel_scene_free(open);
    }
}

/* Pictures: the screen shows the back wall to its very edges, and a lamp outside lights no pixel of it. */
static void test_pictures_keep_light_out(void **state)
{
    (void)state;
    static const char *const lights[] = {
        "{type: point, position: [-900, 130, 100], intensity: 9}",
        "{type: point, position: [-400.0001, 0, -399], intensity: 9}",
        "{type: distant, direction: [1, -1, -1], irradiance: 5}",
        "{type: distant, direction: [0, -1, -1e-9], irradiance: 5}",
        "{type: distant, direction: [-1, 0, 0], irradiance: 5}",
    };
    for (size_t i = 0; i < LX_COUNT(lights); i++)
        for (int in_perspective = 0; in_perspective < 2; in_perspective++) {
            luxel_field *field;
            luxel_scene *scene = scene_of(in_perspective ? "{z: 390, projection: perspective}" : "{z: 2000}",
                                          "{type: room, center: [0, 0, 0], size: [800, 800, 800]}", lights[i]);
            assert_int_equal(luxel_scene_set(scene, "screen.sampling=nodes", NULL), LUXEL_OK);
            assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
            assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
            assert_int_equal(luxel_field_statistics(field)->surface_pixels, 80 * 80);
            assert_true(luxel_field_statistics(field)->maximum.value == 0);
            luxel_field_free(field);
            luxel_scene_free(scene);
        }
}

/* Batches of free elements on walls, with the walls' normals, with others, and on the outside, have what each has by
 * itself. */
static void test_batches(void **state)
{
    enum { PLACES = 300 };
    (void)state;
    for (int turned = 0; turned < 3; turned++) {
        const struct box box = {{-700, -500, -900}, {800, 600, 1000}};
        char room[TEXT_SIZE];
        luxel_place places[PLACES] = {{.is_element = false}};
        luxel_value values[PLACES];
        luxel_evaluator *evaluator;
        luxel_scene *scene = scene_of("{z: 9000}", room_of(&box, "", room),
                                      "{type: point, position: [100, 50, 20], intensity: 3}, "
                                      "{type: point, position: [1400, 50, 20], intensity: 3}, "
                                      "{type: distant, direction: [0.3, -0.5, -0.6], irradiance: 2}");
        assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
        size_t lit_count = 0;
        for (int k = 0; k < PLACES; k++) {
            places[k].is_element = true;
            on_wall(&box, k % 6, places[k].position_mm, places[k].normal);
            for (int i = 0; i < 3 && turned && (turned == 2 || k % 3 > 0); i++)
                places[k].normal[i] = turned == 2 || k % 3 == 1 ? -places[k].normal[i] : between(-1, 1);
        }
        assert_int_equal(luxel_evaluate_places(evaluator, places, PLACES, values, NULL), LUXEL_OK);
        for (int k = 0; k < PLACES; k++) {
            luxel_value alone;
            luxel_evaluate_place(evaluator, &places[k], &alone, NULL);
            assert_true(values[k].value == alone.value && values[k].error == alone.error);
            assert_true(values[k].surface == 0 && values[k].part == (unsigned)k % 6 && alone.part == (unsigned)k % 6);
            lit_count += alone.value > 0;
        }
        assert_true(lit_count > PLACES / 3);
        luxel_evaluator_free(evaluator);
        luxel_scene_free(scene);
    }
}

/* Lamps of some size, one of them mounted on the ceiling, lose nothing to walls: the picture is that without shadows,
 * to the last bit.  From outside they light nothing. */
static void test_area_lamps(void **state)
{
    (void)state;
    static const char *const inside =
        "{type: planar, rectangle: {center: [50, 400, 0], size: [200, 100], axis: [0, -1, 0]}, radiance: 30}, "
        "{type: planar, disk: {center: [-400, 0, 0], radius: 90, axis: [1, 0, 0]}, radiance: 20}, "
        "{type: volume, cylinder: {center: [0, 0, 0], radius: 20, height: 800, axis: [0, 1, 0]}, radiance: 10}, "
        "{type: volume, sphere: {center: [300, -300, -300], radius: 100}, radiance: 10}";
    static const char *const outside =
        "{type: planar, rectangle: {center: [50, 401, 0], size: [2000, 1000], axis: [0, -1, 0]}, radiance: 30}, "
        "{type: volume, sphere: {center: [600, -300, -300], radius: 100}, radiance: 10}";
    for (int is_outside = 0; is_outside < 2; is_outside++) {
        luxel_field *fields[2];
        luxel_scene *scene =
            scene_of("{z: 390, projection: perspective}",
                     "{type: room, center: [0, 0, 0], size: [800, 800, 800], material: {model: lambert}}",
                     is_outside ? outside : inside);
        assert_int_equal(luxel_render(scene, NULL, NULL, &fields[0]), LUXEL_OK);
        assert_int_equal(luxel_scene_set(scene, "shadows=none", NULL), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        assert_int_equal(luxel_render(scene, NULL, NULL, &fields[1]), LUXEL_OK);
        assert_true(luxel_field_statistics(fields[1])->maximum.value > 0);
        for (unsigned pixel = 0; pixel < 80 * 80; pixel++) {
            const double value = luxel_field_value(fields[0], pixel % 80, pixel / 80);
            assert_true(value == (is_outside ? 0 : luxel_field_value(fields[1], pixel % 80, pixel / 80)));
        }
        luxel_field_free(fields[0]);
        luxel_field_free(fields[1]);
        luxel_scene_free(scene);
    }
}

/* Six rectangles written by hand, in the order of the walls. */
static const char *six_of(const struct box *box, const char *more, char text[TEXT_SIZE])
{
    static const char *const axes[] = {"[1, 0, 0]", "[-1, 0, 0]", "[0, 1, 0]", "[0, -1, 0]", "[0, 0, 1]", "[0, 0, -1]"};
    size_t length = 0;
    for (int w = 0; w < 6; w++) {
        double center[3], size[3];
        const int across = w / 2 == 0 ? 2 : 0, upward = w / 2 == 1 ? 2 : 1;
        for (int i = 0; i < 3; i++) {
            size[i] = box->high[i] - box->low[i];
            center[i] = (box->low[i] + box->high[i]) / 2;
        }
        center[w / 2] += (w % 2 ? 1 : -1) * size[w / 2] / 2;
        length +=
            (size_t)snprintf(text + length, TEXT_SIZE - length,
                             "%s{type: rectangle, center: [%.17g, %.17g, %.17g], size: [%.17g, %.17g], axis: %s%s}",
                             w ? ", " : "", center[0], center[1], center[2], size[across], size[upward], axes[w], more);
    }
    return text;
}

/* An observer within sees the same picture, to the last bit, in either precision; and the probes agree. */
static void test_is_six_rectangles(void **state)
{
    (void)state;
    for (int trial = 0; trial < 12; trial++) {
        struct box box = random_box();
        char room[TEXT_SIZE], six[TEXT_SIZE], lights[600], observer[100];
        const char *more = ", material: {diffuse: 0.6, specular: 0.3, shininess: 30}";
        const double eye = between(50, 250);
        snprintf(observer, sizeof observer, "{z: %.17g, projection: perspective}", eye);
        snprintf(lights, sizeof lights,
                 "{type: point, position: [%.17g, %.17g, %.17g], intensity: 7}, "
                 "{type: spot, position: [%.17g, 0, 20], axis: [1, 0.2, -1], intensity: 3, inner: 20, outer: 40}",
                 between(-200, 200), between(-200, 200), between(-250, 250), between(-250, 250));
        luxel_scene *scenes[2] = {scene_of(observer, room_of(&box, more, room), lights),
                                  scene_of(observer, six_of(&box, more, six), lights)};
        for (int precision = 0; precision < 2; precision++) {
            luxel_settings settings;
            luxel_field *fields[2];
            luxel_settings_init(&settings);
            settings.precision = precision ? LUXEL_DOUBLE : LUXEL_SINGLE;
            for (int i = 0; i < 2; i++)
                assert_int_equal(luxel_render(scenes[i], &settings, NULL, &fields[i]), LUXEL_OK);
            for (unsigned pixel = 0; pixel < 80 * 80; pixel++)
                assert_true(luxel_field_value(fields[0], pixel % 80, pixel / 80) ==
                            luxel_field_value(fields[1], pixel % 80, pixel / 80));
            luxel_field_free(fields[0]);
            luxel_field_free(fields[1]);
        }
        for (int k = 0; k < 200; k++) {
            luxel_probe *probes[2];
            const double x = between(-400, 400), y = between(-400, 400);
            for (int i = 0; i < 2; i++)
                assert_int_equal(luxel_probe_screen(scenes[i], NULL, x, y, NULL, &probes[i]), LUXEL_OK);
            assert_true(probes[0]->value == probes[1]->value && probes[0]->error == probes[1]->error);
            assert_int_equal(probes[0]->part, probes[1]->surface);
            assert_int_equal(probes[0]->surface, 0);
            luxel_probe_free(probes[0]);
            luxel_probe_free(probes[1]);
        }
        luxel_scene_free(scenes[0]);
        luxel_scene_free(scenes[1]);
    }
}

/* Lines of sight from inside hit a wall, also those that lead exactly to an edge or into a corner. */
static void test_no_sight_leaks(void **state)
{
    enum { BOXES = 100, RAYS = 1500 };
    extern const struct lx_surface_kind lx_room_kind;
    (void)state;
    for (int trial = 0; trial < BOXES; trial++) {
        struct box box = random_box();
        struct lx_part walls[6];
        char text[TEXT_SIZE], room[TEXT_SIZE];
        luxel_scene *scene = scene_of("{z: 9000}", room_of(&box, "", room), "");
        snprintf(text, sizeof text, "%s", room);
        const struct lx_item *item = &lx_scene_parameters(scene)->surfaces.items[0];
        for (unsigned w = 0; w < 6; w++)
            lx_part_make(&lx_room_kind, item->parameters, w, &walls[w]);
        for (int k = 0; k < RAYS; k++) {
            struct lx_ray ray;
            double place[3], normal[3];
            const int w = rand() % 6;
            on_wall(&box, w, place, normal);
            onto_edges(&box, 1 + rand() % 2, w, place);
            for (int i = 0; i < 3; i++) {
                ray.origin_mm[i] = between(box.low[i], box.high[i]);
                ray.direction[i] = place[i] - ray.origin_mm[i];
            }
            bool hit = false;
            for (int i = 0; i < 6 && !hit; i++)
                hit = walls[i].kind->hit(&walls[i].shape, &ray).exists;
            assert_true(hit);
        }
        luxel_scene_free(scene);
    }
}

/* Before its front wall, above its back wall; from the side in perspective, too; but not behind it. */
static void test_observers(void **state)
{
    (void)state;
    const char *room = "{type: room, center: [0, 0, 500], size: [400, 400, 1000]}";
    const char *light = "{type: point, position: [0, 0, 800], intensity: 1}";
    static const char *const good[] = {"{z: 1500}", "{z: 700}", "{z: 1500, projection: perspective}",
                                       "{z: 700, projection: perspective}"};
    for (size_t i = 0; i < LX_COUNT(good); i++) {
        luxel_probe *probe;
        luxel_scene *scene = scene_of(good[i], room, light);
        assert_int_equal(luxel_probe_screen(scene, NULL, 10, 20, NULL, &probe), LUXEL_OK);
        assert_true(probe->on_surface && probe->position_mm[2] == 0);
        assert_string_equal(probe->part_name, "back");
        assert_string_equal(luxel_scene_part_name(scene, 0, probe->part), "back");
        luxel_probe_free(probe);
        luxel_scene_free(scene);
    }
    char text[TEXT_SIZE];
    snprintf(text, sizeof text,
             "luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: {z: 100}\n"
             "surfaces: [{type: room, center: [0, 0, 500], size: [400, 400, 600]}]\nlights: []\n");
    expect_text_error(text, WANTED(.id = "observer-below-room", .line = 3, .column = 15, .key = "observer.z",
                                   .message = "surfaces[0], at z = 200", .hint = "200"));
}

/* The wall and the colour that are seen through a point, -1 off every surface. */
static double value_at(const luxel_scene *scene, double x, double y)
{
    luxel_probe *probe;
    assert_int_equal(luxel_probe_screen(scene, NULL, x, y, NULL, &probe), LUXEL_OK);
    const double value = probe->has_value ? probe->value / probe->shares[0].irradiance : -1;
    luxel_probe_free(probe);
    return value;
}

/* A material of a wall begins with the defaults, not with those of the room; walls without one have the room's. */
static void test_materials(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of("{z: 500, projection: perspective}",
                                  "{type: room, center: [0, 0, 0], size: [600, 600, 2000], "
                                  "material: {model: lambert, diffuse: 0.5}, "
                                  "materials: {floor: {model: lambert, diffuse: 0.25}, left: {model: lambert}}}",
                                  "{type: point, position: [0, 0, 100], intensity: 1}");
    assert_true(fabs(value_at(scene, 0, -380) - 0.25) <= 1e-12); /* floor */
    assert_true(fabs(value_at(scene, -380, 0) - 0.8) <= 1e-12);  /* left */
    assert_true(fabs(value_at(scene, 380, 0) - 0.5) <= 1e-12);   /* right */
    assert_true(fabs(value_at(scene, 0, 0) - 0.5) <= 1e-12);     /* back */
    assert_int_equal(luxel_scene_set(scene, "surfaces[0].materials.back.diffuse=0.1", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "surfaces.0.materials.back.model=lambert", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_true(fabs(value_at(scene, 0, 0) - 0.1) <= 1e-12);
    char *text;
    luxel_scene *again;
    assert_int_equal(luxel_scene_write_text(scene, &text), LUXEL_OK);
    assert_int_equal(load(text, NULL, &again), LUXEL_OK);
    assert_true(fabs(value_at(again, 0, 0) - 0.1) <= 1e-12);
    luxel_text_free(text);
    luxel_scene_free(again);
    assert_int_equal(luxel_scene_set(scene, "surfaces[0].materials.flor.diffuse=0.1", NULL), LUXEL_ERROR_PATH);
    luxel_scene_free(scene);
}

/* The name and the material of each wall follow from what is up: the same walls by other names shine alike. */
static void test_up(void **state)
{
    (void)state;
    static const char *const names[2][6] = {{"left", "right", "floor", "ceiling", "back", "front"},
                                            {"left", "right", "front", "back", "floor", "ceiling"}};
    for (int trial = 0; trial < 20; trial++) {
        const struct box box = random_box();
        luxel_scene *scenes[2];
        for (int up = 0; up < 2; up++) {
            char room[TEXT_SIZE], more[TEXT_SIZE / 2], light[200];
            int length = snprintf(more, sizeof more, ", up: %s, materials: {", up ? "z" : "y");
            for (int w = 0; w < 6; w++)
                length += snprintf(more + length, sizeof more - (size_t)length,
                                   "%s: {model: lambert, over_pi: true, diffuse: 0.%d}%s", names[up][w], w + 1,
                                   w < 5 ? ", " : "}");
            snprintf(light, sizeof light, "{type: point, position: [%g, %g, %g], intensity: 7}",
                     (box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2, (box.low[2] + box.high[2]) / 2);
            scenes[up] = scene_of("{z: 9000}", room_of(&box, more, room), light);
        }
        for (int w = 0; w < 6; w++) {
            double place[3], normal[3], values[2];
            on_wall(&box, w, place, normal);
            for (int up = 0; up < 2; up++) {
                luxel_probe *probe;
                assert_int_equal(luxel_probe_element(scenes[up], NULL, place, normal, NULL, &probe), LUXEL_OK);
                assert_true(probe->has_value && probe->lies_on_surface);
                assert_string_equal(probe->part_name, names[up][w]);
                assert_true(fabs(probe->value * M_PI - (w + 1) / 10.0 * probe->shares[0].irradiance) <=
                            1e-12 * probe->value);
                values[up] = probe->value;
                luxel_probe_free(probe);
            }
            assert_true(values[0] == values[1]);
        }
        luxel_scene_free(scenes[0]);
        luxel_scene_free(scenes[1]);
    }
    luxel_scene *plain = scene_of("{z: 900}", "{type: room, center: [0, 0, 0], size: [9, 9, 9]}", "");
    luxel_conventions *all;
    assert_int_equal(luxel_find_conventions(plain, NULL, &all), LUXEL_OK);
    for (size_t i = 0; i < all->count; i++)
        assert_string_not_equal(all->list[i].key, "up");
    luxel_conventions_free(all);
    luxel_scene_free(plain);
}

#define BEGINNING                                                                                                      \
    "luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: {z: 900}\nlights: []\nsurfaces:\n"   \
    "  - type: room\n    center: [0, 0, 0]\n"

static void test_wrong_rooms(void **state)
{
    (void)state;
    expect_text_error(BEGINNING "    size: [100, 100, 0]\n", WANTED(.id = "out-of-range", .line = 8, .column = 22));
    expect_text_error(BEGINNING "    size: [100, 100]\n", WANTED(.line = 8, .column = 11));
    expect_text_error(BEGINNING "    size: [1, 1, 1]\n    materials: {ceilling: {diffuse: 1}}\n",
                      WANTED(.id = "unknown-key", .line = 9, .column = 17, .hint = "ceiling"));
    expect_text_error(BEGINNING "    size: [1, 1, 1]\n    materials: {floor: {diffuse: -1}}\n",
                      WANTED(.line = 9, .column = 34, .key = "surfaces[0].materials.floor.diffuse"));
    expect_text_error(BEGINNING "    size: [1, 1, 1]\n    materials: {floor: {difuse: 1}}\n",
                      WANTED(.id = "unknown-key", .line = 9, .column = 25, .hint = "diffuse"));
    expect_text_error(BEGINNING "    size: [1, 1, 1]\n    materials: [1]\n", WANTED(.line = 9, .column = 16));
    expect_text_error(BEGINNING "    size: [1, 1, 1]\n    up: [0, 0, 1]\n", WANTED(.line = 9, .column = 9));
    expect_text_error(BEGINNING "    size: [1, 1, 1]\n    up: x\n", WANTED(.line = 9, .column = 9));
    expect_text_error(BEGINNING, WANTED(.id = "missing-key", .key = "surfaces[0].size"));
}

/* An observer inside sees no room as a whole, and is not told so; a lamp outside of it is. */
static void test_advice(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene =
        scene_of("{z: 500, projection: perspective}", "{type: room, center: [0, 0, 0], size: [6000, 6000, 2000]}",
                 "{type: point, position: [0, 0, 300], intensity: 1}");
    assert_int_equal(luxel_scene_set(scene, "screen.resolution=[400, 400]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 0);
    assert_int_equal(luxel_scene_set(scene, "lights[0].position=[0, 0, 1300]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    expect_entry(diagnostics, 0, WANTED(.id = "light-behind"));
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_walls_under_a_lamp),
        cmocka_unit_test(test_no_light_leaks),
        cmocka_unit_test(test_pictures_keep_light_out),
        cmocka_unit_test(test_batches),
        cmocka_unit_test(test_area_lamps),
        cmocka_unit_test(test_is_six_rectangles),
        cmocka_unit_test(test_no_sight_leaks),
        cmocka_unit_test(test_observers),
        cmocka_unit_test(test_materials),
        cmocka_unit_test(test_up),
        cmocka_unit_test(test_wrong_rooms),
        cmocka_unit_test(test_advice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

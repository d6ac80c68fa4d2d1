/* SPDX-License-Identifier: MIT */
/*
 * Reflected light in random furnished rooms, against paths that share nothing with the library: what both say of each
 * place must agree within their bounds.  The witness is itself tried by points of a cube.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "campaign.h"
#include "path_witness.h"
#include "place.h"
#include "random_scenes.h"
#include "scenes.h"

enum { TEXT_SIZE = 30000, PLACES = 5 };

/* A room with its text under way; lengths in metres, from the middle of the room. */
struct rooms {
    struct randomness random;
    struct path_room room;
    double half[3];
    char text[TEXT_SIZE];
    int length;
    const char *mesh_path;
};

static void say(struct rooms *rooms, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void say(struct rooms *rooms, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    rooms->length += vsnprintf(rooms->text + rooms->length, (size_t)(TEXT_SIZE - rooms->length), format, arguments);
    va_end(arguments);
    assert_true(rooms->length < TEXT_SIZE);
}

static void say_vector(struct rooms *rooms, const char *key, const double vector[3], double scale)
{
    say(rooms, ", %s: [%.17g, %.17g, %.17g]", key, scale * vector[0], scale * vector[1], scale * vector[2]);
}

static double gap(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

/* Whether a place is outside all balls, and so far from their surfaces. */
static bool is_clear(const struct path_room *room, const double place[3], double least)
{
    for (size_t i = 0; i < room->thing_count; i++)
        if (room->things[i].radius > 0 && gap(room->things[i].center, place) < room->things[i].radius + least)
            return false;
    return true;
}

/* A place inside the room, so far from its walls. */
static void random_place(struct rooms *rooms, double margin, double place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = uniform(&rooms->random, margin - rooms->half[i], rooms->half[i] - margin);
}

/* A unit axis, often that of a coordinate, and what is up beside it. */
static void random_frame(struct rooms *rooms, double axis[3], double up[3])
{
    if (pick(&rooms->random, 3) > 0) {
        const int i = pick(&rooms->random, 3);
        memset(axis, 0, 3 * sizeof *axis);
        axis[i] = pick(&rooms->random, 2) ? 1 : -1;
    } else {
        random_direction(&rooms->random, axis);
    }
    for (int i = 0; i < 3; i++)
        up[i] = fabs(axis[1]) > 0.8 ? i == 2 : i == 1;
}

static void add_wall(struct path_room *room, const double half[3], int way, double side, double reflectance)
{
    struct path_thing *wall = &room->things[room->thing_count++];
    *wall = (struct path_thing){.reflectance = reflectance};
    wall->center[way] = side * half[way];
    wall->axis[way] = -side;
    wall->across[(way + 1) % 3] = wall->upward[(way + 2) % 3] = 1;
    wall->half[0] = half[(way + 1) % 3];
    wall->half[1] = half[(way + 2) % 3];
}

static void add_walls(struct rooms *rooms, double darkest, double brightest)
{
    static const char *const names[] = {"left", "right", "floor", "ceiling", "back", "front"};
    for (int i = 0; i < 3; i++)
        rooms->half[i] = uniform(&rooms->random, 1.2, 3);
    say(rooms, "  - {type: room, center: [0, 0, 0], size: [%.17g, %.17g, %.17g], materials: {", 2000 * rooms->half[0],
        2000 * rooms->half[1], 2000 * rooms->half[2]);
    for (int w = 0; w < 6; w++) {
        const double reflectance = uniform(&rooms->random, darkest, brightest);
        add_wall(&rooms->room, rooms->half, w / 2, w % 2 ? 1 : -1, reflectance);
        say(rooms, "%s%s: {model: lambert, diffuse: %.17g, over_pi: true}", w ? ", " : "", names[w], reflectance);
    }
    say(rooms, "}}\n");
}

static void add_plate(struct rooms *rooms, double reflectance)
{
    struct path_thing *plate = &rooms->room.things[rooms->room.thing_count++];
    double up[3];
    *plate = (struct path_thing){.reflectance = reflectance};
    random_frame(rooms, plate->axis, up);
    path_frame(plate->axis, up, plate->across, plate->upward);
    for (int i = 0; i < 2; i++)
        plate->half[i] = uniform(&rooms->random, 0.1, 0.7);
    random_place(rooms, hypot(plate->half[0], plate->half[1]) + 0.02, plate->center);
    if (plate->axis[2] * 30 < plate->axis[0] * plate->center[0] + plate->axis[1] * plate->center[1] +
                                  plate->axis[2] * plate->center[2]) /* a plate is seen from its front */
        for (int i = 0; i < 3; i++) {
            plate->axis[i] = -plate->axis[i];
            plate->across[i] = -plate->across[i];
        }
    if (plate->upward[1] == 1 && pick(&rooms->random, 2)) /* stands on the floor */
        plate->center[1] = plate->half[1] - rooms->half[1];
    say(rooms, "  - {type: rectangle, size: [%.17g, %.17g]", 2000 * plate->half[0], 2000 * plate->half[1]);
    say_vector(rooms, "center", plate->center, 1000);
    say_vector(rooms, "axis", plate->axis, 1);
    say_vector(rooms, "up", up, 1);
    say(rooms, ", material: {model: lambert, diffuse: %.17g, over_pi: true}}\n", reflectance);
}

static void add_ball(struct rooms *rooms, double reflectance)
{
    struct path_thing ball = {.reflectance = reflectance, .radius = uniform(&rooms->random, 0.1, 0.4)};
    random_place(rooms, ball.radius + 0.02, ball.center);
    if (!is_clear(&rooms->room, ball.center, ball.radius + 0.02))
        return;
    rooms->room.things[rooms->room.thing_count++] = ball;
    say(rooms, "  - {type: sphere, radius: %.17g", 1000 * ball.radius);
    say_vector(rooms, "center", ball.center, 1000);
    say(rooms, ", material: {model: lambert, diffuse: %.17g, over_pi: true}}\n", reflectance);
}

/* A closed body of eight triangles, at random no regular one, or as many loose triangles, in a file. */
static void add_mesh(struct rooms *rooms, double reflectance)
{
    enum { FACES = 8 };
    double corners[FACES][3][3], center[3], tips[6][3];
    const bool is_body = pick(&rooms->random, 2);
    FILE *file = fopen(rooms->mesh_path, "w");
    assert_non_null(file);
    random_place(rooms, 0.55, center);
    for (int t = 0; t < 6; t++)
        for (int i = 0; i < 3; i++)
            tips[t][i] = center[i] + (t / 2 == i ? (t % 2 ? 1 : -1) * uniform(&rooms->random, 0.15, 0.5)
                                                 : uniform(&rooms->random, -0.1, 0.1));
    fprintf(file, "OFF\n%d %d 0\n", 3 * FACES, FACES);
    for (int f = 0; f < FACES; f++)
        for (int c = 0; c < 3; c++) {
            /* an odd number of low tips turns the corners round */
            const int turned = (f ^ f >> 1 ^ f >> 2) & 1, k = turned ? c : 2 - c;
            for (int i = 0; i < 3; i++)
                corners[f][c][i] =
                    is_body ? tips[2 * k + (f >> k & 1)][i] : center[i] + uniform(&rooms->random, -0.5, 0.5);
            fprintf(file, "%.17g %.17g %.17g\n", 1000 * corners[f][c][0], 1000 * corners[f][c][1],
                    1000 * corners[f][c][2]);
        }
    for (int f = 0; f < FACES; f++) {
        fprintf(file, "3 %d %d %d\n", 3 * f, 3 * f + 1, 3 * f + 2);
        rooms->room.things[rooms->room.thing_count++] = path_triangle((const double(*)[3])corners[f], reflectance);
    }
    assert_int_equal(fclose(file), 0);
    say(rooms, "  - {type: mesh, file: '%s', material: {model: lambert, diffuse: %.17g, over_pi: true}}\n",
        rooms->mesh_path, reflectance);
}

static void add_lamp(struct rooms *rooms)
{
    struct path_lamp lamp = {0};
    double up[3];
    do
        random_place(rooms, 0.6, lamp.center);
    while (!is_clear(&rooms->room, lamp.center, 0.6));
    if (pick(&rooms->random, 2)) {
        lamp.intensity = uniform(&rooms->random, 50, 500);
        say(rooms, "  - {type: point, intensity: %.17g", lamp.intensity);
        say_vector(rooms, "position", lamp.center, 1000);
        say(rooms, "}\n");
    } else {
        lamp.luminance = uniform(&rooms->random, 500, 5000);
        random_frame(rooms, lamp.axis, up);
        path_frame(lamp.axis, up, lamp.across, lamp.upward);
        for (int i = 0; i < 2; i++)
            lamp.half[i] = uniform(&rooms->random, 0.05, 0.3);
        say(rooms, "  - {type: planar, radiance: %.17g, rectangle: {size: [%.17g, %.17g]", lamp.luminance,
            2000 * lamp.half[0], 2000 * lamp.half[1]);
        say_vector(rooms, "center", lamp.center, 1000);
        say_vector(rooms, "axis", lamp.axis, 1);
        say_vector(rooms, "up", up, 1);
        say(rooms, "}}\n");
    }
    rooms->room.lamps[rooms->room.lamp_count++] = lamp;
}

/* A furnished room with one or two lamps. */
static void furnish(struct rooms *rooms, int plates, int balls, bool has_mesh)
{
    const double darkest = 0.1, brightest = uniform(&rooms->random, 0.3, 0.9);
    say(rooms, "luxel: 1\nunits: photometric\nreflections: all\nscreen: {width: 400, height: 400, resolution: [4, 4]}\n"
               "observer: {z: 30000, projection: perspective}\nsurfaces:\n");
    add_walls(rooms, darkest, brightest);
    for (int i = 0; i < plates; i++)
        add_plate(rooms, uniform(&rooms->random, darkest, brightest));
    for (int i = 0; i < balls; i++)
        add_ball(rooms, uniform(&rooms->random, darkest, brightest));
    if (has_mesh)
        add_mesh(rooms, uniform(&rooms->random, darkest, brightest));
    say(rooms, "lights:\n");
    const int lamps = 1 + pick(&rooms->random, 2);
    for (int i = 0; i < lamps; i++)
        add_lamp(rooms);
}

/* Places on walls, and anywhere in the room. */
static void choose_places(struct rooms *rooms, luxel_place places[PLACES])
{
    for (int p = 0; p < PLACES; p++) {
        double place[3], normal[3];
        do {
            random_place(rooms, 0.01, place);
            random_direction(&rooms->random, normal);
            if (p % 2 == 0) {
                const struct path_thing *wall = &rooms->room.things[pick(&rooms->random, 6)];
                for (int i = 0; i < 3; i++) {
                    place[i] = wall->axis[i] != 0 ? wall->center[i] : place[i];
                    normal[i] = wall->axis[i];
                }
            }
        } while (!is_clear(&rooms->room, place, 0.01));
        places[p] = (luxel_place){.is_element = true};
        for (int i = 0; i < 3; i++) {
            places[p].position_mm[i] = 1000 * place[i];
            places[p].normal[i] = normal[i];
        }
    }
}

/* ---- tests ---- */

static void judge(const struct rooms *rooms, const luxel_place *place, const luxel_probe *probe, size_t paths, int seed)
{
    double at[3];
    for (int i = 0; i < 3; i++)
        at[i] = place->position_mm[i] / 1000;
    const struct path_interval witness = path_reflected(&rooms->room, at, place->normal, paths, (uint64_t)seed);
    const double off = fabs(probe->reflected_irradiance - witness.value);
    if (!(off <= probe->reflected.error + witness.error))
        fail_msg("room %d at %g %g %g: %.6g with the bound %.2g, the witness has %.6g with %.2g\n%s", seed, at[0],
                 at[1], at[2], probe->reflected_irradiance, probe->reflected.error, witness.value, witness.error,
                 rooms->text);
}

static void try_room(const struct place *place, int seed, size_t paths, int plates, int balls, bool has_mesh)
{
    static struct rooms rooms;
    rooms = (struct rooms){.random = {(uint64_t)seed * 7919 + 1}};
    char path[64];
    snprintf(path, sizeof path, "%s/mesh.off", place->folder);
    rooms.mesh_path = path;
    luxel_place places[PLACES];
    luxel_probes *probes;
    luxel_scene *scene;
    luxel_settings settings;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    furnish(&rooms, plates, balls, has_mesh);
    choose_places(&rooms, places);
    if (load(rooms.text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s\n%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL), rooms.text);
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = 0.02;
    assert_int_equal(luxel_probe_places(scene, &settings, places, PLACES, diagnostics, &probes), LUXEL_OK);
    for (int p = 0; p < PLACES; p++)
        judge(&rooms, &places[p], luxel_probes_get(probes, (size_t)p), paths, seed);
    luxel_probes_free(probes);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* Few and small rooms each time; a campaign tries more and fuller ones, with more paths. */
static void random_rooms(void **state)
{
    enum { SMALL = 5 };
    const int count = scenes_to_try(SMALL);
    for (int i = 0; i < count; i++) {
        struct randomness random = {(uint64_t)i + 77};
        const int plates = i < SMALL ? i % 3 : pick(&random, pick(&random, 8) ? 9 : 45);
        const bool has_mesh = i < SMALL ? i >= 3 : pick(&random, 2);
        try_room(*state, i, i < SMALL ? 20000 : 200000, plates, i < SMALL ? i == 1 : pick(&random, 3), has_mesh);
    }
}

/* 10 000 lm from the middle of a cube of 4 m: eight digits by collocation; what is a twentieth off is told. */
static void witness(void **state)
{
    (void)state;
    const double half[3] = {2, 2, 2}, reflectances[] = {0.5, 0.7}, truths[] = {107.78338, 248.68833};
    for (int r = 0; r < 2; r++) {
        struct path_room room = {.lamp_count = 1, .lamps = {{.intensity = 10000 / (4 * M_PI)}}};
        for (int w = 0; w < 6; w++)
            add_wall(&room, half, w / 2, w % 2 ? 1 : -1, reflectances[r]);
        const struct path_interval found =
            path_reflected(&room, (const double[]){1, 1, -2}, (const double[]){0, 0, 1}, 100000, 1);
        assert_true(fabs(found.value - truths[r]) <= found.error);
        assert_true(found.error < 0.05 * truths[r]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(witness),
                                       cmocka_unit_test_setup_teardown(random_rooms, make_place, remove_place)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

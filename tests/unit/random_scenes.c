/* SPDX-License-Identifier: MIT */
/* Drawing materials, shapes and sources at random. */
#include "random_scenes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

double uniform(struct randomness *random, double low, double high)
{
    random->state ^= random->state >> 12;
    random->state ^= random->state << 25;
    random->state ^= random->state >> 27;
    return low + (high - low) * ((double)((random->state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

int pick(struct randomness *random, int count)
{
    return (int)uniform(random, 0, count);
}

double logarithmic(struct randomness *random, double low, double high)
{
    return exp(uniform(random, log(low), log(high)));
}

static struct lx_material random_material(struct randomness *random)
{
    static const int models[] = {LX_BLINN_PHONG, LX_PHONG, LX_LAMBERT};
    return (struct lx_material){
        .model = models[pick(random, 3)],
        .diffuse = pick(random, 5) ? uniform(random, 0, 1) : 0,
        .specular = uniform(random, 0, 1),
        .shininess = pick(random, 2) ? logarithmic(random, 0.1, 10000) : uniform(random, 1, 60),
        .over_pi = pick(random, 2),
        .highlight = pick(random, 3),
        .normalized = pick(random, 3) == 0,
    };
}

static struct lx_profile random_profile(struct randomness *random, const double from[3], const double at[3])
{
    lx_bounded3 axis = lx_unit3(lx_sub3(lx_exact3(at), lx_exact3(from)));
    double outer = uniform(random, 0.5, 90), inner, exponent;
    enum lx_falloff falloff;
    switch (pick(random, 4)) {
    case 0: return lx_profile_cosine(axis, pick(random, 2) ? 1 : logarithmic(random, 0.1, 100));
    case 1: /* one after the other: compilers differ in the order in which they find arguments */
        exponent = pick(random, 2) ? 0 : uniform(random, 0, 10);
        inner = uniform(random, 0, outer);
        falloff = (enum lx_falloff)pick(random, 4);
        return lx_profile_cone(axis, falloff, inner, outer, exponent);
    default: return lx_profile_isotropic();
    }
}

void random_direction(struct randomness *random, double direction[3])
{
    double length = 0;
    for (int i = 0; i < 3; i++) {
        direction[i] = uniform(random, -1, 1);
        length = hypot(length, direction[i]);
    }
    for (int i = 0; i < 3; i++)
        direction[i] /= length;
}

/* A place from just above a sphere to far away, in any direction, sometimes inside. */
static void place_at_sphere(struct randomness *random, const struct lx_shape *sphere, double place[3])
{
    double direction[3];
    random_direction(random, direction);
    double distance = sphere->radius_mm + logarithmic(random, 0.01, 1e7);
    if (pick(random, 3))
        distance = sphere->radius_mm + logarithmic(random, 50, 10000);
    if (pick(random, 20) == 0)
        distance = uniform(random, 0, sphere->radius_mm);
    for (int i = 0; i < 3; i++)
        place[i] = sphere->anchor_mm[i] + direction[i] * distance;
}

/* A place just above a plate or farther, above its edges or beside it, sometimes behind, in its plane or on it. */
static void place_at_plate(struct randomness *random, const struct lx_shape *plate, double place[3])
{
    double height = pick(random, 3) ? logarithmic(random, 50, 10000) : logarithmic(random, 0.01, 1e7);
    int special = pick(random, 20);
    height = special == 0 ? 0 : special == 1 ? -height : height;
    double beside = pick(random, 3) ? 1 : uniform(random, 1, 4);
    double across = uniform(random, -beside, beside) * plate->half_mm[0];
    double upward = uniform(random, -beside, beside) * plate->half_mm[1];
    for (int i = 0; i < 3; i++)
        place[i] =
            plate->anchor_mm[i] + height * plate->axis[i] + across * plate->across[i] + upward * plate->upward[i];
}

struct lx_emitter random_emitter(struct randomness *random, const struct lx_shape *shape)
{
    struct lx_emitter emitter = {.strength = logarithmic(random, 0.01, 10000)};
    double place[3], aim[3];
    if (shape->type == LX_PLATE)
        place_at_plate(random, shape, place);
    else
        place_at_sphere(random, shape, place);
    for (int i = 0; i < 3; i++)
        aim[i] = shape->anchor_mm[i] + uniform(random, -1, 1) * shape->radius_mm;
    emitter.type = pick(random, 8) == 0 ? LX_UNIFORM : pick(random, 5) == 0 ? LX_DIRECTION : LX_POINT;
    emitter.attenuation = (enum lx_attenuation)pick(random, LX_LAWS);
    emitter.k_mm = logarithmic(random, 10, 2000);
    for (int i = 0; i < 3; i++)
        emitter.coefficients[i] = pick(random, 3) ? logarithmic(random, 1e-3, 10) : i == 0;
    memcpy(emitter.position_mm, place, sizeof place);
    emitter.profile = random_profile(random, place, aim);
    emitter.towards = lx_unit3(lx_sub3(lx_exact3(place), lx_exact3(aim)));
    return emitter;
}

const struct lx_surface_kind *kind_called(const char *name)
{
    for (size_t i = 0; lx_surface_variants[i]; i++)
        if (strcmp(lx_surface_variants[i]->name, name) == 0)
            return (const struct lx_surface_kind *)lx_surface_variants[i];
    fail_msg("no surface is called %s", name);
    return NULL;
}

static const void *random_sphere(struct randomness *random, bool is_alone, struct lx_sphere_parameters *sphere)
{
    sphere->radius_mm = is_alone ? logarithmic(random, 60, 600) : uniform(random, 60, 200);
    double reach = is_alone ? 50 : 300;
    sphere->center_mm[0] = uniform(random, -reach, reach);
    sphere->center_mm[1] = uniform(random, -reach, reach);
    sphere->center_mm[2] = uniform(random, 500, 2000);
    return sphere;
}

/* Its front towards the observer, or, where others are in the picture, any way. */
static const void *random_plate(struct randomness *random, bool is_alone, struct lx_plate_parameters *plate)
{
    double reach = is_alone ? 50 : 300;
    for (int i = 0; i < 2; i++) {
        plate->size_mm[i] = is_alone ? logarithmic(random, 30, 2000) : uniform(random, 100, 600);
        plate->center_mm[i] = uniform(random, -reach, reach);
    }
    plate->center_mm[2] = uniform(random, 500, 2000);
    random_direction(random, plate->axis);
    if (is_alone || pick(random, 4))
        plate->axis[2] = fabs(plate->axis[2]);
    if (pick(random, 4) == 0)
        plate->axis[0] = plate->axis[1] = 0;
    if (pick(random, 2)) {
        plate->given = 1 << 3;
        random_direction(random, plate->up);
    }
    return plate;
}

void make_random_scene(struct randomness *random, bool with_plates, struct test_scene *test)
{
    size_t surfaces = pick(random, 3) ? 1 : MAXIMUM_SURFACES;
    *test = (struct test_scene){
        .scene.screen = {.width_mm = 670, .height_mm = 530, .resolution = {COLUMNS, ROWS}, .sampling = pick(random, 2)},
        .scene.observer = {.z_mm = 5000, .projection = pick(random, 2), .view = pick(random, 2)},
    };
    for (size_t i = 0; i < surfaces; i++) {
        bool is_plate = with_plates && (surfaces == 1 || pick(random, 2));
        const void *parameters = is_plate ? random_plate(random, surfaces == 1, &test->plates[i])
                                          : random_sphere(random, surfaces == 1, &test->spheres[i]);
        struct lx_material material = random_material(random);
        const struct lx_surface_kind *kind = kind_called(is_plate ? "rectangle" : "sphere");
        test->surfaces[i] = (struct lx_prepared_surface){.kind = kind,
                                                         .parameters = parameters,
                                                         .shape = lx_surface_shape(kind, parameters),
                                                         .lobe = lx_lobe_prepare(&material),
                                                         .authored = i};
        test->authored[i] = (struct lx_authored_surface){.first = i, .lobe = test->surfaces[i].lobe};
        kind->extent(parameters, test->surfaces[i].low_mm, test->surfaces[i].high_mm);
    }
    size_t lights = 1 + (size_t)pick(random, MAXIMUM_LIGHTS);
    for (size_t i = 0; i < lights; i++)
        test->lights[i] = random_emitter(random, &test->surfaces[0].shape);
    test->prepared = (struct lx_prepared){
        .scene = &test->scene,
        .camera = lx_camera_of(&test->scene.observer),
        .surfaces = test->surfaces,
        .surface_count = surfaces,
        .authored = test->authored,
        .emitters = {.items = test->lights, .count = lights},
        .shadows = surfaces > 1,
    };
}

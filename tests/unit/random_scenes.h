/* SPDX-License-Identifier: MIT */
/*
 * Random and nasty scenes, prepared: grazing and backward light, sources just above the surface and very far, all laws,
 * profiles, lobes and projections; spheres alone, and plates alone and among spheres.
 */
#ifndef TESTS_UNIT_RANDOM_SCENES_H
#define TESTS_UNIT_RANDOM_SCENES_H

#include <stdbool.h>
#include <stdint.h>

#include "surface/authored.h"
#include "world/prepared.h"

enum { COLUMNS = 67, ROWS = 53, MAXIMUM_LIGHTS = 4, MAXIMUM_SURFACES = 3 };

/* xorshift64*: the same scenes on every machine */
struct randomness {
    uint64_t state;
};

struct test_scene {
    struct lx_scene_parameters scene;
    struct lx_sphere_parameters spheres[MAXIMUM_SURFACES];
    struct lx_plate_parameters plates[MAXIMUM_SURFACES];
    struct lx_item items[MAXIMUM_SURFACES];
    struct lx_prepared_surface surfaces[MAXIMUM_SURFACES];
    struct lx_authored_surface authored[MAXIMUM_SURFACES];
    struct lx_emitter lights[MAXIMUM_LIGHTS];
    struct lx_prepared prepared;
};

double uniform(struct randomness *random, double low, double high);
int pick(struct randomness *random, int count);
double logarithmic(struct randomness *random, double low, double high);
void random_direction(struct randomness *random, double direction[3]);

const struct lx_surface_kind *kind_called(const char *name);

/* A source of any type, law and profile near a surface or far from it. */
struct lx_emitter random_emitter(struct randomness *random, const struct lx_shape *shape);

/* A scene of some surfaces and lights, which points into itself. */
void make_random_scene(struct randomness *random, bool with_plates, struct test_scene *test);

#endif

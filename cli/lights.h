/* SPDX-License-Identifier: MIT */
/* The lights of a scene in JSON: what each is, and its flux and intensity, which are worked out once. */
#ifndef LUXEL_CLI_LIGHTS_H
#define LUXEL_CLI_LIGHTS_H

#include <luxel/luxel.h>

#include "json.h"

struct light_strengths {
    const luxel_scene *scene;
    size_t count;
    struct light_strength {
        double flux, intensity; /* NaN where there is none */
    } * lights;
};

/* Those of all lights of a committed scene; to be cleared. */
struct light_strengths lights_measure(const luxel_scene *scene);
void lights_clear(struct light_strengths *strengths);

/* Writes `lights`, with one object for each light of the scene, as a member of an object. */
void lights_write(struct json *json, const struct light_strengths *strengths);

/* Writes `flux` and `intensity` of light i as members of an object. */
void lights_write_strength(struct json *json, const struct light_strengths *strengths, size_t i);

#endif

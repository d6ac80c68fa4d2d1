/* SPDX-License-Identifier: MIT */
/* Lights in JSON.  JSON is an interface: its words are never translated. */
#include "lights.h"

#include <math.h>
#include <stdlib.h>

#include "message.h"

struct light_strengths lights_measure(const luxel_scene *scene)
{
    struct light_strengths strengths = {scene, luxel_scene_light_count(scene), NULL};

    strengths.lights = message_allocate(strengths.count, sizeof *strengths.lights);
    for (size_t i = 0; i < strengths.count; i++) {
        struct light_strength *light = &strengths.lights[i];

        if (luxel_scene_light_flux(scene, i, &light->flux) != LUXEL_OK)
            light->flux = (double)NAN;
        if (luxel_scene_light_intensity(scene, i, &light->intensity) != LUXEL_OK)
            light->intensity = (double)NAN;
    }
    return strengths;
}

void lights_clear(struct light_strengths *strengths)
{
    free(strengths->lights);
    *strengths = (struct light_strengths){0};
}

void lights_write_strength(struct json *json, const struct light_strengths *strengths, size_t i)
{
    json_number(json, "flux", strengths->lights[i].flux);
    json_number(json, "intensity", strengths->lights[i].intensity);
}

void lights_write(struct json *json, const struct light_strengths *strengths)
{
    json_open(json, "lights", '[');
    for (size_t i = 0; i < strengths->count; i++) {
        json_open(json, NULL, '{');
        json_whole(json, "index", i);
        json_text(json, "type", luxel_scene_light_type(strengths->scene, i));
        if (luxel_scene_light_name(strengths->scene, i))
            json_text(json, "name", luxel_scene_light_name(strengths->scene, i));
        json_bool(json, "enabled", luxel_scene_light_enabled(strengths->scene, i));
        lights_write_strength(json, strengths, i);
        json_close(json, '}');
    }
    json_close(json, ']');
}

/* SPDX-License-Identifier: MIT */
/* Making the kernels' constants of lights, once for all or when they are needed. */
#include "lights.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../format/cloud.h"

/* Whole exponents beyond this would need more products than the logarithm has. */
enum { MOST_WHOLE = 65536 };

struct lx_exponent_double lx_exponent_of(double exponent)
{
    bool is_whole = exponent == floor(exponent) && exponent <= MOST_WHOLE;
    return (struct lx_exponent_double){exponent, is_whole ? (unsigned)exponent : 0};
}

static struct lx_exponent_single single_exponent(struct lx_exponent_double exponent)
{
    return (struct lx_exponent_single){(float)exponent.value, exponent.whole};
}

struct lx_lobe_single lx_lobe_single_of(const struct lx_lobe_double *lobe)
{
    return (struct lx_lobe_single){
        .model = lobe->model,
        .highlight = lobe->highlight,
        .diffuse = (float)lobe->diffuse,
        .specular = (float)lobe->specular,
        .exponent = single_exponent(lobe->exponent),
    };
}

enum lx_light_kind lx_light_kind_of(const struct lx_emitter *emitter)
{
    if (emitter->type != LX_POINT)
        return LX_DISTANT;
    if (emitter->profile.falloff != LX_NO_CONE || emitter->profile.exponent > 0)
        return LX_PROFILED;
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return LX_BY_SQUARE;
    case LX_PRACTICAL: return LX_BY_SUM;
    case LX_NO_ATTENUATION: break;
    }
    return LX_UNATTENUATED;
}

void lx_light_move(const double anchor_mm[3], const double row[4], struct lx_light_double *light)
{
    light->x = row[0] - anchor_mm[0];
    light->y = row[1] - anchor_mm[1];
    light->z = row[2] - anchor_mm[2];
    /* The laws are in metres, the kernel's distances in mm. */
    light->gain = row[3] * (light->law == LX_INVERSE_SQUARE ? 1e6 : light->law == LX_PRACTICAL ? 1e3 : 1);
}

void lx_light_set(const struct lx_emitter *emitter, const double anchor_mm[3], struct lx_light_double *light)
{
    const struct lx_profile *profile = &emitter->profile;
    *light = (struct lx_light_double){
        .kind = lx_light_kind_of(emitter),
        .x = emitter->towards.x.value,
        .y = emitter->towards.y.value,
        .z = emitter->towards.z.value,
        .gain = emitter->strength,
        .law = emitter->attenuation,
        .k = emitter->k_mm,
        .falloff = emitter->type == LX_POINT ? profile->falloff : LX_NO_CONE,
        .axis_x = profile->axis.x.value,
        .axis_y = profile->axis.y.value,
        .axis_z = profile->axis.z.value,
        .exponent = lx_exponent_of(profile->exponent),
    };
    if (light->kind == LX_DISTANT)
        return;
    const double *place = emitter->position_mm;
    lx_light_move(anchor_mm, (const double[]){place[0], place[1], place[2], emitter->strength}, light);
    bool by_angle = profile->falloff == LX_LINEAR;
    light->edge = by_angle ? profile->outer_rad.value : profile->outer_versine.value;
    double inner = by_angle ? profile->inner_rad.value : profile->inner_versine.value;
    light->edge_slope = profile->falloff == LX_HARD || profile->falloff == LX_NO_CONE ? 0 : 1 / (light->edge - inner);
}

struct lx_light_single lx_light_single_of(const struct lx_light_double *light)
{
    return (struct lx_light_single){
        .kind = light->kind,
        .x = (float)light->x,
        .y = (float)light->y,
        .z = (float)light->z,
        .gain = (float)light->gain,
        .law = light->law,
        .k = (float)light->k,
        .falloff = light->falloff,
        .axis_x = (float)light->axis_x,
        .axis_y = (float)light->axis_y,
        .axis_z = (float)light->axis_z,
        .exponent = single_exponent(light->exponent),
        .edge = (float)light->edge,
        .edge_slope = (float)light->edge_slope,
    };
}

int lx_lights_append(struct lx_lights *lights, const struct lx_emitter *emitter)
{
    if (lx_reserve(&lights->singles, &lights->singles_capacity, lights->stored + 1, sizeof *lights->singles) ||
        lx_reserve(&lights->exacts, &lights->exacts_capacity, lights->stored + 1, sizeof *lights->exacts))
        return -1;
    struct lx_light_double *light = &lights->exacts[lights->stored];
    lx_light_set(emitter, lights->anchor_mm, light);
    lights->singles[lights->stored++] = lx_light_single_of(light);
    lights->count++;
    return 0;
}

int lx_lights_append_swarm(struct lx_lights *lights, const struct lx_swarm *swarm)
{
    struct lx_emitter_span span = {.first = 0, .end = swarm->end - swarm->first, .swarm = swarm};
    struct lx_emitter room;
    for (size_t i = 0; span.end <= LX_MOST_STORED && i < span.end; i++)
        if (lx_lights_append(lights, lx_span_at(&span, i, &room)))
            return -1;
    if (span.end <= LX_MOST_STORED)
        return 0;
    if (lx_reserve(&lights->clouds, &lights->cloud_capacity, lights->cloud_count + 1, sizeof *lights->clouds))
        return -1;
    struct lx_cloud_lights *cloud = &lights->clouds[lights->cloud_count++];
    *cloud = (struct lx_cloud_lights){.first = lights->count, .end = lights->count + span.end, .swarm = swarm};
    lx_light_set(&swarm->model, lights->anchor_mm, &cloud->model);
    cloud->model_single = lx_light_single_of(&cloud->model);
    lights->count = cloud->end;
    return 0;
}

void lx_lights_clear(struct lx_lights *lights)
{
    free(lights->singles);
    free(lights->exacts);
    free(lights->clouds);
    *lights = (struct lx_lights){0};
}

/* The cloud that light i is of; NULL: it is stored, as number `*stored`. */
static const struct lx_cloud_lights *cloud_of(const struct lx_lights *lights, size_t i, size_t *stored)
{
    *stored = i;
    for (size_t c = 0; c < lights->cloud_count && i >= lights->clouds[c].first; c++) {
        if (i < lights->clouds[c].end)
            return &lights->clouds[c];
        *stored -= lights->clouds[c].end - lights->clouds[c].first;
    }
    return NULL;
}

/* Sets what a light of a cloud does not share with the others. */
static void set_row(const struct lx_lights *lights, const struct lx_cloud_lights *cloud, size_t i,
                    struct lx_light_double *light)
{
    double row[LX_CLOUD_COLUMNS];
    lx_cloud_row(cloud->swarm->cloud, i - cloud->first, row);
    lx_light_move(lights->anchor_mm, row, light);
    if (!cloud->swarm->is_aimed)
        return;
    lx_bounded3 axis = lx_swarm_axis(cloud->swarm, row);
    light->axis_x = axis.x.value;
    light->axis_y = axis.y.value;
    light->axis_z = axis.z.value;
}

const struct lx_light_double *lx_lights_double(const struct lx_lights *lights, size_t first, size_t count,
                                               struct lx_light_double room[LX_MOST_IN_RUN])
{
    size_t stored, last;
    if (!cloud_of(lights, first, &stored) && !cloud_of(lights, first + count - 1, &last))
        return &lights->exacts[stored];
    for (size_t k = 0; k < count; k++) {
        const struct lx_cloud_lights *cloud = cloud_of(lights, first + k, &stored);
        room[k] = cloud ? cloud->model : lights->exacts[stored];
        if (cloud)
            set_row(lights, cloud, first + k, &room[k]);
    }
    return room;
}

const struct lx_light_single *lx_lights_single(const struct lx_lights *lights, size_t first, size_t count,
                                               struct lx_light_single room[LX_MOST_IN_RUN])
{
    size_t stored, last;
    if (!cloud_of(lights, first, &stored) && !cloud_of(lights, first + count - 1, &last))
        return &lights->singles[stored];
    for (size_t k = 0; k < count; k++) {
        const struct lx_cloud_lights *cloud = cloud_of(lights, first + k, &stored);
        room[k] = cloud ? cloud->model_single : lights->singles[stored];
        if (!cloud)
            continue;
        struct lx_light_double exact = {.law = cloud->model.law};
        set_row(lights, cloud, first + k, &exact);
        room[k].x = (float)exact.x, room[k].y = (float)exact.y, room[k].z = (float)exact.z;
        room[k].gain = (float)exact.gain;
        if (cloud->swarm->is_aimed) {
            room[k].axis_x = (float)exact.axis_x;
            room[k].axis_y = (float)exact.axis_y;
            room[k].axis_z = (float)exact.axis_z;
        }
    }
    return room;
}

/* SPDX-License-Identifier: MIT */
/* Making the kernels' constants of lights, once for all or when they are needed. */
#include "lights.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../format/cloud.h"
#include "../surface/surface.h"

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

enum lx_kernel_light lx_light_kind_of(const struct lx_emitter *emitter)
{
    if (!lx_is_point(emitter))
        return LX_DISTANT;
    if (!lx_profile_is_isotropic(&emitter->profile))
        return LX_PROFILED;
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return LX_BY_SQUARE;
    case LX_PRACTICAL: return LX_BY_SUM;
    case LX_POLYNOMIAL: return LX_PROFILED;
    case LX_NO_ATTENUATION: break;
    }
    return LX_UNATTENUATED;
}

bool lx_has_edges(const struct lx_emitter *emitter, const struct lx_lobe_double *lobe)
{
    bool is_gated = LX_JUMPS_AT_HORIZON(lobe->highlight) && lobe->specular > 0;
    return is_gated || (lx_is_point(emitter) && emitter->profile.falloff != LX_NO_CONE);
}

/* What an intensity is multiplied by: the laws are in metres, the kernel's distances in mm. */
static double unit_of(enum lx_attenuation law)
{
    return law == LX_INVERSE_SQUARE ? 1e6 : law == LX_PRACTICAL ? 1e3 : 1;
}

void lx_light_move(const double anchor_mm[3], const double row[4], struct lx_light_double *light)
{
    light->x = row[0] - anchor_mm[0];
    light->y = row[1] - anchor_mm[1];
    light->z = row[2] - anchor_mm[2];
    light->gain = row[3] * unit_of(light->law);
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
        .by_none = emitter->coefficients[0],
        .by_root = emitter->coefficients[1],
        .by_square = emitter->coefficients[2],
        .falloff = lx_is_point(emitter) ? profile->falloff : LX_NO_CONE,
        .axis_x = profile->axis.x.value,
        .axis_y = profile->axis.y.value,
        .axis_z = profile->axis.z.value,
        .exponent = lx_exponent_of(profile->exponent),
        .luminaire = lx_is_point(emitter) ? profile->luminaire : NULL,
    };
    if (light->kind == LX_DISTANT)
        return;
    const double *place = emitter->position_mm;
    lx_light_move(anchor_mm, (const double[]){place[0], place[1], place[2], emitter->strength}, light);
    bool by_angle = profile->falloff == LX_LINEAR;
    light->edge = by_angle ? profile->outer_rad.value : profile->outer_versine.value;
    double inner = by_angle ? profile->inner_rad.value : profile->inner_versine.value;
    light->edge_slope = profile->falloff == LX_HARD || profile->falloff == LX_NO_CONE ? 0 : 1 / (light->edge - inner);
    light->inner_cosine = 1 - profile->inner_versine.value;
    light->cosine = 1 - profile->outer_versine.value;
    light->sine = sin(profile->outer_rad.value);
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
        .by_none = (float)light->by_none,
        .by_root = (float)light->by_root,
        .by_square = (float)light->by_square,
        .falloff = light->falloff,
        .axis_x = (float)light->axis_x,
        .axis_y = (float)light->axis_y,
        .axis_z = (float)light->axis_z,
        .exponent = single_exponent(light->exponent),
        .edge = (float)light->edge,
        .edge_slope = (float)light->edge_slope,
        .inner_cosine = (float)light->inner_cosine,
        .cosine = (float)light->cosine,
        .sine = (float)light->sine,
        .luminaire = light->luminaire,
    };
}

int lx_lights_make_room(struct lx_lights *lights, size_t count)
{
    lights->singles = lx_new_aligned(count, sizeof *lights->singles);
    lights->exacts = lx_new_aligned(count, sizeof *lights->exacts);
    lights->singles_capacity = lights->exacts_capacity = count;
    return lights->singles && lights->exacts ? 0 : -1;
}

double lx_plane_rounding_mm(const double anchor_mm[3], double distance_mm)
{
    const double of_one = 16 * DBL_EPSILON;
    return of_one * (hypot(hypot(anchor_mm[0], anchor_mm[1]), anchor_mm[2]) + distance_mm);
}

void lx_lights_set_plane(struct lx_lights *lights, const struct lx_shape *shape)
{
    memcpy(lights->anchor_mm, shape->anchor_mm, sizeof lights->anchor_mm);
    if (!lx_shape_is_flat(shape))
        return;
    memcpy(lights->axis, shape->axis, sizeof lights->axis);
    lights->is_flat = true;
}

/* Takes a light in the plane, but for what rounding does, so far behind it that no pixel can think otherwise. */
static void put_behind(const struct lx_lights *lights, struct lx_light_double *light)
{
    static const double FAR_BEHIND = 3, SMALLEST_TURN = 1e-15;
    const double distance = hypot(hypot(light->x, light->y), light->z);
    const double touch = light->kind == LX_DISTANT ? SMALLEST_TURN : lx_plane_rounding_mm(lights->anchor_mm, distance);
    const double height = lights->axis[0] * light->x + lights->axis[1] * light->y + lights->axis[2] * light->z;
    /* along an axis of the screen pixels have no rounding there, nor then has what they make of it */
    const bool is_exact = (fabs(lights->axis[0]) == 1 && light->x == 0) ||
                          (fabs(lights->axis[1]) == 1 && light->y == 0) ||
                          (fabs(lights->axis[2]) == 1 && light->z == 0);
    if (!lights->is_flat || fabs(height) > touch || is_exact)
        return;
    light->x -= FAR_BEHIND * touch * lights->axis[0];
    light->y -= FAR_BEHIND * touch * lights->axis[1];
    light->z -= FAR_BEHIND * touch * lights->axis[2];
}

int lx_lights_append(struct lx_lights *lights, const struct lx_emitter *emitter)
{
    if (lx_reserve(&lights->singles, &lights->singles_capacity, lights->stored + 1, sizeof *lights->singles) ||
        lx_reserve(&lights->exacts, &lights->exacts_capacity, lights->stored + 1, sizeof *lights->exacts))
        return -1;
    struct lx_light_double *light = &lights->exacts[lights->stored];
    lx_light_set(emitter, lights->anchor_mm, light);
    put_behind(lights, light);
    lights->singles[lights->stored++] = lx_light_single_of(light);
    lights->count++;
    return 0;
}

int lx_lights_append_point_set(struct lx_lights *lights, const struct lx_point_set *set)
{
    struct lx_emitter_span span = {.first = 0, .end = set->end - set->first, .set = set};
    struct lx_emitter room;
    for (size_t i = 0; span.end <= LX_MOST_STORED && i < span.end; i++)
        if (lx_lights_append(lights, lx_span_at(&span, i, &room)))
            return -1;
    if (span.end <= LX_MOST_STORED)
        return 0;
    if (lx_reserve(&lights->clouds, &lights->cloud_capacity, lights->cloud_count + 1, sizeof *lights->clouds))
        return -1;
    struct lx_cloud_lights *cloud = &lights->clouds[lights->cloud_count++];
    *cloud = (struct lx_cloud_lights){.first = lights->count, .end = lights->count + span.end, .set = set};
    lx_light_set(&set->model, lights->anchor_mm, &cloud->model);
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

/* A row of a cloud as one number: x, y, z and intensity are made at once, as lights have them in that order. */
typedef double row_of_four __attribute__((vector_size(LX_CLOUD_COLUMNS * sizeof(double))));
typedef float singles_of_four __attribute__((vector_size(LX_CLOUD_COLUMNS * sizeof(float))));
_Static_assert(offsetof(struct lx_light_single, gain) == offsetof(struct lx_light_single, x) + 3 * sizeof(float),
               "x, y, z and gain stand together");

/* Makes lights of one cloud in a room that has what they share. */
static void make_doubles(const struct lx_lights *lights, const struct lx_cloud_lights *cloud, size_t first,
                         size_t count, struct lx_light_double *room)
{
    for (size_t k = 0; k < count; k++) {
        double row[LX_CLOUD_COLUMNS];
        lx_cloud_row(cloud->set->cloud, first + k - cloud->first, row);
        lx_light_move(lights->anchor_mm, row, &room[k]);
        put_behind(lights, &room[k]);
        if (!cloud->set->is_aimed)
            continue;
        const lx_bounded3 axis = lx_point_set_axis(cloud->set, row);
        room[k].axis_x = axis.x.value;
        room[k].axis_y = axis.y.value;
        room[k].axis_z = axis.z.value;
    }
}

static void make_singles(const struct lx_lights *lights, const struct lx_cloud_lights *cloud, size_t first,
                         size_t count, struct lx_light_single *room)
{
    const double *anchor = lights->anchor_mm;
    const row_of_four scale = {1, 1, 1, unit_of(cloud->model.law)};
    const row_of_four origin = {anchor[0], anchor[1], anchor[2], 0};
    for (size_t k = 0; k < count; k++) {
        row_of_four values;
        double row[LX_CLOUD_COLUMNS];
        lx_cloud_row(cloud->set->cloud, first + k - cloud->first, row);
        memcpy(&values, row, sizeof values);
        const singles_of_four made = __builtin_convertvector(values * scale - origin, singles_of_four);
        memcpy(&room[k].x, &made, sizeof made);
        if (!cloud->set->is_aimed)
            continue;
        const lx_bounded3 axis = lx_point_set_axis(cloud->set, row);
        room[k].axis_x = (float)axis.x.value;
        room[k].axis_y = (float)axis.y.value;
        room[k].axis_z = (float)axis.z.value;
    }
}

/* How many of some lights, from the first on, are of one cloud, or of none. */
static size_t count_alike(const struct lx_cloud_lights *cloud, const struct lx_lights *lights, size_t first,
                          size_t count)
{
    size_t end = first + count, stored;
    if (cloud)
        return cloud->end < end ? cloud->end - first : count;
    for (size_t k = 1; k < count; k++)
        if (cloud_of(lights, first + k, &stored))
            return k;
    return count;
}

const struct lx_light_double *lx_lights_double(const struct lx_lights *lights, size_t first, size_t count,
                                               struct lx_light_room *room)
{
    size_t stored, alike;
    for (size_t done = 0; done < count; done += alike) {
        const struct lx_cloud_lights *cloud = cloud_of(lights, first + done, &stored);
        alike = count_alike(cloud, lights, first + done, count - done);
        if (!cloud && alike == count)
            return &lights->exacts[stored];
        bool is_ready = alike == count && room->of_exacts == cloud;
        for (size_t k = done; k < done + alike && !is_ready; k++)
            room->exacts[k] = cloud ? cloud->model : lights->exacts[stored + k - done];
        room->of_exacts = NULL;
        if (cloud)
            make_doubles(lights, cloud, first + done, alike, room->exacts + done);
        if (alike == LX_MOST_IN_RUN || is_ready)
            room->of_exacts = cloud;
    }
    return room->exacts;
}

const struct lx_light_single *lx_lights_single(const struct lx_lights *lights, size_t first, size_t count,
                                               struct lx_light_room *room)
{
    size_t stored, alike;
    for (size_t done = 0; done < count; done += alike) {
        const struct lx_cloud_lights *cloud = cloud_of(lights, first + done, &stored);
        alike = count_alike(cloud, lights, first + done, count - done);
        if (!cloud && alike == count)
            return &lights->singles[stored];
        bool is_ready = alike == count && room->of_singles == cloud;
        for (size_t k = done; k < done + alike && !is_ready; k++)
            room->singles[k] = cloud ? cloud->model_single : lights->singles[stored + k - done];
        room->of_singles = NULL;
        if (cloud)
            make_singles(lights, cloud, first + done, alike, room->singles + done);
        if (alike == LX_MOST_IN_RUN || is_ready)
            room->of_singles = cloud;
    }
    return room->singles;
}

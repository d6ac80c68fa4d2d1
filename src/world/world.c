/* SPDX-License-Identifier: MIT */
/* Lighting batches of elements: by vectors where they tell, else by the reference. */
#include "world.h"

#include <math.h>
#include <string.h>

#include "../light/solid/extended.h"
#include "../surface/beside.h"
#include "among.h"
#include "camera.h"

/* Emitters between two questions whether to go on. */
enum { BETWEEN_CHECKS = 64 };

bool lx_world_is_vectored(const struct lx_prepared *prepared, const struct lx_emitter *emitter)
{
    const bool is_bare = !prepared->is_glazed && prepared->mirrors.count == 0;
    return is_bare && !lx_is_extended(emitter) && !lx_is_dome(emitter) && !emitter->profile.luminaire;
}

unsigned lx_world_batch(const struct lx_world *world)
{
    return world->prepared->emitters.extended > 0 || world->prepared->mirrors.count > 0 ? 1 : LX_BATCH;
}

/* ---- completing elements ---- */

/* The ball around a shape, in the scene's axes. */
static struct lx_ball ball_of(const struct lx_shape *shape)
{
    struct lx_ball ball = {.radius = shape->radius_mm + lx_shape_room(shape)};
    double size = 0;
    for (int k = 0; k < 3; k++) {
        ball.center[k] = shape->anchor_mm[k];
        size += fabs(shape->anchor_mm[k]);
    }
    ball.radius = ball.radius * (1 + LX_BALL_ROOM) + LX_BALL_ROOM * size;
    return ball;
}

/* Whether elements of a batch may lie on a shape. */
static bool may_hold(const struct lx_shape *shape, const struct lx_elements *elements)
{
    const double room = 1 + 1e-8; /* what counts as on the surface, and more */
    const struct lx_ball ball = ball_of(shape), *around = &elements->around;
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += (ball.center[k] - around->center[k]) * (ball.center[k] - around->center[k]);
    return !(sqrt(square) > (ball.radius + around->radius) * room);
}

static void hold(const struct lx_world *world, size_t s, struct lx_elements *elements)
{
    const struct lx_prepared_surface *surface = &world->prepared->surfaces[s];
    const uint32_t number = (uint32_t)s + 1;
    if (lx_hold_shape(world->kernels, &surface->shape, number, elements))
        return;
    for (size_t i = 0; i < LX_BATCH && i < (elements->count + LX_VECTOR - 1) / LX_VECTOR * LX_VECTOR; i++) {
        const lx_bounded3 place = lx_columns_get(&elements->place_mm, i);
        if (elements->own[i] == 0 &&
            surface->kind->holds(&surface->shape, (double[]){place.x.value, place.y.value, place.z.value}))
            elements->own[i] = number;
    }
}

/* What a surface leaves to the elements that lie on it. */
static void settle(const struct lx_world *world, size_t s, struct lx_elements *elements)
{
    const struct lx_shape *shape = &world->prepared->surfaces[s].shape;
    bool any = false;
    for (size_t i = 0; i < elements->count; i++)
        any = any || elements->own[i] == s + 1;
    if (any && !lx_settle_shape(world->kernels, shape, (uint32_t)s + 1, elements))
        for (size_t i = 0; i < elements->count; i++) {
            elements->asks[i] = elements->asks[i] || elements->own[i] == s + 1;
            elements->has_sides = true;
        }
}

static void set_views(const struct lx_world *world, const struct lx_settling *settling, struct lx_elements *elements)
{
    const struct lx_camera *camera = &world->prepared->camera;
    if (settling->has_views) {
        world->kernels->unit(&elements->view, elements->count);
    } else if (camera->is_parallel) {
        const lx_bounded3 *axis = &camera->frame.rounded[2];
        for (size_t i = 0; i < LX_BATCH; i++) {
            elements->view.x.value[i] = axis->x.value, elements->view.x.error[i] = axis->x.error;
            elements->view.y.value[i] = axis->y.value, elements->view.y.error[i] = axis->y.error;
            elements->view.z.value[i] = axis->z.value, elements->view.z.error[i] = axis->z.error;
        }
    } else {
        world->kernels->look_at(camera->position_mm, elements);
    }
}

void lx_world_settle(const struct lx_world *world, const struct lx_settling *settling, struct lx_elements *elements)
{
    const struct lx_prepared *prepared = world->prepared;
    if (!settling->has_normals) {
        world->kernels->unit(&elements->normal, elements->count);
        elements->has_exact_normals = false;
    }
    set_views(world, settling, elements);
    const struct lx_ball here = {.radius = elements->around.radius};
    struct lx_found found;
    const bool is_found = lx_among_balls(prepared, elements->around.center, &here, &here, false, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const size_t s = lx_found_at(&found, is_found, i);
        if (may_hold(&prepared->surfaces[s].shape, elements)) {
            hold(world, s, elements);
            settle(world, s, elements);
        }
    }
}

/* ---- what stands in the way ---- */

/* The ball around where ways lead to, or their direction. */
static struct lx_ball end_of(const struct lx_ways *ways)
{
    struct lx_ball towards = {.radius = 0};
    for (int k = 0; k < 3; k++) {
        towards.center[k] = ways->to[k];
        towards.radius += LX_BALL_ROOM * fabs(ways->to[k]);
    }
    return towards;
}

/* Those of many surfaces that may stand between the elements of a batch and an emitter. */
static bool find_near(const struct lx_prepared *prepared, const struct lx_elements *elements,
                      const struct lx_ways *ways, struct lx_found *found)
{
    static const double origin[3];
    const struct lx_ball towards = end_of(ways);
    return lx_among_balls(prepared, origin, &elements->around, &towards, ways->endless, found);
}

/* Whether a surface may stand between the elements of a batch and an emitter. */
static bool may_close(const struct lx_shape *shape, const struct lx_elements *elements, const struct lx_ways *ways)
{
    const struct lx_ball ball = ball_of(shape);
    const struct lx_ball towards = end_of(ways);
    return lx_may_block(&ball, &elements->around, &towards, ways->endless);
}

static struct lx_ways ways_to(const struct lx_emitter *emitter, double room)
{
    struct lx_ways ways = {.endless = lx_is_endless(emitter), .room = room};
    lx_emitter_origin(emitter, ways.to);
    return ways;
}

static void open_all(struct lx_openness *openness)
{
    for (size_t i = 0; i < LX_BATCH; i++)
        openness->open.value[i] = 1;
    memset(openness->open.error, 0, sizeof openness->open.error);
    memset(openness->in_doubt, 0, sizeof openness->in_doubt);
    openness->any_in_doubt = false;
}

/* Elements on a wall that hides itself, where others of the batch have sides of their own, which tell what the wall
 * takes from these: of the rest the reference knows it. */
static void doubt_own(const struct lx_elements *elements, uint32_t surface, struct lx_openness *openness)
{
    for (size_t i = 0; i < elements->count; i++)
        if (elements->own[i] == surface && elements->side_x[i] == 0 && elements->side_y[i] == 0 &&
            elements->side_z[i] == 0)
            openness->in_doubt[i] = openness->any_in_doubt = true;
}

/* What is in doubt, by the reference, unless something else closes the way. */
static void settle_doubts(const struct lx_world *world, const struct lx_elements *elements,
                          const struct lx_emitter *emitter, struct lx_openness *openness)
{
    for (size_t i = 0; i < elements->count; i++) {
        if (!openness->in_doubt[i] || openness->open.value[i] == 0)
            continue;
        const struct lx_element element = lx_elements_get(world->prepared, elements, i);
        const lx_bounded open = lx_openness_of(world->prepared, &element, emitter);
        openness->open.value[i] = open.value;
        openness->open.error[i] = open.error;
    }
}

/* The ways from elements to an emitter that is a point or a direction, those in doubt left so; NULL: all are open. */
static const struct lx_column *find_open(const struct lx_world *world, const struct lx_elements *elements,
                                         const struct lx_emitter *emitter, double room, struct lx_openness *openness)
{
    const struct lx_prepared *prepared = world->prepared;
    const struct lx_element_kernels *kernels = world->kernels;
    const bool casts = elements->are_free ? prepared->shadows_on_free : prepared->shadows;
    bool is_open = true;
    if (!casts || lx_is_uniform(emitter))
        return NULL;
    const struct lx_ways ways = ways_to(emitter, room);
    struct lx_found found;
    const bool is_found = find_near(prepared, elements, &ways, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const size_t s = lx_found_at(&found, is_found, i);
        const struct lx_shape *shape = &prepared->surfaces[s].shape;
        if (!may_close(shape, elements, &ways))
            continue;
        if (is_open)
            open_all(openness);
        is_open = false;
        const struct lx_shape in_the_way = lx_shape_in_the_way(shape);
        const bool hides_own = lx_may_hide(shape, true) && !elements->has_sides;
        const uint32_t number = (uint32_t)s + 1;
        if (lx_close_shape(kernels, &in_the_way, hides_own ? UINT32_MAX : number, &ways, elements, openness)) {
            if (lx_may_hide(shape, true) && !hides_own)
                doubt_own(elements, number, openness);
            continue;
        }
        memset(openness->in_doubt, 1, sizeof openness->in_doubt);
        openness->any_in_doubt = true;
    }
    if (elements->has_sides) {
        if (is_open)
            open_all(openness);
        is_open = false;
        kernels->close_own(&ways, elements, openness);
    }
    return is_open ? NULL : &openness->open;
}

/* ---- light ---- */

static void add(struct lx_column *sum, size_t i, lx_bounded number)
{
    const lx_bounded made = lx_add((lx_bounded){sum->value[i], sum->error[i]}, number);
    sum->value[i] = made.value;
    sum->error[i] = made.error;
}

/* Adds what an emitter gives to one element. */
static void add_one(const struct lx_world *world, const struct lx_element *element, const struct lx_emitter *emitter,
                    enum lx_wanted wanted, size_t i, struct lx_received *received)
{
    const struct lx_lighting lighting = lx_light_element(world->prepared, element, emitter);
    received->on_element[i] = received->on_element[i] || lighting.on_element;
    received->parts[i] += lighting.parts;
    if (wanted & LX_WANT_IRRADIANCE)
        add(&received->irradiance, i, lighting.irradiance);
    if (wanted & LX_WANT_BRIGHTNESS) {
        add(&received->diffuse, i, lighting.diffuse);
        add(&received->specular, i, lighting.specular);
    }
}

/* Which emitters are summed: those of one light, or all. */
struct range {
    size_t first, end;
};

/* The light of one element as the reference makes it. */
static void sum_one(const struct lx_world *world, const struct lx_elements *elements, size_t i,
                    const struct range *range, enum lx_wanted wanted, const struct lx_asking *asking,
                    struct lx_received *received)
{
    const struct lx_element element = lx_elements_get(world->prepared, elements, i);
    struct lx_column *const columns[] = {&received->irradiance, &received->diffuse, &received->specular};
    for (int k = 0; k < 3; k++)
        columns[k]->value[i] = columns[k]->error[i] = 0;
    received->parts[i] = 0;
    received->on_element[i] = false;
    for (size_t k = range->first; k < range->end && !received->on_element[i]; k++) {
        struct lx_emitter room;
        if (!lx_asking_at_step(asking, k, BETWEEN_CHECKS))
            return;
        add_one(world, &element, lx_emitter_at(&world->prepared->emitters, k, &room), wanted, i, received);
    }
}

static bool is_finite(const struct lx_column *column, size_t i)
{
    return isfinite(column->value[i]) && isfinite(column->error[i]);
}

/* Where a light may lie on an element, or a number has left the range, vectors need not have done what the reference
 * does. */
static bool is_certain(const struct lx_received *received, enum lx_wanted wanted, size_t i)
{
    return !received->on_element[i] && (!(wanted & LX_WANT_IRRADIANCE) || is_finite(&received->irradiance, i)) &&
           (!(wanted & LX_WANT_BRIGHTNESS) || (is_finite(&received->diffuse, i) && is_finite(&received->specular, i)));
}

/* Adds the light of an emitter. */
static void add_emitter(const struct lx_world *world, const struct lx_elements *elements,
                        const struct lx_emitter *emitter, enum lx_wanted wanted, const struct lx_asking *asking,
                        struct lx_received *received)
{
    struct lx_openness openness;
    if (lx_world_is_vectored(world->prepared, emitter)) {
        const struct lx_column *open = find_open(world, elements, emitter, 1, &openness);
        if (open && openness.any_in_doubt)
            settle_doubts(world, elements, emitter, &openness);
        world->kernels->light(emitter, elements, open, wanted, received);
        return;
    }
    struct lx_open_dome open = {.dome = NULL};
    for (size_t i = 0; i < elements->count && lx_asking_goes_on(asking); i++) {
        struct lx_element element = lx_elements_get(world->prepared, elements, i);
        element.open_dome = &open;
        if (!received->on_element[i])
            add_one(world, &element, emitter, wanted, i, received);
    }
}

/* Sums emitters from the first on and before the last: of one light, or all where `light` is NULL. */
static size_t sum_emitters(const struct lx_world *world, const struct lx_elements *elements, size_t first, size_t last,
                           const size_t *light, enum lx_wanted wanted, const struct lx_asking *asking,
                           struct lx_received *received)
{
    const struct lx_emitters *emitters = &world->prepared->emitters;
    struct range range = {first, first};
    if (wanted & LX_WANT_IRRADIANCE)
        lx_column_clear(&received->irradiance, elements->count);
    if (wanted & LX_WANT_BRIGHTNESS) {
        lx_column_clear(&received->diffuse, elements->count);
        lx_column_clear(&received->specular, elements->count);
    }
    memset(received->parts, 0, sizeof received->parts);
    memset(received->on_element, 0, sizeof received->on_element);
    for (; range.end < last; range.end++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(emitters, range.end, &room);
        if ((light && emitter->light != *light) || !lx_asking_at_step(asking, range.end, BETWEEN_CHECKS))
            break;
        add_emitter(world, elements, emitter, wanted, asking, received);
    }
    for (size_t i = 0; i < elements->count; i++)
        if (!is_certain(received, wanted, i))
            sum_one(world, elements, i, &range, wanted, asking, received);
    return range.end;
}

void lx_world_light_of(const struct lx_world *world, const struct lx_elements *elements, size_t light,
                       enum lx_wanted wanted, const struct lx_asking *asking, size_t *next,
                       struct lx_received *received)
{
    *next = sum_emitters(world, elements, *next, world->prepared->emitters.count, &light, wanted, asking, received);
}

void lx_world_light_between(const struct lx_world *world, const struct lx_elements *elements, size_t first, size_t end,
                            enum lx_wanted wanted, const struct lx_asking *asking, struct lx_received *received)
{
    sum_emitters(world, elements, first, end, NULL, wanted, asking, received);
}

void lx_world_gradient(const struct lx_world *world, const struct lx_elements *elements,
                       const struct lx_emitter *emitter, enum lx_wanted wanted, unsigned needs,
                       struct lx_gradient *gradient)
{
    /* edges of shadows that are nearer than some 1e-8 of the lengths that they come from */
    static const double ROOM = 0x1p17;
    struct lx_openness openness;
    const struct lx_column *open = find_open(world, elements, emitter, ROOM, &openness);
    for (size_t i = 0; open && i < elements->count; i++)
        gradient->in_doubt[i] = gradient->in_doubt[i] || (openness.in_doubt[i] && open->value[i] != 0);
    world->kernels->gradient(emitter, elements, open, wanted, needs, gradient);
}

void lx_world_light(const struct lx_world *world, const struct lx_elements *elements, enum lx_wanted wanted,
                    const struct lx_asking *asking, struct lx_received *received)
{
    if (wanted & (LX_WANT_IRRADIANCE | LX_WANT_BRIGHTNESS))
        sum_emitters(world, elements, 0, world->prepared->emitters.count, NULL, wanted, asking, received);
    if ((wanted & LX_WANT_REFLECTED) && world->reflected)
        world->reflect(world, elements, asking, received);
    else if (wanted & LX_WANT_REFLECTED)
        lx_column_clear(&received->reflected, elements->count);
}

/* SPDX-License-Identifier: MIT */
/*
 * Advice about point sources by their distances from the surfaces: so near that they brighten only what is below them,
 * or so far that their law of attenuation makes no difference.
 */
#include <math.h>
#include <stdio.h>

#include "../base/number.h"
#include "../light/array.h"
#include "../world/prepared.h"
#include "adviser.h"

/* A share of a surface's radius: nearer, and half of the light falls on less than a tenth of its width. */
#define NEAREST 0.05
/* The change of the attenuation over all surfaces that can still be seen in a picture of 256 grey levels. */
#define LEAST_CHANGE 0.01

/* Place relative to a shape: how far it is outside of it and in which direction from the nearest point. */
static double outside(const struct lx_shape *shape, const double place[3], double direction[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = place[i] - shape->anchor_mm[i];
    return lx_shape_distance(shape, from, direction);
}

/* The attenuation at the nearest place of all surfaces, as a multiple of that at the farthest. */
static double change_over(const struct lx_prepared *prepared, const double place[3], const struct lx_emitter *emitter,
                          double k_mm)
{
    double near = HUGE_VAL, far = 0;
    for (size_t i = 0; i < prepared->surface_count; i++) {
        const struct lx_shape *shape = &prepared->surfaces[i].shape;
        double length = 0;
        for (int axis = 0; axis < 3; axis++)
            length = hypot(length, place[axis] - shape->anchor_mm[axis]);
        near = fmin(near, fmax(length - shape->radius_mm, 0));
        far = fmax(far, length + shape->radius_mm);
    }
    if (emitter->attenuation == LX_PRACTICAL)
        return (k_mm + far) / (k_mm + near);
    if (emitter->attenuation == LX_POLYNOMIAL)
        return lx_by_polynomial(emitter->coefficients, near / 1000) /
               lx_by_polynomial(emitter->coefficients, far / 1000);
    return near > 0 ? far / near * (far / near) : HUGE_VAL;
}

/* "lights[0].position=[1200, 300, 2000]": along a direction from a point of the shape, in round numbers. */
static void write_position(size_t light, const double from[3], const double direction[3], double length,
                           double place[3], char words[LX_ADVICE_SIZE])
{
    char numbers[3][LX_NUMBER_SIZE];
    double step = pow(10, floor(log10(length)) - 1);
    for (int i = 0; i < 3; i++) {
        place[i] = round((from[i] + direction[i] * length) / step) * step;
        lx_write_digits(place[i] + 0.0, 15, numbers[i]);
    }
    snprintf(words, LX_ADVICE_SIZE, "lights[%zu].position=[%s, %s, %s]", light, numbers[0], numbers[1], numbers[2]);
}

static bool is_near(const struct lx_prepared *prepared, const double place[3], const struct lx_shape **shape,
                    double *distance)
{
    for (size_t i = 0; i < prepared->surface_count; i++) {
        double direction[3];
        *shape = &prepared->surfaces[i].shape;
        *distance = outside(*shape, place, direction);
        if (*distance > 0 && *distance < NEAREST * (*shape)->radius_mm)
            return true;
    }
    return false;
}

static void advise_near(struct lx_adviser *adviser, const struct lx_prepared *prepared,
                        const struct lx_emitter *emitter, const struct lx_shape *shape, double distance)
{
    char number[LX_NUMBER_SIZE], words[LX_ADVICE_SIZE];
    double direction[3], place[3], other;
    const struct lx_shape *again;
    lx_advise(adviser, (struct lx_advised){"lights", true, emitter->light, "position", NULL, NULL}, LX_MSG_LIGHT_NEAR,
              lx_write_digits(distance, 2, number));
    outside(shape, emitter->position_mm, direction);
    for (double times = 1; times <= 4; times *= 2) {
        write_position(emitter->light, emitter->position_mm, direction, times * shape->radius_mm, place, words);
        if (is_near(prepared, place, &again, &other))
            continue;
        lx_suggest(adviser, (const char *const[]){words, NULL});
        return;
    }
}

static void advise_far(struct lx_adviser *adviser, const struct lx_prepared *prepared, const struct lx_emitter *emitter,
                       double change)
{
    char number[LX_NUMBER_SIZE], words[LX_ADVICE_SIZE], law[LX_ADVICE_SIZE];
    const struct lx_shape *shape = &prepared->surfaces[0].shape;
    double direction[3], place[3];
    lx_advise(adviser, (struct lx_advised){"lights", true, emitter->light, "position", NULL, NULL}, LX_MSG_LIGHT_FAR,
              lx_write_digits(100 * (change - 1), 2, number));
    outside(shape, emitter->position_mm, direction);
    snprintf(law, sizeof law, "lights[%zu].k=100", emitter->light);
    for (double times = 20; times >= 4; times /= 2) {
        write_position(emitter->light, shape->anchor_mm, direction, times * shape->radius_mm, place, words);
        if (change_over(prepared, place, emitter, emitter->k_mm) - 1 >= LEAST_CHANGE) {
            lx_suggest(adviser, (const char *const[]){words, NULL});
            return;
        }
    }
    if (emitter->attenuation == LX_PRACTICAL && change_over(prepared, place, emitter, 100) - 1 >= LEAST_CHANGE)
        lx_suggest(adviser, (const char *const[]){words, law, NULL});
}

void lx_advise_distances(struct lx_adviser *adviser)
{
    struct lx_prepared prepared;
    int failed = lx_prepare_few(adviser->parameters, LX_DEFAULT_TOLERANCE, LX_SCOUT_SOURCES, &prepared);
    adviser->out_of_memory = failed && !prepared.emitters.is_short;
    for (size_t i = 0; !failed && i < prepared.emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&prepared.emitters, i, &room);
        const struct lx_shape *shape;
        double distance;
        const struct lx_item *light = &adviser->parameters->lights.items[emitter->light];
        if (!lx_is_point(emitter) || emitter->is_part || emitter->attenuation == LX_NO_ATTENUATION ||
            !lx_find_parameter(light->variant->table, "position") || lx_array_of(light))
            continue;
        double change = change_over(&prepared, emitter->position_mm, emitter, emitter->k_mm);
        if (is_near(&prepared, emitter->position_mm, &shape, &distance))
            advise_near(adviser, &prepared, emitter, shape, distance);
        else if (change - 1 < LEAST_CHANGE)
            advise_far(adviser, &prepared, emitter, change);
    }
    lx_prepared_clear(&prepared);
}

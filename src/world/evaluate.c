/* SPDX-License-Identifier: MIT */
/* Summing the lights' shares at elements. */
#include "evaluate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../scene/colours.h"
#include "../surface/surface.h"
#include "mirrors.h"

lx_bounded lx_received_value(const struct lx_received *received, luxel_quantity quantity, size_t i)
{
    return quantity == LUXEL_IRRADIANCE
               ? lx_column_get(&received->irradiance, i)
               : lx_add(lx_column_get(&received->diffuse, i), lx_column_get(&received->specular, i));
}

lx_bounded lx_reflected_value(const struct lx_lobe *lobe, luxel_quantity quantity, lx_bounded irradiance)
{
    return quantity == LUXEL_IRRADIANCE ? irradiance : lx_mul(lobe->diffuse, irradiance);
}

lx_bounded lx_reported(lx_bounded number)
{
    return (lx_bounded){number.value, number.error >= 0 ? number.error : HUGE_VAL};
}

/* The place of an element, without its value. */
static luxel_value place_of(const struct lx_element *element)
{
    luxel_value place = {.on_surface = true};
    if (element->own) {
        place.surface = element->own->authored;
        place.part = element->own->part;
    }
    lx_values3(element->place_mm, place.position_mm);
    lx_values3(element->normal, place.normal);
    return place;
}

/* Sums the lights of elements; those that a light lies on lose their value. */
static void sum_lights(const struct luxel_evaluator *evaluator, const struct lx_elements *elements,
                       const struct lx_asking *asking, const size_t *of, double *shares, bool has_value[LX_BATCH],
                       struct lx_column *total)
{
    const struct lx_emitters *emitters = &evaluator->world.prepared->emitters;
    const enum lx_wanted wanted = lx_wanted_for(evaluator->settings.quantity);
    const size_t lights = evaluator->world.prepared->scene->lights.count;
    for (size_t next = 0; next < emitters->count && lx_asking_goes_on(asking);) {
        struct lx_emitter room;
        struct lx_received received;
        struct lx_column value;
        const size_t light = lx_emitter_at(emitters, next, &room)->light;
        lx_world_light_of(&evaluator->world, elements, light, wanted, asking, &next, &received);
        evaluator->world.kernels->sum(&received, wanted, elements->count, &value, total);
        for (size_t i = 0; i < elements->count; i++) {
            has_value[i] = has_value[i] && !received.on_element[i];
            if (shares)
                shares[of[i] * lights + light] = value.value[i];
        }
    }
}

/* The lobe of the same material in another channel. */
static const struct lx_lobe *lobe_in(const struct lx_prepared *to, const struct lx_prepared *from,
                                     const struct lx_lobe *lobe)
{
    for (size_t i = 0; i < from->surface_count; i++)
        if (lobe == &from->surfaces[i].lobe)
            return &to->surfaces[i].lobe;
    for (size_t i = 0; i < lx_material_count(from->scene); i++)
        if (lobe == &from->authored[i].lobe)
            return &to->authored[i].lobe;
    return lobe;
}

/* Values that are sums over the channels of materials: adds up those of the parts. */
static void add_up_parts(const struct luxel_evaluator *evaluator, const struct lx_elements *elements,
                         const struct lx_asking *asking, const size_t *of, luxel_value *values, double *shares)
{
    const size_t lights = evaluator->world.prepared->scene->lights.count;
    struct lx_elements own = *elements;
    luxel_value found[LX_BATCH];
    size_t places[LX_BATCH];
    double *of_lights = shares ? lx_new_array(LX_BATCH * lights, sizeof *of_lights) : NULL;
    for (size_t i = 0; i < elements->count; i++) {
        places[i] = i;
        values[of[i]] = (luxel_value){0};
        for (size_t l = 0; shares && l < lights; l++)
            shares[of[i] * lights + l] = 0;
    }
    if (shares && !of_lights)
        return; /* memory ran out: no values, rather than values with wrong shares */
    for (size_t p = 0; p < evaluator->part_count; p++) {
        const struct lx_evaluator_part *part = &evaluator->parts[p];
        own.lobe = lobe_in(&part->evaluator->prepared, &evaluator->prepared, elements->lobe);
        lx_evaluate_elements(part->evaluator, &own, asking, places, found, of_lights);
        for (size_t i = 0; i < elements->count; i++) {
            luxel_value *value = &values[of[i]];
            const lx_bounded sum = lx_add_part((lx_bounded){value->value, value->error}, part->weight, found[i].value,
                                               found[i].error);
            const bool has_value = found[i].has_value && (p == 0 || value->has_value);
            *value = found[i];
            value->has_value = has_value;
            value->value = has_value ? sum.value : 0;
            value->error = has_value ? lx_reported(sum).error : 0;
            for (size_t l = 0; of_lights && l < lights; l++)
                shares[of[i] * lights + l] += part->weight * of_lights[i * lights + l];
        }
    }
    free(of_lights);
}

void lx_evaluate_elements(const struct luxel_evaluator *evaluator, const struct lx_elements *elements,
                          const struct lx_asking *asking, const size_t *of, luxel_value *values, double *shares)
{
    if (evaluator->part_count > 0) {
        add_up_parts(evaluator, elements, asking, of, values, shares);
        return;
    }
    const struct lx_world *world = &evaluator->world;
    const size_t lights = world->prepared->scene->lights.count;
    struct lx_column total;
    struct lx_received received;
    bool has_value[LX_BATCH];
    lx_column_clear(&total, elements->count);
    for (size_t i = 0; i < elements->count; i++) {
        has_value[i] = true;
        if (shares)
            memset(shares + of[i] * lights, 0, lights * sizeof *shares);
    }
    sum_lights(evaluator, elements, asking, of, shares, has_value, &total);
    if (world->reflected)
        lx_world_light(world, elements, LX_WANT_REFLECTED, asking, &received);
    for (size_t i = 0; i < elements->count; i++) {
        const struct lx_element element = lx_elements_get(world->prepared, elements, i);
        luxel_value *value = &values[of[i]];
        lx_bounded sum = lx_column_get(&total, i);
        if (world->reflected)
            sum = lx_add(sum, lx_reflected_value(elements->lobe, evaluator->settings.quantity,
                                                 lx_column_get(&received.reflected, i)));
        *value = place_of(&element);
        value->has_value = has_value[i];
        value->value = has_value[i] ? sum.value : 0;
        value->error = has_value[i] ? lx_reported(sum).error : 0;
        if (!has_value[i] && shares)
            memset(shares + of[i] * lights, 0, lights * sizeof *shares);
    }
}

luxel_value lx_evaluate_element(const struct luxel_evaluator *evaluator, const struct lx_element *element,
                                double *shares)
{
    struct lx_elements elements;
    luxel_value value;
    lx_elements_of_one(evaluator->world.prepared, element, &elements);
    lx_evaluate_elements(evaluator, &elements, NULL, (const size_t[]){0}, &value, shares);
    return value;
}

bool lx_evaluator_sees(const struct luxel_evaluator *evaluator, double x_mm, double y_mm, struct lx_element *element)
{
    return evaluator->sees && lx_element_seen(&evaluator->prepared, x_mm, y_mm, element);
}

void luxel_trace_screen(const luxel_evaluator *evaluator, double x_mm, double y_mm, luxel_value *value)
{
    struct lx_element element;
    *value = lx_evaluator_sees(evaluator, x_mm, y_mm, &element) ? place_of(&element) : (luxel_value){0};
}

/* The answer where there is nothing to be evaluated. */
static void answer_nothing(const luxel_evaluator *evaluator, luxel_value *value, double *shares)
{
    *value = (luxel_value){.on_surface = false};
    if (shares)
        memset(shares, 0, luxel_evaluator_light_count(evaluator) * sizeof *shares);
}

void luxel_evaluate_screen(const luxel_evaluator *evaluator, double x_mm, double y_mm, luxel_value *value,
                           double *shares)
{
    struct lx_element element;
    if (lx_evaluator_sees(evaluator, x_mm, y_mm, &element))
        *value = lx_evaluate_element(evaluator, &element, shares);
    else
        answer_nothing(evaluator, value, shares);
}

static bool is_direction(const double way[3])
{
    return isfinite(way[0]) && isfinite(way[1]) && isfinite(way[2]) && (way[0] != 0 || way[1] != 0 || way[2] != 0);
}

bool lx_is_place(const luxel_place *place)
{
    const double *at = place->position_mm;
    if (place->reserved[0] || place->reserved[1] || place->reserved[2])
        return false;
    if (!place->is_element)
        return isfinite(place->screen_mm[0]) && isfinite(place->screen_mm[1]);
    return isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2]) && is_direction(place->normal) &&
           (!place->has_view || is_direction(place->view));
}

void luxel_evaluate_place(const luxel_evaluator *evaluator, const luxel_place *place, luxel_value *value,
                          double *shares)
{
    const struct lx_prepared *prepared = &evaluator->prepared;
    if (!lx_is_place(place) || (place->is_element && place->surface >= lx_material_count(prepared->scene))) {
        answer_nothing(evaluator, value, shares);
    } else if (place->is_element) {
        const struct lx_element asked = lx_element_at(prepared, place), element = lx_element_shown(prepared, &asked);
        *value = lx_evaluate_element(evaluator, &element, shares);
        if (!element.own)
            value->surface = place->surface;
    } else {
        luxel_evaluate_screen(evaluator, place->screen_mm[0], place->screen_mm[1], value, shares);
    }
}

bool luxel_evaluator_integrates(const luxel_evaluator *evaluator)
{
    return evaluator->prepared.emitters.extended > 0;
}

luxel_quantity luxel_evaluator_quantity(const luxel_evaluator *evaluator)
{
    return evaluator->settings.quantity;
}

size_t luxel_evaluator_light_count(const luxel_evaluator *evaluator)
{
    return evaluator->prepared.scene->lights.count;
}

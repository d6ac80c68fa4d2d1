/* SPDX-License-Identifier: MIT */
/* Summing the lights' shares at an element. */
#include "evaluate.h"

#include <math.h>
#include <string.h>

#include "../surface/surface.h"

bool lx_light_share(const struct lx_prepared *prepared, const struct lx_element *element, size_t light, size_t *next,
                    struct lx_share *share)
{
    *share = (struct lx_share){.irradiance = lx_exact(0), .diffuse = lx_exact(0), .specular = lx_exact(0)};
    for (; *next < prepared->emitters.count; ++*next) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&prepared->emitters, *next, &room);
        if (emitter->light != light)
            break;
        struct lx_lighting lighting = lx_light_element(prepared, element, emitter);
        if (lighting.on_element)
            return false;
        share->parts += lighting.parts;
        share->irradiance = lx_add(share->irradiance, lighting.irradiance);
        share->diffuse = lx_add(share->diffuse, lighting.diffuse);
        share->specular = lx_add(share->specular, lighting.specular);
    }
    return true;
}

lx_bounded lx_share_value(const struct lx_share *share, luxel_quantity quantity)
{
    return quantity == LUXEL_IRRADIANCE ? share->irradiance : lx_add(share->diffuse, share->specular);
}

lx_bounded lx_reflected_value(const struct lx_lobe *lobe, luxel_quantity quantity, lx_bounded irradiance)
{
    return quantity == LUXEL_IRRADIANCE ? irradiance : lx_mul(lobe->diffuse, irradiance);
}

double lx_told_error(lx_bounded number)
{
    return number.error >= 0 ? number.error : HUGE_VAL;
}

static void copy3(double to[3], const lx_bounded3 *from)
{
    to[0] = from->x.value;
    to[1] = from->y.value;
    to[2] = from->z.value;
}

/* The place of an element, without its value. */
static luxel_value place_of(const struct lx_element *element)
{
    luxel_value place = {.on_surface = true};
    if (element->own) {
        place.surface = element->own->authored;
        place.part = element->own->part;
    }
    copy3(place.position_mm, &element->place_mm);
    copy3(place.normal, &element->normal);
    return place;
}

luxel_value lx_evaluate_element(const struct luxel_evaluator *evaluator, const struct lx_element *element,
                                double *shares)
{
    const struct lx_prepared *prepared = &evaluator->prepared;
    luxel_value result = place_of(element);
    lx_bounded total = lx_exact(0);
    size_t lights = prepared->scene->lights.count;
    if (shares)
        memset(shares, 0, lights * sizeof *shares);
    for (size_t next = 0; next < prepared->emitters.count;) {
        struct lx_emitter room;
        size_t light = lx_emitter_at(&prepared->emitters, next, &room)->light;
        struct lx_share share;
        if (!lx_light_share(prepared, element, light, &next, &share)) {
            if (shares)
                memset(shares, 0, lights * sizeof *shares);
            return result;
        }
        lx_bounded value = lx_share_value(&share, evaluator->settings.quantity);
        if (shares)
            shares[light] = value.value;
        total = lx_add(total, value);
    }
    if (evaluator->reflected_at)
        total = lx_add(total, lx_reflected_value(element->lobe, evaluator->settings.quantity,
                                                 evaluator->reflected_at(evaluator, element)));
    result.has_value = true;
    result.value = total.value;
    result.error = lx_told_error(total);
    return result;
}

bool lx_evaluator_sees(const struct luxel_evaluator *evaluator, double x_mm, double y_mm, struct lx_element *element)
{
    return evaluator->sees && lx_element_seen(&evaluator->prepared, x_mm, y_mm, element);
}

luxel_value luxel_trace(const luxel_evaluator *evaluator, double x_mm, double y_mm)
{
    struct lx_element element;
    return lx_evaluator_sees(evaluator, x_mm, y_mm, &element) ? place_of(&element) : (luxel_value){0};
}

luxel_value luxel_evaluate(const luxel_evaluator *evaluator, double x_mm, double y_mm, double *shares)
{
    struct lx_element element;
    if (lx_evaluator_sees(evaluator, x_mm, y_mm, &element))
        return lx_evaluate_element(evaluator, &element, shares);
    if (shares)
        memset(shares, 0, luxel_evaluator_light_count(evaluator) * sizeof *shares);
    return (luxel_value){.on_surface = false};
}

static bool is_direction(const double way[3])
{
    return isfinite(way[0]) && isfinite(way[1]) && isfinite(way[2]) && (way[0] != 0 || way[1] != 0 || way[2] != 0);
}

bool lx_is_place(const luxel_place *place)
{
    const double *at = place->position_mm;
    if (!place->is_element)
        return isfinite(place->screen_mm[0]) && isfinite(place->screen_mm[1]);
    return isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2]) && is_direction(place->normal) &&
           (!place->has_view || is_direction(place->view));
}

struct lx_element lx_free_element_at(const struct lx_prepared *prepared, const luxel_place *place)
{
    struct lx_free_element asked = {.surface = place->surface};
    memcpy(asked.place_mm, place->position_mm, sizeof asked.place_mm);
    memcpy(asked.normal, place->normal, sizeof asked.normal);
    asked.view = place->has_view ? place->view : NULL;
    return lx_element_at(prepared, &asked);
}

luxel_value luxel_evaluate_place(const luxel_evaluator *evaluator, const luxel_place *place, double *shares)
{
    const struct lx_prepared *prepared = &evaluator->prepared;
    if (place->is_element && lx_is_place(place) && place->surface < lx_material_count(prepared->scene)) {
        const struct lx_element element = lx_free_element_at(prepared, place);
        luxel_value value = lx_evaluate_element(evaluator, &element, shares);
        if (!element.own)
            value.surface = place->surface;
        return value;
    }
    if (!place->is_element && lx_is_place(place))
        return luxel_evaluate(evaluator, place->screen_mm[0], place->screen_mm[1], shares);
    if (shares)
        memset(shares, 0, luxel_evaluator_light_count(evaluator) * sizeof *shares);
    return (luxel_value){.on_surface = false};
}

luxel_value luxel_evaluate_sphere(const luxel_evaluator *evaluator, size_t surface, const double normal[3],
                                  double *shares)
{
    const struct lx_prepared *prepared = &evaluator->prepared;
    if (surface < prepared->scene->surfaces.count &&
        lx_is_by_normal(prepared, lx_prepared_index(prepared, surface, 0))) {
        const struct lx_element element = lx_element_on(prepared, lx_prepared_index(prepared, surface, 0), normal);
        return lx_evaluate_element(evaluator, &element, shares);
    }
    if (shares)
        memset(shares, 0, luxel_evaluator_light_count(evaluator) * sizeof *shares);
    return (luxel_value){.on_surface = false};
}

bool luxel_evaluator_integrates(const luxel_evaluator *evaluator)
{
    const struct lx_emitters *emitters = &evaluator->prepared.emitters;
    for (size_t i = 0; i < lx_item_count(emitters); i++)
        if (lx_is_extended(&emitters->items[i]))
            return true;
    return false;
}

luxel_quantity luxel_evaluator_quantity(const luxel_evaluator *evaluator)
{
    return evaluator->settings.quantity;
}

size_t luxel_evaluator_light_count(const luxel_evaluator *evaluator)
{
    return evaluator->prepared.scene->lights.count;
}

/* SPDX-License-Identifier: MIT */
/* Spots: places on surfaces, how they are moved, lit and seen. */
#include <math.h>

#include "../world/camera.h"
#include "extrema.h"

const struct lx_shape *lx_spot_shape(const struct lx_extremum_search *search, const struct lx_spot *spot)
{
    return &search->prepared->surfaces[spot->surface].shape;
}

static const struct lx_surface_chart *chart_of(const struct lx_extremum_search *search, const struct lx_spot *spot)
{
    return lx_spot_shape(search, spot)->kind->chart;
}

struct lx_chart lx_spot_chart(const struct lx_extremum_search *search, const struct lx_spot *spot)
{
    struct lx_chart chart;
    chart_of(search, spot)->directions(lx_spot_shape(search, spot), spot->at, chart.first, chart.second);
    return chart;
}

struct lx_spot lx_spot_moved(const struct lx_extremum_search *search, const struct lx_spot *spot,
                             const struct lx_chart *chart, const double step_mm[2])
{
    struct lx_spot moved = {.surface = spot->surface};
    chart_of(search, spot)->move(lx_spot_shape(search, spot), spot->at, chart->first, chart->second, step_mm, moved.at);
    return moved;
}

struct lx_spot lx_spot_of(const struct lx_extremum_search *search, size_t surface, const double place_mm[3],
                          const double normal[3])
{
    struct lx_spot spot = {.surface = surface};
    const struct lx_shape *shape = lx_spot_shape(search, &spot);
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - shape->anchor_mm[i];
    chart_of(search, &spot)->locate(shape, from, normal, spot.at);
    return spot;
}

void lx_spot_place(const struct lx_extremum_search *search, const struct lx_spot *spot, double place_mm[3],
                   double normal[3])
{
    chart_of(search, spot)->place(lx_spot_shape(search, spot), spot->at, place_mm, normal);
}

struct lx_element lx_spot_element(const struct lx_extremum_search *search, const struct lx_spot *spot)
{
    return lx_element_on(search->prepared, spot->surface, spot->at);
}

bool lx_screen_of(const struct lx_extremum_search *search, const double place_mm[3], double screen_mm[2])
{
    const struct lx_camera *camera = &search->prepared->camera;
    const double height = lx_seen_at(camera, place_mm, screen_mm);
    if (!camera->is_perspective || height < camera->z_mm)
        return true;
    screen_mm[0] = screen_mm[1] = HUGE_VAL;
    return false;
}

struct lx_origin lx_eye_of(const struct lx_extremum_search *search)
{
    return lx_eye(&search->prepared->camera);
}

struct lx_origin lx_viewer_of(const struct lx_extremum_search *search)
{
    return lx_viewer(&search->prepared->camera);
}

static struct lx_spot spot_of_element(const struct lx_extremum_search *search, const struct lx_element *element)
{
    double place[3] = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value};
    double normal[3] = {element->normal.x.value, element->normal.y.value, element->normal.z.value};
    return lx_spot_of(search, (size_t)(element->own - search->prepared->surfaces), place, normal);
}

bool lx_spot_shown(const struct lx_extremum_search *search, const double screen_mm[2], struct lx_spot *spot)
{
    struct lx_element element;
    if (!lx_element_seen(search->prepared, screen_mm[0], screen_mm[1], &element))
        return false;
    *spot = spot_of_element(search, &element);
    return true;
}

bool lx_spot_seen(struct lx_extremum_search *search, const double screen_mm[2], struct lx_spot *spot, double *value)
{
    struct lx_element element;
    if (!lx_search_goes_on(search) || !lx_element_seen(search->prepared, screen_mm[0], screen_mm[1], &element))
        return false;
    *spot = spot_of_element(search, &element);
    bool is_irradiance = search->evaluator->settings.quantity == LUXEL_IRRADIANCE;
    if (is_irradiance) /* spares the integrals of the highlight */
        element.lobe = &search->gates[spot->surface].shut;
    *value = 0;
    for (size_t i = 0; i < search->quick.emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&search->quick.emitters, i, &room);
        struct lx_lighting lighting = lx_light_element(&search->quick, &element, emitter);
        if (lighting.on_element)
            return false;
        *value += is_irradiance ? lighting.irradiance.value : lighting.diffuse.value + lighting.specular.value;
    }
    *value *= search->sign;
    return isfinite(*value);
}

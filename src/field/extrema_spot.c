/* SPDX-License-Identifier: MIT */
/* Spots: places on spheres and plates, how they are moved, lit and seen. */
#include <string.h>

#include "../shade/camera.h"
#include "extrema.h"

static const struct lx_observer *observer_of(const struct lx_hunt *hunt)
{
    return &hunt->prepared->scene->observer;
}

const struct lx_shape *lx_spot_shape(const struct lx_hunt *hunt, const struct lx_spot *spot)
{
    return &hunt->prepared->surfaces[spot->surface].shape;
}

struct lx_chart lx_spot_chart(const struct lx_hunt *hunt, const struct lx_spot *spot)
{
    struct lx_chart chart = {.first = {1, 0, 0}, .second = {0, 1, 0}};
    if (lx_spot_shape(hunt, spot)->type != LX_SPHERE)
        return chart;
    /* across the axis that is farthest from the normal */
    const double *n = spot->at;
    int least = fabs(n[0]) <= fabs(n[1]) ? 0 : 1;
    least = fabs(n[2]) < fabs(n[least]) ? 2 : least;
    for (int i = 0; i < 3; i++)
        chart.first[i] = (i == least) - n[least] * n[i];
    lx_normalize(chart.first);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        chart.second[i] = n[j] * chart.first[k] - n[k] * chart.first[j];
    }
    return chart;
}

struct lx_spot lx_spot_moved(const struct lx_hunt *hunt, const struct lx_spot *spot, const struct lx_chart *chart,
                             const double step_mm[2])
{
    const struct lx_shape *shape = lx_spot_shape(hunt, spot);
    struct lx_spot moved = *spot;
    double unit_mm = shape->type == LX_SPHERE ? shape->radius_mm : 1;
    for (int i = 0; i < 3; i++)
        moved.at[i] += (step_mm[0] * chart->first[i] + step_mm[1] * chart->second[i]) / unit_mm;
    if (shape->type == LX_SPHERE)
        lx_normalize(moved.at);
    return moved;
}

struct lx_spot lx_spot_of(const struct lx_hunt *hunt, size_t surface, const double place_mm[3], const double normal[3])
{
    struct lx_spot spot = {.surface = surface};
    const struct lx_shape *shape = lx_spot_shape(hunt, &spot);
    if (shape->type == LX_SPHERE) {
        memcpy(spot.at, normal, sizeof spot.at);
        lx_normalize(spot.at);
        return spot;
    }
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - shape->anchor_mm[i];
    spot.at[0] = lx_dot(from, shape->across);
    spot.at[1] = lx_dot(from, shape->upward);
    return spot;
}

void lx_spot_place(const struct lx_hunt *hunt, const struct lx_spot *spot, double place_mm[3], double normal[3])
{
    const struct lx_shape *shape = lx_spot_shape(hunt, spot);
    bool round = shape->type == LX_SPHERE;
    for (int i = 0; i < 3; i++) {
        double offset =
            round ? shape->radius_mm * spot->at[i] : spot->at[0] * shape->across[i] + spot->at[1] * shape->upward[i];
        place_mm[i] = shape->anchor_mm[i] + offset;
        normal[i] = round ? spot->at[i] : shape->axis[i];
    }
}

static lx_bounded along_plate(const struct lx_shape *plate, const struct lx_spot *spot, int i)
{
    lx_bounded across = {plate->across[i], plate->across_error[i]}, upward = {plate->upward[i], plate->upward_error[i]};
    lx_bounded offset = lx_add(lx_mul(across, lx_exact(spot->at[0])), lx_mul(upward, lx_exact(spot->at[1])));
    return lx_add(lx_exact(plate->anchor_mm[i]), offset);
}

struct lx_element lx_spot_element(const struct lx_hunt *hunt, const struct lx_spot *spot)
{
    const struct lx_prepared_surface *own = &hunt->prepared->surfaces[spot->surface];
    const struct lx_shape *shape = &own->shape;
    const struct lx_observer *observer = observer_of(hunt);
    struct lx_element element;
    if (lx_element_on_sphere(hunt->prepared, spot->surface, spot->at, &element))
        return element;
    lx_bounded3 place = {along_plate(shape, spot, 0), along_plate(shape, spot, 1), along_plate(shape, spot, 2)};
    lx_bounded3 up = lx_exact3((const double[]){0, 0, 1});
    lx_bounded3 eye = lx_exact3((const double[]){0, 0, observer->z_mm});
    return (struct lx_element){
        .place_mm = place,
        .normal = {{shape->axis[0], shape->axis_error[0]},
                   {shape->axis[1], shape->axis_error[1]},
                   {shape->axis[2], shape->axis_error[2]}},
        .view = lx_views_along_z(observer) ? up : lx_unit3(lx_sub3(eye, place)),
        .lobe = &own->lobe,
        .own = own,
    };
}

void lx_screen_of(const struct lx_hunt *hunt, const double place_mm[3], double screen_mm[2])
{
    const struct lx_observer *observer = observer_of(hunt);
    double factor = observer->projection == LX_PERSPECTIVE ? observer->z_mm / (observer->z_mm - place_mm[2]) : 1;
    screen_mm[0] = place_mm[0] * factor;
    screen_mm[1] = place_mm[1] * factor;
}

bool lx_way_to_observer(const struct lx_hunt *hunt, const double place_mm[3], double way[3])
{
    const struct lx_observer *observer = observer_of(hunt);
    bool endless = observer->projection == LX_ORTHOGRAPHIC;
    way[0] = endless ? 0 : -place_mm[0];
    way[1] = endless ? 0 : -place_mm[1];
    way[2] = endless ? 1 : observer->z_mm - place_mm[2];
    return endless;
}

double lx_sphere_front(const struct lx_hunt *hunt, size_t surface, double front[3])
{
    const struct lx_shape *shape = &hunt->prepared->surfaces[surface].shape;
    bool endless = lx_way_to_observer(hunt, shape->anchor_mm, front);
    double distance_mm = lx_normalize(front);
    return endless ? 0 : shape->radius_mm / distance_mm;
}

static struct lx_spot spot_of_element(const struct lx_hunt *hunt, const struct lx_element *element)
{
    double place[3] = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value};
    double normal[3] = {element->normal.x.value, element->normal.y.value, element->normal.z.value};
    return lx_spot_of(hunt, (size_t)(element->own - hunt->prepared->surfaces), place, normal);
}

bool lx_spot_shown(const struct lx_hunt *hunt, const double screen_mm[2], struct lx_spot *spot)
{
    struct lx_element element;
    if (!lx_element_seen(hunt->prepared, screen_mm[0], screen_mm[1], &element))
        return false;
    *spot = spot_of_element(hunt, &element);
    return true;
}

bool lx_spot_seen(struct lx_hunt *hunt, const double screen_mm[2], struct lx_spot *spot, double *value)
{
    struct lx_element element;
    if (!lx_hunt_goes_on(hunt) || !lx_element_seen(hunt->prepared, screen_mm[0], screen_mm[1], &element))
        return false;
    *spot = spot_of_element(hunt, &element);
    bool is_irradiance = hunt->evaluator->settings.quantity == LUXEL_IRRADIANCE;
    if (is_irradiance) /* spares the integrals of the highlight */
        element.lobe = &hunt->gates[spot->surface].shut;
    *value = 0;
    for (size_t i = 0; i < hunt->quick.emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&hunt->quick.emitters, i, &room);
        struct lx_lighting lighting = lx_light_element(&hunt->quick, &element, emitter);
        if (lighting.on_element)
            return false;
        *value += is_irradiance ? lighting.irradiance.value : lighting.diffuse.value + lighting.specular.value;
    }
    *value *= hunt->sign;
    return isfinite(*value);
}

/* SPDX-License-Identifier: MIT */
/* Seeing and lighting one surface element in float64 with error bounds. */
#include "reference.h"

#include <stdint.h>
#include <string.h>

#include "../base/vector.h"
#include "../light/sky/dome.h"
#include "../light/solid/extended.h"
#include "../surface/beside.h"
#include "among.h"
#include "camera.h"
#include "domes.h"
#include "images.h"
#include "integral/cubature.h"
#include "integral/opening_light.h"
#include "mirrors.h"
#include "visibility/boundary.h"

bool lx_element_seen(const struct lx_prepared *prepared, double x_mm, double y_mm, struct lx_element *element)
{
    const struct lx_camera *camera = &prepared->camera;
    const lx_bounded3 eye = camera->is_parallel ? camera->frame.rounded[2] : lx_exact3(camera->position_mm);
    return lx_sight_meets(prepared, lx_line_of_sight(camera, x_mm, y_mm), eye, camera->is_parallel, 0, element);
}

struct lx_element lx_element_at(const struct lx_prepared *prepared, const luxel_place *place)
{
    struct lx_element element = {
        .place_mm = lx_exact3(place->position_mm),
        .normal = lx_unit3(lx_exact3(place->normal)),
        .lobe = &prepared->authored[place->surface].lobe,
        .is_free = true,
    };
    element.view =
        place->has_view ? lx_unit3(lx_exact3(place->view)) : lx_view_from(&prepared->camera, element.place_mm);
    struct lx_found found;
    const bool is_found = lx_among_place(prepared, place->position_mm, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count && !element.own; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[lx_found_at(&found, is_found, i)];
        if (surface->kind->holds(&surface->shape, place->position_mm))
            element.own = surface;
    }
    if (element.own)
        element.lobe = &element.own->lobe;
    return element;
}

bool lx_is_by_normal(const struct lx_prepared *prepared, size_t surface)
{
    const struct lx_surface_chart *chart = prepared->surfaces[surface].kind->chart;
    return chart && chart->by_normal;
}

struct lx_element lx_element_on(const struct lx_prepared *prepared, size_t surface, const double at[3])
{
    const struct lx_prepared_surface *own = &prepared->surfaces[surface];
    struct lx_element element = {.lobe = &own->lobe, .own = own};
    own->kind->chart->element(&own->shape, at, &element.place_mm, &element.normal);
    element.view = lx_view_from(&prepared->camera, element.place_mm);
    return element;
}

lx_bounded lx_blocked_by(const struct lx_shape *shape, bool is_own, const struct lx_element *element, lx_bounded3 way,
                         bool endless)
{
    const bool is_turned = is_own && element->is_free && lx_shape_is_turned(shape, element->place_mm, element->normal);
    lx_bounded open = lx_exact(1);
    if (is_turned ? lx_asks_both(shape->kind) : lx_may_hide(shape, is_own))
        open = lx_not(shape->kind->blocks(shape, element->place_mm, way, endless));
    if (is_turned || (is_own && shape->kind->normal_seen))
        open = lx_both(open, lx_not(lx_shape_hides(shape, element->place_mm, element->normal, way, endless)));
    return lx_not(open);
}

/* The way from the element to an emitter without size; sets whether it has no end. */
static lx_bounded3 way_to(const struct lx_element *element, const struct lx_emitter *emitter, bool *endless)
{
    *endless = lx_is_endless(emitter);
    return *endless ? emitter->towards : lx_sub3(lx_exact3(emitter->position_mm), element->place_mm);
}

lx_bounded lx_hidden_by(const struct lx_prepared_surface *surface, const struct lx_element *element,
                        const struct lx_emitter *emitter)
{
    bool endless;
    const lx_bounded3 way = way_to(element, emitter, &endless);
    return lx_blocked_by(&surface->shape, surface == element->own, element, way, endless);
}

lx_bounded lx_openness_of(const struct lx_prepared *prepared, const struct lx_element *element,
                          const struct lx_emitter *emitter)
{
    lx_bounded open = lx_exact(1);
    const bool casts = element->is_free ? prepared->shadows_on_free : prepared->shadows;
    if (!casts)
        return open;
    bool endless;
    const lx_bounded3 way = way_to(element, emitter, &endless);
    struct lx_found found;
    const bool is_found = lx_among_way(prepared, &element->place_mm, &way, endless, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[lx_found_at(&found, is_found, i)];
        open = lx_both(open, lx_not(lx_blocked_by(&surface->shape, surface == element->own, element, way, endless)));
    }
    if (!prepared->is_glazed || open.value == 0)
        return open;
    double place[3], towards[3];
    lx_values3(element->place_mm, place);
    lx_values3(way, towards);
    const double passed = lx_panes_pass(prepared->panes, prepared->pane_count, NULL, place, towards, endless);
    return lx_mul(open, (lx_bounded){passed, LX_PANE_ROUNDING});
}

/* The diffuse part where it is not Lambert's: the highlight of a lobe of its own. */
static void light_rough(const struct lx_prepared *prepared, const struct lx_element *element,
                        const struct lx_emitter *emitter, struct lx_occlusion *occlusion, struct lx_lighting *lighting)
{
    const struct lx_lobe lobe = lx_lobe_of_diffuse(element->lobe);
    struct lx_element rough = *element;
    rough.lobe = &lobe;
    const struct lx_cubature integral = lx_integrate(emitter, &rough, occlusion, false, 0, prepared->tolerance, NULL);
    lighting->diffuse = integral.specular;
    lighting->parts += integral.parts;
}

/* From this tolerance on what is in umbrae need not be told from nothing. */
static const double SAMPLE = 1e-6;

/* The light that obstacles (NULL: none) leave of a source, by its borders, where these are known to the tolerance. */
bool lx_light_by_borders(const struct lx_prepared *prepared, const struct lx_element *element,
                         const struct lx_emitter *emitter, const struct lx_occlusion *occlusion, double before,
                         struct lx_lighting *lighting)
{
    struct lx_occlusion nothing = {.place_mm = {0}};
    const struct lx_occlusion *hiding = occlusion ? occlusion : &nothing;
    double normal[3];
    lx_bounded seen;
    lx_values3(element->normal, normal);
    lx_values3(element->place_mm, nothing.place_mm);
    if (emitter->potential ? !lx_boundary_sky(emitter, normal, hiding, prepared->tolerance,
                                              before / emitter->radiance.value, &seen, &lighting->parts)
                           : !lx_has_closed_form(emitter) || !lx_boundary_irradiance(emitter, normal, hiding, &seen))
        return false;
    const double greatest = emitter->sky ? lx_sky_greatest(emitter->sky) : 1;
    seen.error += 2 * M_PI * greatest * lx_error3(element->normal);
    seen.value = fmax(seen.value, 0);
    lighting->irradiance = lx_mul(emitter->radiance, seen);
    lighting->parts++;
    if (emitter->potential || lighting->irradiance.error <= prepared->tolerance * (before + lighting->irradiance.value))
        return true;
    return prepared->tolerance >= SAMPLE &&
           lighting->irradiance.error <=
               prepared->tolerance * lx_extended_irradiance(emitter, element->place_mm, element->normal).value;
}

/* The light of a flat opening of which the element sees all, line by line; false: it is not known to the tolerance. */
static bool light_by_lines(const struct lx_prepared *prepared, const struct lx_element *element,
                           const struct lx_emitter *emitter, double before, struct lx_lighting *lighting)
{
    static const double SHARE = 0.5; /* of the tolerance across lines; the rest is for what is left along them */
    const double radiance = emitter->radiance.value;
    lx_bounded seen;
    size_t parts = 0;
    double place[3];
    lx_values3(element->place_mm, place);
    if (!lx_is_opening(emitter) || !lx_opening_is_flat(emitter) || prepared->tolerance < SAMPLE)
        return false;
    if (lx_opening_is_level(emitter, element, &seen)) {
        lighting->irradiance = lx_mul(emitter->radiance, seen);
        return true;
    }
    if (emitter->pane_count > 0 || !lx_opening_is_away(emitter, place))
        return false;
    const double tolerance = SHARE * prepared->tolerance;
    seen = lx_opening_light(emitter, element, tolerance, radiance > 0 ? before / radiance : 0, NULL, &parts);
    lighting->irradiance = lx_mul(emitter->radiance, seen);
    lighting->parts += parts;
    return lighting->irradiance.error <= prepared->tolerance * (before + lighting->irradiance.value);
}

/* In closed form where there is one, else to the tolerance; behind obstacles to the tolerance.  `before`: irradiance of
 * other parts of the same source, relative to which the tolerance is, too. */
struct lx_lighting lx_light_around(const struct lx_prepared *prepared, const struct lx_element *element,
                                   const struct lx_emitter *emitter, struct lx_occlusion *occlusion, double before)
{
    const struct lx_lobe *lobe = element->lobe;
    struct lx_lighting lighting = {.irradiance = lx_exact(0), .specular = lx_exact(0)};
    bool closed = lx_has_closed_form(emitter) && !lx_is_occluded(occlusion);
    if (closed)
        lighting.irradiance = lx_extended_irradiance(emitter, element->place_mm, element->normal);
    else
        closed = lx_is_occluded(occlusion) || !lx_is_opening(emitter)
                     ? lx_light_by_borders(prepared, element, emitter, occlusion, before, &lighting)
                     : light_by_lines(prepared, element, emitter, before, &lighting);
    if (!closed || lx_lobe_shines(lobe)) {
        double known = lobe->diffuse.value * (before + lighting.irradiance.value);
        struct lx_cubature integral =
            lx_integrate(emitter, element, occlusion, !closed, known, prepared->tolerance, NULL);
        if (!closed)
            lighting.irradiance = integral.irradiance;
        lighting.specular = integral.specular;
        lighting.parts += integral.parts;
    }
    if (lx_lobe_is_rough(lobe))
        light_rough(prepared, element, emitter, occlusion, &lighting);
    else
        lighting.diffuse = lx_mul(lobe->diffuse, lighting.irradiance);
    return lighting;
}

/* A bound that knows how much there can be: from nothing to what arrives where nothing stands in the way. */
static lx_bounded within(lx_bounded found, lx_bounded most)
{
    const double low = fmax(found.value - found.error, 0);
    const double high = fmin(found.value + found.error, (most.value + most.error) * (1 + 2 * DBL_EPSILON));
    const double value = fmax(0, fmin(found.value, high));
    const double error = fmax(high - value, value - low) * (1 + 2 * DBL_EPSILON);
    return error < found.error ? (lx_bounded){value, error} : found;
}

/* Behind obstacles; where that is not known to the tolerance, between what there can be. */
struct lx_lighting lx_light_behind(const struct lx_prepared *prepared, const struct lx_element *element,
                                   const struct lx_emitter *emitter, struct lx_occlusion *occlusion, double before)
{
    struct lx_lighting seen = lx_light_around(prepared, element, emitter, occlusion, before);
    const double wanted = prepared->tolerance;
    const bool is_rough = lx_lobe_is_rough(element->lobe);
    if (!lx_is_occluded(occlusion) || (seen.irradiance.error <= wanted * (before + seen.irradiance.value) &&
                                       (!is_rough || seen.diffuse.error <= wanted * seen.diffuse.value) &&
                                       seen.specular.error <= wanted * seen.specular.value))
        return seen;
    const struct lx_lighting all = lx_light_around(prepared, element, emitter, NULL, before);
    seen.irradiance = within(seen.irradiance, all.irradiance);
    seen.diffuse = is_rough ? within(seen.diffuse, all.diffuse) : lx_mul(element->lobe->diffuse, seen.irradiance);
    seen.specular = within(seen.specular, all.specular);
    return seen;
}

/* `is_open`: not NULL where somebody knows what the source gives if nothing stands before it; that is then told, and
 * nothing else. */
struct lx_lighting lx_light_by_extended(const struct lx_prepared *prepared, const struct lx_element *element,
                                        const struct lx_emitter *emitter, double before, bool *is_open)
{
    if (lx_extended_touches(emitter, element->place_mm))
        return (struct lx_lighting){.on_element = true};
    if (!prepared->shadows_extended) {
        if (is_open)
            *is_open = true;
        return is_open ? (struct lx_lighting){.irradiance = lx_exact(0)}
                       : lx_light_around(prepared, element, emitter, NULL, before);
    }
    const bool above = !lx_lobe_reaches_below(element->lobe);
    struct lx_occlusion occlusion = {.place_mm = {0}};
    struct lx_lighting lighting = {.irradiance = {0, HUGE_VAL}, .diffuse = {0, HUGE_VAL}, .specular = {0, HUGE_VAL}};
    const bool failed = lx_occlusion_make(prepared, element, emitter, above, &occlusion) != 0;
    if (!failed && is_open && !occlusion.is_dark && !lx_is_occluded(&occlusion))
        *is_open = true;
    else if (!failed)
        lighting = occlusion.is_dark ? (struct lx_lighting){.irradiance = lx_exact(0)}
                                     : lx_light_behind(prepared, element, emitter, &occlusion, before);
    lx_occlusion_clear(&occlusion);
    return lighting;
}

/* The panes that its light may come through, where what stands in the way counts; of a room that is left out, none. */
void lx_set_panes(const struct lx_prepared *prepared, struct lx_emitter *emitter)
{
    bool counts = false;
    for (size_t i = 0; i < prepared->pane_count && !counts && prepared->is_glazed; i++)
        counts = prepared->panes[i].surface + 1 != prepared->left_out;
    emitter->panes = prepared->panes;
    emitter->pane_count = counts && prepared->shadows_extended ? prepared->pane_count : 0;
}

double lx_beyond_all(const struct lx_prepared *prepared, const double place_mm[3])
{
    static const double TIMES = 1024;
    double reach = fmax(prepared->reach_mm, 1);
    for (int k = 0; k < 3; k++)
        reach = fmax(reach, fabs(place_mm[k]));
    return ldexp(1, ilogb(TIMES * reach) + 1);
}

struct lx_lighting lx_light_directly(const struct lx_prepared *prepared, const struct lx_element *element,
                                     const struct lx_emitter *emitter)
{
    if (lx_is_extended(emitter)) {
        struct lx_emitter beyond_glass = *emitter;
        lx_set_panes(prepared, &beyond_glass);
        return lx_light_by_extended(prepared, element, &beyond_glass, 0, NULL);
    }
    if (lx_is_dome(emitter))
        return lx_light_by_dome(prepared, element, emitter->dome);
    struct lx_sample sample = lx_emitter_sample(emitter, element->place_mm);
    if (sample.on_element)
        return (struct lx_lighting){.on_element = true};
    if (lx_is_uniform(emitter))
        return (struct lx_lighting){
            .irradiance = sample.e_perp,
            .diffuse = lx_mul(element->lobe->ambient, sample.e_perp),
        };
    struct lx_reflection reflection = lx_lobe_reflect(element->lobe, element->normal, element->view, sample.towards);
    lx_bounded e_perp = lx_mul(sample.e_perp, lx_openness_of(prepared, element, emitter));
    return (struct lx_lighting){
        .irradiance = lx_mul(e_perp, reflection.cosine),
        .diffuse = lx_mul(e_perp, reflection.diffuse),
        .specular = lx_mul(e_perp, reflection.specular),
    };
}

/* What is not shown, but may be there, is in the bound. */
static lx_bounded hide(lx_bounded number, enum lx_shown shown)
{
    return (lx_bounded){0, shown == LX_SHOWN_NOTHING   ? 0
                           : shown == LX_SHOWN_UNKNOWN ? HUGE_VAL
                                                       : fabs(number.value) + number.error};
}

struct lx_lighting lx_light_element(const struct lx_prepared *prepared, const struct lx_element *element,
                                    const struct lx_emitter *emitter)
{
    struct lx_lighting lighting = lx_light_directly(prepared, element, emitter);
    if (prepared->mirrors.count == 0 || lighting.on_element)
        return lighting;
    lx_add_images(prepared, element, emitter, &lighting);
    if (element->shown != LX_SHOWN) {
        lighting.irradiance = hide(lighting.irradiance, element->shown);
        lighting.diffuse = hide(lighting.diffuse, element->shown);
        lighting.specular = hide(lighting.specular, element->shown);
    }
    return lighting;
}

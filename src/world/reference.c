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
#include "images.h"
#include "integral/cubature.h"
#include "mirrors.h"
#include "open_domes.h"
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

/* What obstacles leave of a uniform source, by its borders, where these are known to the tolerance. */
static bool find_by_borders(const struct lx_prepared *prepared, const struct lx_element *element,
                            const struct lx_emitter *emitter, const struct lx_occlusion *occlusion, double before,
                            lx_bounded *irradiance)
{
    double normal[3];
    lx_bounded seen;
    lx_values3(element->normal, normal);
    if (!lx_has_closed_form(emitter) || !lx_boundary_irradiance(emitter, normal, occlusion, &seen))
        return false;
    seen.error += 2 * M_PI * (element->normal.x.error + element->normal.y.error + element->normal.z.error);
    seen.value = fmax(seen.value, 0);
    *irradiance = lx_mul(emitter->radiance, seen);
    if (irradiance->error <= prepared->tolerance * (before + irradiance->value))
        return true;
    return prepared->tolerance >= SAMPLE &&
           irradiance->error <=
               prepared->tolerance * lx_extended_irradiance(emitter, element->place_mm, element->normal).value;
}

/* In closed form where there is one, else to the tolerance; behind obstacles to the tolerance.  `before`: irradiance of
 * other parts of the same source, relative to which the tolerance is, too. */
static struct lx_lighting light_around(const struct lx_prepared *prepared, const struct lx_element *element,
                                       const struct lx_emitter *emitter, struct lx_occlusion *occlusion, double before)
{
    const struct lx_lobe *lobe = element->lobe;
    const bool is_occluded = lx_is_occluded(occlusion);
    struct lx_lighting lighting = {.irradiance = lx_exact(0), .specular = lx_exact(0)};
    const bool by_borders =
        is_occluded && find_by_borders(prepared, element, emitter, occlusion, before, &lighting.irradiance);
    const bool closed = by_borders || (lx_has_closed_form(emitter) && !is_occluded);
    lighting.parts = by_borders;
    if (closed && !by_borders)
        lighting.irradiance = lx_extended_irradiance(emitter, element->place_mm, element->normal);
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
    struct lx_lighting seen = light_around(prepared, element, emitter, occlusion, before);
    const double wanted = prepared->tolerance;
    const bool is_rough = lx_lobe_is_rough(element->lobe);
    if (!lx_is_occluded(occlusion) || (seen.irradiance.error <= wanted * (before + seen.irradiance.value) &&
                                       (!is_rough || seen.diffuse.error <= wanted * seen.diffuse.value) &&
                                       seen.specular.error <= wanted * seen.specular.value))
        return seen;
    const struct lx_lighting all = light_around(prepared, element, emitter, NULL, before);
    seen.irradiance = within(seen.irradiance, all.irradiance);
    seen.diffuse = is_rough ? within(seen.diffuse, all.diffuse) : lx_mul(element->lobe->diffuse, seen.irradiance);
    seen.specular = within(seen.specular, all.specular);
    return seen;
}

/* `is_open`: not NULL where somebody knows what the source gives if nothing stands before it; that is then told, and
 * nothing else. */
static struct lx_lighting light_by_extended(const struct lx_prepared *prepared, const struct lx_element *element,
                                            const struct lx_emitter *emitter, double before, bool *is_open)
{
    if (lx_extended_touches(emitter, element->place_mm))
        return (struct lx_lighting){.on_element = true};
    if (!prepared->shadows_extended) {
        if (is_open)
            *is_open = true;
        return is_open ? (struct lx_lighting){.irradiance = lx_exact(0)}
                       : light_around(prepared, element, emitter, NULL, before);
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
static void set_panes(const struct lx_prepared *prepared, struct lx_emitter *emitter)
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

/* The sine of the greatest height of a polygon's corners over the element's horizon; 1 of what has none. */
static double highest_of(const struct lx_dome_view *view, const double place_mm[3], const double normal[3])
{
    double highest = -1;
    if (!view->emitter.facets)
        return 1;
    for (size_t i = 0; i < view->facets.corner_count; i++) {
        double way[3];
        for (int k = 0; k < 3; k++)
            way[k] = (&view->corners_mm[i].x)[k].high - place_mm[k];
        highest = fmax(highest, lx_dot(normal, way) / sqrt(lx_dot(way, way)));
    }
    return highest;
}

/* A polygon no higher than that, as far as can be told, is on the horizon or below: where it is on it, as an opening is
 * for places of its own wall, an integral to a share of next to nothing would take long. */
static const double ON_HORIZON = 1e-9;

/* Adds what a polygon on the horizon may give at most; false: it may be higher. */
static bool add_horizon(const struct lx_dome_view *view, const struct lx_element *element, double highest,
                        struct lx_lighting *sum)
{
    const struct lx_emitter *emitter = &view->emitter;
    if (highest > ON_HORIZON || lx_lobe_shines(element->lobe) || lx_lobe_is_rough(element->lobe))
        return highest < -ON_HORIZON;
    if (highest < -ON_HORIZON)
        return true;
    const double unsure = 1e-14 + element->normal.x.error + element->normal.y.error + element->normal.z.error;
    const double greatest = emitter->radiance.value * (emitter->sky ? lx_sky_greatest(emitter->sky) : 1);
    const lx_bounded most = {0, 2 * M_PI * greatest * (fmax(highest, 0) + unsure)};
    sum->irradiance = lx_add(sum->irradiance, most);
    sum->diffuse = lx_add(sum->diffuse, lx_mul(element->lobe->diffuse, most));
    return true;
}

/* What is nearer to a wall, of a room's size, may be on it. */
static const double ON_WALL = 1e-6;

/* The way to a place from the middle of an opening's room, along the room's axes. */
static void find_in_room(const struct lx_glass_pane *opening, const double place_mm[3], double away_mm[3])
{
    double from[3];
    for (int k = 0; k < 3; k++)
        from[k] = place_mm[k] - opening->room_center_mm[k];
    for (int k = 0; k < 3; k++)
        away_mm[k] = lx_dot(from, opening->room_axes[k]);
}

/* Whether a place is in the room of an opening, or on a wall of it and looks inwards. */
static bool is_in_room(const struct lx_glass_pane *opening, const double place_mm[3], const double normal[3])
{
    double away[3];
    find_in_room(opening, place_mm, away);
    for (int k = 0; k < 3; k++) {
        const double half = opening->room_half_mm[k];
        const double outwards = copysign(1, away[k]) * lx_dot(normal, opening->room_axes[k]);
        if (!(fabs(away[k]) <= half * (1 + 1e-9)) || (fabs(away[k]) > half * (1 - ON_WALL) && outwards > 1e-9))
            return false;
    }
    return true;
}

/* The room on whose outside a place lies and looks away, so that none of its walls stands before it; SIZE_MAX: there is
 * none. */
static size_t find_room_behind(const struct lx_prepared *prepared, const double place_mm[3], const double normal[3])
{
    for (size_t i = 0; i < prepared->pane_count; i++) {
        const struct lx_glass_pane *opening = &prepared->panes[i];
        double away[3];
        find_in_room(opening, place_mm, away);
        for (int k = 0; k < 3; k++)
            if (fabs(away[k]) >= opening->room_half_mm[k] * (1 - 1e-12) &&
                copysign(1, away[k]) * lx_dot(normal, opening->room_axes[k]) > 1 - 1e-12)
                return opening->surface;
    }
    return SIZE_MAX;
}

/* Whether a place is in an opening, and looks outside as well. */
static bool looks_out(const struct lx_glass_pane *opening, const double place_mm[3], const double normal[3])
{
    const double *size = opening->room_half_mm, near = ON_WALL * fmax(size[0], fmax(size[1], size[2]));
    double from[3];
    for (int k = 0; k < 3; k++)
        from[k] = place_mm[k] - opening->center_mm[k];
    return fabs(lx_dot(from, opening->axis)) <= near &&
           fabs(lx_dot(from, opening->across)) <= opening->half_mm[0] + near &&
           fabs(lx_dot(from, opening->upward)) <= opening->half_mm[1] + near &&
           lx_dot(normal, opening->axis) < 1 - 1e-12;
}

/* The room around a place, whose walls hide from it all but what is seen through its openings; SIZE_MAX: there is
 * none. */
static size_t find_room(const struct lx_prepared *prepared, const double place_mm[3], const double normal[3])
{
    size_t room = SIZE_MAX;
    for (size_t i = 0; i < prepared->pane_count; i++)
        room = is_in_room(&prepared->panes[i], place_mm, normal) ? prepared->panes[i].surface : room;
    for (size_t i = 0; i < prepared->pane_count && room < SIZE_MAX; i++)
        if (prepared->panes[i].surface == room && looks_out(&prepared->panes[i], place_mm, normal))
            return SIZE_MAX;
    return room;
}

/* The corners of an opening from a place. */
static void find_rim(const struct lx_glass_pane *opening, const double place_mm[3], lx_wide3 rim[4])
{
    const lx_wide3 middle = lx_wide3_sub(lx_wide3_of(opening->center_mm), lx_wide3_of(place_mm));
    for (int i = 0; i < 4; i++) {
        const lx_wide right = lx_wide_of(i == 0 || i == 3 ? opening->half_mm[0] : -opening->half_mm[0]);
        const lx_wide up = lx_wide_of(i < 2 ? opening->half_mm[1] : -opening->half_mm[1]);
        rim[i] = lx_wide3_add(middle, lx_wide3_add(lx_wide3_mul(lx_wide3_of(opening->across), right),
                                                   lx_wide3_mul(lx_wide3_of(opening->upward), up)));
    }
}

static void add_lighting(struct lx_lighting *sum, const struct lx_lighting *part)
{
    sum->irradiance = lx_add(sum->irradiance, part->irradiance);
    sum->diffuse = lx_add(sum->diffuse, part->diffuse);
    sum->specular = lx_add(sum->specular, part->specular);
    sum->parts += part->parts;
}

/* What is seen through the openings of the room around the element, whose walls hide all else. */
static struct lx_lighting light_through(const struct lx_prepared *prepared, const struct lx_element *element,
                                        const struct lx_dome *dome, size_t room, double away_mm)
{
    struct lx_lighting sum = {.irradiance = lx_exact(0), .diffuse = lx_exact(0), .specular = lx_exact(0)};
    struct lx_prepared without = *prepared;
    double place[3], normal[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    without.left_out = room + 1;
    for (size_t i = 0; i < prepared->pane_count; i++) {
        const struct lx_glass_pane *opening = &prepared->panes[i];
        const lx_wide3 outwards = lx_wide3_mul(lx_wide3_of(opening->axis), lx_wide_of(-1));
        struct lx_dome_view views[LX_MOST_DOME_VIEWS];
        lx_wide3 rim[4];
        if (opening->surface != room)
            continue;
        find_rim(opening, place, rim);
        const size_t count = lx_dome_see_through(dome, rim, outwards, place, away_mm, views);
        for (size_t k = 0; k < count; k++) {
            if (add_horizon(&views[k], element, highest_of(&views[k], place, normal), &sum))
                continue;
            set_panes(prepared, &views[k].emitter);
            views[k].emitter.through = opening;
            const struct lx_lighting part =
                light_by_extended(&without, element, &views[k].emitter, sum.irradiance.value, NULL);
            add_lighting(&sum, &part);
        }
    }
    return sum;
}

/* What is remembered of a dome for elements like this one, in memory of its own where it has none; NULL: nothing is, as
 * it depends on the place of who looks, or the view vector is another one for each element. */
static struct lx_open_dome *remember(const struct lx_prepared *prepared, const struct lx_element *element,
                                     const struct lx_dome *dome, struct lx_open_dome *own)
{
    struct lx_open_dome *open = element->open_dome ? element->open_dome : own;
    lx_bounded3 view = {.x = lx_exact(0)};
    if (lx_lobe_shines(element->lobe) || lx_lobe_is_rough(element->lobe)) {
        if (!prepared->camera.is_parallel || !element->own || !lx_shape_is_flat(&element->own->shape))
            return NULL;
        view = element->view;
    }
    if (open->dome != dome || open->lobe != element->lobe ||
        memcmp(&open->normal, &element->normal, sizeof open->normal) != 0 ||
        memcmp(&open->view, &view, sizeof open->view) != 0)
        *open = (struct lx_open_dome){.dome = dome, .lobe = element->lobe, .normal = element->normal, .view = view};
    return open;
}

/* What a patch gives that nothing hides: the same at the origin, so that it is the same number for whoever asks. */
static struct lx_lighting light_openly(const struct lx_prepared *prepared, const struct lx_element *element,
                                       const struct lx_dome *dome, size_t patch, struct lx_open_dome *remembered)
{
    const double origin[3] = {0, 0, 0};
    struct lx_open_patch *open = &remembered->patches[patch];
    struct lx_element there = *element;
    struct lx_dome_view view;
    /* round surfaces have a normal for each element, which are too many to be kept */
    struct lx_open_domes *domes = element->own && !lx_shape_is_flat(&element->own->shape) ? NULL : prepared->open_domes;
    if (!open->is_known)
        open->is_known = lx_open_domes_look(domes, remembered, prepared->tolerance, patch, &open->lighting);
    if (!open->is_known) {
        there.place_mm = lx_exact3(origin);
        lx_dome_see(dome, patch, origin, lx_beyond_all(prepared, origin), &view);
        *open = (struct lx_open_patch){true, light_around(prepared, &there, &view.emitter, NULL, 0)};
        lx_open_domes_note(domes, remembered, prepared->tolerance, patch, &open->lighting);
    }
    struct lx_lighting found = open->lighting;
    found.parts = element->open_dome ? 0 : found.parts; /* of many elements nobody looked at them for this one */
    return found;
}

/* Patch by patch; those that the element does not look to give nothing. */
static struct lx_lighting light_by_dome(const struct lx_prepared *prepared, const struct lx_element *element,
                                        const struct lx_dome *dome)
{
    struct lx_lighting sum = {.irradiance = lx_exact(0), .diffuse = lx_exact(0), .specular = lx_exact(0)};
    enum { SHARES = 4 }; /* of the tolerance, which patches are to keep together */
    const bool looks_below = lx_lobe_reaches_below(element->lobe);
    double place[3], normal[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    const double away_mm = lx_beyond_all(prepared, place);
    struct lx_prepared shared = *prepared;
    shared.tolerance /= SHARES;
    const size_t room = prepared->shadows_extended && !looks_below ? find_room(prepared, place, normal) : SIZE_MAX;
    if (room < SIZE_MAX && !lx_is_sun(dome))
        return light_through(&shared, element, dome, room, away_mm);
    struct lx_open_dome own = {.dome = NULL}, *remembered = remember(prepared, element, dome, &own);
    if (!looks_below)
        shared.left_out = find_room_behind(prepared, place, normal) + 1;
    for (size_t i = 0; i < dome->patch_count; i++) {
        struct lx_dome_view view;
        lx_dome_see(dome, i, place, away_mm, &view);
        if (!looks_below && add_horizon(&view, element, highest_of(&view, place, normal), &sum))
            continue;
        set_panes(&shared, &view.emitter);
        bool is_open = false, *asks = remembered && view.emitter.pane_count == 0 ? &is_open : NULL;
        struct lx_lighting part = light_by_extended(&shared, element, &view.emitter, sum.irradiance.value, asks);
        if (is_open)
            part = light_openly(&shared, element, dome, i, remembered);
        add_lighting(&sum, &part);
    }
    return sum;
}

struct lx_lighting lx_light_directly(const struct lx_prepared *prepared, const struct lx_element *element,
                                     const struct lx_emitter *emitter)
{
    if (lx_is_extended(emitter)) {
        struct lx_emitter beyond_glass = *emitter;
        set_panes(prepared, &beyond_glass);
        return light_by_extended(prepared, element, &beyond_glass, 0, NULL);
    }
    if (lx_is_dome(emitter))
        return light_by_dome(prepared, element, emitter->dome);
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

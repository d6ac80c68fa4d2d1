/* SPDX-License-Identifier: MIT */
/* Lighting an element by a dome: patch by patch in the open, through its openings from within a room. */
#include "domes.h"

#include <string.h>

#include "../base/vector.h"
#include "potentials.h"
#include "reference.h"
#include "visibility/occlusion.h"

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

/* From which tolerance on potentials are asked: they are not more exact. */
static const double BY_BORDERS = 1e-6;

/* Whether no glass is in the way but what an opening (NULL: none) may have. */
static bool is_only_glass(const struct lx_prepared *prepared, const struct lx_glass_pane *opening)
{
    bool is_only = true;
    for (size_t i = 0; i < prepared->pane_count; i++)
        is_only =
            is_only && (!(prepared->panes[i].index > 0) || (opening && prepared->panes[i].surface == opening->surface));
    return is_only;
}

/* The glass before a view of a dome, through an opening if not NULL, and its potential, where integrals need not be
 * more exact than that. */
static void look_through(const struct lx_prepared *prepared, const struct lx_glass_pane *opening,
                         struct lx_emitter *emitter)
{
    const bool is_glazed = opening && opening->index > 0, is_only = is_only_glass(prepared, opening);
    lx_set_panes(prepared, emitter);
    emitter->through = opening;
    if (is_only && !is_glazed)
        emitter->pane_count = 0;
    if (is_only && (emitter->sky || is_glazed) && emitter->radiance.value > 0 && prepared->tolerance >= BY_BORDERS)
        emitter->potential = lx_potentials_find(prepared->potentials, emitter->sky, opening);
}

/* The irradiance through an opening, by the borders of what is seen of it; false: it is not known to the tolerance. */
static bool light_by_borders(const struct lx_prepared *prepared, const struct lx_element *element,
                             const struct lx_dome_view *views, size_t count, struct lx_lighting *sum)
{
    struct lx_lighting found = *sum;
    double place[3], normal[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    bool is_known = true;
    for (size_t k = 0; k < count && is_known; k++) /* before anything is gathered in vain */
        is_known = views[k].emitter.potential || lx_has_closed_form(&views[k].emitter);
    for (size_t k = 0; k < count && is_known; k++) {
        const struct lx_emitter *emitter = &views[k].emitter;
        struct lx_occlusion occlusion = {.place_mm = {0}};
        struct lx_lighting part = {.irradiance = lx_exact(0)};
        if (add_horizon(&views[k], element, highest_of(&views[k], place, normal), &found))
            continue;
        is_known = lx_occlusion_make(prepared, element, emitter, true, &occlusion) == 0 &&
                   (occlusion.is_dark ||
                    lx_light_by_borders(prepared, element, emitter, &occlusion, found.irradiance.value, &part));
        lx_occlusion_clear(&occlusion);
        found.irradiance = lx_add(found.irradiance, part.irradiance);
        found.parts += part.parts;
    }
    if (!is_known)
        return false;
    found.diffuse = lx_mul(element->lobe->diffuse, found.irradiance);
    *sum = found;
    return true;
}

/* Whether a part of the sun may be seen through an opening. */
static bool sun_is_in(const struct lx_dome *sun, const struct lx_glass_pane *opening, const double place_mm[3])
{
    static const double ROUNDING = 1e-9;
    double inwards[LX_RIM][3], from[3];
    for (int k = 0; k < 3; k++)
        from[k] = place_mm[k] - opening->center_mm[k];
    bool is_in = lx_dot(opening->axis, from) > 0;
    lx_pane_edges(opening, place_mm, inwards);
    for (int i = 0; i < LX_RIM && is_in; i++)
        is_in = lx_dot(inwards[i], sun->up) > -sun->patches[0].radius - ROUNDING;
    return is_in;
}

/* The views of a dome through an opening; `is_cut`: with the sun in corners alone. */
static size_t see_through(const struct lx_prepared *prepared, const struct lx_dome *dome,
                          const struct lx_glass_pane *opening, const double place_mm[3], bool is_cut,
                          struct lx_dome_view views[LX_MOST_DOME_VIEWS])
{
    const lx_wide3 outwards = lx_wide3_mul(lx_wide3_of(opening->axis), lx_wide_of(-1));
    const double away_mm = lx_beyond_all(prepared, place_mm);
    lx_wide3 rim[LX_RIM];
    size_t count = lx_is_sun(dome) && sun_is_in(dome, opening, place_mm);
    if (count > 0)
        lx_dome_see(dome, 0, place_mm, away_mm, &views[0]);
    if (!lx_is_sun(dome)) {
        find_rim(opening, place_mm, rim);
        count = lx_dome_see_through(dome, rim, outwards, place_mm, away_mm, is_cut, views);
    }
    for (size_t k = 0; k < count; k++)
        look_through(prepared, opening, &views[k].emitter);
    return count;
}

/* What is seen through the openings of the room around the element, whose walls hide all else. */
static struct lx_lighting light_through(const struct lx_prepared *prepared, const struct lx_element *element,
                                        const struct lx_dome *dome, size_t room)
{
    struct lx_lighting sum = {.irradiance = lx_exact(0), .diffuse = lx_exact(0), .specular = lx_exact(0)};
    struct lx_prepared without = *prepared;
    double place[3], normal[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    const bool is_matte = !lx_lobe_shines(element->lobe) && !lx_lobe_is_rough(element->lobe);
    without.left_out = room + 1;
    for (size_t i = 0; i < prepared->pane_count; i++) {
        const struct lx_glass_pane *opening = &prepared->panes[i];
        struct lx_dome_view views[LX_MOST_DOME_VIEWS];
        if (opening->surface != room)
            continue;
        size_t count = is_matte ? see_through(prepared, dome, opening, place, false, views) : 0;
        if (is_matte && light_by_borders(&without, element, views, count, &sum))
            continue;
        count = see_through(prepared, dome, opening, place, true, views);
        for (size_t k = 0; k < count; k++) {
            if (add_horizon(&views[k], element, highest_of(&views[k], place, normal), &sum))
                continue;
            const struct lx_lighting part =
                lx_light_by_extended(&without, element, &views[k].emitter, sum.irradiance.value, NULL);
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
        look_through(prepared, NULL, &view.emitter);
        *open = (struct lx_open_patch){true, lx_light_around(prepared, &there, &view.emitter, NULL, 0)};
        lx_open_domes_note(domes, remembered, prepared->tolerance, patch, &open->lighting);
    }
    struct lx_lighting found = open->lighting;
    found.parts = element->open_dome ? 0 : found.parts; /* of many elements nobody looked at them for this one */
    return found;
}

struct lx_lighting lx_light_by_dome(const struct lx_prepared *prepared, const struct lx_element *element,
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
    if (room < SIZE_MAX)
        return light_through(&shared, element, dome, room);
    struct lx_open_dome own = {.dome = NULL}, *remembered = remember(prepared, element, dome, &own);
    if (!looks_below)
        shared.left_out = find_room_behind(prepared, place, normal) + 1;
    for (size_t i = 0; i < dome->patch_count; i++) {
        struct lx_dome_view view;
        lx_dome_see(dome, i, place, away_mm, &view);
        if (!looks_below && add_horizon(&view, element, highest_of(&view, place, normal), &sum))
            continue;
        look_through(&shared, NULL, &view.emitter);
        bool is_open = false, *asks = remembered && view.emitter.pane_count == 0 ? &is_open : NULL;
        struct lx_lighting part = lx_light_by_extended(&shared, element, &view.emitter, sum.irradiance.value, asks);
        if (is_open)
            part = light_openly(&shared, element, dome, i, remembered);
        add_lighting(&sum, &part);
    }
    return sum;
}

/* SPDX-License-Identifier: MIT */
/*
 * Continuous extrema: climbs from all promising places, the best first, and makes of the highest summit a peak: a place
 * that is seen, with the value that it has there.
 */
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../world/camera.h"
#include "extrema.h"
#include "extrema_plain.h"
#include "field.h"
#include "region.h"

/* The tolerance of a look around where values need integrals. */
static const double COARSE = 1e-5;
/* What may be lost, relative, by standing a little off an edge where that is needed. */
static const double NEAR = 2e-11;
/* How many climbs are made at most. */
enum { MOST_CLIMBS = 64, MOST_CLIMBS_COSTLY = 10 };
/* More lights or edges than these are not looked at one by one. */
enum { MOST_EDGE_LIGHTS = 64, MOST_EDGES = 4096 };

bool lx_search_goes_on(struct lx_extremum_search *search)
{
    search->stopped = search->stopped || !lx_control_goes_on(&search->control, true);
    return !search->stopped && !search->short_of_memory;
}

static bool is_on_screen(const struct lx_extremum_search *search, const double at[2])
{
    const struct lx_screen *screen = &search->prepared->scene->screen;
    return fabs(at[0]) <= screen->width_mm / 2 && fabs(at[1]) <= screen->height_mm / 2 &&
           luxel_region_holds(search->region, at[0], at[1]);
}

/* -- from a summit to a peak -- */

/* Whether a spot lies so near to where lines of sight touch its surface that the screen does not tell it from others;
 * then *inside is a place towards whose picture the surface goes on. */
static bool is_near_limb(const struct lx_extremum_search *search, const struct lx_spot *spot, double inside_mm[3])
{
    const struct lx_shape *shape = lx_spot_shape(search, spot);
    const struct lx_origin eye = lx_eye_of(search);
    return lx_shape_has_limb(shape) && shape->kind->chart->is_near_limb(shape, &eye, spot->at, inside_mm);
}

/* The screen point nearest to where a spot of a rim is seen at which its surface is found. */
static bool find_on_screen(const struct lx_extremum_search *search, const struct lx_spot *spot,
                           const double inside_mm[3], double at[2])
{
    const struct lx_prepared *prepared = search->prepared;
    double place[3], normal[3], rim[2], center[2];
    lx_spot_place(search, spot, place, normal);
    lx_screen_of(search, place, rim);
    lx_screen_of(search, inside_mm, center);
    for (double inward = 0; inward<1e-9; inward = inward> 0 ? inward * 2 : LX_ROUNDING) {
        struct lx_element element;
        for (int i = 0; i < 2; i++)
            at[i] = rim[i] - inward * (rim[i] - center[i]);
        if (lx_element_seen(prepared, at[0], at[1], &element) && element.own == &prepared->surfaces[spot->surface])
            return is_on_screen(search, at);
    }
    return false;
}

/* Brings a point that rounding left beyond the edges of screen and region back to them. */
static void clip(const struct lx_extremum_search *search, double at[2])
{
    const struct lx_screen *screen = &search->prepared->scene->screen;
    const double half[2] = {screen->width_mm / 2, screen->height_mm / 2};
    for (int i = 0; i < 2; i++) {
        at[i] = fmin(fmax(at[i], -half[i]), half[i]);
        if (!search->region || search->region->type != LUXEL_REGION_RECTANGLE)
            continue;
        double middle = search->region->center_mm[i], reach = search->region->size_mm[i] / 2;
        at[i] = fmin(fmax(at[i], middle - reach), middle + reach);
    }
}

/* What is truly found at a spot; false: it is not seen, or has no value. */
static bool look_at(struct lx_extremum_search *search, const struct lx_spot *spot, luxel_peak *peak)
{
    double place[3], normal[3], inside[3], at[2];
    luxel_value found;
    if (is_near_limb(search, spot, inside)) {
        if (!find_on_screen(search, spot, inside, at))
            return false;
        const struct lx_element element = lx_spot_element(search, spot);
        found = lx_evaluate_element(search->evaluator, &element, NULL);
    } else {
        lx_spot_place(search, spot, place, normal);
        if (!lx_screen_of(search, place, at))
            return false;
        clip(search, at);
        luxel_evaluate_screen(search->evaluator, at[0], at[1], &found, NULL);
    }
    if (!found.on_surface || lx_prepared_index(search->prepared, found.surface, found.part) != spot->surface ||
        !found.has_value || !is_on_screen(search, at))
        return false;
    *peak = (luxel_peak){
        .exists = true,
        .value = found.value,
        .error = found.error,
        .x_mm = at[0],
        .y_mm = at[1],
        .surface = found.surface,
        .part = found.part,
        .position_mm = {found.position_mm[0], found.position_mm[1], found.position_mm[2]},
        .normal = {found.normal[0], found.normal[1], found.normal[2]},
    };
    return true;
}

/* The direction off all edges that the climb ended on, into the side where it stands. */
static bool way_off(const struct lx_extremum_search *search, const struct lx_climb *climb, const struct lx_chart *chart,
                    double off[2])
{
    off[0] = off[1] = 0;
    for (unsigned i = 0; i < climb->active_count; i++) {
        double inward[2];
        if (!lx_edge_inward(search, climb->active[i], &climb->at, chart, inward))
            return false;
        off[0] += inward[0], off[1] += inward[1];
    }
    double length = hypot(off[0], off[1]);
    off[0] /= length, off[1] /= length;
    return length > 0;
}

static luxel_peak_place place_of(const struct lx_extremum_search *search, const struct lx_climb *climb)
{
    luxel_peak_place place = LUXEL_PEAK_INSIDE;
    for (unsigned i = 0; i < climb->active_count; i++) {
        const struct lx_search_edge *edge = &search->edges[climb->active[i]];
        bool border = edge->type == LX_EDGE_SCREEN || edge->type == LX_EDGE_REGION;
        luxel_peak_place one = border ? LUXEL_PEAK_BORDER : lx_edge_is_wall(edge) ? LUXEL_PEAK_LIMB : LUXEL_PEAK_JUMP;
        if (place == LUXEL_PEAK_INSIDE || one == LUXEL_PEAK_BORDER ||
            (one == LUXEL_PEAK_LIMB && place == LUXEL_PEAK_JUMP))
            place = one;
    }
    return place;
}

/* Whether a peak lies in a part of one value, or on its edge. */
static bool is_plateau(struct lx_extremum_search *search, const struct lx_climb *climb, const luxel_peak *peak)
{
    struct lx_chart chart = lx_spot_chart(search, &climb->at);
    double reach_mm = fmin(search->pixel_mm, lx_spot_shape(search, &climb->at)->radius_mm) / 8;
    int alike = 0, others = 0;
    for (int i = 0; i < 8 && others < 5; i++) {
        double turn = M_PI * i / 4 + 0.1;
        struct lx_spot spot =
            lx_spot_moved(search, &climb->at, &chart, (double[]){reach_mm * cos(turn), reach_mm * sin(turn)});
        luxel_peak beside;
        if (!look_at(search, &spot, &beside))
            continue;
        if (beside.value == peak->value)
            alike++;
        else
            others++;
    }
    return alike > 2 || (alike > 0 && others == 0);
}

/* Where a climb ended, or a little off the edges there. */
static bool look_off(struct lx_extremum_search *search, const struct lx_climb *climb, const struct lx_chart *chart,
                     const double off[2], double step_mm, luxel_peak *peak)
{
    struct lx_spot spot = climb->at;
    if (step_mm > 0)
        spot = lx_spot_moved(search, &climb->at, chart, (double[]){step_mm * off[0], step_mm * off[1]});
    return look_at(search, &spot, peak);
}

/* Whether a peak gives what the climb promised, beyond doubt of the side of an edge on which it lies. */
static bool is_enough(const struct lx_extremum_search *search, const struct lx_climb *climb, const luxel_peak *peak)
{
    double promised = climb->value - fmax(NEAR, climb->noise) * fabs(climb->value);
    return search->sign * peak->value >= promised && peak->error <= 1e-9 * fabs(peak->value) + DBL_MIN;
}

/*
 * The peak of a summit.  Where the function jumps, or another surface begins, the edge may belong to the other side:
 * then the nearest place that does not, found by growing steps off the edge, and by halving the last.
 */
static bool find_peak(struct lx_extremum_search *search, const struct lx_climb *climb, luxel_peak *peak)
{
    struct lx_chart chart = lx_spot_chart(search, &climb->at);
    double off[2] = {0, 0}, size_mm = lx_spot_shape(search, &climb->at)->radius_mm, bad_mm = 0, good_mm = 0;
    luxel_peak trial;
    bool found = look_off(search, climb, &chart, off, 0, peak);
    if ((found && is_enough(search, climb, peak)) || climb->active_count == 0 || !way_off(search, climb, &chart, off))
        return found;
    for (double step_mm = 1e-15 * size_mm; step_mm <= 1e-7 * size_mm; step_mm *= 2) {
        if (!look_off(search, climb, &chart, off, step_mm, &trial))
            continue;
        bool enough = is_enough(search, climb, &trial);
        if (enough || !found || search->sign * (trial.value - peak->value) > 0)
            *peak = trial, good_mm = step_mm, bad_mm = step_mm / 2;
        found = true;
        if (enough)
            return true;
    }
    for (int i = 0; i < 20 && found && good_mm > 0 && !is_enough(search, climb, peak); i++) {
        double middle_mm = (bad_mm + good_mm) / 2;
        if (look_off(search, climb, &chart, off, middle_mm, &trial) && search->sign * (trial.value - peak->value) > 0)
            *peak = trial, good_mm = middle_mm;
        else
            bad_mm = middle_mm;
    }
    return found;
}

/* The least that there can be: what comes from everywhere.  Nothing lower need be looked for. */
static bool is_least(const struct lx_extremum_search *search, const luxel_peak *peak)
{
    double least = 0;
    const struct lx_emitters *emitters = &search->prepared->emitters;
    const struct lx_lobe *lobe =
        &search->prepared->surfaces[lx_prepared_index(search->prepared, peak->surface, peak->part)].lobe;
    for (size_t i = 0; i < lx_item_count(emitters); i++)
        if (lx_is_uniform(&emitters->items[i]))
            least += (search->evaluator->settings.quantity == LUXEL_IRRADIANCE ? 1 : lobe->ambient.value) *
                     emitters->items[i].strength;
    return search->sign < 0 && search->prepared->surface_count == 1 ? peak->value <= least : peak->value <= 0;
}

static bool make_peak(struct lx_extremum_search *search, const struct lx_climb *climb, luxel_peak *peak)
{
    if (!find_peak(search, climb, peak))
        return false;
    peak->place = place_of(search, climb);
    bool smooth = peak->place == LUXEL_PEAK_INSIDE || peak->place == LUXEL_PEAK_JUMP;
    if ((!smooth || climb->flat || is_least(search, peak)) && is_plateau(search, climb, peak))
        peak->place = LUXEL_PEAK_PLATEAU;
    return true;
}

/* -- the search -- */

static bool keep_summit(struct lx_extremum_search *search, const struct lx_climb *climb)
{
    if (lx_reserve(&search->summits, &search->summit_capacity, search->summit_count + 1, sizeof *search->summits)) {
        search->short_of_memory = true;
        return false;
    }
    search->summits[search->summit_count++] = (struct lx_summit){climb->at, climb->value, climb->length_mm};
    return true;
}

/* Whether a costly climb may be spared, since it begins on the hill of a summit that is known. */
static bool is_on_known_hill(const struct lx_extremum_search *search, const struct lx_seed *seed)
{
    double here[3], there[3], normal[3];
    lx_spot_place(search, &seed->spot, here, normal);
    for (size_t i = 0; search->costly && i < search->summit_count; i++) {
        const struct lx_summit *summit = &search->summits[i];
        if (summit->spot.surface != seed->spot.surface || seed->value - seed->margin > summit->value)
            continue;
        lx_spot_place(search, &summit->spot, there, normal);
        double apart = hypot(hypot(here[0] - there[0], here[1] - there[1]), here[2] - there[2]);
        if (apart <= fmax(4 * search->pixel_mm, summit->length_mm / 2))
            return true;
    }
    return false;
}

/* One climb; the peak at its end replaces *best if it is better. */
static void climb_from(struct lx_extremum_search *search, const struct lx_seed *seed, luxel_peak *best)
{
    struct lx_climb climb = {.at = seed->spot, .trust_mm = search->pixel_mm, .length_mm = search->pixel_mm};
    if (!lx_edges_enter(search, &climb.at))
        return;
    lx_climb_up(search, &climb);
    if (climb.known || !isfinite(climb.value) || !keep_summit(search, &climb))
        return;
    luxel_peak peak;
    if (best->exists && climb.value < search->sign * best->value)
        return;
    if (make_peak(search, &climb, &peak) && (!best->exists || search->sign * (peak.value - best->value) > 0))
        *best = peak;
}

static void search_from(struct lx_extremum_search *search, const struct lx_seeds *seeds, luxel_peak *best)
{
    size_t climbs = 0, most = search->costly ? MOST_CLIMBS_COSTLY : MOST_CLIMBS;
    for (size_t i = 0; i < seeds->count && climbs < most && lx_search_goes_on(search); i++) {
        const struct lx_seed *seed = &seeds->items[i];
        if (best->exists && seed->value + seed->margin <= search->sign * best->value)
            continue;
        if (is_on_known_hill(search, seed))
            continue;
        climb_from(search, seed, best);
        climbs++;
        atomic_fetch_add(&search->control.rows_done, 1);
        if (best->exists && search->sign < 0 && is_least(search, best))
            break;
    }
}

static double size_of(const double place_mm[3])
{
    return sqrt(lx_dot(place_mm, place_mm));
}

static void set_scales(struct lx_extremum_search *search, const luxel_field *field)
{
    const struct lx_scene_parameters *scene = search->prepared->scene;
    search->scale_mm = fmax(scene->screen.width_mm, scene->screen.height_mm);
    const struct lx_camera *camera = &search->prepared->camera;
    if (camera->is_perspective)
        search->scale_mm = fmax(search->scale_mm, fmax(fabs(camera->z_mm), size_of(camera->position_mm)));
    if (!camera->frame.is_own)
        search->scale_mm = fmax(search->scale_mm, size_of(camera->frame.origin_mm));
    for (size_t i = 0; i < search->prepared->surface_count; i++) {
        const struct lx_shape *shape = &search->prepared->surfaces[i].shape;
        double reach = size_of(shape->anchor_mm) + shape->radius_mm;
        search->scale_mm = fmax(search->scale_mm, reach);
    }
    search->pixel_mm = scene->screen.width_mm / field->columns;
}

static bool make_gates(struct lx_extremum_search *search)
{
    search->gates = lx_new_array(search->prepared->surface_count, sizeof *search->gates);
    for (size_t i = 0; search->gates && i < search->prepared->surface_count; i++) {
        struct lx_gates *gates = &search->gates[i];
        gates->open = gates->shut = search->prepared->surfaces[i].lobe;
        gates->open.highlight = LX_HIGHLIGHT_PLAIN;
        gates->shut.specular = lx_exact(0);
    }
    return search->gates;
}

/* Whether the lights can be looked at one by one, and whether their values need integrals. */
static void judge_lights(struct lx_extremum_search *search)
{
    const struct lx_emitters *emitters = &search->prepared->emitters;
    bool is_irradiance = search->evaluator->settings.quantity == LUXEL_IRRADIANCE, shines = false;
    size_t narrow = 0;
    for (size_t i = 0; i < search->prepared->surface_count; i++)
        shines = shines || search->prepared->surfaces[i].lobe.specular.value > 0;
    for (size_t i = 0; i < emitters->count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        const bool is_hidden = search->prepared->shadows && search->prepared->shadows_extended;
        bool closed = lx_has_closed_form(emitter) && (is_irradiance || !shines) && !is_hidden;
        search->costly = search->costly || lx_is_dome(emitter) || (lx_is_extended(emitter) && !closed);
        narrow += lx_has_one_way(emitter);
    }
    search->knows_lights = narrow <= MOST_EDGE_LIGHTS && narrow * search->prepared->surface_count <= MOST_EDGES;
    search->costly = search->costly || emitters->count > MOST_EDGE_LIGHTS;
}

static bool are_walkable(const struct lx_prepared *prepared)
{
    for (size_t i = 0; i < prepared->surface_count; i++)
        if (!lx_shape_is_walkable(&prepared->surfaces[i].shape))
            return false;
    return true;
}

static luxel_status search_for(const luxel_evaluator *evaluator, const luxel_field *field, const luxel_region *region,
                               double sign, luxel_diagnostics *diagnostics, luxel_peak *peak)
{
    struct lx_extremum_search search = {
        .evaluator = evaluator,
        .prepared = &evaluator->prepared,
        .quick = evaluator->prepared,
        .bare = evaluator->prepared,
        .region = region,
        .sign = sign,
        .control = {.rows = 2 * (MOST_CLIMBS + 1),
                    .progress = evaluator->settings.progress,
                    .data = evaluator->settings.progress_data},
    };
    struct lx_seeds seeds = {.items = NULL};
    if (sign < 0) /* the maximum is done */
        atomic_store(&search.control.rows_done, MOST_CLIMBS + 1);
    judge_lights(&search);
    set_scales(&search, field);
    if (search.costly)
        search.quick.tolerance = fmax(COARSE, search.quick.tolerance);
    search.bare.shadows = search.bare.shadows && !search.knows_lights; /* penumbrae stay */
    *peak = (luxel_peak){.exists = false};
    search.short_of_memory = !make_gates(&search);
    if (evaluator->world.reflected || evaluator->part_count > 0 || !are_walkable(search.prepared))
        lx_search_plainly(&search, field, peak);
    else if (!search.short_of_memory && lx_search_seeds(&search, field, &seeds))
        search_from(&search, &seeds, peak);
    free(seeds.items);
    free(search.gates);
    free(search.edges);
    free(search.sides);
    free(search.summits);
    if (search.short_of_memory)
        return lx_out_of_memory(diagnostics);
    return search.stopped ? LUXEL_CANCELLED : LUXEL_OK;
}

static luxel_status check(const luxel_evaluator *evaluator, const luxel_field *field, const luxel_region *region,
                          const luxel_extrema *extrema, luxel_diagnostics *diagnostics)
{
    const char *missing = !evaluator ? "evaluator" : !field ? "field" : !extrema ? "extrema" : NULL;
    if (missing)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(missing));
    const struct lx_screen *screen = &evaluator->prepared.scene->screen;
    unsigned columns = screen->resolution[0], rows = screen->resolution[1];
    bool fits = field->columns == columns && field->rows == rows && field->x_mm && field->y_mm &&
                field->quantity == evaluator->settings.quantity;
    for (unsigned i = 0; fits && i < columns; i++)
        fits = field->x_mm[i] == lx_column_x_mm(screen, i);
    for (unsigned i = 0; fits && i < rows; i++)
        fits = field->y_mm[i] == lx_row_y_mm(screen, i);
    if (!fits)
        return lx_refuse(diagnostics, LX_MSG_FOREIGN_FIELD, NULL);
    return lx_region_check(region, diagnostics);
}

luxel_status luxel_find_extrema(const luxel_evaluator *evaluator, const luxel_field *field, const luxel_region *region,
                                luxel_diagnostics *diagnostics, luxel_extrema *extrema)
{
    luxel_status status = check(evaluator, field, region, extrema, diagnostics);
    if (status != LUXEL_OK)
        return status;
    luxel_extrema found = {.maximum.exists = false};
    status = search_for(evaluator, field, region, 1, diagnostics, &found.maximum);
    if (status == LUXEL_OK)
        status = search_for(evaluator, field, region, -1, diagnostics, &found.minimum);
    if (status == LUXEL_OK)
        *extrema = found;
    return status;
}

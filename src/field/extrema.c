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

bool lx_hunt_goes_on(struct lx_hunt *hunt)
{
    hunt->stopped = hunt->stopped || !lx_control_goes_on(&hunt->control, true);
    return !hunt->stopped && !hunt->short_of_memory;
}

static bool is_on_screen(const struct lx_hunt *hunt, const double at[2])
{
    const struct lx_screen *screen = &hunt->prepared->scene->screen;
    return fabs(at[0]) <= screen->width_mm / 2 && fabs(at[1]) <= screen->height_mm / 2 &&
           luxel_region_holds(hunt->region, at[0], at[1]);
}

/* -- from a summit to a peak -- */

/* Whether a spot lies so near to where lines of sight touch its surface that the screen does not tell it from others;
 * then *inside is a place towards whose picture the surface goes on. */
static bool is_near_limb(const struct lx_hunt *hunt, const struct lx_spot *spot, double inside_mm[3])
{
    const struct lx_shape *shape = lx_spot_shape(hunt, spot);
    const struct lx_origin eye = lx_eye_of(hunt);
    return lx_shape_has_limb(shape) && shape->kind->chart->is_near_limb(shape, &eye, spot->at, inside_mm);
}

/* The screen point nearest to where a spot of a rim is seen at which its surface is found. */
static bool find_on_screen(const struct lx_hunt *hunt, const struct lx_spot *spot, const double inside_mm[3],
                           double at[2])
{
    const struct lx_prepared *prepared = hunt->prepared;
    double place[3], normal[3], rim[2], center[2];
    lx_spot_place(hunt, spot, place, normal);
    lx_screen_of(hunt, place, rim);
    lx_screen_of(hunt, inside_mm, center);
    for (double inward = 0; inward<1e-9; inward = inward> 0 ? inward * 2 : LX_ROUNDING) {
        struct lx_element element;
        for (int i = 0; i < 2; i++)
            at[i] = rim[i] - inward * (rim[i] - center[i]);
        if (lx_element_seen(prepared, at[0], at[1], &element) && element.own == &prepared->surfaces[spot->surface])
            return is_on_screen(hunt, at);
    }
    return false;
}

/* Brings a point that rounding left beyond the edges of screen and region back to them. */
static void clip(const struct lx_hunt *hunt, double at[2])
{
    const struct lx_screen *screen = &hunt->prepared->scene->screen;
    const double half[2] = {screen->width_mm / 2, screen->height_mm / 2};
    for (int i = 0; i < 2; i++) {
        at[i] = fmin(fmax(at[i], -half[i]), half[i]);
        if (!hunt->region || hunt->region->type != LUXEL_REGION_RECTANGLE)
            continue;
        double middle = hunt->region->center_mm[i], reach = hunt->region->size_mm[i] / 2;
        at[i] = fmin(fmax(at[i], middle - reach), middle + reach);
    }
}

/* What is truly found at a spot; false: it is not seen, or has no value. */
static bool look_at(struct lx_hunt *hunt, const struct lx_spot *spot, luxel_peak *peak)
{
    double place[3], normal[3], inside[3], at[2];
    luxel_value found;
    if (is_near_limb(hunt, spot, inside)) {
        if (!find_on_screen(hunt, spot, inside, at))
            return false;
        const struct lx_element element = lx_spot_element(hunt, spot);
        found = lx_evaluate_element(hunt->evaluator, &element, NULL);
    } else {
        lx_spot_place(hunt, spot, place, normal);
        if (!lx_screen_of(hunt, place, at))
            return false;
        clip(hunt, at);
        found = luxel_evaluate(hunt->evaluator, at[0], at[1], NULL);
    }
    if (!found.on_surface || lx_prepared_index(hunt->prepared, found.surface, found.part) != spot->surface ||
        !found.has_value || !is_on_screen(hunt, at))
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
static bool way_off(const struct lx_hunt *hunt, const struct lx_climb *climb, const struct lx_chart *chart,
                    double off[2])
{
    off[0] = off[1] = 0;
    for (unsigned i = 0; i < climb->active_count; i++) {
        double inward[2];
        if (!lx_brink_inward(hunt, climb->active[i], &climb->at, chart, inward))
            return false;
        off[0] += inward[0], off[1] += inward[1];
    }
    double length = hypot(off[0], off[1]);
    off[0] /= length, off[1] /= length;
    return length > 0;
}

static luxel_peak_place place_of(const struct lx_hunt *hunt, const struct lx_climb *climb)
{
    luxel_peak_place place = LUXEL_PEAK_INSIDE;
    for (unsigned i = 0; i < climb->active_count; i++) {
        const struct lx_brink *edge = &hunt->brinks[climb->active[i]];
        bool border = edge->type == LX_BRINK_SCREEN || edge->type == LX_BRINK_REGION;
        luxel_peak_place one = border ? LUXEL_PEAK_BORDER : lx_brink_is_wall(edge) ? LUXEL_PEAK_LIMB : LUXEL_PEAK_JUMP;
        if (place == LUXEL_PEAK_INSIDE || one == LUXEL_PEAK_BORDER ||
            (one == LUXEL_PEAK_LIMB && place == LUXEL_PEAK_JUMP))
            place = one;
    }
    return place;
}

/* Whether a peak lies in a part of one value, or on its edge. */
static bool is_plateau(struct lx_hunt *hunt, const struct lx_climb *climb, const luxel_peak *peak)
{
    struct lx_chart chart = lx_spot_chart(hunt, &climb->at);
    double reach_mm = fmin(hunt->pixel_mm, lx_spot_shape(hunt, &climb->at)->radius_mm) / 8;
    int alike = 0, others = 0;
    for (int i = 0; i < 8 && others < 5; i++) {
        double turn = M_PI * i / 4 + 0.1;
        struct lx_spot spot =
            lx_spot_moved(hunt, &climb->at, &chart, (double[]){reach_mm * cos(turn), reach_mm * sin(turn)});
        luxel_peak beside;
        if (!look_at(hunt, &spot, &beside))
            continue;
        if (beside.value == peak->value)
            alike++;
        else
            others++;
    }
    return alike > 2 || (alike > 0 && others == 0);
}

/* Where a climb ended, or a little off the edges there. */
static bool look_off(struct lx_hunt *hunt, const struct lx_climb *climb, const struct lx_chart *chart,
                     const double off[2], double step_mm, luxel_peak *peak)
{
    struct lx_spot spot = climb->at;
    if (step_mm > 0)
        spot = lx_spot_moved(hunt, &climb->at, chart, (double[]){step_mm * off[0], step_mm * off[1]});
    return look_at(hunt, &spot, peak);
}

/* Whether a peak gives what the climb promised, beyond doubt of the side of an edge on which it lies. */
static bool is_enough(const struct lx_hunt *hunt, const struct lx_climb *climb, const luxel_peak *peak)
{
    double promised = climb->value - fmax(NEAR, climb->noise) * fabs(climb->value);
    return hunt->sign * peak->value >= promised && peak->error <= 1e-9 * fabs(peak->value) + DBL_MIN;
}

/*
 * The peak of a summit.  Where the function jumps, or another surface begins, the edge may belong to the other side:
 * then the nearest place that does not, found by growing steps off the edge, and by halving the last.
 */
static bool find_peak(struct lx_hunt *hunt, const struct lx_climb *climb, luxel_peak *peak)
{
    struct lx_chart chart = lx_spot_chart(hunt, &climb->at);
    double off[2] = {0, 0}, size_mm = lx_spot_shape(hunt, &climb->at)->radius_mm, bad_mm = 0, good_mm = 0;
    luxel_peak trial;
    bool found = look_off(hunt, climb, &chart, off, 0, peak);
    if ((found && is_enough(hunt, climb, peak)) || climb->active_count == 0 || !way_off(hunt, climb, &chart, off))
        return found;
    for (double step_mm = 1e-15 * size_mm; step_mm <= 1e-7 * size_mm; step_mm *= 2) {
        if (!look_off(hunt, climb, &chart, off, step_mm, &trial))
            continue;
        bool enough = is_enough(hunt, climb, &trial);
        if (enough || !found || hunt->sign * (trial.value - peak->value) > 0)
            *peak = trial, good_mm = step_mm, bad_mm = step_mm / 2;
        found = true;
        if (enough)
            return true;
    }
    for (int i = 0; i < 20 && found && good_mm > 0 && !is_enough(hunt, climb, peak); i++) {
        double middle_mm = (bad_mm + good_mm) / 2;
        if (look_off(hunt, climb, &chart, off, middle_mm, &trial) && hunt->sign * (trial.value - peak->value) > 0)
            *peak = trial, good_mm = middle_mm;
        else
            bad_mm = middle_mm;
    }
    return found;
}

/* The least that there can be: what comes from everywhere.  Nothing lower need be looked for. */
static bool is_least(const struct lx_hunt *hunt, const luxel_peak *peak)
{
    double least = 0;
    const struct lx_emitters *emitters = &hunt->prepared->emitters;
    const struct lx_lobe *lobe =
        &hunt->prepared->surfaces[lx_prepared_index(hunt->prepared, peak->surface, peak->part)].lobe;
    for (size_t i = 0; i < lx_item_count(emitters); i++)
        if (lx_is_uniform(&emitters->items[i]))
            least += (hunt->evaluator->settings.quantity == LUXEL_IRRADIANCE ? 1 : lobe->ambient.value) *
                     emitters->items[i].strength;
    return hunt->sign < 0 && hunt->prepared->surface_count == 1 ? peak->value <= least : peak->value <= 0;
}

static bool make_peak(struct lx_hunt *hunt, const struct lx_climb *climb, luxel_peak *peak)
{
    if (!find_peak(hunt, climb, peak))
        return false;
    peak->place = place_of(hunt, climb);
    bool smooth = peak->place == LUXEL_PEAK_INSIDE || peak->place == LUXEL_PEAK_JUMP;
    if ((!smooth || climb->flat || is_least(hunt, peak)) && is_plateau(hunt, climb, peak))
        peak->place = LUXEL_PEAK_PLATEAU;
    return true;
}

/* -- the search -- */

static bool keep_summit(struct lx_hunt *hunt, const struct lx_climb *climb)
{
    if (lx_reserve(&hunt->summits, &hunt->summit_capacity, hunt->summit_count + 1, sizeof *hunt->summits)) {
        hunt->short_of_memory = true;
        return false;
    }
    hunt->summits[hunt->summit_count++] = (struct lx_summit){climb->at, climb->value, climb->length_mm};
    return true;
}

/* Whether a costly climb may be spared, since it begins on the hill of a summit that is known. */
static bool is_on_known_hill(const struct lx_hunt *hunt, const struct lx_seed *seed)
{
    double here[3], there[3], normal[3];
    lx_spot_place(hunt, &seed->spot, here, normal);
    for (size_t i = 0; hunt->costly && i < hunt->summit_count; i++) {
        const struct lx_summit *summit = &hunt->summits[i];
        if (summit->spot.surface != seed->spot.surface || seed->value - seed->margin > summit->value)
            continue;
        lx_spot_place(hunt, &summit->spot, there, normal);
        double apart = hypot(hypot(here[0] - there[0], here[1] - there[1]), here[2] - there[2]);
        if (apart <= fmax(4 * hunt->pixel_mm, summit->length_mm / 2))
            return true;
    }
    return false;
}

/* One climb; the peak at its end replaces *best if it is better. */
static void climb_from(struct lx_hunt *hunt, const struct lx_seed *seed, luxel_peak *best)
{
    struct lx_climb climb = {.at = seed->spot, .trust_mm = hunt->pixel_mm, .length_mm = hunt->pixel_mm};
    if (!lx_brinks_enter(hunt, &climb.at))
        return;
    lx_climb_up(hunt, &climb);
    if (climb.known || !isfinite(climb.value) || !keep_summit(hunt, &climb))
        return;
    luxel_peak peak;
    if (best->exists && climb.value < hunt->sign * best->value)
        return;
    if (make_peak(hunt, &climb, &peak) && (!best->exists || hunt->sign * (peak.value - best->value) > 0))
        *best = peak;
}

static void search(struct lx_hunt *hunt, const struct lx_seeds *seeds, luxel_peak *best)
{
    size_t climbs = 0, most = hunt->costly ? MOST_CLIMBS_COSTLY : MOST_CLIMBS;
    for (size_t i = 0; i < seeds->count && climbs < most && lx_hunt_goes_on(hunt); i++) {
        const struct lx_seed *seed = &seeds->items[i];
        if (best->exists && seed->value + seed->margin <= hunt->sign * best->value)
            continue;
        if (is_on_known_hill(hunt, seed))
            continue;
        climb_from(hunt, seed, best);
        climbs++;
        atomic_fetch_add(&hunt->control.rows_done, 1);
        if (best->exists && hunt->sign < 0 && is_least(hunt, best))
            break;
    }
}

static double size_of(const double place_mm[3])
{
    return sqrt(lx_dot(place_mm, place_mm));
}

static void set_scales(struct lx_hunt *hunt, const luxel_field *field)
{
    const struct lx_scene_parameters *scene = hunt->prepared->scene;
    hunt->scale_mm = fmax(scene->screen.width_mm, scene->screen.height_mm);
    const struct lx_camera *camera = &hunt->prepared->camera;
    if (camera->is_perspective)
        hunt->scale_mm = fmax(hunt->scale_mm, fmax(fabs(camera->z_mm), size_of(camera->position_mm)));
    if (!camera->frame.is_own)
        hunt->scale_mm = fmax(hunt->scale_mm, size_of(camera->frame.origin_mm));
    for (size_t i = 0; i < hunt->prepared->surface_count; i++) {
        const struct lx_shape *shape = &hunt->prepared->surfaces[i].shape;
        double reach = size_of(shape->anchor_mm) + shape->radius_mm;
        hunt->scale_mm = fmax(hunt->scale_mm, reach);
    }
    hunt->pixel_mm = scene->screen.width_mm / field->columns;
}

static bool make_gates(struct lx_hunt *hunt)
{
    hunt->gates = lx_new_array(hunt->prepared->surface_count, sizeof *hunt->gates);
    for (size_t i = 0; hunt->gates && i < hunt->prepared->surface_count; i++) {
        struct lx_gates *gates = &hunt->gates[i];
        gates->open = gates->shut = hunt->prepared->surfaces[i].lobe;
        gates->open.highlight = LX_HIGHLIGHT_PLAIN;
        gates->shut.specular = lx_exact(0);
    }
    return hunt->gates;
}

/* Whether the lights can be looked at one by one, and whether their values need integrals. */
static void judge_lights(struct lx_hunt *hunt)
{
    const struct lx_emitters *emitters = &hunt->prepared->emitters;
    bool is_irradiance = hunt->evaluator->settings.quantity == LUXEL_IRRADIANCE, shines = false;
    size_t narrow = 0;
    for (size_t i = 0; i < hunt->prepared->surface_count; i++)
        shines = shines || hunt->prepared->surfaces[i].lobe.specular.value > 0;
    for (size_t i = 0; i < emitters->count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        const bool is_hidden = hunt->prepared->shadows && hunt->prepared->shadows_extended;
        bool closed = lx_has_closed_form(emitter) && (is_irradiance || !shines) && !is_hidden;
        hunt->costly = hunt->costly || (lx_is_extended(emitter) && !closed);
        narrow += lx_has_one_way(emitter);
    }
    hunt->knows_lights = narrow <= MOST_EDGE_LIGHTS && narrow * hunt->prepared->surface_count <= MOST_EDGES;
    hunt->costly = hunt->costly || emitters->count > MOST_EDGE_LIGHTS;
}

static bool are_walkable(const struct lx_prepared *prepared)
{
    for (size_t i = 0; i < prepared->surface_count; i++)
        if (!lx_shape_is_walkable(&prepared->surfaces[i].shape))
            return false;
    return true;
}

static luxel_status hunt_for(const luxel_evaluator *evaluator, const luxel_field *field, const luxel_region *region,
                             double sign, luxel_diagnostics *diagnostics, luxel_peak *peak)
{
    struct lx_hunt hunt = {
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
        atomic_store(&hunt.control.rows_done, MOST_CLIMBS + 1);
    judge_lights(&hunt);
    set_scales(&hunt, field);
    if (hunt.costly)
        hunt.quick.tolerance = fmax(COARSE, hunt.quick.tolerance);
    hunt.bare.shadows = hunt.bare.shadows && !hunt.knows_lights; /* penumbrae stay */
    *peak = (luxel_peak){.exists = false};
    hunt.short_of_memory = !make_gates(&hunt);
    if (evaluator->world.reflected || !are_walkable(hunt.prepared))
        lx_hunt_plainly(&hunt, field, peak);
    else if (!hunt.short_of_memory && lx_hunt_seeds(&hunt, field, &seeds))
        search(&hunt, &seeds, peak);
    free(seeds.items);
    free(hunt.gates);
    free(hunt.brinks);
    free(hunt.sides);
    free(hunt.summits);
    if (hunt.short_of_memory)
        return lx_out_of_memory(diagnostics);
    return hunt.stopped ? LUXEL_CANCELLED : LUXEL_OK;
}

static luxel_status check(const luxel_evaluator *evaluator, const luxel_field *field, const luxel_region *region,
                          const luxel_extrema *extrema, luxel_diagnostics *diagnostics)
{
    const char *missing = !evaluator ? "evaluator" : !field ? "field" : !extrema ? "extrema" : NULL;
    if (missing) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_MISSING_ARGUMENT, LX_ARGS(missing));
        return LUXEL_ERROR_ARGUMENT;
    }
    const struct lx_screen *screen = &evaluator->prepared.scene->screen;
    unsigned columns = screen->resolution[0], rows = screen->resolution[1];
    bool fits = field->columns == columns && field->rows == rows && field->x_mm && field->y_mm &&
                field->quantity == evaluator->settings.quantity;
    for (unsigned i = 0; fits && i < columns; i++)
        fits = field->x_mm[i] == lx_column_x_mm(screen, i);
    for (unsigned i = 0; fits && i < rows; i++)
        fits = field->y_mm[i] == lx_row_y_mm(screen, i);
    if (!fits) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FOREIGN_FIELD, NULL);
        return LUXEL_ERROR_ARGUMENT;
    }
    return lx_region_check(region, diagnostics);
}

luxel_status luxel_find_extrema(const luxel_evaluator *evaluator, const luxel_field *field, const luxel_region *region,
                                luxel_diagnostics *diagnostics, luxel_extrema *extrema)
{
    luxel_status status = check(evaluator, field, region, extrema, diagnostics);
    if (status != LUXEL_OK)
        return status;
    luxel_extrema found;
    status = hunt_for(evaluator, field, region, 1, diagnostics, &found.maximum);
    if (status == LUXEL_OK)
        status = hunt_for(evaluator, field, region, -1, diagnostics, &found.minimum);
    if (status == LUXEL_OK)
        *extrema = found;
    return status;
}

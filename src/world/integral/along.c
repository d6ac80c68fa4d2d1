/* SPDX-License-Identifier: MIT */
/* The integrand, its borders and peaks on an arc, and the integral along it. */
#include <math.h>
#include <stdlib.h>

#include "../../base/larger.h"
#include "../../base/memory.h"
#include "../../light/sky/luminance.h"
#include "../../light/solid/extended.h"
#include "../../surface/pane.h"
#include "along.h"

enum { INNER_PANELS = 256, INNER_PANELS_OF_TABLE = INNER_PANELS + 2 * MOST_LINES };

/* Cuts nearer to each other than this are the same one. */
static const double NARROWEST = 1e-14;

/* The least incidence at a ball's rim, where arcs end and what is integrated grows like its inverse; nothing is summed
 * there. */
static const double LEAST_INCIDENCE = 1e-9;

/* Work that is never exceeded; what was reached by then is told by the error. */
static const size_t MOST_PARTS = 4000000;

/* Values are relative to the top; where one is found that is higher by this (a logarithm), all begins anew. */
static const double HIGHEST = 100;

/* ---- the integrand ---- */

/* The logarithm of the lobe towards L, and the relative error that it brings along; -HUGE_VAL where it is 0. */
static double lobe_log(const struct lx_problem *problem, const double towards[3], double distance_mm, double *error)
{
    return lx_lobe_log(problem->lobe, &problem->at, towards, problem->place_error_mm / distance_mm, error);
}

/*
 * What a part of an opening is: the area dA = r^2 dw/cos(incidence) of it, with the distribution in this direction.
 * Returns the factor of the integrand; *error: absolute, as turns of the direction change it, which is all that a
 * moved place does.
 */
static double opening_at(struct lx_problem *problem, const double towards[3], double tau, double distance_mm,
                         double incidence, double moved, double *error)
{
    const struct lx_pointed *luminaire = problem->emitter->profile.luminaire;
    double area = 1 / fmax(incidence, DBL_MIN);
    if (!lx_has_axis(problem->emitter)) {
        const enum lx_sweep_wall wall = problem->sweep->wall;
        double incidences[2];
        const double far = lx_sweep_far(problem->sweep, &problem->arc, tau, incidences);
        area = 1 / fmax(incidences[wall == LX_FAR_WALL], LEAST_INCIDENCE);
        if (wall == LX_BOTH_WALLS) /* the weight is for the distance of the near side */
            area += lx_relative_law(problem->emitter, far) / lx_relative_law(problem->emitter, distance_mm) /
                    fmax(incidences[1], LEAST_INCIDENCE);
    }
    *error = area * (lx_pointed_slope(luminaire) * (moved + 8 * DBL_EPSILON) + 16 * DBL_EPSILON);
    return area * lx_pointed_near(luminaire, towards, &problem->kept);
}

/* What is integrated at tau: f r^2 a cos(tau), relative to exp(top). */
static struct lx_point_value value_at(struct lx_problem *problem, double tau)
{
    double cos_tau = cos(tau), sin_tau = sin(tau), towards[3], incidence;
    for (int i = 0; i < 3; i++)
        towards[i] = problem->arc.direction[i] * cos_tau + problem->sweep->frame.z[i] * sin_tau;
    double distance = lx_sweep_distance(problem->sweep, &problem->arc, cos_tau, sin_tau, &incidence);
    double cosine = lx_dot_plain(problem->at.normal, towards),
           weight = lx_relative_law(problem->emitter, distance) * cos_tau;
    double moved = problem->place_error_mm / distance, error = 16 * DBL_EPSILON + 4 * moved;
    const bool is_opening = lx_is_opening(problem->emitter);
    if (moved > 0 && !is_opening)
        error += fmin(moved / incidence, 1);
    if (problem->emitter->sky) {
        weight *= lx_sky_luminance(problem->emitter->sky, towards);
        error += LX_SKY_ROUNDING;
    }
    if (problem->emitter->pane_count > 0) {
        const struct lx_emitter *emitter = problem->emitter;
        const double way[3] = {distance * towards[0], distance * towards[1], distance * towards[2]};
        weight *= lx_panes_pass(emitter->panes, emitter->pane_count, emitter->through, problem->place_mm, way, false);
        error += LX_PANE_ROUNDING;
    }
    double opening = 1, opening_error = 0;
    if (is_opening)
        opening = opening_at(problem, towards, tau, distance, incidence, moved, &opening_error);
    double log_value = 0, turned = problem->at.normal_error + moved + DBL_EPSILON;
    problem->parts++;
    if (problem->lobe) {
        double lobe_error = 0;
        log_value = lobe_log(problem, towards, distance, &lobe_error);
        if (!(log_value > -HUGE_VAL))
            return (struct lx_point_value){.value = 0};
        error += lobe_error;
        problem->highest = fmax(problem->highest, log_value);
        weight *= exp(fmin(log_value - problem->top, HIGHEST));
        if (LX_FALLS_TO_HORIZON(problem->lobe->highlight))
            error *= fmax(cosine, 0), error += turned;
    } else {
        error = error * fmax(cosine, 0) + turned;
    }
    bool by_cosine = !problem->lobe || LX_FALLS_TO_HORIZON(problem->lobe->highlight);
    double value = by_cosine ? weight * fmax(cosine, 0) : weight;
    return (struct lx_point_value){.value = value * opening, .error = weight * error * opening + value * opening_error};
}

/* ---- one arc ---- */

static double ease(double t)
{
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

/* The t for a value of ease(). */
static double uneased(double value)
{
    enum { STEPS = 40 };
    double low = 0, high = 1;
    for (int i = 0; i < STEPS; i++)
        *(ease((low + high) / 2) < value ? &low : &high) = (low + high) / 2;
    return (low + high) / 2;
}

static double ease_slope(double t)
{
    return 30 * t * t * (1 - t) * (1 - t);
}

/* On the arc, g.L = amplitude cos(tau - peak). */
void lx_along_arc(const struct lx_border *border, const struct lx_sweep *sweep, const struct lx_arc *arc,
                  double *amplitude, double *peak)
{
    double a = lx_dot_plain(border->g, arc->direction), b = lx_dot_plain(border->g, sweep->frame.z);
    *amplitude = hypot(a, b);
    *peak = atan2(b, a);
}

/* Keeps of the intervals what lies within `half` of the peak, modulo a full turn; whole or not at all where an arc is
 * so short that its ends are the same number. */
static size_t cut_intervals(struct lx_arc_stretch *intervals, size_t count, double peak, double half)
{
    struct lx_arc_stretch kept[MOST_INTERVALS];
    size_t found = 0;
    for (size_t i = 0; i < count; i++)
        for (int turn = -1; turn <= 1; turn++) {
            double from = fmax(intervals[i].from, peak - half + turn * 2 * M_PI);
            double to = fmin(intervals[i].to, peak + half + turn * 2 * M_PI);
            bool eased = intervals[i].eased || from > intervals[i].from || to < intervals[i].to;
            bool is_kept = from < to || (from == to && intervals[i].from == intervals[i].to);
            if (is_kept && found < MOST_INTERVALS)
                kept[found++] = (struct lx_arc_stretch){from, to, eased};
        }
    for (size_t i = 0; i < found; i++)
        intervals[i] = kept[i];
    return found;
}

/* The parts of an arc where all conditions hold. */
static size_t find_intervals(struct lx_problem *problem, const struct lx_sweep *sweep, const struct lx_arc *arc,
                             struct lx_arc_stretch intervals[MOST_INTERVALS])
{
    size_t count = arc->width > 0;
    intervals[0] = (struct lx_arc_stretch){arc->from, arc->from + arc->width, false};
    for (size_t i = 0; i < problem->condition_count; i++) {
        double amplitude, peak, limit = problem->conditions[i].limit;
        lx_along_arc(&problem->conditions[i], sweep, arc, &amplitude, &peak);
        if (limit >= amplitude)
            return 0;
        if (limit > -amplitude)
            count = cut_intervals(intervals, count, peak, acos(limit / amplitude));
    }
    return count;
}

/* What the light is at the ends of a hidden part, times how far they may be off: those within a stretch, and those so
 * near to it that they may be within it. */
static double doubt_of(struct lx_problem *problem, const struct lx_hidden *hidden, const struct lx_arc_stretch *stretch)
{
    double doubt = 0;
    for (int end = 0; end < 2; end++) {
        const double slack = fmin(hidden->slack[end], problem->arc.width);
        const double at = fmax(stretch->from, fmin(hidden->ends[end], stretch->to));
        if (fabs(hidden->ends[end] - at) < slack)
            doubt += value_at(problem, at).value * slack;
    }
    return doubt;
}

/* What the rounding of its ends, as angles, does to what is seen of an arc. */
static double rounding_of(struct lx_problem *problem, const struct lx_arc_stretch *seen)
{
    return 4 * DBL_EPSILON * value_at(problem, seen->from + (seen->to - seen->from) / 2).value;
}

/*
 * Takes the hidden parts of the arc out of its intervals; returns how many are left.  Whose the ends of what is left
 * are is the form of the arc; what is in doubt of them is looked up where `doubts` says so.
 */
static size_t take_hidden(struct lx_problem *problem, size_t count, bool doubts)
{
    problem->intervals = problem->whole;
    problem->doubt = 0;
    problem->form = 0;
    if (!lx_is_occluded(problem->occlusion) || count == 0)
        return count;
    const struct lx_hidden *hidden = problem->occlusion->hidden;
    const size_t hidden_count = lx_occlusion_hide(problem->occlusion, problem->sweep, &problem->arc);
    size_t left = 0;
    for (size_t i = 0; i < count; i++) {
        struct lx_arc_stretch rest = problem->whole[i];
        const double end = rest.to;
        uint64_t began_by = 0;
        for (size_t k = 0; k < hidden_count; k++) {
            problem->doubt += doubts ? doubt_of(problem, &hidden[k], &problem->whole[i]) : 0;
            if (hidden[k].ends[1] <= rest.from || hidden[k].ends[0] >= end)
                continue;
            rest.to = hidden[k].ends[0];
            if (rest.to > rest.from) {
                problem->room[left++] = rest;
                problem->doubt += doubts ? rounding_of(problem, &rest) : 0;
                problem->form = lx_mixed_form(lx_mixed_form(problem->form, began_by), hidden[k].bounds[0]);
            }
            rest.from = hidden[k].ends[1];
            began_by = hidden[k].bounds[1];
        }
        rest.to = end;
        if (rest.from < end) {
            problem->room[left++] = rest;
            problem->doubt += doubts ? rounding_of(problem, &rest) : 0;
            problem->form = lx_mixed_form(lx_mixed_form(problem->form, began_by), 0);
        }
    }
    problem->intervals = problem->room;
    return left;
}

int lx_make_room_on_arcs(struct lx_problem *problem)
{
    problem->intervals = problem->whole;
    problem->room_count = MOST_INTERVALS + problem->occlusion->most_hidden;
    const bool is_integrated = problem->lobe || !lx_has_closed_form(problem->emitter);
    problem->panel_count = INNER_PANELS + problem->room_count * (MOST_PLACES + 1);
    problem->panel_count += lx_is_opening(problem->emitter) ? 2 * MOST_LINES : 0;
    problem->room = lx_new_array(problem->room_count, sizeof *problem->room);
    problem->panels = is_integrated ? lx_new_array(problem->panel_count, sizeof *problem->panels) : NULL;
    return problem->room && (problem->panels || !is_integrated) ? 0 : -1;
}

/* The variable along an arc: tau as an offset from the arc's start; of a round arc the angle whose sine tau is. */
static double to_variable(const struct lx_arc *arc, double tau)
{
    return arc->round ? asin(fmax(-1, fmin(1, 2 * (tau - arc->from) / arc->width - 1))) : tau - arc->from;
}

static struct lx_point_value along(void *data, size_t index, double t)
{
    struct lx_problem *problem = data;
    const struct lx_arc *arc = &problem->arc;
    const struct lx_arc_stretch *interval = &problem->intervals[index];
    double length = interval->to - interval->from;
    double x = interval->from + length * (interval->eased ? ease(t) : t);
    double slope = length * (interval->eased ? ease_slope(t) : 1);
    double tau = arc->from + (arc->round ? arc->width / 2 * (1 + sin(x)) : x);
    if (arc->round)
        slope *= arc->width / 2 * cos(x);
    struct lx_point_value point = value_at(problem, tau);
    point.value *= slope;
    point.error *= slope;
    return point;
}

bool lx_outgrew_top(const struct lx_problem *problem)
{
    return problem->highest > problem->top + HIGHEST;
}

bool lx_goes_on(struct lx_problem *problem)
{
    problem->is_stopped = problem->is_stopped || !lx_asking_goes_on(problem->asking);
    return !problem->is_stopped && problem->parts < MOST_PARTS && !lx_outgrew_top(problem);
}

/* Nothing is gained by estimates smaller than the error that places and roundings bring. */
static double arc_target(void *data, const struct lx_integral *integral)
{
    struct lx_problem *problem = data;
    double wanted = fmax(problem->wanted, 0.1 * problem->tolerance * integral->value);
    return lx_goes_on(problem) ? fmax(wanted, integral->inherited) : HUGE_VAL;
}

/* Where the lobe may have peaks on the arc, and has kinks. */
static size_t find_places(const struct lx_problem *problem, const struct lx_arc *arc, double places[MOST_PLACES])
{
    if (!problem->lobe)
        return 0;
    size_t count = lx_lobe_peaks(problem->lobe, &problem->at, arc->direction, problem->sweep->frame.z, places);
    for (size_t i = 0; i < problem->kink_count; i++) {
        double amplitude, peak;
        lx_along_arc(&problem->kinks[i], problem->sweep, arc, &amplitude, &peak);
        if (!(fabs(problem->kinks[i].limit) < amplitude))
            continue;
        places[count++] = peak - acos(problem->kinks[i].limit / amplitude);
        places[count++] = peak + acos(problem->kinks[i].limit / amplitude);
    }
    return count;
}

/* The panels of each interval; true: between their ends the integrand is analytic and has no peaks. */
static bool start_panels(const struct lx_problem *problem, size_t count, struct lx_panels *panels)
{
    double places[MOST_PLACES + MOST_LINES], cuts[MOST_PLACES + MOST_LINES + 1];
    size_t place_count = find_places(problem, &problem->arc, places);
    for (size_t i = 0; i < problem->line_count; i++)
        places[place_count++] = problem->lines[i].tau;
    for (size_t i = 0; i < count; i++) {
        const struct lx_arc_stretch *interval = &problem->intervals[i];
        size_t cut_count = 0;
        for (size_t k = 0; k < place_count; k++) {
            double share = (to_variable(&problem->arc, places[k]) - interval->from) / (interval->to - interval->from);
            if (share > 0 && share < 1)
                cuts[cut_count++] = interval->eased ? uneased(share) : share;
        }
        cuts[cut_count++] = 1;
        qsort(cuts, cut_count, sizeof *cuts, lx_by_value);
        double from = 0;
        for (size_t k = 0; k < cut_count; k++) {
            if (cuts[k] - from > NARROWEST)
                panels->items[panels->count++] = (struct lx_panel){.interval = i, .from = from, .to = cuts[k]};
            from = cuts[k];
        }
    }
    return lx_is_opening(problem->emitter) && !problem->lobe && problem->line_count < MOST_LINES && !problem->arc.round;
}

/* Where lines of a luminaire's table cross the arc; which ones do belongs to its form. */
static void find_lines(struct lx_problem *problem)
{
    struct lx_pointed_arc arc = {.from = problem->arc.from, .width = problem->arc.width};
    problem->line_count = 0;
    if (!lx_is_opening(problem->emitter))
        return;
    for (int i = 0; i < 3; i++) {
        arc.direction[i] = problem->arc.direction[i];
        arc.pole[i] = problem->sweep->frame.z[i];
    }
    problem->line_count = lx_pointed_crossings(problem->emitter->profile.luminaire, &arc, MOST_LINES, problem->lines);
    for (size_t i = 0; i < problem->line_count; i++)
        problem->form = lx_mixed_form(problem->form, problem->lines[i].line);
}

/* Goes to the arc at x of a sweep, and returns how many of its parts are seen. */
static size_t go_to_arc_at(struct lx_problem *problem, const struct lx_sweep *sweep, double x, bool doubts)
{
    problem->sweep = sweep;
    problem->arc = lx_sweep_arc(sweep, x);
    const size_t count = take_hidden(problem, find_intervals(problem, sweep, &problem->arc, problem->whole), doubts);
    if (count > 0)
        find_lines(problem);
    return count;
}

/* Goes to the arc at t of a piece, and returns how many of its parts are seen; *slope: of the whole measure by t. */
static size_t go_to_arc(struct lx_problem *problem, size_t index, double t, bool doubts, double *slope)
{
    const struct lx_piece *piece = &problem->pieces[index];
    const double length = piece->range.to - piece->range.from;
    const double x = piece->range.from + length * (piece->range.eased ? ease(t) : t);
    const size_t count = go_to_arc_at(problem, &problem->sweeps->items[piece->sweep], x, doubts);
    *slope = problem->arc.measure * length * (piece->range.eased ? ease_slope(t) : 1);
    return count;
}

/* The integral of cos(tau) N.L over an interval, N.L = a cos(tau) + b sin(tau). */
static struct lx_point_value cosine_along(const struct lx_problem *problem, const struct lx_arc_stretch *interval)
{
    const double a = lx_dot_plain(problem->at.normal, problem->arc.direction);
    const double b = lx_dot_plain(problem->at.normal, problem->sweep->frame.z);
    const double width = interval->to - interval->from, sum = interval->to + interval->from, sine = sin(width);
    const double moved = problem->at.normal_error + problem->place_error_mm / problem->arc.distance_mm;
    return (struct lx_point_value){
        .value = fmax((a * (width + cos(sum) * sine) + b * sin(sum) * sine) / 2, 0),
        .error = (fabs(a) + fabs(b)) * width * (8 * DBL_EPSILON + 4 * moved) + 4 * DBL_EPSILON * fabs(sum),
    };
}

static bool is_closed_along(const struct lx_problem *problem)
{
    return lx_is_occluded(problem->occlusion) && !problem->lobe && lx_has_closed_form(problem->emitter);
}

/* Adaptively, over all intervals. */
static struct lx_point_value integrate_along(struct lx_problem *problem, size_t count, double slope)
{
    const struct lx_arc *arc = &problem->arc;
    struct lx_arc_stretch *intervals = problem->intervals;
    struct lx_panel memory[INNER_PANELS_OF_TABLE];
    struct lx_panels panels = {memory, 0, lx_is_opening(problem->emitter) ? INNER_PANELS_OF_TABLE : INNER_PANELS};
    if (lx_is_occluded(problem->occlusion))
        panels = (struct lx_panels){problem->panels, 0, problem->panel_count};
    for (size_t i = 0; i < count; i++) {
        if (intervals[i].eased && problem->lobe && LX_JUMPS_AT_HORIZON(problem->lobe->highlight)) {
            double ends = fmax(value_at(problem, intervals[i].from).value, value_at(problem, intervals[i].to).value);
            problem->at_border = fmax(problem->at_border, ends);
        }
        bool whole = intervals == problem->whole && !intervals[i].eased && !arc->round;
        intervals[i].from = whole ? 0 : to_variable(arc, intervals[i].from);
        intervals[i].to = whole ? arc->width : to_variable(arc, intervals[i].to);
    }
    const bool is_smooth = start_panels(problem, count, &panels);
    double share = 0.1 * problem->tolerance * (problem->known + problem->running);
    problem->wanted = slope > 0 ? share / (double)problem->piece_count / slope : 0;
    struct lx_integrand integrand = {
        .at = along, .target = arc_target, .data = problem, .is_smooth = is_smooth, .is_coarse = problem->is_coarse};
    struct lx_integral integral = lx_integrate_panels(&integrand, &panels);
    return (struct lx_point_value){.value = integral.value, .error = integral.error + integral.inherited};
}

/* The integral along the parts of the arc that are seen; `slope`: what it is to be multiplied by. */
static struct lx_point_value sum_along(struct lx_problem *problem, size_t count, double slope)
{
    struct lx_point_value sum = {.value = 0};
    if (!is_closed_along(problem))
        return integrate_along(problem, count, slope);
    for (size_t i = 0; i < count; i++) {
        const struct lx_point_value part = cosine_along(problem, &problem->intervals[i]);
        sum.value += part.value;
        sum.error += part.error;
    }
    problem->parts++;
    return sum;
}

double lx_light_along(struct lx_problem *problem, const struct lx_sweep *sweep, double x, bool is_free)
{
    struct lx_occlusion *occlusion = problem->occlusion;
    problem->occlusion = is_free ? NULL : occlusion;
    const size_t count = go_to_arc_at(problem, sweep, x, false);
    const double light = sum_along(problem, count, problem->arc.measure).value;
    problem->occlusion = occlusion;
    return light;
}

/* The integral along the arc at x, times the sweep's measure. */
struct lx_point_value lx_integrate_arc(void *data, size_t index, double t)
{
    struct lx_problem *problem = data;
    if (problem->is_stopped)
        return (struct lx_point_value){.value = 0};
    double slope;
    const size_t count = go_to_arc(problem, index, t, true, &slope);
    struct lx_point_value sum = sum_along(problem, count, slope);
    if (sum.value <= problem->doubt) /* what is seen may well be rounding, in which no peak is to be looked for */
        sum = (struct lx_point_value){.value = 0, .error = sum.value + sum.error};
    return (struct lx_point_value){
        .value = sum.value * slope,
        .error = (sum.error + problem->doubt) * slope,
        .form = problem->form,
    };
}

uint64_t lx_form_of_arc(void *data, size_t index, double t)
{
    struct lx_problem *problem = data;
    double slope;
    go_to_arc(problem, index, t, false, &slope);
    return problem->form;
}

/* Looks how great the lobe gets on the arc at x. */
void lx_look_at(struct lx_problem *problem, const struct lx_sweep *sweep, double x)
{
    enum { STEPS = 4 };
    problem->sweep = sweep;
    problem->arc = lx_sweep_arc(sweep, x);
    const struct lx_arc *arc = &problem->arc;
    size_t count = take_hidden(problem, find_intervals(problem, sweep, arc, problem->whole), false);
    double places[MOST_PLACES], unused;
    size_t place_count = find_places(problem, arc, places);
    for (size_t i = 0; i < count; i++)
        for (size_t step = 0; step <= STEPS + place_count; step++) {
            double from = problem->intervals[i].from, to = problem->intervals[i].to, towards[3];
            double tau = step > STEPS ? fmax(from, fmin(to, places[step - STEPS - 1]))
                                      : from + (to - from) * (double)step / STEPS;
            for (int j = 0; j < 3; j++)
                towards[j] = arc->direction[j] * cos(tau) + sweep->frame.z[j] * sin(tau);
            problem->top = fmax(problem->top, lobe_log(problem, towards, arc->distance_mm, &unused));
        }
}

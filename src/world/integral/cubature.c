/* SPDX-License-Identifier: MIT */
/*
 * The integrals over an extended source: cutting its sweeps where arcs change their kind, and the adaptive rule across
 * the arcs.  The longitudes at which a border of the integrand (along.h) reaches an end of the arc, or an arc begins
 * to meet it, are found before, and no panel reaches across them.
 */
#include <math.h>
#include <stdlib.h>

#include "../../base/memory.h"
#include "../../light/sky/luminance.h"
#include "../../light/solid/elliptic.h"
#include "../visibility/outline.h"
#include "along.h"
#include "cubature.h"

enum {
    OUTER_PANELS = 1024,
    SCANS = 16, /* samples in which changes of the arcs are looked for */
    MOST_CUTS = 64,
    MOST_CUTS_OF_OBSTACLES = 1024 /* beyond which the adaptive rule finds where obstacles begin */
};

/* Cuts nearer to each other than this are the same one. */
static const double NARROWEST = 1e-14;

/* From which tolerance on few points do, as pictures ask for, of what they have no samples of. */
static const double COARSE = 1e-4;

/* The rounding of a whole integral, relative: sweeps are made in float64. */
static const double ROUNDING = 1e-13;

/* A top below this vanishes among the float64 numbers, whatever comes on top of it. */
static const double INVISIBLE = -1500;

/* ---- where arcs change their kind ---- */

/* Quantities of an arc whose changes of sign are borders for the outer integral. */
enum { ENDS = 2, EXTREMES = 2, LONGITUDES = 2, APPROACHES = 1 };
enum { MARKS = (MOST_CONDITIONS + LX_MOST_KINKS) * (ENDS + EXTREMES) + LONGITUDES + APPROACHES };

/* Those of one border on an arc: at its ends, and what is greatest and least on it. */
static size_t mark_border(const struct lx_border *border, const struct lx_sweep *sweep, const struct lx_arc *arc,
                          double marks[ENDS + EXTREMES])
{
    double amplitude, peak, limit = border->limit, to = arc->from + arc->width;
    size_t m = 0;
    lx_along_arc(border, sweep, arc, &amplitude, &peak);
    double first = amplitude * cos(arc->from - peak) - limit, last = amplitude * cos(to - peak) - limit;
    double low = peak - M_PI > arc->from ? peak - M_PI : peak + M_PI;
    marks[m++] = first;
    marks[m++] = last;
    marks[m++] = peak > arc->from && peak < to ? amplitude - limit : fmax(first, last);
    marks[m++] = low > arc->from && low < to ? -amplitude - limit : fmin(first, last);
    return m;
}

static void marks_of(const struct lx_problem *problem, const struct lx_sweep *sweep, double x, double marks[MARKS])
{
    struct lx_arc arc = lx_sweep_arc(sweep, x);
    size_t m = 0;
    for (size_t i = 0; i < problem->condition_count; i++)
        m += mark_border(&problem->conditions[i], sweep, &arc, marks + m);
    for (size_t i = 0; i < problem->kink_count; i++)
        m += mark_border(&problem->kinks[i], sweep, &arc, marks + m);
    const double *special[LONGITUDES] = {problem->at.mirrored, problem->at.view};
    for (size_t i = 0; problem->lobe && i < LONGITUDES; i++) {
        const struct lx_sweep_frame *frame = &sweep->frame;
        marks[m++] = lx_dot_plain(arc.direction, frame->x) * lx_dot_plain(special[i], frame->y) -
                     lx_dot_plain(arc.direction, frame->y) * lx_dot_plain(special[i], frame->x);
    }
    marks[m++] = lx_sweep_approach(sweep, x);
    while (m < MARKS)
        marks[m++] = 1;
}

/* Whether a change of a mark is one of where an arc's parts are: not where a kink only comes over an end of it. */
static bool is_border(const struct lx_problem *problem, size_t mark)
{
    const size_t conditions = problem->condition_count * (ENDS + EXTREMES);
    const size_t kinks = conditions + problem->kink_count * (ENDS + EXTREMES);
    return mark < conditions || (mark < kinks && mark % (ENDS + EXTREMES) >= ENDS);
}

/* The place between two where a mark changes its sign. */
static double find_change(const struct lx_problem *problem, const struct lx_sweep *sweep, size_t mark, double from,
                          double to)
{
    enum { STEPS = 60 };
    double marks[MARKS];
    marks_of(problem, sweep, from, marks);
    bool positive = marks[mark] > 0;
    for (int i = 0; i < STEPS && to - from > 1e-15; i++) {
        double middle = (from + to) / 2;
        marks_of(problem, sweep, middle, marks);
        *((marks[mark] > 0) == positive ? &from : &to) = middle;
    }
    return (from + to) / 2;
}

struct cut {
    double x;
    bool border; /* of an arc's parts, not just of a quarter of the sky */
};

static int by_place(const void *a, const void *b)
{
    double x = ((const struct cut *)a)->x, y = ((const struct cut *)b)->x;
    return (x > y) - (x < y);
}

/* Where the slabs of an outline end. */
static size_t cut_at_slabs(const struct lx_problem *problem, const struct lx_sweep *sweep, struct cut *cuts)
{
    const struct lx_trapezoid_map *map = &problem->occlusion->outline->lays[sweep - problem->sweeps->items];
    size_t count = 0;
    for (size_t i = 1; i < map->slab_count; i++) {
        double towards[3];
        for (int k = 0; k < 3; k++)
            towards[k] = sweep->frame.x[k] + map->slabs[i].low * sweep->frame.y[k];
        cuts[count].border = false;
        count += lx_sweep_find(sweep, towards, &cuts[count].x);
    }
    return count;
}

/* The most of them on a sweep. */
static size_t most_slabs(const struct lx_problem *problem)
{
    size_t most = 0;
    for (size_t i = 0;
         lx_is_occluded(problem->occlusion) && problem->occlusion->has_outline && i < problem->sweeps->count; i++) {
        const size_t count = problem->occlusion->outline->lays[i].slab_count;
        most = count > most ? count : most;
    }
    return most;
}

/* Where obstacles begin and end, and where their borders and the source's cross. */
static size_t cut_at_meridians(const struct lx_problem *problem, const struct lx_sweep *sweep, struct cut *cuts)
{
    const struct lx_obstacles *obstacles = &problem->occlusion->obstacles;
    const struct lx_directions *crossings = problem->crossings;
    size_t count = 0;
    for (size_t i = 0; i < obstacles->count && count + LX_MOST_MERIDIANS <= MOST_CUTS_OF_OBSTACLES; i++) {
        double meridians[LX_MOST_MERIDIANS][3];
        bool round;
        const size_t found = lx_obstacle_meridians(&obstacles->items[i], &sweep->frame, meridians, &round);
        for (size_t k = 0; k < found; k++) {
            cuts[count].border = round;
            count += lx_sweep_find(sweep, meridians[k], &cuts[count].x);
        }
    }
    for (size_t i = 0; i < crossings->count && count < MOST_CUTS_OF_OBSTACLES; i++) {
        cuts[count].border = false;
        count += lx_sweep_find(sweep, crossings->items[i], &cuts[count].x);
    }
    return count;
}

/* Cuts a sweep where its marks change, and looks how great the lobe gets on it. */
static size_t cut_sweep(struct lx_problem *problem, const struct lx_sweep *sweep, struct cut *cuts)
{
    double before[MARKS], marks[MARKS];
    size_t count = 0;
    cuts[count++] = (struct cut){0, false};
    for (int i = 0; i <= SCANS; i++) {
        /* the ends themselves are where corners and rims lie, and their marks are often 0 */
        double x = i == 0 ? 1e-9 : i == SCANS ? 1 - 1e-9 : (double)i / SCANS;
        double previous = i <= 1 ? 1e-9 : (double)(i - 1) / SCANS;
        marks_of(problem, sweep, x, marks);
        for (size_t m = 0; i > 0 && m < MARKS; m++)
            if ((marks[m] > 0) != (before[m] > 0) && count < MOST_CUTS - 1)
                cuts[count++] = (struct cut){find_change(problem, sweep, m, previous, x), is_border(problem, m)};
        for (size_t m = 0; m < MARKS; m++)
            before[m] = marks[m];
        if (problem->lobe)
            lx_look_at(problem, sweep, x);
    }
    cuts[count++] = (struct cut){1, false};
    if (lx_is_occluded(problem->occlusion))
        count += cut_at_meridians(problem, sweep, cuts + count);
    if (lx_is_occluded(problem->occlusion) && problem->occlusion->has_outline)
        count += cut_at_slabs(problem, sweep, cuts + count);
    qsort(cuts, count, sizeof *cuts, by_place);
    return count;
}

/* ---- the whole ---- */

static double outer_target(void *data, const struct lx_integral *integral)
{
    struct lx_problem *problem = data;
    problem->running = integral->value;
    return lx_goes_on(problem) ? 0.6 * problem->tolerance * (problem->known + integral->value) : HUGE_VAL;
}

/* Cuts all sweeps into pieces, with a panel for each. */
static int make_pieces(struct lx_problem *problem, struct lx_panels *panels)
{
    size_t capacity = 0;
    struct cut *cuts = lx_new_array(MOST_CUTS + MOST_CUTS_OF_OBSTACLES + most_slabs(problem), sizeof *cuts);
    if (!cuts)
        return -1;
    for (size_t i = 0; i < problem->sweeps->count && lx_goes_on(problem); i++) {
        size_t count = cut_sweep(problem, &problem->sweeps->items[i], cuts);
        if (lx_reserve(&problem->pieces, &capacity, problem->piece_count + count, sizeof *problem->pieces)) {
            free(cuts);
            return -1;
        }
        for (size_t k = 0; k + 1 < count; k++)
            if (cuts[k + 1].x - cuts[k].x > NARROWEST)
                problem->pieces[problem->piece_count++] =
                    (struct lx_piece){i, {cuts[k].x, cuts[k + 1].x, cuts[k].border || cuts[k + 1].border}};
    }
    free(cuts);
    panels->capacity = problem->piece_count + OUTER_PANELS;
    panels->items = lx_new_array(panels->capacity, sizeof *panels->items);
    return panels->items ? 0 : -1;
}

/* The angle under which the source is seen at most, and how near it comes. */
static double greatest_angle(const struct lx_emitter *emitter, const double place_mm[3])
{
    const double *center = lx_emitter_center(emitter), radius = lx_emitter_radius(emitter);
    double distance = hypot(hypot(center[0] - place_mm[0], center[1] - place_mm[1]), center[2] - place_mm[2]);
    return distance > radius ? 2 * asin(radius / distance) : M_PI;
}

/* S^n with n < 1 begins so steeply where S = 0 that both rules miss the same: estimates count this many times. */
static double caution_for(const struct lx_lobe *lobe)
{
    return lobe && lobe->exponent < 1 ? 10 : 1;
}

/* A place in the plane of an opening is taken a little out of it. */
static double opening_error(const struct lx_facets *facets, const double place_mm[3])
{
    double away = facets->radius_mm;
    for (int i = 0; i < 3; i++)
        away += fabs(facets->center_mm[i] - place_mm[i]);
    return LX_FLATTEST * away;
}

/*
 * How far the shape is off that the sweeps are made of, in mm: the rounding of where it lies, and the turn of an
 * uncertain axis about the centre.  A disk's rim is turned with it by as much as the angles of `normal_error` tell.
 */
static double shape_error(const struct lx_emitter *emitter, const double place_mm[3])
{
    if (emitter->facets && !lx_is_opening(emitter))
        return 0;
    if (emitter->facets)
        return opening_error(emitter->facets, place_mm);
    const bool is_round_disk = lx_is_disk(emitter) && !lx_is_elliptic(emitter);
    double away = is_round_disk ? 0 : emitter->radius_mm + lx_half_height(emitter);
    for (int i = 0; i < 3; i++)
        away += fabs(emitter->center_mm[i] - place_mm[i]);
    const double flat = lx_is_opening(emitter) ? LX_FLATTEST : 0;
    const double turned = lx_is_elliptic(emitter) ? lx_elliptic_error(emitter)
                          : lx_has_axis(emitter)  ? lx_error3(emitter->axis)
                                                  : 0;
    return away * (2 * DBL_EPSILON + flat + turned);
}

/*
 * The relative error of the area of facets whose corners stand as float64 offsets from the centre: large for needles.
 * The average of many faces goes for all.
 */
static double facets_error(const struct lx_facets *facets)
{
    enum { FEW = 64 };
    double rounding = 4 * DBL_EPSILON * facets->radius_mm, worst = 0, lengths = 0;
    for (size_t f = 0; f < facets->face_count; f++) {
        const struct lx_face *face = &facets->faces[f];
        double perimeter = 0;
        for (unsigned i = 0; i < face->count; i++) {
            lx_wide3 from = facets->corners_mm[facets->loop[face->first + i]];
            lx_wide3 to = facets->corners_mm[facets->loop[face->first + (i + 1) % face->count]];
            double x = to.x.high - from.x.high, y = to.y.high - from.y.high, z = to.z.high - from.z.high;
            perimeter += sqrt(x * x + y * y + z * z);
        }
        worst = fmax(worst, rounding * perimeter / face->area_mm2);
        lengths += perimeter;
    }
    return facets->face_count <= FEW ? worst : rounding * lengths / facets->area_mm2;
}

/* Lays out what is in the way of the sweeps. */
static int lay_occlusion(struct lx_problem *problem, struct lx_directions *crossings)
{
    struct lx_occlusion *occlusion = problem->occlusion;
    if (occlusion->has_outline && lx_trapezoid_map(occlusion, problem->sweeps, problem->asking))
        return -1;
    return lx_occlusion_make_room(occlusion) || lx_make_room_on_arcs(problem) ||
                   lx_find_crossings(occlusion, problem->emitter, crossings)
               ? -1
               : 0;
}

/* About the most that the integrand may be for a solid angle: of a lobe, as met. */
static double largest_integrand(const struct lx_problem *problem, const double place_mm[3])
{
    static const double BETWEEN = 4; /* more than at any of the places that were looked at */
    const double *center = lx_emitter_center(problem->emitter);
    double away = lx_emitter_radius(problem->emitter);
    for (int k = 0; k < 3; k++)
        away += fabs(center[k] - place_mm[k]);
    const double by_law = problem->emitter->attenuation == LX_INVERSE_SQUARE ? 1 : fmax(away * away * 1e-6, 1);
    double by_area = 1; /* of flat ones dA/r^2 is less than the area in the rectangle, in which doubts are counted */
    for (size_t i = 0; lx_is_opening(problem->emitter) && i < problem->sweeps->count; i++) {
        const struct lx_sweep *sweep = &problem->sweeps->items[i];
        if (sweep->kind != LX_SWEEP_STRIP && sweep->kind != LX_SWEEP_DISK) /* the axis may go through the place */
            by_area = fmax(by_area, away / fmax(sweep->height_mm, sweep->radius_mm));
    }
    const double by_sky = problem->emitter->sky ? lx_sky_greatest(problem->emitter->sky) : 1;
    if (!problem->lobe)
        return by_law * by_area * by_sky;
    const double met = BETWEEN * exp(fmax(problem->highest, problem->top));
    return by_law * by_area * by_sky * (lx_lobe_kind_of(problem->lobe)->power ? fmin(met, 1) : met);
}

/*
 * What of an integral is in doubt because an outline is: all of it where meshes reach into a round source, or have too
 * many edges; else where rays tell something else than edges do, times the most that the integrand may be.  What is no
 * more than a rounding of all that was looked at is nothing, but for tails of highlights.
 */
static lx_bounded doubt_outline(const struct lx_problem *problem, lx_bounded found, const double place_mm[3])
{
    const struct lx_sheet_outline *outline = problem->occlusion->outline;
    const double unsure = lx_outline_unsure(outline), largest = largest_integrand(problem, place_mm);
    const bool is_open = unsure > 0 || outline->is_doubtful || outline->is_broken;
    const lx_bounded made = {found.value, found.error + (is_open ? found.value : 0) +
                                              (unsure + lx_outline_skipped(outline)) * largest};
    const bool is_nothing = made.value + made.error <= lx_outline_nothing(outline) * largest;
    return is_nothing && !problem->lobe && !problem->is_stopped ? (lx_bounded){0, made.value + made.error} : made;
}

/*
 * What the error of where obstacles lie may do across the arcs: an edge that runs along one, or a tube, begins or ends
 * to hide all of it at once, be it within the source or where that ends.  Along the arcs it is counted there.
 */
static double doubt_meridians(struct lx_problem *problem)
{
    const struct lx_occlusion *occlusion = problem->occlusion;
    const size_t count =
        occlusion->obstacles.count < MOST_CUTS_OF_OBSTACLES ? occlusion->obstacles.count : MOST_CUTS_OF_OBSTACLES;
    double doubt = 0;
    for (size_t i = 0; i < problem->sweeps->count * count && lx_goes_on(problem); i++) {
        const struct lx_sweep *sweep = &problem->sweeps->items[i / count];
        const struct lx_obstacle *obstacle = &occlusion->obstacles.items[i % count];
        const bool is_polygon = obstacle->type == LX_OBSTACLE_POLYGON;
        double meridians[LX_MOST_MERIDIANS][3], x;
        bool round;
        const size_t found = is_polygon || obstacle->type == LX_OBSTACLE_TUBE
                                 ? lx_obstacle_meridians(obstacle, &sweep->frame, meridians, &round)
                                 : 0;
        for (size_t k = 0; k < found; k++) {
            const double *at = is_polygon ? meridians[k] : obstacle->center_mm;
            const double away = hypot(lx_dot_plain(at, sweep->frame.x), lx_dot_plain(at, sweep->frame.y));
            if (!lx_sweep_find(sweep, meridians[k], &x))
                continue;
            const bool is_end = x < LX_SAME_ARC || x > 1 - LX_SAME_ARC;
            const double light = lx_light_along(problem, sweep, is_end ? x : x - LX_SAME_ARC, is_end);
            const double jump = is_end ? light : fabs(light - lx_light_along(problem, sweep, x + LX_SAME_ARC, false));
            doubt += jump * (occlusion->error_mm / away + 4 * DBL_EPSILON);
        }
    }
    return doubt;
}

/* The vector g for which there is nothing where g.L <= *limit; where a lobe has no end the normal, and the horizon. */
static const double *end_of_lobe(const struct lx_problem *problem, double *limit)
{
    const struct lx_lobe_kind *kind = problem->lobe ? lx_lobe_kind_of(problem->lobe) : NULL;
    *limit = kind && !LX_ENDS_AT_HORIZON(problem->lobe->highlight) ? -2 : 0; /* no g.L is less than that */
    return kind && kind->end ? kind->end(&problem->at, limit) : problem->at.normal;
}

/* Integrates the problem over the source as it is seen from a place. */
static lx_bounded integrate(struct lx_problem *problem, const double place_mm[3])
{
    struct lx_sweeps sweeps = {0};
    struct lx_panels panels = {0};
    lx_bounded result = {0, HUGE_VAL};
    double unused;
    const double *across_which = end_of_lobe(problem, &unused);
    const bool is_occluded = lx_is_occluded(problem->occlusion);
    const bool has_forms = is_occluded || lx_is_opening(problem->emitter);
    struct lx_integrand integrand = {.at = lx_integrate_arc,
                                     .target = outer_target,
                                     .data = problem,
                                     .form = has_forms ? lx_form_of_arc : NULL,
                                     .is_coarse = problem->is_coarse};
    problem->sweeps = &sweeps;
    problem->top = problem->lobe ? -HUGE_VAL : 0;
    problem->at_border = problem->running = 0;
    problem->highest = -HUGE_VAL;
    problem->pieces = NULL;
    problem->piece_count = 0;
    problem->room = NULL;
    problem->panels = NULL;
    struct lx_directions crossings = {.items = NULL};
    problem->crossings = &crossings;
    if (!lx_sweeps_make(problem->emitter, place_mm, across_which, is_occluded, &sweeps) &&
        (!is_occluded || !lay_occlusion(problem, &crossings)) && !make_pieces(problem, &panels)) {
        if (problem->top == -HUGE_VAL)
            problem->top = 0; /* the lobe was met nowhere */
        if (problem->top < INVISIBLE)
            problem->piece_count = 0;
        struct lx_integral all;
        do {
            problem->top = fmax(problem->top, problem->highest);
            for (size_t i = 0; i < problem->piece_count; i++)
                panels.items[i] = (struct lx_panel){.interval = i, .from = 0, .to = 1};
            panels.count = problem->piece_count;
            all = lx_integrate_panels(&integrand, &panels);
        } while (lx_outgrew_top(problem) && !problem->is_stopped);
        /* A border that is moved by an angle takes along a strip of the source. */
        double moved = problem->at.normal_error + problem->at.view_error + 4 * DBL_EPSILON;
        double strip = 4 * moved * problem->at_border * greatest_angle(problem->emitter, place_mm);
        double scale = exp(problem->top);
        result.value = all.value * scale;
        double estimate = caution_for(problem->lobe) * all.error, rounding = ROUNDING;
        if (problem->emitter->facets)
            rounding += facets_error(problem->emitter->facets);
        result.error = (estimate + all.inherited + strip + rounding * all.value) * scale;
        result.error += problem->top < 0 ? DBL_MIN : 0;
        result.error += is_occluded ? doubt_meridians(problem) * scale : 0;
        if (is_occluded && problem->occlusion->has_outline)
            result = doubt_outline(problem, result, place_mm);
    }
    free(crossings.items);
    free(problem->room);
    free(problem->panels);
    free(panels.items);
    free(problem->pieces);
    free(sweeps.items);
    return result;
}

static void set_condition(struct lx_problem *problem, const double g[3], double limit)
{
    struct lx_border *condition = &problem->conditions[problem->condition_count++];
    for (int i = 0; i < 3; i++)
        condition->g[i] = g[i];
    condition->limit = limit;
}

/* Where the lobe ends, and where its weight does. */
static void set_conditions(struct lx_problem *problem)
{
    const bool front_only = !problem->lobe || LX_ENDS_AT_HORIZON(problem->lobe->highlight);
    double limit;
    const double *end = end_of_lobe(problem, &limit);
    const bool is_by_normal = end == problem->at.normal;
    problem->condition_count = 0;
    set_condition(problem, end, front_only && is_by_normal ? fmax(limit, 0) : limit);
    if (front_only && !is_by_normal)
        set_condition(problem, problem->at.normal, 0);
}

/* What an outline leaves, in closed form if that is good enough. */
static bool sum_outline(struct lx_problem *problem, lx_bounded *seen)
{
    if (!lx_outline_sum(problem->occlusion, problem->emitter, problem->at.normal, problem->at.normal_error,
                        problem->asking, &seen->value, &seen->error))
        return false;
    problem->parts++;
    return seen->error <= fmax(problem->tolerance, 1e-12) * (seen->value + problem->known) ||
           seen->value + seen->error <= lx_outline_nothing(problem->occlusion->outline);
}

struct lx_cubature lx_integrate(const struct lx_emitter *emitter, const struct lx_element *element,
                                struct lx_occlusion *occlusion, bool diffuse, double known, double tolerance,
                                const struct lx_asking *asking)
{
    struct lx_cubature result = {.irradiance = lx_exact(0), .specular = lx_exact(0)};
    const struct lx_lobe *lobe = element->lobe;
    double radiance = emitter->radiance.value, place[3], normal[3], view[3];
    struct lx_problem problem = {.emitter = emitter, .tolerance = tolerance, .asking = asking, .occlusion = occlusion};
    lx_values3(element->place_mm, place);
    lx_values3(element->place_mm, problem.place_mm);
    lx_values3(element->normal, normal);
    lx_values3(element->view, view);
    lx_lobe_at_set(normal, view, &problem.at);
    problem.place_error_mm = lx_error3(element->place_mm) + shape_error(emitter, place);
    problem.at.normal_error = lx_error3(element->normal) + (lx_is_disk(emitter) ? lx_error3(emitter->axis) : 0);
    problem.at.view_error = lx_error3(element->view);
    if (!(radiance > 0))
        return result;
    if (diffuse) {
        set_conditions(&problem);
        const bool is_uneven = lx_is_opening(emitter) || emitter->sky || emitter->pane_count > 0;
        if ((lx_is_occluded(occlusion) || is_uneven) && known > 0 && lobe->diffuse.value > 0)
            problem.known = known / (radiance * lobe->diffuse.value);
        lx_bounded seen;
        problem.is_coarse = is_uneven && tolerance >= COARSE;
        if (!occlusion || is_uneven || !sum_outline(&problem, &seen))
            seen = integrate(&problem, place);
        result.irradiance = lx_mul(emitter->radiance, seen);
        known += result.irradiance.value * lobe->diffuse.value;
        result.parts = problem.parts;
        problem.parts = 0; /* each integral may take all the work that there may be */
    }
    if (lx_lobe_shines(lobe)) {
        lx_bounded strength = lx_mul(emitter->radiance, lobe->specular);
        problem.lobe = lobe;
        problem.known = known / strength.value;
        problem.tolerance = tolerance / caution_for(lobe);
        const bool has_samples = lx_lobe_kind_of(lobe)->power && !lx_is_occluded(occlusion) && !lx_is_opening(emitter);
        problem.is_coarse = !has_samples && problem.tolerance >= COARSE;
        set_conditions(&problem);
        problem.kink_count = lx_lobe_kinks(lobe, &problem.at, problem.kinks);
        result.specular = lx_mul(strength, integrate(&problem, place));
    }
    result.parts += problem.parts;
    return result;
}

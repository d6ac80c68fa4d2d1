/* SPDX-License-Identifier: MIT */
/* The flux of each emitter through a plane: closed forms, and the integral of the others. */
#include "flux.h"

#include <math.h>
#include <stdlib.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "../light/solid/facets.h"
#include "../world/blocking.h"
#include "../world/integral/adaptive.h"
#include "../world/visibility/occlusion.h"
#include "flux_edges.h"
#include "flux_luminaire.h"

/* Panels of one line and of the lines, beside those that they begin with; feet of sources where they begin. */
enum { MORE_PANELS = 512, MOST_FEET = 24 };

/* How small the estimated error is made, relative to the flux. */
static const double TOLERANCE = 1e-9;
/* How well the places of edges are known, by the side of the plane; panels end that far before them. */
static const double PLACES = 1e-11;

/* The work that may be done, in shares of a point source at an element that has to ask surfaces; a polygon takes so
 * many of them, a round source and a polyhedron more, and those of which surfaces may hide a part most. */
static const double MOST_WORK = 4e5, POINT_WORK = 0.25, POLYGON_WORK = 10, ROUND_WORK = 20, HIDDEN_WORK = 100;
/* Behind penumbrae the share of an emitter's work that goes into rules, and what lattices differ by is taken for. */
static const double RULES_SHARE = 0.5, LATTICE_CAUTION = 2;
enum { LEAST_LATTICE = 9 };

/* The plane in float64: what directions lack to their wide numbers counts as their error. */
struct plane {
    const struct lx_cells *cells;
    lx_bounded3 across, upward, normal;
};

struct search {
    const struct lx_prepared *prepared;
    const struct lx_asking *asking;
    struct plane plane;
    struct lx_lobe lobe;
    bool *aside;           /* which surfaces lie behind the plane or in it */
    double work, scale;    /* what was done; an irradiance that is usual on the plane */
    double limit;          /* up to where rules may go on */
    bool touches, stopped; /* a source lies on an element; nobody waits any more, or memory ran out */
};

/* The integral over the light of one emitter. */
struct task {
    struct search *search;
    struct lx_edges edges;
    struct lx_prepared asked;  /* the scene; with no shadows where the edges tell all of them */
    double work;               /* of an element */
    double feet[2][MOST_FEET]; /* along each side from -1/2 to 1/2, in no order */
    size_t foot_count[2];
    double v; /* of the line */
    struct lx_panel *line;
    struct lx_line_part *lit;
    size_t most_lit; /* of a line */
    double *ends;    /* of the intervals between the lines that matter */
    size_t end_count;
};

static lx_bounded area_m2(const struct lx_cells *cells)
{
    return lx_mul(lx_div(lx_exact(cells->size_mm[0]), lx_exact(1000)),
                  lx_div(lx_exact(cells->size_mm[1]), lx_exact(1000)));
}

/* ---- what surfaces may take ---- */

/* Whether all of a surface lies behind the plane or in it. */
static bool is_aside(const struct search *search, const struct lx_prepared_surface *surface)
{
    const double normal[3] = {search->plane.normal.x.value, search->plane.normal.y.value, search->plane.normal.z.value};
    const double *center = search->plane.cells->center_mm;
    double level = 0, size = surface->shape.radius_mm;
    for (int i = 0; i < 3; i++) {
        level += normal[i] * center[i];
        size += fabs(center[i]) + fabs(surface->shape.anchor_mm[i]);
    }
    return lx_surface_farthest(surface->kind, surface->parameters, normal) <= level + 1e-12 * size;
}

/* Whether a surface may stand between the plane and an emitter. */
static bool may_be_hidden(const struct search *search, const struct lx_emitter *emitter)
{
    const struct lx_cells *cells = search->plane.cells;
    const struct lx_ball from = {.radius = hypot(cells->size_mm[0], cells->size_mm[1]) / 2};
    const bool endless = lx_is_endless(emitter);
    struct lx_ball towards = {.radius = 0};
    const bool is_extended = lx_is_extended(emitter);
    if (lx_is_uniform(emitter) || !search->prepared->shadows_on_free ||
        (is_extended && !search->prepared->shadows_extended))
        return false;
    towards.radius = lx_emitter_radius(emitter);
    lx_emitter_origin(emitter, towards.center);
    for (int i = 0; i < 3 && !endless; i++)
        towards.center[i] -= cells->center_mm[i];
    for (size_t s = 0; s < search->prepared->surface_count; s++) {
        const struct lx_prepared_surface *surface = &search->prepared->surfaces[s];
        struct lx_ball ball = {.radius = surface->shape.radius_mm};
        for (int i = 0; i < 3; i++)
            ball.center[i] = surface->shape.anchor_mm[i] - cells->center_mm[i];
        if (!search->aside[s] && lx_may_block(&ball, &from, &towards, endless))
            return true;
    }
    return false;
}

/* ---- closed forms ---- */

/* The place of a point from the plane's centre: along its sides and above it. */
static lx_bounded3 above_plane(const struct plane *plane, const double position_mm[3])
{
    lx_bounded3 from = lx_sub3(lx_exact3(position_mm), lx_exact3(plane->cells->center_mm));
    return (lx_bounded3){lx_dot3(from, plane->across), lx_dot3(from, plane->upward), lx_dot3(from, plane->normal)};
}

/* The solid angle of the rectangle from a point above it, the sum over its corners. */
static lx_bounded solid_angle(const struct plane *plane, lx_bounded3 at)
{
    const double half[2] = {plane->cells->size_mm[0] / 2, plane->cells->size_mm[1] / 2};
    lx_bounded sum = lx_exact(0);
    for (int i = 0; i < 4; i++) {
        lx_bounded x = lx_sub(lx_exact(i & 1 ? half[0] : -half[0]), at.x);
        lx_bounded y = lx_sub(lx_exact(i & 2 ? half[1] : -half[1]), at.y);
        lx_bounded r = lx_length3((lx_bounded3){x, y, at.z});
        lx_bounded corner = lx_angle(lx_mul(x, y), lx_mul(at.z, r));
        sum = i == 0 || i == 3 ? lx_add(sum, corner) : lx_sub(sum, corner);
    }
    return sum;
}

/* The irradiance at a point, for a normal, of the rectangle with the radiance 1; false: memory ran out. */
static bool seen_from(const struct plane *plane, const double position_mm[3], lx_bounded3 normal,
                      lx_bounded *irradiance)
{
    struct lx_facets *rectangle =
        lx_facets_of_pose(plane->cells->center_mm, plane->cells->size_mm, &plane->cells->pose);
    if (!rectangle)
        return false;
    *irradiance = lx_facets_irradiance(rectangle, lx_exact3(position_mm), normal);
    lx_facets_free(rectangle);
    return true;
}

/* Whether an emitter without size lies behind the plane or in it, and so gives it nothing, whatever stands around. */
static bool is_behind(const struct plane *plane, const struct lx_emitter *emitter)
{
    if (!lx_is_point(emitter))
        return false;
    const lx_bounded height = above_plane(plane, emitter->position_mm).z;
    return height.value <= -height.error;
}

/* Whether an emitter that nothing hides has a closed form, and the flux by it. */
static bool in_closed_form(const struct plane *plane, const struct lx_emitter *emitter, lx_bounded *flux)
{
    const struct lx_profile *profile = &emitter->profile;
    const lx_bounded strength = lx_strength(emitter);
    if (lx_is_uniform(emitter)) {
        *flux = lx_mul(strength, area_m2(plane->cells));
        return true;
    }
    if (lx_is_endless(emitter)) {
        lx_bounded cosine = lx_positive(lx_dot3(plane->normal, emitter->towards));
        *flux = lx_mul(lx_mul(strength, cosine), area_m2(plane->cells));
        return true;
    }
    if (!lx_is_point(emitter))
        return false;
    lx_bounded3 at = above_plane(plane, emitter->position_mm);
    if (emitter->attenuation != LX_INVERSE_SQUARE || profile->falloff != LX_NO_CONE || profile->luminaire ||
        !(at.z.value > at.z.error))
        return false;
    lx_bounded share;
    if (profile->exponent == 0)
        share = solid_angle(plane, at);
    else if (profile->exponent != 1 || !seen_from(plane, emitter->position_mm, profile->axis, &share))
        return false;
    *flux = lx_mul(strength, share);
    return true;
}

/* ---- the integral ---- */

static struct lx_point_value light_at(struct task *task, double u, double v)
{
    struct search *search = task->search;
    const struct lx_cells *cells = search->plane.cells;
    const lx_bounded3 place = lx_edges_place(&task->edges, u, v);
    luxel_place asked = {.is_element = true};
    lx_values3(place, asked.position_mm);
    lx_values3(cells->normal, asked.normal);
    struct lx_element element = lx_element_at(&task->asked, &asked);
    element.lobe = &search->lobe;
    search->stopped = search->stopped || !lx_asking_goes_on(search->asking);
    search->work += task->work;
    if (search->stopped)
        return (struct lx_point_value){.value = 0};
    const struct lx_lighting light = lx_light_element(&task->asked, &element, task->edges.emitter);
    /* a source may touch the plane's edge */
    search->touches = search->touches || (light.on_element && fabs(u) < 0.5 && fabs(v) < 0.5);
    if (light.on_element)
        return (struct lx_point_value){.value = 0};
    /* where it is in doubt on which side of an edge the place is, the edge is where the panels end */
    const bool is_doubtful = task->edges.count > 0 && !(light.irradiance.error < light.irradiance.value / 4);
    return (struct lx_point_value){.value = fmax(light.irradiance.value, 0),
                                   .error = is_doubtful ? 0 : light.irradiance.error};
}

static double target(void *data, const struct lx_integral *integral)
{
    const struct search *search = ((const struct task *)data)->search;
    if (search->stopped || search->touches || search->work > search->limit)
        return HUGE_VAL;
    return TOLERANCE * fmax(integral->value, search->scale);
}

/* Lines are ten times as exact as the whole, lest what they are off looks like a shape. */
static double target_of_line(void *data, const struct lx_integral *integral)
{
    return target(data, integral) / 10;
}

static struct lx_point_value at_point(void *data, size_t interval, double u)
{
    struct task *task = data;
    (void)interval;
    return light_at(task, u, task->v);
}

/* The panels of a lit range, which end where a source has its foot. */
static size_t cut_range(const struct task *task, const struct lx_line_part *range, struct lx_panel *panels)
{
    size_t count = 0;
    double from = range->from;
    for (size_t i = 0; i <= task->foot_count[0]; i++) { /* feet in order */
        const double to = i < task->foot_count[0] ? fmin(task->feet[0][i], range->to) : range->to;
        if (to - from > 4 * PLACES)
            panels[count++] = (struct lx_panel){.from = from + PLACES, .to = to - PLACES};
        from = fmax(from, to);
    }
    return count;
}

static double along_line(struct task *task, double v, double *error)
{
    struct lx_integrand integrand = {.at = at_point, .target = target_of_line, .data = task};
    const struct lx_plane_line line = {.middle = {0, v}, .slope = {1, 0}};
    const size_t lit_count = lx_edges_lit(&task->edges, &line, task->lit);
    struct lx_panels panels = {.items = task->line};
    for (size_t i = 0; i < lit_count; i++)
        panels.count += cut_range(task, &task->lit[i], task->line + panels.count);
    panels.capacity = panels.count + MORE_PANELS;
    task->most_lit = panels.count > task->most_lit ? panels.count : task->most_lit;
    task->v = v;
    struct lx_integral integral = lx_integrate_panels(&integrand, &panels);
    *error = integral.error + integral.inherited;
    return integral.value;
}

/* A line of an interval, t of the way: where an edge has its top or bottom the integral along lines begins like a root,
 * and is smooth in t with v = from + (to - from) (3 t^2 - 2 t^3). */
static struct lx_point_value at_line(void *data, size_t interval, double t)
{
    struct task *task = data;
    const double from = task->ends[interval], length = task->ends[interval + 1] - from;
    const double slope = 6 * t * (1 - t) * length;
    double error = 0, value = slope > 0 ? along_line(task, from + length * t * t * (3 - 2 * t), &error) : 0;
    return (struct lx_point_value){.value = slope * value, .error = slope * error};
}

/* Notes where a source stands above the plane, where there the rule begins a panel. */
static void note_foot(struct task *task, const double position_mm[3])
{
    const struct lx_cells *cells = task->search->plane.cells;
    lx_bounded3 at = above_plane(&task->search->plane, position_mm);
    const double feet[2] = {at.x.value / cells->size_mm[0], at.y.value / cells->size_mm[1]};
    for (int side = 0; side < 2; side++)
        if (fabs(feet[side]) < 0.5)
            task->feet[side][task->foot_count[side]++] = feet[side];
}

/* Notes where the axis of a source with a beam meets the plane. */
static void note_aim(struct task *task, const struct lx_emitter *emitter)
{
    const struct lx_profile *profile = &emitter->profile;
    lx_bounded3 at = above_plane(&task->search->plane, emitter->position_mm);
    double fall = -lx_dot3(profile->axis, task->search->plane.normal).value, met[3];
    const double axis[3] = {profile->axis.x.value, profile->axis.y.value, profile->axis.z.value};
    if (lx_profile_is_isotropic(profile) || !(fall > 0 && at.z.value > 0))
        return;
    for (int i = 0; i < 3; i++)
        met[i] = emitter->position_mm[i] + at.z.value / fall * axis[i];
    note_foot(task, met);
}

static void note_feet(struct task *task, const struct lx_emitter *emitter)
{
    if (lx_has_place(emitter))
        note_foot(task, lx_emitter_center(emitter));
    if (lx_is_point(emitter))
        note_aim(task, emitter);
    for (int side = 0; side < 2; side++)
        if (task->foot_count[side] > 1)
            qsort(task->feet[side], task->foot_count[side], sizeof(double), lx_by_value);
}

/* Where the lines change their shape, in order, the plane's ends among them; false: memory ran out. */
static bool find_ends(struct task *task)
{
    struct lx_plane_places turns = {.items = NULL};
    const bool is_whole = lx_edges_turns(&task->edges, &turns) == 0;
    task->ends = is_whole ? lx_new_array(turns.count + MOST_FEET + 2, sizeof *task->ends) : NULL;
    for (size_t i = 0; task->ends && i < turns.count; i++)
        task->ends[task->end_count++] = turns.items[i].v;
    free(turns.items);
    if (!task->ends)
        return false;
    for (size_t i = 0; i < task->foot_count[1]; i++)
        task->ends[task->end_count++] = task->feet[1][i];
    task->ends[task->end_count++] = -0.5;
    task->ends[task->end_count++] = 0.5;
    qsort(task->ends, task->end_count, sizeof *task->ends, lx_by_value);
    return true;
}

/* The mean over the plane; false: memory ran out. */
static bool integrate(struct task *task, lx_bounded *mean)
{
    struct lx_integrand integrand = {.at = at_line, .target = target, .data = task};
    const size_t most = lx_edges_most(&task->edges);
    if (!find_ends(task))
        return false;
    struct lx_panels panels = {.items = lx_new_array(task->end_count + MORE_PANELS, sizeof *panels.items)};
    task->lit = lx_new_array(most, sizeof *task->lit);
    task->line = lx_new_array(most * (MOST_FEET + 1) + MORE_PANELS, sizeof *task->line);
    const bool is_room = panels.items && task->lit && task->line;
    for (size_t i = 0; i + 1 < task->end_count && is_room; i++)
        if (task->ends[i + 1] - task->ends[i] > PLACES)
            panels.items[panels.count++] = (struct lx_panel){.interval = i, .from = 0, .to = 1};
    panels.capacity = panels.count + MORE_PANELS;
    if (is_room) {
        const struct lx_integral integral = lx_integrate_panels(&integrand, &panels);
        const double left_out = 8 * PLACES * (double)(task->end_count + task->most_lit);
        const double places = task->edges.count > 0 ? left_out * fmax(integral.value, task->search->scale) : 0;
        *mean = (lx_bounded){integral.value, integral.error + integral.inherited + places};
    }
    free(panels.items);
    free(task->lit);
    free(task->line);
    return is_room;
}

/* The mean of the places in the middle of n times n cells. */
static lx_bounded mean_of_lattice(struct task *task, unsigned n)
{
    lx_bounded mean = lx_exact(0);
    for (unsigned i = 0; i < n * n && !task->search->stopped; i++) {
        const struct lx_point_value light = light_at(task, (i % n + 0.5) / n - 0.5, ((double)(i / n) + 0.5) / n - 0.5);
        mean.value += light.value / ((double)n * n);
        mean.error += light.error / ((double)n * n);
    }
    return mean;
}

/*
 * The mean over the plane of a source of some size of which surfaces hide parts.  Each line crosses kinks where parts
 * begin to be hidden, and nobody knows where; rules that look for each of them spend the work on their first lines.  So
 * where they do not come to an end three lattices that share no places tell the mean, and by what they differ how far
 * that may be off: the error of one of n times n falls like 1 / n^2 or, where light jumps, 1 / n.
 */
static bool integrate_penumbrae(struct task *task, size_t emitters, lx_bounded *mean)
{
    struct search *search = task->search;
    const double share = (MOST_WORK - search->work) / (double)emitters, end = search->work + share;
    search->limit = search->work + RULES_SHARE * share;
    if (!integrate(task, mean))
        return false;
    if (search->work <= search->limit || search->stopped)
        return true;
    const double places = fmax(end - search->work, share / 4) / task->work;
    const unsigned n = (unsigned)sqrt(places / 1.6) | 1; /* odd ones, of which few have a centre in common */
    if (n < LEAST_LATTICE)
        return true;
    const lx_bounded fine = mean_of_lattice(task, n), middle = mean_of_lattice(task, (n * 5 / 8) | 1),
                     coarse = mean_of_lattice(task, (n * 3 / 8) | 1);
    const double off = fmax(fabs(fine.value - middle.value), fabs(fine.value - coarse.value) / 2);
    const double error = fine.error + LATTICE_CAUTION * off;
    if (error < mean->error)
        *mean = (lx_bounded){fine.value, error};
    return !search->stopped;
}

static double work_of(const struct lx_emitter *emitter, bool asks_surfaces)
{
    if (!lx_is_extended(emitter))
        return asks_surfaces ? 1 : POINT_WORK;
    if (asks_surfaces)
        return HIDDEN_WORK;
    return emitter->facets && emitter->facets->face_count == 1 ? POLYGON_WORK : ROUND_WORK;
}

/* The flux of an emitter by its integral; as many are still to come, it among them. */
static lx_bounded integral_of(struct search *search, const struct lx_emitter *emitter, bool casts, size_t emitters)
{
    const struct lx_flux_asked asked = {.prepared = search->prepared,
                                        .plane = search->plane.cells,
                                        .emitter = emitter,
                                        .aside = search->aside,
                                        .casts = casts,
                                        .usual = search->scale * area_m2(search->plane.cells).value,
                                        .tolerance = TOLERANCE,
                                        .asking = search->asking};
    lx_bounded flux;
    if (lx_luminaire_flux(&asked, &flux))
        return flux;
    struct task task = {.search = search, .asked = *search->prepared};
    lx_bounded mean = lx_exact(0);
    if (lx_edges_make(search->prepared, search->plane.cells, emitter, search->aside, casts, &task.edges) == 0) {
        const bool asks_surfaces = casts && !task.edges.knows_shadows;
        task.work = work_of(emitter, asks_surfaces);
        if (!asks_surfaces)
            task.asked.shadows_on_free = task.asked.shadows_extended = false;
        note_feet(&task, emitter);
        search->limit = MOST_WORK;
        const bool is_whole = asks_surfaces && lx_is_extended(emitter) ? integrate_penumbrae(&task, emitters, &mean)
                                                                       : integrate(&task, &mean);
        search->stopped = !is_whole || search->stopped;
    } else
        search->stopped = true;
    lx_edges_clear(&task.edges);
    free(task.ends);
    return lx_mul(mean, area_m2(search->plane.cells));
}

/* ---- the whole ---- */

static lx_bounded open_flux(struct search *search, const struct lx_emitter *emitter, size_t emitters)
{
    lx_bounded flux;
    return in_closed_form(&search->plane, emitter, &flux) ? flux : integral_of(search, emitter, false, emitters);
}

/* The flux of an emitter: between 0 and what it would be without anything in the way, whatever an integral over many
 * shadows is off. */
static lx_bounded flux_of(struct search *search, const struct lx_emitter *emitter, size_t emitters)
{
    if (is_behind(&search->plane, emitter))
        return lx_exact(0);
    if (!may_be_hidden(search, emitter))
        return open_flux(search, emitter, emitters);
    lx_bounded flux = integral_of(search, emitter, true, emitters);
    if (flux.error <= flux.value)
        return flux;
    const lx_bounded open = open_flux(search, emitter, emitters);
    const double most = open.value + open.error;
    if (!(flux.value <= most))
        flux.value = most;
    flux.error = fmin(flux.error, fmax(flux.value, most - flux.value));
    return flux;
}

struct lx_flux lx_plane_flux(const struct lx_prepared *prepared, const struct lx_cells *plane, double usual,
                             const struct lx_asking *asking)
{
    const struct lx_emitters *emitters = &prepared->emitters;
    struct search search = {
        .prepared = prepared,
        .asking = asking,
        .plane = {plane, lx_wide3_direction(plane->pose.across), lx_wide3_direction(plane->pose.upward),
                  lx_wide3_direction(plane->pose.axis)},
        .lobe = lx_lobe_irradiance(),
        .aside = lx_new_array(prepared->surface_count, sizeof *search.aside),
        .scale = usual,
    };
    struct lx_flux flux = {.value = lx_exact(0)};
    if (!search.aside)
        return flux;
    for (size_t s = 0; s < prepared->surface_count; s++)
        search.aside[s] = is_aside(&search, &prepared->surfaces[s]);
    for (size_t i = 0; i < emitters->count && !search.stopped; i++) {
        struct lx_emitter room;
        search.stopped = !lx_asking_at_step(asking, i, 64);
        flux.value = lx_add(flux.value, flux_of(&search, lx_emitter_at(emitters, i, &room), emitters->count - i));
    }
    flux.is_known = !search.touches && !search.stopped;
    free(search.aside);
    return flux;
}

/* SPDX-License-Identifier: MIT */
/* The flux of each emitter through a plane: closed forms, and the integral of the others. */
#include "flux.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../light/facets.h"
#include "adaptive.h"
#include "blocking.h"
#include "flux_edges.h"
#include "occlusion.h"

/* Panels of one line, and of the lines; feet of sources where they begin. */
enum { MOST_PANELS = 512, MOST_FEET = 24, MOST_ENDS = 250 };

/* How small the estimated error is made, relative to the flux. */
static const double TOLERANCE = 1e-9;
/* How well the places of edges are known, by the side of the plane; panels end that far before them. */
static const double PLACES = 1e-11;

/* The work that may be done, in shares of a point source at an element; a polygon takes so many of them, a round source
 * and a polyhedron more, and those of which surfaces may hide a part most. */
static const double MOST_WORK = 4e5, POLYGON_WORK = 10, ROUND_WORK = 20, HIDDEN_WORK = 100;

/* The plane in float64: what directions lack to their wide numbers counts as their error. */
struct plane {
    const struct lx_cells *cells;
    lx_bounded3 across, upward, normal;
};

struct hunt {
    const struct lx_prepared *prepared;
    const struct lx_asking *asking;
    struct plane plane;
    const struct lx_lobe *lobe;
    size_t *hard; /* emitters that have no closed form here */
    size_t hard_count;
    double work_each, work; /* of an element, and what was done */
    double scale;
    struct lx_edges edges;
    double feet[2][MOST_FEET]; /* along each side from -1/2 to 1/2, in no order */
    size_t foot_count[2];
    bool touches, stopped; /* a source lies on an element; nobody waits any more */
    double v;              /* of the line */
    struct lx_panel *line;
    double ends[MOST_ENDS + 2]; /* of the intervals between the lines that matter */
};

static lx_bounded area_m2(const struct lx_cells *cells)
{
    return lx_mul(lx_div(lx_exact(cells->size_mm[0]), lx_exact(1000)),
                  lx_div(lx_exact(cells->size_mm[1]), lx_exact(1000)));
}

/* ---- what surfaces may take ---- */

/* Whether all of a surface lies behind the plane or in it. */
static bool is_behind(const struct hunt *hunt, const struct lx_prepared_surface *surface)
{
    const double normal[3] = {hunt->plane.normal.x.value, hunt->plane.normal.y.value, hunt->plane.normal.z.value};
    const double *center = hunt->plane.cells->center_mm;
    double level = 0, size = surface->shape.radius_mm;
    for (int i = 0; i < 3; i++) {
        level += normal[i] * center[i];
        size += fabs(center[i]) + fabs(surface->shape.anchor_mm[i]);
    }
    return lx_surface_farthest(surface->kind, surface->parameters, normal) <= level + 1e-12 * size;
}

/* Whether a surface may stand between the plane and an emitter. */
static bool may_be_hidden(const struct hunt *hunt, const struct lx_emitter *emitter)
{
    const struct lx_cells *cells = hunt->plane.cells;
    const struct lx_ball from = {.radius = hypot(cells->size_mm[0], cells->size_mm[1]) / 2};
    const bool endless = emitter->type == LX_DIRECTION;
    struct lx_ball towards = {.center = {emitter->towards.x.value, emitter->towards.y.value, emitter->towards.z.value}};
    const bool is_extended = lx_is_extended(emitter);
    if (!hunt->prepared->shadows_on_free || (is_extended && !hunt->prepared->shadows_extended))
        return false;
    const struct lx_shaft shaft =
        is_extended ? lx_shaft_to(cells->center_mm, from.radius, emitter) : (struct lx_shaft){.to_radius_mm = 0};
    towards.radius = shaft.to_radius_mm;
    for (int i = 0; i < 3 && !endless; i++)
        towards.center[i] = (is_extended ? shaft.to_mm[i] : emitter->position_mm[i]) - cells->center_mm[i];
    for (size_t s = 0; s < hunt->prepared->surface_count; s++) {
        const struct lx_prepared_surface *surface = &hunt->prepared->surfaces[s];
        struct lx_ball ball = {.radius = surface->shape.radius_mm};
        for (int i = 0; i < 3; i++)
            ball.center[i] = surface->shape.anchor_mm[i] - cells->center_mm[i];
        if (!is_behind(hunt, surface) && lx_may_block(&ball, &from, &towards, endless))
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
    struct lx_emitter rectangle = {.type = LX_FACETS, .radiance = lx_exact(1)};
    rectangle.facets = lx_facets_of_pose(plane->cells->center_mm, plane->cells->size_mm, &plane->cells->pose);
    if (!rectangle.facets)
        return false;
    *irradiance = lx_extended_irradiance(&rectangle, lx_exact3(position_mm), normal);
    lx_facets_free(rectangle.facets);
    return true;
}

/* Whether an emitter that nothing hides has a closed form, and the flux by it. */
static bool in_closed_form(const struct plane *plane, const struct lx_emitter *emitter, lx_bounded *flux)
{
    const struct lx_profile *profile = &emitter->profile;
    lx_bounded strength = lx_exact(emitter->strength);
    if (emitter->type == LX_UNIFORM) {
        *flux = lx_mul(strength, area_m2(plane->cells));
        return true;
    }
    if (emitter->type == LX_DIRECTION) {
        lx_bounded cosine = lx_positive(lx_dot3(plane->normal, emitter->towards));
        *flux = lx_mul(lx_mul(strength, cosine), area_m2(plane->cells));
        return true;
    }
    if (emitter->type != LX_POINT)
        return false;
    lx_bounded3 at = above_plane(plane, emitter->position_mm);
    if (at.z.value <= -at.z.error) {
        *flux = lx_exact(0);
        return true;
    }
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

static struct lx_point_value light_at(struct hunt *hunt, double u, double v)
{
    const struct lx_cells *cells = hunt->plane.cells;
    struct lx_point_value point = {.value = 0};
    lx_bounded3 place =
        lx_add3(lx_exact3(cells->center_mm), lx_add3(lx_mul3(hunt->plane.across, lx_exact(u * cells->size_mm[0])),
                                                     lx_mul3(hunt->plane.upward, lx_exact(v * cells->size_mm[1]))));
    struct lx_free_element asked = {.place_mm = {place.x.value, place.y.value, place.z.value},
                                    .normal = {cells->normal.x.value, cells->normal.y.value, cells->normal.z.value}};
    struct lx_element element = lx_element_at(hunt->prepared, &asked);
    element.lobe = hunt->lobe;
    hunt->stopped = hunt->stopped || !lx_asking_goes_on(hunt->asking);
    hunt->work += hunt->work_each;
    for (size_t i = 0; i < hunt->hard_count && !hunt->stopped; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&hunt->prepared->emitters, hunt->hard[i], &room);
        struct lx_lighting light = lx_light_element(hunt->prepared, &element, emitter);
        /* a source may touch the plane's edge */
        hunt->touches = hunt->touches || (light.on_element && fabs(u) < 0.5 && fabs(v) < 0.5);
        if (light.on_element)
            continue;
        point.value += light.irradiance.value;
        /* where it is in doubt on which side of an edge the place is, the edge is where the panels end */
        if (hunt->edges.count == 0 || light.irradiance.error < light.irradiance.value / 4)
            point.error += light.irradiance.error;
    }
    point.value = fmax(point.value, 0);
    return point;
}

static double target(void *data, const struct lx_integral *integral)
{
    const struct hunt *hunt = data;
    if (hunt->stopped || hunt->touches || hunt->work > MOST_WORK)
        return HUGE_VAL;
    return TOLERANCE * fmax(integral->value, hunt->scale);
}

/* Lines are ten times as exact as the whole, lest what they are off looks like a shape. */
static double target_of_line(void *data, const struct lx_integral *integral)
{
    return target(data, integral) / 10;
}

static struct lx_point_value at_point(void *data, size_t interval, double u)
{
    struct hunt *hunt = data;
    (void)interval;
    return light_at(hunt, u, hunt->v);
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return a < b ? -1 : a > b;
}

/* Sorts the ends of panels, those of the plane among them; returns how many there are. */
static size_t sort_ends(const struct hunt *hunt, int side, double *ends, size_t count)
{
    for (size_t i = 0; i < hunt->foot_count[side]; i++)
        ends[count++] = hunt->feet[side][i];
    ends[count++] = -0.5;
    ends[count++] = 0.5;
    qsort(ends, count, sizeof *ends, by_size);
    return count;
}

static double along_line(struct hunt *hunt, double v, double *error)
{
    struct lx_integrand integrand = {.at = at_point, .target = target_of_line, .data = hunt};
    struct lx_panels panels = {.items = hunt->line, .capacity = MOST_PANELS};
    double ends[MOST_ENDS + 2];
    size_t count = lx_edges_across(&hunt->edges, v, ends, MOST_ENDS - MOST_FEET);
    count = sort_ends(hunt, 0, ends, count);
    for (size_t i = 0; i + 1 < count; i++)
        if (ends[i + 1] - ends[i] > 4 * PLACES)
            hunt->line[panels.count++] = (struct lx_panel){.from = ends[i] + PLACES, .to = ends[i + 1] - PLACES};
    hunt->v = v;
    struct lx_integral integral = lx_integrate_panels(&integrand, &panels);
    *error = integral.error + integral.inherited;
    return integral.value;
}

/* A line of an interval, t of the way: where an edge has its top or bottom the integral along lines begins like a root,
 * and is smooth in t with v = from + (to - from) (3 t^2 - 2 t^3). */
static struct lx_point_value at_line(void *data, size_t interval, double t)
{
    struct hunt *hunt = data;
    const double from = hunt->ends[interval], length = hunt->ends[interval + 1] - from;
    const double slope = 6 * t * (1 - t) * length;
    double error = 0, value = slope > 0 ? along_line(hunt, from + length * t * t * (3 - 2 * t), &error) : 0;
    return (struct lx_point_value){.value = slope * value, .error = slope * error};
}

/* ---- the whole ---- */

/* Notes where a source stands above the plane, where there the rule begins a panel. */
static void note_foot(struct hunt *hunt, const double position_mm[3])
{
    const struct lx_cells *cells = hunt->plane.cells;
    lx_bounded3 at = above_plane(&hunt->plane, position_mm);
    const double feet[2] = {at.x.value / cells->size_mm[0], at.y.value / cells->size_mm[1]};
    for (int side = 0; side < 2; side++) {
        size_t count = hunt->foot_count[side];
        bool is_known = count == MOST_FEET || !(fabs(feet[side]) < 0.5);
        for (size_t i = 0; i < count && !is_known; i++)
            is_known = fabs(hunt->feet[side][i] - feet[side]) < 1e-6;
        if (!is_known)
            hunt->feet[side][hunt->foot_count[side]++] = feet[side];
    }
}

/* Notes where the axis of a source with a beam meets the plane. */
static void note_aim(struct hunt *hunt, const struct lx_emitter *emitter)
{
    const struct lx_profile *profile = &emitter->profile;
    lx_bounded3 at = above_plane(&hunt->plane, emitter->position_mm);
    double fall = -lx_dot3(profile->axis, hunt->plane.normal).value, met[3];
    const double axis[3] = {profile->axis.x.value, profile->axis.y.value, profile->axis.z.value};
    if (lx_profile_is_isotropic(profile) || !(fall > 0 && at.z.value > 0))
        return;
    for (int i = 0; i < 3; i++)
        met[i] = emitter->position_mm[i] + at.z.value / fall * axis[i];
    note_foot(hunt, met);
}

static void add_hard(struct hunt *hunt, size_t i, const struct lx_emitter *emitter, bool may_be_hidden)
{
    hunt->hard[hunt->hard_count++] = i;
    if (emitter->type == LX_POINT) {
        note_foot(hunt, emitter->position_mm);
        note_aim(hunt, emitter);
    } else if (emitter->type == LX_FACETS)
        note_foot(hunt, emitter->facets->center_mm);
    else if (lx_is_extended(emitter))
        note_foot(hunt, emitter->center_mm);
    hunt->work_each += !lx_is_extended(emitter)                                         ? 1
                       : may_be_hidden                                                  ? HIDDEN_WORK
                       : emitter->type == LX_FACETS && emitter->facets->face_count == 1 ? POLYGON_WORK
                                                                                        : ROUND_WORK;
}

/* Sums the closed forms, and lists the others. */
static lx_bounded sum_closed(struct hunt *hunt)
{
    const struct lx_emitters *emitters = &hunt->prepared->emitters;
    lx_bounded sum = lx_exact(0);
    for (size_t i = 0; i < emitters->count && !hunt->stopped; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        lx_bounded flux;
        const bool may_hide = may_be_hidden(hunt, emitter);
        hunt->stopped = !lx_asking_at_step(hunt->asking, i, 64);
        if (!may_hide && in_closed_form(&hunt->plane, emitter, &flux)) {
            sum = lx_add(sum, flux);
            continue;
        }
        /* sources of some size have no edges, but a penumbra */
        lx_edges_add(hunt->prepared, hunt->plane.cells, emitter, may_hide && !lx_is_extended(emitter), &hunt->edges);
        add_hard(hunt, i, emitter, may_hide);
    }
    return sum;
}

static lx_bounded integrate(struct hunt *hunt)
{
    struct lx_integrand integrand = {.at = at_line, .target = target, .data = hunt};
    struct lx_panel items[MOST_PANELS];
    struct lx_panels panels = {.items = items, .capacity = MOST_PANELS};
    size_t count = lx_edges_turn(&hunt->edges, hunt->ends, MOST_ENDS - MOST_FEET);
    count = sort_ends(hunt, 1, hunt->ends, count);
    for (size_t i = 0; i + 1 < count; i++)
        if (hunt->ends[i + 1] - hunt->ends[i] > PLACES)
            items[panels.count++] = (struct lx_panel){.interval = i, .from = 0, .to = 1};
    struct lx_integral integral = lx_integrate_panels(&integrand, &panels);
    double places = hunt->edges.count > 0 ? 8 * (double)count * PLACES * fmax(integral.value, hunt->scale) : 0;
    lx_bounded mean = {integral.value, integral.error + integral.inherited + places};
    return lx_mul(mean, area_m2(hunt->plane.cells));
}

struct lx_flux lx_plane_flux(const struct lx_prepared *prepared, const struct lx_cells *plane, double usual,
                             const struct lx_asking *asking)
{
    const struct lx_lobe lobe = lx_lobe_irradiance();
    struct lx_panel line[MOST_PANELS];
    struct hunt hunt = {
        .prepared = prepared,
        .asking = asking,
        .plane = {plane, lx_wide3_direction(plane->pose.across), lx_wide3_direction(plane->pose.upward),
                  lx_wide3_direction(plane->pose.axis)},
        .lobe = &lobe,
        .hard = lx_new_array(prepared->emitters.count, sizeof *hunt.hard),
        .scale = usual,
        .line = line,
    };
    if (!hunt.hard)
        return (struct lx_flux){.is_known = false};
    struct lx_flux flux = {.value = sum_closed(&hunt)};
    if (hunt.hard_count > 0)
        flux.value = lx_add(flux.value, integrate(&hunt));
    flux.is_known = !hunt.touches && !hunt.stopped;
    free(hunt.hard);
    return flux;
}

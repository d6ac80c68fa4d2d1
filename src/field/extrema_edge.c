/* SPDX-License-Identifier: MIT */
/* Edges: where what is seen of a surface ends, and where what it gives jumps or has a kink. */

#include "../base/memory.h"
#include "../light/solid/extended.h"
#include "extrema.h"

/* Roundings of the coordinates that may stand beyond an edge. */
static const double SLACK = 1e-13;

static const struct lx_emitter *emitter_of(const struct lx_extremum_search *search, const struct lx_search_edge *edge,
                                           struct lx_emitter *room)
{
    return lx_emitter_at(&search->prepared->emitters, edge->emitter, room);
}

static bool add(struct lx_extremum_search *search, struct lx_search_edge edge)
{
    if (lx_reserve(&search->edges, &search->edge_capacity, search->edge_count + 1, sizeof edge)) {
        search->short_of_memory = true;
        return false;
    }
    search->edges[search->edge_count++] = edge;
    return true;
}

static bool add_walls(struct lx_extremum_search *search, size_t surface)
{
    const struct lx_prepared *prepared = search->prepared;
    const unsigned walls = prepared->surfaces[surface].shape.kind->chart->walls;
    const struct lx_origin eye = lx_eye_of(search);
    bool done = true;
    unsigned region_sides = !search->region                                  ? 0
                            : search->region->type == LUXEL_REGION_RECTANGLE ? 4
                            : search->region->type == LUXEL_REGION_CIRCLE    ? 1
                                                                             : 0;
    for (unsigned i = 0; done && i < (walls > 4 ? walls : 4); i++) {
        done = i >= walls || add(search, (struct lx_search_edge){.type = LX_EDGE_RIM, .side = i, .closed = true});
        done =
            done && (i >= 4 || add(search, (struct lx_search_edge){.type = LX_EDGE_SCREEN, .side = i, .closed = true}));
        if (i < region_sides)
            done = done && add(search, (struct lx_search_edge){.type = LX_EDGE_REGION, .side = i, .closed = true});
    }
    for (size_t i = 0; done && i < prepared->surface_count; i++)
        if (i != surface && lx_shape_faces(&prepared->surfaces[i].shape, &eye))
            done = add(search, (struct lx_search_edge){.type = LX_EDGE_HIDDEN, .surface = i});
    return done;
}

/* Lines of a luminaire's table beyond so many are walked over: a climb looks at all edges at every step. */
enum { MOST_BREAKS = 64 };

/* Where a profile jumps or has a kink. */
static bool add_breaks(struct lx_extremum_search *search, const struct lx_profile *profile, struct lx_search_edge edge)
{
    struct lx_break place;
    bool done = true;
    for (edge.place = 0; done && lx_profile_break(profile, edge.place, &place); edge.place++) {
        edge.type = place.shape == LX_BREAK_CONE ? LX_EDGE_CONE : LX_EDGE_PATTERN;
        if (place.order != LX_BEND && (edge.place < MOST_BREAKS || place.order == LX_JUMP))
            done = add(search, edge);
    }
    return done;
}

/* The edges of a light that comes from one place or direction. */
static bool add_light(struct lx_extremum_search *search, size_t surface, size_t index)
{
    const struct lx_prepared *prepared = search->prepared;
    struct lx_emitter room;
    const struct lx_emitter *emitter = lx_emitter_at(&prepared->emitters, index, &room);
    const struct lx_lobe *lobe = &prepared->surfaces[surface].lobe;
    struct lx_search_edge edge = {.emitter = index, .closed = true};
    bool done = true, casts = prepared->shadows;
    for (size_t i = 0; casts && done && i < prepared->surface_count; i++) {
        edge.type = LX_EDGE_SHADOW, edge.surface = i;
        done = !lx_may_hide(&prepared->surfaces[i].shape, i == surface) || add(search, edge);
    }
    edge.type = LX_EDGE_TERMINATOR, edge.closed = false;
    done = done && add(search, edge);
    edge.type = LX_EDGE_LOBE, edge.closed = true;
    if (lx_lobe_shines(lobe) && lx_lobe_kind_of(lobe)->end && lobe->exponent < 2)
        done = done && add(search, edge);
    if (!lx_is_point(emitter))
        return done;
    return done && add_breaks(search, &emitter->profile, edge);
}

bool lx_edges_of(struct lx_extremum_search *search, size_t surface)
{
    const struct lx_emitters *emitters = &search->prepared->emitters;
    if (search->edge_count > 0 && search->edged == surface)
        return !search->short_of_memory;
    search->edge_count = 0;
    search->edged = surface;
    bool done = add_walls(search, surface);
    for (size_t i = 0; done && search->knows_lights && i < emitters->count; i++) {
        struct lx_emitter room;
        if (lx_has_one_way(lx_emitter_at(emitters, i, &room)))
            done = add_light(search, surface, i);
    }
    if (done && lx_reserve(&search->sides, &search->side_capacity, search->edge_count, sizeof *search->sides)) {
        search->short_of_memory = true;
        done = false;
    }
    return done;
}

static double beside(const struct lx_extremum_search *search, size_t surface, const double place[3],
                     const double way[3], bool endless)
{
    const struct lx_shape *shape = &search->prepared->surfaces[surface].shape;
    return shape->kind->beside(shape, place, way, endless);
}

/* How far inside of a side of a rectangle: left, right, lower, upper. */
static double from_side(unsigned side, const double place[2], const double center[2], const double half[2])
{
    double offset = place[side / 2] - center[side / 2];
    return half[side / 2] + (side % 2 ? -offset : offset);
}

static double wall_distance(const struct lx_extremum_search *search, const struct lx_search_edge *edge,
                            const struct lx_spot *spot, const double place[3])
{
    const struct lx_shape *shape = lx_spot_shape(search, spot);
    const struct lx_screen *screen = &search->prepared->scene->screen;
    double seen[2];
    if (edge->type == LX_EDGE_RIM) {
        const struct lx_origin eye = lx_eye_of(search);
        return shape->kind->chart->wall(shape, &eye, edge->side, spot->at);
    }
    if (edge->type == LX_EDGE_HIDDEN) {
        const struct lx_origin eye = lx_eye_of(search);
        return lx_shape_beside_sight(&search->prepared->surfaces[edge->surface].shape, place, &eye);
    }
    lx_screen_of(search, place, seen);
    if (edge->type == LX_EDGE_SCREEN)
        return from_side(edge->side, seen, (double[]){0, 0}, (double[]){screen->width_mm / 2, screen->height_mm / 2});
    const luxel_region *region = search->region;
    if (region->type == LUXEL_REGION_CIRCLE)
        return region->radius_mm - hypot(seen[0] - region->center_mm[0], seen[1] - region->center_mm[1]);
    return from_side(edge->side, seen, region->center_mm, (double[]){region->size_mm[0] / 2, region->size_mm[1] / 2});
}

/* How far inside of a break of a profile, along its distance from the light. */
static double inside_break(const struct lx_search_edge *edge, const struct lx_emitter *emitter, const double way[3],
                           double size_mm)
{
    struct lx_break place = {.angle_rad = 0};
    double cross[3], length = sqrt(lx_dot(way, way));
    lx_profile_break(&emitter->profile, edge->place, &place);
    if (place.shape == LX_BREAK_PLANE)
        return -size_mm * (lx_dot(place.axis, way) / length);
    const double *other = place.shape == LX_BREAK_CONE ? way : place.begin;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        cross[i] = place.axis[j] * other[k] - place.axis[k] * other[j];
    }
    if (place.shape == LX_BREAK_HALF_PLANE) /* the whole plane */
        return -lx_dot(cross, way);
    return length * (place.angle_rad - atan2(sqrt(lx_dot(cross, cross)), -lx_dot(place.axis, way)));
}

static double light_distance(const struct lx_extremum_search *search, const struct lx_search_edge *edge,
                             const struct lx_spot *spot, const double place[3], const double normal[3])
{
    struct lx_emitter room;
    const struct lx_emitter *emitter = emitter_of(search, edge, &room);
    double size_mm = lx_spot_shape(search, spot)->radius_mm, way[3], view[3];
    const bool endless = lx_is_endless(emitter);
    lx_emitter_origin(emitter, way);
    for (int i = 0; i < 3 && !endless; i++)
        way[i] -= place[i];
    if (edge->type == LX_EDGE_SHADOW)
        return beside(search, edge->surface, place, way, endless);
    if (edge->type == LX_EDGE_CONE || edge->type == LX_EDGE_PATTERN)
        return inside_break(edge, emitter, way, size_mm);
    lx_normalize(way);
    if (edge->type == LX_EDGE_TERMINATOR)
        return size_mm * lx_dot(normal, way);
    const struct lx_element element = lx_spot_element(search, spot);
    struct lx_lobe_at at;
    double limit;
    lx_values3(element.view, view);
    lx_lobe_at_set(normal, view, &at);
    const double *end = lx_lobe_kind_of(element.lobe)->end(&at, &limit);
    return size_mm * (lx_dot(end, way) - limit);
}

double lx_edge_distance(const struct lx_extremum_search *search, const struct lx_search_edge *edge,
                        const struct lx_spot *spot)
{
    double place[3], normal[3];
    lx_spot_place(search, spot, place, normal);
    return lx_edge_is_wall(edge) ? wall_distance(search, edge, spot, place)
                                 : light_distance(search, edge, spot, place, normal);
}

bool lx_edges_enter(struct lx_extremum_search *search, const struct lx_spot *spot)
{
    if (!lx_edges_of(search, spot->surface))
        return false;
    for (size_t i = 0; i < search->edge_count; i++) {
        const struct lx_search_edge *edge = &search->edges[i];
        double distance = lx_edge_distance(search, edge, spot);
        if (lx_edge_is_wall(edge) && !(distance >= -search->scale_mm * SLACK))
            return false;
        bool inside = lx_edge_is_wall(edge) || distance > 0 || (distance == 0 && edge->closed);
        search->sides[i] = inside ? 1 : -1;
    }
    return true;
}

/* How the distance to an edge changes along the chart. */
static void gradient(const struct lx_extremum_search *search, const struct lx_search_edge *which,
                     const struct lx_spot *spot, const struct lx_chart *chart, double slope[2])
{
    double step = 1e-6 * lx_spot_shape(search, spot)->radius_mm;
    for (int i = 0; i < 2; i++) {
        double ahead[2] = {0, 0}, back[2] = {0, 0};
        ahead[i] = step, back[i] = -step;
        struct lx_spot a = lx_spot_moved(search, spot, chart, ahead), b = lx_spot_moved(search, spot, chart, back);
        slope[i] = (lx_edge_distance(search, which, &a) - lx_edge_distance(search, which, &b)) / (2 * step);
    }
}

bool lx_edge_inward(const struct lx_extremum_search *search, size_t which, const struct lx_spot *spot,
                    const struct lx_chart *chart, double inward[2])
{
    gradient(search, &search->edges[which], spot, chart, inward);
    double length = search->sides[which] * hypot(inward[0], inward[1]);
    if (!(fabs(length) > 1e-9 && isfinite(length)))
        return false;
    inward[0] /= length, inward[1] /= length;
    return true;
}

bool lx_edge_reach(const struct lx_extremum_search *search, size_t which, struct lx_spot *spot)
{
    const struct lx_search_edge *it = &search->edges[which];
    double distance = lx_edge_distance(search, it, spot);
    for (int tries = 0; tries < 12 && distance != 0; tries++) {
        struct lx_chart chart = lx_spot_chart(search, spot);
        double slope[2];
        gradient(search, it, spot, &chart, slope);
        double share = -distance / (slope[0] * slope[0] + slope[1] * slope[1]);
        double step[2] = {share * slope[0], share * slope[1]};
        if (!(hypot(step[0], step[1]) < lx_spot_shape(search, spot)->radius_mm))
            return false;
        struct lx_spot moved = lx_spot_moved(search, spot, &chart, step);
        double left = lx_edge_distance(search, it, &moved);
        if (!(fabs(left) < fabs(distance)))
            break;
        *spot = moved;
        distance = left;
    }
    return fabs(distance) <= 10 * SLACK * search->scale_mm;
}

void lx_edges_meet(const struct lx_extremum_search *search, const size_t edges[2], struct lx_spot *spot)
{
    const struct lx_search_edge *one = &search->edges[edges[0]], *other = &search->edges[edges[1]];
    double a = lx_edge_distance(search, one, spot), b = lx_edge_distance(search, other, spot);
    for (int tries = 0; tries < 6; tries++) {
        struct lx_chart chart = lx_spot_chart(search, spot);
        double p[2], q[2];
        gradient(search, one, spot, &chart, p);
        gradient(search, other, spot, &chart, q);
        double area = p[0] * q[1] - p[1] * q[0];
        double step[2] = {(p[1] * b - q[1] * a) / area, (q[0] * a - p[0] * b) / area};
        if (!(hypot(step[0], step[1]) < 1e-6 * lx_spot_shape(search, spot)->radius_mm))
            return;
        struct lx_spot moved = lx_spot_moved(search, spot, &chart, step);
        double a_left = lx_edge_distance(search, one, &moved), b_left = lx_edge_distance(search, other, &moved);
        if (!(hypot(a_left, b_left) < hypot(a, b)))
            return;
        *spot = moved;
        a = a_left, b = b_left;
    }
}

/* What the edges say of an emitter, from the first one of it at *next on. */
struct verdict {
    bool dark, whole_cone, gate_open, gate_shut;
};

static struct verdict judge(const struct lx_extremum_search *search, const struct lx_lobe *lobe, size_t emitter,
                            size_t *next)
{
    struct verdict verdict = {.dark = false};
    while (*next < search->edge_count &&
           (lx_edge_is_wall(&search->edges[*next]) || search->edges[*next].emitter < emitter))
        ++*next;
    for (; *next < search->edge_count && search->edges[*next].emitter == emitter; ++*next) {
        const struct lx_search_edge *edge = &search->edges[*next];
        bool inside = search->sides[*next] > 0;
        struct lx_emitter room;
        bool hard = edge->type == LX_EDGE_CONE && emitter_of(search, edge, &room)->profile.falloff == LX_HARD;
        if (edge->type == LX_EDGE_SHADOW || hard)
            verdict.dark |= !inside;
        verdict.whole_cone |= hard && inside;
        if (edge->type == LX_EDGE_TERMINATOR && LX_JUMPS_AT_HORIZON(lobe->highlight)) {
            verdict.gate_open = inside;
            verdict.gate_shut = !inside;
        }
    }
    return verdict;
}

double lx_piece_value(struct lx_extremum_search *search, const struct lx_spot *spot, double *error)
{
    const struct lx_prepared *bare = &search->bare;
    struct lx_element element = lx_spot_element(search, spot);
    const struct lx_lobe *lobe = element.lobe;
    const struct lx_gates *gates = &search->gates[spot->surface];
    bool is_irradiance = search->evaluator->settings.quantity == LUXEL_IRRADIANCE;
    lx_bounded total = lx_exact(0);
    size_t next = 0;
    *error = 0;
    if (!lx_search_goes_on(search))
        return (double)NAN;
    for (size_t i = 0; i < bare->emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&bare->emitters, i, &room);
        struct verdict verdict = judge(search, lobe, i, &next);
        if (verdict.dark)
            continue;
        struct lx_emitter changed;
        if (verdict.whole_cone) {
            changed = *emitter;
            changed.profile.falloff = LX_NO_CONE;
            emitter = &changed;
        }
        element.lobe = verdict.gate_open ? &gates->open : is_irradiance || verdict.gate_shut ? &gates->shut : lobe;
        struct lx_lighting lighting = lx_light_element(bare, &element, emitter);
        if (lighting.on_element)
            return (double)NAN;
        total = lx_add(total, is_irradiance ? lighting.irradiance : lx_add(lighting.diffuse, lighting.specular));
    }
    *error = total.error;
    return search->sign * total.value;
}

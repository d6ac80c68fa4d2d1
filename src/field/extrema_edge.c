/* SPDX-License-Identifier: MIT */
/* Edges: where what is seen of a surface ends, and where what it gives jumps or has a kink. */
#include <string.h>

#include "../base/memory.h"
#include "../light/solid/extended.h"
#include "extrema.h"

/* Roundings of the coordinates that may stand beyond an edge. */
static const double SLACK = 1e-13;

static const struct lx_emitter *emitter_of(const struct lx_hunt *hunt, const struct lx_brink *edge,
                                           struct lx_emitter *room)
{
    return lx_emitter_at(&hunt->prepared->emitters, edge->emitter, room);
}

static bool add(struct lx_hunt *hunt, struct lx_brink edge)
{
    if (lx_reserve(&hunt->brinks, &hunt->brink_capacity, hunt->brink_count + 1, sizeof edge)) {
        hunt->short_of_memory = true;
        return false;
    }
    hunt->brinks[hunt->brink_count++] = edge;
    return true;
}

static bool add_walls(struct lx_hunt *hunt, size_t surface)
{
    const struct lx_prepared *prepared = hunt->prepared;
    const unsigned walls = prepared->surfaces[surface].shape.kind->chart->walls;
    const struct lx_origin eye = lx_eye_of(hunt);
    bool done = true;
    unsigned region_sides = !hunt->region                                  ? 0
                            : hunt->region->type == LUXEL_REGION_RECTANGLE ? 4
                            : hunt->region->type == LUXEL_REGION_CIRCLE    ? 1
                                                                           : 0;
    for (unsigned i = 0; done && i < (walls > 4 ? walls : 4); i++) {
        done = i >= walls || add(hunt, (struct lx_brink){.type = LX_BRINK_RIM, .side = i, .closed = true});
        done = done && (i >= 4 || add(hunt, (struct lx_brink){.type = LX_BRINK_SCREEN, .side = i, .closed = true}));
        if (i < region_sides)
            done = done && add(hunt, (struct lx_brink){.type = LX_BRINK_REGION, .side = i, .closed = true});
    }
    for (size_t i = 0; done && i < prepared->surface_count; i++)
        if (i != surface && lx_shape_faces(&prepared->surfaces[i].shape, &eye))
            done = add(hunt, (struct lx_brink){.type = LX_BRINK_HIDDEN, .surface = i});
    return done;
}

/* Lines of a luminaire's table beyond so many are walked over: a climb looks at all edges at every step. */
enum { MOST_BREAKS = 64 };

/* Where a profile jumps or has a kink. */
static bool add_breaks(struct lx_hunt *hunt, const struct lx_profile *profile, struct lx_brink edge)
{
    struct lx_break place;
    bool done = true;
    for (edge.place = 0; done && lx_profile_break(profile, edge.place, &place); edge.place++) {
        edge.type = place.shape == LX_BREAK_CONE ? LX_BRINK_CONE : LX_BRINK_PATTERN;
        if (place.order != LX_BEND && (edge.place < MOST_BREAKS || place.order == LX_JUMP))
            done = add(hunt, edge);
    }
    return done;
}

/* The edges of a light that comes from one place or direction. */
static bool add_light(struct lx_hunt *hunt, size_t surface, size_t index)
{
    const struct lx_prepared *prepared = hunt->prepared;
    struct lx_emitter room;
    const struct lx_emitter *emitter = lx_emitter_at(&prepared->emitters, index, &room);
    const struct lx_lobe *lobe = &prepared->surfaces[surface].lobe;
    struct lx_brink edge = {.emitter = index, .closed = true};
    bool done = true, casts = prepared->shadows;
    for (size_t i = 0; casts && done && i < prepared->surface_count; i++) {
        edge.type = LX_BRINK_SHADOW, edge.surface = i;
        done = !lx_may_hide(&prepared->surfaces[i].shape, i == surface) || add(hunt, edge);
    }
    edge.type = LX_BRINK_TERMINATOR, edge.closed = false;
    done = done && add(hunt, edge);
    edge.type = LX_BRINK_LOBE, edge.closed = true;
    if (lx_lobe_shines(lobe) && lx_lobe_kind_of(lobe)->end && lobe->exponent < 2)
        done = done && add(hunt, edge);
    if (!lx_is_point(emitter))
        return done;
    return done && add_breaks(hunt, &emitter->profile, edge);
}

bool lx_brinks_of(struct lx_hunt *hunt, size_t surface)
{
    const struct lx_emitters *emitters = &hunt->prepared->emitters;
    if (hunt->brink_count > 0 && hunt->edged == surface)
        return !hunt->short_of_memory;
    hunt->brink_count = 0;
    hunt->edged = surface;
    bool done = add_walls(hunt, surface);
    for (size_t i = 0; done && hunt->knows_lights && i < emitters->count; i++) {
        struct lx_emitter room;
        if (lx_has_one_way(lx_emitter_at(emitters, i, &room)))
            done = add_light(hunt, surface, i);
    }
    if (done && lx_reserve(&hunt->sides, &hunt->side_capacity, hunt->brink_count, sizeof *hunt->sides)) {
        hunt->short_of_memory = true;
        done = false;
    }
    return done;
}

static double beside(const struct lx_hunt *hunt, size_t surface, const double place[3], const double way[3],
                     bool endless)
{
    const struct lx_shape *shape = &hunt->prepared->surfaces[surface].shape;
    return shape->kind->beside(shape, place, way, endless);
}

/* How far inside of a side of a rectangle: left, right, lower, upper. */
static double from_side(unsigned side, const double place[2], const double center[2], const double half[2])
{
    double offset = place[side / 2] - center[side / 2];
    return half[side / 2] + (side % 2 ? -offset : offset);
}

static double wall_distance(const struct lx_hunt *hunt, const struct lx_brink *edge, const struct lx_spot *spot,
                            const double place[3])
{
    const struct lx_shape *shape = lx_spot_shape(hunt, spot);
    const struct lx_screen *screen = &hunt->prepared->scene->screen;
    double seen[2];
    if (edge->type == LX_BRINK_RIM) {
        const struct lx_origin eye = lx_eye_of(hunt);
        return shape->kind->chart->wall(shape, &eye, edge->side, spot->at);
    }
    if (edge->type == LX_BRINK_HIDDEN) {
        const struct lx_origin eye = lx_eye_of(hunt);
        return lx_shape_veils(&hunt->prepared->surfaces[edge->surface].shape, place, &eye);
    }
    lx_screen_of(hunt, place, seen);
    if (edge->type == LX_BRINK_SCREEN)
        return from_side(edge->side, seen, (double[]){0, 0}, (double[]){screen->width_mm / 2, screen->height_mm / 2});
    const luxel_region *region = hunt->region;
    if (region->type == LUXEL_REGION_CIRCLE)
        return region->radius_mm - hypot(seen[0] - region->center_mm[0], seen[1] - region->center_mm[1]);
    return from_side(edge->side, seen, region->center_mm, (double[]){region->size_mm[0] / 2, region->size_mm[1] / 2});
}

static void values_of(const lx_bounded3 *from, double to[3])
{
    to[0] = from->x.value, to[1] = from->y.value, to[2] = from->z.value;
}

/* How far inside of a break of a profile, along its distance from the light. */
static double inside_break(const struct lx_brink *edge, const struct lx_emitter *emitter, const double way[3],
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

static double light_distance(const struct lx_hunt *hunt, const struct lx_brink *edge, const struct lx_spot *spot,
                             const double place[3], const double normal[3])
{
    struct lx_emitter room;
    const struct lx_emitter *emitter = emitter_of(hunt, edge, &room);
    double size_mm = lx_spot_shape(hunt, spot)->radius_mm, way[3], view[3];
    const bool endless = lx_is_endless(emitter);
    lx_emitter_origin(emitter, way);
    for (int i = 0; i < 3 && !endless; i++)
        way[i] -= place[i];
    if (edge->type == LX_BRINK_SHADOW)
        return beside(hunt, edge->surface, place, way, endless);
    if (edge->type == LX_BRINK_CONE || edge->type == LX_BRINK_PATTERN)
        return inside_break(edge, emitter, way, size_mm);
    lx_normalize(way);
    if (edge->type == LX_BRINK_TERMINATOR)
        return size_mm * lx_dot(normal, way);
    const struct lx_element element = lx_spot_element(hunt, spot);
    struct lx_lobe_at at;
    double limit;
    values_of(&element.view, view);
    lx_lobe_at_set(normal, view, &at);
    const double *end = lx_lobe_kind_of(element.lobe)->end(&at, &limit);
    return size_mm * (lx_dot(end, way) - limit);
}

double lx_brink_distance(const struct lx_hunt *hunt, const struct lx_brink *edge, const struct lx_spot *spot)
{
    double place[3], normal[3];
    lx_spot_place(hunt, spot, place, normal);
    return lx_brink_is_wall(edge) ? wall_distance(hunt, edge, spot, place)
                                  : light_distance(hunt, edge, spot, place, normal);
}

bool lx_brinks_enter(struct lx_hunt *hunt, const struct lx_spot *spot)
{
    if (!lx_brinks_of(hunt, spot->surface))
        return false;
    for (size_t i = 0; i < hunt->brink_count; i++) {
        const struct lx_brink *edge = &hunt->brinks[i];
        double distance = lx_brink_distance(hunt, edge, spot);
        if (lx_brink_is_wall(edge) && !(distance >= -hunt->scale_mm * SLACK))
            return false;
        bool inside = lx_brink_is_wall(edge) || distance > 0 || (distance == 0 && edge->closed);
        hunt->sides[i] = inside ? 1 : -1;
    }
    return true;
}

/* How the distance to a brink changes along the chart. */
static void gradient(const struct lx_hunt *hunt, const struct lx_brink *brink, const struct lx_spot *spot,
                     const struct lx_chart *chart, double slope[2])
{
    double step = 1e-6 * lx_spot_shape(hunt, spot)->radius_mm;
    for (int i = 0; i < 2; i++) {
        double ahead[2] = {0, 0}, back[2] = {0, 0};
        ahead[i] = step, back[i] = -step;
        struct lx_spot a = lx_spot_moved(hunt, spot, chart, ahead), b = lx_spot_moved(hunt, spot, chart, back);
        slope[i] = (lx_brink_distance(hunt, brink, &a) - lx_brink_distance(hunt, brink, &b)) / (2 * step);
    }
}

bool lx_brink_inward(const struct lx_hunt *hunt, size_t brink, const struct lx_spot *spot, const struct lx_chart *chart,
                     double inward[2])
{
    gradient(hunt, &hunt->brinks[brink], spot, chart, inward);
    double length = hunt->sides[brink] * hypot(inward[0], inward[1]);
    if (!(fabs(length) > 1e-9 && isfinite(length)))
        return false;
    inward[0] /= length, inward[1] /= length;
    return true;
}

bool lx_brink_reach(const struct lx_hunt *hunt, size_t brink, struct lx_spot *spot)
{
    const struct lx_brink *it = &hunt->brinks[brink];
    double distance = lx_brink_distance(hunt, it, spot);
    for (int tries = 0; tries < 12 && distance != 0; tries++) {
        struct lx_chart chart = lx_spot_chart(hunt, spot);
        double slope[2];
        gradient(hunt, it, spot, &chart, slope);
        double share = -distance / (slope[0] * slope[0] + slope[1] * slope[1]);
        double step[2] = {share * slope[0], share * slope[1]};
        if (!(hypot(step[0], step[1]) < lx_spot_shape(hunt, spot)->radius_mm))
            return false;
        struct lx_spot moved = lx_spot_moved(hunt, spot, &chart, step);
        double left = lx_brink_distance(hunt, it, &moved);
        if (!(fabs(left) < fabs(distance)))
            break;
        *spot = moved;
        distance = left;
    }
    return fabs(distance) <= 10 * SLACK * hunt->scale_mm;
}

void lx_brinks_meet(const struct lx_hunt *hunt, const size_t brinks[2], struct lx_spot *spot)
{
    const struct lx_brink *one = &hunt->brinks[brinks[0]], *other = &hunt->brinks[brinks[1]];
    double a = lx_brink_distance(hunt, one, spot), b = lx_brink_distance(hunt, other, spot);
    for (int tries = 0; tries < 6; tries++) {
        struct lx_chart chart = lx_spot_chart(hunt, spot);
        double p[2], q[2];
        gradient(hunt, one, spot, &chart, p);
        gradient(hunt, other, spot, &chart, q);
        double area = p[0] * q[1] - p[1] * q[0];
        double step[2] = {(p[1] * b - q[1] * a) / area, (q[0] * a - p[0] * b) / area};
        if (!(hypot(step[0], step[1]) < 1e-6 * lx_spot_shape(hunt, spot)->radius_mm))
            return;
        struct lx_spot moved = lx_spot_moved(hunt, spot, &chart, step);
        double a_left = lx_brink_distance(hunt, one, &moved), b_left = lx_brink_distance(hunt, other, &moved);
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

static struct verdict judge(const struct lx_hunt *hunt, const struct lx_lobe *lobe, size_t emitter, size_t *next)
{
    struct verdict verdict = {.dark = false};
    while (*next < hunt->brink_count &&
           (lx_brink_is_wall(&hunt->brinks[*next]) || hunt->brinks[*next].emitter < emitter))
        ++*next;
    for (; *next < hunt->brink_count && hunt->brinks[*next].emitter == emitter; ++*next) {
        const struct lx_brink *edge = &hunt->brinks[*next];
        bool inside = hunt->sides[*next] > 0;
        struct lx_emitter room;
        bool hard = edge->type == LX_BRINK_CONE && emitter_of(hunt, edge, &room)->profile.falloff == LX_HARD;
        if (edge->type == LX_BRINK_SHADOW || hard)
            verdict.dark |= !inside;
        verdict.whole_cone |= hard && inside;
        if (edge->type == LX_BRINK_TERMINATOR && LX_JUMPS_AT_HORIZON(lobe->highlight)) {
            verdict.gate_open = inside;
            verdict.gate_shut = !inside;
        }
    }
    return verdict;
}

double lx_piece_value(struct lx_hunt *hunt, const struct lx_spot *spot, double *error)
{
    const struct lx_prepared *bare = &hunt->bare;
    struct lx_element element = lx_spot_element(hunt, spot);
    const struct lx_lobe *lobe = element.lobe;
    const struct lx_gates *gates = &hunt->gates[spot->surface];
    bool is_irradiance = hunt->evaluator->settings.quantity == LUXEL_IRRADIANCE;
    lx_bounded total = lx_exact(0);
    size_t next = 0;
    *error = 0;
    if (!lx_hunt_goes_on(hunt))
        return (double)NAN;
    for (size_t i = 0; i < bare->emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&bare->emitters, i, &room);
        struct verdict verdict = judge(hunt, lobe, i, &next);
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
    return hunt->sign * total.value;
}

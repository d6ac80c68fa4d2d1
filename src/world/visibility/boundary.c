/* SPDX-License-Identifier: MIT */
/*
 * The pieces of curves that bound what is seen: each curve is walked between the places where it crosses any other, and
 * each piece is tried at its middle.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/larger.h"
#include "../../base/vector.h"
#include "../../light/solid/extended.h"
#include "boundary_ends.h"

enum { MOST_CROSSINGS = 4 * (LX_BOUNDARY_SIDES + LX_BOUNDARY_OBSTACLE_SIDES) };

/* Directions that are nearer than this to a curve lie on it. */
static const double ON = 1e-12;

/* Curves that come no nearer to each other's inside than this touch each other, as the parts of a cylinder do. */
static const double TOUCHING = 4e-15;

/* ---- crossings ---- */

void lx_boundary_place(const struct lx_boundary_side *side, double t, double u[3])
{
    const double c = side->is_circle ? cos(t) : 0, s = side->is_circle ? sin(t) : 0;
    for (int k = 0; k < 3; k++)
        u[k] = side->is_circle ? side->limit * side->g[k] + side->sine * (c * side->p[k] + s * side->q[k])
                               : side->from[k] + t * (side->to[k] - side->from[k]);
}

enum { MOST_OF_TWO = 4 };

/* a0 + a1 cos t + b1 sin t + a2 cos 2t + b2 sin 2t */
struct waves {
    double a0, a1, b1, a2, b2;
};

enum { DEGREE = 4 };

static double value_of(const double *terms, int degree, double z)
{
    double value = terms[degree];
    for (int k = degree - 1; k >= 0; k--)
        value = value * z + terms[k];
    return value;
}

/* The root of a polynomial between places where it has different signs, and its slope has one. */
static double find_root(const double *terms, const double *slopes, int degree, double from, double to)
{
    enum { STEPS = 80 };
    const bool positive = value_of(terms, degree, from) > 0;
    double z = from + (to - from) / 2;
    for (int i = 0; i < STEPS && to > from; i++) {
        const double value = value_of(terms, degree, z);
        *((value > 0) == positive ? &from : &to) = z;
        const double next = z - value / value_of(slopes, degree - 1, z); /* Newton's, where it stays within */
        const bool is_good = next >= from && next <= to;
        if (is_good && fabs(next - z) < 1e-16)
            return next;
        z = is_good && i % 4 != 3 ? next : from + (to - from) / 2;
    }
    return z;
}

/* All roots of a polynomial between -1 and 1, in their order: one at most between two neighbours among those of its
 * slope. */
static int find_roots(const double *terms, int degree, double *roots)
{
    double slopes[DEGREE], turns[DEGREE + 1];
    int count = 0;
    if (degree == 0)
        return 0;
    for (int k = 0; k < degree; k++)
        slopes[k] = (k + 1) * terms[k + 1];
    const int turn_count = find_roots(slopes, degree - 1, turns);
    turns[turn_count] = 1;
    double from = -1;
    for (int i = 0; i <= turn_count; i++) {
        if ((value_of(terms, degree, from) > 0) != (value_of(terms, degree, turns[i]) > 0))
            roots[count++] = find_root(terms, slopes, degree, from, turns[i]);
        from = turns[i];
    }
    return count;
}

/* Where they are 0 within a turn: of each half of it as polynomials of the tangent of half the angle. */
static unsigned find_zeros(const struct waves *waves, double *at)
{
    unsigned count = 0;
    for (int half = 0; half < 2; half++) {
        const double a1 = half ? -waves->a1 : waves->a1, b1 = half ? -waves->b1 : waves->b1;
        const double terms[DEGREE + 1] = {waves->a0 + a1 + waves->a2, 2 * b1 + 4 * waves->b2,
                                          2 * waves->a0 - 6 * waves->a2, 2 * b1 - 4 * waves->b2,
                                          waves->a0 - a1 + waves->a2};
        double roots[DEGREE];
        const int found = find_roots(terms, DEGREE, roots);
        for (int i = 0; i < found && count < MOST_OF_TWO; i++) {
            const double angle = 2 * atan(roots[i]) + half * M_PI;
            at[count++] = angle < 0 ? angle + 2 * M_PI : angle;
        }
    }
    return count;
}

/* Adds `weight` (row.u)^2 along a closed curve. */
static void add_square(struct waves *waves, const struct lx_boundary_side *side, const double row[3], double weight)
{
    const double m = side->limit * lx_dot(row, side->g), a = side->sine * lx_dot(row, side->p);
    const double b = side->sine * lx_dot(row, side->q);
    waves->a0 += weight * (m * m + (a * a + b * b) / 2);
    waves->a1 += weight * 2 * m * a;
    waves->b1 += weight * 2 * m * b;
    waves->a2 += weight * (a * a - b * b) / 2;
    waves->b2 += weight * a * b;
}

/* Where closed curves cross, one of which at least is a disk's. */
static unsigned cross_curves(const struct lx_boundary_side *side, const struct lx_boundary_side *other, double *at)
{
    static const double units[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct waves waves = {0};
    for (int i = 0; i < 3; i++)
        add_square(&waves, side, other->is_cone ? other->rows[i] : units[i],
                   other->is_cone ? (i == 0 ? 1 : -1) : -other->limit * other->limit);
    if (!other->is_cone)
        add_square(&waves, side, other->g, 1);
    const double swing =
        sqrt(waves.a1 * waves.a1 + waves.b1 * waves.b1) + sqrt(waves.a2 * waves.a2 + waves.b2 * waves.b2);
    return fabs(waves.a0) > swing * (1 + 1e-12) ? 0 : find_zeros(&waves, at);
}

/* Where on a circle, or on the outline of a disk, that of a plane or of a circle is; none where they touch only. */
static unsigned find_angles(const struct lx_boundary_side *side, const struct lx_boundary_side *other, double *at)
{
    /* limit' = g'.u(phi) = a + b cos(phi) + c sin(phi) */
    const double a = side->limit * lx_dot(side->g, other->g) - other->limit;
    const double b = side->sine * lx_dot(side->p, other->g), c = side->sine * lx_dot(side->q, other->g);
    const double reach = hypot(b, c);
    unsigned count = 0;
    if (!(fabs(a) < reach - TOUCHING))
        return 0;
    const double middle = atan2(c, b), half = acos(-a / reach);
    for (int sign = -1; sign <= 1; sign += 2) {
        const double phi = middle + sign * half;
        at[count++] = phi < 0 ? phi + 2 * M_PI : phi >= 2 * M_PI ? phi - 2 * M_PI : phi;
    }
    return count;
}

/* Where a piece of a great circle crosses a circle or the outline of a disk: at the same places as that crosses it. */
static unsigned cross_closed(const struct lx_boundary_side *side, const struct lx_boundary_side *closed, double *at)
{
    double angles[2], turned[3];
    unsigned count = 0;
    const unsigned found = find_angles(closed, side, angles);
    lx_cross(side->from, side->to, turned);
    const double sign = lx_dot(turned, side->g) < 0 ? -1 : 1;
    for (unsigned i = 0; i < found; i++) {
        double u[3];
        lx_boundary_place(closed, angles[i], u);
        lx_cross(side->from, u, turned);
        const double behind = sign * lx_dot(turned, side->g);
        lx_cross(u, side->to, turned);
        const double before = sign * lx_dot(turned, side->g);
        if (behind > 0 && before > 0)
            at[count++] = behind / (behind + before);
    }
    return count;
}

/* Where a side's curve crosses that of another. */
static unsigned find_crossings(const struct lx_boundary_side *side, const struct lx_boundary_side *other, double *at)
{
    if (side->is_circle && (other->is_cone || (side->is_cone && other->limit != 0)))
        return cross_curves(side, other, at);
    if (side->is_circle)
        return find_angles(side, other, at);
    if (other->is_cone || other->limit != 0)
        return cross_closed(side, other, at);
    const double from = lx_dot(other->g, side->from), to = lx_dot(other->g, side->to);
    at[0] = from / (from - to);
    return (from > 0) != (to > 0);
}

/* ---- walking ---- */

/* How far inside of a side's curve a direction of unit length is. */
static double depth_of(const struct lx_boundary_side *side, const double u[3])
{
    if (side->is_cone)
        return lx_dot(side->rows[0], u) - hypot(lx_dot(side->rows[1], u), lx_dot(side->rows[2], u));
    return lx_dot(side->g, u) - side->limit;
}

/* The way inwards from a side's curve, of any length. */
static void find_way_in(const struct lx_boundary_side *side, const double u[3], double way[3])
{
    if (!side->is_cone) {
        memcpy(way, side->g, sizeof side->g);
        return;
    }
    const double y = lx_dot(side->rows[1], u), z = lx_dot(side->rows[2], u), length = hypot(y, z);
    for (int k = 0; k < 3; k++)
        way[k] = side->rows[0][k] - (y * side->rows[1][k] + z * side->rows[2][k]) / length;
}

/* How far inside of a body a direction of unit length is, by the side that is nearest to it. */
static double depth_in(const struct lx_boundary_body *body, const double u[3], const struct lx_boundary_side **nearest)
{
    double depth = HUGE_VAL;
    for (unsigned i = 0; i < body->count; i++) {
        const double inside = depth_of(&body->sides[i], u);
        if (inside < depth) {
            depth = inside;
            *nearest = &body->sides[i];
        }
    }
    return depth;
}

/* Whether sides of one body may cross anywhere but at the ends of a polygon's edges. */
static bool are_to_cross(const struct lx_boundary_side *side, const struct lx_boundary_side *other)
{
    return side != other && (side->is_circle || other->is_circle);
}

/*
 * Whether a piece of a side of body b is a border of what is seen, told by a direction on it.  Where it lies on a side
 * of another body, too, which *is_on tells: next to an obstacle that begins where the source ends nothing is seen; of
 * obstacles that end there the first one counts; between two that meet there is nothing.
 */
static bool is_border_at(const struct lx_boundary *boundary, unsigned b, const struct lx_boundary_side *side,
                         const double u[3], bool *is_on)
{
    const struct lx_boundary_side *nearest = NULL;
    bool is_border = true;
    *is_on = false;
    for (unsigned i = 0; i < boundary->bodies[b].count; i++) {
        const struct lx_boundary_side *own = &boundary->bodies[b].sides[i];
        if (are_to_cross(side, own) && !(depth_of(own, u) > 0))
            return false;
    }
    for (unsigned i = 0; i < boundary->count; i++) {
        if (i == b || boundary->bodies[i].count == 0)
            continue;
        const double depth = depth_in(&boundary->bodies[i], u, &nearest);
        if (i == 0 ? depth < -ON : depth > ON)
            return false;
        if (fabs(depth) > ON)
            continue;
        double way[3], other[3];
        find_way_in(side, u, way);
        find_way_in(nearest, u, other);
        const bool agrees = lx_dot(way, other) > 0;
        *is_on = true;
        is_border = is_border && i > 0 && (b == 0 ? !agrees : agrees && i > b);
    }
    return is_border;
}

/* Whether a piece is one, told in its middle, and elsewhere, too, where it only touches another curve there. */
static bool is_border(const struct lx_boundary *boundary, unsigned b, const struct lx_boundary_side *side, double from,
                      double to)
{
    static const double shares[] = {0.5, 0.3125};
    bool is_one = false, is_on = true;
    for (int i = 0; i < 2 && is_on; i++) {
        double u[3];
        lx_boundary_place(side, from + (to - from) * shares[i], u);
        if (!side->is_circle || side->is_cone)
            lx_normalize(u);
        is_one = is_border_at(boundary, b, side, u, &is_on);
    }
    return is_one;
}

/* A walk along all curves. */
struct walking {
    const struct lx_boundary *boundary;
    lx_take_border *take;
    void *data;
    struct lx_boundary_ends ends;
};

static void walk(struct walking *walking, unsigned b, const struct lx_boundary_side *side)
{
    const struct lx_boundary *boundary = walking->boundary;
    double at[MOST_CROSSINGS + 2];
    unsigned count = 0;
    at[count++] = 0;
    at[count++] = side->is_circle ? 2 * M_PI : 1;
    if (b == 0)
        lx_boundary_ends_overlook(&walking->ends, side, at[1]);
    for (unsigned i = 0; i < boundary->count; i++)
        for (unsigned k = 0; k < boundary->bodies[i].count; k++)
            if (i != b || are_to_cross(side, &boundary->bodies[i].sides[k]))
                count += find_crossings(side, &boundary->bodies[i].sides[k], at + count);
    if (count > 2)
        qsort(at, count, sizeof *at, lx_by_value);
    for (unsigned i = 0; i + 1 < count; i++) {
        const int sign = b == 0 ? 1 : -1;
        if (!(at[i + 1] > at[i]) || !is_border(boundary, b, side, at[i], at[i + 1]))
            continue;
        walking->take(walking->data, side, at[i], at[i + 1], sign);
        lx_boundary_ends_add(&walking->ends, side, at[i], at[i + 1], sign, boundary->error_mm);
    }
}

static void walk_all(struct walking *walking)
{
    for (unsigned b = 0; b < walking->boundary->count; b++)
        for (unsigned i = 0; i < walking->boundary->bodies[b].count; i++)
            walk(walking, b, &walking->boundary->bodies[b].sides[i]);
}

/* Walks around what is seen, of that through each end of a pipe around the element; the source has room for a side. */
static void walk_from_inside(struct walking *walking, struct lx_boundary *boundary)
{
    struct lx_boundary_body *source = &boundary->bodies[0];
    if (boundary->end_count == 0)
        walk_all(walking);
    for (unsigned i = 0; i < boundary->end_count; i++) {
        source->sides[source->count++] = boundary->ends[i];
        walk_all(walking);
        source->count--;
    }
}

/* Walks around what is seen through a pipe; the source has room for three sides. */
static void walk_hole(struct walking *walking, struct lx_boundary *boundary)
{
    struct lx_boundary_body *source = &boundary->bodies[0];
    unsigned sides[LX_BOUNDARY_BODIES];
    memcpy(&source->sides[source->count], boundary->hole, sizeof boundary->hole);
    source->count += 2;
    for (unsigned b = 0; b < boundary->count; b++) {
        sides[b] = boundary->bodies[b].count;
        boundary->bodies[b].count = boundary->bodies[b].is_pipe ? 0 : sides[b];
    }
    walk_from_inside(walking, boundary);
    for (unsigned b = 0; b < boundary->count; b++)
        boundary->bodies[b].count = sides[b];
    source->count -= 2;
}

bool lx_boundary_walk(struct lx_boundary *boundary, lx_take_border *take, void *data)
{
    struct walking walking; /* large: what is not needed stays as it is */
    walking.boundary = boundary;
    walking.take = take;
    walking.data = data;
    walking.ends.count = 0;
    walking.ends.is_full = false;
    walking.ends.unsure = 0;
    if (boundary->bodies[0].count + (boundary->has_hole ? 2 : 0) + (boundary->end_count > 0) > LX_BOUNDARY_SIDES)
        return false;
    walk_from_inside(&walking, boundary);
    if (boundary->has_hole)
        walk_hole(&walking, boundary);
    const bool is_closed = lx_boundary_ends_meet(&walking.ends);
    boundary->unsure += walking.ends.unsure;
    return is_closed;
}

/* ---- irradiance ---- */

/* An irradiance that is being summed. */
struct sum {
    const double *normal;
    double of_source, of_obstacles;
};

/*
 * What a piece of a disk's outline brings: half the integral of N.(u x u')/u^2, by Gauss's rule of 8 nodes, and of 16
 * by halves, until they agree.
 */
static double along_cone(const struct lx_boundary_side *side, double from, double to, const double normal[3])
{
    static const double places[4] = {0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                     0.96028985649753623};
    static const double weights[4] = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                      0.10122853629037626};
    const double middle = from + (to - from) / 2, half = (to - from) / 2;
    double sum = 0;
    for (int i = 0; i < 8; i++) {
        const double t = middle + (i % 2 ? half : -half) * places[i / 2], c = cos(t), s = sin(t);
        double u[3], slope[3], turned[3];
        for (int k = 0; k < 3; k++) {
            u[k] = side->limit * side->g[k] + side->sine * (c * side->p[k] + s * side->q[k]);
            slope[k] = side->sine * (c * side->q[k] - s * side->p[k]);
        }
        lx_cross(u, slope, turned);
        sum += weights[i / 2] * lx_dot(normal, turned) / lx_dot(u, u);
    }
    return half * sum / 2;
}

static double irradiance_of_cone(const struct lx_boundary_side *side, double from, double to, double whole,
                                 const double normal[3], int depth)
{
    const double ENOUGH = 1e-13;
    const double middle = from + (to - from) / 2;
    const double first = along_cone(side, from, middle, normal), second = along_cone(side, middle, to, normal);
    if (depth == 0 || fabs(first + second - whole) <= ENOUGH * fmax(1, fabs(whole)))
        return first + second;
    return irradiance_of_cone(side, from, middle, first, normal, depth - 1) +
           irradiance_of_cone(side, middle, to, second, normal, depth - 1);
}

/* What a piece of a side brings, for what is inside. */
static double irradiance_of(const struct lx_boundary_side *side, double from, double to, const double normal[3])
{
    enum { DEEPEST = 24 };
    if (!side->is_circle) {
        double a[3], b[3], turned[3];
        lx_boundary_place(side, from, a);
        lx_boundary_place(side, to, b);
        lx_cross(a, b, turned);
        return atan2(sqrt(lx_dot(turned, turned)), lx_dot(a, b)) * lx_dot(normal, side->g) / 2;
    }
    if (side->is_cone)
        return irradiance_of_cone(side, from, to, along_cone(side, from, to, normal), normal, DEEPEST);
    const double sine = sin(to) - sin(from), cosine = cos(to) - cos(from);
    return side->sine / 2 *
           (side->sine * (to - from) * lx_dot(normal, side->g) -
            side->limit * (sine * lx_dot(normal, side->p) - cosine * lx_dot(normal, side->q)));
}

static void add_irradiance(void *data, const struct lx_boundary_side *side, double from, double to, int sign)
{
    struct sum *sum = data;
    *(sign > 0 ? &sum->of_source : &sum->of_obstacles) += irradiance_of(side, from, to, sum->normal);
}

/* How far roundings move a source, and the turn of an uncertain axis. */
static double source_error(const struct lx_emitter *emitter, const double place_mm[3])
{
    const double *center = lx_emitter_center(emitter);
    double away = lx_emitter_radius(emitter);
    for (int k = 0; k < 3; k++)
        away += fabs(center[k] - place_mm[k]);
    return away * (4 * DBL_EPSILON + emitter->axis.x.error + emitter->axis.y.error + emitter->axis.z.error);
}

/* Cuts a ball off at a horizon. */
static void cut_ball(const double center[3], double radius, const double normal[3], struct lx_boundary_body *body)
{
    const double rise = lx_dot(center, normal);
    if (rise <= -radius)
        body->count = 0;
    else if (rise < radius && body->count > 0)
        lx_boundary_add_circle(normal, 0, 1, body);
}

/* The part of a ball above the horizons; false: it has no outline. */
static bool make_ball(const struct lx_emitter *ball, const struct lx_occlusion *occlusion, const double normal[3],
                      struct lx_boundary *boundary)
{
    struct lx_boundary_body *body = &boundary->bodies[0];
    double center[3];
    for (int k = 0; k < 3; k++)
        center[k] = ball->center_mm[k] - occlusion->place_mm[k];
    body->count = 0;
    if (!lx_boundary_add_ball(center, ball->radius_mm, body))
        return false;
    cut_ball(center, ball->radius_mm, normal, body);
    for (unsigned i = 0; i < boundary->cut_count; i++)
        cut_ball(center, ball->radius_mm, boundary->cuts[i], body);
    return true;
}

/* Walks around what is seen of a part of the source; false: it is not known. */
static bool walk_shape(const struct lx_boundary_shape *shape, const double normal[3], struct lx_boundary *boundary,
                       lx_take_border *take, void *data)
{
    struct lx_boundary_polygon part = shape->polygon;
    struct lx_boundary_body *body = &boundary->bodies[0];
    if (part.count + 1 + boundary->cut_count > LX_BOUNDARY_SIDES)
        return false;
    lx_boundary_cut(&part, normal);
    lx_boundary_cut_all(boundary, &part);
    if (part.count == 0)
        return true;
    if (!lx_boundary_add_polygon(&part, body) || body->count + shape->has_curve > LX_BOUNDARY_SIDES)
        return false;
    if (shape->has_curve)
        body->sides[body->count++] = shape->curve;
    return lx_boundary_walk(boundary, take, data);
}

bool lx_boundary_walk_source(const struct lx_emitter *emitter, const double normal[3],
                             const struct lx_occlusion *occlusion, lx_take_border *take, void *data, double *unsure)
{
    struct lx_boundary boundary;
    struct lx_boundary_shapes shapes;
    if (!lx_boundary_begin(occlusion, emitter, &boundary))
        return false;
    boundary.error_mm += source_error(emitter, occlusion->place_mm);
    const bool is_ball = !lx_has_axis(emitter);
    if (is_ball) {
        if (!make_ball(emitter, occlusion, normal, &boundary) ||
            (boundary.bodies[0].count > 0 && !lx_boundary_walk(&boundary, take, data)))
            return false;
    } else if (!lx_boundary_shape(occlusion, emitter, &shapes)) {
        return false;
    }
    for (unsigned i = 0; i < shapes.count && !is_ball; i++)
        if (!walk_shape(&shapes.items[i], normal, &boundary, take, data) ||
            (i + 1 < shapes.count && !lx_boundary_put_aside(&shapes.items[i], &boundary)))
            return false;
    *unsure = boundary.unsure + (is_ball ? 0 : shapes.unsure);
    return true;
}

bool lx_boundary_irradiance(const struct lx_emitter *emitter, const double normal[3],
                            const struct lx_occlusion *occlusion, lx_bounded *irradiance)
{
    struct sum sum = {.normal = normal};
    double unsure;
    if (emitter->attenuation != LX_INVERSE_SQUARE ||
        !lx_boundary_walk_source(emitter, normal, occlusion, add_irradiance, &sum, &unsure))
        return false;
    *irradiance = (lx_bounded){sum.of_source - sum.of_obstacles, unsure};
    return true;
}

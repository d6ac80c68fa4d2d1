/* SPDX-License-Identifier: MIT */
/*
 * The pieces of curves that bound what is seen.  Bodies are the source, cut at the horizon, and the obstacles, each a
 * convex cone of directions with the element at its tip: u is in it where g.u > limit for all of its sides, u and g of
 * unit length.  A side is bounded by its curve, a great circle or a circle around g, which is walked between the places
 * where it crosses any other; each piece is tried at its middle.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vector.h"
#include "../light/extended.h"
#include "skyline.h"

enum { MOST_SIDES = 12, MOST_BODIES = 12, MOST_CROSSINGS = 2 * MOST_SIDES * MOST_BODIES };

/* Directions that are nearer than this to a curve lie on it. */
static const double ON = 1e-12;

struct side {
    double g[3], limit;
    double from[3], to[3]; /* of a great circle's piece, its ends, of any length */
    bool is_circle;
    double sine, p[3], q[3]; /* of a circle: the sine of its angle, and two directions across g */
};

struct body {
    struct side sides[MOST_SIDES];
    unsigned count;
};

struct skyline {
    struct body bodies[MOST_BODIES]; /* the source first */
    unsigned count;
    const double *normal;
};

/* ---- making bodies ---- */

/* The side of a cone between two of its edges, which has `inside` on its inner side; false: it has no width. */
static bool make_side(const double from[3], const double to[3], const double inside[3], struct side *side)
{
    *side = (struct side){.limit = 0};
    lx_cross(from, to, side->g);
    const double length = lx_normalize(side->g);
    if (!(length > 1e-14 * sqrt(lx_dot(from, from) * lx_dot(to, to))))
        return false;
    const double sign = lx_dot(side->g, inside) < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        side->g[k] *= sign;
    memcpy(side->from, from, sizeof side->from);
    memcpy(side->to, to, sizeof side->to);
    return true;
}

/* The cone over a convex polygon; false: it is seen edge-on. */
static bool make_cone(const double (*corners)[3], unsigned count, struct body *body)
{
    double middle[3] = {0, 0, 0};
    body->count = 0;
    for (unsigned i = 0; i < count; i++) {
        const double scale = 1 / sqrt(lx_dot(corners[i], corners[i]));
        for (int k = 0; k < 3; k++)
            middle[k] += scale * corners[i][k];
    }
    for (unsigned i = 0; i < count; i++)
        body->count += make_side(corners[i], corners[(i + 1) % count], middle, &body->sides[body->count]);
    for (unsigned i = 0; i < body->count; i++)
        if (!(lx_dot(body->sides[i].g, middle) > 0))
            return false;
    return body->count >= 3;
}

static void make_circle(const double axis[3], double cosine, double sine, struct side *side)
{
    const int least = fabs(axis[0]) <= fabs(axis[1]) ? (fabs(axis[0]) <= fabs(axis[2]) ? 0 : 2)
                                                     : (fabs(axis[1]) <= fabs(axis[2]) ? 1 : 2);
    *side = (struct side){.limit = cosine, .is_circle = true, .sine = sine};
    memcpy(side->g, axis, sizeof side->g);
    for (int k = 0; k < 3; k++)
        side->p[k] = (k == least) - axis[least] * axis[k];
    lx_normalize(side->p);
    lx_cross(axis, side->p, side->q);
}

static bool make_cap(const double center[3], double radius, struct body *body)
{
    double axis[3] = {center[0], center[1], center[2]};
    const double sine = radius / lx_normalize(axis);
    if (!(sine < 1))
        return false;
    make_circle(axis, sqrt((1 - sine) * (1 + sine)), sine, &body->sides[0]);
    body->count = 1;
    return true;
}

/* Cuts a polygon at the horizon; returns how many corners are left. */
static unsigned cut_at_horizon(double (*corners)[3], unsigned count, const double normal[3])
{
    double left[MOST_SIDES][3];
    unsigned found = 0;
    for (unsigned i = 0; i < count; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % count];
        const double from = lx_dot(normal, a), to = lx_dot(normal, b);
        if (from > 0)
            memcpy(left[found++], a, sizeof left[0]);
        if ((from > 0) != (to > 0)) {
            for (int k = 0; k < 3; k++)
                left[found][k] = a[k] + from / (from - to) * (b[k] - a[k]);
            found++;
        }
    }
    memcpy(corners, left, found * sizeof *left);
    return found;
}

/* ---- walking ---- */

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where a side's curve crosses that of another. */
static unsigned find_crossings(const struct side *side, const struct side *other, double *at)
{
    unsigned count = 0;
    if (side->is_circle) {
        /* limit' = g'.u(phi) = a + b cos(phi) + c sin(phi) */
        const double a = side->limit * lx_dot(side->g, other->g) - other->limit;
        const double b = side->sine * lx_dot(side->p, other->g), c = side->sine * lx_dot(side->q, other->g);
        const double reach = hypot(b, c);
        if (!(fabs(a) < reach))
            return 0;
        const double middle = atan2(c, b), half = acos(-a / reach);
        for (int sign = -1; sign <= 1; sign += 2) {
            const double phi = middle + sign * half;
            at[count++] = phi < 0 ? phi + 2 * M_PI : phi >= 2 * M_PI ? phi - 2 * M_PI : phi;
        }
        return count;
    }
    const double from = lx_dot(other->g, side->from), to = lx_dot(other->g, side->to), change = to - from;
    if (other->limit == 0) {
        if ((from > 0) != (to > 0))
            at[count++] = from / (from - to);
        return count;
    }
    /* (g'.u)^2 = limit'^2 u^2 of u = from + t way */
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = side->to[k] - side->from[k];
    const double square = other->limit * other->limit;
    const double a = change * change - square * lx_dot(way, way), b = from * change - square * lx_dot(side->from, way),
                 c = from * from - square * lx_dot(side->from, side->from), below = b * b - a * c;
    if (!(below > 0))
        return 0;
    const double root = sqrt(below), larger = b > 0 ? -b - root : -b + root;
    const double shares[2] = {larger / a, c / larger};
    for (int i = 0; i < 2; i++)
        if (shares[i] > 0 && shares[i] < 1)
            at[count++] = shares[i];
    return count;
}

static void place_on(const struct side *side, double t, double u[3])
{
    const double c = side->is_circle ? cos(t) : 0, s = side->is_circle ? sin(t) : 0;
    for (int k = 0; k < 3; k++)
        u[k] = side->is_circle ? side->limit * side->g[k] + side->sine * (c * side->p[k] + s * side->q[k])
                               : side->from[k] + t * (side->to[k] - side->from[k]);
}

/* How far inside of a body a direction of unit length is, by the side that is nearest to it. */
static double depth_in(const struct body *body, const double u[3], const struct side **nearest)
{
    double depth = HUGE_VAL;
    for (unsigned i = 0; i < body->count; i++) {
        const double inside = lx_dot(body->sides[i].g, u) - body->sides[i].limit;
        if (inside < depth) {
            depth = inside;
            *nearest = &body->sides[i];
        }
    }
    return depth;
}

/*
 * Whether a piece of a side of body b is a border of what is seen, told by a direction on it.  Where it lies on a side
 * of another body, too: next to an obstacle that begins where the source ends nothing is seen; of obstacles that end
 * there the first one counts; between two that meet there is nothing.
 */
static bool is_border(const struct skyline *skyline, unsigned b, const struct side *side, const double u[3])
{
    const struct side *nearest = NULL;
    for (unsigned i = 0; i < skyline->bodies[b].count && side->is_circle; i++) { /* it has no ends */
        const struct side *own = &skyline->bodies[b].sides[i];
        if (own != side && !(lx_dot(own->g, u) > own->limit))
            return false;
    }
    if (b > 0 && !(depth_in(&skyline->bodies[0], u, &nearest) > ON))
        return false;
    for (unsigned i = 1; i < skyline->count; i++) {
        if (i == b)
            continue;
        const double depth = depth_in(&skyline->bodies[i], u, &nearest);
        if (depth < -ON)
            continue;
        if (depth > ON)
            return false;
        const bool agrees = lx_dot(nearest->g, side->g) > 0;
        if (b == 0 ? agrees : !agrees || i < b)
            return false;
    }
    return true;
}

/* What a piece of a side brings, for what is inside. */
static double piece(const struct side *side, double from, double to, const double normal[3])
{
    if (!side->is_circle) {
        double a[3], b[3], turned[3];
        place_on(side, from, a);
        place_on(side, to, b);
        lx_cross(a, b, turned);
        return atan2(sqrt(lx_dot(turned, turned)), lx_dot(a, b)) * lx_dot(normal, side->g) / 2;
    }
    const double sine = sin(to) - sin(from), cosine = cos(to) - cos(from);
    return side->sine / 2 *
           (side->sine * (to - from) * lx_dot(normal, side->g) -
            side->limit * (sine * lx_dot(normal, side->p) - cosine * lx_dot(normal, side->q)));
}

static double walk(const struct skyline *skyline, unsigned b, const struct side *side)
{
    double at[MOST_CROSSINGS + 2], sum = 0;
    unsigned count = 0;
    at[count++] = 0;
    at[count++] = side->is_circle ? 2 * M_PI : 1;
    for (unsigned i = 0; i < skyline->count; i++)
        for (unsigned k = 0; k < skyline->bodies[i].count && (i != b || side->is_circle); k++)
            if (&skyline->bodies[i].sides[k] != side)
                count += find_crossings(side, &skyline->bodies[i].sides[k], at + count);
    if (count > 2)
        qsort(at, count, sizeof *at, by_value);
    for (unsigned i = 0; i + 1 < count; i++) {
        double u[3];
        if (!(at[i + 1] > at[i]))
            continue;
        place_on(side, at[i] + (at[i + 1] - at[i]) / 2, u);
        if (!side->is_circle)
            lx_normalize(u);
        if (is_border(skyline, b, side, u))
            sum += piece(side, at[i], at[i + 1], skyline->normal);
    }
    return b == 0 ? sum : -sum;
}

static double walk_all(const struct skyline *skyline)
{
    double sum = 0;
    for (unsigned b = 0; b < skyline->count; b++)
        for (unsigned i = 0; i < skyline->bodies[b].count; i++)
            sum += walk(skyline, b, &skyline->bodies[b].sides[i]);
    return sum;
}

/* ---- the source ---- */

static void corner_from(const struct lx_occlusion *occlusion, const struct lx_facets *facets, unsigned i,
                        double corner[3])
{
    const lx_wide3 *wide = &facets->corners_mm[i];
    corner[0] = wide->x.high - occlusion->place_mm[0];
    corner[1] = wide->y.high - occlusion->place_mm[1];
    corner[2] = wide->z.high - occlusion->place_mm[2];
}

/* Whether an obstacle is on the front side of a plane, normal.x = height from the place. */
static bool is_in_front(const struct lx_obstacle *obstacle, const double normal[3], double height)
{
    if (obstacle->type == LX_OBSTACLE_BALL)
        return lx_dot(normal, obstacle->center_mm) - obstacle->radius_mm > height;
    for (unsigned i = 0; i < obstacle->corner_count; i++)
        if (!(lx_dot(normal, obstacle->corners_mm[i]) > height))
            return false;
    return true;
}

/* The same of all obstacles. */
static bool are_in_front(const struct lx_occlusion *occlusion, const double normal[3], double height)
{
    for (size_t i = 0; i < occlusion->obstacles.count; i++)
        if (!is_in_front(&occlusion->obstacles.items[i], normal, height))
            return false;
    return true;
}

static bool make_obstacles(const struct lx_occlusion *occlusion, struct skyline *skyline)
{
    skyline->count = 1;
    if (occlusion->has_outline || occlusion->obstacles.count >= MOST_BODIES)
        return false;
    for (size_t i = 0; i < occlusion->obstacles.count; i++) {
        const struct lx_obstacle *obstacle = &occlusion->obstacles.items[i];
        struct body *body = &skyline->bodies[skyline->count];
        if (obstacle->type == LX_OBSTACLE_BALL) {
            if (obstacle->is_around || !make_cap(obstacle->center_mm, obstacle->radius_mm, body))
                return false;
        } else if (obstacle->type != LX_OBSTACLE_POLYGON ||
                   !make_cone(obstacle->corners_mm, obstacle->corner_count, body)) {
            return false;
        }
        skyline->count++;
    }
    return true;
}

/* Adds a face that looks to the place. */
static bool add_face(const struct lx_occlusion *occlusion, const struct lx_facets *facets, const struct lx_face *face,
                     struct skyline *skyline, double *irradiance)
{
    const double normal[3] = {face->normal.x.high, face->normal.y.high, face->normal.z.high};
    double corners[MOST_SIDES][3];
    corner_from(occlusion, facets, facets->loop[face->first], corners[0]);
    const double height = lx_dot(normal, corners[0]);
    if (!(height < 0))
        return true;
    if (face->count + 1 > MOST_SIDES || !are_in_front(occlusion, normal, height))
        return false;
    for (unsigned i = 1; i < face->count; i++)
        corner_from(occlusion, facets, facets->loop[face->first + i], corners[i]);
    const unsigned left = cut_at_horizon(corners, face->count, skyline->normal);
    if (left < 3)
        return true;
    if (!make_cone(corners, left, &skyline->bodies[0]))
        return false;
    *irradiance += walk_all(skyline);
    return true;
}

static bool add_ball(const struct lx_emitter *ball, const struct lx_occlusion *occlusion, struct skyline *skyline,
                     double *irradiance)
{
    double center[3], towards[3];
    for (int k = 0; k < 3; k++)
        center[k] = towards[k] = ball->center_mm[k] - occlusion->place_mm[k];
    const double away = lx_normalize(towards), back[3] = {-towards[0], -towards[1], -towards[2]};
    struct body *body = &skyline->bodies[0];
    if (!make_cap(center, ball->radius_mm, body) || !are_in_front(occlusion, back, ball->radius_mm - away))
        return false;
    const double rise = lx_dot(center, skyline->normal);
    if (rise <= -ball->radius_mm)
        return true;
    if (rise < ball->radius_mm)
        make_circle(skyline->normal, 0, 1, &body->sides[body->count++]);
    *irradiance += walk_all(skyline);
    return true;
}

bool lx_skyline_irradiance(const struct lx_emitter *emitter, const double normal[3],
                           const struct lx_occlusion *occlusion, double *irradiance)
{
    struct skyline skyline; /* large: what is not needed stays as it is */
    skyline.normal = normal;
    *irradiance = 0;
    if (emitter->attenuation != LX_INVERSE_SQUARE || (emitter->type != LX_FACETS && emitter->type != LX_BALL) ||
        !make_obstacles(occlusion, &skyline))
        return false;
    if (emitter->type == LX_BALL)
        return add_ball(emitter, occlusion, &skyline, irradiance);
    for (size_t f = 0; f < emitter->facets->face_count; f++)
        if (!add_face(occlusion, emitter->facets, &emitter->facets->faces[f], &skyline, irradiance))
            return false;
    return true;
}

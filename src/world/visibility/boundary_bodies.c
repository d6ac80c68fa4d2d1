/* SPDX-License-Identifier: MIT */
/* The bodies of a boundary: cones over polygons, balls, disks and cylinders, and those of the obstacles. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "../../base/vector.h"
#include "boundary_bodies.h"

/* The side of a cone between two of its edges, which has `inside` on its inner side; false: it has no width. */
static bool make_side(const double from[3], const double to[3], const double inside[3], struct lx_boundary_side *side)
{
    *side = (struct lx_boundary_side){.limit = 0};
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
static bool make_cone(const double (*corners)[3], unsigned count, struct lx_boundary_body *body)
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

bool lx_boundary_add_polygon(const struct lx_boundary_polygon *polygon, struct lx_boundary_body *body)
{
    return make_cone(polygon->corners, polygon->count, body);
}

void lx_boundary_add_circle(const double axis[3], double cosine, double sine, struct lx_boundary_body *body)
{
    struct lx_boundary_side *side = &body->sides[body->count++];
    const int least = fabs(axis[0]) <= fabs(axis[1]) ? (fabs(axis[0]) <= fabs(axis[2]) ? 0 : 2)
                                                     : (fabs(axis[1]) <= fabs(axis[2]) ? 1 : 2);
    *side = (struct lx_boundary_side){
        .limit = cosine, .is_circle = true, .sine = sine, .longest = sine, .nearest_mm = HUGE_VAL};
    memcpy(side->g, axis, sizeof side->g);
    for (int k = 0; k < 3; k++)
        side->p[k] = (k == least) - axis[least] * axis[k];
    lx_normalize(side->p);
    lx_cross(axis, side->p, side->q);
}

bool lx_boundary_add_ball(const double center[3], double radius, struct lx_boundary_body *body)
{
    double axis[3] = {center[0], center[1], center[2]};
    const double away = lx_normalize(axis), sine = radius / away, cosine = sqrt((1 - sine) * (1 + sine));
    if (!(sine < 1) || body->count == LX_BOUNDARY_SIDES)
        return false;
    lx_boundary_add_circle(axis, cosine, sine, body);
    body->sides[body->count - 1].nearest_mm = away * cosine;
    return true;
}

void lx_boundary_cut(struct lx_boundary_polygon *polygon, const double normal[3])
{
    double left[LX_BOUNDARY_SIDES][3];
    unsigned found = 0;
    for (unsigned i = 0; i < polygon->count; i++) {
        const double *a = polygon->corners[i], *b = polygon->corners[(i + 1) % polygon->count];
        const double from = lx_dot(normal, a), to = lx_dot(normal, b);
        if (from > 0)
            memcpy(left[found++], a, sizeof left[0]);
        if ((from > 0) != (to > 0)) {
            for (int k = 0; k < 3; k++)
                left[found][k] = a[k] + from / (from - to) * (b[k] - a[k]);
            found++;
        }
    }
    memcpy(polygon->corners, left, found * sizeof *left);
    polygon->count = found < 3 ? 0 : found;
}

/* With c the centre over its distance and p, q the radii across each other over the same, u is inside where
 * u = x c + y p + z q has x more than the length of y and z. */
bool lx_boundary_disk(const double center[3], const double axis[3], double radius, struct lx_boundary_side *side,
                      double *unsure)
{
    const double EDGE_ON = 1e-9;
    struct lx_boundary_body circle = {.sides = side};
    double normal[3];
    const double height = lx_dot(center, axis);
    for (int k = 0; k < 3; k++)
        normal[k] = height < 0 ? -axis[k] : axis[k];
    lx_boundary_add_circle(normal, 1, radius, &circle);
    memcpy(side->g, center, sizeof side->g);
    const double away = lx_normalize(side->g), aside = sqrt(fmax(away * away - height * height, 0));
    side->nearest_mm = hypot(height, aside - radius);
    if (!(fabs(height) > EDGE_ON * away)) {
        *unsure += M_PI * radius * radius * fabs(height) / (side->nearest_mm * side->nearest_mm * side->nearest_mm);
        return false;
    }
    side->longest = radius / side->nearest_mm;
    side->is_cone = true;
    side->sine = 1;
    for (int k = 0; k < 3; k++) {
        side->p[k] *= radius / away;
        side->q[k] *= radius / away;
    }
    lx_cross(side->p, side->q, side->rows[0]);
    lx_cross(side->q, side->g, side->rows[1]);
    lx_cross(side->g, side->p, side->rows[2]);
    const double volume = lx_dot(side->g, side->rows[0]);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            side->rows[i][k] /= volume;
    return true;
}

struct lx_boundary_tube lx_boundary_tube_of(const double center[3], const double axis[3], double radius, double half)
{
    struct lx_boundary_tube tube = {.height = -lx_dot(center, axis), .radius = radius, .half = half};
    for (int k = 0; k < 3; k++) {
        tube.axis[k] = axis[k];
        tube.ends[0][k] = center[k] + half * axis[k];
        tube.ends[1][k] = center[k] - half * axis[k];
        tube.out[k] = -center[k] - tube.height * axis[k];
    }
    tube.away = lx_normalize(tube.out);
    return tube;
}

struct lx_boundary_polygon lx_boundary_side_of_tube(const struct lx_boundary_tube *tube)
{
    struct lx_boundary_polygon polygon = {.count = 4};
    const double cosine = tube->radius / tube->away, sine = sqrt((1 - cosine) * (1 + cosine));
    double aside[3];
    lx_cross(tube->axis, tube->out, aside);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            polygon.corners[i][k] =
                tube->ends[i / 2][k] +
                tube->radius * (cosine * tube->out[k] + (i == 1 || i == 2 ? sine : -sine) * aside[k]);
    return polygon;
}

/* ---- obstacles ---- */

/* Begins one more body, behind one that is complete; NULL: there is no room for so many sides. */
static struct lx_boundary_body *append(struct lx_boundary *boundary, unsigned sides)
{
    const struct lx_boundary_side *end = boundary->sides + LX_BOUNDARY_SIDES + LX_BOUNDARY_OBSTACLE_SIDES;
    if (boundary->count == LX_BOUNDARY_BODIES)
        return NULL;
    struct lx_boundary_body *body = &boundary->bodies[boundary->count];
    body->sides = body[-1].sides + (boundary->count > 1 ? body[-1].count : LX_BOUNDARY_SIDES);
    body->count = 0;
    body->is_pipe = false;
    if (end - body->sides < (ptrdiff_t)sides)
        return NULL;
    boundary->count++;
    return body;
}

static bool append_outline(struct lx_boundary *boundary, const struct lx_boundary_side *side)
{
    struct lx_boundary_body *body = append(boundary, 1);
    if (body)
        body->sides[body->count++] = *side;
    return body;
}

/* What can be seen through a pipe: all that is inside the outlines of both ends. */
static bool look_through(struct lx_boundary *boundary, const struct lx_boundary_tube *tube,
                         const struct lx_boundary_side ends[2])
{
    const double near = fabs(tube->height) - tube->half, far = fabs(tube->height) + tube->half, share = near / far;
    if (!(near > 0) || tube->away * (1 - share) >= tube->radius * (1 + share))
        return true;
    if (boundary->has_hole)
        return false;
    memcpy(boundary->hole, ends, sizeof boundary->hole);
    return boundary->has_hole = true;
}

/* The inner side of a cylinder around the element, which sees what is beyond it through its ends alone. */
static bool look_from_inside(const struct lx_boundary_tube *tube, struct lx_boundary *boundary)
{
    if (boundary->end_count > 0)
        return false;
    for (int i = 0; i < 2; i++)
        if (!lx_boundary_disk(tube->ends[i], tube->axis, tube->radius, &boundary->ends[i], &boundary->unsure))
            return false;
    boundary->end_count = 2;
    return true;
}

/* A space is no body: what is in it is cut off. */
static bool append_cut(struct lx_boundary *boundary, const double axis[3])
{
    if (boundary->cut_count == LX_MOST_HORIZONS)
        return false;
    memcpy(boundary->cuts[boundary->cut_count++], axis, sizeof boundary->cuts[0]);
    return true;
}

void lx_boundary_cut_all(const struct lx_boundary *boundary, struct lx_boundary_polygon *polygon)
{
    for (unsigned i = 0; i < boundary->cut_count && polygon->count > 0; i++)
        lx_boundary_cut(polygon, boundary->cuts[i]);
}

/*
 * The side of a cylinder with open ends.  Seen from outside all of the cylinder is the disks at its ends and the
 * rectangle between; seen from above an end only that end; through the pipe what is in both ends.
 */
static bool append_pipe(struct lx_boundary *boundary, const struct lx_obstacle *pipe)
{
    const struct lx_boundary_tube tube =
        lx_boundary_tube_of(pipe->center_mm, pipe->axis, pipe->radius_mm, pipe->half_mm);
    const unsigned first = boundary->count;
    const bool had_hole = boundary->has_hole;
    struct lx_boundary_side ends[2];
    bool is_seen[2];
    if (pipe->is_around && fabs(tube.height) < tube.half - pipe->touch_mm)
        return look_from_inside(&tube, boundary);
    if (pipe->is_around ? !(fabs(tube.height) > tube.half + pipe->touch_mm)
                        : !(tube.away > tube.radius + pipe->touch_mm))
        return false;
    for (int i = 0; i < 2; i++)
        is_seen[i] = lx_boundary_disk(tube.ends[i], tube.axis, tube.radius, &ends[i], &boundary->unsure);
    for (int i = 0; i < 2; i++)
        if (is_seen[i] && !append_outline(boundary, &ends[i]))
            return false;
    if (!pipe->is_around) {
        const struct lx_boundary_polygon side = lx_boundary_side_of_tube(&tube);
        struct lx_boundary_body *body = append(boundary, side.count);
        if (!body || !lx_boundary_add_polygon(&side, body))
            return false;
    }
    if (is_seen[0] && is_seen[1] && !look_through(boundary, &tube, ends))
        return false;
    for (unsigned i = first; i < boundary->count && boundary->has_hole && !had_hole; i++)
        boundary->bodies[i].is_pipe = true;
    return true;
}

static bool append_obstacle(struct lx_boundary *boundary, const struct lx_obstacle *obstacle)
{
    struct lx_boundary_side side;
    struct lx_boundary_body *body;
    switch (obstacle->type) {
    case LX_OBSTACLE_BALL:
        body = obstacle->is_around ? NULL : append(boundary, 1);
        return body && lx_boundary_add_ball(obstacle->center_mm, obstacle->radius_mm, body);
    case LX_OBSTACLE_POLYGON:
        body = append(boundary, obstacle->corner_count);
        return body && make_cone(obstacle->corners_mm, obstacle->corner_count, body);
    case LX_OBSTACLE_DISK:
        return lx_boundary_disk(obstacle->center_mm, obstacle->axis, obstacle->radius_mm, &side, &boundary->unsure) &&
               append_outline(boundary, &side);
    case LX_OBSTACLE_TUBE: return append_pipe(boundary, obstacle);
    case LX_OBSTACLE_SPACE: return append_cut(boundary, obstacle->axis);
    default: return false;
    }
}

bool lx_boundary_begin(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                       struct lx_boundary *boundary)
{
    boundary->count = 1;
    boundary->bodies[0].sides = boundary->sides;
    boundary->has_hole = boundary->bodies[0].is_pipe = false;
    boundary->end_count = boundary->cut_count = 0;
    boundary->error_mm = occlusion->error_mm;
    boundary->unsure = 0;
    if (occlusion->has_outline || occlusion->is_dark)
        return false;
    for (size_t i = 0; i < occlusion->obstacles.count; i++) {
        const struct lx_obstacle *obstacle = &occlusion->obstacles.items[i];
        enum lx_boundary_stand stand = LX_BOUNDARY_BEFORE;
        double beyond_mm = 0;
        if (obstacle->type != LX_OBSTACLE_SPACE)
            stand = lx_boundary_stand(occlusion, emitter, obstacle, &beyond_mm);
        if (stand == LX_BOUNDARY_UNKNOWN || (stand == LX_BOUNDARY_BEFORE && !append_obstacle(boundary, obstacle)))
            return false;
        boundary->error_mm = fmax(boundary->error_mm, occlusion->error_mm + beyond_mm);
    }
    return true;
}

bool lx_boundary_put_aside(const struct lx_boundary_shape *shape, struct lx_boundary *boundary)
{
    if (shape->has_curve)
        return append_outline(boundary, &shape->curve);
    struct lx_boundary_body *body = append(boundary, shape->polygon.count);
    return body && lx_boundary_add_polygon(&shape->polygon, body);
}

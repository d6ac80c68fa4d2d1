/* SPDX-License-Identifier: MIT */
/* Gathering the obstacles between an element and a source, and what they hide together of an arc. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/vector.h"
#include "../../light/solid/elliptic.h"
#include "../../light/solid/extended.h"
#include "../../surface/beside.h"
#include "../among.h"
#include "occlusion.h"
#include "outline.h"

/* Parts that lie so near to each other are one, and have the same bound. */
static const double SAME = 1e-13;

/* ---- the shaft ---- */

/* A plane of a shaft through a place, of any length; a normal of length 0 makes none. */
static void add_plane(struct lx_shaft *shaft, const double normal[3], const double place_mm[3])
{
    if (shaft->plane_count == LX_SHAFT_PLANES)
        return;
    double *plane = shaft->planes[shaft->plane_count];
    memcpy(plane, normal, 3 * sizeof *normal);
    if (!(lx_normalize(plane) > 0))
        return;
    plane[3] = -lx_dot(plane, place_mm);
    shaft->plane_count++;
}

static void corner_of(const struct lx_facets *facets, size_t i, double corner[3])
{
    const lx_wide3 *wide = &facets->corners_mm[i];
    corner[0] = wide->x.high, corner[1] = wide->y.high, corner[2] = wide->z.high;
}

/* A flat polygon: what is behind it does not count; nor, from a single place, what is beyond the planes of its
 * edges. */
static void bound_by_face(struct lx_shaft *shaft, const struct lx_facets *facets)
{
    const struct lx_face *face = &facets->faces[0];
    double first[3], normal[3] = {face->normal.x.high, face->normal.y.high, face->normal.z.high};
    corner_of(facets, facets->loop[face->first], first);
    add_plane(shaft, normal, first);
    if (shaft->from_radius_mm > 0 || face->count + 1 > LX_SHAFT_PLANES - 1)
        return;
    for (unsigned i = 0; i < face->count; i++) {
        double a[3], b[3], edge[3];
        corner_of(facets, facets->loop[face->first + i], a);
        corner_of(facets, facets->loop[face->first + (i + 1) % face->count], b);
        for (int k = 0; k < 3; k++) {
            a[k] -= shaft->from_mm[k];
            b[k] -= shaft->from_mm[k];
        }
        lx_cross(b, a, edge); /* a face runs counter-clockwise as seen from the place */
        if (lx_dot(normal, a) < 0)
            add_plane(shaft, edge, shaft->from_mm);
    }
}

/* A ball around a round source and the rectangles around it in which its outlines are laid out (outline_map.c): of
 * disks and balls squares; of a cylinder's side one that is as high as where it is nearest.  Those of the pieces of an
 * opening stand where these are nearest, as far aside as where they are farthest: no more than 4 radii of a cylinder
 * and 5 of an ellipsoid from the middle. */
static double radius_of_rectangles(const struct lx_emitter *emitter, const double place_mm[3])
{
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    const bool is_opening = lx_is_opening(emitter);
    double offset[3], half = lx_half_height(emitter);
    if (!lx_emitter_kind(emitter)->has_side)
        return (lx_has_axis(emitter) || !lx_is_elliptic(emitter) ? M_SQRT2 : 5) * emitter->radius_mm;
    for (int k = 0; k < 3; k++)
        offset[k] = emitter->center_mm[k] - place_mm[k];
    const double along = lx_dot(offset, axis), away = sqrt(fmax(lx_dot(offset, offset) - along * along, 0));
    if (is_opening)
        return hypot(4 * emitter->radius_mm, half + (fabs(along) + half) * fmin(4 * emitter->radius_mm / away, 1));
    if (away > emitter->radius_mm)
        half += (fabs(along) + half) * (emitter->radius_mm / away);
    return lx_is_capsule(emitter) ? M_SQRT2 * emitter->radius_mm + half : hypot(M_SQRT2 * emitter->radius_mm, half);
}

/* The plane of a flat source, which is the first one of its shaft, or one that touches the ball around the source; a
 * little nearer, for roundings.  The way to a cylinder's side passes the plane that touches it (outline_map.c) in its
 * second half. */
static void set_before(struct lx_shaft *shaft, bool is_flat, bool is_cylinder)
{
    static const double NEARER = 1e-10;
    double *before = shaft->before, way[3];
    for (int k = 0; k < 3; k++)
        way[k] = shaft->to_mm[k] - shaft->from_mm[k];
    const double away = lx_normalize(way);
    if (is_flat && shaft->plane_count > 0) {
        memcpy(before, shaft->planes[0], sizeof shaft->before);
    } else {
        for (int k = 0; k < 3; k++)
            before[k] = -way[k];
        const double start = lx_dot(way, shaft->from_mm), gap = away - shaft->outline_radius_mm;
        before[3] = start + (is_cylinder ? fmin(gap, gap / 2) : gap);
    }
    before[3] -= NEARER * (away + shaft->outline_radius_mm);
}

struct lx_shaft lx_shaft_to(const double from_mm[3], double radius_mm, const struct lx_emitter *emitter)
{
    const struct lx_facets *facets = emitter->facets;
    double at[3], normal[3];
    const bool is_flat = lx_emitter_plane(emitter, at, normal);
    struct lx_shaft shaft = {
        .from_radius_mm = radius_mm,
        .to_radius_mm = lx_emitter_radius(emitter),
    };
    memcpy(shaft.from_mm, from_mm, sizeof shaft.from_mm);
    memcpy(shaft.to_mm, lx_emitter_center(emitter), sizeof shaft.to_mm);
    if (is_flat && facets)
        bound_by_face(&shaft, facets);
    else if (is_flat)
        add_plane(&shaft, normal, at);
    shaft.outline_radius_mm = facets ? facets->radius_mm : radius_of_rectangles(emitter, from_mm);
    set_before(&shaft, is_flat, lx_emitter_kind(emitter)->has_side);
    return shaft;
}

/* ---- gathering ---- */

/* Whether all of the source is beyond a plane through the place, as far as can be told. */
static bool is_beyond(const struct lx_emitter *emitter, const double place_mm[3], const double normal[3])
{
    const double length = sqrt(lx_dot(normal, normal));
    double offset[3];
    if (!emitter->facets) {
        for (int k = 0; k < 3; k++)
            offset[k] = emitter->center_mm[k] - place_mm[k];
        return lx_dot(normal, offset) < -length * lx_emitter_radius(emitter);
    }
    for (size_t i = 0; i < emitter->facets->corner_count; i++) {
        corner_of(emitter->facets, i, offset);
        for (int k = 0; k < 3; k++)
            offset[k] -= place_mm[k];
        if (!(lx_dot(normal, offset) < -1e-12 * length * sqrt(lx_dot(offset, offset))))
            return false;
    }
    return true;
}

/* Whether a flat obstacle has the source on the element's side, or the element in its plane: then it hides nothing. */
static bool is_aside(const struct lx_obstacle *flat, const struct lx_emitter *emitter, const double place_mm[3])
{
    double axis[3], first[3], second[3], nearest;
    const double *at = flat->type == LX_OBSTACLE_DISK ? flat->center_mm : flat->corners_mm[0];
    if (flat->type == LX_OBSTACLE_DISK) {
        memcpy(axis, flat->axis, sizeof axis);
    } else {
        for (int k = 0; k < 3; k++) {
            first[k] = flat->corners_mm[1][k] - at[k];
            second[k] = flat->corners_mm[2][k] - at[k];
        }
        lx_cross(first, second, axis);
        if (!(lx_normalize(axis) > 0))
            return true;
    }
    const double height = lx_dot(axis, at);
    if (height < 0)
        for (int k = 0; k < 3; k++)
            axis[k] = -axis[k];
    return fabs(height) <= flat->touch_mm ||
           lx_emitter_extent(emitter, place_mm, axis, &nearest) <= fabs(height) + flat->touch_mm;
}

/* Whether a polygon as seen from the place lies beside the source. */
static bool is_beside(const struct lx_obstacle *polygon, const struct lx_emitter *emitter, const double place_mm[3])
{
    for (unsigned i = 0; i < polygon->corner_count; i++) {
        double normal[3];
        lx_cross(polygon->corners_mm[i], polygon->corners_mm[(i + 1) % polygon->corner_count], normal);
        if (lx_dot(normal, polygon->corners_mm[(i + 2) % polygon->corner_count]) < 0)
            for (int k = 0; k < 3; k++)
                normal[k] = -normal[k];
        if (is_beyond(emitter, place_mm, normal))
            return true;
    }
    return false;
}

/* Makes an obstacle relative to the place; false: it hides nothing. */
static bool make_relative(struct lx_obstacle *obstacle, const struct lx_emitter *emitter, const double place_mm[3])
{
    for (unsigned i = 0; i < obstacle->corner_count; i++)
        for (int k = 0; k < 3; k++)
            obstacle->corners_mm[i][k] -= place_mm[k];
    for (int k = 0; k < 3; k++)
        obstacle->center_mm[k] -= place_mm[k];
    if (obstacle->type == LX_OBSTACLE_POLYGON)
        return !is_aside(obstacle, emitter, place_mm) && !is_beside(obstacle, emitter, place_mm);
    if (obstacle->type == LX_OBSTACLE_DISK)
        return !is_aside(obstacle, emitter, place_mm);
    return true;
}

static double size_of(const struct lx_obstacle *obstacle)
{
    double size = obstacle->radius_mm + obstacle->half_mm + sqrt(lx_dot(obstacle->center_mm, obstacle->center_mm));
    for (unsigned i = 0; i < obstacle->corner_count; i++)
        size = fmax(size, sqrt(lx_dot(obstacle->corners_mm[i], obstacle->corners_mm[i])));
    return size;
}

int lx_occlusion_make_room(struct lx_occlusion *occlusion)
{
    const struct lx_obstacles *obstacles = &occlusion->obstacles;
    size_t most = occlusion->has_outline ? lx_outline_most(occlusion->outline) : 1;
    for (size_t i = 0; i < obstacles->count; i++)
        most += obstacles->items[i].type == LX_OBSTACLE_SHAPE ? LX_SCANNED : LX_MOST_HIDDEN;
    return lx_reserve(&occlusion->hidden, &occlusion->most_hidden, most, sizeof *occlusion->hidden);
}

const struct lx_shaft *lx_occlusion_begin(const double place_mm[3], const double *normal,
                                          const struct lx_emitter *emitter, struct lx_occlusion *occlusion)
{
    occlusion->shaft = lx_shaft_to(place_mm, 0, emitter);
    occlusion->obstacles.count = occlusion->obstacles.sheet_count = 0;
    occlusion->obstacles.edge_count = occlusion->obstacles.layered_count = 0;
    occlusion->horizon_count = 0;
    occlusion->has_outline = occlusion->is_dark = occlusion->has_polygons = false;
    memcpy(occlusion->place_mm, place_mm, sizeof occlusion->place_mm);
    if (normal) {
        add_plane(&occlusion->shaft, normal, place_mm);
        memcpy(occlusion->horizons[occlusion->horizon_count++], normal, sizeof occlusion->horizons[0]);
    }
    return &occlusion->shaft;
}

/* Whether a space behind a plane hides nothing: of the source, or that the horizon leaves. */
static bool is_below(const struct lx_obstacle *space, const struct lx_emitter *emitter,
                     const struct lx_occlusion *occlusion)
{
    static const double SAME_PLANE = 1e-14;
    const double down[3] = {-space->axis[0], -space->axis[1], -space->axis[2]};
    double off = HUGE_VAL;
    for (unsigned i = 0; i < occlusion->horizon_count; i++) {
        const double *n = occlusion->horizons[i];
        off = fmin(off, fabs(n[0] + down[0]) + fabs(n[1] + down[1]) + fabs(n[2] + down[2]));
    }
    return off <= SAME_PLANE || is_beyond(emitter, occlusion->place_mm, down);
}

/* A direction to a place of the source above the horizons, if there is one: where it is highest, nearly. */
static bool look_up(const struct lx_emitter *emitter, const struct lx_occlusion *occlusion, double way[3])
{
    const double *center = lx_emitter_center(emitter);
    double best = -HUGE_VAL;
    for (int k = 0; k < 3; k++)
        way[k] = center[k] - occlusion->place_mm[k];
    if (occlusion->horizon_count == 0)
        return true;
    const double *normal = occlusion->horizons[0];
    double middle[3] = {way[0], way[1], way[2]}, radius = emitter->radius_mm;
    for (size_t i = 0; emitter->facets && i < emitter->facets->corner_count; i++) {
        double corner[3];
        corner_of(emitter->facets, i, corner);
        for (int k = 0; k < 3; k++)
            corner[k] = 0.98 * (corner[k] - occlusion->place_mm[k]) + 0.02 * middle[k];
        if (lx_dot(normal, corner) > best) {
            best = lx_dot(normal, corner);
            memcpy(way, corner, sizeof corner);
        }
    }
    if (!emitter->facets) {
        const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
        const double along = lx_dot(normal, axis);
        double up[3];
        for (int k = 0; k < 3; k++)
            up[k] = lx_emitter_kind(emitter)->bulges ? normal[k] : normal[k] - along * axis[k];
        lx_normalize(up);
        for (int k = 0; k < 3; k++)
            way[k] += 0.98 * radius * up[k] +
                      (lx_emitter_kind(emitter)->has_side ? copysign(0.49 * emitter->height_mm, along) * axis[k] : 0);
    }
    for (unsigned i = 0; i < occlusion->horizon_count; i++)
        if (!(lx_dot(occlusion->horizons[i], way) > 0))
            return false;
    return true;
}

/* Takes sheets that may reach into a round source, of which its outline does not know what they hide, as polygons. */
static int take_sheets(const struct lx_emitter *emitter, struct lx_occlusion *occlusion)
{
    enum { MOST_SHEETS = 64 };
    struct lx_obstacles *obstacles = &occlusion->obstacles;
    const struct lx_emitter_kind *kind = lx_emitter_kind(emitter);
    if ((!kind->bulges && !kind->has_side) || obstacles->sheet_count > MOST_SHEETS)
        return 0;
    for (size_t i = 0; i < obstacles->sheet_count; i++) {
        struct lx_obstacle polygon = {.type = LX_OBSTACLE_POLYGON, .corner_count = 3};
        memcpy(polygon.corners_mm, obstacles->sheets[i].corners_mm, sizeof obstacles->sheets[i].corners_mm);
        if (lx_obstacles_append(obstacles, &polygon))
            return -1;
    }
    occlusion->has_polygons = true;
    return 0;
}

/*
 * What sheets do: where no edge of theirs comes into the shaft, they hide all or nothing.  One plane hides nothing of
 * what the other leaves, so with two of them this is not tried.
 */
static int settle_sheets(const struct lx_emitter *emitter, struct lx_occlusion *occlusion)
{
    struct lx_obstacles *obstacles = &occlusion->obstacles;
    double way[3];
    if (obstacles->layered_count == 0)
        return 0;
    for (size_t i = 0; i < obstacles->sheet_count; i++)
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                obstacles->sheets[i].corners_mm[c][k] -= occlusion->place_mm[k];
    for (size_t i = 0; i < obstacles->edge_count; i++)
        for (int k = 0; k < 3; k++) {
            obstacles->edges[i].from_mm[k] -= occlusion->place_mm[k];
            obstacles->edges[i].to_mm[k] -= occlusion->place_mm[k];
        }
    occlusion->outline = occlusion->outline ? occlusion->outline : lx_outline_new();
    if (!occlusion->outline)
        return -1;
    occlusion->has_outline = true;
    if (obstacles->edge_count > 0 || occlusion->horizon_count > 1)
        return 0;
    if (lx_outline_may_cut(occlusion, emitter))
        return 0;
    occlusion->has_outline = false;
    occlusion->is_dark = look_up(emitter, occlusion, way) && lx_outline_layers(occlusion, way) > 0;
    return 0;
}

int lx_occlusion_settle(const struct lx_emitter *emitter, double place_error_mm, struct lx_occlusion *occlusion)
{
    struct lx_obstacles *obstacles = &occlusion->obstacles;
    const double *place = occlusion->place_mm;
    size_t kept = 0;
    double size = fabs(place[0]) + fabs(place[1]) + fabs(place[2]), largest = 0;
    if (take_sheets(emitter, occlusion))
        return -1;
    for (size_t i = 0; i < obstacles->count; i++) {
        struct lx_obstacle obstacle = obstacles->items[i];
        if (!make_relative(&obstacle, emitter, place) ||
            (obstacle.type == LX_OBSTACLE_SPACE && is_below(&obstacle, emitter, occlusion)))
            continue;
        largest = fmax(largest, size_of(&obstacle));
        obstacles->items[kept++] = obstacle;
    }
    obstacles->count = kept;
    for (size_t i = 0; i < kept; i++)
        if (obstacles->items[i].type == LX_OBSTACLE_SPACE && occlusion->horizon_count < LX_MOST_HORIZONS)
            memcpy(occlusion->horizons[occlusion->horizon_count++], obstacles->items[i].axis,
                   sizeof occlusion->horizons[0]);
    if (settle_sheets(emitter, occlusion))
        return -1;
    for (size_t i = 0; i < obstacles->edge_count; i++)
        largest = fmax(largest, sqrt(fmax(lx_dot(obstacles->edges[i].from_mm, obstacles->edges[i].from_mm),
                                          lx_dot(obstacles->edges[i].to_mm, obstacles->edges[i].to_mm))));
    occlusion->error_mm = 4 * DBL_EPSILON * (size + largest) + place_error_mm;
    return 0;
}

int lx_occlusion_gather(const struct lx_shape *shape, bool is_own, bool is_turned, const double normal[3],
                        struct lx_occlusion *occlusion)
{
    const bool is_beside = is_turned || (is_own && shape->kind->normal_seen);
    if ((is_beside ? lx_asks_both(shape->kind) : lx_may_hide(shape, is_own)) &&
        lx_shape_gather(shape, &occlusion->shaft, &occlusion->obstacles))
        return -1;
    return is_beside ? lx_shape_gather_beside(shape, normal, &occlusion->shaft, &occlusion->obstacles) : 0;
}

/* What hides the sun beside an opening that it is seen through: all beyond the planes of its edges. */
static int append_rim(const struct lx_glass_pane *opening, const double place_mm[3], struct lx_obstacles *obstacles)
{
    double inwards[LX_RIM][3];
    int failed = 0;
    lx_pane_edges(opening, place_mm, inwards);
    for (int i = 0; i < LX_RIM && !failed; i++) {
        struct lx_obstacle beside = {.type = LX_OBSTACLE_SPACE};
        memcpy(beside.axis, inwards[i], sizeof beside.axis);
        failed = lx_obstacles_append(obstacles, &beside);
    }
    return failed;
}

int lx_occlusion_make(const struct lx_prepared *prepared, const struct lx_element *element,
                      const struct lx_emitter *emitter, bool above, struct lx_occlusion *occlusion)
{
    const double place[3] = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value};
    const double normal[3] = {element->normal.x.value, element->normal.y.value, element->normal.z.value};
    double beyond_mm = 0;
    lx_occlusion_begin(place, above ? normal : NULL, emitter, occlusion);
    if (emitter->through && lx_is_disk(emitter) && append_rim(emitter->through, place, &occlusion->obstacles))
        return -1;
    struct lx_found found;
    const bool is_found = lx_among_shaft(prepared, &occlusion->shaft, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[lx_found_at(&found, is_found, i)];
        const struct lx_shape *shape = &surface->shape;
        const bool is_own = surface == element->own;
        if (surface->authored + 1 == prepared->left_out)
            continue;
        if (prepared->pane_count >
            0) /* walls stand as much farther back and are as much larger (lx_shape_in_the_way()),
                                         and so the openings are smaller */
            beyond_mm = fmax(beyond_mm, shape->touch_mm + 3 * shape->behind_mm);
        const bool is_turned =
            is_own && element->is_free && lx_shape_is_turned(shape, element->place_mm, element->normal);
        if (lx_occlusion_gather(shape, is_own, is_turned, normal, occlusion))
            return -1;
    }
    return lx_occlusion_settle(
        emitter, beyond_mm + element->place_mm.x.error + element->place_mm.y.error + element->place_mm.z.error,
        occlusion);
}

/* ---- all of it ---- */

/* Whether a convex cone that is all within its planes holds all of the source: as polygons are. */
static bool polygon_hides_all(const struct lx_obstacle *polygon, const struct lx_emitter *emitter,
                              const double place_mm[3])
{
    double first[3], second[3], axis[3], nearest;
    for (int k = 0; k < 3; k++) {
        first[k] = polygon->corners_mm[1][k] - polygon->corners_mm[0][k];
        second[k] = polygon->corners_mm[2][k] - polygon->corners_mm[0][k];
    }
    lx_cross(first, second, axis);
    lx_normalize(axis);
    double height = lx_dot(axis, polygon->corners_mm[0]);
    for (int k = 0; k < 3 && height < 0; k++)
        axis[k] = -axis[k];
    lx_emitter_extent(emitter, place_mm, axis, &nearest);
    if (!(nearest > fabs(height) + polygon->touch_mm))
        return false;
    for (unsigned i = 0; i < polygon->corner_count; i++) {
        lx_cross(polygon->corners_mm[i], polygon->corners_mm[(i + 1) % polygon->corner_count], first);
        lx_normalize(first);
        const double sign = lx_dot(first, polygon->corners_mm[(i + 2) % polygon->corner_count]) < 0 ? -1 : 1;
        for (int k = 0; k < 3; k++)
            first[k] *= sign;
        lx_emitter_extent(emitter, place_mm, first, &nearest);
        if (!(nearest > 0))
            return false;
    }
    return true;
}

/* Whether all of the source lies within the cone of directions that meet the ball, and behind its middle. */
static bool ball_hides_all(const struct lx_obstacle *ball, const struct lx_emitter *emitter, const double place_mm[3])
{
    double axis[3], nearest, offset[3];
    memcpy(axis, ball->center_mm, sizeof axis);
    const double away = lx_normalize(axis), sine = ball->radius_mm / away;
    if (ball->is_around || !(sine < 1))
        return false;
    lx_emitter_extent(emitter, place_mm, axis, &nearest);
    if (!(nearest > away))
        return false;
    const double alpha = asin(sine) * (1 - 1e-12), cosine = cos(alpha);
    if (!emitter->facets) {
        for (int k = 0; k < 3; k++)
            offset[k] = emitter->center_mm[k] - place_mm[k];
        const double distance = lx_normalize(offset), radius = lx_emitter_radius(emitter);
        return distance > radius && acos(fmin(lx_dot(axis, offset), 1)) + asin(radius / distance) < alpha;
    }
    for (size_t i = 0; i < emitter->facets->corner_count; i++) {
        corner_of(emitter->facets, i, offset);
        for (int k = 0; k < 3; k++)
            offset[k] -= place_mm[k];
        if (!(lx_dot(axis, offset) > cosine * sqrt(lx_dot(offset, offset))))
            return false;
    }
    return true;
}

bool lx_occlusion_hides_all(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter)
{
    if (occlusion->is_dark)
        return true;
    for (size_t i = 0; i < occlusion->obstacles.count; i++) {
        const struct lx_obstacle *obstacle = &occlusion->obstacles.items[i];
        if ((obstacle->type == LX_OBSTACLE_POLYGON && polygon_hides_all(obstacle, emitter, occlusion->place_mm)) ||
            (obstacle->type == LX_OBSTACLE_BALL && ball_hides_all(obstacle, emitter, occlusion->place_mm)))
            return true;
    }
    return false;
}

void lx_occlusion_clear(struct lx_occlusion *occlusion)
{
    lx_obstacles_clear(&occlusion->obstacles);
    lx_outline_free(occlusion->outline);
    free(occlusion->hidden);
    *occlusion = (struct lx_occlusion){.place_mm = {0}};
}

/* ---- an arc ---- */

static int by_beginning(const void *a, const void *b)
{
    const struct lx_hidden *x = a, *y = b;
    if (x->ends[0] != y->ends[0])
        return x->ends[0] < y->ends[0] ? -1 : 1;
    return (x->bounds[0] > y->bounds[0]) - (x->bounds[0] < y->bounds[0]);
}

static void sort(struct lx_hidden *hidden, size_t count)
{
    enum { FEW = 12 };
    if (count > FEW) {
        qsort(hidden, count, sizeof *hidden, by_beginning);
        return;
    }
    for (size_t i = 1; i < count; i++) {
        const struct lx_hidden moved = hidden[i];
        size_t k = i;
        for (; k > 0 && by_beginning(&hidden[k - 1], &moved) > 0; k--)
            hidden[k] = hidden[k - 1];
        hidden[k] = moved;
    }
}

/* Where two obstacles end at one place, as triangles at their common edge, it is the first that counts. */
static void extend(struct lx_hidden *part, const struct lx_hidden *by)
{
    const double beyond = by->ends[1] - part->ends[1];
    if (fabs(beyond) <= SAME) {
        part->bounds[1] = by->bounds[1] < part->bounds[1] ? by->bounds[1] : part->bounds[1];
        part->slack[1] = fmax(part->slack[1], by->slack[1]);
    } else if (beyond > 0) {
        part->bounds[1] = by->bounds[1];
        part->slack[1] = by->slack[1];
    }
    part->ends[1] = fmax(part->ends[1], by->ends[1]);
    if (by->ends[0] - part->ends[0] <= SAME && by->bounds[0] < part->bounds[0])
        part->bounds[0] = by->bounds[0];
}

size_t lx_occlusion_hide(const struct lx_occlusion *occlusion, const struct lx_sweep *sweep, const struct lx_arc *arc)
{
    struct lx_hidden *hidden = occlusion->hidden;
    size_t count = 0, kept = 0;
    for (size_t i = 0; i < occlusion->obstacles.count; i++)
        count = lx_obstacle_hide(occlusion, i + 1, sweep, arc, hidden, count);
    if (occlusion->has_outline)
        count = lx_outline_hide(occlusion, sweep, arc, hidden, count);
    if (occlusion->is_dark)
        hidden[count++] = (struct lx_hidden){.ends = {-M_PI, M_PI}};
    sort(hidden, count);
    for (size_t i = 0; i < count; i++) {
        if (kept > 0 && hidden[i].ends[0] <= hidden[kept - 1].ends[1] + SAME)
            extend(&hidden[kept - 1], &hidden[i]);
        else
            hidden[kept++] = hidden[i];
    }
    return kept;
}

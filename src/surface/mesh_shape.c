/* SPDX-License-Identifier: MIT */
/*
 * Seeing a mesh: where lines of sight meet it, and its normals.  Which triangle a line meets is told by the tree;
 * where, and with which normal, is computed here once more with bounds.
 */
#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "mesh.h"
#include "plane.h"

static const struct lx_mesh_body *body_of(const struct lx_shape *shape)
{
    return shape->body;
}

void lx_mesh_enter(const struct lx_shape *shape, const double offset_mm[3], double place[3])
{
    const double size = lx_mesh_size_of(shape);
    place[0] = lx_dot(offset_mm, shape->across) / size;
    place[1] = lx_dot(offset_mm, shape->upward) / size;
    place[2] = lx_dot(offset_mm, shape->axis) / size;
}

void lx_mesh_leave(const struct lx_shape *shape, const double direction[3], double turned[3])
{
    for (int k = 0; k < 3; k++)
        turned[k] = direction[0] * shape->across[k] + direction[1] * shape->upward[k] + direction[2] * shape->axis[k];
}

void lx_mesh_leave_place(const struct lx_shape *shape, const double place[3], double place_mm[3])
{
    lx_mesh_leave(shape, place, place_mm);
    for (int k = 0; k < 3; k++)
        place_mm[k] = place_mm[k] * lx_mesh_size_of(shape) + shape->anchor_mm[k];
}

static void cross(const double a[3], const double b[3], double product[3])
{
    for (int k = 0; k < 3; k++) {
        const int y = (k + 1) % 3, z = (k + 2) % 3;
        product[k] = a[y] * b[z] - a[z] * b[y];
    }
}

/* The normal of a triangle in the tree, of any length. */
static void face_normal(const struct lx_tree_triangle *triangle, double normal[3])
{
    double first[3], second[3];
    for (int k = 0; k < 3; k++) {
        first[k] = triangle->corners[1][k] - triangle->corners[0][k];
        second[k] = triangle->corners[2][k] - triangle->corners[0][k];
    }
    cross(first, second, normal);
}

/* The numbers of a triangle's normals; NULL: it has its own. */
static const unsigned *normals_of(const struct lx_mesh_body *body, const struct lx_tree_triangle *triangle)
{
    const unsigned *of = body->normals->of ? body->normals->of[triangle->number] : NULL;
    return of && of[0] != LX_NO_NORMAL ? of : NULL;
}

/* The normal to shade a place of a triangle by, of the length 1, in space. */
static void shading_normal(const struct lx_shape *shape, const struct lx_tree_triangle *triangle, const double place[3],
                           double normal[3])
{
    const struct lx_mesh_body *body = body_of(shape);
    const unsigned *of = normals_of(body, triangle);
    double own[3], mixed[3] = {0, 0, 0};
    face_normal(triangle, own);
    for (int c = 0; of && c < 3; c++) {
        const double *a = triangle->corners[(c + 1) % 3], *b = triangle->corners[(c + 2) % 3];
        double side[3], from[3], product[3];
        for (int k = 0; k < 3; k++)
            side[k] = b[k] - a[k], from[k] = place[k] - a[k];
        cross(side, from, product);
        const double share = lx_dot(product, own);
        for (int k = 0; k < 3; k++)
            mixed[k] += share * body->normals->normals[of[c]][k];
    }
    lx_mesh_leave(shape, of && lx_dot(mixed, mixed) > 0 ? mixed : own, normal);
    lx_normalize(normal);
}

/* The triangle on which a place of the tree lies, or the nearest one; of two that share an edge the one that a line of
 * sight sees, if any. */
static const struct lx_tree_triangle *triangle_at(const struct lx_shape *shape, const double place[3], double *distance)
{
    const struct lx_mesh_tree *tree = body_of(shape)->tree;
    const struct lx_tree_triangle *found =
        lx_tree_nearest(tree, place, shape->touch_mm / lx_mesh_size_of(shape), distance);
    return found ? found : lx_tree_nearest(tree, place, HUGE_VAL, distance);
}

void lx_mesh_normal(const struct lx_shape *shape, const double offset_mm[3], double normal[3])
{
    double place[3], distance;
    lx_mesh_enter(shape, offset_mm, place);
    const struct lx_tree_triangle *triangle = triangle_at(shape, place, &distance);
    normal[0] = normal[1] = 0, normal[2] = 1;
    if (triangle)
        shading_normal(shape, triangle, place, normal);
}

void lx_mesh_normal_seen(const struct lx_shape *shape, const double offset_mm[3], const double sight[3],
                         double normal[3])
{
    double place[3], true_normal[3], own[3], distance;
    lx_mesh_enter(shape, offset_mm, place);
    const struct lx_tree_triangle *triangle = triangle_at(shape, place, &distance);
    normal[0] = normal[1] = 0, normal[2] = 1;
    if (!triangle)
        return;
    shading_normal(shape, triangle, place, normal);
    face_normal(triangle, own);
    lx_mesh_leave(shape, own, true_normal);
    if (!body_of(shape)->fronts_only && lx_dot(true_normal, sight) > 0)
        for (int k = 0; k < 3; k++)
            normal[k] = -normal[k];
}

bool lx_mesh_face_normal(const struct lx_shape *shape, const double place_mm[3], double normal[3])
{
    double offset[3], place[3], own[3], distance;
    for (int k = 0; k < 3; k++)
        offset[k] = place_mm[k] - shape->anchor_mm[k];
    lx_mesh_enter(shape, offset, place);
    const struct lx_tree_triangle *triangle = triangle_at(shape, place, &distance);
    if (!triangle)
        return false;
    face_normal(triangle, own);
    lx_mesh_leave(shape, own, normal);
    return lx_normalize(normal) > 0;
}

/* Shaded by the normals of its faces it is dark there already, but for highlights. */
bool lx_mesh_is_behind(const struct lx_shape *shape, const double offset_mm[3], const double normal[3],
                       const double way[3])
{
    const struct lx_mesh_body *body = body_of(shape);
    double place[3], own[3], true_normal[3], shading[3], distance;
    const double cosine = lx_dot(normal, way) / sqrt(lx_dot(way, way));
    if (!body->normals->of)
        return cosine < 0;
    /* smooth normals are no farther from those of their faces than the crease */
    if (body->normals->way == LX_NORMALS_SMOOTH && body->normals->crease < 89 &&
        fabs(cosine) > sin(body->normals->crease * (M_PI / 180)) + 1e-9)
        return cosine < 0;
    lx_mesh_enter(shape, offset_mm, place);
    const struct lx_tree_triangle *triangle = triangle_at(shape, place, &distance);
    if (!triangle)
        return false;
    face_normal(triangle, own);
    lx_mesh_leave(shape, own, true_normal);
    shading_normal(shape, triangle, place, shading);
    return lx_dot(true_normal, way) * lx_dot(shading, normal) < 0;
}

bool lx_mesh_holds(const struct lx_shape *shape, const double place_mm[3])
{
    double offset[3], place[3], distance;
    for (int k = 0; k < 3; k++)
        offset[k] = place_mm[k] - shape->anchor_mm[k];
    lx_mesh_enter(shape, offset, place);
    const double near = fmax(1e-9 * shape->radius_mm, shape->touch_mm);
    return lx_tree_nearest(body_of(shape)->tree, place, near / lx_mesh_size_of(shape), &distance) != NULL;
}

bool lx_mesh_encloses(const struct lx_shape *shape, const double place_mm[3])
{
    const struct lx_mesh_body *body = body_of(shape);
    double offset[3], place[3];
    if (!body->encloses || lx_mesh_holds(shape, place_mm))
        return false;
    for (int k = 0; k < 3; k++)
        offset[k] = place_mm[k] - shape->anchor_mm[k];
    lx_mesh_enter(shape, offset, place);
    for (int k = 0; k < 3; k++)
        if (place[k] < body->tree->low[k] || place[k] > body->tree->high[k])
            return false;
    return lx_tree_is_inside(body->tree, place) != body->looks_inwards;
}

double lx_mesh_distance(const struct lx_shape *shape, const double offset_mm[3], double direction[3])
{
    double place[3], distance;
    lx_mesh_enter(shape, offset_mm, place);
    const struct lx_tree_triangle *triangle = lx_tree_nearest(body_of(shape)->tree, place, HUGE_VAL, &distance);
    const double away = distance * lx_mesh_size_of(shape);
    memcpy(direction, offset_mm, 3 * sizeof *direction);
    if (lx_normalize(direction) == 0)
        direction[2] = 1;
    const double at[3] = {offset_mm[0] + shape->anchor_mm[0], offset_mm[1] + shape->anchor_mm[1],
                          offset_mm[2] + shape->anchor_mm[2]};
    return triangle && lx_mesh_encloses(shape, at) ? -away : away;
}

/* ---- lines of sight ---- */

static struct lx_tree_ray ray_in_tree(const struct lx_shape *shape, const double from_mm[3], const double direction[3])
{
    struct lx_tree_ray ray = {.from = 0, .to = HUGE_VAL};
    lx_mesh_enter(shape, from_mm, ray.origin);
    lx_mesh_enter(shape, direction, ray.direction);
    return ray;
}

bool lx_mesh_meets(const struct lx_shape *shape, const double from_mm[3], const double direction[3], double *t,
                   double offset_mm[3])
{
    const struct lx_mesh_body *body = body_of(shape);
    const struct lx_tree_ray ray = ray_in_tree(shape, from_mm, direction);
    const struct lx_tree_hit hit = lx_tree_first(body->tree, &ray, body->fronts_only);
    if (!hit.triangle)
        return false;
    *t = hit.t;
    lx_mesh_leave(shape, hit.place, offset_mm);
    for (int k = 0; k < 3; k++)
        offset_mm[k] *= lx_mesh_size_of(shape);
    return true;
}

/* A vector of the tree in space. */
static lx_bounded3 leave_bounded(const struct lx_shape *shape, lx_bounded3 vector)
{
    return lx_add3(lx_add3(lx_mul3(lx_shape_across(shape), vector.x), lx_mul3(lx_shape_upward(shape), vector.y)),
                   lx_mul3(lx_shape_axis(shape), vector.z));
}

/* The corner of a triangle, from the anchor, in mm. */
static lx_bounded3 corner_in_space(const struct lx_shape *shape, const struct lx_tree_triangle *triangle, int c)
{
    const double *corner = triangle->corners[c];
    const lx_bounded3 place = {lx_rounded(corner[0], 0, 1), lx_rounded(corner[1], 0, 1), lx_rounded(corner[2], 0, 1)};
    lx_bounded3 made = lx_mul3(leave_bounded(shape, place), lx_exact(lx_mesh_size_of(shape)));
    made.x.error += shape->own[1], made.y.error += shape->own[1], made.z.error += shape->own[1];
    return made;
}

/* The shares of a triangle's corners at a place, times the square of its normal. */
static void shares_at(const lx_bounded3 corners[3], lx_bounded3 normal, lx_bounded3 place, lx_bounded shares[3])
{
    for (int c = 0; c < 3; c++) {
        const lx_bounded3 a = corners[(c + 1) % 3], b = corners[(c + 2) % 3];
        shares[c] = lx_dot3(lx_cross3(lx_sub3(b, a), lx_sub3(place, a)), normal);
    }
}

/* The unit normal to shade by, turned as the triangle's corners run. */
static lx_bounded3 shading_bounded(const struct lx_shape *shape, const struct lx_tree_triangle *triangle,
                                   const lx_bounded3 corners[3], lx_bounded3 own, lx_bounded3 place)
{
    const struct lx_mesh_body *body = body_of(shape);
    const unsigned *of = normals_of(body, triangle);
    lx_bounded shares[3];
    if (!of)
        return lx_unit3(own);
    shares_at(corners, own, place, shares);
    lx_bounded3 mixed = {{0, 0}, {0, 0}, {0, 0}};
    for (int c = 0; c < 3; c++)
        mixed = lx_add3(mixed, lx_mul3(lx_exact3(body->normals->normals[of[c]]), shares[c]));
    if (!(lx_square3(mixed).value > 0))
        return lx_unit3(own);
    return lx_unit3(leave_bounded(shape, mixed));
}

struct lx_hit lx_mesh_hit(const struct lx_shape *shape, const struct lx_ray *ray)
{
    const struct lx_mesh_body *body = body_of(shape);
    double from[3];
    for (int k = 0; k < 3; k++)
        from[k] = ray->origin_mm[k] - shape->anchor_mm[k];
    const struct lx_tree_ray in_tree = ray_in_tree(shape, from, ray->direction);
    const struct lx_tree_hit met = lx_tree_first(body->tree, &in_tree, body->fronts_only);
    if (!met.triangle)
        return (struct lx_hit){.exists = false};
    lx_bounded3 corners[3];
    for (int c = 0; c < 3; c++)
        corners[c] = corner_in_space(shape, met.triangle, c);
    const lx_bounded3 own = lx_cross3(lx_sub3(corners[1], corners[0]), lx_sub3(corners[2], corners[0]));
    /* from where the tree found it on, so that what the triangle's normal is off is not multiplied by the distance */
    const lx_bounded3 direction = lx_exact3(ray->direction);
    const lx_bounded3 start =
        lx_add3(lx_sub3(lx_exact3(ray->origin_mm), lx_exact3(shape->anchor_mm)), lx_mul3(direction, lx_exact(met.t)));
    const lx_bounded rest = lx_div(lx_dot3(own, lx_sub3(corners[0], start)), lx_dot3(own, direction));
    const lx_bounded3 place = lx_add3(start, lx_mul3(direction, rest));
    struct lx_hit hit = {.exists = true, .t = met.t + rest.value};
    hit.place_mm = lx_add3(lx_exact3(shape->anchor_mm), place);
    hit.normal = shading_bounded(shape, met.triangle, corners, own, place);
    lx_keep_coordinates(ray, &hit.place_mm);
    if (!met.is_front)
        hit.normal = lx_negate3(hit.normal);
    return hit;
}

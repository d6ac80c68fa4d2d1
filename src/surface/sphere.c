/* SPDX-License-Identifier: MIT */
/*
 * The sphere: its parameters, extent, and float64 reference: where a ray meets it, whether it stands between a
 * place and a light.  The kernels of the shade room hold the same formulas for blocks of rays.
 */
#include <math.h>
#include <string.h>

#include "surface.h"

static const struct lx_parameter sphere_parameters[] = {
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct lx_sphere_parameters, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .advised = {LX_BETWEEN(-10000, 10000), LX_BETWEEN(-10000, 10000), LX_BETWEEN(100, 10000)},
        .meaning = "where the centre of the sphere lies: x to the right, y up, z towards the observer",
    },
    {
        .name = "radius",
        .label = "Radius",
        .type = LX_REAL,
        .offset = offsetof(struct lx_sphere_parameters, radius_mm),
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(50, 2000)},
        .meaning = "the radius of the sphere",
    },
};

static const struct lx_table sphere_table = {
    .parameters = sphere_parameters,
    .count = LX_COUNT(sphere_parameters),
    .size = sizeof(struct lx_sphere_parameters),
};

static void sphere_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct lx_sphere_parameters *sphere = parameters;
    for (int i = 0; i < 3; i++) {
        low_mm[i] = sphere->center_mm[i] - sphere->radius_mm;
        high_mm[i] = sphere->center_mm[i] + sphere->radius_mm;
    }
}

static double sphere_farthest(const void *parameters, const double direction[3])
{
    const struct lx_sphere_parameters *sphere = parameters;
    double length = hypot(hypot(direction[0], direction[1]), direction[2]), along = 0;
    for (int i = 0; i < 3; i++)
        along += sphere->center_mm[i] * direction[i];
    return along + sphere->radius_mm * length;
}

static struct lx_shape sphere_shape(const void *parameters)
{
    const struct lx_sphere_parameters *sphere = parameters;
    struct lx_shape shape = {.type = LX_SPHERE, .radius_mm = sphere->radius_mm};
    memcpy(shape.anchor_mm, sphere->center_mm, sizeof shape.anchor_mm);
    return shape;
}

/*
 * With w = direction x (origin - centre) and a = direction^2, the ray passes the centre at the distance
 * |w|/sqrt(a); the offset of that nearest point is p = (w x direction)/a, and the hit lies before it by
 * sqrt(a R^2 - |w|^2)/a of the direction.  Near the limb a R^2 - |w|^2 cancels, so it is formed in twice the
 * precision.
 */
static lx_bounded discriminant(const struct lx_ray *ray, const struct lx_pair from[3], double radius, lx_bounded3 *w,
                               lx_bounded *a)
{
    const double *d = ray->direction;
    struct lx_pair cross[3];
    double errors[4];
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        cross[i] = lx_exact_dot(4, (double[]){d[j], d[j], -d[k], -d[k]},
                                (double[]){from[k].high, from[k].low, from[j].high, from[j].low}, &errors[i]);
    }
    struct lx_pair square = lx_exact_dot(3, d, d, &errors[3]);
    struct lx_pair r2 = lx_exact_product(radius, radius);
    double rest;
    struct lx_pair result =
        lx_exact_dot(9,
                     (double[]){square.high, square.high, square.low, -cross[0].high, -cross[1].high, -cross[2].high,
                                -2 * cross[0].high, -2 * cross[1].high, -2 * cross[2].high},
                     (double[]){r2.high, r2.low, r2.high, cross[0].high, cross[1].high, cross[2].high, cross[0].low,
                                cross[1].low, cross[2].low},
                     &rest);
    /* the parts' errors, and the products of two low parts that were left out */
    double w_error = errors[0] + errors[1] + errors[2];
    double w_size = fabs(cross[0].high) + fabs(cross[1].high) + fabs(cross[2].high);
    double left_out = 4 * LX_ROUNDING * LX_ROUNDING * (square.high * r2.high + w_size * w_size);
    *w = (lx_bounded3){lx_rounded(cross[0].high, errors[0], 1), lx_rounded(cross[1].high, errors[1], 1),
                       lx_rounded(cross[2].high, errors[2], 1)};
    *a = lx_rounded(square.high, errors[3], 1);
    return lx_rounded(result.high, rest + errors[3] * r2.high + (2 * w_size + w_error) * w_error + left_out, 1);
}

static struct lx_hit sphere_hit(const struct lx_shape *sphere, const struct lx_ray *ray)
{
    struct lx_pair from[3];
    for (int i = 0; i < 3; i++)
        from[i] = lx_exact_difference(ray->origin_mm[i], sphere->anchor_mm[i]);
    lx_bounded3 w, direction = lx_exact3(ray->direction);
    lx_bounded a;
    lx_bounded below = discriminant(ray, from, sphere->radius_mm, &w, &a);
    if (!(below.value >= 0))
        return (struct lx_hit){.exists = false};

    lx_bounded root = lx_sqrt(below);
    double along = 0;
    for (int i = 0; i < 3; i++)
        along += ray->direction[i] * from[i].high;
    lx_bounded3 foot = lx_cross3(w, direction);
    lx_bounded3 before = lx_mul3(direction, root);
    lx_bounded3 offset = lx_sub3(foot, before);
    offset = (lx_bounded3){lx_div(offset.x, a), lx_div(offset.y, a), lx_div(offset.z, a)};
    lx_bounded radius = lx_exact(sphere->radius_mm);
    return (struct lx_hit){
        .exists = true,
        .t = (-along - root.value) / a.value,
        .place_mm = lx_add3(lx_exact3(sphere->anchor_mm), offset),
        .normal = {lx_div(offset.x, radius), lx_div(offset.y, radius), lx_div(offset.z, radius)},
    };
}

/*
 * The nearest point of the way to the centre lies at t = -(p . d)/d^2, p the place from the centre, cut to the
 * way's ends.  The sphere blocks where that point is nearer than the radius, unless both ends are inside: then the
 * way does not cross the surface.
 */
static lx_bounded sphere_blocks(const struct lx_shape *sphere, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    lx_bounded radius = lx_exact(sphere->radius_mm);
    lx_bounded3 p = lx_sub3(place_mm, lx_exact3(sphere->anchor_mm));
    lx_bounded t = lx_positive(lx_div(lx_negate(lx_dot3(p, towards)), lx_square3(towards)));
    if (!endless && t.value >= 1)
        t = (lx_bounded){1, t.error};
    lx_bounded3 nearest = lx_add3(p, lx_mul3(towards, t));
    lx_bounded reached = lx_step(lx_sub(radius, lx_length3(nearest)), false);
    if (endless)
        return reached;
    lx_bounded from_inside = lx_step(lx_sub(radius, lx_length3(p)), false);
    lx_bounded to_inside = lx_step(lx_sub(radius, lx_length3(lx_add3(p, towards))), false);
    return lx_both(reached, lx_not(lx_both(from_inside, to_inside)));
}

static bool sphere_holds(const struct lx_shape *sphere, const double place_mm[3])
{
    lx_bounded3 p = lx_sub3(lx_exact3(place_mm), lx_exact3(sphere->anchor_mm));
    return fabs(lx_length3(p).value - sphere->radius_mm) <= 1e-9 * sphere->radius_mm;
}

static enum lx_standing sphere_standing(const void *parameters, double observer_z_mm, bool perspective)
{
    const struct lx_sphere_parameters *sphere = parameters;
    (void)perspective;
    return observer_z_mm > sphere->center_mm[2] + sphere->radius_mm ? LX_STANDS_BEFORE : LX_STANDS_TOO_LOW;
}

/* The source is inside, or behind and in the shadow of the outline. */
static bool sphere_is_dark(const void *parameters, const double place_mm[3])
{
    const struct lx_sphere_parameters *sphere = parameters;
    double q[3];
    for (int i = 0; i < 3; i++)
        q[i] = (place_mm[i] - sphere->center_mm[i]) / sphere->radius_mm;
    return q[0] * q[0] + q[1] * q[1] + (q[2] < 0 ? 0 : q[2] * q[2]) <= 1;
}

const struct lx_surface_kind lx_sphere_kind = {
    .variant =
        {
            .name = "sphere",
            .meaning = "a sphere, seen from outside",
            .example = "{type: sphere, center: [0, 0, 1000], radius: 200, material: {diffuse: 0.7, shininess: 40}}",
            .table = &sphere_table,
        },
    .extent = sphere_extent,
    .farthest = sphere_farthest,
    .shape = sphere_shape,
    .hit = sphere_hit,
    .blocks = sphere_blocks,
    .holds = sphere_holds,
    .standing = sphere_standing,
    .is_dark = sphere_is_dark,
};

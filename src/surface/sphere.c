/* SPDX-License-Identifier: MIT */
/*
 * The sphere: its parameters, extent, and float64 reference: where a ray meets it, whether it stands between a
 * place and a light.  The kernels of the shade room hold the same formulas for blocks of rays.
 */
#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "../base/vector.h"
#include "authored.h"
#include "sheet.h"
#include "sphere.h"

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
    {
        .name = "inside",
        .label = "Seen from inside",
        .type = LX_BOOLEAN,
        .offset = offsetof(struct lx_sphere_parameters, inside),
        .initial = "false",
        .meaning =
            "whether its inner side is seen and lit, as of an integrating sphere; an observer outside does not see "
            "the near half",
    },
};

static const struct lx_table sphere_table = {
    .parameters = sphere_parameters,
    .count = LX_COUNT(sphere_parameters),
    .size = sizeof(struct lx_sphere_parameters),
};

void lx_sphere_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct lx_sphere_parameters *sphere = parameters;
    for (int i = 0; i < 3; i++) {
        low_mm[i] = sphere->center_mm[i] - sphere->radius_mm;
        high_mm[i] = sphere->center_mm[i] + sphere->radius_mm;
    }
}

double lx_sphere_farthest(const void *parameters, const double direction[3])
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
    return sphere->inside ? lx_inside_kind.shape(sphere) : shape;
}

static bool sphere_surrounds(const void *parameters, const double place_mm[3])
{
    const struct lx_sphere_parameters *sphere = parameters;
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - sphere->center_mm[i];
    return sphere->inside && lx_dot(from, from) < sphere->radius_mm * sphere->radius_mm;
}

/* What a ray's own errors make of the product of its direction along i and its origin along k. */
static double moment_error(const struct lx_ray *ray, const struct lx_pair from[3], int i, int k)
{
    return ray->direction_error[i] * (fabs(from[k].high) + ray->origin_error[k]) +
           fabs(ray->direction[i]) * ray->origin_error[k];
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
        errors[i] += moment_error(ray, from, j, k) + moment_error(ray, from, k, j);
    }
    struct lx_pair square = lx_exact_dot(3, d, d, &errors[3]);
    for (int i = 0; i < 3; i++)
        errors[3] += (2 * fabs(d[i]) + ray->direction_error[i]) * ray->direction_error[i];
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

/* Lengths are taken in a power of two that is near the radius: squares of the smallest and largest hold. */
struct lx_hit lx_sphere_meet(const struct lx_shape *sphere, const struct lx_ray *ray, bool farther)
{
    const double unit_mm = ldexp(1, ilogb(fmax(sphere->radius_mm, DBL_MIN)));
    struct lx_ray scaled = *ray;
    struct lx_pair from[3];
    for (int i = 0; i < 3; i++) {
        from[i] = lx_exact_difference(ray->origin_mm[i], sphere->anchor_mm[i]);
        from[i] = (struct lx_pair){from[i].high / unit_mm, from[i].low / unit_mm};
        scaled.origin_error[i] /= unit_mm;
    }
    lx_bounded3 w, direction = lx_ray_direction(ray);
    lx_bounded a, radius = lx_exact(sphere->radius_mm / unit_mm);
    lx_bounded below = discriminant(&scaled, from, radius.value, &w, &a);
    if (!(below.value >= 0))
        return (struct lx_hit){.exists = false};

    lx_bounded root = lx_sqrt(below);
    if (farther)
        root.value = -root.value;
    double along = 0;
    for (int i = 0; i < 3; i++)
        along += ray->direction[i] * from[i].high;
    lx_bounded3 foot = lx_cross3(w, direction);
    lx_bounded3 before = lx_mul3(direction, root);
    lx_bounded3 offset = lx_sub3(foot, before);
    offset = (lx_bounded3){lx_div(offset.x, a), lx_div(offset.y, a), lx_div(offset.z, a)};
    return (struct lx_hit){
        .exists = true,
        .t = (-along - root.value) / a.value * unit_mm,
        .place_mm = lx_add3(lx_exact3(sphere->anchor_mm), lx_scale3(offset, unit_mm)),
        .normal = {lx_div(offset.x, radius), lx_div(offset.y, radius), lx_div(offset.z, radius)},
    };
}

static struct lx_hit sphere_hit(const struct lx_shape *sphere, const struct lx_ray *ray)
{
    return lx_sphere_meet(sphere, ray, false);
}

/*
 * The nearest point of the way to the centre lies at t = -(p . d)/d^2, p the place from the centre, cut to the
 * way's ends.  The sphere blocks where that point is nearer than the radius, unless both ends are inside: then the
 * way does not cross the surface.
 */
lx_bounded lx_sphere_reached(const struct lx_shape *sphere, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    lx_bounded radius = lx_exact(sphere->radius_mm);
    lx_bounded3 p = lx_sub3(place_mm, lx_exact3(sphere->anchor_mm));
    lx_bounded t = lx_positive(lx_div(lx_negate(lx_dot3(p, towards)), lx_square3(towards)));
    if (!endless && t.value >= 1)
        t = (lx_bounded){1, t.error};
    lx_bounded3 nearest = lx_add3(p, lx_mul3(towards, t));
    return lx_step(lx_sub(radius, lx_length3(nearest)), false);
}

static lx_bounded sphere_blocks(const struct lx_shape *sphere, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    lx_bounded reached = lx_sphere_reached(sphere, place_mm, towards, endless);
    if (endless)
        return reached;
    lx_bounded radius = lx_exact(sphere->radius_mm);
    lx_bounded3 p = lx_sub3(place_mm, lx_exact3(sphere->anchor_mm));
    lx_bounded from_inside = lx_step(lx_sub(radius, lx_length3(p)), false);
    lx_bounded to_inside = lx_step(lx_sub(radius, lx_length3(lx_add3(p, towards))), false);
    return lx_both(reached, lx_not(lx_both(from_inside, to_inside)));
}

bool lx_sphere_holds(const struct lx_shape *sphere, const double place_mm[3])
{
    lx_bounded3 p = lx_sub3(lx_exact3(place_mm), lx_exact3(sphere->anchor_mm));
    return fabs(lx_length3(p).value - sphere->radius_mm) <= 1e-9 * sphere->radius_mm;
}

/* The source is inside, or behind and in the shadow of the outline. */
static bool sphere_is_dark(const struct lx_shape *sphere, const double place_mm[3])
{
    double q[3];
    for (int i = 0; i < 3; i++)
        q[i] = (place_mm[i] - sphere->anchor_mm[i]) / sphere->radius_mm;
    return q[0] * q[0] + q[1] * q[1] + (q[2] < 0 ? 0 : q[2] * q[2]) <= 1;
}

static void sphere_normal(const struct lx_shape *sphere, const double offset_mm[3], double normal[3])
{
    for (int i = 0; i < 3; i++)
        normal[i] = offset_mm[i] / sphere->radius_mm;
}

/*
 * An element that looks outwards loses the light from below the tangent plane.  One that looks inwards, such as that of
 * a table where a ball touches it, has what is inside the sphere in front of it, and loses all light from outside.
 */
static lx_bounded sphere_hides(const struct lx_shape *sphere, lx_bounded3 place_mm, double facing, lx_bounded3 towards,
                               bool endless)
{
    lx_bounded3 from = lx_sub3(place_mm, lx_exact3(sphere->anchor_mm));
    if (facing >= 0)
        return lx_step(lx_negate(lx_dot3(from, towards)), false);
    if (endless)
        return lx_exact(1);
    return lx_step(lx_sub(lx_length3(lx_add3(from, towards)), lx_exact(sphere->radius_mm)), false);
}

/* From on the sphere and outwards it is seen from outside, whatever rounding says of the place. */
static int sphere_gather(const struct lx_shape *sphere, const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    const double touch = 1e-12 * sphere->radius_mm;
    struct lx_obstacle ball = {.type = LX_OBSTACLE_BALL, .radius_mm = sphere->radius_mm, .touch_mm = touch};
    double offset[3];
    if (!lx_shaft_meets_ball(shaft, sphere->anchor_mm, sphere->radius_mm))
        return 0;
    memcpy(ball.center_mm, sphere->anchor_mm, sizeof ball.center_mm);
    for (int i = 0; i < 3; i++)
        offset[i] = shaft->from_mm[i] - sphere->anchor_mm[i];
    ball.is_around = sqrt(lx_dot(offset, offset)) < sphere->radius_mm - touch;
    return lx_obstacles_append(obstacles, &ball);
}

static int sphere_gather_beside(const struct lx_shape *sphere, double facing, const struct lx_obstacle *beyond,
                                const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    if (facing >= 0)
        return lx_obstacles_append(obstacles, beyond);
    struct lx_obstacle ball = {.type = LX_OBSTACLE_BALL, .is_around = true, .radius_mm = sphere->radius_mm};
    memcpy(ball.center_mm, sphere->anchor_mm, sizeof ball.center_mm);
    (void)shaft;
    return lx_obstacles_append(obstacles, &ball);
}

static bool sphere_encloses(const struct lx_shape *sphere, const double place_mm[3])
{
    lx_bounded3 from = lx_sub3(lx_exact3(place_mm), lx_exact3(sphere->anchor_mm));
    return lx_length3(from).value < (1 - 1e-9) * sphere->radius_mm;
}

static double sphere_distance(const struct lx_shape *sphere, const double offset_mm[3], double direction[3])
{
    double length = sqrt(lx_dot(offset_mm, offset_mm));
    for (int i = 0; i < 3; i++)
        direction[i] = length > 0 ? offset_mm[i] / length : 0;
    return length - sphere->radius_mm;
}

/* How far the way from a place passes outside of the sphere. */
double lx_sphere_beside(const struct lx_shape *sphere, const double place[3], const double way[3], bool endless)
{
    double from[3], nearest[3];
    for (int i = 0; i < 3; i++)
        from[i] = place[i] - sphere->anchor_mm[i];
    double t = fmax(-lx_dot(from, way) / lx_dot(way, way), 0);
    if (!endless && t > 1)
        t = 1;
    for (int i = 0; i < 3; i++)
        nearest[i] = from[i] + t * way[i];
    return hypot(hypot(nearest[0], nearest[1]), nearest[2]) - sphere->radius_mm;
}

/* The sphere itself, and the cylinder, or cone, of the ways to the light that touch it. */
double lx_sphere_shadow_edge(const struct lx_shape *sphere, const struct lx_origin *light, unsigned i,
                             const double place_mm[3])
{
    double from[3], axis[3];
    for (int k = 0; k < 3; k++)
        from[k] = place_mm[k] - sphere->anchor_mm[k];
    const double square = lx_dot(from, from), r2 = sphere->radius_mm * sphere->radius_mm;
    if (i == 0)
        return square - r2;
    if (light->endless) {
        const double along = lx_dot(light->at, from);
        return square - along * along - r2;
    }
    for (int k = 0; k < 3; k++) {
        axis[k] = sphere->anchor_mm[k] - light->at[k];
        from[k] = place_mm[k] - light->at[k];
    }
    const double sine = sphere->radius_mm / sqrt(lx_dot(axis, axis));
    if (!(sine < 1))
        return (double)NAN;
    lx_normalize(axis);
    const double along = lx_dot(axis, from);
    return along * along - (1 - sine) * (1 + sine) * lx_dot(from, from);
}

/* The middle direction of the part that faces the observer; returns the cosine of its rim. */
double lx_sphere_front(const struct lx_shape *sphere, const struct lx_origin *eye, double front[3])
{
    bool endless = lx_way_to(eye, sphere->anchor_mm, front);
    double distance_mm = lx_normalize(front);
    return endless ? 0 : sphere->radius_mm / distance_mm;
}

void lx_sphere_outline(const struct lx_shape *sphere, const struct lx_origin *eye, int i, int steps, double place_mm[3],
                       double inside_mm[3])
{
    double front[3], aside[3] = {1, 0, 0}, up[3] = {0, 1, 0};
    const double height = lx_sphere_front(sphere, eye, front), around = sqrt(1 - height * height);
    const double turn = 2 * M_PI * i / steps;
    if (!eye->endless) {
        aside[0] = front[2], aside[1] = 0, aside[2] = -front[0]; /* up x front */
        lx_normalize(aside);
        for (int k = 0; k < 3; k++)
            up[k] = front[(k + 1) % 3] * aside[(k + 2) % 3] - front[(k + 2) % 3] * aside[(k + 1) % 3];
    }
    for (int k = 0; k < 3; k++) {
        place_mm[k] = sphere->anchor_mm[k] +
                      sphere->radius_mm * (height * front[k] + around * (cos(turn) * aside[k] + sin(turn) * up[k]));
        inside_mm[k] = place_mm[k] + 1e-3 * (sphere->anchor_mm[k] - place_mm[k]);
    }
}

/* ---- coordinates: the unit normal ---- */

static void locate_on_sphere(const struct lx_shape *sphere, const double offset_mm[3], const double normal[3],
                             double at[3])
{
    (void)sphere, (void)offset_mm;
    memcpy(at, normal, 3 * sizeof *at);
    lx_normalize(at);
}

static void place_on_sphere(const struct lx_shape *sphere, const double at[3], double place_mm[3], double normal[3])
{
    for (int i = 0; i < 3; i++) {
        place_mm[i] = sphere->anchor_mm[i] + sphere->radius_mm * at[i];
        normal[i] = at[i];
    }
}

static void element_on_sphere(const struct lx_shape *sphere, const double at[3], lx_bounded3 *place_mm,
                              lx_bounded3 *normal)
{
    *normal = lx_unit3(lx_exact3(at));
    *place_mm = lx_add3(lx_exact3(sphere->anchor_mm), lx_mul3(*normal, lx_exact(sphere->radius_mm)));
}

/* Across the axis that is farthest from the normal. */
void lx_sphere_directions(const struct lx_shape *sphere, const double n[3], double first[3], double second[3])
{
    (void)sphere;
    int least = fabs(n[0]) <= fabs(n[1]) ? 0 : 1;
    least = fabs(n[2]) < fabs(n[least]) ? 2 : least;
    for (int i = 0; i < 3; i++)
        first[i] = (i == least) - n[least] * n[i];
    lx_normalize(first);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        second[i] = n[j] * first[k] - n[k] * first[j];
    }
}

void lx_sphere_move(const struct lx_shape *sphere, const double at[3], const double first[3], const double second[3],
                    const double step_mm[2], double moved[3])
{
    for (int i = 0; i < 3; i++)
        moved[i] = at[i] + (step_mm[0] * first[i] + step_mm[1] * second[i]) / sphere->radius_mm;
    lx_normalize(moved);
}

static double wall_of_sphere(const struct lx_shape *sphere, const struct lx_origin *eye, unsigned i, const double at[3])
{
    double front[3], rim = lx_sphere_front(sphere, eye, front);
    (void)i;
    return sphere->radius_mm * (lx_dot(at, front) - rim);
}

void lx_sphere_rim(const struct lx_shape *sphere, const struct lx_origin *eye, int i, int count, double at[3])
{
    double front[3], first[3], second[3], out[3], rim = lx_sphere_front(sphere, eye, front),
                                                  turn = 2 * M_PI * i / count;
    lx_sphere_directions(sphere, front, first, second);
    for (int k = 0; k < 3; k++)
        out[k] = cos(turn) * first[k] + sin(turn) * second[k];
    double along = lx_dot(out, front), sine = sqrt(1 - rim * rim);
    for (int k = 0; k < 3; k++)
        out[k] -= along * front[k];
    lx_normalize(out);
    for (int k = 0; k < 3; k++)
        at[k] = rim * front[k] + sine * out[k];
}

static void middle_of_sphere(const struct lx_shape *sphere, const struct lx_origin *eye, double at[3])
{
    lx_sphere_front(sphere, eye, at);
}

static bool is_near_limb(const struct lx_shape *sphere, const struct lx_origin *eye, const double at[3],
                         double inside_mm[3])
{
    double front[3], rim = lx_sphere_front(sphere, eye, front);
    memcpy(inside_mm, sphere->anchor_mm, 3 * sizeof *inside_mm);
    return lx_dot(at, front) < rim + 1e-3;
}

/* Where the sphere mirrors a light to the observer: between the two directions, where both make the same angle. */
static void find_mirror(const struct lx_shape *sphere, const struct lx_origin *origin, const struct lx_origin *viewer,
                        double at[3])
{
    double eye[3], light[3], across[3], place[3], normal[3], way[3], view[3];
    lx_way_to(viewer, sphere->anchor_mm, eye);
    lx_normalize(eye);
    lx_way_to(origin, sphere->anchor_mm, light);
    lx_normalize(light);
    double along = lx_dot(eye, light);
    for (int i = 0; i < 3; i++)
        across[i] = light[i] - along * eye[i];
    double angle = atan2(lx_normalize(across), along), low = 0, high = angle;
    for (int step = 0; step < 60; step++) {
        double middle = (low + high) / 2;
        for (int i = 0; i < 3; i++)
            at[i] = cos(middle) * eye[i] + sin(middle) * across[i];
        place_on_sphere(sphere, at, place, normal);
        lx_way_to(viewer, place, view);
        lx_normalize(view);
        lx_way_to(origin, place, way);
        lx_normalize(way);
        if (lx_dot(normal, way) < lx_dot(normal, view))
            low = middle;
        else
            high = middle;
    }
}

static int guess_on_sphere(const struct lx_shape *sphere, const struct lx_origin *light, const struct lx_origin *viewer,
                           bool for_least, double at[LX_MOST_GUESSES][3])
{
    int count = 1;
    lx_way_to(light, sphere->anchor_mm, at[0]);
    lx_normalize(at[0]);
    for (int i = 0; i < 3 && for_least; i++)
        at[1][i] = -at[0][i];
    count += for_least;
    find_mirror(sphere, light, viewer, at[count]);
    return count + 1;
}

static const struct lx_surface_chart sphere_chart = {
    .by_normal = true,
    .locate = locate_on_sphere,
    .place = place_on_sphere,
    .element = element_on_sphere,
    .directions = lx_sphere_directions,
    .move = lx_sphere_move,
    .walls = 1,
    .wall = wall_of_sphere,
    .rim = lx_sphere_rim,
    .middle = middle_of_sphere,
    .is_near_limb = is_near_limb,
    .guess = guess_on_sphere,
};

/* ---- bounds and words ---- */

static double sphere_support(const struct lx_shape *sphere, const double direction[3], double place[3])
{
    (void)direction;
    place[0] = place[1] = place[2] = 0;
    return sphere->radius_mm;
}

static double sphere_curvature(const struct lx_shape *sphere)
{
    return 1 / sphere->radius_mm;
}

static int sphere_sheets(const struct lx_shape *sphere, struct lx_smooth_sheet *sheets)
{
    return lx_sheets_of_ball(sphere, false, sheets);
}

static const struct lx_surface_bounds sphere_bounds = {
    .support = sphere_support,
    .widest_turn = M_PI_2,
    .curvature = sphere_curvature,
};

static const struct lx_surface_words sphere_words = {
    .height = "z = z_C + \\sqrt{R^2 - (x - x_C)^2 - (y - y_C)^2}",
    .height_in_numbers = "@Z + \\sqrt{@R^2 - (@x - @X)^2 - (@y - @Y)^2} = @z",
    .normal = "\\frac{\\mathbf{P} - \\mathbf{C}}{R}",
    .sentence = LX_N("The normal of a sphere with the centre {0} and the radius {1} there is {2}."),
    .formulas = {"\\mathbf{C}", "R", "\\mathbf{N} = (\\mathbf{P} - \\mathbf{C}) / R"},
};

const struct lx_surface_kind lx_sphere_kind = {
    .variant =
        {
            .name = "sphere",
            .meaning = "a sphere, seen from outside or from inside",
            .example = "{type: sphere, center: [0, 0, 1000], radius: 200, material: {diffuse: 0.7, shininess: 40}}",
            .table = &sphere_table,
        },
    .extent = lx_sphere_extent,
    .farthest = lx_sphere_farthest,
    .shape = sphere_shape,
    .hit = sphere_hit,
    .blocks = sphere_blocks,
    .holds = lx_sphere_holds,
    .normal = sphere_normal,
    .is_dark = sphere_is_dark,
    .surrounds = sphere_surrounds,
    .hides = sphere_hides,
    .gather = sphere_gather,
    .gather_beside = sphere_gather_beside,
    .encloses = sphere_encloses,
    .distance = sphere_distance,
    .beside = lx_sphere_beside,
    .shadow_edges = 2,
    .shadow_edge = lx_sphere_shadow_edge,
    .outline = lx_sphere_outline,
    .sheets = sphere_sheets,
    .chart = &sphere_chart,
    .bounds = &sphere_bounds,
    .words = &sphere_words,
};

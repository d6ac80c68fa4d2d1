/* SPDX-License-Identifier: MIT */
/*
 * A-priori bounds of the float32 kernels' rounding errors.
 *
 * With u the unit roundoff of float32, a light at the distance D from the anchor of a surface that reaches no
 * farther than R from there, and r its least distance from the surface, the direction L is off by at most about
 * u((D + R)/r + 3); the normal, the view vector and the products add a few u.  The diffuse part inherits these
 * absolutely.  A lobe S^n turns an error d of its angle into at most max(1, 0.61 sqrt(n)) d, the largest slope of
 * exp(-n a^2/2), because the kernel raises 1 - t, t = 1 - cos from the difference of the vectors; the power itself is
 * good to 12 u.  E_perp has a relative error, which is harmless
 * in itself.  Where light jumps or rises steeply, float64 decides (kernel_edge.h).  What float32 cannot do at all
 * (slopes that are infinite) has an infinite bound.
 */
#include <float.h>
#include <math.h>

#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "../world/camera.h"
#include "precision.h"
#include "area_light.h"

static const double unit = 5.9604644775390625e-08; /* u = 2^-24 */

/*
 * How large the bounds may be, as a share of the picture's maximum, which may be off by 2e-6: no picture comes near
 * its bounds.  With this allowance the worst of 12 000 random scenes of spheres is off by 7e-7, with 4e-6 by
 * 1.05e-6; the worst of 10 000 with plates by 1.0e-6 (tests/unit/test_kernels.c).
 */
static const double allowance = 2.5e-6;

/* Beyond these sizes (mm; or strengths) products could leave the range of float32. */
static bool is_moderate(double size)
{
    return size == 0 || (fabs(size) > 1e-7 && fabs(size) < 1e9);
}

static double distance(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z); /* not hypot(): there may be millions; what leaves the range is not moderate */
}

/* The least distance of a place, given from the anchor, to the surface. */
static double least_distance(const struct lx_shape *shape, const double from[3])
{
    double direction[3];
    return fabs(lx_shape_distance(shape, from, direction));
}

/* How far the direction from the surface to a place at this distance from the anchor turns over the surface. */
static double turn_towards(const struct lx_shape *shape, double away)
{
    return away > shape->radius_mm ? asin(shape->radius_mm / away) : shape->kind->bounds->widest_turn;
}

/* The least length of L + V over the surface: 2 cos of half the largest angle between L and V. */
static double least_half_length(const struct lx_prepared *prepared, const struct lx_shape *shape,
                                const struct lx_emitter *emitter, double light_distance)
{
    const struct lx_camera *camera = &prepared->camera;
    const double *center = shape->anchor_mm;
    double eye[3] = {-center[0], -center[1], camera->z_mm - center[2]}, light[3];
    double spread = 0, eye_distance = 0; /* how far L and V turn over the surface; 0: the eye is a direction */
    if (camera->is_parallel) {
        eye[0] = eye[1] = 0, eye[2] = 1;
    } else {
        eye_distance = distance((double[]){0, 0, camera->z_mm}, center);
        spread += turn_towards(shape, eye_distance);
    }
    lx_emitter_origin(emitter, light);
    for (int i = 0; i < 3 && !lx_is_endless(emitter); i++)
        light[i] -= center[i];
    if (!lx_is_endless(emitter))
        spread += turn_towards(shape, light_distance);
    double zero[3] = {0, 0, 0};
    double cosine = lx_dot(eye, light) / (distance(eye, zero) * distance(light, zero));
    double angle = fmin(acos(fmax(-1, fmin(1, cosine))) + spread, M_PI);
    double least = 2 * cos(angle / 2);
    const struct lx_surface_bounds *bounds = shape->kind->bounds;
    if (!bounds->least_cosine)
        return least;
    /* L + V is no shorter than its part along the normal */
    return fmax(least,
                bounds->least_cosine(shape, eye, eye_distance) + bounds->least_cosine(shape, light, light_distance));
}

static double greatest_attenuation(const struct lx_emitter *emitter, double nearest_mm)
{
    double nearest_m = fmax(nearest_mm, 1e-6) / 1000;
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return 1 / (nearest_m * nearest_m);
    case LX_PRACTICAL: return 1 / (emitter->k_mm / 1000 + nearest_m);
    case LX_POLYNOMIAL: return lx_by_polynomial(emitter->coefficients, nearest_m);
    case LX_NO_ATTENUATION: break;
    }
    return 1;
}

/* Coefficients are multiplied by distances in metres up to their square, where these are moderate. */
static bool has_moderate_law(const struct lx_emitter *emitter)
{
    for (int i = 0; i < 3 && emitter->attenuation == LX_POLYNOMIAL; i++)
        if (emitter->coefficients[i] != 0 && !(emitter->coefficients[i] > 1e-20 && emitter->coefficients[i] < 1e9))
            return false;
    return is_moderate(emitter->k_mm);
}

/* The error of the brightness for a unit of E_perp. */
static double lobe_error(const struct lx_lobe *lobe, double least_half, double off)
{
    double error = lobe->diffuse.value * (off + 2 * unit);
    if (!lx_lobe_shines(lobe))
        return error;
    double angle = lx_power_lobe_of(lobe->model)->angle_error(off, least_half, unit);
    double weight = LX_FALLS_TO_HORIZON(lobe->highlight) ? off + unit : 0;
    return error + lobe->specular.value * (lx_power_slope(lobe->exponent) * angle + weight + 12 * unit);
}

double lx_bound_stand(const struct lx_shape *shape, const struct lx_lobe *lobe, const struct lx_emitter *emitter,
                      double strength, const struct lx_stand *stand)
{
    double radius = shape->radius_mm, off = unit, attenuation = 1, relative = 2 * unit, of_profile = 0;
    if (lx_is_point(emitter)) {
        double moved = unit * (stand->away_mm + radius) / stand->nearest_mm;
        off = moved + 3 * unit;
        of_profile = lx_profile_error_single(&emitter->profile, off + 2 * unit, moved);
        relative = 2 * moved + 4 * unit;
        attenuation = greatest_attenuation(emitter, stand->nearest_mm);
    }
    double greatest = strength * attenuation, bound = greatest * lobe_error(lobe, stand->least_half, off);
    if (!emitter->profile.luminaire) /* it is 1 where it is greatest, */
        relative += of_profile;
    else /* and a luminaire's slope may be where its value is small */
        bound += greatest * (lobe->diffuse.value + lobe->specular.value) * of_profile;
    bool moderate = is_moderate(radius) && is_moderate(stand->away_mm) && is_moderate(strength) &&
                    has_moderate_law(emitter) && is_moderate(greatest) && is_moderate(lobe->diffuse.value) &&
                    is_moderate(lobe->specular.value);
    return moderate && bound >= 0 && relative <= allowance / 2 ? bound : HUGE_VAL;
}

double lx_bound_light(const struct lx_prepared *prepared, const struct lx_shape *shape, const struct lx_lobe *lobe,
                      const struct lx_emitter *emitter)
{
    struct lx_stand stand = {.least_half = 2};
    if (!shape->kind->bounds)
        return HUGE_VAL;
    if (lx_is_point(emitter)) {
        double from[3];
        for (int i = 0; i < 3; i++)
            from[i] = emitter->position_mm[i] - shape->anchor_mm[i];
        stand.away_mm = distance(emitter->position_mm, shape->anchor_mm);
        stand.nearest_mm = least_distance(shape, from);
    }
    if (lx_lobe_shines(lobe) && lx_power_lobe_of(lobe->model)->asks_half)
        stand.least_half = least_half_length(prepared, shape, emitter, stand.away_mm);
    return lx_bound_stand(shape, lobe, emitter, emitter->strength, &stand);
}

/* Bounds, or edges of area lights, between two questions whether to go on. */
enum { BETWEEN_CHECKS = 4096 };

static bool goes_on(const struct lx_asking *asking, size_t i)
{
    return i % BETWEEN_CHECKS != BETWEEN_CHECKS - 1 || lx_asking_goes_on(asking);
}

/* The corner of an area light that is farthest against a direction, from the anchor. */
static void farthest_corner(const struct lx_area_light *lamp, const double direction[3], const struct lx_asking *asking,
                            double corner[3])
{
    const struct lx_area_light_edge_double *edges = lamp->edges_double;
    double least = HUGE_VAL;
    size_t best = 0;
    for (size_t i = 0; i < lamp->edge_count && goes_on(asking, i); i++) {
        double height = fmin(lx_dot(direction, edges[i].from), lx_dot(direction, edges[i].to));
        best = height < least ? i : best;
        least = fmin(height, least);
    }
    const double *from = edges[best].from, *to = edges[best].to;
    for (int i = 0; i < 3; i++)
        corner[i] = lamp->center[i] + (lx_dot(direction, from) < lx_dot(direction, to) ? from : to)[i];
}

/*
 * No place of the area light is nearer to the surface than this.  The shortest way between two convex bodies is the
 * nearest point to 0 of the differences of their places: it is approached as Frank and Wolfe do (1956), and every
 * direction on the way gives a bound.  Less than 0 where they may meet.
 */
static double least_gap(const struct lx_shape *shape, const struct lx_area_light *lamp, const struct lx_asking *asking)
{
    enum { MOST_STEPS = 40 };
    double way[3] = {lamp->center[0], lamp->center[1], lamp->center[2]}, best = -HUGE_VAL, radius = 0;
    for (int step = 0; step < MOST_STEPS; step++) {
        double corner[3], point[3], length = sqrt(lx_dot(way, way)), along = 0, square = 0;
        if (!(length > 0))
            break;
        farthest_corner(lamp, way, asking, corner);
        radius = shape->kind->bounds->support(shape, way, point);
        for (int i = 0; i < 3; i++) {
            corner[i] -= point[i];
            along += way[i] * (way[i] - corner[i]);
            square += (way[i] - corner[i]) * (way[i] - corner[i]);
        }
        best = fmax(best, lx_dot(way, corner) / length);
        if (!(best < 0.99 * length))
            break;
        double share = fmax(0, fmin(1, along / square));
        for (int i = 0; i < 3; i++)
            way[i] += share * (corner[i] - way[i]);
    }
    return best - radius;
}

double lx_gap(const struct lx_shape *shape, const struct lx_area_light *lamp, const struct lx_asking *asking)
{
    if (!shape->kind->bounds)
        return -HUGE_VAL;
    return lamp->facets ? least_gap(shape, lamp, asking) : least_distance(shape, lamp->center) - lamp->radius_mm;
}

/*
 * What the terms of an area light's sum add up to at most, for a radiance of 1 and twice over: where the source is
 * near, the angles of the edges, all of which are at most 2 pi; where it is far, |edge| radius/c^2, as kernel_facets.h
 * has it.
 */
static double terms_of(const struct lx_shape *shape, const struct lx_area_light *lamp, double nearest,
                       const struct lx_asking *asking)
{
    const double radius = lamp->radius_mm, middle = fmax(least_distance(shape, lamp->center), sqrt(7) * radius);
    double edges = 0;
    for (size_t i = 0; i < lamp->edge_count && goes_on(asking, i); i++)
        edges += sqrt(lx_dot(lamp->edges_double[i].along, lamp->edges_double[i].along));
    edges = fmin(edges, 4 * M_PI * radius); /* those of the contour alone */
    const double far = edges * radius / (middle * middle), near = nearest > 0 ? edges / nearest : HUGE_VAL;
    return middle <= sqrt(7) * radius ? fmax(far, fmin(near, 2 * M_PI)) : far;
}

/*
 * Each term of the sum is good to some units of what it would be at most.  The ways to the corners are off by what
 * places are rounded.  With two roundings a term the worst of 12 000 random scenes is off by 1.0e-6 of the maximum,
 * with one by 2.3e-6 (tests/unit/test_extended_pictures.c).
 */
static const double roundings = 2;

double lx_bound_area_light(const struct lx_shape *shape, double diffuse, const struct lx_area_light *lamp,
                           const struct lx_asking *asking)
{
    if (!lamp->facets || !shape->kind->bounds)
        return HUGE_VAL;
    const double radius = lamp->radius_mm, greatest = diffuse * lamp->radiance;
    const double away = distance(lamp->center, (double[]){0, 0, 0}), nearest = least_gap(shape, lamp, asking);
    const double off = unit * (1 + (away + shape->radius_mm) / nearest);
    bool moderate = is_moderate(shape->radius_mm) && is_moderate(away) && is_moderate(nearest) && is_moderate(radius) &&
                    is_moderate(lamp->radiance) && is_moderate(diffuse) && is_moderate(greatest);
    return nearest > 0 && moderate ? greatest * terms_of(shape, lamp, nearest, asking) / 2 * roundings * off : HUGE_VAL;
}

double lx_bound_area_light_double(const struct lx_shape *shape, double diffuse, const struct lx_area_light *lamp,
                                  const struct lx_asking *asking)
{
    return diffuse * lamp->radiance * terms_of(shape, lamp, 0, asking) / 2 * roundings * DBL_EPSILON / 2;
}

/* The most that all of an area light's area would give to who faces every part of it straight: the nearer a part is,
 * the less there can be of it, as if it were a disk over whose middle the element stood so near. */
static double greatest_flow(const struct lx_area_light_law *law, double area, double nearest)
{
    enum { STEPS_OUT = 32 };
    const double turns = log1p(area / (M_PI * nearest * nearest)); /* r^2 = nearest^2 exp(turns y) */
    double sum = 0;
    for (int i = 0; i < STEPS_OUT; i++) {
        const double r = nearest * exp(turns * (i + 0.5) / (2 * STEPS_OUT));
        sum += r * r / (law->none + r * (law->root + r * law->square));
    }
    return M_PI * turns * sum / STEPS_OUT;
}

/*
 * The ways to what rules look at are formed in float64, and all that follows are sums and products of numbers that are
 * good to some units, in which heights above planes and horizons are as long as the ways.  So a sum is off by some
 * units of what the source could give at most; the worst of random spheres comes to half of the bound (tests/unit/
 * test_laws.c).  Of a ball the way is what is left of the one to its centre.
 */
double lx_bound_law(const struct lx_shape *shape, double diffuse, const struct lx_area_light *lamp,
                    const struct lx_asking *asking)
{
    const double units = 16, radius = lamp->radius_mm, away = distance(lamp->center, (double[]){0, 0, 0});
    const double nearest = lx_gap(shape, lamp, asking), farthest = away + shape->radius_mm + radius;
    const struct lx_area_light_law *law = &lamp->law;
    if (!(nearest > 0))
        return HUGE_VAL;
    const double greatest = diffuse * lamp->radiance * greatest_flow(law, lamp->turned_mm2, nearest);
    const double least = nearest * nearest * (law->none + nearest * (law->root + nearest * law->square));
    const double most = farthest * farthest * (law->none + farthest * (law->root + farthest * law->square));
    const bool moderate = is_moderate(shape->radius_mm) && is_moderate(away) && is_moderate(nearest) &&
                          is_moderate(radius) && is_moderate(greatest) && least > 1e-20 && most < 1e30;
    const double shared = lamp->is_ball ? 1 + radius / nearest : 1;
    return moderate ? units * unit * shared * greatest : HUGE_VAL;
}

/*
 * Roundings of different lights are independent: their sum grows like its root mean square, but not below a
 * third of the plain sum, since no light reaches its own bound.
 */
static bool keeps_accuracy(double sum, double sum_of_squares, double least_maximum)
{
    return fmax(sqrt(sum_of_squares), sum / 3) <= allowance * least_maximum;
}

enum { STEPS = 10 };

size_t lx_choose_precision(double *bounds, size_t count, double least_maximum, const struct lx_asking *asking,
                           struct lx_rounding_sum *rounding)
{
    /* Lights are left to float32 in the order of powers of two of their bounds, the smallest first. */
    size_t chosen = 0;
    for (int step = STEPS; step >= 0 && chosen < count; step--) {
        double limit = allowance * least_maximum * ldexp(1, -step);
        for (size_t i = 0; i < count; i++) {
            if (!goes_on(asking, i))
                return chosen;
            double bound = bounds[i], sum = rounding->sum + bound, squares = rounding->squares + bound * bound;
            if (bound < 0 || bound > limit || !keeps_accuracy(sum, squares, least_maximum))
                continue;
            *rounding = (struct lx_rounding_sum){sum, squares};
            bounds[i] = -1;
            chosen++;
        }
    }
    return chosen;
}

/* No place of a cylinder is nearer to the surface than this: those of its axis between two that are looked at are no
 * farther from the nearer of them than half their distance. */
static double cylinder_gap(const struct lx_shape *shape, const struct lx_area_light *lamp)
{
    enum { PLACES = 32 };
    double nearest = HUGE_VAL;
    for (int i = 0; i < PLACES; i++) {
        const double along = lamp->half_mm * ((2 * i + 1) / (double)PLACES - 1);
        double place[3];
        for (int k = 0; k < 3; k++)
            place[k] = lamp->center[k] + along * lamp->axis[k];
        nearest = fmin(nearest, least_distance(shape, place));
    }
    return nearest - lamp->half_mm / PLACES - lamp->round_mm;
}

bool lx_samples_fit_single(const struct lx_shape *shape, const struct lx_lobe_double *lobe,
                           const struct lx_area_light *lamp, double tolerance)
{
    const double margin = 200; /* between roundings and the tolerance, and for what is not looked at here */
    double away = distance(lamp->center, (double[]){0, 0, 0});
    double nearest = least_distance(shape, lamp->center) - lamp->radius_mm;
    if (lamp->has_side)
        nearest = fmax(nearest, cylinder_gap(shape, lamp));
    double off = unit * (away + lamp->radius_mm + shape->radius_mm) / nearest + 4 * unit;
    double error = off * fmax(1, lx_power_slope(lobe->exponent.value));
    bool moderate = is_moderate(away) && is_moderate(nearest) && is_moderate(lamp->radius_mm) &&
                    is_moderate(shape->radius_mm) && is_moderate(lamp->radiance) && is_moderate(lobe->specular);
    return nearest > 0 && moderate && error * margin <= tolerance;
}

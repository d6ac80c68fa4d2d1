/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by disks, balls and cylinders: their contours (rim.h, cylinder.c) in wide numbers, in the frame of
 * the source's axis, and what of it is uncertain.
 *
 * Each value is the closed form for the float64 place and normal and the unit vector along the float64 axis.  The
 * true ones may be off by p, e and t.  Turning the axis by t moves no place of the source by more than t times the
 * reach from its centre; this is added to p.  What the element sees of the source has the solid angle Omega, its
 * highest place the elevation with the sine mu, its least distance is d, all taken for the worst place within reach; A
 * is the area that it may see.  Then
 *
 *     |dE| <= e Omega                                           N.w changes by e
 *     |dE| <= p mu (length of the visible contour over r^2)     the region's border moves by p/r
 *     |dE| <= p (5 Omega/d + mu min(A/d^3, c pi/d))             the gradient of cos cos'/r^2 under the integral
 *             + t mu A/d^2                                      its change with the source's normal
 *
 * where c pi/d bounds the integral of 1/r^3 over a flat (c = 3) or convex (c = 12) surface.  A ball turns by p/d of its
 * centre, and its cone opens by p tan/d.  Where the source may be touched, E is between 0 and pi.
 */
#include <math.h>

#include "../../base/vector.h"
#include "elliptic.h"
#include "rim.h"
#include "round.h"

/* What an element at the origin sees, scaled by a power of two so that nothing is far from 1. */
struct sight {
    bool is_disk;
    lx_wide rho, height, radius, half_height; /* the centre is (rho, 0, height) in the frame of rim.h */
    lx_wide3 normal;
    double place_error, normal_error; /* how far places of the source may be off, from the element, and N */
    double turned, tilted;            /* how far the axis may be, and what that does to the element's height */
    double reach;                     /* an upper bound of |r| on the source */
};

struct estimate {
    double value, error;
};

static double norm3(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z);
}

static double error_norm(lx_bounded3 a)
{
    return norm3(a.x.error, a.y.error, a.z.error) * (1 + 8 * DBL_EPSILON);
}

static lx_wide3 wide_of(lx_bounded3 a)
{
    return lx_wide3_of((const double[]){a.x.value, a.y.value, a.z.value});
}

/* A unit vector of which two components are 0 is known exactly. */
static lx_bounded3 sharpened(lx_bounded3 a)
{
    lx_bounded *components[3] = {&a.x, &a.y, &a.z};
    for (int i = 0; i < 3; i++)
        if (lx_is_zero(*components[(i + 1) % 3]) && lx_is_zero(*components[(i + 2) % 3]))
            *components[i] = lx_exact(components[i]->value < 0 ? -1 : 1);
    return a;
}

/* ---- the frame ---- */

static lx_wide3 scaled(lx_wide3 a, double power_of_two)
{
    return (lx_wide3){lx_wide_scale(a.x, power_of_two), lx_wide_scale(a.y, power_of_two),
                      lx_wide_scale(a.z, power_of_two)};
}

/* What of a is perpendicular to the unit vector b. */
static lx_wide3 across(lx_wide3 a, lx_wide3 b)
{
    return lx_wide3_sub(a, lx_wide3_mul(b, lx_wide3_dot(a, b)));
}

/* A unit vector perpendicular to a, towards `center` where that is not parallel to a. */
static lx_wide3 towards(lx_wide3 center, lx_wide3 a)
{
    static const double PARALLEL = 0x1p-90;
    lx_wide3 u = across(center, a);
    if (!(lx_wide3_length(u).high > PARALLEL * lx_wide3_length(center).high)) {
        double x = fabs(a.x.high), y = fabs(a.y.high), z = fabs(a.z.high);
        u = lx_wide3_of((const double[]){x <= y && x <= z, y < x && y <= z, z < x && z < y});
    }
    /* Where little was left, that is not yet at right angles. */
    for (int i = 0; i < 3; i++)
        u = lx_wide3_unit(across(u, a));
    return u;
}

static double scale_of(const struct lx_emitter *emitter, lx_wide3 center)
{
    double largest = fmax(fmax(fabs(center.x.high), fabs(center.y.high)), fabs(center.z.high));
    largest = fmax(largest, fmax(emitter->radius_mm, emitter->height_mm));
    return largest > 0 ? ldexp(1, -ilogb(largest)) : 1;
}

static struct sight sight_of(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal)
{
    static const double OWN = 0x1p-98; /* what the frame adds */
    lx_bounded3 bounded_axis = sharpened(emitter->axis);
    normal = sharpened(normal);
    lx_wide3 center = lx_wide3_sub(lx_wide3_of(emitter->center_mm), wide_of(place_mm));
    double scale = scale_of(emitter, center);
    center = scaled(center, scale);
    double distance = lx_wide3_length(center).high, turned = 0;
    lx_wide3 n = wide_of(normal), a;
    if (!lx_has_axis(emitter)) {
        a = distance > 0 ? lx_wide3_unit(center) : lx_wide3_of((const double[]){0, 0, 1});
    } else {
        a = lx_wide3_unit(wide_of(bounded_axis));
        turned = error_norm(bounded_axis);
        turned *= 1 + turned; /* of a unit vector along it */
    }
    lx_wide height = lx_wide3_dot(center, a);
    if (lx_is_disk(emitter) || height.high < 0) { /* away from the element; a disk's front is towards it */
        a = lx_wide3_mul(a, lx_wide_of(-1));
        height = lx_wide_negate(height);
    }
    lx_wide3 u = towards(center, a), v = lx_wide3_cross(a, u);
    double size = hypot(emitter->radius_mm, emitter->height_mm / 2) * scale;
    struct sight sight = {
        .is_disk = lx_is_disk(emitter),
        .rho = lx_has_axis(emitter) ? lx_wide3_dot(center, u) : lx_wide_of(0),
        .height = height,
        .radius = lx_wide_of(emitter->radius_mm * scale),
        .half_height = lx_wide_of(lx_half_height(emitter) * scale),
        .normal = {lx_wide3_dot(n, u), lx_wide3_dot(n, v), lx_wide3_dot(n, a)},
        .place_error = error_norm(place_mm) * scale + OWN * distance + turned * size,
        .normal_error = error_norm(normal) + OWN,
        .turned = turned,
        .tilted = turned * distance,
    };
    if (sight.rho.high < 0)
        sight.rho = lx_wide_of(0);
    sight.reach = distance + sight.radius.high + sight.half_height.high;
    return sight;
}

/* ---- bounds ---- */

/* Upper bound of half the angle of the rim that may be above the horizon when N.r may be off by `moved`. */
static double half_angle(const struct lx_horizon *horizon, double moved)
{
    double reach = horizon->reach.high, above = lx_wide_add(horizon->middle, horizon->reach).high + moved;
    if (!(above > 0))
        return 0;
    return above < 2 * reach ? 2 * asin(sqrt(above / (2 * reach))) * (1 + 1e-12) : M_PI;
}

/* Upper bound of the share of a circle's disk on one side of a chord: (tau - sin tau cos tau)/pi <= 2/3 tau^3/pi. */
static double share_of(double half_angle)
{
    return fmin(1, 2.0 / 3 * half_angle * half_angle * half_angle / M_PI * (1 + 1e-12));
}

/* Upper bound of the sine of the elevation of the highest place. */
static double elevation(const struct lx_horizon *horizon, double moved, double distance)
{
    double above = lx_wide_add(horizon->middle, horizon->reach).high + moved;
    return fmin(1, fmax(above, 0) / distance);
}

/* Upper bound of the integral of ds/r^2 along what may be seen of a rim, the place off by `moved`. */
static double rim_length(const struct lx_rim *rim, double half_angle, double moved)
{
    double near = sqrt(rim->near2.high) - moved, far = sqrt(rim->far2.high) - moved;
    return near > 0 ? 2 * rim->radius.high * fmin(M_PI / (near * far), half_angle / (near * near)) : HUGE_VAL;
}

static double moved_by(const struct sight *sight)
{
    return (sight->place_error + sight->normal_error * (sight->reach + sight->place_error)) * (1 + 1e-12);
}

/* The bound for surfaces: omega_area: Omega <= omega_area/d^2. */
static double surface_bound(const struct sight *sight, double distance, double mu, double area, double contour,
                            double c)
{
    if (!(distance > 0))
        return M_PI;
    double d = distance, omega = fmin(2 * M_PI, area / (d * d));
    double highest = fmax(sight->height.high, 0) + sight->place_error + sight->tilted; /* above the disk */
    if (sight->is_disk)
        omega = fmin(omega, area * fmin(1, highest / d) / (d * d));
    double by_area = (5 * omega / d + mu * fmin(area / (d * d * d), c * M_PI / d)) * sight->place_error;
    by_area += sight->turned * mu * area / (d * d);
    double by_contour = mu * contour * sight->place_error;
    double bound = omega * sight->normal_error + fmin(by_area, by_contour);
    return fmin(bound * (1 + 1e-9), M_PI);
}

static double disk_bound(const struct sight *sight, const struct lx_rim *rim, const struct lx_horizon *horizon)
{
    double moved = moved_by(sight), h = fabs(sight->height.high), r = sight->radius.high;
    if (sight->height.high + sight->place_error + sight->tilted <= 0)
        return 0; /* behind it for certain */
    double beyond = fmax(lx_wide_sub(sight->rho, sight->radius).high, 0);
    double distance = hypot(beyond, h) * (1 - 1e-12) - sight->place_error;
    double tau = half_angle(horizon, moved), area = M_PI * r * r * share_of(tau);
    return surface_bound(sight, distance, elevation(horizon, moved, distance), area,
                         rim_length(rim, tau, sight->place_error), 3);
}

/* By what the terms are good for. */
static struct estimate estimate_of(const struct lx_wide_sum *sum)
{
    double value = fmax(lx_wide_value(sum->value) / 2, 0);
    return (struct estimate){value, sum->size * LX_SUM_ROUNDING};
}

/* Relative errors of the terms up to which the integrals are not tried. */
static const double ENOUGH = 0x1p-46;

/* A contour of one circle: its terms, or the integral where they cancel. */
static struct estimate circle_irradiance(const struct lx_rim *rim, const struct lx_horizon *horizon, double bound)
{
    struct lx_wide_sum sum = {{0, 0}, 0};
    lx_add_disk(&sum, rim, horizon);
    struct estimate estimate = estimate_of(&sum);
    if (horizon->crossed && estimate.error > ENOUGH * estimate.value) {
        double relative, value = lx_cut_disk_integral(rim, horizon, &relative);
        if (value * relative < estimate.error)
            estimate = (struct estimate){value, value * relative};
    }
    estimate.error += bound;
    return estimate;
}

static struct estimate see_disk(const struct sight *sight)
{
    struct lx_rim rim = lx_rim_of(sight->rho, sight->height, sight->radius, sight->normal);
    struct lx_horizon horizon = lx_rim_horizon(&rim);
    double bound = disk_bound(sight, &rim, &horizon);
    if (!(sight->height.high > 0))
        return (struct estimate){0, bound};
    return circle_irradiance(&rim, &horizon, bound);
}

static double ball_bound(const struct sight *sight, const struct lx_rim *rim, const struct lx_horizon *horizon)
{
    double p = sight->place_error, d = sight->height.high - p, r = sight->radius.high;
    double tangent = sqrt((d - r) * (d + r)) * (1 - 1e-12), h = rim->height.high;
    if (!(d > r))
        return M_PI;
    /* N.r on the contour, as far as it may be off */
    double opening = r * p / (d * tangent) * (1 + 1e-9), turned = p / d + sight->normal_error;
    double moved = (h + r) * (1 + opening) * (turned + opening) * 2, x = r / tangent;
    double tau = half_angle(horizon, moved), mu = elevation(horizon, moved, fmin(h, tangent));
    double omega = fmin(2 * M_PI, M_PI * x * x * share_of(tau)), contour = 2 * tau * r / d;
    return fmin((omega * turned + contour * mu * opening) * (1 + 1e-9), M_PI);
}

/* Its contour is the circle where the tangents touch it, under the same cone as one of radius R at sqrt(d^2 - R^2). */
static struct estimate see_ball(const struct sight *sight)
{
    lx_wide beyond = lx_wide_mul(lx_wide_sub(sight->height, sight->radius), lx_wide_add(sight->height, sight->radius));
    if (!(beyond.high > 0)) {
        bool inside = lx_wide_sub(sight->height, sight->radius).high + sight->place_error < 0;
        return (struct estimate){0, inside ? 0 : M_PI};
    }
    struct lx_rim rim = lx_rim_of(lx_wide_of(0), lx_wide_sqrt(beyond), sight->radius, sight->normal);
    struct lx_horizon horizon = lx_rim_horizon(&rim);
    return circle_irradiance(&rim, &horizon, ball_bound(sight, &rim, &horizon));
}

/* What may be seen of the side: at most so much of the half towards the element, of at most so much of its length. */
static double cylinder_bound(const struct sight *sight, double beyond, double over)
{
    double moved = moved_by(sight), r = sight->radius.high, g = sight->half_height.high;
    double distance = hypot(fmax(beyond, 0), fmax(over, 0)) * (1 - 1e-12) - sight->place_error;
    lx_wide near = lx_wide_sub(sight->height, sight->half_height), far = lx_wide_add(sight->height, sight->half_height);
    struct lx_rim rims[2] = {
        lx_rim_of(sight->rho, near, sight->radius, sight->normal),
        lx_rim_of(sight->rho, far, sight->radius, sight->normal),
    };
    double above = -HUGE_VAL, mu = 0, angle = 0, contour = 0, tau[2];
    for (int i = 0; i < 2; i++) {
        struct lx_horizon horizon = lx_rim_horizon(&rims[i]);
        above = fmax(above, lx_wide_add(horizon.middle, horizon.reach).high + moved);
        mu = fmax(mu, elevation(&horizon, moved, distance));
        tau[i] = half_angle(&horizon, moved);
        angle = fmax(angle, tau[i]);
        if (i == 0 || beyond + sight->place_error > 0)
            contour += rim_length(&rims[i], tau[i], sight->place_error);
    }
    double slope = fabs(sight->normal.z.high) * (1 - 1e-12), length = 2 * g;
    if (length * slope > above)
        length = fmax(above, 0) / slope;
    double tangent = sqrt(fmax(beyond, 0)) * sqrt(fmax(beyond, 0) + 2 * r);
    tangent -= sight->place_error + sight->tilted;
    contour += 2 * fmin(tangent > 0 ? M_PI / tangent : HUGE_VAL, length / (distance * distance));
    double area = M_PI * r * r * share_of(tau[0]) + fmin(M_PI, 2 * angle) * r * length;
    return surface_bound(sight, distance, mu, area, contour, 12);
}

/* The side and the cap that is seen, as integrals where their contour's terms cancel. */
static struct estimate cylinder_integral(const struct sight *sight)
{
    lx_wide near = lx_wide_sub(sight->height, sight->half_height), far = lx_wide_add(sight->height, sight->half_height);
    struct lx_rim rims[2] = {
        lx_rim_of(sight->rho, near, sight->radius, sight->normal),
        lx_rim_of(sight->rho, far, sight->radius, sight->normal),
    };
    struct lx_horizon horizons[2] = {lx_rim_horizon(&rims[0]), lx_rim_horizon(&rims[1])};
    struct estimate cap = {0, 0}, side = {0, 0};
    double relative;
    if (near.high > 0)
        cap = circle_irradiance(&rims[0], &horizons[0], 0);
    if (lx_wide_compare(sight->rho, sight->radius) > 0) {
        side.value = lx_side_integral(rims, horizons, &relative);
        side.error = side.value * relative;
    }
    return (struct estimate){cap.value + side.value, cap.error + side.error};
}

static struct estimate see_cylinder(const struct sight *sight)
{
    double beyond = lx_wide_sub(sight->rho, sight->radius).high;
    double over = lx_wide_sub(sight->height, sight->half_height).high;
    if (fmax(beyond, over) + sight->place_error < 0)
        return (struct estimate){0, 0}; /* inside for certain */
    double bound = cylinder_bound(sight, beyond, over);
    if (!(beyond > 0 || over > 0))
        return (struct estimate){0, bound};
    struct lx_wide_sum sum = {{0, 0}, 0};
    lx_add_cylinder(&sum, sight->rho, sight->height, sight->radius, sight->half_height, sight->normal);
    struct estimate estimate = estimate_of(&sum);
    if (sum.size > 0 && estimate.error > ENOUGH * estimate.value) {
        struct estimate integral = cylinder_integral(sight);
        if (integral.error < estimate.error)
            estimate = integral;
    }
    estimate.error += bound;
    return estimate;
}

/* ---- the interface ---- */

lx_bounded lx_disk_irradiance(const struct lx_emitter *disk, lx_bounded3 place_mm, lx_bounded3 normal)
{
    const struct sight sight = sight_of(disk, place_mm, normal);
    const struct estimate estimate = see_disk(&sight);
    return lx_rounded(estimate.value, estimate.error, 2);
}

lx_bounded lx_ball_irradiance(const struct lx_emitter *ball, lx_bounded3 place_mm, lx_bounded3 normal)
{
    const struct sight sight = sight_of(ball, place_mm, normal);
    const struct estimate estimate = see_ball(&sight);
    return lx_rounded(estimate.value, estimate.error, 2);
}

lx_bounded lx_cylinder_irradiance(const struct lx_emitter *cylinder, lx_bounded3 place_mm, lx_bounded3 normal)
{
    const struct sight sight = sight_of(cylinder, place_mm, normal);
    const struct estimate estimate = see_cylinder(&sight);
    return lx_rounded(estimate.value, estimate.error, 2);
}

/* How far it reaches from its centre in a unit direction. */
static double reach_of(const struct lx_emitter *emitter, const double direction[3])
{
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    const double along = lx_has_axis(emitter) ? lx_dot(direction, axis) : 0;
    const double across = lx_emitter_kind(emitter)->bulges ? 1 : sqrt(fmax(1 - along * along, 0));
    return emitter->radius_mm * across + lx_half_height(emitter) * fabs(along);
}

double lx_round_extent(const struct lx_emitter *emitter, const double place_mm[3], const double direction[3],
                       double *nearest)
{
    double offset[3];
    for (int k = 0; k < 3; k++)
        offset[k] = emitter->center_mm[k] - place_mm[k];
    const double middle = lx_dot(direction, offset), around = reach_of(emitter, direction);
    *nearest = middle - around;
    return middle + around;
}

void lx_round_farthest(const struct lx_emitter *emitter, const double towards[3], double place_mm[3])
{
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    const double along = lx_has_axis(emitter) ? lx_dot(axis, towards) : 0;
    const bool bulges = lx_emitter_kind(emitter)->bulges;
    const double across = bulges ? 1 : sqrt(fmax(1 - along * along, 0)), inwards = bulges ? 0 : along;
    for (int i = 0; i < 3; i++) {
        place_mm[i] = emitter->center_mm[i];
        if (lx_emitter_kind(emitter)->has_side)
            place_mm[i] += copysign(lx_half_height(emitter), along) * axis[i];
        if (across > 0)
            place_mm[i] += emitter->radius_mm * (towards[i] - inwards * axis[i]) / across;
    }
}

/* The distance from the surface. */
static double distance_to(const struct lx_emitter *emitter, const struct sight *sight)
{
    double beyond = lx_wide_sub(sight->rho, sight->radius).high;
    double over = lx_wide_sub(sight->height, sight->half_height).high;
    if (!lx_has_axis(emitter))
        return fabs(lx_wide_sub(sight->height, sight->radius).high);
    if (sight->is_disk)
        return hypot(fmax(beyond, 0), over);
    return beyond <= 0 && over <= 0 ? -fmax(beyond, over) : hypot(fmax(beyond, 0), fmax(over, 0));
}

bool lx_round_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    static const double UNITS = 4;
    if (lx_is_elliptic(emitter))
        return lx_elliptic_touches(emitter, place_mm);
    struct sight sight = sight_of(emitter, place_mm, (lx_bounded3){{0, 0}, {0, 0}, {0, 0}});
    lx_wide3 center = lx_wide3_sub(lx_wide3_of(emitter->center_mm), wide_of(place_mm));
    double largest = fmax(fmax(fabs(place_mm.x.value), fabs(place_mm.y.value)), fabs(place_mm.z.value));
    for (int i = 0; i < 3; i++)
        largest = fmax(largest, fabs(emitter->center_mm[i]));
    largest = fmax(largest, fmax(emitter->radius_mm, emitter->height_mm));
    double slack = UNITS * DBL_EPSILON * largest * scale_of(emitter, center);
    return distance_to(emitter, &sight) <= sight.place_error + slack;
}

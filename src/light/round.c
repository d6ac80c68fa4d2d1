/* SPDX-License-Identifier: MIT */
/*
 * The irradiance by disks, balls and cylinders in closed form, as round.h explains it, in wide numbers, and cutting
 * them into parts.
 *
 * A contour is a ring of pieces, arcs and segments, that run counter-clockwise about the way to the source.  What of
 * each lies above the element's horizon is added up; from where one such piece ends to where the next begins the
 * contour goes along the horizon, or nowhere where they meet.
 *
 * What place, normal and axis are uncertain by moves E as light/facets.c derives it; a turned axis moves the source by
 * its angle times the distance from the centre.
 */
#include <math.h>

#include "../base/pose.h"
#include "round.h"

/* ---- contours ---- */

struct contour {
    lx_wide3 normal;
    lx_wide sum;
    double magnitude; /* of its terms */
    bool begun;
    lx_wide3 first, last;
};

static void add_term(struct contour *contour, lx_wide term)
{
    contour->sum = lx_wide_add(contour->sum, term);
    contour->magnitude += fabs(term.high);
}

/* The angle about the normal from a to b: along the horizon, where both lie on it; 0 where they are the same. */
static lx_wide turn(lx_wide3 normal, lx_wide3 a, lx_wide3 b)
{
    lx_wide below = lx_wide_mul(lx_wide3_dot(normal, a), lx_wide3_dot(normal, b));
    return lx_wide_atan2(lx_wide3_dot(normal, lx_wide3_cross(a, b)), lx_wide_sub(lx_wide3_dot(a, b), below));
}

/* A piece from a to b has been added: joins it to the one before. */
static void join(struct contour *contour, lx_wide3 a, lx_wide3 b)
{
    if (contour->begun)
        add_term(contour, turn(contour->normal, contour->last, a));
    else
        contour->first = a;
    contour->begun = true;
    contour->last = b;
}

static void close_contour(struct contour *contour)
{
    if (contour->begun)
        add_term(contour, turn(contour->normal, contour->last, contour->first));
}

static void add_segment(struct contour *contour, lx_wide3 a, lx_wide3 b)
{
    lx_wide za = lx_wide3_dot(contour->normal, a), zb = lx_wide3_dot(contour->normal, b);
    if (za.high < 0 && zb.high < 0)
        return;
    lx_wide share = lx_wide_div(za, lx_wide_sub(za, zb));
    lx_wide3 meeting = lx_wide3_add(a, lx_wide3_mul(lx_wide3_sub(b, a), share));
    if (za.high < 0)
        a = meeting;
    if (zb.high < 0)
        b = meeting;
    lx_wide3 product = lx_wide3_cross(a, b);
    lx_wide length = lx_wide3_length(product);
    join(contour, a, b);
    if (length.high > 0) {
        lx_wide angle = lx_wide_atan2(length, lx_wide3_dot(a, b));
        add_term(contour, lx_wide_div(lx_wide_mul(angle, lx_wide3_dot(contour->normal, product)), length));
    }
}

/* ---- circles ---- */

/*
 * A circle under its elliptic cone.  The angle psi on the circle, from `out` towards `side`, and t on the cone belong
 * together by cos(t) = (cos(psi) + kappa)/(1 + kappa cos(psi)).
 */
struct circle {
    lx_wide3 center, out, side; /* center from the element; out, side: unit, in the circle's plane */
    lx_wide radius, kappa;
    lx_wide p, q, g; /* g^2 = q^2 - p^2 */
    lx_wide3 normal; /* the element's, in the cone's frame */
};

/* A place on a circle. */
struct mark {
    lx_wide cosine, sine;
};

static lx_wide one(void)
{
    return lx_wide_of(1);
}

static lx_wide square(lx_wide a)
{
    return lx_wide_mul(a, a);
}

/* A unit vector perpendicular to a unit vector. */
static lx_wide3 any_perpendicular(lx_wide3 a)
{
    bool along_x = fabs(a.x.high) > 0.6;
    lx_wide3 other = lx_wide3_of((const double[]){along_x ? 0 : 1, along_x ? 1 : 0, 0});
    return lx_wide3_unit(lx_wide3_cross(a, other));
}

/* The circle about a center with an axis, as the element sees it; false where it lies within its disk. */
static bool see_circle(lx_wide3 center, lx_wide3 axis, double radius_mm, lx_wide3 normal, struct circle *circle)
{
    lx_wide r = lx_wide_of(radius_mm), h = lx_wide3_dot(axis, center);
    if (h.high < 0) {
        axis = lx_wide3_mul(axis, lx_wide_of(-1));
        h = lx_wide_negate(h);
    }
    lx_wide3 away = lx_wide3_sub(center, lx_wide3_mul(axis, h));
    lx_wide rho = lx_wide3_length(away);
    *circle = (struct circle){.center = center, .radius = r};
    bool on_axis = !(rho.high > 0x1p-100 * (h.high + radius_mm));
    circle->out = on_axis ? any_perpendicular(axis) : lx_wide3_mul(away, lx_wide_div(one(), rho));
    circle->side = lx_wide3_cross(axis, circle->out);

    lx_wide near = lx_wide_sub(rho, r), far = lx_wide_add(rho, r);
    lx_wide d1 = lx_wide_sqrt(lx_wide_add(square(near), square(h)));
    lx_wide d2 = lx_wide_sqrt(lx_wide_add(square(far), square(h)));
    lx_wide x = lx_wide_add(lx_wide_mul(near, far), square(h)), w = lx_wide_mul(d1, d2);
    lx_wide sum = lx_wide_add(w, x);
    if (x.high < 0) {
        lx_wide twice = lx_wide_scale(lx_wide_mul(h, r), 2);
        sum = lx_wide_div(square(twice), lx_wide_sub(w, x));
    }
    if (!(sum.high > 0))
        return false;
    circle->p = lx_wide_div(lx_wide_scale(lx_wide_mul(h, r), 2), sum);
    circle->q = lx_wide_div(lx_wide_mul(r, lx_wide_sqrt(lx_wide_of(2))), lx_wide_sqrt(sum));
    /* (d2 - d1)/(d2 + d1), without the difference */
    lx_wide both = lx_wide_add(d1, d2);
    circle->kappa = lx_wide_div(lx_wide_scale(lx_wide_mul(rho, r), 4), square(both));
    circle->g = lx_wide_sqrt(lx_wide_sub(square(circle->q), square(circle->p)));

    /* the cone's axis halves the angle between the extreme rays */
    lx_wide a = lx_wide_add(lx_wide_div(near, d1), lx_wide_div(far, d2));
    lx_wide b = lx_wide_add(lx_wide_div(h, d1), lx_wide_div(h, d2));
    lx_wide length = lx_wide_sqrt(lx_wide_add(square(a), square(b)));
    a = lx_wide_div(a, length);
    b = lx_wide_div(b, length);
    lx_wide along_out = lx_wide3_dot(normal, circle->out), along_axis = lx_wide3_dot(normal, axis);
    circle->normal.x = lx_wide_sub(lx_wide_mul(b, along_out), lx_wide_mul(a, along_axis));
    circle->normal.y = lx_wide3_dot(normal, circle->side);
    circle->normal.z = lx_wide_add(lx_wide_mul(a, along_out), lx_wide_mul(b, along_axis));
    return true;
}

static lx_wide3 place_on(const struct circle *circle, struct mark mark)
{
    lx_wide3 out = lx_wide3_mul(circle->out, lx_wide_mul(circle->radius, mark.cosine));
    lx_wide3 side = lx_wide3_mul(circle->side, lx_wide_mul(circle->radius, mark.sine));
    return lx_wide3_add(circle->center, lx_wide3_add(out, side));
}

/* t of a place on the circle. */
static struct mark on_cone(const struct circle *circle, struct mark psi)
{
    lx_wide below = lx_wide_add(one(), lx_wide_mul(circle->kappa, psi.cosine));
    lx_wide shrunk = lx_wide_sqrt(lx_wide_sub(one(), square(circle->kappa)));
    return (struct mark){
        lx_wide_div(lx_wide_add(psi.cosine, circle->kappa), below),
        lx_wide_div(lx_wide_mul(shrunk, psi.sine), below),
    };
}

/* Below this g is 0 but for terms of g^2. */
static const double ROUND = 0x1p-50;

/* The integral of cos(t)/D up to t. */
static lx_wide cosine_part(const struct circle *circle, lx_wide sine)
{
    lx_wide root = lx_wide_sqrt(lx_wide_add(one(), square(circle->p)));
    if (circle->g.high < ROUND)
        return lx_wide_div(sine, square(root));
    return lx_wide_div(lx_wide_atan2(lx_wide_mul(circle->g, sine), root), lx_wide_mul(circle->g, root));
}

/* The integral of sin(t)/D up to t. */
static lx_wide sine_part(const struct circle *circle, lx_wide cosine)
{
    lx_wide root = lx_wide_sqrt(lx_wide_add(one(), square(circle->q)));
    if (circle->g.high < ROUND)
        return lx_wide_negate(lx_wide_div(cosine, square(root)));
    lx_wide x = lx_wide_div(lx_wide_mul(circle->g, cosine), root);
    lx_wide logarithm = lx_wide_log(lx_wide_div(lx_wide_add(one(), x), lx_wide_sub(one(), x)));
    return lx_wide_negate(lx_wide_div(lx_wide_scale(logarithm, 0.5), lx_wide_mul(circle->g, root)));
}

/* The integral of 1/D from t1 counter-clockwise to t2, less than a full turn. */
static lx_wide constant_part(const struct circle *circle, struct mark t1, struct mark t2)
{
    lx_wide a = lx_wide_sqrt(lx_wide_add(one(), square(circle->p))),
            b = lx_wide_sqrt(lx_wide_add(one(), square(circle->q)));
    lx_wide x1 = lx_wide_mul(a, t1.cosine), y1 = lx_wide_mul(b, t1.sine);
    lx_wide x2 = lx_wide_mul(a, t2.cosine), y2 = lx_wide_mul(b, t2.sine);
    lx_wide angle = lx_wide_atan2(lx_wide_sub(lx_wide_mul(x1, y2), lx_wide_mul(x2, y1)),
                                  lx_wide_add(lx_wide_mul(x1, x2), lx_wide_mul(y1, y2)));
    if (angle.high < 0)
        angle = lx_wide_add(angle, lx_wide_scale(lx_wide_pi(), 2));
    return lx_wide_div(angle, lx_wide_mul(a, b));
}

/* Adds the arc from one place counter-clockwise to another, all of it above the horizon. */
static void add_visible_arc(struct contour *contour, const struct circle *circle, struct mark from, struct mark to)
{
    struct mark t1 = on_cone(circle, from), t2 = on_cone(circle, to);
    lx_wide by_cosine = lx_wide_sub(cosine_part(circle, t2.sine), cosine_part(circle, t1.sine));
    lx_wide by_sine = lx_wide_sub(sine_part(circle, t2.cosine), sine_part(circle, t1.cosine));
    lx_wide by_one = constant_part(circle, t1, t2);
    join(contour, place_on(circle, from), place_on(circle, to));
    add_term(contour, lx_wide_negate(lx_wide_mul(lx_wide_mul(circle->normal.x, circle->q), by_cosine)));
    add_term(contour, lx_wide_negate(lx_wide_mul(lx_wide_mul(circle->normal.y, circle->p), by_sine)));
    add_term(contour, lx_wide_mul(lx_wide_mul(circle->normal.z, lx_wide_mul(circle->p, circle->q)), by_one));
}

/* ---- the horizon ---- */

enum horizon { ALL_ABOVE, ALL_BELOW, CROSSED };

/* Where the circle is above the horizon: from `rise` counter-clockwise to `set`. */
static enum horizon find_horizon(const struct circle *circle, lx_wide3 normal, struct mark *rise, struct mark *set)
{
    lx_wide a = lx_wide3_dot(normal, circle->center);
    lx_wide b = lx_wide_mul(circle->radius, lx_wide3_dot(normal, circle->out));
    lx_wide d = lx_wide_mul(circle->radius, lx_wide3_dot(normal, circle->side));
    lx_wide m2 = lx_wide_add(square(b), square(d)), m = lx_wide_sqrt(m2);
    if (lx_wide_compare(a, m) >= 0)
        return ALL_ABOVE;
    if (lx_wide_compare(a, lx_wide_negate(m)) <= 0)
        return ALL_BELOW;
    lx_wide s = lx_wide_sqrt(lx_wide_mul(lx_wide_sub(m, a), lx_wide_add(m, a)));
    lx_wide ab = lx_wide_mul(a, b), ad = lx_wide_mul(a, d), bs = lx_wide_mul(b, s), ds = lx_wide_mul(d, s);
    *rise = (struct mark){lx_wide_div(lx_wide_sub(ds, ab), m2), lx_wide_div(lx_wide_negate(lx_wide_add(ad, bs)), m2)};
    *set = (struct mark){lx_wide_div(lx_wide_negate(lx_wide_add(ab, ds)), m2), lx_wide_div(lx_wide_sub(bs, ad), m2)};
    return CROSSED;
}

/* From 0 to a full turn, counter-clockwise from one place to another. */
static double angle_between(struct mark from, struct mark to)
{
    double angle = atan2(to.sine.high, to.cosine.high) - atan2(from.sine.high, from.cosine.high);
    return angle < 0 ? angle + 2 * M_PI : angle;
}

/* Adds what is above the horizon of the arc from one place counter-clockwise to another. */
static void add_arc(struct contour *contour, const struct circle *circle, struct mark from, struct mark to)
{
    struct mark rise, set;
    enum horizon horizon = find_horizon(circle, contour->normal, &rise, &set);
    if (horizon == ALL_ABOVE)
        add_visible_arc(contour, circle, from, to);
    if (horizon != CROSSED)
        return;
    double length = angle_between(from, to), rises = angle_between(from, rise), sets = angle_between(from, set);
    if (rises > sets) /* it begins above */
        add_visible_arc(contour, circle, from, sets < length ? set : to);
    if (rises < length)
        add_visible_arc(contour, circle, rise, rises < sets && sets < length ? set : to);
}

/* A whole circle. */
static void add_circle(struct contour *contour, const struct circle *circle)
{
    struct mark rise, set;
    enum horizon horizon = find_horizon(circle, contour->normal, &rise, &set);
    if (horizon == CROSSED)
        add_visible_arc(contour, circle, rise, set);
    if (horizon != ALL_ABOVE)
        return;
    lx_wide below = lx_wide_mul(lx_wide_add(one(), square(circle->p)), lx_wide_add(one(), square(circle->q)));
    lx_wide above = lx_wide_mul(circle->normal.z, lx_wide_mul(circle->p, circle->q));
    add_term(contour, lx_wide_div(lx_wide_mul(lx_wide_scale(lx_wide_pi(), 2), above), lx_wide_sqrt(below)));
}

/* ---- the sources ---- */

static lx_wide3 wide_of(lx_bounded3 a)
{
    return lx_wide3_of((const double[]){a.x.value, a.y.value, a.z.value});
}

static double error_of(lx_bounded3 a)
{
    return a.x.error + a.y.error + a.z.error;
}

static void add_disk(struct contour *contour, lx_wide3 center, lx_wide3 axis, double radius_mm)
{
    struct circle circle;
    if (see_circle(center, axis, radius_mm, contour->normal, &circle))
        add_circle(contour, &circle);
}

/* The ball's contour is the circle where its tangents touch it. */
static void add_ball(struct contour *contour, lx_wide3 center, double radius_mm)
{
    lx_wide distance2 = lx_wide3_dot(center, center), r = lx_wide_of(radius_mm);
    lx_wide beyond = lx_wide_sub(distance2, square(r));
    if (!(beyond.high > 0))
        return;
    lx_wide3 axis = lx_wide3_unit(center);
    /* under the same cone: a circle of radius 1 at the distance sqrt(d^2 - R^2)/R */
    add_disk(contour, lx_wide3_mul(axis, lx_wide_div(lx_wide_sqrt(beyond), r)), axis, 1);
}

static void add_cylinder(struct contour *contour, lx_wide3 center, lx_wide3 axis, double radius_mm, double height_mm)
{
    lx_wide along = lx_wide_negate(lx_wide3_dot(axis, center)); /* of the element, from the middle */
    lx_wide3 outwards = lx_wide3_mul(lx_wide3_add(center, lx_wide3_mul(axis, along)), lx_wide_of(-1));
    lx_wide rho = lx_wide3_length(outwards), half = lx_wide_of(height_mm / 2), r = lx_wide_of(radius_mm);
    lx_wide3 to_top = lx_wide3_mul(axis, half), top = lx_wide3_add(center, to_top),
             bottom = lx_wide3_sub(center, to_top);
    bool above = lx_wide_compare(along, half) > 0, below = lx_wide_compare(along, lx_wide_negate(half)) < 0;
    if (lx_wide_compare(rho, r) <= 0) {
        if (above || below)
            add_disk(contour, above ? top : bottom, axis, radius_mm);
        return;
    }
    lx_wide3 e = lx_wide3_mul(outwards, lx_wide_div(one(), rho)), f = lx_wide3_cross(axis, e);
    lx_wide cosine = lx_wide_div(r, rho);
    lx_wide sine = lx_wide_div(lx_wide_sqrt(lx_wide_mul(lx_wide_sub(rho, r), lx_wide_add(rho, r))), rho);
    /* on a rim, from its far side: where the generators touch it, on either side of the near side */
    struct mark before = {lx_wide_negate(cosine), sine}, after = {lx_wide_negate(cosine), lx_wide_negate(sine)};
    lx_wide3 near = lx_wide3_mul(e, lx_wide_mul(r, cosine)), side = lx_wide3_mul(f, lx_wide_mul(r, sine));
    lx_wide3 left = lx_wide3_sub(near, side), right = lx_wide3_add(near, side);
    struct circle circle;
    if (see_circle(top, axis, radius_mm, contour->normal, &circle))
        add_arc(contour, &circle, above ? after : before, above ? before : after);
    add_segment(contour, lx_wide3_add(top, right), lx_wide3_add(bottom, right));
    if (see_circle(bottom, axis, radius_mm, contour->normal, &circle))
        add_arc(contour, &circle, below ? after : before, below ? before : after);
    add_segment(contour, lx_wide3_add(bottom, left), lx_wide3_add(top, left));
}

/* Of the element from the source's surface, negative within a body; and the areas that can be seen at most. */
static double distance_to(const struct lx_emitter *emitter, lx_wide3 center, lx_wide3 axis)
{
    double distance = lx_wide_value(lx_wide3_length(center));
    if (emitter->type == LX_BALL)
        return distance - emitter->radius_mm;
    lx_wide along = lx_wide3_dot(axis, center);
    double across = lx_wide_value(lx_wide3_length(lx_wide3_sub(center, lx_wide3_mul(axis, along))));
    double beyond = across - emitter->radius_mm, over = fabs(lx_wide_value(along)) - emitter->height_mm / 2;
    if (beyond > 0 && over > 0)
        return hypot(beyond, over);
    return fmax(beyond, over);
}

static double seen_area(const struct lx_emitter *emitter)
{
    double r = emitter->radius_mm, disk = M_PI * r * r;
    return emitter->type == LX_DISK   ? disk
           : emitter->type == LX_BALL ? 2 * disk
                                      : disk + 2 * M_PI * r * emitter->height_mm;
}

static lx_wide3 axis_of(const struct lx_emitter *emitter)
{
    return emitter->type == LX_BALL ? lx_wide3_of((const double[]){0, 0, 1}) : lx_wide3_unit(wide_of(emitter->axis));
}

static lx_wide3 center_from(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    return lx_wide3_sub(lx_wide3_of(emitter->center_mm), wide_of(place_mm));
}

/* How far place and source are off from each other. */
static double place_error_of(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_wide3 center)
{
    double turned = emitter->type == LX_BALL ? 0 : error_of(emitter->axis);
    double reach = lx_wide_value(lx_wide3_length(center)) + emitter->radius_mm + emitter->height_mm / 2;
    return error_of(place_mm) + turned * reach;
}

bool lx_round_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    lx_wide3 center = center_from(emitter, place_mm);
    double size = fabs(place_mm.x.value) + fabs(place_mm.y.value) + fabs(place_mm.z.value) + emitter->radius_mm;
    double slack = place_error_of(emitter, place_mm, center) + 4 * DBL_EPSILON * size;
    return fabs(distance_to(emitter, center, axis_of(emitter))) <= slack;
}

lx_bounded lx_round_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal)
{
    struct contour contour = {.normal = wide_of(normal)};
    lx_wide3 center = center_from(emitter, place_mm), axis = axis_of(emitter);
    double place_error = place_error_of(emitter, place_mm, center), normal_error = error_of(normal);
    double distance = distance_to(emitter, center, axis) - place_error, area = seen_area(emitter);
    bool behind = emitter->type == LX_DISK && !(lx_wide3_dot(axis, center).high < 0);
    if (!behind && emitter->type == LX_DISK)
        add_disk(&contour, center, axis, emitter->radius_mm);
    else if (emitter->type == LX_BALL)
        add_ball(&contour, center, emitter->radius_mm);
    else if (emitter->type == LX_CYLINDER)
        add_cylinder(&contour, center, axis, emitter->radius_mm, emitter->height_mm);
    close_contour(&contour);
    double moved = 0, value = fmax(lx_wide_value(contour.sum) / 2, 0);
    if (place_error > 0 || normal_error > 0) {
        double omega = fmin(2 * M_PI, area / (distance * distance));
        double slope = 5 * omega / distance + fmin(area / (distance * distance * distance), 12 * M_PI / distance);
        moved = distance > 0 ? fmin((omega * normal_error + slope * place_error) * (1 + 1e-9), M_PI) : M_PI;
    }
    bool inside = emitter->type != LX_DISK && distance + place_error < 0;
    if (inside || (behind && lx_wide3_dot(axis, center).high > place_error))
        return lx_exact(0);
    return (lx_bounded){value, (value * DBL_EPSILON + moved) * LX_BOUND_SLACK + contour.magnitude * 0x1p-86};
}

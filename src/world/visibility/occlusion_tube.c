/* SPDX-License-Identifier: MIT */
/* The side of a cylinder as an obstacle on an arc: in its half plane a conic, cut off at both ends. */
#include <math.h>

#include "../../base/vector.h"
#include "occlusion_arc.h"

/* What is across the axis of a direction. */
static void take_across(const double a[3], const double axis[3], double across[3])
{
    const double along = lx_dot(a, axis);
    for (int k = 0; k < 3; k++)
        across[k] = a[k] - along * axis[k];
}

static bool tube_hides(const struct half_plane *half, const struct lx_obstacle *tube, double tau)
{
    const double c = cos(tau), s = sin(tau), reach = lx_reach_of(half, c, s);
    double towards[3], v[3], p[3], moment[3];
    for (int k = 0; k < 3; k++)
        towards[k] = c * half->x[k] + s * half->y[k];
    take_across(towards, tube->axis, v);
    take_across(tube->center_mm, tube->axis, p);
    for (int k = 0; k < 3; k++)
        moment[k] = p[(k + 1) % 3] * v[(k + 2) % 3] - p[(k + 2) % 3] * v[(k + 1) % 3];
    const double square = lx_dot(v, v), middle = lx_dot(p, v);
    const double below = tube->radius_mm * tube->radius_mm * square - lx_dot(moment, moment);
    if (!(below > 0) || !(square > 1e-30))
        return false;
    const double root = sqrt(below), start = -lx_dot(tube->center_mm, tube->axis), change = lx_dot(towards, tube->axis);
    for (int sign = tube->is_around ? 1 : -1; sign <= 1; sign += 2) {
        const double t = (middle + sign * root) / square;
        if (t > tube->touch_mm && t < reach && fabs(start + t * change) <= tube->half_mm)
            return true;
    }
    return false;
}

/* The directions that touch the endless tube: (p.v)^2 = (p^2 - R^2) v^2, a quadratic form in cos(tau) and sin(tau);
 * from a place on its wall the one that leads along it. */
static void propose_tangents(const struct half_plane *half, const double p[3], const double d[3], const double e[3],
                             double radius, struct candidates *candidates)
{
    const double outside = lx_dot(p, p) - radius * radius, pd = lx_dot(p, d), pe = lx_dot(p, e);
    static const double ON_WALL = 1e-6;
    if (!(outside > 0)) {
        const double slope = hypot(pd, pe), level = atan2(pe < 0 ? pd : -pd, fabs(pe)); /* p.v = 0 */
        if (outside > -ON_WALL * radius * radius && slope > 0)
            lx_propose(candidates, level, half->error_mm / slope, TANGENT);
        return;
    }
    const double a = pd * pd - outside * lx_dot(d, d), b = pd * pe - outside * lx_dot(d, e),
                 c = pe * pe - outside * lx_dot(e, e), below = b * b - a * c;
    if (!(below > 0))
        return;
    /* a cos^2 + 2 b cos sin + c sin^2 = 0 */
    const double root = sqrt(below), larger = b > 0 ? -b - root : -b + root;
    const double slack = 2 * half->error_mm * sqrt(lx_dot(p, p)) / root; /* v is no longer than 1 */
    const double first = atan2(larger, c), second = atan2(a, larger);
    lx_propose(candidates, first > M_PI_2 ? first - M_PI : first < -M_PI_2 ? first + M_PI : first, slack, TANGENT);
    lx_propose(candidates,
               second > M_PI_2    ? second - M_PI
               : second < -M_PI_2 ? second + M_PI
                                  : second,
               slack, OTHER_TANGENT);
}

/* Where the line base + t way of the half plane meets the endless tube. */
static void propose_on_line(const struct half_plane *half, struct point base, struct point way, const double p[3],
                            const double d[3], const double e[3], double radius, enum bound bound,
                            struct candidates *candidates)
{
    double from[3], v[3];
    for (int k = 0; k < 3; k++) {
        from[k] = base.x * d[k] + base.y * e[k] - p[k];
        v[k] = way.x * d[k] + way.y * e[k];
    }
    const double a = lx_dot(v, v), b = lx_dot(from, v), c = lx_dot(from, from) - radius * radius, below = b * b - a * c;
    if (!(below > 0) || !(a > 0))
        return;
    const double root = sqrt(below);
    for (int sign = -1; sign <= 1; sign += 2) {
        const double t = (-b + sign * root) / a;
        const struct point at = {base.x + t * way.x, base.y + t * way.y};
        if (at.x > 0)
            lx_propose(candidates, atan2(at.y, at.x), half->error_mm * (radius + sqrt(a)) / root / hypot(at.x, at.y),
                       (enum bound)(bound + (sign > 0)));
    }
}

/* The places in a range where a polynomial of some degree, its constant first, changes its sign: between those where
 * its slope does. */
enum { MOST_DEGREE = 4 };
static size_t find_roots(const double *polynomial, int degree, const double range[2], double roots[MOST_DEGREE])
{
    double slope[MOST_DEGREE + 1], turns[MOST_DEGREE + 1];
    size_t turn_count = 0, count = 0;
    if (degree > 1) {
        for (int i = 1; i <= degree; i++)
            slope[i - 1] = i * polynomial[i];
        turn_count = find_roots(slope, degree - 1, range, turns);
    }
    double before = range[0];
    for (size_t k = 0; k <= turn_count; k++) {
        double from = before, to = k < turn_count ? turns[k] : range[1];
        double at[2] = {0, 0};
        for (int i = degree; i >= 0; i--) {
            at[0] = at[0] * from + polynomial[i];
            at[1] = at[1] * to + polynomial[i];
        }
        before = to;
        if ((at[0] > 0) == (at[1] > 0))
            continue;
        for (double middle = (from + to) / 2; middle > from && middle < to; middle = (from + to) / 2) {
            double value = 0;
            for (int i = degree; i >= 0; i--)
                value = value * middle + polynomial[i];
            *((value > 0) == (at[0] > 0) ? &from : &to) = middle;
        }
        roots[count++] = to;
    }
    return count;
}

/*
 * Where the near side of a ball as a source, or the far one, meets the endless tube.  With t the tangent of half the
 * angle from where the ball is nearest, or farthest, its place times 1 + t^2 is a polynomial, and so is its distance
 * from the axis.
 */
static void propose_on_ball(const struct half_plane *half, const double p[3], const double d[3], const double e[3],
                            double radius, struct candidates *candidates)
{
    const double size = sqrt(fmax(half->square, 0)), square = radius * radius;
    const bool is_far = half->sweep->wall == LX_FAR_WALL;
    const double middle = half->center_mm, to_near = is_far ? -size : size;
    /* the far side is more than half of the circle: it ends where lines of sight touch that */
    const double sine = fmin(size / middle, 1 - DBL_EPSILON), last = is_far ? sqrt((1 + sine) / (1 - sine)) : 1;
    double far[3], side[3], near[3], roots[MOST_DEGREE];
    for (int k = 0; k < 3; k++) {
        near[k] = (middle - to_near) * d[k] - p[k];
        side[k] = 2 * size * e[k];
        far[k] = (middle + to_near) * d[k] - p[k];
    }
    const double polynomial[MOST_DEGREE + 1] = {lx_dot(near, near) - square, 2 * lx_dot(near, side),
                                                2 * lx_dot(near, far) + lx_dot(side, side) - 2 * square,
                                                2 * lx_dot(side, far), lx_dot(far, far) - square};
    const size_t count = find_roots(polynomial, MOST_DEGREE, (const double[]){-last, last}, roots);
    for (size_t i = 0; i < count; i++) {
        const double t = roots[i], scale = 1 / (1 + t * t);
        const struct point at = {middle - to_near * (1 - t) * (1 + t) * scale, 2 * t * size * scale};
        const double slope = polynomial[1] + t * (2 * polynomial[2] + t * (3 * polynomial[3] + t * 4 * polynomial[4]));
        const double off = half->error_mm * (radius + half->error_mm) * 4 / fabs(slope);
        lx_propose(candidates, atan2(at.y, at.x), off * size / half->center_mm, ON_THE_SOURCE);
    }
}

size_t lx_hide_by_tube(const struct half_plane *half, const struct lx_obstacle *tube, struct lx_hidden *hidden,
                       size_t count)
{
    double d[3], e[3], p[3];
    const double x = lx_dot(half->x, tube->axis), y = lx_dot(half->y, tube->axis), square = x * x + y * y;
    const double middle = lx_dot(tube->center_mm, tube->axis), height = lx_dot(tube->center_mm, half->n);
    struct candidates candidates = {.count = 0};
    if (!(fabs(height) < hypot(tube->radius_mm, tube->half_mm)))
        return count;
    take_across(half->x, tube->axis, d);
    take_across(half->y, tube->axis, e);
    take_across(tube->center_mm, tube->axis, p);
    propose_tangents(half, p, d, e, tube->radius_mm, &candidates);
    for (int end = 0; end < 2 && square > 1e-24; end++) {
        const double at = middle + (end ? tube->half_mm : -tube->half_mm);
        const struct point base = {at * x / square, at * y / square}, way = {-y, x};
        propose_on_line(half, base, way, p, d, e, tube->radius_mm, (enum bound)(RIM + 2 * end), &candidates);
    }
    const bool is_before =
        sqrt(lx_dot(tube->center_mm, tube->center_mm)) + hypot(tube->radius_mm, tube->half_mm) <= half->nearest_mm;
    if (half->is_line)
        propose_on_line(half, (struct point){half->line_mm, 0}, (struct point){0, 1}, p, d, e, tube->radius_mm,
                        ON_THE_SOURCE, &candidates);
    else if (half->is_ellipse && !is_before)
        lx_propose_by_scan(half, tube, tube_hides, &candidates);
    else if (!is_before)
        propose_on_ball(half, p, d, e, tube->radius_mm, &candidates);
    return lx_hide_between(half, tube, tube_hides, &candidates, hidden, count);
}

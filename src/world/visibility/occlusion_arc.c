/* SPDX-License-Identifier: MIT */
/*
 * Obstacles on an arc.  The half plane of an arc has the coordinates x along its direction at tau = 0 and y along the
 * pole; a place there is seen at tau = atan2(y, x), and the source is the line x = c, or a circle's near side.
 */
#include <math.h>

#include "../../base/vector.h"
#include "../../surface/surface.h"
#include "occlusion_arc.h"

/* What lies before the source by less than this share of the distance, lies on it. */
static const double ON_SOURCE = 1e-13;

static struct half_plane half_plane_of(const struct lx_occlusion *occlusion, const struct lx_sweep *sweep,
                                       const struct lx_arc *arc, size_t number)
{
    struct half_plane half = {
        .sweep = sweep,
        .arc = arc,
        .x = arc->direction,
        .y = sweep->frame.z,
        .error_mm = occlusion->error_mm,
        .is_line = !lx_sweep_bulges(sweep),
        .is_ellipse = sweep->kind == LX_SWEEP_ELLIPSOID,
        .name = (unsigned)number * BOUNDS,
    };
    for (int k = 0; k < 3; k++)
        half.n[k] = half.x[(k + 1) % 3] * half.y[(k + 2) % 3] - half.x[(k + 2) % 3] * half.y[(k + 1) % 3];
    if (half.is_line) {
        half.line_mm = half.nearest_mm = arc->distance_mm * (1 - ON_SOURCE);
    } else if (half.is_ellipse) {
        half.nearest_mm = lx_sweep_bound(sweep).x_mm[0];
    } else {
        const double d = sweep->height_mm, r = sweep->radius_mm, beside = d * lx_dot(half.n, sweep->frame.x);
        half.center_mm = d * lx_dot(half.x, sweep->frame.x);
        half.square = (r - beside) * (r + beside);
        half.nearest_mm = half.center_mm - sqrt(fmax(half.square, 0));
    }
    return half;
}

double lx_reach_of(const struct half_plane *half, double cos_tau, double sin_tau)
{
    double incidence;
    return lx_sweep_distance(half->sweep, half->arc, cos_tau, sin_tau, &incidence) * (1 - ON_SOURCE);
}

static size_t append(struct lx_hidden *hidden, size_t count, const struct lx_hidden *part)
{
    hidden[count] = *part;
    const bool swap = part->ends[0] > part->ends[1];
    for (int k = 0; k < 2 && swap; k++) {
        hidden[count].ends[k] = part->ends[1 - k];
        hidden[count].slack[k] = part->slack[1 - k];
        hidden[count].bounds[k] = part->bounds[1 - k];
    }
    return count + 1;
}

/* ---- segments ---- */

/* An end of a segment: how far it may be off, and what it is. */
struct end {
    struct point at;
    double error_mm;
    enum bound bound;
    int beyond; /* it is cut off at the arc's beginning, -1, or its end, 1 */
};

/* Its latitude; what is cut off at an end of the arc goes on. */
static double latitude_of(const struct end *end)
{
    return end->beyond ? end->beyond * M_PI : atan2(end->at.y, end->at.x);
}

/* How far the latitude of an end may be off. */
static double slack_of(const struct end *end)
{
    const double distance = hypot(end->at.x, end->at.y);
    if (end->beyond)
        return 0;
    return distance > end->error_mm ? end->error_mm / distance : M_PI;
}

static size_t append_segment(const struct half_plane *half, const struct end *a, const struct end *b,
                             struct lx_hidden *hidden, size_t count)
{
    const struct lx_hidden part = {
        .ends = {latitude_of(a), latitude_of(b)},
        .slack = {slack_of(a), slack_of(b)},
        .bounds = {half->name + a->bound, half->name + b->bound},
    };
    return append(hidden, count, &part);
}

static struct end between(const struct end *a, const struct end *b, double share, enum bound bound)
{
    return (struct end){
        .at = {a->at.x + share * (b->at.x - a->at.x), a->at.y + share * (b->at.y - a->at.y)},
        .error_mm = fmax(a->error_mm, b->error_mm),
        .bound = bound,
    };
}

/* Cuts a segment to x >= low, or x <= high where sign is -1; false: nothing is left. */
static bool cut_at(struct end *a, struct end *b, double limit, int sign)
{
    const double from = sign * (a->at.x - limit), to = sign * (b->at.x - limit);
    if (from <= 0 && to <= 0)
        return false;
    if (from < 0)
        *a = between(a, b, from / (from - to), ON_THE_SOURCE), a->at.x = limit;
    if (to < 0)
        *b = between(b, a, to / (to - from), ON_THE_SOURCE), b->at.x = limit;
    return true;
}

/* Where a segment crosses the circle or ellipse, as shares of it; returns how many. */
static size_t cross_circle(const struct half_plane *half, const struct end *a, const struct end *b, double shares[2])
{
    const double x = a->at.x - half->center_mm, y = a->at.y, u = b->at.x - a->at.x, v = b->at.y - a->at.y;
    double first = u * u + v * v, middle = x * u + y * v, last = x * x + y * y - half->square;
    for (int i = 0; i < 3 && half->is_ellipse; i++) { /* as a circle on the unit sphere that the ellipsoid is made of */
        const struct lx_sweep *sweep = half->sweep;
        const double right = lx_dot(sweep->ways[i], half->x), up = lx_dot(sweep->ways[i], half->y);
        const double start = right * a->at.x + up * a->at.y - sweep->away * sweep->center[i], way = right * u + up * v;
        first = (i ? first : 0) + way * way;
        middle = (i ? middle : 0) + start * way;
        last = (i ? last : -1) + start * start;
    }
    const double below = middle * middle - first * last;
    if (!(below > 0) || !(first > 0))
        return 0;
    const double root = sqrt(below), larger = middle > 0 ? -middle - root : -middle + root;
    shares[0] = larger / first;
    shares[1] = larger != 0 ? last / larger : shares[0];
    if (shares[0] > shares[1]) {
        const double first_share = shares[0];
        shares[0] = shares[1];
        shares[1] = first_share;
    }
    return 2;
}

/* Cuts a segment to what is seen from a latitude on, or up to it where the sign is -1; false: nothing is left. */
static bool cut_at_latitude(struct end *a, struct end *b, double tau, int sign)
{
    const double c = cos(tau), s = sin(tau);
    const double from = sign * (a->at.y * c - a->at.x * s), to = sign * (b->at.y * c - b->at.x * s);
    if (from <= 0 && to <= 0)
        return false;
    if (from < 0)
        *a = between(a, b, from / (from - to), ON_THE_SOURCE), a->beyond = from < -a->error_mm ? -sign : 0;
    if (to < 0)
        *b = between(b, a, to / (to - from), ON_THE_SOURCE), b->beyond = to < -b->error_mm ? -sign : 0;
    return true;
}

/* Before a ball: what of the segment is nearer than the ball's near side, between the places where it crosses that. */
static size_t hide_before_ball(const struct half_plane *half, struct end a, struct end b, struct lx_hidden *hidden,
                               size_t count)
{
    const double first = half->arc->from, last = first + half->arc->width;
    double shares[2];
    if (!cut_at_latitude(&a, &b, first, 1) || !cut_at_latitude(&a, &b, last, -1))
        return count;
    const size_t crossings = cross_circle(half, &a, &b, shares);
    struct end from = a;
    for (size_t i = 0; i <= crossings; i++) {
        struct end to = b;
        if (i < crossings && !(shares[i] > 0 && shares[i] < 1))
            continue;
        if (i < crossings)
            to = between(&a, &b, shares[i], ON_THE_SOURCE);
        const double x = (from.at.x + to.at.x) / 2, y = (from.at.y + to.at.y) / 2, away = hypot(x, y);
        if (away < lx_reach_of(half, x / away, y / away))
            count = append_segment(half, &from, &to, hidden, count);
        from = to;
    }
    return count;
}

static size_t hide_by_segment(const struct half_plane *half, struct end a, struct end b, struct lx_hidden *hidden,
                              size_t count)
{
    if (!cut_at(&a, &b, 0, 1))
        return count;
    if (!half->is_line)
        return hide_before_ball(half, a, b, hidden, count);
    return cut_at(&a, &b, half->line_mm, -1) ? append_segment(half, &a, &b, hidden, count) : count;
}

/* The place of the half plane's plane on the edge from a to b, which are at the heights p and q over it. */
static struct end crossing(const struct half_plane *half, const double a[3], const double b[3], double p, double q,
                           unsigned edge)
{
    const double share = p / (p - q);
    double place[3], along = 0;
    for (int k = 0; k < 3; k++) {
        place[k] = share < 0.5 ? a[k] + share * (b[k] - a[k]) : b[k] + (1 - share) * (a[k] - b[k]);
        along += (b[k] - a[k]) * (b[k] - a[k]);
    }
    return (struct end){
        .at = {lx_dot(place, half->x), lx_dot(place, half->y)},
        .error_mm = half->error_mm * (1 + sqrt(along) / fabs(p - q)),
        .bound = (enum bound)(EDGE + edge),
    };
}

static size_t hide_by_polygon(const struct half_plane *half, const struct lx_obstacle *polygon,
                              struct lx_hidden *hidden, size_t count)
{
    double heights[LX_OBSTACLE_CORNERS];
    struct end ends[2];
    unsigned found = 0;
    for (unsigned i = 0; i < polygon->corner_count; i++)
        heights[i] = lx_dot(polygon->corners_mm[i], half->n);
    for (unsigned i = 0; i < polygon->corner_count && found < 2; i++) {
        const unsigned next = (i + 1) % polygon->corner_count;
        if ((heights[i] < 0) != (heights[next] < 0))
            ends[found++] =
                crossing(half, polygon->corners_mm[i], polygon->corners_mm[next], heights[i], heights[next], i);
    }
    return found == 2 ? hide_by_segment(half, ends[0], ends[1], hidden, count) : count;
}

/* The plane cuts the disk along a chord, whose middle is next to the centre. */
static size_t hide_by_disk(const struct half_plane *half, const struct lx_obstacle *disk, struct lx_hidden *hidden,
                           size_t count)
{
    const double by_axis = lx_dot(half->n, disk->axis), height = lx_dot(half->n, disk->center_mm);
    double down[3], along[3];
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        down[k] = half->n[k] - by_axis * disk->axis[k];
        along[k] = disk->axis[i] * half->n[j] - disk->axis[j] * half->n[i];
    }
    const double slope = lx_normalize(along), away = height / slope;
    if (!(slope > 0) || !(fabs(away) < disk->radius_mm))
        return count;
    const double chord = sqrt((disk->radius_mm - away) * (disk->radius_mm + away)),
                 x = lx_dot(disk->center_mm, half->x), y = lx_dot(disk->center_mm, half->y), shift = away / slope;
    const struct point middle = {x - shift * lx_dot(down, half->x), y - shift * lx_dot(down, half->y)};
    const struct point side = {chord * lx_dot(along, half->x), chord * lx_dot(along, half->y)};
    const double off = half->error_mm / slope, error = off + fmin(off * disk->radius_mm / chord, disk->radius_mm);
    const struct end ends[2] = {{{middle.x - side.x, middle.y - side.y}, error, RIM, 0},
                                {{middle.x + side.x, middle.y + side.y}, error, OTHER_RIM, 0}};
    return hide_by_segment(half, ends[0], ends[1], hidden, count);
}

/* ---- what is tried between candidates ---- */

void lx_propose(struct candidates *candidates, double tau, double slack, enum bound bound)
{
    size_t k = candidates->count;
    if (k == MOST_CANDIDATES || isnan(tau))
        return;
    for (; k > 0 && candidates->items[k - 1].tau > tau; k--)
        candidates->items[k] = candidates->items[k - 1];
    candidates->items[k] = (struct candidate){tau, fmin(fabs(slack), M_PI), bound};
    candidates->count++;
}

size_t lx_hide_between(const struct half_plane *half, const struct lx_obstacle *obstacle, hides_test hides,
                       const struct candidates *candidates, struct lx_hidden *hidden, size_t count)
{
    const double first = half->arc->from, last = first + half->arc->width;
    struct candidate from = {first, 0, SCANNED};
    bool goes_on = false;
    size_t found = 0;
    for (size_t i = 0; i <= candidates->count; i++) {
        struct candidate to = {last, 0, SCANNED};
        if (i < candidates->count)
            to = candidates->items[i];
        if (to.tau <= from.tau || to.tau > last)
            continue;
        const bool is_hidden = hides(half, obstacle, from.tau + (to.tau - from.tau) / 2);
        if (is_hidden && goes_on) {
            hidden[count - 1].ends[1] = to.tau;
            hidden[count - 1].slack[1] = to.slack;
            hidden[count - 1].bounds[1] = half->name + to.bound;
        } else if (is_hidden && found < LX_MOST_HIDDEN) {
            hidden[count++] = (struct lx_hidden){.ends = {from.tau, to.tau},
                                                 .slack = {from.slack, to.slack},
                                                 .bounds = {half->name + from.bound, half->name + to.bound}};
            found++;
        }
        goes_on = is_hidden;
        from = to;
    }
    return count;
}

void lx_propose_by_scan(const struct half_plane *half, const struct lx_obstacle *obstacle, hides_test hides,
                        struct candidates *candidates)
{
    enum { STEPS = 24, HALVINGS = 48 };
    bool was_hidden = hides(half, obstacle, half->arc->from);
    for (int i = 1; i <= STEPS; i++) {
        double low = half->arc->from + half->arc->width * (i - 1) / STEPS, high = low + half->arc->width / STEPS;
        const bool is_hidden = hides(half, obstacle, high);
        for (int k = 0; k < HALVINGS && is_hidden != was_hidden; k++) {
            const double middle = (low + high) / 2;
            *(hides(half, obstacle, middle) == was_hidden ? &low : &high) = middle;
        }
        if (is_hidden != was_hidden)
            lx_propose(candidates, (low + high) / 2, high - low, ON_THE_SOURCE);
        was_hidden = is_hidden;
    }
}

/* ---- balls ---- */

static bool ball_hides(const struct half_plane *half, const struct lx_obstacle *ball, double tau)
{
    const double c = cos(tau), s = sin(tau), x = lx_dot(ball->center_mm, half->x), y = lx_dot(ball->center_mm, half->y);
    const double h = lx_dot(ball->center_mm, half->n), along = c * x + s * y, aside = hypot(c * y - s * x, h);
    const double below = (ball->radius_mm - aside) * (ball->radius_mm + aside);
    if (ball->is_around)
        return along + sqrt(fmax(below, 0)) < lx_reach_of(half, c, s);
    return along > 0 && below > 0 && along - sqrt(below) < lx_reach_of(half, c, s);
}

/* Where the circle that the ball is in the half plane meets the source. */
static void propose_crossings(const struct half_plane *half, double x, double y, double square, double error_mm,
                              struct candidates *candidates)
{
    if (half->is_line) {
        const double off = half->line_mm - x, below = square - off * off;
        if (!(below > 0))
            return;
        const double root = sqrt(below), slack = (error_mm * sqrt(square) / root) / half->line_mm;
        lx_propose(candidates, atan2(y - root, half->line_mm), slack, ON_THE_SOURCE);
        lx_propose(candidates, atan2(y + root, half->line_mm), slack, ON_THE_SOURCE);
        return;
    }
    /* two circles: the line through both of their points is at the share of the way between the centres */
    const double u = half->center_mm - x, v = -y, d2 = u * u + v * v;
    const double along = (d2 + square - half->square) / (2 * d2), below = square / d2 - along * along;
    if (!(d2 > 0 && below > 0))
        return;
    const double root = sqrt(below);
    for (int sign = -1; sign <= 1; sign += 2) {
        const struct point at = {x + along * u - sign * root * v, y + along * v + sign * root * u};
        const double slack = error_mm / root / sqrt(d2) / hypot(at.x, at.y);
        lx_propose(candidates, atan2(at.y, at.x), slack, ON_THE_SOURCE);
    }
}

static size_t hide_by_ball(const struct half_plane *half, const struct lx_obstacle *ball, struct lx_hidden *hidden,
                           size_t count)
{
    const double x = lx_dot(ball->center_mm, half->x), y = lx_dot(ball->center_mm, half->y);
    const double h = lx_dot(ball->center_mm, half->n), square = (ball->radius_mm - h) * (ball->radius_mm + h);
    if (!(square > 0))
        return count;
    const double radius = sqrt(square), away = hypot(x, y);
    const double error_mm =
        half->error_mm * (1 + fmin(ball->radius_mm / radius, sqrt(ball->radius_mm / half->error_mm)));
    struct candidates candidates = {.count = 0};
    if (!ball->is_around) {
        if (x + radius <= 0)
            return count;
        const double sine = fmin(radius / away, 1), alpha = asin(sine), middle = atan2(y, x);
        const double slack = error_mm / fmax(away * sqrt((1 - sine) * (1 + sine)), sqrt(error_mm * away));
        if (half->is_ellipse ? away + radius <= half->nearest_mm : x + radius <= half->nearest_mm) {
            hidden[count] = (struct lx_hidden){.ends = {middle - alpha, middle + alpha},
                                               .slack = {slack, slack},
                                               .bounds = {half->name + TANGENT, half->name + OTHER_TANGENT}};
            return count + 1;
        }
        lx_propose(&candidates, middle - alpha, slack, TANGENT);
        lx_propose(&candidates, middle + alpha, slack, OTHER_TANGENT);
    }
    if (half->is_ellipse)
        lx_propose_by_scan(half, ball, ball_hides, &candidates);
    else
        propose_crossings(half, x, y, square, error_mm, &candidates);
    return lx_hide_between(half, ball, ball_hides, &candidates, hidden, count);
}

/* ---- the others ---- */

static bool space_hides(const struct half_plane *half, const struct lx_obstacle *space, double tau)
{
    return cos(tau) * lx_dot(space->axis, half->x) + sin(tau) * lx_dot(space->axis, half->y) < 0;
}

static size_t hide_by_space(const struct half_plane *half, const struct lx_obstacle *space, struct lx_hidden *hidden,
                            size_t count)
{
    struct candidates candidates = {.count = 0};
    const double tau = atan2(-lx_dot(space->axis, half->x), lx_dot(space->axis, half->y));
    lx_propose(&candidates, tau > M_PI_2 ? tau - M_PI : tau < -M_PI_2 ? tau + M_PI : tau, 4 * DBL_EPSILON, TANGENT);
    return lx_hide_between(half, space, space_hides, &candidates, hidden, count);
}

/* Whether an obstacle hides a direction of which nothing is known but what its `blocks` tells. */
static bool shape_hides(const struct lx_occlusion *occlusion, const struct lx_shape *shape,
                        const struct half_plane *half, double tau)
{
    const double c = cos(tau), s = sin(tau), reach = lx_reach_of(half, c, s);
    const double way[3] = {reach * (c * half->x[0] + s * half->y[0]), reach * (c * half->x[1] + s * half->y[1]),
                           reach * (c * half->x[2] + s * half->y[2])};
    return shape->kind->blocks(shape, lx_exact3(occlusion->place_mm), lx_exact3(way), false).value > 0;
}

static size_t hide_by_shape(const struct lx_occlusion *occlusion, const struct half_plane *half,
                            const struct lx_shape *shape, struct lx_hidden *hidden, size_t count)
{
    enum { STEPS = LX_SCANNED, HALVINGS = 48 };
    double before = half->arc->from, began = before;
    bool was_hidden = shape_hides(occlusion, shape, half, before);
    for (int i = 1; i <= STEPS; i++) {
        const double tau = half->arc->from + half->arc->width * i / STEPS;
        const bool is_hidden = shape_hides(occlusion, shape, half, tau);
        double low = before, high = tau;
        for (int k = 0; k < HALVINGS && is_hidden != was_hidden; k++) {
            const double middle = (low + high) / 2;
            *(shape_hides(occlusion, shape, half, middle) == was_hidden ? &low : &high) = middle;
        }
        const double end = is_hidden == was_hidden ? tau : (low + high) / 2;
        if (was_hidden && (!is_hidden || i == STEPS))
            hidden[count++] =
                (struct lx_hidden){.ends = {began, end}, .bounds = {half->name + SCANNED, half->name + SCANNED}};
        if (is_hidden && !was_hidden)
            began = end;
        before = tau;
        was_hidden = is_hidden;
    }
    return count;
}

size_t lx_obstacle_hide(const struct lx_occlusion *occlusion, size_t number, const struct lx_sweep *sweep,
                        const struct lx_arc *arc, struct lx_hidden *hidden, size_t count)
{
    const struct half_plane half = half_plane_of(occlusion, sweep, arc, number);
    const struct lx_obstacle *obstacle = &occlusion->obstacles.items[number - 1];
    switch (obstacle->type) {
    case LX_OBSTACLE_POLYGON: return hide_by_polygon(&half, obstacle, hidden, count);
    case LX_OBSTACLE_DISK: return hide_by_disk(&half, obstacle, hidden, count);
    case LX_OBSTACLE_BALL: return hide_by_ball(&half, obstacle, hidden, count);
    case LX_OBSTACLE_TUBE: return lx_hide_by_tube(&half, obstacle, hidden, count);
    case LX_OBSTACLE_SPACE: return hide_by_space(&half, obstacle, hidden, count);
    case LX_OBSTACLE_SHAPE: break;
    }
    return hide_by_shape(occlusion, &half, obstacle->shape, hidden, count);
}

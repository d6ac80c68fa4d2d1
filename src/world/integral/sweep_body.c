/* SPDX-License-Identifier: MIT */
/* The sweeps of bodies: balls, ellipsoids, and cylinders, whose side is swept along its lines. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/larger.h"
#include "../../base/vector.h"
#include "sweep_make.h"

static double square(double a)
{
    return a * a;
}

/* ---- balls ---- */

int lx_sweep_ball(const struct lx_emitter *ball, const double place_mm[3], const double across[3],
                  struct lx_sweeps *sweeps)
{
    double towards[3];
    for (int i = 0; i < 3; i++)
        towards[i] = ball->center_mm[i] - place_mm[i];
    double distance = lx_sweep_normalize(towards);
    if (!(distance > ball->radius_mm))
        return 0;
    struct lx_sweep sweep = {
        .kind = LX_SWEEP_BALL,
        .frame = lx_sweep_frame_about(towards, across),
        .height_mm = distance,
        .radius_mm = ball->radius_mm,
        .angle1 = -M_PI_2,
        .angle = M_PI_2,
    };
    if (lx_sweeps_append(sweeps, &sweep))
        return -1;
    sweep.angle1 = 0;
    return lx_sweeps_append(sweeps, &sweep);
}

/* sin(beta) = sin(alpha) sin(t), alpha half the angle under which the ball is seen */
static struct lx_arc ball_arc(const struct lx_sweep *ball, double x)
{
    double t = ball->angle1 + x * ball->angle, sin_alpha = ball->radius_mm / ball->height_mm;
    double cos_alpha = sqrt((1 - sin_alpha) * (1 + sin_alpha));
    double sine = sin_alpha * sin(t), half = sin_alpha * fmax(cos(t), 0), cosine = hypot(cos_alpha, half);
    double latitude = atan2(half, cos_alpha);
    struct lx_arc arc = {
        .measure = half / cosine * ball->angle,
        .from = -latitude,
        .width = 2 * latitude,
        .round = true,
        .distance_mm = ball->height_mm,
    };
    for (int i = 0; i < 3; i++)
        arc.direction[i] = ball->frame.x[i] * cosine + ball->frame.y[i] * sine;
    return arc;
}

/* ---- ellipsoids ---- */

/*
 * A way L is one by v = W L to a unit sphere whose centre is away at w, where W divides by the half axes.  With p, q, r
 * the parts of v along w and along two directions at right angles to it, and c = w^2 - 1, the sphere is met at
 * (p |w| -+ sqrt(D))/v^2 with D = p^2 - c (q^2 + r^2).  A pole at right angles to W'w is seen along q alone, so that
 * the directions that are seen have D > 0 in the plane across it, where D = p^2 - c r^2: an angle between two sides.
 */
static void apply(const double ways[3][3], const double a[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = lx_dot(ways[i], a);
}

/* x in the middle between the sides of what is seen. */
static void set_middle(struct lx_sweep *sweep)
{
    double x[3], y[3], turned[3];
    apply(sweep->ways, sweep->frame.x, x);
    apply(sweep->ways, sweep->frame.y, y);
    const double c = sweep->beyond, p = lx_dot(x, sweep->center), rx = lx_dot(x, sweep->third),
                 ry = lx_dot(y, sweep->third);
    /* the quadratic form, and its values in the middle, which is positive, and across */
    const double xx = p * p - c * rx * rx, xy = -c * rx * ry, yy = -c * ry * ry, mean = (xx + yy) / 2;
    const double size = hypot((xx - yy) / 2, xy), product = -c * square(p * ry);
    const double across = mean < 0 ? mean - size : product / (mean + size), middle = product / across;
    const double turn = atan2(xy, (xx - yy) / 2) / 2;
    for (int k = 0; k < 3; k++)
        turned[k] = cos(turn) * sweep->frame.x[k] + sin(turn) * sweep->frame.y[k];
    memcpy(sweep->frame.x, turned, sizeof turned);
    lx_sweep_normalize(sweep->frame.x);
    lx_cross(sweep->frame.z, sweep->frame.x, sweep->frame.y);
    sweep->sine = sqrt(middle / (middle - across));
    sweep->cosine = sqrt(across / (across - middle));
    sweep->spread = sqrt(middle / c) / sweep->pole_length;
}

int lx_sweep_ellipsoid(const struct lx_emitter *ellipsoid, const double place_mm[3], const double across[3],
                       struct lx_sweeps *sweeps)
{
    static const double PARALLEL = 1e-6;
    struct lx_sweep sweep = {.kind = LX_SWEEP_ELLIPSOID, .angle1 = -M_PI_2, .angle = M_PI_2};
    double offset[3], towards[3] = {0, 0, 0}, pole[3];
    lx_elliptic_ways(ellipsoid, sweep.ways);
    for (int i = 0; i < 3; i++)
        offset[i] = ellipsoid->center_mm[i] - place_mm[i];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            sweep.ways[i][k] /= ellipsoid->radii_mm[i];
    apply(sweep.ways, offset, sweep.center);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            towards[k] += sweep.ways[i][k] * sweep.center[i];
    sweep.height_mm = lx_sweep_normalize(offset);
    sweep.radius_mm = ellipsoid->radius_mm;
    sweep.away = lx_sweep_normalize(sweep.center);
    sweep.beyond = (sweep.away - 1) * (sweep.away + 1);
    lx_sweep_normalize(towards);
    if (!(sweep.beyond > 0))
        return 0;
    lx_cross(offset, towards, pole); /* across both, the centre is at the latitude 0 */
    sweep.frame = lx_sweep_frame_about(towards, across);
    if (lx_sweep_normalize(pole) > PARALLEL) {
        memcpy(sweep.frame.z, pole, sizeof pole);
        lx_cross(pole, towards, sweep.frame.y);
        lx_sweep_normalize(sweep.frame.y);
        lx_cross(towards, sweep.frame.y, sweep.frame.z);
    }
    apply(sweep.ways, sweep.frame.z, sweep.pole);
    sweep.pole_length = lx_sweep_normalize(sweep.pole);
    lx_cross(sweep.pole, sweep.center, sweep.third);
    lx_sweep_normalize(sweep.third);
    set_middle(&sweep);
    if (lx_sweeps_append(sweeps, &sweep))
        return -1;
    sweep.angle1 = 0;
    return lx_sweeps_append(sweeps, &sweep);
}

/* sin(beta) = sin(alpha) sin(t), alpha half the angle between the sides */
static struct lx_arc ellipsoid_arc(const struct lx_sweep *sweep, double x)
{
    const double t = sweep->angle1 + x * sweep->angle, sine = sweep->sine * sin(t), slant = fmax(cos(t), 0);
    const double cosine = hypot(sweep->cosine, sweep->sine * slant);
    struct lx_arc arc = {.measure = sweep->sine * slant / cosine * sweep->angle, .round = true};
    double v[3];
    for (int i = 0; i < 3; i++)
        arc.direction[i] = sweep->frame.x[i] * cosine + sweep->frame.y[i] * sine;
    apply(sweep->ways, arc.direction, v);
    const double middle = -lx_dot(v, sweep->pole) / sweep->pole_length, half = sweep->spread * slant;
    const double low = middle - half, high = middle + half;
    arc.from = atan(low);
    arc.width = atan2(2 * half, 1 + low * high);
    arc.distance_mm = sweep->height_mm;
    arc.slant = sqrt(sweep->beyond) * sweep->pole_length * sqrt(sqrt((1 + low * low) * (1 + high * high)));
    return arc;
}

/* The cosine of the angle at which a way that is v meets the ellipsoid at a distance, where D has that root. */
static double incidence_at(const struct lx_sweep *sweep, const double v[3], double distance, double root)
{
    double normal[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            normal[k] += sweep->ways[i][k] * (distance * v[i] - sweep->away * sweep->center[i]);
    return root / sqrt(lx_dot(normal, normal));
}

static void way_at(const struct lx_sweep *sweep, const struct lx_arc *arc, double cos_tau, double sin_tau, double v[3])
{
    double towards[3];
    for (int k = 0; k < 3; k++)
        towards[k] = arc->direction[k] * cos_tau + sweep->frame.z[k] * sin_tau;
    apply(sweep->ways, towards, v);
}

static double ellipsoid_distance(const struct lx_sweep *sweep, const struct lx_arc *arc, double cos_tau, double sin_tau,
                                 double *incidence)
{
    double v[3];
    way_at(sweep, arc, cos_tau, sin_tau, v);
    const double p = lx_dot(v, sweep->center), q = lx_dot(v, sweep->pole), r = lx_dot(v, sweep->third);
    const double root = sqrt(fmax(p * p - sweep->beyond * (q * q + r * r), 0));
    const double distance = sweep->beyond / (sweep->away * p + root);
    *incidence = incidence_at(sweep, v, distance, root);
    return distance;
}

static double ellipsoid_far(const struct lx_sweep *sweep, const struct lx_arc *arc, double tau, double incidences[2])
{
    double v[3];
    way_at(sweep, arc, cos(tau), sin(tau), v);
    const double root = arc->slant * sqrt(fmax(sin(arc->from + arc->width - tau) * sin(tau - arc->from), 0));
    const double to_both = sweep->away * lx_dot(v, sweep->center) + root, far = to_both / lx_dot(v, v);
    incidences[0] = incidence_at(sweep, v, sweep->beyond / to_both, root);
    incidences[1] = incidence_at(sweep, v, far, root);
    return far;
}

/* Planes n.x = 0 that touch it have (n.o)^2 = |R n|^2, R times the half axes. */
static struct lx_sweep_bounds bound_ellipsoid(const struct lx_sweep *sweep)
{
    double x[3], z[3];
    for (int i = 0; i < 3; i++) {
        const double length2 = lx_dot(sweep->ways[i], sweep->ways[i]);
        x[i] = lx_dot(sweep->ways[i], sweep->frame.x) / length2;
        z[i] = lx_dot(sweep->ways[i], sweep->frame.z) / length2;
    }
    const double ox = sweep->away * lx_dot(sweep->center, x), oz = sweep->away * lx_dot(sweep->center, z);
    const double reach = sqrt(lx_dot(x, x)), a = (ox - reach) * (ox + reach), b = oz * ox - lx_dot(z, x);
    const double root = sqrt(fmax(b * b - a * (oz * oz - lx_dot(z, z)), 0)), side = sweep->sine / sweep->cosine;
    return (struct lx_sweep_bounds){.u = {sweep->angle1 < 0 ? -side : 0, sweep->angle1 < 0 ? 0 : side},
                                    .v = {(b - root) / a, (b + root) / a},
                                    .x_mm = {ox - reach, ox + reach}};
}

/* ---- cylinders ---- */

/* The cross section of a cylinder in the plane through the element: P(t) = c + a cos(t) + b sin(t). */
struct section {
    double c[2], a[2], b[2];
    double x[3], y[3]; /* directions of the plane */
};

static double cross2(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

static void place_of(const struct section *section, double t, double place[2])
{
    for (int k = 0; k < 2; k++)
        place[k] = section->c[k] + cos(t) * section->a[k] + sin(t) * section->b[k];
}

/* Half the change of the square of the distance. */
static double recedes_at(const struct section *section, double t)
{
    double place[2];
    place_of(section, t, place);
    return place[0] * (section->b[0] * cos(t) - section->a[0] * sin(t)) +
           place[1] * (section->b[1] * cos(t) - section->a[1] * sin(t));
}

/* The t of the place that is nearest to the element. */
static double find_nearest(const struct section *section)
{
    enum { STEPS = 48, HALVINGS = 60 };
    double best = 0, least = HUGE_VAL;
    for (int i = 0; i < STEPS; i++) {
        double place[2];
        place_of(section, 2 * M_PI * i / STEPS, place);
        if (hypot(place[0], place[1]) < least)
            least = hypot(place[0], place[1]), best = 2 * M_PI * i / STEPS;
    }
    double low = best - 2 * M_PI / STEPS, high = best + 2 * M_PI / STEPS;
    for (int i = 0; i < HALVINGS; i++)
        *(recedes_at(section, (low + high) / 2) < 0 ? &low : &high) = (low + high) / 2;
    return (low + high) / 2;
}

/* The two t of u cos(t) + v sin(t) = w; false: there are none. */
static bool solve(double u, double v, double w, double found[2])
{
    const double size = hypot(u, v);
    if (!(fabs(w) < size))
        return false;
    const double middle = atan2(v, u), half = acos(w / size);
    found[0] = middle - half, found[1] = middle + half;
    return true;
}

/* The two t at which the line through the element in a direction meets the section. */
static bool meet(const struct section *section, const double direction[2], double found[2])
{
    return solve(cross2(direction, section->a), cross2(direction, section->b), -cross2(direction, section->c), found);
}

enum { MOST_CUTS = 12 };

static void add_cut(double t, double nearest, double cuts[MOST_CUTS], size_t *count)
{
    static const double SAME = 1e-9;
    double turn = t - nearest;
    turn -= 2 * M_PI * floor(turn / (2 * M_PI));
    if (turn > SAME && turn < 2 * M_PI - SAME)
        cuts[(*count)++] = turn;
}

/* From the nearest place on: where the section is seen from the side, and every quarter of the way around the element;
 * between them it goes one way and no farther than that. */
static size_t cut_section(const struct section *section, double nearest, double cuts[MOST_CUTS])
{
    double found[2], place[2], direction[2];
    size_t count = 0;
    if (solve(cross2(section->c, section->b), -cross2(section->c, section->a), -cross2(section->a, section->b), found))
        for (int i = 0; i < 2; i++)
            add_cut(found[i], nearest, cuts, &count);
    place_of(section, nearest, direction);
    for (int quarter = 0; quarter < 4; quarter++) {
        for (int i = 0; i < 2 && meet(section, direction, found); i++) {
            place_of(section, found[i], place);
            if (place[0] * direction[0] + place[1] * direction[1] > 0)
                add_cut(found[i], nearest, cuts, &count);
        }
        const double before = direction[0];
        direction[0] = -direction[1], direction[1] = before;
    }
    qsort(cuts, count, sizeof *cuts, lx_by_value);
    return count;
}

/* A piece of the side in a frame whose x goes through its middle. */
static struct lx_sweep piece_of(const struct lx_sweep *model, const struct section *section, double from, double to)
{
    struct lx_sweep piece = *model;
    double places[2][2], near[2], x[2] = {0, 0};
    place_of(section, model->nearest, near);
    for (int i = 0; i < 2; i++) {
        place_of(section, model->nearest + (i ? to : from), places[i]);
        const double length = hypot(places[i][0], places[i][1]);
        for (int k = 0; k < 2; k++)
            x[k] += places[i][k] / length;
    }
    const double length = hypot(x[0], x[1]);
    x[0] = length > 0 ? x[0] / length : 1;
    x[1] = length > 0 ? x[1] / length : 0;
    const double y[2] = {-x[1], x[0]};
    for (int k = 0; k < 3; k++)
        piece.frame.x[k] = x[0] * section->x[k] + x[1] * section->y[k];
    lx_cross(piece.frame.z, piece.frame.x, piece.frame.y);
    const double *const made[3] = {near, section->a, section->b};
    double *const into[3] = {piece.near_mm, piece.first_mm, piece.second_mm};
    for (int i = 0; i < 3; i++) {
        into[i][0] = made[i][0] * x[0] + made[i][1] * x[1];
        into[i][1] = made[i][0] * y[0] + made[i][1] * y[1];
    }
    piece.angle1 = model->nearest + from;
    piece.angle = to - from;
    return piece;
}

/* All of the side, around the axis; `away` is the way from the element to the axis. */
static int sweep_tube(const struct lx_emitter *cylinder, const double away[3], double low, const double axis[3],
                      bool is_occluded, struct lx_sweeps *sweeps)
{
    struct lx_sweep model = {.kind = LX_SWEEP_TUBE,
                             .height_mm = sqrt(lx_dot(away, away)),
                             .radius_mm = cylinder->radius_mm,
                             .s_mm = low,
                             .length_mm = cylinder->height_mm};
    struct section section = {.b = {0, 0}};
    double second[3], cuts[MOST_CUTS];
    memcpy(model.frame.z, axis, sizeof model.frame.z);
    lx_half_axes(cylinder, section.x, second);
    section.a[0] = lx_sweep_normalize(section.x);
    lx_cross(axis, section.x, section.y);
    section.b[1] = lx_dot(second, section.y);
    section.c[0] = lx_dot(away, section.x), section.c[1] = lx_dot(away, section.y);
    model.nearest = lx_is_elliptic(cylinder) ? find_nearest(&section) : atan2(-section.c[1], -section.c[0]);
    size_t count = 1;
    cuts[0] = M_PI;
    if (is_occluded)
        count = cut_section(&section, model.nearest, cuts);
    double from = 0;
    for (size_t i = 0; i <= count; i++) {
        const double to = i < count ? cuts[i] : 2 * M_PI;
        const struct lx_sweep piece = piece_of(&model, &section, from, to);
        if (lx_sweeps_append(sweeps, &piece))
            return -1;
        from = to;
    }
    return 0;
}

/* From its difference to the nearest place. */
static void place_on_tube(const struct lx_sweep *tube, double angle, double place[2])
{
    const double middle = (angle + tube->nearest) / 2, chord = -2 * sin((angle - tube->nearest) / 2);
    for (int k = 0; k < 2; k++)
        place[k] = tube->near_mm[k] + chord * (tube->first_mm[k] * sin(middle) - tube->second_mm[k] * cos(middle));
}

/* From the angle about the axis; of the area |P'| dt ds that is the measure, for a cosine of incidence cos(tau). */
static struct lx_arc tube_arc(const struct lx_sweep *tube, double x)
{
    const double angle = tube->angle1 + x * tube->angle, end = tube->s_mm + tube->length_mm;
    double place[2], along[2];
    place_on_tube(tube, angle, place);
    for (int k = 0; k < 2; k++)
        along[k] = tube->second_mm[k] * cos(angle) - tube->first_mm[k] * sin(angle);
    const double c = hypot(place[0], place[1]);
    struct lx_arc arc = {
        .measure = hypot(along[0], along[1]) * tube->angle / c,
        .from = atan2(tube->s_mm, c),
        .width = atan2(c * tube->length_mm, c * c + tube->s_mm * end),
        .distance_mm = c,
        .slant = 1,
    };
    for (int i = 0; i < 3; i++)
        arc.direction[i] = tube->frame.x[i] * (place[0] / c) + tube->frame.y[i] * (place[1] / c);
    return arc;
}

static struct lx_sweep_bounds bound_tube(const struct lx_sweep *tube)
{
    struct lx_sweep_bounds bounds = {.x_mm = {HUGE_VAL, 0}};
    const double first = tube->angle1, last = first + tube->angle;
    const double turn = atan2(tube->second_mm[0], tube->first_mm[0]), low = tube->s_mm, high = low + tube->length_mm;
    double places[2][2], place[2];
    place_on_tube(tube, first, places[0]);
    place_on_tube(tube, last, places[1]);
    for (double t = turn + M_PI * ceil((first - turn) / M_PI); t < last; t += M_PI) {
        place_on_tube(tube, t, place);
        bounds.x_mm[0] = fmin(bounds.x_mm[0], place[0]);
        bounds.x_mm[1] = fmax(bounds.x_mm[1], place[0]);
    }
    for (int i = 0; i < 2; i++) {
        bounds.x_mm[0] = fmin(bounds.x_mm[0], places[i][0]);
        bounds.x_mm[1] = fmax(bounds.x_mm[1], places[i][0]);
        bounds.u[i] = (i ? fmax : fmin)(places[0][1] / places[0][0], places[1][1] / places[1][0]);
    }
    bounds.v[0] = fmin(low / bounds.x_mm[0], low / bounds.x_mm[1]);
    bounds.v[1] = fmax(high / bounds.x_mm[0], high / bounds.x_mm[1]);
    return bounds;
}

static bool find_on_tube(const struct lx_sweep *tube, double ahead, double aside, double *x)
{
    const double direction[2] = {ahead, aside};
    struct section section;
    double found[2], place[2];
    for (int k = 0; k < 2; k++) {
        section.a[k] = tube->first_mm[k], section.b[k] = tube->second_mm[k];
        section.c[k] = tube->near_mm[k] - cos(tube->nearest) * section.a[k] - sin(tube->nearest) * section.b[k];
    }
    for (int i = 0; i < 2 && meet(&section, direction, found); i++) {
        double turn = found[i] - tube->angle1;
        turn -= 2 * M_PI * floor(turn / (2 * M_PI));
        place_on_tube(tube, found[i], place);
        *x = turn / tube->angle;
        if (*x > 0 && *x < 1 && place[0] > 0)
            return true;
    }
    return false;
}

/* Its ends, of which both sides are seen. */
static int sweep_ends(const struct lx_emitter *cylinder, const double caps[2][3], const double axis[3],
                      const double place_mm[3], const double across[3], struct lx_sweeps *sweeps)
{
    const double backwards[3] = {-axis[0], -axis[1], -axis[2]};
    struct lx_emitter back = *cylinder;
    back.is_back = true;
    for (int i = 0; i < 2; i++)
        if (lx_sweep_disk(cylinder, caps[i], axis, place_mm, across, sweeps) ||
            lx_sweep_disk(&back, caps[i], backwards, place_mm, across, sweeps))
            return -1;
    return 0;
}

int lx_sweep_cylinder(const struct lx_emitter *cylinder, const double place_mm[3], const double across[3],
                      bool is_occluded, struct lx_sweeps *sweeps)
{
    const double axis[3] = {cylinder->axis.x.value, cylinder->axis.y.value, cylinder->axis.z.value};
    double away[3], offset[3], half = cylinder->height_mm / 2, caps[2][3], backwards[3];
    for (int i = 0; i < 3; i++) {
        offset[i] = cylinder->center_mm[i] - place_mm[i];
        backwards[i] = -axis[i];
        caps[0][i] = cylinder->center_mm[i] + half * axis[i];
        caps[1][i] = cylinder->center_mm[i] - half * axis[i];
    }
    double along = lx_dot(offset, axis);
    for (int i = 0; i < 3; i++)
        away[i] = offset[i] - along * axis[i];
    if (lx_is_opening(cylinder))
        return sweep_tube(cylinder, away, along - half, axis, is_occluded, sweeps) ||
                       sweep_ends(cylinder, (const double(*)[3])caps, axis, place_mm, across, sweeps)
                   ? -1
                   : 0;
    const double distance = lx_sweep_normalize(away);
    if (distance > cylinder->radius_mm) {
        struct lx_sweep side = {
            .kind = LX_SWEEP_SIDE,
            .height_mm = distance,
            .radius_mm = cylinder->radius_mm,
            .s_mm = along - half,
            .length_mm = cylinder->height_mm,
            .angle1 = -M_PI_2,
            .angle = M_PI_2,
        };
        memcpy(side.frame.x, away, sizeof away);
        memcpy(side.frame.z, axis, sizeof axis);
        lx_cross(axis, away, side.frame.y);
        if (lx_sweeps_append(sweeps, &side))
            return -1;
        side.angle1 = 0;
        if (lx_sweeps_append(sweeps, &side))
            return -1;
    }
    if (lx_is_capsule(cylinder))
        return lx_sweep_round_ends(cylinder, (const double(*)[3])caps, axis, along, distance, place_mm, across, sweeps);
    if (lx_sweep_disk(cylinder, caps[0], axis, place_mm, across, sweeps))
        return -1;
    return lx_sweep_disk(cylinder, caps[1], backwards, place_mm, across, sweeps);
}

/* sin(beta) = (R/rho) sin(t), t the angle of incidence */
static struct lx_arc side_arc(const struct lx_sweep *side, double x)
{
    double t = side->angle1 + x * side->angle, ratio = side->radius_mm / side->height_mm, slant = fmax(cos(t), 0);
    double sine = ratio * sin(t), cosine = sqrt((1 - ratio) * (1 + ratio) + ratio * slant * ratio * slant);
    double c = (side->height_mm - side->radius_mm) * (side->height_mm + side->radius_mm) /
               (side->height_mm * cosine + side->radius_mm * slant);
    double s = side->s_mm, end = s + side->length_mm;
    struct lx_arc arc = {
        .measure = ratio * slant / cosine * side->angle,
        .from = atan2(s, c),
        .width = atan2(c * side->length_mm, c * c + s * end),
        .distance_mm = c,
        .slant = slant,
    };
    for (int i = 0; i < 3; i++)
        arc.direction[i] = side->frame.x[i] * cosine + side->frame.y[i] * sine;
    return arc;
}

/* ---- the bodies together ---- */

struct lx_arc lx_body_arc(const struct lx_sweep *sweep, double x)
{
    switch (sweep->kind) {
    case LX_SWEEP_BALL: return ball_arc(sweep, x);
    case LX_SWEEP_DOME: return lx_dome_arc(sweep, ball_arc(sweep, x));
    case LX_SWEEP_ELLIPSOID: return ellipsoid_arc(sweep, x);
    case LX_SWEEP_TUBE: return tube_arc(sweep, x);
    default: return side_arc(sweep, x);
    }
}

double lx_body_distance(const struct lx_sweep *sweep, const struct lx_arc *arc, double cos_tau, double sin_tau,
                        double *incidence)
{
    if (sweep->kind == LX_SWEEP_ELLIPSOID)
        return ellipsoid_distance(sweep, arc, cos_tau, sin_tau, incidence);
    /* the cosine and the squared sine of the angle from the ball's centre */
    double d = sweep->height_mm, r = sweep->radius_mm, x = lx_dot(arc->direction, sweep->frame.x);
    double y = lx_dot(arc->direction, sweep->frame.y), sine2 = y * y + x * x * sin_tau * sin_tau;
    double root = sqrt(fmax(r * r - d * d * sine2, 0));
    *incidence = root / r;
    return (d - r) * (d + r) / (d * x * cos_tau + root);
}

double lx_sweep_far(const struct lx_sweep *sweep, const struct lx_arc *arc, double tau, double incidences[2])
{
    if (sweep->kind == LX_SWEEP_ELLIPSOID)
        return ellipsoid_far(sweep, arc, tau, incidences);
    const double d = sweep->height_mm, x = lx_dot(arc->direction, sweep->frame.x);
    const double root = d * x * sqrt(fmax(sin(arc->from + arc->width - tau) * sin(tau - arc->from), 0));
    incidences[0] = incidences[1] = root / sweep->radius_mm;
    return d * x * cos(tau) + root;
}

struct lx_sweep_bounds lx_sweep_bound(const struct lx_sweep *sweep)
{
    return sweep->kind == LX_SWEEP_ELLIPSOID ? bound_ellipsoid(sweep) : bound_tube(sweep);
}

bool lx_body_find(const struct lx_sweep *sweep, double ahead, double aside, double *x)
{
    const double by = sweep->kind == LX_SWEEP_ELLIPSOID ? 1 / sweep->sine : sweep->height_mm / sweep->radius_mm;
    const double sine = aside / hypot(ahead, aside) * by;
    if (sweep->kind == LX_SWEEP_TUBE)
        return find_on_tube(sweep, ahead, aside, x);
    if (!(fabs(sine) < 1))
        return false;
    *x = (asin(sine) - sweep->angle1) / sweep->angle;
    const bool is_on = *x > -LX_SAME_ARC && *x < 1 + LX_SAME_ARC;
    *x = fmax(0, fmin(*x, 1));
    return is_on;
}

/* SPDX-License-Identifier: MIT */
/*
 * The climb: from a spot to the top of its hill, by Newton's method within a region of trust that grows and shrinks
 * with how well the quadratic model foretells the function (Conn, Gould, Toint, Trust-Region Methods, 2000).
 *
 * Inside, a step goes in two coordinates; on an edge, in one along it; where two edges meet there is none left.  A step
 * that would leave over an edge ends on it.  From an edge the climb goes back inside where that leads upwards, and over
 * an edge that is no wall where the other side is higher.  It never goes down.
 */
#include "extrema.h"

enum { MOST_STEPS = 160 };

/* Steps of differences: a share of the length over which the function changes; wider where it is rougher. */
static const double FINE = 2e-5;
/* A gain that is not worth another step, relative. */
static const double ENOUGH = 1e-16;
/* Below this share of the surface's size a region of trust is a point. */
static const double POINT = 1e-13;
/* Roundings that may stand beyond an edge, of the coordinates' scale. */
static const double SLACK = 1e-13;

/* A value that fell to less than this share of itself within one step falls farther. */
static const double FALL = 0.7;

enum outcome { MOVED, MET_EDGE, ENDED };

static double size_of(const struct lx_extremum_search *search, const struct lx_climb *climb)
{
    return lx_spot_shape(search, &climb->at)->radius_mm;
}

static double value_at(struct lx_extremum_search *search, const struct lx_spot *spot)
{
    double error;
    return lx_piece_value(search, spot, &error);
}

/* The value where the climb stands, and what it tells of the roughness. */
static double value_here(struct lx_extremum_search *search, struct lx_climb *climb)
{
    double error, value = lx_piece_value(search, &climb->at, &error);
    double noise = error > 0 && value != 0 ? error / fabs(value) / 4 : 0;
    climb->noise = fmin(fmax(noise, 4e-16), 1e-4);
    return value;
}

static double fine_step(const struct lx_climb *climb)
{
    return fmax(FINE, cbrt(climb->noise)) * climb->length_mm;
}

/* Wide at first, when nothing is known of the function. */
static double difference_step(const struct lx_climb *climb)
{
    double wide = fmin(climb->trust_mm, climb->length_mm) / 4;
    return climb->looked ? fmin(fine_step(climb), wide) : wide;
}

static double small_gain(const struct lx_climb *climb)
{
    return fmax(ENOUGH, climb->noise / 100) * fabs(climb->value);
}

/* The length over which a function of this curvature changes by itself. */
static void set_length(const struct lx_extremum_search *search, struct lx_climb *climb, double curvature)
{
    double size_mm = size_of(search, climb), length = sqrt(fabs(climb->value) / curvature);
    climb->length_mm = length < size_mm ? fmax(length, 1e-9 * size_mm) : size_mm;
}

static bool is_beyond_one(const struct lx_extremum_search *search, size_t edge, const struct lx_spot *spot)
{
    double distance = lx_edge_distance(search, &search->edges[edge], spot);
    return !(search->sides[edge] * distance >= -SLACK * search->scale_mm);
}

/* Whether a spot lies beyond an edge that the climb does not stand on, and which. */
static bool is_beyond(const struct lx_extremum_search *search, const struct lx_climb *climb, const struct lx_spot *spot,
                      size_t *edge)
{
    for (size_t i = 0; i < search->edge_count; i++) {
        bool stands_on =
            (climb->active_count > 0 && climb->active[0] == i) || (climb->active_count > 1 && climb->active[1] == i);
        if (!stands_on && is_beyond_one(search, i, spot)) {
            *edge = i;
            return true;
        }
    }
    return false;
}

/* A path from where the climb stands: straight on, or along the edge where it stands on one. */
struct path {
    struct lx_chart chart;
    double direction[2]; /* unit */
};

static bool follow(const struct lx_extremum_search *search, const struct lx_climb *climb, const struct path *path,
                   double way_mm, struct lx_spot *spot)
{
    double step[2] = {way_mm * path->direction[0], way_mm * path->direction[1]};
    *spot = lx_spot_moved(search, &climb->at, &path->chart, step);
    return climb->active_count == 0 || lx_edge_reach(search, climb->active[0], spot);
}

/* The last spot of a path, `way` long at most, that is beyond no edge, and the edge where it ends: at first the one
 * that is known to lie on the way, then any that lies before it. */
static bool find_edge(const struct lx_extremum_search *search, const struct lx_climb *climb, const struct path *path,
                      double way_mm, struct lx_spot *spot, size_t *edge)
{
    double inside, outside = way_mm;
    size_t before = *edge;
    do {
        *edge = before;
        inside = 0;
        for (int i = 0; i < 55; i++) {
            double middle = (inside + outside) / 2;
            if (!follow(search, climb, path, middle, spot))
                return false;
            if (is_beyond_one(search, *edge, spot))
                outside = middle;
            else
                inside = middle;
        }
        if (!follow(search, climb, path, inside, spot))
            return false;
        outside = inside;
    } while (is_beyond(search, climb, spot, &before) && before != *edge && inside != 0);
    return true;
}

/* Ends on the edge that the way crosses, unless that leads down. */
static enum outcome stop_at_edge(struct lx_extremum_search *search, struct lx_climb *climb, const struct path *path,
                                 double way_mm, size_t edge)
{
    struct lx_spot spot;
    if (!find_edge(search, climb, path, way_mm, &spot, &edge))
        return ENDED;
    if (climb->active_count == 0 && !lx_edge_reach(search, edge, &spot))
        return ENDED;
    if (climb->active_count == 1)
        lx_edges_meet(search, (size_t[]){climb->active[0], edge}, &spot);
    /* the climb itself may have stood beyond the edge by as much as rounding allows */
    double loss = 4 * (climb->noise + SLACK * search->scale_mm / climb->length_mm) * fabs(climb->value);
    double value = value_at(search, &spot);
    if (!(value >= climb->value - loss))
        return ENDED;
    climb->at = spot;
    climb->value = value;
    climb->active[climb->active_count++] = edge;
    return MET_EDGE;
}

/* After a trial: how far to trust the model from now on. */
static void set_trust(const struct lx_extremum_search *search, struct lx_climb *climb, double way_mm, double predicted,
                      double gained)
{
    if (!(gained >= 0.1 * predicted))
        climb->trust_mm = fmin(climb->trust_mm, way_mm) / 4;
    else if (gained >= 0.7 * predicted)
        climb->trust_mm = fmax(climb->trust_mm, 3 * way_mm);
    climb->trust_mm = fmin(climb->trust_mm, size_of(search, climb) / 2);
}

/* The quadratic model g.p + p.H.p/2. */
struct model {
    double g[2], h[3]; /* h: xx, xy, yy */
};

static double foretell(const struct model *model, const double p[2])
{
    return model->g[0] * p[0] + model->g[1] * p[1] +
           (model->h[0] * p[0] * p[0] + 2 * model->h[1] * p[0] * p[1] + model->h[2] * p[1] * p[1]) / 2;
}

/* The two eigenvalues, the upper one's direction first in `axes`. */
static void principal(const struct model *model, double mu[2], double axes[2][2])
{
    double mean = (model->h[0] + model->h[2]) / 2, half = (model->h[0] - model->h[2]) / 2;
    double radius = hypot(half, model->h[1]), angle = atan2(model->h[1], half) / 2;
    mu[0] = mean + radius, mu[1] = mean - radius;
    axes[0][0] = cos(angle), axes[0][1] = sin(angle);
    axes[1][0] = -axes[0][1], axes[1][1] = axes[0][0];
}

/* The highest point of the model within the region of trust: (shift - H) p = g, with the least shift that serves. */
static void model_top(const struct model *model, double trust, double p[2])
{
    double mu[2], axes[2][2], g[2], q[2];
    principal(model, mu, axes);
    for (int i = 0; i < 2; i++)
        g[i] = axes[i][0] * model->g[0] + axes[i][1] * model->g[1];
    double low = fmax(mu[0], 0), high = low + 2 * hypot(g[0], g[1]) / trust + DBL_MIN;
    bool inside = mu[0] < 0 && hypot(g[0] / mu[0], g[1] / mu[1]) <= trust;
    for (int i = 0; i < 60 && !inside; i++) {
        double shift = (low + high) / 2;
        if (hypot(g[0] / (shift - mu[0]), g[1] / (shift - mu[1])) > trust)
            low = shift;
        else
            high = shift;
    }
    double shift = inside ? 0 : high;
    for (int i = 0; i < 2; i++)
        q[i] = g[i] == 0 ? 0 : g[i] / (shift - mu[i]);
    p[0] = axes[0][0] * q[0] + axes[1][0] * q[1];
    p[1] = axes[0][1] * q[0] + axes[1][1] * q[1];
}

enum { STENCIL = 5 };

/* Places that were looked at. */
struct around {
    struct lx_spot spots[STENCIL];
    double values[STENCIL];
    size_t count;
};

/* The model from differences of the step h; false: there is no value somewhere. */
static bool look_around(struct lx_extremum_search *search, struct lx_climb *climb, const struct lx_chart *chart,
                        double h, struct around *around, struct model *model)
{
    static const double steps[STENCIL][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}};
    double f = climb->value, *values = around->values;
    climb->flat = true;
    for (int i = 0; i < STENCIL; i++) {
        around->spots[i] = lx_spot_moved(search, &climb->at, chart, (double[]){h * steps[i][0], h * steps[i][1]});
        values[i] = value_at(search, &around->spots[i]);
        if (!isfinite(values[i]))
            return false;
        climb->flat = climb->flat && values[i] == f;
    }
    *model = (struct model){
        .g = {(values[0] - values[1]) / (2 * h), (values[2] - values[3]) / (2 * h)},
        .h = {(values[0] - 2 * f + values[1]) / (h * h), (values[4] - values[0] - values[2] + f) / (h * h),
              (values[2] - 2 * f + values[3]) / (h * h)},
    };
    return true;
}

/* The highest of the trial and of the places looked at, those beyond edges left out, if it is higher than the climb. */
static bool settle_for(const struct lx_extremum_search *search, struct lx_climb *climb, const struct lx_spot *trial,
                       double trial_value, const struct around *around)
{
    const struct lx_spot *best = NULL;
    double value = climb->value;
    size_t edge;
    if (trial_value > value)
        best = trial, value = trial_value;
    for (size_t i = 0; i < around->count; i++)
        if (around->values[i] > value && !is_beyond(search, climb, &around->spots[i], &edge))
            best = &around->spots[i], value = around->values[i];
    if (!best)
        return false;
    climb->at = *best;
    climb->value = value;
    return true;
}

/* After a failure: trusts the model less far. */
static enum outcome shrink(const struct lx_extremum_search *search, struct lx_climb *climb, double way_mm)
{
    climb->trust_mm = fmin(climb->trust_mm, way_mm) / 4;
    return climb->trust_mm > POINT * size_of(search, climb) && !search->stopped ? MOVED : ENDED;
}

/* The last step may gain nothing that the value tells, but finds the place. */
static enum outcome make_last_step(struct lx_extremum_search *search, struct lx_climb *climb,
                                   const struct lx_spot *trial)
{
    size_t edge;
    double value = is_beyond(search, climb, trial, &edge) ? -HUGE_VAL : value_at(search, trial);
    if (value >= climb->value - climb->noise * fabs(climb->value)) {
        climb->at = *trial;
        climb->value = value;
    }
    return ENDED;
}

/*
 * A minimum may end in darkness, towards which the function falls like a high power of the way that is left: a
 * highlight whose source sets.  Newton's method then goes a small share of that way a step; so while the function falls
 * to a share of itself, the way is doubled.
 */
static void leap(struct lx_extremum_search *search, const struct lx_climb *climb, const struct path *path,
                 double way_mm, struct lx_spot *trial, double *value)
{
    double before = climb->value;
    while (search->sign < 0 && fabs(*value) < FALL * fabs(before)) {
        struct lx_spot farther;
        size_t edge;
        way_mm *= 2;
        if (!follow(search, climb, path, way_mm, &farther) || is_beyond(search, climb, &farther, &edge))
            return;
        const double there = value_at(search, &farther);
        if (!(there > *value))
            return;
        before = *value;
        *trial = farther;
        *value = there;
    }
}

/* Goes a way along a path, from which the model foretells a gain. */
static enum outcome go(struct lx_extremum_search *search, struct lx_climb *climb, const struct path *path,
                       double way_mm, double predicted, struct around *around)
{
    struct lx_spot trial;
    size_t edge;
    if (way_mm == 0)
        return ENDED;
    if (!follow(search, climb, path, way_mm, &trial))
        return shrink(search, climb, fabs(way_mm));
    if (!(predicted > small_gain(climb)))
        return make_last_step(search, climb, &trial);
    if (is_beyond(search, climb, &trial, &edge)) {
        enum outcome outcome = stop_at_edge(search, climb, path, way_mm, edge);
        return outcome == ENDED ? shrink(search, climb, fabs(way_mm)) : outcome;
    }
    double value = value_at(search, &trial);
    set_trust(search, climb, fabs(way_mm), predicted, value - climb->value);
    leap(search, climb, path, way_mm, &trial, &value);
    if (settle_for(search, climb, &trial, value, around))
        return MOVED;
    return climb->trust_mm > POINT * size_of(search, climb) ? MOVED : ENDED;
}

static enum outcome step_inside(struct lx_extremum_search *search, struct lx_climb *climb)
{
    struct path path = {.chart = lx_spot_chart(search, &climb->at)};
    struct around around = {.count = STENCIL};
    double mu[2], axes[2][2], p[2], h = difference_step(climb);
    struct model model;
    if (!look_around(search, climb, &path.chart, h, &around, &model)) {
        climb->length_mm = fmin(climb->length_mm, climb->trust_mm / 4);
        return shrink(search, climb, climb->trust_mm);
    }
    if (climb->flat)
        return ENDED;
    principal(&model, mu, axes);
    set_length(search, climb, fmax(fabs(mu[0]), fabs(mu[1])));
    climb->looked = true;
    model_top(&model, climb->trust_mm, p);
    double predicted = foretell(&model, p), way = hypot(p[0], p[1]);
    if (!(predicted > small_gain(climb)) && h > 2 * fine_step(climb))
        return MOVED; /* to look closer */
    path.direction[0] = p[0] / way, path.direction[1] = p[1] / way;
    return go(search, climb, &path, way, predicted, &around);
}

/* The path along an edge, square to its inward direction. */
static bool path_along(const struct lx_extremum_search *search, const struct lx_climb *climb, size_t edge,
                       struct path *path)
{
    double inward[2];
    path->chart = lx_spot_chart(search, &climb->at);
    if (!lx_edge_inward(search, edge, &climb->at, &path->chart, inward))
        return false;
    path->direction[0] = -inward[1], path->direction[1] = inward[0];
    return true;
}

static enum outcome step_along(struct lx_extremum_search *search, struct lx_climb *climb)
{
    struct path path;
    struct around around = {.count = 2};
    double *values = around.values, h = difference_step(climb);
    if (!path_along(search, climb, climb->active[0], &path))
        return ENDED;
    for (int i = 0; i < 2; i++) {
        if (!follow(search, climb, &path, i ? -h : h, &around.spots[i]))
            return shrink(search, climb, climb->trust_mm);
        values[i] = value_at(search, &around.spots[i]);
        if (!isfinite(values[i]))
            return shrink(search, climb, climb->trust_mm);
    }
    climb->flat = values[0] == climb->value && values[1] == climb->value;
    if (climb->flat)
        return ENDED;
    double slope = (values[0] - values[1]) / (2 * h), bend = (values[0] - 2 * climb->value + values[1]) / (h * h);
    set_length(search, climb, fabs(bend));
    climb->looked = true;
    double way = bend < 0 ? -slope / bend : copysign(climb->trust_mm, slope);
    way = fmax(fmin(way, climb->trust_mm), -climb->trust_mm);
    double predicted = slope * way + bend * way * way / 2;
    if (!(predicted > small_gain(climb)) && h > 2 * fine_step(climb))
        return MOVED; /* to look closer */
    return go(search, climb, &path, way, predicted, &around);
}

/* How the function rises from where the climb stands along a path: its one-sided slope. */
static double slope_along(struct lx_extremum_search *search, const struct lx_climb *climb, const struct path *path,
                          double sign)
{
    double h = fmax(fine_step(climb), 1e3 * SLACK * search->scale_mm);
    struct lx_spot near, far;
    if (!follow(search, climb, path, sign * h, &near) || !follow(search, climb, path, 2 * sign * h, &far))
        return 0;
    double slope = (4 * value_at(search, &near) - value_at(search, &far) - 3 * climb->value) / (2 * h);
    return isfinite(slope) ? slope : 0;
}

/* Whether a slope leads to more than roundings. */
static bool rises(const struct lx_climb *climb, double slope)
{
    return slope * climb->length_mm > fmax(1e-7, 10 * pow(climb->noise, 2.0 / 3)) * fabs(climb->value);
}

/* Leaves the i-th edge that the climb stands on. */
static void let_go(struct lx_climb *climb, unsigned i)
{
    if (i == 0)
        climb->active[0] = climb->active[1];
    climb->active_count--;
}

/* The slope into the side where the climb stands of its i-th edge, along the other edge if there is one. */
static double slope_off(struct lx_extremum_search *search, const struct lx_climb *climb, unsigned i)
{
    struct path path;
    double inward[2];
    struct lx_climb rest = *climb;
    size_t edge = climb->active[i];
    let_go(&rest, i);
    path.chart = lx_spot_chart(search, &climb->at);
    if (!lx_edge_inward(search, edge, &climb->at, &path.chart, inward))
        return 0;
    if (rest.active_count == 0) {
        path.direction[0] = inward[0], path.direction[1] = inward[1];
        return slope_along(search, &rest, &path, 1);
    }
    if (!path_along(search, &rest, rest.active[0], &path))
        return 0;
    double sign = path.direction[0] * inward[0] + path.direction[1] * inward[1];
    return fabs(sign) > 1e-6 ? slope_along(search, &rest, &path, copysign(1, sign)) : 0;
}

/* Goes to the other side of the i-th edge that the climb stands on, if that is higher or leads upwards. */
static bool cross(struct lx_extremum_search *search, struct lx_climb *climb, unsigned i)
{
    size_t edge = climb->active[i];
    if (lx_edge_is_wall(&search->edges[edge]))
        return false;
    struct lx_climb other = *climb;
    double rounding = 4 * climb->noise * fabs(climb->value);
    search->sides[edge] = (signed char)-search->sides[edge];
    other.value = value_at(search, &climb->at);
    if (other.value > climb->value + rounding) {
        climb->value = other.value;
        return true;
    }
    if (other.value >= climb->value - rounding && rises(climb, slope_off(search, &other, i))) {
        climb->value = fmax(climb->value, other.value);
        let_go(climb, i);
        return true;
    }
    search->sides[edge] = (signed char)-search->sides[edge];
    return false;
}

/* Where two edges that are no walls meet, the piece opposite may be the higher one. */
static bool cross_both(struct lx_extremum_search *search, struct lx_climb *climb)
{
    signed char *first = &search->sides[climb->active[0]], *second = &search->sides[climb->active[1]];
    if (lx_edge_is_wall(&search->edges[climb->active[0]]) || lx_edge_is_wall(&search->edges[climb->active[1]]))
        return false;
    *first = (signed char)-*first, *second = (signed char)-*second;
    double value = value_at(search, &climb->at);
    if (value > climb->value + 4 * climb->noise * fabs(climb->value)) {
        climb->value = value;
        return true;
    }
    *first = (signed char)-*first, *second = (signed char)-*second;
    return false;
}

/* Off an edge, or over it: whether the climb goes on. */
static bool leave_edges(struct lx_extremum_search *search, struct lx_climb *climb)
{
    for (unsigned i = 0; i < climb->active_count; i++)
        if (cross(search, climb, i))
            return true;
    if (climb->active_count == 2 && cross_both(search, climb))
        return true;
    for (unsigned i = 0; i < climb->active_count; i++)
        if (rises(climb, slope_off(search, climb, i))) {
            let_go(climb, i);
            return true;
        }
    return false;
}

/* Whether the climb comes to a summit that is known, and is not above it. */
static bool nears_summit(const struct lx_extremum_search *search, const struct lx_climb *climb)
{
    double here[3], there[3], normal[3];
    lx_spot_place(search, &climb->at, here, normal);
    for (size_t i = 0; i < search->summit_count; i++) {
        const struct lx_summit *summit = &search->summits[i];
        if (summit->spot.surface != climb->at.surface || climb->value > summit->value)
            continue;
        lx_spot_place(search, &summit->spot, there, normal);
        double apart = hypot(hypot(here[0] - there[0], here[1] - there[1]), here[2] - there[2]);
        if (apart <= 0.03 * summit->length_mm)
            return true;
    }
    return false;
}

void lx_climb_up(struct lx_extremum_search *search, struct lx_climb *climb)
{
    climb->value = value_here(search, climb);
    climb->length_mm = fmin(fmax(climb->length_mm, climb->trust_mm), size_of(search, climb));
    if (!isfinite(climb->value))
        return;
    for (int steps = 0; steps < MOST_STEPS && lx_search_goes_on(search); steps++) {
        enum outcome outcome = ENDED;
        if (climb->active_count < 2)
            outcome = climb->active_count == 0 ? step_inside(search, climb) : step_along(search, climb);
        if (outcome == MET_EDGE || (outcome == ENDED && climb->active_count > 0)) {
            bool goes_on = leave_edges(search, climb);
            if (outcome == ENDED && !goes_on)
                return;
            /* a step of its own, unless it was just made */
            climb->trust_mm = fmax(climb->trust_mm, 8 * fine_step(climb));
        } else if (outcome == ENDED) {
            return;
        }
        if (nears_summit(search, climb)) {
            climb->known = true;
            return;
        }
    }
}

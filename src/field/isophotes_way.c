/* SPDX-License-Identifier: MIT */
/*
 * Following the exact function along a way across the screen: where it is on a level, where it has an extremum, where
 * the way leaves its surface.
 */
#include <math.h>

#include "isophotes.h"

double lx_iso_value(const struct lx_iso_search *search, int surface, const double xy_mm[2])
{
    luxel_value found;
    luxel_evaluate_screen(search->evaluator, xy_mm[0], xy_mm[1], &found, NULL);
    bool exists = found.on_surface && found.has_value &&
                  (int)lx_prepared_index(&search->evaluator->prepared, found.surface, found.part) == surface;
    return exists ? found.value : (double)NAN;
}

/* -- along a rim -- */

/* How often a direction can be gone from a place before the screen ends. */
static double room_on_screen(const struct lx_iso_search *search, const double from[2], const double direction[2])
{
    const double *places[2] = {search->x_mm, search->y_mm};
    const unsigned last[2] = {search->columns - 1, search->rows - 1};
    double room = HUGE_VAL;
    for (int i = 0; i < 2; i++) {
        double side = (direction[i] > 0) == (i == 0) ? places[i][last[i]] : places[i][0];
        if (direction[i] != 0)
            room = fmin(room, fmax(0, (side - from[i]) / direction[i]));
    }
    return room;
}

/* A ray across the screen from a place on the surface, to be followed as far as there is room. */
struct ray {
    const struct lx_iso_search *search;
    int surface;
    double inner_mm[2], direction[2], room;
};

static bool is_on_surface(const struct ray *ray, double reach)
{
    const double xy_mm[2] = {ray->inner_mm[0] + reach * ray->direction[0],
                             ray->inner_mm[1] + reach * ray->direction[1]};
    return lx_iso_seen(ray->search, xy_mm) == ray->surface;
}

/* Between which reaches the ray leaves the surface, or all its room if it does not, from nothing. */
static void enclose_rim(const struct ray *ray, double *on, double *off)
{
    *on = 0, *off = 1;
    for (int i = 0; i < 10 && *on < ray->room; i++, *off *= 1.5) {
        *off = fmin(*off, ray->room);
        if (!is_on_surface(ray, *off))
            break;
        *on = *off;
    }
}

/*
 * Where the rim is at a share of the chord by the parabola through where it was found last, and about how far off that
 * may be.  A way is followed in ever smaller steps, by which both soon have all digits.
 */
static bool guess_rim(const struct lx_iso_way *way, double share, double *reach, double *doubt)
{
    const struct lx_iso_rim *rims = way->rims;
    if (way->rim_count < 3)
        return false;
    const double slope = (rims[1].reach - rims[0].reach) / (rims[1].share - rims[0].share);
    const double next = (rims[2].reach - rims[1].reach) / (rims[2].share - rims[1].share);
    const double bend = (next - slope) / (rims[2].share - rims[0].share);
    const double change = bend * (share - rims[0].share) * (share - rims[1].share);
    *reach = rims[0].reach + slope * (share - rims[0].share) + change;
    *doubt = 0.1 * fabs(change) + 2e-15 * *reach;
    return true;
}

/* Between which reaches around a guess the ray leaves the surface; false: not near it, where it might come back to the
 * surface behind another. */
static bool enclose_near(const struct ray *ray, double guess, double doubt, double *on, double *off)
{
    *on = guess - doubt, *off = guess + doubt;
    const bool beyond = is_on_surface(ray, *on);
    for (; doubt < 1e-3 * guess && *off < ray->room; doubt *= 4) {
        if (is_on_surface(ray, beyond ? *off : *on) != beyond)
            return true;
        *(beyond ? on : off) = beyond ? *off : *on;
        *(beyond ? off : on) = beyond ? guess + 4 * doubt : guess - 4 * doubt;
    }
    return false;
}

/* The last reach of the ray on the surface. */
static double find_rim(struct lx_iso_way *way, const struct ray *ray, double share)
{
    double on, off, guess, doubt;
    for (unsigned i = 0; i < way->rim_count; i++)
        if (way->rims[i].share == share)
            return way->rims[i].reach;
    if (!guess_rim(way, share, &guess, &doubt) || !enclose_near(ray, guess, doubt, &on, &off))
        enclose_rim(ray, &on, &off);
    for (double middle = on + (off - on) / 2; on < middle && middle < off; middle = on + (off - on) / 2)
        *(is_on_surface(ray, middle) ? &on : &off) = middle;
    way->rims[2] = way->rims[1], way->rims[1] = way->rims[0];
    way->rims[0] = (struct lx_iso_rim){share, on};
    way->rim_count = way->rim_count < 3 ? way->rim_count + 1 : 3;
    return on;
}

/* From `inner` on through a share of the chord: the last place of the surface on the way out, and a little back where
 * lines of sight touch it. */
static void reach_rim(struct lx_iso_way *way, double share, double xy_mm[2])
{
    const struct lx_iso_search *search = way->search;
    const double *inner = way->inner_mm;
    struct ray ray = {.search = search, .surface = way->surface};
    for (int i = 0; i < 2; i++) {
        const double *from = &way->ends_mm[0][i], *to = &way->ends_mm[1][i];
        ray.inner_mm[i] = inner[i];
        ray.direction[i] = *from + share * (*to - *from) - inner[i];
    }
    const double length = hypot(ray.direction[0], ray.direction[1]);
    ray.room = room_on_screen(search, inner, ray.direction);
    double reach = find_rim(way, &ray, share);
    /* where lines of sight touch the surface rounding shows in the value as its root: not so a little inside */
    if (lx_shape_has_limb(&search->evaluator->prepared.surfaces[way->surface].shape) && length > 0)
        reach = fmax(0, reach - search->pull_mm / length);
    xy_mm[0] = inner[0] + reach * ray.direction[0], xy_mm[1] = inner[1] + reach * ray.direction[1];
}

/*
 * Along a rim the way runs from one end (at -1) straight to the rim (at 0), along it, always where the line from the
 * inner place through the chord of the two ends meets it (to 1), and straight to the other end (at 2).
 */
static void rim_place(struct lx_iso_way *way, double at, double xy_mm[2])
{
    double rim[2];
    reach_rim(way, fmin(fmax(at, 0), 1), rim);
    double back = at < 0 ? -at : at > 1 ? at - 1 : 0;
    const double *end = way->ends_mm[at > 1];
    for (int i = 0; i < 2; i++)
        xy_mm[i] = back < 1 ? rim[i] + back * (end[i] - rim[i]) : end[i];
}

void lx_iso_way_place(struct lx_iso_way *way, double at, double xy_mm[2])
{
    if (way->along_rim) {
        rim_place(way, at, xy_mm);
        return;
    }
    xy_mm[way->axis] = at;
    xy_mm[1 - way->axis] = way->across_mm;
}

/* The value at a place of the way, which is remembered. */
static double follow(struct lx_iso_way *way, double at)
{
    double xy_mm[2];
    lx_iso_way_place(way, at, xy_mm);
    double value = lx_iso_value(way->search, way->surface, xy_mm);
    size_t place = way->count;
    if (isnan(value) || way->count == LX_ISO_SAMPLES)
        return value;
    while (place > 0 && way->samples[place - 1].at > at) {
        way->samples[place] = way->samples[place - 1];
        place--;
    }
    way->samples[place] = (struct lx_iso_sample){at, value};
    way->count++;
    return value;
}

/* -- where it is on a level -- */

/* Secants from where a straight line between rough values would meet the level; false: they do not lead there. */
static bool cross_fast(struct lx_iso_way *way, double level, struct lx_iso_sample from, struct lx_iso_sample to,
                       double *at)
{
    double low = fmin(from.at, to.at), high = fmax(from.at, to.at);
    double slope = (to.value - from.value) / (to.at - from.at), goal = way->search->goal * fabs(level);
    struct lx_iso_sample last = {0};
    double place = from.at + (level - from.value) / slope;
    for (int i = 0; i < 7; i++) {
        if (!(place >= low && place <= high))
            return false;
        double off = follow(way, place) - level;
        *at = place;
        if (fabs(off) <= goal)
            return true;
        if (!isfinite(off) || (i > 0 && !(fabs(off) < 0.5 * fabs(last.value))))
            return false;
        if (i > 0)
            slope = (off - last.value) / (place - last.at);
        last = (struct lx_iso_sample){place, off};
        place -= off / slope;
    }
    return false;
}

/*
 * The tightest bracket of the level among what was found between two places, as distances from the level; false: there
 * is none.
 */
static bool find_bracket(const struct lx_iso_way *way, double level, double from, double to,
                         struct lx_iso_sample bracket[2])
{
    double low = fmin(from, to), high = fmax(from, to);
    for (size_t i = 0; i + 1 < way->count; i++) {
        const struct lx_iso_sample *pair = &way->samples[i];
        if (pair[0].at < low || pair[1].at > high || (pair[0].value >= level) == (pair[1].value >= level))
            continue;
        for (int k = 0; k < 2; k++)
            bracket[k] = (struct lx_iso_sample){pair[k].at, pair[k].value - level};
        return true;
    }
    return false;
}

/* Whether values jump over the level, as at shadows' edges: within what no screen shows they differ by much of what the
 * whole bracket does. */
static bool is_jump(const struct lx_iso_way *way, const struct lx_iso_sample *a, const struct lx_iso_sample *b,
                    double change)
{
    return fabs(a->at - b->at) <= way->search->pull_mm && fabs(a->value - b->value) > 0.1 * change;
}

/* Chandrupatla's method: inverse quadratic interpolation where it may be trusted, else halving. */
static bool cross_safely(struct lx_iso_way *way, double level, const struct lx_iso_sample bracket[2], double *at)
{
    const double goal = way->search->goal * fabs(level), accept = way->search->accept * fabs(level);
    const double change = fabs(bracket[1].value - bracket[0].value);
    struct lx_iso_sample a = bracket[1], b = bracket[0], c = a;
    double t = 0.5;
    for (int i = 0; i < 200; i++) {
        double place = a.at + t * (b.at - a.at), middle = a.at + 0.5 * (b.at - a.at);
        if (place == a.at || place == b.at)
            place = middle;
        if (place == a.at || place == b.at)
            break;
        double off = follow(way, place) - level;
        if (isnan(off))
            return false;
        if ((off >= 0) == (a.value >= 0)) {
            c = a;
        } else {
            c = b;
            b = a;
        }
        a = (struct lx_iso_sample){place, off};
        if (fabs(off) <= goal)
            break;
        if (is_jump(way, &a, &b, change))
            return false;
        double xi = (a.at - b.at) / (c.at - b.at), phi = (a.value - b.value) / (c.value - b.value);
        bool trust = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
        t = !trust ? 0.5
                   : a.value / (b.value - a.value) * c.value / (b.value - c.value) +
                         (c.at - a.at) / (b.at - a.at) * a.value / (c.value - a.value) * b.value / (c.value - b.value);
        if (!(t > 0 && t < 1))
            t = 0.5;
    }
    const struct lx_iso_sample *best = fabs(a.value) <= fabs(b.value) ? &a : &b;
    *at = best->at;
    return fabs(best->value) <= accept;
}

bool lx_iso_way_cross(struct lx_iso_way *way, double level, struct lx_iso_sample from, struct lx_iso_sample to,
                      double *at)
{
    struct lx_iso_sample bracket[2];
    bool known = find_bracket(way, level, from.at, to.at, bracket);
    if (known) {
        from = (struct lx_iso_sample){bracket[0].at, bracket[0].value + level};
        to = (struct lx_iso_sample){bracket[1].at, bracket[1].value + level};
    }
    if (cross_fast(way, level, from, to, at))
        return true;
    if (!known) {
        follow(way, from.at);
        follow(way, to.at);
    }
    if (!find_bracket(way, level, from.at, to.at, bracket))
        return false;
    return cross_safely(way, level, bracket, at);
}

/* -- where it leaves its surface, and where it has an extremum -- */

double lx_iso_way_leave(struct lx_iso_way *way, double on, double off)
{
    double close = way->search->pull_mm, xy_mm[2];
    lx_iso_way_place(way, off, xy_mm);
    if (lx_iso_seen(way->search, xy_mm) == way->surface)
        return off;
    while (fabs(off - on) > close) {
        double middle = on + (off - on) / 2;
        if (middle == on || middle == off)
            break;
        lx_iso_way_place(way, middle, xy_mm);
        *(lx_iso_seen(way->search, xy_mm) == way->surface ? &on : &off) = middle;
    }
    return on;
}

struct lx_iso_sample lx_iso_way_extremum(struct lx_iso_way *way, double from, double to, double sign)
{
    const double golden = 0.38196601125010515, tolerance = 1e-7 * fabs(to - from);
    double low = fmin(from, to), high = fmax(from, to), inner = low + golden * (high - low);
    struct lx_iso_sample best = {inner, follow(way, inner)};
    for (int i = 0; i < 60 && high - low > tolerance && !isnan(best.value); i++) {
        bool after = high - best.at > best.at - low;
        double place = after ? best.at + golden * (high - best.at) : best.at - golden * (best.at - low);
        double value = follow(way, place);
        if (isnan(value))
            return (struct lx_iso_sample){place, value};
        if (sign * value > sign * best.value) {
            *(after ? &low : &high) = best.at;
            best = (struct lx_iso_sample){place, value};
        } else {
            *(after ? &high : &low) = place;
        }
    }
    return best;
}

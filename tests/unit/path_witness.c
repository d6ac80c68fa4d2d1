/* SPDX-License-Identifier: MIT */
/*
 * Paths begin at the element, in directions by Lambert's law; where one ends, direct light is added, and it goes on.
 * The mean of n independent values from 0 to B is known to sqrt(2 V l/n) + 7 B l/(3 (n - 1)), l = ln(4/d), V their
 * sample variance, but for one case in 1/d (Maurer and Pontil 2009, the empirical inequality of Bernstein, both ways).
 */
#include "path_witness.h"

#include <math.h>
#include <string.h>

static const double LEAST_WAY = 1e-9; /* metres */

struct random_state {
    uint64_t state;
};

static double uniform_share(struct random_state *random) /* splitmix64 */
{
    uint64_t z = random->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

void path_frame(const double axis[3], const double up[3], double across[3], double upward[3])
{
    cross(up, axis, across);
    const double length = sqrt(dot(across, across));
    for (int i = 0; i < 3; i++)
        across[i] /= length;
    cross(axis, across, upward);
}

struct path_thing path_triangle(const double corners[3][3], double reflectance)
{
    struct path_thing made = {.reflectance = reflectance, .is_triangle = 1};
    double first[3], second[3], low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, at[3][2];
    for (int i = 0; i < 3; i++) {
        first[i] = corners[1][i] - corners[0][i];
        second[i] = corners[2][i] - corners[0][i];
    }
    cross(first, second, made.axis);
    const double length = sqrt(dot(made.axis, made.axis)), along = sqrt(dot(first, first));
    for (int i = 0; i < 3; i++) {
        made.axis[i] /= length;
        made.across[i] = first[i] / along;
    }
    cross(made.axis, made.across, made.upward);
    for (int c = 0; c < 3; c++) {
        at[c][0] = dot(corners[c], made.across);
        at[c][1] = dot(corners[c], made.upward);
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], at[c][k]);
            high[k] = fmax(high[k], at[c][k]);
        }
    }
    const double height = dot(corners[0], made.axis);
    for (int i = 0; i < 3; i++)
        made.center[i] =
            (low[0] + high[0]) / 2 * made.across[i] + (low[1] + high[1]) / 2 * made.upward[i] + height * made.axis[i];
    for (int k = 0; k < 2; k++) {
        made.half[k] = (high[k] - low[k]) / 2;
        for (int c = 0; c < 3; c++)
            made.corners[c][k] = at[c][k] - (low[k] + high[k]) / 2;
    }
    return made;
}

static int is_in_triangle(const struct path_thing *thing, double x, double y)
{
    int inside = 1;
    for (int c = 0; c < 3; c++) {
        const double *a = thing->corners[c], *b = thing->corners[(c + 1) % 3];
        inside = inside && (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0;
    }
    return inside;
}

/* How far a ray goes to a thing; infinite: it misses. */
static double way_to(const struct path_thing *thing, const double from[3], const double direction[3])
{
    double offset[3], hit[3];
    for (int i = 0; i < 3; i++)
        offset[i] = from[i] - thing->center[i];
    if (thing->radius > 0) {
        const double along = dot(offset, direction);
        const double below = along * along - dot(offset, offset) + thing->radius * thing->radius;
        if (below <= 0)
            return HUGE_VAL;
        const double way = -along - sqrt(below);
        return way > LEAST_WAY ? way : HUGE_VAL;
    }
    const double steep = dot(direction, thing->axis), way = -dot(offset, thing->axis) / steep;
    if (!(way > LEAST_WAY) || !(way < 1e9))
        return HUGE_VAL;
    for (int i = 0; i < 3; i++)
        hit[i] = offset[i] + way * direction[i];
    const double x = dot(hit, thing->across), y = dot(hit, thing->upward);
    const int is_in =
        thing->is_triangle ? is_in_triangle(thing, x, y) : fabs(x) <= thing->half[0] && fabs(y) <= thing->half[1];
    return is_in ? way : HUGE_VAL;
}

/* The thing that a ray meets first, but not the one that it comes from if that is flat; NULL: none. */
static const struct path_thing *meet(const struct path_room *room, const struct path_thing *own, const double from[3],
                                     const double direction[3], double *nearest)
{
    const struct path_thing *met = NULL;
    for (size_t i = 0; i < room->thing_count; i++) {
        const struct path_thing *thing = &room->things[i];
        const double way = thing == own ? HUGE_VAL : way_to(thing, from, direction);
        if (way < *nearest) {
            *nearest = way;
            met = thing;
        }
    }
    return met;
}

/* Direct light at a place of a thing: of extended lamps by one place of theirs. */
static double direct_light(const struct path_room *room, const struct path_thing *own, const double place[3],
                           const double normal[3], struct random_state *random)
{
    double sum = 0;
    for (size_t l = 0; l < room->lamp_count; l++) {
        const struct path_lamp *lamp = &room->lamps[l];
        double way[3], strength = lamp->intensity;
        const double x = lamp->luminance > 0 ? (2 * uniform_share(random) - 1) * lamp->half[0] : 0;
        const double y = lamp->luminance > 0 ? (2 * uniform_share(random) - 1) * lamp->half[1] : 0;
        for (int i = 0; i < 3; i++)
            way[i] = lamp->center[i] + x * lamp->across[i] + y * lamp->upward[i] - place[i];
        const double square = dot(way, way), length = sqrt(square);
        for (int i = 0; i < 3; i++)
            way[i] /= length;
        if (lamp->luminance > 0)
            strength = lamp->luminance * 4 * lamp->half[0] * lamp->half[1] * fmax(-dot(way, lamp->axis), 0);
        const double light = strength * fmax(dot(way, normal), 0) / square;
        double nearest = length;
        if (light > 0 && !meet(room, own, place, way, &nearest))
            sum += light;
    }
    return sum;
}

/* ---- the greatest direct light ---- */

static double distance_to(const struct path_thing *thing, const double place[3])
{
    double from[3], square = 0;
    for (int i = 0; i < 3; i++)
        from[i] = place[i] - thing->center[i];
    if (thing->radius > 0)
        return sqrt(dot(from, from)) - thing->radius;
    const double beyond[3] = {fmax(fabs(dot(from, thing->across)) - thing->half[0], 0),
                              fmax(fabs(dot(from, thing->upward)) - thing->half[1], 0), dot(from, thing->axis)};
    for (int i = 0; i < 3; i++)
        square += beyond[i] * beyond[i];
    return sqrt(square);
}

/* Whether all of a flat thing is behind a lamp that shines to one side. */
static int is_behind(const struct path_thing *thing, const struct path_lamp *lamp)
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = thing->center[i] - lamp->center[i];
    const double reach = thing->radius > 0 ? thing->radius
                                           : fabs(dot(thing->across, lamp->axis)) * thing->half[0] +
                                                 fabs(dot(thing->upward, lamp->axis)) * thing->half[1];
    return lamp->luminance > 0 && dot(from, lamp->axis) + reach <= 0;
}

static double greatest_direct(const struct path_room *room)
{
    double sum = 0;
    for (size_t l = 0; l < room->lamp_count; l++) {
        const struct path_lamp *lamp = &room->lamps[l];
        const double reach = lamp->luminance > 0 ? hypot(lamp->half[0], lamp->half[1]) : 0;
        const double strength =
            lamp->luminance > 0 ? lamp->luminance * 4 * lamp->half[0] * lamp->half[1] : lamp->intensity;
        double nearest = HUGE_VAL;
        for (size_t i = 0; i < room->thing_count; i++)
            if (!is_behind(&room->things[i], lamp))
                nearest = fmin(nearest, distance_to(&room->things[i], lamp->center) - reach);
        sum += nearest > 0 ? strength / (nearest * nearest) : HUGE_VAL;
    }
    return sum;
}

/* ---- paths ---- */

static void scatter(const double normal[3], struct random_state *random, double direction[3])
{
    double across[3], upward[3];
    const double up[3] = {fabs(normal[0]) < 0.6, fabs(normal[0]) >= 0.6, 0};
    path_frame(normal, up, across, upward);
    const double turn = 2 * M_PI * uniform_share(random), square = uniform_share(random), out = sqrt(square);
    for (int i = 0; i < 3; i++)
        direction[i] = sqrt(1 - square) * normal[i] + out * (cos(turn) * across[i] + sin(turn) * upward[i]);
}

static double follow(const struct path_room *room, const double place[3], const double normal[3], double least_weight,
                     struct random_state *random)
{
    const struct path_thing *own = NULL;
    double at[3], out[3], sum = 0, weight = 1;
    memcpy(at, place, sizeof at);
    memcpy(out, normal, sizeof out);
    while (weight > least_weight) {
        double direction[3], way = HUGE_VAL;
        scatter(out, random, direction);
        own = meet(room, own, at, direction, &way);
        if (!own)
            break;
        for (int i = 0; i < 3; i++)
            at[i] += way * direction[i];
        for (int i = 0; i < 3; i++)
            out[i] = own->radius > 0 ? (at[i] - own->center[i]) / own->radius
                                     : (dot(direction, own->axis) < 0 ? 1 : -1) * own->axis[i];
        weight *= own->reflectance;
        sum += weight * direct_light(room, own, at, out, random);
    }
    return sum;
}

struct path_interval path_reflected(const struct path_room *room, const double place[3], const double normal[3],
                                    size_t paths, uint64_t seed)
{
    const double least_weight = 1e-4, l = log(4 / 1e-9), n = (double)paths;
    struct random_state random = {seed};
    double largest = 0, mean = 0, squares = 0;
    for (size_t i = 0; i < room->thing_count; i++)
        largest = fmax(largest, room->things[i].reflectance);
    /* a path brings at most the sum of all bounces of the greatest direct light, and leaves a small part of that */
    const double most = greatest_direct(room) * largest / (1 - largest), left = least_weight / largest * most;
    for (size_t i = 0; i < paths; i++) {
        const double value = follow(room, place, normal, least_weight, &random), step = value - mean;
        mean += step / (double)(i + 1);
        squares += step * (value - mean);
    }
    const double error = sqrt(2 * squares / (n - 1) * l / n) + 7 * most * l / (3 * (n - 1));
    return (struct path_interval){mean + left / 2, error + left / 2};
}

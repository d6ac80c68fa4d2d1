/* SPDX-License-Identifier: MIT */
/*
 * Totals over emitters.  A point gives off I times the integral of its profile g over the sphere, a shell of uniform
 * radiance pi times that and its area (Lambert), whatever the attenuation law makes of it on its way.
 */
#include "totals.h"

#include <math.h>
#include <string.h>

#include "../base/pose.h"
#include "solid/extended.h"
#include "solid/solid_angle.h"

/* ---- flux ---- */

/* The intensity that an opening is worth, as a point; both of its sides have the same area. */
static double strength_of_opening(const struct lx_emitter *emitter)
{
    return emitter->is_back ? 0 : emitter->radiance.value * (lx_extended_area_mm2(emitter).value / 1e6);
}

static double flux_of(const struct lx_emitter *emitter)
{
    if (lx_is_opening(emitter))
        return strength_of_opening(emitter) * lx_profile_solid_angle(&emitter->profile);
    if (lx_is_extended(emitter))
        return M_PI * emitter->radiance.value * (lx_extended_area_mm2(emitter).value / 1e6);
    return lx_is_point(emitter) ? emitter->strength * lx_profile_solid_angle(&emitter->profile) : (double)NAN;
}

double lx_emitters_flux(const struct lx_emitters *emitters)
{
    struct lx_emitter room;
    double sum = 0;
    for (size_t i = 0; i < emitters->count; i++)
        sum += flux_of(lx_emitter_at(emitters, i, &room));
    return sum;
}

/* ---- place ---- */

/* A sum of places with weights, in wide numbers: the middle of a rectangle is to be its centre to the last digit. */
struct middle {
    lx_wide3 sum;
    lx_wide weight;
};

static void add_place(struct middle *middle, lx_wide3 place_mm, lx_wide weight)
{
    middle->sum = lx_wide3_add(middle->sum, lx_wide3_mul(place_mm, weight));
    middle->weight = lx_wide_add(middle->weight, weight);
}

/* Triangle by triangle: each at the mean of its corners, with twice its area as the weight. */
static void add_facets(struct middle *middle, const struct lx_facets *facets)
{
    for (size_t i = 0; i < facets->face_count; i++) {
        const unsigned *loop = facets->loop + facets->faces[i].first;
        lx_wide3 first = facets->corners_mm[loop[0]];
        for (unsigned k = 2; k < facets->faces[i].count; k++) {
            lx_wide3 one = lx_wide3_sub(facets->corners_mm[loop[k - 1]], first);
            lx_wide3 other = lx_wide3_sub(facets->corners_mm[loop[k]], first);
            lx_wide3 third = lx_wide3_mul(lx_wide3_add(one, other), lx_wide_div(lx_wide_of(1), lx_wide_of(3)));
            add_place(middle, lx_wide3_add(first, third), lx_wide3_length(lx_wide3_cross(one, other)));
        }
    }
}

/* The intensity of the strongest point. */
static double greatest_strength(const struct lx_emitters *emitters)
{
    struct lx_emitter room;
    double greatest = 0;
    for (size_t i = 0; i < emitters->count; i++) {
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        if (lx_is_point(emitter))
            greatest = fmax(greatest, emitter->strength);
    }
    return greatest;
}

bool lx_emitters_place(const struct lx_emitters *emitters, double place_mm[3])
{
    struct middle middle = {.weight = lx_wide_of(0)};
    double greatest = greatest_strength(emitters);
    struct lx_emitter room;
    for (size_t i = 0; i < emitters->count; i++) {
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        if (emitter->facets)
            add_facets(&middle, emitter->facets);
        else if (lx_is_extended(emitter))
            add_place(&middle, lx_wide3_of(emitter->center_mm), lx_wide_of(2 * lx_extended_area_mm2(emitter).value));
        else if (lx_is_point(emitter))
            add_place(&middle, lx_wide3_of(emitter->position_mm),
                      lx_wide_of(greatest > 0 ? emitter->strength / greatest : 1));
    }
    if (!(middle.weight.high > 0))
        return false;
    place_mm[0] = lx_wide_value(lx_wide_div(middle.sum.x, middle.weight));
    place_mm[1] = lx_wide_value(lx_wide_div(middle.sum.y, middle.weight));
    place_mm[2] = lx_wide_value(lx_wide_div(middle.sum.z, middle.weight));
    return true;
}

/* ---- direction ---- */

static bool is_isotropic(const struct lx_emitter *emitter)
{
    return lx_is_point(emitter) && lx_profile_is_isotropic(&emitter->profile);
}

static bool direction_of(const struct lx_emitter *emitter, double direction[3])
{
    lx_bounded3 axis;
    double place[3];
    if (lx_is_opening(emitter)) {
        memcpy(direction,
               (double[]){emitter->profile.axis.x.value, emitter->profile.axis.y.value, emitter->profile.axis.z.value},
               3 * sizeof *direction);
        return true;
    }
    if (lx_is_extended(emitter))
        return lx_emitter_plane(emitter, place, direction);
    if (lx_is_uniform(emitter) || is_isotropic(emitter) || lx_is_dome(emitter))
        return false;
    axis = lx_is_endless(emitter) ? lx_negate3(emitter->towards) : emitter->profile.axis;
    memcpy(direction, (double[]){axis.x.value, axis.y.value, axis.z.value}, 3 * sizeof *direction);
    return true;
}

/* Whether a direction is another one, or against it: 1, -1, or 0 where it is neither. */
static int compare_directions(const double a[3], const double b[3])
{
    static const double SAME = 1e-9;
    bool same = true, opposite = true;
    for (int k = 0; k < 3; k++) {
        same = same && fabs(a[k] - b[k]) <= SAME;
        opposite = opposite && fabs(a[k] + b[k]) <= SAME;
    }
    return same ? 1 : opposite ? -1 : 0;
}

bool lx_emitters_direction(const struct lx_emitters *emitters, double direction[3])
{
    struct lx_emitter room;
    double first[3], other[3];
    if (emitters->count == 0 || !direction_of(lx_emitter_at(emitters, 0, &room), first))
        return false;
    for (size_t i = 1; i < emitters->count; i++) {
        if (!direction_of(lx_emitter_at(emitters, i, &room), other))
            return false;
        const int compared = compare_directions(other, first);
        if (compared == 0 || (compared < 0 && !lx_is_extended(lx_emitter_at(emitters, i, &room))))
            return false;
    }
    memcpy(direction, first, sizeof first);
    return true;
}

/* ---- intensity ---- */

double lx_emitters_intensity(const struct lx_emitters *emitters)
{
    struct lx_emitter room;
    double along[3], direction[3], sum = 0;
    if (emitters->count == 0)
        return (double)NAN;
    const struct lx_emitter *first = lx_emitter_at(emitters, 0, &room);
    if (!lx_has_place(first))
        return (double)NAN;
    if (!lx_has_axis(first) && emitters->count == 1 && !lx_is_opening(first))
        return M_PI * first->radiance.value * (first->radius_mm / 1e3) * (first->radius_mm / 1e3);
    const bool is_even = is_isotropic(first), is_flat = lx_is_extended(first);
    if (!is_even && !lx_emitters_direction(emitters, along))
        return (double)NAN;
    for (size_t i = 0; i < emitters->count; i++) {
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        if (lx_is_opening(emitter))
            sum += strength_of_opening(emitter) * lx_profile_on_axis(&emitter->profile);
        else if (!is_flat)
            sum += emitter->strength * lx_profile_on_axis(&emitter->profile);
        else if (direction_of(emitter, direction) && compare_directions(direction, along) > 0)
            sum += emitter->radiance.value * (lx_extended_area_mm2(emitter).value / 1e6);
    }
    return sum;
}

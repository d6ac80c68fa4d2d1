/* SPDX-License-Identifier: MIT */
/*
 * Totals over emitters.  A point gives off I times the integral of its profile g over the sphere, a shell of uniform
 * radiance pi times that and its area (Lambert), whatever the attenuation law makes of it on its way.
 *
 * With the profile cos^m within a hard cone of the half-angle b that integral is 2 pi F(b),
 *
 *     F(b) = (1 - cos(b)^(m+1))/(m+1).
 *
 * A soft edge is a mixture of hard cones: where f falls from 1 at the inner to 0 at the outer angle the integral is
 * 2 pi times that of -f'(b) F(b) over b between them, in which nothing cancels.  Gauss's rule takes it (gauss.h), on
 * panels that keep their distance from the singularity at 90 degrees and within which cos^m does not grow too much.
 */
#include "totals.h"

#include <math.h>
#include <string.h>

#include "../base/pose.h"
#include "extended.h"
#include "gauss.h"

/* Parts of an integral that matter no more. */
static const double NEGLIGIBLE = 1e-17;

/* ---- flux ---- */

/* The versine 1 - cos of the half-angle at the share s of the way from the inner to the outer angle. */
static double edge_versine(const struct lx_profile *profile, double s)
{
    double inner = profile->inner_versine.value;
    double versine = inner + s * (profile->outer_versine.value - inner);
    if (profile->falloff == LX_LINEAR) {
        double sine = sin((profile->inner_rad.value + s * (profile->outer_rad.value - profile->inner_rad.value)) / 2);
        versine = 2 * sine * sine;
    }
    return fmin(versine, 1);
}

/* -df/ds: with t = 1 - s f is t^2 (3 - 2t), t^2 or t */
static double edge_slope(enum lx_falloff falloff, double s)
{
    switch (falloff) {
    case LX_SMOOTHSTEP: return 6 * s * (1 - s);
    case LX_SQUARED: return 2 * (1 - s);
    default: return 1;
    }
}

/* F by the versine, to the last digits for small cones and large exponents. */
static double hard_cone(double versine, double exponent)
{
    return -expm1((exponent + 1) * log1p(-versine)) / (exponent + 1);
}

/* How much of the edge Gauss's rule may take at once from s on. */
static double panel_length(const struct lx_profile *profile, double s)
{
    double versine = edge_versine(profile, s), cosine = 1 - versine, power = profile->exponent + 1;
    if (exp((power + 1) * log1p(-versine)) < NEGLIGIBLE) /* F changes no more */
        return 1 - s;
    if (profile->falloff == LX_LINEAR) {
        double sine = sqrt(versine * (2 - versine)), width = profile->outer_rad.value - profile->inner_rad.value;
        return fmin(cosine / (2 + sqrt(power) / 2 + power * sine / 4) / width, 1 - s);
    }
    double width = profile->outer_versine.value - profile->inner_versine.value;
    return fmin(cosine / (2 + power / 4) / width, 1 - s);
}

/* The integral of -f' F over the edge. */
static double soft_cone(const struct lx_profile *profile)
{
    double sum = 0;
    for (double s = 0, length; s < 1; s += length) {
        length = panel_length(profile, s);
        for (int i = 0; i < LX_GAUSS_NODES; i++) {
            double at = s + length / 2 * (1 + lx_gauss[i].place);
            sum += length / 2 * lx_gauss[i].weight * edge_slope(profile->falloff, at) *
                   hard_cone(edge_versine(profile, at), profile->exponent);
        }
    }
    return sum;
}

/* The integral of the profile over the sphere, in sr. */
static double solid_angle(const struct lx_profile *profile)
{
    switch (profile->falloff) {
    case LX_NO_CONE: return profile->exponent == 0 ? 4 * M_PI : 2 * M_PI / (profile->exponent + 1); /* 0^0 = 1 */
    case LX_HARD: return 2 * M_PI * hard_cone(edge_versine(profile, 1), profile->exponent);
    default: return 2 * M_PI * soft_cone(profile);
    }
}

static double flux_of(const struct lx_emitter *emitter)
{
    if (lx_is_extended(emitter))
        return M_PI * emitter->radiance.value * (lx_extended_area_mm2(emitter).value / 1e6);
    return emitter->type == LX_POINT ? emitter->strength * solid_angle(&emitter->profile) : (double)NAN;
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
        if (emitter->type == LX_POINT)
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
        if (emitter->type == LX_FACETS)
            add_facets(&middle, emitter->facets);
        else if (lx_is_extended(emitter))
            add_place(&middle, lx_wide3_of(emitter->center_mm), lx_wide_of(2 * lx_extended_area_mm2(emitter).value));
        else if (emitter->type == LX_POINT)
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

static bool direction_of(const struct lx_emitter *emitter, double direction[3])
{
    lx_bounded3 axis = emitter->axis;
    switch (emitter->type) {
    case LX_DIRECTION: axis = lx_negate3(emitter->towards); break;
    case LX_POINT:
        if (emitter->profile.falloff == LX_NO_CONE && emitter->profile.exponent == 0)
            return false;
        axis = emitter->profile.axis;
        break;
    case LX_FACETS:
        if (emitter->facets->face_count != 1)
            return false;
        axis = lx_wide3_direction(emitter->facets->faces[0].normal);
        break;
    case LX_DISK: break;
    default: return false;
    }
    memcpy(direction, (double[]){axis.x.value, axis.y.value, axis.z.value}, 3 * sizeof *direction);
    return true;
}

bool lx_emitters_direction(const struct lx_emitters *emitters, double direction[3])
{
    static const double SAME = 1e-9;
    struct lx_emitter room;
    double first[3], other[3];
    if (emitters->count == 0 || !direction_of(lx_emitter_at(emitters, 0, &room), first))
        return false;
    for (size_t i = 1; i < emitters->count; i++) {
        if (!direction_of(lx_emitter_at(emitters, i, &room), other))
            return false;
        for (int k = 0; k < 3; k++)
            if (!(fabs(other[k] - first[k]) <= SAME))
                return false;
    }
    memcpy(direction, first, sizeof first);
    return true;
}

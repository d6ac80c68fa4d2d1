/* SPDX-License-Identifier: MIT */
/*
 * With p the place of a point, r its distance and L its direction from an element, what it gives is a(r) h(L), h being
 * the lobe times the pattern.  Along and across L its second derivatives are
 *
 *     | a'' h                (a'/r - a/r^2) h'     |
 *     | (a'/r - a/r^2) h'    a'/r h + a/r^2 h''    |
 *
 * and what the points of a cluster give differs from what one in their middle gives by at most half the largest length
 * of that matrix times the sum of I |p - c|^2, since the first derivatives cancel there; by at most the largest length
 * of the gradient (a' h, a/r h') times the sum of I |p - c|; and by no more than the most that they can give.
 */
#include "bound.h"

#include <float.h>
#include <math.h>

#include "../../base/larger.h"
#include "../../base/vector.h"

/* Bounds are computed with rounding, too: relative to them, and to the directions. */
static const double ROOM = 1 + 1e-6, ANGLE_ROOM = 1e-7;

/* The cone of what is within one angle of directions that are within another one of an axis. */
static struct lx_cone widened(const struct lx_cone *cone, double cosine, double sine)
{
    struct lx_cone wide = *cone;
    wide.sine = cone->sine * cosine + cone->cosine * sine;
    wide.cosine = cone->cosine * cosine - cone->sine * sine;
    if (cone->cosine <= -1 || cosine <= -1 || wide.sine < 0) {
        wide.cosine = -1;
        wide.sine = 0;
    }
    return wide;
}

/* The cosines of the angles between a direction and those of a cone. */
static struct lx_cosines cosines_to(const struct lx_cone *cone, const double direction[3])
{
    double cosine = lx_dot(cone->axis, direction), sine = sqrt(lx_larger(1 - cosine * cosine, 0));
    return (struct lx_cosines){
        .least = cosine <= -cone->cosine ? -1 : cosine * cone->cosine - sine * cone->sine,
        .most = cosine >= cone->cosine ? 1 : cosine * cone->cosine + sine * cone->sine,
    };
}

struct lx_lobe_limits lx_lobe_limits_of(const struct lx_lobe_double *lobe)
{
    return (struct lx_lobe_limits){.lobe = *lobe, .power = lx_power_of(lobe->exponent.value)};
}

/* ---- the law ---- */

/* a(r) and its derivatives, times powers of r that make them shares of it. */
struct law {
    double value;  /* a */
    double first;  /* |a'| r / a */
    double second; /* a'' r^2 / a */
    double mixed;  /* |a' r - a| / a */
};

static double attenuate(const struct lx_emitter *model, double distance_mm)
{
    switch (model->attenuation) {
    case LX_INVERSE_SQUARE: return 1e6 / (distance_mm * distance_mm);
    case LX_PRACTICAL: return 1e3 / (model->k_mm + distance_mm);
    case LX_POLYNOMIAL: return lx_by_polynomial(model->coefficients, distance_mm / 1000);
    case LX_NO_ATTENUATION: break;
    }
    return 1;
}

/*
 * Shares of 1/q with q = kc + kl r + kq r^2, up to the farthest distance.  The first, f = r q'/q, grows with the
 * distance up to 2, and g = r^2 q''/q with it; a/r and a/r^2 become less.  The second is 2 f^2 - g, between -1/8 and 6.
 */
static void set_polynomial(const struct lx_emitter *model, double farthest_mm, struct law *law)
{
    const double *coefficients = model->coefficients, r = farthest_mm / 1000;
    const double square = r * r * coefficients[2], sum = coefficients[0] + r * coefficients[1] + square;
    const double first = (r * coefficients[1] + 2 * square) / sum;
    law->first = fmin(first, 2);
    law->second = fmin(fmax(2 * first * first, 0.125), 6);
    law->mixed = 1 + law->first;
}

/* All of them become less with the distance, a, a/r, a/r^2 with them; so this is the most from there on. */
static struct law law_at(const struct lx_emitter *model, double distance_mm, double farthest_mm)
{
    struct law law = {.value = attenuate(model, distance_mm), .mixed = 1};
    if (model->attenuation == LX_POLYNOMIAL)
        set_polynomial(model, farthest_mm, &law);
    if (model->attenuation == LX_INVERSE_SQUARE)
        law.first = 2, law.second = 6, law.mixed = 3;
    if (model->attenuation == LX_PRACTICAL) {
        double share = distance_mm / (model->k_mm + distance_mm);
        law.first = share, law.second = 2 * share * share, law.mixed = 1 + share;
    }
    return law;
}

/* ---- the lobe ---- */

/* A cluster as it is seen from a region. */
struct sight {
    double towards[3];        /* unit, from the middle of the region to that of the cluster */
    double nearest, farthest; /* distances between any of both */
    double cosine, sine;      /* of the angle by which directions between them differ from `towards` */
};

static struct sight sight_of(const struct lx_receiver_region *region, const double center[3], double radius)
{
    double reach = (region->places.radius + radius) * ROOM, square = 0;
    struct sight sight;
    for (int k = 0; k < 3; k++) {
        sight.towards[k] = center[k] - region->places.center[k];
        square += sight.towards[k] * sight.towards[k];
    }
    double distance = sqrt(square);
    for (int k = 0; k < 3; k++)
        sight.towards[k] /= distance;
    sight.nearest = distance / ROOM - reach;
    sight.farthest = distance * ROOM + reach;
    sight.sine = reach / distance + ANGLE_ROOM;
    sight.cosine = sight.sine < 1 ? sqrt(1 - sight.sine * sight.sine) : 0;
    return sight;
}

/* The least square of the cosine of half the angle between L and V. */
static double least_half_square(const struct lx_receiver_region *region, const struct sight *sight)
{
    const struct lx_cone views = widened(&region->views, sight->cosine, sight->sine);
    return (1 + cosines_to(&views, sight->towards).least) / 2;
}

/*
 * S^n of the half vector as a function of L.  Where L turns by 1, H turns by J = 1/|L + V| = 1/(2 cos d) at most, d
 * being half the angle between L and V; so with F, F', F'' those of the power as a function of H the slope is J F', the
 * bend J^2 F'' + tan d (J + 1/2)/2 F'.
 */
static struct lx_jet jet_of_half(const struct lx_receiver_region *region, const struct sight *sight,
                                 const struct lx_power *power)
{
    const double square = least_half_square(region, sight), least = 1e-4;
    const struct lx_jet unknown = {.order = LX_ROUGH, .most = 1, .size = 1};
    if (!(square > least) || !(region->views.cosine > 0))
        return unknown;
    const double turn = 0.5 / sqrt(square), slant = sqrt((1 - square) / square);
    const double off = turn * (sight->sine / sight->cosine + region->views.sine / region->views.cosine);
    if (!(off < 1))
        return unknown;
    double half[3], length;
    for (int k = 0; k < 3; k++)
        half[k] = sight->towards[k] + region->views.axis[k];
    length = sqrt(lx_dot(half, half));
    for (int k = 0; k < 3; k++)
        half[k] /= length;
    const struct lx_cone normals = widened(&region->normals, sqrt(1 - off * off), off);
    struct lx_jet jet = lx_jet_of_power(power, cosines_to(&normals, half));
    jet.bend = turn * turn * jet.bend + slant * (turn + 0.5) / 2 * jet.slope;
    jet.slope *= turn;
    return jet;
}

/* The highlight's part of the lobe; `front`: that of max(0, N.L). */
static struct lx_jet jet_of_highlight(const struct lx_receiver_region *region, const struct sight *sight,
                                      const struct lx_lobe_limits *limits, const struct lx_jet *front,
                                      struct lx_cosines facing)
{
    const struct lx_lobe_double *lobe = &limits->lobe;
    struct lx_jet jet;
    if (LX_ENDS_AT_HORIZON(lobe->highlight) && !(facing.most > 0))
        return lx_jet_of_constant(0);
    if (LX_IS_BY_HALF(lobe->model)) {
        jet = jet_of_half(region, sight, &limits->power);
    } else {
        const struct lx_cone mirrored = widened(&region->mirrored, sight->cosine, sight->sine);
        jet = lx_jet_of_power(&limits->power, cosines_to(&mirrored, sight->towards));
    }
    if (LX_FALLS_TO_HORIZON(lobe->highlight))
        return lx_jet_times(&jet, front);
    if (LX_JUMPS_AT_HORIZON(lobe->highlight) && !(facing.least > 0)) {
        jet.order = LX_ROUGH;
        jet.least = 0;
    }
    return jet;
}

/* The pattern about the axes of a cluster. */
static struct lx_jet jet_of_pattern(const struct lx_tree *tree, const struct lx_cluster_turn *turn,
                                    const struct sight *sight)
{
    struct lx_cone axes = {.cosine = cos(turn->spread), .sine = sin(turn->spread)};
    for (int k = 0; k < 3; k++)
        axes.axis[k] = -turn->axis[k];
    axes = widened(&axes, sight->cosine, sight->sine);
    const struct lx_cosines cosines = cosines_to(&axes, sight->towards);
    const struct lx_jet cone = lx_jet_of_cone(&tree->model.profile, cosines);
    if (!(tree->pattern.exponent > 0))
        return cone;
    const struct lx_jet power = lx_jet_of_power(&tree->pattern, cosines);
    return lx_jet_times(&power, &cone);
}

/* ---- the bound ---- */

/* The larger eigenvalue of a symmetric matrix of two rows, of entries that are not negative. */
static double matrix_length(double a, double b, double c)
{
    return (a + c) / 2 + sqrt((a - c) * (a - c) / 4 + b * b);
}

/* How far the middle of a cluster may be from that of its strength: by the roundings of a leaf and of each level. */
static double misplaced(const struct lx_cluster *cluster)
{
    const double *center = cluster->center_mm;
    return 16 * DBL_EPSILON * (fabs(center[0]) + fabs(center[1]) + fabs(center[2]));
}

/* How far a cluster may be off, relative to a(r). */
static double relative_error(const struct lx_jet *jet, const struct law *law, const struct lx_cluster *cluster,
                             double nearest)
{
    const double most = cluster->strength * jet->most, along = law->first * jet->size;
    const double slope = sqrt(along * along + jet->slope * jet->slope) / nearest;
    double second = 0, first = 0;
    if (jet->order <= LX_FOLDED) {
        double across = along + jet->bend;
        second = matrix_length(law->second * jet->size, law->mixed * jet->slope, across) / 2 * cluster->second /
                 (nearest * nearest);
    }
    if (jet->order >= LX_FOLDED && jet->order <= LX_STEEP)
        first = slope * sqrt(cluster->strength * cluster->second); /* sum I |p - c|, by Cauchy and Schwarz */
    double error = jet->order == LX_ROUGH ? most : jet->order == LX_FOLDED ? (first + second) / 2 : first + second;
    error += cluster->strength * slope * misplaced(cluster);
    return error < most ? error : most;
}

/* What is known of a part of the lobe with the pattern. */
static void add_part(const struct lx_jet *part, const struct lx_jet *pattern, double factor, const struct law *law,
                     const struct lx_cluster *cluster, const struct lx_cluster_turn *turn, double nearest,
                     struct lx_share_bound *bound)
{
    const struct lx_jet jet = pattern ? lx_jet_times(part, pattern) : *part;
    const double most = cluster->strength * jet.most;
    double error = relative_error(&jet, law, cluster, nearest);
    /* The points of a cluster may be turned otherwise than its middle. */
    if (pattern && turn->sum > 0)
        error = pattern->order == LX_ROUGH ? most : fmin(error + pattern->slope * part->most * turn->sum, most);
    bound->error += factor * error;
    bound->most += factor * most;
    bound->least += factor * cluster->strength * jet.least;
}

struct lx_share_bound lx_bound_cluster(const struct lx_receiver_region *region, const double anchor_mm[3],
                                       const struct lx_lobe_limits *limits, const struct lx_tree *tree,
                                       const struct lx_cluster *cluster, const struct lx_cluster_turn *turn,
                                       bool is_hidden)
{
    const struct lx_share_bound unknown = {.error = HUGE_VAL, .most = HUGE_VAL};
    double center[3];
    for (int k = 0; k < 3; k++)
        center[k] = cluster->center_mm[k] - anchor_mm[k];
    const struct sight sight = sight_of(region, center, cluster->radius_mm);
    if (!(sight.nearest > 0 && sight.sine < 1))
        return unknown;
    const struct law law = law_at(&tree->model, sight.nearest, sight.farthest);
    const struct lx_cone normals = widened(&region->normals, sight.cosine, sight.sine);
    const struct lx_cosines facing = cosines_to(&normals, sight.towards);
    static const struct lx_power plain = {.exponent = 1, .whole = 1};
    const struct lx_jet front = lx_jet_of_power(&plain, facing);
    struct lx_share_bound bound = {.error = 0};
    struct lx_jet pattern;
    if (tree->has_axis)
        pattern = jet_of_pattern(tree, turn, &sight);
    const struct lx_jet *by = tree->has_axis ? &pattern : NULL;
    if (limits->lobe.diffuse > 0)
        add_part(&front, by, limits->lobe.diffuse, &law, cluster, turn, sight.nearest, &bound);
    if (LX_HAS_HIGHLIGHT(limits->lobe.model)) {
        const struct lx_jet highlight = jet_of_highlight(region, &sight, limits, &front, facing);
        add_part(&highlight, by, limits->lobe.specular, &law, cluster, turn, sight.nearest, &bound);
    }
    bound.error *= law.value * ROOM;
    bound.most *= law.value * ROOM;
    bound.least *= attenuate(&tree->model, sight.farthest) / ROOM;
    if (is_hidden) {
        bound.error = bound.most;
        bound.least = 0;
    }
    return bound.error >= 0 && bound.error < HUGE_VAL ? bound : unknown;
}

struct lx_stand lx_stand_of(const struct lx_receiver_region *region, const double place[3], bool has_half)
{
    const struct sight sight = sight_of(region, place, 0);
    struct lx_stand stand = {.nearest_mm = sight.nearest, .away_mm = sqrt(lx_dot(place, place)), .least_half = 2};
    if (!(sight.nearest > 0 && sight.sine < 1))
        stand.nearest_mm = 0;
    else if (has_half)
        stand.least_half = 2 * sqrt(lx_larger(least_half_square(region, &sight), 0));
    return stand;
}

/* SPDX-License-Identifier: MIT */
/* The bound of what comes over more mirrors than are counted. */
#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "images.h"
#include "mirrors.h"

/* What the rest is a bound of: light that falls straight on the element, as it is and times the cosine. */
struct rest {
    double straight, by_cosine;
};

/* The law of a distance in mm, of a light of the intensity 1. */
static double by_law(const struct lx_emitter *emitter, double distance_mm)
{
    const double distance_m = distance_mm / 1000;
    return lx_relative_law(emitter, distance_mm) / (distance_m * distance_m);
}

/* The greatest intensity of a light that stands somewhere. */
static double greatest_intensity(const struct lx_emitter *emitter)
{
    return lx_is_point(emitter) ? emitter->strength + emitter->strength_error
                                : (emitter->radiance.value + emitter->radiance.error) *
                                      lx_emitter_kind(emitter)->section_mm2(emitter) * 1e-6;
}

/* What share of its greatest intensity a light sends to a place at most, along a unit vector towards its middle; no
 * part of it is nearer than `nearest`. */
static double greatest_share(const struct lx_emitter *emitter, const double place[3], const double towards[3],
                             double nearest)
{
    double at[3], normal[3], height = 0;
    if (lx_is_point(emitter)) {
        const lx_bounded value = lx_profile_value(&emitter->profile, lx_exact3(towards));
        return fmin(value.value + value.error, 1);
    }
    if (emitter->profile.luminaire || !lx_emitter_plane(emitter, at, normal))
        return 1;
    for (int k = 0; k < 3; k++)
        height += normal[k] * (place[k] - at[k]);
    return fmin(fmax(height, 0) * (1 + 1e-9) / nearest + 1e-12, 1);
}

/* Adds the most that comes by one way that is longer than is counted. */
static void add_way(const struct lx_mirror_way *way, const struct lx_element *element, const struct lx_emitter *emitter,
                    struct rest *rest)
{
    const struct lx_element image = lx_mirrored_element(way, element);
    const bool endless = lx_is_endless(emitter);
    const double radius = lx_is_extended(emitter) ? lx_emitter_radius(emitter) : 0;
    const double *at = lx_is_extended(emitter) ? lx_emitter_center(emitter) : emitter->position_mm;
    double place[3], towards[3], normal[3];
    lx_values3(image.place_mm, place);
    lx_values3(image.normal, normal);
    lx_values3(emitter->towards, towards);
    for (int k = 0; k < 3 && !endless; k++)
        towards[k] = at[k] - place[k];
    const double distance = endless ? 1 : sqrt(lx_dot(towards, towards));
    for (unsigned j = 0; j < way->count; j++) {
        const struct lx_aperture *aperture = &way->apertures[j];
        const double height = aperture->height_mm - lx_dot(aperture->normal, place);
        const double change = lx_dot(aperture->normal, towards);
        const double room = 1e-9 * (fabs(aperture->height_mm) + lx_distance(aperture->corners_mm[0], place));
        if (height < -room || (endless ? change < -1e-9 : change + radius < height - room))
            return;
        if (radius > 0 || !(change > 0))
            continue;
        double middle[3], size = 0, met[3];
        lx_aperture_middle(aperture, middle);
        for (unsigned i = 0; i < aperture->count; i++)
            size = fmax(size, lx_distance(aperture->corners_mm[i], middle));
        for (int k = 0; k < 3; k++)
            met[k] = place[k] + height / change * towards[k];
        if (lx_distance(met, middle) > size * (1 + 1e-9) + room * (1 + distance / change))
            return;
    }
    const double nearest = distance - radius;
    const double cosine = fmax((lx_dot(normal, towards) + radius) / fmax(distance, DBL_MIN), 0) + 1e-12;
    double e_perp = HUGE_VAL;
    if (endless)
        e_perp = emitter->strength + emitter->strength_error;
    else if (nearest > 0) {
        lx_normalize(towards);
        e_perp =
            greatest_intensity(emitter) * by_law(emitter, nearest) * greatest_share(emitter, place, towards, nearest);
    }
    rest->straight += e_perp * (1 + 1e-9);
    const double largest = radius > 0 ? cosine * distance / fmax(nearest, DBL_MIN) : cosine;
    rest->by_cosine += e_perp * (1 + 1e-9) * fmin(largest, 1);
}

/* Whether light falls with the square of the distance, far away at least. */
static bool falls_by_square(const struct lx_emitter *emitter, double *share)
{
    *share = emitter->attenuation == LX_POLYNOMIAL ? 1 / emitter->coefficients[2] : 1;
    return emitter->attenuation == LX_INVERSE_SQUARE ||
           (emitter->attenuation == LX_POLYNOMIAL && emitter->coefficients[2] > 0);
}

/* How far a light and a place are from each other at most, along all or, unless NULL, one axis, by way of mirrors that
 * are not in pairs. */
static double farthest_off(const struct lx_prepared *prepared, const double *at, const double *place,
                           const double *axis)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    double most = 0, sum = 0, offset[3];
    for (int k = 0; k < 3; k++)
        offset[k] = at[k] - place[k];
    most = axis ? fabs(lx_dot(axis, offset)) : lx_distance(at, place);
    for (size_t m = 0; m < mirrors->count && mirrors->other_planes > 0; m++) {
        const struct lx_shape *plate = &prepared->surfaces[mirrors->surfaces[m]].shape;
        double from[3], to[3];
        for (int k = 0; k < 3; k++) {
            from[k] = at[k] - plate->anchor_mm[k];
            to[k] = place[k] - plate->anchor_mm[k];
        }
        if (!axis)
            sum += sqrt(lx_dot(from, from)) + sqrt(lx_dot(to, to));
        else if (fabs(lx_dot(axis, plate->axis)) > 0.5)
            most = fmax(most, fabs(lx_dot(axis, from)) + fabs(lx_dot(axis, to)));
    }
    return most + sum;
}

/* The place of a light that has one, and its radius. */
static double place_of(const struct lx_emitter *emitter, const double **at)
{
    *at = lx_is_extended(emitter) ? lx_emitter_center(emitter) : emitter->position_mm;
    return lx_is_extended(emitter) ? lx_emitter_radius(emitter) : 0;
}

/*
 * Adds what comes over more mirrors of two facing planes at the distance g: a way over n of them is (n - 1) g long at
 * least, so that with o single planes, at right angles to them, there are 2^o images at each of the two ends, and each
 * image lights an element by one way at most.  The cosine of incidence is no more than |N.a| + b/d, a the axis of the
 * two planes, b how far the image is off along all of the others.
 */
static void add_row(const struct lx_prepared *prepared, const struct lx_element *element,
                    const struct lx_emitter *emitter, double intensity, struct rest *rest)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    const double gap = mirrors->pair_gaps_mm[0], images = 2 << mirrors->other_planes;
    const double first = (double)mirrors->deepest - mirrors->other_planes; /* n - 1 of the first of these ways */
    const double *at;
    double place[3], normal[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    const double radius = place_of(emitter, &at), off = farthest_off(prepared, at, place, NULL) + radius;
    if (!(first >= 1)) {
        rest->straight = rest->by_cosine = HUGE_VAL;
        return;
    }
    /* the sums of 1/n^2 and 1/n^3 from the first on */
    const double squares = 1 / (first * first) + 1 / first, cubes = 1 / pow(first, 3) + 1 / (2 * first * first);
    const double gap_m = gap / 1000, strength = images * intensity / (gap_m * gap_m);
    const double tilt = fabs(lx_dot(normal, mirrors->pair_axes[0])) + 1e-12;
    rest->straight += strength * squares;
    rest->by_cosine += strength * fmin(tilt * squares + off / gap * cubes, squares);
}

/* How the intensity of a light becomes less near the plane of two pairs' axes, whose normal is `third`: not, with the
 * sine of the angle to it, or to nothing below an angle with this sine. */
enum falling { DOES_NOT_FALL, FALLS_BY_SINE, ENDS };
static enum falling falls_aside(const struct lx_emitter *emitter, const double third[3], double sine)
{
    const struct lx_profile *profile = &emitter->profile;
    double at[3], axis[3];
    if (profile->luminaire)
        return DOES_NOT_FALL;
    if (lx_is_extended(emitter))
        return lx_emitter_plane(emitter, at, axis) && fabs(lx_dot(axis, third)) >= 1 - 1e-9 ? FALLS_BY_SINE
                                                                                            : DOES_NOT_FALL;
    lx_values3(profile->axis, axis);
    if (lx_profile_is_isotropic(profile) || fabs(lx_dot(axis, third)) < 1 - 1e-9)
        return DOES_NOT_FALL;
    if (profile->falloff != LX_NO_CONE && sine < cos(profile->outer_rad.value + profile->outer_rad.error))
        return ENDS;
    return profile->exponent >= 1 ? FALLS_BY_SINE : DOES_NOT_FALL;
}

/*
 * Adds what comes over more mirrors of two pairs of facing planes.  The sum of 1/d^2 over all images has no bound; that
 * of h/d^3 has one, h being how far light and element are apart along the third axis, and h/d the greatest sine of the
 * slope of a way to the other two.  It bounds what falls on elements that face the third axis, and what comes of lights
 * whose intensity falls with that sine.
 */
static void add_lattice(const struct lx_prepared *prepared, const struct lx_element *element,
                        const struct lx_emitter *emitter, double intensity, struct rest *rest)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    const double *at;
    double place[3], normal[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    const double radius = place_of(emitter, &at);
    const double off = (farthest_off(prepared, at, place, mirrors->third_axis) + radius) * (1 + 1e-9);
    const double sine = off / mirrors->nearest_mm;
    const enum falling falling = falls_aside(emitter, mirrors->third_axis, sine * (1 + 1e-9) + 1e-9);
    const bool faces_it =
        fabs(lx_dot(normal, mirrors->pair_axes[0])) + fabs(lx_dot(normal, mirrors->pair_axes[1])) <= 1e-9;
    const double sum = (1 << mirrors->other_planes) * intensity * 1e6 * off * mirrors->cubes_per_mm3;
    if (falling == ENDS)
        return;
    rest->straight += falling == FALLS_BY_SINE ? sum : HUGE_VAL;
    rest->by_cosine += !faces_it ? rest->straight : falling == FALLS_BY_SINE ? sum * fmin(sine, 1) : sum;
}

/* Whether parallel light has left the pairs after so many mirrors: it has come so far along, and aside by its slope. */
static bool has_left(const struct lx_mirrors *mirrors, const double towards[3])
{
    double along = 0, aside = 1;
    for (unsigned p = 0; p < mirrors->pair_count; p++) {
        const double part = fabs(lx_dot(towards, mirrors->pair_axes[p]));
        along += part / mirrors->pair_gaps_mm[p];
        aside -= part * part;
    }
    const double mirrored = (double)mirrors->deepest + 1 - mirrors->other_planes - mirrors->pair_count;
    return mirrored * sqrt(fmax(aside, 0)) > (double)(1 << mirrors->other_planes) * mirrors->pair_size_mm * along;
}

/* Adds what comes by ways over more mirrors than are known one by one. */
static void add_endless(const struct lx_prepared *prepared, const struct lx_element *element,
                        const struct lx_emitter *emitter, struct rest *rest)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    double towards[3], share = 1;
    lx_values3(emitter->towards, towards);
    if (mirrors->pair_count > 0 && lx_is_endless(emitter) && has_left(mirrors, towards))
        return;
    const bool is_known = lx_has_place(emitter) && falls_by_square(emitter, &share);
    const double intensity = is_known ? greatest_intensity(emitter) * share : 0;
    if (is_known && mirrors->pair_count == 1)
        add_row(prepared, element, emitter, intensity, rest);
    else if (is_known && mirrors->pair_count == 2 && mirrors->nearest_mm > 0)
        add_lattice(prepared, element, emitter, intensity, rest);
    else
        rest->straight = rest->by_cosine = HUGE_VAL;
}

/* No highlight, times its weight, makes more of light than this: a power is no more than 1, |A x L| + V.L of measures
 * no more than 2; of facets D is no more than 1/(pi a^2), and what is left of the other factors 1/(2 a). */
static double greatest_highlight(const struct lx_lobe *lobe)
{
    if (!lx_lobe_shines(lobe))
        return 0;
    const double most = lx_lobe_kind_of(lobe)->power ? 1
                        : lobe->model == LX_MEASURE  ? 2
                                                     : 0.5 / (lobe->own[2] * lobe->own[2] * lobe->own[2]);
    return (lobe->specular.value + lobe->specular.error) * most;
}

/* D N.L of a rough surface is below 3: Oren and Nayar's is below 1.5, EON's below 2 but for what its slopes send on to
 * each other, which is below 1. */
static double greatest_diffuse(const struct lx_lobe *lobe, const struct rest *rest)
{
    const double diffuse = lobe->diffuse.value + lobe->diffuse.error;
    return diffuse > 0 ? diffuse * (lx_lobe_is_rough(lobe) ? 3 * rest->straight : rest->by_cosine) : 0;
}

/* Cuts a polygon in room for MOST_SEEN corners to where n.(x - place) >= -room. */
enum { MOST_SEEN = 512 };
static unsigned cut_seen(double corners[][3], unsigned count, const double n[3], const double place[3], double room)
{
    double kept[MOST_SEEN][3];
    unsigned made = 0;
    for (unsigned i = 0; i < count && made + 2 <= MOST_SEEN; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % count];
        double at = room, then = room;
        for (int k = 0; k < 3; k++) {
            at += n[k] * (a[k] - place[k]);
            then += n[k] * (b[k] - place[k]);
        }
        if (at >= 0)
            memcpy(kept[made++], a, sizeof kept[0]);
        if ((at < 0) == (then < 0))
            continue;
        for (int k = 0; k < 3; k++)
            kept[made][k] = a[k] + at / (at - then) * (b[k] - a[k]);
        made++;
    }
    memcpy(corners, kept, made * sizeof kept[0]);
    return made;
}

/* Whether an element may see anything through all mirrors of a way. */
static bool may_see_through(const struct lx_mirror_way *way, const struct lx_element *element)
{
    const struct lx_element image = lx_mirrored_element(way, element);
    const struct lx_aperture *last = &way->apertures[way->count - 1];
    double seen[MOST_SEEN][3], place[3], normal[3];
    unsigned count = last->count;
    lx_values3(image.place_mm, place);
    lx_values3(image.normal, normal);
    const double room = 1e-9 * (fabs(last->height_mm) + lx_distance(last->corners_mm[0], place));
    memcpy(seen, last->corners_mm, count * sizeof seen[0]);
    if (!lx_lobe_reaches_below(element->lobe))
        count = cut_seen(seen, count, normal, place, room);
    for (unsigned j = 0; j < way->count && count > 0; j++) {
        const struct lx_aperture *aperture = &way->apertures[j];
        const double height = aperture->height_mm - lx_dot(aperture->normal, place);
        if (height < -room)
            return false;
        for (unsigned i = 0; i < aperture->count && j + 1 < way->count && height > room && count > 0; i++) {
            double inwards[3];
            lx_aperture_inwards(aperture, i, place, inwards);
            count = cut_seen(seen, count, inwards, place, room);
        }
    }
    return count > 0;
}

/* Whether an element may see anything over more mirrors than ways are known of. */
static bool may_see_beyond(const struct lx_prepared *prepared, const struct lx_element *element)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    for (size_t i = mirrors->way_count; i > 0 && mirrors->ways[i - 1].count == mirrors->deepest; i--)
        if (element->own != &prepared->surfaces[mirrors->ways[i - 1].surface] &&
            may_see_through(&mirrors->ways[i - 1], element))
            return true;
    return false;
}

void lx_add_rest(const struct lx_prepared *prepared, const struct lx_element *element, const struct lx_emitter *emitter,
                 struct lx_lighting *lighting)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    struct rest rest = {0, 0};
    for (size_t i = mirrors->computed; i < mirrors->way_count; i++)
        if (element->own != &prepared->surfaces[mirrors->ways[i].surface])
            add_way(&mirrors->ways[i], element, emitter, &rest);
    if (!mirrors->ends && may_see_beyond(prepared, element))
        add_endless(prepared, element, emitter, &rest);
    const double highlight = greatest_highlight(element->lobe);
    lighting->irradiance.error += rest.by_cosine;
    lighting->diffuse.error += greatest_diffuse(element->lobe, &rest);
    lighting->specular.error += highlight > 0 && rest.straight > 0 ? highlight * rest.straight : 0;
}

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
    const double e_perp = endless       ? emitter->strength + emitter->strength_error
                          : nearest > 0 ? greatest_intensity(emitter) * by_law(emitter, nearest)
                                        : HUGE_VAL;
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

/*
 * Adds what comes by ways over more mirrors than are known one by one.  Between two facing planes at the distance g a
 * way over n of their mirrors is (n - 1) g long at least; of ways that the other planes, at right angles to them, take
 * part in, there are 2^o images at each of the two ends, o the number of those planes, and each image lights an element
 * by one way at most.  The cosine of incidence is no more than |N.a| + b/d, a the axis of the two planes, b how far the
 * image is off along all of the others.
 */
static void add_endless(const struct lx_prepared *prepared, const struct lx_element *element,
                        const struct lx_emitter *emitter, struct rest *rest)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    const double gap = mirrors->pair_gap_mm, images = 2 << mirrors->other_planes;
    double place[3], normal[3], towards[3], share = 1;
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    lx_values3(emitter->towards, towards);
    if (gap > 0 && lx_is_endless(emitter)) {
        const double along = fabs(lx_dot(towards, mirrors->pair_axis)), aside = sqrt(fmax(1 - along * along, 0));
        const double least = (double)mirrors->deepest - mirrors->other_planes;
        if (least * gap * aside > (double)(1 << mirrors->other_planes) * mirrors->pair_size_mm * along)
            return; /* after so many mirrors it has left them */
    }
    const double first = (double)mirrors->deepest - mirrors->other_planes; /* n - 1 of the first of these ways */
    if (!(gap > 0) || !lx_has_place(emitter) || !falls_by_square(emitter, &share) || !(first >= 1)) {
        rest->straight = rest->by_cosine = HUGE_VAL;
        return;
    }
    const double radius = lx_is_extended(emitter) ? lx_emitter_radius(emitter) : 0;
    const double *at = lx_is_extended(emitter) ? lx_emitter_center(emitter) : emitter->position_mm;
    double off = lx_distance(at, place) + radius;
    for (size_t m = 0; m < mirrors->count && mirrors->other_planes > 0; m++) {
        const double *anchor = prepared->surfaces[mirrors->surfaces[m]].shape.anchor_mm;
        off += lx_distance(at, anchor) + lx_distance(place, anchor);
    }
    /* the sums of 1/n^2 and 1/n^3 from the first on */
    const double squares = 1 / (first * first) + 1 / first, cubes = 1 / pow(first, 3) + 1 / (2 * first * first);
    const double gap_m = gap / 1000, strength = images * greatest_intensity(emitter) * share / (gap_m * gap_m);
    const double tilt = fabs(lx_dot(normal, mirrors->pair_axis)) + 1e-12;
    rest->straight += strength * squares;
    rest->by_cosine += strength * fmin(tilt * squares + off / gap * cubes, squares);
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

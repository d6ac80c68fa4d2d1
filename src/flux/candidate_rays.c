/* SPDX-License-Identifier: MIT */
/* Leads: from each emitter along its profile's peaks, downward, and behind each surface. */
#include "candidate_rays.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../light/distribution.h"
#include "../light/solid/extended.h"

/* Peaks of a table that are followed, the greatest ones; and ways that are, of a ring of them. */
enum { MOST_PEAKS = 16, AROUND = 8 };

struct gathering {
    struct lx_candidate_rays *rays;
    size_t each;   /* how many peaks there may be of one emitter, and surfaces, at least 1 */
    bool is_short; /* memory ran out */
};

static void append(struct gathering *gathering, const double from_mm[3], const double way[3])
{
    struct lx_candidate_rays *rays = gathering->rays;
    if (lx_reserve(&rays->items, &rays->capacity, rays->count + 1, sizeof *rays->items)) {
        gathering->is_short = true;
        return;
    }
    struct lx_candidate_ray *ray = &rays->items[rays->count++];
    memcpy(ray->from_mm, from_mm, sizeof ray->from_mm);
    memcpy(ray->way, way, sizeof ray->way);
}

/* ---- peaks of a table ---- */

struct node {
    size_t i, j;
    double value;
};

/* Whether no node around is greater, and one of the next polar angles less. */
static bool is_peak(const struct lx_distribution *table, size_t i, size_t j)
{
    const double value = table->values[i * table->polar_count + j];
    bool is_crest = false;
    for (size_t u = i > 0 ? i - 1 : 0; u <= i + 1 && u < table->azimuth_count; u++)
        for (size_t v = j > 0 ? j - 1 : 0; v <= j + 1 && v < table->polar_count; v++) {
            const double other = table->values[u * table->polar_count + v];
            if (other > value)
                return false;
            is_crest = is_crest || (v != j && other < value);
        }
    return is_crest;
}

/* The greatest peaks, the first of equal ones; returns how many. */
static size_t find_peaks(const struct lx_distribution *table, struct node peaks[MOST_PEAKS])
{
    const size_t azimuths = table->table_double.is_axial ? 1 : table->azimuth_count;
    size_t count = 0;
    for (size_t i = 0; i < azimuths; i++)
        for (size_t j = 0; j < table->polar_count; j++) {
            const double value = table->values[i * table->polar_count + j];
            if (!is_peak(table, i, j) || (count == MOST_PEAKS && !(value > peaks[count - 1].value)))
                continue;
            size_t at = count < MOST_PEAKS ? count++ : count - 1;
            for (; at > 0 && value > peaks[at - 1].value; at--)
                peaks[at] = peaks[at - 1];
            peaks[at] = (struct node){i, j, value};
        }
    return count;
}

static void append_peaks(struct gathering *gathering, const struct lx_pointed *pointed, const double from_mm[3])
{
    const struct lx_distribution *table = pointed->distribution;
    const size_t around = table->table_double.is_axial ? AROUND : 1;
    struct node peaks[MOST_PEAKS];
    const size_t count = find_peaks(table, peaks);
    for (size_t k = 0; k < count && k * around < gathering->each; k++)
        for (size_t turn = 0; turn < around; turn++) {
            const double azimuth = table->azimuths[peaks[k].i] * M_PI / 180 + 2 * M_PI * (double)turn / (double)around;
            const double polar = table->polars[peaks[k].j] * M_PI / 180;
            double way[3];
            for (int i = 0; i < 3; i++)
                way[i] = sin(polar) *
                             (cos(azimuth) * pointed->frame_double[0][i] + sin(azimuth) * pointed->frame_double[1][i]) +
                         cos(polar) * pointed->frame_double[2][i];
            append(gathering, from_mm, way);
        }
}

/* ---- of one emitter ---- */

static void append_own(struct gathering *gathering, const struct lx_emitter *emitter, const double downward[3])
{
    const struct lx_profile *profile = &emitter->profile;
    const double *center = lx_emitter_center(emitter);
    double axis[3], end[3];
    lx_values3(profile->axis, axis);
    if (profile->luminaire)
        append_peaks(gathering, profile->luminaire, center);
    else if (!lx_is_extended(emitter) && !lx_profile_is_isotropic(profile))
        append(gathering, center, axis);
    append(gathering, center, downward);
    if (!lx_is_extended(emitter) || !lx_has_axis(emitter)) /* of a ball that is below the middle */
        return;
    lx_emitter_kind(emitter)->farthest(emitter, downward, end);
    append(gathering, end, downward);
}

static void middle_of(const struct lx_prepared_surface *surface, double middle_mm[3])
{
    for (int i = 0; i < 3; i++)
        middle_mm[i] = (surface->low_mm[i] + surface->high_mm[i]) / 2;
}

static void append_shadow(struct gathering *gathering, const struct lx_emitter *emitter,
                          const struct lx_prepared_surface *surface)
{
    double middle[3], way[3];
    middle_of(surface, middle);
    lx_values3(emitter->towards, way);
    for (int i = 0; i < 3; i++)
        way[i] = lx_is_endless(emitter) ? -way[i] : middle[i] - lx_emitter_center(emitter)[i];
    append(gathering, middle, way);
}

/* ---- of all ---- */

static size_t stride_of(size_t count, size_t most)
{
    return count > most ? (count + most - 1) / most : 1;
}

int lx_candidate_rays_make(const struct lx_prepared *prepared, const double downward[3], size_t most,
                           struct lx_candidate_rays *rays)
{
    const size_t emitters = prepared->emitters.count,
                 surfaces = prepared->shadows_on_free ? prepared->surface_count : 0;
    const size_t stride = stride_of(emitters, most), asked = emitters / stride + 1;
    struct gathering gathering = {.rays = rays, .each = most / asked + 1};
    const size_t surface_stride = stride_of(surfaces, gathering.each);
    for (size_t i = 0; i < emitters && !gathering.is_short; i += stride) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&prepared->emitters, i, &room);
        if (lx_is_uniform(emitter) || lx_is_dome(emitter))
            continue;
        if (lx_has_place(emitter))
            append_own(&gathering, emitter, downward);
        if (lx_is_extended(emitter) && !prepared->shadows_extended)
            continue;
        for (size_t s = 0; s < surfaces; s += surface_stride)
            append_shadow(&gathering, emitter, &prepared->surfaces[s]);
    }
    for (size_t s = 0; s < surfaces; s += surface_stride) {
        double middle[3];
        middle_of(&prepared->surfaces[s], middle);
        append(&gathering, middle, downward);
    }
    return gathering.is_short ? -1 : 0;
}

void lx_candidate_rays_clear(struct lx_candidate_rays *rays)
{
    free(rays->items);
    *rays = (struct lx_candidate_rays){0};
}

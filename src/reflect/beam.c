/* SPDX-License-Identifier: MIT */
/* How narrow beams are, and which cells they fall on. */
#include "beam.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/distribution.h"
#include "../light/solid/extended.h"

/* Beams are no wider than this: from a source that is close, even light of all directions falls narrowly. */
static const double HALF = 0.5;
/* Nor narrower: a millimetre at ten metres. */
static const double NARROWEST = 1e-4;
/* A beam ends where a profile is below this share of what it is on the axis. */
static const double SHARE = 0.25;
/* The samples of a cell and its quarters are eight each way: some of them are in a beam of this share of its radius. */
static const double SEEN = 0.5;

/* Peaks of a table that are wider than this show in the first samples. */
static const double PEAK = 0.25;
/* Peaks do not count that give less than this share of what may be missed in all. */
static const double FAINT = 1e-2;

/* Directions around an axis that are looked at; peaks of one luminaire that are followed one by one. */
enum { AROUND = 8, MOST_PEAKS = 256 };

/* The greatest value of a profile at an angle from its axis. */
static double greatest_at(const struct lx_profile *profile, const double axis[3], double angle_rad)
{
    double across[3], upward[3], greatest = 0;
    lx_around_axis(axis, across, upward);
    for (int i = 0; i < AROUND; i++) {
        const double turn = 2 * M_PI * i / AROUND;
        double towards[3];
        for (int k = 0; k < 3; k++)
            towards[k] = -cos(angle_rad) * axis[k] - sin(angle_rad) * (cos(turn) * across[k] + sin(turn) * upward[k]);
        greatest = fmax(greatest, lx_profile_value(profile, lx_exact3(towards)).value);
    }
    return greatest;
}

static double half_angle(const struct lx_profile *profile, const double axis[3])
{
    const double least = SHARE * lx_profile_on_axis(profile);
    double half_rad = HALF;
    while (half_rad > NARROWEST && greatest_at(profile, axis, half_rad) < least)
        half_rad /= 2;
    return half_rad;
}

static void make_beam(const struct lx_emitter *emitter, struct lx_beam *beam)
{
    const struct lx_profile *profile = &emitter->profile;
    *beam = (struct lx_beam){.radius_mm = lx_emitter_radius(emitter), .half_rad = HALF};
    memcpy(beam->place_mm, lx_emitter_center(emitter), sizeof beam->place_mm);
    if (lx_profile_is_isotropic(profile) || (lx_is_extended(emitter) && !profile->luminaire))
        return;
    beam->axis[0] = profile->axis.x.value;
    beam->axis[1] = profile->axis.y.value;
    beam->axis[2] = profile->axis.z.value;
    beam->half_rad = half_angle(profile, beam->axis);
}

/* ---- peaks of a luminaire ---- */

/* The unit direction at two angles of the table, in radians. */
static void direction_at(const struct lx_pointed *pointed, double azimuth, double polar, double direction[3])
{
    for (int k = 0; k < 3; k++)
        direction[k] =
            sin(polar) * (cos(azimuth) * pointed->frame_double[0][k] + sin(azimuth) * pointed->frame_double[1][k]) +
            cos(polar) * pointed->frame_double[2][k];
}

static double value_at(const struct lx_pointed *pointed, double azimuth, double polar)
{
    double direction[3];
    direction_at(pointed, azimuth, polar, direction);
    const double towards[3] = {-direction[0], -direction[1], -direction[2]};
    return lx_pointed_plain(pointed, towards);
}

/* Within how far on both sides of a node the table falls to a share, along the polar angle or across it; PEAK: it is
 * not narrow. */
static double half_width(const struct lx_pointed *pointed, const double node[2], double value, bool is_polar)
{
    const double across = fmax(sin(node[1]), 1e-3);
    for (double half_rad = NARROWEST; half_rad < PEAK; half_rad *= 2) {
        const double azimuth = is_polar ? 0 : half_rad / across, polar = is_polar ? half_rad : 0;
        if (fmax(value_at(pointed, node[0] + azimuth, node[1] + polar),
                 value_at(pointed, node[0] - azimuth, node[1] - polar)) < SHARE * value)
            return half_rad;
    }
    return PEAK;
}

/* The narrow peak at a node of the table, or the ridge on which the node lies; false: there is none. */
static bool find_peak(const struct lx_pointed *pointed, size_t i, size_t j, struct lx_beam *beam)
{
    const struct lx_distribution *table = pointed->distribution;
    const size_t azimuths = table->azimuth_count, polars = table->polar_count;
    const double *value = table->values + i * polars + j, *polar = table->polars + j;
    const double node[2] = {table->azimuths[i] * M_PI / 180, *polar * M_PI / 180};
    const bool is_crest = !(j > 0 && value[-1] > *value) && !(j + 1 < polars && value[1] > *value);
    const bool is_spoke = !(i > 0 && *(value - polars) > *value) && !(i + 1 < azimuths && *(value + polars) > *value);
    if (!(*value > 0))
        return false;
    const double along = is_crest ? half_width(pointed, node, *value, true) : PEAK;
    const double across = is_spoke ? half_width(pointed, node, *value, false) : PEAK;
    direction_at(pointed, node[0], node[1], beam->axis);
    beam->half_rad = fmin(along, across);
    if (across < PEAK) { /* along a meridian as far as to the next lines */
        const double steps = fmax(j > 0 ? polar[0] - polar[-1] : 0, j + 1 < polars ? polar[1] - polar[0] : 0);
        beam->around_rad = along < PEAK ? fmax(along, across) : steps * M_PI / 180;
    } else if (along < PEAK) {
        memcpy(beam->axis, pointed->frame_double[2], sizeof beam->axis);
        beam->ring_rad = node[1];
    }
    return beam->half_rad < PEAK;
}

/* Whether one of the beams from `first` on has all of another one. */
static bool is_followed(const struct lx_beams *beams, size_t first, const struct lx_beam *other)
{
    for (size_t i = first; i < beams->count; i++) {
        const struct lx_beam *beam = &beams->items[i];
        if (beam->half_rad <= 2 * other->half_rad && beam->around_rad >= other->around_rad &&
            (beam->ring_rad > 0) == (other->ring_rad > 0) && fabs(beam->ring_rad - other->ring_rad) <= beam->half_rad &&
            lx_dot(beam->axis, other->axis) >= cos(beam->half_rad))
            return true;
    }
    return false;
}

/* Adds beams at narrow peaks of a table; where these are too many, one that may be anywhere.  0, or -1. */
static int add_peaks(const struct lx_emitter *emitter, double share, struct lx_beams *beams)
{
    const struct lx_pointed *pointed = emitter->profile.luminaire;
    const struct lx_distribution *table = pointed->distribution;
    const double least = FAINT * share * table->solid_angle;
    const size_t first = beams->count;
    struct lx_beam whole = beams->items[first - 1];
    whole.half_rad = PEAK;
    for (size_t node = 0; node < table->azimuth_count * table->polar_count; node++) {
        struct lx_beam beam = beams->items[first - 1];
        if (!find_peak(pointed, node / table->polar_count, node % table->polar_count, &beam) ||
            !(table->values[node] * beam.half_rad * beam.half_rad > least))
            continue;
        whole.half_rad = fmin(whole.half_rad, beam.half_rad);
        if (beams->count - first >= MOST_PEAKS || is_followed(beams, first, &beam))
            continue;
        if (lx_reserve(&beams->items, &beams->capacity, beams->count + 1, sizeof *beams->items))
            return -1;
        beams->items[beams->count++] = beam;
    }
    if (beams->count - first < MOST_PEAKS)
        return 0;
    whole.around_rad = M_PI;
    beams->items[first] = whole;
    beams->count = first + 1;
    return 0;
}

int lx_beams_make(const struct lx_emitters *emitters, double share, struct lx_beams *beams)
{
    const size_t count = lx_item_count(emitters);
    *beams = (struct lx_beams){0};
    for (size_t i = 0; i < count; i++) {
        const struct lx_emitter *emitter = &emitters->items[i];
        if (!lx_has_place(emitter))
            continue;
        if (lx_reserve(&beams->items, &beams->capacity, beams->count + 1, sizeof *beams->items))
            return -1;
        make_beam(emitter, &beams->items[beams->count++]);
        if (emitter->profile.luminaire && add_peaks(emitter, share, beams))
            return -1;
    }
    return 0;
}

void lx_beams_clear(struct lx_beams *beams)
{
    free(beams->items);
    *beams = (struct lx_beams){0};
}

/* Twice the half angle is where a beam has its skirts, too; a source of some size has no smaller spot than itself. */
static bool is_narrow(const struct lx_beam *beam, const struct lx_tile_cell *cell)
{
    double to[3];
    for (int i = 0; i < 3; i++)
        to[i] = cell->center_mm[i] - beam->place_mm[i];
    const double away = lx_normalize(to);
    const double across = cell->radius_mm + beam->radius_mm;
    if (SEEN * cell->radius_mm <= (away + beam->radius_mm) * sin(beam->half_rad))
        return false;
    if (away <= across)
        return true;
    const double off = acos(fmax(-1, fmin(1, lx_dot(to, beam->axis))));
    return beam->half_rad >= HALF ||
           fabs(off - beam->ring_rad) <= beam->around_rad + 2 * beam->half_rad + asin(across / away);
}

bool lx_beams_narrow(const struct lx_beams *beams, const struct lx_tile_cell *cell)
{
    for (size_t i = 0; i < beams->count; i++)
        if (is_narrow(&beams->items[i], cell))
            return true;
    return false;
}

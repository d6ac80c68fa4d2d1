/* SPDX-License-Identifier: MIT */
/* How narrow beams are, and which cells they fall on. */
#include "beam.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/extended.h"

/* Beams are no wider than this: from a source that is close, even light of all directions falls narrowly. */
static const double HALF = 0.5;
/* Nor narrower: a millimetre at ten metres. */
static const double NARROWEST = 1e-4;
/* A beam ends where a profile is below this share of what it is on the axis. */
static const double SHARE = 0.25;
/* The samples of a cell and its quarters are eight each way: some of them are in a beam of this share of its radius. */
static const double SEEN = 0.5;

/* A cone that falls off over a greater share of its angle has no edge. */
static const double SOFT = 0.3;

enum { AROUND = 8 };

/* The greatest value of a profile at an angle from its axis. */
static double greatest_at(const struct lx_profile *profile, const double axis[3], double angle_rad)
{
    const bool is_along_x = fabs(axis[0]) > 0.7;
    const double unit[3] = {is_along_x ? 0.0 : 1.0, is_along_x ? 1.0 : 0.0, 0};
    double across[3], upward[3], greatest = 0;
    lx_cross(axis, unit, across);
    lx_normalize(across);
    lx_cross(axis, across, upward);
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
    const double inner_rad = profile->inner_rad.value, outer_rad = profile->outer_rad.value;
    if (!profile->luminaire && profile->falloff != LX_NO_CONE && outer_rad - inner_rad < SOFT * outer_rad)
        beam->edge_rad = (inner_rad + outer_rad) / 2;
}

/*
 * A cell beside a disk of radius 1 misses a segment of it between its border and its first samples, which are 1/16 of
 * its side away: of height h, the segment is 4/3 sqrt(2) h^(3/2) / pi of the disk.
 */
static double radius_at_edge(double share)
{
    const double height = pow(share * 3 * M_PI / (4 * M_SQRT2), 2.0 / 3);
    return fmin(0.5, 16 * height / M_SQRT2);
}

int lx_beams_make(const struct lx_emitters *emitters, double share, struct lx_beams *beams)
{
    const size_t count = lx_item_count(emitters);
    *beams = (struct lx_beams){.items = lx_new_array(count, sizeof *beams->items), .at_edge = radius_at_edge(share)};
    if (!beams->items)
        return count > 0 ? -1 : 0;
    for (size_t i = 0; i < count; i++) {
        const struct lx_emitter *emitter = &emitters->items[i];
        if (emitter->type != LX_UNIFORM && emitter->type != LX_DIRECTION)
            make_beam(emitter, &beams->items[beams->count++]);
    }
    return 0;
}

void lx_beams_clear(struct lx_beams *beams)
{
    free(beams->items);
    *beams = (struct lx_beams){0};
}

/* Twice the half angle is where a beam has its skirts, too; a source of some size has no smaller spot than itself. */
static bool is_narrow(const struct lx_beam *beam, double at_edge, const struct lx_tile_cell *cell)
{
    double to[3];
    for (int i = 0; i < 3; i++)
        to[i] = cell->center_mm[i] - beam->place_mm[i];
    const double away = lx_normalize(to);
    const double across = cell->radius_mm + beam->radius_mm;
    const bool is_wide = SEEN * cell->radius_mm > (away + beam->radius_mm) * sin(beam->half_rad);
    const bool has_edge = beam->edge_rad > 0 && cell->radius_mm > at_edge * away * sin(beam->edge_rad);
    if ((is_wide && beam->half_rad >= HALF) || (away <= across && (is_wide || has_edge)))
        return true;
    if (!is_wide && !has_edge)
        return false;
    const double off = acos(fmax(-1, fmin(1, lx_dot(to, beam->axis)))), width = asin(across / away);
    return (is_wide && off <= 2 * beam->half_rad + width) || (has_edge && fabs(off - beam->edge_rad) <= width);
}

bool lx_beams_narrow(const struct lx_beams *beams, const struct lx_tile_cell *cell)
{
    for (size_t i = 0; i < beams->count; i++)
        if (is_narrow(&beams->items[i], beams->at_edge, cell))
            return true;
    return false;
}

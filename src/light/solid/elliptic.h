/* SPDX-License-Identifier: MIT */
/*
 * Luminous openings that are not round, as files declare them: ellipses (LX_DISK), right cylinders over ellipses
 * (LX_CYLINDER) and ellipsoids (LX_BALL).  Their half axes lie along the directions of their luminaire; `radius_mm` is
 * the longest of them, so that what asks for no more than a bound sees the round shape around.
 */
#ifndef LX_LIGHT_ELLIPTIC_H
#define LX_LIGHT_ELLIPTIC_H

#include "../emitter.h"

static inline bool lx_is_elliptic(const struct lx_emitter *emitter)
{
    return emitter->radii_mm[0] + emitter->radii_mm[1] + emitter->radii_mm[2] > 0;
}

/* The unit directions of radii_mm: c0, across and the axis of the luminaire. */
void lx_elliptic_ways(const struct lx_emitter *emitter, double ways[3][3]);

/* Half axes of the ellipse that a disk is, or a cylinder has as its cross section, round ones included. */
void lx_half_axes(const struct lx_emitter *emitter, double first[3], double second[3]);

/* How far the directions may be off. */
double lx_elliptic_error(const struct lx_emitter *emitter);

/* As lx_extended_area_mm2(), and lx_extended_touches(), which within an ellipsoid is true. */
lx_bounded lx_elliptic_area_mm2(const struct lx_emitter *emitter);
bool lx_elliptic_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm);

#endif

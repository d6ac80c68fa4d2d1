/* SPDX-License-Identifier: MIT */
/*
 * Measures: what a place receives as a mean over the surface of a small body there, in place of a plane.  Light that
 * makes E_perp from the unit direction L counts E_perp f(L), f by the axis A and the direction faced, F, perpendicular
 * to it:
 *
 *     cylindrical |A x L|/pi,   semicylindrical (|A x L| + F.L)/pi,   spherical 1/4,   hemispherical (1 + A.L)/4
 *
 * (EN 12665; DIN 5031).  A measure is a lobe, the highlight of an element with the normal A and the view F, or A where
 * nothing is faced: so all that lights elements knows it.
 */
#ifndef LX_MATERIAL_MEASURE_H
#define LX_MATERIAL_MEASURE_H

#include "lobe.h"

enum lx_measure {
    LX_MEASURE_PLANE, /* max(0, A.L): the irradiance, no measure of these */
    LX_MEASURE_CYLINDRICAL,
    LX_MEASURE_SEMICYLINDRICAL,
    LX_MEASURE_SPHERICAL,
    LX_MEASURE_HEMISPHERICAL,
};

/* Their names in scenes, in this order, and NULL. */
extern const char *const lx_measure_names[];

/* The lobe; `above`: of light from above the plane that A is the normal of alone, as places on a surface receive. */
struct lx_lobe lx_lobe_of_measure(enum lx_measure measure, bool above);

/* A measure of light that surfaces send: its axis, unit, and what is in the place of the view. */
struct lx_response {
    enum lx_measure measure;
    double axis[3], view[3];
};

/* f times the length of the way to where the light comes from. */
double lx_response_along(const struct lx_response *response, const double way[3]);
/* The greatest f. */
double lx_response_most(const struct lx_response *response);

#endif

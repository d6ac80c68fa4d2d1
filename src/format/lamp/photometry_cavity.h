/* SPDX-License-Identifier: MIT */
/* The room of tabular methods: floor, walls and ceiling, each evenly lit, that reflect light to each other. */
#ifndef LX_FORMAT_PHOTOMETRY_CAVITY_H
#define LX_FORMAT_PHOTOMETRY_CAVITY_H

enum { LX_FLOOR, LX_WALLS, LX_CEILING, LX_CAVITY_PARTS };

/*
 * The illuminance of each part of a room that is x by y wide and 1 high, from the flux that first falls on each, with
 * all that they reflect to each other, by their form factors.
 */
void lx_cavity_light(double x, double y, const double flux[LX_CAVITY_PARTS], const double reflectance[LX_CAVITY_PARTS],
                     double light[LX_CAVITY_PARTS]);

#endif

/* SPDX-License-Identifier: MIT */
/* The directional albedo of a material. */
#ifndef LX_WORLD_ALBEDO_H
#define LX_WORLD_ALBEDO_H

#include "../material/material.h"

/*
 * What a material reflects towards a view, at the angle to the normal with this cosine, of light that comes from all
 * sides above the horizon alike, as a share of that; divided by pi whether or not the material says so.  By closed
 * forms, or to ten digits.  NaN: the view is not above the horizon.
 */
double lx_material_albedo(const struct lx_material *material, double n_dot_v);

#endif

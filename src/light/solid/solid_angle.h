/* SPDX-License-Identifier: MIT */
/* The solid angle that a profile is worth: its integral over all directions, by which flux and intensity differ. */
#ifndef LX_LIGHT_SOLID_ANGLE_H
#define LX_LIGHT_SOLID_ANGLE_H

#include "../emitter.h"

/* The integral of g over the sphere, in sr, to LX_SOLID_ANGLE_ERROR of it. */
double lx_profile_solid_angle(const struct lx_profile *profile);

#define LX_SOLID_ANGLE_ERROR 1e-13

#endif

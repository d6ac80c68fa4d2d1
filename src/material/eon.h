/* SPDX-License-Identifier: MIT */
/* The part of EON that is not proportional to the reflectance. */
#ifndef LX_MATERIAL_EON_H
#define LX_MATERIAL_EON_H

/* The factor of multiple scattering beside A_F (1 + r q), for the reflectance rho: in D it is times (1/2 - 2/(3 pi) -
 * G/pi) of N.L and of N.V each. */
double lx_eon_multiple(double roughness, double rho);

#endif

/* SPDX-License-Identifier: MIT */
/* The search for an extremum that needs nothing of surfaces but their values. */
#ifndef LX_FIELD_EXTREMA_PLAIN_H
#define LX_FIELD_EXTREMA_PLAIN_H

#include "extrema.h"

/* Finds the extremum of a hunt from its picture; *peak must not exist. */
void lx_hunt_plainly(struct lx_hunt *hunt, const luxel_field *field, luxel_peak *peak);

#endif

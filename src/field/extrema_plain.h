/* SPDX-License-Identifier: MIT */
/* The search for an extremum that needs nothing of surfaces but their values. */
#ifndef LX_FIELD_EXTREMA_PLAIN_H
#define LX_FIELD_EXTREMA_PLAIN_H

#include "extrema.h"

/* Finds the extremum of a search from its picture; *peak must not exist. */
void lx_search_plainly(struct lx_extremum_search *search, const luxel_field *field, luxel_peak *peak);

#endif

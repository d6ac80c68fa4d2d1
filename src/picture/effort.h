/* SPDX-License-Identifier: MIT */
/*
 * How much work a picture is, roughly and rather too little than too much: for choosing how many threads are worth
 * their beginning, and for nothing that a value depends on.
 */
#ifndef LX_PICTURE_EFFORT_H
#define LX_PICTURE_EFFORT_H

#include "plan.h"

/* About how long one thread of a quick machine takes for a pixel, in ns. */
double lx_effort_of_pixel_ns(const struct lx_plan *plan);

#endif

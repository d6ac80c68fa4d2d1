/* SPDX-License-Identifier: MIT */
/* One surface element: what light falls on, wherever it was asked for. */
#ifndef LX_WORLD_ELEMENT_H
#define LX_WORLD_ELEMENT_H

#include <stdbool.h>

#include "../base/bounded.h"

struct lx_lobe;
struct lx_prepared_surface;

struct lx_element {
    lx_bounded3 place_mm, normal, view;
    const struct lx_lobe *lobe;
    const struct lx_prepared_surface *own; /* the surface that it lies on, NULL: none */
    bool is_free;                          /* it was asked for by its place: its normal need not be its surface's */
};

#endif

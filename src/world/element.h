/* SPDX-License-Identifier: MIT */
/* One surface element: what light falls on, wherever it was asked for. */
#ifndef LX_WORLD_ELEMENT_H
#define LX_WORLD_ELEMENT_H

#include <stdbool.h>

#include "../base/bounded.h"

struct lx_lobe;
struct lx_prepared_surface;

/* What an element is to whoever asked for it: itself, or what a mirror shows of it (mirrors.h). */
enum lx_shown {
    LX_SHOWN,        /* all of its light */
    LX_SHOWN_BEYOND, /* it is seen by more mirrors than are counted: what it has is in the bound alone */
    LX_SHOWN_NOTHING, /* a mirror, in which nothing is seen */
    LX_SHOWN_UNKNOWN  /* a mirror, in which nobody knows what is seen */
};

struct lx_open_dome; /* world/reference.h */

struct lx_element {
    lx_bounded3 place_mm, normal, view;
    const struct lx_lobe *lobe;
    const struct lx_prepared_surface *own; /* the surface that it lies on, NULL: none */
    bool is_free;                          /* it was asked for by its place: its normal need not be its surface's */
    enum lx_shown shown;
    unsigned mirrors; /* over how many it is seen */
    struct lx_open_dome *open_dome; /* of one thread, for elements that it asks one after another; NULL: none */
};

#endif

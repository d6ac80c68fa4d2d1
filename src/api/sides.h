/* SPDX-License-Identifier: MIT */
/* The names of the sides of surfaces, for whoever tells numbers of each. */
#ifndef LX_API_SIDES_H
#define LX_API_SIDES_H

#include <luxel/balance.h>

#include "../world/prepared.h"

struct lx_named_side {
    size_t surface;           /* as an index in the scene */
    const char *surface_name; /* the caller's, NULL where it has none */
    unsigned part;
    const char *part_name;
    luxel_surface_side side;
};

/* The side of a prepared surface that its normal leaves behind, or not; 0, or -1 when memory ran out. */
int lx_side_name(const struct lx_prepared *prepared, size_t surface, bool is_flat, bool is_back,
                 struct lx_named_side *named);

#endif

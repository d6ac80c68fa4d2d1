/* SPDX-License-Identifier: MIT */
/*
 * How a run of elements sees a cell of an extended source: how much light it may give at most, whether it is too large
 * for a rule of Gauss, and what no rule may see of it.
 */
#ifndef LX_PICTURE_SIGHT_H
#define LX_PICTURE_SIGHT_H

#include "../material/lobe.h"
#include "patch.h"

/* One source for a lobe. */
struct lx_sampled {
    const struct lx_emitter *emitter;
    const struct lx_area_light *lamp; /* of it */
    enum lx_attenuation law;
    bool in_double;
};

/* A run of LX_LANES elements, and what samples are summed for: a lobe without its diffuse part. */
struct lx_receivers {
    const struct lx_block_double *block;
    size_t start;
    const struct lx_lobe_double *lobe;
    const struct lx_power_lobe *power; /* of it */
    struct lx_lobe_at at[LX_LANES];
    double width[LX_LANES]; /* of the lobe, as an angle of L */
};

void lx_receivers_find(const struct lx_block_double *block, size_t start, const struct lx_lobe_double *lobe,
                       struct lx_receivers *receivers);

struct lx_sight {
    double bound;           /* no element gets more light from the cell */
    bool is_wide;           /* too large for the rule of Gauss */
    bool is_tiny;           /* so small that one sample may do */
    double doubt[LX_LANES]; /* light that may stand where neither the cell nor its quarters have a sample */
};

/* What an element sees of less than `hardly` matters neither for the size nor for the doubt. */
void lx_see(const struct lx_receivers *receivers, const struct lx_sampled *source, const struct lx_patch *patch,
            const struct lx_cell *cell, double hardly, struct lx_sight *sight);

#endif

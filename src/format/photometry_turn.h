/* SPDX-License-Identifier: MIT */
/* A luminaire's table of type A or B as one of type C. */
#ifndef LX_FORMAT_PHOTOMETRY_TURN_H
#define LX_FORMAT_PHOTOMETRY_TURN_H

#include <stdbool.h>

#include <luxel/photometry.h>

/* The luminaire with another table; all else is that of the one it was made of, which must live as long. */
struct lx_turned {
    luxel_photometry shown;
    double *planes, *angles, *intensities;
    /* The greatest difference between both tables, by the greatest intensity, in the directions of either and in the
     * middles between them. */
    double off;
};

/* False: no memory.  lx_turned_clear() is due in any case. */
bool lx_turn_to_c(const luxel_photometry *photometry, struct lx_turned *turned);
void lx_turned_clear(struct lx_turned *turned);

#endif

/* SPDX-License-Identifier: MIT */
/* Where a number lies among rising ones. */
#ifndef LX_BASE_SEARCH_H
#define LX_BASE_SEARCH_H

#include <stddef.h>

/* The cell of two or more rising lines that a number is in, from 0 on; the outermost ones go on. */
static inline size_t lx_cell_among(const double *lines, size_t count, double at)
{
    size_t low = 0, high = count - 1;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (lines[middle] <= at)
            low = middle;
        else
            high = middle;
    }
    return low;
}

#endif

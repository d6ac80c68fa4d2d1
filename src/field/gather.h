/* SPDX-License-Identifier: MIT */
/* The values of a region's pixels as one array, for what must look at all of them. */
#ifndef LX_FIELD_GATHER_H
#define LX_FIELD_GATHER_H

#include <luxel/statistics.h>

#include "field.h"

struct lx_gathered {
    double *values;
    size_t count;
    size_t least, greatest; /* indices among all pixels of the first least and the first greatest; 0 without any */
};

/*
 * Gathers the pixels that show a surface in the region, in row order; free the values with free().
 * LUXEL_ERROR_ARGUMENT: the region does not go, the field does not know its places, or a value is not finite.
 * LUXEL_ERROR_MEMORY.
 */
luxel_status lx_gather_region(const struct luxel_field *field, const luxel_region *region,
                              luxel_diagnostics *diagnostics, struct lx_gathered *gathered);

/* Reports that the field does not know its places; returns LUXEL_ERROR_ARGUMENT. */
luxel_status lx_no_places(luxel_diagnostics *diagnostics);

/* Reports the pixel whose value is infinite or no number; returns LUXEL_ERROR_ARGUMENT. */
luxel_status lx_not_finite(const struct luxel_field *field, size_t pixel, luxel_diagnostics *diagnostics);

/* The value of the k-th place if they were in rising order; changes their order. */
double lx_select(double *values, size_t count, size_t k);

/* A pixel of the field as an extremum. */
luxel_extremum lx_extremum_at(const struct luxel_field *field, size_t pixel, double value);

#endif

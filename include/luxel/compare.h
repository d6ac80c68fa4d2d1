/* SPDX-License-Identifier: MIT */
/* Comparing two pictures: how far their values are apart, and where. */
#ifndef LUXEL_COMPARE_H
#define LUXEL_COMPARE_H

#include <luxel/field.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Differences are those of B from A: b - a.  They are taken over the pixels that show a surface in both; of a field
 * read from a file that does not tell which do, those of the other one count.
 */
typedef struct luxel_comparison {
    size_t pixels;           /* that show a surface in both; without any the numbers below are 0 */
    size_t only_a;           /* pixels that show a surface in A alone */
    size_t only_b;           /* pixels that show a surface in B alone */
    luxel_extremum largest;  /* the largest |b - a|; its value is that magnitude; ties: first in row order */
    double a;                /* the value of A there */
    double b;                /* the value of B there */
    double mean;             /* of b - a */
    double mean_magnitude;   /* of |b - a| */
    double rms;              /* root of the mean square of b - a */
    double scale;            /* the largest |a| or |b| */
    double largest_relative; /* largest / scale; 0 where scale is 0 */
    double rms_relative;     /* rms / scale; 0 where scale is 0 */
    void *reserved[4];       /* for later versions: NULL */
} luxel_comparison;

/*
 * Compares two pictures.  `difference` NULL, or takes a field of the values b - a, 0 where one of them shows no
 * surface, of single precision if both are; it is the caller's.
 * LUXEL_ERROR_ARGUMENT: they differ in their resolution, or in the places of their pixels.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_compare(const luxel_field *a, const luxel_field *b, luxel_diagnostics *diagnostics,
                                     luxel_comparison *comparison, luxel_field **difference);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: MIT */
/*
 * Statistics of a picture or of a part of it: extrema, mean, median, spread, how evenly it is lit, and the histogram.
 *
 * They are taken over the pixels that show a surface and whose sample lies in the region, its edge included.
 */
#ifndef LUXEL_STATISTICS_H
#define LUXEL_STATISTICS_H

#include <luxel/field.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The shape of a region. */
typedef enum luxel_region_type {
    LUXEL_REGION_ALL,       /* the whole picture */
    LUXEL_REGION_RECTANGLE, /* with sides along x and y */
    LUXEL_REGION_CIRCLE
} luxel_region_type;

/* A part of the screen. */
typedef struct luxel_region {
    luxel_region_type type; /* its shape */
    double center_mm[2];    /* of rectangle and circle */
    double size_mm[2];      /* of the rectangle: width and height, above 0 */
    double radius_mm;       /* of the circle, above 0 */
    void *reserved[4];      /* for later versions: NULL */
} luxel_region;

/* Whether a point of the screen lies in the region; NULL is the whole. */
LUXEL_API bool luxel_region_holds(const luxel_region *region, double x_mm, double y_mm);

/* What is read off the pixels of a region.  Without any pixel all but `pixels` is 0. */
typedef struct luxel_summary {
    size_t pixels;             /* on a surface, in the region */
    luxel_extremum maximum;    /* ties: first in row order */
    luxel_extremum minimum;    /* the least of all values, 0 and below included; ties: first in row order */
    double mean;               /* the plain mean */
    double median;             /* the middle value, or the mean of the two in the middle */
    double standard_deviation; /* of the pixels themselves: the root of the mean square distance from the mean */
    double lit;                /* share of the pixels from 1.2e-38 up */
    bool has_evenness;         /* whether the mean is above 0 and no value below; else the next two are 0 */
    double u0;                 /* minimum / mean, the uniformity U0 (EN 12665) */
    double ud;                 /* minimum / maximum, the diversity Ud */
    void *reserved[4];         /* for later versions: NULL */
} luxel_summary;

/*
 * Reads the summary off a field.  `region` NULL: the whole picture.
 * LUXEL_ERROR_ARGUMENT: the region is not finite or of no size, or the field does not know its places.
 * LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_field_summary(const luxel_field *field, const luxel_region *region,
                                           luxel_diagnostics *diagnostics, luxel_summary *summary);

/* Equal steps of the histogram in the value, or in its logarithm. */
typedef enum luxel_histogram_scale { LUXEL_HISTOGRAM_LINEAR, LUXEL_HISTOGRAM_LOGARITHMIC } luxel_histogram_scale;

/* How many pixels have values from where to where.  Its arrays live as long as it does. */
typedef struct luxel_histogram {
    luxel_histogram_scale scale; /* of the steps */
    size_t bins;                 /* how many */
    const double *edges;         /* bins + 1, rising: a bin takes in its lower edge, the last its upper one too */
    const size_t *counts;        /* bins */
    size_t below;                /* pixels under the lowest edge */
    size_t above;                /* pixels over the highest edge */
    size_t pixels;               /* all of them */
} luxel_histogram;

/*
 * Counts the pixels of a region.  `low` and `high` NaN: the range is from the least value (logarithmic: the least above
 * 0) to the greatest.  A range of no size is widened.  `bins` from 1 to 65536.
 * The histogram is the caller's: free it with luxel_histogram_free().
 * LUXEL_ERROR_ARGUMENT: as above, low >= high, a logarithmic range that does not begin above 0, a number of bins that
 * does not go, or no pixel from which a range could be taken.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_field_histogram(const luxel_field *field, const luxel_region *region,
                                             luxel_histogram_scale scale, double low, double high, size_t bins,
                                             luxel_diagnostics *diagnostics, luxel_histogram **histogram);

/* Frees a histogram; NULL is harmless. */
LUXEL_API void luxel_histogram_free(luxel_histogram *histogram);

#ifdef __cplusplus
}
#endif
#endif

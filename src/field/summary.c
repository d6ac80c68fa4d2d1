/* SPDX-License-Identifier: MIT */
/* The summary of a region: extrema, mean, median, spread, evenness. */
#include <luxel/statistics.h>

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/wide.h"
#include "gather.h"

/* The sum is wide, so that it adds nothing to the error of many pixels. */
static double mean_of(const struct lx_gathered *gathered)
{
    lx_wide sum = lx_wide_of(0);
    for (size_t i = 0; i < gathered->count; i++)
        sum = lx_wide_add(sum, lx_wide_of(gathered->values[i]));
    return lx_wide_value(sum) / (double)gathered->count;
}

static double deviation_of(const struct lx_gathered *gathered, double mean)
{
    /* scaled by the largest, so that no square leaves the range */
    double scale = 0, sum = 0;
    for (size_t i = 0; i < gathered->count; i++)
        scale = fmax(scale, fabs(gathered->values[i] - mean));
    for (size_t i = 0; i < gathered->count && scale > 0; i++) {
        double away = (gathered->values[i] - mean) / scale;
        sum += away * away;
    }
    return scale * sqrt(sum / (double)gathered->count);
}

/* The middle of an even number of values is the mean of two. */
static double median_of(struct lx_gathered *gathered)
{
    size_t half = gathered->count / 2;
    double upper = lx_select(gathered->values, gathered->count, half), lower = gathered->values[0];
    if (gathered->count % 2 == 1)
        return upper;
    for (size_t i = 1; i < half; i++) /* the selection has left the smaller ones before it */
        lower = fmax(lower, gathered->values[i]);
    return lower + (upper - lower) / 2;
}

luxel_status luxel_field_summary(const luxel_field *field, const luxel_region *region, luxel_diagnostics *diagnostics,
                                 luxel_summary *summary)
{
    struct lx_gathered gathered;
    *summary = (luxel_summary){0};
    luxel_status status = lx_gather_region(field, region, diagnostics, &gathered);
    if (status != LUXEL_OK)
        return status;
    summary->pixels = gathered.count;
    if (gathered.count > 0) {
        size_t lit = 0;
        for (size_t i = 0; i < gathered.count; i++)
            lit += gathered.values[i] >= LX_LEAST_LIT;
        summary->maximum = lx_extremum_at(field, gathered.greatest, lx_field_value(field, gathered.greatest));
        summary->minimum = lx_extremum_at(field, gathered.least, lx_field_value(field, gathered.least));
        summary->lit = (double)lit / (double)gathered.count;
        summary->mean = mean_of(&gathered);
        summary->standard_deviation = deviation_of(&gathered, summary->mean);
        summary->median = median_of(&gathered);
        summary->has_evenness = summary->mean > 0 && summary->minimum.value >= 0; /* a difference may be below 0 */
    }
    if (summary->has_evenness) {
        summary->u0 = summary->minimum.value / summary->mean;
        summary->ud = summary->minimum.value / summary->maximum.value;
    }
    free(gathered.values);
    return LUXEL_OK;
}

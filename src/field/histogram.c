/* SPDX-License-Identifier: MIT */
/* Histograms: how many pixels of a region have values from where to where. */
#include <luxel/statistics.h>

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/search.h"
#include "gather.h"

enum { MOST_BINS = 65536 };

void luxel_histogram_free(luxel_histogram *histogram)
{
    if (!histogram)
        return;
    free((double *)histogram->edges);
    free((size_t *)histogram->counts);
    free(histogram);
}

/* The range of the values themselves, of those above 0 for a logarithmic scale; widened where it has no size. */
static bool find_range(const struct lx_gathered *gathered, luxel_histogram_scale scale, double *low, double *high)
{
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (size_t i = 0; i < gathered->count; i++) {
        double value = gathered->values[i];
        if (scale == LUXEL_HISTOGRAM_LOGARITHMIC && !(value > 0))
            continue;
        *low = fmin(*low, value);
        *high = fmax(*high, value);
    }
    if (!(*low <= *high))
        return false;
    if (*low == *high) {
        double room = *low == 0 ? 1 : 0.5 * fabs(*low);
        *low = scale == LUXEL_HISTOGRAM_LOGARITHMIC ? *low / 2 : *low - room;
        *high += room;
    }
    return true;
}

static void make_edges(luxel_histogram_scale scale, double low, double high, size_t bins, double *edges)
{
    for (size_t i = 0; i <= bins; i++) {
        double share = (double)i / (double)bins;
        edges[i] = scale == LUXEL_HISTOGRAM_LINEAR ? low * (1 - share) + high * share
                                                   : exp(log(low) * (1 - share) + log(high) * share);
    }
    edges[0] = low;
    edges[bins] = high;
}

static luxel_status count(const struct lx_gathered *gathered, luxel_histogram_scale scale, double low, double high,
                          size_t bins, luxel_diagnostics *diagnostics, luxel_histogram **histogram)
{
    luxel_histogram *made = lx_new_array(1, sizeof *made);
    double *edges = lx_new_array(bins + 1, sizeof *edges);
    size_t *counts = lx_new_array(bins, sizeof *counts);
    if (!made || !edges || !counts) {
        free(made);
        free(edges);
        free(counts);
        return lx_out_of_memory(diagnostics);
    }
    *made =
        (luxel_histogram){.scale = scale, .bins = bins, .edges = edges, .counts = counts, .pixels = gathered->count};
    make_edges(scale, low, high, bins, edges);
    for (size_t i = 0; i < gathered->count; i++) {
        double value = gathered->values[i];
        if (value < low)
            made->below++;
        else if (value > high)
            made->above++;
        else
            counts[lx_cell_among(edges, bins + 1, value)]++;
    }
    *histogram = made;
    return LUXEL_OK;
}

luxel_status luxel_field_histogram(const luxel_field *field, const luxel_region *region, luxel_histogram_scale scale,
                                   double low, double high, size_t bins, luxel_diagnostics *diagnostics,
                                   luxel_histogram **histogram)
{
    struct lx_gathered gathered;
    bool automatic = isnan(low) && isnan(high);
    if (bins < 1 || bins > MOST_BINS)
        return lx_refuse(diagnostics, LX_MSG_BAD_BINS, NULL);
    if (!automatic && !(low < high && isfinite(low) && isfinite(high)))
        return lx_refuse(diagnostics, LX_MSG_BAD_RANGE, NULL);
    if (!automatic && scale == LUXEL_HISTOGRAM_LOGARITHMIC && !(low > 0))
        return lx_refuse(diagnostics, LX_MSG_BAD_LOG_RANGE, NULL);
    luxel_status status = lx_gather_region(field, region, diagnostics, &gathered);
    if (status != LUXEL_OK)
        return status;
    if (automatic && !find_range(&gathered, scale, &low, &high))
        status = lx_refuse(diagnostics, LX_MSG_NO_RANGE, NULL);
    else
        status = count(&gathered, scale, low, high, bins, diagnostics, histogram);
    free(gathered.values);
    return status;
}

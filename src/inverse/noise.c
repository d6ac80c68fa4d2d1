/* SPDX-License-Identifier: MIT */
/* How much readings count: noise that is told or estimated, outliers, and readings that are saturated. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "problem.h"

static const double huber = 1.345, tukey = 4.685;      /* 95 of 100 as efficient as squares where noise is normal */
static const double sds_of_median = 1.482602218505602; /* 1 by the third quartile of the normal distribution */
static const double least_share = 1e-3; /* of the greatest reading: of what relative noise is at least a share */

bool lx_noise_is_told(const luxel_readings *readings)
{
    return readings->noise > 0.0 || readings->relative_noise > 0.0;
}

bool lx_is_saturated(const luxel_readings *readings, double value)
{
    return readings->saturated > 0.0 && value >= readings->saturated;
}

static double sd_of(const struct lx_counting *counting, double usual)
{
    const luxel_readings *readings = counting->problem->readings;
    const double relative = readings->relative_noise * fmax(fabs(usual), least_share * counting->problem->greatest);
    return counting->sd > 0.0 ? counting->sd
                              : sqrt(readings->noise * readings->noise + relative * relative +
                                     readings->quantum * readings->quantum / 12.0);
}

/* The normal density by the normal distribution below, at z; -z where both are too small to tell. */
static double mills(double z)
{
    static const double root_of_half = 0.70710678118654752440, root_of_two_by_pi = 0.79788456080286535588;
    return z < -25.0 ? -z + 1.0 / -z : root_of_two_by_pi * exp(-0.5 * z * z) / erfc(-z * root_of_half);
}

/* -2 log of the normal distribution below z. */
static double cost_below(double z)
{
    static const double root_of_half = 0.70710678118654752440, log_of_two_pi = 1.8378770664093454836;
    return z < -25.0 ? z * z + log_of_two_pi + 2.0 * log(-z + 1.0 / -z) : -2.0 * log(0.5 * erfc(-z * root_of_half));
}

/* A reading that says only that the truth is no less: the likelihood of that, in second order. */
static void count_saturated(double z, struct lx_counted *counted)
{
    const double lambda = mills(z), curvature = lambda * (lambda + z);
    counted->is_saturated = true;
    counted->weight = curvature > 1e-300 ? curvature : 0.0;
    counted->residual = counted->weight > 0.0 ? lambda / curvature : 0.0;
    counted->cost = cost_below(z);
}

struct lx_counted lx_count_reading(const struct lx_counting *counting, size_t i, double model, double usual)
{
    const luxel_readings *readings = counting->problem->readings;
    const double value = counting->set->values[i] + (readings->is_truncated ? 0.5 * readings->quantum : 0.0);
    struct lx_counted counted = {.sd = sd_of(counting, usual), .weight = 1.0};
    if (lx_is_saturated(readings, counting->set->values[i])) {
        count_saturated((model - readings->saturated) / counted.sd, &counted);
        return counted;
    }
    const double r = counted.residual = (value - model) / counted.sd, size = fabs(r);
    counted.cost = r * r;
    if (readings->loss == LUXEL_LOSS_HUBER && size > huber) {
        counted.weight = huber / size;
        counted.cost = huber * (2.0 * size - huber);
    } else if (readings->loss == LUXEL_LOSS_TUKEY) {
        const double inside = size < tukey ? 1.0 - size * size / (tukey * tukey) : 0.0;
        counted.weight = inside * inside;
        counted.cost = tukey * tukey / 3.0 * (1.0 - inside * inside * inside);
    }
    return counted;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double lx_estimate_noise(const struct lx_counting *counting, const double *models, size_t unknowns)
{
    const struct lx_fit_problem *problem = counting->problem;
    const struct lx_counting unit = {.problem = problem, .set = counting->set, .sd = 1.0};
    double *sizes = lx_new_array(counting->set->count + 1, sizeof *sizes), square = 0.0;
    size_t count = 0;
    for (size_t i = 0; sizes && i < counting->set->count; i++) {
        if (lx_is_saturated(problem->readings, counting->set->values[i]))
            continue;
        sizes[count] = fabs(lx_count_reading(&unit, i, models[i], models[i]).residual);
        square += sizes[count] * sizes[count];
        count++;
    }
    double sd = count > unknowns ? sqrt(square / (double)(count - unknowns)) : 0.0;
    if (sizes && count > 0 && problem->readings->loss != LUXEL_LOSS_GAUSSIAN) {
        qsort(sizes, count, sizeof *sizes, compare);
        /* as many of the least are 0, or nearly, as there are unknowns */
        const size_t middle = (count + unknowns) / 2;
        sd = sds_of_median * sizes[middle < count ? middle : count - 1];
    }
    free(sizes);
    return fmax(sd, 1e-14 * problem->greatest);
}

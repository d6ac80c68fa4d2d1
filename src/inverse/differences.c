/* SPDX-License-Identifier: MIT */
/* Tableaus of differences, and what they tell of a slope. */
#include "differences.h"

#include <math.h>

enum { FEWEST_ROWS = 4 };

/* How far an entry is from those that it is made of: none of them is farther from the limit, while they converge. */
static double spread(const double *row, const double *above, unsigned j)
{
    double most = fmax(fabs(row[j] - row[j - 1]), fabs(row[j] - above[j - 1]));
    return fmax(most, fabs(row[j - 1] - above[j - 1]) * 0x1p-4);
}

static void add_row(struct lx_tableau *tableau, double value, double noise)
{
    double row[LX_EXTRAPOLATIONS], noises[LX_EXTRAPOLATIONS];
    const unsigned columns = tableau->rows + 1 < LX_EXTRAPOLATIONS ? tableau->rows + 1 : LX_EXTRAPOLATIONS;
    row[0] = value;
    noises[0] = noise;
    double factor = (double)(1u << tableau->first);
    for (unsigned j = 1; j < columns; j++, factor *= (double)(1u << tableau->step)) {
        row[j] = row[j - 1] + (row[j - 1] - tableau->value[j - 1]) / (factor - 1.0);
        noises[j] = (factor * noises[j - 1] + tableau->noise[j - 1]) / (factor - 1.0) + fabs(row[j]) * 0x1p-50;
        const double error = 2.0 * spread(row, tableau->value, j) + noises[j];
        /* a row that is rough says more than one before it that was smooth by chance */
        if (error < tableau->error || tableau->rows == 1) {
            tableau->best = row[j];
            tableau->error = error;
        }
    }
    for (unsigned j = 0; j < columns; j++) {
        tableau->value[j] = row[j];
        tableau->noise[j] = noises[j];
    }
    tableau->rows++;
}

void lx_differences_begin(struct lx_differences *differences, double middle, double error, bool is_one_sided)
{
    const struct lx_tableau slope = {
        .first = is_one_sided ? 1 : 2, .step = is_one_sided ? 1 : 2, .error = (double)INFINITY};
    const struct lx_tableau gap = {.first = 1, .step = 2, .error = (double)INFINITY};
    *differences = (struct lx_differences){.is_one_sided = is_one_sided,
                                           .middle = middle,
                                           .middle_error = error,
                                           .greatest = fabs(middle),
                                           .slope = slope,
                                           .gap = gap};
}

void lx_differences_add(struct lx_differences *differences, double step, const double values[2], const double errors[2])
{
    const double h = fabs(step);
    if (differences->slope.rows == 0)
        differences->first_step = h;
    differences->greatest = fmax(differences->greatest, fabs(values[0]));
    if (differences->is_one_sided) {
        add_row(&differences->slope, (values[0] - differences->middle) / step,
                (errors[0] + differences->middle_error) / h);
        return;
    }
    differences->greatest = fmax(differences->greatest, fabs(values[1]));
    add_row(&differences->slope, (values[0] - values[1]) / (2.0 * h), (errors[0] + errors[1]) / (2.0 * h));
    add_row(&differences->gap, (values[0] - differences->middle + (values[1] - differences->middle)) / h,
            (errors[0] + errors[1] + 2.0 * differences->middle_error) / h);
}

bool lx_differences_are_done(const struct lx_differences *differences)
{
    const struct lx_tableau *slope = &differences->slope, *gap = &differences->gap;
    if (differences->is_missing)
        return true;
    /* values along a line, from side to side, are done at once */
    const bool is_line = !differences->is_one_sided && slope->rows > 1 && fabs(gap->value[0]) <= gap->noise[0];
    /* half the step doubles what the function's errors make of the quotient, and more of what is extrapolated */
    return (is_line || slope->rows >= FEWEST_ROWS) && 2.0 * slope->noise[0] >= slope->error;
}

luxel_derivative lx_differences_conclude(const struct lx_differences *differences)
{
    const struct lx_tableau *slope = &differences->slope, *gap = &differences->gap;
    const double natural = differences->greatest / differences->first_step;
    luxel_derivative derivative = {.state = LUXEL_DERIVATIVE_EXISTS, .value = slope->best, .error = slope->error};
    if (differences->is_missing)
        derivative.state = LUXEL_DERIVATIVE_NO_VALUE;
    else if (!(slope->error <= fmax(0.1 * fabs(slope->best), 0.01 * natural)))
        derivative.state = LUXEL_DERIVATIVE_ROUGH;
    else if (differences->is_one_sided)
        derivative.state = LUXEL_DERIVATIVE_ONE_SIDED;
    else if (fabs(gap->best) > 4.0 * (gap->error + slope->error))
        derivative.state = LUXEL_DERIVATIVE_KINK;
    if (luxel_derivative_words(derivative.state))
        derivative.value = derivative.error = (double)NAN;
    return derivative;
}

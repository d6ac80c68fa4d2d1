/* SPDX-License-Identifier: MIT */
/*
 * Error bars from the derivatives at the end of a search.  The covariance is s² (J'J)⁻¹; with Huber's or Tukey's loss
 * it is that of an M-estimator (Huber 1981, 7.6), s² (sum psi²)/(n - p) by (mean psi')².
 */
#include "conclude.h"

#include <luxel/derive.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/text.h"

static const double least_direction = 1e-8; /* of the best one: what is told less about is not determined */
static const double outlying = 3.5;         /* standard deviations: a reading that is off by more is told */
static const double much = 3.0;             /* a number that may be off by so many of its own size is not determined */
static const double share_of_block = 1e-5;  /* of a direction: numbers with less do not belong to it */
static const double share_of_vague = 0.05;  /* likewise where the direction is only known badly */

char *lx_unknown_name(const struct lx_keys *keys, size_t unknown)
{
    struct lx_text text = {0};
    if (unknown >= keys->number_count) {
        lx_text_puts(&text, "factor");
        return lx_text_take(&text);
    }
    const struct lx_key *key = lx_keys_of(keys, unknown);
    lx_text_puts(&text, key->path);
    if (key->count > 1)
        lx_text_printf(&text, "[%zu]", unknown - key->offset);
    return lx_text_take(&text);
}

/*
 * The point of Student's distribution that 97.5 of 100 are below (Hill 1970, algorithm 396; exact for 1 and 2), which
 * is that of the normal one for many degrees of freedom.
 */
static double student(size_t dof)
{
    static const double pi = 3.14159265358979323846, normal = 1.95996398454005423552, both = 0.05;
    const double n = (double)dof;
    if (dof == 1)
        return 1.0 / tan(both * pi / 2.0);
    if (dof == 2)
        return sqrt(2.0 / (both * (2.0 - both)) - 2.0);
    const double a = 1.0 / (n - 0.5), b = 48.0 / (a * a);
    double c = ((20700.0 * a / b - 98.0) * a - 16.0) * a + 96.36;
    const double d = ((94.5 / (b + c) - 3.0) / b + 1.0) * sqrt(a * pi / 2.0) * n;
    double y = pow(d * both, 2.0 / n);
    if (y > 0.05 + a) {
        const double x = -normal;
        y = x * x;
        if (dof < 5)
            c += 0.3 * (n - 4.5) * (x + 0.6);
        c = (((0.05 * d * x - 5.0) * x - 7.0) * x - 2.0) * x + b + c;
        y = (((((0.4 * y + 6.3) * y + 36.0) * y + 94.5) / c - y - 3.0) / b + 1.0) * x;
        y = expm1(a * y * y);
    } else {
        y = ((1.0 / (((n + 6.0) / (n * y) - 0.089 * d - 0.822) * (n + 2.0) * 3.0) + 0.5 / (n + 4.0)) * y - 1.0) *
                (n + 1.0) / (n + 2.0) +
            1.0 / y;
    }
    return sqrt(n * y);
}

/* The linear problem at the end. */
struct ending {
    struct lx_fit_problem *problem;
    const struct lx_trial *found;
    struct lx_counting counting;
    struct lx_least_squares squares;
    double *rows, *errors, *right, *least; /* least: of each column, what is none */
    double tolerance;                      /* of directions, from what derivatives may be off */
    size_t rank;                           /* of these, and */
    size_t determined;                     /* without those along which a number may be off by much */
    double variance;                       /* of a right side */
};

/* Derivatives per scale of what the scene gives, NaN where there is none, and the squares of their errors by columns;
 * of many readings, of which each counts for little, and of reflected light, which is known to few digits, from the
 * differences that the search takes. */
static luxel_status find_slopes(struct ending *ending, const luxel_scene *fitted)
{
    enum { MANY = 400 };
    struct lx_fit_problem *problem = ending->problem;
    const size_t count = problem->set.count;
    const char **paths = lx_new_array(problem->keys.count + 1, sizeof *paths);
    luxel_derivatives *derivatives = NULL;
    if (!paths)
        return lx_out_of_memory(problem->diagnostics);
    for (size_t i = 0; i < problem->keys.count; i++)
        paths[i] = problem->keys.list[i].path;
    luxel_status status =
        lx_problem_slopes(problem, &problem->set, ending->found->unknowns, ending->found->models, ending->rows);
    ending->tolerance = fmax(10.0 * least_direction, problem->precision / problem->step);
    if (status == LUXEL_OK && count <= MANY && !lx_prober_solves(problem->scene)) {
        ending->tolerance = least_direction;
        status = luxel_derive_places(fitted, &problem->settings, problem->set.places, NULL, count, paths,
                                     problem->keys.count, problem->diagnostics, &derivatives);
    }
    free(paths);
    const double factor = problem->unknowns > problem->numbers ? ending->found->unknowns[problem->numbers] : 1.0;
    for (size_t k = 0; derivatives && k < problem->numbers; k++) {
        const struct lx_key *key = lx_keys_of(&problem->keys, k);
        const size_t index = (size_t)(key - problem->keys.list);
        for (size_t i = 0; i < count; i++) {
            const luxel_derivative *one = luxel_derivatives_get(derivatives, i, index, k - key->offset);
            const bool is_there = luxel_derivative_words(one->state) == NULL;
            ending->rows[k * count + i] = is_there ? one->value * factor * problem->scale[k]
                                          : one->state == LUXEL_DERIVATIVE_NO_VALUE ? 0.0
                                                                                    : (double)NAN;
            ending->errors[k * count + i] = is_there ? one->error * factor * problem->scale[k] : 0.0;
        }
    }
    luxel_derivatives_free(derivatives);
    return status;
}

/* Rows by standard deviations; rows without a derivative become 0.  What columns are none, and how near directions may
 * be to none, from what derivatives may be off. */
static luxel_status fill_rows(struct ending *ending, const luxel_scene *fitted, luxel_fit *fit)
{
    const struct lx_fit_problem *problem = ending->problem;
    const size_t count = problem->set.count, n = problem->unknowns;
    double size = 0.0;
    const luxel_status status = find_slopes(ending, fitted);
    for (size_t i = 0; status == LUXEL_OK && i < count; i++) {
        const double model = ending->found->models[i];
        const struct lx_counted counted = lx_count_reading(&ending->counting, i, model, model);
        const double weight = (counted.is_saturated ? sqrt(counted.weight) : 1.0) / counted.sd;
        bool is_none = false;
        for (size_t k = 0; k < n; k++)
            is_none = is_none || isnan(ending->rows[k * count + i]);
        for (size_t k = 0; k < n; k++) {
            const double error = is_none ? 0.0 : ending->errors[k * count + i] * weight;
            ending->rows[k * count + i] = is_none ? 0.0 : ending->rows[k * count + i] * weight;
            ending->least[k] += error * error;
        }
        fit->without_derivative += is_none;
        size += model / counted.sd * (model / counted.sd);
    }
    for (size_t k = 0; status == LUXEL_OK && k < n; k++) {
        double square = 0.0;
        for (size_t i = 0; i < count; i++)
            square += ending->rows[k * count + i] * ending->rows[k * count + i];
        const double error = sqrt(ending->least[k]);
        ending->least[k] = fmax(2.0 * error, 0.1 * ending->tolerance * sqrt(size));
        if (square > ending->least[k] * ending->least[k])
            ending->tolerance = fmax(ending->tolerance, 4.0 * error / sqrt(square));
    }
    return status;
}

/* What of the public numbers the residuals tell; the variance of right sides. */
static void judge_residuals(struct ending *ending, luxel_fit *fit)
{
    const struct lx_fit_problem *problem = ending->problem;
    const luxel_readings *readings = problem->readings;
    double squares = 0.0, psi_squares = 0.0, slopes = 0.0, noise = 0.0;
    size_t count = 0;
    for (size_t i = 0; i < problem->set.count; i++) {
        const double model = ending->found->models[i];
        const struct lx_counted counted = lx_count_reading(&ending->counting, i, model, model);
        noise += counted.sd * counted.sd;
        if (counted.is_saturated) {
            fit->saturated++;
            continue;
        }
        const double psi = counted.residual * counted.weight, root = sqrt(counted.weight);
        count++;
        squares += counted.residual * counted.residual;
        psi_squares += psi * psi;
        slopes += readings->loss == LUXEL_LOSS_GAUSSIAN ? 1.0
                  : readings->loss == LUXEL_LOSS_HUBER  ? counted.weight >= 1.0
                                                        : root * (5.0 * root - 4.0);
        fit->outliers += readings->loss != LUXEL_LOSS_GAUSSIAN && fabs(counted.residual) > outlying;
    }
    fit->readings = problem->set.count;
    fit->dof = count > ending->determined ? count - ending->determined : 0;
    fit->noise_is_estimated = !lx_noise_is_told(readings);
    fit->noise = sqrt(noise / (double)problem->set.count);
    fit->chi2 = squares;
    ending->variance = 1.0;
    if (readings->loss != LUXEL_LOSS_GAUSSIAN && fit->dof > 0 && slopes > 0.0)
        ending->variance = psi_squares / (double)fit->dof / (slopes / (double)count * (slopes / (double)count));
    if (fit->noise_is_estimated && readings->loss == LUXEL_LOSS_GAUSSIAN) {
        const double by = fit->dof > 0 ? squares / (double)fit->dof : 0.0;
        ending->variance = by;
        fit->noise *= sqrt(by);
        fit->chi2 = (double)fit->dof;
    }
}

/*
 * How many directions are determined at all, by columns of one length, so that an unknown which matters little still
 * counts; and then, by unknowns in their own scales, along how many of them none may be off by much.
 */
static bool find_rank(struct ending *ending)
{
    struct lx_least_squares *squares = &ending->squares;
    const size_t n = squares->columns, count = ending->problem->set.count;
    double *copy = lx_new_array(n * count + 1, sizeof *copy);
    if (!copy)
        return false;
    memcpy(copy, ending->rows, n * count * sizeof *copy);
    lx_least_squares_solve(squares, copy, ending->right, count, ending->least, true);
    free(copy);
    ending->rank = squares->singular[0] > 0.0 ? lx_least_squares_rank(squares, ending->tolerance) : 0;
    lx_least_squares_solve(squares, ending->rows, ending->right, count, ending->least, false);
    while (ending->rank > 0 && !(squares->singular[ending->rank - 1] > 0.0))
        ending->rank--;
    return true;
}

/* Along a direction of length 1 none may be off by more than one by its singular value. */
static void find_determined(struct ending *ending)
{
    const double sd = sqrt(ending->variance);
    ending->determined = ending->rank;
    while (ending->determined > 0 && sd > much * ending->squares.singular[ending->determined - 1])
        ending->determined--;
}

/* What two unknowns have in common of the directions that are not determined. */
static double common(const struct ending *ending, size_t i, size_t j)
{
    const struct lx_least_squares *squares = &ending->squares;
    double sum = 0.0;
    for (size_t k = ending->determined; k < squares->columns; k++)
        sum += squares->v[k * squares->columns + i] * squares->v[k * squares->columns + j];
    return sum;
}

/* Puts all that goes with an unknown into its block. */
static void gather(const struct ending *ending, double least, size_t from, struct lx_conclusion *conclusion)
{
    for (size_t i = 0; i < ending->squares.columns; i++)
        if (conclusion->block[i] == 0 && fabs(common(ending, from, i)) > least * least) {
            conclusion->block[i] = conclusion->blocks;
            gather(ending, least, i, conclusion);
        }
}

static void find_blocks(const struct ending *ending, struct lx_conclusion *conclusion)
{
    const size_t n = ending->squares.columns;
    const double least = ending->rank < n ? share_of_block : share_of_vague;
    for (size_t i = 0; i < n; i++)
        if (conclusion->block[i] == 0 && common(ending, i, i) > least * least) {
            conclusion->block[i] = ++conclusion->blocks;
            gather(ending, least, i, conclusion);
        }
    for (size_t block = 1; block <= conclusion->blocks; block++) {
        double unknown = 0.0;
        size_t size = 0;
        for (size_t i = 0; i < n; i++)
            if (conclusion->block[i] == block) {
                unknown += common(ending, i, i);
                size++;
            }
        conclusion->known[block - 1] = size - (size_t)fmin(round(fmax(unknown, 1.0)), (double)size);
    }
}

static void tell_parameter(const struct ending *ending, const struct lx_conclusion *conclusion, size_t i,
                           const luxel_fit *fit, luxel_fit_parameter *parameter)
{
    const struct lx_fit_problem *problem = ending->problem;
    const double scale = problem->scale[i];
    const double variance =
        ending->variance * lx_least_squares_covariance(&ending->squares, ending->rank, i, i) * scale * scale;
    parameter->is_determined = conclusion->block[i] == 0 && conclusion->several[i] == 0;
    parameter->has_errors = parameter->is_determined && (fit->dof > 0 || !fit->noise_is_estimated);
    parameter->is_at_limit = ending->found->is_at_limit[i];
    parameter->value = parameter->sd = parameter->low = parameter->high = (double)NAN;
    if (parameter->is_determined)
        parameter->value = ending->found->unknowns[i];
    if (parameter->has_errors) {
        const double wide = fit->noise_is_estimated ? student(fit->dof) : student((size_t)1 << 40);
        parameter->sd = sqrt(variance);
        parameter->low = fmax(parameter->value - wide * parameter->sd, problem->low[i]);
        parameter->high = fmin(parameter->value + wide * parameter->sd, problem->high[i]);
    }
}

static void tell_all(const struct ending *ending, const struct lx_conclusion *conclusion, luxel_fit *fit,
                     luxel_fit_parameter *parameters, double *correlation)
{
    const size_t n = ending->problem->unknowns;
    const struct lx_least_squares *squares = &ending->squares;
    for (size_t i = 0; i < n; i++)
        tell_parameter(ending, conclusion, i, fit, &parameters[i]);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            const double both = lx_least_squares_covariance(squares, ending->rank, i, j);
            const double alone = sqrt(lx_least_squares_covariance(squares, ending->rank, i, i) *
                                      lx_least_squares_covariance(squares, ending->rank, j, j));
            const bool has = parameters[i].has_errors && parameters[j].has_errors && alone > 0.0;
            correlation[i * n + j] = has ? i == j ? 1.0 : fmin(fmax(both / alone, -1.0), 1.0) : (double)NAN;
        }
}

luxel_status lx_conclude(struct lx_fit_problem *problem, const struct lx_trial *found, const luxel_scene *fitted,
                         luxel_fit *fit, luxel_fit_parameter *parameters, double *correlation,
                         struct lx_conclusion *conclusion)
{
    const size_t count = problem->set.count, n = problem->unknowns;
    struct ending ending = {.problem = problem,
                            .found = found,
                            .counting = {.problem = problem, .set = &problem->set, .sd = found->sd},
                            .rows = lx_new_array(count * n + 1, sizeof *ending.rows),
                            .errors = lx_new_array(count * n + 1, sizeof *ending.errors),
                            .right = lx_new_array(count + 1, sizeof *ending.right),
                            .least = lx_new_array(n + 1, sizeof *ending.least)};
    luxel_status status =
        lx_least_squares_make(n, &ending.squares) && ending.rows && ending.errors && ending.right && ending.least
            ? fill_rows(&ending, fitted, fit)
            : lx_out_of_memory(problem->diagnostics);
    if (status == LUXEL_OK && !find_rank(&ending))
        status = lx_out_of_memory(problem->diagnostics);
    if (status == LUXEL_OK) {
        ending.determined = ending.rank;
        judge_residuals(&ending, fit);
        find_determined(&ending);
        find_blocks(&ending, conclusion);
        fit->rank = ending.determined;
        tell_all(&ending, conclusion, fit, parameters, correlation);
    }
    lx_least_squares_clear(&ending.squares);
    free(ending.rows);
    free(ending.errors);
    free(ending.right);
    free(ending.least);
    return status;
}

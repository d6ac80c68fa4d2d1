/* SPDX-License-Identifier: MIT */
/* Steps of Levenberg and Marquardt within what is legal. */
#include "search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"

static const double least_direction = 1e-12; /* of the best one: along others no step is taken */
static const double least_step = 3e-13;      /* of the scale: what is nearer has been found */
static const double least_gain = 1e-15;      /* of the cost */

enum { MOST_TRIES = 14 };

bool lx_trial_make(const struct lx_fit_problem *problem, size_t readings, struct lx_trial *found)
{
    *found = (struct lx_trial){.unknowns = lx_new_array(problem->unknowns + 1, sizeof *found->unknowns),
                               .models = lx_new_array(readings + 1, sizeof *found->models),
                               .is_at_limit = lx_new_array(problem->unknowns + 1, sizeof *found->is_at_limit)};
    return found->unknowns && found->models && found->is_at_limit;
}

void lx_trial_clear(struct lx_trial *found)
{
    free(found->unknowns);
    free(found->models);
    free(found->is_at_limit);
    *found = (struct lx_trial){.unknowns = NULL};
}

/* The cost of some values, with the noise of the usual ones. */
static double cost_of(const struct lx_counting *counting, const double *models, const double *usual)
{
    double cost = 0.0;
    for (size_t i = 0; i < counting->set->count; i++)
        cost += lx_count_reading(counting, i, models[i], usual[i]).cost;
    return cost;
}

void lx_weigh_rows(const struct lx_counting *counting, const double *models, const bool *held, double *slopes,
                   double *right)
{
    const size_t count = counting->set->count;
    for (size_t i = 0; i < count; i++) {
        const struct lx_counted counted = lx_count_reading(counting, i, models[i], models[i]);
        const double root = sqrt(counted.weight);
        right[i] = root * counted.residual;
        for (size_t k = 0; k < counting->problem->unknowns; k++)
            slopes[k * count + i] =
                (held && held[k]) || isnan(slopes[k * count + i]) ? 0.0 : slopes[k * count + i] * root / counted.sd;
    }
}

/* What a search works with. */
struct search {
    struct lx_fit_problem *problem;
    const struct lx_reading_set *set;
    struct lx_trial *found;
    struct lx_counting counting;
    struct lx_least_squares squares;
    double *slopes, *rows, *right, *step, *tried, *models;
    double damping;
};

static bool make_room(struct search *search)
{
    const size_t unknowns = search->problem->unknowns, count = search->set->count, rows = count * unknowns + 1;
    search->slopes = lx_new_array(rows, sizeof *search->slopes);
    search->rows = lx_new_array(rows, sizeof *search->rows);
    search->right = lx_new_array(count + 1, sizeof *search->right);
    search->models = lx_new_array(count + 1, sizeof *search->models);
    search->step = lx_new_array(unknowns + 1, sizeof *search->step);
    search->tried = lx_new_array(unknowns + 1, sizeof *search->tried);
    return lx_least_squares_make(unknowns, &search->squares) && search->slopes && search->rows && search->right &&
           search->models && search->step && search->tried;
}

static void free_room(struct search *search)
{
    lx_least_squares_clear(&search->squares);
    free(search->slopes);
    free(search->rows);
    free(search->right);
    free(search->models);
    free(search->step);
    free(search->tried);
}

/* Solves the linear problem with what is held at the ends of what is legal. */
static void solve(struct search *search)
{
    const size_t count = search->set->count;
    memcpy(search->rows, search->slopes, count * search->problem->unknowns * sizeof *search->rows);
    lx_weigh_rows(&search->counting, search->found->models, search->found->is_at_limit, search->rows, search->right);
    lx_least_squares_solve(&search->squares, search->rows, search->right, count, NULL, true);
}

/* Holds what stands at an end and would go beyond; false: there is nothing more to hold. */
static bool hold_ends(struct search *search)
{
    const struct lx_fit_problem *problem = search->problem;
    bool is_more = false;
    lx_least_squares_step(&search->squares, 0.0, least_direction, search->step);
    for (size_t k = 0; k < problem->unknowns; k++) {
        const double at = search->found->unknowns[k];
        const bool is_out =
            (at <= problem->low[k] && search->step[k] < 0.0) || (at >= problem->high[k] && search->step[k] > 0.0);
        is_more = is_more || (is_out && !search->found->is_at_limit[k]);
        search->found->is_at_limit[k] = search->found->is_at_limit[k] || is_out;
    }
    return is_more;
}

/* Where a step leads: at most nine tenths of the way to an end, unless it is near; its length in scales. */
static double take_step(struct search *search)
{
    const struct lx_fit_problem *problem = search->problem;
    double length = 0.0;
    lx_least_squares_step(&search->squares, search->damping, least_direction, search->step);
    for (size_t k = 0; k < problem->unknowns; k++) {
        const double at = search->found->unknowns[k], wanted = at + search->step[k] * problem->scale[k];
        const double low = problem->low[k], high = problem->high[k], near = 1e-9 * problem->scale[k];
        double to = wanted;
        if (wanted <= low)
            to = at - low < near ? low : low + 0.1 * (at - low);
        if (wanted >= high)
            to = high - at < near ? high : high - 0.1 * (high - at);
        search->tried[k] = to;
        length = fmax(length, fabs(to - at) / problem->scale[k]);
    }
    return length;
}

/* Tries steps, each time shorter, until one leads down. */
static luxel_status go_down(struct search *search)
{
    struct lx_trial *found = search->found;
    const size_t unknowns = search->problem->unknowns, count = search->set->count;
    const double nearest = fmax(least_step, search->problem->precision);
    const double gain = fmax(least_gain, search->problem->precision);
    for (unsigned i = 0; i < MOST_TRIES; i++) {
        const double length = take_step(search);
        if (!(length > nearest))
            break;
        luxel_status status = lx_problem_models(search->problem, search->set, search->tried, search->models);
        if (status != LUXEL_OK && status != LUXEL_ERROR_SCENE)
            return status;
        const double cost = status == LUXEL_OK ? cost_of(&search->counting, search->models, found->models) : HUGE_VAL;
        if (cost < found->cost) {
            found->has_ended = length < nearest * 4.0 || found->cost - cost <= gain * found->cost;
            memcpy(found->unknowns, search->tried, unknowns * sizeof *search->tried);
            memcpy(found->models, search->models, count * sizeof *search->models);
            search->damping = i == 0 ? search->damping * 0.02 : search->damping * 0.5;
            if (search->damping < 1e-10)
                search->damping = 0.0;
            return LUXEL_OK;
        }
        search->damping = fmax(search->damping * 8.0, 1e-6);
    }
    found->has_ended = true;
    return LUXEL_OK;
}

/* The noise that the values show, and what they cost then. */
static void count_cost(struct search *search)
{
    struct lx_trial *found = search->found;
    if (!lx_noise_is_told(search->problem->readings))
        search->counting.sd = lx_estimate_noise(&search->counting, found->models, search->problem->unknowns);
    found->sd = search->counting.sd;
    found->cost = cost_of(&search->counting, found->models, found->models);
}

luxel_status lx_search(struct lx_fit_problem *problem, const struct lx_reading_set *set, unsigned most_steps,
                       struct lx_trial *found)
{
    struct search search = {
        .problem = problem, .set = set, .found = found, .counting = {.problem = problem, .set = set}, .damping = 1e-3};
    luxel_status status = make_room(&search) ? LUXEL_OK : lx_out_of_memory(problem->diagnostics);
    if (status == LUXEL_OK)
        status = lx_problem_models(problem, set, found->unknowns, found->models);
    if (status == LUXEL_OK && problem->unknowns > problem->numbers)
        lx_fit_factor(problem, set, found);
    found->has_ended = false;
    for (unsigned i = 0; status == LUXEL_OK && i < most_steps && !found->has_ended; i++) {
        count_cost(&search);
        status = lx_problem_slopes(problem, set, found->unknowns, found->models, search.slopes);
        if (status != LUXEL_OK)
            break;
        memset(found->is_at_limit, 0, problem->unknowns * sizeof *found->is_at_limit);
        do
            solve(&search);
        while (hold_ends(&search));
        status = go_down(&search);
    }
    if (status == LUXEL_OK)
        count_cost(&search);
    free_room(&search);
    return status;
}

void lx_fit_factor(const struct lx_fit_problem *problem, const struct lx_reading_set *set, struct lx_trial *found)
{
    const double old = found->unknowns[problem->numbers];
    double above = 0.0, below = 0.0;
    for (size_t i = 0; i < set->count; i++)
        if (!lx_is_saturated(problem->readings, set->values[i])) {
            above += set->values[i] * found->models[i];
            below += found->models[i] * found->models[i];
        }
    const double factor = below > 0.0 && above > 0.0 ? above / below : 1.0;
    for (size_t i = 0; i < set->count; i++)
        found->models[i] *= factor;
    found->unknowns[problem->numbers] = old * factor;
}

/* Numbers between 0 and 1 that fill squares evenly (Halton). */
static double radical_inverse(unsigned i, unsigned base)
{
    double inverse = 0.0, digit = 1.0;
    for (; i > 0; i /= base)
        inverse += (digit /= base) * (i % base);
    return inverse;
}

static bool is_prime(unsigned n)
{
    for (unsigned i = 2; i * i <= n; i++)
        if (n % i == 0)
            return false;
    return true;
}

void lx_other_start(const struct lx_keys *keys, const double *lows, const double *highs, const double *scale,
                    unsigned i, double *numbers)
{
    unsigned base = 1;
    for (size_t k = 0; k < keys->number_count; k++) {
        const struct lx_key *key = lx_keys_of(keys, k);
        const double at = key->targets->numbers[k - key->offset], low = lows[k], high = highs[k];
        while (!is_prime(++base))
            continue;
        const double share = radical_inverse(i, base);
        if (isfinite(low) && isfinite(high))
            numbers[k] = low + share * (high - low);
        else if (isfinite(low) && at > low)
            numbers[k] = low + (at - low) * pow(4.0, 2.0 * share - 1.0);
        else if (isfinite(low))
            numbers[k] = low + share * scale[k];
        else
            numbers[k] = at + (2.0 * share - 1.0) * scale[k];
    }
}

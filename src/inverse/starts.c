/* SPDX-License-Identifier: MIT */
/* Searches from several starts, on some of the readings. */
#include "starts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"

enum {
    MOST_STEPS = 60, /* of a search from the scene's own numbers, */
    STEPS = 30,      /* and of one from another start; */
    FEW_STEPS = 12,  /* fewer where readings are many, or values slow, */
    STARTS = 8,
    FEW_STARTS = 3,     /* and fewer starts then, */
    FEW_READINGS = 100, /* which look at so many of them, */
    READINGS_EACH = 12  /* and so many for each unknown */
};

/* How many readings starts look at. */
static size_t some_of(const struct lx_fit_problem *problem)
{
    const size_t few = FEW_READINGS + READINGS_EACH * problem->unknowns;
    return problem->set.count < few ? problem->set.count : few;
}

/* Some of the readings where there are many, from all over them. */
static bool choose_some(const struct lx_fit_problem *problem, struct lx_reading_set *some)
{
    const struct lx_reading_set *all = &problem->set;
    const size_t wanted = some_of(problem);
    some->places = lx_new_array(wanted + 1, sizeof *some->places);
    some->values = lx_new_array(wanted + 1, sizeof *some->values);
    for (size_t i = 0; some->places && some->values && i < wanted; i++) {
        /* each from its own share of them, so that no period of rows is met */
        const size_t first = i * all->count / wanted, last = (i + 1) * all->count / wanted;
        const size_t at = first + (size_t)((uint32_t)(i * 2654435761u) >> 8) % (last - first);
        some->places[some->count] = all->places[at];
        some->values[some->count++] = all->values[at];
    }
    return some->places && some->values;
}

/* How badly something fits, comparably: the squares in standard deviations, or the noise it takes. */
static double badness(const struct lx_fit_problem *problem, const struct lx_trial *found)
{
    return lx_noise_is_told(problem->readings) ? found->cost : found->sd;
}

/* Whether one fits as well as another: the likelihood is within two standard deviations, or both are exact. */
static bool is_as_good(const struct lx_fit_problem *problem, size_t count, double bad, double best)
{
    if (lx_noise_is_told(problem->readings))
        return bad - best < 4.0;
    return bad <= 1e-9 * problem->greatest || 2.0 * (double)count * log(bad / best) < 4.0;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Whether two ends are the same one, be it with lamps that have changed their places. */
static bool is_same(const struct lx_fit_problem *problem, const double *a, const double *b)
{
    double sorted[2][64];
    const size_t n = problem->unknowns;
    bool same = true;
    for (size_t k = 0; k < n; k++)
        same = same && fabs(a[k] - b[k]) <= 1e-3 * problem->scale[k];
    if (same || n > 64)
        return same;
    memcpy(sorted[0], a, n * sizeof *a);
    memcpy(sorted[1], b, n * sizeof *b);
    qsort(sorted[0], n, sizeof *a, compare);
    qsort(sorted[1], n, sizeof *b, compare);
    for (size_t k = 0; k < n; k++)
        if (fabs(sorted[0][k] - sorted[1][k]) > 1e-3 * fmax(fabs(sorted[0][k]), 1e-3))
            return false;
    return true;
}

void lx_starts_clear(struct lx_starts *starts)
{
    for (size_t i = 0; i < starts->count; i++)
        lx_trial_clear(&starts->ends[i]);
    free(starts->some.places);
    free(starts->some.values);
}

luxel_status lx_starts_try(struct lx_fit_problem *problem, struct lx_starts *starts)
{
    const bool are_many = problem->set.count > some_of(problem);
    const bool are_few = are_many || problem->is_slow;
    const unsigned usual = are_few ? FEW_STARTS : STARTS, steps = are_few ? FEW_STEPS : STEPS;
    const unsigned wanted = problem->readings->starts > 0 ? problem->readings->starts : usual;
    luxel_status status = choose_some(problem, &starts->some) ? LUXEL_OK : lx_out_of_memory(problem->diagnostics);
    bool is_any = false;
    for (unsigned i = 0; status == LUXEL_OK && i < wanted && i < LX_MOST_STARTS; i++) {
        struct lx_trial *end = &starts->ends[starts->count++];
        if (!lx_trial_make(problem, starts->some.count, end))
            return lx_out_of_memory(problem->diagnostics);
        lx_other_start(&problem->keys, problem->low, problem->high, problem->scale, i, end->unknowns);
        if (problem->unknowns > problem->numbers)
            end->unknowns[problem->numbers] = 1.0;
        for (size_t k = 0; i == 0 && k < problem->numbers; k++) {
            const struct lx_key *key = lx_keys_of(&problem->keys, k);
            end->unknowns[k] = key->targets->numbers[k - key->offset];
        }
        status = lx_search(problem, &starts->some, i == 0 ? MOST_STEPS : steps, end);
        starts->exists[i] = status == LUXEL_OK;
        if (status == LUXEL_ERROR_SCENE)
            status = LUXEL_OK;
        if (!starts->exists[i])
            continue;
        const double bad = badness(problem, end), best = badness(problem, &starts->ends[starts->best]);
        if (!is_any || (bad < best && !is_as_good(problem, starts->some.count, best, bad)))
            starts->best = i;
        is_any = true;
    }
    return status == LUXEL_OK && !is_any ? LUXEL_ERROR_SCENE : status;
}

/* Whether an end is another one that fits all readings as well as what was found; where it then is. */
static luxel_status confirm(struct lx_fit_problem *problem, const struct lx_trial *found, struct lx_trial *end,
                            bool *is_other)
{
    struct lx_trial full;
    luxel_status status = LUXEL_ERROR_MEMORY;
    *is_other = false;
    if (lx_trial_make(problem, problem->set.count, &full)) {
        memcpy(full.unknowns, end->unknowns, problem->unknowns * sizeof *full.unknowns);
        status = lx_search(problem, &problem->set, STEPS, &full);
        *is_other = status == LUXEL_OK && full.has_ended && !is_same(problem, full.unknowns, found->unknowns) &&
                    is_as_good(problem, problem->set.count, badness(problem, &full), badness(problem, found));
        memcpy(end->unknowns, full.unknowns, problem->unknowns * sizeof *full.unknowns);
    } else {
        lx_out_of_memory(problem->diagnostics);
    }
    lx_trial_clear(&full);
    return status == LUXEL_ERROR_SCENE ? LUXEL_OK : status;
}

/* Takes down the values of another end beside those that were found. */
static void note_end(const struct lx_fit_problem *problem, const struct lx_trial *found, const struct lx_trial *end,
                     struct lx_conclusion *conclusion)
{
    for (size_t k = 0; k < problem->unknowns; k++)
        if (fabs(end->unknowns[k] - found->unknowns[k]) > 1e-3 * problem->scale[k]) {
            if (conclusion->several[k] == 0)
                conclusion->ends[k][conclusion->several[k]++] = found->unknowns[k];
            if (conclusion->several[k] < LX_MOST_ENDS)
                conclusion->ends[k][conclusion->several[k]++] = end->unknowns[k];
        }
}

luxel_status lx_starts_compare(struct lx_fit_problem *problem, struct lx_starts *starts, const struct lx_trial *found,
                               luxel_fit *fit, struct lx_conclusion *conclusion)
{
    luxel_status status = LUXEL_OK;
    const double best = badness(problem, &starts->ends[starts->best]);
    fit->starts = starts->count;
    for (size_t i = 0; status == LUXEL_OK && i < starts->count; i++) {
        struct lx_trial *end = &starts->ends[i];
        bool is_other = false;
        if (!starts->exists[i] || !is_as_good(problem, starts->some.count, badness(problem, end), best))
            continue;
        if (is_same(problem, end->unknowns, starts->ends[starts->best].unknowns))
            fit->agreed++;
        else if (conclusion->blocks == 0) /* along what is not determined there are many, and none is another one */
            status = confirm(problem, found, end, &is_other);
        if (is_other)
            note_end(problem, found, end, conclusion);
    }
    return status;
}

/* SPDX-License-Identifier: MIT */
/* Exact values at many places, by several threads. */
#include <luxel/evaluator.h>

#include "../base/rows.h"
#include "../shade/evaluate.h"

/* Places are handed out so many at once: some tens of microseconds of work where there is one source. */
enum { PLACES_AT_ONCE = 32 };

/* A control counts its rows in an unsigned; more places than this go one part after the other. */
static const size_t MOST_AT_A_TIME = (size_t)1 << 30;

struct evaluating {
    const luxel_evaluator *evaluator;
    struct lx_control *control;
    const luxel_place *places;
    luxel_value *values;
    double *shares; /* NULL: not wanted */
    size_t lights;
};

/* For the threads a place is a row. */
static void evaluate(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct evaluating *work = data;
    (void)worker;
    for (size_t i = first; i < last && lx_control_goes_on(work->control, is_caller); i++)
        work->values[i] = luxel_evaluate_place(work->evaluator, &work->places[i],
                                               work->shares ? work->shares + i * work->lights : NULL);
}

static bool evaluate_part(struct evaluating *work, unsigned count)
{
    const luxel_settings *settings = &work->evaluator->settings;
    struct lx_control control = {.rows = count, .progress = settings->progress, .data = settings->progress_data};
    const struct lx_rows_part part = {.last = count, .tile_rows = PLACES_AT_ONCE, .work = evaluate, .data = work};
    work->control = &control;
    return lx_rows_run_part(&control, lx_thread_count(settings->threads, count / PLACES_AT_ONCE + 1), &part);
}

luxel_status luxel_evaluate_places(const luxel_evaluator *evaluator, const luxel_place *places, size_t count,
                                   luxel_value *values, double *shares)
{
    if (!evaluator || (count > 0 && (!places || !values)))
        return LUXEL_ERROR_ARGUMENT;
    struct evaluating work = {.evaluator = evaluator,
                              .places = places,
                              .values = values,
                              .shares = shares,
                              .lights = luxel_evaluator_light_count(evaluator)};
    while (count > 0) {
        const size_t now = count < MOST_AT_A_TIME ? count : MOST_AT_A_TIME;
        if (!evaluate_part(&work, (unsigned)now))
            return LUXEL_CANCELLED;
        work.places += now;
        work.values += now;
        work.shares = work.shares ? work.shares + now * work.lights : NULL;
        count -= now;
    }
    return LUXEL_OK;
}

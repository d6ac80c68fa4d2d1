/* SPDX-License-Identifier: MIT */
/* Exact values at many places, batch by batch, by several threads. */
#include "evaluate_places.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/rows.h"
#include "../world/evaluate.h"

/* A control counts its rows in an unsigned; more places than this go one part after the other. */
static const size_t MOST_AT_A_TIME = (size_t)1 << 30;

struct evaluating {
    const luxel_evaluator *evaluator;
    struct lx_control *control;
    const luxel_place *places;
    luxel_value *values;
    double *shares; /* NULL: not wanted */
    size_t lights;
    const struct lx_slopes *slopes; /* NULL: not wanted */
    struct lx_slope_list to;
};

/* A batch, and which of the places its elements are. */
struct batch {
    const struct evaluating *work;
    const struct lx_asking *asking;
    struct lx_elements elements;
    size_t of[LX_BATCH];
};

static double *shares_of(const struct evaluating *work, size_t place)
{
    return work->shares ? work->shares + place * work->lights : NULL;
}

/* Writes the slopes of element i; those that somebody else has to tell stay as they are. */
static void write_slopes(const struct batch *batch, const struct lx_column *sums, size_t i)
{
    const struct lx_slopes *slopes = batch->work->slopes;
    luxel_derivative *list = &batch->work->to.list[batch->of[i] * slopes->number_count];
    for (size_t k = 0; k < slopes->number_count; k++)
        if (slopes->numbers[k].is_known) {
            list[k].state = slopes->numbers[k].is_limited ? LUXEL_DERIVATIVE_ONE_SIDED : LUXEL_DERIVATIVE_EXISTS;
            list[k].value = sums[k].value[i];
            list[k].error = sums[k].error[i];
        }
}

static void find_slopes(const struct batch *batch)
{
    const struct evaluating *work = batch->work;
    const struct lx_elements *elements = &batch->elements;
    const luxel_place *first = &work->places[batch->of[0]];
    struct lx_column *sums = lx_new_aligned(work->slopes->number_count + 1, sizeof *sums);
    double screen_mm[LX_BATCH][2];
    bool in_doubt[LX_BATCH];
    for (size_t i = 0; i < elements->count && !elements->are_free; i++)
        memcpy(screen_mm[i], work->places[batch->of[i]].screen_mm, sizeof screen_mm[i]);
    if (sums)
        lx_slope_elements(&work->evaluator->world, work->slopes, elements,
                          lx_wanted_for(work->evaluator->settings.quantity), elements->are_free ? NULL : screen_mm,
                          first->has_view, sums, in_doubt);
    for (size_t i = 0; i < elements->count; i++) {
        const bool is_known = sums && !in_doubt[i] && work->values[batch->of[i]].has_value;
        work->to.in_doubt[batch->of[i]] = !is_known;
        if (is_known)
            write_slopes(batch, sums, i);
    }
    free(sums);
}

/* Sums the lights of a batch; what lies on no surface has the material of one that its place names. */
static void light_batch(const struct batch *batch)
{
    const struct evaluating *work = batch->work;
    lx_evaluate_elements(work->evaluator, &batch->elements, batch->asking, batch->of, work->values, work->shares);
    for (size_t i = 0; i < batch->elements.count; i++)
        if (batch->elements.own[i] == 0)
            work->values[batch->of[i]].surface = work->places[batch->of[i]].surface;
    if (work->slopes)
        find_slopes(batch);
}

static const struct lx_lobe *lobe_of(const struct batch *batch, size_t i)
{
    const uint32_t own = batch->elements.own[i];
    const struct lx_prepared *prepared = batch->work->evaluator->world.prepared;
    return own > 0 ? &prepared->surfaces[own - 1].lobe
                   : &prepared->authored[batch->work->places[batch->of[i]].surface].lobe;
}

/* Lights a batch whose elements may have several lobes: those of each by themselves. */
static void light_by_lobes(struct batch *batch)
{
    const struct lx_elements *all = &batch->elements;
    bool is_done[LX_BATCH] = {false};
    for (size_t first = 0; first < all->count; first++) {
        const struct lx_lobe *lobe = lobe_of(batch, first);
        struct batch part;
        if (is_done[first])
            continue;
        part.work = batch->work;
        part.asking = batch->asking;
        lx_elements_begin(&part.elements, lobe, all->are_free);
        for (size_t i = first; i < all->count; i++)
            if (lobe_of(batch, i) == lobe) {
                part.of[part.elements.count] = batch->of[i];
                lx_elements_copy(&part.elements, all, i);
                is_done[i] = true;
            }
        lx_elements_end(&part.elements);
        light_batch(&part);
    }
}

static void light_elements(struct batch *batch)
{
    bool is_one = true;
    for (size_t i = 1; i < batch->elements.count; i++)
        is_one = is_one && lobe_of(batch, i) == lobe_of(batch, 0);
    batch->elements.lobe = lobe_of(batch, 0);
    if (is_one)
        light_batch(batch);
    else
        light_by_lobes(batch);
}

/* Whether a place is a free element like another that begins a batch; where there are mirrors none is like another. */
static bool is_alike(const struct evaluating *work, const luxel_place *place, const luxel_place *first)
{
    return work->evaluator->world.prepared->mirrors.count == 0 && place->is_element && lx_is_place(place) &&
           place->surface < lx_material_count(work->evaluator->world.prepared->scene) &&
           place->has_view == first->has_view;
}

/* Evaluates the free elements from `first` on that are alike; returns behind the last of them. */
static size_t evaluate_alike(const struct evaluating *work, const struct lx_asking *asking, size_t first, size_t last)
{
    const luxel_place *place = &work->places[first];
    struct batch batch; /* most of which is set as elements come */
    size_t next = first;
    batch.work = work;
    batch.asking = asking;
    lx_elements_begin(&batch.elements, NULL, true);
    for (; next < last && batch.elements.count < LX_BATCH && is_alike(work, &work->places[next], place); next++) {
        const luxel_place *at = &work->places[next];
        batch.of[batch.elements.count] = next;
        lx_elements_append_place(&batch.elements, lx_exact3(at->position_mm), lx_exact3(at->normal),
                                 at->has_view ? at->view : NULL);
    }
    lx_elements_end(&batch.elements);
    lx_world_settle(&work->evaluator->world, &(struct lx_settling){.has_views = place->has_view}, &batch.elements);
    light_elements(&batch);
    return next;
}

/* Evaluates what is seen through the screen points from `first` on; returns behind the last of them. */
static size_t evaluate_seen(const struct evaluating *work, const struct lx_asking *asking, size_t first, size_t last)
{
    struct batch batch; /* most of which is set as elements come */
    size_t next = first;
    batch.work = work;
    batch.asking = asking;
    lx_elements_begin(&batch.elements, NULL, false);
    for (; next < last && batch.elements.count < LX_BATCH && !work->places[next].is_element; next++) {
        const luxel_place *at = &work->places[next];
        struct lx_element element;
        if (lx_is_place(at) && lx_evaluator_sees(work->evaluator, at->screen_mm[0], at->screen_mm[1], &element)) {
            batch.of[batch.elements.count] = next;
            lx_elements_append(work->evaluator->world.prepared, &batch.elements, &element);
            continue;
        }
        work->values[next] = (luxel_value){.on_surface = false};
        if (work->slopes)
            work->to.in_doubt[next] = true;
        if (work->shares)
            memset(shares_of(work, next), 0, work->lights * sizeof *work->shares);
    }
    lx_elements_end(&batch.elements);
    if (batch.elements.count > 0)
        light_elements(&batch);
    return next;
}

/* For the threads a place is a row. */
static void evaluate(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct evaluating *work = data;
    const struct lx_asking asking = {.control = work->control, .is_caller = is_caller};
    (void)worker;
    for (size_t i = first; i < last && lx_control_goes_on(work->control, is_caller);) {
        const luxel_place *place = &work->places[i];
        if (!place->is_element) {
            i = evaluate_seen(work, &asking, i, last);
        } else if (is_alike(work, place, place)) {
            i = evaluate_alike(work, &asking, i, last);
        } else {
            luxel_evaluate_place(work->evaluator, place, &work->values[i], shares_of(work, i));
            if (work->slopes)
                work->to.in_doubt[i] = true;
            i++;
        }
    }
}

static bool evaluate_part(struct evaluating *work, unsigned count)
{
    const luxel_settings *settings = &work->evaluator->settings;
    struct lx_control control = {.rows = count, .progress = settings->progress, .data = settings->progress_data};
    const unsigned batch = lx_world_batch(&work->evaluator->world);
    const struct lx_rows_part part = {.last = count, .tile_rows = batch, .work = evaluate, .data = work};
    work->control = &control;
    return lx_rows_run_part(&control, lx_thread_count(settings->threads, count / batch + 1), &part);
}

static luxel_status evaluate_all(struct evaluating *work, size_t count)
{
    while (count > 0) {
        const size_t now = count < MOST_AT_A_TIME ? count : MOST_AT_A_TIME;
        if (!evaluate_part(work, (unsigned)now))
            return LUXEL_CANCELLED;
        work->places += now;
        work->values += now;
        work->shares = work->shares ? work->shares + now * work->lights : NULL;
        work->to.list = work->slopes ? work->to.list + now * work->slopes->number_count : NULL;
        work->to.in_doubt = work->slopes ? work->to.in_doubt + now : NULL;
        count -= now;
    }
    return LUXEL_OK;
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
    return evaluate_all(&work, count);
}

luxel_status lx_evaluate_slopes(const luxel_evaluator *evaluator, const struct lx_slopes *slopes,
                                const luxel_place *places, size_t count, luxel_value *values, struct lx_slope_list to)
{
    struct evaluating work = {.evaluator = evaluator, .places = places, .values = values, .slopes = slopes, .to = to};
    return evaluate_all(&work, count);
}

/* SPDX-License-Identifier: MIT */
/* Which pixels of a row are asked whether light arrives at them, and what comes of it; and of how many it does. */
#include "reaching.h"

#include <luxel/light.h>

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"

struct lx_reaching_worker {
    struct lx_shader_memory *memory;
    double least; /* so far, in the rows of this thread */
};

static luxel_status open_workers(struct lx_reaching *reaching, unsigned threads)
{
    reaching->workers = lx_new_array(threads, sizeof *reaching->workers);
    if (!reaching->workers)
        return LUXEL_ERROR_MEMORY;
    reaching->count = threads;
    for (unsigned i = 0; i < threads; i++) {
        reaching->workers[i].least = HUGE_VAL;
        reaching->workers[i].memory = lx_shader_memory_new(&reaching->reach.plan);
        if (!reaching->workers[i].memory)
            return LUXEL_ERROR_MEMORY;
    }
    return LUXEL_OK;
}

luxel_status lx_reaching_open(struct lx_reaching *reaching, const struct lx_session *session, unsigned threads,
                              luxel_diagnostics *diagnostics)
{
    const luxel_settings *settings = &session->settings;
    if (!settings->minimum_reached || settings->stride > 1)
        return LUXEL_OK;
    /* what surfaces reflect arrives wherever there is any */
    reaching->is_plain = session->world.reflected || lx_reach_is_plain(&session->prepared, settings->quantity);
    if (reaching->is_plain || session->plan.trees.tree_count > 0)
        return LUXEL_OK;
    luxel_status status = lx_reach_open(&reaching->reach, session->prepared.scene, session->kernels, settings);
    reaching->is_open = true;
    if (status == LUXEL_OK)
        status = open_workers(reaching, threads);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

void lx_reaching_clear(struct lx_reaching *reaching)
{
    for (unsigned i = 0; i < reaching->count; i++)
        lx_shader_memory_free(reaching->workers[i].memory);
    free(reaching->workers);
    if (reaching->is_open)
        lx_reach_clear(&reaching->reach);
}

static bool counts(double value, double least)
{
    return value >= LX_LEAST_LIT && value <= least;
}

/* Whether some value from the i-th on may take the place of the least, or be its equal further up. */
static bool may_count(const struct lx_reaching *reaching, const struct luxel_field *field, const struct lx_strip *strip,
                      size_t i, size_t count, double least)
{
    const struct lx_kernels *kernels = reaching->reach.plan.kernels;
    const struct lx_survey survey = field->precision == LUXEL_DOUBLE
                                        ? kernels->survey_double((const double *)strip->values + i, count, LX_LEAST_LIT)
                                        : kernels->survey_single((const float *)strip->values + i, count, LX_LEAST_LIT);
    return survey.minimum <= least;
}

void lx_reaching_row(struct lx_reaching *reaching, unsigned worker, const struct luxel_field *field,
                     const struct lx_strip *strip, unsigned row, struct lx_row_statistics *gathered)
{
    if (!reaching->is_open)
        return;
    struct lx_reaching_worker *own = &reaching->workers[worker];
    const size_t begin = (size_t)(row - strip->first) * field->columns;
    uint8_t mask[LX_BLOCK], arrives[LX_BLOCK];
    for (unsigned first = 0, count; first < field->columns; first += count) {
        count = field->columns - first < LX_BLOCK ? field->columns - first : LX_BLOCK;
        if (!may_count(reaching, field, strip, begin + first, count, own->least))
            continue;
        lx_reach_row(&reaching->reach, own->memory, field->y_mm[row], field->x_mm + first, count, mask, arrives);
        for (unsigned i = first; i < first + count; i++) {
            const double value = lx_strip_value(field, strip, begin + i);
            if (!arrives[i - first] || !counts(value, own->least) || value >= gathered->reached)
                continue;
            own->least = gathered->reached = value;
            gathered->reached_column = i;
        }
    }
}

luxel_status luxel_find_light_reach(const luxel_scene *scene, const luxel_settings *settings,
                                    luxel_diagnostics *diagnostics, luxel_light_reach *reach)
{
    struct lx_session session;
    struct lx_reach found;
    luxel_status status = lx_session_begin(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, diagnostics);
    if (status != LUXEL_OK)
        return status;
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    double *x_mm = lx_new_column_places(&parameters->screen, 1), *y_mm = lx_new_row_places(&parameters->screen, 1);
    status = lx_reach_open(&found, parameters, session.kernels, &session.settings);
    *reach = (luxel_light_reach){.has_ambient = found.has_ambient, .has_direct = found.has_direct};
    if (status == LUXEL_OK && (!x_mm || !y_mm))
        status = LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK)
        status = lx_reach_share(&found, x_mm, parameters->screen.resolution[0], y_mm, parameters->screen.resolution[1],
                                &reach->share);
    lx_reach_clear(&found);
    free(x_mm);
    free(y_mm);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

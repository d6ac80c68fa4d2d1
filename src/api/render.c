/* SPDX-License-Identifier: MIT */
/* luxel_render(): the plan's pixels, row by row in parallel, into a field with its statistics. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/rows.h"
#include "../field/field.h"
#include "../format/tags.h"
#include "../shade/shader.h"
#include "session.h"

struct rendering {
    const struct lx_plan *plan;
    struct luxel_field *field;
    struct lx_control *control;
    struct lx_shader_memory **memories; /* one for each worker */
    struct lx_row_statistics *rows;
};

/* Of a row whose pixels off the surfaces are 0, and no other is below. */
static struct lx_row_statistics survey_row(const struct rendering *rendering, unsigned row, size_t surface_pixels)
{
    const struct luxel_field *field = rendering->field;
    const struct lx_kernels *kernels = rendering->plan->kernels;
    const size_t first = (size_t)row * field->columns;
    const struct lx_survey survey =
        field->precision == LUXEL_DOUBLE
            ? kernels->survey_double((const double *)field->values + first, field->columns, LX_LEAST_LIT)
            : kernels->survey_single((const float *)field->values + first, field->columns, LX_LEAST_LIT);
    if (isnan(survey.sum))
        return lx_gather_row(field, row);
    return (struct lx_row_statistics){
        .maximum = survey.maximum,
        .minimum = survey.minimum,
        .surface_pixels = surface_pixels,
        .lit_pixels = survey.at_least,
        .sum = survey.sum,
    };
}

static void render_row(struct rendering *rendering, struct lx_shader_memory *memory, bool is_caller, unsigned row)
{
    struct luxel_field *field = rendering->field;
    double x[LX_BLOCK], values[LX_BLOCK], y = field->y_mm[row];
    uint8_t mask[LX_BLOCK];
    size_t shown = 0;
    for (unsigned first = 0; first < field->columns; first += LX_BLOCK) {
        unsigned left = field->columns - first, count = left < LX_BLOCK ? left : LX_BLOCK;
        memcpy(x, field->x_mm + first, count * sizeof *x);
        shown += lx_shade_points(rendering->plan, memory, y, x, count, rendering->control, is_caller, values, mask);
        lx_field_store(field, row, first, values, mask, count);
        if (!lx_control_goes_on(rendering->control, is_caller))
            return;
    }
    rendering->rows[row] = survey_row(rendering, row, shown);
}

static void render_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct rendering *rendering = data;
    for (unsigned row = first; row < last; row++)
        render_row(rendering, rendering->memories[worker], is_caller, row);
}

static unsigned thread_count(const luxel_settings *settings, unsigned columns, unsigned rows)
{
    /* A thread costs more than a tiny picture. */
    return lx_thread_count(settings->threads, (unsigned)((double)columns * rows / 8192) + 1);
}

static luxel_status too_large(const unsigned size[2], double needed, double available, luxel_diagnostics *diagnostics)
{
    char columns[LX_NUMBER_SIZE], rows[LX_NUMBER_SIZE], need[LX_AMOUNT_SIZE], have[LX_AMOUNT_SIZE];
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_PICTURE_TOO_LARGE,
              LX_ARGS(lx_write_number(size[0], columns), lx_write_number(size[1], rows), lx_write_amount(needed, need),
                      lx_write_amount(available, have)));
    lx_hint(diagnostics, LX_MSG_SMALLER_PICTURE, NULL);
    return LUXEL_ERROR_MEMORY;
}

/*
 * What the field keeps of where it came from.  A scene that is larger than can be read again is left out, and that of
 * a quick look, which is not its picture.
 */
static luxel_status keep_origin(const struct lx_session *session, const luxel_scene *scene,
                                luxel_diagnostics *diagnostics, struct luxel_field *field)
{
    const luxel_settings *settings = &session->settings;
    const char *unit = lx_unit_of(&session->prepared, settings->quantity);
    field->quantity = settings->quantity;
    field->tolerance = settings->tolerance;
    field->light_error = settings->light_error;
    field->instruction_set = session->kernels->name;
    field->unit = lx_copy_text(unit, strlen(unit));
    if (!field->unit)
        return lx_out_of_memory(diagnostics);
    if (settings->stride > 1)
        return LUXEL_OK;
    if (luxel_scene_write_text(scene, &field->scene) != LUXEL_OK)
        return lx_out_of_memory(diagnostics);
    if (strlen(field->scene) > LX_LARGEST_TAG) {
        free(field->scene);
        field->scene = NULL;
    }
    return LUXEL_OK;
}

static luxel_status new_field(const struct lx_session *session, luxel_diagnostics *diagnostics,
                              struct luxel_field **field)
{
    const struct lx_scene_parameters *scene = session->prepared.scene;
    luxel_precision precision = session->settings.precision;
    unsigned stride = session->settings.stride > 1 ? session->settings.stride : 1;
    const unsigned size[2] = {lx_strided_count(scene->screen.resolution[0], stride),
                              lx_strided_count(scene->screen.resolution[1], stride)};
    double needed = (double)lx_field_bytes(size[0], size[1], precision);
    double available = lx_available_bytes();
    if (needed == 0 || needed > available)
        return too_large(size, needed, available, diagnostics);
    *field = lx_field_new(scene, stride, precision);
    if (!*field)
        return too_large(size, needed, needed < available ? 0 : available, diagnostics);
    return LUXEL_OK;
}

static luxel_status check_range(const struct luxel_field *field, luxel_diagnostics *diagnostics)
{
    const luxel_extremum *maximum = &field->statistics.maximum;
    if (!maximum->exists || isfinite(maximum->value))
        return LUXEL_OK;
    bool single = field->precision == LUXEL_SINGLE;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_VALUE_TOO_LARGE, LX_ARGS(single ? "single" : "double"));
    lx_hint(diagnostics, single ? LX_MSG_USE_DOUBLE : LX_MSG_LOWER_STRENGTHS, NULL);
    return LUXEL_ERROR_RANGE;
}

static void free_memories(struct lx_shader_memory **memories, unsigned threads)
{
    for (unsigned i = 0; memories && i < threads; i++)
        free(memories[i]);
    free(memories);
}

static luxel_status run(struct rendering *rendering, const luxel_settings *settings, luxel_diagnostics *diagnostics)
{
    struct luxel_field *field = rendering->field;
    unsigned threads = thread_count(settings, field->columns, field->rows);
    bool complete = true;
    rendering->memories = lx_new_array(threads, sizeof *rendering->memories);
    rendering->rows = lx_new_array(field->rows, sizeof *rendering->rows);
    for (unsigned i = 0; rendering->memories && i < threads; i++)
        complete &= (rendering->memories[i] = lx_shader_memory_new(rendering->plan)) != NULL;

    luxel_status status = LUXEL_OK;
    if (!rendering->memories || !rendering->rows || !complete)
        status = lx_out_of_memory(diagnostics);
    else if (!lx_rows_run(rendering->control, threads, render_rows, rendering))
        status = LUXEL_CANCELLED;
    else
        lx_finish_statistics(field, rendering->rows);
    free_memories(rendering->memories, threads);
    free(rendering->rows);
    return status != LUXEL_OK ? status : check_range(field, diagnostics);
}

luxel_status luxel_render(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                          luxel_field **field)
{
    if (!field) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_MISSING_ARGUMENT, LX_ARGS("field"));
        return LUXEL_ERROR_ARGUMENT;
    }
    struct lx_session session;
    struct luxel_field *made = NULL;
    luxel_status status = lx_session_open(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = new_field(&session, diagnostics, &made);
    if (status == LUXEL_OK)
        status = keep_origin(&session, scene, diagnostics, made);
    if (status == LUXEL_OK) {
        struct lx_control control = {
            .rows = made->rows, .progress = session.settings.progress, .data = session.settings.progress_data};
        struct rendering rendering = {.plan = &session.plan, .field = made, .control = &control};
        status = run(&rendering, &session.settings, diagnostics);
    }
    lx_session_clear(&session);
    if (status == LUXEL_OK)
        *field = made;
    else
        luxel_field_free(made);
    return status;
}

/* SPDX-License-Identifier: MIT */
/* luxel_render_files(): strips of the picture, each written to all files before the next but one is computed. */
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "coloring.h"
#include "output.h"
#include "reflecting.h"
#include "rendering.h"

/*
 * Bytes.  A strip should be small, to stay in the processor's caches, but not computed faster than threads come and go.
 * A picture that grey levels wait for is worth more memory, as it takes time to keep it elsewhere.
 */
enum { SIZE_PER_THREAD = 4 << 20, MOST_STRIP_SIZE = 64 << 20, MOST_WAITING_SIZE = 128 << 20 };

struct files {
    struct lx_output **outputs; /* NULL: one that could not be begun, or was ended */
    size_t count;
    luxel_status status; /* what the last one that failed failed with */
};

static luxel_status check_arguments(const char *const *paths, size_t count, const luxel_field_output *how,
                                    luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    if (count > 0 && !paths)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("paths"));
    for (size_t i = 0; i < count && status == LUXEL_OK; i++)
        status = lx_output_check(paths[i], how, diagnostics);
    return status;
}

/* Whether some file carries the scene's text, which takes longer to write than a scene with many surfaces to draw. */
static bool some_carries(const char *const *paths, size_t count)
{
    bool any = false;
    for (size_t i = 0; i < count; i++)
        any = any || lx_output_carries(paths[i]);
    return any;
}

/* A file that cannot be begun does not stop the others. */
static luxel_status open_files(struct files *files, const struct luxel_field *field, const char *const *paths,
                               size_t count, const luxel_field_output *how, luxel_diagnostics *diagnostics)
{
    files->outputs = lx_new_array(count, sizeof(struct lx_output *));
    if (!files->outputs)
        return lx_out_of_memory(diagnostics);
    for (; files->count < count; files->count++) {
        luxel_status status = lx_output_open(field, &(struct lx_destination){.path = paths[files->count]}, how,
                                             diagnostics, &files->outputs[files->count]);
        if (status != LUXEL_OK && status != LUXEL_ERROR_FILE)
            return status;
        files->status = status != LUXEL_OK ? status : files->status;
    }
    return LUXEL_OK;
}

static void add_strip(void *data, const struct lx_strip *strip)
{
    const struct files *files = data;
    for (size_t i = 0; i < files->count; i++)
        if (files->outputs[i])
            lx_output_add(files->outputs[i], strip);
}

/* Whether some file waits for the whole picture. */
static bool some_waits(const struct files *files)
{
    for (size_t i = 0; i < files->count; i++)
        if (files->outputs[i] && lx_output_waits(files->outputs[i]))
            return true;
    return false;
}

/* How many rows to hold at a time, those of whole panels. */
static unsigned strip_height(const struct files *files, const struct luxel_field *field, unsigned threads)
{
    const size_t row_size = lx_field_bytes(field->columns, 1, field->precision);
    for (size_t i = 0; i < files->count; i++)
        if (files->outputs[i] && lx_output_wants_all(files->outputs[i]))
            return field->rows;
    if (some_waits(files) && row_size * field->rows <= MOST_WAITING_SIZE)
        return field->rows;
    const size_t wanted = (size_t)SIZE_PER_THREAD * threads;
    const size_t unit = LX_PANEL_SIDE;
    _Static_assert(LX_PANEL_SIDE % LX_TILE_ROWS == 0, "panels have whole tiles");
    const size_t least = 1 + (wanted < MOST_STRIP_SIZE ? wanted : MOST_STRIP_SIZE) / row_size;
    const size_t height = (least + unit - 1) / unit * unit;
    return height < field->rows ? (unsigned)height : field->rows;
}

/* Goes through the strips once more for the files that have waited for the last one. */
static luxel_status catch_up(struct lx_rendering *rendering, const struct files *files, unsigned height)
{
    struct lx_strip *strip = &rendering->held[0].strip;
    const unsigned rows = rendering->field->rows;
    for (unsigned first = 0; first < rows; first += strip->rows) {
        strip->first = first;
        strip->rows = rows - first < height ? rows - first : height;
        for (size_t i = 0; i < files->count; i++)
            if (files->outputs[i])
                lx_output_catch_up(files->outputs[i], strip);
        atomic_fetch_add(&rendering->control.rows_done, strip->rows);
        if (!lx_control_goes_on(&rendering->control, true))
            return LUXEL_CANCELLED;
    }
    return LUXEL_OK;
}

static luxel_status write_files(struct lx_rendering *rendering, const struct lx_session *session,
                                struct luxel_field *field, struct files *files, luxel_diagnostics *diagnostics)
{
    const unsigned height = strip_height(files, field, lx_rendering_threads(session, field));
    const bool again = height < field->rows && some_waits(files);
    luxel_status status = lx_rendering_open(rendering, session, field, height, diagnostics);
    rendering->take = add_strip;
    rendering->take_data = files;
    if (again)
        rendering->control.rows *= 2;
    if (status == LUXEL_OK)
        status = lx_rendering_run(rendering);
    return status == LUXEL_OK && again ? catch_up(rendering, files, height) : status;
}

/* Puts the files in their places, until the user no longer wants them. */
static luxel_status commit_files(struct files *files, struct lx_control *control)
{
    for (size_t i = 0; i < files->count; i++) {
        if (!files->outputs[i])
            continue;
        control->last = 0; /* ask now, however short ago it was asked */
        if (!lx_control_goes_on(control, true))
            return LUXEL_CANCELLED;
        luxel_status status = lx_output_commit(files->outputs[i]);
        files->outputs[i] = NULL;
        files->status = status != LUXEL_OK ? status : files->status;
    }
    return files->status;
}

static void clear_files(struct files *files)
{
    for (size_t i = 0; i < files->count; i++)
        lx_output_abort(files->outputs[i]);
    free(files->outputs);
}

/* A picture in colour is a sum of pictures, and is made whole. */
static luxel_status render_in_color(const luxel_scene *scene, const luxel_settings *settings, const char *const *paths,
                                    size_t count, const luxel_field_output *how, luxel_diagnostics *diagnostics,
                                    luxel_statistics *statistics)
{
    struct luxel_field *field;
    luxel_status status = luxel_render(scene, settings, diagnostics, &field);
    if (status != LUXEL_OK)
        return status;
    for (size_t i = 0; i < count; i++) {
        const luxel_status written = luxel_field_write_as(field, paths[i], how, diagnostics);
        status = written != LUXEL_OK ? written : status;
    }
    if (statistics)
        *statistics = field->statistics;
    luxel_field_free(field);
    return status;
}

luxel_status luxel_render_files(const luxel_scene *scene, const luxel_settings *settings, const char *const *paths,
                                size_t count, const luxel_field_output *how, luxel_diagnostics *diagnostics,
                                luxel_statistics *statistics)
{
    struct lx_session session = {0};
    struct lx_rendering rendering = {0};
    struct luxel_field *frame = NULL;
    struct files files = {0};
    luxel_status status = check_arguments(paths, count, how, diagnostics);
    if (status == LUXEL_OK && luxel_scene_has_color(scene))
        return render_in_color(scene, settings, paths, count, how, diagnostics, statistics);
    if (status == LUXEL_OK)
        status = lx_session_open(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = lx_new_frame(&session, some_carries(paths, count) ? scene : NULL, diagnostics, &frame);
    if (status == LUXEL_OK)
        status = open_files(&files, frame, paths, count, how, diagnostics);
    if (status == LUXEL_OK)
        status = lx_reflect_picture(scene, &session, diagnostics);
    if (status == LUXEL_OK)
        status = write_files(&rendering, &session, frame, &files, diagnostics);
    if (status == LUXEL_OK) {
        lx_report_mirrored_error(scene, &frame->statistics, diagnostics);
        status = commit_files(&files, &rendering.control);
        if (statistics && status != LUXEL_CANCELLED)
            *statistics = frame->statistics;
    }
    clear_files(&files);
    lx_rendering_clear(&rendering);
    luxel_field_free(frame);
    lx_session_clear(&session);
    return status;
}

/* SPDX-License-Identifier: MIT */
/*
 * What the pixels of a scene show, as depths, normals, places and surfaces: luxel_find_geometry().  Lines of sight meet
 * surfaces by the kernels that pictures are made with, row by row in parallel.
 */
#include <luxel/view.h>

#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../picture/plan_make.h"
#include "../picture/seen.h"
#include "../world/camera.h"
#include "session.h"

/* Scratch memory of one thread. */
struct sight {
    struct lx_seen seen;
    _Alignas(64) double x_mm[LX_BLOCK];
};

struct looking {
    const struct lx_session *session;
    const luxel_geometry *wanted;
    struct lx_control *control;
    struct sight **sights; /* one for each thread */
};

/* An element of a surface, in the frame of the screen. */
struct seen_element {
    double place_mm[3], normal[3];
    const struct lx_prepared_surface *surface;
};

static void show(const struct looking *work, size_t pixel, const struct seen_element *element)
{
    const luxel_geometry *wanted = work->wanted;
    const struct lx_camera *camera = &work->session->prepared.camera;
    if (wanted->depth_mm)
        wanted->depth_mm[pixel] = camera->z_mm - element->place_mm[2];
    if (wanted->normals)
        lx_frame_turn_back(&camera->frame, element->normal, wanted->normals[pixel]);
    if (wanted->positions_mm)
        lx_frame_bring(&camera->frame, element->place_mm, wanted->positions_mm[pixel]);
    if (wanted->surfaces)
        wanted->surfaces[pixel] = (int32_t)element->surface->authored;
    if (wanted->parts)
        wanted->parts[pixel] = element->surface->part;
}

/* Fills so many pixels as where nothing is seen. */
static void clear(const luxel_geometry *wanted, size_t pixel, size_t count)
{
    if (wanted->depth_mm)
        memset(wanted->depth_mm + pixel, 0, count * sizeof *wanted->depth_mm);
    if (wanted->normals)
        memset(wanted->normals + pixel, 0, count * sizeof *wanted->normals);
    if (wanted->positions_mm)
        memset(wanted->positions_mm + pixel, 0, count * sizeof *wanted->positions_mm);
    for (size_t i = 0; wanted->surfaces && i < count; i++)
        wanted->surfaces[pixel + i] = -1;
    if (wanted->parts)
        memset(wanted->parts + pixel, 0, count * sizeof *wanted->parts);
}

/* The elements of a surface that a run of pixels shows, the first of which is `pixel`; returns how many. */
static size_t show_surface(const struct looking *work, struct lx_seen *seen, size_t s, size_t pixel, size_t count)
{
    const struct lx_plan *plan = &work->session->plan;
    const double *anchor = plan->surfaces[s].shape.anchor_mm;
    const struct lx_seen_run gathered = lx_seen_gather(plan, seen, s, count);
    const struct lx_block_double *block = &seen->block;
    for (size_t k = 0; k < gathered.count; k++) {
        const struct seen_element element = {
            .place_mm = {anchor[0] + block->px[k], anchor[1] + block->py[k], anchor[2] + block->pz[k]},
            .normal = {block->nx[k], block->ny[k], block->nz[k]},
            .surface = &plan->prepared->surfaces[s]};
        show(work, pixel + (gathered.first < LX_BLOCK ? gathered.first + k : seen->place[k]), &element);
    }
    return gathered.count;
}

/* Looks through `count` pixels of a row from `column` on. */
static void look_through(const struct looking *work, struct sight *sight, unsigned row, unsigned column, size_t count)
{
    const struct lx_plan *plan = &work->session->plan;
    const struct lx_screen *screen = &plan->prepared->scene->screen;
    const size_t pixel = (size_t)row * screen->resolution[0] + column;
    for (size_t i = 0; i < lx_padded(count); i++)
        sight->x_mm[i] = lx_column_x_mm(screen, column + (unsigned)(i < count ? i : count - 1));
    size_t left = lx_seen_find(plan, &sight->seen, lx_row_y_mm(screen, row), sight->x_mm, count);
    if (left < count)
        clear(work->wanted, pixel, count);
    const size_t all = lx_found_count(&sight->seen.found, sight->seen.is_found, plan->surface_count);
    for (size_t i = 0; left > 0 && i < all; i++)
        left -=
            show_surface(work, &sight->seen, lx_found_at(&sight->seen.found, sight->seen.is_found, i), pixel, count);
}

static void look(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct looking *work = data;
    const unsigned columns = work->session->prepared.scene->screen.resolution[0];
    for (unsigned row = first; row < last; row++)
        for (unsigned column = 0; column < columns; column += LX_BLOCK) {
            const unsigned left = columns - column;
            look_through(work, work->sights[worker], row, column, left < LX_BLOCK ? left : LX_BLOCK);
            if (!lx_control_goes_on(work->control, is_caller))
                return;
        }
}

/* The pixels that are worth a thread. */
static const double PIXELS_OF_A_THREAD = 16384;

static luxel_status look_by_threads(struct looking *work, luxel_diagnostics *diagnostics)
{
    const luxel_settings *settings = &work->session->settings;
    const unsigned *size = work->session->prepared.scene->screen.resolution;
    struct lx_control control = {.rows = size[1], .progress = settings->progress, .data = settings->progress_data};
    const double most = (double)size[0] * size[1] / PIXELS_OF_A_THREAD;
    const unsigned threads = lx_thread_count(settings->threads, (unsigned)(most < 1e6 ? most : 1e6) + 1);
    work->control = &control;
    work->sights = lx_new_array(threads, sizeof *work->sights);
    bool complete = work->sights != NULL;
    for (unsigned i = 0; complete && i < threads; i++) {
        work->sights[i] = lx_new_aligned(1, sizeof **work->sights);
        complete = work->sights[i] != NULL;
        if (complete)
            lx_seen_init(&work->session->plan, &work->sights[i]->seen);
    }
    const luxel_status status = !complete                                    ? lx_out_of_memory(diagnostics)
                                : lx_rows_run(&control, threads, look, work) ? LUXEL_OK
                                                                             : LUXEL_CANCELLED;
    for (unsigned i = 0; work->sights && i < threads; i++)
        free(work->sights[i]);
    free(work->sights);
    return status;
}

luxel_status luxel_find_geometry(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, const luxel_geometry *geometry)
{
    if (!geometry)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("geometry"));
    luxel_status status = LX_CHECK_RESERVE(geometry, diagnostics);
    if (status != LUXEL_OK)
        return status;
    struct lx_session session;
    status = lx_session_open_world(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, diagnostics);
    if (status == LUXEL_OK) {
        status = lx_plan_sight(&session.prepared, session.kernels, &session.settings, &session.plan);
        if (status == LUXEL_ERROR_MEMORY)
            lx_out_of_memory(diagnostics);
    }
    struct looking work = {.session = &session, .wanted = geometry};
    if (status == LUXEL_OK)
        status = look_by_threads(&work, diagnostics);
    lx_session_clear(&session);
    return status;
}

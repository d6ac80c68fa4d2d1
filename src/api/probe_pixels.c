/* SPDX-License-Identifier: MIT */
/* Shading the tiles and panels in which the pixels of probes lie. */
#include "probe_pixels.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/rows.h"
#include "../picture/polynomial/panels.h"
#include "../world/camera.h"
#include "reflecting.h"

/* A pixel that is wanted: the tile it lies in, by the place of that in the picture, and whose probe it is. */
struct wanted {
    unsigned top, left;
    luxel_probe *probe;
};

/* Scratch memory of one thread. */
struct scratch {
    struct lx_shader_memory *shader;
    struct lx_panels_memory *panels;
};

struct pixels {
    const struct lx_session *session;
    struct lx_control *control;
    unsigned width, height; /* of a tile */
    struct wanted *wanted;  /* tile by tile, row by row */
    size_t *first;          /* of each tile, and behind the last */
    struct scratch *scratch;
    atomic_bool failed;
};

/* The pixels of a tile, which its values may depend on. */
struct neighbourhood {
    unsigned first, top, columns, rows;
    double x_mm[LX_BLOCK], y_mm[LX_PANEL_SIDE];
};

static struct neighbourhood neighbourhood_of(const struct pixels *pixels, const struct wanted *wanted)
{
    const struct lx_screen *screen = &pixels->session->prepared.scene->screen;
    struct neighbourhood made = {.first = wanted->left, .top = wanted->top};
    const unsigned columns = screen->resolution[0] - made.first, rows = screen->resolution[1] - made.top;
    made.columns = columns < pixels->width ? columns : pixels->width;
    made.rows = rows < pixels->height ? rows : pixels->height;
    for (unsigned i = 0; i < made.columns; i++)
        made.x_mm[i] = lx_column_x_mm(screen, made.first + i);
    for (unsigned j = 0; j < made.rows; j++)
        made.y_mm[j] = lx_row_y_mm(screen, made.top + j);
    return made;
}

static void set_value(luxel_probe *probe, double value)
{
    probe->pixel_value = value;
    probe->has_pixel_value = isfinite(value);
}

/* Each row of the tile that has a wanted pixel is shaded once. */
static void shade_tile(const struct pixels *pixels, const struct scratch *scratch, const struct wanted *first,
                       const struct wanted *end)
{
    const struct lx_session *session = pixels->session;
    const struct lx_plan *plan = &session->plan;
    const struct neighbourhood tile = neighbourhood_of(pixels, first);
    const bool in_double = session->settings.precision == LUXEL_DOUBLE;
    double values[LX_BLOCK];
    float singles[LX_BLOCK];
    uint8_t mask[LX_BLOCK];
    unsigned shaded = tile.rows;
    lx_shader_enter(plan, scratch->shader, tile.y_mm, tile.rows, tile.x_mm, tile.columns);
    for (const struct wanted *at = first; at < end; at++) {
        const unsigned row = at->probe->row - tile.top, column = at->probe->column - tile.first;
        if (row != shaded && in_double)
            lx_shade_row(plan, scratch->shader, row, NULL, false, values, mask);
        else if (row != shaded)
            lx_shade_row_single(plan, scratch->shader, row, NULL, false, singles, mask);
        shaded = row;
        set_value(at->probe, in_double ? values[column] : (double)singles[column]);
    }
}

static void shade_panel(const struct pixels *pixels, const struct scratch *scratch, const struct wanted *first,
                        const struct wanted *end)
{
    float values[LX_PANEL_SIDE * LX_PANEL_SIDE];
    uint8_t mask[LX_PANEL_SIDE * LX_PANEL_SIDE];
    unsigned shown[LX_PANEL_SIDE];
    const struct neighbourhood panel = neighbourhood_of(pixels, first);
    struct lx_control control = {.rows = 1};
    const struct lx_picture_part canvas = {panel.first, panel.top, panel.x_mm, panel.y_mm, values, mask, LX_PANEL_SIDE};
    lx_shade_panels(&pixels->session->plan, scratch->panels, scratch->shader, &control, false, &canvas, panel.top,
                    panel.first, 1, shown);
    for (const struct wanted *at = first; at < end; at++)
        set_value(at->probe,
                  (double)values[(at->probe->row - panel.top) * LX_PANEL_SIDE + at->probe->column - panel.first]);
}

/* The scratch memory of a worker, made when it is first needed; NULL: it cannot be had. */
static const struct scratch *scratch_of(const struct pixels *pixels, unsigned worker)
{
    const struct lx_plan *plan = &pixels->session->plan;
    struct scratch *scratch = &pixels->scratch[worker];
    if (!scratch->shader)
        scratch->shader = lx_shader_memory_new(plan);
    if (scratch->shader && plan->in_panels && !scratch->panels)
        scratch->panels = lx_panels_memory_new(plan);
    return scratch->shader && (scratch->panels || !plan->in_panels) ? scratch : NULL;
}

/* Adds what surfaces reflect to the pixels, each as in its row of the picture. */
static luxel_status reflect(const struct pixels *pixels, size_t count)
{
    const struct lx_session *session = pixels->session;
    const struct lx_screen *screen = &session->prepared.scene->screen;
    struct lx_shader_memory *memory = lx_shader_memory_new(&session->plan);
    const uint8_t shown = 1;
    for (size_t i = 0; memory && i < count; i++) {
        luxel_probe *probe = pixels->wanted[i].probe;
        const double x_mm = lx_column_x_mm(screen, probe->column);
        float single = (float)probe->pixel_value;
        const bool in_double = session->settings.precision == LUXEL_DOUBLE;
        const struct lx_lit_row row = {.y_mm = lx_row_y_mm(screen, probe->row),
                                       .x_mm = &x_mm,
                                       .count = 1,
                                       .values = in_double ? (void *)&probe->pixel_value : &single,
                                       .mask = &shown};
        if (!probe->has_pixel_value)
            continue;
        lx_reflect_row(session, memory, &row);
        if (!in_double)
            probe->pixel_value = (double)single;
    }
    lx_shader_memory_free(memory);
    return memory ? LUXEL_OK : LUXEL_ERROR_MEMORY;
}

/* For the pool a tile is a row. */
static void shade_tiles(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct pixels *pixels = data;
    const struct scratch *scratch = scratch_of(pixels, worker);
    if (!scratch)
        atomic_store(&pixels->failed, true);
    for (unsigned i = first; scratch && i < last && lx_control_goes_on(pixels->control, is_caller); i++) {
        const struct wanted *from = pixels->wanted + pixels->first[i], *end = pixels->wanted + pixels->first[i + 1];
        if (scratch->panels)
            shade_panel(pixels, scratch, from, end);
        else
            shade_tile(pixels, scratch, from, end);
        atomic_fetch_add(&pixels->control->rows_done, (unsigned)(end - from));
    }
}

static int compare_wanted(const void *left, const void *right)
{
    const struct wanted *a = left, *b = right;
    if (a->top != b->top)
        return a->top < b->top ? -1 : 1;
    if (a->left != b->left)
        return a->left < b->left ? -1 : 1;
    return a->probe->row < b->probe->row ? -1 : a->probe->row > b->probe->row;
}

/* Finds the wanted pixels and their tiles; false: memory ran out. */
static bool find_tiles(struct pixels *pixels, luxel_probe *probes, size_t count, unsigned *tiles)
{
    size_t found = 0;
    *tiles = 0;
    pixels->wanted = lx_new_array(count, sizeof *pixels->wanted);
    pixels->first = lx_new_array(count + 1, sizeof *pixels->first);
    if (!pixels->wanted || !pixels->first)
        return false;
    for (size_t i = 0; i < count; i++)
        if (probes[i].on_surface && probes[i].has_pixel)
            pixels->wanted[found++] = (struct wanted){probes[i].row / pixels->height * pixels->height,
                                                      probes[i].column / pixels->width * pixels->width, &probes[i]};
    qsort(pixels->wanted, found, sizeof *pixels->wanted, compare_wanted);
    for (size_t i = 0; i < found; i++)
        if (i == 0 || pixels->wanted[i].top != pixels->wanted[i - 1].top ||
            pixels->wanted[i].left != pixels->wanted[i - 1].left)
            pixels->first[(*tiles)++] = i;
    pixels->first[*tiles] = found;
    return true;
}

luxel_status lx_probe_pixels(const struct lx_session *session, struct lx_control *control, luxel_probe *probes,
                             size_t count)
{
    const struct lx_plan *plan = &session->plan;
    const unsigned columns = session->prepared.scene->screen.resolution[0];
    struct pixels pixels = {
        .session = session,
        .control = control,
        .width = plan->in_panels ? LX_PANEL_SIDE : lx_tile_columns(plan, columns),
        .height = plan->in_panels ? LX_PANEL_SIDE : LX_TILE_ROWS,
    };
    unsigned tiles = 0;
    luxel_status status = find_tiles(&pixels, probes, count, &tiles) ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    const unsigned threads = lx_thread_count(session->settings.threads, tiles);
    if (status == LUXEL_OK && tiles > 0) {
        const struct lx_rows_part part = {
            .last = tiles, .tile_rows = 1, .counts_itself = true, .work = shade_tiles, .data = &pixels};
        pixels.scratch = lx_new_array(threads, sizeof *pixels.scratch);
        if (!pixels.scratch)
            status = LUXEL_ERROR_MEMORY;
        else if (!lx_rows_run_part(control, threads, &part))
            status = LUXEL_CANCELLED;
        else if (atomic_load(&pixels.failed))
            status = LUXEL_ERROR_MEMORY;
    }
    if (status == LUXEL_OK && session->world.reflected)
        status = reflect(&pixels, pixels.first[tiles]);
    for (unsigned i = 0; pixels.scratch && i < threads; i++) {
        lx_panels_memory_free(pixels.scratch[i].panels);
        lx_shader_memory_free(pixels.scratch[i].shader);
    }
    free(pixels.scratch);
    free(pixels.wanted);
    free(pixels.first);
    return status;
}

/* SPDX-License-Identifier: MIT */
/*
 * The plan's pixels, row by row in parallel, strip by strip, and their statistics.
 *
 * Where a strip is not the whole picture two are in memory: while one is computed, the calling thread first hands on
 * the one before.
 */
#include "rendering.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../picture/effort.h"
#include "../scene/lit.h"
#include "reflecting.h"

/* The row's pixels off the surfaces are 0, and no other is below. */
static struct lx_row_statistics look_over_row(const struct lx_rendering *rendering, unsigned row, size_t surface_pixels)
{
    const struct luxel_field *field = rendering->field;
    const struct lx_strip *strip = &rendering->computed->strip;
    const struct lx_kernels *kernels = rendering->plan->kernels;
    const size_t first = (size_t)(row - strip->first) * field->columns;
    const struct lx_survey survey =
        field->precision == LUXEL_DOUBLE
            ? kernels->survey_double((const double *)strip->values + first, field->columns, LX_LEAST_LIT)
            : kernels->survey_single((const float *)strip->values + first, field->columns, LX_LEAST_LIT);
    if (isnan(survey.sum))
        return lx_gather_row(field, strip, row);
    return (struct lx_row_statistics){
        .maximum = survey.maximum,
        .minimum = survey.minimum,
        .surface_pixels = surface_pixels,
        .lit_pixels = survey.at_least,
        .sum = survey.sum,
        .reached = HUGE_VAL,
    };
}

/* Adds what surfaces reflect to a row of direct light. */
static void reflect_row(struct lx_rendering *rendering, unsigned worker, unsigned row)
{
    const struct luxel_field *field = rendering->field;
    const struct lx_strip *strip = &rendering->computed->strip;
    const size_t size = field->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float);
    const size_t first = (size_t)(row - strip->first) * field->columns;
    const struct lx_lit_row lit = {.y_mm = field->y_mm[row],
                                   .x_mm = field->x_mm,
                                   .count = field->columns,
                                   .values = (char *)strip->values + first * size,
                                   .mask = strip->mask + first};
    rendering->computed->reflected_errors[row - strip->first] =
        lx_reflect_row(rendering->session, rendering->memories[worker], &lit);
}

/* Finishes a row, and all that is gathered of it. */
static void survey_row(struct lx_rendering *rendering, unsigned worker, unsigned row, size_t surface_pixels)
{
    const struct lx_strip *strip = &rendering->computed->strip;
    if (rendering->computed->reflected_errors)
        reflect_row(rendering, worker, row);
    struct lx_row_statistics *gathered = &rendering->computed->rows[row - strip->first];
    *gathered = look_over_row(rendering, row, surface_pixels);
    lx_reaching_row(&rendering->reaching, worker, rendering->field, strip, row, gathered);
}

/* Computes a row, from `column` on, of the tile that was entered, whose first row is `top`; returns how many of its
 * `count` pixels show a surface. */
static size_t render_row(struct lx_rendering *rendering, struct lx_shader_memory *memory, bool is_caller, unsigned top,
                         unsigned row, unsigned column, unsigned count)
{
    struct lx_control *control = &rendering->control;
    const struct luxel_field *field = rendering->field;
    const struct lx_strip *strip = &rendering->computed->strip;
    const size_t first = (size_t)(row - strip->first) * field->columns + column;
    uint8_t *mask = strip->mask + first;
    if (field->precision == LUXEL_SINGLE)
        return lx_shade_row_single(rendering->plan, memory, row - top, control, is_caller,
                                   (float *)strip->values + first, mask);
    _Alignas(64) double values[LX_BLOCK];
    const size_t shown = lx_shade_row(rendering->plan, memory, row - top, control, is_caller, values, mask);
    memcpy((double *)strip->values + first, values, count * sizeof *values);
    return shown;
}

/* Rows of panels, which threads render piece by piece: how many pieces are not rendered yet, and how many pixels of
 * each row of a piece show a surface. */
struct lx_panel_rows {
    atomic_uint left;
};
struct lx_render_piece {
    unsigned shown[LX_PANEL_SIDE];
};

/* How many panels side by side are a piece: as many as have pixels in a block together, but where there are highlights
 * of extended sources one.  Runs of elements have their samples in common, which must not depend on what stands beside
 * the panel that a probe looks at; and where highlights are left to pixels one panel is work enough. */
static unsigned panels_of_piece(const struct lx_plan *plan)
{
    return plan->has_gloss ? 1 : LX_BLOCK / LX_PANEL_SIDE;
}

static unsigned pieces_across(const struct lx_rendering *rendering)
{
    const unsigned width = panels_of_piece(rendering->plan) * LX_PANEL_SIDE;
    return (rendering->field->columns + width - 1) / width;
}

static unsigned panel_rows_of(const struct lx_strip *strip)
{
    return (strip->rows + LX_PANEL_SIDE - 1) / LX_PANEL_SIDE;
}

/* Renders one piece of a strip; whoever renders the last of a row of panels gathers what the rows have. */
static void render_piece(void *data, unsigned worker, bool is_caller, unsigned piece, unsigned next)
{
    struct lx_rendering *rendering = data;
    const struct luxel_field *field = rendering->field;
    const struct lx_strip *strip = &rendering->computed->strip;
    const struct lx_picture_part canvas = {
        .top = strip->first,
        .x_mm = field->x_mm,
        .y_mm = field->y_mm + strip->first,
        .values = strip->values,
        .mask = strip->mask,
        .stride = field->columns,
    };
    const unsigned panels = panels_of_piece(rendering->plan);
    const unsigned across = pieces_across(rendering), down = piece / across * LX_PANEL_SIDE, left = strip->rows - down;
    const unsigned first = strip->first + down, rows = left < LX_PANEL_SIDE ? left : LX_PANEL_SIDE;
    (void)next;
    lx_shade_panels(rendering->plan, rendering->panels[worker], rendering->memories[worker], &rendering->control,
                    is_caller, &canvas, first, piece % across * panels * LX_PANEL_SIDE, panels,
                    rendering->pieces[piece].shown);
    if (atomic_fetch_sub(&rendering->panel_rows[piece / across].left, 1) > 1)
        return;
    for (unsigned r = 0; r < rows && lx_control_goes_on(&rendering->control, is_caller); r++) {
        size_t shown = 0;
        for (unsigned i = 0; i < across; i++)
            shown += rendering->pieces[piece / across * across + i].shown[r];
        survey_row(rendering, worker, first + r, shown);
    }
    atomic_fetch_add(&rendering->control.rows_done, rows);
}

/* Renders rows first to last - 1, no more than a tile has, tile by tile. */
static void render_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct lx_rendering *rendering = data;
    struct lx_shader_memory *memory = rendering->memories[worker];
    const struct luxel_field *field = rendering->field;
    size_t shown[LX_TILE_ROWS] = {0};
    const unsigned width = lx_tile_columns(rendering->plan, field->columns);
    _Static_assert((int)LX_ROWS_AT_ONCE == (int)LX_TILE_ROWS, "a thread takes the rows of whole tiles");
    for (unsigned column = 0; column < field->columns; column += width) {
        unsigned left = field->columns - column, count = left < width ? left : width;
        lx_shader_enter(rendering->plan, memory, field->y_mm + first, last - first, field->x_mm + column, count);
        for (unsigned row = first; row < last; row++) {
            shown[row - first] += render_row(rendering, memory, is_caller, first, row, column, count);
            if (!lx_control_goes_on(&rendering->control, is_caller))
                return;
        }
    }
    for (unsigned row = first; row < last; row++)
        survey_row(rendering, worker, row, shown[row - first]);
}

/* A thread begins some 50 us after it is wanted, half of which the caller is busy with it: it pays from twice as much
 * work on.  Who asks for threads gets them, but for tiny pictures. */
unsigned lx_rendering_threads(const struct lx_session *session, const struct luxel_field *field)
{
    const double pixels = (double)field->columns * field->rows, work_ns = 120e3, most = UINT_MAX - 1;
    const double paying =
        session->settings.threads > 0 ? pixels / 8192 : pixels * lx_effort_of_pixel_ns(&session->plan) / work_ns;
    return lx_thread_count(session->settings.threads, (unsigned)fmin(paying, most) + 1);
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
 * The field's record of where it came from.  A scene that nobody wants (NULL) is left out, and that of a quick look,
 * which is not its picture, or of a scene whose text is behind its numbers.
 */
static luxel_status keep_origin(const struct lx_session *session, const luxel_scene *scene,
                                luxel_diagnostics *diagnostics, struct luxel_field *field)
{
    const luxel_settings *settings = &session->settings;
    const char *unit = lx_unit_of(&session->prepared, settings->quantity);
    field->quantity = settings->quantity;
    field->tolerance = settings->tolerance;
    field->light_error = settings->light_error;
    field->reflected_error = lx_wants_reflections(session->prepared.scene) ? settings->reflected_error : 0;
    field->instruction_set = session->kernels->name;
    field->quantity_word = lx_quantity_word(settings->quantity, session->prepared.scene->units == LX_PHOTOMETRIC);
    field->unit = lx_copy_text(unit, strlen(unit));
    if (!field->unit)
        return lx_out_of_memory(diagnostics);
    if (!scene || settings->stride > 1 || lx_scene_is_ahead(scene))
        return LUXEL_OK;
    luxel_scene *lit;
    const luxel_status status = lx_scene_lit(scene, settings, diagnostics, &lit);
    if (status != LUXEL_OK)
        return status;
    field->scene = lx_scene_text_of(lit ? lit : scene);
    luxel_scene_free(lit);
    return field->scene ? LUXEL_OK : lx_out_of_memory(diagnostics);
}

luxel_status lx_new_frame(const struct lx_session *session, const luxel_scene *scene, luxel_diagnostics *diagnostics,
                          struct luxel_field **frame)
{
    unsigned stride = session->settings.stride > 1 ? session->settings.stride : 1;
    *frame = lx_field_new_frame(session->prepared.scene, stride, session->settings.precision);
    return *frame ? keep_origin(session, scene, diagnostics, *frame) : lx_out_of_memory(diagnostics);
}

/* Makes room to hold `height` rows at a time.  Whether there is so much is asked only of what is not little: the system
 * takes as long to tell as a small picture takes in all. */
static luxel_status hold(struct lx_rendering *rendering, unsigned height)
{
    const double little = 32e6;
    const struct luxel_field *field = rendering->field;
    const unsigned size[2] = {field->columns, field->rows};
    const double needed = (double)lx_field_bytes(field->columns, height, field->precision);
    const double available = needed <= little ? HUGE_VAL : lx_available_bytes();
    if (needed == 0 || needed > available)
        return too_large(size, needed, available, rendering->diagnostics);
    bool complete = true;
    for (size_t i = 0; i < (height < field->rows ? 2 : 1); i++) {
        struct lx_held *held = &rendering->held[i];
        held->strip.rows = height;
        held->rows = lx_new_array(height, sizeof *held->rows);
        if (rendering->session->world.reflected)
            held->reflected_errors = lx_new_array(height, sizeof *held->reflected_errors);
        complete = complete && held->rows && (held->reflected_errors || !rendering->session->world.reflected) &&
                   lx_strip_allocate(field, &held->strip) == 0;
    }
    return complete ? LUXEL_OK : too_large(size, needed, needed < available ? 0 : available, rendering->diagnostics);
}

/* The pixels of a quick look are too far from each other for panels. */
static luxel_status make_memories(struct lx_rendering *rendering, bool is_quick_look)
{
    const unsigned rows = panel_rows_of(&rendering->held->strip);
    rendering->memories = lx_new_array(rendering->threads, sizeof *rendering->memories);
    bool complete = rendering->memories != NULL;
    if (rendering->plan->in_panels && !is_quick_look) {
        rendering->panels = lx_new_array(rendering->threads, sizeof *rendering->panels);
        rendering->panel_rows = lx_new_array(rows, sizeof *rendering->panel_rows);
        rendering->pieces = lx_new_array((size_t)rows * pieces_across(rendering), sizeof *rendering->pieces);
        complete = complete && rendering->panels && rendering->panel_rows && rendering->pieces;
    }
    for (unsigned i = 0; complete && i < rendering->threads; i++) {
        complete = (rendering->memories[i] = lx_shader_memory_new(rendering->plan)) != NULL;
        if (complete && rendering->panels)
            complete = (rendering->panels[i] = lx_panels_memory_new(rendering->plan)) != NULL;
    }
    return complete ? LUXEL_OK : lx_out_of_memory(rendering->diagnostics);
}

luxel_status lx_rendering_open(struct lx_rendering *rendering, const struct lx_session *session,
                               struct luxel_field *field, unsigned height, luxel_diagnostics *diagnostics)
{
    const luxel_settings *settings = &session->settings;
    *rendering = (struct lx_rendering){
        .session = session,
        .plan = &session->plan,
        .field = field,
        .diagnostics = diagnostics,
        .threads = lx_rendering_threads(session, field),
        .control = {.rows = field->rows,
                    .progress = settings->progress,
                    .data = settings->progress_data,
                    .before = session->done},
    };
    luxel_status status = hold(rendering, height);
    if (status == LUXEL_OK)
        status = make_memories(rendering, settings->stride > 1);
    if (status == LUXEL_OK)
        status = lx_reaching_open(&rendering->reaching, session, rendering->threads, diagnostics);
    return status;
}

static luxel_status check_range(const struct luxel_field *field, const luxel_extremum *maximum,
                                luxel_diagnostics *diagnostics)
{
    if (!maximum->exists || isfinite(maximum->value))
        return LUXEL_OK;
    bool single = field->precision == LUXEL_SINGLE;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_VALUE_TOO_LARGE, LX_ARGS(single ? "single" : "double"));
    lx_hint(diagnostics, single ? LX_MSG_USE_DOUBLE : LX_MSG_LOWER_STRENGTHS, NULL);
    return LUXEL_ERROR_RANGE;
}

double lx_share_of_maximum(const luxel_statistics *statistics, double error)
{
    const double maximum = statistics->maximum.exists ? statistics->maximum.value : 0;
    return !(error > 0) ? 0 : maximum > 0 ? error / maximum : HUGE_VAL;
}

void lx_report_mirrored_error(const luxel_scene *scene, const luxel_statistics *statistics,
                              luxel_diagnostics *diagnostics)
{
    char most[LX_NUMBER_SIZE], error[LX_NUMBER_SIZE];
    const bool is_bounded = statistics->mirrored_error < HUGE_VAL;
    if (!(statistics->mirrored_error > 0))
        return;
    lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, is_bounded ? LX_MSG_PICTURE_OF_MIRRORS : LX_MSG_MIRRORS_UNKNOWN,
              LX_ARGS(lx_write_number(lx_scene_parameters(scene)->mirrors, most),
                      lx_write_bound(statistics->mirrored_error, 2, error)));
    lx_hint(diagnostics, is_bounded ? LX_MSG_HINT_MORE_MIRRORS : LX_MSG_HINT_PROBES_OF_MIRRORS, NULL);
}

/* What is not known of light over more mirrors than are counted, of all pixels, which threads have shaded by now. */
static double mirrored_error_of(const struct lx_rendering *rendering)
{
    double error = 0;
    for (unsigned i = 0; i < rendering->threads; i++)
        error = fmax(error, lx_shader_mirrored_error(rendering->memories[i]));
    return lx_share_of_maximum(&rendering->field->statistics, error);
}

static void finish_statistics(struct lx_rendering *rendering)
{
    luxel_statistics *statistics = &rendering->field->statistics;
    *statistics = lx_tally_finish(&rendering->tally);
    if (rendering->reaching.is_plain)
        statistics->minimum_reached = statistics->minimum;
    statistics->mirrored_error = mirrored_error_of(rendering);
    if (!rendering->session->world.reflected)
        return;
    const double maximum = statistics->maximum.exists ? statistics->maximum.value : 0;
    statistics->has_reflected = true;
    statistics->reflected_error = maximum > 0 ? rendering->reflected_error / maximum : 0;
    statistics->reflected_reached = statistics->reflected_error <= lx_pictured_error_of(&rendering->session->settings);
    if (statistics->reflected_reached)
        return;
    char error[LX_NUMBER_SIZE];
    lx_report(rendering->diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_REFLECTED_ERROR,
              LX_ARGS(lx_write_bound(statistics->reflected_error, 2, error)));
    lx_hint_overlap(rendering->session->world.reflected, &rendering->session->prepared, rendering->diagnostics);
}

/* Takes the rows that are finished into the statistics and hands them on. */
static void put_away(void *data)
{
    struct lx_rendering *rendering = data;
    struct luxel_field *field = rendering->field;
    const struct lx_strip *strip = &rendering->finished->strip;
    lx_tally_add(&rendering->tally, field, strip, rendering->finished->rows);
    for (unsigned i = 0; rendering->finished->reflected_errors && i < strip->rows; i++)
        rendering->reflected_error = fmax(rendering->reflected_error, rendering->finished->reflected_errors[i]);
    rendering->status = check_range(field, &rendering->tally.so_far.maximum, rendering->diagnostics);
    if (rendering->status != LUXEL_OK) {
        atomic_store(&rendering->control.stop, true);
        return;
    }
    if (strip->first + strip->rows == field->rows)
        finish_statistics(rendering);
    if (rendering->take)
        rendering->take(rendering->take_data, strip);
}

/* The strip that is computed as work for threads. */
static struct lx_rows_part part_of(struct lx_rendering *rendering)
{
    const struct lx_strip *strip = &rendering->computed->strip;
    struct lx_rows_part part = {.first = strip->first,
                                .last = strip->first + strip->rows,
                                .tile_rows = rendering->plan->trees.tree_count > 0 ? LX_TILE_ROWS : 0,
                                .work = render_rows,
                                .meanwhile = rendering->finished ? put_away : NULL,
                                .data = rendering};
    if (!rendering->panels)
        return part;
    part.first = 0;
    part.last = panel_rows_of(strip) * pieces_across(rendering);
    for (unsigned i = 0; i < panel_rows_of(strip); i++)
        atomic_init(&rendering->panel_rows[i].left, pieces_across(rendering));
    part.tile_rows = 1;
    part.counts_itself = true;
    part.work = render_piece;
    return part;
}

luxel_status lx_rendering_run(struct lx_rendering *rendering)
{
    const unsigned rows = rendering->field->rows, height = rendering->held[0].strip.rows;
    for (unsigned first = 0; first < rows; first += rendering->computed->strip.rows) {
        const unsigned left = rows - first;
        rendering->computed = &rendering->held[first / height % 2];
        rendering->computed->strip.first = first;
        rendering->computed->strip.rows = left < height ? left : height;
        const struct lx_rows_part part = part_of(rendering);
        if (!lx_rows_run_part(&rendering->control, rendering->threads, &part))
            return rendering->status != LUXEL_OK ? rendering->status : LUXEL_CANCELLED;
        rendering->finished = rendering->computed;
    }
    put_away(rendering);
    return rendering->status;
}

void lx_rendering_clear(struct lx_rendering *rendering)
{
    for (unsigned i = 0; rendering->memories && i < rendering->threads; i++)
        lx_shader_memory_free(rendering->memories[i]);
    for (unsigned i = 0; rendering->panels && i < rendering->threads; i++)
        lx_panels_memory_free(rendering->panels[i]);
    lx_reaching_clear(&rendering->reaching);
    free(rendering->memories);
    free(rendering->panels);
    free(rendering->panel_rows);
    free(rendering->pieces);
    for (size_t i = 0; i < 2; i++) {
        free(rendering->held[i].strip.values);
        free(rendering->held[i].strip.mask);
        free(rendering->held[i].rows);
        free(rendering->held[i].reflected_errors);
    }
}

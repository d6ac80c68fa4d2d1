/* SPDX-License-Identifier: MIT */
/* Measuring grids: the light at the centre of each cell, batch by batch, and what is read off the values. */
#include "grid.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/rows.h"
#include "../light/solid/extended.h"
#include "../scene/scene.h"
#include "../world/evaluate.h"
#include "coloring.h"
#include "grid_measuring.h"
#include "reflecting.h"

void luxel_grid_free(luxel_grid *grid)
{
    if (!grid)
        return;
    free((char *)grid->name);
    free((double *)grid->values);
    free((double *)grid->errors);
    free((uint8_t *)grid->mask);
    free((uint8_t *)grid->inside);
    free((luxel_color *)grid->colors);
    luxel_grid_free(grid->surround);
    luxel_grid_free(grid->background);
    free(grid);
}

size_t luxel_scene_grid_count(const luxel_scene *scene)
{
    return scene && luxel_scene_is_committed(scene) ? lx_scene_parameters(scene)->grids.count : 0;
}

static const struct lx_grid *find_grid(const luxel_scene *scene, size_t i)
{
    return i < luxel_scene_grid_count(scene) ? (const struct lx_grid *)lx_scene_parameters(scene)->grids.items + i
                                             : NULL;
}

const char *luxel_scene_grid_name(const luxel_scene *scene, size_t i)
{
    const struct lx_grid *grid = find_grid(scene, i);
    return grid ? grid->name : NULL;
}

luxel_status luxel_scene_grid_resolution(const luxel_scene *scene, size_t i, unsigned *columns, unsigned *rows)
{
    const struct lx_grid *grid = find_grid(scene, i);
    if (!grid || !columns || !rows)
        return LUXEL_ERROR_ARGUMENT;
    *columns = grid->n[0];
    *rows = grid->n[1];
    return LUXEL_OK;
}

/* The elements at the centres of some cells. */
static void make_elements(const struct lx_measuring *measuring, const unsigned *these, unsigned count,
                          struct lx_elements *elements)
{
    const unsigned columns = measuring->lattice.cells.n[0];
    lx_elements_begin(elements, &measuring->measure.lobe, true);
    for (unsigned i = 0; i < count; i++)
        lx_elements_append_place(elements,
                                 lx_lattice_place(&measuring->lattice, these[i] % columns, these[i] / columns),
                                 measuring->lattice.cells.normal, NULL);
    lx_elements_end(elements);
    lx_world_settle(&measuring->world, &(struct lx_settling){.has_normals = true}, elements);
}

/* Cells that are in no body, and in the area, of some; returns how many. */
static unsigned leave_out(const struct lx_measuring *measuring, unsigned first, unsigned count,
                          unsigned these[LX_BATCH])
{
    const unsigned columns = measuring->lattice.cells.n[0];
    unsigned left = 0;
    for (unsigned cell = first; cell < first + count; cell++)
        if (!(measuring->ring &&
              lx_ring_leaves_out(measuring->ring, &measuring->lattice.cells, cell % columns, cell / columns)) &&
            !lx_body_around_cell(measuring, cell % columns, cell / columns))
            these[left++] = cell;
    return left;
}

/* For the pool a cell is a row; where light takes integrals one alone may be worth a thread. */
static void measure_cells(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct lx_measuring *measuring = data;
    const struct lx_asking asking = {.control = measuring->control, .is_caller = is_caller};
    struct lx_elements elements;
    struct lx_received received;
    (void)worker;
    for (unsigned cell = first; cell < last && lx_asking_goes_on(&asking); cell += LX_BATCH) {
        unsigned these[LX_BATCH];
        const unsigned count = leave_out(measuring, cell, last - cell < LX_BATCH ? last - cell : LX_BATCH, these);
        if (count == 0)
            continue;
        make_elements(measuring, these, count, &elements);
        lx_plane_light(&measuring->world, &measuring->measure, &elements, &asking, &received);
        for (unsigned i = 0; i < count; i++) {
            if (received.on_element[i])
                continue;
            const lx_bounded irradiance = lx_received_on_plane(&measuring->world, &received, i);
            measuring->mask[these[i]] = 1;
            measuring->values[these[i]] = irradiance.value;
            measuring->errors[these[i]] = lx_reported(irradiance).error;
        }
    }
}

bool lx_measure_lattice(struct lx_measuring *measuring, bool counts_itself)
{
    const struct lx_cells *cells = &measuring->lattice.cells;
    const struct lx_rows_part part = {.last = cells->n[0] * cells->n[1],
                                      .tile_rows = lx_world_batch(&measuring->world),
                                      .counts_itself = counts_itself,
                                      .work = measure_cells,
                                      .data = measuring};
    return lx_rows_run_part(measuring->control, measuring->threads, &part);
}

/* The light that lies on a cell. */
static size_t light_on(const struct lx_measuring *measuring, size_t cell)
{
    struct lx_elements elements;
    make_elements(measuring, &(unsigned){(unsigned)cell}, 1, &elements);
    for (size_t next = 0; next < measuring->world.prepared->emitters.count;) {
        struct lx_emitter room;
        const size_t light = lx_emitter_at(&measuring->world.prepared->emitters, next, &room)->light;
        struct lx_received received;
        lx_world_light_of(&measuring->world, &elements, light, LX_WANT_IRRADIANCE, NULL, &next, &received);
        if (received.on_element[0])
            return light;
    }
    return 0;
}

static void note_extremum(const struct lx_measuring *measuring, size_t cell, luxel_grid_extremum *extremum)
{
    unsigned columns = measuring->made->grid.columns;
    extremum->value = measuring->values[cell];
    extremum->column = (unsigned)(cell % columns);
    extremum->row = (unsigned)(cell / columns);
    luxel_grid_position(&measuring->made->grid, extremum->column, extremum->row, extremum->position_mm);
}

/* Average and extrema, in row order.  The sum is wide, so that it adds nothing to the error of many cells. */
static void gather(const struct lx_measuring *measuring)
{
    luxel_grid *grid = &measuring->made->grid;
    size_t cells = (size_t)grid->columns * grid->rows, least = cells, greatest = cells, blocked = 0;
    lx_wide sum = lx_wide_of(0), errors = lx_wide_of(0);
    for (size_t i = 0; i < cells; i++) {
        if (!measuring->mask[i]) {
            if (!grid->inside[i] && blocked++ == 0)
                grid->blocking_light = light_on(measuring, i);
            continue;
        }
        double value = measuring->values[i];
        grid->measured++;
        sum = lx_wide_add(sum, lx_wide_of(value));
        errors = lx_wide_add(errors, lx_wide_of(measuring->errors[i]));
        grid->error = fmax(grid->error, measuring->errors[i]);
        if (least == cells || value < measuring->values[least])
            least = i;
        if (greatest == cells || value > measuring->values[greatest])
            greatest = i;
    }
    if (grid->measured == 0)
        return;
    double count = (double)grid->measured;
    lx_bounded total = {lx_wide_value(sum), 0};
    total.error = isfinite(grid->error) ? lx_wide_value(errors) + LX_ROUNDING * (1 + 0x1p-20) * total.value : HUGE_VAL;
    grid->average = lx_div((lx_bounded){total.value, total.error * LX_BOUND_SLACK}, lx_exact(count));
    note_extremum(measuring, least, &grid->minimum);
    note_extremum(measuring, greatest, &grid->maximum);
}

/* Whether some light has no closed form, so that its share is an integral to a tolerance. */
static bool integrates(const struct lx_emitters *emitters)
{
    for (size_t i = 0; i < lx_item_count(emitters); i++)
        if (lx_is_dome(&emitters->items[i]) ||
            (lx_is_extended(&emitters->items[i]) && !lx_has_closed_form(&emitters->items[i])))
            return true;
    return false;
}

/* What all of an opening would bring to a place as a point, no nearer than it is large. */
static double opening_around(const struct lx_emitter *emitter, lx_bounded3 place)
{
    const double *center = lx_emitter_center(emitter), size = lx_emitter_radius(emitter);
    const struct lx_emitter point = lx_extended_as_point(emitter);
    if (lx_length3(lx_sub3(lx_exact3(center), place)).value < size)
        place = lx_exact3((const double[]){center[0] + size, center[1], center[2]});
    return lx_emitter_sample(&point, place).e_perp.value;
}

/* What the lights bring to a cell, however it is turned: E_perp, and of extended ones pi times the radiance. */
static double light_around(const struct lx_measuring *measuring, size_t cell)
{
    unsigned columns = measuring->made->grid.columns;
    lx_bounded3 place = lx_lattice_place(&measuring->lattice, (unsigned)(cell % columns), (unsigned)(cell / columns));
    double sum = 0;
    for (size_t i = 0; i < measuring->world.prepared->emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&measuring->world.prepared->emitters, i, &room);
        sum += lx_is_opening(emitter)    ? opening_around(emitter, place)
               : lx_is_extended(emitter) ? M_PI * emitter->radiance.value
                                         : lx_emitter_sample(emitter, place).e_perp.value;
    }
    return sum;
}

/* What the error of a cell is compared with.  That of a dark one may be the rounding of a cosine. */
static double size_of(const struct lx_measuring *measuring, size_t cell)
{
    double value = measuring->values[cell], maximum = measuring->made->grid.maximum.value;
    return value > measuring->errors[cell] ? value : maximum > 0 ? maximum : light_around(measuring, cell);
}

static bool reaches(const struct lx_measuring *measuring, bool is_asked_for)
{
    const luxel_grid *grid = &measuring->made->grid;
    size_t cells = (size_t)grid->columns * grid->rows;
    if (!is_asked_for && isfinite(grid->error) && !integrates(&measuring->world.prepared->emitters))
        return true;
    for (size_t i = 0; i < cells; i++)
        if (measuring->mask[i] && measuring->errors[i] > DBL_MIN &&
            !(measuring->errors[i] <= measuring->world.prepared->tolerance * size_of(measuring, i)))
            return false;
    return true;
}

/* What is read off the values, and is to be read anew. */
static void forget(luxel_grid *grid)
{
    grid->measured = 0;
    grid->error = 0;
}

static void judge_evenness(luxel_grid *grid)
{
    grid->has_evenness = grid->average.value > 0; /* which a maximum below the normal numbers may leave at 0 */
    if (grid->has_evenness) {
        grid->u0 = grid->minimum.value / grid->average.value;
        grid->ud = grid->minimum.value / grid->maximum.value;
    }
}

static void judge(const struct lx_measuring *measuring, bool is_tolerance_asked_for)
{
    luxel_grid *grid = &measuring->made->grid;
    judge_evenness(grid);
    grid->tolerance_reached = reaches(measuring, is_tolerance_asked_for);
}

static void describe(const struct lx_grid *from, struct lx_measured *made)
{
    luxel_grid *grid = &made->grid;
    made->cells = lx_cells_of(from);
    grid->columns = from->n[0];
    grid->rows = from->n[1];
    memcpy(grid->center_mm, from->center_mm, sizeof grid->center_mm);
    memcpy(grid->size_mm, from->size_mm, sizeof grid->size_mm);
    lx_values3(lx_wide3_direction(made->cells.pose.axis), grid->axis);
    lx_values3(lx_wide3_direction(made->cells.pose.upward), grid->up);
    lx_values3(lx_wide3_direction(made->cells.pose.across), grid->across);
}

static luxel_status too_large(const struct lx_grid *grid, double needed, double available,
                              luxel_diagnostics *diagnostics)
{
    char columns[LX_NUMBER_SIZE], rows[LX_NUMBER_SIZE], need[LX_AMOUNT_SIZE], have[LX_AMOUNT_SIZE];
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_GRID_TOO_LARGE,
              LX_ARGS(lx_write_number(grid->n[0], columns), lx_write_number(grid->n[1], rows),
                      lx_write_amount(needed, need), lx_write_amount(available, have)));
    lx_hint(diagnostics, LX_MSG_SMALLER_GRID, NULL);
    return LUXEL_ERROR_MEMORY;
}

/* The grid without its values, which get their memory. */
static luxel_status new_grid(const struct lx_session *session, const struct lx_grid *from,
                             luxel_diagnostics *diagnostics, struct lx_measuring *measuring)
{
    size_t cells = (size_t)from->n[0] * from->n[1];
    double needed = (double)cells * (2 * sizeof(double) + 2), available = lx_available_bytes();
    if (needed > available || cells > UINT_MAX)
        return too_large(from, needed, available, diagnostics);
    measuring->made = lx_new_array(1, sizeof *measuring->made);
    if (!measuring->made)
        return lx_out_of_memory(diagnostics);
    luxel_grid *grid = &measuring->made->grid;
    grid->values = measuring->values = lx_new_array(cells, sizeof *measuring->values);
    grid->errors = measuring->errors = lx_new_array(cells, sizeof *measuring->errors);
    grid->mask = measuring->mask = lx_new_array(cells, sizeof *measuring->mask);
    grid->inside = measuring->inside = lx_new_array(cells, sizeof *measuring->inside);
    if (from->name)
        grid->name = lx_copy_text(from->name, strlen(from->name));
    if (!grid->values || !grid->errors || !grid->mask || !grid->inside || (from->name && !grid->name))
        return lx_out_of_memory(diagnostics);
    describe(from, measuring->made);
    if (lx_lattice_make(&measuring->made->cells, &measuring->lattice) ||
        lx_bodies_find(&session->prepared, &measuring->made->cells, &measuring->bodies))
        return lx_out_of_memory(diagnostics);
    measuring->measure = lx_plane_measure_of((enum lx_measure)from->measure, &measuring->made->cells);
    lx_find_enclosed_cells(measuring);
    grid->measure = lx_measure_names[from->measure];
    grid->unit = lx_unit_of(&session->prepared, LUXEL_IRRADIANCE);
    return LUXEL_OK;
}

/* ---- reflected light ---- */

/* The element of a cell that has a value, and that. */
static bool element_of(const void *data, size_t cell, struct lx_element *element, double *direct)
{
    const struct lx_measuring *measuring = data;
    struct lx_elements elements;
    if (!measuring->mask[cell])
        return false;
    make_elements(measuring, &(unsigned){(unsigned)cell}, 1, &elements);
    *element = lx_elements_get(measuring->world.prepared, &elements, 0);
    *direct = measuring->values[cell];
    return true;
}

/* Adds what is reflected to a cell. */
static void take_reflected(void *data, size_t cell, lx_bounded light)
{
    struct lx_measuring *measuring = data;
    luxel_grid *grid = &measuring->made->grid;
    const lx_bounded total = lx_add((lx_bounded){measuring->values[cell], measuring->errors[cell]}, light);
    const double error = lx_reported(light).error, allowed = lx_reflected_error_of(measuring->settings) * total.value;
    grid->reflected_average += light.value;
    grid->reflected_error = fmax(grid->reflected_error, error);
    grid->reflected_reached = grid->reflected_reached && error <= fmax(allowed, DBL_MIN);
    measuring->values[cell] = total.value;
    measuring->errors[cell] = lx_reported(total).error;
}

static luxel_status reflect(struct lx_session *session, struct lx_measuring *measuring, luxel_diagnostics *diagnostics)
{
    luxel_grid *grid = &measuring->made->grid;
    const struct lx_reflected_key key = lx_reflected_key_of_plane(session, measuring->number);
    const struct lx_reflecting reflecting = {measuring->control,
                                             (size_t)grid->columns * grid->rows,
                                             element_of,
                                             take_reflected,
                                             measuring,
                                             measuring->slot,
                                             &key,
                                             lx_plane_response(&measuring->measure)};
    const luxel_status status = lx_reflect_places(session, &reflecting, false, diagnostics);
    measuring->world.reflected = session->world.reflected; /* what is measured from now on has it */
    grid->has_reflected = true;
    if (grid->measured > 0)
        grid->reflected_average /= (double)grid->measured;
    return status;
}

static luxel_status run(struct lx_session *session, struct lx_measuring *measuring, luxel_diagnostics *diagnostics)
{
    luxel_grid *grid = &measuring->made->grid;
    const luxel_settings *settings = &session->settings;
    struct lx_control control = {
        .rows = grid->columns * grid->rows, .progress = settings->progress, .data = settings->progress_data};
    measuring->control = &control;
    measuring->threads = lx_thread_count(settings->threads, control.rows / 4 + 1);
    if (!lx_measure_lattice(measuring, false))
        return LUXEL_CANCELLED;
    gather(measuring);
    judge(measuring, settings->tolerance > 0);
    grid->reflected_reached = true;
    if (lx_wants_reflections(measuring->world.prepared->scene)) {
        const luxel_status status = reflect(session, measuring, diagnostics);
        if (status != LUXEL_OK)
            return status;
        forget(grid);
        gather(measuring);
        judge_evenness(grid);
    }
    if (grid->measured > 0 && !isfinite(grid->average.value)) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_VALUE_TOO_LARGE, LX_ARGS("double"));
        lx_hint(diagnostics, LX_MSG_LOWER_STRENGTHS, NULL);
        return LUXEL_ERROR_RANGE;
    }
    if (!measuring->values_alone) {
        if (measuring->measure.measure == LX_MEASURE_PLANE)
            lx_integrate_plane(measuring);
        lx_judge_sampling(measuring);
    }
    return atomic_load(&control.stop) ? LUXEL_CANCELLED : LUXEL_OK;
}

const struct lx_grid *lx_asked_grid(const luxel_scene *scene, size_t i, const void *answer, const char *name,
                                    luxel_diagnostics *diagnostics)
{
    const struct lx_grid *grid = find_grid(scene, i);
    char index[LX_NUMBER_SIZE];
    if (!answer)
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_MISSING_ARGUMENT, LX_ARGS(name));
    else if (!grid)
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_SUCH_GRID,
                  LX_ARGS(lx_write_number((double)i, index)));
    return answer ? grid : NULL;
}

luxel_status lx_measure_cells(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                              const struct lx_wanted_cells *cells, luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    return luxel_scene_has_color(scene) && grid ? lx_measure_in_color(scene, settings, i, cells, diagnostics, grid)
                                                : lx_measure_grey(scene, settings, i, cells, diagnostics, grid);
}

luxel_status lx_measure_as(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                           const struct lx_wanted_cells *cells, const enum lx_measure *measure,
                           luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    const struct lx_area *area = cells ? cells->area : NULL;
    struct lx_session session;
    struct lx_measuring measuring = {.values_alone = cells != NULL, .ring = area ? &area->ring : NULL};
    struct lx_grid wanted;
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    const struct lx_grid *asked = status == LUXEL_OK ? lx_asked_grid(scene, i, grid, "grid", diagnostics) : NULL;
    if (status == LUXEL_OK && !asked)
        status = LUXEL_ERROR_ARGUMENT;
    if (status == LUXEL_OK) {
        measuring.world = session.world;
        measuring.world.reflected = NULL;
        measuring.settings = &session.settings;
        measuring.slot = area ? NULL : lx_scene_reflected_on_plane(scene);
        measuring.number = i;
        wanted = area ? area->grid : *asked;
        if (cells && !area)
            memcpy(wanted.n, cells->n, sizeof wanted.n);
        if (measure)
            wanted.measure = (int)*measure;
        status = new_grid(&session, &wanted, diagnostics, &measuring);
    }
    if (status == LUXEL_OK)
        status = lx_reflect_shared(scene, &session, diagnostics);
    if (status == LUXEL_OK)
        status = run(&session, &measuring, diagnostics);
    lx_lattice_clear(&measuring.lattice);
    lx_bodies_clear(&measuring.bodies);
    lx_session_clear(&session);
    if (status == LUXEL_OK)
        *grid = &measuring.made->grid;
    else if (measuring.made)
        luxel_grid_free(&measuring.made->grid);
    return status;
}

luxel_status lx_measure_grey(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                             const struct lx_wanted_cells *cells, luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    return lx_measure_as(scene, settings, i, cells, NULL, diagnostics, grid);
}

void luxel_grid_position(const luxel_grid *grid, unsigned column, unsigned row, double position_mm[3])
{
    lx_values3(lx_cell_place(&((const struct lx_measured *)grid)->cells, column, row), position_mm);
}

/* SPDX-License-Identifier: MIT */
/* The grid on which isophotes are found: its places, the surfaces seen at its corners, and their exact values. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../world/camera.h"
#include "isophotes.h"

/* -- making it -- */

/* The samples' places, and the screen's edges where they lie outside of them; NULL: memory is short. */
static double *new_places(const double *samples, unsigned count, const double *edges, unsigned *first, unsigned *whole)
{
    /* rounding may leave a sample that is meant to lie on the edge a little beside it */
    double room = edges ? 1e-12 * fabs(edges[1]) : 0;
    bool before = edges && fabs(edges[0] - samples[0]) > room;
    bool behind = edges && fabs(edges[1] - samples[count - 1]) > room;
    double *places = lx_new_array((size_t)count + 2, sizeof *places);
    if (!places)
        return NULL;
    *first = before;
    *whole = count + before + behind;
    if (before)
        places[0] = edges[0];
    memcpy(&places[before], samples, count * sizeof *places);
    if (behind)
        places[*whole - 1] = edges[1];
    return places;
}

/* A box of the screen that holds all that is seen of a surface. */
static void find_box(const struct lx_prepared *prepared, const struct lx_prepared_surface *surface, double box[4])
{
    const struct lx_camera *camera = &prepared->camera;
    double low[3], high[3];
    lx_surface_extent(surface->kind, surface->parameters, &camera->frame, low, high);
    if (camera->is_perspective && !(high[2] < camera->z_mm)) {
        /* it reaches beside the observer, as the walls of a room do, and may be seen anywhere */
        box[0] = box[2] = -HUGE_VAL;
        box[1] = box[3] = HUGE_VAL;
        return;
    }
    box[0] = box[2] = HUGE_VAL;
    box[1] = box[3] = -HUGE_VAL;
    for (int corner = 0; corner < 8; corner++) {
        double z = corner & 4 ? high[2] : low[2];
        double widening = camera->is_perspective ? camera->z_mm / (camera->z_mm - z) : 1;
        for (int axis = 0; axis < 2; axis++) {
            double at = (corner & (1 << axis) ? high[axis] : low[axis]) * widening, room = 1e-9 * fabs(at);
            box[2 * axis] = fmin(box[2 * axis], at - room);
            box[2 * axis + 1] = fmax(box[2 * axis + 1], at + room);
        }
    }
}

static int make_worker(struct lx_iso_worker *worker, size_t columns)
{
    size_t bytes = columns * (4 * (sizeof(double) + sizeof(int)) + 2 * 2);
    char *memory = worker->memory = lx_new_array(bytes, 1);
    if (!memory)
        return -1;
    for (int i = 0; i < 4; i++, memory += columns * sizeof(double))
        worker->around[i].value = (double *)(void *)memory;
    for (int i = 0; i < 4; i++, memory += columns * sizeof(int))
        worker->around[i].surface = (int *)(void *)memory;
    for (int i = 0; i < 2; i++, memory += columns * 2)
        worker->marked[i] = (unsigned char *)memory;
    worker->line = -1;
    return 0;
}

int lx_iso_grid_new(struct lx_iso_search *search, unsigned threads)
{
    const struct luxel_field *field = search->field;
    const struct lx_prepared *prepared = search->evaluator ? &search->evaluator->prepared : NULL;
    double sides[2][2] = {{0}};
    if (prepared) {
        const struct lx_screen *screen = &prepared->scene->screen;
        sides[0][0] = -screen->width_mm / 2, sides[0][1] = screen->width_mm / 2;
        sides[1][0] = screen->height_mm / 2, sides[1][1] = -screen->height_mm / 2;
    }
    search->x_mm = new_places(field->x_mm, field->columns, prepared ? sides[0] : NULL, &search->left, &search->columns);
    search->y_mm = new_places(field->y_mm, field->rows, prepared ? sides[1] : NULL, &search->top, &search->rows);
    if (!search->x_mm || !search->y_mm)
        return -1;
    search->lines = lx_new_array(search->rows, sizeof *search->lines);
    search->workers = lx_new_array(threads, sizeof *search->workers);
    if (!search->lines || !search->workers)
        return -1;
    search->worker_count = threads;
    for (unsigned i = 0; i < threads; i++)
        if (make_worker(&search->workers[i], search->columns))
            return -1;
    if (!prepared || prepared->surface_count < 2)
        return 0;
    search->boxes = lx_new_array(prepared->surface_count, sizeof *search->boxes);
    for (size_t i = 0; search->boxes && i < prepared->surface_count; i++)
        find_box(prepared, &prepared->surfaces[i], search->boxes[i]);
    return search->boxes ? 0 : -1;
}

void lx_iso_grid_clear(struct lx_iso_search *search)
{
    for (unsigned i = 0; search->lines && i < search->rows; i++) {
        struct lx_iso_line *line = &search->lines[i];
        free(line->runs.items);
        free(line->exact.items);
        free(line->nodes.items);
        free(line->crossings.items);
        free(line->ends.items);
        free(line->segments.items);
    }
    for (unsigned i = 0; i < search->worker_count; i++)
        free(search->workers[i].memory);
    free(search->workers);
    free(search->lines);
    free(search->boxes);
    free(search->x_mm);
    free(search->y_mm);
}

/* -- reading it -- */

/* The row of the field that a line of the grid is; false: it is an edge of the screen, or lies beyond the grid. */
static bool find_row(const struct lx_iso_search *search, long long line, size_t *row)
{
    long long place = line - search->top;
    *row = (size_t)place;
    return place >= 0 && place < search->field->rows;
}

static void load_picture(const struct lx_iso_search *search, long long line, struct lx_iso_corners *corners)
{
    const struct luxel_field *field = search->field;
    size_t row;
    for (unsigned i = 0; i < search->columns; i++) {
        corners->surface[i] = LX_ISO_NOTHING;
        corners->value[i] = 0;
    }
    if (!find_row(search, line, &row))
        return;
    const struct lx_iso_list *runs = &search->lines[line].runs;
    const struct lx_iso_run *run = runs->items, *end = run + runs->count;
    int shown = 0;
    for (unsigned i = 0; i < field->columns; i++) {
        size_t pixel = row * field->columns + i;
        for (; run < end && run->column == i; run++)
            shown = run->surface;
        corners->surface[search->left + i] = field->mask[pixel] ? shown : LX_ISO_NOTHING;
        corners->value[search->left + i] = lx_field_value(field, pixel);
    }
}

static void load_exact(const struct lx_iso_search *search, long long line, struct lx_iso_corners *corners)
{
    if (line < 0 || line >= search->rows)
        return;
    const struct lx_iso_list *list = &search->lines[line].exact;
    const struct lx_iso_exact *exact = list->items;
    for (size_t i = 0; i < list->count; i++) {
        corners->surface[exact[i].column] = exact[i].surface;
        corners->value[exact[i].column] = exact[i].value;
    }
}

void lx_iso_load(const struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line, bool with_exact)
{
    bool is_next = worker->line >= 0 && worker->line + 1 == line;
    if (is_next) {
        struct lx_iso_corners first = worker->around[0];
        for (int i = 0; i < 3; i++)
            worker->around[i] = worker->around[i + 1];
        worker->around[3] = first;
    }
    for (int i = is_next ? 3 : 0; i < 4; i++) {
        load_picture(search, (long long)line + i - 1, &worker->around[i]);
        if (with_exact)
            load_exact(search, (long long)line + i - 1, &worker->around[i]);
    }
    worker->line = line;
}

/* -- the surfaces -- */

int lx_iso_seen(const struct lx_iso_search *search, const double xy_mm[2])
{
    const struct lx_prepared *prepared = &search->evaluator->prepared;
    struct lx_element element;
    if (!lx_element_seen(prepared, xy_mm[0], xy_mm[1], &element))
        return LX_ISO_NOTHING;
    return (int)(element.own - prepared->surfaces);
}

/* The surface seen at a sample that shows one; most are told by the surfaces' boxes. */
static int surface_at(const struct lx_iso_search *search, const double xy_mm[2])
{
    int only = LX_ISO_NOTHING;
    for (size_t i = 0; i < search->evaluator->prepared.surface_count; i++) {
        const double *box = search->boxes[i];
        if (!(xy_mm[0] >= box[0] && xy_mm[0] <= box[1] && xy_mm[1] >= box[2] && xy_mm[1] <= box[3]))
            continue;
        if (only != LX_ISO_NOTHING)
            return lx_iso_seen(search, xy_mm);
        only = (int)i;
    }
    return only;
}

void lx_iso_surfaces(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line)
{
    const struct luxel_field *field = search->field;
    size_t row;
    int last = 0;
    (void)worker;
    if (!search->boxes || !find_row(search, line, &row))
        return;
    for (unsigned i = 0; i < field->columns; i++) {
        if (!field->mask[row * field->columns + i])
            continue;
        int surface = surface_at(search, (const double[]){field->x_mm[i], field->y_mm[row]});
        if (surface == last)
            continue;
        struct lx_iso_run *run = lx_iso_append(search, &search->lines[line].runs, sizeof *run);
        if (!run)
            return;
        *run = (struct lx_iso_run){.column = i, .surface = last = surface};
    }
}

/* -- exact values -- */

static void add_exact(struct lx_iso_search *search, unsigned line, unsigned column)
{
    struct lx_iso_exact *exact = lx_iso_append(search, &search->lines[line].exact, sizeof *exact);
    if (!exact)
        return;
    luxel_value found;
    luxel_evaluate_screen(search->evaluator, search->x_mm[column], search->y_mm[line], &found, NULL);
    *exact = (struct lx_iso_exact){
        .column = column,
        .surface = found.on_surface ? (int)lx_prepared_index(&search->evaluator->prepared, found.surface, found.part)
                                    : LX_ISO_NOTHING,
        .value = found.on_surface && !found.has_value ? (double)NAN : found.value,
    };
}

/* Whether a sample next to this one shows another surface. */
static bool is_beside_edge(const struct lx_iso_worker *worker, unsigned column, unsigned first, unsigned last,
                           const bool rows[3])
{
    int surface = worker->around[1].surface[column];
    for (int row = 0; row < 3; row++)
        for (unsigned i = column > first ? column - 1 : first; rows[row] && i <= column + 1 && i < last; i++)
            if (worker->around[row].surface[i] != surface)
                return true;
    return false;
}

static bool is_near_level(const struct lx_iso_search *search, double value)
{
    size_t above = lx_iso_first_level(search, value - search->near);
    return above < search->level_count && search->levels[above] <= value + search->near;
}

void lx_iso_corners(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line)
{
    size_t row;
    bool is_sampled = find_row(search, line, &row);
    unsigned first = search->left, last = first + search->field->columns;
    bool rows[3] = {row > 0, true, row + 1 < search->field->rows};
    lx_iso_load(search, worker, line, false);
    const struct lx_iso_corners *corners = &worker->around[1];
    for (unsigned i = 0; i < search->columns; i++) {
        bool is_sample = is_sampled && i >= first && i < last;
        if (!is_sample || is_beside_edge(worker, i, first, last, rows) ||
            (corners->surface[i] != LX_ISO_NOTHING && is_near_level(search, corners->value[i])))
            add_exact(search, line, i);
    }
}

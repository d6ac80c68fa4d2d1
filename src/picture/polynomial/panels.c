/* SPDX-License-Identifier: MIT */
/* Shading rows of panels: polynomials, what they leave, and what has none. */
#include "panels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../world/camera.h"
#include "../seen.h"
#include "smooth_gloss.h"

enum { HALF_SIDE = LX_PANEL_SIDE / 2, QUARTERS = 4, SIDE_BY_SIDE = LX_BLOCK / LX_PANEL_SIDE };

/* Highlights of extended sources that are not smooth in squares of so many pixels are sampled at each of them. */
enum { LEAST_SIDE = LX_PANEL_SIDE / 4 };

/* Errors of polynomials, as shares of the picture's maximum; and what roundings of luminaires may add up to besides.
 * As these are independent they do not come together: a third of that sum is more than any picture has of it. */
static const double SHARE = 8e-7, ROUNDINGS = 2.4e-6;

struct lx_panels_memory {
    struct lx_fitting fitting;
    uint8_t *was_left; /* of the lights: by the polynomial of the whole panel */
};

/* A piece of work: some panels side by side. */
struct job {
    const struct lx_plan *plan;
    struct lx_panels_memory *memory;
    struct lx_shader_memory *shader;
    struct lx_control *control;
    bool is_caller;
    const struct lx_picture_part *canvas;
    unsigned row, end; /* of the picture: where the panels begin, and where the last of them ends */
    unsigned *shown;
};

/* What is in the picture of a square of pixels. */
struct part {
    unsigned row, column, rows, columns;
};

struct lx_panels_memory *lx_panels_memory_new(const struct lx_plan *plan)
{
    struct lx_panels_memory *memory = lx_new_array(1, sizeof *memory);
    if (!memory)
        return NULL;
    size_t most = 0;
    for (size_t s = 0; s < plan->surface_count; s++)
        most = plan->surfaces[s].smooth.count > most ? plan->surfaces[s].smooth.count : most;
    memory->was_left = lx_new_array(most, 1);
    if (lx_fitting_make(plan, &memory->fitting) == 0 && memory->was_left)
        return memory;
    lx_panels_memory_free(memory);
    return NULL;
}

void lx_panels_memory_free(struct lx_panels_memory *memory)
{
    if (!memory)
        return;
    lx_fitting_clear(&memory->fitting);
    free(memory->was_left);
    free(memory);
}

static bool goes_on(const struct job *job)
{
    return lx_control_goes_on(job->control, job->is_caller);
}

static size_t index_of(const struct job *job, unsigned row, unsigned column)
{
    return (size_t)(row - job->canvas->top) * job->canvas->stride + column - job->canvas->left;
}

/* What a job has to do of a square of pixels from a row and column on. */
static struct part part_of(const struct job *job, unsigned row, unsigned column, unsigned side)
{
    const unsigned last = job->plan->prepared->scene->screen.resolution[1];
    const unsigned rows = row < last ? last - row : 0, columns = column < job->end ? job->end - column : 0;
    return (struct part){row, column, rows < side ? rows : side, columns < side ? columns : side};
}

/* Such a square on the screen, and what its middle shows; pixels beyond the picture are as far from each other as in
 * it. */
static struct lx_square square_of(const struct job *job, unsigned row, unsigned column, unsigned side)
{
    const struct lx_screen *screen = &job->plan->prepared->scene->screen;
    const unsigned columns = screen->resolution[0], rows = screen->resolution[1];
    const double left = lx_column_x_mm(screen, 0),
                 across = (lx_column_x_mm(screen, columns - 1) - left) / (columns - 1);
    const double top = lx_row_y_mm(screen, 0), down = (lx_row_y_mm(screen, rows - 1) - top) / (rows - 1);
    struct lx_square square = {
        .x_mm = left + (column + (side - 1) / 2.0) * across,
        .y_mm = top + (row + (side - 1) / 2.0) * down,
        .half_mm = {fabs(across) * side / 2, fabs(down) * side / 2},
        .side = side,
    };
    square.surface = lx_surface_seen(job->plan, square.x_mm, square.y_mm);
    return square;
}

/* Fits polynomials to lights that are left over a square of pixels and puts them into the picture, or adds them to what
 * is there already.  False: there are none. */
static bool fit_lights(const struct job *job, unsigned row, unsigned column, const struct lx_square *square,
                       bool has_some, double *allowance)
{
    const struct lx_plan *plan = job->plan;
    struct lx_fitting *fitting = &job->memory->fitting;
    const struct part part = part_of(job, row, column, square->side);
    const double uniform = has_some ? 0 : square->surface->uniform;
    const struct lx_asking asking = {.control = job->control, .is_caller = job->is_caller};
    if (!lx_smooth_fit(plan, fitting, job->shader, square, uniform, !has_some, &asking, allowance))
        return false;
    for (size_t i = 0; i < fitting->count; i++)
        plan->kernels->spread_polynomial(&fitting->polynomials[i], part.rows, part.columns, has_some || i > 0,
                                         job->canvas->values + index_of(job, row, column), job->canvas->stride);
    return true;
}

/* Adds luminaires that are left, to the light that is there already or to that of uniform sources.  False: there are
 * none. */
static bool fit_luminaires(const struct job *job, unsigned row, unsigned column, const struct lx_square *square,
                           bool has_some, struct lx_allowance *allowance)
{
    const struct part part = part_of(job, row, column, square->side);
    const struct lx_square_values to = {part.rows, part.columns, job->canvas->values + index_of(job, row, column),
                                        job->canvas->stride};
    if (square->surface->smooth.luminaires.count == 0 || !goes_on(job))
        return false;
    for (unsigned r = 0; r < part.rows && !has_some; r++)
        for (unsigned i = 0; i < part.columns; i++)
            to.values[r * to.stride + i] = (float)square->surface->uniform;
    return lx_add_tabled(job->plan, &job->memory->fitting, job->shader, square, &to, allowance) > 0;
}

/* Puts all that polynomials do for of the lights that are left into the picture, or adds it to what is there already.
 * False: there is nothing. */
static bool fit_square(const struct job *job, unsigned row, unsigned column, const struct lx_square *square,
                       bool has_some, struct lx_allowance *allowance)
{
    const bool are_all = square->surface->smooth.luminaires.count == square->surface->smooth.count;
    memset(job->memory->fitting.is_faint, 0, sizeof job->memory->fitting.is_faint);
    const bool has_lights = !are_all && fit_lights(job, row, column, square, has_some, &allowance->error);
    return fit_luminaires(job, row, column, square, has_some || has_lights, allowance) || has_lights;
}

/* A polynomial is there only where all of a square shows the surface. */
static void show(const struct job *job, struct part part)
{
    uint8_t *mask = job->canvas->mask + index_of(job, part.row, part.column);
    unsigned *shown = job->shown + (part.row - job->row);
    for (unsigned row = 0; row < part.rows; row++, mask += job->canvas->stride) {
        if (part.columns == LX_PANEL_SIDE)
            memset(mask, 1, LX_PANEL_SIDE); /* of a size that compilers know: no call */
        else
            memset(mask, 1, part.columns);
        shown[row] += part.columns;
    }
}

/* Shades a part pixel by pixel, tile by tile, or adds to it what a portion of the light gives; NULL: all of it. */
static void shade_tiles(const struct job *job, struct part part, const struct lx_portion *portion, bool adds)
{
    const struct lx_picture_part *canvas = job->canvas;
    const struct lx_plan *plan = job->plan;
    const unsigned end = part.row + part.rows;
    lx_shader_choose(job->shader, portion);
    for (unsigned top = part.row; top < end && goes_on(job); top += LX_TILE_ROWS) {
        const unsigned rows = end - top < LX_TILE_ROWS ? end - top : LX_TILE_ROWS;
        lx_shader_enter(plan, job->shader, canvas->y_mm + (top - canvas->top), rows,
                        canvas->x_mm + (part.column - canvas->left), part.columns);
        for (unsigned r = 0; r < rows; r++) {
            const size_t at = index_of(job, top + r, part.column);
            if (!adds) {
                job->shown[top + r - job->row] += (unsigned)lx_shade_row_single(
                    plan, job->shader, r, job->control, job->is_caller, canvas->values + at, canvas->mask + at);
                continue;
            }
            _Alignas(64) double values[LX_BLOCK];
            uint8_t mask[LX_BLOCK];
            lx_shade_row(plan, job->shader, r, job->control, job->is_caller, values, mask);
            for (unsigned i = 0; i < part.columns; i++)
                canvas->values[at + i] = (float)((double)canvas->values[at + i] + values[i]);
        }
    }
    lx_shader_choose(job->shader, NULL);
}

static bool are_left(const struct job *job, const struct lx_square *square)
{
    return memchr(job->memory->fitting.is_left, 1, square->surface->smooth.count) != NULL;
}

/* Whether a quarter of a panel, some lights over which are left, shows a polynomial; *allowance: of the error.  The
 * panel `has_some` of the surface that it shows. */
static bool shade_quarter(const struct job *job, unsigned row, unsigned column,
                          const struct lx_planned_surface *has_some, struct lx_allowance allowance)
{
    struct lx_fitting *fitting = &job->memory->fitting;
    const struct lx_square square = square_of(job, row, column, HALF_SIDE);
    if (!has_some && (!square.surface || !square.surface->smooth.pays))
        return false;
    if (has_some)
        memcpy(fitting->is_left, job->memory->was_left, has_some->smooth.count);
    else
        memset(fitting->is_left, 1, square.surface->smooth.count);
    const bool has_more = fit_square(job, row, column, &square, has_some, &allowance);
    if (!has_some && !has_more)
        return false;
    const struct part part = part_of(job, row, column, HALF_SIDE);
    const struct lx_portion left = {.which = fitting->is_left, .lights = true};
    show(job, part);
    if (are_left(job, &square))
        shade_tiles(job, part, &left, true);
    return true;
}

/* Shades a panel but for quarters without a polynomial, which become plain. */
static void shade_panel(const struct job *job, unsigned row, unsigned column, bool is_plain[QUARTERS])
{
    struct lx_fitting *fitting = &job->memory->fitting;
    const double allowance = SHARE * job->plan->least_maximum, kept = allowance / 4; /* for its quarters */
    const struct lx_square square = square_of(job, row, column, LX_PANEL_SIDE);
    const bool is_smooth = square.surface && square.surface->smooth.pays;
    struct lx_allowance left_over = {allowance - kept, ROUNDINGS * job->plan->least_maximum};
    bool is_faint[QUARTERS] = {false}, has_some = false;
    if (is_smooth) {
        memset(fitting->is_left, 1, square.surface->smooth.count);
        has_some = fit_square(job, row, column, &square, false, &left_over);
        memcpy(is_faint, fitting->is_faint, sizeof is_faint);
        memcpy(job->memory->was_left, fitting->is_left, square.surface->smooth.count);
        if (!are_left(job, &square)) {
            show(job, part_of(job, row, column, LX_PANEL_SIDE));
            return;
        }
    }
    const struct lx_allowance for_quarters = {left_over.error + kept, left_over.rounding};
    for (unsigned q = 0; q < QUARTERS && goes_on(job); q++) {
        const unsigned top = row + q / 2 * HALF_SIDE, left = column + q % 2 * HALF_SIDE;
        const struct part part = part_of(job, top, left, HALF_SIDE);
        if (part.rows > 0 && part.columns > 0)
            is_plain[q] = is_faint[q] || !shade_quarter(job, top, left, has_some ? square.surface : NULL, for_quarters);
    }
}

/* Shades the plain quarters among panels side by side. */
static void shade_plain(const struct job *job, unsigned row, unsigned column, bool (*is_plain)[QUARTERS])
{
    const struct lx_portion matte = {.lights = true, .uniform = true};
    for (unsigned half = 0; half < 2; half++)
        for (unsigned q = 0, next; q < 2 * SIDE_BY_SIDE && goes_on(job); q = next) {
            const bool first = is_plain[q / 2][2 * half + q % 2];
            for (next = q + 1; next < 2 * SIDE_BY_SIDE && is_plain[next / 2][2 * half + next % 2] == first;)
                next++;
            struct part part = part_of(job, row + half * HALF_SIDE, column + q * HALF_SIDE, HALF_SIDE);
            const struct part end = part_of(job, row + half * HALF_SIDE, column + (next - 1) * HALF_SIDE, HALF_SIDE);
            part.columns = end.column + end.columns - part.column;
            if (first)
                shade_tiles(job, part, job->plan->has_gloss ? &matte : NULL, false);
        }
}

/* Whether some pixel of a part shows a surface. */
static bool shows_any(const struct job *job, struct part part)
{
    const uint8_t *mask = job->canvas->mask + index_of(job, part.row, part.column);
    for (unsigned row = 0; row < part.rows; row++, mask += job->canvas->stride)
        if (memchr(mask, 1, part.columns))
            return true;
    return false;
}

/* Adds the highlights of extended sources over a square of pixels: by a polynomial, or over its quarters, or at each
 * pixel. */
static void add_gloss(const struct job *job, unsigned row, unsigned column, unsigned side)
{
    const struct lx_plan *plan = job->plan;
    const struct part part = part_of(job, row, column, side);
    const struct lx_asking asking = {.control = job->control, .is_caller = job->is_caller};
    const struct lx_portion highlights = {.highlights = true};
    if (part.rows == 0 || part.columns == 0 || !goes_on(job) || !shows_any(job, part))
        return;
    const struct lx_square square = square_of(job, row, column, side);
    if (square.surface && square.surface->smooth.pays) {
        struct lx_polynomial *polynomial = job->memory->fitting.polynomials;
        const enum lx_gloss gloss =
            lx_gloss_fit(plan, &job->memory->fitting, job->shader, &square, &asking, polynomial);
        if (gloss == LX_GLOSS_SMOOTH)
            plan->kernels->spread_polynomial(polynomial, part.rows, part.columns, true,
                                             job->canvas->values + index_of(job, row, column), job->canvas->stride);
        if (gloss != LX_GLOSS_ROUGH)
            return;
    }
    if (side == LEAST_SIDE) {
        shade_tiles(job, part, &highlights, true);
        return;
    }
    for (unsigned q = 0; q < QUARTERS; q++)
        add_gloss(job, row + q / 2 * side / 2, column + q % 2 * side / 2, side / 2);
}

void lx_shade_panels(const struct lx_plan *plan, struct lx_panels_memory *memory, struct lx_shader_memory *shader,
                     struct lx_control *control, bool is_caller, const struct lx_picture_part *canvas, unsigned row,
                     unsigned column, unsigned panels, unsigned shown[LX_PANEL_SIDE])
{
    const unsigned columns = plan->prepared->scene->screen.resolution[0], end = column + panels * LX_PANEL_SIDE;
    const struct job job = {plan, memory, shader, control, is_caller, canvas, row, end < columns ? end : columns,
                            shown};
    bool is_plain[SIDE_BY_SIDE][QUARTERS] = {{false}};
    memset(shown, 0, LX_PANEL_SIDE * sizeof *shown);
    for (unsigned p = 0; p < panels && goes_on(&job); p++)
        if (column + p * LX_PANEL_SIDE < columns)
            shade_panel(&job, row, column + p * LX_PANEL_SIDE, is_plain[p]);
    shade_plain(&job, row, column, is_plain);
    for (unsigned p = 0; p < panels && plan->has_gloss; p++)
        add_gloss(&job, row, column + p * LX_PANEL_SIDE, LX_PANEL_SIDE);
}

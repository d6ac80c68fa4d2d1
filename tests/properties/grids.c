/* SPDX-License-Identifier: MIT */
/* Measuring grids: their cells are free elements, light adds up on them, and their bounds hold. */
#include "properties.h"

#include <float.h>
#include <math.h>

/* The tolerance of integrals, as users would take it. */
static const double TOLERANCE = 1e-4;

static luxel_grid *measure(const luxel_scene *scene, double tolerance)
{
    luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    luxel_grid *grid = NULL;
    settings.tolerance = tolerance;
    return scene && luxel_scene_grid_count(scene) > 0 && luxel_find_grid(scene, &settings, 0, NULL, &grid) == LUXEL_OK
               ? grid
               : NULL;
}

static luxel_grid *measure_draft(const struct draft *draft)
{
    luxel_scene *scene = trial_scene_of(draft);
    luxel_grid *grid = measure(scene, TOLERANCE);
    luxel_scene_free(scene);
    return grid;
}

static size_t cells_of(const luxel_grid *grid)
{
    return (size_t)grid->columns * grid->rows;
}

/* ---- cells and elements ---- */

/* What a free element has, widened by what it has at a place. */
struct span {
    double low, high;
    bool is_blocked; /* a source lies on the element somewhere */
};

static void widen(const struct trial *trial, const double position[3], const double axis[3], struct span *span)
{
    luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    luxel_probe *probe = NULL;
    settings.quantity = LUXEL_IRRADIANCE;
    settings.tolerance = TOLERANCE;
    if (luxel_probe_element(trial->scene, &settings, position, axis, NULL, &probe) != LUXEL_OK || !probe->has_value) {
        span->is_blocked = true;
    } else {
        span->low = fmin(span->low, probe->value - probe->error);
        span->high = fmax(span->high, probe->value + probe->error);
    }
    luxel_probe_free(probe);
}

/* How far a cell may be from where its rounded place is. */
static double rounding_of(const luxel_grid *grid)
{
    double size = grid->size_mm[0] + grid->size_mm[1];
    for (int k = 0; k < 3; k++)
        size = fmax(size, fabs(grid->center_mm[k]));
    return 4 * DBL_EPSILON * size;
}

/* The element of a cell may be any of those around its rounded place. */
static struct span span_around(const struct trial *trial, const luxel_grid *grid, const double position[3])
{
    struct span span = {HUGE_VAL, -HUGE_VAL, false};
    widen(trial, position, grid->axis, &span);
    for (int way = 0; way < 6; way++) {
        double moved[3] = {position[0], position[1], position[2]};
        moved[way / 2] += (way % 2 ? 1 : -1) * rounding_of(grid);
        widen(trial, moved, grid->axis, &span);
    }
    for (size_t i = 0; i < trial->draft->light_count; i++) {
        const double *place = trial->draft->lights[i].numbers.place;
        const double away = hypot(hypot(place[0] - position[0], place[1] - position[1]), place[2] - position[2]);
        span.is_blocked = span.is_blocked || away <= 4 * rounding_of(grid);
    }
    return span;
}

bool has_cells_of_elements(struct trial *trial)
{
    luxel_grid *grid = measure(trial->scene, TOLERANCE);
    bool holds = true;
    for (size_t i = 0; holds && grid && i < cells_of(grid); i++) {
        double position[3];
        luxel_grid_position(grid, (unsigned)(i % grid->columns), (unsigned)(i / grid->columns), position);
        const struct span span = span_around(trial, grid, position);
        const double margin = span.high - span.low + grid->errors[i];
        holds = span.is_blocked || (grid->inside[i] && !grid->mask[i]) ||
                (grid->mask[i] && grid->values[i] >= span.low - margin && grid->values[i] <= span.high + margin) ||
                trial_fails(trial, "cell %zu: %.17g +- %.3g%s, the element there from %.17g to %.17g", i,
                            grid->values[i], grid->errors[i], grid->mask[i] ? "" : " (blocked)", span.low, span.high);
    }
    luxel_grid_free(grid);
    return holds;
}

/* ---- sums ---- */

/* The grids of the single lights added up, with their errors; false where one has no grid.  A cell is inside of a body
 * where any of them says so: what a light shines in is none, so they differ. */
static bool add_grids(const struct draft *draft, size_t cells, double *sum, double *error, bool *is_measured,
                      bool *is_inside)
{
    for (size_t c = 0; c < cells; c++)
        sum[c] = error[c] = 0, is_measured[c] = true, is_inside[c] = false;
    for (size_t i = 0; i < draft->light_count; i++) {
        struct draft single = *draft;
        single.lights[0] = draft->lights[i];
        single.light_count = 1;
        luxel_grid *grid = measure_draft(&single);
        if (!grid)
            return false;
        for (size_t c = 0; c < cells; c++) {
            is_measured[c] = is_measured[c] && grid->mask[c];
            is_inside[c] = is_inside[c] || grid->inside[c];
            sum[c] += grid->values[c];
            error[c] += grid->errors[c] + 4 * DBL_EPSILON * grid->values[c];
        }
        luxel_grid_free(grid);
    }
    return true;
}

bool has_cells_that_add_up(struct trial *trial)
{
    enum { MOST_CELLS = 16 };
    double sum[MOST_CELLS], error[MOST_CELLS];
    bool is_measured[MOST_CELLS], is_inside[MOST_CELLS], holds = true;
    luxel_grid *grid = trial->draft->light_count > 1 ? measure(trial->scene, TOLERANCE) : NULL;
    if (!grid)
        return true;
    if (!add_grids(trial->draft, cells_of(grid), sum, error, is_measured, is_inside))
        holds = trial_fails(trial, "a light alone has no grid, but all of them have");
    for (size_t c = 0; holds && c < cells_of(grid); c++)
        holds = is_inside[c] || grid->inside[c] ||
                (grid->mask[c] == is_measured[c] &&
                 (!is_measured[c] || fabs(grid->values[c] - sum[c]) <= grid->errors[c] + error[c])) ||
                trial_fails(trial, "cell %zu: %.17g +- %.3g, one by one %.17g +- %.3g", c, grid->values[c],
                            grid->errors[c], sum[c], error[c]);
    luxel_grid_free(grid);
    return holds;
}

/* ---- turns ---- */

/* Every number of a scene that is turned by a quarter is as exact as before, so the bounds alone tell how near. */
bool has_cells_that_turn(struct trial *trial)
{
    struct draft turned = *trial->draft;
    if (!draft_is_symmetric(trial->draft))
        return true;
    draft_turn(&turned, (struct draft_map){.xy = -1, .yx = 1});
    luxel_grid *grid = measure(trial->scene, TOLERANCE), *after = grid ? measure_draft(&turned) : NULL;
    bool holds = !grid || after || trial_fails(trial, "the turned scene has no grid");
    for (size_t c = 0; holds && grid && c < cells_of(grid); c++)
        holds = (grid->mask[c] == after->mask[c] &&
                 fabs(grid->values[c] - after->values[c]) <= grid->errors[c] + after->errors[c]) ||
                trial_fails(trial, "cell %zu: %.17g +- %.3g, turned %.17g +- %.3g", c, grid->values[c], grid->errors[c],
                            after->values[c], after->errors[c]);
    luxel_grid_free(grid);
    luxel_grid_free(after);
    return holds;
}

/* ---- bounds, and what is read off ---- */

static bool is_consistent(struct trial *trial, const luxel_grid *grid)
{
    double sum = 0;
    for (size_t c = 0; c < cells_of(grid); c++) {
        if (!(isfinite(grid->values[c]) && grid->values[c] >= 0 && grid->errors[c] >= 0))
            return trial_fails(trial, "cell %zu: %.17g +- %.3g", c, grid->values[c], grid->errors[c]);
        sum += grid->values[c];
    }
    if (grid->measured == 0)
        return true;
    const double average = sum / (double)grid->measured, low = grid->minimum.value, high = grid->maximum.value;
    const bool is_so = fabs(average - grid->average.value) <= 1e-14 * average + 1e-300 && low <= high &&
                       grid->average.value >= low * (1 - 1e-14) && grid->average.value <= high * (1 + 1e-14) &&
                       grid->has_evenness == (grid->average.value > 0) && grid->u0 >= 0 && grid->u0 <= 1 + 1e-14 &&
                       grid->ud >= 0 && grid->ud <= 1;
    return is_so || trial_fails(trial, "average %.17g, from %.17g to %.17g, U0 %g, Ud %g", grid->average.value, low,
                                high, grid->u0, grid->ud);
}

bool has_grid_within_bounds(struct trial *trial)
{
    luxel_grid *rough = measure(trial->scene, 1e-2), *fine = rough ? measure(trial->scene, 1e-5) : NULL;
    bool holds = !rough || (is_consistent(trial, rough) && (fine || trial_fails(trial, "no grid by tolerance 1e-5")));
    for (size_t c = 0; holds && rough && c < cells_of(rough); c++)
        holds = fabs(rough->values[c] - fine->values[c]) <= rough->errors[c] + fine->errors[c] ||
                trial_fails(trial, "cell %zu: %.17g +- %.3g with the tolerance 1e-2, %.17g +- %.3g with 1e-5", c,
                            rough->values[c], rough->errors[c], fine->values[c], fine->errors[c]);
    luxel_grid_free(rough);
    luxel_grid_free(fine);
    return holds;
}

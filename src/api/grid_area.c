/* SPDX-License-Identifier: MIT */
/*
 * The areas around a task area, which a grid's plane then is: the immediate surrounding area, a strip along its edges,
 * and the background area, a strip around that (EN 12464-1:2011, 4.3), both as far as the walls of the room.  Each is
 * measured on cells over the rectangle around it, those whose centres are in the strip.
 */
#include <math.h>
#include <string.h>

#include "../parameter/decode.h"
#include "../scene/grids.h"
#include "../scene/scene.h"
#include "coloring.h"
#include "grid.h"

enum { AREAS = 2, MOST_CELLS = 1000000 };

/* What rounding may put a wall off by. */
static const double SLACK_MM = 1e-6;

/* A rectangle on the plane, from the middle of the grid: low and high, across and up. */
struct extent {
    double mm[2][2];
};

static struct extent widen(struct extent extent, double width_mm)
{
    for (int side = 0; side < 2; side++) {
        extent.mm[side][0] -= width_mm;
        extent.mm[side][1] += width_mm;
    }
    return extent;
}

/* What all rooms that the plane's middle is in have in common. */
static void find_room(const struct lx_scene_parameters *scene, const double center_mm[3], struct lx_ring *ring)
{
    for (int k = 0; k < 3; k++) {
        ring->low_mm[k] = -HUGE_VAL;
        ring->high_mm[k] = HUGE_VAL;
    }
    for (size_t i = 0; i < scene->surfaces.count; i++) {
        const struct lx_item *item = &scene->surfaces.items[i];
        if (strcmp(item->variant->name, "room") != 0)
            continue;
        const struct lx_table *table = item->variant->table;
        const double *center = lx_const_member(lx_find_parameter(table, "center"), item->parameters);
        const double *size = lx_const_member(lx_find_parameter(table, "size"), item->parameters);
        bool is_inside = true;
        for (int k = 0; k < 3; k++)
            is_inside = is_inside && fabs(center_mm[k] - center[k]) <= size[k] / 2 + SLACK_MM;
        for (int k = 0; k < 3 && is_inside; k++) {
            ring->low_mm[k] = fmax(ring->low_mm[k], center[k] - size[k] / 2);
            ring->high_mm[k] = fmin(ring->high_mm[k], center[k] + size[k] / 2);
        }
    }
}

/* Cuts a rectangle at walls that are at right angles to a side of the plane; at others its cells are judged one by
 * one. */
static void cut_at_walls(const struct lx_ring *ring, const double center_mm[3], const double *const sides[2],
                         struct extent *extent)
{
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < 3; k++) {
            const double along = sides[side][k], low = ring->low_mm[k] - center_mm[k],
                         high = ring->high_mm[k] - center_mm[k];
            if (fabs(along) < 1 - 1e-12)
                continue;
            extent->mm[side][0] = fmax(extent->mm[side][0], along > 0 ? low : -high);
            extent->mm[side][1] = fmin(extent->mm[side][1], along > 0 ? high : -low);
        }
}

/* As many cells as the standard wants of a strip of this width. */
static void set_cells(double width_mm, struct lx_grid *grid)
{
    const double spacing = lx_en12464_spacing_mm((const double[]){width_mm, 2 * width_mm});
    const double cells = grid->size_mm[0] / spacing * (grid->size_mm[1] / spacing);
    const double coarse = cells > MOST_CELLS ? sqrt(cells / MOST_CELLS) : 1;
    for (int side = 0; side < 2; side++)
        grid->n[side] = (unsigned)fmin(ceil(grid->size_mm[side] / (spacing * coarse) * (1 - 1e-9)), MOST_CELLS);
}

/* The area between a rectangle and one that is so much wider; false: walls leave no room for it. */
static bool make_area(const struct lx_scene_parameters *scene, const struct lx_grid *task, struct extent inner,
                      double width_mm, struct lx_area *area)
{
    const struct lx_cells cells = lx_cells_of(task);
    double across[3], up[3];
    const double *const sides[2] = {across, up};
    struct extent outer = widen(inner, width_mm);
    lx_values3(lx_wide3_direction(cells.pose.across), across);
    lx_values3(lx_wide3_direction(cells.pose.upward), up);
    *area = (struct lx_area){.grid = *task};
    find_room(scene, task->center_mm, &area->ring);
    cut_at_walls(&area->ring, task->center_mm, sides, &outer);
    bool is_wider = false;
    for (int side = 0; side < 2; side++) {
        const double middle = (outer.mm[side][0] + outer.mm[side][1]) / 2;
        is_wider = is_wider || outer.mm[side][0] < inner.mm[side][0] - SLACK_MM ||
                   outer.mm[side][1] > inner.mm[side][1] + SLACK_MM;
        area->grid.size_mm[side] = outer.mm[side][1] - outer.mm[side][0];
        for (int k = 0; k < 3; k++)
            area->grid.center_mm[k] += middle * sides[side][k];
        for (int end = 0; end < 2; end++)
            area->ring.hole_mm[side][end] = inner.mm[side][end] - middle;
    }
    if (is_wider)
        set_cells(width_mm, &area->grid);
    return is_wider;
}

bool lx_ring_leaves_out(const struct lx_ring *ring, const struct lx_cells *cells, unsigned column, unsigned row)
{
    const double at_mm[2] = {cells->size_mm[0] * ((2.0 * column + 1) / cells->n[0] - 1) / 2,
                             cells->size_mm[1] * (1 - (2.0 * row + 1) / cells->n[1]) / 2};
    bool is_in_hole = true, is_in_room = true;
    double place_mm[3];
    for (int side = 0; side < 2; side++)
        is_in_hole = is_in_hole && at_mm[side] >= ring->hole_mm[side][0] && at_mm[side] <= ring->hole_mm[side][1];
    lx_place_on_cells(cells, at_mm, place_mm);
    for (int k = 0; k < 3; k++)
        is_in_room =
            is_in_room && place_mm[k] >= ring->low_mm[k] - SLACK_MM && place_mm[k] <= ring->high_mm[k] + SLACK_MM;
    return is_in_hole || !is_in_room;
}

/* The areas that the grid asks for and that there is room for; returns how many, `of` tells which. */
static size_t find_areas(const struct lx_scene_parameters *scene, const struct lx_grid *task,
                         struct lx_area areas[AREAS], size_t of[AREAS])
{
    const double widths_mm[AREAS] = {task->surround_mm, task->background_mm};
    struct extent inner;
    size_t count = 0;
    for (int side = 0; side < 2; side++) {
        inner.mm[side][0] = -task->size_mm[side] / 2;
        inner.mm[side][1] = task->size_mm[side] / 2;
    }
    for (size_t i = 0; i < AREAS && widths_mm[i] > 0; i++) {
        of[count] = i;
        count += make_area(scene, task, inner, widths_mm[i], &areas[count]);
        inner = widen(inner, widths_mm[i]);
    }
    return count;
}

luxel_status lx_measure_with_areas(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                   lx_measure_plane *measure, luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    const bool exists = grid && i < luxel_scene_grid_count(scene);
    struct lx_area areas[AREAS];
    size_t of[AREAS], count = 0;
    struct lx_part_progress progress;
    luxel_settings own;
    if (exists)
        count = find_areas(lx_scene_parameters(scene),
                           (const struct lx_grid *)lx_scene_parameters(scene)->grids.items + i, areas, of);
    if (count == 0)
        return measure(scene, settings, i, diagnostics, grid);
    luxel_settings_init(&own);
    own = settings ? *settings : own;
    lx_part_progress_begin(&progress, 0, count + 1, settings, &own);
    luxel_status status = measure(scene, &own, i, diagnostics, grid);
    if (status != LUXEL_OK)
        return status;
    for (size_t k = 0; k < count && status == LUXEL_OK; k++) {
        const struct lx_wanted_cells wanted = {.area = &areas[k]};
        luxel_grid *made = NULL;
        lx_part_progress_begin(&progress, k + 1, count + 1, settings, &own);
        status = lx_measure_cells(scene, &own, i, &wanted, diagnostics, &made);
        if (status == LUXEL_OK)
            *(of[k] == 0 ? &(*grid)->surround : &(*grid)->background) = made;
    }
    if (status != LUXEL_OK)
        luxel_grid_free(*grid);
    return status;
}

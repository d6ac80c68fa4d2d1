/* SPDX-License-Identifier: MIT */
/*
 * Where the cells of a measuring grid are.  Their places are wide numbers first, so that a grid along the axes of the
 * scene has no rounding where it needs none: its elements lie exactly in its plane.
 */
#include <string.h>

#include "cells.h"

struct lx_cells lx_cells_of(const struct lx_grid *grid)
{
    struct lx_cells cells;
    double up[3];
    memcpy(up, grid->up, sizeof up);
    if (lx_are_parallel(grid->axis, up)) /* in a committed scene that can only be the default */
        lx_usual_up(grid->axis, up);
    cells.pose = lx_pose_of(grid->axis, up);
    cells.normal = lx_wide3_direction(cells.pose.axis);
    memcpy(cells.center_mm, grid->center_mm, sizeof cells.center_mm);
    memcpy(cells.size_mm, grid->size_mm, sizeof cells.size_mm);
    memcpy(cells.n, grid->n, sizeof cells.n);
    return cells;
}

/* From the middle of so many cells along a side to the centre of one of them. */
static lx_wide offset_of(double size_mm, unsigned index, unsigned count)
{
    lx_wide twice = lx_wide_mul(lx_wide_of(size_mm), lx_wide_of(2.0 * index + 1 - count));
    return lx_wide_div(twice, lx_wide_of(2.0 * count));
}

/* center + across u + upward v for one coordinate, the rounding to float64 as its error. */
static lx_bounded coordinate(double center_mm, lx_wide across, lx_wide u, lx_wide upward, lx_wide v)
{
    if (lx_wide_value(across) == 0 && lx_wide_value(upward) == 0)
        return lx_exact(center_mm);
    lx_wide first = lx_wide_mul(across, u), second = lx_wide_mul(upward, v);
    lx_wide place = lx_wide_add(lx_wide_of(center_mm), lx_wide_add(first, second));
    double value = lx_wide_value(place);
    double rest = fabs(lx_wide_value(lx_wide_sub(place, lx_wide_of(value))));
    double size = fabs(center_mm) + fabs(lx_wide_value(first)) + fabs(lx_wide_value(second));
    /* Some ten operations of 2^-98 each, and products that may have left the normal numbers. */
    return (lx_bounded){value, (rest + 0x1p-90 * size) * LX_BOUND_SLACK + 0x1p-1000};
}

lx_bounded3 lx_cell_place(const struct lx_cells *cells, unsigned column, unsigned row)
{
    const lx_wide3 *across = &cells->pose.across, *upward = &cells->pose.upward;
    lx_wide u = offset_of(cells->size_mm[0], column, cells->n[0]);
    lx_wide v = lx_wide_negate(offset_of(cells->size_mm[1], row, cells->n[1]));
    return (lx_bounded3){
        coordinate(cells->center_mm[0], across->x, u, upward->x, v),
        coordinate(cells->center_mm[1], across->y, u, upward->y, v),
        coordinate(cells->center_mm[2], across->z, u, upward->z, v),
    };
}

struct lx_element lx_cell_element(const struct lx_prepared *prepared, const struct lx_cells *cells, unsigned column,
                                  unsigned row, const struct lx_lobe *lobe)
{
    lx_bounded3 place = lx_cell_place(cells, column, row), normal = cells->normal;
    const struct lx_free_element asked = {
        .place_mm = {place.x.value, place.y.value, place.z.value},
        .normal = {normal.x.value, normal.y.value, normal.z.value},
    };
    struct lx_element element = lx_element_at(prepared, &asked);
    element.place_mm = place;
    element.normal = normal;
    element.lobe = lobe;
    return element;
}

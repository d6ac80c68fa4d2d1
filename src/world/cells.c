/* SPDX-License-Identifier: MIT */
/*
 * Where the cells of a measuring grid are.  Their places are wide numbers first, so that a grid along the axes of the
 * scene has no rounding where it needs none: its elements lie exactly in its plane.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
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

/* center + first + second, what lies across and upward, for one coordinate; the rounding to float64 as its error. */
static lx_bounded coordinate(double center_mm, lx_wide first, lx_wide second)
{
    lx_wide place = lx_wide_add(lx_wide_of(center_mm), lx_wide_add(first, second));
    double value = lx_wide_value(place);
    double rest = fabs(lx_wide_value(lx_wide_sub(place, lx_wide_of(value))));
    double size = fabs(center_mm) + fabs(lx_wide_value(first)) + fabs(lx_wide_value(second));
    /* Some ten operations of 2^-98 each, and products that may have left the normal numbers. */
    return (lx_bounded){value, (rest + 0x1p-90 * size) * LX_BOUND_SLACK + 0x1p-1000};
}

/* From the grid's middle to column or row i. */
static lx_wide3 way_to(const struct lx_cells *cells, int side, unsigned i)
{
    const lx_wide3 *direction = side == 0 ? &cells->pose.across : &cells->pose.upward;
    lx_wide along = offset_of(cells->size_mm[side], i, cells->n[side]);
    along = side == 0 ? along : lx_wide_negate(along);
    return (lx_wide3){
        lx_wide_mul(direction->x, along),
        lx_wide_mul(direction->y, along),
        lx_wide_mul(direction->z, along),
    };
}

static bool is_zero(lx_wide a)
{
    return lx_wide_value(a) == 0;
}

/* The sides that a coordinate changes along. */
static unsigned sides_of(lx_wide across, lx_wide upward)
{
    return (is_zero(across) ? 0 : 1) | (is_zero(upward) ? 0 : 2);
}

static void find_sides(const struct lx_cells *cells, unsigned sides[3])
{
    const lx_wide3 *across = &cells->pose.across, *upward = &cells->pose.upward;
    sides[0] = sides_of(across->x, upward->x);
    sides[1] = sides_of(across->y, upward->y);
    sides[2] = sides_of(across->z, upward->z);
}

void lx_place_on_cells(const struct lx_cells *cells, const double at_mm[2], double place_mm[3])
{
    const lx_bounded3 across = lx_wide3_direction(cells->pose.across), up = lx_wide3_direction(cells->pose.upward);
    place_mm[0] = cells->center_mm[0] + at_mm[0] * across.x.value + at_mm[1] * up.x.value;
    place_mm[1] = cells->center_mm[1] + at_mm[0] * across.y.value + at_mm[1] * up.y.value;
    place_mm[2] = cells->center_mm[2] + at_mm[0] * across.z.value + at_mm[1] * up.z.value;
}

lx_bounded3 lx_cell_place(const struct lx_cells *cells, unsigned column, unsigned row)
{
    const lx_wide3 first = way_to(cells, 0, column), second = way_to(cells, 1, row);
    unsigned sides[3];
    find_sides(cells, sides);
    return (lx_bounded3){
        sides[0] ? coordinate(cells->center_mm[0], first.x, second.x) : lx_exact(cells->center_mm[0]),
        sides[1] ? coordinate(cells->center_mm[1], first.y, second.y) : lx_exact(cells->center_mm[1]),
        sides[2] ? coordinate(cells->center_mm[2], first.z, second.z) : lx_exact(cells->center_mm[2]),
    };
}

/* Coordinate i of a cell's middle: along one side it is that of the column, or row, whatever the other one. */
static lx_bounded place_of(const struct lx_lattice *lattice, int i, unsigned column, unsigned row)
{
    const struct lx_lattice_line *across = &lattice->lines[0][column], *upward = &lattice->lines[1][row];
    switch (lattice->sides[i]) {
    case 0: return lx_exact(lattice->cells.center_mm[i]);
    case 1: return across->alone[i];
    case 2: return upward->alone[i];
    default: return coordinate(lattice->cells.center_mm[i], across->way[i], upward->way[i]);
    }
}

lx_bounded3 lx_lattice_place(const struct lx_lattice *lattice, unsigned column, unsigned row)
{
    return (lx_bounded3){
        place_of(lattice, 0, column, row),
        place_of(lattice, 1, column, row),
        place_of(lattice, 2, column, row),
    };
}

int lx_lattice_make(const struct lx_cells *cells, struct lx_lattice *lattice)
{
    const lx_wide none = lx_wide_of(0);
    *lattice = (struct lx_lattice){.cells = *cells};
    find_sides(cells, lattice->sides);
    for (int side = 0; side < 2; side++) {
        lattice->lines[side] = lx_new_array(cells->n[side], sizeof *lattice->lines[side]);
        for (unsigned i = 0; lattice->lines[side] && i < cells->n[side]; i++) {
            struct lx_lattice_line *line = &lattice->lines[side][i];
            const lx_wide3 way = way_to(cells, side, i);
            line->way[0] = way.x, line->way[1] = way.y, line->way[2] = way.z;
            for (int k = 0; k < 3; k++)
                line->alone[k] = side == 0 ? coordinate(cells->center_mm[k], line->way[k], none)
                                           : coordinate(cells->center_mm[k], none, line->way[k]);
        }
    }
    return lattice->lines[0] && lattice->lines[1] ? 0 : -1;
}

void lx_lattice_clear(struct lx_lattice *lattice)
{
    free(lattice->lines[0]);
    free(lattice->lines[1]);
    *lattice = (struct lx_lattice){.lines = {NULL, NULL}};
}

/* SPDX-License-Identifier: MIT */
/* A measurement of a grid under way, which grid.c makes cell by cell and grid_plane.c judges as a plane. */
#ifndef LX_API_GRID_MEASURING_H
#define LX_API_GRID_MEASURING_H

#include "../base/rows.h"
#include "../world/bodies.h"
#include "../world/world.h"
#include "grid.h"
#include "plane_measure.h"

struct lx_measuring {
    struct lx_world world;
    const luxel_settings *settings;
    struct lx_control *control;
    unsigned threads;
    struct lx_plane_measure measure;
    struct lx_measured *made;
    struct lx_lattice lattice; /* of its cells */
    double *values, *errors;
    uint8_t *mask, *inside;
    struct lx_bodies bodies;    /* that the plane meets */
    const struct lx_ring *ring; /* what of the cells counts; NULL: all */
    bool values_alone;          /* nothing is asked of the plane as a whole */
    struct lx_kept_slot *slot;  /* for what is reflected to the plane; NULL: it is not kept */
    size_t number;              /* of the grid */
};

/* The sum that number i of the answer for the light on a plane is, direct light alone as long as nothing is known to be
 * reflected. */
static inline lx_bounded lx_received_on_plane(const struct lx_world *world, const struct lx_received *received,
                                              size_t i)
{
    const lx_bounded direct = lx_column_get(&received->irradiance, i);
    return world->reflected ? lx_add(direct, lx_column_get(&received->reflected, i)) : direct;
}

/* Measures all cells of its lattice, by the pool; false: it was cancelled. */
bool lx_measure_lattice(struct lx_measuring *measuring, bool counts_itself);

/* The mean over the plane and the flux, where they are known. */
void lx_integrate_plane(const struct lx_measuring *measuring);
/* How far the average of the values may be from the mean over the plane. */
void lx_judge_sampling(const struct lx_measuring *measuring);
/* The body that a cell's centre is inside of; NULL: none. */
const struct lx_prepared_surface *lx_body_around_cell(const struct lx_measuring *measuring, unsigned column,
                                                      unsigned row);
/* Marks and counts the cells inside of bodies. */
void lx_find_enclosed_cells(const struct lx_measuring *measuring);

#endif

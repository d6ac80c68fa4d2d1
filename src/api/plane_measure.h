/* SPDX-License-Identifier: MIT */
/* The measure of a plane's cells: their irradiance, or what a small body at each of them receives (measure.h). */
#ifndef LX_API_PLANE_MEASURE_H
#define LX_API_PLANE_MEASURE_H

#include "../material/measure.h"
#include "../world/cells.h"
#include "../world/world.h"

struct lx_plane_measure {
    enum lx_measure measure;
    struct lx_lobe lobe, above; /* above: of places on a surface, which light from one side reaches */
    lx_bounded3 view;           /* the direction faced, or the normal */
    struct lx_response response;
};

/* The measure of a grid, whose axis is the normal of the cells, and which faces their upward direction. */
struct lx_plane_measure lx_plane_measure_of(enum lx_measure measure, const struct lx_cells *cells);

/* How reflected light counts; NULL: by the cosine. */
static inline const struct lx_response *lx_plane_response(const struct lx_plane_measure *measure)
{
    return measure->measure == LX_MEASURE_PLANE ? NULL : &measure->response;
}

/*
 * The light on elements of a plane that are complete, as received->irradiance and, where the world knows of reflected
 * light, received->reflected; their lobes and views become those of the measure.
 */
void lx_plane_light(const struct lx_world *world, const struct lx_plane_measure *measure, struct lx_elements *elements,
                    const struct lx_asking *asking, struct lx_received *received);

#endif

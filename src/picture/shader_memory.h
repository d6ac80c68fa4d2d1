/* SPDX-License-Identifier: MIT */
/* The memory that shading a run of pixels (shader.c) and its light of area lights (shader_area_lights.c) share. */
#ifndef LX_PICTURE_SHADER_MEMORY_H
#define LX_PICTURE_SHADER_MEMORY_H

#include "cluster/cut.h"
#include "penumbra.h"
#include "seen.h"
#include "shader.h"

/* For how many surfaces that a tile shows the cuts are kept from row to row. */
enum { KEPT_CUTS = 4 };

struct lx_shader_memory {
    struct lx_seen seen;
    double *sum; /* of the elements: the pixels' values where each of them is one, else: */
    double room_of_sum[LX_BLOCK];
    float open[LX_BLOCK];
    struct lx_sampling_memory *sampling;
    const struct lx_portion *portion; /* NULL: everything is summed */
    struct lx_light_room room;
    struct lx_penumbra penumbra;
    _Alignas(64) double tile_x[LX_BLOCK];
    double tile_y[LX_TILE_ROWS];
    size_t tile_rows, tile_columns;
    /* where points are clustered: */
    struct lx_cut cuts[KEPT_CUTS]; /* of a surface the one that its number leaves; of this tile where they have one */
    size_t cut_count;
    double error;
    double mirrored_error; /* of all pixels so far */
};

/* Whether a light is in the portion that is asked for. */
static inline bool lx_is_chosen(const struct lx_portion *portion, size_t light)
{
    return !portion || (portion->lights && (!portion->which || portion->which[light]));
}

/* Adds the extended sources' light over the gathered block of a surface's elements. */
void lx_light_by_area_lights(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                             struct lx_shader_memory *memory, size_t count, const struct lx_asking *asking);

#endif

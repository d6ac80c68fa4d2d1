/* SPDX-License-Identifier: MIT */
/* Which surfaces bound bodies, and which of those a place is in. */
#include "bodies.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../light/solid/extended.h"
#include "../surface/beside.h"
#include "among.h"

/* Whether a plane may meet what a shape bounds. */
static bool meets_plane(const struct lx_shape *shape, const struct lx_cells *plane)
{
    const double axis[3] = {plane->normal.x.value, plane->normal.y.value, plane->normal.z.value};
    double height = 0, size = shape->radius_mm;
    for (int k = 0; k < 3; k++) {
        height += axis[k] * (shape->anchor_mm[k] - plane->center_mm[k]);
        size += fabs(shape->anchor_mm[k]) + fabs(plane->center_mm[k]);
    }
    return !(fabs(height) > shape->radius_mm + 1e-12 * size);
}

/* Whether other surfaces cover the open ends of a shape. */
static bool is_closed(const struct lx_prepared *prepared, const struct lx_shape *shape)
{
    struct lx_shape_opening openings[LX_MOST_OPENINGS];
    const unsigned count = shape->kind->openings ? shape->kind->openings(shape, openings) : 0;
    bool is_closed = true;
    for (unsigned i = 0; i < count && is_closed; i++) {
        is_closed = false;
        for (size_t s = 0; s < prepared->surface_count && !is_closed; s++) {
            const struct lx_shape *cover = &prepared->surfaces[s].shape;
            is_closed = cover->kind->covers && cover->kind->covers(cover, &openings[i]);
        }
    }
    return is_closed;
}

/* Whether some light shines in it. */
static bool is_lit_within(const struct lx_prepared *prepared, const struct lx_shape *shape)
{
    for (size_t i = 0; i < prepared->emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&prepared->emitters, i, &room);
        if (lx_has_place(emitter) && lx_shape_encloses(shape, lx_emitter_center(emitter)))
            return true;
    }
    return false;
}

int lx_bodies_find(const struct lx_prepared *prepared, const struct lx_cells *plane, struct lx_bodies *bodies)
{
    *bodies = (struct lx_bodies){.prepared = prepared};
    for (size_t s = 0; s < prepared->surface_count; s++) {
        const struct lx_shape *shape = &prepared->surfaces[s].shape;
        if (!shape->kind->encloses || !meets_plane(shape, plane) || !is_closed(prepared, shape) ||
            is_lit_within(prepared, shape))
            continue;
        if (!bodies->are_bodies)
            bodies->are_bodies = lx_new_array(prepared->surface_count, sizeof *bodies->are_bodies);
        if (!bodies->are_bodies)
            return -1;
        bodies->are_bodies[s] = true;
    }
    return 0;
}

void lx_bodies_clear(struct lx_bodies *bodies)
{
    free(bodies->are_bodies);
    *bodies = (struct lx_bodies){.are_bodies = NULL};
}

/* The first of these surfaces around a place, or of all that are closed. */
static const struct lx_prepared_surface *first_around(const struct lx_prepared *prepared, const bool *these,
                                                      const double place_mm[3])
{
    struct lx_found found;
    const bool is_found = lx_among_place(prepared, place_mm, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const size_t s = lx_found_at(&found, is_found, i);
        const struct lx_shape *shape = &prepared->surfaces[s].shape;
        if ((!these || these[s]) && lx_shape_encloses(shape, place_mm) && (these || is_closed(prepared, shape)))
            return &prepared->surfaces[s];
    }
    return NULL;
}

const struct lx_prepared_surface *lx_surface_around(const struct lx_prepared *prepared, const double place_mm[3])
{
    return first_around(prepared, NULL, place_mm);
}

const struct lx_prepared_surface *lx_body_around(const struct lx_bodies *bodies, const double place_mm[3])
{
    return bodies->are_bodies ? first_around(bodies->prepared, bodies->are_bodies, place_mm) : NULL;
}

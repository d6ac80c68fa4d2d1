/* SPDX-License-Identifier: MIT */
/* The parts of surfaces: the surface itself, unless its kind says otherwise. */
#include "part.h"

#include <string.h>

unsigned lx_part_count(const struct lx_surface_kind *kind)
{
    return kind->part_names ? kind->part_count : 1;
}

void lx_part_make(const struct lx_surface_kind *kind, const void *parameters, unsigned i, struct lx_part *part)
{
    if (kind->part_names) {
        kind->part(parameters, i, part);
        return;
    }
    part->shape = lx_surface_shape(kind, parameters);
    part->kind = part->shape.kind;
    part->parameters = parameters;
    part->material = NULL;
}

size_t lx_piece_count(const struct lx_surface_kind *kind, const void *parameters)
{
    return kind->piece_count ? kind->piece_count(parameters) : lx_part_count(kind);
}

void lx_piece_make(const struct lx_surface_kind *kind, const void *parameters, size_t i, struct lx_part *piece,
                   unsigned *number)
{
    *number = (unsigned)i;
    if (kind->piece)
        *number = kind->piece(parameters, i, piece);
    else
        lx_part_make(kind, parameters, *number, piece);
}

const char *lx_part_name(const struct lx_surface_kind *kind, unsigned i)
{
    return kind->part_names ? kind->part_names[i] : NULL;
}

bool lx_part_flat(const struct lx_part *part, struct lx_flat *flat)
{
    extern const struct lx_surface_kind lx_plate_kind;
    if (part->kind != &lx_plate_kind)
        return false;
    const struct lx_plate_parameters *plate = part->parameters;
    memcpy(flat->center_mm, plate->center_mm, sizeof flat->center_mm);
    memcpy(flat->size_mm, plate->size_mm, sizeof flat->size_mm);
    memcpy(flat->axis, plate->axis, sizeof flat->axis);
    memcpy(flat->up, plate->up, sizeof flat->up);
    return true;
}

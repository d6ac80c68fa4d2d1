/* SPDX-License-Identifier: MIT */
/* The parts of surfaces: the surface itself, unless its kind says otherwise. */
#include "part.h"

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

/* SPDX-License-Identifier: MIT */
/* Extended emitters by their kind. */
#include <stdlib.h>

#include "extended.h"
#include "facets.h"
#include "round.h"

void lx_facets_free(struct lx_facets *facets)
{
    if (!facets)
        return;
    free(facets->corners_mm);
    free(facets->loop);
    free(facets->faces);
    free(facets->edges);
    free(facets);
}

bool lx_extended_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    if (emitter->type == LX_FACETS)
        return lx_facets_touch(emitter->facets, place_mm);
    return lx_round_touches(emitter, place_mm);
}

lx_bounded lx_extended_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal)
{
    if (emitter->type == LX_FACETS)
        return lx_mul(emitter->radiance, lx_facets_irradiance(emitter->facets, place_mm, normal));
    return lx_mul(emitter->radiance, lx_round_irradiance(emitter, place_mm, normal));
}

int lx_extended_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters)
{
    size_t first = emitters->count;
    int failed =
        emitter->type == LX_FACETS ? lx_facets_cut(emitter, parts, emitters) : lx_round_cut(emitter, parts, emitters);
    for (size_t i = first; i < emitters->count; i++)
        emitters->items[i].is_part = true;
    return failed;
}

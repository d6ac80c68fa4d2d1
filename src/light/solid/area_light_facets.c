/* SPDX-License-Identifier: MIT */
/* The end of the flat faces of an emitter, which several may use. */
#include "area_light_facets.h"

void lx_facets_free(struct lx_facets *facets)
{
    lx_kept_release((struct lx_kept *)facets);
}

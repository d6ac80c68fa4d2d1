/* SPDX-License-Identifier: MIT */
/* What a side is called: by its surface, the part of that, and which way it looks. */
#include "sides.h"

#include <string.h>

#include "../base/memory.h"
#include "../base/phrase.h"
#include "../scene/scene.h"
#include "../surface/part.h"

const char *luxel_surface_side_name(luxel_surface_side side)
{
    static const char *const names[] = {
        [LUXEL_SIDE_FRONT] = LX_N("front"),
        [LUXEL_SIDE_BACK] = LX_N("back"),
        [LUXEL_SIDE_OUTSIDE] = LX_N("outside"),
        [LUXEL_SIDE_INSIDE] = LX_N("inside"),
    };
    return side <= LUXEL_SIDE_INSIDE ? names[side] : NULL;
}

int lx_side_name(const struct lx_prepared *prepared, size_t surface, bool is_flat, bool is_back,
                 struct lx_named_side *named)
{
    const struct lx_prepared_surface *from = &prepared->surfaces[surface];
    const struct lx_item *item = &prepared->scene->surfaces.items[from->authored];
    const char *name = ((const struct lx_surface_common *)item->common)->name;
    *named = (struct lx_named_side){
        .surface = from->authored,
        .surface_name = name ? lx_copy_text(name, strlen(name)) : NULL,
        .part = from->part,
        .part_name = lx_part_name((const struct lx_surface_kind *)item->variant, from->part),
        .side = is_flat ? (is_back ? LUXEL_SIDE_BACK : LUXEL_SIDE_FRONT)
                        : (is_back ? LUXEL_SIDE_INSIDE : LUXEL_SIDE_OUTSIDE),
    };
    return name && !named->surface_name ? -1 : 0;
}

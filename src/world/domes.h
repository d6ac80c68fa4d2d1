/* SPDX-License-Identifier: MIT */
/* The light of a dome on an element. */
#ifndef LX_WORLD_DOMES_H
#define LX_WORLD_DOMES_H

#include "element.h"
#include "open_domes.h"
#include "prepared.h"

/* Patch by patch; those that the element does not look to give nothing. */
struct lx_lighting lx_light_by_dome(const struct lx_prepared *prepared, const struct lx_element *element,
                                    const struct lx_dome *dome);

#endif

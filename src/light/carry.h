/* SPDX-License-Identifier: MIT */
/*
 * Emitters as another frame has them: what a picture whose screen stands elsewhere is computed from.  They have the
 * same numbers, and but for roundings the same light.
 */
#ifndef LX_LIGHT_CARRY_H
#define LX_LIGHT_CARRY_H

#include "../base/frame.h"
#include "emitter.h"

/*
 * Carries a list into a frame.  Facets and clouds, which scenes share, are copied.  0, or -1 when memory ran out or
 * where the work is to stop; release `carried` with lx_emitters_clear() in any case.
 */
int lx_emitters_carry(const struct lx_emitters *emitters, const struct lx_frame *frame, const struct lx_asking *asking,
                      struct lx_emitters *carried);

/* Copies of facets and of a cloud in a frame, for lx_facets_free() and lx_cloud_free(); NULL as -1 above. */
struct lx_facets *lx_facets_carry(const struct lx_facets *facets, const struct lx_frame *frame,
                                  const struct lx_asking *asking);
struct lx_cloud *lx_cloud_carry(const struct lx_cloud *cloud, const struct lx_frame *frame,
                                const struct lx_asking *asking);

#endif

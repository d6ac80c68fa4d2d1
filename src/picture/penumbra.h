/* SPDX-License-Identifier: MIT */
/*
 * Penumbrae: what surfaces hide of extended sources from the pixels of a picture.
 *
 * For each surface and source the plan lists what may be in the way at all (lx_find_area_light_blockers()); for a run
 * of pixels, then for each of them, that is tried again, so that most see the whole source, or nothing of it.  What is
 * left has the integral of the reference (cubature.h) over what it sees, to the accuracy of the picture, and depends on
 * its element alone.
 */
#ifndef LX_PICTURE_PENUMBRA_H
#define LX_PICTURE_PENUMBRA_H

#include "../world/blocking.h"
#include "../world/visibility/occlusion.h"
#include "plan.h"

/* What an element sees of a source. */
enum lx_share_seen { LX_SEES_ALL, LX_SEES_PART, LX_SEES_NOTHING };

/* What a thread needs. */
struct lx_penumbra {
    struct lx_occlusion occlusion;
    uint8_t sight[LX_BLOCK]; /* of the elements that were looked at last, which are: */
    const struct lx_planned_area_light *source;
    size_t first, end;
    double elements[6][LX_BLOCK]; /* places and normals */
    struct lx_occlusion *kept; /* what is in their way, where they see a part and it is not too much; NULL at first */
    bool is_kept[LX_BLOCK];
    struct lx_occlusion *used; /* the last one that was asked for */
};

void lx_penumbra_init(struct lx_penumbra *penumbra);
void lx_penumbra_clear(struct lx_penumbra *penumbra);

/* Lists the surfaces that may stand between a surface and a source; 0, or -1 when memory ran out. */
int lx_find_area_light_blockers(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                struct lx_planned_area_light *planned);

/* Whether some of them may stand between places in a ball, an offset from the surface's anchor, and the source. */
bool lx_area_light_may_be_hidden(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                 const struct lx_planned_area_light *planned, const struct lx_ball *ball);

/*
 * What the elements from `first` to `end` of a block see of a source -> sight; whether all of them see all.  Where
 * memory runs out they see nothing.
 */
bool lx_find_sight(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                   const struct lx_planned_area_light *planned, const struct lx_block_double *block, size_t first,
                   size_t end, struct lx_penumbra *penumbra);

/* What is in the way of element i of a block, which was looked at and sees a part -> used: as it was kept, or gathered
 * once more. */
void lx_look_again(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                   const struct lx_planned_area_light *planned, const struct lx_element *element, size_t i,
                   struct lx_penumbra *penumbra);

/*
 * The diffuse light and the highlight of element i of a block, which was looked at and sees a part of a source;
 * `known`: how bright it is, and the picture somewhere.  The highlight of a part is quick; false: it is not for this
 * part.
 */
double lx_diffuse_of_part(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                          const struct lx_planned_area_light *planned, const struct lx_element *element, size_t i,
                          struct lx_penumbra *penumbra, const struct lx_asking *asking);
bool lx_partial_highlight_of_part(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                                  const struct lx_planned_area_light *planned, const struct lx_element *element,
                                  size_t i, double known, struct lx_penumbra *penumbra, const struct lx_asking *asking,
                                  double *highlight);
double lx_highlight_of_part(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                            const struct lx_planned_area_light *planned, const struct lx_element *element, size_t i,
                            double known, struct lx_penumbra *penumbra, const struct lx_asking *asking);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Extended sources for pictures: what the kernels need of one, as seen from a surface's anchor, and its cutting into
 * patches, cells and samples, over which highlights are integrated.
 */
#ifndef LX_SHADE_SHELL_H
#define LX_SHADE_SHELL_H

#include <luxel/status.h>

#include "../base/rows.h"
#include "kernel.h"

/* LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED.  Release with lx_shell_clear() in any case. */
luxel_status lx_shell_make(const struct lx_emitter *emitter, const struct lx_shape *lit, const struct lx_asking *asking,
                           struct lx_shell *shell);
void lx_shell_clear(struct lx_shell *shell);
/* Adds what the kernels in float32 need of facets.  LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED. */
luxel_status lx_shell_make_single(struct lx_shell *shell, const struct lx_asking *asking);

/*
 * A smooth part of a shell over the unit square (s, t).
 *
 * flat   o + s a + t b + s t g
 * disk   o + s radius (a cos + b sin)(2 pi t)
 * ball   LX_BALL_SHAPED of kernel.h, x = s, turned by 2 pi t
 * side   LX_SIDE of kernel.h, x = (s - 1/2) length, y = 2 t - 1
 *
 * On the latter two each element has places of its own.
 */
enum lx_patch_kind { LX_PATCH_FLAT, LX_PATCH_DISK, LX_PATCH_BALL, LX_PATCH_SIDE };

struct lx_patch {
    enum lx_patch_kind kind;
    double o[3], a[3], b[3], g[3], n[3]; /* from the anchor; n is the normal of a flat one or a disk */
    double area[3];                      /* of a flat one, for a unit of s and t: area[0] + s area[1] + t area[2] */
    double radius, length;
};

/* The patches of a shell that some place within a ball may see; at most lx_patch_limit() of them.  Not all of them
 * where the work is to stop. */
enum { LX_MOST_ROUND_PATCHES = 3 }; /* of what has no facets: a side and two ends */
size_t lx_patch_limit(const struct lx_shell *shell);
size_t lx_patches_make(const struct lx_shell *shell, const struct lx_around *around, const struct lx_asking *asking,
                       struct lx_patch *patches);

/* A part of a patch: s from s to s + ds, t from t to t + dt. */
struct lx_cell {
    double s, t, ds, dt;
};

/* Whether it is the whole of a disk or a ball, for which a full turn is left uncut. */
bool lx_cell_is_round(const struct lx_patch *patch, const struct lx_cell *cell);

/* The middle of a cell, the same for all elements unless the patch is a ball's or a side's, and how far away from it
 * its places are at most; less than 0 where the element is in the body. */
double lx_cell_look(const struct lx_patch *patch, const struct lx_cell *cell, const double element[3],
                    double middle[3]);

/* Sets what all samples on a patch have in common. */
void lx_patch_samples(const struct lx_patch *patch, double touch_mm, struct lx_samples_double *samples);

/* The product rules of Gauss with side x side points, side from 1 to 3; they weigh area. */
void lx_cell_samples(const struct lx_patch *patch, const struct lx_cell *cell, unsigned side, double gain, size_t first,
                     struct lx_samples_double *samples);

/* For what is round: `rings` circles, from 1 to 3, by the rule of Gauss between two shares s of the radius, with so
 * many samples on each, equally far from each other; the first is so many times their distance from t = 0. */
void lx_round_samples(const struct lx_patch *patch, double from_s, double to_s, unsigned rings, unsigned spokes,
                      double off, double gain, struct lx_samples_double *samples);

#endif

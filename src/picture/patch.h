/* SPDX-License-Identifier: MIT */
/*
 * Patches: the smooth parts of an extended source's area light, and their cutting into cells and samples, over which
 * highlights are integrated.
 *
 * A patch that is large against its distance is near: some of it is seen at many times the size of the rest, and its
 * cells follow that, whatever the ratio of lengths.  What is cut unseen is cut across its longer side alone, so that no
 * cell becomes a sliver; a disk's and a ball's would, round the middle, the more of them the greater the ratio.
 */
#ifndef LX_PICTURE_PATCH_H
#define LX_PICTURE_PATCH_H

#include "area_light.h"

/*
 * A smooth part of an area light over the unit square (s, t).
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
    double breadth; /* of a side, as far as it is seen round: for a unit of t */
    bool is_near;   /* large against its distance from some place that may see it */
};

/* The patches of an area light that some place within a ball may see; at most lx_patch_limit() of them.  Not all of
 * them where the work is to stop. */
enum { LX_MOST_ROUND_PATCHES = 3 }; /* of what has no facets: a side and two ends */
size_t lx_patch_limit(const struct lx_area_light *lamp);
size_t lx_patches_make(const struct lx_area_light *lamp, const struct lx_around *around, const struct lx_asking *asking,
                       struct lx_patch *patches);

/* A part of a patch: s from s to s + ds, t from t to t + dt. */
struct lx_cell {
    double s, t, ds, dt;
};

/* Whether it is the whole of a disk or a ball, for which a full turn is left uncut. */
bool lx_cell_is_round(const struct lx_patch *patch, const struct lx_cell *cell);

/* A quarter of a cell, both of its sides halved; of what is round, which the rule of Gauss is not for, a sector. */
enum { LX_QUARTERS = 4 };
struct lx_cell lx_cell_quarter(const struct lx_patch *patch, const struct lx_cell *cell, int quarter);

/* Whether a cell is so long that, where no rule is to tell its error by its quarters, it is better cut across its
 * longer side alone; and a fourth part of it, cut so where it is. */
bool lx_cell_is_long(const struct lx_patch *patch, const struct lx_cell *cell);
struct lx_cell lx_cell_fourth(const struct lx_patch *patch, const struct lx_cell *cell, int fourth);

/* How far an element is above the plane of what is flat, or above what is bent where that is nearest. */
double lx_patch_above(const struct lx_patch *patch, const double element[3]);

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

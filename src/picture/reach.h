/* SPDX-License-Identifier: MIT */
/*
 * Where light arrives: which pixels show an element that some source shines on, shadows included.  That is a question
 * of geometry, N.L > 0 for some source or for a part of one, not of values: the tail of a highlight that is not gated
 * shows behind the terminator, too, and ambient light, which is left out here, everywhere.
 *
 * It is asked of the irradiance by the law 1/r^2, whatever the sources' own laws are: where light arrives it does by
 * any law, and this one has closed forms.
 */
#ifndef LX_PICTURE_REACH_H
#define LX_PICTURE_REACH_H

#include "shader.h"

/* Set once, then only read; it stays where it is. */
struct lx_reach {
    bool has_ambient, has_direct; /* light of this kind, and any that comes from somewhere */
    struct lx_prepared prepared;
    struct lx_plan plan;
};

/*
 * Opens it with the kernels and settings (light_error, progress) that the picture itself has.  LUXEL_OK,
 * LUXEL_ERROR_MEMORY or LUXEL_CANCELLED; release with lx_reach_clear() in any case.
 */
luxel_status lx_reach_open(struct lx_reach *reach, const struct lx_scene_parameters *scene,
                           const struct lx_kernels *kernels, const luxel_settings *settings);
void lx_reach_clear(struct lx_reach *reach);

/*
 * Whether light arrives at what is seen through the points (x[i], y): arrives[i] is 1 or 0, and 0 off every surface,
 * where mask[i] is 0, too.
 * `count` is no more than LX_BLOCK; `memory` is made for the plan of the reach.
 */
void lx_reach_row(const struct lx_reach *reach, struct lx_shader_memory *memory, double y_mm, const double *x_mm,
                  size_t count, uint8_t *mask, uint8_t *arrives);

/* The share of the pixels at all (x[i], y[j]) that show a surface at which light arrives; 0 without any.
 * LUXEL_OK or LUXEL_ERROR_MEMORY. */
luxel_status lx_reach_share(const struct lx_reach *reach, const double *x_mm, unsigned columns, const double *y_mm,
                            unsigned rows, double *share);

/*
 * Whether every value above 0 of a picture is the light of a source that the element faces, so that nothing need be
 * asked: no ambient light counts, and no highlight does behind the terminator.
 */
bool lx_reach_is_plain(const struct lx_prepared *prepared, luxel_quantity quantity);

#endif

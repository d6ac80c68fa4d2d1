/* SPDX-License-Identifier: MIT */
/*
 * Shapes in blocks: lines of sight that meet them, elements made whole, and light that they take away, by the kernels
 * that a shape has, or else by its kind's float64 reference.  Arguments and results are as kernel.h has them.
 */
#ifndef LX_WORLD_GENERAL_H
#define LX_WORLD_GENERAL_H

#include "../kernel/kernel.h"
#include "../surface/surface.h"

/* Whether a shape has kernels of its own, so that all that is made for these may be used. */
static inline bool lx_has_kernels(const struct lx_shape *shape)
{
    return shape->type < LX_SHAPE_TYPES;
}

size_t lx_meet_shape(const struct lx_kernels *kernels, const struct lx_shape *shape, const struct lx_row_view *view,
                     const double *x_mm, size_t count, double *depth, double *px, double *py, double *pz);

/* `eye`: where lines of sight start, from the anchor, or the direction that they come from. */
void lx_complete_shape(const struct lx_kernels *kernels, const struct lx_shape *shape, const double *observer_mm,
                       const struct lx_origin *eye, struct lx_block_double *block, struct lx_block_single *copy,
                       size_t count);

/* Functions for shapes that have kernels. */
static inline void lx_set_shape_columns(const struct lx_kernels *kernels, const struct lx_shape *shape,
                                        const double *x_mm, size_t count, struct lx_columns *columns)
{
    kernels->set_columns[shape->type](shape, x_mm, count, columns);
}

static inline struct lx_stretch lx_view_shape(const struct lx_kernels *kernels, const struct lx_shape *shape,
                                              const struct lx_row_view *view, const struct lx_columns *columns,
                                              struct lx_block_single *block, uint8_t *mask)
{
    return kernels->view_single[shape->type](shape, view, columns, block, mask);
}

/* `is_own`: of elements that lie on the shape itself. */
void lx_block_shape(const struct lx_kernels *kernels, const struct lx_blocker *blocker, bool is_own,
                    const struct lx_block_double *block, size_t count, float *open);

#endif

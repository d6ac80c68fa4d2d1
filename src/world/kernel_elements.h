/* SPDX-License-Identifier: MIT */
/* Light on batches of elements: the functions of one instruction set (kernel_bounded.c), those of shapes by type. */
#ifndef LX_WORLD_KERNEL_ELEMENTS_H
#define LX_WORLD_KERNEL_ELEMENTS_H

#include "general.h"
#include "gradient.h"

/* Questions about a batch; members that were not asked for mean nothing. */
enum lx_wanted { LX_WANT_IRRADIANCE = 1, LX_WANT_BRIGHTNESS = 2, LX_WANT_REFLECTED = 4 };

/* Whether light gets from an emitter to elements, 1 or 0; where that is in doubt, the reference is to be asked. */
struct lx_openness {
    struct lx_column open;
    bool in_doubt[LX_BATCH];
    bool any_in_doubt;
};

/* The ways from elements to an emitter that is a point or a direction. */
struct lx_ways {
    bool endless;
    double to[3]; /* the place of a point, the unit vector of a direction */
    double room;  /* edges are passed by so many times more than decides with certainty, or are in doubt: 1 at least */
};

/* The functions of one instruction set. */
struct lx_element_kernels {
    /* Makes unit vectors of columns of exact values, `count` of them. */
    void (*unit)(struct lx_columns3 *columns, size_t count);
    /* The views from elements to a place, exact, whose columns are set. */
    void (*look_at)(const double place_mm[3], struct lx_elements *elements);
    /* By the type of a shape that has kernels (general.h).  Sets own[i] to `surface`, its number from 1, where it is 0
     * and the place lies on the shape, as the kind has it. */
    void (*hold[LX_SHAPE_TYPES])(const struct lx_shape *shape, uint32_t surface, struct lx_elements *elements);
    /* Sets what the shape leaves to elements that lie on it, or that they ask. */
    void (*settle[LX_SHAPE_TYPES])(const struct lx_shape *shape, uint32_t surface, struct lx_elements *elements);
    /* Closes the ways that the surfaces which elements lie on do not leave. */
    void (*close_own)(const struct lx_ways *ways, const struct lx_elements *elements, struct lx_openness *openness);
    /* Closes the ways that a shape stands in, of elements that do not lie on it. */
    void (*close[LX_SHAPE_TYPES])(const struct lx_shape *shape, uint32_t surface, const struct lx_ways *ways,
                                  const struct lx_elements *elements, struct lx_openness *openness);
    /* Adds the light of an emitter that is not extended; open: NULL where all ways are. */
    void (*light)(const struct lx_emitter *emitter, const struct lx_elements *elements, const struct lx_column *open,
                  enum lx_wanted wanted, struct lx_received *received);
    /* Sets the gradient of that light, of one of the two, by the emitter's numbers, and adds the one by the elements';
     * those that `needs` asks for (gradient.h).  Adds the elements that are in doubt. */
    void (*gradient)(const struct lx_emitter *emitter, const struct lx_elements *elements, const struct lx_column *open,
                     enum lx_wanted wanted, unsigned needs, struct lx_gradient *gradient);
    /* Adds a derivative by something that changes at a rate. */
    void (*add_rate)(const struct lx_column *derivative, lx_bounded rate, size_t count, struct lx_column *sum);
    /* The value of what is received, one of the two, and a sum that it is added to. */
    void (*sum)(const struct lx_received *received, enum lx_wanted wanted, size_t count, struct lx_column *value,
                struct lx_column *total);
};

/* Those of the same set as kernels that were built. */
const struct lx_element_kernels *lx_element_kernels_of(const struct lx_kernels *kernels);

/* By a shape's own functions; false where it has none, so that only its kind knows. */
static inline bool lx_hold_shape(const struct lx_element_kernels *kernels, const struct lx_shape *shape,
                                 uint32_t surface, struct lx_elements *elements)
{
    if (lx_has_kernels(shape))
        kernels->hold[shape->type](shape, surface, elements);
    return lx_has_kernels(shape);
}

static inline bool lx_settle_shape(const struct lx_element_kernels *kernels, const struct lx_shape *shape,
                                   uint32_t surface, struct lx_elements *elements)
{
    if (lx_has_kernels(shape))
        kernels->settle[shape->type](shape, surface, elements);
    return lx_has_kernels(shape);
}

static inline bool lx_close_shape(const struct lx_element_kernels *kernels, const struct lx_shape *shape,
                                  uint32_t surface, const struct lx_ways *ways, const struct lx_elements *elements,
                                  struct lx_openness *openness)
{
    if (lx_has_kernels(shape))
        kernels->close[shape->type](shape, surface, ways, elements, openness);
    return lx_has_kernels(shape);
}

#endif

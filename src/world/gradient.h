/* SPDX-License-Identifier: MIT */
/*
 * Gradients: how the value at an element changes with the numbers that the light of an emitter is computed with (its
 * place, strength, axis, cone, law) and with the element's own (place, normal, view, and its lobe's factors).
 */
#ifndef LX_WORLD_GRADIENT_H
#define LX_WORLD_GRADIENT_H

#include "elements.h"

/* The numbers, those of vectors side by side; of parallel light LX_BY_ORIGIN is its direction. */
enum lx_by {
    LX_BY_ORIGIN = 0,
    LX_BY_STRENGTH = 3,
    LX_BY_AXIS = 4,
    LX_BY_INNER = 7, /* the cone's angles, or their versines where its falloff goes by these */
    LX_BY_OUTER,
    LX_BY_PATTERN, /* the exponent of the profile's cosine */
    LX_BY_LAW,     /* k, or the coefficients of a polynomial */
    LX_BY_EMITTER = 13,
    LX_BY_PLACE = LX_BY_EMITTER,
    LX_BY_NORMAL = 16,
    LX_BY_VIEW = 19,
    LX_BY_DIFFUSE = 22,
    LX_BY_SPECULAR,
    LX_BY_SHININESS,
    LX_BY_AMBIENT,
    LX_BY_ALL
};

/* Those numbers that are wanted, as a set of bits. */
#define LX_BIT_BY(number) (1u << (number))

/* The gradient at a batch: by an emitter's numbers, of that one alone, and by the elements', summed over emitters. */
struct lx_gradient {
    struct lx_column by[LX_BY_ALL];
    /* The value may have no derivative here: it jumps or turns within next to nothing. */
    bool in_doubt[LX_BATCH];
};

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Batches of surface elements anywhere, as they are for the reference (reference.h), but side by side: a structure of
 * arrays of bounded numbers.  Measuring grids, probes, evaluators and sections hand over such batches to a world
 * (world.h), which knows no picture.
 *
 * What lights a batch are the operations of the reference on vectors, in the same order and without contraction, one
 * source compiled once for each instruction set (kernel_bounded.c).  So an element's number and its bound are those of
 * the reference to the last bit, whatever the set, the batch and the place in it.
 */
#ifndef LX_WORLD_ELEMENTS_H
#define LX_WORLD_ELEMENTS_H

#include <stdint.h>

#include "blocking.h"
#include "reference.h"

/* Elements of a batch, and numbers of a vector, at most. */
enum { LX_BATCH = 64, LX_VECTOR = 8 };

/* Bounded numbers of a batch, in whole vectors. */
struct lx_column {
    _Alignas(64) double value[LX_BATCH];
    double error[LX_BATCH];
};

struct lx_columns3 {
    struct lx_column x, y, z;
};

/* Balls are larger than what they hold by this share of how far that is from the origin. */
#define LX_BALL_ROOM 1e-12

struct lx_elements {
    size_t count;
    const struct lx_lobe *lobe; /* all have the same */
    bool are_free;              /* as struct lx_element has it */
    struct lx_columns3 place_mm, normal, view;
    uint32_t own[LX_BATCH]; /* the surface that each lies on, from 1; 0: none */
    /*
     * What its own surface leaves to a free element with a normal of its own: the light that comes from where its
     * `side` looks to.  0 where all is left.  Where `asks` is set only the reference knows.
     */
    _Alignas(64) double side_x[LX_BATCH];
    double side_y[LX_BATCH], side_z[LX_BATCH];
    bool has_sides;
    bool asks[LX_BATCH];
    enum lx_shown shown[LX_BATCH];
    bool has_exact_normals;
    struct lx_ball around; /* all places, with room for rounding */
};

/*
 * A batch begins, gets elements and ends: then it goes on to whole vectors.  Elements are appended as the reference
 * made them, those that are free lit as only the reference knows, or as places whose normals, not yet of unit length,
 * and views, unless they are NULL, come with them (lx_world_settle() completes those), or from another batch of the
 * same lobe.
 */
void lx_elements_begin(struct lx_elements *elements, const struct lx_lobe *lobe, bool are_free);
void lx_elements_append(const struct lx_prepared *prepared, struct lx_elements *elements,
                        const struct lx_element *element);
void lx_elements_append_place(struct lx_elements *elements, lx_bounded3 place_mm, lx_bounded3 normal,
                              const double view[3]);
void lx_elements_copy(struct lx_elements *to, const struct lx_elements *from, size_t k);
void lx_elements_end(struct lx_elements *elements);

/* A batch of one element that the reference made. */
void lx_elements_of_one(const struct lx_prepared *prepared, const struct lx_element *element,
                        struct lx_elements *elements);

/* Element i of a batch on its own, and a number and a vector of it. */
struct lx_element lx_elements_get(const struct lx_prepared *prepared, const struct lx_elements *elements, size_t i);
void lx_column_clear(struct lx_column *column, size_t count); /* whole vectors that hold so many numbers */
lx_bounded lx_column_get(const struct lx_column *column, size_t i);
lx_bounded3 lx_columns_get(const struct lx_columns3 *columns, size_t i);

/* The light that a batch receives, from some emitters and from surfaces. */
struct lx_received {
    struct lx_column irradiance, diffuse, specular;
    struct lx_column reflected; /* irradiance by what surfaces send to each other */
    size_t parts[LX_BATCH];     /* as in struct lx_lighting */
    bool on_element[LX_BATCH];  /* one of the emitters lies on the element: there is no value */
};

#endif

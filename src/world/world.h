/* SPDX-License-Identifier: MIT */
/*
 * A world: what shines, what is lit and what stands between, without a screen and without a maximum.  It is asked one
 * thing: how much light falls on these elements, direct and reflected, with a bound of its error.
 *
 * The numbers are the reference's, bit for bit: points, directions and uniform light are computed for a batch at once
 * (elements.h), extended sources, and whatever vectors cannot tell, element by element.
 */
#ifndef LX_WORLD_WORLD_H
#define LX_WORLD_WORLD_H

#include "../base/rows.h"
#include "kernel_elements.h"

struct lx_radiosity;

struct lx_world {
    const struct lx_prepared *prepared;
    const struct lx_element_kernels *kernels;
    struct lx_radiosity *reflected; /* what surfaces send to each other; NULL: nothing, or it is not known yet */
    bool by_tiles;                  /* quickly on surfaces, with a bound that holds on all of a tile; else as exactly
                                     * as it is known at each place */
    /* Sets what is reflected to elements; given by the room that knows (reflect/reflected.h). */
    void (*reflect)(const struct lx_world *world, const struct lx_elements *elements, const struct lx_asking *asking,
                    struct lx_received *received);
};

/* Whether a batch has the light of an emitter by vectors; of extended sources, luminaires, what comes through glass,
 * and where there are mirrors, it asks the reference. */
bool lx_world_is_vectored(const struct lx_prepared *prepared, const struct lx_emitter *emitter);

/*
 * How many elements a piece of work for one thread should have: a batch, or a single one where some source takes long
 * for each element.
 */
unsigned lx_world_batch(const struct lx_world *world);

/* How the elements of a batch, appended as places, are to be completed. */
struct lx_settling {
    bool has_normals; /* which are of unit length already */
    bool has_views;   /* which were appended, but need not be of unit length; else they are as the scene says */
};

/*
 * Completes a batch of free elements that were appended as places: normals and views of unit length, and the surfaces
 * that they lie on.  Their lobes are not the batch's where they lie on a surface.
 */
void lx_world_settle(const struct lx_world *world, const struct lx_settling *settling, struct lx_elements *elements);

/*
 * The light of all emitters together, and what is reflected, 0 where the world knows of nothing that is.  Something
 * else where the work is to stop.
 */
void lx_world_light(const struct lx_world *world, const struct lx_elements *elements, enum lx_wanted wanted,
                    const struct lx_asking *asking, struct lx_received *received);

/* The direct light of one light alone, whose emitters follow *next, which moves behind them; 0 where it has none. */
void lx_world_light_of(const struct lx_world *world, const struct lx_elements *elements, size_t light,
                       enum lx_wanted wanted, const struct lx_asking *asking, size_t *next,
                       struct lx_received *received);
/* The direct light of the emitters from `first` on and before `end`. */
void lx_world_light_between(const struct lx_world *world, const struct lx_elements *elements, size_t first, size_t end,
                            enum lx_wanted wanted, const struct lx_asking *asking, struct lx_received *received);

/* The gradient of the light of an emitter that is vectored, of elements whose lobe is a power or without a highlight,
 * as the kernel makes it; at borders of shadows it is in doubt. */
void lx_world_gradient(const struct lx_world *world, const struct lx_elements *elements,
                       const struct lx_emitter *emitter, enum lx_wanted wanted, unsigned needs,
                       struct lx_gradient *gradient);

#endif

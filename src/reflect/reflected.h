/* SPDX-License-Identifier: MIT */
/*
 * Reflected light of a scene: the irradiance E_r that surfaces send to each other by Lambert's law, with a bound of its
 * error.
 *
 * The direct irradiance E_d of each face is known at any place.  The reflected one obeys E_r = K rho (E_d + E_r), where
 * K is the integral over all faces that are seen; it is a polynomial on each of some tiles, graded towards edges,
 * found by collocation at their nodes.  How far the right side of the equation is from the polynomials, the residual,
 * is looked for between the nodes; errors e of the solution obey |e| <= |residual| + K rho |e|, which is solved as
 * well.  One more integral gives E_r at any place, and of the errors, too.  docs/MATHS.md, "Reflected light".
 */
#ifndef LX_REFLECT_REFLECTED_H
#define LX_REFLECT_REFLECTED_H

#include "../shade/reference.h"
#include "../shade/world.h"
#include "veil.h"

struct lx_radiosity;

/* A place whose reflected light is wanted, and how large the error may be beside what is reflected: the direct
 * irradiance there. */
struct lx_reflected_place {
    struct lx_receiver receiver;
    double direct;
};

struct lx_reflected_wish {
    const struct lx_prepared *prepared;
    const struct lx_element_kernels *kernels;
    double error; /* the bound wanted: relative to the value of each place or, without places, to the greatest value */
    const struct lx_reflected_place *places; /* tiles are refined for these; NULL: for all that there is */
    size_t place_count;
    unsigned threads;
    struct lx_control *control;
};

/* LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED. */
luxel_status lx_reflected_make(const struct lx_reflected_wish *wish, struct lx_radiosity **made);
void lx_reflected_free(struct lx_radiosity *reflected);

/* The receiver of an element. */
struct lx_receiver lx_receiver_of(const struct lx_prepared *prepared, const struct lx_element *element);

/* The reflected irradiance of a receiver; `veils` is memory of the caller, zero-initialised at first. */
lx_bounded lx_reflected_at(const struct lx_radiosity *reflected, const struct lx_receiver *receiver,
                           struct lx_veils *veils);

#endif

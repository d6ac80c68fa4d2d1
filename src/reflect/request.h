/* SPDX-License-Identifier: MIT */
/* The request for a solution of reflected light: its scene, the bound, and the places that this is for. */
#ifndef LX_REFLECT_REQUEST_H
#define LX_REFLECT_REQUEST_H

#include "../world/prepared.h"
#include "../world/world.h"
#include "receiver.h"

/* The settings that a solution for a picture was made with, beside its scene. */
struct lx_reflected_key {
    int quantity;
    double error, tolerance;
    const void *kernels;
    const bool *on; /* which lights give light; in the key of a solution its own */
    double within;  /* seconds that it may take; 0: no end */
    bool is_asked;  /* somebody may say that it is enough */
};

/* A place whose reflected light is wanted, and how large the error may be beside what is reflected: the direct
 * irradiance there. */
struct lx_reflected_place {
    struct lx_receiver receiver;
    double direct;
};

/* A place of a surface that a picture shows: what its value takes of the reflected irradiance, and what it has beside
 * that, or less. */
struct lx_reflected_spot {
    size_t surface;
    double place_mm[3], normal[3];
    double share, value;
};

struct lx_reflected_request {
    const struct lx_prepared *prepared;
    const struct lx_element_kernels *kernels;
    double error; /* the bound wanted: relative to the value of each place, or of spots and means to the greatest */
    const struct lx_reflected_place *places; /* tiles are refined for these, or where there are none for: */
    size_t place_count;
    const struct lx_reflected_spot *spots; /* and where there are neither, for the means of all sides */
    size_t spot_count;
    struct lx_reflected_key key;
    size_t effort; /* that the work may take, and little more; 0: a minute or two of one core (base/effort.h) */
    unsigned threads;
    struct lx_control *control;
    double within;                               /* seconds after which the best so far is taken; 0: no end */
    bool (*is_enough)(double bound, void *data); /* so, too, once this is true (base/rows.h); NULL */
};

#endif

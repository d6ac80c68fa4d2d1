/* SPDX-License-Identifier: MIT */
/*
 * The luminous opening of a luminaire: where on it the light comes from.  Each part dA of the opening is a point with
 * the whole distribution and the share dA/A of the intensity, so nothing depends on the angle under which a part is
 * seen, and all of a body's surface counts, from whichever side.  An opening is made of emitters of some size with the
 * luminaire's profile; flat ones have two sides, of which an element sees one.
 */
#ifndef LX_LIGHT_OPENING_H
#define LX_LIGHT_OPENING_H

#include <luxel/photometry.h>

#include "../parameter/check.h"
#include "distribution.h"
#include "light.h"

enum lx_opening_word { LX_OPENING_IS_POINT, LX_OPENING_IS_OF_FILE };

struct lx_opening_shape {
    uint64_t given;
    double size_mm[3]; /* of a rectangle and of a box: along c0, along C = 90, along the axis */
    double radius_mm, height_mm;
    double radii_mm[3]; /* of one that a file declares and that is not round; 0: it is (light/solid/elliptic.h) */
    double center_mm[3];
    double axis[3];
};

/* A group that may be a word (struct lx_worded of table.h). */
struct lx_opening {
    uint64_t given;
    int word; /* enum lx_opening_word; -1: one of: */
    struct lx_opening_shape rectangle, disk, box, sphere, cylinder;
};

extern const char *const lx_opening_words[];
extern const struct lx_table lx_opening_table;

/* The opening that a file declares, as one of the shapes; false: it has none. */
bool lx_opening_of_file(const luxel_photometry_opening *declared, const struct lx_pointed *pointed,
                        struct lx_opening *opening);

/* Appends the emitters of an opening that is no word; `point` is the luminaire as a point.  0, or -1 where memory ran
 * out. */
int lx_opening_emit(const struct lx_opening *opening, const struct lx_emitter *point, struct lx_emitters *emitters);

#endif

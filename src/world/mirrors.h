/* SPDX-License-Identifier: MIT */
/*
 * Mirrors: the ways by which light comes to elements over some of them, one after the other, and what a sight that is
 * mirrored meets.
 *
 * A way that is mirrored is straight where space is unfolded: what lies before a mirror is carried to where its image
 * stands, so that a light shines on the image of an element by a straight way that passes through the mirror.  A way
 * over the mirrors m1, ..., mk, in this order from the element on, has a frame that carries what lies before m1 into
 * the space in which the lights stand, by the planes of m1, then m2, and so on; what lies between m1 and m2 is carried
 * by the frame of the way over m2, ..., mk, and so on to the lights themselves.  docs/MATHS.md says more.
 */
#ifndef LX_WORLD_MIRRORS_H
#define LX_WORLD_MIRRORS_H

#include <stdint.h>

#include "element.h"
#include "prepared.h"

/* What of a mirror a way may pass, as the other mirrors of the way leave it: a convex polygon in the space of the
 * lights, and its plane n.x = height, the lights being where that is more. */
struct lx_aperture {
    unsigned count;
    double (*corners_mm)[3];
    double normal[3], height_mm;
};

struct lx_mirror_way {
    unsigned count;                /* of the mirrors */
    uint32_t surface;              /* m1, one of the prepared surfaces */
    size_t rest;                   /* the way over the others; LX_NO_WAY: there are none */
    struct lx_frame frame;         /* of what lies before m1 */
    struct lx_shape *shapes;       /* all surfaces, carried by that; NULL where the way is over too many mirrors */
    struct lx_aperture *apertures; /* of m1, ..., mk */
    double (*corners_mm)[3];       /* of all of them */
};

#define LX_NO_WAY SIZE_MAX

/* The way over all mirrors but the first; NULL: there are no others. */
static inline const struct lx_mirror_way *lx_rest_of(const struct lx_prepared *prepared,
                                                     const struct lx_mirror_way *way)
{
    return way->rest == LX_NO_WAY ? NULL : &prepared->mirrors.ways[way->rest];
}

/* A surface as the frame of a way carries it; NULL: as it is. */
static inline const struct lx_shape *lx_mirrored_shape(const struct lx_prepared *prepared,
                                                       const struct lx_mirror_way *way, size_t surface)
{
    return way ? &way->shapes[surface] : &prepared->surfaces[surface].shape;
}

/*
 * Finds the mirrors of a prepared scene and the ways over at most so many of them; of a carried scene `from` is what
 * it was made of, else NULL.  0, or -1 when memory ran out, or there are too many ways (mirrors.is_short).
 */
int lx_mirrors_make(struct lx_prepared *prepared, unsigned most, const struct lx_prepared *from);
void lx_mirrors_clear(struct lx_mirrors *mirrors);

/* The middle of an aperture's corners; the unit normal of the plane through a place and edge i, which looks to the side
 * of the aperture, 0 where there is no such plane. */
void lx_aperture_middle(const struct lx_aperture *aperture, double middle_mm[3]);
void lx_aperture_inwards(const struct lx_aperture *aperture, unsigned i, const double place_mm[3], double inwards[3]);

/* How a surface stands to a mirror's plane. */
enum lx_mirror_side { LX_BEFORE_MIRROR, LX_BEHIND_MIRROR, LX_ACROSS_MIRROR };
enum lx_mirror_side lx_side_of_mirror(const struct lx_prepared *prepared, size_t surface, size_t mirror);

/* The element as the frame of a way carries it, lit there as it is where it stands. */
struct lx_element lx_mirrored_element(const struct lx_mirror_way *way, const struct lx_element *element);

/*
 * What a line of sight meets, mirror after mirror; false: nothing.  `eye` is the place, or `is_endless` the direction,
 * of whoever looks, as it is after so many mirrors, from which the line comes.
 */
bool lx_sight_meets(const struct lx_prepared *prepared, struct lx_ray ray, lx_bounded3 eye, bool is_endless,
                    unsigned mirrors, struct lx_element *element);

/* What an element shows: on the front of a mirror what its view, mirrored, meets; else itself. */
struct lx_element lx_element_shown(const struct lx_prepared *prepared, const struct lx_element *element);

#endif

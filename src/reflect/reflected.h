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

#include "../format/kept.h"
#include "../world/reference.h"
#include "../world/world.h"
#include "occluder_cone.h"
#include "request.h"

/* A solution; it never changes once made, and may be shared. */
struct lx_radiosity;

/* LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED. */
luxel_status lx_reflected_make(const struct lx_reflected_request *request, struct lx_radiosity **made);
void lx_reflected_free(struct lx_radiosity *reflected);

/* A solution as something that is kept, and back, if it was made with this; NULL: it was made with something else. */
struct lx_kept *lx_reflected_kept(struct lx_radiosity *reflected);
struct lx_radiosity *lx_reflected_of_kept(struct lx_kept *kept, const struct lx_reflected_key *key);

/* So, too, whatever it was made for, and for whatever bound. */
struct lx_radiosity *lx_reflected_like_kept(struct lx_kept *kept, const struct lx_reflected_key *key);

/* Whether time or a wish was the end of a solution, and would be again for somebody who waits so many seconds (0:
 * without end), or is asked whether it is enough. */
bool lx_reflected_is_cut(const struct lx_radiosity *reflected, double within, bool is_asked);

/* What a request bounds, as it bounds it: the greatest error of places, of spots or of means.  Where that of a place is
 * above `most`, any such. */
double lx_reflected_error(const struct lx_radiosity *reflected, const struct lx_reflected_request *request,
                          double most);

/* Whether a solution has all faces that reflect light to what a request asks: not where it was made for other places
 * and left out what these do not see. */
bool lx_reflected_is_for(const struct lx_radiosity *reflected, const struct lx_reflected_request *request);

/* Whether the errors at places, which are in the request, are small enough. */
bool lx_reflected_is_reached(const struct lx_radiosity *reflected, const struct lx_reflected_request *request);

/* The reflected irradiance of a receiver in the prepared scene that it was made of, or in one prepared likewise;
 * `cones` is memory of the caller, zero-initialised at first. */
lx_bounded lx_reflected_at(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                           const struct lx_receiver *receiver, struct lx_occluder_cones *cones);

/* The light on one side of a prepared surface. */
struct lx_lit_side {
    size_t surface;
    bool is_flat, is_back; /* the side that the normal leaves behind, of what is round the inner one */
    double area_m2, reflectance;
    lx_bounded direct, irradiance; /* means over the side: direct light, and all */
};

/* Where the light stays that arrives directly: fluxes, in the irradiance's unit times m^2. */
struct lx_light_balance {
    lx_bounded arrives, absorbed, escaped;
    lx_bounded pending;    /* what is reflected after the last bounce that is wanted, wherever it goes */
    lx_bounded difference; /* what all three are beside what arrives: in truth 0 */
};

/* Sets the sides that light may reach, in the order of the surfaces, in memory for lx_reflected_most_sides() of them;
 * returns how many. */
size_t lx_reflected_most_sides(const struct lx_radiosity *reflected);
size_t lx_reflected_sides(const struct lx_radiosity *reflected, struct lx_lit_side *sides);
struct lx_light_balance lx_reflected_balance(const struct lx_radiosity *reflected);

/* Two prepared surfaces, or one mesh twice, of which faces lie on one another in one plane and have light there, so
 * that no bound is small (overlap.h); false: there are none. */
bool lx_reflected_overlaps(const struct lx_radiosity *reflected, size_t surfaces[2]);

/*
 * The reflected irradiance on a surface, for many places: the polynomial of the tile there, with the bound that holds
 * on all of it. `near` is of the caller, 0 at first: places that follow each other are often on one tile.
 */
lx_bounded lx_reflected_on(const struct lx_radiosity *reflected, const struct lx_prepared *prepared, size_t surface,
                           const double place_mm[3], const double normal[3], size_t *near);

#endif

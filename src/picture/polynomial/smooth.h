/* SPDX-License-Identifier: MIT */
/*
 * Polynomials in place of lights.  Over a small square of a picture that shows one surface the brightness by most
 * lights is as smooth as can be: then it is computed at a few nodes, in float64, and the polynomial through them takes
 * its place, provided that it is certain not to differ from it by more than a small share of the picture's maximum.
 *
 * What makes it certain is a bound of the brightness as an analytic function: at complex places around the square, in
 * an ellipse with its foci at the square's sides, where kernel_smooth.h bounds it (docs/MATHS.md, "Squares of a
 * picture").  Where a light sets within the square its diffuse part, max(0, N.L), has a fold; a polynomial of its own
 * goes on below 0 and is cut off there.  Lights whose cones end within the square, whose highlights are gated there, or
 * that stand too near, are left to be summed for each pixel; likewise extended sources that the horizon cuts.
 */
#ifndef LX_PICTURE_SMOOTH_H
#define LX_PICTURE_SMOOTH_H

#include "../../base/rows.h"
#include "../sampling.h"
#include "smooth_lights.h"
#include "smooth_plan.h"
#include "tabled.h"
#include "vicinity.h"

struct lx_plan;
struct lx_planned_surface;
struct lx_light_run;
struct lx_ball;
struct lx_shader_memory;
struct lx_seen;

void lx_basis_make(unsigned nodes, double reach, struct lx_basis *basis);
void lx_bases_make(struct lx_basis bases[LX_BASES]); /* from the fewest nodes on */

/* The most lights that polynomials are made of: what is kept of each of them takes 144 bytes. */
enum { LX_MOST_SMOOTH = 1 << 20 };

/* For the lights over a surface and its area lights, whose highlights lx_has_smooth_highlights(), if they have any.
 * LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED. */
luxel_status lx_smooth_make(const struct lx_planned_surface *surface, double radius_mm, const struct lx_asking *asking,
                            struct lx_smooth *smooth);
void lx_smooth_clear(struct lx_smooth *smooth);

/* Whether something may stand between a part of a surface and a light of a run. */
bool lx_light_may_be_blocked(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                             const struct lx_light_run *run, const struct lx_ball *part, const struct lx_ball *light);

/* Where in tiles of 4 x 4 the i-th node of row j stands, of a number on each axis that 4 divides. */
static inline size_t lx_node_in_tiles(unsigned nodes, unsigned i, unsigned j)
{
    enum { TILE = 4 };
    return ((size_t)(j / TILE) * (nodes / TILE) + i / TILE) * TILE * TILE + (size_t)(j % TILE) * TILE + i % TILE;
}

/* Elements where lines of sight through the nodes of a square meet its surface; `in_tiles` of 4 x 4 nodes, so that
 * those of a run are near each other, else row by row. */
void lx_gather_nodes(const struct lx_plan *plan, struct lx_seen *seen, const struct lx_square *square,
                     const struct lx_basis *basis, bool in_tiles);

/* Lights that set within a square and whose diffuse light a polynomial of its own does for, at most. */
enum { LX_MOST_FOLDED = 16 };

/* What one thread needs, for one plan, whatever surfaces its squares show. */
struct lx_fitting {
    uint8_t *is_left;       /* of each light */
    uint8_t *how[LX_BASES]; /* how polynomials of each basis take each light */
    double *sizes, *part_sizes;
    struct lx_smooth_lights round;  /* the round parts as the square sees them */
    struct lx_light_room room;      /* for lights that are not stored */
    struct lx_block_double *turned; /* room for elements */
    struct lx_tabled *tabled;       /* room for a luminaire */
    struct lx_vicinity vicinity;    /* of the square and the basis that were last */
    /* of the square that was last: */
    struct lx_polynomial *polynomials;
    size_t count;
    bool is_faint[4]; /* which quarters, from the top left to the bottom right, are too faint for any */
};

int lx_fitting_make(const struct lx_plan *plan, struct lx_fitting *fitting);
void lx_fitting_clear(struct lx_fitting *fitting);

/*
 * Takes from the lights that are left those over a square that polynomials do for; these may be off by `*allowance`
 * together, which is lessened by what they are.  The first one is `uniform` and the brightness by these lights; the
 * others, where they are above 0, are to be added to it.  Where they are `alone` in the picture they are good to a
 * small share of the least brightness, too; the foot of a highlight that is all there is comes as a power.  False:
 * there are none.  The elements that the shader has seen are lost.  Where the work is to stop the call returns early
 * with polynomials that mean nothing.
 */
bool lx_smooth_fit(const struct lx_plan *plan, struct lx_fitting *fitting, struct lx_shader_memory *shader,
                   const struct lx_square *square, double uniform, bool alone, const struct lx_asking *asking,
                   double *allowance);

#endif

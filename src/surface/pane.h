/* SPDX-License-Identifier: MIT */
/*
 * Openings in the walls of rooms, and panes of clear glass in them.  Unpolarized light meets one at the angle theta and
 * goes on in it at theta', sin theta = n sin theta'; it lets through
 *
 *     tau = mean over both polarizations of (1 - r)^2 a / (1 - r^2 a^2),   a = a0^(1 / cos theta')
 *
 * with Fresnel's reflectance r of a face and all reflections between the two; a0 is what is left at right angles of
 * light that enters.
 */
#ifndef LX_SURFACE_PANE_H
#define LX_SURFACE_PANE_H

#include <stdbool.h>
#include <stddef.h>

#include "../base/frame.h"

struct lx_glass_pane {
    double center_mm[3];
    double across[3], upward[3], axis[3]; /* unit, at right angles */
    double half_mm[2];
    double index, transmittance; /* n and a0; an index of 0: there is no glass in the opening */
    size_t surface;              /* of the scene's list: the room that it is in, */
    double room_center_mm[3], room_axes[3][3], room_half_mm[3];
};

/* A pane as a frame has it. */
struct lx_glass_pane lx_pane_carried(const struct lx_glass_pane *pane, const struct lx_frame *frame);

/* The planes through a place before an opening and its edges: unit normals to the side of the opening. */
enum { LX_RIM = 4 };
void lx_pane_edges(const struct lx_glass_pane *pane, const double place_mm[3], double inwards[LX_RIM][3]);

/* tau by the cosine of theta, >= 0; good to LX_PANE_ROUNDING, absolutely. */
double lx_pane_transmittance(const struct lx_glass_pane *pane, double cosine);
#define LX_PANE_ROUNDING 1e-14

/* What panes leave of light that comes to a place by a way, from its end or, `endless`, from beyond all.  It comes
 * `through` one of them, whatever rounding makes of its rim, and no other of that room; NULL: who knows. */
double lx_panes_pass(const struct lx_glass_pane *panes, size_t count, const struct lx_glass_pane *through,
                     const double place_mm[3], const double way[3], bool endless);

#endif

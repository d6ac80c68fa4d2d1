/* SPDX-License-Identifier: MIT */
/*
 * The flux of a luminaire through a measuring plane, in the angles of its own table.  By the law 1/r^2 it is the
 * integral of the intensity over the solid angle of what is seen of the plane: along a half-plane of one azimuth the
 * table has a closed integral over the polar angle between any two edges of light, and only the azimuth is left to a
 * rule.  So the kinks of the table, of which a file has thousands, cost nothing.
 */
#ifndef LX_FLUX_FLUX_LUMINAIRE_H
#define LX_FLUX_FLUX_LUMINAIRE_H

#include "../base/rows.h"
#include "../world/cells.h"

/* A luminaire without an opening and the plane; `usual` is a flux, relative to which the tolerance counts. */
struct lx_flux_asked {
    const struct lx_prepared *prepared;
    const struct lx_cells *plane;
    const struct lx_emitter *emitter;
    const bool *aside; /* surfaces that lie behind the plane or in it */
    bool casts;        /* the others may hide the luminaire */
    double usual, tolerance;
    const struct lx_asking *asking;
};

/* The flux; false: it is not found this way, as of another law, in the plane itself, or behind surfaces whose edges of
 * shadow are unknown; or the work was stopped. */
bool lx_luminaire_flux(const struct lx_flux_asked *asked, lx_bounded *flux);

#endif

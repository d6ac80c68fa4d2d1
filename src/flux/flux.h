/* SPDX-License-Identifier: MIT */
/*
 * The irradiance integrated over a whole measuring plane, whatever cells it is cut into.  The plane's elements are free
 * ones, lit by their irradiance alone.
 *
 * Over a rectangle with the normal n a point source at P of the law 1/r^2 gives I times the solid angle of the
 * rectangle from P where it shines alike in all directions, and I times the irradiance that the rectangle would give at
 * P, as a source of the radiance 1 and for the normal along the source's axis, where it follows the cosine; ambient and
 * distant light gives its irradiance times the area.  All else, and what surfaces may take light from, is integrated
 * along lines and then across them, between the edges that light has on the plane (flux_edges.h).
 */
#ifndef LX_FLUX_FLUX_H
#define LX_FLUX_FLUX_H

#include "../base/rows.h"
#include "../world/cells.h"

struct lx_flux {
    bool is_known;    /* false where a source lies in the plane, or the work was stopped */
    lx_bounded value; /* in the unit of the irradiance times m^2 */
};

/* `usual`: an irradiance that is usual on the plane, 0 where all is dark. */
struct lx_flux lx_plane_flux(const struct lx_prepared *prepared, const struct lx_cells *plane, double usual,
                             const struct lx_asking *asking);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Utilization factors by the tabular method: the direct ratios share out the downward flux between the work plane and
 * the walls above it, and floor, walls and ceiling of a square room, each evenly lit, reflect it to each other.
 */
#include <luxel/utilization.h>

#include <math.h>

#include "photometry.h"
#include "photometry_cavity.h"

static const double reflectances[LUXEL_UTILIZATION_REFLECTANCES][LX_CAVITY_PARTS] = {
    /* floor, walls, ceiling */
    {0.2, 0.7, 0.8}, {0.2, 0.5, 0.8}, {0.2, 0.5, 0.7}, {0.2, 0.3, 0.7}, {0.2, 0.1, 0.7},
    {0.2, 0.5, 0.5}, {0.2, 0.3, 0.5}, {0.2, 0.3, 0.3}, {0.2, 0.1, 0.3}, {0, 0, 0},
};

double luxel_utilization_reflectance(size_t i, size_t part)
{
    return i < LUXEL_UTILIZATION_REFLECTANCES && part < LX_CAVITY_PARTS ? reflectances[i][LX_CEILING - part]
                                                                        : (double)NAN;
}

luxel_status luxel_photometry_find_utilization(const luxel_photometry *photometry, luxel_utilization_table *table)
{
    luxel_photometry_figures figures;
    if (!photometry || !table)
        return LUXEL_ERROR_ARGUMENT;
    *table = (luxel_utilization_table){.exists = false};
    if (luxel_photometry_find_figures(photometry, &figures) != LUXEL_OK)
        return LUXEL_ERROR_MEMORY;
    if (!(figures.zone_lumens > 0) || !isfinite(figures.direct_ratios[0]))
        return LUXEL_OK;
    table->exists = true;
    table->lumens =
        !photometry->is_absolute && photometry->declared_lumens > 0 ? photometry->declared_lumens : figures.zone_lumens;
    double down = figures.zone_lumens * figures.dff / 100, up = figures.zone_lumens - down;
    for (size_t k = 0; k < LUXEL_ROOM_INDICES; k++) {
        double side = 2 * luxel_photometry_room_index(k), on_floor = down * figures.direct_ratios[k];
        const double flux[LX_CAVITY_PARTS] = {[LX_FLOOR] = on_floor, [LX_WALLS] = down - on_floor, [LX_CEILING] = up};
        for (size_t i = 0; i < LUXEL_UTILIZATION_REFLECTANCES; i++) {
            double light[LX_CAVITY_PARTS];
            lx_cavity_light(side, side, flux, reflectances[i], light);
            table->factors[k][i] = light[LX_FLOOR] * side * side / table->lumens;
        }
    }
    return LUXEL_OK;
}

/* SPDX-License-Identifier: MIT */
/* The way to the sun in the scene. */
#include "stand.h"

#include <math.h>
#include <string.h>

#include "../../base/number.h"
#include "../../base/pose.h"
#include "../../base/vector.h"
#include "position.h"

bool lx_sun_stands(const struct lx_table *table, const void *parameters, const struct lx_sun_stand *stand,
                   double *altitude_deg, double *azimuth_deg)
{
    double julian;
    *altitude_deg = stand->altitude_deg;
    *azimuth_deg = stand->azimuth_deg;
    if (!lx_is_given(table, parameters, "date"))
        return true;
    if (!lx_read_date(stand->date, &julian))
        return false;
    lx_sun_position(julian, stand->latitude_deg, stand->longitude_deg, altitude_deg, azimuth_deg);
    return true;
}

void lx_way_up(const struct lx_ground_ways *ways, double up[3])
{
    memcpy(up, ways->up, 3 * sizeof *up);
    lx_normalize(up);
}

void lx_way_to_sun(const struct lx_ground_ways *ways, bool is_north_given, double altitude_deg, double azimuth_deg,
                   double towards[3])
{
    const double altitude = altitude_deg * (M_PI / 180), azimuth = azimuth_deg * (M_PI / 180);
    double up[3], north[3], east[3];
    lx_way_up(ways, up);
    memcpy(north, ways->north, sizeof north);
    if (!is_north_given && lx_are_parallel(ways->north, ways->up))
        memcpy(north, (const double[]){0, 0, -1}, sizeof north);
    lx_cross(north, up, east);
    lx_normalize(east);
    lx_cross(up, east, north);
    for (int k = 0; k < 3; k++)
        towards[k] = sin(altitude) * up[k] + cos(altitude) * (cos(azimuth) * north[k] + sin(azimuth) * east[k]);
    lx_normalize(towards);
}

void lx_check_sun_stand(const struct lx_check *check, const struct lx_sun_stand *stand)
{
    double altitude, azimuth;
    char number[LX_NUMBER_SIZE];
    if (!lx_sun_stands(check->table, check->parameters, stand, &altitude, &azimuth)) {
        lx_check_report(check, "date", LX_ALL_OF_IT, LX_MSG_SUN_DATE, NULL);
        lx_check_hint(check, LX_MSG_HINT_SUN_DATE, NULL);
    } else if (!(altitude > 0)) {
        lx_check_report(check, "date", LX_ALL_OF_IT, LX_MSG_SUN_BELOW, LX_ARGS(lx_write_digits(altitude, 4, number)));
        lx_check_hint(check, LX_MSG_HINT_SUN_BELOW, NULL);
    }
}

void lx_check_ground_ways(const struct lx_check *check, const struct lx_ground_ways *ways)
{
    if (lx_is_given(check->table, check->parameters, "north") && lx_are_parallel(ways->north, ways->up))
        lx_check_report(check, "north", LX_ALL_OF_IT, LX_MSG_NORTH_PARALLEL, NULL);
}

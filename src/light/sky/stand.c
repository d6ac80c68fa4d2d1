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

struct lx_sun_site lx_sun_site_plain(void)
{
    return (struct lx_sun_site){.ways = {.up = {0, 0, 1}, .north = {0, 1, 0}}};
}

/* The key of this name in parameters by a table, which has it. */
static const void *find_member(const struct lx_table *table, const void *parameters, const char *name)
{
    return (const char *)parameters + lx_find_parameter(table, name)->offset;
}

bool lx_sun_site_of(const struct lx_item *light, struct lx_sun_site *site)
{
    const struct lx_table *table = light->variant->table, *stands = table;
    const void *parameters = light->parameters, *group = parameters;
    const bool is_sky = strcmp(light->variant->name, "sky") == 0;
    double altitude, azimuth;
    if (!is_sky && strcmp(light->variant->name, "sun") != 0)
        return false;
    *site = lx_sun_site_plain();
    memcpy(site->ways.up, find_member(table, parameters, "up"), sizeof site->ways.up);
    memcpy(site->ways.north, find_member(table, parameters, "north"), sizeof site->ways.north);
    site->is_north_given = lx_is_given(table, parameters, "north");
    if (is_sky && !lx_is_given(table, parameters, "sun"))
        return true;
    if (is_sky) {
        stands = lx_find_parameter(table, "sun")->group;
        group = find_member(table, parameters, "sun");
    }
    /* all keys of a stand lie together, the altitude first (LX_SUN_STAND_PARAMETERS) */
    const struct lx_sun_stand *stand = find_member(stands, group, "altitude");
    site->has_place = lx_is_given(stands, group, "date");
    site->latitude_deg = stand->latitude_deg;
    site->longitude_deg = stand->longitude_deg;
    site->has_sun = lx_sun_stands(stands, group, stand, &altitude, &azimuth);
    if (site->has_sun)
        lx_way_to_sun(&site->ways, site->is_north_given, altitude, azimuth, site->towards);
    return true;
}

double lx_sun_site_look(const struct lx_sun_site *site, double julian, double towards[3])
{
    double altitude, azimuth;
    lx_sun_position(julian, site->latitude_deg, site->longitude_deg, &altitude, &azimuth);
    lx_way_to_sun(&site->ways, site->is_north_given, altitude, azimuth, towards);
    return altitude;
}

void lx_sun_as_direction(const double towards[3], struct lx_emitter *emitter)
{
    *emitter = (struct lx_emitter){.type = LX_DIRECTION, .strength = 1, .towards = lx_exact3(towards)};
}

void lx_sky_disk(const double towards[3], double half_rad, const double place_mm[3], double away_mm,
                 struct lx_emitter *emitter)
{
    *emitter = (struct lx_emitter){.type = LX_DISK,
                                   .radiance = lx_exact(1),
                                   .attenuation = LX_INVERSE_SQUARE,
                                   .radius_mm = away_mm * tan(half_rad),
                                   .axis = lx_negate3(lx_exact3(towards))};
    for (int k = 0; k < 3; k++)
        emitter->center_mm[k] = place_mm[k] + away_mm * towards[k];
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

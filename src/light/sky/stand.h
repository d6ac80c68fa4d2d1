/* SPDX-License-Identifier: MIT */
/*
 * Where the sun stands, as a light says it: by altitude and azimuth, or by date and place; and which ways of the scene
 * are up and north.  A kind puts a struct lx_sun_stand into its parameters or a group of them.
 */
#ifndef LX_LIGHT_SKY_STAND_H
#define LX_LIGHT_SKY_STAND_H

#include "../../parameter/check.h"
#include "../light.h"
#include "site.h"

struct lx_sun_stand {
    double altitude_deg, azimuth_deg;
    const char *date;
    double latitude_deg, longitude_deg;
};

#define LX_SUN_STAND_PARAMETERS(type_, member_)                                                                        \
    {                                                                                                                  \
        .name = "altitude",                                                                                            \
        .label = "Altitude",                                                                                           \
        .type = LX_REAL,                                                                                               \
        .offset = offsetof(type_, member_.altitude_deg),                                                               \
        .unit = LX_UNIT_DEGREES,                                                                                       \
        .legal = {.given = true, .low = 0, .high = 90, .low_open = true},                                              \
        .meaning = "the angle of the sun above the horizon",                                                           \
    },                                                                                                                 \
        {                                                                                                              \
            .name = "azimuth",                                                                                         \
            .label = "Azimuth",                                                                                        \
            .type = LX_REAL,                                                                                           \
            .offset = offsetof(type_, member_.azimuth_deg),                                                            \
            .unit = LX_UNIT_DEGREES,                                                                                   \
            .legal = LX_BETWEEN(-360, 360),                                                                            \
            .meaning = "the way to the sun along the horizon, from north towards east: 90 is east, 180 south",         \
        },                                                                                                             \
        {                                                                                                              \
            .name = "date",                                                                                            \
            .label = "Date",                                                                                           \
            .type = LX_TEXT,                                                                                           \
            .offset = offsetof(type_, member_.date),                                                                   \
            .meaning = "the date and time, instead of altitude and azimuth, such as 2026-06-21T12:00+02:00; without "  \
                       "an offset the time is UTC",                                                                    \
        },                                                                                                             \
        {                                                                                                              \
            .name = "latitude",                                                                                        \
            .label = "Latitude",                                                                                       \
            .type = LX_REAL,                                                                                           \
            .offset = offsetof(type_, member_.latitude_deg),                                                           \
            .unit = LX_UNIT_DEGREES,                                                                                   \
            .legal = LX_BETWEEN(-90, 90),                                                                              \
            .meaning = "the latitude of the place, north of the equator",                                              \
        },                                                                                                             \
    {                                                                                                                  \
        .name = "longitude", .label = "Longitude", .type = LX_REAL, .offset = offsetof(type_, member_.longitude_deg),  \
        .unit = LX_UNIT_DEGREES, .legal = LX_BETWEEN(-180, 180),                                                       \
        .meaning = "the longitude of the place, east of Greenwich",                                                    \
    }

#define LX_SUN_STAND_RULES                                                                                             \
    {LX_RULE_ONE, "altitude", NULL, "altitude|date"}, {LX_RULE_NEEDED, "azimuth", "altitude", NULL},                   \
        {LX_RULE_NEEDED, "altitude", "azimuth", NULL}, {LX_RULE_NEEDED, "latitude", "date", NULL},                     \
        {LX_RULE_NEEDED, "longitude", "date", NULL}, {LX_RULE_NEEDED, "date", "latitude", NULL},                       \
    {                                                                                                                  \
        LX_RULE_NEEDED, "date", "longitude", NULL                                                                      \
    }

#define LX_GROUND_WAYS_PARAMETERS(type_, member_)                                                                      \
    {                                                                                                                  \
        .name = "up",                                                                                                  \
        .label = "Up direction",                                                                                       \
        .type = LX_REALS,                                                                                              \
        .offset = offsetof(type_, member_.up),                                                                         \
        .count = 3,                                                                                                    \
        .nonzero = true,                                                                                               \
        .initial = "[0, 0, 1]",                                                                                        \
        .meaning = "the direction of the scene that points to the zenith, of any length",                              \
    },                                                                                                                 \
    {                                                                                                                  \
        .name = "north", .label = "North", .type = LX_REALS, .offset = offsetof(type_, member_.north), .count = 3,     \
        .nonzero = true, .initial = "[0, 1, 0]",                                                                       \
        .meaning = "the direction of the scene that points to north, made perpendicular to up; where it is not given " \
                   "and up runs along y, (0, 0, -1)",                                                                  \
    }

/* Altitude and azimuth; `table` tells which keys were given.  False: the date cannot be read. */
bool lx_sun_stands(const struct lx_table *table, const void *parameters, const struct lx_sun_stand *stand,
                   double *altitude_deg, double *azimuth_deg);

/* The unit vector up, and with altitude and azimuth that to the sun, each to a few roundings. */
void lx_way_up(const struct lx_ground_ways *ways, double up[3]);
void lx_way_to_sun(const struct lx_ground_ways *ways, bool is_north_given, double altitude_deg, double azimuth_deg,
                   double towards[3]);

/* Reports a date that cannot be read, and a sun below the horizon. */
void lx_check_sun_stand(const struct lx_check *check, const struct lx_sun_stand *stand);
/* Reports a north that is given and runs along up. */
void lx_check_ground_ways(const struct lx_check *check, const struct lx_ground_ways *ways);

#endif

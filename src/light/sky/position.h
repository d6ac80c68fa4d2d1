/* SPDX-License-Identifier: MIT */
/*
 * Where the sun stands, by date and place: the mean orbit with its equation of centre, the obliquity and the sidereal
 * time of the Astronomical Almanac (J. J. Michalsky, The Astronomical Almanac's algorithm for approximate solar
 * position, Solar Energy 40, 1988).  Within 0.01 degrees from 1950 to 2050, and 0.02 from 1900 to 2100, without
 * refraction, as seen from the middle of the earth, which makes at most 0.0025 degrees.
 */
#ifndef LX_LIGHT_SKY_POSITION_H
#define LX_LIGHT_SKY_POSITION_H

#include <stdbool.h>

/* A time as the Julian date of UTC.  False: it is no "year-month-day", then "T" or a blank, "hour:minute" or
 * "hour:minute:second", and "Z", an offset such as "+02:00", or nothing for UTC; or its year is not from 1900 to
 * 2100. */
bool lx_read_date(const char *text, double *julian);

/* A day, "year-month-day", and the offset of its clock in minutes, as above: the Julian date of UTC at its midnight,
 * and the month and day by number.  False: it is none. */
struct lx_day {
    double midnight;
    int month, day, zone_minutes;
};
bool lx_read_day(const char *text, struct lx_day *day);

/* The altitude and the azimuth, from north towards east, in degrees; the longitude counts eastwards. */
void lx_sun_position(double julian, double latitude_deg, double longitude_deg, double *altitude_deg,
                     double *azimuth_deg);

/* What light the sun gives then outside of the atmosphere, of that at its mean distance. */
double lx_sun_nearness(double julian);

#endif

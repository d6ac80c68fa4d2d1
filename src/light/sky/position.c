/* SPDX-License-Identifier: MIT */
/* Dates, and the position of the sun. */
#include "position.h"

#include <math.h>
#include <stddef.h>

static const double DEGREE = M_PI / 180;

/* ---- dates ---- */

/* Reads so many digits, no more, no fewer. */
static bool read_digits(const char **text, int count, int *number)
{
    *number = 0;
    for (int i = 0; i < count; i++, (*text)++) {
        if (**text < '0' || **text > '9')
            return false;
        *number = 10 * *number + (**text - '0');
    }
    return **text < '0' || **text > '9';
}

static bool skip(const char **text, char sign)
{
    if (**text != sign)
        return false;
    (*text)++;
    return true;
}

static int days_of(int year, int month)
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool is_leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return days[month - 1] + (month == 2 && is_leap);
}

/* The days from noon of 1 January 2000 to the midnight before a day. */
static double day_number(int year, int month, int day)
{
    int days = day - 1;
    for (int m = 1; m < month; m++)
        days += days_of(year, m);
    const int before = year - 1;
    const int leaps = before / 4 - before / 100 + before / 400, leaps_to_2000 = 1999 / 4 - 1999 / 100 + 1999 / 400;
    return 365.0 * (year - 2000) + leaps - leaps_to_2000 + days - 0.5;
}

/* The offset of a zone in minutes. */
static bool read_zone(const char **text, int *minutes)
{
    int hour, minute = 0;
    *minutes = 0;
    if (**text == 0 || skip(text, 'Z'))
        return true;
    const int sign = **text == '-' ? -1 : 1;
    if (!(skip(text, '+') || skip(text, '-')) || !read_digits(text, 2, &hour) || hour > 14)
        return false;
    if (skip(text, ':') && (!read_digits(text, 2, &minute) || minute > 59))
        return false;
    *minutes = sign * (60 * hour + minute);
    return true;
}

/* The year, month and day at the start of a text, which moves behind them, as the midnight of UTC. */
static bool read_day(const char **text, struct lx_day *read)
{
    int year, month, day;
    if (!read_digits(text, 4, &year) || !skip(text, '-') || !read_digits(text, 2, &month) || !skip(text, '-') ||
        !read_digits(text, 2, &day))
        return false;
    if (year < 1900 || year > 2100 || month < 1 || month > 12 || day < 1 || day > days_of(year, month))
        return false;
    *read = (struct lx_day){.midnight = 2451545 + day_number(year, month, day), .month = month, .day = day};
    return true;
}

bool lx_read_day(const char *text, struct lx_day *day)
{
    if (!read_day(&text, day) || !read_zone(&text, &day->zone_minutes) || *text != 0)
        return false;
    day->midnight -= day->zone_minutes / 1440.0;
    return true;
}

bool lx_read_date(const char *text, double *julian)
{
    struct lx_day day;
    int hour, minute, second = 0, zone;
    if (!read_day(&text, &day))
        return false;
    if (!(skip(&text, 'T') || skip(&text, ' ')) || !read_digits(&text, 2, &hour) || !skip(&text, ':') ||
        !read_digits(&text, 2, &minute) || hour > 23 || minute > 59)
        return false;
    if (skip(&text, ':') && (!read_digits(&text, 2, &second) || second > 59))
        return false;
    if (!read_zone(&text, &zone) || *text != 0)
        return false;
    *julian = day.midnight + (hour * 3600 + (minute - zone) * 60 + second) / 86400.0;
    return true;
}

/* ---- the sun ---- */

void lx_sun_position(double julian, double latitude_deg, double longitude_deg, double *altitude_deg,
                     double *azimuth_deg)
{
    const double days = julian - 2451545;
    const double mean_longitude = (280.460 + 0.9856474 * days) * DEGREE;
    const double anomaly = (357.528 + 0.9856003 * days) * DEGREE;
    const double longitude = mean_longitude + (1.915 * sin(anomaly) + 0.020 * sin(2 * anomaly)) * DEGREE;
    const double obliquity = (23.439 - 0.0000004 * days) * DEGREE;
    const double ascension = atan2(cos(obliquity) * sin(longitude), cos(longitude));
    const double declination = asin(sin(obliquity) * sin(longitude));
    const double sidereal = (280.46062 + 360.98564737 * days + longitude_deg) * DEGREE;
    const double hour = sidereal - ascension, latitude = latitude_deg * DEGREE;
    const double east = -cos(declination) * sin(hour);
    const double north = cos(latitude) * sin(declination) - sin(latitude) * cos(declination) * cos(hour);
    const double above = sin(latitude) * sin(declination) + cos(latitude) * cos(declination) * cos(hour);
    const double azimuth = atan2(east, north) / DEGREE;
    *altitude_deg = atan2(above, hypot(east, north)) / DEGREE;
    *azimuth_deg = azimuth < 0 ? azimuth + 360 : azimuth;
}

double lx_sun_nearness(double julian)
{
    const double anomaly = (357.528 + 0.9856003 * (julian - 2451545)) * DEGREE;
    const double distance = 1.00014 - 0.01671 * cos(anomaly) - 0.00014 * cos(2 * anomaly);
    return 1 / (distance * distance);
}

/* SPDX-License-Identifier: MIT */
/* Dates of scenes, such as "2026-03-21T12:00+01:00": their days, and other times of the same day. */
#ifndef LUXEL_APP_DATE_H
#define LUXEL_APP_DATE_H

enum { APP_DATE_DAY_MINUTES = 24 * 60 };

/* The day of a date, by its clock: "2026-03-21+01:00"; the caller's. */
char *app_date_day(const char *date);

/* The minutes from its midnight, by its clock; negative: it is no date with a time. */
int app_date_minutes(const char *date);

/* The date so many minutes from the same midnight, at no second; the caller's. */
char *app_date_at(const char *date, int minutes);

#endif

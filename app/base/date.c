/* SPDX-License-Identifier: MIT */
/* What stands before and behind the time is kept as it was written. */
#include "date.h"

#include <glib.h>
#include <stdio.h>
#include <string.h>

enum { DAY = 10 /* letters of a day */, HOUR = 60 };

char *app_date_day(const char *date)
{
    const char *time = strchr(date, 'T'), *offset = time ? strpbrk(time, "+-") : NULL;
    return g_strdup_printf("%.*s%s", DAY, date, offset ? offset : "");
}

int app_date_minutes(const char *date)
{
    int hour, minute;
    if (strlen(date) < DAY || !strchr("T ", date[DAY]) || sscanf(date + DAY + 1, "%2d:%2d", &hour, &minute) != 2)
        return -1;
    return hour * HOUR + minute;
}

char *app_date_at(const char *date, int minutes)
{
    const char *behind = date + DAY + 1 + strspn(date + DAY + 1, "0123456789:");
    return g_strdup_printf("%.*s%02d:%02d%s", DAY + 1, date, minutes / HOUR, minutes % HOUR, behind);
}

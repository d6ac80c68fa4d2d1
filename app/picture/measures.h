/* SPDX-License-Identifier: MIT */
/*
 * Measures: the numbers beside the picture.  One thread reads them off a shot: sources, points and sections at once,
 * by the picture's own solution of reflected light; what takes longer (statistics, true extrema, isophotes) when the
 * hand rests.  Another one answers what is under the pointer.
 */
#ifndef LUXEL_APP_MEASURES_H
#define LUXEL_APP_MEASURES_H

#include "curve.h"
#include "picture.h"

/* What is wanted; of a shot of direct light alone the sources, as its numbers would be taken for those of the scene. */
typedef struct AppQuestion {
    AppShot *shot;      /* a reference is taken, as of the next two */
    AppShot *minus;     /* what is taken off, so that the answers are of the difference; NULL: nothing */
    AppShot *live;      /* that the sources are told of: */
    gboolean is_placed; /* what they give at the place that is seen at place_mm, else at the first surface's centre */
    double place_mm[2];
    gboolean section; /* the profiles through section_mm */
    double section_mm[2];
    gboolean statistics; /* summary, extrema, histogram, and of surfaces that reflect light the balance */
    gboolean isophotes;  /* lines at levels of the range low to high */
    double low, high;
    gboolean logarithmic; /* histogram and levels */
} AppQuestion;

/* A measuring point of the scene. */
typedef struct AppPoint {
    double x_mm, y_mm;
    gboolean on_surface, has_value, has_pixel, source_on_element;
    double value, error, pixel_value;
    luxel_color color; /* of the value, in a scene in colour */
    guint column, row;
    gboolean has_grey;
    guint8 grey; /* of the pixel, where has_grey: of a grey picture */
} AppPoint;

/* A source. */
typedef struct AppSource {
    double flux;       /* in W or lm; NaN where it has none */
    double irradiance; /* where it is asked for; NaN: no surface is seen there */
} AppSource;

/* The answers, which come in parts: of each flag that is TRUE the rest is meant. */
typedef struct AppMeasures {
    AppVersion version; /* that they are of, but the sources */
    AppShot *shot;
    gboolean is_difference; /* of the shot and what was taken off */
    gboolean has_points;
    AppPoint *points;
    gsize point_count, points_left; /* points_left: more than are listed */
    gboolean has_sources;           /* by their direct light */
    AppShot *live;                  /* whose they are */
    AppSource *sources;
    gsize source_count;
    gboolean has_section;
    AppCurve *curves[2]; /* horizontal, vertical; NULL: none */
    double section_mm[2];
    gboolean has_statistics, has_extrema;
    luxel_summary summary;
    luxel_color mean; /* of the pixels' channels */
    luxel_extrema extrema;
    luxel_extremum reached; /* the least value where light arrives */
    luxel_histogram *histogram;
    gboolean has_isophotes;
    luxel_isophotes *isophotes;
    gboolean has_balance;
    luxel_balance *balance; /* NULL: it could not be found */
} AppMeasures;

enum { APP_MOST_POINTS = 200 };

typedef struct AppMeter AppMeter;

/* `tell` is called in the main loop; the answers are freed afterwards, but for what it steals. */
AppMeter *app_meter_new(void (*tell)(AppMeasures *measures, gpointer owner), gpointer owner);
void app_meter_free(AppMeter *meter);
void app_meter_ask(AppMeter *meter, const AppQuestion *question);

/* What is under the pointer. */
typedef struct AppReading {
    double x_mm, y_mm;
    luxel_value value;
    double *shares; /* a share for each light */
    gsize share_count;
    gboolean has_minus;
    luxel_value minus; /* of the shot that is taken off */
    luxel_color color; /* of the value, in a scene in colour */
    gboolean has_pixel;
    guint column, row; /* of the field */
    gboolean has_grey;
    guint8 grey; /* where the picture is grey */
    AppMoment *moment;
    luxel_quantity quantity;
    AppVersion version;
} AppReading;

/* The lights by what they give, the greatest first; the caller's, g_free(). */
gsize *app_reading_order(const AppReading *reading);

typedef struct AppPointer AppPointer;

AppPointer *app_pointer_new(void (*tell)(const AppReading *reading, gpointer owner), gpointer owner);
void app_pointer_free(AppPointer *pointer);
/* `minus`: another shot to be read at the same place; NULL: none. */
void app_pointer_ask(AppPointer *pointer, AppShot *shot, AppShot *minus, double x_mm, double y_mm);

/* The pixel of a field whose sample is nearest to a place of the screen; FALSE off the screen. */
gboolean app_pixel_at(const luxel_field *field, double x_mm, double y_mm, guint *column, guint *row);

#endif

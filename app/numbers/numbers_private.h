/* SPDX-License-Identifier: MIT */
/* The inside of the numbers, for the files that make them up. */
#ifndef LUXEL_APP_NUMBERS_PRIVATE_H
#define LUXEL_APP_NUMBERS_PRIVATE_H

#include <luxel/drawing.h>

#include "numbers.h"

enum { DIGITS = 7, PLACE_DIGITS = 10, TEXT_COLUMNS = 36 };

/* What the statistics list. */
typedef enum Line {
    LINE_MAXIMUM,
    LINE_MAXIMUM_PLACE,
    LINE_TRUE_MAXIMUM,
    LINE_TRUE_MAXIMUM_PLACE,
    LINE_MINIMUM,
    LINE_TRUE_MINIMUM,
    LINE_REACHED,
    LINE_REACHED_PLACE,
    LINE_LEAST,
    LINE_LEAST_PLACE,
    LINE_MEAN,
    LINE_MEDIAN,
    LINE_DEVIATION,
    LINE_LIT,
    LINE_U0,
    LINE_UD,
    LINE_PIXELS,
    LINE_COLOR,
    LINE_COLOR_PLACE,
    LINE_COLOR_TEMPERATURE,
    LINE_REFLECTED,
    LINE_MIRRORED,
    LINES
} Line;

/* Results that come and go by themselves, each of a version of the scene. */
typedef enum Part { PART_POINTS, PART_SECTION, PART_STATISTICS, PART_BALANCE, PART_LIGHTING, PARTS } Part;

/* The plots, off which a cursor reads values. */
typedef enum Plot { PLOT_HORIZONTAL, PLOT_VERTICAL, PLOT_HISTOGRAM, PLOTS } Plot;

typedef struct Cursor {
    GtkWidget *words;       /* what it reads */
    gssize at;              /* the sample or bin, -1: nowhere */
    luxel_plot_frame frame; /* of the plot, as it was drawn last */
} Cursor;

struct _AppNumbers {
    GtkBox parent;
    AppDocument *document;
    GtkWidget *stack, *points, *points_left, *unit, *section_place, *plots[PLOTS];
    Cursor cursors[PLOTS];
    GtkWidget *lines[LINES], *balance, *copy, *waiting;
    GtkWidget *lighting;   /* the lines of grids and observers */
    gboolean has_lighting; /* the scene has some */
    AppGrids *grids; /* NULL: none were measured, as below */
    AppEyes *eyes;
    guint64 live;    /* the version that lighting is to be of, which knows no comparison and needs no picture */
    AppVersion wanted, versions[PARTS]; /* of the scene that is shown, and that each part is of */
    gboolean is_latest;                 /* what is wanted is the document as it is */
    guint point_rows;
    char *unit_name;
    AppCurve *curves[2];
    double section_mm[2];
    char **names; /* of the lights, NULL-terminated */
    gsize name_count;
    luxel_histogram *bins;
    char *bins_name; /* of what they count */
    const char *palette;
    double low, high;
    gboolean logarithmic;
    double size_mm;     /* of the screen */
    AppShot *shot;      /* whose numbers these are; NULL: none came yet */
    AppPoint *measured; /* its points, to be copied */
    gsize measured_count;
    gboolean is_difference, has_extrema;
    luxel_extrema extrema;
    luxel_extremum reached;
};

/* Labels are only touched when their text is another: laying them out is what costs. */
void app_numbers_set_text(GtkWidget *label, const char *text);
void app_numbers_set_number(GtkWidget *label, double number);
/* "brightness, W/sr": what the values of a field of these measures are; the caller's. */
char *app_numbers_name(const AppMeasures *measures, const luxel_field *field);
/* Grids and observers have become those of a version. */
void app_numbers_follow_lighting(AppNumbers *self, guint64 serial);
/* How plots are drawn on a widget; `language` is room for what the style points to. */
luxel_drawing_style app_numbers_style(GtkWidget *widget, luxel_language *language);

/* numbers_cursor.c: plots, and what is read off them. */
void app_numbers_add_plot(AppNumbers *self, Plot plot, GtkDrawingAreaDrawFunc draw, const char *name, GtkWidget *page);
/* Draws the cursor over a plot, whose frame is known. */
void app_numbers_draw_cursor(AppNumbers *self, Plot plot, cairo_t *cairo, const luxel_drawing_style *style);
/* The plot has become another: it is drawn, and read, anew. */
void app_numbers_tell_cursor(AppNumbers *self, Plot plot);

/* numbers_sections.c */
GtkWidget *app_numbers_new_sections(AppNumbers *self);
void app_numbers_show_sections(AppNumbers *self, AppMeasures *measures);

/* numbers_statistics.c */
GtkWidget *app_numbers_new_statistics(AppNumbers *self);
void app_numbers_show_statistics(AppNumbers *self, AppMeasures *measures);

/* numbers_balance.c: of scenes whose surfaces reflect light */
GtkWidget *app_numbers_new_balance(AppNumbers *self);
/* Whether one belongs to what is shown. */
void app_numbers_await_balance(AppNumbers *self, gboolean is_coming);
void app_numbers_show_balance(AppNumbers *self, const luxel_balance *balance);

/* numbers_lighting.c: of scenes that have grids or observers */
GtkWidget *app_numbers_new_lighting(AppNumbers *self);
void app_numbers_forget_lighting(AppNumbers *self);

#endif

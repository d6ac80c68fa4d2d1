/* SPDX-License-Identifier: MIT */
/*
 * How numbers are shown on the screen: colours, range, exposure, background.  It changes neither the scene nor what is
 * saved of it.
 */
#ifndef LUXEL_APP_DISPLAY_H
#define LUXEL_APP_DISPLAY_H

#include <glib.h>
#include <luxel/figure.h>

/* The part of a picture in colour that is shown. */
typedef enum AppChannel {
    APP_CHANNEL_COLORS, /* its colours; in false colour the luminance */
    APP_CHANNEL_LUMINANCE,
    APP_CHANNEL_RED,
    APP_CHANNEL_GREEN,
    APP_CHANNEL_BLUE,
    APP_CHANNEL_CCT, /* the colour temperature */
    APP_CHANNELS
} AppChannel;

typedef struct AppDisplay {
    AppChannel channel;   /* has a say in pictures in colour only */
    const char *palette;  /* a name of luxel_palette_name(), which lives for ever */
    gboolean logarithmic; /* colours by the logarithm of the value */
    gboolean is_locked;   /* low and high hold, else the picture's own range does */
    double low, high;     /* low < high */
    double exposure;      /* in stops: values are multiplied by 2^exposure */
    double background[3]; /* the colour where no surface is, 0 to 1 */
    gboolean outline;     /* a line around the surfaces */
    gboolean isophotes;   /* lines of equal value */
    gboolean maximum;     /* a mark at the greatest value */
    gboolean marks;       /* sources, points and the section */
} AppDisplay;

/* The values of the first and the last colour, and how those between lie: low < high. */
typedef struct AppRange {
    double low, high;
    gboolean logarithmic; /* then 0 < low */
} AppRange;

/* Where a value lies between the ends: 0 at the lower one, 1 at the upper one; beyond them less or more. */
double app_range_place(const AppRange *range, double value);
/* The range when an end has gone to the value that stood so many parts of the length farther up. */
AppRange app_range_move(const AppRange *range, gboolean upper, double parts);

/* Grey on black, all marks shown. */
void app_display_init(AppDisplay *display);

/* Whether the picture is shown just as the scene's PNG has it. */
gboolean app_display_is_plain(const AppDisplay *display);

/* The field of one channel of a picture in colour, the caller's; NULL: it is shown itself. */
luxel_field *app_display_view(const luxel_field *field, AppChannel channel);

/* Whether a field is shown in colours of its own. */
gboolean app_display_is_colored(const AppDisplay *display, const luxel_field *field);

/* The least and the greatest number on a surface that is shown: of values, or of channels; 0 where there is none. */
void app_display_ends(const AppDisplay *display, const luxel_field *field, double ends[2]);

/* The values that get the first and the last colour; always low < high, and 0 < low where logarithmic. */
void app_display_range(const AppDisplay *display, const luxel_field *field, double *low, double *high);

/* The colour, 0 to 1 each, that a value has so many parts of the range from its lower end. */
void app_display_color(const AppDisplay *display, const luxel_field *field, double part, double color[3]);

/* Paints the field as pixels of four bytes, blue, green, red, 255, row by row. */
void app_display_paint(const AppDisplay *display, const luxel_field *field, double low, double high, guchar *pixels);

#endif

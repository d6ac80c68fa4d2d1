/* SPDX-License-Identifier: MIT */
/*
 * The part of a picture that a view shows, at the size at which it shows it, so that putting it on the screen is a
 * plain copy.  Reduced pixels are averages; somewhat enlarged ones blend into one another; from four times on each is
 * seen as the square it is.
 */
#ifndef LUXEL_APP_RESAMPLE_H
#define LUXEL_APP_RESAMPLE_H

#include <glib.h>
#include <luxel/field.h>

/* How a view lies over the screen of a scene: at = origin + mm * scale in its dots, y downwards on the view. */
typedef struct AppFrame {
    double origin[2];
    double scale;      /* dots for a millimetre */
    int width, height; /* in dots; 0: the picture as it is */
} AppFrame;

/* A rectangle of the screen. */
typedef struct AppArea {
    double low[2], high[2];
} AppArea;

/* What the pixels of a field cover: half a pixel around the outer samples. */
AppArea app_area_of(const luxel_field *field);

/*
 * The part of a picture of four bytes a pixel that the frame shows: *columns x *rows pixels, the caller's, which cover
 * *area.  `smooth`: pixels blend however much they are enlarged.  NULL where the frame shows none of it.
 */
guchar *app_resample(const guchar *pixels, const luxel_field *field, const AppFrame *frame, gboolean smooth,
                     guint *columns, guint *rows, AppArea *area);

#endif

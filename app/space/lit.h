/* SPDX-License-Identifier: MIT */
/*
 * A scene in space in its own light: a thread makes pictures of it as an orbit sees it, by the sums that the observer's
 * picture is made of, with how far it is to what each pixel shows.  Coarse pictures follow the hand, finer ones come
 * when it rests.  Where surfaces reflect light to each other it is the direct light.
 *
 * Pictures are counted and never change, so that threads share them.
 */
#ifndef LUXEL_APP_LIT_H
#define LUXEL_APP_LIT_H

#include "../picture/picture.h"
#include "orbit.h"

/* What is wanted. */
typedef struct AppLitWish {
    AppMoment *moment; /* a reference is taken */
    AppOrbit orbit;
    double dots; /* pixels of the screen for one of the widget: the finest picture has so many */
    luxel_quantity quantity;
    AppDisplay display; /* by which it is painted, as the observer's picture is, */
    double low, high;   /* in this range of values */
    double seconds;     /* that a pixel of the observer's picture took; 0: not known */
} AppLitWish;

typedef struct AppLit {
    AppMoment *moment; /* that was wanted; NULL: nothing could be seen, as from inside a body */
    AppOrbit orbit;
    guint columns, rows; /* of the pixels */
    guint32 *pixels;     /* as cairo has them, transparent where nothing is seen */
    guint depth_columns, depth_rows;
    float *depth_mm; /* along the line of sight; 0: nothing is seen */
} AppLit;

AppLit *app_lit_ref(AppLit *lit);
void app_lit_unref(AppLit *lit); /* NULL is harmless */

/* How far it is to what is seen at a place of the widget; 0: nothing is. */
double app_lit_depth(const AppLit *lit, double x, double y);
/* Whether a body stands before what is seen at x, y, so far away. */
gboolean app_lit_hides(const AppLit *lit, const double seen[3]);

typedef struct AppLighter AppLighter;

/* `show` is called in the main loop with each picture, which it may keep by app_lit_ref(). */
AppLighter *app_lighter_new(void (*show)(AppLit *lit, gpointer owner), gpointer owner);
void app_lighter_free(AppLighter *lighter); /* NULL is harmless */
/* The newest wish counts. */
void app_lighter_ask(AppLighter *lighter, const AppLitWish *wish);

#endif

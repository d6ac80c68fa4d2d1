/* SPDX-License-Identifier: MIT */
/*
 * Pictures: a scene on its way to the screen.  A thread commits it, computes it and paints it; where that takes longer
 * than a frame, a coarse picture comes at once and the fine one when no newer scene has come.  Where surfaces reflect
 * light to each other, pictures of the direct light come in the same way before that of all light.
 *
 * Moments, shots and pictures are counted and never change, so that threads share them.
 */
#ifndef LUXEL_APP_PICTURE_H
#define LUXEL_APP_PICTURE_H

#include <glib.h>
#include <luxel/drawing.h>
#include <luxel/luxel.h>

#include "display.h"
#include "resample.h"

/* A committed scene at one moment of the work. */
typedef struct AppMoment {
    luxel_scene *scene;
    guint64 serial;           /* of the version of the scene, see AppWish */
    gssize solo;              /* the light that alone is seen, or -1 */
    gsize only;               /* that light */
    gboolean is_direct;       /* without the reflected light that the document's scene asks for */
    struct AppMoment *direct; /* the same without that light; NULL: there is none, or it is that itself */
    luxel_surface_outlines
        *outlines; /* of its surfaces; the painter's, which makes them when they are wanted; NULL: none */
} AppMoment;

/* Its field. */
typedef struct AppShot {
    AppMoment *moment;
    luxel_field *field;
    gboolean is_fine;      /* every pixel; else a quick look */
    double seconds;        /* that it took */
    AppChannel channel;    /* that the field has, of a picture in colour, */
    struct AppShot *whole; /* which is this one; NULL: it is that itself, or grey */
} AppShot;

/* Which picture is shown, where one was pinned. */
typedef enum AppSide { APP_SIDE_LIVE, APP_SIDE_PINNED, APP_SIDE_DIFFERENCE } AppSide;

typedef struct AppPicture {
    AppShot *shot;       /* NULL: the scene could not be computed, `faults` say why */
    AppDisplay display;  /* by which it was painted */
    AppSide side;        /* what was painted */
    AppShot *pinned;     /* that it was compared with; NULL: none */
    guchar *pixels;      /* three bytes each, red, green, blue */
    guint columns, rows; /* of the pixels */
    AppArea area;        /* of the screen, which they cover */
    double low, high;    /* the range of the colours */
    gboolean has_comparison;
    luxel_comparison comparison; /* of the shot with the pinned one */
    luxel_diagnostics *faults;   /* NULL: none */
    guint64 serial;              /* of the version that was asked for */
} AppPicture;

/* The version of the scene that a number, mark, list, curve or text belongs to; {0}: to none. */
typedef struct AppVersion {
    guint64 shot, minus; /* the serial of what it was read off, and of what was taken off that; 0: nothing was */
    gboolean is_direct;  /* direct light alone of a scene that reflects */
    AppChannel channel;  /* of a picture in colour */
} AppVersion;

AppVersion app_version_of(const AppShot *shot, const AppShot *minus);
gboolean app_version_equal(const AppVersion *a, const AppVersion *b);

AppMoment *app_moment_ref(AppMoment *moment);
void app_moment_unref(AppMoment *moment); /* NULL is harmless, as below */
AppShot *app_shot_ref(AppShot *shot);
void app_shot_unref(AppShot *shot);
/* The shot, or the whole that it is a channel of, as it shows that channel; a reference, the caller's. */
AppShot *app_shot_view(AppShot *shot, AppChannel channel);
/* The field as it was computed, whichever channel is shown. */
const luxel_field *app_shot_light(const AppShot *shot);
AppPicture *app_picture_ref(AppPicture *picture);
void app_picture_unref(AppPicture *picture);

/* A pixel's value as the picture shows it, or the difference of two; FALSE: none, off the surfaces. */
gboolean app_picture_value(const AppPicture *picture, guint column, guint row, double *value);

/* What is wanted of a painter. */
typedef struct AppWish {
    luxel_scene *scene; /* a copy, not committed, which is taken over */
    guint64 serial;     /* another one, and a greater one, for each scene, light that alone is seen, and quantity */
    gssize solo;
    luxel_quantity quantity;
    gboolean is_direct; /* light that surfaces reflect is not wanted, whatever the scene says */
    AppDisplay display;
    AppFrame frame; /* of the view */
    AppSide side;
    AppShot *pinned; /* to compare with; a reference is taken; NULL: none */
} AppWish;

/* Makes pictures in a thread of its own. */
typedef struct AppPainter AppPainter;

/* `show` is called in the main loop with each picture, which it may keep by app_picture_ref(). */
AppPainter *app_painter_new(void (*show)(AppPicture *picture, gpointer owner), gpointer owner);
void app_painter_free(AppPainter *painter);

/* The newest wish counts: older ones are given up, unless they are within a frame of being done. */
void app_painter_ask(AppPainter *painter, const AppWish *wish);

/* How far the present computation is, 0 to 1, and for how many seconds it has been going on; FALSE: none is. */
gboolean app_painter_progress(AppPainter *painter, double *done, double *seconds);

/* Whether a wish waits or is being fulfilled. */
gboolean app_painter_is_busy(AppPainter *painter);

/* A moment made at once, in the calling thread, for files and tests; NULL: it has faults. */
AppMoment *app_moment_new(luxel_scene *scene, guint64 serial, gssize solo, luxel_diagnostics *faults);
/* Leaves a scene that is not committed the direct light alone, which is there at once; FALSE: it has no other. */
gboolean app_scene_leave_direct(luxel_scene *scene);
/* Which lights are seen: sets the group of the settings, which point into the moment then. */
void app_moment_light(const AppMoment *moment, luxel_settings *settings);
gboolean app_moment_is_on(const AppMoment *moment, gsize light);
/* The unit of a quantity by the light that is seen, not translated. */
const char *app_moment_unit(const AppMoment *moment, luxel_quantity quantity);

#endif

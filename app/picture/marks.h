/* SPDX-License-Identifier: MIT */
/*
 * Marks: what can be taken hold of on the picture, where it is seen, and what moving it does to the scene.
 *
 * A source is marked where it is seen; one beyond the edge of the view by an arrow at the edge.  Distant light stands
 * nowhere: its mark moves on a disk as wide as the screen, the way one sees a lamp on a dome, in the middle when it
 * shines along the view.
 */
#ifndef LUXEL_APP_MARKS_H
#define LUXEL_APP_MARKS_H

#include "../files/document.h"
#include "picture.h"

typedef enum AppMarkKind {
    APP_MARK_NONE,
    APP_MARK_SURFACE,
    APP_MARK_SOURCE,
    APP_MARK_POINT,
    APP_MARK_SECTION /* index 0: both lines at their crossing, 1: the horizontal one, 2: the vertical one */
} AppMarkKind;

typedef struct AppMark {
    AppMarkKind kind;
    gsize index;
    gboolean is_distant; /* a direction, not a place */
    gboolean is_on;      /* a source that is enabled */
    gboolean is_behind;  /* distant light from below */
    double place_mm[3];  /* in space, z of points 0; of distant light the direction towards it */
    double screen_mm[2]; /* where it is seen */
    char label[48];      /* of sources and points: "2 fill", "P1" */
} AppMark;

/* The marks of a moment: surfaces, sources, points (at most APP_MOST_POINTS); AppMark's, the caller's. */
GArray *app_marks_of(const AppMoment *moment);

/* How a mark is being moved. */
typedef struct AppHand {
    AppMark mark;
    double grip_mm[2];    /* where the pointer took hold, on the screen */
    double pointer_mm[2]; /* where it is now, motion while `fine` counting a tenth */
    double last_mm[2];    /* where it really was last */
    double gain;          /* of an arrow at the edge: how much farther out the source is */
    double start_mm[3];   /* the place at the beginning */
    double height_grip;   /* pointer_mm[1] since which the height changes */
    gboolean was_height;
} AppHand;

typedef struct AppTouch {
    double pointer_mm[2];
    double mm_per_pixel; /* of the view: so exact need the numbers be */
    gboolean fine;       /* a tenth of the motion */
    gboolean snap;       /* to round numbers */
    gboolean height;     /* up and down change z */
} AppTouch;

/* `shown_mm`: where the mark is shown, which of an arrow is not where the source is seen. */
void app_hand_take(AppHand *hand, const AppMark *mark, const double pointer_mm[2], const double shown_mm[2]);
/* Moves it; the numbers go into the document.  FALSE where that is not possible. */
gboolean app_hand_move(AppHand *hand, const AppTouch *touch, const AppMoment *moment, AppDocument *document);
/* The direction, of unit length, of a light from far away as the document has it; FALSE: it is another. */
gboolean app_mark_direction(AppDocument *document, gsize light, double unit[3]);

/* Shifts a mark in space by a step, for keys and the wheel. */
gboolean app_mark_shift(const AppMark *mark, const double step_mm[3], AppDocument *document);

/* The key of a source's or surface's place, such as "lights[0].position"; the caller's; NULL where it has none. */
char *app_place_key(const AppDocument *document, AppMarkKind kind, gsize index);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * A scene in space, as what shows it there draws it: lines in the scene's coordinates, and things that can be grabbed,
 * each with the key of the scene that says where it is.  It knows no widget.
 */
#ifndef LUXEL_APP_SPACE_H
#define LUXEL_APP_SPACE_H

#include "../files/document.h"
#include "../picture/picture.h"

/* The two projections: from above on x and y, from the front on x and z. */
typedef enum AppProjection { APP_PLAN, APP_ELEVATION, APP_PROJECTIONS } AppProjection;

/* The coordinate that a projection shows upwards: 1 is y, 2 is z.  To the right there is always x. */
int app_projection_up(AppProjection projection);

typedef enum AppThingKind {
    APP_THING_NONE,
    APP_THING_LAMP,
    APP_THING_AIM,       /* the place at which a lamp is aimed */
    APP_THING_AXIS,      /* the end of an arrow along a lamp's axis */
    APP_THING_C0,        /* the end of an arrow towards a luminaire's plane C = 0 */
    APP_THING_DIRECTION, /* a place in the direction that distant light comes from */
    APP_THING_SURFACE,
    APP_THING_OBSERVER,
    APP_THING_TARGET /* the place at which the observer looks */
} AppThingKind;

enum { APP_KEY_SIZE = 64, APP_MOST_THINGS = 600 };

typedef struct AppThing {
    AppThingKind kind;
    gsize index;            /* of the light or the surface */
    gboolean is_on;         /* of a light: enabled */
    gsize place, places;    /* of a light: which of its array's, from 1 on, or 0 all of it; and how many there are */
    double off_mm[3];       /* how far a place of an array is from where the key has the light */
    double at_mm[3];        /* where it is grabbed */
    double from_mm[3];      /* where the arrow to it begins, of aims, axes and directions */
    char key[APP_KEY_SIZE]; /* that moving it changes: "lights[0].position" */
} AppThing;

/* Whose a line is. */
typedef enum AppLineKind { APP_LINE_SURFACE, APP_LINE_LAMP, APP_LINE_AIM, APP_LINE_SCREEN, APP_LINE_SIGHT } AppLineKind;

/* A chain of places. */
typedef struct AppLine {
    AppLineKind kind;
    gsize index;        /* of the surface or the light */
    gboolean closed;    /* the last place is joined to the first */
    gboolean goes_on;   /* the next line goes with it around one area, as those around a hole do */
    guint projections;  /* in which it is drawn, a bit each */
    gsize first, count; /* of the places */
} AppLine;

/* The cone of a spot, as far as it is aimed. */
typedef struct AppCone {
    gsize light;
    double tip_mm[3], axis[3]; /* a unit vector */
    double length_mm, radius_mm;
} AppCone;

typedef struct AppSpace {
    GArray *things;             /* AppThing's; lamps first */
    GArray *lines;              /* AppLine's */
    GArray *places;             /* three numbers each, in mm */
    GArray *cones;              /* AppCone's */
    double floor_mm[3];         /* the lowest coordinates of bodies, 0 or below */
    double low[3], high[3];     /* that hold all of them */
    double eye_mm[3];           /* where the observer stands */
    double sight[3];            /* the unit vector to the observer, where that is the same everywhere */
    gboolean is_sight_parallel; /* it is */
} AppSpace;

typedef struct AppOutlines AppOutlines; /* outlines.h */

/* The caller's; NULL: the scene is not committed.  Silhouettes are taken from the outlines; NULL: surfaces have no
 * lines. */
AppSpace *app_space_new(const AppMoment *moment, AppOutlines *outlines);
void app_space_free(AppSpace *space);

/* What a thing is, and where: "Source 2", "x 1500, y 200, z 2200 mm"; the caller's. */
char *app_thing_tell(const AppThing *thing);

/* The unit vector from a place to the observer, as the formula of the highlight has it. */
void app_space_view(const AppSpace *space, const double place_mm[3], double view[3]);

/* The unit vector from a place with this normal to a lamp, or against distant light; FALSE: it is none that shines
 * there. */
gboolean app_space_light(const AppThing *thing, const double place_mm[3], const double normal[3], double light[3]);

/*
 * Moves a thing: the coordinates of the projection become those of `to_mm`, rounded to `grain_mm`, the third one stays.
 * Corners are moved by as much as the thing.  The at_mm of what stands at a place follows.  FALSE where it cannot be
 * moved so.
 */
gboolean app_space_move(AppThing *thing, AppProjection projection, const double to_mm[3], double grain_mm,
                        AppDocument *document);
/* Moves all three coordinates of a thing, else as above. */
gboolean app_space_carry(AppThing *thing, const double to_mm[3], double grain_mm, AppDocument *document);
/* Whether a projection can move it at all: the height of an observer is not seen from above. */
gboolean app_space_moves(const AppThing *thing, AppProjection projection);

#endif

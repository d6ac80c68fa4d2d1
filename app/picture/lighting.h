/* SPDX-License-Identifier: MIT */
/*
 * Lighting: what the measuring grids and the observers of a scene measure, and whether their limits are kept.  Both are
 * counted and never change, so that threads share them.  A survey finds them in a thread of its own.
 */
#ifndef LUXEL_APP_LIGHTING_H
#define LUXEL_APP_LIGHTING_H

#include "picture.h"

enum { APP_MOST_LIMITS = 2 * LUXEL_MOST_LIMITS };

/* A grid with its areas, judged. */
typedef struct AppGrid {
    luxel_grid *grid;
    luxel_limit limits[APP_MOST_LIMITS]; /* of the grid, then of its areas */
    gsize limit_count;
} AppGrid;

typedef struct AppGrids {
    AppMoment *moment;
    AppGrid *list;
    gsize count;
    double most; /* the greatest value of all of them */
} AppGrids;

/* Those that are one entry of the list of observers: the worst of their ratings counts. */
typedef struct AppEye {
    luxel_glare_sight sight; /* of the first */
    gsize places;            /* how many there are */
    gboolean has_rating;
    luxel_bounded rating;                /* the greatest */
    luxel_limit limits[APP_MOST_LIMITS]; /* the worst of each */
    gsize limit_count;
} AppEye;

typedef struct AppEyes {
    AppMoment *moment;
    AppEye *list;
    gsize count;
} AppEyes;

/* Those of a moment; NULL: it was given up, or failed. */
AppGrids *app_grids_new(AppMoment *moment, const luxel_settings *settings);
AppEyes *app_eyes_new(AppMoment *moment, const luxel_settings *settings);

AppGrids *app_grids_ref(AppGrids *grids); /* NULL is harmless, as below */
void app_grids_unref(AppGrids *grids);
AppEyes *app_eyes_ref(AppEyes *eyes);
void app_eyes_unref(AppEyes *eyes);

/* The worst verdict of all limits; LUXEL_PASS where there is none. */
luxel_verdict app_limits_verdict(const luxel_limit *limits, gsize count);

/* The cell of a grid that a place is on, of which the coordinates x and `other` (1 or 2) count; FALSE: on none that has
 * a value, or the plane stands on edge. */
gboolean app_grid_find_cell(const luxel_grid *grid, int other, const double place_mm[3], gsize *cell);

/* "work plane", or "grid 2", "observer 2" of one without a name; the caller's. */
char *app_grid_name(const AppGrids *grids, gsize i);
char *app_eye_name(const AppEyes *eyes, gsize i);

/* Measures them in scenes that have some, apart from the picture. */
typedef struct AppSurvey AppSurvey;

/* Findings in a version of the scene, which is kept by a reference: grids at first, then eyes; the other is NULL,
 * and both are where the grids cannot be measured. */
typedef void (*AppSurveyTell)(AppGrids *grids, AppEyes *eyes, guint64 serial, gpointer owner);

/* `tell` is called in the main loop. */
AppSurvey *app_survey_new(AppSurveyTell tell, gpointer owner);
void app_survey_free(AppSurvey *survey);
/* The newest scene counts; it is not committed and is taken over.  Serial and solo are those of wishes. */
void app_survey_ask(AppSurvey *survey, luxel_scene *scene, guint64 serial, gssize solo);

#endif

/* SPDX-License-Identifier: MIT */
/* The results of a scene as one text: the greatest and the least value, where they are, and the points. */
#ifndef LUXEL_APP_RESULTS_H
#define LUXEL_APP_RESULTS_H

#include "../picture/measures.h"

/* What is told of; NULL or FALSE what is not known. */
typedef struct AppResults {
    const char *title;             /* of the scene */
    const char *unit;              /* "brightness, W/sr" */
    const luxel_field *field;      /* the picture, of which the pixels' extrema are; NULL: a difference */
    const luxel_extrema *extrema;  /* between the pixels */
    const luxel_extremum *reached; /* the least value where light arrives */
    const AppPoint *points;
    gsize point_count;
} AppResults;

/* One result to a line, with tabs between name, value and place, for tables and for mails; the caller's. */
char *app_results_text(const AppResults *results);

#endif

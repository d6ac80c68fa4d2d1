/* SPDX-License-Identifier: MIT */
/* The inside of a row, for the files that make it up. */
#ifndef LUXEL_APP_ROW_PRIVATE_H
#define LUXEL_APP_ROW_PRIVATE_H

#include "row.h"

/* What a hand on the label does: where it begins, FALSE if there is nothing to move, and so many dots from there. */
typedef struct AppRowHand {
    gboolean (*begins)(AppRow *self);
    void (*moves)(AppRow *self, double dots, gboolean fine, gboolean coarse);
} AppRowHand;

struct _AppRow {
    GtkBox parent;
    AppRowKind kind;
    luxel_parameter_range legal, advised;
    char *label, *advised_words;
    gboolean logarithmic; /* a drag */
    gboolean is_updating; /* values are shown, not edited */
    gboolean is_wrong;    /* what is typed cannot be taken */
    gboolean is_empty;    /* there is no number */
    gboolean is_part;     /* a vector has its note and its unit */
    gboolean is_dragged;  /* its label */
    double value, start;  /* now, and on the scale of a drag when it began */
    const AppRowHand *hand;
    GtkWidget *name, *control, *unit, *note;
};

/* Says something below the row, as what is wrong or as advice; NULL: nothing. */
void app_row_note(AppRow *self, const char *text, gboolean wrong);
/* Says whether the value lies in the advised range. */
void app_row_say_state(AppRow *self);
gboolean app_row_is_outside(const luxel_parameter_range *range, double value);
/* Takes the text of the field, where it is another than was shown. */
void app_row_enter(AppRow *self);
/* What cannot be taken does not stay behind as if it were the value; why it was not taken does. */
void app_row_leave(AppRow *self);

/* row_drag.c: the label is dragged. */
void app_row_make_draggable(AppRow *self, const AppRowHand *hand);

/* row_date.c: the label of a date is dragged through its day. */
void app_row_make_date(AppRow *self);

/* row_number.c: the field of a number, which stands in the line; `missing`: what holds where it is empty, or NULL. */
void app_row_add_number(AppRow *self, GtkWidget *line, const char *missing);
/* The field shows the value. */
void app_row_show_number(AppRow *self);

#endif

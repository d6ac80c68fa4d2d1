/* SPDX-License-Identifier: MIT */
/* The inside of the view, for the files that make it up. */
#ifndef LUXEL_APP_VIEW_PRIVATE_H
#define LUXEL_APP_VIEW_PRIVATE_H

#include "turn.h"
#include "view.h"
#include "view_draw.h"

typedef enum Doing { DOING_NOTHING, DOING_MOVE, DOING_PAN } Doing;

struct _AppView {
    GtkWidget parent;
    AppDocument *document;
    AppPicture *picture;
    GdkTexture *texture;
    GArray *marks; /* of the moment that is shown */
    luxel_isophotes *isophotes;
    guint64 isophotes_serial; /* of the version that they are of: over a picture of another one they are dimmed */
    gboolean section_shown;
    double section_mm[2];
    gboolean is_read; /* a section, at this place */
    double read_mm[2];
    gboolean is_kept; /* a place, where “Why?” is kept */
    double kept_mm[2];
    AppMarkKind selected_kind;
    gsize selected_index;
    GArray *chosen;           /* gsize: the sources that are chosen together */
    AppMarkKind hovered_kind; /* that the pointer is on, here or in a list */
    gsize hovered_index;
    char *hint;        /* beside the first source; NULL: none */
    gssize surface;    /* under the pointer */
    gboolean is_stale; /* the document can no longer be computed: the picture is of a scene of before */
    gboolean is_fitted;
    AppArea screen;    /* that is fitted */
    AppMap map, told;  /* `told`: as it was when the last signal went out */
    double pointer[2]; /* in the widget */
    Doing doing;
    gboolean is_toggling; /* pressed with Ctrl or Shift, and not moved yet */
    gboolean was_chosen;  /* what was pressed, with others */
    AppTurn *turn;        /* of light from far away that is chosen with it, while it is held; NULL: none */
    AppMark pressed;      /* a surface that a click chooses; of no kind: none */
    gboolean has_moved;
    AppHand hand;
    double pan_start[2];
    double pinch; /* the scale that was zoomed by so far */
};

/* Zooms so that what is at a place of the widget stays there. */
void app_view_zoom_at(AppView *self, const double at[2], double factor);
/* Tells when the map has become another. */
void app_view_tell_frame(AppView *self);

/* Whether a mark is one of several sources that are chosen together. */
gboolean app_view_is_chosen(const AppView *self, const AppMark *mark);

/* view_input.c: what the pointer, the wheel, the keys and fingers do. */
void app_view_add_input(AppView *self);
/* Ends what the hand does. */
void app_view_let_go(AppView *self);

#endif

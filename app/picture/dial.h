/* SPDX-License-Identifier: MIT */
/*
 * The colour bar as a dial: its ends are dragged or moved by keys, a drag between them changes the exposure, which
 * counts in stops, and two buttons lock the range and make it logarithmic.  A needle shows the value under the pointer,
 * ticks above the bar the isophotes, and triangles at the ends that there are values beyond.
 */
#ifndef LUXEL_APP_DIAL_H
#define LUXEL_APP_DIAL_H

#include <gtk/gtk.h>

#include "display_form.h"
#include "picture.h"

#define APP_TYPE_DIAL (app_dial_get_type())
G_DECLARE_FINAL_TYPE(AppDial, app_dial, APP, DIAL, GtkBox)

/* The form whose display is turned; set once. */
void app_dial_set_form(AppDial *self, AppDisplayForm *form);
/* The range, the colours and the words are those of a picture from now on, to which a
 * reference is taken.  NULL: there is none. */
void app_dial_set_picture(AppDial *self, AppPicture *picture);
/* The levels that have ticks; NULL: none. */
void app_dial_set_isophotes(AppDial *self, const luxel_isophotes *isophotes);
/* The value under the pointer; NaN: none. */
void app_dial_set_needle(AppDial *self, double value);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Why a value is what it is, a card on the picture, which it does not move: the value at the place where the pointer
 * rested or that was kept, what each source gives of it, the formula of the chosen one filled with the numbers of the
 * place, and one click away the whole calculation, as `luxel explain` prints it.
 *
 * Signal: "kept" when the place at which the card is kept has become another one, or none.
 */
#ifndef LUXEL_APP_WHY_H
#define LUXEL_APP_WHY_H

#include <gtk/gtk.h>

#include "../picture/picture.h"

#define APP_TYPE_WHY (app_why_get_type())
G_DECLARE_FINAL_TYPE(AppWhy, app_why, APP, WHY, GtkBox)

GtkWidget *app_why_new(void);

/* The card comes or goes. */
void app_why_show(AppWhy *self, gboolean shown);
gboolean app_why_is_shown(const AppWhy *self);

/* Keeps the card at a place of the screen of this shot, which it explains from now on; with a point of the scene (-1:
 * none) it goes where that goes. */
void app_why_pin(AppWhy *self, AppShot *shot, const double place_mm[2], gssize point);
/* The place at which the card is kept; FALSE: it follows the pointer, or is not shown. */
gboolean app_why_pinned(const AppWhy *self, double place_mm[2]);

/* The pointer is at a place of the screen, of this shot; where it rests it is explained, if that is wanted. */
void app_why_point(AppWhy *self, AppShot *shot, double x_mm, double y_mm);
/* The picture that is shown has become this shot: what was explained is explained anew there. */
void app_why_follow(AppWhy *self, AppShot *shot);
/* The version that is shown; the explanation of another one is dimmed. */
void app_why_set_version(AppWhy *self, guint64 serial);
/* Another scene is opened: nothing is left of the one before. */
void app_why_forget(AppWhy *self);
/* Whose formula is shown. */
void app_why_choose(AppWhy *self, gsize light);

#endif

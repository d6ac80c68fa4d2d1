/* SPDX-License-Identifier: MIT */
/*
 * Sources from far away that are chosen together and turn as one of them does: the turn that takes the direction that
 * this one had into the one that it has is made of the directions that the others had when it began, so that many small
 * turns add no rounding.
 */
#ifndef APP_TURN_H
#define APP_TURN_H

#include "../files/document.h"

typedef struct AppTurn AppTurn;

/* Begins to turn the source `held`, one of `lights` (gsize); NULL where it or all the others do not come from far away.
 */
AppTurn *app_turn_begin(AppDocument *document, const GArray *lights, gsize held);

/* Turns the others to where the held one has been turned by now; NULL is harmless, also to free. */
void app_turn_follow(const AppTurn *turn, AppDocument *document);
void app_turn_free(AppTurn *turn);

G_DEFINE_AUTOPTR_CLEANUP_FUNC(AppTurn, app_turn_free)

#endif

/* SPDX-License-Identifier: MIT */
/* Hours of sun at a place of the screen, on the day of the scene's sky or sun. */
#ifndef LUXEL_APP_SUNSHINE_H
#define LUXEL_APP_SUNSHINE_H

#include <luxel/luxel.h>

#include <glib.h>

/*
 * "Sun on 2026-03-21: 06:12–09:30, 12:01–18:03; 9.4 h"; the caller's.  NULL: no light of the scene has a date, no
 * surface is seen there, or it was given up.  The scene is one without reflected light, which has no say.
 */
char *app_sunshine(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm);

#endif

/* SPDX-License-Identifier: MIT */
/* The look of a lamp: one colour and one number, by which it is known in the list, on the picture and in curves. */
#ifndef LUXEL_APP_LAMP_H
#define LUXEL_APP_LAMP_H

#include <cairo.h>
#include <glib.h>

/* Whether colours are for a dark ground, as the theme of the windows has it; one for the whole program. */
void app_lamp_use_dark(gboolean dark);
gboolean app_lamp_is_dark(void);

/* The colour of a light: red, green and blue from 0 to 1. */
void app_lamp_color(gsize light, double color[3]);
/* Its number on its colour, as markup; the caller's. */
char *app_lamp_markup(gsize light);

/* The radius of a badge, without the line around it. */
enum { APP_BADGE_RADIUS = 8 };

/* How a badge is drawn. */
typedef struct AppBadge {
    gsize light;
    gboolean is_on;    /* else it is hollow */
    gboolean selected; /* with a bold line around it */
} AppBadge;

/* The number of a light in a disk of its colour, around the origin of the context. */
void app_lamp_draw_badge(cairo_t *cairo, const AppBadge *badge);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * How the picture is shown: channel, colours, range, exposure, background, marks.
 *
 * Signal: "changed" when the user changed something.
 */
#ifndef LUXEL_APP_DISPLAY_FORM_H
#define LUXEL_APP_DISPLAY_FORM_H

#include <gtk/gtk.h>

#include "display.h"

#define APP_TYPE_DISPLAY_FORM (app_display_form_get_type())
G_DECLARE_FINAL_TYPE(AppDisplayForm, app_display_form, APP, DISPLAY_FORM, GtkBox)

GtkWidget *app_display_form_new(void);
const AppDisplay *app_display_form_get(AppDisplayForm *self);
void app_display_form_set(AppDisplayForm *self, const AppDisplay *display);
/* The range that the picture has now: what locking keeps. */
void app_display_form_tell_range(AppDisplayForm *self, double low, double high);
/* Whether the picture is one in colour, of which a channel can be chosen. */
void app_display_form_tell_color(AppDisplayForm *self, gboolean colored);

/* The keys of viewers: brighter or darker by half a stop, the range locked to the picture's, all as at the start. */
void app_display_form_expose(AppDisplayForm *self, double stops);
void app_display_form_normalise(AppDisplayForm *self);
void app_display_form_reset(AppDisplayForm *self);

/* The name of luxel_palette_name() that is the same, which lives for ever; NULL: there is none. */
const char *app_palette_named(const char *name);

#endif

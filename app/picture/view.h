/* SPDX-License-Identifier: MIT */
/*
 * The view: the picture with its marks, fitted or zoomed, and the hand on it.  Drags change the document itself.
 *
 * Signals: "pointed" (x_mm, y_mm, is_inside) when the pointer moves; "selected" (kind, index) when a mark was taken;
 * "section-moved" (x_mm, y_mm); "framed" when another part of the screen is shown than before; "hovered" (kind, index)
 * when the pointer comes to a mark, or with kind 0 leaves it; "moved" when a drag moves a mark; "toggled"
 * (index) when a source is to be chosen beside the others, or no longer.
 */
#ifndef LUXEL_APP_VIEW_H
#define LUXEL_APP_VIEW_H

#include <gtk/gtk.h>

#include "marks.h"
#include "measures.h"

#define APP_TYPE_VIEW (app_view_get_type())
G_DECLARE_FINAL_TYPE(AppView, app_view, APP, VIEW, GtkWidget)

/* The document that drags change; set once. */
void app_view_set_document(AppView *self, AppDocument *document);
/* Shows a picture; a reference is taken. */
void app_view_set_picture(AppView *self, AppPicture *picture);
/* Shows these lines of a version of the scene from now on; they are taken over.  NULL: none. */
void app_view_set_isophotes(AppView *self, luxel_isophotes *isophotes, guint64 serial);
/* Shows the section's lines; `shown` FALSE: not. */
void app_view_set_section(AppView *self, gboolean shown, const double section_mm[2]);
/* Rings the place at which a section is read; NULL: none is. */
void app_view_set_read(AppView *self, const double place_mm[2]);
/* Rings the place at which “Why?” is kept; NULL: it is not. */
void app_view_set_kept(AppView *self, const double place_mm[2]);
/* Which source is marked as the chosen one. */
void app_view_select(AppView *self, AppMarkKind kind, gsize index);
/* The sources that are chosen together (gsize), which are moved together. */
void app_view_choose(AppView *self, const GArray *lights);
/* Which mark is lit up, as the pointer is on its line in a list; kind APP_MARK_NONE: none. */
void app_view_hover(AppView *self, AppMarkKind kind, gsize index);
/* Another scene is opened: nothing is left of the one before, and what was held is let go. */
void app_view_forget(AppView *self);
/* Dims the picture: it is of an earlier scene, as the present one cannot be computed. */
void app_view_set_stale(AppView *self, gboolean stale);
/* Which surface was under the pointer, -1 for none: what a press there takes. */
void app_view_set_surface(AppView *self, gssize surface);

/* Words beside the first source's mark; NULL: none. */
void app_view_set_hint(AppView *self, const char *hint);

void app_view_fit(AppView *self);
/* One pixel of the picture on one of the screen. */
void app_view_one_to_one(AppView *self);
void app_view_zoom(AppView *self, double factor);
/* Millimetres for a pixel of the widget. */
double app_view_mm_per_pixel(AppView *self);
/* Dots of the screen for a pixel of the picture; 0: there is none. */
double app_view_magnification(AppView *self);

/* What the view shows of the screen, for the painter. */
AppFrame app_view_frame(AppView *self);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * The list of sources with what each gives, and the form of the chosen one; of several that are chosen, of the
 * one that was chosen last, and its changes are for all of them.
 *
 * Signals: "chosen" (index) when another one was chosen; "solo" (index, -1 for none) when one alone is to be seen;
 * "hovered" (index, -1 for none) when the pointer comes to a row or leaves it.
 */
#ifndef LUXEL_APP_SOURCES_H
#define LUXEL_APP_SOURCES_H

#include "../picture/measures.h"
#include "form.h"

#define APP_TYPE_SOURCES (app_sources_get_type())
G_DECLARE_FINAL_TYPE(AppSources, app_sources, APP, SOURCES, GtkBox)

GtkWidget *app_sources_new(AppDocument *document, const luxel_parameters *parameters);

void app_sources_refresh(AppSources *self);
/* Chooses one source alone; or takes one more in, or one out, of which one stays. */
void app_sources_choose(AppSources *self, gsize index);
void app_sources_toggle(AppSources *self, gsize index);
/* All that are chosen, rising (gsize); they are changed together.  Which of them the form shows. */
const GArray *app_sources_chosen(const AppSources *self);
gsize app_sources_shown(const AppSources *self);
/* Which row is lit up, as the pointer is on its mark; -1: none. */
void app_sources_hover(AppSources *self, gssize index);
/* The version of the scene that is shown: what the sources give in another one is dimmed.  FALSE: that is still on its
 * way. */
gboolean app_sources_set_version(AppSources *self, guint64 serial);
/* Another scene is opened: nothing is left of what those of the one before give. */
void app_sources_forget(AppSources *self);
/* Shows flux and irradiance; `photometric`: in lm and lx. */
void app_sources_show(AppSources *self, const AppMeasures *measures, gboolean photometric);
/* Shows each source's share of the value that was read under the pointer; NULL: there is none. */
void app_sources_show_shares(AppSources *self, const AppReading *reading);
/* Marks a wrong key; TRUE where the form has it. */
gboolean app_sources_set_fault(AppSources *self, const char *key, const char *reason);

/* What can be done with sources; the window's actions call these. */
void app_sources_add(AppSources *self, const char *kind);
/* A luminaire of a photometry file, as the scene names it. */
void app_sources_add_luminaire(AppSources *self, const char *file);
void app_sources_duplicate(AppSources *self);
void app_sources_delete(AppSources *self);
void app_sources_move(AppSources *self, int step);
void app_sources_aim(AppSources *self);
void app_sources_end_solo(AppSources *self);
/* Adds a point source for each "x, y, z" of a text; NULL, or what is wrong with it: the caller's. */
char *app_sources_paste(AppSources *self, const char *text);

#endif

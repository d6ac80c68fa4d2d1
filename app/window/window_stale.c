/* SPDX-License-Identifier: MIT */
/*
 * A document that cannot be computed.  The picture of before stays to be worked on, but it is dimmed, as are the
 * numbers, and in the line at the edge stands that it is not of this scene, why, and what would mend it.
 */
#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "window_private.h"

/* Marks the rows that the faults name, in whichever form they stand. */
static void mark_faults(AppWindow *self, const luxel_diagnostics *faults)
{
    AppForm *forms[] = {APP_FORM(self->screen_form), APP_FORM(self->surface_form), APP_FORM(self->material_form),
                        APP_FORM(self->picture_form)};
    for (gsize i = 0; i < G_N_ELEMENTS(forms); i++)
        app_form_set_fault(forms[i], NULL, NULL);
    app_sources_set_fault(APP_SOURCES(self->sources), NULL, NULL);
    for (gsize i = 0; faults && i < luxel_diagnostics_count(faults); i++) {
        const char *key = luxel_diagnostics_get(faults, i)->key;
        char *reason = luxel_diagnostics_message(faults, i, language_translate, NULL);
        for (gsize k = 0; k < G_N_ELEMENTS(forms) && key; k++)
            app_form_set_fault(forms[k], key, reason);
        if (key)
            app_sources_set_fault(APP_SOURCES(self->sources), key, reason);
        luxel_text_free(reason);
    }
}

/* The first error, in words. */
static char *first_fault(const luxel_diagnostics *faults)
{
    for (gsize i = 0; i < luxel_diagnostics_count(faults); i++)
        if (luxel_diagnostics_get(faults, i)->severity == LUXEL_SEVERITY_ERROR)
            return luxel_diagnostics_message(faults, i, language_translate, NULL);
    return NULL;
}

/* Puts a repair on its button; NULL: there is none.  Takes it over. */
static void show_repair(AppWindow *self, AppRepair *repair)
{
    g_clear_pointer(&self->repair, g_ptr_array_unref);
    self->repair = repair;
    gtk_widget_set_visible(self->repair_button, self->repair != NULL);
    if (!self->repair)
        return;
    char *words = app_repair_words(self->repair, self->parameters);
    char *text = g_strdup_printf(_("Mend: %s"), words);
    gtk_label_set_text(GTK_LABEL(self->repair_label), text);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->repair_button), GTK_ACCESSIBLE_PROPERTY_LABEL, text, -1);
    g_free(words);
    g_free(text);
}

static void offer_repair(AppWindow *self, const luxel_diagnostics *faults)
{
    const luxel_scene *good = self->picture && self->picture->shot ? self->picture->shot->moment->scene : NULL;
    show_repair(self, app_repair_find(self->document, faults, good));
}

void app_window_set_stale(AppWindow *self, const luxel_diagnostics *faults)
{
    if (!faults && !self->is_stale && !self->repair)
        return;
    self->is_stale = faults != NULL;
    mark_faults(self, faults);
    if (faults) {
        char *fault = first_fault(faults), *text = g_strdup_printf(_("Not this scene: %s"), fault ? fault : "");
        app_window_set_message(self->stale_label, text);
        gtk_label_set_text(GTK_LABEL(self->status_label), "");
        luxel_text_free(fault);
        g_free(text);
        offer_repair(self, faults);
    } else {
        g_clear_pointer(&self->repair, g_ptr_array_unref);
        app_window_set_message(self->stale_label, ""); /* what is no longer shown is not read out either */
    }
    app_window_reveal_bar(self, self->stale_bar, self->is_stale);
}

void app_window_offer_turn(AppWindow *self, const AppPicture *picture)
{
    if (luxel_field_statistics(app_shot_light(picture->shot))->maximum.exists)
        return;
    luxel_diagnostics *advice = luxel_diagnostics_new();
    AppRepair *repair = NULL;
    (void)luxel_scene_advise(picture->shot->moment->scene, advice);
    for (gsize i = 0; i < luxel_diagnostics_count(advice) && !repair; i++) {
        if (strcmp(luxel_diagnostics_get(advice, i)->id, "turned-away") != 0)
            continue;
        char *hint = luxel_diagnostics_hint(advice, i, NULL, NULL);
        char *text = luxel_diagnostics_message(advice, i, language_translate, NULL);
        repair = app_repair_of_hint(hint ? hint : "");
        if (repair->len == 0)
            g_clear_pointer(&repair, g_ptr_array_unref);
        app_window_set_message(self->stale_label, text);
        luxel_text_free(text);
        luxel_text_free(hint);
    }
    luxel_diagnostics_free(advice);
    if (repair)
        show_repair(self, repair);
    app_window_reveal_bar(self, self->stale_bar, repair != NULL);
}

void app_window_make_repair(AppWindow *self)
{
    if (self->repair)
        app_repair_make(self->repair, self->document);
}

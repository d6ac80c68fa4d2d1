/* SPDX-License-Identifier: MIT */
/* Opening drafts, and computing each thing of them once. */
#include "trial.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

luxel_scene *trial_scene_of(const struct draft *draft)
{
    luxel_scene *scene = NULL;
    char *text = draft_write(draft);
    luxel_status status = luxel_scene_read_text(text, strlen(text), "draft", NULL, &scene);
    free(text);
    if (status == LUXEL_OK && luxel_scene_commit(scene, NULL) == LUXEL_OK)
        return scene;
    luxel_scene_free(scene);
    return NULL;
}

void trial_open(const struct draft *draft, struct trial *trial)
{
    *trial = (struct trial){.draft = draft, .scene = trial_scene_of(draft)};
}

void trial_close(struct trial *trial)
{
    luxel_evaluator_free(trial->evaluator);
    luxel_field_free(trial->pictures[LUXEL_SINGLE]);
    luxel_field_free(trial->pictures[LUXEL_DOUBLE]);
    luxel_scene_free(trial->scene);
}

bool trial_fails(struct trial *trial, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(trial->complaint, sizeof trial->complaint, format, arguments);
    va_end(arguments);
    return false;
}

luxel_settings trial_settings(luxel_precision precision)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.precision = precision;
    settings.threads = 1;
    return settings;
}

luxel_field *trial_render(const luxel_scene *scene, const luxel_settings *settings)
{
    luxel_field *field = NULL;
    return luxel_render(scene, settings, NULL, &field) == LUXEL_OK ? field : NULL;
}

luxel_field *trial_render_draft(const struct draft *draft, const luxel_settings *settings)
{
    luxel_scene *scene = trial_scene_of(draft);
    luxel_field *field = scene ? trial_render(scene, settings) : NULL;
    luxel_scene_free(scene);
    return field;
}

const luxel_field *trial_picture(struct trial *trial, luxel_precision precision)
{
    if (!trial->is_rendered[precision]) {
        const luxel_settings settings = trial_settings(precision);
        trial->pictures[precision] = trial_render(trial->scene, &settings);
        trial->is_rendered[precision] = true;
    }
    return trial->pictures[precision];
}

const luxel_evaluator *trial_evaluator(struct trial *trial)
{
    luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    settings.tolerance = 1e-7; /* of integrals, whose errors the values tell */
    if (!trial->evaluator && luxel_evaluator_new(trial->scene, &settings, NULL, &trial->evaluator) != LUXEL_OK)
        abort();
    return trial->evaluator;
}

double trial_maximum(const luxel_field *picture)
{
    return luxel_field_statistics(picture)->maximum.value;
}

/* Highlights of extended sources are known to the tolerance alone. */
static bool has_wide_highlight(const struct draft *draft)
{
    bool shines = false;
    for (size_t i = 0; i < draft->surface_count; i++)
        shines = shines || draft->surfaces[i].words.model != 0;
    return shines && draft_has_extended(draft);
}

double trial_slack(const struct trial *trial, const luxel_field *picture)
{
    const bool is_double = luxel_field_precision(picture) == LUXEL_DOUBLE;
    const double share = has_wide_highlight(trial->draft) ? 1e-3 : is_double ? 1e-11 : 2e-6;
    return share * trial_maximum(picture) + (is_double ? 1e-300 : 1.2e-38);
}

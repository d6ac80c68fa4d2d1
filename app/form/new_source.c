/* SPDX-License-Identifier: MIT */
/* New lights come from the library, by a copy of the document's scene; doubles and points from the document. */
#include "new_source.h"

#include <string.h>

#include <luxel/light.h>

#include "../base/number.h"
#include "../base/scalar.h"
#include "../picture/marks.h"

static const double STEP_MM = 100; /* between a source and its double */

static char *key_of(gsize light, const char *name)
{
    return g_strdup_printf("lights[%zu].%s", light, name);
}

static char *make(const AppDocument *document, const char *wanted, gsize chosen, gboolean replaces)
{
    luxel_scene *scene = app_document_copy_scene(document);
    char *made = NULL, *yaml = NULL;
    if (scene && luxel_new_light(scene, wanted, chosen, replaces, NULL, &made) == LUXEL_OK)
        yaml = g_strdup(made);
    luxel_text_free(made);
    luxel_scene_free(scene);
    return yaml;
}

char *app_new_source(const AppDocument *document, const char *kind, gsize chosen)
{
    return make(document, kind, chosen, FALSE);
}

char *app_changed_source(const AppDocument *document, const char *kind, gsize index)
{
    return make(document, kind, index, TRUE);
}

char *app_new_luminaire(const AppDocument *document, const char *file, gsize chosen)
{
    char *quoted = app_yaml_quote(file);
    char *example =
        g_strdup_printf("{type: luminaire, file: %s, position: [800, 500, 2500], aim: [0, 0, 1000]}", quoted);
    char *yaml = make(document, example, chosen, FALSE);
    g_free(example);
    g_free(quoted);
    return yaml;
}

static gboolean read_place(const AppDocument *document, AppMarkKind kind, gsize index, double place[3])
{
    char *key = app_place_key(document, kind, index);
    char *text = key && !g_str_has_suffix(key, ".vertices") ? app_document_get(document, key, NULL) : NULL;
    const gboolean read = text && app_list_read(text, place, 3) == 3;
    g_free(text);
    g_free(key);
    return read;
}

char *app_doubled_source(const AppDocument *document, gsize chosen)
{
    static const double aside[3] = {STEP_MM, 0, 0};
    char *key = g_strdup_printf("lights[%zu]", chosen), *yaml = app_document_get(document, key, NULL);
    AppDocument *trial = yaml ? app_document_copy(document) : NULL;
    double place[3];
    if (trial && read_place(trial, APP_MARK_SOURCE, chosen, place)) {
        const AppMark mark = {.kind = APP_MARK_SOURCE, .index = chosen};
        app_mark_shift(&mark, aside, trial);
        g_free(yaml);
        yaml = app_document_get(trial, key, NULL);
    }
    g_clear_object(&trial);
    g_free(key);
    return yaml;
}

/* Strength and attenuation of the chosen source, if it is a point; else those of the exercise. */
static char *rest_of_point(const AppDocument *document, gsize chosen)
{
    static const char *const copied[] = {"intensity", "power", "attenuation", "k", "coefficients"};
    GString *rest = g_string_new(NULL);
    char *type_key = key_of(chosen, "type"), *type = app_document_get(document, type_key, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(copied) && g_strcmp0(type, "point") == 0; i++) {
        gboolean written;
        char *key = key_of(chosen, copied[i]);
        char *value = app_document_get(document, key, &written);
        if (written)
            g_string_append_printf(rest, ", %s: %s", copied[i], value);
        g_free(value);
        g_free(key);
    }
    if (rest->len == 0)
        g_string_append(rest, ", intensity: 10, attenuation: none");
    g_free(type);
    g_free(type_key);
    return g_string_free(rest, FALSE);
}

void app_new_points(const AppDocument *document, const double *places_mm, gsize count, gsize chosen, gsize at,
                    AppEdits *edits)
{
    char *rest = rest_of_point(document, chosen);
    for (gsize i = 0; i < count; i++) {
        char *place = app_list_write(&places_mm[3 * i], 3);
        char *yaml = g_strdup_printf("{type: point, position: %s%s}", place, rest);
        app_edits_add(edits, APP_EDIT_INSERT, "lights", yaml, at + i, 0);
        g_free(yaml);
        g_free(place);
    }
    g_free(rest);
}

/* SPDX-License-Identifier: MIT */
/* Candidates for a repair, and the trial of each on a copy of the scene. */
#include "repair.h"

#include <math.h>
#include <string.h>

#include "../base/choices.h"
#include "../base/number.h"
#include "rules.h"

/* Multiples of a number at fault: upwards in small steps at first, then downwards. */
static const double factors[] = {1.2, 1.5, 2, 3, 5, 10, 20, 50, 100, 1000, 0.8, 0.5, 0.2, 0.1, 0.01, 0.001};

static AppRepair *new_repair(void)
{
    return g_ptr_array_new_with_free_func(g_free);
}

AppRepair *app_repair_of_hint(const char *hint)
{
    static const char begin[] = "-s '";
    AppRepair *repair = new_repair();
    const char *end;
    for (const char *at = strstr(hint, begin); at; at = strstr(end, begin)) {
        at += strlen(begin);
        end = strchr(at, '\'');
        if (!end)
            break;
        g_ptr_array_add(repair, g_strndup(at, (gsize)(end - at)));
    }
    return repair;
}

/* Whether the document can be computed with it. */
static gboolean does(const AppRepair *repair, const AppDocument *document)
{
    luxel_scene *scene = repair->len > 0 ? app_document_copy_scene(document) : NULL;
    gboolean good = scene != NULL;
    for (guint i = 0; i < repair->len && good; i++)
        good = luxel_scene_set(scene, g_ptr_array_index(repair, i), NULL) == LUXEL_OK;
    good = good && luxel_scene_commit(scene, NULL) == LUXEL_OK && luxel_scene_check_view(scene, NULL) == LUXEL_OK;
    luxel_scene_free(scene);
    return good;
}

/* Takes the repair over; NULL where it does not do. */
static AppRepair *if_it_does(AppRepair *repair, const AppDocument *document)
{
    if (does(repair, document))
        return repair;
    g_ptr_array_unref(repair);
    return NULL;
}

static AppRepair *try_value(const AppDocument *document, const char *key, const char *value)
{
    AppRepair *repair = new_repair();
    if (value)
        g_ptr_array_add(repair, g_strdup_printf("%s=%s", key, value));
    return if_it_does(repair, document);
}

static AppRepair *try_hint(const AppDocument *document, const luxel_diagnostics *faults, gsize i)
{
    char *hint = luxel_diagnostics_hint(faults, i, NULL, NULL);
    AppRepair *repair = app_repair_of_hint(hint ? hint : "");
    luxel_text_free(hint);
    return if_it_does(repair, document);
}

/* Round numbers near the one that is at fault. */
static AppRepair *try_numbers(const AppDocument *document, const char *key)
{
    char *text = app_document_get(document, key, NULL), *end = NULL, number[APP_NUMBER_SIZE];
    const double value = text ? g_ascii_strtod(text, &end) : 0;
    const gboolean is_number = text && end != text && *end == '\0' && isfinite(value) && value != 0;
    AppRepair *repair = NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(factors) && is_number && !repair; i++)
        repair = try_value(document, key, app_number_plain(value * factors[i], 2, number));
    g_free(text);
    return repair;
}

/* The value of before, in its own words. */
static AppRepair *try_old(const AppDocument *document, const char *key, const luxel_scene *good)
{
    char *text = NULL, *opened = app_document_get_opened(document, key);
    AppRepair *repair = NULL;
    if (good && luxel_scene_get(good, key, NULL, NULL, &text) == LUXEL_OK)
        repair = try_value(document, key, text);
    luxel_text_free(text);
    if (!repair)
        repair = try_value(document, key, opened);
    g_free(opened);
    return repair;
}

AppRepair *app_repair_find(const AppDocument *document, const luxel_diagnostics *faults, const luxel_scene *good)
{
    AppRepair *repair = NULL;
    for (gsize i = 0; i < luxel_diagnostics_count(faults) && !repair; i++) {
        const luxel_diagnostic *fault = luxel_diagnostics_get(faults, i);
        if (fault->severity != LUXEL_SEVERITY_ERROR)
            continue;
        repair = try_hint(document, faults, i);
        if (!repair && fault->key)
            repair = try_numbers(document, fault->key);
        if (!repair && fault->key)
            repair = try_old(document, fault->key, good);
    }
    /* the fault may be told of another key than the one that was changed */
    const char *changed = app_history_undo_topic(app_document_history(document));
    return repair || !changed ? repair : try_old(document, changed, good);
}

/* The key of an assignment; the caller's.  *value: what stands behind it. */
static char *key_of(const char *assignment, const char **value)
{
    const char *equals = strchr(assignment, '=');
    *value = equals ? equals + 1 : "";
    return g_strndup(assignment, equals ? (gsize)(equals - assignment) : strlen(assignment));
}

gboolean app_repair_make(const AppRepair *repair, AppDocument *document)
{
    AppEdits *edits = app_edits_new();
    for (guint i = 0; i < repair->len; i++) {
        const char *value;
        char *key = key_of(g_ptr_array_index(repair, i), &value);
        app_edits_add(edits, APP_EDIT_SET, key, value, 0, 0);
        g_free(key);
    }
    gboolean made = repair->len > 0 && app_edits_make(edits, document, NULL);
    app_edits_free(edits);
    return made;
}

/* The parameter with a key of a scene, whatever element of a list it is of; NULL: there is none. */
static const luxel_parameter *find(const luxel_parameters *parameters, const char *key)
{
    GString *path = g_string_new(NULL);
    const luxel_parameter *found = NULL;
    for (const char *at = key; *at; at++) {
        g_string_append_c(path, *at);
        while (*at == '[' && at[1] && at[1] != ']')
            at++;
    }
    for (gsize i = 0; i < luxel_parameters_count(parameters) && !found; i++)
        if (strcmp(luxel_parameters_get(parameters, i)->path, path->str) == 0)
            found = luxel_parameters_get(parameters, i);
    g_string_free(path, TRUE);
    return found;
}

char *app_repair_words(const AppRepair *repair, const luxel_parameters *parameters)
{
    GString *words = g_string_new(NULL);
    for (guint i = 0; i < repair->len; i++) {
        const char *value, *separator = i > 0 ? ", " : "";
        char *key = key_of(g_ptr_array_index(repair, i), &value);
        const luxel_parameter *parameter = find(parameters, key);
        char *dot = strchr(key, '.');
        if (dot)
            *dot = '\0';
        const luxel_parameter *group = dot ? find(parameters, key) : NULL;
        if (!parameter)
            g_string_append_printf(words, "%s%s", separator, (const char *)g_ptr_array_index(repair, i));
        else
            g_string_append_printf(words, "%s%s%s%s: %s%s%s", separator, group ? group->label : "", group ? ", " : "",
                                   parameter->label, app_choice_label(value), *parameter->unit ? " " : "",
                                   parameter->unit);
        g_free(key);
    }
    return g_string_free(words, FALSE);
}

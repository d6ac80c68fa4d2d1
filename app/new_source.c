/* SPDX-License-Identifier: MIT */
/* A new source is put together in a copy of the document, which is asked what it gives. */
#include "new_source.h"

#include <math.h>
#include <string.h>

#include "marks.h"
#include "number.h"
#include "picture.h"
#include "scalar.h"

enum { LOOK = 48 /* pixels across of the pictures that tell how strong sources are */ };
static const double STEP_MM = 100;                       /* between a source and its double */
static const double EXAMPLE_CENTER_MM[3] = {0, 0, 1000}; /* what examples shine at */

static const luxel_parameter_kind *find_kind(const luxel_parameters *parameters, const char *name)
{
    for (gsize i = 0; i < luxel_parameters_kind_count(parameters); i++) {
        const luxel_parameter_kind *kind = luxel_parameters_kind(parameters, i);
        if (strcmp(kind->list, "lights") == 0 && strcmp(kind->name, name) == 0)
            return kind;
    }
    return NULL;
}

static char *key_of(gsize light, const char *name)
{
    return g_strdup_printf("lights[%zu].%s", light, name);
}

static char *get(const AppDocument *document, gsize light, const char *name, gboolean *written)
{
    char *key = key_of(light, name), *value = app_document_get(document, key, written);
    g_free(key);
    return value;
}

static void set(AppDocument *document, gsize light, const char *name, const char *value)
{
    char *key = key_of(light, name);
    app_document_set(document, key, value, NULL);
    g_free(key);
}

static void take_out(AppDocument *document, gsize light, const char *name)
{
    char *key = key_of(light, name);
    const AppEdit edit = {.kind = APP_EDIT_REMOVE, .key = key};
    app_document_edit(document, &edit, 1, NULL, NULL);
    g_free(key);
}

/* ---- the law ---- */

static gboolean has_key(const luxel_parameters *parameters, const char *type, const char *name)
{
    for (gsize i = 0; i < luxel_parameters_count(parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(parameters, i);
        if (g_str_has_prefix(parameter->path, "lights[].") && g_strcmp0(parameter->variant, type) == 0 &&
            strcmp(parameter->path + strlen("lights[]."), name) == 0)
            return TRUE;
    }
    return FALSE;
}

/* What decides how light goes out and becomes weaker: from one source to the other, so far as both have the keys. */
static void take_law(AppDocument *trial, const luxel_parameters *parameters, gsize from, gsize to)
{
    static const char *const of_law[] = {"attenuation", "k", "coefficients", "pattern", "exponent"};
    char *type = get(trial, from, "type", NULL), *kind = get(trial, to, "type", NULL);
    const gboolean both_patterns = has_key(parameters, type, "pattern") && has_key(parameters, kind, "pattern");
    for (gsize i = 0; i < G_N_ELEMENTS(of_law); i++) {
        gboolean written;
        /* an exponent is of a pattern, or, of spots, of the cone */
        if (!has_key(parameters, type, of_law[i]) || !has_key(parameters, kind, of_law[i]) ||
            (strcmp(of_law[i], "exponent") == 0 && !both_patterns))
            continue;
        char *value = get(trial, from, of_law[i], &written);
        if (written)
            set(trial, to, of_law[i], value);
        else
            take_out(trial, to, of_law[i]);
        g_free(value);
    }
    g_free(type);
    g_free(kind);
}

/* ---- place and aim ---- */

static gboolean read_place(const AppDocument *document, AppMarkKind kind, gsize index, double place[3])
{
    char *key = app_place_key(document, kind, index);
    char *text = key && !g_str_has_suffix(key, ".vertices") ? app_document_get(document, key, NULL) : NULL;
    const gboolean read = text && app_list_read(text, place, 3) == 3;
    g_free(text);
    g_free(key);
    return read;
}

/* On the other side of the surface than the chosen source; above it, beside it. */
static void choose_place(const double center[3], const double chosen[3], double place[3])
{
    const double aside[2] = {chosen[0] - center[0], chosen[1] - center[1]}, height = chosen[2] - center[2];
    memcpy(place, chosen, 3 * sizeof *place);
    if (hypot(aside[0], aside[1]) < 0.1 * fabs(height))
        place[0] = center[0] - round(fabs(height) / 20) * 10;
    else if (fabs(aside[0]) >= fabs(aside[1]))
        place[0] = center[0] - aside[0];
    else
        place[1] = center[1] - aside[1];
}

/* Whether another source stands there, or nearly. */
static gboolean is_taken(const AppDocument *trial, gsize light, const double place[3])
{
    static const double NEAR_MM = 1;
    double other[3];
    for (gsize i = 0; i < light; i++)
        if (read_place(trial, APP_MARK_SOURCE, i, other) &&
            hypot(hypot(other[0] - place[0], other[1] - place[1]), other[2] - place[2]) < NEAR_MM)
            return TRUE;
    return FALSE;
}

/* Where one stands already, the new one stands an eighth of a turn further around the surface, or another one. */
static void give_way(const AppDocument *trial, gsize light, const double center[3], double place[3])
{
    enum { PLACES = 8 };
    const double aside[2] = {place[0] - center[0], place[1] - center[1]};
    for (int i = 1; i < PLACES && is_taken(trial, light, place); i++) {
        const double turn = 2 * G_PI * i / PLACES;
        place[0] = round(center[0] + aside[0] * cos(turn) - aside[1] * sin(turn));
        place[1] = round(center[1] + aside[0] * sin(turn) + aside[1] * cos(turn));
    }
}

static void put(AppDocument *trial, gsize light, const double place[3])
{
    char *key = app_place_key(trial, APP_MARK_SOURCE, light), *value = app_list_write(place, 3);
    if (key && !g_str_has_suffix(key, ".vertices"))
        app_document_set(trial, key, value, NULL);
    g_free(key);
    g_free(value);
}

/* Aimed at the middle of the first surface, if it has been aimed at all. */
static void aim(AppDocument *trial, gsize light, const char *center)
{
    static const char *const parts[] = {"", "rectangle.", "disk."};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        gboolean written;
        char *name = g_strconcat(parts[i], "aim", NULL);
        g_free(get(trial, light, name, &written));
        if (written)
            set(trial, light, name, center);
        g_free(name);
    }
}

static void stand(AppDocument *trial, gsize light, gsize chosen)
{
    double center[3], old[3], place[3];
    char *text = app_document_get(trial, "surfaces[0].center", NULL);
    if (text && app_list_read(text, center, 3) == 3) {
        if (chosen != light && read_place(trial, APP_MARK_SOURCE, chosen, old)) {
            choose_place(center, old, place);
            give_way(trial, light, center, place);
            put(trial, light, place);
        } else if (read_place(trial, APP_MARK_SOURCE, light, place)) {
            for (int k = 0; k < 3; k++)
                place[k] += center[k] - EXAMPLE_CENTER_MM[k];
            put(trial, light, place);
        }
        aim(trial, light, text);
    }
    g_free(text);
}

/* A pattern that depends on the direction needs one. */
static void aim_pattern(AppDocument *trial, gsize light)
{
    gboolean written, axis, aimed;
    char *pattern = get(trial, light, "pattern", &written), *center = NULL;
    g_free(get(trial, light, "axis", &axis));
    g_free(get(trial, light, "aim", &aimed));
    if (written && strcmp(pattern, "isotropic") != 0 && !axis && !aimed)
        center = app_document_get(trial, "surfaces[0].center", NULL);
    if (center)
        set(trial, light, "aim", center);
    g_free(center);
    g_free(pattern);
}

/* ---- strength ---- */

/* The greatest direct irradiance that a source alone gives in view; 0 where it gives none, or that is not known. */
static double greatest_irradiance(const AppDocument *document, gsize light)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    luxel_scene *scene = app_document_copy_scene(document);
    if (scene)
        app_scene_leave_direct(scene);
    AppMoment *moment = app_moment_new(scene, 0, (gssize)light, faults);
    luxel_settings settings;
    luxel_field *field = NULL;
    unsigned columns, rows;
    double greatest = 0;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    if (moment)
        app_moment_light(moment, &settings);
    if (moment && luxel_scene_resolution(moment->scene, &columns, &rows) == LUXEL_OK) {
        settings.stride = MAX(MAX(columns, rows) / LOOK, 1);
        if (luxel_render(moment->scene, &settings, NULL, &field) == LUXEL_OK)
            greatest = luxel_field_statistics(field)->maximum.value;
    }
    luxel_field_free(field);
    app_moment_unref(moment);
    luxel_diagnostics_free(faults);
    return greatest;
}

/* The source gets `wanted` as its greatest irradiance, which is in proportion to its strength, in round numbers. */
static void become_as_strong(AppDocument *trial, gsize light, double wanted)
{
    static const char *const strengths[] = {"intensity", "radiance", "power", "irradiance"};
    const double given = greatest_irradiance(trial, light);
    if (!(given > 0) || !(wanted > 0))
        return;
    for (gsize i = 0; i < G_N_ELEMENTS(strengths); i++) {
        gboolean written;
        char number[APP_NUMBER_SIZE], *text = get(trial, light, strengths[i], &written);
        const double strength = text ? g_ascii_strtod(text, NULL) * wanted / given : 0;
        if (written && isfinite(strength) && strength > 0)
            set(trial, light, strengths[i], app_number_plain(strength, 2, number));
        g_free(text);
    }
}

/* ---- all of it ---- */

/* A source made from an example; `is_as_strong`: it gives as much light as the chosen one. */
static char *make(const AppDocument *document, const luxel_parameters *parameters, const char *example, gsize chosen,
                  gboolean is_as_strong)
{
    const gsize light = app_document_size(document, "lights");
    const gboolean is_like = chosen < light;
    AppDocument *trial = app_document_copy(document);
    const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "lights", .value = example, .index = light};
    char *key = g_strdup_printf("lights[%zu]", light), *yaml = NULL;
    if (app_document_edit(trial, &edit, 1, NULL, NULL)) {
        if (is_like)
            take_law(trial, parameters, chosen, light);
        stand(trial, light, is_like ? chosen : light);
        aim_pattern(trial, light);
        if (is_like && is_as_strong)
            become_as_strong(trial, light, greatest_irradiance(trial, chosen));
        yaml = app_document_get(trial, key, NULL);
    }
    g_object_unref(trial);
    g_free(key);
    return yaml;
}

char *app_new_source(const AppDocument *document, const luxel_parameters *parameters, const char *kind, gsize chosen)
{
    const luxel_parameter_kind *found = find_kind(parameters, kind);
    return found && found->example ? make(document, parameters, found->example, chosen, TRUE) : NULL;
}

char *app_new_luminaire(const AppDocument *document, const luxel_parameters *parameters, const char *file, gsize chosen)
{
    char *quoted = app_yaml_quote(file);
    char *example =
        g_strdup_printf("{type: luminaire, file: %s, position: [800, 500, 2500], aim: [0, 0, 1000]}", quoted);
    char *yaml = make(document, parameters, example, chosen, FALSE);
    g_free(example);
    g_free(quoted);
    return yaml;
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

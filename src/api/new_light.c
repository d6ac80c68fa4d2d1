/* SPDX-License-Identifier: MIT */
/*
 * New lights: one is put at the end of a copy of the scene, changed there key by key until it fits, and read off as
 * YAML.  How strong it should be is told by two pictures of the copy, by the light that it is like and by itself.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/field.h>
#include <luxel/light.h>
#include <luxel/render.h>

#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../base/text.h"
#include "../light/light.h"
#include "../parameter/decode.h"
#include "../scene/scene.h"

enum {
    LOOK = 48,  /* pixels across of the pictures that tell how strong lights are */
    PLACES = 8, /* around the surface */
    DIGITS = 2  /* of a strength */
};
static const double NEAR_MM = 1.0;                       /* within which two lights stand on each other */
static const double EXAMPLE_CENTER_MM[3] = {0, 0, 1000}; /* what examples shine at */

/* The copy; `light` is the new one, `like` the one that it is like, the same where there is none. */
struct trial {
    luxel_scene *scene;
    size_t light, like;
    bool replaces;
    luxel_status status; /* LUXEL_ERROR_MEMORY once that ran out, or LUXEL_OK */
};

/* ---- keys of lights ---- */

static char *path_of(struct trial *trial, size_t light, const char *name, const char *value)
{
    struct lx_text path = {0};
    lx_text_printf(&path, "lights[%zu].%s", light, name);
    if (value)
        lx_text_printf(&path, "=%s", value);
    char *text = lx_text_take(&path);
    if (!text)
        trial->status = LUXEL_ERROR_MEMORY;
    return text;
}

/* What a light writes of a key, the caller's; NULL: nothing. */
static char *get(struct trial *trial, size_t light, const char *name)
{
    char *path = path_of(trial, light, name, NULL), *value = NULL;
    bool is_written = false;
    if (path && luxel_scene_get(trial->scene, path, NULL, &is_written, &value) == LUXEL_ERROR_MEMORY)
        trial->status = LUXEL_ERROR_MEMORY;
    free(path);
    if (!is_written) {
        luxel_text_free(value);
        value = NULL;
    }
    return value;
}

static bool has(struct trial *trial, const char *name)
{
    char *value = get(trial, trial->light, name);
    luxel_text_free(value);
    return value != NULL;
}

/* A value that the key cannot have is left to luxel_scene_commit(). */
static void set(struct trial *trial, const char *name, const char *value)
{
    char *assignment = path_of(trial, trial->light, name, value);
    if (assignment && luxel_scene_set(trial->scene, assignment, NULL) == LUXEL_ERROR_MEMORY)
        trial->status = LUXEL_ERROR_MEMORY;
    free(assignment);
}

static void take_out(struct trial *trial, const char *name)
{
    char *path = path_of(trial, trial->light, name, NULL);
    if (path && luxel_scene_remove(trial->scene, path, NULL) == LUXEL_ERROR_MEMORY)
        trial->status = LUXEL_ERROR_MEMORY;
    free(path);
}

static const struct lx_variant *find_kind(const char *name)
{
    return name ? lx_find_variant(lx_find_parameter(&lx_scene_table, "lights"), name) : NULL;
}

static const struct lx_variant *kind_of(struct trial *trial, size_t light)
{
    char *type = get(trial, light, "type");
    const struct lx_variant *kind = find_kind(type);
    luxel_text_free(type);
    return kind;
}

static bool has_key(const struct lx_variant *kind, const char *name)
{
    return kind && lx_find_parameter(kind->table, name);
}

/* ---- numbers of a list in brackets ---- */

static bool read_vector(const char *text, double vector[3])
{
    size_t count = 0;
    if (!text || *text != '[')
        return false;
    for (const char *at = text + 1; count < 3; count++) {
        const size_t length = strcspn(at + strspn(at, " "), ",] ");
        at += strspn(at, " ");
        if (!lx_read_number(at, length, &vector[count]))
            return false;
        at += length;
        at += strspn(at, " ");
        if (*at != (count < 2 ? ',' : ']'))
            return false;
        at++;
    }
    return true;
}

static void set_vector(struct trial *trial, const char *name, const double vector[3])
{
    char numbers[3][LX_NUMBER_SIZE];
    struct lx_text list = {0};
    for (int k = 0; k < 3; k++)
        lx_write_number(vector[k], numbers[k]);
    lx_text_printf(&list, "[%s, %s, %s]", numbers[0], numbers[1], numbers[2]);
    char *text = lx_text_take(&list);
    if (text)
        set(trial, name, text);
    else
        trial->status = LUXEL_ERROR_MEMORY;
    free(text);
}

/* ---- what is taken over ---- */

/* From one light to the other, so far as both kinds have the key. */
static void carry(struct trial *trial, const struct lx_variant *from, const struct lx_variant *to, const char *name)
{
    if (!has_key(from, name) || !has_key(to, name))
        return;
    char *value = get(trial, trial->like, name);
    if (value)
        set(trial, name, value);
    else
        take_out(trial, name);
    luxel_text_free(value);
}

/* What decides how light goes out and becomes weaker. */
static void take_law(struct trial *trial)
{
    static const char *const of_law[] = {"attenuation", "k", "coefficients", "pattern"};
    const struct lx_variant *from = kind_of(trial, trial->like), *to = kind_of(trial, trial->light);
    for (size_t i = 0; i < LX_COUNT(of_law); i++)
        carry(trial, from, to, of_law[i]);
    /* an exponent belongs to a pattern, or, of spots, to the cone */
    if (has_key(from, "pattern") && has_key(to, "pattern"))
        carry(trial, from, to, "exponent");
    if (trial->replaces)
        carry(trial, from, to, "array");
}

/* What all kinds have. */
static void take_identity(struct trial *trial)
{
    static const char *const common[] = {"name", "enabled", "color"};
    for (size_t i = 0; i < LX_COUNT(common); i++) {
        char *value = get(trial, trial->like, common[i]);
        if (value)
            set(trial, common[i], value);
        luxel_text_free(value);
    }
}

/* ---- place and aim ---- */

/* The key that says where a light stands, if it does by three numbers; NULL: none. */
static const char *find_place(struct trial *trial, size_t light, double place_mm[3])
{
    static const char *const keys[] = {"position",   "rectangle.center", "disk.center",
                                       "box.center", "sphere.center",    "cylinder.center"};
    for (size_t i = 0; i < LX_COUNT(keys); i++) {
        char *text = get(trial, light, keys[i]);
        const bool is_place = read_vector(text, place_mm);
        luxel_text_free(text);
        if (is_place)
            return keys[i];
    }
    return NULL;
}

/* Where the light stands that the new one is like; of outlines and meshes the middle, if the scene has no errors. */
static bool find_like(struct trial *trial, double place_mm[3])
{
    if (trial->like == trial->light)
        return false;
    if (find_place(trial, trial->like, place_mm))
        return true;
    luxel_scene *copy = luxel_scene_copy(trial->scene);
    const bool is_there =
        copy && luxel_scene_commit(copy, NULL) == LUXEL_OK && luxel_scene_light_place(copy, trial->like, place_mm);
    for (int k = 0; k < 3 && is_there; k++)
        place_mm[k] = round(place_mm[k]);
    luxel_scene_free(copy);
    return is_there;
}

/* On the other side of the surface than the light that it is like; above it, beside it. */
static void choose_place(const double center[3], const double like[3], double place[3])
{
    const double aside[2] = {like[0] - center[0], like[1] - center[1]}, height = like[2] - center[2];
    memcpy(place, like, 3 * sizeof *place);
    if (hypot(aside[0], aside[1]) < 0.1 * fabs(height))
        place[0] = center[0] - round(fabs(height) / 20.0) * 10.0;
    else if (fabs(aside[0]) >= fabs(aside[1]))
        place[0] = center[0] - aside[0];
    else
        place[1] = center[1] - aside[1];
}

static bool is_taken(struct trial *trial, const double place[3])
{
    double other[3];
    for (size_t i = 0; i < trial->light; i++)
        if (find_place(trial, i, other) &&
            hypot(hypot(other[0] - place[0], other[1] - place[1]), other[2] - place[2]) < NEAR_MM)
            return true;
    return false;
}

/* Where a light stands already, the new one stands an eighth of a turn further around the surface, or another one. */
static void give_way(struct trial *trial, const double center[3], double place[3])
{
    const double aside[2] = {place[0] - center[0], place[1] - center[1]};
    for (int i = 1; i < PLACES && is_taken(trial, place); i++) {
        const double turn = 2.0 * 3.14159265358979323846 * i / PLACES;
        place[0] = round(center[0] + aside[0] * cos(turn) - aside[1] * sin(turn));
        place[1] = round(center[1] + aside[0] * sin(turn) + aside[1] * cos(turn));
    }
}

static void stand(struct trial *trial, const double center[3])
{
    double place[3];
    const bool is_near_another = find_like(trial, place);
    if (is_near_another && !trial->replaces) {
        double like[3];
        memcpy(like, place, sizeof like);
        choose_place(center, like, place);
        give_way(trial, center, place);
    }
    double example[3];
    const char *key = find_place(trial, trial->light, example);
    if (!key && is_near_another && has(trial, "direction")) {
        for (int k = 0; k < 3; k++)
            place[k] = center[k] - place[k];
        set_vector(trial, "direction", place);
    }
    for (int k = 0; k < 3 && !is_near_another; k++)
        place[k] = example[k] + center[k] - EXAMPLE_CENTER_MM[k];
    if (key)
        set_vector(trial, key, place);
}

/* At the middle of the first surface, or at what the light was aimed at that it replaces. */
static void aim(struct trial *trial, const double center[3])
{
    static const char *const aims[] = {"aim", "rectangle.aim", "disk.aim"};
    double target[3];
    memcpy(target, center, sizeof target);
    for (size_t i = 0; i < LX_COUNT(aims) && trial->replaces; i++) {
        char *text = get(trial, trial->like, aims[i]);
        const bool is_aimed = read_vector(text, target);
        luxel_text_free(text);
        if (is_aimed)
            break;
    }
    for (size_t i = 0; i < LX_COUNT(aims); i++)
        if (has(trial, aims[i]))
            set_vector(trial, aims[i], target);
    /* a pattern that depends on the direction needs one */
    char *pattern = get(trial, trial->light, "pattern");
    if (pattern && strcmp(pattern, "isotropic") != 0 && !has(trial, "axis") && !has(trial, "aim"))
        set_vector(trial, "aim", target);
    luxel_text_free(pattern);
}

/* ---- strength ---- */

/* The greatest direct irradiance that a light alone gives in view; 0 where it gives none, or that is not known. */
static double greatest_irradiance(const luxel_scene *scene, size_t light)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    unsigned columns, rows;
    double greatest = 0.0;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.lights = &light;
    settings.light_count = 1;
    if (luxel_scene_resolution(scene, &columns, &rows) == LUXEL_OK) {
        const unsigned most = columns > rows ? columns : rows;
        settings.stride = most > LOOK ? most / LOOK : 1;
        if (luxel_render(scene, &settings, NULL, &field) == LUXEL_OK)
            greatest = luxel_field_statistics(field)->maximum.value;
    }
    luxel_field_free(field);
    return greatest;
}

/* Makes the scene one of direct light alone, without the soft shadows that would take most of the time. */
static bool leave_direct(luxel_scene *scene)
{
    char *shadows = NULL;
    luxel_status status = luxel_scene_get(scene, "shadows", NULL, NULL, &shadows);
    if (status == LUXEL_OK && shadows && strcmp(shadows, "all") == 0)
        status = luxel_scene_set(scene, "shadows=points", NULL);
    luxel_text_free(shadows);
    return status == LUXEL_OK && luxel_scene_set(scene, "reflections=none", NULL) == LUXEL_OK;
}

/* By how much the new light is to become stronger; 0: not known. */
static double find_factor(struct trial *trial)
{
    luxel_scene *copy = luxel_scene_copy(trial->scene);
    double factor = 0.0;
    char *on = path_of(trial, trial->like, "enabled", "true"),
         *new_on = path_of(trial, trial->light, "enabled", "true");
    if (!copy || !on || !new_on)
        trial->status = LUXEL_ERROR_MEMORY;
    else if (leave_direct(copy) && luxel_scene_set(copy, on, NULL) == LUXEL_OK &&
             luxel_scene_set(copy, new_on, NULL) == LUXEL_OK && luxel_scene_commit(copy, NULL) == LUXEL_OK &&
             luxel_scene_check_view(copy, NULL) == LUXEL_OK) {
        const double given = greatest_irradiance(copy, trial->light);
        factor = given > 0.0 ? greatest_irradiance(copy, trial->like) / given : 0.0;
    }
    luxel_scene_free(copy);
    free(new_on);
    free(on);
    return factor;
}

/* The sky and the sun are as strong as they are, and pictures of them take seconds. */
static bool is_daylight(struct trial *trial, size_t light)
{
    const struct lx_variant *kind = kind_of(trial, light);
    return kind && ((const struct lx_light_kind *)kind)->is_daylight;
}

/* In round numbers. */
static void become_as_strong(struct trial *trial)
{
    static const char *const strengths[] = {"intensity", "radiance", "power", "irradiance"};
    if (is_daylight(trial, trial->light) || is_daylight(trial, trial->like))
        return;
    const double factor = find_factor(trial);
    for (size_t i = 0; i < LX_COUNT(strengths); i++) {
        double strength;
        char number[LX_NUMBER_SIZE], *text = get(trial, trial->light, strengths[i]);
        if (text && lx_read_number(text, strlen(text), &strength) && strength * factor > 0.0 &&
            isfinite(strength * factor)) {
            lx_write_digits(strength * factor, DIGITS, number);
            if (lx_read_number(number, strlen(number), &strength))
                set(trial, strengths[i], lx_write_number(strength, number));
        }
        luxel_text_free(text);
    }
}

/* ---- all of it ---- */

static void fit(struct trial *trial)
{
    double center[3];
    char *text = NULL;
    if (trial->like != trial->light)
        take_law(trial);
    if (trial->replaces)
        take_identity(trial);
    if (luxel_scene_get(trial->scene, "surfaces[0].center", NULL, NULL, &text) == LUXEL_OK &&
        read_vector(text, center)) {
        stand(trial, center);
        aim(trial, center);
    }
    luxel_text_free(text);
    if (trial->like != trial->light)
        become_as_strong(trial);
}

luxel_status luxel_new_light(const luxel_scene *scene, const char *wanted, size_t like, bool replaces,
                             luxel_diagnostics *diagnostics, char **yaml)
{
    if (!scene || !wanted || !yaml)
        return LUXEL_ERROR_ARGUMENT;
    *yaml = NULL;
    const struct lx_variant *kind = find_kind(wanted);
    const char *example = kind ? kind->example : wanted;
    if (!example || (!kind && *wanted != '{'))
        return LUXEL_ERROR_ARGUMENT;
    struct trial trial = {.scene = luxel_scene_copy(scene)};
    char *made = NULL;
    if (!trial.scene)
        return lx_out_of_memory(diagnostics);
    luxel_status status = luxel_scene_list_size(trial.scene, "lights", diagnostics, &trial.light);
    trial.like = like < trial.light ? like : trial.light;
    trial.replaces = replaces && trial.like != trial.light;
    if (status == LUXEL_OK)
        status = luxel_scene_insert(trial.scene, "lights", trial.light, example, diagnostics);
    if (status == LUXEL_OK) {
        struct lx_text path = {0};
        fit(&trial);
        lx_text_printf(&path, "lights[%zu]", trial.light);
        status = trial.status != LUXEL_OK || path.failed
                     ? lx_out_of_memory(diagnostics)
                     : luxel_scene_get(trial.scene, path.bytes, diagnostics, NULL, &made);
        lx_text_clear(&path);
    }
    luxel_scene_free(trial.scene);
    *yaml = made;
    return status;
}

/* SPDX-License-Identifier: MIT */
/* Rules of the parameter table, applied to the document. */
#include "rules.h"

#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../picture/marks.h"
#include "new_source.h"

/* ---- paths ---- */

char *app_keys_path(const AppKeys *keys, const luxel_parameter *parameter)
{
    const char *brackets = strstr(parameter->path, "[]");
    if (!brackets)
        return g_strdup(parameter->path);
    return g_strdup_printf("%.*s[%zu]%s", (int)(brackets - parameter->path), parameter->path, keys->index,
                           brackets + 2);
}

gboolean app_keys_has(const AppKeys *keys, const luxel_parameter *parameter)
{
    return !parameter->variant || g_strcmp0(parameter->variant, keys->type) == 0;
}

static gsize stem_length(const luxel_parameter *parameter)
{
    const char *dot = strrchr(parameter->path, '.');
    return dot ? (gsize)(dot - parameter->path) + 1 : 0;
}

static const char *name_of(const luxel_parameter *parameter)
{
    return parameter->path + stem_length(parameter);
}

/* The parameter with this path among those of the element. */
static const luxel_parameter *find(const AppKeys *keys, const char *path)
{
    for (gsize i = 0; i < luxel_parameters_count(keys->parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(keys->parameters, i);
        if (app_keys_has(keys, parameter) && strcmp(parameter->path, path) == 0)
            return parameter;
    }
    return NULL;
}

const luxel_parameter *app_keys_beside(const AppKeys *keys, const luxel_parameter *parameter, const char *name)
{
    char *path = g_strdup_printf("%.*s%s", (int)stem_length(parameter), parameter->path, name);
    const luxel_parameter *found = find(keys, path);
    g_free(path);
    return found;
}

/* The group that a parameter stands in, such as lights[].rectangle; NULL: none, or one that is always there. */
static const luxel_parameter *group_of(const AppKeys *keys, const luxel_parameter *parameter)
{
    const gsize stem = stem_length(parameter);
    char *path = g_strndup(parameter->path, stem > 0 ? stem - 1 : 0);
    const luxel_parameter *group = find(keys, path);
    g_free(path);
    return group && group->value_type == LUXEL_PARAMETER_GROUP ? group : NULL;
}

/* ---- what is shown ---- */

static char *value_of(const AppKeys *keys, const luxel_parameter *parameter, gboolean *written)
{
    char *path = app_keys_path(keys, parameter), *value = app_document_get(keys->document, path, written);
    g_free(path);
    return value;
}

static gboolean is_written(const AppKeys *keys, const luxel_parameter *parameter)
{
    gboolean written = FALSE;
    if (parameter)
        g_free(value_of(keys, parameter, &written));
    return written;
}

/* Whether a word stands in a list "a, b, c". */
static gboolean lists(const char *choices, const char *word)
{
    char **words = g_strsplit(choices, ", ", -1);
    gboolean found = g_strv_contains((const char *const *)words, word);
    g_strfreev(words);
    return found;
}

static gboolean other_is_chosen(const AppKeys *keys, const luxel_parameter *parameter, const luxel_parameter_rule *rule)
{
    const luxel_parameter *other = app_keys_beside(keys, parameter, rule->other);
    if (!rule->choices)
        return is_written(keys, other);
    char *value = other ? value_of(keys, other, NULL) : NULL;
    gboolean chosen = value && lists(rule->choices, value);
    g_free(value);
    return chosen;
}

/* Whether one of the keys of a rule is written, of which one must be. */
static gboolean any_written(const AppKeys *keys, const luxel_parameter *parameter, const char *choices)
{
    char **names = g_strsplit(choices, ", ", -1);
    gboolean any = FALSE;
    for (gsize i = 0; names[i] && !any; i++)
        any = is_written(keys, app_keys_beside(keys, parameter, names[i]));
    g_strfreev(names);
    return any;
}

/* Whether none of the keys of which one must be given is, and this is the first of them. */
static gboolean is_first_of_none(const AppKeys *keys, const luxel_parameter *parameter,
                                 const luxel_parameter_rule *rule)
{
    const char *name = name_of(parameter);
    const gsize length = strlen(name);
    return strncmp(rule->choices, name, length) == 0 && (!rule->choices[length] || rule->choices[length] == ',') &&
           !any_written(keys, parameter, rule->choices);
}

static gboolean rule_shows(const AppKeys *keys, const luxel_parameter *parameter, const luxel_parameter_rule *rule,
                           gboolean written)
{
    if (rule->kind == LUXEL_RULE_USED)
        return written || other_is_chosen(keys, parameter, rule);
    if (rule->kind == LUXEL_RULE_NEEDED && !rule->choices)
        return written || other_is_chosen(keys, parameter, rule);
    if (rule->kind == LUXEL_RULE_ONE_OF)
        return written || is_first_of_none(keys, parameter, rule);
    if (rule->kind == LUXEL_RULE_EXCLUDES && !written)
        return parameter->default_value && !is_written(keys, app_keys_beside(keys, parameter, rule->other));
    return TRUE;
}

/* Whether a word stands for a group, or nothing, instead of keys of its own. */
static gboolean is_word(const AppKeys *keys, const luxel_parameter *group)
{
    char *value = value_of(keys, group, NULL);
    const gboolean is_word = !value || value[0] != '{';
    g_free(value);
    return is_word;
}

/* Whether a parameter is a key right below a group. */
static gboolean is_in_group(const luxel_parameter *parameter, const luxel_parameter *group)
{
    const gsize stem = strlen(group->path);
    return strncmp(parameter->path, group->path, stem) == 0 && parameter->path[stem] == '.' &&
           !strchr(parameter->path + stem + 1, '.');
}

gboolean app_keys_is_optional(const AppKeys *keys, const luxel_parameter *group)
{
    if (group->value_type != LUXEL_PARAMETER_GROUP || group->required || group->choices || group->rule_count > 0)
        return FALSE;
    for (gsize i = 0; i < luxel_parameters_count(keys->parameters); i++) {
        const luxel_parameter *child = luxel_parameters_get(keys->parameters, i);
        if (child->required && is_in_group(child, group) && app_keys_has(keys, child))
            return TRUE;
    }
    return FALSE;
}

gboolean app_keys_is_shown(const AppKeys *keys, const luxel_parameter *parameter)
{
    if (!app_keys_has(keys, parameter))
        return FALSE;
    const gboolean written = is_written(keys, parameter);
    const luxel_parameter *group = group_of(keys, parameter);
    if (group && !app_keys_is_shown(keys, group))
        return FALSE;
    if (group && group->choices && !written && is_word(keys, group))
        return FALSE;
    if (group && !is_written(keys, group) && app_keys_is_optional(keys, group))
        return FALSE;
    for (gsize i = 0; i < parameter->rule_count; i++)
        if (!rule_shows(keys, parameter, &parameter->rules[i], written))
            return FALSE;
    return TRUE;
}

/* ---- edits ---- */

static void add_set(const AppKeys *keys, const luxel_parameter *parameter, const char *value, AppEdits *edits)
{
    char *path = app_keys_path(keys, parameter);
    app_edits_add(edits, APP_EDIT_SET, path, value, 0, 0);
    g_free(path);
}

/* A value to begin with where the table has no default: within the advised range, and round. */
static double first_number(const luxel_parameter *parameter, guint component)
{
    const luxel_parameter_range *advised = &parameter->advised_range[MIN(component, 2)];
    char text[APP_NUMBER_SIZE];
    if (!advised->given)
        return parameter->legal_range.given && parameter->legal_range.low_open ? 1 : 0;
    double middle = advised->low > 0 ? sqrt(advised->low * advised->high) : (advised->low + advised->high) / 2;
    return g_ascii_strtod(app_number_round(middle, 1, text), NULL);
}

/* The scene with these edits made (NULL: as it is), committed; the caller's.  NULL where it has faults. */
static luxel_scene *scene_with(const AppKeys *keys, const AppEdits *edits)
{
    luxel_scene *scene = NULL;
    AppDocument *trial = app_document_copy(keys->document);
    if (!edits || app_edits_make(edits, trial, NULL))
        scene = app_document_copy_scene(trial);
    if (scene && (luxel_scene_commit(scene, NULL) != LUXEL_OK || luxel_scene_check_view(scene, NULL) != LUXEL_OK))
        g_clear_pointer(&scene, luxel_scene_free);
    g_object_unref(trial);
    return scene;
}

/* Where a light stands now, whatever of it is written; else above the middle. */
static void place_of(const AppKeys *keys, double place[3])
{
    const double above[3] = {0, 0, 2000};
    char *path = app_place_key(keys->document, APP_MARK_SOURCE, keys->index);
    char *text = path && !g_str_has_suffix(path, ".vertices") ? app_document_get(keys->document, path, NULL) : NULL;
    const gboolean found = text && app_list_read(text, place, 3) == 3;
    g_free(text);
    g_free(path);
    if (found)
        return;
    memcpy(place, above, sizeof above);
    luxel_scene *scene = scene_with(keys, NULL); /* the middle of a polygon or mesh */
    if (scene && luxel_scene_light_place(scene, keys->index, place))
        for (int k = 0; k < 3; k++)
            place[k] = round(place[k] * 1e3) / 1e3;
    luxel_scene_free(scene);
}

/* What the example of such an element has; NULL where it has not. */
static char *example_value(const AppKeys *keys, const luxel_parameter *parameter)
{
    char *value = NULL;
    for (gsize i = 0; i < luxel_parameters_kind_count(keys->parameters) && !value; i++) {
        const luxel_parameter_kind *kind = luxel_parameters_kind(keys->parameters, i);
        const gsize length = strlen(kind->list);
        if (!kind->example || g_strcmp0(kind->name, keys->type) != 0 ||
            strncmp(parameter->path, kind->list, length) != 0 || parameter->path[length] != '[')
            continue;
        AppDocument *trial = app_document_copy(keys->document);
        const AppKeys first = {trial, keys->parameters, keys->type, 0};
        const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = kind->list, .value = kind->example};
        if (app_document_edit(trial, &edit, 1, NULL, NULL))
            value = value_of(&first, parameter, NULL);
        g_object_unref(trial);
    }
    return value;
}

static char *first_value(const AppKeys *keys, const luxel_parameter *parameter);

/* A group with its required keys. */
static char *first_group(const AppKeys *keys, const luxel_parameter *group)
{
    GString *text = g_string_new("{");
    for (gsize i = 0; i < luxel_parameters_count(keys->parameters); i++) {
        const luxel_parameter *child = luxel_parameters_get(keys->parameters, i);
        if (!app_keys_has(keys, child) || !child->required || !is_in_group(child, group))
            continue;
        char *value = first_value(keys, child);
        g_string_append_printf(text, "%s%s: %s", text->len > 1 ? ", " : "", name_of(child), value);
        g_free(value);
    }
    g_string_append_c(text, '}');
    return g_string_free(text, FALSE);
}

/* Four corners around the place of the light. */
static char *first_corners(const AppKeys *keys)
{
    double place[3];
    char text[3][APP_NUMBER_SIZE];
    GString *corners = g_string_new("[");
    place_of(keys, place);
    for (int i = 0; i < 4; i++)
        g_string_append_printf(
            corners, "%s[%s, %s, %s]", i ? ", " : "", app_number_write(place[0] + (i < 2 ? -100 : 100), text[0]),
            app_number_write(place[1] + (i == 1 || i == 2 ? 100 : -100), text[1]), app_number_write(place[2], text[2]));
    g_string_append_c(corners, ']');
    return g_string_free(corners, FALSE);
}

static char *first_value(const AppKeys *keys, const luxel_parameter *parameter)
{
    double numbers[3];
    const char *name = name_of(parameter);
    const gboolean is_list =
        parameter->value_type == LUXEL_PARAMETER_NUMBERS || parameter->value_type == LUXEL_PARAMETER_WHOLE_NUMBERS;
    if (parameter->default_value)
        return g_strdup(parameter->default_value);
    if (parameter->value_type == LUXEL_PARAMETER_GROUP)
        return first_group(keys, parameter);
    if (parameter->value_type == LUXEL_PARAMETER_TEXT)
        return g_strdup("\"\""); /* to be given: until then the row says that there is no such file */
    if (parameter->value_type == LUXEL_PARAMETER_VECTORS)
        return first_corners(keys);
    if (is_list && (strcmp(name, "center") == 0 || strcmp(name, "position") == 0)) {
        place_of(keys, numbers);
        return app_list_write(numbers, 3);
    }
    if (is_list && strcmp(name, "size") == 0)
        return app_list_write((double[]){200, 200, 200}, MIN(parameter->count, 3));
    if (parameter->value_type == LUXEL_PARAMETER_WHOLE_NUMBERS) /* of places in columns and rows */
        return g_strdup("[2, 2]");
    char *example = example_value(keys, parameter), text[APP_NUMBER_SIZE];
    if (example)
        return example;
    for (guint i = 0; i < MIN(parameter->count, 3); i++)
        numbers[i] = first_number(parameter, i);
    return is_list ? app_list_write(numbers, MIN(parameter->count, 3)) : g_strdup(app_number_write(numbers[0], text));
}

/* The keys that must be given once this one has that value. */
static void add_needed(const AppKeys *keys, const luxel_parameter *parameter, const char *yaml, AppEdits *edits)
{
    for (gsize i = 0; i < luxel_parameters_count(keys->parameters); i++) {
        const luxel_parameter *other = luxel_parameters_get(keys->parameters, i);
        if (!app_keys_has(keys, other) || app_keys_beside(keys, parameter, name_of(other)) != other ||
            is_written(keys, other))
            continue;
        for (gsize r = 0; r < other->rule_count; r++) {
            const luxel_parameter_rule *rule = &other->rules[r];
            if (rule->kind != LUXEL_RULE_NEEDED || strcmp(rule->other, name_of(parameter)) != 0 ||
                (rule->choices && !lists(rule->choices, yaml)))
                continue;
            char *value = first_value(keys, other);
            add_set(keys, other, value, edits);
            g_free(value);
        }
    }
}

/* Pixels stay square: a side follows the other, and the sides follow the number of pixels. */
static void add_square(const AppKeys *keys, const luxel_parameter *parameter, int component, double value,
                       AppEdits *edits)
{
    double pixels[2] = {1, 1}, width = app_document_get_number(keys->document, "screen.width");
    double height = app_document_get_number(keys->document, "screen.height");
    char *text = app_document_get(keys->document, "screen.resolution", NULL), number[APP_NUMBER_SIZE];
    app_list_read(text, pixels, 2);
    g_free(text);
    if (strcmp(parameter->path, "screen.width") == 0)
        app_edits_add(edits, APP_EDIT_SET, "screen.height", app_number_write(value * pixels[1] / pixels[0], number), 0,
                      0);
    else if (strcmp(parameter->path, "screen.height") == 0)
        app_edits_add(edits, APP_EDIT_SET, "screen.width", app_number_write(value * pixels[0] / pixels[1], number), 0,
                      0);
    else if (strcmp(parameter->path, "screen.resolution") == 0 && component >= 0 && width > 0 && height > 0) {
        /* the other number of pixels follows; what rounding leaves, the height takes */
        double other = component == 0 ? value * height / width : value * width / height;
        pixels[component] = value;
        pixels[1 - component] = MAX(1, round(other));
        char *both = app_list_write(pixels, 2);
        app_edits_add(edits, APP_EDIT_SET, "screen.resolution", both, 0, 0);
        app_edits_add(edits, APP_EDIT_SET, "screen.height", app_number_write(width * pixels[1] / pixels[0], number), 0,
                      0);
        g_free(both);
    }
}

/* One number of several: the rest stays. */
static void add_component(const AppKeys *keys, const luxel_parameter *parameter, int component, double value,
                          AppEdits *edits)
{
    double numbers[3] = {0};
    char *text = value_of(keys, parameter, NULL);
    app_list_read(text, numbers, 3);
    numbers[component] = value;
    char *list = app_list_write(numbers, MIN(parameter->count, 3));
    add_set(keys, parameter, list, edits);
    g_free(list);
    g_free(text);
}

/* ---- another type ---- */

/* Whether a key right below the element. */
static gboolean is_own_key(const luxel_parameter *parameter)
{
    const char *brackets = strstr(parameter->path, "[].");
    return brackets && !strchr(brackets + 3, '.');
}

/* Whether an element of this type must be given a key that the present one does not have. */
static gboolean must_be_given(const AppKeys *keys, const luxel_parameter *parameter)
{
    if (!is_own_key(parameter) || strcmp(name_of(parameter), "type") == 0)
        return FALSE;
    if (parameter->required)
        return !is_written(keys, parameter);
    for (gsize r = 0; r < parameter->rule_count; r++) {
        const luxel_parameter_rule *rule = &parameter->rules[r];
        if (rule->kind == LUXEL_RULE_ONE_OF && is_first_of_none(keys, parameter, rule))
            return TRUE;
    }
    return FALSE;
}

/* The element becomes one of another type: it keeps the keys that both have, and is given what the new one needs. */
static void change_type(const AppKeys *keys, const luxel_parameter *parameter, const char *type, AppEdits *edits)
{
    const char *list_end = strstr(parameter->path, "[].");
    const AppKeys after = {keys->document, keys->parameters, type, keys->index};
    const gsize stem = (gsize)(list_end - parameter->path) + 3;
    for (gsize i = 0; i < luxel_parameters_count(keys->parameters); i++) {
        const luxel_parameter *other = luxel_parameters_get(keys->parameters, i);
        if (strncmp(other->path, parameter->path, stem) == 0 && is_own_key(other) && app_keys_has(keys, other) &&
            !find(&after, other->path) && is_written(keys, other)) {
            char *path = app_keys_path(keys, other);
            app_edits_add(edits, APP_EDIT_REMOVE, path, NULL, 0, 0);
            g_free(path);
        }
    }
    add_set(keys, parameter, type, edits);
    for (gsize i = 0; i < luxel_parameters_count(keys->parameters); i++) {
        const luxel_parameter *other = luxel_parameters_get(keys->parameters, i);
        if (strncmp(other->path, parameter->path, stem) != 0 || !app_keys_has(&after, other) ||
            !must_be_given(&after, other))
            continue;
        char *value = first_value(&after, other);
        add_set(&after, other, value, edits);
        g_free(value);
    }
}

/* The light becomes one of another kind as the library makes it: it stands and shines where it did, and as much. */
static gboolean change_light(const AppKeys *keys, const luxel_parameter *parameter, const char *type, AppEdits *edits)
{
    char *yaml = app_changed_source(keys->document, type, keys->index);
    AppDocument *trial = app_document_copy(keys->document);
    const AppKeys made = {trial, keys->parameters, type, app_document_size(trial, "lights")};
    const AppEdit insert = {.kind = APP_EDIT_INSERT, .key = "lights", .value = yaml, .index = made.index};
    const gboolean is_made = yaml && app_document_edit(trial, &insert, 1, NULL, NULL);
    for (int sets = 0; sets < 2 && is_made; sets++) { /* what it no longer has goes first */
        const AppKeys *of = sets ? &made : keys;
        if (sets)
            add_set(keys, parameter, type, edits);
        for (gsize i = 0; i < luxel_parameters_count(keys->parameters); i++) {
            const luxel_parameter *other = luxel_parameters_get(keys->parameters, i);
            if (!g_str_has_prefix(other->path, "lights[].") || !is_own_key(other) || !app_keys_has(of, other) ||
                strcmp(name_of(other), "type") == 0 || !is_written(of, other))
                continue;
            const luxel_parameter *same = sets ? other : find(&made, other->path);
            char *path = app_keys_path(keys, other);
            if (sets) {
                char *value = value_of(&made, other, NULL);
                app_edits_add(edits, APP_EDIT_SET, path, value, 0, 0);
                g_free(value);
            } else if (!same || !is_written(&made, same)) {
                app_edits_add(edits, APP_EDIT_REMOVE, path, NULL, 0, 0);
            }
            g_free(path);
        }
    }
    g_object_unref(trial);
    g_free(yaml);
    return is_made;
}

void app_keys_set(const AppKeys *keys, const luxel_parameter *parameter, int component, const char *yaml,
                  AppEdits *edits)
{
    const double value = g_ascii_strtod(yaml, NULL);
    if (keys->type && is_own_key(parameter) && strcmp(name_of(parameter), "type") == 0) {
        if (!g_str_has_prefix(parameter->path, "lights[].") || !change_light(keys, parameter, yaml, edits))
            change_type(keys, parameter, yaml, edits);
        return;
    }
    if (parameter->value_type == LUXEL_PARAMETER_GROUP && strcmp(yaml, "true") == 0) {
        char *group = first_group(keys, parameter);
        add_set(keys, parameter, group, edits);
        g_free(group);
    } else if (component >= 0)
        add_component(keys, parameter, component, value, edits);
    else
        add_set(keys, parameter, yaml, edits);
    add_needed(keys, parameter, yaml, edits);
    add_square(keys, parameter, component, value, edits);
}

/* ---- one key instead of another ---- */

GPtrArray *app_keys_instead(const AppKeys *keys, const luxel_parameter *parameter)
{
    GPtrArray *names = g_ptr_array_new_with_free_func(g_free);
    for (gsize i = 0; i < parameter->rule_count; i++) {
        const luxel_parameter_rule *rule = &parameter->rules[i];
        if (rule->kind == LUXEL_RULE_EXCLUDES && app_keys_beside(keys, parameter, rule->other))
            g_ptr_array_add(names, g_strdup(rule->other));
        if (rule->kind != LUXEL_RULE_ONE_OF)
            continue;
        char **choices = g_strsplit(rule->choices, ", ", -1);
        for (gsize k = 0; choices[k]; k++) {
            const luxel_parameter *other = app_keys_beside(keys, parameter, choices[k]);
            /* a file cannot be guessed */
            if (other && other != parameter && other->value_type != LUXEL_PARAMETER_TEXT)
                g_ptr_array_add(names, g_strdup(choices[k]));
        }
        g_strfreev(choices);
    }
    return names;
}

static gboolean is_strength(const luxel_parameter *parameter)
{
    static const char *const names[] = {"intensity", "radiance", "power", NULL};
    return g_strv_contains(names, name_of(parameter));
}

/* The flux of a light of a scene with these edits made; NaN where it has none. */
static double flux_with(const AppKeys *keys, const AppEdits *edits)
{
    double flux = (double)NAN;
    luxel_scene *scene = scene_with(keys, edits);
    if (scene && luxel_scene_light_flux(scene, keys->index, &flux) != LUXEL_OK)
        flux = (double)NAN;
    luxel_scene_free(scene);
    return flux;
}

static void add_switch(const AppKeys *keys, const luxel_parameter *from, const luxel_parameter *to, const char *value,
                       AppEdits *edits)
{
    char *path = app_keys_path(keys, from);
    app_edits_add(edits, APP_EDIT_REMOVE, path, NULL, 0, 0);
    add_set(keys, to, value, edits);
    g_free(path);
}

/* A strength of the same flux, which is in proportion to each of them; NULL where that is not known. */
static char *strength_of_same_flux(const AppKeys *keys, const luxel_parameter *from, const luxel_parameter *to)
{
    char text[APP_NUMBER_SIZE];
    AppEdits *one = app_edits_new();
    add_switch(keys, from, to, "1", one);
    const double value = flux_with(keys, NULL) / flux_with(keys, one);
    app_edits_free(one);
    if (!isfinite(value))
        return NULL;
    /* a round number where there is one, such as after the way back */
    for (int digits = 6; digits <= 12; digits++)
        if (fabs(g_ascii_strtod(app_number_round(value, digits, text), NULL) - value) <= 1e-11 * value)
            break;
    return g_strdup(text);
}

/* The axis of the light's direction, or a place a metre along it; NULL where it has none. */
static char *aim_of_same_direction(const AppKeys *keys, const luxel_parameter *to)
{
    static const double AHEAD_MM = 1000;
    double direction[3], place[3];
    char *value = NULL, text[APP_NUMBER_SIZE];
    luxel_scene *scene = scene_with(keys, NULL);
    if (scene && luxel_scene_light_direction(scene, keys->index, direction) &&
        luxel_scene_light_place(scene, keys->index, place)) {
        const gboolean is_place = strcmp(name_of(to), "aim") == 0;
        for (int k = 0; k < 3; k++) {
            const double number = is_place ? place[k] + AHEAD_MM * direction[k] : direction[k];
            direction[k] = g_ascii_strtod(app_number_round(round(number * 1e6) / 1e6, 9, text), NULL);
        }
        value = app_list_write(direction, 3);
    }
    luxel_scene_free(scene);
    return value;
}

static gboolean is_aim(const luxel_parameter *parameter)
{
    return strcmp(name_of(parameter), "aim") == 0 || strcmp(name_of(parameter), "axis") == 0;
}

void app_keys_switch(const AppKeys *keys, const luxel_parameter *from, const luxel_parameter *to, AppEdits *edits)
{
    char *value = is_strength(from) && is_strength(to) ? strength_of_same_flux(keys, from, to)
                  : is_aim(from) && is_aim(to)         ? aim_of_same_direction(keys, to)
                                                       : NULL;
    if (!value)
        value = first_value(keys, to);
    add_switch(keys, from, to, value, edits);
    g_free(value);
}

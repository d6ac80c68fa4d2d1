/* SPDX-License-Identifier: MIT */
/*
 * The conventions of a scene: every choice of its tables that has an effect, such as the projection, the
 * sampling and the highlight's model, or those of them that had a say in a result.
 */
#include <luxel/conventions.h>
#include <luxel/probe.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/text.h"
#include "materials.h"
#include "object.h"

/* Which results a part of the scene has a say in. */
enum purpose { ANY_RESULT, OF_SCREEN, OF_PIXELS, OF_RANGE, OF_ROUNDING, OF_BRIGHTNESS };

struct collecting {
    const luxel_conventions_use *use; /* NULL: all */
    bool skips_materials;             /* of a surface that had no say, or whose parts have their own */
    luxel_convention *list;           /* whose values are its own */
    size_t count, capacity;
};

/* Whether `word` is one of the words joined by ", ". */
static bool holds(const char *words, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = words; at; at = strstr(at, ", ")) {
        at += at[0] == ',' ? 2 : 0;
        if (strncmp(at, word, length) == 0 && (at[length] == ',' || !at[length]))
            return true;
    }
    return false;
}

/* Adds a word to the convention with this key, once. */
static int add(struct collecting *all, const char *key, const char *word)
{
    luxel_convention *found = NULL;
    for (size_t i = 0; i < all->count && !found; i++)
        if (strcmp(all->list[i].key, key) == 0)
            found = &all->list[i];
    if (found && holds(found->value, word))
        return 0;
    struct lx_text text = {0};
    if (found) {
        lx_text_puts(&text, found->value);
        lx_text_puts(&text, ", ");
    }
    lx_text_puts(&text, word);
    char *value = lx_text_take(&text);
    if (!value)
        return -1;
    if (found) {
        free((char *)found->value);
        found->value = value;
        return 0;
    }
    if (lx_reserve((void **)&all->list, &all->capacity, all->count + 1, sizeof *all->list) < 0) {
        free(value);
        return -1;
    }
    all->list[all->count++] = (luxel_convention){key, value};
    return 0;
}

static bool has_effect(const struct lx_table *table, const struct lx_parameter *parameter, const void *parameters)
{
    for (size_t i = 0; i < table->rule_count; i++)
        if (table->rules[i].kind == LX_RULE_USED && strcmp(table->rules[i].key, parameter->name) == 0 &&
            !lx_rule_applies(&table->rules[i], table, parameters))
            return false;
    return true;
}

static bool matters(const luxel_conventions_use *use, enum purpose purpose)
{
    if (!use)
        return true;
    switch (purpose) {
    case OF_SCREEN: return use->screen;
    case OF_PIXELS: return use->pixels;
    case OF_RANGE: return use->range;
    case OF_ROUNDING: return use->rounding;
    case OF_BRIGHTNESS: return use->brightness;
    case ANY_RESULT: break;
    }
    return true;
}

/* The purpose of a key: its own, or that of the part of the scene in which it stands. */
static enum purpose purpose_of(const struct lx_parameter *parameter, enum purpose of_table)
{
    static const struct {
        const char *name;
        enum purpose purpose;
    } known[] = {{"screen", OF_PIXELS},   {"projection", OF_SCREEN},   {"surfaces", OF_SCREEN},
                 {"view", OF_BRIGHTNESS}, {"material", OF_BRIGHTNESS}, {"materials", OF_BRIGHTNESS},
                 {"range", OF_RANGE},     {"rounding", OF_ROUNDING}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (parameter->name[0] == known[i].name[0] && strcmp(parameter->name, known[i].name) == 0)
            return known[i].purpose;
    return of_table;
}

static int collect_table(struct collecting *all, const struct lx_table *table, const void *parameters, bool booleans,
                         enum purpose purpose);

static int collect_list(struct collecting *all, const struct lx_parameter *parameter, const struct lx_list *list,
                        enum purpose purpose)
{
    const bool *which = all->use && purpose == OF_SCREEN ? all->use->surfaces : NULL;
    int result = 0;
    for (size_t i = 0; i < list->count && result == 0; i++) {
        const struct lx_item *item = &list->items[i];
        /* a light that is off decides nothing */
        const struct lx_parameter *enabled = lx_find_parameter(parameter->group, "enabled");
        if (enabled && !*(const bool *)lx_const_member(enabled, item->common))
            continue;
        const bool is_used = !which || which[i], is_surface = purpose == OF_SCREEN;
        all->skips_materials = !is_used;
        result = collect_table(all, item->variant->table, item->parameters, !is_surface, purpose);
        all->skips_materials = is_surface && !lx_uses_own_material(item);
        if (result == 0 && is_used)
            result = collect_table(all, parameter->group, item->common, false, purpose);
    }
    return result;
}

/* The view of a result of which some, or all, was seen from a direction of its own. */
static int add_view(struct collecting *all, const struct lx_parameter *parameter, const void *parameters)
{
    const luxel_conventions_use *use = all->use;
    char words[3 * LX_NUMBER_SIZE + 8], x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE], z[LX_NUMBER_SIZE];
    if (!use || !use->only_view)
        if (add(all, parameter->name, lx_chosen(parameter, parameters)) < 0)
            return -1;
    if (!use || !use->has_view)
        return 0;
    snprintf(words, sizeof words, "[%s, %s, %s]", lx_write_number(use->view[0], x), lx_write_number(use->view[1], y),
             lx_write_number(use->view[2], z));
    return add(all, parameter->name, words);
}

enum { WORD_SIZE = 2 * LX_NUMBER_SIZE + 8 };

/* What a key that is no group or list says of how things are computed; NULL: nothing. */
static const char *word_of_value(const struct lx_parameter *parameter, const void *parameters, bool booleans,
                                 char buffer[WORD_SIZE])
{
    const void *value = lx_const_member(parameter, parameters);
    const struct lx_choice_or_pair *pair = value;
    const struct lx_choice_or_whole *whole = value;
    char low[LX_NUMBER_SIZE], high[LX_NUMBER_SIZE];
    if (parameter->type == LX_CHOICE)
        return lx_chosen(parameter, parameters);
    if (parameter->type == LX_CHOICE_OR_PAIR && pair->choice < 0) {
        snprintf(buffer, WORD_SIZE, "[%s, %s]", lx_write_number(pair->low, low), lx_write_number(pair->high, high));
        return buffer;
    }
    if (parameter->type == LX_CHOICE_OR_PAIR)
        return parameter->choices[pair->choice];
    if (parameter->type == LX_CHOICE_OR_WHOLE)
        return whole->choice < 0 ? lx_write_number(whole->whole, buffer) : parameter->choices[whole->choice];
    if (strcmp(parameter->name, "maintenance_factor") == 0)
        return lx_write_number(*(const double *)value, buffer);
    if (parameter->type == LX_BOOLEAN && (booleans || strcmp(parameter->name, "mirror") == 0))
        return *(const bool *)value ? "true" : "false";
    return NULL;
}

/* Direct light alone, sources as their files say, rooms that stand upright, Lambert's law and no mirrors are no
 * conventions. */
static bool goes_without_saying(const struct lx_parameter *parameter, const char *word)
{
    static const char *const names[] = {"channels", "reflections",   "maintenance_factor",
                                        "up",       "diffuse_model", "mirror"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(parameter->name, names[i]) == 0)
            return strcmp(word, parameter->initial) == 0;
    return false;
}

static int collect_value(struct collecting *all, const struct lx_parameter *parameter, const void *parameters,
                         bool booleans)
{
    char buffer[WORD_SIZE];
    if (strcmp(parameter->name, "view") == 0)
        return add_view(all, parameter, parameters);
    const char *word = word_of_value(parameter, parameters, booleans, buffer);
    return !word || goes_without_saying(parameter, word) ? 0 : add(all, parameter->name, word);
}

/* Whether a group is the material of nothing: of a wall that has none of its own, or where materials do not count. */
static bool is_no_material(const struct collecting *all, const struct lx_table *table,
                           const struct lx_parameter *parameter, const void *parameters)
{
    if (parameter->type != LX_GROUP || parameter->group != &lx_material_table)
        return false;
    const bool is_of_part = strcmp(parameter->name, "material") != 0;
    return all->skips_materials || (is_of_part && !lx_is_given(table, parameters, parameter->name));
}

/* A group that may be a word: that, or the key that says of which kind it is. */
static const char *word_of_group(const struct lx_parameter *parameter, const void *value)
{
    const struct lx_worded *worded = value;
    const struct lx_table *group = parameter->group;
    for (size_t i = 0; worded->word < 0 && i < group->count; i++)
        if (lx_is_given(group, value, group->parameters[i].name))
            return group->parameters[i].name;
    return parameter->choices[worded->word < 0 ? 0 : worded->word];
}

/* `booleans`: whether truth values of this table decide how things are computed, and not what there is. */
static int collect_table(struct collecting *all, const struct lx_table *table, const void *parameters, bool booleans,
                         enum purpose purpose)
{
    int result = 0;
    for (size_t i = 0; i < table->count && result == 0; i++) {
        const struct lx_parameter *parameter = &table->parameters[i];
        const void *value = lx_const_member(parameter, parameters);
        const enum purpose of_key = purpose_of(parameter, purpose);
        if (!has_effect(table, parameter, parameters) || is_no_material(all, table, parameter, parameters))
            continue;
        if (parameter->type == LX_GROUP && parameter->choices && matters(all->use, of_key))
            result = add(all, parameter->name, word_of_group(parameter, value));
        else if (parameter->type == LX_GROUP)
            result = collect_table(all, parameter->group, value, true, of_key);
        else if (parameter->type == LX_VARIANTS)
            result = collect_list(all, parameter, value, of_key);
        else if (matters(all->use, of_key))
            result = collect_value(all, parameter, parameters, booleans);
    }
    return result;
}

/* "windows 0.3" */
static int collect_dimming(struct collecting *all, const struct lx_scene_parameters *scene)
{
    int failed = 0;
    for (size_t i = 0; i < scene->dimming.count && !failed; i++) {
        const struct lx_dimming *dimming = (const struct lx_dimming *)scene->dimming.items + i;
        struct lx_text word = {0};
        char number[LX_NUMBER_SIZE];
        lx_text_add_escaped(&word, dimming->name, strlen(dimming->name));
        lx_text_puts(&word, " ");
        lx_text_puts(&word, lx_write_number(dimming->factor, number));
        failed = word.failed ? -1 : add(all, "dimming", word.bytes);
        lx_text_clear(&word);
    }
    return failed;
}

void luxel_conventions_free(luxel_conventions *conventions)
{
    if (!conventions)
        return;
    for (size_t i = 0; i < conventions->count; i++)
        free((char *)conventions->list[i].value);
    free((luxel_convention *)conventions->list);
    free(conventions);
}

luxel_status luxel_find_conventions(const luxel_scene *scene, const luxel_conventions_use *use,
                                    luxel_conventions **conventions)
{
    if (!conventions || !scene || !luxel_scene_is_committed(scene) || (use && LX_CHECK_RESERVE(use, NULL) != LUXEL_OK))
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    luxel_conventions_use used = use ? *use : (luxel_conventions_use){.screen = false};
    /* in perspective the projection decides the view */
    used.screen =
        used.screen || (used.brightness && !used.only_view && parameters->observer.projection == LX_PERSPECTIVE);
    struct collecting all = {.use = use ? &used : NULL};
    luxel_conventions *made = lx_new_array(1, sizeof *made);
    if (!made)
        return LUXEL_ERROR_MEMORY;
    const int failed =
        collect_table(&all, &lx_scene_table, parameters, true, ANY_RESULT) || collect_dimming(&all, parameters);
    *made = (luxel_conventions){all.count, all.list};
    if (failed) {
        luxel_conventions_free(made);
        return LUXEL_ERROR_MEMORY;
    }
    *conventions = made;
    return LUXEL_OK;
}

const char *lx_quantity_word(luxel_quantity quantity, bool photometric)
{
    if (quantity == LUXEL_IRRADIANCE)
        return photometric ? LX_N("illuminance") : LX_N("irradiance");
    return photometric ? LX_N("luminance") : LX_N("brightness");
}

const char *lx_by_quantity(luxel_quantity quantity, bool photometric, const char *const sentences[4])
{
    return sentences[(quantity == LUXEL_IRRADIANCE ? 2 : 0) + photometric];
}

const char *luxel_scene_quantity_word(const luxel_scene *scene, luxel_quantity quantity)
{
    bool is_ready = scene && luxel_scene_is_committed(scene);
    return lx_quantity_word(quantity, is_ready && lx_scene_parameters(scene)->units == LX_PHOTOMETRIC);
}

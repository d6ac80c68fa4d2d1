/* SPDX-License-Identifier: MIT */
/*
 * The conventions of a scene: every choice of its tables that has an effect, such as the projection, the
 * sampling and the highlight's model.  Two people whose numbers differ will find the reason among them.
 */
#include <luxel/probe.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/text.h"
#include "object.h"

void lx_clear_conventions(luxel_scene *scene)
{
    for (size_t i = 0; i < scene->convention_count; i++)
        free(scene->conventions[i].value);
    free(scene->conventions);
    scene->conventions = NULL;
    scene->convention_count = scene->convention_capacity = 0;
}

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
static int add(luxel_scene *scene, const char *key, const char *word)
{
    struct lx_convention *found = NULL;
    for (size_t i = 0; i < scene->convention_count && !found; i++)
        if (strcmp(scene->conventions[i].key, key) == 0)
            found = &scene->conventions[i];
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
        free(found->value);
        found->value = value;
        return 0;
    }
    if (lx_reserve((void **)&scene->conventions, &scene->convention_capacity, scene->convention_count + 1,
                   sizeof *scene->conventions) < 0) {
        free(value);
        return -1;
    }
    scene->conventions[scene->convention_count++] = (struct lx_convention){key, value};
    return 0;
}

static int add_choice_or_pair(luxel_scene *scene, const struct lx_parameter *parameter,
                              const struct lx_choice_or_pair *value)
{
    if (value->choice >= 0)
        return add(scene, parameter->name, parameter->choices[value->choice]);
    char words[2 * LX_NUMBER_SIZE + 8], low[LX_NUMBER_SIZE], high[LX_NUMBER_SIZE];
    snprintf(words, sizeof words, "[%s, %s]", lx_write_number(value->low, low), lx_write_number(value->high, high));
    return add(scene, parameter->name, words);
}

static int add_choice_or_whole(luxel_scene *scene, const struct lx_parameter *parameter,
                               const struct lx_choice_or_whole *value)
{
    if (value->choice >= 0)
        return add(scene, parameter->name, parameter->choices[value->choice]);
    char number[LX_NUMBER_SIZE];
    return add(scene, parameter->name, lx_write_number(value->whole, number));
}

static bool has_effect(const struct lx_table *table, const struct lx_parameter *parameter, const void *parameters)
{
    for (size_t i = 0; i < table->rule_count; i++)
        if (table->rules[i].kind == LX_RULE_USED && strcmp(table->rules[i].key, parameter->name) == 0 &&
            !lx_rule_applies(&table->rules[i], table, parameters))
            return false;
    return true;
}

static int collect_table(luxel_scene *scene, const struct lx_table *table, const void *parameters, bool booleans);

static int collect_list(luxel_scene *scene, const struct lx_parameter *parameter, const struct lx_list *list)
{
    int result = 0;
    for (size_t i = 0; i < list->count && result == 0; i++) {
        const struct lx_item *item = &list->items[i];
        /* a light that is off decides nothing */
        const struct lx_parameter *enabled = lx_find_parameter(parameter->group, "enabled");
        if (enabled && !*(const bool *)lx_const_member(enabled, item->common))
            continue;
        result = collect_table(scene, item->variant->table, item->parameters, true);
        if (result == 0)
            result = collect_table(scene, parameter->group, item->common, false);
    }
    return result;
}

/* `booleans`: whether truth values of this table decide how things are computed, and not what there is. */
static int collect_table(luxel_scene *scene, const struct lx_table *table, const void *parameters, bool booleans)
{
    int result = 0;
    for (size_t i = 0; i < table->count && result == 0; i++) {
        const struct lx_parameter *parameter = &table->parameters[i];
        const void *value = lx_const_member(parameter, parameters);
        if (!has_effect(table, parameter, parameters))
            continue;
        if (parameter->type == LX_CHOICE)
            result = add(scene, parameter->name, lx_chosen(parameter, parameters));
        else if (parameter->type == LX_CHOICE_OR_PAIR)
            result = add_choice_or_pair(scene, parameter, value);
        else if (parameter->type == LX_CHOICE_OR_WHOLE)
            result = add_choice_or_whole(scene, parameter, value);
        else if (parameter->type == LX_BOOLEAN && booleans)
            result = add(scene, parameter->name, *(const bool *)value ? "true" : "false");
        else if (parameter->type == LX_GROUP)
            result = collect_table(scene, parameter->group, value, true);
        else if (parameter->type == LX_VARIANTS)
            result = collect_list(scene, parameter, value);
    }
    return result;
}

int lx_collect_conventions(luxel_scene *scene)
{
    return collect_table(scene, &lx_scene_table, &scene->parameters, true);
}

const char *lx_quantity_word(luxel_quantity quantity, bool photometric)
{
    if (quantity == LUXEL_IRRADIANCE)
        return photometric ? LX_N("illuminance") : LX_N("irradiance");
    return photometric ? LX_N("luminance") : LX_N("brightness");
}

const char *luxel_scene_quantity_word(const luxel_scene *scene, luxel_quantity quantity)
{
    bool is_ready = scene && luxel_scene_is_committed(scene);
    return lx_quantity_word(quantity, is_ready && lx_scene_parameters(scene)->units == LX_PHOTOMETRIC);
}

/* SPDX-License-Identifier: MIT */
/* The flat list of all parameters, made by walking the tables once. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/phrase.h"
#include "any.h"
#include "decode.h"
#include "reflect.h"
#include "words.h"

static void free_rules(struct lx_reflected *item)
{
    for (size_t i = 0; i < item->shown.rule_count; i++)
        free((char *)item->rules[i].choices);
    free(item->rules);
}

void lx_reflection_clear(struct lx_parameter_reflection *reflection)
{
    for (size_t i = 0; i < reflection->count; i++) {
        struct lx_reflected *item = &reflection->items[i];
        free(item->path);
        free(item->choices);
        free_rules(item);
    }
    for (size_t i = 0; i < reflection->word_count; i++)
        free(reflection->words[i]);
    free(reflection->words);
    free(reflection->items);
    free(reflection->kinds);
    *reflection = (struct lx_parameter_reflection){0};
}

/* Words of the tables in the reflection's language, kept by it; NULL where out of memory. */
static const char *keep_words(struct lx_parameter_reflection *reflection, struct lx_text *words)
{
    char *text = lx_text_render(words, reflection->translate, reflection->data);
    if (!text || lx_reserve(&reflection->words, &reflection->word_capacity, reflection->word_count + 1,
                            sizeof *reflection->words) < 0) {
        free(text);
        return NULL;
    }
    return reflection->words[reflection->word_count++] = text;
}

static const char *keep_phrase(struct lx_parameter_reflection *reflection, const char *english)
{
    struct lx_text text = {0};
    lx_add_phrase(&text, english, NULL);
    return keep_words(reflection, &text);
}

static luxel_parameter_range interval_of(const struct lx_interval *range)
{
    if (!range->given)
        return (luxel_parameter_range){.low = -HUGE_VAL, .high = HUGE_VAL};
    return (luxel_parameter_range){.given = true, .low = range->low, .high = range->high, .low_open = range->low_open};
}

/* How many numbers one value consists of, or one element of a list of points. */
static unsigned count_numbers(const struct lx_parameter *parameter)
{
    switch (parameter->type) {
    case LX_REALS:
    case LX_WHOLES: return parameter->count;
    case LX_CHOICE_OR_PAIR:
    case LX_POINTS: return 2;
    case LX_VECTORS: return 3;
    default: return 1;
    }
}

/* What a form needs beside words. */
static void measure(const struct lx_parameter *parameter, luxel_parameter *shown)
{
    static const luxel_parameter_type types[] = {
        [LX_REAL] = LUXEL_PARAMETER_NUMBER,
        [LX_WHOLE] = LUXEL_PARAMETER_WHOLE_NUMBER,
        [LX_BOOLEAN] = LUXEL_PARAMETER_YES_OR_NO,
        [LX_CHOICE] = LUXEL_PARAMETER_CHOICE,
        [LX_TEXT] = LUXEL_PARAMETER_TEXT,
        [LX_REALS] = LUXEL_PARAMETER_NUMBERS,
        [LX_WHOLES] = LUXEL_PARAMETER_WHOLE_NUMBERS,
        [LX_CHOICE_OR_PAIR] = LUXEL_PARAMETER_CHOICE_OR_PAIR,
        [LX_GROUP] = LUXEL_PARAMETER_GROUP,
        [LX_POINTS] = LUXEL_PARAMETER_POINTS,
        [LX_VECTORS] = LUXEL_PARAMETER_VECTORS,
        [LX_CHOICE_OR_WHOLE] = LUXEL_PARAMETER_CHOICE_OR_WHOLE,
        [LX_GROUPS] = LUXEL_PARAMETER_GROUPS,
        [LX_VARIANTS] = LUXEL_PARAMETER_VARIANTS,
        [LX_ANY] = LUXEL_PARAMETER_ANY,
    };
    bool by_component = parameter->advised[1].given;
    shown->value_type = types[parameter->type];
    shown->count = count_numbers(parameter);
    shown->legal_range = interval_of(&parameter->legal);
    for (size_t i = 0; i < LX_COMPONENTS; i++)
        shown->advised_range[i] = interval_of(&parameter->advised[by_component ? i : 0]);
}

/* A parameter in words; false where out of memory. */
static bool describe(struct lx_parameter_reflection *reflection, const struct lx_parameter *parameter,
                     luxel_parameter *shown)
{
    const char *unit = lx_unit_word(parameter->unit, false);
    struct lx_text type = {0}, legal = {0}, advised = {0};
    lx_add_type(&type, parameter);
    lx_add_range(&legal, &parameter->legal, unit);
    if (parameter->advised[0].given)
        lx_add_advised(&advised, parameter, unit);
    shown->type = keep_words(reflection, &type);
    shown->legal = keep_words(reflection, &legal);
    shown->advised = keep_words(reflection, &advised);
    shown->unit = keep_phrase(reflection, unit);
    shown->photometric_unit = keep_phrase(reflection, lx_unit_word(parameter->unit, true));
    shown->label = keep_phrase(reflection, parameter->label);
    shown->meaning = keep_phrase(reflection, parameter->meaning);
    bool whole = shown->type && shown->legal && shown->advised && shown->unit && shown->photometric_unit &&
                 shown->label && shown->meaning;
    if (!parameter->legal.given)
        shown->legal = NULL;
    if (!parameter->advised[0].given)
        shown->advised = NULL;
    return whole;
}

/* A rule of a table as the key `key` sees it; false where it says nothing about that key. */
static bool see_rule(const struct lx_rule *rule, const char *key, luxel_parameter_rule *seen)
{
    static const luxel_parameter_rule_kind kinds[] = {
        [LX_RULE_EXCLUSIVE] = LUXEL_RULE_EXCLUDES, [LX_RULE_NEEDED] = LUXEL_RULE_NEEDED,
        [LX_RULE_USED] = LUXEL_RULE_USED,          [LX_RULE_ORDERED] = LUXEL_RULE_AT_MOST,
        [LX_RULE_DISTINCT] = LUXEL_RULE_DIFFERS,   [LX_RULE_POSITIVE] = LUXEL_RULE_POSITIVE,
        [LX_RULE_ONE] = LUXEL_RULE_ONE_OF,
    };
    if (rule->kind == LX_RULE_ONE) {
        *seen = (luxel_parameter_rule){.kind = LUXEL_RULE_ONE_OF};
        return lx_rule_lists(rule, key);
    }
    bool is_key = strcmp(rule->key, key) == 0;
    if (!is_key && !(rule->kind == LX_RULE_EXCLUSIVE && strcmp(rule->other, key) == 0))
        return false;
    *seen = (luxel_parameter_rule){.kind = kinds[rule->kind], .other = is_key ? rule->other : rule->key};
    return true;
}

/* Gives an item the rules of its table; 0, or -1 when out of memory. */
static int add_rules(struct lx_reflected *item, const struct lx_table *table, const char *key)
{
    item->rules = lx_new_array(table->rule_count, sizeof *item->rules);
    if (!item->rules)
        return -1;
    item->shown.rules = item->rules;
    for (size_t i = 0; i < table->rule_count; i++) {
        luxel_parameter_rule seen;
        if (!see_rule(&table->rules[i], key, &seen))
            continue;
        struct lx_text words = {0};
        if (table->rules[i].choices) {
            lx_add_rule_choices(&words, &table->rules[i], ", ");
            seen.choices = lx_text_take(&words);
        }
        if (table->rules[i].choices && !seen.choices)
            return -1;
        item->rules[item->shown.rule_count++] = seen;
    }
    return 0;
}

/* Appends a parameter; `path` and `choices` become the list's. */
static int append(struct lx_parameter_reflection *reflection, const struct lx_parameter *parameter, const char *variant,
                  char *path, char *choices)
{
    if (lx_reserve((void **)&reflection->items, &reflection->capacity, reflection->count + 1,
                   sizeof *reflection->items) < 0) {
        free(path);
        free(choices);
        return -1;
    }
    struct lx_reflected item = {.path = path, .choices = choices};
    item.shown = (luxel_parameter){
        .path = path,
        .variant = variant,
        .choices = choices,
        .default_value = parameter->initial,
        .required = parameter->required,
    };
    measure(parameter, &item.shown);
    bool whole = path && (choices || !parameter->choices) && describe(reflection, parameter, &item.shown);
    reflection->items[reflection->count++] = item;
    return whole ? 0 : -1;
}

static char *join_path(const char *up, const char *key)
{
    struct lx_text path = {0};
    lx_text_puts(&path, up);
    if (up[0])
        lx_text_puts(&path, ".");
    lx_text_puts(&path, key);
    return lx_text_take(&path);
}

static int reflect_table(struct lx_parameter_reflection *reflection, const struct lx_table *table, const char *up,
                         const char *variant);

static int append_kinds(struct lx_parameter_reflection *reflection, const struct lx_parameter *list)
{
    for (size_t i = 0; list->variants[i]; i++) {
        const struct lx_variant *variant = list->variants[i];
        if (lx_reserve(&reflection->kinds, &reflection->kind_capacity, reflection->kind_count + 1,
                       sizeof *reflection->kinds) < 0)
            return -1;
        const char *meaning = keep_phrase(reflection, variant->meaning);
        if (!meaning)
            return -1;
        reflection->kinds[reflection->kind_count++] = (luxel_parameter_kind){
            .list = list->name, .name = variant->name, .meaning = meaning, .example = variant->example};
    }
    return 0;
}

/* The key `type` of a list's elements, the keys common to them, and those of each variant. */
static int reflect_list(struct lx_parameter_reflection *reflection, const struct lx_parameter *list, const char *path)
{
    static const struct lx_parameter type = {.name = "type",
                                             .label = "Type",
                                             .type = LX_CHOICE,
                                             .required = true,
                                             .meaning = "which kind it is, which decides its other keys"};
    struct lx_text element = {0}, names = {0};
    lx_text_puts(&element, path);
    lx_text_puts(&element, "[]");
    lx_add_variants(&names, list->variants);
    char *up = lx_text_take(&element), *choices = lx_text_take(&names);
    if (!up || !choices) {
        free(up);
        free(choices);
        return -1;
    }
    int result = append(reflection, &type, NULL, join_path(up, "type"), choices);
    if (result == 0)
        result = append_kinds(reflection, list);
    if (result == 0)
        result = reflect_table(reflection, list->group, up, NULL);
    for (size_t i = 0; result == 0 && list->variants[i]; i++)
        result = reflect_table(reflection, list->variants[i]->table, up, list->variants[i]->name);
    free(up);
    return result;
}

static int reflect_groups(struct lx_parameter_reflection *reflection, const struct lx_parameter *list, const char *path,
                          const char *variant)
{
    struct lx_text element = {0};
    lx_text_puts(&element, path);
    lx_text_puts(&element, "[]");
    char *up = lx_text_take(&element);
    int result = up ? reflect_table(reflection, list->group, up, variant) : -1;
    free(up);
    return result;
}

static int reflect_table(struct lx_parameter_reflection *reflection, const struct lx_table *table, const char *up,
                         const char *variant)
{
    int result = 0;
    for (size_t i = 0; result == 0 && i < table->count; i++) {
        const struct lx_parameter *parameter = &table->parameters[i];
        struct lx_text choices = {0};
        if (parameter->choices)
            lx_add_choices(&choices, parameter->choices);
        size_t index = reflection->count;
        result = append(reflection, parameter, variant, join_path(up, parameter->name),
                        parameter->choices ? lx_text_take(&choices) : NULL);
        if (result == 0)
            result = add_rules(&reflection->items[index], table, parameter->name);
        if (result < 0)
            break;
        const char *path = reflection->items[index].path;
        if (parameter->type == LX_GROUP)
            result = reflect_table(reflection, parameter->group, path, variant);
        else if (parameter->type == LX_GROUPS)
            result = reflect_groups(reflection, parameter, path, variant);
        else if (parameter->type == LX_VARIANTS)
            result = reflect_list(reflection, parameter, path);
    }
    return result;
}

int lx_reflect(const struct lx_table *table, luxel_translate translate, void *data,
               struct lx_parameter_reflection *reflection)
{
    *reflection = (struct lx_parameter_reflection){.translate = translate, .data = data};
    int result = reflect_table(reflection, table, "", NULL);
    if (result < 0)
        lx_reflection_clear(reflection);
    return result;
}

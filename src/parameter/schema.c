/* SPDX-License-Identifier: MIT */
/*
 * The schema made by walking the tables.  Groups become objects where they stand; each kind of a list's elements is a
 * definition that its key `type` chooses.  Rules between keys are schema_rules.c's.
 *
 * Draft-07 is what editors read best (yaml-language-server among them).  There a $ref hides its neighbours, so what is
 * shared is brought in by allOf.
 */
#include "schema.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/json.h"
#include "schema_rules.h"
#include "words.h"

/* ---- meanings ---- */

static void add_sentence(struct lx_text *text, const char *start, const char *words)
{
    if (text->length)
        lx_text_puts(text, " ");
    lx_text_puts(text, start);
    lx_text_puts(text, words);
    lx_text_puts(text, ".");
}

/* A meaning as a sentence; one that begins with a symbol ("kd, the weight") keeps its letter. */
static void add_meaning(struct lx_text *text, const char *meaning)
{
    char first[2] = {meaning[0], 0};
    if (first[0] >= 'a' && first[0] <= 'z' && meaning[strcspn(meaning, ", ")] != ',')
        first[0] = (char)(first[0] - 'a' + 'A');
    add_sentence(text, first, meaning + 1);
}

static void add_advised(struct lx_text *text, const struct lx_parameter *parameter)
{
    struct lx_text words = {0};
    lx_add_advised(&words, parameter, lx_unit_word(parameter->unit, false));
    char *range = lx_text_render(&words, NULL, NULL);
    if (range)
        add_sentence(text, "Advised: ", range);
    else
        text->failed = true;
    free(range);
}

static void add_unit(struct lx_text *text, const struct lx_parameter *parameter)
{
    const char *unit = lx_unit_word(parameter->unit, false), *photometric = lx_unit_word(parameter->unit, true);
    if (!unit[0])
        return;
    add_sentence(text, "Unit: ", strcmp(unit, "°") == 0 ? "degrees" : unit);
    if (strcmp(unit, photometric) != 0) {
        text->length--; /* the full stop */
        lx_text_printf(text, ", or %s with photometric units.", photometric);
    }
}

static void add_description(struct lx_json *json, const struct lx_table *table, const struct lx_parameter *parameter)
{
    struct lx_text text = {0};
    add_meaning(&text, parameter->meaning);
    add_unit(&text, parameter);
    if (parameter->advised[0].given)
        add_advised(&text, parameter);
    lx_describe_rules(&text, table, parameter->name);
    char *description = lx_text_take(&text);
    if (description)
        lx_json_text(json, "description", description);
    else
        json->text->failed = true;
    free(description);
}

/* ---- values ---- */

static void add_range(struct lx_json *json, const struct lx_interval *range)
{
    if (!range->given)
        return;
    if (range->low == range->high) {
        lx_json_number(json, "const", range->low);
        return;
    }
    if (isfinite(range->low))
        lx_json_number(json, range->low_open ? "exclusiveMinimum" : "minimum", range->low);
    if (isfinite(range->high))
        lx_json_number(json, "maximum", range->high);
}

static void add_reference(struct lx_json *json, const char *key, const char *definition, const char *kind)
{
    struct lx_text path = {0};
    lx_text_printf(&path, "#/definitions/%s%s%s", definition, kind ? "-" : "", kind ? kind : "");
    char *words = lx_text_take(&path);
    lx_json_open_line(json, key, '{');
    lx_json_text(json, "$ref", words ? words : "");
    lx_json_close(json, "}");
    json->text->failed = json->text->failed || !words;
    free(words);
}

static void add_number(struct lx_json *json, const struct lx_parameter *parameter, bool whole)
{
    lx_json_text(json, "type", whole ? "integer" : "number");
    add_range(json, &parameter->legal);
    if (whole)
        return;
    lx_json_open_line(json, "allOf", '[');
    add_reference(json, NULL, "finite", NULL);
    lx_json_close(json, "]");
}

/* An array of exactly `count` numbers. */
static void add_numbers(struct lx_json *json, const struct lx_parameter *parameter, unsigned count, bool whole)
{
    lx_json_text(json, "type", "array");
    lx_json_open_line(json, "items", '{');
    add_number(json, parameter, whole);
    lx_json_close(json, "}");
    lx_json_number(json, "minItems", count);
    lx_json_number(json, "maxItems", count);
    if (parameter->nonzero)
        lx_json_raw(json, "contains", "{\"not\": {\"const\": 0}}");
}

static void add_choices(struct lx_json *json, const char *const *choices)
{
    lx_json_open_line(json, "enum", '[');
    for (size_t i = 0; choices[i]; i++)
        lx_json_text(json, NULL, choices[i]);
    lx_json_close(json, "]");
}

/* One of some words, or what is opened next. */
static void begin_words_or(struct lx_json *json, const char *const *words)
{
    lx_json_open(json, "anyOf", '[');
    lx_json_open_line(json, NULL, '{');
    add_choices(json, words);
    lx_json_close(json, "}");
}

static void add_choice_or_pair(struct lx_json *json, const struct lx_parameter *parameter)
{
    begin_words_or(json, parameter->choices);
    lx_json_open(json, NULL, '{');
    lx_json_text(json, "$comment", "low < high is checked where one of the steps below lies from high to low");
    add_numbers(json, parameter, 2, false);
    lx_json_boolean(json, "uniqueItems", true);
    lx_add_rising_pair(json);
    lx_json_close(json, "}]");
}

static void add_choice_or_whole(struct lx_json *json, const struct lx_parameter *parameter)
{
    begin_words_or(json, parameter->choices);
    lx_json_open_line(json, NULL, '{');
    add_number(json, parameter, true);
    lx_json_close(json, "}]");
}

/* A list of lists of `width` numbers. */
static void add_tuples(struct lx_json *json, const struct lx_parameter *parameter, unsigned width)
{
    lx_json_text(json, "type", "array");
    if (parameter->count)
        lx_json_number(json, "minItems", parameter->count);
    lx_json_open(json, "items", '{');
    add_numbers(json, parameter, width, false);
    lx_json_close(json, "}");
}

static void add_list(struct lx_json *json, const struct lx_parameter *parameter)
{
    lx_json_text(json, "type", "array");
    if (parameter->count)
        lx_json_number(json, "minItems", parameter->count);
    add_reference(json, "items", parameter->name, NULL);
}

static void add_object(struct lx_json *json, const struct lx_table *const *tables, size_t count,
                       const struct lx_variant *variant);

static void add_group(struct lx_json *json, const struct lx_parameter *parameter)
{
    if (!parameter->choices) {
        add_object(json, &parameter->group, 1, NULL);
        return;
    }
    begin_words_or(json, parameter->choices);
    lx_json_open(json, NULL, '{');
    add_object(json, &parameter->group, 1, NULL);
    lx_json_close(json, "}]");
}

static void add_groups(struct lx_json *json, const struct lx_parameter *parameter)
{
    lx_json_text(json, "type", "array");
    if (parameter->count)
        lx_json_number(json, "minItems", parameter->count);
    lx_json_open(json, "items", '{');
    add_object(json, &parameter->group, 1, NULL);
    lx_json_close(json, "}");
}

static void add_default(struct lx_json *json, const struct lx_parameter *parameter)
{
    bool is_word = parameter->choices || parameter->type == LX_TEXT;
    if (parameter->initial && is_word)
        lx_json_text(json, "default", parameter->initial);
    else if (parameter->initial)
        lx_json_raw(json, "default", parameter->initial);
}

/* ---- mappings ---- */

static void add_parameter(struct lx_json *json, const struct lx_table *table, const struct lx_parameter *parameter)
{
    lx_json_open(json, parameter->name, '{');
    lx_json_text(json, "title", parameter->label);
    add_description(json, table, parameter);
    switch (parameter->type) { /* any.h: nothing can be said of it */
    case LX_REAL: add_number(json, parameter, false); break;
    case LX_WHOLE: add_number(json, parameter, true); break;
    case LX_BOOLEAN: lx_json_text(json, "type", "boolean"); break;
    case LX_CHOICE: add_choices(json, parameter->choices); break;
    case LX_TEXT:
        lx_json_text(json, "type", "string");
        lx_json_text(json, "pattern", "^[^\\u0000]*$");
        break;
    case LX_REALS: add_numbers(json, parameter, parameter->count, false); break;
    case LX_WHOLES: add_numbers(json, parameter, parameter->count, true); break;
    case LX_CHOICE_OR_PAIR: add_choice_or_pair(json, parameter); break;
    case LX_GROUP: add_group(json, parameter); break;
    case LX_CHOICE_OR_WHOLE: add_choice_or_whole(json, parameter); break;
    case LX_POINTS: add_tuples(json, parameter, 2); break;
    case LX_VECTORS: add_tuples(json, parameter, 3); break;
    case LX_GROUPS: add_groups(json, parameter); break;
    case LX_VARIANTS: add_list(json, parameter); break;
    }
    add_default(json, parameter);
    lx_json_close(json, "}");
}

static void add_required(struct lx_json *json, const struct lx_table *const *tables, size_t count,
                         const struct lx_variant *variant)
{
    size_t required = variant ? 1 : 0;
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->count; i++)
            required += tables[t]->parameters[i].required;
    if (!required)
        return;
    lx_json_open_line(json, "required", '[');
    if (variant)
        lx_json_text(json, NULL, "type");
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->count; i++)
            if (tables[t]->parameters[i].required)
                lx_json_text(json, NULL, tables[t]->parameters[i].name);
    lx_json_close(json, "]");
}

/* The members of an object schema; `variant`: of a list's element, which has a key `type`, too. */
static void add_object(struct lx_json *json, const struct lx_table *const *tables, size_t count,
                       const struct lx_variant *variant)
{
    lx_json_text(json, "type", "object");
    add_required(json, tables, count, variant);
    lx_json_boolean(json, "additionalProperties", false);
    lx_json_open(json, "properties", '{');
    if (variant) {
        lx_json_open_line(json, "type", '{');
        lx_json_text(json, "const", variant->name);
        lx_json_close(json, "}");
    }
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->count; i++)
            add_parameter(json, tables[t], &tables[t]->parameters[i]);
    lx_json_close(json, "}");
    lx_add_rules(json, tables, count);
}

/* ---- lists ---- */

/* What every element must be: its type is known, and it is one of that type. */
static void define_element(struct lx_json *json, const struct lx_parameter *list)
{
    lx_json_open(json, list->name, '{');
    lx_json_text(json, "type", "object");
    lx_json_raw(json, "required", "[\"type\"]");
    lx_json_open(json, "properties", '{');
    lx_json_open(json, "type", '{');
    lx_json_text(json, "description", "Which kind it is, which decides its other keys.");
    lx_json_open_line(json, "enum", '[');
    for (size_t i = 0; list->variants[i]; i++)
        lx_json_text(json, NULL, list->variants[i]->name);
    lx_json_close(json, "]}}");
    lx_json_open(json, "allOf", '[');
    for (size_t i = 0; list->variants[i]; i++) {
        lx_json_open_line(json, NULL, '{');
        lx_json_open(json, "if", '{');
        lx_json_raw(json, "required", "[\"type\"]");
        lx_json_open(json, "properties", '{');
        lx_json_open(json, "type", '{');
        lx_json_text(json, "const", list->variants[i]->name);
        lx_json_close(json, "}}}");
        add_reference(json, "then", list->name, list->variants[i]->name);
        lx_json_close(json, "}");
    }
    lx_json_close(json, "]}");
}

static void define_variant(struct lx_json *json, const struct lx_parameter *list, const struct lx_variant *variant)
{
    const struct lx_table *const tables[] = {variant->table, list->group};
    struct lx_text name = {0}, meaning = {0};
    lx_text_printf(&name, "%s-%s", list->name, variant->name);
    add_meaning(&meaning, variant->meaning);
    char *key = lx_text_take(&name), *description = lx_text_take(&meaning);
    lx_json_open(json, key, '{');
    lx_json_text(json, "description", description ? description : "");
    add_object(json, tables, 2, variant);
    lx_json_close(json, "}");
    json->text->failed = json->text->failed || !key || !description;
    free(key);
    free(description);
}

/* The lists stand in the scene's own table. */
static void add_definitions(struct lx_json *json, const struct lx_table *table)
{
    lx_json_open(json, "definitions", '{');
    lx_json_open(json, "finite", '{');
    lx_json_text(json, "$comment", "Infinity fails the bounds, and only NaN could pass what must not be passed.");
    lx_json_number(json, "minimum", -DBL_MAX);
    lx_json_number(json, "maximum", DBL_MAX);
    lx_json_raw(json, "not", "{\"type\": \"number\", \"minimum\": 1, \"maximum\": 0}");
    lx_json_close(json, "}");
    for (size_t i = 0; i < table->count; i++) {
        const struct lx_parameter *list = &table->parameters[i];
        if (list->type != LX_VARIANTS)
            continue;
        define_element(json, list);
        for (size_t k = 0; list->variants[k]; k++)
            define_variant(json, list, list->variants[k]);
    }
    lx_json_close(json, "}");
}

char *lx_schema(const struct lx_table *table, const char *title, const char *beyond)
{
    struct lx_text text = {0};
    struct lx_json json = {.text = &text};
    lx_json_open(&json, NULL, '{');
    lx_json_text(&json, "$schema", "http://json-schema.org/draft-07/schema#");
    lx_json_text(&json, "title", title);
    lx_json_text(&json, "$comment", beyond);
    add_object(&json, &table, 1, NULL);
    add_definitions(&json, table);
    lx_json_close(&json, "}");
    return lx_text_take(&text);
}

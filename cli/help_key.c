/* SPDX-License-Identifier: MIT */
/*
 * What a scene key means.  A topic is compared with the paths of the parameter table component by component,
 * so that "lights[0].intensity", "lights.0.intensity", "lights[].intensity" and "intensity" all find the key,
 * "material" finds its group, and "spot" the keys of a type.
 */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "../front/language.h"
#include "cli.h"
#include "command_help.h"
#include "help_words.h"
#include "json.h"
#include "message.h"
#include "text.h"

/* How a parameter answers to a topic; a better match is greater. */
enum match { MATCH_NONE, MATCH_BELOW, MATCH_EXACT };

/* The path with every index as "[]": "lights.0.position" and "lights[0].position" are "lights[].position". */
static char *normal_path(const char *topic)
{
    char *path = message_allocate(2 * strlen(topic) + 1, 1);
    char *out = path;

    while (*topic) {
        const size_t skip = *topic == '[' || *topic == '.';
        const size_t digits = skip ? strspn(topic + 1, "0123456789") : 0;
        const char end = skip ? topic[1 + digits] : '\0';

        if ((*topic == '[' && end == ']') || (*topic == '.' && digits > 0 && (end == '.' || end == '\0'))) {
            out = stpcpy(out, "[]");
            topic += 1 + digits + (end == ']');
        } else {
            *out++ = *topic++;
        }
    }
    return path;
}

static bool is_boundary(char character)
{
    return character == '\0' || character == '.' || character == '[';
}

/* A topic names the parameter if it is the end of its path, and a group above it if it stands inside. */
static enum match match_path(const char *topic, const char *path)
{
    const size_t length = strlen(topic);
    enum match best = MATCH_NONE;

    for (const char *at = strstr(path, topic); at && length > 0; at = strstr(at + 1, topic)) {
        if (at != path && at[-1] != '.')
            continue;
        if (at[length] == '\0')
            return MATCH_EXACT;
        if (is_boundary(at[length]) || topic[length - 1] == ']')
            best = MATCH_BELOW;
    }
    return best;
}

static enum match match_parameter(const char *topic, const luxel_parameter *parameter)
{
    enum match match;

    if (!topic)
        return MATCH_EXACT;
    match = match_path(topic, parameter->path);
    if (match == MATCH_NONE && parameter->variant && strcmp(topic, parameter->variant) == 0)
        match = MATCH_BELOW;
    return match;
}

static bool same_text(const char *a, const char *b)
{
    return (!a && !b) || (a && b && strcmp(a, b) == 0);
}

static bool same_rules(const luxel_parameter *a, const luxel_parameter *b)
{
    bool same = a->rule_count == b->rule_count;

    for (size_t i = 0; same && i < a->rule_count; i++)
        same = a->rules[i].kind == b->rules[i].kind && same_text(a->rules[i].other, b->rules[i].other) &&
               same_text(a->rules[i].choices, b->rules[i].choices);
    return same;
}

/* Whether two rows of the table say the same, wherever they stand. */
static bool same_meaning(const luxel_parameter *a, const luxel_parameter *b)
{
    return same_text(a->type, b->type) && same_text(a->choices, b->choices) && same_text(a->unit, b->unit) &&
           same_text(a->default_value, b->default_value) && a->required == b->required &&
           same_text(a->legal, b->legal) && same_text(a->advised, b->advised) && same_text(a->meaning, b->meaning) &&
           same_rules(a, b);
}

/* Rows of one key that say the same, but for the type that they belong to. */
static bool same_parameter(const luxel_parameter *a, const luxel_parameter *b)
{
    return same_text(a->path, b->path) && same_meaning(a, b);
}

/* Whether a key's group is called as another's and more, as "materials.floor" is to "material". */
static bool extends_group(const char *path, const char *other)
{
    const char *dot = strrchr(other, '.');

    return dot && strncmp(path, other, (size_t)(dot - other)) == 0;
}

/* Whether another key says what one before it said to the same topic, as "shininess" of walls after a material's. */
static bool repeats(const luxel_parameter *key, const luxel_parameter *before, const char *topic)
{
    return topic && match_parameter(topic, before) == MATCH_EXACT && match_parameter(topic, key) == MATCH_EXACT &&
           extends_group(key->path, before->path) && same_meaning(before, key) && !same_text(key->path, before->path);
}

static bool is_first_of_its_kind(const luxel_parameters *keys, const char *topic, size_t i)
{
    const luxel_parameter *parameter = luxel_parameters_get(keys, i);

    for (size_t k = 0; k < i; k++) {
        const luxel_parameter *before = luxel_parameters_get(keys, k);

        if (same_parameter(before, parameter) || repeats(parameter, before, topic))
            return false;
    }
    return true;
}

/* Whether a path is that of a key between two others that repeats the first of them, for another type. */
static bool is_listed(const luxel_parameters *keys, const char *topic, size_t i, size_t end)
{
    for (size_t k = i + 1; k < end; k++)
        if (strcmp(luxel_parameters_get(keys, k)->path, luxel_parameters_get(keys, end)->path) == 0 &&
            repeats(luxel_parameters_get(keys, k), luxel_parameters_get(keys, i), topic))
            return true;
    return false;
}

/* The paths of the keys that repeat parameter i; "" where there are none. */
static const char *list_repeats(const luxel_parameters *keys, const char *topic, size_t i, char buffer[TEXT_SIZE])
{
    size_t used = 0;

    buffer[0] = '\0';
    for (size_t k = i + 1; k < luxel_parameters_count(keys) && used < TEXT_SIZE; k++) {
        const luxel_parameter *other = luxel_parameters_get(keys, k);

        if (repeats(other, luxel_parameters_get(keys, i), topic) && !is_listed(keys, topic, i, k))
            used += (size_t)snprintf(buffer + used, TEXT_SIZE - used, "%s%s", used > 0 ? ", " : "", other->path);
    }
    return buffer;
}

/* "point, spot": the types that have parameter i as it stands; "" for all. */
static const char *list_variants(const luxel_parameters *keys, size_t i, char buffer[TEXT_SIZE])
{
    const luxel_parameter *parameter = luxel_parameters_get(keys, i);
    size_t used = 0;

    buffer[0] = '\0';
    for (size_t k = i; parameter->variant && k < luxel_parameters_count(keys); k++) {
        const luxel_parameter *other = luxel_parameters_get(keys, k);

        if (!same_parameter(parameter, other) || !other->variant || used >= TEXT_SIZE)
            continue;
        used += (size_t)snprintf(buffer + used, TEXT_SIZE - used, "%s%s", used > 0 ? ", " : "", other->variant);
    }
    return buffer;
}

static void add_line(struct text_table *table, const char *name, const char *value)
{
    if (value && *value)
        text_table_row(table, TEXT_CELLS(name, value));
}

static void add_rule(struct text_table *table, const luxel_parameter_rule *rule)
{
    char words[TEXT_SIZE];
    const char *choices = rule->choices ? rule->choices : "";

    switch (rule->kind) {
    case LUXEL_RULE_EXCLUDES: add_line(table, _("excludes"), rule->other); break;
    case LUXEL_RULE_NEEDED:
        add_line(table, _("required"),
                 rule->choices ? text_format(words, _("with %s: %s"), rule->other, choices)
                               : text_format(words, _("with %s"), rule->other));
        break;
    case LUXEL_RULE_USED:
        add_line(table, _("has effect"),
                 rule->choices ? text_format(words, _("only with %s: %s"), rule->other, choices)
                               : text_format(words, _("only with %s"), rule->other));
        break;
    case LUXEL_RULE_AT_MOST: add_line(table, _("at most"), rule->other); break;
    case LUXEL_RULE_DIFFERS: add_line(table, _("must differ"), text_format(words, _("from %s"), rule->other)); break;
    case LUXEL_RULE_POSITIVE:
        add_line(table, _("must be > 0"), text_format(words, _("with %s: %s"), rule->other, choices));
        break;
    case LUXEL_RULE_ONE_OF: add_line(table, _("exactly one of"), choices); break;
    }
}

static void print_parameter(const luxel_parameters *keys, size_t i)
{
    const luxel_parameter *parameter = luxel_parameters_get(keys, i);
    struct text_table *table = text_table_new("ll");
    char variants[TEXT_SIZE];

    printf("%s\n", parameter->path);
    text_definition(stdout, "", 2, parameter->meaning);
    add_line(table, _("of type"), list_variants(keys, i, variants));
    add_line(table, _("type"), parameter->type);
    add_line(table, _("choices"), parameter->choices);
    add_line(table, _("unit"), parameter->unit);
    add_line(table, _("default"), parameter->required ? _("none, it is required") : parameter->default_value);
    add_line(table, _("legal"), parameter->legal);
    add_line(table, _("advised"), parameter->advised);
    for (size_t r = 0; r < parameter->rule_count; r++)
        add_rule(table, &parameter->rules[r]);
    text_table_print(table, stdout, 2);
}

/* What a topic such as "spot" is, with an example; returns what separates it from the next. */
static const char *print_kinds(const luxel_parameters *keys, const char *topic, const char *separator)
{
    const luxel_parameter_kind *kind;

    for (size_t i = 0; (kind = luxel_parameters_kind(keys, i)) != NULL; i++) {
        if (!topic || strcmp(kind->name, topic) != 0)
            continue;
        printf(_("%s%s of the list %s\n"), separator, kind->name, kind->list);
        text_definition(stdout, "", 2, kind->meaning);
        if (kind->example)
            printf(_("  such as  %s\n"), kind->example);
        separator = "\n";
    }
    return separator;
}

static bool is_path(const luxel_parameters *keys, const char *topic)
{
    for (size_t i = 0; topic && i < luxel_parameters_count(keys); i++)
        if (strcmp(luxel_parameters_get(keys, i)->path, topic) == 0)
            return true;
    return false;
}

/* A topic that is a key's whole path, such as "points", is meant as that first. */
static void print_text(const luxel_parameters *keys, const char *topic, enum match wanted)
{
    const bool key_first = is_path(keys, topic);
    const char *separator = key_first ? "" : print_kinds(keys, topic, "");
    char repeated[TEXT_SIZE], text[TEXT_SIZE];

    for (size_t i = 0; i < luxel_parameters_count(keys); i++) {
        if (match_parameter(topic, luxel_parameters_get(keys, i)) != wanted || !is_first_of_its_kind(keys, topic, i))
            continue;
        fputs(separator, stdout);
        print_parameter(keys, i);
        if (*list_repeats(keys, topic, i, repeated))
            text_definition(stdout, "", 2, text_format(text, _("the same for %s"), repeated));
        separator = "\n";
    }
    if (key_first)
        print_kinds(keys, topic, separator);
}

/* What lies below the keys that were explained, a line each. */
static void print_below(const luxel_parameters *keys, const char *topic)
{
    struct text_table *table = text_table_new("lll");
    size_t count = 0;

    for (size_t i = 0; i < luxel_parameters_count(keys); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(keys, i);

        if (match_parameter(topic, parameter) != MATCH_BELOW)
            continue;
        if (count++ == 0)
            text_table_line(table, _("keys below:"));
        text_table_row(table,
                       TEXT_CELLS(parameter->path, parameter->variant ? parameter->variant : "", parameter->meaning));
    }
    if (count > 0)
        fputc('\n', stdout);
    text_table_print(table, stdout, 2);
}

static const char *rule_word(luxel_parameter_rule_kind kind)
{
    static const char *const words[] = {
        [LUXEL_RULE_EXCLUDES] = "excludes",   [LUXEL_RULE_NEEDED] = "required_with",
        [LUXEL_RULE_USED] = "used_only_with", [LUXEL_RULE_AT_MOST] = "at_most",
        [LUXEL_RULE_DIFFERS] = "differs",     [LUXEL_RULE_POSITIVE] = "positive_with",
        [LUXEL_RULE_ONE_OF] = "one_of",
    };

    return words[kind];
}

static void write_rules(struct json *json, const luxel_parameter *parameter)
{
    json_open(json, "rules", '[');
    for (size_t r = 0; r < parameter->rule_count; r++) {
        json_open(json, NULL, '{');
        json_text(json, "rule", rule_word(parameter->rules[r].kind));
        json_text(json, "key", parameter->rules[r].other);
        json_text(json, "choices", parameter->rules[r].choices);
        json_close(json, '}');
    }
    json_close(json, ']');
}

static void write_kinds(struct json *json, const luxel_parameters *keys, const char *topic)
{
    const luxel_parameter_kind *kind;

    json_open(json, "kinds", '[');
    for (size_t i = 0; (kind = luxel_parameters_kind(keys, i)) != NULL; i++) {
        if (topic && strcmp(topic, kind->name) != 0)
            continue;
        json_open(json, NULL, '{');
        json_text(json, "list", kind->list);
        json_text(json, "name", kind->name);
        json_text(json, "meaning", kind->meaning);
        json_text(json, "example", kind->example);
        json_close(json, '}');
    }
    json_close(json, ']');
}

static void print_json(const luxel_parameters *keys, const char *topic, const char *word)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_open(&json, "keys", '[');
    for (size_t i = 0; i < luxel_parameters_count(keys); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(keys, i);

        if (match_parameter(topic, parameter) == MATCH_NONE)
            continue;
        json_open(&json, NULL, '{');
        json_text(&json, "path", parameter->path);
        json_text(&json, "label", parameter->label);
        json_text(&json, "of_type", parameter->variant);
        json_text(&json, "type", parameter->type);
        json_text(&json, "choices", parameter->choices);
        json_text(&json, "unit", parameter->unit);
        json_text(&json, "default", parameter->default_value);
        json_bool(&json, "required", parameter->required);
        json_text(&json, "legal", parameter->legal);
        json_text(&json, "advised", parameter->advised);
        json_text(&json, "meaning", parameter->meaning);
        write_rules(&json, parameter);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    write_kinds(&json, keys, topic);
    help_word_write(&json, word);
    json_close(&json, '}');
}

static const char *last_component(const char *path)
{
    const char *dot = strrchr(path, '.');

    return dot ? dot + 1 : path;
}

static int report_unknown_topic(const luxel_parameters *keys, const char *topic)
{
    const size_t parameters = luxel_parameters_count(keys);
    const char **words = message_allocate(COMMAND_COUNT + 3 * parameters, sizeof *words);
    size_t count = 0;

    for (size_t i = 0; i < COMMAND_COUNT; i++)
        words[count++] = commands[i]->name;
    for (size_t i = 0; i < parameters; i++) {
        const luxel_parameter *parameter = luxel_parameters_get(keys, i);

        words[count++] = last_component(parameter->path);
        words[count++] = parameter->path;
        words[count++] = parameter->variant;
    }
    message_error(_("there is no help about \"%s\""), topic);
    message_did_you_mean(luxel_nearest_word(topic, words, count));
    free(words);
    return EXIT_USAGE;
}

/* "study", "study.vary[].random": the keys of study files, as which key; NULL: not about them. */
static const char *topic_of_study(const char *topic)
{
    static const char word[] = "study";
    const size_t length = strlen(word);

    if (!topic || strncmp(topic, word, length) != 0 || (topic[length] != '\0' && topic[length] != '.'))
        return NULL;
    return topic + length + (topic[length] == '.');
}

int help_print_keys(const char *topic, bool as_json)
{
    const char *below = topic_of_study(topic);
    const luxel_translate translate = as_json ? NULL : language_translate;
    luxel_parameters *keys =
        below ? luxel_study_keys(translate, NULL) : luxel_parameters_new_translated(translate, NULL);
    char *path = below && !*below ? NULL : topic ? normal_path(below ? below : topic) : NULL;
    enum match best = MATCH_NONE;
    int code = EXIT_DONE;

    for (size_t i = 0; keys && i < luxel_parameters_count(keys); i++) {
        const enum match match = match_parameter(path, luxel_parameters_get(keys, i));

        best = match > best ? match : best;
    }
    if (!keys) {
        code = message_failure(LUXEL_ERROR_MEMORY, NULL);
    } else if (best == MATCH_NONE && !help_word_is_known(topic)) {
        code = report_unknown_topic(keys, topic);
    } else if (as_json) {
        print_json(keys, path, topic);
    } else if (best == MATCH_NONE) {
        help_word_print(topic);
    } else {
        print_text(keys, path, best);
        if (best == MATCH_EXACT && path)
            print_below(keys, path);
        if (topic && help_word_is_known(topic)) {
            fputc('\n', stdout);
            help_word_print(topic);
        }
    }
    free(path);
    luxel_parameters_free(keys);
    return code;
}

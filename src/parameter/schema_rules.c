/* SPDX-License-Identifier: MIT */
/*
 * Rules between keys as clauses of a schema.  A schema cannot compare two values; an order is therefore checked against
 * steps: what reaches a step must be followed by what reaches it, too.  Between two steps only the library tells.
 */
#include "schema_rules.h"

#include <math.h>
#include <string.h>

#include "decode.h"
#include "words.h"

static void add_required(struct lx_json *json, const char *key)
{
    lx_json_open(json, "required", '[');
    lx_json_text(json, NULL, key);
    lx_json_close(json, "]");
}

/* "if": the other key has one of the rule's words, also by its default. */
static void add_condition(struct lx_json *json, const struct lx_table *table, const struct lx_rule *rule)
{
    const struct lx_parameter *other = lx_find_parameter(table, rule->other);
    bool by_default = false;
    lx_json_open(json, "if", '{');
    lx_json_open(json, "properties", '{');
    lx_json_open(json, rule->other, '{');
    lx_json_open(json, "enum", '[');
    for (size_t i = 0; other->choices[i]; i++) {
        if (!lx_rule_lists(rule, other->choices[i]))
            continue;
        lx_json_text(json, NULL, other->choices[i]);
        by_default = by_default || (other->initial && strcmp(other->initial, other->choices[i]) == 0);
    }
    lx_json_close(json, "]}}");
    if (!by_default)
        add_required(json, rule->other);
    lx_json_close(json, "}");
}

/* Where the one is given, the other must be, too. */
static void add_beside(struct lx_json *json, const struct lx_rule *rule)
{
    lx_json_open_line(json, NULL, '{');
    lx_json_open(json, "dependencies", '{');
    lx_json_open(json, rule->other, '[');
    lx_json_text(json, NULL, rule->key);
    lx_json_close(json, "]}}");
}

static void add_needed(struct lx_json *json, const struct lx_table *table, const struct lx_rule *rule)
{
    if (!rule->choices) {
        add_beside(json, rule);
        return;
    }
    lx_json_open_line(json, NULL, '{');
    add_condition(json, table, rule);
    lx_json_open(json, "then", '{');
    add_required(json, rule->key);
    lx_json_close(json, "}}");
}

static void add_positive(struct lx_json *json, const struct lx_table *table, const struct lx_rule *rule)
{
    lx_json_open_line(json, NULL, '{');
    add_condition(json, table, rule);
    lx_json_open(json, "then", '{');
    lx_json_open(json, "properties", '{');
    lx_json_raw(json, rule->key, "{\"exclusiveMinimum\": 0}");
    lx_json_close(json, "}}}");
}

/* Where the one is given, the other must not be: an editor then marks that key and not the whole object. */
static void add_exclusive(struct lx_json *json, const char *key, const char *other)
{
    lx_json_open_line(json, NULL, '{');
    lx_json_open(json, "dependencies", '{');
    lx_json_open(json, key, '{');
    lx_json_open(json, "properties", '{');
    lx_json_boolean(json, other, false);
    lx_json_close(json, "}}}}");
}

/* At least one, and no two of them. */
static void add_one(struct lx_json *json, const struct lx_table *table, const struct lx_rule *rule)
{
    const struct lx_parameter *key, *other;
    lx_json_open_line(json, NULL, '{');
    lx_json_open(json, "anyOf", '[');
    for (size_t i = 0; (key = lx_rule_key(rule, table, i)) != NULL; i++) {
        lx_json_open(json, NULL, '{');
        add_required(json, key->name);
        lx_json_close(json, "}");
    }
    lx_json_close(json, "]}");
    for (size_t i = 0; (key = lx_rule_key(rule, table, i)) != NULL; i++)
        for (size_t k = i + 1; (other = lx_rule_key(rule, table, k)) != NULL; k++)
            add_exclusive(json, key->name, other->name);
}

static void add_minimum(struct lx_json *json, const char *key, double minimum)
{
    lx_json_open(json, "properties", '{');
    lx_json_open(json, key, '{');
    lx_json_number(json, "minimum", minimum);
    lx_json_close(json, "}}");
}

/* The whole numbers of the legal range are the steps, where it has ends that are not too far apart. */
static void add_ordered(struct lx_json *json, const struct lx_table *table, const struct lx_rule *rule)
{
    const struct lx_interval *range = &lx_find_parameter(table, rule->key)->legal;
    for (double step = floor(range->low) + 1; step <= range->high; step++) {
        lx_json_open_line(json, NULL, '{');
        lx_json_open(json, "if", '{');
        add_minimum(json, rule->key, step);
        add_required(json, rule->key);
        lx_json_close(json, "}");
        lx_json_open(json, "then", '{');
        add_minimum(json, rule->other, step);
        lx_json_close(json, "}}");
    }
}

/* Whether a schema can say something about a rule. */
static bool is_enforced(const struct lx_table *table, const struct lx_rule *rule)
{
    enum { MOST_STEPS = 360 };
    if (rule->kind == LX_RULE_ONE)
        return true;
    const struct lx_interval *range = &lx_find_parameter(table, rule->key)->legal;
    if (rule->kind == LX_RULE_ORDERED)
        return range->given && range->high - range->low <= MOST_STEPS;
    return rule->kind != LX_RULE_USED && rule->kind != LX_RULE_DISTINCT;
}

static void add_rule(struct lx_json *json, const struct lx_table *table, const struct lx_rule *rule)
{
    switch (rule->kind) {
    case LX_RULE_EXCLUSIVE: add_exclusive(json, rule->key, rule->other); break;
    case LX_RULE_ONE: add_one(json, table, rule); break;
    case LX_RULE_NEEDED: add_needed(json, table, rule); break;
    case LX_RULE_POSITIVE: add_positive(json, table, rule); break;
    case LX_RULE_ORDERED: add_ordered(json, table, rule); break;
    case LX_RULE_USED:
    case LX_RULE_DISTINCT: break; /* legal, or beyond a schema: the description tells */
    }
}

void lx_add_rules(struct lx_json *json, const struct lx_table *const *tables, size_t count)
{
    size_t enforced = 0;
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->rule_count; i++)
            enforced += is_enforced(tables[t], &tables[t]->rules[i]);
    if (!enforced)
        return;
    lx_json_open(json, "allOf", '[');
    for (size_t t = 0; t < count; t++)
        for (size_t i = 0; i < tables[t]->rule_count; i++)
            if (is_enforced(tables[t], &tables[t]->rules[i]))
                add_rule(json, tables[t], &tables[t]->rules[i]);
    lx_json_close(json, "]");
}

void lx_describe_rules(struct lx_text *text, const struct lx_table *table, const char *key)
{
    for (size_t i = 0; i < table->rule_count; i++) {
        const struct lx_rule *rule = &table->rules[i];
        if (strcmp(rule->key, key) != 0)
            continue;
        if (rule->kind == LX_RULE_USED) {
            lx_text_printf(text, " It has an effect only with %s%s", rule->other, rule->choices ? " " : "");
            lx_add_rule_choices(text, rule, " or ");
            lx_text_puts(text, ".");
        } else if (rule->kind == LX_RULE_DISTINCT) {
            lx_text_printf(text, " It must differ from %s.", rule->other);
        } else if (rule->kind == LX_RULE_ORDERED) {
            lx_text_printf(text, " It must not be greater than %s.", rule->other);
        }
    }
}

void lx_add_rising_pair(struct lx_json *json)
{
    static const double steps[] = {-1000, -100, -10, -1, 0,  0.01, 0.02, 0.05, 0.1,  0.2,  0.5,  1,
                                   2,     5,    10,  20, 50, 100,  200,  500,  1000, 2000, 5000, 10000};
    lx_json_open(json, "allOf", '[');
    for (size_t i = 0; i < LX_COUNT(steps); i++) {
        lx_json_open_line(json, NULL, '{');
        lx_json_open(json, "if", '{');
        lx_json_open(json, "items", '[');
        lx_json_open(json, NULL, '{');
        lx_json_number(json, "minimum", steps[i]);
        lx_json_close(json, "}]}");
        lx_json_open(json, "then", '{');
        lx_json_open(json, "items", '[');
        lx_json_raw(json, NULL, "true");
        lx_json_open(json, NULL, '{');
        lx_json_number(json, "exclusiveMinimum", steps[i]);
        lx_json_close(json, "}]}}");
    }
    lx_json_close(json, "]");
}

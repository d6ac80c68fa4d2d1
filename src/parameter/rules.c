/* SPDX-License-Identifier: MIT */
/* The rules between the keys of a table. */
#include <string.h>

#include "../base/number.h"
#include "decode.h"

bool lx_rule_lists(const struct lx_rule *rule, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = rule->choices; at; at = strchr(at, '|')) {
        at += *at == '|';
        if (strncmp(at, word, length) == 0 && (at[length] == '|' || !at[length]))
            return true;
    }
    return false;
}

const char *lx_chosen(const struct lx_parameter *parameter, const void *parameters)
{
    return parameter->choices[*(const int *)lx_const_member(parameter, parameters)];
}

bool lx_rule_applies(const struct lx_rule *rule, const struct lx_table *table, const void *parameters)
{
    return lx_rule_lists(rule, lx_chosen(lx_find_parameter(table, rule->other), parameters));
}

/* A table whose rules are checked. */
struct check {
    struct lx_walk *walk;
    const struct lx_step *up;
    const struct lx_table *table;
    const void *parameters;
    lx_node_id mapping;
};

static uint64_t bit_of(const struct check *check, const struct lx_parameter *parameter)
{
    return (uint64_t)1 << (parameter - check->table->parameters);
}

/* Reports at the value of `key`. */
static void report(const struct check *check, const char *key, enum lx_message message, const char *first,
                   const char *second)
{
    const struct lx_document *document = check->walk->document;
    struct lx_step step = {check->up, key, 0};
    lx_node_id id = lx_document_find(document, check->mapping, key);
    lx_walk_report(check->walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, id), &step, message, first, second);
}

static void report_exclusive(const struct check *check, const struct lx_rule *rule)
{
    const struct lx_document *document = check->walk->document;
    lx_node_id key = lx_document_find(document, check->mapping, rule->key);
    lx_node_id other = lx_document_find(document, check->mapping, rule->other);
    /* the one that comes second is the one too many; nodes are numbered in the order of the text */
    lx_node_id late = key > other ? key : other;
    const char *name = lx_document_key(document, late);
    struct lx_step step = {check->up, name, 0};
    lx_walk_report(check->walk, LUXEL_SEVERITY_ERROR, lx_document_key_place(document, late), &step,
                   LX_MSG_EXCLUSIVE_KEYS, late == key ? rule->other : rule->key, NULL);
}

static void check_needed(const struct check *check, const struct lx_rule *rule)
{
    const struct lx_parameter *other = lx_find_parameter(check->table, rule->other);
    if (!lx_rule_applies(rule, check->table, check->parameters))
        return;
    struct lx_step step = {check->up, rule->key, 0};
    lx_walk_report(check->walk, LUXEL_SEVERITY_ERROR, lx_document_place(check->walk->document, check->mapping), &step,
                   LX_MSG_NEEDED_KEY, rule->other, lx_chosen(other, check->parameters));
}

static void check_ordered(const struct check *check, const struct lx_parameter *key, const struct lx_parameter *other)
{
    char number[LX_NUMBER_SIZE];
    double low = *(const double *)lx_const_member(key, check->parameters);
    double high = *(const double *)lx_const_member(other, check->parameters);
    if (low > high)
        report(check, key->name, LX_MSG_WRONG_ORDER, other->name, lx_write_number(high, number));
}

static void check_distinct(const struct check *check, const struct lx_parameter *key, const struct lx_parameter *other)
{
    const double *a = lx_const_member(key, check->parameters), *b = lx_const_member(other, check->parameters);
    bool same = true;
    for (unsigned i = 0; i < key->count; i++)
        same = same && a[i] == b[i];
    if (same)
        report(check, key->name, LX_MSG_SAME_PLACE, other->name, NULL);
}

static void check_positive(const struct check *check, const struct lx_rule *rule, const struct lx_parameter *key)
{
    double value = *(const double *)lx_const_member(key, check->parameters);
    if (value > 0 || !lx_rule_applies(rule, check->table, check->parameters))
        return;
    const struct lx_parameter *other = lx_find_parameter(check->table, rule->other);
    report(check, key->name, LX_MSG_NOT_POSITIVE, rule->other, lx_chosen(other, check->parameters));
}

void lx_check_rules(struct lx_walk *walk, const struct lx_step *up, const struct lx_table *table,
                    const void *parameters, uint64_t seen, uint64_t there, lx_node_id mapping)
{
    const struct check check = {walk, up, table, parameters, mapping};
    for (size_t i = 0; i < table->rule_count; i++) {
        const struct lx_rule *rule = &table->rules[i];
        const struct lx_parameter *key = lx_find_parameter(table, rule->key);
        const struct lx_parameter *other = lx_find_parameter(table, rule->other);
        uint64_t good = *(const uint64_t *)parameters;
        bool key_seen = seen & bit_of(&check, key), other_seen = seen & bit_of(&check, other);
        bool key_good = good & bit_of(&check, key), other_good = good & bit_of(&check, other);
        if (rule->kind == LX_RULE_EXCLUSIVE && key_seen && other_seen)
            report_exclusive(&check, rule);
        else if (rule->kind == LX_RULE_NEEDED && !(there & bit_of(&check, key)) && other_seen == other_good)
            check_needed(&check, rule);
        else if (rule->kind == LX_RULE_ORDERED && key_good && other_good)
            check_ordered(&check, key, other);
        else if (rule->kind == LX_RULE_DISTINCT && key_good && other_good)
            check_distinct(&check, key, other);
        else if (rule->kind == LX_RULE_POSITIVE && key_good && other_seen == other_good)
            check_positive(&check, rule, key);
    }
}

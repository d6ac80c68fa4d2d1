/* SPDX-License-Identifier: MIT */
/* The rules between the keys of a table, and reports about what no rule can say. */
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../base/pose.h"
#include "check.h"

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
    if (!rule->choices)
        return lx_is_given(table, parameters, rule->other);
    return lx_rule_lists(rule, lx_chosen(lx_find_parameter(table, rule->other), parameters));
}

static uint64_t bit_of(const struct lx_check *check, const struct lx_parameter *parameter)
{
    return (uint64_t)1 << (parameter - check->table->parameters);
}

static void tell(const struct lx_check *check, luxel_severity severity, const char *key, size_t element,
                 enum lx_message message, const char *const *arguments)
{
    const struct lx_document *document = check->walk->document;
    struct lx_step step = {check->up, key, 0}, below = {&step, NULL, element};
    lx_node_id id = lx_document_find(document, check->mapping, key);
    lx_node_id part = id && element != LX_ALL_OF_IT ? lx_document_element(document, id, element) : 0;
    id = part ? part : id ? id : check->mapping;
    lx_walk_tell(check->walk, severity, lx_document_place(document, id), part ? &below : &step, message, arguments);
}

void lx_check_report(const struct lx_check *check, const char *key, size_t element, enum lx_message message,
                     const char *const *arguments)
{
    tell(check, LUXEL_SEVERITY_ERROR, key, element, message, arguments);
}

void lx_check_advise(const struct lx_check *check, const char *key, enum lx_message message,
                     const char *const *arguments)
{
    tell(check, LUXEL_SEVERITY_ADVICE, key, LX_ALL_OF_IT, message, arguments);
}

void lx_check_hint(const struct lx_check *check, enum lx_message message, const char *const *arguments)
{
    lx_hint(check->walk->diagnostics, message, arguments);
}

static void report(const struct lx_check *check, const char *key, enum lx_message message, const char *first,
                   const char *second)
{
    lx_check_report(check, key, LX_ALL_OF_IT, message, LX_ARGS(first, second));
}

void lx_check_pose(const struct lx_check *check, const double axis[3], const double up[3])
{
    if (lx_is_given(check->table, check->parameters, "up") && lx_are_parallel(axis, up))
        report(check, "up", LX_MSG_UP_PARALLEL, NULL, NULL);
}

static void report_exclusive(const struct lx_check *check, const struct lx_rule *rule)
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

const struct lx_parameter *lx_rule_key(const struct lx_rule *rule, const struct lx_table *table, size_t i)
{
    const char *word = rule->choices;
    for (; word && i > 0; i--) {
        const char *bar = strchr(word, '|');
        word = bar ? bar + 1 : NULL;
    }
    size_t length = word ? strcspn(word, "|") : 0;
    for (size_t k = 0; word && k < table->count; k++)
        if (strncmp(table->parameters[k].name, word, length) == 0 && !table->parameters[k].name[length])
            return &table->parameters[k];
    return NULL;
}

/* The keys of the rule that are among these bits, and the one of them that comes first in the text. */
static size_t count_given(const struct lx_check *check, const struct lx_rule *rule, uint64_t bits, lx_node_id *first)
{
    const struct lx_parameter *key;
    size_t count = 0;
    *first = 0;
    for (size_t i = 0; (key = lx_rule_key(rule, check->table, i)) != NULL; i++) {
        lx_node_id id = lx_document_find(check->walk->document, check->mapping, key->name);
        count += (bits & bit_of(check, key)) != 0;
        if (id && (!*first || id < *first))
            *first = id;
    }
    return count;
}

/* Each key but the first is one too many. */
static void report_more(const struct lx_check *check, const struct lx_rule *rule, uint64_t seen, lx_node_id first,
                        const char *keys)
{
    const struct lx_document *document = check->walk->document;
    const struct lx_parameter *key;
    for (size_t i = 0; (key = lx_rule_key(rule, check->table, i)) != NULL; i++) {
        lx_node_id id = lx_document_find(document, check->mapping, key->name);
        struct lx_step step = {check->up, key->name, 0};
        if ((seen & bit_of(check, key)) && id != first)
            lx_walk_tell(check->walk, LUXEL_SEVERITY_ERROR, lx_document_key_place(document, id), &step,
                         LX_MSG_MORE_KEYS, LX_ARGS(lx_document_key(document, first), keys));
    }
}

static void check_one(const struct lx_check *check, const struct lx_rule *rule, uint64_t seen, uint64_t there)
{
    const struct lx_document *document = check->walk->document;
    lx_node_id first;
    const bool is_given = count_given(check, rule, there, &first) > 0;
    if (is_given && count_given(check, rule, seen, &first) <= 1)
        return;
    struct lx_text text = {0};
    lx_add_rule_choices(&text, rule, ", ");
    char *keys = lx_text_take(&text);
    if (!keys)
        check->walk->out_of_memory = true;
    else if (!is_given)
        lx_walk_report(check->walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, check->mapping), check->up,
                       LX_MSG_ONE_KEY, keys, NULL);
    if (keys)
        report_more(check, rule, seen, first, keys);
    free(keys);
}

static void check_needed(const struct lx_check *check, const struct lx_rule *rule)
{
    const struct lx_parameter *other = lx_find_parameter(check->table, rule->other);
    if (!lx_rule_applies(rule, check->table, check->parameters))
        return;
    struct lx_step step = {check->up, rule->key, 0};
    const struct lx_place place = lx_document_place(check->walk->document, check->mapping);
    if (rule->choices)
        lx_walk_report(check->walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_NEEDED_KEY, rule->other,
                       lx_chosen(other, check->parameters));
    else
        lx_walk_report(check->walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_NEEDED_BESIDE, rule->other, NULL);
    lx_hint_expected(check->walk, lx_find_parameter(check->table, rule->key));
}

static void check_ordered(const struct lx_check *check, const struct lx_parameter *key,
                          const struct lx_parameter *other)
{
    char number[LX_NUMBER_SIZE];
    double low = *(const double *)lx_const_member(key, check->parameters);
    double high = *(const double *)lx_const_member(other, check->parameters);
    if (low > high)
        report(check, key->name, LX_MSG_WRONG_ORDER, other->name, lx_write_number(high, number));
}

static void check_distinct(const struct lx_check *check, const struct lx_parameter *key,
                           const struct lx_parameter *other)
{
    const double *a = lx_const_member(key, check->parameters), *b = lx_const_member(other, check->parameters);
    bool same = true;
    for (unsigned i = 0; i < key->count; i++)
        same = same && a[i] == b[i];
    if (same)
        report(check, key->name, LX_MSG_SAME_PLACE, other->name, NULL);
}

static void check_positive(const struct lx_check *check, const struct lx_rule *rule, const struct lx_parameter *key)
{
    double value = *(const double *)lx_const_member(key, check->parameters);
    if (value > 0 || !lx_rule_applies(rule, check->table, check->parameters))
        return;
    const struct lx_parameter *other = lx_find_parameter(check->table, rule->other);
    report(check, key->name, LX_MSG_NOT_POSITIVE, rule->other, lx_chosen(other, check->parameters));
}

void lx_check_rules(const struct lx_check *check, uint64_t seen, uint64_t there)
{
    const struct lx_table *table = check->table;
    for (size_t i = 0; i < table->rule_count; i++) {
        const struct lx_rule *rule = &table->rules[i];
        if (rule->kind == LX_RULE_ONE) {
            check_one(check, rule, seen, there);
            continue;
        }
        const struct lx_parameter *key = lx_find_parameter(table, rule->key);
        const struct lx_parameter *other = lx_find_parameter(table, rule->other);
        uint64_t good = *(const uint64_t *)check->parameters;
        bool key_seen = seen & bit_of(check, key), other_seen = seen & bit_of(check, other);
        bool key_good = good & bit_of(check, key), other_good = good & bit_of(check, other);
        if (rule->kind == LX_RULE_EXCLUSIVE && key_seen && other_seen)
            report_exclusive(check, rule);
        else if (rule->kind == LX_RULE_NEEDED && !(there & bit_of(check, key)) && other_seen == other_good)
            check_needed(check, rule);
        else if (rule->kind == LX_RULE_ORDERED && key_good && other_good)
            check_ordered(check, key, other);
        else if (rule->kind == LX_RULE_DISTINCT && key_good && other_good)
            check_distinct(check, key, other);
        else if (rule->kind == LX_RULE_POSITIVE && key_good && other_seen == other_good)
            check_positive(check, rule, key);
    }
}

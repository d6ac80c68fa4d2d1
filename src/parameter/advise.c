/* SPDX-License-Identifier: MIT */
/* Advice that follows from the tables alone: what was written outside an advised range, or without effect. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "decode.h"

/* What is advised, or usual in a scene of this size. */
static struct lx_interval usual_range(const struct lx_walk *walk, const struct lx_parameter *parameter,
                                      const struct lx_interval *advised)
{
    struct lx_interval range = *advised;
    if (!walk->lengths.given || parameter->unit != LX_UNIT_MM || range.high < LX_USUAL_MM)
        return range;
    range.high = fmax(range.high, walk->lengths.high);
    if (parameter->count == 3) /* a place, which may be on either side of the screen */
        range.low = fmin(range.low, walk->lengths.low);
    return range;
}

static void advise_number(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                          const struct lx_interval *advised, lx_node_id id)
{
    double value;
    const struct lx_interval usual = usual_range(walk, parameter, advised);
    if (!usual.given || !lx_read_real(walk->document, id, &value) || (value >= usual.low && value <= usual.high))
        return;
    const bool is_kept = lx_keeps(walk->diagnostics, LUXEL_SEVERITY_ADVICE);
    struct lx_text range = {0};
    char number[LX_NUMBER_SIZE];
    lx_add_range(&range, &usual, lx_unit_word(parameter->unit, walk->photometric));
    char *words = lx_text_take(&range);
    lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_place(walk->document, id), step, LX_MSG_NOT_ADVISED,
                   words ? words : "", lx_write_number(value, number));
    free(words);
    if (walk->mend && is_kept)
        walk->mend(walk, step, value < usual.low ? usual.low : usual.high);
}

static void advise_numbers(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                           lx_node_id id);

/* Each of a list of tuples. */
static void advise_tuples(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                          lx_node_id id)
{
    struct lx_parameter tuple = *parameter;
    tuple.type = LX_REALS;
    size_t i = 0;
    for (id = lx_document_node(walk->document, id)->first; id; id = lx_document_node(walk->document, id)->next, i++) {
        struct lx_step element = {step, NULL, i};
        advise_numbers(walk, &element, &tuple, id);
    }
}

static void advise_numbers(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                           lx_node_id id)
{
    const struct lx_document *document = walk->document;
    if (parameter->type == LX_POINTS || parameter->type == LX_VECTORS) {
        advise_tuples(walk, step, parameter, id);
        return;
    }
    if (lx_document_node(document, id)->kind == LX_SCALAR) {
        advise_number(walk, step, parameter, &parameter->advised[0], id);
        return;
    }
    bool one_for_all = !parameter->advised[1].given;
    size_t i = 0;
    for (id = lx_document_node(document, id)->first; id; id = lx_document_node(document, id)->next, i++) {
        struct lx_step component = {step, NULL, i};
        if (one_for_all || i < LX_COMPONENTS)
            advise_number(walk, &component, parameter, &parameter->advised[one_for_all ? 0 : i], id);
    }
}

/* A key that has no effect beside the other values of its table; false where it has one. */
static bool advise_unused(struct lx_walk *walk, const struct lx_step *step, const struct lx_table *table,
                          const void *parameters, lx_node_id id)
{
    for (size_t i = 0; i < table->rule_count; i++) {
        const struct lx_rule *rule = &table->rules[i];
        if (rule->kind != LX_RULE_USED || strcmp(rule->key, step->key) != 0 || lx_rule_applies(rule, table, parameters))
            continue;
        if (rule->choices)
            lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_key_place(walk->document, id), step,
                           LX_MSG_NOT_USED, rule->other, lx_chosen(lx_find_parameter(table, rule->other), parameters));
        else
            lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_key_place(walk->document, id), step,
                           LX_MSG_NOT_USED_WITHOUT, rule->other, NULL);
        lx_hint(walk->diagnostics, LX_MSG_HINT_LEAVE_OUT, NULL);
        return true;
    }
    return false;
}

static void advise_mapping(struct lx_walk *walk, const struct lx_step *up, const struct lx_table *table,
                           const void *parameters, lx_node_id mapping);

static void advise_list(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                        const struct lx_list *list, lx_node_id sequence)
{
    lx_node_id id = lx_document_node(walk->document, sequence)->first;
    for (size_t i = 0; i < list->count; i++, id = lx_document_node(walk->document, id)->next) {
        const struct lx_item *item = &list->items[i];
        struct lx_step element = {step, NULL, i};
        advise_mapping(walk, &element, item->variant->table, item->parameters, id);
        advise_mapping(walk, &element, parameter->group, item->common, id);
    }
}

static void advise_groups(struct lx_walk *walk, const struct lx_step *step, const struct lx_table *table,
                          const struct lx_groups *groups, lx_node_id sequence)
{
    lx_node_id id = lx_document_node(walk->document, sequence)->first;
    for (size_t i = 0; i < groups->count; i++, id = lx_document_node(walk->document, id)->next) {
        struct lx_step element = {step, NULL, i};
        advise_mapping(walk, &element, table, (const char *)groups->items + i * table->size, id);
    }
}

static void advise_mapping(struct lx_walk *walk, const struct lx_step *up, const struct lx_table *table,
                           const void *parameters, lx_node_id mapping)
{
    const struct lx_document *document = walk->document;
    for (lx_node_id id = lx_document_node(document, mapping)->first; id; id = lx_document_node(document, id)->next) {
        struct lx_step step = {up, lx_document_key(document, id), 0};
        const struct lx_parameter *parameter = lx_find_parameter(table, step.key);
        if (!parameter || advise_unused(walk, &step, table, parameters, id))
            continue;
        const void *value = lx_const_member(parameter, parameters);
        if (parameter->type == LX_GROUP)
            advise_mapping(walk, &step, parameter->group, value, id);
        else if (parameter->type == LX_GROUPS)
            advise_groups(walk, &step, parameter->group, value, id);
        else if (parameter->type == LX_VARIANTS)
            advise_list(walk, &step, parameter, value, id);
        else
            advise_numbers(walk, &step, parameter, id);
    }
    const struct lx_check check = {walk, up, table, parameters, mapping, true};
    if (table->release) /* the only tables with something to say beyond their keys are those that load files */
        table->check(&check, (void *)parameters);
}

void lx_advise_parameters(struct lx_walk *walk, const struct lx_table *table, const void *parameters)
{
    advise_mapping(walk, NULL, table, parameters, walk->document->root);
}

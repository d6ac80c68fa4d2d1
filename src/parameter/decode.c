/* SPDX-License-Identifier: MIT */
/*
 * The walk of tables over a document: which keys are there, unknown, doubled or missing, groups within groups,
 * and lists whose elements say by their key `type` which table is theirs.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "comma.h"
#include "decode.h"

/* ---- defaults ---- */

static void table_defaults(const struct lx_table *table, void *parameters)
{
    for (size_t i = 0; i < table->count; i++)
        lx_set_default(&table->parameters[i], lx_member(&table->parameters[i], parameters));
}

static void numbers_default(const char *initial, unsigned count, double *numbers)
{
    for (unsigned i = 0; i < count; i++) {
        initial += strspn(initial, "[, ");
        size_t length = strcspn(initial, ",] ");
        lx_read_number(initial, length, &numbers[i]);
        initial += length;
    }
}

static int choice_default(const struct lx_parameter *parameter)
{
    for (int i = 0; parameter->choices[i]; i++)
        if (strcmp(parameter->choices[i], parameter->initial) == 0)
            return i;
    return 0;
}

void lx_set_default(const struct lx_parameter *parameter, void *value)
{
    double number = 0;
    if (parameter->type == LX_GROUP)
        table_defaults(parameter->group, value);
    if (!parameter->initial)
        return;
    switch (parameter->type) {
    case LX_REAL: numbers_default(parameter->initial, 1, value); break;
    case LX_WHOLE:
        numbers_default(parameter->initial, 1, &number);
        *(unsigned *)value = (unsigned)number;
        break;
    case LX_REALS: numbers_default(parameter->initial, parameter->count, value); break;
    case LX_BOOLEAN: *(bool *)value = strcmp(parameter->initial, "true") == 0; break;
    case LX_CHOICE: *(int *)value = choice_default(parameter); break;
    case LX_GROUP: ((struct lx_worded *)value)->word = choice_default(parameter); break;
    case LX_CHOICE_OR_PAIR: ((struct lx_choice_or_pair *)value)->choice = choice_default(parameter); break;
    case LX_CHOICE_OR_WHOLE: ((struct lx_choice_or_whole *)value)->choice = choice_default(parameter); break;
    default: break;
    }
}

/* ---- freeing ---- */

static void list_clear(const struct lx_parameter *parameter, struct lx_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        struct lx_item *item = &list->items[i];
        if (item->variant) {
            lx_parameters_clear(item->variant->table, item->parameters);
            lx_parameters_clear(parameter->group, item->common);
        }
        free(item->parameters); /* common lies in the same memory */
    }
    free(list->items);
    *list = (struct lx_list){0};
}

static void groups_clear(const struct lx_table *table, struct lx_groups *groups)
{
    for (size_t i = 0; i < groups->count; i++)
        lx_parameters_clear(table, (char *)groups->items + i * table->size);
    free(groups->items);
    *groups = (struct lx_groups){0};
}

void lx_parameters_clear(const struct lx_table *table, void *parameters)
{
    if (table->release)
        table->release(parameters);
    for (size_t i = 0; i < table->count; i++) {
        const struct lx_parameter *parameter = &table->parameters[i];
        void *value = lx_member(parameter, parameters);
        if (parameter->type == LX_GROUP) {
            lx_parameters_clear(parameter->group, value);
        } else if (parameter->type == LX_POINTS) {
            free(((struct lx_points *)value)->xy);
            *(struct lx_points *)value = (struct lx_points){0};
        } else if (parameter->type == LX_VECTORS) {
            free(((struct lx_vectors *)value)->xyz);
            *(struct lx_vectors *)value = (struct lx_vectors){0};
        } else if (parameter->type == LX_GROUPS) {
            groups_clear(parameter->group, value);
        } else if (parameter->type == LX_VARIANTS) {
            list_clear(parameter, value);
        }
    }
}

/* ---- mappings ---- */

enum { MOST_TABLES = 2 };

/* One mapping and the tables its keys come from: one, or an element's own and the one common to its list. */
struct mapping {
    struct lx_walk *walk;
    const struct lx_step *step; /* to the mapping */
    lx_node_id id;
    const struct lx_parameter *list; /* of an element: the parameter whose variants it is one of */
    size_t table_count;
    const struct lx_table *tables[MOST_TABLES];
    void *parameters[MOST_TABLES];
    uint64_t seen[MOST_TABLES];
    uint64_t meant[MOST_TABLES]; /* what a misspelt key seems to mean is not reported as missing, too */
    bool type_seen;
};

static bool decode_parameter(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                             lx_node_id id, void *value);

static void report_key(const struct mapping *mapping, lx_node_id id, enum lx_message message)
{
    struct lx_step step = {mapping->step, lx_document_key(mapping->walk->document, id), 0};
    struct lx_text escaped = {0};
    lx_text_add_escaped(&escaped, step.key, strlen(step.key));
    char *key = lx_text_take(&escaped);
    lx_walk_report(mapping->walk, LUXEL_SEVERITY_ERROR, lx_document_key_place(mapping->walk->document, id), &step,
                   message, key ? key : "", NULL);
    free(key);
}

/* Reports a key that is the fraction of the number before it, behind a decimal comma; false: it is none. */
static bool report_comma(const struct mapping *mapping, lx_node_id before, lx_node_id id)
{
    struct lx_walk *walk = mapping->walk;
    const struct lx_document *document = walk->document;
    if (!lx_number_goes_on_in_key(document, before, id))
        return false;
    const struct lx_parameter *parameter = NULL;
    for (size_t t = 0; t < mapping->table_count && !parameter; t++)
        parameter = lx_find_parameter(mapping->tables[t], lx_document_key(document, before));
    if (!parameter || (parameter->type != LX_REAL && parameter->type != LX_WHOLE))
        return false;
    struct lx_text number = {0};
    lx_text_printf(&number, "%s,%s", lx_document_text(document, before), lx_document_key(document, id));
    char *words = lx_text_take(&number);
    struct lx_step step = {mapping->step, parameter->name, 0};
    struct lx_place place = lx_document_place(document, before);
    place.end = lx_document_key_place(document, id).end;
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_WRONG_NUMBER, "", words ? words : "");
    lx_hint(walk->diagnostics, LX_MSG_HINT_POINT, NULL);
    free(words);
    return true;
}

/*
 * Decodes one key with its value, behind the node before it (0: none); each is known to one of the tables, doubled, or
 * unknown.
 */
static void decode_key(struct mapping *mapping, lx_node_id before, lx_node_id id)
{
    struct lx_walk *walk = mapping->walk;
    const char *key = lx_document_key(walk->document, id);
    if (mapping->list && strcmp(key, "type") == 0) {
        if (mapping->type_seen)
            report_key(mapping, id, LX_MSG_DOUBLED_KEY);
        mapping->type_seen = true;
        return;
    }
    for (size_t t = 0; t < mapping->table_count; t++) {
        const struct lx_parameter *parameter = lx_find_parameter(mapping->tables[t], key);
        if (!parameter)
            continue;
        uint64_t bit = (uint64_t)1 << (parameter - mapping->tables[t]->parameters);
        if (mapping->seen[t] & bit) {
            report_key(mapping, id, LX_MSG_DOUBLED_KEY);
            return;
        }
        mapping->seen[t] |= bit;
        struct lx_step step = {mapping->step, key, 0};
        if (decode_parameter(walk, &step, parameter, id, lx_member(parameter, mapping->parameters[t])))
            *(uint64_t *)mapping->parameters[t] |= bit;
        return;
    }
    if (report_comma(mapping, before, id))
        return;
    bool worth_a_hint = lx_keeps(walk->diagnostics, LUXEL_SEVERITY_ERROR);
    report_key(mapping, id, LX_MSG_UNKNOWN_KEY);
    if (!worth_a_hint)
        return;
    const char *meant =
        lx_hint_unknown_key(walk->diagnostics, key, mapping->tables, mapping->table_count, mapping->list);
    for (size_t t = 0; meant && t < mapping->table_count; t++) {
        const struct lx_parameter *parameter = lx_find_parameter(mapping->tables[t], meant);
        if (parameter)
            mapping->meant[t] |= (uint64_t)1 << (parameter - mapping->tables[t]->parameters);
    }
}

/* Adds "in mm". */
static void add_unit(struct lx_text *text, const char *unit)
{
    struct lx_text phrase = {0};
    lx_add_phrase(&phrase, unit, NULL);
    char *words = lx_text_take(&phrase);
    lx_add_phrase(text, LX_N("in {0}"), LX_ARGS(words ? words : ""));
    free(words);
}

void lx_hint_expected(struct lx_walk *walk, const struct lx_parameter *parameter)
{
    struct lx_text expected = {0};
    lx_add_phrase(&expected, parameter->meaning, NULL);
    if (!lx_has_tables(parameter)) {
        lx_text_puts(&expected, " (");
        lx_add_type(&expected, parameter);
        const char *unit = lx_unit_word(parameter->unit, walk->photometric);
        if (parameter->legal.given || unit[0])
            lx_text_puts(&expected, " ");
        if (parameter->legal.given)
            lx_add_range(&expected, &parameter->legal, unit);
        else if (unit[0])
            add_unit(&expected, unit);
        lx_text_puts(&expected, ")");
    }
    char *words = lx_text_take(&expected);
    if (words)
        lx_hint(walk->diagnostics, LX_MSG_HINT_EXPECTED, LX_ARGS(LX_WORDS(words)));
    free(words);
}

static void report_missing(struct mapping *mapping, const struct lx_parameter *parameter)
{
    struct lx_walk *walk = mapping->walk;
    struct lx_step step = {mapping->step, parameter->name, 0};
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(walk->document, mapping->id), &step,
                   LX_MSG_MISSING_KEY, NULL, NULL);
    lx_hint_expected(walk, parameter);
}

/* Judges the keys of one table together; what its own check() sees is good as far as rules can tell. */
static void judge_table(struct mapping *mapping, size_t t)
{
    struct lx_walk *walk = mapping->walk;
    const struct lx_table *table = mapping->tables[t];
    void *parameters = mapping->parameters[t];
    uint64_t there = mapping->seen[t] | mapping->meant[t];
    size_t errors = walk->errors;
    for (size_t i = 0; i < table->count; i++)
        if (table->parameters[i].required && !(there >> i & 1))
            report_missing(mapping, &table->parameters[i]);
    const struct lx_check check = {walk, mapping->step, table, parameters, mapping->id, false};
    lx_check_rules(&check, mapping->seen[t], there);
    bool sound = walk->errors == errors && mapping->seen[t] == *(uint64_t *)parameters && !mapping->meant[t];
    if (table->check && sound && !walk->out_of_memory)
        table->check(&check, parameters);
}

/* Decodes all keys of a mapping; false where anything below it is wrong. */
static bool decode_mapping(struct mapping *mapping)
{
    struct lx_walk *walk = mapping->walk;
    bool failed_before = walk->failed;
    walk->failed = false;
    for (size_t t = 0; t < mapping->table_count; t++)
        table_defaults(mapping->tables[t], mapping->parameters[t]);
    lx_node_id before = 0;
    for (lx_node_id id = lx_document_node(walk->document, mapping->id)->first; id && !walk->out_of_memory;
         before = id, id = lx_document_node(walk->document, id)->next)
        decode_key(mapping, before, id);
    for (size_t t = 0; t < mapping->table_count; t++)
        judge_table(mapping, t);
    bool good = !walk->failed && !walk->out_of_memory;
    walk->failed = walk->failed || failed_before;
    return good;
}

static bool is_mapping(struct lx_walk *walk, const struct lx_step *step, lx_node_id id, enum lx_node_kind kind)
{
    if (lx_document_node(walk->document, id)->kind == kind)
        return true;
    struct lx_text found = {0};
    lx_add_found(&found, walk->document, id);
    char *words = lx_text_take(&found);
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(walk->document, id), step,
                   kind == LX_MAPPING ? LX_MSG_WRONG_GROUP : LX_MSG_WRONG_LIST, NULL, words ? words : "");
    free(words);
    return false;
}

/* The number of elements of a list; false, and reported, where they are too few. */
static bool has_enough(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *list, lx_node_id id,
                       size_t *count)
{
    *count = lx_document_size(walk->document, id);
    if (*count >= list->count)
        return true;
    char least[24];
    snprintf(least, sizeof least, "%u", list->count);
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(walk->document, id), step, LX_MSG_TOO_FEW, least,
                   NULL);
    return false;
}

/* ---- lists of variants ---- */

/* Reports that an element's type is missing (`type` 0) or names no variant. */
static void report_type(struct lx_walk *walk, const struct lx_step *up, const struct lx_parameter *list,
                        lx_node_id element, lx_node_id type)
{
    const struct lx_document *document = walk->document;
    const struct lx_step step = {up, "type", 0};
    struct lx_text words = {0};
    lx_add_variants(&words, list->variants);
    char *known = lx_text_take(&words);
    if (!type) {
        lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, element), &step, LX_MSG_MISSING_KEY,
                       NULL, NULL);
        if (known)
            lx_hint(walk->diagnostics, LX_MSG_HINT_KNOWN_TYPES, LX_ARGS(known));
    } else {
        lx_add_found(&words, document, type);
        char *found = lx_text_take(&words);
        lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, type), &step, LX_MSG_WRONG_CHOICE, known,
                       found ? found : "");
        free(found);
        const char *name = lx_document_text(document, type);
        struct lx_nearest nearest = {.word = name, .length = strlen(name)};
        for (size_t i = 0; list->variants[i]; i++)
            lx_nearest_offer(&nearest, list->variants[i]->name);
        lx_hint_nearest(walk->diagnostics, &nearest);
    }
    free(known);
}

/* The variant that an element's type names; NULL, and reported, where it names none. */
static const struct lx_variant *find_variant(struct lx_walk *walk, const struct lx_step *step,
                                             const struct lx_parameter *list, lx_node_id id)
{
    const struct lx_variant *variant = NULL;
    lx_node_id type = lx_document_find(walk->document, id, "type");
    if (type && lx_document_node(walk->document, type)->kind == LX_SCALAR)
        variant = lx_find_variant(list, lx_document_text(walk->document, type));
    if (!variant)
        report_type(walk, step, list, id, type);
    return variant;
}

static void decode_item(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *list,
                        lx_node_id id, struct lx_item *item)
{
    if (!is_mapping(walk, step, id, LX_MAPPING))
        return;
    const struct lx_variant *variant = find_variant(walk, step, list, id);
    if (!variant)
        return;
    size_t own = (variant->table->size + _Alignof(max_align_t) - 1) / _Alignof(max_align_t) * _Alignof(max_align_t);
    char *memory = lx_new_array(1, own + list->group->size);
    if (!memory) {
        walk->out_of_memory = true;
        return;
    }
    struct mapping mapping = {
        .walk = walk,
        .step = step,
        .id = id,
        .list = list,
        .table_count = 2,
        .tables = {variant->table, list->group},
        .parameters = {memory, memory + own},
    };
    *item = (struct lx_item){variant, memory, memory + own};
    if (!decode_mapping(&mapping)) {
        lx_parameters_clear(variant->table, item->parameters);
        lx_parameters_clear(list->group, item->common);
        free(memory);
        *item = (struct lx_item){0};
    }
}

/* Room for the elements of a list; NULL where it is none or too short, or memory ran out. */
static void *new_items(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *list, lx_node_id id,
                       size_t size, size_t *count)
{
    size_t elements;
    if (!is_mapping(walk, step, id, LX_SEQUENCE) || !has_enough(walk, step, list, id, &elements))
        return NULL;
    void *items = lx_new_array(elements, size);
    if (items)
        *count = elements;
    else
        walk->out_of_memory = true;
    return items;
}

static bool decode_variants(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *list,
                            lx_node_id id, struct lx_list *result)
{
    result->items = new_items(walk, step, list, id, sizeof *result->items, &result->count);
    bool good = result->items;
    size_t i = 0;
    for (id = result->items ? lx_document_node(walk->document, id)->first : 0; id && !walk->out_of_memory;
         id = lx_document_node(walk->document, id)->next, i++) {
        struct lx_step element = {step, NULL, i};
        decode_item(walk, &element, list, id, &result->items[i]);
        good = good && result->items[i].variant;
    }
    return good;
}

/* ---- groups ---- */

static bool decode_group(struct lx_walk *walk, const struct lx_step *step, const struct lx_table *table, lx_node_id id,
                         void *parameters)
{
    if (!is_mapping(walk, step, id, LX_MAPPING))
        return false;
    struct mapping mapping = {
        .walk = walk, .step = step, .id = id, .table_count = 1, .tables = {table}, .parameters = {parameters}};
    return decode_mapping(&mapping);
}

/* A group whose value may be a word, which leaves its keys at their defaults. */
static bool decode_worded(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                          lx_node_id id, struct lx_worded *worded)
{
    if (lx_document_node(walk->document, id)->kind != LX_MAPPING)
        return lx_decode_value(walk, step, parameter, id, &worded->word);
    worded->word = -1;
    return decode_group(walk, step, parameter->group, id, worded);
}

static bool decode_groups(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *list,
                          lx_node_id id, struct lx_groups *result)
{
    result->items = new_items(walk, step, list, id, list->group->size, &result->count);
    bool good = result->items;
    size_t i = 0;
    for (id = result->items ? lx_document_node(walk->document, id)->first : 0; id && !walk->out_of_memory;
         id = lx_document_node(walk->document, id)->next, i++) {
        struct lx_step element = {step, NULL, i};
        good = decode_group(walk, &element, list->group, id, (char *)result->items + i * list->group->size) && good;
    }
    return good;
}

static bool decode_parameter(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                             lx_node_id id, void *value)
{
    switch (parameter->type) {
    case LX_VARIANTS: return decode_variants(walk, step, parameter, id, value);
    case LX_GROUPS: return decode_groups(walk, step, parameter, id, value);
    case LX_GROUP:
        return parameter->choices ? decode_worded(walk, step, parameter, id, value)
                                  : decode_group(walk, step, parameter->group, id, value);
    default: return lx_decode_value(walk, step, parameter, id, value);
    }
}

luxel_status lx_walk_status(struct lx_walk *walk)
{
    if (walk->out_of_memory)
        return lx_out_of_memory(walk->diagnostics);
    if (!walk->failed)
        return LUXEL_OK;
    return walk->unread > 0 && walk->unread == walk->errors ? LUXEL_ERROR_FILE : LUXEL_ERROR_SCENE;
}

luxel_status lx_decode(struct lx_walk *walk, const struct lx_table *table, void *parameters)
{
    memset(parameters, 0, table->size);
    walk->failed = walk->out_of_memory = false;
    walk->errors = walk->unread = 0;
    decode_group(walk, NULL, table, walk->document->root, parameters);
    return lx_walk_status(walk);
}

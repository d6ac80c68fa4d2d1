/* SPDX-License-Identifier: MIT */
/* Walks the parameter tables of a committed scene, row by row. */
#include "parameter_tables.h"

#include <luxel/parameter.h>
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../parameter/decode.h"
#include "../parameter/words.h"
#include "../scene/materials.h"

/* One walk: where the rows go, and what the unit's words depend on. */
struct walk {
    struct luxel_document *document;
    bool photometric;
    bool parts_alone; /* each part of the surface has a material of its own, and none has that of the whole */
};

/* What formulas call the parameters, as explanations do (explain_model.c). */
static const struct {
    const char *key, *symbol;
} symbols[] = {
    {"diffuse", "k_d"},
    {"specular", "k_s"},
    {"ambient", "k_a"},
    {"shininess", "n"},
    {"intensity", "I"},
    {"radiance", "L_e"},
    {"power", "\\Phi"},
    {"k", "k"},
    {"exponent", "m"},
    {"inner", "a"},
    {"outer", "b"},
    {"radius", "R"},
    {"irradiance", "E"},
    {"center", "\\mathbf{C}"},
    {"position", "\\mathbf{S}"},
    {"observer.position", "\\mathbf{O}"},
    {"target", "\\mathbf{T}"},
    {"z", "z_O"},
    {"width", "W"},
    {"height", "H"},
};

/* The symbol of a key, or of one by its path; NULL: it has none. */
static const char *symbol_of(const char *key)
{
    for (size_t i = 0; i < sizeof symbols / sizeof symbols[0]; i++)
        if (strcmp(symbols[i].key, key) == 0)
            return symbols[i].symbol;
    return NULL;
}

static void add_number(struct lx_text *text, double value)
{
    char number[LX_NUMBER_SIZE];
    lx_text_puts(text, lx_write_number(value, number));
}

static void add_numbers(struct lx_text *text, const double *values, size_t count)
{
    lx_text_puts(text, "(");
    for (size_t i = 0; i < count; i++) {
        lx_text_puts(text, i > 0 ? ", " : "");
        add_number(text, values[i]);
    }
    lx_text_puts(text, ")");
}

/* A word of the scene by its label, in the document's language: in English as the scene writes it. */
static void add_word(const struct walk *walk, struct lx_text *text, const char *written, const char *label)
{
    const char *word = label ? lx_document_word(walk->document, label) : written;
    lx_text_puts(text, label && strcmp(word, label) == 0 ? written : word);
}

static void add_choice(const struct walk *walk, struct lx_text *text, const char *choice)
{
    add_word(walk, text, choice, luxel_parameter_choice_label(choice));
}

static void add_boolean(const struct walk *walk, struct lx_text *text, bool is_true)
{
    add_word(walk, text, is_true ? "true" : "false", is_true ? LX_N("yes") : LX_N("no"));
}

/* The value in the scene's own words; false for what is no value but holds others, or is no setting. */
static bool add_value(const struct walk *walk, struct lx_text *text, const struct lx_parameter *parameter,
                      const void *value)
{
    const struct lx_choice_or_pair *pair = value;
    const struct lx_choice_or_whole *whole = value;
    const struct lx_vectors *vectors = value;
    switch (parameter->type) {
    case LX_REAL: add_number(text, *(const double *)value); return true;
    case LX_WHOLE: add_number(text, *(const unsigned *)value); return true;
    case LX_BOOLEAN: add_boolean(walk, text, *(const bool *)value); return true;
    case LX_CHOICE: add_choice(walk, text, parameter->choices[*(const int *)value]); return true;
    case LX_TEXT: lx_text_puts(text, *(const char *const *)value); return true;
    case LX_REALS: add_numbers(text, value, parameter->count); return true;
    case LX_WHOLES: {
        const unsigned *numbers = value;
        double copy[LX_COMPONENTS] = {0};
        for (unsigned i = 0; i < parameter->count && i < LX_COMPONENTS; i++)
            copy[i] = numbers[i];
        add_numbers(text, copy, parameter->count);
        return true;
    }
    case LX_CHOICE_OR_PAIR:
        if (pair->choice >= 0)
            add_choice(walk, text, parameter->choices[pair->choice]);
        else
            add_numbers(text, (const double[]){pair->low, pair->high}, 2);
        return true;
    case LX_CHOICE_OR_WHOLE:
        if (whole->choice >= 0)
            add_choice(walk, text, parameter->choices[whole->choice]);
        else
            add_number(text, whole->whole);
        return true;
    case LX_GROUP: add_choice(walk, text, parameter->choices[((const struct lx_worded *)value)->word]); return true;
    case LX_VECTORS:
        for (size_t i = 0; i < vectors->count; i++) {
            lx_text_puts(text, i > 0 ? ", " : "");
            add_numbers(text, vectors->xyz[i], 3);
        }
        return true;
    default: return false;
    }
}

/* Keys that are told only where a scene has them: without them all is grey and new, nothing is a mirror, and what is no
 * highlight is Lambert's. */
static bool goes_unsaid(const struct lx_table *table, const void *parameters, const char *name)
{
    static const char *const names[] = {"channels",           "color",  "specular_color", "diffuse_model",
                                        "maintenance_factor", "mirror", "mirrors"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(name, names[i]) == 0)
            return !lx_is_given(table, parameters, name);
    return false;
}

/* Whether a parameter says something about this scene. */
static bool is_shown(const struct lx_table *table, const struct lx_parameter *parameter, const void *parameters)
{
    bool given = lx_is_given(table, parameters, parameter->name);
    if ((!given && !parameter->initial) || goes_unsaid(table, parameters, parameter->name))
        return false;
    for (size_t i = 0; i < table->rule_count; i++) {
        const struct lx_rule *rule = &table->rules[i];
        if (rule->kind == LX_RULE_USED && strcmp(rule->key, parameter->name) == 0 &&
            !lx_rule_applies(rule, table, parameters))
            return false;
        /* the default of a key that another one excludes is no setting */
        if (rule->kind == LX_RULE_EXCLUSIVE && !given &&
            ((strcmp(rule->key, parameter->name) == 0 && lx_is_given(table, parameters, rule->other)) ||
             (strcmp(rule->other, parameter->name) == 0 && lx_is_given(table, parameters, rule->key))))
            return false;
    }
    return strcmp(parameter->name, "enabled") != 0 && strcmp(parameter->name, "name") != 0;
}

/* Whether a key is one of those of which just one must be given, and another one was. */
static bool is_other_choice(const struct lx_table *table, const void *parameters, const char *name)
{
    for (size_t i = 0; i < table->rule_count; i++)
        if (table->rules[i].kind == LX_RULE_ONE && lx_rule_lists(&table->rules[i], name))
            return !lx_is_given(table, parameters, name);
    return false;
}

/* Whether a group says nothing: another one of its choice was given, or no part of the surface has this material. */
static bool is_idle_group(const struct walk *walk, const struct lx_table *table, const void *parameters,
                          const struct lx_parameter *parameter, bool is_of_part)
{
    if (parameter->group == &lx_material_table)
        return is_of_part ? !lx_is_given(table, parameters, parameter->name) : walk->parts_alone;
    return is_other_choice(table, parameters, parameter->name);
}

/* What is said of a key, without its symbol, which has a column of its own: "kd, the weight" becomes "the weight". */
static const char *without_symbol(const char *meaning, const char *symbol)
{
    const char *at = meaning;
    for (; symbol && *symbol; symbol++)
        if (*symbol != '_' && *symbol != *at++)
            return meaning;
    return symbol && strncmp(at, ", ", 2) == 0 ? at + 2 : meaning;
}

static void add_row(struct walk *walk, const char *path, const struct lx_parameter *parameter, const void *value)
{
    struct lx_text shown = {0}, range = {0};
    const char *unit = lx_unit_word(parameter->unit, walk->photometric);
    if (!add_value(walk, &shown, parameter, value)) {
        lx_text_clear(&shown);
        return;
    }
    if (*unit) {
        lx_text_puts(&shown, strcmp(unit, "°") == 0 ? "" : " ");
        lx_text_puts(&shown, lx_document_word(walk->document, unit));
    }
    if (parameter->advised[0].given)
        lx_add_advised(&range, parameter, unit);
    char *words = lx_document_rendered(walk->document, &range);
    const char *own = symbol_of(path), *symbol = own ? own : symbol_of(parameter->name);
    const char *meaning = without_symbol(lx_document_word(walk->document, parameter->meaning), symbol);
    const struct lx_span formula = LX_MATH(symbol ? symbol : ""), none = LX_PLAIN("");
    lx_document_row(walk->document,
                    LX_SPANS(LX_CODE(path), symbol ? formula : none, LX_PLAIN(meaning), LX_PLAIN(shown.bytes),
                             LX_PLAIN(words ? words : "")),
                    false);
    free(words);
    lx_text_clear(&shown);
}

static void add_rows(struct walk *walk, const char *prefix, const struct lx_table *table, const void *parameters)
{
    for (size_t i = 0; i < table->count; i++) {
        const struct lx_parameter *parameter = &table->parameters[i];
        const void *value = lx_const_member(parameter, parameters);
        struct lx_text path = {0};
        bool is_group = parameter->type == LX_GROUP;
        if (is_group && parameter->choices)
            is_group = ((const struct lx_worded *)value)->word < 0;
        if (is_group ? is_idle_group(walk, table, parameters, parameter, *prefix)
                     : !is_shown(table, parameter, parameters))
            continue;
        lx_text_puts(&path, prefix);
        lx_text_puts(&path, parameter->name);
        if (is_group) {
            lx_text_puts(&path, ".");
            add_rows(walk, path.bytes ? path.bytes : "", parameter->group, value);
        } else {
            add_row(walk, path.bytes ? path.bytes : "", parameter, value);
        }
        lx_text_clear(&path);
    }
}

static void begin_table(struct walk *walk)
{
    lx_document_table(walk->document, "lllll");
    lx_document_row(walk->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("key")), LX_PLAIN(""), LX_TERM_SPAN(LX_N("meaning")),
                             LX_TERM_SPAN(LX_N("value")), LX_TERM_SPAN(LX_N("advised range"))),
                    false);
}

void lx_add_element_name(struct lx_text *text, const char *list, size_t index, const char *name)
{
    lx_text_printf(text, "%s[%zu]%s", list, index, name ? " " : "");
    if (name)
        lx_text_add_escaped(text, name, strlen(name));
}

/* A table for each element of a list; `common` is what all of its kinds have. */
static void add_list(struct walk *walk, const char *list, const struct lx_parameter *parameter,
                     const struct lx_list *items)
{
    const struct lx_parameter *name = lx_find_parameter(parameter->group, "name");
    const struct lx_parameter *enabled = lx_find_parameter(parameter->group, "enabled");
    for (size_t i = 0; i < items->count && i < LX_MOST_PARAMETER_TABLES; i++) {
        const struct lx_item *item = &items->items[i];
        struct lx_text heading = {0};
        if (enabled && !*(const bool *)lx_const_member(enabled, item->common))
            continue;
        lx_add_element_name(&heading, list, i, *(const char *const *)lx_const_member(name, item->common));
        if (heading.bytes)
            lx_document_heading(walk->document, 2, "{0}: {1}",
                                LX_SPANS(LX_PLAIN(heading.bytes), LX_TERM_SPAN(item->variant->meaning)));
        begin_table(walk);
        walk->parts_alone = strcmp(list, "surfaces") == 0 && !lx_uses_own_material(item);
        add_rows(walk, "", item->variant->table, item->parameters);
        add_rows(walk, "", parameter->group, item->common);
        lx_text_clear(&heading);
    }
    if (items->count > LX_MOST_PARAMETER_TABLES) {
        char all[LX_NUMBER_SIZE];
        lx_document_paragraph(walk->document, LX_N("There are {0} of them in all; the scene at the end has them."),
                              LX_SPANS(LX_PLAIN(lx_write_number((double)items->count, all))));
    }
}

void lx_add_parameter_tables(struct luxel_document *document, const struct lx_scene_parameters *scene)
{
    struct walk walk = {.document = document, .photometric = scene->units == LX_PHOTOMETRIC};
    begin_table(&walk);
    for (size_t i = 0; i < lx_scene_table.count; i++) {
        const struct lx_parameter *parameter = &lx_scene_table.parameters[i];
        const void *value = lx_const_member(parameter, scene);
        if (parameter->type == LX_GROUP) {
            struct lx_text prefix = {0};
            lx_text_printf(&prefix, "%s.", parameter->name);
            add_rows(&walk, prefix.bytes ? prefix.bytes : "", parameter->group, value);
            lx_text_clear(&prefix);
        } else if ((parameter->type == LX_CHOICE && !goes_unsaid(&lx_scene_table, scene, parameter->name)) ||
                   (parameter->type == LX_CHOICE_OR_WHOLE && lx_is_given(&lx_scene_table, scene, parameter->name))) {
            add_row(&walk, parameter->name, parameter, value);
        }
    }
    for (size_t i = 0; i < lx_scene_table.count; i++) {
        const struct lx_parameter *parameter = &lx_scene_table.parameters[i];
        if (parameter->type == LX_VARIANTS)
            add_list(&walk, parameter->name, parameter, lx_const_member(parameter, scene));
    }
}

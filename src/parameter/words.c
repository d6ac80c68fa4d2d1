/* SPDX-License-Identifier: MIT */
/* Tables in words, for messages, help and references alike, so that all of them say the same. */
#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "any.h"
#include "words.h"

enum { LONGEST_FOUND = 40 };

const char *lx_unit_word(enum lx_unit unit, bool photometric)
{
    switch (unit) {
    case LX_UNIT_MM: return LX_N("mm");
    case LX_UNIT_DEGREES: return "°";
    case LX_UNIT_INTENSITY: return photometric ? LX_N("cd") : LX_N("W/sr");
    case LX_UNIT_IRRADIANCE: return photometric ? LX_N("lx") : LX_N("W/m²");
    case LX_UNIT_RADIANCE: return photometric ? LX_N("cd/m²") : LX_N("W/(sr·m²)");
    case LX_UNIT_POWER: return photometric ? LX_N("lm") : LX_N("W");
    case LX_UNIT_NONE: break;
    }
    return "";
}

static void add_number(struct lx_text *text, double value)
{
    char buffer[LX_NUMBER_SIZE];
    lx_text_puts(text, lx_write_number(value, buffer));
}

void lx_add_range(struct lx_text *text, const struct lx_interval *range, const char *unit)
{
    if (!range->given) {
        lx_add_phrase(text, LX_N("any"), NULL);
    } else if (range->low == range->high) {
        add_number(text, range->low);
    } else if (isinf(range->high) || range->low_open) {
        lx_text_puts(text, range->low_open ? "> " : "≥ ");
        add_number(text, range->low);
        if (!isinf(range->high)) {
            lx_text_puts(text, ", ≤ ");
            add_number(text, range->high);
        }
    } else {
        char low[LX_NUMBER_SIZE], high[LX_NUMBER_SIZE];
        lx_add_phrase(text, LX_N("{0} to {1}"),
                      LX_ARGS(lx_write_number(range->low, low), lx_write_number(range->high, high)));
    }
    if (unit[0] && strcmp(unit, "°") != 0)
        lx_text_puts(text, " ");
    lx_add_phrase(text, unit, NULL);
}

void lx_add_advised(struct lx_text *text, const struct lx_parameter *parameter, const char *unit)
{
    static const char *const names[] = {"x ", ", y ", ", z "};
    bool by_component = parameter->advised[1].given;
    for (size_t i = 0; i < (by_component ? LX_COMPONENTS : 1); i++) {
        if (by_component)
            lx_text_puts(text, names[i]);
        lx_add_range(text, &parameter->advised[i], !by_component || i == LX_COMPONENTS - 1 ? unit : "");
    }
}

static void add_listed(struct lx_text *text, const char *word, bool first)
{
    if (!first)
        lx_text_puts(text, ", ");
    lx_text_puts(text, word);
}

void lx_add_choices(struct lx_text *text, const char *const *choices)
{
    for (size_t i = 0; choices[i]; i++)
        add_listed(text, choices[i], i == 0);
}

void lx_add_variants(struct lx_text *text, const struct lx_variant *const *variants)
{
    for (size_t i = 0; variants[i]; i++)
        add_listed(text, variants[i]->name, i == 0);
}

void lx_add_rule_choices(struct lx_text *text, const struct lx_rule *rule, const char *separator)
{
    for (const char *at = rule->choices; at && *at;) {
        size_t length = strcspn(at, "|");
        if (at > rule->choices)
            lx_text_puts(text, separator);
        lx_text_add(text, at, length);
        at += length + (at[length] == '|');
    }
}

void lx_add_type(struct lx_text *text, const struct lx_parameter *parameter)
{
    static const char *const words[] = {
        [LX_REAL] = LX_N("number"),
        [LX_WHOLE] = LX_N("whole number"),
        [LX_BOOLEAN] = LX_N("true or false"),
        [LX_CHOICE] = LX_N("one of"),
        [LX_TEXT] = LX_N("text"),
        [LX_REALS] = LX_N("{0} numbers"),
        [LX_WHOLES] = LX_N("{0} whole numbers"),
        [LX_CHOICE_OR_PAIR] = LX_N("one of, or [low, high]"),
        [LX_GROUP] = LX_N("group of keys"),
        [LX_POINTS] = LX_N("list of points [x, y]"),
        [LX_VECTORS] = LX_N("list of {0} or more places [x, y, z]"),
        [LX_CHOICE_OR_WHOLE] = LX_N("one of, or a whole number"),
        [LX_GROUPS] = LX_N("list of groups of keys"),
        [LX_VARIANTS] = LX_N("list"),
        [LX_ANY] = LX_N("value"),
    };
    char count[LX_NUMBER_SIZE];
    if (parameter->type == LX_GROUP && parameter->choices) {
        lx_add_phrase(text, LX_N("one of, or a group of keys"), NULL);
        return;
    }
    lx_add_phrase(text, words[parameter->type], LX_ARGS(lx_write_number(parameter->count, count)));
}

void lx_add_found(struct lx_text *text, const struct lx_document *document, lx_node_id id)
{
    const struct lx_node *node = lx_document_node(document, id);
    if (node->kind != LX_SCALAR) {
        lx_text_puts(text, node->kind == LX_SEQUENCE ? "[…]" : "{…}");
        return;
    }
    const char *found = lx_document_text(document, id);
    if (node->plain && !found[0]) {
        lx_add_phrase(text, LX_N("empty"), NULL);
        return;
    }
    size_t length = strlen(found), shown = 0;
    for (size_t characters = 0; shown < length && characters < LONGEST_FOUND; characters++) {
        uint32_t code;
        size_t size = lx_next_character(found + shown, length - shown, &code);
        shown += size ? size : 1;
    }
    const char *quote = node->plain ? "" : "\"";
    lx_text_puts(text, quote);
    lx_text_add_escaped(text, found, shown);
    if (shown < length)
        lx_text_puts(text, "…");
    lx_text_puts(text, quote);
}

void lx_add_path(struct lx_text *text, const struct lx_step *step)
{
    if (!step)
        return;
    lx_add_path(text, step->up);
    if (!step->key) {
        lx_text_printf(text, "[%zu]", step->index);
        return;
    }
    if (text->length)
        lx_text_puts(text, ".");
    lx_text_puts(text, step->key);
}

void lx_add_path_end(struct lx_text *text, const struct lx_step *step)
{
    if (step && !step->key) {
        lx_add_path_end(text, step->up);
        lx_text_printf(text, "[%zu]", step->index);
    } else if (step) {
        lx_text_puts(text, step->key);
    }
}

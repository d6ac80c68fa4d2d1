/* SPDX-License-Identifier: MIT */
/* Tables in words, for messages, help and references alike, so that all of them say the same. */
#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "words.h"

enum { LONGEST_FOUND = 40 };

const char *lx_unit_word(enum lx_unit unit, bool photometric)
{
    switch (unit) {
    case LX_UNIT_MM: return "mm";
    case LX_UNIT_DEGREES: return "°";
    case LX_UNIT_INTENSITY: return photometric ? "cd" : "W/sr";
    case LX_UNIT_IRRADIANCE: return photometric ? "lx" : "W/m²";
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
        lx_text_puts(text, "any");
    } else if (range->low == range->high) {
        add_number(text, range->low);
    } else if (isinf(range->high)) {
        lx_text_puts(text, range->low_open ? "> " : "≥ ");
        add_number(text, range->low);
    } else {
        add_number(text, range->low);
        lx_text_puts(text, " to ");
        add_number(text, range->high);
    }
    if (unit[0] && strcmp(unit, "°") != 0)
        lx_text_puts(text, " ");
    lx_text_puts(text, unit);
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
    switch (parameter->type) {
    case LX_REAL: lx_text_puts(text, "number"); break;
    case LX_WHOLE: lx_text_puts(text, "whole number"); break;
    case LX_BOOLEAN: lx_text_puts(text, "true or false"); break;
    case LX_CHOICE: lx_text_puts(text, "one of"); break;
    case LX_TEXT: lx_text_puts(text, "text"); break;
    case LX_REALS: lx_text_printf(text, "%u numbers", parameter->count); break;
    case LX_WHOLES: lx_text_printf(text, "%u whole numbers", parameter->count); break;
    case LX_CHOICE_OR_PAIR: lx_text_puts(text, "one of, or [low, high]"); break;
    case LX_GROUP: lx_text_puts(text, "group of keys"); break;
    case LX_POINTS: lx_text_puts(text, "list of points [x, y]"); break;
    case LX_VARIANTS: lx_text_puts(text, "list"); break;
    }
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
        lx_text_puts(text, "empty");
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
    lx_text_add(text, found, shown);
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

/* SPDX-License-Identifier: MIT */
/* One value of a document into its place in a struct, checked for type, length and legal range. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "any.h"
#include "comma.h"
#include "decode.h"
#include "plain.h"

void lx_walk_tell(struct lx_walk *walk, luxel_severity severity, struct lx_place place, const struct lx_step *step,
                  enum lx_message message, const char *const *arguments)
{
    enum { MOST_ARGUMENTS = 16 };
    const char *all[MOST_ARGUMENTS + 2] = {""};
    if (severity == LUXEL_SEVERITY_ERROR) {
        walk->failed = true;
        walk->errors++;
    }
    if (!lx_keeps(walk->diagnostics, severity)) {
        lx_report(walk->diagnostics, severity, NULL, message, NULL);
        return;
    }
    struct lx_text path = {0}, end = {0};
    lx_add_path(&path, step);
    lx_add_path_end(&end, step);
    char *key = lx_text_take(&path), *name = lx_text_take(&end);
    if (!key || !name)
        walk->out_of_memory = true;
    place.key = key;
    all[0] = name ? name : "";
    for (size_t i = 0; arguments && arguments[i] && i < MOST_ARGUMENTS; i++)
        all[i + 1] = arguments[i];
    lx_report(walk->diagnostics, severity, &place, message, all);
    free(key);
    free(name);
}

void lx_walk_report(struct lx_walk *walk, luxel_severity severity, struct lx_place place, const struct lx_step *step,
                    enum lx_message message, const char *first, const char *second)
{
    lx_walk_tell(walk, severity, place, step, message, LX_ARGS(LX_WORDS(first ? first : ""), LX_WORDS(second)));
}

/* What is being decoded: the parameter, the way to it and the node. */
struct value {
    struct lx_walk *walk;
    const struct lx_step *step;
    const struct lx_parameter *parameter;
    lx_node_id id;
};

/* Reports that the value is not what `message` wants; `wanted` is {1}, what was found {2}.  Returns false. */
static bool wrong(const struct value *value, enum lx_message message, const char *wanted)
{
    struct lx_text found = {0};
    lx_add_found(&found, value->walk->document, value->id);
    char *words = lx_text_take(&found);
    lx_walk_report(value->walk, LUXEL_SEVERITY_ERROR, lx_document_place(value->walk->document, value->id), value->step,
                   message, wanted, words ? words : "");
    free(words);
    return false;
}

static const char *scalar_text(const struct value *value, bool plain)
{
    const struct lx_node *node = lx_document_node(value->walk->document, value->id);
    bool fits = node->kind == LX_SCALAR && (node->plain || !plain);
    return fits ? lx_document_text(value->walk->document, value->id) : NULL;
}

/* ---- numbers ---- */

bool lx_read_real(const struct lx_document *document, lx_node_id id, double *value)
{
    const struct lx_node *node = lx_document_node(document, id);
    const char *text = lx_document_text(document, id);
    return node->kind == LX_SCALAR && node->plain && lx_read_number(text, strlen(text), value);
}

/* Says why a text is no number, where that can be guessed. */
static void hint_number(const struct value *value)
{
    const struct lx_document *document = value->walk->document;
    luxel_diagnostics *diagnostics = value->walk->diagnostics;
    if (lx_document_node(document, value->id)->kind != LX_SCALAR)
        return;
    const char *text = lx_document_text(document, value->id);
    size_t length = strlen(text), digits = strspn(text, "+-0123456789.");
    const char *word = text + strspn(text, "+-.");
    if (!lx_document_node(document, value->id)->plain) {
        if (lx_looks_like_number(text, length))
            lx_hint(diagnostics, LX_MSG_HINT_QUOTES, NULL);
    } else if (lx_looks_like_number(text, length)) {
        lx_hint(diagnostics, LX_MSG_HINT_TOO_LARGE, NULL);
    } else if (lx_word_distance(word, strlen(word), "nan") == 0 || lx_word_distance(word, strlen(word), "inf") == 0) {
        lx_hint(diagnostics, LX_MSG_HINT_FINITE, NULL);
    } else if (digits > 0 && text[digits] == ',' && strspn(text + digits + 1, "0123456789") > 0) {
        lx_hint(diagnostics, LX_MSG_HINT_POINT, NULL);
    } else if ((digits > 0 && text[digits] && strchr("xo_:", text[digits])) || (unsigned char)text[0] >= 0x80) {
        lx_hint(diagnostics, LX_MSG_HINT_DECIMAL, NULL);
    } else if (digits > 0 && lx_looks_like_number(text, digits)) {
        lx_hint(diagnostics, LX_MSG_HINT_NO_UNIT, NULL);
    }
}

static char *range_words(const struct value *value)
{
    struct lx_text text = {0};
    if (value->parameter->legal.given)
        lx_add_range(&text, &value->parameter->legal, lx_unit_word(value->parameter->unit, value->walk->photometric));
    return lx_text_take(&text);
}

static bool not_a_number(const struct value *value, enum lx_message message)
{
    struct lx_text text = {0};
    char *range = range_words(value);
    if (range && range[0]) {
        lx_text_puts(&text, " ");
        lx_text_puts(&text, range);
    }
    free(range);
    char *words = lx_text_take(&text);
    wrong(value, message, words ? words : "");
    free(words);
    double read;
    if (message == LX_MSG_WRONG_WHOLE && lx_read_real(value->walk->document, value->id, &read))
        lx_hint(value->walk->diagnostics, LX_MSG_HINT_WHOLE, NULL);
    else
        hint_number(value);
    return false;
}

static bool out_of_range(const struct value *value)
{
    char *range = range_words(value);
    wrong(value, LX_MSG_OUT_OF_RANGE, range ? range : "");
    free(range);
    return false;
}

bool lx_interval_holds(const struct lx_interval *range, double number)
{
    if (!range->given)
        return true;
    return (range->low_open ? number > range->low : number >= range->low) && number <= range->high;
}

static bool decode_real(const struct value *value, double *number)
{
    double read;
    if (!lx_read_real(value->walk->document, value->id, &read))
        return not_a_number(value, LX_MSG_WRONG_NUMBER);
    if (!lx_interval_holds(&value->parameter->legal, read))
        return out_of_range(value);
    *number = read;
    return true;
}

static bool decode_whole(const struct value *value, unsigned *number)
{
    double read;
    const char *text = scalar_text(value, true);
    size_t sign = text && (text[0] == '-' || text[0] == '+');
    if (!text || !text[sign] || text[sign + strspn(text + sign, "0123456789")])
        return not_a_number(value, LX_MSG_WRONG_WHOLE);
    if (!lx_read_number(text, strlen(text), &read) || !lx_interval_holds(&value->parameter->legal, read) || read < 0 ||
        read > UINT32_MAX)
        return out_of_range(value);
    *number = (unsigned)read;
    return true;
}

/* ---- words ---- */

static bool decode_boolean(const struct value *value, bool *boolean)
{
    const char *text = scalar_text(value, true);
    if (text && (strcmp(text, "true") == 0 || strcmp(text, "false") == 0)) {
        *boolean = text[0] == 't';
        return true;
    }
    wrong(value, LX_MSG_WRONG_BOOLEAN, NULL);
    text = scalar_text(value, false);
    if (text && (strcmp(text, "true") == 0 || strcmp(text, "false") == 0)) {
        lx_hint(value->walk->diagnostics, LX_MSG_HINT_QUOTES, NULL);
    } else if (text) {
        struct lx_nearest nearest = {.word = text, .length = strlen(text)};
        lx_nearest_offer(&nearest, "true");
        lx_nearest_offer(&nearest, "false");
        lx_hint_nearest(value->walk->diagnostics, &nearest);
    }
    return false;
}

static bool decode_choice(const struct value *value, enum lx_message message, int *choice)
{
    const char *text = scalar_text(value, false);
    const char *const *choices = value->parameter->choices;
    struct lx_nearest nearest = {.word = text ? text : "", .length = text ? strlen(text) : 0};
    for (int i = 0; choices[i]; i++) {
        if (text && strcmp(text, choices[i]) == 0) {
            *choice = i;
            return true;
        }
        lx_nearest_offer(&nearest, choices[i]);
    }
    struct lx_text words = {0};
    lx_add_choices(&words, choices);
    char *known = lx_text_take(&words);
    wrong(value, message, known ? known : "");
    free(known);
    lx_hint_nearest(value->walk->diagnostics, &nearest);
    return false;
}

static bool decode_text(const struct value *value, const char **text)
{
    const char *read = scalar_text(value, false);
    bool plain = lx_document_node(value->walk->document, value->id)->plain;
    if (!read || (plain && !lx_plain_is_text(read))) {
        wrong(value, LX_MSG_WRONG_TEXT, NULL);
        if (read && read[0])
            lx_hint(value->walk->diagnostics, LX_MSG_HINT_PUT_QUOTES, NULL);
        return false;
    }
    *text = read;
    return true;
}

/* ---- lists of numbers ---- */

static bool wrong_length(const struct value *value, unsigned wanted, size_t found)
{
    char wanted_words[24], found_words[24];
    snprintf(wanted_words, sizeof wanted_words, "%u", wanted);
    snprintf(found_words, sizeof found_words, "%zu", found);
    lx_walk_report(value->walk, LUXEL_SEVERITY_ERROR, lx_document_place(value->walk->document, value->id), value->step,
                   LX_MSG_WRONG_LENGTH, wanted_words, found_words);
    if (lx_has_decimal_commas(value->walk->document, value->id, wanted))
        lx_hint(value->walk->diagnostics, LX_MSG_HINT_POINT, NULL);
    return false;
}

/* Decodes each number of a list of value->parameter->count into `wholes` or, where that is NULL, `reals`. */
static bool decode_numbers(const struct value *value, double *reals, unsigned *wholes)
{
    const struct lx_document *document = value->walk->document;
    unsigned count = value->parameter->count;
    if (lx_document_node(document, value->id)->kind != LX_SEQUENCE) {
        char words[24];
        snprintf(words, sizeof words, "%u", count);
        return wrong(value, wholes ? LX_MSG_WRONG_WHOLES : LX_MSG_WRONG_NUMBERS, words);
    }
    size_t found = lx_document_size(document, value->id);
    if (found != count)
        return wrong_length(value, count, found);
    bool good = true, zero = true;
    lx_node_id id = lx_document_node(document, value->id)->first;
    for (unsigned i = 0; i < count; i++, id = lx_document_node(document, id)->next) {
        struct lx_step step = {value->step, NULL, i};
        struct value part = {value->walk, &step, value->parameter, id};
        bool read = wholes ? decode_whole(&part, &wholes[i]) : decode_real(&part, &reals[i]);
        good = good && read;
        zero = zero && !(good && reals && reals[i] != 0);
    }
    if (good && value->parameter->nonzero && zero) {
        lx_walk_report(value->walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, value->id), value->step,
                       value->parameter->legal.given ? LX_MSG_ALL_ZERO : LX_MSG_ZERO_VECTOR, NULL, NULL);
        return false;
    }
    return good;
}

/* A list of lists of `width` numbers each, one behind the other; *numbers is the caller's, also after an error. */
static bool decode_tuples(const struct value *value, unsigned width, double **numbers, size_t *count)
{
    const struct lx_document *document = value->walk->document;
    size_t i = 0;
    *count = lx_document_size(document, value->id);
    *numbers = lx_new_array(*count, width * sizeof **numbers);
    if (!*numbers) {
        value->walk->out_of_memory = true;
        return false;
    }
    bool good = true;
    struct lx_parameter tuple = *value->parameter;
    tuple.count = width;
    for (lx_node_id id = lx_document_node(document, value->id)->first; id; id = lx_document_node(document, id)->next) {
        struct lx_step step = {value->step, NULL, i};
        struct value part = {value->walk, &step, &tuple, id};
        good = decode_numbers(&part, *numbers + width * i++, NULL) && good;
    }
    return good;
}

static bool is_list(const struct value *value)
{
    return lx_document_node(value->walk->document, value->id)->kind == LX_SEQUENCE;
}

static bool decode_points(const struct value *value, struct lx_points *points)
{
    double *numbers = NULL;
    if (!is_list(value))
        return wrong(value, LX_MSG_WRONG_POINTS, NULL);
    bool good = decode_tuples(value, 2, &numbers, &points->count);
    points->xy = (double(*)[2])numbers;
    points->count = good ? points->count : 0;
    return good;
}

static bool decode_vectors(const struct value *value, struct lx_vectors *vectors)
{
    const struct lx_document *document = value->walk->document;
    double *numbers = NULL;
    if (!is_list(value))
        return wrong(value, LX_MSG_WRONG_VECTORS, NULL);
    size_t found = lx_document_size(document, value->id);
    if (found < value->parameter->count) {
        char least[24], words[24];
        snprintf(least, sizeof least, "%u", value->parameter->count);
        snprintf(words, sizeof words, "%zu", found);
        lx_walk_report(value->walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, value->id), value->step,
                       LX_MSG_TOO_FEW_VECTORS, least, words);
        return false;
    }
    bool good = decode_tuples(value, 3, &numbers, &vectors->count);
    vectors->xyz = (double(*)[3])numbers;
    vectors->count = good ? vectors->count : 0;
    return good;
}

/* What has the form of a number is meant as one. */
static bool decode_choice_or_whole(const struct value *value, struct lx_choice_or_whole *result)
{
    const char *text = scalar_text(value, true);
    struct lx_choice_or_whole read = {.choice = -1};
    bool good = text && lx_looks_like_number(text, strlen(text))
                    ? decode_whole(value, &read.whole)
                    : decode_choice(value, LX_MSG_WRONG_CHOICE_OR_WHOLE, &read.choice);
    if (good)
        *result = read;
    return good;
}

static bool decode_choice_or_pair(const struct value *value, struct lx_choice_or_pair *result)
{
    if (lx_document_node(value->walk->document, value->id)->kind != LX_SEQUENCE)
        return decode_choice(value, LX_MSG_WRONG_CHOICE_OR_PAIR, &result->choice);
    double pair[2];
    struct lx_parameter numbers = *value->parameter;
    numbers.count = 2;
    struct value list = {value->walk, value->step, &numbers, value->id};
    if (!decode_numbers(&list, pair, NULL))
        return false;
    if (!(pair[0] < pair[1])) {
        char low[LX_NUMBER_SIZE], high[LX_NUMBER_SIZE];
        lx_walk_report(value->walk, LUXEL_SEVERITY_ERROR, lx_document_place(value->walk->document, value->id),
                       value->step, LX_MSG_WRONG_PAIR, lx_write_number(pair[0], low), lx_write_number(pair[1], high));
        return false;
    }
    *result = (struct lx_choice_or_pair){-1, pair[0], pair[1]};
    return true;
}

bool lx_decode_value(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                     lx_node_id id, void *value)
{
    struct value v = {walk, step, parameter, id};
    if (parameter->type == LX_ANY) {
        *(lx_node_id *)value = id;
        return true;
    }
    switch (parameter->type) {
    case LX_REAL: return decode_real(&v, value);
    case LX_WHOLE: return decode_whole(&v, value);
    case LX_BOOLEAN: return decode_boolean(&v, value);
    case LX_CHOICE: return decode_choice(&v, LX_MSG_WRONG_CHOICE, value);
    case LX_TEXT: return decode_text(&v, value);
    case LX_REALS: return decode_numbers(&v, value, NULL);
    case LX_WHOLES: return decode_numbers(&v, NULL, value);
    case LX_CHOICE_OR_PAIR: return decode_choice_or_pair(&v, value);
    case LX_CHOICE_OR_WHOLE: return decode_choice_or_whole(&v, value);
    case LX_POINTS: return decode_points(&v, value);
    case LX_VECTORS: return decode_vectors(&v, value);
    case LX_GROUP: return decode_choice(&v, LX_MSG_WRONG_CHOICE_OR_GROUP, value); /* a word instead of the keys */
    case LX_GROUPS:
    case LX_VARIANTS: break; /* they hold tables of their own */
    }
    return false;
}

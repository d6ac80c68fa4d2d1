/* SPDX-License-Identifier: MIT */
/* The parser of formulas: recursive descent over the notation, limited in depth. */
#include "formula.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

enum { DEEPEST = 40 };

struct parser {
    const char *at;
    int depth;
    bool failed, starved; /* no more of it is parsed; because out of memory */
};

void lx_formula_free(struct lx_formula *formula)
{
    if (!formula)
        return;
    for (size_t i = 0; i < formula->count; i++)
        lx_formula_free(formula->children[i]);
    free(formula->children);
    free(formula->text);
    free(formula);
}

/* A formula of this type with `count` children, none of them there yet. */
static struct lx_formula *new_formula(struct parser *parser, enum lx_formula_type type, const char *text, size_t length,
                                      size_t count)
{
    struct lx_formula *made = lx_new_array(1, sizeof *made);
    if (made) {
        made->type = type;
        made->text = text ? lx_copy_text(text, length) : NULL;
        made->children = lx_new_array(count > 0 ? count : 1, sizeof *made->children);
        made->count = count;
    }
    if (made && made->children && (made->text || !text))
        return made;
    if (made && !made->children)
        made->count = 0;
    lx_formula_free(made);
    parser->failed = parser->starved = true;
    return NULL;
}

static struct lx_formula *sign(struct parser *parser, enum lx_formula_type type, const char *text)
{
    return new_formula(parser, type, text, strlen(text), 0);
}

static void append(struct parser *parser, struct lx_formula *row, struct lx_formula *child)
{
    if (!child)
        return;
    struct lx_formula **longer = realloc(row->children, (row->count + 1) * sizeof *longer);
    if (!longer) {
        lx_formula_free(child);
        parser->failed = parser->starved = true;
        return;
    }
    row->children = longer;
    row->children[row->count++] = child;
}

/* ---- words of the notation ---- */

struct word {
    const char *name;
    enum lx_formula_type type;
    const char *text;
    double width;
};

static const struct word words[] = {
    {"cdot", LX_FORMULA_OPERATOR, "·", 0},       {"times", LX_FORMULA_OPERATOR, "×", 0},
    {"le", LX_FORMULA_OPERATOR, "≤", 0},         {"ge", LX_FORMULA_OPERATOR, "≥", 0},
    {"ne", LX_FORMULA_OPERATOR, "≠", 0},         {"approx", LX_FORMULA_OPERATOR, "≈", 0},
    {"pm", LX_FORMULA_OPERATOR, "±", 0},         {"to", LX_FORMULA_OPERATOR, "→", 0},
    {"perp", LX_FORMULA_UPRIGHT, "⊥", 0},        {"infty", LX_FORMULA_UPRIGHT, "∞", 0},
    {"degree", LX_FORMULA_UPRIGHT, "°", 0},      {"sum", LX_FORMULA_UPRIGHT, "∑", 0},
    {"int", LX_FORMULA_UPRIGHT, "∫", 0},         {"max", LX_FORMULA_UPRIGHT, "max", 0},
    {"min", LX_FORMULA_UPRIGHT, "min", 0},       {"cos", LX_FORMULA_UPRIGHT, "cos", 0},
    {"sin", LX_FORMULA_UPRIGHT, "sin", 0},       {"tan", LX_FORMULA_UPRIGHT, "tan", 0},
    {"log", LX_FORMULA_UPRIGHT, "log", 0},       {"exp", LX_FORMULA_UPRIGHT, "exp", 0},
    {"arctan", LX_FORMULA_UPRIGHT, "arctan", 0}, {"arccos", LX_FORMULA_UPRIGHT, "arccos", 0},
    {"alpha", LX_FORMULA_LETTER, "α", 0},        {"beta", LX_FORMULA_LETTER, "β", 0},
    {"gamma", LX_FORMULA_LETTER, "γ", 0},        {"delta", LX_FORMULA_LETTER, "δ", 0},
    {"varepsilon", LX_FORMULA_LETTER, "ε", 0},   {"eta", LX_FORMULA_LETTER, "η", 0},
    {"theta", LX_FORMULA_LETTER, "θ", 0},        {"lambda", LX_FORMULA_LETTER, "λ", 0},
    {"mu", LX_FORMULA_LETTER, "μ", 0},           {"nu", LX_FORMULA_LETTER, "ν", 0},
    {"pi", LX_FORMULA_LETTER, "π", 0},           {"rho", LX_FORMULA_LETTER, "ρ", 0},
    {"sigma", LX_FORMULA_LETTER, "σ", 0},        {"tau", LX_FORMULA_LETTER, "τ", 0},
    {"varphi", LX_FORMULA_LETTER, "φ", 0},       {"omega", LX_FORMULA_LETTER, "ω", 0},
    {"Delta", LX_FORMULA_UPRIGHT, "Δ", 0},       {"Sigma", LX_FORMULA_UPRIGHT, "Σ", 0},
    {"Phi", LX_FORMULA_UPRIGHT, "Φ", 0},         {"Omega", LX_FORMULA_UPRIGHT, "Ω", 0},
    {"lfloor", LX_FORMULA_FENCE, "⌊", 0},        {"rfloor", LX_FORMULA_FENCE, "⌋", 0},
    {"quad", LX_FORMULA_SPACE, "", 1},           {"qquad", LX_FORMULA_SPACE, "", 2},
};

/* Commands of which the braces hold words or a letter. */
static const struct word lettered[] = {
    {"mathbf", LX_FORMULA_BOLD, NULL, 0},
    {"mathrm", LX_FORMULA_UPRIGHT, NULL, 0},
    {"text", LX_FORMULA_WORDS, NULL, 0},
};

static const struct word accents[] = {
    {"vec", LX_FORMULA_ACCENT, "→", 0},
    {"hat", LX_FORMULA_ACCENT, "^", 0},
};

static const struct word *find_word(const struct word *list, size_t count, const char *name, size_t length)
{
    for (size_t i = 0; i < count; i++)
        if (strncmp(list[i].name, name, length) == 0 && !list[i].name[length])
            return &list[i];
    return NULL;
}

#define FIND(list, name, length) find_word(list, sizeof(list) / sizeof(list)[0], name, length)

/* ---- the grammar ---- */

static struct lx_formula *parse_row(struct parser *parser);

static bool take(struct parser *parser, const char *text)
{
    size_t length = strlen(text);
    if (strncmp(parser->at, text, length) != 0)
        return false;
    parser->at += length;
    return true;
}

static void skip_blanks(struct parser *parser)
{
    while (*parser->at == ' ')
        parser->at++;
}

/* { row } */
static struct lx_formula *parse_braces(struct parser *parser)
{
    if (!take(parser, "{")) {
        parser->failed = true;
        return NULL;
    }
    struct lx_formula *row = parse_row(parser);
    if (!take(parser, "}"))
        parser->failed = true;
    return row;
}

/* \mathbf{N}: the braces hold plain characters, none of which means anything in LaTeX. */
static struct lx_formula *parse_lettered(struct parser *parser, enum lx_formula_type type)
{
    const char *start = parser->at + 1;
    size_t length = *parser->at == '{' ? strcspn(start, "{}\\$&#^_~%\"\n") : 0;
    if (*parser->at != '{' || start[length] != '}') {
        parser->failed = true;
        return NULL;
    }
    parser->at = start + length + 1;
    return new_formula(parser, type, start, length, 0);
}

/* A command with one or two pairs of braces behind it. */
static struct lx_formula *parse_parts(struct parser *parser, enum lx_formula_type type, const char *text, size_t count)
{
    struct lx_formula *made = new_formula(parser, type, text, text ? strlen(text) : 0, count);
    for (size_t i = 0; made && i < count && !parser->failed; i++)
        made->children[i] = parse_braces(parser);
    return made;
}

/* Behind \left or \right: a bracket as tall as what the two hold. */
static struct lx_formula *parse_tall_fence(struct parser *parser, bool closes)
{
    if (!*parser->at || !strchr("()[]|.", *parser->at)) {
        parser->failed = true;
        return NULL;
    }
    struct lx_formula *made = new_formula(parser, LX_FORMULA_FENCE, parser->at, *parser->at == '.' ? 0 : 1, 0);
    if (made) {
        made->tall = true;
        made->closes = closes;
    }
    parser->at++;
    return made;
}

/* Behind \left: a row of its own, to which what stands below and above belongs. */
static struct lx_formula *parse_fenced(struct parser *parser)
{
    struct lx_formula *row = new_formula(parser, LX_FORMULA_ROW, NULL, 0, 0);
    if (!row)
        return NULL;
    append(parser, row, parse_tall_fence(parser, false));
    if (!parser->failed)
        append(parser, row, parse_row(parser));
    if (!parser->failed && take(parser, "\\right"))
        append(parser, row, parse_tall_fence(parser, true));
    else
        parser->failed = true;
    return row;
}

static struct lx_formula *parse_space(struct parser *parser, double width)
{
    struct lx_formula *made = sign(parser, LX_FORMULA_SPACE, "");
    if (made)
        made->width = width;
    return made;
}

/* Behind a backslash. */
static struct lx_formula *parse_command(struct parser *parser)
{
    if (take(parser, ","))
        return parse_space(parser, 1.0 / 6);
    if (take(parser, ";"))
        return parse_space(parser, 5.0 / 18);
    if (take(parser, "%"))
        return sign(parser, LX_FORMULA_UPRIGHT, "%");
    const char *name = parser->at;
    size_t length = 0;
    while ((name[length] >= 'a' && name[length] <= 'z') || (name[length] >= 'A' && name[length] <= 'Z'))
        length++;
    parser->at += length;
    const struct word *word = FIND(words, name, length), *letters = FIND(lettered, name, length);
    const struct word *accent = FIND(accents, name, length);
    if (word) {
        struct lx_formula *made = sign(parser, word->type, word->text);
        if (made)
            made->width = word->width;
        if (made && word->type == LX_FORMULA_FENCE)
            made->closes = *word->name == 'r';
        return made;
    }
    if (letters)
        return parse_lettered(parser, letters->type);
    if (accent)
        return parse_parts(parser, LX_FORMULA_ACCENT, accent->text, 1);
    if (length == 4 && strncmp(name, "frac", 4) == 0)
        return parse_parts(parser, LX_FORMULA_FRACTION, NULL, 2);
    if (length == 4 && strncmp(name, "sqrt", 4) == 0)
        return parse_parts(parser, LX_FORMULA_ROOT, NULL, 1);
    if (length == 4 && strncmp(name, "left", 4) == 0)
        return parse_fenced(parser);
    parser->at = name;
    parser->failed = true;
    return NULL;
}

static struct lx_formula *parse_number(struct parser *parser)
{
    size_t length = strspn(parser->at, "0123456789");
    if (parser->at[length] == '.' && parser->at[length + 1] >= '0' && parser->at[length + 1] <= '9')
        length += 1 + strspn(parser->at + length + 1, "0123456789");
    struct lx_formula *made = new_formula(parser, LX_FORMULA_NUMBER, parser->at, length, 0);
    parser->at += length;
    return made;
}

/* One sign, group or command, without what may stand below or above it. */
static struct lx_formula *parse_nucleus(struct parser *parser)
{
    char c = *parser->at;
    if (take(parser, "\\"))
        return parse_command(parser);
    if (c == '{')
        return parse_braces(parser);
    if (c >= '0' && c <= '9')
        return parse_number(parser);
    if (c == '&' && parser->depth == 1) {
        parser->at++;
        return parse_space(parser, 0);
    }
    if (take(parser, "-"))
        return sign(parser, LX_FORMULA_OPERATOR, "−");
    const char *start = parser->at;
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
        parser->at++;
        return new_formula(parser, LX_FORMULA_LETTER, start, 1, 0);
    }
    if (c && strchr("+=<>/", c)) {
        parser->at++;
        return new_formula(parser, LX_FORMULA_OPERATOR, start, 1, 0);
    }
    if (c && strchr("()[]|,.;:!'", c)) {
        struct lx_formula *made =
            new_formula(parser, strchr("()[]|", c) ? LX_FORMULA_FENCE : LX_FORMULA_UPRIGHT, start, 1, 0);
        if (made)
            made->closes = c == ')' || c == ']';
        parser->at++;
        return made;
    }
    if (take(parser, "⊥"))
        return sign(parser, LX_FORMULA_UPRIGHT, "⊥");
    if (take(parser, "°"))
        return sign(parser, LX_FORMULA_UPRIGHT, "°");
    parser->failed = true;
    return NULL;
}

/* What stands below or above: a group, or one sign. */
static struct lx_formula *parse_script(struct parser *parser)
{
    skip_blanks(parser);
    return *parser->at == '{' ? parse_braces(parser) : parse_nucleus(parser);
}

static struct lx_formula *parse_scripted(struct parser *parser)
{
    struct lx_formula *base = parse_nucleus(parser);
    if (parser->failed || (*parser->at != '_' && *parser->at != '^'))
        return base;
    struct lx_formula *made = new_formula(parser, LX_FORMULA_SCRIPTS, NULL, 0, 3);
    if (!made) {
        lx_formula_free(base);
        return NULL;
    }
    made->children[0] = base;
    while (!parser->failed && (*parser->at == '_' || *parser->at == '^')) {
        size_t place = *parser->at++ == '_' ? 1 : 2;
        if (made->children[place])
            parser->failed = true;
        else
            made->children[place] = parse_script(parser);
    }
    return made;
}

static bool ends_row(const char *at)
{
    return !*at || *at == '}' || strncmp(at, "\\\\", 2) == 0 || strncmp(at, "\\right", 6) == 0;
}

/* Signs up to a closing brace, a new line or a \right. */
static struct lx_formula *parse_row(struct parser *parser)
{
    struct lx_formula *row = new_formula(parser, LX_FORMULA_ROW, NULL, 0, 0);
    if (!row || ++parser->depth > DEEPEST) {
        parser->failed = true;
        return row;
    }
    for (skip_blanks(parser); !ends_row(parser->at); skip_blanks(parser)) {
        append(parser, row, parse_scripted(parser));
        if (parser->failed)
            return row;
    }
    parser->depth--;
    return row;
}

struct lx_formula *lx_formula_parse(const char *notation, size_t *at)
{
    struct parser parser = {.at = notation};
    struct lx_formula *lines = new_formula(&parser, LX_FORMULA_LINES, NULL, 0, 0);
    while (lines && !parser.failed) {
        append(&parser, lines, parse_row(&parser));
        if (parser.failed || !take(&parser, "\\\\"))
            break;
    }
    if (!parser.failed && !*parser.at) {
        if (lines->count > 1)
            return lines;
        struct lx_formula *only = lines->children[0];
        lines->count = 0;
        lx_formula_free(lines);
        return only;
    }
    if (at)
        *at = parser.starved ? SIZE_MAX : (size_t)(parser.at - notation);
    lx_formula_free(lines);
    return NULL;
}

/* ---- what writers ask ---- */

const struct lx_formula *lx_formula_nucleus(const struct lx_formula *formula)
{
    return formula->type == LX_FORMULA_SCRIPTS ? formula->children[0] : formula;
}

bool lx_formula_is_fence(const struct lx_formula *formula, bool closes)
{
    return formula->type == LX_FORMULA_FENCE && strcmp(formula->text, "|") != 0 && formula->closes == closes;
}

bool lx_formula_is_word(const struct lx_formula *formula)
{
    const struct lx_formula *name = lx_formula_nucleus(formula);
    char first = name->type == LX_FORMULA_UPRIGHT ? name->text[0] : '\0';
    return ((first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z')) && name->text[1];
}

bool lx_formula_is_comma(const struct lx_formula *formula)
{
    return formula->type == LX_FORMULA_UPRIGHT && (strcmp(formula->text, ",") == 0 || strcmp(formula->text, ";") == 0);
}

bool lx_formula_is_sign(const struct lx_formula *row, size_t i)
{
    const char *sign = row->children[i]->text;
    size_t k = i;
    if (row->children[i]->type != LX_FORMULA_OPERATOR ||
        (strcmp(sign, "−") != 0 && strcmp(sign, "+") != 0 && strcmp(sign, "±") != 0))
        return false;
    while (k > 0 && row->children[k - 1]->type == LX_FORMULA_SPACE)
        k--;
    if (k == 0)
        return true;
    const struct lx_formula *before = row->children[k - 1];
    return before->type == LX_FORMULA_OPERATOR || lx_formula_is_fence(before, false) || lx_formula_is_comma(before);
}

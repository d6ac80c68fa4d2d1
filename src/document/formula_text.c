/* SPDX-License-Identifier: MIT */
/* Formulas in one line of Unicode, for terminals. */
#include <string.h>

#include "formula.h"

/* A sign and how it stands below and above others; NULL where Unicode has none. */
struct script {
    const char *plain, *below, *above;
};

static const struct script scripts[] = {
    {"0", "₀", "⁰"}, {"1", "₁", "¹"}, {"2", "₂", "²"}, {"3", "₃", "³"}, {"4", "₄", "⁴"}, {"5", "₅", "⁵"},
    {"6", "₆", "⁶"}, {"7", "₇", "⁷"}, {"8", "₈", "⁸"}, {"9", "₉", "⁹"}, {"−", "₋", "⁻"}, {"+", "₊", "⁺"},
    {"=", "₌", "⁼"}, {"n", "ₙ", "ⁿ"}, {"i", "ᵢ", "ⁱ"}, {"m", "ₘ", "ᵐ"}, {"k", "ₖ", "ᵏ"}, {"a", "ₐ", "ᵃ"},
    {"e", "ₑ", "ᵉ"}, {"s", "ₛ", "ˢ"}, {"x", "ₓ", "ˣ"}, {"p", "ₚ", "ᵖ"}, {"t", "ₜ", "ᵗ"}, {"j", "ⱼ", "ʲ"},
    {"r", "ᵣ", "ʳ"}, {"o", "ₒ", "ᵒ"}, {"l", "ₗ", "ˡ"}, {"h", "ₕ", "ʰ"}, {"v", "ᵥ", "ᵛ"}, {"u", "ᵤ", "ᵘ"},
};

static void add(struct lx_text *text, const struct lx_formula *formula);

/* The sign of a plain child as it stands below or above; NULL where there is none. */
static const char *script_of(const struct lx_formula *sign, bool above)
{
    for (size_t i = 0; sign->text && i < sizeof scripts / sizeof scripts[0]; i++)
        if (strcmp(sign->text, scripts[i].plain) == 0)
            return above ? scripts[i].above : scripts[i].below;
    return NULL;
}

/* Digits of a number one by one, other signs as a whole; false where Unicode lacks one of them. */
static bool add_script_signs(struct lx_text *text, const struct lx_formula *formula, bool above)
{
    if (formula->type == LX_FORMULA_ROW) {
        for (size_t i = 0; i < formula->count; i++)
            if (!add_script_signs(text, formula->children[i], above))
                return false;
        return true;
    }
    if (formula->type != LX_FORMULA_NUMBER && formula->type != LX_FORMULA_LETTER &&
        formula->type != LX_FORMULA_UPRIGHT && formula->type != LX_FORMULA_OPERATOR)
        return false;
    if (formula->type == LX_FORMULA_OPERATOR || strlen(formula->text) == 1) {
        const char *sign = script_of(formula, above);
        if (sign)
            lx_text_puts(text, sign);
        return sign != NULL;
    }
    for (const char *at = formula->text; *at; at++) {
        char one[2] = {*at, '\0'};
        const char *sign = script_of(&(struct lx_formula){.text = one}, above);
        if (!sign)
            return false;
        lx_text_puts(text, sign);
    }
    return true;
}

/* Whether a row is held by a \left and its \right. */
static bool is_fenced(const struct lx_formula *formula)
{
    return formula->type == LX_FORMULA_ROW && formula->count > 0 && formula->children[0]->type == LX_FORMULA_FENCE &&
           formula->children[0]->tall;
}

/* Whether a part must be bracketed where it meets a stronger bond, such as a fraction's line. */
static bool is_compound(const struct lx_formula *formula)
{
    int depth = 0;
    bool in_bars = false;
    if (formula->type == LX_FORMULA_FRACTION)
        return true;
    for (size_t i = 0; formula->type == LX_FORMULA_ROW && i < formula->count; i++) {
        const struct lx_formula *child = formula->children[i];
        bool is_sign = child->type == LX_FORMULA_OPERATOR || child->type == LX_FORMULA_FRACTION;
        bool is_row = child->type == LX_FORMULA_ROW && !is_fenced(child) && is_compound(child);
        depth += lx_formula_is_fence(child, false) ? 1 : lx_formula_is_fence(child, true) ? -1 : 0;
        in_bars ^= child->type == LX_FORMULA_FENCE && strcmp(child->text, "|") == 0;
        if ((is_sign || is_row) && depth == 0 && !in_bars)
            return true;
    }
    return false;
}

static void add_bracketed(struct lx_text *text, const struct lx_formula *formula, bool brackets)
{
    lx_text_puts(text, brackets ? "(" : "");
    add(text, formula);
    lx_text_puts(text, brackets ? ")" : "");
}

static bool is_single(const struct lx_formula *formula)
{
    if (formula->type == LX_FORMULA_WORDS)
        return !strchr(formula->text, ' ');
    return formula->type == LX_FORMULA_ROW
               ? is_fenced(formula) || (formula->count == 1 && is_single(formula->children[0]))
               : formula->type != LX_FORMULA_FRACTION;
}

static void add_scripts(struct lx_text *text, const struct lx_formula *formula)
{
    add_bracketed(text, formula->children[0], is_compound(formula->children[0]));
    for (int place = 1; place < 3; place++) {
        const struct lx_formula *child = formula->children[place];
        struct lx_text signs = {0};
        if (!child)
            continue;
        if (add_script_signs(&signs, child, place == 2) && signs.bytes) {
            lx_text_puts(text, signs.bytes);
        } else {
            lx_text_puts(text, place == 1 ? "_" : "^");
            add_bracketed(text, child, !is_single(child));
        }
        text->failed = text->failed || signs.failed;
        lx_text_clear(&signs);
    }
}

/* Something that is multiplied by what stands beside it. */
static bool is_factor(const struct lx_formula *formula)
{
    const struct lx_formula *sign = lx_formula_nucleus(formula);
    bool is_mark =
        sign->type == LX_FORMULA_UPRIGHT && (strchr(",.;:!'%", sign->text[0]) || strcmp(sign->text, "°") == 0);
    return sign->type != LX_FORMULA_OPERATOR && sign->type != LX_FORMULA_SPACE && sign->type != LX_FORMULA_WORDS &&
           !lx_formula_is_fence(sign, true) && !is_mark;
}

/* Whether the scripts of a sign had no Unicode, so that what follows would seem to belong to them. */
static bool has_plain_script(struct lx_text *text, const struct lx_formula *formula)
{
    bool plain = false;
    for (size_t place = 1; formula->type == LX_FORMULA_SCRIPTS && place < 3; place++) {
        struct lx_text signs = {0};
        plain = plain || (formula->children[place] && !add_script_signs(&signs, formula->children[place], place == 2));
        text->failed = text->failed || signs.failed;
        lx_text_clear(&signs);
    }
    return plain;
}

static bool are_set_apart(struct lx_text *text, const struct lx_formula *left, const struct lx_formula *right)
{
    bool opens = lx_formula_is_fence(lx_formula_nucleus(right), false) || is_fenced(lx_formula_nucleus(right));
    if (lx_formula_is_fence(left, false))
        return false;
    if (lx_formula_is_comma(left))
        return right->type != LX_FORMULA_SPACE && !lx_formula_is_fence(right, true);
    if (!is_factor(right))
        return false;
    if (!is_factor(left) && !lx_formula_is_fence(lx_formula_nucleus(left), true))
        return false;
    if (lx_formula_is_word(left))
        return !opens;
    if (left->type == LX_FORMULA_SCRIPTS && lx_formula_nucleus(left)->type == LX_FORMULA_UPRIGHT)
        return true; /* a sum with its limits */
    return lx_formula_is_word(right) || left->type == LX_FORMULA_FRACTION || right->type == LX_FORMULA_FRACTION ||
           lx_formula_nucleus(right)->type == LX_FORMULA_NUMBER || (has_plain_script(text, left) && !opens) ||
           lx_formula_nucleus(right)->type == LX_FORMULA_UPRIGHT;
}

/* A fraction that is multiplied by what follows. */
static bool is_divided_factor(const struct lx_formula *row, size_t i)
{
    size_t k = i + 1;
    while (k < row->count && row->children[k]->type == LX_FORMULA_SPACE)
        k++;
    return row->children[i]->type == LX_FORMULA_FRACTION && k < row->count && is_factor(row->children[k]) &&
           row->children[k]->type != LX_FORMULA_WORDS;
}

static void add_row(struct lx_text *text, const struct lx_formula *row)
{
    for (size_t i = 0; i < row->count; i++) {
        const struct lx_formula *child = row->children[i];
        bool is_operator = child->type == LX_FORMULA_OPERATOR && !lx_formula_is_sign(row, i);
        bool begins = i == 0 || (i == 1 && row->children[0]->type == LX_FORMULA_SPACE);
        if ((is_operator && !begins) || (i > 0 && are_set_apart(text, row->children[i - 1], child)))
            lx_text_puts(text, " ");
        add_bracketed(text, child, is_divided_factor(row, i));
        if (is_operator)
            lx_text_puts(text, " ");
    }
}

static void add(struct lx_text *text, const struct lx_formula *formula)
{
    if (!formula)
        return;
    switch (formula->type) {
    case LX_FORMULA_ROW: add_row(text, formula); break;
    case LX_FORMULA_FRACTION:
        add_bracketed(text, formula->children[0], is_compound(formula->children[0]));
        lx_text_puts(text, " / ");
        add_bracketed(text, formula->children[1], is_compound(formula->children[1]));
        break;
    case LX_FORMULA_ROOT:
        lx_text_puts(text, "√");
        add_bracketed(text, formula->children[0], !is_single(formula->children[0]));
        break;
    case LX_FORMULA_SCRIPTS: add_scripts(text, formula); break;
    case LX_FORMULA_ACCENT:
        add(text, formula->children[0]);
        lx_text_puts(text, strcmp(formula->text, "^") == 0 ? "\xcc\x82" : "\xe2\x83\x97");
        break;
    case LX_FORMULA_SPACE: lx_text_puts(text, formula->width > 0.9 ? "   " : formula->width > 0.1 ? " " : ""); break;
    case LX_FORMULA_LINES:
        for (size_t i = 0; i < formula->count; i++) {
            lx_text_puts(text, i > 0 ? "\n" : "");
            add(text, formula->children[i]);
        }
        break;
    default: lx_text_puts(text, formula->text); break;
    }
}

void lx_formula_add_text(struct lx_text *text, const struct lx_formula *formula)
{
    add(text, formula);
}

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
    {"n", "ₙ", "ⁿ"}, {"i", "ᵢ", "ⁱ"}, {"m", "ₘ", "ᵐ"}, {"k", "ₖ", "ᵏ"}, {"a", "ₐ", "ᵃ"}, {"e", "ₑ", "ᵉ"},
    {"s", "ₛ", "ˢ"}, {"x", "ₓ", "ˣ"}, {"p", "ₚ", "ᵖ"}, {"t", "ₜ", "ᵗ"}, {"j", "ⱼ", "ʲ"}, {"r", "ᵣ", "ʳ"},
    {"o", "ₒ", "ᵒ"}, {"l", "ₗ", "ˡ"}, {"h", "ₕ", "ʰ"}, {"v", "ᵥ", "ᵛ"}, {"u", "ᵤ", "ᵘ"},
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

/* Whether a part must be bracketed where it meets a stronger bond, such as a fraction's line. */
static bool is_compound(const struct lx_formula *formula)
{
    int depth = 0;
    if (formula->type == LX_FORMULA_FRACTION)
        return true;
    for (size_t i = 0; formula->type == LX_FORMULA_ROW && i < formula->count; i++) {
        const struct lx_formula *child = formula->children[i];
        bool is_sign = child->type == LX_FORMULA_OPERATOR || child->type == LX_FORMULA_FRACTION;
        if (child->type == LX_FORMULA_FENCE && strchr("([", child->text[0]))
            depth++;
        else if (child->type == LX_FORMULA_FENCE && strchr(")]", child->text[0]))
            depth--;
        else if (is_sign && depth == 0)
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
    return formula->type != LX_FORMULA_ROW ? formula->type != LX_FORMULA_FRACTION
                                           : formula->count == 1 && is_single(formula->children[0]);
}

static void add_scripts(struct lx_text *text, const struct lx_formula *formula)
{
    add(text, formula->children[0]);
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

/* An operator has blanks around it, but for a sign before the first number or behind a bracket or another operator. */
static bool is_prefix(const struct lx_formula *row, size_t i)
{
    size_t k = i;
    while (k > 0 && row->children[k - 1]->type == LX_FORMULA_SPACE)
        k--;
    if (k == 0)
        return true;
    const struct lx_formula *before = row->children[k - 1];
    return before->type == LX_FORMULA_OPERATOR || (before->type == LX_FORMULA_FENCE && strchr("([", before->text[0])) ||
           (before->type == LX_FORMULA_UPRIGHT && strcmp(before->text, ",") == 0);
}

static bool is_function(const struct lx_formula *formula)
{
    const struct lx_formula *name = formula->type == LX_FORMULA_SCRIPTS ? formula->children[0] : formula;
    return name->type == LX_FORMULA_UPRIGHT && name->text[0] >= 'a' && name->text[0] <= 'z' && name->text[1];
}

static void add_row(struct lx_text *text, const struct lx_formula *row)
{
    for (size_t i = 0; i < row->count; i++) {
        const struct lx_formula *child = row->children[i];
        bool is_operator = child->type == LX_FORMULA_OPERATOR && !is_prefix(row, i);
        if (is_operator)
            lx_text_puts(text, " ");
        add(text, child);
        bool before_fence = i + 1 < row->count && row->children[i + 1]->type == LX_FORMULA_FENCE;
        bool comma = child->type == LX_FORMULA_UPRIGHT && strcmp(child->text, ",") == 0;
        bool space_follows = i + 1 < row->count && row->children[i + 1]->type == LX_FORMULA_SPACE;
        if (is_operator || (is_function(child) && !before_fence && i + 1 < row->count) || (comma && !space_follows))
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

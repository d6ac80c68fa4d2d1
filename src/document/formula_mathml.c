/* SPDX-License-Identifier: MIT */
/* Formulas as presentation MathML, which browsers show by themselves. */
#include <string.h>

#include "formula.h"

static void add(struct lx_text *text, const struct lx_formula *formula);

static void add_escaped(struct lx_text *text, const char *plain)
{
    for (; *plain; plain++)
        switch (*plain) {
        case '<': lx_text_puts(text, "&lt;"); break;
        case '>': lx_text_puts(text, "&gt;"); break;
        case '&': lx_text_puts(text, "&amp;"); break;
        default: lx_text_add(text, plain, 1); break;
        }
}

static void add_element(struct lx_text *text, const char *name, const char *attributes, const char *content)
{
    lx_text_printf(text, "<%s%s>", name, attributes);
    add_escaped(text, content);
    lx_text_printf(text, "</%s>", name);
}

/* Browsers set a function no further from its neighbours than a factor. */
static void add_thin_space(struct lx_text *text)
{
    lx_text_puts(text, "<mspace width=\"0.17em\"></mspace>");
}

static bool opens(const struct lx_formula *formula)
{
    const struct lx_formula *first = lx_formula_nucleus(formula);
    if (first->type == LX_FORMULA_ROW && first->count > 0)
        first = first->children[0];
    return lx_formula_is_fence(first, false);
}

static bool is_tight(const struct lx_formula *formula)
{
    return formula->type == LX_FORMULA_OPERATOR || formula->type == LX_FORMULA_SPACE ||
           lx_formula_is_fence(formula, false) || lx_formula_is_comma(formula);
}

static void add_row(struct lx_text *text, const struct lx_formula *row)
{
    for (size_t i = 0; i < row->count; i++) {
        const struct lx_formula *child = row->children[i], *next = i + 1 < row->count ? row->children[i + 1] : NULL;
        bool is_word = lx_formula_is_word(child);
        if (is_word && i > 0 && !is_tight(row->children[i - 1]))
            add_thin_space(text);
        if (lx_formula_is_sign(row, i))
            lx_text_printf(text, "<mo form=\"prefix\">%s</mo>", child->text);
        else
            add(text, child);
        if (is_word && next) /* it is applied to what follows */
            lx_text_puts(text, "<mo>&#x2061;</mo>");
        if (is_word && next && !opens(next) && !is_tight(next) && !lx_formula_is_fence(next, true) &&
            !lx_formula_is_word(next))
            add_thin_space(text);
    }
}

static void add_group(struct lx_text *text, const char *name, const struct lx_formula *formula)
{
    lx_text_printf(text, "<%s>", name);
    if (formula->type == LX_FORMULA_ROW)
        add_row(text, formula);
    for (size_t i = 0; formula->type != LX_FORMULA_ROW && i < formula->count; i++)
        add(text, formula->children[i]);
    lx_text_printf(text, "</%s>", name);
}

/* Words with their blanks at both ends, which browsers would leave out. */
static void add_words(struct lx_text *text, const char *words)
{
    size_t length = strlen(words), first = strspn(words, " "), last = length;
    while (last > first && words[last - 1] == ' ')
        last--;
    lx_text_puts(text, "<mtext>");
    for (size_t i = 0; i < length; i++)
        if (i < first || i >= last)
            lx_text_puts(text, "&#xa0;");
        else
            add_escaped(text, (const char[]){words[i], '\0'});
    lx_text_puts(text, "</mtext>");
}

/* A bracket is an operator that stretches only where \left or \right made it; | would be set apart like one. */
static void add_fence(struct lx_text *text, const struct lx_formula *formula)
{
    const char *tight = strcmp(formula->text, "|") == 0 ? " lspace=\"0\" rspace=\"0\"" : "";
    if (!*formula->text)
        return;
    lx_text_printf(text, "<mo fence=\"true\"%s%s>", formula->tall ? "" : " stretchy=\"false\"", tight);
    add_escaped(text, formula->text);
    lx_text_puts(text, "</mo>");
}

/* Sums and integrals stand between their limits, all else before them. */
static void add_scripts(struct lx_text *text, const struct lx_formula *formula)
{
    const struct lx_formula *base = formula->children[0], *below = formula->children[1], *above = formula->children[2];
    bool limits = base && base->type == LX_FORMULA_UPRIGHT &&
                  (strcmp(base->text, "∑") == 0 || strcmp(base->text, "max") == 0 || strcmp(base->text, "min") == 0);
    const char *name = limits ? (below && above ? "munderover"
                                 : below        ? "munder"
                                                : "mover")
                              : (below && above ? "msubsup"
                                 : below        ? "msub"
                                                : "msup");
    lx_text_printf(text, "<%s>", name);
    for (size_t i = 0; i < 3; i++)
        if (formula->children[i])
            add(text, formula->children[i]);
    lx_text_printf(text, "</%s>", name);
}

/* Lines under each other: what stands before and behind the mark of alignment are two cells. */
static void add_lines(struct lx_text *text, const struct lx_formula *formula)
{
    lx_text_puts(text, "<mtable displaystyle=\"true\">");
    for (size_t i = 0; i < formula->count; i++) {
        const struct lx_formula *row = formula->children[i];
        size_t mark = 0;
        while (mark < row->count && !(row->children[mark]->type == LX_FORMULA_SPACE && row->children[mark]->width == 0))
            mark++;
        struct lx_formula left = *row, right = *row;
        left.count = mark;
        right.children += mark < row->count ? mark + 1 : mark;
        right.count = mark < row->count ? row->count - mark - 1 : 0;
        lx_text_puts(text, "<mtr><mtd style=\"text-align:right;padding-right:0\">");
        add_row(text, &left);
        lx_text_puts(text, "</mtd><mtd style=\"text-align:left;padding-left:0\"><mrow><mi></mi>");
        add_row(text, &right);
        lx_text_puts(text, "</mrow></mtd></mtr>");
    }
    lx_text_puts(text, "</mtable>");
}

static void add_space(struct lx_text *text, double width)
{
    if (width > 0)
        lx_text_printf(text, "<mspace width=\"%d.%02dem\"></mspace>", (int)width, (int)(width * 100) % 100);
}

static void add(struct lx_text *text, const struct lx_formula *formula)
{
    if (!formula)
        return;
    bool is_sum = formula->text && strcmp(formula->text, "∑") == 0;
    bool is_comma = lx_formula_is_comma(formula);
    switch (formula->type) {
    case LX_FORMULA_ROW: add_group(text, "mrow", formula); break;
    case LX_FORMULA_LETTER: add_element(text, "mi", "", formula->text); break;
    case LX_FORMULA_BOLD:
        add_element(text, "mi", " mathvariant=\"normal\" style=\"font-weight:bold\"", formula->text);
        break;
    case LX_FORMULA_UPRIGHT:
        if (is_sum || is_comma)
            add_element(text, "mo", "", formula->text);
        else
            add_element(text, "mi", " mathvariant=\"normal\"", formula->text);
        break;
    case LX_FORMULA_NUMBER: add_element(text, "mn", "", formula->text); break;
    case LX_FORMULA_OPERATOR:
        add_element(text, "mo", strcmp(formula->text, "/") == 0 ? " lspace=\"0\" rspace=\"0\"" : "", formula->text);
        break;
    case LX_FORMULA_FENCE: add_fence(text, formula); break;
    case LX_FORMULA_WORDS: add_words(text, formula->text); break;
    case LX_FORMULA_SPACE: add_space(text, formula->width); break;
    case LX_FORMULA_FRACTION: add_group(text, "mfrac", formula); break;
    case LX_FORMULA_ROOT: add_group(text, "msqrt", formula); break;
    case LX_FORMULA_SCRIPTS: add_scripts(text, formula); break;
    case LX_FORMULA_ACCENT:
        lx_text_puts(text, "<mover accent=\"true\">");
        add(text, formula->children[0]);
        add_element(text, "mo", "", formula->text);
        lx_text_puts(text, "</mover>");
        break;
    case LX_FORMULA_LINES: add_lines(text, formula); break;
    }
}

void lx_formula_add_mathml(struct lx_text *text, const struct lx_formula *formula)
{
    add(text, formula);
}

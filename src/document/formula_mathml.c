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

/* cos, max_i: names of functions */
static bool is_function(const struct lx_formula *formula)
{
    const struct lx_formula *name = formula->type == LX_FORMULA_SCRIPTS ? formula->children[0] : formula;
    return name && name->type == LX_FORMULA_UPRIGHT && name->text[0] >= 'a' && name->text[0] <= 'z' && name->text[1];
}

static void add_group(struct lx_text *text, const char *name, const struct lx_formula *formula)
{
    lx_text_printf(text, "<%s>", name);
    for (size_t i = 0; i < formula->count; i++) {
        add(text, formula->children[i]);
        /* it is applied to what follows, which sets the two apart */
        if (formula->type == LX_FORMULA_ROW && i + 1 < formula->count && formula->children[i] &&
            is_function(formula->children[i]))
            lx_text_puts(text, "<mo>&#x2061;</mo>");
    }
    lx_text_printf(text, "</%s>", name);
}

/* A bracket is an operator that stretches only where \left or \right made it. */
static void add_fence(struct lx_text *text, const struct lx_formula *formula)
{
    if (*formula->text)
        add_element(text, "mo", formula->tall ? " fence=\"true\"" : " fence=\"true\" stretchy=\"false\"",
                    formula->text);
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
    lx_text_puts(text, "<mtable displaystyle=\"true\" columnalign=\"right left\">");
    for (size_t i = 0; i < formula->count; i++) {
        const struct lx_formula *row = formula->children[i];
        bool open = true;
        lx_text_puts(text, "<mtr><mtd style=\"text-align:right\">");
        for (size_t k = 0; row->type == LX_FORMULA_ROW && k < row->count; k++) {
            bool is_mark = row->children[k]->type == LX_FORMULA_SPACE && row->children[k]->width == 0;
            if (is_mark && open) {
                lx_text_puts(text, "</mtd><mtd style=\"text-align:left\">");
                open = false;
            } else if (!is_mark) {
                add(text, row->children[k]);
            }
        }
        lx_text_puts(text, "</mtd></mtr>");
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
    bool is_comma = formula->text && strcmp(formula->text, ",") == 0;
    switch (formula->type) {
    case LX_FORMULA_ROW: add_group(text, "mrow", formula); break;
    case LX_FORMULA_LETTER: add_element(text, "mi", "", formula->text); break;
    case LX_FORMULA_BOLD:
        add_element(text, "mi", " mathvariant=\"bold\" style=\"font-weight:bold\"", formula->text);
        break;
    case LX_FORMULA_UPRIGHT:
        if (is_sum || is_comma)
            add_element(text, "mo", "", formula->text);
        else
            add_element(text, "mi", " mathvariant=\"normal\"", formula->text);
        break;
    case LX_FORMULA_NUMBER: add_element(text, "mn", "", formula->text); break;
    case LX_FORMULA_OPERATOR: add_element(text, "mo", "", formula->text); break;
    case LX_FORMULA_FENCE: add_fence(text, formula); break;
    case LX_FORMULA_WORDS: add_element(text, "mtext", "", formula->text); break;
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

/* SPDX-License-Identifier: MIT */
/* Documents as LaTeX: a whole article, for pdflatex and lualatex alike. */
#include <string.h>

#include "blocks.h"

/* What of Unicode stands in sentences and has a command of its own; the rest is for the input encoding. */
static const struct {
    const char *sign, *command;
} signs[] = {
    {"−", "\\ensuremath{-}"},
    {"×", "\\ensuremath{\\times}"},
    {"·", "\\ensuremath{\\cdot}"},
    {"≈", "\\ensuremath{\\approx}"},
    {"≤", "\\ensuremath{\\le}"},
    {"≥", "\\ensuremath{\\ge}"},
    {"±", "\\ensuremath{\\pm}"},
    {"°", "\\ensuremath{^\\circ}"},
    {"²", "\\ensuremath{^2}"},
    {"→", "\\ensuremath{\\to}"},
    {"π", "\\ensuremath{\\pi}"},
    {"∞", "\\ensuremath{\\infty}"},
    {"…", "\\dots{}"},
    {"–", "--"},
    {"—", "---"},
};

static void add_character(struct lx_text *text, char c)
{
    switch (c) {
    case '\\': lx_text_puts(text, "\\textbackslash{}"); break;
    case '~': lx_text_puts(text, "\\textasciitilde{}"); break;
    case '^': lx_text_puts(text, "\\textasciicircum{}"); break;
    case '<': lx_text_puts(text, "\\textless{}"); break;
    case '>': lx_text_puts(text, "\\textgreater{}"); break;
    case '|': lx_text_puts(text, "\\textbar{}"); break;
    case '"': lx_text_puts(text, "\\textquotedbl{}"); break;
    case '\'': lx_text_puts(text, "\\textquotesingle{}"); break;
    case '`': lx_text_puts(text, "\\textasciigrave{}"); break;
    case '-': lx_text_puts(text, "-{}"); break;
    default:
        if (strchr("#$%&_{}", c))
            lx_text_puts(text, "\\");
        lx_text_add(text, &c, 1);
        break;
    }
}

static void add_escaped(struct lx_text *text, const char *plain, size_t length)
{
    struct lx_text printable = {0};
    lx_text_add_escaped(&printable, plain, length);
    for (const char *at = printable.bytes ? printable.bytes : ""; *at;) {
        size_t i = 0, count = sizeof signs / sizeof signs[0];
        while (i < count && strncmp(at, signs[i].sign, strlen(signs[i].sign)) != 0)
            i++;
        if (i < count) {
            lx_text_puts(text, signs[i].command);
            at += strlen(signs[i].sign);
        } else {
            add_character(text, *at++);
        }
    }
    text->failed = text->failed || printable.failed;
    lx_text_clear(&printable);
}

/* A formula as it is, its Unicode signs as commands. */
static void add_math(struct lx_text *text, const char *notation)
{
    for (const char *at = notation; *at;) {
        if (strncmp(at, "⊥", 3) == 0) {
            lx_text_puts(text, "\\perp ");
            at += 3;
        } else if (strncmp(at, "°", 2) == 0) {
            lx_text_puts(text, "^\\circ ");
            at += 2;
        } else if (strncmp(at, "\\degree", 7) == 0) {
            lx_text_puts(text, "^\\circ ");
            at += 7;
        } else {
            lx_text_add(text, at++, 1);
        }
    }
}

static void add_wrapped(struct lx_text *text, const char *command, const char *plain)
{
    lx_text_puts(text, command);
    add_escaped(text, plain, strlen(plain));
    lx_text_puts(text, "}");
}

static void add_pieces(struct lx_text *text, const struct lx_pieces *pieces)
{
    for (size_t i = 0; i < pieces->count; i++) {
        const struct lx_piece *piece = &pieces->items[i];
        switch (piece->type) {
        case LX_SPAN_CODE: add_wrapped(text, "\\texttt{", piece->text); break;
        case LX_SPAN_STRONG: add_wrapped(text, "\\textbf{", piece->text); break;
        case LX_SPAN_FORMULA:
            lx_text_puts(text, "$");
            add_math(text, piece->text);
            lx_text_puts(text, "$");
            break;
        default: add_escaped(text, piece->text, strlen(piece->text)); break;
        }
    }
}

/* Columns of words take what room there is. */
static void add_table(struct lx_text *text, const struct lx_block *table)
{
    size_t columns = lx_block_columns(table);
    lx_text_puts(text, "\\begin{center}\n\\small\n\\begin{tabularx}{\\linewidth}{");
    for (size_t c = 0; c < columns; c++)
        lx_text_puts(text, table->text[c] == 'r' ? "r" : ">{\\raggedright\\arraybackslash}X");
    lx_text_puts(text, "}\n\\toprule\n");
    for (size_t r = 0; r < table->row_count; r++) {
        for (size_t c = 0; c < columns; c++) {
            lx_text_puts(text, c > 0 ? " & " : "");
            lx_text_puts(text, table->rows[r].marked ? "\\textbf{" : "");
            add_pieces(text, &table->rows[r].cells[c]);
            lx_text_puts(text, table->rows[r].marked ? "}" : "");
        }
        lx_text_puts(text, r == 0 ? " \\\\\n\\midrule\n" : " \\\\\n");
    }
    lx_text_puts(text, "\\bottomrule\n\\end{tabularx}\n\\end{center}\n");
}

/* Typewriter lines that may break; blanks at their beginnings are kept. */
static void add_code(struct lx_text *text, const char *code)
{
    lx_text_puts(text, "\\begin{flushleft}\\footnotesize\\ttfamily\n");
    while (*code) {
        size_t length = strcspn(code, "\n"), blanks = strspn(code, " ");
        for (size_t i = 0; i < blanks && i < length; i++)
            lx_text_puts(text, "~");
        if (blanks < length)
            add_escaped(text, code + blanks, length - blanks);
        lx_text_puts(text, "\\strut\\\\\n");
        code += length + (code[length] == '\n');
    }
    lx_text_puts(text, "\\end{flushleft}\n");
}

static void add_block(struct lx_text *text, const struct lx_block *block, bool begins, bool ends)
{
    switch (block->type) {
    case LX_BLOCK_HEADING:
        lx_text_puts(text, block->level == 1 ? "\\section*{" : "\\subsection*{");
        add_pieces(text, &block->words);
        lx_text_puts(text, "}\n");
        break;
    case LX_BLOCK_PARAGRAPH:
        add_pieces(text, &block->words);
        lx_text_puts(text, "\n");
        break;
    case LX_BLOCK_ITEM:
        lx_text_puts(text, begins ? "\\begin{itemize}\n\\item " : "\\item ");
        add_pieces(text, &block->words);
        lx_text_puts(text, ends ? "\n\\end{itemize}\n" : "\n");
        break;
    case LX_BLOCK_FORMULA:
        lx_text_puts(text, "\\begin{align*}\n");
        add_math(text, block->text);
        lx_text_puts(text, "\n\\end{align*}\n");
        break;
    case LX_BLOCK_CODE: add_code(text, block->text); break;
    case LX_BLOCK_TABLE: add_table(text, block); break;
    case LX_BLOCK_PICTURE:
        lx_text_puts(text, "\\begin{center}\n\\textit{");
        add_pieces(text, &block->words);
        lx_text_puts(text, "}\n\\end{center}\n");
        break;
    }
}

static void add_preamble(const struct luxel_document *document, struct lx_text *text)
{
    bool russian = strncmp(document->language.code, "ru", 2) == 0;
    lx_text_puts(text, "\\documentclass[a4paper,11pt]{article}\n"
                       "\\usepackage{iftex}\n"
                       "\\ifPDFTeX\n"
                       "  \\usepackage[utf8]{inputenc}\n");
    lx_text_puts(text, russian ? "  \\usepackage[T2A]{fontenc}\n" : "  \\usepackage[T1]{fontenc}\n");
    lx_text_puts(text, "\\else\n"
                       "  \\usepackage{fontspec}\n");
    lx_text_puts(text, russian ? "  \\setmainfont{CMU Serif}\n  \\setmonofont{CMU Typewriter Text}\n" : "");
    lx_text_puts(text, "\\fi\n");
    lx_text_puts(text, russian ? "\\usepackage[russian]{babel}\n" : "\\usepackage[english]{babel}\n");
    lx_text_puts(text, "\\usepackage{textcomp,amsmath,array,booktabs,tabularx}\n"
                       "\\usepackage[margin=25mm]{geometry}\n"
                       "\\title{");
    add_pieces(text, &document->title);
    lx_text_puts(text, "}\n\\author{");
    for (size_t i = 0; i < document->byline_count; i++) {
        lx_text_puts(text, i > 0 ? "\\\\ " : "");
        add_escaped(text, document->bylines[i], strlen(document->bylines[i]));
    }
    lx_text_puts(text, "}\n\\date{}\n\\begin{document}\n\\maketitle\n");
}

void lx_document_write_latex(const struct luxel_document *document, struct lx_text *text)
{
    add_preamble(document, text);
    for (size_t i = 0; i < document->block_count; i++) {
        bool begins = i == 0 || !lx_block_goes_on(document, i - 1);
        lx_text_puts(text, document->blocks[i].type == LX_BLOCK_ITEM && !begins ? "" : "\n");
        add_block(text, &document->blocks[i], begins, !lx_block_goes_on(document, i));
    }
    lx_text_puts(text, "\n\\end{document}\n");
}

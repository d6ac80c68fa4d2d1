/* SPDX-License-Identifier: MIT */
/* Documents as LaTeX: a whole article, for pdflatex and lualatex alike. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "blocks.h"

enum { LINE = 88, GAP = 3 }; /* characters that fit a line of a table; between columns */

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
    case '[': lx_text_puts(text, "{[}"); break; /* not the beginning of an option, nor a star of a command */
    case ']': lx_text_puts(text, "{]}"); break;
    case '*': lx_text_puts(text, "{*}"); break;
    case '`': lx_text_puts(text, "\\textasciigrave{}"); break;
    case '-': lx_text_puts(text, "-{}"); break; /* two of them would become a dash */
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

/* Code, which may be broken behind its signs. */
static void add_code_words(struct lx_text *text, const char *code, size_t length)
{
    while (length > 0) {
        size_t word = strcspn(code, "'/,=");
        if (word >= length) {
            add_escaped(text, code, length);
            return;
        }
        add_escaped(text, code, word);
        if (code[word] == '\'')
            lx_text_puts(text, "\\textquotesingle{}");
        else
            lx_text_printf(text, "%c\\allowbreak{}", code[word]);
        code += word + 1;
        length -= word + 1;
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
        const struct lx_text_piece *piece = &pieces->items[i];
        switch (piece->type) {
        case LX_SPAN_CODE:
            lx_text_puts(text, "\\texttt{");
            add_code_words(text, piece->text, strlen(piece->text));
            lx_text_puts(text, "}");
            break;
        case LX_SPAN_STRONG: add_wrapped(text, "\\textbf{", piece->text); break;
        case LX_SPAN_FORMULA:
            lx_text_puts(text, "$");
            lx_add_tex_formula(text, piece->text, false);
            lx_text_puts(text, "$");
            break;
        default: add_escaped(text, piece->text, strlen(piece->text)); break;
        }
    }
}

/* The most characters of a column's cells. */
static size_t measure_column(struct lx_text *text, const struct lx_block *table, size_t column)
{
    size_t widest = 0;
    for (size_t r = 0; r < table->row_count; r++) {
        struct lx_text words = {0};
        lx_pieces_add_plain(&words, &table->rows[r].cells[column]);
        size_t width = words.bytes ? lx_width_of(words.bytes, words.length) : 0;
        widest = width > widest ? width : widest;
        text->failed = text->failed || words.failed;
        lx_text_clear(&words);
    }
    return widest;
}

static void add_columns(struct lx_text *text, const struct lx_block *table)
{
    size_t columns = lx_block_columns(table), *widths = lx_new_array(columns, sizeof *widths);
    text->failed = text->failed || !widths;
    if (!widths)
        return;
    for (size_t c = 0; c < columns; c++)
        widths[c] = measure_column(text, table, c);
    size_t room = lx_table_room(table->text, widths, LINE, GAP);
    for (size_t c = 0; c < columns; c++)
        if (table->text[c] == 'l' && widths[c] > room)
            lx_text_printf(text, ">{\\raggedright\\arraybackslash}p{0.%02d\\linewidth}", (int)(room * 99 / LINE));
        else
            lx_text_add(text, &table->text[c], 1);
    free(widths);
}

/* Tables may go on over several pages, each with the heading. */
static void add_table(struct lx_text *text, const struct lx_block *table)
{
    size_t columns = lx_block_columns(table);
    lx_text_puts(text, "{\\small\n\\begin{longtable}{");
    add_columns(text, table);
    lx_text_puts(text, "}\n\\toprule\n");
    for (size_t r = 0; r < table->row_count; r++) {
        for (size_t c = 0; c < columns; c++) {
            bool marked = table->rows[r].marked && table->rows[r].cells[c].count > 0;
            lx_text_puts(text, c > 0 ? " & " : "");
            lx_text_puts(text, marked ? "\\textbf{" : "");
            add_pieces(text, &table->rows[r].cells[c]);
            lx_text_puts(text, marked ? "}" : "");
        }
        lx_text_puts(text, r == 0 ? " \\\\\n\\midrule\n\\endhead\n" : " \\\\\n");
    }
    lx_text_puts(text, "\\bottomrule\n\\end{longtable}}\n");
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
            add_code_words(text, code + blanks, length - blanks);
        lx_text_puts(text, "\\strut\\\\\n");
        code += length + (code[length] == '\n');
    }
    lx_text_puts(text, "\\end{flushleft}\n");
}

/* A formula that is longer than a line is set as a paragraph, where LaTeX breaks it. */
static void add_formula(struct lx_text *text, const char *notation)
{
    const struct lx_pieces pieces = {.items = &(struct lx_text_piece){LX_SPAN_FORMULA, (char *)notation}, .count = 1};
    struct lx_text plain = {0};
    lx_pieces_add_plain(&plain, &pieces);
    bool breaks = plain.bytes && !strchr(notation, '&') && !strstr(notation, "\\\\") &&
                  lx_width_of(plain.bytes, plain.length) > LINE;
    lx_text_puts(text, breaks ? "\n\\begin{quote}\n\\raggedright$\\displaystyle " : "\\begin{align*}\n");
    lx_add_tex_formula(text, notation, false);
    lx_text_puts(text, breaks ? "$\n\\end{quote}\n" : "\n\\end{align*}\n");
    text->failed = text->failed || plain.failed;
    lx_text_clear(&plain);
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
    case LX_BLOCK_FORMULA: add_formula(text, block->text); break;
    case LX_BLOCK_CODE: add_code(text, block->text); break;
    case LX_BLOCK_TABLE: add_table(text, block); break;
    case LX_BLOCK_PICTURE:
        lx_text_puts(text, "\\begin{center}\n\\textit{");
        add_pieces(text, &block->words);
        lx_text_puts(text, "}\n\\end{center}\n");
        break;
    }
}

static bool has_cyrillic(const char *at)
{
    for (; *at; at++)
        if (*at == '\xd0' || *at == '\xd1')
            return true;
    return false;
}

/* Whether every LaTeX has a character: ASCII, Western and Russian letters, dashes and quotation marks. */
static bool is_common(uint32_t code)
{
    return code < 0x80 || (code > 0xa0 && code < 0x100) || (code >= 0x410 && code < 0x450) || code == 0x401 ||
           code == 0x451 || (code >= 0x2013 && code <= 0x201e);
}

/* A character that LaTeX may not know, in the name of a light, say, is shown by its number rather than stopping it. */
static void add_declarations(struct lx_text *text, const char *body)
{
    struct lx_text known = {0};
    uint32_t code;
    for (size_t length; *body; body += length > 0 ? length : 1) {
        char declared[16];
        length = lx_next_character(body, strlen(body), &code);
        if (length == 0 || is_common(code))
            continue;
        snprintf(declared, sizeof declared, "{%04X}", (unsigned)code);
        if (known.bytes && strstr(known.bytes, declared))
            continue;
        lx_text_puts(&known, declared);
        lx_text_puts(text, "  \\ifcsname u8:\\detokenize{");
        lx_text_add(text, body, length);
        lx_text_printf(text, "}\\endcsname\\else\\DeclareUnicodeCharacter%s{\\texttt{U+%04X}}\\fi\n", declared,
                       (unsigned)code);
    }
    text->failed = text->failed || known.failed;
    lx_text_clear(&known);
}

static void add_preamble(const struct luxel_document *document, const char *body, struct lx_text *text)
{
    static const char *const fonts[] = {"CMU Serif", "Noto Serif", "Liberation Serif", "DejaVu Serif"};
    bool russian = strncmp(document->language.code, "ru", 2) == 0, cyrillic = russian || has_cyrillic(body);
    lx_text_puts(text, "\\documentclass[a4paper,11pt]{article}\n"
                       "\\usepackage{iftex}\n"
                       "\\ifPDFTeX\n"
                       "  \\usepackage[utf8]{inputenc}\n");
    lx_text_puts(text, cyrillic ? "  \\usepackage[T1,T2A]{fontenc}\n" : "  \\usepackage[T1]{fontenc}\n");
    lx_text_puts(text, "  \\usepackage{textcomp}\n");
    add_declarations(text, body);
    lx_text_puts(text, "\\else\n"
                       "  \\usepackage{fontspec}\n");
    for (size_t i = 0; cyrillic && i < sizeof fonts / sizeof fonts[0]; i++) /* the first that is installed */
        lx_text_printf(text, "  %s\\IfFontExistsTF{%s}{\\setmainfont{%s}}{%%\n", i > 0 ? "  " : "", fonts[i], fonts[i]);
    lx_text_puts(text, cyrillic ? "  }}}}\n" : "");
    lx_text_puts(text, cyrillic
                           ? "  \\IfFontExistsTF{CMU Typewriter Text}{\\setmonofont{CMU Typewriter Text}}{%\n"
                             "    \\IfFontExistsTF{DejaVu Sans Mono}{\\setmonofont{DejaVu Sans Mono}[Scale=0.85]}{}}\n"
                           : "");
    lx_text_puts(text, "\\fi\n");
    lx_text_puts(text, russian ? "\\usepackage[russian]{babel}\n" : "\\usepackage[english]{babel}\n");
    lx_text_puts(text, "\\usepackage{amsmath,array,booktabs,longtable}\n"
                       "\\usepackage[margin=25mm]{geometry}\n");
}

static void add_title(const struct luxel_document *document, struct lx_text *text)
{
    lx_text_puts(text, "\\title{");
    add_pieces(text, &document->title);
    lx_text_puts(text, "}\n\\author{");
    for (size_t i = 0; i < document->byline_count; i++) {
        lx_text_puts(text, i > 0 ? "\\\\ " : "");
        add_escaped(text, document->bylines[i], strlen(document->bylines[i]));
    }
    lx_text_puts(text, "}\n\\date{}\n\\begin{document}\n\\maketitle\n");
}

static void add_cover_lines(const struct luxel_document *document, enum lx_cover_place place, struct lx_text *text)
{
    for (size_t i = 0; i < document->cover_counts[place]; i++) {
        add_pieces(text, &document->covers[place][i]);
        lx_text_puts(text, "\\par\n");
    }
}

/* A page of its own. */
static void add_cover(const struct luxel_document *document, struct lx_text *text)
{
    lx_text_puts(text, "\\begin{document}\n\\begin{titlepage}\n\\centering\n");
    add_cover_lines(document, LX_COVER_HEAD, text);
    lx_text_puts(text, "\\vfill\n");
    add_cover_lines(document, LX_COVER_ABOVE, text);
    lx_text_puts(text, "\\bigskip{\\Large\\bfseries ");
    add_pieces(text, &document->title);
    lx_text_puts(text, "\\par}\n\\vfill\n{\\raggedleft\n");
    add_cover_lines(document, LX_COVER_SIDE, text);
    lx_text_puts(text, "}\\vfill\n");
    add_cover_lines(document, LX_COVER_FOOT, text);
    lx_text_puts(text, "\\end{titlepage}\n");
}

static void add_body(const struct luxel_document *document, struct lx_text *text)
{
    if (lx_document_has_cover(document))
        add_cover(document, text);
    else
        add_title(document, text);
    for (size_t i = 0; i < document->block_count; i++) {
        bool begins = i == 0 || !lx_block_goes_on(document, i - 1);
        bool goes_on = document->blocks[i].type == LX_BLOCK_FORMULA || /* a part of its paragraph */
                       (document->blocks[i].type == LX_BLOCK_ITEM && !begins);
        lx_text_puts(text, goes_on && i > 0 ? "" : "\n");
        add_block(text, &document->blocks[i], begins, !lx_block_goes_on(document, i));
    }
    lx_text_puts(text, "\n\\end{document}\n");
}

void lx_document_write_latex(const struct luxel_document *document, struct lx_text *text)
{
    struct lx_text body = {0};
    add_body(document, &body);
    if (body.bytes) {
        add_preamble(document, body.bytes, text);
        lx_text_puts(text, body.bytes);
    }
    text->failed = text->failed || body.failed;
    lx_text_clear(&body);
}

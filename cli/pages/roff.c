/* SPDX-License-Identifier: MIT */
/*
 * Escapes of roff.  A dot or quote must not begin a line, a backslash is \e, a minus that is typed is \-; characters
 * outside ASCII are named by their code, so that the page reads the same through every formatter and locale.
 */
#include "roff.h"

#include <stdbool.h>
#include <string.h>

/* The code of the character at the text, which is UTF-8, and its length. */
static unsigned next_code(const char *text, size_t *length)
{
    const unsigned char first = (unsigned char)text[0];
    unsigned code;

    *length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (*length == 1)
        return first;
    code = first & (0xffU >> (*length + 1));
    for (size_t i = 1; i < *length; i++)
        code = code << 6 | ((unsigned char)text[i] & 0x3f);
    return code;
}

static void print_character(FILE *out, unsigned code, bool typed)
{
    if (code == 0xb7) /* the dot of a product, which terminals without Unicode have no sign for */
        fputc('*', out);
    else if (code >= 0x80)
        fprintf(out, "\\[u%04X]", code);
    else if (code == '\\')
        fputs("\\e", out);
    else if (code == '-' && typed)
        fputs("\\-", out);
    else if (code == '\'')
        fputs("\\(aq", out);
    else if (code == '"')
        fputs("\\(dq", out);
    else if (code == '^')
        fputs("\\(ha", out);
    else if (code == '~')
        fputs("\\(ti", out);
    else if (code == '`')
        fputs("\\(ga", out);
    else
        fputc((int)code, out);
}

/* Whether the minus at `at` begins a word, an option or a number, and joins no two words. */
static bool begins_word(const char *text, const char *at)
{
    return at == text || strchr(" (-", at[-1]) || at[1] == '-' || (at[1] >= '0' && at[1] <= '9');
}

/* `typed`: as it stands, on one line; else in lines of some 70 columns, which the formatter fills anew. */
static void print_characters(FILE *out, const char *text, bool typed)
{
    enum { WIDTH = 70 };
    unsigned column = 0;
    size_t length;

    for (const char *at = text; *at; at += length, column++) {
        const unsigned code = next_code(at, &length);

        if (!typed && code == ' ' && column + strcspn(at + 1, " ") > WIDTH) {
            fputc('\n', out);
            column = 0;
            continue;
        }
        if (column <= 1 && (code == '.' || code == '\''))
            fputs("\\&", out);
        print_character(out, code, typed || begins_word(text, at));
    }
}

void roff_text(FILE *out, const char *text)
{
    print_characters(out, text, false);
}

void roff_typed(FILE *out, const char *text)
{
    fputs("\\fB", out);
    print_characters(out, text, true);
    fputs("\\fR", out);
}

void roff_placeholder(FILE *out, const char *text)
{
    fputs("\\fI", out);
    print_characters(out, text, false);
    fputs("\\fR", out);
}

void roff_paragraph(FILE *out, const char *text)
{
    fputs(".PP\n", out);
    roff_text(out, text);
    fputc('\n', out);
}

void roff_example(FILE *out, const char *lines)
{
    fputs(".PP\n.RS 4\n.nf\n", out);
    while (*lines) {
        const size_t length = strcspn(lines, "\n");
        char line[256];

        snprintf(line, sizeof line, "%.*s", (int)length, lines);
        print_characters(out, line, true);
        fputc('\n', out);
        lines += length + (lines[length] != '\0');
    }
    fputs(".fi\n.RE\n", out);
}

/* SPDX-License-Identifier: MIT */
/*
 * Texts with phrases.  A phrase stands between BEGIN and END: its template, and each argument behind a NEXT.  The
 * marks are control characters, which an escaped text never has.
 */
#include "phrase.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

enum { BEGIN = '\x02', END = '\x03', NEXT = '\x1f', MOST_ARGUMENTS = 10 };

const char lx_term_mark[] = "term", lx_words_mark[] = "words";

/* A stretch of a text with phrases. */
struct part {
    const char *start, *end;
};

struct parts {
    struct part part[MOST_ARGUMENTS];
    size_t count;
};

struct language {
    luxel_translate translate;
    void *data;
};

static bool is_mark(char c)
{
    return c == BEGIN || c == END || c == NEXT;
}

static void add_mark(struct lx_text *text, char mark)
{
    lx_text_add(text, &mark, 1);
}

void lx_add_phrase(struct lx_text *text, const char *english, const char *const *arguments)
{
    add_mark(text, BEGIN);
    lx_text_puts(text, english);
    for (size_t i = 0; arguments && arguments[i]; i++) {
        add_mark(text, NEXT);
        lx_text_puts(text, arguments[i]);
    }
    add_mark(text, END);
}

/* Adds a text with phrases, all but the marks escaped. */
static void add_escaped(struct lx_text *text, const char *words)
{
    while (*words) {
        size_t length = 0;
        while (words[length] && !is_mark(words[length]))
            length++;
        lx_text_add_escaped(text, words, length);
        words += length;
        if (*words)
            add_mark(text, *words++);
    }
}

const char *const *lx_add_argument(struct lx_text *text, const char *const *argument)
{
    const char *mark = argument[0];
    bool marked = mark == lx_term_mark || mark == lx_words_mark;
    const char *words = argument[marked];
    if (!words)
        return argument + marked;
    if (mark == lx_words_mark) {
        add_escaped(text, words);
    } else {
        if (mark == lx_term_mark)
            add_mark(text, BEGIN);
        lx_text_add_escaped(text, words, strlen(words));
        if (mark == lx_term_mark)
            add_mark(text, END);
    }
    return argument + marked + 1;
}

/* ---- rendering ---- */

static void render(struct lx_text *text, struct part part, struct language language);

/* Where the template or argument ends that starts here. */
static const char *part_end(const char *at, const char *end)
{
    size_t depth = 0;
    for (; at < end && (depth || (*at != NEXT && *at != END)); at++) {
        depth += *at == BEGIN;
        depth -= *at == END;
    }
    return at;
}

static void fill(struct lx_text *text, const char *english, const struct parts *arguments, struct language language)
{
    /* The translation of "" would be the catalogue's header. */
    const char *at = language.translate && *english ? language.translate(english, language.data) : english;
    for (; *at; at++) {
        size_t argument = (size_t)(at[1] - '0');
        if (at[0] == '{' && at[1] >= '0' && at[1] <= '9' && at[2] == '}' && argument < arguments->count) {
            render(text, arguments->part[argument], language);
            at += 2;
        } else {
            lx_text_add(text, at, 1);
        }
    }
}

/* Renders the phrase whose BEGIN is at `at`; returns what follows its END. */
static const char *render_phrase(struct lx_text *text, const char *at, const char *end, struct language language)
{
    struct parts arguments = {.count = 0};
    const char *start = at + 1;
    at = part_end(start, end);
    char *english = lx_copy_text(start, (size_t)(at - start));
    while (at < end && *at == NEXT) {
        start = at + 1;
        at = part_end(start, end);
        if (arguments.count < MOST_ARGUMENTS)
            arguments.part[arguments.count++] = (struct part){start, at};
    }
    if (english)
        fill(text, english, &arguments, language);
    else
        text->failed = true;
    free(english);
    return at < end ? at + 1 : at;
}

static void render(struct lx_text *text, struct part part, struct language language)
{
    for (const char *at = part.start; at < part.end;) {
        const char *plain = at;
        while (at < part.end && !is_mark(*at))
            at++;
        lx_text_add(text, plain, (size_t)(at - plain));
        if (at < part.end)
            at = *at == BEGIN ? render_phrase(text, at, part.end, language) : at + 1;
    }
}

void lx_add_rendered(struct lx_text *text, const char *english, const char *const *arguments, luxel_translate translate,
                     void *data)
{
    struct parts parts = {.count = 0};
    for (; arguments && arguments[parts.count] && parts.count < MOST_ARGUMENTS; parts.count++) {
        const char *argument = arguments[parts.count];
        parts.part[parts.count] = (struct part){argument, argument + strlen(argument)};
    }
    fill(text, english, &parts, (struct language){translate, data});
}

char *lx_text_render(struct lx_text *text, luxel_translate translate, void *data)
{
    struct lx_text rendered = {0};
    char *words = lx_text_take(text);
    if (!words)
        return NULL;
    render(&rendered, (struct part){words, words + strlen(words)}, (struct language){translate, data});
    free(words);
    return lx_text_take(&rendered);
}

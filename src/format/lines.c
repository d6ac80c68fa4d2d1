/* SPDX-License-Identifier: MIT */
/* Taking a text apart into lines and words. */
#include "lines.h"

#include <string.h>
#include <strings.h>

bool lx_is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool lx_next_line(struct lx_lines *lines)
{
    while (lines->next < lines->end) {
        const char *start = lines->next, *stop = memchr(start, '\n', (size_t)(lines->end - start));
        stop = stop ? stop : lines->end;
        lines->next = stop < lines->end ? stop + 1 : stop;
        lines->line += 1 + lines->joined;
        lines->joined = 0;
        for (const char *at = start; at < stop; at++)
            lines->joined += *at == LX_JOINED_LINES;
        const char *comment = memchr(start, '#', (size_t)(stop - start));
        lines->at = start;
        lines->stop = comment ? comment : stop;
        while (lines->at < lines->stop && lx_is_blank(*lines->at))
            lines->at++;
        if (lines->at < lines->stop)
            return true;
    }
    return false;
}

bool lx_next_word(struct lx_lines *lines, const char **word, size_t *length)
{
    while (lines->at < lines->stop && lx_is_blank(*lines->at))
        lines->at++;
    *word = lines->at;
    while (lines->at < lines->stop && !lx_is_blank(*lines->at))
        lines->at++;
    *length = (size_t)(lines->at - *word);
    return *length > 0;
}

bool lx_is_word(const char *word, size_t length, const char *wanted)
{
    return strlen(wanted) == length && strncasecmp(word, wanted, length) == 0;
}

bool lx_word_is(const char *word, size_t length, const char *wanted)
{
    return strlen(wanted) == length && memcmp(word, wanted, length) == 0;
}

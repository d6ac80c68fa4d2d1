/* SPDX-License-Identifier: MIT */
/*
 * Text for people: a growing buffer, and the two things every message needs, the escaping of characters that
 * could disturb a terminal and the search for the word that was meant.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "text.h"

enum { LONGEST_WORD = 64 };

void lx_text_add(struct lx_text *text, const char *bytes, size_t length)
{
    if (text->failed)
        return;
    if (length >= SIZE_MAX - text->length ||
        lx_reserve(&text->bytes, &text->capacity, text->length + length + 1, 1) < 0) {
        text->failed = true;
        return;
    }
    if (length)
        memcpy(text->bytes + text->length, bytes, length);
    text->length += length;
    text->bytes[text->length] = 0;
}

void lx_text_puts(struct lx_text *text, const char *string)
{
    lx_text_add(text, string, strlen(string));
}

void lx_text_fill(struct lx_text *text, char character, size_t count)
{
    for (size_t i = 0; i < count; i++)
        lx_text_add(text, &character, 1);
}

void lx_text_printf(struct lx_text *text, const char *format, ...)
{
    char buffer[256];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof buffer)
        text->failed = true;
    else
        lx_text_add(text, buffer, (size_t)length);
}

char *lx_text_take(struct lx_text *text)
{
    if (!text->bytes)
        lx_text_puts(text, "");
    char *bytes = text->bytes;
    if (text->failed) {
        free(bytes);
        bytes = NULL;
    }
    *text = (struct lx_text){0};
    return bytes;
}

void lx_text_clear(struct lx_text *text)
{
    free(text->bytes);
    *text = (struct lx_text){0};
}

size_t lx_next_character(const char *bytes, size_t length, uint32_t *code)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const unsigned char *s = (const unsigned char *)bytes;
    if (length == 0)
        return 0;
    if (s[0] < 0x80) {
        *code = s[0];
        return 1;
    }
    size_t size = s[0] >= 0xF8 ? 0 : s[0] >= 0xF0 ? 4 : s[0] >= 0xE0 ? 3 : s[0] >= 0xC0 ? 2 : 0;
    if (size == 0 || size > length)
        return 0;
    uint32_t value = s[0] & (0x7Fu >> size);
    for (size_t i = 1; i < size; i++) {
        if ((s[i] & 0xC0) != 0x80)
            return 0;
        value = value << 6 | (s[i] & 0x3F);
    }
    if (value < least[size] || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF))
        return 0;
    *code = value;
    return size;
}

/* Characters without a picture of their own, or with that of a blank, or that change where others stand. */
static bool is_invisible(uint32_t code)
{
    return code == 0xA0 || code == 0xAD || (code >= 0x2000 && code <= 0x200F) || (code >= 0x2028 && code <= 0x202F) ||
           (code >= 0x205F && code <= 0x206F) || code == 0xFEFF || (code >= 0xFFF0 && code <= 0xFFFB) ||
           code >= 0xE0000;
}

/* The escape of the character at bytes, empty where it may stand as it is; *size: the bytes it covers. */
static size_t escape(const char *bytes, size_t length, size_t *size, char out[12])
{
    uint32_t code = 0;
    *size = lx_next_character(bytes, length, &code);
    if (*size == 0) {
        *size = 1;
        return (size_t)snprintf(out, 12, "\\x%02X", (unsigned)(unsigned char)bytes[0]);
    }
    if (code == '\n' || code == '\t' || code == '\r')
        return (size_t)snprintf(out, 12, "\\%c", code == '\n' ? 'n' : code == '\t' ? 't' : 'r');
    if (code < 0x20 || (code >= 0x7F && code < 0xA0))
        return (size_t)snprintf(out, 12, "\\x%02X", (unsigned)code);
    if (is_invisible(code))
        return (size_t)snprintf(out, 12, code > 0xFFFF ? "\\U%08X" : "\\u%04X", (unsigned)code);
    return 0;
}

size_t lx_text_add_escaped(struct lx_text *text, const char *bytes, size_t length)
{
    size_t columns = 0;
    for (size_t i = 0, size; i < length; i += size) {
        char out[12];
        size_t escaped = escape(bytes + i, length - i, &size, out);
        if (escaped)
            lx_text_add(text, out, escaped);
        else
            lx_text_add(text, bytes + i, size);
        columns += escaped ? escaped : 1;
    }
    return columns;
}

size_t lx_escaped_width(const char *bytes, size_t length)
{
    char out[12];
    size_t size, escaped = escape(bytes, length, &size, out);
    return escaped ? escaped : 1;
}

bool lx_is_printable(const char *bytes, size_t length)
{
    char out[12];
    for (size_t i = 0, size; i < length; i += size)
        if (escape(bytes + i, length - i, &size, out))
            return false;
    return true;
}

static unsigned char lower(char c)
{
    return (unsigned char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

static unsigned least_of(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

unsigned lx_word_distance(const char *a, size_t a_length, const char *b)
{
    size_t b_length = strlen(b);
    if (a_length > LONGEST_WORD || b_length > LONGEST_WORD)
        return LONGEST_WORD;
    /* optimal string alignment: three rows of the table are enough to see swapped neighbours */
    unsigned rows[3][LONGEST_WORD + 1];
    unsigned *before = rows[0], *above = rows[1], *row = rows[2];
    for (size_t j = 0; j <= b_length; j++)
        above[j] = (unsigned)j;
    for (size_t i = 1; i <= a_length; i++) {
        row[0] = (unsigned)i;
        for (size_t j = 1; j <= b_length; j++) {
            unsigned changed = above[j - 1] + (lower(a[i - 1]) != lower(b[j - 1]));
            row[j] = least_of(changed, 1 + least_of(above[j], row[j - 1]));
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                row[j] = least_of(row[j], before[j - 2] + 1);
        }
        unsigned *oldest = before;
        before = above;
        above = row;
        row = oldest;
    }
    return above[b_length];
}

void lx_nearest_offer(struct lx_nearest *nearest, const char *candidate)
{
    unsigned distance = lx_word_distance(nearest->word, nearest->length, candidate);
    size_t longer = nearest->length > strlen(candidate) ? nearest->length : strlen(candidate);
    /* a third of the letters may be wrong, and never all of them; a beginning of three letters is meant, too */
    bool near = distance <= (longer + 2) / 3 && distance < longer && distance <= 4;
    if (!near && nearest->length >= 3 && nearest->length < strlen(candidate) &&
        lx_word_distance(nearest->word, nearest->length, candidate) == strlen(candidate) - nearest->length &&
        lower(nearest->word[0]) == lower(candidate[0]))
        near = true;
    if (near && (!nearest->best || distance < nearest->distance)) {
        nearest->best = candidate;
        nearest->distance = distance;
    }
}

/* SPDX-License-Identifier: MIT */
/* The meaning of scalars without quotes: YAML 1.2's core schema, and the traps of YAML 1.1 that others still read. */
#include <string.h>

#include "../base/number.h"
#include "../base/text.h"
#include "plain.h"

/* Words that some YAML takes for a truth value, null, or a number, in any case of letters. */
static const char *const reserved[] = {"null", "true", "false", "yes", "no", "on", "off", "y", "n", "nan", "inf", NULL};

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (unsigned char)c >= 0x80;
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

bool lx_plain_is_text(const char *text)
{
    static const char *const words[] = {"",      "~",     "null", "Null", "NULL", "true", "True", "TRUE", "false",
                                        "False", "FALSE", ".nan", ".NaN", ".NAN", ".inf", ".Inf", ".INF", NULL};
    for (size_t i = 0; words[i]; i++)
        if (strcmp(text, words[i]) == 0)
            return false;
    const char *digits = text + (text[0] == '+' || text[0] == '-');
    if (digits > text && digits[0] == '.' && !lx_plain_is_text(digits))
        return false;
    if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'o') && digits[2] &&
        !digits[2 + strspn(digits + 2, "0123456789abcdefABCDEF")])
        return false;
    return !lx_looks_like_number(text, strlen(text));
}

/* Letters, digits, and blanks and marks between them that mean nothing to YAML. */
static bool is_harmless(const char *text)
{
    size_t length = strlen(text);
    if (length == 0 || text[0] == ' ' || text[length - 1] == ' ' || !lx_is_printable(text, length))
        return false;
    for (size_t i = 0; i < length; i++)
        if (!is_letter(text[i]) && !is_digit(text[i]) && !strchr(" .+-/()", text[i]))
            return false;
    return true;
}

bool lx_plain_is_safe(const char *text)
{
    if (!is_letter(text[0]) || !is_harmless(text))
        return false;
    for (size_t i = 0; reserved[i]; i++)
        if (lx_word_distance(text, strlen(text), reserved[i]) == 0)
            return false;
    return true;
}

bool lx_plain_is_writable(const char *text)
{
    if (text[0] == '-' && (text[1] == '-' || text[1] == ' ' || !text[1]))
        return false;
    return strcmp(text, "~") == 0 || is_harmless(text);
}

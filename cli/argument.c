/* SPDX-License-Identifier: MIT */
/*
 * Strict reading of numbers.  strtod alone would take " 1", "0x1", "nan" and "inf", and stop silently at
 * "1mm"; the shape of the text is checked first, and strtod only converts it.
 */
#include "argument.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"

static size_t digits(const char *text)
{
    return strspn(text, "0123456789");
}

/* The length of the decimal number that text starts with; 0 where there is none. */
static size_t number_length(const char *text)
{
    const char *at = text + (*text == '+' || *text == '-');
    const size_t whole = digits(at);
    size_t fraction = 0;

    at += whole;
    if (*at == '.') {
        fraction = digits(at + 1);
        at += 1 + fraction;
    }
    if (whole + fraction == 0)
        return 0;
    if (*at == 'e' || *at == 'E') {
        const size_t sign = at[1] == '+' || at[1] == '-';
        const size_t exponent = digits(at + 1 + sign);

        if (exponent > 0)
            at += 1 + sign + exponent;
    }
    return (size_t)(at - text);
}

/* One number that ends where `length` says; `whole_text` is what the message shows beside it. */
static bool read_number(const char *option, const char *whole_text, const char *text, size_t length, double *value)
{
    char *end;

    if (length == 0)
        message_error(_("%s %s: a number is missing"), option, whole_text);
    else if (number_length(text) != length)
        message_error(_("%s %s: \"%.*s\" is not a number"), option, whole_text, (int)length, text);
    else if (*value = strtod(text, &end), !isfinite(*value))
        message_error(_("%s %s: \"%.*s\" is too large a number"), option, whole_text, (int)length, text);
    else
        return true;
    return false;
}

bool argument_number(const char *option, const char *text, double *value)
{
    if (read_number(option, text, text, strlen(text), value))
        return true;
    message_hint(_("expected a decimal number with a point, such as 0.5 or 1e-9"));
    return false;
}

static size_t count_parts(const char *text)
{
    size_t parts = 1;

    for (; *text; text++)
        parts += *text == ',';
    return parts;
}

/* How many numbers may be written with a decimal comma: digits, a comma and digits alone. */
static size_t fractions(const char *text)
{
    size_t count = 0;

    for (const char *at = text; *at;) {
        const char *start = at + (*at == '-' || *at == '+');
        const size_t whole = digits(start), fraction = start[whole] == ',' ? digits(start + whole + 1) : 0;
        const char *end = fraction > 0 ? start + whole + 1 + fraction : start;

        if (whole > 0 && fraction > 0 && (!*end || *end == ',')) {
            count++;
            at = end;
        } else {
            at = start + strcspn(start, ",");
        }
        at += *at == ',';
    }
    return count;
}

bool argument_numbers(const char *option, const char *form, const char *text, double *values, size_t count)
{
    const size_t parts = count_parts(text);
    const char *at = text;

    for (size_t i = 0; i < parts; i++) {
        const size_t length = strcspn(at, ",");
        double value;

        if (!read_number(option, text, at, length, &value))
            goto wrong;
        if (i < count)
            values[i] = value;
        at += length + 1;
    }
    if (parts == count)
        return true;
    message_error(
        ngettext("%s %s: expected %zu numbers, %zu was given", "%s %s: expected %zu numbers, %zu were given", parts),
        option, text, count, parts);
    if (parts > count && fractions(text) >= parts - count) {
        message_hint(_("write the fraction with a point: a comma stands between two numbers, as in %s %s"), option,
                     form);
        return false;
    }
wrong:
    message_hint(_("the form is %s %s, decimal numbers with a point and commas between them"), option, form);
    return false;
}

bool argument_whole(const char *option, const char *text, unsigned least, unsigned most, unsigned *value)
{
    const size_t length = strlen(text);

    /* Nine digits always fit. */
    if (length > 0 && digits(text) == length && length <= 9) {
        *value = (unsigned)strtoul(text, NULL, 10);
        if (*value >= least && *value <= most)
            return true;
    }
    message_error(_("%s %s: expected a whole number from %u to %u"), option, text, least, most);
    return false;
}

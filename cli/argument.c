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
#include "text.h"

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

bool argument_share(const char *option, const char *text, double *share)
{
    if (!argument_number(option, text, share))
        return false;
    if (*share > 0.0 && *share < 1.0)
        return true;
    message_error(_("%s %s: expected a number above 0 and below 1"), option, text);
    return false;
}

bool argument_seconds(const char *option, const char *text, double *seconds)
{
    if (!argument_number(option, text, seconds))
        return false;
    if (*seconds > 0.0 && *seconds <= 1e6)
        return true;
    message_error(_("%s %s: expected seconds, above 0 and up to 1000000"), option, text);
    return false;
}

static size_t count_parts(const char *text)
{
    size_t parts = 1;

    for (; *text; text++)
        parts += *text == ',';
    return parts;
}

/* The separators that may stand between two numbers for people whose numbers have a comma. */
static const char separators[] = ",; \t";

/* The length of digits, a comma and digits, and perhaps an exponent; 0: that is not what text starts with. */
static size_t comma_length(const char *text)
{
    const char *at = text + (*text == '+' || *text == '-');
    const size_t whole = digits(at);
    const char *fraction = at + whole + 1, *end;

    if (whole == 0 || at[whole] != ',' || digits(fraction) == 0)
        return 0;
    end = fraction + number_length(fraction); /* which reads an exponent, too */
    return !*end || strchr(separators, *end) ? (size_t)(end - text) : 0;
}

/* Whether text is so many numbers once some of its commas are taken for points. */
static bool has_decimal_commas(const char *text, size_t wanted)
{
    size_t found = 0, commas = 0;

    while (*text) {
        const size_t with_comma = comma_length(text);
        const size_t length = with_comma > 0 ? with_comma : number_length(text);

        text += length;
        if (length == 0 || (*text && !strchr(separators, *text)))
            return false;
        commas += with_comma > 0;
        found += with_comma > 0 ? 2 : 1;
        text += strspn(text, separators);
    }
    return commas > 0 && found > wanted && found - commas <= wanted;
}

bool argument_numbers(const char *option, const char *form, const char *text, double *values, size_t count)
{
    const size_t parts = count_parts(text);
    const char *at = text;
    bool all_read = true;

    for (size_t i = 0; i < parts && all_read; i++) {
        const size_t length = strcspn(at, ",");
        double value;

        all_read = read_number(option, text, at, length, &value);
        if (i < count)
            values[i] = value;
        at += length + 1;
    }
    if (all_read && parts == count)
        return true;
    if (all_read)
        message_error(ngettext("%s %s: expected %zu numbers, %zu was given",
                               "%s %s: expected %zu numbers, %zu were given", parts),
                      option, text, count, parts);
    if (has_decimal_commas(text, count))
        message_hint(_("write the fraction with a point: a comma stands between two numbers, as in %s %s"), option,
                     form);
    else
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

bool argument_region(const char *option, const char *argument, luxel_region *region)
{
    size_t commas = 0;
    double numbers[4];

    for (const char *at = argument; *at; at++)
        commas += *at == ',';
    region->type = commas == 2 ? LUXEL_REGION_CIRCLE : LUXEL_REGION_RECTANGLE;
    if (!argument_numbers(option, "X,Y,W,H or X,Y,R", argument, numbers, commas == 2 ? 3 : 4))
        return false;
    memcpy(region->center_mm, numbers, sizeof region->center_mm);
    memcpy(region->size_mm, numbers + 2, sizeof region->size_mm);
    region->radius_mm = numbers[2];
    if (numbers[2] > 0.0 && (commas == 2 || numbers[3] > 0.0))
        return true;
    message_error(_("%s %s: width, height and radius must be above 0"), option, argument);
    return false;
}

bool argument_shard(const char *text, unsigned *part, unsigned *parts)
{
    const char *slash = strchr(text, '/');
    char *first = slash ? strndup(text, (size_t)(slash - text)) : NULL;
    bool good = first && argument_whole("--shard", first, 0, 65535, part) &&
                argument_whole("--shard", slash + 1, 1, 65535, parts);

    if (!slash)
        message_error(_("--shard must be I/N, part I of N: \"%s\""), text);
    free(first);
    if (good && *part > *parts) {
        message_error(_("--shard %s: there is no part %u of %u"), text, *part, *parts);
        good = false;
    }
    if (good)
        *part %= *parts;
    return good;
}

bool argument_levels(const char *text, double *levels, size_t most, size_t *count)
{
    const size_t length = strlen(text);
    char *shorter = strndup(text, length > 0 && text[length - 1] == ',' ? length - 1 : length);
    bool good;

    *count = 1;
    for (const char *at = shorter; at && *at; at++)
        *count += *at == ',';
    if (*count > most) {
        message_error(_("--levels: %zu levels are too many, %d may be given"), *count, (int)most);
        free(shorter);
        return false;
    }
    good = shorter && argument_numbers("--levels", "L1,L2,...", shorter, levels, *count);
    free(shorter);
    return good;
}

bool argument_word(const char *option, const char *argument, const char *const *words, size_t *found)
{
    char list[TEXT_SIZE] = "";
    size_t used = 0;

    for (*found = 0; words[*found]; ++*found)
        if (strcmp(argument, words[*found]) == 0)
            return true;
    for (size_t i = 0; i < *found && used < sizeof list; i++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i > 0 ? ", " : "", words[i]);
    message_error(_("%s %s: expected one of %s"), option, argument, list);
    message_did_you_mean(luxel_nearest_word(argument, words, *found));
    return false;
}

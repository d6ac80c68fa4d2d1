/* SPDX-License-Identifier: MIT */
/*
 * Numbers as text.  The grammar is checked here and the value formed by the C library under its own "C"
 * locale, so neither the program's locale nor a thread's matters; numbers of few digits are formed here.
 */
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"

/* glibc hands out its built-in object here, so this neither fails nor costs. */
static locale_t c_locale(void)
{
    return newlocale(LC_ALL_MASK, "C", (locale_t)0);
}

static size_t skip_digits(const char *text, size_t length, size_t i)
{
    while (i < length && text[i] >= '0' && text[i] <= '9')
        i++;
    return i;
}

bool lx_looks_like_number(const char *text, size_t length)
{
    size_t i = 0;
    if (i < length && (text[i] == '+' || text[i] == '-'))
        i++;
    size_t whole = skip_digits(text, length, i) - i;
    i += whole;
    size_t fraction = 0;
    if (i < length && text[i] == '.') {
        i++;
        fraction = skip_digits(text, length, i) - i;
        i += fraction;
    }
    if (whole + fraction == 0)
        return false;
    if (i < length && (text[i] == 'e' || text[i] == 'E')) {
        i++;
        if (i < length && (text[i] == '+' || text[i] == '-'))
            i++;
        size_t exponent = skip_digits(text, length, i) - i;
        if (exponent == 0)
            return false;
        i += exponent;
    }
    return i == length;
}

/*
 * A number of few digits, as most are, without the library's care: both its digits and the power of ten are exact, so
 * that one rounding makes of them what strtod() makes.  The text has the form of a number; false: it is no such one.
 */
static bool read_short(const char *text, size_t length, double *value)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    enum { GREATEST = sizeof powers / sizeof powers[0] - 1 };
    static const uint64_t most = (UINT64_C(1) << 53) / 10 - 1; /* with one more digit still exact */
    const char *at = text, *end = text + length;
    bool is_negative = *at == '-', is_fraction = false;
    uint64_t digits = 0;
    int scale = 0, exponent = 0;
    at += is_negative || *at == '+';
    for (; at < end && *at != 'e' && *at != 'E'; at++) {
        if (*at == '.') {
            is_fraction = true;
            continue;
        }
        if (digits > most)
            return false;
        digits = 10 * digits + (uint64_t)(*at - '0');
        scale -= is_fraction;
    }
    bool has_exponent = at < end, is_small = has_exponent && at[1] == '-';
    at += has_exponent ? 1 + (at[1] == '-' || at[1] == '+') : 0;
    for (; at < end && exponent <= 1000; at++)
        exponent = 10 * exponent + (*at - '0');
    scale += is_small ? -exponent : exponent;
    if (scale < -GREATEST || scale > GREATEST || FLT_EVAL_METHOD != 0)
        return false;
    double size = scale < 0 ? (double)digits / powers[-scale] : (double)digits * powers[scale];
    *value = is_negative ? -size : size;
    return true;
}

bool lx_read_number(const char *text, size_t length, double *value)
{
    char buffer[64];
    if (!lx_looks_like_number(text, length))
        return false;
    if (read_short(text, length, value))
        return true;
    char *copy = length < sizeof buffer ? buffer : lx_copy_text(text, length);
    if (!copy)
        return false;
    if (copy == buffer) {
        memcpy(buffer, text, length);
        buffer[length] = 0;
    }
    locale_t locale = c_locale();
    double number = strtod_l(copy, NULL, locale);
    freelocale(locale);
    if (copy != buffer)
        free(copy);
    if (!isfinite(number))
        return false;
    *value = number;
    return true;
}

static void print_digits(double value, int digits, char buffer[LX_NUMBER_SIZE])
{
    locale_t locale = c_locale();
    locale_t before = uselocale(locale);
    snprintf(buffer, LX_NUMBER_SIZE, "%.*g", digits, value);
    uselocale(before);
    freelocale(locale);
}

char *lx_write_number(double value, char buffer[LX_NUMBER_SIZE])
{
    /* 15 digits always survive, and %g drops their zeros; only subnormal numbers may need fewer. */
    int digits = fabs(value) < 2.3e-308 ? 1 : 15;
    for (; digits <= 17; digits++) {
        double back;
        print_digits(value, digits, buffer);
        if (lx_read_number(buffer, strlen(buffer), &back) && back == value)
            break;
    }
    return buffer;
}

char *lx_write_digits(double value, int digits, char buffer[LX_NUMBER_SIZE])
{
    enum { MOST = LX_NUMBER_SIZE - 10 }; /* beside sign, point and exponent */
    print_digits(value, digits < MOST ? digits : MOST, buffer);
    return buffer;
}

double lx_round_up(double value, int digits)
{
    char text[LX_NUMBER_SIZE];
    double rounded = 0;
    if (!(value > 0) || !isfinite(value))
        return value;
    const double grain = pow(10, floor(log10(value)) - digits + 1);
    print_digits(value, digits, text);
    if (lx_read_number(text, strlen(text), &rounded) && rounded < value) {
        print_digits(rounded + grain, digits, text);
        lx_read_number(text, strlen(text), &rounded);
    }
    return rounded < value ? value : rounded;
}

double lx_error_of_shown(const char *shown, double value, double error)
{
    double read;
    return lx_read_number(shown, strlen(shown), &read) ? error + fabs(read - value) : error;
}

char *lx_write_bound(double error, int digits, char buffer[LX_NUMBER_SIZE])
{
    return lx_write_digits(lx_round_up(error, digits), digits, buffer);
}

/* SPDX-License-Identifier: MIT */
/* Reading and writing numbers without the locale. */
#include "number.h"

#include <math.h>
#include <string.h>

#include <luxel/bounded.h>

/* Blanks that people put between groups of digits: the plain one and those of typography. */
static gsize blank_at(const char *text)
{
    static const char *const blanks[] = {" ", "\t", "\u00a0", "\u2009", "\u202f"};
    for (gsize i = 0; i < G_N_ELEMENTS(blanks); i++)
        if (g_str_has_prefix(text, blanks[i]))
            return strlen(blanks[i]);
    return 0;
}

/* Whether a blank at `text` stands between a digit and a group of three digits. */
static gboolean is_group_blank(const GString *before, const char *text, gsize blank)
{
    const char *rest = text + blank;
    return before->len > 0 && g_ascii_isdigit(before->str[before->len - 1]) && g_ascii_isdigit(rest[0]) &&
           g_ascii_isdigit(rest[1]) && g_ascii_isdigit(rest[2]) && !g_ascii_isdigit(rest[3]);
}

/* The text as C writes numbers; NULL where it is none. */
static char *as_c_number(const char *text)
{
    GString *plain = g_string_new(NULL);
    gboolean has_mark = FALSE;
    while (*text && blank_at(text))
        text += blank_at(text);
    while (*text) {
        gsize blank = blank_at(text);
        if (blank && !is_group_blank(plain, text, blank))
            break;
        if (blank) {
            text += blank;
        } else if (g_str_has_prefix(text, "\u2212")) {
            g_string_append_c(plain, '-');
            text += strlen("\u2212");
        } else if (*text == ',' || *text == '.') {
            g_string_append_c(plain, has_mark ? '?' : '.');
            has_mark = TRUE;
            text++;
        } else {
            g_string_append_c(plain, *text++);
        }
    }
    while (*text && blank_at(text))
        text += blank_at(text);
    if (*text || plain->len == 0) {
        g_string_free(plain, TRUE);
        return NULL;
    }
    return g_string_free(plain, FALSE);
}

gboolean app_number_read(const char *text, double *value)
{
    char *plain = as_c_number(text), *end;
    gboolean good = plain && strspn(plain, "+-.0123456789eE") == strlen(plain);
    if (good) {
        double read = g_ascii_strtod(plain, &end);
        good = end != plain && *end == '\0' && isfinite(read);
        if (good)
            *value = read;
    }
    g_free(plain);
    return good;
}

const char *app_number_write(double value, char text[APP_NUMBER_SIZE])
{
    for (int digits = 6; digits <= 17; digits++) {
        app_number_round(value, digits, text);
        if (g_ascii_strtod(text, NULL) == value)
            break;
    }
    return text;
}

const char *app_number_round(double value, int digits, char text[APP_NUMBER_SIZE])
{
    char format[16];
    g_snprintf(format, sizeof format, "%%.%dg", digits);
    g_ascii_formatd(text, APP_NUMBER_SIZE, format, value == 0 ? 0 : value);
    return text;
}

const char *app_number_plain(double value, int digits, char text[APP_NUMBER_SIZE])
{
    return app_number_write(g_ascii_strtod(app_number_round(value, digits, text), NULL), text);
}

static char decimal_mark = '.';

void app_number_set_mark(char mark)
{
    decimal_mark = mark;
}

static const char minus[] = "\u2212";

static const char *set_mark(char *text)
{
    char *point = strchr(text, '.');
    if (point)
        *point = decimal_mark;
    return text;
}

const char *app_number_mark(char *text)
{
    if (*text == '-') {
        memmove(text + strlen(minus), text + 1, strlen(text)); /* with the end */
        memcpy(text, minus, strlen(minus));
    }
    return set_mark(text);
}

const char *app_number_show(double value, int digits, char text[APP_NUMBER_SIZE])
{
    const gboolean is_plain = fabs(value) >= 1 && fabs(value) < 1e6; /* "13360" and not "1.336e+04" */
    (is_plain ? app_number_plain : app_number_round)(value, digits, text);
    return app_number_mark(text);
}

const char *app_bound_show(double error, int digits, char text[APP_NUMBER_SIZE])
{
    return app_number_show(luxel_round_bound(error, digits), digits, text);
}

const char *app_number_show_all(double value, char text[APP_NUMBER_SIZE])
{
    app_number_write(value, text);
    return set_mark(text);
}

const char *app_number_separator(void)
{
    return decimal_mark == ',' ? "; " : ", ";
}

static gboolean begins_number(const char *text)
{
    return g_ascii_isdigit(*text) || *text == '-' || g_str_has_prefix(text, "\u2212");
}

char *app_text_show(const char *text)
{
    GString *shown = g_string_new(NULL);
    int depth = 0; /* of brackets */
    for (const char *at = text; *at; at++) {
        const gboolean after_digit = at > text && g_ascii_isdigit(at[-1]);
        const gboolean after_word = at > text && g_ascii_isalnum(at[-1]);
        depth += *at == '(' ? 1 : *at == ')' ? -1 : 0;
        if (*at == '.' && after_digit && g_ascii_isdigit(at[1]))
            g_string_append_c(shown, decimal_mark);
        else if (*at == ',' && decimal_mark == ',' && depth > 0 && after_digit && at[1] == ' ' && begins_number(at + 2))
            g_string_append_c(shown, ';');
        else if (*at == '-' && !after_word && g_ascii_isdigit(at[1]))
            g_string_append(shown, minus);
        else
            g_string_append_c(shown, *at);
    }
    return g_string_free(shown, FALSE);
}

const char *app_amount_write(double value, double error, char text[APP_AMOUNT_SIZE])
{
    enum { DIGITS = 7 };
    char number[APP_NUMBER_SIZE], bound[APP_NUMBER_SIZE];
    const double last = error > 0 ? pow(10, floor(log10(error)) - 1) : 0;
    app_number_round(last > 0 ? round(value / last) * last : value, DIGITS, number);
    app_bound_show(error + fabs(g_ascii_strtod(number, NULL) - value), 2, bound);
    g_snprintf(text, APP_AMOUNT_SIZE, "%s ± %s", app_number_mark(number), bound);
    return text;
}

const char *app_number_place(double value, double size, char text[APP_NUMBER_SIZE])
{
    const double grain = size > 0 ? pow(10, floor(log10(size)) - 6) : 0;
    if (!(grain > 0) || !isfinite(value))
        return app_number_show(value, 7, text);
    const double whole = round(value / grain), rounded = grain < 1 ? whole / round(1 / grain) : whole * grain;
    return app_number_show(rounded, 10, text);
}

/* ---- groups ---- */

/* Reads the words of one group; TRUE where there are just `size` numbers. */
static gboolean read_words(const char *group, const char *separators, gsize size, GArray *numbers)
{
    char **words = g_strsplit_set(group, separators, -1);
    gsize found = 0;
    gboolean good = TRUE;
    for (gsize i = 0; words[i] && good; i++) {
        double number;
        if (*g_strstrip(words[i]) == '\0')
            continue;
        good = found < size && app_number_read(words[i], &number);
        if (good)
            g_array_append_val(numbers, number);
        found += good ? 1 : 0;
    }
    g_strfreev(words);
    if (!good || found != size) {
        g_array_set_size(numbers, numbers->len - (guint)MIN(found, numbers->len));
        return FALSE;
    }
    return TRUE;
}

/* Commas that set numbers apart are tried first; "0,5 1,5" has decimal commas. */
static gboolean read_group(const char *group, gsize size, GArray *numbers)
{
    return read_words(group, ", \t", size, numbers) || read_words(group, " \t", size, numbers) ||
           read_words(group, ";", size, numbers);
}

static gboolean read_groups(const char *text, const char *separators, gsize size, GArray *numbers, char **fault)
{
    char **groups = g_strsplit_set(text, separators, -1);
    gboolean good = TRUE;
    g_array_set_size(numbers, 0);
    for (gsize i = 0; groups[i] && good; i++) {
        if (*g_strstrip(groups[i]) == '\0')
            continue;
        good = read_group(groups[i], size, numbers);
        if (!good && fault)
            *fault = g_strdup(groups[i]);
    }
    g_strfreev(groups);
    return good && numbers->len > 0;
}

double *app_numbers_read(const char *text, gsize size, gsize *count, char **fault)
{
    char *plain = g_strdup(text);
    GArray *numbers = g_array_new(FALSE, FALSE, sizeof(double));
    *fault = NULL;
    for (char *c = plain; *c; c++)
        if (strchr("[](){}", *c))
            *c = ' ';
    gboolean good = read_groups(plain, ";\n\r", size, numbers, fault);
    if (!good && read_groups(plain, "\n\r", size, numbers, NULL)) {
        g_clear_pointer(fault, g_free);
        good = TRUE;
    }
    g_free(plain);
    if (!good) {
        if (!*fault)
            *fault = g_strdup("");
        g_array_free(numbers, TRUE);
        return NULL;
    }
    *count = numbers->len / size;
    return (double *)(void *)g_array_free(numbers, FALSE);
}

/* One comma between digits and nothing else that could set numbers apart: "60,5". */
static gboolean is_ambiguous(const char *text)
{
    const char *comma = strchr(text, ',');
    return comma && comma > text && !strchr(comma + 1, ',') && !strpbrk(text, ";.") && g_ascii_isdigit(comma[-1]) &&
           g_ascii_isdigit(comma[1]) && strcspn(text, " \t") == strlen(text);
}

gboolean app_pair_read(const char *text, double pair[2])
{
    GArray *numbers = g_array_new(FALSE, FALSE, sizeof(double));
    char *plain = g_strdup(text);
    for (char *c = plain; *c; c++)
        if (strchr("[](){}", *c))
            *c = ' ';
    g_strstrip(plain);
    gboolean good = !is_ambiguous(plain) &&
                    (strchr(plain, ';') ? read_words(plain, ";", 2, numbers) : read_group(plain, 2, numbers));
    if (good)
        memcpy(pair, numbers->data, 2 * sizeof *pair);
    g_array_unref(numbers);
    g_free(plain);
    return good;
}

gsize app_list_read(const char *text, double *numbers, gsize room)
{
    gsize count = 0;
    while (text && *text && count < room) {
        char *end;
        text += strspn(text, "[], \t");
        double number = g_ascii_strtod(text, &end);
        if (end == text)
            break;
        numbers[count++] = number;
        text = end;
    }
    return count;
}

char *app_list_write(const double *numbers, gsize count)
{
    GString *text = g_string_new("[");
    char number[APP_NUMBER_SIZE];
    for (gsize i = 0; i < count; i++)
        g_string_append_printf(text, "%s%s", i ? ", " : "", app_number_write(numbers[i], number));
    g_string_append_c(text, ']');
    return g_string_free(text, FALSE);
}

/* SPDX-License-Identifier: MIT */
/*
 * Messages on standard error.  A diagnostic of the library is shown the way compilers do: its place, the
 * offending line, a mark under the offending text, and a hint.  Colour is used on a terminal only.
 */
#include "message.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../front/language.h"
#include "cli.h"
#include "standard_output.h"
#include "text.h"

static bool wants_colour(FILE *stream)
{
    const char *no_colour = getenv("NO_COLOR");
    const char *terminal = getenv("TERM");

    return !(no_colour && *no_colour) && terminal && strcmp(terminal, "dumb") != 0 && isatty(fileno(stream));
}

/* The word that starts a message, in bold red or blue where colour is welcome. */
static void print_severity(FILE *stream, luxel_severity severity)
{
    const char *word = severity == LUXEL_SEVERITY_ERROR ? _("error:") : _("advice:");

    if (wants_colour(stream))
        fprintf(stream, "\033[1;%dm%s\033[0m ", severity == LUXEL_SEVERITY_ERROR ? 31 : 34, word);
    else
        fprintf(stream, "%s ", word);
}

/* Arguments of the user may hold anything, so the finished text is escaped as a whole. */
static void print_formatted(const char *format, va_list arguments)
{
    char *text = NULL;

    if (vasprintf(&text, format, arguments) < 0)
        return;
    text_print_escaped(stderr, text);
    fputc('\n', stderr);
    free(text);
}

void message_error(const char *format, ...)
{
    va_list arguments;

    fputs("luxel: ", stderr);
    print_severity(stderr, LUXEL_SEVERITY_ERROR);
    va_start(arguments, format);
    print_formatted(format, arguments);
    va_end(arguments);
}

void message_hint(const char *format, ...)
{
    va_list arguments;

    fputs(_("  hint: "), stderr);
    va_start(arguments, format);
    print_formatted(format, arguments);
    va_end(arguments);
}

void message_tolerance(size_t missed, size_t count)
{
    message_error(_("results whose error is above the tolerance: %zu of %zu"), missed, count);
    message_hint(_("they are printed with their errors; --tolerance T allows another one"));
}

void message_did_you_mean(const char *nearest)
{
    if (nearest)
        message_hint(_("did you mean %s?"), nearest);
}

void message_note(const char *format, ...)
{
    va_list arguments;

    fputs("luxel: ", stderr);
    va_start(arguments, format);
    print_formatted(format, arguments);
    va_end(arguments);
}

static int exit_code_of(luxel_status status)
{
    switch (status) {
    case LUXEL_OK: return EXIT_DONE;
    case LUXEL_ERROR_ARGUMENT:
    case LUXEL_ERROR_PATH: return EXIT_USAGE;
    case LUXEL_ERROR_FILE: return EXIT_FILE;
    case LUXEL_CANCELLED: return EXIT_INTERRUPTED;
    case LUXEL_ERROR_SCENE:
    case LUXEL_ERROR_MEMORY:
    case LUXEL_ERROR_RANGE: break;
    }
    return EXIT_SCENE;
}

static void print_repeated(FILE *stream, char character, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        fputc(character, stream);
}

/* The offending line, already escaped by the library, and the mark under it. */
static void print_excerpt(FILE *stream, const luxel_diagnostic *entry)
{
    fprintf(stream, "    %s\n    ", entry->excerpt);
    print_repeated(stream, ' ', entry->mark_offset);
    fputc('^', stream);
    print_repeated(stream, '~', entry->mark_length > 1 ? entry->mark_length - 1 : 0);
    fputc('\n', stream);
}

static void print_entry(FILE *stream, const luxel_diagnostics *diagnostics, size_t i, luxel_severity shown_as)
{
    const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
    char *message = luxel_diagnostics_message(diagnostics, i, language_translate, NULL);
    char *hint = luxel_diagnostics_hint(diagnostics, i, language_translate, NULL);

    text_print_escaped(stream, entry->source ? entry->source : "luxel");
    if (entry->line > 0 && entry->column > 0)
        fprintf(stream, ":%u:%u", entry->line, entry->column);
    else if (entry->line > 0)
        fprintf(stream, ":%u", entry->line);
    fputs(": ", stream);
    print_severity(stream, shown_as);
    fprintf(stream, "%s\n", message ? message : entry->id);
    if (entry->excerpt)
        print_excerpt(stream, entry);
    if (hint && *hint)
        fprintf(stream, _("  hint: %s\n"), hint);
    luxel_text_free(message);
    luxel_text_free(hint);
}

/* Whether two diagnostics say the same of two elements of one list, whose numbers are set. */
static bool are_alike(const luxel_diagnostic *a, const luxel_diagnostic *b, unsigned long index[2])
{
    const size_t list = a->key ? strcspn(a->key, "[") : 0;
    char *ends[2];

    if (!a->key || !b->key || !a->key[list] || strcmp(a->id, b->id) != 0 || strncmp(a->key, b->key, list + 1) != 0)
        return false;
    index[0] = strtoul(a->key + list + 1, &ends[0], 10);
    index[1] = strtoul(b->key + list + 1, &ends[1], 10);
    return strcmp(ends[0], ends[1]) == 0;
}

static bool is_told_before(const luxel_diagnostics *diagnostics, size_t i)
{
    unsigned long index[2];

    for (size_t k = 0; k < i; k++)
        if (are_alike(luxel_diagnostics_get(diagnostics, k), luxel_diagnostics_get(diagnostics, i), index))
            return true;
    return false;
}

static void print_range(FILE *stream, const luxel_diagnostic *entry, unsigned long first, unsigned long last,
                        bool is_first)
{
    const int list = (int)strcspn(entry->key, "[");

    fputs(is_first ? _("  likewise: ") : ", ", stream);
    fprintf(stream, "%.*s[%lu]", list, entry->key, first);
    if (last > first)
        fprintf(stream, last > first + 1 ? " … %.*s[%lu]" : ", %.*s[%lu]", list, entry->key, last);
}

/* The other elements of the list of which entry i goes, too.  Returns how many there are. */
static size_t print_alike(FILE *stream, const luxel_diagnostics *diagnostics, size_t i)
{
    const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
    unsigned long index[2], first = 0, last = 0;
    size_t found = 0;
    bool is_first = true;

    for (size_t k = i + 1; k < luxel_diagnostics_count(diagnostics); k++) {
        if (!are_alike(entry, luxel_diagnostics_get(diagnostics, k), index))
            continue;
        if (found++ > 0 && index[1] == last + 1) {
            last++;
            continue;
        }
        if (found > 1) {
            print_range(stream, entry, first, last, is_first);
            is_first = false;
        }
        first = last = index[1];
    }
    if (found > 0) {
        print_range(stream, entry, first, last, is_first);
        fputc('\n', stream);
    }
    return found;
}

void message_diagnostics(FILE *stream, const luxel_diagnostics *diagnostics, luxel_severity severity,
                         luxel_severity shown_as)
{
    const size_t count = luxel_diagnostics_count(diagnostics);
    size_t left = luxel_diagnostics_total(diagnostics, severity);

    for (size_t i = 0; i < count; i++) {
        const bool groups = severity == LUXEL_SEVERITY_ADVICE; /* what is wrong is told one by one */

        if (luxel_diagnostics_get(diagnostics, i)->severity != severity || (groups && is_told_before(diagnostics, i)))
            continue;
        print_entry(stream, diagnostics, i, shown_as);
        left -= groups ? 1 + print_alike(stream, diagnostics, i) : 1;
    }
    if (left > 0 && shown_as == LUXEL_SEVERITY_ERROR)
        fprintf(stream, ngettext("and %zu more error\n", "and %zu more errors\n", left), left);
    else if (left > 0)
        fprintf(stream, ngettext("and %zu more line of advice\n", "and %zu more lines of advice\n", left), left);
}

bool message_reflected(luxel_diagnostics *diagnostics)
{
    static const char *const missed[] = {"reflected-error", "balance-error"};
    const size_t count = luxel_diagnostics_count(diagnostics);
    size_t last = count; /* a report has several pictures of one scene: one line tells it of all */

    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < COUNT_OF(missed); k++)
            if (strcmp(luxel_diagnostics_get(diagnostics, i)->id, missed[k]) == 0)
                last = i;
    if (last == count)
        return true;
    print_entry(stderr, diagnostics, last, LUXEL_SEVERITY_ERROR);
    message_hint(_("it is made all the same; --reflected-error R allows another share"));
    luxel_diagnostics_clear(diagnostics);
    return false;
}

void message_passed_over(luxel_diagnostics *diagnostics, bool quiet)
{
    if (!quiet)
        message_diagnostics(stderr, diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ADVICE);
    luxel_diagnostics_clear(diagnostics);
}

/* Whether all that went wrong is that a reader of `-o -` has seen enough. */
static bool is_reader_left(const luxel_diagnostics *diagnostics)
{
    bool is_about_it = luxel_diagnostics_count(diagnostics) > 0 && standard_output_reader_left();

    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics) && is_about_it; i++) {
        char *message = luxel_diagnostics_message(diagnostics, i, NULL, NULL);

        is_about_it = message && standard_output_is_named(message);
        luxel_text_free(message);
    }
    return is_about_it;
}

int message_failure(luxel_status status, luxel_diagnostics *diagnostics)
{
    const size_t errors = luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR);

    if (status == LUXEL_ERROR_FILE && is_reader_left(diagnostics))
        return EXIT_DONE;
    if (errors > 0 && luxel_diagnostics_count(diagnostics) > 0)
        message_diagnostics(stderr, diagnostics, LUXEL_SEVERITY_ERROR, LUXEL_SEVERITY_ERROR);
    else if (status == LUXEL_ERROR_MEMORY) /* which may not have done for the report of it */
        message_error(_("out of memory"));
    else
        message_error(_("the library failed with status %d"), (int)status);
    return exit_code_of(status);
}

int message_table_failure(luxel_status status, luxel_diagnostics *diagnostics, const char *form)
{
    const luxel_diagnostic *first = luxel_diagnostics_get(diagnostics, 0);
    const int code = message_failure(status, diagnostics);

    if (status == LUXEL_ERROR_FILE && first && strcmp(first->id, "file-not-read") != 0)
        message_hint("%s", form);
    return code;
}

static _Noreturn void die_of_memory(void)
{
    message_error(_("out of memory"));
    exit(EXIT_SCENE);
}

luxel_diagnostics *message_new_diagnostics(void)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();

    if (!diagnostics)
        die_of_memory();
    return diagnostics;
}

void *message_allocate(size_t count, size_t size)
{
    void *memory = calloc(count > 0 ? count : 1, size);

    if (!memory)
        die_of_memory();
    return memory;
}

/* SPDX-License-Identifier: MIT */
/* From a row of a table to an answer; and from a folder to its tables. */
#include "answers.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include <luxel/luxel.h>

#include "../front/language.h"
#include "cli.h"
#include "message.h"
#include "text.h"

enum column { VARIANT, VALUE, POINT, X, Y, STUDENT, GIVEN_NAME, COLUMN_COUNT };

/* How the columns may be called; a heading may go on with a unit, as in x_mm. */
static const char *const variant_names[] = {"variant", "вариант", NULL};
static const char *const value_names[] = {"value", "answer", "значение", "ответ", NULL};
static const char *const point_names[] = {"point", "точка", NULL};
static const char *const x_names[] = {"x", "х", NULL};
static const char *const y_names[] = {"y", "у", NULL};
static const char *const student_names[] = {"student", "name", "surname", "студент", "фамилия", "фио", NULL};
static const char *const given_names[] = {"first name", "given name", "имя", NULL};

static const luxel_table_column columns[COLUMN_COUNT] = {
    [VARIANT] = {.type = LUXEL_TABLE_TEXT, .is_required = true, .names = variant_names},
    [VALUE] = {.type = LUXEL_TABLE_TEXT, .is_required = true, .names = value_names},
    [POINT] = {.type = LUXEL_TABLE_TEXT, .is_required = false, .names = point_names},
    [X] = {.type = LUXEL_TABLE_LENGTH, .is_required = false, .names = x_names},
    [Y] = {.type = LUXEL_TABLE_LENGTH, .is_required = false, .names = y_names},
    [STUDENT] = {.type = LUXEL_TABLE_TEXT, .is_required = false, .names = student_names},
    [GIVEN_NAME] = {.type = LUXEL_TABLE_TEXT, .is_required = false, .names = given_names},
};

struct table {
    struct answers *answers;
    const char *path;
    luxel_table *reader;
    const luxel_table_row *row;
};

static char *copy_text(const char *text)
{
    char *copy = message_allocate(strlen(text) + 1, 1);

    return strcpy(copy, text);
}

/* Doubles an array, whose old memory is freed. */
static void *grow(void *list, size_t *capacity, size_t size)
{
    const size_t more = *capacity > 0 ? 2 * *capacity : 16;
    void *grown = message_allocate(more, size);

    if (*capacity > 0)
        memcpy(grown, list, *capacity * size);
    free(list);
    *capacity = more;
    return grown;
}

/* "FILE:line:column: error: ..." */
__attribute__((format(printf, 4, 0))) static void report_at(const char *path, unsigned line, unsigned column,
                                                            const char *format, va_list arguments)
{
    char *text = NULL;

    text_print_escaped(stderr, path);
    fprintf(stderr, ":%u:%u: %s ", line, column, _("error:"));
    if (vasprintf(&text, format, arguments) >= 0)
        text_print_escaped(stderr, text);
    fputc('\n', stderr);
    free(text);
}

/* Reports at a field of the row. */
__attribute__((format(printf, 3, 4))) static void report(struct table *table, enum column column, const char *format,
                                                         ...)
{
    unsigned line, place;
    va_list arguments;

    luxel_table_place(table->reader, column, &line, &place);
    table->answers->mistakes++;
    va_start(arguments, format);
    report_at(table->path, line, place, format, arguments);
    va_end(arguments);
}

static const char *text_of(const struct table *table, enum column column)
{
    return table->row->texts[column];
}

static bool take_whole(struct table *table, enum column column, const char *text, unsigned most, unsigned *number)
{
    const size_t digits = strspn(text, "0123456789");
    const unsigned long value = digits > 0 && digits < 8 ? strtoul(text, NULL, 10) : 0;

    *number = (unsigned)value;
    if (digits > 0 && text[digits] == '\0' && value >= 1 && value <= most)
        return true;
    report(table, column, _("expected a whole number from 1 to %u, not \"%s\""), most, text_of(table, column));
    return false;
}

static bool is_one_of(const char *text, const char *const *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (strcasecmp(text, words[i]) == 0)
            return true;
    return false;
}

/* An answer may say that there is nothing to be seen, and a cell that there is no answer. */
static bool take_value(struct table *table, struct answer *answer)
{
    static const char *const off[] = {"off", "nan", "none"};
    static const char *const blank[] = {"", "-", "–", "—", "?", "n/a", "нет", "Нет", "НЕТ"};
    const char *text = text_of(table, VALUE);

    answer->is_blank = is_one_of(text, blank, COUNT_OF(blank));
    if (answer->is_blank || is_one_of(text, off, COUNT_OF(off))) {
        answer->value = (double)NAN;
        return true;
    }
    if (luxel_table_number(text, &answer->value, &answer->rounding))
        return true;
    report(table, VALUE, _("expected a number, not \"%s\""), text);
    return false;
}

static bool take_place(struct table *table, struct answer *answer)
{
    const char *point = text_of(table, POINT);

    if (*point == '\0' && luxel_table_has(table->reader, X) && luxel_table_has(table->reader, Y)) {
        answer->x_mm = table->row->numbers[X];
        answer->y_mm = table->row->numbers[Y];
        if (isfinite(answer->x_mm) && isfinite(answer->y_mm))
            return true;
        report(table, isfinite(answer->x_mm) ? Y : X, _("expected a number, not \"%s\""), "");
        return false;
    }
    return take_whole(table, POINT, point + (*point == 'P' || *point == 'p'), 1000, &answer->point);
}

/* "Ivanov Pyotr", of one or two columns; NULL where both are empty. */
static char *copy_name(const char *name, const char *given)
{
    char *copy;

    if (*name == '\0' && *given == '\0')
        return NULL;
    copy = message_allocate(strlen(name) + strlen(given) + 2, 1);
    stpcpy(stpcpy(stpcpy(copy, name), *name != '\0' && *given != '\0' ? " " : ""), given);
    return copy;
}

static void read_row(struct table *table)
{
    struct answers *answers = table->answers;
    struct answer answer = {.file = answers->file_count - 1};
    unsigned unused;

    luxel_table_place(table->reader, VARIANT, &answer.line, &unused);
    if (!take_whole(table, VARIANT, text_of(table, VARIANT), LUXEL_LAST_VARIANT, &answer.variant) ||
        !take_place(table, &answer) || !take_value(table, &answer))
        return;
    answer.student = copy_name(text_of(table, STUDENT), text_of(table, GIVEN_NAME));
    if (answers->count == answers->capacity)
        answers->list = grow(answers->list, &answers->capacity, sizeof *answers->list);
    answers->list[answers->count++] = answer;
}

/* Tells what the library found, of which it keeps only so much, and makes room for more. */
static void tell_mistakes(struct table *table, luxel_diagnostics *diagnostics)
{
    table->answers->mistakes += luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR);
    message_diagnostics(stderr, diagnostics, LUXEL_SEVERITY_ERROR, LUXEL_SEVERITY_ERROR);
    luxel_diagnostics_clear(diagnostics);
}

/* Whether answers say where they are from. */
static bool has_places(struct table *table)
{
    const bool has_point = luxel_table_has(table->reader, POINT);

    if (has_point || (luxel_table_has(table->reader, X) && luxel_table_has(table->reader, Y)))
        return true;
    table->answers->mistakes++;
    message_error(_("%s: the first line must name the columns: variant,x,y,value or variant,point,value"), table->path);
    return false;
}

static void read_table(const char *path, struct answers *answers)
{
    struct table table = {.answers = answers, .path = path};
    luxel_diagnostics *diagnostics = message_new_diagnostics();

    if (answers->file_count == answers->file_capacity)
        answers->files = grow(answers->files, &answers->file_capacity, sizeof *answers->files);
    answers->files[answers->file_count++] = copy_text(path);
    if (luxel_table_open(path, columns, COLUMN_COUNT, true, diagnostics, &table.reader) != LUXEL_OK) {
        tell_mistakes(&table, diagnostics);
    } else if (message_passed_over(diagnostics, answers->is_quiet), has_places(&table)) {
        while (luxel_table_next(table.reader, &table.row))
            if (table.row)
                read_row(&table);
            else
                tell_mistakes(&table, diagnostics);
    }
    luxel_table_free(table.reader);
    luxel_diagnostics_free(diagnostics);
}

static bool is_table(const char *name)
{
    const char *ending = strrchr(name, '.');

    return ending && ending > name && (strcasecmp(ending, ".csv") == 0 || strcasecmp(ending, ".tsv") == 0);
}

static int is_shown(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

static int by_name(const struct dirent **one, const struct dirent **other)
{
    return strcmp((*one)->d_name, (*other)->d_name);
}

static void read_folder(const char *path, struct answers *answers)
{
    struct dirent **entries = NULL;
    const int count = scandir(path, &entries, is_shown, by_name);
    int tables = 0;

    if (count < 0)
        message_error(_("the folder %s could not be read: %s"), path, language_reason(errno));
    for (int i = 0; i < count; i++) {
        char *file = message_allocate(strlen(path) + strlen(entries[i]->d_name) + 2, 1);

        stpcpy(stpcpy(stpcpy(file, path), path[strlen(path) - 1] == '/' ? "" : "/"), entries[i]->d_name);
        if (is_table(file)) {
            read_table(file, answers);
            tables++;
        } else if (!answers->is_quiet) {
            message_note(_("skipped: %s is no .csv or .tsv file"), file);
        }
        free(file);
        free(entries[i]);
    }
    free(entries);
    if (count >= 0 && tables == 0)
        message_error(_("there is no .csv or .tsv file in the folder %s"), path);
    answers->mistakes += tables == 0;
}

void answers_read(const char *path, struct answers *answers)
{
    struct stat status;

    if (*path != '\0' && stat(path, &status) == 0 && S_ISDIR(status.st_mode))
        read_folder(path, answers);
    else
        read_table(path, answers);
}

void answers_report(struct answers *answers, const struct answer *answer, const char *format, ...)
{
    va_list arguments;

    answers->mistakes++;
    va_start(arguments, format);
    report_at(answers->files[answer->file], answer->line, 1, format, arguments);
    va_end(arguments);
}

void answers_clear(struct answers *answers)
{
    for (size_t i = 0; i < answers->count; i++)
        free(answers->list[i].student);
    for (size_t i = 0; i < answers->file_count; i++)
        free(answers->files[i]);
    free(answers->list);
    free(answers->files);
}

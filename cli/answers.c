/* SPDX-License-Identifier: MIT */
/* From a line of a table, cut into fields, to an answer; and from a folder to its tables. */
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
#include "answer_fields.h"
#include "cli.h"
#include "message.h"

enum { MOST_FIELDS = 64, NO_COLUMN = MOST_FIELDS };

enum column { VARIANT, POINT, X, Y, VALUE, STUDENT, COLUMN_COUNT };

/* How the columns may be called; a heading may go on with a unit, as in x_mm. */
static const struct {
    enum column column;
    const char *name;
} headings[] = {
    {VARIANT, "variant"},
    {VARIANT, "вариант"},
    {VARIANT, "Вариант"},
    {POINT, "point"},
    {POINT, "точка"},
    {POINT, "Точка"},
    {X, "x"},
    {Y, "y"},
    {VALUE, "value"},
    {VALUE, "значение"},
    {VALUE, "Значение"},
    {STUDENT, "student"},
    {STUDENT, "name"},
    {STUDENT, "студент"},
    {STUDENT, "Студент"},
};

struct table {
    struct answers *answers;
    struct fields fields;
    size_t columns[COLUMN_COUNT]; /* the index of each, or NO_COLUMN */
    size_t width;                 /* fields of the header */
};

/* Reports at a field of the line just read; beyond the last one at the line's beginning. */
#define REPORT(table, field, ...)                                                                                      \
    do {                                                                                                               \
        (table)->answers->mistakes++;                                                                                  \
        fields_report(&(table)->fields, (field), __VA_ARGS__);                                                         \
    } while (0)

static enum column column_of(const char *heading)
{
    for (size_t i = 0; i < COUNT_OF(headings); i++) {
        const size_t length = strlen(headings[i].name);

        if (strncasecmp(heading, headings[i].name, length) == 0 &&
            (heading[length] == '\0' || heading[length] == '_' || heading[length] == ',' || heading[length] == ' '))
            return headings[i].column;
    }
    return COLUMN_COUNT;
}

static bool read_header(struct table *table)
{
    bool doubled = false;

    table->width = table->fields.count;
    for (size_t c = 0; c < COLUMN_COUNT; c++)
        table->columns[c] = NO_COLUMN;
    for (size_t i = 0; i < table->width; i++) {
        const enum column column = column_of(table->fields.list[i].text);

        if (column == COLUMN_COUNT)
            continue;
        if (table->columns[column] != NO_COLUMN) {
            REPORT(table, i, _("the column \"%s\" is there twice"), table->fields.list[i].text);
            doubled = true;
        }
        table->columns[column] = i;
    }
    if (doubled)
        return false;
    if (table->columns[VARIANT] != NO_COLUMN && table->columns[VALUE] != NO_COLUMN &&
        (table->columns[POINT] != NO_COLUMN || (table->columns[X] != NO_COLUMN && table->columns[Y] != NO_COLUMN)))
        return true;
    REPORT(table, 0, _("the first line must name the columns: variant,x,y,value or variant,point,value"));
    return false;
}

static const char *text_of(const struct table *table, enum column column)
{
    return table->fields.list[table->columns[column]].text;
}

static bool take_number(struct table *table, enum column column, double *number, double *rounding)
{
    const size_t field = table->columns[column];

    if (fields_number(&table->fields, field, number, rounding))
        return true;
    REPORT(table, field, _("a number is expected, not \"%s\""), table->fields.list[field].text);
    return false;
}

static bool take_whole(struct table *table, enum column column, const char *text, unsigned most, unsigned *number)
{
    const size_t digits = strspn(text, "0123456789");
    const unsigned long value = digits > 0 && digits < 8 ? strtoul(text, NULL, 10) : 0;

    *number = (unsigned)value;
    if (digits > 0 && text[digits] == '\0' && value >= 1 && value <= most)
        return true;
    REPORT(table, table->columns[column], _("a whole number from 1 to %u is expected, not \"%s\""), most,
           text_of(table, column));
    return false;
}

/* An answer may say that there is nothing to be seen. */
static bool take_value(struct table *table, struct answer *answer)
{
    static const char *const off[] = {"off", "-", "nan", "none"};
    const char *text = text_of(table, VALUE);

    for (size_t i = 0; i < COUNT_OF(off); i++)
        if (strcasecmp(text, off[i]) == 0) {
            answer->value = (double)NAN;
            return true;
        }
    if (*text != '\0')
        return take_number(table, VALUE, &answer->value, &answer->rounding);
    REPORT(table, table->columns[VALUE], _("a value is missing; \"off\" stands for a place off the surface"));
    return false;
}

static bool take_place(struct table *table, struct answer *answer)
{
    const char *point = table->columns[POINT] != NO_COLUMN ? text_of(table, POINT) : "";
    double unused;

    if (*point == '\0' && table->columns[X] != NO_COLUMN && table->columns[Y] != NO_COLUMN)
        return take_number(table, X, &answer->x_mm, &unused) && take_number(table, Y, &answer->y_mm, &unused);
    return take_whole(table, POINT, point + (*point == 'P' || *point == 'p'), 1000, &answer->point);
}

static void read_line(struct table *table)
{
    struct answers *answers = table->answers;
    struct answer answer = {.file = answers->file_count - 1, .line = table->fields.list[0].line};

    if (table->fields.count != table->width) {
        REPORT(table, 0, _("this line has %zu fields, but the first one has %zu"), table->fields.count, table->width);
        if (table->fields.separator == ',' && table->fields.count > table->width)
            message_hint(_("numbers with decimal commas need quotes, or semicolons between the fields"));
        return;
    }
    if (!take_whole(table, VARIANT, text_of(table, VARIANT), LUXEL_LAST_VARIANT, &answer.variant) ||
        !take_place(table, &answer) || !take_value(table, &answer))
        return;
    if (table->columns[STUDENT] != NO_COLUMN && *text_of(table, STUDENT) != '\0')
        answer.student = message_copy(text_of(table, STUDENT));
    if (answers->count == answers->capacity)
        answers->list = message_grow(answers->list, &answers->capacity, sizeof *answers->list);
    answers->list[answers->count++] = answer;
}

static void read_table(const char *path, struct answers *answers)
{
    struct table table = {.answers = answers};
    enum fields_end end;

    if (answers->file_count == answers->file_capacity)
        answers->files = message_grow(answers->files, &answers->file_capacity, sizeof *answers->files);
    answers->files[answers->file_count++] = message_copy(path);
    if (!fields_open(path, &table.fields)) {
        answers->mistakes++;
        return;
    }
    end = fields_next(&table.fields);
    if (end == FIELDS_DONE) {
        answers->mistakes++;
        message_error(_("%s: there is nothing in it"), path);
    } else if (end == FIELDS_LINE && read_header(&table)) {
        while ((end = fields_next(&table.fields)) == FIELDS_LINE)
            read_line(&table);
    }
    answers->mistakes += end == FIELDS_BROKEN;
    fields_close(&table.fields);
}

static int is_table(const struct dirent *entry)
{
    const size_t length = strlen(entry->d_name);

    return length > 4 && entry->d_name[0] != '.' && strcasecmp(entry->d_name + length - 4, ".csv") == 0;
}

static int by_name(const struct dirent **one, const struct dirent **other)
{
    return strcmp((*one)->d_name, (*other)->d_name);
}

static void read_folder(const char *path, struct answers *answers)
{
    struct dirent **entries = NULL;
    const int count = scandir(path, &entries, is_table, by_name);

    if (count <= 0) {
        answers->mistakes++;
        message_error(count < 0 ? _("the folder %s could not be read: %s")
                                : _("there is no .csv file in the folder %s"),
                      path, language_reason(errno));
    }
    for (int i = 0; i < count; i++) {
        char *file = message_allocate(strlen(path) + strlen(entries[i]->d_name) + 2, 1);

        stpcpy(stpcpy(stpcpy(file, path), path[strlen(path) - 1] == '/' ? "" : "/"), entries[i]->d_name);
        read_table(file, answers);
        free(file);
        free(entries[i]);
    }
    free(entries);
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
    fields_report_at(answers->files[answer->file], answer->line, 1, format, arguments);
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

/* SPDX-License-Identifier: MIT */
/* Headings of tables: which field names which column, and in what unit. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "text_table_read.h"

/* What lengths may be in, and how many mm that is. */
static const struct {
    const char *name;
    double mm;
} LENGTHS[] = {
    {"mm", 1},    {"millimetres", 1}, {"millimeters", 1}, {"мм", 1},        {"cm", 10},    {"см", 10},
    {"m", 1000},  {"м", 1000},        {"metres", 1000},   {"meters", 1000}, {"µm", 1e-3},  {"μm", 1e-3},
    {"um", 1e-3}, {"мкм", 1e-3},      {"in", 25.4},       {"inch", 25.4},   {"ft", 304.8},
};

/* Names of columns that only number or name the rows: nobody misses them. */
static const char *const LABELS[] = {"",  "index", "unnamed: 0", "id",       "n",    "no",    "no.", "nr",   "№",
                                     "#", "i",     "row",        "rownames", "name", "label", "имя", "номер"};

/* ---- letters ---- */

/* Latin and Russian letters in lower case and no-break spaces as blanks, with as many bytes as before. */
static void lower(char *text)
{
    unsigned char *at = (unsigned char *)text;
    for (; *at; at++) {
        if (*at >= 'A' && *at <= 'Z') {
            *at |= 0x20;
        } else if (*at == 0xC2 && at[1] == 0xA0) {
            at[0] = at[1] = ' ';
            at++;
        } else if (*at == 0xD0 && at[1] == 0x81) { /* Ё */
            at[0] = 0xD1;
            *++at = 0x91;
        } else if (*at == 0xD0 && at[1] >= 0x90 && at[1] <= 0x9F) {
            *++at += 0x20;
        } else if (*at == 0xD0 && at[1] >= 0xA0 && at[1] <= 0xAF) {
            at[0] = 0xD1;
            *++at -= 0x20;
        }
    }
}

/* The text of a field in UTF-8, without doubled quotes; NULL: out of memory. */
static char *text_of(const struct lx_text_table_field *field)
{
    struct lx_text text = {0};
    lx_text_table_add(&text, field);
    return lx_text_take(&text);
}

/* ---- names ---- */

/* What stands behind a name: nothing, or a unit set off from it, of which `*unit` and `*length` are the bare one. */
static bool set_off(const char *rest, const char **unit, size_t *length, bool *in_brackets)
{
    *unit = rest + strspn(rest, "_ ,/([{:");
    *in_brackets = memchr(rest, '(', (size_t)(*unit - rest)) || memchr(rest, '[', (size_t)(*unit - rest));
    *length = strlen(*unit);
    while (*length > 0 && strchr(*unit > rest && strchr("([{", (*unit)[-1]) ? " )]}" : " ", (*unit)[*length - 1]))
        --*length;
    return *rest == '\0' || *unit > rest;
}

struct named {
    size_t column, synonym; /* which name of which column it is */
    const char *unit;
    size_t unit_length;
    double factor; /* of a length; 0: its unit is none */
};

static double length_in_mm(const char *unit, size_t length)
{
    for (size_t i = 0; i < sizeof LENGTHS / sizeof *LENGTHS; i++)
        if (strlen(LENGTHS[i].name) == length && memcmp(LENGTHS[i].name, unit, length) == 0)
            return LENGTHS[i].mm;
    return length == 0;
}

/* The column that a heading in lower case names. */
static bool find_column(const struct lx_text_table_form *form, const char *heading, struct named *named)
{
    for (size_t c = 0; c < form->count; c++)
        for (size_t s = 0; form->columns[c].names[s]; s++) {
            const char *name = form->columns[c].names[s];
            bool in_brackets;
            *named = (struct named){.column = c, .synonym = s, .factor = 1};
            if (strncmp(heading, name, strlen(name)) != 0 ||
                !set_off(heading + strlen(name), &named->unit, &named->unit_length, &in_brackets))
                continue;
            if (form->columns[c].type == LUXEL_TABLE_LENGTH)
                named->factor = length_in_mm(named->unit, named->unit_length);
            if (named->factor > 0 || in_brackets)
                return true;
        }
    return false;
}

void lx_text_table_list_columns(const struct lx_text_table_form *form, char *list, size_t size)
{
    *list = '\0';
    for (size_t c = 0; c < form->count; c++) {
        size_t used = strlen(list), length = strlen(form->columns[c].names[0]) + 2;
        if (used + length >= size)
            return;
        strcpy(list + used, used > 0 ? ", " : "");
        strcat(list, form->columns[c].names[0]);
    }
}

/* All names by which columns are known: "value/answer, x, y"; letters that only look alike are told once. */
static bool add_names(struct lx_text *text, const struct lx_text_table_form *form)
{
    for (size_t c = 0; c < form->count; c++)
        for (size_t s = 0; form->columns[c].names[s]; s++) {
            const char *name = form->columns[c].names[s];
            if (s > 0 && strlen(form->columns[c].names[0]) == 1 && strlen(name) <= 2)
                continue;
            lx_text_puts(text, s > 0 ? "/" : c > 0 ? ", " : "");
            lx_text_puts(text, name);
        }
    return !text->failed;
}

void lx_text_table_report_unused(const struct lx_text_table *table, const char *name, luxel_diagnostics *diagnostics)
{
    struct lx_text names = {0};
    char list[LX_UNUSED_SIZE];
    if (table->unused_count == 0)
        return;
    const struct lx_place place = lx_text_table_place_of(&table->unused[0], name);
    lx_text_table_list_unused(table, list, sizeof list);
    lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, &place, LX_MSG_TABLE_UNUSED, LX_ARGS(list));
    if (add_names(&names, table->form))
        lx_hint(diagnostics, LX_MSG_HINT_TABLE_COLUMNS, LX_ARGS(names.bytes));
    lx_text_clear(&names);
}

void lx_text_table_list_unused(const struct lx_text_table *table, char *list, size_t size)
{
    size_t used = 0;
    *list = '\0';
    for (size_t i = 0; i < table->unused_count; i++) {
        const char *name = table->unused[i].words[0];
        bool fits = used + strlen(name) + sizeof "\"\", ..." < size;
        used += (size_t)snprintf(list + used, size - used, fits ? "%s\"%s\"" : "%s...", i > 0 ? ", " : "", name);
        if (!fits)
            return;
    }
}

/* ---- the whole heading ---- */

static void forget(struct lx_text_table *table)
{
    for (size_t c = 0; c < LX_MOST_COLUMNS; c++) {
        table->places[c] = LX_NO_FIELD;
        table->factors[c] = 1;
        free(table->units[c]);
        table->units[c] = NULL;
    }
    table->unused_count = 0;
}

static bool is_label(const char *name)
{
    for (size_t i = 0; i < sizeof LABELS / sizeof *LABELS; i++)
        if (strcmp(LABELS[i], name) == 0)
            return true;
    return false;
}

/* Notes a column that is passed over. */
static bool pass_over(struct lx_text_table *table, size_t field)
{
    const struct lx_text_table_field *at = &table->lines.fields[field];
    char *text = text_of(at), *name = text ? lx_copy_text(text, strlen(text)) : NULL;
    bool is_done = name;
    if (name)
        lower(name);
    if (name && !is_label(name)) {
        is_done =
            lx_reserve(&table->unused, &table->unused_capacity, table->unused_count + 1, sizeof *table->unused) == 0;
        if (is_done)
            table->unused[table->unused_count++] =
                lx_text_table_fault_here(table, LX_MSG_TABLE_UNUSED, at->at, at->length, LX_ARGS(text));
    }
    free(name);
    free(text);
    return is_done;
}

/* The best of the fields that name a column gets it; a second one as good is a fault. */
static bool give_column(struct lx_text_table *table, size_t field, const struct named *named, size_t *synonyms,
                        const char *text, const char *heading, struct lx_text_table_fault *fault)
{
    size_t c = named->column;
    const struct lx_text_table_field *at = &table->lines.fields[field];
    const char *name = table->form->columns[c].names[0];
    if (synonyms[c] == named->synonym && fault->message == LX_MSG_COUNT)
        *fault = lx_text_table_fault_here(table, LX_MSG_TABLE_TWICE, at->at, at->length, LX_ARGS(name));
    if (synonyms[c] <= named->synonym)
        return pass_over(table, field);
    if (table->places[c] != LX_NO_FIELD && !pass_over(table, table->places[c]))
        return false;
    const char *unit = text + (named->unit - heading);
    char *copy = lx_copy_text(unit, named->unit_length);
    if (!copy)
        return false;
    if (named->factor == 0 && fault->message == LX_MSG_COUNT) {
        *fault = lx_text_table_fault_here(table, LX_MSG_TABLE_UNIT, at->at, at->length, LX_ARGS(copy, name));
        fault->hint = LX_MSG_HINT_TABLE_UNITS;
    }
    free(table->units[c]);
    table->units[c] = copy;
    table->factors[c] = named->factor;
    table->places[c] = field;
    synonyms[c] = named->synonym;
    return true;
}

/* One field of the heading; false where out of memory. */
static bool take_field(struct lx_text_table *table, size_t field, size_t *synonyms, struct lx_text_table_fault *fault)
{
    char *text = text_of(&table->lines.fields[field]);
    char *heading = text ? lx_copy_text(text, strlen(text)) : NULL;
    struct named named;
    bool is_done = heading;
    if (heading)
        lower(heading);
    if (is_done && find_column(table->form, heading, &named))
        is_done = give_column(table, field, &named, synonyms, text, heading, fault);
    else if (is_done)
        is_done = pass_over(table, field);
    free(text);
    free(heading);
    return is_done;
}

bool lx_text_table_take_heading(struct lx_text_table *table, struct lx_text_table_fault *fault)
{
    size_t synonyms[LX_MOST_COLUMNS], count = lx_text_table_trimmed(table, 0);
    struct lx_text_table_fault found = {.message = LX_MSG_COUNT};
    for (size_t c = 0; c < LX_MOST_COLUMNS; c++)
        synonyms[c] = SIZE_MAX;
    forget(table);
    for (size_t i = 0; i < count; i++)
        if (!take_field(table, i, synonyms, &found)) {
            *fault = lx_text_table_fault_of(LX_MSG_OUT_OF_MEMORY, NULL);
            return true;
        }
    bool has_all = true;
    for (size_t c = 0; c < table->form->count; c++)
        has_all = has_all && (table->places[c] != LX_NO_FIELD || !table->form->columns[c].is_required);
    if (!has_all) {
        forget(table);
        return false;
    }
    table->has_heading = true;
    table->width = count;
    *fault = found;
    return true;
}

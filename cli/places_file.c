/* SPDX-License-Identifier: MIT */
/*
 * Reading places to probe from a table or an array with the columns x, y for points of the screen, or x, y, z, nx, ny,
 * nz for free surface elements; a row may leave the last four empty, and is a point of the screen then.
 */
#include <math.h>
#include <string.h>

#include "cli.h"
#include "message.h"
#include "places.h"

enum { X, Y, Z, NX, NY, NZ, COLUMNS };

static const luxel_table_column columns[COLUMNS] = {
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = (const char *const[]){"x", NULL}},
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = (const char *const[]){"y", NULL}},
    {.type = LUXEL_TABLE_LENGTH, .is_required = false, .names = (const char *const[]){"z", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = false, .names = (const char *const[]){"nx", "normal_x", "n_x", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = false, .names = (const char *const[]){"ny", "normal_y", "n_y", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = false, .names = (const char *const[]){"nz", "normal_z", "n_z", NULL}},
};

static const char form[] = N_("each line has x, y, or x, y, z, nx, ny, nz, in mm");

/* "points.csv:3:1", a message of a row */
static void report_row(const luxel_table *table, const char *file, size_t column, const char *problem)
{
    unsigned line, place;

    luxel_table_place(table, column, &line, &place);
    message_error("%s:%u:%u: %s", file, line, place, problem);
}

/* The place of a row; false: it is none, which is said. */
static bool take_row(const luxel_table *table, const char *file, const double *numbers, struct places *places)
{
    size_t given = 0;

    for (size_t i = Z; i < COLUMNS; i++)
        given += isnan(numbers[i]) ? 0 : 1;
    if (given == 0) {
        memcpy(places_add(places)->screen_mm, numbers, 2 * sizeof *numbers);
        return true;
    }
    if (given < COLUMNS - Z)
        report_row(table, file, X, _("a place is x, y on the screen, or x, y, z and its normal nx, ny, nz"));
    else if (numbers[NX] == 0.0 && numbers[NY] == 0.0 && numbers[NZ] == 0.0)
        report_row(table, file, NX, _("the normal must not be zero"));
    else
        places_set_element(places_add(places), numbers);
    return given == COLUMNS - Z && (numbers[NX] != 0.0 || numbers[NY] != 0.0 || numbers[NZ] != 0.0);
}

int places_read(const char *file, luxel_diagnostics *diagnostics, bool quiet, struct places *places)
{
    luxel_table *table = NULL;
    const luxel_table_row *row;
    const size_t before = places->count;
    size_t wrong = 0;
    const luxel_status status = luxel_table_open(file, columns, COLUMNS, false, diagnostics, &table);

    if (status != LUXEL_OK)
        return message_table_failure(status, diagnostics, _(form));
    message_passed_over(diagnostics, quiet);
    while (luxel_table_next(table, &row) && wrong < LUXEL_DIAGNOSTICS_KEPT)
        if (row)
            wrong += !take_row(table, file, row->numbers, places);
    luxel_table_free(table);
    if (luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR) > 0)
        return message_table_failure(LUXEL_ERROR_FILE, diagnostics, _(form));
    if (wrong == 0 && places->count == before) {
        message_error(_("%s has no places"), file);
        message_hint("%s", _(form));
        return EXIT_FILE;
    }
    return wrong > 0 ? EXIT_FILE : EXIT_DONE;
}

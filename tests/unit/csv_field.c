/* SPDX-License-Identifier: MIT */
/* Writes the values, or a text, to a file as a user would, and reads it. */
#include "csv_field.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmocka.h>

luxel_field *field_of_csv(const char *text)
{
    char path[] = "/tmp/luxel-field-XXXXXX.csv";
    int descriptor = mkstemps(path, 4);
    assert_true(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
    luxel_field *field = NULL;
    assert_int_equal(luxel_field_read(path, NULL, &field), LUXEL_OK);
    unlink(path);
    return field;
}

luxel_field *csv_field(const double *values, unsigned rows, unsigned columns)
{
    enum { LINE = 60 };
    size_t size = LINE * ((size_t)rows * columns + 1), used;
    char *text = malloc(size);
    assert_non_null(text);
    used = (size_t)snprintf(text, size, "x_mm,y_mm,value_\n");
    for (unsigned row = 0; row < rows; row++)
        for (unsigned column = 0; column < columns; column++) {
            double value = values[(size_t)row * columns + column];
            if (!isnan(value))
                used += (size_t)snprintf(text + used, size - used, "%u,%u,%.17g\n", column, rows - 1 - row, value);
        }
    luxel_field *field = field_of_csv(text);
    free(text);
    assert_int_equal(luxel_field_rows(field), rows);
    assert_int_equal(luxel_field_columns(field), columns);
    return field;
}

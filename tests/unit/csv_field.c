/* SPDX-License-Identifier: MIT */
/* Writes the values to a file as a user would, and reads it. */
#include "csv_field.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmocka.h>

luxel_field *csv_field(const double *values, unsigned rows, unsigned columns)
{
    char path[] = "/tmp/luxel-field-XXXXXX.csv";
    int descriptor = mkstemps(path, 4);
    assert_true(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    assert_non_null(file);
    fputs("x_mm,y_mm,value_\n", file);
    for (unsigned row = 0; row < rows; row++)
        for (unsigned column = 0; column < columns; column++) {
            double value = values[(size_t)row * columns + column];
            if (!isnan(value))
                fprintf(file, "%u,%u,%.17g\n", column, rows - 1 - row, value);
        }
    assert_int_equal(fclose(file), 0);
    luxel_field *field = NULL;
    assert_int_equal(luxel_field_read(path, NULL, &field), LUXEL_OK);
    unlink(path);
    assert_int_equal(luxel_field_rows(field), rows);
    assert_int_equal(luxel_field_columns(field), columns);
    return field;
}

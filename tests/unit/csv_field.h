/* SPDX-License-Identifier: MIT */
/* Fields with values that a test chooses, at places 1 mm apart. */
#ifndef TESTS_UNIT_CSV_FIELD_H
#define TESTS_UNIT_CSV_FIELD_H

#include <stddef.h>

#include <luxel/luxel.h>

/*
 * A field of double precision, row by row from the top; pixel (0, 0) lies at (0, rows - 1) mm.  NaN: off every surface.
 * Free it with luxel_field_free().
 */
luxel_field *csv_field(const double *values, unsigned rows, unsigned columns);

/* The field of such a file's text; free it with luxel_field_free(). */
luxel_field *field_of_csv(const char *text);

#endif

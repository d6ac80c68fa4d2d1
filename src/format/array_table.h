/* SPDX-License-Identifier: MIT */
/*
 * Arrays in NPY files as tables: of real or whole numbers and two dimensions, with a row for each row and as many
 * columns as a table without a heading may have, in the order in which they are wanted.
 */
#ifndef LX_FORMAT_ARRAY_TABLE_H
#define LX_FORMAT_ARRAY_TABLE_H

#include "text_table.h"

struct lx_array_table;

/* Whether a file holds an array, by its first bytes. */
bool lx_is_array(struct lx_source *source);

/*
 * Reads all of the array.  The form must outlive it; lx_array_table_free() is due unless this failed.
 * LUXEL_ERROR_FILE: it is no such array, which is reported.  LUXEL_ERROR_MEMORY.
 */
luxel_status lx_array_table_new(struct lx_source *source, const struct lx_text_table_form *form,
                                struct lx_array_table **array);
void lx_array_table_free(struct lx_array_table *array);

/* Whether the array has a column that was wanted. */
bool lx_array_table_has(const struct lx_array_table *array, size_t column);

/* The number of the row that was read last, from 1. */
size_t lx_array_table_row(const struct lx_array_table *array);

/*
 * Goes to the next row and writes its numbers, NaN for columns that the array lacks.  False: there is none.
 * `*is_good` false: not all that must be are finite.
 */
bool lx_array_table_next(struct lx_array_table *array, double *numbers, bool *is_good);

#endif

/* SPDX-License-Identifier: MIT */
/* What derivatives and fits take: keys and places. */
#ifndef LUXEL_PYTHON_INVERSE_H
#define LUXEL_PYTHON_INVERSE_H

#include "strided.h"

/* Keys as the library takes them; the texts live as long as the list.  Free them with PyMem_Free().  NULL: an exception
 * is set. */
const char **keys_of(PyObject *list, size_t *count);

/* Places of an array of 2, 6 or 9 columns: a point of the screen; or place, normal and view of an element.  Free them
 * with free(); NULL: memory ran out. */
luxel_place *places_of(const struct strided *places, size_t surface);

#endif

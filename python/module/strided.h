/* SPDX-License-Identifier: MIT */
/* Arrays of float64 by the buffer protocol: of any strides, negative and 0 included, and any alignment. */
#ifndef LUXEL_PYTHON_STRIDED_H
#define LUXEL_PYTHON_STRIDED_H

#include "module.h"

#include <string.h>

struct strided {
    Py_buffer buffer;
    bool is_held;          /* the buffer is to be released */
    char *data;            /* of the first element */
    Py_ssize_t shape[2];   /* the second one is 1 of one dimension */
    Py_ssize_t strides[2]; /* in bytes */
};

/*
 * Takes the buffer of an array with this many dimensions, 1 or 2; `name` stands in messages.  False: an exception is
 * set.  Release it with strided_release(), which does nothing to what is zero.
 */
bool strided_take(PyObject *array, const char *name, int dimensions, bool is_written, struct strided *strided);
void strided_release(struct strided *strided);

/* One number; the array may lie anywhere. */
static inline double strided_get(const struct strided *strided, Py_ssize_t row, Py_ssize_t column)
{
    double number;

    memcpy(&number, strided->data + row * strided->strides[0] + column * strided->strides[1], sizeof number);
    return number;
}

static inline void strided_set(const struct strided *strided, Py_ssize_t row, Py_ssize_t column, double number)
{
    memcpy(strided->data + row * strided->strides[0] + column * strided->strides[1], &number, sizeof number);
}

#endif

/* SPDX-License-Identifier: MIT */
/* Arrays of float64 by the buffer protocol. */
#include "strided.h"

#include <string.h>

/* Whether a format of the struct module is a float64 of this machine. */
static bool is_double(const char *format)
{
    const char *const native = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? "@=<" : "@=>!";

    if (!format)
        return false;
    if (*format && strchr(native, *format))
        format++;
    return strcmp(format, "d") == 0;
}

bool strided_take(PyObject *array, const char *name, int dimensions, bool is_written, struct strided *strided)
{
    if (PyObject_GetBuffer(array, &strided->buffer, PyBUF_STRIDES | PyBUF_FORMAT | (is_written ? PyBUF_WRITABLE : 0)) <
        0)
        return false;
    strided->is_held = true;
    const Py_buffer *buffer = &strided->buffer;

    if (!is_double(buffer->format) || buffer->itemsize != (Py_ssize_t)sizeof(double) || buffer->ndim != dimensions) {
        PyErr_Format(PyExc_TypeError, "%s: an array of float64 with %d dimension(s) is expected", name, dimensions);
        strided_release(strided);
        return false;
    }
    strided->data = buffer->buf;
    strided->shape[0] = buffer->shape[0];
    strided->strides[0] = buffer->strides[0];
    strided->shape[1] = dimensions > 1 ? buffer->shape[1] : 1;
    strided->strides[1] = dimensions > 1 ? buffer->strides[1] : 0;
    return true;
}

void strided_release(struct strided *strided)
{
    if (strided->is_held)
        PyBuffer_Release(&strided->buffer);
    strided->is_held = false;
}

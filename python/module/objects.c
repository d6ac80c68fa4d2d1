/* SPDX-License-Identifier: MIT */
/* Small objects of Python from numbers and texts of the library. */
#include "module.h"

#include <string.h>

PyObject *none(void)
{
    return Py_NewRef(Py_None);
}

PyObject *text_or_none(const char *text)
{
    return text ? PyUnicode_DecodeUTF8(text, (Py_ssize_t)strlen(text), "replace") : none();
}

PyObject *file_of(bool good, unsigned char *bytes, size_t length)
{
    PyObject *made = good ? PyBytes_FromStringAndSize((const char *)bytes, (Py_ssize_t)length) : NULL;

    luxel_bytes_free(bytes);
    return made;
}

PyObject *number_or_none(bool given, double number)
{
    return given ? PyFloat_FromDouble(number) : none();
}

PyObject *triple_or_none(bool given, const double vector[3])
{
    return given ? Py_BuildValue("(ddd)", vector[0], vector[1], vector[2]) : none();
}

bool is_tuple(PyObject *object)
{
    if (PyTuple_Check(object))
        return true;
    PyErr_SetString(PyExc_TypeError, "a tuple is expected");
    return false;
}

int append(PyObject *list, PyObject *item)
{
    const int code = item ? PyList_Append(list, item) : -1;

    Py_XDECREF(item);
    return code;
}

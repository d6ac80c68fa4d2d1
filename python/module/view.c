/* SPDX-License-Identifier: MIT */
/*
 * Handles of results, and views: numbers of the library that Python reads where they lie.  A view keeps their owner
 * alive and cannot be written, as the results of the library never change.
 */
#include "module.h"

/* ---- holders ---- */

static void holder_dealloc(PyObject *self)
{
    struct holder_object *holder = (struct holder_object *)self;
    PyTypeObject *type = Py_TYPE(self);

    if (holder->release)
        holder->release(holder->thing);
    PyObject_Free(self);
    Py_DECREF(type);
}

static PyType_Slot holder_slots[] = {
    {Py_tp_dealloc, holder_dealloc},
    {Py_tp_doc, "A result of the library, freed with this."},
    {0, NULL},
};

PyType_Spec holder_spec = {.name = "luxel._luxel.Holder",
                           .basicsize = sizeof(struct holder_object),
                           .flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_DISALLOW_INSTANTIATION,
                           .slots = holder_slots};

PyObject *holder_new(PyObject *module, void *thing, void (*release)(void *thing))
{
    struct holder_object *holder = PyObject_New(struct holder_object, module_state(module)->holder_type);

    if (!holder) {
        release(thing);
        return NULL;
    }
    holder->thing = thing;
    holder->release = release;
    return (PyObject *)holder;
}

/* ---- views ---- */

struct view_object {
    PyObject_HEAD PyObject *owner;
    struct view_layout layout;
    Py_ssize_t item, shape[2], strides[2];
    char format[2];
};

static int view_get(PyObject *self, Py_buffer *buffer, int flags)
{
    struct view_object *view = (struct view_object *)self;
    const bool has_columns = view->layout.columns > 0;
    const Py_ssize_t packed = view->item * (has_columns ? view->layout.columns : 1);

    if (flags & PyBUF_WRITABLE) {
        PyErr_SetString(PyExc_BufferError, "results of Luxel cannot be written");
        return -1;
    }
    if (view->strides[0] != packed && (flags & PyBUF_STRIDES) != PyBUF_STRIDES) {
        PyErr_SetString(PyExc_BufferError, "the numbers do not follow one another: strides are needed");
        return -1;
    }
    *buffer = (Py_buffer){.buf = (void *)view->layout.data,
                          .obj = Py_NewRef(self),
                          .len = view->shape[0] * packed,
                          .itemsize = view->item,
                          .readonly = 1,
                          .ndim = has_columns ? 2 : 1,
                          .format = flags & PyBUF_FORMAT ? view->format : NULL,
                          .shape = flags & PyBUF_ND ? view->shape : NULL,
                          .strides = (flags & PyBUF_STRIDES) == PyBUF_STRIDES ? view->strides : NULL};
    return 0;
}

static void view_dealloc(PyObject *self)
{
    PyTypeObject *type = Py_TYPE(self);

    Py_XDECREF(((struct view_object *)self)->owner);
    PyObject_Free(self);
    Py_DECREF(type);
}

static PyType_Slot view_slots[] = {
    {Py_tp_dealloc, view_dealloc},
    {Py_bf_getbuffer, view_get},
    {Py_tp_doc, "Numbers of a result as a buffer."},
    {0, NULL},
};

PyType_Spec view_spec = {.name = "luxel._luxel.View",
                         .basicsize = sizeof(struct view_object),
                         .flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_DISALLOW_INSTANTIATION,
                         .slots = view_slots};

PyObject *view_new(PyObject *module, PyObject *owner, const struct view_layout *layout)
{
    struct view_object *view = PyObject_New(struct view_object, module_state(module)->view_type);

    if (!view)
        return NULL;
    view->owner = Py_NewRef(owner);
    view->layout = *layout;
    view->format[0] = layout->format[0];
    view->format[1] = '\0';
    view->item = *layout->format == 'd'   ? (Py_ssize_t)sizeof(double)
                 : *layout->format == 'f' ? (Py_ssize_t)sizeof(float)
                                          : 1;
    view->shape[0] = layout->rows;
    view->shape[1] = layout->columns;
    view->strides[1] = view->item;
    view->strides[0] = layout->stride ? layout->stride : view->item * (layout->columns > 0 ? layout->columns : 1);
    return (PyObject *)view;
}

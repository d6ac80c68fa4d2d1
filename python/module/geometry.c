/* SPDX-License-Identifier: MIT */
/* What the pixels of a scene show, written to arrays of Python without the interpreter's lock. */
#include "failure.h"
#include "work.h"

enum { ARRAYS = 5 };

/* Takes an array that holds all pixels in one piece.  False: an exception is set. */
static bool take(PyObject *array, const char *name, size_t bytes, Py_buffer *buffer)
{
    if (PyObject_GetBuffer(array, buffer, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE) < 0)
        return false;
    if ((size_t)buffer->len == bytes)
        return true;
    PyErr_Format(PyExc_ValueError, "%s: %zu bytes are expected, not %zd", name, bytes, buffer->len);
    PyBuffer_Release(buffer);
    return false;
}

static PyObject *geometry(PyObject *module, PyObject *arguments)
{
    static const char *const names[ARRAYS] = {"depth_mm", "normals", "positions_mm", "surfaces", "parts"};
    static const size_t sizes[ARRAYS] = {sizeof(double), sizeof(double[3]), sizeof(double[3]), sizeof(int32_t),
                                         sizeof(unsigned)};
    PyObject *handle, *settings, *given[ARRAYS];
    Py_buffer buffers[ARRAYS];
    unsigned columns, rows;
    size_t taken = 0;
    struct work work;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOOOOOO", &handle, &given[0], &given[1], &given[2], &given[3], &given[4],
                          &settings) ||
        !(scene = scene_of(module, handle)) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    luxel_scene_resolution(scene, &columns, &rows);
    while (taken < ARRAYS && take(given[taken], names[taken], sizes[taken] * columns * rows, &buffers[taken]))
        taken++;
    luxel_status status = LUXEL_OK;

    if (taken == ARRAYS) {
        const luxel_geometry wanted = {.depth_mm = buffers[0].buf,
                                       .normals = buffers[1].buf,
                                       .positions_mm = buffers[2].buf,
                                       .surfaces = buffers[3].buf,
                                       .parts = buffers[4].buf};

        work_leave(&work);
        status = luxel_find_geometry(scene, &work.settings, diagnostics, &wanted);
        work_return(&work);
    }
    while (taken > 0)
        PyBuffer_Release(&buffers[--taken]);
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? none() : NULL;
}

const PyMethodDef geometry_functions[] = {
    FUNCTION("geometry", geometry, METH_VARARGS,
             "scene: SceneHandle, depth_mm: Any, normals: Any, positions_mm: Any, surfaces: Any, parts: Any, "
             "settings: _Settings, /",
             "None"),
    {NULL, NULL, 0, NULL},
};
